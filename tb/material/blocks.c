/* SPDX-License-Identifier: MIT */
#include "blocks.h"

#include <stdio.h>
#include <stdlib.h>

void stand(standing *at, const surfaces *f, point p, generator *g) {
  static holder held[MOST];
  static enclosure e;
  *at = (standing){.held = held, .consistent = true};
  find_crossings(&e, f->s, p, g);
  for (size_t block = 0; block < f->s->count; block++) {
    int sum = 0;
    bool crossed = false;
    for (size_t i = 0; i < f->s->count; i++) {
      sum += f->block[i] == block ? e.crossing[i] : 0;
      crossed = crossed || (f->block[i] == block && e.crossing[i] != 0);
    }
    if (!crossed) {
      continue;
    }
    find_enclosure(&e, f, block);
    if (e.enclosed || e.enclosed_of_2) {
      held[at->holding++] = (holder){block, sum};
      at->consistent = at->consistent && f->signed_in[block];
      at->sum += sum;
      at->below += sum < 0;
    }
  }
  find_enclosure(&e, f, MOST);
  if ((e.enclosed || e.enclosed_of_2) != (at->holding > 0)) {
    fprintf(stderr, "material: the blocks and the whole differ\n");
    exit(2);
  }
}
