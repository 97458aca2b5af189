/* SPDX-License-Identifier: MIT */
/* rules.h - links that may meet in motions of a kind. */
#ifndef CERTIFICATE_RULES_H
#define CERTIFICATE_RULES_H

#include "robot.h"
#include "steps.h"

typedef struct {
  char *a, *b; /* names of links, or roles of parts of tools */
  step_kind kind;
} rule;

typedef struct {
  rule *entry;
  int count;
} rules;

/* CSV whose first line is a,b,kind. file may be NULL: no rules. */
rules rules_read(const char *file, const robot *r, files *f);

bool rules_may_meet(const rules *all, const robot *r, int a, int b, step_kind kind);

#endif
