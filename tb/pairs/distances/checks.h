/* SPDX-License-Identifier: MIT */
/* checks.h - what the checks of distances count and say, and the faults that they must see. */
#ifndef DISTANCES_CHECKS_H
#define DISTANCES_CHECKS_H

#include "cases.h"

#include <inttypes.h>

enum { REQUESTS = 4 }; /* of a distance, and of a verdict, in each case */

/* A budget may be exceeded by the step that is under way (sepax.h). */
enum { OVERSHOOT = 500 };

/* Faults that can be put into an answer. */
typedef enum {
  NO_FAULT,
  LEAST_ABOVE, /* least is the next double above the distance */
  MOST_BELOW,  /* most is the next double below the distance */
  TOO_WIDE,    /* the interval is wider than the tolerance, and certain */
  OTHER_PAIR,  /* another pair */
  ONE_ULP,     /* an exact distance is wrong by two units in the last place */
  OTHER_BYTES, /* a bit differs in the answer of the other instruction set */
  TOO_MUCH,    /* more work than the budget */
  LOST,        /* a distance within the limit is reported as infinite */
  STALE,       /* a query with a front says what holds in the pose before */
  WRONG_APART, /* NEAR and APART exchanged where the distance is next to the one asked for */
  FAULTS
} fault;

typedef struct {
  uint64_t cases, answers, touching, ended, wrong;
} tally;

extern fault planted;
extern tally *counted; /* of the kind at work */

/* Count a wrong answer of the case at work, and print the first few. */
void wrong(const char *format, ...) __attribute__((format(printf, 1, 2)));

uint64_t draw_budget(sepax_random *r);
double draw_length(const situation *s, sepax_random *r);
const char *said(sepax_simd second); /* "without vector instructions", for a message */

/* Check what sepax_bodies_apart says at several distances, and along a walk with a front. */
void check_all_apart(const situation *s, sepax_random *r);
void check_walk(const situation *s, kind what, sepax_random *r);

#endif
