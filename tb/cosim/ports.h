/* SPDX-License-Identifier: MIT */
// ports.h - the ports of a verilated top under the same names for every architecture. A pair
// is one input word with valid/ready on both sides (exact), some of AXI4-Stream (stream_ports.h),
// or three without waiting (paper, conference).
#ifndef SEPAX_PORTS_H
#define SEPAX_PORTS_H

#include "pair_source.h"
#include "sepax_params.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

// What goes with a pair of AXI4-Stream: its tag, TLAST; and what is wrong with the pair: a
// coordinate beyond the word, `outside` says which and how; or TLAST comes behind its first `cut`
// words. Other designs have nothing of it.
struct Travel {
  uint64_t tag = 0;
  bool last = false;
  uint32_t outside = 0;
  int cut = 0;
  bool whole() const { return outside == 0 && cut == 0; }
};

// What the outputs show.
struct Verdict {
  bool valid, collision, coplanar, out_of_range;
  int axis, band;
  bool partial = false; // of AXI4-Stream, as tag and last
  uint64_t tag = 0;
  bool last = false;
  bool operator!=(const Verdict &v) const {
    return valid != v.valid || collision != v.collision || coplanar != v.coplanar ||
           out_of_range != v.out_of_range || axis != v.axis || band != v.band ||
           partial != v.partial || tag != v.tag || last != v.last;
  }
};

inline std::string text(const Verdict &v) {
  return std::string(v.collision ? "collision" : "separated") + (v.coplanar ? ", coplanar" : "") +
         (v.out_of_range ? ", out of range" : "") + ", axis " + std::to_string(v.axis) + ", band " +
         std::to_string(v.band);
}

inline Verdict expected(const sepax_judgement &v, const Travel &t) {
  Verdict want{
      true,       v.collision, v.coplanar, v.axis == SEPAX_AXIS_EXTENT, SEPAX_EXACT ? v.axis : 0,
      (int)v.band};
  want.partial = t.cut > 0;
  want.tag = t.tag;
  want.last = t.last;
  return want;
}

#ifdef SEPAX_STREAM
#include "stream_ports.h"
#else
#include "Vsepax_top.h"
#if defined SEPAX_ISOLATION && (defined SEPAX_BOXES || !SEPAX_EXACT && !defined SEPAX_CONFERENCE)
#include "Vsepax_top___024root.h" // modules.vlt
#endif
using Top = Vsepax_top;

inline void set_reset(Top &top, bool on) { top.rst = on; }
inline void set_in_valid(Top &top, bool valid) { top.in_valid = valid; }
constexpr bool STREAMED = false;
#if SEPAX_EXACT
constexpr bool HANDSHAKE = true;
constexpr int INPUT_WORDS = 1;
inline bool in_ready(const Top &top) { return top.in_ready != 0; }
inline void set_out_ready(Top &top, bool ready) { top.out_ready = ready; }
inline int shown_axis(const Top &top) { return (int)top.out_axis; }
#else
constexpr bool HANDSHAKE = false;
constexpr int INPUT_WORDS = 3;
inline bool in_ready(const Top &) { return true; }
inline void set_out_ready(Top &, bool) {}
inline int shown_axis(const Top &) { return 0; }
#endif

inline Verdict shown(const Top &top) {
  Verdict v{
      top.out_valid != 0, top.out_collision != 0, top.out_coplanar != 0, false, shown_axis(top), 0};
#ifdef SEPAX_EXTENT_A
  v.out_of_range = top.out_of_range != 0;
#endif
#ifdef SEPAX_BANDS
  v.band = (int)top.out_band;
#endif
  return v;
}

// Word `word` of the pair on the inputs.
inline void drive(Top &top, const sepax_pair &pair, int word, const Travel &) {
#if SEPAX_EXACT
  decltype(&top.in_a1_x) const port[] = {
      &top.in_a1_x, &top.in_a1_y, &top.in_a1_z, &top.in_a2_x, &top.in_a2_y, &top.in_a2_z,
      &top.in_a3_x, &top.in_a3_y, &top.in_a3_z, &top.in_b1_x, &top.in_b1_y, &top.in_b1_z,
      &top.in_b2_x, &top.in_b2_y, &top.in_b2_z, &top.in_b3_x, &top.in_b3_y, &top.in_b3_z};
#else
  decltype(&top.in_a_x) const port[] = {&top.in_a_x, &top.in_a_y, &top.in_a_z, &top.in_b_x,
                                        &top.in_b_y, &top.in_b_z, &top.in_na,  &top.in_nb};
#endif
  int i = 0;
  for (auto *p : port) {
    int k = SEPAX_EXACT ? i : i < 6 ? 9 * (i / 3) + 3 * word + i % 3 : 18 + 3 * (i % 2) + word;
    *p = (uint32_t)coordinate(pair, k) & (0xffffffffu >> (32 - SEPAX_WORD));
    i++;
  }
}

#endif

// Looks once a cycle at operands of what has nothing to do.
#if defined SEPAX_ISOLATION && defined SEPAX_BOXES && !defined SEPAX_STREAM
inline bool any_bit(uint64_t bits) { return bits != 0; }
template <std::size_t WORDS> bool any_bit(const VlWide<WORDS> &bits) {
  return std::any_of(bits.data(), bits.data() + WORDS, [](uint32_t word) { return word != 0; });
}

// Without a pair, or where the AABB test has decided, nothing but zeros enters the core.
class Isolation {
public:
  explicit Isolation(const sepax_design &) {}
  void enter(const sepax_judgement &) {}
  void forget() {}
  bool kept(const Top &top) {
    const auto &in = *top.rootp;
    return (in.sepax_top__DOT__narrow_valid && !in.sepax_top__DOT__disjoint) ||
           !any_bit(in.sepax_top__DOT__narrow_pair);
  }
};
#elif defined SEPAX_ISOLATION && !SEPAX_EXACT && !defined SEPAX_CONFERENCE
// Coplanar pairs leave operands, axes and vertices of axes 7 ... 9 as they are.
class Isolation {
public:
  explicit Isolation(const sepax_design &design) {
    const auto bits = [&](int id) { return design.format[id].exact - design.format[id].shift; };
    operands = 6 * bits(SEPAX_F_EDGE);
    axes = 18 * bits(SEPAX_F_AXIS);
  }
  // The last word of a pair was in this cycle.
  void enter(const sepax_judgement &v) { cycles |= v.coplanar ? 0 : UINT64_C(1) << INPUT_WORDS; }
  // A reset.
  void forget() {
    cycles = 0;
    before.clear();
  }
  bool kept(const Top &top) {
    const auto &now = *top.rootp;
    const std::vector<unsigned char> was = before;
    before.clear();
    add(operands_of(now, 0), operands);
    const auto middle = (std::ptrdiff_t)before.size();
    add(now.sepax_top__DOT__axis, axes);
    add(now.sepax_top__DOT__a_10, 0);
    add(now.sepax_top__DOT__b_10, 0);
    const bool loads = (cycles >> 7 & 1) != 0, moves = (cycles >> 9 & 1) != 0;
    cycles <<= 1;
    return was.empty() ||
           ((loads || std::equal(was.begin(), was.begin() + middle, before.begin())) &&
            (moves || std::equal(was.begin() + middle, was.end(), before.begin() + middle)));
  }

private:
  int operands, axes;  // their first bits
  uint64_t cycles = 0; // bit c: a pair that is not coplanar was in its cycle c in the cycle before
  std::vector<unsigned char> before;

  // The operands; in a flat netlist they have another name.
  template <typename Root>
  static auto operands_of(const Root &root, int) -> decltype((root.sepax_top__DOT__psa__DOT__p_q)) {
    return root.sepax_top__DOT__psa__DOT__p_q;
  }
  template <typename Root>
  static auto operands_of(const Root &root, long) -> decltype((root.sepax_top__DOT__psa_p_q)) {
    return root.sepax_top__DOT__psa_p_q;
  }

  // The bits of a signal from this one on; Verilator has the lowest in the first byte.
  template <typename Signal> void add(const Signal &signal, int first) {
    unsigned char bytes[sizeof signal];
    std::memcpy(bytes, &signal, sizeof signal);
    bytes[first / 8] &= (unsigned char)(0xff << first % 8);
    before.insert(before.end(), bytes + first / 8, bytes + sizeof signal);
  }
};
#else
class Isolation {
public:
  explicit Isolation(const sepax_design &) {}
  void enter(const sepax_judgement &) {}
  void forget() {}
  bool kept(const Top &) { return true; }
};
#endif

#endif
