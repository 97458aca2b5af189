/* SPDX-License-Identifier: MIT */
/* pieces.c - compares each two parts whose boxes overlap. */
#include "pieces.h"

#include "report.h"
#include "separation.h"
#include "sets.h"

#include <stdlib.h>

typedef struct {
  size_t part, element; /* numbers */
  surface s;            /* its triangles; box and radius */
  box_tree tree;        /* without boxes: not made yet */
} body;

static int compare_bodies(const void *x, const void *y) {
  const body *a = x;
  const body *b = y;
  if (a->element != b->element)
    return a->element < b->element ? -1 : 1;
  return (a->s.low.x > b->s.low.x) - (a->s.low.x < b->s.low.x);
}

/* Do the boxes overlap along x? b is behind a in the order. */
static bool follows(const body *a, const body *b) {
  return b->element == a->element && b->s.low.x <= a->s.high.x;
}

/* Along y and z. */
static bool boxes_meet(const surface *a, const surface *b) {
  return a->low.y <= b->high.y && b->low.y <= a->high.y && a->low.z <= b->high.z &&
         b->low.z <= a->high.z;
}

static const box_tree *tree_of(body *b) {
  if (b->tree.box == NULL)
    b->tree = boxes_of(&b->s);
  return &b->tree;
}

/* Sorted along x, so that only those are compared whose boxes overlap there. */
static body *bodies_of(const surface *s, const sheets *of) {
  body *all = memory(NULL, of->parts, sizeof *all);
  for (size_t n = 0; n < of->parts; n++)
    all[n] = (body){.part = n, .element = of->part[n].element};
  for (size_t n = 0; n < s->count; n++) {
    surface *to = &all[of->part_of[n]].s;
    GROW(to->triangle, to->count);
    to->triangle[to->count++] = s->triangle[n];
  }
  for (size_t n = 0; n < of->parts; n++)
    surface_finish(&all[n].s);
  qsort(all, of->parts, sizeof *all, compare_bodies);
  return all;
}

size_t *pieces_of(const surface *s, const sheets *of) {
  body *all = bodies_of(s, of);
  size_t *piece = memory(NULL, of->parts, sizeof *piece);
  const motion still = {.column = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, .rounding = 2e-13 * s->radius};
  for (size_t n = 0; n < of->parts; n++)
    piece[n] = n;
  for (size_t n = 0; n < of->parts; n++) {
    body *a = &all[n];
    for (body *b = a + 1; b < all + of->parts && follows(a, b); b++) {
      if (root_of(piece, a->part) != root_of(piece, b->part) && boxes_meet(&a->s, &b->s) &&
          !separated(tree_of(a), tree_of(b), &still, 0))
        unite(piece, a->part, b->part);
    }
  }
  for (size_t n = 0; n < of->parts; n++) {
    piece[n] = root_of(piece, n);
    free(all[n].s.triangle);
    free(all[n].tree.box);
    free(all[n].tree.triangle);
  }
  free(all);
  return piece;
}
