/* SPDX-License-Identifier: MIT */
/* ply_head.c - the head of a PLY file: its elements, their properties, what they are here. */
#include "text/ply.h"
#include "util/list.h"

#include <stdio.h>
#include <stdlib.h>

enum { ELEMENTS_MOST = 100, PROPERTIES_MOST = 1000 };

const size_t sepax__ply_bytes[PLY_DOUBLE + 1] = {0, 1, 1, 2, 2, 4, 4, 4, 8};

static const struct {
  const char *name;
  ply_type type;
} types[] = {
    {"char", PLY_INT8},   {"int8", PLY_INT8},     {"uchar", PLY_UINT8},   {"uint8", PLY_UINT8},
    {"short", PLY_INT16}, {"int16", PLY_INT16},   {"ushort", PLY_UINT16}, {"uint16", PLY_UINT16},
    {"int", PLY_INT32},   {"int32", PLY_INT32},   {"uint", PLY_UINT32},   {"uint32", PLY_UINT32},
    {"float", PLY_FLOAT}, {"float32", PLY_FLOAT}, {"double", PLY_DOUBLE}, {"float64", PLY_DOUBLE},
};

typedef struct {
  ply_head *head;
  mesh_builder *b;
  words w;
  bool only_cr; /* by itself ends a line, as it does the first one */
} head_reader;

static bool is(const words *w, const char *word) {
  size_t length = words_length(w);
  return strlen(word) == length && memcmp(w->at, word, length) == 0;
}

static void skip_word(words *w) { w->at += words_length(w); }

static bool fail_word(const head_reader *r, const char *wanted) {
  words w = r->w;
  bool there = words_next(&w);
  return sepax__builder_fail_line(r->b, w.line, "'%s' where the head has %s; export the mesh again",
                                  there ? words_show(&w).text : "", wanted);
}

/* Names are printed, and end where C ends them. */
static bool is_plain(const words *w) {
  size_t length = words_length(w);
  bool plain = length < 40;
  for (size_t n = 0; n < length && plain; n++) {
    plain = w->at[n] > ' ' && w->at[n] <= '~';
  }
  return plain;
}

static bool read_name(head_reader *r, char name[40]) {
  if (!words_next(&r->w) || !is_plain(&r->w)) {
    return fail_word(r, "a name of up to 39 characters of ASCII");
  }
  snprintf(name, 40, "%.*s", (int)words_length(&r->w), r->w.at);
  skip_word(&r->w);
  return true;
}

static bool read_type(head_reader *r, ply_type *type) {
  *type = PLY_NONE;
  if (words_next(&r->w)) {
    for (size_t n = 0; n < sizeof types / sizeof types[0]; n++) {
      *type = is(&r->w, types[n].name) ? types[n].type : *type;
    }
  }
  if (*type == PLY_NONE) {
    return fail_word(r, "a type of numbers");
  }
  skip_word(&r->w);
  return true;
}

static bool read_format(head_reader *r) {
  static const char *const names[] = {"ascii", "binary_little_endian", "binary_big_endian"};
  int order = 0;
  if (!words_next(&r->w)) {
    return fail_word(r, "a format");
  }
  while (order < 3 && !is(&r->w, names[order])) {
    order++;
  }
  if (order == 3) {
    return fail_word(r, "ascii, binary_little_endian or binary_big_endian");
  }
  r->head->order = (ply_order)order;
  skip_word(&r->w);
  return (words_next(&r->w) && is(&r->w, "1.0")) ? (skip_word(&r->w), true) : fail_word(r, "1.0");
}

static bool read_element(head_reader *r) {
  ply_head *head = r->head;
  ply_element *grown = head->elements < ELEMENTS_MOST ? list_grow(head->element, &head->capacity,
                                                                  head->elements, sizeof *grown)
                                                      : NULL;
  if (grown == NULL) {
    return head->elements < ELEMENTS_MOST
               ? sepax__builder_fail_memory(r->b)
               : sepax__builder_fail_line(r->b, r->w.line,
                                          "more than %d elements; export the mesh again",
                                          ELEMENTS_MOST);
  }
  head->element = grown;
  ply_element *e = &grown[head->elements++];
  *e = (ply_element){.rows = 0};
  if (!read_name(r, e->name)) {
    return false;
  }
  const char *digits = words_next(&r->w) ? r->w.at : "";
  const char *c = digits;
  for (; *c >= '0' && *c <= '9' && e->rows < UINT64_MAX / 100; c++) {
    e->rows = 10 * e->rows + (uint64_t)(*c - '0');
  }
  if (c == digits || !words_is_end(&r->w, c)) {
    return fail_word(r, "how many there are");
  }
  r->w.at = c;
  for (size_t n = 0; n + 1 < head->elements; n++) {
    if (strcmp(head->element[n].name, e->name) == 0) {
      return sepax__builder_fail_line(r->b, r->w.line, "a second element '%s'; take one out",
                                      e->name);
    }
  }
  return true;
}

static bool read_property(head_reader *r) {
  ply_head *head = r->head;
  if (head->elements == 0) {
    return fail_word(r, "an element before its properties");
  }
  ply_element *e = &head->element[head->elements - 1];
  ply_property *grown = e->properties < PROPERTIES_MOST
                            ? list_grow(e->property, &e->capacity, e->properties, sizeof *grown)
                            : NULL;
  if (grown == NULL) {
    return e->properties < PROPERTIES_MOST
               ? sepax__builder_fail_memory(r->b)
               : sepax__builder_fail_line(r->b, r->w.line,
                                          "more than %d properties; export the mesh again",
                                          PROPERTIES_MOST);
  }
  e->property = grown;
  ply_property *p = &grown[e->properties++];
  *p = (ply_property){.type = PLY_NONE};
  bool list = words_next(&r->w) && is(&r->w, "list");
  if (list) {
    skip_word(&r->w);
  }
  if ((list && !read_type(r, &p->count)) || !read_type(r, &p->type) || !read_name(r, p->name)) {
    return false;
  }
  if (list && p->count >= PLY_FLOAT) {
    return sepax__builder_fail_line(r->b, r->w.line,
                                    "list '%s' has a length that is no integer; "
                                    "export the mesh again",
                                    p->name);
  }
  for (size_t n = 0; n + 1 < e->properties; n++) {
    if (strcmp(grown[n].name, p->name) == 0) {
      return sepax__builder_fail_line(r->b, r->w.line, "a second property '%s'; take one out",
                                      p->name);
    }
  }
  return true;
}

/* One line; *ended at end_header. */
static bool read_line(head_reader *r, bool *ended, bool *formatted) {
  bool (*read)(head_reader *) = NULL;
  if (!words_next(&r->w) || is(&r->w, "comment") || is(&r->w, "obj_info")) {
    words_skip_line(&r->w);
    return true;
  }
  *ended = is(&r->w, "end_header");
  read = is(&r->w, "format")     ? read_format
         : is(&r->w, "element")  ? read_element
         : is(&r->w, "property") ? read_property
                                 : NULL;
  if (read == NULL && !*ended) {
    return fail_word(r, "format, comment, element, property or end_header");
  }
  *formatted = *formatted || read == read_format;
  skip_word(&r->w);
  if (read != NULL && !read(r)) {
    return false;
  }
  if (words_next(&r->w)) {
    return fail_word(r, "the end of a line");
  }
  /* Behind a binary file's head the first number may look like the end of a line. */
  if (*ended && r->w.at < r->w.end) {
    r->w.at += r->only_cr ? 1 : words_line_end(r->w.at);
    r->w.line++;
  } else {
    words_skip_line(&r->w);
  }
  return true;
}

static size_t property_named(const ply_element *e, const char *name) {
  size_t n = 0;
  while (n < e->properties && strcmp(e->property[n].name, name) != 0) {
    n++;
  }
  return n;
}

/* The number of the list of indices, or e->properties if there is none. */
static size_t indices_of(const ply_element *e) {
  size_t n = property_named(e, "vertex_indices");
  n = n < e->properties ? n : property_named(e, "vertex_index");
  return n < e->properties && e->property[n].count != PLY_NONE ? n : e->properties;
}

/* A list of integers may be faces under another name: any in an element that is not known, a second
 * one of such a name in an element of faces. */
static bool may_be_faces(const ply_element *e, size_t n) {
  const ply_property *p = &e->property[n];
  bool named = strncmp(p->name, "vert", 4) == 0 || strcmp(p->name, "indices") == 0 ||
               strcmp(p->name, "index") == 0;
  return p->count != PLY_NONE && p->type < PLY_FLOAT &&
         (e->role == PLY_OTHER || (e->role != PLY_VERTEX && n != e->use[0] && named));
}

static const ply_property *faces_elsewhere(const ply_element *e) {
  size_t n = 0;
  while (n < e->properties && !may_be_faces(e, n)) {
    n++;
  }
  return n < e->properties ? &e->property[n] : NULL;
}

static bool give_role(mesh_builder *b, ply_element *e) {
  static const char *const xyz[] = {"x", "y", "z"};
  size_t indices = indices_of(e);
  e->role = strcmp(e->name, "vertex") == 0      ? PLY_VERTEX
            : strcmp(e->name, "face") == 0      ? PLY_FACE
            : strcmp(e->name, "tristrips") == 0 ? PLY_STRIP
                                                : PLY_OTHER;
  e->use[0] = indices;
  for (int i = 0; i < 3 && e->role == PLY_VERTEX; i++) {
    e->use[i] = property_named(e, xyz[i]);
    if (e->use[i] == e->properties || e->property[e->use[i]].count != PLY_NONE) {
      return sepax__builder_fail(b, "element vertex has no property %s; export the mesh again",
                                 xyz[i]);
    }
  }
  const ply_property *list = faces_elsewhere(e);
  if (list != NULL) {
    return sepax__builder_fail(b,
                               "element '%s' may refer to vertices by its list '%s', which is not "
                               "read; export one list of faces",
                               e->name, list->name);
  }
  if ((e->role == PLY_FACE || e->role == PLY_STRIP) &&
      (indices == e->properties || e->property[indices].type >= PLY_FLOAT)) {
    return sepax__builder_fail(b,
                               "element %s has no list vertex_indices of integers; export the "
                               "mesh again",
                               e->name);
  }
  if (e->properties == 0 && e->rows > 0) {
    return sepax__builder_fail(b, "element '%s' has no properties; export the mesh again", e->name);
  }
  bool lists = false;
  for (size_t n = 0; n < e->properties; n++) {
    lists = lists || e->property[n].count != PLY_NONE;
    e->bytes += sepax__ply_bytes[e->property[n].type];
  }
  e->bytes = lists ? 0 : e->bytes;
  return true;
}

static bool give_roles(ply_head *head, mesh_builder *b) {
  bool faces = false;
  head->vertex = head->elements;
  for (size_t n = 0; n < head->elements; n++) {
    ply_element *e = &head->element[n];
    if (!give_role(b, e)) {
      return false;
    }
    faces = faces || e->role == PLY_FACE || e->role == PLY_STRIP;
    head->vertex = e->role == PLY_VERTEX ? n : head->vertex;
    head->faces_first = head->faces_first || (faces && head->vertex == head->elements);
  }
  return (head->vertex < head->elements && faces) ||
         sepax__builder_fail(b, "it has no element %s; give a mesh with faces",
                             faces ? "vertex" : "face");
}

/* The first line. */
static bool read_magic(head_reader *r) {
  if (!words_next(&r->w) || !is(&r->w, "ply")) {
    return fail_word(r, "ply");
  }
  skip_word(&r->w);
  if (words_next(&r->w)) {
    return fail_word(r, "the end of a line");
  }
  r->only_cr = *r->w.at == '\r' && r->w.at[1] != '\n';
  words_skip_line(&r->w);
  return true;
}

bool sepax__ply_head_read(ply_head *head, mesh_builder *b) {
  head_reader r = {.head = head, .b = b, .w = words_begin(b, false)};
  bool ended = false;
  bool formatted = false;
  *head = (ply_head){.order = PLY_TEXT};
  if (!read_magic(&r)) {
    return false;
  }
  while (!ended) {
    if (r.w.at >= r.w.end) {
      return sepax__builder_fail_line(b, r.w.line, "truncated: no end_header; export it again");
    }
    if (!read_line(&r, &ended, &formatted)) {
      return false;
    }
  }
  head->behind = r.w;
  return (formatted || sepax__builder_fail(b, "its head has no format; export it again")) &&
         give_roles(head, b);
}

void sepax__ply_head_free(ply_head *head) {
  for (size_t n = 0; n < head->elements; n++) {
    sepax_release(head->element[n].property);
  }
  sepax_release(head->element);
  *head = (ply_head){.order = PLY_TEXT};
}
