/* SPDX-License-Identifier: MIT */
/* size.c - finds the design with the fewest gates that judges a scene in time.
 * docs/reference/size.md. */
#include "size/candidates.h"
#include "design/engine_table.h"
#include "sepax_tree.h"
#include "util/error.h"

#include <stdio.h>
#include <stdlib.h>

/* Cycles of a tree engine between a job and the next, without the latency of its memory. */
enum { BETWEEN = 40 };

bool sepax_size_cycles(uint64_t *cycles, const sepax_size *size, const sepax_config *config,
                       size_t pose, const sepax_size_request *request, sepax_error *error) {
  const candidate_kind *of = sepax__candidate_kind(config);
  if (of->cycles == NULL) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "cycles: they are not known for %s; choose another design",
                      sepax__engine_of(config)->name);
  }
  if (sepax__is_absent(size, pose)) {
    *cycles = 0;
    return true;
  }
  size_t near = (size_t)sepax__candidates_of(size, pose);
  uint64_t *steps = malloc((near + 1) * sizeof *steps);
  bool ok = steps != NULL
                ? of->cycles(cycles, size, config, pose, request, steps, error)
                : sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu candidates", near);
  free(steps);
  return ok;
}

/* The cycles of all pairs in a pose. The sum stops above the limit. */
static bool cycles_in_pose(const candidates *all, const sepax_config *config, size_t pose,
                           uint64_t limit, uint64_t *cycles, sepax_error *error) {
  const candidate_kind *of = sepax__candidate_kind(config);
  *cycles = of->waits ? all->list : 0;
  for (size_t n = 0; n < all->pairs && *cycles <= limit; n++) {
    uint64_t one;
    if (sepax__is_absent(&all->size[n], pose)) {
      continue;
    }
    if (!of->cycles(&one, &all->size[n], config, pose, all->request, all->steps, error)) {
      return false;
    }
    *cycles += one + (of->waits ? all->job : 0);
  }
  return true;
}

/* Find the slowest pose of a design, or any pose that takes more than `limit`. m->worst is the pose
 * to try first and becomes the slowest one. */
static bool try_poses(const candidates *all, sepax_sized_design *m, uint64_t limit,
                      sepax_error *error) {
  const candidate_kind *of = sepax__candidate_kind(&m->config);
  size_t poses = of->poses(all);
  size_t begin = m->worst;
  double sum = 0;
  m->cycles = 0;
  for (size_t n = 0; n < poses && m->cycles <= limit; n++) {
    size_t at = (begin + n) % poses;
    uint64_t cycles;
    if (!cycles_in_pose(all, &m->config, at, limit, &cycles, error)) {
      return false;
    }
    m->worst = n == 0 || cycles > m->cycles ? at : m->worst;
    m->cycles = cycles > m->cycles ? cycles : m->cycles;
    sum += (double)cycles;
  }
  m->mean = sum / (double)poses;
  return true;
}

static int by_gates(const void *p, const void *q) {
  const sepax_sized_design *a = p;
  const sepax_sized_design *b = q;
  return a->gates != b->gates ? (a->gates > b->gates) - (a->gates < b->gates)
                              : (a->cycles > b->cycles) - (a->cycles < b->cycles);
}

/* Sort by the bound of the cycles. Of equal bounds the design with more gates comes first, because
 * it is likely to be faster. */
static int by_cycles(const void *p, const void *q) {
  const sepax_sized_design *a = p;
  const sepax_sized_design *b = q;
  return a->cycles != b->cycles ? (a->cycles > b->cycles) - (a->cycles < b->cycles)
                                : by_gates(q, p);
}

/* What cannot be made. */
typedef struct {
  sepax_sized_design design; /* the first; config.word is 0 if there is none */
  sepax_error why;
  bool seen[SEPAX_ENGINE_COUNT][SEPAX_II_MAX + 1][2]; /* by engine, II, extents */
} refusal;

static bool *refusal_of(refusal *refused, const sepax_config *c) {
  return &refused->seen[sepax__config_engine(c)][c->ii][c->extent_a > 0];
}

/* Ask whether the design can be made. */
static bool plan(const candidates *all, sepax_sized_design *m, bool *made, refusal *refused,
                 sepax_error *error) {
  sepax_design design;
  sepax_error why = {0};
  *made = all->request->plan == NULL;
  if (*made) {
    return true;
  }
  if (!sepax_design_init(&design, &m->config, error)) {
    return false;
  }
  *made = all->request->plan(&design, &m->gates, &m->gates_error, &why);
  if (!*made && why.code != SEPAX_ERROR_ARGUMENT) {
    *error = why;
    return false;
  }
  if (!*made && refused->design.config.word == 0) {
    refused->design = *m;
    refused->why = why;
  }
  *refusal_of(refused, &m->config) = !*made;
  return true;
}

/* The smallest design that takes at most `limit` cycles in every pose and can be made. If there is
 * none, then best->config.word is 0, and *refused has the smallest that cannot be made. Poses that
 * were slow before are tried first. */
static bool find_cheapest(candidates *all, uint64_t limit, sepax_sized_design *best,
                          refusal *refused, sepax_error *error) {
  size_t pose[SEPAX_ENGINE_COUNT] = {0};
  bool made = false;
  best->config.word = 0;
  qsort(all->design, all->count, sizeof *all->design, by_gates);
  for (size_t n = 0; n < all->count; n++) {
    sepax_sized_design m = all->design[n];
    size_t *worst = &pose[sepax__config_engine(&m.config)];
    if (!*refusal_of(refused, &m.config) && m.cycles <= limit &&
        sepax__candidate_kind(&m.config)->poses(all) > 0) {
      m.worst = *worst;
      if (!try_poses(all, &m, limit, error)) {
        return false;
      }
      *worst = m.worst;
      if (m.cycles <= limit && !plan(all, &m, &made, refused, error)) {
        return false;
      }
      if (m.cycles <= limit && made) {
        *best = m;
        return true;
      }
    }
  }
  return true;
}

/* The fewest cycles of all designs. If workloads were not computed, then a bound that no design can
 * beat. */
static bool find_fewest(candidates *all, uint64_t *fewest, sepax_error *error) {
  size_t pose[SEPAX_ENGINE_COUNT] = {0};
  *fewest = UINT64_MAX;
  qsort(all->design, all->count, sizeof *all->design, by_cycles);
  for (size_t n = 0; n < all->count && all->design[n].cycles < *fewest; n++) {
    sepax_sized_design m = all->design[n];
    size_t *worst = &pose[sepax__config_engine(&m.config)];
    m.worst = *worst;
    if (sepax__candidate_kind(&m.config)->poses(all) > 0 && !try_poses(all, &m, *fewest, error)) {
      return false;
    }
    *worst = m.worst;
    *fewest = m.cycles < *fewest ? m.cycles : *fewest;
  }
  return true;
}

static bool too_slow(candidates *all, double period, sepax_sized_design *sized,
                     sepax_error *error) {
  const sepax_size_request *r = all->request;
  uint64_t fewest;
  char kinds[64] = "tree engine";
  if (r->lanes_least <= r->lanes_most) {
    snprintf(kinds, sizeof kinds, "design of up to %d lanes%s", r->lanes_most,
             all->work != NULL ? " or a tree" : "");
  }
  if (!find_fewest(all, &fewest, error)) {
    return false;
  }
  *sized = (sepax_sized_design){.cycles = fewest, .seconds = (double)fewest * period};
  return sepax_fail(
      error, SEPAX_ERROR_NONE_FITS,
      "time: %.4g ms is too short: at a clock of %g ns the fastest %s takes %.4g ms; allow more "
      "time, or coarsen the meshes",
      1e3 * r->seconds, 1e9 * period, kinds, 1e3 * sized->seconds);
}

static bool choose(candidates *all, sepax_sized_design *sized, sepax_error *error) {
  double period = all->request->clock_ps * 1e-12;
  double limit = all->request->seconds / period * (1 + 1e-9);
  sepax_sized_design best;
  refusal refused = {.why = {0}};
  if (!find_cheapest(all, limit < 0x1p63 ? (uint64_t)limit : UINT64_MAX, &best, &refused, error)) {
    return false;
  }
  if (best.config.word == 0 && refused.design.config.word == 0) {
    return too_slow(all, period, sized, error);
  }
  if (best.config.word == 0) {
    *sized = refused.design;
    sized->seconds = (double)sized->cycles * period;
    *error = refused.why;
    return false;
  }
  best.seconds = (double)best.cycles * period;
  *sized = best;
  return true;
}

static bool size_all(candidates *all, sepax_sized_design *sized, sepax_error *error) {
  *sized = (sepax_sized_design){.cycles = 0};
  bool ok = sepax__candidates_find(all, error) && choose(all, sized, error);
  sepax__candidates_free(all);
  return ok;
}

bool sepax_size_design(sepax_sized_design *sized, const sepax_size *size,
                       const sepax_size_request *request, sepax_error *error) {
  candidates all = {.size = size, .pairs = 1, .request = request};
  return size_all(&all, sized, error);
}

bool sepax_size_pairs(sepax_sized_design *sized, const sepax_size *size, size_t pairs,
                      const sepax_size_request *request, sepax_error *error) {
  uint64_t latency = (uint64_t)(request->latency > 0 ? request->latency : SEPAX_TREE_LATENCY);
  candidates all = {
      .size = size, .pairs = pairs, .job = BETWEEN + latency, .list = latency, .request = request};
  return size_all(&all, sized, error);
}
