/* volumes.c - the exact verdict from 35 products: the golden model of architecture
 * exact.
 *
 * The signs of the volumes of the tetrahedra of the six vertices decide, and where all
 * are zero the signs of areas in the three coordinate projections and the boxes.
 * Vertices are numbered 0 ... 5, A's first. */
#include "sepax.h"

typedef __int128 wide;

enum { POINTS = 6 };

typedef struct {
  int64_t x[POINTS], y[POINTS], z[POINTS];
} points;

/* g[i][j][k], i < j < k: twice the area of triangle ijk in the projection on x, y. */
typedef struct {
  wide g[POINTS][POINTS][POINTS];
} areas;

static int sign(wide value) { return (value > 0) - (value < 0); }

/* 15 products t_ij, 20 sums. */
static void find_areas(areas *a, const points *p) {
  wide t[POINTS][POINTS];
  for (int i = 0; i < POINTS; i++) {
    for (int j = i + 1; j < POINTS; j++) {
      t[i][j] = (wide)(p->x[j] - p->x[i]) * (p->y[i] + p->y[j]);
    }
  }
  for (int i = 0; i < POINTS; i++) {
    for (int j = i + 1; j < POINTS; j++) {
      for (int k = j + 1; k < POINTS; k++) {
        a->g[i][j][k] = t[i][j] + t[j][k] - t[i][k];
      }
    }
  }
}

/* h[i][j][k], i < j < k: six times the volume of the prism under the triangle. */
typedef struct {
  wide h[POINTS][POINTS][POINTS];
} prisms;

/* 20 products. */
static void find_prisms(prisms *r, const points *p, const areas *a) {
  for (int i = 0; i < POINTS; i++) {
    for (int j = i + 1; j < POINTS; j++) {
      for (int k = j + 1; k < POINTS; k++) {
        r->h[i][j][k] = a->g[i][j][k] * (p->z[i] + p->z[j] + p->z[k]);
      }
    }
  }
}

/* The sign of the volume of tetrahedron i < j < k < l. */
static int volume(const prisms *r, int i, int j, int k, int l) {
  return sign(r->h[j][k][l] - r->h[i][k][l] + r->h[i][j][l] - r->h[i][j][k]);
}

/* Edges (0,1), (1,2), (0,2) of A and the same + 3 of B; the third runs backwards in
 * the cycle, so its signs enter negated. */
static const int edge_from[3] = {0, 1, 0};
static const int edge_to[3] = {1, 2, 2};
static const int edge_turn[3] = {1, 1, -1};

typedef struct {
  int s[3], w[3], d[3][3];
  bool all_zero;
} signs;

static signs signs_of(const prisms *r) {
  signs q = {.all_zero = true};
  for (int k = 0; k < 3; k++) {
    q.s[k] = volume(r, 0, 1, 2, 3 + k);
    q.w[k] = volume(r, k, 3, 4, 5);
    q.all_zero = q.all_zero && q.s[k] == 0 && q.w[k] == 0;
    for (int j = 0; j < 3; j++) {
      q.d[k][j] = edge_turn[k] * edge_turn[j] *
                  volume(r, edge_from[k], edge_to[k], 3 + edge_from[j], 3 + edge_to[j]);
      q.all_zero = q.all_zero && q.d[k][j] == 0;
    }
  }
  return q;
}

/* Three signs of which none is opposite to another. */
static bool agree(int p, int q, int r) {
  bool plus = p > 0 || q > 0 || r > 0;
  bool minus = p < 0 || q < 0 || r < 0;
  return !(plus && minus);
}

static bool edges_meet(const signs *q) {
  for (int e = 0; e < 3; e++) {
    if (q->w[edge_from[e]] != q->w[edge_to[e]] &&
        agree(q->d[e][0], q->d[e][1], q->d[e][2])) {
      return true;
    }
    if (q->s[edge_from[e]] != q->s[edge_to[e]] &&
        agree(q->d[0][e], q->d[1][e], q->d[2][e])) {
      return true;
    }
  }
  return false;
}

/* In one projection: does an edge of one triangle have the other strictly on the side
 * where its own third vertex is not? */
static bool edge_separates(const areas *a, int from, int to, int third, int other) {
  int own = from < third ? (third < to ? -sign(a->g[from][third][to])
                                       : sign(a->g[from][to][third]))
                         : sign(a->g[third][from][to]);
  int side[3];
  for (int k = 0; k < 3; k++) {
    int p = other + k;
    side[k] = sign(other > from ? a->g[from][to][p] : a->g[p][from][to]);
  }
  return side[0] != 0 && side[0] == side[1] && side[1] == side[2] && own != side[0];
}

static bool separated_in_projection(const points *p) {
  areas a;
  find_areas(&a, p);
  for (int e = 0; e < 3; e++) {
    int third = 3 - edge_from[e] - edge_to[e];
    if (edge_separates(&a, edge_from[e], edge_to[e], third, 3) ||
        edge_separates(&a, 3 + edge_from[e], 3 + edge_to[e], 3 + third, 0)) {
      return true;
    }
  }
  return false;
}

static bool apart(const int64_t c[POINTS]) {
  int64_t low[2] = {c[0], c[3]};
  int64_t high[2] = {c[0], c[3]};
  for (int i = 0; i < POINTS; i++) {
    low[i / 3] = c[i] < low[i / 3] ? c[i] : low[i / 3];
    high[i / 3] = c[i] > high[i / 3] ? c[i] : high[i / 3];
  }
  return high[0] < low[1] || high[1] < low[0];
}

/* Coplanar or degenerate: three projections and the boxes. */
static bool separated_in_plane(points *p) {
  if (apart(p->x) || apart(p->y) || apart(p->z)) {
    return true;
  }
  for (int pass = 0; pass < 3; pass++) {
    if (separated_in_projection(p)) {
      return true;
    }
    for (int i = 0; i < POINTS; i++) {
      int64_t x = p->x[i];
      p->x[i] = p->y[i];
      p->y[i] = p->z[i];
      p->z[i] = x;
    }
  }
  return false;
}

bool sepax_volumes(const sepax_tri *a, const sepax_tri *b) {
  points p;
  for (int i = 0; i < POINTS; i++) {
    sepax_vec v = i < 3 ? a->v[i] : b->v[i - 3];
    p.x[i] = v.x;
    p.y[i] = v.y;
    p.z[i] = v.z;
  }
  areas area;
  prisms prism;
  find_areas(&area, &p);
  find_prisms(&prism, &p, &area);
  signs q = signs_of(&prism);
  return q.all_zero ? !separated_in_plane(&p) : edges_meet(&q);
}
