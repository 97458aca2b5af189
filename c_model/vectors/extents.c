/* SPDX-License-Identifier: MIT */
/* extents.c - hard pairs whose AABBs stay within given extents or just exceed them. */
#include "sepax_vectors.h"

enum { TRIES = 8 };

/* Vertices 0, 1, 2 are A's, 3, 4, 5 are B's. */
typedef struct {
  int64_t c[6][3];
} points;

static points points_of(const sepax_pair *pair) {
  points p;
  for (int i = 0; i < 6; i++) {
    const sepax_vec *v = &(i < 3 ? &pair->a : &pair->b)->v[i % 3];
    p.c[i][0] = v->x;
    p.c[i][1] = v->y;
    p.c[i][2] = v->z;
  }
  return p;
}

static sepax_pair pair_of(const points *p) {
  sepax_pair pair = {.na = {0, 0, 0}};
  for (int i = 0; i < 6; i++) {
    const int64_t *c = p->c[i];
    (i < 3 ? &pair.a : &pair.b)->v[i % 3] =
        (sepax_vec){(int32_t)c[0], (int32_t)c[1], (int32_t)c[2]};
  }
  return pair;
}

/* The lowest and the highest coordinate of vertices first ... end - 1. */
static void bounds(const points *p, int first, int end, int axis, int64_t *low, int64_t *high) {
  *low = p->c[first][axis];
  *high = *low;
  for (int i = first + 1; i < end; i++) {
    int64_t c = p->c[i][axis];
    *low = c < *low ? c : *low;
    *high = c > *high ? c : *high;
  }
}

static bool within(const points *p, const int extent[2]) {
  bool ok = true;
  for (int k = 0; k < 6; k++) {
    int64_t low;
    int64_t high;
    bounds(p, k / 3 * 3, k / 3 * 3 + 3, k % 3, &low, &high);
    ok = ok && high - low <= extent[k / 3];
  }
  return ok;
}

/* If a side exceeds its extent, then take its coordinates modulo extent + 1, counted from the
 * lowest. */
static void fold(points *p, const int extent[2]) {
  for (int k = 0; k < 6; k++) {
    int64_t low;
    int64_t high;
    int first = k / 3 * 3;
    bounds(p, first, first + 3, k % 3, &low, &high);
    for (int i = first; i < first + 3; i++) {
      p->c[i][k % 3] = low + (p->c[i][k % 3] - low) % (extent[k / 3] + 1);
    }
  }
}

/* Move the highest vertex of a triangle along an axis until its AABB is `side` long, if all
 * vertices then span at most `range`. The AABB only grows. */
static void stretch(points *p, int triangle, int axis, int64_t side, int64_t range) {
  int64_t low;
  int64_t high;
  int64_t all_low;
  int64_t all_high;
  int first = 3 * triangle;
  bounds(p, first, first + 3, axis, &low, &high);
  bounds(p, 0, 6, axis, &all_low, &all_high);
  if (low + side < high || low + side - all_low > range) {
    return;
  }
  for (int i = first; i < first + 3; i++) {
    if (p->c[i][axis] == high) {
      p->c[i][axis] = low + side;
      return;
    }
  }
}

static int bits_of(int64_t value) {
  int bits = SEPAX_WORD_MIN;
  while (value >> bits != 0) {
    bits++;
  }
  return bits;
}

static points draw_within(size_t family, int word, const int extent[2], sepax_random *random) {
  points p = {{{0}}};
  int longest = bits_of(extent[0] > extent[1] ? extent[0] : extent[1]);
  int most = longest < word ? longest : word;
  bool ok = false;
  for (int n = 0; n < TRIES && !ok; n++) {
    int bits = (int)sepax_random_range(random, SEPAX_WORD_MIN, most);
    sepax_pair pair = sepax_family_triangles(family, bits, random);
    p = points_of(&pair);
    ok = within(&p, extent);
  }
  if (!ok) {
    fold(&p, extent);
  }
  return p;
}

/* Translate the pair to anywhere in the word, now and then to its very end. */
static void translate_anywhere(points *p, int word, sepax_random *random) {
  for (int axis = 0; axis < 3; axis++) {
    int64_t low;
    int64_t high;
    bounds(p, 0, 6, axis, &low, &high);
    int64_t from = sepax_word_min(word) - low;
    int64_t to = sepax_word_max(word) - high;
    int64_t choice = sepax_random_range(random, 0, 7);
    int64_t any = sepax_random_range(random, from, to);
    int64_t shift = choice == 0 ? from : choice == 1 ? to : any;
    for (int i = 0; i < 6; i++) {
      p->c[i][axis] += shift;
    }
  }
}

sepax_pair sepax_extent_pair(size_t family, int word, const int extent[2], bool exceeds,
                             sepax_random *random) {
  points p = draw_within(family, word, extent, random);
  int64_t range = (INT64_C(1) << word) - 1;
  int triangle = (int)sepax_random_range(random, 0, 1);
  int axis = (int)sepax_random_range(random, 0, 2);
  int64_t choice = sepax_random_range(random, 0, 3);
  int64_t more = sepax_random_range(random, 1, range);
  if (exceeds) {
    int64_t side = extent[triangle] + (more >> sepax_random_range(random, 0, word - 1));
    stretch(&p, triangle, axis, extent[triangle] + 1, range);
    stretch(&p, triangle, axis, side, range);
  } else if (choice == 0) {
    stretch(&p, triangle, axis, extent[triangle], range);
  }
  translate_anywhere(&p, word, random);
  return pair_of(&p);
}
