/* SPDX-License-Identifier: MIT */
/* pieces.c - finds the parts of a body that have a point in common, by testing its tree against
 * itself. */
#include "body/body.h"
#include "parts.h"

#include <math.h>
#include <stdlib.h>

#define MIXED UINT32_MAX

typedef struct {
  float centre[3], half[3];
} box;

typedef struct {
  const sepax_body *body;
  const uint32_t *part_of;
  uint32_t *piece;
  size_t pieces;
  uint32_t *below; /* a part of the piece that has all triangles below a node, or MIXED */
} search;

static bool is_triangle(uint32_t child) { return (child & BODY_TRIANGLE) != 0; }

static uint32_t part_below(const search *s, uint32_t child) {
  return is_triangle(child) ? s->part_of[child - BODY_TRIANGLE] : s->below[child];
}

/* Find `below` of a node from its children. Parts of one piece count as one part. */
static void find_below(search *s, uint32_t at) {
  const body_node *node = &s->body->node[at];
  uint32_t all = MIXED;
  for (uint32_t lane = 0; lane < node->children; lane++) {
    uint32_t part = part_below(s, node->child[lane]);
    part = part != MIXED ? set_of(s->piece, part) : MIXED;
    all = lane == 0 || part == all ? part : MIXED;
  }
  s->below[at] = all;
}

static void fill_below(search *s, uint32_t at) {
  const body_node *node = &s->body->node[at];
  for (uint32_t lane = 0; lane < node->children; lane++) {
    if (!is_triangle(node->child[lane])) {
      fill_below(s, node->child[lane]);
    }
  }
  find_below(s, at);
}

static bool one_piece(const search *s, uint32_t p, uint32_t q) {
  uint32_t part = part_below(s, p);
  uint32_t other = part_below(s, q);
  return part != MIXED && other != MIXED && set_of(s->piece, part) == set_of(s->piece, other);
}

static box lane_box(const body_node *node, uint32_t lane) {
  box b;
  for (int i = 0; i < 3; i++) {
    b.centre[i] = node->centre[i][lane];
    b.half[i] = node->half[i][lane];
  }
  return b;
}

static float size_of(const box *b) { return b->half[0] + b->half[1] + b->half[2]; }

/* True if the boxes are disjoint. Boxes hold their triangles with some room, and numbers up to 4
 * are rounded to 24 bits here. */
static bool disjoint(const box *p, const box *q) {
  for (int i = 0; i < 3; i++) {
    if (fabsf(p->centre[i] - q->centre[i]) > p->half[i] + q->half[i] + 0x1p-20F) {
      return true;
    }
  }
  return false;
}

/* True if q is certainly on one side of p's plane. With differences up to m, an area is wrong by at
 * most 10 u m^2, u = 2^-53, and the volume by 52 u m^3. Underflow loses less than 2^-1000. */
static bool one_side(const double p[3][3], const double q[3][3]) {
  double v[5][3];
  double n[3];
  double m = 0;
  int above = 0;
  for (int k = 0; k < 5; k++) {
    for (int i = 0; i < 3; i++) {
      v[k][i] = (k < 2 ? p[k + 1] : q[k - 2])[i] - p[0][i];
      m = fmax(m, fabs(v[k][i]));
    }
  }
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3;
    int k = (i + 2) % 3;
    n[i] = v[0][j] * v[1][k] - v[0][k] * v[1][j];
  }
  for (int k = 2; k < 5; k++) {
    double volume = n[0] * v[k][0] + n[1] * v[k][1] + n[2] * v[k][2];
    above += !(fabs(volume) > 64 * 0x1p-53 * m * m * m + 0x1p-1000) ? 0 : volume > 0 ? 1 : -1;
  }
  return above == 3 || above == -3;
}

static void judge(search *s, uint32_t p, uint32_t q) {
  const double(*a)[3] = s->body->triangle[p - BODY_TRIANGLE];
  const double(*b)[3] = s->body->triangle[q - BODY_TRIANGLE];
  if (!one_side(a, b) && !one_side(b, a) && sepax_exact_posed(a, NULL, b, NULL).collision) {
    join(s->piece, part_below(s, p), part_below(s, q));
    s->pieces--;
  }
}

static void cross(search *s, uint32_t p, const box *box_p, uint32_t q, const box *box_q) {
  if (s->pieces == 1 || one_piece(s, p, q) || disjoint(box_p, box_q)) {
    return;
  }
  if (is_triangle(p) && is_triangle(q)) {
    judge(s, p, q);
    return;
  }
  bool open_p = is_triangle(q) || (!is_triangle(p) && size_of(box_p) > size_of(box_q));
  const body_node *node = &s->body->node[open_p ? p : q];
  for (uint32_t lane = 0; lane < node->children; lane++) {
    box own = lane_box(node, lane);
    cross(s, node->child[lane], &own, open_p ? q : p, open_p ? box_q : box_p);
  }
}

/* Test the triangles below a node against each other. The children come first: triangles that are
 * one piece below them then count as one, so many triangles in one place are not tested one by
 * one. */
static void cross_below(search *s, uint32_t at) {
  const body_node *node = &s->body->node[at];
  if (s->below[at] != MIXED) {
    return;
  }
  for (uint32_t i = 0; i < node->children; i++) {
    if (!is_triangle(node->child[i])) {
      cross_below(s, node->child[i]);
    }
  }
  for (uint32_t i = 0; i < node->children; i++) {
    box own = lane_box(node, i);
    for (uint32_t j = i + 1; j < node->children; j++) {
      box other = lane_box(node, j);
      cross(s, node->child[i], &own, node->child[j], &other);
    }
  }
  find_below(s, at);
}

bool sepax__join_pieces(const sepax_body *body, const uint32_t *part_of, uint32_t *piece,
                        size_t parts) {
  search s = {.body = body, .part_of = part_of, .piece = piece, .pieces = parts};
  s.below = sepax_allocate(body->nodes * sizeof *s.below);
  if (s.below == NULL) {
    return false;
  }
  fill_below(&s, 0);
  cross_below(&s, 0);
  sepax_release(s.below);
  return true;
}
