/* SPDX-License-Identifier: MIT */
// scoreboard.h - the pairs whose verdicts are outstanding: first in, first out; no heap.
#ifndef SEPAX_SCOREBOARD_H
#define SEPAX_SCOREBOARD_H

#include "ports.h"
#include "sepax_design.h"
#include "sepax_params.h"

struct Outstanding {
  uint64_t index, cycle; // of taking the pair, as if its words came without gaps
  bool alone;            // the core was empty
  sepax_judgement verdict;
  sepax_pair pair;
  Travel travel;
};

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

#endif
