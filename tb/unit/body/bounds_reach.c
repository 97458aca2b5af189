/* SPDX-License-Identifier: MIT */
/* bounds_reach.c - bounds in single precision of the distance of boxes (distance/reach.h):
 * BOUND_SLACK and 16 d of distance/bounds.c, MORE of body/fit.c, and `thick`. */
#define sepax__body_fit body_fit_of_test
#define enclose enclose_points
#define next next_of_fit
#define below below_of_fit
#define turn turn_of_fit
#include "body/fit.c" /* NOLINT(bugprone-suspicious-include): its functions are static */
#undef enclose
#undef next
#undef below
#undef turn
#include "bounds_compiled.h"

#include "wide.h"

/* Two bodies of one box each in poses; the search turns B's box into A's coordinates. */
typedef struct {
  sepax_body body[2];
  body_frame frame[2];
  body_boxes boxes[2];
  float foot;
  sepax_pose pose[2];
  search s;
} two_boxes;

static void store_box(two_boxes *t, int body, const oriented *r, uint32_t child) {
  const oriented none = {{{0}}, {FAR, FAR, FAR}, {0}};
  for (int lane = 0; lane < BODY_WIDE; lane++) {
    store(&t->boxes[body], lane, lane == 0 ? r : &none, lane == 0 ? child : BODY_NONE);
  }
  t->body[body].boxes = &t->boxes[body];
  t->body[body].frame = &t->frame[body];
}

static void store_frame(two_boxes *t, int body) {
  oriented r;
  round_box(&t->frame[body], &r);
  store_box(t, body, &r, 0);
}

/* The least distance that the boxes prove in single precision, with and without AVX2; the greater
 * of both. */
static wide least_of(two_boxes *t) {
  float square[BODY_WIDE];
  wide most = 0;
  for (int portable = 0; portable < 2; portable++) {
    t->s = (search){.body = {&t->body[0], &t->body[1]}, .portable = portable > 0};
    sepax__search_begin(&t->s, &t->pose[0], &t->pose[1]);
    sepax__bound_children(&t->s, 0, 0, 0, square);
    wide least = (wide)(double)square[0] * t->s.square_of_unit[0];
    most = wide_most(most, wide_root(least) * t->s.scale);
  }
  return most;
}

static void exact_box(const two_boxes *t, int body, wide_box *box) {
  const sepax_body *b = &t->body[body];
  const double(*r)[3] = (const double(*)[3])t->pose[body].rotation;
  wide_point centre;
  for (int i = 0; i < 3; i++) {
    wide_point axis;
    wide_of(b->frame->axis[i], axis);
    wide_move(r, axis, NULL, box->axis[i]);
    box->half[i] = (wide)b->frame->half[i] * b->scale;
    centre[i] = b->centre[i] + (wide)b->scale * b->frame->centre[i];
  }
  wide_move(r, centre, t->pose[body].translation, box->centre);
}

/* |x| + |y| + |z| of a vector in the coordinates of A. */
static wide size_in_a(const two_boxes *t, const wide v[3]) {
  wide column[3][3];
  wide_point u;
  for (int k = 0; k < 9; k++) {
    column[k % 3][k / 3] = t->pose[0].rotation[k / 3][k % 3];
  }
  wide_solve((const wide(*)[3])column, v, u);
  return wide_size(u[0]) + wide_size(u[1]) + wide_size(u[2]);
}

/* ------------------------------------------------------------------------- slack */

enum { POSE = 16, NODE = 11, SLACK_INPUTS = 2 * (POSE + NODE) };

/* Move B so that its box is on an axis of A's coordinates, as seen from A's box, or nearly: there
 * |x| + |y| + |z| is not more than the length. */
static void move_b(two_boxes *t, const double *x) {
  wide_box box[2] = {{{0}, {{0}}, {0}}};
  exact_box(t, 0, &box[0]);
  exact_box(t, 1, &box[1]);
  for (int i = 0; i < 3; i++) {
    wide to = box[0].centre[i];
    for (int k = 0; k < 3; k++) {
      to += (k == 0 ? x[0] : 0x1p-10 * x[k] * x[k]) * t->pose[0].rotation[i][k];
    }
    t->pose[1].translation[i] += (double)(to - box[1].centre[i]);
  }
}

/* Two points far from each other: what part of BOUND_SLACK is taken, or, in poses that are not
 * quite rotations, of 16 d? */
static double slack_part(const double *x, double skew) {
  two_boxes t = {.foot = INFINITY};
  wide_box box[2] = {{{0}, {{0}}, {0}}};
  for (int body = 0; body < 2; body++) {
    const double *own = x + body * (POSE + NODE);
    skewed_rotation(own, own + 4, skew, t.pose[body].rotation);
    memcpy(t.pose[body].translation, own + 13, sizeof t.pose[body].translation);
    t.body[body] = (sepax_body){.scale = ldexp(1, -(int)(8 * fabs(own[POSE])))};
    skewed_rotation(own + POSE + 1, own, 0, t.frame[body].axis);
    for (int i = 0; i < 3; i++) {
      t.body[body].centre[i] = own[POSE + 5 + i];
      t.frame[body].centre[i] = own[POSE + 8 + i];
      t.frame[body].half[i] = 0x1p-46;
    }
    store_frame(&t, body);
    if (!sepax_pose_valid(&t.pose[body], NULL)) {
      return -1;
    }
  }
  move_b(&t, x + POSE + NODE + 13);
  exact_box(&t, 0, &box[0]);
  exact_box(&t, 1, &box[1]);
  wide_point way;
  wide_minus(box[1].centre, box[0].centre, way);
  wide least = least_of(&t);
  double slack = (double)t.s.slack;
  wide error = (least - wide_length(way)) / size_in_a(&t, way) + slack;
  return (double)error / (skew > 0 ? slack - BOUND_SLACK : slack);
}

static double slack_error(const double *x) { return slack_part(x, 0); }
static double skew_error(const double *x) { return slack_part(x, 1e-6); }

CASE(gaps_of_points) {
  assert_part("BOUND_SLACK", most_of_bound(slack_error, SLACK_INPUTS, 4, 6000), 0.06);
  assert_part("16 d", most_of_bound(skew_error, SLACK_INPUTS, 4, 6000), 0.25);
}

/* -------------------------------------------------------------------------- MORE */

/* Two plates, nearly parallel, of two poses that are not quite the same: what of MORE is taken? */
static double more_error(const double *x) {
  two_boxes t = {.foot = INFINITY};
  wide_box box[2] = {{{0}, {{0}}, {0}}};
  for (int body = 0; body < 2; body++) {
    skewed_rotation(x, x + 4 + 9 * body, x[22] > 0 ? 1e-6 : 0, t.pose[body].rotation);
    t.body[body] = (sepax_body){.scale = 1};
    skewed_rotation(x + 23, x, 0, t.frame[body].axis);
    for (int i = 0; i < 3; i++) {
      t.frame[body].half[i] = i == 0 ? 0x1p-46 : fabs(x[27 + 2 * body + i]);
      t.frame[body].axis[0][i] += body * 1e-5 * x[34] * t.frame[0].axis[1][i];
      t.frame[body].axis[1][i] -= body * 1e-5 * x[34] * t.frame[0].axis[0][i];
      t.pose[body].translation[i] = 0.1 * x[35 + i];
    }
  }
  wide sum = 0;
  for (int k = 0; k < 6; k++) {
    sum += t.frame[k / 3].half[k % 3];
  }
  for (int i = 0; i < 3; i++) {
    const double way = x[38] * t.frame[0].axis[0][i];
    t.frame[1].centre[i] = 0x1p-13 * way + 0x1p-16 * x[39 + i];
  }
  for (int body = 0; body < 2; body++) {
    store_frame(&t, body);
    exact_box(&t, body, &box[body]);
    if (!sepax_pose_valid(&t.pose[body], NULL)) {
      return -1;
    }
  }
  memcpy(t.pose[1].translation, t.pose[0].translation, sizeof t.pose[1].translation);
  exact_box(&t, 1, &box[1]);
  wide least = least_of(&t);
  wide more = 0x1p-15 * sum;
  return !(least > 0) ? -1 : (double)((least - wide_boxes_reach(&box[0], &box[1])) / more) + 1;
}

CASE(boxes_that_nearly_touch) { assert_part("MORE", most_of_bound(more_error, 42, 8, 6000), 0.05); }

/* ------------------------------------------------------------------------- thick */

static const sepax_pose unmoved = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};

/* A triangle that is small for its distance from the centre: how far does it reach out of the range
 * that it covers on an axis, if `thick` is not there? */
static double thick_error(const double *x) {
  two_boxes t = {.pose = {unmoved, unmoved}};
  oriented r;
  facet_points v;
  posed_box p;
  double axis[3][3];
  wide high = -INFINITY;
  wide low = INFINITY;
  double size = ldexp(1, -9 - (int)(6 * fabs(x[0])));
  for (int k = 0; k < 9; k++) {
    v[k / 3][k % 3] = x[1 + k % 3] * (1 - size) + size * x[4 + k];
  }
  t.foot = fit_triangle(&v, &r);
  store_box(&t, 0, &r, BODY_TRIANGLE);
  store_box(&t, 1, &r, BODY_TRIANGLE);
  t.body[0] = t.body[1] = (sepax_body){.scale = 1};
  sepax__place_bodies(&t.s.at, &t.body[0], NULL, &t.body[1], NULL);
  turn_box(&p, &t.s.at.to[0], &t.boxes[1], 0);
  skewed_rotation(x + 13, x, 0, axis);
  floats_portable cosine[3];
  for (int k = 0; k < 3; k++) {
    double dot = 0;
    for (int i = 0; i < 3; i++) {
      dot += axis[0][i] * (double)p.axis[k][i];
    }
    cosine[k] = (floats_portable){0} + (float)dot;
  }
  for (int k = 0; k < 3; k++) {
    wide at = 0;
    for (int i = 0; i < 3; i++) {
      at += axis[0][i] * ((wide)v[k][i] - (double)p.centre[i] - (double)p.rest[i]);
    }
    high = wide_most(high, at);
    low = wide_least(low, at);
  }
  range_portable range =
      covered_portable(cosine, &p, true, t.s.at.to[0].ratio * t.foot, t.s.at.to[0].lost);
  wide out = wide_most(high - (double)range.high[0], (double)range.low[0] - low);
  wide thick = 0x1p-9 * ((double)p.half[0] + (double)p.half[1] + (double)p.half[2]);
  return isinf(t.foot) ? -1 : (double)(out / thick) + 1;
}

CASE(a_triangle_in_its_box) {
  assert_part("thick", most_of_bound(thick_error, 17, 24, 4000), 0.26);
}
