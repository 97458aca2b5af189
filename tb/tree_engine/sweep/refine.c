/* SPDX-License-Identifier: MIT */
/* refine.c - a mesh of the same surface with more triangles.
 *   refine IN.stl COUNT OUT.stl
 * The longest edge is bisected, in all triangles that have it, until there are COUNT triangles or
 * a few more. Vertices of equal coordinates are one, so a mesh stays closed. */
#include "sepax_models.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NONE = -1 };

typedef struct {
  int end[2];
  int first;     /* half-edge 3 t + k: from corner k of triangle t to the next */
  float squared; /* of its length */
} edge;

static struct {
  float (*corner)[3];
  int (*triangle)[3];
  int *next, *previous; /* half-edges of one edge */
  int *edge_of;         /* of a half-edge */
  edge *edge;
  int *heap, *slot; /* edges, the longest first; a hash table of them */
  int corners, triangles, edges, waiting;
  unsigned slots; /* a power of 2 */
} m;

static _Noreturn void stop(const char *text) {
  fprintf(stderr, "refine: %s\n", text);
  exit(2);
}

static void *space(size_t count, size_t size) {
  void *p = calloc(count, size);
  if (p == NULL) {
    stop("out of memory");
  }
  return p;
}

static unsigned mix(uint64_t a, uint64_t b) {
  uint64_t h = (a * 0x9E3779B97F4A7C15U ^ b) * 0xBF58476D1CE4E5B9U;
  return (unsigned)(h >> 32);
}

/* ------------------------------------------------------------------- edges */

static bool longer(int a, int b) {
  float difference = m.edge[a].squared - m.edge[b].squared;
  return difference > 0 || (difference == 0 && a < b);
}

static void push(int e) {
  int at = m.waiting++;
  for (; at > 0 && longer(e, m.heap[(at - 1) / 2]); at = (at - 1) / 2) {
    m.heap[at] = m.heap[(at - 1) / 2];
  }
  m.heap[at] = e;
}

static int pop(void) {
  int top = m.heap[0];
  int last = m.heap[--m.waiting];
  int at = 0;
  for (int child = 1; child < m.waiting; child = 2 * at + 1) {
    child += child + 1 < m.waiting && longer(m.heap[child + 1], m.heap[child]);
    if (!longer(m.heap[child], last)) {
      break;
    }
    m.heap[at] = m.heap[child];
    at = child;
  }
  m.heap[at] = last;
  return top;
}

/* The edge of two corners, which is made if it is new. */
static int edge_between(int a, int b) {
  int low = a < b ? a : b;
  int high = a < b ? b : a;
  unsigned at = mix((uint64_t)low, (uint64_t)high) & (m.slots - 1);
  for (; m.slot[at] != 0; at = (at + 1) & (m.slots - 1)) {
    const edge *e = &m.edge[m.slot[at] - 1];
    if (e->end[0] == low && e->end[1] == high) {
      return m.slot[at] - 1;
    }
  }
  float squared = 0;
  for (int i = 0; i < 3; i++) {
    float d = m.corner[a][i] - m.corner[b][i];
    squared += d * d;
  }
  int e = m.edges++;
  m.edge[e] = (edge){{low, high}, NONE, squared};
  m.slot[at] = e + 1;
  push(e);
  return e;
}

static void join(int half) {
  int t = half / 3;
  int k = half % 3;
  int e = edge_between(m.triangle[t][k], m.triangle[t][(k + 1) % 3]);
  m.edge_of[half] = e;
  m.previous[half] = NONE;
  m.next[half] = m.edge[e].first;
  if (m.next[half] != NONE) {
    m.previous[m.next[half]] = half;
  }
  m.edge[e].first = half;
}

static void leave(int half) {
  int next = m.next[half];
  int previous = m.previous[half];
  if (next != NONE) {
    m.previous[next] = previous;
  }
  if (previous != NONE) {
    m.next[previous] = next;
  } else {
    m.edge[m.edge_of[half]].first = next;
  }
}

/* Triangles (u, v, w) at the edge become (u, middle, w), (middle, v, w). */
static void bisect(int e) {
  int middle = m.corners++;
  for (int i = 0; i < 3; i++) {
    m.corner[middle][i] = (m.corner[m.edge[e].end[0]][i] + m.corner[m.edge[e].end[1]][i]) / 2;
  }
  for (int half = m.edge[e].first; half != NONE;) {
    int after = m.next[half];
    int t = half / 3;
    int k = half % 3;
    int added = m.triangles++;
    int second = 3 * t + (k + 1) % 3;
    leave(second);
    memcpy(m.triangle[added], m.triangle[t], sizeof m.triangle[t]);
    m.triangle[t][(k + 1) % 3] = middle;
    m.triangle[added][k] = middle;
    join(half);
    join(second);
    for (int i = 0; i < 3; i++) {
      join(3 * added + i);
    }
    half = after;
  }
}

/* ------------------------------------------------------------------ meshes */

static int corner_at(const float p[3]) {
  uint32_t bits[3];
  memcpy(bits, p, sizeof bits);
  unsigned at = mix((uint64_t)bits[0] << 32 | bits[1], bits[2]) & (m.slots - 1);
  for (; m.slot[at] != 0; at = (at + 1) & (m.slots - 1)) {
    const float *q = m.corner[m.slot[at] - 1];
    if (q[0] == p[0] && q[1] == p[1] && q[2] == p[2]) {
      return m.slot[at] - 1;
    }
  }
  memcpy(m.corner[m.corners], p, 3 * sizeof *p);
  m.slot[at] = ++m.corners;
  return m.corners - 1;
}

/* Of so many triangles; an edge that is bisected adds one at least. */
static void load(const sepax_soup *mesh, size_t count) {
  size_t most = count + mesh->count; /* the last edge may have many */
  m.corner = space(3 * mesh->count + count, sizeof *m.corner);
  m.triangle = space(most, sizeof *m.triangle);
  m.next = space(3 * most, sizeof *m.next);
  m.previous = space(3 * most, sizeof *m.previous);
  m.edge_of = space(3 * most, sizeof *m.edge_of);
  m.edge = space(3 * most + 2 * count, sizeof *m.edge);
  m.heap = space(3 * most + 2 * count, sizeof *m.heap);
  for (m.slots = 1024; m.slots < 10 * most; m.slots *= 2) {}
  m.slot = space(m.slots, sizeof *m.slot);
  for (size_t t = 0; t < mesh->count; t++) {
    for (int k = 0; k < 3; k++) {
      float p[3];
      for (int i = 0; i < 3; i++) {
        p[i] = (float)mesh->facet[t].v[k][i] + 0.0F; /* no -0 */
      }
      m.triangle[t][k] = corner_at(p);
    }
  }
  memset(m.slot, 0, m.slots * sizeof *m.slot);
  m.triangles = (int)mesh->count;
  for (int half = 0; half < 3 * m.triangles; half++) {
    join(half);
  }
}

static void store(sepax_soup *mesh) {
  mesh->count = (size_t)m.triangles;
  mesh->facet = space(mesh->count, sizeof *mesh->facet);
  for (size_t t = 0; t < mesh->count; t++) {
    for (int k = 0; k < 3; k++) {
      for (int i = 0; i < 3; i++) {
        mesh->facet[t].v[k][i] = (double)m.corner[m.triangle[t][k]][i];
      }
    }
  }
}

int main(int argc, char **argv) {
  sepax_error error = {0};
  sepax_soup mesh;
  char *end = NULL;
  long count = argc == 4 ? strtol(argv[2], &end, 10) : 0;
  if (argc != 4 || *end != '\0' || count < 1 || count > 50000000) {
    stop("usage: refine IN.stl COUNT OUT.stl");
  }
  if (!sepax_stl_read(&mesh, argv[1], false, &error)) {
    stop(error.text);
  }
  load(&mesh, (size_t)count);
  sepax_soup_free(&mesh);
  while (m.triangles < count) {
    bisect(pop());
  }
  store(&mesh);
  if (!sepax_stl_write(&mesh, argv[3], false, &error)) {
    stop(error.text);
  }
  printf("%s: %zu triangles\n", argv[3], mesh.count);
  sepax_soup_free(&mesh);
  free(m.corner);
  free(m.triangle);
  free(m.next);
  free(m.previous);
  free(m.edge_of);
  free(m.edge);
  free(m.heap);
  free(m.slot);
  return 0;
}
