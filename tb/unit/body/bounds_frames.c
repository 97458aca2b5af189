/* SPDX-License-Identifier: MIT */
/* bounds_frames.c - FRAME_ERROR and `skew` of distance/frames.h: bounds in doubles of the distance
 * of two nodes, or of a node and a triangle. */
#include "bounds_compiled.h"

#include "wide.h"

/* Two bodies of one node each in poses. */
typedef struct {
  sepax_body body[2];
  body_frame frame[2];
  facet_points triangle;
  sepax_pose pose[2];
  search s;
  double bound; /* of the distance of the nodes, which search_begin returns */
} two_nodes;

enum { POSE_INPUTS = 16, NODE_INPUTS = 14, ALL_INPUTS = 2 * (POSE_INPUTS + NODE_INPUTS) };

/* A body within the unit cube and a frame within centre +- scale. Half sides are of any size. */
static void node_of(const double *x, sepax_body *b, body_frame *f) {
  *b = (sepax_body){.frame = f, .scale = ldexp(1, -1 - (int)(20 * fabs(x[0])))};
  skewed_rotation(x + 1, x + 1, 0, f->axis);
  for (int i = 0; i < 3; i++) {
    b->centre[i] = x[5 + i] * (1 - b->scale);
    f->centre[i] = 0.9 * x[8 + i];
    f->half[i] = 0.1 * pow(x[11 + i], 8);
  }
}

static void exact_box(const two_nodes *n, int body, wide_box *box) {
  const sepax_body *b = &n->body[body];
  const double(*r)[3] = (const double(*)[3])n->pose[body].rotation;
  wide_point centre;
  for (int i = 0; i < 3; i++) {
    wide_point axis;
    wide_of(b->frame->axis[i], axis);
    wide_move(r, axis, NULL, box->axis[i]);
    box->half[i] = (wide)b->frame->half[i] * b->scale;
    centre[i] = b->centre[i] + (wide)b->scale * b->frame->centre[i];
  }
  wide_move(r, centre, n->pose[body].translation, box->centre);
}

/* Place B's centre at a point of A's coordinates. */
static void move_b(two_nodes *n, const wide at[3]) {
  wide_box box = {{0}, {{0}}, {0}};
  exact_box(n, 1, &box);
  for (int i = 0; i < 3; i++) {
    n->pose[1].translation[i] += (double)(at[i] - box.centre[i]);
  }
}

/* False if a pose is not valid, or the unit of the search is not 1. */
static bool begin_nodes(two_nodes *n) {
  if (!sepax_pose_valid(&n->pose[0], NULL) || !sepax_pose_valid(&n->pose[1], NULL)) {
    return false;
  }
  n->s = (search){.body = {&n->body[0], &n->body[1]}};
  n->bound = sepax__search_begin(&n->s, &n->pose[0], &n->pose[1]);
  return n->s.unit > 0.9 && n->s.unit < 1.1;
}

static void nodes_of(const double *x, double skew, two_nodes *n) {
  for (int body = 0; body < 2; body++) {
    const double *own = x + body * (POSE_INPUTS + NODE_INPUTS);
    skewed_rotation(own, own + 4, skew, n->pose[body].rotation);
    memcpy(n->pose[body].translation, own + 13, sizeof n->pose[body].translation);
    node_of(own + POSE_INPUTS, &n->body[body], &n->frame[body]);
  }
}

/* The nodes are near to each other, and their poses are rotations but for rounding. B's translation
 * says in which direction it is, and how far. */
static bool near_nodes(const double *x, two_nodes *n) {
  nodes_of(x, 0, n);
  wide_box a = {{0}, {{0}}, {0}};
  wide_box b = a;
  exact_box(n, 0, &a);
  exact_box(n, 1, &b);
  const double *way = x + ALL_INPUTS - NODE_INPUTS - 3;
  wide sum = 0;
  for (int i = 0; i < 3; i++) {
    sum += a.half[i] + b.half[i];
  }
  for (int i = 0; i < 3; i++) {
    a.centre[i] += (2 * sum + 0x1p-20) * way[i];
  }
  move_b(n, a.centre);
  return begin_nodes(n);
}

static double frames_error(const double *x) {
  two_nodes n = {.bound = 0};
  wide_box box[2] = {{{0}, {{0}}, {0}}};
  if (!near_nodes(x, &n) || !(n.bound > 0)) {
    return -1;
  }
  exact_box(&n, 0, &box[0]);
  exact_box(&n, 1, &box[1]);
  return (double)((n.bound + (wide)FRAME_ERROR - wide_boxes_reach(&box[0], &box[1])) / FRAME_ERROR);
}

/* B is a triangle at the centre of its frame. */
static double frame_error(const double *x) {
  two_nodes n = {.bound = 0};
  wide_box box = {{0}, {{0}}, {0}};
  if (!near_nodes(x, &n)) {
    return -1;
  }
  for (int k = 0; k < 9; k++) {
    int i = k % 3;
    double side = n.body[1].scale * n.frame[1].half[i];
    n.triangle[k / 3][i] = n.body[1].centre[i] + n.body[1].scale * n.frame[1].centre[i] +
                           side * n.frame[1].axis[k / 3][i];
  }
  n.body[1].triangle = &n.triangle;
  double proved = sepax__exact_bound(&n.s, (const uint32_t[2]){0, BODY_TRIANGLE});
  exact_box(&n, 0, &box);
  wide least = INFINITY;
  for (int k = 0; k < 3; k++) {
    wide_point own;
    wide_point at;
    wide_of(n.triangle[k], own);
    wide_move((const double(*)[3])n.pose[1].rotation, own, n.pose[1].translation, at);
    least = wide_least(least, wide_box_reach(&box, at));
  }
  return !(proved > 0) ? -1 : (double)((proved + (wide)FRAME_ERROR - least) / FRAME_ERROR);
}

CASE(boxes_in_doubles) {
  assert_part("FRAME_ERROR of nodes", most_of_bound(frames_error, ALL_INPUTS, 4, 12000), 0.01);
  assert_part("FRAME_ERROR of a triangle", most_of_bound(frame_error, ALL_INPUTS, 8, 12000),
              0.0157);
}

/* ------------------------------------------------------------------------- skew */

/* B is a point above the face of A's box: what does 3 skew of the half sides take off? */
static double reach_error(const double *x) {
  two_nodes n = {.bound = 0};
  nodes_of(x, 1e-6, &n);
  n.body[0].scale = 0.5;
  double sum = 0;
  for (int i = 0; i < 3; i++) {
    n.frame[0].half[i] = fabs(x[POSE_INPUTS + 11 + i]) + 1e-9;
    n.frame[1].half[i] = 0;
    sum += n.body[0].scale * n.frame[0].half[i];
  }
  wide_box box[2] = {{{0}, {{0}}, {0}}};
  exact_box(&n, 0, &box[0]);
  wide_point at;
  memcpy(at, box[0].centre, sizeof at);
  for (int k = 0; k < 3; k++) {
    wide t = k > 0 ? (wide)x[ALL_INPUTS - k] : 1 + 0x1p-15 / (wide)n.frame[0].half[0];
    for (int i = 0; i < 3; i++) {
      at[i] += t * box[0].half[k] * box[0].axis[k][i];
    }
  }
  move_b(&n, at);
  if (!begin_nodes(&n) || !(n.bound > 0)) {
    return -1;
  }
  exact_box(&n, 0, &box[0]);
  exact_box(&n, 1, &box[1]);
  wide cover = 3 * (wide)n.s.skew * sum;
  return (double)((n.bound + cover - wide_box_reach(&box[0], box[1].centre)) / cover);
}

/* Both are points that are far from each other: what does 1 - 2 skew take off? */
static double length_error(const double *x) {
  two_nodes n = {.bound = 0};
  nodes_of(x, 1e-6, &n);
  for (int k = 0; k < 6; k++) {
    n.frame[k / 3].half[k % 3] = 0;
  }
  if (!begin_nodes(&n)) {
    return -1;
  }
  wide_box box[2] = {{{0}, {{0}}, {0}}};
  exact_box(&n, 0, &box[0]);
  exact_box(&n, 1, &box[1]);
  wide distance = wide_gap(box[0].centre, box[1].centre);
  return (double)((n.bound / distance - (1 - 2 * (wide)n.s.skew)) / (2 * (wide)n.s.skew));
}

CASE(poses_that_are_not_quite_rotations) {
  assert_part("3 skew of half sides", most_of_bound(reach_error, ALL_INPUTS, 2, 4000), 0.5);
  assert_part("1 - 2 skew", most_of_bound(length_error, ALL_INPUTS, 2, 4000), 0.6);
}
