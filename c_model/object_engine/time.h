/* SPDX-License-Identifier: MIT */
/* time.h - predicts when the object engine is done, by following the candidates from the comparator
 * lanes to the cores (private, docs/reference/object-engine.md). */
#ifndef SEPAX_OBJECT_TIME_H
#define SEPAX_OBJECT_TIME_H

#include "sepax_design.h"

/* Buffers between the lanes and the cores: a FIFO of masks of candidates (only their number matters
 * here), the mask that the priority encoder empties, and the pairs that were
 * fetched. */
enum { ENGINE_ENTRIES = 16, ENGINE_FETCHED = 2 };
typedef struct {
  uint64_t mask[ENGINE_ENTRIES];
  int first, count;
  uint64_t picked; /* candidates left in the mask of the priority encoder */
  int fetched;
  uint64_t now, last_taken;
  uint64_t ii, cores;
  int fullest;      /* the pair enumerator stops if the FIFO has more masks than this */
  uint64_t to_fifo; /* register stages from the lanes to the FIFO */
  uint64_t to_end;  /* register stages from the FIFO to a core, and its latency */
  uint64_t free_at[SEPAX_CORES_MAX];
} engine_time;

static inline engine_time engine_time_begin(const sepax_config *config) {
  bool fpga = config->target != SEPAX_TARGET_ASIC;
  return (engine_time){.ii = (uint64_t)config->ii,
                       .cores = (uint64_t)config->cores,
                       .fullest = ENGINE_ENTRIES - (fpga ? 8 : 6),
                       .to_fifo = fpga ? 8 : 5,
                       .to_end = fpga ? (config->lanes > 1 ? 13 : 10) : 6};
}

static inline uint64_t *engine_first_free(engine_time *t) {
  uint64_t *free_at = &t->free_at[0];
  for (uint64_t k = 1; k < t->cores; k++) {
    free_at = t->free_at[k] < *free_at ? &t->free_at[k] : free_at;
  }
  return free_at;
}

static inline void engine_tick(engine_time *t) {
  t->now++;
  uint64_t *free_at = engine_first_free(t);
  if (t->fetched > 0 && t->now >= *free_at) {
    *free_at = t->now + t->ii;
    t->last_taken = t->now;
    t->fetched--;
  }
  if (t->picked > 0 && t->fetched < ENGINE_FETCHED) {
    t->picked--;
    t->fetched++;
  }
  if (t->picked == 0 && t->count > 0) {
    t->picked = t->mask[t->first];
    t->first = (t->first + 1) % ENGINE_ENTRIES;
    t->count--;
  }
}

/* Let up to `most` cycles pass in which nothing moves because all wait for a core. */
static inline uint64_t engine_wait(engine_time *t, uint64_t most) {
  bool waits = t->fetched == ENGINE_FETCHED ? t->picked > 0 || t->count == 0
                                            : t->fetched > 0 && t->picked == 0 && t->count == 0;
  uint64_t free_at = waits ? *engine_first_free(t) : 0;
  uint64_t cycles = free_at > t->now + 1 ? free_at - t->now - 1 : 0;
  cycles = cycles < most ? cycles : most;
  t->now += cycles;
  return cycles;
}

/* Let cycles pass until the pair enumerator may go on. */
static inline void engine_stall(engine_time *t) {
  while (t->count > t->fullest) {
    engine_wait(t, UINT64_MAX);
    engine_tick(t);
  }
}

/* A step of the pair enumerator that finds so many candidates, at least 1. */
static inline void engine_step(engine_time *t, uint64_t candidates) {
  engine_stall(t);
  t->mask[(t->first + t->count++) % ENGINE_ENTRIES] = candidates;
  engine_tick(t);
}

/* Steps of the pair enumerator that find no candidate. */
static inline void engine_idle(engine_time *t, uint64_t steps) {
  while (steps > 0) {
    engine_stall(t);
    if (t->count == 0 && t->picked == 0 && t->fetched == 0) {
      t->now += steps;
      return;
    }
    steps -= engine_wait(t, steps - 1) + 1;
    engine_tick(t);
  }
}

/* The cycle of the last verdict. If there is no verdict, then the end of the last step. */
static inline uint64_t engine_finish(engine_time *t, int latency) {
  uint64_t enumerated = t->now + t->to_fifo;
  while (t->count > 0 || t->picked > 0 || t->fetched > 0) {
    engine_wait(t, UINT64_MAX);
    engine_tick(t);
  }
  uint64_t answered = t->last_taken + t->to_end + (uint64_t)latency;
  return t->last_taken > 0 && answered > enumerated ? answered : enumerated;
}

/* The number of steps for these numbers of triangles (docs/reference/object-engine.md). */
static inline uint64_t engine_steps(uint64_t count_a, uint64_t count_b, uint64_t lanes) {
  uint64_t length = count_b > lanes ? count_b : lanes;
  return (count_a + lanes - 1) / lanes * length + (count_a - 1) % lanes;
}

/* The step in which triangle i of A meets triangle j of B: lane k takes its triangle in step k of a
 * round and keeps it up to step k - 1 of the next round. */
static inline uint64_t engine_step_of(uint64_t i, uint64_t j, uint64_t count_b, uint64_t lanes) {
  uint64_t length = count_b > lanes ? count_b : lanes;
  return (i / lanes + (j < i % lanes)) * length + j;
}

#endif
