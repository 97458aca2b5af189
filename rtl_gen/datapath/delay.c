/* SPDX-License-Identifier: MIT */
/* delay.c - the delay model: one table a library, and what is computed of it. */
#include "delay.h"

#include <math.h>

/* Fitted to logic that Yosys 0.23 maps to the typical corner and OpenSTA times: arithmetic alone;
 * operands to W = 8 and 18 at II = 3, fixed_slots to W = 12 at II = 2 and 6, sums to W = 18 and 20,
 * aabb to W = 18, slow is a little above the most of OpenSTA's ratios of least periods
 * (docs/developers/timing.md), engine to W = 5 with 8 lanes. */
static const delay_model nangate45 = {
    .library = "nangate45_typ",
    .reg = 0.20,
    .row = {0.17, 0.03},
    .adder = {0.10, 0.055, 0.0012},
    .test = {0.05, 0.04},
    .mux = {0.08, 0.04},
    .sum = 0.135,
    .late_sum = 0.085,
    .carry = 0.095,
    .early_correction = 0.1,
    .skew_lost = 0.07,
    .slot = 0.28,
    .operands = {0.38, 0.26},
    .fixed_slots = 0.12,
    .shared_value = 0.15,
    .sums = {0.125, 0.022, 19},
    .decide = 0.45,
    .ripple = 0.085,
    .overlap = 0.18,
    .aabb = 0.71,
    .engine = 1.1,
    .slow = 3.75,
    .flip_flop = 17,
    .enabled_flip_flop = 24,
};

/* Of a family: clock to output, a wire, a table, onto a carry chain, along it a bit, off it. A
 * level of logic is what it takes and the wire behind it; a chain has no wire behind it, since its
 * sum is taken by a register beside it. */
#define OF_FAMILY(clk, wire, lut, on, bit, off)                                                    \
  .family = true, .reg = (clk) + (wire), .adder = {(on) + (off), 0, (bit)},                        \
  .test = {0, 0.5 * ((lut) + (wire))}, .mux = {0, (lut) + (wire)}, .sum = (wire) + (on) + (off),   \
  .slot = 0.8 * (wire), .operands = {0.8 * (wire), 0}, .fixed_slots = 0.5 * ((lut) + (wire)),      \
  .shared_value = 0.4 * (wire), .aabb = 2 * ((lut) + (wire)), .product = 2.5 * (lut) + 2 * (wire), \
  .flip_flop = 17, .enabled_flip_flop = 18

static const delay_model families[] = {
    [SEPAX_TARGET_ICE40] = {.library = "iCE40",
                            .dsp = {80, 6},
                            OF_FAMILY(0.54, 1.1, 0.45, 0.26, 0.126, 0.5)},
    [SEPAX_TARGET_ECP5] = {.library = "ECP5",
                           .dsp = {18, 18},
                           OF_FAMILY(0.52, 1.0, 0.24, 0.45, 0.036, 0.44)},
    [SEPAX_TARGET_XC7] = {.library = "Xilinx 7",
                          .dsp = {25, 18},
                          OF_FAMILY(0.46, 0.8, 0.12, 0.5, 0.03, 0.3)},
    [SEPAX_TARGET_XCUP] = {.library = "Xilinx UltraScale+",
                           .dsp = {27, 18},
                           OF_FAMILY(0.08, 0.5, 0.1, 0.3, 0.01, 0.2)},
    [SEPAX_TARGET_GOWIN] = {.library = "Gowin",
                            .dsp = {18, 18},
                            OF_FAMILY(0.46, 1.1, 0.5, 0.5, 0.06, 0.5)},
};

const delay_model *delay_model_of(sepax_target target) {
  return target == SEPAX_TARGET_ASIC ? &nangate45 : &families[target];
}

double delay_corner(const sepax_config *config) {
  return config->corner == SEPAX_CORNER_SLOW ? delay_model_of(config->target)->slow : 1;
}

double delay_register(const delay_model *m) { return m->reg; }

double delay_row(const delay_model *m, int width) { return m->row[0] + m->row[1] * log2(width); }

double delay_compressor(const delay_model *m) { return m->sum; }

double delay_adder(const delay_model *m, int width) {
  return m->adder[0] + m->adder[1] * log2(width) + m->adder[2] * width;
}

double delay_test(const delay_model *m, int width) { return m->test[0] + m->test[1] * log2(width); }

double delay_mux(const delay_model *m, int inputs) {
  return inputs > 1 ? m->mux[0] + m->mux[1] * log2(inputs) : 0;
}

double delay_operands(const delay_model *m, int word) {
  int fitted = word > 8 ? word : 8;
  return m->operands[0] + m->operands[1] * log2(fitted / 8.0) + delay_mux(m, 2);
}

double delay_sums_fan_out(const delay_model *m, int width) {
  double late = m->sums[0] + m->sums[1] * (width - m->sums[2]);
  return late > 0 ? late : 0;
}
