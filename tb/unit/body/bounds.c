/* SPDX-License-Identifier: MIT */
/* bounds.c - the bounds on rounding errors of a search for distances: placed vertices, pairs of
 * triangles, boxes in doubles (distance/bounds.c, reach.h, frames.c). Each bound holds for inputs
 * that a search makes as bad as it can, and they come near enough to it. */
#include "bounds_compiled.h"

#include "wide.h"

/* Points of the cube -1 ... 1. */
static void points_of(const double *x, int count, double v[][3]) {
  for (int k = 0; k < count; k++) {
    v[k / 3][k % 3] = x[k];
  }
}

/* --------------------------------------------------------------- placed vertices */

/* A pose of 16 inputs that is valid: its rotation is off by up to `skew`. */
static bool pose_of(const double *x, double skew, sepax_pose *pose) {
  skewed_rotation(x, x + 4, skew, pose->rotation);
  memcpy(pose->translation, x + 13, sizeof pose->translation);
  return sepax_pose_valid(pose, NULL);
}

static double vertex_error(const double *x) {
  sepax_pose pose;
  facet_points v;
  if (!pose_of(x, 1e-6, &pose)) {
    return -1;
  }
  points_of(x + 16, 3, v);
  points_of(x + 16, 3, v + 1);
  points_of(x + 16, 3, v + 2);
  const sepax_body b = {.triangle = &v};
  search s = {.body = {&b, &b}};
  find_world_pose(&s.pose[0], &pose, 1);
  placed_triangle t;
  place_triangle(&s, 0, BODY_TRIANGLE, t);
  double from[9 * 2];
  for (int k = 0; k < 18; k++) {
    from[k] = v[0][k / 2 % 3];
  }
  triangle_portable many;
  place_portable(&many, from, &s.pose[0]);
  wide_point at;
  wide_point own;
  wide_of(v[0], own);
  wide_move((const double(*)[3])pose.rotation, own, pose.translation, at);
  wide_point placed[2];
  for (int i = 0; i < 3; i++) {
    placed[0][i] = t[0][i];
    placed[1][i] = many.v[0].c[i][0];
  }
  return (double)(wide_most(wide_gap(placed[0], at), wide_gap(placed[1], at)) /
                  (wide)s.pose[0].error);
}

CASE(a_placed_vertex) {
  assert_part("2^-48 of a placed vertex", most_of_bound(vertex_error, 19, 8, 20000), 0.13);
}

/* ------------------------------------------------------------ pairs of triangles */

static const world_pose in_place = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}, 1, 0x1p-500};

static void enclose_pair(const double v[6][3], bool portable, const short_cut *cut,
                         pair_enclosure *e) {
  const search s = {.pose = {in_place, in_place}, .portable = portable};
  const int lanes = portable ? 2 : 4;
  pair_enclosure all[4];
  double from[18 * 4];
  for (int k = 0; k < 18; k++) {
    for (int n = 0; n < lanes; n++) {
      from[k * lanes + n] = v[k / 3][k % 3];
    }
  }
  enclose(&s, from, cut, all);
  *e = all[0];
}

static bool has_avx2(void) {
#if defined __x86_64__
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
  return false;
#endif
}

/* The largest coordinate from A_0. */
static double size_of_pair(const double v[6][3]) {
  double most = 0;
  for (int k = 0; k < 18; k++) {
    most = fmax(most, fabs(v[k / 3][k % 3] - v[0][k % 3]));
  }
  return most;
}

/* The gap on a direction, divided by its length; it is not above the distance. */
static wide gap_on(const double way[3], const wide v[6][3]) {
  wide_point w;
  wide least[2];
  wide most[2];
  wide_of(way, w);
  for (int k = 0; k < 6; k++) {
    wide at = wide_dot(w, v[k]);
    least[k / 3] = k % 3 == 0 ? at : wide_least(least[k / 3], at);
    most[k / 3] = k % 3 == 0 ? at : wide_most(most[k / 3], at);
  }
  return wide_most(least[1] - most[0], least[0] - most[1]) / wide_length(w);
}

static void pair_of(const double *x, double v[6][3], wide w[6][3]) {
  points_of(x, 18, v);
  for (int k = 0; k < 6; k++) {
    wide_of(v[k], w[k]);
  }
}

static const short_cut no_cut = {.enough = INFINITY};

/* What a gap on the way that is found takes of the error, or on any other way. */
static double least_error_of(const double *x, const short_cut *cut, bool portable) {
  double v[6][3];
  wide w[6][3];
  pair_enclosure e;
  pair_of(x, v, w);
  enclose_pair((const double(*)[3])v, portable, cut, &e);
  double error = PAIR_ERROR * size_of_pair((const double(*)[3])v);
  wide gap = gap_on(e.way, (const wide(*)[3])w);
  return !(e.least + error > 0) ? -1 : (double)((e.least + (wide)error - gap) / error);
}

static double cut_error_of(const double *x, bool portable) {
  short_cut cut = {.enough = -INFINITY};
  set_unit(cut.way[0], x + 18);
  return least_error_of(x, &cut, portable);
}

static double most_error_of(const double *x, bool portable) {
  double v[6][3];
  wide w[6][3];
  pair_enclosure e;
  pair_of(x, v, w);
  enclose_pair((const double(*)[3])v, portable, &no_cut, &e);
  double error = PAIR_ERROR * size_of_pair((const double(*)[3])v);
  wide distance = wide_triangles_reach((const wide(*)[3])w, (const wide(*)[3])(w + 3));
  return (double)((distance - (e.most - (wide)error)) / error);
}

static double least_error(const double *x) { return least_error_of(x, &no_cut, true); }
static double cut_error(const double *x) { return cut_error_of(x, true); }
static double most_error(const double *x) { return most_error_of(x, true); }
static double least_error_avx2(const double *x) { return least_error_of(x, &no_cut, false); }
static double cut_error_avx2(const double *x) { return cut_error_of(x, false); }
static double most_error_avx2(const double *x) { return most_error_of(x, false); }

CASE(a_pair_of_triangles) {
  assert_part("PAIR_ERROR below", most_of_bound(least_error, 18, 8, 20000), 0.0625);
  assert_part("PAIR_ERROR on a way", most_of_bound(cut_error, 21, 4, 8000), 0.0625);
  assert_part("PAIR_ERROR above", most_of_bound(most_error, 18, 4, 4000), 0.0625);
  if (has_avx2()) {
    assert_part("PAIR_ERROR below, AVX2", most_of_bound(least_error_avx2, 18, 8, 20000), 0.0625);
    assert_part("PAIR_ERROR on a way, AVX2", most_of_bound(cut_error_avx2, 21, 4, 8000), 0.0625);
    assert_part("PAIR_ERROR above, AVX2", most_of_bound(most_error_avx2, 18, 4, 4000), 0.0625);
  }
}
