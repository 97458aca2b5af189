/* paper.h - what architectures paper and conference share beside their formats: their latencies and
 * the epsilon of the coplanarity test. */
#ifndef SEPAX_PAPER_DESIGN_H
#define SEPAX_PAPER_DESIGN_H

#include "sepax_design.h"
#include "util/wide.h"

/* paper_latency.c: cycles from the first input word to the verdict, both counted. */
int sepax__paper_latency(void);
int sepax__conference_latency(void);

/* paper_coplanarity_epsilon.c. The option --epsilon at its default, LSB. */
enum { PAPER_EPSILON = 1 };

/* Fails if the epsilon of the options is larger than a coordinate. */
bool sepax__paper_epsilon_check(const sepax_config *config, sepax_error *error);

/* The epsilon in units of a projection on a normal, as the formats of the design keep it. */
int64_t sepax__paper_coplanar_limit(const sepax_design *design);

/* The coplanarity test: is each p_k closer to q_k than epsilon? */
bool sepax__paper_coplanar(const sepax_design *design, const wide p[3], const wide q[3]);

#endif
