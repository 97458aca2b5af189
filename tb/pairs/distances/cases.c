/* SPDX-License-Identifier: MIT */
/* cases.c - draws two bodies in poses whose distance is hard to find, and finds it without
 * rounding. */
#include "cases.h"
#include "benchmark/columns.h"
#include "checks.h"
#include "pairs/rotation.h"

#include <assert.h>

/* ---------------------------------------------------------------------------- poses */

sepax_pose any_pose(double away, sepax_random *r) {
  sepax_pose p;
  random_rotation(p.rotation, r);
  bool off = one_in(r, 3);
  for (int i = 0; i < 3; i++) {
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

double little(sepax_random *r, int least, int most) {
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

void make_pool(void) {
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

void free_pool(void) {
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

void draw_situation(situation *s, kind what, sepax_random *r) {
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

sepax_distance_result ask(const situation *s, const sepax_distance_request *request) {
  sepax_distance_result result;
  sepax_error error;
  if (!sepax_bodies_distance(s->body[0], s->given[0], s->body[1], s->given[1], request, &result,
                             &error)) {
    bench_fail(&error);
  }
  counted->answers++;
  return result;
}

void find_pair_square(const situation *s, const size_t pair[2], exact_square *square) {
  distance_square_posed(square, s->facet[0][pair[0]].v, s->given[0], s->facet[1][pair[1]].v,
                        s->given[1]);
}

void find_truth(situation *s, kind what) {
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

void free_situation(situation *s, kind what) {
  exact_square_clear(&s->square);
  for (int k = 0; k < 2 && what != LARGE; k++) {
    sepax_body_free(s->body[k]);
  }
}

int order(const situation *s, double x) {
  return x == INFINITY ? -1 : exact_square_compare_length(&s->square, x);
}
