/* SPDX-License-Identifier: MIT */
/* coordinates.c - rotating registers of coordinates. */
#include "coordinates.h"

#include "graph.h"

#include <stdlib.h>

enum { Z = 2, AXES };

void coordinates_need(coordinates *c, int axis, int v, int cycle) {
  int *end = &c->axis[axis].end[v];
  *end = cycle >= *end ? cycle + 1 : *end;
}

/* The cycle behind the last read. */
static int last_end(const coordinates_axis *a) {
  int end = 0;
  for (int v = 0; v < 6; v++) {
    end = a->end[v] > end ? a->end[v] : end;
  }
  return end;
}

/* Banks from cycle 0 on, a change in cycle `change`, until all reads are covered. */
static void lay_out(coordinates_axis *a, int ii, int change) {
  int end = last_end(a);
  a->banks = 1;
  a->start[0] = 0;
  while (a->banks < COORDINATES_BANKS &&
         (a->start[a->banks - 1] < change || a->start[a->banks - 1] + ii < end)) {
    int before = a->start[a->banks - 1];
    a->start[a->banks++] = before < change && before + ii > change ? change : before + ii;
  }
}

void coordinates_store(coordinates *c, int z_change) {
  for (int axis = 0; axis < AXES; axis++) {
    lay_out(&c->axis[axis], c->ii, 0);
  }
  int fewest = c->axis[Z].banks;
  lay_out(&c->axis[Z], c->ii, z_change);
  if (c->axis[Z].banks > fewest) {
    lay_out(&c->axis[Z], c->ii, 0);
  }
}

/* Is a register of a bank behind the first there: read, or rotated, or moved on? */
static bool is_there(const coordinates *c, int axis, int v, int bank) {
  const coordinates_axis *a = &c->axis[axis];
  if (bank == 0) {
    return true;
  }
  int end = a->end[v];
  for (int k = 0; k < 3 && c->rotate; k++) {
    int other = a->end[v / 3 * 3 + k];
    end = other > end ? other : end;
  }
  return end > a->start[bank - 1] + c->ii;
}

int coordinates_count(const coordinates *c) {
  int count = 0;
  for (int axis = 0; axis < AXES; axis++) {
    for (int n = 0; n < 6 * c->axis[axis].banks; n++) {
      count += is_there(c, axis, n % 6, n / 6);
    }
  }
  return count;
}

static gen_line register_name(int axis, int v, int bank) {
  return gen_format(bank > 1    ? "%c_%s_hold%d"
                    : bank == 1 ? "%c_%s_hold"
                                : "%c_%s",
                    "xyz"[axis], graph_vertex_name(v), bank);
}

static gen_line source_in(const coordinates *c, int axis, int v, int bank, int cycle) {
  int turned = c->rotate ? (cycle - c->axis[axis].start[bank]) % 3 : 0;
  return register_name(axis, v / 3 * 3 + (v % 3 - turned + 3) % 3, bank);
}

gen_line coordinates_source(const coordinates *c, int axis, int v, int cycle) {
  const coordinates_axis *a = &c->axis[axis];
  int bank = 0;
  while (cycle >= a->start[bank] + c->ii) {
    if (++bank == a->banks) {
      return gen_format("no_bank_has_it"); /* undeclared: the emitter refuses what reads it */
    }
  }
  return source_in(c, axis, v, bank, cycle);
}

void coordinates_declare(const coordinates *c, emit_text *out) {
  for (int axis = 0; axis < AXES; axis++) {
    for (int n = 0; n < 6 * c->axis[axis].banks; n++) {
      if (is_there(c, axis, n % 6, n / 6)) {
        emit_net(out, "reg signed", "W", register_name(axis, n % 6, n / 6).text);
      }
    }
  }
}

/* A register takes its coordinate over from the bank before, or from the input. */
static void load(const coordinates *c, emit_text *out, int axis, int v, int bank) {
  int before = c->axis[axis].start[bank] - 1;
  if (bank > 0) {
    text_printf(out, "%s;\n", source_in(c, axis, v, bank - 1, before).text);
  } else {
    text_printf(out, "in_%s_%c;\n", graph_vertex_name(v), "xyz"[axis]);
  }
}

/* All registers of a bank take their coordinates over, or rotate. */
static void move(const coordinates *c, emit_text *out, int axis, int bank, bool rotate, int depth) {
  for (int v = 0; v < 6; v++) {
    if (is_there(c, axis, v, bank)) {
      text_printf(out, "%*s%s <= ", depth, "", register_name(axis, v, bank).text);
      if (rotate) {
        text_printf(out, "%s;\n", register_name(axis, v / 3 * 3 + (v + 1) % 3, bank).text);
      } else {
        load(c, out, axis, v, bank);
      }
    }
  }
}

void coordinates_clock(const coordinates *c, advance *a, emit_text *out) {
  for (int axis = 0; axis < AXES; axis++) {
    for (int bank = 0; bank < c->axis[axis].banks; bank++) {
      int start = c->axis[axis].start[bank];
      int depth = 4;
      if (a->gated) {
        text_printf(out, "    if (%s) begin\n", advance_name(a, start).text);
        depth += 2;
      }
      if (c->ii > 1) {
        const gen_line slot = advance_slot(a, start, start + c->ii - 1);
        text_printf(out, "%*sif (%s) begin\n", depth, "",
                    a->gated && !a->ahead && bank == 0 ? "last" : slot.text);
        depth += 2;
      }
      move(c, out, axis, bank, false, depth);
      if (c->rotate) {
        text_printf(out, "%*send else begin\n", depth - 2, "");
        move(c, out, axis, bank, true, depth);
      }
      for (depth -= 2; depth >= 4; depth -= 2) {
        text_printf(out, "%*send\n", depth, "");
      }
    }
  }
}
