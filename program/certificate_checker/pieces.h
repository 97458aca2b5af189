/* SPDX-License-Identifier: MIT */
/* pieces.h - which parts of a collision element may touch or overlap each other. */
#ifndef CERTIFICATE_PIECES_H
#define CERTIFICATE_PIECES_H

#include "sheets.h"

/* Of each part the number of its piece. Two parts of an element have the same piece, unless they
 * are proved to have no point in common, also by way of other parts. The caller frees it. */
size_t *pieces_of(const surface *s, const sheets *of);

#endif
