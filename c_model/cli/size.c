/* size.c - sepax size: what a scene needs, and the design for it. */
#include "cli.h"
#include "cli/report.h"
#include "sepax_design.h"
#include "util/error.h"

#include <stdlib.h>
#include <string.h>

typedef struct {
  sepax_space space;
  const char *path[2], *folder;
  int paths, lanes_least, lanes_most;
  double seconds;
  sepax_config clock; /* its period only */
  bool json, generate;
} size_options;

enum {
  KEY_OFFSET = 0x480,
  KEY_WORKSPACE,
  KEY_MOTION,
  KEY_MOTION_A,
  KEY_CENTRE,
  KEY_CENTRE_A,
  KEY_POSES,
  KEY_TIME,
  KEY_CLOCK,
  KEY_LANES,
  KEY_GEN
};

static const struct argp_option options[] = {
    {NULL, 0, NULL, 0,
     "Scene (a LENGTH is in file units, or with nm, um, mm or m behind it where "
     "these are mm):",
     1},
    {"resolution", 'r', "LENGTH", 0, "length per LSB", 0},
    {"offset", KEY_OFFSET, "X,Y,Z", 0,
     "file coordinates of the integer origin (the middle of the workspace)", 0},
    {"workspace", KEY_WORKSPACE, "SIZE", 0,
     "a cuboid that must hold all poses: LENGTH, LENGTHxLENGTHxLENGTH, or LENGTH..LENGTHx... in "
     "the file's coordinates (what the poses need)",
     0},
    {"motion", KEY_MOTION, "WHERE", 0,
     "how B may move from its pose in the file: x:LENGTH..LENGTH, y:..., z:... and rotate:x, "
     "rotate:y, rotate:z or rotate, with commas between (not at all)",
     0},
    {"centre", KEY_CENTRE, "X,Y,Z", 0, "what B rotates about, file coordinates (0,0,0)", 0},
    {"motion-a", KEY_MOTION_A, "WHERE", 0, "the same of A", 0},
    {"centre-a", KEY_CENTRE_A, "X,Y,Z", 0, "the same of A", 0},
    {"poses", KEY_POSES, "COUNT", 0,
     "poses of a moving body to sample for the candidates that the AABB test leaves (64)", 0},
    {"seed", 's', "SEED", 0, "seed of these poses (1)", 0},
    {NULL, 0, NULL, 0, "Design:", 2},
    {"time", KEY_TIME, "TIME", 0, "for all pairs, with ns, us, ms or s behind it (0.96ms)", 0},
    {"clock-ns", KEY_CLOCK, "PERIOD", 0, "clock period, 0.5 ... 20 (2)", 0},
    {"lanes", KEY_LANES, "COUNT", 0,
     "comparator lanes, 0 ... 64; 0: a core alone (as many as the time takes)", 0},
    {NULL, 0, NULL, 0, "Output:", 3},
    {"json", 'j', NULL, 0, "print JSON instead of text", 0},
    {"gen", KEY_GEN, NULL, 0, "generate the design, too, as sepax gen does; needs -o", 0},
    {"output", 'o', "DIR", 0, "folder for its Verilog (made if missing)", 0},
    {0}};

/* ----------------------------------------------------------------------- parsing */

/* LENGTH or LENGTH..LENGTH; the end of it, or NULL. */
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

/* One item of a motion; the end of it, or NULL. Each may be given once: bits 0 ... 2 of `given`
 * stand for x, y, z, bit 3 for rotate. */
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
  static const cli_unit units[] = {{"ns", -9}, {"us", -6}, {"ms", -3}, {"s", 0}, {NULL, 0}};
  double seconds;
  const char *end = cli_scan(text, units, &seconds);
  if (end == NULL || *end != '\0' || (end[-1] != 's') || !(seconds > 0)) {
    argp_error(state, "time: '%s' is no time; give 1ms, say", text);
  }
  return seconds;
}

static error_t parse_scene(int key, char *text, struct argp_state *state) {
  sepax_space *space = &((size_options *)state->input)->space;
  switch (key) {
  case 'r':
    space->resolution = cli_length(state, "resolution", text);
    if (space->resolution <= 0) {
      argp_error(state, "resolution: %s is not above 0", text);
    }
    return 0;
  case KEY_OFFSET:
    cli_vector(state, "offset", text, space->offset);
    space->offset_given = true;
    return 0;
  case KEY_WORKSPACE:
    if (!scan_workspace(space, text)) {
      argp_error(state, "workspace: '%s' is not LENGTHxLENGTHxLENGTH, nor LOW..HIGH three times",
                 text);
    }
    return 0;
  case KEY_MOTION:
    parse_motion(state, &space->motion[1], "motion", text);
    return 0;
  case KEY_MOTION_A:
    parse_motion(state, &space->motion[0], "motion-a", text);
    return 0;
  case KEY_CENTRE:
    cli_vector(state, "centre", text, space->motion[1].centre);
    return 0;
  case KEY_CENTRE_A:
    cli_vector(state, "centre-a", text, space->motion[0].centre);
    return 0;
  case KEY_POSES:
    space->poses = (int)cli_count(state, "poses", text, 1000000);
    return 0;
  case 's':
    space->seed = cli_count(state, "seed", text, UINT64_MAX);
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

static void check_given(const size_options *o, const struct argp_state *state) {
  if (o->paths != 2) {
    argp_error(state, "give two STL files");
  }
  if (o->space.resolution == 0) {
    argp_error(state, "resolution: what is one LSB? give --resolution=2um, say");
  }
  if (o->generate != (o->folder != NULL)) {
    argp_error(state, "--gen and -o DIR go together; give both");
  }
}

static error_t parse(int key, char *text, struct argp_state *state) {
  size_options *o = state->input;
  sepax_error error;
  switch (key) {
  case KEY_TIME:
    o->seconds = parse_time(state, text);
    return 0;
  case KEY_CLOCK:
    if (!sepax_config_set(&o->clock, "clock-ns", text, &error)) {
      argp_error(state, "%s", error.text);
    }
    return 0;
  case KEY_LANES:
    o->lanes_least = (int)cli_count(state, "lanes", text, SEPAX_LANES_MAX);
    o->lanes_most = o->lanes_least;
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
      argp_error(state, "unexpected argument '%s': give two STL files", text);
    }
    o->path[o->paths++] = text;
    return 0;
  case ARGP_KEY_END:
    check_given(o, state);
    return 0;
  default:
    return parse_scene(key, text, state);
  }
}

/* ------------------------------------------------------------------------ output */

static uint64_t pairs_of(const sepax_size *s) { return (uint64_t)s->count[0] * s->count[1]; }

static uint64_t memory_bits(const sepax_sized_design *m) {
  const sepax_config *c = &m->config; /* triangles and their AABBs */
  return c->lanes == 0 ? 0
                       : 15 * (uint64_t)c->word * ((uint64_t)c->memory_a + (uint64_t)c->memory_b);
}

enum { WIDTH = 11 };

static void print_candidates(const size_options *o, const sepax_size *s) {
  double pairs = (double)pairs_of(s);
  printf("%-*s%llu of %.0f pairs have overlapping AABBs in the pose of the files: %.3g %%\n", WIDTH,
         "AABBs", (unsigned long long)s->given, pairs, 100 * (double)s->given / pairs);
  if (s->poses > 0) {
    printf("%-*sthe most in that and in %d sampled poses (seed %llu): %llu, %.3g %%\n", WIDTH, "",
           s->poses, (unsigned long long)o->space.seed, (unsigned long long)s->worst,
           100 * (double)s->worst / pairs);
  }
}

static void print_design(const sepax_size *s, const sepax_sized_design *m) {
  printf("design     exact, II = %d, ", m->config.ii);
  if (m->config.lanes > 0) {
    printf("%d comparator lanes, %d core%s, memories of %.0f kbit\n", m->config.lanes,
           m->config.cores, m->config.cores > 1 ? "s" : "", (double)memory_bits(m) / 1000);
  } else {
    printf("no comparator lanes\n");
  }
  printf("gates      %.1fK +- %.1fK GE (formula for Nangate45 at 2 ns%s)\n", m->gates / 1000,
         m->gates_error / 1000, m->fitted ? "" : ", NOT fitted to designs like this one");
  printf("time       %.4g ms for all pairs (%llu cycles of %g ns)", 1e3 * m->seconds,
         (unsigned long long)m->cycles, m->config.clock_ps / 1000.0);
  if (s->poses > 0) {
    printf(", worst of the file's and %d sampled poses, not a bound", s->poses);
  }
  putchar('\n');
}

static void print_text(const size_options *o, const sepax_size *s, const sepax_sized_design *m) {
  char text[SEPAX_CONFIG_TEXT];
  report_print_file('A', WIDTH, o->path[0], s->count[0]);
  report_print_file('B', WIDTH, o->path[1], s->count[1]);
  printf("poses      x %.9g ... %.9g, y %.9g ... %.9g, z %.9g ... %.9g\n", s->low[0], s->high[0],
         s->low[1], s->high[1], s->low[2], s->high[2]);
  report_print_grid(WIDTH, &s->grid);
  printf("extents    L_A = %lld, L_B = %lld LSB: %d bits behind the AABB test\n",
         (long long)s->extent[0], (long long)s->extent[1], s->core_word);
  print_candidates(o, s);
  print_design(s, m);
  printf("sepax gen %s -o %s\n", sepax_config_text(&m->config, text, sizeof text),
         o->generate ? o->folder : "DIR");
}

static void print_json(const size_options *o, const sepax_size *s, const sepax_sized_design *m) {
  char text[SEPAX_CONFIG_TEXT];
  char command[SEPAX_CONFIG_TEXT + 16];
  snprintf(command, sizeof command, "sepax gen %s",
           sepax_config_text(&m->config, text, sizeof text));
  json_t *report = report_scene(o->path, s->count, &s->grid);
  json_t *needs =
      json_pack("{s:[[f, f], [f, f], [f, f]], s:[I, I], s:i}", "poses", s->low[0], s->high[0],
                s->low[1], s->high[1], s->low[2], s->high[2], "extents", (json_int_t)s->extent[0],
                (json_int_t)s->extent[1], "core_word", s->core_word);
  json_t *candidates = json_pack("{s:I, s:I, s:I, s:i, s:I}", "pairs", (json_int_t)pairs_of(s),
                                 "as_given", (json_int_t)s->given, "worst", (json_int_t)s->worst,
                                 "sampled_poses", s->poses, "seed", (json_int_t)o->space.seed);
  json_t *design = json_pack("{s:s, s:i, s:b, s:i, s:i, s:I, s:f, s:f, s:b, s:I, s:f, s:b, s:s}",
                             "arch", sepax_arch_name(m->config.arch), "ii", m->config.ii, "extents",
                             m->config.extent_a > 0, "lanes", m->config.lanes, "cores",
                             m->config.lanes > 0 ? m->config.cores : 1, "memory_bits",
                             (json_int_t)memory_bits(m), "ge", m->gates, "ge_error", m->gates_error,
                             "ge_fitted", m->fitted, "cycles", (json_int_t)m->cycles, "seconds",
                             m->seconds, "is_bound", s->poses == 0, "command", command);
  json_object_update(report, needs);
  json_decref(needs);
  json_object_set_new(report, "candidates", candidates);
  json_object_set_new(report, "design", design);
  report_print_json(report);
}

/* ------------------------------------------------------------------------- steps */

static bool read_and_size(const size_options *o, sepax_size *size, sepax_error *error) {
  sepax_mesh mesh[2] = {{NULL, 0}, {NULL, 0}};
  bool ok = sepax_stl_read(&mesh[0], o->path[0], error) &&
            sepax_stl_read(&mesh[1], o->path[1], error) &&
            sepax_size_scene(size, &mesh[0], &mesh[1], &o->space, error);
  sepax_mesh_free(&mesh[0]);
  sepax_mesh_free(&mesh[1]);
  return ok;
}

/* Through the text, as sepax gen would read it. */
static bool generate(const size_options *o, const sepax_sized_design *m, sepax_error *error) {
  char text[SEPAX_CONFIG_TEXT];
  sepax_config config = sepax_config_default();
  sepax_design design;
  return sepax_config_parse(&config, sepax_config_text(&m->config, text, sizeof text), error) &&
         sepax_design_init(&design, &config, error) && cli_generate(&design, o->folder, error);
}

int cli_size(int argc, char **argv) {
  static const struct argp argp = {
      options,
      parse,
      "A.stl B.stl",
      "What an exact design for two meshes needs in every pose, and the design of the fewest gates "
      "that judges all pairs in time.",
      NULL,
      NULL,
      NULL};
  size_options o = {.space = {.poses = 64, .seed = 1},
                    .lanes_most = SEPAX_LANES_MAX,
                    .seconds = 0.96e-3,
                    .clock = sepax_config_default()};
  argp_parse(&argp, argc, argv, 0, NULL, &o);
  sepax_error error = {""};
  sepax_size size = {.job = NULL};
  sepax_sized_design design;
  if ((o.json && !report_names_printable(o.path, &error)) ||
      !sepax_config_check(&o.clock, &error) || !read_and_size(&o, &size, &error) ||
      !sepax_size_design(&design, &size, o.seconds, o.clock.clock_ps, o.lanes_least, o.lanes_most,
                         &error) ||
      (o.generate && !generate(&o, &design, &error))) {
    sepax_size_free(&size);
    return cli_fail(argv[0], &error);
  }
  (o.json ? print_json : print_text)(&o, &size, &design);
  sepax_size_free(&size);
  return 0;
}
