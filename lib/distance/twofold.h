/* SPDX-License-Identifier: MIT */
/* twofold.h - numbers of twice the precision of a double (private).
 *
 * A value is high + low, |low| at most half a unit in the last place of high. With u = 2^-53 a sum
 * is wrong by 3 u^2 of itself at most, a product by 5 u^2, a quotient by 10 u^2, a root by 4 u^2
 * (Joldes, Muller, Popescu, "Tight and rigorous error bounds for basic building blocks of
 * double-word arithmetic", 2017); a product below 2^-960 by up to 2^-1060, too. Factors are below
 * 2^990 in size. */
#ifndef SEPAX_TWOFOLD_H
#define SEPAX_TWOFOLD_H

#include <math.h>
#include <stdbool.h>

typedef struct {
  double high, low;
} twofold;

typedef struct {
  twofold c[3];
} twofold_vector;

static inline twofold twofold_of(double x) { return (twofold){x, 0}; }

/* |a| >= |b|, or a = 0; exact. */
static inline twofold sum_of_ordered(double a, double b) {
  double s = a + b;
  return (twofold){s, b - (s - a)};
}

/* Exact. */
static inline twofold sum_of(double a, double b) {
  double s = a + b;
  double from_b = s - a;
  return (twofold){s, (a - (s - from_b)) + (b - from_b)};
}

/* Exact, but for underflow. Each factor is cut into halves of 26 bits. */
static inline twofold product_of(double a, double b) {
  const double cut = 0x1p27 + 1;
  double a_cut = cut * a;
  double b_cut = cut * b;
  double a_high = a_cut - (a_cut - a);
  double b_high = b_cut - (b_cut - b);
  double a_low = a - a_high;
  double b_low = b - b_high;
  double p = a * b;
  return (twofold){p, ((a_high * b_high - p) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

static inline twofold twofold_add(twofold a, twofold b) {
  twofold s = sum_of(a.high, b.high);
  twofold t = sum_of(a.low, b.low);
  s = sum_of_ordered(s.high, s.low + t.high);
  return sum_of_ordered(s.high, s.low + t.low);
}

static inline twofold twofold_minus(twofold a) { return (twofold){-a.high, -a.low}; }

static inline twofold twofold_subtract(twofold a, twofold b) {
  return twofold_add(a, twofold_minus(b));
}

static inline twofold twofold_multiply(twofold a, twofold b) {
  twofold p = product_of(a.high, b.high);
  return sum_of_ordered(p.high, p.low + (a.high * b.low + a.low * b.high));
}

static inline twofold twofold_divide(twofold a, twofold b) {
  double q = a.high / b.high;
  twofold rest = twofold_subtract(a, twofold_multiply(twofold_of(q), b));
  return sum_of_ordered(q, rest.high / b.high);
}

static inline twofold twofold_root(twofold a) {
  if (!(a.high > 0)) {
    return twofold_of(0);
  }
  double r = sqrt(a.high);
  twofold rest = twofold_subtract(a, product_of(r, r));
  return sum_of_ordered(r, rest.high / (2 * r));
}

/* Times 2^exponent. */
static inline twofold twofold_scaled(twofold a, int exponent) {
  return (twofold){ldexp(a.high, exponent), ldexp(a.low, exponent)};
}

static inline twofold twofold_dot(const twofold_vector *p, const twofold_vector *q) {
  twofold r = twofold_multiply(p->c[0], q->c[0]);
  for (int i = 1; i < 3; i++) {
    r = twofold_add(r, twofold_multiply(p->c[i], q->c[i]));
  }
  return r;
}

static inline twofold_vector twofold_cross(const twofold_vector *p, const twofold_vector *q) {
  twofold_vector r;
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3;
    int k = (i + 2) % 3;
    r.c[i] =
        twofold_subtract(twofold_multiply(p->c[j], q->c[k]), twofold_multiply(p->c[k], q->c[j]));
  }
  return r;
}

static inline bool twofold_less(twofold a, twofold b) {
  return a.high < b.high || (a.high == b.high && a.low < b.low);
}

#endif
