/* SPDX-License-Identifier: MIT */
/* advance.h - what comes along with a pair: enables of the datapath's registers, and copies of the
 * slot.
 * advance_t is high while registers take what they hold in cycle t of a pair, and in the II - 1
 * cycles behind, as the units work for II operations in turn.
 * On an FPGA a slot bit that the whole core reads would be its longest wire. So each II window has
 * a copy of the slot: slot_qN_K, which is made of slot_q(N-1) a cycle earlier. No copy equals
 * another by what it is made of, so synthesis does not merge them. While the slot rests a copy
 * shows something else. Copy N is right again from cycle N - 1 of a pair on. */
#ifndef SEPAX_ADVANCE_H
#define SEPAX_ADVANCE_H

#include "emit/emit.h"

enum { ADVANCE_CYCLES = 256 };

typedef struct {
  bool gated; /* registers have enables */
  bool ahead; /* a pair is here before it enters the first registers */
  bool used[ADVANCE_CYCLES];
  int ii;
  bool copied;                   /* each II window has a copy of the slot */
  int copies;                    /* the last copy that is read; 0: none is */
  unsigned bits[ADVANCE_CYCLES]; /* of each copy: those that are read */
} advance;

/* The enable of registers of this cycle, which is marked as used. Beyond ADVANCE_CYCLES there is
 * none: the emitter refuses what reads it. */
gen_line advance_name(advance *a, int cycle);

/* Which copy what begins in this cycle reads; 0: the slot itself. */
int advance_copy(const advance *a, int begin);

/* The bit that is high in `cycle`, of the copy that what begins in cycle `begin` reads. That copy
 * is marked as used. */
gen_line advance_slot(advance *a, int begin, int cycle);

/* The copies that are used: declarations and clocked assignments. */
void advance_copies(const advance *a, emit_text *out);

#endif
