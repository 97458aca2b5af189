/* SPDX-License-Identifier: MIT */
// stream_ports.h - of ports.h: the ports of a verilated sepax_stream. SEPAX_STREAM transfers are a
// pair.
#ifndef SEPAX_STREAM_PORTS_H
#define SEPAX_STREAM_PORTS_H

#include "Vsepax_stream.h"

#include <type_traits>

using Top = Vsepax_stream;

constexpr bool STREAMED = true;
constexpr bool HANDSHAKE = true;
constexpr int INPUT_WORDS = SEPAX_STREAM;
constexpr uint64_t TAG_MASK = UINT64_MAX >> (64 - SEPAX_TAG);

inline void set_reset(Top &top, bool on) { top.aresetn = !on; }
inline void set_in_valid(Top &top, bool valid) { top.s_axis_tvalid = valid; }
inline bool in_ready(const Top &top) { return top.s_axis_tready != 0; }
inline void set_out_ready(Top &top, bool ready) { top.m_axis_tready = ready; }

inline Verdict shown(const Top &top) {
  const uint32_t data = top.m_axis_tdata;
  Verdict v{top.m_axis_tvalid != 0, (data & 1) != 0,       (data & 2) != 0,
            (data & 4) != 0,        (int)(data >> 8 & 15), (int)(data >> 4 & 3)};
  v.partial = (data & ~UINT32_C(0xf37)) != 0; // bit 3, and those that are 0
  v.tag = v.valid ? (uint64_t)top.m_axis_tuser : 0;
  v.last = v.valid && top.m_axis_tlast;
  return v;
}

// Word `word` of the pair on the inputs; anything where bits are unused, and in TUSER before the
// pair's last word.
inline void drive(Top &top, const sepax_pair &pair, int word, const Travel &t) {
  constexpr int VERTICES = 6 / INPUT_WORDS;
  constexpr uint32_t BITS = 33 - SEPAX_WORD; // that tell whether a coordinate fits
  const bool end = word + 1 == (t.cut > 0 ? t.cut : INPUT_WORDS);
  for (int i = 0; i < (int)(sizeof top.s_axis_tdata / 4); i++) {
    top.s_axis_tdata[i] = (uint32_t)(t.tag + (uint64_t)i) * 0x9e3779b9u;
  }
  for (int n = 0; n < 3 * VERTICES; n++) {
    const int number = 3 * VERTICES * word + n;
    uint32_t value = (uint32_t)coordinate(pair, number);
    if (t.outside != 0 && t.outside % 18 == (uint32_t)number) {
      value ^= 1u << (SEPAX_WORD - 1 + t.outside / 18 % BITS);
    }
    top.s_axis_tdata[n / 9 * 16 + n / 3 % 3 * 4 + n % 3] = value;
  }
  top.s_axis_tuser =
      static_cast<std::decay_t<decltype(top.s_axis_tuser)>>((end ? t.tag : ~t.tag) & TAG_MASK);
  top.s_axis_tlast = end && t.last;
}

#endif
