/* SPDX-License-Identifier: MIT */
/* ears.c - cuts a polygon in the plane into triangles by its ears. */
#include "reader/ears.h"
#include "body/orient.h"
#include "sepax.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* What is known of a corner while its neighbours stay. */
enum { UNKNOWN, NO_EAR, TOUCHED_EAR };

typedef struct {
  double low, high; /* along x */
  uint32_t from;    /* the corner that it begins at */
} side;

/* The corners that are left, as a ring. */
typedef struct {
  double (*at)[2]; /* inside is on the left */
  uint32_t *before, *after;
  uint32_t *bay; /* corners that were not convex when they were last looked at */
  size_t bays;
  uint8_t *state;
  bool *doubled; /* the edge after a corner may run along another edge */
  bool *gone;
  side *side;
  size_t count, left, cut;
  size_t (*triangle)[3];
  bool area; /* some triangle has an area */
} ring;

static int turn(const ring *r, uint32_t a, uint32_t b, uint32_t c) {
  return sepax__orient2d(r->at[a], r->at[b], r->at[c]);
}

static int turn_at(const ring *r, uint32_t c) { return turn(r, r->before[c], c, r->after[c]); }

/* ----------------------------------------------------------- edges against edges */

static int compare(const void *p, const void *q) {
  const side *a = p;
  const side *b = q;
  int order = (a->low > b->low) - (a->low < b->low);
  return order != 0 ? order : (a->from > b->from) - (a->from < b->from);
}

static bool apart(double p, double q, double r, double s) {
  return fmax(p, q) < fmin(r, s) || fmax(r, s) < fmin(p, q);
}

/* True if two segments on one line share more than a point. */
static bool overlap(const double *a, const double *b, const double *c, const double *d) {
  int i = a[0] < b[0] || a[0] > b[0] ? 0 : 1;
  return fmin(fmax(a[i], b[i]), fmax(c[i], d[i])) > fmax(fmin(a[i], b[i]), fmin(c[i], d[i]));
}

/* True if the edges after p and after q cross each other at inner points. Edges on one line are
 * marked. */
static bool edges_cross(ring *r, uint32_t p, uint32_t q) {
  uint32_t p1 = r->after[p];
  uint32_t q1 = r->after[q];
  if (apart(r->at[p][1], r->at[p1][1], r->at[q][1], r->at[q1][1])) {
    return false;
  }
  int from = turn(r, p, p1, q);
  int to = turn(r, p, p1, q1);
  if (from == 0 && to == 0) {
    if (overlap(r->at[p], r->at[p1], r->at[q], r->at[q1])) {
      r->doubled[p] = r->doubled[q] = true;
    }
    return false;
  }
  return from * to < 0 && turn(r, q, q1, p) * turn(r, q, q1, p1) < 0;
}

static bool crosses_itself(ring *r) {
  for (uint32_t n = 0; n < r->count; n++) {
    double x = r->at[n][0];
    double to = r->at[r->after[n]][0];
    r->side[n] = (side){fmin(x, to), fmax(x, to), n};
  }
  qsort(r->side, r->count, sizeof *r->side, compare);
  for (size_t n = 0; n < r->count; n++) {
    for (size_t m = n + 1; m < r->count && r->side[m].low <= r->side[n].high; m++) {
      if (edges_cross(r, r->side[n].from, r->side[m].from)) {
        return true;
      }
    }
  }
  return false;
}

/* ------------------------------------------------------------------------- cutting */

static void cut(ring *r, uint32_t c) {
  uint32_t p = r->before[c];
  uint32_t n = r->after[c];
  size_t *t = r->triangle[r->cut++];
  t[0] = p;
  t[1] = c;
  t[2] = n;
  r->after[p] = n;
  r->before[n] = p;
  r->doubled[p] = r->doubled[p] || r->doubled[c];
  r->state[p] = r->state[n] = UNKNOWN;
  r->gone[c] = true;
  r->left--;
}

/* True if a corner is the tip of a spike or repeats a neighbour. */
static bool is_tip(const ring *r, uint32_t c) {
  const double *p = r->at[r->before[c]];
  const double *q = r->at[c];
  const double *s = r->at[r->after[c]];
  bool ahead = false;
  for (int i = 0; i < 2; i++) {
    ahead = ahead || (p[i] < q[i] && q[i] < s[i]) || (p[i] > q[i] && q[i] > s[i]);
  }
  return !ahead && turn_at(r, c) == 0;
}

/* Cut a corner if it is a tip, and then each corner that becomes a tip by that. Returns a corner
 * that is left. */
static uint32_t trim(ring *r, uint32_t at) {
  while (r->left > 3) {
    uint32_t next = r->after[at];
    if (is_tip(r, at)) {
      uint32_t before = r->before[at];
      cut(r, at);
      at = before;
    } else if (is_tip(r, next)) {
      cut(r, next);
    } else {
      break;
    }
  }
  return at;
}

/* --------------------------------------------------------------------------- ears */

/* True if an edge from corner q, which is on the border of the triangle, runs into its inside.
 * on[k]: q is on the line of side k. */
static bool runs_in(const ring *r, const uint32_t t[3], const bool on[3], uint32_t to) {
  for (int k = 0; k < 3; k++) {
    if (on[k] && turn(r, t[k], t[(k + 1) % 3], to) <= 0) {
      return false;
    }
  }
  return true;
}

/* Decide what corner q, not one of the triangle's, means for an ear; UNKNOWN if it does not
 * matter. */
static int judge_corner(const ring *r, const uint32_t t[3], uint32_t q, bool *touches) {
  bool on[3];
  bool border = false;
  for (int k = 0; k < 3; k++) {
    int way = turn(r, t[k], t[(k + 1) % 3], q);
    if (way < 0) {
      return UNKNOWN;
    }
    on[k] = way == 0;
    border = border || on[k];
  }
  if (!border || runs_in(r, t, on, r->before[q]) || runs_in(r, t, on, r->after[q])) {
    return NO_EAR;
  }
  *touches = true;
  return on[2] && !on[0] && !on[1] ? TOUCHED_EAR : UNKNOWN;
}

/* How often the ring winds round a point within the triangle; 1 if none is a double. */
static int winding_within(const ring *r, const uint32_t t[3]) {
  static const double share[4][3] = {
      {0.375, 0.25, 0.375}, {0.25, 0.5, 0.25}, {0.5, 0.25, 0.25}, {0.25, 0.25, 0.5}};
  double m[2];
  bool within = false;
  for (int n = 0; n < 4 && !within; n++) {
    for (int i = 0; i < 2; i++) {
      m[i] = share[n][0] * r->at[t[0]][i] + share[n][1] * r->at[t[1]][i] +
             share[n][2] * r->at[t[2]][i];
    }
    within = true;
    for (int k = 0; k < 3; k++) {
      within = within && sepax__orient2d(r->at[t[k]], r->at[t[(k + 1) % 3]], m) > 0;
    }
  }
  int winding = 0;
  uint32_t q = t[1];
  do {
    const double *a = r->at[q];
    q = r->after[q];
    const double *b = r->at[q];
    if ((a[1] <= m[1]) != (b[1] <= m[1])) {
      int way = sepax__orient2d(a, b, m);
      winding += a[1] <= m[1] ? way > 0 : -(way < 0);
    }
  } while (q != t[1]);
  return within ? winding : 1;
}

/* Remove corners from the list that are gone or convex now. */
static void list_bays(ring *r) {
  size_t kept = 0;
  for (size_t n = 0; n < r->bays; n++) {
    if (!r->gone[r->bay[n]] && turn_at(r, r->bay[n]) <= 0) {
      r->bay[kept++] = r->bay[n];
    }
  }
  r->bays = kept;
}

/* Can a corner with an area be cut? Only corners that are not convex can prevent it, because the
 * point inside the triangle that is farthest from the cut is such a corner. *touches: a corner lies
 * on the border. */
static int find_state(ring *r, uint32_t c, bool *touches) {
  const uint32_t t[3] = {r->before[c], c, r->after[c]};
  const double *p[3] = {r->at[t[0]], r->at[t[1]], r->at[t[2]]};
  double low[2];
  double high[2];
  for (int i = 0; i < 2; i++) {
    low[i] = fmin(p[0][i], fmin(p[1][i], p[2][i]));
    high[i] = fmax(p[0][i], fmax(p[1][i], p[2][i]));
  }
  int state = UNKNOWN;
  for (size_t n = 0; n < r->bays; n++) {
    uint32_t q = r->bay[n];
    const double *at = r->at[q];
    if (at[0] < low[0] || at[0] > high[0] || at[1] < low[1] || at[1] > high[1] || r->gone[q] ||
        q == t[0] || q == t[1] || q == t[2]) {
      continue;
    }
    int made = judge_corner(r, t, q, touches);
    if (made == NO_EAR) {
      return NO_EAR;
    }
    state = made == TOUCHED_EAR ? TOUCHED_EAR : state;
  }
  if ((r->doubled[t[0]] || r->doubled[t[1]]) && winding_within(r, t) < 1) {
    return NO_EAR;
  }
  return state;
}

static void cut_ear(ring *r, uint32_t c, bool touches) {
  uint32_t p = r->before[c];
  cut(r, c);
  r->area = true;
  r->doubled[p] = r->doubled[p] || touches;
}

/* Cut the first ear, from corner *at on, whose cut no corner touches. False if there is none. */
static bool cut_next(ring *r, uint32_t *at) {
  for (size_t n = 0; n < r->left; n++) {
    uint32_t c = *at;
    *at = r->after[c];
    if (r->state[c] != UNKNOWN) {
      continue;
    }
    bool touches = false;
    r->state[c] = (uint8_t)(turn_at(r, c) > 0 ? find_state(r, c, &touches) : NO_EAR);
    if (r->state[c] == UNKNOWN) {
      uint32_t p = r->before[c];
      cut_ear(r, c, touches);
      *at = r->after[r->after[trim(r, p)]];
      return true;
    }
  }
  return false;
}

/* Cut an ear whose cut a corner touches, or else a straight corner. */
static bool cut_other(ring *r, uint32_t *at) {
  for (int straight = 0; straight < 2; straight++) {
    uint32_t c = *at;
    for (size_t n = 0; n < r->left; n++, c = r->after[c]) {
      uint32_t p = r->before[c];
      if (straight != 0 && turn_at(r, c) == 0) {
        cut(r, c);
      } else if (straight == 0 && r->state[c] == TOUCHED_EAR) {
        cut_ear(r, c, true);
      } else {
        continue;
      }
      *at = r->after[trim(r, p)];
      return true;
    }
  }
  return false;
}

/* ----------------------------------------------------------------- the polygon */

static void begin(ring *r, const double (*corner)[3], int axis, bool right) {
  int x = (axis + (right ? 2 : 1)) % 3;
  int y = (axis + (right ? 1 : 2)) % 3;
  for (uint32_t n = 0; n < r->count; n++) {
    r->at[n][0] = corner[n][x];
    r->at[n][1] = corner[n][y];
    r->before[n] = (n == 0 ? (uint32_t)r->count : n) - 1;
    r->after[n] = n + 1 < r->count ? n + 1 : 0;
    r->state[n] = UNKNOWN;
    r->gone[n] = r->doubled[n] = false;
    r->bay[n] = n;
  }
  r->bays = r->left = r->count;
  r->cut = 0;
  r->area = false;
}

static bool cut_all(ring *r) {
  uint32_t at = 0;
  for (size_t n = 0; n < r->count; n++) {
    at = r->after[trim(r, at)];
  }
  at = r->gone[0] ? at : 0;
  list_bays(r);
  size_t listed = r->left;
  while (r->left > 3) {
    if (!cut_next(r, &at) && !cut_other(r, &at)) {
      return false;
    }
    if (r->left < listed - listed / 8) {
      list_bays(r);
      listed = r->left;
    }
  }
  int way = turn_at(r, at);
  r->area = r->area || way > 0;
  cut(r, at);
  return way >= 0;
}

static bool reserve(ring *r, size_t count) {
  r->count = count;
  r->at = sepax_allocate(count * sizeof *r->at);
  r->before = sepax_allocate(count * sizeof *r->before);
  r->after = sepax_allocate(count * sizeof *r->after);
  r->bay = sepax_allocate(count * sizeof *r->bay);
  r->state = sepax_allocate(count * sizeof *r->state);
  r->doubled = sepax_allocate(count * sizeof *r->doubled);
  r->gone = sepax_allocate(count * sizeof *r->gone);
  r->side = sepax_allocate(count * sizeof *r->side);
  return r->at != NULL && r->before != NULL && r->after != NULL && r->bay != NULL &&
         r->state != NULL && r->doubled != NULL && r->gone != NULL && r->side != NULL;
}

static void release(ring *r) {
  sepax_release(r->at);
  sepax_release(r->before);
  sepax_release(r->after);
  sepax_release(r->bay);
  sepax_release(r->state);
  sepax_release(r->doubled);
  sepax_release(r->gone);
  sepax_release(r->side);
}

polygon_result sepax__cut_ears(const double (*corner)[3], size_t count, int axis, bool right,
                               bool flat, size_t (*triangle)[3]) {
  ring r = {.triangle = triangle};
  polygon_result result = POLYGON_MEMORY;
  if (reserve(&r, count)) {
    result = POLYGON_CROSSES;
    for (int n = 0; n < 2 && result == POLYGON_CROSSES; n++) {
      begin(&r, corner, axis, right != (n == 1));
      if (crosses_itself(&r)) {
        break;
      }
      result = cut_all(&r) && (r.area || flat) ? POLYGON_DIVIDED : POLYGON_CROSSES;
    }
  }
  release(&r);
  return result;
}
