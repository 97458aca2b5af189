/* SPDX-License-Identifier: MIT */
/* units.h - the units that a length or a time may have, on the command line and in files. */
#ifndef SEPAX_UNITS_H
#define SEPAX_UNITS_H

#include <stddef.h>

/* A unit: 10^power metres or seconds. The last entry of a list has no name. */
typedef struct {
  const char *name;
  int power;
} cli_unit;

static const cli_unit cli_lengths[] = {{"nm", -9}, {"um", -6}, {"mm", -3}, {"m", 0}, {NULL, 0}};
static const cli_unit cli_times[] = {{"ns", -9}, {"us", -6}, {"ms", -3}, {"s", 0}, {NULL, 0}};

/* The unit of a number without a unit, as a power of ten. STL files are read in mm, URDF files in
 * metres. */
enum { CLI_MILLIMETRES = -3, CLI_METRES = 0, CLI_SECONDS = 0 };

#endif
