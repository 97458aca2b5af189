/* SPDX-License-Identifier: MIT */
/* load.c - reads the machines of a guard and takes all its memory; not for real time. */
#include "machine.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double DEGREE = 0.017453292519943295;

static bool say(char *text, const char *what, const char *name) {
  snprintf(text, GUARD_TEXT, what, name);
  return false;
}

static bool settings_good(const guard_settings *s, char *text) {
  if (s->joints < 1 || s->joints > GUARD_JOINTS_MOST) {
    return say(text, "%s: 1 to 9 joints", "joints");
  }
  if (!(s->clearance > 0 && isfinite(s->clearance) && s->slow_zone >= 0 &&
        isfinite(s->slow_zone))) {
    return say(text, "%s: a length above 0 is needed", "clearance, slow_zone");
  }
  if (!(s->slow_scale > 0 && s->slow_scale <= 1 && s->brake > 0 && s->brake <= 1)) {
    return say(text, "%s: a number above 0, at most 1", "slow_scale, brake");
  }
  if (!(s->reaction >= 4 && s->reaction <= 1e6 && s->unit > 0 && s->unit <= 1e3) || s->work == 0) {
    return say(text, "%s: reaction is at least 4 periods, work and unit are above 0", "settings");
  }
  for (size_t n = 0; n < s->joints; n++) {
    if (s->axis[n] == 0 || strchr("XYZABCUVW", s->axis[n]) == NULL) {
      return say(text, "%s: only letters of XYZABCUVW, one for each joint", "coordinates");
    }
    if (memchr(s->axis, s->axis[n], n) != NULL) {
      return say(text, "%s: two joints of one axis are not known here", "coordinates");
    }
  }
  return true;
}

/* Each joint of the mechanism that has a value of its own belongs to one joint of the control. */
static bool map_joints(guard_machine *m, const guard_settings *s, char *text) {
  const sepax_mechanism *mechanism = &m->robot.robot.mechanism;
  size_t driven = 0;
  for (size_t k = 0; k < mechanism->joints; k++) {
    driven += sepax_joint_driven(&mechanism->joint[k]) ? 1 : 0;
  }
  for (size_t n = 0; n < s->joints; n++) {
    if (strlen(s->name[n]) >= TUBE_NAME) {
      return say(text, "joint %s: the name has more than 63 bytes", s->name[n]);
    }
    m->joint[n] = sepax_robot_joint(&m->robot.robot, s->name[n]);
    if (m->joint[n] == SEPAX_NO_JOINT || !sepax_joint_driven(&mechanism->joint[m->joint[n]])) {
      return say(text, "joint %s is not in the URDF, or has no value of its own", s->name[n]);
    }
    for (size_t before = 0; before < n; before++) {
      if (m->joint[before] == m->joint[n]) {
        return say(text, "joint %s is named twice", s->name[n]);
      }
    }
    const bool length = mechanism->joint[m->joint[n]].kind == SEPAX_JOINT_PRISMATIC;
    if (length != (strchr("ABC", s->axis[n]) == NULL)) {
      return say(text, "joint %s turns where the axis is linear, or the other way", s->name[n]);
    }
    m->scale[n] = length ? s->unit : DEGREE;
  }
  return driven == s->joints ||
         say(text, "%s: the URDF has joints that the control does not move; make them fixed",
             "joints");
}

/* Does a joint that turns carry this one? */
static bool is_turned(const sepax_mechanism *m, const sepax_joint *joint) {
  size_t link = joint->parent;
  for (size_t k = 0; k < m->joints; k++) {
    const sepax_joint *above = &m->joint[k];
    if (above->child == link) {
      return (above->kind != SEPAX_JOINT_PRISMATIC && above->kind != SEPAX_JOINT_FIXED) ||
             is_turned(m, above);
    }
  }
  return false;
}

/* Then linear joints that move by a vector of length L move no body by more than L, as seen from
 * any other. The axes are those in the root's coordinates, in which the linear joints do not turn:
 * no other joint carries them. */
static bool is_square(const guard_machine *m, const guard_settings *s) {
  const sepax_mechanism *mechanism = &m->robot.robot.mechanism;
  double axis[GUARD_JOINTS_MOST][3];
  size_t axes = 0;
  sepax_pose *pose = calloc(mechanism->links, sizeof *pose);
  bool square = pose != NULL;
  if (square) {
    sepax_mechanism_poses(mechanism, m->value, pose);
  }
  for (size_t n = 0; n < s->joints && square; n++) {
    const sepax_joint *joint = &mechanism->joint[m->joint[n]];
    if (joint->kind != SEPAX_JOINT_PRISMATIC) {
      continue;
    }
    square = !is_turned(mechanism, joint);
    for (int k = 0; k < 3; k++) {
      const double *row = pose[joint->child].rotation[k];
      axis[axes][k] = row[0] * joint->axis[0] + row[1] * joint->axis[1] + row[2] * joint->axis[2];
    }
    for (size_t before = 0; before < axes && square; before++) {
      const double *a = axis[before];
      const double *b = axis[axes];
      square = fabs(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) < 1e-10;
    }
    axes++;
  }
  for (size_t k = 0; k < mechanism->joints; k++) { /* a follower would move a body once more */
    square = square && mechanism->joint[k].mimic == SEPAX_NO_JOINT;
  }
  free(pose);
  return square;
}

static bool load(guard_machine *m, const guard_settings *s, const guard_tool *tool, char *text) {
  sepax_error error = {0};
  m->tool = tool->tool;
  if (!sepax_robot_machine_read(&m->robot, tool->urdf, tool->srdf, NULL, &error)) {
    return say(text, "%s", error.text);
  }
  m->read = true;
  if (!sepax_watch_new(&m->watch, m->robot.machine, &error)) {
    return say(text, "%s", error.text);
  }
  const size_t joints = m->robot.robot.mechanism.joints;
  m->value = calloc(joints + 1, sizeof *m->value);
  m->travel = calloc(joints + 1, sizeof *m->travel);
  if (m->value == NULL || m->travel == NULL) {
    return say(text, "%s", "out of memory");
  }
  if (!map_joints(m, s, text)) {
    return false;
  }
  m->square = is_square(m, s);
  return true;
}

guard *guard_new(const guard_settings *settings, const guard_tool *tool, size_t tools, char *text) {
  guard *g = calloc(1, sizeof *g);
  if (g == NULL) {
    say(text, "%s", "out of memory");
    return NULL;
  }
  g->settings = *settings;
  bool good = settings_good(settings, text);
  if (good && (tools == 0 || tools > GUARD_TOOLS_MOST)) {
    good = say(text, "%s", "give the URDF of 1 to 16 tools");
  }
  for (size_t n = 0; n < tools && good; n++) {
    g->tools = n + 1;
    good = load(&g->tool[n], settings, &tool[n], text);
  }
  if (!good) {
    guard_free(g);
    return NULL;
  }
  return g;
}

void guard_free(guard *g) {
  if (g == NULL) {
    return;
  }
  for (size_t n = 0; n < g->tools; n++) {
    guard_machine *m = &g->tool[n];
    sepax_watch_free(m->watch);
    if (m->read) {
      sepax_robot_machine_free(&m->robot);
    }
    free(m->value);
    free(m->travel);
  }
  free(g);
}

void guard_use_tube(guard *g, const tube *t) { g->tube = t; }

void guard_begin_tube(const guard *g, tube *t, uint64_t rows) {
  t->magic = TUBE_MAGIC;
  t->joints = (uint32_t)g->settings.joints;
  t->most = rows;
  t->clearance = g->settings.clearance;
  for (size_t n = 0; n < g->settings.joints; n++) {
    t->scale[n] = g->tool[0].scale[n];
    snprintf(t->name[n], TUBE_NAME, "%.*s", TUBE_NAME - 1, g->settings.name[n]);
  }
}

const char *guard_link_name(const guard *g, size_t link) {
  const sepax_mechanism *m = &g->tool[0].robot.robot.mechanism;
  return link < m->links ? m->link[link].name : "";
}
