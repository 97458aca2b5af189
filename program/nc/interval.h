/* SPDX-License-Identifier: MIT */
/* interval.h - intervals of real numbers, and functions of one variable with their first two
 * derivatives in intervals (private to program/nc).
 *
 * Each result contains every value that the operation has on numbers of its operands. A result of
 * IEEE arithmetic to the nearest differs from the exact value by at most 2^-53 of itself, or by
 * 2^-1075 if it underflows. nc_below and nc_above move a result by 2^-51 of itself and by 2^-500,
 * so the moved number lies beyond the exact value although moving it is rounded, too. Operands are
 * at most 1e30, so nothing overflows. */
#ifndef SEPAX_NC_INTERVAL_H
#define SEPAX_NC_INTERVAL_H

#include <math.h>

typedef struct {
  double lo, hi; /* lo <= hi */
} nc_interval;

/* A function f(t) for t in some interval: v contains f, d contains f', dd contains f''. */
typedef struct {
  nc_interval v, d, dd;
} nc_jet;

static inline double nc_below(double x) { return x - (fabs(x) * 0x1p-51 + 0x1p-500); }
static inline double nc_above(double x) { return x + (fabs(x) * 0x1p-51 + 0x1p-500); }
static inline double nc_least(double a, double b) { return a < b ? a : b; }
static inline double nc_most(double a, double b) { return a > b ? a : b; }

static inline nc_interval nc_point(double x) { return (nc_interval){x, x}; }

/* The result x of one rounded operation, and what it may have been. */
static inline nc_interval nc_around(double x) { return (nc_interval){nc_below(x), nc_above(x)}; }

/* The largest absolute value. */
static inline double nc_size(nc_interval a) { return nc_most(fabs(a.lo), fabs(a.hi)); }

static inline nc_interval nc_hull(nc_interval a, nc_interval b) {
  return (nc_interval){nc_least(a.lo, b.lo), nc_most(a.hi, b.hi)};
}

static inline nc_interval nc_add(nc_interval a, nc_interval b) {
  return (nc_interval){nc_below(a.lo + b.lo), nc_above(a.hi + b.hi)};
}

static inline nc_interval nc_minus(nc_interval a) { return (nc_interval){-a.hi, -a.lo}; }

static inline nc_interval nc_subtract(nc_interval a, nc_interval b) {
  return (nc_interval){nc_below(a.lo - b.hi), nc_above(a.hi - b.lo)};
}

static inline nc_interval nc_times(nc_interval a, nc_interval b) {
  double p = a.lo * b.lo, q = a.lo * b.hi, r = a.hi * b.lo, s = a.hi * b.hi;
  return (nc_interval){nc_below(nc_least(nc_least(p, q), nc_least(r, s))),
                       nc_above(nc_most(nc_most(p, q), nc_most(r, s)))};
}

/* The quotient by an interval without 0. */
static inline nc_interval nc_over(nc_interval a, nc_interval b) {
  return nc_times(a, (nc_interval){nc_below(1 / b.hi), nc_above(1 / b.lo)});
}

/* The square root of a number that is not negative; `a` may reach below 0 by rounding. */
static inline nc_interval nc_root(nc_interval a) {
  double lo = nc_below(sqrt(nc_most(a.lo, 0)));
  return (nc_interval){nc_most(lo, 0), nc_above(sqrt(nc_most(a.hi, 0)))};
}

/* How far a point of the interval may be from x, rounded up. */
static inline double nc_farthest(nc_interval a, double x) {
  return nc_above(nc_most(fabs(a.hi - x), fabs(a.lo - x)));
}

static inline double nc_middle(nc_interval a) { return a.lo + (a.hi - a.lo) / 2; }

/* Sine and cosine of an angle in radians. With the middle m and the half width h:
 * sin(m + e) = sin m cos e + cos m sin e, so |sin(m + e) - sin m| <= h |cos m| + h^2 / 2, and the
 * same holds for the cosine. C libraries compute both to less than 2^-52; 2^-50 is allowed here. */
static inline void nc_circle(nc_interval angle, nc_interval *sine, nc_interval *cosine) {
  double m = nc_middle(angle), h = nc_farthest(angle, m);
  double s = sin(m), c = cos(m);
  double from_s = nc_above(h * (fabs(c) + h / 2) * (1 + 0x1p-40) + 0x1p-50);
  double from_c = nc_above(h * (fabs(s) + h / 2) * (1 + 0x1p-40) + 0x1p-50);
  *sine = (nc_interval){nc_most(nc_below(s - from_s), -1), nc_least(nc_above(s + from_s), 1)};
  *cosine = (nc_interval){nc_most(nc_below(c - from_c), -1), nc_least(nc_above(c + from_c), 1)};
}

/* ------------------------------------------------------------------------ jets */

static inline nc_jet nc_still(nc_interval value) {
  return (nc_jet){.v = value, .d = nc_point(0), .dd = nc_point(0)};
}

static inline nc_jet nc_jet_add(nc_jet a, nc_jet b) {
  return (nc_jet){nc_add(a.v, b.v), nc_add(a.d, b.d), nc_add(a.dd, b.dd)};
}

static inline nc_jet nc_jet_subtract(nc_jet a, nc_jet b) {
  return (nc_jet){nc_subtract(a.v, b.v), nc_subtract(a.d, b.d), nc_subtract(a.dd, b.dd)};
}

/* (a b)'' = a'' b + 2 a' b' + a b''. */
static inline nc_jet nc_jet_times(nc_jet a, nc_jet b) {
  nc_interval both = nc_times(a.d, b.d);
  return (nc_jet){nc_times(a.v, b.v), nc_add(nc_times(a.d, b.v), nc_times(a.v, b.d)),
                  nc_add(nc_add(nc_times(a.dd, b.v), nc_times(a.v, b.dd)), nc_add(both, both))};
}

static inline nc_jet nc_jet_scale(nc_jet a, nc_interval by) {
  return (nc_jet){nc_times(a.v, by), nc_times(a.d, by), nc_times(a.dd, by)};
}

/* Of an angle in radians: (sin a)'' = a'' cos a - a'^2 sin a. */
static inline void nc_jet_circle(nc_jet angle, nc_jet *sine, nc_jet *cosine) {
  nc_interval s, c, square = nc_times(angle.d, angle.d);
  nc_circle(angle.v, &s, &c);
  *sine =
      (nc_jet){s, nc_times(angle.d, c), nc_subtract(nc_times(angle.dd, c), nc_times(square, s))};
  *cosine = (nc_jet){c, nc_minus(nc_times(angle.d, s)),
                     nc_minus(nc_add(nc_times(angle.dd, s), nc_times(square, c)))};
}

#endif
