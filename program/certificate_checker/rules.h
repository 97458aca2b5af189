/* SPDX-License-Identifier: MIT */
/* rules.h - links that may meet in motions of a kind. */
#ifndef CERTIFICATE_RULES_H
#define CERTIFICATE_RULES_H

#include "robot.h"
#include "steps.h"

typedef struct {
  int a, b; /* links */
  step_kind kind;
} rule;

typedef struct {
  rule *entry;
  int count;
} rules;

/* CSV whose first line is a,b,kind. file may be NULL: no rules. */
rules rules_read(const char *file, const robot *r, files *f);

bool rules_may_meet(const rules *all, int a, int b, step_kind kind);

#endif
