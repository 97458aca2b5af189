/* SPDX-License-Identifier: MIT */
/* stages.c - registers inside the units of the exact datapath: the delay model asks where. */
#include "aabb/aabb.h"
#include "clearance.h"
#include "engine/engine.h"
#include "exact.h"

#include <math.h>

/* Until operands of coordinates are selected. At II = 1 there is nothing to select, at II = 3
 * rotating registers are all that trapezoids need. */
static double coordinate_operands(const exact_plan *p) {
  int ii = p->design->config.ii;
  if (ii == 1 || p->running) {
    return 0;
  }
  return delay_operands(p->delay, p->design->core_word) + (ii % 3 == 0 ? 0 : p->delay->fixed_slots);
}

/* A trapezoid with registers behind its sums or without, whichever has fewer pipeline registers, or
 * else fewer bits of them. Without, its rows are late behind fan-outs. */
static void place_in_trapezoid(exact_plan *p, double sums, double period) {
  exact_stages *s = &p->stages;
  const sepax_format *f = p->design->exact_format;
  int span = f[SEPAX_X_SPAN].width;
  arith_form form = {.delay = p->delay,
                     .a_w = span,
                     .b_w = span,
                     .p_w = f[SEPAX_X_ORIENT2D].width,
                     .digits = f[SEPAX_X_SPAN].digits,
                     .less = 1};
  arith_plan_make(&s->trapezoid, &form, period);
  if (p->delay->family) {
    /* Many units read a coordinate. The multiplier has its own registers, which are not beside the
     * sums. Logic takes low bits, and the order in x, which is the sign of a sum. */
    double behind = delay_mux(p->delay, 2);
    if (s->trapezoid.cut.low_a + s->trapezoid.cut.low_b > 1) {
      behind += delay_adder(p->delay, 2 * span);
    }
    if (!p->single) {
      behind = fmax(behind, delay_test(p->delay, span));
    }
    behind += delay_operands(p->delay, p->design->core_word);
    s->trapezoid_sums = sums + behind > period - delay_register(p->delay);
    return;
  }
  int latency = 1 + s->trapezoid.latency;
  int registers = 2 * span + s->trapezoid.registers;
  form.used = sums + delay_sums_fan_out(p->delay, span);
  arith_plan_make(&s->trapezoid, &form, period);
  s->trapezoid_sums = sums + delay_row(p->delay, span) > period - delay_register(p->delay) ||
                      latency < s->trapezoid.latency ||
                      (latency == s->trapezoid.latency && registers < s->trapezoid.registers);
  if (s->trapezoid_sums) {
    form.used = 0;
    arith_plan_make(&s->trapezoid, &form, period);
  }
}

static void place_in_prisms(exact_plan *p, double period) {
  exact_stages *s = &p->stages;
  const sepax_format *f = p->design->exact_format;
  const sepax_format *zsum = &f[SEPAX_X_Z_SUM];
  const sepax_format *own_zsum = &f[SEPAX_X_OWN_Z_SUM];
  int orient2d = f[SEPAX_X_ORIENT2D].width;
  int orient3d = f[SEPAX_X_ORIENT3D].width;
  arith_form form = {.delay = p->delay,
                     .a_w = orient2d,
                     .b_w = zsum->width,
                     .p_w = orient3d,
                     .digits = zsum->digits,
                     .less = 1};
  arith_form own_form = form;
  own_form.b_w = own_zsum->width;
  own_form.digits = own_zsum->digits;
  arith_plan_make(&s->prism, &form, period);
  arith_plan_make(&s->own_prism, &own_form, period);
  form.less = 2;
  arith_plan_make(&s->prism_of_two, &form, period);
}

/* Full adders one after the other that leave two rows of so many. */
static int levels_of(int terms) {
  int levels = 0;
  for (; terms > 2; terms = terms / 3 * 2 + terms % 3) {
    levels++;
  }
  return levels;
}

/* With a clearance: registers inside a limit. */
static void place_in_limits(exact_plan *p, double available) {
  const sepax_format *f = p->design->exact_format;
  exact_stages *s = &p->stages;
  double maximum = delay_adder(p->delay, f[SEPAX_X_CROSS].width) + delay_mux(p->delay, 2);
  double sum = delay_adder(p->delay, f[SEPAX_X_LIMIT].width);
  int terms = 0;
  int most = 0;
  for (int k = 0; k < p->limits; k++) {
    int of_sum = clearance_digits(p->design->margin[k] + 1);
    int of_most = clearance_digits(p->design->margin[k] - 1);
    terms = of_sum + of_most > terms ? of_sum + of_most : terms;
    most = of_sum > most ? of_sum : most;
    most = of_most > most ? of_most : most;
  }
  s->most = 2 * maximum > available;
  s->total = levels_of(terms) * delay_compressor(p->delay) + sum > available;
  s->shortest = fmax(s->shortest,
                     delay_register(p->delay) + levels_of(most) * delay_compressor(p->delay) + sum);
}

/* On an FPGA: the low bits of factors that logic takes. */
static double low_bits_settled(const exact_plan *p) {
  const exact_stages *s = &p->stages;
  return fmax(s->trapezoid.cut.settled, fmax(s->prism.cut.settled, s->own_prism.cut.settled));
}

/* On an FPGA: until an operand of a shared unit is selected. */
static double selection(const exact_plan *p) {
  int ii = p->design->config.ii;
  return ii > 1 ? p->delay->slot + delay_mux(p->delay, ii > 3 ? ii : 2) : p->delay->shared_value;
}

/* In gates: until an operand of an orient2d or a z sum is selected. Rotating registers and classes
 * leave two to select from at II = 3; else there are more, of up to II slots, and a slot bit
 * selects more operands, the more the fewer slots there are; copies of it for these units select no
 * more than one at II = 3. */
static double selected_operands(const exact_plan *p, bool copies) {
  enum { MOST = 6 };
  int ii = p->design->config.ii;
  int inputs = ii <= 3 ? 2 : ii < MOST ? ii : MOST;
  return delay_operands(p->delay, p->design->core_word) + delay_mux(p->delay, inputs) -
         delay_mux(p->delay, 2) + (copies || ii == 3 ? 0 : p->delay->fixed_slots * 2 / ii);
}

/* The longest stage that has no place for a register: sums of coordinates, of trapezoid terms, of
 * prisms, the AABB test in front, and the engine around. `sum`: the last addition of an orient3d.
 */
static double shortest_stage(const exact_plan *p, double sums, double sum) {
  const sepax_design *d = p->design;
  const sepax_format *f = d->exact_format;
  double operands = p->stages.fetch_2d ? 0
                    : p->delay->family ? selection(p)
                    : d->config.ii > 1 ? selected_operands(p, p->stages.slot_copies)
                                       : p->delay->shared_value;
  double orient2d = delay_compressor(p->delay) + delay_adder(p->delay, f[SEPAX_X_ORIENT2D].width);
  /* On an FPGA two differences, and coordinates that their registers bring in turn. */
  double zsum = (p->delay->family ? 1 : 2) * delay_compressor(p->delay) +
                delay_adder(p->delay, f[SEPAX_X_Z_SUM].width);
  double z_operands = p->delay->family ? coordinate_operands(p) : operands;
  double row = p->delay->family
                   ? fmax(p->delay->product, low_bits_settled(p) - delay_register(p->delay))
                   : delay_row(p->delay, f[SEPAX_X_ORIENT2D].width) + delay_compressor(p->delay);
  double running = (p->running ? p->delay->slot + delay_mux(p->delay, 2) : 0) + sum;
  double longest =
      fmax(fmax(row, sums), fmax(fmax(operands + orient2d, z_operands + zsum), running));
  longest = fmax(longest, aabb_delay(d));
  const engine_generator *around = engine_generator_of(&d->config);
  if (around->delay != NULL) {
    longest = fmax(longest, around->delay(p->delay, d->config.word));
  }
  return delay_register(p->delay) + longest;
}

void exact_stages_make(exact_plan *p, double period) {
  const sepax_format *f = p->design->exact_format;
  exact_stages *s = &p->stages;
  bool shared_units = p->design->config.ii > 1;
  double available = period - delay_register(p->delay);
  int orient3d = f[SEPAX_X_ORIENT3D].width;
  int own_zsum = f[SEPAX_X_OWN_Z_SUM].width;
  double fan_out = p->delay->shared_value;
  double sums = delay_adder(p->delay, f[SEPAX_X_SPAN].width) + coordinate_operands(p);
  double sum = fan_out + delay_adder(p->delay, orient3d);
  double orient2d = delay_compressor(p->delay) + delay_adder(p->delay, f[SEPAX_X_ORIENT2D].width);
  s->fetch_2d = p->delay->family && shared_units && selection(p) + orient2d > available;
  s->fetch_3d = p->delay->family && shared_units && selection(p) + sum > available;
  double whole = (shared_units && !s->fetch_3d ? p->delay->slot + delay_mux(p->delay, 2) : 0) +
                 2 * delay_compressor(p->delay) + sum;
  place_in_trapezoid(p, sums, period);
  place_in_prisms(p, period);
  s->orient3d = whole > available ? 2 : whole + delay_test(p->delay, orient3d) > available ? 1 : 0;
  s->orient3d_latency = 1 + s->fetch_3d + (p->limits > 0 ? s->orient3d / 2 : s->orient3d);
  s->zdiff_shared =
      !p->delay->family && !shared_units &&
      fan_out + 3 * delay_compressor(p->delay) + 2 * delay_adder(p->delay, own_zsum) <= available;
  double six_terms = fan_out + 4 * delay_compressor(p->delay) + delay_adder(p->delay, own_zsum);
  s->own_zsum = !p->running && !s->zdiff_shared && six_terms > available;
  double zsum = 2 * delay_compressor(p->delay) + delay_adder(p->delay, f[SEPAX_X_Z_SUM].width);
  s->slot_copies = !p->delay->family && shared_units &&
                   selected_operands(p, false) + fmax(orient2d, zsum) > available;
  s->shortest = shortest_stage(p, sums, sum);
  if (!p->single) {
    s->shortest = fmax(s->shortest, delay_register(p->delay) + exact_axis_place(p, available));
  }
  if (p->limits > 0) {
    place_in_limits(p, available);
  }
}
