/* SPDX-License-Identifier: MIT */
/* sxt_files.c - trees as the format says, files that give them back, and damaged ones that do not:
 * SEPAX_COUNT: how many damaged trees are walked. */
#include "tree_engine/build.h"
#include "tree_engine/tree.h"
#include "unit/tree/scenes.h"

#include <stdio.h>

/* Triangles that halve in size and distance: the surface area heuristic cuts off one end each time.
 */
static triangles halving(size_t count) {
  triangles t = {calloc(count, sizeof(sepax_tri)), count};
  assert_non_null(t.tri);
  for (size_t n = 0; n < count; n++) {
    double x = ldexp(100000, -(int)(n * 18 / count));
    for (int k = 0; k < 9; k++) {
      *coordinate(&t.tri[n].v[k / 3], k % 3) = (int32_t)(x * (1 + 0.3 * random_unit()));
    }
  }
  return t;
}

static triangles one_place(size_t count) {
  triangles t = {calloc(count, sizeof(sepax_tri)), count};
  assert_non_null(t.tri);
  return t;
}

static triangles body(int kind, size_t count, int word) {
  double most = sepax_word_max(word);
  return kind == 5   ? halving(count)
         : kind == 6 ? one_place(count)
                     : drawn(count, kind, 0.7 * most, kind == 0 ? most : 0.05 * most, word);
}

/* All vertices are where they were. */
static void assert_same_triangles(const sepax_tree *tree, const triangles *t) {
  assert_int_equal(sepax_tree_triangles(tree), t->count);
  for (uint32_t number = 0; number < tree->nodes; number++) {
    const tree_node n = sepax__tree_unpack(tree->image + (size_t)128 * number, tree->grid.word);
    for (int k = 0; k < n.children && n.level == 0; k++) {
      int32_t v[3][3];
      assert_true(sepax__tree_triangle(v, tree->image + (size_t)16 * n.record, n.beats, k, 21));
      sepax_tri *own = &t->tri[sepax_tree_number(tree, n.first + (uint32_t)k)];
      for (int i = 0; i < 9; i++) {
        assert_int_equal(v[i / 3][i % 3], *coordinate(&own->v[i / 3], i % 3));
      }
    }
  }
}

CASE(trees_are_whole) {
  static const size_t counts[] = {1, 2, 16, 17, 33, 400, 5000};
  static const int words[] = {18, 21, 18, 18, 12, 18, 4};
  for (int kind = 0; kind < 7; kind++) {
    for (size_t c = 0; c < LENGTH(counts); c++) {
      triangles t = body(kind, counts[c], words[kind]);
      sepax_tree *tree = tree_of(&t, words[kind]);
      assert_works(sepax__tree_check(tree, &fault));
      assert_same_triangles(tree, &t);
      sepax_tree *back;
      snprintf(path, sizeof path, "%s/body.sxt", folder);
      assert_works(sepax_tree_write(tree, path, &fault));
      assert_works(sepax_tree_read(&back, path, &fault));
      size_t bytes;
      size_t bytes_back;
      const uint8_t *image = sepax_tree_image(tree, &bytes);
      const uint8_t *image_back = sepax_tree_image(back, &bytes_back);
      assert_int_equal(bytes, bytes_back);
      assert_memory_equal(image, image_back, bytes);
      assert_memory_equal(tree->number, back->number, t.count * sizeof *tree->number);
      double each = (double)bytes / (double)t.count;
      assert_true(t.count < 5000 || each <= (kind == 4 ? 22 : 50));
      sepax_tree_free(tree);
      sepax_tree_free(back);
      free(t.tri);
    }
  }
}

/* Levels below a node of a tree in halves; its leaves are counted. */
static int even_levels(const tree_binary *b, uint32_t node, size_t *triangles_below) {
  if (b->node[node].child == 0) {
    *triangles_below += count_of(&b->node[node].of);
    return 0;
  }
  uint32_t child[TREE_FAN_OUT];
  int children = sepax__tree_children(b, node, child);
  int most = 0;
  assert_true(children >= 2 && children <= TREE_FAN_OUT);
  for (int k = 0; k < children; k++) {
    int levels = 1 + even_levels(b, child[k], triangles_below);
    most = levels > most ? levels : most;
  }
  return most;
}

/* What is taken where the surface area heuristic makes too many levels. */
CASE(halves_are_low) {
  for (int kind = 0; kind < 7; kind++) {
    triangles t = body(kind, 20000, 18);
    tree_binary b;
    size_t below = 0;
    assert_true(sepax__tree_divide(&b, t.tri, t.count, true) && sepax__tree_choose(&b, true));
    assert_true(even_levels(&b, 0, &below) <= 4);
    assert_int_equal(below, t.count);
    sepax__tree_binary_free(&b);
    free(t.tri);
  }
}

CASE(what_is_no_tree) {
  sepax_tree *tree;
  sepax_tri t = {{{0, 0, 0}, {200, 0, 0}, {0, 3, 0}}};
  sepax_grid grid = {.resolution = 1, .word = 8};
  assert_fault(sepax_tree_new(&tree, &t, 1, &grid, &fault), "facet 0 does not fit 8 bits");
  grid.word = 22;
  assert_fault(sepax_tree_new(&tree, &t, 1, &grid, &fault), "word: 22 is not in 4 ... 21");
  grid.word = 18;
  assert_fault(sepax_tree_new(&tree, &t, 0, &grid, &fault), "1 ... 2^32 - 1 triangles");
}

/* ------------------------------------------------------------------- damage */

static void write_bytes(const uint8_t *bytes, size_t count) {
  FILE *out = fopen(path, "wb");
  assert_non_null(out);
  assert_int_equal(fwrite(bytes, 1, count, out), count);
  assert_int_equal(fclose(out), 0);
}

static uint8_t *file_of(const sepax_tree *tree, size_t *count) {
  snprintf(path, sizeof path, "%s/body.sxt", folder);
  assert_works(sepax_tree_write(tree, path, &fault));
  FILE *in = fopen(path, "rb");
  assert_non_null(in);
  fseek(in, 0, SEEK_END);
  *count = (size_t)ftell(in);
  rewind(in);
  uint8_t *bytes = malloc(*count);
  assert_non_null(bytes);
  assert_int_equal(fread(bytes, 1, *count, in), *count);
  fclose(in);
  return bytes;
}

CASE(damaged_files) {
  triangles t = body(4, 100, 18);
  sepax_tree *tree = tree_of(&t, 18);
  size_t count;
  uint8_t *bytes = file_of(tree, &count);
  sepax_tree *back;
  for (int n = 0; n < 500; n++) {
    size_t at = (size_t)random_below((int)count);
    uint8_t keep = bytes[at];
    bytes[at] = (uint8_t)(bytes[at] ^ 1 << random_below(8));
    write_bytes(bytes, count);
    assert_fault(sepax_tree_read(&back, path, &fault), "make ");
    assert_null(back);
    bytes[at] = keep;
  }
  for (size_t n = 0; n < count; n += 1 + (size_t)random_below(500)) {
    write_bytes(bytes, n);
    assert_fault(sepax_tree_read(&back, path, &fault), "make ");
  }
  snprintf(path, sizeof path, "%s/none.sxt", folder);
  assert_fault(sepax_tree_read(&back, path, &fault), "none.sxt: not read: No such file");
  free(bytes);
  sepax_tree_free(tree);
  free(t.tri);
}

/* Any byte but those of the places that are never read makes the tree wrong, also under a right
 * CRC. */
static void mend_crc(sepax_tree *tree, uint32_t number) {
  uint8_t *node = tree->image + (size_t)128 * number;
  const tree_node n = sepax__tree_unpack(node, tree->grid.word);
  tree_image image = tree_image_of(tree);
  if (n.level > 0 || sepax__tree_node_sound(&image, &n, number)) {
    size_t at = n.level > 0 ? 0 : (size_t)16 * n.record;
    bytes_put32(node + 24, sepax__tree_node_crc(node, tree->image + at));
  }
}

CASE(damage_under_right_crcs) {
  triangles t = body(4, 300, 18);
  sepax_tree *tree = tree_of(&t, 18);
  int told = 0;
  for (uint32_t number = 0; number < tree->nodes; number++) {
    uint8_t *node = tree->image + (size_t)128 * number;
    for (int at = 12; at < 128; at = at == 23 ? 31 : at + 1) {
      uint8_t keep[128];
      memcpy(keep, node, sizeof keep);
      node[at] = (uint8_t)(node[at] ^ 128);
      mend_crc(tree, number);
      fault.text[0] = '\0';
      bool ok = sepax__tree_check(tree, &fault);
      assert_int_equal(ok, fault.text[0] == '\0');
      told += !ok;
      assert_true(!ok || at >= 32); /* a box may be larger than what it holds */
      memcpy(node, keep, sizeof keep);
    }
  }
  assert_true(told > 1000);
  assert_works(sepax__tree_check(tree, &fault));
  for (int way = 0; way < 2; way++) { /* more than are there, of the same image */
    uint32_t *counted = way == 0 ? &tree->nodes : &tree->triangles;
    ++*counted;
    assert_fault(sepax__tree_check(tree, &fault), way == 0 ? "nodes, 300 triangles" : "of ");
    --*counted;
  }
  tree->number[0] = tree->number[1];
  assert_fault(sepax__tree_check(tree, &fault), "twice");
  sepax_tree_free(tree);
  free(t.tri);
}

/* ------------------------------------------------- the walk over any bytes */

static bool at_most(void *context, const sepax_tree_pair *pair) {
  size_t *left = context;
  assert_true(pair->child[0] < 16 && pair->child[1] < 16);
  return (*left)-- > 0;
}

/* The walk ends: damaged, or with what it then finds. */
CASE(damaged_trees_end) {
  size_t count = count_of_run("SEPAX_COUNT", 3000);
  triangles t = body(4, 600, 18);
  sepax_tree *tree = tree_of(&t, 18);
  sepax_design design = design_of("--word=18");
  size_t bytes;
  const uint8_t *image = sepax_tree_image(tree, &bytes);
  uint8_t *copy = malloc(bytes);
  assert_non_null(copy);
  size_t damaged = 0;
  for (size_t n = 0; n < count; n++) {
    uint8_t record[2][SEPAX_TREE_BODY_BYTES];
    sepax_tree_body(tree, 4096, record[0]);
    sepax_tree_body(tree, 4096, record[1]);
    memcpy(copy, image, bytes);
    int changes = 1 + random_below(n % 2 == 0 ? 4 : 2000);
    for (int k = 0; k < changes; k++) {
      size_t last = n % 3 == 0 ? bytes : 128 * sepax_tree_nodes(tree);
      copy[random_below((int)last)] = (uint8_t)random_below(256);
    }
    if (random_below(10) == 0) {
      record[1][8 + random_below(12)] = (uint8_t)random_below(256);
      bytes_put32(record[1] + 16, (uint32_t)(bytes / 16));
    }
    sepax_tree_pose pose;
    sepax_pose of_b = posed(random_below(5), 30000);
    assert_works(sepax_tree_pose_make(&pose, tree, NULL, tree, &of_b, 0, &fault));
    size_t left = 100000;
    const sepax_tree_walk_options how = {.design = &design, .each = at_most, .context = &left};
    sepax_tree_run run;
    const uint8_t *const images[2] = {image, copy};
    if (sepax_tree_walk_images(images, (const uint8_t(*)[SEPAX_TREE_BODY_BYTES])record, &pose, &how,
                               &run, &fault)) {
      damaged += run.damaged;
    }
  }
  assert_true(damaged > count / 10);
  free(copy);
  sepax_tree_free(tree);
  free(t.tri);
}
