/* SPDX-License-Identifier: MIT */
/* advance.c - see advance.h. */
#include "advance.h"

gen_line advance_name(advance *a, int cycle) {
  if (cycle < ADVANCE_CYCLES) {
    a->used[cycle] = true;
  }
  return gen_format("advance_%d", cycle);
}
