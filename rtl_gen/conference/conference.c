/* SPDX-License-Identifier: MIT */
/* conference.c - architecture conference: what the paper improves on, table by table
 * (docs/reference/conference.md), of the paper's units. */
#include "conference/conference.h"
#include "paper/paper.h"

bool gen_conference(emitter *e) {
  static const char *const module[] = {
      "sepax_trunc", "sepax_mul",   "sepax_edges",          "sepax_dot",   "sepax_proj",
      "sepax_cop",   "sepax_norm",  "paper/sepax_cross",    "sepax_psa_9", "sepax_psa_6",
      "sepax_cmp",   "sepax_input", "conference/sepax_top", NULL};
  return paper_emit(e, module);
}
