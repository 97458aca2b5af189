// SPDX-License-Identifier: MIT
// soc.cpp - the verilated soc_top: its console on stdout, its exit status; the cycles on stderr.
//   soc [CYCLES]    CYCLES: how many it may take (100,000,000); status 3 when it takes more
#include "Vsoc_top.h"
#include "verilated.h"

#include <cstdio>
#include <cstdlib>
#include <memory>

int main(int argc, char **argv) {
  long most = argc > 1 ? std::atol(argv[1]) : 100000000;
  VerilatedContext context;
  context.randReset(2);
  std::unique_ptr<Vsoc_top> top(new Vsoc_top(&context));
  long cycle = 0;
  for (top->rst = 1; cycle < most && (top->rst || !top->ended); cycle++) {
    top->rst = cycle < 10;
    top->clk = 1;
    top->eval();
    if (!top->rst && top->console_valid) {
      std::putchar(top->console);
    }
    top->clk = 0;
    top->eval();
  }
  bool ended = top->ended != 0;
  int code = ended ? top->code : 3;
  std::fflush(stdout);
  std::fprintf(stderr, "soc: %s after %ld cycles, status %d\n", ended ? "ended" : "still running",
               cycle, code);
  top->final();
  return code;
}
