/* SPDX-License-Identifier: MIT */
/* time.c - predicts the cycles of the tree engine (docs/reference/tree-engine.md, Time). */
#include "tree_engine/time.h"

#include "tree_engine/format.h"

/* Cycles of
 *   LOOK_UP       looking up a pair of nodes
 *   LEAST         an entry with one box in the compare path
 *   BEHIND_BOXES  from the last box of an entry to its last push or row
 *   MADE          from the last beat of a record to its triangles
 *   TO_PAIR       from a row to its first tested pair
 *   AROUND_CORE   queues before and after a core
 *   NEXT_PAIR     from one near pair to the next
 *   BEHIND_ROW    after each row
 * for an ASIC, then for an FPGA, which has more pipeline registers. */
enum { LOOK_UP, LEAST, BEHIND_BOXES, MADE, TO_PAIR, AROUND_CORE, NEXT_PAIR, BEHIND_ROW, SPANS };
static const uint64_t spans[2][SPANS] = {{3, 6, 24, 16, 12, 8, 0, 0}, {4, 9, 36, 17, 18, 9, 2, 1}};

static uint64_t later(uint64_t a, uint64_t b) { return a > b ? a : b; }

void sepax__tree_time_begin(tree_time *t, const sepax_config *config, int latency) {
  *t = (tree_time){.span = spans[config->target != SEPAX_TARGET_ASIC],
                   .latency = (uint64_t)latency,
                   .ii = (uint64_t)config->ii,
                   .cores = (uint64_t)config->cores,
                   .most_rows = (uint64_t)config->rows,
                   .most_leaves = (uint64_t)config->leaves};
}

/* Look up a block of `beats` beats in a set of a cache. If the block is not there, it replaces the
 * block that was used longest ago, and it is read over the bus. Returns its place; place->there is
 * the cycle from which on it can be used. */
static time_place *look_up(tree_time *t, time_place set[TIME_WAYS], uint32_t number, uint64_t beats,
                           uint64_t now) {
  time_place *place = &set[0];
  for (int k = 0; k < TIME_WAYS; k++) {
    if (set[k].number == number + 1) {
      set[k].used = ++t->uses;
      return &set[k];
    }
    place = set[k].used < place->used ? &set[k] : place;
  }
  t->asked = later(later(now, place->released), t->asked + 1);
  t->bus = later(t->bus, t->asked + t->latency) + beats;
  *place = (time_place){.number = number + 1, .there = t->bus, .used = ++t->uses};
  return place;
}

uint64_t sepax__tree_time_move(tree_time *t, uint64_t now, const uint32_t node[2]) {
  uint64_t there = now + t->span[LOOK_UP];
  for (int body = 0; body < 2; body++) {
    time_place *set = t->node[body][node[body] % TIME_NODE_SETS];
    there = later(
        there,
        look_up(t, set, node[body], TREE_NODE_BYTES / TREE_BEAT, now + t->span[LOOK_UP])->there);
  }
  return there;
}

uint64_t sepax__tree_time_finish(tree_time *t, uint64_t there, unsigned boxes) {
  t->compare = later(t->compare, there) + later(boxes, t->span[LEAST]);
  return t->compare + t->span[BEHIND_BOXES];
}

static void take_pair(tree_time *t, uint64_t tested) {
  uint64_t *free_at = &t->free_at[0];
  for (uint64_t k = 1; k < t->cores; k++) {
    free_at = t->free_at[k] < *free_at ? &t->free_at[k] : free_at;
  }
  t->verdict = later(later(tested + t->span[TO_PAIR], *free_at), t->verdict + t->span[NEXT_PAIR]);
  *free_at = t->verdict + t->ii;
}

/* Release the pair of leaves of the row before, and ask for the pair of this row. */
static void take_leaves(tree_time *t, const time_row *row) {
  uint64_t *released = &t->released[t->pairs_of_leaves % t->most_leaves];
  uint64_t now = later(row->now, *released);
  t->compare = later(t->compare, *released);
  t->leaves_there = now;
  if (t->places[0] != NULL) {
    t->released[(t->pairs_of_leaves + t->most_leaves - 1) % t->most_leaves] = t->pairs;
    t->places[0]->released = t->places[1]->released = t->pairs;
  }
  for (int body = 0; body < 2; body++) {
    time_place *set = t->leaf[body][row->leaf[body] % (t->most_leaves / TIME_WAYS)];
    t->places[body] = look_up(t, set, row->leaf[body], (uint64_t)row->beats[body], now);
    t->leaves_there = later(t->leaves_there, t->places[body]->there + t->span[MADE]);
    t->leaves[body] = row->leaf[body] + 1;
  }
  t->pairs_of_leaves++;
}

/* The number of vertices that the row before does not have; at least 1. */
static uint64_t to_turn(uint32_t corners, uint32_t before) {
  uint64_t fresh = 0;
  for (int k = 0; k < 15; k += 5) {
    bool found = false;
    for (int j = 0; j < 15; j += 5) {
      found = found || ((corners >> k ^ before >> j) & 31) == 0;
    }
    fresh += !found;
  }
  return fresh > 0 ? fresh : 1;
}

void sepax__tree_time_row(tree_time *t, const time_row *row) {
  uint64_t *begun = &t->begun[t->rows++ % t->most_rows];
  t->compare = later(t->compare, *begun);
  uint64_t least = 3;
  if (row->leaf[0] + 1 != t->leaves[0] || row->leaf[1] + 1 != t->leaves[1]) {
    take_leaves(t, row);
  } else {
    least = to_turn(row->corners, t->corners);
  }
  t->corners = row->corners;
  t->pairs = later(t->pairs, t->leaves_there);
  *begun = t->pairs;
  t->pairs += later(row->pairs, least) + t->span[BEHIND_ROW];
  for (unsigned n = 0; n < row->near; n++) {
    take_pair(t, *begun + n);
  }
  uint64_t kept = TIME_PAIRS * t->ii;
  t->pairs = later(t->pairs, t->verdict > kept ? t->verdict - kept : 0);
}

uint64_t sepax__tree_time_end(const tree_time *t, const sepax_design *design) {
  uint64_t answered = t->verdict + t->span[AROUND_CORE] + (uint64_t)design->latency;
  uint64_t walked = later(t->compare + t->span[BEHIND_BOXES], t->pairs + t->span[TO_PAIR]);
  return t->verdict > 0 ? later(answered, walked) : walked;
}
