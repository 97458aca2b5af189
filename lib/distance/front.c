/* SPDX-License-Identifier: MIT */
/* front.c - what a search proved of pairs of boxes, kept for similar poses.
 *
 * The motion. Let R_a, t_a and R_b, t_b be the poses and v = R_a x + t_a - R_b y - t_b the way
 * between a point x of A and a point y of B, both as in their files. Let M = R_b^T R_a and
 * m = R_b^T (t_a - t_b), and let ' denote the later poses. No entry of R_b R_b^T differs from the
 * identity by more than s, so that R_b R_b^T and R_b^T R_b, whose eigenvalues are the same, differ
 * from it by at most 3 s as matrices. With w = R_b^T v = M x + m - R_b^T R_b y:
 *
 *   |v| (1 - 2 s) <= |w| <= |v| (1 + 2 s),   as sqrt(1 - 3 s) >= 1 - 2 s for s <= 1/4
 *   |w' - w| <= |(M' - M) x + m' - m| + 3 (s + s') |y| = D
 *   |v'| >= (|v| (1 - 2 s) - D) / (1 + 2 s') >= |v| - 2 (s + s') |v| - D
 *
 * So a bound that is at most `most` falls by D + 2 (s + s') most. For x = c + r, where c is the
 * centre of A and |r| its radius at most, |(M' - M) x + m' - m| is at most |(M' - M) c + m' - m|
 * and the radius times the root of the sum of all squares of M' - M.
 *
 * Rounding. With u = 2^-53, let T be the sum of the coordinates of t_a - t_b in both poses. An
 * entry of M is wrong by 8 u, one of M' - M by 18 u, a coordinate of m' - m by 32 u T, one of
 * (M' - M) c + m' - m by 78 u |c| + 40 u T. As vectors, with the rounding of their lengths, they
 * are wrong by less than 256 u (|c| + T), and the product with the radius by less than 256 u of the
 * radius. MOTION_ERROR is more than that. */
#include "front.h"
#include "distance.h"
#include "util/error.h"
#include "util/vector.h"

#include <float.h>
#include <math.h>
#include <string.h>

#define MOTION_ERROR 0x1p-44

/* Squares of lengths within these limits neither overflow nor lose more by underflow than 2^-500.
 * Beyond them no front is kept. */
#define LEAST_SIZE 0x1p-400
#define MOST_SIZE 0x1p400

/* In units of the scale: bounds above this one are lowered to it. */
#define MOST_BOUND 0x1p60

/* Numbers that cover all rounding of doubles and floats. */
#define FLOAT_ERROR 0x1p-22

/* ------------------------------------------------------------------------ memory */

enum { ENTRY_BYTES = sizeof(float) + sizeof(front_entry) + sizeof(uint32_t), ALIGNED = 64 };
#define ROOM_MOST UINT32_C(0x1000000)

static size_t head_bytes(void) {
  return (sizeof(sepax_front) + ALIGNED - 1) / ALIGNED * ALIGNED + ALIGNED;
}

size_t sepax_front_bytes(size_t entries) {
  size_t room = entries < ROOM_MOST ? entries : ROOM_MOST;
  return head_bytes() + (room + FRONT_LANES - 1) / FRONT_LANES * FRONT_LANES * ENTRY_BYTES;
}

bool sepax_front_begin(sepax_front **front, void *memory, size_t bytes, sepax_error *error) {
  *front = NULL;
  if (memory == NULL || bytes < head_bytes()) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "%zu bytes are too few for a front; give sepax_front_bytes(entries)",
                      memory == NULL ? 0 : bytes);
  }
  char *at = (char *)memory;
  at += (ALIGNED - (uintptr_t)at % ALIGNED) % ALIGNED;
  memset(memory, 0, bytes);
  sepax_front *f = (sepax_front *)(void *)at;
  size_t room = (bytes - head_bytes()) / ENTRY_BYTES / FRONT_LANES * FRONT_LANES;
  f->room = (uint32_t)(room < ROOM_MOST ? room : ROOM_MOST);
  at += head_bytes() - ALIGNED;
  f->end = (float *)(void *)at;
  f->entry = (front_entry *)(void *)(f->end + f->room);
  f->list = (uint32_t *)(void *)(f->entry + f->room);
  sepax__front_clear(f);
  *front = f;
  return true;
}

void sepax__front_clear(sepax_front *f) {
  f->covers = f->full = false;
  f->used = f->listed = f->next = 0;
  f->free = FRONT_END;
  f->moved = f->most = 0;
}

/* ------------------------------------------------------------------------ motion */

static const sepax_pose at_origin = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};

/* Where the first body is, as seen from the second. */
typedef struct {
  double rotation[3][3], translation[3];
  double reach; /* sum of the coordinates of the way between the origins */
  double skew;  /* of the second body's pose */
} relation;

static void relate(relation *to, const sepax_pose *a, const sepax_pose *b) {
  a = a != NULL ? a : &at_origin;
  b = b != NULL ? b : &at_origin;
  const double way[3] = {a->translation[0] - b->translation[0],
                         a->translation[1] - b->translation[1],
                         a->translation[2] - b->translation[2]};
  double skew = 0;
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      to->rotation[i][j] = b->rotation[0][i] * a->rotation[0][j] +
                           b->rotation[1][i] * a->rotation[1][j] +
                           b->rotation[2][i] * a->rotation[2][j];
      skew = fmax(skew, fabs(vector_dot(b->rotation[i], b->rotation[j]) - (i == j)));
    }
    to->translation[i] =
        b->rotation[0][i] * way[0] + b->rotation[1][i] * way[1] + b->rotation[2][i] * way[2];
  }
  to->reach = fabs(way[0]) + fabs(way[1]) + fabs(way[2]);
  to->skew = skew + 0x1p-50;
}

/* How much the bounds of a front fall. */
static double motion(const sepax_front *f, const relation *now) {
  const double *c = f->body[0]->centre;
  double way[3];
  double turned = 0; /* sum of squares */
  for (int i = 0; i < 3; i++) {
    way[i] = now->translation[i] - f->translation[i];
    for (int k = 0; k < 3; k++) {
      double turn = now->rotation[i][k] - f->rotation[i][k];
      way[i] += turn * c[k];
      turned += turn * turn;
    }
  }
  double radius = f->body[0]->radius;
  const double size[2] = {vector_length(c) + radius,
                          vector_length(f->body[1]->centre) + f->body[1]->radius};
  double skews = f->skew + now->skew;
  return vector_length(way) + sqrt(turned) * radius + 3 * skews * size[1] +
         2 * skews * f->most * f->scale + MOTION_ERROR * (size[0] + f->reach + now->reach);
}

/* Are all lengths such that their squares are of use? */
static bool has_squares(const sepax_front *f, double reach) {
  const sepax_body *const *b = f->body;
  double most = reach;
  for (int k = 0; k < 2; k++) {
    for (int i = 0; i < 3; i++) {
      most = fmax(most, fabs(b[k]->centre[i]));
    }
    most = fmax(most, b[k]->scale);
  }
  return most <= MOST_SIZE && b[0]->scale >= LEAST_SIZE && b[1]->scale >= LEAST_SIZE;
}

void sepax__front_move(sepax_front *f, const sepax_body *a, const sepax_pose *pose_a,
                       const sepax_body *b, const sepax_pose *pose_b) {
  relation now;
  relate(&now, pose_a, pose_b);
  if (f->body[0] != a || f->body[1] != b) {
    sepax__front_clear(f);
    f->has_near = false;
    f->body[0] = a;
    f->body[1] = b;
    f->scale = fmax(a->scale, b->scale);
  }
  f->listed = f->next = 0;
  if (f->covers) {
    f->moved = (f->moved + motion(f, &now) / f->scale) * (1 + 0x1p-50);
  }
  if (!has_squares(f, now.reach) || !(f->moved < MOST_BOUND)) {
    sepax__front_clear(f);
  }
  memcpy(f->rotation, now.rotation, sizeof f->rotation);
  memcpy(f->translation, now.translation, sizeof f->translation);
  f->reach = now.reach;
  f->skew = now.skew;
}

/* ------------------------------------------------------------------------ entries */

typedef float four_ends __attribute__((vector_size(16)));
typedef int32_t four_marks __attribute__((vector_size(16)));

/* Of all entries. Places up to the next multiple of FRONT_LANES are infinite. */
static float least_end(const sepax_front *f) {
  four_ends least[2] = {{INFINITY, INFINITY, INFINITY, INFINITY},
                        {INFINITY, INFINITY, INFINITY, INFINITY}};
  for (uint32_t n = 0; n < f->used; n += FRONT_LANES) {
    for (int k = 0; k < 2; k++) {
      four_ends x;
      memcpy(&x, f->end + n + 4 * k, sizeof x);
      four_marks less = x < least[k];
      least[k] = (four_ends)(((four_marks)x & less) | ((four_marks)least[k] & ~less));
    }
  }
  float all = INFINITY;
  for (int k = 0; k < 8; k++) {
    all = fminf(all, least[k / 4][k % 4]);
  }
  return all;
}

/* The least end of a bound above the limit; this is larger than it by more than all rounding. */
static float end_of(const sepax_front *f, double limit) {
  return (float)fmin((f->moved + limit / f->scale) * (1 + FLOAT_ERROR) + FLT_MIN, FLT_MAX);
}

double sepax__front_least(const sepax_front *f) {
  if (!f->covers) {
    return 0;
  }
  double least = ((double)least_end(f) - f->moved) * (1 - 0x1p-40);
  return least > 0 ? least * f->scale : 0;
}

bool sepax__front_beyond(sepax_front *f, double limit, double *least) {
  if (!f->covers) {
    return false;
  }
  float enough = end_of(f, limit);
  float all = least_end(f);
  if (all > enough) {
    *least = fmax(limit, ((double)all - f->moved) * (1 - 0x1p-40) * f->scale);
    return true;
  }
  for (uint32_t n = 0; n < f->used; n++) {
    f->list[f->listed] = n;
    f->listed += !(f->end[n] > enough);
  }
  return false;
}

bool sepax__front_worth(const sepax_front *f) {
  return f->covers && 2 * f->listed <= f->used && f->used <= 2 * f->built + 64;
}

bool sepax__front_next(sepax_front *f, front_entry *e) {
  if (f->next == f->listed) {
    return false;
  }
  uint32_t place = f->list[f->next++];
  *e = f->entry[place];
  f->entry[place].at[0] = f->free;
  f->end[place] = INFINITY;
  f->free = place;
  return true;
}

void sepax__front_add(sepax_front *f, const front_entry *e, double bound) {
  uint32_t place = f->free;
  if (f->full) {
    return;
  }
  if (place != FRONT_END) {
    f->free = f->entry[place].at[0];
  } else if (f->used < f->room) {
    place = f->used++;
    if (place % FRONT_LANES == 0) {
      for (int k = 0; k < FRONT_LANES; k++) {
        f->end[place + (uint32_t)k] = INFINITY;
      }
    }
  } else {
    f->full = true;
    return;
  }
  double scaled = fmax(fmin(bound / f->scale, MOST_BOUND), 0);
  double end = (f->moved + scaled) * (1 - FLOAT_ERROR);
  f->most = fmax(f->most, scaled);
  f->end[place] = end > 4 * (double)FLT_MIN ? (float)end : 0;
  f->entry[place] = *e;
}

void sepax__front_note_near(sepax_front *f, const uint32_t at[2], double limit) {
  f->has_near = true;
  f->near[0] = at[0];
  f->near[1] = at[1];
  f->near_limit = limit;
}

void sepax__front_end(sepax_front *f, bool from_roots, double proved) {
  front_entry e;
  uint32_t left = f->listed - f->next;
  while (proved > 0 && sepax__front_next(f, &e)) {
    sepax__front_add(f, &e, proved);
  }
  f->covers = !f->full;
  if (f->full) {
    sepax__front_clear(f);
  } else if (from_roots || left > 0) {
    f->built = f->used;
  }
}
