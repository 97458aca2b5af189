/* SPDX-License-Identifier: MIT */
/* motion.c - paths as CSV: a header that names joints, then their values, a line each. Columns of
 * steps say more about the motion that ends in a line. */
#include "formats/motion_columns.h"
#include "util/memory.h"
#include "util/error.h"
#include "util/list.h"
#include "util/plain_numbers.h"
#include "util/text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const size_t bytes_most = (size_t)256 << 20;

const char *const format_kind_names[FORMAT_KINDS] = {"move", "rapid", "feed", "probe", "dwell"};

void format_motion_free(format_motion *motion) {
  sepax_release(motion->value);
  sepax_release(motion->time);
  sepax_release(motion->line);
  sepax_release(motion->step);
  for (size_t n = 0; n < motion->names; n++) {
    sepax_release(motion->name[n]);
  }
  sepax_release(motion->name);
  *motion = (format_motion){0};
}

bool format_motion_goes_on(const format_motion *motion, size_t n) {
  return n + 1 < motion->lines && (motion->step == NULL || !motion->step[n + 1].breaks);
}

/* --------------------------------------------------------------------------- lines */

/* The unit in which limits are printed: metres or radians. */
static const char *unit_of(const sepax_joint *joint) {
  return joint->kind == SEPAX_JOINT_PRISMATIC ? "m" : "rad";
}

/* Check the limits of a joint. `at` is its column, whose unit is used in the message, or NULL. */
static bool within_limits(const motion_reader *r, size_t n, const column *at, double value,
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
  return motion_fail(r, error,
                     "%sjoint %.60s: %.9g %s is %s its limit of %.9g %s; mend it, %sor give "
                     "--ignore-limits",
                     where, joint->name, value * scale, name, above ? "above" : "below",
                     (above ? joint->upper : joint->lower) * scale, name,
                     degrees ? "name its unit, [deg], " : "");
}

static bool fail_cell(const motion_reader *r, size_t k, piece cell, const char *cure,
                      sepax_error *error) {
  const column *c = &r->column[k];
  const char *name =
      c->kind == COLUMN_JOINT ? r->m->joint[c->joint].name : column_kind_names[c->kind];
  return motion_fail(r, error, "column %zu (%.60s): '%.*s' is %s", k + 1, name, piece_shown(cell),
                     cell.at, cure);
}

static bool read_value(const motion_reader *r, size_t k, piece cell, double *value,
                       sepax_error *error) {
  const column *c = &r->column[k];
  double number;
  if (!sepax__number(cell.at, cell.length, &number)) {
    return fail_cell(r, k, cell, "no finite number; mend it", error);
  }
  *value = number * c->times / c->by;
  return fabs(*value) <= SEPAX_ROBOT_VALUE_MOST ||
         motion_fail(r, error,
                     "column %zu: %.*s is too large, %g m, rad or s being the most; mend it", k + 1,
                     piece_shown(cell), cell.at, SEPAX_ROBOT_VALUE_MOST);
}

/* --------------------------------------------------------------------------- steps */

/* The number of a name, which is kept once. The last names are looked at first, because most lines
 * have the names of the line before. */
static bool take_name(motion_reader *r, piece cell, size_t *number, sepax_error *error) {
  enum { NAMES_MOST = 10000 };
  format_motion *to = r->motion;
  *number = to->names;
  while (*number > 0) {
    if (piece_is(cell, to->name[--*number])) {
      return true;
    }
  }
  char **name = list_grow(to->name, &r->name_capacity, to->names, sizeof *name);
  char *copy = name != NULL ? sepax_allocate(cell.length + 1) : NULL;
  to->name = name != NULL ? name : to->name;
  if (copy == NULL || to->names == NAMES_MOST) {
    sepax_release(copy);
    return motion_fail(r, error, "no memory for more than %zu files and tools; split the file",
                       to->names);
  }
  memcpy(copy, cell.at, cell.length);
  copy[cell.length] = '\0';
  *number = to->names++;
  to->name[*number] = copy;
  return true;
}

static bool read_kind(const motion_reader *r, size_t k, piece cell, format_kind *kind,
                      sepax_error *error) {
  for (int n = 0; n < FORMAT_KINDS; n++) {
    if (piece_is(cell, format_kind_names[n])) {
      *kind = (format_kind)n;
      return true;
    }
  }
  return fail_cell(r, k, cell, "none of: move, rapid, feed, probe, dwell", error);
}

static bool read_program_line(const motion_reader *r, size_t k, piece cell, size_t *line,
                              sepax_error *error) {
  double number;
  if (!sepax__number(cell.at, cell.length, &number) || !(number >= 0 && number <= 1e9) ||
      number != floor(number)) {
    return fail_cell(r, k, cell, "no number of a line; mend it", error);
  }
  *line = (size_t)number;
  return true;
}

/* Read a cell of a column of steps. An empty cell says nothing. */
static bool read_step(motion_reader *r, size_t k, piece cell, sepax_error *error) {
  format_step *step = &r->motion->step[r->motion->lines - 1];
  if (cell.length == 0) {
    return true;
  }
  switch (r->column[k].kind) {
  case COLUMN_FILE:
    return take_name(r, cell, &step->file, error);
  case COLUMN_LINE:
    return read_program_line(r, k, cell, &step->line, error);
  case COLUMN_KIND:
    return read_kind(r, k, cell, &step->kind, error);
  case COLUMN_TOOL:
    return take_name(r, cell, &step->tool, error);
  case COLUMN_BREAK:
    step->breaks = piece_is(cell, "1");
    return step->breaks || piece_is(cell, "0") ||
           fail_cell(r, k, cell, "neither 1, where the path begins anew, nor 0", error);
  default:
    return read_value(r, k, cell, &step->deviation, error) &&
           (step->deviation >= 0 || fail_cell(r, k, cell, "below 0; mend it", error));
  }
}

/* --------------------------------------------------------------------------- lines */

/* Make space for one more line, with all joints at 0. */
static double *add_line(motion_reader *r) {
  format_motion *to = r->motion;
  size_t joints = r->m->joints > 0 ? r->m->joints : 1;
  double *value = list_grow(to->value, &r->value_capacity, to->lines, joints * sizeof *value);
  to->value = value != NULL ? value : to->value;
  double *time = list_grow(to->time, &r->time_capacity, to->lines, sizeof *time);
  to->time = time != NULL ? time : to->time;
  size_t *line = list_grow(to->line, &r->line_capacity, to->lines, sizeof *line);
  to->line = line != NULL ? line : to->line;
  format_step *step = list_grow(to->step, &r->step_capacity, to->lines, sizeof *step);
  to->step = step != NULL ? step : to->step;
  if (value == NULL || time == NULL || line == NULL || step == NULL ||
      to->lines >= ((size_t)1 << 28) / joints) {
    return NULL;
  }
  double *fresh = &to->value[to->lines * joints];
  memset(fresh, 0, joints * sizeof *fresh);
  to->time[to->lines] = 0;
  to->step[to->lines] = (format_step){.file = FORMAT_NO_NAME, .tool = FORMAT_NO_NAME};
  to->line[to->lines++] = r->line;
  return fresh;
}

static bool check_line(const motion_reader *r, const double *value, sepax_error *error) {
  for (size_t k = 0; k < r->columns; k++) {
    const column *c = &r->column[k];
    if (c->kind == COLUMN_JOINT && !within_limits(r, c->joint, c, value[c->joint], error)) {
      return false;
    }
  }
  for (size_t n = 0; n < r->m->joints; n++) {
    if (r->m->joint[n].kind != SEPAX_JOINT_FIXED && !(fabs(value[n]) <= SEPAX_ROBOT_VALUE_MOST)) {
      return motion_fail(r, error, "joint %.60s: its value is too large; mend it",
                         r->m->joint[n].name);
    }
    if (r->m->joint[n].kind != SEPAX_JOINT_FIXED && !within_limits(r, n, NULL, value[n], error)) {
      return false;
    }
  }
  return true;
}

static bool read_cell(motion_reader *r, size_t k, piece cell, sepax_error *error) {
  format_motion *to = r->motion;
  const column *c = &r->column[k];
  if (c->kind > COLUMN_TIME) {
    return read_step(r, k, cell, error);
  }
  return read_value(r, k, cell,
                    c->kind == COLUMN_TIME ? &to->time[to->lines - 1]
                                           : &to->value[(to->lines - 1) * to->joints + c->joint],
                    error);
}

static bool read_line(motion_reader *r, piece line, sepax_error *error) {
  double *value = add_line(r);
  format_motion *to = r->motion;
  if (value == NULL) {
    return motion_fail(r, error, "no memory for so many lines; split the file");
  }
  size_t cells = 0;
  piece cell;
  for (; piece_next_cell(&line, &cell); cells++) {
    if (cells < r->columns && !read_cell(r, cells, cell, error)) {
      return false;
    }
  }
  if (cells != r->columns) {
    return motion_fail(r, error, "%zu columns, but the header has %zu; mend the line%s", cells,
                       r->columns, cells > r->columns ? " (decimals have a point)" : "");
  }
  if (to->lines > 1 && to->time[to->lines - 1] < to->time[to->lines - 2]) {
    return motion_fail(r, error, "time runs back, from %.9g s to %.9g s; mend it",
                       to->time[to->lines - 2], to->time[to->lines - 1]);
  }
  sepax_mechanism_follow(r->m, value);
  return check_line(r, value, error);
}

/* Read all lines. Empty lines are skipped but counted. */
static bool read_lines(motion_reader *r, piece text, sepax_error *error) {
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
    line = piece_trimmed(line);
    if (line.length > 0 && !(r->column == NULL ? motion_read_header : read_line)(r, line, error)) {
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
  motion_reader r = {.path = path, .m = m, .rules = rules, .motion = motion};
  text_bytes text;
  size_t begin = 0;
  *motion = (format_motion){.joints = m->joints};
  if (!sepax__text_csv(&text, &begin, path, bytes_most, error)) {
    return false;
  }
  plain_numbers plain = plain_numbers_begin();
  bool ok = read_lines(&r, (piece){text.bytes + begin, text.size - begin}, error);
  plain_numbers_end(plain);
  motion->columns = r.columns;
  bool timed = false;
  for (size_t k = 0; k < r.columns; k++) {
    timed = timed || r.column[k].kind == COLUMN_TIME;
  }
  sepax_release(text.bytes);
  sepax_release(r.column);
  if (!ok) {
    format_motion_free(motion);
  } else if (!timed) {
    sepax_release(motion->time);
    motion->time = NULL;
  }
  if (ok && !r.has_steps) {
    sepax_release(motion->step);
    motion->step = NULL;
  }
  return ok;
}
