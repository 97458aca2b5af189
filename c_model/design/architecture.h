/* architecture.h - what an architecture is to everything that does not depend on one. */
#ifndef SEPAX_ARCHITECTURE_H
#define SEPAX_ARCHITECTURE_H

#include "sepax_design.h"

typedef sepax_judgement judge_function(const sepax_design *design, const sepax_pair *pair);

typedef struct {
  const char *name;
  judge_function *judge; /* the golden model */
  /* Fails on values that do not go together; NULL: all do. Each is in the range of its option. */
  bool (*check)(const sepax_config *config, sepax_error *error);
  /* Formats, latency and the rest of a design whose configuration is checked; NULL: none. */
  void (*derive)(sepax_design *design);
} architecture;

/* By sepax_arch. A new architecture is a file with such a row and a line of the list. */
extern const architecture *const sepax__architectures[SEPAX_ARCH_COUNT];
extern const architecture sepax__architecture_exact, sepax__architecture_paper,
    sepax__architecture_conference;

/* Models that are no function of the public headers. */
judge_function sepax__judge_exact, sepax__judge_reference, sepax__judge_float32,
    sepax__judge_float64, sepax__judge_interval32, sepax__judge_interval64, sepax__judge_guigue32,
    sepax__judge_guigue64, sepax__judge_filtered;

#endif
