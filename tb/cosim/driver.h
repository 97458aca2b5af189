/* SPDX-License-Identifier: MIT */
// driver.h - drives a verilated top with pairs and compares its verdicts, in the order of the
// pairs, with the golden model's.
#ifndef SEPAX_DRIVER_H
#define SEPAX_DRIVER_H

#include "ports.h"
#include "scoreboard.h"
#include "sepax_design.h"
#include "stress.h"
#include "traits.h"
#include "verilated_top.h"

#include <algorithm>
#include <cinttypes>
#include <stdio.h>
#include <string>

constexpr uint64_t MISMATCHES_SHOWN = 20;

class Driver {
public:
  Driver(const char *wave, uint64_t stress, const sepax_design &design)
      : design(design), stress(stress), top(wave, stress), isolation(design) {
    set_reset(*top, true);
    set_in_valid(*top, false);
    set_out_ready(*top, true);
    top.settle();
    top.rise();
    top.settle();
    top.rise();
    set_reset(*top, false);
  }

  bool too_many() const { return mismatches >= MISMATCHES_SHOWN || hung; }

  // Offer the words of the pair until they are taken; under stress a stream has, before some, the
  // pair with a fault. False when the design hangs.
  bool send(uint64_t index, const sepax_pair &pair) {
    if (index == 0 && HANDSHAKE && stress.on()) {
      first = pair;
      capacity = fill(false);
      check_capacity();
    }
    while (STREAMED && stress.on() && stress.draw() % 16 == 0) {
      damaged++;
      if (!offer(index, pair, stress.faulty())) {
        return false;
      }
    }
    return offer(index, pair, stress.travel());
  }

  void drain() {
    while (!scoreboard.empty() && !hung) {
      reset_by_chance();
      step(nullptr, 0);
    }
    if (HANDSHAKE && stress.on() && !hung && fill(true) != capacity) {
      complain(nullptr, "not as many pairs are taken, verdicts blocked, as after the first reset");
    }
    for (int i = 0; i < 4 * (SEPAX_LATENCY + SEPAX_II) && !hung; i++) {
      tick(false, true); // a verdict too many is seen here
    }
    if (!scoreboard.empty()) {
      std::fprintf(stderr, "cosim: time-out: %" PRIu64 " verdicts never came\n", scoreboard.size());
      mismatches += scoreboard.size();
    }
    uint64_t allowed = streamed == 0 ? 0 : (streamed - 1) * PACE + SEPAX_LATENCY;
    if (!hung && last_taken - first_taken > allowed) {
      std::fprintf(stderr,
                   "cosim: %" PRIu64 " cycles from the first to the last of %" PRIu64 " pairs; "
                   "II = %d allows %" PRIu64 "\n",
                   (last_taken - first_taken), streamed, (int)PACE, allowed);
      mismatches++;
    }
  }

  void report() const {
    std::printf("%" PRIu64 " pairs, %" PRIu64 " mismatches, %" PRIu64 " collisions, %" PRIu64
                " coplanar\n",
                judged, mismatches, collisions, coplanar);
#if SEPAX_EXACT
    std::printf("axes 0 ... %d:", LAST_AXIS);
    for (int axis = 0; axis <= LAST_AXIS; axis++) {
      std::printf(" %" PRIu64, axes[axis]);
    }
    std::printf("\n");
#endif
#ifdef SEPAX_BANDS
    std::printf("bands free, warning, collision: %" PRIu64 " %" PRIu64 " %" PRIu64 "\n", bands[0],
                bands[1], bands[2]);
#endif
    if (damaged > 0) {
      std::printf("%" PRIu64 " of them with a coordinate beyond the word, or cut short\n", damaged);
    }
    std::printf("latency %d: %" PRIu64 " pairs that did not wait; ", SEPAX_LATENCY, latencies);
    if (stress.on()) {
      std::printf("random gaps%s, %" PRIu64 " resets, %" PRIu64 " pairs dropped by them, %" PRIu64
                  " offers withdrawn\n",
                  HANDSHAKE ? " and blocks" : "", resets, dropped, withdrawn);
      return;
    }
    std::printf("II %d", SEPAX_II);
    if (streamed > 1) {
      std::printf(": %.4f cycles a pair",
                  (double)(last_taken - first_taken) / (double)(streamed - 1));
    }
    double ps = HANDSHAKE ? design.config.clock_ps : PAPER_PS;
    std::printf("; %" PRIu64 " cycles = %.3f ms at %g ns\n", last_verdict_cycle,
                1e-9 * (double)last_verdict_cycle * ps, 1e-3 * ps);
  }

  uint64_t mismatches = 0, judged = 0, dropped = 0, damaged = 0; // pairs with a fault

private:
  // How many times the first pair is taken while every verdict is blocked; then all leave. Slowly:
  // a pair is offered when the one before has gone as far as it can.
  uint64_t fill(bool slowly) {
    Outstanding e{0, cycle, false, sepax_judge(&design, &first), first, Travel()};
    uint64_t taken = 0, more = 0;
    int word = 0;
    for (uint64_t refused = 0; (refused < PATIENCE || word > 0) && !hung;) {
      const bool blocks = refused < PATIENCE; // or the last pair becomes whole
      drive(*top, first, word, e.travel);
      if (!tick(true, !blocks)) {
        refused++;
        continue;
      }
      refused = blocks ? 0 : refused;
      word = (word + 1) % INPUT_WORDS;
      if (word == 0 && scoreboard.full()) {
        hang("more pairs were taken than the design can hold");
      } else if (word == 0) {
        e.cycle = cycle;
        scoreboard.push(e);
        (blocks ? taken : more)++;
        for (int i = 0; slowly && blocks && i < 2 * (SEPAX_LATENCY + SEPAX_II); i++) {
          tick(false, false);
        }
      }
    }
    if (INPUT_WORDS == 1 && !hung) { // in place of a verdict that leaves a pair is taken
      bool took = tick(true, true);
      for (int i = 0; i < LEAVES && !took; i++) {
        took = tick(true, true);
      }
      if (took) {
        e.cycle = cycle;
        scoreboard.push(e);
        more++;
      } else {
        complain(nullptr, "a verdict has left, and no pair is taken");
      }
    }
    while (!scoreboard.empty() && !hung) {
      tick(false, true);
    }
    judged -= hung ? 0 : taken + more;
    return taken;
  }

  // The entries of the queue are a power of two; each stage before it holds a pair more.
  void check_capacity() {
    const uint64_t entries = capacity - std::min(capacity, BOXES + SKID);
    if (!STREAMED && (entries == 0 || (entries & (entries - 1)) != 0)) {
      complain(nullptr, std::to_string(capacity) + " pairs are taken, verdicts blocked");
    }
  }

  bool offer(uint64_t index, const sepax_pair &pair, const Travel &t) {
    Outstanding e{index, 0, false, sepax_judge(&design, &pair), pair, t};
    if (!t.whole()) {
      e.verdict = {};
      e.verdict.collision = true;
      e.verdict.axis = SEPAX_AXIS_EXTENT;
      e.verdict.band = design.limits > 0 ? SEPAX_BAND_COLLISION : SEPAX_BAND_FREE;
    }
    const int words = t.cut > 0 ? t.cut : INPUT_WORDS;
    for (int word = 0; word < words && !hung;) {
      if (reset_by_chance()) {
        word = 0;
      }
      word += step(&e, word);
    }
    if (hung) {
      return false;
    }
    e.cycle = cycle - (HANDSHAKE ? 0 : INPUT_WORDS - 1);
    e.alone = idle >= SETTLE;
    isolation.enter(e.verdict);
    if (scoreboard.full()) {
      hang("more pairs were taken than the design can hold");
    }
    scoreboard.push(e);
    if (!stress.on()) {
      pace(e);
    }
    return true;
  }

  // One clock cycle, under stress perhaps a gap, with anything on the data inputs, or a block;
  // true if the word is taken. In a gap noise may be offered while nothing is taken, as by a
  // partner that withdraws what it offers, against the rules of AXI.
  bool step(const Outstanding *e, int word) {
    bool offer = stress.offers() && e != nullptr;
    if (offer) {
      drive(*top, e->pair, word, e->travel);
    } else if (stress.on()) {
      drive_noise();
      withdraws = HANDSHAKE && stress.draw() % 2 == 0;
    }
    const bool taken = tick(offer, !HANDSHAKE || stress.accepts());
    withdraws = false;
    return taken;
  }

  bool tick(bool offer, bool ready) {
    set_in_valid(*top, offer);
    set_out_ready(*top, ready);
    cycle++;
    top.settle();
    if (HANDSHAKE && stress.on()) {
      check_independence(offer, ready);
    }
    if (withdraws && !in_ready(*top)) { // it will not be, since in_ready is independent
      set_in_valid(*top, true);
      top.settle();
      withdrawn++;
    }
    bool was_empty = scoreboard.empty();
    idle = was_empty ? idle + 1 : 0;
    if (HANDSHAKE && idle > RESTED && !in_ready(*top)) {
      complain(nullptr, "it is empty, and not ready for a pair");
    }
    bool take = offer && in_ready(*top);
    bool give = shown(*top).valid && ready;
    look(ready);
    top.rise();
    if (!ready) {
      blocked = cycle;
    }
    if (take || give) {
      waited = 0;
    } else if (ready && (offer || !was_empty) && ++waited > PATIENCE) {
      hang(offer ? "time-out: no pair is taken" : "time-out: no verdict comes");
    }
    return take;
  }

  const Outstanding *oldest() { return scoreboard.empty() ? nullptr : &scoreboard.front(); }

  void look(bool ready) {
    const Verdict now = shown(*top);
    const Outstanding *e = oldest();
    if (!isolation.kept(*top)) {
      complain(e, "operands move without a pair that needs them");
    }
    if (blocked_verdict.valid && now != blocked_verdict) {
      complain(e, "a verdict moves while it is blocked");
    }
    blocked_verdict = {};
    if (!now.valid) {
      if (now != Verdict{}) {
        complain(nullptr, "an output is 1 without out_valid");
      }
      if (!HANDSHAKE && e != nullptr && cycle - e->cycle + 1 >= SEPAX_LATENCY) {
        complain(e, "no verdict in the cycle where it is due");
        scoreboard.pop();
      }
    } else if (e == nullptr) {
      complain(nullptr, "a verdict that nobody asked for");
    } else if (since = since == 0 ? cycle : since; !ready) {
      blocked_verdict = now;
    } else {
      judge(*e, now);
      scoreboard.pop();
    }
  }

  void judge(const Outstanding &e, const Verdict &now) {
    const Verdict want = expected(e.verdict, e.travel);
    judged++;
    collisions += e.verdict.collision;
    coplanar += e.verdict.coplanar;
    last_verdict_cycle = cycle;
    axes[want.axis]++;
    bands[want.band]++;
    if (now != want) {
      complain(&e, "expected " + text(want) + "; got " + text(now));
    }
    // Never earlier; not later where nothing was in the way. The verdict before can be, and of a
    // pair in a stage before the core an II window, or while verdicts are blocked a full queue.
    if (e.travel.whole()) {
      const uint64_t due = e.cycle + SEPAX_LATENCY - 1;
      const bool alone = !HANDSHAKE || (e.alone && blocked < e.cycle);
      const uint64_t latest = CONSTANT      ? std::max(due, left + 1)
                              : alone       ? due
                              : stress.on() ? since
                                            : due + WAIT;
      latencies += latest == due;
      if (since < due || since > latest) {
        complain(&e, "verdict in cycle " + std::to_string(since - e.cycle + 1) +
                         " from taking the pair, not " + std::to_string(latest - e.cycle + 1));
      }
    }
    left = cycle;
    since = 0;
  }

  void complain(const Outstanding *e, const std::string &what) {
    mismatches++;
    if (mismatches > MISMATCHES_SHOWN) {
      hung = true; // it may go on for ever
      return;
    }
    std::string pair;
    if (e != nullptr) { // the architecture without normals has 18 numbers
      for (int k = 0; k < (SEPAX_EXACT ? 18 : 24); k++) {
        pair += (k > 0 ? " " : "") + std::to_string(coordinate(e->pair, k));
      }
      std::fprintf(stderr, "cosim: pair %" PRIu64 ", ", e->index);
    } else {
      std::fputs("cosim: ", stderr);
    }
    std::fprintf(stderr, "cycle %" PRIu64 ": %s\n", cycle, what.c_str());
    if (e != nullptr) {
      std::fprintf(stderr, "  %s\n  replay: make wave " SEPAX_MAKE " PAIR='%s'\n", pair.c_str(),
                   pair.c_str());
    }
  }

  void hang(const char *what) {
    complain(oldest(), what);
    hung = true;
  }

  // The first pairs go alone; then a pair as soon as it is taken.
  void pace(const Outstanding &e) {
    if (latencies < ALONE_LATENCIES && e.index < ALONE_PAIRS) {
      while (!scoreboard.empty() && !hung) {
        tick(false, true);
      }
      for (uint64_t i = 0; i < SETTLE; i++) {
        tick(false, true); // the verdict has left, and an II window that has begun ends
      }
      return;
    }
    if (streamed++ == 0) {
      first_taken = e.cycle;
    }
    last_taken = e.cycle;
  }

  void drive_noise() {
    const sepax_pair noise = stress.noise();
    drive(*top, noise, 0, stress.travel());
  }

  // Now and then a reset, which drops every pair in flight. Nothing is handed over in a cycle of
  // reset, whatever valid and ready say.
  bool reset_by_chance() {
    if (!stress.resets()) {
      return false;
    }
    set_reset(*top, true);
    do {
      drive_noise();
      set_in_valid(*top, stress.draw() % 2 != 0);
      set_out_ready(*top, stress.draw() % 2 != 0);
      cycle++;
      top.settle();
      top.rise();
    } while (stress.draw() % 3 == 0);
    set_reset(*top, false);
    idle = 0;
    isolation.forget();
    resets++;
    dropped += scoreboard.size();
    scoreboard.clear();
    blocked_verdict = {};
    since = waited = 0;
    return true;
  }

  void check_independence(bool offer, bool ready) {
    bool was_ready = in_ready(*top);
    Verdict before = shown(*top);
    set_in_valid(*top, !offer);
    top->eval();
    if (in_ready(*top) != was_ready) {
      complain(nullptr, "in_ready depends on in_valid of the same cycle");
    }
    set_in_valid(*top, offer);
    set_out_ready(*top, !ready);
    top->eval();
    if (shown(*top) != before) {
      complain(nullptr, "the verdict depends on out_ready of the same cycle");
    }
    set_out_ready(*top, ready);
    top->eval();
  }

  const sepax_design &design;
  Stress stress;
  VerilatedTop<Top> top;
  Isolation isolation;
  Scoreboard scoreboard;
  bool hung = false;
  bool withdraws = false;    // noise is offered in this cycle unless it would be taken
  sepax_pair first{};        // pair of a run under stress
  uint64_t capacity = 0;     // pairs that are taken while verdicts are blocked
  Verdict blocked_verdict{}; // shown and blocked in the cycle before
  uint64_t idle = 0;         // cycles for which it has been empty, this one, too
  uint64_t cycle = 0, blocked = 0, waited = 0, last_verdict_cycle = 0;
  uint64_t since = 0, left = 0; // the oldest verdict is shown; the one before left
  uint64_t collisions = 0, coplanar = 0, latencies = 0, resets = 0, withdrawn = 0;
  uint64_t axes[LAST_AXIS + 1] = {}, bands[3] = {};
  uint64_t streamed = 0, first_taken = 0, last_taken = 0;
};

#endif
