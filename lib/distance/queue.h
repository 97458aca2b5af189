/* SPDX-License-Identifier: MIT */
/* queue.h - pairs of boxes in the order of their distances, roughly (private).
 *
 * Pairs are in lists by distance, in 512 steps up to that of the limit when the queue was cleared.
 * Within a list the last comes first: a search then goes to the end of one way where many pairs are
 * equally near. All functions take constant time, but for queue_least. */
#ifndef SEPAX_DISTANCE_QUEUE_H
#define SEPAX_DISTANCE_QUEUE_H

#include "search.h"

#include <math.h>

enum { QUEUE_ROOM = 4096, QUEUE_LISTS = 512, QUEUE_END = -1 };

typedef struct {
  box_pair pair[QUEUE_ROOM];
  int16_t next[QUEUE_ROOM];
  int16_t first[QUEUE_LISTS];
  int16_t free; /* list of places that were used before */
  int used;     /* places that were used */
  int lowest;   /* no list before this one has pairs */
  double scale; /* lists in a unit of distance */
} pair_queue;

/* `most`: the square of the limit. */
static inline void queue_clear(pair_queue *q, double most) {
  q->free = QUEUE_END;
  q->used = 0;
  q->lowest = QUEUE_LISTS;
  q->scale = QUEUE_LISTS / fmax(sqrt(most), 0x1p-400);
  for (int n = 0; n < QUEUE_LISTS; n++) {
    q->first[n] = QUEUE_END;
  }
}

/* False if there is no room. */
static inline bool queue_push(pair_queue *q, const box_pair *p) {
  int at = q->free;
  if (at != QUEUE_END) {
    q->free = q->next[at];
  } else if (q->used < QUEUE_ROOM) {
    at = q->used++;
  } else {
    return false;
  }
  int list = (int)fmin(sqrt(p->least) * q->scale, QUEUE_LISTS - 1);
  q->pair[at] = *p;
  q->next[at] = q->first[list];
  q->first[list] = (int16_t)at;
  q->lowest = list < q->lowest ? list : q->lowest;
  return true;
}

/* Take a pair of the nearest list. False if there is none. */
static inline bool queue_pop(pair_queue *q, box_pair *p) {
  while (q->lowest < QUEUE_LISTS && q->first[q->lowest] == QUEUE_END) {
    q->lowest++;
  }
  if (q->lowest == QUEUE_LISTS) {
    return false;
  }
  int16_t at = q->first[q->lowest];
  q->first[q->lowest] = q->next[at];
  q->next[at] = q->free;
  q->free = at;
  *p = q->pair[at];
  return true;
}

/* The least of all pairs; infinite if there is none. */
static inline double queue_least(const pair_queue *q) {
  double least = INFINITY;
  for (int list = q->lowest; list < QUEUE_LISTS && isinf(least); list++) {
    for (int at = q->first[list]; at != QUEUE_END; at = q->next[at]) {
      least = fmin(least, q->pair[at].least);
    }
  }
  return least;
}

#endif
