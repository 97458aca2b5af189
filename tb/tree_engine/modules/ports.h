/* SPDX-License-Identifier: MIT */
// ports.h - bits of a verilated module's ports, however wide they are.
#ifndef SEPAX_TREE_TB_PORTS_H
#define SEPAX_TREE_TB_PORTS_H

#include "verilated.h"

#include <cstdint>

// count <= 32 bits of a port from bit `from` on.
inline uint64_t bits_of(uint64_t port, unsigned from, unsigned count) {
  return port >> from & ((uint64_t(1) << count) - 1);
}
template <std::size_t WORDS>
uint64_t bits_of(const VlWide<WORDS> &port, unsigned from, unsigned count) {
  uint64_t value = port[from / 32];
  if (from / 32 + 1 < WORDS) {
    value |= (uint64_t)port[from / 32 + 1] << 32;
  }
  return bits_of(value, from % 32, count);
}

// Bits that only `seed` tells, into a port of so many bits; and whether a port has them.
inline void spread(uint64_t seed, unsigned bits, uint32_t &port) {
  port = (uint32_t)(seed & (~uint32_t(0) >> (32 - bits)));
}
inline void spread(uint64_t seed, unsigned bits, QData &port) {
  port = seed & (~uint64_t(0) >> (64 - bits));
}
template <std::size_t WORDS> void spread(uint64_t seed, unsigned bits, VlWide<WORDS> &port) {
  for (unsigned k = 0; k < WORDS; k++) {
    uint64_t word = seed * (2 * k + 1);
    spread(word >> 32, k + 1 < WORDS ? 32 : bits - 32 * k, port[k]);
  }
}
inline bool has_spread(uint64_t seed, unsigned bits, uint64_t port) {
  return port == (seed & (~uint64_t(0) >> (64 - bits)));
}
template <std::size_t WORDS>
bool has_spread(uint64_t seed, unsigned bits, const VlWide<WORDS> &port) {
  VlWide<WORDS> wanted;
  spread(seed, bits, wanted);
  bool same = true;
  for (unsigned k = 0; k < WORDS; k++) {
    same = same && port[k] == wanted[k];
  }
  return same;
}

#endif
