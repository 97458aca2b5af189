/* SPDX-License-Identifier: MIT */
/* bodies.c - posed triangles and bodies against the oracle on the same doubles. */
#include "harness.h"
#include "oracle/oracle.h"
#include "unit/body/draws.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef double points[3][3];

static double random_size(void) { return ldexp(random_unit(), random_below(40) - 20); }

/* Kinds: any rotation, a quarter turn with entries 0, 1 and -1, none. */
static sepax_pose random_pose(double away) {
  static const sepax_pose quarter = {{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}, {0, 0, 0}};
  static const sepax_pose none = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};
  int kind = random_below(3);
  sepax_pose p = kind == 0   ? turned(random_unit(), random_unit(), random_unit(), random_unit())
                 : kind == 1 ? quarter
                             : none;
  for (int i = 0; i < 3; i++) {
    p.translation[i] = away * (kind == 0 ? random_unit() : random_below(5) - 2);
  }
  return p;
}

static void assert_oracle(const points a, const sepax_pose *pa, const points b,
                          const sepax_pose *pb) {
  bool expected = oracle_collide_posed(a, pa, b, pb);
  sepax_verdict v = sepax_exact_posed(a, pa, b, pb);
  if (v.collision != expected || (v.axis == SEPAX_AXIS_NONE) != expected) {
    fail_msg("A_0 = %a %a %a, B_0 = %a %a %a: %d expected", a[0][0], a[0][1], a[0][2], b[0][0],
             b[0][1], b[0][2], expected);
  }
}

CASE(rotations_are_valid) {
  for (int n = 0; n < 1000; n++) {
    sepax_pose p = random_pose(1);
    assert_works(sepax_pose_valid(&p, &fault));
  }
}

CASE(invalid_poses) {
  sepax_pose p = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};
  p.rotation[0][0] = 1 + 2e-6;
  assert_fault(sepax_pose_valid(&p, &fault), "rotation");
  p.rotation[0][0] = -1;
  assert_fault(sepax_pose_valid(&p, &fault), "reflection");
  p.rotation[0][0] = NAN;
  assert_fault(sepax_pose_valid(&p, &fault), "finite");
  p.rotation[0][0] = 1;
  p.translation[2] = INFINITY;
  assert_fault(sepax_pose_valid(&p, &fault), "finite");
}

/* A hard pair of some word length as doubles. */
static void draw_pair(points t[2], size_t n, double scale, sepax_random *random) {
  sepax_pair pair = mixed_pair(n, 4 + random_below(29), random);
  for (int k = 0; k < 18; k++) {
    const sepax_vec *v = &(k < 9 ? &pair.a : &pair.b)->v[k / 3 % 3];
    t[k / 9][k / 3 % 3][k % 3] = scale * (k % 3 == 0 ? v->x : k % 3 == 1 ? v->y : v->z);
  }
}

/* Both in one pose: touching pairs, rotated, are decided by their last bits. */
CASE(families_in_poses) {
  sepax_random random = {3};
  for (size_t n = 0; n < FEWER(20000); n++) {
    double scale = ldexp(1, random_below(60) - 30) * (random_below(2) == 0 ? 1 : 0.1);
    points t[2];
    draw_pair(t, n, scale, &random);
    sepax_pose p = random_pose(scale);
    sepax_pose same = p;
    assert_oracle(t[0], NULL, t[1], NULL);
    assert_oracle(t[0], &p, t[1], &same);
    assert_oracle(t[0], &p, t[1], n % 2 == 0 ? NULL : &same);
  }
}

/* Coordinates of very different sizes, down to the smallest that there are. */
CASE(wide_exponents) {
  for (int n = 0; n < 2000; n++) {
    points t[2];
    for (int k = 0; k < 18; k++) {
      int exponent = n % 3 == 0 ? random_below(2000) - 1074 : -1074 + random_below(60);
      double few = random_below(5) - 2;
      t[k / 9][k / 3 % 3][k % 3] = n % 2 == 0 ? ldexp(few, exponent) : random_size() * few;
    }
    sepax_pose p = random_pose(random_size());
    assert_oracle(t[0], NULL, t[1], NULL);
    assert_oracle(t[0], NULL, t[1], &p);
  }
}

/* ------------------------------------------------------------------------ bodies */

/* A search done once finds the pairs in `hit`, in order. */
static void assert_found_once(const sepax_soup m[2], const sepax_pose *pa, const sepax_pose *pb,
                              sepax_simd simd_taken, const bool *hit) {
  for (int kind = 0; kind < 3; kind++) {
    sepax_search how = {.size = sizeof(sepax_search),
                        .simd = simd_taken,
                        .threads = 1 + kind % 2,
                        .brute_force = kind == 2};
    sepax_pairs found;
    size_t n = 0;
    assert_works(sepax_meshes_collide(SEPAX_SOUP_MESH(&m[0]), pa, SEPAX_SOUP_MESH(&m[1]), pb, &how,
                                      &found, &fault));
    for (size_t k = 0; k < m[0].count * m[1].count; k++) {
      if (hit[k]) {
        assert_true(n < found.count);
        assert_int_equal(found.pair[n][0] * m[1].count + found.pair[n][1], k);
        n++;
      }
    }
    assert_int_equal(found.count, n);
    sepax_pairs_free(&found);
  }
}

static size_t assert_all_pairs(const sepax_soup m[2], sepax_body *body[2], const sepax_pose *pa,
                               const sepax_pose *pb, sepax_simd simd_taken) {
  bool *hit = calloc(m[0].count * m[1].count, 1);
  sepax_query query = {.size = sizeof(sepax_query), .simd = simd_taken};
  sepax_pairs found;
  size_t expected = 0;
  assert_non_null(hit);
  assert_works(sepax_bodies_collide(body[0], pa, body[1], pb, &query, &found, &fault));
  for (size_t n = 0; n < found.count; n++) {
    bool *one = &hit[found.pair[n][0] * m[1].count + found.pair[n][1]];
    assert_false(*one);
    *one = true;
  }
  for (size_t i = 0; i < m[0].count; i++) {
    for (size_t j = 0; j < m[1].count; j++) {
      bool collide = sepax_exact_posed(m[0].facet[i].v, pa, m[1].facet[j].v, pb).collision;
      assert_int_equal(hit[i * m[1].count + j], collide);
      expected += collide;
    }
  }
  assert_int_equal(found.count, expected);
  for (size_t most = 1; most <= 3; most++) {
    query.most = most;
    sepax_pairs_free(&found);
    assert_works(sepax_bodies_collide(body[0], pa, body[1], pb, &query, &found, &fault));
    assert_int_equal(found.count, expected < most ? expected : most);
  }
  query = SEPAX_STRUCT(sepax_query, .only_any = true, .simd = simd_taken);
  sepax_pairs_free(&found);
  assert_works(sepax_bodies_collide(body[0], pa, body[1], pb, &query, &found, &fault));
  assert_int_equal(found.count, expected > 0);
  assert_null(found.pair);
  assert_found_once(m, pa, pb, simd_taken, hit);
  free(hit);
  return expected;
}

CASE(all_pairs_of_bodies) {
  size_t collisions = 0;
  for (int n = 0; n < FEWER(40); n++) {
    double step = n % 2 == 0 ? 0.125 : 0;
    sepax_soup m[2] = {strewn(1 + (size_t)random_below(150), 0.6, step),
                       strewn(1 + (size_t)random_below(150), 0.3, step)};
    sepax_body *body[2];
    for (int k = 0; k < 2; k++) {
      assert_works(sepax_body_new(&body[k], SEPAX_SOUP_MESH(&m[k]), NULL, &fault));
      assert_int_equal(sepax_body_triangles(body[k]), m[k].count);
    }
    sepax_pose pa = random_pose(0.25);
    sepax_pose pb = random_pose(0.25);
    collisions += assert_all_pairs(m, body, NULL, &pb, SEPAX_SIMD_BEST);
    collisions += assert_all_pairs(m, body, &pa, &pb, SEPAX_SIMD_BEST);
    collisions += assert_all_pairs(m, body, &pa, NULL, SEPAX_SIMD_PORTABLE);
    for (int k = 0; k < 2; k++) {
      sepax_body_free(body[k]);
      sepax_soup_free(&m[k]);
    }
  }
  assert_true(collisions > FEWER(1000));
}

/* Poses that turn or move nothing, or along one axis alone. */
CASE(poses_that_move_little) {
  sepax_soup m[2] = {strewn(24, 0.9, 0.125), strewn(24, 0.6, 0.125)};
  sepax_body *body[2];
  for (int k = 0; k < 2; k++) {
    assert_works(sepax_body_new(&body[k], SEPAX_SOUP_MESH(&m[k]), NULL, &fault));
  }
  for (int n = 0; n < 15; n++) {
    sepax_pose pose = turned(1, n == 7 ? 1 : 0, n == 8 ? 1 : 0, n == 9 ? 1 : 0);
    if (n < 6) {
      pose.translation[n % 3] = n < 3 ? 0.25 : -0.5;
    } else if (n == 14) {
      pose = (sepax_pose){{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {1, 1, 1}};
    } else if (n >= 10) {
      pose = turned(1, 0, n == 10 ? 1e-9 : 0, n == 11 ? 1e-9 : 0);
      pose.rotation[2][2] = n == 12 ? 1 - 1e-7 : pose.rotation[2][2];
      pose.rotation[0][2] = n == 13 ? 1e-7 : pose.rotation[0][2];
    }
    assert_all_pairs(m, body, NULL, &pose, SEPAX_SIMD_BEST);
    assert_all_pairs(m, body, &pose, NULL, SEPAX_SIMD_BEST);
  }
  for (int k = 0; k < 2; k++) {
    sepax_body_free(body[k]);
    sepax_soup_free(&m[k]);
  }
}

static void assert_posed_bodies(const points t[2], sepax_body *const body[2], const sepax_pose *pa,
                                const sepax_pose *pb, sepax_simd simd_taken) {
  sepax_pairs found;
  sepax_query query = {.size = sizeof(sepax_query), .simd = simd_taken};
  assert_works(sepax_bodies_collide(body[0], pa, body[1], pb, &query, &found, &fault));
  assert_int_equal(found.count, sepax_exact_posed(t[0], pa, t[1], pb).collision);
  sepax_pairs_free(&found);
}

/* Bodies of one triangle each: what touches is in doubt for the doubles. */
CASE(touching_bodies) {
  sepax_random random = {5};
  for (size_t n = 0; n < FEWER(20000); n++) {
    sepax_facet facet[2] = {{{{0}}}, {{{0}}}};
    points t[2];
    sepax_body *body[2];
    double tiny = ldexp(0.1, -340 - random_below(60)); /* its cube is less than any normal number */
    draw_pair(t, n, n % 3 == 0 ? 0.1 : n % 3 == 1 ? tiny : 0.25, &random);
    for (int k = 0; k < 2; k++) {
      memcpy(facet[k].v, t[k], sizeof t[k]);
      assert_works(sepax_body_new(
          &body[k], &SEPAX_STRUCT(sepax_mesh, .vertex = &facet[k], .triangles = 1), NULL, &fault));
    }
    sepax_pose p = random_pose(1);
    const sepax_simd paths[] = {SEPAX_SIMD_PORTABLE, SEPAX_SIMD_AVX2, SEPAX_SIMD_BEST};
    sepax_simd simd_taken = paths[n % 4 % 3];
    assert_posed_bodies(t, body, &p, n % 2 == 0 ? &p : NULL, simd_taken);
    assert_posed_bodies(t, body, NULL, &p, simd_taken);
    assert_posed_bodies(t, body, NULL, NULL, simd_taken);
    if (n % 16 == 0) {
      sepax_pairs found;
      assert_works(
          sepax_meshes_collide(&SEPAX_STRUCT(sepax_mesh, .vertex = &facet[0], .triangles = 1), &p,
                               &SEPAX_STRUCT(sepax_mesh, .vertex = &facet[1], .triangles = 1),
                               n % 32 == 0 ? &p : NULL, NULL, &found, &fault));
      assert_int_equal(found.count,
                       sepax_exact_posed(t[0], &p, t[1], n % 32 == 0 ? &p : NULL).collision);
      sepax_pairs_free(&found);
    }
    sepax_body_free(body[0]);
    sepax_body_free(body[1]);
  }
}

/* Triangles on one line that touch, or have a gap that their boxes do not see. */
CASE(bodies_on_a_line) {
  for (int n = 0; n < 200; n++) {
    points t[2];
    sepax_body *body[2];
    double along[3] = {random_below(7) - 3, random_below(7) - 3, random_below(7) - 3};
    double gap = n % 2 == 0 ? 0 : 0x1p-24;
    for (int k = 0; k < 2; k++) {
      sepax_facet facet = {{{0}}};
      int first = random_below(3);
      for (int v = 0; v < 3; v++) {
        double at = v == first ? 0 : random_below(16);
        at = k == 0 ? -at : at + gap;
        for (int i = 0; i < 3; i++) {
          t[k][v][i] = facet.v[v][i] = at * along[i];
        }
      }
      assert_works(sepax_body_new(
          &body[k], &SEPAX_STRUCT(sepax_mesh, .vertex = &facet, .triangles = 1), NULL, &fault));
    }
    bool point = fabs(along[0]) + fabs(along[1]) + fabs(along[2]) < 1;
    assert_int_equal(sepax_exact_posed(t[0], NULL, t[1], NULL).collision, n % 2 == 0 || point);
    assert_posed_bodies(t, body, NULL, NULL, n % 4 < 2 ? SEPAX_SIMD_PORTABLE : SEPAX_SIMD_BEST);
    sepax_body_free(body[0]);
    sepax_body_free(body[1]);
  }
}

typedef struct {
  size_t calls, most;
} counter;

static bool count_pair(void *context, size_t a, size_t b) {
  counter *c = context;
  assert_true(a < 300 && b < 300);
  return ++c->calls < c->most;
}

static sepax_pairs search_of(sepax_body *const body[2], sepax_query query) {
  sepax_pairs found;
  assert_works(sepax_bodies_collide(body[0], NULL, body[1], NULL, &query, &found, &fault));
  return found;
}

static bool is_among(const sepax_pairs *pairs, const size_t pair[2]) {
  size_t k = 0;
  while (k < pairs->count && memcmp(pairs->pair[k], pair, sizeof pairs->pair[k]) != 0) {
    k++;
  }
  return k < pairs->count;
}

CASE(limits_of_a_search) {
  sepax_soup m[2] = {strewn(300, 0.5, 0), strewn(300, 0.5, 0)};
  sepax_body *body[2];
  for (int k = 0; k < 2; k++) {
    assert_works(sepax_body_new(&body[k], SEPAX_SOUP_MESH(&m[k]), NULL, &fault));
  }
  sepax_pairs all = search_of(body, SEPAX_STRUCT(sepax_query));
  assert_true(all.count > 100);
  assert_false(all.ended);
  sepax_pairs some = search_of(body, SEPAX_STRUCT(sepax_query, .most = 7));
  assert_int_equal(some.count, 7);
  assert_true(some.ended);
  for (size_t k = 0; k < some.count; k++) {
    assert_true(is_among(&all, some.pair[k]));
  }
  counter c = {0, SIZE_MAX};
  sepax_pairs told = search_of(body, SEPAX_STRUCT(sepax_query, .each = count_pair, .context = &c));
  assert_int_equal(c.calls, all.count);
  assert_false(told.ended);
  assert_null(told.pair);
  c = (counter){0, 5};
  told = search_of(body, SEPAX_STRUCT(sepax_query, .each = count_pair, .context = &c));
  assert_int_equal(c.calls, 5);
  assert_true(told.ended);
  sepax_pairs hurried = search_of(body, SEPAX_STRUCT(sepax_query, .seconds = 1e-12));
  assert_int_equal(hurried.count, 0);
  assert_true(hurried.ended);
  sepax_pairs patient = search_of(body, SEPAX_STRUCT(sepax_query, .seconds = 1e6));
  assert_int_equal(patient.count, all.count);
  sepax_pairs_free(&all);
  sepax_pairs_free(&some);
  sepax_pairs_free(&patient);
  for (int k = 0; k < 2; k++) {
    sepax_body_free(body[k]);
    sepax_soup_free(&m[k]);
  }
}

/* Sizes, places and distances so different that single precision overflows, or sees nothing. */
CASE(bodies_of_any_size) {
  for (int n = 0; n < FEWER(300); n++) {
    sepax_soup m[2];
    sepax_body *body[2];
    double away[3];
    int middle = random_below(1500) - 750;
    for (int i = 0; i < 3; i++) {
      away[i] = n % 3 == 0 ? 0 : ldexp(random_unit(), random_below(60) - 10);
    }
    for (int k = 0; k < 2; k++) {
      double size = ldexp(1, middle + (k == 1 && n % 2 == 0 ? random_below(400) - 200 : 0));
      m[k] = strewn(12, 1, 0);
      for (size_t i = 0; i < m[k].count * 9; i++) {
        double *x = &m[k].facet[i / 9].v[i % 9 / 3][i % 3];
        *x = size * *x + ldexp(away[i % 3], middle);
      }
      assert_works(sepax_body_new(&body[k], SEPAX_SOUP_MESH(&m[k]), NULL, &fault));
    }
    sepax_pose pose = random_pose(n % 5 == 0 ? ldexp(1, middle + random_below(80) - 40) : 0);
    for (int i = 0; i < 9; i++) {
      pose.rotation[i / 3][i % 3] += n % 7 == 0 ? 2e-7 * random_unit() : 0;
    }
    assert_works(sepax_pose_valid(&pose, &fault));
    assert_all_pairs(m, body, NULL, n % 4 == 0 ? NULL : &pose, SEPAX_SIMD_BEST);
    assert_all_pairs(m, body, &pose, &pose, SEPAX_SIMD_PORTABLE);
    for (int k = 0; k < 2; k++) {
      sepax_body_free(body[k]);
      sepax_soup_free(&m[k]);
    }
  }
}

/* A pose may stretch by a millionth: the corner of B is A's then. */
CASE(stretched_into_contact) {
  const double k = 1.0000004;
  sepax_soup m[2] = {strewn(1, 1, 0), strewn(1, 1, 0)};
  sepax_body *body[2];
  const double a[3][3] = {{k, k, k}, {3, 3, 3}, {3, k, k}};
  const double b[3][3] = {{-1, -1, -1}, {1, 1, 1}, {-1, 1, 1}};
  const sepax_pose pose = {{{k, 0, 0}, {0, k, 0}, {0, 0, k}}, {0, 0, 0}};
  sepax_pairs found;
  memcpy(m[0].facet[0].v, a, sizeof a);
  memcpy(m[1].facet[0].v, b, sizeof b);
  for (int n = 0; n < 2; n++) {
    assert_works(sepax_body_new(&body[n], SEPAX_SOUP_MESH(&m[n]), NULL, &fault));
  }
  assert_works(sepax_bodies_collide(body[0], NULL, body[1], &pose, NULL, &found, &fault));
  assert_int_equal(found.count, 1);
  sepax_pairs_free(&found);
  for (int n = 0; n < 2; n++) {
    sepax_body_free(body[n]);
    sepax_soup_free(&m[n]);
  }
}

/* All that take poses and limits refuse what is none. */
static void assert_question_refused(const sepax_soup *mesh, const sepax_body *body,
                                    const sepax_pose *pose, double seconds, const char *part) {
  const sepax_query query = {.size = sizeof(sepax_query), .seconds = seconds};
  const sepax_distance_request request = {.size = sizeof(sepax_distance_request),
                                          .seconds = seconds};
  sepax_distance_result distance;
  sepax_pairs found;
  for (int k = 0; k < 2; k++) {
    const sepax_pose *a = k == 0 ? pose : NULL;
    const sepax_pose *b = k == 0 ? NULL : pose;
    assert_fault(sepax_bodies_collide(body, a, body, b, &query, &found, &fault), part);
    assert_null(found.pair);
    assert_fault(sepax_bodies_near(body, a, body, b, 1, &query, &found, &fault), part);
    assert_fault(sepax_bodies_distance(body, a, body, b, &request, &distance, &fault), part);
    if (pose != NULL) {
      sepax_shell shell;
      sepax_inside within[2];
      assert_works(sepax_shell_find(&shell, body, &fault));
      assert_fault(sepax_meshes_collide(SEPAX_SOUP_MESH(mesh), a, SEPAX_SOUP_MESH(mesh), b, NULL,
                                        &found, &fault),
                   part);
      assert_fault(sepax_bodies_within(&shell, a, &shell, b, within, &fault), part);
      sepax_shell_free(&shell);
    }
  }
}

CASE(questions_refused) {
  const sepax_pose still = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};
  sepax_soup mesh = strewn(5, 1, 0);
  sepax_body *body;
  assert_works(sepax_body_new(&body, SEPAX_SOUP_MESH(&mesh), NULL, &fault));
  sepax_pose pose = still;
  pose.translation[1] = NAN;
  assert_question_refused(&mesh, body, &pose, 0, "finite");
  pose = still;
  pose.rotation[0][0] = 1e308;
  assert_question_refused(&mesh, body, &pose, 0, "rotation");
  assert_question_refused(&mesh, body, NULL, -1, "seconds");
  assert_question_refused(&mesh, body, NULL, NAN, "seconds");
  sepax_body_free(body);
  sepax_soup_free(&mesh);
}

/* Of every coordinate. */
CASE(meshes_refused) {
  static const double wrong[] = {NAN, INFINITY, -0x1p1001};
  for (int k = 0; k < 36; k++) {
    sepax_facet facet[2][2] = {{{.v = {{0}}}}, {{.v = {{0}}}}};
    const sepax_soup m[2] = {{.facet = facet[0], .count = 2}, {.facet = facet[1], .count = 2}};
    sepax_pairs found;
    double *x = &facet[k / 18][k / 9 % 2].v[k / 3 % 3][k % 3];
    *x = wrong[k % 4 % 3];
    assert_fault(sepax_meshes_collide(SEPAX_SOUP_MESH(&m[0]), NULL, SEPAX_SOUP_MESH(&m[1]), NULL,
                                      NULL, &found, &fault),
                 "2^1000");
    *x = 0;
    assert_works(sepax_meshes_collide(SEPAX_SOUP_MESH(&m[0]), NULL, SEPAX_SOUP_MESH(&m[1]), NULL,
                                      NULL, &found, &fault));
    assert_int_equal(found.count, 4);
    sepax_pairs_free(&found);
  }
}

CASE(bodies_refused) {
  sepax_body *body;
  sepax_pairs found;
  sepax_soup none = {.facet = NULL, .count = 0};
  assert_fault(sepax_body_new(&body, SEPAX_SOUP_MESH(&none), NULL, &fault), "triangles");
  sepax_soup mesh = strewn(5, 1, 0);
  mesh.facet[3].v[1][2] = NAN;
  assert_fault(sepax_body_new(&body, SEPAX_SOUP_MESH(&mesh), NULL, &fault), "facet 3");
  mesh.facet[3].v[1][2] = 1e305;
  assert_fault(sepax_body_new(&body, SEPAX_SOUP_MESH(&mesh), NULL, &fault), "facet 3");
  assert_fault(sepax_meshes_collide(SEPAX_SOUP_MESH(&mesh), NULL, SEPAX_SOUP_MESH(&mesh), NULL,
                                    NULL, &found, &fault),
               "2^1000");
  assert_works(sepax_meshes_collide(SEPAX_SOUP_MESH(&none), NULL, SEPAX_SOUP_MESH(&none), NULL,
                                    NULL, &found, &fault));
  assert_int_equal(found.count, 0);
  sepax_soup_free(&mesh);
}
