/* conference.c - the design that the paper improves on: against the separating axis
 * theorem written another way, and against the paper's design, bit for bit. */
#include "sepax_design.h"
#include "sepax_vectors.h"
#include "harness.h"

#include <string.h>

typedef __int128 wide;

typedef struct {
  wide x, y, z;
} vec;

enum { FAMILIES = 17 };

static sepax_design design_of(const char *arch, const char *options) {
  sepax_config config = sepax_config_default();
  sepax_design design;
  sepax_error error = {""};
  if (!sepax_config_set(&config, "arch", arch, &error) ||
      !sepax_config_parse(&config, options, &error) ||
      !sepax_design_init(&design, &config, &error)) {
    fail_msg("%s %s: %s", arch, options, error.text);
  }
  return design;
}

/* ------------------------------------------------------- the theorem, with all bits */

static vec between(sepax_vec from, sepax_vec to) {
  return (vec){(wide)to.x - from.x, (wide)to.y - from.y, (wide)to.z - from.z};
}

static vec wide_of(sepax_vec v) { return (vec){v.x, v.y, v.z}; }

static vec cross(vec p, vec q) {
  return (vec){p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}

static wide dot(vec p, vec q) { return p.x * q.x + p.y * q.y + p.z * q.z; }

/* All of B strictly on one side of all of A along c: the signs of nine differences. */
static bool separates(const sepax_pair *pair, vec c) {
  int above = 0;
  int below = 0;
  for (int i = 0; i < 9; i++) {
    wide d = dot(between(pair->a.v[i / 3], pair->b.v[i % 3]), c);
    above += d > 0;
    below += d < 0;
  }
  return above == 9 || below == 9;
}

static vec edge(const sepax_tri *t, int i) { return between(t->v[i], t->v[(i + 1) % 3]); }

/* The verdict of an eleven-axis test, or of a six-axis one where the pair is called coplanar. */
static bool collides(const sepax_pair *pair, bool coplanar) {
  vec na = wide_of(pair->na);
  vec nb = wide_of(pair->nb);
  bool disjoint = !coplanar && (separates(pair, na) || separates(pair, nb));
  for (int i = 0; i < 3 && !disjoint; i++) {
    if (coplanar) {
      disjoint = separates(pair, cross(na, edge(&pair->a, i))) ||
                 separates(pair, cross(nb, edge(&pair->b, i)));
    }
    for (int j = 0; j < 3 && !coplanar && !disjoint; j++) {
      disjoint = separates(pair, cross(edge(&pair->a, i), edge(&pair->b, j)));
    }
  }
  return !disjoint;
}

/* B_k within epsilon LSB of A's plane by the distance of B_k from A_k; printed: equal offsets. */
static bool called_coplanar(const sepax_pair *pair, const sepax_config *config) {
  wide limit = (wide)config->epsilon << (config->word - 1);
  for (int k = 0; k < 3; k++) {
    vec b = wide_of(config->coplanarity == SEPAX_COPLANAR_PLANE ? pair->na : pair->nb);
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
  for (size_t i = 0; i < sizeof designs / sizeof designs[0]; i++) {
    sepax_design design = design_of("conference", designs[i]);
    sepax_random random = {31 + i};
    int coplanar = 0;
    int collisions = 0;
    int alarms = 0;
    for (int n = 0; n < 34000; n++) {
      sepax_pair pair = sepax_family_pair((size_t)n % FAMILIES, design.config.word, &random);
      sepax_verdict v = sepax_judge(&design, &pair);
      assert_int_equal(v.coplanar, called_coplanar(&pair, &design.config));
      assert_int_equal(v.collision, collides(&pair, v.coplanar));
      bool truth = sepax_reference(&pair.a, &pair.b);
      assert_true(v.collision || !truth); /* an axis that separates is a proof */
      coplanar += v.coplanar;
      collisions += truth;
      alarms += v.collision && !truth;
    }
    assert_in_range(coplanar, 1000, 20000);
    assert_in_range(collisions, 10000, 30000);
    assert_in_range(alarms, 1, 10000);
  }
}

/* ------------------------------------------------------------ beside the paper's design */

/* Everything is the same but that no normal is tried on coplanar pairs, and that the inner
 * products of coplanarity are computed for themselves. Returns whether the verdict differs. */
static bool compare(const sepax_design *conference, const sepax_design *paper,
                    const sepax_pair *pair) {
  sepax_verdict c = sepax_judge(conference, pair);
  sepax_verdict p = sepax_judge(paper, pair);
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
  int differ[8] = {0};
  for (int word = SEPAX_WORD_MIN; word <= SEPAX_WORD_MAX; word++) {
    for (size_t s = 0; s < 8; s++) {
      char options[96];
      snprintf(options, sizeof options, "--word=%d %s", word, precision[s]);
      sepax_design conference = design_of("conference", options);
      sepax_design paper = design_of("paper", options);
      assert_int_equal(conference.latency, 20);
      assert_memory_equal(conference.format, paper.format, sizeof paper.format);
      assert_int_equal(conference.coplanar_limit, paper.coplanar_limit);
      sepax_random random = {(uint64_t)word};
      for (int n = 0; n < 1700; n++) {
        sepax_pair pair = sepax_family_pair((size_t)n % FAMILIES, word, &random);
        bool differs = compare(&conference, &paper, &pair);
        differ[s] += differs;
        bool proof =
            conference.config.guard < 0 && conference.config.inequality == SEPAX_INEQUALITY_CORRECT;
        assert_true(!differs || !proof || !sepax_reference(&pair.a, &pair.b)); /* a false alarm */
      }
    }
  }
  for (size_t s = 0; s < 8; s++) {
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
  sepax_design paper = design_of("paper", "--epsilon=4");
  sepax_design conference = design_of("conference", "--epsilon=4");
  sepax_verdict p = sepax_judge(&paper, &pair);
  sepax_verdict c = sepax_conference(&conference, &pair);
  assert_true(p.coplanar && !p.collision && p.axis == 10);
  assert_true(c.coplanar && c.collision && c.axis == 0);
  conference = design_of("conference", "--epsilon=1");
  c = sepax_conference(&conference, &pair);
  assert_true(!c.coplanar && !c.collision && c.axis == 10);
}

CASE(test_multiplications) {
  sepax_design design = design_of("conference", "--word=18");
  sepax_random random = {5};
  int least[2] = {1000, 1000};
  int most[2] = {0, 0};
  for (int n = 0; n < 170000; n++) {
    sepax_pair pair = sepax_family_pair((size_t)n % FAMILIES, 18, &random);
    sepax_verdict v = sepax_judge(&design, &pair);
    int c = v.coplanar;
    least[c] = v.mul_project < least[c] ? v.mul_project : least[c];
    most[c] = v.mul_project > most[c] ? v.mul_project : most[c];
  }
  assert_int_equal(least[0], 36);
  assert_int_equal(most[0], 216);
  assert_int_equal(least[1], 36);
  assert_int_equal(most[1], 126);
}

CASE(test_choices) {
  static const char *const bad[] = {"--ii=1", "--coplanar=flag", "--clock-ns=1", "--extent-a=5",
                                    "--precision=full --block-float=on"};
  for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
    sepax_config config = sepax_config_default();
    sepax_error error = {""};
    config.arch = SEPAX_ARCH_CONFERENCE;
    assert_true(sepax_config_parse(&config, bad[i], &error));
    assert_false(sepax_config_check(&config, &error));
    assert_true(error.text[0] != '\0');
  }
  char text[320];
  static const char *const all =
      "--arch=conference --word=9 --ii=3 --precision=guard=7 --block-float=on "
      "--coplanarity=paper --inequality=printed --epsilon=0";
  sepax_config config = sepax_config_default();
  sepax_error error = {""};
  assert_true(sepax_config_parse(&config, all, &error));
  assert_string_equal(sepax_config_text(&config, text, sizeof text), all);
  assert_string_equal(sepax_arch_name(config.arch), "conference");
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_full_precision), cmocka_unit_test(test_beside_paper),
      cmocka_unit_test(test_thin_gap),       cmocka_unit_test(test_multiplications),
      cmocka_unit_test(test_choices),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
