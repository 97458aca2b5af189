/* SPDX-License-Identifier: MIT */
/* vector.h - vectors in double for triangles; in long double, with unit quaternions, for poses. */
#ifndef CERTIFICATE_VECTOR_H
#define CERTIFICATE_VECTOR_H

#include <math.h>

typedef struct {
  double x, y, z;
} vec;

static inline vec vec_plus(vec a, vec b) { return (vec){a.x + b.x, a.y + b.y, a.z + b.z}; }
static inline vec vec_minus(vec a, vec b) { return (vec){a.x - b.x, a.y - b.y, a.z - b.z}; }
static inline vec vec_times(double f, vec a) { return (vec){f * a.x, f * a.y, f * a.z}; }
static inline double vec_dot(vec a, vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static inline vec vec_cross(vec a, vec b) {
  return (vec){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
static inline double vec_length(vec a) { return sqrt(vec_dot(a, a)); }

typedef struct {
  long double x, y, z;
} point;

static inline point point_of(vec a) { return (point){a.x, a.y, a.z}; }
static inline vec point_near(point a) { return (vec){(double)a.x, (double)a.y, (double)a.z}; }
static inline point point_plus(point a, point b) {
  return (point){a.x + b.x, a.y + b.y, a.z + b.z};
}
static inline point point_minus(point a, point b) {
  return (point){a.x - b.x, a.y - b.y, a.z - b.z};
}
static inline point point_times(long double f, point a) {
  return (point){f * a.x, f * a.y, f * a.z};
}
static inline long double point_dot(point a, point b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static inline point point_cross(point a, point b) {
  return (point){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
static inline long double point_length(point a) { return sqrtl(point_dot(a, a)); }

/* A rotation: a unit quaternion, scalar part first. */
typedef struct {
  long double w;
  point v;
} quaternion;

static inline quaternion quaternion_about(point axis, long double angle) {
  return (quaternion){cosl(angle / 2), point_times(sinl(angle / 2), axis)};
}
static inline quaternion quaternion_product(quaternion a, quaternion b) {
  return (quaternion){
      a.w * b.w - point_dot(a.v, b.v),
      point_plus(point_plus(point_times(a.w, b.v), point_times(b.w, a.v)), point_cross(a.v, b.v))};
}
static inline point quaternion_turn(quaternion q, point p) {
  const point t = point_times(2, point_cross(q.v, p));
  return point_plus(point_plus(p, point_times(q.w, t)), point_cross(q.v, t));
}

/* p goes to turn(p) + shift. */
typedef struct {
  quaternion turn;
  point shift;
} pose;

static const pose POSE_NONE = {{1, {0, 0, 0}}, {0, 0, 0}};

static inline point pose_apply(pose a, point p) {
  return point_plus(quaternion_turn(a.turn, p), a.shift);
}
static inline pose pose_product(pose a, pose b) {
  return (pose){quaternion_product(a.turn, b.turn), pose_apply(a, b.shift)};
}
static inline pose pose_inverse(pose a) {
  const quaternion back = {a.turn.w, point_times(-1, a.turn.v)};
  return (pose){back, point_times(-1, quaternion_turn(back, a.shift))};
}

#endif
