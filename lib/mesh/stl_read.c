/* SPDX-License-Identifier: MIT */
/* stl_read.c - reads the bytes of STL files, text and binary. */
#include "mesh/stl.h"
#include "util/bytes.h"
#include "util/error.h"
#include "util/list.h"
#include "util/text.h"

#include <inttypes.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

static const char cure[] = "export the mesh again";

/* The path comes first and is cut, so that the cure at the end never is. */
bool sepax__stl_fail(sepax_error *error, sepax_code code, const char *path, const char *format,
                     ...) {
  char detail[200];
  va_list args;
  va_start(args, format);
  vsnprintf(detail, sizeof detail, format, args);
  va_end(args);
  return sepax_fail(error, code, "%.300s: %s", path, detail);
}

const char *sepax__stl_flaw(double number) { return isnan(number) ? "NaN" : "infinite"; }

/* A soup while it is read. */
typedef struct {
  sepax_soup soup;
  size_t capacity, normal_capacity;
  size_t most;
  bool normals;
} reading;

static bool fail_memory(sepax_error *error, const char *path) {
  return sepax__stl_fail(error, SEPAX_ERROR_MEMORY, path,
                         "too large for the memory; use a coarser mesh");
}

static bool fail_most(const reading *r, const char *path, sepax_error *error) {
  return sepax__stl_fail(error, SEPAX_ERROR_LIMIT, path,
                         "more than %zu triangles; simplify the mesh", r->most);
}

static bool append(reading *r, const stl_numbers *n, const char *path, sepax_error *error) {
  sepax_soup *soup = &r->soup;
  if (soup->count >= r->most) {
    return fail_most(r, path, error);
  }
  sepax_facet *facet = list_grow(soup->facet, &r->capacity, soup->count, sizeof *facet);
  soup->facet = facet != NULL ? facet : soup->facet;
  double(*normal)[3] = NULL;
  if (r->normals) {
    normal = list_grow(soup->normal, &r->normal_capacity, soup->count, sizeof *normal);
    soup->normal = normal != NULL ? normal : soup->normal;
  }
  if (facet == NULL || (r->normals && normal == NULL)) {
    return fail_memory(error, path);
  }
  memcpy(facet[soup->count].v, n->of + 3, sizeof facet->v);
  if (r->normals) {
    memcpy(normal[soup->count], n->of, sizeof *normal);
  }
  soup->count++;
  return true;
}

typedef struct {
  const char *bytes; /* followed by a '\0' */
  size_t size;
} content;

/* The length of UTF-8's byte order mark at the beginning, or 0. */
static size_t mark_bytes(const content *file) {
  return file->size >= 3 && memcmp(file->bytes, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
}

/* -------------------------------------------------------------------- text */

typedef struct {
  const char *path;
  const char *at, *end; /* the text that is left */
  size_t line;
  sepax_error *error;
} scanner;

static bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/* A line ends with LF, CR LF or CR. */
static bool ends_line(const char *c) { return *c == '\n' || (*c == '\r' && c[1] != '\n'); }

static void skip_blanks(scanner *text) {
  for (; is_blank(*text->at); text->at++) {
    text->line += ends_line(text->at);
  }
}

static void skip_word(scanner *text) {
  while (text->at < text->end && !is_blank(*text->at)) {
    text->at++;
  }
}

static bool fail_line(const scanner *text, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static bool fail_line(const scanner *text, const char *format, ...) {
  char detail[160];
  va_list args;
  va_start(args, format);
  vsnprintf(detail, sizeof detail, format, args);
  va_end(args);
  return sepax_fail(text->error, SEPAX_ERROR_FORMAT, "%.300s:%zu: %s; %s", text->path, text->line,
                    detail, cure);
}

static bool fail_expecting(const scanner *text, const char *what) {
  if (text->at == text->end) {
    return fail_line(text, "the text ends before %s: truncated", what);
  }
  char found[25] = "";
  const char *c = text->at;
  for (size_t i = 0; c < text->end && !is_blank(*c) && i < sizeof found - 1; i++, c++) {
    found[i] = *c > ' ' && *c <= '~' ? *c : '?';
  }
  return fail_line(text, "'%s' where %s is expected", found, what);
}

static bool word_has(const scanner *text, const char *keyword) {
  const char *c = text->at;
  for (; *keyword != '\0'; keyword++, c++) {
    if ((*c | 0x20) != *keyword) {
      return false;
    }
  }
  return is_blank(*c) || c == text->end;
}

/* The word at hand is the keyword of `length` characters, in capitals or not. Compiled for each
 * keyword by itself, which makes it one comparison of whole numbers for most files. */
static inline bool __attribute__((always_inline))
word_is(const scanner *text, const char *keyword, size_t length) {
  const char *c = text->at;
  return (size_t)(text->end - c) > length && memcmp(c, keyword, length) == 0
             ? is_blank(c[length]) || word_has(text, keyword)
             : word_has(text, keyword);
}

static inline bool __attribute__((always_inline))
read_word(scanner *text, const char *keyword, size_t length) {
  skip_blanks(text);
  if (!word_is(text, keyword, length)) {
    return fail_expecting(text, keyword);
  }
  text->at += length;
  return true;
}

#define WORD_IS(text, keyword) word_is(text, keyword, sizeof(keyword) - 1)
#define READ_KEYWORD(text, keyword) read_word(text, keyword, sizeof(keyword) - 1)

/* Read a number. Words that C reads as numbers, such as nan, are read and then refused. */
static bool read_number(scanner *text, double *number, const char *name) {
  skip_blanks(text);
  const char *end = sepax__decimal(text->at, number);
  if (end == NULL) {
    const char *word = text->at + (*text->at == '-' || *text->at == '+');
    size_t length = strncasecmp(word, "nan", 3) == 0        ? 3
                    : strncasecmp(word, "infinity", 8) == 0 ? 8
                    : strncasecmp(word, "inf", 3) == 0      ? 3
                                                            : 0;
    *number = *word == 'n' || *word == 'N' ? NAN : INFINITY;
    end = length > 0 ? word + length : NULL;
  }
  if (end == NULL || !(is_blank(*end) || end == text->end)) {
    return fail_expecting(text, "a number");
  }
  if (!isfinite(*number)) {
    return fail_line(text, "%s is %s", name, sepax__stl_flaw(*number));
  }
  text->at = end;
  return true;
}

/* Read a normal. If the caller does not ask for normals, then any word is accepted, because many
 * writers have NaN there. */
static bool read_normal(scanner *text, const reading *r, double normal[3]) {
  bool ok = READ_KEYWORD(text, "normal");
  for (int i = 0; i < 3 && ok; i++) {
    if (r->normals) {
      ok = read_number(text, &normal[i], "normal");
      continue;
    }
    skip_blanks(text);
    ok = (text->at < text->end && !WORD_IS(text, "outer")) || fail_expecting(text, "a number");
    skip_word(text);
  }
  return ok;
}

static bool read_facet(scanner *text, const reading *r, stl_numbers *facet) {
  bool ok =
      read_normal(text, r, facet->of) && READ_KEYWORD(text, "outer") && READ_KEYWORD(text, "loop");
  for (int i = 3; ok && i < STL_FACET_NUMBERS; i += 3) {
    ok = READ_KEYWORD(text, "vertex");
    for (int k = 0; ok && k < 3; k++) {
      ok = read_number(text, &facet->of[i + k], "coordinate");
    }
  }
  return ok && READ_KEYWORD(text, "endloop") && READ_KEYWORD(text, "endfacet");
}

/* Skip the name after solid or endsolid. A name may have any words, but not a facet, which would be
 * lost. */
static bool skip_name(scanner *text) {
  while (text->at < text->end && !ends_line(text->at)) {
    if (is_blank(*text->at)) {
      text->at++;
    } else if (WORD_IS(text, "endfacet")) {
      return fail_line(text, "a facet in the line of a solid's name");
    } else {
      skip_word(text);
    }
  }
  return true;
}

static bool read_solid(scanner *text, reading *r) {
  if (!WORD_IS(text, "solid")) {
    return fail_expecting(text, "solid");
  }
  if (!skip_name(text)) {
    return false;
  }
  skip_blanks(text);
  while (WORD_IS(text, "facet")) {
    stl_numbers facet = {{0}};
    text->at += strlen("facet");
    if (!read_facet(text, r, &facet) || !append(r, &facet, text->path, text->error)) {
      return false;
    }
    skip_blanks(text);
  }
  if (!WORD_IS(text, "endsolid")) {
    return fail_expecting(text, "facet or endsolid");
  }
  return skip_name(text);
}

/* True if the text is over. Old systems put zeros or Ctrl-Z behind the end. */
static bool is_over(scanner *text) {
  const char *c = text->at;
  while (c < text->end && (*c == '\0' || *c == 0x1a || is_blank(*c))) {
    c++;
  }
  return c == text->end;
}

static bool read_text(reading *r, const content *file, const char *path, sepax_error *error) {
  scanner text = {.path = path,
                  .at = file->bytes + mark_bytes(file),
                  .end = file->bytes + file->size,
                  .line = 1,
                  .error = error};
  do {
    skip_blanks(&text);
    if (!read_solid(&text, r)) {
      return false;
    }
    skip_blanks(&text);
  } while (!is_over(&text));
  return true;
}

/* ------------------------------------------------------------------ binary */

static uint64_t bytes_announced(const content *file) {
  return STL_HEAD_BYTES + (uint64_t)STL_FACET_BYTES * bytes_get32(file->bytes + STL_TITLE_BYTES);
}

static bool is_binary(const content *file) {
  return file->size >= STL_HEAD_BYTES && file->size == bytes_announced(file);
}

/* Read a record. The normal is checked only if the caller asks for normals. */
static bool read_record(const reading *r, const char *bytes, size_t k, stl_numbers *facet,
                        const char *path, sepax_error *error) {
  for (int i = r->normals ? 0 : 3; i < STL_FACET_NUMBERS; i++) {
    double number = (double)bytes_get_float(bytes + 4 * i);
    if (!isfinite(number)) {
      return sepax__stl_fail(error, SEPAX_ERROR_FORMAT, path, "facet %zu: %s is %s; %s", k,
                             i < 3 ? "normal" : "coordinate", sepax__stl_flaw(number), cure);
    }
    facet->of[i] = number;
  }
  return true;
}

static bool read_binary(reading *r, const content *file, const char *path, sepax_error *error) {
  size_t count = (file->size - STL_HEAD_BYTES) / STL_FACET_BYTES;
  if (count > r->most) {
    return fail_most(r, path, error);
  }
  const char *bytes = file->bytes + STL_HEAD_BYTES;
  r->capacity = r->normal_capacity = count;
  r->soup.facet = sepax_allocate(count * sizeof *r->soup.facet);
  r->soup.normal = r->normals ? sepax_allocate(count * sizeof *r->soup.normal) : NULL;
  if (r->soup.facet == NULL || (r->normals && r->soup.normal == NULL)) {
    return fail_memory(error, path);
  }
  for (size_t k = 0; k < count; k++, bytes += STL_FACET_BYTES) {
    stl_numbers facet = {{0}};
    if (!read_record(r, bytes, k, &facet, path, error) || !append(r, &facet, path, error)) {
      return false;
    }
  }
  return true;
}

/* ------------------------------------------------------- which of the two */

/* True if the file is text. Binary files may also begin with "solid", but their heads contain
 * zeros. */
static bool is_text(const content *file) {
  const char *word = file->bytes + mark_bytes(file);
  while (is_blank(*word)) {
    word++;
  }
  size_t head = file->size < STL_HEAD_BYTES ? file->size : STL_HEAD_BYTES;
  return strncasecmp(word, "solid", 5) == 0 && memchr(file->bytes, 0, head) == NULL;
}

static bool has_text_head(const content *file) {
  for (size_t i = 0; i < STL_HEAD_BYTES; i++) {
    unsigned char c = (unsigned char)file->bytes[i];
    if (c < ' ' && !is_blank((char)c)) {
      return false;
    }
  }
  return true;
}

static bool fail_format(const content *file, const char *path, sepax_error *error) {
  if (file->size == 0) {
    return sepax__stl_fail(error, SEPAX_ERROR_FORMAT, path, "the file is empty; %s", cure);
  }
  if (file->size >= STL_HEAD_BYTES && memcmp(file->bytes, "sepaxSXT", 8) == 0) {
    return sepax__stl_fail(error, SEPAX_ERROR_FORMAT, path,
                           "it is a tree of 'sepax tree', not an STL file; %s",
                           "give the mesh that the tree was made from");
  }
  if (file->size < STL_HEAD_BYTES || has_text_head(file)) {
    return sepax__stl_fail(error, SEPAX_ERROR_FORMAT, path,
                           "not an STL file: it has neither 'solid' nor a binary header; %s",
                           "export the mesh as STL");
  }
  uint32_t count = bytes_get32(file->bytes + STL_TITLE_BYTES);
  uint64_t announced = bytes_announced(file);
  const char *what = file->size < announced ? "truncated" : "longer than its count says";
  return sepax__stl_fail(error, SEPAX_ERROR_FORMAT, path,
                         "%s: %" PRIu32 " facets take %" PRIu64
                         " bytes, the file has %zu (or is not an STL file); %s",
                         what, count, announced, file->size, cure);
}

static bool read_format(reading *r, const content *file, const char *path, sepax_error *error) {
  if (is_binary(file)) {
    return read_binary(r, file, path, error);
  }
  if (is_text(file)) {
    return read_text(r, file, path, error);
  }
  return fail_format(file, path, error);
}

bool sepax__stl_parse(sepax_soup *soup, const char *bytes, size_t size, const char *path,
                      bool normals, size_t most, sepax_error *error) {
  const content file = {bytes, size};
  reading r = {.normals = normals, .most = most};
  *soup = (sepax_soup){0};
  bool ok = read_format(&r, &file, path, error);
  if (ok && r.soup.count == 0) {
    ok = sepax__stl_fail(error, SEPAX_ERROR_FORMAT, path, "no facets; %s", cure);
  }
  if (!ok) {
    sepax_release(r.soup.facet);
    sepax_release(r.soup.normal);
    return false;
  }
  *soup = r.soup;
  return true;
}
