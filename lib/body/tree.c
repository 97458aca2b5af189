/* SPDX-License-Identifier: MIT */
/* tree.c - a body's tree of AABBs, eight children a node, split by the surface area heuristic.
 *
 * Ranges of triangles are divided down to PART of them; the trees below are parts that threads
 * take. Parts depend on the mesh alone, and so does the tree. */
#include "body.h"
#include "mesh/mesh.h"
#include "util/options.h"
#include "util/bins.h"
#include "util/memory.h"
#include "util/error.h"
#include "util/list.h"
#include "util/threads.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Nodes at level EVEN and below are split into halves of equal counts, so that no tree has more
 * than 64 levels. */
enum { EVEN = 48, PART = 2048 };

/* The nodes of a subtree. Until all subtrees are joined, the root of a part has the number
 * BODY_PART + part. */
typedef struct {
  body_node *node;
  size_t nodes, capacity;
  range whole;
  int level;
  bool no_memory;
} subtree;

#define BODY_PART UINT32_C(0x40000000)

typedef struct {
  sepax_body *body;
  const triangles *mesh;
  box4 *entry;
  subtree top, *part;
  size_t parts, capacity; /* number of parts and space for them */
} builder;

static corner magnitude(corner v) { return (corner)((corner_bits)v & INT32_MAX); }

/* In single precision a coordinate is wrong by 2^-24, and the difference of it and what covers that
 * likewise: 2^-22 are more. The difference from the centre rounds by less than 2^-52 of the scale,
 * which 2^-50 covers. */
static box4 entry_of(const sepax_body *b, const double v[3][3], uint32_t number) {
  const double per_unit = 1 / b->scale;
  corner p[3];
  for (int k = 0; k < 3; k++) {
    p[k] = (corner){(float)((v[k][0] - b->centre[0]) * per_unit),
                    (float)((v[k][1] - b->centre[1]) * per_unit),
                    (float)((v[k][2] - b->centre[2]) * per_unit), 0};
  }
  box4 r = {corner_least(corner_least(p[0], p[1]), p[2]),
            corner_most(corner_most(p[0], p[1]), p[2])};
  r.low -= magnitude(r.low) * 0x1p-22F + 0x1p-50F;
  r.high += magnitude(r.high) * 0x1p-22F + 0x1p-50F;
  box4_set_number(&r, number);
  return r;
}

/* -------------------------------------------------------------------------- splits */

/* Divide a range into two. If `even` is true or all middles are equal, then the halves have equal
 * counts. */
static void split(const builder *b, const range *r, bool even, range part[2]) {
  cut best = {.cost = FLT_MAX, .axis = -1};
  if (!even) {
    bins filled;
    bin_scale s = scale_bins(b->entry, r);
    fill_bins(&filled, b->entry, r, &s);
    for (int axis = 0; axis < 3; axis++) {
      find_cut(&filled, &s, axis, &best);
    }
    if (best.axis >= 0) {
      uint32_t at = partition(b->entry, r, &s, &best);
      part[0] = (range){r->begin, at, best.first};
      part[1] = (range){at, r->end, best.second};
      return;
    }
  }
  uint32_t half = r->begin + count_of(r) / 2;
  part[0] = (range){r->begin, half, bounds_of(b->entry, r->begin, half)};
  part[1] = (range){half, r->end, bounds_of(b->entry, half, r->end)};
}

/* --------------------------------------------------------------------------- nodes */

/* The half sides are rounded by 2^-24, which 2^-22 cover. */
static void set_lane(body_node *node, int lane, const box4 *b, uint32_t child) {
  corner centre = 0.5F * (b->low + b->high);
  corner half = corner_most(b->high - centre, centre - b->low) * (1 + 0x1p-22F);
  for (int i = 0; i < 3; i++) {
    node->centre[i][lane] = centre[i];
    node->half[i][lane] = half[i];
  }
  node->child[lane] = child;
}

/* Divide a range into up to eight ranges, in order. The range with the largest area that is too
 * long for a node is divided again and again. A range that fits a node is divided into single
 * triangles. */
static int divide(const builder *b, const range *whole, bool even, range part[BODY_WIDE]) {
  int parts = 1;
  part[0] = *whole;
  if (count_of(whole) <= BODY_WIDE) {
    for (uint32_t n = whole->begin; n < whole->end; n++) {
      part[n - whole->begin] = (range){n, n + 1, b->entry[n]};
    }
    return (int)count_of(whole);
  }
  while (parts < BODY_WIDE) {
    int largest = -1;
    float most = -1;
    for (int k = 0; k < parts; k++) {
      float size = area(&part[k].bounds);
      if (count_of(&part[k]) > BODY_WIDE && size > most) {
        most = size;
        largest = k;
      }
    }
    if (largest < 0) {
      break;
    }
    range r = part[largest];
    memmove(part + largest + 2, part + largest + 1, (size_t)(parts - largest - 1) * sizeof *part);
    split(b, &r, even, part + largest);
    parts++;
  }
  return parts;
}

static bool add_node(subtree *t) {
  if (t->nodes == t->capacity) {
    size_t more = t->capacity == 0 ? count_of(&t->whole) / 4 + 8 : 2 * t->capacity;
    body_node *grown = sepax_resize(t->node, more * sizeof *grown);
    if (grown == NULL) {
      t->no_memory = true;
      return false;
    }
    t->node = grown;
    t->capacity = more;
  }
  body_node *node = &t->node[t->nodes++];
  for (int lane = 0; lane < BODY_WIDE; lane++) {
    node->child[lane] = 0;
    for (int i = 0; i < 3; i++) {
      node->centre[i][lane] = 0;
      node->half[i][lane] = -FLT_MAX / 4;
    }
  }
  return true;
}

static bool add_part(builder *b, const range *whole, int level, uint32_t *number) {
  subtree *grown = list_grow(b->part, &b->capacity, b->parts, sizeof *grown);
  if (grown == NULL) {
    b->top.no_memory = true;
    return false;
  }
  b->part = grown;
  *number = BODY_PART + (uint32_t)b->parts;
  b->part[b->parts++] = (subtree){.whole = *whole, .level = level};
  return true;
}

/* Build the tree below a range, or only down to ranges that become parts. */
static bool build_node(builder *b, subtree *t, bool to_parts, const range *whole, int level,
                       uint32_t *number) {
  if (to_parts && count_of(whole) <= PART) {
    return add_part(b, whole, level, number);
  }
  size_t own = t->nodes;
  if (!add_node(t)) {
    return false;
  }
  range part[BODY_WIDE];
  int parts = divide(b, whole, level > EVEN, part);
  t->node[own].children = (uint32_t)parts;
  for (int lane = 0; lane < parts; lane++) {
    const range *r = &part[lane];
    uint32_t child = BODY_TRIANGLE + r->begin;
    if (count_of(r) > 1 && !build_node(b, t, to_parts, r, level + 1, &child)) {
      return false;
    }
    set_lane(&t->node[own], lane, &r->bounds, child);
  }
  *number = (uint32_t)own;
  return true;
}

static void build_part(void *context, size_t part) {
  builder *b = context;
  subtree *t = &b->part[part];
  uint32_t root;
  build_node(b, t, false, &t->whole, t->level, &root);
}

/* Copy a subtree into the whole tree, where its nodes begin at `first`. */
static void join(body_node *to, const subtree *t, uint32_t first, const uint32_t *first_of_part) {
  for (size_t n = 0; n < t->nodes; n++) {
    to[n] = t->node[n];
    for (uint32_t lane = 0; lane < to[n].children; lane++) {
      uint32_t child = to[n].child[lane];
      if ((child & BODY_TRIANGLE) == 0) {
        to[n].child[lane] =
            (child & BODY_PART) != 0 ? first_of_part[child - BODY_PART] : child + first;
      }
    }
  }
}

static bool join_all(builder *b) {
  sepax_body *body = b->body;
  uint32_t *first = sepax_allocate((b->parts + 1) * sizeof *first);
  body->nodes = b->top.nodes;
  bool ok = first != NULL && !b->top.no_memory;
  for (size_t k = 0; k < b->parts && ok; k++) {
    first[k] = (uint32_t)body->nodes;
    body->nodes += b->part[k].nodes;
    ok = !b->part[k].no_memory;
  }
  body->node = ok ? sepax_allocate(body->nodes * sizeof *body->node) : NULL;
  ok = body->node != NULL;
  if (ok) {
    join(body->node, &b->top, 0, first);
  }
  for (size_t k = 0; k < b->parts && ok; k++) {
    join(body->node + first[k], &b->part[k], first[k], first);
  }
  sepax_release(first);
  return ok;
}

/* ----------------------------------------------------------------------- the body */

static bool measure(sepax_body *body, const triangles *mesh, sepax_error *error) {
  double low[3] = {INFINITY, INFINITY, INFINITY};
  double high[3] = {-INFINITY, -INFINITY, -INFINITY};
  for (size_t n = 0; n < mesh->count; n++) {
    double space[3][3];
    const double(*v)[3] = triangle_at(mesh, n, space);
    for (int k = 0; k < 9; k++) {
      double x = v[k / 3][k % 3];
      if (!(fabs(x) <= 0x1p1000)) {
        return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                          "facet %zu: %c = %g is not within 2^1000; %s", n, "xyz"[k % 3], x,
                          isfinite(x) ? "scale the mesh down" : "mend the mesh");
      }
      low[k % 3] = x < low[k % 3] ? x : low[k % 3];
      high[k % 3] = x > high[k % 3] ? x : high[k % 3];
    }
  }
  double most = 0;
  for (int i = 0; i < 3; i++) {
    body->centre[i] = low[i] / 2 + high[i] / 2;
    most = fmax(most, fmax(high[i] - body->centre[i], body->centre[i] - low[i]));
  }
  int exponent;
  frexp(most, &exponent);
  body->scale = most > 0 ? ldexp(1, exponent < -1000 ? -1000 : exponent) : 1;
  double sum = 0; /* sum of squares, in units of the scale */
  for (int i = 0; i < 3; i++) {
    double half = fmax(high[i] - body->centre[i], body->centre[i] - low[i]) / body->scale;
    sum += half * half;
  }
  body->radius = body->scale * sqrt(sum) * (1 + 0x1p-40);
  return true;
}

static void place_triangles(const builder *b) {
  for (size_t n = 0; n < b->body->count; n++) {
    uint32_t number = box4_number(&b->entry[n]);
    double space[3][3];
    memcpy(b->body->triangle[n], triangle_at(b->mesh, number, space), sizeof(facet_points));
    b->body->number[n] = number;
  }
}

static bool build(builder *b, size_t threads) {
  sepax_body *body = b->body;
  size_t count = b->mesh->count;
  body->count = count;
  body->triangle = sepax_allocate(count * sizeof *body->triangle);
  body->number = sepax_allocate(count * sizeof *body->number);
  b->entry = sepax_allocate(count * sizeof *b->entry);
  bool ok = body->triangle != NULL && body->number != NULL && b->entry != NULL;
  if (ok) {
    for (size_t n = 0; n < count; n++) {
      double space[3][3];
      b->entry[n] = entry_of(body, triangle_at(b->mesh, n, space), (uint32_t)n);
    }
    uint32_t root;
    b->top.whole = (range){0, (uint32_t)count, bounds_of(b->entry, 0, (uint32_t)count)};
    ok = build_node(b, &b->top, count > PART, &b->top.whole, 0, &root);
  }
  if (ok) {
    sepax__threads_run(threads, b->parts, build_part, b);
    ok = join_all(b);
    place_triangles(b);
  }
  sepax_release(b->entry);
  for (size_t k = 0; k < b->parts; k++) {
    sepax_release(b->part[k].node);
  }
  sepax_release(b->part);
  sepax_release(b->top.node);
  return ok && sepax__body_fit(body, threads);
}

static size_t threads_of(const sepax_build *how, size_t count) {
  size_t most = 1 + count / PART;
  size_t threads = how->threads > 0 ? (size_t)how->threads : most > 1 ? sepax__threads_here() : 1;
  return threads < most ? threads : most;
}

bool sepax_body_new(sepax_body **body, const sepax_mesh *mesh, const sepax_build *how,
                    sepax_error *error) {
  sepax_build options;
  triangles all;
  *body = NULL;
  if (!sepax__options(&options, sizeof options, how, "sepax_build", error) ||
      !sepax__triangles_of(&all, mesh, error)) {
    return false;
  }
  if (options.threads < 0) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "%d threads is out of range; give 0 (one for each processor) or more",
                      options.threads);
  }
  if (all.count == 0 || all.count >= INT32_MAX) {
    return sepax_fail(error, all.count == 0 ? SEPAX_ERROR_ARGUMENT : SEPAX_ERROR_LIMIT,
                      "a body has 1 ... 2^31 - 2 triangles, not %zu; %s", all.count,
                      all.count == 0 ? "give a mesh with facets" : "split the mesh");
  }
  sepax_body *made = sepax__zeroed(1, sizeof *made);
  builder b = {.body = made, .mesh = &all};
  bool ok = made != NULL;
  if (ok && !measure(made, &all, error)) {
    sepax_body_free(made);
    return false;
  }
  if (!ok || !build(&b, threads_of(&options, all.count))) {
    sepax_body_free(made);
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for a body of %zu triangles",
                      all.count);
  }
  *body = made;
  return true;
}

void sepax_body_free(sepax_body *body) {
  if (body != NULL) {
    sepax_release(body->triangle);
    sepax_release(body->number);
    sepax_release(body->node);
    sepax_release(body->memory);
    sepax_release(body->frame);
    sepax_release(body->foot);
    sepax_release(body);
  }
}

size_t sepax_body_triangles(const sepax_body *body) { return body->count; }
