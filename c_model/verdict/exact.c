/* exact.c - the golden model of architecture exact: the mathematical verdict from 34
 * products and the signs of their sums.
 *
 * Vertices 0 ... 2 are A's, 3 ... 5 B's. With
 *   t_ij  = (x_j - x_i)(y_i + y_j)                               15 products
 *   g_ijk = t_ij + t_jk + t_ki                                   20 areas
 *   h_ijk = g_ijk (z_i + z_j + z_k - z_0 - z_1 - z_2)            19 products; h_012 = 0
 * the volumes of the 15 tetrahedra are alternating sums of four h. Their signs decide
 * unless all are zero: then the six vertices are in a plane, and the signs of the areas
 * decide in the first projection on coordinates that does not flatten it, or, if all do,
 * the vertices are on a line and the boxes decide.
 *
 * Coordinates of up to 20 bits are judged in 64 bits, longer ones in 128. */
#include "sepax.h"

enum { AXIS_NORMAL_A = 10, AXIS_NORMAL_B = 11, AXIS_IN_PLANE = 12 };

static const int next[3] = {1, 2, 0};

/* Signs, all negated in common, of N_A.(B_k - A_0), N_B.(A_k - B_0) and
 * (e_i x f_j).(B_j - A_i), where e_i is the edge from A_i to A_i+1, f_j from B_j. */
typedef struct {
  int s[3], w[3], d[3][3];
} volume_signs;

/* Signs of areas, as in exact_sums.h. */
typedef struct {
  int own_a, own_b, a[3][3], b[3][3];
} area_signs;

static bool zeros(const int sign[3]) { return (sign[0] | sign[1] | sign[2]) == 0; }

static bool zero_matrix(const int sign[3][3]) {
  return zeros(sign[0]) && zeros(sign[1]) && zeros(sign[2]);
}

static bool all_zero(const volume_signs *v) {
  return zeros(v->s) && zeros(v->w) && zero_matrix(v->d);
}

static bool no_area(const area_signs *s) {
  return s->own_a == 0 && s->own_b == 0 && zero_matrix(s->a) && zero_matrix(s->b);
}

static bool one_side(const int sign[3]) {
  return sign[0] != 0 && sign[0] == sign[1] && sign[0] == sign[2];
}

/* Axis e_i x f_j: B lies beyond A's edge, where f_j crosses A's plane upwards and e_i
 * crosses B's; or all of it the other way round. */
static bool edges_separate(const volume_signs *v, int i, int j) {
  int d = v->d[i][j];
  return d != 0 && d * v->s[j] <= 0 && d * v->s[next[j]] >= 0 && d * v->w[i] <= 0 &&
         d * v->w[next[i]] >= 0;
}

static int axis_in_space(const volume_signs *v) {
  if (one_side(v->s)) {
    return AXIS_NORMAL_A;
  }
  if (one_side(v->w)) {
    return AXIS_NORMAL_B;
  }
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      if (edges_separate(v, i, j)) {
        return 1 + 3 * i + j;
      }
    }
  }
  return 0;
}

/* An edge has the other triangle strictly on the side where its own third vertex is not. */
static bool edge_separates(const area_signs *s) {
  for (int i = 0; i < 3; i++) {
    if ((one_side(s->a[i]) && s->a[i][0] != s->own_a) ||
        (one_side(s->b[i]) && s->b[i][0] != s->own_b)) {
      return true;
    }
  }
  return false;
}

static bool apart(int32_t a0, int32_t a1, int32_t a2, int32_t b0, int32_t b1, int32_t b2) {
  return (a0 < b0 && a0 < b1 && a0 < b2 && a1 < b0 && a1 < b1 && a1 < b2 && a2 < b0 && a2 < b1 &&
          a2 < b2) ||
         (a0 > b0 && a0 > b1 && a0 > b2 && a1 > b0 && a1 > b1 && a1 > b2 && a2 > b0 && a2 > b1 &&
          a2 > b2);
}

static bool boxes_apart(const sepax_tri *a, const sepax_tri *b) {
  const sepax_vec *p = a->v;
  const sepax_vec *q = b->v;
  return apart(p[0].x, p[1].x, p[2].x, q[0].x, q[1].x, q[2].x) ||
         apart(p[0].y, p[1].y, p[2].y, q[0].y, q[1].y, q[2].y) ||
         apart(p[0].z, p[1].z, p[2].z, q[0].z, q[1].z, q[2].z);
}

static sepax_verdict judged(bool coplanar, int axis) {
  return (sepax_verdict){.collision = axis == 0, .coplanar = coplanar, .axis = axis};
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
