/* near.c - which triangles of two bodies in their poses are within a distance. */
#include "body/body.h"
#include "distance.h"
#include "util/error.h"
#include "util/list.h"

#include <math.h>

static void find_bounds(const double v[3][3], const sepax_pose *pose, double low[3],
                        double high[3]) {
  for (int i = 0; i < 3; i++) {
    low[i] = INFINITY;
    high[i] = -INFINITY;
    for (int k = 0; k < 3; k++) {
      double x = v[k][i];
      double size = fabs(x);
      if (pose != NULL) {
        const double *r = pose->rotation[i];
        x = r[0] * v[k][0] + r[1] * v[k][1] + r[2] * v[k][2] + pose->translation[i];
        size = 2 * (fabs(v[k][0]) + fabs(v[k][1]) + fabs(v[k][2])) + fabs(pose->translation[i]);
      }
      low[i] = fmin(low[i], x - 0x1p-48 * size);
      high[i] = fmax(high[i], x + 0x1p-48 * size);
    }
  }
}

bool sepax_bodies_near(const sepax_body *a, const sepax_pose *pose_a, const sepax_body *b,
                       const sepax_pose *pose_b, double distance, const sepax_query *query,
                       sepax_pairs *found, sepax_error *error) {
  static const sepax_query usual = {0};
  const sepax_query *q = query != NULL ? query : &usual;
  size_t capacity = 0;
  *found = (sepax_pairs){0};
  if (!(distance >= 0 && distance <= 0x1p1000)) {
    return sepax_fail(error, "the distance %g is not within 0 ... 2^1000", distance);
  }
  if (distance == 0) {
    return sepax_bodies_collide(a, pose_a, b, pose_b, query, found, error);
  }
  for (size_t i = 0; i < a->count; i++) {
    double low_a[3];
    double high_a[3];
    find_bounds(a->triangle[i], pose_a, low_a, high_a);
    for (size_t j = 0; j < b->count; j++) {
      double low_b[3];
      double high_b[3];
      bool far = false;
      find_bounds(b->triangle[j], pose_b, low_b, high_b);
      for (int k = 0; k < 3; k++) {
        double gap = fmax(low_b[k] - high_a[k], low_a[k] - high_b[k]);
        far = far || gap > distance * (1 + 0x1p-50);
      }
      if (far || !distance_within_posed(a->triangle[i], pose_a, b->triangle[j], pose_b, distance)) {
        continue;
      }
      if (q->only_any) {
        found->count = 1;
        return true;
      }
      if (!list_add_pair(found, &capacity, a->number[i], b->number[j])) {
        sepax_pairs_free(found);
        return sepax_fail(error, "no memory for the near pairs");
      }
      if (found->count == q->most) {
        return true;
      }
    }
  }
  return true;
}
