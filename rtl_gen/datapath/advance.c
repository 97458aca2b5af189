/* SPDX-License-Identifier: MIT */
/* advance.c - see advance.h. */
#include "advance.h"

gen_line advance_name(advance *a, int cycle) {
  if (cycle < ADVANCE_CYCLES) {
    a->used[cycle] = true;
  }
  return gen_format("advance_%d", cycle);
}

int advance_copy(const advance *a, int begin) { return a->copied ? begin / a->ii : 0; }

static gen_line bit_name(int copy, int bit) {
  return copy == 0 ? gen_format("slot[%d]", bit) : gen_format("slot_q%d_%d", copy, bit);
}

gen_line advance_slot(advance *a, int begin, int cycle) {
  int bit = cycle % a->ii;
  for (int copy = advance_copy(a, begin); copy > 0; copy--) {
    int before = (bit + a->ii - (advance_copy(a, begin) - copy) % a->ii) % a->ii;
    a->bits[copy] |= 1U << before;
    a->copies = copy > a->copies ? copy : a->copies;
  }
  return bit_name(advance_copy(a, begin), bit);
}

void advance_copies(const advance *a, emit_text *out) {
  for (int pass = 0; pass < 2 && a->copies > 0; pass++) {
    text_puts(out, pass == 0 ? "  // Copies of slot, which units of later II windows read.\n"
                             : "  always @(posedge clk) begin\n");
    for (int n = a->ii; n < (a->copies + 1) * a->ii; n++) {
      int copy = n / a->ii;
      int bit = n % a->ii;
      if ((a->bits[copy] >> bit & 1) == 0) {
        continue;
      }
      text_printf(out, pass == 0 ? "  reg %s;\n" : "    %s <= %s;\n", bit_name(copy, bit).text,
                  bit_name(copy - 1, (bit + a->ii - 1) % a->ii).text);
    }
  }
  text_puts(out, a->copies > 0 ? "  end\n\n" : "");
}
