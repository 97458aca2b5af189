/* SPDX-License-Identifier: MIT */
/* prefix.c - see prefix.h. */
#include "emit/prefix.h"

#include "util/error.h"

#include <ctype.h>
#include <string.h>

static bool is_small(char c) { return c >= 'a' && c <= 'z'; }
static bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool prefix_check(const char *prefix, sepax_error *error) {
  size_t length = strlen(prefix);
  bool fits = length >= 1 && length <= PREFIX_MOST && is_small(prefix[0]);
  for (size_t i = 1; i < length && fits; i++) {
    fits = is_small(prefix[i]) || is_digit(prefix[i]) ||
           (prefix[i] == '_' && prefix[i - 1] != '_' && i + 1 < length);
  }
  if (!fits) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "prefix: '%.40s' does not fit; give a small letter, then small letters, "
                      "digits and single '_', at most %d characters, no '_' at the end",
                      prefix, PREFIX_MOST);
  }
  if (strncmp(prefix, PREFIX_STANDARD "_", sizeof PREFIX_STANDARD) == 0) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "prefix: '%s' could clash with modules of the prefix sepax; give one that "
                      "does not begin with sepax_",
                      prefix);
  }
  return true;
}

static bool is_of_word(char c) { return isalnum((unsigned char)c) || c == '_' || c == '$'; }

void prefix_put(emit_text *out, const char *text, const char *prefix) {
  enum { LENGTH = sizeof PREFIX_STANDARD - 1 };
  const char *kept = text; /* from here on nothing is appended yet */
  for (const char *at = text; *at != '\0'; at++) {
    bool small = strncmp(at, "sepax_", LENGTH + 1) == 0;
    bool capital = strncmp(at, "SEPAX_", LENGTH + 1) == 0;
    if ((!small && !capital) || (at > text && is_of_word(at[-1]))) {
      continue;
    }
    text_put(out, kept, (size_t)(at - kept));
    for (const char *c = prefix; *c != '\0'; c++) {
      text_putc(out, capital ? toupper((unsigned char)*c) : *c);
    }
    kept = at + LENGTH;
  }
  text_puts(out, kept);
}
