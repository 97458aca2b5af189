/* SPDX-License-Identifier: MIT */
/* pieces.c - compares each two parts whose boxes overlap. */
#include "pieces.h"

#include "report.h"
#include "separation.h"
#include "sets.h"

#include <stdlib.h>

typedef struct {
  size_t number; /* of the part */
  size_t element;
  surface s; /* its triangles; box and radius */
  box_tree tree;
  bool has_tree;
} body;

static int compare_bodies(const void *x, const void *y) {
  const body *a = x;
  const body *b = y;
  if (a->element != b->element)
    return a->element < b->element ? -1 : 1;
  return (a->s.low.x > b->s.low.x) - (a->s.low.x < b->s.low.x);
}

static bool boxes_meet(const surface *a, const surface *b) {
  return a->low.y <= b->high.y && b->low.y <= a->high.y && a->low.z <= b->high.z &&
         b->low.z <= a->high.z;
}

static const box_tree *tree_of(body *b) {
  if (!b->has_tree)
    b->tree = boxes_of(&b->s);
  b->has_tree = true;
  return &b->tree;
}

/* Sorted along x, so that only those are compared whose boxes overlap there. */
static body *bodies_of(const surface *s, const sheets *of) {
  body *all = memory(NULL, of->parts, sizeof *all);
  for (size_t n = 0; n < of->parts; n++)
    all[n] = (body){.number = n, .element = of->part[n].element};
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
    for (size_t k = n + 1; k < of->parts && all[k].element == all[n].element &&
                           all[k].s.low.x <= all[n].s.high.x;
         k++) {
      if (root_of(piece, all[n].number) != root_of(piece, all[k].number) &&
          boxes_meet(&all[n].s, &all[k].s) &&
          !separated(tree_of(&all[n]), tree_of(&all[k]), &still, 0))
        unite(piece, all[n].number, all[k].number);
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
