/* SPDX-License-Identifier: MIT */
/* paper.c - the bit-accurate models of architecture `paper`, Algorithm 1 in the fixed-point formats
 * of the design, and of `conference`, its predecessor. Each intermediate is exact, then floored to
 * the bits that its format keeps. The hardware tries all axes at once; here the first separating
 * axis decides, which gives the same verdict. */
#include "design/paper.h"
#include "util/wide.h"

#include <assert.h>

typedef struct {
  wide a[3], b[3];
} projections;

typedef struct {
  const sepax_design *design;
  sepax_judgement verdict;
} model;

static wide keep(const model *m, sepax_format_id id, wide exact) {
  const sepax_format *f = &m->design->format[id];
  wide half = (wide)1 << (f->exact - 1);
  assert(-half <= exact && exact < half);
  (void)half;
  return exact >> f->shift;
}

/* The inner product of a vertex and an axis: three multiplications. */
static wide project(model *m, sepax_vec vertex, const wide_vec *axis, sepax_format_id product,
                    sepax_format_id sum) {
  wide_vec v = wide_from(vertex);
  wide total = 0;
  for (int i = 0; i < 3; i++) {
    total += keep(m, product, v.c[i] * axis->c[i]);
  }
  m->verdict.mul_project += 3;
  return keep(m, sum, total);
}

static projections project_pair(model *m, const sepax_pair *pair, const wide_vec *axis,
                                sepax_format_id product, sepax_format_id sum) {
  projections p;
  for (int k = 0; k < 3; k++) {
    p.a[k] = project(m, pair->a.v[k], axis, product, sum);
    p.b[k] = project(m, pair->b.v[k], axis, product, sum);
  }
  return p;
}

static wide least(const wide p[3]) {
  wide low = p[0] < p[1] ? p[0] : p[1];
  return low < p[2] ? low : p[2];
}

static wide greatest(const wide p[3]) {
  wide high = p[0] > p[1] ? p[0] : p[1];
  return high > p[2] ? high : p[2];
}

/* Inequality (4) or (5); touching intervals are not disjoint. */
static bool disjoint(const model *m, const projections *p) {
  bool a_above_b = least(p->a) > greatest(p->b);
  bool a_below_b = m->design->config.inequality == SEPAX_INEQUALITY_PRINTED
                       ? greatest(p->a) > least(p->b)
                       : greatest(p->a) < least(p->b);
  return a_above_b || a_below_b;
}

static wide_vec edge_of(const model *m, const sepax_tri *tri, int i) {
  wide_vec from = wide_from(tri->v[i]);
  wide_vec to = wide_from(tri->v[(i + 1) % 3]);
  wide_vec edge;
  for (int k = 0; k < 3; k++) {
    edge.c[k] = keep(m, SEPAX_F_EDGE, to.c[k] - from.c[k]);
  }
  return edge;
}

/* The number of bits by which all three components can move left and still fit `bits`. */
static int common_headroom(const wide c[3], int bits) {
  int headroom = bits - 1;
  for (int k = 0; k < 3; k++) {
    wide value = c[k] < 0 ? ~c[k] : c[k];
    int unused = bits - 1;
    while (value != 0) {
      value >>= 1;
      unused--;
    }
    headroom = unused < headroom ? unused : headroom;
  }
  return headroom;
}

/* The cross product of two operands as an axis: six multiplications. */
static wide_vec axis_of(model *m, const wide_vec *p, const wide_vec *q) {
  wide exact[3];
  for (int k = 0; k < 3; k++) {
    int i = (k + 1) % 3;
    int j = (k + 2) % 3;
    exact[k] = keep(m, SEPAX_F_CROSS_PRODUCT, p->c[i] * q->c[j]) -
               keep(m, SEPAX_F_CROSS_PRODUCT, p->c[j] * q->c[i]);
  }
  m->verdict.mul_axes += 6;
  int left = 0;
  if (m->design->config.block_float) {
    left = common_headroom(exact, m->design->format[SEPAX_F_AXIS].exact);
  }
  wide_vec axis;
  for (int k = 0; k < 3; k++) {
    axis.c[k] = keep(m, SEPAX_F_AXIS, exact[k] * ((wide)1 << left));
  }
  return axis;
}

static bool axis_separates(model *m, const sepax_pair *pair, const wide_vec *p, const wide_vec *q) {
  wide_vec axis = axis_of(m, p, q);
  projections on_axis = project_pair(m, pair, &axis, SEPAX_F_PRODUCT, SEPAX_F_PROJECTION);
  return disjoint(m, &on_axis);
}

/* The first separating axis of table 2 (coplanar pairs) or of table 1 (others). */
static int first_separating(model *m, const sepax_pair *pair) {
  wide_vec normal[2] = {wide_from(pair->na), wide_from(pair->nb)};
  int rows = m->verdict.coplanar ? 2 : 3;
  for (int row = 0; row < rows; row++) {
    for (int column = 0; column < 3; column++) {
      wide_vec p = m->verdict.coplanar ? normal[row] : edge_of(m, &pair->a, row);
      bool edge_of_a = m->verdict.coplanar && row == 0;
      wide_vec q = edge_of(m, edge_of_a ? &pair->a : &pair->b, column);
      if (axis_separates(m, pair, &p, &q)) {
        return SEPAX_AXIS_EDGES + 3 * row + column;
      }
    }
  }
  return SEPAX_AXIS_NONE;
}

sepax_judgement sepax_paper(const sepax_design *design, const sepax_pair *pair) {
  model m = {.design = design};
  wide_vec na = wide_from(pair->na);
  wide_vec nb = wide_from(pair->nb);
  projections on_na =
      project_pair(&m, pair, &na, SEPAX_F_NORMAL_PRODUCT, SEPAX_F_NORMAL_PROJECTION);
  projections on_nb =
      project_pair(&m, pair, &nb, SEPAX_F_NORMAL_PRODUCT, SEPAX_F_NORMAL_PROJECTION);
  m.verdict.coplanar = design->config.coplanarity == SEPAX_COPLANAR_PLANE
                           ? sepax__paper_coplanar(design, on_na.b, on_na.a)
                           : sepax__paper_coplanar(design, on_na.a, on_nb.b);
  if (disjoint(&m, &on_na)) {
    m.verdict.axis = SEPAX_AXIS_NORMAL_A;
  } else if (disjoint(&m, &on_nb)) {
    m.verdict.axis = SEPAX_AXIS_NORMAL_B;
  } else {
    m.verdict.axis = first_separating(&m, pair);
  }
  m.verdict.collision = m.verdict.axis == SEPAX_AXIS_NONE;
  return m.verdict;
}

/* The coplanarity test of conference: six inner products that no other step uses. */
static bool coplanar_alone(model *m, const sepax_pair *pair, const wide_vec normal[2]) {
  bool plane = m->design->config.coplanarity == SEPAX_COPLANAR_PLANE;
  wide of_a[3];
  wide of_b[3];
  for (int k = 0; k < 3; k++) {
    of_a[k] =
        project(m, pair->a.v[k], &normal[0], SEPAX_F_NORMAL_PRODUCT, SEPAX_F_NORMAL_PROJECTION);
    of_b[k] = project(m, pair->b.v[k], &normal[plane ? 0 : 1], SEPAX_F_NORMAL_PRODUCT,
                      SEPAX_F_NORMAL_PROJECTION);
  }
  return sepax__paper_coplanar(m->design, of_a, of_b);
}

sepax_judgement sepax_conference(const sepax_design *design, const sepax_pair *pair) {
  model m = {.design = design};
  const wide_vec normal[2] = {wide_from(pair->na), wide_from(pair->nb)};
  m.verdict.coplanar = coplanar_alone(&m, pair, normal);
  for (int i = 0; i < 2 && !m.verdict.coplanar && m.verdict.axis == SEPAX_AXIS_NONE; i++) {
    projections p =
        project_pair(&m, pair, &normal[i], SEPAX_F_NORMAL_PRODUCT, SEPAX_F_NORMAL_PROJECTION);
    m.verdict.axis = disjoint(&m, &p) ? SEPAX_AXIS_NORMAL_A + i : SEPAX_AXIS_NONE;
  }
  if (m.verdict.axis == SEPAX_AXIS_NONE) {
    m.verdict.axis = first_separating(&m, pair);
  }
  m.verdict.collision = m.verdict.axis == SEPAX_AXIS_NONE;
  return m.verdict;
}
