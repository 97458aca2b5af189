/* SPDX-License-Identifier: MIT */
/* sepax_design.h - hardware designs: their configuration, the number formats that follow from it,
 * the golden models of their verdicts, and the search for the design that a scene needs. The
 * conventions are those of sepax.h. */
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
#define SEPAX_LEAVES_MIN 8
#define SEPAX_LEAVES_MAX 32
#define SEPAX_ROWS_MIN 64
#define SEPAX_ROWS_MAX 256
#define SEPAX_MEMORY_MAX 32768
#define SEPAX_CONFIG_TEXT 512 /* bytes, enough for every text of a configuration */

/* ----------------------------------------------------------- configuration */

typedef enum {
  SEPAX_ARCH_EXACT,      /* hardware: the exact verdict and the axis */
  SEPAX_ARCH_PAPER,      /* hardware: the paper's datapath, bit for bit */
  SEPAX_ARCH_CONFERENCE, /* hardware: the predecessor of `paper`, docs/reference/conference.md */
  SEPAX_ARCH_REFERENCE,  /* software: the exact verdict by another method (sepax_reference) */
  SEPAX_ARCH_FLOAT32,    /* software: sepax_float32 */
  SEPAX_ARCH_FLOAT64,    /* software: sepax_float64 */
  SEPAX_ARCH_INTERVAL32, /* software: sepax_interval32 */
  SEPAX_ARCH_INTERVAL64, /* software: sepax_interval64 */
  SEPAX_ARCH_GUIGUE32,   /* software: sepax_guigue32 */
  SEPAX_ARCH_GUIGUE64,   /* software: sepax_guigue64 */
  SEPAX_ARCH_FILTERED,   /* software: sepax_filtered */
  SEPAX_ARCH_COUNT
} sepax_arch;

/* How paper and conference test whether a pair is coplanar. */
typedef enum {
  SEPAX_COPLANAR_PLANE, /* |B_k.N_A - A_k.N_A| < epsilon for all k: the right test */
  SEPAX_COPLANAR_PAPER  /* |A_k.N_A - B_k.N_B| < epsilon for all k: as printed in the paper */
} sepax_coplanarity;

/* Inequality (5) of the paper, in paper and conference. */
typedef enum {
  SEPAX_INEQUALITY_CORRECT, /* max A < min B */
  SEPAX_INEQUALITY_PRINTED  /* max A > min B, as printed in the paper */
} sepax_inequality;

/* The technology that the Verilog is made for: an ASIC, with multipliers made of gates, or a family
 * of FPGAs (iCE40, ECP5, Xilinx 7, Xilinx UltraScale+, Gowin), with its built-in multipliers. */
typedef enum {
  SEPAX_TARGET_ASIC,
  SEPAX_TARGET_ICE40,
  SEPAX_TARGET_ECP5,
  SEPAX_TARGET_XC7,
  SEPAX_TARGET_XCUP,
  SEPAX_TARGET_GOWIN
} sepax_target;

/* The content of one transfer of AXI4-Stream. */
typedef enum {
  SEPAX_STREAM_NONE, /* no AXI4-Stream: the core alone */
  SEPAX_STREAM_VERTEX,
  SEPAX_STREAM_TRIANGLE,
  SEPAX_STREAM_PAIR
} sepax_stream;

/* The corner (voltage, temperature and process) of the cells for which the clock period must hold.
 */
typedef enum { SEPAX_CORNER_TYPICAL, SEPAX_CORNER_SLOW } sepax_corner;

/* The configuration of a design. The golden model, the Verilog generator and the test benches all
 * read it. "exact:" marks the fields of architecture exact, and "paper:" marks those of paper and
 * conference. */
typedef struct {
  sepax_arch arch;
  int word;         /* W, bits of a coordinate, 4 ... 32 */
  int ii;           /* initiation interval in cycles; exact: 1 ... 18; paper: 3 */
  int guard;        /* paper: keep W + guard bits of intermediates, 0 ... 2W + 3; -1: keep all */
  bool block_float; /* paper: shift the components of an axis left together before truncation */
  sepax_coplanarity coplanarity; /* paper: test of coplanarity */
  sepax_inequality inequality;   /* paper: form of inequality (5) */
  int epsilon;         /* paper: tolerance of coplanarity in LSB, 0 ... 2^(W-1) - 1; 0: equality */
  bool flag;           /* exact: call coplanar pairs collisions and flag them as undecided */
  sepax_target target; /* exact: technology */
  int clock_ps;        /* exact: clock period to pipeline for, 500 ... 1000000 ps */
  sepax_corner corner; /* exact: corner of the cells */
  int extent_a, extent_b; /* exact: longest AABB side of a triangle of A and of B, in LSB, that the
                             core decides; 0 and 0: no limit */
  bool early_out;         /* exact: put an AABB test before the core, so that the core idles for
                             pairs that the test decides; always there with extents */
  bool registered_ready;  /* exact: put a skid buffer before the core, to make in_ready a register;
                             on an FPGA it is there anyway */
  bool clock_gating;      /* exact: registers have enables and stand still without a pair */
  int clearance, warning; /* exact: distances in LSB; -1 and 0: none. A pair is called free only if
                             the real triangles are farther apart than `clearance`
                             (docs/reference/clearance.md) */
  sepax_stream stream;    /* exact: put AXI4-Stream around the core */
  int tag;                /* exact: bits of the tag that goes with a pair of the stream, 1 ... 64 */
  int lanes;              /* exact: comparator lanes of an object engine, 1 ... 64; 0: no engine */
  bool tree;              /* exact: a tree engine */
  int cores;              /* exact: cores of the engine, 1 ... 8 */
  int memory_a, memory_b; /* exact: triangles of A and of B that an object engine holds, a power of
                             two, 2^7 ... 2^15 */
  int leaves, rows;       /* exact: leaves of each body that a tree engine holds, and rows that wait
                             in it: powers of two, 8 ... 32 and 64 ... 256 */
} sepax_config;

/* The default configuration: architecture exact, W = 18, II = 3, coplanar pairs decided, 2 ns. For
 * paper and conference: all bits kept, SEPAX_COPLANAR_PLANE, SEPAX_INEQUALITY_CORRECT, epsilon 1.
 */
sepax_config sepax_config_default(void);

/* Set one value from text. `name` is the name of the command-line option without "--" ("word",
 * "early-out", ...; c_model/design/option_table.c lists them). If the default of an option is
 * "none", then the value "" sets it to none. Error: ARGUMENT on an unknown name or value. */
bool sepax_config_set(sepax_config *config, const char *name, const char *value,
                      sepax_error *error);

/* Parse a text of sepax_config_text ("--arch=paper --word=18 ..."). Options that the text does not
 * name keep their values. On failure *config is unchanged. Error: ARGUMENT. */
bool sepax_config_parse(sepax_config *config, const char *text, sepax_error *error);

/* Write the options that the architecture reads into text[size], except for options that are
 * "none": as "--arch=paper --word=18 ...", which sepax_config_parse reads, or as
 * "ARCH=paper WORD=18 ...", the variables of make. A text that does not fit is cut;
 * SEPAX_CONFIG_TEXT bytes are always enough. Both return `text`. */
char *sepax_config_text(const sepax_config *config, char *text, size_t size);
char *sepax_config_variables(const sepax_config *config, char *text, size_t size);

/* One of these options. */
typedef struct {
  const char *name; /* "early-out" */
  char value[32];   /* "boxes" */
  bool is_number;   /* `value` is a number */
} sepax_setting;
/* Option i of the list that sepax_config_text writes. False after the last one. */
bool sepax_config_setting(const sepax_config *config, size_t i, sepax_setting *setting);

/* Write the name of the design into text[size], for example "exact-w18-ii3". Values that differ
 * from their defaults follow in the name. A name that does not fit is cut. Returns `text`. */
char *sepax_config_name(const sepax_config *config, char *text, size_t size);

/* True if the configuration is supported. Otherwise the function fails with ARGUMENT: a value is
 * out of range (the text has the legal range), two options exclude each other, or the architecture
 * does not have an option. */
bool sepax_config_check(const sepax_config *config, sepax_error *error);

const char *sepax_arch_name(sepax_arch arch);

/* Number of AXI4-Stream transfers that carry one pair: 6, 2 or 1; 0 without AXI4-Stream. */
int sepax_stream_transfers(const sepax_config *config);

/* The format of a number in the datapath. In paper and conference the exact value needs `exact`
 * bits (by interval analysis). The lowest `shift` bits are dropped, which rounds down, and `width`
 * = exact - shift bits are kept. docs/reference/paper.md has the table. For architecture exact see
 * SEPAX_X_... below. */
typedef struct {
  const char *name;
  int exact, width, shift;
  int digits; /* exact on an ASIC: radix-4 digits of this factor in a multiplier; otherwise 0 */
} sepax_format;

/* The numbers of the datapaths of paper and conference. */
typedef enum {
  SEPAX_F_VERTEX,            /* coordinate */
  SEPAX_F_NORMAL,            /* component of N_A or N_B */
  SEPAX_F_NORMAL_PRODUCT,    /* coordinate times component of a normal */
  SEPAX_F_NORMAL_PROJECTION, /* vertex . normal: t_k, s_k, u_k, v_k of the paper */
  SEPAX_F_EDGE,              /* component of an edge; components of normals fit, too */
  SEPAX_F_CROSS_PRODUCT,     /* one product of a cross product */
  SEPAX_F_AXIS,              /* component of an axis */
  SEPAX_F_PRODUCT,           /* coordinate times component of an axis */
  SEPAX_F_PROJECTION,        /* vertex . axis */
  SEPAX_F_COUNT
} sepax_format_id;

/* The numbers of the datapath of exact (docs/reference/exact.md). `exact` bits would hold every
 * term. `width` bits hold the result, because sums are taken modulo 2^width and terms cancel.
 * `shift` is 0. */
enum {
  SEPAX_X_COORDINATE,
  SEPAX_X_SPAN,      /* sum or difference of two coordinates */
  SEPAX_X_ORIENT2D,  /* t_ij and g_ijk: twice an area */
  SEPAX_X_Z_SUM,     /* sum of z coordinates of both triangles, on an ASIC plus BIAS = 1 + 4 + 16
                        + ..., which the biased multiplier subtracts again */
  SEPAX_X_OWN_Z_SUM, /* the same sum for three vertices of B */
  SEPAX_X_ORIENT3D,  /* h_ijk, s_k, w_i and d_ij: six times a volume */
  SEPAX_X_STEP,      /* difference of two y coordinates that chooses the projection, on an ASIC plus
                        BIAS */
  SEPAX_X_CROSS,     /* with a clearance: component of e x f, N_A or N_B */
  SEPAX_X_LIMIT,     /* with a clearance: twice the gap on such an axis must exceed this number */
  SEPAX_X_EDGE_LIMIT, /* the same for an axis that is normal to an edge and to x, y or z */
  SEPAX_X_COUNT
};

/* A checked configuration and what follows from it. */
typedef struct {
  sepax_config config;
  sepax_format format[SEPAX_F_COUNT];       /* paper: by sepax_format_id */
  sepax_format exact_format[SEPAX_X_COUNT]; /* exact: by SEPAX_X_... */
  int formats;                              /* entries of `format` or of `exact_format` */
  bool aabb_test;                           /* exact: there is an AABB test before the core */
  int core_word;          /* exact: bits of a coordinate after the AABB test; W without extents */
  int64_t coplanar_limit; /* paper: a pair is coplanar if |difference| is below this number, in
                             units of SEPAX_F_NORMAL_PROJECTION */
  int latency;            /* cycles from the first input word to the verdict; for exact 0, because
                             only the generator's schedule decides it */
  int wait; /* for exact set by the generator: cycles for which a stage before the core may keep a
               pair until the II window ends; 0: every pair has the latency */
  bool ripple;       /* for exact set by the generator: the clock has time for adders that are
                        chains of full adders */
  int limits;        /* number of clearances: 0, 1 (clearance) or 2 (and warning) */
  int64_t margin[2]; /* gaps of AABBs in LSB, 0 without clearances. If the gap is above
                        margin[0] = 1 + clearance, then the pair is not in band COLLISION. If
                        it is above margin[1] = 1 + the larger clearance, then the pair is in
                        band FREE. A tree engine adds to both:
                        docs/reference/tree-engine.md */
} sepax_design;

/* Check a configuration and derive all other fields of *design. Error: ARGUMENT as for
 * sepax_config_check. */
bool sepax_design_init(sepax_design *design, const sepax_config *config, sepax_error *error);

/* ---------------------------------------------------------- golden models */

/* The verdict of `design` on a pair, the same bits as its Verilog gives. The components of the pair
 * must fit W bits; sepax_pair_fits checks it. Only paper and conference read the normals and count
 * multiplications.
 *
 * Architecture exact gives the verdict of sepax_exact, or of sepax_clearance if limits > 0. There
 * are two exceptions. A design that flags coplanar pairs calls them collisions with
 * SEPAX_AXIS_NONE. If the design has an AABB test, then the test decides first (SEPAX_AXIS_AABB,
 * SEPAX_AXIS_EXTENT). */
sepax_judgement sepax_judge(const sepax_design *design, const sepax_pair *pair);

/* The verdict with the clearances of `design` (architecture exact, limits > 0). The band is
 * COLLISION within the clearance, WARNING between the clearance and the warning distance, and FREE
 * beyond both.
 *
 * The band errs on one side only. Each coordinate of a real triangle may differ by 1/2 LSB from the
 * coordinate given. If the Euclidean distance of the real triangles is at most a limit, then the
 * band never says that it is more. docs/reference/clearance.md has the proof and the rate of false
 * alarms.
 *
 * `axis` is the first axis in the order 13, 10, 11, 1 ... 9, 12 that proves the band. In band
 * COLLISION it is SEPAX_AXIS_NONE. `coplanar` is as for sepax_exact. Coordinates have W bits. Cost:
 * about 1 us. */
sepax_judgement sepax_clearance(const sepax_design *design, const sepax_tri *a, const sepax_tri *b);

/* The same verdict with the true lengths of the axes, in software only. The hardware replaces each
 * length by a bound that is up to 22 % larger. So sepax_clearance never calls a pair free that this
 * function does not call free. At a clearance of a few LSB it calls hardly fewer pairs free, and at
 * 1000 LSB far fewer. */
sepax_judgement sepax_clearance_tight(const sepax_design *design, const sepax_tri *a,
                                      const sepax_tri *b);

/* Algorithm 1 of the paper in the formats of `design` (architecture paper). mul_project is 36 if a
 * normal separates. Otherwise it is 36 + 18 for each axis tried: 54 ... 144 for coplanar pairs and
 * 54 ... 198 for others. The paper prints 188 because it takes 9 x 18 for 152. */
sepax_judgement sepax_paper(const sepax_design *design, const sepax_pair *pair);

/* The predecessor of `paper` in the same formats (architecture conference). It first tests
 * coplanarity. Then it tries six axes for coplanar pairs (table 2; the normals are not tried) and
 * eleven axes for others. mul_project is 18 for coplanarity and 18 for each axis tried: 36 ... 126
 * for coplanar pairs and 36 ... 216 for others. The verdict differs from that of sepax_paper only
 * if a normal separates a pair that is called coplanar. */
sepax_judgement sepax_conference(const sepax_design *design, const sepax_pair *pair);

/* Like sepax_colliding_pairs, but it finds all pairs that are not in band FREE. The band is that of
 * sepax_clearance, or of sepax_clearance_tight if `tight` is true. `design` must have clearances
 * (limits > 0). */
bool sepax_near_pairs(const sepax_design *design, bool tight, const sepax_tri *a, size_t count_a,
                      const sepax_tri *b, size_t count_b, const sepax_search *how,
                      sepax_pairs *found, sepax_error *error);

/* ------------------------------------------------------------ the object engine */

/* The result of a run of the object engine. */
typedef struct {
  uint64_t pairs, candidates; /* pairs whose AABBs were compared; pairs whose AABBs overlap or, with
                                 a clearance, are within the margin */
  sepax_pairs found;          /* collisions and pairs in band WARNING, in the order of the engine */
  uint64_t collisions;        /* number of collisions in `found` */
  size_t first;          /* index of the first collision in `found`; found.count if there is none */
  uint64_t out_of_range; /* undecided pairs in `found`: beyond an extent, or B left the W bits */
  uint64_t cycles;       /* predicted cycles, right to about 1 % plus 20 + 4 II cycles, to 10 %
                            where candidates come in bursts */
} sepax_object_run;

/* The golden model of the object engine (a design with lanes). It judges all triangles of A against
 * all triangles of B, which is moved by move[3] LSB (|move[i]| < 2^W). Verdicts are those of
 * sepax_judge. A triangle of B that the move takes out of W bits counts as out of range: it
 * collides with every triangle whose AABB overlaps its own. Free run->found with sepax_pairs_free.
 * Errors: ARGUMENT if an object is empty or does not fit its memory; MEMORY. */
bool sepax_object_engine(const sepax_design *design, const sepax_tri *a, size_t count_a,
                         const sepax_tri *b, size_t count_b, const int32_t move[3],
                         sepax_object_run *run, sepax_error *error);

/* ----------------------------------------------------------- what a scene needs */

/* The rotations that a body may take, by any angle: none, about the axis through the centre
 * parallel to x, y or z, or about every axis through the centre. */
typedef enum {
  SEPAX_ROTATION_NONE,
  SEPAX_ROTATION_X,
  SEPAX_ROTATION_Y,
  SEPAX_ROTATION_Z,
  SEPAX_ROTATION_ANY
} sepax_rotation;

/* The poses of a body. The body is first rotated about `centre`, then shifted by a vector between
 * `low` and `high` (in units of the file). The pose of the file, without rotation and shift, always
 * belongs to the poses. If all fields are zero, then the body does not move. */
typedef struct {
  double low[3], high[3];
  sepax_rotation rotation;
  double centre[3];
} sepax_motion;

/* The cuboid that the grid must cover. */
typedef enum {
  SEPAX_WORKSPACE_NONE,  /* the AABB of all poses */
  SEPAX_WORKSPACE_SIDES, /* a cuboid with the sides high - low around the middle of all poses */
  SEPAX_WORKSPACE_PLACED /* the cuboid low ... high */
} sepax_workspace;

/* What is known of a scene besides its two meshes. Lengths are in units of the files. */
typedef struct {
  double resolution; /* length of 1 LSB, > 0 */
  bool offset_given; /* if false, the origin of the grid is the middle of the workspace */
  double offset[3];  /* origin of the grid */
  sepax_workspace workspace;
  double low[3], high[3];  /* of the workspace */
  sepax_motion motion[2];  /* of A and of B; not read with a path */
  int poses;               /* number of random poses to sample if a body moves */
  uint64_t seed;           /* of the random poses */
  const sepax_poses *path; /* all poses of B, while A does not move; NULL: no path */
  uint64_t pairs_most; /* on a path with more pairs of triangles, workloads are not computed; 0: no
                          limit */
  bool limited;        /* the designs have the clearances below */
  int clearance, warning; /* LSB, as in sepax_config */
} sepax_space;

/* The work that one pose gives a design. */
typedef struct {
  size_t candidates;        /* pairs of triangles whose AABBs overlap */
  uint32_t (*candidate)[2]; /* their triangles of A and of B */
} sepax_workload;

/* What a scene needs in all its poses. extent[0] bounds each side of the AABB of each triangle of
 * A, in LSB, in every pose and for every rounding of the moved body to the grid; extent[1] does so
 * for B. If no body moves and no workspace was given, then extent[i] is the longest side itself. */
typedef struct {
  sepax_grid grid;        /* of the least word length that holds all poses and the workspace */
  double low[3], high[3]; /* AABB of all poses, in units of the files */
  size_t count[2];        /* triangles of A and of B */
  int64_t extent[2];
  int core_word;  /* bits of a coordinate after the AABB test, at most grid.word */
  uint64_t given; /* candidates in the pose of the files, or in the first pose of the path */
  uint64_t worst; /* the largest number of candidates in a pose that was examined. If poses were
                     sampled, then other poses may have more */
  int poses;      /* number of sampled poses */
  sepax_workload *workload; /* of the pose of the files and each sampled pose, or of each pose of
                               the path */
  size_t workloads;
  size_t path;                    /* poses of the path; 0 without a path */
  const unsigned char *absent;    /* absent[n] is not 0 if the two bodies are not compared in pose n
                                     of the path. The caller may set it, and frees it. NULL: they
                                     are compared in each pose */
  struct sepax_size_trees *trees; /* what a tree engine reads on the path; NULL if there is no path
                                     or if W is above 21 */
  bool limited;                   /* this and the next two: as in sepax_space */
  int clearance, warning;
} sepax_size;

/* Find what a scene needs. Free *size with sepax_size_free. docs/reference/size.md explains it. The
 * function fails if a mesh has no triangles or 2^32 or more, if a range is empty, if the workspace
 * does not hold all poses, if more than 32 bits are needed, if a tree engine cannot take the path
 * (sepax_tree_pose_make), or if there is no memory. */
bool sepax_size_scene(sepax_size *size, const sepax_soup *a, const sepax_soup *b,
                      const sepax_space *space, sepax_error *error);
void sepax_size_free(sepax_size *size);

/* An estimate of the gates, in gate equivalents (GE), of a design of architecture exact at 2 ns,
 * without the memories of an engine. The formula is fitted to designs that were mapped to the cells
 * of Nangate45 (typical corner). *error is the largest error, in GE, of the formula on such
 * designs. sepax_design_init has filled in the design. docs/reference/size.md has the formula. */
double sepax_gates(const sepax_design *design, double *error);

/* Bits of the memories of an engine; 0 for a core without an engine. */
uint64_t sepax_memory_bits(const sepax_config *config);

/* The designs among which a search looks for the smallest. */
typedef struct {
  double seconds;              /* time that a pose may take */
  int clock_ps;                /* clock period, ps */
  int lanes_least, lanes_most; /* lanes of object engines, 0 ... SEPAX_LANES_MAX; 0 means the core
                                  without an engine; least > most: neither */
  bool tree;                   /* also tree engines, if the scene has a path */
  bool first;                  /* tree engines end a pose at its first collision */
  int latency;                 /* cycles of a tree engine's memory; 0: SEPAX_TREE_LATENCY */
  /* Asked of a design that is fast enough. False, with error ARGUMENT, if it cannot be made for the
   * clock: then neither can one with other lanes or cores. The function may replace the gates and
   * their error by better ones. NULL: every design can be made. */
  bool (*plan)(const sepax_design *design, double *gates, double *gates_error, sepax_error *error);
} sepax_size_request;

/* The smallest design that is fast enough for a scene. */
typedef struct {
  sepax_config config;       /* with lanes an object engine, with tree a tree engine; otherwise the
                                core without an engine, to which every pair is given */
  double gates, gates_error; /* as from sepax_gates, or from the `plan` of the request */
  bool fitted;               /* the formula of sepax_gates was fitted to designs like this one */
  uint64_t cycles; /* of the slowest pose in sepax_size. If poses were sampled, then other poses may
                      take more. The golden models predict the cycles: sepax_object_engine to about
                      1 %, sepax_tree_run.cycles with cold caches. The latency of a core is left
                      out. On a path an object engine loads the objects for each pose, 3 cycles for
                      each triangle (docs/reference/object-engine.md, Motion); otherwise loading is
                      left out */
  double mean;     /* mean cycles of a pose */
  size_t worst;    /* number of the slowest pose */
  double seconds;  /* time of the slowest pose */
} sepax_sized_design;

/* The design with the fewest gates (sepax_gates) that judges all pairs of `size` within the time in
 * each of its poses. The search covers the engines of the request, all numbers of cores, and every
 * II for which gates are known. Object engines and cores are tried with and without extents.
 *
 * The function fails with the error of the smallest design if `plan` refuses all that are fast
 * enough; *sized then has the cycles of this design. It fails with NONE_FITS if no design is fast
 * enough. The error then names the time of the fastest design, or a time that no design can beat,
 * and *sized has this time in `cycles` and `seconds`. After other errors *sized is 0. */
bool sepax_size_design(sepax_sized_design *sized, const sepax_size *size,
                       const sepax_size_request *request, sepax_error *error);

/* The same for several pairs of bodies on one path: size[n] is the size of pair n, 0 <= n < pairs.
 * A pose runs all pairs one after the other, so its cycles are the sum over the pairs. A tree
 * engine adds 40 cycles and one memory latency for each pair, and one more memory latency for the
 * whole list. All sizes must have the same number of poses, the same clearances and the same
 * resolution. Either all sizes have workloads or none has. The same holds for trees. */
bool sepax_size_pairs(sepax_sized_design *sized, const sepax_size *size, size_t pairs,
                      const sepax_size_request *request, sepax_error *error);

/* The cycles that one pair of bodies takes in pose `pose` on the design `config`. Errors: ARGUMENT
 * if they are not known for this design; MEMORY. */
bool sepax_size_cycles(uint64_t *cycles, const sepax_size *size, const sepax_config *config,
                       size_t pose, const sepax_size_request *request, sepax_error *error);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif
#endif
