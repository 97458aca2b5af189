/* SPDX-License-Identifier: MIT */
/* emission.c - units of a datapath: operands, instances. */
#include "emission.h"

#include <string.h>

typedef struct {
  const datapath *d;
  advance *advance;
  emit_text *text; /* all units so far */
} emission;

static const schedule_producer *producer_of(const datapath *d, const graph_kind *k, int unit) {
  return &d->schedule.producer[k->producer[unit]];
}

/* ---------------------------------------------------------------------- operands */

/* What is high in this cycle of the II window: a bit of the slot, or its copy of this name, which
 * is made of the bit a cycle earlier. On an FPGA each II window has a copy instead. With enables
 * the bit is 0 while no pair is here, so the copy of slot 0, in which a pair begins, is made of the
 * end of the window, unless pairs are here before. */
static gen_line slot_name(const emission *e, const char *copies, int begin, int cycle) {
  int ii = e->d->schedule.ii;
  int slot = cycle % ii;
  if (copies == NULL || e->advance->copied) {
    return advance_slot(e->advance, begin, cycle);
  }
  const gen_line name = gen_format("slot_%s_%d", copies, slot);
  const gen_line wire = gen_format("  wire %s;\n", name.text);
  if (strstr(text_so_far(e->text), wire.text) == NULL) {
    const gen_line before = e->advance->gated && !e->advance->ahead && slot == 0
                                ? gen_format("last")
                                : gen_format("slot[%d]", (slot + ii - 1) % ii);
    text_printf(e->text,
                "%s  sepax_slot_copy copy_%s_%d (\n"
                "    .clk(clk),\n    .slot(%s),\n    .slot_q(%s)\n  );\n",
                wire.text, copies, slot, before.text, name.text);
  }
  return name;
}

/* "(slot[0] || slot[2]) ? source :" for all slots in which it is the operand. */
static void print_case(const emission *e, emit_text *out, const graph_kind *k, int unit,
                       const gen_line source[], int first) {
  const char *separator = "\n      (";
  int terms = 0;
  for (int slot = first; slot < e->d->schedule.ii; slot++) {
    if (strcmp(source[slot].text, source[first].text) == 0) {
      text_printf(out, "%s%s", separator,
                  slot_name(e, k->slots, k->start[unit], k->start[unit] + slot).text);
      separator = ++terms % 4 == 0 ? " ||\n       " : " || ";
    }
  }
  text_printf(out, ") ? %s :", source[first].text);
}

/* The operand that a unit reads: a register, or a wire that selects one. What most slots read needs
 * no condition. */
static gen_line operand_of(const emission *e, const graph_kind *k, int unit, int index) {
  gen_line source[SEPAX_II_MAX]; /* in each slot; "": nothing */
  int votes[SEPAX_II_MAX] = {0}; /* of slots that read the same, for the first of them */
  int best = 0;
  int used = 0;
  graph_value operand = 0;
  for (int slot = 0; slot < e->d->schedule.ii; slot++) {
    source[slot].text[0] = '\0';
    if (k->at[unit][slot] != 0) {
      operand = e->d->graph.node[k->at[unit][slot]].operand[index];
      source[slot] = times_source(e->d, operand, k->start[unit] + slot);
      int first = 0;
      while (strcmp(source[first].text, source[slot].text) != 0) {
        first++;
      }
      votes[first]++;
      used++;
    }
  }
  for (int slot = 1; slot < e->d->schedule.ii; slot++) {
    best = votes[slot] > votes[best] ? slot : best;
  }
  if (votes[best] == used) {
    return source[best];
  }
  emit_text cases = {NULL};
  for (int slot = 0; slot < e->d->schedule.ii; slot++) {
    if (votes[slot] > 0 && slot != best) {
      print_case(e, &cases, k, unit, source, slot);
    }
  }
  const gen_line name = gen_format("%s_op%d", producer_of(e->d, k, unit)->name, index + 1);
  emit_net(e->text, graph_is_signed(&e->d->graph, operand) ? "wire signed" : "wire",
           graph_width(&e->d->graph, operand), name.text);
  text_printf(e->text, "  assign %s =", name.text);
  text_append(e->text, &cases);
  text_printf(e->text, "\n      %s;\n", source[best].text);
  return name;
}

/* ------------------------------------------------------------------------- units */

static bool is_optional(const char *port) { return port[0] == '?'; }

/* Do the optional operands of each operation of a unit cancel? */
static bool cancel(const emission *e, const graph_kind *k, int unit) {
  for (int slot = 0; slot < e->d->schedule.ii; slot++) {
    const graph_node *n = &e->d->graph.node[k->at[unit][slot]];
    graph_value common = 0;
    for (int i = 0; i < n->operands; i++) {
      if (is_optional(k->row.operand[i])) {
        if (common != 0 && n->operand[i] != common) {
          return false;
        }
        common = n->operand[i];
      }
    }
  }
  return true;
}

/* Optional outputs of a unit: operations beside its own. Returns how many there are. */
static int more_outputs(const emission *e, const graph_kind *of, int unit, emit_text *out) {
  const graph *g = &e->d->graph;
  int count = 0;
  for (const graph_kind *k = g->kind; k < g->kind + g->kinds; k++) {
    if (k->row.module == NULL && k->row.expression == NULL && k->count[unit] > 0 &&
        graph_kind_of(g, g->node[k->operation[0]].beside) == of) {
      text_printf(out, ",\n    .%s(%s)", k->row.output, producer_of(e->d, k, unit)->name);
      count++;
    }
  }
  return count;
}

/* Do the slots read this operand from different places? */
static bool is_selected(const emission *e, const graph_kind *k, int unit, int index) {
  gen_line first = {""};
  for (int slot = 0; slot < e->d->schedule.ii; slot++) {
    if (k->at[unit][slot] != 0) {
      graph_value operand = e->d->graph.node[k->at[unit][slot]].operand[index];
      const gen_line source = times_source(e->d, operand, k->start[unit] + slot);
      if (first.text[0] != '\0' && strcmp(first.text, source.text) != 0) {
        return true;
      }
      first = source;
    }
  }
  return false;
}

/* The operand for a port: its own, but for the first on a carry chain one that is not selected, if
 * its sum has such a one. */
static int operand_for(const emission *e, const graph_kind *k, int unit, int port) {
  int first = 0;
  if (!e->d->chains || !k->row.commutes) {
    return port;
  }
  int added = -k->row.negative;
  while (added + k->row.negative < GRAPH_OPERANDS &&
         k->row.operand[added + k->row.negative] != NULL) {
    added++;
  }
  while (first < added - 1 && is_selected(e, k, unit, first)) {
    first++;
  }
  first = is_selected(e, k, unit, first) ? 0 : first;
  return port == 0 ? first : port == first ? 0 : port;
}

/* A comment: the operations of a unit that has several. */
static void describe(const emission *e, const graph_kind *k, int unit) {
  const schedule_producer *s = producer_of(e->d, k, unit);
  emit_text *out = e->text;
  int left = k->count[unit];
  text_putc(out, '\n');
  if (left < 2) {
    return;
  }
  text_printf(out, "  // %s:", s->name);
  for (int slot = 0, terms = 1; left > 0; slot++) {
    if (k->at[unit][slot] != 0) {
      left--;
      text_printf(out, " %s_%s%s", s->symbol, s->label[slot],
                  left == 0          ? ".\n"
                  : terms++ % 4 == 0 ? ",\n  //  "
                                     : ",");
    }
  }
}

static void print_instance(const emission *e, const graph_kind *k, int unit) {
  const char *name = producer_of(e->d, k, unit)->name;
  bool without = cancel(e, k, unit);
  emit_text ports = {NULL};
  describe(e, k, unit);
  text_puts(&ports, k->latency > 0 ? "\n    .clk(clk)," : "");
  for (int stage = 1; e->advance->gated && stage <= k->latency; stage++) {
    text_printf(&ports, "%s%s%s", stage == 1 ? "\n    .advance(" : " || ",
                advance_name(e->advance, k->start[unit] + stage).text,
                stage == k->latency ? ")," : "");
  }
  for (int i = 0; i < GRAPH_OPERANDS && k->row.operand[i] != NULL; i++) {
    const char *port = k->row.operand[i];
    if (!is_optional(port) || !without) {
      const gen_line operand = operand_of(e, k, unit, operand_for(e, k, unit, i));
      text_printf(&ports, "\n    .%s(%s),", port + is_optional(port), operand.text);
    }
  }
  text_printf(&ports, "\n    .%s(%s)", k->row.output, name);
  int more = more_outputs(e, k, unit, &ports);
  const char *module =
      k->row.lesser != NULL && without && more == 0 ? k->row.lesser : k->row.module;
  text_printf(e->text, "  %s %s_%s (", module, module + strlen("sepax_"), name);
  text_append(e->text, &ports);
  text_puts(e->text, "\n  );\n");
}

/* The row's expression of the operand. */
static void print_expression(const emission *e, const graph_kind *k, int unit) {
  const gen_line operand = operand_of(e, k, unit, 0);
  text_printf(e->text, "  assign %s = ", producer_of(e->d, k, unit)->name);
  for (const char *c = k->row.expression; *c != '\0'; c++) {
    text_printf(e->text, "%.*s", *c == '@' ? EMIT_NAME : 1, *c == '@' ? operand.text : c);
  }
  text_puts(e->text, ";\n");
}

/* The units of a kind, with what selects their operands. */
static void print_units(const emission *e, const graph_kind *k) {
  if (k->row.about != NULL) {
    text_printf(e->text, "\n  // %s\n", k->row.about);
  }
  for (int unit = 0; unit < k->units; unit++) {
    if (k->count[unit] > 0 && k->row.module != NULL) {
      print_instance(e, k, unit);
    } else if (k->count[unit] > 0 && k->row.expression != NULL) {
      print_expression(e, k, unit);
    }
  }
}

/* ---------------------------------------------------------------------- the module */

static void declare_outputs(const datapath *d, emit_text *out) {
  for (const graph_kind *k = d->graph.kind; k < d->graph.kind + d->graph.kinds; k++) {
    for (int unit = 0; unit < k->units; unit++) {
      if (k->count[unit] > 0) {
        emit_net(out, k->row.is_signed ? "wire signed" : "wire", k->row.width,
                 producer_of(d, k, unit)->name);
      }
    }
  }
}

void emission_holes(datapath *d, emit_holes *h) {
  coordinates_declare(&d->coordinates, emit_hole_open(h, "coordinates"));
  declare_outputs(d, emit_hole_open(h, "outputs"));
  schedule_declare(&d->schedule, &h->text);
  coordinates_clock(&d->coordinates, &d->advance, emit_hole_open(h, "coordinate_moves"));
  schedule_clock(&d->schedule, &d->advance, emit_hole_open(h, "output_moves"));
  emit_hole_open(h, "units");
  for (int kind = 0; kind < d->graph.kinds; kind++) {
    print_units(&(emission){d, &d->advance, &h->text}, &d->graph.kind[kind]);
  }
  advance_copies(&d->advance, emit_hole_open(h, "slot_copies"));
  emit_hole_close(h);
}

void emission_bus(const datapath *d, emit_text *out, const char *name, const graph_value value[],
                  int cycle) {
  int count = 0;
  while (value[count] != 0) {
    count++;
  }
  emit_net(out, "wire", gen_format("%d*(%s)", count, graph_width(&d->graph, value[0])).text, name);
  text_printf(out, "  assign %s = {", name);
  for (int i = count - 1; i >= 0; i--) {
    text_printf(out, "%s%s", times_source(d, value[i], cycle).text,
                i == 0       ? "};\n"
                : i % 4 == 0 ? ",\n      "
                             : ", ");
  }
}
