/* function.h - reads the functions of a cell's pins. */
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

#endif
