/* SPDX-License-Identifier: MIT */
/* outline_offset.c - outlines that are shrunk or grown by a length.
 *
 * In space: a ball around a point at distance r from the axis lies in a solid of revolution if and
 * only if the disc of the same radius around (z, r) lies in the region and its mirror image,
 * because the ball covers the same pairs of a height and a distance from the axis. So the shrunk
 * solid is the solid of the shrunk region. It has the form 0 <= r <= S(z) again:
 * S(z) = least of R(z + t) - sqrt(d^2 - t^2) for |t| <= d.
 *
 * The point of the boundary that is nearest to a point within is on an edge, or is a vertex where
 * the region has an angle above 180 degrees; then the point is between the inward normals of the
 * vertex's edges. So S is the least of these pieces: edges shifted by d, segments across at both
 * ends of each, and arcs around such vertices from one normal to the other. A grown region has the
 * greatest of its pieces: there the shifted edges go on until they meet, and a vertex that is
 * sharper than 90 degrees has a square around its circle.
 *
 * Rounding: a vertex of the result is wrong by some 1e-12. Nothing is claimed here;
 * outline_checks.c proves what is needed of the result. */
#include "outline.h"
#include "util/error.h"
#include "util/list.h"

#include <math.h>
#include <stdlib.h>

/* A piece of the envelope: r is linear from (z[0], r[0]) to (z[1], r[1]), z[0] < z[1]. */
typedef struct {
  double z[2], r[2];
} piece;

enum { PIECES_MOST = 6000, HEIGHTS_MOST = 1 << 16 };

/* Points closer than this in z and r are one point. */
static const double tiny = 1e-9;

typedef struct {
  piece *piece;
  size_t pieces, piece_capacity;
  double *height; /* where the least piece may change */
  size_t heights, height_capacity;
  double sign; /* 1: the least r counts; -1: the greatest */
  bool memory; /* there was enough */
  bool few;    /* no more than the most */
} envelope;

static void add_piece(envelope *e, spot a, spot b) {
  piece *grown = list_grow(e->piece, &e->piece_capacity, e->pieces, sizeof *grown);
  e->memory = e->memory && grown != NULL;
  if (grown != NULL) {
    bool rises = a.z < b.z;
    e->piece = grown;
    e->piece[e->pieces] =
        (piece){{rises ? a.z : b.z, rises ? b.z : a.z}, {rises ? a.r : b.r, rises ? b.r : a.r}};
    e->pieces += e->piece[e->pieces].z[0] < e->piece[e->pieces].z[1];
  }
}

static void add_height(envelope *e, double z) {
  double *grown = list_grow(e->height, &e->height_capacity, e->heights, sizeof *grown);
  e->memory = e->memory && grown != NULL;
  e->few = e->few && e->heights < HEIGHTS_MOST;
  if (grown != NULL) {
    e->height = grown;
    e->height[e->heights++] = z;
  }
}

/* The point of a circle in the direction of an inward normal: 0 is towards the axis, a quarter turn
 * is up. */
static spot on_circle(spot centre, double angle, double radius) {
  return (spot){centre.z + radius * sin(angle), centre.r - radius * cos(angle)};
}

/* The arc from the inward normal of the edge before a vertex to that of the edge behind it, in
 * steps of a given angle at most: as chords, or as tangents, which are outside of the circle. */
static void add_fan(envelope *e, const outline *o, size_t n, double size, double step,
                    bool chords) {
  spot a = o->at[n - 1];
  spot b = o->at[n];
  spot c = o->at[n + 1];
  double from = atan2(b.r - a.r, b.z - a.z);
  double to = atan2(c.r - b.r, c.z - b.z);
  int steps = (int)fmin(ceil((to - from) / step), PIECES_MOST);
  step = (to - from) / (steps > 0 ? steps : 1);
  spot before = on_circle(b, from, size);
  for (int k = 0; k < steps; k++) {
    spot next = chords ? on_circle(b, from + (k + 1) * step, size)
                       : on_circle(b, from + (k + 0.5) * step, size / cos(step / 2));
    add_piece(e, before, next);
    before = next;
  }
  if (!chords && steps > 0) {
    add_piece(e, before, on_circle(b, to, size));
  }
}

/* Half a square around the circle, away from the axis. */
static void add_square(envelope *e, spot centre, double size) {
  double corner = size * (1.4142135623730951 + 1e-12);
  spot top = {centre.z, centre.r + corner};
  add_piece(e, (spot){centre.z - corner, centre.r}, top);
  add_piece(e, top, (spot){centre.z + corner, centre.r});
}

/* Point n of an outline with its ends at the axis, n = -1 ... count. */
static spot spot_of(const outline *o, ptrdiff_t n) {
  ptrdiff_t last = (ptrdiff_t)o->count - 1;
  return n < 0 ? (spot){o->at[0].z, 0} : n > last ? (spot){o->at[last].z, 0} : o->at[n];
}

/* At vertex n of a region that grows by `size`, edges that turn by an angle t <= 90 degrees meet at
 * size tan(t / 2) beyond their ends, which is not more than 1.42 size from the vertex. Returns that
 * length; 0 for a hollow vertex; and -1 for a sharper one, which needs a square. */
static double length_beyond(const outline *o, ptrdiff_t n, double size) {
  spot a = spot_of(o, n - 1);
  spot b = spot_of(o, n);
  spot c = spot_of(o, n + 1);
  double z[2] = {b.z - a.z, c.z - b.z};
  double r[2] = {b.r - a.r, c.r - b.r};
  double length = hypot(z[0], r[0]) * hypot(z[1], r[1]);
  double sine = r[0] * z[1] - z[0] * r[1]; /* positive: an angle below 180 degrees */
  double cosine = r[0] * r[1] + z[0] * z[1];
  if (cosine < -1e-12 * length || length == 0) {
    return -1;
  }
  return sine > 0 ? size * (sine / (length + cosine)) : 0;
}

static void add_edge(envelope *e, const outline *o, ptrdiff_t n, double depth, double before,
                     double behind) {
  spot a = o->at[n];
  spot b = o->at[n + 1];
  double length = hypot(b.z - a.z, b.r - a.r);
  if (!(b.z > a.z)) {
    return; /* its vertices bound what is near it */
  }
  double z = (b.z - a.z) / length;
  double r = (b.r - a.r) / length;
  add_piece(e, (spot){a.z + depth * r - before * z, a.r - depth * z - before * r},
            (spot){b.z + depth * r + behind * z, b.r - depth * z + behind * r});
  if (depth > 0) {
    add_piece(e, a, (spot){a.z + depth * r, a.r - depth * z});
    add_piece(e, b, (spot){b.z + depth * r, b.r - depth * z});
  }
}

/* The pieces of a region that shrinks. The chords of a circle are inside of it, so what is cut off
 * is less. */
static void add_shrunk(envelope *e, const outline *from, double size, bool chords, double sagitta) {
  double step = fmin(2 * acos(size / (size + sagitta)), 1);
  for (size_t n = 0; n + 1 < from->count; n++) {
    add_edge(e, from, (ptrdiff_t)n, size, 0, 0);
    if (n > 0) {
      add_fan(e, from, n, size, step, chords);
    }
  }
}

static void add_grown(envelope *e, const outline *from, double size) {
  double before = 0;
  for (ptrdiff_t n = 0; n < (ptrdiff_t)from->count; n++) {
    double here = length_beyond(from, n, size);
    if (n > 0) {
      add_edge(e, from, n - 1, -size, fmax(before, 0), fmax(here, 0));
    }
    if (here < 0) {
      add_square(e, from->at[n], size);
    }
    before = here;
  }
}

/* -------------------------------------------------------------------- envelope */

static double piece_at(const piece *p, double z) {
  return z >= p->z[1] ? p->r[1]
                      : p->r[0] + (p->r[1] - p->r[0]) * ((z - p->z[0]) / (p->z[1] - p->z[0]));
}

static int compare_pieces(const void *a, const void *b) {
  const piece *p = a;
  const piece *q = b;
  return (p->z[0] > q->z[0]) - (p->z[0] < q->z[0]);
}

static int compare_heights(const void *a, const void *b) {
  double p = *(const double *)a;
  double q = *(const double *)b;
  return (p > q) - (p < q);
}

static void add_crossing(envelope *e, const piece *p, const piece *q) {
  double low = fmax(p->z[0], q->z[0]);
  double high = fmin(p->z[1], q->z[1]);
  double at_low = piece_at(p, low) - piece_at(q, low);
  double at_high = piece_at(p, high) - piece_at(q, high);
  if ((at_low < 0 && at_high > 0) || (at_low > 0 && at_high < 0)) {
    add_height(e, low + (high - low) * (at_low / (at_low - at_high)));
  }
}

static void add_heights(envelope *e) {
  if (e->pieces > 0) {
    qsort(e->piece, e->pieces, sizeof *e->piece, compare_pieces);
  }
  for (size_t i = 0; i < e->pieces && e->memory && e->few; i++) {
    const piece *p = &e->piece[i];
    add_height(e, p->z[0]);
    add_height(e, p->z[1]);
    if ((p->r[0] < 0) != (p->r[1] < 0)) {
      add_height(e, p->z[0] + (p->z[1] - p->z[0]) * (p->r[0] / (p->r[0] - p->r[1])));
    }
    for (size_t j = i + 1; j < e->pieces && e->piece[j].z[0] < p->z[1]; j++) {
      add_crossing(e, p, &e->piece[j]);
    }
  }
  if (e->heights > 0) {
    qsort(e->height, e->heights, sizeof *e->height, compare_heights);
  }
}

/* The piece that counts at z; NULL: none. */
static const piece *piece_over(const envelope *e, double z) {
  const piece *best = NULL;
  for (size_t n = 0; n < e->pieces && e->piece[n].z[0] <= z; n++) {
    const piece *p = &e->piece[n];
    if (z <= p->z[1] && (best == NULL || e->sign * piece_at(p, z) < e->sign * piece_at(best, z))) {
      best = p;
    }
  }
  return best;
}

static void add_spot(envelope *e, outline *o, double z, double r) {
  r = r < tiny ? 0 : r;
  if (o->count > 0) {
    spot before = o->at[o->count - 1];
    z = z - before.z < tiny ? before.z : z;
    if (z == before.z && fabs(r - before.r) < tiny) {
      return;
    }
  }
  e->memory = e->memory && sepax__outline_add(o, z, r);
}

/* The outline of the pieces that count between two heights. */
static void trace(envelope *e, outline *o, double from, double to) {
  const piece *before = NULL;
  bool below = false; /* the piece before was below the axis, where the outline follows the axis */
  double end = from;
  for (size_t n = 0; n + 1 < e->heights; n++) {
    double low = fmax(e->height[n], from);
    double high = fmin(e->height[n + 1], to);
    if (!(low < high)) {
      continue;
    }
    double middle = low + (high - low) / 2;
    const piece *p = piece_over(e, middle);
    bool under = p != NULL && piece_at(p, middle) < 0;
    if (p != before || under != below) {
      if (before != NULL) {
        add_spot(e, o, end, below ? 0 : piece_at(before, end));
      }
      if (p != NULL) {
        add_spot(e, o, low, under ? 0 : piece_at(p, low));
      }
    }
    before = p;
    below = under;
    end = high;
  }
  if (before != NULL) {
    add_spot(e, o, end, below ? 0 : piece_at(before, end));
  }
}

static bool complain(const envelope *e, sepax_error *error) {
  return e->few ? sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for a profile of %zu pieces",
                             e->pieces)
                : sepax_fail(error, SEPAX_ERROR_LIMIT,
                             "the profile has too many pieces for this gap (%zu, and %zu heights); "
                             "give a larger gap",
                             e->pieces, e->heights);
}

bool sepax__outline_offset(outline *o, const outline *from, double depth, outline_side side,
                           double sagitta, sepax_error *error) {
  envelope e = {.sign = depth > 0 ? 1 : -1, .memory = true, .few = true};
  double low = depth > 0 ? from->at[0].z + depth : -INFINITY;
  double high = depth > 0 ? from->at[from->count - 1].z - depth : INFINITY;
  *o = (outline){0};
  if (depth > 0) {
    add_shrunk(&e, from, depth, side == AROUND, sagitta);
  } else {
    add_grown(&e, from, -depth);
  }
  e.few = e.pieces <= PIECES_MOST;
  if (e.memory && e.few && low < high) {
    add_heights(&e);
    if (e.memory && e.few) {
      trace(&e, o, low, high);
    }
  }
  sepax_release(e.piece);
  sepax_release(e.height);
  if (!e.memory || !e.few) {
    sepax__outline_free(o);
    return complain(&e, error);
  }
  return true;
}
