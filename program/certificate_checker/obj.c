/* SPDX-License-Identifier: MIT */
/* obj.c - Wavefront OBJ: vertices and faces. */
#include "mesh.h"

#include "report.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* Statements without a surface of their own: normals, lines, curves, groups, materials. Surfaces
 * of free form (surf) are not among them. */
static const char *const WITHOUT[] = {
    "vt",     "vn",     "vp",     "p",      "l",     "g",          "o",         "s",        "mg",
    "mtllib", "usemtl", "usemap", "maplib", "bevel", "curv",       "c_interp",  "d_interp", "lod",
    "curv2",  "parm",   "trim",   "hole",   "scrv",  "sp",         "end",       "con",      "deg",
    "bmat",   "step",   "cstype", "ctech",  "stech", "shadow_obj", "trace_obj",
};

typedef struct {
  mesh *m;
  point *vertex;
  size_t vertices;
  point *face;
  long line;
} obj;

static bool is(const char *word, size_t length, const char *name) {
  return strlen(name) == length && strncmp(word, name, length) == 0;
}

static const char *skip_blanks(const char *text) {
  while (*text == ' ' || *text == '\t' || *text == '\r' || *text == '\v' || *text == '\f')
    text++;
  return text;
}

/* Behind the three coordinates are a weight or a colour. */
static void read_vertex(obj *o, const char *text) {
  const point p = {mesh_number(o->m, &text, 0, o->line), mesh_number(o->m, &text, 0, o->line),
                   mesh_number(o->m, &text, 0, o->line)};
  while (*(text = skip_blanks(text)) != 0)
    mesh_number(o->m, &text, 0, o->line);
  GROW(o->vertex, o->vertices);
  o->vertex[o->vertices++] = p;
}

/* Numbers of vertices count from 1; negative ones from the last vertex so far. */
static point vertex_of(const obj *o, long long number) {
  const long long count = (long long)o->vertices;
  if (number == 0 || number > count || number < -count)
    cannot("%s:%ld: no vertex %lld", o->m->file, o->line, number);
  return o->vertex[number > 0 ? number - 1 : count + number];
}

static void read_face(obj *o, const char *text) {
  size_t count = 0;
  while (*(text = skip_blanks(text)) != 0) {
    char *end = NULL;
    const long long number = strtoll(text, &end, 10);
    const size_t length = strcspn(text, " \t\r\v\f");
    if (end == text || (*end != '/' && end != text + length) ||
        strspn(text, "+-/0123456789") != length)
      cannot("%s:%ld: no corner of a face: %.20s", o->m->file, o->line, text);
    GROW(o->face, count);
    o->face[count++] = vertex_of(o, number);
    text += length;
  }
  if (count < 3)
    cannot("%s:%ld: a face of %zu corners", o->m->file, o->line, count);
  mesh_polygon(o->m, o->face, count);
  o->m->faces++;
}

static void read_statement(obj *o, const char *text) {
  text = skip_blanks(text);
  const size_t length = strcspn(text, " \t\r\v\f");
  if (length == 0)
    return;
  if (is(text, length, "v")) {
    read_vertex(o, text + length);
  } else if (is(text, length, "f") || is(text, length, "fo")) {
    read_face(o, text + length);
  } else {
    size_t n = 0;
    while (n < sizeof WITHOUT / sizeof *WITHOUT && !is(text, length, WITHOUT[n]))
      n++;
    if (n == sizeof WITHOUT / sizeof *WITHOUT)
      cannot("%s:%ld: unknown statement: %.20s", o->m->file, o->line, text);
  }
}

/* A line that ends with a backslash goes on in the next one. GROW knows an array by its count, so
 * o.face keeps what the largest face took. */
void mesh_obj(mesh *m, const char *bytes, size_t length) {
  if (memchr(bytes, 0, length) != NULL)
    cannot("%s: a byte 0 in a text", m->file);
  obj o = {.m = m};
  char *text = text_copy(bytes, length);
  long lines = 0;
  for (char *next = text; *next != 0;) {
    char *line = next;
    o.line = ++lines;
    char *end = line + strcspn(line, "\n");
    for (;;) {
      char *last = end > line && end[-1] == '\r' ? end - 2 : end - 1;
      if (*end == 0 || last < line || *last != '\\')
        break;
      memset(last, ' ', (size_t)(end - last) + 1);
      end += strcspn(end, "\n");
      lines++;
    }
    next = *end == 0 ? end : end + 1;
    *end = 0;
    line[strcspn(line, "#")] = 0;
    read_statement(&o, line);
  }
  free(text);
  free(o.vertex);
  free(o.face);
}
