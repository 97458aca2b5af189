/* SPDX-License-Identifier: MIT */
/* paper_latency.c - the latency of architectures paper and conference, from the schedules that the
 * papers print (docs/reference/paper.md, docs/reference/conference.md). No option changes it.
 * rtl_gen/paper and rtl_gen/conference follow the schedules cycle by cycle and take the last cycle
 * from here. */
#include "design/paper.h"

/* The cycles of each stage, as in figure 6; 0 ends the list. */
static const int paper[] = {3, /* three input words */
                            2, /* PROJ of the vertices on both normals */
                            1, /* COP, CMP of axes 10 and 11 */
                            1, /* operands of PSA */
                            2, /* PSA */
                            2, /* PROJ of the vertices on nine axes */
                            1, /* CMP of nine axes */
                            1, /* NAND and output */
                            0};

/* The stages of the conference design, with the durations of figure 6. */
static const int conference[] = {3, /* three input words */
                                 1, /* edges */
                                 2, /* PSA of table 1 */
                                 2, /* PROJ of the vertices on eleven axes */
                                 1, /* CMP of eleven axes */
                                 2, /* PROJ of the vertices on the normals */
                                 2, /* COP, edges */
                                 2, /* PSA of table 2 */
                                 2, /* PROJ of the vertices on six axes */
                                 1, /* CMP of six axes */
                                 1, /* NAND of the six or of the eleven */
                                 1, /* output */
                                 0};

static int sum_of(const int *stage) {
  int cycles = 0;
  for (; *stage > 0; stage++) {
    cycles += *stage;
  }
  return cycles;
}

int sepax__paper_latency(void) { return sum_of(paper); }

int sepax__conference_latency(void) { return sum_of(conference); }
