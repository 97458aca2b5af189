/* SPDX-License-Identifier: MIT */
/* ask.h - a query of a machine (private). */
#ifndef SEPAX_ASK_H
#define SEPAX_ASK_H

#include "mechanism/machine.h"

#define ASKING_NO_LIMIT UINT64_MAX

typedef struct {
  sepax_watch *watch;
  sepax_machine_query query;
  uint64_t left; /* units of work, or ASKING_NO_LIMIT */
  uint64_t spent;
  size_t near; /* the first pair that is near, or SEPAX_NO_PAIR */
  size_t open; /* entries of watch.queue: pairs that may be open */
} asking;

/* An equal share of the work that is left for so many pairs, at least 1. */
uint64_t sepax__asking_share(const asking *a, size_t among);

void sepax__asking_spend(asking *a, uint64_t work);

/* Find the least clearance with the work that is left. */
bool sepax__asking_measure(asking *a, sepax_machine_answer *answer, sepax_error *error);

#endif
