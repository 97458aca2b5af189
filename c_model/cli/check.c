/* check.c - sepax check: which triangles of two STL files collide. */
#include "cli.h"
#include "cli/report.h"
#include "sepax_design.h"
#include "util/error.h"
#include "util/list.h"
#include "util/write_file.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

typedef struct {
  sepax_config config;
  cli_grid grid;
  const char *path[2];
  double clearance, warning; /* file units; below 0: none */
  int paths, threads;
  const char *pairs_path, *ply_path;
  bool json, solid, first;
} check_options;

typedef struct {
  sepax_pairs pairs; /* that collide */
  sepax_pairs warned;
  size_t capacity; /* of pairs */
  double seconds;
  bool within[2]; /* A in B, B in A */
} collisions;

enum { KEY_SOLID = 0x380, KEY_THREADS, KEY_FIRST, KEY_PAIRS, KEY_PLY, KEY_CLEARANCE, KEY_WARNING };

static const struct argp_option options[] = {
    {"json", 'j', NULL, 0, "print JSON instead of text", 0},
    {"solid", KEY_SOLID, NULL, 0,
     "the meshes are closed: a part wholly inside the other mesh is a collision, too", 0},
    {"first", KEY_FIRST, NULL, 0, "stop at the first pair that collides", 0},
    {"clearance", KEY_CLEARANCE, "LENGTH", 0,
     "in file units: pairs collide unless they are provably farther from each other than this, "
     "before they were rounded to LSB",
     0},
    {"warning", KEY_WARNING, "LENGTH", 0,
     "in file units: warn of pairs unless they are provably farther from each other than this", 0},
    {"pairs", KEY_PAIRS, "FILE", 0, "write the colliding pairs as CSV, not to standard output", 0},
    {"ply", KEY_PLY, "FILE", 0, "write both meshes as PLY, colliding triangles in colour", 0},
    {"threads", KEY_THREADS, "N", 0, "threads of --arch=exact (one for each processor)", 0},
    {0}};

static double length(struct argp_state *state, const char *name, const char *text) {
  double value = cli_number(state, name, text);
  if (value < 0) {
    argp_error(state, "%s: %s is below 0", name, text);
  }
  return value;
}

static error_t parse(int key, char *text, struct argp_state *state) {
  check_options *o = state->input;
  switch (key) {
  case ARGP_KEY_INIT:
    state->child_inputs[0] = &o->config;
    state->child_inputs[1] = &o->grid;
    return 0;
  case 'j':
    o->json = true;
    return 0;
  case KEY_SOLID:
    o->solid = true;
    return 0;
  case KEY_FIRST:
    o->first = true;
    return 0;
  case KEY_CLEARANCE:
    o->clearance = length(state, "clearance", text);
    return 0;
  case KEY_WARNING:
    o->warning = length(state, "warning", text);
    return 0;
  case KEY_PAIRS:
    o->pairs_path = text;
    return 0;
  case KEY_PLY:
    o->ply_path = text;
    return 0;
  case KEY_THREADS:
    o->threads = (int)cli_count(state, "threads", text, 1024);
    return 0;
  case ARGP_KEY_ARG:
    if (o->paths == 2) {
      argp_error(state, "unexpected argument '%s': give two STL files", text);
    }
    o->path[o->paths++] = text;
    return 0;
  case ARGP_KEY_END:
    if (o->paths != 2) {
      argp_error(state, "give two STL files");
    }
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

static bool judge_all(const sepax_design *design, const sepax_scene *scene, bool first,
                      collisions *found) {
  uint64_t total = (uint64_t)scene->count[0] * scene->count[1];
  cli_progress progress = cli_progress_begin("pairs", total);
  bool ok = true;
  bool done = false;
  for (size_t i = 0; i < scene->count[0] && ok && !done; i++) {
    for (size_t j = 0; j < scene->count[1] && ok && !done; j++) {
      sepax_pair pair = sepax_scene_pair(scene, i, j);
      if (sepax_judge(design, &pair).collision) {
        ok = list_add_pair(&found->pairs, &found->capacity, i, j);
        done = first;
      }
    }
    cli_progress_show(&progress, (uint64_t)(i + 1) * scene->count[1]);
  }
  found->seconds = cli_progress_end(&progress);
  return ok;
}

static bool show(void *context, uint64_t done, uint64_t total) {
  cli_progress *progress = context;
  progress->total = total;
  cli_progress_show(progress, done);
  return true;
}

/* Divide the pairs that are not free: those that collide stay, the others go to found->warned. */
static bool divide_bands(const sepax_design *design, const sepax_scene *scene, collisions *found) {
  sepax_pairs *all = &found->pairs;
  size_t colliding = 0;
  found->warned.pair = malloc((all->count + 1) * sizeof *all->pair);
  if (found->warned.pair == NULL) {
    return false;
  }
  for (size_t k = 0; k < all->count; k++) {
    sepax_pair pair = sepax_scene_pair(scene, all->pair[k][0], all->pair[k][1]);
    bool collides = sepax_clearance(design, &pair.a, &pair.b).collision;
    size_t *to = collides ? all->pair[colliding++] : found->warned.pair[found->warned.count++];
    memmove(to, all->pair[k], sizeof *all->pair);
  }
  all->count = colliding;
  return true;
}

static bool search(const check_options *o, const sepax_design *design, const sepax_scene *scene,
                   collisions *found, sepax_error *error) {
  cli_progress progress = cli_progress_begin("leaves", 1);
  bool bands = design->limits > 0;
  sepax_search how = {
      .threads = o->threads, .first = o->first && !bands, .progress = show, .context = &progress};
  bool ok = bands ? sepax_near_pairs(design, scene->tri[0], scene->count[0], scene->tri[1],
                                     scene->count[1], &how, &found->pairs, error)
                  : sepax_colliding_pairs(scene->tri[0], scene->count[0], scene->tri[1],
                                          scene->count[1], &how, &found->pairs, error);
  found->seconds = cli_progress_end(&progress);
  return ok && (!bands || divide_bands(design, scene, found) ||
                sepax_fail(error, "no memory for the pairs found"));
}

/* Exact verdicts down a tree of AABBs; verdicts of other designs pair by pair. */
static bool find(const check_options *o, const sepax_design *design, const sepax_scene *scene,
                 collisions *found, sepax_error *error) {
  bool exact = o->config.arch == SEPAX_ARCH_EXACT && !o->config.flag && o->config.extent_a == 0;
  if (exact) {
    return search(o, design, scene, found, error);
  }
  return judge_all(design, scene, o->first, found) ||
         sepax_fail(error, "no memory for %zu collisions", found->pairs.count);
}

static bool hit(const collisions *found) {
  return found->pairs.count > 0 || found->within[0] || found->within[1];
}

/* Lengths in file units as LSB of the grid, rounded up, into the design. */
static bool set_clearances(const check_options *o, const sepax_grid *grid, sepax_design *design,
                           sepax_error *error) {
  sepax_config config = o->config;
  if (o->clearance >= 0 && !sepax_grid_lsb(grid, o->clearance, &config.clearance)) {
    return sepax_fail(error, "clearance: %g is above 2^31 LSB of %g", o->clearance,
                      grid->resolution);
  }
  if (o->warning >= 0 && !sepax_grid_lsb(grid, o->warning, &config.warning)) {
    return sepax_fail(error, "warning: %g is above 2^31 LSB of %g", o->warning, grid->resolution);
  }
  return sepax_design_init(design, &config, error);
}

static void print_bands(const sepax_design *design, const sepax_scene *scene,
                        const collisions *found) {
  double lsb = scene->grid.resolution;
  size_t not_free = found->pairs.count + found->warned.count;
  printf("bands  %zu free, ", scene->count[0] * scene->count[1] - not_free);
  if (design->limits > 1) {
    printf("%zu warning (up to %d LSB = %.9g), ", found->warned.count, design->config.warning,
           design->config.warning * lsb);
  }
  printf("%zu collision (up to %d LSB = %.9g)\n", found->pairs.count, design->config.clearance,
         design->config.clearance * lsb);
}

static void print_text(const check_options *o, const sepax_design *design, const sepax_scene *scene,
                       const collisions *found) {
  enum { WIDTH = 7 };
  report_print_file('A', WIDTH, o->path[0], scene->count[0]);
  report_print_file('B', WIDTH, o->path[1], scene->count[1]);
  report_print_grid(WIDTH, &scene->grid);
  for (size_t k = 0; k < found->pairs.count && o->pairs_path == NULL; k++) {
    printf("A[%zu] B[%zu]\n", found->pairs.pair[k][0], found->pairs.pair[k][1]);
  }
  for (int i = 0; i < 2; i++) {
    if (found->within[i]) {
      printf("%c, or a part of it, is wholly inside %c\n", "AB"[i], "BA"[i]);
    }
  }
  if (design->limits > 0) {
    print_bands(design, scene, found);
  }
  printf("%s  %s%zu of %zu pairs collide (%s), %.3f s\n",
         hit(found)                ? "COLLISION"
         : found->warned.count > 0 ? "WARNING"
                                   : "FREE",
         o->first && found->pairs.count > 0 ? "at least " : "", found->pairs.count,
         scene->count[0] * scene->count[1], sepax_arch_name(o->config.arch), found->seconds);
}

static json_t *pairs_as_json(const sepax_pairs *pairs) {
  json_t *list = json_array();
  for (size_t k = 0; k < pairs->count; k++) {
    json_array_append_new(
        list, json_pack("[I, I]", (json_int_t)pairs->pair[k][0], (json_int_t)pairs->pair[k][1]));
  }
  return list;
}

static void print_json(const check_options *o, const sepax_design *design, const sepax_scene *scene,
                       const collisions *found) {
  json_int_t pairs = (json_int_t)scene->count[0] * (json_int_t)scene->count[1];
  json_t *report =
      json_pack("{s:s, s:I, s:I, s:b, s:b, s:f, s:o}", "arch", sepax_arch_name(o->config.arch),
                "pairs", pairs, "collisions", (json_int_t)found->pairs.count, "a_inside_b",
                found->within[0], "b_inside_a", found->within[1], "seconds", found->seconds,
                "colliding", pairs_as_json(&found->pairs));
  json_t *files = report_scene(o->path, scene->count, &scene->grid);
  json_object_update(report, files);
  json_decref(files);
  if (design->limits > 0) {
    json_int_t free = pairs - (json_int_t)(found->pairs.count + found->warned.count);
    json_object_set_new(report, "clearance", json_integer(design->config.clearance));
    json_object_set_new(report, "free", json_integer(free));
    json_object_set_new(report, "warnings", json_integer((json_int_t)found->warned.count));
  }
  if (design->limits > 1) {
    json_object_set_new(report, "warning", json_integer(design->config.warning));
    json_object_set_new(report, "warned", pairs_as_json(&found->warned));
  }
  report_print_json(report);
}

static bool same_file(const char *p, const char *q) {
  struct stat a;
  struct stat b;
  return strcmp(p, q) == 0 ||
         (stat(p, &a) == 0 && stat(q, &b) == 0 && a.st_dev == b.st_dev && a.st_ino == b.st_ino);
}

/* What is written must not be what is read, nor one file be written twice. */
static bool outputs_distinct(const check_options *o, sepax_error *error) {
  const char *const outputs[] = {o->pairs_path, o->ply_path};
  for (int i = 0; i < 4; i++) {
    const char *output = outputs[i % 2];
    if (output != NULL && same_file(output, o->path[i / 2])) {
      return sepax_fail(error, "%.300s: is read; name another file to write", output);
    }
  }
  if (o->pairs_path != NULL && o->ply_path != NULL && same_file(o->pairs_path, o->ply_path)) {
    return sepax_fail(error, "%.300s: --pairs and --ply name one file; name two", o->ply_path);
  }
  return true;
}

static bool normals_read(const check_options *o, sepax_error *error) {
  return !o->grid.file_normals || o->config.arch == SEPAX_ARCH_PAPER ||
         o->config.arch == SEPAX_ARCH_CONFERENCE ||
         sepax_fail(error, "normals: architecture %s reads none; give --arch=paper, too",
                    sepax_arch_name(o->config.arch));
}

/* The checks that need no mesh. */
static bool clearances_make_sense(const check_options *o, sepax_error *error) {
  if (o->clearance < 0 && o->warning < 0) {
    return true;
  }
  if (o->clearance < 0) {
    return sepax_fail(error,
                      "warning: there is no clearance to warn before; give --clearance, too");
  }
  if (o->warning >= 0 && o->warning <= o->clearance) {
    return sepax_fail(error, "warning: %g is not above the clearance of %g", o->warning,
                      o->clearance);
  }
  if (o->config.arch != SEPAX_ARCH_EXACT) {
    return sepax_fail(error,
                      "clearance: architecture %s has none; leave it out, or give --arch=exact",
                      sepax_arch_name(o->config.arch));
  }
  if (o->config.extent_a != 0 || o->config.extent_b != 0) {
    return sepax_fail(error, "clearance: not with extents here; leave one of them out");
  }
  if (o->first) {
    return sepax_fail(error,
                      "first: all bands are counted with a clearance; leave one of them out");
  }
  return true;
}

static bool write_csv(FILE *out, const void *context) {
  const sepax_pairs *pairs = context;
  bool ok = fputs("a,b\n", out) != EOF;
  for (size_t k = 0; k < pairs->count && ok; k++) {
    ok = fprintf(out, "%zu,%zu\n", pairs->pair[k][0], pairs->pair[k][1]) > 0;
  }
  return ok;
}

static bool write_files(const check_options *o, const sepax_scene *scene, const sepax_pairs *pairs,
                        sepax_error *error) {
  return (o->pairs_path == NULL || sepax_write_file(o->pairs_path, write_csv, pairs, error)) &&
         (o->ply_path == NULL || sepax_ply_write(scene, pairs, o->ply_path, error));
}

int cli_check(int argc, char **argv) {
  static const struct argp_child children[] = {
      {&cli_config_argp, 0, NULL, 0}, {&cli_grid_argp, 0, NULL, 0}, {0}};
  static const struct argp argp = {
      options,
      parse,
      "A.stl B.stl",
      "Judge every pair of triangles of two STL files. Indices count facets from 0.\v"
      "Exit status: 0 free (or, with --warning, a warning), 1 collision, 2 error.",
      children,
      NULL,
      NULL};
  check_options o = {.config = sepax_config_default(), .clearance = -1, .warning = -1};
  argp_parse(&argp, argc, argv, 0, NULL, &o);
  o.grid.grid.word = o.config.word;
  sepax_error error = {""};
  sepax_design design;
  sepax_scene scene;
  if ((o.json && !report_names_printable(o.path, &error)) || !outputs_distinct(&o, &error) ||
      !normals_read(&o, &error) || !sepax_design_init(&design, &o.config, &error) ||
      !clearances_make_sense(&o, &error) ||
      !sepax_scene_load(&scene, o.path, &o.grid.grid, o.grid.file_normals, &error)) {
    return cli_fail(argv[0], &error);
  }
  collisions found = {0};
  int status = EXIT_ERROR;
  if (!set_clearances(&o, &scene.grid, &design, &error) ||
      !find(&o, &design, &scene, &found, &error) ||
      (o.solid && found.pairs.count == 0 && !sepax_solid(&scene, found.within, &error)) ||
      !write_files(&o, &scene, &found.pairs, &error)) {
    cli_fail(argv[0], &error);
  } else {
    (o.json ? print_json : print_text)(&o, &design, &scene, &found);
    status = hit(&found) ? EXIT_COLLISION : EXIT_FREE;
  }
  sepax_pairs_free(&found.warned);
  sepax_pairs_free(&found.pairs);
  sepax_scene_free(&scene);
  return status;
}
