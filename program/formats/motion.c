/* SPDX-License-Identifier: MIT */
/* motion.c - paths as CSV: a header that names joints, then their values, a line each. */
#include "cli/units.h"
#include "formats/formats.h"
#include "util/memory.h"
#include "util/error.h"
#include "util/list.h"
#include "util/plain_numbers.h"
#include "util/text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char blanks[] = " \t";

static const size_t bytes_most = (size_t)256 << 20;

enum { TIME = -1, COLUMNS_MOST = SEPAX_ROBOT_LINKS_MOST + 1 };

typedef struct {
  int joint; /* or TIME */
  const char *unit;
  double times,
      by; /* a value of the file is multiplied by `times` and divided by `by` to get m, rad or s */
  bool bare; /* the header has no unit */
} column;

/* A piece of the text. */
typedef struct {
  const char *at;
  size_t length;
} piece;

typedef struct {
  const char *path;
  const sepax_mechanism *m;
  const format_motion_rules *rules;
  format_motion *motion;
  column *column;
  size_t columns, line; /* number of columns; current line, from 1 */
  size_t value_capacity, time_capacity, line_capacity;
} reader;

void format_motion_free(format_motion *motion) {
  sepax_release(motion->value);
  sepax_release(motion->time);
  sepax_release(motion->line);
  *motion = (format_motion){0};
}

static bool fail(const reader *r, sepax_error *error, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

static bool fail(const reader *r, sepax_error *error, const char *format, ...) {
  char detail[240];
  va_list args;
  va_start(args, format);
  vsnprintf(detail, sizeof detail, format, args);
  va_end(args);
  return sepax_fail(error, SEPAX_ERROR_FORMAT, "%.240s:%zu: %s", r->path, r->line, detail);
}

/* -------------------------------------------------------------------------- pieces */

static piece trimmed(piece p) {
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
static bool next_cell(piece *line, piece *cell) {
  if (line->at == NULL) {
    return false;
  }
  const char *comma = memchr(line->at, ',', line->length);
  size_t length = comma != NULL ? (size_t)(comma - line->at) : line->length;
  *cell = trimmed((piece){line->at, length});
  line->length -= length + (comma != NULL);
  line->at = comma != NULL ? comma + 1 : NULL;
  return true;
}

static bool is(piece p, const char *word) {
  return strlen(word) == p.length && strncmp(p.at, word, p.length) == 0;
}

/* The length of a piece to print in a message. */
static int shown(piece p) { return p.length < 60 ? (int)p.length : 60; }

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
      u = trimmed((piece){name->at + open, name->length - 1 - open});
      *name = trimmed((piece){name->at, open - 1});
    }
  }
  return u;
}

/* Find a unit in a list. Returns its name as permanent text, or NULL. */
static const char *take_power(column *c, const cli_unit *unit, piece u) {
  while (unit->name != NULL && !is(u, unit->name)) {
    unit++;
  }
  for (int n = unit->power; n < 0; n++) {
    c->by *= 10;
  }
  return unit->name;
}

static const char *take_angle(column *c, piece u) {
  if (is(u, "deg")) {
    c->times = 0x1.921fb54442d18p1;
    c->by = 180;
    return "deg";
  }
  return is(u, "rad") ? "rad" : NULL;
}

static bool find_unit(const reader *r, column *c, piece name, piece u, sepax_error *error) {
  bool slides = c->joint != TIME && r->m->joint[c->joint].kind == SEPAX_JOINT_PRISMATIC;
  c->times = c->by = 1;
  c->bare = u.at == NULL;
  if (c->bare) {
    c->unit = c->joint == TIME ? "s" : slides ? "m" : "rad";
    return true;
  }
  c->unit = c->joint == TIME ? take_power(c, cli_times, u)
            : slides         ? take_power(c, cli_lengths, u)
                             : take_angle(c, u);
  return c->unit != NULL || fail(r, error, "column '%.*s': unit [%.*s] is none of: %s", shown(name),
                                 name.at, shown(u), u.at,
                                 c->joint == TIME ? "s, ms, us, ns"
                                 : slides         ? "m, mm, um, nm"
                                                  : "rad, deg");
}

static bool has_any(piece p, const char *characters) {
  for (size_t n = 0; n < p.length; n++) {
    if (strchr(characters, p.at[n]) != NULL) {
      return true;
    }
  }
  return false;
}

static bool fail_name(const reader *r, piece name, sepax_error *error) {
  double number;
  if (name.length == 0) {
    return fail(r, error, "column %zu has no name; give one, or leave the comma out",
                r->columns + 1);
  }
  return fail(r, error, "column '%.*s': there is no joint of this name; %s", shown(name), name.at,
              name.at[0] == '"'                              ? "leave the quotes out"
              : name.at[0] == '#'                            ? "leave comments out"
              : has_any(name, "\r")                          ? "end each line with a line feed"
              : has_any(name, "; \t")                        ? "separate columns by commas"
              : sepax__number(name.at, name.length, &number) ? "the first line must name joints"
                                                             : "mend the name, or leave it out");
}

static bool find_joint(const reader *r, piece name, column *c, sepax_error *error) {
  const sepax_mechanism *m = r->m;
  size_t n = 0;
  while (n < m->joints && !is(name, m->joint[n].name)) {
    n++;
  }
  if (n == m->joints) {
    return fail_name(r, name, error);
  }
  if (!sepax_joint_driven(&m->joint[n])) {
    return fail(r, error, "column '%.*s': this joint %s; leave the column out", shown(name),
                name.at,
                m->joint[n].kind == SEPAX_JOINT_FIXED ? "is fixed" : "follows another one");
  }
  c->joint = (int)n;
  return true;
}

static bool add_column(reader *r, piece name, sepax_error *error) {
  piece u = take_unit(&name);
  column c = {.joint = TIME};
  if (r->columns == COLUMNS_MOST) {
    return fail(r, error, "more than %d columns", COLUMNS_MOST);
  }
  if ((!is(name, "time") && !find_joint(r, name, &c, error)) || !find_unit(r, &c, name, u, error)) {
    return false;
  }
  for (size_t k = 0; k < r->columns; k++) {
    if (r->column[k].joint == c.joint) {
      return fail(r, error, "two columns '%.*s'; leave one of them out", shown(name), name.at);
    }
  }
  r->column[r->columns++] = c;
  return true;
}

/* Check that each joint with a value of its own has a column. */
static bool has_all(const reader *r, sepax_error *error) {
  bool *there = sepax__zeroed(r->m->joints + 1, sizeof *there);
  if (there == NULL) {
    return fail(r, error, "no memory for its columns");
  }
  for (size_t k = 0; k < r->columns; k++) {
    if (r->column[k].joint != TIME) {
      there[r->column[k].joint] = true;
    }
  }
  size_t n = 0;
  while (n < r->m->joints && (there[n] || !sepax_joint_driven(&r->m->joint[n]))) {
    n++;
  }
  sepax_release(there);
  return n == r->m->joints || r->rules->hold ||
         fail(r, error,
              "joint %.60s has no column; add one, or give --hold, which keeps such "
              "joints at 0",
              r->m->joint[n].name);
}

static bool read_header(reader *r, piece line, sepax_error *error) {
  piece cell;
  r->column = sepax__zeroed(COLUMNS_MOST, sizeof *r->column);
  if (r->column == NULL) {
    return fail(r, error, "no memory for its columns");
  }
  while (next_cell(&line, &cell)) {
    if (!add_column(r, cell, error)) {
      return false;
    }
  }
  return has_all(r, error);
}

/* --------------------------------------------------------------------------- lines */

/* The unit in which limits are printed: metres or radians. */
static const char *unit_of(const sepax_joint *joint) {
  return joint->kind == SEPAX_JOINT_PRISMATIC ? "m" : "rad";
}

/* Check the limits of a joint. `at` is its column, whose unit is used in the message, or NULL. */
static bool within_limits(const reader *r, size_t n, const column *at, double value,
                          sepax_error *error) {
  const sepax_joint *joint = &r->m->joint[n];
  if (r->rules->ignore_limits || (value >= joint->lower && value <= joint->upper)) {
    return true;
  }
  char where[32] = "";
  if (at != NULL) {
    snprintf(where, sizeof where, "column %zu, ", (size_t)(at - r->column) + 1);
  }
  bool above = value > joint->upper;
  double scale = at != NULL ? at->by / at->times : 1;
  const char *name = at != NULL ? at->unit : unit_of(joint);
  bool degrees = at != NULL && at->bare && joint->kind != SEPAX_JOINT_PRISMATIC;
  return fail(r, error,
              "%sjoint %.60s: %.9g %s is %s its limit of %.9g %s; mend it, %sor give "
              "--ignore-limits",
              where, joint->name, value * scale, name, above ? "above" : "below",
              (above ? joint->upper : joint->lower) * scale, name,
              degrees ? "name its unit, [deg], " : "");
}

static bool read_value(const reader *r, size_t k, piece cell, double *value, sepax_error *error) {
  const column *c = &r->column[k];
  double number;
  if (!sepax__number(cell.at, cell.length, &number)) {
    return fail(r, error, "column %zu (%.60s): '%.*s' is no finite number; mend it", k + 1,
                c->joint == TIME ? "time" : r->m->joint[c->joint].name, shown(cell), cell.at);
  }
  *value = number * c->times / c->by;
  return fabs(*value) <= SEPAX_ROBOT_VALUE_MOST ||
         fail(r, error, "column %zu: %.*s is too large, %g m, rad or s being the most; mend it",
              k + 1, shown(cell), cell.at, SEPAX_ROBOT_VALUE_MOST);
}

/* Make space for one more line, with all joints at 0. */
static double *add_line(reader *r) {
  format_motion *to = r->motion;
  size_t joints = r->m->joints > 0 ? r->m->joints : 1;
  double *value = list_grow(to->value, &r->value_capacity, to->lines, joints * sizeof *value);
  to->value = value != NULL ? value : to->value;
  double *time = list_grow(to->time, &r->time_capacity, to->lines, sizeof *time);
  to->time = time != NULL ? time : to->time;
  size_t *line = list_grow(to->line, &r->line_capacity, to->lines, sizeof *line);
  to->line = line != NULL ? line : to->line;
  if (value == NULL || time == NULL || line == NULL || to->lines >= ((size_t)1 << 28) / joints) {
    return NULL;
  }
  double *fresh = &to->value[to->lines * joints];
  memset(fresh, 0, joints * sizeof *fresh);
  to->time[to->lines] = 0;
  to->line[to->lines++] = r->line;
  return fresh;
}

static bool check_line(const reader *r, const double *value, sepax_error *error) {
  for (size_t k = 0; k < r->columns; k++) {
    int n = r->column[k].joint;
    if (n != TIME && !within_limits(r, (size_t)n, &r->column[k], value[n], error)) {
      return false;
    }
  }
  for (size_t n = 0; n < r->m->joints; n++) {
    if (r->m->joint[n].kind != SEPAX_JOINT_FIXED && !(fabs(value[n]) <= SEPAX_ROBOT_VALUE_MOST)) {
      return fail(r, error, "joint %.60s: its value is too large; mend it", r->m->joint[n].name);
    }
    if (r->m->joint[n].kind != SEPAX_JOINT_FIXED && !within_limits(r, n, NULL, value[n], error)) {
      return false;
    }
  }
  return true;
}

static bool read_line(reader *r, piece line, sepax_error *error) {
  double *value = add_line(r);
  format_motion *to = r->motion;
  if (value == NULL) {
    return fail(r, error, "no memory for so many lines; split the file");
  }
  size_t cells = 0;
  piece cell;
  while (next_cell(&line, &cell)) {
    double number = 0;
    if (cells < r->columns && !read_value(r, cells, cell, &number, error)) {
      return false;
    }
    if (cells < r->columns) {
      int n = r->column[cells].joint;
      *(n == TIME ? &to->time[to->lines - 1] : &value[n]) = number;
    }
    cells++;
  }
  if (cells != r->columns) {
    return fail(r, error, "%zu columns, but the header has %zu; mend the line%s", cells, r->columns,
                cells > r->columns ? " (decimals have a point)" : "");
  }
  if (to->lines > 1 && to->time[to->lines - 1] < to->time[to->lines - 2]) {
    return fail(r, error, "time runs back, from %.9g s to %.9g s; mend it", to->time[to->lines - 2],
                to->time[to->lines - 1]);
  }
  sepax_mechanism_follow(r->m, value);
  return check_line(r, value, error);
}

/* Read all lines. Empty lines are skipped but counted. */
static bool read_lines(reader *r, piece text, sepax_error *error) {
  while (text.length > 0) {
    const char *end = memchr(text.at, '\n', text.length);
    size_t length = end != NULL ? (size_t)(end - text.at) : text.length;
    piece line = {text.at, length};
    text.at += length + (end != NULL);
    text.length -= length + (end != NULL);
    r->line++;
    if (line.length > 0 && line.at[line.length - 1] == '\r') {
      line.length--;
    }
    line = trimmed(line);
    if (line.length > 0 && !(r->column == NULL ? read_header : read_line)(r, line, error)) {
      return false;
    }
  }
  if (r->motion->lines == 0) {
    return sepax_fail(error, SEPAX_ERROR_FORMAT,
                      "%.300s: no line of values in it; the first line names joints, each other "
                      "one has their values",
                      r->path);
  }
  return true;
}

bool format_motion_read(format_motion *motion, const sepax_mechanism *m,
                        const format_motion_rules *rules, const char *path, sepax_error *error) {
  static const char mark[] = "\xef\xbb\xbf"; /* of UTF-8, as editors put it in front of a file */
  reader r = {.path = path, .m = m, .rules = rules, .motion = motion};
  text_bytes text;
  *motion = (format_motion){.joints = m->joints};
  if (!sepax__text_read(&text, path, bytes_most, error)) {
    return false;
  }
  size_t skip = strncmp(text.bytes, mark, strlen(mark)) == 0 ? strlen(mark) : 0;
  plain_numbers plain = plain_numbers_begin();
  bool ok = memchr(text.bytes, '\0', text.size) == NULL
                ? read_lines(&r, (piece){text.bytes + skip, text.size - skip}, error)
                : sepax_fail(error, SEPAX_ERROR_FORMAT,
                             "%.300s: it has bytes of zero; give CSV as text", path);
  plain_numbers_end(plain);
  motion->columns = r.columns;
  bool timed = false;
  for (size_t k = 0; k < r.columns; k++) {
    timed = timed || r.column[k].joint == TIME;
  }
  sepax_release(text.bytes);
  sepax_release(r.column);
  if (!ok) {
    format_motion_free(motion);
  } else if (!timed) {
    sepax_release(motion->time);
    motion->time = NULL;
  }
  return ok;
}
