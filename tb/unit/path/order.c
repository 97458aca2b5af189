/* SPDX-License-Identifier: MIT */
/* order.c - the least clearance of a path: the same in any order of lines and with any number of
 * threads, and found with few searches. */
#include "path/search/line.h"
#include "harness.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static path_question question;
static char urdf[PATH_BYTES];
static char motion[PATH_BYTES];

/* The bodies are boxes with these sizes and places: those of `base`, and `tool` on joints x, y, z
 * and c. */
static void put_robot(const char *base, const char *tool) {
  snprintf(urdf, sizeof urdf, "%s/r.urdf", folder);
  FILE *out = fopen(urdf, "w");
  assert_non_null(out);
  fprintf(out,
          "<robot name='r'><link name='base'>%s</link><link name='lx'/><link name='ly'/>"
          "<link name='lz'/><link name='tool'>%s</link>",
          base, tool);
  static const char *const joints[4][4] = {{"x", "base", "lx", "1 0 0"},
                                           {"y", "lx", "ly", "0 1 0"},
                                           {"z", "ly", "lz", "0 0 1"},
                                           {"c", "lz", "tool", "0 0 1"}};
  for (int k = 0; k < 4; k++) {
    fprintf(out,
            "<joint name='%s' type='%s'><parent link='%s'/><child link='%s'/><axis xyz='%s'/>"
            "<limit lower='-99' upper='99'/></joint>",
            joints[k][0], k < 3 ? "prismatic" : "revolute", joints[k][1], joints[k][2],
            joints[k][3]);
  }
  fputs("</robot>", out);
  assert_int_equal(fclose(out), 0);
}

#define BOX(size, at) \
  "<collision><origin xyz='" at "'/><geometry><box size='" size "'/></geometry></collision>"
#define BALL(radius, at) \
  "<collision><origin xyz='" at "'/><geometry><sphere radius='" radius "'/></geometry></collision>"

static FILE *begin_motion(void) {
  snprintf(motion, sizeof motion, "%s/p.csv", folder);
  FILE *out = fopen(motion, "w");
  assert_non_null(out);
  fputs("x,y,z,c\n", out);
  return out;
}

static path_scene searched(int threads) {
  path_scene scene;
  question = (path_question){.urdf = urdf,
                             .motion = motion,
                             .bands.unit = CLI_METRES,
                             .meshes.unit = CLI_METRES,
                             .threads = threads};
  assert_works(path_scene_load(&scene, &question, &fault));
  assert_int_equal(scene.pairs, 1);
  assert_works(path_search(&scene, &question, &fault));
  return scene;
}

/* The least clearance as all lines one after the other have it, its first line and its points. */
static void assert_least(const path_scene *scene) {
  const path_pair *pair = &scene->pair[0];
  path_line at = path_line_begin(scene, &question, pair);
  double least = INFINITY;
  size_t first = PATH_NO_LINE;
  double point[2][3] = {{0}};
  for (size_t line = 0; line < scene->motion.lines; line++) {
    sepax_distance_result r;
    report_verdict verdict = VERDICT_FREE;
    path_line_pose(&at, line);
    assert_works(path_line_measure_alone(&at, &r, &fault));
    if (r.min_distance > 0 && path_line_boxes_overlap(&at)) {
      assert_works(path_line_within(&at, &verdict, &fault));
    }
    double distance = verdict == VERDICT_COLLISION ? 0 : r.min_distance;
    if (distance < least) {
      least = distance;
      first = line;
      memcpy(point, r.nearest_points, sizeof point);
    }
  }
  assert_true(pair->least == least);
  assert_int_equal(pair->least_line, first);
  for (int k = 0; k < 6 && !pair->inside; k++) {
    assert_true(pair->point[k / 3][k % 3] == point[k / 3][k % 3]);
  }
  assert_true(pair->interval[0] <= least && least <= pair->interval[1]);
  assert_true(least == 0 || nextafter(pair->interval[0], INFINITY) >= least);
  assert_true(least == 0 || nextafter(pair->interval[1], 0) <= least);
}

/* A tool that comes down: each line is nearer than all before. In the order of the lines each line
 * would be measured. */
CASE(test_descent) {
  put_robot(BOX("1 1 1", "0 0 0"), BALL("0.3", "0 0 0"));
  FILE *out = begin_motion();
  for (int n = 0; n < 1000; n++) {
    fprintf(out, "0.1,0.2,%.17g,0.3\n", 3 - 1e-3 * n);
  }
  fclose(out);
  path_scene scene = searched(1);
  assert_int_equal(scene.pair[0].least_line, 999);
  assert_in_range(scene.pair[0].measured, 1, 4);
  assert_int_equal(scene.pair[0].lines[VERDICT_FREE], 1000);
  assert_least(&scene);
  path_scene_free(&scene);
}

/* A tool in a groove: the boxes about the bodies overlap in all lines, so that bounds say nothing.
 * No line is measured twice, but for the few that are the nearest so far. */
CASE(test_groove) {
  put_robot(BOX("1 1 3", "-1 0 0") BOX("1 1 3", "1 0 0"), BALL("0.3", "0 0 0"));
  FILE *out = begin_motion();
  for (int n = 0; n < 1000; n++) {
    fprintf(out, "%.17g,%.17g,%.17g,0\n", 0.1 * random_unit(), 0.1 * random_unit(), 1e-3 * n);
  }
  fclose(out);
  path_scene scene = searched(1);
  assert_in_range(scene.pair[0].measured, 900, 1060);
  assert_least(&scene);
  path_scene_free(&scene);
}

/* Poses that come again: the first line of all that are equally near, in any block. */
CASE(test_ties) {
  static const double heights[] = {1.5, 1.25, 1.125, 1.75, 1.125, 1.5};
  put_robot(BOX("1 1 1", "0 0 0"), BOX("0.5 0.5 0.5", "0 0 0"));
  for (int before = 0; before <= 600; before += 300) {
    FILE *out = begin_motion();
    for (int n = 0; n < before; n++) {
      fprintf(out, "%.17g,0,2,0\n", 1e-3 * (n % 50));
    }
    for (int n = 0; n < 900; n++) {
      fprintf(out, "%.17g,0,%g,0\n", 1e-3 * (n / 6 % 3), heights[n % 6]);
    }
    fclose(out);
    for (int threads = 1; threads <= 3; threads++) {
      path_scene scene = searched(threads);
      assert_int_equal(scene.pair[0].least_line, before + 2);
      assert_true(scene.pair[0].least == 0.375);
      assert_least(&scene);
      path_scene_free(&scene);
    }
  }
}

/* Two threads: one is still at work in the groove when the other finds bodies that touch, in a
 * later line than the first that touches. */
CASE(test_first_touch) {
  put_robot(BOX("1 1 3", "-1 0 0") BOX("1 1 3", "1 0 0"), BALL("0.3", "0 0 0"));
  FILE *out = begin_motion();
  for (int n = 0; n < 600; n++) {
    fprintf(out, "%.17g,0,0,0\n", n < 250 ? 0.1 * random_unit() : 0.3 + 1e-4 * (n % 2));
  }
  fclose(out);
  for (int n = 0; n < 20; n++) {
    path_scene scene = searched(2);
    assert_int_equal(scene.pair[0].lines[VERDICT_COLLISION], 350);
    assert_true(scene.pair[0].least == 0);
    assert_int_equal(scene.pair[0].least_line, 250);
    path_scene_free(&scene);
  }
}

/* Random lines with collisions, bodies that touch, and one inside the other. `size`: how far the
 * tool moves. */
static void search_random(double size, bool in_steps) {
  FILE *out = begin_motion();
  for (int n = 0; n < 700; n++) {
    double v[3];
    for (int k = 0; k < 3; k++) {
      v[k] = in_steps ? random_below(17) / 8.0 - 1 : size * random_unit();
    }
    fprintf(out, "%.17g,%.17g,%.17g,%.17g\n", v[0], v[1], v[2], in_steps ? 0 : random_unit());
  }
  fclose(out);
  for (int threads = 1; threads <= 3; threads++) {
    path_scene scene = searched(threads);
    assert_least(&scene);
    path_scene_free(&scene);
  }
}

CASE(test_random_lines) {
  for (int n = 0; n < FEWER(4) + 1; n++) {
    put_robot(BOX("1 1 1", "0 0 0") BOX("0.5 0.5 0.5", "0 0 2"), BALL("0.1", "0 0 0"));
    search_random(0.3, false); /* often inside */
    search_random(1.5, false);
    search_random(9, false);
    put_robot(BOX("1 1 1", "0 0 0"), BOX("0.5 0.5 0.25", "0 0 0"));
    search_random(0, true); /* often touching */
  }
}
