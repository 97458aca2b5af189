/* SPDX-License-Identifier: MIT */
/* libraries.c - the message of a build that lacks a library. */
#include "reader/libraries.h"
#include "util/error.h"

static const struct {
  int bit;
  const bool *here;
  const char *name, *package;
} libraries_known[] = {
    {NEEDS_LIBXML2, &sepax__libxml2_here, "libxml2", "libxml2-dev"},
    {NEEDS_LIBZIP, &sepax__libzip_here, "libzip", "libzip-dev"},
};

bool sepax__libraries_here(int libraries, const char *path, const char *format,
                           sepax_error *error) {
  for (size_t n = 0; n < sizeof libraries_known / sizeof libraries_known[0]; n++) {
    if ((libraries & libraries_known[n].bit) != 0 && !*libraries_known[n].here) {
      return sepax_fail(error, SEPAX_ERROR_FORMAT,
                        "%.240s: this build reads no %s, because %s is missing; install %s and "
                        "run make",
                        path, format, libraries_known[n].name, libraries_known[n].package);
    }
  }
  return true;
}
