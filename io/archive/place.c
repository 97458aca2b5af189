/* SPDX-License-Identifier: MIT */
/* place.c - places the objects of a 3MF package by its items and components. */
#include "archive/model.h"
#include "body/orient.h"
#include "util/text.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Limits: levels of components, and components visited to place all objects. */
enum { HEIGHT_MOST = 64, VISITS_MOST = 4000000 };

/* ------------------------------------------------------------------------- matrices */

/* Above 0 if the matrix keeps left and right, below 0 if it mirrors, 0 if it makes objects flat. */
static int orientation(const double m[4][3]) {
  static const double origin[3] = {0, 0, 0};
  return sepax__orient3d(origin, m[0], m[1], m[2]);
}

bool sepax__model_matrix(const part_xml *x, const part_attribute *a, model_matrix *at) {
  static const double identity[4][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};
  const char *c = a->value;
  const char *end = a->value + a->length;
  int count = 0;
  while (true) {
    while (c < end && (*c == ' ' || *c == '\t' || *c == '\n' || *c == '\r')) {
      c++;
    }
    const char *word = c;
    while (c < end && *c != ' ' && *c != '\t' && *c != '\n' && *c != '\r') {
      c++;
    }
    if (word == c) {
      break;
    }
    if (count == 12 || !sepax__number(word, (size_t)(c - word), &at->m[count / 3][count % 3])) {
      count = 0;
      break;
    }
    count++;
  }
  if (count != 12) {
    return sepax__part_xml_fail(x, "transform=\"%.*s\": give 12 finite numbers",
                                (int)(a->length < 60 ? a->length : 60), a->value);
  }
  int sign = orientation((const double(*)[3])at->m);
  at->identity = memcmp(at->m, identity, sizeof identity) == 0;
  at->mirrors = sign < 0;
  return sign != 0 ||
         sepax__part_xml_fail(x, "transform=\"%.*s\" makes the object flat; give one that does not",
                              (int)(a->length < 60 ? a->length : 60), a->value);
}

/* The matrix that applies `inner` first, then `outer`. */
static model_matrix multiply(const model_matrix *inner, const model_matrix *outer) {
  if (outer->identity) {
    return *inner;
  }
  if (inner->identity) {
    return *outer;
  }
  model_matrix product = {.mirrors = inner->mirrors != outer->mirrors};
  for (int i = 0; i < 4; i++) {
    for (int k = 0; k < 3; k++) {
      product.m[i][k] = inner->m[i][0] * outer->m[0][k] + inner->m[i][1] * outer->m[1][k] +
                        inner->m[i][2] * outer->m[2][k] + (i == 3 ? outer->m[3][k] : 0);
    }
  }
  return product;
}

/* Digits of coordinates are lost where products of matrices are very small or large, and all of
 * them where they underflow. */
static bool is_placing(const model_matrix *at) {
  bool placing = true;
  for (int i = 0; i < 3 && !at->identity; i++) {
    double most = fmax(fabs(at->m[i][0]), fmax(fabs(at->m[i][1]), fabs(at->m[i][2])));
    placing = placing && most >= 0x1p-400 && most <= 0x1p400;
  }
  return placing && (at->identity || orientation((const double(*)[3])at->m) != 0);
}

static void apply(const model_matrix *at, const double from[3], double to[3]) {
  for (int k = 0; k < 3; k++) {
    to[k] = at->identity ? from[k]
                         : from[0] * at->m[0][k] + from[1] * at->m[1][k] + from[2] * at->m[2][k] +
                               at->m[3][k];
  }
}

/* -------------------------------------------------------------------------- objects */

static int compare_objects(const void *left, const void *right) {
  const model_object *a = left;
  const model_object *b = right;
  if (a->part != b->part) {
    return a->part < b->part ? -1 : 1;
  }
  return a->id < b->id ? -1 : a->id > b->id;
}

static bool sort_objects(model *m) {
  if (m->objects == 0) {
    return true;
  }
  qsort(m->object, m->objects, sizeof *m->object, compare_objects);
  for (size_t n = 1; n < m->objects; n++) {
    const model_object *o = &m->object[n];
    if (compare_objects(o - 1, o) == 0) {
      return sepax__package_fail(&m->p, o->part, o->line > o[-1].line ? o->line : o[-1].line,
                                 "a second object %zu; give each its own id", o->id);
    }
  }
  return true;
}

static model_object *find_object(const model *m, const model_use *use) {
  model_object key = {.part = use->part, .id = use->id};
  model_object *found =
      m->objects > 0 ? bsearch(&key, m->object, m->objects, sizeof key, compare_objects) : NULL;
  if (found == NULL) {
    sepax__package_fail(&m->p, use->in, use->line,
                        "object %zu is not in part %.80s; export it again", use->id,
                        m->p.part[use->part].name);
  }
  return found;
}

static size_t add(size_t a, size_t b) { return a > SIZE_MAX - b ? SIZE_MAX : a + b; }

/* Count the triangles that one use of an object makes. Each object is counted only once, so a file
 * whose components double at each level takes no longer than its length. */
static bool weigh(model *m, model_object *o, int depth) {
  if (o->done) {
    return true;
  }
  if (o->entered || depth > HEIGHT_MOST) {
    return sepax__package_fail(&m->p, o->part, o->line,
                               o->entered ? "object %zu has itself as a component; export it again"
                                          : "object %zu: components are nested deeper than 64; "
                                            "flatten them",
                               o->id);
  }
  o->entered = true;
  o->weight = o->is_mesh ? o->count : 0;
  for (size_t n = 0; n < o->count && !o->is_mesh; n++) {
    model_object *part = find_object(m, &m->component[o->first + n]);
    if (part == NULL || !weigh(m, part, depth + 1)) {
      return false;
    }
    o->weight = add(o->weight, part->weight);
    o->visits = add(o->visits, part->weight > 0 ? add(part->visits, 1) : 1);
    o->height = part->height >= o->height ? part->height + 1 : o->height;
  }
  o->done = true;
  return o->height <= HEIGHT_MOST ||
         sepax__package_fail(&m->p, o->part, o->line,
                             "object %zu: components are nested deeper than 64; flatten them",
                             o->id);
}

/* Mark an object and its components as built. Each object is entered once. */
static bool mark_placed(model *m, model_object *o, const model_use *item) {
  if (o->placed) {
    return true;
  }
  o->placed = true;
  if (o->is_mesh && o->is_other) {
    return sepax__package_fail(&m->p, item->in, item->line,
                               "it builds object %zu, whose type is \"other\"; leave it out, or "
                               "give it another type",
                               o->id);
  }
  for (size_t n = 0; n < o->count && !o->is_mesh; n++) {
    if (!mark_placed(m, find_object(m, &m->component[o->first + n]), item)) {
      return false;
    }
  }
  return true;
}

static bool place_mesh(model *m, const model_object *o, const model_matrix *at) {
  const bool turned = at->mirrors != o->turned; /* a mirrored triangle keeps its outer side */
  for (size_t n = 0; n < o->count; n++) {
    const uint32_t *index = m->triangle[o->first + n];
    double v[3][3];
    for (int k = 0; k < 3; k++) {
      apply(at, m->vertex[o->vertex + index[k]], v[turned && k > 0 ? 3 - k : k]);
    }
    if (!sepax__builder_triangle(m->p.b, (const double(*)[3])v)) {
      return false;
    }
  }
  return true;
}

/* Find the placed meshes that are inside out, and name them in the account. */
static void find_turned(const model *m) {
  for (size_t n = 0; n < m->objects; n++) {
    model_object *o = &m->object[n];
    o->turned = o->is_mesh && o->placed && sepax__model_inside_out(m, o);
    if (o->turned) {
      bool root = o->part == m->root;
      sepax__builder_remark(m->p.b, "meshes inside out, which are turned", "object %zu%s%.60s",
                            o->id, root ? "" : " of ", root ? "" : m->p.part[o->part].name);
    }
  }
}

static bool place(model *m, const model_object *o, const model_matrix *at) {
  if (o->weight == 0) {
    return true;
  }
  if (o->is_mesh) {
    return place_mesh(m, o, at);
  }
  for (size_t n = 0; n < o->count; n++) {
    const model_use *use = &m->component[o->first + n];
    model_matrix inner = multiply(&use->at, at);
    if (!is_placing(&inner)) {
      return sepax__package_fail(
          &m->p, use->in, use->line,
          "its transform, combined with the transforms around it, makes object %zu flat, or too "
          "small or too large for a double; export it again",
          use->id);
    }
    if (!place(m, find_object(m, use), &inner)) {
      return false;
    }
  }
  return true;
}

bool sepax__model_place(model *m, size_t *unplaced) {
  size_t all = 0;
  size_t visits = 0;
  if (!sort_objects(m)) {
    return false;
  }
  for (size_t n = 0; n < m->objects; n++) {
    if (!weigh(m, &m->object[n], 0)) {
      return false;
    }
  }
  for (size_t n = 0; n < m->items; n++) {
    model_object *o = find_object(m, &m->item[n]);
    if (o == NULL || !mark_placed(m, o, &m->item[n])) {
      return false;
    }
    all = add(all, o->weight);
    visits = add(visits, o->weight > 0 ? o->visits : 0);
  }
  if (visits > VISITS_MOST) {
    return sepax_fail(m->p.b->error, SEPAX_ERROR_LIMIT,
                      "%.240s: its components are placed more than %d times; simplify it",
                      m->p.b->path, (int)VISITS_MOST);
  }
  if (all > m->p.b->how.most) {
    return sepax_fail(m->p.b->error, SEPAX_ERROR_LIMIT,
                      "%.240s: its items make more than %zu triangles; simplify the mesh",
                      m->p.b->path, m->p.b->how.most);
  }
  find_turned(m);
  for (size_t n = 0; n < m->items; n++) {
    if (!place(m, find_object(m, &m->item[n]), &m->item[n].at)) {
      return false;
    }
  }
  for (size_t n = 0; n < m->objects; n++) {
    const model_object *o = &m->object[n];
    *unplaced += o->is_mesh && !o->placed ? o->count : 0;
  }
  return true;
}
