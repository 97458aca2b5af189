/* SPDX-License-Identifier: MIT */
/* sepax_tree.h - the golden model of the tree engine: trees of triangles in the engine's memory
 * format, poses in fixed point, the walk down two trees, and lists of jobs. The conventions are
 * those of sepax.h. docs/reference/tree-engine.md specifies format, arithmetic and order. */
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
#define SEPAX_TREE_LINE 32     /* most entries in flight */
#define SEPAX_TREE_STACK 1024  /* most entries that wait */
#define SEPAX_TREE_LATENCY 100 /* default latency of the memory, in cycles */

/* ------------------------------------------------------------------- trees */

/* A tree of the triangles of a body on a grid. A tree never changes, so threads may share it. */
typedef struct sepax_tree sepax_tree;

/* Make a tree of `count` triangles. The tree keeps the word, resolution and offset of the grid.
 * Fails if count is 0 or above 2^32 - 1, if a coordinate does not fit grid->word bits, if the word
 * is above SEPAX_TREE_WORD_MAX, if the tree has more than 2^23 nodes, or without memory. Free the
 * tree with sepax_tree_free. */
bool sepax_tree_new(sepax_tree **tree, const sepax_tri *tri, size_t count, const sepax_grid *grid,
                    sepax_error *error);
void sepax_tree_free(sepax_tree *tree);

/* Write a tree to the file `path`, or read it (docs/reference/tree-engine.md, The file). Writing
 * uses a temporary name, which is then renamed to `path`. Reading checks the version, the CRCs and
 * every rule of the format, and fails if the file is not exactly one tree. */
bool sepax_tree_write(const sepax_tree *tree, const char *path, sepax_error *error);
bool sepax_tree_read(sepax_tree **tree, const char *path, sepax_error *error);

/* The image, which is the bytes that the engine reads, and its size in bytes, a multiple of 16. The
 * image belongs to the tree. */
const uint8_t *sepax_tree_image(const sepax_tree *tree, size_t *bytes);

/* Write the body record of a tree whose image is at `address`, a multiple of 4096. */
void sepax_tree_body(const sepax_tree *tree, uint64_t address,
                     uint8_t record[SEPAX_TREE_BODY_BYTES]);

size_t sepax_tree_nodes(const sepax_tree *tree);
size_t sepax_tree_triangles(const sepax_tree *tree);
sepax_grid sepax_tree_grid(const sepax_tree *tree);

/* The number in the mesh, from 0, of a triangle that has the number `triangle` in the tree. */
uint32_t sepax_tree_number(const sepax_tree *tree, uint32_t triangle);

/* ------------------------------------------------------------------- poses */

/* The transformation of one body's vertices and boxes into the other body's coordinates. */
typedef struct {
  int32_t matrix[3][3]; /* rotation, in 2^-20: -2^20 ... 2^20 */
  int64_t shift[3];     /* translation, in 2^-20 LSB: 44 bits. Side 0 includes 2^19, which makes the
                           floor of formula (1) round to nearest */
  uint32_t sigma[3];    /* length by which turned boxes are enlarged, in 2^-10 LSB: 24 bits */
} sepax_tree_side;

/* side[0] turns B into A's coordinates: M, t, sigma_A. side[1] turns A into B's: K, u, sigma_B. */
typedef struct {
  sepax_tree_side side[2];
} sepax_tree_pose;

/* Make the pose of B in the coordinates of A from the poses of both bodies (NULL: the body stays as
 * in its file). `margin` is sepax_design.margin[1] of the design, 0 ... 8191 LSB; boxes are
 * enlarged by it. Each entry of the matrix is rounded once, and t is wrong by less than 2^-17 LSB.
 * sigma_B is computed in whole numbers and satisfies inequality (2) of
 * docs/reference/tree-engine.md.
 * Fails if the resolutions of the trees differ, if a pose is not valid or has an entry above
 * 1 + 2^-22, if a translation or offset is beyond 2^28 LSB, if the bodies are 2^23 LSB or more from
 * each other, or if the margin or sigma_B is out of range. */
bool sepax_tree_pose_make(sepax_tree_pose *pose, const sepax_tree *a, const sepax_pose *pose_a,
                          const sepax_tree *b, const sepax_pose *pose_b, int64_t margin,
                          sepax_error *error);

/* Fill side[1].sigma with the least values that satisfy inequality (2). All other members of the
 * pose are given, `word` is the bits of B's coordinates, and `margin` is that of
 * sepax_tree_pose_make. Fails if a value does not fit 24 bits. */
bool sepax_tree_pose_close(sepax_tree_pose *pose, int word, int64_t margin, sepax_error *error);

/* Convert a pose to the bytes that the engine reads, or back. Unpacking fails if a number is out of
 * its range. */
void sepax_tree_pose_pack(const sepax_tree_pose *pose, uint8_t bytes[SEPAX_TREE_POSE_BYTES]);
bool sepax_tree_pose_unpack(sepax_tree_pose *pose, const uint8_t bytes[SEPAX_TREE_POSE_BYTES],
                            sepax_error *error);

/* d of docs/reference/tree-engine.md, Clearance: the LSB by which the clearance of the core must
 * exceed the clearance of the real bodies in their poses. */
int sepax_tree_clearance_added(int word);

/* -------------------------------------------------------------------- walk */

/* A near pair. Index 0 is A and index 1 is B. */
typedef struct {
  uint32_t triangle[2]; /* numbers in the trees */
  uint32_t leaf[2];     /* node numbers of their leaves */
  int child[2];         /* numbers in the leaves, 0 ... 15 */
  bool out_of_range;    /* a turned coordinate does not fit W bits: reported as a collision */
  bool collision, coplanar;
  sepax_band band;
} sepax_tree_pair;

/* Options of a walk. All members but `design` may be zero. */
typedef struct {
  const sepax_design *design; /* word, clearances and verdicts; its architecture is exact */
  unsigned line, stack;       /* most entries; 0: SEPAX_TREE_LINE, SEPAX_TREE_STACK */
  int latency;                /* cycles of the memory, for `cycles`; 0: SEPAX_TREE_LATENCY */
  bool first;                 /* end at the first collision */
  const sepax_tree_pair *row; /* the pair to test before all others (leaf, child); NULL: none */
  /* Called with each near pair, in order. If it returns false, the walk ends. NULL: not called. */
  bool (*each)(void *context, const sepax_tree_pair *pair);
  void *context;
} sepax_tree_walk_options;

typedef struct {
  uint64_t entries, steps, rows, pairs, near,
      collisions;                  /* docs/reference/tree-engine.md, Counters */
  uint64_t out_of_range, warnings; /* near pairs that are out of range, or in the warning band */
  sepax_tree_pair found;           /* the first collision; valid if collisions > 0 */
  uint64_t cycles;                 /* predicted cycle of the last verdict, with cold caches */
  uint64_t deepest;                /* most entries that were in the stack */
  bool damaged;                    /* a node is damaged or the stack is full: no verdict */
  bool ended;                      /* `first` or `each` ended the walk */
} sepax_tree_run;

/* Walk two trees as the engine does. Fails if the word of a tree is above that of the design, if
 * the stack is too small for the trees, or without memory. A damaged tree is not a failure: see
 * run->damaged. */
bool sepax_tree_walk(const sepax_tree *a, const sepax_tree *b, const sepax_tree_pose *pose,
                     const sepax_tree_walk_options *how, sepax_tree_run *run, sepax_error *error);

/* The same walk on images in memory, which may hold any bytes. Each image must have as many bytes
 * as its body record says. Fails also if the nodes of a record do not fit its image. */
bool sepax_tree_walk_images(const uint8_t *const image[2],
                            const uint8_t record[2][SEPAX_TREE_BODY_BYTES],
                            const sepax_tree_pose *pose, const sepax_tree_walk_options *how,
                            sepax_tree_run *run, sepax_error *error);

/* -------------------------------------------------------------------- jobs */

#define SEPAX_TREE_JOB_BYTES 128
#define SEPAX_TREE_POSE_STRIDE 256 /* bytes from one pose of a queue to the next */

/* Modes of a job: docs/reference/tree-engine.md, Jobs. */
enum {
  SEPAX_TREE_FIRST = 1, /* a pose ends at its first collision */
  SEPAX_TREE_QUIET = 2, /* colliding pairs are counted but not sent */
  SEPAX_TREE_ROW = 4,   /* leaf and child are valid: the pair that the first pose tests first */
  SEPAX_TREE_AGAIN = 8, /* a pose tests first the pair that collided first in an earlier pose */
  SEPAX_TREE_COLD = 16, /* empty the caches before each pose, not only before the first */
  SEPAX_TREE_WARM = 32, /* keep the caches for the first pose: same bodies as the job before */
  SEPAX_TREE_LEAVE = 64 /* the first pose that collides ends the job */
};

/* Two bodies and a queue of poses. */
typedef struct {
  uint8_t body[2][SEPAX_TREE_BODY_BYTES]; /* sepax_tree_body */
  uint64_t poses;                         /* address of the queue, a multiple of 256 */
  uint32_t count;                         /* number of poses, 1 or more */
  uint32_t modes;                         /* SEPAX_TREE_FIRST ... */
  uint32_t budget;                        /* cycles after which a pose is stopped; 0: no limit */
  uint32_t leaf[2];                       /* the first row: node numbers of its leaves */
  int child[2];                           /* the first row: numbers in the leaves */
} sepax_tree_job;

/* Convert a job to the bytes that the engine reads, or back. Unpacking returns false if the engine
 * refuses the job. */
void sepax_tree_job_pack(const sepax_tree_job *job, uint8_t bytes[SEPAX_TREE_JOB_BYTES]);
bool sepax_tree_job_unpack(sepax_tree_job *job, const uint8_t bytes[SEPAX_TREE_JOB_BYTES]);

/* Bits of the status of a pose: what was found, and why the pose ended. */
enum {
  SEPAX_TREE_HIT = 1,          /* a pair collides */
  SEPAX_TREE_OUT_OF_RANGE = 2, /* some of the collisions are out of range, so undecided */
  SEPAX_TREE_STOPPED = 4,      /* ended by BUDGET or STOP: other collisions may exist */
  SEPAX_TREE_DAMAGED = 8,      /* a damaged node or leaf, or a full stack: no verdict */
  SEPAX_TREE_BUS = 16,         /* memory answered with an error: no verdict */
  SEPAX_TREE_REFUSED = 32,     /* a number of the job or pose is out of its range: no verdict */
  SEPAX_TREE_NO_VERDICT = 8 + 16 + 32
};

/* The engine's memory: `size` bytes, of which the first has the address `address`. */
typedef struct {
  const uint8_t *byte;
  uint64_t address, size;
} sepax_tree_memory;

/* A list of jobs for sepax_tree_next, which works through it pose by pose. */
typedef struct {
  const sepax_design *design;
  const sepax_tree_memory *memory;
  uint64_t list; /* address of the jobs, a multiple of 128 */
  uint32_t jobs;
  /* Called with each pair that collides or is in the warning band, in order. NULL: not called. */
  void (*each)(void *context, const sepax_tree_pair *pair);
  void *context;
  /* The state of the batch. All zero before the first pose. */
  uint32_t job, pose;
  bool has_row;
  sepax_tree_pair row; /* the first row of the next pose */
  sepax_tree_job current;
} sepax_tree_batch;

typedef struct {
  uint32_t job, pose;
  unsigned status;    /* SEPAX_TREE_HIT ...; never SEPAX_TREE_STOPPED */
  unsigned modes;     /* of the job */
  sepax_tree_run run; /* undefined if status has a bit of SEPAX_TREE_NO_VERDICT */
} sepax_tree_result;

/* Work on the next pose of a batch. If the batch has ended, *more is false and nothing else is
 * written. A batch ends after its last pose or after a pose without a verdict. If a body is not
 * wholly in the memory, the status is SEPAX_TREE_BUS, even if the walk would not need the missing
 * bytes. Fails without memory. */
bool sepax_tree_next(sepax_tree_batch *batch, sepax_tree_result *result, bool *more,
                     sepax_error *error);

/* -------------------------------------------------------- lists in files */

/* A list of jobs with its bodies, names and poses (docs/reference/tree-engine.md, The list in a
 * file). The bytes are those of the file and of the engine's memory. Addresses count from the first
 * byte. All jobs have the same number of poses. Pose n of each job belongs to line n of a path. */
typedef struct {
  uint8_t *byte;
  size_t bytes;
  uint64_t list;                /* address of the jobs */
  uint32_t jobs, poses, bodies; /* poses: of each job */
  int word, clearance, warning; /* sepax_config of a design for the list; clearance is 0 or more */
} sepax_job_list;

/* Two bodies, by their numbers, and sepax_job_scene.poses poses of them. */
typedef struct {
  size_t body[2];
  const sepax_tree_pose *pose;
} sepax_job_pair;

typedef struct {
  const sepax_tree *const *tree; /* of each body; one resolution, at most `word` bits */
  const char *const *name;       /* of each body */
  size_t bodies;
  const sepax_job_pair *pair; /* each pair becomes a job */
  size_t pairs;
  const uint32_t *line; /* for each pose: its line in the path file */
  size_t poses;
  uint32_t modes; /* of all jobs: SEPAX_TREE_FIRST ... */
  int word, clearance, warning;
} sepax_job_scene;

/* Make a list. Fails without bodies, pairs or poses, if the list would exceed 2 GiB, or without
 * memory. Free the list with sepax_job_list_free. */
bool sepax_job_list_make(sepax_job_list *list, const sepax_job_scene *scene, sepax_error *error);
void sepax_job_list_free(sepax_job_list *list);

/* Write a list to the file `path`, or read it. Writing uses a temporary name, which is then renamed
 * to `path`. Reading checks the version, the CRCs, each tree as sepax_tree_read does, and each job
 * and pose as the engine does, and fails if the file is not exactly one list. */
bool sepax_job_list_write(const sepax_job_list *list, const char *path, sepax_error *error);
bool sepax_job_list_read(sepax_job_list *list, const char *path, sepax_error *error);

/* True if and only if the file begins as a list does. */
bool sepax_job_list_is(const char *path);

/* Name, triangles and resolution of the bodies; the number of a job's body; the line in the path
 * file of a pose. Numbers count from 0. */
const char *sepax_job_list_name(const sepax_job_list *list, uint32_t body);
uint32_t sepax_job_list_triangles(const sepax_job_list *list, uint32_t body);
double sepax_job_list_resolution(const sepax_job_list *list);
uint32_t sepax_job_list_body(const sepax_job_list *list, uint32_t job, int side); /* A, B: 0, 1 */
uint32_t sepax_job_list_line(const sepax_job_list *list, uint32_t pose);

/* Set tree, word, clearance and warning of *config to those of a design for the list. */
void sepax_job_list_config(const sepax_job_list *list, sepax_config *config);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif
#endif
