/* SPDX-License-Identifier: MIT */
/* cycles.c - how many cycles a run of the object engine takes, register by register: pair
 * enumerator, lanes, FIFO of candidate masks, priority encoder, fetch, core
 * (docs/reference/object-engine.md). */
#include "bench.h"

#include <stdlib.h>

static int64_t least(int64_t x, int64_t y, int64_t z) {
  return x < y ? (x < z ? x : z) : (y < z ? y : z);
}

/* Whether the AABBs of a and of b, moved, are nearer to each other than the margin, or touch. */
static bool near(const sepax_tri *a, const sepax_tri *b, const int32_t move[3], int64_t margin) {
  for (int k = 0; k < 3; k++) {
    int64_t x[2][3];
    for (int i = 0; i < 3; i++) {
      const sepax_vec *v[2] = {&a->v[i], &b->v[i]};
      for (int s = 0; s < 2; s++) {
        x[s][i] = k == 0 ? v[s]->x : k == 1 ? v[s]->y : v[s]->z;
      }
      x[1][i] += move[k];
    }
    for (int s = 0; s < 2; s++) {
      int64_t high = -least(-x[s][0], -x[s][1], -x[s][2]);
      if (high + margin < least(x[!s][0], x[!s][1], x[!s][2])) {
        return false;
      }
    }
  }
  return true;
}

/* Masks of candidates, of which the numbers of pairs are kept, by their step. */
typedef struct {
  unsigned char *pairs; /* of the lanes in each step */
  bool *any;            /* B has a triangle in it */
  size_t count;
} steps;

static bool make_steps(steps *s, const sepax_tri *a, size_t count_a, const sepax_tri *b,
                       size_t count_b, const int32_t move[3], int64_t margin) {
  const size_t lanes = SEPAX_LANES;
  size_t length = count_b > lanes ? count_b : lanes;
  s->count = (count_a + lanes - 1) / lanes * length + (count_a - 1) % lanes;
  s->pairs = calloc(s->count, sizeof *s->pairs);
  s->any = calloc(s->count, sizeof *s->any);
  for (size_t n = 0; n < s->count && s->pairs != NULL && s->any != NULL; n++) {
    size_t j = n % length;
    s->any[n] = j < count_b;
    for (size_t k = 0; k < lanes && j < count_b; k++) {
      size_t i = n / length * lanes + k;
      if (j < k) { /* that of the round before */
        if (i < lanes) {
          continue;
        }
        i -= lanes;
      }
      s->pairs[n] =
          (unsigned char)(s->pairs[n] + (i < count_a && near(&a[i], &b[j], move, margin) ? 1 : 0));
    }
  }
  return s->pairs != NULL && s->any != NULL;
}

enum { ENTRIES = 16, FREE = ENTRIES - 6, TAKEN = 64 };

uint64_t cycles_of_run(const sepax_tri *a, size_t count_a, const sepax_tri *b, size_t count_b,
                       const int32_t move[3], int64_t margin) {
  const uint64_t rest = ((SEPAX_LATENCY - 3) / SEPAX_II + 2) * SEPAX_II; /* of an empty core */
  steps s;
  if (!make_steps(&s, a, count_a, b, count_b, move, margin)) {
    exit(2);
  }
  size_t made = 0; /* steps */
  bool running = true;
  bool stage[3] = {false};     /* a step is in the lanes */
  bool there = false;          /* B has a triangle in the last one */
  unsigned char mask[3] = {0}; /* its candidates, the last in the register of the mask */
  bool free_q = true;          /* of the FIFO */
  unsigned char entry[ENTRIES] = {0};
  unsigned head = 0;
  unsigned count = 0;
  unsigned left = 0;           /* pairs of the mask at the priority encoder */
  bool read = false;           /* a pair comes from the memories */
  bool out = false;            /* it stands before the core */
  uint64_t taken[TAKEN] = {0}; /* when pairs were */
  size_t first = 0;
  size_t end = 0;
  uint64_t last = 0; /* when a pair was taken last, 0: none */
  uint64_t now = 1;
  for (;; now++) {
    while (first < end && taken[first % TAKEN] + SEPAX_LATENCY <= now) {
      first++;
    }
    bool drained = !running && !stage[0] && !stage[1] && !stage[2] && count == 0 && left == 0 &&
                   !read && !out && first == end;
    if (drained) {
      break;
    }
    bool ready = last == 0 || (now - last) % SEPAX_II == 0 || now - last >= rest;
    bool each = SEPAX_II == 1;
    bool enable_2 = !out || (each && ready);
    bool enable_1 = !read || enable_2;
    bool take = left > 0 && enable_1;
    bool pop = count > 0 && (left == 0 || (take && left == 1));
    bool push = mask[2] > 0;
    bool step = running && free_q && made < s.count;
    if (out && ready) {
      last = now;
      taken[end++ % TAKEN] = now;
    }
    running = running && made < s.count;
    /* What the registers take. */
    out = enable_2 ? read : !ready;
    read = enable_1 ? left > 0 : read;
    left = pop ? entry[head] : left - take;
    head = (head + pop) % ENTRIES;
    count -= pop;
    entry[(head + count) % ENTRIES] = mask[2];
    count += push;
    free_q = count <= FREE;
    mask[2] = mask[1];
    mask[1] = mask[0];
    stage[2] = stage[1];
    stage[1] = stage[0] && there;
    stage[0] = step;
    if (step) {
      there = s.any[made];
      mask[0] = s.pairs[made];
      made++;
    } else {
      mask[0] = 0;
    }
  }
  free(s.pairs);
  free(s.any);
  return now + 1;
}
