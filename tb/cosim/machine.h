// machine.h - what the drivers of all architectures share: the verilated sepax_top with
// its clock and waveform, the verdicts it owes, and what was wrong.
#ifndef SEPAX_MACHINE_H
#define SEPAX_MACHINE_H

#include "Vsepax_top.h"
#include "pair_source.h"
#include "verilated.h"
#if VM_TRACE
#include "verilated_fst_c.h"
#include "sepax_design.h"
#include "sepax_vectors.h"
#endif

#include <memory>

constexpr uint64_t MISMATCHES_SHOWN = 20;

struct Owed {
  uint64_t index, cycle; // of the verdict (paper), or of taking the pair (exact)
  bool alone;            // the machine was empty
  sepax_verdict verdict;
  sepax_pair pair;
};

// First in, first out; no heap.
class OwedQueue {
public:
  static constexpr uint64_t ROOM = 1024;
  bool empty() const { return begin == end; }
  bool full() const { return size() == ROOM; }
  uint64_t size() const { return end - begin; }
  Owed &front() { return entry[begin % ROOM]; }
  void push(const Owed &owed) { entry[end++ % ROOM] = owed; }
  void pop() { begin++; }
  void clear() { begin = end; }

private:
  Owed entry[ROOM];
  uint64_t begin = 0, end = 0;
};
static_assert(2 * (SEPAX_LATENCY / SEPAX_II + 8) <= OwedQueue::ROOM, "more than a machine holds");

class Machine {
public:
  Machine(const char *wave, uint64_t stress, const sepax_design &design)
      : design(design), stress(stress), random{stress} {
    context.randReset(2); // registers begin with anything
    context.randSeed(1 + (int)(stress % 1000000));
    top.reset(new Vsepax_top(&context));
#if VM_TRACE
    if (wave != nullptr) {
      context.traceEverOn(true);
      trace.reset(new VerilatedFstC);
      top->trace(trace.get(), 99);
      trace->open(wave);
    }
#else
    (void)wave;
#endif
    top->clk = 0;
  }
  Machine(const Machine &) = delete;
  Machine &operator=(const Machine &) = delete;

  ~Machine() {
#if VM_TRACE
    if (trace) {
      trace->close();
    }
#endif
    top->final();
  }

  bool too_many() const { return mismatches >= MISMATCHES_SHOWN || hung; }

  uint64_t mismatches = 0, judged = 0, collisions = 0, coplanar = 0, resets = 0, dropped = 0;
  uint64_t last_verdict_cycle = 0;

protected:
  uint64_t draw() { return sepax_random_next(&random); }
  bool chance(uint64_t one_in) { return draw() % one_in == 0; }

  // The first half of a clock cycle: the inputs act on the outputs. Then the second,
  // which begins with the rising edge.
  void settle() {
    cycle++;
    top->eval();
    dump();
  }
  void rise() {
    top->clk = 1;
    top->eval();
    dump();
    top->clk = 0;
  }

  void drop_owed() {
    resets++;
    dropped += owed.size();
    owed.clear();
  }

  // The oldest verdict owed came, or should have come.
  void count(const Owed &e) {
    judged++;
    collisions += e.verdict.collision;
    coplanar += e.verdict.coplanar;
    last_verdict_cycle = cycle;
  }

  void compare(const Owed &e) {
    if (top->out_collision != e.verdict.collision) {
      complain(&e, e.verdict.collision ? "expected collision, got separated"
                                       : "expected separated, got collision");
    } else if (top->out_coplanar != e.verdict.coplanar) {
      complain(&e, e.verdict.coplanar ? "expected coplanar, got not coplanar"
                                      : "expected not coplanar, got coplanar");
    }
  }

  void complain(const Owed *e, const char *what) {
    mismatches++;
    if (mismatches > MISMATCHES_SHOWN) {
      return;
    }
    if (e == nullptr) {
      std::fprintf(stderr, "cosim: cycle %llu: %s\n", (unsigned long long)cycle, what);
      return;
    }
    std::fprintf(stderr, "cosim: pair %llu, cycle %llu: %s\n  ", (unsigned long long)e->index,
                 (unsigned long long)cycle, what);
    print(e->pair);
    std::fprintf(stderr, "\n  replay: make wave " SEPAX_MAKE " PAIR='");
    print(e->pair);
    std::fprintf(stderr, "'\n");
  }

  void complain_never_came() {
    if (!owed.empty()) {
      std::fprintf(stderr, "cosim: time-out: %llu verdicts never came\n",
                   (unsigned long long)owed.size());
      mismatches += owed.size();
    }
  }

  const sepax_design &design;
  uint64_t stress;
  sepax_random random;
  VerilatedContext context;
  std::unique_ptr<Vsepax_top> top;
  OwedQueue owed;
  uint64_t cycle = 0;
  bool hung = false;

private:
  // What the machine was given: the architecture without normals has 18 words.
  static void print(sepax_pair pair) {
    if (!SEPAX_EXACT) {
      sepax_pair_print(stderr, &pair);
      return;
    }
    for (int k = 0; k < 18; k++) {
      std::fprintf(stderr, "%s%ld", k > 0 ? " " : "", (long)coordinate(&pair, k));
    }
  }

  void dump() {
#if VM_TRACE
    if (trace) {
      trace->dump(time++);
    }
#endif
  }

#if VM_TRACE
  std::unique_ptr<VerilatedFstC> trace;
  uint64_t time = 0; // half cycles
#endif
};

inline uint32_t word_bits(int32_t value) {
  return (uint32_t)value & (0xffffffffu >> (32 - SEPAX_WORD));
}

#endif
