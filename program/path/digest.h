/* digest.h - the digest of a file in a certificate. (private) */
#ifndef SEPAX_PATH_DIGEST_H
#define SEPAX_PATH_DIGEST_H

#include "sepax.h"

enum { DIGEST_LENGTH = 65 };

/* SHA-256 as 64 hexadecimal digits and a 0. Fails on a file that cannot be read, and always in a
 * build without libmd. */
bool path_digest(char digest[DIGEST_LENGTH], const char *file, sepax_error *error);

/* Fails in a build without libmd. */
bool path_digest_possible(sepax_error *error);

#endif
