/* sepax_grid.h - triangles of integers: a mesh on a grid, exact verdicts on one pair and on many.
 * This is the arithmetic of the hardware. The conventions are those of sepax.h.
 *
 * Coordinates are integers of W bits, two's complement, W = 4 ... 32; 1 LSB is the length that one
 * step of the grid stands for (2 um in the paper).
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

/* The smallest and largest coordinate of a W-bit word. */
int32_t sepax_word_min(int word);
int32_t sepax_word_max(int word);

typedef struct {
  int32_t x, y, z;
} sepax_vec;

/* Vertices v[0], v[1], v[2]; any position, also all on a line or in a point. */
typedef struct {
  sepax_vec v[3];
} sepax_tri;

/* ---------------------------------------------------------------- verdicts */

/* The exact verdict from 34 products, the golden model of architecture exact: for every int32_t,
 * for coplanar and degenerate triangles, too, without rounding and without a tolerance. Axes 1 ...
 * 9 are tried only where e_i crosses or touches B's plane and f_j A's plane; an axis that was not
 * tried may separate, too. About 0.1 us for coordinates of up to 20 bits. */
sepax_verdict sepax_exact(const sepax_tri *a, const sepax_tri *b);

/* Triangles as a structure of arrays: c[k][axis][n] is coordinate `axis` (x, y, z) of vertex k of
 * triangle n. The arrays need the alignment of int32_t. */
typedef struct {
  const int32_t *c[3][3];
} sepax_columns;

/* The verdicts of sepax_exact on pairs (a[n], b[n]), n < count: bit n % 64 of bits[n / 64] is 1 for
 * a collision; bits of the last word from `count` on are 0. Exact for every int32_t. It is fastest
 * where all 64 pairs of a word have coordinates of up to 20 bits, not much slower up to 25 bits,
 * and judges longer coordinates one by one in 128 bits. It reads nothing outside of the arrays.
 * docs/reference/library.md. */
void sepax_exact_pairs(sepax_simd simd, const sepax_columns *a, const sepax_columns *b,
                       size_t count, uint64_t *bits);

/* The same of one triangle and each of b; sums of a's own vertices are computed once. */
void sepax_exact_one_to_many(sepax_simd simd, const sepax_tri *a, const sepax_columns *b,
                             size_t count, uint64_t *bits);

/* All colliding pairs of triangles of A and B, exact, in the order of i, then of j. Lists of AABBs,
 * halved again and again, exclude most pairs; sepax_exact_pairs judges what is left. Errors: LIMIT
 * on 2^32 triangles; CANCELLED; MEMORY. */
bool sepax_colliding_pairs(const sepax_tri *a, size_t count_a, const sepax_tri *b, size_t count_b,
                           const sepax_search *how, sepax_pairs *found, sepax_error *error);

/* As sepax_colliding_pairs, but for the pairs of which `judge` is true, among those whose AABBs
 * overlap or have a gap of at most `margin` LSB (0 ... 2^31) in every coordinate. `judge` is called
 * from several threads at once. */
typedef bool sepax_pair_judge(void *context, const sepax_tri *a, const sepax_tri *b);
bool sepax_judged_pairs(const sepax_tri *a, size_t count_a, const sepax_tri *b, size_t count_b,
                        int64_t margin, sepax_pair_judge *judge, void *context,
                        const sepax_search *how, sepax_pairs *found, sepax_error *error);

/* -------------------------------------------------------------------- grid */

/* The grid of integer coordinates: q = round((x - offset) / resolution). */
typedef struct {
  double resolution; /* file units per LSB, > 0 */
  double offset[3];  /* file units */
  int word;
} sepax_grid;

/* The finest grid of W bits on which all the meshes fit: the offset is the centre of their common
 * AABB, the longest side spans just under 2^W - 1 steps. Errors: ARGUMENT on meshes without
 * triangles, on meshes that are a single point, on an index beyond the vertices, and on coordinates
 * above 2^1000. */
bool sepax_grid_fit(sepax_grid *grid, const sepax_mesh *const meshes[], size_t count, int word,
                    sepax_error *error);

/* Quantise a mesh: tri[mesh->triangles] receives the triangles, each coordinate rounded to nearest,
 * half away from zero, exactly for the doubles given (0.009 on a grid of 0.002 is 4: the double
 * nearest 0.009 is less); 2 to 6 ns each. Errors: ARGUMENT on a coordinate that does not fit W
 * bits, naming facet, coordinate and the cure, on NaN or infinity, on an index beyond the vertices,
 * and on a grid that is none; tri is then zero. */
bool sepax_quantise(const sepax_mesh *mesh, const sepax_grid *grid, sepax_tri *tri,
                    sepax_error *error);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif
#endif
