#include "clear_rules.h"

#include <math.h>

static const char *const names[RULES] = {"length",          "model",         "sum",
                                         "without x and y", "without edges", "products",
                                         "boxes",           "no rounding",   "length, wrong"};

const char *clear_rule_name(clear_rule rule) { return names[rule]; }

typedef struct {
  double c[3];
} vec;

static vec minus(vec p, vec q) {
  return (vec){{p.c[0] - q.c[0], p.c[1] - q.c[1], p.c[2] - q.c[2]}};
}

static vec outer(vec p, vec q) {
  return (vec){{p.c[1] * q.c[2] - p.c[2] * q.c[1], p.c[2] * q.c[0] - p.c[0] * q.c[2],
                p.c[0] * q.c[1] - p.c[1] * q.c[0]}};
}

static double inner(vec p, vec q) { return p.c[0] * q.c[0] + p.c[1] * q.c[1] + p.c[2] * q.c[2]; }

static double sum_of(vec p) { return fabs(p.c[0]) + fabs(p.c[1]) + fabs(p.c[2]); }

static double most_of(vec p) { return fmax(fabs(p.c[0]), fmax(fabs(p.c[1]), fabs(p.c[2]))); }

/* `bound`: of |c|_1, for the rule that has no better. */
static bool axis_clears(clear_rule rule, const vec p[6], vec c, double bound, double d) {
  double low[2] = {INFINITY, INFINITY};
  double high[2] = {-INFINITY, -INFINITY};
  for (int k = 0; k < 6; k++) {
    double at = inner(c, minus(p[k], p[0]));
    low[k / 3] = fmin(low[k / 3], at);
    high[k / 3] = fmax(high[k / 3], at);
  }
  double gap = fmax(low[0] - high[1], low[1] - high[0]);
  double length = sqrt(inner(c, c));
  double limit = sum_of(c) + 0.5 * d * (sum_of(c) + most_of(c));
  switch (rule) {
  case RULE_EUCLID:
    limit = sum_of(c) + d * length;
    break;
  case RULE_SUM:
    limit = (1 + d) * sum_of(c);
    break;
  case RULE_PRODUCTS:
    limit = (1 + d) * bound;
    break;
  case RULE_NO_ROUNDING:
    limit = d * sum_of(c);
    break;
  case RULE_LENGTH:
    limit = (1 + d) * length;
    break;
  default:
    break;
  }
  return length > 0 && gap > limit;
}

static bool edges_clear(clear_rule rule, const vec p[6], const vec edge[6], double d) {
  int first = rule == RULE_XY || rule == RULE_PRODUCTS ? 2 : rule == RULE_NO_EDGE ? 3 : 0;
  for (int i = 0; i < 6; i++) {
    for (int axis = first; axis < 3; axis++) {
      vec unit = {{axis == 0, axis == 1, axis == 2}};
      vec c = outer(edge[i], unit);
      if (axis_clears(rule, p, c, sum_of(c), d)) {
        return true;
      }
    }
  }
  return false;
}

bool clear_by(clear_rule rule, const sepax_tri *a, const sepax_tri *b, double d) {
  vec p[6];
  vec edge[6];
  for (int i = 0; i < 6; i++) {
    sepax_vec v = i < 3 ? a->v[i] : b->v[i - 3];
    p[i] = (vec){{v.x, v.y, v.z}};
  }
  for (int i = 0; i < 6; i++) {
    edge[i] = minus(p[i / 3 * 3 + (i + 1) % 3], p[i]);
  }
  for (int axis = 0; axis < 3; axis++) {
    vec unit = {{axis == 0, axis == 1, axis == 2}};
    if (axis_clears(rule, p, unit, 1, d)) {
      return true;
    }
  }
  if (rule == RULE_BOXES) {
    return false;
  }
  for (int i = 0; i < 5; i++) {
    for (int j = i + 1; j < 6; j++) {
      if (axis_clears(rule, p, outer(edge[i], edge[j]), sum_of(edge[i]) * sum_of(edge[j]), d)) {
        return true;
      }
    }
  }
  return edges_clear(rule, p, edge, d);
}
