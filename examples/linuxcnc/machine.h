/* SPDX-License-Identifier: MIT */
/* machine.h - what the guard keeps: the machine of each tool, and its own state. */
#ifndef GUARD_MACHINE_H
#define GUARD_MACHINE_H

#include "guard.h"

typedef struct {
  long tool;
  bool read;
  sepax_robot_machine robot;
  sepax_watch *watch;
  size_t joint[GUARD_JOINTS_MOST]; /* of the mechanism */
  double scale[GUARD_JOINTS_MOST]; /* metres or radians in the control's unit */
  double *value, *travel;          /* of each joint of the mechanism */
  bool square;  /* the axes of its linear joints are at right angles, and no joint turns them */
  double apart; /* any body may also move by this length in any direction, in metres */
} guard_machine;

struct guard {
  guard_settings settings;
  guard_machine tool[GUARD_TOOLS_MOST];
  size_t tools;
  bool seen;    /* a period before was homed: `last` is valid */
  bool latched; /* stopped until the reset */
  bool slow;    /* in the slow zone */
  bool rebase;  /* `kept` is set anew as soon as the joints rest */
  bool reset_was;
  double kept; /* while latched: jogs keep the bodies farther apart than this, in metres */
  double last[GUARD_JOINTS_MOST], before[GUARD_JOINTS_MOST]; /* position, velocity */
  size_t since;          /* periods since the guard last began to compare bodies */
  guard_output measured; /* last: distances and their pair */
  guard_reason reason;
  const tube *tube;
  tube_place place; /* in it */
  bool left;        /* the machine was in the tube one period before, and is not now */
};

#endif
