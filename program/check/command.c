/* SPDX-License-Identifier: MIT */
/* command.c - sepax check: reads the options and calls the parts that answer and print. */
#include "check/parts.h"
#include "report/json.h"
#include "command_table.h"
#include "util/error.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The design's options and the grid's options each have an argp of their own, so that the first one
 * that was given can be named if --grid is missing. */
typedef struct {
  const struct argp *of;
  void *input;
  const char **given;
} grid_options;

typedef struct {
  check_question question;
  int paths;
  const char *given; /* the first option given that applies only to --grid */
  grid_options config, grid;
} command;

enum {
  KEY_GRID = 0x380,
  KEY_THREADS,
  KEY_FIRST,
  KEY_PAIRS,
  KEY_PLY,
  KEY_POSES,
  KEY_SURFACES,
  KEY_NEAREST
};

static const struct argp_option options[] = {
    {"poses", KEY_POSES, "FILE", 0,
     "check each pose of B in FILE. A line has 12 numbers: the rotation by rows, then the "
     "translation in mm; # begins a comment",
     0},
    {"nearest-rotation", KEY_NEAREST, NULL, 0,
     "replace each matrix of --poses by the nearest rotation, for matrices with few decimals", 0},
    {"first", KEY_FIRST, NULL, 0, "stop at the first colliding pair of triangles in each pose", 0},
    {"surfaces", KEY_SURFACES, NULL, 0,
     "treat the meshes as surfaces, not solids: do not test whether one body is inside the other",
     0},
    {"pairs", KEY_PAIRS, "FILE", 0,
     "write the colliding pairs to FILE as CSV, not to standard output", 0},
    {"ply", KEY_PLY, "FILE", 0,
     "write both meshes to FILE as PLY, with the colliding triangles in colour", 0},
    {"threads", KEY_THREADS, "N", 0,
     "number of threads for --poses, and for --grid with --arch=exact (default: one for each "
     "processor)",
     0},
    {"grid", KEY_GRID, NULL, 0,
     "say what hardware would say: round the meshes to integers and judge them with a design "
     "(design options below)",
     0},
    {0}};

/* ------------------------------------------------------------ options of the grid */

static const char *name_of(const struct argp_option *option, int key) {
  for (; option->name != NULL || option->doc != NULL; option++) {
    if (option->key == key) {
      return option->name;
    }
  }
  return "";
}

static error_t parse_grid_option(int key, char *text, struct argp_state *state) {
  grid_options *g = state->input;
  state->input = g->input;
  error_t error = g->of->parser(key, text, state);
  state->input = g;
  if (error == 0 && key > ARGP_KEY_ARG && key < ARGP_KEY_END && *g->given == NULL) {
    *g->given = name_of(g->of->options, key);
  }
  return error;
}

/* The options of a design without --clearance and --warning, which are lengths in sepax check. */
static const struct argp_option *design_options(void) {
  static struct argp_option shown[80];
  enum { MOST = sizeof shown / sizeof shown[0] - 1 };
  int used = 0;
  shown[used++] = (struct argp_option){.doc = "Only with --grid:", .group = 1};
  for (const struct argp_option *o = cli_verdict_argp.options;
       (o->name != NULL || o->doc != NULL) && used < MOST; o++) {
    bool length =
        o->name != NULL && (strcmp(o->name, "clearance") == 0 || strcmp(o->name, "warning") == 0);
    if (!length) {
      shown[used++] = *o;
    }
  }
  return shown;
}

/* ------------------------------------------------------------------------ parsing */

static void end_of_options(command *c, struct argp_state *state) {
  if (c->paths != 2) {
    argp_error(state, "give two mesh files");
  }
  if (c->given != NULL && !c->question.on_grid) {
    argp_error(state, "%s: applies only to --grid; give --grid, too, or leave it out", c->given);
  }
}

static error_t parse_argument(command *c, char *text, struct argp_state *state) {
  if (c->paths == 2) {
    argp_error(state, "unexpected argument '%s': give two mesh files", text);
  }
  c->question.path[c->paths++] = text;
  return 0;
}

static error_t parse(int key, char *text, struct argp_state *state) {
  command *c = state->input;
  check_question *q = &c->question;
  switch (key) {
  case ARGP_KEY_INIT:
    state->child_inputs[0] = &c->config;
    state->child_inputs[1] = &c->grid;
    state->child_inputs[2] = &q->bands;
    state->child_inputs[3] = &q->output;
    state->child_inputs[4] = &q->meshes;
    return 0;
  case KEY_GRID:
    q->on_grid = true;
    return 0;
  case KEY_FIRST:
    q->first = true;
    return 0;
  case KEY_SURFACES:
    q->surfaces = true;
    return 0;
  case KEY_POSES:
    q->poses_path = text;
    return 0;
  case KEY_NEAREST:
    q->nearest = true;
    return 0;
  case KEY_PAIRS:
    q->pairs_path = text;
    return 0;
  case KEY_PLY:
    q->ply_path = text;
    return 0;
  case KEY_THREADS:
    q->threads = (int)cli_count(state, "threads", text, 0, CLI_THREADS_MOST);
    return 0;
  case ARGP_KEY_ARG:
    return parse_argument(c, text, state);
  case ARGP_KEY_END:
    end_of_options(c, state);
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

/* ------------------------------------------------------- checks that need no mesh */

static bool outputs_allowed(const check_question *q, sepax_error *error) {
  const char *const outputs[] = {q->pairs_path, q->ply_path};
  const char *const inputs[] = {q->path[0], q->path[1], q->poses_path};
  return cli_outputs_allowed(outputs, 2, inputs, 3, error);
}

static bool options_agree(const check_question *q, sepax_error *error) {
  if (q->surfaces && q->on_grid) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "surfaces: with --grid the inside of a body is never tested; leave it out");
  }
  if (q->poses_path != NULL && q->on_grid) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "poses: on a grid no body can be turned exactly; leave out --grid, or "
                      "--poses");
  }
  if (q->nearest && q->poses_path == NULL) {
    return sepax_fail(
        error, SEPAX_ERROR_ARGUMENT,
        "nearest-rotation: applies only to --poses; give --poses, too, or leave it out");
  }
  if (q->poses_path != NULL && q->ply_path != NULL) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "ply: a picture shows one pose; leave out --poses, or --ply");
  }
  return cli_question_agrees(&q->output, &q->bands, error);
}

static bool grid_options_agree(const check_question *q, sepax_error *error) {
  const sepax_config *config = &q->config;
  sepax_design design;
  if (q->grid.file_normals && config->arch != SEPAX_ARCH_PAPER &&
      config->arch != SEPAX_ARCH_CONFERENCE) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "normals: architecture %s reads no normals; give --arch=paper, too",
                      sepax_arch_name(config->arch));
  }
  if (!sepax_design_init(&design, config, error) || q->bands.clearance.text == NULL) {
    return q->bands.clearance.text == NULL && error->code == SEPAX_OK;
  }
  if (config->arch != SEPAX_ARCH_EXACT) {
    return sepax_fail(
        error, SEPAX_ERROR_ARGUMENT,
        "clearance: architecture %s has no clearance; leave it out, or give --arch=exact",
        sepax_arch_name(config->arch));
  }
  if (config->extent_a != 0 || config->extent_b != 0) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "clearance: cannot be combined with extents; leave one of them out");
  }
  if (q->first) {
    return sepax_fail(
        error, SEPAX_ERROR_ARGUMENT,
        "first: with --grid and --clearance all pairs are counted; leave out --first, or "
        "--clearance");
  }
  return true;
}

int cli_check(int argc, char **argv) {
  const struct argp design = {.options = design_options(), .parser = parse_grid_option};
  const struct argp rounding = {.options = cli_grid_argp.options, .parser = parse_grid_option};
  const struct argp_child children[] = {
      {&design, 0, NULL, 0},          {&rounding, 0, NULL, 0},        {&cli_bands_argp, 0, NULL, 0},
      {&cli_output_argp, 0, NULL, 0}, {&cli_meshes_argp, 0, NULL, 0}, {0}};
  const struct argp argp = {
      options,
      parse,
      "A B",
      "Tell whether two bodies collide, and which of their triangles do. A and B are mesh files: "
      "STL, OBJ, PLY, 3MF or DAE. The answer is exact for the coordinates in the files. A body "
      "inside a closed body collides, too. Triangles and poses are numbered from 0.\v"
      "Exit status: 0 free, 1 collision, 2 error, 3 warning, 4 undecided.",
      children,
      NULL,
      NULL};
  command c = {.question = {.config = sepax_config_default(),
                            .bands.unit = CLI_MILLIMETRES,
                            .meshes.unit = CLI_MILLIMETRES}};
  check_question *q = &c.question;
  c.config = (grid_options){&cli_verdict_argp, &q->config, &c.given};
  c.grid = (grid_options){&cli_grid_argp, &q->grid, &c.given};
  cli_parse(&argp, argc, argv, &c);
  q->grid.grid.word = q->config.word;
  sepax_error error = {0};
  check_report report = {.answers = 0};
  bool ok = (!q->output.json || report_names_printable(q->path, &error)) &&
            outputs_allowed(q, &error) && options_agree(q, &error) &&
            (!q->on_grid || grid_options_agree(q, &error)) &&
            (q->on_grid ? check_on_grid : check_bodies)(q, &report, &error) &&
            check_write_files(q, &report, &error);
  int result = ok ? report_verdict_status[check_worst(&report)] : cli_fail(argv[0], &error);
  if (ok && !q->output.quiet) {
    (q->output.json ? check_print_json : check_print_text)(q, &report);
  }
  check_report_free(&report);
  return result;
}
