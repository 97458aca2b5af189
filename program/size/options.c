/* SPDX-License-Identifier: MIT */
/* options.c - the options of sepax size: what they mean, and which of them go together. */
#include "size/parts.h"

#include <string.h>

enum {
  KEY_OFFSET = 0x480,
  KEY_WORKSPACE,
  KEY_MOTION,
  KEY_MOTION_A,
  KEY_CENTRE,
  KEY_CENTRE_A,
  KEY_POSES,
  KEY_SAMPLES,
  KEY_FIRST,
  KEY_LATENCY,
  KEY_TREE,
  KEY_TIME,
  KEY_CLOCK,
  KEY_LANES,
  KEY_GEN
};

/* The options of two meshes. */
static const struct argp_option meshes_options[] = {
    {"resolution", 'r', "LENGTH", 0, "length of one LSB", 0},
    {"offset", KEY_OFFSET, "X,Y,Z", 0,
     "point of the files, in mm, that becomes the integer origin (default: the middle of the "
     "workspace)",
     0},
    {"workspace", KEY_WORKSPACE, "SIZE", 0,
     "a cuboid that must hold all poses: LENGTH, LENGTHxLENGTHxLENGTH, or LOW..HIGHxLOW..HIGHx"
     "LOW..HIGH in the files' coordinates (default: the AABB of all poses)",
     0},
    {"motion", KEY_MOTION, "WHERE", 0,
     "how B may move from its pose in the file: a list of items with commas between them. "
     "x:LENGTH..LENGTH, y:LENGTH..LENGTH and z:LENGTH..LENGTH shift B; rotate:x, rotate:y and "
     "rotate:z rotate B about one axis, and rotate rotates B about any axis (default: B does not "
     "move)",
     0},
    {"centre", KEY_CENTRE, "X,Y,Z", 0,
     "point of the files, in mm, about which B rotates (default 0,0,0)", 0},
    {"motion-a", KEY_MOTION_A, "WHERE", 0, "how A may move, as --motion (default: not at all)", 0},
    {"centre-a", KEY_CENTRE_A, "X,Y,Z", 0, "point about which A rotates (default 0,0,0)", 0},
    {"samples", KEY_SAMPLES, "COUNT", 0,
     "number of random poses of the moving bodies; in each pose the pairs with overlapping AABBs "
     "are counted (default 64)",
     0},
    {"seed", 's', "SEED", 0, "seed of these random poses (default 1)", 0},
    {"poses", KEY_POSES, "FILE", 0,
     "path of B, instead of --motion. A line has 12 numbers: the rotation by rows, then the "
     "translation in mm. Tree engines are then considered, too",
     0},
    {0}};

static const struct argp_option options[] = {
    {NULL, 0, NULL, 0, "Design:", 3},
    {"time", KEY_TIME, "TIME", 0,
     "time that a pose may take, with a unit (ns, us, ms, s; default 0.96ms)", 0},
    {"clock-ns", KEY_CLOCK, "PERIOD", 0, "clock period in ns, 0.5 ... 1000 (default 2)", 0},
    {"lanes", KEY_LANES, "COUNT", 0,
     "consider only designs with this number of comparator lanes, 0 ... 64; 0 is a core without "
     "an engine (default: any number)",
     0},
    {"tree", KEY_TREE, NULL, 0, "consider only tree engines (needs --poses)", 0},
    {"first", KEY_FIRST, NULL, 0,
     "a tree engine ends each pose at its first collision (default: it finds all; needs --poses)",
     0},
    {"latency", KEY_LATENCY, "CYCLES", 0,
     "latency of a tree engine's memory in cycles, 1 ... 100000 (default 100; needs --poses)", 0},
    {NULL, 0, NULL, 0, "Output:", 4},
    {"json", 'j', NULL, 0, "print JSON instead of text", 0},
    {"gen", KEY_GEN, NULL, 0, "also generate the design, as sepax gen does (needs --output)", 0},
    {"output", 'o', "DIR", 0, "folder for the Verilog of --gen; it is made if missing", 0},
    {0}};

/* ----------------------------------------------------------------------- parsing */

/* Read LENGTH or LENGTH..LENGTH. Returns the end of what was read, or NULL. */
static const char *scan_range(const char *text, double *low, double *high, bool *is_range) {
  const char *at = cli_scan_length(text, low);
  *high = *low;
  *is_range = at != NULL && strncmp(at, "..", 2) == 0;
  return *is_range ? cli_scan_length(at + 2, high) : at;
}

static bool scan_workspace(sepax_space *space, const char *text) {
  bool placed[3];
  const char *at = text;
  for (int axis = 0; axis < 3; axis++) {
    at = scan_range(at, &space->low[axis], &space->high[axis], &placed[axis]);
    if (at == NULL || placed[axis] != placed[0]) {
      return false;
    }
    if (axis == 0 && *at == '\0' && !placed[0]) { /* a cube */
      for (int k = 1; k < 3; k++) {
        space->high[k] = space->high[0];
        placed[k] = false;
      }
      break;
    }
    if (axis < 2 && *at != 'x' && *at != ',') {
      return false;
    }
    at += axis < 2;
  }
  space->workspace = placed[0] ? SEPAX_WORKSPACE_PLACED : SEPAX_WORKSPACE_SIDES;
  for (int axis = 0; axis < 3 && !placed[0]; axis++) {
    space->low[axis] = 0;
  }
  return *at == '\0';
}

/* Read one item of --motion. Returns the end of what was read, or NULL. Each item may be given
 * once: bits 0 ... 2 of `given` stand for x, y, z, and bit 3 for rotate. */
static const char *scan_item(sepax_motion *m, const char *text, unsigned *given) {
  static const char rotate[] = "rotate";
  if (strncmp(text, rotate, sizeof rotate - 1) == 0) {
    const char *at = text + sizeof rotate - 1;
    if ((*given & 8u) != 0) {
      return NULL;
    }
    *given |= 8u;
    m->rotation = SEPAX_ROTATION_ANY;
    if (at[0] == ':' && at[1] >= 'x' && at[1] <= 'z') {
      m->rotation = (sepax_rotation)(SEPAX_ROTATION_X + (at[1] - 'x'));
      at += 2;
    }
    return at;
  }
  if (text[0] < 'x' || text[0] > 'z' || text[1] != ':') {
    return NULL;
  }
  bool is_range;
  int axis = text[0] - 'x';
  if ((*given & 1u << axis) != 0) {
    return NULL;
  }
  *given |= 1u << axis;
  const char *at = scan_range(text + 2, &m->low[axis], &m->high[axis], &is_range);
  return is_range ? at : NULL;
}

static bool scan_motion(sepax_motion *m, const char *text) {
  unsigned given = 0;
  const char *at = scan_item(m, text, &given);
  while (at != NULL && *at == ',') {
    at = scan_item(m, at + 1, &given);
  }
  return at != NULL && *at == '\0';
}

static void parse_motion(const struct argp_state *state, sepax_motion *m, const char *option,
                         const char *text) {
  if (!scan_motion(m, text)) {
    argp_error(state, "%s: '%s' is not x:LOW..HIGH,y:...,z:...,rotate:x|y|z or rotate, each once",
               option, text);
  }
}

static double parse_time(const struct argp_state *state, const char *text) {
  double seconds;
  const char *end = cli_scan(text, cli_times, CLI_SECONDS, &seconds);
  if (end == NULL || *end != '\0' || (end[-1] != 's') || !(seconds > 0)) {
    argp_error(state, "time: '%s' is not a time; give, for example, 1ms", text);
  }
  return seconds;
}

static error_t parse_meshes(int key, char *text, struct argp_state *state) {
  size_options *o = state->input;
  sepax_space *space = &o->space;
  switch (key) {
  case 'r':
    o->resolution = text;
    space->resolution = cli_length(state, "resolution", text);
    if (space->resolution <= 0) {
      argp_error(state, "resolution: %s is not above 0", text);
    }
    return 0;
  case KEY_OFFSET:
    cli_vector(state, "offset", text, space->offset);
    space->offset_given = true;
    o->placed = "offset";
    return 0;
  case KEY_WORKSPACE:
    if (!scan_workspace(space, text)) {
      argp_error(state, "workspace: '%s' is not LENGTHxLENGTHxLENGTH, nor LOW..HIGH three times",
                 text);
    }
    o->placed = "workspace";
    return 0;
  case KEY_MOTION:
    o->moved = "motion";
    parse_motion(state, &space->motion[1], "motion", text);
    return 0;
  case KEY_MOTION_A:
    o->moved = "motion-a";
    parse_motion(state, &space->motion[0], "motion-a", text);
    return 0;
  case KEY_CENTRE:
    o->moved = "centre";
    cli_vector(state, "centre", text, space->motion[1].centre);
    return 0;
  case KEY_CENTRE_A:
    o->moved = "centre-a";
    cli_vector(state, "centre-a", text, space->motion[0].centre);
    return 0;
  case KEY_POSES:
    o->path_file = text;
    return 0;
  case KEY_SAMPLES:
    o->moved = "samples";
    space->poses = (int)cli_count(state, "samples", text, 0, 1000000);
    return 0;
  case 's':
    o->moved = "seed";
    space->seed = cli_count(state, "seed", text, 0, UINT64_MAX);
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

static const struct argp meshes_argp = {meshes_options, parse_meshes, NULL, NULL, NULL, NULL, NULL};

static bool ends_in(const char *name, const char *end) {
  size_t length = strlen(name);
  return length > strlen(end) && strcmp(name + length - strlen(end), end) == 0;
}

/* Refuse options that apply only to two meshes, or only to a machine and its path. */
static void check_scene(size_options *o, const struct argp_state *state) {
  const path_question *q = &o->scene;
  o->is_scene = ends_in(o->path[0], ".urdf") || ends_in(o->path[1], ".csv");
  if (!o->is_scene) {
    if (q->srdf != NULL || q->packages > 0 || q->bands.clearance.text != NULL ||
        q->bands.warning.text != NULL || q->rules.hold || q->rules.ignore_limits) {
      argp_error(
          state,
          "srdf, package, clearance, warning, hold, ignore-limits: apply only to a URDF and a CSV "
          "file; leave them out");
    }
    return;
  }
  const char *other = o->path_file != NULL ? "poses" : o->moved != NULL ? o->moved : o->placed;
  if (other != NULL) {
    argp_error(
        state,
        "%s: applies only to two meshes, because the CSV says where the bodies are; leave it out",
        other);
  }
  o->posed = NULL;
  o->request.first = true; /* because the jobs of a list end at the first collision */
  o->scene.urdf = o->path[0];
  o->scene.motion = o->path[1];
  o->scene.keep = true;
  if (o->resolution != NULL) {
    o->scene.lsb = cli_limit(state, "resolution", o->resolution, CLI_METRES);
  }
}

static void check_given(size_options *o, const struct argp_state *state) {
  if (o->paths != 2) {
    argp_error(state, "give two mesh files, or a URDF and a CSV file");
  }
  check_scene(o, state);
  if (o->space.resolution == 0) {
    argp_error(state, "resolution: give the length of one LSB, for example --resolution=2um");
  }
  if (o->moved != NULL && o->path_file != NULL) {
    argp_error(state, "%s: cannot be combined with --poses; leave one of them out", o->moved);
  }
  if (o->posed != NULL && o->path_file == NULL) {
    argp_error(state, "%s: applies only to tree engines on a path; give --poses=FILE, too",
               o->posed);
  }
  if (o->request.tree && o->lanes_given) {
    argp_error(state, "tree: a tree engine has no comparator lanes; leave out --tree, or --lanes");
  }
  if (o->generate != (o->folder != NULL)) {
    argp_error(state, "--gen and -o DIR go together; give both");
  }
}

static error_t parse(int key, char *text, struct argp_state *state) {
  size_options *o = state->input;
  sepax_error error;
  switch (key) {
  case ARGP_KEY_INIT:
    state->child_inputs[0] = &o->scene;
    state->child_inputs[1] = o;
    return 0;
  case KEY_TIME:
    o->request.seconds = parse_time(state, text);
    return 0;
  case KEY_CLOCK:
    if (!sepax_config_set(&o->clock, "clock-ns", text, &error)) {
      argp_error(state, "%s", error.text);
    }
    return 0;
  case KEY_LANES:
    o->request.lanes_least = (int)cli_count(state, "lanes", text, 0, SEPAX_LANES_MAX);
    o->request.lanes_most = o->request.lanes_least;
    o->lanes_given = true;
    return 0;
  case KEY_TREE:
    o->request.tree = true;
    o->posed = "tree";
    return 0;
  case KEY_FIRST:
    o->request.first = true;
    o->posed = "first";
    return 0;
  case KEY_LATENCY:
    o->request.latency = (int)cli_count(state, "latency", text, 1, 100000);
    o->posed = "latency";
    return 0;
  case 'j':
    o->json = true;
    return 0;
  case KEY_GEN:
    o->generate = true;
    return 0;
  case 'o':
    o->folder = text;
    return 0;
  case ARGP_KEY_ARG:
    if (o->paths == 2) {
      argp_error(state, "unexpected argument '%s': give two files", text);
    }
    o->path[o->paths++] = text;
    return 0;
  case ARGP_KEY_END:
    check_given(o, state);
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

void size_parse(size_options *o, int argc, char **argv) {
  static const struct argp_child children[] = {
      {&path_scene_argp, 0, "Scene of a machine and its path:", 2},
      {&meshes_argp, 0, "Scene (a LENGTH has a unit, nm, um, mm or m, or is in mm):", 1},
      {0}};
  static const struct argp argp = {
      options,
      parse,
      "A B\nROBOT.urdf PATH.csv",
      "Find the smallest design of architecture exact that judges all pairs of triangles of a "
      "scene in time. The smallest design is the one with the fewest gates. Also print the word "
      "length, the extents and the greatest number of pairs with overlapping AABBs. The scene is "
      "two meshes A and B, or a machine and its path. For a machine, all pairs of bodies are "
      "judged in each line of the path. Candidates are a core without an engine, object engines "
      "and, on a path, tree engines.",
      children,
      NULL,
      NULL};
  *o = (size_options){
      .space = {.poses = 64, .seed = 1},
      .request = {.lanes_most = SEPAX_LANES_MAX, .seconds = 0.96e-3, .latency = SEPAX_TREE_LATENCY},
      .clock = sepax_config_default()};
  cli_parse(&argp, argc, argv, o);
  o->request.clock_ps = o->clock.clock_ps;
}
