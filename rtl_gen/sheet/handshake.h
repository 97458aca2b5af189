/* SPDX-License-Identifier: MIT */
/* handshake.h - how the top of a design talks to what is around it, as a waveform. */
#ifndef SEPAX_SHEET_HANDSHAKE_H
#define SEPAX_SHEET_HANDSHAKE_H

#include "sepax_design.h"
#include "sheet/wave.h"

/* Fill in the waveform of a design: two pairs that come and their verdicts. Of an engine: the write
 * to its register at address `start`, which begins a run, and the interrupt at the end. Gaps stand
 * for as many cycles as the design takes. */
void handshake_wave(const sepax_design *design, unsigned start, wave *w);

#endif
