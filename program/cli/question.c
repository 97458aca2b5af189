/* SPDX-License-Identifier: MIT */
/* question.c - options that sepax check, sepax path and sepax size share. */
#include "cli/question.h"
#include "cli/units.h"
#include "util/error.h"

#include <string.h>

/* ------------------------------------------------------------------------- bands */

enum { KEY_CLEARANCE = 0x600, KEY_WARNING };

static const struct argp_option bands_options[] = {
    {"clearance", KEY_CLEARANCE, "LENGTH", 0,
     "call bodies a collision unless they are farther apart than LENGTH, for example 0.1mm; units "
     "are nm, um, mm, m; a number without a unit is in mm for meshes and in m for a URDF",
     0},
    {"warning", KEY_WARNING, "LENGTH", 0,
     "a second, larger clearance: warn unless the bodies are farther apart than LENGTH", 0},
    {0}};

report_limit cli_limit(const struct argp_state *state, const char *option, const char *text,
                       int unit) {
  bool metres = unit == CLI_METRES;
  report_limit limit = {text, 0};
  const char *end = cli_scan(text, cli_lengths, unit, &limit.length);
  if (end == NULL || *end != '\0') {
    argp_error(state, "%s: '%s' is not a length; give %s", option, text,
               metres ? "0.1mm, or 0.0001 for 0.0001 m" : "2um, or 0.002 for 0.002 mm");
  }
  if (!(limit.length >= 0 && limit.length <= (metres ? 1e9 : 0x1p1000))) {
    argp_error(state, "%s: %s is not within 0 ... %s", option, text,
               metres ? "1e9 m" : "2^1000 mm");
  }
  return limit;
}

static error_t parse_bands(int key, char *text, struct argp_state *state) {
  report_bands *bands = state->input;
  switch (key) {
  case KEY_CLEARANCE:
    bands->clearance = cli_limit(state, "clearance", text, bands->unit);
    return 0;
  case KEY_WARNING:
    bands->warning = cli_limit(state, "warning", text, bands->unit);
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

const struct argp cli_bands_argp = {bands_options, parse_bands, NULL, NULL, NULL, NULL, NULL};

/* ------------------------------------------------------------------------- output */

static const struct argp_option output_options[] = {
    {"json", 'j', NULL, 0, "print JSON instead of text", 0},
    {"quiet", 'q', NULL, 0, "print nothing; the exit status is the answer", 0},
    {0}};

static error_t parse_output(int key, char *text, struct argp_state *state) {
  cli_output *output = state->input;
  (void)text;
  output->json = output->json || key == 'j';
  output->quiet = output->quiet || key == 'q';
  return key == 'j' || key == 'q' ? 0 : ARGP_ERR_UNKNOWN;
}

const struct argp cli_output_argp = {output_options, parse_output, NULL, NULL, NULL, NULL, NULL};

bool cli_question_agrees(const cli_output *output, const report_bands *bands, sepax_error *error) {
  if (output->quiet && output->json) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "quiet: cannot be combined with --json; leave one of them out");
  }
  return report_bands_agree(bands, error);
}

bool cli_outputs_allowed(const char *const *outputs, int count, const char *const *inputs,
                         int inputs_count, sepax_error *error) {
  for (int i = 0; i < count; i++) {
    if (outputs[i] != NULL && strcmp(outputs[i], "-") == 0) {
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "-: standard output cannot be used here; name a file to write");
    }
    for (int k = 0; k < inputs_count && outputs[i] != NULL; k++) {
      if (inputs[k] != NULL && cli_same_file(outputs[i], inputs[k])) {
        return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                          "%.300s: is an input; name another file to write", outputs[i]);
      }
    }
    for (int k = 0; k < i && outputs[i] != NULL; k++) {
      if (outputs[k] != NULL && cli_same_file(outputs[i], outputs[k])) {
        return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                          "%.300s: two options write this file; name two different files",
                          outputs[i]);
      }
    }
  }
  return true;
}
