/* SPDX-License-Identifier: MIT */
/* accuracy.c - sepax accuracy: wrong verdicts of a design, family by family or on two meshes. */
#include "accuracy_tally.h"
#include "cli/meshes.h"
#include "command_table.h"
#include "sepax_design.h"
#include "sepax_vectors.h"
#include "util/aabb.h"
#include "util/error.h"

#include <string.h>

typedef struct {
  sepax_config config;
  cli_grid grid;
  const char *file[2];
  int files;
  const char *of_families; /* the first option given that applies only to families, or NULL */
  const char *family;
  uint64_t count, flips, nudges, seed;
  bool real, csv;
} accuracy_options;

enum { KEY_FLIPS = 0x300, KEY_NUDGES, KEY_TRUTH, KEY_CSV };

static const struct argp_option options[] = {
    {"family", 'f', "NAME", 0, "family of hard pairs, or all (default all)", 0},
    {"count", 'n', "PAIRS", 0, "number of pairs of each family (default 100000)", 0},
    {"flips", KEY_FLIPS, "PAIRS", 0,
     "also judge variants of this many pairs of each family, and count the verdicts that change "
     "(default 0). In a variant the vertices have another order, the two triangles are exchanged, "
     "both triangles are moved by one vector, the axes are permuted or reflected, or all "
     "coordinates are doubled",
     0},
    {"nudges", KEY_NUDGES, "PAIRS", 0,
     "take this many pairs of each family, or of the meshes, change each coordinate by -1, 0 or 1 "
     "LSB at random, judge these pairs again, and count the verdicts that change (default 0)",
     0},
    {"seed", 's', "SEED", 0, "seed of the random numbers (default 1)", 0},
    {"truth", KEY_TRUTH, "OF", 0,
     "quantised (default): the right verdict is the exact verdict on the W-bit triangles. real: "
     "the right verdict is the exact verdict on the triangles before they were rounded to W bits "
     "(W = 4 ... 27). The coordinates of these triangles have 31 bits. After rounding, the "
     "coordinates fill half of the range of W bits",
     0},
    {"csv", KEY_CSV, NULL, 0, "print CSV instead of text", 0},
    {0}};

static error_t parse(int key, char *text, struct argp_state *state) {
  accuracy_options *o = state->input;
  switch (key) {
  case ARGP_KEY_INIT:
    state->child_inputs[0] = &o->config;
    state->child_inputs[1] = &o->grid;
    return 0;
  case 'f':
    o->of_families = "family";
    o->family = text;
    return 0;
  case 'n':
    o->of_families = "count";
    o->count = cli_count(state, "count", text, 1, UINT32_MAX);
    return 0;
  case KEY_FLIPS:
    o->of_families = "flips";
    o->flips = cli_count(state, "flips", text, 0, UINT32_MAX);
    return 0;
  case KEY_NUDGES:
    o->nudges = cli_count(state, "nudges", text, 0, UINT32_MAX);
    return 0;
  case 's':
    o->seed = cli_count(state, "seed", text, 0, UINT64_MAX);
    return 0;
  case KEY_TRUTH:
    o->of_families = "truth";
    o->real = strcmp(text, "real") == 0;
    if (!o->real && strcmp(text, "quantised") != 0) {
      argp_error(state, "truth: '%s' is neither quantised nor real", text);
    }
    return 0;
  case KEY_CSV:
    o->csv = true;
    return 0;
  case ARGP_KEY_ARG:
    if (o->files == 2) {
      argp_error(state, "unexpected argument '%s'", text);
    }
    o->file[o->files++] = text;
    return 0;
  case ARGP_KEY_END:
    if (o->files == 1) {
      argp_error(state, "give two mesh files, or none");
    }
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

/* ------------------------------------------------------------------ pairs */

enum { FINE = 31 };

static sepax_vec *vertex(sepax_pair *p, int i) { return i < 3 ? &p->a.v[i] : &p->b.v[i - 3]; }

static int32_t *component(sepax_vec *v, int axis) {
  return axis == 0 ? &v->x : axis == 1 ? &v->y : &v->z;
}

static void set_normals(sepax_pair *p, int word) {
  p->na = sepax_unit_normal(&p->a, word);
  p->nb = sepax_unit_normal(&p->b, word);
}

/* Round to a grid that is coarser by the factor 2^shift, half away from zero. */
static int32_t coarser(int32_t value, int shift) {
  int64_t half = shift > 0 ? INT64_C(1) << (shift - 1) : 0;
  int64_t size = value < 0 ? -(int64_t)value : value;
  int64_t rounded = (size + half) >> shift;
  return (int32_t)(value < 0 ? -rounded : rounded);
}

static bool is_zero(sepax_vec v) { return v.x == 0 && v.y == 0 && v.z == 0; }

static group group_of(const sepax_pair *pair) {
  return is_zero(pair->na) || is_zero(pair->nb) ? DEGENERATE : PROPER;
}

static bool judge(const sepax_design *design, const sepax_pair *pair) {
  return sepax_judge(design, pair).collision;
}

enum { BLOCK = 64 };

/* A block of pairs: as they are given, and as the design reads them. */
typedef struct {
  sepax_pair given[BLOCK], pair[BLOCK];
  group of[BLOCK];
  size_t count;
  int32_t column[18][BLOCK];
  uint64_t truth;
} block;

static void round_pair(sepax_pair *pair, int word) {
  for (int i = 0; i < 18; i++) {
    int32_t *c = component(vertex(pair, i / 3), i % 3);
    *c = coarser(*c, FINE + 1 - word);
  }
  set_normals(pair, word);
}

static void find_truth(block *b) {
  for (size_t n = 0; n < b->count; n++) {
    b->of[n] = group_of(&b->pair[n]);
    for (int i = 0; i < 18; i++) {
      b->column[i][n] = *component(vertex(&b->given[n], i / 3), i % 3);
    }
  }
  sepax_columns columns[2];
  for (int i = 0; i < 18; i++) {
    columns[i / 9].c[i / 3 % 3][i % 3] = b->column[i];
  }
  sepax_exact_pairs(SEPAX_SIMD_BEST, &columns[0], &columns[1], b->count, &b->truth);
}

static void draw_block(block *b, size_t count, const accuracy_options *o, size_t family,
                       sepax_random *random) {
  int word = o->config.word;
  b->count = count;
  for (size_t n = 0; n < count; n++) {
    b->given[n] = sepax_family_pair(family, o->real ? FINE : word, random);
    b->pair[n] = b->given[n];
    if (o->real) {
      round_pair(&b->pair[n], word);
    }
  }
  find_truth(b);
}

static void count_block(tally t[GROUPS], const sepax_design *design, const block *b, double unit) {
  for (size_t n = 0; n < b->count; n++) {
    const sepax_pair *given = &b->given[n];
    const sepax_pair *pair = &b->pair[n];
    tally *own = &t[b->of[n]];
    bool truth = (b->truth >> n & 1) != 0;
    bool settled = false;
    bool verdict = design->config.arch == SEPAX_ARCH_FILTERED
                       ? sepax_filtered(&pair->a, &pair->b, &settled)
                       : judge(design, pair);
    own->pairs++;
    own->collisions += truth;
    own->settled += settled;
    if (truth && !verdict) {
      own->missed++;
      own->deepest = fmax(own->deepest, sepax_depth(&given->a, &given->b) * unit);
    } else if (!truth && verdict) {
      own->alarms++;
      own->widest = fmax(own->widest, -sepax_depth(&given->a, &given->b) * unit);
    }
  }
}

/* Judge each pair again with every coordinate changed by -1, 0 or 1 LSB, within the word. */
static void count_nudges(tally t[GROUPS], const sepax_design *design, const block *b, size_t count,
                         sepax_random *random) {
  int word = design->config.word;
  int64_t low = sepax_word_min(word);
  int64_t high = sepax_word_max(word);
  for (size_t n = 0; n < count; n++) {
    sepax_pair nudged = b->pair[n];
    for (int i = 0; i < 18; i++) {
      int32_t *c = component(vertex(&nudged, i / 3), i % 3);
      int64_t from = *c > low ? *c - 1 : low;
      int64_t to = *c < high ? *c + 1 : high;
      *c = (int32_t)sepax_random_range(random, from, to);
    }
    set_normals(&nudged, word);
    t[b->of[n]].nudged++;
    t[b->of[n]].changed += judge(design, &nudged) != judge(design, &b->pair[n]);
  }
}

/* --------------------------------------------------------------- variants */

static const int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};

static sepax_tri reorder(const sepax_tri *t, const int order[3]) {
  return (sepax_tri){{t->v[order[0]], t->v[order[1]], t->v[order[2]]}};
}

/* True if a variant of this kind gets another verdict. */
static bool flips(const sepax_design *design, const sepax_pair *pair, int kind, bool before,
                  sepax_random *random) {
  static const int variants_of[VARIANTS] = {36, 36, 4, 48, 1};
  int word = design->config.word;
  int64_t half = INT64_C(1) << (word - 2);
  for (int n = 0; n < variants_of[kind]; n++) {
    sepax_pair variant = *pair;
    int64_t by[3] = {0, 0, 0};
    for (int axis = 0; axis < 3 && kind == 2; axis++) {
      by[axis] = sepax_random_range(random, -half, half);
    }
    if (kind <= 1) {
      variant.a = reorder(kind == 0 ? &pair->a : &pair->b, orders[n / 6]);
      variant.b = reorder(kind == 0 ? &pair->b : &pair->a, orders[n % 6]);
    }
    for (int i = 0; i < 18 && kind >= 2; i++) {
      int axis = i % 3;
      sepax_pair was = *pair;
      int32_t c = *component(vertex(&was, i / 3), kind == 3 ? orders[n / 8][axis] : axis);
      c = kind == 3 && (n >> axis) % 2 == 1 ? -c : kind == 4 ? 2 * c : (int32_t)(c + by[axis]);
      *component(vertex(&variant, i / 3), axis) = c;
    }
    set_normals(&variant, word);
    if (judge(design, &variant) != before) {
      return true;
    }
  }
  return false;
}

/* Draw pairs of W - 2 bits, so that every variant fits W bits. */
static void count_flips(tally t[GROUPS], const sepax_design *design, size_t family,
                        sepax_random *random) {
  int word = design->config.word;
  sepax_pair pair = sepax_family_pair(family, word - 2, random);
  set_normals(&pair, word);
  bool before = judge(design, &pair);
  bool any = false;
  tally *own = &t[group_of(&pair)];
  for (int kind = 0; kind < VARIANTS; kind++) {
    bool flipped = flips(design, &pair, kind, before, random);
    own->flipped[kind] += flipped;
    any = any || flipped;
  }
  own->varied++;
  own->flipped_any += any;
}

/* ----------------------------------------------------------------- studies */

static uint64_t least(uint64_t p, uint64_t q) { return p < q ? p : q; }

static void sum_groups(tally t[GROUPS]) {
  t[ANY] = t[PROPER];
  tally_add(&t[ANY], &t[DEGENERATE]);
}

static void study_family(const accuracy_options *o, const sepax_design *design, size_t family,
                         tally t[GROUPS], cli_progress *progress, uint64_t before) {
  static block drawn;
  const double lsb = o->real ? ldexp(1, o->config.word - FINE - 1) : 1;
  sepax_random random = {o->seed * 1000 + family};
  sepax_random nudging = {o->seed * 1000 + 500 + family};
  for (uint64_t n = 0; n < o->count; n += BLOCK) {
    draw_block(&drawn, least(o->count - n, BLOCK), o, family, &random);
    count_block(t, design, &drawn, lsb);
    if (n < o->nudges) {
      count_nudges(t, design, &drawn, least(o->nudges - n, drawn.count), &nudging);
    }
    cli_progress_show(progress, before + n);
  }
  for (uint64_t n = 0; n < o->flips; n++) {
    count_flips(t, design, family, &random);
    if (n % BLOCK == 0) {
      cli_progress_show(progress, before + o->count + n);
    }
  }
  sum_groups(t);
}

static void study_families(const accuracy_options *o, const sepax_design *design,
                           const row_style *style, size_t first, size_t last) {
  tally whole[GROUPS] = {{0}};
  uint64_t each = o->count + o->flips;
  cli_progress progress = cli_progress_begin("pairs", (last - first + 1) * each);
  for (size_t family = first; family <= last; family++) {
    tally t[GROUPS] = {{0}};
    study_family(o, design, family, t, &progress, (family - first) * each);
    print_rows(style, sepax_family_name(family), t, first == last);
    for (group of = ANY; of < GROUPS; of++) {
      tally_add(&whole[of], &t[of]);
    }
  }
  cli_progress_end(&progress);
  if (first < last) {
    print_rows(style, "all", whole, true);
  }
}

/* A block of pairs of meshes is full, or it is the last one. */
static void count_near(tally t[GROUPS], const accuracy_options *o, const sepax_design *design,
                       block *near, sepax_random *nudging) {
  uint64_t before = t[PROPER].pairs + t[DEGENERATE].pairs;
  find_truth(near);
  count_block(t, design, near, 1);
  if (before < o->nudges) {
    count_nudges(t, design, near, least(o->nudges - before, near->count), nudging);
  }
  near->count = 0;
}

/* Judge the pairs of triangles of two meshes whose AABBs overlap or have a gap of 1 LSB. */
static void study_meshes(const accuracy_options *o, const sepax_design *design,
                         const row_style *style, const sepax_scene *scene) {
  static block near;
  tally t[GROUPS] = {{0}};
  sepax_random nudging = {o->seed};
  cli_progress progress = cli_progress_begin("triangles of A", scene->count[0]);
  for (size_t i = 0; i < scene->count[0]; i++) {
    aabb a = aabb_of(&scene->tri[0][i]);
    for (size_t j = 0; j < scene->count[1]; j++) {
      aabb b = aabb_of(&scene->tri[1][j]);
      if (aabb_disjoint(&a, &b, 1)) {
        continue;
      }
      sepax_pair pair = sepax_scene_pair(scene, i, j);
      near.given[near.count] = pair;
      near.pair[near.count++] = pair;
      if (near.count == BLOCK) {
        count_near(t, o, design, &near, &nudging);
      }
    }
    cli_progress_show(&progress, i);
  }
  count_near(t, o, design, &near, &nudging);
  cli_progress_end(&progress);
  sum_groups(t);
  print_rows(style, "meshes", t, true);
}

static bool check(const accuracy_options *o, sepax_error *error) {
  if (o->files > 0 && o->of_families != NULL) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "%s: applies only to families; leave out the option, or the two meshes",
                      o->of_families);
  }
  if (o->files == 0 && (o->grid.grid.resolution > 0 || o->grid.file_normals)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "%s: applies only to meshes; give two mesh files, too",
                      o->grid.file_normals ? "normals" : "resolution");
  }
  if (o->real && o->config.word > FINE - 4) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "truth: real triangles are given in %d bits; give --word=%d or less", FINE,
                      FINE - 4);
  }
  if (o->flips > 0 && o->config.word < SEPAX_WORD_MIN + 2) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "flips: at --word=%d a moved pair does not fit; give %d or more",
                      o->config.word, SEPAX_WORD_MIN + 2);
  }
  return true;
}

int cli_accuracy(int argc, char **argv) {
  enum { MESH_WIDTH = 6 };
  static const struct argp_child children[] = {
      {&cli_verdict_argp, 0, NULL, 0}, {&cli_grid_argp, 0, NULL, 0}, {0}};
  static const struct argp argp = {
      options,
      parse,
      "[A.stl B.stl]",
      "Count the wrong verdicts of a design on hard pairs of triangles (pairs that touch, nearly "
      "touch, or are degenerate), or on pairs of triangles "
      "of two meshes. In meshes, a pair counts only if the AABBs of its two triangles overlap or "
      "are at most 1 LSB apart. A missed collision is a colliding pair that the design calls "
      "separated; the greatest depth of these pairs is printed, in LSB. A false alarm is a "
      "separated pair that the design calls a collision; the widest gap of these pairs is printed, "
      "in LSB.",
      children,
      NULL,
      NULL};
  accuracy_options o = {
      .config = sepax_config_default(), .family = "all", .count = 100000, .seed = 1};
  cli_parse(&argp, argc, argv, &o);
  sepax_error error = {0};
  sepax_design design;
  sepax_scene scene;
  size_t first;
  size_t last;
  o.grid.grid.word = o.config.word;
  report_mesh file[2] = {{.unit = 0}, {.unit = 0}};
  if (!sepax_design_init(&design, &o.config, &error) || !check(&o, &error) ||
      !cli_families(o.family, &first, &last, &error) ||
      (o.files > 0 && !cli_scene_load(&scene, file, o.file, NULL, &o.grid, &error))) {
    return cli_fail(argv[0], &error);
  }
  for (int i = 0; i < 2 && o.files > 0 && !o.csv; i++) {
    if (!report_mesh_is_plain(&file[i])) {
      report_print_mesh("mesh", MESH_WIDTH, o.file[i], &file[i]);
    }
  }
  char name[SEPAX_CONFIG_TEXT];
  sepax_config_text(&o.config, name, sizeof name);
  const row_style style = {.design = name,
                           .truth = o.real ? "real" : "quantised",
                           .csv = o.csv,
                           .filter = o.config.arch == SEPAX_ARCH_FILTERED};
  print_head(&style);
  if (o.files > 0) {
    study_meshes(&o, &design, &style, &scene);
    sepax_scene_free(&scene);
  } else {
    study_families(&o, &design, &style, first, last);
  }
  return 0;
}
