/* model.c - configuration, formats, the paper's design and the baselines. */
#include "sepax_design.h"
#include "sepax_vectors.h"
#include "harness.h"

#include <math.h>
#include <string.h>

static sepax_config paper_config(void) {
  sepax_config config = sepax_config_default();
  config.arch = SEPAX_ARCH_PAPER;
  return config;
}

static sepax_design design_of(const char *options) {
  sepax_config config = paper_config();
  sepax_design design;
  sepax_error error = {""};
  if (!sepax_config_parse(&config, options, &error) ||
      !sepax_design_init(&design, &config, &error)) {
    fail_msg("%s: %s", options, error.text);
  }
  return design;
}

static void refuse(const char *options, const char *why) {
  sepax_config config = paper_config();
  sepax_error error = {""};
  sepax_design design;
  bool ok =
      sepax_config_parse(&config, options, &error) && sepax_design_init(&design, &config, &error);
  assert_false(ok);
  if (strstr(error.text, why) == NULL) {
    fail_msg("%s: '%s' does not say '%s'", options, error.text, why);
  }
}

CASE(test_config) {
  static const char *const texts[] = {
      "--arch=paper --word=18 --ii=3 --precision=full --block-float=off "
      "--coplanarity=plane --inequality=correct --epsilon=1",
      "--arch=paper --word=4 --ii=3 --precision=guard=7 --block-float=on "
      "--coplanarity=paper --inequality=printed --epsilon=0",
      "--arch=exact --word=32 --ii=18 --coplanar=flag --clock-ns=0.5",
      "--arch=exact --word=18 --ii=3 --coplanar=exact --clock-ns=2",
      "--arch=reference --word=18",
      "--arch=float32 --word=18"};
  for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
    char text[320];
    sepax_config config = sepax_config_default();
    sepax_error error = {""};
    assert_true(sepax_config_parse(&config, texts[i], &error));
    assert_string_equal(sepax_config_text(&config, text, sizeof text), texts[i]);
  }
  refuse("--word=3", "4 ... 32");
  refuse("--word=33", "4 ... 32");
  refuse("--word=eighteen", "whole number");
  refuse("--word=99999999999", "out of range");
  refuse("--arch=fast", "exact, paper, conference, reference, float32");
  refuse("--ii=2", "--ii=3");
  refuse("--precision=half", "full, word, guard=BITS");
  refuse("--precision=guard=x", "whole number");
  refuse("--precision=guard=40", "0 ... 39");
  refuse("--precision=guard=-1", "0 ... 2 W + 3");
  refuse("--block-float=on", "--precision=word");
  refuse("--coplanarity=none", "plane, paper");
  refuse("--inequality=wrong", "correct, printed");
  refuse("--epsilon=131072", "0 ... 131071");
  refuse("--coplanar=flag", "--arch=exact");
  refuse("--clock-ns=3", "--arch=exact");
  refuse("--arch=exact --ii=0", "1 ... 18");
  refuse("--arch=exact --ii=19", "1 ... 18");
  refuse("--arch=exact --clock-ns=0.4", "0.5 ... 20");
  refuse("--arch=exact --clock-ns=1.2345", "three decimals");
  refuse("--arch=exact --coplanar=maybe", "exact, flag");
  refuse("--arch=exact --precision=word", "no such choice");
  refuse("--arch=exact --epsilon=2", "no such choice");
  refuse("--speed=1", "no setting");
  refuse("word=18", "--NAME=VALUE");
}

/* A text that does not fit is cut; nothing behind it is written. */
CASE(test_small_buffers) {
  typedef char *print_config(const sepax_config *, char *, size_t);
  print_config *const print[] = {sepax_config_text, sepax_config_variables, sepax_config_name};
  static const char options[] = "--arch=exact --word=18 --extent-a=2500 --extent-b=2500 "
                                "--clearance=5 --warning=20 --lanes=16 --memory-a=1024";
  sepax_config config = sepax_config_default();
  sepax_error error = {""};
  assert_true(sepax_config_parse(&config, options, &error));
  for (size_t i = 0; i < sizeof print / sizeof print[0]; i++) {
    char whole[SEPAX_CONFIG_TEXT];
    size_t length = strlen(print[i](&config, whole, sizeof whole));
    for (size_t size = 0; size <= length; size++) {
      char text[SEPAX_CONFIG_TEXT];
      memset(text, '#', sizeof text);
      print[i](&config, text, size);
      assert_true(size == 0 || strlen(text) == size - 1);
      assert_memory_equal(text, whole, size == 0 ? 0 : size - 1);
      for (size_t k = size; k < sizeof text; k++) {
        assert_int_equal(text[k], '#');
      }
    }
  }
}

/* The folder of a design: what is not the default follows. */
CASE(test_names) {
  static const struct {
    const char *options, *name;
  } design[] = {
      {"--arch=exact", "exact-w18-ii3"},
      {"--arch=exact --word=8 --ii=1 --coplanar=flag --clock-ns=1.5", "exact-w8-ii1-flag-1.5ns"},
      {"--arch=exact --extent-a=300 --extent-b=40 --clearance=0 --warning=7",
       "exact-w18-ii3-a300-b40-c0-d7"},
      {"--arch=exact --early-out=boxes", "exact-w18-ii3-boxes"},
      {"--arch=exact --lanes=16 --cores=2 --memory-a=1024", "exact-w18-ii3-k16x2-ma1024"},
      {"--arch=paper", "paper-w18-full"},
      {"--arch=paper --word=12 --precision=guard=4 --block-float=on", "paper-w12-guard4-bf"},
      {"--arch=paper --coplanarity=paper --inequality=printed", "paper-w18-full-cop-ineq"},
      {"--arch=conference --precision=word --epsilon=4", "conference-w18-word-e4"}};
  for (size_t i = 0; i < sizeof design / sizeof design[0]; i++) {
    char name[SEPAX_CONFIG_TEXT];
    sepax_config config = sepax_config_default();
    sepax_error error = {""};
    assert_true(sepax_config_parse(&config, design[i].options, &error));
    assert_string_equal(sepax_config_name(&config, name, sizeof name), design[i].name);
  }
}

static void expect_format(const sepax_design *d, sepax_format_id id, int exact, int width) {
  assert_int_equal(d->format[id].exact, exact);
  assert_int_equal(d->format[id].width, width);
  assert_int_equal(d->format[id].shift, exact - width);
}

CASE(test_formats) {
  for (int word = SEPAX_WORD_MIN; word <= SEPAX_WORD_MAX; word++) {
    char options[64];
    snprintf(options, sizeof options, "--word=%d", word);
    sepax_design full = design_of(options);
    expect_format(&full, SEPAX_F_VERTEX, word, word);
    expect_format(&full, SEPAX_F_NORMAL_PRODUCT, 2 * word, 2 * word);
    expect_format(&full, SEPAX_F_NORMAL_PROJECTION, 2 * word + 1, 2 * word + 1);
    expect_format(&full, SEPAX_F_EDGE, word + 1, word + 1);
    expect_format(&full, SEPAX_F_CROSS_PRODUCT, 2 * word + 1, 2 * word + 1);
    expect_format(&full, SEPAX_F_AXIS, 2 * word + 2, 2 * word + 2);
    expect_format(&full, SEPAX_F_PRODUCT, 3 * word + 1, 3 * word + 1);
    expect_format(&full, SEPAX_F_PROJECTION, 3 * word + 3, 3 * word + 3);
    assert_int_equal(full.latency, 13);
    for (int guard = 0; guard <= 2 * word + 3; guard++) {
      snprintf(options, sizeof options, "--word=%d --precision=guard=%d", word, guard);
      sepax_design some = design_of(options);
      for (int i = 0; i < SEPAX_F_COUNT; i++) {
        assert_true(some.format[i].width <= word + guard);
        assert_true(some.format[i].width <= some.format[i].exact);
      }
    }
    for (int i = 0; i < SEPAX_F_COUNT; i++) { /* guard = 2W + 3 is as good as full */
      snprintf(options, sizeof options, "--word=%d --precision=guard=%d", word, 2 * word + 3);
      assert_int_equal(design_of(options).format[i].width, full.format[i].width);
    }
  }
}

CASE(test_coplanar_limit) {
  assert_int_equal(design_of("--word=18 --epsilon=1").coplanar_limit, 131072);
  assert_int_equal(design_of("--word=18 --epsilon=0").coplanar_limit, 1);
  assert_int_equal(design_of("--word=18 --precision=word --epsilon=1").coplanar_limit, 1);
  assert_int_equal(design_of("--word=18 --precision=word --epsilon=9").coplanar_limit, 3);
  assert_int_equal(design_of("--word=32 --epsilon=2147483647").coplanar_limit, INT64_C(2147483647)
                                                                                   << 31);
}

/* The model's own asserts check every intermediate against its format. */
CASE(test_ranges) {
  static const char *const settings[] = {"full", "word", "guard=3"};
  sepax_random random = {11};
  for (int word = SEPAX_WORD_MIN; word <= SEPAX_WORD_MAX; word++) {
    for (int s = 0; s < 4; s++) {
      char options[96];
      snprintf(options, sizeof options, "--word=%d --precision=%s --block-float=%s", word,
               settings[s == 3 ? 1 : s], s == 3 ? "on" : "off");
      sepax_design design = design_of(options);
      for (int n = 0; n < 4000; n++) {
        size_t family = (size_t)n % 17;
        sepax_pair pair = sepax_family_pair(family, word, &random);
        sepax_judge(&design, &pair);
      }
      sepax_tri low = {{{sepax_word_min(word), sepax_word_max(word), sepax_word_min(word)},
                        {sepax_word_max(word), sepax_word_min(word), sepax_word_max(word)},
                        {sepax_word_min(word), sepax_word_min(word), sepax_word_max(word)}}};
      int32_t least = sepax_word_min(word);
      sepax_vec far = {least, least, least};
      sepax_pair extreme = {low, low, far, far};
      sepax_judge(&design, &extreme);
    }
  }
}

/* With every bit kept, an axis that separates is a proof: no collision is missed. */
CASE(test_full_never_misses) {
  static const int words[] = {4, 8, 12, 18, 24, 32};
  static const char *const tests[] = {"plane", "paper"};
  for (size_t w = 0; w < sizeof words / sizeof words[0]; w++) {
    for (int t = 0; t < 2; t++) {
      char options[96];
      snprintf(options, sizeof options, "--word=%d --coplanarity=%s", words[w], tests[t]);
      sepax_design design = design_of(options);
      sepax_random random = {(uint64_t)words[w]};
      int collisions = 0;
      int right = 0;
      for (int n = 0; n < 34000; n++) {
        sepax_pair pair = sepax_family_pair((size_t)n % 17, words[w], &random);
        bool truth = sepax_reference(&pair.a, &pair.b);
        bool verdict = sepax_judge(&design, &pair).collision;
        assert_true(verdict || !truth);
        collisions += truth;
        right += verdict == truth;
      }
      assert_true(collisions > 10000 && collisions < 30000);
      assert_true(right > 25000);
    }
  }
}

static bool same(sepax_verdict u, sepax_verdict v) {
  return u.collision == v.collision && u.coplanar == v.coplanar && u.axis == v.axis &&
         u.mul_project == v.mul_project && u.mul_axes == v.mul_axes;
}

/* Flagged, coplanar pairs are collisions; everything else is the exact verdict. */
CASE(test_coplanar_flag) {
  sepax_design exact = design_of("--arch=exact");
  sepax_design flag = design_of("--arch=exact --coplanar=flag");
  const sepax_verdict flagged = {.collision = true, .coplanar = true};
  sepax_random random = {13};
  int changed = 0;
  for (int n = 0; n < 34000; n++) {
    sepax_pair pair = sepax_family_pair((size_t)n % 17, 18, &random);
    sepax_verdict v = sepax_exact(&pair.a, &pair.b);
    assert_true(same(sepax_judge(&exact, &pair), v));
    assert_true(same(sepax_judge(&flag, &pair), v.coplanar ? flagged : v));
    changed += v.coplanar && !v.collision;
  }
  assert_in_range(changed, 500, 10000);
}

CASE(test_multiplications) {
  sepax_design design = design_of("--word=18");
  sepax_random random = {5};
  int least[2] = {1000, 1000};
  int most[2] = {0, 0};
  int normal_exits = 0;
  for (int n = 0; n < 170000; n++) {
    sepax_pair pair = sepax_family_pair((size_t)n % 17, 18, &random);
    sepax_verdict v = sepax_judge(&design, &pair);
    int tried = v.collision ? (v.coplanar ? 6 : 9) : v.axis < 10 ? v.axis : 0;
    assert_int_equal(v.mul_project, 36 + 18 * tried);
    assert_int_equal(v.mul_axes, 6 * tried);
    if (tried == 0) {
      normal_exits++;
      continue;
    }
    int c = v.coplanar;
    least[c] = v.mul_project < least[c] ? v.mul_project : least[c];
    most[c] = v.mul_project > most[c] ? v.mul_project : most[c];
  }
  assert_true(normal_exits > 1000);
  assert_int_equal(least[0], 54);
  assert_int_equal(most[0], 198); /* 36 + 9 x 18; the paper prints 36 + 152 */
  assert_int_equal(least[1], 54);
  assert_int_equal(most[1], 144);
}

/* Planes x + y = 600 and x - y = 600: tangent to one sphere round the origin. */
static const sepax_tri tangent_a = {{{600, 0, 0}, {500, 100, 0}, {500, 100, 90}}};
static const sepax_tri tangent_b = {{{610, 10, 20}, {650, 50, 0}, {650, 50, 90}}};

static sepax_pair pair_of(const sepax_tri *a, const sepax_tri *b, int word) {
  return (sepax_pair){*a, *b, sepax_unit_normal(a, word), sepax_unit_normal(b, word)};
}

CASE(test_printed_coplanarity) {
  sepax_design plane = design_of("--word=18 --coplanarity=plane");
  sepax_design paper = design_of("--word=18 --coplanarity=paper");
  sepax_pair tangent = pair_of(&tangent_a, &tangent_b, 18);
  tangent.nb = (sepax_vec){-tangent.nb.x, -tangent.nb.y, -tangent.nb.z};
  if (sepax_paper(&paper, &tangent).coplanar == false) {
    tangent = pair_of(&tangent_a, &tangent_b, 18);
  }
  assert_true(sepax_paper(&paper, &tangent).coplanar);
  assert_false(sepax_paper(&plane, &tangent).coplanar);

  static const sepax_tri up = {{{0, 0, 50}, {90, 0, 50}, {0, 90, 50}}};
  static const sepax_tri down = {{{100, 100, 50}, {100, 190, 50}, {190, 100, 50}}};
  sepax_pair opposite = pair_of(&up, &down, 18);
  assert_int_equal(opposite.na.z, -opposite.nb.z);
  assert_false(sepax_paper(&paper, &opposite).coplanar);
  assert_true(sepax_paper(&plane, &opposite).coplanar);
  assert_true(sepax_paper(&paper, &opposite).collision); /* a false alarm */
  assert_false(sepax_paper(&plane, &opposite).collision);
}

CASE(test_printed_inequality) {
  sepax_design printed = design_of("--word=18 --inequality=printed");
  sepax_random random = {3};
  int collisions = 0;
  int missed = 0;
  for (int n = 0; n < 20000; n++) {
    sepax_pair pair = sepax_family_pair((size_t)n % 2, 18, &random);
    if (sepax_reference(&pair.a, &pair.b)) {
      collisions++;
      missed += !sepax_judge(&printed, &pair).collision;
    }
  }
  assert_true(collisions > 2000);
  assert_true(missed * 100 > collisions * 99);
}

/* Edges of 100 LSB leave no bit of their cross product in an 18-bit word: where only
 * such an axis separates, truncation raises a false alarm; block floating point keeps
 * the axis. */
CASE(test_short_edges) {
  sepax_design full = design_of("--word=18");
  sepax_design word = design_of("--word=18 --precision=word");
  sepax_design block = design_of("--word=18 --precision=word --block-float=on");
  sepax_random random = {7};
  int separated = 0;
  int alarms_word = 0;
  int alarms_block = 0;
  for (int n = 0; n < 50000; n++) {
    sepax_pair pair = sepax_family_pair(0, 8, &random); /* extents of at most 256 LSB */
    pair = pair_of(&pair.a, &pair.b, 18);
    sepax_verdict truth = sepax_judge(&full, &pair);
    if (truth.axis >= 1 && truth.axis <= 9) {
      separated++;
      alarms_word += sepax_judge(&word, &pair).collision;
      alarms_block += sepax_judge(&block, &pair).collision;
    }
  }
  print_message("short edges: %d separated, false alarms %d, with block-float %d\n", separated,
                alarms_word, alarms_block);
  assert_true(separated > 5000);
  assert_true(2 * alarms_word > separated);
  assert_true(alarms_block < alarms_word);
}

CASE(test_unit_normal) {
  static const sepax_tri flat = {{{0, 0, 0}, {7, 0, 0}, {0, 9, 0}}};
  sepax_vec n = sepax_unit_normal(&flat, 18);
  assert_int_equal(n.x, 0);
  assert_int_equal(n.y, 0);
  assert_int_equal(n.z, 131071);
  static const sepax_tri line = {{{1, 1, 1}, {2, 2, 2}, {5, 5, 5}}};
  n = sepax_unit_normal(&line, 18);
  assert_true(n.x == 0 && n.y == 0 && n.z == 0);
  sepax_random random = {9};
  for (int i = 0; i < 100000; i++) {
    int word = 4 + i % 29;
    sepax_pair pair = sepax_family_pair(0, word, &random);
    const sepax_vec *v = pair.a.v;
    n = sepax_unit_normal(&pair.a, word);
    const long double e[3] = {(long double)v[1].x - v[0].x, (long double)v[1].y - v[0].y,
                              (long double)v[1].z - v[0].z};
    const long double f[3] = {(long double)v[2].x - v[0].x, (long double)v[2].y - v[0].y,
                              (long double)v[2].z - v[0].z};
    const long double c[3] = {e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2],
                              e[0] * f[1] - e[1] * f[0]};
    long double length = sqrtl(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]);
    if (length > 0) {
      long double scale = (long double)sepax_word_max(word) / length;
      assert_true(fabsl((long double)n.x - scale * c[0]) <= 0.5001L);
      assert_true(fabsl((long double)n.y - scale * c[1]) <= 0.5001L);
      assert_true(fabsl((long double)n.z - scale * c[2]) <= 0.5001L);
    }
  }
}

/* At W = 8 doubles round nothing: the baseline is right on proper triangles. */
CASE(test_float_baselines) {
  sepax_random random = {21};
  int wrong32 = 0;
  for (int n = 0; n < 60000; n++) {
    sepax_pair pair = sepax_family_pair((size_t)n % 5, 8, &random);
    sepax_vec zero = {0, 0, 0};
    if (memcmp(&pair.na, &zero, sizeof zero) != 0 && memcmp(&pair.nb, &zero, sizeof zero) != 0) {
      assert_int_equal(sepax_float64(&pair.a, &pair.b), sepax_reference(&pair.a, &pair.b));
    }
    pair = sepax_family_pair((size_t)n % 5, 24, &random);
    wrong32 += sepax_float32(&pair.a, &pair.b) != sepax_reference(&pair.a, &pair.b);
  }
  assert_true(wrong32 > 0 && wrong32 < 30000);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_config),
      cmocka_unit_test(test_small_buffers),
      cmocka_unit_test(test_names),
      cmocka_unit_test(test_formats),
      cmocka_unit_test(test_coplanar_limit),
      cmocka_unit_test(test_ranges),
      cmocka_unit_test(test_full_never_misses),
      cmocka_unit_test(test_coplanar_flag),
      cmocka_unit_test(test_multiplications),
      cmocka_unit_test(test_printed_coplanarity),
      cmocka_unit_test(test_printed_inequality),
      cmocka_unit_test(test_short_edges),
      cmocka_unit_test(test_unit_normal),
      cmocka_unit_test(test_float_baselines),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
