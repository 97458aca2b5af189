/* SPDX-License-Identifier: MIT */
/* steps.h - the lines of a path: a value of each joint. */
#ifndef CERTIFICATE_STEPS_H
#define CERTIFICATE_STEPS_H

#include "robot.h"

typedef struct {
  int lines, joints;
  long double *value; /* lines x joints; m and rad */
} steps;

/* CSV whose header names joints, with units in brackets. */
steps steps_read(const char *file, const robot *r, files *f);

static inline const long double *steps_line(const steps *s, int line) {
  return s->value + (size_t)line * (size_t)s->joints;
}

#endif
