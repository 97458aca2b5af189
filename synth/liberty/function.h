/* SPDX-License-Identifier: MIT */
/* function.h - the functions of a cell's pins as truth tables. */
#ifndef SEPAX_LIBERTY_FUNCTION_H
#define SEPAX_LIBERTY_FUNCTION_H

#include "cells.h"

/* The truth table whose value is that of input k; of the state, where k is the number of inputs. */
uint64_t function_column(int k);

/* The truth table of a function of the cell's pins and its state, which it calls state[0] and its
 * complement state[1] (NULL: none); exits with status 2 and a message where it is not understood.
 * Outputs are what their own tables say. */
uint64_t function_rows(const lib_cell *cell, const char *text, char *const state[2]);

#endif
