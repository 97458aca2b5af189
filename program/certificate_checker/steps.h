/* SPDX-License-Identifier: MIT */
/* steps.h - the lines of a path: a value of each joint, and what is said of the way to the line. */
#ifndef CERTIFICATE_STEPS_H
#define CERTIFICATE_STEPS_H

#include "robot.h"

typedef struct {
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

static inline const long double *steps_line(const steps *s, int line) {
  return s->value + (size_t)line * (size_t)s->joints;
}

#endif
