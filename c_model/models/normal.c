/* SPDX-License-Identifier: MIT */
/* normal.c - unit normals of integer triangles, in integers. */
#include "sepax_models.h"
#include "util/error.h"
#include "util/wide.h"

#include <math.h>

typedef unsigned __int128 uwide;

/* value * 2^shift, rounded down. */
static wide shifted(wide value, int shift) {
  return shift >= 0 ? value * ((wide)1 << shift) : value >> -shift;
}

/* The integer square root of a number in 2^120 ... 2^124, at most 1 too large: one Newton step from
 * double precision is enough. */
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
  int shift = 61; /* shift that brings the largest component to 61 bits */
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

/* ------------------------------------------------------------------ of a file */

static bool check_normal(const double normal[3], size_t number, sepax_error *error) {
  for (int axis = 0; axis < 3; axis++) {
    if (!isfinite(normal[axis])) {
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "facet %zu: the normal has %c = %g; mend the mesh", number, "xyz"[axis],
                        normal[axis]);
    }
  }
  return true;
}

static sepax_vec quantise_normal(const double normal[3], int word) {
  double largest = fmax(fmax(fabs(normal[0]), fabs(normal[1])), fabs(normal[2]));
  if (largest == 0) {
    return (sepax_vec){0, 0, 0};
  }
  int exponent = 0;
  frexp(largest, &exponent);
  double n[3];
  for (int axis = 0; axis < 3; axis++) {
    n[axis] = ldexp(normal[axis], -exponent);
  }
  double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  double unit = sepax_word_max(word);
  return (sepax_vec){(int32_t)round(n[0] * unit / length), (int32_t)round(n[1] * unit / length),
                     (int32_t)round(n[2] * unit / length)};
}

bool sepax_quantise_normals(const sepax_soup *soup, int word, sepax_vec *normal,
                            sepax_error *error) {
  if (soup->normal == NULL) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "the mesh has no normals; read them with the file");
  }
  for (size_t i = 0; i < soup->count; i++) {
    if (!check_normal(soup->normal[i], i, error)) {
      return false;
    }
  }
  for (size_t i = 0; i < soup->count; i++) {
    normal[i] = quantise_normal(soup->normal[i], word);
  }
  return true;
}
