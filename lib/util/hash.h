/* SPDX-License-Identifier: MIT */
/* hash.h - hashes of coordinates and numbers, for tables of a power of two of slots (private). */
#ifndef SEPAX_HASH_H
#define SEPAX_HASH_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

static inline uint64_t hash_add(uint64_t hash, uint64_t word) {
  hash = (hash ^ word) * UINT64_C(0x9e3779b97f4a7c15);
  return hash ^ hash >> 32;
}

/* The hash of the bits, so -0 and 0 differ. */
static inline uint64_t hash_doubles(const double *v, size_t count) {
  uint64_t hash = 0;
  for (size_t n = 0; n < count; n++) {
    uint64_t word;
    memcpy(&word, &v[n], sizeof word);
    hash = hash_add(hash, word);
  }
  return hash * UINT64_C(0xd6e8feb86659fd93);
}

#endif
