/* SPDX-License-Identifier: MIT */
/* sheets.h - the sheets of a surface, and the closed surfaces that they form (private).
 *
 * Triangles that hang together without a seam are a sheet. A seam is an edge that does not have
 * exactly two triangles, or has two equal ones, or on which another edge lies. The boundary of a
 * sheet is a set of places, modulo 2: a place is a seam or, where edges lie on each other, an end
 * of them. Sheets form a closed surface iff each place is in an even number of their boundaries. */
#ifndef SEPAX_SHEETS_H
#define SEPAX_SHEETS_H

#include "surface.h"
#include "util/hash.h"

/* A place of the boundary of a sheet, or of several sheets that are taken as one. */
typedef struct {
  uint32_t sheet, place;
} border;

typedef struct {
  uint32_t *of;   /* union-find; the sheet of a triangle is its first triangle */
  border *border; /* in the order of sheets, then of places */
  size_t borders;
  uint32_t places;
  bool *joint; /* of each triangle: an edge of it has more than two triangles, or lies on another
                  edge */
} sheets;

/* A word for a number below 2^63, not 0, all bits mixed, so that sums of words tell them apart. */
static inline uint64_t word_of(uint64_t number) {
  uint64_t hash = hash_add(~number, 0);
  return hash_add(hash, hash >> 29);
}

/* Find the sheets of a surface. False without memory; free them in any case. */
bool sepax__find_sheets(const surface *s, sheets *all);
void sepax__free_sheets(sheets *all);

/* Order borders by sheets, then by places, and take out those that are there an even number of
 * times. sheets, places: more than any number. False without memory. */
bool sepax__sort_borders(border *list, size_t *count, uint32_t numbers, uint32_t places);

/* Set word[n] of each sheet so that it has the property: for each set of sheets, the words that it
 * has an odd number of times have the sum 0 modulo 2 if, and nearly surely only if, it has an even
 * number of sheets of each closed surface. list: the borders of all sheets that count; member:
 * which these are. Both change. Parts of one closed surface are joined. tangled: marks sheets of
 * which the closed surfaces are too many to be found. False without memory. */
bool sepax__find_cycles(const surface *s, border *list, size_t count, uint32_t places,
                        uint8_t *member, uint64_t *word, bool *tangled);

#endif
