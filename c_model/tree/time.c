/* time.c - about when the tree engine does what the walk does. docs/tree.md, Time. */
#include "tree/time.h"

#include "tree/format.h"

/* Cycles: to look up a pair of nodes; of the least entry in the compare path; from the last box to
 * what is made of it; from a row to a pair; around cores. */
enum { LOOK_UP = 3, LEAST = 8, BEHIND_BOXES = 24, TO_PAIR = 12, AROUND_CORE = 8 };

static uint64_t later(uint64_t a, uint64_t b) { return a > b ? a : b; }

void tree_time_begin(tree_time *t, const sepax_config *config, int latency) {
  *t = (tree_time){.latency = (uint64_t)latency,
                   .ii = (uint64_t)config->ii,
                   .cores = (uint64_t)config->cores,
                   .per_box = config->ii == 1 || config->cores > 1 ? 1 : 2};
}

/* When a block of so many beats is there; it takes the place that was used longest ago. */
static uint64_t look_up(tree_time *t, time_place set[TIME_WAYS], uint32_t number, uint64_t beats,
                        uint64_t now) {
  time_place *place = &set[0];
  for (int k = 0; k < TIME_WAYS; k++) {
    if (set[k].number == number + 1) {
      set[k].used = ++t->uses;
      return later(now, set[k].there);
    }
    place = set[k].used < place->used ? &set[k] : place;
  }
  t->asked = later(now, t->asked + 1);
  t->bus = later(t->bus, t->asked + t->latency) + beats;
  *place = (time_place){number + 1, t->bus, ++t->uses};
  return t->bus;
}

uint64_t tree_time_move(tree_time *t, uint64_t now, const uint32_t node[2]) {
  uint64_t there = now + LOOK_UP;
  for (int body = 0; body < 2; body++) {
    time_place *set = t->node[body][node[body] % TIME_NODE_SETS];
    there = later(there, look_up(t, set, node[body], TREE_NODE_BYTES / TREE_BEAT, now + LOOK_UP));
  }
  return there;
}

uint64_t tree_time_finish(tree_time *t, uint64_t there, unsigned boxes) {
  uint64_t most = boxes * t->per_box;
  t->compare = later(t->compare, there) + (most > LEAST ? most : LEAST);
  return t->compare + BEHIND_BOXES;
}

static void take_pass(tree_time *t) {
  uint64_t *free_at = &t->free_at[0];
  for (uint64_t k = 1; k < t->cores; k++) {
    free_at = t->free_at[k] < *free_at ? &t->free_at[k] : free_at;
  }
  t->verdict = later(t->pairs + TO_PAIR, *free_at);
  *free_at = t->verdict + t->ii;
}

void tree_time_row(tree_time *t, uint64_t now, const uint32_t leaf[2], const int beats[2],
                   unsigned pairs, unsigned passes) {
  uint64_t *begun = &t->begun[t->rows++ % TIME_ROWS];
  t->compare = later(t->compare, *begun);
  uint64_t there = now;
  for (int body = 0; body < 2; body++) {
    time_place *set = t->leaf[body][leaf[body] % TIME_LEAF_SETS];
    there = later(there, look_up(t, set, leaf[body], (uint64_t)beats[body], now));
  }
  uint64_t least = 3;
  t->pairs = later(t->pairs, there);
  *begun = t->pairs;
  t->pairs += pairs > least ? pairs : least;
  for (unsigned n = 0; n < passes; n++) {
    take_pass(t);
  }
  uint64_t kept = TIME_PAIRS * t->ii;
  t->pairs = later(t->pairs, t->verdict > kept ? t->verdict - kept : 0);
}

uint64_t tree_time_end(const tree_time *t, const sepax_design *design) {
  uint64_t answered = t->verdict + AROUND_CORE + (uint64_t)design->latency;
  uint64_t walked = later(t->compare + BEHIND_BOXES, t->pairs + TO_PAIR);
  return t->verdict > 0 ? later(answered, walked) : walked;
}
