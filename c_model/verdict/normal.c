/* normal.c - unit normals of integer triangles, in integers. */
#include "sepax.h"

#include <math.h>

typedef __int128 wide;
typedef unsigned __int128 uwide;

static uwide magnitude(wide value) { return value < 0 ? (uwide)-value : (uwide)value; }

/* value * 2^shift, rounded down. */
static wide shifted(wide value, int shift) {
  return shift >= 0 ? value * ((wide)1 << shift) : value >> -shift;
}

/* The integer square root of 2^120 ... 2^124: one Newton step from double precision
 * leaves at most 1 too much. */
static uwide square_root(uwide value) {
  uwide root = (uwide)sqrt((double)value);
  root = (root + value / root) / 2;
  return root - (root * root > value);
}

static int32_t scaled_component(wide component, uwide length, int word) {
  uwide scale = (uwide)sepax_word_max(word);
  uwide rounded = (2 * magnitude(component) * scale + length) / (2 * length);
  int32_t value = (int32_t)rounded;
  return component < 0 ? -value : value;
}

sepax_vec sepax_unit_normal(const sepax_tri *tri, int word) {
  const sepax_vec *v = tri->v;
  const wide e[3] = {(wide)v[1].x - v[0].x, (wide)v[1].y - v[0].y, (wide)v[1].z - v[0].z};
  const wide f[3] = {(wide)v[2].x - v[0].x, (wide)v[2].y - v[0].y, (wide)v[2].z - v[0].z};
  wide n[3] = {e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]};
  uwide largest = 0;
  for (int i = 0; i < 3; i++) {
    largest = magnitude(n[i]) > largest ? magnitude(n[i]) : largest;
  }
  if (largest == 0) {
    return (sepax_vec){0, 0, 0};
  }
  int shift = 61; /* to bring the largest component to 61 bits */
  for (uwide rest = largest; rest != 0; rest >>= 1) {
    shift--;
  }
  uwide square = 0;
  for (int i = 0; i < 3; i++) {
    n[i] = shifted(n[i], shift);
    square += magnitude(n[i]) * magnitude(n[i]);
  }
  uwide length = square_root(square);
  return (sepax_vec){scaled_component(n[0], length, word), scaled_component(n[1], length, word),
                     scaled_component(n[2], length, word)};
}
