/* SPDX-License-Identifier: MIT */
/* motion.c - chains of joints; a pair's motion to second order. */
#include "motion.h"

#include "report.h"

#include <float.h>

_Static_assert(LDBL_MANT_DIG >= 64, "poses need more bits than a double has");

static void append(chain *c, chain_part part) {
  GROW(c->part, c->count);
  c->part[c->count++] = part;
}

static int parent(const robot *r, int link) {
  return r->link[link].joint < 0 ? -1 : r->joint[r->link[link].joint].parent;
}

/* The links down to `link`, its root first; `steps` of them. */
static int *line_of(const robot *r, int link, int *steps) {
  *steps = 0;
  for (int at = link; at >= 0; at = parent(r, at))
    ++*steps;
  int *line = memory(NULL, (size_t)*steps, sizeof *line);
  int n = *steps;
  for (int at = link; at >= 0; at = parent(r, at))
    line[--n] = at;
  return line;
}

chain chain_between(const robot *r, int first, int second) {
  int down = 0;
  int up = 0;
  const int *to = line_of(r, first, &down);
  const int *back = line_of(r, second, &up);
  int common = 0;
  while (common < down && common < up && to[common] == back[common])
    common++;
  if (common == 0) {
    cannot("no joints lead from %s to %s", r->link[first].name, r->link[second].name);
  }
  chain c = {NULL, 0};
  for (int n = up - 1; n >= common; n--) {
    const int at = r->link[back[n]].joint;
    if (r->joint[at].kind != JOINT_FIXED)
      append(&c, (chain_part){at, -1, POSE_NONE});
    append(&c, (chain_part){-1, 1, pose_inverse(r->joint[at].origin)});
  }
  for (int n = common; n < down; n++) {
    const int at = r->link[to[n]].joint;
    append(&c, (chain_part){-1, 1, r->joint[at].origin});
    if (r->joint[at].kind != JOINT_FIXED)
      append(&c, (chain_part){at, 1, POSE_NONE});
  }
  return c;
}

static pose joint_pose(const joint *j, long double value) {
  if (j->kind == JOINT_REVOLUTE) {
    return (pose){quaternion_about(j->axis, value), {0, 0, 0}};
  }
  return (pose){{1, {0, 0, 0}}, point_times(value, j->axis)};
}

pose chain_pose(const chain *c, const robot *r, const long double *value) {
  pose at = POSE_NONE;
  for (int n = 0; n < c->count; n++) {
    const chain_part *p = &c->part[n];
    at = pose_product(
        at, p->joint < 0 ? p->fixed : joint_pose(&r->joint[p->joint], p->sign * value[p->joint]));
  }
  return at;
}

typedef struct {
  long double value, rate; /* at the middle; from there to the end */
} course;

static course course_of(const chain_part *p, const interval *i) {
  const long double from = i->from[p->joint];
  const long double way = i->to[p->joint] - from;
  return (course){p->sign * (from + i->middle * way), p->sign * (i->half * way)};
}

/* C / 2, and what is above the rounding. A term of a separating axis (a vertex of the first body at
 * s, of the second, their projections on a unit vector) is a sum of fewer than 64 products, each
 * below `scale`: the bodies' reach, and that times what the turns add. In doubles this loses less
 * than 64 2^-53 scale < 1e-14 scale; poses in long double, of up to 500 parts, less than 500 * 20 *
 * 2^-64 scale < 1e-15 scale, and turns by large angles 2^-62 of the angle. */
static void bounds(const chain *c, const robot *r, const interval *i, motion *m) {
  long double reach = i->radius_first;
  long double behind = 0; /* |d_j| R_j of the parts so far */
  long double bend = 0;
  long double turns = 0;
  long double angles = 0;
  for (int n = c->count - 1; n >= 0; n--) {
    const chain_part *p = &c->part[n];
    if (p->joint < 0) {
      reach += point_length(p->fixed.shift);
      continue;
    }
    const course q = course_of(p, i);
    const long double rate = fabsl(q.rate);
    if (r->joint[p->joint].kind == JOINT_PRISMATIC) {
      behind += rate;
      reach += fabsl(q.value) + rate;
    } else {
      bend += rate * (rate * reach + 2 * behind);
      behind += rate * reach;
      turns += rate;
      angles += fabsl(q.value) + rate;
    }
  }
  const long double scale = (reach + i->radius_second) * (1 + 2 * turns) + behind;
  m->curve = (double)(bend / 2 * (1 + 1e-12L));
  m->rounding = (double)(scale * (1e-13L + angles * 0x1p-60L));
}

motion chain_motion(const chain *c, const robot *r, const interval *i) {
  motion m = {0};
  pose at = POSE_NONE;
  point spin = {0, 0, 0};
  point drift = {0, 0, 0};
  for (int n = 0; n < c->count; n++) {
    const chain_part *p = &c->part[n];
    if (p->joint < 0) {
      at = pose_product(at, p->fixed);
      continue;
    }
    const joint *j = &r->joint[p->joint];
    const course q = course_of(p, i);
    const point along = point_times(q.rate, quaternion_turn(at.turn, j->axis));
    if (j->kind == JOINT_PRISMATIC) {
      drift = point_plus(drift, along);
    } else {
      spin = point_plus(spin, along);
      drift = point_minus(drift, point_cross(along, at.shift));
    }
    at = pose_product(at, joint_pose(j, q.value));
  }
  m.column[0] = point_near(quaternion_turn(at.turn, (point){1, 0, 0}));
  m.column[1] = point_near(quaternion_turn(at.turn, (point){0, 1, 0}));
  m.column[2] = point_near(quaternion_turn(at.turn, (point){0, 0, 1}));
  m.shift = point_near(at.shift);
  m.spin = point_near(spin);
  m.drift = point_near(drift);
  bounds(c, r, i, &m);
  return m;
}
