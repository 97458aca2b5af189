/* coordinates.c - rotating registers of coordinates. */
#include "coordinates.h"

#include "graph.h"

#include <stdlib.h>
#include <string.h>

static const char axes[] = "xyzu";

static int index_of(char axis) { return (int)(strchr(axes, axis) - axes); }

void coordinates_init(coordinates *c, int ii) {
  *c = (coordinates){.ii = ii, .rotate = ii % 3 == 0};
  for (int i = 0; i < 4; i++) {
    for (int v = 0; v < 6; v++) {
      c->axis[i].last[v] = -1;
    }
  }
}

void coordinates_need(coordinates *c, char axis, int v, int cycle) {
  int *last = &c->axis[index_of(axis)].last[v];
  *last = cycle > *last ? cycle : *last;
}

/* Banks from cycle 0 on, a change in cycle `change`, until cycle `last` is covered. */
static void lay_out(coordinates_axis *a, int ii, int change, int last) {
  a->banks = 1;
  a->start[0] = 0;
  while (a->start[a->banks - 1] < change || a->start[a->banks - 1] + ii - 1 < last) {
    if (a->banks == COORDINATES_BANKS) {
      abort(); /* more banks than COORDINATES_BANKS */
    }
    int before = a->start[a->banks - 1];
    a->start[a->banks++] = before < change && before + ii > change ? change : before + ii;
  }
}

static int last_of(const coordinates_axis *a) {
  int last = 0;
  for (int v = 0; v < 6; v++) {
    last = a->last[v] > last ? a->last[v] : last;
  }
  return last;
}

void coordinates_store(coordinates *c, int z_change) {
  if (c->second_pass) {
    for (int v = 0; v < 6; v++) {
      coordinates_need(c, 'u', v, c->again);
      coordinates_need(c, 'z', v, c->again);
    }
  }
  for (int i = 0; i < 4; i++) {
    lay_out(&c->axis[i], c->ii, 0, last_of(&c->axis[i]));
  }
  coordinates_axis *z = &c->axis[index_of('z')];
  int fewest = z->banks;
  lay_out(z, c->ii, z_change, last_of(z));
  if (z->banks > fewest) {
    lay_out(z, c->ii, 0, last_of(z));
  }
}

static int bank_of(const coordinates *c, char axis, int cycle) {
  const coordinates_axis *a = &c->axis[index_of(axis)];
  for (int bank = 0; bank < a->banks; bank++) {
    if (cycle < a->start[bank] + c->ii) {
      return bank;
    }
  }
  abort(); /* it is read when no bank has it any more */
}

/* Bank 0 of u is x. Is a register of the others there: read, or rotated, or moved on? */
static bool is_there(const coordinates *c, char axis, int v, int bank) {
  const coordinates_axis *a = &c->axis[index_of(axis)];
  if (bank == 0) {
    return axis != 'u';
  }
  int last = a->last[v];
  for (int k = 0; k < 3 && c->rotate; k++) {
    int other = a->last[v / 3 * 3 + k];
    last = other > last ? other : last;
  }
  return last >= a->start[bank - 1] + c->ii;
}

static void register_name(char axis, int v, int bank, char text[EMIT_NAME]) {
  int used = snprintf(text, EMIT_NAME, "%c_%s", axis, graph_vertex_name(v));
  if (bank == 1) {
    snprintf(text + used, EMIT_NAME - (size_t)used, "_hold");
  } else if (bank > 1) {
    snprintf(text + used, EMIT_NAME - (size_t)used, "_hold%d", bank);
  }
}

static void source_in(const coordinates *c, char axis, int v, int bank, int cycle,
                      char text[EMIT_NAME]) {
  int turned = c->rotate ? (cycle - c->axis[index_of(axis)].start[bank]) % 3 : 0;
  register_name(axis, v / 3 * 3 + (v % 3 - turned + 3) % 3, bank, text);
}

void coordinates_source(const coordinates *c, char axis, int v, int cycle, char text[EMIT_NAME]) {
  source_in(c, axis, v, bank_of(c, axis, cycle), cycle, text);
}

void coordinates_declare(const coordinates *c, emit_module *m) {
  bool has_u = c->axis[index_of('u')].banks > 1;
  char name[EMIT_NAME];
  emit_text(m, "\n// Coordinates. _hold, _hold2 ... stand for one II window more each.%s%s",
            c->rotate ? "\n// The vertices of each triangle rotate, one place a cycle." : "",
            has_u
                ? "\n// u is x, or y where all six x are equal: with z it makes the projection of "
                  "a second pass."
                : "");
  for (const char *axis = axes; *axis != '\0'; axis++) {
    for (int bank = 0; bank < c->axis[index_of(*axis)].banks; bank++) {
      for (int v = 0; v < 6; v++) {
        if (is_there(c, *axis, v, bank)) {
          register_name(*axis, v, bank, name);
          emit_net(m, EMIT_REG, true, name, "W");
        }
      }
    }
  }
  if (has_u) {
    emit_net(m, EMIT_WIRE, false, "x_equal", "");
    emit_text(m, "assign x_equal = (x_a2 == x_a1) && (x_a3 == x_a1) && (x_b1 == x_a1) &&\n"
                 "                 (x_b2 == x_a1) && (x_b3 == x_a1);");
  }
}

static void rotate(const coordinates *c, emit_module *m, char axis, int bank) {
  for (int v = 0; v < 6; v++) {
    char to[EMIT_NAME];
    char from[EMIT_NAME];
    register_name(axis, v, bank, to);
    register_name(axis, v / 3 * 3 + (v + 1) % 3, bank, from);
    if (is_there(c, axis, v, bank)) {
      emit_text(m, "    %s <= %s;", to, from);
    }
  }
}

/* A register takes its coordinate over from the bank before, or from the input, or, for a second
 * pass, from the last banks: u for x and z for y. */
static void load(const coordinates *c, emit_module *m, char axis, int v, int bank) {
  const char *indent = c->ii > 1 ? "    " : "  ";
  char to[EMIT_NAME];
  char from[EMIT_NAME];
  register_name(axis, v, bank, to);
  int before = c->axis[index_of(axis)].start[bank] - 1;
  if (axis == 'u' && bank == 1) {
    char other[EMIT_NAME];
    source_in(c, 'x', v, 0, before, from);
    source_in(c, 'y', v, 0, before, other);
    emit_text(m, "%s%s <= x_equal ? %s : %s;", indent, to, other, from);
  } else if (bank > 0) {
    source_in(c, axis, v, bank - 1, before, from);
    emit_text(m, "%s%s <= %s;", indent, to, from);
  } else if (!c->second_pass || axis == 'z') {
    emit_text(m, "%s%s <= in_%s_%c;", indent, to, graph_vertex_name(v), axis);
  } else {
    coordinates_source(c, axis == 'x' ? 'u' : 'z', v, c->again, from);
    snprintf(from + strlen(from), EMIT_NAME - strlen(from), " : in_%s_%c", graph_vertex_name(v),
             axis);
    emit_text(m, "%s%s <= again ? %s;", indent, to, from);
  }
}

void coordinates_clock(const coordinates *c, emit_module *m) {
  emit_text(m, "\nalways @(posedge clk) begin");
  for (const char *axis = axes; *axis != '\0'; axis++) {
    const coordinates_axis *a = &c->axis[index_of(*axis)];
    for (int bank = *axis == 'u'; bank < a->banks; bank++) {
      if (c->ii > 1) {
        emit_text(m, "  if (slot[%d]) begin", (a->start[bank] + c->ii - 1) % c->ii);
      }
      for (int v = 0; v < 6; v++) {
        if (is_there(c, *axis, v, bank)) {
          load(c, m, *axis, v, bank);
        }
      }
      if (c->rotate) {
        emit_text(m, "  end else begin");
        rotate(c, m, *axis, bank);
      }
      if (c->ii > 1) {
        emit_text(m, "  end");
      }
    }
  }
  emit_text(m, "end");
}
