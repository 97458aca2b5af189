/* SPDX-License-Identifier: MIT */
/* support.c - a proof by one direction that two bodies are apart.
 *
 * On the direction w the nearest triangles so far leave a gap. What it is more than is needed is to
 * spare. Each body is searched for vertices that are beyond its nearest triangle: nodes that, by
 * their boxes in doubles, clearly take no more than is taken already are passed over; triangles in
 * doubt are looked at in twofold numbers. What the first body takes is no longer to spare for the
 * second.
 *
 * Errors. Let u = 2^-53. In the unit of the search coordinates and translations are at most 1, so a
 * point is at most sqrt(3) from the origin before the rotation and 3.5 after it. All errors are in
 * terms of |w|. A coordinate of R^T w is a sum of three products that are below 1.01 together:
 * wrong by 12 u^2, which makes 36 u^2 of a vertex. The products of R^T w and a vertex are
 * below 1.75 together, as are those of w and the translation: each sum is wrong by 20 u^2, and
 * their sum by 11 u^2 more. So a vertex on w is wrong by 87 u^2. A gap of two of them, below 7, is
 * wrong by 174 u^2, and by 21 u^2 for each of five differences; |w| times what is needed is wrong
 * by 15 u^2 of 7. That is less than 400 u^2, and PROOF_ERROR is 2^10 u^2.
 *
 * In doubles a coordinate of the way is wrong by u of itself, a centre or a vertex by less than 2
 * u, and their sum of products, with the origin, by 18 u. The end of the nearest triangle is
 * rounded by 4 u, and its difference by 7 u. The half sides, below 0.9 each, reach out by less
 * than 2.7, which is wrong by 21 u. Sum and difference with what is taken round by 10 u each. That
 * is less than 70 u of |w|, which is at most sqrt(3): 2^-46. DOUBLE_ERROR is more than all that. */
#include "support.h"

#include "util/vector.h"

#define PROOF_ERROR 0x1p-96
#define DOUBLE_ERROR 0x1p-44
#define HARDLY 0x1p-40

enum { STACK = 1024 }; /* each of 64 levels leaves up to seven nodes */

/* One body on the way. */
typedef struct {
  const search *s;
  int body;
  bool high;            /* does this side of the body look to greater numbers? */
  double way[3], rough; /* the way in the body's coordinates and its origin on it, in doubles */
  twofold taken, spare; /* how far beyond the nearest triangle vertices are, and may be */
  uint32_t beyond;      /* box of a triangle that is beyond all that is to spare */
} side;

static twofold end_of(const side *r) { return r->s->proof.end[r->body]; }

static twofold at_vertex(const side *r, const double v[3]) {
  const double unit = r->s->pose[r->body].unit;
  const twofold_vector scaled = {{{v[0] * unit, 0}, {v[1] * unit, 0}, {v[2] * unit, 0}}};
  const direction_proof *p = &r->s->proof;
  return twofold_add(p->shift[r->body], twofold_dot(&p->turned[r->body], &scaled));
}

/* Of the vertex of a triangle that is farthest out. */
static twofold outermost(const side *r, const double v[3][3]) {
  twofold most = at_vertex(r, v[0]);
  for (int k = 1; k < 3; k++) {
    twofold at = at_vertex(r, v[k]);
    most = r->high == twofold_less(most, at) ? at : most;
  }
  return most;
}

/* Does something that reaches `reach` to both sides of `at` clearly take no more? */
static bool clearly_within(const side *r, double at, double reach) {
  double out = r->high ? at - end_of(r).high : end_of(r).high - at;
  return out + reach <= r->taken.high - DOUBLE_ERROR;
}

static bool node_is_within(const side *r, uint32_t node) {
  const sepax_body *b = r->s->body[r->body];
  const body_frame *f = &b->frame[node];
  const double unit = r->s->pose[r->body].unit;
  const double size = r->s->size[r->body];
  double at = r->rough;
  double reach = 0;
  for (int i = 0; i < 3; i++) {
    at += r->way[i] * (b->centre[i] * unit + size * f->centre[i]);
    reach += fabs(vector_dot(f->axis[i], r->way)) * f->half[i] * size;
  }
  return clearly_within(r, at, reach);
}

/* How far a point is beyond the end. */
static twofold beyond_end(const side *r, twofold at) {
  return r->high ? twofold_subtract(at, end_of(r)) : twofold_subtract(end_of(r), at);
}

/* Do all triangles of a node take no more, by the node's exact AABB? On a face parallel to two axes
 * that says as much as the triangles themselves. */
static bool aabb_is_within(const side *r, uint32_t node) {
  const body_frame *f = &r->s->body[r->body]->frame[node];
  double corner[3];
  for (int i = 0; i < 3; i++) {
    corner[i] = f->aabb[r->high == (r->way[i] > 0)][i];
  }
  return !twofold_less(r->taken, beyond_end(r, at_vertex(r, corner)));
}

/* False if the triangle takes more than is to spare. */
static bool take_triangle(side *r, const double v[3][3]) {
  const double unit = r->s->pose[r->body].unit;
  bool within = true;
  for (int k = 0; k < 3 && within; k++) {
    within = clearly_within(r, r->rough + vector_dot(r->way, v[k]) * unit, 0);
  }
  if (within) {
    return true;
  }
  twofold out = beyond_end(r, outermost(r, v));
  r->taken = twofold_less(r->taken, out) ? out : r->taken;
  return !twofold_less(r->spare, out);
}

/* True only if no vertex below a node takes more than is to spare. */
static bool take_node(side *r, uint32_t node, uint64_t *work, uint64_t most) {
  const sepax_body *b = r->s->body[r->body];
  uint32_t stack[STACK];
  int depth = 1;
  stack[0] = node;
  while (depth > 0) {
    uint32_t number = stack[--depth];
    if (++*work > most) {
      return false;
    }
    if (node_is_within(r, number) || aabb_is_within(r, number)) {
      continue;
    }
    const body_boxes *boxes = &b->boxes[number];
    for (int lane = 0; lane < BODY_WIDE && boxes->child[lane] != BODY_NONE; lane++) {
      uint32_t child = boxes->child[lane];
      if ((child & BODY_TRIANGLE) == 0) {
        stack[depth++] = child;
        continue;
      }
      ++*work;
      if (!take_triangle(r, b->triangle[child - BODY_TRIANGLE])) {
        r->beyond = BODY_WIDE * number + (uint32_t)lane;
        return false;
      }
    }
  }
  return true;
}

static bool take_child(side *r, uint32_t child, uint64_t *work, uint64_t most) {
  if ((child & BODY_TRIANGLE) == 0) {
    return take_node(r, child, work, most);
  }
  ++*work;
  return take_triangle(r, r->s->body[r->body]->triangle[child - BODY_TRIANGLE]);
}

/* A way with its largest coordinate in 1/2 ... 1; false if it is 0. */
static bool scale_way(twofold_vector *way) {
  double largest = 0;
  for (int i = 0; i < 3; i++) {
    largest = fmax(largest, fabs(way->c[i].high));
  }
  if (!(largest > 0x1p-900 && largest < 0x1p900)) {
    return false;
  }
  int exponent;
  frexp(largest, &exponent);
  for (int i = 0; i < 3; i++) {
    way->c[i] = twofold_scaled(way->c[i], -exponent);
  }
  return true;
}

/* An edge of a triangle in the coordinates of the search. */
static twofold_vector posed_edge(const world_pose *p, const double from[3], const double to[3]) {
  twofold_vector edge;
  for (int i = 0; i < 3; i++) {
    edge.c[i] = twofold_of(0);
    for (int k = 0; k < 3; k++) {
      twofold step = sum_of(to[k] * p->unit, -from[k] * p->unit);
      edge.c[i] = twofold_add(edge.c[i], twofold_multiply(step, twofold_of(p->rotation[i][k])));
    }
  }
  return edge;
}

static twofold_vector normal_of(const search *s, int body, uint32_t at) {
  const double(*v)[3] = s->body[body]->triangle[sepax__place_at(s->body[body], at)];
  twofold_vector e = posed_edge(&s->pose[body], v[0], v[1]);
  twofold_vector f = posed_edge(&s->pose[body], v[0], v[2]);
  return twofold_cross(&e, &f);
}

static uint64_t work_allowed(const search *s) {
  uint64_t most = 4 * s->work;
  if (s->work_most > 0) {
    uint64_t left = s->work_most > s->work ? s->work_most - s->work : 0;
    most = most < left ? most : left;
  }
  return most;
}

static void turn_way(search *s, int body, const twofold_vector *way) {
  const world_pose *p = &s->pose[body];
  twofold_vector *turned = &s->proof.turned[body];
  twofold *shift = &s->proof.shift[body];
  *shift = twofold_of(0);
  for (int i = 0; i < 3; i++) {
    turned->c[i] = twofold_of(0);
    for (int k = 0; k < 3; k++) {
      twofold part = twofold_multiply(way->c[k], twofold_of(p->rotation[k][i]));
      turned->c[i] = twofold_add(turned->c[i], part);
    }
    *shift = twofold_add(*shift, twofold_multiply(way->c[i], twofold_of(p->translation[i])));
  }
}

static side side_of(const search *s, int body) {
  const direction_proof *p = &s->proof;
  side r = {.s = s, .body = body, .high = body == p->high, .beyond = BODY_NONE};
  for (int i = 0; i < 3; i++) {
    r.way[i] = p->turned[body].c[i].high;
  }
  r.rough = p->shift[body].high;
  return r;
}

/* Find on which sides of the way the bodies are, by their nearest triangles; the gap of these. */
static twofold place_sides(search *s, const uint32_t at[2]) {
  direction_proof *p = &s->proof;
  twofold low[2];
  twofold high[2];
  for (int k = 0; k < 2; k++) {
    const double(*v)[3] = s->body[k]->triangle[sepax__place_at(s->body[k], at[k])];
    const side r = {.s = s, .body = k};
    low[k] = high[k] = at_vertex(&r, v[0]);
    for (int n = 1; n < 3; n++) {
      twofold end = at_vertex(&r, v[n]);
      low[k] = twofold_less(end, low[k]) ? end : low[k];
      high[k] = twofold_less(high[k], end) ? end : high[k];
    }
  }
  p->high = twofold_less(low[1], high[0]);
  p->end[p->high] = high[p->high];
  p->end[!p->high] = low[!p->high];
  return twofold_subtract(p->end[!p->high], p->end[p->high]);
}

/* Begin with a way, if it proves anything at all. */
static bool begin_on(search *s, twofold_vector way, const uint32_t at[2], twofold need) {
  direction_proof *p = &s->proof;
  p->possible = false;
  if (scale_way(&way)) {
    turn_way(s, 0, &way);
    turn_way(s, 1, &way);
    twofold gap = place_sides(s, at);
    twofold length = twofold_root(twofold_dot(&way, &way));
    p->spare = twofold_subtract(gap, twofold_multiply(need, length));
    p->possible = gap.high > 0 && p->spare.high >= 0;
  }
  return p->possible;
}

bool sepax__proof_begin(search *s, const twofold_vector *way, const uint32_t at[2], twofold need) {
  need = twofold_add(twofold_of(PROOF_ERROR), twofold_multiply(need, twofold_of(s->unit)));
  return begin_on(s, *way, at, need) || begin_on(s, normal_of(s, 0, at[0]), at, need) ||
         begin_on(s, normal_of(s, 1, at[1]), at, need);
}

bool sepax__prove_apart(search *s, const uint32_t child[2], hindrance *by) {
  const uint64_t most = work_allowed(s);
  twofold spare = s->proof.spare;
  uint64_t work = 0;
  bool proved = true;
  by->body = -1;
  for (int k = 0; k < 2 && proved; k++) {
    side r = side_of(s, k);
    r.spare = spare;
    r.taken = twofold_scaled(spare, -1);
    proved = take_child(&r, child[k], &work, most);
    if (r.beyond != BODY_NONE && r.taken.high < HARDLY) {
      *by = (hindrance){k, r.beyond};
    }
    spare = twofold_subtract(spare, r.taken);
  }
  s->work += work;
  return proved;
}
