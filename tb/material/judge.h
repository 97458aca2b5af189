/* SPDX-License-Identifier: MIT */
/* judge.h - the library's answers about a body and a point, against the linear algebra. */
#ifndef MATERIAL_JUDGE_H
#define MATERIAL_JUDGE_H

#include "parts.h"
#include "place.h"
#include "surfaces.h"

typedef enum {
  OUTSIDE, /* no closed surface encloses the point */
  CAVITY,  /* OUTSIDE in a cavity */
  INSIDE,
  UNKNOWN, /* and the rule says so, too */
  LOST,    /* UNKNOWN although the rule tells more */
  REFUSED, /* OUTSIDE, and sepax-certificate-check does not prove it */
  WRONG,
  OUTCOMES
} outcome;

typedef struct {
  outcome is;
  const char *why; /* of LOST and WRONG, else NULL */
} judgement;

/* A body, and what is known about it. */
typedef struct {
  const body *b; /* its soup, and the solids of which it is the union, if known */
  placing where;
  surfaces found;
  division parts;
  sepax_body *solid;
  sepax_shell shell;
  struct checker_body *checked; /* the same body, for the checker */
} subject;

/* Ends the program if the library fails. */
void open_subject(subject *s, const body *b, const placing *where);
void close_subject(subject *s);

/* Are the fields of the shell right? OUTSIDE if they are. */
judgement judge_shell(const subject *s);

/* Is the probe at p inside? It must be free. */
judgement judge_point(const subject *s, point p);

/* Write the body and the probe at p as STL. */
void write_subject(const subject *s, point p, const char *prefix);

#endif
