/* SPDX-License-Identifier: MIT */
/* sepax_mechanism.h - mechanisms: links held together by joints, and the poses of the links for
 * given joint values (forward kinematics). The conventions are those of sepax.h.
 *
 * A mechanism is a tree of links, with the names of URDF. Each link has its own coordinates. All
 * lengths are in one unit (metres if the mechanism comes from a URDF file); angles are in radians.
 * A joint connects a parent link with the child link that the joint moves. The pose of the child in
 * the parent's coordinates is the joint's origin, composed with the motion of the joint:
 *
 *   revolute, continuous: a rotation about the axis by the joint's value, in radians
 *   prismatic: a translation along the axis by the joint's value, in units of length
 *   fixed: no motion
 *
 * Rounding: poses are computed in doubles. Let n joints lie between two links. Let L be the sum of
 * the lengths of all translations on the way: those of the origins and those along prismatic axes.
 * Then the image of a unit vector under the rotation is wrong by at most n 2^-46, and the
 * translation is wrong by at most n 2^-45 L. This holds if values, axes and origins are exact and
 * the C library's sin and cos are right to one unit in the last place. docs/reference/mechanisms.md
 * has the proof. A verdict on bodies in such poses is exact for the rounded poses.
 */
#ifndef SEPAX_MECHANISM_H
#define SEPAX_MECHANISM_H

#include "sepax.h"

#ifdef __cplusplus
extern "C" {
#endif
#ifdef __GNUC__
#pragma GCC visibility push(default)
#endif

#define SEPAX_NO_JOINT SIZE_MAX
#define SEPAX_JOINTS_MOST 65536

typedef enum {
  SEPAX_JOINT_FIXED,
  SEPAX_JOINT_REVOLUTE,
  SEPAX_JOINT_CONTINUOUS, /* revolute, without limits */
  SEPAX_JOINT_PRISMATIC
} sepax_joint_kind;

typedef struct {
  char *name;
  size_t joint; /* the joint that moves it, or SEPAX_NO_JOINT for the root;
                   set by sepax_mechanism_join */
} sepax_link;

typedef struct {
  char *name;
  sepax_joint_kind kind;
  size_t parent, child;  /* numbers of links */
  sepax_pose origin;     /* of the child in the parent's coordinates when the value is 0 */
  double axis[3];        /* direction, any length but 0; not read if the joint is fixed */
  double lower, upper;   /* limits of the value; -INFINITY, INFINITY: none */
  size_t mimic;          /* the joint that this joint follows, or SEPAX_NO_JOINT. The value of a */
  double factor, offset; /* follower is factor * (value of that joint) + offset */
} sepax_joint;

/* To make a mechanism, fill in `link`, `joint` and all names with memory of sepax_allocate. Then
 * call sepax_mechanism_join. */
typedef struct {
  sepax_link *link;
  size_t links;
  sepax_joint *joint;
  size_t joints;
  size_t root;   /* the link that no joint moves; set by sepax_mechanism_join */
  size_t *order; /* all joints, the nearer to the root the earlier; set by sepax_mechanism_join */
} sepax_mechanism;

/* Check a mechanism and complete it:
 *   - `root` and `order` are set.
 *   - Each axis becomes a unit vector.
 *   - The rotation of each origin, which must be valid (sepax_pose_valid), becomes orthonormal up
 * to rounding.
 *   - If a joint follows a second joint that follows a third one, then the first joint now follows
 *     the third one, with the factor and offset of both steps. So `mimic` always names a joint that
 *     follows no other.
 * Errors: ARGUMENT on no links, two roots, a cycle of links, a link that two joints move, an axis
 * of length 0, a lower limit above the upper one, a joint that follows itself (also by way of other
 * joints) or a fixed joint, or a factor or offset that is not finite; LIMIT on more than
 * SEPAX_JOINTS_MOST joints; MEMORY. After an error the mechanism can only be freed. */
bool sepax_mechanism_join(sepax_mechanism *m, sepax_error *error);
void sepax_mechanism_free(sepax_mechanism *m);

/* True if the joint has a value of its own: it is not fixed and follows no other joint. */
bool sepax_joint_driven(const sepax_joint *joint);

/* Set the values of all joints that follow another joint. value[n] is the value of joint n. */
void sepax_mechanism_follow(const sepax_mechanism *m, double *value);

/* The pose of each link in the root's coordinates: pose[n] is the pose of link n. value[n] is the
 * value of joint n. The values must be finite; those of fixed joints are not read. Call
 * sepax_mechanism_follow before. */
void sepax_mechanism_poses(const sepax_mechanism *m, const double *value, sepax_pose *pose);

/* The joints between two links A and B. `top` is the last link that the ways from the root to A and
 * to B have in common. joint[0] ... joint[up - 1] lead from A up to `top`. joint[up] ...
 * joint[count - 1] lead from `top` down to B. */
typedef struct {
  size_t *joint;
  size_t count, up, top;
} sepax_chain;

/* Find the chain between links `a` and `b`. Error: MEMORY. */
bool sepax_chain_find(sepax_chain *chain, const sepax_mechanism *m, size_t a, size_t b,
                      sepax_error *error);
void sepax_chain_free(sepax_chain *chain);

/* The poses of A and B in the coordinates of `top`. They depend only on the joints of the chain.
 * value[n] is the value of joint n of the mechanism. */
void sepax_chain_poses(const sepax_chain *chain, const sepax_mechanism *m, const double *value,
                       sepax_pose pose[2]);

/* A bound on the motion of link A relative to link B while all joints move linearly from the values
 * `from` to the values `to`. `middle` has the values halfway, rounded. box[0] and box[1] are the
 * least and the greatest coordinates of a box in A's coordinates. During the motion no point of the
 * box, in B's coordinates, is farther from its place at `middle` than the returned length.
 *
 * The bound includes all rounding: of the bound itself, of the joint values on the way, and of the
 * poses that sepax_chain_poses computes at `middle`. Joints that follow others move linearly, too.
 * docs/reference/mechanisms.md has the proof. */
double sepax_chain_travel(const sepax_chain *chain, const sepax_mechanism *m, const double *from,
                          const double *middle, const double *to, const double box[2][3]);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif
#endif
