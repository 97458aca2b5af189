/* SPDX-License-Identifier: MIT */
/* scene.c - the bodies and a tool path of mill.urdf: scene FOLDER [LINES]
 * Writes spindle.stl, holder.stl, cutter.stl, table.stl, fixture.stl, workpiece.stl (mm) and
 * path.csv, whose ball-end cutter follows the top of the workpiece ALLOWANCE above it, its axis
 * along the normal of that. */
#include <sepax.h>
#include <stdio.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PI 3.14159265358979323846

/* Lengths in mm. That of the tool is from the axis of the head to the centre of the ball; mill.urdf
 * has it, too, and where the workpiece stands on the table. */
static const double BALL = 5, TOOL = 300, ALLOWANCE = 0.2, FEED = 50;
static const double HALF_X = 60, HALF_Y = 50, HEIGHT = 40, WAVE = 6;
static const double WORKPIECE_Z = -50;

typedef struct {
  double x, y, z;
} point;

/* ----------------------------------------------------------------------- bodies */

typedef struct {
  sepax_soup mesh;
  size_t capacity;
} shape;

static void triangle(shape *s, point a, point b, point c) {
  if (s->mesh.count == s->capacity) {
    s->capacity = s->capacity == 0 ? 1024 : 2 * s->capacity;
    s->mesh.facet = sepax_resize(s->mesh.facet, s->capacity * sizeof *s->mesh.facet);
    if (s->mesh.facet == NULL) {
      fprintf(stderr, "scene: no memory\n");
      exit(2);
    }
  }
  s->mesh.facet[s->mesh.count++] =
      (sepax_facet){{{a.x, a.y, a.z}, {b.x, b.y, b.z}, {c.x, c.y, c.z}}};
}

/* Its corners are in counter-clockwise order, seen from outside. */
static void quad(shape *s, point a, point b, point c, point d) {
  triangle(s, a, b, c);
  triangle(s, a, c, d);
}

static double coordinate(point p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

/* The point of a box at i of n cells along one axis, j of m along the next, low or high on the
 * third. */
static point on_side(point low, point high, int third, double i, double j, double k) {
  double at[3];
  const double part[3] = {k, i, j};
  for (int n = 0; n < 3; n++) {
    int axis = (third + n) % 3;
    double from = coordinate(low, axis);
    at[axis] = from + (coordinate(high, axis) - from) * part[n];
  }
  return (point){at[0], at[1], at[2]};
}

static void box(shape *s, point low, point high, double cell) {
  int cells[3];
  for (int axis = 0; axis < 3; axis++) {
    cells[axis] = (int)ceil((coordinate(high, axis) - coordinate(low, axis)) / cell);
  }
  for (int third = 0; third < 3; third++) {
    double n = cells[(third + 1) % 3];
    double m = cells[(third + 2) % 3];
    for (int i = 0; i < n; i++) {
      for (int j = 0; j < m; j++) {
        for (int k = 0; k < 2; k++) {
          point p = on_side(low, high, third, i / n, j / m, k);
          point q = on_side(low, high, third, (i + 1) / n, j / m, k);
          point r = on_side(low, high, third, (i + 1) / n, (j + 1) / m, k);
          point t = on_side(low, high, third, i / n, (j + 1) / m, k);
          k == 1 ? quad(s, p, q, r, t) : quad(s, p, t, r, q);
        }
      }
    }
  }
}

/* A profile of radii and heights from the axis up and back to the axis. */
typedef struct {
  double radius[512], z[512];
  int count;
} profile;

/* A line to a point, in steps of about `step`; step 0: one. */
static void line_to(profile *p, double radius, double z, double step) {
  double r0 = p->count == 0 ? radius : p->radius[p->count - 1];
  double z0 = p->count == 0 ? z : p->z[p->count - 1];
  int steps = step > 0 ? (int)ceil(hypot(radius - r0, z - z0) / step) : 1;
  for (int k = steps > 0 ? 1 : 0; k <= steps; k++) {
    double part = steps > 0 ? (double)k / steps : 1;
    p->radius[p->count] = r0 + (radius - r0) * part;
    p->z[p->count++] = z0 + (z - z0) * part;
  }
}

static point turned(const profile *p, int n, int k, int segments) {
  double angle = 2 * PI * (k % segments) / segments;
  return (point){p->radius[n] * cos(angle), p->radius[n] * sin(angle), p->z[n]};
}

static void revolve(shape *s, const profile *p, int segments) {
  for (int n = 0; n + 1 < p->count; n++) {
    for (int k = 0; k < segments; k++) {
      point a = turned(p, n, k, segments);
      point b = turned(p, n, k + 1, segments);
      point c = turned(p, n + 1, k + 1, segments);
      point d = turned(p, n + 1, k, segments);
      if (p->radius[n] == 0) {
        triangle(s, a, c, d);
      } else if (p->radius[n + 1] == 0) {
        triangle(s, a, b, c);
      } else {
        quad(s, a, b, c, d);
      }
    }
  }
}

/* The top of the workpiece, and the slopes of it. */
static double top(double x, double y, double slope[2]) {
  double u = 2 * PI / 90;
  double v = 2 * PI / 110;
  slope[0] = WAVE * u * cos(u * x) * cos(v * y);
  slope[1] = -WAVE * v * sin(u * x) * sin(v * y);
  return HEIGHT + WAVE * sin(u * x) * cos(v * y);
}

static point on_top(int i, int j, int n, int m, bool down) {
  double slope[2];
  double x = HALF_X * (2.0 * i / n - 1);
  double y = HALF_Y * (2.0 * j / m - 1);
  return (point){x, y, down ? 0 : top(x, y, slope)};
}

static void workpiece(shape *s) {
  enum { N = 300, M = 240 };
  for (int i = 0; i < N; i++) {
    for (int j = 0; j < M; j++) {
      quad(s, on_top(i, j, N, M, false), on_top(i + 1, j, N, M, false),
           on_top(i + 1, j + 1, N, M, false), on_top(i, j + 1, N, M, false));
    }
  }
  const point centre = {0, 0, 0};
  for (int k = 0; k < 2 * (N + M); k++) { /* round its sides, counter-clockwise */
    int at[2][2];
    for (int end = 0; end < 2; end++) {
      int n = (k + end) % (2 * (N + M));
      int *p = at[end];
      p[0] = n < N ? n : n < N + M ? N : n < 2 * N + M ? 2 * N + M - n : 0;
      p[1] = n < N ? 0 : n < N + M ? n - N : n < 2 * N + M ? M : 2 * (N + M) - n;
    }
    point a = on_top(at[0][0], at[0][1], N, M, true);
    point b = on_top(at[1][0], at[1][1], N, M, true);
    quad(s, a, b, on_top(at[1][0], at[1][1], N, M, false), on_top(at[0][0], at[0][1], N, M, false));
    triangle(s, centre, b, a);
  }
}

/* In the coordinates of its link, as mill.urdf has them. */
static void cutter(shape *s) {
  profile p = {.count = 0};
  enum { STEPS = 40 };
  line_to(&p, 0, -BALL, 0);
  for (int k = 1; k <= STEPS; k++) {
    double angle = PI / 2 * k / STEPS;
    line_to(&p, BALL * sin(angle), -BALL * cos(angle), 0);
  }
  line_to(&p, BALL, 60, 2);
  line_to(&p, 0, 60, 0);
  revolve(s, &p, 240);
}

static void holder(shape *s) {
  profile p = {.count = 0};
  line_to(&p, 0, 0, 0);
  line_to(&p, 14, 0, 2);
  line_to(&p, 16, 25, 2);
  line_to(&p, 32, 45, 2);
  line_to(&p, 32, 62, 2);
  line_to(&p, 0, 62, 4);
  revolve(s, &p, 360);
}

static void spindle(shape *s) {
  profile p = {.count = 0};
  line_to(&p, 0, -185, 0);
  line_to(&p, 55, -185, 4);
  line_to(&p, 80, -150, 4);
  line_to(&p, 80, 40, 4);
  line_to(&p, 0, 40, 8);
  revolve(s, &p, 360);
}

static void table(shape *s) {
  box(s, (point){-140, -90, -95}, (point){140, 90, -70}, 4);
  box(s, (point){-165, -40, -95}, (point){-140, 40, 40}, 4);
  box(s, (point){140, -40, -95}, (point){165, 40, 40}, 4);
}

static void fixture(shape *s) {
  box(s, (point){-70, -80, 0}, (point){70, 80, 20}, 3);
  box(s, (point){-40, -72, 20}, (point){40, -50, 42}, 3);
  box(s, (point){-40, 50, 20}, (point){40, 72, 42}, 3);
}

/* ------------------------------------------------------------------------- path */

static const double degrees = 180 / PI;

/* The axes x, y, z (mm), b, a (radians) that hold the ball on the workpiece at x, y. Table and
 * head turn so that the tool stands along the normal. */
static void axes_at(double x, double y, double axes[5]) {
  double slope[2];
  double z = top(x, y, slope);
  double length = sqrt(slope[0] * slope[0] + slope[1] * slope[1] + 1);
  const point n = {-slope[0] / length, -slope[1] / length, 1 / length};
  double away = BALL + ALLOWANCE;
  const point ball = {x + away * n.x, y + away * n.y, z + away * n.z + WORKPIECE_Z};
  double b = asin(n.x);
  double a = atan2(n.y, n.z);
  axes[0] = ball.x + TOOL * sin(b);
  axes[1] = cos(a) * ball.y - sin(a) * ball.z;
  axes[2] = sin(a) * ball.y + cos(a) * ball.z + TOOL * cos(b);
  axes[3] = b;
  axes[4] = a;
}

/* Rows along x, to and fro. */
static bool write_path(FILE *out, int lines) {
  int columns = (int)ceil(sqrt((double)lines));
  int rows = (lines + columns - 1) / columns;
  double time = 0;
  double last[2] = {0, 0};
  fprintf(out, "time [s],x [mm],y [mm],z [mm],b [deg],a [deg]\n");
  for (int n = 0; n < lines; n++) {
    int row = n / columns;
    int column = row % 2 == 0 ? n % columns : columns - 1 - n % columns;
    double x = 0.95 * HALF_X * (2.0 * column / (columns > 1 ? columns - 1 : 1) - 1);
    double y = 0.95 * HALF_Y * (2.0 * row / (rows > 1 ? rows - 1 : 1) - 1);
    double axes[5];
    axes_at(x, y, axes);
    time += n > 0 ? hypot(x - last[0], y - last[1]) / FEED : 0;
    last[0] = x;
    last[1] = y;
    fprintf(out, "%.4f,%.6f,%.6f,%.6f,%.7f,%.7f\n", time, axes[0], axes[1], axes[2],
            axes[3] * degrees, axes[4] * degrees);
  }
  return !ferror(out);
}

int main(int argc, char **argv) {
  static const struct {
    const char *name;
    void (*fill)(shape *s);
  } bodies[] = {{"spindle", spindle}, {"holder", holder},   {"cutter", cutter},
                {"table", table},     {"fixture", fixture}, {"workpiece", workpiece}};
  int lines = argc == 3 ? atoi(argv[2]) : 10000;
  if (argc < 2 || argc > 3 || lines < 2) {
    fprintf(stderr, "scene: give FOLDER, and maybe the lines of its path\n");
    return 2;
  }
  char name[4096];
  for (size_t k = 0; k < sizeof bodies / sizeof bodies[0]; k++) {
    shape s = {{0}, 0};
    sepax_error error = {0};
    bodies[k].fill(&s);
    snprintf(name, sizeof name, "%s/%s.stl", argv[1], bodies[k].name);
    if (!sepax_stl_write(&s.mesh, name, false, &error)) {
      fprintf(stderr, "scene: %s\n", error.text);
      return 2;
    }
    printf("%s: %zu triangles\n", name, s.mesh.count);
    sepax_soup_free(&s.mesh);
  }
  snprintf(name, sizeof name, "%s/path.csv", argv[1]);
  FILE *out = fopen(name, "w");
  bool ok = out != NULL && write_path(out, lines);
  if (out == NULL || fclose(out) != 0 || !ok) {
    fprintf(stderr, "scene: %s: cannot be written\n", name);
    return 2;
  }
  printf("%s: %d lines\n", name, lines);
  return 0;
}
