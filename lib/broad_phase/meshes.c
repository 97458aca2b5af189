/* SPDX-License-Identifier: MIT */
/* meshes.c - all colliding pairs of two meshes. Candidates come from their AABBs (halves.c) or are
 * all pairs. They are judged many at a time by one or more threads. */
#include "broad_phase/search.h"
#include "body/body.h"
#include "mesh/mesh.h"
#include "util/memory.h"
#include "util/aabb.h"
#include "util/options.h"
#include "util/list.h"
#include "util/threads.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { BLOCK = 64, PART = 64 * 64, DIGIT = 10 };

/* ------------------------------------------------------------------ candidates */

/* Record a pair. False if the search ends with it, or has ended: candidates that still wait when
 * the first pair is found are judged, too. */
static bool record(worker *w, size_t i, size_t j) {
  if (w->all->how.first && w->found.count > 0) {
    return false;
  }
  w->no_memory |= !list_add_pair(&w->found, &w->capacity, i, j);
  bool ends = w->no_memory || w->all->how.first;
  if (ends) {
    atomic_store(&w->all->stop, true);
  }
  return !ends;
}

static void gather_candidates(const worker *w, int32_t c[2][3][3][BATCH], sepax_columns of[2]) {
  for (int k = 0; k < 2; k++) {
    for (size_t n = 0; n < w->waiting; n++) {
      const sepax_tri *t = &w->all->tri[k][w->candidate[n][k]];
      for (int v = 0; v < 3; v++) {
        c[k][v][0][n] = t->v[v].x;
        c[k][v][1][n] = t->v[v].y;
        c[k][v][2][n] = t->v[v].z;
      }
    }
    for (int v = 0; v < 9; v++) {
      of[k].c[v / 3][v % 3] = c[k][v / 3][v % 3];
    }
  }
}

void sepax__search_judge_candidates(worker *w) {
  const search *s = w->all;
  size_t count = w->waiting;
  uint64_t hits = 0;
  if (count == 0) {
    return;
  }
  if (s->facet[0] != NULL) {
    uint64_t exact;
    hits = sepax__judge_posed_pairs(&s->posed, w->candidate, (int)count, &exact);
  } else if (s->judge == NULL) {
    int32_t c[2][3][3][BATCH];
    sepax_columns of[2];
    gather_candidates(w, c, of);
    sepax_exact_pairs(s->how.simd, &of[0], &of[1], count, &hits);
  } else {
    for (size_t n = 0; n < count; n++) {
      const sepax_tri *a = &s->tri[0][w->candidate[n][0]];
      const sepax_tri *b = &s->tri[1][w->candidate[n][1]];
      hits |= (uint64_t)s->judge(s->context, a, b) << n;
    }
  }
  w->waiting = 0;
  for (bool on = true; on && hits != 0; hits &= hits - 1) {
    const uint32_t *pair = w->candidate[__builtin_ctzll(hits)];
    on = record(w, pair[0], pair[1]);
  }
}

void sepax__search_add_candidate(worker *w, uint32_t i, uint32_t j) {
  w->candidate[w->waiting][0] = i;
  w->candidate[w->waiting++][1] = j;
  if (w->waiting == BATCH) {
    sepax__search_judge_candidates(w);
  }
}

/* ----------------------------------------------------------------- brute force */

static bool fill_columns(search *s) {
  size_t count = s->count[1];
  int32_t *x = sepax_allocate(9 * count * sizeof *x);
  s->column = x;
  for (int k = 0; k < 9 && x != NULL; k++) {
    s->columns.c[k / 3][k % 3] = x + (size_t)k * count;
    for (size_t n = 0; n < count; n++) {
      x[(size_t)k * count + n] = vec_component(&s->tri[1][n].v[k / 3], k % 3);
    }
  }
  return x != NULL;
}

static bool brute_force_begin(search *s) {
  s->parts = (s->count[1] + PART - 1) / PART;
  s->total = (s->count[0] + BLOCK - 1) / BLOCK * s->parts;
  atomic_init(&s->next, 0);
  return s->facet[0] != NULL || fill_columns(s);
}

/* Judge one triangle of A against `many` triangles of B. */
static void judge_one(worker *w, size_t i, size_t from, size_t many) {
  const search *s = w->all;
  uint64_t bits[PART / 64];
  sepax_columns columns;
  for (int k = 0; k < 9; k++) {
    columns.c[k / 3][k % 3] = s->columns.c[k / 3][k % 3] + from;
  }
  sepax_exact_one_to_many(s->how.simd, &s->tri[0][i], &columns, many, bits);
  for (size_t m = 0; m < (many + 63) / 64; m++) {
    for (uint64_t word = bits[m]; word != 0; word &= word - 1) {
      if (!record(w, i, from + 64 * m + (size_t)__builtin_ctzll(word))) {
        return;
      }
    }
  }
}

static void judge_one_posed(worker *w, size_t i, size_t from, size_t many) {
  for (size_t j = from; j < from + many; j++) {
    sepax__search_add_candidate(w, (uint32_t)i, (uint32_t)j);
  }
  sepax__search_judge_candidates(w);
}

static void judge_one_with_margin(worker *w, size_t i, size_t from, size_t many) {
  const search *s = w->all;
  aabb a = aabb_of(&s->tri[0][i]);
  for (size_t j = from; j < from + many; j++) {
    aabb b = aabb_of(&s->tri[1][j]);
    if (!aabb_disjoint(&a, &b, s->margin)) {
      sepax__search_add_candidate(w, (uint32_t)i, (uint32_t)j);
    }
  }
  sepax__search_judge_candidates(w);
}

/* Judge a block of A against a part of B. */
static void brute_force_task(worker *w, size_t task) {
  const search *s = w->all;
  size_t first = task / s->parts * BLOCK;
  size_t from = task % s->parts * PART;
  size_t many = from + PART < s->count[1] ? PART : s->count[1] - from;
  for (size_t i = first; i < first + BLOCK && i < s->count[0] && !atomic_load(&w->all->stop); i++) {
    if (s->facet[0] != NULL) {
      judge_one_posed(w, i, from, many);
    } else if (s->judge == NULL) {
      judge_one(w, i, from, many);
    } else {
      judge_one_with_margin(w, i, from, many);
    }
  }
}

static void brute_force_work(worker *w) {
  search *s = w->all;
  for (size_t task = atomic_fetch_add(&s->next, 1); task < s->total && !atomic_load(&s->stop);
       task = atomic_fetch_add(&s->next, 1)) {
    brute_force_task(w, task);
    if (w->reports) {
      sepax__search_report(w, task);
    }
  }
}

/* ---------------------------------------------------------------------- order */

/* One pass of a radix sort, by the DIGIT bits of pair[][which] from `shift` on. */
static void sort_by_digit(const size_t (*from)[2], size_t (*to)[2], size_t count, int which,
                          int shift) {
  size_t place[1 << DIGIT] = {0};
  size_t sum = 0;
  for (size_t n = 0; n < count; n++) {
    place[from[n][which] >> shift & ((1 << DIGIT) - 1)]++;
  }
  for (size_t d = 0; d < 1 << DIGIT; d++) {
    size_t many = place[d];
    place[d] = sum;
    sum += many;
  }
  for (size_t n = 0; n < count; n++) {
    memcpy(to[place[from[n][which] >> shift & ((1 << DIGIT) - 1)]++], from[n], sizeof *to);
  }
}

/* Collect the pairs of all workers, sorted by i, then by j. */
static bool gather(const search *s, const worker *workers, size_t threads, sepax_pairs *all) {
  size_t total = 0;
  for (size_t k = 0; k < threads; k++) {
    total += workers[k].found.count;
  }
  size_t(*pair)[2] = sepax_allocate((total + 1) * sizeof *pair);
  size_t(*other)[2] = sepax_allocate((total + 1) * sizeof *other);
  bool ok = pair != NULL && other != NULL;
  size_t at = 0;
  for (size_t k = 0; k < threads && ok; k++) {
    if (workers[k].found.count > 0) {
      memcpy(pair + at, workers[k].found.pair, workers[k].found.count * sizeof *pair);
      at += workers[k].found.count;
    }
  }
  for (int which = 1; which >= 0 && ok; which--) {
    for (int shift = 0; (s->count[which] - 1) >> shift != 0; shift += DIGIT) {
      sort_by_digit(pair, other, total, which, shift);
      size_t(*swap)[2] = pair;
      pair = other;
      other = swap;
    }
  }
  sepax_release(other);
  if (!ok) {
    sepax_release(pair);
    return false;
  }
  *all = (sepax_pairs){.pair = pair, .count = total};
  return true;
}

/* -------------------------------------------------------------------- threads */

void sepax__search_report(worker *w, uint64_t done) {
  search *s = w->all;
  if (s->how.progress != NULL && !s->ended && !s->how.progress(s->how.context, done, s->total)) {
    s->ended = true;
    atomic_store(&s->stop, true);
  }
}

static void work(void *workers, size_t part) {
  worker *w = (worker *)workers + part;
  if (w->all->how.brute_force) {
    brute_force_work(w);
  } else {
    sepax__halves_work(w);
  }
}

static size_t threads_of(const sepax_search *how, size_t most) {
  size_t threads = how->first ? 1 : how->threads > 0 ? (size_t)how->threads : sepax__threads_here();
  return threads < most ? threads : most;
}

static bool run(search *s, size_t threads, sepax_pairs *found) {
  worker *workers = sepax__zeroed(threads, sizeof *workers);
  if (workers == NULL) {
    return false;
  }
  for (size_t k = 0; k < threads; k++) {
    workers[k].all = s;
    workers[k].reports = k == 0;
  }
  sepax__threads_run(threads, threads, work, workers);
  bool ok = true;
  for (size_t k = 0; k < threads; k++) {
    ok = ok && !workers[k].no_memory;
  }
  if (ok) {
    sepax__search_report(&workers[0], s->total);
  }
  ok = ok && !s->ended && gather(s, workers, threads, found);
  for (size_t k = 0; k < threads; k++) {
    sepax_release(workers[k].found.pair);
  }
  sepax_release(workers);
  return ok;
}

static bool find_pairs(search *s, const sepax_search *how, sepax_pairs *found, sepax_error *error) {
  *found = (sepax_pairs){0};
  if (!sepax__options(&s->how, sizeof s->how, how, "sepax_search", error)) {
    return false;
  }
  if (s->how.threads < 0) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "%d threads is out of range; give 0 (one for each processor) or more",
                      s->how.threads);
  }
  if (s->count[0] == 0 || s->count[1] == 0) {
    return true;
  }
  if (s->count[0] > UINT32_MAX || s->count[1] > UINT32_MAX) {
    return sepax_fail(error, SEPAX_ERROR_LIMIT,
                      "a search is among up to 2^32 - 1 triangles, not %zu and %zu", s->count[0],
                      s->count[1]);
  }
  atomic_init(&s->stop, false);
  size_t most = SIZE_MAX;
  bool ok = s->how.brute_force ? brute_force_begin(s) : sepax__halves_begin(s, &most);
  ok = ok && run(s, threads_of(&s->how, most), found);
  sepax__halves_end(s);
  sepax_release(s->column);
  if (s->ended) {
    return sepax_fail(error, SEPAX_ERROR_CANCELLED, "the progress function ended the search");
  }
  return ok || sepax_fail(error, SEPAX_ERROR_MEMORY,
                          "no memory for the search among %zu and %zu triangles", s->count[0],
                          s->count[1]);
}

bool sepax_colliding_pairs(const sepax_tri *a, size_t count_a, const sepax_tri *b, size_t count_b,
                           const sepax_search *how, sepax_pairs *found, sepax_error *error) {
  search s = {.tri = {a, b}, .count = {count_a, count_b}};
  return find_pairs(&s, how, found, error);
}

bool sepax_judged_pairs(const sepax_tri *a, size_t count_a, const sepax_tri *b, size_t count_b,
                        int64_t margin, sepax_pair_judge *judge, void *context,
                        const sepax_search *how, sepax_pairs *found, sepax_error *error) {
  search s = {.judge = judge,
              .context = context,
              .tri = {a, b},
              .count = {count_a, count_b},
              .margin = margin};
  return find_pairs(&s, how, found, error);
}

/* The triangles as consecutive doubles: in place, or copied into *copy. NULL without memory. */
static const facet_points *as_doubles(const triangles *t, facet_points **copy) {
  *copy = NULL;
  if (t->packed) {
    return (const facet_points *)(const void *)t->vertex;
  }
  if (t->count <= SIZE_MAX / sizeof **copy) {
    *copy = sepax_allocate(t->count * sizeof **copy);
  }
  for (size_t n = 0; n < t->count && *copy != NULL; n++) {
    triangle_at(t, n, (*copy)[n]);
  }
  return (const facet_points *)*copy;
}

/* The size of the largest coordinate; above 2^1000 if some coordinate is NaN or infinite. */
static double largest_of(const facet_points *facet, size_t count) {
  double most = 0;
  for (size_t n = 0; n < count; n++) {
    for (int k = 0; k < 9; k++) {
      double size = fabs(facet[n][k / 3][k % 3]);
      most = size <= most ? most : size;
      most = isnan(size) ? INFINITY : most;
    }
  }
  return most;
}

static bool collide(search *s, const sepax_pose *pose[2], const sepax_search *how,
                    sepax_pairs *found, sepax_error *error) {
  double most[2] = {largest_of(s->facet[0], s->count[0]), largest_of(s->facet[1], s->count[1])};
  if (!(most[0] <= 0x1p1000) || !(most[1] <= 0x1p1000)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "a mesh has a coordinate that is not within 2^1000");
  }
  s->posed = (posed_pairs){.first = {s->facet[0][0][0], s->facet[1][0][0]},
                           .stride = {9, 9},
                           .lanes = sepax__posed_pairs_lanes(s->how.simd)};
  sepax__place_poses(&s->posed.at, pose[0], pose[1], most[1]);
  double size = most[0];
  for (int i = 0; i < 3; i++) {
    size = fmax(size, fabs(s->posed.at.offset[i]) + 4 * most[1]);
  }
  int exponent;
  frexp(size, &exponent);
  s->unit = size > 0 ? ldexp(1, exponent < -1000 ? 1000 : -exponent) : 1;
  return find_pairs(s, how, found, error);
}

bool sepax_meshes_collide(const sepax_mesh *a, const sepax_pose *pose_a, const sepax_mesh *b,
                          const sepax_pose *pose_b, const sepax_search *how, sepax_pairs *found,
                          sepax_error *error) {
  triangles mesh[2];
  search s = {.judge = NULL};
  *found = (sepax_pairs){0};
  if (!sepax__poses_valid(pose_a, pose_b, error) || !sepax__triangles_of(&mesh[0], a, error) ||
      !sepax__triangles_of(&mesh[1], b, error) ||
      !sepax__options(&s.how, sizeof s.how, how, "sepax_search", error)) {
    return false;
  }
  if (mesh[0].count == 0 || mesh[1].count == 0) {
    return true;
  }
  facet_points *copy[2] = {NULL, NULL};
  for (int k = 0; k < 2; k++) {
    s.facet[k] = as_doubles(&mesh[k], &copy[k]);
    s.count[k] = mesh[k].count;
  }
  bool ok = s.facet[0] != NULL && s.facet[1] != NULL
                ? collide(&s, (const sepax_pose *[2]){pose_a, pose_b}, how, found, error)
                : sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu and %zu triangles",
                             mesh[0].count, mesh[1].count);
  sepax_release(copy[0]);
  sepax_release(copy[1]);
  return ok;
}

void sepax_pairs_free(sepax_pairs *pairs) {
  sepax_release(pairs->pair);
  *pairs = (sepax_pairs){0};
}
