/* SPDX-License-Identifier: MIT */
/* gates.h - a mapped netlist, all its instances, simulated without delays in 64 lanes. */
#ifndef SEPAX_GATES_H
#define SEPAX_GATES_H

#include "liberty/cells.h"

enum { GATES_LANES = 64, GATES_GROUPS = 8 };

/* Of something: how often, in each group of eight lanes that stand side by side. Lanes simulate
 * pairs of their own, so groups are samples of their own. */
typedef uint64_t gates_count[GATES_GROUPS];

/* One instance of a module: its path from the top, which ends with "/" (the top's is empty). */
typedef struct {
  const char *path, *module;
} gates_instance;

typedef struct {
  const lib_cell *type;
  const char *name;
  int instance;
  int net[LIB_PINS]; /* of each pin; -1: none */
  uint64_t state;    /* of a register, one bit a lane */
  int phase;         /* of its outputs: 1: with the clock, as a clock gate's; -1: against it; 0 */
} gates_cell;

/* A port of the top. */
typedef struct {
  const char *name;
  bool output;
  int bits;
  int *net; /* of each bit, the lowest first */
} gates_port;

typedef struct gates {
  gates_instance *instance;
  int instances;
  gates_cell *cell; /* registers, then combinational cells, each behind those that drive it */
  int cells;
  gates_port *port;
  int ports;
  int nets;
  int clock;            /* its net */
  uint64_t *value;      /* of each net, one bit a lane; net 0 is 0, net 1 is 1; the clock's is 1, so
                           that a gated clock's is whether the next edge passes */
  uint64_t *before;     /* in the cycle before */
  gates_count *toggles; /* of each net, over cycles counted */
  gates_count *ones;
  uint64_t cycles;                    /* counted */
  struct glitches *glitches;          /* of glitches.h, or NULL */
  void (*count_all)(struct gates *g); /* with them: before each edge that is counted */
  gates_count *changes; /* with them: as toggles, and all that come between two edges */
  int latest;           /* ps after the edge, of all changes */
} gates;

/* Read the netlist.json of synth/area/map; exits with status 2 and a message on anything that
 * is not understood: an unknown cell, a net with two drivers or none, a loop, a second clock.
 * Registers are as when power comes up: anything, always the same. */
void gates_read(gates *g, const library *lib, const char *path);

/* The nets of a port of the top, which must have so many bits (0: any number); exits if it has not
 * or is not there. */
const gates_port *gates_find(const gates *g, const char *name, int bits);

/* The net of the clock: aclk of a top with buses, clk of a core. */
int gates_clock(const gates *g);

/* Drive the reset in all lanes: aresetn, active low, of a top with buses, rst of a core. */
void gates_reset(gates *g, bool on);

/* A port of one bit, in all lanes. */
uint64_t *gates_bit(const gates *g, const char *name);

/* The value of nets, the lowest bit first, in one lane, in all lanes. */
void gates_set(gates *g, const int net[], int bits, unsigned lane, uint64_t value);
void gates_set_all(gates *g, const gates_port *port, uint64_t value);
uint64_t gates_get(const gates *g, const int net[], int bits, unsigned lane);

/* A truth table of a cell, with these values of its pins and its state. */
uint64_t gates_evaluate(const lib_cell *type, uint64_t table, const uint64_t in[], uint64_t state);

/* Count the lanes whose bit is 1. */
void gates_tally(gates_count count, uint64_t lanes);

/* The mean's standard error, over the mean, of what has been measured in each group. */
double gates_error(const double of_group[GATES_GROUPS]);

/* Let the inputs, set in value[], and the registers act on everything else. */
void gates_settle(gates *g);

/* Count what has changed since the last cycle; then the rising edge of the clock. */
void gates_rise(gates *g, bool count);

#endif
