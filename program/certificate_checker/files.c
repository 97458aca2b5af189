/* SPDX-License-Identifier: MIT */
/* files.c - digests by libmd, and counts. */
#include "files.h"

#include "report.h"

#include <math.h>
#include <stdint.h>
#include <string.h>
#include <sys/types.h>

#include <sha2.h>

files files_of(const char *certificate, json_t *list) {
  if (!json_is_array(list))
    cannot("%s: line 1: no files", certificate);
  const size_t count = json_array_size(list);
  files f = {list, memory(NULL, count, sizeof *f.used)};
  for (size_t n = 0; n < count; n++) {
    const json_t *entry = json_array_get(list, n);
    f.used[n] = false;
    if (json_string_value(json_object_get(entry, "file")) == NULL ||
        json_string_value(json_object_get(entry, "sha256")) == NULL ||
        !json_is_integer(json_object_get(entry, "bytes")))
      cannot("%s: line 1: file %zu: no name, digest and length", certificate, n);
  }
  return f;
}

static const char *name_of(const files *f, size_t n) {
  return json_string_value(json_object_get(json_array_get(f->list, n), "file"));
}

/* The first of that name; another one would never be read. */
static size_t place_of(const files *f, const char *as) {
  size_t n = 0;
  while (n < json_array_size(f->list) && strcmp(name_of(f, n), as) != 0)
    n++;
  if (n == json_array_size(f->list))
    cannot("%s: is not among the files of the certificate; certify again", as);
  return n;
}

char *files_read(files *f, const char *name, const char *as, size_t *length) {
  const size_t place = place_of(f, as);
  const json_t *entry = json_array_get(f->list, place);
  char *bytes = file_read(name, length);
  char digest[SHA256_DIGEST_STRING_LENGTH];
  SHA256Data((const uint8_t *)bytes, *length, digest);
  const char *said = json_string_value(json_object_get(entry, "sha256"));
  if (strcmp(digest, said) != 0)
    reject("%s: SHA-256 is %s, not %s as in the certificate: the file has changed", name, digest,
           said);
  f->used[place] = true;
  files_count(f, as, "bytes", (long double)*length);
  return bytes;
}

bool files_has(const files *f, const char *as, const char *what) {
  return json_object_get(json_array_get(f->list, place_of(f, as)), what) != NULL;
}

void files_count(const files *f, const char *as, const char *what, long double count) {
  const json_t *said = json_object_get(json_array_get(f->list, place_of(f, as)), what);
  if (!json_is_number(said))
    reject("%s: the certificate does not say its %s", as, what);
  const long double value = json_is_integer(said) ? (long double)json_integer_value(said)
                                                  : (long double)json_real_value(said);
  if (!(fabsl(value - count) <= 1e-15L * fabsl(count)))
    reject("%s: %s: %.10Lg here, %.10Lg in the certificate", as, what, count, value);
}

void files_text(const files *f, const char *as, const char *what, const char *text) {
  const char *said =
      json_string_value(json_object_get(json_array_get(f->list, place_of(f, as)), what));
  if (said == NULL || strcmp(said, text) != 0)
    reject("%s: %s: %s here, %s in the certificate", as, what, text, said == NULL ? "none" : said);
}

void files_finish(const files *f) {
  for (size_t n = 0; n < json_array_size(f->list); n++) {
    if (!f->used[n])
      reject("%s: the certificate names this file, which the scene does not have", name_of(f, n));
  }
}
