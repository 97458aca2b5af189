/* SPDX-License-Identifier: MIT */
/* scene_options.c - the options that describe a scene, for sepax path and sepax size. */
#include "path/common/parts.h"

#include <stdio.h>
#include <string.h>

enum {
  KEY_SRDF = 0x500,
  KEY_PACKAGE,
  KEY_HOLD,
  KEY_IGNORE_LIMITS,
  KEY_MACHINE,
  KEY_TOOL_TABLE,
  KEY_AXIS,
  KEY_CONTROL,
  KEY_RAPIDS,
  KEY_TOOLS,
  KEY_TOOL_LINK,
  KEY_LOADED,
  KEY_START,
  KEY_STOCK,
  KEY_PART,
  KEY_GOUGE,
  KEY_CELLS,
  KEY_DEPTH,
  KEY_FIRST,
  KEY_BLENDED,
  KEY_DEVIATION,
  KEY_SMOOTHING
};

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
    {NULL, 0, NULL, 0, "NC programs, tools and stock:", 1},
    {"tools", KEY_TOOLS, "FILE", 0,
     "the tools that the path names are bodies on --tool-link: flutes, shank and holder of each, "
     "from this file of tools",
     0},
    {"tool-link", KEY_TOOL_LINK, "LINK", 0,
     "the link of the tools: its origin is the nose of the spindle, its z axis leads into the "
     "spindle (default: tool)",
     0},
    {"start", KEY_START, "X,Y,Z,...", 0,
     "the position of the axes X, Y, Z, A, B, C, U, V, W when an NC program starts, in mm and "
     "degrees (default: home)",
     0},
    {"loaded", KEY_LOADED, "NUMBER", 0,
     "the tool in the spindle when an NC program starts; 0: none (default: not known)", 0},
    {"stock", KEY_STOCK, "LINK", 0, "the link of the stock: flutes may meet it in feeds", 0},
    {"part", KEY_PART, "LINK", 0,
     "the link of the finished part: flutes may be no deeper in it than --gouge", 0},
    {"gouge", KEY_GOUGE, "LENGTH", 0, "how deep flutes may be in --part (default 10um)", 0},
    {"cells", KEY_CELLS, "LENGTH", 0,
     "the side of the cells in which --stock is cut (default: 0.2mm, or a tenth of the smallest "
     "radius of a tool, but at most 1500 along the stock)",
     0},
    {"depth", KEY_DEPTH, "LENGTH", 0,
     "flutes in rapids and shanks may be so deep in what is left of --stock (default: two cells)",
     0},
    {"first", KEY_FIRST, "FILE", 0,
     "--stock is what an earlier program has left, a file of --left; the mesh of the link must "
     "hold it",
     0},
    {"machine", KEY_MACHINE, "FILE.ini", 0,
     "the second file is an NC program for the machine of this configuration of LinuxCNC", 0},
    {"tool-table", KEY_TOOL_TABLE, "FILE", 0,
     "the tool table of an NC program (default: that of the configuration)", 0},
    {"axis", KEY_AXIS, "LETTER:JOINT", CLI_REPEATABLE,
     "the joint of the URDF that is an axis of the machine (default: the joint that has the letter "
     "as its name); the option may be repeated",
     0},
    {"control", KEY_CONTROL, "OPTION", CLI_REPEATABLE,
     "what the files of an NC program leave open: set=PIN=VALUE of HAL, table-units=mm or inch, "
     "block-delete, seconds=N for the interpreter (default 60); the option may be repeated",
     0},
    {"rapids", KEY_RAPIDS, "WAY", 0,
     "straight: the axes of a rapid start and arrive together (default); dogleg: each takes its "
     "own time",
     0},
    {"blended", KEY_BLENDED, NULL, 0,
     "count the rounding of corners of G64 without P as a deviation, by the speeds and "
     "accelerations of the ini (default: exact corners)",
     0},
    {"deviation", KEY_DEVIATION, "LENGTH", 0,
     "motions of an NC program that are curved in the joints are divided until each joint is at "
     "most LENGTH, or as many radians as LENGTH has metres, from linear motion (default 1um)",
     0},
    {"smoothing", KEY_SMOOTHING, "LENGTH", 0,
     "how far the control's smoothing takes a linear joint off its way, with ten times as many "
     "radians of a rotary joint as LENGTH has metres (default: a third of the acceleration in "
     "the ini times the square of the servo period)",
     0},
    {0}};

static void add_axis(path_question *q, const struct argp_state *state, const char *text) {
  bool is = strlen(text) > 2 && text[1] == ':' && strchr("XYZABCUVW", text[0]) != NULL;
  for (size_t n = 0; n < q->axes; n++) {
    is = is && q->axis[n].letter != text[0];
  }
  if (!is || q->axes == PATH_AXES_MOST) {
    argp_error(state, "axis: '%s' is not LETTER:JOINT with a letter of XYZABCUVW, each once", text);
  } else {
    q->axis[q->axes].letter = text[0];
    q->axis[q->axes++].joint = text + 2;
  }
}

static void add_package(path_question *q, const struct argp_state *state, char *text) {
  char *colon = strchr(text, ':');
  if (colon == NULL || colon == text || colon[1] == '\0' || q->packages == PATH_PACKAGES_MOST) {
    argp_error(state, "package: '%s' is not NAME:FOLDER, or there are too many packages", text);
  } else {
    *colon = '\0';
    q->package[q->packages++] = (sepax_package){text, colon + 1};
  }
}

/* The field of an option that is a name. */
static const char **name_of(path_question *q, int key) {
  switch (key) {
  case KEY_SRDF:
    return &q->srdf;
  case KEY_TOOLS:
    return &q->tools;
  case KEY_TOOL_LINK:
    return &q->tool_link;
  case KEY_START:
    return &q->start;
  case KEY_STOCK:
    return &q->stock;
  case KEY_PART:
    return &q->part;
  case KEY_FIRST:
    return &q->first;
  case KEY_MACHINE:
    return &q->machine;
  case KEY_TOOL_TABLE:
    return &q->tool_table;
  default:
    return NULL;
  }
}

static error_t parse(int key, char *text, struct argp_state *state) {
  path_question *q = state->input;
  const char **name = name_of(q, key);
  if (name != NULL) {
    *name = text;
    return 0;
  }
  switch (key) {
  case ARGP_KEY_INIT:
    q->bands.unit = CLI_METRES;
    q->tool_link = "tool";
    q->loaded = -1;
    q->gouge = (report_limit){NULL, 1e-5};
    state->child_inputs[0] = &q->bands;
    q->meshes.unit = CLI_METRES;
    state->child_inputs[1] = &q->meshes;
    return 0;
  case KEY_PACKAGE:
    add_package(q, state, text);
    return 0;
  case KEY_HOLD:
    q->rules.hold = true;
    return 0;
  case KEY_LOADED:
    q->loaded = (int)cli_count(state, "loaded", text, 0, 1000000);
    return 0;
  case KEY_GOUGE:
    q->gouge = cli_limit(state, "gouge", text, CLI_METRES);
    if (!(q->gouge.length >= 1e-7)) {
      argp_error(state, "gouge: %s is below 100nm", text);
    }
    return 0;
  case KEY_CELLS:
    q->cell = cli_limit(state, "cells", text, CLI_METRES);
    if (!(q->cell.length >= 1e-6)) {
      argp_error(state, "cells: %s is below 1um", text);
    }
    return 0;
  case KEY_DEPTH:
    q->depth = cli_limit(state, "depth", text, CLI_METRES);
    return 0;
  case KEY_AXIS:
    add_axis(q, state, text);
    return 0;
  case KEY_CONTROL:
    if (q->controls == PATH_CONTROLS_MOST || strlen(text) > 200) {
      argp_error(state, "control: more than %d times, or longer than 200 characters",
                 PATH_CONTROLS_MOST);
    }
    q->control[q->controls++] = text;
    return 0;
  case KEY_RAPIDS:
    q->dogleg = strcmp(text, "dogleg") == 0;
    if (!q->dogleg && strcmp(text, "straight") != 0) {
      argp_error(state, "rapids: '%s' is neither straight nor dogleg", text);
    }
    return 0;
  case KEY_BLENDED:
    q->blended = true;
    return 0;
  case KEY_DEVIATION:
    q->deviation = cli_limit(state, "deviation", text, CLI_METRES);
    if (!(q->deviation.length >= 1e-9 && q->deviation.length <= 1e-3)) {
      argp_error(state, "deviation: %s is not within 1nm ... 1mm", text);
    }
    return 0;
  case KEY_SMOOTHING:
    q->smoothing = cli_limit(state, "smoothing", text, CLI_METRES);
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
