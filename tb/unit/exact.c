/* SPDX-License-Identifier: MIT */
/* exact.c - checks the exact models against the oracle, and the oracle against known
 * answers. The counts of the exhaustive corpora were found by a third method, that
 * the origin is in the hull of the nine differences of vertices. */
#include "oracle/geometry.h"
#include "oracle/oracle.h"
#include "oracle/pair_tools.h"
#include "harness.h"

#define EXACT_PAIRS (FEWER_BY > 1 ? 100000 / FEWER_BY : 1000000)
#define SYMMETRY_PAIRS FEWER(4000)
#define MISMATCHES_SHOWN 20
#define AXES 13

typedef struct {
  size_t wrong;
  size_t count[2][2]; /* [collision][coplanar] */
  size_t axis[AXES];  /* that sepax_exact named */
} tally;

static void report(tally *t, const sepax_tri *a, const sepax_tri *b, bool expected, bool got) {
  sepax_pair pair = {.a = *a, .b = *b};
  for (int i = 0; i < COORDINATES; i++)
    print_error("%d ", (int)*field(&pair, i));
  print_error("expected %d got %d\n", expected, got);
  if (++t->wrong == MISMATCHES_SHOWN)
    fail_msg("%s", "too many mismatches, stopped");
}

/* ---------------------------------------------------------- the verdict's axis */

/* Axis 1 ... 11 as sepax.h numbers them. */
static wide_vec axis_vector(int axis, const sepax_tri *a, const sepax_tri *b) {
  if (axis == 10)
    return cross(edge(a, 0), edge(a, 1));
  if (axis == 11)
    return cross(edge(b, 0), edge(b, 1));
  return cross(edge(a, (axis - 1) / 3), edge(b, (axis - 1) % 3));
}

/* Axis 0 for a collision, 12 in a common plane, else one that separates. */
static bool right(const sepax_verdict *v, const sepax_tri *a, const sepax_tri *b, bool collision,
                  bool coplanar) {
  if (v->collision != collision || v->coplanar != coplanar)
    return false;
  if (collision)
    return v->axis == 0;
  if (coplanar)
    return v->axis == 12;
  return v->axis >= 1 && v->axis <= 11 && separates(axis_vector(v->axis, a, b), a, b);
}

/* The verdict is the same for the same pair a million LSB away, where coordinates of 20
 * bits have become longer. */
static bool steady(const sepax_verdict *v, const sepax_tri *a, const sepax_tri *b) {
  sepax_pair away = {.a = *a, .b = *b};
  for (int i = 0; i < COORDINATES; i++) {
    int32_t *c = field(&away, i);
    if (*c > INT32_MAX - (1 << 20))
      return true;
    *c += 1 << 20;
  }
  sepax_verdict u = sepax_exact(&away.a, &away.b);
  return u.collision == v->collision && u.coplanar == v->coplanar && u.axis == v->axis;
}

/* Check each exact model against what is expected and count the pair. */
static void judge(tally *t, const sepax_tri *a, const sepax_tri *b, bool expected, bool flat) {
  t->count[expected][flat]++;
  if (sepax_reference(a, b) != expected || sepax_sat54(a, b) != expected)
    report(t, a, b, expected, !expected);
  sepax_verdict exact = sepax_exact(a, b);
  t->axis[exact.axis]++;
  if (!right(&exact, a, b, expected, flat) || !steady(&exact, a, b)) {
    print_error("axis %d%s: ", exact.axis, exact.coplanar ? ", coplanar" : "");
    report(t, a, b, expected, exact.collision);
  }
}

/* Against the oracle. */
static void compare(tally *t, const sepax_tri *a, const sepax_tri *b) {
  judge(t, a, b, oracle_collide(a, b), oracle_coplanar(a, b));
}

static void assert_counts(const tally *t, size_t free_oblique, size_t free_coplanar,
                          size_t hit_oblique, size_t hit_coplanar) {
  assert_int_equal(t->wrong, 0);
  if (STEP > 1)
    return;
  assert_int_equal(t->count[0][0], free_oblique);
  assert_int_equal(t->count[0][1], free_coplanar);
  assert_int_equal(t->count[1][0], hit_oblique);
  assert_int_equal(t->count[1][1], hit_coplanar);
}

/* Each of the four kinds of pair makes at least 1 % of the corpus. */
static void assert_mixed(const tally *t, size_t pairs) {
  assert_int_equal(t->wrong, 0);
  for (size_t hit = 0; hit < 2; hit++)
    for (size_t flat = 0; flat < 2; flat++) {
      print_message("%s, %s: %zu of %zu\n", hit ? "collision" : "free",
                    flat ? "coplanar" : "not coplanar", t->count[hit][flat], pairs);
      assert_in_range(t->count[hit][flat], pairs / 100 + 1, pairs);
    }
}

/* ------------------------------------------------------------- known answers */

#define MIN INT32_MIN
#define MAX INT32_MAX
#define LOW (-(1 << 19)) /* of 20 bits; HIGH is not */
#define HIGH ((3 << 19) - 1)
#define THIRD (-715827883) /* (MAX + MIN + MIN) / 3, without remainder */
#define FLAT                            \
  {                                     \
    {                                   \
      {0, 0, 0}, {4, 0, 0}, { 0, 4, 0 } \
    }                                   \
  }
#define TRI(ax, ay, az, bx, by, bz, cx, cy, cz)  \
  {                                              \
    {                                            \
      {ax, ay, az}, {bx, by, bz}, { cx, cy, cz } \
    }                                            \
  }
#define POINT(x, y, z) TRI(x, y, z, x, y, z, x, y, z)

static const struct {
  const char *name;
  sepax_tri a, b;
  bool collision, coplanar;
} known[] = {
    {"vertex in face", FLAT, TRI(1, 1, 0, 1, 1, 3, 2, 2, 3), true, false},
    {"vertex above face", FLAT, TRI(1, 1, 1, 1, 1, 3, 2, 2, 3), false, false},
    {"vertex on edge", FLAT, TRI(2, 2, 0, 5, 5, 1, 5, 5, -1), true, false},
    {"vertex beside edge", FLAT, TRI(3, 2, 0, 5, 5, 1, 5, 5, -1), false, false},
    {"vertex on vertex", FLAT, TRI(4, 0, 0, 6, 0, 1, 6, 1, -1), true, false},
    {"edges cross at (1.5, 0, 0)", FLAT, TRI(1, -1, -1, 2, 1, 1, 2, -5, 1), true, false},
    {"edges pass at (1.5, -0.5, 0)", FLAT, TRI(1, -2, -1, 2, 1, 1, 2, -5, 1), false, false},
    {"edge pierces at (4/3, 1, 0)", FLAT, TRI(1, 1, -1, 2, 1, 2, 9, 9, 9), true, false},
    {"edge beside face", FLAT, TRI(5, 1, -2, 5, 1, 2, 9, 9, 0), false, false},
    {"parallel", FLAT, TRI(0, 0, 1, 4, 0, 1, 0, 4, 1), false, false},
    {"identical", FLAT, FLAT, true, true},
    {"contained", TRI(0, 0, 0, 12, 0, 0, 0, 12, 0), TRI(2, 2, 0, 4, 2, 0, 2, 4, 0), true, true},
    {"star", TRI(0, 0, 0, 6, 0, 0, 3, 6, 0), TRI(0, 4, 0, 6, 4, 0, 3, -2, 0), true, true},
    {"coplanar, disjoint", FLAT, TRI(5, 0, 0, 9, 0, 0, 5, 4, 0), false, true},
    {"coplanar, AABBs overlap", FLAT, TRI(4, 4, 0, 4, 1, 0, 1, 4, 0), false, true},
    {"coplanar, common edge", FLAT, TRI(4, 0, 0, 0, 4, 0, 4, 4, 0), true, true},
    {"coplanar, part of an edge", FLAT, TRI(1, 0, 0, 2, 0, 0, 1, -3, 0), true, true},
    {"coplanar, common vertex", FLAT, TRI(4, 0, 0, 8, 0, 0, 8, 4, 0), true, true},
    {"oblique plane, disjoint", TRI(6, 0, 0, 0, 6, 0, 0, 0, 6), TRI(7, -1, 0, 8, -2, 0, 8, -1, -1),
     false, true},
    {"segment pierces", FLAT, TRI(1, 1, -1, 1, 1, 1, 1, 1, 0), true, false},
    {"segment above", FLAT, TRI(1, 1, 1, 1, 1, 2, 1, 1, 3), false, false},
    {"segment across", FLAT, TRI(-1, 1, 0, 9, 1, 0, -1, 1, 0), true, true},
    {"segment beside", FLAT, TRI(5, 0, 0, 5, 9, 0, 5, 1, 0), false, true},
    {"segments skew", TRI(0, 0, 0, 2, 0, 0, 1, 0, 0), TRI(1, -1, 1, 1, 1, 1, 1, 0, 1), false,
     false},
    {"segments cross", TRI(0, 0, 0, 2, 0, 0, 1, 0, 0), TRI(1, -1, 0, 2, 1, 0, 1, -1, 0), true,
     true},
    {"segments in line, disjoint", TRI(0, 0, 0, 1, 1, 1, 2, 2, 2), TRI(3, 3, 3, 5, 5, 5, 4, 4, 4),
     false, true},
    {"segments end to end", TRI(0, 0, 0, 1, 1, 1, 2, 2, 2), TRI(2, 2, 2, 5, 5, 5, 4, 4, 4), true,
     true},
    {"segments parallel", TRI(0, 0, 0, 1, 1, 1, 2, 2, 2), TRI(0, 0, 1, 1, 1, 2, 2, 2, 3), false,
     true},
    {"point in face", FLAT, POINT(1, 1, 0), true, true},
    {"point on edge", FLAT, POINT(2, 2, 0), true, true},
    {"point beside", FLAT, POINT(3, 2, 0), false, true},
    {"point above", FLAT, POINT(1, 1, 1), false, false},
    {"point on segment", TRI(0, 0, 0, 3, 6, 9, 0, 0, 0), POINT(1, 2, 3), true, true},
    {"point behind segment", TRI(0, 0, 0, 3, 6, 9, 0, 0, 0), POINT(4, 8, 12), false, true},
    {"equal points", POINT(1, 2, 3), POINT(1, 2, 3), true, true},
    {"two points", POINT(1, 2, 3), POINT(1, 2, 4), false, true},
    {"2^21 LSB wide, a volume above 2^63", TRI(LOW, LOW, LOW, HIGH, HIGH, LOW, HIGH, LOW, HIGH),
     TRI(LOW, HIGH, HIGH, -LOW, -LOW, -LOW, -LOW, 1 - LOW, -LOW), false, false},
    {"extreme, vertex in face", TRI(MAX, MIN, MIN, MIN, MAX, MIN, MIN, MIN, MAX),
     TRI(THIRD, THIRD, THIRD, MAX, MAX, MAX, MAX, MAX, 0), true, false},
    {"extreme, vertex above face", TRI(MAX, MIN, MIN, MIN, MAX, MIN, MIN, MIN, MAX),
     TRI(THIRD + 1, THIRD, THIRD, MAX, MAX, MAX, MAX, MAX, 0), false, false},
    {"extreme, 2^-32 LSB in", TRI(MIN, MIN, 0, MAX, MAX - 1, 0, MIN, MAX, 0),
     POINT(MIN + 1, MIN + 1, 0), true, true},
    {"extreme, 2^-32 LSB out", TRI(MIN, MIN, 0, MAX, MAX - 1, 0, MAX, MIN, 0),
     POINT(MIN + 1, MIN + 1, 0), false, true},
    {"extreme, diagonals cross", TRI(MIN, MIN, MIN, MAX, MAX, MAX, MIN, MIN, MAX),
     TRI(MAX, MIN, MIN, MIN, MAX, MAX, MAX, MIN, MAX), true, false},
    {"extreme, opposite corners", TRI(MIN, MIN, MIN, 0, MIN, MIN, MIN, 0, MIN),
     TRI(MAX, MAX, MAX, 0, MAX, MAX, MAX, 0, MAX), false, false},
};

CASE(test_known) {
  tally t = {0};
  for (size_t i = 0; i < LENGTH(known); i++)
    for (size_t swap = 0; swap < 2; swap++) {
      const sepax_tri *a = swap ? &known[i].b : &known[i].a;
      const sepax_tri *b = swap ? &known[i].a : &known[i].b;
      if (oracle_collide(a, b) != known[i].collision ||
          oracle_coplanar(a, b) != known[i].coplanar) {
        print_error("oracle, %s: ", known[i].name);
        report(&t, a, b, known[i].collision, !known[i].collision);
      }
      compare(&t, a, b);
    }
  assert_mixed(&t, 2 * LENGTH(known));
}

/* ----------------------------------------------------------------- exhaustive */

/* Place `digit` of a corpus, of its variant. */
typedef sepax_vec place(int32_t digit, int variant);

/* Every pair of triangles with vertices at `places` places, in each variant. Variants are turned,
 * which changes no answer: the oracle gives that of the first, and now and then says so. */
static tally all_pairs(uint32_t places, place *at, int variants) {
  tally t = {0};
  uint32_t codes = places * places * places;
  codes *= codes;
  for (uint32_t code = 0; code < codes; code += STEP) {
    bool expected = false;
    bool flat = false;
    for (int variant = 0; variant < variants; variant++) {
      sepax_tri tri[2];
      uint32_t rest = code;
      for (size_t k = 0; k < 6; k++) {
        tri[k / 3].v[k % 3] = at((int32_t)(rest % places), variant);
        rest /= places;
      }
      if (variant == 0) {
        expected = oracle_collide(&tri[0], &tri[1]);
        flat = oracle_coplanar(&tri[0], &tri[1]);
      } else if (code % 16 == 0) {
        assert_int_equal(oracle_collide(&tri[0], &tri[1]), expected);
        assert_int_equal(oracle_coplanar(&tri[0], &tri[1]), flat);
      }
      judge(&t, &tri[0], &tri[1], expected, flat);
    }
  }
  return t;
}

static sepax_vec in_cube(int32_t digit, int variant) {
  (void)variant;
  return (sepax_vec){digit & 1, digit >> 1 & 1, digit >> 2 & 1};
}

/* {-1, 0, 1}^2 in the plane (x, y), (y, z) or (z, x). */
static sepax_vec in_plane(int32_t digit, int variant) {
  sepax_vec v = {0, 0, 0};
  *coordinate(&v, variant) = digit % 3 - 1;
  *coordinate(&v, (variant + 1) % 3) = digit / 3 - 1;
  return v;
}

/* Of an oblique line. */
static sepax_vec in_line(int32_t digit, int variant) {
  (void)variant;
  return (sepax_vec){2 - digit, 3, 2 * digit};
}

CASE(test_cube) {
  tally t = all_pairs(8, in_cube, 1);
  assert_counts(&t, 60528, 4376, 150912, 46328);
}

CASE(test_plane) {
  tally t = all_pairs(9, in_plane, 3);
  assert_counts(&t, 0, 3 * 91320, 0, 3 * 440121);
}

CASE(test_line) {
  tally t = all_pairs(6, in_line, 1);
  assert_counts(&t, 0, 2886, 0, 43770);
}

/* Vertices drawn from a grid of 3 x 3 x 3: every seldom coincidence comes often. */
CASE(test_grid) {
  tally t = {0};
  sepax_random random = {3};
  for (size_t i = 0; i < EXACT_PAIRS; i++) {
    sepax_tri tri[2];
    for (size_t k = 0; k < 6; k++) {
      uint64_t draw = sepax_random_next(&random) >> 32;
      tri[k / 3].v[k % 3] =
          (sepax_vec){(int32_t)(draw % 3), (int32_t)(draw / 3 % 3), (int32_t)(draw / 9 % 3)};
    }
    compare(&t, &tri[0], &tri[1]);
  }
  assert_int_equal(t.wrong, 0);
  for (size_t axis = 0; axis < AXES; axis++)
    assert_in_range(t.axis[axis], EXACT_PAIRS / 1000, EXACT_PAIRS);
}

/* ----------------------------------------------------------------- hard pairs */

/* Pair i of a corpus: all words, then the next family. */
static sepax_pair hard_pair(size_t i, sepax_random *random) {
  static const int word[] = {4, 8, 12, 16, 18, 20, 24, 32};
  int w = word[i % LENGTH(word)];
  sepax_pair pair = mixed_pair(i / LENGTH(word), w, random);
  assert_true(sepax_pair_fits(&pair, w));
  return pair;
}

CASE(test_hard) {
  tally t = {0};
  sepax_random random = {1};
  for (size_t i = 0; i < EXACT_PAIRS; i++) {
    sepax_pair pair = hard_pair(i, &random);
    compare(&t, &pair.a, &pair.b);
  }
  assert_mixed(&t, EXACT_PAIRS);
  for (size_t axis = 0; axis < AXES; axis++) {
    print_message("axis %zu: %zu\n", axis, t.axis[axis]);
    assert_in_range(t.axis[axis], EXACT_PAIRS / 200, EXACT_PAIRS);
  }
}

static sepax_tri reordered(const sepax_tri *tri, size_t order) {
  static const size_t orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                      {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  const size_t *o = orders[order];
  return (sepax_tri){{tri->v[o[0]], tri->v[o[1]], tri->v[o[2]]}};
}

/* The verdict depends neither on the order of the vertices nor of the triangles. */
CASE(test_symmetry) {
  tally t = {0};
  sepax_random random = {2};
  for (size_t i = 0; i < SYMMETRY_PAIRS; i++) {
    sepax_pair pair = hard_pair(i, &random);
    compare(&t, &pair.a, &pair.b);
    bool expected = sepax_exact(&pair.a, &pair.b).collision;
    for (size_t order = 0; order < 36; order++) {
      sepax_tri a = reordered(&pair.a, order / 6);
      sepax_tri b = reordered(&pair.b, order % 6);
      if (sepax_exact(&a, &b).collision != expected || sepax_exact(&b, &a).collision != expected)
        report(&t, &a, &b, expected, !expected);
    }
  }
  assert_mixed(&t, SYMMETRY_PAIRS);
}
