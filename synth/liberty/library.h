/* library.h - a Liberty file as a simulation of gates and its power need it. */
#ifndef SEPAX_LIBERTY_LIBRARY_H
#define SEPAX_LIBERTY_LIBRARY_H

#include "function.h"
#include "table.h"

/* Read a plain Liberty file; exits with status 2 and a message where it cannot be read. */
void library_read(library *lib, const char *path);

/* The cell of this name, or NULL. */
const lib_cell *library_cell(const library *lib, const char *name);

#endif
