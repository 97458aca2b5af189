/* SPDX-License-Identifier: MIT */
/* crowd.h - registers of an engine under many accesses at once, legal ones and others. */
#ifndef SEPAX_ENGINE_CROWD_H
#define SEPAX_ENGINE_CROWD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* What can be written: numbers of these bits; `is_signed`: those above repeat the highest. */
typedef struct {
  uint32_t address, bits;
  bool is_signed;
  bool forgets; /* 0 is read whatever was written */
} crowd_register;

/* After a reset: small numbers to each other address, which are refused; then writes to them and
 * elsewhere, and reads, all under way at once, with gaps. What is read then is what was written.
 * Settings are not what they were before. `command`: the address of COMMAND. */
void crowd(const crowd_register *known, size_t count, uint32_t command, uint64_t seed);

/* Of the bench: count and print what is not as it must be. */
void expect(const char *what, unsigned long long got, unsigned long long wanted);

#endif
