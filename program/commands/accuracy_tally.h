/* SPDX-License-Identifier: MIT */
/* accuracy_tally.h - what sepax accuracy counts, and its rows (private; accuracy.c). */
#ifndef SEPAX_ACCURACY_TALLY_H
#define SEPAX_ACCURACY_TALLY_H

#include <inttypes.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>

enum { VARIANTS = 5 };

static const char *const variant_name[VARIANTS] = {"order", "exchange", "move", "axes", "scale"};

/* Groups of pairs. PROPER: both triangles have an area. DEGENERATE: at least one has no area. */
typedef enum { ANY, PROPER, DEGENERATE, GROUPS } group;

static const char *const group_name[GROUPS] = {"any", "proper", "degenerate"};
static const char *const group_row[GROUPS] = {"", "- proper", "- degenerate"};

typedef struct {
  uint64_t pairs, collisions, missed, alarms;
  double deepest,
      widest; /* depth of the deepest missed collision, gap of the widest false alarm; LSB */
  uint64_t varied, flipped[VARIANTS], flipped_any;
  uint64_t nudged,
      changed;      /* pairs nudged by up to 1 LSB in each coordinate; verdicts that changed */
  uint64_t settled; /* pairs that doubles alone decided, if the design has a filter */
} tally;

typedef struct {
  const char *design, *truth;
  bool csv, filter;
} row_style;

static inline void tally_add(tally *sum, const tally *t) {
  sum->pairs += t->pairs;
  sum->collisions += t->collisions;
  sum->missed += t->missed;
  sum->alarms += t->alarms;
  sum->deepest = fmax(sum->deepest, t->deepest);
  sum->widest = fmax(sum->widest, t->widest);
  sum->varied += t->varied;
  sum->flipped_any += t->flipped_any;
  for (int kind = 0; kind < VARIANTS; kind++) {
    sum->flipped[kind] += t->flipped[kind];
  }
  sum->nudged += t->nudged;
  sum->changed += t->changed;
  sum->settled += t->settled;
}

/* The ends of the 95 % confidence interval of a share k / n (Wilson). */
static inline void interval_of(uint64_t k, uint64_t n, double ends[2]) {
  const double z = 1.959964;
  if (n == 0) {
    ends[0] = 0;
    ends[1] = 1;
    return;
  }
  double m = (double)n;
  double p = (double)k / m;
  double centre = p + z * z / (2 * m);
  double reach = z * sqrt(p * (1 - p) / m + z * z / (4 * m * m));
  double scale = 1 + z * z / m;
  ends[0] = k == 0 ? 0 : fmax(0, (centre - reach) / scale);
  ends[1] = fmin(1, (centre + reach) / scale);
}

static inline void print_head(const row_style *s) {
  if (s->csv) {
    printf("design,truth,family,pairs,collisions,missed,missed_low,missed_high,deepest_missed_lsb,"
           "false_alarms,false_low,false_high,widest_false_lsb,varied,flipped");
    for (int kind = 0; kind < VARIANTS; kind++) {
      printf(",flipped_%s", variant_name[kind]);
    }
    puts(",triangles,nudged,changed_by_1_lsb,settled");
    return;
  }
  printf("%s, truth of the %s triangles\n", s->design, s->truth);
  printf("%-16s %9s %9s %9s %20s %9s %9s %20s %9s %9s %9s %9s\n", "family", "pairs", "collide",
         "missed", "share, 95 %", "deepest", "false", "share, 95 %", "widest", "flipped", "1 LSB",
         s->filter ? "settled" : "");
}

static inline void print_share(uint64_t k, uint64_t n) {
  double ends[2];
  char text[40];
  interval_of(k, n, ends);
  snprintf(text, sizeof text, "%.2g ... %.2g", ends[0], ends[1]);
  printf(" %9" PRIu64 " %20s", k, text);
}

static inline void print_percent(uint64_t k, uint64_t n) {
  if (n > 0) {
    printf(" %7.3f %%", 100 * (double)k / (double)n);
  } else {
    printf(" %9s", "-");
  }
}

static inline void print_csv(const row_style *s, const char *family, group of, const tally *t) {
  double missed[2];
  double alarms[2];
  interval_of(t->missed, t->collisions, missed);
  interval_of(t->alarms, t->pairs - t->collisions, alarms);
  printf("%s,%s,%s,%" PRIu64 ",%" PRIu64 ",%" PRIu64 ",%.4g,%.4g,%.6g", s->design, s->truth, family,
         t->pairs, t->collisions, t->missed, missed[0], missed[1], t->deepest);
  printf(",%" PRIu64 ",%.4g,%.4g,%.6g,%" PRIu64 ",%" PRIu64, t->alarms, alarms[0], alarms[1],
         t->widest, t->varied, t->flipped_any);
  for (int kind = 0; kind < VARIANTS; kind++) {
    printf(",%" PRIu64, t->flipped[kind]);
  }
  printf(",%s,%" PRIu64 ",%" PRIu64 ",", group_name[of], t->nudged, t->changed);
  if (s->filter) {
    printf("%" PRIu64, t->settled);
  }
  putchar('\n');
}

static inline void print_row(const row_style *s, const char *family, group of, const tally *t) {
  if (s->csv) {
    print_csv(s, family, of, t);
    return;
  }
  printf("%-16s %9" PRIu64 " %9" PRIu64, of == ANY ? family : group_row[of], t->pairs,
         t->collisions);
  print_share(t->missed, t->collisions);
  printf(" %9.4g", t->deepest);
  print_share(t->alarms, t->pairs - t->collisions);
  printf(" %9.4g", t->widest);
  print_percent(t->flipped_any, t->varied);
  print_percent(t->changed, t->nudged);
  if (s->filter) {
    print_percent(t->settled, t->pairs);
  }
  putchar('\n');
}

/* Print the row of all pairs. If `grouped` is true (always in CSV), then also print a row for each
 * group that has pairs. */
static inline void print_rows(const row_style *s, const char *family, const tally t[GROUPS],
                              bool grouped) {
  for (group of = ANY; of < GROUPS; of++) {
    if (of == ANY || ((s->csv || grouped) && t[of].pairs + t[of].varied > 0)) {
      print_row(s, family, of, &t[of]);
    }
  }
}

#endif
