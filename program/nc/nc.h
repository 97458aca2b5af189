/* SPDX-License-Identifier: MIT */
/* nc.h - from a program's canonical motion to rows of joint values.
 *
 * Between two rows the machine's joints do not move linearly: an arc is curved, and a straight
 * motion of the axes is curved in the joints if the kinematics turn. Rows are so dense that each
 * true position of the joints during a motion has a point of the straight line between the two
 * rows that differs in joint j by at most deviation[j].
 *
 * The bound, for one joint and one piece of a way from t0 to t1. Let f(t) be the joint's true
 * value, M a bound of |f''| in t0 ... t1 and h = t1 - t0. The line through (t0, f(t0)) and (t1,
 * f(t1)) differs from f by at most M h^2 / 8. The rows have rounded values, so the line between the
 * rows differs from the former line by at most the larger of the two differences at its ends. M and
 * these differences come from intervals that are rounded outwards (interval.h). On arcs whose
 * radius changes there is a third term: way.h's slip, times a bound of the joint's derivatives by
 * the axes that slip. A piece is divided until the first term is within the tolerance.
 *
 * What is taken for granted: the control moves as way.h says, without the rounding of its own
 * doubles (about 1e-12 mm), and the drives follow. LinuxCNC smooths each joint: what it commands is
 * (p + 4 q + r) / 6 of the joint's positions p, q, r in three servo periods. So a commanded joint
 * differs from the way by at most a sixth of its acceleration times the period squared. The stream
 * tells the period and the greatest acceleration of each axis, and twice that acceleration is
 * taken, because parts of two motions add up. If joints are not axes, they may accelerate faster
 * than axes do; 1 um and 10 urad, which are 6 m/s^2 and 60 rad/s^2 for 1 ms, are then taken if they
 * are more, and also where the stream does not tell. nc_rules.servo_linear and servo_angular take
 * the place of all this; blending[j] has the bounds for joints that move.
 *
 * Blending. At the corner c between two motions the control may start the second before the first
 * has ended. LinuxCNC adds the parts: the position of the axes is c - a(t) + b(t), with a(t) what
 * is left of the first motion and b(t) what is done of the second. a shrinks while b grows, each
 * along the whole way of its motion at most, and all axes share them. "The actual path will be no
 * more than P away from the programmed endpoint" (G64 P) is taken as: at one moment of the blend X,
 * Y, Z are within P of the corner. Lines may also be merged within Q of their points before they
 * are blended; the record has E = P + Q. blending[j] then bounds, for the rows of both motions, how
 * far joint j may be from the nearest true position without blending; it is to be added to
 * deviation[j]. blend.h derives it. Without P it is finite, too, because both motions are: the
 * position is in a parallelogram, of which the speeds and accelerations of the axes leave a part.
 */
#ifndef SEPAX_NC_H
#define SEPAX_NC_H

#include "nc/canon.h"

/* Why the path begins anew in a row: the way from the row before is not known. */
typedef enum {
  NC_GOES_ON,   /* it does not begin anew */
  NC_FIRST,     /* first row of the program */
  NC_LOADED,    /* a tool was changed */
  NC_PROBED,    /* the motion before was a probe, which may have ended anywhere on its way */
  NC_DISPLACED, /* the tool offset changed while the kinematics depend on it: the joints jump */
} nc_break;

/* A row, and the motion that ends in it. */
typedef struct {
  nc_kind kind;
  int file;    /* for nc_program_file */
  size_t line; /* 0: not known */
  int tool;    /* in the spindle; -1: not known, before the first `load` */
  nc_break begins;
  nc_blend blend; /* how the control may pass over the ends of this motion */
  double within;  /* m; of NC_WITHIN */
  bool spindle;   /* it turns */
  bool dogleg;    /* each joint may go there at its own speed */
  double share;   /* of the program's motion that is done in this row: 0 ... 1 */
} nc_row;

typedef struct {
  double linear, angular; /* tolerances in m and rad; 0: 1e-6 */
  double servo_linear;    /* by smoothing, m; 0: as said above; below 0: none */
  double servo_angular;   /* by smoothing, rad; 0: as said above; below 0: none */
  bool dogleg;            /* rapids are dog-legs: mark their rows */
  bool ignore_limits;     /* accept joints beyond their limits */
} nc_rules;

typedef struct {
  nc_program program; /* tools, files, joints and all records */
  nc_row *row;
  double *value;     /* value[n * joints + j]: joint j in row n, m or rad */
  double *deviation; /* deviation[n * joints + j]: of the motion that ends in row n, m or rad */
  double *blending;  /* blending[n * joints + j]: besides, by blending and smoothing */
  double smoothing[NC_JOINTS_MOST]; /* the part of blending by smoothing, of a joint that moves */
  size_t rows, joints;
} nc_motion;

/* The rows of a stream. `name` stands for the stream in messages; `rules` may be NULL. Refused
 * besides what nc_program_read refuses: unknown kinematics; a program without motion; a joint
 * beyond its limits by more than 1e-9 m or rad, in a row or between two rows; a tolerance below
 * 1e-12; more than 2^24 rows. Messages name the program's file and line where there is one. Cost:
 * about 5 us a row. After a failure *motion is zero. */
bool nc_motion_read(nc_motion *motion, FILE *stream, const char *name, const nc_rules *rules,
                    sepax_error *error);
void nc_motion_free(nc_motion *motion);

#endif
