/* SPDX-License-Identifier: MIT */
/* turned.c - meshes of solids of revolution contain the true solid, or are contained by it, and
 * are near to it: dense samples against an oracle in long double. */
#include "harness.h"
#include "turned_oracle.h"

#include <string.h>

/* What is wrong with a mesh, or NULL. */
static const char *wrong;

typedef struct {
  oracle solid, ended; /* `solid` is what is shrunk; `ended` is the profile as given */
  const revolve_how *how;
  real slack; /* rounding of the oracle */
} judge;

static judge judge_of(const turned_profile *p, const revolve_how *how) {
  return (judge){oracle_of(p, how->keep_top ? how->shrink : 0), oracle_of(p, 0), how, 1e-11L};
}

static const char *look_at(const judge *j, const sepax_facet *f, bool outer) {
  enum { PARTS = 4 };
  for (int a = 0; a <= PARTS; a++) {
    for (int b = 0; a + b <= PARTS; b++) {
      real v[3];
      for (int i = 0; i < 3; i++) {
        v[i] = (a * (real)f->v[0][i] + b * (real)f->v[1][i] + (PARTS - a - b) * (real)f->v[2][i]) /
               PARTS;
      }
      real depth = oracle_depth(&j->solid, v[2], hypotl(v[0], v[1])) - j->how->shrink;
      if (outer ? depth > -j->slack : depth < j->slack) {
        return outer ? "the outer mesh cuts the solid" : "the inner mesh leaves the solid";
      }
      if (outer && depth < -(real)j->how->gap && j->how->shrink == 0) {
        return "the outer mesh is too far from the solid";
      }
    }
  }
  return NULL;
}

/* Edges and facets around and along. Of a solid with thousands of triangles some sectors. */
static const char *look_at_all(const judge *j, const sepax_soup *s, bool outer) {
  size_t step = s->count / 1000 + 1;
  for (size_t n = 0; n < s->count; n += step) {
    const char *found = look_at(j, &s->facet[n], outer);
    if (found != NULL) {
      return found;
    }
  }
  return NULL;
}

/* How often the surface winds around p: the signed crossings of a ray. */
static int windings(const sepax_soup *s, const real p[3]) {
  static const real ray[3] = {0.267891L, 0.534127L, 0.801823L};
  int sum = 0;
  for (size_t n = 0; n < s->count; n++) {
    real m[3][3];
    for (int k = 0; k < 9; k++) {
      m[k / 3][k % 3] = (real)s->facet[n].v[k / 3][k % 3] - p[k % 3];
    }
    real side[3];
    for (int k = 0; k < 3; k++) {
      const real *a = m[k];
      const real *b = m[(k + 1) % 3];
      side[k] = ray[0] * (a[1] * b[2] - a[2] * b[1]) + ray[1] * (a[2] * b[0] - a[0] * b[2]) +
                ray[2] * (a[0] * b[1] - a[1] * b[0]);
    }
    bool positive = side[0] > 0 && side[1] > 0 && side[2] > 0;
    bool negative = side[0] < 0 && side[1] < 0 && side[2] < 0;
    real volume = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) +
                  m[0][1] * (m[1][2] * m[2][0] - m[1][0] * m[2][2]) +
                  m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    sum += positive && volume > 0 ? 1 : negative && volume < 0 ? -1 : 0;
  }
  return sum;
}

/* Points of the solid's boundary, some of them moved inwards or outwards. */
static void draw_point(const judge *j, real p[3], real *z, real *r) {
  const oracle_edge *e = &j->solid.edge[random_below((int)j->solid.edges)];
  real t = (real)(random_unit() + 1) / 2;
  *z = e->z[0] + t * (e->z[1] - e->z[0]);
  *r = e->r[0] < e->r[1] || e->radius == 0 || e->z[0] == e->z[1] ? e->r[0] + t * (e->r[1] - e->r[0])
                                                                 : oracle_radius(e, *z);
  if (e->radius > 0) {
    *r = oracle_radius(e, *z);
  }
  real reach = random_below(2) == 0 ? 2e-6L : (real)j->how->shrink + (real)j->how->gap;
  *z += reach * (real)random_unit();
  *r = fabsl(*r + reach * (real)random_unit());
  real angle = 3.2L * (real)random_unit();
  p[0] = *r * cosl(angle);
  p[1] = *r * sinl(angle);
  p[2] = *z;
}

static const char *wind_around(const judge *j, const sepax_soup *outer, const sepax_soup *inner,
                               int count) {
  const int triangles = 100000; /* to look at, about */
  count = outer->count > 0 ? (int)fmin(count, 1 + triangles / (double)outer->count) : count;
  for (int n = 0; n < count; n++) {
    real p[3];
    real z;
    real r;
    draw_point(j, p, &z, &r);
    real depth = oracle_depth(&j->solid, z, r) - j->how->shrink;
    const int times[2] = {windings(outer, p), windings(inner, p)};
    if (times[0] < 0 || times[0] > 1 || times[1] < 0 || times[1] > 1) {
      return "a mesh winds around a point more than once";
    }
    if (depth >= 0 && times[0] != 1) {
      return "a point of the solid is not in the outer mesh";
    }
    if (depth < 0 && times[1] != 0) {
      return "a point outside of the solid is in the inner mesh";
    }
  }
  return NULL;
}

static bool is_closed(const sepax_soup *s) {
  sepax_body *body;
  sepax_shell shell;
  assert_works(sepax_body_new(&body, SEPAX_SOUP_MESH(s), NULL, &fault));
  assert_works(sepax_shell_find(&shell, body, &fault));
  bool closed = shell.closed && shell.consistent;
  sepax_shell_free(&shell);
  sepax_body_free(body);
  for (size_t n = 0; n < s->count && closed; n++) {
    const double(*v)[3] = s->facet[n].v;
    real square = 0;
    for (int i = 0; i < 3; i++) {
      int k = (i + 1) % 3;
      real c = ((real)v[1][i] - v[0][i]) * ((real)v[2][k] - v[0][k]) -
               ((real)v[1][k] - v[0][k]) * ((real)v[2][i] - v[0][i]);
      square += c * c;
    }
    closed = square > 0;
  }
  return closed;
}

static bool agree(const turned_profile *p, const revolve_how *how, const sepax_soup *outer,
                  const sepax_soup *inner, int points) {
  judge j = judge_of(p, how);
  wrong = look_at_all(&j, outer, true);
  wrong = wrong != NULL ? wrong : look_at_all(&j, inner, false);
  wrong = wrong != NULL ? wrong : wind_around(&j, outer, inner, points);
  return wrong == NULL;
}

static void check(turned_point *point, size_t points, double gap, double shrink, bool keep_top) {
  turned_profile p = {point, points};
  revolve_how how = {gap, shrink, keep_top};
  sepax_soup outer;
  sepax_soup inner;
  assert_works(sepax__revolve(&outer, &inner, &p, &how, &fault));
  assert_true(outer.count > 0 && is_closed(&outer));
  assert_true(inner.count > 0 && is_closed(&inner));
  if (!agree(&p, &how, &outer, &inner, FEWER(200))) {
    fail_msg("gap %g, shrunk by %g: %s", gap, shrink, wrong);
  }
  sepax_soup_free(&outer);
  sepax_soup_free(&inner);
}

#define SHAPE(name, ...) static turned_point name[] = {__VA_ARGS__}
SHAPE(flat, {0, 5, 0}, {25, 5, 0});
SHAPE(ball, {0, 0, 0}, {5, 5, 5}, {25, 5, 0});
SHAPE(bull, {0, 4, 0}, {1, 5, 1}, {25, 5, 0});
SHAPE(drill, {0, 0, 0}, {1.5, 5, 0}, {60, 5, 0});
SHAPE(slotter, {0, 12, 0}, {5, 12, 0}, {5, 5, 0}, {20, 5, 0}, {20, 6, 0}, {60, 6, 0});
SHAPE(groove, {0, 12, 0}, {5, 8, 0}, {10, 12, 0});
SHAPE(probe, {0, 0, 0}, {3, 3, 3}, {6, 0, 3});
SHAPE(barrel, {0, 3, 0}, {20, 5, 85}, {40, 5, 0});
SHAPE(waist, {0, 9, 0}, {4, 5, -5}, {30, 5, 0}, {34, 9, -5});
SHAPE(engraver, {-1, 0.05, 0}, {9, 1, 0}, {39, 1, 0});
SHAPE(holder, {30, 14, 0}, {55, 16, 0}, {75, 32, 0}, {92, 32, 0});
static const struct {
  turned_point *point;
  size_t points;
} shapes[] = {{flat, LENGTH(flat)},         {ball, LENGTH(ball)},       {bull, LENGTH(bull)},
              {drill, LENGTH(drill)},       {slotter, LENGTH(slotter)}, {groove, LENGTH(groove)},
              {probe, LENGTH(probe)},       {barrel, LENGTH(barrel)},   {waist, LENGTH(waist)},
              {engraver, LENGTH(engraver)}, {holder, LENGTH(holder)}};

CASE(test_shapes) {
  for (size_t n = 0; n < LENGTH(shapes); n++) {
    check(shapes[n].point, shapes[n].points, 0.005, 0, false);
    check(shapes[n].point, shapes[n].points, 0.1, 0, false);
    check(shapes[n].point, shapes[n].points, 0.005, 0.01, false);
    check(shapes[n].point, shapes[n].points, 0.005, 0.01, true);
    check(shapes[n].point, shapes[n].points, 0.02, 0.3, false);
  }
}

CASE(test_fine) {
  for (size_t n = 0; n < LENGTH(shapes); n += STEP) {
    if (shapes[n].point != waist) {
      check(shapes[n].point, shapes[n].points, 0.001, 0, false);
    }
  }
}

/* Coarse tangents of a hollow arc cross the axis. */
CASE(test_hollow_at_axis) {
  static turned_point point[] = {
      {0, 0.15, 0}, {0.123, 0.17, -0.0665}, {0.2, 0.04, 0}, {0.38, 0.12, -0.11}, {0.7, 0.12, 0}};
  check(point, LENGTH(point), 0.15, 0, false);
  check(point, LENGTH(point), 0.01, 0, false);
}

/* No point of the solid is farther than the gap from the inner mesh. */
CASE(test_inner_gap) {
  turned_profile p = {bull, LENGTH(bull)};
  revolve_how how = {0.005, 0, false};
  judge j = judge_of(&p, &how);
  sepax_soup inner;
  sepax_body *body;
  assert_works(sepax__revolve(NULL, &inner, &p, &how, &fault));
  assert_works(sepax_body_new(&body, SEPAX_SOUP_MESH(&inner), NULL, &fault));
  for (int n = 0; n < FEWER(2000); n++) {
    real at[3];
    real z;
    real r;
    double v[3][3];
    draw_point(&j, at, &z, &r);
    for (int k = 0; k < 9; k++) {
      v[k / 3][k % 3] = (double)at[k % 3];
    }
    sepax_body *point;
    sepax_distance_result found;
    assert_works(sepax_body_new(&point, &SEPAX_STRUCT(sepax_mesh, .vertex = v, .triangles = 1),
                                NULL, &fault));
    assert_works(sepax_bodies_distance(body, NULL, point, NULL, NULL, &found, &fault));
    assert_true(oracle_depth(&j.solid, z, r) < 0 || found.min_distance <= how.gap ||
                windings(&inner, at) == 1);
    sepax_body_free(point);
  }
  sepax_body_free(body);
  sepax_soup_free(&inner);
}

/* -------------------------------------------------------------------- random */

/* Lines, steps and arcs of any radius that is legal; 0 where the profile is not. */
static size_t draw_profile(turned_point *point) {
  size_t points = 2 + (size_t)random_below(6);
  double z = 10 * random_unit();
  double scale = pow(10, 1.5 * random_unit());
  for (size_t n = 0; n < points; n++) {
    double before = z;
    z += n > 0 && random_below(3) > 0 ? scale * fabs(random_unit()) : 0;
    double r = random_below(8) == 0 ? 0 : scale * fabs(random_unit());
    double bend = 0;
    if (n > 0 && random_below(2) == 0) {
      double chord = hypot(z - before, r - point[n - 1].r);
      bend = chord / 2 * (1 + fabs(random_unit()) * pow(10, 2 * random_unit()));
      bend *= random_below(3) == 0 ? -1 : 1;
    }
    point[n] = (turned_point){z, r, bend};
  }
  turned_profile p = {point, points};
  return sepax__turned_check(&p, NULL) ? points : 0;
}

static void print_profile(const turned_profile *p, const revolve_how *how) {
  for (size_t n = 0; n < p->points; n++) {
    printf("{%.17g, %.17g, %.17g}, ", p->point[n].z, p->point[n].r, p->point[n].bend);
  }
  printf("gap %.17g, shrunk by %.17g, %d\n", how->gap, how->shrink, (int)how->keep_top);
}

/* An outer mesh alone needs no inner one, however thin the solid is, unless it is shrunk. */
static void check_outer(const turned_profile *p, const revolve_how *how) {
  judge j = judge_of(p, how);
  sepax_soup outer;
  assert_works(sepax__revolve(&outer, NULL, p, how, &fault));
  assert_true(is_closed(&outer));
  wrong = look_at_all(&j, &outer, true);
  if (wrong != NULL) {
    print_profile(p, how);
    fail_msg("%s", wrong);
  }
  sepax_soup_free(&outer);
}

static void check_drawn(turned_point *point, size_t points, int *proved) {
  double gap = 0.01 * pow(10, 1.3 * random_unit());
  revolve_how how = {gap, random_below(2) == 0 ? 0 : 10 * gap * fabs(random_unit()) + 1e-5,
                     random_below(2) == 0};
  turned_profile p = {point, points};
  sepax_soup outer;
  sepax_soup inner;
  if (!sepax__revolve(&outer, &inner, &p, &how, &fault)) {
    assert_int_equal(fault.code, SEPAX_ERROR_LIMIT);
    if (strstr(fault.text, "too thin") == NULL && strstr(fault.text, "too many") == NULL) {
      print_profile(&p, &how);
      fail_msg("%s", fault.text);
    }
    assert_true(outer.facet == NULL && inner.facet == NULL);
    if (how.shrink == 0) {
      check_outer(&p, &how);
    }
    return;
  }
  *proved += 1;
  assert_true(outer.count == 0 || is_closed(&outer));
  assert_true(inner.count == 0 || is_closed(&inner));
  if (!agree(&p, &how, &outer, &inner, FEWER(20))) {
    print_profile(&p, &how);
    fail_msg("%s", wrong);
  }
  sepax_soup_free(&outer);
  sepax_soup_free(&inner);
}

CASE(test_random) {
  int drawn = 0;
  int proved = 0;
  while (drawn < FEWER(200)) {
    turned_point point[8];
    size_t points = draw_profile(point);
    if (points > 0) {
      check_drawn(point, points, &proved);
      drawn++;
    }
  }
  printf("%d of %d profiles proved\n", proved, drawn);
  assert_true(10 * proved >= 8 * drawn);
}

/* A flange that ends in an edge without an angle, and a plate. */
CASE(test_outer_alone) {
  turned_point flange[] = {{0, 10, 0}, {5, 5, -5}, {40, 5, 0}, {45, 10, -5}, {50, 10, 0}};
  turned_point plate[] = {{0, 5, 0}, {1e-7, 5, 0}};
  const revolve_how how = {0.005, 0, false};
  check_outer(&(turned_profile){flange, LENGTH(flange)}, &how);
  check_outer(&(turned_profile){plate, LENGTH(plate)}, &how);
}

/* ------------------------------------------------------------- planted faults */

static void scale_soup(sepax_soup *s, double across, double along) {
  for (size_t n = 0; n < 9 * s->count; n++) {
    s->facet[n / 9].v[n % 9 / 3][n % 3] *= n % 3 == 2 ? 1 : across;
    s->facet[n / 9].v[n % 9 / 3][n % 3] += n % 3 == 2 ? along : 0;
  }
}

static void plant(double across, double along, bool outer, const char *expected) {
  turned_profile p = {bull, LENGTH(bull)};
  revolve_how how = {0.005, 0, false};
  sepax_soup mesh[2];
  assert_works(sepax__revolve(&mesh[0], &mesh[1], &p, &how, &fault));
  scale_soup(&mesh[outer ? 0 : 1], across, along);
  assert_false(agree(&p, &how, &mesh[0], &mesh[1], 200));
  assert_string_equal(wrong, expected);
  sepax_soup_free(&mesh[0]);
  sepax_soup_free(&mesh[1]);
}

/* The judge of this file sees a polygon that is a little too small or too large, or moved. */
CASE(test_planted) {
  plant(1 - 1e-5, 0, true, "the outer mesh cuts the solid");
  plant(1, 3e-5, true, "the outer mesh cuts the solid");
  plant(1, -3e-5, true, "the outer mesh cuts the solid");
  plant(1.001, 0, true, "the outer mesh is too far from the solid");
  plant(1 + 1e-5, 0, false, "the inner mesh leaves the solid");
  plant(1, 3e-5, false, "the inner mesh leaves the solid");
}
