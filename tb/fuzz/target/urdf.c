/* SPDX-License-Identifier: MIT */
/* urdf.c - URDF files; the links of what is read have poses at any values. */
#include "formats/formats.h"
#include "fuzz/fuzz.h"

#include <math.h>

static void require_poses(const sepax_mechanism *m) {
  double *value = calloc(m->joints + 1, sizeof *value);
  sepax_pose *pose = calloc(m->links + 1, sizeof *pose);
  REQUIRE(value != NULL && pose != NULL);
  sepax_mechanism_follow(m, value);
  sepax_mechanism_poses(m, value, pose);
  for (size_t n = 0; n < m->links; n++) {
    for (int i = 0; i < 9; i++) {
      REQUIRE(fabs(pose[n].rotation[i / 3][i % 3]) < 1.0001);
    }
  }
  free(value);
  free(pose);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  sepax_robot robot;
  sepax_error error = {0};
  const sepax_package package = {"here", "."};
  const sepax_robot_reading how = {.size = sizeof how, .package = &package, .packages = 1};
  const cli_meshes rules = {.unit = CLI_METRES};
  fuzz_file("input.urdf", data, size);
  bool ok = fuzz_answer(sepax_robot_read(&robot, "input.urdf", &how, &error), &error);
  if (ok) {
    REQUIRE(robot.mechanism.links > 0);
    require_poses(&robot.mechanism);
    for (size_t n = 0; n < robot.shapes && n < 4; n++) {
      sepax_soup mesh;
      report_mesh said;
      if (robot.shape[n].kind != SEPAX_SHAPE_MESH &&
          format_shape_mesh(&mesh, &said, &robot.shape[n], &rules, &error)) {
        REQUIRE(mesh.count >= 12);
        sepax_soup_free(&mesh);
      }
    }
    sepax_robot_free(&robot);
  }
  return 0;
}
