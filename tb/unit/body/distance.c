/* SPDX-License-Identifier: MIT */
/* distance.c - distances of posed triangles and bodies against rational arithmetic. SEPAX_COUNT: so
 * many pairs of triangles. */
#include "harness.h"
#include "oracle/distance.h"
#include "oracle/oracle.h"
#include "unit/body/draws.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef double points[3][3];

/* A rotation, exact but for rounding or, of two in three, shorter or longer by 4.5e-7. */
static sepax_pose random_pose(double away) {
  sepax_pose p = turned_and_moved(away);
  double length = 1 + 4.5e-7 * (random_below(3) - 1);
  for (int k = 0; k < 9; k++) {
    p.rotation[k / 3][k % 3] *= length;
  }
  return p;
}

static double largest(const points t, const sepax_pose *p) {
  double most = 0;
  for (int k = 0; k < 9; k++) {
    most = fmax(most, fabs(t[k / 3][k % 3]));
    most = p != NULL ? fmax(most, fabs(p->translation[k / 3])) : most;
  }
  return most;
}

/* The points lie on the triangles and are as far from each other as they should. */
static void assert_points(const points a, const sepax_pose *pa, const points b,
                          const sepax_pose *pb, double distance, const double nearest[2][3]) {
  double error = 0x1p-50 * fmax(largest(a, pa), largest(b, pb)) + 0x1p-1070;
  points at[2];
  for (int k = 0; k < 9; k++) {
    at[0][k / 3][k % 3] = nearest[0][k % 3];
    at[1][k / 3][k % 3] = nearest[1][k % 3];
  }
  assert_true(distance_within_posed(at[0], NULL, a, pa, error));
  assert_true(distance_within_posed(at[1], NULL, b, pb, error));
  assert_true(distance_within_posed(at[0], NULL, at[1], NULL, stepped(distance, 1) + 2 * error));
}

static size_t zeros;

/* Right to one unit in the last place. */
static double assert_distance(const points a, const sepax_pose *pa, const points b,
                              const sepax_pose *pb) {
  double nearest[2][3];
  double r = sepax_distance_posed(a, pa, b, pb, nearest);
  bool right = r == 0 ? oracle_collide_posed(a, pa, b, pb)
                      : distance_within_posed(a, pa, b, pb, stepped(r, 1)) &&
                            !distance_within_posed(a, pa, b, pb, stepped(r, -1));
  if (!right) {
    fail_msg("A_0 = %a %a %a, B_0 = %a %a %a: the distance is not %a", a[0][0], a[0][1], a[0][2],
             b[0][0], b[0][1], b[0][2], r);
  }
  zeros += r == 0;
  if (random_below(8) == 0) {
    assert_points(a, pa, b, pb, r, (const double(*)[3])nearest);
  }
  return r;
}

/* A hard pair of some word length as doubles. */
static void draw_family(points t[2], size_t n, double scale) {
  static sepax_random random = {3};
  sepax_pair pair = mixed_pair(n, 4 + random_below(29), &random);
  for (int k = 0; k < 18; k++) {
    const sepax_vec *v = &(k < 9 ? &pair.a : &pair.b)->v[k / 3 % 3];
    t[k / 9][k / 3 % 3][k % 3] = scale * (k % 3 == 0 ? v->x : k % 3 == 1 ? v->y : v->z);
  }
}

static void draw_strewn(points t[2], double scale) {
  for (int k = 0; k < 18; k++) {
    t[k / 9][k / 3 % 3][k % 3] = scale * random_unit();
  }
}

/* B is A, or A's plane, moved a little: parallel faces and edges. */
static void draw_parallel(points t[2], double scale) {
  double way[3];
  draw_strewn(t, scale);
  for (int i = 0; i < 3; i++) {
    way[i] = ldexp(random_unit(), -random_below(50)) * scale;
  }
  for (int k = 0; k < 3; k++) {
    double s = random_below(2) == 0 ? 0 : random_unit();
    for (int i = 0; i < 3; i++) {
      t[1][k][i] = t[0][k][i] + s * (t[0][(k + 1) % 3][i] - t[0][k][i]) + way[i];
    }
  }
}

/* Slivers, segments and points: a vertex is another, or near the line of the others. */
static void draw_sliver(points t[2], double scale) {
  draw_strewn(t, scale);
  for (int n = 0; n < 2; n++) {
    double s = random_below(3) == 0 ? random_below(2) : random_unit();
    double off = random_below(3) == 0 ? 0 : ldexp(scale, -random_below(60));
    for (int i = 0; i < 3; i++) {
      t[n][2][i] = t[n][0][i] + s * (t[n][1][i] - t[n][0][i]) + off * random_unit();
      t[n][1][i] = random_below(9) == 0 ? t[n][0][i] : t[n][1][i];
    }
  }
}

/* Coordinates of very different sizes, from the smallest that there are. */
static void draw_wide(points t[2], size_t n) {
  for (int k = 0; k < 18; k++) {
    int exponent = n % 3 == 0   ? random_below(2070) - 1074
                   : n % 3 == 1 ? -1074 + random_below(60)
                                : 940 + random_below(60);
    double few = random_below(5) - 2;
    t[k / 9][k / 3 % 3][k % 3] = ldexp(n % 2 == 0 ? few : random_unit(), exponent);
  }
}

/* A vertex of B comes next to a point of A. */
static void draw_near(points t[2], double scale) {
  double weight[3] = {0, 0, 0};
  double way[3];
  draw_strewn(t, scale);
  weight[0] = random_below(3) == 0 ? random_below(2) : fabs(random_unit());
  weight[1] = random_below(2) == 0 ? 1 - weight[0] : (1 - weight[0]) * fabs(random_unit());
  weight[2] = 1 - weight[0] - weight[1];
  double off = ldexp(scale, -random_below(70));
  for (int i = 0; i < 3; i++) {
    double at = weight[0] * t[0][0][i] + weight[1] * t[0][1][i] + weight[2] * t[0][2][i];
    way[i] = at + off * random_unit() - t[1][0][i];
  }
  for (int k = 0; k < 9; k++) {
    t[1][k / 3][k % 3] += way[k % 3];
  }
}

static void draw_pair(points t[2], size_t n, double scale) {
  switch (n % 6) {
  case 0:
    draw_strewn(t, scale);
    break;
  case 1:
    draw_parallel(t, scale);
    break;
  case 2:
    draw_sliver(t, scale);
    break;
  case 3:
    draw_near(t, scale);
    break;
  case 4:
    draw_wide(t, n / 6);
    break;
  default:
    draw_family(t, n / 6, scale);
    break;
  }
}

CASE(distances_of_triangles) {
  const char *given = getenv("SEPAX_COUNT");
  size_t count = given != NULL ? (size_t)strtoul(given, NULL, 10) : 12000;
  zeros = 0;
  for (size_t n = 0; n < count; n++) {
    double scale = ldexp(1, random_below(60) - 30) * (random_below(2) == 0 ? 1 : 0.1);
    points t[2];
    draw_pair(t, n, scale);
    sepax_pose p = random_pose(random_below(2) == 0 ? scale : 1);
    sepax_pose q = random_pose(scale);
    switch (random_below(4)) {
    case 0:
      assert_distance(t[0], NULL, t[1], NULL);
      break;
    case 1:
      assert_distance(t[0], &p, t[1], &p);
      break;
    case 2:
      assert_distance(t[0], NULL, t[1], &p);
      break;
    default:
      assert_distance(t[0], &q, t[1], &p);
      break;
    }
  }
  assert_true(zeros > count / 50 && zeros < count / 2);
}

/* Known distances, each with A and B exchanged. */
CASE(known_distances) {
  static const struct {
    points a, b;
    double distance;
  } known[] = {
      {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 3}, {1, 0, 3}, {0, 1, 3}}, 3},
      {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{3, 4, 0}, {3, 4, 0}, {3, 4, 0}}, 0x1.2d552e7a5c1dp+2},
      {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {{3, 4, 0}, {3, 4, 0}, {3, 4, 0}}, 5},
      {{{-1, 0, 0}, {1, 0, 0}, {0, -9, 0}}, {{0, -1, 2}, {0, 1, 2}, {0, 0, 9}}, 2},
      {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{1, 1, -1}, {1, 1, 1}, {9, 9, 9}}, 0},
      {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{1, 1, 0x1p-1074}, {1, 1, 1}, {9, 9, 9}}, 0x1p-1074},
      {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}, 0x1.6a09e667f3bcdp-1},
      {{{0x1p1000, 0, 0}, {0x1p1000, 1, 0}, {0x1p1000, 0, 1}},
       {{-0x1p1000, 0, 0}, {-0x1p1000, 1, 0}, {-0x1p1000, 0, 1}},
       0x1p1001},
  };
  for (size_t n = 0; n < LENGTH(known); n++) {
    double d = assert_distance(known[n].a, NULL, known[n].b, NULL);
    double e = assert_distance(known[n].b, NULL, known[n].a, NULL);
    assert_true(d == known[n].distance || n == 1);
    assert_true(d == e);
  }
}

/* 2^-1100 from each other: more than a collision, less than a double. */
CASE(less_than_a_double) {
  points a = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  points b = {{0, 0, 0x1p-550}, {1, 0, 0x1p-550}, {0, 1, 0x1p-550}};
  sepax_pose p = turned(1, 0, 0, 0);
  p.rotation[2][2] = 0x1p-550;
  assert_true(sepax_distance_posed(a, NULL, b, &p, NULL) == 0x1p-1074);
}

/* ------------------------------------------------------------------------ bodies */

typedef struct {
  sepax_soup mesh[2];
  sepax_body *body[2];
  const sepax_pose *pose[2];
} scene;

static void make_bodies(scene *s) {
  for (int k = 0; k < 2; k++) {
    assert_works(sepax_body_new(&s->body[k], SEPAX_SOUP_MESH(&s->mesh[k]), NULL, &fault));
  }
}

static void free_scene(scene *s) {
  for (int k = 0; k < 2; k++) {
    sepax_body_free(s->body[k]);
    sepax_soup_free(&s->mesh[k]);
  }
}

static double distance_of_pair(const scene *s, size_t i, size_t j) {
  return sepax_distance_posed(s->mesh[0].facet[i].v, s->pose[0], s->mesh[1].facet[j].v, s->pose[1],
                              NULL);
}

static sepax_distance_result find_distance(const scene *s, double limit, sepax_simd simd_taken) {
  sepax_distance_request request = {
      .size = sizeof(sepax_distance_request), .limit = limit, .simd = simd_taken};
  sepax_distance_result r;
  assert_works(
      sepax_bodies_distance(s->body[0], s->pose[0], s->body[1], s->pose[1], &request, &r, &fault));
  return r;
}

/* The search begins with what is nearest here, or in other poses. */
static void assert_last(const scene *s, const sepax_distance_result *expected) {
  sepax_distance_result last = *expected;
  sepax_distance_result r;
  for (int n = 0; n < 3; n++) {
    sepax_pose p = random_pose(3);
    scene moved = *s;
    moved.pose[1] = &p;
    sepax_distance_request request = {.size = sizeof(sepax_distance_request), .last = &last};
    assert_works(sepax_bodies_distance(s->body[0], s->pose[0], s->body[1], s->pose[1], &request, &r,
                                       &fault));
    assert_true(r.min_distance >= stepped(expected->min_distance, -1));
    assert_true(r.min_distance <= stepped(expected->min_distance, 1));
    last = find_distance(&moved, 0, SEPAX_SIMD_BEST);
  }
}

/* The least distance of all pairs, one by one; and by the search, with limits. */
static double assert_least(const scene *s, sepax_simd simd_taken) {
  double least = INFINITY;
  for (size_t i = 0; i < s->mesh[0].count; i++) {
    for (size_t j = 0; j < s->mesh[1].count; j++) {
      least = fmin(least, distance_of_pair(s, i, j));
    }
  }
  sepax_distance_result r = find_distance(s, 0, simd_taken);
  if (!(r.min_distance >= least && r.min_distance <= stepped(least, 1))) {
    fail_msg("the distance of the bodies is %a, not %a", least, r.min_distance);
  }
  assert_true(distance_of_pair(s, r.pair[0], r.pair[1]) == r.min_distance);
  if (least > 0) {
    assert_true(find_distance(s, stepped(least, 2), simd_taken).min_distance <= stepped(least, 1));
    assert_true(isinf(find_distance(s, stepped(least, -2), simd_taken).min_distance));
    assert_last(s, &r);
  }
  return least;
}

static void assert_near(const scene *s, double distance, const sepax_query *query) {
  const size_t count[2] = {s->mesh[0].count, s->mesh[1].count};
  bool *near = calloc(count[0] * count[1] + 1, 1);
  sepax_pairs found;
  size_t expected = 0;
  assert_non_null(near);
  assert_works(sepax_bodies_near(s->body[0], s->pose[0], s->body[1], s->pose[1], distance, query,
                                 &found, &fault));
  for (size_t n = 0; n < found.count; n++) {
    bool *one = &near[found.pair[n][0] * count[1] + found.pair[n][1]];
    assert_false(*one);
    *one = true;
  }
  for (size_t n = 0; n < count[0] * count[1]; n++) {
    size_t i = n / count[1];
    size_t j = n % count[1];
    double d = distance_of_pair(s, i, j);
    bool is_within = d < distance;
    if (d >= stepped(distance, -1) && d <= stepped(distance, 1) && d > 0) {
      is_within = distance_within_posed(s->mesh[0].facet[i].v, s->pose[0], s->mesh[1].facet[j].v,
                                        s->pose[1], distance);
      is_within = is_within && !(query->strict && d == distance);
    }
    assert_int_equal(near[n], is_within || (distance == 0 && d == 0));
    expected += near[n];
  }
  for (size_t most = 1; most <= 2; most++) {
    sepax_query few = *query;
    few.most = most;
    few.only_any = most == 2;
    sepax_pairs_free(&found);
    assert_works(sepax_bodies_near(s->body[0], s->pose[0], s->body[1], s->pose[1], distance, &few,
                                   &found, &fault));
    assert_int_equal(found.count, expected > 0);
    assert_true(found.ended == (expected > 0) && (found.pair == NULL || !few.only_any));
  }
  sepax_pairs_free(&found);
  free(near);
}

CASE(distances_of_bodies) {
  size_t separated = 0;
  for (int n = 0; n < 40; n++) {
    sepax_pose p[2] = {random_pose(2), random_pose(4)};
    sepax_simd way = n % 2 == 0 ? SEPAX_SIMD_BEST : SEPAX_SIMD_PORTABLE;
    scene s = {.mesh = {strewn(1 + (size_t)random_below(40), 0.3, 0),
                        strewn(1 + (size_t)random_below(40), 0.3, 0)}};
    s.pose[0] = n % 3 == 0 ? NULL : &p[0];
    s.pose[1] = &p[1];
    make_bodies(&s);
    double least = assert_least(&s, way);
    separated += least > 0;
    assert_near(&s, random_below(2) == 0 ? least : 0.5, &SEPAX_STRUCT(sepax_query, .simd = way));
    free_scene(&s);
  }
  assert_true(separated > 20);
}

/* On a coarse grid many pairs are at the same distance, and some at 1/4 exactly. */
CASE(ties) {
  for (int n = 0; n < 16; n++) {
    const sepax_pose aside = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {2.25, 0, 0}};
    scene s = {.mesh = {strewn(60, 0.3, 0.25), strewn(60, 0.3, 0.25)}};
    s.pose[1] = n % 2 == 0 ? &aside : NULL;
    make_bodies(&s);
    assert_least(&s, SEPAX_SIMD_BEST);
    assert_near(&s, 0.25, &SEPAX_STRUCT(sepax_query, .strict = n % 4 >= 2));
    assert_near(&s, 0, &SEPAX_STRUCT(sepax_query));
    free_scene(&s);
  }
}

/* All triangles of a body are nearly the same one: doubles cannot tell which is nearest. */
CASE(near_ties) {
  for (int n = 0; n < FEWER(16); n++) {
    sepax_pose p[2] = {random_pose(3), random_pose(3)};
    scene s = {.mesh = {strewn(40, 0.3, 0), strewn(40, 0.3, 0)}, .pose = {&p[0], &p[1]}};
    for (size_t k = 0; k < 720; k++) {
      sepax_facet *facet = s.mesh[k / 360].facet;
      facet[k / 9 % 40].v[k / 3 % 3][k % 3] =
          stepped(facet[1].v[k / 3 % 3][k % 3], random_below(9) - 4);
    }
    make_bodies(&s);
    assert_least(&s, n % 2 == 0 ? SEPAX_SIMD_BEST : SEPAX_SIMD_PORTABLE);
    free_scene(&s);
  }
}

/* Small bodies that are far from each other, or far from the origin: the limit is the distance
 * itself, and roundings of boxes, or of vertices, are larger than their sides. */
CASE(limits_of_far_bodies) {
  for (int n = 0; n < 10000; n++) {
    sepax_pose p[2] = {random_pose(1), random_pose(1)};
    double size = ldexp(1, -random_below(30));
    for (int i = 0; i < 3 && n % 4 >= 2; i++) {
      p[1].translation[i] = p[0].translation[i] + size * random_unit();
    }
    scene s = {.mesh = {strewn(1, size, 0), strewn(1, size, 0)}, .pose = {&p[0], &p[1]}};
    for (int k = 0; k < 18; k++) {
      double *x = &s.mesh[k / 9].facet[0].v[k / 3 % 3][k % 3];
      *x = (*x - 1) * size;
    }
    make_bodies(&s);
    double d = distance_of_pair(&s, 0, 0);
    double limit = stepped(d, 1);
    sepax_pairs found;
    sepax_query query = {.size = sizeof(sepax_query),
                         .simd = n % 2 == 0 ? SEPAX_SIMD_BEST : SEPAX_SIMD_PORTABLE};
    assert_works(
        sepax_bodies_near(s.body[0], &p[0], s.body[1], &p[1], limit, &query, &found, &fault));
    assert_int_equal(found.count, 1);
    sepax_pairs_free(&found);
    free_scene(&s);
  }
}

CASE(limits_of_time) {
  scene s = {.mesh = {strewn(300, 0.1, 0), strewn(300, 0.1, 0)}};
  const sepax_pose away = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {9, 0, 0}};
  sepax_distance_result r;
  sepax_pairs found;
  make_bodies(&s);
  for (int hurried = 0; hurried < 2; hurried++) {
    double seconds = hurried != 0 ? 1e-12 : 1e6;
    assert_works(sepax_bodies_near(s.body[0], NULL, s.body[1], &away, 9,
                                   &SEPAX_STRUCT(sepax_query, .seconds = seconds), &found, &fault));
    assert_int_equal(found.ended, hurried);
    assert_true(hurried != 0 || found.count > 100);
    sepax_pairs_free(&found);
    assert_works(sepax_bodies_distance(s.body[0], NULL, s.body[1], &away,
                                       &SEPAX_STRUCT(sepax_distance_request, .seconds = seconds),
                                       &r, &fault));
    assert_int_equal(r.ended, hurried);
    assert_true(r.min_distance > (hurried != 0 ? 0 : 5));
  }
  free_scene(&s);
}

CASE(distances_refused) {
  scene s = {.mesh = {strewn(2, 1, 0), strewn(2, 1, 0)}};
  sepax_distance_result r;
  sepax_pairs found;
  make_bodies(&s);
  assert_fault(sepax_bodies_distance(s.body[0], NULL, s.body[1], NULL,
                                     &SEPAX_STRUCT(sepax_distance_request, .limit = -1), &r,
                                     &fault),
               "limit of -1");
  assert_fault(sepax_bodies_distance(s.body[0], NULL, s.body[1], NULL,
                                     &SEPAX_STRUCT(sepax_distance_request, .limit = NAN), &r,
                                     &fault),
               "limit");
  const sepax_distance_result bad[] = {{.min_distance = 1, .box = {0, 9}},
                                       {.min_distance = 1, .pair = {0, 1}},
                                       {.min_distance = 0, .pair = {2, 0}},
                                       {.min_distance = INFINITY, .pair = {0, SIZE_MAX}},
                                       {.min_distance = NAN},
                                       {.min_distance = -1}};
  for (size_t i = 0; i < LENGTH(bad); i++) {
    const sepax_distance_request request = {.size = sizeof(sepax_distance_request),
                                            .last = &bad[i]};
    assert_fault(sepax_bodies_distance(s.body[0], NULL, s.body[1], NULL, &request, &r, &fault),
                 "not a result for these bodies");
  }
  assert_fault(sepax_bodies_near(s.body[0], NULL, s.body[1], NULL, NAN, NULL, &found, &fault),
               "distance");
  free_scene(&s);
}
