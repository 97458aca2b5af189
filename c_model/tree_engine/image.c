/* SPDX-License-Identifier: MIT */
/* image.c - writes the bytes of a tree from its triangles. */
#include "tree_engine/build.h"
#include "tree_engine/tree.h"
#include "util/aabb.h"
#include "util/error.h"

#include <stdlib.h>
#include <string.h>

typedef struct {
  const tree_binary *binary;
  sepax_tree *tree;
  uint32_t nodes, triangles; /* numbers that are already used */
  size_t at;                 /* place of the next record in the image, in bytes */
} writer;

/* -------------------------------------------------------------------- a node */

static int32_t floor_shift(int32_t x, int by) { return (int32_t)((int64_t)x >> by); }

/* Set the origin to the middle of the bounds, and the exponents to the least with which all cells
 * fit int8. */
static void place(tree_node *n, const box4 *bounds) {
  for (int i = 0; i < 3; i++) {
    int32_t low = (int32_t)bounds->low[i];
    int32_t high = (int32_t)bounds->high[i];
    n->origin[i] = floor_shift(low + high, 1);
    n->exponent[i] = 0;
    while (floor_shift(low - n->origin[i], n->exponent[i]) < INT8_MIN ||
           floor_shift(high - n->origin[i], n->exponent[i]) > INT8_MAX) {
      n->exponent[i]++;
    }
  }
}

static void set_child(tree_node *n, int child, const box4 *b) {
  for (int i = 0; i < 3; i++) {
    n->low[child][i] = (int8_t)floor_shift((int32_t)b->low[i] - n->origin[i], n->exponent[i]);
    n->high[child][i] = (int8_t)floor_shift((int32_t)b->high[i] - n->origin[i], n->exponent[i]);
    int below = -1 - n->low[child][i];
    int most = n->high[child][i] > below ? n->high[child][i] : below;
    n->own[i] = most > n->own[i] ? (int8_t)most : n->own[i];
  }
}

/* Write the record of a leaf at the next place where it does not cross a page. */
static void write_record(writer *w, tree_node *n, const range *r) {
  uint8_t vertex[TREE_FAN_OUT][3];
  uint64_t packed[TREE_VERTICES];
  int vertices = sepax__tree_distinct(w->binary, r->begin, r->end, vertex, packed);
  n->beats = 2 + (vertices + 1) / 2;
  size_t bytes = (size_t)n->beats * TREE_BEAT;
  if (w->at % TREE_PAGE + bytes > TREE_PAGE) {
    w->at = (w->at / TREE_PAGE + 1) * TREE_PAGE;
  }
  n->record = (uint32_t)(w->at / TREE_BEAT);
  uint8_t *to = w->tree->image + w->at;
  for (int k = 0; k < n->children; k++) {
    unsigned three = vertex[k][0] | (unsigned)vertex[k][1] << 5 | (unsigned)vertex[k][2] << 10;
    to[2 * k] = (uint8_t)three;
    to[2 * k + 1] = (uint8_t)(three >> 8);
  }
  for (int k = 0; k < vertices; k++) {
    bytes_put64(to + 32 + 8 * k, packed[k]);
  }
  w->at += bytes;
}

static void write_leaf(writer *w, tree_node *n, const range *r) {
  n->children = (int)count_of(r);
  n->first = w->triangles;
  for (int k = 0; k < n->children; k++) {
    const box4 *e = &w->binary->entry[r->begin + (uint32_t)k];
    set_child(n, k, e);
    w->tree->number[w->triangles++] = box4_number(e);
  }
  write_record(w, n, r);
}

/* Write node `number` of the image, which is node `of` of the binary tree, and all that is below
 * it. Returns its level. */
static int write_node(writer *w, uint32_t number, uint32_t of) {
  tree_node n = {.level = 0};
  const range r = w->binary->node[of].of;
  place(&n, &r.bounds);
  if (w->binary->node[of].child == 0) {
    write_leaf(w, &n, &r);
  } else {
    uint32_t child[TREE_FAN_OUT];
    n.children = sepax__tree_children(w->binary, of, child);
    n.first = w->nodes;
    w->nodes += (uint32_t)n.children;
    for (int k = 0; k < n.children; k++) {
      set_child(&n, k, &w->binary->node[child[k]].of.bounds);
      int level = 1 + write_node(w, n.first + (uint32_t)k, child[k]);
      n.level = level > n.level ? level : n.level;
    }
  }
  sepax__tree_pack(w->tree->image + (size_t)TREE_NODE_BYTES * number, &n,
                   w->tree->image + (size_t)TREE_BEAT * n.record);
  return n.level;
}

/* -------------------------------------------------------------------- a tree */

/* Size of a subtree: its nodes, the leaves among them, and its level. */
typedef struct {
  size_t nodes, leaves;
  int level;
} extent;

/* Measure the subtree of a node that has `above` levels above it. If the tree has too many levels,
 * the measuring stops, and `level` is above TREE_LEVEL_MAX. */
static extent measure(const tree_binary *b, uint32_t of, int above) {
  extent sum = {1, b->node[of].child == 0, 0};
  if (b->node[of].child == 0 || above > TREE_LEVEL_MAX) {
    return sum;
  }
  uint32_t child[TREE_FAN_OUT];
  int children = sepax__tree_children(b, of, child);
  for (int k = 0; k < children; k++) {
    extent part = measure(b, child[k], above + 1);
    sum.nodes += part.nodes;
    sum.leaves += part.leaves;
    sum.level = part.level + 1 > sum.level ? part.level + 1 : sum.level;
  }
  return sum;
}

static bool write_all(sepax_tree *tree, const tree_binary *b, const extent *size) {
  size_t at = tree_records_at(size->nodes);
  tree->image = calloc(at + size->leaves * TREE_RECORD_BYTES, 1);
  tree->number = malloc((size_t)count_of(&b->node[0].of) * sizeof *tree->number);
  if (tree->image == NULL || tree->number == NULL) {
    return false;
  }
  writer w = {.binary = b, .tree = tree, .nodes = 1, .at = at};
  write_node(&w, 0, 0);
  tree->nodes = w.nodes;
  tree->triangles = w.triangles;
  tree->bytes = w.at;
  uint8_t *less = realloc(tree->image, tree->bytes);
  if (less != NULL) {
    tree->image = less;
  }
  return true;
}

static bool build(sepax_tree *tree, const sepax_tri *tri, size_t count, bool *too_many, bool even) {
  tree_binary b;
  bool ok = sepax__tree_divide(&b, tri, count, even) && sepax__tree_choose(&b, even);
  extent size = ok ? measure(&b, 0, 0) : (extent){0};
  *too_many = size.nodes > TREE_NODES_MAX;
  bool too_high = size.level > TREE_LEVEL_MAX;
  ok = ok && !*too_many && (too_high || write_all(tree, &b, &size));
  sepax__tree_binary_free(&b);
  return ok && too_high ? build(tree, tri, count, too_many, true) : ok;
}

static bool check_fits(const sepax_tri *tri, size_t count, const sepax_grid *grid,
                       sepax_error *error) {
  if (grid->word < SEPAX_WORD_MIN || grid->word > SEPAX_TREE_WORD_MAX) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "word: %d is not in %d ... %d, which a tree takes", grid->word,
                      SEPAX_WORD_MIN, SEPAX_TREE_WORD_MAX);
  }
  if (count == 0 || count > UINT32_MAX) {
    return sepax_fail(error, count == 0 ? SEPAX_ERROR_ARGUMENT : SEPAX_ERROR_LIMIT,
                      "a tree has 1 ... 2^32 - 1 triangles, not %zu; %s", count,
                      count == 0 ? "give a mesh with facets" : "split the mesh");
  }
  for (size_t n = 0; n < count; n++) {
    aabb b = aabb_of(&tri[n]);
    if (!aabb_fits(&b, grid->word)) {
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "facet %zu does not fit %d bits; raise word or resolution", n, grid->word);
    }
  }
  return true;
}

bool sepax_tree_new(sepax_tree **tree, const sepax_tri *tri, size_t count, const sepax_grid *grid,
                    sepax_error *error) {
  *tree = NULL;
  if (!check_fits(tri, count, grid, error)) {
    return false;
  }
  sepax_tree *made = calloc(1, sizeof *made);
  bool too_many = false;
  if (made == NULL || !build(made, tri, count, &too_many, false)) {
    sepax_tree_free(made);
    return too_many ? sepax_fail(error, SEPAX_ERROR_LIMIT,
                                 "%zu triangles need more than 2^23 nodes; split the mesh", count)
                    : sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for a tree of %zu triangles",
                                 count);
  }
  made->grid = *grid;
  *tree = made;
  return true;
}

void sepax_tree_free(sepax_tree *tree) {
  if (tree != NULL) {
    free(tree->image);
    free(tree->number);
    free(tree);
  }
}

const uint8_t *sepax_tree_image(const sepax_tree *tree, size_t *bytes) {
  *bytes = tree->bytes;
  return tree->image;
}

void sepax_tree_body(const sepax_tree *tree, uint64_t address,
                     uint8_t record[SEPAX_TREE_BODY_BYTES]) {
  memset(record, 0, SEPAX_TREE_BODY_BYTES);
  bytes_put64(record, address);
  bytes_put32(record + 8, tree->nodes);
  bytes_put32(record + 12, tree->triangles);
  bytes_put32(record + 16, (uint32_t)(tree->bytes / TREE_BEAT));
}

size_t sepax_tree_nodes(const sepax_tree *tree) { return tree->nodes; }
size_t sepax_tree_triangles(const sepax_tree *tree) { return tree->triangles; }
sepax_grid sepax_tree_grid(const sepax_tree *tree) { return tree->grid; }
uint32_t sepax_tree_number(const sepax_tree *tree, uint32_t triangle) {
  return tree->number[triangle];
}
