/* SPDX-License-Identifier: MIT */
/* sepax_models.h - the pairs that the hardware receives, the judgements that it gives, and software
 * to compare it with: tests in floating point and slower models of the same verdict. The
 * conventions are those of sepax.h and sepax_grid.h. "The paper" is described in
 * docs/reference/paper.md.
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

/* Two triangles and their normals na and nb. A normal has components of W bits. Normals from
 * sepax_unit_normal and sepax_quantise_normals are unit vectors in Q1.(W-1), that is, multiplied by
 * 2^(W-1) - 1. */
typedef struct {
  sepax_tri a, b;
  sepax_vec na, nb;
} sepax_pair;

/* True if all 18 coordinates and the 6 components of the normals fit `word` bits. */
bool sepax_pair_fits(const sepax_pair *pair, int word);

/* The unit normal of a triangle of `word` bits: (v1 - v0) x (v2 - v0), divided by its length and
 * multiplied by 2^(W-1) - 1. Each component is rounded to the nearest integer, a half away from
 * zero. Before this rounding the component is right to 2^-28 LSB. The normal of a triangle without
 * area is zero. */
sepax_vec sepax_unit_normal(const sepax_tri *tri, int word);

/* The normals of a file (soup->normal), scaled to unit length in Q1.(W-1), into
 * normal[soup->count]. A normal of length zero stays zero. Error: ARGUMENT if a component is not
 * finite; the text names the facet. */
bool sepax_quantise_normals(const sepax_soup *soup, int word, sepax_vec *normal,
                            sepax_error *error);

/* Two meshes on one grid. Triangle i of A is tri[0][i] and has the normal normal[0][i]. Those of B
 * are in tri[1] and normal[1]. */
typedef struct {
  sepax_grid grid;
  sepax_tri *tri[2];
  sepax_vec *normal[2];
  size_t count[2];
} sepax_scene;

/* Put two meshes on `grid`. If its resolution is 0, then they are put on the finest grid of
 * grid->word bits that holds both. Normals are computed from the quantised vertices, or, if
 * file_normals is true, taken from the soups. name[0] and name[1] are the files' names for
 * messages. Free the scene with sepax_scene_free. Errors: as for sepax_grid_fit, sepax_quantise and
 * sepax_quantise_normals, with the name of the file. */
bool sepax_scene_make(sepax_scene *scene, const sepax_soup soup[2], const char *const name[2],
                      const sepax_grid *grid, bool file_normals, sepax_error *error);

/* The same for two STL files. Errors: also those of sepax_stl_read. */
bool sepax_scene_load(sepax_scene *scene, const char *const path[2], const sepax_grid *grid,
                      bool file_normals, sepax_error *error);
void sepax_scene_free(sepax_scene *scene);

/* The pair of triangle i of A and triangle j of B. */
sepax_pair sepax_scene_pair(const sepax_scene *scene, size_t i, size_t j);

/* --------------------------------------------------------------- judgements */

/* The band of a pair if the design has a clearance (sepax_clearance). */
typedef enum { SEPAX_BAND_FREE, SEPAX_BAND_WARNING, SEPAX_BAND_COLLISION } sepax_band;

/* More axis numbers. With a clearance, SEPAX_AXIS_PLANE stands for an axis that is normal to an
 * edge and to x, y or z. If paper or conference call a pair coplanar, then 1 ... 6 are the axes of
 * the paper's table 2. */
enum {
  SEPAX_AXIS_AABB = 13,  /* x, y or z; tried by an AABB test and with a clearance */
  SEPAX_AXIS_EXTENT = 14 /* no axis: the AABBs overlap and one of them exceeds its extent, so the
                            pair is undecided and is called a collision */
};

/* The judgement of a design on a pair. */
typedef struct {
  bool collision;
  bool strict;     /* as in sepax_verdict; false if the architecture does not compute it */
  bool coplanar;   /* by the architecture's own test; false if it has no such test */
  int axis;        /* the first axis that separates in the order 10, 11, 1, 2, ... 9 */
  sepax_band band; /* with a clearance; then collision is band == SEPAX_BAND_COLLISION */
  int mul_project; /* multiplications in projections, as the paper counts them */
  int mul_axes;    /* multiplications in cross products, which the paper does not count */
} sepax_judgement;

/* ------------------------------------------------- slower models, baselines */

/* True if the triangles collide. Both functions agree with sepax_exact on every pair of up to 32
 * bits. sepax_reference applies the separating axis theorem (SAT) in 128-bit integers, axis by
 * axis. sepax_sat54 is the theorem written out with 54 products. */
bool sepax_reference(const sepax_tri *a, const sepax_tri *b);
bool sepax_sat54(const sepax_tri *a, const sepax_tri *b);

/* The separating axis theorem in IEEE single and double precision. Normals are cross products, and
 * coplanarity is tested by equality, as is usual in software. Rounding makes some verdicts wrong.
 */
bool sepax_float32(const sepax_tri *a, const sepax_tri *b);
bool sepax_float64(const sepax_tri *a, const sepax_tri *b);

/* The interval test of Moeller (1997) in single and double precision, without a tolerance. It is
 * the usual test in fast software. It is not defined for triangles without area. */
bool sepax_interval32(const sepax_tri *a, const sepax_tri *b);
bool sepax_interval64(const sepax_tri *a, const sepax_tri *b);

/* The test of Guigue and Devillers (2003) in single and double precision. It needs up to eight
 * signs of orient3d, or of orient2d if the triangles are coplanar, and no division. It is right if
 * rounding changes no sign: in double precision always for W <= 16. It is not defined for triangles
 * without area. */
bool sepax_guigue32(const sepax_tri *a, const sepax_tri *b);
bool sepax_guigue64(const sepax_tri *a, const sepax_tri *b);

/* The same test in double precision with a bound on the rounding of each sign. If a sign is in
 * doubt or a triangle has no area, then sepax_exact decides. So the result is that of sepax_exact
 * for every pair. *settled is true if doubles were enough; `settled` may be NULL. */
bool sepax_filtered(const sepax_tri *a, const sepax_tri *b, bool *settled);

/* How far a pair is from the other verdict, in LSB. For a collision it is the depth: the length of
 * the shortest translation after which the triangles only touch. The depth is 0 if they only touch
 * and for all coplanar pairs. For separated triangles it is minus their distance. The relative
 * error is about 1e-9. For slivers of W > 26 the error may be about 1e-6 LSB. */
double sepax_depth(const sepax_tri *a, const sepax_tri *b);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif
#endif
