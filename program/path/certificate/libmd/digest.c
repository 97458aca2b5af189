/* SPDX-License-Identifier: MIT */
/* digest.c - SHA-256 by libmd. */
#include "path/certificate/digest.h"
#include "util/error.h"

#include <errno.h>
#include <stdint.h>
#include <string.h>
#include <sys/types.h>

#include <sha2.h>

bool path_digest(char digest[DIGEST_LENGTH], const char *file, sepax_error *error) {
  return SHA256File(file, digest) != NULL ||
         sepax_fail(error, SEPAX_ERROR_FILE, "%.400s: cannot be read: %s", file, strerror(errno));
}

bool path_digest_possible(sepax_error *error) {
  (void)error;
  return true;
}
