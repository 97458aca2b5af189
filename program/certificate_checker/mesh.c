/* SPDX-License-Identifier: MIT */
/* mesh.c - which format a mesh file has, and its polygons. */
#include "mesh.h"

#include "report.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* Lengths beyond this would overflow in products of three. */
static const long double MOST = 0x1p1000L;

/* So many triangles of a file are read at most: a 3MF of some bytes may place a mesh without end.
 */
enum { TRIANGLES_MOST = 20000000 };

void mesh_polygon(mesh *m, const point *corner, size_t count) {
  for (size_t n = 0; n < count; n++) {
    const point p = corner[m->turned && n > 0 ? count - n : n];
    if (!(fabsl(p.x) <= MOST && fabsl(p.y) <= MOST && fabsl(p.z) <= MOST))
      cannot("%s: a coordinate is not finite", m->file);
    GROW(m->corner, m->corners);
    m->corner[m->corners++] = p;
  }
  GROW(m->end, m->polygons);
  m->end[m->polygons++] = m->corners;
  m->triangles += count - 2;
  if (m->triangles > TRIANGLES_MOST)
    cannot("%s: more than %d triangles", m->file, TRIANGLES_MOST);
}

bool mesh_strip(mesh *m, const point *corner, size_t count) {
  for (size_t n = 2; n < count; n++) {
    const point three[3] = {corner[n % 2 == 0 ? n - 2 : n - 1], corner[n % 2 == 0 ? n - 1 : n - 2],
                            corner[n]};
    mesh_polygon(m, three, 3);
  }
  return count > 2;
}

bool mesh_fan(mesh *m, const point *corner, size_t count) {
  for (size_t n = 2; n < count; n++) {
    const point three[3] = {corner[0], corner[n - 1], corner[n]};
    mesh_polygon(m, three, 3);
  }
  return count > 2;
}

placement placement_product(const placement *a, const placement *b) {
  placement c = {.shift = placement_apply(a, b->shift)};
  for (int n = 0; n < 3; n++) {
    const point r = a->row[n];
    c.row[n] = point_plus(point_plus(point_times(r.x, b->row[0]), point_times(r.y, b->row[1])),
                          point_times(r.z, b->row[2]));
  }
  return c;
}

/* strtold also takes hexadecimal numbers, NAN and INF, which no mesh has. */
long double mesh_number(const mesh *m, const char **text, char stop, long line) {
  const char *from = *text;
  while (isspace((unsigned char)*from))
    from++;
  char *end = NULL;
  const size_t length = strspn(from, "+-.0123456789eE");
  const long double value = strtold(from, &end);
  if (end == from || end != from + length || !isfinite(value) ||
      (*end != 0 && *end != stop && !isspace((unsigned char)*end)))
    cannot("%s:%ld: no number: %.*s", m->file, line, (int)strcspn(from, " \t\r\n") % 40, from);
  *text = end;
  return value;
}

static bool begins(const char *text, const char *with) {
  return strncasecmp(text, with, strlen(with)) == 0;
}

/* Does a line begin with this word? */
static bool has_line(const char *text, const char *word) {
  const size_t length = strlen(word);
  for (const char *at = text; at != NULL; at = strchr(at, '\n')) {
    at += strspn(at, " \t\r\n");
    if (strncmp(at, word, length) == 0 && (at[length] == ' ' || at[length] == '\t'))
      return true;
  }
  return false;
}

static bool is_binary_stl(const char *bytes, size_t length) {
  size_t count = 0;
  for (int n = 83; length >= 84 && n >= 80; n--)
    count = count << 8 | (unsigned char)bytes[n];
  return length >= 84 && length == 84 + 50 * count;
}

mesh mesh_read(const char *file, const char *bytes, size_t length) {
  mesh m = {.file = file};
  const char *text = strncmp(bytes, "\xEF\xBB\xBF", 3) == 0 ? bytes + 3 : bytes;
  const char *word = text + strspn(text, " \t\r\n");
  const size_t left = length - (size_t)(text - bytes);
  if (length > 4 && memcmp(bytes, "PK\3\4", 4) == 0) {
    m.format = "3MF";
    mesh_3mf(&m, bytes, length);
  } else if (strncmp(text, "ply", 3) == 0 && text[3] != 0 && strchr(" \t\r\n", text[3]) != NULL) {
    m.format = "PLY";
    mesh_ply(&m, text, left);
  } else if (is_binary_stl(bytes, length) || begins(word, "solid")) {
    m.format = "STL";
    mesh_stl(&m, is_binary_stl(bytes, length) ? bytes : text,
             is_binary_stl(bytes, length) ? length : left);
  } else if (*word == '<') {
    m.format = "DAE";
    mesh_dae(&m, text, left);
  } else if (has_line(text, "v")) {
    m.format = "OBJ";
    mesh_obj(&m, text, left);
  } else {
    cannot("%s: is no STL, OBJ, PLY, 3MF or DAE file", file);
  }
  if (m.triangles == 0)
    cannot("%s: has no triangle", file);
  return m;
}

void mesh_free(mesh *m) {
  free(m->corner);
  free(m->end);
}
