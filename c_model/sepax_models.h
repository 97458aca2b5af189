/* sepax_models.h - pairs as the hardware gets them, what it says of them, and software to compare
 * it with: baselines in floating point and slower models of the same verdict. The conventions are
 * those of sepax.h and sepax_grid.h; "the paper" is the one that docs/reference/paper.md describes.
 */
#ifndef SEPAX_MODELS_H
#define SEPAX_MODELS_H

#include "sepax_grid.h"

#ifdef __cplusplus
extern "C" {
#endif
#ifdef __GNUC__
#pragma GCC visibility push(default)
#endif

/* ------------------------------------------------------------------- pairs */

/* Two triangles and their normals. A normal is a direction of W-bit components, a unit vector in
 * Q1.(W-1) when sepax_unit_normal or sepax_quantise_normals made it. */
typedef struct {
  sepax_tri a, b;
  sepax_vec na, nb;
} sepax_pair;

/* True iff all 18 coordinates and the 6 normal components fit W bits. */
bool sepax_pair_fits(const sepax_pair *pair, int word);

/* The unit normal (v1 - v0) x (v2 - v0) / |.|, times 2^(W-1) - 1, each component
 * rounded to nearest (half away from zero; the quotient is exact to 2^-28 LSB).
 * Zero for a triangle without area. Legal for every triangle of W bits. */
sepax_vec sepax_unit_normal(const sepax_tri *tri, int word);

/* The normals of a file, soup->normal, scaled to unit length in Q1.(W-1); zero where the file has
 * none. Error: ARGUMENT on a component that is not finite, naming its facet. */
bool sepax_quantise_normals(const sepax_soup *soup, int word, sepax_vec *normal,
                            sepax_error *error);

/* Two meshes on one grid: triangle i of A is tri[0][i], its normal normal[0][i]. */
typedef struct {
  sepax_grid grid;
  sepax_tri *tri[2];
  sepax_vec *normal[2];
  size_t count[2];
} sepax_scene;

/* Quantise two meshes on `grid`, or, when its resolution is 0, on the finest grid of grid->word
 * bits that holds both. Normals are computed from the quantised vertices, or, with file_normals,
 * those of the soups. name[] is of their files, for messages. Fails as the steps do, naming the
 * file. */
bool sepax_scene_make(sepax_scene *scene, const sepax_soup soup[2], const char *const name[2],
                      const sepax_grid *grid, bool file_normals, sepax_error *error);

/* The same of two STL files. */
bool sepax_scene_load(sepax_scene *scene, const char *const path[2], const sepax_grid *grid,
                      bool file_normals, sepax_error *error);
void sepax_scene_free(sepax_scene *scene);

/* The pair of triangle i of A and triangle j of B. */
sepax_pair sepax_scene_pair(const sepax_scene *scene, size_t i, size_t j);

/* --------------------------------------------------------------- judgements */

/* The band of a pair where a design has a clearance (sepax_clearance). */
typedef enum { SEPAX_BAND_FREE, SEPAX_BAND_WARNING, SEPAX_BAND_COLLISION } sepax_band;

/* Axes beyond those of sepax_axis. With a clearance SEPAX_AXIS_PLANE is an axis normal to an edge
 * and to x, y or z. Where paper and conference find a pair coplanar, 1 ... 6 number the axes of
 * table 2. */
enum {
  SEPAX_AXIS_AABB = 13,  /* x, y or z, tried where an AABB test or a clearance is */
  SEPAX_AXIS_EXTENT = 14 /* undecided, called a collision: the AABBs overlap, and one of them
                            exceeds its extent */
};

/* What a design says of a pair. */
typedef struct {
  bool collision;
  bool strict;     /* as sepax_verdict has it; false if the architecture does not tell */
  bool coplanar;   /* by the architecture's own test; false if it has none */
  int axis;        /* the first that separates in the order 10, 11, 1, 2, ... 9 */
  sepax_band band; /* with a clearance; collision is then band == SEPAX_BAND_COLLISION */
  int mul_project; /* multiplications in projections, as the paper counts them */
  int mul_axes;    /* multiplications in cross products, which the paper does not count */
} sepax_judgement;

/* ------------------------------------------------- slower models, baselines */

/* Two more models, true iff the triangles collide. They agree with sepax_exact on every pair of W
 * bits. sepax_reference is the separating axis theorem on 128-bit integers, axis by axis;
 * sepax_sat54 is the same theorem written out in 54 products. */
bool sepax_reference(const sepax_tri *a, const sepax_tri *b);
bool sepax_sat54(const sepax_tri *a, const sepax_tri *b);

/* SAT in IEEE single and double precision, with normals by cross product and coplanarity by
 * equality, as software usually does it. Rounding makes some verdicts wrong. */
bool sepax_float32(const sepax_tri *a, const sepax_tri *b);
bool sepax_float64(const sepax_tri *a, const sepax_tri *b);

/* The interval test (Moeller 1997) in the same precisions, without a tolerance: the usual test
 * where speed counts. It is not defined for triangles without area. */
bool sepax_interval32(const sepax_tri *a, const sepax_tri *b);
bool sepax_interval64(const sepax_tri *a, const sepax_tri *b);

/* The test of Guigue and Devillers (2003) in the same precisions: up to eight signs of orient3d, in
 * a common plane of orient2d. It divides nothing and is right where no sign is rounded away: in
 * double precision always for W <= 16. It is not defined for triangles without area. */
bool sepax_guigue32(const sepax_tri *a, const sepax_tri *b);
bool sepax_guigue64(const sepax_tri *a, const sepax_tri *b);

/* The verdict of sepax_exact for every pair: the same test in double precision with a bound on the
 * rounding of each sign, and sepax_exact where a sign is in doubt or a triangle has no area.
 * *settled (NULL: not asked) is true iff doubles were enough. */
bool sepax_filtered(const sepax_tri *a, const sepax_tri *b, bool *settled);

/* How far a pair is from the other verdict, in LSB. For a collision it is the depth, the length of
 * the shortest translation that leaves mere contact (0 for contact, and for all coplanar pairs);
 * for separated triangles it is minus their distance. Rounded: the relative error is about 1e-9,
 * and up to some 1e-6 LSB where triangles are slivers of W > 26. */
double sepax_depth(const sepax_tri *a, const sepax_tri *b);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif
#endif
