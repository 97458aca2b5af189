/* SPDX-License-Identifier: MIT */
/* distance_points.c - vertices of two posed triangles in numbers of twice the precision
 * (distance/distance.c): `lost`. */
#define sepax__distance_and_way distance_and_way_of_test
#define sepax__distance_at_least distance_at_least_of_test
#define sepax__distance_compare distance_compare_of_test
#include "distance/distance.c" /* NOLINT(bugprone-suspicious-include): its functions are static */

#include "wide.h"

enum { POSE = 16, VERTICES = 2 * POSE };

/* What of `lost` does the distance of two vertices take? */
static double lost_part(const double *x) {
  double v[2][3][3];
  wide_point exact[6];
  sepax_pose pose[2];
  twofold_points p;
  wide most = 0;
  memcpy(v, x + VERTICES, sizeof v);
  for (int body = 0; body < 2; body++) {
    skewed_rotation(x + body * POSE, x + body * POSE + 4, 0, pose[body].rotation);
    memcpy(pose[body].translation, x + body * POSE + 13, sizeof pose[body].translation);
    for (int k = 0; k < 3; k++) {
      wide_point local;
      wide_of(v[body][k], local);
      wide_move((const double(*)[3])pose[body].rotation, local, pose[body].translation,
                exact[3 * body + k]);
    }
  }
  find_twofold_points(&p, v[0], &pose[0], v[1], &pose[1]);
  const wide unit = ldexp(1, -p.exponent);
  for (int k = 0; k < 36; k++) {
    int from = k / 6;
    int to = k % 6;
    wide_point found;
    wide_point way;
    for (int i = 0; i < 3; i++) {
      const twofold *c[2] = {&p.v[from].c[i], &p.v[to].c[i]};
      found[i] = ((wide)c[1]->high - c[0]->high) + ((wide)c[1]->low - c[0]->low);
      way[i] = (exact[to][i] - exact[from][i]) * unit;
    }
    wide_minus(found, way, found);
    most = wide_most(most, wide_length(found));
  }
  return (double)(most / p.lost);
}

CASE(posed_vertices) {
  assert_part("lost", most_of_bound(lost_part, VERTICES + 18, 8, 10000), 0.015);
}
