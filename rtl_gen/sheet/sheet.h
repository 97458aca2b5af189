/* SPDX-License-Identifier: MIT */
/* sheet.h - the datasheet of a design: what it is for, how exact it is, its ports, its handshake,
 * its speed, what it costs, its registers. */
#ifndef SEPAX_SHEET_H
#define SEPAX_SHEET_H

#include "emit/emit.h"

/* What the design gives and costs, as rtl_gen/estimate.h has it. x_error: the value is x - x_error
 * to x + x_error. */
enum { SHEET_ENERGIES = 3 }; /* of pairs that are separated, colliding, coplanar */
typedef struct {
  double pairs;                                                /* a second */
  double compared;                                             /* AABBs a second; 0: no lanes */
  uint64_t memory_bits;                                        /* not in the gates */
  bool gates_known;                                            /* the next four */
  double gates, gates_error;                                   /* gate equivalents */
  double flip_flops, flip_flops_error;                         /* bits */
  bool energy_known;                                           /* the next two */
  double energy[SHEET_ENERGIES], energy_error[SHEET_ENERGIES]; /* nJ a pair */
} sheet_costs;

/* Append the datasheet as HTML, with the waveform in it, or as Markdown, which names the file of
 * the waveform, sepax_handshake.svg. The emitter has a design and all its modules. */
void sheet_write(emitter *e, const sheet_costs *costs, bool html, emit_text *out);

/* Append the waveform of the handshake, as SVG or as WaveDrom's JSON. */
void sheet_wave(const emitter *e, bool svg, emit_text *out);

#endif
