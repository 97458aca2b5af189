/* SPDX-License-Identifier: MIT */
/* tube_read.c - reads the file that `sepax path --tube` wrote. */
#include "tube.h"

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The file has this much besides what is needed, for rounding; see docs/reference/tube.md. A tenth
 * of it stays here for the rounding of this file and of tube_inside. */
static const double ROUNDING = 1e-10;

/* What is read at present. */
typedef struct {
  tube *t;
  const char *path;
  size_t line;
  char *text;
  int column[2 * TUBE_JOINTS_MOST + 2]; /* of each column of the file: joint * 2, + 1 for off */
  size_t columns;
} reader;

__attribute__((format(printf, 2, 3))) static bool fail(const reader *r, const char *format, ...) {
  char what[TUBE_TEXT / 2];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(what, sizeof what, format, arguments);
  va_end(arguments);
  snprintf(r->text, TUBE_TEXT, "%.200s:%zu: %s", r->path, r->line, what);
  return false;
}

/* The next cell of a line, which ends it; NULL after the last. */
static char *next_cell(char **rest) {
  char *cell = *rest;
  if (cell != NULL) {
    char *comma = strchr(cell, ',');
    *rest = comma != NULL ? comma + 1 : NULL;
    if (comma != NULL) {
      *comma = 0;
    }
  }
  return cell;
}

static bool first_line(reader *r, const char *line) {
  static const char start[] = "# sepax tube 1; clearance ";
  char *end = NULL;
  r->line = 1;
  if (strncmp(line, start, sizeof start - 1) != 0) {
    return fail(r, "is no tube of this version; write it with sepax path --tube=FILE");
  }
  r->t->free_of = strtod(line + sizeof start - 1, &end);
  if (strcmp(end, "; metres and radians\n") != 0) {
    return fail(r, "a clearance in metres is missing");
  }
  return r->t->free_of >= r->t->clearance ||
         fail(r,
              "is free of %g mm only, and the guard keeps %g mm; give sepax path --clearance=%gmm",
              r->t->free_of * 1e3, r->t->clearance * 1e3, r->t->clearance * 1e3);
}

/* The joint that a column belongs to: 2 * joint, or 2 * joint + 1 for "off"; -1: none. */
static int column_of(const tube *t, const char *name) {
  for (size_t n = 0; n < t->joints; n++) {
    const size_t length = strlen(t->name[n]);
    if (strncmp(name, t->name[n], length) == 0 &&
        (name[length] == 0 || strcmp(name + length, " off") == 0)) {
      return (int)n * 2 + (name[length] != 0);
    }
  }
  return -1;
}

/* The name of column n of the file. */
static bool name_read(reader *r, size_t n, const char *name) {
  static const char *const before[] = {"tool", "begins"};
  if (n < 2) {
    return strcmp(name, before[n]) == 0 ||
           fail(r, "column %zu is %.60s, not %s", n + 1, name, before[n]);
  }
  const int column = n < 2 + 2 * (size_t)r->t->joints ? column_of(r->t, name) : -1;
  r->column[n < 2 + 2 * TUBE_JOINTS_MOST ? n : 0] = column;
  return column >= 0 || fail(r, "the joint %.60s is not one of the guard", name);
}

static bool second_line(reader *r, char *line) {
  char *rest = line;
  r->line = 2;
  line[strcspn(line, "\n")] = 0;
  for (char *name = next_cell(&rest); name != NULL; name = next_cell(&rest)) {
    if (!name_read(r, r->columns++, name)) {
      return false;
    }
  }
  for (size_t joint = 0; joint < 2 * (size_t)r->t->joints; joint++) {
    size_t n = 2;
    while (n < r->columns && r->column[n] != (int)joint) {
      n++;
    }
    if (n == r->columns) {
      return fail(r, "the joint %.60s is missing, or its off", r->t->name[joint / 2]);
    }
  }
  return true;
}

static bool number(const reader *r, const char *text, double *value) {
  char *end = NULL;
  *value = strtod(text, &end);
  return (end != text && *end == 0 && isfinite(*value)) || fail(r, "'%.60s' is no number", text);
}

static bool value_of(const reader *r, size_t column, const char *text, double *row) {
  double value = -1;
  if ((column != 0 || *text != 0) && !number(r, text, &value)) {
    return false;
  }
  if (column < 2) {
    row[column] = value;
    return (column == 0 ? value == -1 || value >= 0 : value == 0 || value == 1) ||
           fail(r, "'%.60s' is no tool or no beginning", text);
  }
  const size_t joint = (size_t)r->column[column] / 2;
  const bool off = r->column[column] % 2 != 0;
  if (off && value < 0) {
    return fail(r, "'%.60s' is below 0", text);
  }
  value = off ? fmax(0, value - ROUNDING) : value;
  row[TUBE_FIRST + joint * TUBE_VALUES + (off ? TUBE_OFF : TUBE_END)] = value / r->t->scale[joint];
  return true;
}

static bool row_read(const reader *r, char *line, double *row) {
  char *rest = line;
  size_t n = 0;
  if (strchr(line, '\n') == NULL) {
    return fail(r, "the file ends within the line");
  }
  line[strcspn(line, "\n")] = 0;
  for (char *text = next_cell(&rest); text != NULL; text = next_cell(&rest)) {
    if (n == r->columns || !value_of(r, n++, text, row)) {
      return n < r->columns ? false : fail(r, "there are more values than columns");
    }
  }
  return n == r->columns || fail(r, "there are fewer values than columns");
}

/* ------------------------------------------------------------------ where joints turn back */

static double *value_at(tube *t, uint64_t row, size_t joint) {
  return &t->value[row * tube_stride(t->joints) + TUBE_FIRST + joint * TUBE_VALUES];
}

/* Motions from one turn of a joint to the next have the same least and greatest value. */
static void find_turns(tube *t, size_t joint) {
  uint64_t first = 1;
  while (first < t->rows) {
    double low = value_at(t, first - 1, joint)[TUBE_END];
    double high = low;
    double way = 0;
    uint64_t end = first;
    while (end < t->rows && t->value[end * tube_stride(t->joints) + TUBE_BEGINS] == 0) {
      const double step = value_at(t, end, joint)[TUBE_END] - value_at(t, end - 1, joint)[TUBE_END];
      if (end > first && (way > 0) - (way < 0) != (step > 0) - (step < 0)) {
        break;
      }
      way = step;
      low = fmin(low, value_at(t, end, joint)[TUBE_END]);
      high = fmax(high, value_at(t, end, joint)[TUBE_END]);
      end++;
    }
    for (uint64_t row = first; row < end; row++) {
      value_at(t, row, joint)[TUBE_LOW] = low;
      value_at(t, row, joint)[TUBE_HIGH] = high;
    }
    first = end > first ? end : end + 1;
  }
}

/* ------------------------------------------------------------------ the file */

static bool rows_read(reader *r, FILE *in, char **line, size_t *room) {
  const size_t stride = tube_stride(r->t->joints);
  while (getline(line, room, in) > 0) {
    r->line++;
    if (r->t->rows == r->t->most) {
      return fail(r, "there is room for %llu rows; give loadrt sepax_guard more tube_rows",
                  (unsigned long long)r->t->most);
    }
    if (!row_read(r, *line, &r->t->value[r->t->rows * stride])) {
      return false;
    }
    r->t->rows++;
  }
  return r->t->rows > 0 || fail(r, "there is no row");
}

static bool file_read(reader *r, FILE *in, char **line, size_t *room) {
  if (getline(line, room, in) <= 0 || !first_line(r, *line)) {
    return r->line > 0 ? false : fail(r, "the file is empty");
  }
  if (getline(line, room, in) <= 0) {
    return fail(r, "the names of the joints are missing");
  }
  return second_line(r, *line) && rows_read(r, in, line, room);
}

bool tube_read(tube *t, const char *path, char *text) {
  reader r = {.t = t, .path = path, .text = text};
  char *line = NULL;
  size_t room = 0;
  const uint64_t serial = atomic_load(&t->serial) | 1;
  FILE *in = fopen(path, "r");
  if (in == NULL) {
    snprintf(text, TUBE_TEXT, "%.300s: %s", path, strerror(errno));
    tube_clear(t);
    return false;
  }
  atomic_store(&t->serial, serial); /* odd: the guard does not look at what follows */
  atomic_thread_fence(memory_order_seq_cst);
  t->rows = 0;
  bool good = file_read(&r, in, &line, &room);
  if (good && ferror(in)) {
    good = fail(&r, "cannot be read");
  }
  for (size_t joint = 0; joint < t->joints && good; joint++) {
    find_turns(t, joint);
  }
  t->rows = good ? t->rows : 0;
  atomic_store_explicit(&t->serial, serial + 1, memory_order_release);
  free(line);
  fclose(in);
  return good;
}
