/* sepax_mechanism.h - links that joints hold together, and where they are: forward kinematics.
 *
 * A mechanism is a tree. Its links have coordinates of their own, in one unit of length (metres, of
 * a URDF); angles are in radians. A joint is between a link, its parent, and the link that it
 * moves, its child. In the parent's coordinates the child's pose is
 *
 *   origin, then about the axis by the joint's value (revolute, continuous), or along it
 *   (prismatic), or not at all (fixed).
 *
 * Rounding: the poses are computed in doubles. Of links with n joints between them the rotation is
 * wrong by at most n 2^-46 (the largest length by which a unit vector's image is off), the
 * translation by at most n 2^-45 L, L being the sum of the lengths of the origins' translations and
 * of the ways along axes, if the values, axes and origins are exact, and sin and cos are right to
 * one unit in the last place. docs/guides/path.md proves it. A verdict on bodies in such poses is
 * exact for the poses as they are rounded.
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
  SEPAX_JOINT_CONTINUOUS, /* revolute without limits */
  SEPAX_JOINT_PRISMATIC
} sepax_joint_kind;

typedef struct {
  char *name;
  size_t joint; /* whose child it is; SEPAX_NO_JOINT: the root. By sepax_mechanism_join */
} sepax_link;

typedef struct {
  char *name;
  sepax_joint_kind kind;
  size_t parent, child; /* links */
  sepax_pose origin;
  double axis[3];        /* of a joint that moves: of any length but 0 */
  double lower, upper;   /* limits of its value; -INFINITY, INFINITY: none */
  size_t mimic;          /* the joint that it follows, or SEPAX_NO_JOINT; then its value is */
  double factor, offset; /* factor * the other's value + offset */
} sepax_joint;

/* Fill in links, joints and their names, each in memory of sepax_allocate; then call
 * sepax_mechanism_join. */
typedef struct {
  sepax_link *link;
  size_t links;
  sepax_joint *joint;
  size_t joints;
  size_t root;   /* a link; by sepax_mechanism_join, as is the order: */
  size_t *order; /* all joints, those nearer to the root first */
} sepax_mechanism;

/* Check the joints, find root and order; axes become unit vectors, the origins' rotations, valid as
 * sepax_pose_valid has it, become orthonormal to rounding. A joint that follows one which follows a
 * third follows the third afterwards, with the product of the factors: `mimic` always names a joint
 * that leads. Errors: ARGUMENT on two roots, a cycle, a link that two joints move, an axis of
 * length 0, limits that are none, a joint that follows itself, also over others, or a fixed joint,
 * a factor or offset that is not finite; LIMIT on more than SEPAX_JOINTS_MOST joints; MEMORY. After
 * an error the mechanism can be freed, and nothing else. */
bool sepax_mechanism_join(sepax_mechanism *m, sepax_error *error);
void sepax_mechanism_free(sepax_mechanism *m);

/* True iff the joint has a value of its own: it moves, and follows no other. */
bool sepax_joint_driven(const sepax_joint *joint);

/* value[joints]: set those of joints that follow another. */
void sepax_mechanism_follow(const sepax_mechanism *m, double *value);

/* pose[links]: where the links are in the root's coordinates. value[joints] is finite; that of a
 * fixed joint is not read. */
void sepax_mechanism_poses(const sepax_mechanism *m, const double *value, sepax_pose *pose);

/* The joints between two links A and B: joint[0] ... joint[up - 1] lead from A up to `top`, the
 * link from which both hang; those behind them lead from there down to B. */
typedef struct {
  size_t *joint;
  size_t count, up, top;
} sepax_chain;

/* Error: MEMORY; free with sepax_chain_free. */
bool sepax_chain_find(sepax_chain *chain, const sepax_mechanism *m, size_t a, size_t b,
                      sepax_error *error);
void sepax_chain_free(sepax_chain *chain);

/* Where A and B are in the coordinates of `top`: no other joint has a part in it. */
void sepax_chain_poses(const sepax_chain *chain, const sepax_mechanism *m, const double *value,
                       sepax_pose pose[2]);

/* The joints go linearly from one set of values to another; at the middle they are midway, rounded.
 * The result is a bound: in B's coordinates no point of a box of A's (least and greatest
 * coordinates, in A's) is ever farther from where it is at the middle. Rounding is in it: that of
 * the bound, of values between the ends, and of the poses that sepax_chain_poses gives at the
 * middle. Values that follow are linear, too. docs/guides/path.md. */
double sepax_chain_travel(const sepax_chain *chain, const sepax_mechanism *m, const double *from,
                          const double *middle, const double *to, const double box[2][3]);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif
#endif
