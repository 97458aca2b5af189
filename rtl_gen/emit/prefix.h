/* SPDX-License-Identifier: MIT */
/* prefix.h - the names of a design: what begins with sepax_ or SEPAX_ gets the user's prefix, so
 * that several designs stand in one list of files and in one C program. */
#ifndef SEPAX_EMIT_PREFIX_H
#define SEPAX_EMIT_PREFIX_H

#include "emit/text.h"
#include "sepax_design.h"

#define PREFIX_STANDARD "sepax"
enum { PREFIX_MOST = 24 }; /* characters; the longest name of a module then has 64 */

/* Can it be a prefix? A small letter, then small letters, digits and single underscores, none at
 * the end, at most PREFIX_MOST. Macros have it in capitals, so that two prefixes that differ in
 * their letters' case would clash. sepax_NAME would clash with modules of the standard prefix.
 * False: *error says what to give. */
bool prefix_check(const char *prefix, sepax_error *error);

/* Append the text, with `prefix` in place of sepax where a word begins with sepax_, in capitals
 * where one begins with SEPAX_. Everything else stays, byte by byte. */
void prefix_put(emit_text *out, const char *text, const char *prefix);

#endif
