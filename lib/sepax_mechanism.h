/* SPDX-License-Identifier: MIT */
/* sepax_mechanism.h - mechanisms: links held together by joints, and the poses of the links for
 * given joint values (forward kinematics); machines: which bodies on the links are near. The
 * conventions are those of sepax.h.
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
 *     to rounding.
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

/* ------------------------------------------------------------------ machines */

/* A machine: a mechanism, bodies on its links, and the pairs of bodies that are compared. It never
 * changes after sepax_machine_new, so threads may share it. It answers the question of a control
 * loop: is any pair of bodies near for these joint values, or for all values close to them?
 *
 * Only surfaces are compared. A body that lies wholly inside another one and does not come near its
 * surface is not found. If a body may be inside another one at the start, then ask
 * sepax_bodies_within at the start. Later no body gets inside another one as long as all joints
 * stay within the travel of queries that say APART. */
typedef struct sepax_machine sepax_machine;

/* A body on a link. Its mesh has the link's coordinates. */
typedef struct {
  size_t link;
  const sepax_body *body;
} sepax_machine_body;

/* What a machine is made of. The links and joints of the mechanism, and the bodies, must live as
 * long as the machine and must not change. The struct of the mechanism and both lists are copied.
 */
typedef struct {
  size_t size;
  const sepax_mechanism *mechanism; /* after sepax_mechanism_join */
  const sepax_machine_body *body;
  size_t bodies;
  const size_t (*pair)[2]; /* numbers of two bodies that are compared */
  size_t pairs;
} sepax_machine_parts;

/* Make a machine. Cost: one pass over the triangles of the bodies. Errors: ARGUMENT if the
 * mechanism was not joined, if a body names no link, if a pair names no body or the same body
 * twice, or if there is no pair; MEMORY. */
bool sepax_machine_new(sepax_machine **machine, const sepax_machine_parts *parts,
                       sepax_error *error);
void sepax_machine_free(sepax_machine *machine);

/* The memory of one thread's queries of one machine. sepax_watch_new allocates and writes all of
 * it, so that a query neither allocates nor meets a page of this memory for the first time. It
 * takes about 11 KB for each pair and, for each top link of the pairs (sepax_chain), 250 bytes
 * for each link and body below. Each thread needs a watch of its own. The machine must live as long
 * as the watch. Error: MEMORY. */
typedef struct sepax_watch sepax_watch;
bool sepax_watch_new(sepax_watch **watch, const sepax_machine *machine, sepax_error *error);
void sepax_watch_free(sepax_watch *watch);

/* Options of sepax_watch_ask. By default the query asks for collisions, at the values themselves,
 * without a limit of work. */
typedef struct {
  size_t size;
  double clearance; /* 0 ... 2^1000: two bodies are near if their distance is at most this. A
                       distance of 0 is a collision */
  /* travel[n]: joint n may be anywhere within value[n] - travel[n] ... value[n] + travel[n],
   * independently of the other joints. Each number is finite and not negative, in the joint's unit.
   * Those of fixed joints and of joints that follow another are not read. APART, `least` and `most`
   * then hold for all these positions at once. They also hold for the exact poses of the links
   * instead of the rounded ones, even if all numbers are 0. NULL: the answer holds for the values
   * alone. */
  const double *travel;
  uint64_t work; /* units of work in all (sepax.h); 0: no limit. One unit for each pair is always
                    used */
  bool measure;  /* also find the least clearance */
  double relative, absolute; /* its tolerance, as in sepax_distance_request */
  sepax_simd simd;
} sepax_machine_query;

#define SEPAX_NO_PAIR SIZE_MAX

typedef struct {
  /* APART: in all positions that were asked for, the bodies of each pair are farther apart than the
   * clearance. NEAR: at the values, the bodies of `pair` have two triangles that are at most the
   * clearance apart. UNDECIDED: the work ended before one of these was proved, or the bodies are
   * apart at the values but may be near within the travel. Without travel, the verdict is exact for
   * the poses that sepax_chain_poses computes, bit by bit. */
  sepax_nearness verdict;
  size_t pair; /* NEAR: the first pair that is near. An earlier one may be undecided if the work
                  ended. UNDECIDED: the first pair that is undecided. APART: SEPAX_NO_PAIR */
  size_t triangle[2]; /* if NEAR: a triangle of each body of that pair; any two that are near */
  /* If the query measures: the least clearance is the least distance of any pair in any of the
   * positions that were asked for. least <= least clearance <= most, and both bounds are certain.
   * Without travel the interval is at most as wide as the tolerance allows, unless the work
   * ended. If the lengths between two bodies are below 2^-400 or above 2^450 in all, then travel
   * proves nothing of them. `most` is infinite if no pair was measured. If the query does not
   * measure, then both are 0. */
  double least, most;
  size_t nearest; /* the pair that has a distance of at most `most`; SEPAX_NO_PAIR if no pair was
                     measured */
  uint64_t work;  /* units of work that the query took */
} sepax_machine_answer;

/* Ask about the machine at the values of its joints: value[n] is the value of joint n. Those of
 * fixed joints and of joints that follow another are not read. Limits of joints are not checked.
 *
 * If the work does not end, then the verdict and `pair` do not depend on earlier queries of the
 * watch. But `work`, `triangle` and the interval within its tolerance may depend on them, because
 * the watch remembers bounds, near triangles and a front of each pair (sepax.h), which makes
 * similar queries faster.
 *
 * The work is divided as follows. First all pairs are compared by their boxes. Of the pairs that
 * remain, the one that was near last is searched first; the others follow in their order. Each pair
 * gets an equal share of the work that is left. What it does not use is left for the others. Pairs
 * that are undecided are searched again as long as their share is at least twice the share before.
 * The measurement gets the rest: half of it goes to the pair with the least bound, then half of
 * what is left to the pair that has the least bound then, and so on.
 *
 * Real time: the call neither allocates, nor locks, nor reads a clock, nor calls a function of the
 * caller, and does not recurse. docs/reference/library.md has the stack that it takes and the worst
 * times for given work. Cost: 10 to 40 nanoseconds for a pair whose boxes are far apart, 1 to 5
 * microseconds for most others. Errors: ARGUMENT if a value is not finite, if a link comes to lie
 * farther than 2^1000 from the top link of a pair, or if a number of the query is out of range. */
bool sepax_watch_ask(sepax_watch *watch, const double *value, const sepax_machine_query *query,
                     sepax_machine_answer *answer, sepax_error *error);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif
#endif
