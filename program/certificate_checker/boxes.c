/* SPDX-License-Identifier: MIT */
/* boxes.c - builds the tree of boxes: a box is divided along its longest side, at the median of its
 * triangles' centres. */
#include "boxes.h"

#include "report.h"

#include <float.h>
#include <limits.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

enum { LEAF = 1 };

static int longest(const double *half) {
  if (half[0] >= half[1] && half[0] >= half[2])
    return 0;
  return half[1] >= half[2] ? 1 : 2;
}

static double key(const triangle *t, vec axis) {
  return vec_dot(axis, t->at[0]) + vec_dot(axis, t->at[1]) + vec_dot(axis, t->at[2]);
}

/* The first `low` triangles have keys that are at most those of the others. */
static void divide(triangle *t, int count, int low, vec axis) {
  int from = 0;
  int to = count - 1;
  while (from < to) {
    const double pivot = key(&t[from + (to - from) / 2], axis);
    int i = from;
    int j = to;
    while (i <= j) {
      while (key(&t[i], axis) < pivot)
        i++;
      while (key(&t[j], axis) > pivot)
        j--;
      if (i > j)
        break;
      const triangle swapped = t[i];
      t[i++] = t[j];
      t[j--] = swapped;
    }
    if (low <= j) {
      to = j;
    } else if (low >= i) {
      from = i;
    } else {
      return;
    }
  }
}

/* Enclose triangles in a box with b's axes. Half sides are enlarged by more than they are
 * rounded. */
static void enclose(box *b, const triangle *t, int count) {
  double low[3] = {DBL_MAX, DBL_MAX, DBL_MAX};
  double high[3] = {-DBL_MAX, -DBL_MAX, -DBL_MAX};
  double largest = 0;
  for (int n = 0; n < 3 * count; n++) {
    const vec p = t[n / 3].at[n % 3];
    for (int k = 0; k < 3; k++) {
      const double at = vec_dot(b->axis[k], p);
      if (at < low[k])
        low[k] = at;
      if (at > high[k])
        high[k] = at;
    }
  }
  b->middle = (vec){0, 0, 0};
  for (int k = 0; k < 3; k++) {
    largest += fabs(low[k]) + fabs(high[k]);
    b->half[k] = (high[k] - low[k]) / 2;
    b->middle = vec_plus(b->middle, vec_times(low[k] + b->half[k], b->axis[k]));
  }
  for (int k = 0; k < 3; k++)
    b->half[k] += largest * 0x1p-46;
  b->radius = vec_length((vec){b->half[0], b->half[1], b->half[2]}) * (1 + 0x1p-46);
}

/* Choose axes along the mean normal, and across it along the way from the first vertex to the
 * farthest one. False if the normals have no useful mean. */
static bool lie(box *b, const triangle *t, int count) {
  vec normal = {0, 0, 0};
  double area = 0;
  for (int n = 0; n < count; n++) {
    const vec own = vec_cross(vec_minus(t[n].at[1], t[n].at[0]), vec_minus(t[n].at[2], t[n].at[0]));
    normal = vec_plus(normal, own);
    area += vec_length(own);
  }
  const double length = vec_length(normal);
  if (!(length > 0.1 * area))
    return false;
  normal = vec_times(1 / length, normal);
  vec along = {0, 0, 0};
  double most = 0;
  for (int n = 0; n < 3 * count; n++) {
    const vec from = vec_minus(t[n / 3].at[n % 3], t[0].at[0]);
    const vec across = vec_minus(from, vec_times(vec_dot(from, normal), normal));
    if (vec_dot(across, across) > most) {
      most = vec_dot(across, across);
      along = across;
    }
  }
  if (!(most > 0))
    return false;
  along = vec_times(1 / vec_length(along), along);
  along = vec_minus(along, vec_times(vec_dot(along, normal), normal));
  along = vec_times(1 / vec_length(along), along);
  b->axis[0] = normal;
  b->axis[1] = along;
  b->axis[2] = vec_cross(normal, along);
  return true;
}

static double side_area(const box *b) {
  return b->half[0] * b->half[1] + b->half[1] * b->half[2] + b->half[2] * b->half[0];
}

static void fit(box *b, const triangle *t, int count) {
  box turned = *b;
  b->axis[0] = (vec){1, 0, 0};
  b->axis[1] = (vec){0, 1, 0};
  b->axis[2] = (vec){0, 0, 1};
  enclose(b, t, count);
  if (!lie(&turned, t, count))
    return;
  enclose(&turned, t, count);
  if (side_area(&turned) < side_area(b))
    *b = turned;
}

box_tree boxes_of(const surface *s) {
  if (s->count > INT_MAX / 4)
    cannot("too many triangles");
  const int count = (int)s->count;
  box_tree tree = {memory(NULL, 2 * s->count, sizeof *tree.box), 1,
                   memory(NULL, s->count, sizeof *tree.triangle)};
  memcpy(tree.triangle, s->triangle, s->count * sizeof *tree.triangle);
  tree.box[0].first = 0;
  tree.box[0].count = count;
  for (int n = 0; n < tree.boxes; n++) {
    box *b = &tree.box[n];
    triangle *t = tree.triangle + b->first;
    fit(b, t, b->count);
    if (b->count <= LEAF)
      continue;
    const int low = b->count / 2;
    divide(t, b->count, low, b->axis[longest(b->half)]);
    box *below = &tree.box[tree.boxes];
    below[0].first = b->first;
    below[0].count = low;
    below[1].first = b->first + low;
    below[1].count = b->count - low;
    b->first = tree.boxes;
    b->count = 0;
    tree.boxes += 2;
  }
  return tree;
}
