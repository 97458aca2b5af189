/* SPDX-License-Identifier: MIT */
/* sepax_grid.h - triangles with integer coordinates: put a mesh on a grid, and judge one pair of
 * triangles or many. The hardware uses the same arithmetic. The conventions are those of sepax.h.
 *
 * A coordinate is a two's complement integer of W bits, W = 4 ... 32. One step of the grid is 1
 * LSB. The grid says which length 1 LSB stands for; in the paper it is 2 um.
 */
#ifndef SEPAX_GRID_H
#define SEPAX_GRID_H

#include "sepax.h"

#ifdef __cplusplus
extern "C" {
#endif
#ifdef __GNUC__
#pragma GCC visibility push(default)
#endif

#define SEPAX_WORD_MIN 4
#define SEPAX_WORD_MAX 32

/* The smallest and the largest coordinate of `word` bits: -2^(W-1) and 2^(W-1) - 1. */
int32_t sepax_word_min(int word);
int32_t sepax_word_max(int word);

typedef struct {
  int32_t x, y, z;
} sepax_vec;

/* A triangle with the vertices v[0], v[1], v[2]. The vertices may also lie on a line or in one
 * point. */
typedef struct {
  sepax_vec v[3];
} sepax_tri;

/* ---------------------------------------------------------------- verdicts */

/* The exact verdict on two triangles, from 34 products. It is the golden model of architecture
 * exact. It is right for every int32_t, for coplanar triangles and for triangles without area;
 * there is no rounding and no tolerance. Axis e_i x f_j is tried only if edge e_i has a point in
 * B's plane and edge f_j has a point in A's plane. So an axis that was not tried may separate the
 * triangles, too. Cost: about 0.1 us for coordinates of up to 20 bits. */
sepax_verdict sepax_exact(const sepax_tri *a, const sepax_tri *b);

/* Triangles as a structure of arrays: c[k][axis][n] is the coordinate of vertex k of triangle n
 * along `axis` (0: x, 1: y, 2: z). The arrays are aligned as int32_t. */
typedef struct {
  const int32_t *c[3][3];
} sepax_columns;

/* The verdicts of sepax_exact on the pairs (a[n], b[n]) for all n < count. Bit n % 64 of
 * bits[n / 64] is 1 for a collision. Bits from `count` on in the last word are 0. The function is
 * exact for every int32_t. It is fastest if all 64 pairs of a word have coordinates of up to 20
 * bits, and little slower up to 25 bits. Pairs with longer coordinates are judged one by one. The
 * function reads nothing outside the arrays. docs/reference/library.md explains the method. */
void sepax_exact_pairs(sepax_simd simd, const sepax_columns *a, const sepax_columns *b,
                       size_t count, uint64_t *bits);

/* The verdicts on the pairs (a, b[n]) for all n < count, as for sepax_exact_pairs. It is faster
 * than sepax_exact_pairs because the sums of the vertices of `a` are computed once. */
void sepax_exact_one_to_many(sepax_simd simd, const sepax_tri *a, const sepax_columns *b,
                             size_t count, uint64_t *bits);

/* All pairs of triangles of A and B that collide. The result is exact and sorted by the triangle of
 * A, then by the triangle of B. Lists of AABBs are halved again and again, which excludes most
 * pairs; sepax_exact_pairs judges the other pairs. Errors: ARGUMENT on a negative number of
 * threads; LIMIT on 2^32 triangles or more; CANCELLED; MEMORY. */
bool sepax_colliding_pairs(const sepax_tri *a, size_t count_a, const sepax_tri *b, size_t count_b,
                           const sepax_search *how, sepax_pairs *found, sepax_error *error);

/* Like sepax_colliding_pairs, but `judge` decides whether a pair is found. `judge` is called for
 * pairs whose AABBs overlap or have a gap of at most `margin` LSB (0 ... 2^31) in every coordinate.
 * Several threads may call `judge` at once. */
typedef bool sepax_pair_judge(void *context, const sepax_tri *a, const sepax_tri *b);
bool sepax_judged_pairs(const sepax_tri *a, size_t count_a, const sepax_tri *b, size_t count_b,
                        int64_t margin, sepax_pair_judge *judge, void *context,
                        const sepax_search *how, sepax_pairs *found, sepax_error *error);

/* -------------------------------------------------------------------- grid */

/* A grid: the coordinate x of a mesh becomes the integer round((x - offset) / resolution). */
typedef struct {
  double resolution; /* units of the mesh per LSB, > 0 */
  double offset[3];  /* the point that becomes 0, in units of the mesh */
  int word;          /* W, bits of a coordinate */
} sepax_grid;

/* The finest grid of `word` bits that holds all meshes. The offset is the centre of the AABB of all
 * meshes. The longest side of the AABB spans just under 2^W - 1 steps. Errors: ARGUMENT if `word`
 * is not in 4 ... 32, if there are no triangles, if all vertices are one point, if an index is
 * beyond the vertices, or if a coordinate is not within 2^1000. */
bool sepax_grid_fit(sepax_grid *grid, const sepax_mesh *const meshes[], size_t count, int word,
                    sepax_error *error);

/* Put a mesh on a grid. tri[mesh->triangles] receives the triangles. Each coordinate is rounded to
 * the nearest integer, and a half is rounded away from zero. The rounding is exact for the doubles
 * given: 0.009 on a grid of 0.002 becomes 4 because the double nearest to 0.009 is below 0.009.
 * Cost: 2 to 6 ns for each coordinate. Errors: ARGUMENT if a coordinate does not fit W bits (the
 * text names the triangle, the coordinate and the cure), is NaN or infinite, if an index is beyond
 * the vertices, or if the grid is not valid. After an error `tri` is zero. */
bool sepax_quantise(const sepax_mesh *mesh, const sepax_grid *grid, sepax_tri *tri,
                    sepax_error *error);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif
#endif
