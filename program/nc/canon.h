/* SPDX-License-Identifier: MIT */
/* canon.h - canonical motion: the stream of text that an interpreter of NC programs writes, as
 * records in memory. Units: mm, degrees, seconds.
 *
 * The reader is strict. A record that it does not know, a word too few or too many, a number that
 * is not finite, a record before what it needs and a stream without `end` are refused with the
 * line of the stream. Every record is in the result. */
#ifndef SEPAX_NC_CANON_H
#define SEPAX_NC_CANON_H

#include "sepax.h"

#include <stdio.h>

/* The axes of a position, in this order: X Y Z A B C U V W. */
enum { NC_AXES = 9, NC_JOINTS_MOST = 16, NC_NAME = 64, NC_WORDS_MOST = 8, NC_PARAMETERS_MOST = 32 };
enum { NC_X, NC_Y, NC_Z, NC_A, NC_B, NC_C, NC_U, NC_V, NC_W };

/* The letter of an axis, and the axis of a letter, or -1. */
char nc_letter(int axis);
int nc_axis(char letter);

typedef enum { NC_RAPID, NC_FEED, NC_PROBE, NC_DWELL } nc_kind;

/* How the control passes from one motion to the next: over the programmed point; no farther from
 * it than a length; or without a bound. */
typedef enum { NC_EXACT, NC_WITHIN, NC_UNBOUNDED } nc_blend;

typedef enum {
  NC_DO_MOVE,
  NC_DO_ARC,
  NC_DO_DWELL,
  NC_DO_LOAD,
  NC_DO_LENGTH,
  NC_DO_SPINDLE,
  NC_DO_KINS,
  NC_DO_BLEND,
  NC_DO_NOTE,
  NC_DO_END
} nc_action;

typedef struct {
  nc_action action;
  nc_kind kind;         /* of a move or an arc */
  int file;             /* number of the program's file, or -1 if it is not known */
  size_t line;          /* of that file, from 1; 0 if it is not known */
  double axis[NC_AXES]; /* end of a move or an arc; tool offset of `length`; position of `kins` */
  double centre[3];     /* of an arc, mm */
  double normal[3];     /* of an arc; the motion is counter-clockwise around it */
  int number;           /* turns of an arc, tool of `load`, type of `kins`, 1 or 0 of `spindle` */
  nc_blend blend;
  double within; /* of `blend within`: mm, > 0 */
  double seconds;
  char *text; /* of `note`; otherwise NULL */
} nc_record;

typedef struct {
  char *path;
  int number;
} nc_file;

typedef struct {
  char name[NC_NAME];
  double value;
  bool follows; /* the Z of the tool offset in force is added */
} nc_parameter;

typedef struct {
  int axis; /* that it moves */
  bool angular;
  double least, most;  /* limits in mm or degrees */
  double acceleration; /* its greatest, in mm/s^2 or degrees/s^2; 0: not known */
} nc_joint;

/* Of coordinated motion, in mm or degrees and seconds; 0: not known. */
typedef struct {
  double speed;        /* at most */
  double acceleration; /* that the planner may use */
} nc_limits;

typedef struct {
  int number, pocket;
  double diameter;
  double offset[NC_AXES];
  char *comment; /* may be empty */
} nc_tool;

typedef struct {
  nc_file *file;
  size_t files;
  char machine[NC_WORDS_MOST][NC_NAME]; /* the module of the kinematics and its words */
  size_t machine_words;
  nc_parameter parameter[NC_PARAMETERS_MOST];
  size_t parameters;
  double servo; /* period of the servo loop, s; 0: not known */
  nc_joint joint[NC_JOINTS_MOST];
  size_t joints;
  nc_limits limits[NC_AXES];
  nc_tool *tool;
  size_t tools;
  bool start_given; /* otherwise the machine is taken to start from home */
  double start[NC_AXES];
  nc_record *record; /* the last one is NC_DO_END */
  size_t records;
} nc_program;

/* Read a stream to its end. `name` stands for it in messages. Cost: one pass; memory of 200 bytes a
 * record. Fails as the head of this file says, and without memory; *program is then zero. */
bool nc_program_read(nc_program *program, FILE *stream, const char *name, sepax_error *error);
void nc_program_free(nc_program *program);

/* The path of a file number, or "(a file of unknown name)". */
const char *nc_program_file(const nc_program *program, int number);

#endif
