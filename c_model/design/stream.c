/* SPDX-License-Identifier: MIT */
/* stream.c - AXI4-Stream around the core: its row in the table of engines. */
#include "design/engine_table.h"

const engine_row sepax__engine_stream = {.name = "a stream", .option = "stream"};

int sepax_stream_transfers(const sepax_config *config) {
  static const int transfers[] = {[SEPAX_STREAM_NONE] = 0,
                                  [SEPAX_STREAM_VERTEX] = 6,
                                  [SEPAX_STREAM_TRIANGLE] = 2,
                                  [SEPAX_STREAM_PAIR] = 1};
  return transfers[config->stream];
}
