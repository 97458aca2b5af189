/* delay.c - the delay model: one table a library, and what is computed of it. */
#include "delay.h"

#include <math.h>

/* Fitted to logic that Yosys 0.23 maps to the typical corner and OpenSTA times: arithmetic alone;
 * operands to W = 8 and 18 at II = 3, fixed_slots to W = 12 at II = 2 and 6, sums to W = 18 and 20,
 * aabb to W = 18. */
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
    .orient2d_sign = 1.0,
    .aabb = 0.71,
    .flip_flop = 17,
    .enabled_flip_flop = 24,
};

const delay_model *const delay_used = &nangate45;

double delay_register(void) { return delay_used->reg; }

double delay_row(int width) { return delay_used->row[0] + delay_used->row[1] * log2(width); }

double delay_compressor(void) { return delay_used->sum; }

double delay_adder(int width) {
  const double *adder = delay_used->adder;
  return adder[0] + adder[1] * log2(width) + adder[2] * width;
}

double delay_test(int width) { return delay_used->test[0] + delay_used->test[1] * log2(width); }

double delay_mux(int inputs) {
  return inputs > 1 ? delay_used->mux[0] + delay_used->mux[1] * log2(inputs) : 0;
}

double delay_operands(int word) {
  int fitted = word > 8 ? word : 8;
  return delay_used->operands[0] + delay_used->operands[1] * log2(fitted / 8.0) + delay_mux(2);
}

double delay_sums_fan_out(int width) {
  const double *sums = delay_used->sums;
  double late = sums[0] + sums[1] * (width - sums[2]);
  return late > 0 ? late : 0;
}
