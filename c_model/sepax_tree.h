/* sepax_tree.h - trees of triangles in the memory format of the tree engine, poses in fixed point,
 * and the walk down two trees: the golden model of the engine. The conventions are those of
 * sepax.h; docs/reference/tree-engine.md is the specification of format, arithmetic and order. */
#ifndef SEPAX_TREE_H
#define SEPAX_TREE_H

#include "sepax_design.h"

#ifdef __cplusplus
extern "C" {
#endif
#ifdef __GNUC__
#pragma GCC visibility push(default)
#endif

#define SEPAX_TREE_WORD_MAX 21
#define SEPAX_TREE_NODE_BYTES 128
#define SEPAX_TREE_BODY_BYTES 32
#define SEPAX_TREE_POSE_BYTES 144
#define SEPAX_TREE_LINE 32     /* entries in flight */
#define SEPAX_TREE_STACK 1024  /* entries that wait */
#define SEPAX_TREE_LATENCY 100 /* cycles of a memory */

/* ------------------------------------------------------------------- trees */

/* The triangles of a body on a grid, in a tree. It never changes; threads may share it. */
typedef struct sepax_tree sepax_tree;

/* The tree of triangles on a grid, of which word, resolution and offset are kept. Fails on no
 * triangles or more than 2^32 - 1, on a coordinate beyond grid->word bits, on words above
 * SEPAX_TREE_WORD_MAX, on more than 2^23 nodes, and without memory. */
bool sepax_tree_new(sepax_tree **tree, const sepax_tri *tri, size_t count, const sepax_grid *grid,
                    sepax_error *error);
void sepax_tree_free(sepax_tree *tree);

/* Write a tree into a file (docs/reference/tree-engine.md, The file), under a temporary name that
 * is then renamed to path; read it back. Reading checks versions, CRCs and all that the format
 * says, and fails on a file that is anything else than a whole tree. */
bool sepax_tree_write(const sepax_tree *tree, const char *path, sepax_error *error);
bool sepax_tree_read(sepax_tree **tree, const char *path, sepax_error *error);

/* What the engine reads: the image, of so many bytes, a multiple of 16. It stays with the tree. */
const uint8_t *sepax_tree_image(const sepax_tree *tree, size_t *bytes);

/* The body record of an image that is at an address, which is a multiple of 4096. */
void sepax_tree_body(const sepax_tree *tree, uint64_t address,
                     uint8_t record[SEPAX_TREE_BODY_BYTES]);

size_t sepax_tree_nodes(const sepax_tree *tree);
size_t sepax_tree_triangles(const sepax_tree *tree);
sepax_grid sepax_tree_grid(const sepax_tree *tree);

/* The number in the mesh, from 0, of a triangle of the tree. */
uint32_t sepax_tree_number(const sepax_tree *tree, uint32_t triangle);

/* ------------------------------------------------------------------- poses */

/* What turns vertices and boxes of one body to the coordinates of the other. */
typedef struct {
  int32_t matrix[3][3]; /* 2^-20; -2^20 ... 2^20 */
  int64_t shift[3];     /* 2^-20 LSB, 44 bits; of side 0 with the 2^19 that rounds to nearest */
  uint32_t sigma[3];    /* 2^-10 LSB, 24 bits: by how much turned boxes are larger */
} sepax_tree_side;

/* side[0] turns B to A's coordinates: M, t, sigma_A; side[1] turns A to B's: K, u, sigma_B. */
typedef struct {
  sepax_tree_side side[2];
} sepax_tree_pose;

/* The pose of B in the coordinates of A, where the bodies are in their poses (NULL: as they stand
 * in their files). Each entry of the matrix is rounded once, t is wrong by less than 2^-17 LSB.
 * Boxes are larger by the margin, whole LSB, 0 ... 8191 (sepax_design.margin[1]). K, u and sigma_B
 * keep inequality (2) of docs/reference/tree-engine.md, checked in whole numbers. Fails on trees of
 * different resolutions, on a pose that is not valid or has an entry above 1 + 2^-22, on a
 * translation or offset beyond 2^28 LSB, on bodies too far from each other for 44 bits (2^23 LSB),
 * and on a margin that does not fit. */
bool sepax_tree_pose_make(sepax_tree_pose *pose, const sepax_tree *a, const sepax_pose *pose_a,
                          const sepax_tree *b, const sepax_pose *pose_b, int64_t margin,
                          sepax_error *error);

/* The least K-side of a pose whose side[0] and side[1].matrix, .shift are given: fills
 * side[1].sigma by inequality (2), for B's coordinates of so many bits. Fails if it does not fit 24
 * bits. */
bool sepax_tree_pose_close(sepax_tree_pose *pose, int word, int64_t margin, sepax_error *error);

/* To the bytes that the engine reads, and back; reading fails on a number out of its range. */
void sepax_tree_pose_pack(const sepax_tree_pose *pose, uint8_t bytes[SEPAX_TREE_POSE_BYTES]);
bool sepax_tree_pose_unpack(sepax_tree_pose *pose, const uint8_t bytes[SEPAX_TREE_POSE_BYTES],
                            sepax_error *error);

/* By how many LSB the clearance of the core must be larger than that of the real bodies in their
 * poses: d of docs/reference/tree-engine.md, Clearance. */
int sepax_tree_clearance_added(int word);

/* -------------------------------------------------------------------- walk */

/* A near pair: triangles of A and B by their numbers in the trees, the leaves and their children.
 */
typedef struct {
  uint32_t triangle[2];
  uint32_t leaf[2];
  int child[2];
  bool out_of_range; /* a turned coordinate is beyond W bits: called a collision */
  bool collision, coplanar;
  sepax_band band;
} sepax_tree_pair;

/* How trees are walked; all zero but `design` is a good choice. */
typedef struct {
  const sepax_design *design; /* its word, clearances and verdicts; architecture exact */
  unsigned line, stack;       /* 0: SEPAX_TREE_LINE, SEPAX_TREE_STACK */
  int latency;                /* of the memory, for `cycles`; 0: SEPAX_TREE_LATENCY */
  bool first;                 /* end at the first collision */
  const sepax_tree_pair *row; /* a pair that is served before all others; NULL: none */
  /* Called with each near pair, in order; false ends the walk. NULL: not called. */
  bool (*each)(void *context, const sepax_tree_pair *pair);
  void *context;
} sepax_tree_walk_options;

typedef struct {
  uint64_t entries, steps, rows, pairs, near,
      collisions;                  /* docs/reference/tree-engine.md, Counters */
  uint64_t out_of_range, warnings; /* among `near` */
  uint64_t passes;       /* of near pairs through the core: two for one that is flat along z */
  sepax_tree_pair found; /* FIRST, where collisions > 0 */
  uint64_t cycles;       /* predicted, with cold caches */
  uint64_t deepest;      /* the most entries in the stack */
  bool damaged;          /* a node, or the stack: the walk ended there, no verdict */
  bool ended;            /* by `first` or `each` */
} sepax_tree_run;

/* The walk of the engine. Trees of words up to that of the design. Fails where that is not so,
 * where the stack is too small for the trees, and without memory; a damaged tree is no failure. */
bool sepax_tree_walk(const sepax_tree *a, const sepax_tree *b, const sepax_tree_pose *pose,
                     const sepax_tree_walk_options *how, sepax_tree_run *run, sepax_error *error);

/* The same on images as they are in memory, by their body records: bytes that need not be a tree.
 * An image has all the bytes that its record tells. */
bool sepax_tree_walk_images(const uint8_t *const image[2],
                            const uint8_t record[2][SEPAX_TREE_BODY_BYTES],
                            const sepax_tree_pose *pose, const sepax_tree_walk_options *how,
                            sepax_tree_run *run, sepax_error *error);

/* -------------------------------------------------------------------- jobs */

#define SEPAX_TREE_JOB_BYTES 128
#define SEPAX_TREE_POSE_STRIDE 256 /* bytes from a pose of a queue to the next */

/* Modes of a job: docs/reference/tree-engine.md, Jobs. */
enum {
  SEPAX_TREE_FIRST = 1, /* a pose ends at its first collision */
  SEPAX_TREE_QUIET = 2, /* pairs are counted, not sent */
  SEPAX_TREE_ROW = 4,   /* the job's first row is valid */
  SEPAX_TREE_AGAIN = 8, /* what collided first is the first row of the poses behind */
  SEPAX_TREE_COLD = 16, /* caches are empty at each pose, else at the job's first */
  SEPAX_TREE_WARM = 32, /* not at the job's first: its bodies are those of the job before */
  SEPAX_TREE_LEAVE = 64 /* the first pose that collides ends the job */
};

/* Two bodies and a queue of poses. */
typedef struct {
  uint8_t body[2][SEPAX_TREE_BODY_BYTES]; /* sepax_tree_body */
  uint64_t poses;                         /* address of the queue, a multiple of 256 */
  uint32_t count;                         /* of poses, 1 or more */
  uint32_t modes;                         /* SEPAX_TREE_FIRST ... */
  uint32_t budget;                        /* cycles after which a pose is stopped; 0: none */
  uint32_t leaf[2];                       /* the first row */
  int child[2];
} sepax_tree_job;

void sepax_tree_job_pack(const sepax_tree_job *job, uint8_t bytes[SEPAX_TREE_JOB_BYTES]);
/* False if the engine refuses it. */
bool sepax_tree_job_unpack(sepax_tree_job *job, const uint8_t bytes[SEPAX_TREE_JOB_BYTES]);

/* Why a pose ended, and what was found: bits of its status. */
enum {
  SEPAX_TREE_HIT = 1,          /* a pair collides */
  SEPAX_TREE_OUT_OF_RANGE = 2, /* among those that do some are undecided */
  SEPAX_TREE_STOPPED = 4,      /* BUDGET or STOP: undecided, unless HIT */
  SEPAX_TREE_DAMAGED = 8,      /* a node, a leaf or the stack: no verdict */
  SEPAX_TREE_BUS = 16,         /* memory answered with an error: no verdict */
  SEPAX_TREE_REFUSED = 32,     /* a number of the job or the pose is out of its range */
  SEPAX_TREE_NO_VERDICT = 8 + 16 + 32
};

/* A memory as the engine sees it: bytes at the addresses from `address` on. */
typedef struct {
  const uint8_t *byte;
  uint64_t address, size;
} sepax_tree_memory;

/* The golden model of job control: a list of jobs, pose by pose. */
typedef struct {
  const sepax_design *design;
  const sepax_tree_memory *memory;
  uint64_t list; /* address of the jobs, a multiple of 128 */
  uint32_t jobs;
  /* Called with each near pair that is not free, in order; NULL: not called. */
  void (*each)(void *context, const sepax_tree_pair *pair);
  void *context;
  /* Where it is; all zero before the first pose. */
  uint32_t job, pose;
  bool has_row;
  sepax_tree_pair row; /* the first row of the next pose */
  sepax_tree_job current;
} sepax_tree_batch;

typedef struct {
  uint32_t job, pose;
  unsigned status; /* SEPAX_TREE_HIT ...; never STOPPED */
  unsigned modes;
  sepax_tree_run run; /* not defined without a verdict */
} sepax_tree_result;

/* The next pose; *more is false, and nothing is written, if there is none. A batch ends behind its
 * last pose and behind one without a verdict. A body that is not in the memory is an error of the
 * bus here, whether or not the walk comes to what is missing. Fails without memory. */
bool sepax_tree_next(sepax_tree_batch *batch, sepax_tree_result *result, bool *more,
                     sepax_error *error);

/* -------------------------------------------------------- lists in files */

/* A list of jobs with the bodies, names and poses that it needs, as the bytes of its file, which an
 * engine's memory can be filled with: docs/reference/tree-engine.md, The list in a file. Addresses
 * are counted from the first byte. All jobs have as many poses; pose n of each is that of line n of
 * a path. */
typedef struct {
  uint8_t *byte;
  size_t bytes;
  uint64_t list; /* address of the jobs */
  uint32_t jobs, poses, bodies;
  int word, clearance, warning; /* of a design for it: sepax_config; clearance 0 or more */
} sepax_job_list;

/* Two bodies, by their numbers, and poses[] of them. */
typedef struct {
  size_t body[2];
  const sepax_tree_pose *pose;
} sepax_job_pair;

typedef struct {
  const sepax_tree *const *tree; /* of each body: of one resolution, of `word` bits at most */
  const char *const *name;
  size_t bodies;
  const sepax_job_pair *pair; /* a job each */
  size_t pairs;
  const uint32_t *line; /* of each pose: its line in the file of the path */
  size_t poses;
  uint32_t modes; /* of all jobs */
  int word, clearance, warning;
} sepax_job_scene;

/* Fails on no bodies, pairs or poses, on what is more than 2 GiB, and without memory. */
bool sepax_job_list_make(sepax_job_list *list, const sepax_job_scene *scene, sepax_error *error);
void sepax_job_list_free(sepax_job_list *list);

/* Write the file under a temporary name that is then renamed to path; read it back. Reading fails
 * on anything else than a whole list: it checks versions, CRCs, each tree as sepax_tree_read does,
 * jobs and poses as the engine does. */
bool sepax_job_list_write(const sepax_job_list *list, const char *path, sepax_error *error);
bool sepax_job_list_read(sepax_job_list *list, const char *path, sepax_error *error);

/* True iff the file begins as a list does. */
bool sepax_job_list_is(const char *path);

const char *sepax_job_list_name(const sepax_job_list *list, uint32_t body);
uint32_t sepax_job_list_triangles(const sepax_job_list *list, uint32_t body);
double sepax_job_list_resolution(const sepax_job_list *list);
uint32_t sepax_job_list_body(const sepax_job_list *list, uint32_t job, int side); /* A, B: 0, 1 */
uint32_t sepax_job_list_line(const sepax_job_list *list, uint32_t pose);

/* The options of a design for it, all others as they are. */
void sepax_job_list_config(const sepax_job_list *list, sepax_config *config);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif
#endif
