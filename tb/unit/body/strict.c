/* SPDX-License-Identifier: MIT */
/* strict.c - which triangles, and which bodies, pass through each other, and which only touch. */
#include "harness.h"
#include "oracle/oracle.h"
#include "unit/body/draws.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef double points[3][3];

static void to_doubles(const sepax_tri *t, double scale, points v) {
  for (int k = 0; k < 3; k++) {
    v[k][0] = scale * t->v[k].x;
    v[k][1] = scale * t->v[k].y;
    v[k][2] = scale * t->v[k].z;
  }
}

/* Does a search of two bodies of one triangle each list the pair? */
static bool listed(points t[2], const sepax_pose *pa, const sepax_pose *pb, sepax_simd simd_taken) {
  sepax_facet facet[2] = {{{{0}}}, {{{0}}}};
  sepax_body *body[2];
  sepax_query query = {.size = sizeof(sepax_query), .strict = true, .simd = simd_taken};
  sepax_pairs found;
  for (int k = 0; k < 2; k++) {
    memcpy(facet[k].v, t[k], sizeof t[k]);
    assert_works(sepax_body_new(
        &body[k], &SEPAX_STRUCT(sepax_mesh, .vertex = &facet[k], .triangles = 1), NULL, &fault));
  }
  assert_works(sepax_bodies_collide(body[0], pa, body[1], pb, &query, &found, &fault));
  bool any = found.count > 0;
  sepax_pairs_free(&found);
  sepax_body_free(body[0]);
  sepax_body_free(body[1]);
  return any;
}

static void assert_strict(points t[2], const sepax_pose *pa, const sepax_pose *pb, bool search,
                          size_t seen[2]) {
  bool expected = oracle_strict_posed(t[0], pa, t[1], pb);
  sepax_verdict v = sepax_exact_posed(t[0], pa, t[1], pb);
  sepax_verdict w = sepax_exact_posed(t[1], pb, t[0], pa);
  if (v.strict != expected || w.strict != expected || (v.strict && !v.collision)) {
    fail_msg("A_0 = %a %a %a, B_0 = %a %a %a: %d expected", t[0][0][0], t[0][0][1], t[0][0][2],
             t[1][0][0], t[1][0][1], t[1][0][2], expected);
  }
  if (search) {
    assert_int_equal(listed(t, pa, pb, SEPAX_SIMD_BEST), expected);
    assert_int_equal(listed(t, pa, pb, SEPAX_SIMD_PORTABLE), expected);
  }
  seen[expected]++;
}

/* Hard families of all word lengths as integers, as doubles, and in one pose. */
CASE(families) {
  sepax_random random = {11};
  size_t seen[2] = {0};
  for (size_t n = 0; n < FEWER(12000); n++) {
    sepax_pair pair = mixed_pair(n, 4 + random_below(29), &random);
    points t[2];
    to_doubles(&pair.a, 1, t[0]);
    to_doubles(&pair.b, 1, t[1]);
    assert_strict(t, NULL, NULL, n % 8 == 0, seen);
    assert_int_equal(sepax_exact(&pair.a, &pair.b).strict,
                     oracle_strict_posed(t[0], NULL, t[1], NULL));
    to_doubles(&pair.a, 0.1, t[0]);
    to_doubles(&pair.b, 0.1, t[1]);
    sepax_pose p = turned_and_moved(1);
    sepax_pose same = p;
    assert_strict(t, &p, &same, n % 8 == 0, seen);
  }
  assert_true(seen[0] > FEWER(5000) && seen[1] > FEWER(3000));
}

/* Few coordinates: most pairs touch in a vertex, an edge, a plane, or have no area. */
CASE(small_grid) {
  size_t seen[2] = {0};
  for (size_t n = 0; n < FEWER(100000); n++) {
    points t[2];
    sepax_pair pair = {{{{0}}}, {{{0}}}, {0}, {0}};
    int side = 2 + (int)(n % 4);
    for (int k = 0; k < 6; k++) {
      sepax_vec *v = &(k < 3 ? &pair.a : &pair.b)->v[k % 3];
      *v = (sepax_vec){random_below(side), random_below(side), random_below(side)};
    }
    to_doubles(&pair.a, 1, t[0]);
    to_doubles(&pair.b, 1, t[1]);
    assert_strict(t, NULL, NULL, n % 16 == 0, seen);
    assert_int_equal(sepax_exact(&pair.a, &pair.b).strict,
                     sepax_exact_posed(t[0], NULL, t[1], NULL).strict);
  }
  assert_true(seen[0] > FEWER(10000) && seen[1] > FEWER(1000));
}

/* The unit cube, moved. */
static sepax_body *cube(double x, double y, double z, double side) {
  sepax_facet facet[12];
  sepax_body *body;
  int n = 0;
  for (int axis = 0; axis < 3; axis++) {
    for (int k = 0; k < 4; k++, n++) {
      const int corner[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
      memset(&facet[n], 0, sizeof facet[n]);
      for (int i = 0; i < 3; i++) {
        const int *at = corner[(i + 2 * (k % 2)) % 4];
        int high = k / 2;
        facet[n].v[i][axis] = side * high;
        facet[n].v[i][(axis + 1) % 3] = side * at[0];
        facet[n].v[i][(axis + 2) % 3] = side * at[1];
        facet[n].v[i][0] += x;
        facet[n].v[i][1] += y;
        facet[n].v[i][2] += z;
      }
    }
  }
  assert_works(sepax_body_new(&body, &SEPAX_STRUCT(sepax_mesh, .vertex = facet, .triangles = 12),
                              NULL, &fault));
  return body;
}

/* Two cubes in one pose: pairs that collide, and those that collide strictly. */
static void assert_cubes(sepax_body *other, bool touch, bool strict) {
  sepax_body *one = cube(0, 0, 0, 1);
  sepax_pose p = turned_and_moved(1);
  for (int k = 0; k < 4; k++) {
    sepax_query query = {.size = sizeof(sepax_query), .strict = k % 2 != 0};
    const sepax_pose *pose = k < 2 ? NULL : &p;
    sepax_pairs found;
    assert_works(sepax_bodies_collide(one, pose, other, pose, &query, &found, &fault));
    assert_int_equal(found.count > 0, query.strict ? strict : touch);
    sepax_pairs_free(&found);
  }
  sepax_body_free(one);
  sepax_body_free(other);
}

CASE(cubes) {
  assert_cubes(cube(0.25, 0.25, 1, 0.5), true, false);   /* stands on it */
  assert_cubes(cube(1, 0, 0, 1), true, false);           /* face on the same face */
  assert_cubes(cube(1, 1, 0.5, 1), true, false);         /* edge on edge */
  assert_cubes(cube(1, 1, 1, 1), true, false);           /* vertex on vertex */
  assert_cubes(cube(0.25, 0.25, 0.75, 0.5), true, true); /* sunk into it */
  assert_cubes(cube(0.25, 0.25, 0.25, 0.5), false, false);
  assert_cubes(cube(0, 0, 0, 1), true, false); /* itself: nowhere does one cross the other */
  assert_cubes(cube(0.5, 0.25, 0.25, 1), true, true);
}
