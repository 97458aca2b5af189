/* SPDX-License-Identifier: MIT */
/* guard.h - the guard without its control: joints of one servo period in, the signals that slow or
 * stop the machine out. sepax_guard.c connects it with LinuxCNC. Nothing here knows of HAL, so that
 * tests run it without a control.
 *
 * What is proved. In each period the guard knows a box of joint values: all values that the control
 * can still reach if the stop is raised `reaction` periods later, braking included. While the guard
 * lets the machine move, the bodies of each pair are farther apart than the clearance in the whole
 * box. When this is not proved, it stops the machine, which then comes to rest within the box of
 * the period before. guard_reach has the bounds and what they take for granted.
 *
 * A program that was certified before needs none of this while the joints are in its tube (tube.h):
 * the bodies are farther apart than the clearance wherever they are in it. The guard takes for
 * granted that the control goes on in the tube. As soon as it does not, all of the above holds
 * again, though perhaps too late for what has come near at speed.
 */
#ifndef GUARD_H
#define GUARD_H

#include "sepax_robot.h"
#include "tube.h"

enum {
  GUARD_JOINTS_MOST = TUBE_JOINTS_MOST,
  GUARD_TOOLS_MOST = 16,
  GUARD_TEXT = 640,
  GUARD_WORK = 1000
};

typedef enum {
  GUARD_BLIND, /* not homed: positions mean nothing. Motion is stopped, homing is not touched */
  GUARD_FREE,
  GUARD_SLOW,   /* nearer than the slow zone */
  GUARD_STOPPED /* latched until the operator resets */
} guard_state;

typedef enum {
  GUARD_NO_REASON,
  GUARD_IS_NEAR,      /* two bodies come within the clearance at these values */
  GUARD_MAY_BE_NEAR,  /* they may within the way that braking takes, or the work ended */
  GUARD_NOT_HOMED,    /* not latched */
  GUARD_NOT_A_NUMBER, /* a position, velocity, limit or the period is not finite or not positive */
  GUARD_TOOL,         /* no machine was loaded for the tool in the spindle */
  GUARD_JUMP,         /* a joint moved farther than its velocity says: a missed period */
  GUARD_QUERY,        /* the query was refused */
  GUARD_LEFT_TUBE     /* the program went another way than the certified one, near bodies */
} guard_reason;

typedef struct {
  size_t joints;                       /* of the control, 1 ... GUARD_JOINTS_MOST */
  char axis[GUARD_JOINTS_MOST];        /* letter of the axis that each joint is: XYZABCUVW */
  const char *name[GUARD_JOINTS_MOST]; /* of the joint in the URDF that it moves */
  double unit;       /* metres in the control's unit of length. Its unit of angles is the degree */
  double clearance;  /* > 0, metres */
  double slow_zone;  /* >= 0, metres beyond the clearance */
  double slow_scale; /* feed in the slow zone, above 0, at most 1 */
  double reaction;   /* >= 4, servo periods from a verdict to the first period that brakes */
  double brake;  /* share of the acceleration with which coordinated motion certainly brakes, above
                    0,  at most 1 */
  uint64_t work; /* units of work (sepax_watch_ask) of one query. A period has at most two */
} guard_settings;

/* One period. Lengths and angles in the control's units. */
typedef struct {
  double position[GUARD_JOINTS_MOST];     /* commanded */
  double velocity[GUARD_JOINTS_MOST];     /* commanded, a second */
  double acceleration[GUARD_JOINTS_MOST]; /* the least of the limits that hold for this joint */
  double fastest[GUARD_JOINTS_MOST];      /* the greatest velocity that the control commands */
  double speed;                           /* of the path, as the planner says it; 0 while jogging */
  double period;                          /* seconds */
  bool coordinated;                       /* a program or MDI may move; otherwise jogs */
  bool homed;
  bool reset; /* a rising edge resets */
  long tool;  /* in the spindle */
} guard_input;

typedef struct {
  guard_state state;
  guard_reason reason; /* why it stopped; stays until the reset */
  double feed_scale;
  bool feed_inhibit, jog_stop;
  size_t nearest[2];  /* numbers of links; SEPAX_NO_PAIR if none was measured */
  double least, most; /* the least distance of any pair lies between them; the control's units. At
                         the commanded position of one of the last 8 periods; of a stopped machine
                         the one over the whole box of guard_reach */
  bool in_tube; /* the program is in its tube: no body was compared, and least is its clearance */
  uint64_t work;
} guard_output;

typedef struct guard guard;

/* The files of one tool. */
typedef struct {
  long tool;               /* its number; -1: any */
  const char *urdf, *srdf; /* srdf may be NULL */
} guard_tool;

/* Read the machines, one for each tool, and take all the memory of the guard. Not for a real-time
 * thread. On failure NULL, and one line of why in text[GUARD_TEXT]. */
guard *guard_new(const guard_settings *settings, const guard_tool *tool, size_t tools, char *text);
void guard_free(guard *g);

/* From now on programs and MDI may move in this tube; NULL: in none. The guard keeps the pointer.
 */
void guard_use_tube(guard *g, const tube *t);

/* Fill in the first part of a tube of this guard, with room for `rows`: tube_size bytes, all 0. */
void guard_begin_tube(const guard *g, tube *t, uint64_t rows);

/* Judge one period. Real time: no allocation, lock, file or clock; at most two queries of
 * `work` units. */
void guard_step(guard *g, const guard_input *in, guard_output *out);

/* The joints lie within low ... high, relative to the commanded position, until they rest if the
 * stop comes `reaction` periods later. Control's units. Let d = reaction * period, a_j the limit of
 * acceleration of joint j, v_j its velocity.
 *
 * Jogs. Each joint moves by itself and brakes with a_j without turning round. Its velocity when it
 * begins to brake is at most w = v_j + a_j d, and it moves at most w d before and w^2 / (2 a_j)
 * while it brakes. If w is not positive, then it does not move that way. Other direction likewise.
 *
 * Coordinated motion. The planner brakes along the path, whose direction may change. Let V be the
 * speed of the path, that is, the sum of the speeds of the segments that it blends, and A the least
 * a_j of the axes X, Y, Z. V grows by at most |(a_x, a_y, a_z)| d. From then on no segment speeds
 * up. A straight segment brakes with the acceleration that gives one of its axes its a_j; blending
 * and arcs leave it the share `brake`. So braking takes at most T = max(V / A, w_j / a_j) / brake,
 * with w_j the fastest of each other axis j. None of X, Y, Z moves farther than V d + V T / 2,
 * another axis no farther than w_j d + w_j T / 2: of two segments that are blended, one may turn it
 * forward and the other backward, so its velocity does not say more. But if it rested also in the
 * period before, then no segment turns it yet, and it may only begin to: w_j = a_j d, and it brakes
 * with brake a_j. `before`: the velocities then, or NULL. */
void guard_reach(const guard_settings *s, const guard_input *in, const double *before,
                 double low[GUARD_JOINTS_MOST], double high[GUARD_JOINTS_MOST]);

const char *guard_reason_text(guard_reason reason);

/* Name of a link of the first tool's machine, or "". */
const char *guard_link_name(const guard *g, size_t link);

#endif
