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

static void describe(struct sepax_parts *own, const sepax_body *body, size_t parts,
                     const surface *s) {
  for (size_t k = 0; k < parts; k++) {
    own->part[k].consistent = true;
    own->part[k].open = false;
    own->part[k].tangled = false;
    own->part[k].times = UINT32_MAX;
    for (int i = 0; i < 3; i++) {
      own->part[k].low[i] = INFINITY;
      own->part[k].high[i] = -INFINITY;
    }
  }
  for (size_t n = 0; n < body->count; n++) {
    solid_part *part = &own->part[own->of[n]];
    part->consistent = part->consistent && !s->turned[n];
    part->open = part->open || s->open[n];
    part->tangled = part->tangled || (s->tangled != NULL && s->tangled[n]);
    uint32_t times = s->times != NULL ? s->times[n] : 1;
    if (times != SOLID_MEMBER) {
      part->times = part->times == UINT32_MAX || part->times == times ? times : 0;
    }
    memcpy(part->vertex, body->triangle[n][0], sizeof part->vertex);
    for (int k = 0; k < 9; k++) {
      double x = body->triangle[n][k / 3][k % 3];
      part->low[k % 3] = fmin(part->low[k % 3], x);
      part->high[k % 3] = fmax(part->high[k % 3], x);
    }
  }
  for (int i = 0; i < 3; i++) {
    own->open[0][i] = INFINITY;
    own->open[1][i] = -INFINITY;
    for (size_t k = 0; k < parts; k++) {
      const solid_part *part = &own->part[k];
      own->open[0][i] = fmin(own->open[0][i], part->open ? part->low[i] : INFINITY);
      own->open[1][i] = fmax(own->open[1][i], part->open ? part->high[i] : -INFINITY);
    }
  }
}

/* Take over the words, if there are any. */
static void take_over(struct sepax_parts *own, surface *s) {
  for (size_t n = 0; n < s->count && s->word != NULL; n++) {
    if (s->word[n] != 0) {
      own->word = s->word;
      s->word = NULL;
    }
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
    take_over(own, s);
  }
  sepax_release(piece);
  return ok;
}

void sepax__free_parts(struct sepax_parts *own) {
  if (own != NULL) {
    sepax_release(own->part);
    sepax_release(own->of);
    sepax_release(own->word);
    sepax_release(own);
  }
}
