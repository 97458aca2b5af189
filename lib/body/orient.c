/* SPDX-License-Identifier: MIT */
/* orient.c - on which side of a line or of a plane a point is, exactly. */
#include "body/orient.h"
#include "body/big.h"
#include "body/number.h"

#include <math.h>
#include <stdbool.h>

/* Below this size doubles do not decide, because underflow can cost a product up to 2^-1074. */
static const double tiny = 0x1p-900;

/* From here on a product may be infinite. */
static const double huge = 0x1p1000;

static int sign_of(double x) { return (x > 0) - (x < 0); }

/* r = p - q in units of 2^unit; p and q are multiples of this unit. */
static void subtract(big *r, double p, double q, int unit) {
  number a = number_of(p);
  number b = number_of(q);
  big_set_zero(r);
  if (a.sign != 0) {
    big_add_shifted(r, a.sign, a.size, a.exponent - unit);
  }
  if (b.sign != 0) {
    big_add_shifted(r, -b.sign, b.size, b.exponent - unit);
  }
}

static int lower_unit(int unit, const double *v, int count) {
  for (int i = 0; i < count; i++) {
    number n = number_of(v[i]);
    unit = n.sign != 0 && n.exponent < unit ? n.exponent : unit;
  }
  return unit;
}

/* r = p q - s t. */
static void subtract_products(big *r, const big *p, const big *q, const big *s, const big *t) {
  big product;
  big_multiply(r, p, q);
  big_multiply(&product, s, t);
  big_subtract(r, r, &product);
}

static int orient2d_exactly(const double a[2], const double b[2], const double c[2]) {
  big u[2];
  big v[2];
  big area;
  int unit = lower_unit(lower_unit(lower_unit(2000, a, 2), b, 2), c, 2);
  for (int i = 0; i < 2; i++) {
    subtract(&u[i], b[i], a[i], unit);
    subtract(&v[i], c[i], a[i], unit);
  }
  subtract_products(&area, &u[0], &v[1], &u[1], &v[0]);
  return area.sign;
}

static bool is_zero(double x) { return !(x < 0 || x > 0); }

/* True if b - a was not rounded: then it gives a and b back. */
static bool is_exact(double a, double b, double difference) {
  const double back = b - difference;
  const double forth = difference + back;
  return is_zero(back - a) && is_zero(forth - b);
}

/* A difference is zero only if it is exactly zero. Each product is wrong by at most 3 u of its
 * size, u = 2^-53, and the difference of the products by u more. Two products of exact differences
 * that are rounded to one double differ by what they were rounded by, which fma has exactly: this
 * is so for three points on a line of a wall, and much faster than integers. */
int sepax__orient2d(const double a[2], const double b[2], const double c[2]) {
  double u[2] = {b[0] - a[0], b[1] - a[1]};
  double v[2] = {c[0] - a[0], c[1] - a[1]};
  if ((is_zero(u[0]) || is_zero(v[1])) && (is_zero(u[1]) || is_zero(v[0]))) {
    return 0;
  }
  double left = u[0] * v[1];
  double right = u[1] * v[0];
  double limit = 5 * 0x1p-53 * (fabs(left) + fabs(right)) + tiny;
  if (fabs(left - right) > limit) {
    return sign_of(left - right);
  }
  if (is_zero(left - right) && fabs(left) > tiny && fabs(left) < huge &&
      is_exact(a[0], b[0], u[0]) && is_exact(a[1], b[1], u[1]) && is_exact(a[0], c[0], v[0]) &&
      is_exact(a[1], c[1], v[1])) {
    return sign_of(fma(u[0], v[1], -left) - fma(u[1], v[0], -right));
  }
  return orient2d_exactly(a, b, c);
}

static int orient3d_exactly(const double a[3], const double b[3], const double c[3],
                            const double d[3]) {
  const double *end[3] = {b, c, d};
  big v[3][3];
  big area;
  big term;
  big volume;
  int unit = lower_unit(lower_unit(2000, a, 3), b, 3);
  unit = lower_unit(lower_unit(unit, c, 3), d, 3);
  for (int k = 0; k < 9; k++) {
    subtract(&v[k / 3][k % 3], end[k / 3][k % 3], a[k % 3], unit);
  }
  big_set_zero(&volume);
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3;
    int k = (i + 2) % 3;
    subtract_products(&area, &v[0][j], &v[1][k], &v[0][k], &v[1][j]);
    big_multiply(&term, &area, &v[2][i]);
    big_add(&volume, &volume, &term);
  }
  return volume.sign;
}

/* If differences are wrong by u of their size, then `volume` is wrong by at most 9 u of the sum of
 * the sizes of all six products. An area that underflows is wrong by less than 2^-1073 before it is
 * multiplied. */
int sepax__orient3d(const double a[3], const double b[3], const double c[3], const double d[3]) {
  double v[3][3];
  for (int i = 0; i < 3; i++) {
    v[0][i] = b[i] - a[i];
    v[1][i] = c[i] - a[i];
    v[2][i] = d[i] - a[i];
  }
  double volume = 0;
  double sizes = 0;
  double heights = 0;
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3;
    int k = (i + 2) % 3;
    double left = v[0][j] * v[1][k];
    double right = v[0][k] * v[1][j];
    volume += (left - right) * v[2][i];
    sizes += (fabs(left) + fabs(right)) * fabs(v[2][i]);
    heights += fabs(v[2][i]);
  }
  /* if all differences of a coordinate are zero, then nothing is rounded */
  for (int i = 0; i < 3; i++) {
    if (is_zero(v[0][i]) && is_zero(v[1][i]) && is_zero(v[2][i])) {
      return 0;
    }
  }
  double limit = 16 * 0x1p-53 * sizes + 0x1p-1060 * heights + tiny;
  return fabs(volume) > limit ? sign_of(volume) : orient3d_exactly(a, b, c, d);
}
