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

#endif
