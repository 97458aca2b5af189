/* SPDX-License-Identifier: MIT */
/* motion_columns.h - the columns of a path as CSV, and cells of CSV (private to this folder). */
#ifndef SEPAX_FORMATS_MOTION_COLUMNS_H
#define SEPAX_FORMATS_MOTION_COLUMNS_H

#include "formats/formats.h"

#include <string.h>

typedef enum {
  COLUMN_JOINT,
  COLUMN_TIME,
  /* of steps: */
  COLUMN_FILE,
  COLUMN_LINE,
  COLUMN_KIND,
  COLUMN_TOOL,
  COLUMN_BREAK,
  COLUMN_DEVIATION
} column_kind;

/* Names of the kinds except for joints, which have names of their own. */
extern const char *const column_kind_names[COLUMN_DEVIATION + 1];

typedef struct {
  column_kind kind;
  size_t joint;
  const char *unit;
  double times, by; /* a value of the file is multiplied by `times` and divided by `by` to get m,
                       rad or s */
  bool bare;        /* the header has no unit */
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
  bool has_steps;       /* a column says more about motions */
  size_t value_capacity, time_capacity, line_capacity, step_capacity, name_capacity;
} motion_reader;

/* Fail with the file, the current line and a text. */
bool motion_fail(const motion_reader *r, sepax_error *error, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Read the header. */
bool motion_read_header(motion_reader *r, piece line, sepax_error *error);

static inline bool piece_is(piece p, const char *word) {
  return strlen(word) == p.length && strncmp(p.at, word, p.length) == 0;
}

/* The length of a piece to print in a message. */
static inline int piece_shown(piece p) { return p.length < 60 ? (int)p.length : 60; }

/* The piece without blanks at its ends. */
piece piece_trimmed(piece p);

/* The next cell of a line; false behind the last. */
bool piece_next_cell(piece *line, piece *cell);

#endif
