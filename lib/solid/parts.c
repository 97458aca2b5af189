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
                     const bool *turned, const bool *open, const uint8_t *broken,
                     const uint8_t *copy) {
  for (size_t k = 0; k < parts; k++) {
    own->part[k].consistent = true;
    own->part[k].open = false;
    own->part[k].readings = SOLID_ALL;
    for (int i = 0; i < 3; i++) {
      own->part[k].low[i] = INFINITY;
      own->part[k].high[i] = -INFINITY;
    }
  }
  for (size_t n = 0; n < body->count; n++) {
    solid_part *part = &own->part[own->of[n]];
    part->consistent = part->consistent && !turned[n];
    part->open = part->open || open[n];
    part->readings |= copy[n];
    memcpy(part->vertex, body->triangle[n][0], sizeof part->vertex);
    for (int k = 0; k < 9; k++) {
      double x = body->triangle[n][k / 3][k % 3];
      part->low[k % 3] = fmin(part->low[k % 3], x);
      part->high[k % 3] = fmax(part->high[k % 3], x);
    }
  }
  for (size_t n = 0; n < body->count; n++) {
    solid_part *part = &own->part[own->of[n]];
    part->readings &= (uint8_t) ~(part->open ? SOLID_ONE | SOLID_HALF : broken[n]);
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

bool sepax__find_parts(sepax_shell *shell, uint32_t *parent, const bool *turned, const bool *open,
                       const uint8_t *broken, uint8_t **copy) {
  const sepax_body *body = shell->body;
  struct sepax_parts *own = sepax__zeroed(1, sizeof *own);
  shell->own = own;
  if (own == NULL || (own->of = sepax_allocate(body->count * sizeof *own->of)) == NULL) {
    return false;
  }
  uint32_t parts = number_parts(own->of, parent, body->count);
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
    describe(own, body, parts, turned, open, broken, *copy);
    for (uint32_t k = 0; k < parts && own->copy == NULL; k++) {
      if (own->part[k].readings != SOLID_ALL) {
        own->copy = *copy;
        *copy = NULL;
      }
    }
  }
  sepax_release(piece);
  return ok;
}

void sepax__free_parts(struct sepax_parts *own) {
  if (own != NULL) {
    sepax_release(own->part);
    sepax_release(own->of);
    sepax_release(own->copy);
    sepax_release(own);
  }
}
