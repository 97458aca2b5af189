/* SPDX-License-Identifier: MIT */
/* motion.h - how one body of a pair moves, seen from the other, while the joints go linearly.
 *
 * The chain of the pair is a product E_1(s) E_2(s) ... E_m(s) of poses, from the second body's link
 * to the first's: constant ones, turns about an axis by q_j + s d_j and shifts along an axis by
 * q_j + s d_j; s is 0 at the middle of the interval, -1 and 1 at its ends. A joint on the second
 * body's side goes backwards. For a point p of the first body, seen from the second,
 *
 *     p'(s)  = sum of d_j w_j(s):  w_j = a_j x (p - c_j) of a turn, w_j = a_j of a shift,
 *     p''(s) = sum over turns i of d_i a_i x (d_i w_i + 2 sum over j > i of d_j w_j),
 *
 * as a_j, c_j and all behind them turn with each E_i before them. With |w_j| <= R_j (1 of a shift)
 *
 *     |p''(s)| <= sum over turns i of |d_i| (|d_i| R_i + 2 sum over j > i of |d_j| R_j) = C,
 *
 * and by Taylor's theorem p(s) is within C / 2 of p(0) + s p'(0), for any s of the interval. p'(0)
 * is spin x p + drift, the same two vectors for all points. R_j: seen from E_j, the body is within
 * the sum of the lengths of all shifts behind E_j (the longest in the interval) and the body's
 * radius. */
#ifndef CERTIFICATE_MOTION_H
#define CERTIFICATE_MOTION_H

#include "robot.h"

typedef struct {
  int joint; /* -1: constant */
  int sign;  /* -1: backwards */
  pose fixed;
} chain_part;

typedef struct {
  chain_part *part;
  int count;
} chain;

/* From the coordinates of link first to those of link second. */
chain chain_between(const robot *r, int first, int second);

typedef struct {
  vec column[3]; /* p of the first body is at column[0] p.x + ... + shift at the middle */
  vec shift;
  vec spin, drift; /* and at s from there by s (spin x that + drift), but for */
  double curve;    /* at most this */
  double rounding; /* above what the arithmetic of a separating axis loses */
} motion;

typedef struct {
  const long double *from, *to; /* values of the joints at the ends of the segment */
  long double middle, half;     /* parts of the segment */
  double radius_first, radius_second;
} interval;

motion chain_motion(const chain *c, const robot *r, const interval *i);

/* Where the first body's link is, seen from the second's. */
pose chain_pose(const chain *c, const robot *r, const long double *value);

#endif
