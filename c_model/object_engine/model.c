/* SPDX-License-Identifier: MIT */
/* model.c - golden model of the object engine: the pairs that it finds, their order and the
 * approximate time (docs/reference/object-engine.md). */
#include "object_engine/time.h"
#include "design/engine_table.h"
#include "util/aabb.h"
#include "util/error.h"
#include "util/list.h"

/* The lowest `word` bits of a coordinate, as a signed number. A coordinate that fits is
 * unchanged. */
static int32_t wrapped(int64_t c, int word) {
  uint64_t high = UINT64_C(1) << (word - 1);
  uint64_t low = (uint64_t)c & (2 * high - 1);
  return (int32_t)((int64_t)(low ^ high) - (int64_t)high);
}

/* Triangle B after the move, as the cores see it. */
static sepax_tri moved(const sepax_tri *t, const int32_t move[3], int word) {
  sepax_tri m;
  for (int k = 0; k < 3; k++) {
    m.v[k] = (sepax_vec){wrapped((int64_t)t->v[k].x + move[0], word),
                         wrapped((int64_t)t->v[k].y + move[1], word),
                         wrapped((int64_t)t->v[k].z + move[2], word)};
  }
  return m;
}

typedef struct {
  const sepax_design *design;
  const sepax_tri *a, *b;
  const aabb *bounds_a, *bounds_b;
  const int32_t *move;
  sepax_object_run *run;
  size_t capacity;
  sepax_error *error;
} enumeration;

/* Judge a candidate, that is, a pair whose AABBs overlap. */
static bool judge(enumeration *e, size_t i, size_t j) {
  sepax_object_run *run = e->run;
  const sepax_config *c = &e->design->config;
  const sepax_pair pair = {.a = e->a[i], .b = moved(&e->b[j], e->move, c->word)};
  sepax_judgement v = sepax_judge(e->design, &pair);
  bool moved_out = !aabb_fits(&e->bounds_b[j], c->word);
  bool undecided = moved_out || v.axis == SEPAX_AXIS_EXTENT;
  bool collision = moved_out || v.collision;
  run->candidates++;
  bool warning = !collision && e->design->limits > 0 && v.band == SEPAX_BAND_WARNING;
  if (!collision && !warning) {
    return true;
  }
  run->out_of_range += undecided;
  run->first = collision && run->collisions == 0 ? run->found.count : run->first;
  run->collisions += collision;
  return list_add_pair(&run->found, &e->capacity, i, j) ||
         sepax_fail(e->error, SEPAX_ERROR_MEMORY, "out of memory for the pairs that collide");
}

/* One step: triangle j of B against the triangle of A in each lane. Lane k takes its triangle in
 * step k of a round and keeps it up to step k - 1 of the next round. */
static bool judge_step(enumeration *e, size_t round, size_t j, size_t count_a) {
  size_t lanes = (size_t)e->design->config.lanes;
  for (size_t k = 0; k < lanes; k++) {
    size_t n = round * lanes + k;
    if (j < k && n < lanes) {
      continue;
    }
    n -= j < k ? lanes : 0;
    if (n < count_a) {
      e->run->pairs++;
      if (!aabb_disjoint(&e->bounds_a[n], &e->bounds_b[j], e->design->margin[1]) &&
          !judge(e, n, j)) {
        return false;
      }
    }
  }
  return true;
}

static bool judge_all(enumeration *e, size_t count_a, size_t count_b) {
  const sepax_config *c = &e->design->config;
  size_t lanes = (size_t)c->lanes;
  size_t length = count_b > lanes ? count_b : lanes;
  size_t rounds = (count_a + lanes - 1) / lanes;
  size_t last = (count_a - 1) % lanes;
  engine_time t = engine_time_begin(c);
  for (size_t round = 0; round <= rounds; round++) {
    for (size_t j = 0; j < length && (round < rounds || j < last); j++) {
      uint64_t before = e->run->candidates;
      if (j < count_b && !judge_step(e, round, j, count_a)) {
        return false;
      }
      if (e->run->candidates > before) {
        engine_step(&t, e->run->candidates - before);
      } else {
        engine_idle(&t, 1);
      }
    }
  }
  e->run->cycles = engine_finish(&t, e->design->latency);
  return true;
}

bool sepax_object_engine(const sepax_design *design, const sepax_tri *a, size_t count_a,
                         const sepax_tri *b, size_t count_b, const int32_t move[3],
                         sepax_object_run *run, sepax_error *error) {
  *run = (sepax_object_run){0};
  if (sepax__config_engine(&design->config) != SEPAX_ENGINE_OBJECT || count_a == 0 ||
      count_b == 0 || count_a > (size_t)design->config.memory_a ||
      count_b > (size_t)design->config.memory_b) {
    return sepax_fail(
        error, SEPAX_ERROR_ARGUMENT,
        "engine: %zu and %zu triangles do not fit %d lanes with memories of %d and %d triangles; "
        "give 1 triangle or more, or larger memories",
        count_a, count_b, design->config.lanes, design->config.memory_a, design->config.memory_b);
  }
  aabb *bounds_a = malloc(count_a * sizeof *bounds_a);
  aabb *bounds_b = malloc(count_b * sizeof *bounds_b);
  bool ok = bounds_a != NULL && bounds_b != NULL;
  if (!ok) {
    sepax_fail(error, SEPAX_ERROR_MEMORY, "out of memory for the AABBs of %zu triangles",
               count_a + count_b);
  }
  for (size_t i = 0; i < count_a && ok; i++) {
    bounds_a[i] = aabb_of(&a[i]);
  }
  for (size_t j = 0; j < count_b && ok; j++) {
    bounds_b[j] = aabb_translated(aabb_of(&b[j]), move);
  }
  enumeration e = {design, a, b, bounds_a, bounds_b, move, run, 0, error};
  ok = ok && judge_all(&e, count_a, count_b);
  run->first = run->collisions > 0 ? run->first : run->found.count;
  free(bounds_a);
  free(bounds_b);
  if (!ok) {
    sepax_pairs_free(&run->found);
  }
  return ok;
}
