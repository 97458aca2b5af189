/* SPDX-License-Identifier: MIT */
/* pairs.c - pairs of triangles as lines of text. */
#include "util/error.h"
#include "sepax_vectors.h"

#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { VERTEX_FIELDS = 18, FIELDS = 24, TOLD = 4, MOST = FIELDS + TOLD, LINE_BYTES = 4096 };

static const char *const field_names[FIELDS] = {
    "A1x", "A1y", "A1z", "A2x", "A2y", "A2z", "A3x",  "A3y",  "A3z",  "B1x",  "B1y",  "B1z",
    "B2x", "B2y", "B2z", "B3x", "B3y", "B3z", "N_Ax", "N_Ay", "N_Az", "N_Bx", "N_By", "N_Bz"};

/* What a verdict may be, number by number: collision, coplanar, axis, band. */
static const int told_limit[TOLD] = {1, 1, 15, 3};

typedef struct {
  int32_t value[FIELDS];
  int told[TOLD];
} field_values;

static sepax_vec vec_at(const field_values *f, int i) {
  return (sepax_vec){f->value[3 * i], f->value[3 * i + 1], f->value[3 * i + 2]};
}

static sepax_pair to_pair(const field_values *f) {
  return (sepax_pair){.a = {{vec_at(f, 0), vec_at(f, 1), vec_at(f, 2)}},
                      .b = {{vec_at(f, 3), vec_at(f, 4), vec_at(f, 5)}},
                      .na = vec_at(f, 6),
                      .nb = vec_at(f, 7)};
}

static field_values from_pair(const sepax_pair *pair) {
  const sepax_vec vecs[FIELDS / 3] = {pair->a.v[0], pair->a.v[1], pair->a.v[2], pair->b.v[0],
                                      pair->b.v[1], pair->b.v[2], pair->na,     pair->nb};
  field_values f = {{0}, {0}};
  for (int i = 0; i < FIELDS / 3; i++) {
    f.value[3 * i] = vecs[i].x;
    f.value[3 * i + 1] = vecs[i].y;
    f.value[3 * i + 2] = vecs[i].z;
  }
  return f;
}

bool sepax_pair_fits(const sepax_pair *pair, int word) {
  field_values f = from_pair(pair);
  for (int i = 0; i < FIELDS; i++) {
    if (f.value[i] < sepax_word_min(word) || f.value[i] > sepax_word_max(word)) {
      return false;
    }
  }
  return true;
}

/* ------------------------------------------------------------------- reading */

/* A piece of a line for a message: short and printable. */
typedef struct {
  char text[48];
} quote;

static quote quoted(const char *text, size_t length) {
  enum { SHOWN = 40 };
  quote q;
  int used = length > SHOWN ? SHOWN : (int)length;
  snprintf(q.text, sizeof q.text, "%.*s%s", used, text, length > SHOWN ? "..." : "");
  for (char *c = q.text; *c != '\0'; c++) {
    *c = *c < ' ' || *c > '~' ? '?' : *c;
  }
  return q;
}

static bool is_digit(char c) { return '0' <= c && c <= '9'; }

/* Stops at INT64_MAX and INT64_MIN, which fit no word. */
static bool parse_integer(int64_t *value, const char *text, size_t length) {
  bool negative = text[0] == '-';
  size_t start = negative || text[0] == '+';
  *value = 0;
  for (size_t i = start; i < length; i++) {
    if (!is_digit(text[i])) {
      return false;
    }
    int64_t digit = text[i] - '0';
    bool fits = negative ? *value >= (INT64_MIN + digit) / 10 : *value <= (INT64_MAX - digit) / 10;
    int64_t limit = negative ? INT64_MIN : INT64_MAX;
    *value = fits ? *value * 10 + (negative ? -digit : digit) : limit;
  }
  return length > start;
}

static bool parse_field(field_values *f, size_t fields, size_t index, const char *text,
                        size_t length, int word, sepax_error *error) {
  int64_t value;
  if (!parse_integer(&value, text, length)) {
    return sepax_fail(error, SEPAX_ERROR_FORMAT, "number %zu, '%s', is not a decimal integer",
                      index + 1, quoted(text, length).text);
  }
  if (index >= fields) {
    return true;
  }
  if (index >= FIELDS) {
    int limit = told_limit[index - FIELDS];
    f->told[index - FIELDS] = (int)value;
    return (value >= 0 && value <= limit) ||
           sepax_fail(error, SEPAX_ERROR_FORMAT,
                      "number %zu of a verdict, '%s', is not in 0 ... %d", index - FIELDS + 1,
                      quoted(text, length).text, limit);
  }
  int32_t least = sepax_word_min(word);
  int32_t most = sepax_word_max(word);
  if (value < least || value > most) {
    return sepax_fail(error, SEPAX_ERROR_FORMAT,
                      "%s = %s does not fit W = %d (%" PRId32 " ... %" PRId32 ")",
                      field_names[index], quoted(text, length).text, word, least, most);
  }
  f->value[index] = (int32_t)value;
  return true;
}

/* The length of a line without its comment and its end (LF, CR LF or none). */
static size_t content_length(const char *line) {
  size_t end = strcspn(line, "\n");
  end -= end > 0 && line[end - 1] == '\r';
  size_t comment = strcspn(line, "#");
  return comment < end ? comment : end;
}

static bool parse_fields(field_values *f, size_t most, size_t *count, const char *line, int word,
                         sepax_error *error) {
  const char *rest = strchr(line, '\n');
  if (rest != NULL && rest[1] != '\0') {
    return sepax_fail(error, SEPAX_ERROR_FORMAT, "more than one line where one pair is expected");
  }
  size_t end = content_length(line);
  for (size_t at = 0; at < end;) {
    size_t length = strcspn(line + at, " \t");
    length = length < end - at ? length : end - at;
    if (length == 0) {
      at++;
      continue;
    }
    if (!parse_field(f, most, *count, line + at, length, word, error)) {
      return false;
    }
    at += length;
    ++*count;
  }
  return true;
}

static sepax_line parse_told(sepax_pair *pair, sepax_told *told, const char *line, int word,
                             sepax_error *error) {
  field_values f = {{0}, {0}};
  size_t count = 0;
  size_t most = told != NULL ? MOST : FIELDS;
  if (!parse_fields(&f, most, &count, line, word, error)) {
    return SEPAX_LINE_ERROR;
  }
  if (count == 0) {
    return SEPAX_LINE_EMPTY;
  }
  if (count != VERTEX_FIELDS && (count < FIELDS || count > most)) {
    sepax_fail(error, SEPAX_ERROR_FORMAT,
               "%zu number%s where 18 (A1x A1y A1z ... B3z) or 24 (with the normals "
               "N_A, N_B)%s are expected",
               count, count == 1 ? "" : "s",
               told != NULL ? ", or these and the verdict of sepax judge --echo," : "");
    return SEPAX_LINE_ERROR;
  }
  if (told != NULL) {
    told->count = count > FIELDS ? count - FIELDS : 0;
    memcpy(told->value, f.told, sizeof told->value);
  }
  *pair = to_pair(&f);
  if (count == VERTEX_FIELDS) {
    pair->na = sepax_unit_normal(&pair->a, word);
    pair->nb = sepax_unit_normal(&pair->b, word);
  }
  return SEPAX_LINE_PAIR;
}

sepax_line sepax_pair_parse(sepax_pair *pair, const char *line, int word, sepax_error *error) {
  return parse_told(pair, NULL, line, word, error);
}

static sepax_line fail_at(sepax_error *error, const char *name, size_t number, const char *what) {
  sepax_fail(error, SEPAX_ERROR_FORMAT, "%.240s:%zu: %.240s", name, number, what);
  return SEPAX_LINE_ERROR;
}

static sepax_line fail_reading(sepax_error *error, const char *name, size_t number, int code) {
  char reason[128] = "unknown error";
  (void)strerror_r(code, reason, sizeof reason);
  sepax_fail(error, SEPAX_ERROR_FORMAT, "%.240s:%zu: cannot read: %s", name, number, reason);
  return SEPAX_LINE_ERROR;
}

static sepax_line parse_numbered(sepax_pair *pair, sepax_told *told, const char *line,
                                 size_t length, const char *name, size_t number, int word,
                                 sepax_error *error) {
  if (strlen(line) != length) {
    return fail_at(error, name, number, "NUL byte where text is expected");
  }
  sepax_error inner;
  sepax_line kind = parse_told(pair, told, line, word, &inner);
  return kind == SEPAX_LINE_ERROR ? fail_at(error, name, number, inner.text) : kind;
}

/* Read the next line with its end, cut at the size of the buffer. Returns its length, or 0 at the
 * end of the stream. */
static size_t read_line(char line[LINE_BYTES], FILE *in) {
  size_t length = 0;
  int c = 0;
  while (length < LINE_BYTES - 1 && c != '\n' && (c = getc(in)) != EOF) {
    line[length++] = (char)c;
  }
  line[length] = '\0';
  return length;
}

sepax_line sepax_pair_read_told(sepax_pair *pair, sepax_told *told, FILE *in, const char *name,
                                size_t *number, int word, sepax_error *error) {
  char line[LINE_BYTES];
  sepax_line kind = SEPAX_LINE_EMPTY;
  while (kind == SEPAX_LINE_EMPTY) {
    errno = 0;
    size_t length = read_line(line, in);
    if (ferror(in)) {
      return fail_reading(error, name, *number + 1, errno);
    }
    if (length == 0) {
      break;
    }
    ++*number;
    if (length == LINE_BYTES - 1 && line[length - 1] != '\n') {
      return fail_at(error, name, *number,
                     "the line is longer than any pair; give one pair in each line");
    }
    kind = parse_numbered(pair, told, line, length, name, *number, word, error);
  }
  return kind;
}

sepax_line sepax_pair_read(sepax_pair *pair, FILE *in, const char *name, size_t *number, int word,
                           sepax_error *error) {
  return sepax_pair_read_told(pair, NULL, in, name, number, word, error);
}

sepax_told sepax_tell(const sepax_design *design, const sepax_judgement *verdict) {
  sepax_arch arch = design->config.arch;
  bool exact = arch == SEPAX_ARCH_EXACT;
  bool hardware = exact || arch == SEPAX_ARCH_PAPER || arch == SEPAX_ARCH_CONFERENCE;
  return (sepax_told){
      .count = exact      ? (design->limits > 0 ? 4 : 3)
               : hardware ? 2
                          : 1,
      .value = {verdict->collision, verdict->coplanar, verdict->axis, (int)verdict->band}};
}

bool sepax_told_check(const sepax_told *told, const sepax_design *design,
                      const sepax_judgement *verdict, sepax_error *error) {
  static const char *const name[TOLD] = {"collision", "coplanar", "axis", "band"};
  static const char cure[] = "; for a file of another design leave the numbers after the 24th out";
  sepax_told own = sepax_tell(design, verdict);
  if (told->count != 0 && told->count != own.count) {
    return sepax_fail(error, SEPAX_ERROR_FORMAT,
                      "a verdict of %zu numbers, of this design it has %zu%s", told->count,
                      own.count, cure);
  }
  for (size_t i = 0; i < told->count; i++) {
    if (told->value[i] != own.value[i]) {
      return sepax_fail(error, SEPAX_ERROR_FORMAT,
                        "%s is %d, by the golden model of this design %d%s", name[i],
                        told->value[i], own.value[i], cure);
    }
  }
  return true;
}

void sepax_pair_print(FILE *out, const sepax_pair *pair) {
  field_values f = from_pair(pair);
  for (int i = 0; i < FIELDS; i++) {
    fprintf(out, "%s%" PRId32, i > 0 ? " " : "", f.value[i]);
  }
}
