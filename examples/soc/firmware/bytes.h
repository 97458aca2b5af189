/* SPDX-License-Identifier: MIT */
/* bytes.h - what firmware without a C library needs of <string.h>. */
#ifndef BYTES_H
#define BYTES_H

#include <stddef.h>

void *memset(void *to, int value, size_t count);
void *memcpy(void *restrict to, const void *restrict from, size_t count);

#endif
