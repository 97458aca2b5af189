/* SPDX-License-Identifier: MIT */
/* parts.h - what the parts of sepax check share: command.c reads what is asked, bodies.c answers
 * for the bodies as the files have them, grid.c for a design on its grid, output.c prints. */
#ifndef SEPAX_CHECK_PARTS_H
#define SEPAX_CHECK_PARTS_H

#include "cli/meshes.h"
#include "cli/question.h"

typedef struct {
  const char *path[2];
  const char *poses_path, *pairs_path, *ply_path; /* files of the options, or NULL */
  report_bands bands;                             /* mm */
  cli_meshes meshes;
  cli_output output;
  bool on_grid, first, surfaces;
  bool nearest; /* --nearest-rotation */
  int threads;
  sepax_config config; /* design of --grid, without clearances */
  cli_grid grid;
} check_question;

/* The answer for one pose. If nobody sees the pairs of a list, then they are only counted and
 * `pair` is NULL. */
typedef struct {
  report_verdict verdict;
  sepax_pairs colliding, undecided, warned;
  bool within_asked;
  sepax_inside within[2]; /* [0]: is a part of A inside B; [1]: is a part of B inside A */
  sepax_within_reason why[2];
} check_answer;

/* What is known of the surface of a body. */
typedef struct {
  bool closed, consistent; /* as in sepax_shell */
  size_t facet;            /* a facet that shows why one of the two is false */
} check_surface;

typedef struct {
  size_t triangles[2];
  report_mesh file[2];
  check_surface surface[2];
  sepax_soup mesh[2];   /* meshes for --ply */
  sepax_grid grid;      /* with --grid: the grid */
  report_steps steps;   /* with --grid: the clearances */
  check_answer *answer; /* one, or one for each pose */
  size_t answers;
  double moved; /* with `nearest`: the largest change of a matrix entry */
  double seconds;
} check_report;

/* Answer for the bodies as the files have them. After false the report can be freed. */
bool check_bodies(const check_question *q, check_report *report, sepax_error *error);
bool check_on_grid(const check_question *q, check_report *report, sepax_error *error);
void check_report_free(check_report *report);

/* True if neither the pairs nor their number are printed or written, so one pair is enough. */
bool check_any_is_enough(const check_question *q);
report_verdict check_worst(const check_report *report);

void check_print_text(const check_question *q, const check_report *report);
void check_print_json(const check_question *q, const check_report *report);
bool check_write_files(const check_question *q, const check_report *report, sepax_error *error);

#endif
