/* SPDX-License-Identifier: MIT */
/* within.c - is a part of one body wholly inside the other?
 *
 * Bodies of which no triangles collide: a part is inside if one vertex of it is, which must not be
 * in the box of all open parts. A ray along an axis of that body, to the nearest side of its box
 * first, is summed up sheet by sheet; sepax.h has the rule. Doubles decide where they are certain,
 * else ray.c. */
#include "body/placement.h"
#include "parts.h"
#include "ray.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* STACK: 64 levels, up to 7 children waiting on each. SHEETS: of which a ray meets triangles. */
enum { STACK = 512, SHEETS = 256 };

typedef struct {
  const sepax_body *body; /* the body whose triangles the ray meets */
  double from[3]; /* origin of the ray in the coordinates of the body's file, each wrong by at most
                     `error` */
  double error;
  float at[3], slack; /* the same in the coordinates of its tree */
  int axis, way;
  const double *vertex;      /* the origin as a vertex of its own body's file */
  const sepax_pose *pose[2]; /* pose of the origin's body; pose of `body` */
  bool known;                /* `exact` is filled in */
  exact_point exact;
  sepax_within_reason why; /* of the last answer */
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

static bool may_be_in(const ray *r, const double box[2][3]) {
  for (int i = 0; i < 3; i++) {
    if (r->from[i] + 2 * r->error < box[0][i] || r->from[i] - 2 * r->error > box[1][i]) {
      return false;
    }
  }
  return true;
}

/* What a ray meets of a sheet or of a part: how much more often it leaves than it enters, and
 * whether it does both an odd number of times together. */
typedef struct {
  uint32_t part, sheet;
  int32_t turns;
  bool odd;
} crossing;

typedef struct {
  crossing sheet[SHEETS]; /* in the order of parts, then of sheets */
  size_t count;
  bool full; /* there are more sheets */
} crossings;

/* Add a triangle that the ray meets. */
static void add_crossing(crossings *all, uint32_t part, uint32_t sheet, int turn) {
  size_t n = all->count;
  while (n > 0 && (all->sheet[n - 1].part > part ||
                   (all->sheet[n - 1].part == part && all->sheet[n - 1].sheet > sheet))) {
    n--;
  }
  if (n > 0 && all->sheet[n - 1].part == part && all->sheet[n - 1].sheet == sheet) {
    all->sheet[n - 1].turns += turn;
    all->sheet[n - 1].odd = !all->sheet[n - 1].odd;
    return;
  }
  all->full = all->full || all->count == SHEETS;
  if (!all->full) {
    memmove(&all->sheet[n + 1], &all->sheet[n], (all->count - n) * sizeof *all->sheet);
    all->sheet[n] = (crossing){part, sheet, turn, true};
    all->count++;
  }
}

/* Find what the ray meets of parts that may have its origin inside. */
static void cross_body(ray *r, const sepax_shell *shell, crossings *all) {
  const struct sepax_parts *own = shell->own;
  uint32_t stack[STACK] = {0};
  int depth = 1;
  all->count = 0;
  all->full = false;
  while (depth > 0) {
    const body_node *node = &r->body->node[stack[--depth]];
    for (uint32_t mask = children_met(r, node); mask != 0; mask &= mask - 1) {
      uint32_t child = node->child[__builtin_ctz(mask)];
      if ((child & BODY_TRIANGLE) == 0) {
        stack[depth++] = child;
        continue;
      }
      uint32_t number = child - BODY_TRIANGLE;
      const double(*t)[3] = r->body->triangle[number];
      bool certain;
      int met = meets(r, t, &certain);
      met = certain ? met : meets_exactly(r, t);
      const uint32_t part = own->of[number];
      if (met != 0 && may_be_in(r, own->part[part].tangle)) {
        add_crossing(all, part, own->sheet[number], met * r->way);
      }
    }
  }
}

/* Sum up the sheets of each part, but for parts of which the ray leaves each sheet as often as it
 * enters it. They follow each other in `part`. Returns their number. */
static size_t sum_parts(const crossings *all, crossing part[SHEETS]) {
  size_t parts = 0;
  size_t next;
  for (size_t n = 0; n < all->count; n = next) {
    crossing sum = {all->sheet[n].part, 0, 0, false};
    bool cancels = true;
    for (next = n; next < all->count && all->sheet[next].part == sum.part; next++) {
      cancels = cancels && all->sheet[next].turns == 0;
      sum.turns += all->sheet[next].turns;
      sum.odd ^= all->sheet[next].odd;
    }
    if (!cancels) {
      part[parts++] = sum;
    }
  }
  return parts;
}

/* Order parts by their boxes. If they do not touch and have a common point inside, then they are in
 * each other, and so are their boxes: the outermost one comes first. */
static void order_parts(const sepax_shell *shell, crossing *part, size_t parts) {
  const solid_part *own = shell->own->part;
  for (size_t n = 1; n < parts; n++) {
    const crossing one = part[n];
    size_t k = n;
    for (; k > 0 && own[one.part].box[0][0] < own[part[k - 1].part].box[0][0]; k--) {
      part[k] = part[k - 1];
    }
    part[k] = one;
  }
}

static bool one_piece(const sepax_shell *shell, const crossing *p, const crossing *q) {
  return shell->own->part[p->part].piece == shell->own->part[q->part].piece;
}

/* Do these parts, which are ordered and whose turns have the sum 0, not touch each other, and are
 * they wound outwards and inwards by turns, the outermost one outwards? */
static bool is_cavity(const sepax_shell *shell, const crossing *part, size_t parts) {
  for (size_t n = 0; n < parts; n++) { /* as the sum is 0, their number is even */
    if (part[n].turns != (n % 2 == 0 ? 1 : -1)) {
      return false;
    }
    for (size_t k = 0; k < n; k++) {
      if (one_piece(shell, &part[k], &part[n])) {
        return false;
      }
    }
  }
  return true;
}

/* Is one of these parts, which are ordered, in another piece that is wound the same way? */
static bool is_nested(const sepax_shell *shell, const crossing *part, size_t parts) {
  for (size_t n = 1; n < parts; n++) {
    if ((part[n].turns > 0) == (part[n - 1].turns > 0) &&
        !one_piece(shell, &part[n - 1], &part[n])) {
      return true;
    }
  }
  return false;
}

/* Of some parts that a ray crosses. */
typedef struct {
  size_t parts;
  int64_t turns;
  bool odd;
  bool consistent; /* each of them is */
  bool negative;   /* each of them is crossed more often inwards */
  bool zero;       /* one of them is crossed as often outwards as inwards */
} crossing_sum;

/* Add up closed parts; they become the first ones of the list, ordered. */
static crossing_sum sum_closed(const sepax_shell *shell, crossing *part, size_t count) {
  crossing_sum sum = {.consistent = true, .negative = true};
  for (size_t n = 0; n < count; n++) {
    const solid_part *own = &shell->own->part[part[n].part];
    if (!own->open) {
      sum.odd ^= part[n].odd;
      sum.consistent = sum.consistent && own->consistent;
      sum.negative = sum.negative && part[n].turns < 0;
      sum.zero = sum.zero || part[n].turns == 0;
      sum.turns += part[n].turns;
      part[sum.parts++] = part[n];
    }
  }
  order_parts(shell, part, sum.parts);
  return sum;
}

/* What one ray tells, and why. */
static sepax_inside inside_by_ray(ray *r, const sepax_shell *shell) {
  crossings all;
  crossing part[SHEETS];
  cross_body(r, shell, &all);
  const size_t met = all.full ? 0 : sum_parts(&all, part);
  const crossing_sum sum = sum_closed(shell, part, met);
  const bool open = sum.parts < met; /* an open part may close others */
  r->why = SEPAX_WITHIN_PLAIN;
  if (met == 0 && !all.full) {
    return SEPAX_OUTSIDE;
  }
  if (sum.parts > 0 && (sum.consistent ? sum.turns > 0 || sum.negative : sum.odd)) {
    const bool nested = sum.consistent && is_nested(shell, part, sum.parts);
    r->why = nested ? SEPAX_WITHIN_NESTED : SEPAX_WITHIN_PLAIN;
    return SEPAX_INSIDE;
  }
  if (sum.consistent && sum.turns == 0 && !open && !all.full && is_cavity(shell, part, sum.parts)) {
    return SEPAX_OUTSIDE;
  }
  r->why = all.full          ? SEPAX_WITHIN_SHEETS
           : open            ? SEPAX_WITHIN_OPEN
           : !sum.consistent ? SEPAX_WITHIN_INCONSISTENT
           : sum.zero        ? SEPAX_WITHIN_DOUBLED
                             : SEPAX_WITHIN_OPPOSED;
  return SEPAX_INSIDE_UNKNOWN;
}

/* If one ray does not tell, then another may. */
static sepax_inside inside(ray *r, const sepax_shell *shell) {
  sepax_inside in = inside_by_ray(r, shell);
  const sepax_within_reason why = r->why;
  const int first[2] = {r->axis, r->way};
  for (int n = 0; n < 6 && in == SEPAX_INSIDE_UNKNOWN; n++) {
    r->axis = n / 2;
    r->way = n % 2 == 0 ? 1 : -1;
    if (r->axis != first[0] || r->way != first[1]) {
      in = inside_by_ray(r, shell);
    }
  }
  r->why = in == SEPAX_INSIDE_UNKNOWN ? why : r->why;
  return in;
}

/* True if the whole part may fit into a box that contains its vertex. The box is up to sqrt(3) of
 * its longest side across; a valid pose stretches by at most 2^-16. */
static bool may_fit(const solid_part *part, const double box[2][3]) {
  double most = 0;
  double side = 0;
  for (int i = 0; i < 3; i++) {
    most = fmax(most, part->box[1][i] - part->box[0][i]);
    side = fmax(side, box[1][i] - box[0][i]);
  }
  return !(most > 2 * side);
}

static sepax_inside find_inside(const sepax_shell *a, const sepax_pose *pose_a,
                                const sepax_shell *b, const sepax_pose *pose_b,
                                sepax_within_reason *why) {
  placement at;
  sepax_inside result = SEPAX_OUTSIDE;
  const double(*open)[3] = (const double(*)[3])b->own->open;
  ray r = {.body = b->body, .pose = {pose_a, pose_b}};
  sepax__place_bodies(&at, b->body, pose_b, a->body,
                      pose_a); /* a sum that overflows is far outside */
  r.error = at.error;
  *why = SEPAX_WITHIN_PLAIN;
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
    const bool maybe_open = may_be_in(&r, open) && may_fit(part, open);
    const sepax_inside one = maybe_open ? SEPAX_INSIDE_UNKNOWN : inside(&r, b);
    if (one != SEPAX_OUTSIDE && result == SEPAX_OUTSIDE) {
      *why = maybe_open ? SEPAX_WITHIN_OPEN : r.why;
      result = one;
    }
    if (one == SEPAX_INSIDE) {
      *why = r.why;
      return SEPAX_INSIDE;
    }
  }
  return result;
}

bool sepax_bodies_within_why(const sepax_shell *a, const sepax_pose *pose_a, const sepax_shell *b,
                             const sepax_pose *pose_b, sepax_inside within[2],
                             sepax_within_reason why[2], sepax_error *error) {
  within[0] = within[1] = SEPAX_INSIDE_UNKNOWN;
  why[0] = why[1] = SEPAX_WITHIN_PLAIN;
  if (!sepax__poses_valid(pose_a, pose_b, error)) {
    return false;
  }
  within[0] = find_inside(a, pose_a, b, pose_b, &why[0]);
  within[1] = find_inside(b, pose_b, a, pose_a, &why[1]);
  return true;
}

bool sepax_bodies_within(const sepax_shell *a, const sepax_pose *pose_a, const sepax_shell *b,
                         const sepax_pose *pose_b, sepax_inside within[2], sepax_error *error) {
  sepax_within_reason why[2];
  return sepax_bodies_within_why(a, pose_a, b, pose_b, within, why, error);
}
