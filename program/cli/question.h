/* question.h - options that sepax check, sepax path and sepax size share. */
#ifndef SEPAX_CLI_QUESTION_H
#define SEPAX_CLI_QUESTION_H

#include "cli/cli.h"
#include "report/bands.h"

/* --clearance and --warning. The input of this argp child is a report_bands, of which `unit` says
 * in which unit lengths are. */
extern const struct argp cli_bands_argp;

/* A length of 0 ... 2^1000 mm, or of 0 ... 1e9 m where `unit` is CLI_METRES; argp_error otherwise.
 */
report_limit cli_limit(const struct argp_state *state, const char *option, const char *text,
                       int unit);

/* --json and --quiet. The input of this argp child is a cli_output. */
typedef struct {
  bool json, quiet;
} cli_output;
extern const struct argp cli_output_argp;

/* Fails where --json and --quiet are given, or --warning does not fit --clearance. */
bool cli_question_agrees(const cli_output *output, const report_bands *bands, sepax_error *error);

/* Fails where a file to write (NULL: none) is a file to read, or is named twice. */
bool cli_outputs_distinct(const char *const *outputs, int count, const char *const *inputs,
                          int inputs_count, sepax_error *error);

#endif
