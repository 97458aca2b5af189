/* SPDX-License-Identifier: MIT */
/* axis.c - sepax_axis before the core: its registers, and what its template needs. */
#include "exact.h"

/* What it does one after the other, up to the product, and how long that takes. A register may
 * stand behind each of them. */
typedef struct {
  double time[AXIS_CUTS];
} axis_times;

static axis_times times_of(const exact_plan *p) {
  const delay_model *m = p->delay;
  const sepax_format *f = p->design->exact_format;
  double selection = m->slot + delay_mux(m, 2);
  return (axis_times){{[AXIS_COMPARED] = delay_adder(m, p->design->core_word),
                       [AXIS_PICKED] = m->slot + delay_mux(m, 3),
                       [AXIS_DIFFERENCES] = (m->family ? 0 : delay_compressor(m)) +
                                            delay_adder(m, f[SEPAX_X_STEP].width),
                       [AXIS_CHOSEN] = selection}};
}

double exact_axis_place(exact_plan *p, double available) {
  const delay_model *m = p->delay;
  const sepax_format *f = p->design->exact_format;
  exact_axis *a = &p->stages.axis;
  const axis_times t = times_of(p);
  double used = 0;
  double longest = 0;
  for (int cut = 0; cut < AXIS_CUTS; cut++) {
    a->cut[cut] = false;
    if (used + t.time[cut] > available && cut > 0) {
      a->cut[cut - 1] = true;
      used = 0;
    }
    used += t.time[cut];
    longest = t.time[cut] > longest ? t.time[cut] : longest;
  }
  double test = m->sum + delay_test(m, 2 * p->design->core_word);
  arith_form form = {.delay = m,
                     .a_w = f[SEPAX_X_SPAN].width,
                     .b_w = f[SEPAX_X_STEP].width,
                     .p_w = m->family ? f[SEPAX_X_ORIENT2D].width : 2 * p->design->core_word,
                     .digits = f[SEPAX_X_STEP].digits,
                     .less = 1,
                     .terms = m->family ? 0 : 2,
                     .open = !m->family,
                     .behind = test,
                     .used = used};
  arith_plan_make(&a->product, &form, available + delay_register(m));
  /* Without a register its rows are late; one saves stages, or bits of them. */
  a->cut[AXIS_CHOSEN] = m->family || a->product.latency > 0;
  if (a->cut[AXIS_CHOSEN]) {
    form.used = 0;
    arith_plan_make(&a->product, &form, available + delay_register(m));
  }
  /* One product after the other in one tree, which adds what is there of the first. */
  a->in_turn = !m->family && p->design->config.ii > 2 && a->product.latency == 0;
  if (a->in_turn) {
    form.terms = 1;
    form.addend[0] = form.addend[1] = (arith_addend){.width = form.p_w};
    arith_plan_make(&a->product, &form, available + delay_register(m));
  }
  double exchange = m->slot; /* one bit exchanges all coordinates; its fan-out counts */
  a->late = m->family || a->product.settled + exchange > available;
  return longest > exchange ? longest : exchange;
}

/* A comparison and a difference follow one another, and the exchange ends its stage. */
double exact_axis_ripple_time(const exact_plan *p) {
  const delay_model *m = p->delay;
  const int word = p->design->exact_format[SEPAX_X_STEP].width;
  const double more = m->adder[0] + m->ripple * word - delay_adder(m, word);
  return p->single ? 0 : delay_register(m) + p->stages.axis.product.settled + m->slot + 2 * more;
}

/* The cycle in which what stands behind these cuts is read, counted from the one in which the pair
 * stands in the registers of the unit. */
static int cycle_behind(const exact_axis *a, int cuts) {
  int cycle = 0;
  for (int cut = 0; cut < cuts; cut++) {
    cycle += a->cut[cut];
  }
  return cycle;
}

int exact_axis_latency(const exact_plan *p) {
  const exact_axis *a = &p->stages.axis;
  return p->single ? 0 : cycle_behind(a, AXIS_CUTS) + a->product.latency + a->in_turn + a->late + 1;
}

/* A signal, the text of its bits, and its register, which ends with _q. */
typedef struct {
  const char *bits, *name;
} axis_signal;

/* Registers that take signals at the end of the cycle before `cycle`. */
static void print_registers(emit_text *out, const exact_plan *p, int cycle,
                            const axis_signal *signal) {
  const axis_signal *s;
  for (s = signal; s->name != NULL; s++) {
    text_printf(out, s->bits[0] == '\0' ? "  reg %s%s_q;\n" : "  reg [%s-1:0] %s_q;\n", s->bits,
                s->name);
  }
  text_puts(out, "  always @(posedge clk) begin\n");
  const gen_line gate = gen_format("    if (live[%d]) begin\n", cycle - 1);
  text_puts(out, p->datapath.advance.gated ? gate.text : "");
  for (s = signal; s->name != NULL; s++) {
    text_printf(out, "    %s_q <= %s;\n", s->name, s->name);
  }
  text_puts(out, p->datapath.advance.gated ? "    end\n  end\n" : "  end\n");
}

static void set_cuts(emit_holes *h, const exact_plan *p) {
  static const struct {
    const char *hole, *q;
    axis_signal signal[6];
  } row[AXIS_CUTS] = {
      {"compared", "q_compared", {{"6", "rises"}}},
      {"picked",
       "q_picked",
       {{"2*W", "low_x"}, {"2*W", "low_y"}, {"2*W", "high_x"}, {"2*W", "high_y"}, {"2", "level"}}},
      {"differences",
       "q_differences",
       {{"2*S_W", "run"}, {"2*D_W", "fall"}, {"S_W", "step"}, {"D_W", "climb"}, {"2", "flat"}}},
      {"chosen",
       "q_chosen",
       {{"S_W", "run_of"}, {"D_W", "fall_of"}, {"S_W", "step_of"}, {"D_W", "climb_of"}}}};
  const exact_axis *a = &p->stages.axis;
  for (int cut = 0; cut < AXIS_CUTS; cut++) {
    emit_text *out = emit_hole_open(h, row[cut].hole);
    if (a->cut[cut]) {
      print_registers(out, p, cycle_behind(a, cut + 1), row[cut].signal);
    }
    emit_hole_close(h);
    emit_hole_set(h, row[cut].q, a->cut[cut] ? "_q" : "");
  }
}

/* The pair itself, as long as it is read: a bank of registers for each II window. */
static gen_line bank_name(const exact_plan *p, int cycle) {
  int bank = cycle / p->design->config.ii;
  return bank == 0 ? gen_format("pair_q") : gen_format("pair_q%d", bank + 1);
}

static void set_banks(emit_holes *h, const exact_plan *p) {
  int ii = p->design->config.ii;
  bool gated = p->datapath.advance.gated;
  emit_text *out = emit_hole_open(h, "banks");
  for (int cycle = 0; cycle < exact_axis_latency(p); cycle += ii) {
    const gen_line live = cycle == 0 ? gen_format("comes") : gen_format("live[%d]", cycle - 1);
    const gen_line gate = gen_format("if (%s%s%s) begin", ii > 1 ? "last" : "",
                                     ii > 1 && gated ? " && " : "", gated ? live.text : "");
    text_printf(out, "  reg [18*W-1:0] %s;\n  always @(posedge clk) %s\n    %s <= %s;\n  end\n",
                bank_name(p, cycle).text, ii > 1 || gated ? gate.text : "begin",
                bank_name(p, cycle).text, cycle == 0 ? "in_pair" : bank_name(p, cycle - ii).text);
  }
  emit_hole_close(h);
}

/* Registers in which a bit of cycle `from` waits until cycle `end`: same_x_q1, same_x_q2 ... */
static void print_delay(emit_text *out, const exact_plan *p, const char *bit, int from, int end) {
  for (int k = 1; k <= end - from; k++) {
    const gen_line gate = gen_format("if (live[%d]) ", from + k - 1);
    const gen_line before = k == 1 ? gen_format("%s", bit) : gen_format("%s_q%d", bit, k - 1);
    text_printf(out, "  reg %s_q%d;\n  always @(posedge clk) %sbegin\n    %s_q%d <= %s;\n  end\n",
                bit, k, p->datapath.advance.gated ? gate.text : "", bit, k, before.text);
  }
}

void exact_axis_count(const exact_plan *p, exact_parts *parts) {
  const exact_axis *a = &p->stages.axis;
  const int w = p->design->core_word;
  const int step = p->design->exact_format[SEPAX_X_STEP].width;
  const int span = p->design->exact_format[SEPAX_X_SPAN].width;
  const int bits[AXIS_CUTS] = {6, 8 * w + 2, 3 * (span + step) + 2, 2 * (span + step)};
  const int cycles = exact_axis_latency(p);
  const int flags = (cycles > 0 ? 2 * (cycles - 1) - cycle_behind(a, AXIS_CHOSEN) : 0) + a->late;
  if (cycles == 0) {
    return;
  }
  for (int cut = 0; cut < AXIS_CUTS; cut++) {
    parts->registers += a->cut[cut] ? bits[cut] : 0;
  }
  parts->registers += flags + a->product.registers + (a->in_turn ? 4 * w : 0);
  parts->coordinates += 18 * w * ((cycles + p->design->config.ii - 1) / p->design->config.ii);
  parts->full_adders += a->product.adders;
  parts->additions += 6 * w + 7 * w / 2; /* differences; comparisons, of which no sum is read */
  parts->multiplexers += 16 * w + (span + step) * (1 + a->in_turn) + 24 * w;
  parts->rows += (a->in_turn ? 1 : 2) * a->product.rows * span;
}

void gen_axis(emitter *e, const exact_plan *p, emit_holes *h) {
  const sepax_format *f = p->design->exact_format;
  const exact_axis *a = &p->stages.axis;
  int chosen = cycle_behind(a, AXIS_DIFFERENCES + 1);
  int product = cycle_behind(a, AXIS_CUTS);
  int end = exact_axis_latency(p) - 1;
  if (!arith_same(&a->product, &p->stages.trapezoid)) {
    gen_multiplier(e, &a->product);
  }
  emit_hole_numbers(h, (emit_number[]){{"step_w", f[SEPAX_X_STEP].width},
                                       {"product_w", a->product.p_w},
                                       {"step_digits", f[SEPAX_X_STEP].digits},
                                       {"shared", p->design->config.ii > 1},
                                       {"picked_cycle", cycle_behind(a, AXIS_COMPARED + 1)},
                                       {"differences_cycle", cycle_behind(a, AXIS_PICKED + 1)},
                                       {"chosen_cycle", chosen},
                                       {"product_cycle", product},
                                       {"tested_cycle", product + a->product.latency + a->in_turn},
                                       {"in_turn", a->in_turn},
                                       {"axis_latency", end + 1},
                                       {"product_clocked", a->product.latency > 0},
                                       {"out_cycle", end},
                                       {"axis_gated", p->datapath.advance.gated && end > 0},
                                       {"axis_live", end - 1},
                                       {NULL, 0}});
  emit_hole_set(h, "axis_product", "%s", arith_name(&a->product).text);
  emit_hole_set(h, "picked_bank", "%s", bank_name(p, cycle_behind(a, AXIS_COMPARED + 1)).text);
  emit_hole_set(h, "out_bank", "%s", bank_name(p, end).text);
  set_banks(h, p);
  set_cuts(h, p);
  emit_text *out = emit_hole_open(h, "summed");
  if (a->in_turn) {
    print_registers(out, p, product + 1,
                    (const axis_signal[]){{"2*W", "sum"}, {"2*W", "carry"}, {NULL, NULL}});
  }
  out = emit_hole_open(h, "waits");
  if (a->late) {
    print_registers(out, p, end, (const axis_signal[]){{"", "across"}, {NULL, NULL}});
  }
  print_delay(out, p, "same_x", chosen, end);
  print_delay(out, p, "same_y", 0, end);
  emit_hole_close(h);
  const gen_line q_x = gen_format("_q%d", end - chosen);
  const gen_line q_y = gen_format("_q%d", end);
  emit_hole_set(h, "q_late", a->late ? "_q" : "");
  emit_hole_set(h, "q_same_x", "%s", end > chosen ? q_x.text : "");
  emit_hole_set(h, "q_same_y", "%s", end > 0 ? q_y.text : "");
  emit_template(e, "sepax_axis", h->hole);
}
