/* stl_read.c - the bytes of STL files, text and binary. */
#include "mesh/stl.h"
#include "util/bytes.h"
#include "util/error.h"
#include "util/list.h"

#include <inttypes.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

static const char cure[] = "export the mesh again";

static bool fail(sepax_error *error, sepax_code code, const char *path, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* The path comes first and is cut, so that the cure at the end never is. */
static bool fail(sepax_error *error, sepax_code code, const char *path, const char *format, ...) {
  char detail[200];
  va_list args;
  va_start(args, format);
  vsnprintf(detail, sizeof detail, format, args);
  va_end(args);
  return sepax_fail(error, code, "%.300s: %s", path, detail);
}

/* The numbers of a facet in the order of the file: its normal, its vertices. */
typedef struct {
  double of[STL_FACET_NUMBERS];
} numbers;

/* A soup that grows. */
typedef struct {
  sepax_soup soup;
  size_t capacity, normal_capacity;
  bool normals;
} reading;

static bool append(reading *r, const numbers *n) {
  sepax_soup *soup = &r->soup;
  sepax_facet *facet = list_grow(soup->facet, &r->capacity, soup->count, sizeof *facet);
  if (facet == NULL) {
    return false;
  }
  soup->facet = facet;
  memcpy(facet[soup->count].v, n->of + 3, sizeof facet->v);
  if (r->normals) {
    double(*normal)[3] = list_grow(soup->normal, &r->normal_capacity, soup->count, sizeof *normal);
    if (normal == NULL) {
      return false;
    }
    soup->normal = normal;
    memcpy(normal[soup->count], n->of, sizeof *normal);
  }
  soup->count++;
  return true;
}

static const char *number_name(int i) { return i < 3 ? "normal" : "coordinate"; }

static const char *flaw(double number) { return isnan(number) ? "NaN" : "infinite"; }

static bool fail_memory(sepax_error *error, const char *path) {
  return fail(error, SEPAX_ERROR_MEMORY, path, "too large for the memory; use a coarser mesh");
}

typedef struct {
  const char *bytes; /* and a '\0' behind them */
  size_t size;
} content;

/* -------------------------------------------------------------------- text */

typedef struct {
  const char *path;
  const char *next, *end; /* what is still to be read */
  const char *word;
  size_t length;
  size_t line; /* of the word */
  sepax_error *error;
} scanner;

static bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/* A line ends with LF, CR LF or CR. */
static bool ends_line(const char *c) { return *c == '\n' || (*c == '\r' && c[1] != '\n'); }

/* False at the end of the text; the word is then empty. */
static bool next_word(scanner *text) {
  for (; text->next < text->end && is_blank(*text->next); text->next++) {
    text->line += ends_line(text->next);
  }
  text->word = text->next;
  while (text->next < text->end && !is_blank(*text->next)) {
    text->next++;
  }
  text->length = (size_t)(text->next - text->word);
  return text->length > 0;
}

static void skip_line(scanner *text) {
  while (text->next < text->end && !ends_line(text->next)) {
    text->next++;
  }
}

static bool word_is(const scanner *text, const char *keyword) {
  return text->length == strlen(keyword) && strncasecmp(text->word, keyword, text->length) == 0;
}

static bool fail_expecting(const scanner *text, const char *what) {
  if (text->length == 0) {
    return fail(text->error, SEPAX_ERROR_FORMAT, text->path,
                "line %zu: the text ends before %s: truncated; %s", text->line, what, cure);
  }
  char found[25] = "";
  for (size_t i = 0; i < text->length && i < sizeof found - 1; i++) {
    char c = text->word[i];
    found[i] = '?';
    if (c > ' ' && c <= '~') {
      found[i] = c;
    }
  }
  return fail(text->error, SEPAX_ERROR_FORMAT, text->path,
              "line %zu: '%s' where %s is expected; %s", text->line, found, what, cure);
}

static bool read_keyword(scanner *text, const char *keyword) {
  next_word(text);
  return word_is(text, keyword) || fail_expecting(text, keyword);
}

static bool read_number(scanner *text, double *number, const char *name) {
  next_word(text);
  char *end = NULL;
  *number = strtod(text->word, &end);
  bool hexadecimal = memchr(text->word, 'x', text->length) != NULL ||
                     memchr(text->word, 'X', text->length) != NULL;
  if (text->length == 0 || end != text->word + text->length || hexadecimal) {
    return fail_expecting(text, "a number");
  }
  if (!isfinite(*number)) {
    return fail(text->error, SEPAX_ERROR_FORMAT, text->path, "line %zu: %s is %s; %s", text->line,
                name, flaw(*number), cure);
  }
  return true;
}

static bool read_facet(scanner *text, numbers *facet) {
  bool ok = read_keyword(text, "normal");
  for (int i = 0; ok && i < STL_FACET_NUMBERS; i++) {
    if (i == 3) {
      ok = read_keyword(text, "outer") && read_keyword(text, "loop");
    }
    if (i >= 3 && i % 3 == 0) {
      ok = ok && read_keyword(text, "vertex");
    }
    ok = ok && read_number(text, &facet->of[i], number_name(i));
  }
  return ok && read_keyword(text, "endloop") && read_keyword(text, "endfacet");
}

static bool read_solid(scanner *text, reading *r) {
  if (!word_is(text, "solid")) {
    return fail_expecting(text, "solid");
  }
  skip_line(text);
  while (next_word(text) && word_is(text, "facet")) {
    numbers facet;
    if (!read_facet(text, &facet)) {
      return false;
    }
    if (!append(r, &facet)) {
      return fail_memory(text->error, text->path);
    }
  }
  if (!word_is(text, "endsolid")) {
    return fail_expecting(text, "facet or endsolid");
  }
  skip_line(text);
  return true;
}

static bool read_text(reading *r, const content *file, const char *path, sepax_error *error) {
  scanner text = {.path = path,
                  .next = file->bytes,
                  .end = file->bytes + file->size,
                  .line = 1,
                  .error = error};
  while (next_word(&text)) {
    if (!read_solid(&text, r)) {
      return false;
    }
  }
  return true;
}

/* ------------------------------------------------------------------ binary */

typedef union {
  uint32_t word;
  float number;
} binary32;

static uint64_t bytes_announced(const content *file) {
  return STL_HEAD_BYTES + (uint64_t)STL_FACET_BYTES * bytes_get32(file->bytes + STL_TITLE_BYTES);
}

static bool is_binary(const content *file) {
  return file->size >= STL_HEAD_BYTES && file->size == bytes_announced(file);
}

static bool read_binary(reading *r, const content *file, const char *path, sepax_error *error) {
  size_t count = (file->size - STL_HEAD_BYTES) / STL_FACET_BYTES;
  const char *bytes = file->bytes + STL_HEAD_BYTES;
  r->capacity = r->normal_capacity = count;
  r->soup.facet = sepax_allocate(count * sizeof *r->soup.facet);
  r->soup.normal = r->normals ? sepax_allocate(count * sizeof *r->soup.normal) : NULL;
  if (r->soup.facet == NULL || (r->normals && r->soup.normal == NULL)) {
    return fail_memory(error, path);
  }
  for (size_t k = 0; k < count; k++, bytes += STL_FACET_BYTES) {
    numbers facet;
    for (int i = 0; i < STL_FACET_NUMBERS; i++) {
      binary32 value = {.word = bytes_get32(bytes + 4 * i)};
      if (!isfinite(value.number)) {
        return fail(error, SEPAX_ERROR_FORMAT, path, "facet %zu: %s is %s; %s", k, number_name(i),
                    flaw(value.number), cure);
      }
      facet.of[i] = value.number;
    }
    append(r, &facet);
  }
  return true;
}

/* ------------------------------------------------------- which of the two */

/* Binary files may also begin with "solid"; but zeros are in the heads of those. */
static bool is_text(const content *file) {
  const char *word = file->bytes;
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
    return fail(error, SEPAX_ERROR_FORMAT, path, "the file is empty; %s", cure);
  }
  if (file->size >= STL_HEAD_BYTES && memcmp(file->bytes, "sepaxSXT", 8) == 0) {
    return fail(error, SEPAX_ERROR_FORMAT, path, "a tree of 'sepax tree', no STL file; %s",
                "give the one that it was made of");
  }
  if (file->size < STL_HEAD_BYTES || has_text_head(file)) {
    return fail(error, SEPAX_ERROR_FORMAT, path,
                "no STL file: neither 'solid' nor a binary header; %s", "export the mesh as STL");
  }
  uint32_t count = bytes_get32(file->bytes + STL_TITLE_BYTES);
  uint64_t announced = bytes_announced(file);
  const char *what = file->size < announced ? "truncated" : "longer than its count says";
  return fail(error, SEPAX_ERROR_FORMAT, path,
              "%s: %" PRIu32 " facets take %" PRIu64
              " bytes, the file has %zu (or is no STL file); %s",
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
                      bool normals, sepax_error *error) {
  const content file = {bytes, size};
  reading r = {.normals = normals};
  *soup = (sepax_soup){0};
  bool ok = read_format(&r, &file, path, error);
  if (ok && r.soup.count == 0) {
    ok = fail(error, SEPAX_ERROR_FORMAT, path, "no facets; %s", cure);
  }
  if (!ok) {
    sepax_release(r.soup.facet);
    sepax_release(r.soup.normal);
    return false;
  }
  *soup = r.soup;
  return true;
}
