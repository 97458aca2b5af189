/* SPDX-License-Identifier: MIT */
/* search.c - the pairs of triangles of two posed bodies that may be within a limit.
 *
 * Both trees are descended together, nearest boxes first. A box of one body is compared with the
 * eight children of a node of the other (bounds.c). Pairs of triangles whose boxes may be near
 * enough wait until there are several, and are then estimated together. */
#include "bounds.h"
#include "frames.h"
#include "front.h"
#include "queue.h"
#include "support.h"
#include "util/clock.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* -------------------------------------------------------------- pairs of triangles */

static void drop_waiting(search *s) {
  int count = 0;
  for (int n = 0; n < s->count; n++) {
    if (s->waiting[n].least <= s->most) {
      s->waiting[count++] = s->waiting[n];
    }
  }
  s->count = count;
}

/* Keep a pair that the search need not open further. `bound` is in file units. */
static void keep(const search *s, const uint32_t at[2], double bound) {
  if (s->front != NULL) {
    const front_entry e = {{at[0], at[1]}, FRONT_CLOSED, 0};
    sepax__front_add(s->front, &e, bound);
  }
}

/* A bound in file units, of a square in those of the search. */
static double bound_of(const search *s, double square) {
  return sqrt(square) * (1 - 0x1p-50) * s->scale;
}

/* Keep pairs of triangles from number `first` on; none is nearer than `proved`. */
static void keep_waiting(const search *s, int first, double proved) {
  for (int n = first; n < s->count; n++) {
    keep(s, s->waiting[n].at, fmax(proved, bound_of(s, s->waiting[n].least)));
  }
}

static void take_waiting(search *s) {
  const int lanes = s->portable ? 2 : ENCLOSED_MOST;
  pair_enclosure e[ENCLOSED_MOST];
  short_cut cut = {.enough = INFINITY};
  memcpy(cut.way[1], s->line, sizeof s->line);
  drop_waiting(s);
  int next_one = 0;
  for (int first = 0; first < s->count && !s->ended; first += lanes) {
    int used = s->count - first < lanes ? s->count - first : lanes;
    memcpy(cut.way[0], s->line, sizeof s->line);
    cut.enough = s->limit * s->unit;
    sepax__enclose_waiting(s, first, used, &cut, e);
    s->work += (uint64_t)used;
    set_unit(cut.way[1], e[0].way);
    for (int n = 0; n < used && !s->ended; n++) {
      bool may_be_near = !(e[n].least > s->limit * s->unit);
      if (may_be_near) {
        s->take(s, s->waiting[first + n].at, e[n].least / s->unit, e[n].most / s->unit);
      }
      keep(s, s->waiting[first + n].at,
           !may_be_near || s->ended ? e[n].least / s->unit * (1 - 0x1p-50) : s->limit);
      next_one++;
      if (e[n].most < s->shortest) {
        s->shortest = e[n].most;
        s->nearest = s->waiting[first + n];
        sepax__set_way(s, e[n].way);
      }
    }
  }
  keep_waiting(s, next_one, 0);
  s->count = 0;
}

/* -------------------------------------------------------------------- the descent */

/* Each of 64 levels of both trees leaves up to seven pairs. */
enum { STACK = 2048, SEEDS = 2, DEPTH_FIRST = 128, FIRST_PROOF = 24 };

/* The pairs of boxes that are left: depth first in a stack, or best first in a queue, as far as
 * that has room. */
typedef struct {
  box_pair stack[STACK];
  int depth;
  pair_queue *queue; /* NULL: depth first */
} open_pairs;

/* Would a bound in doubles be above the limit? It is not above the one in single precision by more
 * than what that takes off for rounding: slack times the offset of the centres, which is less than
 * twice the limit and all half sides, and 2^-15 of the half sides, each on three axes. The bound of
 * a triangle loses up to 2^-9 of its sides; where that decides, its node is opened instead. */
static bool in_doubt(const search *s, double least, const uint32_t at[2]) {
  double half = 0;
  for (int body = 0; body < 2; body++) {
    half += (double)size_at(s->body[body], at[body]) * s->body[body]->scale / s->scale;
  }
  double limit = s->limit / s->scale;
  double lost = 8 * (limit + half) * (double)s->slack + 0x1p-13 * half;
  return isfinite(limit) && sqrt(least) + lost > limit;
}

/* Is a bound in doubles, in terms of `scale`, so near the limit that doubles do not decide? */
static bool is_tie(const search *s, double least) {
  double limit = s->limit / s->scale;
  double doubt = 8 * FRAME_ERROR;
  return least <= limit && limit - least < doubt * (limit + 1 / (s->unit * s->scale));
}

/* The bound `least` of a pair in single precision, or a better one: in doubles, or, where these do
 * not decide, by the direction of the nearest pair; infinite if that proves that it is not
 * needed. */
static double refined(search *s, double least, const uint32_t at[2]) {
  const uint32_t child[2] = {child_at(s->body[0], at[0]), child_at(s->body[1], at[1])};
  double unit = s->unit * s->scale; /* not 0, unless a translation is out of all proportion */
  if ((child[0] & child[1] & BODY_TRIANGLE) != 0 || !(unit > 0x1p-900) || !in_doubt(s, least, at)) {
    return least;
  }
  hindrance by;
  bool all_tie = s->proof.possible && is_tie(s, 0);
  if (all_tie && sepax__prove_apart(s, child, &by)) {
    return INFINITY;
  }
  double nearest = sepax__exact_bound(s, child) / unit * (1 - 0x1p-50);
  s->work++;
  if (!all_tie && s->proof.possible && is_tie(s, nearest) && sepax__prove_apart(s, child, &by)) {
    return INFINITY;
  }
  return fmax(least, nearest * nearest);
}

/* --------------------------------------------------------------------- the search */

/* Keep the children of a node that are farther than the limit; `opened` are those that are not.
 * least: the square of the distance of some of them at least. */
static void keep_children(const search *s, int open, uint32_t node, const box_pair *p,
                          uint32_t opened, double least, const float square[BODY_WIDE]) {
  const uint32_t *child = s->body[open]->boxes[node].child;
  uint32_t all = 0;
  float own = INFINITY;
  for (uint32_t lane = 0; lane < BODY_WIDE && child[lane] != BODY_NONE; lane++) {
    all |= 1U << lane;
    own = (opened >> lane & 1) == 0 && square[lane] < own ? square[lane] : own;
  }
  if ((all & ~opened) != 0) {
    const front_entry e = {{p->at[0], p->at[1]}, (uint16_t)open, (uint16_t)opened};
    least = fmin(least, (double)fminf(own, FLT_MAX) * s->square_of_unit[open]);
    sepax__front_add(s->front, &e, bound_of(s, fmax(least, p->least)));
  }
}

/* Children of the opened node that may be near enough, except for `others`, the farthest first.
 * Inlined twice, because a search without a front should not pay for one. */
static inline __attribute__((always_inline)) int near_children_of(search *s, int open,
                                                                  uint32_t node, const box_pair *p,
                                                                  uint32_t others, bool keeping,
                                                                  box_pair near[BODY_WIDE]) {
  float square[BODY_WIDE];
  uint32_t on = others; /* children that go on */
  double proved = INFINITY;
  int count = 0;
  for (uint32_t mask = sepax__bound_children(s, open, node, p->at[!open], square) & ~others;
       mask != 0; mask &= mask - 1) {
    uint32_t lane = (uint32_t)__builtin_ctz(mask);
    /* a square that single precision cannot hold is above the largest that it can */
    double own = (double)fminf(square[lane], FLT_MAX) * s->square_of_unit[open];
    double least = fmax(own, p->least);
    if (s->body[open]->boxes[node].child[lane] == BODY_NONE) {
      continue;
    }
    box_pair q;
    q.at[open] = BODY_WIDE * node + lane;
    q.at[!open] = p->at[!open];
    q.least = refined(s, least, q.at);
    if (q.least > s->most) {
      /* by a direction: no more than the limit is certain */
      double limit = keeping ? s->limit / s->scale : 0;
      proved = fmin(proved, isinf(q.least) ? limit * limit : q.least);
      square[lane] = INFINITY;
      continue;
    }
    on |= 1U << lane;
    int at = count++;
    for (; at > 0 && near[at - 1].least < q.least; at--) {
      near[at] = near[at - 1];
    }
    near[at] = q;
  }
  if (keeping && !s->front->full) {
    keep_children(s, open, node, p, on, proved, square);
  }
  return count;
}

static __attribute__((noinline)) int near_children_kept(search *s, int open, uint32_t node,
                                                        const box_pair *p, uint32_t others,
                                                        box_pair near[BODY_WIDE]) {
  return near_children_of(s, open, node, p, others, true, near);
}

static void prefetch(const void *at, size_t bytes) {
  for (size_t line = 0; line < bytes; line += 64) {
    __builtin_prefetch((const char *)at + line);
  }
}

/* Open one node of a pair: that of the body `open`, or, if it is FRONT_CLOSED, any. */
static void visit(search *s, const box_pair *p, int open, uint32_t others, open_pairs *o) {
  uint32_t child[2] = {child_at(s->body[0], p->at[0]), child_at(s->body[1], p->at[1])};
  open = open == FRONT_CLOSED ? opened_body(s->body, p->at, s->at.to[0].ratio) : open;
  box_pair near[BODY_WIDE];
  int count = s->front == NULL ? near_children_of(s, open, child[open], p, 0, false, near)
                               : near_children_kept(s, open, child[open], p, others, near);
  s->work++;
  for (int n = 0; n < count; n++) {
    uint32_t below = child_at(s->body[open], near[n].at[open]);
    if ((child[!open] & below & BODY_TRIANGLE) != 0) {
      s->waiting[s->count++] = near[n];
    } else {
      o->stack[o->depth++] = near[n];
    }
    if ((below & BODY_TRIANGLE) == 0) {
      prefetch(&s->body[open]->boxes[below], sizeof(body_boxes));
    } else {
      prefetch(s->body[open]->triangle[below - BODY_TRIANGLE], sizeof(facet_points));
    }
  }
}

void sepax__search_waiting(search *s) {
  sepax__find_most(s);
  take_waiting(s);
}

/* Go on at the nearest triangles and the other body as a whole: what is nearest to them is likely
 * near. */
static void add_seeds(const search *s, open_pairs *o) {
  for (int k = 0; k < 2; k++) {
    box_pair *seed = &o->stack[o->depth++];
    seed->least = 0;
    seed->at[k] = s->nearest.at[k];
    seed->at[!k] = BODY_WIDE * (uint32_t)s->body[!k]->nodes;
  }
}

/* Move pairs from the stack to the queue. */
static void enqueue(open_pairs *o) {
  int left = 0;
  for (int n = 0; n < o->depth; n++) {
    if (!queue_push(o->queue, &o->stack[n])) {
      o->stack[left++] = o->stack[n];
    }
  }
  o->depth = left;
}

static bool next_pair(search *s, open_pairs *o, box_pair *p) {
  while (o->depth > 0) {
    *p = o->stack[--o->depth];
    if (p->least <= s->most) {
      return true;
    }
  }
  while (o->queue != NULL && queue_pop(o->queue, p)) {
    if (p->least <= s->most) {
      return true;
    }
  }
  return false;
}

/* Look at the next entry of the front that may be near. False if there is none. */
static bool resume(search *s, open_pairs *o) {
  front_entry e;
  if (!s->resume || !sepax__front_next(s->front, &e)) {
    return false;
  }
  const box_pair p = {{e.at[0], e.at[1]}, 0};
  if ((child_at(s->body[0], p.at[0]) & child_at(s->body[1], p.at[1]) & BODY_TRIANGLE) != 0) {
    s->waiting[s->count++] = p;
  } else {
    visit(s, &p, e.open, e.others, o);
  }
  return true;
}

/* Keep what is left open; it is not nearer than `proved`. */
static void keep_open(search *s, const open_pairs *o, double proved) {
  keep_waiting(s, 0, proved);
  for (int n = 0; n < o->depth; n++) {
    keep(s, o->stack[n].at, fmax(proved, bound_of(s, o->stack[n].least)));
  }
  sepax__front_end(s->front, !s->resume, proved);
}

/* What is left is not nearer than this, in file units. */
static double least_of_open(const search *s, const open_pairs *o) {
  double least = INFINITY;
  for (int n = 0; n < o->depth; n++) {
    least = fmin(least, o->stack[n].least);
  }
  for (int n = 0; n < s->count; n++) {
    least = fmin(least, s->waiting[n].least);
  }
  if (o->queue != NULL) {
    least = fmin(least, queue_least(o->queue));
  }
  return bound_of(s, least);
}

static bool has_ended(const search *s, size_t steps, double end) {
  return (s->work_most > 0 && s->work >= s->work_most) ||
         (end > 0 && steps % 64 == 1 && seconds_now() >= end);
}

/* `queue`: where pairs go once a limit is known and the search has taken some steps; or NULL. */
static void run(search *s, pair_queue *queue) {
  open_pairs o;
  size_t steps = 0;
  size_t proof = FIRST_PROOF; /* steps before the next attempt of a proof */
  int seeds = SEEDS;
  double end = s->seconds > 0 ? seconds_now() + s->seconds : 0;
  o.depth = s->resume ? 0 : 1;
  o.queue = NULL;
  o.stack[0].least = 0;
  for (int k = 0; k < 2; k++) {
    o.stack[0].at[k] = BODY_WIDE * (uint32_t)s->body[k]->nodes;
  }
  sepax__find_most(s);
  for (box_pair p; !s->ended;) {
    double limit = s->limit;
    if (s->count >= s->batch || s->count > SEARCH_BATCH - BODY_WIDE ||
        (s->count > 0 && (steps == 0 || isinf(limit)))) {
      take_waiting(s);
      sepax__find_most(s);
    }
    if (s->limit < limit && seeds-- > 0) {
      add_seeds(s, &o);
      continue;
    }
    if (next_pair(s, &o, &p)) {
      visit(s, &p, FRONT_CLOSED, 0, &o);
    } else if (!resume(s, &o)) {
      break;
    }
    steps++;
    if (queue != NULL && o.queue == NULL && steps > DEPTH_FIRST && isfinite(s->limit)) {
      o.queue = queue;
      queue_clear(queue, s->most);
    }
    if (o.queue != NULL) {
      enqueue(&o);
    }
    if (s->prove != NULL && isfinite(s->shortest) && (steps >= proof || s->prove_soon)) {
      s->prove_soon = false;
      if (s->prove(s)) {
        if (s->front != NULL) {
          keep_open(s, &o, s->limit);
        }
        return;
      }
      proof = steps >= proof ? 4 * steps : proof;
    }
    if (has_ended(s, steps, end)) {
      s->ended = true;
      s->open = fmin(s->open, least_of_open(s, &o));
    }
  }
  if (!s->ended) {
    take_waiting(s);
  }
  if (s->front != NULL) {
    keep_open(s, &o, 0);
  }
}

/* Not inlined, because a search without limits needs no memory for the queue. */
static __attribute__((noinline)) void run_best_first(search *s) {
  pair_queue queue;
  queue_clear(&queue, 0);
  run(s, &queue);
}

void sepax__search_pairs(search *s) {
  if (s->best_first) {
    run_best_first(s);
  } else {
    run(s, NULL);
  }
}
