/* SPDX-License-Identifier: MIT */
/* program.h - machining programs made for the tests of the stock: moves of a tool whose tip goes
 * straight while two angles turn its axis. */
#ifndef STOCK_PROGRAM_H
#define STOCK_PROGRAM_H

#include "stock/moves.h"

typedef struct {
  move *line;
  size_t count, capacity;
} program;

enum { TOOLS = 5, FIVE_AXIS_BALL = 3, FIVE_AXIS_BULL = 4 };

/* A tool: its flutes, and shank and holder above them; each as a shape inside it and outside. */
typedef struct {
  double radius, round; /* of the flutes, of their corner */
  sepax__stock_shape flutes[2], shank[2], holder[2];
} mill;

/* Milling cutter 0: flat, D 10. 1: drill, D 6. 2: ball, D 8. 3: ball, D 4. 4: bull nose, D 4
 * with corners of 0.9. Arcs are exact to
 * `error_most`. The shank is as wide as the flutes, and begins at their top. */
void make_tools(mill tool[TOOLS], double error_most);

/* A part of 80 x 60 x 30 with its top at z = 0: a pocket in three passes, a slanted slot and one
 * along x, as wide as their cutter, with rapids back at depth; two holes drilled by pecks; a wavy
 * floor by a ball. */
program three_axis_part(void);
extern const double part_box[2][3];

/* About 4,500 lines of five-axis motion of a tool in a cone, as for an impeller. */
program five_axis_part(int tool);
extern const sepax__stock_corner cone_profile[4];
extern const double cone_box[2][3];

void free_program(program *p);

#endif
