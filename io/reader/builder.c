/* SPDX-License-Identifier: MIT */
/* builder.c - collects the triangles that the readers of all formats make. */
#include "reader/builder.h"
#include "reader/polygon.h"
#include "util/list.h"

#include <math.h>
#include <stdarg.h>
#include <string.h>

static const double coordinate_most = 0x1p1000;

static bool fail_text(const mesh_builder *b, const char *line, const char *format, va_list args) {
  char detail[240];
  vsnprintf(detail, sizeof detail, format, args);
  return sepax_fail(b->error, SEPAX_ERROR_FORMAT, "%.240s%s: %s", b->path, line, detail);
}

bool sepax__builder_fail(const mesh_builder *b, const char *format, ...) {
  va_list args;
  va_start(args, format);
  fail_text(b, "", format, args);
  va_end(args);
  return false;
}

bool sepax__builder_fail_line(const mesh_builder *b, size_t line, const char *format, ...) {
  char number[24] = "";
  va_list args;
  if (line > 0) {
    snprintf(number, sizeof number, ":%zu", line);
  }
  va_start(args, format);
  fail_text(b, number, format, args);
  va_end(args);
  return false;
}

bool sepax__builder_fail_memory(const mesh_builder *b) {
  return sepax_fail(b->error, SEPAX_ERROR_MEMORY,
                    "%.240s: no memory for its mesh of more than %zu triangles; simplify it",
                    b->path, b->soup.count);
}

bool sepax__builder_corners(mesh_builder *b, size_t corners) {
  if (corners <= b->corners) {
    return true;
  }
  size_t space = corners > 2 * b->corners ? corners : 2 * b->corners;
  space = space < 16 ? 16 : space;
  double(*corner)[3] = sepax_resize(b->corner, space * sizeof *corner);
  b->corner = corner != NULL ? corner : b->corner;
  size_t(*triangle)[3] = sepax_resize(b->triangle, space * sizeof *triangle);
  b->triangle = triangle != NULL ? triangle : b->triangle;
  if (corner == NULL || triangle == NULL) {
    return sepax__builder_fail_memory(b);
  }
  b->corners = space;
  return true;
}

/* Check the coordinates of triangle `number` of the soup. */
static bool coordinates_right(const mesh_builder *b, size_t number, const double (*v)[3],
                              size_t count) {
  bool right = true;
  for (size_t i = 0; i < 3 * count; i++) {
    right &= fabs(v[i / 3][i % 3]) <= coordinate_most;
  }
  for (size_t i = 0; i < 3 * count && !right; i++) {
    double x = v[i / 3][i % 3];
    if (!(fabs(x) <= coordinate_most)) {
      return sepax__builder_fail(b, "triangle %zu: a coordinate is %s; export the mesh again",
                                 number,
                                 isnan(x)   ? "NaN"
                                 : isinf(x) ? "infinite"
                                            : "beyond 2^1000");
    }
  }
  return true;
}

bool sepax__builder_within(const mesh_builder *b) {
  bool right = true;
  for (size_t n = 0; n < b->soup.count; n++) {
    for (int i = 0; i < 9; i++) {
      right &= fabs(b->soup.facet[n].v[i / 3][i % 3]) <= coordinate_most;
    }
  }
  for (size_t n = 0; n < b->soup.count && !right; n++) {
    if (!coordinates_right(b, n, b->soup.facet[n].v, 3)) {
      return false;
    }
  }
  return true;
}

bool sepax__builder_triangle(mesh_builder *b, const double v[3][3]) {
  if (!coordinates_right(b, b->soup.count, v, 3)) {
    return false;
  }
  if (b->soup.count >= b->how.most) {
    return sepax_fail(b->error, SEPAX_ERROR_LIMIT,
                      "%.240s: more than %zu triangles; simplify the mesh", b->path, b->how.most);
  }
  sepax_facet *grown = list_grow(b->soup.facet, &b->capacity, b->soup.count, sizeof *grown);
  if (grown == NULL) {
    return sepax__builder_fail_memory(b);
  }
  b->soup.facet = grown;
  memcpy(grown[b->soup.count++].v, v, sizeof grown->v);
  return true;
}

static bool divided(const mesh_builder *b, polygon_result result, size_t count, size_t line,
                    const char *what, size_t number) {
  switch (result) {
  case POLYGON_MEMORY:
    return sepax__builder_fail_memory(b);
  case POLYGON_LONG:
    return sepax__builder_fail_line(
        b, line,
        "%s %zu: a polygon of %zu corners that is no fan around its first corner; such polygons "
        "may have up to %d corners; export triangles",
        what, number, count, POLYGON_CORNERS_MOST);
  case POLYGON_CROSSES:
    return sepax__builder_fail_line(
        b, line,
        "%s %zu: a polygon of %zu corners crosses itself; export triangles, or give --polygons=fan",
        what, number, count);
  case POLYGON_DIVIDED:
    break;
  }
  return true;
}

static void reverse(double (*corner)[3], size_t count) {
  for (size_t n = 0; n < count / 2; n++) {
    double keep[3];
    memcpy(keep, corner[n], sizeof keep);
    memcpy(corner[n], corner[count - 1 - n], sizeof keep);
    memcpy(corner[count - 1 - n], keep, sizeof keep);
  }
}

/* Let corner `first` be the first one, followed by the others, backwards or not. */
static void reorder(double (*corner)[3], size_t count, size_t first, bool back) {
  if (back) {
    reverse(corner, count);
    first = count - 1 - first;
  }
  if (first > 0) {
    reverse(corner, first);
    reverse(corner + first, count - first);
    reverse(corner, count);
  }
}

bool sepax__builder_polygon(mesh_builder *b, size_t count, size_t line, const char *what,
                            size_t number) {
  if (count == 3) {
    return sepax__builder_triangle(b, (const double(*)[3])b->corner);
  }
  bool bent = false;
  bool back;
  size_t first;
  const double(*corner)[3] = (const double(*)[3])b->corner;
  if (!coordinates_right(b, b->soup.count, corner, count)) {
    return false;
  }
  if (!sepax__sides_find(&b->sides, corner, count, &first, &back)) {
    return sepax__builder_fail_memory(b);
  }
  reorder(b->corner, count, first, back);
  polygon_result result = sepax__polygon_divide(corner, count, b->triangle, &bent);
  if (result == POLYGON_CROSSES && b->how.fans) {
    /* Other programs take the first corner of the file, also of the second side of a face. */
    sepax__polygon_fan(count, back ? first : (count - first) % count, b->triangle);
    b->account.fans++;
    result = POLYGON_DIVIDED;
  }
  if (!divided(b, result, count, line, what, number)) {
    return false;
  }
  b->account.divided++;
  b->account.bent += bent;
  bool ok = true;
  for (size_t n = 0; n + 2 < count && ok; n++) {
    double v[3][3];
    for (int k = 0; k < 3; k++) {
      memcpy(v[k], b->corner[b->triangle[n][back ? 2 - k : k]], sizeof v[k]);
    }
    ok = sepax__builder_triangle(b, (const double(*)[3])v);
  }
  return ok;
}

bool sepax__builder_other(mesh_builder *b, const char *what, size_t count) {
  sepax_mesh_account *a = &b->account;
  size_t n = 0;
  while (n < a->others && strcmp(a->other[n].what, what) != 0) {
    n++;
  }
  if (n == SEPAX_MESH_OTHERS_MOST) {
    return sepax__builder_fail(b,
                               "more than %d kinds of elements without a surface; export "
                               "triangles alone",
                               SEPAX_MESH_OTHERS_MOST);
  }
  if (n == a->others && count > 0) {
    snprintf(a->other[n].what, sizeof a->other[n].what, "%s", what);
    a->others++;
  }
  if (n < a->others) {
    a->other[n].count += count;
  }
  return true;
}

void sepax__builder_remark(mesh_builder *b, const char *what, const char *format, ...) {
  sepax_mesh_account *a = &b->account;
  size_t n = 0;
  while (n < a->remarks && strcmp(a->remark[n].what, what) != 0) {
    n++;
  }
  sepax_mesh_remark *r = &a->remark[n];
  if (n == a->remarks) {
    snprintf(r->what, sizeof r->what, "%s", what);
    a->remarks++;
  }
  char name[100];
  va_list args;
  va_start(args, format);
  vsnprintf(name, sizeof name, format, args);
  va_end(args);
  /* "..." stands for the names from the first on that has no space, and comes once. */
  static const char more[] = ", ...";
  size_t used = strlen(r->which);
  bool full = used >= sizeof more && strcmp(r->which + used + 1 - sizeof more, more) == 0;
  bool fits = used + strlen(name) + 2 + sizeof more <= sizeof r->which;
  if (!full) {
    snprintf(r->which + used, sizeof r->which - used, "%s%s",
             used == 0 ? ""
             : fits    ? ", "
                       : more,
             fits ? name : "");
  }
  r->count++;
}
