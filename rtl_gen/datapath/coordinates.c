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

void coordinates_declare(const coordinates *c, FILE *out) {
  for (const char *axis = axes; *axis != '\0'; axis++) {
    for (int bank = 0; bank < c->axis[index_of(*axis)].banks; bank++) {
      for (int v = 0; v < 6; v++) {
        if (is_there(c, *axis, v, bank)) {
          char name[EMIT_NAME];
          register_name(*axis, v, bank, name);
          emit_net(out, "reg signed", "W", name);
        }
      }
    }
  }
}

static void rotate(const coordinates *c, FILE *out, char axis, int bank) {
  for (int v = 0; v < 6; v++) {
    char to[EMIT_NAME];
    char from[EMIT_NAME];
    register_name(axis, v, bank, to);
    register_name(axis, v / 3 * 3 + (v + 1) % 3, bank, from);
    if (is_there(c, axis, v, bank)) {
      fprintf(out, "      %s <= %s;\n", to, from);
    }
  }
}

/* A register takes its coordinate over from the bank before, or from the input, or, for a second
 * pass, from the last banks: u for x and z for y. */
static void load(const coordinates *c, FILE *out, char axis, int v, int bank) {
  const char *indent = c->ii > 1 ? "    " : "  ";
  char to[EMIT_NAME];
  char from[EMIT_NAME];
  register_name(axis, v, bank, to);
  int before = c->axis[index_of(axis)].start[bank] - 1;
  if (axis == 'u' && bank == 1) {
    char other[EMIT_NAME];
    source_in(c, 'x', v, 0, before, from);
    source_in(c, 'y', v, 0, before, other);
    fprintf(out, "  %s%s <= x_equal ? %s : %s;\n", indent, to, other, from);
  } else if (bank > 0) {
    source_in(c, axis, v, bank - 1, before, from);
    fprintf(out, "  %s%s <= %s;\n", indent, to, from);
  } else if (!c->second_pass || axis == 'z') {
    fprintf(out, "  %s%s <= in_%s_%c;\n", indent, to, graph_vertex_name(v), axis);
  } else {
    coordinates_source(c, axis == 'x' ? 'u' : 'z', v, c->again, from);
    snprintf(from + strlen(from), EMIT_NAME - strlen(from), " : in_%s_%c", graph_vertex_name(v),
             axis);
    fprintf(out, "  %s%s <= again ? %s;\n", indent, to, from);
  }
}

void coordinates_clock(const coordinates *c, FILE *out) {
  for (const char *axis = axes; *axis != '\0'; axis++) {
    const coordinates_axis *a = &c->axis[index_of(*axis)];
    for (int bank = *axis == 'u'; bank < a->banks; bank++) {
      if (c->ii > 1) {
        fprintf(out, "    if (slot[%d]) begin\n", (a->start[bank] + c->ii - 1) % c->ii);
      }
      for (int v = 0; v < 6; v++) {
        if (is_there(c, *axis, v, bank)) {
          load(c, out, *axis, v, bank);
        }
      }
      if (c->rotate) {
        fprintf(out, "    end else begin\n");
        rotate(c, out, *axis, bank);
      }
      if (c->ii > 1) {
        fprintf(out, "    end\n");
      }
    }
  }
}
