/* SPDX-License-Identifier: MIT */
/* threads.h - one job in parts, for threads that take them (private). */
#ifndef SEPAX_THREADS_H
#define SEPAX_THREADS_H

#include <stddef.h>

/* Call work(context, part) for all parts. The calling thread does part 0, then it and up to
 * threads - 1 others take the next; a thread that cannot be had leaves its work to the others. */
void sepax__threads_run(size_t threads, size_t parts, void (*work)(void *context, size_t part),
                        void *context);

/* One for each processor, and 1 at least. */
size_t sepax__threads_here(void);

#endif
