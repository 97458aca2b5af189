/* SPDX-License-Identifier: MIT */
/* joints.c - pieces of linear joint motion: is the tool where they say? Against places in long
 * double. */
#include "mechanism/steps.h"
#include "stock/stock.h"
#include "unit/mechanism/places.h"

enum { JOINTS_MOST = 8, STEPS = 24 };

typedef struct {
  sepax_mechanism m;
  sepax_chain chain;
  double from[JOINTS_MOST], to[JOINTS_MOST], value[3][JOINTS_MOST];
  size_t a, b;
  sepax__stock_joints way;
} motion;

static place back(const place *p) {
  place r = {{p->q[0], -p->q[1], -p->q[2], -p->q[3]}, {0, 0, 0}};
  turn(r.q, p->t, r.t);
  for (int i = 0; i < 3; i++) {
    r.t[i] = -r.t[i];
  }
  return r;
}

/* Link A in B's coordinates at a part of the way. */
static place seen(const motion *w, long double part) {
  place at[JOINTS_MOST + 1] = {{{1, 0, 0, 0}, {0, 0, 0}}};
  for (size_t n = 0; n < w->m.joints; n++) {
    place step = place_of(&w->m.joint[n], w->from[n] + ((long double)w->to[n] - w->from[n]) * part);
    at[n + 1] = after(&at[w->m.joint[n].parent], &step);
  }
  place from_b = back(&at[w->b]);
  return after(&from_b, &at[w->a]);
}

static motion *draw_motion(double size) {
  motion *w = calloc(1, sizeof *w);
  assert_non_null(w);
  w->m = row_of(1 + (size_t)random_below(JOINTS_MOST));
  for (size_t n = 0; n < w->m.joints; n++) {
    draw_joint(&w->m.joint[n], n + 1);
    w->from[n] = 3 * random_unit();
    w->to[n] = w->from[n] + size * random_unit();
  }
  w->a = (size_t)random_below((int)w->m.joints + 1);
  w->b = (size_t)random_below((int)w->m.joints + 1);
  assert_works(sepax_mechanism_join(&w->m, &fault));
  assert_works(sepax_chain_find(&w->chain, &w->m, w->a, w->b, &fault));
  w->way = (sepax__stock_joints){.chain = &w->chain,
                                 .mechanism = &w->m,
                                 .mount = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}},
                                 .from = w->from,
                                 .to = w->to,
                                 .value = {w->value[0], w->value[1], w->value[2]}};
  for (int i = 0; i < 3; i++) {
    double end[2] = {2 * random_unit(), 2 * random_unit()};
    w->way.box[0][i] = fmin(end[0], end[1]);
    w->way.box[1][i] = fmax(end[0], end[1]);
  }
  return w;
}

static void free_motion(motion *w) {
  sepax_chain_free(&w->chain);
  sepax_mechanism_free(&w->m);
  free(w);
}

/* The farthest that a point of the box is from where the piece puts it. */
static double farthest_of(const motion *w, const sepax__stock_piece *piece, double from,
                          double to) {
  long double most = 0;
  for (int step = 0; step <= STEPS; step++) {
    long double part = (long double)step / STEPS;
    place at = seen(w, from + ((long double)to - from) * part);
    for (int n = 0; n < 9; n++) {
      long double v[3];
      long double p[3];
      long double square = 0;
      for (int i = 0; i < 3; i++) {
        v[i] = n < 8 ? w->way.box[n >> i & 1][i] : (w->way.box[0][i] + w->way.box[1][i]) / 2;
      }
      turn(at.q, v, p);
      for (int i = 0; i < 3; i++) {
        long double there = piece->at.translation[i] + part * piece->way[i];
        for (int j = 0; j < 3; j++) {
          there += piece->at.rotation[i][j] * v[j];
        }
        square += (p[i] + at.t[i] - there) * (p[i] + at.t[i] - there);
      }
      most = fmaxl(most, sqrtl(square));
    }
  }
  return (double)most;
}

CASE(no_point_is_farther_than_the_deviation) {
  double tightest = 0;
  for (int n = 0; n < FEWER(3000); n++) {
    const double sizes[4] = {1, 0.1, 1e-3, 1e-7};
    motion *w = draw_motion(sizes[n % 4]);
    double from = n % 5 == 0 ? 0 : fabs(random_unit());
    double to = from + (1 - from) * fabs(random_unit());
    sepax__stock_piece piece;
    sepax__stock_joint_piece(&w->way, from, to, &piece);
    double farthest = farthest_of(w, &piece, from, to);
    assert_true(farthest <= piece.deviation);
    tightest = farthest > 1e-6 ? fmax(tightest, farthest / piece.deviation) : tightest;
    free_motion(w);
  }
  assert_true(tightest > 0.9); /* it is no mere sum of all ways */
}

/* The farthest that a corner of the box is from its chord. */
static double off_chord(const motion *w) {
  const place end[2] = {seen(w, 0), seen(w, 1)};
  long double most = 0;
  for (int step = 1; step < STEPS; step++) {
    long double part = (long double)step / STEPS;
    place at = seen(w, part);
    for (int n = 0; n < 8; n++) {
      long double v[3];
      long double p[3][3];
      long double square = 0;
      for (int i = 0; i < 3; i++) {
        v[i] = w->way.box[n >> i & 1][i];
      }
      turn(end[0].q, v, p[0]);
      turn(end[1].q, v, p[1]);
      turn(at.q, v, p[2]);
      for (int i = 0; i < 3; i++) {
        long double chord = (1 - part) * (p[0][i] + end[0].t[i]) + part * (p[1][i] + end[1].t[i]);
        square += (p[2][i] + at.t[i] - chord) * (p[2][i] + at.t[i] - chord);
      }
      most = fmaxl(most, sqrtl(square));
    }
  }
  return (double)most;
}

CASE(no_point_is_farther_from_its_chord_than_the_bend) {
  double tightest = 0;
  for (int n = 0; n < FEWER(3000); n++) {
    motion *w = draw_motion(n % 2 == 0 ? 1 : 0.1);
    double middle[JOINTS_MOST];
    for (size_t k = 0; k < w->m.joints; k++) {
      middle[k] = w->from[k] / 2 + w->to[k] / 2;
    }
    double bend = sepax__chain_bend(&w->chain, &w->m, w->from, middle, w->to, w->way.box);
    double farthest = off_chord(w);
    assert_true(farthest <= bend);
    tightest = farthest > 1e-6 ? fmax(tightest, farthest / bend) : tightest;
    free_motion(w);
  }
  assert_true(tightest > 0.9); /* one joint turns the box around its axis */
}

CASE(ways_without_turning_are_one_piece) {
  motion *w = draw_motion(1);
  for (int n = 0; n < 200; n++) {
    free_motion(w);
    w = draw_motion(1);
    for (size_t k = 0; k < w->m.joints; k++) {
      w->to[k] = w->m.joint[k].kind == SEPAX_JOINT_PRISMATIC ? w->to[k] : w->from[k];
    }
    sepax__stock_piece piece;
    sepax__stock_joint_piece(&w->way, 0, 1, &piece);
    assert_true(piece.deviation < 1e-9);
    assert_true(farthest_of(w, &piece, 0, 1) <= piece.deviation);
  }
  free_motion(w);
}

/* Where the tool is not the link: its axis and its box. */
CASE(a_mounted_tool_is_in_its_box) {
  const sepax__stock_corner corner[4] = {{0, -1, 0}, {0.7, -1, 0}, {0.7, 2, 0}, {0, 2, 0}};
  sepax__stock_shape shape[2];
  assert_works(sepax__stock_shape_make(corner, 4, 1, &shape[0], &shape[1], &fault));
  for (int n = 0; n < 200; n++) {
    motion *w = draw_motion(0.1);
    const double c = cos(n);
    const double s = sin(n);
    w->way.mount = (sepax_pose){{{c, 0, s}, {0, 1, 0}, {-s, 0, c}}, {0.1 * n, 2, -1}};
    sepax__stock_mounted_box(&shape[0], &w->way.mount, w->way.box);
    for (int k = 0; k < 60; k++) {
      double angle = PI * random_unit();
      const double v[3] = {0.7 * cos(angle), 0.7 * sin(angle), k % 2 == 0 ? -1 : 2};
      double p[3];
      sepax_pose_apply(&w->way.mount, v, p);
      for (int i = 0; i < 3; i++) {
        assert_true(p[i] >= w->way.box[0][i] && p[i] <= w->way.box[1][i]);
      }
    }
    sepax__stock_piece piece;
    sepax__stock_joint_piece(&w->way, 0, 1, &piece);
    sepax_pose link = piece.at; /* the link, from the tool's pose */
    sepax_pose off = sepax_pose_inverse(&w->way.mount);
    link = sepax_pose_compose(&link, &off);
    piece.at = link;
    assert_true(farthest_of(w, &piece, 0, 1) <= piece.deviation + 1e-12);
    free_motion(w);
  }
}
