/* solid.c - closed meshes as solids: is a part of one wholly inside the other? */
#include "util/error.h"
#include "util/wide.h"

#include <stdlib.h>
#include <string.h>

/* ------------------------------------------------------------------- closed */

typedef struct {
  sepax_vec end[2]; /* in order */
} edge;

static int compare_vertices(const sepax_vec *p, const sepax_vec *q) {
  int x = (p->x > q->x) - (p->x < q->x);
  int y = (p->y > q->y) - (p->y < q->y);
  int z = (p->z > q->z) - (p->z < q->z);
  return x != 0 ? x : y != 0 ? y : z;
}

static int compare_edges(const void *p, const void *q) {
  const edge *e = p;
  const edge *f = q;
  int first = compare_vertices(&e->end[0], &f->end[0]);
  return first != 0 ? first : compare_vertices(&e->end[1], &f->end[1]);
}

/* Every edge belongs to an even number of triangles; edges without length do not count. */
static bool closed(const sepax_tri *tri, size_t count, bool *result) {
  edge *list = malloc((3 * count + 1) * sizeof *list);
  if (list == NULL) {
    return false;
  }
  size_t edges = 0;
  for (size_t k = 0; k < count; k++) {
    for (int i = 0; i < 3; i++) {
      const sepax_vec *p = &tri[k].v[i];
      const sepax_vec *q = &tri[k].v[(i + 1) % 3];
      int order = compare_vertices(p, q);
      if (order != 0) {
        list[edges++] = order < 0 ? (edge){{*p, *q}} : (edge){{*q, *p}};
      }
    }
  }
  qsort(list, edges, sizeof *list, compare_edges);
  *result = true;
  for (size_t k = 0; k < edges && *result;) {
    size_t same = 1;
    while (k + same < edges && compare_edges(&list[k], &list[k + same]) == 0) {
      same++;
    }
    *result = same % 2 == 0;
    k += same;
  }
  free(list);
  return true;
}

/* ------------------------------------------------------------------- inside */

/* Does the line upwards from p, moved by something infinitely small to the right and, even
 * smaller, up the page, pass this edge on its right? The same for both triangles at an
 * edge, whichever way they go round it. */
static bool passes(sepax_vec p, sepax_vec from, sepax_vec to) {
  if ((from.y > p.y) == (to.y > p.y)) {
    return false;
  }
  wide side = (wide)((int64_t)to.x - from.x) * ((int64_t)p.y - from.y) -
              (wide)((int64_t)p.x - from.x) * ((int64_t)to.y - from.y);
  return to.y > from.y ? side > 0 : side < 0;
}

/* p is not on the triangle: does the line upwards from p meet it, and which way does it
 * face there? 0, -1 downwards, 1 upwards. */
static int above(sepax_vec p, const sepax_tri *t) {
  bool within = false;
  for (int i = 0; i < 3; i++) {
    within ^= passes(p, t->v[i], t->v[(i + 1) % 3]);
  }
  if (!within) {
    return 0;
  }
  wide_vec a = wide_from(t->v[0]);
  wide_vec n = wide_cross(wide_sub(wide_from(t->v[1]), a), wide_sub(wide_from(t->v[2]), a));
  wide height = wide_dot(n, wide_sub(wide_from(p), a));
  int up = n.c[2] > 0 ? 1 : -1;
  return (up > 0 ? height < 0 : height > 0) ? up : 0;
}

/* Parity holds whatever way the triangles face; where bodies overlap it is even, but the
 * mesh winds round p. */
static bool inside(sepax_vec p, const sepax_tri *tri, size_t count) {
  bool odd = false;
  int64_t winding = 0;
  for (size_t k = 0; k < count; k++) {
    int way = above(p, &tri[k]);
    odd ^= way != 0;
    winding += way;
  }
  return odd || winding != 0;
}

/* -------------------------------------------------------------------- parts */

typedef struct {
  sepax_vec at;
  size_t triangle;
} corner;

static int compare_corners(const void *p, const void *q) {
  return compare_vertices(&((const corner *)p)->at, &((const corner *)q)->at);
}

static size_t root(size_t *part, size_t k) {
  while (part[k] != k) {
    part[k] = part[part[k]];
    k = part[k];
  }
  return k;
}

/* part[k] == k for one triangle of each connected part. */
static bool find_parts(const sepax_tri *tri, size_t count, size_t *part) {
  corner *list = malloc((3 * count + 1) * sizeof *list);
  if (list == NULL) {
    return false;
  }
  for (size_t k = 0; k < 3 * count; k++) {
    list[k] = (corner){tri[k / 3].v[k % 3], k / 3};
    part[k / 3] = k / 3;
  }
  qsort(list, 3 * count, sizeof *list, compare_corners);
  for (size_t k = 1; k < 3 * count; k++) {
    if (compare_corners(&list[k - 1], &list[k]) == 0) {
      part[root(part, list[k].triangle)] = root(part, list[k - 1].triangle);
    }
  }
  free(list);
  return true;
}

bool sepax_solid(const sepax_scene *scene, bool within[2], sepax_error *error) {
  for (int i = 0; i < 2; i++) {
    bool is_closed = false;
    if (!closed(scene->tri[i], scene->count[i], &is_closed)) {
      return sepax_fail(error, "no memory for the edges of %zu triangles", scene->count[i]);
    }
    if (!is_closed) {
      return sepax_fail(
          error,
          "mesh %s is not closed on this grid: an edge has an odd number of triangles; "
          "mend it, or leave --solid out",
          i == 0 ? "A" : "B");
    }
  }
  for (int i = 0; i < 2; i++) {
    size_t *part = calloc(scene->count[i] + 1, sizeof *part);
    if (part == NULL || !find_parts(scene->tri[i], scene->count[i], part)) {
      free(part);
      return sepax_fail(error, "no memory for the parts of %zu triangles", scene->count[i]);
    }
    within[i] = false;
    for (size_t k = 0; k < scene->count[i] && !within[i]; k++) {
      within[i] =
          part[k] == k && inside(scene->tri[i][k].v[0], scene->tri[1 - i], scene->count[1 - i]);
    }
    free(part);
  }
  return true;
}
