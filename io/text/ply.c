/* SPDX-License-Identifier: MIT */
/* ply.c - the reader of PLY: the rows of its elements. */
#include "text/ply.h"
#include "util/bytes.h"

#include <stdio.h>

typedef struct {
  mesh_builder *b;
  ply_head head;
  words w; /* in a binary file only `at` is used */
  double (*vertex)[3];
  size_t vertices; /* read so far */
  size_t faces;
  const ply_element *element;
  uint64_t row;
} ply_reader;

/* "element face, row 17 (from 0)" and the line, or the offset. */
static bool fail_row(const ply_reader *r, const char *what) {
  if (r->head.order == PLY_TEXT) {
    return sepax__builder_fail_line(r->b, r->w.line, "element %s, row %llu: %s; export it again",
                                    r->element->name, (unsigned long long)r->row, what);
  }
  return sepax__builder_fail(r->b, "offset %zu: element %s, row %llu: %s; export it again",
                             (size_t)(r->w.at - r->b->bytes), r->element->name,
                             (unsigned long long)r->row, what);
}

/* ------------------------------------------------------------------------- numbers */

static double number_at(const char *at, ply_type type, bool big) {
  const unsigned char *byte = (const unsigned char *)at;
  union {
    uint64_t whole;
    double real;
  } eight;
  union {
    uint32_t whole;
    float real;
  } four;
  unsigned two = big ? byte[0] * 256U + byte[1] : byte[1] * 256U + byte[0];
  switch (type) {
  case PLY_INT8:
    return (int8_t)byte[0];
  case PLY_UINT8:
    return byte[0];
  case PLY_INT16:
    return (int16_t)two;
  case PLY_UINT16:
    return two;
  case PLY_DOUBLE:
    eight.whole = bytes_get64(at);
    eight.whole = big ? __builtin_bswap64(eight.whole) : eight.whole;
    return eight.real;
  default:
    break;
  }
  four.whole = bytes_get32(at);
  four.whole = big ? __builtin_bswap32(four.whole) : four.whole;
  return type == PLY_FLOAT    ? (double)four.real
         : type == PLY_UINT32 ? (double)four.whole
                              : (double)(int32_t)four.whole;
}

/* Take a number. NaN of a vertex that no face has is harmless. */
static bool take_word(ply_reader *r, double *number) {
  return words_next(&r->w) ? words_any_number(&r->w, number)
                           : fail_row(r, "truncated: fewer numbers than properties");
}

static bool take_number(ply_reader *r, ply_type type, double *number) {
  if (r->head.order == PLY_TEXT) {
    return take_word(r, number);
  }
  size_t bytes = sepax__ply_bytes[type];
  if ((size_t)(r->w.end - r->w.at) < bytes) {
    return fail_row(r, "truncated");
  }
  *number = number_at(r->w.at, type, r->head.order == PLY_BIG);
  r->w.at += bytes;
  return true;
}

/* Another reader might cut off what does not fit. NaN is no whole number. */
static bool fits_type(ply_reader *r, double number, ply_type type) {
  static const double least[] = {
      [PLY_INT8] = INT8_MIN, [PLY_INT16] = INT16_MIN, [PLY_INT32] = INT32_MIN, [PLY_UINT32] = 0};
  static const double most[] = {
      [PLY_INT8] = INT8_MAX,     [PLY_UINT8] = UINT8_MAX, [PLY_INT16] = INT16_MAX,
      [PLY_UINT16] = UINT16_MAX, [PLY_INT32] = INT32_MAX, [PLY_UINT32] = UINT32_MAX};
  if (type == PLY_FLOAT || type == PLY_DOUBLE) {
    return true;
  }
  return (number >= least[type] && number <= most[type] && number == (double)(int64_t)number) ||
         fail_row(r, "a number that its type does not have");
}

static bool take_length(ply_reader *r, const ply_property *p, size_t *length) {
  double number = 0;
  if (!take_number(r, p->count, &number)) {
    return false;
  }
  if (!(number >= 0 && number < 0x1p32 && number == (double)(uint64_t)number)) {
    return fail_row(r, "a list whose length is no whole number");
  }
  size_t least = r->head.order == PLY_TEXT ? 1 : sepax__ply_bytes[p->type];
  if (number > (double)((size_t)(r->w.end - r->w.at) / least)) {
    return fail_row(r, "truncated: a list is longer than the numbers that follow");
  }
  *length = (size_t)number;
  return fits_type(r, number, p->count);
}

static bool skip(ply_reader *r, ply_type type, size_t count) {
  bool ok = true;
  if (r->head.order != PLY_TEXT) {
    r->w.at += count * sepax__ply_bytes[type]; /* take_length has checked that the bytes exist */
    return r->w.at <= r->w.end || fail_row(r, "truncated");
  }
  for (size_t n = 0; n < count && ok; n++) {
    ok = words_next(&r->w) || fail_row(r, "truncated: fewer numbers than properties");
    r->w.at += ok ? words_length(&r->w) : 0;
  }
  return ok;
}

static bool skip_property(ply_reader *r, const ply_property *p) {
  size_t count = 1;
  double unused;
  if (p->count == PLY_NONE) {
    return r->head.order == PLY_TEXT ? skip(r, p->type, 1) : take_number(r, p->type, &unused);
  }
  return take_length(r, p, &count) && skip(r, p->type, count);
}

/* ---------------------------------------------------------------------------- rows */

static bool read_vertex(ply_reader *r) {
  const ply_element *e = r->element;
  double *v = r->vertex[r->vertices];
  for (size_t n = 0; n < e->properties; n++) {
    int axis = 0;
    while (axis < 3 && e->use[axis] != n) {
      axis++;
    }
    const ply_property *p = &e->property[n];
    if (!(axis < 3 ? take_number(r, p->type, &v[axis]) && fits_type(r, v[axis], p->type)
                   : skip_property(r, p))) {
      return false;
    }
  }
  r->vertices++;
  return true;
}

/* The index of a vertex, or -1 where that is allowed. */
static bool take_index(ply_reader *r, ply_type type, bool separates, double *index) {
  char text[80];
  if (!take_number(r, type, index)) {
    return false;
  }
  if ((*index >= 0 && *index < (double)r->vertices && *index == (double)(size_t)*index) ||
      (separates && *index == -1)) {
    return fits_type(r, *index, type);
  }
  snprintf(text, sizeof text, "there is no vertex %.17g, of %zu", *index, r->vertices);
  return fail_row(r, text);
}

static bool read_polygon(ply_reader *r, const ply_property *p) {
  size_t count = 0;
  if (!take_length(r, p, &count) || !sepax__builder_corners(r->b, count)) {
    return false;
  }
  for (size_t n = 0; n < count; n++) {
    double index = 0;
    if (!take_index(r, p->type, false, &index)) {
      return false;
    }
    memcpy(r->b->corner[n], r->vertex[(size_t)index], sizeof *r->vertex);
  }
  if (count < 3) {
    return fail_row(r, "a face of fewer than three corners");
  }
  return sepax__builder_polygon(r->b, count, r->head.order == PLY_TEXT ? r->w.line : 0, "face",
                                r->row);
}

/* Each corner makes a triangle with the two before it, which winds the other way every other time;
 * one with a corner twice only leads to the next part of the strip. */
static bool read_strip(ply_reader *r, const ply_property *p) {
  size_t count = 0;
  size_t in_part = 0;
  size_t last[3] = {0, 0, 0};
  bool ok = take_length(r, p, &count);
  for (size_t n = 0; n < count && ok; n++) {
    double index = 0;
    ok = take_index(r, p->type, true, &index);
    if (ok && index < 0) {
      ok = in_part == 0 || in_part >= 3 || fail_row(r, "a strip of fewer than three corners");
      in_part = 0;
    } else if (ok) {
      last[0] = last[1];
      last[1] = last[2];
      last[2] = (size_t)index;
      in_part++;
      if (in_part < 3) {
        continue;
      }
      double v[3][3];
      bool turned = in_part % 2 == 0;
      memcpy(v[0], r->vertex[last[turned ? 1 : 0]], sizeof v[0]);
      memcpy(v[1], r->vertex[last[turned ? 0 : 1]], sizeof v[1]);
      memcpy(v[2], r->vertex[last[2]], sizeof v[2]);
      bool leads = last[0] == last[1] || last[1] == last[2] || last[0] == last[2];
      ok = leads ? sepax__builder_other(r->b, "triangles of strips with a corner twice", 1)
                 : sepax__builder_triangle(r->b, (const double(*)[3])v);
    }
  }
  return ok && (in_part == 0 || in_part >= 3 || fail_row(r, "a strip of fewer than three corners"));
}

static bool read_face(ply_reader *r) {
  const ply_element *e = r->element;
  for (size_t n = 0; n < e->properties; n++) {
    const ply_property *p = &e->property[n];
    bool ok = n != e->use[0]        ? skip_property(r, p)
              : e->role == PLY_FACE ? read_polygon(r, p)
                                    : read_strip(r, p);
    if (!ok) {
      return false;
    }
  }
  r->faces++;
  return true;
}

static bool skip_row(ply_reader *r) {
  const ply_element *e = r->element;
  bool ok = true;
  for (size_t n = 0; n < e->properties && ok; n++) {
    ok = skip_property(r, &e->property[n]);
  }
  return ok;
}

/* ------------------------------------------------------------------------ elements */

static bool make_space(ply_reader *r) {
  uint64_t least = r->element->bytes > 0 && r->head.order != PLY_TEXT ? r->element->bytes : 2;
  uint64_t there = (uint64_t)(r->w.end - r->w.at) / least + 1;
  uint64_t rows = r->element->rows < there ? r->element->rows : there;
  r->vertex = sepax_allocate((size_t)(rows + 1) * sizeof *r->vertex);
  return r->vertex != NULL || sepax__builder_fail_memory(r->b);
}

static bool read_rows(ply_reader *r, bool (*read)(ply_reader *r)) {
  bool text = r->head.order == PLY_TEXT;
  bool ok = true;
  for (r->row = 0; r->row < r->element->rows && ok; r->row++) {
    while (text && r->w.at < r->w.end && !words_next(&r->w)) {
      words_skip_line(&r->w);
    }
    ok = r->w.at < r->w.end || fail_row(r, "truncated");
    ok = ok && read(r);
    ok = ok && (!text || !words_next(&r->w) || fail_row(r, "more numbers than properties"));
  }
  return ok;
}

static bool read_elements(ply_reader *r, bool vertices, bool faces) {
  bool ok = true;
  r->w = r->head.behind;
  for (size_t n = 0; n < r->head.elements && ok; n++) {
    r->element = &r->head.element[n];
    bool (*read)(ply_reader * r) = skip_row;
    if (r->element->role == PLY_VERTEX && vertices) {
      ok = make_space(r);
      read = read_vertex;
    } else if ((r->element->role == PLY_FACE || r->element->role == PLY_STRIP) && faces) {
      read = read_face;
    }
    ok = ok && read_rows(r, read);
  }
  if (!ok) {
    return false;
  }
  while (r->head.order == PLY_TEXT && r->w.at < r->w.end && !words_next(&r->w)) {
    words_skip_line(&r->w);
  }
  return r->w.at >= r->w.end ||
         sepax__builder_fail(
             r->b,
             "offset %zu: more data after the last element than the head declares; export it again",
             (size_t)(r->w.at - r->b->bytes));
}

/* ------------------------------------------------------------------- the other parts */

/* "sets of vertex properties: nx ny nz" */
static bool name_properties(mesh_builder *b, const ply_element *e) {
  char what[sizeof b->account.other[0].what];
  size_t used = (size_t)snprintf(what, sizeof what, "sets of %s properties:", e->name);
  size_t count = 0;
  for (size_t n = 0; n < e->properties; n++) {
    bool is_used = n == e->use[0] || (e->role == PLY_VERTEX && (n == e->use[1] || n == e->use[2]));
    count += !is_used;
    if (!is_used && used < sizeof what) {
      used += (size_t)snprintf(what + used, sizeof what - used, " %s", e->property[n].name);
    }
  }
  if (used >= sizeof what) {
    memcpy(what + sizeof what - 4, "...", 4);
  }
  return count == 0 || sepax__builder_other(b, what, e->rows);
}

static bool name_others(mesh_builder *b, const ply_head *head) {
  bool ok = true;
  for (size_t n = 0; n < head->elements && ok; n++) {
    const ply_element *e = &head->element[n];
    char what[64];
    snprintf(what, sizeof what, "elements '%s'", e->name);
    ok = e->role != PLY_OTHER           ? name_properties(b, e)
         : strcmp(e->name, "edge") == 0 ? sepax__builder_other(b, "edges", e->rows)
                                        : sepax__builder_other(b, what, e->rows);
  }
  return ok;
}

bool sepax__ply_read(mesh_builder *b, size_t *faces) {
  ply_reader r = {.b = b};
  bool ok = sepax__ply_head_read(&r.head, b);
  if (ok && r.head.faces_first) {
    ok = read_elements(&r, true, false) && read_elements(&r, false, true);
  } else {
    ok = ok && read_elements(&r, true, true);
  }
  ok = ok && name_others(b, &r.head);
  *faces = r.faces;
  sepax_release(r.vertex);
  sepax__ply_head_free(&r.head);
  return ok;
}

bool sepax__ply_is(const char *bytes, size_t size) {
  return size > 4 && memcmp(bytes, "ply", 3) == 0 && (bytes[3] == '\n' || bytes[3] == '\r');
}
