/* SPDX-License-Identifier: MIT */
/* engine_table.h - the table of engines: what other code needs to know of an engine. An engine
 * surrounds the core of architecture exact and gives it pairs. */
#ifndef SEPAX_ENGINE_TABLE_H
#define SEPAX_ENGINE_TABLE_H

#include "sepax_design.h"

/* One line for each engine: its value SEPAX_ENGINE_..., and the name of its rows
 * (sepax__engine_NAME here, generator_NAME in rtl_gen). */
#define SEPAX_ENGINES(ENGINE) \
  ENGINE(STREAM, stream)      \
  ENGINE(OBJECT, object)      \
  ENGINE(TREE, tree)

/* SEPAX_ENGINE_NONE means a core without an engine. */
#define SEPAX_ENGINE_VALUE(value, name) SEPAX_ENGINE_##value,
typedef enum {
  SEPAX_ENGINE_NONE,
  SEPAX_ENGINES(SEPAX_ENGINE_VALUE) SEPAX_ENGINE_COUNT
} sepax_engine;
#undef SEPAX_ENGINE_VALUE

typedef struct {
  const char *name;   /* in messages: "a tree engine" */
  const char *option; /* a design has this engine if this option is not at its default */
  bool tests_aabbs;   /* the engine compares the AABBs of each pair before the core gets the pair */
  /* Fails if values do not go with the engine. NULL: all values do. */
  bool (*check)(const sepax_config *config, sepax_error *error);
  /* LSB that the engine adds to the margin of a clearance, for a word of this many bits. NULL:
   * none. */
  int (*margin_added)(int word);
  /* Gates (GE) around the cores: constant, for each bit of W, for each lane and bit of W
   * (scripts/experiments/fit-area). */
  double gates, gates_per_bit, gates_per_lane_bit;
  uint64_t (*memory_bits)(const sepax_config *config); /* bits of its memories; NULL: it has none */
} engine_row;

#define SEPAX_ENGINE_ROW(value, name) extern const engine_row sepax__engine_##name;
SEPAX_ENGINES(SEPAX_ENGINE_ROW)
#undef SEPAX_ENGINE_ROW

/* The engine that the options ask for. If they ask for two, then the first one; sepax_config_check
 * refuses this. */
sepax_engine sepax__config_engine(const sepax_config *config);

/* "none", "stream", "object", "tree". */
const char *sepax__engine_name(sepax_engine which);

/* The engine of a design. Without an engine, a row whose name and option are NULL. */
const engine_row *sepax__engine_of(const sepax_config *config);

/* Fails if the options ask for two engines or if values do not go with the engine. */
bool sepax__engine_check(const sepax_config *config, sepax_error *error);

/* If the gap of two AABBs is above this number, then the pair is outside the larger clearance. */
int64_t sepax__outer_margin(const sepax_config *config);

#endif
