/* SPDX-License-Identifier: MIT */
#include "clearance_rules.h"

#include "geometry.h"

#include <math.h>

static const char *const names[RULES] = {"length",          "model",         "sum",
                                         "without x and y", "without edges", "products",
                                         "boxes",           "no rounding",   "length, wrong"};

const char *clear_rule_name(clear_rule rule) { return names[rule]; }

static double sum_of(point p) { return fabs(p.c[0]) + fabs(p.c[1]) + fabs(p.c[2]); }

static double most_of(point p) { return fmax(fabs(p.c[0]), fmax(fabs(p.c[1]), fabs(p.c[2]))); }

/* `bound`: of |c|_1, for the rule that has no better. */
static bool axis_clears(clear_rule rule, const point p[6], point c, double bound, double d) {
  double low[2] = {INFINITY, INFINITY};
  double high[2] = {-INFINITY, -INFINITY};
  for (int k = 0; k < 6; k++) {
    double at = inner(c, minus(p[k], p[0]));
    low[k / 3] = fmin(low[k / 3], at);
    high[k / 3] = fmax(high[k / 3], at);
  }
  double gap = fmax(low[0] - high[1], low[1] - high[0]);
  double length = sqrt(inner(c, c));
  double sum = sum_of(c);
  double limit = rule == RULE_EUCLID        ? sum + d * length
                 : rule == RULE_SUM         ? (1 + d) * sum
                 : rule == RULE_PRODUCTS    ? (1 + d) * bound
                 : rule == RULE_NO_ROUNDING ? d * sum
                 : rule == RULE_LENGTH      ? (1 + d) * length
                                            : sum + 0.5 * d * (sum + most_of(c));
  return length > 0 && gap > limit;
}

bool clear_by(clear_rule rule, const sepax_tri *a, const sepax_tri *b, double d) {
  static const point unit[3] = {{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}};
  int first = rule == RULE_XY || rule == RULE_PRODUCTS ? 2 : rule == RULE_NO_EDGE ? 3 : 0;
  point p[6];
  point e[6];
  for (int i = 0; i < 6; i++) {
    const sepax_vec *v = i < 3 ? a->v : b->v;
    p[i] = point_of(v[i % 3]);
    e[i] = minus(point_of(v[(i + 1) % 3]), p[i]);
  }
  bool clear = false;
  for (int axis = 0; axis < 3; axis++) {
    clear = clear || axis_clears(rule, p, unit[axis], 1, d);
  }
  for (int i = 0; i < 6 && rule != RULE_BOXES; i++) {
    for (int j = i + 1; j < 6; j++) {
      clear = clear || axis_clears(rule, p, outer(e[i], e[j]), sum_of(e[i]) * sum_of(e[j]), d);
    }
    for (int axis = first; axis < 3; axis++) {
      point c = outer(e[i], unit[axis]);
      clear = clear || axis_clears(rule, p, c, sum_of(c), d);
    }
  }
  return clear;
}
