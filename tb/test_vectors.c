/* test_vectors - the random stream, the families of hard pairs and pairs as text. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdlib.h>
#include <string.h>
#include <sys/types.h>

#include "sepax.h"

#ifndef VECTOR_PAIRS
#define VECTOR_PAIRS 2000
#endif
#define LENGTH(array) (sizeof(array) / sizeof *(array))

typedef __int128 wide;

static size_t family_count(void) {
  size_t count = 0;
  while (sepax_family_name(count) != NULL) {
    count++;
  }
  return count;
}

static size_t family_number(const char *name) {
  size_t family = 0;
  while (family < family_count() && strcmp(sepax_family_name(family), name) != 0) {
    family++;
  }
  return family;
}

static sepax_random seeded(size_t family, int word) {
  return (sepax_random){1000 * (uint64_t)family + (uint64_t)word};
}

/* ------------------------------------------------------------- random numbers */

static void random_is_splitmix64(void **state) {
  (void)state;
  sepax_random random = {0};
  assert_int_equal(sepax_random_next(&random), UINT64_C(0xe220a8397b1dcdaf));
  assert_int_equal(sepax_random_next(&random), UINT64_C(0x6e789e6aa1b965f4));
  assert_int_equal(sepax_random_next(&random), UINT64_C(0x06c45d188009454f));
}

/* Chi-squared with 6 degrees of freedom: 33 is exceeded once in 100000. */
static void range_is_uniform(void **state) {
  (void)state;
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
static void range_is_unbiased(void **state) {
  (void)state;
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

static void range_spans(void **state) {
  (void)state;
  sepax_random random = {4};
  assert_int_equal(sepax_random_range(&random, -7, -7), -7);
  assert_int_equal(sepax_random_range(&random, INT64_MAX, INT64_MAX), INT64_MAX);
  assert_spread(INT32_MIN, INT32_MAX);
  assert_spread(0, UINT32_MAX);
  assert_spread(INT64_MIN, INT64_MAX);
}

/* ------------------------------------------------------------------- geometry */

typedef struct {
  wide c[3];
} vec;

static vec between(sepax_vec from, sepax_vec to) {
  return (vec){{(wide)to.x - from.x, (wide)to.y - from.y, (wide)to.z - from.z}};
}

static vec cross(vec p, vec q) {
  return (vec){{p.c[1] * q.c[2] - p.c[2] * q.c[1], p.c[2] * q.c[0] - p.c[0] * q.c[2],
                p.c[0] * q.c[1] - p.c[1] * q.c[0]}};
}

static wide dot(vec p, vec q) {
  return p.c[0] * q.c[0] + p.c[1] * q.c[1] + p.c[2] * q.c[2];
}

static bool is_zero(vec p) { return p.c[0] == 0 && p.c[1] == 0 && p.c[2] == 0; }

static wide gcd(wide p, wide q) {
  while (q != 0) {
    wide rest = p % q;
    p = q;
    q = rest;
  }
  return p < 0 ? -p : p;
}

static vec normal(const sepax_tri *t) {
  return cross(between(t->v[0], t->v[1]), between(t->v[0], t->v[2]));
}

/* The normal without its common factor, which is returned. */
static wide primitive(vec *n) {
  wide factor = gcd(gcd(n->c[0], n->c[1]), n->c[2]);
  for (int i = 0; i < 3 && factor != 0; i++) {
    n->c[i] /= factor;
  }
  return factor;
}

static bool equal(sepax_vec p, sepax_vec q) {
  return p.x == q.x && p.y == q.y && p.z == q.z;
}

static sepax_vec vertex(const sepax_pair *pair, int i) {
  return i < 3 ? pair->a.v[i] : pair->b.v[i - 3];
}

static int sign(wide value) { return (value > 0) - (value < 0); }

/* On which side of the line p q is r, with one coordinate left out. */
static int side(sepax_vec p, sepax_vec q, sepax_vec r, int dropped) {
  return sign(cross(between(p, q), between(p, r)).c[dropped]);
}

/* An axis along which a vector is not zero. */
static int pivot(vec n) { return n.c[0] != 0 ? 0 : n.c[1] != 0 ? 1 : 2; }

static bool on_face(sepax_vec p, const sepax_tri *t) {
  vec n = normal(t);
  if (is_zero(n) || dot(n, between(t->v[0], p)) != 0) {
    return false;
  }
  int dropped = pivot(n);
  int ahead = 0;
  int behind = 0;
  for (int k = 0; k < 3; k++) {
    int s = side(t->v[k], t->v[(k + 1) % 3], p, dropped);
    ahead += s > 0;
    behind += s < 0;
  }
  return ahead == 0 || behind == 0;
}

static bool on_edge(sepax_vec p, sepax_vec from, sepax_vec to) {
  vec ahead = between(p, to);
  vec behind = between(p, from);
  return is_zero(cross(ahead, behind)) && dot(ahead, behind) <= 0;
}

/* Two edges that are not parallel have a common point. */
static bool edges_meet(const sepax_vec e[2], const sepax_vec f[2]) {
  vec n = cross(between(e[0], e[1]), between(f[0], f[1]));
  if (is_zero(n) || dot(n, between(e[0], f[0])) != 0) {
    return false;
  }
  int d = pivot(n);
  return side(e[0], e[1], f[0], d) * side(e[0], e[1], f[1], d) <= 0 &&
         side(f[0], f[1], e[0], d) * side(f[0], f[1], e[1], d) <= 0;
}

static wide extent(const sepax_tri *t) {
  wide most = 0;
  for (int k = 0; k < 3; k++) {
    vec edge = between(t->v[k], t->v[(k + 1) % 3]);
    for (int i = 0; i < 3; i++) {
      wide length = edge.c[i] < 0 ? -edge.c[i] : edge.c[i];
      most = length > most ? length : most;
    }
  }
  return most;
}

/* ----------------------------------------------------------- what a pair may be */

typedef bool property(const sepax_pair *pair, int word);

static bool legal(const sepax_pair *pair, int word) {
  return sepax_pair_fits(pair, word) &&
         equal(pair->na, sepax_unit_normal(&pair->a, word)) &&
         equal(pair->nb, sepax_unit_normal(&pair->b, word));
}

static bool collides(const sepax_pair *pair, int word) {
  (void)word;
  return sepax_exact(&pair->a, &pair->b);
}

typedef struct {
  vec v[6];
} six;

static vec minus(vec p, vec q) {
  return (vec){{p.c[0] - q.c[0], p.c[1] - q.c[1], p.c[2] - q.c[2]}};
}

static six vertices(const sepax_pair *pair) {
  static const sepax_vec origin = {0, 0, 0};
  six s;
  for (int i = 0; i < 6; i++) {
    s.v[i] = between(origin, vertex(pair, i));
  }
  return s;
}

/* All 15 tetrahedra have no volume. */
static bool flat(const six *s) {
  for (int i = 0; i < 6; i++) {
    for (int j = i + 1; j < 6; j++) {
      for (int k = j + 1; k < 6; k++) {
        vec n = cross(minus(s->v[j], s->v[i]), minus(s->v[k], s->v[i]));
        for (int l = k + 1; l < 6; l++) {
          if (dot(n, minus(s->v[l], s->v[i])) != 0) {
            return false;
          }
        }
      }
    }
  }
  return true;
}

static bool coplanar(const sepax_pair *pair, int word) {
  (void)word;
  six s = vertices(pair);
  return flat(&s);
}

/* A move of one coordinate by 1 LSB, maybe out of the range, makes the pair flat. */
static bool almost_coplanar(const sepax_pair *pair, int word) {
  (void)word;
  six s = vertices(pair);
  for (int i = 0; i < 18; i++) {
    wide *c = &s.v[i / 3].c[i % 3];
    wide kept = *c;
    *c = kept + 1;
    bool found = flat(&s);
    *c = kept - 1;
    found = found || flat(&s);
    *c = kept;
    if (found) {
      return true;
    }
  }
  return false;
}

static bool has_area(const sepax_tri *t) { return !is_zero(normal(t)); }

static bool both_have_area(const sepax_pair *pair, int word) {
  (void)word;
  return has_area(&pair->a) && has_area(&pair->b);
}

static bool normals_parallel(const sepax_pair *pair, int word) {
  (void)word;
  vec a = normal(&pair->a);
  vec b = normal(&pair->b);
  return primitive(&a) != 0 && primitive(&b) != 0 && is_zero(cross(a, b));
}

static bool same_orientation(const sepax_pair *pair, int word) {
  (void)word;
  vec a = normal(&pair->a);
  vec b = normal(&pair->b);
  return sign(a.c[pivot(a)]) == sign(b.c[pivot(a)]);
}

static int common_vertices(const sepax_pair *pair) {
  int count = 0;
  for (int i = 0; i < 3; i++) {
    sepax_vec p = pair->a.v[i];
    const sepax_vec *b = pair->b.v;
    count += equal(p, b[0]) || equal(p, b[1]) || equal(p, b[2]);
  }
  return count;
}

static bool one_common(const sepax_pair *pair, int word) {
  (void)word;
  return common_vertices(pair) >= 1;
}

static bool two_common(const sepax_pair *pair, int word) {
  (void)word;
  return common_vertices(pair) >= 2;
}

static bool three_common(const sepax_pair *pair, int word) {
  (void)word;
  return common_vertices(pair) == 3;
}

static bool same_order(const sepax_pair *pair, int word) {
  (void)word;
  return equal(pair->a.v[0], pair->b.v[0]) && equal(pair->a.v[1], pair->b.v[1]);
}

static bool vertex_on_face(const sepax_pair *pair, int word) {
  (void)word;
  for (int i = 0; i < 6; i++) {
    if (on_face(vertex(pair, i), i < 3 ? &pair->b : &pair->a)) {
      return true;
    }
  }
  return false;
}

static bool vertex_on_edge(const sepax_pair *pair, int word) {
  (void)word;
  for (int i = 0; i < 6; i++) {
    const sepax_tri *other = i < 3 ? &pair->b : &pair->a;
    for (int k = 0; k < 3; k++) {
      if (on_edge(vertex(pair, i), other->v[k], other->v[(k + 1) % 3])) {
        return true;
      }
    }
  }
  return false;
}

static bool edge_on_edge(const sepax_pair *pair, int word) {
  (void)word;
  for (int i = 0; i < 3; i++) {
    const sepax_vec e[2] = {pair->a.v[i], pair->a.v[(i + 1) % 3]};
    for (int k = 0; k < 3; k++) {
      const sepax_vec f[2] = {pair->b.v[k], pair->b.v[(k + 1) % 3]};
      if (edges_meet(e, f)) {
        return true;
      }
    }
  }
  return false;
}

static double square(vec p) {
  double total = 0;
  for (int i = 0; i < 3; i++) {
    total += (double)p.c[i] * (double)p.c[i];
  }
  return total;
}

/* Long, and no higher than 1.5 LSB in one direction and 0.5 in the others. */
static bool is_sliver(const sepax_tri *t, int word) {
  double longest = 0;
  for (int k = 0; k < 3; k++) {
    double length = square(between(t->v[k], t->v[(k + 1) % 3]));
    longest = length > longest ? length : longest;
  }
  return square(normal(t)) < 2.8 * longest && extent(t) >= sepax_word_max(word) / 6;
}

static bool has_sliver(const sepax_pair *pair, int word) {
  return is_sliver(&pair->a, word) || is_sliver(&pair->b, word);
}

static bool is_tiny(const sepax_tri *t, int word) {
  return extent(t) <= (word > 6 ? (wide)1 << (word - 5) : 2);
}

static bool has_tiny(const sepax_pair *pair, int word) {
  return is_tiny(&pair->a, word) || is_tiny(&pair->b, word);
}

static bool a_is_tiny(const sepax_pair *pair, int word) {
  return is_tiny(&pair->a, word);
}

static bool a_has_area(const sepax_pair *pair, int word) {
  (void)word;
  return has_area(&pair->a);
}

static bool is_point(const sepax_pair *pair, int word) {
  (void)word;
  return extent(&pair->a) == 0 || extent(&pair->b) == 0;
}

static bool small(const sepax_pair *pair, int word) {
  wide most = sepax_word_max(word);
  return extent(&pair->a) <= most && extent(&pair->b) <= most;
}

static void box_along(const sepax_tri *t, int axis, int64_t box[2]) {
  box[0] = INT64_MAX;
  box[1] = INT64_MIN;
  for (int k = 0; k < 3; k++) {
    int64_t c[3] = {t->v[k].x, t->v[k].y, t->v[k].z};
    box[0] = c[axis] < box[0] ? c[axis] : box[0];
    box[1] = c[axis] > box[1] ? c[axis] : box[1];
  }
}

static bool boxes_overlap(const sepax_pair *pair, int word) {
  (void)word;
  for (int axis = 0; axis < 3; axis++) {
    int64_t a[2];
    int64_t b[2];
    box_along(&pair->a, axis, a);
    box_along(&pair->b, axis, b);
    if (a[1] < b[0] || b[1] < a[0]) {
      return false;
    }
  }
  return true;
}

static bool coordinate_at(const sepax_pair *pair, int64_t value) {
  for (int i = 0; i < 6; i++) {
    sepax_vec v = vertex(pair, i);
    if (v.x == value || v.y == value || v.z == value) {
      return true;
    }
  }
  return false;
}

static bool at_least_value(const sepax_pair *pair, int word) {
  return coordinate_at(pair, sepax_word_min(word));
}

static bool at_greatest_value(const sepax_pair *pair, int word) {
  return coordinate_at(pair, sepax_word_max(word));
}

static bool at_corners(const sepax_pair *pair, int word) {
  int64_t most = sepax_word_max(word);
  for (int i = 0; i < 6; i++) {
    sepax_vec v = vertex(pair, i);
    const int64_t c[3] = {v.x, v.y, v.z};
    for (int axis = 0; axis < 3; axis++) {
      int64_t size = c[axis] < 0 ? -c[axis] : c[axis];
      if (size > 1 && size < most - 1) {
        return false;
      }
    }
  }
  return true;
}

static bool on_grid(const sepax_pair *pair, int word) {
  (void)word;
  for (int i = 0; i < 6; i++) {
    sepax_vec v = vertex(pair, i);
    if (v.x < -1 || v.x > 1 || v.y < -1 || v.y > 1 || v.z < -1 || v.z > 1) {
      return false;
    }
  }
  return true;
}

/* A.N_A = B.N_B, exactly: equal levels and squares of the primitive normals. */
static bool tangent(const sepax_pair *pair, int word) {
  (void)word;
  static const sepax_vec origin = {0, 0, 0};
  vec a = normal(&pair->a);
  vec b = normal(&pair->b);
  bool areas = primitive(&a) != 0 && primitive(&b) != 0;
  return areas && dot(a, a) == dot(b, b) &&
         dot(a, between(origin, pair->a.v[0])) == dot(b, between(origin, pair->b.v[0]));
}

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
    {"local", boxes_overlap, 80, 100},
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
    {"parallel", collides, 0, 0},
    {"parallel", normals_parallel, 100, 100},
    {"parallel", same_orientation, 40, 60},
    {"parallel", coplanar, 0, 0},
    {"sliver", collides, 50, 75},
    {"sliver", has_sliver, 100, 100},
    {"shared-vertex", collides, 100, 100},
    {"shared-vertex", one_common, 100, 100},
    {"shared-vertex", two_common, 0, 10},
    {"shared-edge", collides, 100, 100},
    {"shared-edge", two_common, 100, 100},
    {"shared-edge", coplanar, 25, 50},
    {"degenerate", collides, 35, 65},
    {"degenerate", both_have_area, 0, 0},
    {"degenerate", a_has_area, 20, 40},
    {"degenerate", is_point, 30, 60},
    {"identical", collides, 100, 100},
    {"identical", three_common, 100, 100},
    {"identical", same_order, 10, 25},
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

static int count_holding(const expectation *e, size_t family, int word) {
  sepax_random random = seeded(family, word);
  int count = 0;
  for (int i = 0; i < VECTOR_PAIRS; i++) {
    sepax_pair pair = sepax_family_pair(family, word, &random);
    count += e->holds(&pair, word);
  }
  return count;
}

static int count_misses(const expectation *e, size_t index, size_t family) {
  int misses = 0;
  for (int word = SEPAX_WORD_MIN; word <= SEPAX_WORD_MAX; word++) {
    int count = count_holding(e, family, word);
    if (100 * count < e->least * VECTOR_PAIRS || 100 * count > e->most * VECTOR_PAIRS) {
      print_error("expectation %zu, %s, W = %d: %d of %d, expected %d ... %d %%\n", index,
                  sepax_family_name(family), word, count, VECTOR_PAIRS, e->least,
                  e->most);
      misses++;
    }
  }
  return misses;
}

static void families_are_what_they_say(void **state) {
  (void)state;
  int misses = 0;
  for (size_t i = 0; i < LENGTH(expectations); i++) {
    const expectation *e = &expectations[i];
    bool all = e->family == NULL;
    size_t first = all ? 0 : family_number(e->family);
    size_t last = all ? family_count() - 1 : first;
    assert_true(last < family_count());
    for (size_t family = first; family <= last; family++) {
      misses += count_misses(e, i, family);
    }
  }
  assert_int_equal(misses, 0);
}

static void every_family_is_expected(void **state) {
  (void)state;
  for (size_t family = 0; family < family_count(); family++) {
    size_t found = 0;
    for (size_t i = 1; i < LENGTH(expectations); i++) {
      found += strcmp(expectations[i].family, sepax_family_name(family)) == 0;
    }
    assert_true(found > 0);
  }
}

static bool lies_anywhere(const char *family) {
  static const char *const others[] = {"uniform", "tangent", "grid"};
  for (size_t i = 0; i < LENGTH(others); i++) {
    if (strcmp(family, others[i]) == 0) {
      return false;
    }
  }
  return true;
}

/* Families that are moved to any place get to both ends of the range. */
static void families_reach_the_ends(void **state) {
  (void)state;
  for (size_t family = 0; family < family_count(); family++) {
    const char *name = sepax_family_name(family);
    const expectation ends[] = {{name, at_least_value, 10, 100},
                                {name, at_greatest_value, 10, 100}};
    if (lies_anywhere(name)) {
      assert_int_equal(count_misses(&ends[0], 0, family), 0);
      assert_int_equal(count_misses(&ends[1], 1, family), 0);
    }
  }
}

/* -------------------------------------------------------------- table and streams */

static void names_are_a_table(void **state) {
  (void)state;
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

static uint64_t mixed(uint64_t hash, int32_t value) {
  return (hash ^ (uint32_t)value) * UINT64_C(1099511628211);
}

/* FNV-1a over the coordinates of 100 pairs. */
static uint64_t stream_hash(size_t family, int word, uint64_t seed) {
  sepax_random random = {seed};
  uint64_t hash = UINT64_C(14695981039346656037);
  for (int n = 0; n < 100; n++) {
    sepax_pair pair = sepax_family_pair(family, word, &random);
    for (int i = 0; i < 6; i++) {
      sepax_vec v = vertex(&pair, i);
      hash = mixed(mixed(mixed(hash, v.x), v.y), v.z);
    }
  }
  return hash;
}

static void streams_follow_the_seed(void **state) {
  (void)state;
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
static void streams_are_frozen(void **state) {
  (void)state;
  uint64_t all = 0;
  for (size_t family = 0; family < family_count(); family++) {
    all = all * 31 + stream_hash(family, 18, 1);
  }
  assert_int_equal(all, UINT64_C(0x506872d201c929ef));
}

/* ----------------------------------------------------------------- pairs as text */

#define EIGHTEEN "0 0 0 7 0 0 0 7 0 1 1 -3 1 1 3 2 2 3"

static const sepax_pair untouched = {
    {{{1, 2, 3}, {4, 5, 6}, {7, -1, -2}}},
    {{{-3, -4, -5}, {-6, -7, -8}, {0, 1, 2}}},
    {3, 4, 5},
    {-1, -2, -3}};

static bool same_pair(const sepax_pair *p, const sepax_pair *q) {
  for (int i = 0; i < 6; i++) {
    if (!equal(vertex(p, i), vertex(q, i))) {
      return false;
    }
  }
  return equal(p->na, q->na) && equal(p->nb, q->nb);
}

static bool fits_with(int32_t value, int field, int word) {
  sepax_pair pair = {0};
  sepax_vec *v[8] = {&pair.a.v[0], &pair.a.v[1], &pair.a.v[2], &pair.b.v[0],
                     &pair.b.v[1], &pair.b.v[2], &pair.na,     &pair.nb};
  int32_t *c[3] = {&v[field / 3]->x, &v[field / 3]->y, &v[field / 3]->z};
  *c[field % 3] = value;
  return sepax_pair_fits(&pair, word);
}

static void fits_looks_at_every_field(void **state) {
  (void)state;
  for (int word = SEPAX_WORD_MIN; word <= SEPAX_WORD_MAX; word++) {
    int32_t least = sepax_word_min(word);
    int32_t most = sepax_word_max(word);
    for (int field = 0; field < 24; field++) {
      assert_true(fits_with(least, field, word));
      assert_true(fits_with(most, field, word));
      if (word < SEPAX_WORD_MAX) {
        assert_false(fits_with(least - 1, field, word));
        assert_false(fits_with(most + 1, field, word));
      }
    }
  }
}

static void printing_is_24_integers(void **state) {
  (void)state;
  char text[256] = "";
  FILE *out = fmemopen(text, sizeof text, "w");
  assert_non_null(out);
  sepax_pair_print(out, &untouched);
  assert_int_equal(fclose(out), 0);
  assert_string_equal(text, "1 2 3 4 5 6 7 -1 -2 -3 -4 -5 -6 -7 -8 0 1 2 3 4 5 -1 -2 -3");
}

static void print_then_read(void **state) {
  (void)state;
  sepax_error error = {""};
  for (size_t family = 0; family < family_count(); family++) {
    for (int word = SEPAX_WORD_MIN; word <= SEPAX_WORD_MAX; word++) {
      sepax_random random = seeded(family, word);
      sepax_pair pair = sepax_family_pair(family, word, &random);
      pair.na.x = sepax_word_min(word);
      FILE *file = tmpfile();
      assert_non_null(file);
      sepax_pair_print(file, &pair);
      rewind(file);
      sepax_pair got;
      size_t number = 0;
      assert_int_equal(sepax_pair_read(&got, file, "x", &number, word, &error),
                       SEPAX_LINE_PAIR);
      assert_true(same_pair(&got, &pair));
      assert_int_equal(fclose(file), 0);
    }
  }
}

static void absent_normals_are_computed(void **state) {
  (void)state;
  sepax_error error = {""};
  sepax_pair pair;
  assert_int_equal(sepax_pair_parse(&pair, EIGHTEEN, 4, &error), SEPAX_LINE_PAIR);
  assert_true(legal(&pair, 4));
  assert_true(equal(pair.na, (sepax_vec){0, 0, 7}));
  assert_true(equal(pair.b.v[2], (sepax_vec){2, 2, 3}));
  assert_string_equal(error.text, "");
}

static void given_normals_are_taken(void **state) {
  (void)state;
  sepax_error error = {""};
  sepax_pair pair;
  assert_int_equal(sepax_pair_parse(&pair, EIGHTEEN " 1 2 3 -4 -5 -6", 4, &error),
                   SEPAX_LINE_PAIR);
  assert_true(equal(pair.na, (sepax_vec){1, 2, 3}));
  assert_true(equal(pair.nb, (sepax_vec){-4, -5, -6}));
}

static void spellings_are_tolerated(void **state) {
  (void)state;
  static const char *const lines[] = {
      EIGHTEEN "\n",
      EIGHTEEN "\r\n",
      EIGHTEEN "\r",
      EIGHTEEN " \t \n",
      EIGHTEEN "# with a comment\r\n",
      EIGHTEEN " # 1 2 3 # more, \t\r and 0x7f",
      (" \t" EIGHTEEN),
      "+0 -0 00 +7 0 0 0\t007 0 1 1 -3 1  1 3 2 2 3",
  };
  sepax_error error = {""};
  sepax_pair expected;
  assert_int_equal(sepax_pair_parse(&expected, EIGHTEEN, 4, &error), SEPAX_LINE_PAIR);
  for (size_t i = 0; i < LENGTH(lines); i++) {
    sepax_pair pair = untouched;
    assert_int_equal(sepax_pair_parse(&pair, lines[i], 4, &error), SEPAX_LINE_PAIR);
    assert_true(same_pair(&pair, &expected));
  }
}

static void empty_lines_are_empty(void **state) {
  (void)state;
  static const char *const lines[] = {"",           "\n", "\r\n",        "\r",
                                      " \t \r\n", "#",  "  # 1 2 3\n"};
  sepax_error error = {""};
  for (size_t i = 0; i < LENGTH(lines); i++) {
    sepax_pair pair = untouched;
    assert_int_equal(sepax_pair_parse(&pair, lines[i], 4, &error), SEPAX_LINE_EMPTY);
    assert_true(same_pair(&pair, &untouched));
    assert_string_equal(error.text, "");
  }
}

typedef struct {
  int word;
  const char *line, *message;
} refusal;

#define COUNT_MESSAGE                                                                   \
  " where 18 (A1x A1y A1z ... B3z) or 24 (with the normals N_A, N_B) are expected"

static const refusal refusals[] = {
    {4, "1", "1 number" COUNT_MESSAGE},
    {4, "1 2 3 4 5 6 7 1 2 3 4 5 6 7 1 2 3", "17 numbers" COUNT_MESSAGE},
    {4, "1 2 3 4 5 6 7 1 2 3 4 5 6 7 1 2 3 # 4", "17 numbers" COUNT_MESSAGE},
    {4, EIGHTEEN " 1", "19 numbers" COUNT_MESSAGE},
    {4, EIGHTEEN " 1 2 3 4 5", "23 numbers" COUNT_MESSAGE},
    {4, EIGHTEEN " 1 2 3 4 5 6 7", "25 numbers" COUNT_MESSAGE},
    {4, EIGHTEEN " " EIGHTEEN " 99", "37 numbers" COUNT_MESSAGE},
    {4, EIGHTEEN " 1 2 3 4 5 6 x", "number 25, 'x', is not a decimal integer"},
    {4, "0x1 2", "number 1, '0x1', is not a decimal integer"},
    {4, "1 2.0", "number 2, '2.0', is not a decimal integer"},
    {4, "1 2e3", "number 2, '2e3', is not a decimal integer"},
    {4, "1,2,3", "number 1, '1,2,3', is not a decimal integer"},
    {4, "1 -", "number 2, '-', is not a decimal integer"},
    {4, "+", "number 1, '+', is not a decimal integer"},
    {4, "+-1", "number 1, '+-1', is not a decimal integer"},
    {4, "--1", "number 1, '--1', is not a decimal integer"},
    {4, "1 nan", "number 2, 'nan', is not a decimal integer"},
    {4, "1\v2", "number 1, '1?2', is not a decimal integer"},
    {4, "1\r2\n", "number 1, '1?2', is not a decimal integer"},
    {4, "1 \r\r\n", "number 2, '?', is not a decimal integer"},
    {4, "\xef\xbb\xbf" "1", "number 1, '???1', is not a decimal integer"},
    {4, "1 2-", "number 2, '2-', is not a decimal integer"},
    {4, EIGHTEEN "\n" EIGHTEEN, "more than one line where one pair is expected"},
    {4, "# one\n2", "more than one line where one pair is expected"},
    {4, "0 0 0 0 9", "A2y = 9 does not fit W = 4 (-8 ... 7)"},
    {4, "-9", "A1x = -9 does not fit W = 4 (-8 ... 7)"},
    {4, "0 8", "A1y = 8 does not fit W = 4 (-8 ... 7)"},
    {4, "1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 +99", "B3z = +99 does not fit W = 4 (-8 ... 7)"},
    {4, EIGHTEEN " 8", "N_Ax = 8 does not fit W = 4 (-8 ... 7)"},
    {4, EIGHTEEN " 1 1 1 1 1 -9", "N_Bz = -9 does not fit W = 4 (-8 ... 7)"},
    {18, "131072", "A1x = 131072 does not fit W = 18 (-131072 ... 131071)"},
    {32, "2147483648",
     "A1x = 2147483648 does not fit W = 32 (-2147483648 ... 2147483647)"},
    {32, "-2147483649",
     "A1x = -2147483649 does not fit W = 32 (-2147483648 ... 2147483647)"},
    {32, "9223372036854775808",
     "A1x = 9223372036854775808 does not fit W = 32 (-2147483648 ... 2147483647)"},
    {32, "-18446744073709551616",
     "A1x = -18446744073709551616 does not fit W = 32 (-2147483648 ... 2147483647)"},
    {4, "123456789012345678901234567890123456789012345678901234567890",
     "A1x = 1234567890123456789012345678901234567890... does not fit W = 4 (-8 ... 7)"},
    {4, "123456789012345678901234567890123456789x",
     "number 1, '123456789012345678901234567890123456789x', is not a decimal integer"},
};

static void errors_say_what_is_wrong(void **state) {
  (void)state;
  for (size_t i = 0; i < LENGTH(refusals); i++) {
    const refusal *r = &refusals[i];
    sepax_error error = {""};
    sepax_pair pair = untouched;
    sepax_line kind = sepax_pair_parse(&pair, r->line, r->word, &error);
    assert_string_equal(error.text, r->message);
    assert_int_equal(kind, SEPAX_LINE_ERROR);
    assert_true(same_pair(&pair, &untouched));
  }
}

static void every_field_has_its_name(void **state) {
  (void)state;
  static const char names[] = "A1x A1y A1z A2x A2y A2z A3x A3y A3z "
                              "B1x B1y B1z B2x B2y B2z B3x B3y B3z "
                              "N_Ax N_Ay N_Az N_Bx N_By N_Bz";
  const char *name = names;
  for (size_t field = 0; field < 24; field++) {
    char line[64] = "";
    for (size_t i = 0; i < field; i++) {
      line[2 * i] = '0';
      line[2 * i + 1] = ' ';
    }
    line[2 * field] = '8';
    sepax_error error = {""};
    sepax_pair pair;
    assert_int_equal(sepax_pair_parse(&pair, line, 4, &error), SEPAX_LINE_ERROR);
    size_t length = strcspn(name, " ");
    assert_memory_equal(error.text, name, length);
    assert_memory_equal(error.text + length, " = 8 ", 5);
    name += length + 1;
  }
}

/* ----------------------------------------------------------------------- streams */

static FILE *stream_of(const char *text, size_t length) {
  FILE *file = tmpfile();
  assert_non_null(file);
  assert_int_equal(fwrite(text, 1, length, file), length);
  rewind(file);
  return file;
}

static void reading_counts_lines(void **state) {
  (void)state;
  static const char text[] = "# head\n\n" EIGHTEEN "\r\n \t\n# two\n1 2 3\n" EIGHTEEN
                             " 1 2 3 4 5 6 # last, without a line feed";
  FILE *in = stream_of(text, sizeof text - 1);
  sepax_error error = {""};
  sepax_pair pair;
  size_t number = 0;
  assert_int_equal(sepax_pair_read(&pair, in, "f", &number, 4, &error), SEPAX_LINE_PAIR);
  assert_int_equal(number, 3);
  assert_string_equal(error.text, "");
  sepax_pair first = pair;
  assert_int_equal(sepax_pair_read(&pair, in, "f", &number, 4, &error), SEPAX_LINE_ERROR);
  assert_int_equal(number, 6);
  assert_string_equal(error.text, "f:6: 3 numbers" COUNT_MESSAGE);
  assert_true(same_pair(&pair, &first));
  assert_int_equal(sepax_pair_read(&pair, in, "f", &number, 4, &error), SEPAX_LINE_PAIR);
  assert_int_equal(number, 7);
  assert_int_equal(pair.nb.z, 6);
  assert_int_equal(sepax_pair_read(&pair, in, "f", &number, 4, &error), SEPAX_LINE_EMPTY);
  assert_int_equal(sepax_pair_read(&pair, in, "f", &number, 4, &error), SEPAX_LINE_EMPTY);
  assert_int_equal(number, 7);
  fclose(in);
}

static void an_empty_stream_ends(void **state) {
  (void)state;
  FILE *in = stream_of("", 0);
  sepax_error error = {""};
  sepax_pair pair = untouched;
  size_t number = 0;
  assert_int_equal(sepax_pair_read(&pair, in, "f", &number, 4, &error), SEPAX_LINE_EMPTY);
  assert_int_equal(number, 0);
  assert_true(same_pair(&pair, &untouched));
  fclose(in);
}

static void assert_nul_refused(const char *text, size_t length) {
  FILE *in = stream_of(text, length);
  sepax_error error = {""};
  sepax_pair pair = untouched;
  size_t number = 0;
  assert_int_equal(sepax_pair_read(&pair, in, "f", &number, 4, &error), SEPAX_LINE_ERROR);
  assert_string_equal(error.text, "f:1: NUL byte where text is expected");
  assert_true(same_pair(&pair, &untouched));
  fclose(in);
}

static void nul_bytes_are_refused(void **state) {
  (void)state;
  static const char inside[] = EIGHTEEN "\0 1\n";
  static const char comment[] = EIGHTEEN " # \0\n";
  static const char alone[] = "\0\n";
  static const char last[] = EIGHTEEN "\0";
  assert_nul_refused(inside, sizeof inside - 1);
  assert_nul_refused(comment, sizeof comment - 1);
  assert_nul_refused(alone, sizeof alone - 1);
  assert_nul_refused(last, sizeof last - 1);
}

static void long_names_and_lines_fit(void **state) {
  (void)state;
  enum { LONG = 100000 };
  char *text = malloc(LONG + 1);
  assert_non_null(text);
  for (size_t i = 0; i < LONG; i++) {
    text[i] = 'n';
  }
  text[LONG] = '\0';
  FILE *in = stream_of(text, LONG);
  sepax_error error = {""};
  sepax_pair pair;
  size_t number = 0;
  assert_int_equal(sepax_pair_read(&pair, in, text, &number, 4, &error),
                   SEPAX_LINE_ERROR);
  assert_non_null(strstr(error.text, ":1: number 1, 'nnnn"));
  assert_non_null(strstr(error.text, "nn...', is not a decimal integer"));
  fclose(in);
  free(text);
}

static void read_failures_are_errors(void **state) {
  (void)state;
  FILE *in = fopen("/", "r");
  assert_non_null(in);
  sepax_error error = {""};
  sepax_pair pair = untouched;
  size_t number = 4;
  assert_int_equal(sepax_pair_read(&pair, in, "/", &number, 4, &error), SEPAX_LINE_ERROR);
  assert_memory_equal(error.text, "/:5: cannot read: ", 18);
  assert_true(strlen(error.text) > 20);
  assert_int_equal(number, 4);
  assert_true(same_pair(&pair, &untouched));
  fclose(in);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(random_is_splitmix64),
      cmocka_unit_test(range_is_uniform),
      cmocka_unit_test(range_is_unbiased),
      cmocka_unit_test(range_spans),
      cmocka_unit_test(names_are_a_table),
      cmocka_unit_test(every_family_is_expected),
      cmocka_unit_test(families_are_what_they_say),
      cmocka_unit_test(families_reach_the_ends),
      cmocka_unit_test(streams_follow_the_seed),
      cmocka_unit_test(streams_are_frozen),
      cmocka_unit_test(fits_looks_at_every_field),
      cmocka_unit_test(printing_is_24_integers),
      cmocka_unit_test(print_then_read),
      cmocka_unit_test(absent_normals_are_computed),
      cmocka_unit_test(given_normals_are_taken),
      cmocka_unit_test(spellings_are_tolerated),
      cmocka_unit_test(empty_lines_are_empty),
      cmocka_unit_test(errors_say_what_is_wrong),
      cmocka_unit_test(every_field_has_its_name),
      cmocka_unit_test(reading_counts_lines),
      cmocka_unit_test(an_empty_stream_ends),
      cmocka_unit_test(nul_bytes_are_refused),
      cmocka_unit_test(long_names_and_lines_fit),
      cmocka_unit_test(read_failures_are_errors),
  };
  return cmocka_run_group_tests_name("test_vectors", tests, NULL, NULL);
}
