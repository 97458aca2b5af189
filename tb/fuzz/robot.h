/* SPDX-License-Identifier: MIT */
/* robot.h - a mechanism whose links and joints the inputs of the fuzz targets name. */
#ifndef FUZZ_ROBOT_H
#define FUZZ_ROBOT_H

#include "formats/formats.h"
#include "fuzz/fuzz.h"

#include <stdio.h>
#include <string.h>

static inline void read_robot(sepax_robot *robot) {
  static const char text[] =
      "<robot name='r'><link name='a'/><link name='b'><collision><geometry><sphere radius='1'/>"
      "</geometry></collision></link><link name='c'/><link name='d'/>"
      "<joint name='x' type='prismatic'><parent link='a'/><child link='b'/><axis xyz='1 0 0'/>"
      "<limit lower='-1' upper='1'/></joint>"
      "<joint name='q' type='continuous'><parent link='b'/><child link='c'/></joint>"
      "<joint name='m' type='prismatic'><parent link='a'/><child link='d'/>"
      "<limit lower='-9' upper='9'/><mimic joint='x' multiplier='2'/></joint></robot>";
  sepax_error error = {0};
  fuzz_file("robot.urdf", (const uint8_t *)text, sizeof text - 1);
  bool ok = sepax_robot_read(robot, "robot.urdf", NULL, &error);
  if (!ok) {
    fprintf(stderr, "%s\n", error.text);
  }
  REQUIRE(ok);
}

#endif
