/* SPDX-License-Identifier: MIT */
/* conference.c - the design that the paper improves on: against the separating axis
 * theorem written another way, and against the paper's design, bit for bit. */
#include "oracle/geometry.h"
#include "harness.h"

/* ------------------------------------------------------- the theorem, with all bits */

static bool splits(const sepax_pair *pair, wide_vec c) { return separates(c, &pair->a, &pair->b); }

/* The verdict of an eleven-axis test, or of a six-axis one where the pair is called coplanar. */
static bool collides(const sepax_pair *pair, bool coplanar) {
  wide_vec na = wide_of(pair->na);
  wide_vec nb = wide_of(pair->nb);
  bool disjoint = !coplanar && (splits(pair, na) || splits(pair, nb));
  for (int i = 0; i < 3 && !disjoint; i++) {
    if (coplanar) {
      disjoint =
          splits(pair, cross(na, edge(&pair->a, i))) || splits(pair, cross(nb, edge(&pair->b, i)));
    }
    for (int j = 0; j < 3 && !coplanar && !disjoint; j++) {
      disjoint = splits(pair, cross(edge(&pair->a, i), edge(&pair->b, j)));
    }
  }
  return !disjoint;
}

/* B_k within epsilon LSB of A's plane by the distance of B_k from A_k; printed: equal offsets. */
static bool called_coplanar(const sepax_pair *pair, const sepax_config *config) {
  wide limit = (wide)config->epsilon << (config->word - 1);
  for (int k = 0; k < 3; k++) {
    wide_vec b = wide_of(config->coplanarity == SEPAX_COPLANAR_PLANE ? pair->na : pair->nb);
    wide d = dot(wide_of(pair->b.v[k]), b) - dot(wide_of(pair->a.v[k]), wide_of(pair->na));
    d = d < 0 ? -d : d;
    if (config->epsilon == 0 ? d != 0 : d >= limit) {
      return false;
    }
  }
  return true;
}

CASE(test_full_precision) {
  static const char *const designs[] = {
      "--word=4",  "--word=8 --coplanarity=paper", "--word=12 --epsilon=4",
      "--word=18", "--word=18 --epsilon=0",        "--word=32"};
  for (size_t i = 0; i < LENGTH(designs); i++) {
    sepax_design design = design_of("--arch=conference %s", designs[i]);
    sepax_random random = {31 + i};
    int coplanar = 0;
    int collisions = 0;
    int alarms = 0;
    for (size_t n = 0; n < FEWER(34000); n++) {
      sepax_pair pair = mixed_pair(n, design.config.word, &random);
      sepax_judgement v = sepax_judge(&design, &pair);
      assert_int_equal(v.coplanar, called_coplanar(&pair, &design.config));
      assert_int_equal(v.collision, collides(&pair, v.coplanar));
      bool truth = sepax_reference(&pair.a, &pair.b);
      assert_true(v.collision || !truth); /* an axis that separates is a proof */
      coplanar += v.coplanar;
      collisions += truth;
      alarms += v.collision && !truth;
    }
    assert_in_range(coplanar, FEWER(1000), FEWER(20000));
    assert_in_range(collisions, FEWER(10000), FEWER(30000));
    assert_in_range(alarms, 1, FEWER(10000));
  }
}

/* ------------------------------------------------------------ beside the paper's design */

/* Everything is the same but that no normal is tried on coplanar pairs, and that the inner
 * products of coplanarity are computed for themselves. Returns whether the verdict differs. */
static bool compare(const sepax_design *conference, const sepax_design *paper,
                    const sepax_pair *pair) {
  sepax_judgement c = sepax_judge(conference, pair);
  sepax_judgement p = sepax_judge(paper, pair);
  assert_int_equal(c.coplanar, p.coplanar);
  assert_int_equal(c.collision, c.axis == 0);
  if (!c.coplanar) {
    assert_int_equal(c.axis, p.axis);
    assert_int_equal(c.mul_axes, p.mul_axes);
    assert_int_equal(c.mul_project, p.mul_project + (p.axis == 10 ? 0 : 18));
    return false;
  }
  assert_in_range(c.axis, 0, 6);
  if (p.axis == 10 || p.axis == 11) {
    return c.collision;
  }
  assert_int_equal(c.axis, p.axis);
  assert_int_equal(c.mul_axes, p.mul_axes);
  assert_int_equal(c.mul_project, p.mul_project - 18);
  return false;
}

CASE(test_beside_paper) {
  static const char *const precision[] = {
      "--precision=full",    "--precision=word",
      "--precision=guard=4", "--precision=word --block-float=on",
      "--coplanarity=paper", "--inequality=printed",
      "--epsilon=7",         "--precision=word --coplanarity=paper --epsilon=4"};
  int differ[LENGTH(precision)] = {0};
  for (int word = SEPAX_WORD_MIN; word <= SEPAX_WORD_MAX; word++) {
    for (size_t s = 0; s < LENGTH(precision); s++) {
      sepax_design conference = design_of("--arch=conference --word=%d %s", word, precision[s]);
      sepax_design paper = design_of("--arch=paper --word=%d %s", word, precision[s]);
      assert_int_equal(conference.latency, 20);
      assert_memory_equal(conference.format, paper.format, sizeof paper.format);
      assert_int_equal(conference.coplanar_limit, paper.coplanar_limit);
      bool proof =
          conference.config.guard < 0 && conference.config.inequality == SEPAX_INEQUALITY_CORRECT;
      sepax_random random = {(uint64_t)word};
      for (size_t n = 0; n < FEWER(1700); n++) {
        sepax_pair pair = mixed_pair(n, word, &random);
        bool differs = compare(&conference, &paper, &pair);
        differ[s] += differs;
        assert_true(!differs || !proof || !sepax_reference(&pair.a, &pair.b)); /* a false alarm */
      }
    }
  }
  for (size_t s = 0; s < LENGTH(precision); s++) {
    print_message("%s: %d verdicts differ\n", precision[s], differ[s]);
  }
  assert_true(differ[0] > 0 && differ[6] > 0); /* coplanar for the design, yet a normal separates */
}

/* Two planes at a distance of 2 LSB: coplanar within 4; only a normal separates what lies in them.
 */
CASE(test_thin_gap) {
  static const sepax_tri low = {{{0, 0, 0}, {90, 0, 0}, {0, 90, 0}}};
  static const sepax_tri high = {{{10, 10, 2}, {50, 10, 2}, {10, 50, 2}}};
  sepax_pair pair = {low, high, sepax_unit_normal(&low, 18), sepax_unit_normal(&high, 18)};
  sepax_design paper = design_of("--arch=paper --epsilon=4");
  sepax_design conference = design_of("--arch=conference --epsilon=4");
  sepax_judgement p = sepax_judge(&paper, &pair);
  sepax_judgement c = sepax_conference(&conference, &pair);
  assert_true(p.coplanar && !p.collision && p.axis == 10);
  assert_true(c.coplanar && c.collision && c.axis == 0);
  conference = design_of("--arch=conference --epsilon=1");
  c = sepax_conference(&conference, &pair);
  assert_true(!c.coplanar && !c.collision && c.axis == 10);
}
