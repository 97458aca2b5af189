/* function.h - the functions of a cell's pins: reads and evaluates them. */
#ifndef SEPAX_LIBERTY_FUNCTION_H
#define SEPAX_LIBERTY_FUNCTION_H

#include "cells.h"

/* Read a function of the cell's pins and its state, which it calls `state` and its complement
 * `state_not`; exits with status 2 and a message where it is not understood. */
void function_parse(lib_function *f, const lib_cell *cell, const char *text, const char *state,
                    const char *state_not);

/* Bit r: the function in row r. Outputs are what they are in that row. */
uint64_t function_rows(const lib_cell *cell, const lib_function *f);

int function_inputs(const lib_cell *cell);

/* Index of a pin, or -1. */
int lib_pin_index(const lib_cell *cell, const char *name);

/* The function on 64 lanes of pin values; `state` is that of a register. */
uint64_t lib_evaluate(const lib_function *f, const uint64_t pin[], uint64_t state);

/* How likely each row of a cell is: bit k of its number is input k (counted without outputs), the
 * last one the state of a register. Inputs are 1 with probability one[pin], independent of each
 * other; the state with one_state. A register whose next state is a pin differs from it with
 * `differ`: it moves as often. Returns the number of rows. */
int lib_rows(const lib_cell *cell, const double one[], double one_state, double differ,
             double row[64]);

#endif
