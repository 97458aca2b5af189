/* SPDX-License-Identifier: MIT */
/* solid_oracle.h - what is inside what, in whole numbers of any size (GMP), by rays of random
 * direction against every triangle; and what a shell must be, every edge against every other. */
#ifndef SOLID_ORACLE_H
#define SOLID_ORACLE_H

#include "harness.h"
#include "oracle/oracle.h"

#include <gmp.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef double points[3][3];

typedef mpz_t whole_point[3];

/* The vertices of both meshes in space, times one power of two that makes them whole: vertex k of
 * triangle n of mesh i is v[i][3 n + k]. */
typedef struct {
  whole_point *v[2];
  size_t count[2];
} space;

static void find_posed(mpq_t r, const double v[3], const sepax_pose *pose, int axis) {
  mpq_t p;
  mpq_t q;
  mpq_inits(p, q, NULL);
  mpq_set_d(r, pose == NULL ? v[axis] : pose->translation[axis]);
  for (int k = 0; k < 3 && pose != NULL; k++) {
    mpq_set_d(p, pose->rotation[axis][k]);
    mpq_set_d(q, v[k]);
    mpq_mul(p, p, q);
    mpq_add(r, r, p);
  }
  mpq_clears(p, q, NULL);
}

static void place(space *s, const sepax_soup m[2], const sepax_pose *const pose[2]) {
  const mp_bitcnt_t places = 4400; /* of which none is lost: a product of two doubles has fewer */
  mpq_t x;
  mpq_init(x);
  for (int i = 0; i < 2; i++) {
    s->count[i] = m[i].count;
    s->v[i] = calloc(3 * m[i].count + 1, sizeof *s->v[i]);
    assert_non_null(s->v[i]);
    for (size_t n = 0; n < 9 * m[i].count; n++) {
      find_posed(x, m[i].facet[n / 9].v[n / 3 % 3], pose[i], (int)(n % 3));
      mpz_init(s->v[i][n / 3][n % 3]);
      mpq_mul_2exp(x, x, places);
      assert_int_equal(mpz_cmp_ui(mpq_denref(x), 1), 0);
      mpz_set(s->v[i][n / 3][n % 3], mpq_numref(x));
    }
  }
  mpq_clear(x);
  mp_bitcnt_t zeros = places;
  for (int pass = 0; pass < 2; pass++) {
    for (size_t n = 0; n < 9 * (m[0].count + m[1].count); n++) {
      size_t i = n >= 9 * m[0].count;
      size_t at = n - 9 * i * m[0].count;
      mpz_t *c = &s->v[i][at / 3][at % 3];
      if (pass == 0 && mpz_sgn(*c) != 0 && mpz_scan1(*c, 0) < zeros) {
        zeros = mpz_scan1(*c, 0);
      } else if (pass == 1) {
        mpz_tdiv_q_2exp(*c, *c, zeros);
      }
    }
  }
}

static void leave(space *s) {
  for (int i = 0; i < 2; i++) {
    for (size_t n = 0; n < 3 * s->count[i]; n++) {
      mpz_clears(s->v[i][n][0], s->v[i][n][1], s->v[i][n][2], NULL);
    }
    free(s->v[i]);
  }
}

static void subtract(whole_point r, whole_point p, whole_point q) {
  for (int i = 0; i < 3; i++) {
    mpz_sub(r[i], p[i], q[i]);
  }
}

/* r is neither p nor q. */
static void cross(whole_point r, whole_point p, whole_point q) {
  for (int i = 0; i < 3; i++) {
    mpz_mul(r[i], p[(i + 1) % 3], q[(i + 2) % 3]);
    mpz_submul(r[i], p[(i + 2) % 3], q[(i + 1) % 3]);
  }
}

/* The sign of the product of two vectors. */
static int along(whole_point p, whole_point q) {
  mpz_t sum;
  mpz_init(sum);
  for (int i = 0; i < 3; i++) {
    mpz_addmul(sum, p[i], q[i]);
  }
  int sign = mpz_sgn(sum);
  mpz_clear(sum);
  return sign;
}

/* 0: the ray from p does not meet the triangle, 1, -1: on which side; UNCLEAR: it meets an edge, or
 * is in its plane. */
enum { UNCLEAR = 9 };

static int ray_meets(whole_point p, whole_point way, whole_point t[3]) {
  whole_point r[6]; /* the vertices from p, two vectors, the normal */
  int side[3];
  for (int k = 0; k < 18; k++) {
    mpz_init(r[k / 3][k % 3]);
  }
  subtract(r[3], t[1], t[0]);
  subtract(r[4], t[2], t[0]);
  cross(r[5], r[3], r[4]);
  bool no_area = mpz_sgn(r[5][0]) == 0 && mpz_sgn(r[5][1]) == 0 && mpz_sgn(r[5][2]) == 0;
  for (int k = 0; k < 3; k++) {
    subtract(r[k], t[k], p);
  }
  int facing = along(way, r[5]);
  int height = along(r[0], r[5]);
  for (int k = 0; k < 3; k++) {
    cross(r[3], r[k], r[(k + 1) % 3]);
    side[k] = along(way, r[3]);
  }
  for (int k = 0; k < 18; k++) {
    mpz_clear(r[k / 3][k % 3]);
  }
  if (no_area || side[0] * side[1] < 0 || side[1] * side[2] < 0 || side[2] * side[0] < 0) {
    return 0;
  }
  if (side[0] == 0 || side[1] == 0 || side[2] == 0 || facing == 0 || height == 0) {
    return UNCLEAR;
  }
  return height == facing ? facing : 0;
}

/* Along directions at random until one meets no edge: how often the ray meets the part, and how
 * much more often it leaves than enters. */
static void oracle_crossings(whole_point p, whole_point *t, const size_t *part, size_t which,
                             size_t count, int *times, int *turns) {
  whole_point way;
  int met = UNCLEAR;
  mpz_inits(way[0], way[1], way[2], NULL);
  while (met == UNCLEAR) {
    *times = *turns = 0;
    met = 0;
    for (int i = 0; i < 3; i++) {
      mpz_set_si(way[i], random_below(1 << 20) - (1 << 19));
    }
    for (size_t n = 0; n < count && met != UNCLEAR; n++) {
      met = part[n] == which ? ray_meets(p, way, &t[3 * n]) : 0;
      *times += met != 0;
      *turns += met;
    }
  }
  mpz_clears(way[0], way[1], way[2], NULL);
}

static bool same_point(const double p[3], const double q[3]) {
  return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
}

/* 1: q runs from -> to, -1: to -> from, 0: another edge. */
static int same_edge(const double p[3], const double q[3], const double r[3], const double s[3]) {
  return same_point(p, q)                       ? 0
         : same_point(p, r) && same_point(q, s) ? 1
         : same_point(p, s) && same_point(q, r) ? -1
                                                : 0;
}

/* What the shell of a mesh must be, every edge against every other. part, piece: the lowest
 * triangle of the same. */
typedef struct {
  bool closed, consistent;
  size_t *part, *piece, parts, pieces;
  bool *turned; /* at a part's lowest triangle: the part is not consistent, */
  bool *open;   /* is open */
} oracle_shell;

static void merge(size_t *set, size_t count, size_t p, size_t q) {
  size_t low = set[p] < set[q] ? set[p] : set[q];
  size_t high = set[p] < set[q] ? set[q] : set[p];
  for (size_t n = 0; n < count; n++) {
    set[n] = set[n] == high ? low : set[n];
  }
}

static bool boxes_disjoint(const points p, const points q) {
  for (int i = 0; i < 3; i++) {
    if (fmax(fmax(p[0][i], p[1][i]), p[2][i]) < fmin(fmin(q[0][i], q[1][i]), q[2][i])) {
      return true;
    }
  }
  return false;
}

/* ---- edges whose triangles do not cancel, as segments in space */

typedef struct {
  const double *from, *to;
  size_t triangle;
  bool odd;  /* of an odd number of triangles */
  int turns; /* how much more often triangles run it from `from` to `to` than back */
} odd_edge;

/* r is on the line through p and q, which differ. */
static bool is_on_line(const double p[3], const double q[3], const double r[3]) {
  mpq_t d[6];
  mpq_t origin;
  bool on = true;
  mpq_init(origin);
  for (int i = 0; i < 6; i++) {
    mpq_init(d[i]);
    mpq_set_d(d[i], (i < 3 ? q : r)[i % 3]);
    mpq_set_d(origin, p[i % 3]);
    mpq_sub(d[i], d[i], origin);
  }
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3;
    mpq_t left;
    mpq_t right;
    mpq_inits(left, right, NULL);
    mpq_mul(left, d[i], d[3 + j]);
    mpq_mul(right, d[j], d[3 + i]);
    on = on && mpq_equal(left, right) != 0;
    mpq_clears(left, right, NULL);
  }
  for (int i = 0; i < 6; i++) {
    mpq_clear(d[i]);
  }
  mpq_clear(origin);
  return on;
}

/* An axis along which a segment has a length. */
static int axis_of(const odd_edge *e) {
  int i = 0;
  while (e->from[i] == e->to[i]) {
    i++;
  }
  return i;
}

static bool covers(const odd_edge *e, const double p[3]) {
  int i = axis_of(e);
  return p[i] >= fmin(e->from[i], e->to[i]) && p[i] <= fmax(e->from[i], e->to[i]) &&
         is_on_line(e->from, e->to, p);
}

static int by_number(const void *p, const void *q) {
  double a = *(const double *)p;
  double b = *(const double *)q;
  return (a > b) - (a < b);
}

/* Between any two ends that follow each other on edge e: how many edges are there, and how often
 * one way? */
static void judge_oracle_edge(oracle_shell *o, const odd_edge *edge, size_t count, size_t e) {
  int axis = axis_of(&edge[e]);
  double *at = calloc(2 * count, sizeof *at);
  size_t *on = calloc(count, sizeof *on); /* edges on its line */
  size_t ends = 0;
  size_t lines = 0;
  for (size_t n = 0; n < count; n++) {
    if (is_on_line(edge[e].from, edge[e].to, edge[n].from) &&
        is_on_line(edge[e].from, edge[e].to, edge[n].to)) {
      on[lines++] = n;
      for (int k = 0; k < 2; k++) {
        const double *p = k == 0 ? edge[n].from : edge[n].to;
        if (covers(&edge[e], p)) {
          at[ends++] = p[axis];
        }
      }
    }
  }
  qsort(at, ends, sizeof *at, by_number);
  for (size_t n = 1; n < ends; n++) {
    int times = 0;
    int turns = 0;
    for (size_t k = 0; k < lines && at[n] > at[n - 1]; k++) {
      double from = edge[on[k]].from[axis];
      double to = edge[on[k]].to[axis];
      if (fmin(from, to) <= at[n - 1] && fmax(from, to) >= at[n]) {
        times += edge[on[k]].odd;
        turns += to > from ? edge[on[k]].turns : -edge[on[k]].turns;
      }
    }
    o->closed = o->closed && times % 2 == 0;
    o->open[edge[e].triangle] = o->open[edge[e].triangle] || times % 2 != 0;
    o->consistent = o->consistent && abs(turns) <= 1;
    o->turned[edge[e].triangle] = o->turned[edge[e].triangle] || abs(turns) > 1;
  }
  free(at);
  free(on);
}

static void judge_oracle_edges(oracle_shell *o, const odd_edge *edge, size_t count, size_t facets) {
  for (size_t e = 0; e < count; e++) {
    judge_oracle_edge(o, edge, count, e);
    for (size_t n = 0; n < e; n++) {
      const odd_edge *p = &edge[e];
      const odd_edge *q = &edge[n];
      bool meet = same_point(p->from, q->from) || same_point(p->from, q->to) ||
                  same_point(p->to, q->from) || same_point(p->to, q->to);
      if (meet && is_on_line(p->from, p->to, q->from) && is_on_line(p->from, p->to, q->to)) {
        merge(o->part, facets, p->triangle, q->triangle);
      }
    }
  }
}

static void find_oracle_shell(oracle_shell *o, const sepax_soup *m) {
  odd_edge *odd = calloc(3 * m->count, sizeof *odd);
  size_t odds = 0;
  *o = (oracle_shell){true,
                      true,
                      calloc(m->count, sizeof(size_t)),
                      calloc(m->count, sizeof(size_t)),
                      0,
                      0,
                      calloc(m->count, 1),
                      calloc(m->count, 1)};
  for (size_t n = 0; n < m->count; n++) {
    o->part[n] = n;
  }
  for (size_t n = 0; n < 3 * m->count; n++) {
    const double(*t)[3] = m->facet[n / 3].v;
    const double *p = t[n % 3];
    const double *q = t[(n + 1) % 3];
    int count = 0;
    int turns = 0;
    bool first = true;
    for (size_t k = 0; k < 3 * m->count; k++) {
      const double(*u)[3] = m->facet[k / 3].v;
      int way = same_edge(p, q, u[k % 3], u[(k + 1) % 3]);
      count += way != 0;
      turns += way;
      if (way != 0) {
        first = first && k >= n;
        merge(o->part, m->count, n / 3, k / 3);
      }
    }
    if (turns != 0 && first) {
      odd[odds++] = (odd_edge){p, q, n / 3, count % 2 != 0, turns};
    }
  }
  judge_oracle_edges(o, odd, odds, m->count);
  free(odd);
  for (size_t n = 0; n < m->count; n++) {
    o->turned[o->part[n]] = o->turned[o->part[n]] || o->turned[n];
    o->open[o->part[n]] = o->open[o->part[n]] || o->open[n];
  }
  memcpy(o->piece, o->part, m->count * sizeof *o->part);
  for (size_t n = 0; n < m->count; n++) {
    for (size_t k = 0; k < m->count; k++) {
      const double(*t)[3] = m->facet[n].v;
      const double(*u)[3] = m->facet[k].v;
      if (o->piece[n] != o->piece[k] && !boxes_disjoint(t, u) && !boxes_disjoint(u, t) &&
          oracle_collide_posed(t, NULL, u, NULL)) {
        merge(o->piece, m->count, n, k);
      }
    }
  }
  for (size_t n = 0; n < m->count; n++) {
    o->parts += o->part[n] == n;
    o->pieces += o->piece[n] == n;
  }
}

static void free_oracle_shell(oracle_shell *o) {
  free(o->part);
  free(o->piece);
  free(o->turned);
  free(o->open);
}

/* What may be said of a point. */
typedef enum { ORACLE_OUTSIDE, ORACLE_NOT_INSIDE, ORACLE_UNKNOWN, ORACLE_INSIDE } oracle_answer;

/* By the parts that a ray meets once more one way than the other, or an odd number of times. Parts
 * that hold the point and do not touch are in each other: the outer ones begin farther out. */
static oracle_answer oracle_inside(whole_point p, whole_point *t, const oracle_shell *o,
                                   size_t count) {
  int sum = 0;
  size_t odds = 0;
  size_t held = 0;
  bool any = false;
  bool consistent = true;
  bool negative = true;
  struct {
    size_t part;
    int turns;
  } round[64];
  for (size_t part = 0; part < count; part++) {
    if (o->part[part] != part || o->open[part]) {
      continue;
    }
    int times;
    int turns;
    oracle_crossings(p, t, o->part, part, count, &times, &turns);
    bool in = times % 2 != 0 || (!o->turned[part] && turns != 0);
    any = any || o->turned[part] || times != 0;
    if (!in) {
      continue;
    }
    assert_true(held < LENGTH(round));
    round[held].part = part;
    round[held++].turns = turns;
    odds += times % 2 != 0;
    sum += turns;
    consistent = consistent && !o->turned[part];
    negative = negative && turns < 0;
  }
  if (held == 0) {
    return any ? ORACLE_NOT_INSIDE : ORACLE_OUTSIDE;
  }
  if (consistent ? sum > 0 || negative : odds % 2 != 0) {
    return ORACLE_INSIDE;
  }
  if (!consistent || sum != 0) {
    return ORACLE_UNKNOWN;
  }
  int depth[64] = {0}; /* how many of the others are round it */
  for (size_t n = 0; n < held; n++) {
    for (size_t k = 0; k < held; k++) {
      if (k == n) {
        continue;
      }
      if (o->piece[round[k].part] == o->piece[round[n].part]) {
        return ORACLE_UNKNOWN;
      }
      int times;
      int turns;
      oracle_crossings(t[3 * round[n].part], t, o->part, round[k].part, count, &times, &turns);
      depth[n] += turns != 0;
    }
  }
  for (size_t n = 0; n < held; n++) {
    if (round[n].turns != (depth[n] % 2 == 0 ? 1 : -1)) {
      return ORACLE_UNKNOWN;
    }
  }
  return ORACLE_OUTSIDE;
}

/* Of some vertices of mesh i. Of bodies that do not collide, one vertex tells for its part. */
static oracle_answer oracle_within(space *s, int i, const oracle_shell *other) {
  oracle_answer most = ORACLE_OUTSIDE;
  for (size_t n = 0; n < 3 * s->count[i] && most != ORACLE_INSIDE;
       n += 1 + (size_t)random_below(23)) {
    oracle_answer one = oracle_inside(s->v[i][n], s->v[!i], other, s->count[!i]);
    most = one > most ? one : most;
  }
  return most;
}

static void assert_answer(sepax_inside within, oracle_answer expected) {
  switch (expected) {
  case ORACLE_OUTSIDE:
    assert_int_equal(within, SEPAX_OUTSIDE);
    break;
  case ORACLE_INSIDE:
    assert_int_equal(within, SEPAX_INSIDE);
    break;
  case ORACLE_UNKNOWN:
    assert_int_equal(within, SEPAX_INSIDE_UNKNOWN);
    break;
  case ORACLE_NOT_INSIDE: /* another ray may tell */
    assert_true(within != SEPAX_INSIDE);
    break;
  }
}

/* How many vertices of m are, for certain or perhaps, in the box of all open parts of the other
 * mesh: whether a part of m is inside of these is unknown where all are; where none is, the closed
 * parts tell. */
static void assert_may_be_within(sepax_inside within, const sepax_soup *m, const sepax_pose *pose,
                                 const sepax_soup *other, const sepax_pose *pose_other,
                                 const oracle_shell *o, oracle_answer expected) {
  const sepax_pose still = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};
  const double margin = 1e-6;
  double low[3] = {INFINITY, INFINITY, INFINITY};
  double high[3] = {-INFINITY, -INFINITY, -INFINITY};
  size_t in = 0;
  size_t perhaps = 0;
  pose = pose != NULL ? pose : &still;
  pose_other = pose_other != NULL ? pose_other : &still;
  for (size_t n = 0; other->facet != NULL && n < 9 * other->count; n++) {
    double x = other->facet[n / 9].v[n / 3 % 3][n % 3];
    bool open = o->open[o->part[n / 9]];
    low[n % 3] = fmin(low[n % 3], open ? x : INFINITY);
    high[n % 3] = fmax(high[n % 3], open ? x : -INFINITY);
  }
  for (size_t n = 0; m->facet != NULL && n < 3 * m->count; n++) {
    const double *v = m->facet[n / 3].v[n % 3];
    double away[3];
    bool is_in = true;
    bool may_be = true;
    for (int i = 0; i < 3; i++) {
      away[i] = pose->translation[i] - pose_other->translation[i];
      for (int k = 0; k < 3; k++) {
        away[i] += pose->rotation[i][k] * v[k];
      }
    }
    for (int i = 0; i < 3; i++) {
      double x = 0;
      for (int k = 0; k < 3; k++) {
        x += pose_other->rotation[k][i] * away[k];
      }
      is_in = is_in && x > low[i] + margin && x < high[i] - margin;
      may_be = may_be && x > low[i] - margin && x < high[i] + margin;
    }
    in += is_in;
    perhaps += may_be;
  }
  assert_true(expected == ORACLE_INSIDE || within != SEPAX_INSIDE);
  if (in == 3 * m->count) {
    assert_int_equal(within, SEPAX_INSIDE_UNKNOWN);
  }
  if (perhaps == 0) {
    assert_answer(within, expected);
  }
}

#endif
