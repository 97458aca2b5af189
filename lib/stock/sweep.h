/* SPDX-License-Identifier: MIT */
/* sweep.h - a convex shape that goes straight on: which points does it reach? (private) */
#ifndef SEPAX_STOCK_SWEEP_H
#define SEPAX_STOCK_SWEEP_H

#include "stock/stock.h"

/* A limit, ready to be asked: `cube` is how far a cube of half side 1 reaches across it. */
typedef struct {
  bool round;
  double a, b, c, ring, cube;
} sweep_limit;

/* A shape that goes along a way. Frame: row 2 is the tool's axis, and the way has no part along row
 * 1; the origin is that of the tool where the way begins. */
typedef struct {
  double frame[3][3], origin[3];
  double x, z;                      /* the way along rows 0 and 2 of the frame */
  double inverse_x, inverse_length; /* 1 / x, and 1 / the length of the way */
  double close;                     /* Newton steps end when this near */
  int count;
  sweep_limit limit[SEPAX__STOCK_LIMITS];
  double box[2][3]; /* holds all points reached */
} sweep;

/* Make the sweep of a shape along a piece. `grow` is added to the shape on all sides, or taken off
 * if below 0, and besides a length that covers all rounding of what follows, with the sign of
 * `sure`: 1 so that no point reached is denied, -1 so that no point is called reached that is not.
 * `extent` bounds the coordinates of the points that will be asked, in absolute value; `close` is a
 * length that matters to nobody. False if the pose is not valid. */
bool sepax__sweep_make(sweep *s, const sepax__stock_shape *shape, const sepax__stock_piece *piece,
                       double grow, int sure, double extent, double close, sepax_error *error);

/* A point, in the frame of the sweep. */
static inline void sweep_point(const sweep *s, const double p[3], double q[3]) {
  const double d[3] = {p[0] - s->origin[0], p[1] - s->origin[1], p[2] - s->origin[2]};
  for (int i = 0; i < 3; i++) {
    q[i] = s->frame[i][0] * d[0] + s->frame[i][1] * d[1] + s->frame[i][2] * d[2];
  }
}

typedef enum { SWEEP_OUTSIDE, SWEEP_BORDER, SWEEP_INSIDE } sweep_side;

/* Where is the cube with the middle q, in the frame, and the half side `half`, which is aligned
 * with the axes of the stock? With half = 0: where is the point?
 *   - OUTSIDE: the cube has no point of the sweep, nor has any cube of the same size whose middle
 * is less than *reach away.
 *   - INSIDE: the sweep, made larger by the cube, holds q and all points less than *reach away, all
 *     at one time of the way. With half = 0 a ball around q lies in the sweep.
 *   - BORDER: neither is known; *reach is 0.
 * Sure is what the sign of `sure` promises. The other answer is right but for the rounding. */
sweep_side sepax__sweep_locate(const sweep *s, const double q[3], double half, double *reach);

#endif
