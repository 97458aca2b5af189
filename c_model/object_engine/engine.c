/* SPDX-License-Identifier: MIT */
/* engine.c - the object engine: its row in the table of engines. */
#include "design/engine_table.h"
#include "util/error.h"

static bool check_memory(char object, int triangles, sepax_error *error) {
  return (triangles & (triangles - 1)) == 0 ||
         sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                    "memory-%c: %d triangles is no power of two of %d ... %d", object, triangles,
                    SEPAX_MEMORY_MIN, SEPAX_MEMORY_MAX);
}

static bool check(const sepax_config *config, sepax_error *error) {
  return check_memory('a', config->memory_a, error) && check_memory('b', config->memory_b, error);
}

/* Memories for the triangles, their AABBs and the thinnest side of A's AABBs. */
static uint64_t memory_bits(const sepax_config *config) {
  uint64_t of_a = (uint64_t)config->memory_a;
  uint64_t of_b = (uint64_t)config->memory_b;
  uint64_t side = !config->flag && config->clearance < 0 ? 2 : 0;
  return 15 * (uint64_t)config->word * (of_a + of_b) + side * of_a;
}

/* Gates: docs/developers/results/area/engine.csv, scripts/experiments/fit-area -l. */
const engine_row sepax__engine_object = {.name = "an object engine",
                                         .option = "lanes",
                                         .tests_aabbs = true,
                                         .check = check,
                                         .gates = 12169,
                                         .gates_per_bit = 549.12,
                                         .gates_per_lane_bit = 92,
                                         .memory_bits = memory_bits};
