/* walk.h - the pieces of the walk down two trees, one a module of the engine (private). Each is a
 * function of its arguments; docs/tree.md has the formulas and widths. */
#ifndef SEPAX_TREE_WALK_H
#define SEPAX_TREE_WALK_H

#include "sepax_tree.h"
#include "tree/format.h"

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

tree_setting tree_set_up(const sepax_tree_side *side, const tree_node *s, const tree_node *t);
tree_cells tree_turn_box(const tree_setting *setting, const int8_t low[3], const int8_t high[3]);

/* Bit j: child j of T is hit. */
uint16_t tree_hits(const tree_cells *box, const tree_node *t);

void tree_turn_vertex(int32_t v[3], const sepax_tree_side *side, const int32_t p[3]);

/* a: vertices of A; b: turned vertices of B; margin 0 ... 2^(W-1). */
tree_pair tree_test_pair(const int32_t a[3][3], const int32_t b[3][3], int64_t margin, int word);

/* As the core gets it. */
sepax_tri tree_turned_axes(const int32_t v[3][3], int turn);

/* sepax_images_walk of what has been looked at: nodes are in the images. */
bool tree_images_walk(const tree_image tree[2], const sepax_tree_pose *pose,
                      const sepax_tree_walk *how, sepax_tree_run *run, sepax_error *error);

#endif
