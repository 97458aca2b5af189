/* exact.c - the golden model of architecture exact: the mathematical verdict from 34 products and
 * the signs of their sums.
 *
 * Vertices 0 ... 2 are A's, 3 ... 5 B's. With
 *   t_ij  = (x_j - x_i)(y_i + y_j)                       trapezoid terms, 15 products
 *   g_ijk = t_ij + t_jk + t_ki                           20 orient2d of the projection on x, y
 *   h_ijk = g_ijk (z_i + z_j + z_k - z_0 - z_1 - z_2)    prism volumes, 19 products; h_012 = 0
 * orient3d of each of the 15 tetrahedra is an alternating sum of four h. The signs of orient3d
 * decide, unless all are zero. Then one plane holds the six vertices, and the signs of orient2d
 * decide in the first coordinate projection that does not flatten this plane. If all projections
 * do, one line holds the vertices and the AABBs decide.
 *
 * Coordinates of up to 20 bits are judged in 64 bits, longer ones in 128. */
#include "util/aabb.h"

static const int next[3] = {1, 2, 0};

/* Signs of orient3d, all negated in common: of N_A.(B_k - A_0), of N_B.(A_k - B_0) and of
 * (e_i x f_j).(B_j - A_i), where e_i is the edge from A_i to A_i+1, f_j that from B_j to B_j+1. */
typedef struct {
  int s[3], w[3], d[3][3];
} orient3d_signs;

/* Signs of orient2d, as in exact_sums.h. */
typedef struct {
  int own_a, own_b, a[3][3], b[3][3];
} orient2d_signs;

static bool zeros(const int sign[3]) { return (sign[0] | sign[1] | sign[2]) == 0; }

static bool zero_matrix(const int sign[3][3]) {
  return zeros(sign[0]) && zeros(sign[1]) && zeros(sign[2]);
}

static bool all_zero_3d(const orient3d_signs *v) {
  return zeros(v->s) && zeros(v->w) && zero_matrix(v->d);
}

static bool all_zero_2d(const orient2d_signs *s) {
  return s->own_a == 0 && s->own_b == 0 && zero_matrix(s->a) && zero_matrix(s->b);
}

static bool one_side(const int sign[3]) {
  return sign[0] != 0 && sign[0] == sign[1] && sign[0] == sign[2];
}

/* Axis e_i x f_j separates: f_j crosses A's plane upwards, e_i crosses B's plane, and B is on the
 * outer side of A's edge; or all three the other way round. */
static bool edges_separate(const orient3d_signs *v, int i, int j) {
  int d = v->d[i][j];
  return d != 0 && d * v->s[j] <= 0 && d * v->s[next[j]] >= 0 && d * v->w[i] <= 0 &&
         d * v->w[next[i]] >= 0;
}

static int axis_in_space(const orient3d_signs *v) {
  if (one_side(v->s)) {
    return SEPAX_AXIS_NORMAL_A;
  }
  if (one_side(v->w)) {
    return SEPAX_AXIS_NORMAL_B;
  }
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      if (edges_separate(v, i, j)) {
        return SEPAX_AXIS_EDGES + 3 * i + j;
      }
    }
  }
  return SEPAX_AXIS_NONE;
}

/* The other triangle is strictly on one side of some edge, and the third vertex of the edge's own
 * triangle is not on this side. */
static bool edge_separates(const orient2d_signs *s) {
  for (int i = 0; i < 3; i++) {
    if ((one_side(s->a[i]) && s->a[i][0] != s->own_a) ||
        (one_side(s->b[i]) && s->b[i][0] != s->own_b)) {
      return true;
    }
  }
  return false;
}

static bool aabbs_disjoint(const sepax_tri *a, const sepax_tri *b) {
  aabb p = aabb_of(a);
  aabb q = aabb_of(b);
  return aabb_disjoint(&p, &q, 0);
}

static sepax_verdict judged(bool coplanar, int axis) {
  return (sepax_verdict){.collision = axis == SEPAX_AXIS_NONE, .coplanar = coplanar, .axis = axis};
}

/* Unrolled, the sums take half the time. */
#define UNROLL _Pragma("GCC unroll 3")

#define NUMBER uint64_t
#define NAME(name) name##_64
#include "exact_sums.h"
#undef NUMBER
#undef NAME

#define NUMBER unsigned __int128
#define NAME(name) name##_128
#include "exact_sums.h"
#undef NUMBER
#undef NAME

static bool fits_20_bits(const sepax_tri *tri) {
  const uint32_t half = (uint32_t)1 << 19;
  uint32_t biased = 0;
  for (int k = 0; k < 3; k++) {
    sepax_vec v = tri->v[k];
    biased |= ((uint32_t)v.x + half) | ((uint32_t)v.y + half) | ((uint32_t)v.z + half);
  }
  return biased >> 20 == 0;
}

sepax_verdict sepax_exact(const sepax_tri *a, const sepax_tri *b) {
  return fits_20_bits(a) && fits_20_bits(b) ? verdict_64(a, b) : verdict_128(a, b);
}
