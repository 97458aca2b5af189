/* normal.c - unit normals of integer triangles, in integers. */
#include "util/wide.h"

#include <math.h>

typedef unsigned __int128 uwide;

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
  uwide rounded = (2 * (uwide)wide_magnitude(component) * scale + length) / (2 * length);
  int32_t value = (int32_t)rounded;
  return component < 0 ? -value : value;
}

sepax_vec sepax_unit_normal(const sepax_tri *tri, int word) {
  wide_vec origin = wide_from(tri->v[0]);
  wide_vec n =
      wide_cross(wide_sub(wide_from(tri->v[1]), origin), wide_sub(wide_from(tri->v[2]), origin));
  wide largest = 0;
  for (int i = 0; i < 3; i++) {
    wide size = wide_magnitude(n.c[i]);
    largest = size > largest ? size : largest;
  }
  if (largest == 0) {
    return (sepax_vec){0, 0, 0};
  }
  int shift = 61; /* to bring the largest component to 61 bits */
  for (wide rest = largest; rest != 0; rest >>= 1) {
    shift--;
  }
  uwide square = 0;
  for (int i = 0; i < 3; i++) {
    n.c[i] = shifted(n.c[i], shift);
    square += (uwide)(n.c[i] * n.c[i]);
  }
  uwide length = square_root(square);
  return (sepax_vec){scaled_component(n.c[0], length, word), scaled_component(n.c[1], length, word),
                     scaled_component(n.c[2], length, word)};
}
