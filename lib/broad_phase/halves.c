/* SPDX-License-Identifier: MIT */
/* halves.c - finds the pairs of triangles of two meshes whose AABBs overlap, without a tree.
 *
 * A pair of lists of boxes is processed as follows. A box outside the bounds of the other list
 * leaves its list. Then the longer list is halved, and each half forms a new pair with the other
 * list. If few pairs of boxes are left, then all are tested. Lists are halved in place. Long pairs
 * of lists become tasks that threads take. */
#include "broad_phase/search.h"
#include "util/memory.h"
#include "util/box.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

enum {
  LEAF_PAIRS = 512, /* up to this many pairs of boxes are tested one by one */
  TASK = 256        /* least number of items of both lists for a task */
};

/* AABBs of triangles with their numbers. */
typedef struct {
  box4 *item;
  size_t count;
  box4 bounds;
} list;

typedef struct task {
  struct task *next;
  list of[2]; /* the list of A, the list of B */
  uint64_t share;
} task;

struct tasks {
  pthread_mutex_t lock;
  pthread_cond_t changed;
  task *first;
  size_t active;
  uint64_t done;
  box4 *items[2];
};

static const uint64_t whole = UINT64_C(1) << 40;

/* --------------------------------------------------------------------- lists */

/* An enlarged AABB. The margin and 2^-22 of a coordinate are added. This covers rounding: a
 * coordinate rounds by 2^-24 of itself, and so does its sum with the margin. */
static box4 box_of_triangle(const sepax_tri *t, float margin) {
  corner_bits v[3];
  memcpy(&v[0], &t->v[0], sizeof v[0]);
  memcpy(&v[1], &t->v[1], sizeof v[1]);
  v[2] = (corner_bits){t->v[2].x, t->v[2].y, t->v[2].z, 0};
  corner p = __builtin_convertvector(v[0], corner);
  corner q = __builtin_convertvector(v[1], corner);
  corner r = __builtin_convertvector(v[2], corner);
  box4 b = {corner_least(corner_least(p, q), r), corner_most(corner_most(p, q), r)};
  b.low -= (corner)((corner_bits)b.low & INT32_MAX) * 0x1p-22F + margin;
  b.high += (corner)((corner_bits)b.high & INT32_MAX) * 0x1p-22F + margin;
  return b;
}

/* The AABB of a posed triangle of doubles, in A's coordinates times `unit`, which brings them
 * within 1. Rounded to floats, coordinates are wrong by 2^-24 of themselves, or by 2^-149. */
static box4 box_of_posed(const search *s, int which, size_t n) {
  const double(*v)[3] = s->facet[which][n];
  double placed[3][3];
  float margin = (float)(s->posed.at.error * s->unit * (1 + 0x1p-20)) + 0x1p-140F;
  if (which == 1) {
    sepax__place_triangle_b(&s->posed.at, v, placed);
    v = placed;
  }
  box4 b = box4_of_none();
  for (int k = 0; k < 3; k++) {
    corner at = {(float)(v[k][0] * s->unit), (float)(v[k][1] * s->unit), (float)(v[k][2] * s->unit),
                 0};
    b.low = corner_least(b.low, at);
    b.high = corner_most(b.high, at);
  }
  b.low -= (corner)((corner_bits)b.low & INT32_MAX) * 0x1p-22F + margin;
  b.high += (corner)((corner_bits)b.high & INT32_MAX) * 0x1p-22F + margin;
  return b;
}

static box4 box_of(const search *s, int which, size_t n, float margin) {
  return s->facet[0] != NULL ? box_of_posed(s, which, n)
                             : box_of_triangle(&s->tri[which][n], margin);
}

static box4 bounds_of_mesh(const search *s, int which) {
  box4 all = box4_of_none();
  for (size_t n = 0; n < s->count[which]; n++) {
    box4 b = box_of(s, which, n, 0);
    box4_enclose(&all, &b);
  }
  return all;
}

/* List the triangles whose boxes meet `reach`. */
static void fill_list(const search *s, int which, list *to, float margin, const box4 *reach) {
  to->count = 0;
  to->bounds = box4_of_none();
  for (size_t n = 0; n < s->count[which]; n++) {
    box4 b = box_of(s, which, n, margin);
    if (!box4_disjoint(&b, reach)) {
      box4_enclose(&to->bounds, &b);
      box4_set_number(&b, (uint32_t)n);
      to->item[to->count++] = b;
    }
  }
}

static void find_bounds(list *l) {
  l->bounds = box4_of_none();
  for (size_t n = 0; n < l->count; n++) {
    box4_enclose(&l->bounds, &l->item[n]);
  }
}

/* Move the items that meet `reach` to the front; they are the new list. */
static list clip(list l, const box4 *reach) {
  size_t kept = 0;
  for (size_t n = 0; n < l.count; n++) {
    box4 keep = l.item[n];
    l.item[n] = l.item[kept];
    l.item[kept] = keep;
    kept += !box4_disjoint(&keep, reach);
  }
  l.count = kept;
  find_bounds(&l);
  return l;
}

/* Halve a list at the middle of the longest side of its bounds. If that leaves all items on one
 * side, then by number. */
static void halve(const list *l, list half[2]) {
  int axis = box4_longest_axis(&l->bounds);
  float middle = l->bounds.low[axis] + l->bounds.high[axis];
  size_t first = 0;
  for (size_t n = 0; n < l->count; n++) {
    box4 keep = l->item[n];
    l->item[n] = l->item[first];
    l->item[first] = keep;
    first += keep.low[axis] + keep.high[axis] < middle;
  }
  if (first == 0 || first == l->count) {
    first = l->count / 2;
  }
  half[0] = (list){.item = l->item, .count = first};
  half[1] = (list){.item = l->item + first, .count = l->count - first};
  find_bounds(&half[0]);
  find_bounds(&half[1]);
}

/* --------------------------------------------------------------------- tasks */

/* Make a task with a copy of the lists. False without memory. */
static bool push(tasks *t, const list of[2], uint64_t share) {
  size_t items = of[0].count + of[1].count;
  task *made = sepax_allocate(sizeof *made);
  box4 *space = sepax_allocate(items * sizeof *space);
  if (made == NULL || space == NULL) {
    sepax_release(made);
    sepax_release(space);
    return false;
  }
  *made = (task){.of = {of[0], of[1]}, .share = share};
  made->of[0].item = space;
  made->of[1].item = space + of[0].count;
  for (int k = 0; k < 2; k++) {
    memcpy(made->of[k].item, of[k].item, of[k].count * sizeof *space);
  }
  pthread_mutex_lock(&t->lock);
  made->next = t->first;
  t->first = made;
  pthread_cond_signal(&t->changed);
  pthread_mutex_unlock(&t->lock);
  return true;
}

static void drop(task *t) {
  sepax_release(t->of[0].item);
  sepax_release(t);
}

/* Take the next task. NULL if all is done or the search stops. `share` is the share of the whole
 * that the thread has just done. */
static task *take(search *s, bool was_active, uint64_t share, uint64_t *done) {
  tasks *t = s->tasks;
  pthread_mutex_lock(&t->lock);
  t->active -= was_active;
  t->done += share;
  *done = t->done;
  while (t->first == NULL && t->active > 0 && !atomic_load(&s->stop)) {
    pthread_cond_wait(&t->changed, &t->lock);
  }
  task *next = atomic_load(&s->stop) ? NULL : t->first;
  if (next != NULL) {
    t->first = next->next;
    t->active++;
  } else {
    pthread_cond_broadcast(&t->changed);
  }
  pthread_mutex_unlock(&t->lock);
  return next;
}

/* -------------------------------------------------------------------- search */

static void test_all(worker *w, const list of[2]) {
  for (size_t m = 0; m < of[0].count; m++) {
    const box4 *a = &of[0].item[m];
    for (size_t n = 0; n < of[1].count; n++) {
      const box4 *b = &of[1].item[n];
      if (!box4_disjoint(a, b)) {
        sepax__search_add_candidate(w, box4_number(a), box4_number(b));
      }
    }
  }
  if (w->all->how.first) {
    sepax__search_judge_candidates(w);
  }
}

/* Search two lists, each clipped to the bounds of the other. Returns the share of the whole that
 * was given away as tasks. */
static uint64_t search_lists(worker *w, const list of[2], uint64_t share) {
  if (atomic_load_explicit(&w->all->stop, memory_order_relaxed)) {
    return 0;
  }
  if (of[0].count * of[1].count <= LEAF_PAIRS) {
    test_all(w, of);
    return 0;
  }
  int longer = of[1].count > of[0].count;
  uint64_t given = 0;
  list half[2];
  halve(&of[longer], half);
  for (int k = 0; k < 2; k++) {
    list next[2];
    next[!longer] = clip(of[!longer], &half[k].bounds);
    next[longer] = clip(half[k], &next[!longer].bounds);
    if (next[0].count == 0 || next[1].count == 0) {
      continue;
    }
    if (next[0].count + next[1].count >= TASK && push(w->all->tasks, next, share / 2)) {
      given += share / 2;
    } else {
      search_lists(w, next, 0);
    }
  }
  return given;
}

void sepax__halves_work(worker *w) {
  search *s = w->all;
  uint64_t done;
  task *t = take(s, false, 0, &done);
  while (t != NULL) {
    uint64_t given = search_lists(w, t->of, t->share);
    uint64_t share = t->share - given;
    drop(t);
    t = take(s, true, share, &done);
    if (w->reports && t != NULL) {
      sepax__search_report(w, done);
    }
  }
  sepax__search_judge_candidates(w);
}

bool sepax__halves_begin(search *s, size_t *most_threads) {
  tasks *t = sepax__zeroed(1, sizeof *t);
  if (t == NULL) {
    return false;
  }
  s->tasks = t;
  s->total = whole;
  pthread_mutex_init(&t->lock, NULL);
  pthread_cond_init(&t->changed, NULL);
  float margin = (float)s->margin * (1 + 0x1p-20F);
  list of[2] = {{.count = 0}, {.count = 0}};
  for (int k = 0; k < 2; k++) {
    t->items[k] = sepax_allocate(s->count[k] * sizeof *t->items[k]);
    of[k].item = t->items[k];
    if (t->items[k] == NULL) {
      return false;
    }
  }
  box4 reach = bounds_of_mesh(s, 1);
  fill_list(s, 0, &of[0], margin, &reach);
  fill_list(s, 1, &of[1], 0, &of[0].bounds);
  *most_threads = 1 + (of[0].count + of[1].count) / TASK;
  return of[0].count == 0 || of[1].count == 0 || push(t, of, whole);
}

void sepax__halves_end(search *s) {
  tasks *t = s->tasks;
  if (t == NULL) {
    return;
  }
  while (t->first != NULL) {
    task *next = t->first->next;
    drop(t->first);
    t->first = next;
  }
  for (int k = 0; k < 2; k++) {
    sepax_release(t->items[k]);
  }
  pthread_cond_destroy(&t->changed);
  pthread_mutex_destroy(&t->lock);
  sepax_release(t);
}
