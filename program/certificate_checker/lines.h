/* SPDX-License-Identifier: MIT */
/* lines.h - a certificate's text: JSON, a value a line. */
#ifndef CERTIFICATE_LINES_H
#define CERTIFICATE_LINES_H

#include "robot.h"

#include <stdint.h>
#include <stdio.h>

/* The finest interval is 2^-LEVELS of a segment. */
enum { LEVELS = 50 };

typedef struct {
  const char *file;
  FILE *in;
  char *line;
  size_t size;
  long long number, intervals;
  const char *urdf, *srdf, *rules, *path; /* srdf, rules: NULL if none */
  double clearance;
  files files;
  const char *(*pair)[2];
  size_t pairs;
  json_t *head; /* the first line */
} certificate;

typedef struct {
  size_t pair;
  int segment, level;
  uint64_t index;
  double bound;
  bool has_axis;
  vec axis;
  char where[32]; /* "line 12" */
} certificate_line;

/* Reads the first line; its packages go behind those that are there. */
certificate certificate_open(const char *file, packages *folders);

/* false: that was the last interval, and as many came as the certificate says. */
bool certificate_next(certificate *c, certificate_line *line);

#endif
