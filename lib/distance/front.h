/* SPDX-License-Identifier: MIT */
/* front.h - what a search proved of pairs of boxes, kept for similar poses (private).
 *
 * The entries of a front that covers two bodies hold all pairs of their triangles between them.
 * Each has a bound that the distance of its pairs is not below. When the bodies move, all bounds
 * fall by what they move at most (front.c). A search then needs to look only at entries whose bound
 * is not above its limit.
 *
 * Bounds are counted from `moved`, the sum of all motions since the front was empty: an entry's
 * bound is `end - moved`, so that a motion changes no entry. They are in units of `scale`. */
#ifndef SEPAX_DISTANCE_FRONT_H
#define SEPAX_DISTANCE_FRONT_H

#include "body/body.h"

/* A pair of boxes, numbered as in search.h. If the node of one box was opened, then the entry
 * covers its children except for those that have entries of their own. */
typedef struct {
  uint32_t at[2];
  uint16_t open; /* the body whose node was opened; FRONT_CLOSED: none */
  uint16_t others;
} front_entry;

enum { FRONT_CLOSED = 2, FRONT_LANES = 8 };
#define FRONT_END UINT32_MAX

struct sepax_front {
  const sepax_body *body[2];
  bool covers;
  bool full;       /* an entry found no room, so the front cannot cover */
  uint32_t room;   /* entries, a multiple of FRONT_LANES */
  uint32_t used;   /* places that were used */
  uint32_t free;   /* first of the list of free places below `used`, by at[0] */
  uint32_t built;  /* entries after the last search from the roots */
  uint32_t listed; /* places in `list` */
  uint32_t next;   /* of `list`: what is left to look at */
  double scale, moved, most;
  /* The first body in the second's coordinates. */
  double rotation[3][3], translation[3];
  double reach, skew;
  bool has_near;
  uint32_t near[2];  /* boxes of two triangles that were near last */
  double near_limit; /* they were at most that far apart */
  float *end;        /* of each place; infinite if it is free */
  front_entry *entry;
  uint32_t *list; /* places of entries that may be near */
};

/* Begin a search of two bodies in their poses. Bounds fall by their motion; a front of other bodies
 * becomes empty. */
void sepax__front_move(sepax_front *f, const sepax_body *a, const sepax_pose *pose_a,
                       const sepax_body *b, const sepax_pose *pose_b);

/* List the entries whose bound is not above `limit`. True if there is none, and *least receives a
 * bound of the distance, which is above the limit. */
bool sepax__front_beyond(sepax_front *f, double limit, double *least);

/* A bound of the distance, if the front covers the bodies; otherwise 0. */
double sepax__front_least(const sepax_front *f);

/* Should the entries of the list be looked at, rather than all pairs from the roots? */
bool sepax__front_worth(const sepax_front *f);

/* Forget all entries. */
void sepax__front_clear(sepax_front *f);

/* The next entry of the list, which is taken out of the front. False at the end. */
bool sepax__front_next(sepax_front *f, front_entry *e);

/* Add an entry with a bound in file units. */
void sepax__front_add(sepax_front *f, const front_entry *e, double bound);

/* Two triangles are at most `limit` apart, in file units. */
void sepax__front_note_near(sepax_front *f, const uint32_t at[2], double limit);

/* The search has ended; `proved`: a bound of what is left in the list. */
void sepax__front_end(sepax_front *f, bool from_roots, double proved);

#endif
