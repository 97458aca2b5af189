// design_under_test.h - what the drivers of all architectures share: the verilated sepax_top,
// the scoreboard of outstanding verdicts, and what was wrong.
#ifndef SEPAX_DESIGN_UNDER_TEST_H
#define SEPAX_DESIGN_UNDER_TEST_H

#include "Vsepax_top.h"
#include "pair_source.h"
#include "sepax_design.h"
#include "sepax_vectors.h"
#include "verilated_top.h"

constexpr uint64_t MISMATCHES_SHOWN = 20;

struct Outstanding {
  uint64_t index, cycle; // of the verdict (paper), or of taking the pair (exact)
  bool alone;            // the core was empty
  sepax_verdict verdict;
  sepax_pair pair;
};

// First in, first out; no heap.
class Scoreboard {
public:
  static constexpr uint64_t CAPACITY = 1024;
  bool empty() const { return begin == end; }
  bool full() const { return size() == CAPACITY; }
  uint64_t size() const { return end - begin; }
  Outstanding &front() { return entry[begin % CAPACITY]; }
  void push(const Outstanding &expected) { entry[end++ % CAPACITY] = expected; }
  void pop() { begin++; }
  void clear() { begin = end; }

private:
  Outstanding entry[CAPACITY];
  uint64_t begin = 0, end = 0;
};
static_assert(2 * (SEPAX_LATENCY / SEPAX_II + 8) <= Scoreboard::CAPACITY,
              "more pairs in flight than entries");

class DesignUnderTest {
public:
  DesignUnderTest(const char *wave, uint64_t stress, const sepax_design &design)
      : design(design), stress(stress), random{stress}, top(wave, stress) {}

  bool too_many() const { return mismatches >= MISMATCHES_SHOWN || hung; }

  uint64_t mismatches = 0, judged = 0, collisions = 0, coplanar = 0, resets = 0, dropped = 0;
  uint64_t last_verdict_cycle = 0;

protected:
  uint64_t draw() { return sepax_random_next(&random); }
  bool chance(uint64_t one_in) { return draw() % one_in == 0; }

  void settle() {
    cycle++;
    top.settle();
  }
  void rise() { top.rise(); }

  void drop_outstanding() {
    resets++;
    dropped += scoreboard.size();
    scoreboard.clear();
  }

  // The oldest outstanding verdict came, or should have come.
  void count(const Outstanding &e) {
    judged++;
    collisions += e.verdict.collision;
    coplanar += e.verdict.coplanar;
    last_verdict_cycle = cycle;
  }

  void compare(const Outstanding &e) {
    if (top->out_collision != e.verdict.collision) {
      complain(&e, e.verdict.collision ? "expected collision, got separated"
                                       : "expected separated, got collision");
    } else if (top->out_coplanar != e.verdict.coplanar) {
      complain(&e, e.verdict.coplanar ? "expected coplanar, got not coplanar"
                                      : "expected not coplanar, got coplanar");
    }
  }

  void complain(const Outstanding *e, const char *what) {
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
    if (!scoreboard.empty()) {
      std::fprintf(stderr, "cosim: time-out: %llu verdicts never came\n",
                   (unsigned long long)scoreboard.size());
      mismatches += scoreboard.size();
    }
  }

  const sepax_design &design;
  uint64_t stress;
  sepax_random random;
  VerilatedTop<Vsepax_top> top;
  Scoreboard scoreboard;
  uint64_t cycle = 0;
  bool hung = false;

private:
  // What the design was given: the architecture without normals has 18 words.
  static void print(sepax_pair pair) {
    if (!SEPAX_EXACT) {
      sepax_pair_print(stderr, &pair);
      return;
    }
    for (int k = 0; k < 18; k++) {
      std::fprintf(stderr, "%s%ld", k > 0 ? " " : "", (long)coordinate(&pair, k));
    }
  }
};

inline uint32_t word_bits(int32_t value) {
  return (uint32_t)value & (0xffffffffu >> (32 - SEPAX_WORD));
}

#endif
