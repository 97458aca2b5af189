/* SPDX-License-Identifier: MIT */
/* steps.h - the lines of a path: a value of each joint, and what is said of the way to the line. */
#ifndef CERTIFICATE_STEPS_H
#define CERTIFICATE_STEPS_H

#include "robot.h"

typedef enum { STEP_MOVE, STEP_RAPID, STEP_FEED, STEP_PROBE, STEP_DWELL } step_kind;

typedef struct {
  step_kind kind;   /* of the way to this line */
  const char *tool; /* in the spindle on this way; NULL: none is named */
  bool begins;      /* there is no way to this line from the line before */
  double deviation; /* m: how far points may be from where the linear way has them */
} step;

typedef struct {
  int lines, joints;
  long double *value; /* lines x joints; m and rad */
  step *step;         /* one for each line */
} steps;

/* CSV whose header names joints, with units in brackets, or what is said of the way. */
steps steps_read(const char *file, const robot *r, files *f);

extern const char *const step_kind_names[STEP_DWELL + 1];

/* false: there is no kind of that name */
bool step_kind_named(const char *name, step_kind *kind);

static inline const long double *steps_line(const steps *s, int line) {
  return s->value + (size_t)line * (size_t)s->joints;
}

#endif
