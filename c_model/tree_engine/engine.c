/* SPDX-License-Identifier: MIT */
/* engine.c - the row of the tree engine in the table of engines: limits, gates, memory. */
#include "design/engine_table.h"
#include "sepax_tree.h"
#include "util/error.h"

static bool check_power(const char *name, int value, int least, int most, sepax_error *error) {
  return (value & (value - 1)) == 0 ||
         sepax_fail(error, SEPAX_ERROR_ARGUMENT, "%s: %d is no power of two of %d ... %d", name,
                    value, least, most);
}

static bool check(const sepax_config *config, sepax_error *error) {
  enum { MARGIN_MAX = 8191 };
  if (!check_power("leaves", config->leaves, SEPAX_LEAVES_MIN, SEPAX_LEAVES_MAX, error) ||
      !check_power("rows", config->rows, SEPAX_ROWS_MIN, SEPAX_ROWS_MAX, error)) {
    return false;
  }
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

/* Bits of all memories. A leaf of both bodies has 32 triangles of 9 W + 1 bits, 16 times 15 bits of
 * vertex numbers, two tags of 46 bits, and a place of 114 + 4 sets bits in the list of pairs, where
 * `sets` is the logarithm of the sets of 4 leaves. Of up to 16 pairs, 102 bits wait a second time.
 * A row has 21 bits. What else grows with W holds
 * heads of nodes, turned triangles and pairs; the constant part holds boxes of nodes, tags, lists,
 * poses and the stack. */
static uint64_t memory_bits(const sepax_config *config) {
  uint64_t word = (uint64_t)config->word;
  uint64_t leaves = (uint64_t)config->leaves;
  uint64_t sets = 0;
  while (UINT64_C(4) << sets < leaves) {
    sets++;
  }
  return 207688 + 1368 * word + leaves * (288 * word + 478 + 4 * sets) + 8 * sets +
         102 * (leaves < 16 ? leaves : 16) + 21 * (uint64_t)config->rows;
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
