/* SPDX-License-Identifier: MIT */
/* posed_clearance.c - what the walk calls free is free for the real bodies in the real pose:
 * against exact distances. TREE_NEAR: how many near pairs. */
#include "oracle/distance.h"
#include "oracle/real_pairs.h"
#include "unit/tree/scenes.h"

enum { WORD = 18 };

/* Real triangles in LSB; of B in its own coordinates, of which the tree has the rounded ones. */
typedef struct {
  double a[3][3], b[3][3];
  sepax_tri of_a, of_b;
  sepax_pose pose;
} posed_pair;

static void apply_inverse(double p[3], const sepax_pose *pose, const double v[3]) {
  for (int j = 0; j < 3; j++) {
    p[j] = 0;
    for (int i = 0; i < 3; i++) {
      p[j] += pose->rotation[i][j] * (v[i] - pose->translation[i]);
    }
  }
}

/* Coordinates of B are rounded to nearest; often so that all of B goes away from A. */
static bool draw_pair(posed_pair *r, int kind, double distance, bool away, sepax_random *random) {
  real_pair p = real_pair_make(kind, distance, random);
  double way[3] = {0, 0, 0};
  r->of_a = p.rounded_a;
  r->pose = posed(random_below(5), 0);
  for (int i = 0; i < 3; i++) {
    r->pose.translation[i] = 60000 * random_unit();
  }
  if (!sepax_exact(&p.rounded_a, &p.rounded_b).collision) {
    distance_rounded(&p.rounded_a, &p.rounded_b, way);
  }
  for (int k = 0; k < 3; k++) {
    double b[3];
    double local[3];
    for (int i = 0; i < 3; i++) {
      r->a[k][i] = ldexp(*coordinate(&p.a.v[k], i), -p.fraction);
      b[i] = ldexp(*coordinate(&p.b.v[k], i), -p.fraction);
    }
    apply_inverse(local, &r->pose, b);
    for (int j = 0; j < 3; j++) {
      double ahead = 0;
      for (int i = 0; i < 3; i++) {
        ahead += r->pose.rotation[i][j] * way[i];
      }
      double whole = round(local[j] + (away ? copysign(0.49, ahead) : 0));
      r->b[k][j] = away ? whole - copysign(0x1.fffp-2, ahead) : rint(local[j] * 0x1p20) * 0x1p-20;
      whole = away ? whole : round(r->b[k][j]);
      if (fabs(whole) > 131000 || fabs(r->a[k][j]) > 131000) {
        return false;
      }
      *coordinate(&r->of_b.v[k], j) = (int32_t)whole;
    }
  }
  return true;
}

static bool is_called_free(const posed_pair *p, const sepax_design *design) {
  const triangles a = {(sepax_tri *)&p->of_a, 1};
  const triangles b = {(sepax_tri *)&p->of_b, 1};
  sepax_tree *tree_a = tree_of(&a, WORD);
  sepax_tree *tree_b = tree_of(&b, WORD);
  sepax_tree_pose pose;
  assert_works(
      sepax_tree_pose_make(&pose, tree_a, NULL, tree_b, &p->pose, design->margin[1], &fault));
  const sepax_tree_walk_options how = {.design = design};
  sepax_tree_run run;
  assert_works(sepax_tree_walk(tree_a, tree_b, &pose, &how, &run, &fault));
  sepax_tree_free(tree_a);
  sepax_tree_free(tree_b);
  return run.collisions == 0;
}

/* Pairs called free that are not, of `count`; by a tree engine, or by a core as it is alone. */
static size_t missed(size_t count, bool tree, size_t *within, size_t *called_free) {
  static const int limits[] = {0, 1, 2, 5, 20};
  sepax_random random = {2026};
  size_t wrong = 0;
  for (size_t n = 0; n < count;) {
    int limit = limits[n / REAL_KINDS % LENGTH(limits)];
    sepax_design design =
        design_of("--word=%d --clearance=%d%s", WORD, limit, tree ? " --tree=on" : "");
    posed_pair p;
    double distance = fmax(0, limit + uniform(&random, -1, 5));
    if (!draw_pair(&p, (int)(n % REAL_KINDS), distance, n % 2 == 1, &random)) {
      continue;
    }
    n++;
    bool is_within = distance_within_posed((const double(*)[3])p.a, NULL, (const double(*)[3])p.b,
                                           &p.pose, limit);
    bool is_free = is_called_free(&p, &design);
    *within += is_within;
    *called_free += is_free;
    wrong += is_within && is_free;
  }
  return wrong;
}

CASE(nothing_is_missed) {
  size_t count = count_of_run("TREE_NEAR", FEWER(20000));
  size_t within = 0;
  size_t called_free = 0;
  assert_int_equal(missed(count, true, &within, &called_free), 0);
  print_message("%zu within, %zu called free\n", within, called_free);
  assert_true(within > count / 10 && called_free > count / 100);
}

/* The pairs are hard enough: the clearance alone misses some. */
CASE(less_misses) {
  size_t within = 0;
  size_t called_free = 0;
  size_t wrong = missed(FEWER_BY > 1 ? 8000 : 20000, false, &within, &called_free);
  print_message("%zu missed of %zu called free\n", wrong, called_free);
  assert_true(wrong > 0);
}
