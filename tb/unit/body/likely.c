/* SPDX-License-Identifier: MIT */
/* likely.c - the first guesses of searches: doubles nearly always find which features of two
 * triangles are nearest, so that whole numbers of any size are not needed. */
#include "distance/distance.h"
#include "harness.h"
#include "unit/body/draws.h"

#include <math.h>

enum { PAIRS = 3000 };

/* Of each kind: free; near each other; parallel; needles; far from the origin. */
static void draw(int kind, double v[2][3][3]) {
  for (int k = 0; k < 18; k++) {
    double x = random_unit();
    x += kind == 0 && k >= 9 && k % 3 == 0 ? 3 : 0;
    x = kind == 2 && k % 3 == 2 ? (k < 9 ? 0 : 0.5) : x;
    x = kind == 3 && k / 3 % 3 == 2 ? v[k / 9][1][k % 3] + 0x1p-20 * x : x;
    v[k / 9][k / 3 % 3][k % 3] = kind == 4 ? x + 1e6 * (k % 3) : x;
  }
}

CASE(doubles_find_what_is_nearest) {
  for (int kind = 0; kind < 5; kind++) {
    int found = 0;
    int free_pairs = 0;
    for (int n = 0; n < PAIRS; n++) {
      double v[2][3][3];
      double nearest[2][3];
      twofold_vector way;
      sepax_pose pose = turned_and_moved(1);
      const sepax_pose *pa = n % 2 == 0 ? NULL : &pose;
      draw(kind, v);
      if (sepax__distance_and_way((const double(*)[3])v[0], pa, (const double(*)[3])v[1], NULL,
                                  nearest, &way) > 0) {
        free_pairs++;
        found += way.c[0].high != 0 || way.c[1].high != 0 || way.c[2].high != 0;
      }
    }
    assert_true(found == free_pairs && free_pairs > PAIRS / 2);
  }
}
