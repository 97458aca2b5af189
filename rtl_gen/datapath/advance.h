/* SPDX-License-Identifier: MIT */
/* advance.h - enables of the datapath's registers, which a pair brings along: advance_t is high
 * while registers take what they hold in cycle t of a pair, and in the II - 1 cycles behind, as the
 * units work for II operations in turn. */
#ifndef SEPAX_ADVANCE_H
#define SEPAX_ADVANCE_H

#include "emit/emit.h"

enum { ADVANCE_CYCLES = 256 };

typedef struct {
  bool gated; /* registers have enables */
  bool used[ADVANCE_CYCLES];
} advance;

/* The enable of registers of this cycle, which is marked as used. Beyond ADVANCE_CYCLES there is
 * none: the emitter refuses what reads it. */
gen_line advance_name(advance *a, int cycle);

#endif
