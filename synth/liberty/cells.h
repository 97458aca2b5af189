/* cells.h - the cells of a Liberty file that a simulation of gates and its power need. */
#ifndef SEPAX_CELLS_H
#define SEPAX_CELLS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { LIB_PINS = 12, LIB_OPS = 64, LIB_DEPTH = 12, LIB_INDEX = 16, LIB_FANOUT = 64 };

/* A function in postfix order: operand k >= 0 is pin k. */
enum {
  LIB_NOT = -1,
  LIB_AND = -2,
  LIB_OR = -3,
  LIB_XOR = -4,
  LIB_ZERO = -5,
  LIB_ONE = -6,
  LIB_STATE = -7,
  LIB_STATE_NOT = -8
};
typedef struct {
  int count, depth; /* operations, operands that wait at the end of them */
  short op[LIB_OPS];
} lib_function;

/* A value over the slope of an input (ns) and the load of an output, in the file's units. */
typedef struct {
  bool given;
  int slopes, loads;
  double slope[LIB_INDEX], load[LIB_INDEX], value[LIB_INDEX][LIB_INDEX]; /* [slope][load] */
} lib_table;

typedef struct {
  char *name;
  bool output;
  double capacitance; /* F */
  lib_function function;
} lib_pin;

/* Energy of a transition of `pin`; of an output caused by `related`, or -1. */
typedef struct {
  int pin, related;
  uint64_t when;       /* row r of the inputs and the state: bit r */
  lib_table energy[2]; /* rising, falling `pin` */
} lib_power;

/* Slope of output `to` after a transition of `from`. */
typedef struct {
  int to, from;
  bool on_rise,
      on_fall; /* unateness: `to` goes as `from`, against it; of a clock its rising edge only */
  bool clocked;
  lib_table slope[2];
} lib_arc;

typedef struct {
  char *name;
  int pins, powers, arcs;
  lib_pin pin[LIB_PINS];
  lib_power *power;
  lib_arc *arc;
  bool register_; /* one bit on the rising edge of pin `clock` */
  int clock;
  lib_function next;
  double leakage; /* W */
} lib_cell;

typedef struct {
  lib_cell *cell;
  size_t cells;
  double volt;
  double farad, joule;     /* the file's units of capacitance and energy */
  double wire[LIB_FANOUT]; /* F of a net with so many loads by the default wire load model */
} library;

#endif
