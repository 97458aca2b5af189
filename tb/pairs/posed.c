/* SPDX-License-Identifier: MIT */
/* posed - verdicts on triangles of binary32 and binary64, as they are and in poses, against the
 * oracle in rational numbers. No grid is anywhere.
 *   posed-pairs COUNT SEED   COUNT pairs at least; a line a kind: pairs, collisions, wrong verdicts
 *                            of sepax_exact_posed and of searches of bodies. Exit status 1: one is
 *                            wrong
 *
 * The drafts are hard pairs of integers (sepax_vectors.h): touching, coplanar, of one edge, without
 * area; and pairs with one point in common. They are turned, moved away and rounded, so that what
 * touched is separated or collides by its last bits: within the bound of the search's filter in
 * doubles, and about it. */
#include "benchmark/columns.h"
#include "oracle/oracle.h"
#include "oracle/real_pairs.h"
#include "pairs/rotation.h"

#include <assert.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { MOST = 12 }; /* triangles of a body: more than the children of a node of its tree */

typedef enum {
  DRAFT,     /* integers times a power of two */
  TENTHS,    /* times 0.1, rounded */
  TURNED,    /* turned, rounded */
  ALIKE,     /* both in one pose */
  BACK,      /* B turned back, rounded, in the pose that turns it */
  TWO_POSES, /* both turned back, each in a pose of its own */
  NUDGED,    /* as BACK, then B moved by 2^-20 ... 2^-56 of its size */
  ULPS,      /* as TURNED, some coordinates a few ulps beside it */
  UNEQUAL,   /* coordinates of very different sizes */
  UNIFORM,   /* three points each in a cube */
  KINDS
} kind;

static const char *const kind_names[KINDS] = {"draft",   "tenths",    "turned", "alike",
                                              "back",    "two_poses", "nudged", "ulps",
                                              "unequal", "uniform"};

/* Two bodies of some triangles; given[k] is &pose[k] or NULL. */
typedef struct {
  sepax_facet facet[2][MOST];
  size_t count;
  bool single; /* coordinates are rounded to binary32 */
  sepax_pose pose[2];
  const sepax_pose *given[2];
} situation;

static const sepax_pose still = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};

/* Any rotation, or one of three in which axes lie on axes. */
static sepax_pose any_pose(double away, sepax_random *r) {
  sepax_pose p;
  random_rotation(p.rotation, r);
  for (int i = 0; i < 3; i++) {
    p.translation[i] = away * uniform(r, -1, 1);
  }
  if (sepax_random_range(r, 0, 2) == 0) {
    int turns = (int)sepax_random_range(r, 0, 2);
    for (int k = 0; k < 9; k++) {
      p.rotation[k / 3][k % 3] = (k / 3 + turns) % 3 == k % 3;
    }
  }
  return p;
}

static void turn(double v[3], const sepax_pose *p) {
  const double x[3] = {v[0], v[1], v[2]};
  for (int i = 0; i < 3; i++) {
    v[i] = p->rotation[i][0] * x[0] + p->rotation[i][1] * x[1] + p->rotation[i][2] * x[2] +
           p->translation[i];
  }
}

static void turn_back(double v[3], const sepax_pose *p) {
  double x[3];
  for (int i = 0; i < 3; i++) {
    x[i] = v[i] - p->translation[i];
  }
  for (int i = 0; i < 3; i++) {
    v[i] = p->rotation[0][i] * x[0] + p->rotation[1][i] * x[1] + p->rotation[2][i] * x[2];
  }
}

static void turn_body(situation *s, int body, const sepax_pose *p, bool back) {
  for (size_t n = 0; n < s->count; n++) {
    for (int k = 0; k < 3; k++) {
      (back ? turn_back : turn)(s->facet[body][n].v[k], p);
    }
  }
}

static void draft(situation *s, size_t n, double scale, sepax_random *r) {
  int word = (int)sepax_random_range(r, SEPAX_WORD_MIN, SEPAX_WORD_MAX);
  size_t families = 0;
  while (sepax_family_name(families) != NULL) {
    families++;
  }
  assert(families > 0);
  for (size_t i = 0; i < s->count; i++) {
    sepax_pair pair = sepax_family_triangles((n + i) % families, word, r);
    for (int k = 0; k < 6; k++) {
      const sepax_vec *v = k < 3 ? &pair.a.v[k] : &pair.b.v[k - 3];
      double *to = s->facet[k / 3][i].v[k % 3];
      to[0] = scale * v->x;
      to[1] = scale * v->y;
      to[2] = scale * v->z;
    }
  }
}

static void add(double r[3], const double p[3], double t, const double q[3]) {
  for (int i = 0; i < 3; i++) {
    r[i] = p[i] + t * q[i];
  }
}

/* One point in common, but for rounding, on which the verdict hangs; everything else is far from
 * touching: one orient3d of 15 is zero. A corner of one triangle's AABB, a vertex of it, is in the
 * inside of the other, which may be much larger; or two edges cross, and each triangle is on its
 * side of both. */
static void draft_touch(double a[3][3], double b[3][3], double scale, sepax_random *r) {
  static const double origin[3] = {0, 0, 0};
  bool swap = sepax_random_range(r, 0, 1) == 0;
  double(*t[2])[3] = {swap ? b : a, swap ? a : b};
  sepax_pose place = any_pose(ldexp(scale, (int)sepax_random_range(r, 0, 8)), r);
  double e[3][3];
  for (int k = 0; k < 9; k++) {
    e[k / 3][k % 3] = scale * place.rotation[k % 3][k / 3];
  }
  if (sepax_random_range(r, 0, 1) == 0) {
    double size = ldexp(1, (int)sepax_random_range(r, 0, 8));
    add(t[0][0], origin, -size * uniform(r, 0.2, 1), e[0]);
    add(t[0][1], t[0][0], 2 * size, e[0]);
    add(t[0][2], origin, size * uniform(r, 0.2, 1), e[1]);
    add(t[0][0], t[0][0], -size * uniform(r, 0.2, 1), e[1]);
    add(t[0][1], t[0][1], -size * uniform(r, 0.2, 1), e[1]);
    for (int k = 0; k < 9; k++) {
      t[1][k / 3][k % 3] = k < 3 ? 0 : copysign(scale * uniform(r, 0, 1), e[2][k % 3]);
    }
  } else {
    for (int k = 0; k < 2; k++) {
      add(t[k][0], origin, -uniform(r, 0.2, 1), e[k]);
      add(t[k][1], origin, uniform(r, 0.2, 1), e[k]);
      add(t[k][2], origin, (k == 0 ? 1 : -1) * uniform(r, 0.2, 1), e[2]);
    }
  }
  for (int k = 0; k < 6; k++) {
    add(t[k / 3][k % 3], t[k / 3][k % 3], 1, place.translation);
  }
}

/* Each coordinate of both bodies in turn: k = 0 ... 18 count - 1. */
static double *coordinate_of(situation *s, size_t k) {
  return &s->facet[k / 9 % 2][k / 18].v[k / 3 % 3][k % 3];
}

static double largest(situation *s) {
  double most = 0;
  for (size_t k = 0; k < 18 * s->count; k++) {
    most = fmax(most, fabs(*coordinate_of(s, k)));
  }
  return most;
}

static void round_all(situation *s) {
  for (size_t k = 0; k < 18 * s->count && s->single; k++) {
    double *x = coordinate_of(s, k);
    *x = (double)(float)*x;
  }
}

/* A coordinate is a few steps of its format beside its place. */
static void nudge_ulps(situation *s, sepax_random *r) {
  for (size_t k = 0; k < 18 * s->count; k++) {
    double *x = coordinate_of(s, k);
    for (int64_t steps = sepax_random_range(r, -2, 4); steps > 0; steps--) {
      *x = s->single ? (double)nextafterf((float)*x, INFINITY) : nextafter(*x, INFINITY);
    }
  }
}

static void draw_unequal(situation *s, bool uniformly, sepax_random *r) {
  int most = s->single ? 120 : 900;
  for (size_t k = 0; k < 18 * s->count; k++) {
    int exponent = uniformly ? 0 : (int)sepax_random_range(r, -most, most) / 8 * (k % 5 == 0);
    double few = (double)sepax_random_range(r, -2, 2);
    *coordinate_of(s, k) = uniformly ? uniform(r, -1, 1) : ldexp(few, exponent);
  }
}

static void draw_draft(situation *s, kind what, size_t n, sepax_random *r) {
  double unit = ldexp(1, (int)sepax_random_range(r, -30, 30));
  double scale = unit * (what == DRAFT ? 1 : what == TENTHS ? 0.1 : uniform(r, 0.5, 1));
  if (what == UNEQUAL || what == UNIFORM) {
    draw_unequal(s, what == UNIFORM, r);
  } else if (what == DRAFT || what == TENTHS || sepax_random_range(r, 0, 1) == 0) {
    draft(s, n, scale, r);
  } else {
    for (size_t i = 0; i < s->count; i++) {
      draft_touch(s->facet[0][i].v, s->facet[1][i].v, scale, r);
    }
  }
}

static void draw(situation *s, kind what, size_t n, sepax_random *r) {
  int64_t part = sepax_random_range(r, 0, 31);
  *s = (situation){.count = part == 0   ? MOST
                            : part < 5  ? 4
                            : part < 13 ? 2
                                        : 1,
                   .single = sepax_random_range(r, 0, 1) == 0,
                   .pose = {still, still}};
  draw_draft(s, what, n, r);
  double size = largest(s);
  sepax_pose first = any_pose(ldexp(size, (int)sepax_random_range(r, 0, 12)), r);
  s->pose[0] = any_pose(size * (double)sepax_random_range(r, 0, 2), r);
  s->pose[1] = what == ALIKE ? s->pose[0] : any_pose(size * (double)sepax_random_range(r, 0, 2), r);
  if (what >= TURNED && what <= ULPS) {
    turn_body(s, 0, &first, false);
    turn_body(s, 1, &first, false);
  }
  if (what == TWO_POSES || what == BACK || what == NUDGED) {
    turn_body(s, 0, what == TWO_POSES ? &s->pose[0] : &still, true);
    turn_body(s, 1, &s->pose[1], true);
  }
  round_all(s);
  if (what == ULPS) {
    nudge_ulps(s, r);
  }
  if (what == NUDGED) {
    s->pose[1].translation[sepax_random_range(r, 0, 2)] +=
        ldexp(size * uniform(r, -1, 1), -(int)sepax_random_range(r, 20, 56));
  }
  bool posed =
      what == ALIKE || what == TWO_POSES || ((what == UNEQUAL || what == UNIFORM) && n % 2);
  s->given[0] = posed ? &s->pose[0] : NULL;
  s->given[1] = posed || what == BACK || what == NUDGED ? &s->pose[1] : NULL;
}

/* -------------------------------------------------------------------------- judging */

typedef struct {
  uint64_t pairs, collisions, wrong_pairs, wrong_bodies;
} tally;

static void print_pair(const char *who, kind what, const situation *s, size_t i, size_t j) {
  fprintf(stderr, "%s, %s:", who, kind_names[what]);
  for (int k = 0; k < 18; k++) {
    fprintf(stderr, " %a", s->facet[k / 9][k < 9 ? i : j].v[k / 3 % 3][k % 3]);
  }
  for (int k = 0; k < 2; k++) {
    for (int n = 0; n < 12 && s->given[k] != NULL; n++) {
      fprintf(stderr, "%s%a",
              n > 0    ? " "
              : k == 0 ? "; A in "
                       : "; B in ",
              n < 9 ? s->pose[k].rotation[n / 3][n % 3] : s->pose[k].translation[n - 9]);
    }
  }
  fputc('\n', stderr);
}

/* What a search of the two bodies finds, as a table. */
static void search(const situation *s, bool found[MOST][MOST], sepax_simd simd) {
  sepax_body *body[2];
  sepax_pairs pairs;
  sepax_error error = {0};
  sepax_query query = {.size = sizeof(sepax_query), .simd = simd};
  for (int k = 0; k < 2; k++) {
    sepax_facet copy[MOST];
    memcpy(copy, s->facet[k], sizeof copy);
    if (!sepax_body_new(&body[k], &SEPAX_STRUCT(sepax_mesh, .vertex = copy, .triangles = s->count),
                        NULL, &error)) {
      bench_fail(&error);
    }
  }
  if (!sepax_bodies_collide(body[0], s->given[0], body[1], s->given[1], &query, &pairs, &error)) {
    bench_fail(&error);
  }
  memset(found, 0, MOST * sizeof *found);
  for (size_t n = 0; n < pairs.count; n++) {
    found[pairs.pair[n][0]][pairs.pair[n][1]] = true;
  }
  sepax_pairs_free(&pairs);
  sepax_body_free(body[0]);
  sepax_body_free(body[1]);
}

static void judge(tally *t, kind what, const situation *s, sepax_simd simd) {
  enum { SHOWN = 3 };
  bool found[MOST][MOST];
  search(s, found, simd);
  for (size_t i = 0; i < s->count; i++) {
    for (size_t j = 0; j < s->count; j++) {
      const double(*a)[3] = s->facet[0][i].v;
      const double(*b)[3] = s->facet[1][j].v;
      bool expected = oracle_collide_posed(a, s->given[0], b, s->given[1]);
      bool exact = sepax_exact_posed(a, s->given[0], b, s->given[1]).collision;
      t->pairs++;
      t->collisions += expected;
      t->wrong_pairs += exact != expected;
      t->wrong_bodies += found[i][j] != expected;
      if (exact != expected && t->wrong_pairs <= SHOWN) {
        print_pair("sepax_exact_posed is wrong", what, s, i, j);
      }
      if (found[i][j] != expected && t->wrong_bodies <= SHOWN) {
        print_pair("sepax_bodies_collide is wrong", what, s, i, j);
      }
    }
  }
}

int main(int argc, char **argv) {
  char *end[2] = {NULL, NULL};
  uint64_t count = argc == 3 ? strtoull(argv[1], &end[0], 10) : 0;
  sepax_random random = {argc == 3 ? strtoull(argv[2], &end[1], 10) : 0};
  if (count == 0 || *end[0] != '\0' || *end[1] != '\0') {
    fputs("usage: posed-pairs COUNT SEED\n", stderr);
    return 2;
  }
  tally of[KINDS] = {{0}};
  uint64_t done = 0;
  uint64_t wrong = 0;
  for (size_t n = 0; done < count; n++) {
    kind what = (kind)(n % KINDS);
    situation s;
    draw(&s, what, n / KINDS, &random);
    judge(&of[what], what, &s, n / KINDS % 4 == 0 ? SEPAX_SIMD_PORTABLE : SEPAX_SIMD_BEST);
    done += s.count * s.count;
    if (n % 20000 == 0 && isatty(2)) {
      fprintf(stderr, "  %" PRIu64 " of %" PRIu64 "\r", done, count);
    }
  }
  for (int k = 0; k < KINDS; k++) {
    printf("%s %" PRIu64 " %" PRIu64 " %" PRIu64 " %" PRIu64 "\n", kind_names[k], of[k].pairs,
           of[k].collisions, of[k].wrong_pairs, of[k].wrong_bodies);
    wrong += of[k].wrong_pairs + of[k].wrong_bodies;
  }
  return wrong > 0;
}
