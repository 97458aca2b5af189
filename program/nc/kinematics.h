/* SPDX-License-Identifier: MIT */
/* kinematics.h - from positions of the axes to positions of the joints, and back.
 *
 * Known kinematics, with the formulas of LinuxCNC's document "5-Axis Kinematics" (2.9; equations
 * 25, 28, 36 and 39) and of its bridge mill. Lengths are in mm, angles in degrees. P is the
 * position of the axes, J that of the joints, R the point (x-rot-point, y-rot-point, z-rot-point),
 * Rx(t) the right-handed rotation about X by t.
 *
 *   trivkins         each joint is the axis that it moves
 *   xyzac-trt-kins   J = R + D + Rx(A) (Rz(C) (P - R) - D), D = (0, y-offset, z-offset +
 * tool-offset) xyzbc-trt-kins   J = R + D + Ry(B) (Rz(C) (P - R) - D), D = (x-offset, 0, z-offset +
 * tool-offset) 5axiskins        J = P - r (sin B cos C, sin B sin C, -cos B) - (0, 0,
 * pivot-length), r = pivot-length + W
 *
 * All other axes are joints as they are. A joint's value under 5axiskins differs from LinuxCNC's in
 * the last bits, because LinuxCNC computes with 180 degrees - B.
 *
 * All but trivkins have types: 0 is the kinematics above, 1 is the identity. The word
 * sparm=identityfirst exchanges the two. Type 2 is kinematics of the user's own; it is refused. */
#ifndef SEPAX_NC_KINEMATICS_H
#define SEPAX_NC_KINEMATICS_H

#include "nc/canon.h"
#include "nc/interval.h"

typedef enum { NC_TRIVIAL, NC_XYZAC, NC_XYZBC, NC_BRIDGE } nc_module;

/* The parameters of all kinematics. */
enum { NC_POINT, NC_OFFSET = 3, NC_TOOL_OFFSET = 6, NC_PIVOT, NC_CONVENTIONAL, NC_VALUES };

typedef struct {
  nc_module module;
  bool identity_first;
  double base[NC_VALUES];  /* as the configuration says */
  bool follows[NC_VALUES]; /* the Z of the tool offset in force is added to it */
  double value[NC_VALUES]; /* in force */
  int joint_axis[NC_JOINTS_MOST];
  size_t joints;
  bool identity; /* of the type in force */
} nc_kinematics;

/* The kinematics of a program, with type 0 in force and no tool offset. `name` stands for the
 * stream in messages. Fails if they are not known, a word or a parameter is not one of theirs,
 * `coordinates=` differs from the joints' axes, an axis that they need has no joint, or
 * conventional-directions is not 0. */
bool nc_kinematics_of(nc_kinematics *k, const nc_program *program, const char *name,
                      sepax_error *error);

/* Put a type in force. False if there is none of this number; nothing is changed then. */
bool nc_kinematics_switch(nc_kinematics *k, int type);

/* Put the Z of a tool offset in force, in mm. True if the kinematics change by it. */
bool nc_kinematics_length(nc_kinematics *k, double z);

/* The joints at positions of the axes, as functions of one variable, in m and rad: values and
 * derivatives are contained. Cost: about 0.5 us. */
void nc_kinematics_joints(const nc_kinematics *k, const nc_jet axis[NC_AXES],
                          nc_jet joint[NC_JOINTS_MOST]);

/* A limit of a joint in m or rad, from mm or degrees. */
nc_interval nc_kinematics_metric(bool angular, nc_interval value);

#endif
