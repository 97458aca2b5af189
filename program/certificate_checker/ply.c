/* SPDX-License-Identifier: MIT */
/* ply.c - PLY, ASCII or binary. */
#include "mesh.h"

#include "report.h"

#include <ctype.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

typedef enum { I8, U8, I16, U16, I32, U32, F32, F64, TYPES } type;
static const char *const NAME[TYPES][2] = {
    {"char", "int8"}, {"uchar", "uint8"}, {"short", "int16"},   {"ushort", "uint16"},
    {"int", "int32"}, {"uint", "uint32"}, {"float", "float32"}, {"double", "float64"},
};
static const size_t SIZE[TYPES] = {1, 1, 2, 2, 4, 4, 4, 8};

enum { PROPERTIES_MOST = 64, ELEMENTS_MOST = 16, WORD = 64 };

typedef struct {
  char name[WORD];
  bool list;
  type length, value;
} property;

typedef struct {
  char name[WORD];
  unsigned long long count;
  property property[PROPERTIES_MOST];
  size_t properties;
} element;

typedef struct {
  mesh *m;
  const char *next, *end;
  bool has_format, text, big;
  element element[ELEMENTS_MOST];
  size_t elements;
  point *vertex;
  size_t vertices;
  long long *index; /* of all faces and strips, as their vertices may be behind them */
  size_t indices;
  struct {
    size_t end;
    bool strip;
    bool last; /* of its row */
  } * list;
  size_t lists;
} ply;

/* ------------------------------------------------------------------- the head */

static type type_named(const ply *p, const char *word) {
  for (int n = 0; n < TYPES; n++) {
    if (strcmp(word, NAME[n][0]) == 0 || strcmp(word, NAME[n][1]) == 0)
      return (type)n;
  }
  cannot("%s: head: unknown type %s", p->m->file, word);
}

static void read_property(ply *p, char word[5][WORD], int words) {
  element *e = &p->element[p->elements - 1];
  const bool list = words == 5 && strcmp(word[1], "list") == 0;
  if (p->elements == 0 || e->properties == PROPERTIES_MOST || (!list && words != 3))
    cannot("%s: head: property", p->m->file);
  property *new = &e->property[e->properties++];
  *new = (property){.list = list, .value = type_named(p, word[list ? 3 : 1])};
  if (list)
    new->length = type_named(p, word[2]);
  strcpy(new->name, word[words - 1]);
  if (list && (new->length == F32 || new->length == F64))
    cannot("%s: head: the length of a list is no whole number", p->m->file);
}

static void read_element(ply *p, char word[5][WORD], int words) {
  if (words != 3 || p->elements == ELEMENTS_MOST || word[2][0] < '0' || word[2][0] > '9')
    cannot("%s: head: element", p->m->file);
  element *new = &p->element[p->elements++];
  char *end = NULL;
  *new = (element){.count = strtoull(word[2], &end, 10)};
  if (*end != 0)
    cannot("%s: head: element %s", p->m->file, word[1]);
  for (size_t n = 0; n + 1 < p->elements; n++) {
    if (strcmp(p->element[n].name, word[1]) == 0)
      cannot("%s: head: two elements %s", p->m->file, word[1]);
  }
  strcpy(new->name, word[1]);
}

static void read_format(ply *p, char word[5][WORD], int words) {
  p->has_format = true;
  p->text = strcmp(word[1], "ascii") == 0;
  p->big = strcmp(word[1], "binary_big_endian") == 0;
  if (words != 3 || strcmp(word[2], "1.0") != 0 ||
      (!p->text && !p->big && strcmp(word[1], "binary_little_endian") != 0))
    cannot("%s: head: format", p->m->file);
}

static void read_head(ply *p) {
  for (;;) {
    const char *end = memchr(p->next, '\n', (size_t)(p->end - p->next));
    char word[5][WORD] = {""};
    int words = 0;
    if (end == NULL)
      cannot("%s: head: no end_header", p->m->file);
    for (const char *at = p->next; at < end && words < 6;) {
      const size_t length = strcspn(at, " \t\r\n");
      if (length >= WORD || (length > 0 && words == 5)) {
        words = 6;
        break;
      }
      if (length > 0) {
        memcpy(word[words], at, length);
        word[words++][length] = 0;
      }
      at += length + 1;
    }
    p->next = end + 1;
    const bool said = strcmp(word[0], "comment") == 0 || strcmp(word[0], "obj_info") == 0;
    if (said || words == 0 || strcmp(word[0], "ply") == 0)
      continue;
    if (words > 5)
      cannot("%s: head: %s", p->m->file, word[0]);
    if (strcmp(word[0], "end_header") == 0)
      return;
    if (strcmp(word[0], "format") == 0)
      read_format(p, word, words);
    else if (strcmp(word[0], "element") == 0)
      read_element(p, word, words);
    else if (strcmp(word[0], "property") == 0 && p->elements > 0)
      read_property(p, word, words);
    else
      cannot("%s: head: %s", p->m->file, word[0]);
  }
}

/* ------------------------------------------------------------------- the body */

static long double binary(ply *p, type of) {
  const size_t size = SIZE[of];
  if ((size_t)(p->end - p->next) < size)
    cannot("%s: ends within an element", p->m->file);
  uint64_t bits = 0;
  for (size_t n = 0; n < size; n++)
    bits = bits << 8 | (unsigned char)p->next[p->big ? n : size - 1 - n];
  p->next += size;
  float single = 0;
  double value = 0;
  const uint32_t low = (uint32_t)bits;
  switch (of) {
  case F32:
    memcpy(&single, &low, sizeof single);
    return single;
  case F64:
    memcpy(&value, &bits, sizeof value);
    return value;
  case I8:
    return (int8_t)bits;
  case I16:
    return (int16_t)bits;
  case I32:
    return (int32_t)bits;
  default:
    return bits;
  }
}

/* Properties that are not coordinates or indices may be NaN. */
static long double next_number(ply *p, type of, bool used) {
  if (!p->text)
    return binary(p, of);
  while (p->next < p->end && isspace((unsigned char)*p->next))
    p->next++;
  if (p->next == p->end)
    cannot("%s: ends within an element", p->m->file);
  if (used)
    return mesh_number(p->m, &p->next, 0, 0);
  while (p->next < p->end && !isspace((unsigned char)*p->next))
    p->next++;
  return 0;
}

static size_t next_length(ply *p, type of) {
  const long double length = next_number(p, of, true);
  if (!(length >= 0 && length <= (long double)(p->end - p->next)) || length != floorl(length))
    cannot("%s: a list of %.0Lf entries", p->m->file, length);
  return (size_t)length;
}

static void skip(ply *p, const property *of) {
  const size_t count = of->list ? next_length(p, of->length) : 1;
  for (size_t n = 0; n < count; n++)
    next_number(p, of->value, false);
}

static void read_vertex(ply *p, const element *e) {
  long double at[3] = {NAN, NAN, NAN};
  for (size_t n = 0; n < e->properties; n++) {
    const property *of = &e->property[n];
    if (!of->list && of->name[0] >= 'x' && of->name[0] <= 'z' && of->name[1] == 0)
      at[of->name[0] - 'x'] = next_number(p, of->value, true);
    else
      skip(p, of);
  }
  GROW(p->vertex, p->vertices);
  p->vertex[p->vertices++] = (point){at[0], at[1], at[2]};
}

static bool is_indices(const property *of) {
  return strcmp(of->name, "vertex_indices") == 0 || strcmp(of->name, "vertex_index") == 0;
}

static void end_list(ply *p, bool strip, bool last) {
  GROW(p->list, p->lists);
  p->list[p->lists].end = p->indices;
  p->list[p->lists].last = last;
  p->list[p->lists++].strip = strip;
}

/* A face, or strips with a -1 between them. */
static void read_list(ply *p, const element *e, bool strips) {
  for (size_t n = 0; n < e->properties; n++) {
    const property *of = &e->property[n];
    if (!is_indices(of)) {
      skip(p, of);
      continue;
    }
    const size_t count = next_length(p, of->length);
    for (size_t k = 0; k < count; k++) {
      const long double value = next_number(p, of->value, true);
      if (strips && value == -1) {
        end_list(p, true, false);
        continue;
      }
      GROW(p->index, p->indices);
      p->index[p->indices++] =
          value == floorl(value) && fabsl(value) < 1e15L ? (long long)value : -1;
    }
    end_list(p, strips, true);
  }
}

static void check_element(const ply *p, const element *e, bool vertices, bool faces) {
  int indices = 0;
  int coordinates = 0;
  for (size_t n = 0; n < e->properties; n++) {
    const property *of = &e->property[n];
    indices += of->list && is_indices(of);
    coordinates += !of->list && (strcmp(of->name, "x") == 0 || strcmp(of->name, "y") == 0 ||
                                 strcmp(of->name, "z") == 0);
    for (size_t k = 0; k < n; k++) {
      if (strcmp(of->name, e->property[k].name) == 0)
        cannot("%s: head: two properties %s of %s", p->m->file, of->name, e->name);
    }
  }
  if (vertices && coordinates != 3)
    cannot("%s: head: vertices without x, y, z", p->m->file);
  if (indices != (faces ? 1 : 0))
    cannot("%s: head: element %s: %d lists of vertices", p->m->file, e->name, indices);
  if (e->properties == 0 && e->count > 0)
    cannot("%s: head: element %s without properties", p->m->file, e->name);
}

static void read_body(ply *p) {
  for (size_t n = 0; n < p->elements; n++) {
    const element *e = &p->element[n];
    const bool vertices = strcmp(e->name, "vertex") == 0;
    const bool strips = strcmp(e->name, "tristrips") == 0;
    const bool faces = strips || strcmp(e->name, "face") == 0;
    check_element(p, e, vertices, faces);
    for (unsigned long long k = 0; k < e->count; k++) {
      if (vertices)
        read_vertex(p, e);
      else if (faces)
        read_list(p, e, strips);
      for (size_t of = 0; !vertices && !faces && of < e->properties; of++)
        skip(p, &e->property[of]);
    }
  }
  while (p->text && p->next < p->end && isspace((unsigned char)*p->next))
    p->next++;
  if (p->next != p->end)
    cannot("%s: %zu bytes behind the last element", p->m->file, (size_t)(p->end - p->next));
}

/* A triangle with a corner twice only leads to the next part of a strip. */
static void make_strip(ply *p, const point *corner, const long long *index, size_t count) {
  for (size_t n = 2; n < count; n++) {
    const size_t odd = n % 2;
    const point three[3] = {corner[n - 2 + odd], corner[n - 1 - odd], corner[n]};
    if (index[n - 2] != index[n - 1] && index[n - 1] != index[n] && index[n - 2] != index[n])
      mesh_polygon(p->m, three, 3);
  }
}

static void make_faces(ply *p) {
  point *corner = memory(NULL, p->indices, sizeof *corner);
  for (size_t n = 0; n < p->indices; n++) {
    if (p->index[n] < 0 || (unsigned long long)p->index[n] >= p->vertices)
      cannot("%s: no vertex %lld", p->m->file, p->index[n]);
    corner[n] = p->vertex[p->index[n]];
  }
  size_t from = 0;
  for (size_t n = 0; n < p->lists; n++) {
    const size_t count = p->list[n].end - from;
    if (p->list[n].strip) {
      make_strip(p, corner + from, p->index + from, count);
      p->m->faces += p->list[n].last;
    } else if (count < 3) {
      cannot("%s: a face of %zu corners", p->m->file, count);
    } else {
      mesh_polygon(p->m, corner + from, count);
      p->m->faces++;
    }
    from = p->list[n].end;
  }
  free(corner);
}

void mesh_ply(mesh *m, const char *bytes, size_t length) {
  ply p = {.m = m, .next = bytes, .end = bytes + length};
  read_head(&p);
  if (!p.has_format)
    cannot("%s: head: no format", m->file);
  read_body(&p);
  make_faces(&p);
  free(p.vertex);
  free(p.index);
  free(p.list);
}
