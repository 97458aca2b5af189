/* SPDX-License-Identifier: MIT */
/* counts.c - what a plan of architecture exact costs: latency, flip-flops, gates. The counts
 * compare plans of one configuration. They leave out what all these plans have in common. On an
 * FPGA gates are flip-flops alone. */
#include "exact.h"

#include <stdlib.h>
#include <string.h>

/* Bits of a kind's result, of which the row names the width as Verilog does. */
static int bits_of(const exact_plan *p, const graph_kind *k) {
  const struct {
    const char *width;
    int format;
  } named[] = {{"G_W", SEPAX_X_ORIENT2D},
               {"Z_W", SEPAX_X_Z_SUM},
               {"O_W", SEPAX_X_OWN_Z_SUM},
               {"V_W", SEPAX_X_ORIENT3D},
               {"C_W", SEPAX_X_CROSS}};
  const sepax_format *f = p->design->exact_format;
  for (size_t i = 0; i < sizeof named / sizeof named[0]; i++) {
    if (strcmp(k->row.width, named[i].width) == 0) {
      return f[named[i].format].width;
    }
  }
  return strcmp(k->row.width, "LIMITS*L_W") == 0 ? p->limits * f[SEPAX_X_LIMIT].width
         : strcmp(k->row.width, "M_W") == 0      ? p->limits * f[SEPAX_X_EDGE_LIMIT].width
         : k->row.width[0] == 'L'                ? p->limits + 2
                                                 : atoi(k->row.width);
}

static const arith_plan *multiplier_of(const exact_plan *p, const graph_kind *k) {
  const exact_stages *s = &p->stages;
  const char *module = k->row.module != NULL ? k->row.module : "";
  return strcmp(module, "sepax_trapezoid_ab") == 0 ? &s->trapezoid
         : strcmp(module, "sepax_prism") == 0      ? &s->prism
         : strcmp(module, "sepax_prism_2") == 0    ? &s->prism_of_two
         : strcmp(module, "sepax_own_prism") == 0  ? &s->own_prism
                                                   : NULL;
}

/* Flip-flops of a limit on an axis, sepax_limit, whose components have so many bits. */
static int registers_in_limit(const exact_plan *p, int component) {
  const exact_stages *s = &p->stages;
  int limits = p->limits * p->design->exact_format[SEPAX_X_LIMIT].width;
  int sums = (component + 2) * (1 + s->most) + component * (4 + 2 * s->most);
  return sums + limits * (1 + 2 * s->total);
}

/* Of a limit on an edge, sepax_edge_limit, in one of its three projections. */
static int registers_in_edge_limit(const exact_plan *p) {
  int word = p->design->core_word;
  int limits = p->limits * p->design->exact_format[SEPAX_X_EDGE_LIMIT].width;
  return word + (word + 1) + (p->design->margin[1] > 1 ? word : 0) +
         limits * (1 + 2 * p->stages.total);
}

/* Flip-flops inside a unit and at its output. */
static int registers_in(const exact_plan *p, const graph_kind *k) {
  const exact_stages *s = &p->stages;
  const sepax_format *f = p->design->exact_format;
  const arith_plan *multiplier = multiplier_of(p, k);
  int bits = bits_of(p, k);
  if (k->latency == 0) {
    return 0;
  }
  if (multiplier != NULL) {
    bool sums = multiplier == &s->trapezoid && s->trapezoid_sums;
    return bits + multiplier->registers + (sums ? 2 * f[SEPAX_X_SPAN].width : 0);
  }
  if (strcmp(k->row.symbol, "l") == 0 || strcmp(k->row.symbol, "lo") == 0) {
    bool own = k->row.symbol[1] == 'o';
    return registers_in_limit(p, f[own ? SEPAX_X_ORIENT2D : SEPAX_X_CROSS].width);
  }
  if (strcmp(k->row.symbol, "le") == 0) {
    return registers_in_edge_limit(p);
  }
  if (strncmp(k->row.symbol, "zo", 2) == 0 && !p->running) {
    return bits * (1 + 2 * s->own_zsum);
  }
  bool orient3d = strchr("swd", k->row.symbol[0]) != NULL && k->row.symbol[1] == '\0';
  if (orient3d && k->row.module != NULL) {
    int volume = f[SEPAX_X_ORIENT3D].width;
    return bits + (p->limits == 0 && s->orient3d > 0 ? volume : 0) +
           (s->orient3d > 1 ? 2 * volume : 0);
  }
  return bits * k->latency;
}

/* Bits of full adders inside a unit, with those of its additions, as far as plans differ in them.
 */
static int adders_in(const exact_plan *p, const graph_kind *k) {
  const arith_plan *multiplier = multiplier_of(p, k);
  int bits = bits_of(p, k);
  return multiplier != NULL                 ? multiplier->adders
         : strcmp(k->row.symbol, "zo") == 0 ? (p->stages.zdiff_shared ? 2 : 5) * bits
         : strcmp(k->row.symbol, "z") == 0  ? (k->row.operand[2] == NULL ? 1 : 3) * bits
                                            : 0;
}

/* Bits of the additions of a unit. */
static int additions_in(const exact_plan *p, const graph_kind *k) {
  const arith_plan *multiplier = multiplier_of(p, k);
  int span = p->design->exact_format[SEPAX_X_SPAN].width;
  bool orient3d = strchr("swd", k->row.symbol[0]) != NULL && k->row.symbol[1] == '\0';
  return k->row.module == NULL ? 0
         : orient3d            ? p->design->exact_format[SEPAX_X_ORIENT3D].width
                    : bits_of(p, k) + (multiplier == &p->stages.trapezoid ? 2 * span : 0);
}

/* Inputs of multiplexers in front of a unit beyond the first, times their bits. */
static int multiplexers_of(const exact_plan *p, const graph_kind *k, int unit) {
  const datapath *d = &p->datapath;
  int ii = d->schedule.ii;
  int bits = 0;
  for (int i = 0; i < GRAPH_OPERANDS && k->row.operand[i] != NULL; i++) {
    gen_line source[SEPAX_II_MAX];
    int sources = 0;
    int width = p->design->core_word;
    for (int slot = 0; slot < ii; slot++) {
      const graph_node *n = &d->graph.node[k->at[unit][slot]];
      if (k->at[unit][slot] == 0 || i >= n->operands) {
        continue;
      }
      const graph_node *operand = &d->graph.node[n->operand[i]];
      width = operand->kind >= 0 ? bits_of(p, &d->graph.kind[operand->kind]) : width;
      source[sources] = times_source(d, n->operand[i], k->start[unit] + slot);
      int same = 0;
      while (strcmp(source[same].text, source[sources].text) != 0) {
        same++;
      }
      sources += same == sources;
    }
    bits += sources > 1 ? (sources - 1) * width : 0;
  }
  return bits;
}

/* Count a unit of a kind, and the registers that its results wait in. */
static void add_unit(exact_parts *parts, const exact_plan *p, const graph_kind *k, int unit) {
  const datapath *d = &p->datapath;
  const schedule_producer *of = &d->schedule.producer[k->producer[unit]];
  const arith_plan *multiplier = multiplier_of(p, k);
  int bits = bits_of(p, k);
  parts->full_adders += adders_in(p, k);
  parts->additions += additions_in(p, k);
  parts->multiplexers += d->schedule.ii > 1 ? multiplexers_of(p, k, unit) : 0;
  parts->rows += multiplier != NULL ? multiplier->rows * multiplier->a_w : 0;
  parts->registers += registers_in(p, k) + of->line * bits;
  parts->holding += schedule_holds(&d->schedule, of) * bits;
}

exact_parts exact_parts_of(const exact_plan *p) {
  const datapath *d = &p->datapath;
  exact_parts parts = {.coordinates = coordinates_count(&d->coordinates) * p->design->core_word,
                       .control = exact_control_count(p)};
  for (const graph_kind *k = d->graph.kind; k < d->graph.kind + d->graph.kinds; k++) {
    for (int unit = 0; unit < k->units; unit++) {
      if (k->count[unit] > 0) {
        add_unit(&parts, p, k, unit);
      }
    }
  }
  exact_axis_count(p, &parts);
  return parts;
}

/* Thirds of a gate equivalent, by Nangate45: a full adder, a bit of a fast addition, an input of a
 * multiplexer. */
enum { FULL_ADDER = 16, FAST_ADDER = 22, MULTIPLEXER = 5 };

exact_counts exact_count(const exact_plan *p) {
  const exact_parts n = exact_parts_of(p);
  const int plain = n.registers + n.control;
  const int enabled = n.holding + n.coordinates;
  const int logic = FULL_ADDER * n.full_adders +
                    (p->ripple ? FULL_ADDER : FAST_ADDER) * n.additions +
                    MULTIPLEXER * n.multiplexers;
  return (exact_counts){.latency = exact_latency(p),
                        .flip_flops = plain + enabled,
                        .gates = (p->delay->family ? 0 : logic) + p->delay->flip_flop * plain +
                                 p->delay->enabled_flip_flop * enabled};
}
