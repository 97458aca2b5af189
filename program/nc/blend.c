/* SPDX-License-Identifier: MIT */
/* blend.c - how far a control that blends two motions may be from both of them. */
#include "nc/blend.h"

#include <string.h>

/* More than all roundings of a formula of this file together, relative to its operands. */
static const double rounding = 1e-13;

/* The farthest that each axis is from the corner during a motion; its end is at t = 0 or 1. */
static void reach(const nc_way *way, const double *corner, double far[NC_AXES]) {
  nc_jet axis[NC_AXES];
  nc_way_at(way, (nc_interval){0, 1}, axis);
  for (int i = 0; i < NC_AXES; i++) {
    far[i] = nc_way_rests(way, i) ? 0 : nc_farthest(axis[i].v, corner[i]);
  }
}

static double length(const double *x) { return sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]); }

/* Two straight motions that move X, Y, Z: step 3 of the head of blend.h. */
static void straight(const nc_way *first, const nc_way *second, double within,
                     double off[NC_AXES]) {
  double d1[NC_AXES], d2[NC_AXES], across[3];
  for (int i = 0; i < NC_AXES; i++) {
    d1[i] = first->to[i] - first->from[i];
    d2[i] = second->to[i] - second->from[i];
  }
  double l1 = length(d1), l2 = length(d2);
  double cosine = (d1[0] * d2[0] + d1[1] * d2[1] + d1[2] * d2[2]) / l1 / l2;
  for (int i = 0; i < 3; i++) {
    across[i] = d2[i] / l2 - cosine * d1[i] / l1;
  }
  double sine = cosine > 0 ? length(across) - rounding : 1;
  double most = nc_least(l1, l2);
  /* The cosine is rounded, so near a right angle the weaker bound counts. */
  if (sine > 0) {
    most = nc_least(most, within / (fabs(cosine) < rounding ? sine - rounding : sine));
  }
  double k = nc_least(nc_most(cosine, 0), 1);
  for (int i = 0; i < NC_AXES; i++) {
    double a = d1[i] / l1, b = d2[i] / l2;
    double far = nc_most(fabs(b - k * a), fabs(a - k * b));
    off[i] = most * (1 + rounding) * (far + rounding * (fabs(a) + fabs(b)));
  }
}

/* All that one of the motions does: the one that moves bodies less. Either is right; a degree moves
 * a body that is 150 mm from the axis as far as so many mm. */
static const double a_degree = 2.6;

static void parallelogram(const double far[2][NC_AXES], double off[NC_AXES]) {
  double sum[2] = {0, 0};
  for (int i = 0; i < NC_AXES; i++) {
    double weight = i >= NC_A && i <= NC_C ? a_degree : 1;
    sum[0] += weight * far[0][i];
    sum[1] += weight * far[1][i];
  }
  memcpy(off, far[sum[0] < sum[1] ? 0 : 1], NC_AXES * sizeof *off);
}

/* By the manual's word. */
static void stated(const nc_leg *first, const nc_leg *second, const double far[2][NC_AXES],
                   double within, double off[NC_AXES]) {
  bool replaced = (first->arcs && first->merges) || (second->arcs && second->merges);
  double space = replaced ? 2 * within : within;
  for (int i = 0; i < NC_AXES; i++) {
    bool moves = first->moves[i] || second->moves[i];
    off[i] = !moves ? 0 : i < 3 ? space : nc_above(far[0][i] + far[1][i]);
  }
}

/* The rate and the gain of a straight motion that is not merged. */
static void straight_pace(nc_leg *leg, const nc_limits limits[NC_AXES]) {
  double rate = INFINITY, gain = INFINITY;
  for (int i = 0; i < NC_AXES; i++) {
    double way = fabs(leg->way->to[i] - leg->way->from[i]);
    if (way > 0) {
      rate = nc_least(rate, limits[i].speed / way);
      gain = nc_least(gain, limits[i].acceleration / way);
    }
  }
  if (rate > 0 && gain > 0 && isfinite(rate) && isfinite(gain)) {
    leg->rate = rate;
    leg->gain = gain;
    leg->brake = 2 * rate / gain;
  }
}

void nc_blend_pace(nc_leg *leg, const nc_limits limits[NC_AXES]) {
  double ratio = 0, speed = 0, acceleration = INFINITY;
  leg->rate = leg->gain = leg->brake = 0;
  if (!leg->merges && !leg->arcs) {
    straight_pace(leg, limits);
    return;
  }
  for (int i = 0; i < NC_AXES; i++) {
    if (leg->moves[i]) {
      ratio = nc_most(ratio, limits[i].speed / limits[i].acceleration);
      speed = nc_most(speed, limits[i].speed);
      acceleration = nc_least(acceleration, limits[i].acceleration);
    }
  }
  if (speed > 0 && acceleration > 0 && isfinite(ratio)) {
    leg->brake = 2 * (leg->arcs ? 2 * sqrt(3.0) * speed / acceleration : ratio);
  }
}

/* The shares of both motions that are in the blend. */
static void find_shares(const nc_leg *first, const nc_leg *second, double servo, double share[2]) {
  const double more = 1.05;
  share[0] = share[1] = 1;
  if (servo > 0 && first->rate > 0) {
    double left = more * first->rate * first->rate / first->gain + 2 * first->rate * servo;
    share[0] = nc_least(1, left);
  }
  if (servo > 0 && first->brake > 0 && second->rate > 0) {
    double time = more * first->brake + 2 * servo;
    double grown = more * second->gain * time * time / 2;
    share[1] = nc_least(1, nc_least(second->rate * time, grown));
  }
}

static bool shifts(const nc_leg *leg) { return leg->moves[0] || leg->moves[1] || leg->moves[2]; }

static double largest(const double *off) { return nc_most(nc_most(off[0], off[1]), off[2]); }

void nc_blend_corner(const nc_leg *first, const nc_leg *second, nc_blend blend, double within,
                     double servo, double off[NC_AXES]) {
  double far[2][NC_AXES], whole[NC_AXES], share[2];
  memset(off, 0, NC_AXES * sizeof *off);
  if (blend == NC_EXACT) {
    return;
  }
  reach(first->way, first->way->to, far[0]);
  reach(second->way, second->way->from, far[1]);
  find_shares(first, second, servo, share);
  for (int i = 0; i < NC_AXES; i++) {
    far[0][i] = nc_least(far[0][i], share[0] * far[0][i] * (1 + 0x1p-40));
    far[1][i] = nc_least(far[1][i], share[1] * far[1][i] * (1 + 0x1p-40));
  }
  parallelogram((const double(*)[NC_AXES])far, whole);
  bool merges = first->merges || second->merges;
  if (blend == NC_UNBOUNDED || (!merges && (!shifts(first) || !shifts(second)))) {
    memcpy(off, whole, sizeof whole);
    return;
  }
  if (merges || first->arcs || second->arcs) {
    stated(first, second, (const double(*)[NC_AXES])far, within, off);
  } else {
    straight(first->way, second->way, within, off);
  }
  if (!merges && largest(whole) < largest(off)) {
    memcpy(off, whole, sizeof whole);
  }
}

void nc_blend_joints(const nc_kinematics *k, const nc_way *first, const nc_way *second,
                     const double off[NC_AXES], double joint[NC_JOINTS_MOST]) {
  nc_jet a[NC_AXES], b[NC_AXES], moved[NC_JOINTS_MOST];
  nc_way_at(first, (nc_interval){0, 1}, a);
  nc_way_at(second, (nc_interval){0, 1}, b);
  for (int i = 0; i < NC_AXES; i++) {
    nc_interval beside = {-off[i], off[i]};
    a[i] = (nc_jet){nc_add(nc_hull(a[i].v, b[i].v), beside), beside, nc_point(0)};
  }
  nc_kinematics_joints(k, a, moved);
  for (size_t n = 0; n < k->joints; n++) {
    joint[n] = nc_size(moved[n].d);
  }
}
