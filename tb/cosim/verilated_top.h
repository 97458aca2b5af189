/* SPDX-License-Identifier: MIT */
// verilated_top.h - a verilated module with its clock and waveform; registers begin with anything.
#ifndef SEPAX_VERILATED_TOP_H
#define SEPAX_VERILATED_TOP_H

#include "verilated.h"
#if VM_TRACE
#include "verilated_fst_c.h"
#endif

#include <cstdint>
#include <memory>

// Its clock: aclk of a top with buses, clk of a core.
template <typename Module> auto clock_of(Module &module, int) -> decltype((module.aclk)) {
  return module.aclk;
}
template <typename Module> auto clock_of(Module &module, long) -> decltype((module.clk)) {
  return module.clk;
}

// The test pin of mapped clock gates: they are not tested.
template <typename Module>
auto test_nothing(Module &module, int) -> decltype((void)module.test_enable) {
  module.test_enable = 0;
}
template <typename Module> void test_nothing(Module &, long) {}

template <typename Module> class VerilatedTop {
public:
  // wave: the FST file to write, or nullptr.
  VerilatedTop(const char *wave, uint64_t seed) {
    context.randReset(2);
    context.randSeed(1 + (int)(seed % 1000000));
    module.reset(new Module(&context));
#if VM_TRACE
    if (wave != nullptr) {
      context.traceEverOn(true);
      trace.reset(new VerilatedFstC);
      module->trace(trace.get(), 99);
      trace->open(wave);
    }
#else
    (void)wave;
#endif
    clock_of(*module, 0) = 0;
    test_nothing(*module, 0);
  }
  VerilatedTop(const VerilatedTop &) = delete;
  VerilatedTop &operator=(const VerilatedTop &) = delete;

  ~VerilatedTop() {
#if VM_TRACE
    if (trace) {
      trace->close();
    }
#endif
    module->final();
  }

  Module *operator->() { return module.get(); }
  Module &operator*() { return *module; }

  // What begins with + is for the design.
  void arguments(int argc, char **argv) { context.commandArgs(argc, argv); }

  // The first half of a clock cycle: the inputs act on the outputs.
  void settle() {
    module->eval();
    dump();
  }

  // The second half, which begins with the rising edge.
  void rise() {
    clock_of(*module, 0) = 1;
    module->eval();
    dump();
    clock_of(*module, 0) = 0;
  }

private:
  void dump() {
#if VM_TRACE
    if (trace) {
      trace->dump(half_cycle++);
    }
#endif
  }

  VerilatedContext context;
  std::unique_ptr<Module> module;
#if VM_TRACE
  std::unique_ptr<VerilatedFstC> trace;
  uint64_t half_cycle = 0;
#endif
};

#endif
