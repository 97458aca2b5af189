/* engine_table.h - the list of engines, and what an engine is to everything that does not depend on
 * which one it is. An engine stands around the core of architecture exact and brings it its pairs.
 */
#ifndef SEPAX_ENGINE_TABLE_H
#define SEPAX_ENGINE_TABLE_H

#include "sepax_design.h"

/* Every engine, one line each: its value SEPAX_ENGINE_..., and the name of its rows:
 * sepax__engine_NAME here, generator_NAME in rtl_gen. */
#define SEPAX_ENGINES(ENGINE) \
  ENGINE(STREAM, stream)      \
  ENGINE(OBJECT, object)      \
  ENGINE(TREE, tree)

/* SEPAX_ENGINE_NONE is the core alone. */
#define SEPAX_ENGINE_VALUE(value, name) SEPAX_ENGINE_##value,
typedef enum {
  SEPAX_ENGINE_NONE,
  SEPAX_ENGINES(SEPAX_ENGINE_VALUE) SEPAX_ENGINE_COUNT
} sepax_engine;
#undef SEPAX_ENGINE_VALUE

typedef struct {
  const char *name;   /* in messages: "a tree engine" */
  const char *option; /* a design has this engine if this option is not at its default */
  bool tests_aabbs;   /* of each pair, before the core gets it */
  /* Fails on values that do not go with the engine; NULL: all do. */
  bool (*check)(const sepax_config *config, sepax_error *error);
  /* LSB that the margin of a clearance is larger at a word of so many bits; NULL: none. */
  int (*margin_added)(int word);
  /* Gates (GE) around the cores: constant, for each bit of W, for each lane and bit of W
   * (scripts/experiments/fit-area). */
  double gates, gates_per_bit, gates_per_lane_bit;
  uint64_t (*memory_bits)(const sepax_config *config); /* NULL: no memories */
} engine_row;

#define SEPAX_ENGINE_ROW(value, name) extern const engine_row sepax__engine_##name;
SEPAX_ENGINES(SEPAX_ENGINE_ROW)
#undef SEPAX_ENGINE_ROW

/* The engine that the options ask for: the first, if they ask for two, which sepax_config_check
 * refuses. */
sepax_engine sepax__config_engine(const sepax_config *config);

/* "none", "stream", "object", "tree". */
const char *sepax__engine_name(sepax_engine which);

/* The engine of a design; without one a row whose name and option are NULL. */
const engine_row *sepax__engine_of(const sepax_config *config);

/* Fails if a design has two engines, and on values that do not go with the one that it has. */
bool sepax__engine_check(const sepax_config *config, sepax_error *error);

/* The gap of AABBs above which a pair is outside the outermost clearance. */
int64_t sepax__outer_margin(const sepax_config *config);

#endif
