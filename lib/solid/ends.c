/* SPDX-License-Identifier: MIT */
/* ends.c - lists and sorts the ends of edges, so that those on one line follow each other. */
#include "body/orient.h"
#include "surface.h"
#include "util/list.h"

#include <string.h>

bool sepax__add_ends(edge_ends *ends, edge_end end) {
  for (int k = 0; k < 2; k++) {
    edge_end *grown = list_grow(ends->end, &ends->capacity, ends->count, sizeof *grown);
    if (grown == NULL) {
      return false;
    }
    ends->end = grown;
    ends->end[ends->count++] = end;
    uint32_t at = end.at;
    end.at = end.other;
    end.other = at;
    end.away = -end.away;
  }
  return true;
}

/* The order of the lines through p and q, p and r, around p: exactly 0 for the same line. A line's
 * direction is taken with its first coordinate that is not 0 positive. */
static int compare_lines(const double p[3], const double q[3], const double r[3]) {
  const double *end[2] = {q, r};
  int first[2];
  bool back[2];
  for (int k = 0; k < 2; k++) {
    first[k] = 0;
    while (first[k] < 2 && !(end[k][first[k]] < p[first[k]] || end[k][first[k]] > p[first[k]])) {
      first[k]++;
    }
    back[k] = end[k][first[k]] < p[first[k]];
  }
  int order = first[1] - first[0];
  for (int i = first[0] + 1; i < 3 && order == 0; i++) {
    const double at[2] = {p[first[0]], p[i]};
    const double to_q[2] = {q[first[0]], q[i]};
    const double to_r[2] = {r[first[0]], r[i]};
    order = sepax__orient2d(at, to_q, to_r);
    order = back[0] != back[1] ? -order : order;
  }
  return order;
}

int sepax__compare_ends(const surface *s, const edge_end *p, const edge_end *q) {
  if (p->at != q->at) {
    return p->at < q->at ? -1 : 1;
  }
  return compare_lines(s->vertex[p->at], s->vertex[p->other], s->vertex[q->other]);
}

/* Sort by merging; `scratch` has space for half of the ends. */
static void sort(const surface *s, edge_end *end, edge_end *scratch, size_t count) {
  if (count < 2) {
    return;
  }
  size_t half = count / 2;
  sort(s, end, scratch, half);
  sort(s, end + half, scratch, count - half);
  memcpy(scratch, end, half * sizeof *end);
  size_t p = 0;
  size_t q = half;
  for (size_t n = 0; p < half; n++) {
    bool lower = q == count || sepax__compare_ends(s, &scratch[p], &end[q]) <= 0;
    end[n] = lower ? scratch[p++] : end[q++];
  }
}

bool sepax__sort_ends(const surface *s, edge_ends *ends) {
  if (ends->count == 0) {
    return true;
  }
  edge_end *scratch = sepax_allocate(ends->count / 2 * sizeof *scratch);
  if (scratch != NULL) {
    sort(s, ends->end, scratch, ends->count);
    sepax_release(scratch);
  }
  return scratch != NULL;
}
