/* SPDX-License-Identifier: MIT */
/* clearance_bands.c - checks sepax_clearance against exact distances of real triangles near its
 * limits; `make experiment NAME=clearance` does so 10,000,000 times. */
#include "oracle/clearance_rules.h"
#include "oracle/distance.h"
#include "oracle/geometry.h"
#include "oracle/oracle.h"
#include "oracle/pair_tools.h"
#include "oracle/real_pairs.h"
#include "harness.h"

#include <math.h>
#include <stdlib.h>

#define REAL_PAIRS (FEWER_BY > 1 ? 100000 / FEWER_BY : 200000)
#define FAULT_PAIRS FEWER(40000)
#define TIGHT_PAIRS (REAL_PAIRS / 4)

static real_pair pair_near(size_t n, int limit, sepax_random *random) {
  double reach = n % 3 == 0 ? 0.02 : n % 3 == 1 ? 1 : 3;
  return real_pair_make((int)(n % REAL_KINDS), fmax(0, limit + uniform(random, -reach, reach)),
                        random);
}

/* The axis that is named, 1 ... 11. */
static wide_vec named_axis(int axis, const sepax_tri *a, const sepax_tri *b) {
  const sepax_tri *of[2] = {axis == SEPAX_AXIS_NORMAL_B ? b : a,
                            axis == SEPAX_AXIS_NORMAL_A ? a : b};
  int from[2] = {0, 1};
  if (axis < SEPAX_AXIS_NORMAL_A) {
    from[0] = (axis - SEPAX_AXIS_EDGES) / 3;
    from[1] = (axis - SEPAX_AXIS_EDGES) % 3;
  }
  return cross(edge(of[0], from[0]), edge(of[1], from[1]));
}

/* No pair within a limit is called free of it. */
CASE(test_nothing_is_missed) {
  static const int limits[][2] = {{0, 1}, {0, 7}, {1, 3}, {2, 20}, {5, 6}, {40, 100}};
  sepax_random random = {2026};
  size_t within = 0;
  size_t free_pairs = 0;
  size_t quick = 0;
  for (size_t n = 0; n < REAL_PAIRS; n++) {
    const int *limit = limits[n % 6];
    sepax_design design = design_of("--clearance=%d --warning=%d", limit[0], limit[1]);
    real_pair p = pair_near(n, limit[sepax_random_range(&random, 0, 1)], &random);
    sepax_judgement v = sepax_clearance(&design, &p.rounded_a, &p.rounded_b);
    assert_int_equal(v.collision, v.band == SEPAX_BAND_COLLISION);
    assert_int_equal(v.axis == 0, v.collision);
    assert_true(
        v.axis == 0 || v.axis > SEPAX_AXIS_NORMAL_B ||
        separates(named_axis(v.axis, &p.rounded_a, &p.rounded_b), &p.rounded_a, &p.rounded_b));
    for (int k = 0; k < 2; k++) {
      bool is_within = distance_within(&p.a, &p.b, (int64_t)limit[k] << p.fraction, &quick);
      bool called_free = v.band == SEPAX_BAND_FREE || (k == 0 && v.band == SEPAX_BAND_WARNING);
      within += is_within;
      free_pairs += called_free;
      assert_false(is_within && called_free);
    }
  }
  assert_true(within > REAL_PAIRS / 2 && free_pairs > REAL_PAIRS / 4);
}

/* The pairs are hard enough: rules without the rounding, or with a length for the sum, miss. */
static size_t missed_by(clear_rule rule) {
  sepax_random random = {7};
  size_t missed = 0;
  for (size_t n = 0; n < FAULT_PAIRS; n++) {
    int limit = (int)(n / REAL_KINDS % 6);
    real_pair p = pair_near(n, limit, &random);
    missed += clear_by(rule, &p.rounded_a, &p.rounded_b, limit) &&
              distance_within(&p.a, &p.b, (int64_t)limit << p.fraction, NULL);
  }
  return missed;
}

CASE(test_wrong_rules_miss) {
  assert_true(missed_by(RULE_NO_ROUNDING) > FEWER(100));
  assert_true(missed_by(RULE_LENGTH) > FEWER(10));
}

/* A wide triangle with normal c, and the same one shifted. */
static sepax_pair face_and_shifted(const int32_t c[3], int32_t size, const int64_t way[3]) {
  int i = c[0] != 0 ? 0 : 1; /* c[i] is not 0 */
  int32_t span[2][3] = {{0, 0, 0}, {0, 0, 0}};
  for (int k = 0; k < 2; k++) {
    int j = (i + 1 + k) % 3;
    int32_t scale = size / (1 + abs(c[i]) + abs(c[j]));
    span[k][i] = -c[j] * scale;
    span[k][j] = c[i] * scale;
  }
  sepax_pair pair = {.a = {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}}};
  for (int axis = 0; axis < 3; axis++) {
    *coordinate(&pair.a.v[0], axis) = -span[0][axis] - span[1][axis];
    *coordinate(&pair.a.v[1], axis) = 2 * span[0][axis] - span[1][axis];
    *coordinate(&pair.a.v[2], axis) = 2 * span[1][axis] - span[0][axis];
    for (int k = 0; k < 3; k++) {
      int64_t at = *coordinate(&pair.a.v[k], axis) + way[axis];
      *coordinate(&pair.b.v[k], axis) = at > INT32_MAX || at < INT32_MIN ? INT32_MAX : (int32_t)at;
    }
  }
  return pair;
}

/* Beyond sqrt(3) (D + 2) every pair is free, docs/reference/clearance.md. */
CASE(test_far_is_free) {
  sepax_random random = {3};
  size_t beyond = 0;
  for (size_t n = 0; n < FAULT_PAIRS; n++) {
    int limit = (int)(n / REAL_KINDS % 6);
    sepax_design design = design_of("--clearance=%d", limit);
    double far = sqrt(3) * (limit + 2);
    real_pair p = real_pair_make((int)(n % REAL_KINDS), far * uniform(&random, 0.9, 1.2), &random);
    int64_t reach = (int64_t)ceil(ldexp(far, p.fraction));
    if (!distance_within(&p.a, &p.b, reach, NULL)) {
      beyond++;
      assert_int_equal(sepax_clearance(&design, &p.rounded_a, &p.rounded_b).band, SEPAX_BAND_FREE);
    }
  }
  assert_true(beyond > FAULT_PAIRS / 4);
}

/* The tight rule: no miss either, whatever the clearance; free what sepax_clearance calls free, and
 * what the axes prove by their lengths, as an own computation in doubles finds. */
CASE(test_tight) {
  static const int limits[] = {0, 1, 10, 100, 1000};
  sepax_random random = {11};
  size_t within = 0;
  size_t more = 0;
  size_t same = 0;
  for (size_t n = 0; n < TIGHT_PAIRS; n++) {
    int limit = limits[n / REAL_KINDS % LENGTH(limits)];
    sepax_design design = design_of("--clearance=%d", limit);
    double share = n % 3 == 0 ? 0.001 : n % 3 == 1 ? 0.05 : 0.5;
    double reach = share * (limit + 2);
    real_pair p = real_pair_make((int)(n % REAL_KINDS),
                                 fmax(0, limit + uniform(&random, -0.2 * reach, reach)), &random);
    bool tight = sepax_clearance_tight(&design, &p.rounded_a, &p.rounded_b).band == SEPAX_BAND_FREE;
    bool usual = sepax_clearance(&design, &p.rounded_a, &p.rounded_b).band == SEPAX_BAND_FREE;
    bool is_within = distance_within(&p.a, &p.b, (int64_t)limit << p.fraction, NULL);
    assert_false(is_within && tight);
    assert_true(tight || !usual);
    within += is_within;
    more += tight && !usual;
    bool just = clear_by(RULE_EUCLID, &p.rounded_a, &p.rounded_b, limit * (1 + 1e-9) + 1e-9);
    bool almost = clear_by(RULE_EUCLID, &p.rounded_a, &p.rounded_b, limit * (1 - 1e-9) - 1e-9);
    if (just == almost) {
      same++;
      assert_int_equal(tight, just);
    }
  }
  assert_true(within > TIGHT_PAIRS / 10 && more > TIGHT_PAIRS / 20 && same > TIGHT_PAIRS / 2);
}

/* Parallel faces whose normal has a whole length: at a gap of |c|_1 + D |c|_2 not free, above it
 * free; to the largest numbers of 32 bits. */
CASE(test_tight_limit) {
  static const int32_t normals[][4] = {{3, 4, 0, 5},  {0, -4, 3, 5},  {1, 2, 2, 3},
                                       {-2, 3, 6, 7}, {6, -6, 7, 11}, {1, 0, 0, 1}};
  size_t found = 0;
  for (int n = 0; n < FEWER(3000); n++) {
    const int32_t *c = normals[n % (int)LENGTH(normals)];
    int word = 8 + n % 25;
    int clearance = random_below(sepax_word_max(word) / 2);
    sepax_design design = design_of("--word=%d --clearance=%d", word, clearance);
    int64_t wanted = labs(c[0]) + labs(c[1]) + labs(c[2]) + (int64_t)clearance * c[3];
    /* Shifted along c nearly as far, then by single steps. */
    int64_t square = (int64_t)c[3] * c[3];
    int64_t way[3];
    for (int i = 0; i < 3; i++) {
      way[i] = wanted / square * c[i];
    }
    int64_t rest = wanted - wanted / square * square;
    for (int k = 0; k < 3 && rest > 0; k++) {
      for (int step = -40; step <= 40 && rest > 0; step++) {
        for (int other = -40; other <= 40 && rest > 0; other++) {
          if ((int64_t)step * c[k] + (int64_t)other * c[(k + 1) % 3] == rest) {
            way[k] += step;
            way[(k + 1) % 3] += other;
            rest = 0;
          }
        }
      }
    }
    int32_t size = sepax_word_max(word) / 16;
    sepax_pair pair = face_and_shifted(c, size, way);
    if (rest > 0 || size < 100 || !sepax_pair_fits(&pair, word)) {
      continue;
    }
    found++;
    assert_int_equal(sepax_clearance_tight(&design, &pair.a, &pair.b).band, SEPAX_BAND_COLLISION);
    int k = abs(c[0]) == 1 ? 0 : abs(c[1]) > 0 ? 1 : 2;
    way[k] += c[k] > 0 ? 1 : -1;
    pair = face_and_shifted(c, size, way);
    assert_int_equal(sepax_clearance_tight(&design, &pair.a, &pair.b).band, SEPAX_BAND_FREE);
  }
  assert_true(found > FEWER(1000));
}

/* Corners of the space of 32 bits, where the squares take more than 192 bits. */
CASE(test_tight_corners) {
  size_t count[2] = {0, 0};
  for (int n = 0; n < FEWER(20000); n++) {
    sepax_pair pair = {.a = {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}}};
    for (int i = 0; i < COORDINATES; i++) {
      bool far = random_below(8) != 0;
      int32_t most = INT32_MAX - random_below(3);
      *field(&pair, i) = far ? (random_below(2) == 0 ? most : -most) : random_below(INT32_MAX);
    }
    int32_t clearance = INT32_MAX - random_below(INT32_MAX);
    sepax_design design = design_of("--word=32 --clearance=%d", clearance);
    bool tight = sepax_clearance_tight(&design, &pair.a, &pair.b).band == SEPAX_BAND_FREE;
    bool just = clear_by(RULE_EUCLID, &pair.a, &pair.b, clearance * (1 + 1e-9));
    bool almost = clear_by(RULE_EUCLID, &pair.a, &pair.b, clearance * (1 - 1e-9));
    count[tight]++;
    assert_true(just != almost || tight == just);
  }
  assert_true(count[0] > FEWER(1000) && count[1] > FEWER(1000));
}

/* The two halves of the oracle agree, and the rational one with known answers. */
CASE(test_oracle) {
  sepax_tri a = {{{0, 0, 0}, {10, 0, 0}, {0, 10, 0}}};
  static const struct {
    sepax_tri b;
    int64_t within;
  } known[] = {{{{{2, 2, 7}, {2, 3, 9}, {3, 2, 9}}}, 7},       /* over */
               {{{{5, -5, 1}, {5, 25, 1}, {5, 25, 1}}}, 1},    /* crossing */
               {{{{13, -4, 0}, {20, -5, 3}, {20, -6, 0}}}, 5}, /* to a corner */
               {{{{2, 2, -5}, {2, 2, 5}, {3, 2, 5}}}, 0}};     /* through */
  for (size_t i = 0; i < LENGTH(known); i++) {
    const sepax_tri *b = &known[i].b;
    int64_t d = known[i].within;
    assert_true(distance_within_exact(&a, b, d));
    assert_true(distance_within(b, &a, d, NULL));
    assert_true(d == 0 || !distance_within_exact(b, &a, d - 1));
    assert_true(d == 0 || !distance_within(&a, b, d - 1, NULL));
  }
  sepax_random random = {1};
  for (size_t n = 0; n < FEWER(20000); n++) {
    real_pair p = pair_near(n, 2, &random);
    bool is_within = distance_within_exact(&p.a, &p.b, (int64_t)2 << p.fraction);
    assert_int_equal(distance_within(&p.a, &p.b, (int64_t)2 << p.fraction, NULL), is_within);
    assert_int_equal(distance_within_exact(&p.a, &p.b, 0), oracle_collide(&p.a, &p.b));
  }
}

/* AABBs decide exactly at the margin; limits nest; both triangles are alike. */
CASE(test_bands) {
  sepax_design design = design_of("--clearance=5 --warning=20");
  assert_int_equal(design.margin[0], 6);
  assert_int_equal(design.margin[1], 21);
  sepax_tri a = {{{0, 0, 0}, {100, 0, 0}, {0, 100, 0}}};
  static const struct {
    int32_t gap;
    sepax_band band;
  } row[] = {{0, SEPAX_BAND_COLLISION},
             {6, SEPAX_BAND_COLLISION},
             {7, SEPAX_BAND_WARNING},
             {21, SEPAX_BAND_WARNING},
             {22, SEPAX_BAND_FREE}};
  for (size_t i = 0; i < LENGTH(row); i++) {
    sepax_tri b = {{{0, 0, row[i].gap}, {100, 0, row[i].gap}, {0, 100, row[i].gap}}};
    sepax_judgement v = sepax_clearance(&design, &a, &b);
    assert_int_equal(v.band, row[i].band);
    assert_int_equal(v.axis, row[i].band == SEPAX_BAND_COLLISION ? 0 : SEPAX_AXIS_AABB);
    assert_int_equal(v.coplanar, row[i].gap == 0);
  }
}

CASE(test_symmetry) {
  sepax_random random = {5};
  sepax_design design = design_of("--clearance=2 --warning=9");
  for (size_t n = 0; n < FEWER(50000); n++) {
    real_pair p = pair_near(n, 4, &random);
    sepax_band band = sepax_clearance(&design, &p.rounded_a, &p.rounded_b).band;
    sepax_tri turned;
    sepax_tri other;
    for (size_t k = 0; k < 3; k++) {
      sepax_vec v = p.rounded_a.v[(k + n) % 3];
      sepax_vec w = p.rounded_b.v[2 - k];
      turned.v[k] = (sepax_vec){v.y, v.z, v.x};
      other.v[k] = (sepax_vec){w.y, w.z, w.x};
    }
    assert_int_equal(sepax_clearance(&design, &other, &turned).band, band);
  }
}
