/* SPDX-License-Identifier: MIT */
/* estimate.h - what a design costs and gives, known before its Verilog is mapped. */
#ifndef SEPAX_ESTIMATE_H
#define SEPAX_ESTIMATE_H

#include "sepax_design.h"

/* The workloads of docs/developers/power.md. */
enum { ESTIMATE_SEPARATED, ESTIMATE_COLLIDING, ESTIMATE_COPLANAR, ESTIMATE_PAIRS };

/* The terms of the formulas: counts of the design that a fit weighs. */
enum { ESTIMATE_TERMS = 28 };

/* All of one design. A value x with an error stands for the interval from x - x_error to
 * x + x_error. */
typedef struct {
  int latency;          /* cycles from the cycle that takes a pair to that of its verdict */
  double pairs;         /* pairs a second that the cores judge: cores x clock frequency / II */
  double compared;      /* pairs of AABBs a second that the lanes of an object engine compare; else
                           0 */
  uint64_t memory_bits; /* of an engine; they are not in the gates */
  bool gates_known;     /* the next four are known: architecture exact made of an ASIC's cells */
  double gates, gates_error;           /* gate equivalents, Nangate45 */
  double flip_flops, flip_flops_error; /* bits */
  bool energy_known; /* gates are known, of a core alone, without clearance, extents and clock
                        gating, at the typical corner */
  double energy[ESTIMATE_PAIRS], energy_error[ESTIMATE_PAIRS]; /* nJ for a pair of a workload, with
                        glitches, without the clock tree */
  double term[ESTIMATE_TERMS];
} sepax_estimate;

/* Estimate a design that sepax_design_init has filled in. Nothing is written: registers are placed
 * and operations are scheduled as sepax_generate does it, which takes 1 to 60 ms. The latency is
 * exact. Gates, flip-flops and energy follow from formulas that were fitted to mapped designs
 * (docs/reference/estimate.md). Fails as sepax_generate does if the architecture has no hardware or
 * if the clock period is too short. */
bool sepax_estimate_design(const sepax_design *design, sepax_estimate *estimate,
                           sepax_error *error);

/* The name of a term, as JSON has it. */
const char *sepax_estimate_term(int term);

#endif
