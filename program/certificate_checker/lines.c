/* SPDX-License-Identifier: MIT */
/* lines.c - JSON, read with jansson line by line. */
#include "lines.h"

#include "report.h"

#include <errno.h>
#include <jansson.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* NULL: no line is left. */
static json_t *next_value(certificate *c) {
  const ssize_t length = getline(&c->line, &c->size, c->in);
  if (length < 0) {
    if (ferror(c->in))
      cannot("%s: cannot be read: %s", c->file, strerror(errno));
    return NULL;
  }
  c->number++;
  json_error_t error;
  json_t *value = json_loadb(c->line, (size_t)length, JSON_REJECT_DUPLICATES, &error);
  if (value == NULL)
    cannot("%s: line %lld: %s", c->file, c->number, error.text);
  return value;
}

static const char *name_of(const certificate *c, const json_t *head, const char *key) {
  const char *text = json_string_value(json_object_get(head, key));
  if (text == NULL || *text == 0)
    cannot("%s: line 1: no %s", c->file, key);
  return text;
}

static void read_pairs(certificate *c, const json_t *all) {
  if (!json_is_array(all))
    cannot("%s: line 1: no pairs", c->file);
  c->pairs = json_array_size(all);
  c->pair = memory(NULL, c->pairs, sizeof *c->pair);
  for (size_t n = 0; n < c->pairs; n++) {
    const json_t *names = json_array_get(all, n);
    for (size_t k = 0; k < 2; k++) {
      c->pair[n][k] = json_string_value(json_array_get(names, k));
      if (c->pair[n][k] == NULL || json_array_size(names) != 2) {
        cannot("%s: line 1: pair %zu", c->file, n);
      }
    }
  }
}

certificate certificate_open(const char *file, packages *folders) {
  certificate c = {.file = file, .in = fopen(file, "r")};
  if (c.in == NULL)
    cannot("%s: cannot be read: %s", file, strerror(errno));
  json_t *head = next_value(&c); /* its texts stay in use */
  if (head == NULL)
    cannot("%s: is empty", file);
  const char *kind = json_string_value(json_object_get(head, "certificate"));
  const json_t *version = json_object_get(head, "version");
  if (kind != NULL && strcmp(kind, "sepax") == 0 && json_integer_value(version) == 1)
    cannot("%s: is a certificate of version 1, without digests; certify again", file);
  if (kind == NULL || strcmp(kind, "sepax") != 0 || json_integer_value(version) != 2)
    cannot("%s: is no certificate of version 2", file);
  c.urdf = name_of(&c, head, "urdf");
  const json_t *srdf = json_object_get(head, "srdf");
  if (srdf != NULL && !json_is_null(srdf))
    c.srdf = name_of(&c, head, "srdf");
  const json_t *rules = json_object_get(head, "rules");
  if (rules != NULL && !json_is_null(rules))
    c.rules = name_of(&c, head, "rules");
  c.path = name_of(&c, head, "path");
  const json_t *clearance = json_object_get(head, "clearance");
  c.clearance = json_number_value(clearance);
  if (!json_is_number(clearance) || !(c.clearance >= 0))
    cannot("%s: line 1: no clearance", file);
  c.files = files_of(file, json_object_get(head, "files"));
  read_pairs(&c, json_object_get(head, "pairs"));
  c.head = head;
  const char *name = NULL;
  json_t *folder = NULL;
  json_object_foreach(json_object_get(head, "packages"), name, folder) {
    if (!json_is_string(folder))
      cannot("%s: line 1: package %s", file, name);
    const char *text = json_string_value(folder);
    GROW(folders->entry, folders->count);
    folders->entry[folders->count++] =
        (package){text_copy(name, strlen(name)), text_copy(text, strlen(text))};
  }
  return c;
}

static uint64_t whole(const certificate *c, const json_t *values, size_t n, uint64_t most) {
  const json_t *value = json_array_get(values, n);
  const json_int_t number = json_integer_value(value);
  if (!json_is_integer(value) || number < 0 || (uint64_t)number > most) {
    cannot("%s: line %lld: value %zu", c->file, c->number, n);
  }
  return (uint64_t)number;
}

static double real(const certificate *c, const json_t *values, size_t n) {
  const json_t *value = json_array_get(values, n);
  if (!json_is_number(value))
    cannot("%s: line %lld: value %zu", c->file, c->number, n);
  return json_number_value(value);
}

static void read_interval(const certificate *c, const json_t *values, certificate_line *line) {
  const size_t size = json_array_size(values);
  if (size != 5 && size != 8)
    cannot("%s: line %lld: %zu values", c->file, c->number, size);
  line->pair = whole(c, values, 0, INT_MAX);
  line->segment = (int)whole(c, values, 1, INT_MAX);
  line->level = (int)whole(c, values, 2, LEVELS);
  line->index = whole(c, values, 3, ((uint64_t)1 << line->level) - 1);
  line->bound = real(c, values, 4);
  if (!(line->bound >= 0))
    cannot("%s: line %lld: value 4", c->file, c->number);
  line->has_axis = size == 8;
  if (line->has_axis) {
    line->axis = (vec){real(c, values, 5), real(c, values, 6), real(c, values, 7)};
    const double length = vec_length(line->axis);
    if (!(length > 1e-100 && length < 1e100))
      cannot("%s: line %lld: axis", c->file, c->number);
  }
  snprintf(line->where, sizeof line->where, "line %lld", c->number);
}

bool certificate_next(certificate *c, certificate_line *line) {
  json_t *value = next_value(c);
  if (value == NULL)
    reject("%s: ends without its number of intervals", c->file);
  if (json_is_array(value)) {
    read_interval(c, value, line);
    json_decref(value);
    c->intervals++;
    return true;
  }
  const json_t *number = json_object_get(value, "intervals");
  if (!json_is_integer(number))
    cannot("%s: line %lld: no interval", c->file, c->number);
  if (json_integer_value(number) != c->intervals) {
    reject("%s: %lld intervals, not %lld", c->file, c->intervals,
           (long long)json_integer_value(number));
  }
  json_decref(value);
  if (next_value(c) != NULL)
    cannot("%s: line %lld: behind the last", c->file, c->number);
  return false;
}
