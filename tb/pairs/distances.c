/* SPDX-License-Identifier: MIT */
/* distances - intervals of the distance of two bodies, and what sepax_bodies_apart says, against
 * the oracle in rational numbers.
 *   distances COUNT SEED [FAULT]   COUNT cases: two bodies in poses, with 6 requests of a distance
 *                                  and 6 of a verdict each. A line a kind of bodies: cases,
 * answers, touching cases, answers that a budget ended, wrong answers. Exit status 1: one is wrong
 * FAULT names a fault that is put into each answer before it is checked (see faults[]): a check
 * that works is then red.
 *
 * Bodies of up to 60 triangles are drawn so that many pairs are equally near, or nearly, and every
 * pair is measured without rounding. Of the large bodies (kind "large") the exact mode's pair is
 * measured so. Requests have tolerances, limits about the distance, budgets of work, and results of
 * other poses. A front is kept along small motions, jumps and other bodies. The same request gives
 * the same bytes again. Without vector instructions an answer may be another one, which is checked
 * as well. */
#include "benchmark/columns.h"
#include "oracle/bodies.h"
#include "oracle/oracle.h"
#include "oracle/real_pairs.h"

#include <assert.h>
#include <inttypes.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { MOST = 64, REQUESTS = 4 };

/* A budget may be exceeded by the step that is under way (sepax.h). */
enum { OVERSHOOT = 500 };

typedef enum {
  STREWN,   /* triangles of any place */
  TIED,     /* parallel plates: all pairs are equally near */
  TOUCHING, /* boxes face on face, or a few ulps apart */
  NESTED,   /* a body in a hollow one */
  COPY,     /* a surface and its own copy */
  SLIVERS,  /* needles, segments and points */
  MIXED,    /* coordinates of very different sizes */
  FAR,      /* far from the origin, or from each other, for their size */
  ALIKE,    /* each triangle is nearly the same one */
  ON_EDGE,  /* a box over a plate, on its edge or corner */
  SPHERES,  /* concentric ones of few triangles */
  LARGE,    /* thousands of triangles */
  KINDS
} kind;

static const char *const kind_names[KINDS] = {"strewn", "tied",    "touching", "nested",
                                              "copy",   "sliver",  "mixed",    "far",
                                              "alike",  "on_edge", "spheres",  "large"};

/* Faults that can be put into an answer. */
typedef enum {
  NO_FAULT,
  LEAST_ABOVE, /* least is the next double above the distance */
  MOST_BELOW,  /* most is the next double below the distance */
  TOO_WIDE,    /* the interval is wider than the tolerance, and certain */
  OTHER_PAIR,  /* another pair */
  ONE_ULP,     /* an exact distance is wrong by two units in the last place */
  OTHER_BYTES, /* a bit differs in the answer of the other instruction set */
  TOO_MUCH,    /* more work than the budget */
  LOST,        /* a distance within the limit is reported as infinite */
  STALE,       /* a query with a front says what holds in the pose before */
  WRONG_APART, /* NEAR and APART exchanged where the distance is next to the one asked for */
  FAULTS
} fault;

static const char *const fault_names[FAULTS] = {"",      "least", "most",  "width", "pair", "ulp",
                                                "bytes", "work",  "limit", "front", "apart"};

typedef struct {
  sepax_facet few[2][MOST];
  const sepax_facet *facet[2];
  size_t count[2];
  sepax_pose pose[2];
  const sepax_pose *given[2]; /* &pose[k], &pose[0] or NULL */
  sepax_body *body[2];
  exact_square square; /* of the distance */
  double below;        /* the greatest double that is not above the distance */
  bool is_double;      /* it is the distance */
  double slack_ulps;   /* the truth is known but for so many ulps */
} situation;

typedef struct {
  uint64_t cases, answers, touching, ended, wrong;
} tally;

static fault planted;
static tally *counted;
static const char *at_work; /* the kind */
static uint64_t case_number;

static void wrong(const char *format, ...) __attribute__((format(printf, 1, 2)));
static void wrong(const char *format, ...) {
  enum { SHOWN = 5 };
  if (counted->wrong++ < SHOWN) {
    va_list list;
    va_start(list, format);
    fprintf(stderr, "%s, case %" PRIu64 ": ", at_work, case_number);
    vfprintf(stderr, format, list);
    fputc('\n', stderr);
    va_end(list);
  }
}

static double up(double x) { return nextafter(x, INFINITY); }
static double down(double x) { return nextafter(x, 0); }

static int64_t range(sepax_random *r, int64_t low, int64_t high) {
  return sepax_random_range(r, low, high);
}
static bool one_in(sepax_random *r, int64_t n) { return range(r, 1, n) == 1; }

/* ---------------------------------------------------------------------------- poses */

/* Any rotation, a third of them not quite one. */
static sepax_pose any_pose(double away, sepax_random *r) {
  double q[4];
  double square = 0;
  for (int i = 0; i < 4; i++) {
    q[i] = uniform(r, -1, 1);
    square += q[i] * q[i];
  }
  sepax_pose p;
  bool off = one_in(r, 3);
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3;
    int k = (i + 2) % 3;
    p.rotation[i][i] = 1 - 2 * (q[j] * q[j] + q[k] * q[k]) / square;
    p.rotation[i][j] = 2 * (q[i] * q[j] - q[3] * q[k]) / square;
    p.rotation[i][k] = 2 * (q[i] * q[k] + q[3] * q[j]) / square;
    p.translation[i] = away * uniform(r, -1, 1);
  }
  for (int k = 0; k < 9 && off; k++) {
    p.rotation[k / 3][k % 3] += 1e-7 * uniform(r, -1, 1);
  }
  return p;
}

/* ----------------------------------------------------------------------------- bodies */

static void set(double v[3], double x, double y, double z) {
  v[0] = x;
  v[1] = y;
  v[2] = z;
}

static void add_triangle(situation *s, int body, const double p[3], const double q[3],
                         const double t[3]) {
  assert(s->count[body] < MOST);
  sepax_facet *f = &s->few[body][s->count[body]++];
  memcpy(f->v[0], p, sizeof f->v[0]);
  memcpy(f->v[1], q, sizeof f->v[1]);
  memcpy(f->v[2], t, sizeof f->v[2]);
}

static void add_quad(situation *s, int body, double p[4][3]) {
  add_triangle(s, body, p[0], p[1], p[2]);
  add_triangle(s, body, p[0], p[2], p[3]);
}

/* n x m cells of a grid at height z, whose heights vary by up to `rough`. */
static void add_plate(situation *s, int body, int n, int m, double z, double rough,
                      sepax_random *r) {
  double height[9][9];
  for (int k = 0; k < 81; k++) {
    height[k / 9][k % 9] = rough > 0 ? z + uniform(r, -rough, rough) : z;
  }
  for (int i = 0; i < n; i++) {
    for (int j = 0; j < m; j++) {
      double p[4][3];
      for (int k = 0; k < 4; k++) {
        int x = i + (k == 1 || k == 2);
        int y = j + k / 2;
        set(p[k], x, y, height[x][y]);
      }
      add_quad(s, body, p);
    }
  }
}

static void add_box(situation *s, int body, const double low[3], const double high[3]) {
  for (int axis = 0; axis < 3; axis++) {
    for (int side = 0; side < 2; side++) {
      double p[4][3];
      for (int k = 0; k < 4; k++) {
        p[k][axis] = side == 0 ? low[axis] : high[axis];
        p[k][(axis + 1) % 3] = k == 1 || k == 2 ? high[(axis + 1) % 3] : low[(axis + 1) % 3];
        p[k][(axis + 2) % 3] = k / 2 == 1 ? high[(axis + 2) % 3] : low[(axis + 2) % 3];
      }
      add_quad(s, body, p);
    }
  }
}

static void add_sphere(situation *s, int body, double radius, int slices, int rings) {
  const double pi = 3.14159265358979323846;
  double at[8][9][3];
  for (int i = 0; i <= rings; i++) {
    for (int j = 0; j <= slices; j++) {
      double up_angle = pi * i / rings;
      double round_angle = 2 * pi * (j % slices) / slices;
      set(at[i][j], radius * sin(up_angle) * cos(round_angle),
          radius * sin(up_angle) * sin(round_angle), radius * cos(up_angle));
    }
  }
  for (int i = 0; i < rings; i++) {
    for (int j = 0; j < slices; j++) {
      if (i > 0) {
        add_triangle(s, body, at[i][j], at[i + 1][j], at[i][j + 1]);
      }
      if (i + 1 < rings) {
        add_triangle(s, body, at[i + 1][j], at[i + 1][j + 1], at[i][j + 1]);
      }
    }
  }
}

static size_t some(sepax_random *r) {
  return (size_t)(one_in(r, 40)  ? range(r, 20, 60)
                  : one_in(r, 4) ? range(r, 9, 20)
                                 : range(r, 1, 8));
}

static void strew(situation *s, int body, double size, sepax_random *r) {
  for (size_t n = some(r); n > 0; n--) {
    double v[3][3];
    for (int k = 0; k < 9; k++) {
      v[k / 3][k % 3] = k < 3 ? uniform(r, -1, 1) : v[0][k % 3] + size * uniform(r, -1, 1);
    }
    add_triangle(s, body, v[0], v[1], v[2]);
  }
}

static void move(situation *s, int body, double x, double y, double z) {
  const double by[3] = {x, y, z};
  for (size_t n = 0; n < 9 * s->count[body]; n++) {
    s->few[body][n / 9].v[n / 3 % 3][n % 3] += by[n % 3];
  }
}

static void copy_body(situation *s) {
  memcpy(s->few[1], s->few[0], sizeof s->few[0]);
  s->count[1] = s->count[0];
}

/* 2^-k, or a number of that size. */
static double little(sepax_random *r, int least, int most) {
  double part = one_in(r, 2) ? 1 : uniform(r, 0.5, 1);
  return ldexp(part, -(int)range(r, least, most));
}

static void draw_tied(situation *s, sepax_random *r) {
  int n = one_in(r, 10) ? 5 : (int)range(r, 1, 3);
  int m = (int)range(r, 1, 3);
  add_plate(s, 0, n, m, 0, 0, r);
  add_plate(s, 1, one_in(r, 2) ? n : 1, m, 0, 0, r);
  double aside = (double)range(r, 0, 2) * 0.5;
  move(s, 1, one_in(r, 2) ? 0 : aside, aside,
       one_in(r, 2) ? (double)range(r, 1, 4) : little(r, 0, 40));
}

static void draw_touching(situation *s, sepax_random *r) {
  const double low[3] = {0, 0, 0};
  const double high[3] = {1, (double)range(r, 1, 3), 1};
  add_box(s, 0, low, high);
  add_box(s, 1, low, high);
  double gap = one_in(r, 3) ? 0 : little(r, 0, 55);
  double aside = one_in(r, 2) ? 0.25 * (double)range(r, 0, 4) : uniform(r, 0, 1);
  move(s, 1, one_in(r, 2) ? 0 : aside, aside, 1 + gap);
}

static void draw_nested(situation *s, sepax_random *r) {
  double low[3] = {-1, -1, -1};
  double high[3] = {1, 1, 1};
  add_box(s, 0, low, high);
  for (int i = 0; i < 3; i++) {
    double half = one_in(r, 2) ? 0.5 : uniform(r, 0.1, 0.9);
    low[i] = -half;
    high[i] = half;
  }
  if (one_in(r, 2)) {
    add_box(s, 1, low, high);
  } else {
    add_sphere(s, 1, 0.75, 4, 2);
  }
  if (one_in(r, 2)) {
    move(s, 1, 0.25 * (double)range(r, -1, 1), 0.125 * (double)range(r, -1, 1), little(r, 4, 50));
  }
}

static void draw_slivers(situation *s, sepax_random *r) {
  for (int body = 0; body < 2; body++) {
    strew(s, body, 1, r);
    for (size_t n = 0; n < s->count[body]; n++) {
      double(*v)[3] = s->few[body][n].v;
      double t = one_in(r, 3) ? (double)range(r, 0, 1) : uniform(r, 0, 1);
      double off = one_in(r, 3) ? 0 : little(r, 0, 60);
      bool point = one_in(r, 9);
      for (int i = 0; i < 3; i++) {
        v[2][i] = v[0][i] + t * (v[1][i] - v[0][i]) + off * uniform(r, -1, 1);
        v[1][i] = point ? v[0][i] : v[1][i];
      }
    }
  }
  move(s, 1, uniform(r, -2, 2), uniform(r, -2, 2), 0);
}

static void draw_mixed(situation *s, sepax_random *r) {
  int span = one_in(r, 4) ? 900 : 40;
  for (int body = 0; body < 2; body++) {
    for (size_t n = (size_t)range(r, 1, 4); n > 0; n--) {
      double v[3][3];
      int of_triangle = (int)range(r, -span, span) / 2;
      for (int k = 0; k < 9; k++) {
        int exponent = of_triangle + (one_in(r, 3) ? (int)range(r, -span, span) / 2 : 0);
        v[k / 3][k % 3] =
            ldexp(one_in(r, 2) ? (double)range(r, -2, 2) : uniform(r, -1, 1), exponent);
      }
      add_triangle(s, body, v[0], v[1], v[2]);
    }
  }
}

static void draw_far(situation *s, sepax_random *r) {
  for (int body = 0; body < 2; body++) {
    double size = little(r, 0, 40);
    for (size_t n = (size_t)range(r, 1, 5); n > 0; n--) {
      double v[3][3];
      for (int k = 0; k < 9; k++) {
        v[k / 3][k % 3] = size * uniform(r, -1, 1);
      }
      add_triangle(s, body, v[0], v[1], v[2]);
    }
  }
  move(s, 1, little(r, 0, 50), 1, 1);
  if (one_in(r, 2)) {
    move(s, 0, 1, 1, 1);
  }
}

static void draw_alike(situation *s, sepax_random *r) {
  double v[2][3][3];
  for (int k = 0; k < 18; k++) {
    v[k / 9][k / 3 % 3][k % 3] = uniform(r, -1, 1) + (k >= 9 && k % 3 == 0 ? 1.5 : 0);
  }
  for (int body = 0; body < 2; body++) {
    for (size_t n = (size_t)range(r, 1, one_in(r, 20) ? 20 : 5); n > 0; n--) {
      double t[3][3];
      for (int k = 0; k < 9; k++) {
        t[k / 3][k % 3] = v[body][k / 3][k % 3];
        for (int64_t steps = range(r, 0, 4); steps > 0; steps--) {
          t[k / 3][k % 3] = up(t[k / 3][k % 3]);
        }
      }
      add_triangle(s, body, t[0], t[1], t[2]);
    }
  }
}

/* A plate below a box that stands on an edge, or on a corner, turned in its own coordinates. */
static void draw_on_edge(situation *s, sepax_random *r) {
  const double low[3] = {-1, -1, -1};
  const double high[3] = {1, 1, 1};
  add_plate(s, 0, (int)range(r, 1, 4), (int)range(r, 1, 3), 0, 0, r);
  add_box(s, 1, low, high);
  double half = sqrt(0.5);
  bool corner = one_in(r, 2);
  for (size_t n = 0; n < 3 * s->count[1]; n++) {
    double *v = s->few[1][n / 3].v[n % 3];
    const double x[3] = {v[0], half * (v[1] - v[2]), half * (v[1] + v[2])};
    set(v, corner ? half * (x[0] - x[2]) : x[0], x[1], corner ? half * (x[0] + x[2]) : x[2]);
  }
  move(s, 1, uniform(r, 0, 2), uniform(r, 0, 2), 2 + little(r, 0, 50));
}

static void draw_spheres(situation *s, sepax_random *r) {
  add_sphere(s, 0, 1, (int)range(r, 3, 6), (int)range(r, 2, 4));
  add_sphere(s, 1, 1.1 + 2 * little(r, 0, 20), (int)range(r, 3, one_in(r, 8) ? 8 : 5),
             (int)range(r, 2, 4));
}

static void draw_bodies(situation *s, kind what, sepax_random *r) {
  switch (what) {
  case TIED:
    draw_tied(s, r);
    break;
  case TOUCHING:
    draw_touching(s, r);
    break;
  case NESTED:
    draw_nested(s, r);
    break;
  case COPY:
    add_plate(s, 0, (int)range(r, 1, 4), (int)range(r, 1, 3), 0, uniform(r, 0, 0.5), r);
    copy_body(s);
    move(s, 1, one_in(r, 2) ? 0 : little(r, 1, 30), one_in(r, 2) ? 0 : little(r, 1, 30),
         little(r, 1, 50));
    break;
  case SLIVERS:
    draw_slivers(s, r);
    break;
  case MIXED:
    draw_mixed(s, r);
    break;
  case FAR:
    draw_far(s, r);
    break;
  case ALIKE:
    draw_alike(s, r);
    break;
  case ON_EDGE:
    draw_on_edge(s, r);
    break;
  case SPHERES:
    draw_spheres(s, r);
    break;
  default:
    strew(s, 0, 0.3, r);
    strew(s, 1, 0.3, r);
    move(s, 1, uniform(r, -3, 3), uniform(r, -1, 1), 0);
    break;
  }
}

/* ------------------------------------------------------------------------- large bodies */

enum { POOL = 6 };

static struct {
  sepax_soup mesh;
  sepax_body *body;
  double size;
} pool[POOL];

static void make_body(sepax_body **body, const sepax_facet *facet, size_t count) {
  sepax_error error;
  if (!sepax_body_new(body, &SEPAX_STRUCT(sepax_mesh, .vertex = facet, .triangles = count), NULL,
                      &error)) {
    bench_fail(&error);
  }
}

static void make_pool(void) {
  static const struct {
    const char *shape;
    size_t count;
    double size;
  } samples[POOL] = {{"sphere", 2000, 40},   {"sphere", 2000, 43}, {"pocket", 3000, 100},
                     {"ball-end", 2000, 40}, {"sphere", 300, 1},   {"ball-end", 10000, 40}};
  const double origin[3] = {0, 0, 0};
  sepax_error error;
  for (int k = 0; k < POOL; k++) {
    if (!sepax_sample(&pool[k].mesh, samples[k].shape, samples[k].count, origin, samples[k].size,
                      &error)) {
      bench_fail(&error);
    }
    pool[k].size = samples[k].size;
    make_body(&pool[k].body, pool[k].mesh.facet, pool[k].mesh.count);
  }
}

static void free_pool(void) {
  for (int k = 0; k < POOL; k++) {
    sepax_body_free(pool[k].body);
    sepax_soup_free(&pool[k].mesh);
  }
}

static void draw_large(situation *s, sepax_random *r) {
  double size = 0;
  for (int k = 0; k < 2; k++) {
    size_t which = (size_t)range(r, 0, POOL - 1);
    s->facet[k] = pool[which].mesh.facet;
    s->count[k] = pool[which].mesh.count;
    s->body[k] = pool[which].body;
    size = fmax(size, pool[which].size);
  }
  s->pose[0] = any_pose(one_in(r, 2) ? 0 : size, r);
  s->pose[1] = any_pose(size * uniform(r, 0, 4), r);
  s->given[0] = one_in(r, 2) ? NULL : &s->pose[0];
  s->given[1] = one_in(r, 8) ? NULL : &s->pose[1];
}

/* ------------------------------------------------------------------------- situations */

static void draw(situation *s, kind what, sepax_random *r) {
  if (what == LARGE) {
    draw_large(s, r);
    return;
  }
  draw_bodies(s, what, r);
  int exponent = what == MIXED ? 0 : (int)range(r, -30, 30) * (one_in(r, 8) ? 10 : 1);
  double unit = ldexp(one_in(r, 2) ? 1 : 0.1, exponent);
  for (int k = 0; k < 2; k++) {
    for (size_t n = 0; n < 9 * s->count[k]; n++) {
      s->few[k][n / 9].v[n / 3 % 3][n % 3] *= unit;
    }
    s->facet[k] = s->few[k];
  }
  double away = one_in(r, 4) ? 0 : unit * (one_in(r, 4) ? 1e6 : 2);
  s->pose[0] = any_pose(away, r);
  s->pose[1] = one_in(r, 2) ? s->pose[0] : any_pose(away, r);
  switch (range(r, 0, 3)) {
  case 0: /* as they are drawn */
    break;
  case 1: /* both in one pose: what is tied stays so */
    s->given[0] = s->given[1] = &s->pose[0];
    break;
  case 2:
    s->given[1] = &s->pose[1];
    break;
  default:
    s->given[0] = &s->pose[0];
    s->given[1] = &s->pose[1];
    break;
  }
  make_body(&s->body[0], s->few[0], s->count[0]);
  make_body(&s->body[1], s->few[1], s->count[1]);
}

static sepax_distance_result ask(const situation *s, const sepax_distance_request *request) {
  sepax_distance_result result;
  sepax_error error;
  if (!sepax_bodies_distance(s->body[0], s->given[0], s->body[1], s->given[1], request, &result,
                             &error)) {
    bench_fail(&error);
  }
  counted->answers++;
  return result;
}

static void find_pair_square(const situation *s, const size_t pair[2], exact_square *square) {
  distance_square_posed(square, s->facet[0][pair[0]].v, s->given[0], s->facet[1][pair[1]].v,
                        s->given[1]);
}

static void find_truth(situation *s, kind what) {
  exact_square_init(&s->square);
  if (what == LARGE) {
    sepax_distance_result exact = ask(s, NULL);
    find_pair_square(s, exact.pair, &s->square);
    s->slack_ulps = 1;
  } else {
    const oracle_body a = {s->facet[0], s->count[0], s->given[0]};
    const oracle_body b = {s->facet[1], s->count[1], s->given[1]};
    oracle_bodies_square(&s->square, &a, &b);
  }
  s->below = exact_square_root(&s->square);
  s->is_double = exact_square_compare_length(&s->square, s->below) == 0;
}

static void free_situation(situation *s, kind what) {
  exact_square_clear(&s->square);
  for (int k = 0; k < 2 && what != LARGE; k++) {
    sepax_body_free(s->body[k]);
  }
}

/* The sign of the distance less x. */
static int order(const situation *s, double x) {
  return x == INFINITY ? -1 : exact_square_compare_length(&s->square, x);
}

/* --------------------------------------------------------------------------- requests */

static double draw_tolerance(sepax_random *r) {
  static const double tolerances[] = {1e-3, 1e-6, 1e-6, 1e-12, 0x1p-52, 0.5};
  return tolerances[range(r, 0, 5)];
}

static uint64_t draw_budget(sepax_random *r) {
  static const uint64_t budgets[] = {1, 2, 10, 50, 100, 1000, 3000, 10000};
  return budgets[range(r, 0, 7)];
}

/* A length about the distance: below, above, or next to it. */
static double draw_length(const situation *s, sepax_random *r) {
  double x = s->below;
  switch (range(r, 0, 6)) {
  case 0:
    return x;
  case 1:
    return down(x);
  case 2:
    return up(x);
  case 3:
    return x * (1 - little(r, 0, 52));
  case 4:
    return fmin(x * (1 + little(r, 0, 52)), 0x1p999);
  case 5:
    return fmin(2 * x, 0x1p999);
  default:
    return 0.5 * x;
  }
}

/* A result of another pose, or of this one, which may be a collision, or infinite. */
static sepax_distance_result draw_last(const situation *s, const sepax_distance_result *exact,
                                       sepax_random *r) {
  if (one_in(r, 3)) {
    return *exact;
  }
  situation other = *s;
  double away = one_in(r, 2) ? s->below : 4 * s->below;
  other.pose[1] = any_pose(fmin(fmax(away, 0x1p-900), 0x1p900), r);
  other.given[1] = &other.pose[1];
  double limit = one_in(r, 5) ? s->below : 0;
  return ask(&other, &SEPAX_STRUCT(sepax_distance_request, .relative = 1e-3, .limit = limit));
}

static void draw_request(sepax_distance_request *q, const situation *s, sepax_random *r) {
  *q = SEPAX_STRUCT(sepax_distance_request, .limit = 0);
  if (!one_in(r, 4)) {
    q->relative = draw_tolerance(r);
  }
  if (one_in(r, 4)) {
    q->absolute = one_in(r, 2) ? s->below * draw_tolerance(r) : little(r, 0, 100);
  }
  if (one_in(r, 2)) {
    q->work = draw_budget(r);
  }
  if (one_in(r, 4)) {
    q->limit = draw_length(s, r);
  }
}

/* ------------------------------------------------------------------------------ checks */

static uint64_t bits_of(double x) {
  uint64_t bits;
  memcpy(&bits, &x, sizeof bits);
  return bits;
}

/* Both answers, member by member, because the bytes between members may have any value. */
static bool same_bytes(const sepax_distance_result *p, const sepax_distance_result *q) {
  bool same = bits_of(p->min_distance) == bits_of(q->min_distance) &&
              bits_of(p->least) == bits_of(q->least) && bits_of(p->most) == bits_of(q->most);
  for (int k = 0; k < 6; k++) {
    same = same &&
           bits_of(p->nearest_points[k / 3][k % 3]) == bits_of(q->nearest_points[k / 3][k % 3]);
  }
  for (int k = 0; k < 2; k++) {
    same = same && p->pair[k] == q->pair[k] && p->box[k] == q->box[k];
  }
  return same && p->work == q->work && p->ended == q->ended;
}

static const char *said(sepax_simd second) {
  return second == SEPAX_SIMD_PORTABLE ? ", then without vector instructions," : "";
}

static void plant(sepax_distance_result *a, const sepax_distance_request *q, const situation *s) {
  bool exact = q->relative == 0 && q->absolute == 0;
  switch (planted) {
  case LEAST_ABOVE:
    a->least = up(s->below);
    break;
  case MOST_BELOW:
    a->most = s->is_double ? down(s->below) : s->below;
    break;
  case TOO_WIDE:
    if (isfinite(a->most) && !a->ended && q->absolute < a->most) {
      a->least = 0;
      a->most *= 2;
    }
    break;
  case OTHER_PAIR:
    a->pair[0] = (a->pair[0] + 1) % s->count[0];
    break;
  case ONE_ULP:
    a->min_distance = exact ? up(up(a->min_distance)) : a->min_distance;
    break;
  case TOO_MUCH:
    a->work = q->work + OVERSHOOT + 1;
    break;
  case LOST:
    if (q->limit > 0) {
      *a = (sepax_distance_result){.min_distance = INFINITY, .least = a->least, .most = INFINITY};
    }
    break;
  default:
    break;
  }
}

/* The distance between the answer's points is that of the pair, but for rounding. */
static bool points_fit(const situation *s, const sepax_distance_result *a) {
  long double square = 0;
  double size = 0;
  for (int i = 0; i < 3; i++) {
    long double way = (long double)a->nearest_points[1][i] - (long double)a->nearest_points[0][i];
    square += way * way;
  }
  for (int k = 0; k < 2; k++) {
    for (int n = 0; n < 9; n++) {
      size = fmax(size, fabs(s->facet[k][a->pair[k]].v[n / 3][n % 3]));
      size = fmax(size, s->given[k] != NULL ? fabs(s->given[k]->translation[n % 3]) : 0);
    }
  }
  return fabsl(sqrtl(square) - (long double)a->min_distance) <=
         0x1p-48L * (long double)size + 0x1p-1070L;
}

static void check_pair(const situation *s, const sepax_distance_result *a) {
  double m = a->min_distance;
  if (a->pair[0] >= s->count[0] || a->pair[1] >= s->count[1]) {
    wrong("there is no pair %zu, %zu", a->pair[0], a->pair[1]);
    return;
  }
  double posed = sepax_distance_posed(s->facet[0][a->pair[0]].v, s->given[0],
                                      s->facet[1][a->pair[1]].v, s->given[1], NULL);
  if (posed != m) {
    wrong("min_distance is %a, but that of its pair is %a", m, posed);
  }
  exact_square square;
  exact_square_init(&square);
  find_pair_square(s, a->pair, &square);
  bool right = m == 0 ? exact_square_compare_length(&square, 0) == 0
                      : exact_square_compare_length(&square, down(m)) > 0 &&
                            exact_square_compare_length(&square, up(m)) < 0;
  exact_square_clear(&square);
  if (!right) {
    wrong("min_distance %a is not right to one unit in the last place for its pair", m);
  }
  if (!points_fit(s, a)) {
    wrong("the nearest points are not min_distance %a apart", m);
  }
}

static void check_interval(const situation *s, const sepax_distance_request *q,
                           const sepax_distance_result *a) {
  double most = s->slack_ulps > 0 ? up(a->most) : a->most;
  if (!(a->least >= 0 && a->least <= a->most)) {
    wrong("the interval is %a ... %a", a->least, a->most);
  } else if (order(s, a->least) < 0) {
    wrong(
        "least is %a, above the distance: %a is below it (tolerance %g, %g, limit %a, work %" PRIu64
        "%s)",
        a->least, s->below, q->relative, q->absolute, q->limit, q->work,
        q->last != NULL ? ", last" : "");
  } else if (order(s, most) > 0) {
    wrong("most is %a, below the distance of at least %a", a->most, s->below);
  }
}

static void check_width(const situation *s, const sepax_distance_request *q,
                        const sepax_distance_result *a) {
  double m = a->min_distance;
  long double width = (long double)a->most - (long double)a->least;
  bool neighbours = a->least >= down(m) && a->most <= up(m);
  bool within =
      width <= (long double)q->relative * (long double)a->most || width <= (long double)q->absolute;
  if (!within && !neighbours) {
    wrong("the interval %a ... %a is wider than its tolerance: %g, %g", a->least, a->most,
          q->relative, q->absolute);
  }
  bool exact = q->relative == 0 && q->absolute == 0;
  double slack = s->slack_ulps > 0 ? up(m) : m;
  if (exact && !(m == 0 ? order(s, 0) == 0 : order(s, down(m)) > 0 && order(s, up(slack)) < 0)) {
    wrong("the exact distance is not %a but near %a", m, s->below);
  }
}

static void check_limits(const situation *s, const sepax_distance_request *q,
                         const sepax_distance_result *a) {
  if (q->work == 0 && a->ended) {
    wrong("a search without a budget ended");
  }
  if (q->work > 0 && a->work > q->work + OVERSHOOT) {
    wrong("%" PRIu64 " units of work within a budget of %" PRIu64, a->work, q->work);
  }
  if (q->work > 0 && a->ended && a->work < q->work) {
    wrong("ended after %" PRIu64 " units of a budget of %" PRIu64, a->work, q->work);
  }
  if (a->min_distance == INFINITY) {
    if (!a->ended && !(q->limit > 0 && a->least >= q->limit && order(s, q->limit) >= 0)) {
      wrong("infinite, with least %a, at a limit of %a and a distance near %a", a->least, q->limit,
            s->below);
    }
    if (a->most != INFINITY) {
      wrong("most is %a where min_distance is infinite", a->most);
    }
  } else if (q->limit > 0 && a->min_distance > q->limit) {
    wrong("%a is above the limit of %a and is not infinite", a->min_distance, q->limit);
  }
}

static void check_answer(const situation *s, const sepax_distance_request *q,
                         sepax_distance_result *a) {
  plant(a, q, s);
  counted->ended += a->ended;
  check_interval(s, q, a);
  check_limits(s, q, a);
  if (a->min_distance != INFINITY) {
    check_pair(s, a);
    if (!a->ended) {
      check_width(s, q, a);
    }
  }
}

static void check_distances(const situation *s, sepax_random *r) {
  const sepax_distance_request plain = SEPAX_STRUCT(sepax_distance_request, .limit = 0);
  sepax_distance_result exact = ask(s, &plain);
  sepax_distance_result last;
  check_answer(s, &plain, &exact);
  exact = ask(s, &plain);
  for (int n = 0; n < REQUESTS; n++) {
    sepax_distance_request q;
    draw_request(&q, s, r);
    if (one_in(r, 2)) {
      last = draw_last(s, &exact, r);
      q.last = &last;
    }
    sepax_distance_result answer = ask(s, &q);
    q.simd = one_in(r, 2) ? SEPAX_SIMD_BEST : SEPAX_SIMD_PORTABLE;
    sepax_distance_result again = ask(s, &q);
    again.box[0] ^= planted == OTHER_BYTES;
    if (q.simd == SEPAX_SIMD_BEST && !same_bytes(&answer, &again)) {
      wrong("the same arguments%s gave %a ... %a (%" PRIu64 " units) and %a ... %a (%" PRIu64
            " units)",
            said(q.simd), answer.least, answer.most, answer.work, again.least, again.most,
            again.work);
    }
    check_answer(s, &q, q.simd == SEPAX_SIMD_BEST ? &answer : &again);
  }
  if (one_in(r, 16)) {
    sepax_distance_request q = SEPAX_STRUCT(sepax_distance_request, .seconds = 1e-7);
    sepax_distance_result hurried = ask(s, &q);
    check_interval(s, &q, &hurried);
  }
}

/* ------------------------------------------------------------------------------- apart */

static sepax_apart_result ask_apart(const situation *s, double distance,
                                    const sepax_apart_request *request) {
  sepax_apart_result result;
  sepax_error error;
  if (!sepax_bodies_apart(s->body[0], s->given[0], s->body[1], s->given[1], distance, request,
                          &result, &error)) {
    bench_fail(&error);
  }
  counted->answers++;
  return result;
}

static void check_near(const situation *s, double distance, const sepax_apart_result *a) {
  if (a->pair[0] >= s->count[0] || a->pair[1] >= s->count[1]) {
    wrong("there is no near pair %zu, %zu", a->pair[0], a->pair[1]);
    return;
  }
  exact_square square;
  exact_square_init(&square);
  find_pair_square(s, a->pair, &square);
  if (exact_square_compare_length(&square, distance) > 0) {
    wrong("pair %zu, %zu is not within %a", a->pair[0], a->pair[1], distance);
  }
  exact_square_clear(&square);
}

static void check_apart(const situation *s, double distance, sepax_random *r) {
  sepax_apart_request q = SEPAX_STRUCT(sepax_apart_request, .work = 0);
  q.work = one_in(r, 2) ? draw_budget(r) : 0;
  q.simd = one_in(r, 2) ? SEPAX_SIMD_BEST : SEPAX_SIMD_PORTABLE;
  sepax_apart_result a = ask_apart(s, distance, &q);
  sepax_apart_result again = ask_apart(s, distance, &q);
  if (again.verdict != a.verdict || again.work != a.work || again.pair[0] != a.pair[0] ||
      again.pair[1] != a.pair[1] || bits_of(again.least) != bits_of(a.least)) {
    wrong("the same arguments%s gave two answers: is it farther than %a?", said(q.simd), distance);
  }
  if (planted == WRONG_APART && a.verdict != SEPAX_UNDECIDED) {
    a.verdict = a.verdict == SEPAX_APART ? SEPAX_NEAR : SEPAX_APART;
  }
  a.least = planted == LEAST_ABOVE ? up(s->below) : a.least;
  a.work = planted == TOO_MUCH ? q.work + OVERSHOOT + 1 : a.work;
  counted->ended += a.verdict == SEPAX_UNDECIDED;
  /* Of large bodies the truth may be an ulp less. */
  bool far = order(s, distance) > 0;
  bool unsure = s->slack_ulps > 0 && distance >= down(s->below) && distance <= s->below;
  if (a.verdict == SEPAX_UNDECIDED ? q.work == 0 || a.work < q.work
                                   : (a.verdict == SEPAX_APART) != far && !unsure) {
    wrong("%s farther than %a, at a distance near %a, work %" PRIu64 " of %" PRIu64,
          a.verdict == SEPAX_UNDECIDED ? "undecided whether it is"
          : a.verdict == SEPAX_APART   ? "it is not"
                                       : "it is",
          distance, s->below, a.work, q.work);
  }
  if (!(a.least >= 0) || order(s, a.least) < 0 ||
      (a.verdict == SEPAX_APART && a.least < distance)) {
    wrong("least is %a, asked about %a, at a distance near %a", a.least, distance, s->below);
  }
  if (q.work > 0 && a.work > q.work + OVERSHOOT) {
    wrong("%" PRIu64 " units of work within a budget of %" PRIu64, a.work, q.work);
  }
  if (a.verdict == SEPAX_NEAR) {
    check_near(s, distance, &a);
  }
}

static void check_all_apart(const situation *s, sepax_random *r) {
  const double next[] = {s->below, down(s->below), up(s->below)};
  for (int n = 0; n < REQUESTS; n++) {
    check_apart(s, n < 3 ? next[n] : one_in(r, 4) ? 0 : draw_length(s, r), r);
  }
}

/* ------------------------------------------------------------------------------ fronts */

enum { STEPS = 8, FRONT_MOST = 600 };

/* A rotation by a small angle about any axis. */
static sepax_pose small_turn(double angle, sepax_random *r) {
  const double x = 0.5 * angle * uniform(r, -1, 1);
  const double y = 0.5 * angle * uniform(r, -1, 1);
  const double z = 0.5 * angle * uniform(r, -1, 1);
  const double n = 2 / (1 + x * x + y * y + z * z);
  return (sepax_pose){{{1 - n * (y * y + z * z), n * (x * y - z), n * (x * z + y)},
                       {n * (x * y + z), 1 - n * (x * x + z * z), n * (y * z - x)},
                       {n * (x * z - y), n * (y * z + x), 1 - n * (x * x + y * y)}},
                      {0, 0, 0}};
}

/* About the largest coordinate of a body. */
static double size_of(const situation *s, int body) {
  double most = 0;
  for (size_t n = 0; n<9 * s->count[body]; n += s->count[body]> MOST ? 91 : 1) {
    most = fmax(most, fabs(s->facet[body][n / 9].v[n / 3 % 3][n % 3]));
  }
  return most;
}

/* Move one body by about `way`, or both together by much. */
static void step(situation *s, double way, sepax_random *r) {
  const bool both = one_in(r, 4);
  const int moved = (int)range(r, 0, 1);
  const double angle = fmin(way / fmax(size_of(s, moved), 0x1p-900), 1);
  sepax_pose by =
      both ? any_pose(fmin(16 * way, 0x1p900), r) : small_turn(one_in(r, 3) ? 0 : angle, r);
  for (int i = 0; i < 3 && !both; i++) {
    by.translation[i] = one_in(r, 3) ? 0 : way * uniform(r, -1, 1);
  }
  for (int k = 0; k < 2; k++) {
    s->pose[k] = s->given[k] != NULL ? *s->given[k] : small_turn(0, r);
    if (both || k == moved) {
      s->pose[k] = sepax_pose_compose(&by, &s->pose[k]);
    }
    s->given[k] = &s->pose[k];
  }
}

static bool poses_are_valid(const situation *s) {
  bool ok = true;
  for (int k = 0; k < 2; k++) {
    ok = ok && sepax_pose_valid(&s->pose[k], NULL);
    for (int i = 0; i < 3; i++) {
      ok = ok && fabs(s->pose[k].translation[i]) <= 0x1p1000;
    }
  }
  return ok;
}

/* One query with a front, against a query without and against the truth. */
static void check_front(const situation *s, double distance, sepax_front *front, uint64_t work,
                        sepax_apart_result *before) {
  const sepax_apart_request q = SEPAX_STRUCT(sepax_apart_request, .front = front, .work = work);
  sepax_apart_result a = ask_apart(s, distance, &q);
  if (planted == STALE) {
    sepax_apart_result now = a;
    a = *before;
    *before = now;
  }
  bool far = order(s, distance) > 0;
  bool unsure = s->slack_ulps > 0 && distance >= down(s->below) && distance <= s->below;
  if (a.verdict == SEPAX_UNDECIDED ? work == 0 : (a.verdict == SEPAX_APART) != far && !unsure) {
    wrong("with a front it is %s than %a, at a distance near %a",
          a.verdict == SEPAX_APART ? "farther" : "not farther", distance, s->below);
  }
  if (!(a.least >= 0) || order(s, a.least) < 0 ||
      (a.verdict == SEPAX_APART && a.least < distance)) {
    wrong("with a front, least is %a, asked about %a, at a distance near %a", a.least, distance,
          s->below);
  }
  if (work > 0 && a.work > work + OVERSHOOT) {
    wrong("with a front, %" PRIu64 " units of work within a budget of %" PRIu64, a.work, work);
  }
  if (a.verdict == SEPAX_NEAR) {
    check_near(s, distance, &a);
  }
}

/* The bodies in the other order. */
static situation exchanged(const situation *s) {
  situation other = *s;
  for (int k = 0; k < 2; k++) {
    other.facet[k] = s->facet[!k];
    other.count[k] = s->count[!k];
    other.body[k] = s->body[!k];
    other.given[k] = s->given[!k];
  }
  return other;
}

/* Queries with one front along a walk. */
static void check_walk(const situation *s, kind what, sepax_random *r) {
  static char memory[1 << 14];
  static const size_t capacities[] = {0, 1, 8, 40, FRONT_MOST, FRONT_MOST};
  sepax_front *front;
  sepax_error error;
  size_t bytes = sepax_front_bytes(capacities[range(r, 0, 5)]);
  assert(bytes <= sizeof memory);
  if (!sepax_front_begin(&front, memory, bytes, &error)) {
    bench_fail(&error);
  }
  situation at = *s;
  sepax_apart_result before = {SEPAX_UNDECIDED, {0, 0}, 0, 0};
  double way = fmax(s->below, 0x1p-20 * size_of(s, 0)) * little(r, 1, 12);
  double distance = fmin(s->below * (1 - little(r, 0, 12)), 0x1p999);
  for (int n = 0; n < STEPS; n++) {
    uint64_t work = one_in(r, 6) ? draw_budget(r) : 0;
    if (n > 0 && !one_in(r, 5)) {
      step(&at, one_in(r, 12) ? fmin(64 * way, 0x1p900) : way, r);
    }
    if (!poses_are_valid(&at)) {
      return;
    }
    find_truth(&at, what);
    distance = one_in(r, 3) ? draw_length(&at, r) : one_in(r, 12) ? 0 : distance;
    check_front(&at, distance, front, work, &before);
    if (one_in(r, 12)) {
      situation other = exchanged(&at);
      check_front(&other, distance, front, work, &before);
    }
    exact_square_clear(&at.square);
  }
}

/* --------------------------------------------------------------------------- campaign */

/* One case in so many is of large bodies, which take longer. */
enum { LARGE_EVERY = 24 };

static fault fault_of(const char *name) {
  int n = 1;
  while (n < FAULTS && strcmp(fault_names[n], name) != 0) {
    n++;
  }
  return (fault)n;
}

int main(int argc, char **argv) {
  char *end[2] = {NULL, NULL};
  bool ok = argc == 3 || argc == 4;
  uint64_t count = ok ? strtoull(argv[1], &end[0], 10) : 0;
  sepax_random random = {ok ? strtoull(argv[2], &end[1], 10) : 0};
  planted = argc == 4 ? fault_of(argv[3]) : NO_FAULT;
  if (count == 0 || *end[0] != '\0' || *end[1] != '\0' || planted == FAULTS) {
    fputs("usage: distances COUNT SEED [least|most|width|pair|ulp|bytes|work|limit|front|apart]\n",
          stderr);
    return 2;
  }
  tally of[KINDS] = {{0}};
  uint64_t all_wrong = 0;
  make_pool();
  for (uint64_t n = 0; n < count; n++) {
    kind what = n % LARGE_EVERY == LARGE_EVERY - 1 ? LARGE : (kind)(n % LARGE);
    situation s = {.count = {0, 0}};
    counted = &of[what];
    at_work = kind_names[what];
    case_number = n;
    draw(&s, what, &random);
    find_truth(&s, what);
    counted->cases++;
    counted->touching += order(&s, 0) == 0;
    check_distances(&s, &random);
    check_all_apart(&s, &random);
    if (one_in(&random, 3)) {
      check_walk(&s, what, &random);
    }
    free_situation(&s, what);
    if (n % 1000 == 0 && isatty(2)) {
      fprintf(stderr, "  %" PRIu64 " of %" PRIu64 "\r", n, count);
    }
  }
  free_pool();
  for (int k = 0; k < KINDS; k++) {
    printf("%s %" PRIu64 " %" PRIu64 " %" PRIu64 " %" PRIu64 " %" PRIu64 "\n", kind_names[k],
           of[k].cases, of[k].answers, of[k].touching, of[k].ended, of[k].wrong);
    all_wrong += of[k].wrong;
  }
  return all_wrong > 0;
}
