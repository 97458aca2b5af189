/* architecture.h - what an architecture is to everything that does not depend on one. */
#ifndef SEPAX_ARCHITECTURE_H
#define SEPAX_ARCHITECTURE_H

#include "sepax_design.h"

typedef struct {
  const char *name;
  /* Fails on values that do not go together; NULL: all do. Each is in the range of its option. */
  bool (*check)(const sepax_config *config, sepax_error *error);
  /* Formats, latency and the rest of a design whose configuration is checked; NULL: none. */
  void (*derive)(sepax_design *design);
} architecture;

/* The rows of the list in architectures.c, each in the file of its architecture. */
extern const architecture architecture_exact, architecture_paper, architecture_conference;

#endif
