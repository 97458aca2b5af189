/* SPDX-License-Identifier: MIT */
/* stream.c - sepax_stream, the core on AXI4-Stream (docs/reference/exact.md): what a transfer has.
 * Its row in the table of generators. */
#include "engine/engine.h"

static void generate(emitter *e, emit_holes *h, int pairs) {
  static const struct {
    const char *words, *about, *layout;
  } of[] = {[SEPAX_STREAM_VERTEX] = {"a vertex a transfer, A_1, A_2, A_3, B_1, B_2, B_3",
                                     "a vertex", "{unused, z, y, x}, 32 bits each"},
            [SEPAX_STREAM_TRIANGLE] = {"a triangle a transfer, A, then B", "a triangle",
                                       "{unused, v_3, v_2, v_1}; {unused, z, y, x}"},
            [SEPAX_STREAM_PAIR] = {"a pair a transfer", "a pair",
                                   "{B, A}; {unused, v_3, v_2, v_1}; {unused, z, y, x}"}};
  const sepax_config *c = &e->design->config;
  int transfers = sepax_stream_transfers(c);
  int flight = 1;
  while (1 << flight < pairs) {
    flight++;
  }
  emit_hole_numbers(h, (emit_number[]){{"extents", c->extent_a > 0},
                                       {"narrow", c->word < 32},
                                       {"parts", transfers > 1},
                                       {"vertices", 6 / transfers},
                                       {"vertices_come", c->stream == SEPAX_STREAM_VERTEX},
                                       {"bits", transfers == 6 ? 127 : 1024 / transfers - 1},
                                       {"tag_bits", c->tag},
                                       {"tag_msb", c->tag - 1},
                                       {"pair", 18 * c->word - 1},
                                       {"flight", flight},
                                       {NULL, 0}});
  emit_hole_set(h, "words", "%s", of[c->stream].words);
  emit_hole_set(h, "word_about", "%s", of[c->stream].about);
  emit_hole_set(h, "layout", "%s", of[c->stream].layout);
  emit_hole_set(h, "verdict_bits", "0 %s, 1 coplanar, 2 undecided, 3 cut, %s11:8 axis",
                e->design->limits > 0 ? "hit" : "collision",
                e->design->limits > 0 ? "5:4 band, " : "");
  emit_template(e, "sepax_fifo", (emit_hole[]){{"fpga", "0"}, {NULL, NULL}});
  emit_template(e, "sepax_gather", h->hole);
  emit_template(e, "sepax_stream", h->hole);
}

const engine_generator generator_stream = {
    .generate = generate, .registers_ready = true, .core = "core"};
