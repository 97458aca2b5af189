/* SPDX-License-Identifier: MIT */
/* ray.c - a ray from a posed point against a triangle, in integers of any size.
 *
 * Point v of A is at x = R_A v + t_A - t_B from B's origin, and adj(R_B) x / det(R_B) in B's
 * coordinates. These are sums of products of doubles, integers times a power of two. det(R_B) > 0
 * goes to the other side: triangles are compared as det(R_B) times their file coordinates.
 *
 * Doubles have exponents from -1074 to 1023. adj(R_B) x has up to 5,400 bits, a cross product of
 * two edges 4,200, and the product of both, the longest number here, fits a big. */
#include "ray.h"
#include "body/number.h"

static const int next[3] = {1, 2, 0};

/* ----------------------------------------------------------------- scaled integers */

static void set(scaled *r, double x) {
  number n = number_of(x);
  r->size.sign = n.sign;
  r->size.limbs = n.sign != 0;
  r->size.limb[0] = n.size;
  r->exponent = n.exponent;
}

static void copy(scaled *r, const scaled *p) {
  big_copy(&r->size, &p->size);
  r->exponent = p->exponent;
}

/* r = p 2^bits. */
static void shift_left(big *r, const big *p, int bits) {
  int at = bits / 64;
  int shift = bits % 64;
  assert(p->limbs + at < BIG_LIMBS);
  uint64_t above = 0;
  for (int i = p->limbs; i >= 0; i--) {
    uint64_t limb = i > 0 ? p->limb[i - 1] : 0;
    r->limb[i + at] = shift > 0 ? above << shift | limb >> (64 - shift) : above;
    above = limb;
  }
  for (int i = 0; i < at; i++) {
    r->limb[i] = 0;
  }
  r->limbs = p->limbs + at + (r->limb[p->limbs + at] != 0);
  r->sign = p->sign;
}

/* r = p + sign q; r may be p. */
static void add(scaled *r, const scaled *p, const scaled *q, int sign) {
  if (p->size.sign == 0 || q->size.sign == 0) {
    int q_sign = sign * q->size.sign;
    bool only_p = q_sign == 0;
    copy(r, only_p ? p : q);
    r->size.sign = only_p ? r->size.sign : q_sign;
    return;
  }
  scaled moved = {0};
  bool p_higher = p->exponent > q->exponent;
  const scaled *high = p_higher ? p : q;
  const scaled *low = p_higher ? q : p;
  shift_left(&moved.size, &high->size, high->exponent - low->exponent);
  r->exponent = low->exponent;
  big_add_signed(&r->size, p_higher ? &moved.size : &p->size, p_higher ? &q->size : &moved.size,
                 sign * q->size.sign);
}

/* r = p q; r is neither. */
static void multiply(scaled *r, const scaled *p, const scaled *q) {
  big_multiply(&r->size, &p->size, &q->size);
  r->exponent = p->exponent + q->exponent;
}

/* r += sign p q. */
static void add_product(scaled *r, const scaled *p, const scaled *q, int sign) {
  scaled product = {0};
  multiply(&product, p, q);
  add(r, r, &product, sign);
}

/* r = p q - s t. */
static void subtract_products(scaled *r, const scaled *p, const scaled *q, const scaled *s,
                              const scaled *t) {
  multiply(r, p, q);
  add_product(r, s, t, -1);
}

/* --------------------------------------------------------------------- the point */

static void find_posed(scaled x[3], const double v[3], const sepax_pose *own,
                       const sepax_pose *other) {
  scaled p = {0};
  scaled q = {0};
  for (int i = 0; i < 3; i++) {
    set(&x[i], own != NULL ? own->translation[i] : v[i]);
    for (int k = 0; k < 3 && own != NULL; k++) {
      set(&p, own->rotation[i][k]);
      set(&q, v[k]);
      add_product(&x[i], &p, &q, 1);
    }
    if (other != NULL) {
      set(&p, other->translation[i]);
      add(&x[i], &x[i], &p, -1);
    }
  }
}

void sepax__find_exact_point(exact_point *p, const double v[3], const sepax_pose *own,
                             const sepax_pose *other) {
  if (other == NULL) {
    find_posed(p->c, v, own, other);
    set(&p->over, 1);
    return;
  }
  scaled x[3] = {0};
  scaled r[3][3] = {0};
  scaled cofactor = {0};
  find_posed(x, v, own, other);
  for (int k = 0; k < 9; k++) {
    set(&r[k / 3][k % 3], other->rotation[k / 3][k % 3]);
  }
  set(&p->over, 0);
  for (int i = 0; i < 3; i++) {
    int i1 = next[i];
    int i2 = next[i1];
    set(&p->c[i], 0);
    for (int j = 0; j < 3; j++) {
      int j1 = next[j];
      int j2 = next[j1];
      subtract_products(&cofactor, &r[j1][i1], &r[j2][i2], &r[j1][i2], &r[j2][i1]);
      add_product(&p->c[i], &cofactor, &x[j], 1);
      if (i == 0) {
        add_product(&p->over, &r[j][0], &cofactor, 1);
      }
    }
  }
}

/* ------------------------------------------------------------------- the triangle */

/* The triangle's edges, and its vertices from the point, times `over`. */
typedef struct {
  scaled edge[3][3], from[3][3];
} seen;

static void look(seen *s, const exact_point *p, const double t[3][3]) {
  scaled v[3][3] = {0};
  for (int k = 0; k < 3; k++) {
    for (int i = 0; i < 3; i++) {
      set(&v[k][i], t[k][i]);
      multiply(&s->from[k][i], &v[k][i], &p->over);
      add(&s->from[k][i], &s->from[k][i], &p->c[i], -1);
    }
  }
  for (int k = 0; k < 3; k++) {
    for (int i = 0; i < 3; i++) {
      add(&s->edge[k][i], &v[next[k]][i], &v[k][i], -1);
    }
  }
}

/* Seen along the ray, does a second ray from it, in direction axis + 1, meet edge k? */
static bool passes(const seen *s, int k, int axis) {
  int x = next[axis];
  int y = next[x];
  bool up = s->from[next[k]][y].size.sign > 0;
  if (up == (s->from[k][y].size.sign > 0)) {
    return false;
  }
  scaled side = {0};
  subtract_products(&side, &s->edge[k][y], &s->from[k][x], &s->edge[k][x], &s->from[k][y]);
  return up ? side.size.sign > 0 : side.size.sign < 0;
}

int sepax__exact_ray_meets(const exact_point *p, int axis, int way, const double t[3][3]) {
  seen s = {0};
  look(&s, p, t);
  bool within = false;
  for (int k = 0; k < 3; k++) {
    within ^= passes(&s, k, axis);
  }
  if (!within) {
    return 0;
  }
  scaled normal[3];
  scaled height;
  for (int i = 0; i < 3; i++) {
    int i1 = next[i];
    int i2 = next[i1];
    subtract_products(&normal[i], &s.edge[0][i1], &s.edge[1][i2], &s.edge[0][i2], &s.edge[1][i1]);
  }
  set(&height, 0);
  for (int i = 0; i < 3; i++) {
    add_product(&height, &normal[i], &s.from[0][i], 1);
  }
  int facing = normal[axis].size.sign;
  return height.size.sign * facing * way > 0 ? facing : 0;
}
