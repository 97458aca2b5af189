/* meshes.c - all colliding pairs of two meshes. Leaves hold 64 triangles in the order of a
 * space-filling curve, a tree of axis-aligned bounding boxes (AABB) is above them, and pairs.c
 * judges the pairs in a leaf. */
#include "sepax_design.h"
#include "util/aabb.h"
#include "util/error.h"
#include "util/list.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { LEAF = 64, DIGITS = 21 };

/* Leaf k has triangles 64 k ... 64 k + 63 of the order; the last triangle fills the rest of its
 * leaf, and leaves behind that one are empty. Node 1 is the root, nodes 2 n and 2 n + 1 are the
 * children of node n, leaf k is node leaves + k. */
typedef struct {
  size_t count, leaves; /* leaves: a power of two */
  size_t *order;        /* number in the mesh */
  int32_t *columns;
  sepax_columns at;
  aabb *bounds; /* of each node; of an empty one aabb_of_none */
} tree;

/* ------------------------------------------------------------------- the tree */

typedef struct {
  uint64_t code;
  size_t triangle;
} curve_entry;

static int compare_entries(const void *p, const void *q) {
  const curve_entry *a = p;
  const curve_entry *b = q;
  int by_code = (a->code > b->code) - (a->code < b->code);
  return by_code != 0 ? by_code : (a->triangle > b->triangle) - (a->triangle < b->triangle);
}

/* The centre of an AABB as a Morton code: its position on a curve through 2^21 cells a side. */
static uint64_t curve_code(const aabb *b, const aabb *all) {
  uint64_t code = 0;
  int64_t size = aabb_longest_side(all) + 1;
  for (int axis = 0; axis < 3; axis++) {
    int64_t middle = (b->low[axis] + b->high[axis]) / 2 - all->low[axis];
    uint64_t cell = (uint64_t)(middle * ((INT64_C(1) << DIGITS) - 1) / size);
    for (int digit = 0; digit < DIGITS; digit++) {
      code |= (cell >> digit & 1) << (3 * digit + axis);
    }
  }
  return code;
}

static void free_tree(tree *t) {
  free(t->order);
  free(t->columns);
  free(t->bounds);
  *t = (tree){0};
}

static bool fill_columns(tree *t, const sepax_tri *tri) {
  size_t length = t->leaves * LEAF;
  t->columns = malloc(length * 9 * sizeof *t->columns);
  if (t->columns == NULL) {
    return false;
  }
  for (int k = 0; k < 3; k++) {
    int32_t *x = t->columns + (size_t)(3 * k) * length;
    for (size_t n = 0; n < length; n++) {
      const sepax_vec *v = &tri[t->order[n < t->count ? n : t->count - 1]].v[k];
      x[n] = v->x;
      x[n + length] = v->y;
      x[n + 2 * length] = v->z;
    }
    for (int axis = 0; axis < 3; axis++) {
      t->at.c[k][axis] = x + (size_t)axis * length;
    }
  }
  return true;
}

static void fill_bounds(tree *t, const sepax_tri *tri) {
  for (size_t leaf = 0; leaf < t->leaves; leaf++) {
    aabb all = aabb_of_none();
    for (size_t n = leaf * LEAF; n < (leaf + 1) * LEAF && n < t->count; n++) {
      aabb b = aabb_of(&tri[t->order[n]]);
      aabb_enclose(&all, &b);
    }
    t->bounds[t->leaves + leaf] = all;
  }
  for (size_t n = t->leaves - 1; n > 0; n--) {
    t->bounds[n] = t->bounds[2 * n];
    aabb_enclose(&t->bounds[n], &t->bounds[2 * n + 1]);
  }
}

static bool sort_along_curve(tree *t, const sepax_tri *tri) {
  curve_entry *entries = malloc(t->count * sizeof *entries);
  if (entries == NULL) {
    return false;
  }
  aabb all = aabb_of_none();
  for (size_t n = 0; n < t->count; n++) {
    aabb b = aabb_of(&tri[n]);
    aabb_enclose(&all, &b);
  }
  for (size_t n = 0; n < t->count; n++) {
    aabb b = aabb_of(&tri[n]);
    entries[n] = (curve_entry){curve_code(&b, &all), n};
  }
  qsort(entries, t->count, sizeof *entries, compare_entries);
  for (size_t n = 0; n < t->count; n++) {
    t->order[n] = entries[n].triangle;
  }
  free(entries);
  return true;
}

static void keep_order(tree *t) {
  for (size_t n = 0; n < t->count; n++) {
    t->order[n] = n;
  }
}

/* Brute force needs neither an order nor bounds. */
static bool build_tree(tree *t, const sepax_tri *tri, size_t count, bool brute_force) {
  *t = (tree){.count = count, .leaves = 1};
  while (t->leaves * LEAF < count) {
    t->leaves *= 2;
  }
  t->order = malloc(count * sizeof *t->order);
  t->bounds = malloc(2 * t->leaves * sizeof *t->bounds);
  bool ok = t->order != NULL && t->bounds != NULL;
  if (ok && brute_force) {
    keep_order(t);
  }
  if (!ok || (!brute_force && !sort_along_curve(t, tri))) {
    free_tree(t);
    return false;
  }
  if (!brute_force) {
    fill_bounds(t, tri);
  }
  return true;
}

/* ------------------------------------------------------------------ the search */

typedef struct {
  const sepax_search *how;
  const sepax_design *design; /* with clearances, or NULL for collisions */
  const sepax_tri *tri_a, *tri_b;
  tree a, b;
  size_t tasks, parts; /* of B */
  atomic_size_t next;  /* task */
  atomic_bool stop;
  bool ended; /* by progress */
} search;

typedef struct {
  search *all;
  sepax_pairs found;
  size_t capacity, taken; /* taken: by gather */
  bool no_memory;
} worker;

/* False where the search ends with this pair. */
static bool record(worker *w, size_t i, size_t j) {
  w->no_memory = !list_add_pair(&w->found, &w->capacity, i, j);
  bool ends = w->no_memory || w->all->how->first;
  if (ends) {
    atomic_store(&w->all->stop, true);
  }
  return !ends;
}

/* With clearances AABBs may be as far from each other as the margin. */
static bool within_reach(const search *s, const aabb *a, const aabb *b) {
  return !aabb_disjoint(a, b, s->design != NULL ? s->design->margin[1] : 0);
}

/* One triangle of A against the triangles from ... to of B's order: those that are not free. */
static bool judge_bands(worker *w, size_t i, size_t from, size_t to) {
  const search *s = w->all;
  aabb a = aabb_of(&s->tri_a[i]);
  for (size_t m = from; m < to; m++) {
    size_t j = s->b.order[m];
    aabb b = aabb_of(&s->tri_b[j]);
    if (within_reach(s, &a, &b) &&
        sepax_clearance(s->design, &s->tri_a[i], &s->tri_b[j]).band != SEPAX_BAND_FREE &&
        !record(w, i, j)) {
      return false;
    }
  }
  return true;
}

/* The triangles first ... end - 1 of A's order, of which `bounds` are the AABBs (NULL: not tested),
 * against leaves of B. Leaf `leaf` is not empty. */
static void judge_leaves(worker *w, const aabb *bounds, size_t first, size_t end, size_t leaf,
                         size_t leaves) {
  const search *s = w->all;
  uint64_t bits[LEAF];
  size_t from = leaf * LEAF;
  size_t many = (leaf + leaves) * LEAF < s->b.count ? leaves * LEAF : s->b.count - from;
  sepax_columns columns;
  for (int i = 0; i < 9; i++) {
    columns.c[i / 3][i % 3] = s->b.at.c[i / 3][i % 3] + from;
  }
  for (size_t n = first; n < end && !atomic_load(&w->all->stop); n++) {
    if (bounds != NULL && !within_reach(s, &bounds[n - first], &s->b.bounds[s->b.leaves + leaf])) {
      continue;
    }
    size_t i = s->a.order[n];
    if (s->design != NULL) {
      if (!judge_bands(w, i, from, from + many)) {
        return;
      }
      continue;
    }
    sepax_exact_one_to_many(s->how->path, &s->tri_a[i], &columns, many, bits);
    for (size_t m = 0; m < (many + 63) / 64; m++) {
      for (uint64_t word = bits[m]; word != 0; word &= word - 1) {
        size_t j = s->b.order[from + 64 * m + (size_t)__builtin_ctzll(word)];
        if (!record(w, i, j)) {
          return;
        }
      }
    }
  }
}

/* One leaf of A against all of B down its tree, or by brute force against 64 leaves. */
static void judge_task(worker *w, size_t task) {
  const search *s = w->all;
  size_t leaf_a = task / s->parts;
  size_t first = leaf_a * LEAF;
  size_t end = first + LEAF < s->a.count ? first + LEAF : s->a.count;
  if (s->how->brute_force) {
    judge_leaves(w, NULL, first, end, task % s->parts * LEAF, LEAF);
    return;
  }
  aabb bounds[LEAF];
  for (size_t n = first; n < end; n++) {
    bounds[n - first] = aabb_of(&s->tri_a[s->a.order[n]]);
  }
  size_t stack[64] = {1};
  size_t depth = 1;
  while (depth > 0 && !atomic_load(&w->all->stop)) {
    size_t node = stack[--depth];
    if (!within_reach(s, &s->b.bounds[node], &s->a.bounds[s->a.leaves + leaf_a])) {
      continue;
    }
    if (node >= s->b.leaves) {
      judge_leaves(w, bounds, first, end, node - s->b.leaves, 1);
    } else {
      stack[depth++] = 2 * node + 1;
      stack[depth++] = 2 * node;
    }
  }
}

static void report(search *s, size_t done) {
  if (s->how->progress != NULL && !s->how->progress(s->how->context, done, s->tasks)) {
    s->ended = true;
    atomic_store(&s->stop, true);
  }
}

static int compare_pairs(const void *p, const void *q) {
  const size_t *a = p;
  const size_t *b = q;
  int by_a = (a[0] > b[0]) - (a[0] < b[0]);
  return by_a != 0 ? by_a : (a[1] > b[1]) - (a[1] < b[1]);
}

/* Leaves the worker's pairs in order. */
static void work(worker *w, bool reports) {
  search *s = w->all;
  for (size_t task = atomic_fetch_add(&s->next, 1); task < s->tasks && !atomic_load(&s->stop);
       task = atomic_fetch_add(&s->next, 1)) {
    judge_task(w, task);
    if (reports) {
      report(s, task);
    }
  }
  if (w->found.count > 0) {
    qsort(w->found.pair, w->found.count, sizeof *w->found.pair, compare_pairs);
  }
}

static void *work_beside(void *argument) {
  work(argument, false);
  return NULL;
}

/* The lists of all workers, which are in order, into one. */
static bool gather(worker *workers, size_t count, sepax_pairs *all) {
  size_t total = 0;
  for (size_t k = 0; k < count; k++) {
    total += workers[k].found.count;
    workers[k].taken = 0;
  }
  all->pair = malloc((total + 1) * sizeof *all->pair);
  if (all->pair == NULL) {
    return false;
  }
  for (; all->count < total; all->count++) {
    worker *least = NULL;
    for (size_t k = 0; k < count; k++) {
      worker *w = &workers[k];
      if (w->taken < w->found.count &&
          (least == NULL ||
           compare_pairs(w->found.pair[w->taken], least->found.pair[least->taken]) < 0)) {
        least = w;
      }
    }
    if (least == NULL) {
      break;
    }
    memcpy(all->pair[all->count], least->found.pair[least->taken++], sizeof *all->pair);
  }
  return true;
}

static size_t threads_of(const sepax_search *how, size_t tasks) {
  long here = sysconf(_SC_NPROCESSORS_ONLN);
  if (how->first) {
    return 1;
  }
  size_t threads = how->threads > 0 ? (size_t)how->threads : here > 0 ? (size_t)here : 1;
  return threads < tasks ? threads : tasks;
}

/* A thread that cannot be had leaves its work to the others. */
static bool run(search *s, sepax_pairs *found) {
  size_t threads = threads_of(s->how, s->tasks);
  worker *workers = calloc(threads, sizeof *workers);
  pthread_t *beside = calloc(threads, sizeof *beside);
  bool *started = calloc(threads, sizeof *started);
  bool ok = workers != NULL && beside != NULL && started != NULL;
  for (size_t k = 0; k < threads && ok; k++) {
    workers[k].all = s;
    started[k] = k > 0 && pthread_create(&beside[k], NULL, work_beside, &workers[k]) == 0;
  }
  if (ok) {
    work(&workers[0], true);
  }
  for (size_t k = 0; k < threads && ok; k++) {
    if (started[k]) {
      pthread_join(beside[k], NULL);
    }
  }
  for (size_t k = 0; k < threads && ok; k++) {
    ok = !workers[k].no_memory;
  }
  if (ok && !s->ended) {
    report(s, s->tasks);
  }
  ok = ok && gather(workers, threads, found);
  for (size_t k = 0; k < threads && workers != NULL; k++) {
    free(workers[k].found.pair);
  }
  free(workers);
  free(beside);
  free(started);
  return ok;
}

static bool find_pairs(const sepax_design *design, const sepax_tri *a, size_t count_a,
                       const sepax_tri *b, size_t count_b, const sepax_search *how,
                       sepax_pairs *found, sepax_error *error) {
  static const sepax_search usual = {0};
  search s = {.how = how != NULL ? how : &usual, .design = design, .tri_a = a, .tri_b = b};
  *found = (sepax_pairs){0};
  if (count_a == 0 || count_b == 0) {
    return true;
  }
  bool brute_force = s.how->brute_force;
  bool ok = build_tree(&s.a, a, count_a, brute_force) &&
            build_tree(&s.b, b, count_b, brute_force) && fill_columns(&s.b, b);
  s.parts = brute_force ? (count_b + LEAF * LEAF - 1) / (LEAF * LEAF) : 1;
  s.tasks = (count_a + LEAF - 1) / LEAF * s.parts;
  atomic_init(&s.next, 0);
  atomic_init(&s.stop, false);
  ok = ok && run(&s, found);
  free_tree(&s.a);
  free_tree(&s.b);
  if (s.ended) {
    sepax_pairs_free(found);
    return sepax_fail(error, "the search was ended before its time");
  }
  return ok || sepax_fail(error, "no memory for the search among %zu and %zu triangles", count_a,
                          count_b);
}

bool sepax_colliding_pairs(const sepax_tri *a, size_t count_a, const sepax_tri *b, size_t count_b,
                           const sepax_search *how, sepax_pairs *found, sepax_error *error) {
  return find_pairs(NULL, a, count_a, b, count_b, how, found, error);
}

bool sepax_near_pairs(const sepax_design *design, const sepax_tri *a, size_t count_a,
                      const sepax_tri *b, size_t count_b, const sepax_search *how,
                      sepax_pairs *found, sepax_error *error) {
  return find_pairs(design, a, count_a, b, count_b, how, found, error);
}

void sepax_pairs_free(sepax_pairs *pairs) {
  free(pairs->pair);
  *pairs = (sepax_pairs){0};
}
