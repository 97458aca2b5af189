/* SPDX-License-Identifier: MIT */
/* options.c - the options that describe a scene, for sepax path and sepax size. */
#include "path/parts.h"

#include <stdio.h>
#include <string.h>

enum { KEY_SRDF = 0x500, KEY_PACKAGE, KEY_HOLD, KEY_IGNORE_LIMITS };

static const struct argp_option options[] = {
    {"srdf", KEY_SRDF, "FILE", 0,
     "check all pairs of links that this SRDF file does not disable. Default: all pairs except "
     "the two links of a joint and two links that are joined only by fixed joints",
     0},
    {"package", KEY_PACKAGE, "NAME:FOLDER", CLI_REPEATABLE,
     "take FOLDER for package://NAME/ in the URDF; the option may be repeated", 0},
    {"hold", KEY_HOLD, NULL, 0, "keep joints that have no column in the CSV at 0", 0},
    {"ignore-limits", KEY_IGNORE_LIMITS, NULL, 0, "accept values beyond the limits of their joints",
     0},
    {0}};

static void add_package(path_question *q, const struct argp_state *state, char *text) {
  char *colon = strchr(text, ':');
  if (colon == NULL || colon == text || colon[1] == '\0' || q->packages == PATH_PACKAGES_MOST) {
    argp_error(state, "package: '%s' is not NAME:FOLDER, or there are too many packages", text);
  } else {
    *colon = '\0';
    q->package[q->packages++] = (sepax_package){text, colon + 1};
  }
}

static error_t parse(int key, char *text, struct argp_state *state) {
  path_question *q = state->input;
  switch (key) {
  case ARGP_KEY_INIT:
    q->bands.unit = CLI_METRES;
    state->child_inputs[0] = &q->bands;
    q->meshes.unit = CLI_METRES;
    state->child_inputs[1] = &q->meshes;
    return 0;
  case KEY_SRDF:
    q->srdf = text;
    return 0;
  case KEY_PACKAGE:
    add_package(q, state, text);
    return 0;
  case KEY_HOLD:
    q->rules.hold = true;
    return 0;
  case KEY_IGNORE_LIMITS:
    q->rules.ignore_limits = true;
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

static const struct argp_child children[] = {
    {&cli_bands_argp, 0, NULL, 0}, {&cli_meshes_argp, 0, NULL, 0}, {0}};
const struct argp path_scene_argp = {options, parse, NULL, NULL, children, NULL, NULL};
