/* SPDX-License-Identifier: MIT */
/* bounds_proof.c - PROOF_ERROR and DOUBLE_ERROR of distance/support.c: a proof by one direction
 * that two bodies are apart. */
#define sepax__proof_begin proof_begin_of_test
#define sepax__prove_apart prove_apart_of_test
#include "distance/support.c" /* NOLINT(bugprone-suspicious-include): its functions are static */

#include "wide.h"

/* Two bodies in poses, in the unit of the search. Each has two triangles in its root; all vertices
 * of a triangle are the same point. */
typedef struct {
  sepax_body body[2];
  body_boxes boxes[2];
  body_frame frame[2];
  facet_points triangle[2][2];
  twofold_vector way;
  search s;
} two_bodies;

static wide wide_value(twofold x) { return (wide)x.high + x.low; }

/* Inputs: poses of 16 each, two points of each body, the way. */
enum { POSE = 16, POINTS = 2 * POSE, WAY = POINTS + 12, PROOF_INPUTS = WAY + 6 };

/* The last input of a pose says whether there is one. */
static bool place(search *s, int body, const double *x) {
  world_pose *p = &s->pose[body];
  sepax_pose pose;
  skewed_rotation(x, x + 4, 1e-6, pose.rotation);
  memcpy(pose.translation, x + 13, sizeof pose.translation);
  memcpy(p->rotation, pose.rotation, sizeof p->rotation);
  memcpy(p->translation, pose.translation, sizeof p->translation);
  p->unit = 1;
  return sepax_pose_valid(&pose, NULL);
}

static bool bodies_of(const double *x, two_bodies *t) {
  bool valid = true;
  memset(t, 0, sizeof *t);
  t->s.unit = 1;
  for (int body = 0; body < 2; body++) {
    sepax_body *b = &t->body[body];
    *b = (sepax_body){.count = 2,
                      .scale = 1,
                      .nodes = 1,
                      .triangle = t->triangle[body],
                      .boxes = &t->boxes[body],
                      .frame = &t->frame[body]};
    for (int lane = 0; lane < BODY_WIDE; lane++) {
      t->boxes[body].child[lane] = lane < 2 ? BODY_TRIANGLE + (uint32_t)lane : BODY_NONE;
    }
    for (int k = 0; k < 18; k++) { /* the second point is near the first one */
      double first = x[POINTS + 6 * body + k % 3];
      double second = first + 0x1p-45 * x[POINTS + 6 * body + 3 + k % 3];
      t->triangle[body][k / 9][k / 3 % 3][k % 3] = k < 9 ? first : fmax(-1, fmin(1, second));
    }
    t->s.body[body] = b;
    t->s.size[body] = 1;
    valid = place(&t->s, body, x + POSE * body) && valid;
  }
  for (int i = 0; i < 3; i++) {
    t->way.c[i] = sum_of(x[WAY + i], 0x1p-54 * x[WAY + 3 + i] * x[WAY + i]);
  }
  return scale_way(&t->way) && valid;
}

/* The point of a body on the way. */
static wide on_way(const two_bodies *t, int body, const wide v[3]) {
  const world_pose *p = &t->s.pose[body];
  wide_point w;
  wide_point at;
  for (int i = 0; i < 3; i++) {
    w[i] = wide_value(t->way.c[i]);
  }
  wide_move((const double(*)[3])p->rotation, v, p->translation, at);
  return wide_dot(w, at);
}

static wide triangle_on_way(const two_bodies *t, int body, int place) {
  wide_point v;
  wide_of(t->triangle[body][place][0], v);
  return on_way(t, body, v);
}

static wide way_length(const two_bodies *t) {
  wide square = 0;
  for (int i = 0; i < 3; i++) {
    square += wide_value(t->way.c[i]) * wide_value(t->way.c[i]);
  }
  return wide_root(square);
}

static twofold twofold_near(wide x) {
  double high = (double)x;
  return sum_of_ordered(high, (double)(x - high));
}

/* A proof of a little less than what the nearest triangles leave; what do all triangles leave by
 * the proof, and what in truth? */
static double proof_error(const double *x) {
  static const uint32_t nearest[2] = {0, 0};
  two_bodies t;
  if (!bodies_of(x, &t)) {
    return -1;
  }
  wide length = way_length(&t);
  wide gap = triangle_on_way(&t, 0, 0) - triangle_on_way(&t, 1, 0);
  twofold need = twofold_near(wide_size(gap) / length - 0x1p-80);
  if (!(need.high > 0x1p-10) || !sepax__proof_begin(&t.s, &t.way, nearest, need)) {
    return -1;
  }
  wide end[2];
  twofold left = t.s.proof.spare;
  for (int k = 0; k < 2; k++) {
    side r = side_of(&t.s, k);
    end[k] = triangle_on_way(&t, k, 0);
    r.spare = left;
    r.taken = twofold_scaled(left, -1);
    for (int n = 0; n < 2; n++) {
      wide at = triangle_on_way(&t, k, n);
      end[k] = r.high ? wide_most(end[k], at) : wide_least(end[k], at);
      take_triangle(&r, (const double(*)[3])t.triangle[k][n]);
    }
    left = twofold_subtract(left, r.taken);
  }
  wide least = end[!t.s.proof.high] - end[t.s.proof.high];
  wide truth = least - wide_value(need) * length;
  wide error = PROOF_ERROR * length;
  return (double)((wide_value(left) + error - truth) / error);
}

CASE(a_proof_by_one_direction) {
  assert_part("PROOF_ERROR", most_of_bound(proof_error, PROOF_INPUTS, 3, 240000), 0.0157);
}

/* An AABB is within what is taken if its farthest corner is, but for PROOF_ERROR. */
CASE(an_aabb_on_the_way) {
  for (int n = 0; n < FEWER(5000); n++) {
    two_bodies t;
    double x[PROOF_INPUTS];
    for (int k = 0; k < PROOF_INPUTS; k++) {
      x[k] = random_unit();
    }
    if (!bodies_of(x, &t)) {
      continue;
    }
    turn_way(&t.s, 0, &t.way);
    t.s.proof.high = n % 2;
    t.s.proof.end[0] = twofold_of(x[POSE]);
    side r = side_of(&t.s, 0);
    wide out = -INFINITY;
    for (int k = 0; k < 6; k++) {
      double y = x[POSE + 1 + k];
      t.frame[0].aabb[k / 3][k % 3] = k < 3 ? y : fmax(y, t.frame[0].aabb[0][k % 3]);
    }
    for (int corner = 0; corner < 8; corner++) {
      wide_point v;
      for (int i = 0; i < 3; i++) {
        v[i] = t.frame[0].aabb[corner >> i & 1][i];
      }
      wide beyond = on_way(&t, 0, v) - x[POSE];
      out = wide_most(out, r.high ? beyond : -beyond);
    }
    wide error = PROOF_ERROR * way_length(&t);
    r.taken = twofold_near(out - error);
    assert_false(aabb_is_within(&r, 0));
    r.taken = twofold_near(out + error);
    assert_true(aabb_is_within(&r, 0));
  }
}

/* ---------------------------------------------------------------- proofs in doubles */

/* How far out is the body at least to be, if its nearest triangle is at `end`? `within` says
 * whether it clearly takes no more than is taken. */
static double threshold(side *r, bool (*within)(side *r)) {
  double low = -1;
  double high = 1;
  for (int n = 0; n < 64; n++) {
    r->taken = twofold_of(low + (high - low) / 2);
    if (within(r)) {
      high = r->taken.high;
    } else {
      low = r->taken.high;
    }
  }
  return high;
}

static bool node_within(side *r) { return node_is_within(r, 0); }

/* A triangle that is looked at takes more than is to spare. */
static bool triangle_within(side *r) {
  side copy = *r;
  copy.spare = twofold_of(-9);
  return take_triangle(&copy, r->s->body[r->body]->triangle[0]);
}

/* What of DOUBLE_ERROR is taken, if the body of `box` ends at `out`, counted along the way? */
static double part_of_double(two_bodies *t, wide out, double off, bool (*within)(side *r)) {
  turn_way(&t->s, 0, &t->way);
  t->s.proof.high = off < 0;
  t->s.proof.end[0] = twofold_near(out + 0x1p-20 * (wide)off);
  side r = side_of(&t->s, 0);
  wide beyond = out - wide_value(t->s.proof.end[0]);
  beyond = r.high ? beyond : -beyond;
  return (double)((beyond - ((wide)threshold(&r, within) - DOUBLE_ERROR)) / DOUBLE_ERROR);
}

/* The node's box takes the inputs of the second body. */
static double node_error(const double *x) {
  two_bodies t;
  const double *own = x + POSE;
  wide_box box = {{0}, {{0}}, {0}};
  if (!bodies_of(x, &t)) {
    return -1;
  }
  body_frame *f = &t.frame[0];
  t.body[0].scale = t.s.size[0] = ldexp(1, -1 - (int)(10 * fabs(own[4])));
  skewed_rotation(own, own, 0, f->axis);
  wide_point axis;
  for (int i = 0; i < 3; i++) {
    t.body[0].centre[i] = own[5 + i] * (1 - t.body[0].scale);
    f->centre[i] = own[8 + i] * 0.9;
    f->half[i] = fabs(own[11 + i]);
    box.centre[i] = t.body[0].centre[i] + (wide)t.body[0].scale * f->centre[i];
  }
  double off = x[WAY + 5];
  wide out = on_way(&t, 0, box.centre);
  for (int i = 0; i < 3; i++) {
    wide_of(f->axis[i], axis);
    for (int k = 0; k < 3; k++) {
      axis[k] += box.centre[k];
    }
    wide reach = (on_way(&t, 0, axis) - on_way(&t, 0, box.centre)) * f->half[i] * t.s.size[0];
    out += off < 0 ? -wide_size(reach) : wide_size(reach);
  }
  return part_of_double(&t, out, off, node_within);
}

static double vertex_error(const double *x) {
  two_bodies t;
  if (!bodies_of(x, &t)) {
    return -1;
  }
  return part_of_double(&t, triangle_on_way(&t, 0, 0), x[WAY + 5], triangle_within);
}

CASE(a_proof_in_doubles) {
  assert_part("DOUBLE_ERROR of a node", most_of_bound(node_error, PROOF_INPUTS, 6, 20000), 0.0157);
  assert_part("DOUBLE_ERROR of a vertex", most_of_bound(vertex_error, PROOF_INPUTS, 6, 20000),
              0.0157);
}
