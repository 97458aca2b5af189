/* SPDX-License-Identifier: MIT */
/* cells.h - the cells of a Liberty file as a simulation of gates and its power need them. */
#ifndef SEPAX_CELLS_H
#define SEPAX_CELLS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { LIB_PINS = 12, LIB_INPUTS = 6, LIB_INDEX = 16, LIB_FANOUT = 64 };

/* A value over the slope of an input (ns) and the load of an output, in the file's units. */
typedef struct {
  bool given;
  int slopes, loads;
  double slope[LIB_INDEX], load[LIB_INDEX], value[LIB_INDEX][LIB_INDEX]; /* [slope][load] */
} lib_table;

/* A truth table has a row for all values of the inputs and, last, of the state: bit k of its number
 * is input k, counted without outputs. Bit r of a table is its value in row r. */
typedef struct {
  char *name;
  bool output, known; /* known: it has a function, or is an input */
  double capacitance; /* F */
  uint64_t rows;      /* the function; of an input its own value */
} lib_pin;

/* Energy of a transition of `pin`; of an output caused by `related`, or -1. */
typedef struct {
  int pin, related;
  uint64_t when;       /* truth table */
  lib_table energy[2]; /* rising, falling `pin` */
} lib_power;

/* Delay, and slope of output `to`, after a transition of `from`. */
typedef struct {
  int to, from;
  bool on_rise,
      on_fall; /* unateness: `to` goes as `from`, against it; of a clock its rising edge only */
  bool clocked;
  lib_table slope[2], delay[2]; /* rising, falling `to` */
} lib_arc;

typedef struct {
  char *name;
  int pins, powers, arcs;
  lib_pin pin[LIB_PINS];
  lib_power *power;
  lib_arc *arc;
  int inputs;     /* at most LIB_INPUTS with the state, or no pin has a function */
  bool register_; /* one bit on the rising edge of pin `clock` */
  bool latch;     /* while pin `clock` is high, or low, its outputs are those of `next` */
  bool open_low;
  int clock;
  bool gate;      /* clock gate; its output's function is whether the next edge passes */
  uint64_t next;  /* truth table of the next state */
  double leakage; /* W */
} lib_cell;

typedef struct {
  lib_cell *cell;
  size_t cells;
  double volt;
  double farad, joule;     /* the file's units of capacitance and energy */
  double wire[LIB_FANOUT]; /* F of a net with so many loads by the default wire load model */
} library;

/* Read a plain Liberty file; exits with status 2 and a message where it cannot be read. */
void library_read(library *lib, const char *path);

/* The cell of this name, or NULL. */
const lib_cell *library_cell(const library *lib, const char *name);

/* Index of a pin, or -1. */
int lib_pin_index(const lib_cell *cell, const char *name);

/* The table at a slope (ns) and a load (the file's unit): linear between and beyond its points. */
double lib_look_up(const lib_table *t, double slope, double load);

/* How likely each row of a cell's truth tables is. Inputs are 1 with probability one[pin],
 * independent of each other; the state with one_state. A register whose next state is a pin differs
 * from it with `differ`: it moves as often. Returns the number of rows. */
int lib_rows(const lib_cell *cell, const double one[], double one_state, double differ,
             double row[64]);

#endif
