/* SPDX-License-Identifier: MIT */
/* robot.h - links, joints and collision geometry of a URDF; pairs that an SRDF excludes. */
#ifndef CERTIFICATE_ROBOT_H
#define CERTIFICATE_ROBOT_H

#include "files.h"
#include "surface.h"
#include "vector.h"

#include <stdbool.h>

typedef enum { JOINT_FIXED, JOINT_REVOLUTE, JOINT_PRISMATIC } joint_kind;

typedef struct {
  char *name;
  joint_kind kind;
  int parent, child; /* links */
  pose origin;
  point axis;
  int mimic; /* the joint whose value, times factor, plus offset, is this one's; or -1 */
  char *mimics;
  long double factor, offset;
} joint;

typedef struct {
  char *name;
  int joint; /* that leads to its parent, or -1 */
  surface body;
  /* Of a part of a tool that is held by a link; otherwise NULL. */
  const char *role; /* "flutes" */
  const char *tool; /* it exists only with this tool in the spindle */
} robot_link;

typedef struct {
  robot_link *link;
  joint *joint;
  int links, joints;
  bool *excluded; /* links x links */
} robot;

/* Folders of package://NAME/...; the first entry with a name counts. */
typedef struct {
  char *name, *folder;
} package;
typedef struct {
  package *entry;
  size_t count;
} packages;

/* srdf may be NULL: then the two links of a joint are excluded, and those which no joint moves
 * against each other. */
robot robot_read(const char *urdf, const char *srdf, const packages *folders, files *f);

/* -1: none of that name. */
int robot_link_named(const robot *r, const char *name);
int robot_joint_named(const robot *r, const char *name);

#endif
