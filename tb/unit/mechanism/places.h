/* SPDX-License-Identifier: MIT */
/* places.h - mechanisms for tests, and their links' places: quaternions in long double. */
#ifndef PLACES_H
#define PLACES_H

#include "harness.h"
#include "sepax_mechanism.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static inline char *copied(const char *text) {
  char *copy = malloc(strlen(text) + 1);
  assert_non_null(copy);
  return strcpy(copy, text);
}

/* Links l0 ... and joints j0 ..., all fixed: joint n is between link n and link n + 1. */
static inline sepax_mechanism row_of(size_t joints) {
  sepax_mechanism m = {.link = calloc(joints + 1, sizeof *m.link),
                       .links = joints + 1,
                       .joint = calloc(joints + 1, sizeof *m.joint),
                       .joints = joints};
  assert_non_null(m.link);
  assert_non_null(m.joint);
  for (size_t n = 0; n <= joints; n++) {
    char name[32];
    snprintf(name, sizeof name, "l%zu", n);
    m.link[n].name = copied(name);
    if (n < joints) {
      name[0] = 'j';
      m.joint[n] = (sepax_joint){.name = copied(name),
                                 .parent = n,
                                 .child = n + 1,
                                 .origin = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}},
                                 .axis = {0, 0, 1},
                                 .lower = -INFINITY,
                                 .upper = INFINITY,
                                 .mimic = SEPAX_NO_JOINT,
                                 .factor = 1};
    }
  }
  return m;
}

/* ------------------------------------------------------------------------- oracle */

typedef struct {
  long double q[4], t[3]; /* w, x, y, z of a unit quaternion; the translation */
} place;

static inline void turn(const long double q[4], const long double v[3], long double to[3]) {
  long double c[3];
  for (int i = 0; i < 3; i++) { /* v + 2 u x (u x v + w v) */
    int j = (i + 1) % 3;
    int k = (i + 2) % 3;
    c[i] = q[1 + j] * v[k] - q[1 + k] * v[j] + q[0] * v[i];
  }
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3;
    int k = (i + 2) % 3;
    to[i] = v[i] + 2 * (q[1 + j] * c[k] - q[1 + k] * c[j]);
  }
}

static inline place after(const place *outer, const place *inner) {
  const long double *p = outer->q;
  const long double *q = inner->q;
  place r = {{p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
              p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
              p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
              p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]},
             {0, 0, 0}};
  turn(p, inner->t, r.t);
  for (int i = 0; i < 3; i++) {
    r.t[i] += outer->t[i];
  }
  return r;
}

/* The quaternion of a matrix whose rotation is by less than half a turn. */
static inline void quaternion_of(const double r[3][3], long double q[4]) {
  long double trace = (long double)r[0][0] + r[1][1] + r[2][2];
  q[0] = sqrtl(1 + trace) / 2;
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3;
    int k = (i + 2) % 3;
    q[1 + i] = ((long double)r[k][j] - r[j][k]) / (4 * q[0]);
  }
}

static inline place place_of(const sepax_joint *joint, long double value) {
  place p = {{1, 0, 0, 0}, {0, 0, 0}};
  quaternion_of(joint->origin.rotation, p.q);
  for (int i = 0; i < 3; i++) {
    p.t[i] = joint->origin.translation[i];
  }
  const double *a = joint->axis;
  long double length =
      sqrtl((long double)a[0] * a[0] + (long double)a[1] * a[1] + (long double)a[2] * a[2]);
  bool slides = joint->kind == SEPAX_JOINT_PRISMATIC;
  bool turns = joint->kind == SEPAX_JOINT_REVOLUTE || joint->kind == SEPAX_JOINT_CONTINUOUS;
  place moved = {{turns ? cosl(value / 2) : 1, 0, 0, 0}, {0, 0, 0}};
  for (int i = 0; i < 3; i++) {
    moved.q[1 + i] = turns ? sinl(value / 2) * a[i] / length : 0;
    moved.t[i] = slides ? value * a[i] / length : 0;
  }
  return after(&p, &moved);
}

/* ------------------------------------------------------------------------- random */

static inline void draw_joint(sepax_joint *joint, size_t links) {
  static const sepax_joint_kind kinds[] = {SEPAX_JOINT_FIXED, SEPAX_JOINT_REVOLUTE,
                                           SEPAX_JOINT_CONTINUOUS, SEPAX_JOINT_PRISMATIC};
  joint->kind = kinds[random_below(4)];
  joint->parent = (size_t)random_below((int)links);
  double angle = random_unit();
  joint->origin.rotation[0][0] = joint->origin.rotation[1][1] = cos(angle);
  joint->origin.rotation[1][0] = sin(angle);
  joint->origin.rotation[0][1] = -sin(angle);
  double size = ldexp(1, random_below(40) - 20);
  for (int i = 0; i < 3; i++) {
    joint->origin.translation[i] = random_unit();
    joint->axis[i] = size * random_unit();
  }
}

#endif
