/* options.c - what says which scene is asked about: of sepax path and of sepax size. */
#include "path/parts.h"
#include "util/error.h"

#include <string.h>

enum { KEY_SRDF = 0x500, KEY_PACKAGE, KEY_CLEARANCE, KEY_WARNING, KEY_HOLD, KEY_IGNORE_LIMITS };

static const struct argp_option options[] = {
    {"srdf", KEY_SRDF, "FILE", 0,
     "compare the pairs of links that this SRDF does not disable; without it all but the two links "
     "of a joint",
     0},
    {"package", KEY_PACKAGE, "NAME:FOLDER", 0, "where package://NAME/ is; may be given again", 0},
    {"clearance", KEY_CLEARANCE, "LENGTH", 0,
     "bodies collide unless they are farther from each other than this: with nm, um, mm or m "
     "behind it, or metres",
     0},
    {"warning", KEY_WARNING, "LENGTH", 0,
     "a second, larger clearance: warn of bodies unless they are farther from each other than this",
     0},
    {"hold", KEY_HOLD, NULL, 0, "joints without a column stay at 0", 0},
    {"ignore-limits", KEY_IGNORE_LIMITS, NULL, 0, "values may be beyond the limits of their joints",
     0},
    {0}};

/* A length without a unit is one of metres, as in URDF. */
static const cli_unit lengths[] = {{"nm", -9}, {"um", -6}, {"mm", -3}, {"m", 0}, {NULL, 0}};

path_limit path_length(const struct argp_state *state, const char *name, const char *text) {
  path_limit l = {text, 0};
  const char *end = cli_scan(text, lengths, &l.length);
  if (end == NULL || *end != '\0') {
    argp_error(state, "%s: '%s' is not a length; give 0.1mm, or metres", name, text);
  }
  if (l.length < 0 || l.length > 1e9) {
    argp_error(state, "%s: %s is not within 0 ... 1e9 m", name, text);
  }
  return l;
}

static void add_package(path_question *q, const struct argp_state *state, char *text) {
  char *colon = strchr(text, ':');
  if (colon == NULL || colon == text || colon[1] == '\0' || q->packages == PATH_PACKAGES_MOST) {
    argp_error(state, "package: '%s' is not NAME:FOLDER, or one too many", text);
  } else {
    *colon = '\0';
    q->package[q->packages++] = (format_package){text, colon + 1};
  }
}

static error_t parse(int key, char *text, struct argp_state *state) {
  path_question *q = state->input;
  switch (key) {
  case KEY_SRDF:
    q->srdf = text;
    return 0;
  case KEY_PACKAGE:
    add_package(q, state, text);
    return 0;
  case KEY_CLEARANCE:
    q->clearance = path_length(state, "clearance", text);
    return 0;
  case KEY_WARNING:
    q->warning = path_length(state, "warning", text);
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

const struct argp path_scene_argp = {options, parse, NULL, NULL, NULL, NULL, NULL};

bool path_bands_agree(const path_question *q, sepax_error *error) {
  if (q->warning.text != NULL && q->clearance.text == NULL) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "warning: there is no clearance to warn before; give --clearance, too");
  }
  if (q->warning.text != NULL && q->warning.length <= q->clearance.length) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "warning: %.60s is not above the clearance of %.60s", q->warning.text,
                      q->clearance.text);
  }
  return true;
}
