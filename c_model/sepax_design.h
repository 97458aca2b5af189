/* sepax_design.h - designs: their configuration, what follows from it, the golden models of their
 * verdicts, and the design that a scene needs. The conventions are those of sepax.h. */
#ifndef SEPAX_DESIGN_H
#define SEPAX_DESIGN_H

#include "sepax_models.h"

#ifdef __cplusplus
extern "C" {
#endif
#ifdef __GNUC__
#pragma GCC visibility push(default)
#endif

#define SEPAX_II_MAX 18
#define SEPAX_LANES_MAX 64
#define SEPAX_CORES_MAX 8
#define SEPAX_MEMORY_MIN 128
#define SEPAX_MEMORY_MAX 32768
#define SEPAX_CONFIG_TEXT 512 /* bytes that hold every text of a configuration */

/* ----------------------------------------------------------- configuration */

typedef enum {
  SEPAX_ARCH_EXACT,      /* the mathematical verdict, and the axis */
  SEPAX_ARCH_PAPER,      /* the paper's datapath, bit for bit */
  SEPAX_ARCH_CONFERENCE, /* the design that the paper improves on, docs/reference/conference.md */
  SEPAX_ARCH_REFERENCE,  /* software: the same verdict by another method, sepax_reference */
  SEPAX_ARCH_FLOAT32,    /* software baseline in IEEE single precision */
  SEPAX_ARCH_FLOAT64,    /* software baseline in IEEE double precision */
  SEPAX_ARCH_INTERVAL32, /* the interval test of Moeller, the usual one, single precision */
  SEPAX_ARCH_INTERVAL64, /* the same in double precision */
  SEPAX_ARCH_GUIGUE32,   /* the test of Guigue and Devillers by orientations, single precision */
  SEPAX_ARCH_GUIGUE64,   /* the same in double precision */
  SEPAX_ARCH_FILTERED,   /* the same with a bound on each sign, exact where one is in doubt */
  SEPAX_ARCH_COUNT
} sepax_arch;

typedef enum {
  SEPAX_COPLANAR_PLANE, /* |B_k.N_A - A_k.N_A| < epsilon for all k: right */
  SEPAX_COPLANAR_PAPER  /* |A_k.N_A - B_k.N_B| < epsilon for all k: printed */
} sepax_coplanarity;

typedef enum {
  SEPAX_INEQUALITY_CORRECT, /* (5) as max A < min B */
  SEPAX_INEQUALITY_PRINTED  /* (5) as printed: max A > min B */
} sepax_inequality;

/* What the Verilog is made for: cells of an ASIC, whose multipliers are made of gates, or a family
 * of FPGAs: iCE40, ECP5, Xilinx 7, Xilinx UltraScale+, Gowin. */
typedef enum {
  SEPAX_TARGET_ASIC,
  SEPAX_TARGET_ICE40,
  SEPAX_TARGET_ECP5,
  SEPAX_TARGET_XC7,
  SEPAX_TARGET_XCUP,
  SEPAX_TARGET_GOWIN
} sepax_target;

/* What a transfer of AXI4-Stream has. */
typedef enum {
  SEPAX_STREAM_NONE, /* no AXI4-Stream: the core alone */
  SEPAX_STREAM_VERTEX,
  SEPAX_STREAM_TRIANGLE,
  SEPAX_STREAM_PAIR
} sepax_stream;

/* Of the cells that the clock period is for. */
typedef enum { SEPAX_CORNER_TYPICAL, SEPAX_CORNER_SLOW } sepax_corner;

/* What model, generator and benches must agree on, and all they share. */
typedef struct {
  sepax_arch arch;
  int word;         /* W, 4 ... 32 */
  int ii;           /* initiation interval, cycles; exact: 1 ... 18, paper and conference: 3 */
  int guard;        /* W + guard bits of every intermediate are kept, 0 ... 2W + 3; -1: all */
  bool block_float; /* axes shifted left in common before truncation */
  sepax_coplanarity coplanarity;
  sepax_inequality inequality;
  int epsilon;            /* LSB, 0 ... 2^(W-1) - 1; 0 asks for equality */
  bool flag;              /* exact: coplanar pairs are called collisions, undecided */
  sepax_target target;    /* exact: what the Verilog is made for */
  int clock_ps;           /* exact: the period to pipeline for, 500 ... 20000 ps */
  sepax_corner corner;    /* exact: at which corner of the cells */
  int extent_a, extent_b; /* exact: the longest side of the AABB of a triangle of A, of B, in LSB,
                             that the core decides; 0, 0: any */
  bool early_out;         /* exact: an AABB test goes before the core, whose operands are then zero
                             for pairs that the test decides; with extents there is one anyway */
  bool registered_ready;  /* exact: a skid buffer before the core; in_ready is a register */
  bool clock_gating;      /* exact: registers move only with a pair */
  int clearance, warning; /* exact: LSB; -1 and 0: none. The verdict is free only if the real
                             triangles are farther from each other than `clearance`
                             (docs/reference/clearance.md) */
  sepax_stream stream;    /* exact: AXI4-Stream around the core */
  int tag;                /* bits of a tag that travels with a pair of the stream, 1 ... 64 */
  int lanes;              /* exact: comparator lanes of an object engine, 1 ... 64; 0: none */
  bool tree;              /* exact: a tree engine */
  int cores;              /* of the engine, 1 ... 8 */
  int memory_a, memory_b; /* triangles of A, of B that it holds: 2^7 ... 2^15 */
} sepax_config;

/* The defaults: exact, W = 18, II = 3, coplanar pairs decided, 2 ns; and for paper and
 * conference full, plane, correct, epsilon 1. */
sepax_config sepax_config_default(void);

/* Set one value from text, by the name of its command-line option ("word", "early-out", ...;
 * c_model/design/options.c has the table). "" is none where none is the default. Fails on an
 * unknown name or value. */
bool sepax_config_set(sepax_config *config, const char *name, const char *value,
                      sepax_error *error);

/* Parse a line that sepax_config_text wrote ("--arch=paper --word=18 ..."). */
bool sepax_config_parse(sepax_config *config, const char *text, sepax_error *error);

/* The options that the architecture reads, without those that are "none", into text[size], cut
 * where it does not fit: as "--arch=paper --word=18 ...", which sepax_config_parse reads back, or
 * as "ARCH=paper WORD=18 ...", the variables of make. Both return text. */
char *sepax_config_text(const sepax_config *config, char *text, size_t size);
char *sepax_config_variables(const sepax_config *config, char *text, size_t size);

/* The same, one at a time. */
typedef struct {
  const char *name; /* "early-out" */
  char value[32];   /* "boxes" */
  bool is_number;   /* value is one */
} sepax_setting;
/* Setting i of `config`; false behind the last. */
bool sepax_config_setting(const sepax_config *config, size_t i, sepax_setting *setting);

/* The name of the design, "exact-w18-ii3", into text[size], cut where it does not fit: what is
 * not the default follows. Returns text. */
char *sepax_config_name(const sepax_config *config, char *text, size_t size);

/* Fails with the legal range if a value or a combination is not supported, and if a
 * choice is made that the architecture does not have. */
bool sepax_config_check(const sepax_config *config, sepax_error *error);

const char *sepax_arch_name(sepax_arch arch);

/* Transfers of AXI4-Stream that are a pair: 6, 2 or 1; 0 without. */
int sepax_stream_transfers(const sepax_config *config);

/* The format of a number of the datapath. In paper and conference the exact value needs `exact`
 * bits (interval analysis); the lowest `shift` of them are dropped by flooring, `width` = exact -
 * shift are kept (docs/reference/paper.md has the table). In exact see SEPAX_X_... below. */
typedef struct {
  const char *name;
  int exact, width, shift;
  int digits; /* exact, ASIC: how many radix-4 digits a multiplier cuts this factor into; else 0 */
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

/* Formats of architecture exact (docs/reference/exact.md): `exact` bits would hold every term,
 * `width` bits hold the result, as sums that cancel are taken modulo 2^width. shift is 0. */
enum {
  SEPAX_X_COORDINATE,
  SEPAX_X_SPAN,       /* sum or difference of two coordinates */
  SEPAX_X_ORIENT2D,   /* t_ij, g_ijk: twice an area */
  SEPAX_X_Z_SUM,      /* z sum of vertices of both triangles, plus BIAS = 1 + 4 + 16 ..., which the
                         biased multiplier deducts; on FPGAs without */
  SEPAX_X_OWN_Z_SUM,  /* the same of B's own vertices */
  SEPAX_X_ORIENT3D,   /* h_ijk, s_k, w_i, d_ij: six times a volume */
  SEPAX_X_CROSS,      /* with a clearance: a component of e x f, N_A, N_B */
  SEPAX_X_LIMIT,      /* with a clearance: what twice a gap on such an axis must exceed */
  SEPAX_X_EDGE_LIMIT, /* the same on an axis that is normal to an edge and to x, y or z */
  SEPAX_X_COUNT
};

/* A checked configuration with what follows from it. */
typedef struct {
  sepax_config config;
  sepax_format format[SEPAX_F_COUNT];       /* of paper and conference, by sepax_format_id */
  sepax_format exact_format[SEPAX_X_COUNT]; /* of exact, by SEPAX_X_... */
  int formats;                              /* entries of format, or of exact_format */
  bool aabb_test;                           /* exact: an AABB test goes before the core */
  int core_word;          /* exact: bits of a coordinate behind the AABB test; W without extents */
  int64_t coplanar_limit; /* |difference| < limit, in units of NORMAL_PROJECTION */
  int latency;            /* cycles from the first input word to the verdict; of exact 0 until the
                             generator has made the schedule */
  int limits;             /* clearances asked for, 0 ... 2 */
  int64_t margin[2];      /* of AABBs: with a gap above margin[0] = 1 + clearance a pair is not in
                             band COLLISION, above margin[1] = 1 + the outermost clearance it is
                             in band FREE; a tree engine adds to both
                             (docs/reference/tree-engine.md); 0 without clearances */
} sepax_design;

/* Check the configuration and derive formats, limit and latency. */
bool sepax_design_init(sepax_design *design, const sepax_config *config, sepax_error *error);

/* ---------------------------------------------------------- golden models */

/* The verdict of the architecture of `design`, bit for bit what its RTL gives. The pair has
 * components of W bits (the caller checks, sepax_pair_fits). Only `paper` and `conference` read the
 * normals and count multiplications. Architecture `exact` gives the verdict of sepax_exact, or that
 * of sepax_clearance if limits > 0; with two exceptions: a design that flags coplanar pairs calls
 * them collisions, SEPAX_AXIS_NONE; and an AABB test, where there is one, decides first
 * (SEPAX_AXIS_AABB, SEPAX_AXIS_EXTENT). */
sepax_judgement sepax_judge(const sepax_design *design, const sepax_pair *pair);

/* The verdict with the clearances of `design` (arch exact, limits > 0): band COLLISION within the
 * clearance, WARNING between the clearance and the warning limit, FREE beyond both. It is
 * conservative: if the real triangles, each coordinate of which is within 1/2 LSB of the one given,
 * are within a limit of each other (Euclidean distance), the band never says that they are not.
 * axis is the first in the order 13, 10, 11, 1 ... 9, 12 that proves the band, SEPAX_AXIS_NONE in
 * band COLLISION. coplanar is that of sepax_exact. docs/reference/clearance.md has the proof and
 * the rate of false alarms. Coordinates of W bits; about 1 us. */
sepax_judgement sepax_clearance(const sepax_design *design, const sepax_tri *a, const sepax_tri *b);

/* The same on the same axes, but by their true lengths: all that these axes can prove. The
 * hardware bounds each length from above, by up to 22 %, so sepax_clearance never calls more pairs
 * free; at a clearance of a few LSB hardly fewer, at 1000 LSB far fewer. In software only: no
 * design has it. */
sepax_judgement sepax_clearance_tight(const sepax_design *design, const sepax_tri *a,
                                      const sepax_tri *b);

/* Algorithm 1 on the formats of `design` (arch paper). mul_project is 36 when a
 * normal separates, else 36 + 18 per axis tried: 54 ... 144 for coplanar pairs
 * and 54 ... 198 otherwise (the paper prints 188: it takes 9 x 18 for 152). */
sepax_judgement sepax_paper(const sepax_design *design, const sepax_pair *pair);

/* The predecessor of `paper`, on the same formats (arch conference): coplanarity first, then six
 * axes for coplanar pairs (table 2, the normals are not tried), eleven for others. mul_project is
 * 18 for coplanarity and 18 per axis tried: 36 ... 126 for coplanar pairs, else 36 ... 216.
 * The verdict is that of sepax_paper but where a normal separates a pair called coplanar. */
sepax_judgement sepax_conference(const sepax_design *design, const sepax_pair *pair);

/* As sepax_colliding_pairs, but for the pairs that sepax_clearance, or if `tight`
 * sepax_clearance_tight, does not call free. `design` has clearances (limits > 0), and AABBs within
 * its margin[1] count as overlapping. `first` ends the search at such a pair. */
bool sepax_near_pairs(const sepax_design *design, bool tight, const sepax_tri *a, size_t count_a,
                      const sepax_tri *b, size_t count_b, const sepax_search *how,
                      sepax_pairs *found, sepax_error *error);

/* ------------------------------------------------------------ the object engine */

/* What a run of the engine finds. */
typedef struct {
  uint64_t pairs, candidates; /* tested; of these, with AABBs that overlap (or are in the margin) */
  uint64_t passes;            /* of candidates through the cores; two for pairs flat as seen along
                                 the thinnest side of A's AABB */
  sepax_pairs found;     /* collisions, and pairs in band WARNING, in the order of the engine */
  uint64_t collisions;   /* among found */
  size_t first;          /* index in found of the first collision; found.count without one */
  uint64_t out_of_range; /* among found, undecided: an extent is exceeded, or B is out of W bits */
  uint64_t cycles;       /* predicted, to about 1 % and 20 + 4 II cycles; a pair of two passes may
                            take up to II more, as it holds up the verdicts behind it */
} sepax_object_run;

/* The golden model of the object engine, a design with lanes: all triangles of A against those of
 * B, which is moved by whole LSB (|move| < 2^W). Verdicts are those of sepax_judge. A triangle of B
 * that was moved out of W bits collides with every triangle whose AABB overlaps its own, and counts
 * as out of range. Fails on objects that are empty or do not fit the memories of the design, and
 * without memory. Free run->found with sepax_pairs_free. */
bool sepax_object_engine(const sepax_design *design, const sepax_tri *a, size_t count_a,
                         const sepax_tri *b, size_t count_b, const int32_t move[3],
                         sepax_object_run *run, sepax_error *error);

/* ----------------------------------------------------------- what a scene needs */

/* A rotation by any angle about the axis through a centre that is parallel to x, y or z, or about
 * every axis through the centre. */
typedef enum {
  SEPAX_ROTATION_NONE,
  SEPAX_ROTATION_X,
  SEPAX_ROTATION_Y,
  SEPAX_ROTATION_Z,
  SEPAX_ROTATION_ANY
} sepax_rotation;

/* The poses of a body: rotated first, then shifted by low ... high (file units). The pose of the
 * file, without rotation and shift, is always one of them. All zero: the body does not move. */
typedef struct {
  double low[3], high[3];
  sepax_rotation rotation;
  double centre[3];
} sepax_motion;

typedef enum {
  SEPAX_WORKSPACE_NONE,  /* what the poses need */
  SEPAX_WORKSPACE_SIDES, /* a cuboid of sides high - low about the middle of the poses */
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
  const sepax_poses *path; /* the poses of B, all there are; A stands, `motion` is not read. NULL:
                              none */
  uint64_t
      pairs_most; /* of a path with more pairs of triangles no workloads are found; 0: of any */
  bool limited;   /* designs have these clearances, LSB, as sepax_config has them */
  int clearance, warning;
} sepax_space;

/* What one pose gives a design to do. */
typedef struct {
  uint64_t candidates; /* pairs of triangles with overlapping AABBs */
  uint32_t (*pass)[2]; /* the numbers of their triangles of A and of B; a pair that is flat as seen
                          along the thinnest side of A's AABB goes through a core of an engine
                          twice, and is here twice */
  size_t passes;       /* in `pass` */
  uint64_t twice; /* of all pairs, those that go through a core alone twice without an AABB test:
                     flat as seen along z */
  uint64_t twice_near; /* of these, the candidates */
} sepax_workload;

/* What follows for every pose. extent[i] bounds each side of the AABB of each triangle of A, of B,
 * in LSB, in every pose and for every rounding of the moved body to the grid. If nothing moves and
 * no workspace was given, it is the longest side itself. */
typedef struct {
  sepax_grid grid;        /* the least word length that holds all poses and the workspace */
  double low[3], high[3]; /* of all poses, file units */
  size_t count[2];
  int64_t extent[2];
  int core_word;  /* bits of a coordinate behind the AABB test, at most grid.word */
  uint64_t given; /* pairs of triangles with overlapping AABBs in the pose of the files, or the
                     first of the path, counted */
  uint64_t worst; /* the most that were counted in any pose; where poses are sampled, no bound */
  int poses;      /* that were sampled */
  sepax_workload
      *workload; /* of the pose of the files and of each sampled one, or of each of the path */
  size_t workloads;
  size_t path; /* poses of the path, 0 without one */
  struct sepax_size_trees
      *trees;   /* of a path: what a tree engine reads; NULL: none, as W is above 21 */
  bool limited; /* as the space has them */
  int clearance, warning;
} sepax_size;

/* Fails on no triangles, 2^32 or more, an empty range, a workspace that does not hold all poses,
 * more than 32 bits, a path that a tree engine cannot be given (sepax_tree_pose_make), and without
 * memory. Free *size with sepax_size_free. docs/reference/size.md. */
bool sepax_size_scene(sepax_size *size, const sepax_soup *a, const sepax_soup *b,
                      const sepax_space *space, sepax_error *error);
void sepax_size_free(sepax_size *size);

/* Gates (GE) of architecture exact at 2 ns, by a formula fitted to mapped designs (Nangate45
 * typical); *error is the largest error of the formula if this design is like those. An engine is
 * counted without its memories. The design is one that sepax_design_init made.
 * docs/reference/size.md. */
double sepax_gates(const sepax_design *design, double *error);

/* Bits of the memories of an engine, 0 of a core alone. */
uint64_t sepax_memory_bits(const sepax_config *config);

/* Which designs are looked at. */
typedef struct {
  double seconds; /* that a pose may take */
  int clock_ps;
  int lanes_least, lanes_most; /* 0 ... SEPAX_LANES_MAX; 0 is the core alone; least > most: none */
  bool tree;                   /* tree engines, too, if the size is that of a path */
  bool first;                  /* they end a pose at its first collision */
  int latency;                 /* of their memory, cycles; 0: SEPAX_TREE_LATENCY */
} sepax_size_request;

/* A design for all pairs of a scene. */
typedef struct {
  sepax_config config; /* with lanes: an object engine; with tree: a tree engine; else the core
                          alone, given every pair */
  double gates, gates_error; /* sepax_gates */
  bool fitted;               /* the formula was fitted to designs like this one */
  uint64_t
      cycles;   /* in the pose that takes the most of those of `size`: where poses were sampled
                   no bound. As predicted by the golden models (sepax_object_engine, to about 1
                   %; of a tree engine sepax_tree_run.cycles, with cold caches), without the
                   latency of a core. On a path an object engine loads the objects anew, 3 cycles
                   a triangle (docs/reference/object-engine.md, Motion); else loading is left out */
  double mean;  /* cycles a pose */
  size_t worst; /* number of the pose that takes `cycles` */
  double seconds;
} sepax_sized_design;

/* The design of the fewest gates (sepax_gates) that judges all pairs of `size` within the time in
 * each of its poses: of all that the request names, any number of cores, any II that gates are
 * known for, and, but for tree engines, with or without extents. Fails without memory, and if none
 * is fast enough: then the error names the time of the fastest, or one that none is below, and
 * cycles and seconds of *sized are that, else 0. */
bool sepax_size_design(sepax_sized_design *sized, const sepax_size *size,
                       const sepax_size_request *request, sepax_error *error);

/* The same of several pairs of bodies, one size each, on one path: a pose is that of all pairs, one
 * after the other, and as many cycles as these take; with a tree engine 40 more each, and as often
 * and once more the latency of the memory, for what is between the jobs of a list. Sizes have
 * poses, clearances and resolution alike; workloads or trees that one has not none has. */
bool sepax_size_pairs(sepax_sized_design *sized, const sepax_size *size, size_t pairs,
                      const sepax_size_request *request, sepax_error *error);

/* The cycles that pair `pair` of these takes in a pose of a design, alone. */
bool sepax_size_cycles(uint64_t *cycles, const sepax_size *size, const sepax_config *config,
                       size_t pose, const sepax_size_request *request, sepax_error *error);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif
#endif
