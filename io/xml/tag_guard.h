/* SPDX-License-Identifier: MIT */
/* tag_guard.h - keeps tags from libxml2 that take it long (private).
 *
 * The time of libxml2 grows with the square of the attributes of a tag, and where a document comes
 * in pieces, with that of its length. No document that is read has such tags. */
#ifndef SEPAX_TAG_GUARD_H
#define SEPAX_TAG_GUARD_H

#include <stdbool.h>
#include <stddef.h>

enum { TAG_ATTRIBUTES_MOST = 1000, TAG_BYTES_MOST = 1 << 20 };

/* Zero at the beginning of a document. */
typedef struct {
  int where;
  char quote, last[2];
  size_t length, attributes; /* of the tag */
  size_t offset;             /* of the next byte */
} tag_guard;

/* The next bytes of the document. False: the tag, comment or instruction at g->offset has more
 * attributes or bytes than these. */
bool sepax__tag_guard(tag_guard *g, const char *bytes, size_t size);

#endif
