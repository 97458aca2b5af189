/* SPDX-License-Identifier: MIT */
/* rows.h - lists of rows and of the motions that they belong to (private to program/nc). */
#ifndef SEPAX_NC_ROWS_H
#define SEPAX_NC_ROWS_H

#include "nc/kinematics.h"
#include "nc/nc.h"
#include "nc/way.h"

/* A motion that goes somewhere, and has a known beginning. */
typedef struct {
  size_t record; /* of the program */
  double from[NC_AXES];
  size_t first, end; /* its rows: first ... end - 1 */
  size_t state;      /* kinematics in force */
  nc_blend blend;
  double within; /* mm */
  bool joined;   /* the control may blend it with the motion before in the list */
} nc_part;

typedef struct {
  const char *name; /* of the stream */
  nc_rules rules;   /* with all tolerances */
  nc_motion *motion;
  sepax_error *error;
  size_t row_capacity, value_capacity, deviation_capacity;
  nc_part *part;
  size_t parts, part_capacity;
  nc_kinematics *state; /* state[states - 1] is in force */
  size_t states, state_capacity;
  double least[NC_JOINTS_MOST], most[NC_JOINTS_MOST]; /* limits in m or rad */
} nc_rows;

/* Begin with a program that is read, and its kinematics; end, which keeps the rows. */
bool nc_rows_begin(nc_rows *r);
void nc_rows_end(nc_rows *r);

/* Write "FILE:LINE: ..." of the record, and return false. */
bool nc_rows_refuse(const nc_rows *r, const nc_record *record, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Add a row with values in m or rad and deviations of the motion from the row before; NULL: zero.
 * `row` says all else. Refused if a joint is beyond its limits. */
bool nc_rows_add(nc_rows *r, const nc_row *row, const nc_record *record, const double *value,
                 const double *deviation);

/* Add a motion, and kinematics in force from now on. */
bool nc_rows_part(nc_rows *r, const nc_part *part);
bool nc_rows_state(nc_rows *r, const nc_kinematics *k);

/* Fill in blending[] of all rows. Cost: one evaluation of the kinematics for each motion. */
bool nc_rows_blend(nc_rows *r);

#endif
