// SPDX-License-Identifier: MIT
// sim.cpp - the chip in Verilator: its clock, its reset, and its UART on standard output. EOT ends
// the simulation; so do two hundred million cycles without it, with status 1.
#include "Vchip.h"

#include <cstdio>
#include <memory>

int main() {
  constexpr long PATIENCE = 200'000'000;
  constexpr char END = 4;
  auto chip = std::make_unique<Vchip>();
  chip->serial_source_ready = 1;
  for (long cycle = 0; cycle < PATIENCE; cycle++) {
    chip->sys_rst = cycle < 10;
    chip->sys_clk = 0;
    chip->eval();
    bool said = chip->serial_source_valid != 0 && cycle >= 10;
    char letter = static_cast<char>(chip->serial_source_data);
    chip->sys_clk = 1;
    chip->eval();
    if (said && letter == END) {
      std::fprintf(stderr, "%ld cycles\n", cycle);
      return 0;
    }
    if (said) {
      std::putchar(letter);
    }
  }
  std::fprintf(stderr, "sim: no end in %ld cycles\n", PATIENCE);
  return 1;
}
