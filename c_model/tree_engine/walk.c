/* SPDX-License-Identifier: MIT */
/* walk.c - the walk down two trees: which pairs the tree engine tests, in which order, and its
 * counters (docs/reference/tree-engine.md, Order). */
#include "tree_engine/time.h"
#include "tree_engine/tree.h"
#include "tree_engine/walk.h"

#include "util/error.h"

#include <stdlib.h>
#include <string.h>

/* An entry. With mask 0, S's own box is turned. */
typedef struct {
  uint32_t s, t;
  uint16_t mask;
  uint8_t side;
  uint64_t there; /* predicted cycle in which its nodes are here */
} entry;

static uint16_t half(uint16_t mask) {
  int ones = 0;
  for (int k = 0; k < TREE_FAN_OUT; k++) {
    ones += mask >> k & 1;
  }
  return ones > TREE_FAN_OUT / 2 ? 0 : mask;
}

typedef struct {
  tree_image tree[2]; /* A, B */
  const sepax_tree_pose *pose;
  const sepax_tree_walk_options *how;
  sepax_tree_run *run;
  size_t line_most, stack_most, height;
  entry *line, *stack; /* the line is a ring */
  size_t oldest, in_line, in_stack;
  tree_time time;
  uint64_t now; /* predicted cycle in which the current entry is finished */
} walk;

static bool damaged(walk *w) {
  w->run->damaged = true;
  return false;
}

/* Read a node of a body. False, with run->damaged, if it is damaged. */
static bool read_node(walk *w, tree_node *node, int body, uint32_t number) {
  const tree_image *tree = &w->tree[body];
  if (number >= tree->nodes) {
    return damaged(w);
  }
  *node = sepax__tree_unpack(tree->image + (size_t)TREE_NODE_BYTES * number,
                             w->how->design->config.word);
  return sepax__tree_node_sound(tree, node, number) || damaged(w);
}

static bool push(walk *w, entry e) {
  if (w->in_stack == w->stack_most) {
    return damaged(w);
  }
  w->stack[w->in_stack++] = e;
  w->run->deepest = w->in_stack > w->run->deepest ? w->in_stack : w->run->deepest;
  return true;
}

/* -------------------------------------------------------------------- pairs */

static void judge(walk *w, sepax_tree_pair *p, const tree_pair *tested, const int32_t a[3][3],
                  const int32_t b[3][3]) {
  sepax_pair pair = {.a = sepax__tree_thin_along_z(a, tested->thinnest),
                     .b = sepax__tree_thin_along_z(b, tested->thinnest)};
  p->out_of_range = tested->out_of_range;
  p->collision = true;
  p->band = SEPAX_BAND_COLLISION;
  if (!tested->out_of_range) {
    sepax_judgement v = sepax_judge(w->how->design, &pair);
    p->collision = v.collision;
    p->coplanar = v.coplanar;
    p->band = v.band;
  }
}

static bool count_near(walk *w, const sepax_tree_pair *p) {
  sepax_tree_run *run = w->run;
  run->near++;
  run->out_of_range += p->out_of_range;
  run->warnings += w->how->design->limits > 0 && !p->collision && p->band == SEPAX_BAND_WARNING;
  if (p->collision && run->collisions++ == 0) {
    run->found = *p;
  }
  bool enough = w->how->each != NULL && !w->how->each(w->how->context, p);
  run->ended = enough || (w->how->first && p->collision);
  return !run->ended;
}

static bool serve_row(walk *w, const uint32_t leaf[2], const tree_node *node_a,
                      const tree_node *node_b, int b, uint16_t mask) {
  int word = w->how->design->config.word;
  const uint8_t *record_a = w->tree[0].image + (size_t)TREE_BEAT * node_a->record;
  const uint8_t *record_b = w->tree[1].image + (size_t)TREE_BEAT * node_b->record;
  int32_t own[3][3];
  int32_t turned[3][3];
  w->run->rows++;
  uint64_t pairs = w->run->pairs;
  uint64_t near = w->run->near;
  if (!sepax__tree_triangle(own, record_b, node_b->beats, b, word)) {
    return damaged(w);
  }
  for (int k = 0; k < 3; k++) {
    sepax__tree_turn_vertex(turned[k], &w->pose->side[0], own[k]);
  }
  for (int a = 0; a < TREE_FAN_OUT; a++) {
    if ((mask >> a & 1) == 0) {
      continue;
    }
    w->run->pairs++;
    int32_t v[3][3];
    if (!sepax__tree_triangle(v, record_a, node_a->beats, a, word)) {
      return damaged(w);
    }
    tree_pair tested = sepax__tree_test_pair(v, turned, w->how->design->margin[1], word);
    if (tested.near) {
      sepax_tree_pair p = {.triangle = {node_a->first + (uint32_t)a, node_b->first + (uint32_t)b},
                           .leaf = {leaf[0], leaf[1]},
                           .child = {a, b}};
      judge(w, &p, &tested, v, turned);
      if (!count_near(w, &p)) {
        break;
      }
    }
  }
  const time_row row = {.now = w->now,
                        .leaf = {leaf[0], leaf[1]},
                        .beats = {node_a->beats, node_b->beats},
                        .corners = record_b[2 * b] | (uint32_t)record_b[2 * b + 1] << 8,
                        .pairs = (unsigned)(w->run->pairs - pairs),
                        .near = (unsigned)(w->run->near - near)};
  sepax__tree_time_row(&w->time, &row);
  return !w->run->ended;
}

/* ------------------------------------------------------------------ entries */

static bool finish_rows(walk *w, const entry *e, const tree_node *s, const tree_node *t,
                        const uint16_t hit[TREE_FAN_OUT], const uint16_t column[TREE_FAN_OUT]) {
  const uint16_t *mask = e->side == 0 ? hit : column;
  const tree_node *a = e->side == 0 ? t : s;
  const tree_node *b = e->side == 0 ? s : t;
  const uint32_t leaf[2] = {e->side == 0 ? e->t : e->s, e->side == 0 ? e->s : e->t};
  for (int k = 0; k < TREE_FAN_OUT; k++) {
    if (mask[k] != 0 && !serve_row(w, leaf, a, b, k, mask[k])) {
      return false;
    }
  }
  return true;
}

static bool finish_own(walk *w, const entry *e, const tree_node *s, const tree_node *t) {
  tree_setting setting = sepax__tree_set_up(&w->pose->side[e->side], s, t);
  int8_t low[3];
  for (int i = 0; i < 3; i++) {
    low[i] = (int8_t)(-1 - s->own[i]);
  }
  tree_cells box = sepax__tree_turn_box(&setting, low, s->own);
  uint16_t hit = sepax__tree_hits(&box, t);
  w->run->entries++;
  w->run->steps++;
  w->now = sepax__tree_time_finish(&w->time, e->there, 1);
  return hit == 0 || push(w, (entry){e->t, e->s, hit, !e->side, 0});
}

/* Bit i of column[j] is bit j of hit[i]. */
static void turn_masks(const uint16_t hit[TREE_FAN_OUT], uint16_t column[TREE_FAN_OUT]) {
  memset(column, 0, TREE_FAN_OUT * sizeof *column);
  for (int i = 0; i < TREE_FAN_OUT; i++) {
    for (int j = 0; hit[i] >> j != 0; j++) {
      column[j] = (uint16_t)(column[j] | (hit[i] >> j & 1) << i);
    }
  }
}

static bool finish(walk *w, const entry *e) {
  tree_node s;
  tree_node t;
  if (!read_node(w, &s, e->side == 0 ? 1 : 0, e->s) || !read_node(w, &t, e->side, e->t)) {
    return false;
  }
  if (e->mask == 0) {
    return finish_own(w, e, &s, &t);
  }
  tree_setting setting = sepax__tree_set_up(&w->pose->side[e->side], &s, &t);
  uint16_t hit[TREE_FAN_OUT] = {0};
  uint16_t column[TREE_FAN_OUT];
  const tree_lanes lanes = tree_lanes_of(&t);
  uint64_t steps = w->run->steps;
  for (int i = 0; i < TREE_FAN_OUT; i++) {
    if ((e->mask >> i & 1) != 0) {
      tree_cells box = sepax__tree_turn_box(&setting, s.low[i], s.high[i]);
      hit[i] = tree_lanes_hits(&lanes, &box);
      w->run->steps++;
    }
  }
  if (s.level == 0) {
    turn_masks(hit, column);
  }
  w->run->entries++;
  w->now = sepax__tree_time_finish(&w->time, e->there, (unsigned)(w->run->steps - steps));
  if (s.level == 0 && t.level == 0) {
    return finish_rows(w, e, &s, &t, hit, column);
  }
  for (uint32_t k = 0; k < TREE_FAN_OUT; k++) {
    uint16_t mask = s.level > 0 ? hit[k] : column[k];
    entry next = s.level > 0 ? (entry){e->t, s.first + k, half(mask), !e->side, 0}
                             : (entry){e->s, t.first + k, half(mask), e->side, 0};
    if (mask != 0 && !push(w, next)) {
      return false;
    }
  }
  return true;
}

static void move(walk *w, entry e) {
  const uint32_t node[2] = {e.side == 0 ? e.t : e.s, e.side == 0 ? e.s : e.t};
  e.there = sepax__tree_time_move(&w->time, w->now, node);
  w->line[(w->oldest + w->in_line++) % w->line_most] = e;
}

static void fill_line(walk *w) {
  while (
      w->in_stack > 0 && w->in_line < w->line_most &&
      (w->in_line == 0 || w->in_stack + 16 * (w->in_line + 1) + 15 * w->height <= w->stack_most)) {
    move(w, w->stack[--w->in_stack]);
  }
}

static bool serve_first(walk *w, const sepax_tree_pair *p) {
  tree_node a;
  tree_node b;
  return read_node(w, &a, 0, p->leaf[0]) && read_node(w, &b, 1, p->leaf[1]) &&
         ((a.level == 0 && b.level == 0) || damaged(w)) &&
         serve_row(w, p->leaf, &a, &b, p->child[1], (uint16_t)(1 << p->child[0]));
}

static void walk_all(walk *w, const tree_node *root_b) {
  if (w->how->row != NULL && !serve_first(w, w->how->row)) {
    return;
  }
  move(w, (entry){0, 0, half((uint16_t)((1U << root_b->children) - 1)), 0, 0});
  while (w->in_line > 0) {
    entry e = w->line[w->oldest];
    if (!finish(w, &e)) {
      return;
    }
    w->oldest = (w->oldest + 1) % w->line_most;
    w->in_line--;
    fill_line(w);
  }
}

/* All nodes are inside the images. */
static bool walk_trees(const tree_image tree[2], const sepax_tree_pose *pose,
                       const sepax_tree_walk_options *how, sepax_tree_run *run,
                       sepax_error *error) {
  walk w = {.tree = {tree[0], tree[1]},
            .pose = pose,
            .how = how,
            .run = run,
            .line_most = how->line > 0 ? how->line : SEPAX_TREE_LINE,
            .stack_most = how->stack > 0 ? how->stack : SEPAX_TREE_STACK};
  *run = (sepax_tree_run){0};
  tree_node root[2];
  if (!read_node(&w, &root[0], 0, 0) || !read_node(&w, &root[1], 1, 0)) {
    return true;
  }
  w.height = (size_t)root[0].level + (size_t)root[1].level;
  if (w.stack_most < 15 * w.height + 16) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "trees of %d and %d levels need a stack of %zu entries, not %zu",
                      root[0].level, root[1].level, 15 * w.height + 16, w.stack_most);
  }
  w.line = malloc((w.line_most + w.stack_most) * sizeof *w.line);
  if (w.line == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for a stack of %zu entries",
                      w.stack_most);
  }
  w.stack = w.line + w.line_most;
  sepax__tree_time_begin(&w.time, &how->design->config,
                         how->latency > 0 ? how->latency : SEPAX_TREE_LATENCY);
  walk_all(&w, &root[1]);
  run->cycles = sepax__tree_time_end(&w.time, how->design);
  free(w.line);
  return true;
}

static tree_image image_of(const uint8_t *image, const uint8_t *record) {
  return (tree_image){image, bytes_get32(record + 8), bytes_get32(record + 12),
                      bytes_get32(record + 16)};
}

bool sepax_tree_walk_images(const uint8_t *const image[2],
                            const uint8_t record[2][SEPAX_TREE_BODY_BYTES],
                            const sepax_tree_pose *pose, const sepax_tree_walk_options *how,
                            sepax_tree_run *run, sepax_error *error) {
  const tree_image tree[2] = {image_of(image[0], record[0]), image_of(image[1], record[1])};
  for (int i = 0; i < 2; i++) {
    if (tree[i].nodes == 0 ||
        (uint64_t)tree[i].nodes * (TREE_NODE_BYTES / TREE_BEAT) > tree[i].beats) {
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "body %c: %u nodes are not in an image of %u bytes", "AB"[i], tree[i].nodes,
                        TREE_BEAT * tree[i].beats);
    }
  }
  return walk_trees(tree, pose, how, run, error);
}

bool sepax_tree_walk(const sepax_tree *a, const sepax_tree *b, const sepax_tree_pose *pose,
                     const sepax_tree_walk_options *how, sepax_tree_run *run, sepax_error *error) {
  const tree_image tree[2] = {tree_image_of(a), tree_image_of(b)};
  int word = a->grid.word > b->grid.word ? a->grid.word : b->grid.word;
  if (word > how->design->config.word) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "a tree of %d bits is beyond the %d bits of the design", word,
                      how->design->config.word);
  }
  return walk_trees(tree, pose, how, run, error);
}
