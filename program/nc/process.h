/* SPDX-License-Identifier: MIT */
/* process.h - a Python program in a process of its own, whose output is read as a stream. */
#ifndef SEPAX_NC_PROCESS_H
#define SEPAX_NC_PROCESS_H

#include "sepax.h"

#include <stdio.h>
#include <sys/types.h>

typedef struct {
  FILE *out;    /* what it prints; read this to the end */
  FILE *errors; /* what it prints on stderr */
  pid_t pid;
} nc_process;

/* Start python3 with the text of a program and its arguments, which end with NULL. */
bool nc_process_start(nc_process *p, const char *program, const char *const *arguments,
                      sepax_error *error);

/* Close the stream and wait for the end. A process that still runs then is stopped. If it has
 * failed, then the error is the last line that it printed on stderr; *failed tells this from errors
 * of the reader. */
bool nc_process_end(nc_process *p, bool *failed, sepax_error *error);

#endif
