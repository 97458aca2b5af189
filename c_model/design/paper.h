/* SPDX-License-Identifier: MIT */
/* paper.h - what architectures paper and conference share besides their formats: their latencies
 * and the epsilon of the coplanarity test. */
#ifndef SEPAX_PAPER_DESIGN_H
#define SEPAX_PAPER_DESIGN_H

#include "sepax_design.h"
#include "util/wide.h"

/* Cycles from the first input word to the verdict, both counted (paper_latency.c). */
int sepax__paper_latency(void);
int sepax__conference_latency(void);

/* The default of --epsilon, in LSB. */
enum { PAPER_EPSILON = 1 };

/* Fails if epsilon is larger than a coordinate. */
bool sepax__paper_epsilon_check(const sepax_config *config, sepax_error *error);

/* Epsilon in units of a projection on a normal, in the design's format. */
int64_t sepax__paper_coplanar_limit(const sepax_design *design);

/* The coplanarity test: true if each p_k is closer to q_k than epsilon. */
bool sepax__paper_coplanar(const sepax_design *design, const wide p[3], const wide q[3]);

#endif
