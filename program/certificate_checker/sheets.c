/* SPDX-License-Identifier: MIT */
/* sheets.c - sorts the boundaries of sheets, and compares neighbours. */
#include "sheets.h"

#include "report.h"

#include <stdint.h>
#include <stdlib.h>

/* An edge between sheets, at one of them. */
typedef struct {
  size_t sheet, low, high;
} seam;

typedef struct {
  const seam *at; /* sorted */
  size_t count, sheet;
} boundary;

static int compare_sizes(size_t a, size_t b) { return (a > b) - (a < b); }

static int compare_ends(const seam *a, const seam *b) {
  const int order = compare_sizes(a->low, b->low);
  return order != 0 ? order : compare_sizes(a->high, b->high);
}

static int compare_seams(const void *x, const void *y) {
  const seam *a = x;
  const seam *b = y;
  return a->sheet != b->sheet ? compare_sizes(a->sheet, b->sheet) : compare_ends(a, b);
}

static int compare_lines(const boundary *a, const boundary *b) {
  int order = compare_sizes(a->count, b->count);
  for (size_t n = 0; n < a->count && order == 0; n++)
    order = compare_ends(&a->at[n], &b->at[n]);
  return order;
}

static int compare_boundaries(const void *x, const void *y) {
  const boundary *a = x;
  const boundary *b = y;
  const int order = compare_lines(a, b);
  return order != 0 ? order : compare_sizes(a->sheet, b->sheet);
}

static size_t root_of(size_t *sheet, size_t n) {
  while (sheet[n] != n)
    n = sheet[n] = sheet[sheet[n]];
  return n;
}

/* The third vertex of the edge's triangle; SIZE_MAX: there is none. */
static size_t third(const edge *e, const size_t *vertex) {
  const size_t *v = &vertex[3 * e->triangle];
  for (int k = 0; k < 3; k++) {
    if (v[k] != e->low && v[k] != e->high)
      return v[k];
  }
  return SIZE_MAX;
}

/* Join the triangles of the edge that begins at e[0], or add it to the seams. Returns how many
 * entries it has. */
static size_t edge_join(size_t *sheet, seam *seams, size_t *count, const edge *e, size_t left,
                        const size_t *vertex) {
  size_t n = 1;
  while (n < left && e[n].low == e->low && e[n].high == e->high)
    n++;
  const bool pair = n == 2 && third(&e[0], vertex) != third(&e[1], vertex);
  if (pair)
    sheet[root_of(sheet, e[0].triangle)] = root_of(sheet, e[1].triangle);
  for (size_t k = 0; k < n && n > 1 && !pair; k++)
    seams[(*count)++] = (seam){e[k].triangle, e[k].low, e[k].high};
  return n;
}

/* The seams that a sheet has an odd number of times. */
static size_t sort_seams(seam *seams, size_t count, size_t *sheet) {
  for (size_t n = 0; n < count; n++)
    seams[n].sheet = root_of(sheet, seams[n].sheet);
  qsort(seams, count, sizeof *seams, compare_seams);
  size_t kept = 0;
  for (size_t n = 0; n < count; n++) {
    if (kept > 0 && compare_seams(&seams[kept - 1], &seams[n]) == 0)
      kept--;
    else
      seams[kept++] = seams[n];
  }
  return kept;
}

void sheets_find(size_t *before, size_t *copies, const edge *edges, size_t used,
                 const size_t *vertex, size_t count) {
  size_t *sheet = memory(NULL, count, sizeof *sheet);
  seam *seams = memory(NULL, used, sizeof *seams);
  boundary *all = memory(NULL, count, sizeof *all);
  size_t seam_count = 0;
  size_t sheets = 0;
  for (size_t n = 0; n < count; n++) {
    sheet[n] = n;
    before[n] = 0;
    copies[n] = 1;
  }
  for (size_t n = 0; n < used;)
    n += edge_join(sheet, seams, &seam_count, &edges[n], used - n, vertex);
  seam_count = sort_seams(seams, seam_count, sheet);
  for (size_t n = 0; n < seam_count; n++) {
    if (n == 0 || seams[n].sheet != seams[n - 1].sheet)
      all[sheets++] = (boundary){&seams[n], 0, seams[n].sheet};
    all[sheets - 1].count++;
  }
  qsort(all, sheets, sizeof *all, compare_boundaries);
  for (size_t n = 1; n < sheets; n++) {
    if (compare_lines(&all[n - 1], &all[n]) == 0)
      before[all[n].sheet] = before[all[n - 1].sheet] + 1;
  }
  for (size_t n = sheets; n-- > 0;) {
    const bool last = n + 1 == sheets || before[all[n + 1].sheet] == 0;
    copies[all[n].sheet] = last ? before[all[n].sheet] + 1 : copies[all[n + 1].sheet];
  }
  for (size_t n = 0; n < count; n++) {
    before[n] = before[root_of(sheet, n)];
    copies[n] = copies[root_of(sheet, n)];
  }
  free(all);
  free(seams);
  free(sheet);
}
