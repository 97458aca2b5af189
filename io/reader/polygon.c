/* SPDX-License-Identifier: MIT */
/* polygon.c - a polygon as triangles: its plane, its views, and the fan. */
#include "reader/polygon.h"
#include "reader/ears.h"
#include "body/orient.h"

#include <math.h>

static bool same_point(const double p[3], const double q[3]) {
  return !(p[0] < q[0] || p[0] > q[0] || p[1] < q[1] || p[1] > q[1] || p[2] < q[2] || p[2] > q[2]);
}

/* Orientation of a, b, c as seen along the axis. */
static int orient_seen(const double a[3], const double b[3], const double c[3], int axis) {
  int x = (axis + 1) % 3;
  int y = (axis + 2) % 3;
  return sepax__orient2d((double[2]){a[x], a[y]}, (double[2]){b[x], b[y]}, (double[2]){c[x], c[y]});
}

static bool on_line(const double a[3], const double b[3], const double c[3]) {
  return orient_seen(a, b, c, 0) == 0 && orient_seen(a, b, c, 1) == 0 &&
         orient_seen(a, b, c, 2) == 0;
}

/* --------------------------------------------------------------------- its plane */

/* Find three corners that are not on one line, the first corner among them. False if there are
 * none. */
static bool find_base(const double (*corner)[3], size_t count, size_t base[3]) {
  base[0] = 0;
  for (base[1] = 1; base[1] < count && same_point(corner[0], corner[base[1]]);) {
    base[1]++;
  }
  for (base[2] = base[1] + 1; base[2] < count; base[2]++) {
    if (!on_line(corner[0], corner[base[1]], corner[base[2]])) {
      return true;
    }
  }
  return false;
}

/* True if two opposite sides of four corners are equal vectors; then so are the other two. */
static bool is_parallelogram(const double (*corner)[3]) {
  for (int i = 0; i < 3; i++) {
    double a = corner[0][i];
    double b = corner[1][i];
    double c = corner[2][i];
    double d = corner[3][i];
    bool sides = (a <= b && a >= b && c <= d && c >= d) || (a <= d && a >= d && b <= c && b >= c);
    if (!sides) {
      return false;
    }
  }
  return true;
}

static bool is_bent(const double (*corner)[3], size_t count, const size_t base[3]) {
  if (count == 4 && is_parallelogram(corner)) {
    return false;
  }
  for (size_t n = base[1] + 1; n < count; n++) {
    if (n != base[2] &&
        sepax__orient3d(corner[0], corner[base[1]], corner[base[2]], corner[n]) != 0) {
      return true;
    }
  }
  return false;
}

/* --------------------------------------------------------------------- its views */

/* Twice the area along each axis, with coordinates times `scale`. */
static void find_area(const double (*corner)[3], size_t count, double scale, double area[3]) {
  area[0] = area[1] = area[2] = 0;
  for (size_t n = 1; n + 1 < count; n++) {
    double p[3];
    double q[3];
    for (int i = 0; i < 3; i++) {
      p[i] = scale * (corner[n][i] - corner[0][i]);
      q[i] = scale * (corner[n + 1][i] - corner[0][i]);
    }
    for (int i = 0; i < 3; i++) {
      int j = (i + 1) % 3;
      int k = (i + 2) % 3;
      area[i] += p[j] * q[k] - p[k] * q[j];
    }
  }
}

/* Order the axes by area, the largest first. */
static void order_axes(const double (*corner)[3], size_t count, int axis[3], double area[3]) {
  find_area(corner, count, 1, area);
  double most = fmax(fabs(area[0]), fmax(fabs(area[1]), fabs(area[2])));
  if (!(most > 0x1p-900 && most < 0x1p900)) { /* or a product is infinite or was lost */
    double size = 0;
    for (size_t n = 0; n < count; n++) {
      for (int i = 0; i < 3; i++) {
        size = fmax(size, fabs(corner[n][i] - corner[0][i]));
      }
    }
    int exponent = 0;
    frexp(size, &exponent);
    find_area(corner, count, ldexp(1, exponent > -1000 ? -exponent : 1000), area);
  }
  for (int i = 0; i < 3; i++) {
    axis[i] = i;
  }
  for (int i = 1; i < 3; i++) {
    for (int k = i; k > 0 && fabs(area[axis[k]]) > fabs(area[axis[k - 1]]); k--) {
      int one = axis[k];
      axis[k] = axis[k - 1];
      axis[k - 1] = one;
    }
  }
}

/* ----------------------------------------------------------------------- the fan */

/* The first corner sees all others in their order, in less than one turn: once the corners have
 * passed behind it, seen along its first edge, they stay there. */
static bool is_fan(const double (*corner)[3], size_t count, int axis) {
  int way = orient_seen(corner[0], corner[1], corner[2], axis);
  bool behind = false;
  for (size_t n = 2; n + 1 < count; n++) {
    if (way == 0 || orient_seen(corner[0], corner[n], corner[n + 1], axis) != way) {
      return false;
    }
    int side = count > 4 ? way * orient_seen(corner[0], corner[1], corner[n + 1], axis) : 0;
    if (behind && side >= 0) {
      return false;
    }
    behind = behind || side < 0;
  }
  return way != 0;
}

void sepax__polygon_fan(size_t count, size_t first, size_t (*triangle)[3]) {
  for (size_t n = 1; n + 1 < count; n++) {
    triangle[n - 1][0] = first;
    triangle[n - 1][1] = (first + n) % count;
    triangle[n - 1][2] = (first + n + 1) % count;
  }
}

/* ------------------------------------------------------------------- the polygon */

polygon_result sepax__polygon_divide(const double (*corner)[3], size_t count, size_t (*triangle)[3],
                                     bool *bent) {
  size_t base[3];
  int axis[3];
  double area[3];
  *bent = false;
  if (!find_base(corner, count, base)) {
    sepax__polygon_fan(count, 0, triangle);
    return POLYGON_DIVIDED;
  }
  *bent = is_bent(corner, count, base);
  order_axes(corner, count, axis, area);
  if (is_fan(corner, count, axis[0])) {
    sepax__polygon_fan(count, 0, triangle);
    return POLYGON_DIVIDED;
  }
  if (count > POLYGON_CORNERS_MOST) {
    return POLYGON_LONG;
  }
  for (int k = 0; k < 3; k++) {
    /* A plane that is seen from its side shows nothing. */
    bool seen = *bent || orient_seen(corner[0], corner[base[1]], corner[base[2]], axis[k]) != 0;
    if (!seen) {
      continue;
    }
    polygon_result result =
        sepax__cut_ears(corner, count, axis[k], area[axis[k]] < 0, !*bent, triangle);
    if (result != POLYGON_CROSSES || !*bent) {
      return result;
    }
  }
  /* Two triangles that share an edge, and are in no common plane, meet nowhere else. */
  if (*bent && count == 4) {
    sepax__polygon_fan(count, 0, triangle);
    return POLYGON_DIVIDED;
  }
  return POLYGON_CROSSES;
}
