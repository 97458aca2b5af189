/* SPDX-License-Identifier: MIT */
/* program.c - machining programs made for the tests of the stock. */
#include "stock/program.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PI 0x1.921fb54442d18p1

const double part_box[2][3] = {{0, 0, -30}, {80, 60, 0}};
const double cone_box[2][3] = {{-42, -42, -4}, {42, 42, 28}};
const sepax__stock_corner cone_profile[4] = {{0, -4, 0}, {42, -4, 0}, {13.5, 28, 0}, {0, 28, 0}};

/* ------------------------------------------------------------------- moves */

static void add_move(program *p, move m) {
  if (p->count == p->capacity) {
    p->capacity = p->capacity == 0 ? 1024 : 2 * p->capacity;
    p->line = realloc(p->line, p->capacity * sizeof *p->line);
    if (p->line == NULL) {
      fprintf(stderr, "program.c: no memory\n");
      exit(2);
    }
  }
  p->line[p->count++] = m;
}

void free_program(program *p) {
  free(p->line);
  memset(p, 0, sizeof *p);
}

static void go(program *p, bool rapid, int tool, stand to) {
  stand from = p->count > 0 ? p->line[p->count - 1].to : to;
  if (p->count > 0 && p->line[p->count - 1].tool != tool) {
    from = to; /* a new tool begins where it is put */
  }
  add_move(p, (move){rapid, tool, from, to, 40});
}

static void rapid_to(program *p, int tool, double x, double y, double z) {
  go(p, true, tool, (stand){.tip = {x, y, z}});
}

static void feed_to(program *p, int tool, double x, double y, double z) {
  go(p, false, tool, (stand){.tip = {x, y, z}});
}

/* ------------------------------------------------------------------- tools */

static void make_shape(sepax__stock_shape shape[2], const sepax__stock_corner corner[4],
                       double error_most, bool joined_below) {
  sepax_error error;
  if (!sepax__stock_shape_make(corner, 4, error_most, &shape[0], &shape[1], &error)) {
    fprintf(stderr, "program.c: %s\n", error.text);
    exit(2);
  }
  for (int side = 0; side < 2 && joined_below; side++) {
    shape[side].limit[0].joined = true;
  }
}

void make_tools(mill tool[TOOLS], double error_most) {
  const double radius[TOOLS] = {5, 3, 4, 2, 2};
  const double flutes[TOOLS] = {22, 30, 22, 8, 8};
  const double round[TOOLS] = {0, 0, 4, 2, 0.9};
  for (int n = 0; n < TOOLS; n++) {
    double r = radius[n];
    double tip = n == 1 ? r / tan(59 * PI / 180) : 0;
    const sepax__stock_corner cutter[4] = {
        {0, 0, 0}, {r, tip, round[n]}, {r, flutes[n], 0}, {0, flutes[n], 0}};
    const sepax__stock_corner shank[4] = {
        {0, flutes[n], 0}, {r, flutes[n], 0}, {r, 35, 0}, {0, 35, 0}};
    const sepax__stock_corner holder[4] = {{0, 35, 0}, {20, 35, 0}, {20, 40, 0}, {0, 40, 0}};
    tool[n].radius = r;
    tool[n].round = round[n];
    make_shape(tool[n].flutes, cutter, error_most, false);
    make_shape(tool[n].shank, shank, error_most, true);
    make_shape(tool[n].holder, holder, error_most, false);
  }
}

/* -------------------------------------------------------------- three axes */

static void pocket(program *p) {
  const double rows[5] = {10, 18, 26, 33, 35};
  for (int pass = 1; pass <= 3; pass++) {
    double z = -4 * pass;
    rapid_to(p, 0, 10, 10, 5);
    rapid_to(p, 0, 10, 10, z + 4); /* onto what the last pass left */
    feed_to(p, 0, 10, 10, z);
    for (int n = 0; n < 5; n++) {
      feed_to(p, 0, n % 2 == 0 ? 30 : 10, rows[n], z);
      feed_to(p, 0, n % 2 == 0 ? 30 : 10, rows[n == 4 ? 4 : n + 1], z);
    }
    feed_to(p, 0, 30, 10, z);
    feed_to(p, 0, 10, 10, z);
    feed_to(p, 0, 10, 35, z);
    feed_to(p, 0, 30, 35, z);
    rapid_to(p, 0, 30, 10, z); /* along the wall, at depth */
    rapid_to(p, 0, 10, 35, z); /* and across */
    rapid_to(p, 0, 10, 35, 5);
  }
}

static void slot(program *p, const double from[2], const double to[2], int passes) {
  rapid_to(p, 0, from[0], from[1], 5);
  rapid_to(p, 0, from[0], from[1], 0);
  for (int pass = 1; pass <= passes; pass++) {
    feed_to(p, 0, from[0], from[1], -2 * pass);
    feed_to(p, 0, to[0], to[1], -2 * pass);
    rapid_to(p, 0, from[0], from[1], -2 * pass);
  }
  rapid_to(p, 0, from[0], from[1], 5);
}

static void pecks(program *p, double x, double y) {
  rapid_to(p, 1, x, y, 2);
  for (int n = 1; n <= 5; n++) {
    rapid_to(p, 1, x, y, n == 1 ? 1 : -5 * (n - 1) + 0.3);
    feed_to(p, 1, x, y, -5 * n);
    rapid_to(p, 1, x, y, 2);
  }
}

static double wavy(double x, double y) { return -12.7 + 0.4 * sin(x / 3) * cos(y / 4); }

static void wavy_floor(program *p) {
  enum { PASSES = 50, STEPS = 45 };
  for (int n = 0; n < PASSES; n++) {
    double y = 10 + 0.5 * n;
    rapid_to(p, 2, 11, y, 2);
    rapid_to(p, 2, 11, y, -11.5);
    for (int k = 0; k <= STEPS; k++) {
      double x = 11 + 18.0 * k / STEPS;
      feed_to(p, 2, x, y, wavy(x, y));
    }
    if (n % 10 == 0) { /* back on the last steps */
      rapid_to(p, 2, 29 - 0.4, y, wavy(29 - 0.4, y));
    }
    rapid_to(p, 2, p->line[p->count - 1].to.tip[0], y, 2);
  }
}

program three_axis_part(void) {
  program p = {0};
  pocket(&p);
  slot(&p, (const double[]){46, 10}, (const double[]){70, 27}, 4);
  slot(&p, (const double[]){46, 50}, (const double[]){70, 50}, 3);
  pecks(&p, 40, 52);
  pecks(&p, 73.3, 38.1);
  wavy_floor(&p);
  return p;
}

/* --------------------------------------------------------------- five axes */

/* On the cone at the height h (0: bottom, 1: top), `deep` below its surface. */
static stand on_cone(double h, double azimuth, double deep, double lean) {
  const double slope = atan2(32, 42 - 13.5); /* of the surface's normal, from the plane */
  double r = 42 - (42 - 13.5) * h;
  stand at = {.a = PI / 2 - (PI / 2 - slope) + lean, .c = azimuth + 0.3 * lean};
  sepax_pose pose = pose_of(&at);
  const double surface[3] = {r * cos(azimuth), r * sin(azimuth), -4 + 32 * h};
  for (int i = 0; i < 3; i++) {
    at.tip[i] = surface[i] - deep * pose.rotation[i][2];
  }
  return at;
}

program five_axis_part(int tool) {
  enum { GROOVES = 12, LAYERS = 4, PASSES = 3, STEPS = 30 };
  program p = {0};
  for (int n = 0; n < GROOVES * LAYERS * PASSES; n++) {
    int layer = n / PASSES % LAYERS;
    int groove = n / (PASSES * LAYERS);
    for (int k = 0; k <= STEPS; k++) {
      double h = (double)k / STEPS;
      double azimuth = 2 * PI * groove / GROOVES + 0.9 * h * h + 0.05 * (n % PASSES - 1);
      double lean = 0.25 * sin(5 * h + n % PASSES);
      if (k == 0) {
        go(&p, true, tool, on_cone(h, azimuth, -15, lean));
      }
      go(&p, k == 0, tool, on_cone(h, azimuth, 1.5 * (layer + 1) - (k == 0 ? 12 : 0), lean));
      if (k == STEPS) {
        go(&p, true, tool, on_cone(h, azimuth, -15, lean));
      }
    }
  }
  return p;
}
