/* SPDX-License-Identifier: MIT */
/* temporary.h - files under way, which a signal that ends the program removes (private). */
#ifndef SEPAX_TEMPORARY_H
#define SEPAX_TEMPORARY_H

#include <stdio.h>

/* Remember a file that is not to outlive the program; the ticket goes to sepax__temporary_drop. -1:
 * it is not remembered, as too many are. */
int sepax__temporary_add(const char *path);

/* Create a new file and remember it, with no signal between. NULL: errno tells why. */
FILE *sepax__temporary_create(const char *path, int *ticket);

/* The file is renamed or removed. */
void sepax__temporary_drop(int ticket);

/* From now on SIGINT, SIGTERM and SIGHUP remove the files and then end the program as they do
 * by default; a signal that is ignored stays ignored. A write beyond the limit of a file's size
 * fails (EFBIG) instead of ending the program. For programs, not for the library. */
void sepax__temporary_remove_on_signals(void);

#endif
