/* SPDX-License-Identifier: MIT */
/* lines.h - the edges of a soup, line by line, cut into elementary segments at all their ends. */
#ifndef MATERIAL_LINES_H
#define MATERIAL_LINES_H

#include "soup.h"

/* An edge of a triangle between two different points. */
typedef struct {
  point direction; /* of its line: no common factor, the first number that is not 0 is positive */
  axis moment;     /* end x direction: the same for all points of the line */
  point end[2];    /* in the direction of the line */
  int64_t at[2];   /* the places of the ends on the line: end * direction */
  int sign;        /* 1 if the triangle runs in the direction of the line, else -1 */
  size_t of;       /* the triangle */
} edge;

typedef struct {
  edge *edge;
  size_t edges;
  int64_t *cut; /* the places of all ends, in order, each once */
  point *where; /* the same as points */
  size_t cuts;
} line;

/* Call `each` with every line on which edges lie. The line's memory is gone afterwards. */
void for_each_line(const soup *s, void (*each)(void *context, const line *l), void *context);

#endif
