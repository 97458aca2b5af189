/* SPDX-License-Identifier: MIT */
/* judge.c - sepax judge: verdicts for pairs given as text. */
#include "cli/cli.h"
#include "command_table.h"
#include "util/error.h"
#include "sepax_design.h"
#include "sepax_vectors.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

typedef struct {
  sepax_config config;
  const char *path;
  bool echo;
} judge_options;

static const struct argp_option options[] = {
    {"echo", 'e', NULL, 0,
     "print the 24 integers of the pair before its verdict. Designs with hardware also print, "
     "after the verdict, whether the pair is coplanar (0 or 1). After that, --arch=exact prints "
     "the value of its port out_axis (0 ... 12, or 0 ... 14 with an AABB test) and, with "
     "--clearance, the value of its port out_band (0 free, 1 warning, 2 collision)",
     0},
    {0}};

static error_t parse(int key, char *text, struct argp_state *state) {
  judge_options *o = state->input;
  switch (key) {
  case ARGP_KEY_INIT:
    state->child_inputs[0] = &o->config;
    return 0;
  case 'e':
    o->echo = true;
    return 0;
  case ARGP_KEY_ARG:
    if (o->path != NULL) {
      argp_error(state, "unexpected argument '%s': give one file", text);
    }
    o->path = text;
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

static void print_verdict(const sepax_design *design, const sepax_judgement *verdict,
                          const sepax_pair *pair, bool echo) {
  sepax_told told = sepax_tell(design, verdict);
  if (echo) {
    sepax_pair_print(stdout, pair);
    putchar(' ');
  }
  for (size_t i = 0; i < (echo ? told.count : 1); i++) {
    printf("%s%d", i > 0 ? " " : "", told.value[i]);
  }
  putchar('\n');
}

static bool judge_stream(const sepax_design *design, FILE *in, const char *name, bool echo,
                         sepax_error *error) {
  sepax_pair pair;
  sepax_told told;
  sepax_line line;
  size_t number = 0;
  while ((line = sepax_pair_read_told(&pair, &told, in, name, &number, design->config.word,
                                      error)) == SEPAX_LINE_PAIR) {
    sepax_judgement verdict = sepax_judge(design, &pair);
    sepax_error differs;
    if (!sepax_told_check(&told, design, &verdict, &differs)) {
      return sepax_fail(error, differs.code, "%.200s:%zu: %.280s", name, number, differs.text);
    }
    print_verdict(design, &verdict, &pair, echo);
  }
  return line != SEPAX_LINE_ERROR;
}

int cli_judge(int argc, char **argv) {
  static const struct argp_child children[] = {{&cli_verdict_argp, 0, NULL, 0}, {0}};
  static const struct argp argp = {
      options,
      parse,
      "[FILE]",
      "Print the verdict of a design on each pair of triangles in FILE or standard input: 1 "
      "(collision) or 0 (separated). A pair is a line of 18 integers A1x A1y A1z ... B3z, or of 24 "
      "integers, the last six of which are the normals. Missing normals are computed. '#' starts a "
      "comment. --arch=reference computes the same verdicts as --arch=exact by another method.",
      children,
      NULL,
      NULL};
  judge_options o = {.config = sepax_config_default()};
  cli_parse(&argp, argc, argv, &o);
  sepax_error error = {0};
  sepax_design design;
  if (!sepax_design_init(&design, &o.config, &error)) {
    return cli_fail(argv[0], &error);
  }
  bool from_file = o.path != NULL && strcmp(o.path, "-") != 0;
  FILE *in = from_file ? fopen(o.path, "r") : stdin;
  if (in == NULL) {
    sepax_fail(&error, SEPAX_ERROR_FILE, "%.200s: %s; give a readable file of pairs", o.path,
               strerror(errno));
    return cli_fail(argv[0], &error);
  }
  bool ok = judge_stream(&design, in, from_file ? o.path : "standard input", o.echo, &error);
  if (from_file) {
    fclose(in);
  }
  return ok ? 0 : cli_fail(argv[0], &error);
}
