/* SPDX-License-Identifier: MIT */
// stress.h - what a test bench does at random under stress: gaps, blocks, resets, tags, faults.
#ifndef SEPAX_STRESS_H
#define SEPAX_STRESS_H

#include "ports.h"
#include "sepax_params.h"
#include "sepax_vectors.h"

// Without a seed there is no stress: every offer is made, every verdict taken, and no reset comes.
class Stress {
public:
  explicit Stress(uint64_t seed) : seed(seed), random{seed} { until_reset = next_reset(); }

  bool on() const { return seed != 0; }
  uint64_t draw() { return sepax_random_next(&random); }

  // In this cycle, is a pair offered? Is a verdict taken? Does a reset come?
  bool offers() { return !on() || next(&offering); }
  bool accepts() { return !on() || next(&accepting); }
  bool resets() {
    if (!on() || until_reset-- != 0) {
      return false;
    }
    until_reset = next_reset();
    return true;
  }

  // A tag of many values, and now and then TLAST.
  Travel travel() {
    Travel t;
#ifdef SEPAX_STREAM
    t.tag = (draw() << 32 ^ draw()) & TAG_MASK;
    t.last = draw() % 4 == 0;
#endif
    return t;
  }

  // The same, with a coordinate beyond the word or cut short, where there can be.
  Travel faulty() {
    Travel t = travel();
    constexpr int CUTS = INPUT_WORDS - 1;
    if (CUTS > 0 && (SEPAX_WORD == 32 || draw() % 2 == 0)) {
      t.cut = 1 + (int)(draw() % (uint64_t)(CUTS > 0 ? CUTS : 1));
      t.last = true;
    } else if (SEPAX_WORD < 32) {
      t.outside = 1 + (uint32_t)(draw() % 100000);
    }
    return t;
  }

  // Anything on the data inputs.
  sepax_pair noise() {
    sepax_pair noise;
    for (int k = 0; k < 24; k++) {
      coordinate(noise, k) = (int32_t)(uint32_t)draw();
    }
    return noise;
  }

private:
  // A stretch of cycles in which a signal is 1 in `eighths` of 8 cycles.
  struct Stretch {
    uint64_t left, eighths;
  };

  bool next(Stretch *s) {
    static const uint64_t rates[] = {0, 1, 4, 7, 8};
    if (s->left == 0) {
      s->left = 1 + draw() % (8 * SEPAX_LATENCY);
      s->eighths = rates[draw() % 5];
    }
    s->left--;
    return draw() % 8 < s->eighths;
  }

  // A few cycles or many thousand.
  uint64_t next_reset() {
    uint64_t most = UINT64_C(8) << draw() % 13;
    return draw() % most;
  }

  uint64_t seed;
  sepax_random random;
  Stretch offering{0, 0}, accepting{0, 0};
  uint64_t until_reset;
};

#endif
