/* SPDX-License-Identifier: MIT */
/* sheets.h - finds sheets of a surface that are there more than once, such as both sides of a face.
 *
 * Triangles that hang together by edges of two triangles are a sheet; two equal triangles, of the
 * same vertices, are two. Sheets with the same boundary are copies of each other, however each is
 * divided. An edge that a sheet has twice is no part of its boundary. */
#ifndef CERTIFICATE_SHEETS_H
#define CERTIFICATE_SHEETS_H

#include <stdbool.h>
#include <stddef.h>

typedef struct {
  size_t low, high; /* numbers of vertices, low < high */
  size_t triangle;
  bool forward;
} edge;

/* Of count triangles with the vertices `vertex`, three each, and their `used` edges, sorted by low
 * and high: how many copies of its sheet come before each triangle, and how many its sheet has,
 * itself included. */
void sheets_find(size_t *before, size_t *copies, const edge *edges, size_t used,
                 const size_t *vertex, size_t count);

#endif
