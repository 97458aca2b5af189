/* SPDX-License-Identifier: MIT */
/* question.h - options that sepax check, sepax path and sepax size share. */
#ifndef SEPAX_CLI_QUESTION_H
#define SEPAX_CLI_QUESTION_H

#include "cli/cli.h"
#include "report/bands.h"

/* The argp child for --clearance and --warning. Its input is a report_bands, whose `unit` is the
 * unit of numbers without one. */
extern const struct argp cli_bands_argp;

/* Read a length of 0 ... 2^1000 mm, or of 0 ... 1e9 m if `unit` is CLI_METRES. Anything else ends
 * the program by argp_error. */
report_limit cli_limit(const struct argp_state *state, const char *option, const char *text,
                       int unit);

/* The input of the argp child for --json and --quiet. */
typedef struct {
  bool json, quiet;
} cli_output;
extern const struct argp cli_output_argp;

/* Fails if both --json and --quiet are given, or if --warning does not fit --clearance. */
bool cli_question_agrees(const cli_output *output, const report_bands *bands, sepax_error *error);

/* Fails if a file to write is also read, is written twice or is "-", because no command writes a
 * file to standard output. NULL entries are skipped. */
bool cli_outputs_allowed(const char *const *outputs, int count, const char *const *inputs,
                         int inputs_count, sepax_error *error);

#endif
