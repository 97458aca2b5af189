/* SPDX-License-Identifier: MIT */
/* motion_columns.c - the header of a path as CSV: names of joints and units. */
#include "formats/motion_columns.h"
#include "cli/units.h"
#include "util/error.h"
#include "util/memory.h"
#include "util/text.h"

#include <stdarg.h>
#include <stdio.h>

static const char blanks[] = " \t";

enum { COLUMNS_MOST = SEPAX_ROBOT_LINKS_MOST + COLUMN_DEVIATION };

const char *const column_kind_names[COLUMN_DEVIATION + 1] = {NULL,   "time", "file",  "line",
                                                             "kind", "tool", "break", "deviation"};

bool motion_fail(const motion_reader *r, sepax_error *error, const char *format, ...) {
  char detail[240];
  va_list args;
  va_start(args, format);
  vsnprintf(detail, sizeof detail, format, args);
  va_end(args);
  return sepax_fail(error, SEPAX_ERROR_FORMAT, "%.240s:%zu: %s", r->path, r->line, detail);
}

/* -------------------------------------------------------------------------- pieces */

piece piece_trimmed(piece p) {
  while (p.length > 0 && strchr(blanks, p.at[0]) != NULL) {
    p.at++;
    p.length--;
  }
  while (p.length > 0 && strchr(blanks, p.at[p.length - 1]) != NULL) {
    p.length--;
  }
  return p;
}

/* The next cell of a line; false behind the last. */
bool piece_next_cell(piece *line, piece *cell) {
  if (line->at == NULL) {
    return false;
  }
  const char *comma = memchr(line->at, ',', line->length);
  size_t length = comma != NULL ? (size_t)(comma - line->at) : line->length;
  *cell = piece_trimmed((piece){line->at, length});
  line->length -= length + (comma != NULL);
  line->at = comma != NULL ? comma + 1 : NULL;
  return true;
}

/* -------------------------------------------------------------------------- header */

/* Split "NAME [UNIT]": returns the unit, with at == NULL if there is none. */
static piece take_unit(piece *name) {
  piece u = {NULL, 0};
  size_t open = name->length;
  if (name->length > 2 && name->at[name->length - 1] == ']') {
    while (open > 1 && name->at[open - 1] != '[') {
      open--;
    }
    if (open > 1) {
      u = piece_trimmed((piece){name->at + open, name->length - 1 - open});
      *name = piece_trimmed((piece){name->at, open - 1});
    }
  }
  return u;
}

/* Find a unit in a list. Returns its name as permanent text, or NULL. */
static const char *take_power(column *c, const cli_unit *unit, piece u) {
  while (unit->name != NULL && !piece_is(u, unit->name)) {
    unit++;
  }
  for (int n = unit->power; n < 0; n++) {
    c->by *= 10;
  }
  return unit->name;
}

static const char *take_angle(column *c, piece u) {
  if (piece_is(u, "deg")) {
    c->times = 0x1.921fb54442d18p1;
    c->by = 180;
    return "deg";
  }
  return piece_is(u, "rad") ? "rad" : NULL;
}

typedef enum { NO_QUANTITY, A_TIME, A_LENGTH, AN_ANGLE } quantity;

static quantity quantity_of(const motion_reader *r, const column *c) {
  switch (c->kind) {
  case COLUMN_JOINT:
    return r->m->joint[c->joint].kind == SEPAX_JOINT_PRISMATIC ? A_LENGTH : AN_ANGLE;
  case COLUMN_TIME:
    return A_TIME;
  case COLUMN_DEVIATION:
    return A_LENGTH;
  default:
    return NO_QUANTITY;
  }
}

static bool find_unit(const motion_reader *r, column *c, piece name, piece u, sepax_error *error) {
  static const char *const bare[] = {"", "s", "m", "rad"};
  static const char *const all[] = {"", "s, ms, us, ns", "m, mm, um, nm", "rad, deg"};
  quantity of = quantity_of(r, c);
  c->times = c->by = 1;
  c->bare = u.at == NULL;
  if (c->bare) {
    c->unit = bare[of];
    return true;
  }
  if (of == NO_QUANTITY) {
    return motion_fail(r, error, "column '%.*s' has no unit; leave [%.*s] out", piece_shown(name),
                       name.at, piece_shown(u), u.at);
  }
  c->unit =
      of == AN_ANGLE ? take_angle(c, u) : take_power(c, of == A_TIME ? cli_times : cli_lengths, u);
  return c->unit != NULL || motion_fail(r, error, "column '%.*s': unit [%.*s] is none of: %s",
                                        piece_shown(name), name.at, piece_shown(u), u.at, all[of]);
}

static bool has_any(piece p, const char *characters) {
  for (size_t n = 0; n < p.length; n++) {
    if (strchr(characters, p.at[n]) != NULL) {
      return true;
    }
  }
  return false;
}

static bool fail_name(const motion_reader *r, piece name, sepax_error *error) {
  double number;
  if (name.length == 0) {
    return motion_fail(r, error, "column %zu has no name; give one, or leave the comma out",
                       r->columns + 1);
  }
  return motion_fail(
      r, error, "column '%.*s': there is no joint of this name; %s", piece_shown(name), name.at,
      name.at[0] == '"'                              ? "leave the quotes out"
      : name.at[0] == '#'                            ? "leave comments out"
      : has_any(name, "\r")                          ? "end each line with a line feed"
      : has_any(name, "; \t")                        ? "separate columns by commas"
      : sepax__number(name.at, name.length, &number) ? "the first line must name joints"
                                                     : "mend the name, or leave it out");
}

/* A joint, if there is one of this name; else another kind of column. */
static bool find_kind(const motion_reader *r, piece name, column *c, sepax_error *error) {
  const sepax_mechanism *m = r->m;
  size_t n = 0;
  while (n < m->joints && !piece_is(name, m->joint[n].name)) {
    n++;
  }
  c->kind = piece_is(name, column_kind_names[COLUMN_TIME]) ? COLUMN_TIME : COLUMN_JOINT;
  for (int k = COLUMN_FILE; k <= COLUMN_DEVIATION && n == m->joints; k++) {
    c->kind = piece_is(name, column_kind_names[k]) ? (column_kind)k : c->kind;
  }
  if (c->kind != COLUMN_JOINT) {
    return true;
  }
  if (n == m->joints) {
    return fail_name(r, name, error);
  }
  if (!sepax_joint_driven(&m->joint[n])) {
    return motion_fail(r, error, "column '%.*s': this joint %s; leave the column out",
                       piece_shown(name), name.at,
                       m->joint[n].kind == SEPAX_JOINT_FIXED ? "is fixed" : "follows another one");
  }
  c->joint = n;
  return true;
}

static bool add_column(motion_reader *r, piece name, sepax_error *error) {
  piece u = take_unit(&name);
  column c = {0};
  if (r->columns == COLUMNS_MOST) {
    return motion_fail(r, error, "more than %d columns", COLUMNS_MOST);
  }
  if (!find_kind(r, name, &c, error) || !find_unit(r, &c, name, u, error)) {
    return false;
  }
  for (size_t k = 0; k < r->columns; k++) {
    if (r->column[k].kind == c.kind && r->column[k].joint == c.joint) {
      return motion_fail(r, error, "two columns '%.*s'; leave one of them out", piece_shown(name),
                         name.at);
    }
  }
  r->has_steps = r->has_steps || c.kind > COLUMN_TIME;
  r->column[r->columns++] = c;
  return true;
}

/* Check that each joint with a value of its own has a column. */
static bool has_all(const motion_reader *r, sepax_error *error) {
  bool *there = sepax__zeroed(r->m->joints + 1, sizeof *there);
  if (there == NULL) {
    return motion_fail(r, error, "no memory for its columns");
  }
  for (size_t k = 0; k < r->columns; k++) {
    if (r->column[k].kind == COLUMN_JOINT) {
      there[r->column[k].joint] = true;
    }
  }
  size_t n = 0;
  while (n < r->m->joints && (there[n] || !sepax_joint_driven(&r->m->joint[n]))) {
    n++;
  }
  sepax_release(there);
  return n == r->m->joints || r->rules->hold ||
         motion_fail(r, error,
                     "joint %.60s has no column; add one, or give --hold, which keeps such "
                     "joints at 0",
                     r->m->joint[n].name);
}

bool motion_read_header(motion_reader *r, piece line, sepax_error *error) {
  piece cell;
  r->column = sepax__zeroed(COLUMNS_MOST, sizeof *r->column);
  if (r->column == NULL) {
    return motion_fail(r, error, "no memory for its columns");
  }
  while (piece_next_cell(&line, &cell)) {
    if (!add_column(r, cell, error)) {
      return false;
    }
  }
  return has_all(r, error);
}
