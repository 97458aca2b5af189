/* SPDX-License-Identifier: MIT */
/* frames.c - bounds of the distance of nodes and triangles in doubles; frames.h has the errors. */
#include "frames.h"
#include "util/vector.h"

static double positive(double x) { return x > 0 ? x : 0; }

/* What is left of a gap when its errors are taken off; `half` are the half sides of the frame on
 * whose axis it is. */
static double certain(double gap, const double half[3], double skew) {
  return positive(gap - FRAME_ERROR - 3 * skew * (half[0] + half[1] + half[2]));
}

static double norm(const double gap[3]) { return vector_length(gap); }

double sepax__frames_apart(const placed_frame *p, const placed_frame *q, const double way[3],
                           double skew) {
  double between[3];
  double on_p[3];
  double on_q[3] = {0, 0, 0};
  double reach = 0; /* of both on the way */
  for (int i = 0; i < 3; i++) {
    between[i] = q->centre[i] - p->centre[i];
    on_q[i] = fabs(vector_dot(q->axis[i], way)) * q->half[i];
    reach += fabs(vector_dot(p->axis[i], way)) * p->half[i] + on_q[i];
    on_q[i] = q->half[i];
  }
  for (int i = 0; i < 3; i++) {
    on_p[i] = p->half[i];
    for (int k = 0; k < 3; k++) {
      double cosine = fabs(vector_dot(p->axis[i], q->axis[k]));
      on_p[i] += cosine * q->half[k];
      on_q[k] += cosine * p->half[i];
    }
  }
  for (int i = 0; i < 3; i++) {
    on_p[i] = certain(fabs(vector_dot(p->axis[i], between)) - on_p[i], p->half, skew);
    on_q[i] = certain(fabs(vector_dot(q->axis[i], between)) - on_q[i], q->half, skew);
  }
  double along = positive(fabs(vector_dot(way, between)) - reach - FRAME_ERROR);
  return fmax(along, fmax(norm(on_p), norm(on_q))) * (1 - 2 * skew);
}

/* How far a range is from the range centre - reach ... centre + reach. */
static double beyond(const double v[3], double centre, double reach) {
  double low = fmin(v[0], fmin(v[1], v[2])) - centre;
  double high = fmax(v[0], fmax(v[1], v[2])) - centre;
  return fmax(low, -high) - reach;
}

double sepax__frame_apart(const placed_frame *p, const placed_triangle t, const double way[3],
                          double skew) {
  double gap[3];
  double at[3];
  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 3; k++) {
      at[k] = vector_dot(p->axis[i], t[k]);
    }
    gap[i] = beyond(at, vector_dot(p->axis[i], p->centre), p->half[i]);
    gap[i] = certain(gap[i], p->half, skew);
  }
  double reach = 0;
  for (int k = 0; k < 3; k++) {
    reach += fabs(vector_dot(p->axis[k], way)) * p->half[k];
    at[k] = vector_dot(way, t[k]);
  }
  double along = positive(beyond(at, vector_dot(way, p->centre), reach) - FRAME_ERROR);
  return fmax(along, norm(gap)) * (1 - 2 * skew);
}
