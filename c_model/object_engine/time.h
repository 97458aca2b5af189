/* SPDX-License-Identifier: MIT */
/* time.h - predicts when the object engine is done, by following the candidates from the comparator
 * lanes to the cores (private, docs/reference/object-engine.md). */
#ifndef SEPAX_OBJECT_TIME_H
#define SEPAX_OBJECT_TIME_H

#include "sepax_design.h"
#include "util/aabb.h"
#include "util/wide.h"

/* Between the lanes and the cores: a FIFO of candidate masks (of each only the number of its pairs
 * matters here, and of those that take two passes, which are the first that are picked), the mask
 * that the priority encoder empties, and the stages that fetch a pair.
 * On an FPGA all stages wait for the last one; else there are two, and the first fills on its own.
 */
enum { ENGINE_ENTRIES = 16 };
typedef struct {
  uint64_t pairs_of[ENGINE_ENTRIES];
  uint64_t twice_of[ENGINE_ENTRIES];
  uint64_t arrives[ENGINE_ENTRIES]; /* the cycle in which a mask comes out of the lanes */
  int first, count;                 /* with masks that are still in the lanes */
  int arrived;
  uint64_t picked; /* pairs left in the mask of the priority encoder */
  uint64_t twice;  /* of them with two passes */
  unsigned pairs;  /* bit k: stage k has a pair */
  unsigned both;   /* bit k: it takes two passes */
  unsigned last;   /* the bit of the last stage */
  bool together;   /* all stages wait for the last one */
  uint64_t now, last_taken;
  uint64_t ii, cores;
  int fullest;       /* the pair enumerator stops if the FIFO has more masks than this */
  bool late, free;   /* it learns that a cycle late; it may go on */
  uint64_t in_lanes; /* cycles of a mask from its step to the FIFO */
  uint64_t to_end;   /* cycles from the last stage to the end of a run, but for a core's latency */
  uint64_t free_at[SEPAX_CORES_MAX];
} engine_time;

static inline engine_time engine_time_begin(const sepax_config *config) {
  bool fpga = config->target != SEPAX_TARGET_ASIC;
  return (engine_time){.ii = (uint64_t)config->ii,
                       .cores = (uint64_t)config->cores,
                       .fullest = ENGINE_ENTRIES - (fpga ? 9 : 6),
                       .late = fpga,
                       .free = true,
                       .last = !fpga               ? 2U
                               : config->lanes > 1 ? 64U
                                                   : 8U,
                       .together = fpga,
                       .in_lanes = fpga ? 6 : 3,
                       .to_end = fpga ? 1 : 2};
}

static inline uint64_t *engine_first_free(engine_time *t) {
  uint64_t *free_at = &t->free_at[0];
  for (uint64_t k = 1; k < t->cores; k++) {
    free_at = t->free_at[k] < *free_at ? &t->free_at[k] : free_at;
  }
  return free_at;
}

/* The masks that came out of the lanes. */
static inline void engine_arrivals(engine_time *t) {
  while (t->arrived < t->count && t->arrives[(t->first + t->arrived) % ENGINE_ENTRIES] <= t->now) {
    t->arrived++;
  }
}

/* Can the first stage take a pair while the last one waits? */
static inline bool engine_fills(const engine_time *t) {
  return !t->together && (t->pairs & 1) == 0;
}

/* The bits of the stages behind a cycle. */
static inline unsigned engine_moved(const engine_time *t, unsigned bits, bool blocked) {
  return blocked ? bits : bits << 1 & (2 * t->last - 1);
}

static inline void engine_tick(engine_time *t) {
  const bool free_before = t->arrived <= t->fullest;
  t->now++;
  engine_arrivals(t);
  uint64_t *free_at = engine_first_free(t);
  bool blocked = (t->pairs & t->last) != 0;
  if (blocked && t->now >= *free_at) {
    *free_at = t->now + ((t->both & t->last) != 0 ? 2 : 1) * t->ii;
    t->last_taken = t->now;
    blocked = false;
  }
  if (!blocked || engine_fills(t)) {
    t->pairs = engine_moved(t, t->pairs, blocked) | (t->picked > 0);
    t->both = engine_moved(t, t->both, blocked) | (t->twice > 0);
    t->picked -= t->picked > 0;
    t->twice -= t->twice > 0;
  }
  if (t->picked == 0 && t->arrived > 0) {
    t->picked = t->pairs_of[t->first];
    t->twice = t->twice_of[t->first];
    t->first = (t->first + 1) % ENGINE_ENTRIES;
    t->count--;
    t->arrived--;
  }
  t->free = t->late ? free_before : t->arrived <= t->fullest;
}

/* Let up to `most` cycles pass in which nothing moves because all wait for a core. */
static inline uint64_t engine_wait(engine_time *t, uint64_t most) {
  bool waits = (t->pairs & t->last) != 0 && !(t->picked > 0 && engine_fills(t)) &&
               (t->picked > 0 || t->count == 0);
  uint64_t free_at = waits ? *engine_first_free(t) : 0;
  uint64_t cycles = free_at > t->now + 1 ? free_at - t->now - 1 : 0;
  cycles = cycles < most ? cycles : most;
  t->now += cycles;
  engine_arrivals(t);
  t->free = cycles > 0 ? t->arrived <= t->fullest : t->free;
  return cycles;
}

/* Let cycles pass until the pair enumerator may go on. */
static inline void engine_stall(engine_time *t) {
  while (!t->free) {
    engine_wait(t, UINT64_MAX);
    engine_tick(t);
  }
}

/* A step of the pair enumerator that finds so many candidates, at least 1, of which `twice` take
 * two passes. */
static inline void engine_step(engine_time *t, uint64_t pairs, uint64_t twice) {
  engine_stall(t);
  const int last = (t->first + t->count++) % ENGINE_ENTRIES;
  t->pairs_of[last] = pairs;
  t->twice_of[last] = twice;
  t->arrives[last] = t->now + 1 + t->in_lanes;
  engine_tick(t);
}

/* Steps of the pair enumerator that find no candidate. */
static inline void engine_idle(engine_time *t, uint64_t steps) {
  while (steps > 0) {
    engine_stall(t);
    if (t->count == 0 && t->picked == 0 && t->pairs == 0) {
      t->now += steps;
      return;
    }
    /* While masks come, the FIFO may fill. */
    steps -= engine_wait(t, t->count > t->fullest ? 0 : steps - 1) + 1;
    engine_tick(t);
  }
}

/* The cycle of the last verdict. If there is no verdict, then the end of the last step. */
static inline uint64_t engine_finish(engine_time *t, int latency) {
  uint64_t enumerated = t->now + t->in_lanes + 2;
  while (t->count > 0 || t->picked > 0 || t->pairs != 0) {
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

/* The triangle with z and the axis of the thinnest side exchanged. */
static inline sepax_tri engine_thin_along_z(const sepax_tri *t, const aabb *thin) {
  int thinnest = aabb_thinnest(thin);
  sepax_tri swapped;
  for (int k = 0; k < 3; k++) {
    const sepax_vec *v = &t->v[k];
    swapped.v[k] = (sepax_vec){thinnest == 0 ? v->z : v->x, thinnest == 1 ? v->z : v->y,
                               vec_component(v, thinnest)};
  }
  return swapped;
}

/* True if a pair needs two passes through a core without an AABB test: its six vertices are on one
 * line as seen along z. */
static inline bool engine_takes_two_passes(const sepax_tri *a, const sepax_tri *b) {
  wide dx = 0;
  wide dy = 0;
  for (int i = 1; i < 6; i++) {
    const sepax_vec *v = i < 3 ? &a->v[i] : &b->v[i - 3];
    wide x = (wide)v->x - a->v[0].x;
    wide y = (wide)v->y - a->v[0].y;
    if (dx * y != dy * x) {
      return false;
    }
    if (dx == 0 && dy == 0) {
      dx = x;
      dy = y;
    }
  }
  return true;
}

#endif
