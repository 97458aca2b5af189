/* surface.c - triangles of STL files, boxes, cylinders and spheres. */
#include "surface.h"

#include "report.h"

#include <ctype.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* Corners of a cylinder's ends; of a sphere's equator, which has half as many rings. */
enum { SEGMENTS = 256, RINGS = SEGMENTS / 2 };

static const long double PI = 3.14159265358979323846264338327950288L;

/* Above the rounding of a polyhedron's corners. */
static const long double OUTWARD = 1 + 1e-12L;

void surface_element(surface *s) {
  GROW(s->element, s->elements);
  s->element[s->elements++] = s->count;
}

static void add(surface *s, pose at, point a, point b, point c) {
  GROW(s->triangle, s->count);
  s->triangle[s->count++] =
      (triangle){{point_near(pose_apply(at, a)), point_near(pose_apply(at, b)),
                  point_near(pose_apply(at, c))}};
}

static point scaled(const long double *v, point scale) {
  return (point){v[0] * scale.x, v[1] * scale.y, v[2] * scale.z};
}

static void add_checked(surface *s, const char *file, const long double v[9], point scale,
                        pose at) {
  for (int n = 0; n < 9; n++) {
    if (!isfinite(v[n]))
      cannot("%s: a coordinate is not finite", file);
  }
  add(s, at, scaled(v, scale), scaled(v + 3, scale), scaled(v + 6, scale));
}

static uint32_t little(const char *bytes) {
  uint32_t value = 0;
  for (int n = 3; n >= 0; n--)
    value = value << 8 | (unsigned char)bytes[n];
  return value;
}

static void read_binary(surface *s, const char *file, const char *text, point scale, pose at) {
  const uint32_t count = little(text + 80);
  for (uint32_t n = 0; n < count; n++) {
    const char *record = text + 84 + 50 * (size_t)n + 12;
    long double v[9];
    for (size_t k = 0; k < 9; k++) {
      const uint32_t bits = little(record + 4 * k);
      float value = 0;
      memcpy(&value, &bits, sizeof value);
      v[k] = value;
    }
    add_checked(s, file, v, scale, at);
  }
}

/* The words `vertex` with three numbers behind each; three of them make a facet. */
static void read_ascii(surface *s, const char *file, const char *text, point scale, pose at) {
  long double v[9];
  int have = 0;
  const char *next = text;
  for (;;) {
    while (isspace((unsigned char)*next))
      next++;
    const char *word = next;
    while (*next != 0 && !isspace((unsigned char)*next))
      next++;
    const size_t length = (size_t)(next - word);
    if (length == 0)
      break;
    if (length == 8 && strncmp(word, "endfacet", 8) == 0) {
      if (have != 9)
        cannot("%s: a facet without three vertices", file);
      add_checked(s, file, v, scale, at);
      have = 0;
    } else if (length == 6 && strncmp(word, "vertex", 6) == 0) {
      if (have > 6)
        cannot("%s: a facet of more than three vertices", file);
      for (int n = 0; n < 3 && have < 9; n++) {
        char *end = NULL;
        v[have++] = strtold(next, &end);
        if (end == next)
          cannot("%s: a vertex without three numbers", file);
        next = end;
      }
    }
  }
  if (have != 0)
    cannot("%s: ends within a facet", file);
}

void surface_stl(surface *s, const char *file, point scale, pose at) {
  size_t length = 0;
  char *text = file_read(file, &length);
  const size_t before = s->count;
  if (length >= 84 && length == 84 + 50 * (size_t)little(text + 80)) {
    read_binary(s, file, text, scale, at);
  } else if (strncmp(text, "solid", 5) == 0) {
    read_ascii(s, file, text, scale, at);
  } else {
    cannot("%s: is no STL file", file);
  }
  if (s->count == before)
    cannot("%s: has no triangle", file);
  free(text);
}

static void quad(surface *s, pose at, point a, point b, point c, point d) {
  add(s, at, a, b, c);
  add(s, at, a, c, d);
}

void surface_box(surface *s, point size, pose at) {
  point corner[8];
  for (int n = 0; n < 8; n++) {
    corner[n] = (point){n & 1 ? size.x / 2 : -size.x / 2, n & 2 ? size.y / 2 : -size.y / 2,
                        n & 4 ? size.z / 2 : -size.z / 2};
  }
  static const int SIDE[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                 {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (int n = 0; n < 6; n++) {
    quad(s, at, corner[SIDE[n][0]], corner[SIDE[n][1]], corner[SIDE[n][2]], corner[SIDE[n][3]]);
  }
}

/* n of SEGMENTS on a circle; the same numbers for the last as for the first. */
static point on_circle(int n, long double radius, long double z) {
  const long double angle = 2 * PI * (n % SEGMENTS) / SEGMENTS;
  return (point){radius * cosl(angle), radius * sinl(angle), z};
}

static void stands_out(surface *s, long double length) {
  s->rounded = fmax(s->rounded, (double)length);
}

/* The middles of the sides are as far from the axis as the corners times cos(pi / SEGMENTS). */
void surface_cylinder(surface *s, long double radius, long double length, pose at) {
  const long double outer = radius / cosl(PI / SEGMENTS) * OUTWARD;
  const long double half = length / 2 * OUTWARD;
  const point bottom = {0, 0, -half};
  const point top = {0, 0, half};
  for (int n = 0; n < SEGMENTS; n++) {
    const point low = on_circle(n, outer, -half);
    const point next = on_circle(n + 1, outer, -half);
    const point over = on_circle(n, outer, half);
    const point next_over = on_circle(n + 1, outer, half);
    quad(s, at, low, next, next_over, over);
    add(s, at, bottom, next, low);
    add(s, at, top, over, next_over);
  }
  stands_out(s, outer - radius + half - length / 2);
}

/* A face's distance from the centre: the chord of a meridian, pi / RINGS long, is cos(pi / 2 RINGS)
 * radii away, and a face between two meridians is this chord, squeezed towards the sphere's axis by
 * cos(pi / SEGMENTS), which brings no line nearer by more than that factor. */
void surface_sphere(surface *s, long double radius, pose at) {
  const long double outer = radius / cosl(PI / SEGMENTS) / cosl(PI / (2 * RINGS)) * OUTWARD;
  for (int ring = 0; ring < RINGS; ring++) {
    const long double below = PI * ring / RINGS;
    const long double above = PI * (ring + 1) / RINGS;
    /* At the poles sine is 0, so that the faces close. */
    const long double r0 = ring == 0 ? 0 : outer * sinl(below);
    const long double r1 = ring == RINGS - 1 ? 0 : outer * sinl(above);
    const long double z0 = -outer * cosl(below);
    const long double z1 = -outer * cosl(above);
    for (int n = 0; n < SEGMENTS; n++) {
      const point a = on_circle(n, r0, z0);
      const point b = on_circle(n + 1, r0, z0);
      const point c = on_circle(n + 1, r1, z1);
      const point d = on_circle(n, r1, z1);
      if (ring > 0)
        add(s, at, a, b, c);
      if (ring < RINGS - 1)
        add(s, at, a, c, d);
    }
  }
  stands_out(s, outer - radius);
}

void surface_finish(surface *s) {
  s->low = s->high = s->triangle[0].at[0];
  for (size_t n = 0; n < s->count; n++) {
    for (int k = 0; k < 3; k++) {
      const vec p = s->triangle[n].at[k];
      s->low = (vec){fmin(s->low.x, p.x), fmin(s->low.y, p.y), fmin(s->low.z, p.z)};
      s->high = (vec){fmax(s->high.x, p.x), fmax(s->high.y, p.y), fmax(s->high.z, p.z)};
      s->radius = fmax(s->radius, vec_length(p) * (1 + 1e-12));
    }
  }
}
