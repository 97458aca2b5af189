/* SPDX-License-Identifier: MIT */
/* moves.h - moves of a tool for the tests of the stock: its tip goes straight while two angles turn
 * its axis. */
#ifndef STOCK_MOVES_H
#define STOCK_MOVES_H

#include "stock/stock.h"

#include <math.h>

/* Where a tool is: its tip, and the angles of its axis, Rz(c) Ry(a) ez. */
typedef struct {
  double tip[3], a, c;
} stand;

typedef struct {
  bool rapid;
  int tool;
  stand from, to;
  double reach; /* of the shapes, from the tip */
} move;

/* The pose of a tool that stands there. */
static inline sepax_pose pose_of(const stand *at) {
  double ca = cos(at->a);
  double sa = sin(at->a);
  double cc = cos(at->c);
  double sc = sin(at->c);
  return (sepax_pose){{{cc * ca, -sc, cc * sa}, {sc * ca, cc, sc * sa}, {-sa, 0, ca}},
                      {at->tip[0], at->tip[1], at->tip[2]}};
}

static inline stand stand_between(const move *m, double s) {
  stand at = {.a = m->from.a + s * (m->to.a - m->from.a),
              .c = m->from.c + s * (m->to.c - m->from.c)};
  for (int i = 0; i < 3; i++) {
    at.tip[i] = m->from.tip[i] + s * (m->to.tip[i] - m->from.tip[i]);
  }
  return at;
}

/* The tip is exactly on its way. A point `reach` from it is off by the turn from the middle. */
static inline void piece_of_move(const void *context, double from, double to,
                                 sepax__stock_piece *piece) {
  const move *m = context;
  stand middle = stand_between(m, from / 2 + to / 2);
  stand start = stand_between(m, from);
  double turn = fabs(m->to.a - m->from.a) + fabs(m->to.c - m->from.c);
  piece->at = pose_of(&middle);
  for (int i = 0; i < 3; i++) {
    piece->at.translation[i] = start.tip[i];
    piece->way[i] = (to - from) * (m->to.tip[i] - m->from.tip[i]);
  }
  piece->deviation = turn / 2 * (to - from) * m->reach + 1e-11;
}

/* The way of a move. */
#define WAY(line) (&(sepax__stock_way){piece_of_move, (line)})

#endif
