/* table.h - tables over slope and load: reads and interpolates them. */
#ifndef SEPAX_LIBERTY_TABLE_H
#define SEPAX_LIBERTY_TABLE_H

#include "cells.h"
#include "tree.h"

/* Read the table n (NULL: none) of the library root. */
void table_read(lib_table *t, const node *root, const node *n);

/* The numbers in a text, at most so many; returns how many. */
int table_numbers(const char *text, double *list, int most);

/* The table at a slope (ns) and a load (the file's unit): linear between and beyond its points. */
double lib_look_up(const lib_table *t, double slope, double load);

#endif
