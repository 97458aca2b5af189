/* gates.h - a mapped netlist, all its instances, simulated without delays in 64 lanes. */
#ifndef SEPAX_GATES_H
#define SEPAX_GATES_H

#include "liberty/library.h"

enum { GATES_LANES = 64 };

/* One instance of a module, in the instance `parent` (-1: the top). */
typedef struct {
  const char *name, *module;
  int parent;
} gates_instance;

typedef struct {
  const lib_cell *type;
  const char *name;
  int instance;
  int net[LIB_PINS]; /* of each pin; -1: none */
  uint64_t state;    /* of a register, one bit a lane */
} gates_cell;

typedef struct {
  const char *name; /* of a bit of a port of the top, "in_a1_x[3]" */
  int net;
  bool output;
} gates_port;

typedef struct {
  gates_instance *instance;
  int instances;
  gates_cell *cell;
  int cells;
  gates_port *port;
  int ports;
  int *order; /* combinational cells, each behind those that drive it */
  int ordered;
  int nets;
  int clock;         /* net of the port clk */
  uint64_t *value;   /* of each net, one bit a lane; net 0 is 0, net 1 is 1 */
  uint64_t *before;  /* in the cycle before */
  uint64_t *toggles; /* of each net, over lanes and cycles counted */
  uint64_t *ones;
  uint64_t cycles; /* counted */
} gates;

/* Read the netlist.json of synth/area/map; exits with status 2 and a message on anything that
 * is not understood: an unknown cell, a net with two drivers or none, a loop, a second clock. */
void gates_read(gates *g, const library *lib, const char *path);

/* The net of a port of the top, by its name and bit (-1: a port of one bit); exits if none. */
int gates_find(const gates *g, const char *name, int bit);

/* How many bits a port has; exits if it has more than so many. */
int gates_bits(const gates *g, const char *name, int most);

/* The nets of a port of several bits, the lowest first; exits if it has fewer. */
void gates_find_word(const gates *g, const char *name, int bits, int net[]);

/* The value of a port in one lane, in all lanes: as many of the lowest bits as it has. */
void gates_set(gates *g, const int net[], int bits, unsigned lane, uint64_t value);
void gates_set_all(gates *g, const int net[], int bits, uint64_t value);
uint64_t gates_get(const gates *g, const int net[], int bits, unsigned lane);

/* Registers as they are when power comes up: anything, always the same. */
void gates_scramble(gates *g);

/* Let the inputs, set in value[], and the registers act on everything else. */
void gates_settle(gates *g);

/* Count what has changed since the last cycle; then the rising edge of the clock. */
void gates_rise(gates *g, bool count);

#endif
