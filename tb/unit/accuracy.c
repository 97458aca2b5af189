/* SPDX-License-Identifier: MIT */
/* accuracy.c - what the accuracy laboratory measures with: depths, solids, the software baselines;
 * and where a baseline or architecture paper begins to err. */
#include "oracle/distance.h"
#include "oracle/geometry.h"
#include "oracle/pair_tools.h"
#include "harness.h"

#include <math.h>
#include <stdlib.h>

CASE(known_depths) {
  sepax_tri a = {{{0, 0, 0}, {100, 0, 0}, {0, 100, 0}}};
  static const struct {
    sepax_tri b;
    double depth;
  } known[] = {
      {{{{0, 0, 7}, {100, 0, 7}, {0, 100, 7}}}, -7},       /* face to face */
      {{{{-3, -4, 0}, {-30, -40, 0}, {-30, -50, 9}}}, -5}, /* vertex to vertex */
      {{{{20, 20, 3}, {20, 20, 50}, {30, 30, 50}}}, -3},   /* vertex to face */
      {{{{80, 80, 0}, {90, 90, 50}, {90, 90, -50}}}, -30 * 1.4142135623730951}, /* to the edge */
      {{{{20, 20, -2}, {20, 20, 50}, {30, 30, 50}}}, 2}, /* through the face */
      {{{{20, 20, 0}, {20, 20, 50}, {30, 30, 50}}}, 0},  /* contact */
      {{{{10, 10, 0}, {20, 10, 0}, {10, 20, 0}}}, 0},    /* coplanar */
  };
  for (size_t i = 0; i < LENGTH(known); i++) {
    assert_float_equal(sepax_depth(&a, &known[i].b), known[i].depth, 1e-9);
    assert_float_equal(sepax_depth(&known[i].b, &a), known[i].depth, 1e-9);
  }
}

static sepax_tri moved(const sepax_tri *t, int x, int y, int z) {
  const int by[3] = {x, y, z};
  sepax_tri m = *t;
  for (int i = 0; i < 9; i++) {
    *coordinate(&m.v[i / 3], i % 3) += by[i % 3];
  }
  return m;
}

/* No move shorter than the depth changes the verdict; one that is hardly longer does. */
CASE(depths_by_moving) {
  enum { REACH = 9 };
  for (size_t family = 0; family < family_count(); family++) {
    sepax_random random = seeded(family, 4);
    for (int n = 0; n < FEWER(40); n++) {
      sepax_pair pair = sepax_family_pair(family, 4, &random);
      bool collision = sepax_exact(&pair.a, &pair.b).collision;
      double depth = fabs(sepax_depth(&pair.a, &pair.b));
      double nearest = INFINITY;
      for (int x = -REACH; x <= REACH; x++) {
        for (int y = -REACH; y <= REACH; y++) {
          for (int z = -REACH; z <= REACH; z++) {
            sepax_tri b = moved(&pair.b, x, y, z);
            double length = sqrt(x * x + y * y + z * z);
            if (sepax_exact(&pair.a, &b).collision != collision && length < nearest) {
              nearest = length;
            }
          }
        }
      }
      assert_true(nearest >= depth - 1e-9);
      assert_true(depth > REACH - 2 || !collision || nearest <= depth + 1.75);
    }
  }
}

/* From the origin to the nearest facet of the hull of the nine differences of vertices. */
static double depth_of_hull(const sepax_tri *a, const sepax_tri *b) {
  wide_vec p[9];
  double least = INFINITY;
  for (int k = 0; k < 9; k++) {
    p[k] = between(a->v[k / 3], b->v[k % 3]);
  }
  for (int three = 0; three < 729; three++) {
    const wide_vec *o = &p[three % 9];
    wide_vec n = cross(wide_minus(p[three / 9 % 9], *o), wide_minus(p[three / 81], *o));
    int sides[2] = {0, 0};
    for (int k = 0; k < 9; k++) {
      wide at = dot(n, wide_minus(p[k], *o));
      sides[0] += at > 0;
      sides[1] += at < 0;
    }
    double length = sqrt((double)dot(n, n));
    if (length > 0 && (sides[0] == 0 || sides[1] == 0)) {
      least = fmin(least, fabs((double)dot(n, *o)) / length);
    }
  }
  return isinf(least) ? 0 : least;
}

CASE(depths_by_other_ways) {
  for (size_t family = 0; family < family_count(); family++) {
    sepax_random random = seeded(family, 16);
    for (int n = 0; n < 60; n++) {
      sepax_pair pair = sepax_family_pair(family, 4 + n % 13, &random);
      double way[3];
      double depth = sepax_exact(&pair.a, &pair.b).collision
                         ? depth_of_hull(&pair.a, &pair.b)
                         : -distance_rounded(&pair.a, &pair.b, way);
      assert_float_equal(sepax_depth(&pair.a, &pair.b), depth, 1e-6);
    }
  }
}

/* The filter is never wrong, up to W = 16 it settles every proper pair, and it settles some of
 * longer words in every family. */
CASE(filtered_is_exact) {
  static const int words[] = {4, 16, 18, 20, 24, 27, 32};
  for (size_t w = 0; w < LENGTH(words); w++) {
    for (size_t family = 0; family < family_count(); family++) {
      sepax_random random = seeded(family, words[w]);
      int count = 0;
      for (int n = 0; n < FEWER(3000); n++) {
        sepax_pair pair = sepax_family_pair(family, words[w], &random);
        bool settled;
        bool verdict = sepax_filtered(&pair.a, &pair.b, &settled);
        assert_int_equal(verdict, sepax_exact(&pair.a, &pair.b).collision);
        assert_true(settled || words[w] > 16 || !both_have_area(&pair, words[w]));
        count += settled;
      }
      assert_true(count > FEWER(300));
    }
  }
}

/* Signs of doubles are right up to W = 16; longer words lose contacts. */
CASE(orientations_in_doubles) {
  int missed[2] = {0, 0};
  for (int word = 16; word <= 24; word += 8) {
    for (size_t family = 0; family < family_count(); family++) {
      sepax_random random = seeded(family, word);
      for (int n = 0; n < FEWER(3000); n++) {
        sepax_pair pair = sepax_family_pair(family, word, &random);
        bool exact = sepax_exact(&pair.a, &pair.b).collision;
        if (both_have_area(&pair, word) && sepax_guigue64(&pair.a, &pair.b) != exact) {
          missed[word / 24] += exact;
          assert_int_equal(word, 24);
        }
      }
    }
  }
  assert_true(missed[0] == 0 && missed[1] > FEWER(500));
}

/* What SAT in doubles misses at W = 16 are pairs in a plane, whose axes N x e have four factors:
 * products of three are exact. At W = 20 these round, too. */
CASE(sat_in_doubles) {
  int missed[2][2] = {{0, 0}, {0, 0}};
  for (int word = 16; word <= 20; word += 4) {
    for (size_t family = 0; family < family_count(); family++) {
      sepax_random random = seeded(family, word);
      for (int n = 0; n < FEWER(6000); n++) {
        sepax_pair pair = sepax_family_pair(family, word, &random);
        sepax_verdict exact = sepax_exact(&pair.a, &pair.b);
        missed[word / 20][exact.coplanar] += exact.collision && !sepax_float64(&pair.a, &pair.b);
      }
    }
  }
  assert_true(missed[0][0] == 0 && missed[0][1] > 0);
  assert_true(missed[1][0] > 0 && missed[1][1] > 0);
}

/* Where architecture paper keeps 36 bits behind W = 18, the last bit of each product with an axis
 * is lost. Up to three odd products make up to two units of overlap, on an axis of three odd
 * components 2 / sqrt(3) LSB at most. */
CASE(a_bit_short) {
  static const struct {
    sepax_tri a, b;
    double square; /* of the depth, inverted */
  } pairs[] = {
      {{{{-68269, -28501, -95858}, {-68269, -28500, -95859}, {-68270, -28500, -95858}}},
       {{{-68269, -28499, -95859}, {-68271, -28501, -95858}, {-68270, -28501, -95857}}},
       17},
      {{{{-1, -2, -18}, {0, -8, -23}, {-4, -2, -22}}},
       {{{1, -2, -23}, {-3, -3, -21}, {1, -3, -24}}},
       97.0 / 13},
  };
  for (size_t n = 0; n < LENGTH(pairs); n++) {
    sepax_pair pair = {.a = pairs[n].a, .b = pairs[n].b};
    pair.na = sepax_unit_normal(&pair.a, 18);
    pair.nb = sepax_unit_normal(&pair.b, 18);
    assert_true(sepax_exact(&pair.a, &pair.b).collision);
    assert_true(fabs(sepax_depth(&pair.a, &pair.b) - 1 / sqrt(pairs[n].square)) < 1e-9);
    for (int guard = 36; guard <= 37; guard++) {
      sepax_config config = sepax_config_default();
      config.arch = SEPAX_ARCH_PAPER;
      config.guard = guard;
      sepax_design design;
      assert_works(sepax_design_init(&design, &config, &fault));
      assert_int_equal(sepax_judge(&design, &pair).collision, guard == 37);
    }
  }
}

/* Disjoint edges on one line are no collision in a common plane. */
CASE(edges_on_a_line) {
  sepax_tri a = {{{0, 0, 5}, {10, 0, 5}, {0, 10, 5}}};
  sepax_tri b = {{{20, 0, 5}, {30, 0, 5}, {30, 10, 5}}};
  assert_false(sepax_interval64(&a, &b) || sepax_interval32(&a, &b));
  assert_false(sepax_guigue64(&a, &b) || sepax_guigue32(&a, &b));
  b.v[0].x = 10;
  assert_true(sepax_interval64(&a, &b) && sepax_guigue64(&a, &b));
}

/* Proper triangles of short words are judged right, but for mere contact: quotients round. */
CASE(interval_test_is_one) {
  sepax_random random = {3};
  for (int n = 0; n < FEWER(200000); n++) {
    sepax_pair pair = sepax_family_pair((size_t)(n % 2), 8, &random);
    if (both_have_area(&pair, 8)) {
      bool exact = sepax_exact(&pair.a, &pair.b).collision;
      assert_true(sepax_interval64(&pair.a, &pair.b) == exact ||
                  sepax_depth(&pair.a, &pair.b) == 0);
    }
  }
}
