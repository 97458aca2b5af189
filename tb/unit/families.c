/* SPDX-License-Identifier: MIT */
/* families.c - the random stream and the families of hard pairs. */
#include <string.h>

#include "oracle/pair_tools.h"
#include "harness.h"

#ifndef VECTOR_PAIRS
#define VECTOR_PAIRS 2000
#endif

/* ------------------------------------------------------------- random numbers */

CASE(random_is_splitmix64) {
  sepax_random random = {0};
  assert_int_equal(sepax_random_next(&random), UINT64_C(0xe220a8397b1dcdaf));
  assert_int_equal(sepax_random_next(&random), UINT64_C(0x6e789e6aa1b965f4));
  assert_int_equal(sepax_random_next(&random), UINT64_C(0x06c45d188009454f));
}

/* Chi-squared with 6 degrees of freedom: 33 is exceeded once in 100000. */
CASE(range_is_uniform) {
  enum { EXPECTED = 10000, DRAWS = 7 * EXPECTED };
  sepax_random random = {1};
  int count[7] = {0};
  for (int i = 0; i < DRAWS; i++) {
    int64_t value = sepax_random_range(&random, -3, 3);
    assert_in_range(value + 3, 0, 6);
    count[value + 3]++;
  }
  double chi = 0;
  for (int i = 0; i < 7; i++) {
    double excess = count[i] - EXPECTED;
    chi += excess * excess / EXPECTED;
  }
  assert_true(chi < 33);
}

/* A modulo would draw the lower half of a span of 3/4 2^64 twice as often. */
CASE(range_is_unbiased) {
  enum { DRAWS = 30000 };
  sepax_random random = {2};
  int64_t hi = INT64_MIN + 3 * (INT64_MAX / 4);
  int low = 0;
  for (int i = 0; i < DRAWS; i++) {
    int64_t value = sepax_random_range(&random, INT64_MIN, hi);
    assert_true(value <= hi);
    low += value < INT64_MIN + INT64_MAX / 4;
  }
  assert_in_range(low, DRAWS / 3 - 600, DRAWS / 3 + 600);
}

static void assert_spread(int64_t lo, int64_t hi) {
  sepax_random random = {3};
  bool quarter[4] = {false};
  int64_t step = hi / 4 - lo / 4;
  for (int i = 0; i < 200; i++) {
    int64_t value = sepax_random_range(&random, lo, hi);
    assert_true(lo <= value && value <= hi);
    int at = value < lo + step ? 0 : value < lo + 2 * step ? 1 : value < hi - step ? 2 : 3;
    quarter[at] = true;
  }
  assert_true(quarter[0] && quarter[1] && quarter[2] && quarter[3]);
}

CASE(range_spans) {
  sepax_random random = {4};
  assert_int_equal(sepax_random_range(&random, -7, -7), -7);
  assert_int_equal(sepax_random_range(&random, INT64_MAX, INT64_MAX), INT64_MAX);
  assert_spread(INT32_MIN, INT32_MAX);
  assert_spread(0, UINT32_MAX);
  assert_spread(INT64_MIN, INT64_MAX);
}

/* ------------------------------------------------------------- what families are */

/* How many of 100 pairs of a family have the property, at each W; family NULL: of
 * every family. */
typedef struct {
  const char *family;
  property *holds;
  int least, most;
} expectation;

static const expectation expectations[] = {
    {NULL, legal, 100, 100},
    {"uniform", collides, 22, 35},
    {"uniform", coplanar, 0, 1},
    {"local", collides, 35, 75},
    {"local", aabbs_overlap, 80, 100},
    {"local", small, 100, 100},
    {"touch-face", collides, 40, 75},
    {"touch-face", vertex_on_face, 20, 55},
    {"touch-face", both_have_area, 95, 100},
    {"touch-edge", collides, 35, 65},
    {"touch-edge", vertex_on_edge, 20, 45},
    {"touch-edge", both_have_area, 95, 100},
    {"touch-edges", collides, 40, 75},
    {"touch-edges", edge_on_edge, 20, 55},
    {"touch-edges", both_have_area, 95, 100},
    {"coplanar", collides, 55, 80},
    {"coplanar", coplanar, 100, 100},
    {"coplanar", both_have_area, 100, 100},
    {"coplanar", same_orientation, 40, 60},
    {"almost-coplanar", collides, 35, 65},
    {"almost-coplanar", almost_coplanar, 100, 100},
    {"almost-coplanar", coplanar, 0, 0},
    {"parallel", collides, 20, 45},
    {"parallel", normals_parallel, 100, 100},
    {"parallel", same_orientation, 40, 60},
    {"parallel", coplanar, 45, 55},
    {"sliver", collides, 50, 75},
    {"sliver", has_sliver, 100, 100},
    {"shared-vertex", collides, 45, 55},
    {"shared-vertex", one_common, 45, 55},
    {"shared-vertex", two_common, 0, 10},
    {"shared-edge", collides, 45, 55},
    {"shared-edge", two_common, 45, 55},
    {"shared-edge", coplanar, 12, 25},
    {"degenerate", collides, 35, 65},
    {"degenerate", both_have_area, 0, 0},
    {"degenerate", a_has_area, 20, 40},
    {"degenerate", is_point, 30, 60},
    {"identical", collides, 45, 55},
    {"identical", three_common, 45, 55},
    {"identical", same_order, 5, 12},
    {"identical", same_orientation, 40, 60},
    {"big-tiny", collides, 30, 60},
    {"big-tiny", has_tiny, 100, 100},
    {"big-tiny", a_is_tiny, 40, 75},
    {"tangent", collides, 30, 60},
    {"tangent", tangent, 100, 100},
    {"tangent", coplanar, 0, 0},
    {"corners", collides, 25, 36},
    {"corners", at_corners, 100, 100},
    {"corners", at_least_value, 80, 100},
    {"corners", at_greatest_value, 80, 100},
    {"grid", collides, 45, 60},
    {"grid", on_grid, 100, 100},
};

/* At how many word lengths this is not so. */
static int count_misses(const expectation *e, size_t family) {
  int misses = 0;
  for (int word = SEPAX_WORD_MIN; word <= SEPAX_WORD_MAX; word += STEP) {
    sepax_random random = seeded(family, word);
    int count = 0;
    for (int i = 0; i < VECTOR_PAIRS; i++) {
      sepax_pair pair = sepax_family_pair(family, word, &random);
      count += e->holds(&pair, word);
    }
    if (100 * count < e->least * VECTOR_PAIRS || 100 * count > e->most * VECTOR_PAIRS) {
      print_error("%s, W = %d: %d of %d, expected %d ... %d %%\n", sepax_family_name(family), word,
                  count, VECTOR_PAIRS, e->least, e->most);
      misses++;
    }
  }
  return misses;
}

CASE(families_are_what_they_say) {
  int misses = 0;
  size_t expected[64] = {0};
  for (size_t i = 0; i < LENGTH(expectations); i++) {
    const expectation *e = &expectations[i];
    size_t first = e->family == NULL ? 0 : family_number(e->family);
    size_t last = e->family == NULL ? family_count() - 1 : first;
    assert_true(last < family_count());
    for (size_t family = first; family <= last; family++) {
      misses += count_misses(e, family);
    }
    expected[first] += e->family != NULL;
  }
  assert_int_equal(misses, 0);
  for (size_t family = 0; family < family_count(); family++) {
    assert_true(expected[family] > 0);
  }
}

/* Families that are moved to any place get to both ends of the range. */
CASE(families_reach_the_ends) {
  static const expectation ends[] = {{NULL, at_least_value, 10, 100},
                                     {NULL, at_greatest_value, 10, 100}};
  for (size_t family = 0; family < family_count(); family++) {
    const char *name = sepax_family_name(family);
    if (strstr("uniform, tangent, grid", name) == NULL) {
      assert_int_equal(count_misses(&ends[0], family) + count_misses(&ends[1], family), 0);
    }
  }
}

/* -------------------------------------------------------------- table and streams */

CASE(names_are_a_table) {
  assert_int_equal(family_count(), 17);
  for (size_t i = 0; i < family_count(); i++) {
    const char *name = sepax_family_name(i);
    assert_int_equal(strspn(name, "abcdefghijklmnopqrstuvwxyz-"), strlen(name));
    assert_int_equal(family_number(name), i);
    assert_in_range(strlen(sepax_family_about(i)), 10, 60);
    assert_null(strchr(sepax_family_about(i), '\n'));
  }
  assert_null(sepax_family_name(family_count()));
  assert_null(sepax_family_about(family_count()));
  assert_null(sepax_family_name(SIZE_MAX));
  assert_null(sepax_family_about(SIZE_MAX));
}

/* FNV-1a over the coordinates of 100 pairs. */
static uint64_t stream_hash(size_t family, int word, uint64_t seed) {
  sepax_random random = {seed};
  uint64_t hash = UINT64_C(14695981039346656037);
  for (int n = 0; n < 100; n++) {
    sepax_pair pair = sepax_family_pair(family, word, &random);
    for (int i = 0; i < COORDINATES; i++) {
      hash = (hash ^ (uint32_t)field_of(&pair, i)) * UINT64_C(1099511628211);
    }
  }
  return hash;
}

CASE(streams_follow_the_seed) {
  for (size_t family = 0; family < family_count(); family++) {
    for (int word = SEPAX_WORD_MIN; word <= SEPAX_WORD_MAX; word++) {
      uint64_t hash = stream_hash(family, word, 7);
      assert_int_equal(hash, stream_hash(family, word, 7));
      assert_int_not_equal(hash, stream_hash(family, word, 8));
    }
  }
}

/* Recorded vectors stay reproducible: a change of a family or of the compiler that
 * changes the stream has to change this number too. */
CASE(streams_are_frozen) {
  uint64_t all = 0;
  for (size_t family = 0; family < family_count(); family++) {
    all = all * 31 + stream_hash(family, 18, 1);
  }
  assert_int_equal(all, UINT64_C(0x2e6757a7a5c66ae4));
}
