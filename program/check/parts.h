/* parts.h - what the parts of sepax check share: command.c reads what is asked, bodies.c answers
 * for the bodies as the files have them, grid.c for a design on its grid, output.c prints. */
#ifndef SEPAX_CHECK_PARTS_H
#define SEPAX_CHECK_PARTS_H

#include "cli/meshes.h"
#include "cli/question.h"

typedef struct {
  const char *path[2];
  const char *poses_path, *pairs_path, *ply_path; /* or NULL */
  report_bands bands;                             /* mm */
  cli_meshes meshes;
  cli_output output;
  bool on_grid, first, surfaces;
  bool nearest; /* matrices of poses are replaced by the nearest rotations */
  int threads;
  sepax_config config; /* of the grid's design, without clearances */
  cli_grid grid;
} check_question;

/* Of one pose. Lists that nobody prints are counted only: their `pair` is then NULL. */
typedef struct {
  report_verdict verdict;
  sepax_pairs colliding, undecided, warned;
  bool within_asked;
  sepax_inside within[2]; /* is a part of A inside B, of B inside A? */
} check_answer;

/* Of a body as its file has it. */
typedef struct {
  bool closed, consistent; /* as of sepax_shell */
  size_t facet;            /* where one is not so */
} check_surface;

typedef struct {
  size_t triangles[2];
  report_mesh file[2];
  check_surface surface[2];
  sepax_soup mesh[2];   /* what --ply shows */
  sepax_grid grid;      /* on a grid: what was taken */
  report_steps steps;   /* on a grid: the clearances */
  check_answer *answer; /* one, or one for each pose */
  size_t answers;
  double moved; /* the largest change of an entry by `nearest` */
  double seconds;
} check_report;

/* False leaves a report that can be freed. */
bool check_bodies(const check_question *q, check_report *report, sepax_error *error);
bool check_on_grid(const check_question *q, check_report *report, sepax_error *error);
void check_report_free(check_report *report);

/* Nobody sees which pairs there are, nor how many. */
bool check_any_is_enough(const check_question *q);
report_verdict check_worst(const check_report *report);

void check_print_text(const check_question *q, const check_report *report);
void check_print_json(const check_question *q, const check_report *report);
bool check_write_files(const check_question *q, const check_report *report, sepax_error *error);

#endif
