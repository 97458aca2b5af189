/* sepax_tree.h - trees of triangles in the memory format of the tree engine, poses in fixed point,
 * and the walk down two trees: the golden model of the engine. The conventions are those of
 * sepax.h; docs/tree.md is the specification of format, arithmetic and order. */
#ifndef SEPAX_TREE_H
#define SEPAX_TREE_H

#include "sepax_design.h"

#ifdef __cplusplus
extern "C" {
#endif

#define SEPAX_TREE_WORD_MAX 21
#define SEPAX_TREE_NODE_BYTES 128
#define SEPAX_TREE_BODY_BYTES 32
#define SEPAX_TREE_POSE_BYTES 144
#define SEPAX_TREE_LINE 32    /* entries in flight */
#define SEPAX_TREE_STACK 1024 /* entries that wait */

/* ------------------------------------------------------------------- trees */

/* The triangles of a body on a grid, in a tree. It never changes; threads may share it. */
typedef struct sepax_tree sepax_tree;

/* The tree of triangles on a grid, of which word, resolution and offset are kept. Fails on no
 * triangles or more than 2^32 - 1, on a coordinate beyond grid->word bits, on words above
 * SEPAX_TREE_WORD_MAX, on more than 2^23 nodes, and without memory. */
bool sepax_tree_new(sepax_tree **tree, const sepax_tri *tri, size_t count, const sepax_grid *grid,
                    sepax_error *error);
void sepax_tree_free(sepax_tree *tree);

/* Write a tree into a file (docs/tree.md, The file), under a temporary name that is then renamed to
 * path; read it back. Reading checks versions, CRCs and all that the format says, and fails on a
 * file that is anything else than a whole tree. */
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
 * keep inequality (2) of docs/tree.md, checked in whole numbers. Fails on trees of different
 * resolutions, on a pose that is not valid or has an entry above 1 + 2^-22, on a translation or
 * offset beyond 2^28 LSB, on bodies too far from each other for 44 bits (2^23 LSB), and on a
 * margin that does not fit. */
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
 * poses: d of docs/tree.md, Clearance. */
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
  bool first;                 /* end at the first collision */
  const sepax_tree_pair *row; /* a pair that is served before all others; NULL: none */
  /* Called with each near pair, in order; false ends the walk. NULL: not called. */
  bool (*each)(void *context, const sepax_tree_pair *pair);
  void *context;
} sepax_tree_walk;

typedef struct {
  uint64_t entries, steps, rows, pairs, near, collisions; /* docs/tree.md, Counters */
  uint64_t out_of_range, warnings;                        /* among `near` */
  uint64_t passes;       /* of near pairs through the core: two for one that is flat along z */
  sepax_tree_pair found; /* FIRST, where collisions > 0 */
  uint64_t deepest;      /* the most entries in the stack */
  bool damaged;          /* a node, or the stack: the walk ended there, no verdict */
  bool ended;            /* by `first` or `each` */
} sepax_tree_run;

/* The walk of the engine. Trees of words up to that of the design. Fails where that is not so,
 * where the stack is too small for the trees, and without memory; a damaged tree is no failure. */
bool sepax_trees_walk(const sepax_tree *a, const sepax_tree *b, const sepax_tree_pose *pose,
                      const sepax_tree_walk *how, sepax_tree_run *run, sepax_error *error);

/* The same on images as they are in memory, by their body records: bytes that need not be a tree.
 * An image has all the bytes that its record tells. */
bool sepax_images_walk(const uint8_t *const image[2],
                       const uint8_t record[2][SEPAX_TREE_BODY_BYTES], const sepax_tree_pose *pose,
                       const sepax_tree_walk *how, sepax_tree_run *run, sepax_error *error);

#ifdef __cplusplus
}
#endif
#endif
