/* SPDX-License-Identifier: MIT */
/* clearance - checks sepax_clearance against exact distances of the real triangles, and counts
 * its false alarms:
 *   clearance sweep COUNT SEED    COUNT pairs near a limit; exit status 1 if one is missed
 *   clearance curve COUNT SEED    CSV: share of pairs not free over the real distance, COUNT
 *                                 pairs a kind and distance, CLEARANCE 5
 *   clearance large COUNT SEED    CSV: share of pairs called free over their distance, by the rule
 *                                 of the hardware and by the tight one, CLEARANCE 1 ... 1000
 *   clearance pairs COUNT WORD    pairs near limits of 0 ... 20, rounded, for the test benches */
#include "benchmark/columns.h"
#include "oracle/clearance_rules.h"
#include "oracle/distance.h"
#include "oracle/real_pairs.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const int limits[][2] = {{0, 1}, {0, 7}, {1, 3}, {2, 20}, {5, 20}, {5, 6}, {40, 100}};
enum { LIMITS = sizeof limits / sizeof limits[0] };

static sepax_design clear_design(int clearance, int warning) {
  sepax_config config = sepax_config_default();
  config.clearance = clearance;
  config.warning = warning;
  return design_from(config);
}

/* Mostly about the limit itself, and up to where no pair is in doubt. */
static double distance_near(int limit, sepax_random *r) {
  switch (sepax_random_range(r, 0, 3)) {
  case 0:
    return limit + uniform(r, -0.01, 0.01);
  case 1:
    return fmax(0, limit + uniform(r, -1, 1));
  case 2:
    return fmax(0, limit + uniform(r, -1, 4));
  default:
    return uniform(r, 0, 2.0 * (1 + limit));
  }
}

typedef struct {
  size_t pairs, within, clear, missed, quick; /* within ... missed of two limits a pair */
} tally;

static void print_pair(const real_pair *p, const int limit[2]) {
  fprintf(stderr, "missed: %s, limits %d, %d, in 2^-%d LSB:", real_kind_name(p->kind), limit[0],
          limit[1], p->fraction);
  for (int k = 0; k < 6; k++) {
    const sepax_vec *v = k < 3 ? &p->a.v[k] : &p->b.v[k - 3];
    fprintf(stderr, " %d %d %d", v->x, v->y, v->z);
  }
  fputc('\n', stderr);
}

static void judge(tally *t, const sepax_design *design, const int limit[2], const real_pair *p) {
  sepax_band band = sepax_clearance(design, &p->rounded_a, &p->rounded_b).band;
  t->pairs++;
  for (int k = 0; k < 2; k++) {
    bool clear = band == SEPAX_BAND_FREE || (k == 0 && band == SEPAX_BAND_WARNING);
    bool within = distance_within(&p->a, &p->b, (int64_t)limit[k] << p->fraction, &t->quick);
    t->within += within;
    t->clear += clear;
    t->missed += clear && within;
    if (clear && within && t->missed <= 3) {
      print_pair(p, limit);
    }
  }
}

static int sweep(size_t count, uint64_t seed) {
  sepax_random random = {seed};
  sepax_design design[LIMITS];
  tally all[REAL_KINDS] = {{0}};
  for (int i = 0; i < LIMITS; i++) {
    design[i] = clear_design(limits[i][0], limits[i][1]);
  }
  for (size_t n = 0; n < count; n++) {
    int kind = (int)(n % REAL_KINDS);
    size_t i = (size_t)sepax_random_range(&random, 0, LIMITS - 1);
    int limit = limits[i][sepax_random_range(&random, 0, 1)];
    real_pair p = real_pair_make(kind, distance_near(limit, &random), &random);
    judge(&all[kind], &design[i], limits[i], &p);
  }
  printf("%-14s %10s %12s %12s %12s %8s\n", "kind", "pairs", "within", "beyond", "of them clear",
         "missed");
  tally sum = {0};
  for (int kind = 0; kind < REAL_KINDS; kind++) {
    const tally *t = &all[kind];
    printf("%-14s %10zu %12zu %12zu %12zu %8zu\n", real_kind_name(kind), t->pairs, t->within,
           2 * t->pairs - t->within, t->clear, t->missed);
    sum.pairs += t->pairs;
    sum.within += t->within;
    sum.missed += t->missed;
    sum.quick += t->quick;
  }
  printf("%zu pairs, two limits each: %zu times within a limit, %zu misses; %zu judged by a plane "
         "in integers, %zu by rational distances\n",
         sum.pairs, sum.within, sum.missed, sum.quick, 2 * sum.pairs - sum.quick);
  return sum.missed > 0 || sum.within == 0;
}

enum { CURVE_LIMIT = 5, STEPS = 60 };

static int curve(size_t count, uint64_t seed) {
  static const clear_rule rules[] = {RULE_EUCLID,  RULE_SUM,      RULE_XY,
                                     RULE_NO_EDGE, RULE_PRODUCTS, RULE_BOXES};
  enum { COMPARED = sizeof rules / sizeof rules[0] };
  sepax_random random = {seed};
  const sepax_design design = clear_design(CURVE_LIMIT, 0);
  printf("kind,distance,pairs,not_free");
  for (int r = 0; r < COMPARED; r++) {
    printf(",%s", clear_rule_name(rules[r]));
  }
  putchar('\n');
  for (int kind = 0; kind < REAL_KINDS; kind++) {
    for (int step = 0; step < STEPS; step++) {
      double from = CURVE_LIMIT + 0.25 * step;
      size_t pairs = 0;
      size_t alarms = 0;
      size_t others[COMPARED] = {0};
      for (size_t n = 0; n < 4 * count && pairs < count; n++) {
        real_pair p = real_pair_make(kind, uniform(&random, from, from + 0.25), &random);
        double way[3];
        double distance = ldexp(distance_rounded(&p.a, &p.b, way), -p.fraction);
        if (distance < from || distance >= from + 0.25 || distance_within(&p.a, &p.b, 0, NULL)) {
          continue;
        }
        pairs++;
        alarms += sepax_clearance(&design, &p.rounded_a, &p.rounded_b).band != SEPAX_BAND_FREE;
        for (int r = 0; r < COMPARED; r++) {
          others[r] += !clear_by(rules[r], &p.rounded_a, &p.rounded_b, CURVE_LIMIT);
        }
      }
      printf("%s,%.3f,%zu,%.5f", real_kind_name(kind), from + 0.125, pairs,
             (double)alarms / (double)pairs);
      for (int r = 0; r < COMPARED; r++) {
        printf(",%.5f", (double)others[r] / (double)pairs);
      }
      putchar('\n');
    }
  }
  return 0;
}

/* Pairs of kind "local" at distances of 1 ... 6 D, more densely where the rules part. */
static int large(size_t count, uint64_t seed) {
  static const int clearances[] = {1, 10, 100, 1000};
  static const double ratios[] = {1,   1.01, 1.02, 1.04, 1.06, 1.08, 1.1, 1.15, 1.2, 1.25,
                                  1.3, 1.4,  1.5,  1.7,  2,    2.5,  3,   4,    5,   6};
  enum { RATIOS = sizeof ratios / sizeof ratios[0], LOCAL = 9 };
  sepax_random random = {seed};
  puts("clearance,ratio,pairs,hardware,tight");
  for (size_t i = 0; i < sizeof clearances / sizeof clearances[0]; i++) {
    const sepax_design design = clear_design(clearances[i], 0);
    for (int step = 0; step + 1 < RATIOS && ratios[step] * clearances[i] < 2000; step++) {
      size_t found[3] = {0, 0, 0}; /* pairs, free by either rule */
      for (size_t n = 0; n < 4 * count && found[0] < count; n++) {
        double away = uniform(&random, ratios[step], ratios[step + 1]) * clearances[i];
        real_pair p = real_pair_make(LOCAL, away, &random);
        double way[3];
        double ratio = ldexp(distance_rounded(&p.a, &p.b, way), -p.fraction) / clearances[i];
        if (ratio < ratios[step] || ratio >= ratios[step + 1]) {
          continue;
        }
        found[0]++;
        found[1] += !sepax_clearance(&design, &p.rounded_a, &p.rounded_b).collision;
        found[2] += !sepax_clearance_tight(&design, &p.rounded_a, &p.rounded_b).collision;
      }
      printf("%d,%.4f,%zu,%.5f,%.5f\n", clearances[i], (ratios[step] + ratios[step + 1]) / 2,
             found[0], (double)found[1] / (double)found[0], (double)found[2] / (double)found[0]);
    }
  }
  return 0;
}

static int print_pairs(size_t count, uint64_t word) {
  if (word < SEPAX_WORD_MIN || word > SEPAX_WORD_MAX) {
    fprintf(stderr, "clearance: word: give %d ... %d\n", SEPAX_WORD_MIN, SEPAX_WORD_MAX);
    return 2;
  }
  static const int near[] = {0, 1, 2, 5, 20};
  sepax_random random = {word};
  for (size_t n = 0; n < count;) {
    int limit = near[sepax_random_range(&random, 0, 4)];
    double distance = limit + uniform(&random, 0, 2 + limit);
    real_pair p = real_pair_make((int)(sepax_random_next(&random) % REAL_KINDS), distance, &random);
    sepax_pair pair = {.a = p.rounded_a, .b = p.rounded_b};
    if (sepax_pair_fits(&pair, (int)word)) {
      sepax_pair_print(stdout, &pair);
      putchar('\n');
      n++;
    }
  }
  return 0;
}

int main(int argc, char **argv) {
  char *end = NULL;
  size_t count = argc == 4 ? strtoul(argv[2], &end, 10) : 0;
  uint64_t seed = argc == 4 ? strtoull(argv[3], NULL, 10) : 0;
  static const struct {
    const char *name;
    int (*run)(size_t count, uint64_t seed);
  } verbs[] = {{"sweep", sweep}, {"curve", curve}, {"large", large}, {"pairs", print_pairs}};
  for (size_t i = 0; i < sizeof verbs / sizeof verbs[0] && count > 0 && *end == '\0'; i++) {
    if (strcmp(argv[1], verbs[i].name) == 0) {
      return verbs[i].run(count, seed);
    }
  }
  fprintf(stderr, "usage: clearance sweep|curve|large COUNT SEED, clearance pairs COUNT WORD\n");
  return 2;
}
