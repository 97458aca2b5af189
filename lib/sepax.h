/* sepax.h - libsepax: do two bodies collide, where, and how far are they from each other?
 *
 * Conventions
 *   - A body is a mesh of triangles. Coordinates are doubles in one unit of length, which the
 *     caller chooses. A result is exact for the doubles given, because nothing is rounded on the
 *     way to a verdict.
 *   - A collision is at least one common point of two closed triangles. Touching counts.
 *   - A function that can fail returns false. Then *error has a code and one line of text, which
 *     names the file or the value and the cure. Every result is zero and need not be freed.
 *     `error` may be NULL. No input ends the process. Nothing is clamped, wrapped or dropped.
 *   - A struct of options or a mesh begins with its size, which SEPAX_STRUCT fills in. A field that
 *     is zero has its default, so later versions can add fields without breaking a caller. Where a
 *     function takes options, NULL stands for all defaults.
 *   - sepax_NAME_free releases what a function has put into a sepax_NAME.
 *   - Triangles, vertices and meshes count from 0, also in messages. Lines of a file count from 1.
 *   - Only sepax_set_allocator keeps state. All other functions may be called from several threads
 *     at once.
 *
 * sepax_grid.h has triangles of integers, sepax_mechanism.h links and joints.
 */
#ifndef SEPAX_H
#define SEPAX_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif
#ifdef __GNUC__
#pragma GCC visibility push(default)
#endif

/* ----------------------------------------------------------------- version */

/* The version is written nowhere else. While MAJOR is 0, a new MINOR may break callers. A release
 * that breaks callers raises the number in the shared library's name, libsepax.so.0. */
#define SEPAX_VERSION_MAJOR 0
#define SEPAX_VERSION_MINOR 2
#define SEPAX_VERSION_PATCH 0
#define SEPAX_VERSION_NUMBER \
  (10000 * SEPAX_VERSION_MAJOR + 100 * SEPAX_VERSION_MINOR + SEPAX_VERSION_PATCH)
#define SEPAX_VERSION               \
  SEPAX_DIGITS(SEPAX_VERSION_MAJOR) \
  "." SEPAX_DIGITS(SEPAX_VERSION_MINOR) "." SEPAX_DIGITS(SEPAX_VERSION_PATCH)
#define SEPAX_DIGITS(macro) SEPAX_TEXT(macro)
#define SEPAX_TEXT(text) #text

/* SEPAX_VERSION_NUMBER and SEPAX_VERSION, such as "1.2.3", of the library that runs. */
int sepax_version_number(void);
const char *sepax_version(void);

/* True iff a program that was compiled with headers of this version can call the library that runs:
 * `if (!sepax_version_fits(SEPAX_VERSION_NUMBER)) ...`. */
bool sepax_version_fits(int number);

/* ------------------------------------------------------------------ errors */

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

/* ------------------------------------------------------------------ memory */

/* Where the library gets memory. `allocate` and `resize` return NULL where there is none; memory is
 * aligned as malloc's. All three may be called from several threads at once. */
typedef struct {
  void *(*allocate)(void *context, size_t bytes);
  void *(*resize)(void *context, void *memory, size_t bytes); /* memory NULL: allocates */
  void (*release)(void *context, void *memory);               /* NULL: nothing to do */
  void *context;
} sepax_allocator;

/* From now on the library uses this allocator (NULL: malloc, realloc and free). Call it before
 * everything else, or after everything was freed: memory must go back to the allocator that gave
 * it. */
void sepax_set_allocator(const sepax_allocator *allocator);

/* Memory of that allocator, for what the caller fills in and the library frees (sepax_soup,
 * sepax_mechanism). NULL where there is none; releasing NULL does nothing. */
void *sepax_allocate(size_t bytes);
void *sepax_resize(void *memory, size_t bytes); /* the memory is then moved, or as it was on NULL */
void sepax_release(void *memory);

/* ----------------------------------------------------------------- options */

/* A struct with its size, as a compound literal of C (in C++ set .size by hand):
 * sepax_bodies_collide(a, p, b, q, &SEPAX_STRUCT(sepax_query, .most = 1), &found, &error). */
#define SEPAX_STRUCT(type, ...) ((type){.size = sizeof(type), __VA_ARGS__})

/* Which vector instructions a function uses. All give the same results. If this processor lacks
 * those that are asked for, the function uses the widest that it has. */
typedef enum {
  SEPAX_SIMD_BEST,
  SEPAX_SIMD_PORTABLE, /* 2 pairs at once, compiled for any processor */
  SEPAX_SIMD_AVX2,     /* 4 pairs at once */
  SEPAX_SIMD_AVX512    /* 8 pairs at once */
} sepax_simd;

bool sepax_simd_runs(sepax_simd simd);
const char *sepax_simd_name(sepax_simd simd); /* of the instructions that would be used */

/* ------------------------------------------------------------------- poses */

/* Where a body is: its point v is at rotation v + translation. The entries of the rotation, by
 * rows, are taken as the exact numbers that they are. */
typedef struct {
  double rotation[3][3];
  double translation[3];
} sepax_pose;

/* True iff the pose is finite and its matrix is a rotation within 1e-6: no entry of R R^T differs
 * by more from the identity, and the determinant is positive. Else SEPAX_ERROR_ARGUMENT. */
bool sepax_pose_valid(const sepax_pose *pose, sepax_error *error);

/* Replace the matrix by the nearest rotation, its polar factor, to rounding: a matrix that was
 * printed with few decimals. `moved`, unless NULL, gets the largest change of an entry. Error:
 * ARGUMENT where the pose is not finite, where the matrix is a reflection, and where an entry would
 * change by more than 0.01; the pose then stays. Cost: some 300 operations. */
bool sepax_pose_nearest(sepax_pose *pose, double *moved, sepax_error *error);

/* to = rotation v + translation; `to` may be v. Rounded: three products and sums a coordinate. */
void sepax_pose_apply(const sepax_pose *pose, const double v[3], double to[3]);

/* inner, then outer: a point v is at outer(inner(v)). Rounded. */
sepax_pose sepax_pose_compose(const sepax_pose *outer, const sepax_pose *inner);

/* The pose that leads back, by the transpose of the rotation: exact as far as the rotation is one.
 * Rounded. */
sepax_pose sepax_pose_inverse(const sepax_pose *pose);

typedef struct {
  sepax_pose *pose;
  size_t count;
} sepax_poses;

/* Read poses from a text file: 12 decimal numbers a line, the rotation by rows, then the
 * translation in file units; '#' begins a comment, a line may be empty, UTF-8's byte order mark is
 * skipped. Each number is rounded to the nearest double, in every locale. Errors: FILE; FORMAT,
 * naming the line, on another count of numbers, on a number that is none or not finite, on a pose
 * that is not valid, and on a file without poses; MEMORY. */
bool sepax_poses_read(sepax_poses *poses, const char *path, sepax_error *error);

/* The same, each matrix replaced as sepax_pose_nearest does; *moved gets the largest change of all
 * entries. */
bool sepax_poses_read_nearest(sepax_poses *poses, double *moved, const char *path,
                              sepax_error *error);
void sepax_poses_free(sepax_poses *poses);

/* ------------------------------------------------------------------ meshes */

typedef enum { SEPAX_DOUBLE, SEPAX_FLOAT } sepax_real;

/* Triangles as the caller has them. The library reads them where they are, while a function that is
 * given the mesh runs, and keeps no pointer to them. Triangle i has the vertices with the numbers
 * index[3i], index[3i + 1], index[3i + 2], or without an index 3i, 3i + 1, 3i + 2. */
typedef struct {
  size_t size;
  const void *vertex;    /* x, y, z of the first vertex */
  sepax_real real;       /* what x, y and z are */
  size_t vertex_stride;  /* bytes from a vertex to the next; 0: three numbers */
  size_t vertices;       /* how many there are; only checked where there is an index */
  const uint32_t *index; /* three a triangle; NULL: vertices in their order */
  size_t index_stride;   /* bytes from the index of a triangle to that of the next; 0: three */
  size_t triangles;
} sepax_mesh;

/* Triangles that a function of the library made; three vertices each. */
typedef struct {
  double v[3][3];
} sepax_facet;

typedef struct {
  sepax_facet *facet;
  size_t count;
  double (*normal)[3]; /* as the file has them, if they were asked for; else NULL */
} sepax_soup;

void sepax_soup_free(sepax_soup *soup);

/* A soup as a function that takes a mesh is given it: a pointer to a compound literal. */
#define SEPAX_SOUP_MESH(soup) \
  (&SEPAX_STRUCT(sepax_mesh, .vertex = (soup)->facet, .triangles = (soup)->count))

/* Read an STL file, ASCII or binary (by its size, not by its first word), with the normals of its
 * facets if `normals`. ASCII decimals are correctly rounded to double, binary32 values are exact.
 * Errors: FILE; FORMAT on an empty, truncated or over-long file, no facets, NaN or infinity in a
 * coordinate or a normal, and on text that is no STL (with its line); MEMORY. */
bool sepax_stl_read(sepax_soup *soup, const char *path, bool normals, sepax_error *error);

/* Write a binary STL (coordinates rounded to binary32), or ASCII with 17 digits. Normals are those
 * of the soup, or else zero. The file is written under a temporary name beside path, then renamed
 * to path. Errors: ARGUMENT on no facets, on NaN or infinity, on a value that does not fit binary32
 * and on a facet that loses its area by rounding to it; FILE, also where path exists but is no
 * file. */
bool sepax_stl_write(const sepax_soup *soup, const char *path, bool ascii, sepax_error *error);

/* What sepax_soup_weld did; lengths in units of the soup. */
typedef struct {
  double length;     /* that was asked for */
  size_t moved;      /* vertices that are elsewhere now, */
  double farthest;   /* at most so far: up to ten lengths, as vertices may be in a chain */
  size_t degenerate; /* triangles that became an edge or a vertex of others and were left out */
  size_t duplicates; /* copies of triangles that were left out */
  size_t divided;    /* open sides of triangles that had vertices within the length put into them */
} sepax_weld;

/* Close a mesh that was rounded or torn:
 *   1. Vertices within `length` of each other, and chains of such, become the one of them whose x
 * is the least; of equal x, the least y; then z.
 *   2. A triangle that became a segment or a point is left out if it is an edge or a vertex of a
 *      triangle that is none. Of triangles with the same three vertices one stays, but those that
 *      are closed as two sheets, and would be open as one, remain two.
 *   3. A vertex within `length` of an edge of an odd number of triangles is put into that edge, if
 *      it is an end of such an edge itself: the triangle is divided there.
 * The set of triangles that results does not depend on their order, nor on that of their corners.
 * With length 0, only copies, segments and points that were there are left out. The soup's normals
 * are freed. `said` may be NULL. On failure the soup is as it was. A microsecond a triangle.
 * Errors: ARGUMENT on a length that is not within 0 ... 2^1000, on a soup without triangles, on
 * coordinates that are not within 2^1000, and on a length that is too long for the mesh: more than
 * a tenth of the longest side of its box, or so that a vertex would move by more than ten lengths,
 * that each has hundreds of others near, or that no triangle keeps three vertices; LIMIT on more
 * than 715,827,882 triangles; MEMORY. */
bool sepax_soup_weld(sepax_soup *soup, double length, sepax_weld *said, sepax_error *error);

/* ---------------------------------------------------------------- verdicts */

/* Axis numbers are those of the paper that docs/reference/paper.md describes. e_i is the edge from
 * A_i to A_i+1, f_j that from B_j to B_j+1 (i, j = 0, 1, 2 modulo 3). */
typedef enum {
  SEPAX_AXIS_NONE = 0,      /* no axis separates, or the method names none */
  SEPAX_AXIS_EDGES = 1,     /* 1 ... 9: SEPAX_AXIS_EDGES + 3i + j is e_i x f_j */
  SEPAX_AXIS_NORMAL_A = 10, /* N_A */
  SEPAX_AXIS_NORMAL_B = 11, /* N_B */
  SEPAX_AXIS_PLANE = 12     /* some axis in the common plane of a coplanar pair */
} sepax_axis;

/* Of two triangles. A pair is separated iff an axis is named, and this axis separates it. */
typedef struct {
  bool collision;
  bool strict;   /* a collision, and more than touching: both triangles have an area, they are not
                    coplanar, and their interiors (without the edges) share a point. They pass
                    through each other, and solids that they bound overlap */
  bool coplanar; /* one plane holds all six vertices */
  int axis;      /* sepax_axis: the first that separates in the order 10, 11, 1, 2, ... 9 */
} sepax_verdict;

/* The verdict on triangle a in pose_a and b in pose_b (NULL: as it is), v[k] vertex k: all doubles
 * are taken as the exact numbers that they are, nothing is rounded. They are finite. Some
 * microseconds. */
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

/* ------------------------------------------------------- all colliding pairs */

/* pair[n]: the number of a triangle of A and of one of B. */
typedef struct {
  size_t (*pair)[2];
  size_t count;
  bool ended; /* by a limit of the query: there may be more pairs */
} sepax_pairs;

void sepax_pairs_free(sepax_pairs *pairs);

/* How two meshes are searched. */
typedef struct {
  size_t size;
  int threads;      /* at most; 0: one for each processor */
  bool brute_force; /* every pair is tested */
  bool first;       /* end at a pair that collides, always at the same one */
  sepax_simd simd;
  /* Called now and then from the calling thread, at the end with done == total if nothing ends the
   * search before. False ends the search with SEPAX_ERROR_CANCELLED. NULL: not called. */
  bool (*progress)(void *context, uint64_t done, uint64_t total);
  void *context;
} sepax_search;

/* All colliding pairs of two meshes in their poses (NULL: as they stand), exact, in the order of i,
 * then of j. Without a tree: faster than sepax_body_new where two meshes are asked once. Errors:
 * ARGUMENT on a pose that is not valid, on an index beyond the vertices and on coordinates that are
 * not within 2^1000; LIMIT on 2^32 triangles; CANCELLED; MEMORY. */
bool sepax_meshes_collide(const sepax_mesh *a, const sepax_pose *pose_a, const sepax_mesh *b,
                          const sepax_pose *pose_b, const sepax_search *how, sepax_pairs *found,
                          sepax_error *error);

/* ------------------------------------------------------------------ bodies */

/* A mesh and its tree, as it stands in its file. It never changes; threads may share it. */
typedef struct sepax_body sepax_body;

/* How a body is built. */
typedef struct {
  size_t size;
  int threads; /* at most; 0: one for each processor */
} sepax_build;

/* Copies what it needs of the mesh; some 250 bytes a triangle. The result does not depend on the
 * number of threads. Errors: ARGUMENT on a mesh without triangles, on an index beyond the vertices,
 * and on a coordinate that is not within 2^1000, such as NaN or infinity (naming its facet); LIMIT
 * on more than 2^31 - 2 triangles; MEMORY. */
bool sepax_body_new(sepax_body **body, const sepax_mesh *mesh, const sepax_build *how,
                    sepax_error *error);
void sepax_body_free(sepax_body *body);
size_t sepax_body_triangles(const sepax_body *body);

/* What is asked of two bodies; by default all colliding pairs. */
typedef struct {
  size_t size;
  size_t most;    /* end after so many pairs; 0: no limit */
  bool only_any;  /* no pairs are kept: the count is 0 or 1 */
  bool strict;    /* only pairs that collide strictly (sepax_verdict): touching does not count */
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
 * bodies, the poses and the query. A search that a limit ended has found what is certain, but more
 * may collide; no pair found then leaves the bodies undecided. Errors: ARGUMENT on poses that are
 * not valid and on a time that is no number or negative; MEMORY. */
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

/* How a distance is asked for; by default whatever it is. */
typedef struct {
  size_t size;
  double limit; /* a distance above it is not looked for, which is faster; 0: no limit */
  const sepax_distance_result *last; /* of the same bodies, in poses like these: where to begin,
                                        which is faster; NULL: none */
  double seconds; /* end after so much time; 0: no limit. Where the way is a million times
                     the bodies' size, all triangles are as far as each other: it takes long */
  sepax_simd simd;
} sepax_distance_request;

/* The distance of the surfaces of two bodies in their poses (NULL: as they stand), the least of
 * sepax_distance_posed over all pairs of triangles, exact and rounded as there; and a pair that has
 * it. Errors: ARGUMENT on poses that are not valid, on limits that are no numbers or negative, and
 * on a `last` whose min_distance is no distance or whose pair or box these bodies lack; MEMORY. A
 * `last` of other bodies that passes costs time, but changes no result. */
bool sepax_bodies_distance(const sepax_body *a, const sepax_pose *pose_a, const sepax_body *b,
                           const sepax_pose *pose_b, const sepax_distance_request *request,
                           sepax_distance_result *result, sepax_error *error);

/* ------------------------------------------------------------------ solids */

/* The surface of a body. Vertices are one where their coordinates are equal (-0 is 0); an edge
 * joins two that differ. Edges are segments in space: one with a vertex of other triangles in its
 * middle may close a body with the two shorter edges there, if all are exactly on one line.
 * Triangles without area are triangles like others. A part is what hangs together by edges, and by
 * edges of an odd number of triangles that are on one line and share an end. Fill it with
 * sepax_shell_find; the body must stay as long as it. It never changes; threads may share it. */
typedef struct {
  const sepax_body *body;
  bool closed;     /* every point, but for a finite number of them, is on an even number of edges of
                      triangles: the body is a solid */
  bool consistent; /* there, as many edges run one way as the other; but for one edge where their
                      number is odd: no triangle is turned round */
  size_t facet;    /* where one is false: a triangle by its number in the mesh, and an edge of it */
  double edge[2][3]; /* that is not so; where both are false, an edge that is open */
  size_t parts;
  size_t pieces; /* parts that touch or overlap each other are one piece */
  struct sepax_parts *own;
} sepax_shell;

/* Some tenths of a microsecond a triangle. Errors: LIMIT on more than 715,827,882 triangles;
 * MEMORY. */
bool sepax_shell_find(sepax_shell *shell, const sepax_body *body, sepax_error *error);
void sepax_shell_free(sepax_shell *shell);

typedef enum { SEPAX_INSIDE_UNKNOWN, SEPAX_OUTSIDE, SEPAX_INSIDE } sepax_inside;

/* Two bodies in their poses (NULL: as they stand) of which no triangles collide: within[0] is
 * SEPAX_INSIDE iff a part of A is wholly inside the solid B, within[1] iff one of B is inside A;
 * else SEPAX_OUTSIDE. Parts that are open have no inside that is defined: where a part of A may be
 * inside the box of all open parts of B, it is not asked what that part is inside of, and within[0]
 * is SEPAX_INSIDE_UNKNOWN unless another part of A is inside; likewise within[1]. Exact for the
 * doubles given. Some microseconds for each part inside the other's box. Errors: ARGUMENT on a pose
 * that is not valid.
 *
 * A point is inside a part iff a ray from it meets the part an odd number of times; or, if the
 * part's own triangles are consistent, if it winds round the point, as where a part crosses itself
 * or is there twice. A point is inside a piece iff it is inside one of its parts, and inside the
 * solid iff it is inside an odd number of pieces. So a piece inside a piece is a cavity, what is in
 * that is material again, and parts that overlap are material where any of them is. A part may be
 * inside out, and triangles may be turned round: neither changes an inside by parity. */
bool sepax_bodies_within(const sepax_shell *a, const sepax_pose *pose_a, const sepax_shell *b,
                         const sepax_pose *pose_b, sepax_inside within[2], sepax_error *error);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif
#endif
