// ports.h - the ports of a verilated sepax_top under the same names for every architecture. A pair
// is one input word with valid/ready on both sides (exact), or three without waiting (paper,
// conference).
#ifndef SEPAX_PORTS_H
#define SEPAX_PORTS_H

#include "Vsepax_top.h"
#include "pair_source.h"

// What the outputs show.
struct Verdict {
  bool valid, collision, coplanar, out_of_range;
  int axis, band;
  bool operator!=(const Verdict &v) const {
    return valid != v.valid || collision != v.collision || coplanar != v.coplanar ||
           out_of_range != v.out_of_range || axis != v.axis || band != v.band;
  }
};

#if SEPAX_EXACT
constexpr bool HANDSHAKE = true;
constexpr int INPUT_WORDS = 1;
inline bool in_ready(const Vsepax_top &top) { return top.in_ready != 0; }
inline void set_out_ready(Vsepax_top &top, bool ready) { top.out_ready = ready; }
inline int shown_axis(const Vsepax_top &top) { return (int)top.out_axis; }
#else
constexpr bool HANDSHAKE = false;
constexpr int INPUT_WORDS = 3;
inline bool in_ready(const Vsepax_top &) { return true; }
inline void set_out_ready(Vsepax_top &, bool) {}
inline int shown_axis(const Vsepax_top &) { return 0; }
#endif

inline Verdict shown(const Vsepax_top &top) {
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

inline Verdict expected(const sepax_verdict &v) {
  return {true,       v.collision, v.coplanar, v.axis == SEPAX_AXIS_EXTENT, HANDSHAKE ? v.axis : 0,
          (int)v.band};
}

// Word `word` of the pair on the inputs.
inline void drive(Vsepax_top &top, const sepax_pair &pair, int word) {
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
