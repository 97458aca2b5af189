/* SPDX-License-Identifier: MIT */
/* exact.c - the golden model of architecture exact: the mathematical verdict from 34 products and
 * the signs of their sums.
 *
 * Vertices 0 ... 2 are A's, 3 ... 5 B's. With
 *   t_ij  = (x_j - x_i)(y_i + y_j)                       trapezoid terms, 15 products
 *   g_ijk = t_ij + t_jk + t_ki                           20 orient2d of the projection on x, y
 *   h_ijk = g_ijk (z_i + z_j + z_k - z_0 - z_1 - z_2)    prism volumes, 19 products; h_012 = 0
 * orient3d of each of the 15 tetrahedra is an alternating sum of four h. The signs of orient3d
 * decide, unless all are zero. Then one plane holds the six vertices, and the signs of orient2d
 * decide in the first coordinate projection that does not flatten this plane. If all projections
 * do, one line holds the vertices and the AABBs decide.
 *
 * Coordinates of up to 20 bits are judged in 64 bits, longer ones in 128. */
#include "signs.h"
#include "util/aabb.h"

static bool aabbs_disjoint(const sepax_tri *a, const sepax_tri *b) {
  aabb p = aabb_of(a);
  aabb q = aabb_of(b);
  return aabb_disjoint(&p, &q, 0);
}

/* Unrolled, the sums take half the time. */
#define SIMD_UNROLL _Pragma("GCC unroll 3")

#define SIMD_NUMBER uint64_t
#define SIMD_NAME(name) name##_64
#include "exact_sums.h"
#undef SIMD_NUMBER
#undef SIMD_NAME

#define SIMD_NUMBER unsigned __int128
#define SIMD_NAME(name) name##_128
#include "exact_sums.h"
#undef SIMD_NUMBER
#undef SIMD_NAME

static bool fits_20_bits(const sepax_tri *tri) {
  const uint32_t half = (uint32_t)1 << 19;
  uint32_t biased = 0;
  for (int k = 0; k < 3; k++) {
    sepax_vec v = tri->v[k];
    biased |= ((uint32_t)v.x + half) | ((uint32_t)v.y + half) | ((uint32_t)v.z + half);
  }
  return biased >> 20 == 0;
}

sepax_verdict sepax_exact(const sepax_tri *a, const sepax_tri *b) {
  return fits_20_bits(a) && fits_20_bits(b) ? verdict_64(a, b) : verdict_128(a, b);
}
