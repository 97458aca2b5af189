/* SPDX-License-Identifier: MIT */
/* bytes.h - whole numbers in little-endian bytes, whatever the processor's order (private). */
#ifndef SEPAX_BYTES_H
#define SEPAX_BYTES_H

#include <stdint.h>
#include <string.h>

static inline uint32_t bytes_get32(const void *from) {
  const uint8_t *byte = (const uint8_t *)from;
  return (uint32_t)byte[0] | (uint32_t)byte[1] << 8 | (uint32_t)byte[2] << 16 |
         (uint32_t)byte[3] << 24;
}

static inline uint64_t bytes_get64(const void *from) {
  const uint8_t *byte = (const uint8_t *)from;
  return (uint64_t)bytes_get32(byte) | (uint64_t)bytes_get32(byte + 4) << 32;
}

/* A number of binary32, and its bytes. */
static inline float bytes_get_float(const void *from) {
  uint32_t word = bytes_get32(from);
  float number;
  memcpy(&number, &word, sizeof number);
  return number;
}

static inline void bytes_put32(void *to, uint32_t value) {
  for (int k = 0; k < 4; k++) {
    ((uint8_t *)to)[k] = (uint8_t)(value >> (8 * k));
  }
}

static inline void bytes_put_float(void *to, float number) {
  uint32_t word;
  memcpy(&word, &number, sizeof word);
  bytes_put32(to, word);
}

static inline void bytes_put64(void *to, uint64_t value) {
  bytes_put32(to, (uint32_t)value);
  bytes_put32((uint8_t *)to + 4, (uint32_t)(value >> 32));
}

#endif
