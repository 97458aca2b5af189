/* SPDX-License-Identifier: MIT */
/* check.c - checks that an image of any bytes is a tree. */
#include "tree_engine/tree.h"
#include "util/aabb.h"
#include "util/error.h"

#include <stdlib.h>

/* The state of the check, which walks down the tree. If no node or triangle is seen twice, and the
 * counts equal those of the tree, then each has exactly one parent. */
typedef struct {
  const sepax_tree *tree;
  tree_image image;
  uint8_t *seen;           /* 1 if seen: nodes, then triangles */
  size_t nodes, triangles; /* that were counted */
  sepax_error *error;
} checker;

static bool wrong(const checker *c, uint32_t number, const char *what) {
  return sepax_fail(c->error, SEPAX_ERROR_FORMAT, "node %u: %s; the file is damaged, make it again",
                    number, what);
}

static bool all_zero(const uint8_t *bytes, size_t count) {
  unsigned any = 0;
  for (size_t n = 0; n < count; n++) {
    any |= bytes[n];
  }
  return any == 0;
}

static bool record_zeros(const tree_node *n, const uint8_t *record) {
  size_t children = (size_t)n->children;
  int most = -1; /* highest vertex number in use */
  for (size_t k = 0; k < children; k++) {
    unsigned packed = record[2 * k] | (unsigned)record[2 * k + 1] << 8;
    for (int i = 0; i < 3; i++) {
      int number = (int)(packed >> (5 * i) & 31);
      most = number > most ? number : most;
    }
  }
  int places = 2 * n->beats - 4;
  bool zero = most < places && all_zero(record + 2 * children, 2 * (TREE_FAN_OUT - children));
  for (int k = 0; k < places && zero; k++) {
    const uint8_t *vertex = record + 32 + 8 * k;
    zero = k <= most ? (vertex[7] & 128) == 0 : all_zero(vertex, 8);
  }
  return zero;
}

/* True if all unused bytes of a node, and of its record, are 0. */
static bool zeros(const checker *c, const tree_node *n, const uint8_t *bytes) {
  size_t children = (size_t)n->children;
  if (bytes[15] != 0 || bytes[31] != 0 ||
      !all_zero(bytes + 32 + 6 * children, 6 * (TREE_FAN_OUT - children))) {
    return false;
  }
  if (n->level > 0) {
    return n->record == 0 && n->beats == 1;
  }
  return record_zeros(n, c->tree->image + (size_t)TREE_BEAT * n->record);
}

/* True if the cells of a child hold a box, and the node's own box holds the cells. */
static bool holds(const tree_node *n, int child, const aabb *b) {
  for (int i = 0; i < 3; i++) {
    if (n->low[child][i] > n->high[child][i] || n->low[child][i] < -1 - n->own[i] ||
        n->high[child][i] > n->own[i] ||
        b->low[i] - n->origin[i] < n->low[child][i] * (INT64_C(1) << n->exponent[i]) ||
        b->high[i] - n->origin[i] >= (n->high[child][i] + 1) * (INT64_C(1) << n->exponent[i])) {
      return false;
    }
  }
  return true;
}

static bool see(const checker *c, size_t at) {
  bool first = c->seen[at] == 0;
  c->seen[at] = 1;
  return first;
}

static bool check_triangle(const checker *c, const tree_node *n, int child, aabb *bounds) {
  const uint8_t *record = c->tree->image + (size_t)TREE_BEAT * n->record;
  int word = c->tree->grid.word;
  int32_t v[3][3];
  int32_t wide[3][3];
  if ((record[2 * child + 1] & 128) != 0 ||
      !sepax__tree_triangle(v, record, n->beats, child, word) ||
      !sepax__tree_triangle(wide, record, n->beats, child, SEPAX_TREE_WORD_MAX)) {
    return false;
  }
  bool same = true;
  for (int k = 0; k < 9; k++) {
    same = same && v[k / 3][k % 3] == wide[k / 3][k % 3];
  }
  const sepax_tri t = {
      {{v[0][0], v[0][1], v[0][2]}, {v[1][0], v[1][1], v[1][2]}, {v[2][0], v[2][1], v[2][2]}}};
  *bounds = aabb_of(&t);
  return same && see(c, (size_t)c->tree->nodes + n->first + (size_t)child);
}

/* Check node `number`, which is below the number of nodes, and all that is below it. *bounds
 * becomes the box of its triangles. */
static bool check_node(checker *c, uint32_t number, int level_above, aabb *bounds) {
  const uint8_t *bytes = c->tree->image + (size_t)TREE_NODE_BYTES * number;
  const tree_node n = sepax__tree_unpack(bytes, c->tree->grid.word);
  if (!see(c, number) || !sepax__tree_node_sound(&c->image, &n, number) || n.level >= level_above) {
    return wrong(c, number, "its children are not where children are");
  }
  const uint8_t *record = c->tree->image + (n.level == 0 ? (size_t)TREE_BEAT * n.record : 0);
  if (bytes_get32(bytes + 24) != sepax__tree_node_crc(bytes, record)) {
    return wrong(c, number, "its CRC is not that of its bytes");
  }
  for (int i = 0; i < 3; i++) {
    if ((int32_t)bytes_get32(bytes + 4 * i) != n.origin[i]) {
      return wrong(c, number, "its origin is beyond the word");
    }
  }
  if (!zeros(c, &n, bytes)) {
    return wrong(c, number, "bytes that are to be 0 are not");
  }
  *bounds = aabb_of_none();
  int highest = -1;
  for (int k = 0; k < n.children; k++) {
    aabb of_child = aabb_of_none();
    if (n.level > 0) {
      uint32_t child = n.first + (uint32_t)k;
      if (!check_node(c, child, n.level, &of_child)) {
        return false;
      }
      int level = c->tree->image[(size_t)TREE_NODE_BYTES * child + 14] & 15;
      highest = level > highest ? level : highest;
      c->nodes++;
    } else {
      if (!check_triangle(c, &n, k, &of_child)) {
        return wrong(c, number, "a triangle is not one");
      }
      c->triangles++;
    }
    if (!holds(&n, k, &of_child)) {
      return wrong(c, number, "a box does not hold what is below it");
    }
    aabb_enclose(bounds, &of_child);
  }
  return n.level == highest + 1 || wrong(c, number, "its level is wrong");
}

/* Check that the table gives each triangle of the mesh once. */
static bool check_table(const checker *c) {
  for (uint32_t n = 0; n < c->tree->triangles; n++) {
    uint32_t number = c->tree->number[n];
    if (number >= c->tree->triangles || !see(c, number)) {
      return sepax_fail(c->error, SEPAX_ERROR_FORMAT,
                        "the table of triangles names one twice; the file is damaged, "
                        "make it again");
    }
  }
  return true;
}

bool sepax__tree_check(const sepax_tree *tree, sepax_error *error) {
  checker c = {.tree = tree, .image = tree_image_of(tree), .nodes = 1, .error = error};
  c.seen = calloc((size_t)tree->nodes + 2 * (size_t)tree->triangles, 1);
  if (c.seen == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory to check %u triangles",
                      tree->triangles);
  }
  aabb bounds;
  bool ok = check_node(&c, 0, TREE_LEVEL_MAX + 1, &bounds);
  if (ok && (c.nodes != tree->nodes || c.triangles != tree->triangles)) {
    ok = sepax_fail(error, SEPAX_ERROR_FORMAT,
                    "%zu nodes, %zu triangles of %u and %u are in the tree; the file is "
                    "damaged, make it again",
                    c.nodes, c.triangles, tree->nodes, tree->triangles);
  }
  checker table = c;
  table.seen = c.seen + tree->nodes + tree->triangles;
  ok = ok && check_table(&table);
  free(c.seen);
  return ok;
}
