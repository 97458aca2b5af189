/* sepax.h - libsepax: golden models of triangle/triangle collision detection by
 * the separating axis theorem (SAT), and the data they work on.
 *
 * Conventions of every function below
 *   - Coordinates are integers of W bits, two's complement; 1 LSB is the length
 *     one step stands for (2 um in the paper). W is 4 ... 32.
 *   - A collision is at least one common point of the two closed triangles;
 *     touching counts. The verdict is true for a collision.
 *   - A function that can fail returns false and leaves one line in *error
 *     which names the file or the value and the cure; its results are then
 *     untouched or freed. Nothing is clamped, wrapped or dropped.
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
#define SEPAX_II_MAX 18
#define SEPAX_LANES_MAX 64
#define SEPAX_MEMORY_MIN 128
#define SEPAX_MEMORY_MAX 32768

/* One line of text without a newline; empty until something failed. */
typedef struct {
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

/* Two triangles and their normals. A normal is a direction of W-bit components,
 * Q1.(W-1) of a unit vector when sepax_unit_normal or the quantiser made it. */
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

/* ----------------------------------------------------------- configuration */

typedef enum {
  SEPAX_ARCH_PAPER,      /* the paper's datapath, bit for bit */
  SEPAX_ARCH_EXACT,      /* the mathematical verdict, and the axis */
  SEPAX_ARCH_REFERENCE,  /* software: the same verdict by another method, sepax_reference */
  SEPAX_ARCH_FLOAT32,    /* software baseline in IEEE single precision */
  SEPAX_ARCH_FLOAT64,    /* software baseline in IEEE double precision */
  SEPAX_ARCH_INTERVAL32, /* the interval test of Moeller, the usual one, single precision */
  SEPAX_ARCH_INTERVAL64, /* the same in double precision */
  SEPAX_ARCH_CONFERENCE  /* the machine that the paper improves on, docs/conference.md */
} sepax_arch;

typedef enum {
  SEPAX_COPLANAR_PLANE, /* |B_k.N_A - A_k.N_A| < epsilon for all k: right */
  SEPAX_COPLANAR_PAPER  /* |A_k.N_A - B_k.N_B| < epsilon for all k: printed */
} sepax_coplanarity;

typedef enum {
  SEPAX_INEQUALITY_CORRECT, /* (5) as max A < min B */
  SEPAX_INEQUALITY_PRINTED  /* (5) as printed: max A > min B */
} sepax_inequality;

/* What model, generator and benches must agree on, and all they share. */
typedef struct {
  sepax_arch arch;
  int word;         /* W, 4 ... 32 */
  int ii;           /* initiation interval, cycles; exact: 1 ... 18, paper and conference: 3 */
  bool full;        /* every bit of every intermediate is kept */
  int guard;        /* else W + guard bits of each are; 0 ... 2W + 3 */
  bool block_float; /* axes shifted left in common before truncation */
  sepax_coplanarity coplanarity;
  sepax_inequality inequality;
  int epsilon;            /* LSB, 0 ... 2^(W-1) - 1; 0 asks for equality */
  bool flag;              /* exact: coplanar pairs are called collisions, undecided */
  int clock_ps;           /* exact: the period to pipeline for, 500 ... 20000 ps */
  int extent_a, extent_b; /* exact: longest side of the box of a triangle of A, of B, in
                             LSB, that the core decides; 0, 0: any */
  bool early_out;         /* exact: a box test goes before the core, which gets zeros for pairs that
                             it decides; with extents it does anyway */
  int clearance, warning; /* exact: LSB; -1 and 0: none. The verdict is free only if the real
                             triangles are farther apart than `clearance` (docs/clearance.md) */
  int lanes;              /* exact: box lanes of an object engine, 1 ... 64; 0: the core alone */
  int cores;              /* of the engine, 1 ... 8 */
  int memory_a, memory_b; /* triangles of A, of B that it holds: 2^7 ... 2^15 */
} sepax_config;

/* The defaults: exact, W = 18, II = 3, coplanar pairs decided, 2 ns; and for paper and
 * conference full, plane, correct, epsilon 1. */
sepax_config sepax_config_default(void);

/* Set one value from text, by the name of its command-line option: "arch",
 * "word", "ii", "precision" (full, word, guard=G), "block-float" (on, off),
 * "coplanarity", "inequality", "epsilon", "coplanar" (exact, flag), "clock-ns" (at most
 * three decimals), "extent-a", "extent-b", "early-out" (none, boxes), "clearance", "warning",
 * "lanes", "cores", "memory-a", "memory-b". Fails on an unknown name or value. */
bool sepax_config_set(sepax_config *config, const char *name, const char *value,
                      sepax_error *error);

/* Parse a line that sepax_config_text wrote ("--arch=paper --word=18 ..."). */
bool sepax_config_parse(sepax_config *config, const char *text, sepax_error *error);

/* What the architecture reads, as "--arch=paper --word=18 ...", into text[size];
 * sepax_config_parse reads it back. Returns text. */
char *sepax_config_text(const sepax_config *config, char *text, size_t size);

/* Fails with the legal range if a value or a combination is not supported, and if a
 * choice is made that the architecture does not have. */
bool sepax_config_check(const sepax_config *config, sepax_error *error);

const char *sepax_arch_name(sepax_arch arch);

/* Fixed-point format of an intermediate of the paper's datapath. The exact value
 * needs `exact` bits (interval analysis); the lowest `shift` of them are dropped
 * by flooring, `width` = exact - shift are kept. docs/paper.md lists the table. */
typedef struct {
  const char *name;
  int exact, width, shift;
  int digits; /* in architecture exact, of a factor: radix-4 digits it is cut into */
} sepax_format;

typedef enum {
  SEPAX_F_VERTEX,            /* a coordinate */
  SEPAX_F_NORMAL,            /* a component of N_A, N_B */
  SEPAX_F_NORMAL_PRODUCT,    /* coordinate x normal component */
  SEPAX_F_NORMAL_PROJECTION, /* t_k, s_k, u_k, v_k */
  SEPAX_F_EDGE,              /* component of an edge; holds a normal's too */
  SEPAX_F_CROSS_PRODUCT,     /* one product of a cross product */
  SEPAX_F_AXIS,              /* component of an axis */
  SEPAX_F_PRODUCT,           /* coordinate x axis component */
  SEPAX_F_PROJECTION,        /* vertex . axis */
  SEPAX_F_COUNT
} sepax_format_id;

/* Numbers of architecture exact (docs/exact.md): `exact` bits hold every term, `width`
 * the result; sums that cancel are taken modulo 2^width. shift is 0. */
enum {
  SEPAX_X_COORDINATE,
  SEPAX_X_SPAN,       /* sum or difference of two coordinates */
  SEPAX_X_AREA,       /* t_ij, g_ijk: twice an area */
  SEPAX_X_WEIGHT,     /* sum of z, the origin moved to A: for triangles of both; plus
                         1 + 4 + 16 ..., as its digits want it (docs/exact.md) */
  SEPAX_X_OWN_WEIGHT, /* the same for triangle B itself */
  SEPAX_X_VOLUME,     /* h_ijk, v_ijkl: six times a volume */
  SEPAX_X_CROSS,      /* with a clearance: a component of e x f, N_A, N_B; */
  SEPAX_X_LIMIT,      /* what twice a gap on such an axis must exceed; */
  SEPAX_X_EDGE_LIMIT  /* and on an axis normal to an edge and a coordinate axis */
};

/* A checked configuration with what follows from it. */
typedef struct {
  sepax_config config;
  sepax_format format[SEPAX_F_COUNT]; /* by sepax_format_id, or SEPAX_X_... for exact */
  int formats;
  bool boxes;             /* exact: a box test goes before the core */
  int core_word;          /* exact: bits of a coordinate behind the box test; W without extents */
  int64_t coplanar_limit; /* |difference| < limit, in units of NORMAL_PROJECTION */
  int latency;            /* cycles from the first input word to the verdict; of exact it
                             follows from the schedule that the generator makes */
  int limits;             /* clearances asked for, 0 ... 2 */
  int64_t margin[2];      /* with them: a gap of the boxes above margin[0] is outside of the
                             clearance, above margin[1] free; 1 + clearance, 1 + warning */
} sepax_design;

/* Check the configuration and derive formats, limit and latency. */
bool sepax_design_init(sepax_design *design, const sepax_config *config, sepax_error *error);

/* ---------------------------------------------------------------- verdicts */

/* Axis numbers are the paper's: 1 ... 9 of table 1, 1 + 3i + j being e_i x f_j with e_i
 * the edge from A_i to A_i+1 and f_j that from B_j to B_j+1 (i, j = 0, 1, 2 modulo 3);
 * 10 = N_A, 11 = N_B; 0 when none separates or the method has none. Of coplanar pairs
 * paper and conference number the axes 1 ... 6 of table 2, exact calls every axis in the plane 12.
 * With a box test in front 13 are disjoint boxes, and with extents 14 boxes that meet, one of them
 * larger than its extent: a collision, undecided. With a clearance 13 is x, y or z, 12 normal to an
 * edge and to x, y or z. */
typedef enum { SEPAX_BAND_FREE, SEPAX_BAND_WARNING, SEPAX_BAND_COLLISION } sepax_band;
enum { SEPAX_AXIS_BOXES = 13, SEPAX_AXIS_RANGE = 14 };

typedef struct {
  bool collision;
  bool coplanar;   /* by the architecture's own test; false if it has none */
  int axis;        /* at which the search stops; it goes 10, 11, 1, 2, ... 9 */
  int mul_project; /* multiplications in projections, as the paper counts them */
  int mul_axes;    /* multiplications in cross products, which it leaves out */
  sepax_band band; /* with a clearance; collision is then band == SEPAX_BAND_COLLISION */
} sepax_verdict;

/* The verdict of the architecture of `design`, bit for bit what its RTL gives.
 * Pair: W-bit components (the caller checks, sepax_pair_fits). Only `paper` and `conference` read
 * the normals and count multiplications. Of `exact` it is that of sepax_exact, but where
 * the design flags coplanar pairs they are collisions, axis 0, and where a box
 * test goes before the core boxes are tested first (axes 13, 14). */
sepax_verdict sepax_judge(const sepax_design *design, const sepax_pair *pair);

/* The exact verdict from 34 products, the golden model of architecture exact: every W up
 * to 32, coplanar and degenerate triangles included, no rounding, no tolerance. coplanar
 * is true iff one plane holds all six vertices. The axis truly separates, and a pair is
 * separated iff there is one; 1 ... 9 are tried only where e_i crosses or touches B's
 * plane and f_j A's, so one that was passed over may separate, too. About 0.1 us for
 * coordinates of up to 20 bits. */
sepax_verdict sepax_exact(const sepax_tri *a, const sepax_tri *b);

/* The verdict with the clearances of `design` (arch exact, limits > 0): clearance 0 ... D LSB is
 * band COLLISION, up to the warning limit WARNING, beyond FREE. Conservative: when the real
 * triangles, every coordinate within 1/2 LSB of those given, are no farther apart than a limit
 * (Euclid), the band is never beyond it. axis: 13, 10, 11, 1 ... 9, 12 in this order, the first
 * that proves the band; 0 in band COLLISION. coplanar as of sepax_exact. docs/clearance.md has the
 * proof and false alarms. Coordinates of W bits; about 1 us. */
sepax_verdict sepax_clearance(const sepax_design *design, const sepax_tri *a, const sepax_tri *b);

/* Two more models, true iff the triangles collide: they agree with sepax_exact on every
 * pair. The reference: the separating axis theorem on 128-bit integers, axis by axis; and
 * the same theorem written out in 54 products. */
bool sepax_reference(const sepax_tri *a, const sepax_tri *b);
bool sepax_sat54(const sepax_tri *a, const sepax_tri *b);

/* Algorithm 1 on the formats of `design` (arch paper). mul_project is 36 when a
 * normal separates, else 36 + 18 per axis tried: 54 ... 144 for coplanar pairs
 * and 54 ... 198 otherwise (the paper prints 188: it takes 9 x 18 for 152). */
sepax_verdict sepax_paper(const sepax_design *design, const sepax_pair *pair);

/* The machine before it, on the same formats (arch conference): coplanarity first, then six axes
 * for coplanar pairs (table 2, the normals are not tried), eleven for others. mul_project is
 * 18 for coplanarity and 18 per axis tried: 36 ... 126 for coplanar pairs, else 36 ... 216.
 * The verdict is that of sepax_paper but where a normal separates a pair called coplanar. */
sepax_verdict sepax_conference(const sepax_design *design, const sepax_pair *pair);

/* SAT in IEEE single/double precision, normals by cross product, coplanar by
 * equality: what software usually does. Rounded: wrong now and then. */
bool sepax_float32(const sepax_tri *a, const sepax_tri *b);
bool sepax_float64(const sepax_tri *a, const sepax_tri *b);

/* The interval test (Moeller 1997) in the same precisions, without a tolerance: the usual
 * one where speed counts. Triangles without area are beyond it. */
bool sepax_interval32(const sepax_tri *a, const sepax_tri *b);
bool sepax_interval64(const sepax_tri *a, const sepax_tri *b);

/* How far a pair is from the other verdict, in LSB, rounded (relative error about 1e-9,
 * but some 1e-6 LSB at least where triangles are slivers of W > 26): a collision's depth,
 * the shortest translation that ends in mere contact (0 for contact, and for all coplanar
 * pairs); of separated triangles minus their distance. */
double sepax_depth(const sepax_tri *a, const sepax_tri *b);

/* --------------------------------------------------------------- many pairs */

/* Triangles as a structure of arrays: c[k][axis][n] is coordinate `axis` (x, y, z) of
 * vertex k of triangle n. No alignment but int32_t's is asked for. */
typedef struct {
  const int32_t *c[3][3];
} sepax_columns;

/* How a batch is computed: BEST is the fastest of those that run on this machine. All give
 * the same verdicts. */
typedef enum {
  SEPAX_PATH_BEST,
  SEPAX_PATH_PORTABLE, /* 2 pairs at once in doubles; sepax_exact where a sign is in doubt */
  SEPAX_PATH_AVX2,     /* 4 pairs at once */
  SEPAX_PATH_AVX512    /* 8 pairs at once */
} sepax_path;

bool sepax_path_runs(sepax_path path);
const char *sepax_path_name(sepax_path path); /* of BEST: the one that it is */

/* The verdicts of sepax_exact on pairs (a[n], b[n]), n < count: bit n % 64 of bits[n / 64],
 * 1 for a collision; bits of the last word behind `count` are 0. Exact for every int32_t;
 * fastest where all 64 pairs of a word have coordinates of up to 20 bits, not much slower
 * up to 25, and one by one in 128 bits beyond. Reads nothing outside of the arrays. The path must
 * run on this machine. docs/software.md. */
void sepax_exact_pairs(sepax_path path, const sepax_columns *a, const sepax_columns *b,
                       size_t count, uint64_t *bits);

/* The same of one triangle and each of b; what belongs to it alone is computed once. */
void sepax_exact_one_to_many(sepax_path path, const sepax_tri *a, const sepax_columns *b,
                             size_t count, uint64_t *bits);

/* How two meshes are searched; all zero is a good choice. */
typedef struct {
  int threads;      /* 0: as many as the machine has processors */
  bool brute_force; /* box tests of all pairs, not down a tree */
  bool first;       /* end at a pair that collides, always the same one */
  sepax_path path;
  /* Called now and then from the calling thread, total last if nothing stops it; false
   * ends the search. NULL: not called. */
  bool (*progress)(void *context, uint64_t done, uint64_t total);
  void *context;
} sepax_search;

/* pair[n]: the numbers of a triangle of A and of one of B. */
typedef struct {
  size_t (*pair)[2];
  size_t count;
} sepax_pairs;

/* All colliding pairs of triangles of A and B, exact, by i, then j. Trees of boxes over
 * leaves of 64 triangles prune; sepax_exact_one_to_many judges in the leaves. `how` may be
 * NULL. Fails without memory, or when progress ended it; free with sepax_pairs_free. */
bool sepax_colliding_pairs(const sepax_tri *a, size_t count_a, const sepax_tri *b, size_t count_b,
                           const sepax_search *how, sepax_pairs *found, sepax_error *error);
/* The same search for the pairs that sepax_clearance does not call free: `design` has clearances
 * (limits > 0), boxes are kept apart by its margin. `first` ends at such a pair. */
bool sepax_near_pairs(const sepax_design *design, const sepax_tri *a, size_t count_a,
                      const sepax_tri *b, size_t count_b, const sepax_search *how,
                      sepax_pairs *found, sepax_error *error);
void sepax_pairs_free(sepax_pairs *pairs);

/* ------------------------------------------------------------ the object engine */

/* What a run of the engine finds. */
typedef struct {
  uint64_t pairs, survivors; /* tested; of these, with boxes that meet */
  uint64_t passes;           /* of survivors through the cores; two for pairs flat along z */
  sepax_pairs found; /* collisions, and pairs in the band of warnings, in the order of the engine */
  uint64_t collisions;   /* among them */
  size_t first;          /* of found: the first collision; found.count without one */
  uint64_t out_of_range; /* of these, undecided: beyond the extents, or moved out of W bits */
  uint64_t cycles;       /* predicted, to about 1 % and 20 + 4 II cycles; less
                            well where several cores meet pairs of two passes */
} sepax_engine_run;

/* The golden model of sepax_engine, a design with lanes: triangles of A against those of B,
 * B's moved by whole LSB (|move| < 2^W). Verdicts are those of sepax_judge; a triangle of B
 * that was moved out of W bits collides with all whose boxes it meets, and is counted as out of
 * range. Fails on objects that are empty or do not fit the memories, or without memory; free
 * run->found with sepax_pairs_free. */
bool sepax_engine(const sepax_design *design, const sepax_tri *a, size_t count_a,
                  const sepax_tri *b, size_t count_b, const int32_t move[3], sepax_engine_run *run,
                  sepax_error *error);

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

/* Write a binary STL (coordinates rounded to binary32; a value that does not fit
 * is an error, and so is a facet that loses its area by rounding), or ASCII with 17
 * digits. Written aside, then renamed to path. Fails also on an empty mesh, NaN or
 * infinity, and where path is there but no file. */
bool sepax_stl_write(const sepax_mesh *mesh, const char *path, bool ascii, sepax_error *error);

/* A sample object: a closed mesh of exactly `triangles` facets in mm, refined by
 * longest-edge bisection. `at` is its centre (cutters: the tip; pocket: the middle
 * of the top face), `size` its characteristic length in mm (0: the default of the
 * shape). Fails on an unknown shape, on fewer triangles than the shape needs, on
 * more than 10^9, on an odd number (a closed mesh has an even number), and on a
 * place farther than 2^30 sizes from the origin. */
bool sepax_sample(sepax_mesh *mesh, const char *shape, size_t triangles, const double at[3],
                  double size, sepax_error *error);

/* Names, descriptions and least numbers of triangles; NULL and 0 beyond the last. */
const char *sepax_sample_name(size_t i);
const char *sepax_sample_about(size_t i);
size_t sepax_sample_least(size_t i);

/* The grid of integer coordinates: q = round((x - offset) / resolution). */
typedef struct {
  double resolution; /* file units per LSB, > 0 */
  double offset[3];  /* file units */
  int word;
} sepax_grid;

/* The finest grid of W bits on which all the meshes fit: the offset is the centre
 * of their common box, the longest side spans just under 2^W - 1 steps. Fails on a
 * mesh without facets, on no extent and on coordinates above 2^1000. */
bool sepax_grid_fit(sepax_grid *grid, const sepax_mesh *const meshes[], size_t count, int word,
                    sepax_error *error);

/* Quantise a mesh: tri[mesh->count] receives the triangles, each coordinate
 * rounded to nearest, half away from zero, exactly for the doubles given (0.009 on
 * a grid of 0.002 is 4: the double nearest 0.009 is less); normal[mesh->count], if
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

/* The least whole number of LSB that is not below a length >= 0 in file units; exact. False where
 * it is above 2^31 - 1. */
bool sepax_grid_lsb(const sepax_grid *grid, double length, int *lsb);

/* Two closed meshes of which no triangles collide: within[0] iff a connected part of A is
 * wholly inside the solid B, within[1] the same of B in A. Exact: inside is where a line that
 * leaves a vertex meets the other mesh an odd number of times, or leaves it more often than it
 * enters it (bodies that overlap), as the triangles' vertices go round. Fails on a mesh that is not
 * closed: every edge belongs to an even number of triangles. */
bool sepax_solid(const sepax_scene *scene, bool within[2], sepax_error *error);

/* Both meshes of a scene as one PLY file (binary), as they were quantised, in file units:
 * triangles that are in `pairs` red (A) and orange (B), the others pale. Written aside, then
 * renamed to path; fails where it cannot be. */
bool sepax_ply_write(const sepax_scene *scene, const sepax_pairs *pairs, const char *path,
                     sepax_error *error);

/* The pair of triangle i of A and triangle j of B. */
sepax_pair sepax_scene_pair(const sepax_scene *scene, size_t i, size_t j);

/* ----------------------------------------------------------- what a scene needs */

/* A turn by any angle about the axis through a centre that is parallel to x, y or z, or
 * about every axis through it. */
typedef enum {
  SEPAX_TURN_NONE,
  SEPAX_TURN_X,
  SEPAX_TURN_Y,
  SEPAX_TURN_Z,
  SEPAX_TURN_ANY
} sepax_turn;

/* Where a body may be: turned first, then shifted by low ... high (file units; the pose of
 * the file, no turn and no shift, is always one of them). All zero: it rests. */
typedef struct {
  double low[3], high[3];
  sepax_turn turn;
  double centre[3];
} sepax_motion;

typedef enum {
  SEPAX_WORKSPACE_NONE,  /* what the poses need */
  SEPAX_WORKSPACE_SIDES, /* a box of sides high - low about the middle of the poses */
  SEPAX_WORKSPACE_PLACED /* low ... high */
} sepax_workspace;

/* A scene beside its two meshes, lengths in file units. */
typedef struct {
  double resolution; /* per LSB, > 0 */
  bool offset_given; /* else the origin of the grid is the middle of the workspace */
  double offset[3];
  sepax_workspace workspace;
  double low[3], high[3];
  sepax_motion motion[2]; /* of A, of B */
  int poses;              /* to sample where a body moves */
  uint64_t seed;
} sepax_space;

/* What follows for every pose. extent[i] bounds each side of the box of each triangle of A,
 * of B, in LSB, however the moved body is rounded to the grid; if nothing moves and no
 * workspace was given it is the longest side itself. */
typedef struct {
  sepax_grid grid;        /* the least word length that holds all poses and the workspace */
  double low[3], high[3]; /* of all poses, file units */
  size_t count[2];
  int64_t extent[2];
  int core_word;  /* bits of a coordinate behind the box test, at most grid.word */
  uint64_t given; /* pairs of triangles whose boxes meet as the files stand: counted */
  uint64_t worst; /* the most that were counted in this and `poses` sampled poses */
  int poses;
} sepax_size;

/* Fails on no triangles, an empty range, a workspace that does not hold all poses, more than
 * 32 bits, and without memory. docs/size.md. */
bool sepax_size_scene(sepax_size *size, const sepax_mesh *a, const sepax_mesh *b,
                      const sepax_space *space, sepax_error *error);

/* Gates (GE) of architecture exact at 2 ns, by a formula fitted to mapped designs (Nangate45
 * typical), and the most that it is wrong by if this design is like those. Of an object engine
 * without its memories. The design is one that sepax_design_init made. docs/size.md. */
double sepax_gates(const sepax_design *design, double *error);

/* A machine for all pairs of a scene. */
typedef struct {
  sepax_config
      config; /* with lanes: an object engine; without: the core alone, fed with every pair */
  double gates, gates_error; /* sepax_gates */
  bool fitted;               /* the formula was fitted to machines like this one */
  uint64_t cycles; /* for all pairs, at most; of an engine with loading left out, of a core alone
                      with second passes left out */
  double seconds;
} sepax_machine;

/* The machine of the fewest gates that judges all pairs of `size` within `seconds` at a
 * period of clock_ps, `worst` pairs being left by the box test: lanes_least ... lanes_most
 * lanes (0 ... SEPAX_LANES_MAX; 0 is the core alone). Fails if none is fast enough, naming
 * the fastest. */
bool sepax_size_machine(sepax_machine *machine, const sepax_size *size, double seconds,
                        int clock_ps, int lanes_least, int lanes_most, sepax_error *error);

/* ------------------------------------------------------------- test vectors */

/* A stream of pseudo-random numbers (splitmix64): same seed, same stream. */
typedef struct {
  uint64_t state;
} sepax_random;

uint64_t sepax_random_next(sepax_random *random);
/* Uniform in lo ... hi, both included; lo <= hi. */
int64_t sepax_random_range(sepax_random *random, int64_t lo, int64_t hi);

/* Families of hard pairs, numbered from 0; NULL beyond the last. */
const char *sepax_family_name(size_t family);
const char *sepax_family_about(size_t family);

/* A random pair of a family (below the last) at W bits, normals by
 * sepax_unit_normal. */
sepax_pair sepax_family_pair(size_t family, int word, sepax_random *random);

/* The same with zero normals, several times as fast. */
sepax_pair sepax_family_triangles(size_t family, int word, sepax_random *random);

/* The same, the box of A at most extent[0] and that of B at most extent[1] LSB long (1 ...
 * 2^W - 1), many to the very LSB, anywhere in the word; or, `beyond`, one of them 1 LSB or more
 * too long where the word has room for it: always if both extents are below 2^(W-2). */
sepax_pair sepax_extent_pair(size_t family, int word, const int extent[2], bool beyond,
                             sepax_random *random);

/* Pairs as text: one line of 18 decimal integers A1x A1y A1z ... B3z, or 24 with
 * N_A and N_B behind them (computed when absent); '#' starts a comment. */
typedef enum { SEPAX_LINE_PAIR, SEPAX_LINE_EMPTY, SEPAX_LINE_ERROR } sepax_line;

/* Parse one line. Errors: not 18 or 24 integers, or one that does not fit W. */
sepax_line sepax_pair_parse(sepax_pair *pair, const char *line, int word, sepax_error *error);

/* The next pair of a stream; empty lines are skipped, a line is at most 4095 long. `number` counts
 * lines for messages (start at 0), `name` names the stream. SEPAX_LINE_EMPTY is the end; after an
 * error the stream stands behind the bad line. */
sepax_line sepax_pair_read(sepax_pair *pair, FILE *in, const char *name, size_t *number, int word,
                           sepax_error *error);

/* Print the 24 integers separated by blanks, without a newline. */
void sepax_pair_print(FILE *out, const sepax_pair *pair);

#ifdef __cplusplus
}
#endif
#endif
