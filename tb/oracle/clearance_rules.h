/* SPDX-License-Identifier: MIT */
/* clearance_rules.h - other rules for a pair to be clear of a distance, in doubles: what dearer and
 * cheaper ones than sepax_clearance's would do, and two that are wrong. For statistics. */
#ifndef CLEARANCE_RULES_H
#define CLEARANCE_RULES_H

#include "sepax_design.h"

typedef enum {
  RULE_EUCLID,      /* gap > |c|_1 + D |c|_2: what the axes of the model can give at best */
  RULE_MODEL,       /* 2 gap > (2 + D) |c|_1 + D |c|_inf, as sepax_clearance */
  RULE_SUM,         /* gap > (1 + D) |c|_1 */
  RULE_XY,          /* the model's without the axes of an edge and x or y */
  RULE_NO_EDGE,     /* nor of an edge and z */
  RULE_PRODUCTS,    /* RULE_XY's axes, gap > (1 + D) |e|_1 |f|_1 for e x f, N_A, N_B */
  RULE_BOXES,       /* boxes only */
  RULE_NO_ROUNDING, /* wrong: gap > D |c|_1 */
  RULE_LENGTH,      /* wrong: gap > (1 + D) |c|_2 */
  RULES
} clear_rule;

const char *clear_rule_name(clear_rule rule);

bool clear_by(clear_rule rule, const sepax_tri *a, const sepax_tri *b, double distance);

#endif
