/* accuracy.c - sepax accuracy: wrong verdicts of a design, family by family. */
#include "cli.h"
#include "util/error.h"
#include "sepax_design.h"
#include "sepax_vectors.h"

#include <math.h>
#include <string.h>

typedef struct {
  sepax_config config;
  const char *family;
  uint64_t count, flips, seed;
  bool real, csv;
} accuracy_options;

enum { KEY_FLIPS = 0x300, KEY_TRUTH, KEY_CSV };

static const struct argp_option options[] = {
    {"family", 'f', "NAME", 0, "one family of cases, or all (all)", 0},
    {"count", 'n', "PAIRS", 0, "pairs of each family (100000)", 0},
    {"flips", KEY_FLIPS, "PAIRS", 0,
     "so many pairs of each family also in every vertex order, exchanged, moved, with axes "
     "permuted and reflected, and scaled by 2 (none)",
     0},
    {"seed", 's', "SEED", 0, "seed of the random numbers (1)", 0},
    {"truth", KEY_TRUTH, "OF", 0,
     "quantised: the verdict on the W-bit integers (default); real: on the triangles before they "
     "were rounded to W bits (4 ... 27), given 31 - W bits finer, at half the range",
     0},
    {"csv", KEY_CSV, NULL, 0, "comma-separated, for programs", 0},
    {0}};

static error_t parse(int key, char *text, struct argp_state *state) {
  accuracy_options *o = state->input;
  switch (key) {
  case ARGP_KEY_INIT:
    state->child_inputs[0] = &o->config;
    return 0;
  case 'f':
    o->family = text;
    return 0;
  case 'n':
    o->count = cli_count(state, "count", text, UINT32_MAX);
    return 0;
  case KEY_FLIPS:
    o->flips = cli_count(state, "flips", text, UINT32_MAX);
    return 0;
  case 's':
    o->seed = cli_count(state, "seed", text, UINT64_MAX);
    return 0;
  case KEY_TRUTH:
    o->real = strcmp(text, "real") == 0;
    if (!o->real && strcmp(text, "quantised") != 0) {
      argp_error(state, "truth: '%s' is neither quantised nor real", text);
    }
    return 0;
  case KEY_CSV:
    o->csv = true;
    return 0;
  case ARGP_KEY_ARG:
    argp_error(state, "unexpected argument '%s'", text);
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

/* ------------------------------------------------------------------ pairs */

enum { FINE = 31, VARIANTS = 5 };

static const char *const variant_name[VARIANTS] = {"order", "exchange", "move", "axes", "scale"};

typedef struct {
  uint64_t pairs, collisions, missed, alarms;
  uint64_t alarms_no_area; /* where a triangle is a segment or a point */
  double deepest, widest;  /* missed penetration, gap called a collision; LSB */
  uint64_t varied, flipped[VARIANTS], flipped_any;
} tally;

static sepax_vec *vertex(sepax_pair *p, int i) { return i < 3 ? &p->a.v[i] : &p->b.v[i - 3]; }

static int32_t *component(sepax_vec *v, int axis) {
  return axis == 0 ? &v->x : axis == 1 ? &v->y : &v->z;
}

static void set_normals(sepax_pair *p, int word) {
  p->na = sepax_unit_normal(&p->a, word);
  p->nb = sepax_unit_normal(&p->b, word);
}

/* Round to a grid that is 2^shift times as coarse, half away from zero. */
static int32_t coarser(int32_t value, int shift) {
  int64_t half = shift > 0 ? INT64_C(1) << (shift - 1) : 0;
  int64_t size = value < 0 ? -(int64_t)value : value;
  int64_t rounded = (size + half) >> shift;
  return (int32_t)(value < 0 ? -rounded : rounded);
}

static bool is_zero(sepax_vec v) { return v.x == 0 && v.y == 0 && v.z == 0; }

static bool judge(const sepax_design *design, const sepax_pair *pair) {
  return sepax_judge(design, pair).collision;
}

enum { BLOCK = 64 };

/* Pairs as they are given, and as the design reads them. */
typedef struct {
  sepax_pair given[BLOCK], pair[BLOCK];
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

static void draw_block(block *b, size_t count, const accuracy_options *o, size_t family,
                       sepax_random *random) {
  int word = o->config.word;
  for (size_t n = 0; n < count; n++) {
    b->given[n] = sepax_family_pair(family, o->real ? FINE : word, random);
    b->pair[n] = b->given[n];
    if (o->real) {
      round_pair(&b->pair[n], word);
    }
    for (int i = 0; i < 18; i++) {
      b->column[i][n] = *component(vertex(&b->given[n], i / 3), i % 3);
    }
  }
  sepax_columns columns[2];
  for (int i = 0; i < 18; i++) {
    columns[i / 9].c[i / 3 % 3][i % 3] = b->column[i];
  }
  sepax_exact_pairs(SEPAX_PATH_BEST, &columns[0], &columns[1], count, &b->truth);
}

static void count_block(tally *t, const sepax_design *design, const block *b, size_t count,
                        double unit) {
  for (size_t n = 0; n < count; n++) {
    const sepax_pair *given = &b->given[n];
    bool truth = (b->truth >> n & 1) != 0;
    bool verdict = judge(design, &b->pair[n]);
    t->pairs++;
    t->collisions += truth;
    if (truth && !verdict) {
      t->missed++;
      t->deepest = fmax(t->deepest, sepax_depth(&given->a, &given->b) * unit);
    } else if (!truth && verdict) {
      t->alarms++;
      t->alarms_no_area += is_zero(b->pair[n].na) || is_zero(b->pair[n].nb);
      t->widest = fmax(t->widest, -sepax_depth(&given->a, &given->b) * unit);
    }
  }
}

/* --------------------------------------------------------------- variants */

static const int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};

static sepax_tri reorder(const sepax_tri *t, const int order[3]) {
  return (sepax_tri){{t->v[order[0]], t->v[order[1]], t->v[order[2]]}};
}

/* True iff a variant of this kind has another verdict. */
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

/* Pairs of W - 2 bits, so that every variant fits W bits. */
static void count_flips(tally *t, const sepax_design *design, size_t family, sepax_random *random) {
  int word = design->config.word;
  sepax_pair pair = sepax_family_pair(family, word - 2, random);
  set_normals(&pair, word);
  bool before = judge(design, &pair);
  bool any = false;
  for (int kind = 0; kind < VARIANTS; kind++) {
    bool flipped = flips(design, &pair, kind, before, random);
    t->flipped[kind] += flipped;
    any = any || flipped;
  }
  t->varied++;
  t->flipped_any += any;
}

/* ------------------------------------------------------------------ report */

/* Ends of the 95 % interval of a share k / n (Wilson). */
static void interval_of(uint64_t k, uint64_t n, double ends[2]) {
  const double z = 1.959964;
  if (n == 0) {
    ends[0] = 0;
    ends[1] = 1;
    return;
  }
  double m = (double)n;
  double p = (double)k / m;
  double centre = p + z * z / (2 * m);
  double reach = z * sqrt(p * (1 - p) / m + z * z / (4 * m * m));
  double scale = 1 + z * z / m;
  ends[0] = k == 0 ? 0 : fmax(0, (centre - reach) / scale);
  ends[1] = fmin(1, (centre + reach) / scale);
}

static void print_head(const accuracy_options *o, const char *design) {
  if (o->csv) {
    printf("design,truth,family,pairs,collisions,missed,missed_low,missed_high,deepest_missed_lsb,"
           "false_alarms,false_low,false_high,widest_false_lsb,varied,flipped");
    for (int kind = 0; kind < VARIANTS; kind++) {
      printf(",flipped_%s", variant_name[kind]);
    }
    puts(",false_without_area");
    return;
  }
  printf("%s, truth of the %s triangles\n", design, o->real ? "real" : "quantised");
  printf("%-16s %9s %9s %9s %20s %9s %9s %20s %9s %9s\n", "family", "pairs", "collide", "missed",
         "share, 95 %", "deepest", "false", "share, 95 %", "widest", o->flips > 0 ? "flipped" : "");
}

static void print_share(uint64_t k, uint64_t n) {
  double ends[2];
  char text[40];
  interval_of(k, n, ends);
  snprintf(text, sizeof text, "%.2g ... %.2g", ends[0], ends[1]);
  printf(" %9llu %20s", (unsigned long long)k, text);
}

static void print_row(const accuracy_options *o, const char *design, const char *family,
                      const tally *t) {
  if (!o->csv) {
    printf("%-16s %9llu %9llu", family, (unsigned long long)t->pairs,
           (unsigned long long)t->collisions);
    print_share(t->missed, t->collisions);
    printf(" %9.4g", t->deepest);
    print_share(t->alarms, t->pairs - t->collisions);
    printf(" %9.4g", t->widest);
    if (t->varied > 0) {
      printf(" %7.3f %%", 100 * (double)t->flipped_any / (double)t->varied);
    }
    putchar('\n');
    return;
  }
  double missed[2];
  double alarms[2];
  interval_of(t->missed, t->collisions, missed);
  interval_of(t->alarms, t->pairs - t->collisions, alarms);
  printf("%s,%s,%s,%llu,%llu,%llu,%.4g,%.4g,%.6g,%llu,%.4g,%.4g,%.6g,%llu,%llu", design,
         o->real ? "real" : "quantised", family, (unsigned long long)t->pairs,
         (unsigned long long)t->collisions, (unsigned long long)t->missed, missed[0], missed[1],
         t->deepest, (unsigned long long)t->alarms, alarms[0], alarms[1], t->widest,
         (unsigned long long)t->varied, (unsigned long long)t->flipped_any);
  for (int kind = 0; kind < VARIANTS; kind++) {
    printf(",%llu", (unsigned long long)t->flipped[kind]);
  }
  printf(",%llu\n", (unsigned long long)t->alarms_no_area);
}

static void add(tally *sum, const tally *t) {
  sum->pairs += t->pairs;
  sum->collisions += t->collisions;
  sum->missed += t->missed;
  sum->alarms += t->alarms;
  sum->alarms_no_area += t->alarms_no_area;
  sum->deepest = fmax(sum->deepest, t->deepest);
  sum->widest = fmax(sum->widest, t->widest);
  sum->varied += t->varied;
  sum->flipped_any += t->flipped_any;
  for (int kind = 0; kind < VARIANTS; kind++) {
    sum->flipped[kind] += t->flipped[kind];
  }
}

static bool check(const accuracy_options *o, sepax_error *error) {
  if (o->real && o->config.word > FINE - 4) {
    return sepax_fail(error, "truth: real triangles are given in %d bits; give --word=%d or less",
                      FINE, FINE - 4);
  }
  if (o->flips > 0 && o->config.word < SEPAX_WORD_MIN + 2) {
    return sepax_fail(error, "flips: at --word=%d a moved pair does not fit; give %d or more",
                      o->config.word, SEPAX_WORD_MIN + 2);
  }
  return true;
}

static tally study(const accuracy_options *o, const sepax_design *design, size_t family,
                   cli_progress *progress, uint64_t before) {
  static block drawn;
  const double lsb = o->real ? ldexp(1, o->config.word - FINE - 1) : 1;
  sepax_random random = {o->seed * 1000 + family};
  tally t = {0};
  for (uint64_t n = 0; n < o->count; n += BLOCK) {
    size_t count = o->count - n < BLOCK ? (size_t)(o->count - n) : BLOCK;
    draw_block(&drawn, count, o, family, &random);
    count_block(&t, design, &drawn, count, lsb);
    cli_progress_show(progress, before + n);
  }
  for (uint64_t n = 0; n < o->flips; n++) {
    count_flips(&t, design, family, &random);
    if (n % BLOCK == 0) {
      cli_progress_show(progress, before + o->count + n);
    }
  }
  return t;
}

int cli_accuracy(int argc, char **argv) {
  static const struct argp_child children[] = {{&cli_config_argp, 0, NULL, 0}, {0}};
  static const struct argp argp = {
      options,
      parse,
      NULL,
      "Count the wrong verdicts of a design on seeded hard pairs: collisions that it misses and "
      "how deep the deepest is, false alarms and how wide the widest gap is, in LSB; and "
      "verdicts that change with the order of vertices or of triangles, a translation, a symmetry "
      "or a scale.",
      children,
      NULL,
      NULL};
  accuracy_options o = {
      .config = sepax_config_default(), .family = "all", .count = 100000, .seed = 1};
  argp_parse(&argp, argc, argv, 0, NULL, &o);
  sepax_error error = {""};
  sepax_design design;
  size_t first;
  size_t last;
  if (!sepax_design_init(&design, &o.config, &error) || !check(&o, &error) ||
      !cli_families(o.family, &first, &last, &error)) {
    return cli_fail(argv[0], &error);
  }
  char name[SEPAX_CONFIG_TEXT];
  sepax_config_text(&o.config, name, sizeof name);
  print_head(&o, name);
  tally whole = {0};
  cli_progress progress = cli_progress_begin("pairs", (last - first + 1) * (o.count + o.flips));
  for (size_t family = first; family <= last; family++) {
    tally t = study(&o, &design, family, &progress, (family - first) * (o.count + o.flips));
    print_row(&o, name, sepax_family_name(family), &t);
    add(&whole, &t);
  }
  cli_progress_end(&progress);
  if (first < last) {
    print_row(&o, name, "all", &whole);
  }
  return 0;
}
