/* SPDX-License-Identifier: MIT */
/* digest.c - what a build without libmd has instead of digests: errors. */
#include "path/certificate/digest.h"
#include "util/error.h"

bool path_digest_possible(sepax_error *error) {
  return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                    "certificate: this build writes none, because libmd is missing; install "
                    "libmd-dev and run make");
}

bool path_digest(char digest[DIGEST_LENGTH], const char *file, sepax_error *error) {
  (void)digest;
  (void)file;
  return path_digest_possible(error);
}
