/* emission.c - units of a datapath: operands, instances. */
#include "emission.h"

#include "binding.h"

#include <stdlib.h>
#include <string.h>

typedef char source[EMIT_NAME];

static const schedule_stream *stream_of(const emission *e, const graph_kind *k, int unit) {
  return &e->d->schedule.stream[k->stream[unit]];
}

static FILE *open_text(char **text, size_t *size) {
  FILE *out = open_memstream(text, size);
  if (out == NULL) {
    abort();
  }
  return out;
}

void emission_declare(emission *e) {
  const graph *g = &e->d->graph;
  coordinates_declare(&e->d->coordinates, e->m);
  emit_text(e->m,
            "\n// Outputs of the units. _q, _q2 ... are their delay lines; _hold is a holding "
            "register.");
  for (int i = 0; i < g->kinds; i++) {
    const graph_kind *k = &g->kind[i];
    for (int unit = 0; unit < k->units; unit++) {
      if (binding_count(k, unit) > 0) {
        emit_net(e->m, EMIT_WIRE, k->row.is_signed, stream_of(e, k, unit)->name, k->row.width);
      }
    }
  }
  schedule_declare(&e->d->schedule, e->m);
  coordinates_clock(&e->d->coordinates, e->m);
  emit_text(e->m, "\nalways @(posedge clk) begin");
  schedule_clock(&e->d->schedule, e->m);
  emit_text(e->m, "end");
}

/* ---------------------------------------------------------------------- operands */

/* What is high in this cycle of the II window: a bit of the slot, or its copy of this name, which
 * is made of the bit a cycle earlier. */
static void slot_name(emission *e, const char *copies, int cycle, source text) {
  int ii = e->d->schedule.ii;
  if (copies == NULL) {
    snprintf(text, EMIT_NAME, "slot[%d]", cycle % ii);
    return;
  }
  snprintf(text, EMIT_NAME, "slot_%s_%d", copies, cycle % ii);
  for (int i = 0; i < e->copies; i++) {
    if (strcmp(e->copy[i], text) == 0) {
      return;
    }
  }
  if (e->copies == EMISSION_COPIES) {
    abort(); /* more slot copies than EMISSION_COPIES */
  }
  source name;
  snprintf(e->copy[e->copies++], EMIT_NAME, "%s", text);
  snprintf(name, EMIT_NAME, "copy_%s_%d", copies, cycle % ii);
  emit_net(e->m, EMIT_WIRE, false, text, "");
  emit_instance(e->m, "sepax_slot_copy", name, "", "clk=clk, slot=slot[%d], slot_q=%s",
                (cycle + ii - 1) % ii, text);
}

/* "(slot[0] || slot[2]) ? source :" for all slots in which it is the operand. */
static void print_case(emission *e, FILE *out, const graph_kind *k, int unit, source text[],
                       int first) {
  const char *separator = "\n    (";
  int terms = 0;
  for (int slot = first; slot < e->d->schedule.ii; slot++) {
    if (strcmp(text[slot], text[first]) == 0) {
      source name;
      slot_name(e, k->slots, k->start[unit] + slot, name);
      fprintf(out, "%s%s", separator, name);
      separator = ++terms % 4 == 0 ? " ||\n     " : " || ";
    }
  }
  fprintf(out, ") ? %s :", text[first]);
}

/* The operand that a unit reads, text[slot] in each slot ("": nothing): a register, or a wire
 * `name` that selects one. What most slots read needs no condition. */
static void select_operand(emission *e, const graph_kind *k, int unit, const char *name,
                           source text[], graph_value operand, source out) {
  int ii = e->d->schedule.ii;
  int votes[SEPAX_II_MAX] = {0};
  int best = 0;
  int used = 0;
  for (int slot = 0; slot < ii; slot++) {
    /* NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult): callers fill ii slots */
    for (int other = 0; other < ii && text[slot][0] != '\0'; other++) {
      votes[slot] += strcmp(text[slot], text[other]) == 0;
    }
    used += text[slot][0] != '\0';
    best = votes[slot] > votes[best] ? slot : best;
  }
  snprintf(out, EMIT_NAME, "%s", votes[best] == used ? text[best] : name);
  if (votes[best] == used) {
    return;
  }
  char *line = NULL;
  size_t size = 0;
  FILE *stream = open_text(&line, &size);
  for (int slot = 0; slot < ii; slot++) {
    bool first = text[slot][0] != '\0' && strcmp(text[slot], text[best]) != 0;
    for (int other = 0; other < slot && first; other++) {
      first = strcmp(text[slot], text[other]) != 0;
    }
    if (first) {
      print_case(e, stream, k, unit, text, slot);
    }
  }
  fclose(stream);
  emit_net(e->m, EMIT_WIRE, graph_is_signed(&e->d->graph, operand), name,
           graph_width(&e->d->graph, operand));
  emit_text(e->m, "assign %s =%s\n    %s;", name, line, text[best]);
  free(line);
}

static void operand_of(emission *e, const graph_kind *k, int unit, int index, source out) {
  source text[SEPAX_II_MAX];
  source name;
  graph_value operand = 0;
  for (int slot = 0; slot < e->d->schedule.ii; slot++) {
    const graph_node *n = &e->d->graph.node[k->at[unit][slot]];
    text[slot][0] = '\0';
    if (k->at[unit][slot] != 0) {
      operand = n->operand[index];
      times_source(e->d, operand, k->start[unit] + slot, text[slot]);
    }
  }
  snprintf(name, EMIT_NAME, "%s_op%d", stream_of(e, k, unit)->name, index + 1);
  select_operand(e, k, unit, name, text, operand, out);
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

/* Results that a unit has beside its own: connections; their number. */
static int more_outputs(const emission *e, int kind, int unit, FILE *out) {
  const graph *g = &e->d->graph;
  int count = 0;
  for (int i = 0; i < g->kinds; i++) {
    const graph_kind *k = &g->kind[i];
    if (k->row.module != NULL || k->row.expression != NULL || unit >= k->units ||
        binding_count(k, unit) == 0 || g->node[g->node[k->operation[0]].beside].kind != kind) {
      continue;
    }
    fprintf(out, ", %s=%s", k->row.output, stream_of(e, k, unit)->name);
    count++;
  }
  return count;
}

/* A comment: the operations of a unit that has several. */
static void describe(const emission *e, const graph_kind *k, int unit) {
  const schedule_stream *s = stream_of(e, k, unit);
  if (binding_count(k, unit) < 2) {
    emit_blank(e->m);
    return;
  }
  char *line = NULL;
  size_t size = 0;
  FILE *out = open_text(&line, &size);
  const char *separator = "";
  int terms = 0;
  for (int slot = 0; slot < e->d->schedule.ii; slot++) {
    if (k->at[unit][slot] != 0) {
      fprintf(out, "%s %s_%s", separator, s->symbol, s->label[slot]);
      separator = ++terms % 4 == 0 ? ",\n//  " : ",";
    }
  }
  fclose(out);
  emit_text(e->m, "\n// %s:%s.", s->name, line);
  free(line);
}

/* The row's expression of the operand. */
static void assign_expression(const emission *e, const graph_kind *k, int unit,
                              const char *operand) {
  char *line = NULL;
  size_t size = 0;
  FILE *out = open_text(&line, &size);
  for (const char *c = k->row.expression; *c != '\0'; c++) {
    if (*c == '@') {
      fputs(operand, out);
    } else {
      fputc(*c, out);
    }
  }
  fclose(out);
  emit_text(e->m, "assign %s = %s;", stream_of(e, k, unit)->name, line);
  free(line);
}

static void instance(emission *e, int kind, int unit) {
  const graph_kind *k = &e->d->graph.kind[kind];
  char *connections = NULL;
  size_t size = 0;
  FILE *out = open_text(&connections, &size);
  describe(e, k, unit);
  bool without = cancel(e, k, unit);
  for (int i = 0; i < GRAPH_OPERANDS && k->row.operand[i] != NULL; i++) {
    const char *port = k->row.operand[i];
    if (!is_optional(port) || !without) {
      source text;
      operand_of(e, k, unit, i, text);
      fprintf(out, ", %s=%s", port + is_optional(port), text);
    }
  }
  fprintf(out, ", %s=%s", k->row.output, stream_of(e, k, unit)->name);
  int more = more_outputs(e, kind, unit, out);
  fclose(out);
  const char *module =
      k->row.lesser != NULL && without && more == 0 ? k->row.lesser : k->row.module;
  source name;
  snprintf(name, EMIT_NAME, "%s_%s", module + strlen("sepax_"), stream_of(e, k, unit)->name);
  emit_instance(e->m, module, name, "", "%s%s", k->latency > 0 ? "clk=clk" : connections + 2,
                k->latency > 0 ? connections : "");
  free(connections);
}

void emission_units(emission *e, int kind) {
  const graph_kind *k = &e->d->graph.kind[kind];
  if (k->row.about != NULL) {
    emit_text(e->m, "\n// %s", k->row.about);
  }
  for (int unit = 0; unit < k->units; unit++) {
    if (binding_count(k, unit) == 0) {
      continue;
    }
    if (k->row.module != NULL) {
      instance(e, kind, unit);
    } else if (k->row.expression != NULL) {
      source text;
      operand_of(e, k, unit, 0, text);
      assign_expression(e, k, unit, text);
    }
  }
}

void emission_bus(emission *e, const char *name, const graph_value value[], int cycle) {
  char *line = NULL;
  size_t size = 0;
  FILE *out = open_text(&line, &size);
  char width[2 * EMIT_NAME];
  int count = 0;
  while (value[count] != 0) {
    count++;
  }
  for (int i = count - 1; i >= 0; i--) {
    source text;
    times_source(e->d, value[i], cycle, text);
    fprintf(out, "%s%s", text, i == 0 ? "" : i % 4 == 0 ? ",\n    " : ", ");
  }
  fclose(out);
  snprintf(width, sizeof width, "%d*(%s)", count, graph_width(&e->d->graph, value[0]));
  emit_net(e->m, EMIT_WIRE, false, name, width);
  emit_text(e->m, "assign %s = {%s};", name, line);
  free(line);
}
