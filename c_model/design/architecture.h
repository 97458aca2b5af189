/* SPDX-License-Identifier: MIT */
/* architecture.h - the table of architectures: what other code needs to know of an architecture. */
#ifndef SEPAX_ARCHITECTURE_H
#define SEPAX_ARCHITECTURE_H

#include "sepax_design.h"

typedef sepax_judgement judge_function(const sepax_design *design, const sepax_pair *pair);

typedef struct {
  const char *name;
  judge_function *judge; /* its golden model */
  /* Fails if values do not go together. Each value is already in the range of its option. NULL: all
   * values go together. */
  bool (*check)(const sepax_config *config, sepax_error *error);
  /* Fills in formats, latency and other fields of a design whose configuration was checked. NULL:
   * nothing to fill in. */
  void (*derive)(sepax_design *design);
} architecture;

/* The rows by sepax_arch. To add an architecture, add a file with a row and a line of this list. */
extern const architecture *const sepax__architectures[SEPAX_ARCH_COUNT];
extern const architecture sepax__architecture_exact, sepax__architecture_paper,
    sepax__architecture_conference;

/* Models that the public headers do not declare. */
judge_function sepax__judge_exact, sepax__judge_reference, sepax__judge_float32,
    sepax__judge_float64, sepax__judge_interval32, sepax__judge_interval64, sepax__judge_guigue32,
    sepax__judge_guigue64, sepax__judge_filtered;

#endif
