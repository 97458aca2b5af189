/* sepax.h - libsepax: golden models of triangle/triangle collision detection by
 * the separating axis theorem (SAT), and the data they work on.
 *
 * Conventions
 *   - Coordinates of sepax_vec, sepax_tri, sepax_pair and sepax_columns are integers of W bits,
 *     two's complement; 1 LSB is the length one step stands for (2 um in the paper). W is
 *     4 ... 32. Those of meshes, bodies and poses are doubles in file units.
 *   - A collision is at least one common point of the two closed triangles;
 *     touching counts. The verdict is true for a collision.
 *   - A function that can fail returns false and leaves one line in *error
 *     which names the file or the value and the cure; its results are then
 *     untouched or freed. Nothing is clamped, wrapped or dropped.
 *   - Facets, triangles, vertices and meshes count from 0, in messages, too; lines of a file
 *     count from 1.
 *   - No function keeps state; all are safe to call from several threads.
 *
 * Sources: "the paper" is the ASIC for machine tool automation that docs/paper.md
 * describes; "Algorithm 1", "table 2", "figure 5" are its own.
 */
#ifndef SEPAX_H
#define SEPAX_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#ifdef __cplusplus
extern "C" {
#endif

#define SEPAX_VERSION "0.1.0"
#define SEPAX_WORD_MIN 4
#define SEPAX_WORD_MAX 32

/* What kind of failure it was. The numbers never change. */
typedef enum {
  SEPAX_OK = 0,
  SEPAX_ERROR_ARGUMENT = 1,  /* a value of the caller is not in the range that is documented */
  SEPAX_ERROR_MEMORY = 2,    /* the allocator gave none */
  SEPAX_ERROR_LIMIT = 3,     /* larger than the library can hold: triangles, bits, bytes */
  SEPAX_ERROR_CANCELLED = 4, /* the caller's progress function ended it */
  SEPAX_ERROR_FILE = 5,      /* a file cannot be opened, read or written */
  SEPAX_ERROR_FORMAT = 6,    /* a file or a text is not what it should be */
  SEPAX_ERROR_NONE_FITS = 7  /* of several designs none is good enough */
} sepax_code;

/* One line of text without a newline; empty until something failed. */
typedef struct {
  sepax_code code;
  char text[512];
} sepax_error;

/* ---------------------------------------------------------------- geometry */

typedef struct {
  int32_t x, y, z;
} sepax_vec;

/* Vertices v[0], v[1], v[2]; any position, also all on a line or in a point. */
typedef struct {
  sepax_vec v[3];
} sepax_tri;

/* Two triangles and their normals. A normal is a direction of W-bit components, a unit vector in
 * Q1.(W-1) when sepax_unit_normal or the quantiser made it. */
typedef struct {
  sepax_tri a, b;
  sepax_vec na, nb;
} sepax_pair;

/* The smallest and largest coordinate of a W-bit word. */
int32_t sepax_word_min(int word);
int32_t sepax_word_max(int word);

/* True iff all 18 coordinates and the 6 normal components fit W bits. */
bool sepax_pair_fits(const sepax_pair *pair, int word);

/* The unit normal (v1 - v0) x (v2 - v0) / |.|, times 2^(W-1) - 1, each component
 * rounded to nearest (half away from zero; the quotient is exact to 2^-28 LSB).
 * Zero for a triangle without area. Legal for every triangle of W bits. */
sepax_vec sepax_unit_normal(const sepax_tri *tri, int word);

/* ---------------------------------------------------------------- verdicts */

/* The band of a pair where a design has a clearance (sepax_clearance). */
typedef enum { SEPAX_BAND_FREE, SEPAX_BAND_WARNING, SEPAX_BAND_COLLISION } sepax_band;

/* Axis numbers are those of the paper. e_i is the edge from A_i to A_i+1, f_j that from B_j to
 * B_j+1 (i, j = 0, 1, 2 modulo 3). Where paper and conference find a pair coplanar, 1 ... 6 number
 * the axes of table 2 instead. */
typedef enum {
  SEPAX_AXIS_NONE = 0,      /* no axis separates, or the method names none */
  SEPAX_AXIS_EDGES = 1,     /* 1 ... 9, table 1: SEPAX_AXIS_EDGES + 3i + j is e_i x f_j */
  SEPAX_AXIS_NORMAL_A = 10, /* N_A */
  SEPAX_AXIS_NORMAL_B = 11, /* N_B */
  SEPAX_AXIS_PLANE = 12,    /* exact: some axis in the common plane of a coplanar pair; with a
                               clearance an axis normal to an edge and to x, y or z */
  SEPAX_AXIS_AABB = 13,     /* x, y or z, tried where an AABB test or a clearance is */
  SEPAX_AXIS_EXTENT = 14    /* undecided, called a collision: the AABBs overlap, and one of them
                               exceeds its extent */
} sepax_axis;

typedef struct {
  bool collision;
  bool strict;     /* sepax_exact, sepax_exact_posed: a collision, and more than touching */
  bool coplanar;   /* by the architecture's own test; false if it has none */
  int axis;        /* sepax_axis: the first that separates in the order 10, 11, 1, 2, ... 9 */
  int mul_project; /* multiplications in projections, as the paper counts them */
  int mul_axes;    /* multiplications in cross products, which the paper does not count */
  sepax_band band; /* with a clearance; collision is then band == SEPAX_BAND_COLLISION */
} sepax_verdict;

/* The exact verdict from 34 products, the golden model of architecture exact: for every W up to 32,
 * for coplanar and degenerate triangles, too, without rounding and without a tolerance. coplanar is
 * true iff one plane holds all six vertices. strict is true iff both triangles have an area, they
 * are not coplanar, and their interiors (without the edges) share a point: they pass through each
 * other, and solids that they bound overlap. Coplanar triangles never collide strictly, nor do
 * those whose common points are all on edges of one of them. A pair is separated iff an axis is
 * named, and this axis separates it. Axes 1 ... 9 are tried only where e_i crosses or touches B's
 * plane and f_j A's plane; an axis that was not tried may separate, too. About 0.1 us for
 * coordinates of up to 20 bits. */
sepax_verdict sepax_exact(const sepax_tri *a, const sepax_tri *b);

/* Two more models, true iff the triangles collide. They agree with sepax_exact on every pair.
 * sepax_reference is the separating axis theorem on 128-bit integers, axis by axis; sepax_sat54 is
 * the same theorem written out in 54 products. */
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

/* --------------------------------------------------------------- many pairs */

/* Triangles as a structure of arrays: c[k][axis][n] is coordinate `axis` (x, y, z) of vertex k of
 * triangle n. The arrays need the alignment of int32_t. */
typedef struct {
  const int32_t *c[3][3];
} sepax_columns;

/* The vector instructions that are used; all give the same results. Those that this processor lacks
 * stand for the widest that it has. */
typedef enum {
  SEPAX_SIMD_BEST,
  SEPAX_SIMD_PORTABLE, /* 2 pairs at once in doubles; sepax_exact where a sign is uncertain */
  SEPAX_SIMD_AVX2,     /* 4 pairs at once */
  SEPAX_SIMD_AVX512    /* 8 pairs at once */
} sepax_simd;

bool sepax_simd_runs(sepax_simd path);
const char *sepax_simd_name(sepax_simd path); /* of BEST: the name of the path that it stands for */

/* The verdicts of sepax_exact on pairs (a[n], b[n]), n < count: bit n % 64 of bits[n / 64] is 1 for
 * a collision; bits of the last word from `count` on are 0. Exact for every int32_t. It is fastest
 * where all 64 pairs of a word have coordinates of up to 20 bits, not much slower up to 25 bits,
 * and judges longer coordinates one by one in 128 bits. It reads nothing outside of the arrays. The
 * path must run on this processor. docs/software.md. */
void sepax_exact_pairs(sepax_simd path, const sepax_columns *a, const sepax_columns *b,
                       size_t count, uint64_t *bits);

/* The same of one triangle and each of b; sums of a's own vertices are computed once. */
void sepax_exact_one_to_many(sepax_simd path, const sepax_tri *a, const sepax_columns *b,
                             size_t count, uint64_t *bits);

/* How two meshes are searched; all zero is a good choice. */
typedef struct {
  int threads;      /* 0: one for each processor */
  bool brute_force; /* every pair is tested */
  bool first;       /* end at a pair that collides, always at the same one */
  sepax_simd simd;
  /* Called now and then from the calling thread, at the end with done == total if nothing ends the
   * search before. False ends the search. NULL: not called. */
  bool (*progress)(void *context, uint64_t done, uint64_t total);
  void *context;
} sepax_search;

/* pair[n]: the numbers of a triangle of A and of one of B. */
typedef struct {
  size_t (*pair)[2];
  size_t count;
  bool ended; /* by a limit of the query: there may be more pairs */
} sepax_pairs;

/* All colliding pairs of triangles of A and B, exact, in the order of i, then of j. Lists of AABBs,
 * halved again and again, exclude most pairs; sepax_exact_pairs judges what is left. `how` may be
 * NULL. Fails on 2^32 triangles, without memory, or when progress ended it; free with
 * sepax_pairs_free. */
bool sepax_colliding_pairs(const sepax_tri *a, size_t count_a, const sepax_tri *b, size_t count_b,
                           const sepax_search *how, sepax_pairs *found, sepax_error *error);
void sepax_pairs_free(sepax_pairs *pairs);

/* As sepax_colliding_pairs, but for the pairs of which `judge` is true, among those whose AABBs
 * overlap or have a gap of at most `margin` LSB (0 ... 2^31) in every coordinate. `judge` is called
 * from several threads at once. */
typedef bool sepax_pair_judge(void *context, const sepax_tri *a, const sepax_tri *b);
bool sepax_judged_pairs(const sepax_tri *a, size_t count_a, const sepax_tri *b, size_t count_b,
                        int64_t margin, sepax_pair_judge *judge, void *context,
                        const sepax_search *how, sepax_pairs *found, sepax_error *error);

/* ------------------------------------------------------------------ meshes */

/* One facet of a mesh in file units: the coordinates and the normal as written. */
typedef struct {
  double v[3][3];
  double normal[3];
} sepax_facet;

typedef struct {
  sepax_facet *facet;
  size_t count;
} sepax_mesh;

void sepax_mesh_free(sepax_mesh *mesh);

/* Read an STL file, ASCII or binary (by its size, not by its first word). ASCII
 * decimals are correctly rounded to double, binary32 values are exact. Fails on
 * a missing, empty, truncated or over-long file, no facets, NaN or infinity in a
 * coordinate or a normal, and on text that is no STL (with its line). */
bool sepax_stl_read(sepax_mesh *mesh, const char *path, sepax_error *error);

/* Write a binary STL (coordinates rounded to binary32; a value that does not fit is an error, and
 * so is a facet that loses its area by rounding), or ASCII with 17 digits. The file is written
 * under a temporary name beside path, then renamed to path. Fails also on an empty mesh, on NaN or
 * infinity, and where path exists but is no file. */
bool sepax_stl_write(const sepax_mesh *mesh, const char *path, bool ascii, sepax_error *error);

/* The grid of integer coordinates: q = round((x - offset) / resolution). */
typedef struct {
  double resolution; /* file units per LSB, > 0 */
  double offset[3];  /* file units */
  int word;
} sepax_grid;

/* The finest grid of W bits on which all the meshes fit: the offset is the centre of their common
 * AABB, the longest side spans just under 2^W - 1 steps. Fails on meshes without facets, on meshes
 * that are a single point, and on coordinates above 2^1000. */
bool sepax_grid_fit(sepax_grid *grid, const sepax_mesh *const meshes[], size_t count, int word,
                    sepax_error *error);

/* Quantise a mesh: tri[mesh->count] receives the triangles, each coordinate
 * rounded to nearest, half away from zero, exactly for the doubles given (0.009 on
 * a grid of 0.002 is 4: the double nearest 0.009 is less); 2 to 6 ns each; normal[mesh->count], if
 * not NULL, the file's normals scaled to unit length in Q1.(W-1), or zero where the
 * file has none. Fails on a coordinate that does not fit W bits, naming facet,
 * coordinate and the cure, on NaN or infinity and on a grid that is none. */
bool sepax_quantise(const sepax_mesh *mesh, const sepax_grid *grid, sepax_tri *tri,
                    sepax_vec *normal, sepax_error *error);

/* Two meshes on one grid: triangle i of A is tri[0][i], its normal normal[0][i]. */
typedef struct {
  sepax_grid grid;
  sepax_tri *tri[2];
  sepax_vec *normal[2];
  size_t count[2];
} sepax_scene;

/* Read two STL files and quantise them on `grid`, or, when its resolution is 0, on
 * the finest grid of grid->word bits that holds both. Normals are computed from the
 * quantised vertices, or the file's. Fails as the steps above do, naming the file. */
bool sepax_scene_load(sepax_scene *scene, const char *const path[2], const sepax_grid *grid,
                      bool file_normals, sepax_error *error);
void sepax_scene_free(sepax_scene *scene);

/* The pair of triangle i of A and triangle j of B. */
sepax_pair sepax_scene_pair(const sepax_scene *scene, size_t i, size_t j);

/* ------------------------------------------------------------------ bodies */

/* Where a body is: its point v is at rotation v + translation. The entries of the rotation, by
 * rows, are taken as the exact numbers that they are. */
typedef struct {
  double rotation[3][3];
  double translation[3];
} sepax_pose;

/* True iff the pose is finite and its matrix is a rotation within 1e-6: no entry of R R^T differs
 * by more from the identity, and the determinant is positive. */
bool sepax_pose_valid(const sepax_pose *pose, sepax_error *error);

typedef struct {
  sepax_pose *pose;
  size_t count;
} sepax_poses;

/* Read poses from a text file: 12 decimal numbers a line, the rotation by rows, then the
 * translation in file units; '#' begins a comment, a line may be empty, UTF-8's byte order mark is
 * skipped. Each number is rounded to
 * the nearest double, in every locale. Fails, naming the line, on another count of numbers, on a
 * number that is none or not finite, on a pose that is not valid, and on a file without poses. */
bool sepax_poses_read(sepax_poses *poses, const char *path, sepax_error *error);
void sepax_poses_free(sepax_poses *poses);

/* The verdict of sepax_exact on triangle a in pose_a and b in pose_b (NULL: as it is), v[k] vertex
 * k: all doubles are taken as the exact numbers that they are, nothing is rounded. They are finite.
 * Some microseconds. */
sepax_verdict sepax_exact_posed(const double a[3][3], const sepax_pose *pose_a,
                                const double b[3][3], const sepax_pose *pose_b);

/* The distance of triangle a in pose_a and b in pose_b (NULL: as it is), v[k] vertex k, all doubles
 * taken as the exact numbers that they are: 0 iff they collide (sepax_exact_posed), else wrong by
 * less than one unit in the last place of the exact distance; one below 2^-1074 is given as
 * 2^-1074. nearest, if not NULL, receives a point of A and one of B at that distance (of a
 * collision a common point); each coordinate is wrong by up to 2^-51 of the largest coordinate of a
 * vertex or translation. Coordinates and translations are within 2^1000, poses valid. Some
 * microseconds; more for pairs that nearly touch. */
double sepax_distance_posed(const double a[3][3], const sepax_pose *pose_a, const double b[3][3],
                            const sepax_pose *pose_b, double nearest[2][3]);

/* A mesh and its tree, as it stands in its file. It never changes; threads may share it. */
typedef struct sepax_body sepax_body;

/* Copies what it needs of the mesh; some 250 bytes a facet. Large meshes are built by a thread for
 * each processor; the result does not depend on that. Fails on a mesh without facets, on a
 * coordinate that is not within 2^1000, such as NaN or infinity (naming its facet), on more than
 * 2^31 - 2 facets, and without memory. */
bool sepax_body_new(sepax_body **body, const sepax_mesh *mesh, sepax_error *error);
void sepax_body_free(sepax_body *body);
size_t sepax_body_triangles(const sepax_body *body);

/* What is asked of two bodies; all zero: all colliding pairs. */
typedef struct {
  size_t most;    /* end after so many pairs; 0: no limit */
  bool only_any;  /* no pairs are kept: the count is 0 or 1 */
  bool strict;    /* only pairs that collide strictly (sepax_exact): touching does not count */
  double seconds; /* end after so much time; 0: no limit */
  /* Called with each pair, in place of keeping it; false ends the search. NULL: not called. */
  bool (*each)(void *context, size_t a, size_t b);
  void *context;
  sepax_simd simd;
} sepax_query;

/* The pairs of triangles (number in A, number in B) of two bodies in their poses (NULL: as they
 * stand) that collide; touching counts. Exact for the doubles given: each pair is decided on the
 * posed coordinates as rational numbers. A pair that collides strictly proves that solids overlap.
 * Solids that touch, face on face, edge on face, have none; nor have some that overlap, but nowhere
 * cross, such as a solid and itself in one pose. The order of the pairs depends on nothing but the
 * bodies, the poses and the query. A search that a limit ended has found what
 * is certain, but more may collide; no pair found then leaves the bodies undecided. Fails on poses
 * that are not valid, on a time that is no number or negative, and without memory; free with
 * sepax_pairs_free. */
bool sepax_bodies_collide(const sepax_body *a, const sepax_pose *pose_a, const sepax_body *b,
                          const sepax_pose *pose_b, const sepax_query *query, sepax_pairs *found,
                          sepax_error *error);

/* The pairs whose distance is at most `distance`, which is within 0 ... 2^1000, or less where the
 * query is strict, compared exactly with the double; with 0 those that collide. Everything else as
 * for sepax_bodies_collide. */
bool sepax_bodies_near(const sepax_body *a, const sepax_pose *pose_a, const sepax_body *b,
                       const sepax_pose *pose_b, double distance, const sepax_query *query,
                       sepax_pairs *found, sepax_error *error);

typedef struct {
  double min_distance;         /* infinite where it is above the limit; the rest is 0 then */
  double nearest_points[2][3]; /* of A, of B */
  size_t pair[2];              /* triangles that these points are on: number in A, number in B */
  uint32_t box[2];             /* of theirs in the bodies, for `last`; 0 where they collide */
  bool ended; /* by the time limit: the distance is not above min_distance, but may be less */
} sepax_distance_result;

/* How a distance is asked for; all zero: whatever it is. */
typedef struct {
  double limit; /* a distance above it is not looked for, which is faster; 0: no limit */
  const sepax_distance_result *last; /* of the same bodies, in poses like these: where to begin,
                                        which is faster; NULL: none */
  double seconds; /* end after so much time; 0: no limit. Where the way is a million times
                     the bodies' size, all triangles are as far as each other: it takes long */
  sepax_simd simd;
} sepax_distance_request;

/* The distance of the surfaces of two bodies in their poses (NULL: as they stand), the least of
 * sepax_distance_posed over all pairs of triangles, exact and rounded as there; and a pair that has
 * it. `request` may be NULL. Fails on poses that are not valid, without memory, on limits that are
 * no numbers or negative, and on a `last` whose min_distance is no distance or whose pair or box
 * these bodies lack. A `last` of other bodies that passes costs time, but changes no result. */
bool sepax_bodies_distance(const sepax_body *a, const sepax_pose *pose_a, const sepax_body *b,
                           const sepax_pose *pose_b, const sepax_distance_request *request,
                           sepax_distance_result *result, sepax_error *error);

/* ------------------------------------------------------------------ solids */

/* The surface of a body. Vertices are one where their coordinates are equal (-0 is 0); an edge
 * joins two that differ. A part is what hangs together by edges. Triangles without area are
 * triangles like others. Fill it with sepax_shell_find; the body must stay as long as it. It never
 * changes; threads may share it. */
typedef struct {
  const sepax_body *body;
  bool closed;     /* every edge belongs to an even number of triangles: the body is a solid */
  bool consistent; /* every edge is run as often one way as the other, but for one triangle where
                      their number is odd: no triangle is turned round */
  size_t facet;    /* where one is false: a triangle by its number in the mesh, and an edge of it */
  double edge[2][3]; /* that is not so; where both are false, an edge that is open */
  size_t parts;
  size_t pieces; /* of a closed body: parts that touch or overlap each other are one piece */
  struct sepax_parts *own;
} sepax_shell;

/* Some tenths of a microsecond a triangle. Fails without memory, and on more than 715,827,882
 * triangles; free with sepax_shell_free. */
bool sepax_shell_find(sepax_shell *shell, const sepax_body *body, sepax_error *error);
void sepax_shell_free(sepax_shell *shell);

typedef enum { SEPAX_OUTSIDE, SEPAX_INSIDE, SEPAX_INSIDE_UNKNOWN } sepax_inside;

/* Two bodies in their poses (NULL: as they stand) of which no triangles collide: within[0] is
 * SEPAX_INSIDE iff a part of A is wholly inside the solid B, within[1] iff one of B is inside A;
 * else SEPAX_OUTSIDE. What is open has no inside that is defined: where B is, within[0] is
 * SEPAX_INSIDE_UNKNOWN if a part of A may be inside B's box, likewise within[1]. Exact for the
 * doubles given. Some microseconds for each part inside the other's box. Fails on a pose that is
 * not valid.
 *
 * A point is inside a part iff a ray from it meets the part an odd number of times; or, if the
 * part's own triangles are consistent, if it winds round the point, as where a part crosses itself
 * or is there twice. A point is inside a piece iff it is inside one of its parts, and inside the
 * solid iff it is inside an odd number of pieces. So a piece inside a piece is a cavity, what is in
 * that is material again, and parts that overlap are material where any of them is. A part may be
 * inside out, and triangles may be turned round: neither changes an inside by parity. */
bool sepax_bodies_within(const sepax_shell *a, const sepax_pose *pose_a, const sepax_shell *b,
                         const sepax_pose *pose_b, sepax_inside within[2], sepax_error *error);

/* All colliding pairs of two meshes in their poses, exact as sepax_bodies_collide finds them, in
 * the order of i, then of j, without a tree: faster than sepax_body_new where a pair of meshes is
 * asked once. `how` as for sepax_colliding_pairs. Fails also on coordinates that are not within
 * 2^1000. */
bool sepax_meshes_collide(const sepax_mesh *a, const sepax_pose *pose_a, const sepax_mesh *b,
                          const sepax_pose *pose_b, const sepax_search *how, sepax_pairs *found,
                          sepax_error *error);

#ifdef __cplusplus
}
#endif
#endif
