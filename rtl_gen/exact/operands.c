/* gen_exact_operands.c - banks of coordinates in sepax_core, and where its units find their
 * operands in each cycle. */
#include "core.h"
#include "sepax_design.h"

#include <stdlib.h>
#include <string.h>

/* ------------------------------------------------------------------------- banks */

const char *core_vertex_name(int v) {
  static const char *const name[] = {"a1", "a2", "a3", "b1", "b2", "b3"};
  return name[v];
}

static void bank_name(char axis, int v, int bank, source text) {
  int used = snprintf(text, EMIT_NAME, "%c_%s", axis, core_vertex_name(v));
  if (bank > 0) {
    snprintf(text + used, EMIT_NAME - (size_t)used, "_q%d", bank);
  }
}

static int banks_of(const core *c, char axis) {
  return axis == 'z' ? c->p->z_banks : axis == 'u' ? c->p->u_banks : 1;
}

static int bank_start(const core *c, char axis, int bank) {
  return axis == 'z' ? c->p->z_bank[bank] : c->p->u_bank[bank];
}

void core_coordinate(const core *c, char axis, int v, int bank, int cycle, source text) {
  int turned = c->p->turns ? (cycle - bank_start(c, axis, bank)) % 3 : 0;
  bank_name(axis, v / 3 * 3 + (v % 3 - turned + 3) % 3, bank, text);
}

static const char axes[] = "xyzu";

void core_declare_banks(core *c) {
  char name[EMIT_NAME];
  emit_text(c->m, "\n// Coordinates%s.%s",
            c->p->turns ? "; the vertices of each triangle go round, one place a cycle" : "",
            c->p->u_banks > 1 ? " u is x, or y where all six x are\n// equal: with z it does for a "
                                "second look at pairs that are flat in x and y."
                              : "");
  for (const char *axis = axes; *axis != '\0'; axis++) {
    for (int bank = *axis == 'u'; bank < banks_of(c, *axis); bank++) {
      for (int v = 0; v < 6; v++) {
        bank_name(*axis, v, bank, name);
        emit_net(c->m, EMIT_REG, true, name, "W");
      }
    }
  }
  if (c->p->u_banks > 1) {
    emit_net(c->m, EMIT_WIRE, false, "x_equal", "");
    emit_text(c->m, "assign x_equal = (x_a2 == x_a1) && (x_a3 == x_a1) && (x_b1 == x_a1) &&\n"
                    "                 (x_b2 == x_a1) && (x_b3 == x_a1);");
  }
}

static void turn(core *c, char axis, int bank, const char *indent) {
  for (int v = 0; v < 6; v++) {
    source to;
    source from;
    bank_name(axis, v, bank, to);
    bank_name(axis, v / 3 * 3 + (v + 1) % 3, bank, from);
    emit_text(c->m, "%s%s <= %s;", indent, to, from);
  }
}

/* A bank takes the pair over from the one before, or from the input, or, for a second
 * pass, from the last banks: u for x and z for y. */
static void load(core *c, char axis, int bank, const char *indent) {
  for (int v = 0; v < 6; v++) {
    source to;
    source from;
    bank_name(axis, v, bank, to);
    int before = bank_start(c, axis, bank) - 1;
    if (axis == 'u' && bank == 1) {
      source other;
      core_coordinate(c, 'x', v, 0, before, from);
      core_coordinate(c, 'y', v, 0, before, other);
      emit_text(c->m, "%s%s <= x_equal ? %s : %s;", indent, to, other, from);
    } else if (bank > 0) {
      core_coordinate(c, axis, v, bank - 1, before, from);
      emit_text(c->m, "%s%s <= %s;", indent, to, from);
    } else if (c->p->single || axis == 'z') {
      emit_text(c->m, "%s%s <= in_%s_%c;", indent, to, core_vertex_name(v), axis);
    } else {
      char again = axis == 'x' ? 'u' : 'z';
      core_coordinate(c, again, v, banks_of(c, again) - 1, c->p->plane_cycle, from);
      emit_text(c->m, "%s%s <= again ? %s : in_%s_%c;", indent, to, from, core_vertex_name(v),
                axis);
    }
  }
}

void core_clock_banks(core *c) {
  emit_text(c->m, "\nalways @(posedge clk) begin");
  for (const char *axis = axes; *axis != '\0'; axis++) {
    for (int bank = *axis == 'u'; bank < banks_of(c, *axis); bank++) {
      if (c->ii == 1) {
        load(c, *axis, bank, "  ");
        continue;
      }
      int phase = (bank_start(c, *axis, bank) + c->ii - 1) % c->ii;
      emit_text(c->m, "  if (at[%d]) begin", phase);
      load(c, *axis, bank, "    ");
      if (c->p->turns) {
        emit_text(c->m, "  end else begin");
        turn(c, *axis, bank, "    ");
      }
      emit_text(c->m, "  end");
    }
  }
  emit_text(c->m, "end");
}

/* ---------------------------------------------------------------------- operands */

/* Bit `cycle` of the copy by which this kind of units chooses; of use while a pair is in the
 * machine. */
static gen_line copy_of(core *c, int cycle) {
  const gen_line name = gen_format("at_q%d_%d", c->turn, cycle);
  if ((c->turned[c->turn] >> cycle & 1) == 0) {
    c->turned[c->turn] |= 1U << cycle;
    emit_net(c->m, EMIT_WIRE, false, name.text, "");
    emit_instance(c->m, "sepax_turn", gen_format("turn_%d_%d", c->turn, cycle).text, "",
                  "clk=clk, at=at[%d], at_q=%s", cycle, name.text);
  }
  return name;
}

void core_choose(core *c, const char *name, const char *width, bool is_signed, int start, int slots,
                 source text[], source out) {
  int votes[SEPAX_II_MAX] = {0};
  int best = 0;
  for (int k = 0; k < slots; k++) {
    for (int j = 0; j < slots; j++) {
      votes[k] += strcmp(text[k], text[j]) == 0;
    }
    best = votes[k] > votes[best] ? k : best;
  }
  if (votes[best] == slots) {
    snprintf(out, EMIT_NAME, "%s", text[best]);
    return;
  }
  char *line = NULL;
  size_t size = 0;
  FILE *stream = open_memstream(&line, &size);
  if (stream == NULL) {
    abort();
  }
  for (int k = 0; k < slots; k++) {
    bool first = strcmp(text[k], text[best]) != 0;
    for (int j = 0; j < k && first; j++) {
      first = strcmp(text[k], text[j]) != 0;
    }
    if (!first) {
      continue;
    }
    const char *separator = "";
    fputc('(', stream);
    for (int j = k; j < slots; j++) {
      if (strcmp(text[k], text[j]) == 0) {
        if (c->turn > 0) {
          fprintf(stream, "%s%s", separator, copy_of(c, (start + j + c->ii - 1) % c->ii).text);
        } else {
          fprintf(stream, "%sat[%d]", separator, (start + j) % c->ii);
        }
        separator = " || ";
      }
    }
    fprintf(stream, ") ? %s :\n         ", text[k]);
  }
  fprintf(stream, "%s", text[best]);
  fclose(stream);
  snprintf(out, EMIT_NAME, "%s", name);
  emit_net(c->m, EMIT_WIRE, is_signed, name, width);
  emit_text(c->m, "assign %s = %s;", name, line);
  free(line);
}

unit core_unit_of(const core *c, exact_class_id id, int number) {
  const exact_class *class = &c->p->class[id];
  unit u = {.id = id, .start = class->start[number], .slots = exact_slots(c->p, id, number)};
  for (int k = 0; k < u.slots; k++) {
    u.operation[k] = exact_operation(c->p, id, number, k);
  }
  u.out = &c->p->schedule.stream[class->stream + number];
  snprintf(u.suffix, sizeof u.suffix, "%s", strchr(u.out->name, '_') + 1);
  return u;
}

void core_describe(core *c, const unit *u) {
  if (c->ii == 1 || u->slots == 1) {
    return;
  }
  char line[EMIT_NAME * SEPAX_II_MAX];
  int used = 0;
  for (int k = 0; k < u->slots; k++) {
    used += snprintf(line + used, sizeof line - (size_t)used, "%s %s_%s", k > 0 ? "," : "",
                     u->out->kind, u->out->label[k]);
  }
  emit_text(c->m, "\n// %s:%s.", u->out->name, line);
}

void core_operand(core *c, const unit *u, int index, const char *width, source out) {
  source text[SEPAX_II_MAX];
  char name[EMIT_NAME];
  for (int k = 0; k < u->slots; k++) {
    schedule_value v[EXACT_TERMS];
    exact_operands(c->p, u->id, u->operation[k], v);
    schedule_source(&c->p->schedule, v[index], u->start + k, text[k]);
  }
  snprintf(name, sizeof name, "%.40s_%c", u->out->name, "pqrs"[index]);
  core_choose(c, name, width, true, u->start, u->slots, text, out);
}

void core_point(core *c, const unit *u, const char *name, char axis, const int vertex[],
                source out) {
  source text[SEPAX_II_MAX];
  char wire[EMIT_NAME];
  for (int k = 0; k < u->slots; k++) {
    int cycle = u->start + k;
    core_coordinate(c, axis, vertex[k], axis == 'z' ? exact_z_bank(c->p, cycle) : 0, cycle,
                    text[k]);
  }
  snprintf(wire, sizeof wire, "%.30s_%s", u->out->name, name);
  core_choose(c, wire, "W", true, u->start, u->slots, text, out);
}
