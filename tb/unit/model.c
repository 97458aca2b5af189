/* SPDX-License-Identifier: MIT */
/* model.c - configuration, formats, the paper's design and the baselines. */
#include "oracle/geometry.h"
#include "oracle/pair_tools.h"
#include "harness.h"

#include <math.h>
#include <string.h>

CASE(test_config) {
  static const char *const texts[] = {
      "--arch=paper --word=18 --ii=3 --precision=full --block-float=off "
      "--coplanarity=plane --inequality=correct --epsilon=1",
      "--arch=paper --word=4 --ii=3 --precision=guard=7 --block-float=on "
      "--coplanarity=paper --inequality=printed --epsilon=0",
      "--arch=conference --word=9 --ii=3 --precision=guard=7 --block-float=on "
      "--coplanarity=paper --inequality=printed --epsilon=0",
      "--arch=exact --word=32 --ii=18 --coplanar=flag --clock-ns=0.5",
      "--arch=exact --word=18 --ii=3 --coplanar=exact --clock-ns=2",
      "--arch=exact --word=18 --ii=3 --coplanar=exact --clock-ns=2 --clearance=0",
      "--arch=exact --word=18 --ii=3 --coplanar=exact --clock-ns=2 --clearance=131071",
      "--arch=exact --word=18 --ii=3 --coplanar=exact --clock-ns=2 --clearance=5 --warning=20",
      "--arch=exact --word=18 --ii=3 --coplanar=exact --clock-ns=2 --extent-a=500 "
      "--extent-b=500 --clearance=3",
      "--arch=reference --word=18",
      "--arch=float32 --word=18"};
  for (size_t i = 0; i < LENGTH(texts); i++) {
    char text[SEPAX_CONFIG_TEXT];
    sepax_config config = sepax_config_default();
    assert_works(sepax_config_parse(&config, texts[i], &fault));
    assert_works(sepax_config_check(&config, &fault));
    assert_string_equal(sepax_config_text(&config, text, sizeof text), texts[i]);
  }
}

/* tb/system/cli has more of them. */
CASE(test_refused) {
  static const char *const row[][2] = {
      {"--word=33", "4 ... 32"},
      {"--word=eighteen", "whole number"},
      {"--word=99999999999", "out of range"},
      {"--arch=fast", "exact, paper, conference, reference, float32"},
      {"--arch=paper --ii=2", "--ii=3"},
      {"--arch=paper --precision=half", "full, word, guard=BITS"},
      {"--arch=paper --precision=guard=x", "whole number"},
      {"--arch=paper --precision=guard=40", "0 ... 39"},
      {"--arch=paper --precision=guard=-1", "0 ... 2 W + 3"},
      {"--arch=paper --block-float=on", "--precision=word"},
      {"--arch=paper --coplanarity=none", "plane, paper"},
      {"--arch=paper --inequality=wrong", "correct, printed"},
      {"--arch=paper --epsilon=131072", "0 ... 131071"},
      {"--arch=conference --coplanar=flag", "--arch=exact"},
      {"--arch=conference --extent-a=5", "--arch=exact"},
      {"--arch=conference --precision=full --block-float=on", "--precision=word"},
      {"--arch=exact --ii=19", "1 ... 18"},
      {"--arch=exact --clock-ns=0.4", "0.5 ... 1000"},
      {"--arch=exact --clock-ns=1.2345", "three decimals"},
      {"--arch=exact --clock-ns=0x10", "no period"},
      {"--clearance=131072", "0 ... 131071"},
      {"--clearance=-2", "out of range"},
      {"--clearance=5 --warning=131072", "at most 131071"},
      {"--clearance=100000 --extent-a=500 --extent-b=500", "they save nothing; leave them out"},
      {"--speed=1", "not a design option"},
      {"word=18", "--NAME=VALUE"}};
  for (size_t i = 0; i < LENGTH(row); i++) {
    refuse_design(row[i][0], row[i][1]);
  }
}

/* A text that does not fit is cut; nothing behind it is written. */
CASE(test_small_buffers) {
  typedef char *print_config(const sepax_config *, char *, size_t);
  print_config *const print[] = {sepax_config_text, sepax_config_variables, sepax_config_name};
  sepax_config config = design_of("--extent-a=2500 --extent-b=2500 --clearance=5 --warning=20 "
                                  "--lanes=16 --memory-a=1024")
                            .config;
  for (size_t i = 0; i < LENGTH(print); i++) {
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
      {"--arch=exact --stream=pair --tag=40", "exact-w18-ii3-pair-t40"},
      {"--arch=exact --lanes=16 --cores=2 --memory-a=1024", "exact-w18-ii3-k16x2-ma1024"},
      {"--arch=paper", "paper-w18-full"},
      {"--arch=paper --word=12 --precision=guard=4 --block-float=on", "paper-w12-guard4-bf"},
      {"--arch=paper --coplanarity=paper --inequality=printed", "paper-w18-full-cop-ineq"},
      {"--arch=conference --precision=word --epsilon=4", "conference-w18-word-e4"}};
  for (size_t i = 0; i < LENGTH(design); i++) {
    char name[SEPAX_CONFIG_TEXT];
    sepax_config config = design_of("%s", design[i].options).config;
    assert_string_equal(sepax_config_name(&config, name, sizeof name), design[i].name);
  }
}

/* Bits of the exact value, W and 1 being counted. */
CASE(test_formats) {
  static const struct {
    sepax_format_id id;
    int words, more;
  } exact[] = {
      {SEPAX_F_VERTEX, 1, 0},  {SEPAX_F_NORMAL_PRODUCT, 2, 0}, {SEPAX_F_NORMAL_PROJECTION, 2, 1},
      {SEPAX_F_EDGE, 1, 1},    {SEPAX_F_CROSS_PRODUCT, 2, 1},  {SEPAX_F_AXIS, 2, 2},
      {SEPAX_F_PRODUCT, 3, 1}, {SEPAX_F_PROJECTION, 3, 3}};
  for (int word = SEPAX_WORD_MIN; word <= SEPAX_WORD_MAX; word++) {
    sepax_design full = design_of("--arch=paper --word=%d", word);
    assert_int_equal(full.latency, 13);
    for (size_t i = 0; i < LENGTH(exact); i++) {
      const sepax_format *format = &full.format[exact[i].id];
      assert_int_equal(format->exact, exact[i].words * word + exact[i].more);
      assert_int_equal(format->width, format->exact);
      assert_int_equal(format->shift, 0);
    }
    for (int guard = 0; guard <= 2 * word + 3; guard++) {
      sepax_design some = design_of("--arch=paper --word=%d --precision=guard=%d", word, guard);
      for (int i = 0; i < SEPAX_F_COUNT; i++) {
        const sepax_format *format = &some.format[i];
        assert_true(format->width <= word + guard && format->width <= format->exact);
        /* guard = 2W + 3 is as good as full */
        assert_true(guard < 2 * word + 3 || format->width == full.format[i].width);
      }
    }
  }
}

CASE(test_coplanar_limit) {
  static const struct {
    const char *options;
    int64_t limit;
  } row[] = {{"--word=18 --epsilon=1", 131072},
             {"--word=18 --epsilon=0", 1},
             {"--word=18 --precision=word --epsilon=1", 1},
             {"--word=18 --precision=word --epsilon=9", 3},
             {"--word=32 --epsilon=2147483647", INT64_C(2147483647) << 31}};
  for (size_t i = 0; i < LENGTH(row); i++) {
    assert_int_equal(design_of("--arch=paper %s", row[i].options).coplanar_limit, row[i].limit);
  }
}

/* The model's own asserts check every intermediate against its format. */
CASE(test_ranges) {
  static const char *const settings[] = {"full", "word", "guard=3", "word --block-float=on"};
  sepax_random random = {11};
  for (int word = SEPAX_WORD_MIN; word <= SEPAX_WORD_MAX; word++) {
    int32_t low = sepax_word_min(word);
    int32_t high = sepax_word_max(word);
    sepax_tri broad = {{{low, high, low}, {high, low, high}, {low, low, high}}};
    sepax_pair extreme = {broad, broad, {low, low, low}, {low, low, low}};
    for (size_t s = 0; s < LENGTH(settings); s++) {
      sepax_design design = design_of("--arch=paper --word=%d --precision=%s", word, settings[s]);
      for (size_t n = 0; n < FEWER(4000); n++) {
        sepax_pair pair = mixed_pair(n, word, &random);
        sepax_judge(&design, &pair);
      }
      sepax_judge(&design, &extreme);
    }
  }
}

/* With every bit kept, an axis that separates is a proof: no collision is missed. */
CASE(test_full_never_misses) {
  static const int words[] = {4, 8, 12, 18, 24, 32};
  static const char *const tests[] = {"plane", "paper"};
  for (size_t w = 0; w < LENGTH(words); w++) {
    for (int t = 0; t < 2; t++) {
      sepax_design design =
          design_of("--arch=paper --word=%d --coplanarity=%s", words[w], tests[t]);
      sepax_random random = {(uint64_t)words[w]};
      int collisions = 0;
      int right = 0;
      for (size_t n = 0; n < FEWER(34000); n++) {
        sepax_pair pair = mixed_pair(n, words[w], &random);
        bool truth = sepax_reference(&pair.a, &pair.b);
        bool verdict = sepax_judge(&design, &pair).collision;
        assert_true(verdict || !truth);
        collisions += truth;
        right += verdict == truth;
      }
      assert_true(collisions > FEWER(10000) && collisions < FEWER(30000));
      assert_true(right > FEWER(25000));
    }
  }
}

static bool same(sepax_judgement u, sepax_judgement v) {
  return u.collision == v.collision && u.coplanar == v.coplanar && u.axis == v.axis &&
         u.mul_project == v.mul_project && u.mul_axes == v.mul_axes;
}

/* Flagged, coplanar pairs are collisions; everything else is the exact verdict. */
CASE(test_coplanar_flag) {
  sepax_design exact = design_of("--arch=exact");
  sepax_design flag = design_of("--arch=exact --coplanar=flag");
  const sepax_judgement flagged = {.collision = true, .coplanar = true};
  sepax_random random = {13};
  int changed = 0;
  for (size_t n = 0; n < 34000; n++) {
    sepax_pair pair = mixed_pair(n, 18, &random);
    sepax_verdict truth = sepax_exact(&pair.a, &pair.b);
    sepax_judgement v = sepax_judge(&exact, &pair);
    assert_true(v.collision == truth.collision && v.strict == truth.strict &&
                v.coplanar == truth.coplanar && v.axis == truth.axis && v.mul_project == 0);
    assert_true(same(sepax_judge(&flag, &pair), v.coplanar ? flagged : v));
    changed += v.coplanar && !v.collision;
  }
  assert_in_range(changed, 500, 10000);
}

/* The least and the most of pairs that are not coplanar, and of those that are; of the paper's only
 * where it tries more than normals. */
CASE(test_multiplications) {
  static const struct {
    const char *arch;
    int range[2][2];
  } row[] = {{"paper", {{54, 198}, {54, 144}}}, /* 36 + 9 x 18; the paper prints 36 + 152 */
             {"conference", {{36, 216}, {36, 126}}}};
  for (size_t i = 0; i < LENGTH(row); i++) {
    sepax_design design = design_of("--arch=%s --word=18", row[i].arch);
    sepax_random random = {5};
    int range[2][2] = {{1000, 0}, {1000, 0}};
    int normal_exits = 0;
    for (size_t n = 0; n < 170000; n++) {
      sepax_pair pair = mixed_pair(n, 18, &random);
      sepax_judgement v = sepax_judge(&design, &pair);
      if (design.config.arch == SEPAX_ARCH_PAPER) {
        int tried = v.collision ? (v.coplanar ? 6 : 9) : v.axis < 10 ? v.axis : 0;
        assert_int_equal(v.mul_project, 36 + 18 * tried);
        assert_int_equal(v.mul_axes, 6 * tried);
        normal_exits += tried == 0;
      }
      if (design.config.arch != SEPAX_ARCH_PAPER || v.mul_axes > 0) {
        int *of = range[v.coplanar];
        of[0] = v.mul_project < of[0] ? v.mul_project : of[0];
        of[1] = v.mul_project > of[1] ? v.mul_project : of[1];
      }
    }
    assert_true(normal_exits > 1000 || design.config.arch != SEPAX_ARCH_PAPER);
    assert_memory_equal(range, row[i].range, sizeof range);
  }
}

/* Planes x + y = 600 and x - y = 600: tangent to one sphere round the origin. */
static const sepax_tri tangent_a = {{{600, 0, 0}, {500, 100, 0}, {500, 100, 90}}};
static const sepax_tri tangent_b = {{{610, 10, 20}, {650, 50, 0}, {650, 50, 90}}};

static sepax_pair pair_of(const sepax_tri *a, const sepax_tri *b, int word) {
  return (sepax_pair){*a, *b, sepax_unit_normal(a, word), sepax_unit_normal(b, word)};
}

CASE(test_printed_coplanarity) {
  sepax_design plane = design_of("--arch=paper --word=18 --coplanarity=plane");
  sepax_design paper = design_of("--arch=paper --word=18 --coplanarity=paper");
  sepax_pair touching = pair_of(&tangent_a, &tangent_b, 18);
  touching.nb = (sepax_vec){-touching.nb.x, -touching.nb.y, -touching.nb.z};
  if (sepax_paper(&paper, &touching).coplanar == false) {
    touching = pair_of(&tangent_a, &tangent_b, 18);
  }
  assert_true(sepax_paper(&paper, &touching).coplanar);
  assert_false(sepax_paper(&plane, &touching).coplanar);

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
  sepax_design printed = design_of("--arch=paper --word=18 --inequality=printed");
  sepax_random random = {3};
  int collisions = 0;
  int missed = 0;
  for (size_t n = 0; n < 20000; n++) {
    sepax_pair pair = sepax_family_pair(n % 2, 18, &random);
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
  sepax_design full = design_of("--arch=paper --word=18");
  sepax_design word = design_of("--arch=paper --word=18 --precision=word");
  sepax_design block = design_of("--arch=paper --word=18 --precision=word --block-float=on");
  sepax_random random = {7};
  int separated = 0;
  int alarms_word = 0;
  int alarms_block = 0;
  for (size_t n = 0; n < FEWER(50000); n++) {
    sepax_pair pair = sepax_family_pair(0, 8, &random); /* extents of at most 256 LSB */
    pair = pair_of(&pair.a, &pair.b, 18);
    sepax_judgement truth = sepax_judge(&full, &pair);
    if (truth.axis >= 1 && truth.axis <= 9) {
      separated++;
      alarms_word += sepax_judge(&word, &pair).collision;
      alarms_block += sepax_judge(&block, &pair).collision;
    }
  }
  print_message("short edges: %d separated, false alarms %d, with block-float %d\n", separated,
                alarms_word, alarms_block);
  assert_true(separated > FEWER(5000));
  assert_true(2 * alarms_word > separated);
  assert_true(alarms_block < alarms_word);
}

/* What stands before the model of architecture exact, and behind it. */
CASE(test_judged) {
  static const sepax_tri low = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  static const sepax_tri large = {{{0, 0, 0}, {0, 2, 1}, {2, 0, 1}}};
  static const sepax_tri above = {{{0, 0, 2}, {1, 0, 2}, {0, 1, 1}}};
  static const sepax_tri other = {{{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}}; /* AABBs touch */
  static const struct {
    const char *options;
    const sepax_tri *b;
    sepax_judgement v;
  } known[] = {
      {"--word=8", &other, {.coplanar = true, .axis = SEPAX_AXIS_PLANE}},
      {"--word=8 --coplanar=flag", &other, {.collision = true, .coplanar = true}},
      {"--word=8 --coplanar=flag", &above, {.axis = SEPAX_AXIS_NORMAL_A}},
      {"--word=8 --early-out=boxes", &large, {.collision = true}},
      {"--word=8 --early-out=boxes", &above, {.axis = SEPAX_AXIS_AABB}},
      {"--word=8 --extent-a=1 --extent-b=1", &low, {.collision = true, .coplanar = true}},
      {"--word=8 --extent-a=1 --extent-b=1", &other, {.coplanar = true, .axis = SEPAX_AXIS_PLANE}},
      {"--word=8 --extent-a=1 --extent-b=1",
       &large,
       {.collision = true, .axis = SEPAX_AXIS_EXTENT, .band = SEPAX_BAND_FREE}},
      {"--word=8 --clearance=5 --extent-a=1 --extent-b=1",
       &large,
       {.collision = true, .axis = SEPAX_AXIS_EXTENT, .band = SEPAX_BAND_COLLISION}},
      {"--word=8 --clearance=5", &above, {.collision = true, .band = SEPAX_BAND_COLLISION}},
  };
  for (size_t i = 0; i < LENGTH(known); i++) {
    sepax_design design = design_of("%s", known[i].options);
    sepax_pair pair = {.a = low, .b = *known[i].b};
    sepax_judgement v = sepax_judge(&design, &pair);
    print_message("%s: %d %d %d %d\n", known[i].options, v.collision, v.coplanar, v.axis, v.band);
    assert_int_equal(v.collision, known[i].v.collision);
    assert_int_equal(v.coplanar, known[i].v.coplanar);
    assert_int_equal(v.axis, known[i].v.axis);
    assert_int_equal(v.band, known[i].v.band);
  }
}

CASE(test_unit_normal) {
  static const struct {
    sepax_tri tri;
    sepax_vec normal;
  } known[] = {{{{{0, 0, 0}, {7, 0, 0}, {0, 9, 0}}}, {0, 0, 131071}},
               {{{{1, 1, 1}, {2, 2, 2}, {5, 5, 5}}}, {0, 0, 0}}};
  for (size_t i = 0; i < LENGTH(known); i++) {
    assert_true(equal(sepax_unit_normal(&known[i].tri, 18), known[i].normal));
  }
  sepax_random random = {9};
  for (int i = 0; i < FEWER(100000); i++) {
    int word = 4 + i % 29;
    sepax_pair pair = sepax_family_pair(0, word, &random);
    sepax_vec n = sepax_unit_normal(&pair.a, word);
    wide_vec c = cross(edge(&pair.a, 0), edge(&pair.a, 1));
    long double size[3];
    for (int k = 0; k < 3; k++) {
      size[k] = (long double)c.c[k];
    }
    long double length = sqrtl(size[0] * size[0] + size[1] * size[1] + size[2] * size[2]);
    for (int k = 0; k < 3 && length > 0; k++) {
      long double expected = (long double)sepax_word_max(word) / length * size[k];
      assert_true(fabsl((long double)*coordinate(&n, k) - expected) <= 0.5001L);
    }
  }
}

/* At W = 8 doubles round nothing: the baseline is right on proper triangles. */
CASE(test_float_baselines) {
  sepax_random random = {21};
  int wrong32 = 0;
  for (size_t n = 0; n < 60000; n++) {
    sepax_pair pair = sepax_family_pair(n % 5, 8, &random);
    if (both_have_area(&pair, 8)) {
      assert_int_equal(sepax_float64(&pair.a, &pair.b), sepax_reference(&pair.a, &pair.b));
    }
    pair = sepax_family_pair(n % 5, 24, &random);
    wrong32 += sepax_float32(&pair.a, &pair.b) != sepax_reference(&pair.a, &pair.b);
  }
  assert_true(wrong32 > 0 && wrong32 < 30000);
}
