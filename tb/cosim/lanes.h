/* SPDX-License-Identifier: MIT */
// lanes.h - drives 64 designs at once, each a bit of the mapped gates that synth/fpga/lanes.awk
// makes of them, and compares their verdicts with the golden model's. Has what driver.h has for
// cosim.cpp.
#ifndef SEPAX_LANES_H
#define SEPAX_LANES_H

#include "pair_source.h"
#include "sepax_design.h"

#include <cinttypes>
#include <deque>
#include <map>
#include <memory>
#include <stdio.h>
#include <string>
#include <vector>

extern "C" {
extern const int gates_nets;
extern uint64_t gates_net[];
extern const int gates_registers;
extern const int gates_register[];
extern const struct {
  const char *name;
  int net;
} gates_ports[];
void gates_settle(void);
void gates_rise(void);
}

class Driver {
public:
  Driver(const char *wave, uint64_t stress, const sepax_design &design)
      : design(design), stress(stress), random{stress + 1}, lane(new Lane[LANES]) {
    if (wave != nullptr) {
      std::fputs("cosim: mapped gates have no waveform; leave --wave out\n", stderr);
      std::exit(EXIT_ERROR);
    }
    for (int i = 0; gates_ports[i].name != nullptr; i++) {
      port[gates_ports[i].name] = &gates_net[gates_ports[i].net];
    }
    for (const char *vertex : {"a1", "a2", "a3", "b1", "b2", "b3"}) {
      for (const char *axis : {"x", "y", "z"}) {
        for (int bit = 0; bit < SEPAX_WORD; bit++) {
          std::string name = std::string("in_") + vertex + "_" + axis;
          data.push_back(bits(name + "[" + std::to_string(bit) + "]"));
        }
      }
    }
    rst = bits("rst");
    in_valid = bits("in_valid");
    in_ready = bits("in_ready");
    out_valid = bits("out_valid");
    out_ready = bits("out_ready");
    collision = bits("out_collision");
    plane = bits("out_coplanar");
    for (int bit = 0; bit < 4; bit++) {
      axis[bit] = bits("out_axis[" + std::to_string(bit) + "]");
    }
    reset();
  }

  bool too_many() const { return mismatches >= MISMATCHES_SHOWN || hung; }

  // Gives the pair to a design that has none to take; false when no design takes one.
  bool send(uint64_t index, const sepax_pair &pair) {
    while (vacant == 0 && !hung) {
      tick();
    }
    if (hung) {
      return false;
    }
    int n = __builtin_ctzll(vacant);
    vacant &= vacant - 1;
    lane[n].offered = {index, sepax_judge(&design, &pair), pair};
    for (int k = 0; k < 18; k++) {
      const auto value = (uint64_t)coordinate(lane[n].offered.pair, k);
      for (int bit = 0; bit < SEPAX_WORD; bit++) {
        uint64_t &word = *data[(size_t)(k * SEPAX_WORD + bit)];
        word = (word & ~(UINT64_C(1) << n)) | (value >> bit & 1) << n;
      }
    }
    return true;
  }

  void drain() {
    while ((~vacant != 0 || outstanding != 0) && !hung) {
      tick();
    }
    for (int i = 0; i < 4 * (SEPAX_LATENCY + SEPAX_II) && !hung; i++) {
      tick(); // a verdict too many is seen here
    }
  }

  void report() const {
    std::printf("%" PRIu64 " pairs, %" PRIu64 " mismatches, %" PRIu64 " collisions, %" PRIu64
                " coplanar\n%" PRIu64 " cycles of %d designs%s\n",
                judged, mismatches, collisions, coplanar, cycle, LANES,
                stress != 0 ? ", random gaps and blocks" : "");
  }

  uint64_t mismatches = 0, judged = 0, dropped = 0, damaged = 0;

private:
  static constexpr uint64_t MISMATCHES_SHOWN = 20;
  static constexpr int LANES = 64;
  static constexpr uint64_t PATIENCE = 2000 + 64 * (SEPAX_LATENCY + SEPAX_II);

  // More pairs than a design can hold.
  static constexpr size_t CAPACITY = 2 * (SEPAX_LATENCY / SEPAX_II + 8);

  struct Judged {
    uint64_t index;
    sepax_judgement verdict;
    sepax_pair pair;
  };
  struct Lane {
    Judged offered;
    std::deque<Judged> taken;
  };

  uint64_t *bits(const std::string &name) {
    auto at = port.find(name);
    if (at == port.end()) {
      std::fprintf(stderr, "cosim: the gates have no port %s\n", name.c_str());
      std::exit(EXIT_ERROR);
    }
    return at->second;
  }

  uint64_t draw() { return sepax_random_next(&random); }

  // Registers begin with anything, and so does what nothing drives.
  void reset() {
    for (int i = 0; i < gates_nets; i++) {
      gates_net[i] = draw();
    }
    for (int i = 0; i < 3; i++) {
      *rst = i < 2 ? ~UINT64_C(0) : 0;
      *in_valid = 0;
      *out_ready = ~UINT64_C(0);
      gates_settle();
      if (i < 2) {
        gates_rise();
      }
    }
  }

  // One cycle of all.
  void tick() {
    uint64_t want = ~vacant;
    *in_valid = stress != 0 ? want & (draw() | draw()) : want;
    *out_ready = stress != 0 ? draw() | draw() : ~UINT64_C(0);
    cycle++;
    gates_settle();
    uint64_t take = *in_valid & *in_ready;
    uint64_t give = *out_valid & *out_ready;
    uint64_t now[] = {*out_valid, *collision, *plane, *axis[0], *axis[1], *axis[2], *axis[3]};
    for (size_t i = 0; i < 7; i++) {
      each((now[i] ^ before[i]) & blocked, "a verdict moves while it is blocked");
      each(now[i] & ~*out_valid, "an output is 1 without out_valid");
      before[i] = now[i];
    }
    blocked = *out_valid & ~*out_ready;
    for (uint64_t rest = give; rest != 0; rest &= rest - 1) {
      judge(__builtin_ctzll(rest));
    }
    for (uint64_t rest = take; rest != 0; rest &= rest - 1) {
      Lane &l = lane[__builtin_ctzll(rest)];
      if (l.taken.size() == CAPACITY) {
        hang("more pairs were taken than the design can hold");
        return;
      }
      l.taken.push_back(l.offered);
      outstanding++;
    }
    vacant |= take;
    waited = (take | give) != 0 ? 0 : waited + 1;
    if (waited > PATIENCE) {
      hang("time-out: no pair is taken, no verdict comes");
    }
    gates_rise();
  }

  void judge(int n) {
    std::deque<Judged> &taken = lane[n].taken;
    if (taken.empty()) {
      complain(n, nullptr, "a verdict that nobody asked for");
      return;
    }
    const Judged &e = taken.front();
    auto bit = [n](const uint64_t *word) { return (int)(*word >> n & 1); };
    int shown = bit(axis[0]) + 2 * bit(axis[1]) + 4 * bit(axis[2]) + 8 * bit(axis[3]);
    judged++;
    outstanding--;
    collisions += e.verdict.collision;
    coplanar += e.verdict.coplanar;
    if (bit(collision) != e.verdict.collision || bit(plane) != e.verdict.coplanar ||
        shown != e.verdict.axis) {
      complain(n, &e, "another verdict than the golden model's");
    }
    taken.pop_front();
  }

  void each(uint64_t wrong, const char *what) {
    for (; wrong != 0; wrong &= wrong - 1) {
      complain(__builtin_ctzll(wrong), nullptr, what);
    }
  }

  void complain(int n, const Judged *e, const char *what) {
    if (++mismatches > MISMATCHES_SHOWN) {
      return;
    }
    std::fprintf(stderr, "cosim: cycle %" PRIu64 ", design %d: %s\n", cycle, n, what);
    if (e != nullptr) {
      std::fprintf(stderr, "  pair %" PRIu64 ":", e->index);
      for (int k = 0; k < 18; k++) {
        std::fprintf(stderr, " %" PRId64, (int64_t)coordinate(e->pair, k));
      }
      std::fputc('\n', stderr);
    }
  }

  void hang(const char *what) {
    complain(0, nullptr, what);
    hung = true;
  }

  const sepax_design &design;
  uint64_t stress;
  sepax_random random;
  std::unique_ptr<Lane[]> lane;
  std::map<std::string, uint64_t *> port;
  std::vector<uint64_t *> data;
  uint64_t *rst, *in_valid, *in_ready, *out_valid, *out_ready, *collision, *plane, *axis[4];
  uint64_t vacant = ~UINT64_C(0), blocked = 0, before[7] = {};
  uint64_t cycle = 0, waited = 0, outstanding = 0, collisions = 0, coplanar = 0;
  bool hung = false;
};

#endif
