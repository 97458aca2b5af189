/* SPDX-License-Identifier: MIT */
#include "real_pairs.h"

#include "distance.h"
#include "geometry.h"
#include "pair_tools.h"

#include <math.h>

/* A of the near vertices, B of them: 1 a vertex, 2 an edge, 3 the face. */
static const struct {
  const char *name;
  int a, b;
} kinds[REAL_KINDS] = {{"vertex-vertex", 1, 1}, {"vertex-edge", 1, 2}, {"vertex-face", 1, 3},
                       {"edge-vertex", 2, 1},   {"edge-edge", 2, 2},   {"edge-face", 2, 3},
                       {"face-vertex", 3, 1},   {"face-edge", 3, 2},   {"face-face", 3, 3},
                       {"local", 0, 0},         {"family", 0, 0},      {"flat", 2, 2}};

enum { LOCAL = 9, FAMILY = 10, FLAT = 11 };

const char *real_kind_name(int kind) { return kinds[kind].name; }

double uniform(sepax_random *r, double low, double high) {
  return low + (high - low) * 0x1p-53 * (double)(sepax_random_next(r) >> 11);
}

static int64_t range(sepax_random *r, int64_t low, int64_t high) {
  return sepax_random_range(r, low, high);
}

static point scaled(point p) { return along((point){{0, 0, 0}}, 1 / sqrt(inner(p, p)), p); }

static point anywhere(sepax_random *r, double size) {
  return (point){{uniform(r, -size, size), uniform(r, -size, size), uniform(r, -size, size)}};
}

/* A direction: any, or along an axis or a diagonal of the grid, or almost so. */
static point direction(sepax_random *r) {
  point n = anywhere(r, 1);
  int64_t how = range(r, 0, 7);
  if (how < 3) {
    int64_t keep = range(r, 1, 7);
    for (int i = 0; i < 3; i++) {
      double noise = how == 0 ? 0 : how == 1 ? 0x1p-12 * n.c[i] : 0.05 * n.c[i];
      n.c[i] = ((keep >> i & 1) != 0 ? (n.c[i] < 0 ? -1 : 1) : 0) + noise;
    }
  }
  return inner(n, n) > 0 ? scaled(n) : (point){{1, 0, 0}};
}

/* A triangle below the plane through the origin with normal n; its first `on` vertices are on
 * it, and so is their mean, or another point between them, the origin. */
static void hang(sepax_random *r, point n, int on, double size, point t[3]) {
  double weight[3];
  double total = 0;
  point touch = {{0, 0, 0}};
  double flat = range(r, 0, 3) == 0 ? size * 0x1p-8 : size;
  double thin = range(r, 0, 3) == 0 ? 0x1p-7 : 1;
  point first = anywhere(r, size);
  for (int k = 0; k < 3; k++) {
    point any = along(first, thin, anywhere(r, size));
    double depth = k < on ? 0 : uniform(r, 0, flat);
    t[k] = along(any, -inner(any, n) - depth, n);
    weight[k] = k < on ? uniform(r, range(r, 0, 3) == 0 ? 0 : 0.05, 1) : 0;
    total += weight[k];
  }
  for (int k = 0; k < on && k < 3; k++) {
    touch = along(touch, weight[k] / total, t[k]);
  }
  for (int k = 0; k < 3; k++) {
    t[k] = along(t[k], -1, touch);
  }
}

static sepax_tri fine_tri(const point t[3], point at, int fraction) {
  sepax_tri tri;
  for (int i = 0; i < 9; i++) {
    double c = t[i / 3].c[i % 3] + at.c[i % 3];
    *coordinate(&tri.v[i / 3], i % 3) = (int32_t)llround(ldexp(c, fraction));
  }
  return tri;
}

/* Half away from zero, as the quantiser does. */
static int32_t nearest(int32_t x, int fraction) {
  int64_t half = INT64_C(1) << (fraction - 1);
  int64_t size = ((x < 0 ? -(int64_t)x : x) + half) >> fraction;
  return (int32_t)(x < 0 ? -size : size);
}

static sepax_tri rounded(sepax_tri t, int fraction) {
  for (int i = 0; i < 9; i++) {
    int32_t *c = coordinate(&t.v[i / 3], i % 3);
    *c = nearest(*c, fraction);
  }
  return t;
}

/* Each coordinate to where rounding moves it as far as can be against `sign`. */
static void worst(sepax_tri *t, point n, double sign, int fraction) {
  for (int i = 0; i < 9; i++) {
    int32_t *c = coordinate(&t->v[i / 3], i % 3);
    int32_t half = (1 << (fraction - 1)) - 1;
    int32_t grid = (int32_t)((uint32_t)nearest(*c, fraction) << fraction);
    *c = grid + (n.c[i % 3] * sign > 0 ? half : -half);
  }
}

/* Two whole-numbered triangles of a hard family, with fractions, one drawn towards the other
 * along the way between their nearest points; that leaves exactly the way that is left. */
static void draw_near(real_pair *p, double distance, sepax_random *r) {
  int word = (int)range(r, 4, 28 - p->fraction);
  size_t family = (size_t)range(r, 0, (int64_t)family_count() - 1);
  sepax_pair whole = sepax_family_triangles(family, word, r);
  bool noise = range(r, 0, 3) != 0;
  for (int i = 0; i < COORDINATES; i++) {
    int32_t *c = field(&whole, i);
    int64_t half = noise ? INT64_C(1) << (p->fraction - 1) : 0;
    *c = (int32_t)(*c * (INT64_C(1) << p->fraction) + range(r, -half, half));
  }
  p->a = whole.a;
  p->b = whole.b;
  double way[3];
  double away = ldexp(distance_rounded(&p->a, &p->b, way), -p->fraction);
  if (away > distance && !distance_within(&p->a, &p->b, 0, NULL)) {
    for (int i = 0; i < 9; i++) {
      *coordinate(&p->b.v[i / 3], i % 3) += (int32_t)llround(way[i % 3] * (distance / away - 1));
    }
  }
}

static void hang_both(real_pair *p, int kind, double distance, sepax_random *r) {
  int bits = 26 - p->fraction;
  double size = ldexp(uniform(r, 0.5, 1), (int)range(r, 1, bits));
  double other = range(r, 0, 1) != 0 ? size : ldexp(uniform(r, 0.5, 1), (int)range(r, 1, bits));
  point n = direction(r);
  int flat = kind == FLAT ? (int)range(r, 0, 2) : 3;
  if (flat < 3) { /* both in a plane of the grid */
    n.c[flat] = 0;
    n = inner(n, n) > 0 ? scaled(n) : (point){{flat != 0, flat == 0, 0}};
  }
  int on_a = kind == LOCAL ? (int)range(r, 1, 3) : kinds[kind].a;
  int on_b = kind == LOCAL ? (int)range(r, 1, 4 - on_a) : kinds[kind].b;
  point t[2][3];
  hang(r, n, on_a, size, t[0]);
  hang(r, along((point){{0, 0, 0}}, -1, n), on_b, other, t[1]);
  point at = anywhere(r, 2 * ldexp(1, bits));
  for (int i = 0; i < 6 && flat < 3; i++) {
    t[i / 3][i % 3].c[flat] = 0;
  }
  p->a = fine_tri(t[0], at, p->fraction);
  p->b = fine_tri(t[1], along(at, distance, n), p->fraction);
  if (range(r, 0, 2) == 0) {
    worst(&p->a, n, 1, p->fraction);
    worst(&p->b, n, -1, p->fraction);
  }
}

real_pair real_pair_make(int kind, double distance, sepax_random *random) {
  real_pair p = {.kind = kind, .fraction = (int)range(random, 10, 20)};
  if (kind == FAMILY) {
    draw_near(&p, distance, random);
  } else {
    hang_both(&p, kind, distance, random);
  }
  if (range(random, 0, 1) != 0) {
    sepax_tri kept = p.a;
    p.a = p.b;
    p.b = kept;
  }
  p.rounded_a = rounded(p.a, p.fraction);
  p.rounded_b = rounded(p.b, p.fraction);
  return p;
}
