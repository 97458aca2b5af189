/* SPDX-License-Identifier: MIT */
/* sepax.h - libsepax: do two bodies collide, where, and how far are they from each other?
 *
 * Conventions
 *   - A body is a mesh of triangles. Coordinates are doubles in one unit of length, which the
 *     caller chooses. A result is exact for the doubles given, because nothing is rounded on the
 *     way to a verdict.
 *   - Two triangles collide if they have at least one point in common. Edges and vertices belong to
 *     a triangle, so touching is a collision.
 *   - A function that can fail returns false. Then *error has a code and one line of text. The text
 *     names the file or the value, and the cure. `error` may be NULL. After a failure all results
 *     of the function are zero and need not be freed, unless its comment says otherwise.
 *   - Invalid input never ends the process. No value is clamped or wrapped, and no triangle is
 *     dropped.
 *   - Meshes and structs of options begin with their size in bytes. SEPAX_STRUCT fills in the size.
 *     A field that is zero means its default value, so later versions can add fields without
 *     breaking a caller. A function that takes options also takes NULL, which means all defaults.
 *   - If a pose is NULL, then the body is not moved: its vertices keep the coordinates of its mesh.
 *   - sepax_NAME_free releases the memory of a sepax_NAME.
 *   - Triangles, vertices and meshes are numbered from 0, also in messages. Lines of a file are
 *     numbered from 1.
 *   - Only sepax_set_allocator changes global state. All other functions may be called from several
 *     threads at once.
 *
 * sepax_grid.h has triangles with integer coordinates. sepax_mechanism.h has links and joints.
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

/* The version of this header. While MAJOR is 0, a new MINOR version may break callers. A release
 * that breaks callers also raises the number at the end of the shared library's name,
 * libsepax.so.0. */
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

/* The version of the library that the program runs with. sepax_version_number returns a number
 * like SEPAX_VERSION_NUMBER; sepax_version returns a text like SEPAX_VERSION, for example "1.2.3".
 * The version of the library may differ from the version of the header. */
int sepax_version_number(void);
const char *sepax_version(void);

/* True if a program that was compiled with the headers of version `number` can call the library
 * that it runs with. Call it once at the start:
 * `if (!sepax_version_fits(SEPAX_VERSION_NUMBER)) ...`. */
bool sepax_version_fits(int number);

/* ------------------------------------------------------------------ errors */

/* The kind of a failure. The numbers never change. */
typedef enum {
  SEPAX_OK = 0,
  SEPAX_ERROR_ARGUMENT = 1,  /* an argument is outside its documented range */
  SEPAX_ERROR_MEMORY = 2,    /* the allocator returned NULL */
  SEPAX_ERROR_LIMIT = 3,     /* the input has more triangles, bits or bytes than a limit allows */
  SEPAX_ERROR_CANCELLED = 4, /* the caller's progress function ended the search */
  SEPAX_ERROR_FILE = 5,      /* a file cannot be opened, read or written */
  SEPAX_ERROR_FORMAT = 6,    /* a file or a text breaks the rules of its format */
  SEPAX_ERROR_NONE_FITS = 7  /* no design meets the request */
} sepax_code;

/* The report of a failure. A function that fails fills in both fields. `text` is one line without a
 * newline. */
typedef struct {
  sepax_code code;
  char text[512];
} sepax_error;

/* ------------------------------------------------------------------ memory */

/* The functions by which the library gets and returns memory. `allocate` and `resize` return NULL
 * if there is no memory. The memory must be aligned as malloc aligns memory. The three functions
 * must be thread-safe, because several threads may call them at once. */
typedef struct {
  void *(*allocate)(void *context, size_t bytes);
  void *(*resize)(void *context, void *memory, size_t bytes); /* if memory is NULL, it allocates */
  void (*release)(void *context, void *memory); /* if memory is NULL, it does nothing */
  void *context;
} sepax_allocator;

/* From now on the library uses this allocator. NULL restores malloc, realloc and free. Call the
 * function before any other function of the library, or after all memory of the library was freed,
 * because memory must return to the allocator that it came from. */
void sepax_set_allocator(const sepax_allocator *allocator);

/* Get, resize and release memory by the allocator that the library uses. Use these functions
 * for the parts of a sepax_soup or sepax_mechanism that the caller fills in, because the library
 * frees these parts. sepax_allocate and sepax_resize return NULL if there is no memory. After
 * sepax_resize returned NULL, the old memory is unchanged. Releasing NULL does nothing. */
void *sepax_allocate(size_t bytes);
void *sepax_resize(void *memory, size_t bytes);
void sepax_release(void *memory);

/* ----------------------------------------------------------------- options */

/* A struct with its size filled in, as a compound literal of C. In C++, set .size by hand. Example:
 * sepax_bodies_collide(a, p, b, q, &SEPAX_STRUCT(sepax_query, .most = 1), &found, &error). */
#define SEPAX_STRUCT(type, ...) ((type){.size = sizeof(type), __VA_ARGS__})

/* The vector instructions that a function uses. The results do not depend on them. If the processor
 * lacks the instructions that the caller asks for, then the function uses the widest ones that the
 * processor has. */
typedef enum {
  SEPAX_SIMD_BEST,
  SEPAX_SIMD_PORTABLE, /* 2 pairs at once, on any processor */
  SEPAX_SIMD_AVX2,     /* 4 pairs at once */
  SEPAX_SIMD_AVX512    /* 8 pairs at once */
} sepax_simd;

/* True if the processor has the vector instructions that `simd` names. */
bool sepax_simd_runs(sepax_simd simd);

/* "portable", "avx2" or "avx512": the instructions that a function would use if it were given
 * `simd`. */
const char *sepax_simd_name(sepax_simd simd);

/* ------------------------------------------------------------------- poses */

/* The place of a body: its point v lies at rotation * v + translation. rotation[i] is row i of the
 * matrix. The library computes with the entries as they are and never rounds them to a perfect
 * rotation. */
typedef struct {
  double rotation[3][3];
  double translation[3];
} sepax_pose;

/* True if the pose is valid. Let R be the matrix `rotation`. A pose is valid if all its numbers are
 * finite, no entry of R R^T differs from the identity matrix by more than 1e-6, and the determinant
 * of R is positive. If the pose is not valid, then sepax_pose_valid returns false and the code of
 * *error is ARGUMENT. */
bool sepax_pose_valid(const sepax_pose *pose, sepax_error *error);

/* Replace the matrix by the nearest rotation (its polar factor), up to rounding. Use it for a
 * matrix that was printed with few decimals. `moved` receives the largest change of an entry and
 * may be NULL. Errors: ARGUMENT if a number is not finite, if the matrix is a reflection, or if an
 * entry would change by more than 0.01. On failure the pose is unchanged. Cost: about 300
 * operations. */
bool sepax_pose_nearest(sepax_pose *pose, double *moved, sepax_error *error);

/* to = rotation * v + translation. `to` may be v. Each coordinate is rounded: three products and
 * three sums in double precision. */
void sepax_pose_apply(const sepax_pose *pose, const double v[3], double to[3]);

/* The pose that applies first `inner`, then `outer`. Each number of the pose is rounded as a
 * coordinate of sepax_pose_apply. */
sepax_pose sepax_pose_compose(const sepax_pose *outer, const sepax_pose *inner);

/* The inverse pose. Its rotation is the transpose of the matrix. The transpose equals the inverse
 * only if the matrix is a perfect rotation. The translation is rounded. */
sepax_pose sepax_pose_inverse(const sepax_pose *pose);

typedef struct {
  sepax_pose *pose;
  size_t count;
} sepax_poses;

/* Read poses from a text file. Each line has 12 decimal numbers: the rotation by rows, then the
 * translation. '#' begins a comment. Empty lines and the byte order mark of UTF-8 are skipped. Each
 * number is rounded to the nearest double, in every locale. Errors: FILE; FORMAT if the file has no
 * poses, if a line does not have 12 finite decimal numbers, or if its pose is not valid
 * (sepax_pose_valid); MEMORY. The text of *error names the bad line. */
bool sepax_poses_read(sepax_poses *poses, const char *path, sepax_error *error);

/* Read poses as sepax_poses_read does, but replace each matrix as sepax_pose_nearest does. *moved
 * receives the largest change of an entry in the file. */
bool sepax_poses_read_nearest(sepax_poses *poses, double *moved, const char *path,
                              sepax_error *error);
void sepax_poses_free(sepax_poses *poses);

/* ------------------------------------------------------------------ meshes */

typedef enum { SEPAX_DOUBLE, SEPAX_FLOAT } sepax_real;

/* Triangles in memory of the caller. A function that takes the mesh reads the triangles in place.
 * The library keeps no pointer to them after the function has returned. Triangle i has the vertices
 * index[3i], index[3i + 1] and index[3i + 2]. Without an index it has the vertices 3i, 3i + 1 and
 * 3i + 2. */
typedef struct {
  size_t size;
  const void *vertex;    /* x, y, z of the first vertex */
  sepax_real real;       /* type of x, y and z */
  size_t vertex_stride;  /* bytes from one vertex to the next; 0: the size of 3 numbers */
  size_t vertices;       /* number of vertices; read only if there is an index */
  const uint32_t *index; /* three numbers for each triangle; NULL: no index */
  size_t index_stride;   /* bytes from the index of one triangle to the next; 0: 12 bytes */
  size_t triangles;
} sepax_mesh;

/* A triangle of a sepax_soup: v[k] is vertex k. */
typedef struct {
  double v[3][3];
} sepax_facet;

/* A soup: triangles that the library read from a file or made. */
typedef struct {
  sepax_facet *facet;
  size_t count;
  double (*normal)[3]; /* normals of the file, one for each facet; NULL if not asked for */
} sepax_soup;

void sepax_soup_free(sepax_soup *soup);

/* Use SEPAX_SOUP_MESH(&soup) as the argument of a function that takes a mesh. The macro makes a
 * mesh, as a compound literal of C, and returns a pointer to that mesh. */
#define SEPAX_SOUP_MESH(soup) \
  (&SEPAX_STRUCT(sepax_mesh, .vertex = (soup)->facet, .triangles = (soup)->count))

/* Read an STL file, ASCII or binary. The size of the file decides between the two, because a binary
 * file may begin with the word "solid", too. If `normals` is true, then the normals of the facets
 * are read as well. Decimal numbers are rounded to the nearest double; binary numbers are exact.
 * Errors: FILE; FORMAT if the file is empty, truncated or too long, if it has no facets, if a
 * coordinate or a normal is NaN or infinite, or if the text is not STL (*error names the line);
 * MEMORY. */
bool sepax_stl_read(sepax_soup *soup, const char *path, bool normals, sepax_error *error);

/* Write an STL file: binary, with coordinates rounded to binary32, or ASCII with 17 digits, which
 * loses nothing. Normals are those of the soup, or zero if it has none. The file is written under a
 * temporary name in the folder of `path` and then renamed, so `path` never has half a file. Errors:
 * ARGUMENT if the soup has no facets, if a number is NaN or infinite, or, in a binary file, if a
 * number does not fit binary32 or a facet would lose its area by rounding; FILE, also if `path`
 * exists but is not a file. */
bool sepax_stl_write(const sepax_soup *soup, const char *path, bool ascii, sepax_error *error);

/* What sepax_soup_weld changed. Lengths are in the unit of the soup. */
typedef struct {
  double length;     /* the length that the caller asked for */
  size_t moved;      /* vertices that moved */
  double farthest;   /* the longest distance that a vertex moved. It may be up to 10 times
                        `length`, because a chain of vertices becomes one vertex */
  size_t degenerate; /* triangles left out because they became an edge or a vertex of others */
  size_t duplicates; /* triangles left out because they were copies */
  size_t divided;    /* open edges into which a vertex was inserted (step 3 below) */
} sepax_weld;

/* Close a mesh whose vertices were rounded or torn apart:
 *   1. Vertices within `length` of each other become one vertex. A chain of vertices, each within
 *      `length` of the next, also becomes one vertex. The vertex with the least x stays; of equal
 *      x, the least y; then the least z.
 *   2. A triangle that became a segment or a point is left out if it is an edge or a vertex of a
 *      triangle with three different vertices. Of several triangles with the same three vertices
 *      one stays. But two of them stay if the mesh is closed with two and open with one.
 *   3. An edge is open if an odd number of triangles has it. If an end of an open edge lies
 *      within `length` of a second open edge, then this end becomes a vertex of the second edge and
 *      divides its triangle there.
 * The resulting set of triangles depends neither on their order nor on the order of their vertices.
 * If the length is 0, then no vertex moves and no edge is divided: only copies, segments and points
 * that are already in the mesh are left out. The normals of the soup are freed. `said` may be NULL.
 * On failure the soup is unchanged. Cost: about a microsecond for each triangle.
 *
 * Errors: ARGUMENT if the length is not in 0 ... 2^1000, if a coordinate is not within 2^1000, if
 * the soup has no triangles, or if the length is too long for the mesh; LIMIT on more than
 * 715,827,882 triangles; MEMORY. A length is too long if it is more than a tenth of the longest
 * side of the mesh's AABB, if a vertex would move by more than ten lengths, if hundreds of vertices
 * are near each vertex, or if no triangle keeps three vertices. */
bool sepax_soup_weld(sepax_soup *soup, double length, sepax_weld *said, sepax_error *error);

/* ---------------------------------------------------------------- verdicts */

/* Axis numbers, as in the paper that docs/reference/paper.md describes. e_i is the edge from vertex
 * A_i to A_i+1, and f_j is the edge from vertex B_j to B_j+1 (indices modulo 3). N_A and N_B are
 * the normals of the triangles. */
typedef enum {
  SEPAX_AXIS_NONE = 0,      /* the triangles collide, or the judging method names no axis */
  SEPAX_AXIS_EDGES = 1,     /* first of 9: SEPAX_AXIS_EDGES + 3i + j is e_i x f_j */
  SEPAX_AXIS_NORMAL_A = 10, /* N_A */
  SEPAX_AXIS_NORMAL_B = 11, /* N_B */
  SEPAX_AXIS_PLANE = 12     /* an axis in the common plane of a coplanar pair */
} sepax_axis;

/* The verdict on two triangles. If they are separated, then `axis` names an axis that separates
 * them. If they collide, then `axis` is SEPAX_AXIS_NONE. */
typedef struct {
  bool collision;
  bool strict;   /* the triangles pass through each other: both have an area, they are not coplanar,
                    and their interiors (without edges) share a point. If two solids have such
                    triangles, then the solids overlap */
  bool coplanar; /* all six vertices are in one plane */
  int axis;      /* a sepax_axis: the first that separates, in the order 10, 11, 1, 2, ... 9 */
} sepax_verdict;

/* The verdict on triangle a in pose_a and triangle b in pose_b. a[k] is vertex k. The verdict is
 * exact for the doubles given. All numbers must be finite. Cost: a few microseconds. */
sepax_verdict sepax_exact_posed(const double a[3][3], const sepax_pose *pose_a,
                                const double b[3][3], const sepax_pose *pose_b);

/* The distance between triangle a in pose_a and triangle b in pose_b. a[k] is vertex k.
 * No coordinate or translation may be greater than 2^1000 in absolute value, and the poses must be
 * valid (sepax_pose_valid).
 *
 * The result is 0 if and only if the triangles collide (sepax_exact_posed). Otherwise it differs
 * from the exact distance by less than one unit in the last place. An exact distance below 2^-1074
 * is returned as 2^-1074.
 *
 * `nearest` receives a point of A and a point of B at that distance. If the triangles collide, then
 * both points are the same common point. Each coordinate is wrong by at most 2^-51 of the largest
 * coordinate of a vertex or a translation. `nearest` may be NULL. Cost: a few microseconds, more
 * for triangles that nearly touch. */
double sepax_distance_posed(const double a[3][3], const sepax_pose *pose_a, const double b[3][3],
                            const sepax_pose *pose_b, double nearest[2][3]);

/* ------------------------------------------------------- all colliding pairs */

/* Pairs of triangles: pair[n][0] is a triangle of A, and pair[n][1] is a triangle of B. A query
 * that sets the field `each` or `only_any` of sepax_query lists no pairs. Its result has a `pair`
 * of NULL, and `count` is the number of pairs that were found. */
typedef struct {
  size_t (*pair)[2];
  size_t count;
  bool ended; /* a limit of sepax_query ended the search, so there may be more pairs */
} sepax_pairs;

void sepax_pairs_free(sepax_pairs *pairs);

/* Options of a search for all colliding pairs of two meshes. */
typedef struct {
  size_t size;
  int threads;      /* number of threads at most; 0: one for each processor */
  bool brute_force; /* test every pair; this is slow and serves to check the search */
  bool first;       /* end at the first pair found; it is always the same pair */
  sepax_simd simd;
  /* The library calls `progress` now and then from the calling thread, the last time with done ==
   * total. If `progress` returns false, then the search fails with CANCELLED. NULL: no calls. */
  bool (*progress)(void *context, uint64_t done, uint64_t total);
  void *context; /* first argument of `progress` */
} sepax_search;

/* All pairs of triangles of two meshes that collide, each mesh in its pose. The result is exact and
 * sorted by the triangle of A, then by the triangle of B. No tree is built. So for
 * a single query on two meshes this function is faster than sepax_body_new with
 * sepax_bodies_collide. Errors: ARGUMENT if a pose is not valid, an index is beyond the vertices,
 * or a coordinate is not within 2^1000; LIMIT on 2^32 triangles or more; CANCELLED; MEMORY. */
bool sepax_meshes_collide(const sepax_mesh *a, const sepax_pose *pose_a, const sepax_mesh *b,
                          const sepax_pose *pose_b, const sepax_search *how, sepax_pairs *found,
                          sepax_error *error);

/* ------------------------------------------------------------------ bodies */

/* A copy of a mesh together with its bounding volume hierarchy, which makes queries fast. A body
 * never changes, so threads may share it. */
typedef struct sepax_body sepax_body;

/* Options of sepax_body_new. */
typedef struct {
  size_t size;
  int threads; /* number of threads at most; 0: one for each processor */
} sepax_build;

/* Make a body from a mesh. The body copies the mesh and takes 230 to 310 bytes for each triangle,
 * and up to 410 while it is made.
 * The body does not depend on the number of threads. Errors: ARGUMENT if the mesh has no triangles,
 * if an index is beyond the vertices, or if a coordinate is NaN or not within 2^1000 (the text
 * of *error names the triangle); LIMIT on more than 2^31 - 2 triangles; MEMORY. */
bool sepax_body_new(sepax_body **body, const sepax_mesh *mesh, const sepax_build *how,
                    sepax_error *error);
void sepax_body_free(sepax_body *body);
size_t sepax_body_triangles(const sepax_body *body);

/* Options of a query on two bodies. By default the query lists all colliding pairs. */
typedef struct {
  size_t size;
  size_t most;   /* end after this many pairs; 0: no limit */
  bool only_any; /* end at the first pair and list none: the count is 0 or 1 */
  bool strict;   /* only pairs that pass through each other (sepax_verdict), not those that touch */
  double seconds; /* end after this time; 0: no limit */
  /* The library calls `each` with every pair instead of listing the pair. If `each` returns false,
   * then the search ends. NULL: the pairs are listed. */
  bool (*each)(void *context, size_t a, size_t b);
  void *context; /* first argument of `each` */
  sepax_simd simd;
} sepax_query;

/* The pairs of triangles of two bodies that collide, each body in its pose. The result is exact for
 * the doubles given. The order of the pairs depends only on the bodies, the poses and the query.
 *
 * A pair that collides strictly (sepax_verdict) proves that the solids overlap. The reverse does
 * not hold: two solids can overlap without such a pair, for example a solid and its copy in the
 * same pose. Solids that only touch, face on face or edge on face, have no strict pair.
 *
 * If a limit ended the search (found->ended), then every pair in `found` collides, and more pairs
 * may collide. If then `found` has no pair, it is unknown whether the bodies collide. Errors:
 * ARGUMENT if a pose is not valid or the time is negative or NaN; MEMORY. */
bool sepax_bodies_collide(const sepax_body *a, const sepax_pose *pose_a, const sepax_body *b,
                          const sepax_pose *pose_b, const sepax_query *query, sepax_pairs *found,
                          sepax_error *error);

/* The pairs of triangles whose distance is at most `distance`, a number in 0 ... 2^1000. If the
 * query is strict and `distance` is above 0, then the distance of a pair must be less than
 * `distance`. The comparison is exact for the doubles given. With 0 the function is
 * sepax_bodies_collide. Order, limits and errors are those of sepax_bodies_collide. */
bool sepax_bodies_near(const sepax_body *a, const sepax_pose *pose_a, const sepax_body *b,
                       const sepax_pose *pose_b, double distance, const sepax_query *query,
                       sepax_pairs *found, sepax_error *error);

/* Searches for distances count their work in units: 1 for each comparison of two boxes of the
 * trees, or of a box with eight boxes; 1 for each estimate of the distance of two triangles; 8 for
 * each proof by a direction of two triangles; 50 for each exact test of two triangles. The units of
 * a query depend only on its arguments and on the instruction set, except that a limit in seconds
 * ends it by the clock, and that a front depends on its earlier queries. A unit takes 0.05 to 0.15
 * microseconds on a processor of 2020. A search ends at the latest 600 units after its limit,
 * because it completes its step. A query with a front also takes a unit for each 64 entries of the
 * front, whatever the limit is. */

/* The distance of two bodies and where it is found: least <= distance <= most. Both bounds are
 * certain for the doubles given. */
typedef struct {
  double min_distance; /* the distance of the two triangles in `pair`, which are the nearest that
                          were found. Infinite if that distance is above the limit of the request,
                          or if the search ended before it found two triangles; then
                          nearest_points, pair and box are 0 */
  double least, most;  /* the interval that holds the distance of the bodies. `most` is infinite if
                          min_distance is */
  double nearest_points[2][3]; /* a point of A and a point of B at min_distance */
  size_t pair[2];              /* the triangle of A and the triangle of B that have these points */
  uint32_t box[2]; /* the places of both triangles in the trees of the bodies; 0 if the bodies
                      collide. A later request that names this result in its field `last` begins
                      at these places */
  uint64_t work;   /* units of work that the search took */
  bool ended;      /* a limit of work or time ended the search: the interval is certain, but may be
                      wider than the tolerance */
} sepax_distance_result;

/* Options of sepax_bodies_distance. By default the distance is exact and there are no limits. */
typedef struct {
  size_t size;
  double limit; /* report a longer distance as infinite, which is faster; 0: no limit. Then `least`
                   is the limit, unless a limit of work or time ended the search */
  /* The tolerance, 0 <= relative < 1 and absolute >= 0: the search ends when most - least is at
   * most `relative` times most, or at most `absolute`. A tolerance saves time where many triangles
   * are nearly equally far, and 1e-12 costs hardly more than 1e-6. An interval is never
   * narrower than one unit in the last place of `most`. If both numbers are 0, then min_distance is
   * the distance of the bodies, right to one unit in the last place. */
  double relative, absolute;
  /* A result for the same bodies in similar poses. The search begins at the triangles of that
   * result and is faster. A result of other bodies is an error if the bodies of the request do
   * not have its triangles. Otherwise such a result costs time, but does not change the interval
   * by more than the tolerance. NULL, or a result without triangles: none. */
  const sepax_distance_result *last;
  uint64_t work;  /* end after so many units of work; 0: no limit */
  double seconds; /* end after this time; 0: no limit */
  sepax_simd simd;
} sepax_distance_request;

/* The distance between the surfaces of two bodies, each in its pose, and a pair of triangles at
 * that distance. It is the least value of sepax_distance_posed over all pairs of triangles. A body
 * inside another has the distance of the surfaces, not 0. Real time: the call neither allocates nor
 * locks, and reads a clock only if `seconds` is set. Errors: ARGUMENT if a pose is not valid, a
 * limit or tolerance is out of range, or `last` names triangles that the bodies do not have. */
bool sepax_bodies_distance(const sepax_body *a, const sepax_pose *pose_a, const sepax_body *b,
                           const sepax_pose *pose_b, const sepax_distance_request *request,
                           sepax_distance_result *result, sepax_error *error);

typedef enum {
  SEPAX_UNDECIDED, /* a limit of work ended the search, or positions within a travel differ */
  SEPAX_APART,     /* the bodies are farther apart than the distance asked for */
  SEPAX_NEAR       /* two triangles are at most that distance apart */
} sepax_nearness;

/* A front: what a search proved about the parts of two bodies, kept for the next poses. If the
 * bodies move little from one query to the next, then the next query looks only at parts that the
 * motion may have brought near. Only the motion of one body as seen from the other counts.
 *
 * A front lives in memory of the caller, and a query with a front allocates nothing. Two threads
 * must not use a front at once. */
typedef struct sepax_front sepax_front;

/* The bytes of memory that a front of so many entries takes: 20 for each entry, and less than 500
 * more. A front has at most 2^24 entries. A search makes an entry for each comparison of a box with
 * eight boxes and for each estimate of the distance of two triangles. 512 entries do for queries
 * that take up to 20 microseconds. */
size_t sepax_front_bytes(size_t entries);

/* Make an empty front in the memory. The front uses as many entries as the bytes hold, in steps
 * of 8. If a search makes more entries, then the front becomes empty and the answer is right all
 * the same. The caller releases the memory after the last query with the front. Cost: all the
 * memory is written. Error: ARGUMENT if the memory is NULL or has less than sepax_front_bytes(0)
 * bytes. */
bool sepax_front_begin(sepax_front **front, void *memory, size_t bytes, sepax_error *error);

/* Options of sepax_bodies_apart. By default there are no limits. */
typedef struct {
  size_t size;
  uint64_t work; /* end after so many units of work; 0: no limit */
  sepax_simd simd;
  /* What the searches of earlier queries proved; the query updates the front. Any poses and any
   * distance may follow each other. If the front is of two other bodies, or of the same bodies in
   * the other order, then it becomes empty first. After a body of the front was freed, call
   * sepax_front_begin again, because another body may get its address. The verdict does not depend
   * on the front if the work does not end; `pair`, `least` and `work` may. NULL: none. */
  sepax_front *front;
} sepax_apart_request;

typedef struct {
  sepax_nearness verdict;
  size_t pair[2]; /* if NEAR: a triangle of A and a triangle of B that are that near */
  double least;   /* the distance of the bodies is at least this. If APART, `least` is at least the
                     distance asked for; it is seldom close to the distance of the bodies */
  uint64_t work;  /* units of work that the search took */
} sepax_apart_result;

/* Are two bodies, each in its pose, farther apart than `distance`, a number in 0 ... 2^1000? The
 * verdict is exact for the doubles given. Use it where a verdict is needed and the distance itself
 * is not; `work` bounds its time. A distance of 0 asks for a collision. Real time: the call neither
 * allocates, nor locks, nor reads a clock. Cost: 0.5 to 2 microseconds for most poses. Errors:
 * ARGUMENT if a pose is not valid or the distance is out of range. */
bool sepax_bodies_apart(const sepax_body *a, const sepax_pose *pose_a, const sepax_body *b,
                        const sepax_pose *pose_b, double distance,
                        const sepax_apart_request *request, sepax_apart_result *result,
                        sepax_error *error);

/* ------------------------------------------------------------------ solids */

/* The surface of a body: is it closed, and which parts does it have? sepax_shell_find fills it in.
 * The body must live as long as its shell. A shell never changes, so threads may share it.
 *
 * Vertices with equal coordinates are one vertex (-0 equals 0). An edge joins two different
 * vertices. Edges are compared as segments in space, not by their ends: two short edges may match
 * one long edge if all three lie exactly on one line. A triangle without area opens nothing: its
 * edges cancel each other.
 *
 * Triangles that share an edge belong to the same part. An edge is uneven if more triangles run
 * along it in one direction than in the other. Triangles whose uneven edges lie on one line and
 * share an end belong to the same part, too. */
typedef struct {
  const sepax_body *body;
  bool closed;       /* the body is a solid: every point of its edges, except for a finite number of
                        points, lies on an even number of triangle edges */
  bool consistent;   /* no triangle is turned round: at every point of the edges, except for a
                        finite number of points, as many edges run in one direction as in the
                        other. Of a body that is not closed it only says: of the edges that end at
                        a vertex on one line, at most one more runs to it than from it, or from it
                        than to it */
  size_t facet;      /* if `closed` or `consistent` is false: a triangle, not without area, with an
                        edge at one of whose ends the rule of that field is broken */
  double edge[2][3]; /* the ends of that edge. If both fields are false, then the broken rule is
                        that of `closed` */
  size_t parts;
  size_t pieces;           /* parts that touch or overlap each other form one piece */
  struct sepax_parts *own; /* private */
} sepax_shell;

/* Find the shell of a body. The result is exact: no tolerance is used. Cost: about 0.3 microseconds
 * for each triangle, twice as much if many edges overlap. Errors: LIMIT on more than 715,827,882
 * triangles; MEMORY. */
bool sepax_shell_find(sepax_shell *shell, const sepax_body *body, sepax_error *error);
void sepax_shell_free(sepax_shell *shell);

typedef enum { SEPAX_INSIDE_UNKNOWN, SEPAX_OUTSIDE, SEPAX_INSIDE } sepax_inside;

/* Is a part of one body wholly inside the other body? Call it only for bodies that have no
 * colliding pair of triangles in these poses. within[0] is SEPAX_INSIDE if a part of A is inside
 * the solid B, and SEPAX_OUTSIDE if none is. within[1] says the same of the parts of B and the
 * solid A. The result is exact for the doubles given.
 *
 * An open part has no inside. So the function does not judge a part of A that may lie within the
 * AABB that encloses all open parts of B. If A has such a part and no other part of A is inside B,
 * then within[0] is SEPAX_INSIDE_UNKNOWN. within[1] likewise.
 *
 * The triangles at an edge are neighbours if the edge has exactly two of them, which run along it
 * in opposite directions. Triangles that are joined by neighbours form a sheet. A ray crosses a
 * triangle outwards if it leaves on the triangle's outer side, and inwards otherwise.
 *   1. If a ray from a point crosses each sheet as often outwards as inwards, then the point is
 *      outside. No closed surface that any of the triangles form encloses the point.
 *   2. Otherwise the crossings are summed. Open parts do not count, and no parts of which each
 *      sheet is crossed as often outwards as inwards. If each part that counts is consistent, then
 *      the point is inside if more crossings are outwards than inwards, or if in each of these
 *      parts more are inwards (a body inside out). If one of them is not consistent, then the point
 *      is inside if the number of crossings is odd.
 *   3. If as many crossings are outwards as inwards, then the point is outside if it is in a
 *      cavity: the parts round the point do not touch each other, and from the outermost part on
 *      they are wound outwards and inwards by turns. If sheets of an open part do not cancel, then
 *      this rule says nothing.
 *   4. Otherwise the point is SEPAX_INSIDE_UNKNOWN, if none of six rays tells more.
 * So the solids of one body are united, even if one solid lies in another one. A cavity must be
 * wound inwards. The rules leave a point undecided in a surface that has both sides of each face,
 * and where a solid overlaps another solid that is inside out. docs/reference/solids.md has the
 * proof, and says which triangles are neighbours where edges overlap.
 *
 * Cost: a few microseconds for each part that lies within the AABB of the other body. Errors:
 * ARGUMENT if a pose is not valid. */
bool sepax_bodies_within(const sepax_shell *a, const sepax_pose *pose_a, const sepax_shell *b,
                         const sepax_pose *pose_b, sepax_inside within[2], sepax_error *error);

/* Why a point is INSIDE or UNKNOWN:
 *   NESTED: it is inside several shells that do not touch and are wound alike, which are solids in
 *     each other. A cavity must be wound inwards.
 *   OPEN: not known. Open parts may enclose it.
 *   INCONSISTENT: not known. A part round it has triangles that are turned round.
 *   DOUBLED: not known. A part round it has faces twice, as two sides or as copies; or it is a
 *     solid and a cavity with a common edge.
 *   OPPOSED: not known. Parts round it touch and are wound in opposite ways: one of them is inside
 *     out, or a cavity that touches its wall.
 *   SHEETS: not known. A ray from it crosses more than 256 sheets.
 * PLAIN: there is nothing to say. */
typedef enum {
  SEPAX_WITHIN_PLAIN,
  SEPAX_WITHIN_NESTED,
  SEPAX_WITHIN_OPEN,
  SEPAX_WITHIN_INCONSISTENT,
  SEPAX_WITHIN_DOUBLED,
  SEPAX_WITHIN_OPPOSED,
  SEPAX_WITHIN_SHEETS
} sepax_within_reason;

/* As sepax_bodies_within; why[i] is the reason of within[i]. */
bool sepax_bodies_within_why(const sepax_shell *a, const sepax_pose *pose_a, const sepax_shell *b,
                             const sepax_pose *pose_b, sepax_inside within[2],
                             sepax_within_reason why[2], sepax_error *error);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif
#endif
