/* SPDX-License-Identifier: MIT */
/* pieces.c - compares each two parts whose boxes overlap. */
#include "pieces.h"

#include "report.h"
#include "separation.h"

#include <stdlib.h>

typedef struct {
  surface s; /* its triangles; box and radius */
  box_tree tree;
  bool made; /* the tree */
} piece_part;

static size_t root_of(size_t *piece, size_t n) {
  while (piece[n] != n)
    n = piece[n] = piece[piece[n]];
  return n;
}

static bool boxes_meet(const surface *a, const surface *b) {
  return a->low.x <= b->high.x && b->low.x <= a->high.x && a->low.y <= b->high.y &&
         b->low.y <= a->high.y && a->low.z <= b->high.z && b->low.z <= a->high.z;
}

static const box_tree *tree_of(piece_part *p) {
  if (!p->made)
    p->tree = boxes_of(&p->s);
  p->made = true;
  return &p->tree;
}

void pieces_find(size_t *piece, const triangle *t, size_t count, double radius,
                 const size_t *part) {
  piece_part *all = memory(NULL, count, sizeof *all);
  size_t *stands = memory(NULL, count, sizeof *stands);
  size_t parts = 0;
  for (size_t n = 0; n < count; n++) {
    piece[n] = n;
    all[n] = (piece_part){0};
  }
  for (size_t n = 0; n < count; n++) {
    surface *s = &all[part[n]].s;
    if (s->count == 0)
      stands[parts++] = part[n];
    GROW(s->triangle, s->count);
    s->triangle[s->count++] = t[n];
  }
  const motion still = {.column = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, .rounding = 2e-13 * radius};
  for (size_t n = 0; n < parts; n++) {
    piece_part *a = &all[stands[n]];
    surface_finish(&a->s);
    for (size_t k = 0; k < n; k++) {
      piece_part *b = &all[stands[k]];
      const size_t of_a = root_of(piece, stands[n]);
      const size_t of_b = root_of(piece, stands[k]);
      if (of_a != of_b && boxes_meet(&a->s, &b->s) &&
          !separated(tree_of(a), tree_of(b), &still, 0)) {
        piece[of_a] = of_b;
      }
    }
  }
  for (size_t n = 0; n < count; n++)
    piece[n] = root_of(piece, n);
  for (size_t n = 0; n < parts; n++) {
    free(all[stands[n]].s.triangle);
    free(all[stands[n]].tree.box);
    free(all[stands[n]].tree.triangle);
  }
  free(stands);
  free(all);
}
