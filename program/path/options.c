/* SPDX-License-Identifier: MIT */
/* options.c - the options of sepax path beside those of its scene, and which go together. */
#include "path/certificate/digest.h"
#include "path/common/parts.h"
#include "report/json.h"
#include "sepax_tree.h"
#include "util/error.h"

#include <string.h>
#include <sys/stat.h>

enum {
  KEY_CSV = 0x400,
  KEY_MOTION,
  KEY_TUBE,
  KEY_LEFT,
  KEY_RULES,
  KEY_WORST,
  KEY_PAGE,
  KEY_JOBS,
  KEY_WORD,
  KEY_LSB,
  KEY_NO_DISTANCE,
  KEY_CERTIFY,
  KEY_CERTIFICATE,
  KEY_RESOLUTION,
  KEY_INTERVALS,
  KEY_SURFACES,
  KEY_THREADS
};

enum { INTERVALS_MOST = 1000000000 };

static const struct argp_option options[] = {
    {"rules", KEY_RULES, "FILE", 0,
     "let links meet in motions of a kind: FILE is CSV with lines such as cutter,stock,feed", 0},
    {"motion", KEY_MOTION, "FILE", 0,
     "write the path of an NC program to FILE as CSV, a motion file that sepax path reads", 0},
    {"tube", KEY_TUBE, "FILE", 0,
     "if the NC program is free, write to FILE where its joints may be, for the guard in "
     "examples/linuxcnc",
     0},
    {"left", KEY_LEFT, "FILE", 0,
     "write what is left of --stock to FILE, for --first: FILE.obj as a mesh in metres, other "
     "names as cells",
     0},
    {"csv", KEY_CSV, "FILE", 0,
     "write to FILE as CSV: for each line of the path, each pair of bodies that is not free in it",
     0},
    {"worst", KEY_WORST, "FILE", 0,
     "write all bodies to FILE as PLY, in the first pose with the worst verdict; if all pairs are "
     "free, in the line where two bodies are nearest",
     0},
    {"page", KEY_PAGE, "FILE", 0,
     "write an HTML page to FILE that shows the bodies and plays the path in a browser", 0},
    {"jobs", KEY_JOBS, "FILE", 0,
     "write all pairs of bodies in all lines to FILE as jobs of the tree engine; with --tools a "
     "list for each tool, FILE with .T3 before its ending",
     0},
    {"word", KEY_WORD, "W", 0, "bits of a coordinate in --jobs, 6 ... 21 (default 18)", 0},
    {"lsb", KEY_LSB, "LENGTH", 0,
     "length of one LSB in --jobs (default: the shortest length at which all coordinates fit "
     "--word)",
     0},
    {"no-distance", KEY_NO_DISTANCE, NULL, 0,
     "find verdicts only, not the least clearance; this is faster", 0},
    {"certify", KEY_CERTIFY, NULL, 0,
     "also check the motion between the lines, where all joints move linearly: prove that each "
     "pair of bodies that collides in no line is free between the lines, too",
     0},
    {"certificate", KEY_CERTIFICATE, "FILE", 0,
     "write the proof of --certify to FILE, for sepax-certificate-check", 0},
    {"resolution", KEY_RESOLUTION, "LENGTH", 0,
     "--certify does not divide motions of LENGTH or less any further (default 1um)", 0},
    {"intervals", KEY_INTERVALS, "N", 0,
     "--certify divides the motion of a pair of bodies into at most N intervals, plus 64 for each "
     "line (default 262144)",
     0},
    {"surfaces", KEY_SURFACES, NULL, 0,
     "treat the meshes as surfaces, not solids: do not test whether one body is inside another", 0},
    {"threads", KEY_THREADS, "N", 0, "number of threads (default: one for each processor)", 0},
    {0}};

static error_t parse_argument(path_question *q, char *text, struct argp_state *state) {
  if (q->motion != NULL) {
    argp_error(state, "unexpected argument '%s': give a URDF and a path", text);
  }
  *(q->urdf == NULL ? &q->urdf : &q->motion) = text;
  return 0;
}

/* The field of an option that is on or off. */
static bool *switch_of(path_question *q, int key) {
  switch (key) {
  case KEY_NO_DISTANCE:
    return &q->no_distance;
  case KEY_CERTIFY:
    return &q->certify;
  case KEY_SURFACES:
    return &q->surfaces;
  default:
    return NULL;
  }
}

/* The field of an option that is a name. */
static const char **name_of(path_question *q, int key) {
  switch (key) {
  case KEY_CERTIFICATE:
    return &q->certificate;
  case KEY_RULES:
    return &q->table;
  case KEY_LEFT:
    return &q->left;
  case KEY_MOTION:
    return &q->written;
  case KEY_TUBE:
    return &q->tube;
  case KEY_CSV:
    return &q->csv;
  case KEY_WORST:
    return &q->picture;
  case KEY_PAGE:
    return &q->page;
  case KEY_JOBS:
    return &q->jobs;
  default:
    return NULL;
  }
}

static error_t parse(int key, char *text, struct argp_state *state) {
  path_question *q = state->input;
  bool *on = switch_of(q, key);
  if (on != NULL) {
    *on = true;
    return 0;
  }
  const char **name = name_of(q, key);
  if (name != NULL) {
    *name = text;
    return 0;
  }
  switch (key) {
  case ARGP_KEY_INIT:
    state->child_inputs[0] = q;
    state->child_inputs[1] = &q->output;
    return 0;
  case KEY_RESOLUTION:
    q->resolution = cli_limit(state, "resolution", text, CLI_METRES);
    return 0;
  case KEY_INTERVALS:
    q->intervals = (size_t)cli_count(state, "intervals", text, 1, INTERVALS_MOST);
    return 0;
  case KEY_WORD:
    q->word = (int)cli_count(state, "word", text, PATH_WORD_MIN, SEPAX_TREE_WORD_MAX);
    return 0;
  case KEY_LSB:
    q->lsb = cli_limit(state, "lsb", text, CLI_METRES);
    if (q->lsb.length <= 0) {
      argp_error(state, "lsb: %s is not above 0", text);
    }
    return 0;
  case KEY_THREADS:
    q->threads = (int)cli_count(state, "threads", text, 0, CLI_THREADS_MOST);
    return 0;
  case ARGP_KEY_ARG:
    return parse_argument(q, text, state);
  case ARGP_KEY_END:
    if (q->motion == NULL) {
      argp_error(state, "give a URDF and a path: a CSV file, or an NC program with --machine");
    }
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

void path_parse(path_question *q, int argc, char **argv) {
  static const struct argp_child children[] = {
      {&path_scene_argp, 0, NULL, 0}, {&cli_output_argp, 0, NULL, 0}, {0}};
  static const struct argp argp = {
      options,
      parse,
      "ROBOT.urdf PATH.csv\n--machine=MACHINE.ini ROBOT.urdf PROGRAM.ngc",
      "Tell which bodies of a machine collide on a path, and in which line of the path each pair "
      "of bodies first collides. Of the pairs that do not collide, tell how near they come. The "
      "bodies are the collision geometry of the links in the URDF file. The header of the CSV file "
      "names joints, and each line has their values. The verdict is exact for the pose of each "
      "line. Only --certify checks the motion between the lines; programs always are.\v"
      "Exit status: 0 free, 1 collision, 2 error, 3 warning, 4 undecided.",
      children,
      NULL,
      NULL};
  *q = (path_question){.resolution = {NULL, 1e-6}};
  cli_parse(&argp, argc, argv, q);
}

/* ---------------------------------------------------------------- which go together */

static bool has_ending(const char *name, const char *ending) {
  size_t length = strlen(name);
  return length > strlen(ending) && strcmp(name + length - strlen(ending), ending) == 0;
}

/* Do the options of an NC program agree with the files? */
static bool program_agrees(const path_question *q, sepax_error *error) {
  static const char *const endings[] = {".ngc", ".nc", ".tap", ".gcode", ".NGC", ".NC"};
  const char *first = q->tool_table != NULL       ? "tool-table"
                      : q->axes > 0               ? "axis"
                      : q->controls > 0           ? "control"
                      : q->dogleg                 ? "rapids"
                      : q->blended                ? "blended"
                      : q->deviation.text != NULL ? "deviation"
                      : q->written != NULL        ? "motion"
                      : q->tube != NULL           ? "tube"
                      : q->start != NULL          ? "start"
                      : q->smoothing.text != NULL ? "smoothing"
                      : q->loaded >= 0            ? "loaded"
                                                  : NULL;
  if (q->machine == NULL && first != NULL) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "%s: applies only to an NC program; give --machine, too, or leave it out",
                      first);
  }
  for (size_t n = 0; q->machine == NULL && n < sizeof endings / sizeof *endings; n++) {
    if (has_ending(q->motion, endings[n])) {
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "%.300s: is an NC program; give --machine=FILE.ini, the configuration of "
                        "its machine",
                        q->motion);
    }
  }
  const char *of_tools = q->stock != NULL        ? "stock"
                         : q->part != NULL       ? "part"
                         : q->gouge.text != NULL ? "gouge"
                                                 : NULL;
  if (q->tools == NULL && of_tools != NULL) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "%s: applies only to tools; give --tools, too, or leave it out", of_tools);
  }
  if (q->stock != NULL && q->part != NULL && strcmp(q->stock, q->part) == 0) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "part: %.60s is the stock, too; give the finished part as a link of its own",
                      q->part);
  }
  const char *of_stock = q->first != NULL        ? "first"
                         : q->left != NULL       ? "left"
                         : q->cell.text != NULL  ? "cells"
                         : q->depth.text != NULL ? "depth"
                                                 : NULL;
  if (q->stock == NULL && of_stock != NULL) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "%s: applies only to --stock; give --stock, too, or leave it out", of_stock);
  }
  return q->machine == NULL || q->certificate == NULL || q->written != NULL ||
         sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                    "certificate: of an NC program needs --motion=FILE, because the certificate is "
                    "about the motion file");
}

bool path_options_agree(const path_question *q, sepax_error *error) {
  if (!cli_question_agrees(&q->output, &q->bands, error)) {
    return false;
  }
  if (!program_agrees(q, error)) {
    return false;
  }
  if (!q->certify && (q->certificate != NULL || q->resolution.text != NULL || q->intervals != 0)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "%s: applies only to --certify; give --certify, too, or leave it out",
                      q->certificate != NULL       ? "certificate"
                      : q->resolution.text != NULL ? "resolution"
                                                   : "intervals");
  }
  if (q->certificate != NULL && (q->meshes.weld.text != NULL || q->meshes.own.text != NULL)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "certificate: not with --%s, because its checker reads meshes as they are; "
                      "%s",
                      q->meshes.weld.text != NULL ? "weld" : "unit",
                      q->meshes.weld.text != NULL ? "write the welded mesh to a file"
                                                  : "give the unit as scale in the URDF");
  }
  if (q->certificate != NULL && !path_digest_possible(error)) {
    return false;
  }
  const char *const read[] = {q->urdf, q->motion, q->srdf, q->table};
  for (int n = 0; n < 4 && q->certificate != NULL; n++) {
    struct stat s;
    if (read[n] != NULL && stat(read[n], &s) == 0 && !S_ISREG(s.st_mode)) {
      return sepax_fail(
          error, SEPAX_ERROR_ARGUMENT,
          "certificate: %.240s is not a regular file, so the checker cannot read it again; give a "
          "file",
          read[n]);
    }
  }
  if (q->jobs == NULL && (q->word != 0 || q->lsb.text != NULL)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "%s: applies only to --jobs; give --jobs, too, or leave it out",
                      q->word != 0 ? "word" : "lsb");
  }
  if (q->resolution.length <= 0) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "resolution: %.60s is not above 0",
                      q->resolution.text);
  }
  const char *const names[2] = {q->urdf, q->motion};
  const char *const more[2] = {q->srdf != NULL ? q->srdf : "", q->jobs != NULL ? q->jobs : ""};
  const char *const rules[2] = {q->table != NULL ? q->table : "", ""};
  return (!q->output.json && q->page == NULL) ||
         (report_names_printable(names, error) && report_names_printable(more, error) &&
          report_names_printable(rules, error));
}
