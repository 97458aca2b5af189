/* SPDX-License-Identifier: MIT */
/* engine.c - the row of the tree engine in the table of engines: limits, gates, memory. */
#include "design/engine_table.h"
#include "sepax_tree.h"
#include "util/error.h"

static bool check(const sepax_config *config, sepax_error *error) {
  enum { MARGIN_MAX = 8191 };
  if (config->word > SEPAX_TREE_WORD_MAX) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "word: a tree engine takes 4 ... %d bits, not %d", SEPAX_TREE_WORD_MAX,
                      config->word);
  }
  if (config->extent_a != 0) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "tree: a tree engine has no extents; leave one of both out");
  }
  return config->clearance < 0 || sepax__outer_margin(config) <= MARGIN_MAX ||
         sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                    "tree: clearances need a margin of %lld LSB; %d is the most",
                    (long long)sepax__outer_margin(config), MARGIN_MAX);
}

/* Bits of all memories. The part that grows with W holds vertices, rows and pairs; the constant
 * part holds nodes, tags, lists and the stack. */
static uint64_t memory_bits(const sepax_config *config) {
  return 219008 + 3288 * (uint64_t)config->word;
}

/* The gates are a fit by `scripts/experiments/fit-area -t` to
 * docs/developers/results/area/tree.csv. */
const engine_row sepax__engine_tree = {.name = "a tree engine",
                                       .option = "tree",
                                       .tests_aabbs = true,
                                       .check = check,
                                       .margin_added = sepax_tree_clearance_added,
                                       .gates = 76559,
                                       .gates_per_bit = 1779.5,
                                       .memory_bits = memory_bits};
