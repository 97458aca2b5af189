/* SPDX-License-Identifier: MIT */
/* tube.h - where the joints of a certified program may be, as `sepax path --tube` writes it, in
 * memory that a program beside the control fills and the guard reads. docs/reference/tube.md has
 * the format of the file and what is proved.
 *
 * The joints are inside if for some motion of the tube, with joint values a at its start and b at
 * its end, there is one t in 0 ... 1 such that each joint is within its `off` of a + t (b - a). The
 * program is certified for all these positions.
 *
 * Besides, each joint must be slow enough. Along the tube a joint turns back only at some values.
 * It must be able to stop, with its limit of acceleration, at the next of them, or at most `off`
 * behind it: a control that follows the tube does so. This finds a program that goes deeper than
 * the certified one while there is still a way to brake. */
#ifndef GUARD_TUBE_H
#define GUARD_TUBE_H

#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { TUBE_JOINTS_MOST = 9, TUBE_NAME = 64, TUBE_TEXT = 640, TUBE_ROWS_MOST = 10000000 };
enum { TUBE_MAGIC = 0x53585431, TUBE_KEY = 0x53585442 /* of the shared memory */ };

/* A row is an array of numbers. It begins with the tool in the spindle (-1: any) and with whether
 * the path begins anew in it. From TUBE_FIRST on, each joint has TUBE_VALUES numbers: its value at
 * the end of the motion, how far it may be off, and the least and greatest value between the places
 * where it turns back before and after. */
enum { TUBE_TOOL, TUBE_BEGINS, TUBE_FIRST };
enum { TUBE_END, TUBE_OFF, TUBE_LOW, TUBE_HIGH, TUBE_VALUES };

/* For the memory that is shared: no pointers. The guard fills in the first part and never changes
 * it; the rest is written by tube_read while `serial` is odd. */
typedef struct {
  uint32_t magic, joints;
  uint64_t most;                          /* rows that there is room for */
  double clearance;                       /* of the guard, metres */
  double scale[TUBE_JOINTS_MOST];         /* metres or radians in the control's unit */
  char name[TUBE_JOINTS_MOST][TUBE_NAME]; /* of the joint in the URDF */
  _Atomic uint64_t serial;
  uint64_t rows;  /* 0: there is no tube */
  double free_of; /* clearance of the tube, metres */
  double value[]; /* tube_stride numbers for each row, in the control's units */
} tube;

/* Where the guard is in the tube. */
typedef struct {
  uint64_t serial; /* of the tube that `row` belongs to */
  uint64_t row, search;
  bool inside;
} tube_place;

size_t tube_stride(size_t joints);              /* numbers of a row */
size_t tube_size(size_t joints, uint64_t rows); /* bytes */

/* Real time: are the joints inside? At most 200 rows are compared. Control's units; tool: in the
 * spindle; period: seconds. `acceleration`: limit of each joint. */
bool tube_inside(const tube *t, tube_place *place, const double *position, const double *velocity,
                 const double *acceleration, long tool, double period);

/* Read a file of sepax path into t, whose first part is there. Not for real time. On failure the
 * tube is empty, and text[TUBE_TEXT] has one line of why. */
bool tube_read(tube *t, const char *path, char *text);

/* No tube from now on. */
void tube_clear(tube *t);

#endif
