/* SPDX-License-Identifier: MIT */
/* tool_rows.c - a file of tools as CSV: a header that names columns and their units, then a row for
 * each tool. */
#include "nc/tool_rows.h"
#include "util/error.h"
#include "util/list.h"
#include "util/memory.h"
#include "util/plain_numbers.h"
#include "util/text.h"

#include <limits.h>
#include <math.h>
#include <string.h>

static const size_t bytes_most = (size_t)16 << 20;

enum { COLUMNS_MOST = 32, ROWS_MOST = 10000, SHOWN = 40 };

/* What a column has: numbers and lists of steps have a unit. */
typedef enum { HAS_LENGTH, HAS_ANGLE, HAS_STEPS, HAS_TOOL, HAS_NAME, HAS_KIND } content;

typedef struct {
  const char *name;
  content has;
  int index; /* a tool_number or an nc_tool_part */
} column_kind;

static const column_kind kinds[] = {{"number", HAS_TOOL, 0},
                                    {"name", HAS_NAME, 0},
                                    {"kind", HAS_KIND, 0},
                                    {"diameter", HAS_LENGTH, TOOL_DIAMETER},
                                    {"corner radius", HAS_LENGTH, TOOL_CORNER},
                                    {"tip angle", HAS_ANGLE, TOOL_TIP},
                                    {"taper angle", HAS_ANGLE, TOOL_TAPER},
                                    {"flute length", HAS_LENGTH, TOOL_FLUTE},
                                    {"neck diameter", HAS_LENGTH, TOOL_NECK},
                                    {"usable length", HAS_LENGTH, TOOL_USABLE},
                                    {"shank diameter", HAS_LENGTH, TOOL_SHANK},
                                    {"stick-out", HAS_LENGTH, TOOL_OUT},
                                    {"length", HAS_LENGTH, TOOL_LENGTH},
                                    {"flutes", HAS_STEPS, NC_FLUTES},
                                    {"shank", HAS_STEPS, NC_SHANK},
                                    {"holder", HAS_STEPS, NC_HOLDER}};
enum { KINDS = sizeof kinds / sizeof kinds[0] };

static const struct {
  const char *name;
  double mm;
} units[] = {{"mm", 1}, {"in", 25.4}};

typedef struct {
  const char *at;
  size_t length;
} piece;

typedef struct {
  const column_kind *kind;
  double unit;
} column;

typedef struct {
  nc_tool_rows *rows;
  const char *path;
  size_t line;
  column column[COLUMNS_MOST];
  size_t columns;
} reader;

static const char *const kind_names[NC_TOOL_KINDS] = {"flat",  "ball", "bull",  "drill",
                                                      "taper", "face", "probe", "form"};

const char *nc_tool_kind_name(nc_tool_kind kind) { return kind_names[kind]; }

const char *nc_tool_number_name(tool_number number) {
  size_t n = 0;
  while (kinds[n].has > HAS_ANGLE || kinds[n].index != (int)number) {
    n++;
  }
  return kinds[n].name;
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

static bool no_memory(const reader *r, sepax_error *error) {
  return sepax_fail(error, SEPAX_ERROR_MEMORY, "%.240s:%zu: no memory", r->path, r->line);
}

void nc_tool_row_free(nc_tool_row *row) {
  sepax_release(row->name);
  for (int n = 0; n < NC_TOOL_PARTS; n++) {
    sepax_release(row->steps[n].text);
  }
  *row = (nc_tool_row){0};
}

void nc_tool_rows_free(nc_tool_rows *rows) {
  for (size_t n = 0; n < rows->rows; n++) {
    nc_tool_row_free(&rows->row[n]);
  }
  sepax_release(rows->row);
  *rows = (nc_tool_rows){0};
}

/* ---------------------------------------------------------------------- pieces */

static piece trimmed(piece p) {
  for (; p.length > 0 && p.at[0] == ' '; p.at++) {
    p.length--;
  }
  while (p.length > 0 && p.at[p.length - 1] == ' ') {
    p.length--;
  }
  return p;
}

/* Take what is before the next comma; false after the last cell. */
static bool next_cell(piece *line, piece *cell) {
  if (line->at == NULL) {
    return false;
  }
  const char *comma = line->length > 0 ? memchr(line->at, ',', line->length) : NULL;
  size_t length = comma != NULL ? (size_t)(comma - line->at) : line->length;
  *cell = trimmed((piece){line->at, length});
  line->length -= length + (comma != NULL);
  line->at = comma != NULL ? comma + 1 : NULL;
  return true;
}

static bool is(piece p, const char *word) {
  return strlen(word) == p.length && memcmp(p.at, word, p.length) == 0;
}

static int shown(piece p) { return p.length < SHOWN ? (int)p.length : SHOWN; }

/* ---------------------------------------------------------------------- header */

/* Split "NAME [UNIT]"; a unit without a text is none. */
static piece take_unit(piece *name) {
  piece unit = {name->at, 0};
  const char *open = name->length > 0 ? memchr(name->at, '[', name->length) : NULL;
  if (open != NULL && name->at[name->length - 1] == ']') {
    size_t before = (size_t)(open - name->at);
    unit = trimmed((piece){open + 1, name->length - before - 2});
    *name = trimmed((piece){name->at, before});
  }
  return unit;
}

static bool find_unit(const reader *r, column *c, piece unit, sepax_error *error) {
  const char *name = c->kind->name;
  c->unit = 1;
  if (c->kind->has > HAS_STEPS) {
    return unit.length == 0 ||
           fail(r, error, "column '%s' has no unit; write '%s' alone", name, name);
  }
  if (c->kind->has == HAS_ANGLE) {
    return is(unit, "deg") || fail(r, error, "column '%s': write '%s [deg]'", name, name);
  }
  for (size_t n = 0; n < sizeof units / sizeof units[0]; n++) {
    if (is(unit, units[n].name)) {
      c->unit = units[n].mm;
      return true;
    }
  }
  return fail(r, error, "column '%s': write '%s [mm]' or '%s [in]'", name, name, name);
}

static bool unknown_column(const reader *r, piece name, sepax_error *error) {
  char list[200] = "";
  for (size_t n = 0; n < KINDS; n++) {
    strcat(strcat(list, n > 0 ? ", " : ""), kinds[n].name);
  }
  return fail(r, error, "unknown column '%.*s'; give some of: %s",
              name.length < 20 ? shown(name) : 20, name.at, list);
}

static bool add_column(reader *r, piece name, sepax_error *error) {
  piece unit = take_unit(&name);
  column c = {NULL, 1};
  for (size_t n = 0; n < KINDS && c.kind == NULL; n++) {
    c.kind = is(name, kinds[n].name) ? &kinds[n] : NULL;
  }
  if (c.kind == NULL) {
    return unknown_column(r, name, error);
  }
  for (size_t n = 0; n < r->columns; n++) {
    if (r->column[n].kind == c.kind) {
      return fail(r, error, "two columns '%s'; leave one of them out", c.kind->name);
    }
  }
  r->column[r->columns++] = c;
  return find_unit(r, &r->column[r->columns - 1], unit, error);
}

static bool read_header(reader *r, piece line, sepax_error *error) {
  piece cell;
  while (next_cell(&line, &cell)) {
    if (!add_column(r, cell, error)) {
      return false;
    }
  }
  for (size_t n = 0; n < KINDS; n++) {
    bool there = kinds[n].has != HAS_TOOL && kinds[n].has != HAS_KIND;
    for (size_t k = 0; k < r->columns && !there; k++) {
      there = r->column[k].kind == &kinds[n];
    }
    if (!there) {
      return fail(r, error, "no column '%s'; add it to the first line", kinds[n].name);
    }
  }
  return true;
}

/* ------------------------------------------------------------------------ rows */

static bool read_tool(const reader *r, nc_tool_row *row, piece cell, sepax_error *error) {
  double number = 0;
  if (is(cell, "default")) {
    row->number = -1;
  } else if (sepax__number(cell.at, cell.length, &number) && number >= 1 && number <= INT_MAX &&
             floor(number) == number) {
    row->number = (int)number;
  } else {
    return fail(r, error, "tool '%.*s'; give a whole number from 1, or default", shown(cell),
                cell.at);
  }
  for (size_t n = 0; &r->rows->row[n] != row; n++) {
    if (r->rows->row[n].number == row->number) {
      return fail(r, error, "tool %.*s is in line %zu, too; leave one of them out", shown(cell),
                  cell.at, r->rows->row[n].line);
    }
  }
  return true;
}

static bool read_kind(const reader *r, nc_tool_row *row, piece cell, sepax_error *error) {
  for (int n = 0; n < NC_TOOL_KINDS; n++) {
    if (is(cell, kind_names[n])) {
      row->kind = (nc_tool_kind)n;
      return true;
    }
  }
  return fail(r, error, "kind '%.*s'; give flat, ball, bull, drill, taper, face, probe or form",
              shown(cell), cell.at);
}

static bool copy_text(const reader *r, char **to, piece cell, sepax_error *error) {
  *to = sepax__zeroed(cell.length + 1, 1);
  if (*to == NULL) {
    return no_memory(r, error);
  }
  memcpy(*to, cell.at, cell.length);
  return true;
}

static bool read_number(const reader *r, const column *c, nc_tool_row *row, piece cell,
                        sepax_error *error) {
  double *to = &row->value[c->kind->index];
  if (cell.length == 0) {
    return true;
  }
  if (!sepax__number(cell.at, cell.length, to) || *to < 0) {
    return fail(r, error, "column '%s': '%.*s' is no number of 0 or more; mend it", c->kind->name,
                shown(cell), cell.at);
  }
  *to *= c->unit;
  return *to <= TURNED_SIZE_MOST || fail(r, error, "column '%s': %.*s is too large; mend it",
                                         c->kind->name, shown(cell), cell.at);
}

static bool read_cell(const reader *r, const column *c, nc_tool_row *row, piece cell,
                      sepax_error *error) {
  switch (c->kind->has) {
  case HAS_TOOL:
    return read_tool(r, row, cell, error);
  case HAS_KIND:
    return read_kind(r, row, cell, error);
  case HAS_NAME:
    sepax_release(row->name);
    return copy_text(r, &row->name, cell, error);
  case HAS_STEPS:
    row->steps[c->kind->index].unit = c->unit;
    return cell.length == 0 || copy_text(r, &row->steps[c->kind->index].text, cell, error);
  default:
    return read_number(r, c, row, cell, error);
  }
}

static nc_tool_row *add_row(reader *r, sepax_error *error) {
  nc_tool_row *grown = list_grow(r->rows->row, &r->rows->capacity, r->rows->rows, sizeof *grown);
  if (grown == NULL || r->rows->rows == ROWS_MOST) {
    r->rows->row = grown != NULL ? grown : r->rows->row;
    sepax_fail(error, grown == NULL ? SEPAX_ERROR_MEMORY : SEPAX_ERROR_LIMIT,
               "%.240s:%zu: %s; split the file", r->path, r->line,
               grown == NULL ? "no memory" : "more than 10000 tools");
    return NULL;
  }
  r->rows->row = grown;
  nc_tool_row *row = &grown[r->rows->rows];
  *row = (nc_tool_row){.path = r->path, .line = r->line};
  for (int n = 0; n < TOOL_NUMBERS; n++) {
    row->value[n] = NAN;
  }
  return row;
}

static size_t count_cells(piece line) {
  size_t count = 1;
  for (size_t n = 0; n < line.length; n++) {
    count += line.at[n] == ',';
  }
  return count;
}

static bool read_row(reader *r, piece line, sepax_error *error) {
  nc_tool_row *row = add_row(r, error);
  piece cell;
  if (row == NULL || !copy_text(r, &row->name, (piece){"", 0}, error)) {
    return false; /* a row without a name has nothing to free */
  }
  r->rows->rows++; /* with what was read of it, so that it is freed */
  if (count_cells(line) != r->columns) {
    return fail(r, error, "%zu cells, but the first line has %zu; mend the line%s",
                count_cells(line), r->columns,
                count_cells(line) > r->columns ? " (decimals have a point)" : "");
  }
  bool ok = true;
  for (size_t n = 0; ok && next_cell(&line, &cell); n++) {
    ok = read_cell(r, &r->column[n], row, cell, error);
  }
  return ok;
}

/* Characters of other kinds of tables, which would be read wrongly. */
static bool check_line(const reader *r, piece line, sepax_error *error) {
  static const struct {
    char at;
    const char *cure;
  } strange[] = {{'\t', "a tab; separate cells by commas"},
                 {';', "a semicolon; separate cells by commas, and write decimals with a point"},
                 {'"', "a quotation mark; write cells without them"}};
  for (size_t n = 0; n < sizeof strange / sizeof strange[0]; n++) {
    if (memchr(line.at, strange[n].at, line.length) != NULL) {
      return fail(r, error, "%s", strange[n].cure);
    }
  }
  return true;
}

/* Empty lines, and lines that begin with #, are counted only. */
static bool read_lines(reader *r, piece text, sepax_error *error) {
  while (text.length > 0) {
    const char *end = memchr(text.at, '\n', text.length);
    size_t length = end != NULL ? (size_t)(end - text.at) : text.length;
    piece line = {text.at, length};
    text.at += length + (end != NULL);
    text.length -= length + (end != NULL);
    r->line++;
    line.length -= line.length > 0 && line.at[line.length - 1] == '\r';
    line = trimmed(line);
    if (line.length == 0 || line.at[0] == '#') {
      continue;
    }
    if (!check_line(r, line, error) ||
        !(r->columns == 0 ? read_header : read_row)(r, line, error)) {
      return false;
    }
  }
  return r->rows->rows > 0 ||
         sepax_fail(error, SEPAX_ERROR_FORMAT,
                    "%.240s: no tools in it; the first line names columns, each other one is a "
                    "tool",
                    r->path);
}

bool nc_tool_rows_read(nc_tool_rows *rows, const char *path, sepax_error *error) {
  reader r = {.rows = rows, .path = path};
  text_bytes text;
  size_t begin = 0;
  *rows = (nc_tool_rows){0};
  if (!sepax__text_csv(&text, &begin, path, bytes_most, error)) {
    return false;
  }
  plain_numbers plain = plain_numbers_begin();
  bool ok = read_lines(&r, (piece){text.bytes + begin, text.size - begin}, error);
  plain_numbers_end(plain);
  sepax_release(text.bytes);
  if (!ok) {
    nc_tool_rows_free(rows);
  }
  return ok;
}
