/* SPDX-License-Identifier: MIT */
/* rules.c - a table of bodies that may meet, as CSV. */
#include "formats/motion_columns.h"
#include "util/error.h"
#include "util/list.h"
#include "util/text.h"

#include <stdio.h>

static const char *const heads[] = {"a", "b", "kind"};
enum { CELLS = 3 };

typedef struct {
  const char *path;
  format_rules *rules;
  size_t line, capacity;
  bool has_header;
} reader;

void format_rules_free(format_rules *rules) {
  for (size_t n = 0; n < rules->count; n++) {
    sepax_release(rules->rule[n].body[0]);
    sepax_release(rules->rule[n].body[1]);
  }
  sepax_release(rules->rule);
  *rules = (format_rules){0};
}

static bool fail(const reader *r, piece cell, const char *what, sepax_error *error) {
  return sepax_fail(error, SEPAX_ERROR_FORMAT, "%.240s:%zu: '%.*s' %s", r->path, r->line,
                    piece_shown(cell), cell.at, what);
}

static char *copy_of(piece p) {
  char *copy = sepax_allocate(p.length + 1);
  if (copy != NULL) {
    memcpy(copy, p.at, p.length);
    copy[p.length] = '\0';
  }
  return copy;
}

static bool take_rule(reader *r, const piece cell[CELLS], sepax_error *error) {
  format_rules *to = r->rules;
  int kind = 0;
  while (kind < FORMAT_KINDS && !piece_is(cell[2], format_kind_names[kind])) {
    kind++;
  }
  if (kind == FORMAT_KINDS) {
    return fail(r, cell[2], "is none of: move, rapid, feed, probe, dwell", error);
  }
  if (cell[0].length == 0 || cell[1].length == 0) {
    return fail(r, cell[2], "needs the names of two links before it", error);
  }
  format_rule *grown = list_grow(to->rule, &r->capacity, to->count, sizeof *grown);
  if (grown == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu rules", to->count);
  }
  to->rule = grown;
  format_rule *rule = &to->rule[to->count++];
  *rule = (format_rule){{copy_of(cell[0]), copy_of(cell[1])}, (format_kind)kind, r->line};
  return (rule->body[0] != NULL && rule->body[1] != NULL) ||
         sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu rules", to->count);
}

static bool take_line(reader *r, piece line, sepax_error *error) {
  piece cell[CELLS];
  piece all = line;
  int cells = 0;
  while (cells < CELLS && piece_next_cell(&line, &cell[cells])) {
    cells++;
  }
  if (cells < CELLS || line.at != NULL) {
    return fail(r, all, "is not: a,b,kind", error);
  }
  if (r->has_header) {
    return take_rule(r, cell, error);
  }
  r->has_header = true;
  for (int n = 0; n < CELLS; n++) {
    if (!piece_is(cell[n], heads[n])) {
      return fail(r, cell[n], "stands in the first line, which must be: a,b,kind", error);
    }
  }
  return true;
}

bool format_rules_read(format_rules *rules, const char *path, sepax_error *error) {
  enum { BYTES_MOST = 1 << 20 };
  reader r = {.path = path, .rules = rules};
  text_bytes text;
  size_t begin = 0;
  *rules = (format_rules){0};
  if (!sepax__text_csv(&text, &begin, path, BYTES_MOST, error)) {
    return false;
  }
  bool ok = true;
  for (piece left = {text.bytes + begin, text.size - begin}; ok && left.length > 0;) {
    const char *end = memchr(left.at, '\n', left.length);
    size_t length = end != NULL ? (size_t)(end - left.at) : left.length;
    piece line = piece_trimmed((piece){left.at, length});
    left.at += length + (end != NULL);
    left.length -= length + (end != NULL);
    r.line++;
    if (line.length > 0 && line.at[line.length - 1] == '\r') {
      line = piece_trimmed((piece){line.at, line.length - 1});
    }
    ok = line.length == 0 || take_line(&r, line, error);
  }
  ok = ok &&
       (rules->count > 0 || sepax_fail(error, SEPAX_ERROR_FORMAT,
                                       "%.300s: has no rule; its first line is: a,b,kind", path));
  sepax_release(text.bytes);
  if (!ok) {
    format_rules_free(rules);
  }
  return ok;
}
