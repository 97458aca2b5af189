/* SPDX-License-Identifier: MIT */
/* digest.h - the digest of a file in a certificate. (private) */
#ifndef SEPAX_PATH_DIGEST_H
#define SEPAX_PATH_DIGEST_H

#include "sepax.h"

enum { DIGEST_LENGTH = 65 };

/* SHA-256 of a file as 64 hexadecimal digits and a final 0. Fails if the file cannot be read, and
 * always in a build without libmd. */
bool path_digest(char digest[DIGEST_LENGTH], const char *file, sepax_error *error);

/* True if this build has libmd; otherwise it fails. */
bool path_digest_possible(sepax_error *error);

#endif
