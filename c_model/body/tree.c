/* tree.c - a body's tree of AABBs, eight children a node, split by the surface area heuristic. */
#include "body.h"
#include "util/error.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Nodes below level EVEN are split into halves, so that no tree has more than 64 levels. */
enum { BINS = 16, EVEN = 48 };

typedef struct {
  float low[3], high[3];
} box;

typedef struct {
  box bounds;
  uint32_t triangle;
} entry;

typedef struct {
  sepax_body *body;
  const sepax_mesh *mesh;
  entry *entry;
  size_t capacity; /* of nodes */
  size_t placed;   /* triangles in the tree's order */
} builder;

typedef struct {
  size_t begin, end;
  box bounds;
} range;

/* -------------------------------------------------------------------------- boxes */

static box empty_box(void) {
  return (box){{FLT_MAX, FLT_MAX, FLT_MAX}, {-FLT_MAX, -FLT_MAX, -FLT_MAX}};
}

static void enclose(box *b, const box *other) {
  for (int i = 0; i < 3; i++) {
    b->low[i] = other->low[i] < b->low[i] ? other->low[i] : b->low[i];
    b->high[i] = other->high[i] > b->high[i] ? other->high[i] : b->high[i];
  }
}

static float area(const box *b) {
  float x = b->high[0] - b->low[0];
  float y = b->high[1] - b->low[1];
  float z = b->high[2] - b->low[2];
  return x < 0 ? 0 : x * y + y * z + z * x;
}

static float middle(const box *b, int axis) { return b->low[axis] + b->high[axis]; }

static float down(double x) {
  float f = (float)x;
  return (double)f > x ? nextafterf(f, -INFINITY) : f;
}

static float up(double x) {
  float f = (float)x;
  return (double)f < x ? nextafterf(f, INFINITY) : f;
}

/* In units of the scale from the centre. The difference rounds by less than 2^-52 of the scale,
 * which `margin` covers. */
static box box_of(const sepax_body *b, const double v[3][3]) {
  const double margin = 0x1p-50;
  box r;
  for (int i = 0; i < 3; i++) {
    double low = fmin(fmin(v[0][i], v[1][i]), v[2][i]);
    double high = fmax(fmax(v[0][i], v[1][i]), v[2][i]);
    r.low[i] = down((low - b->centre[i]) / b->scale - margin);
    r.high[i] = up((high - b->centre[i]) / b->scale + margin);
  }
  return r;
}

/* -------------------------------------------------------------------------- splits */

typedef struct {
  box bounds;
  size_t count;
} bin;

/* The cheapest of the splits along one axis: area times count on both sides. */
static float best_split(const bin bins[BINS], int *at) {
  float right[BINS];
  box bounds = empty_box();
  size_t count = 0;
  for (int k = BINS - 1; k > 0; k--) {
    enclose(&bounds, &bins[k].bounds);
    count += bins[k].count;
    right[k] = count > 0 ? area(&bounds) * (float)count : -1;
  }
  float best = FLT_MAX;
  bounds = empty_box();
  count = 0;
  for (int k = 1; k < BINS; k++) {
    enclose(&bounds, &bins[k - 1].bounds);
    count += bins[k - 1].count;
    float cost = area(&bounds) * (float)count + right[k];
    if (count > 0 && right[k] >= 0 && cost < best) {
      best = cost;
      *at = k;
    }
  }
  return best;
}

static int bin_of(float position, float low, float per_bin) {
  int k = (int)((position - low) * per_bin);
  return k < BINS ? k : BINS - 1;
}

/* Sort entries below the split to the front; where the second part begins. */
static size_t partition(entry *e, const range *r, int axis, float low, float per_bin, int at) {
  size_t i = r->begin;
  size_t j = r->end;
  while (i < j) {
    if (bin_of(middle(&e[i].bounds, axis), low, per_bin) < at) {
      i++;
    } else {
      entry keep = e[i];
      e[i] = e[--j];
      e[j] = keep;
    }
  }
  return i;
}

static box bounds_of(const entry *e, size_t begin, size_t end) {
  box all = empty_box();
  for (size_t n = begin; n < end; n++) {
    enclose(&all, &e[n].bounds);
  }
  return all;
}

/* Divide a range into two; into halves where `even`, or where no centre differs. */
static void split(builder *b, const range *r, bool even, range *first, range *second) {
  entry *e = b->entry;
  float low[3] = {FLT_MAX, FLT_MAX, FLT_MAX};
  float high[3] = {-FLT_MAX, -FLT_MAX, -FLT_MAX};
  for (size_t n = r->begin; n < r->end; n++) {
    for (int i = 0; i < 3; i++) {
      float m = middle(&e[n].bounds, i);
      low[i] = m < low[i] ? m : low[i];
      high[i] = m > high[i] ? m : high[i];
    }
  }
  float per_bin[3];
  bin bins[3][BINS];
  for (int i = 0; i < 3; i++) {
    per_bin[i] = high[i] > low[i] ? BINS / (high[i] - low[i]) : 0;
    for (int k = 0; k < BINS; k++) {
      bins[i][k] = (bin){empty_box(), 0};
    }
  }
  for (size_t n = r->begin; n < r->end; n++) {
    for (int i = 0; i < 3; i++) {
      bin *to = &bins[i][bin_of(middle(&e[n].bounds, i), low[i], per_bin[i])];
      enclose(&to->bounds, &e[n].bounds);
      to->count++;
    }
  }
  float best = FLT_MAX;
  int axis = -1;
  int at = 0;
  for (int i = 0; i < 3 && !even; i++) {
    int k = 0;
    float cost = best_split(bins[i], &k);
    if (cost < best) {
      best = cost;
      axis = i;
      at = k;
    }
  }
  size_t half = axis < 0 ? r->begin + (r->end - r->begin) / 2
                         : partition(e, r, axis, low[axis], per_bin[axis], at);
  *first = (range){r->begin, half, bounds_of(e, r->begin, half)};
  *second = (range){half, r->end, bounds_of(e, half, r->end)};
}

/* --------------------------------------------------------------------------- nodes */

static void set_lane(body_node *node, int lane, const box *b, uint32_t child) {
  for (int i = 0; i < 3; i++) {
    float centre = 0.5F * (b->low[i] + b->high[i]);
    node->centre[i][lane] = centre;
    node->half[i][lane] = up(fmax((double)b->high[i] - centre, (double)centre - b->low[i]));
  }
  node->child[lane] = child;
}

static uint32_t place_triangle(builder *b, const entry *e) {
  size_t place = b->placed++;
  memcpy(b->body->triangle[place], b->mesh->facet[e->triangle].v, sizeof(facet_points));
  b->body->number[place] = e->triangle;
  return BODY_TRIANGLE + (uint32_t)place;
}

/* Divide a range into up to eight: always the one of the largest area, until all of a short range
 * are single. */
static int divide(builder *b, const range *whole, bool even, range part[BODY_WIDE]) {
  int parts = 1;
  part[0] = *whole;
  while (parts < BODY_WIDE) {
    int largest = -1;
    float most = -1;
    bool bottom = whole->end - whole->begin <= BODY_WIDE;
    for (int k = 0; k < parts; k++) {
      size_t count = part[k].end - part[k].begin;
      float size = area(&part[k].bounds);
      if (count > (bottom ? 1U : (size_t)BODY_WIDE) && size > most) {
        most = size;
        largest = k;
      }
    }
    if (largest < 0) {
      break;
    }
    range r = part[largest];
    split(b, &r, even, &part[largest], &part[parts++]);
  }
  return parts;
}

static bool build_node(builder *b, const range *whole, int level, uint32_t *number) {
  sepax_body *body = b->body;
  if (body->nodes == b->capacity) {
    size_t more = 2 * b->capacity;
    body_node *grown = realloc(body->node, more * sizeof *grown);
    if (grown == NULL) {
      return false;
    }
    body->node = grown;
    b->capacity = more;
  }
  size_t own = body->nodes++;
  body_node *node = &body->node[own];
  range part[BODY_WIDE];
  node->children = (uint32_t)divide(b, whole, level > EVEN, part);
  for (int lane = 0; lane < BODY_WIDE; lane++) {
    node->child[lane] = 0;
    for (int i = 0; i < 3; i++) {
      node->centre[i][lane] = 0;
      node->half[i][lane] = -FLT_MAX / 4;
    }
  }
  int parts = (int)node->children;
  for (int lane = 0; lane < parts; lane++) {
    const range *r = &part[lane];
    uint32_t child = 0;
    if (r->end - r->begin == 1) {
      child = place_triangle(b, &b->entry[r->begin]);
    } else if (!build_node(b, r, level + 1, &child)) {
      return false;
    }
    set_lane(&body->node[own], lane, &r->bounds, child);
  }
  *number = (uint32_t)own;
  return true;
}

/* ----------------------------------------------------------------------- the body */

static bool measure(sepax_body *body, const sepax_mesh *mesh, sepax_error *error) {
  double low[3] = {INFINITY, INFINITY, INFINITY};
  double high[3] = {-INFINITY, -INFINITY, -INFINITY};
  for (size_t n = 0; n < mesh->count; n++) {
    for (int k = 0; k < 9; k++) {
      double x = mesh->facet[n].v[k / 3][k % 3];
      if (!(fabs(x) <= 0x1p1000)) {
        return sepax_fail(error, "facet %zu: the coordinate %g is not within 2^1000", n, x);
      }
      low[k % 3] = fmin(low[k % 3], x);
      high[k % 3] = fmax(high[k % 3], x);
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
  return true;
}

static bool build(builder *b, sepax_error *error) {
  sepax_body *body = b->body;
  size_t count = b->mesh->count;
  b->capacity = count / 4 + 8;
  body->count = count;
  body->triangle = malloc(count * sizeof *body->triangle);
  body->number = malloc(count * sizeof *body->number);
  body->node = malloc(b->capacity * sizeof *body->node);
  b->entry = malloc(count * sizeof *b->entry);
  bool ok =
      body->triangle != NULL && body->number != NULL && body->node != NULL && b->entry != NULL;
  if (ok) {
    for (size_t n = 0; n < count; n++) {
      b->entry[n] = (entry){box_of(body, b->mesh->facet[n].v), (uint32_t)n};
    }
    range whole = {0, count, bounds_of(b->entry, 0, count)};
    uint32_t root;
    ok = build_node(b, &whole, 0, &root) && body_fit(body);
  }
  free(b->entry);
  return ok || sepax_fail(error, "no memory for a body of %zu triangles", count);
}

bool sepax_body_new(sepax_body **body, const sepax_mesh *mesh, sepax_error *error) {
  *body = NULL;
  if (mesh->count == 0 || mesh->count >= INT32_MAX) {
    return sepax_fail(error, "a body has 1 ... 2^31 - 2 triangles, not %zu", mesh->count);
  }
  sepax_body *made = calloc(1, sizeof *made);
  builder b = {.body = made, .mesh = mesh};
  if (made == NULL) {
    return sepax_fail(error, "no memory for a body");
  }
  if (!measure(made, mesh, error) || !build(&b, error)) {
    sepax_body_free(made);
    return false;
  }
  *body = made;
  return true;
}

void sepax_body_free(sepax_body *body) {
  if (body != NULL) {
    free(body->triangle);
    free(body->number);
    free(body->node);
    free(body->boxes);
    free(body);
  }
}

size_t sepax_body_triangles(const sepax_body *body) { return body->count; }
