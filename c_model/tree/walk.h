/* walk.h - the pieces of the walk down two trees, one a module of the engine (private). Each is a
 * function of its arguments; docs/tree.md has the formulas and widths. */
#ifndef SEPAX_TREE_WALK_H
#define SEPAX_TREE_WALK_H

#include "tree/format.h"

/* One side of a pose. */
typedef struct {
  int32_t matrix[3][3]; /* 2^-20; -2^20 ... 2^20 */
  int64_t shift[3];     /* 2^-20 LSB, 44 bits */
  uint32_t sigma[3];    /* 2^-10 LSB, 24 bits */
} tree_side;

/* Side 0: B to A (M, t, sigma_A). Side 1: A to B (K, u, sigma_B). */
typedef struct {
  tree_side side[2];
} tree_pose;

/* What turns boxes of S into the cells of T. */
typedef struct {
  int32_t n[3][3];         /* N, 12 bits */
  int32_t low[3], high[3]; /* 21 bits */
  int shift[3];            /* -5 ... 10 */
} tree_setting;

/* A turned box in cells of T, -129 ... 128. */
typedef struct {
  int low[3], high[3];
} tree_cells;

/* A pair that was tested. */
typedef struct {
  bool near;         /* the AABBs leave no gap above the margin */
  bool out_of_range; /* near, and a turned coordinate is beyond W bits */
  int turn;          /* what the core gets: 0: (x, y, z), 1: (y, z, x), 2: (z, x, y) */
} tree_pair;

tree_setting tree_set_up(const tree_side *side, const tree_node *s, const tree_node *t);
tree_cells tree_turn_box(const tree_setting *setting, const int8_t low[3], const int8_t high[3]);

/* Bit j: child j of T is hit. */
uint16_t tree_hits(const tree_cells *box, const tree_node *t);

void tree_turn_vertex(int32_t v[3], const tree_side *side, const int32_t p[3]);

/* a: vertices of A; b: turned vertices of B; margin 0 ... 2^(W-1). */
tree_pair tree_test_pair(const int32_t a[3][3], const int32_t b[3][3], int32_t margin, int word);

/* As the core gets it. */
sepax_tri tree_turned_axes(const int32_t v[3][3], int turn);

/* Bytes to pose and back; reading fails if a number is out of its range. */
bool tree_pose_unpack(tree_pose *pose, const uint8_t bytes[TREE_POSE_BYTES], sepax_error *error);
void tree_pose_pack(uint8_t bytes[TREE_POSE_BYTES], const tree_pose *pose);

#endif
