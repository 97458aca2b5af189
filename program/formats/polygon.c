/* polygon.c - a polygon as triangles between its corners. */
#include "formats/formats.h"
#include "util/vector.h"

/* Twice the area of a triangle as a vector. */
static void area_of(const double a[3], const double b[3], const double c[3], double area[3]) {
  double p[3];
  double q[3];
  for (int i = 0; i < 3; i++) {
    p[i] = b[i] - a[i];
    q[i] = c[i] - a[i];
  }
  vector_cross(p, q, area);
}

/* All triangles of this corner turn the same way as the polygon. */
static bool sees_all(const double (*corner)[3], size_t count, size_t from, const double whole[3]) {
  for (size_t n = 1; n + 1 < count; n++) {
    double area[3];
    area_of(corner[from], corner[(from + n) % count], corner[(from + n + 1) % count], area);
    if (!(vector_dot(area, whole) >= 0)) {
      return false;
    }
  }
  return true;
}

bool format_polygon_divide(const double (*corner)[3], size_t count, size_t (*triangle)[3]) {
  enum { CORNERS_SEARCHED = 2000 };
  double whole[3] = {0, 0, 0};
  for (size_t n = 1; n + 1 < count; n++) {
    double area[3];
    area_of(corner[0], corner[n], corner[n + 1], area);
    for (int i = 0; i < 3; i++) {
      whole[i] += area[i];
    }
  }
  size_t tries = count > CORNERS_SEARCHED ? 1 : count;
  size_t from = 0;
  while (from < tries && count > 3 && !sees_all(corner, count, from, whole)) {
    from++;
  }
  for (size_t n = 1; n + 1 < count && from < tries; n++) {
    triangle[n - 1][0] = from;
    triangle[n - 1][1] = (from + n) % count;
    triangle[n - 1][2] = (from + n + 1) % count;
  }
  return from < tries;
}
