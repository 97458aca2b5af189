/* SPDX-License-Identifier: MIT */
/* space.h - points with integer coordinates, exact products of them, and random numbers.
 *
 * Coordinates stay below 2^22, so a product of two fits int64_t and all others fit `wide`. */
#ifndef MATERIAL_SPACE_H
#define MATERIAL_SPACE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef __int128 wide;
typedef struct {
  int64_t x[3];
} point;
typedef struct {
  wide x[3];
} axis; /* a vector that is a product of others */
typedef struct {
  uint64_t state;
} generator;

static inline point minus(point a, point b) {
  return (point){{a.x[0] - b.x[0], a.x[1] - b.x[1], a.x[2] - b.x[2]}};
}
static inline point plus(point a, point b) {
  return (point){{a.x[0] + b.x[0], a.x[1] + b.x[1], a.x[2] + b.x[2]}};
}
static inline point times(point a, int64_t t) {
  return (point){{t * a.x[0], t * a.x[1], t * a.x[2]}};
}
static inline bool equal(point a, point b) {
  return a.x[0] == b.x[0] && a.x[1] == b.x[1] && a.x[2] == b.x[2];
}
static inline int compare(point a, point b) {
  for (int i = 0; i < 3; i++) {
    if (a.x[i] != b.x[i]) {
      return a.x[i] < b.x[i] ? -1 : 1;
    }
  }
  return 0;
}
static inline axis axis_of(point a) { return (axis){{a.x[0], a.x[1], a.x[2]}}; }
static inline axis cross(axis a, axis b) {
  return (axis){{a.x[1] * b.x[2] - a.x[2] * b.x[1], a.x[2] * b.x[0] - a.x[0] * b.x[2],
                 a.x[0] * b.x[1] - a.x[1] * b.x[0]}};
}
static inline wide dot(axis a, point b) {
  return a.x[0] * b.x[0] + a.x[1] * b.x[1] + a.x[2] * b.x[2];
}
static inline bool is_zero(axis a) { return a.x[0] == 0 && a.x[1] == 0 && a.x[2] == 0; }
static inline axis normal(const point v[3]) {
  return cross(axis_of(minus(v[1], v[0])), axis_of(minus(v[2], v[0])));
}
static inline wide determinant(point a, point b, point c) {
  return dot(cross(axis_of(a), axis_of(b)), c);
}
static inline int sign(wide x) { return (x > 0) - (x < 0); }

/* SplitMix64 by Steele, Lea and Flood (2014). */
static inline uint64_t draw_bits(generator *g) {
  uint64_t z = g->state += UINT64_C(0x9e3779b97f4a7c15);
  z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
  z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
  return z ^ (z >> 31);
}
static inline int64_t draw(generator *g, int64_t low, int64_t high) {
  return low + (int64_t)(draw_bits(g) % (uint64_t)(high - low + 1));
}
static inline bool one_in(generator *g, int64_t n) { return draw(g, 1, n) == 1; }

#endif
