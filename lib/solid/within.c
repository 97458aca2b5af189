/* SPDX-License-Identifier: MIT */
/* within.c - is a part of one body wholly inside the other?
 *
 * Bodies of which no triangles collide: a part is inside if one vertex of it is, which must not be
 * in the box of all open parts, and that is inside a closed part if a ray from it meets an odd
 * number of triangles. The ray runs along an axis of that body to the nearest side of its box.
 * Doubles decide where they are certain, else ray.c. */
#include "body/placement.h"
#include "parts.h"
#include "ray.h"

#include <float.h>
#include <math.h>

enum { STACK = 512 }; /* 64 levels, up to 7 children waiting on each */

typedef struct {
  const sepax_body *body; /* the body whose triangles the ray meets */
  double from[3]; /* origin of the ray in the coordinates of the body's file, each wrong by at most
                     `error` */
  double error;
  float at[3], slack; /* the same in the coordinates of its tree */
  int axis, way;
  const uint32_t *part_of;
  uint32_t part;             /* only triangles of this part count */
  const double *vertex;      /* the origin as a vertex of its own body's file */
  const sepax_pose *pose[2]; /* pose of the origin's body; pose of `body` */
  bool known;                /* `exact` is filled in */
  exact_point exact;
} ray;

/* As sepax__exact_ray_meets, for certain or not.
 *
 * With u = 2^-53, e = `error` and all coordinates from the ray's origin up to m across the ray and
 * up to n along it: a difference is wrong by e + u m or e + u n. An area, two products of these,
 * is wrong by 5 m e + 10 u m^2 at most; the volume, three areas times a coordinate along the ray,
 * by 15 m n e + 6 m^2 e + 52 u m^2 n. What underflow loses is below 2^-1000, or m is so large that
 * the limits are infinite. */
static int meets(const ray *r, const double t[3][3], bool *certain) {
  int x = (r->axis + 1) % 3;
  int y = (r->axis + 2) % 3;
  double v[3][3];
  double m = 0;
  double n = 0;
  bool aside = false;
  for (int i = 0; i < 3; i++) {
    bool above = true;
    bool below = true;
    for (int k = 0; k < 3; k++) {
      v[k][i] = t[k][i] - r->from[i];
      double *most = i == r->axis ? &n : &m;
      *most = fmax(*most, fabs(v[k][i]));
      above = above && v[k][i] > 2 * r->error;
      below = below && v[k][i] <= -2 * r->error;
    }
    aside = aside || (i == r->axis ? (r->way > 0 ? below : above) : above || below);
  }
  *certain = aside;
  if (aside) {
    return 0;
  }
  double tiny = 0x1p-1000;
  double limit = m * (8 * r->error + 16 * 0x1p-53 * m) + tiny;
  double area[3];
  double volume = 0;
  int ways = 0;
  for (int k = 0; k < 3; k++) {
    const double *p = v[(k + 1) % 3];
    const double *q = v[(k + 2) % 3];
    area[k] = p[x] * q[y] - p[y] * q[x];
    if (!(fabs(area[k]) > limit)) {
      return 0;
    }
    ways += area[k] > 0 ? 1 : -1;
    volume += area[k] * v[k][r->axis];
  }
  *certain = true;
  if (ways != 3 && ways != -3) {
    return 0;
  }
  *certain = fabs(volume) > m * (m + n) * (16 * r->error + 64 * 0x1p-53 * n) + tiny;
  int facing = ways / 3;
  return (volume > 0) == (facing * r->way > 0) ? facing : 0;
}

static int meets_exactly(ray *r, const double t[3][3]) {
  if (!r->known) {
    sepax__find_exact_point(&r->exact, r->vertex, r->pose[0], r->pose[1]);
    r->known = true;
  }
  return sepax__exact_ray_meets(&r->exact, r->axis, r->way, t);
}

/* The children that the ray may meet. */
static uint32_t children_met(const ray *r, const body_node *node) {
  int x = (r->axis + 1) % 3;
  int y = (r->axis + 2) % 3;
  uint32_t bits = 0;
  for (int n = 0; n < BODY_WIDE; n++) {
    bool disjoint = (fabsf(node->centre[x][n] - r->at[x]) > node->half[x][n] + r->slack) |
                    (fabsf(node->centre[y][n] - r->at[y]) > node->half[y][n] + r->slack) |
                    ((float)r->way * (node->centre[r->axis][n] - r->at[r->axis]) <
                     -node->half[r->axis][n] - r->slack);
    bits |= (uint32_t)disjoint << n;
  }
  return ~bits & ((1U << node->children) - 1);
}

/* Is the ray's origin inside the part: does the ray meet it an odd number of times, or does the
 * part wind round the origin, or do sheets of it enclose the origin? *times: how many copies of one
 * surface are round the origin; 0: not known. */
static sepax_inside inside_part(ray *r, const solid_part *part, const uint64_t *word,
                                uint32_t *times) {
  uint32_t stack[STACK] = {0};
  int depth = 1;
  bool odd = false;
  bool any = false;
  int64_t turns = 0;
  uint64_t words = 0;
  while (depth > 0) {
    const body_node *node = &r->body->node[stack[--depth]];
    for (uint32_t mask = children_met(r, node); mask != 0; mask &= mask - 1) {
      uint32_t child = node->child[__builtin_ctz(mask)];
      if ((child & BODY_TRIANGLE) == 0) {
        stack[depth++] = child;
        continue;
      }
      uint32_t number = child - BODY_TRIANGLE;
      if (r->part_of[number] != r->part) {
        continue;
      }
      const double(*t)[3] = r->body->triangle[number];
      bool certain;
      int met = meets(r, t, &certain);
      met = certain ? met : meets_exactly(r, t);
      if (met != 0) {
        any = true;
        odd = !odd;
        turns += met;
        words ^= word != NULL ? word[number] : 0;
      }
    }
  }
  *times = odd == (part->times % 2 != 0) ? part->times : 0;
  if (odd || words != 0 || (part->consistent && turns != 0)) {
    return SEPAX_INSIDE;
  }
  return any && part->tangled ? SEPAX_INSIDE_UNKNOWN : SEPAX_OUTSIDE;
}

/* Aim the ray at the nearest side of the body's AABB. False if the origin is outside the AABB.
 *
 * Otherwise the origin is at most 1 + slack in the tree's units, and children_met rounds it to 24
 * bits a few times. */
static bool aim(ray *r) {
  const sepax_body *b = r->body;
  double slack = r->error / b->scale + 0x1p-20;
  double nearest = INFINITY;
  r->slack = (float)(slack * (1 + 0x1p-20));
  r->axis = 0;
  r->way = 1;
  for (int i = 0; i < 3; i++) {
    double at = (r->from[i] - b->centre[i]) / b->scale;
    double low = INFINITY;
    double high = -INFINITY;
    for (uint32_t n = 0; n < b->node[0].children; n++) {
      double centre = b->node[0].centre[i][n];
      double half = b->node[0].half[i][n];
      low = fmin(low, centre - half);
      high = fmax(high, centre + half);
    }
    if (at < low - slack || at > high + slack) {
      return false;
    }
    r->at[i] = (float)at;
    for (int way = -1; way <= 1; way += 2) {
      double distance = way > 0 ? high - at : at - low;
      if (distance < nearest) {
        nearest = distance;
        r->axis = i;
        r->way = way;
      }
    }
  }
  return true;
}

static bool may_be_in(const ray *r, const double low[3], const double high[3]) {
  for (int i = 0; i < 3; i++) {
    if (r->from[i] + 2 * r->error < low[i] || r->from[i] - 2 * r->error > high[i]) {
      return false;
    }
  }
  return true;
}

/* Pieces that cancel each other are a cavity only if each of them is certainly one surface, or the
 * same number of copies of one. Otherwise another solid may fill the cavity, or stand in it: a
 * surface of which each triangle is there twice may be both sides of a cavity's faces, or a cavity
 * and what fills it. */
static sepax_inside inside(ray *r, const sepax_shell *shell) {
  const solid_part *part = shell->own->part;
  size_t pieces = 0;
  uint32_t times = UINT32_MAX;
  bool unknown = false;
  r->part_of = shell->own->of;
  for (uint32_t k = 0; k < shell->parts;) {
    size_t parts = 0;
    uint32_t piece = part[k].piece;
    for (; k < shell->parts && part[k].piece == piece; k++) {
      r->part = k;
      if (part[k].open || !may_be_in(r, part[k].low, part[k].high)) {
        continue;
      }
      uint32_t copies;
      sepax_inside in = inside_part(r, &part[k], shell->own->word, &copies);
      unknown = unknown || in == SEPAX_INSIDE_UNKNOWN;
      if (in == SEPAX_INSIDE) {
        parts++;
        times = times == UINT32_MAX || times == copies ? copies : 0;
      }
    }
    if (parts > 1) {
      return SEPAX_INSIDE;
    }
    pieces += parts;
  }
  if (pieces % 2 != 0 || (pieces > 0 && times == 0)) {
    return SEPAX_INSIDE;
  }
  return unknown ? SEPAX_INSIDE_UNKNOWN : SEPAX_OUTSIDE;
}

/* True if the whole part may fit into a box that contains its vertex. The box is up to sqrt(3) of
 * its longest side across; a valid pose stretches by at most 2^-16. */
static bool may_fit(const solid_part *part, const double box[2][3]) {
  double most = 0;
  double side = 0;
  for (int i = 0; i < 3; i++) {
    most = fmax(most, part->high[i] - part->low[i]);
    side = fmax(side, box[1][i] - box[0][i]);
  }
  return !(most > 2 * side);
}

static sepax_inside find_inside(const sepax_shell *a, const sepax_pose *pose_a,
                                const sepax_shell *b, const sepax_pose *pose_b) {
  placement at;
  sepax_inside result = SEPAX_OUTSIDE;
  const double(*open)[3] = (const double(*)[3])b->own->open;
  ray r = {.body = b->body, .pose = {pose_a, pose_b}};
  sepax__place_bodies(&at, b->body, pose_b, a->body,
                      pose_a); /* a sum that overflows is far outside */
  r.error = at.error;
  for (size_t k = 0; k < a->parts; k++) {
    const solid_part *part = &a->own->part[k];
    r.vertex = part->vertex;
    r.known = false;
    for (int i = 0; i < 3; i++) {
      r.from[i] = at.linear[i][0] * r.vertex[0] + at.linear[i][1] * r.vertex[1] +
                  at.linear[i][2] * r.vertex[2] + at.offset[i];
    }
    if (!aim(&r)) {
      continue;
    }
    if (may_be_in(&r, open[0], open[1]) && may_fit(part, open)) {
      result = SEPAX_INSIDE_UNKNOWN;
      continue;
    }
    const sepax_inside one = inside(&r, b);
    if (one == SEPAX_INSIDE) {
      return SEPAX_INSIDE;
    }
    result = one == SEPAX_INSIDE_UNKNOWN ? one : result;
  }
  return result;
}

bool sepax_bodies_within(const sepax_shell *a, const sepax_pose *pose_a, const sepax_shell *b,
                         const sepax_pose *pose_b, sepax_inside within[2], sepax_error *error) {
  within[0] = within[1] = SEPAX_INSIDE_UNKNOWN;
  if (!sepax__poses_valid(pose_a, pose_b, error)) {
    return false;
  }
  within[0] = find_inside(a, pose_a, b, pose_b);
  within[1] = find_inside(b, pose_b, a, pose_a);
  return true;
}
