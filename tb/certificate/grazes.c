/* SPDX-License-Identifier: MIT */
/* grazes.c - a random scene in which two boxes on random joints come as near as is asked:
 *   certificate-grazes SEED GAP
 * writes r.urdf, path.csv of one segment and c.json, a certificate of one interval that lacks its
 * files, to the current folder. A gap below 0 is a collision of that depth. Kinematics by matrices
 * and the 15 axes of two boxes in many poses: nothing of the checker. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { JOINTS = 4, POSES = 3000 };

typedef struct {
  double turn[3][3], shift[3];
} placing;

typedef struct {
  int turns;
  double xyz[3], rpy[3], axis[3], from, to;
} moving;

typedef struct {
  double xyz[3], rpy[3], size[3];
} cuboid;

static moving joints[JOINTS]; /* world, 0, 1, a; world, 2, 3, b */
static cuboid box_a, box_b;
static uint64_t state;

static double random_in(double low, double high) {
  state = state * 6364136223846793005U + 1442695040888963407U;
  return round((low + (high - low) * ((double)(state >> 11) * 0x1p-53)) * 1e6) / 1e6;
}

static void random_three(double *v, double low, double high) {
  for (int n = 0; n < 3; n++)
    v[n] = random_in(low, high);
}

static placing product(placing a, placing b) {
  placing r = a;
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      r.turn[i][j] = 0;
      for (int k = 0; k < 3; k++)
        r.turn[i][j] += a.turn[i][k] * b.turn[k][j];
      r.shift[i] += a.turn[i][j] * b.shift[j];
    }
  }
  return r;
}

static placing about(const double *axis, double angle) {
  const double length = sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
  const double u[3] = {axis[0] / length, axis[1] / length, axis[2] / length};
  const double s = sin(angle);
  const double cross[3][3] = {{0, -u[2], u[1]}, {u[2], 0, -u[0]}, {-u[1], u[0], 0}};
  placing r = {{{0}}, {0}};
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      r.turn[i][j] = (i == j ? cos(angle) : 0) + u[i] * u[j] * (1 - cos(angle)) + s * cross[i][j];
    }
  }
  return r;
}

static placing origin(const double *xyz, const double *rpy) {
  static const double X[3] = {1, 0, 0};
  static const double Y[3] = {0, 1, 0};
  static const double Z[3] = {0, 0, 1};
  placing r = product(about(Z, rpy[2]), product(about(Y, rpy[1]), about(X, rpy[0])));
  memcpy(r.shift, xyz, sizeof r.shift);
  return r;
}

static placing joint_at(const moving *j, double s) {
  const double value = j->from + s * (j->to - j->from);
  const double *a = j->axis;
  const double length = sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
  placing moved = about(a, j->turns ? value : 0);
  for (int n = 0; n < 3 && !j->turns; n++)
    moved.shift[n] = value * a[n] / length;
  return product(origin(j->xyz, j->rpy), moved);
}

/* Greatest gap along the axes of the two boxes at s; the axis, from b to a, in b's link. */
static double gap_at(double s, double *toward) {
  const placing link = product(joint_at(&joints[2], s), joint_at(&joints[3], s));
  const placing a = product(product(joint_at(&joints[0], s), joint_at(&joints[1], s)),
                            origin(box_a.xyz, box_a.rpy));
  const placing b = product(link, origin(box_b.xyz, box_b.rpy));
  double best = -HUGE_VAL;
  for (int n = 0; n < 15; n++) {
    double axis[3];
    for (int i = 0; i < 3; i++) {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      const int of_a = n < 6 ? 0 : (n - 6) / 3;
      const int of_b = n < 6 ? 0 : (n - 6) % 3;
      axis[i] = n < 3   ? a.turn[i][n]
                : n < 6 ? b.turn[i][n - 3]
                        : a.turn[j][of_a] * b.turn[k][of_b] - a.turn[k][of_a] * b.turn[j][of_b];
    }
    const double length = sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    if (length < 1e-6)
      continue;
    double middle = 0;
    double sides = 0;
    for (int i = 0; i < 3; i++) {
      double along_a = 0;
      double along_b = 0;
      for (int k = 0; k < 3; k++) {
        along_a += axis[k] * a.turn[k][i] * box_a.size[i] / 2;
        along_b += axis[k] * b.turn[k][i] * box_b.size[i] / 2;
      }
      middle += axis[i] * (a.shift[i] - b.shift[i]);
      sides += fabs(along_a) + fabs(along_b);
    }
    const double gap = (fabs(middle) - sides) / length;
    if (gap <= best)
      continue;
    best = gap;
    for (int i = 0; i < 3; i++) {
      toward[i] = 0;
      for (int k = 0; k < 3; k++)
        toward[i] += link.turn[k][i] * axis[k] / length;
      if (middle < 0)
        toward[i] = -toward[i];
    }
  }
  return best;
}

/* The least gap of the way, sought near every pose that is nearer than its neighbours. */
static double least_gap(double *at, double *toward) {
  static double gap[POSES + 1];
  double best = HUGE_VAL;
  for (int n = 0; n <= POSES; n++)
    gap[n] = gap_at((double)n / POSES, toward);
  for (int n = 0; n <= POSES; n++) {
    if ((n > 0 && gap[n] > gap[n - 1]) || (n < POSES && gap[n] > gap[n + 1]))
      continue;
    double low = (double)(n > 0 ? n - 1 : n) / POSES;
    double high = (double)(n < POSES ? n + 1 : n) / POSES;
    for (int step = 0; step < 60; step++) {
      const double one = low + (high - low) * 0.382;
      const double two = low + (high - low) * 0.618;
      if (gap_at(one, toward) < gap_at(two, toward)) {
        high = two;
      } else {
        low = one;
      }
    }
    const double s = gap[n] < gap_at(low, toward) ? (double)n / POSES : low;
    if (gap_at(s, toward) >= best)
      continue;
    best = gap_at(s, toward);
    *at = s;
  }
  gap_at(*at, toward);
  return best;
}

static void make(void) {
  for (int n = 0; n < JOINTS; n++) {
    moving *j = &joints[n];
    j->turns = random_in(0, 1) < 0.65;
    random_three(j->xyz, -0.3, 0.3);
    random_three(j->rpy, -3, 3);
    random_three(j->axis, -1, 1);
    j->from = random_in(-1, 1) * (j->turns ? 3 : 0.3);
    j->to = j->from + random_in(-1, 1) * (j->turns ? 0.5 : 0.1);
  }
  random_three(box_a.xyz, -0.1, 0.1);
  random_three(box_b.xyz, -0.1, 0.1);
  random_three(box_a.rpy, -3, 3);
  random_three(box_b.rpy, -3, 3);
  random_three(box_a.size, 0.02, 0.2);
  random_three(box_b.size, 0.02, 0.2);
}

static void three(FILE *out, const char *name, const double *v) {
  fprintf(out, " %s=\"%.17g %.17g %.17g\"", name, v[0], v[1], v[2]);
}

static void write_link(FILE *out, const char *name, const cuboid *b) {
  fprintf(out, "<link name=\"%s\"><collision><origin", name);
  three(out, "xyz", b->xyz);
  three(out, "rpy", b->rpy);
  fprintf(out, "/><geometry><box");
  three(out, "size", b->size);
  fprintf(out, "/></geometry></collision></link>\n");
}

static void write_robot(FILE *out) {
  static const char *const PARENT[JOINTS] = {"world", "l", "world", "m"};
  static const char *const CHILD[JOINTS] = {"l", "a", "m", "b"};
  fprintf(out, "<robot name=\"r\"><link name=\"world\"/><link name=\"l\"/><link name=\"m\"/>\n");
  write_link(out, "a", &box_a);
  write_link(out, "b", &box_b);
  for (int n = 0; n < JOINTS; n++) {
    fprintf(out, "<joint name=\"j%d\" type=\"%s\"><parent link=\"%s\"/><child link=\"%s\"/><origin",
            n, joints[n].turns ? "continuous" : "prismatic", PARENT[n], CHILD[n]);
    three(out, "xyz", joints[n].xyz);
    three(out, "rpy", joints[n].rpy);
    fprintf(out, "/><axis");
    three(out, "xyz", joints[n].axis);
    fprintf(out, "/></joint>\n");
  }
  fprintf(out, "</robot>\n");
}

static FILE *opened(const char *name) {
  FILE *out = fopen(name, "w");
  if (out == NULL) {
    perror(name);
    exit(2);
  }
  return out;
}

int main(int count, char **words) {
  if (count != 3)
    return 2;
  const double want = strtod(words[2], NULL);
  state = strtoull(words[1], NULL, 10) * 7919 + 13;
  for (int n = 0; n < 10; n++)
    random_in(0, 1);
  make();
  double toward[3] = {0, 0, 0};
  double at = 0;
  double gap = least_gap(&at, toward);
  for (int n = 0; n < 60 && fabs(gap - want) > fabs(want) / 20; n++) {
    for (int i = 0; i < 3; i++)
      box_b.xyz[i] += (gap - want) * toward[i];
    gap = least_gap(&at, toward);
  }
  if (fabs(gap - want) > fabs(want) / 20) {
    fprintf(stderr, "grazes: seed %s: no such scene\n", words[1]);
    return 2;
  }
  FILE *out = opened("r.urdf");
  write_robot(out);
  fclose(out);
  out = opened("path.csv");
  fprintf(out, "j3,j1,j0,j2\n%.17g,%.17g,%.17g,%.17g\n%.17g,%.17g,%.17g,%.17g\n", joints[3].from,
          joints[1].from, joints[0].from, joints[2].from, joints[3].to, joints[1].to, joints[0].to,
          joints[2].to);
  fclose(out);
  out = opened("c.json");
  fprintf(out,
          "{\"certificate\": \"sepax\", \"version\": 2, \"urdf\": \"r.urdf\", \"srdf\": null, ");
  fprintf(out, "\"path\": \"path.csv\", \"packages\": {}, \"clearance\": 0, ");
  fprintf(out, "\"pairs\": [[\"%s\"]]}\n", state & 1024 ? "a\", \"b" : "b\", \"a");
  fprintf(out, "[0,0,0,0,0]\n{\"intervals\": 1}\n");
  fclose(out);
  printf("gap %g at %g\n", gap, at);
  return 0;
}
