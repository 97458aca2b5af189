/* SPDX-License-Identifier: MIT */
/* deviation.c - how much nearer bodies come if joints are off their linear motion: the bound on a
 * path against points of both bodies at joints that are off, and dog-legs. */
#include "harness.h"
#include "path/nc/program.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { JOINTS = 4, LINES = 3 };

static path_question question;
static char urdf[PATH_BYTES];

/* A table that tilts and turns, and a tool on two slides, with boxes that are not at their links.
 */
static const char slides[] =
    "<robot name='r'><link name='base'/><link name='tilt'/><link name='slide'/>"
    "<link name='table'><collision><origin xyz='.1 0 .05'/><geometry><box size='.4 .3 .1'/>"
    "</geometry></collision></link>"
    "<link name='tool'><collision><origin xyz='0 .02 .3'/><geometry><box size='.02 .04 .2'/>"
    "</geometry></collision></link>"
    "<joint name='a' type='continuous'><parent link='base'/><child link='tilt'/>"
    "<origin xyz='0 .1 .2'/><axis xyz='1 0 0'/></joint>"
    "<joint name='c' type='continuous'><parent link='tilt'/><child link='table'/>"
    "<origin xyz='0 -.1 -.2'/><axis xyz='0 0 1'/></joint>"
    "<joint name='x' type='prismatic'><parent link='base'/><child link='slide'/>"
    "<axis xyz='1 0 0'/><limit lower='-9' upper='9'/></joint>"
    "<joint name='z' type='prismatic'><parent link='slide'/><child link='tool'/>"
    "<origin xyz='0 0 .5'/><axis xyz='0 0 1'/><limit lower='-9' upper='9'/></joint></robot>";

/* A small part that tilts and turns, and a long tool on a head that swivels beside it. */
static const char head[] =
    "<robot name='r'><link name='base'/><link name='tilt'/><link name='slide'/>"
    "<link name='table'><collision><geometry><box size='.04 .03 .02'/></geometry></collision>"
    "</link>"
    "<link name='tool'><collision><origin xyz='0 0 -.3'/><geometry><box size='.02 .04 .2'/>"
    "</geometry></collision></link>"
    "<joint name='a' type='continuous'><parent link='base'/><child link='tilt'/>"
    "<axis xyz='1 0 0'/></joint>"
    "<joint name='c' type='continuous'><parent link='tilt'/><child link='table'/>"
    "<axis xyz='0 0 1'/></joint>"
    "<joint name='x' type='prismatic'><parent link='base'/><child link='slide'/>"
    "<axis xyz='1 0 0'/><limit lower='-9' upper='9'/></joint>"
    "<joint name='z' type='continuous'><parent link='slide'/><child link='tool'/>"
    "<origin xyz='.8 0 .3'/><axis xyz='0 1 0'/></joint></robot>";

static void put_machine(const char *text) {
  snprintf(urdf, sizeof urdf, "%s/r.urdf", folder);
  FILE *out = fopen(urdf, "w");
  assert_non_null(out);
  fputs(text, out);
  assert_int_equal(fclose(out), 0);
}

/* A path of three lines, as if a program had made it. */
static path_scene made(const char *machine, bool dogleg) {
  static char csv[PATH_BYTES];
  path_scene scene;
  put_machine(machine);
  snprintf(csv, sizeof csv, "%s/p.csv", folder);
  FILE *out = fopen(csv, "w");
  assert_non_null(out);
  fputs("a,c,x,z,kind\n0,0,0,0,rapid\n0.3,-2,0.2,0.1,rapid\n-0.4,1,0.1,0.3,rapid\n", out);
  assert_int_equal(fclose(out), 0);
  question = (path_question){
      .urdf = urdf, .motion = csv, .bands.unit = CLI_METRES, .meshes.unit = CLI_METRES};
  assert_works(path_scene_load(&scene, &question, &fault));
  assert_int_equal(scene.pairs, 1);
  assert_int_equal(scene.motion.joints, JOINTS);
  size_t numbers = LINES * JOINTS;
  scene.nc.joints = JOINTS;
  scene.nc.rows = LINES;
  scene.nc.row = sepax_allocate(LINES * sizeof *scene.nc.row);
  scene.nc.deviation = sepax_allocate(numbers * sizeof(double));
  scene.nc.blending = sepax_allocate(numbers * sizeof(double));
  scene.row_of = sepax_allocate(LINES * sizeof *scene.row_of);
  for (size_t n = 0; n < LINES; n++) {
    scene.row_of[n] = n;
    scene.nc.row[n] = (nc_row){.kind = NC_RAPID, .dogleg = dogleg, .share = 1};
    for (size_t j = 0; j < JOINTS; j++) {
      scene.nc.deviation[n * JOINTS + j] = dogleg ? 0 : 1e-3 * (1 + fabs(random_unit()));
      scene.nc.blending[n * JOINTS + j] = dogleg ? 0 : 1e-3 * fabs(random_unit());
      scene.joint_of[j] = j;
    }
  }
  assert_works(path_program_deviations(&scene, true, &fault));
  return scene;
}

/* The distance of a corner of each body. */
static double corners_apart(const path_scene *scene, const double *value, const int corner[2]) {
  const path_pair *pair = &scene->pair[0];
  sepax_pose pose[2];
  double at[2][3];
  sepax_chain_poses(&pair->chain, &scene->robot.mechanism, value, pose);
  for (int side = 0; side < 2; side++) {
    const path_body *b = &scene->body[pair->body[side]];
    double v[3];
    for (int i = 0; i < 3; i++) {
      v[i] = (corner[side] >> i & 1) != 0 ? b->most[i] : b->least[i];
    }
    sepax_pose_apply(&pose[side], v, at[side]);
  }
  return hypot(hypot(at[0][0] - at[1][0], at[0][1] - at[1][1]), at[0][2] - at[1][2]);
}

/* The greatest share of the bound that is reached, of many paths of a machine. */
static double share_reached(const char *machine) {
  double reached = 0;
  for (int round = 0; round < FEWER(40); round++) {
    path_scene scene = made(machine, false);
    for (int n = 0; n < 2000; n++) {
      size_t line = 1 + (size_t)random_below(LINES - 1);
      double part = fabs(random_unit());
      double value[2][JOINTS];
      int corner[2] = {random_below(8), random_below(8)};
      for (size_t j = 0; j < JOINTS; j++) {
        size_t at = line * JOINTS + j;
        double off = scene.nc.deviation[at] + scene.nc.blending[at];
        double from = scene.motion.value[at - JOINTS];
        value[0][j] = from + part * (scene.motion.value[at] - from);
        value[1][j] = value[0][j] + off * (random_below(2) == 0 ? 1 : -1);
      }
      double change =
          corners_apart(&scene, value[0], corner) - corners_apart(&scene, value[1], corner);
      assert_true(change <= scene.motion.step[line].deviation);
      reached = fmax(reached, change / scene.motion.step[line].deviation);
    }
    path_scene_free(&scene);
  }
  print_message("%.3f of the bound\n", reached);
  return reached;
}

CASE(joints_that_are_off) {
  assert_true(share_reached(slides) > 0.3);
  assert_true(share_reached(head) > 0.3);
}

/* Each joint takes its own time: it may be anywhere between its values at the ends. */
static void any_in_box(const double *from, const double *to, double *value) {
  for (size_t j = 0; j < JOINTS; j++) {
    double part = random_below(3) == 0 ? fabs(random_unit()) : random_below(2);
    value[j] = from[j] + (to[j] - from[j]) * part;
  }
}

/* Is this a place that the motion to a line covers? Then `value` becomes its place on the way. */
static bool covers(const path_scene *scene, size_t line, const double *place, double *value) {
  const format_motion *motion = &scene->motion;
  const double *to = &motion->value[line * JOINTS];
  const double *from = to - JOINTS;
  for (size_t j = 0; j < JOINTS; j++) {
    double spread = scene->spread[line * JOINTS + j];
    double low = fmin(from[j], to[j]);
    double high = fmax(from[j], to[j]);
    if (!(place[j] >= low - spread && place[j] <= high + spread)) {
      return false;
    }
    value[j] = low == high ? low : place[j];
  }
  return true;
}

CASE(doglegs) {
  double reached = 0;
  for (int near = 0; near < 2; near++) {
    path_scene scene = made(slides, true);
    double end[LINES * JOINTS];
    memcpy(end, scene.motion.value, sizeof end);
    question.bands.clearance.length = near != 0 ? 0.45 : 0; /* boxes must be divided */
    question.resolution.length = 1e-3;
    assert_works(path_program_doglegs(&scene, &question, &fault));
    assert_works(path_program_deviations(&scene, true, &fault));
    assert_true(near == 0 ? scene.motion.lines < 20 : scene.motion.lines > 20);
    for (int n = 0; n < FEWER(4000); n++) {
      size_t row = 1 + (size_t)random_below(LINES - 1);
      double place[JOINTS];
      double value[JOINTS];
      int corner[2] = {random_below(8), random_below(8)};
      size_t covered = 0;
      any_in_box(&end[(row - 1) * JOINTS], &end[row * JOINTS], place);
      for (size_t line = 1; line < scene.motion.lines; line++) {
        if (scene.row_of[line] != row || !format_motion_goes_on(&scene.motion, line - 1) ||
            !covers(&scene, line, place, value)) {
          continue;
        }
        covered++;
        double change = corners_apart(&scene, value, corner) - corners_apart(&scene, place, corner);
        assert_true(change <= scene.motion.step[line].deviation);
        reached = fmax(reached, change / scene.motion.step[line].deviation);
      }
      assert_true(covered > 0);
    }
    print_message("%zu lines, %.3f of the bound\n", scene.motion.lines, reached);
    path_scene_free(&scene);
  }
  assert_true(reached > 0.15);
}
