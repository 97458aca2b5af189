/* units.h - the units that a length or a time may have, on the command line and in files. */
#ifndef SEPAX_UNITS_H
#define SEPAX_UNITS_H

#include <stddef.h>

/* 10^power of metres, or of seconds. The last of a list has no name. */
typedef struct {
  const char *name;
  int power;
} cli_unit;

static const cli_unit cli_lengths[] = {{"nm", -9}, {"um", -6}, {"mm", -3}, {"m", 0}, {NULL, 0}};
static const cli_unit cli_times[] = {{"ns", -9}, {"us", -6}, {"ms", -3}, {"s", 0}, {NULL, 0}};

/* The unit of a number that has none behind it: a power as above. A unit of an STL file is 1 mm; a
 * URDF is in metres. */
enum { CLI_MILLIMETRES = -3, CLI_METRES = 0, CLI_SECONDS = 0 };

#endif
