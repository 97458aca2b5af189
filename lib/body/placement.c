/* SPDX-License-Identifier: MIT */
/* placement.c - places two bodies: finds the motions between their coordinates. */
#include "placement.h"

#include <math.h>
#include <string.h>

static const int next[3] = {1, 2, 0};

static const sepax_pose unmoved = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};

static void transpose_adjugate(const double m[3][3], double r[3][3]) {
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      int i1 = next[i];
      int i2 = next[i1];
      int j1 = next[j];
      int j2 = next[j1];
      r[j][i] = m[i1][j1] * m[i2][j2] - m[i1][j2] * m[i2][j1];
    }
  }
}

/* Invert a matrix that is nearly a rotation. */
static void invert(const double m[3][3], double r[3][3]) {
  transpose_adjugate(m, r);
  double determinant = m[0][0] * r[0][0] + m[0][1] * r[1][0] + m[0][2] * r[2][0];
  for (int k = 0; k < 9; k++) {
    r[k / 3][k % 3] /= determinant;
  }
}

static void multiply(const double p[3][3], const double q[3][3], double r[3][3]) {
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      r[i][j] = p[i][0] * q[0][j] + p[i][1] * q[1][j] + p[i][2] * q[2][j];
    }
  }
}

/* Find the motion from the coordinates of B's tree to those of A's tree; its linear part and offset
 * are given in units of the file. The doubles round by less than 2^-44 of the largest offset and
 * centre. */
static void find_motion(motion *m, const sepax_body *a, const sepax_body *b,
                        const double linear[3][3], const double offset[3]) {
  double ratio = b->scale / a->scale;
  double far = 0;
  double lost = 0;
  *m = (motion){.ratio = (float)ratio};
  for (int i = 0; i < 3; i++) {
    double shift = offset[i] - a->centre[i];
    for (int k = 0; k < 3; k++) {
      shift += linear[i][k] * b->centre[k];
      m->scaled[k][i] = linear[i][k] * ratio;
      m->turn[k][i] = (float)linear[i][k];
    }
    m->shift[i] = shift / a->scale;
    far = fmax(far, fabs(m->shift[i]));
    lost = fmax(lost, fabs(offset[i]) + fabs(a->centre[i]) + 4 * fabs(b->centre[i]));
  }
  m->lost = (float)(0x1p-44 * ((1 + ratio) * (2 + far) + lost / a->scale));
}

double sepax__largest_coordinate(const sepax_body *b) {
  double most = 0;
  for (int i = 0; i < 3; i++) {
    most = fmax(most, fabs(b->centre[i]));
  }
  return most + b->scale;
}

static bool is(double x, int whole) { return x >= whole && x <= whole; }

/* True if a pose is not NULL and not the identity. */
static bool moves(const sepax_pose *pose) {
  bool same = pose != NULL;
  for (int i = 0; i < 3 && same; i++) {
    same = is(pose->translation[i], 0);
    for (int k = 0; k < 3; k++) {
      same = same && is(pose->rotation[i][k], i == k);
    }
  }
  return pose != NULL && !same;
}

static bool turns_axes_into_axes(const double linear[3][3]) {
  for (int k = 0; k < 9; k++) {
    double size = fabs(linear[k / 3][k % 3]);
    if (!is(size, 0) && !is(size, 1)) {
      return false;
    }
  }
  return true;
}

void sepax__place_poses(placement *p, const sepax_pose *pose_a, const sepax_pose *pose_b,
                        double most) {
  pose_a = moves(pose_a) ? pose_a : NULL;
  pose_b = moves(pose_b) ? pose_b : NULL;
  *p = (placement){.pose = {pose_a, pose_b}};
  const sepax_pose *pa = pose_a != NULL ? pose_a : &unmoved;
  const sepax_pose *pb = pose_b != NULL ? pose_b : &unmoved;
  double inverse[3][3];
  invert(pa->rotation, inverse);
  if (pose_a == NULL) {
    memcpy(inverse, unmoved.rotation, sizeof inverse);
  }
  multiply(inverse, pb->rotation, p->linear);
  double away = 0;
  for (int i = 0; i < 3; i++) {
    p->offset[i] = 0;
    for (int k = 0; k < 3; k++) {
      p->offset[i] += inverse[i][k] * (pb->translation[k] - pa->translation[k]);
      away = fmax(away, fabs(pb->translation[k]) + fabs(pa->translation[k]));
    }
  }
  /* up to 32 roundings of terms that are at most 4 times the largest number */
  p->error = 0x1p-53 * 128 * (most + away);
  if (pose_a == NULL && pose_b == NULL) {
    p->error = 0;
  }
  p->whole = pose_a == NULL && turns_axes_into_axes(p->linear);
}

void sepax__place_bodies(placement *p, const sepax_body *a, const sepax_pose *pose_a,
                         const sepax_body *b, const sepax_pose *pose_b) {
  double back[3][3];
  double offset[3];
  sepax__place_poses(p, pose_a, pose_b, sepax__largest_coordinate(b));
  invert(p->linear, back);
  for (int i = 0; i < 3; i++) {
    offset[i] = 0;
    for (int k = 0; k < 3; k++) {
      offset[i] -= back[i][k] * p->offset[k];
    }
  }
  find_motion(&p->to[0], a, b, p->linear, p->offset);
  find_motion(&p->to[1], b, a, back, offset);
}

void sepax__place_triangle_b(const placement *p, const double b[3][3], double placed[3][3]) {
  for (int k = 0; k < 3; k++) {
    for (int i = 0; i < 3; i++) {
      placed[k][i] = p->linear[i][0] * b[k][0] + p->linear[i][1] * b[k][1] +
                     p->linear[i][2] * b[k][2] + p->offset[i];
    }
  }
}

/* Find the posed centre of a body; add a bound on its rounding to *size. */
static void pose_centre(const sepax_body *b, const sepax_pose *pose, double at[3], double *size) {
  const sepax_pose *p = pose != NULL ? pose : &unmoved;
  for (int i = 0; i < 3; i++) {
    at[i] = p->translation[i];
    *size += fabs(p->translation[i]) + 4 * fabs(b->centre[i]);
    for (int k = 0; k < 3; k++) {
      at[i] += p->rotation[i][k] * b->centre[k];
    }
  }
}

bool sepax__balls_disjoint(const sepax_body *a, const sepax_pose *pose_a, const sepax_body *b,
                           const sepax_pose *pose_b) {
  double at[2][3];
  double size = 0;
  double sum = 0;
  pose_centre(a, pose_a, at[0], &size);
  pose_centre(b, pose_b, at[1], &size);
  for (int i = 0; i < 3; i++) {
    double step = at[1][i] - at[0][i];
    sum += step * step;
  }
  double reach = (a->radius + b->radius) * (1 + 0x1p-16) + 0x1p-48 * size;
  return reach < 0x1p500 && sum > 0x1p-900 && sum < 0x1p1000 && sum > reach * reach;
}
