/* SPDX-License-Identifier: MIT */
/* samples.c - closed sample meshes of any even number of triangles.
 *
 * A shape begins as rings of corners joined by bands, fans and caps. Then the longest
 * edge is bisected until there are enough triangles: each bisection turns the two
 * triangles at the edge into four, so the mesh stays closed and oriented. */
#include "util/error.h"
#include "sepax_vectors.h"
#include "util/vector.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TRIANGLES_MAX = 1000000000 };

/* Objects farther from the origin than this number of sizes are refused, because doubles would
 * round them by more than 2^-23 of their size. */
static const double sizes_away_max = 0x1p30;

/* Curved surfaces of radius 1: a sphere round the origin, a cylinder round the z axis.
 * A corner lies on a set of them, the middle of an edge on those of both its ends. */
enum { PLANE = 0, SPHERE = 1, CYLINDER = 2 };

typedef struct {
  double p[3];
  unsigned surfaces;
} corner;

typedef struct {
  size_t end[2];
  size_t side[2]; /* the two triangles at this edge */
  double square;  /* square of the length */
} edge;

/* Counter-clockwise seen from outside; edge[i] leads from corner[i] to the next. */
typedef struct {
  size_t corner[3], edge[3];
} triangle;

typedef struct {
  corner *corner;
  edge *edge;
  triangle *triangle;
  size_t *heap; /* edge numbers, the longest edge first */
  size_t corners, edges, triangles;
} surface;

/* ------------------------------------------------------------- base meshes */

static size_t add_corner(surface *s, double x, double y, double z, unsigned surfaces) {
  s->corner[s->corners] = (corner){{x, y, z}, surfaces};
  return s->corners++;
}

static void add_triangle(surface *s, size_t a, size_t b, size_t c) {
  s->triangle[s->triangles++] = (triangle){.corner = {a, b, c}};
}

/* Six corners at radius 1, counter-clockwise seen from above. */
static size_t add_circle(surface *s, double z, unsigned surfaces) {
  static const double h = 0.86602540378443865; /* sqrt(3) / 2 */
  const double circle[6][2] = {{1, 0}, {0.5, h}, {-0.5, h}, {-1, 0}, {-0.5, -h}, {0.5, -h}};
  size_t first = s->corners;
  for (int i = 0; i < 6; i++) {
    add_corner(s, circle[i][0], circle[i][1], z, surfaces);
  }
  return first;
}

/* Four corners at +-x and +-y, counter-clockwise seen from above. */
static size_t add_rectangle(surface *s, double x, double y, double z) {
  size_t first = add_corner(s, -x, -y, z, PLANE);
  add_corner(s, x, -y, z, PLANE);
  add_corner(s, x, y, z, PLANE);
  add_corner(s, -x, y, z, PLANE);
  return first;
}

/* Connect two rings. Outside is on the right if the rings follow upwards. */
static void add_band(surface *s, size_t from, size_t to, size_t count) {
  for (size_t i = 0; i < count; i++) {
    size_t j = (i + 1) % count;
    add_triangle(s, from + i, from + j, to + j);
    add_triangle(s, from + i, to + j, to + i);
  }
}

static void add_fan_below(surface *s, size_t apex, size_t ring, size_t count) {
  for (size_t i = 0; i < count; i++) {
    add_triangle(s, apex, ring + (i + 1) % count, ring + i);
  }
}

static void add_fan_above(surface *s, size_t apex, size_t ring, size_t count) {
  for (size_t i = 0; i < count; i++) {
    add_triangle(s, apex, ring + i, ring + (i + 1) % count);
  }
}

static void add_cap_below(surface *s, size_t ring) {
  add_triangle(s, ring, ring + 2, ring + 1);
  add_triangle(s, ring, ring + 3, ring + 2);
}

static void add_cap_above(surface *s, size_t ring) {
  add_triangle(s, ring, ring + 1, ring + 2);
  add_triangle(s, ring, ring + 2, ring + 3);
}

static void build_cutter(surface *s, double tip_z, unsigned end_surface) {
  size_t tip = add_corner(s, 0, 0, tip_z, end_surface);
  size_t lower = add_circle(s, 0, end_surface | CYLINDER);
  size_t upper = add_circle(s, 6, CYLINDER);
  size_t top = add_corner(s, 0, 0, 6, PLANE);
  add_fan_below(s, tip, lower, 6);
  add_band(s, lower, upper, 6);
  add_fan_above(s, top, upper, 6);
}

static void build_ball_end(surface *s) { build_cutter(s, -1, SPHERE); }

static void build_flat_end(surface *s) { build_cutter(s, 0, PLANE); }

static void build_pocket(surface *s) {
  size_t bottom = add_rectangle(s, 60, 40, -40);
  size_t top = add_rectangle(s, 60, 40, 0);
  size_t rim = add_rectangle(s, 40, 20, 0);
  size_t ground = add_rectangle(s, 40, 20, -25);
  add_cap_below(s, bottom);
  add_band(s, bottom, top, 4);
  add_band(s, top, rim, 4);
  add_band(s, rim, ground, 4);
  add_cap_above(s, ground);
}

static void build_sphere(surface *s) {
  size_t south = add_corner(s, 0, 0, -1, SPHERE);
  size_t equator = add_corner(s, 1, 0, 0, SPHERE);
  add_corner(s, 0, 1, 0, SPHERE);
  add_corner(s, -1, 0, 0, SPHERE);
  add_corner(s, 0, -1, 0, SPHERE);
  size_t north = add_corner(s, 0, 0, 1, SPHERE);
  add_fan_below(s, south, equator, 4);
  add_fan_above(s, north, equator, 4);
}

static void build_box(surface *s) {
  size_t bottom = add_rectangle(s, 60, 40, -20);
  size_t top = add_rectangle(s, 60, 40, 20);
  add_cap_below(s, bottom);
  add_band(s, bottom, top, 4);
  add_cap_above(s, top);
}

/* ------------------------------------------------------------------ shapes */

typedef struct {
  const char *name, *about;
  size_t least;    /* triangles of the base mesh */
  double size;     /* default, mm */
  double length;   /* the length that `size` means, in units of the base mesh */
  double anchor_z; /* the point of the z axis of the base mesh that is placed at `at` */
  void (*build)(surface *s);
} sample;

static const sample samples[] = {
    {"ball-end", "ball-end cutter, tip at `at`, shank of 3 diameters (size: diameter)", 24, 20, 2,
     -1, build_ball_end},
    {"flat-end", "end mill, tip at `at`, 3 diameters long (size: diameter)", 24, 20, 2, 0,
     build_flat_end},
    {"pocket", "block 120 x 80 x 40 with a pocket, top at `at` (size: longest side)", 28, 120, 120,
     0, build_pocket},
    {"sphere", "sphere round `at` (size: diameter)", 8, 40, 2, 0, build_sphere},
    {"box", "block 120 x 80 x 40 round `at` (size: longest side)", 12, 120, 120, 0, build_box},
};

enum { SAMPLES = sizeof samples / sizeof samples[0] };

const char *sepax_sample_name(size_t i) { return i < SAMPLES ? samples[i].name : NULL; }

const char *sepax_sample_about(size_t i) { return i < SAMPLES ? samples[i].about : NULL; }

size_t sepax_sample_least(size_t i) { return i < SAMPLES ? samples[i].least : 0; }

/* --------------------------------------------------------------- bisection */

static double square_between(const surface *s, size_t a, size_t b) {
  const double *p = s->corner[a].p;
  const double *q = s->corner[b].p;
  double x = p[0] - q[0];
  double y = p[1] - q[1];
  double z = p[2] - q[2];
  return x * x + y * y + z * z;
}

static size_t add_edge(surface *s, size_t a, size_t b, size_t t, size_t u) {
  s->edge[s->edges] = (edge){{a, b}, {t, u}, square_between(s, a, b)};
  return s->edges++;
}

/* True if edge a is longer than b. Equal lengths are ordered by number, so that the mesh depends on
 * nothing else. */
static bool goes_first(const surface *s, size_t a, size_t b) {
  double difference = s->edge[a].square - s->edge[b].square;
  return difference > 0 || (difference == 0 && a < b);
}

static void sift_up(surface *s, size_t at, size_t e) {
  while (at > 0 && goes_first(s, e, s->heap[(at - 1) / 2])) {
    s->heap[at] = s->heap[(at - 1) / 2];
    at = (at - 1) / 2;
  }
  s->heap[at] = e;
}

/* Replace the longest edge, the root of the first `count`, by edge e. */
static void sift_down(surface *s, size_t count, size_t e) {
  size_t at = 0;
  for (size_t child = 1; child < count; child = 2 * at + 1) {
    if (child + 1 < count && goes_first(s, s->heap[child + 1], s->heap[child])) {
      child++;
    }
    if (goes_first(s, e, s->heap[child])) {
      break;
    }
    s->heap[at] = s->heap[child];
    at = child;
  }
  s->heap[at] = e;
}

/* Find or make the edge of triangle t from corner a to corner b. It exists already if its other
 * triangle was linked. */
static size_t link_edge(surface *s, size_t t, size_t a, size_t b) {
  for (size_t e = 0; e < s->edges; e++) {
    if (s->edge[e].end[0] == b && s->edge[e].end[1] == a) {
      s->edge[e].side[1] = t;
      return e;
    }
  }
  return add_edge(s, a, b, t, t);
}

static void link_edges(surface *s) {
  for (size_t t = 0; t < s->triangles; t++) {
    triangle *face = &s->triangle[t];
    for (int i = 0; i < 3; i++) {
      face->edge[i] = link_edge(s, t, face->corner[i], face->corner[(i + 1) % 3]);
    }
  }
  for (size_t e = 0; e < s->edges; e++) {
    sift_up(s, e, e);
  }
}

static void scale_to_one(double p[], int dimensions) {
  double square = 0;
  for (int i = 0; i < dimensions; i++) {
    square += p[i] * p[i];
  }
  for (int i = 0; i < dimensions; i++) {
    p[i] /= sqrt(square);
  }
}

static size_t add_middle(surface *s, size_t a, size_t b) {
  const corner *from = &s->corner[a];
  const corner *to = &s->corner[b];
  corner middle = {.surfaces = from->surfaces & to->surfaces};
  for (int i = 0; i < 3; i++) {
    middle.p[i] = (from->p[i] + to->p[i]) / 2;
  }
  if (middle.surfaces & SPHERE) {
    scale_to_one(middle.p, 3);
  }
  if (middle.surfaces & CYLINDER) {
    scale_to_one(middle.p, 2);
  }
  s->corner[s->corners] = middle;
  return s->corners++;
}

static void replace(size_t of[3], size_t old, size_t with) {
  for (int i = 0; i < 3; i++) {
    of[i] = of[i] == old ? with : of[i];
  }
}

static void replace_side(edge *e, size_t old, size_t with) {
  e->side[e->side[0] == old ? 0 : 1] = with;
}

/* Triangle t has edge e from corner a to corner b, which was bisected at m. t keeps the half at a,
 * and a new triangle receives the other half. Returns the number of the new triangle. */
static size_t divide(surface *s, size_t t, size_t e, size_t half, size_t b, size_t m) {
  size_t t_new = s->triangles++;
  triangle *near_a = &s->triangle[t];
  triangle *near_b = &s->triangle[t_new];
  int i = 0;
  while (near_a->edge[i] != e) {
    i++;
  }
  bool ahead = near_a->corner[i] != b;
  size_t a = near_a->corner[ahead ? i : (i + 1) % 3];
  size_t apex = near_a->corner[(i + 2) % 3];
  size_t edge_a = near_a->edge[(i + (ahead ? 2 : 1)) % 3];
  size_t edge_b = near_a->edge[(i + (ahead ? 1 : 2)) % 3];
  size_t cut = add_edge(s, m, apex, t, t_new);
  *near_b = *near_a;
  replace(near_a->corner, b, m);
  replace(near_a->edge, edge_b, cut);
  replace(near_b->corner, a, m);
  replace(near_b->edge, edge_a, cut);
  replace(near_b->edge, e, half);
  replace_side(&s->edge[edge_b], t, t_new);
  sift_up(s, cut, cut);
  return t_new;
}

static void bisect_longest(surface *s) {
  size_t e = s->heap[0];
  size_t a = s->edge[e].end[0];
  size_t b = s->edge[e].end[1];
  size_t m = add_middle(s, a, b);
  s->edge[e].end[1] = m;
  s->edge[e].square = square_between(s, a, m);
  sift_down(s, s->edges, e);
  size_t half = add_edge(s, m, b, 0, 0);
  sift_up(s, half, half);
  for (int i = 0; i < 2; i++) {
    s->edge[half].side[i] = divide(s, s->edge[e].side[i], e, half, b, m);
  }
}

/* ------------------------------------------------------------------ result */

static void transform(surface *s, const sample *kind, const double at[3], double size) {
  double scale = size / kind->length;
  for (size_t i = 0; i < s->corners; i++) {
    double *p = s->corner[i].p;
    p[2] -= kind->anchor_z;
    for (int axis = 0; axis < 3; axis++) {
      p[axis] = at[axis] + scale * p[axis];
    }
  }
}

/* False if the facet has no area in double precision. */
static bool find_normal(const sepax_facet *facet, double n[3]) {
  double e[3];
  double f[3];
  for (int axis = 0; axis < 3; axis++) {
    e[axis] = facet->v[1][axis] - facet->v[0][axis];
    f[axis] = facet->v[2][axis] - facet->v[0][axis];
  }
  vector_cross(e, f, n);
  double length = vector_length(n);
  for (int axis = 0; axis < 3; axis++) {
    n[axis] /= length;
  }
  return isnormal(length);
}

static bool copy_facets(sepax_soup *soup, const surface *s) {
  for (size_t t = 0; t < s->triangles; t++) {
    sepax_facet *facet = &soup->facet[t];
    for (int i = 0; i < 3; i++) {
      for (int axis = 0; axis < 3; axis++) {
        facet->v[i][axis] = s->corner[s->triangle[t].corner[i]].p[axis];
      }
    }
    if (!find_normal(facet, soup->normal[t])) {
      return false;
    }
  }
  soup->count = s->triangles;
  return true;
}

/* Reserve memory for a closed surface of this many triangles without holes. */
static bool reserve(surface *s, size_t triangles) {
  s->corner = calloc(triangles / 2 + 2, sizeof *s->corner);
  s->edge = calloc(triangles / 2 * 3, sizeof *s->edge);
  s->triangle = calloc(triangles, sizeof *s->triangle);
  s->heap = calloc(triangles / 2 * 3, sizeof *s->heap);
  return s->corner != NULL && s->edge != NULL && s->triangle != NULL && s->heap != NULL;
}

static void release(surface *s) {
  free(s->corner);
  free(s->edge);
  free(s->triangle);
  free(s->heap);
}

static bool make(sepax_soup *soup, const sample *kind, size_t triangles, const double at[3],
                 double size, sepax_error *error) {
  surface s = {0};
  sepax_soup result = {.facet = sepax_allocate(triangles * sizeof *result.facet),
                       .normal = sepax_allocate(triangles * sizeof *result.normal)};
  bool ok = reserve(&s, triangles) && result.facet != NULL && result.normal != NULL;
  if (!ok) {
    sepax_fail(error, SEPAX_ERROR_MEMORY, "%s: no memory for %zu triangles; ask for fewer",
               kind->name, triangles);
  } else {
    kind->build(&s);
    link_edges(&s);
    while (s.triangles < triangles) {
      bisect_longest(&s);
    }
    transform(&s, kind, at, size);
    ok = copy_facets(&result, &s) ||
         sepax_fail(
             error, SEPAX_ERROR_ARGUMENT,
             "%s: at size %g some triangles have no area in double precision; choose a size nearer "
             "%g mm",
             kind->name, size, kind->size);
  }
  release(&s);
  if (!ok) {
    sepax_soup_free(&result);
    return false;
  }
  *soup = result;
  return true;
}

static const sample *find_sample(const char *name, sepax_error *error) {
  char names[100] = "";
  for (size_t i = 0; i < SAMPLES; i++) {
    if (strcmp(samples[i].name, name) == 0) {
      return &samples[i];
    }
    size_t used = strlen(names);
    snprintf(names + used, sizeof names - used, "%s%s", i > 0 ? ", " : "", samples[i].name);
  }
  sepax_fail(error, SEPAX_ERROR_ARGUMENT, "shape: '%.40s' is none of: %s", name, names);
  return NULL;
}

static bool check_triangles(const sample *kind, size_t triangles, sepax_error *error) {
  if (triangles < kind->least || triangles > TRIANGLES_MAX) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "%s: %zu triangles are not in %zu ... %d",
                      kind->name, triangles, kind->least, TRIANGLES_MAX);
  }
  if (triangles % 2 != 0) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "%s: %zu triangles cannot form a closed mesh; ask for an even number",
                      kind->name, triangles);
  }
  return true;
}

bool sepax_sample(sepax_soup *soup, const char *shape, size_t triangles, const double at[3],
                  double size, sepax_error *error) {
  *soup = (sepax_soup){0};
  const sample *kind = find_sample(shape, error);
  if (kind == NULL || !check_triangles(kind, triangles, error)) {
    return false;
  }
  if (!(size >= 0) || !isfinite(size)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "size: %g is not a length; 0 stands for %g mm",
                      size, kind->size);
  }
  double length = size > 0 ? size : kind->size;
  for (int axis = 0; axis < 3; axis++) {
    if (!(fabs(at[axis]) <= sizes_away_max * length)) {
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "at: %c = %g is too far away for an object of %g mm; %s", "xyz"[axis],
                        at[axis], length, "move it nearer the origin");
    }
  }
  return make(soup, kind, triangles, at, length, error);
}
