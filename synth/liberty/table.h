/* SPDX-License-Identifier: MIT */
/* table.h - reads tables over slope and load. */
#ifndef SEPAX_LIBERTY_TABLE_H
#define SEPAX_LIBERTY_TABLE_H

#include "cells.h"
#include "tree.h"

/* Read the table n (NULL: none) of the library root. */
void table_read(lib_table *t, const node *root, const node *n);

/* The numbers in a text, at most so many; returns how many. */
int table_numbers(const char *text, double *list, int most);

#endif
