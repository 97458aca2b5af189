/* SPDX-License-Identifier: MIT */
/* obj.c - OBJ: vertices in a first pass, faces in a second, as a face may come before them. */
#include "reader/format_table.h"
#include "text/words.h"
#include "util/list.h"

#include <stdlib.h>

typedef enum { IS_VERTEX, IS_TEXTURE, IS_NORMAL, IS_FACE, HAS_NO_SURFACE, IS_REFUSED } statement;

/* What the first word of a line means: a face, an element without a surface, or something that is
 * refused. */
typedef struct {
  const char *word;
  statement is;
  const char *what;
} keyword;

#define NO_SURFACE(word, what) \
  { word, HAS_NO_SURFACE, what }
#define REFUSED(word, what) \
  { word, IS_REFUSED, what }

static const keyword keywords[] = {
    {"v", IS_VERTEX, ""},
    {"f", IS_FACE, ""},
    {"fo", IS_FACE, ""}, /* as f was called in files of version 2.11 */
    {"vt", IS_TEXTURE, "texture coordinates"},
    {"vn", IS_NORMAL, "vertex normals"},
    NO_SURFACE("vp", "parameter space vertices"),
    NO_SURFACE("p", "points"),
    NO_SURFACE("l", "lines"),
    NO_SURFACE("g", "group names"),
    NO_SURFACE("o", "object names"),
    NO_SURFACE("s", "smoothing groups"),
    NO_SURFACE("mg", "merging groups"),
    NO_SURFACE("usemtl", "material names"),
    NO_SURFACE("mtllib", "material libraries"),
    NO_SURFACE("usemap", "texture maps"),
    NO_SURFACE("maplib", "texture maps"),
    NO_SURFACE("bevel", "display attributes"),
    NO_SURFACE("c_interp", "display attributes"),
    NO_SURFACE("d_interp", "display attributes"),
    NO_SURFACE("lod", "display attributes"),
    NO_SURFACE("shadow_obj", "display attributes"),
    NO_SURFACE("trace_obj", "display attributes"),
    NO_SURFACE("ctech", "display attributes"),
    NO_SURFACE("stech", "display attributes"),
    NO_SURFACE("cstype", "statements of curves"),
    NO_SURFACE("deg", "statements of curves"),
    NO_SURFACE("bmat", "statements of curves"),
    NO_SURFACE("step", "statements of curves"),
    NO_SURFACE("curv", "statements of curves"),
    NO_SURFACE("curv2", "statements of curves"),
    NO_SURFACE("parm", "statements of curves"),
    NO_SURFACE("scrv", "statements of curves"),
    NO_SURFACE("sp", "statements of curves"),
    NO_SURFACE("end", "statements of curves"),
    NO_SURFACE("con", "statements of curves"),
    NO_SURFACE("cdc", "statements of curves"),
    REFUSED("surf", "a free-form surface"),
    REFUSED("trim", "of a free-form surface"),
    REFUSED("hole", "of a free-form surface"),
    REFUSED("bzp", "a Bezier patch"),
    REFUSED("bsp", "a B-spline patch"),
    REFUSED("cdp", "a Cardinal patch"),
    REFUSED("res", "of a free-form surface"),
    REFUSED("call", "another file in place of it"),
    REFUSED("csh", "a command of a shell"),
};

typedef struct {
  mesh_builder *b;
  words w;
  double (*vertex)[3];
  size_t capacity;
  size_t vertices, textures, normals; /* numbers in the whole file */
  size_t above[3];                    /* how many of them are above the current line */
  size_t faces;
} obj_reader;

static const keyword *keyword_of(const words *w) {
  size_t length = words_length(w);
  for (size_t n = 0; n < sizeof keywords / sizeof keywords[0]; n++) {
    const char *word = keywords[n].word;
    if (strlen(word) == length && memcmp(word, w->at, length) == 0) {
      return &keywords[n];
    }
  }
  return NULL;
}

/* Comments begin where a word may. */
static bool next_word(words *w) { return words_next(w) && *w->at != '#'; }

/* ---------------------------------------------------------------------- first pass */

/* v x y z, w or not, a colour or not. */
static bool read_vertex(obj_reader *r) {
  double number[3];
  int count = 0;
  for (; next_word(&r->w); count++) {
    double unused;
    if (count < 3 ? !words_number(&r->w, &number[count]) : !words_any_number(&r->w, &unused)) {
      return false;
    }
  }
  if (count != 3 && count != 4 && count != 6 && count != 7) {
    return sepax__builder_fail_line(r->b, r->w.line,
                                    "a vertex of %d numbers; give x, y, z, then a weight or not, "
                                    "then a colour or not",
                                    count);
  }
  double(*grown)[3] = list_grow(r->vertex, &r->capacity, r->vertices, sizeof *grown);
  if (grown == NULL) {
    return sepax__builder_fail_memory(r->b);
  }
  r->vertex = grown;
  memcpy(grown[r->vertices++], number, sizeof *grown);
  return (count != 4 && count != 7) || sepax__builder_other(r->b, "vertex weights", 1)
             ? count < 6 || sepax__builder_other(r->b, "vertex colours", 1)
             : false;
}

static bool read_vertices(obj_reader *r) {
  for (; r->w.at < r->w.end; words_skip_line(&r->w)) {
    const keyword *key = next_word(&r->w) ? keyword_of(&r->w) : NULL;
    r->textures += key != NULL && key->is == IS_TEXTURE;
    r->normals += key != NULL && key->is == IS_NORMAL;
    if (key != NULL && key->is == IS_VERTEX) {
      r->w.at++;
      if (!read_vertex(r)) {
        return false;
      }
    }
  }
  return true;
}

/* --------------------------------------------------------------------- second pass */

/* Read an index from 1 to `all`, or a negative one that counts back from the current line, above
 * which there are `above`. *there: the element exists. */
static bool read_index(obj_reader *r, size_t all, size_t above, size_t *index, bool *there) {
  const char *c = r->w.at;
  bool back = *c == '-';
  uint64_t number = 0;
  c += back;
  const char *digits = c;
  for (; *c >= '0' && *c <= '9'; c++) {
    number = number < UINT32_MAX ? 10 * number + (uint64_t)(*c - '0') : number;
  }
  if (c == digits || !(*c == '/' || words_is_end(&r->w, c))) {
    return sepax__builder_fail_line(r->b, r->w.line,
                                    "'%s' is no corner of a face; give 1, 1/2, 1//3 or 1/2/3",
                                    words_show(&r->w).text);
  }
  *there = number != 0 && number <= (back ? above : all);
  *index = (size_t)(back ? above - number : number - 1);
  r->w.at = c;
  return true;
}

static bool read_vertex_index(obj_reader *r, size_t *vertex) {
  words_shown shown = words_show(&r->w);
  bool there = false;
  return read_index(r, r->vertices, r->above[0], vertex, &there) &&
         (there ||
          sepax__builder_fail_line(
              r->b, r->w.line,
              "'%s': there is no such vertex; the file has %zu, %zu of them above this line; "
              "export it again",
              shown.text, r->vertices, r->above[0]));
}

/* v, v/vt, v//vn, v/vt/vn. What is behind a slash may be left out, or name nothing: it has no
 * surface. */
static bool read_corner(obj_reader *r, size_t *vertex) {
  const size_t all[2] = {r->textures, r->normals};
  if (!read_vertex_index(r, vertex)) {
    return false;
  }
  for (int k = 0; k < 2 && *r->w.at == '/'; k++) {
    size_t unused;
    bool there = true;
    r->w.at++;
    if (*r->w.at != '/' && !words_is_end(&r->w, r->w.at) &&
        !read_index(r, all[k], r->above[k + 1], &unused, &there)) {
      return false;
    }
    if (!there && !sepax__builder_other(r->b,
                                        k == 0 ? "texture coordinates of corners that are not there"
                                               : "normals of corners that are not there",
                                        1)) {
      return false;
    }
  }
  return words_is_end(&r->w, r->w.at) ||
         sepax__builder_fail_line(r->b, r->w.line,
                                  "a corner of more than three numbers; give v/vt/vn");
}

static bool read_face(obj_reader *r) {
  size_t line = r->w.line;
  size_t count = 0;
  while (next_word(&r->w)) {
    size_t vertex = 0;
    if (!read_corner(r, &vertex) || !sepax__builder_corners(r->b, count + 1)) {
      return false;
    }
    memcpy(r->b->corner[count++], r->vertex[vertex], sizeof *r->vertex);
  }
  r->faces++;
  return count >= 3 ? sepax__builder_polygon(r->b, count, line, "face", r->faces - 1)
                    : sepax__builder_fail_line(r->b, line,
                                               "a face of %zu corners; give three or more, or a "
                                               "line (l)",
                                               count);
}

static bool read_statement(obj_reader *r) {
  const keyword *key = keyword_of(&r->w);
  if (key == NULL) {
    return sepax__builder_fail_line(r->b, r->w.line, "'%s' is no word of OBJ; mend it",
                                    words_show(&r->w).text);
  }
  switch (key->is) {
  case IS_VERTEX:
    r->above[0]++;
    return true;
  case IS_TEXTURE:
    r->above[1]++;
    return sepax__builder_other(r->b, key->what, 1);
  case IS_NORMAL:
    r->above[2]++;
    return sepax__builder_other(r->b, key->what, 1);
  case IS_FACE:
    r->w.at += strlen(key->word);
    return read_face(r);
  case HAS_NO_SURFACE:
    return sepax__builder_other(r->b, key->what, 1);
  case IS_REFUSED:
    break;
  }
  return sepax__builder_fail_line(r->b, r->w.line, "%s: %s, which is not read; export polygons",
                                  key->word, key->what);
}

/* Go to the next line. A comment or a name that ends with a backslash by chance, as paths do, would
 * swallow the statement in the next line, so this is refused. */
static bool end_line(obj_reader *r) {
  while (words_skip_part(&r->w)) {
    words next = r->w;
    if (next_word(&next) && keyword_of(&next) != NULL) {
      return sepax__builder_fail_line(r->b, r->w.line - 1,
                                      "the backslash at its end makes '%s' of the next line a part "
                                      "of this one; take it out",
                                      words_show(&next).text);
    }
  }
  return true;
}

static bool read_faces(obj_reader *r) {
  bool ok = true;
  r->w = words_begin(r->b, true);
  while (r->w.at < r->w.end && ok) {
    ok = (!next_word(&r->w) || read_statement(r)) && end_line(r);
  }
  return ok;
}

bool sepax__obj_read(mesh_builder *b, size_t *faces) {
  obj_reader r = {.b = b, .w = words_begin(b, true)};
  const char *zero = memchr(b->bytes, '\0', b->size);
  bool ok =
      (zero == NULL || sepax__builder_fail(b, "a byte of zero at offset %zu; give OBJ as text",
                                           (size_t)(zero - b->bytes))) &&
      read_vertices(&r) && read_faces(&r);
  *faces = r.faces;
  sepax_release(r.vertex);
  return ok;
}

/* Its first word is one of OBJ, behind comments. The title of a binary STL may begin so. */
bool sepax__obj_is(const char *bytes, size_t size) {
  enum { TITLE_MOST = 100 };
  mesh_builder b = {.bytes = bytes, .size = size};
  words w = words_begin(&b, true);
  while (w.at < w.end && !next_word(&w)) {
    words_skip_line(&w);
  }
  return w.at < w.end && keyword_of(&w) != NULL &&
         memchr(bytes, '\0', size < TITLE_MOST ? size : TITLE_MOST) == NULL;
}
