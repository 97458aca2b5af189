/* SPDX-License-Identifier: MIT */
/* parts.c - numbers the parts of a body so that the parts of a piece follow each other. */
#include "parts.h"
#include "body/body.h"
#include "util/memory.h"

#include <math.h>
#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* Set of[n] to the part of triangle n. Parts are numbered in the order of their first triangles. */
static uint32_t number_parts(uint32_t *of, uint32_t *parent, size_t count) {
  uint32_t parts = 0;
  for (uint32_t n = 0; n < count; n++) {
    uint32_t first = set_of(parent, n);
    of[n] = first == n ? parts++ : of[first];
  }
  return parts;
}

/* Set place[k] to the new number of part k, so that the parts of a piece follow each other. `begin`
 * is scratch space. Returns the number of pieces. */
static size_t order_parts(uint32_t *place, uint32_t *begin, uint32_t *piece, uint32_t parts) {
  size_t pieces = 0;
  memset(begin, 0, parts * sizeof *begin);
  for (uint32_t k = 0; k < parts; k++) {
    begin[set_of(piece, k)]++;
  }
  uint32_t sum = 0;
  for (uint32_t k = 0; k < parts; k++) {
    uint32_t size = begin[k];
    begin[k] = sum;
    sum += size;
    pieces += size > 0;
  }
  for (uint32_t k = 0; k < parts; k++) {
    place[k] = begin[set_of(piece, k)]++;
  }
  return pieces;
}

static void grow_box(double box[2][3], const double low[3], const double high[3]) {
  for (int i = 0; i < 3; i++) {
    box[0][i] = low[i] < box[0][i] ? low[i] : box[0][i];
    box[1][i] = high[i] > box[1][i] ? high[i] : box[1][i];
  }
}

static void empty_box(double box[2][3]) {
  for (int i = 0; i < 3; i++) {
    box[0][i] = INFINITY;
    box[1][i] = -INFINITY;
  }
}

static void describe(struct sepax_parts *own, const sepax_body *body, size_t parts,
                     const surface *s) {
  for (size_t k = 0; k < parts; k++) {
    own->part[k].consistent = true;
    own->part[k].open = false;
    empty_box(own->part[k].box);
  }
  for (size_t n = 0; n < body->count; n++) {
    solid_part *part = &own->part[own->of[n]];
    part->consistent = part->consistent && !s->turned[n];
    part->open = part->open || s->open[n];
    memcpy(part->vertex, body->triangle[n][0], sizeof part->vertex);
    for (int k = 0; k < 3; k++) {
      grow_box(part->box, body->triangle[n][k], body->triangle[n][k]);
    }
  }
  empty_box(own->open);
  for (size_t k = 0; k < parts; k++) {
    if (own->part[k].open) {
      grow_box(own->open, own->part[k].box[0], own->part[k].box[1]);
    }
  }
}

/* Find `tangle` of each part. tangle: space for a number of each. */
static void entangle(struct sepax_parts *own, size_t parts, const surface *s, uint32_t *tangle) {
  for (uint32_t k = 0; k < parts; k++) {
    tangle[k] = k;
    memcpy(own->part[k].tangle, own->part[k].box, sizeof own->part[k].box);
  }
  for (uint32_t n = 0; n < s->count && s->entangled != NULL; n++) {
    join(tangle, own->of[n], own->of[set_of(s->entangled, n)]);
  }
  for (uint32_t k = 0; k < parts; k++) { /* the first part of a set stands for it */
    const solid_part *part = &own->part[k];
    grow_box(own->part[set_of(tangle, k)].tangle, part->box[0], part->box[1]);
  }
  for (uint32_t k = 0; k < parts; k++) {
    memcpy(own->part[k].tangle, own->part[set_of(tangle, k)].tangle, sizeof own->part[k].tangle);
  }
}

bool sepax__find_parts(sepax_shell *shell, surface *s) {
  const sepax_body *body = shell->body;
  struct sepax_parts *own = sepax__zeroed(1, sizeof *own);
  shell->own = own;
  if (own == NULL || (own->of = sepax_allocate(body->count * sizeof *own->of)) == NULL) {
    return false;
  }
  uint32_t parts = number_parts(own->of, s->parent, body->count);
  assert(parts > 0);
  uint32_t *piece = sepax_allocate(3 * (size_t)parts * sizeof *piece);
  own->part = sepax_allocate(parts * sizeof *own->part);
  bool ok = piece != NULL && own->part != NULL;
  if (ok) {
    uint32_t *place = piece + parts;
    for (uint32_t k = 0; k < parts; k++) {
      piece[k] = k;
    }
    ok = parts == 1 || sepax__join_pieces(body, own->of, piece, parts);
    shell->parts = parts;
    shell->pieces = order_parts(place, place + parts, piece, parts);
    for (uint32_t k = 0; k < parts; k++) {
      own->part[place[k]].piece = set_of(piece, k);
    }
    for (size_t n = 0; n < body->count; n++) {
      own->of[n] = place[own->of[n]];
    }
    describe(own, body, parts, s);
    entangle(own, parts, s, place);
    own->sheet = s->sheet;
    s->sheet = NULL;
    for (uint32_t n = 0; n < body->count; n++) {
      own->sheet[n] = set_of(own->sheet, n);
    }
  }
  sepax_release(piece);
  return ok;
}

void sepax__free_parts(struct sepax_parts *own) {
  if (own != NULL) {
    sepax_release(own->part);
    sepax_release(own->of);
    sepax_release(own->sheet);
    sepax_release(own);
  }
}
