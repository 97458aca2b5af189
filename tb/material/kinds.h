/* SPDX-License-Identifier: MIT */
/* kinds.h - random bodies, kind by kind. */
#ifndef MATERIAL_KINDS_H
#define MATERIAL_KINDS_H

#include "soup.h"

enum { SOLIDS = 32 };

typedef struct {
  soup s;
  /* If the body is known to be the union of convex solids that are wound outwards: these solids,
   * and the first triangle of each. Else there are no solids. */
  soup proof;
  size_t first[SOLIDS + 1];
  size_t solids;
} body;

/* How many kinds there are; the name of one; its number by name, or the count of kinds. */
size_t kinds(void);
const char *kind_name(size_t kind);
size_t kind_of(const char *name);

/* Draw a body. It has at least one triangle. */
void draw_body(body *b, size_t kind, generator *g);

#endif
