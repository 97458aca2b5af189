/* paper.c - the bit-accurate models of architecture `paper`, Algorithm 1 in the
 * fixed-point formats of the design, and of `conference`, the machine before it. Every intermediate
 * is exact, then floored to the bits that its format keeps. The hardware tries all axes at once;
 * the first separating one decides here, so the verdict is the same. */
#include "sepax_design.h"

#include <assert.h>

typedef __int128 wide;

typedef struct {
  wide c[3];
} components;

typedef struct {
  wide a[3], b[3];
} projections;

typedef struct {
  const sepax_design *design;
  sepax_verdict verdict;
} machine;

static wide keep(const machine *m, sepax_format_id id, wide exact) {
  const sepax_format *f = &m->design->format[id];
  wide half = (wide)1 << (f->exact - 1);
  assert(-half <= exact && exact < half);
  (void)half;
  return exact >> f->shift;
}

static components from_vec(sepax_vec v) { return (components){{v.x, v.y, v.z}}; }

/* The inner product of a vertex and an axis: three multiplications. */
static wide project(machine *m, sepax_vec vertex, const components *axis, sepax_format_id product,
                    sepax_format_id sum) {
  components v = from_vec(vertex);
  wide total = 0;
  for (int i = 0; i < 3; i++) {
    total += keep(m, product, v.c[i] * axis->c[i]);
  }
  m->verdict.mul_project += 3;
  return keep(m, sum, total);
}

static projections project_pair(machine *m, const sepax_pair *pair, const components *axis,
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

/* Inequality (4) or (5); touching intervals are not apart. */
static bool apart(const machine *m, const projections *p) {
  bool a_above_b = least(p->a) > greatest(p->b);
  bool a_below_b = m->design->config.inequality == SEPAX_INEQUALITY_PRINTED
                       ? greatest(p->a) > least(p->b)
                       : greatest(p->a) < least(p->b);
  return a_above_b || a_below_b;
}

static bool near(const machine *m, const wide p[3], const wide q[3]) {
  for (int k = 0; k < 3; k++) {
    wide difference = p[k] > q[k] ? p[k] - q[k] : q[k] - p[k];
    if (difference >= m->design->coplanar_limit) {
      return false;
    }
  }
  return true;
}

static components edge_of(const machine *m, const sepax_tri *tri, int i) {
  components from = from_vec(tri->v[i]);
  components to = from_vec(tri->v[(i + 1) % 3]);
  components edge;
  for (int k = 0; k < 3; k++) {
    edge.c[k] = keep(m, SEPAX_F_EDGE, to.c[k] - from.c[k]);
  }
  return edge;
}

/* Bits by which all three components can move left and still fit `bits`. */
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
static components axis_of(machine *m, const components *p, const components *q) {
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
  components axis;
  for (int k = 0; k < 3; k++) {
    axis.c[k] = keep(m, SEPAX_F_AXIS, exact[k] * ((wide)1 << left));
  }
  return axis;
}

static bool axis_separates(machine *m, const sepax_pair *pair, const components *p,
                           const components *q) {
  components axis = axis_of(m, p, q);
  projections on_axis = project_pair(m, pair, &axis, SEPAX_F_PRODUCT, SEPAX_F_PROJECTION);
  return apart(m, &on_axis);
}

/* The number of the first separating axis of table 2 (coplanar) or table 1, or 0. */
static int first_separating(machine *m, const sepax_pair *pair) {
  components normal[2] = {from_vec(pair->na), from_vec(pair->nb)};
  int rows = m->verdict.coplanar ? 2 : 3;
  for (int row = 0; row < rows; row++) {
    for (int column = 0; column < 3; column++) {
      components p = m->verdict.coplanar ? normal[row] : edge_of(m, &pair->a, row);
      bool edge_of_a = m->verdict.coplanar && row == 0;
      components q = edge_of(m, edge_of_a ? &pair->a : &pair->b, column);
      if (axis_separates(m, pair, &p, &q)) {
        return 3 * row + column + 1;
      }
    }
  }
  return 0;
}

sepax_verdict sepax_paper(const sepax_design *design, const sepax_pair *pair) {
  machine m = {.design = design};
  components na = from_vec(pair->na);
  components nb = from_vec(pair->nb);
  projections on_na =
      project_pair(&m, pair, &na, SEPAX_F_NORMAL_PRODUCT, SEPAX_F_NORMAL_PROJECTION);
  projections on_nb =
      project_pair(&m, pair, &nb, SEPAX_F_NORMAL_PRODUCT, SEPAX_F_NORMAL_PROJECTION);
  m.verdict.coplanar = design->config.coplanarity == SEPAX_COPLANAR_PLANE
                           ? near(&m, on_na.b, on_na.a)
                           : near(&m, on_na.a, on_nb.b);
  if (apart(&m, &on_na)) {
    m.verdict.axis = 10;
  } else if (apart(&m, &on_nb)) {
    m.verdict.axis = 11;
  } else {
    m.verdict.axis = first_separating(&m, pair);
  }
  m.verdict.collision = m.verdict.axis == 0;
  return m.verdict;
}

/* Coplanar by six inner products of its own, which no other step uses. */
static bool coplanar_alone(machine *m, const sepax_pair *pair, const components normal[2]) {
  bool plane = m->design->config.coplanarity == SEPAX_COPLANAR_PLANE;
  wide of_a[3];
  wide of_b[3];
  for (int k = 0; k < 3; k++) {
    of_a[k] =
        project(m, pair->a.v[k], &normal[0], SEPAX_F_NORMAL_PRODUCT, SEPAX_F_NORMAL_PROJECTION);
    of_b[k] = project(m, pair->b.v[k], &normal[plane ? 0 : 1], SEPAX_F_NORMAL_PRODUCT,
                      SEPAX_F_NORMAL_PROJECTION);
  }
  return near(m, of_a, of_b);
}

sepax_verdict sepax_conference(const sepax_design *design, const sepax_pair *pair) {
  machine m = {.design = design};
  const components normal[2] = {from_vec(pair->na), from_vec(pair->nb)};
  m.verdict.coplanar = coplanar_alone(&m, pair, normal);
  for (int i = 0; i < 2 && !m.verdict.coplanar && m.verdict.axis == 0; i++) {
    projections p =
        project_pair(&m, pair, &normal[i], SEPAX_F_NORMAL_PRODUCT, SEPAX_F_NORMAL_PROJECTION);
    m.verdict.axis = apart(&m, &p) ? 10 + i : 0;
  }
  if (m.verdict.axis == 0) {
    m.verdict.axis = first_separating(&m, pair);
  }
  m.verdict.collision = m.verdict.axis == 0;
  return m.verdict;
}

/* -1 apart, 0 within the extents if there are any, 1 beyond one. */
static int judge_boxes(const sepax_design *design, const sepax_pair *pair) {
  const sepax_config *c = &design->config;
  int beyond = 0;
  for (int axis = 0; axis < 3; axis++) {
    int64_t low[2] = {INT64_MAX, INT64_MAX};
    int64_t high[2] = {INT64_MIN, INT64_MIN};
    for (int i = 0; i < 6; i++) {
      const sepax_vec *v = i < 3 ? &pair->a.v[i] : &pair->b.v[i - 3];
      int64_t at = axis == 0 ? v->x : axis == 1 ? v->y : v->z;
      low[i / 3] = at < low[i / 3] ? at : low[i / 3];
      high[i / 3] = at > high[i / 3] ? at : high[i / 3];
    }
    if (low[1] - high[0] > design->margin[1] || low[0] - high[1] > design->margin[1]) {
      return -1;
    }
    beyond |= c->extent_a > 0 && (high[0] - low[0] > c->extent_a || high[1] - low[1] > c->extent_b);
  }
  return beyond;
}

static sepax_verdict judge_exact(const sepax_design *design, const sepax_pair *pair) {
  int boxes = design->aabb_test ? judge_boxes(design, pair) : 0;
  if (boxes != 0) {
    return (sepax_verdict){.collision = boxes > 0,
                           .axis = boxes > 0 ? SEPAX_AXIS_EXTENT : SEPAX_AXIS_AABB,
                           .band = boxes > 0 && design->limits > 0 ? SEPAX_BAND_COLLISION
                                                                   : SEPAX_BAND_FREE};
  }
  if (design->limits > 0) {
    return sepax_clearance(design, &pair->a, &pair->b);
  }
  sepax_verdict verdict = sepax_exact(&pair->a, &pair->b);
  if (verdict.coplanar && design->config.flag) {
    return (sepax_verdict){.collision = true, .coplanar = true};
  }
  return verdict;
}

sepax_verdict sepax_judge(const sepax_design *design, const sepax_pair *pair) {
  switch (design->config.arch) {
  case SEPAX_ARCH_PAPER:
    return sepax_paper(design, pair);
  case SEPAX_ARCH_CONFERENCE:
    return sepax_conference(design, pair);
  case SEPAX_ARCH_REFERENCE:
    return (sepax_verdict){.collision = sepax_reference(&pair->a, &pair->b)};
  case SEPAX_ARCH_FLOAT32:
    return (sepax_verdict){.collision = sepax_float32(&pair->a, &pair->b)};
  case SEPAX_ARCH_FLOAT64:
    return (sepax_verdict){.collision = sepax_float64(&pair->a, &pair->b)};
  case SEPAX_ARCH_INTERVAL32:
    return (sepax_verdict){.collision = sepax_interval32(&pair->a, &pair->b)};
  case SEPAX_ARCH_INTERVAL64:
    return (sepax_verdict){.collision = sepax_interval64(&pair->a, &pair->b)};
  case SEPAX_ARCH_EXACT:
  default:
    return judge_exact(design, pair);
  }
}
