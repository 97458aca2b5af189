/* config.c - the configuration that model, generator and benches share, and the
 * fixed-point formats that follow from it by interval analysis (docs/paper.md). */
#include "util/error.h"
#include "sepax_design.h"

#include <ctype.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>

typedef __int128 wide;

int32_t sepax_word_min(int word) { return (int32_t)(-(INT64_C(1) << (word - 1))); }

int32_t sepax_word_max(int word) { return (int32_t)((INT64_C(1) << (word - 1)) - 1); }

/* ------------------------------------------------------------- names and text */

static const char *const arch_names[] = {"paper",      "exact",      "reference",
                                         "float32",    "float64",    "interval32",
                                         "interval64", "conference", NULL};
static const char *const coplanarity_names[] = {"plane", "paper", NULL};
static const char *const inequality_names[] = {"correct", "printed", NULL};
static const char *const switch_names[] = {"off", "on", NULL};
static const char *const early_names[] = {"none", "boxes", NULL};
static const char *const coplanar_names[] = {"exact", "flag", NULL};

const char *sepax_arch_name(sepax_arch arch) { return arch_names[arch]; }

/* The machines of the paper have the same choices and formats. */
static bool is_published(sepax_arch arch) {
  return arch == SEPAX_ARCH_PAPER || arch == SEPAX_ARCH_CONFERENCE;
}

static bool parse_name(int *value, const char *option, const char *const names[], const char *text,
                       sepax_error *error) {
  char choice[128] = "";
  for (int i = 0; names[i] != NULL; i++) {
    if (strcmp(names[i], text) == 0) {
      *value = i;
      return true;
    }
    size_t used = strlen(choice);
    snprintf(choice + used, sizeof choice - used, "%s%s", i > 0 ? ", " : "", names[i]);
  }
  return sepax_fail(error, "%s: '%.40s' is none of: %s", option, text, choice);
}

static bool parse_int(int *value, const char *option, const char *text, sepax_error *error) {
  char *end;
  errno = 0;
  long number = strtol(text, &end, 10);
  if (end == text || *end != '\0' || isspace((unsigned char)text[0])) {
    return sepax_fail(error, "%s: '%.40s' is not a whole number", option, text);
  }
  if (errno == ERANGE || number < INT32_MIN || number > INT32_MAX) {
    return sepax_fail(error, "%s: %.40s is out of range", option, text);
  }
  *value = (int)number;
  return true;
}

/* Nanoseconds, at most three decimals, as picoseconds. */
static bool parse_clock(int *picoseconds, const char *text, sepax_error *error) {
  char *end;
  double number = strtod(text, &end);
  if (end == text || *end != '\0' || !(number > 0) || number > 1000) {
    return sepax_fail(error, "clock-ns: '%.40s' is no period in nanoseconds; give 0.5 ... 20",
                      text);
  }
  int rounded = (int)(number * 1000 + 0.5);
  if (number * 1000 - rounded > 1e-6 || rounded - number * 1000 > 1e-6) {
    return sepax_fail(error, "clock-ns: '%.40s' has more than three decimals; round it", text);
  }
  *picoseconds = rounded;
  return true;
}

static bool parse_precision(sepax_config *config, const char *text, sepax_error *error) {
  static const char guard[] = "guard=";
  if (strcmp(text, "full") == 0) {
    config->full = true;
    config->guard = 0;
    return true;
  }
  int bits = 0;
  if (strncmp(text, guard, sizeof guard - 1) == 0) {
    if (!parse_int(&bits, "precision guard", text + sizeof guard - 1, error)) {
      return false;
    }
  } else if (strcmp(text, "word") != 0) {
    return sepax_fail(error, "precision: '%.40s' is none of: full, word, guard=BITS", text);
  }
  config->full = false;
  config->guard = bits;
  return true;
}

sepax_config sepax_config_default(void) {
  return (sepax_config){.arch = SEPAX_ARCH_EXACT,
                        .word = 18,
                        .ii = 3,
                        .full = true,
                        .coplanarity = SEPAX_COPLANAR_PLANE,
                        .inequality = SEPAX_INEQUALITY_CORRECT,
                        .epsilon = 1,
                        .clock_ps = 2000,
                        .clearance = -1,
                        .cores = 1,
                        .memory_a = 512,
                        .memory_b = 512};
}

static bool set_clearance(sepax_config *config, int value, sepax_error *error) {
  if (value < 0) {
    return sepax_fail(error, "clearance: %d LSB is out of range; give 0 or more", value);
  }
  config->clearance = value;
  return true;
}

bool sepax_config_set(sepax_config *config, const char *name, const char *value,
                      sepax_error *error) {
  int choice = 0;
  const struct {
    const char *name;
    int *value;
  } numbers[] = {{"word", &config->word},         {"ii", &config->ii},
                 {"epsilon", &config->epsilon},   {"extent-a", &config->extent_a},
                 {"extent-b", &config->extent_b}, {"lanes", &config->lanes},
                 {"cores", &config->cores},       {"memory-a", &config->memory_a},
                 {"memory-b", &config->memory_b}, {"warning", &config->warning}};
  for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
    if (strcmp(name, numbers[i].name) == 0) {
      return parse_int(numbers[i].value, name, value, error);
    }
  }
  if (strcmp(name, "clearance") == 0) { /* that there is none is said by leaving it out */
    return parse_int(&choice, name, value, error) && set_clearance(config, choice, error);
  }
  if (strcmp(name, "clock-ns") == 0) {
    return parse_clock(&config->clock_ps, value, error);
  }
  if (strcmp(name, "coplanar") == 0) {
    bool ok = parse_name(&choice, name, coplanar_names, value, error);
    config->flag = ok ? choice == 1 : config->flag;
    return ok;
  }
  if (strcmp(name, "early-out") == 0) {
    bool ok = parse_name(&choice, name, early_names, value, error);
    config->early_out = ok ? choice == 1 : config->early_out;
    return ok;
  }
  if (strcmp(name, "precision") == 0) {
    return parse_precision(config, value, error);
  }
  if (strcmp(name, "arch") == 0) {
    bool ok = parse_name(&choice, name, arch_names, value, error);
    config->arch = ok ? (sepax_arch)choice : config->arch;
    return ok;
  }
  if (strcmp(name, "coplanarity") == 0) {
    bool ok = parse_name(&choice, name, coplanarity_names, value, error);
    config->coplanarity = ok ? (sepax_coplanarity)choice : config->coplanarity;
    return ok;
  }
  if (strcmp(name, "inequality") == 0) {
    bool ok = parse_name(&choice, name, inequality_names, value, error);
    config->inequality = ok ? (sepax_inequality)choice : config->inequality;
    return ok;
  }
  if (strcmp(name, "block-float") == 0) {
    bool ok = parse_name(&choice, name, switch_names, value, error);
    config->block_float = ok ? choice == 1 : config->block_float;
    return ok;
  }
  return sepax_fail(error, "'%.40s' is no setting of a design", name);
}

bool sepax_config_parse(sepax_config *config, const char *text, sepax_error *error) {
  char copy[512];
  if (strlen(text) >= sizeof copy) {
    return sepax_fail(error, "configuration text is longer than %zu characters", sizeof copy - 1);
  }
  strcpy(copy, text);
  sepax_config parsed = *config;
  char *rest = NULL;
  for (char *word = strtok_r(copy, " ", &rest); word != NULL; word = strtok_r(NULL, " ", &rest)) {
    char *value = strchr(word, '=');
    if (strncmp(word, "--", 2) != 0 || value == NULL) {
      return sepax_fail(error, "configuration: '%.40s' is not --NAME=VALUE", word);
    }
    *value = '\0';
    if (!sepax_config_set(&parsed, word + 2, value + 1, error)) {
      return false;
    }
  }
  *config = parsed;
  return true;
}

char *sepax_config_text(const sepax_config *config, char *text, size_t size) {
  int used = snprintf(text, size, "--arch=%s --word=%d", arch_names[config->arch], config->word);
  if (config->arch == SEPAX_ARCH_EXACT) {
    used += snprintf(text + used, size - (size_t)used, " --ii=%d --coplanar=%s --clock-ns=%g",
                     config->ii, coplanar_names[config->flag], config->clock_ps / 1000.0);
    if (config->extent_a > 0) {
      used += snprintf(text + used, size - (size_t)used, " --extent-a=%d --extent-b=%d",
                       config->extent_a, config->extent_b);
    }
    if (config->early_out) {
      used += snprintf(text + used, size - (size_t)used, " --early-out=boxes");
    }
    if (config->clearance >= 0) {
      used += snprintf(text + used, size - (size_t)used, " --clearance=%d", config->clearance);
    }
    if (config->warning > 0) {
      used += snprintf(text + used, size - (size_t)used, " --warning=%d", config->warning);
    }
    if (config->lanes > 0) {
      snprintf(text + used, size - (size_t)used,
               " --lanes=%d --cores=%d --memory-a=%d --memory-b=%d", config->lanes, config->cores,
               config->memory_a, config->memory_b);
    }
  }
  if (!is_published(config->arch)) {
    return text;
  }
  char precision[24] = "full";
  if (!config->full) {
    snprintf(precision, sizeof precision, config->guard == 0 ? "word" : "guard=%d", config->guard);
  }
  snprintf(text + used, size - (size_t)used,
           " --ii=%d --precision=%s --block-float=%s "
           "--coplanarity=%s --inequality=%s --epsilon=%d",
           config->ii, precision, switch_names[config->block_float],
           coplanarity_names[config->coplanarity], inequality_names[config->inequality],
           config->epsilon);
  return text;
}

/* What an architecture does not read must be left alone. */
static bool check_unused(const sepax_config *config, sepax_error *error) {
  sepax_config plain = sepax_config_default();
  const struct {
    const char *name;
    sepax_arch owner;
    bool changed;
  } choice[] = {
      {"precision", SEPAX_ARCH_PAPER, config->full != plain.full},
      {"block-float", SEPAX_ARCH_PAPER, config->block_float != plain.block_float},
      {"coplanarity", SEPAX_ARCH_PAPER, config->coplanarity != plain.coplanarity},
      {"inequality", SEPAX_ARCH_PAPER, config->inequality != plain.inequality},
      {"epsilon", SEPAX_ARCH_PAPER, config->epsilon != plain.epsilon},
      {"coplanar", SEPAX_ARCH_EXACT, config->flag != plain.flag},
      {"clock-ns", SEPAX_ARCH_EXACT, config->clock_ps != plain.clock_ps},
      {"extent-a", SEPAX_ARCH_EXACT, config->extent_a != 0},
      {"extent-b", SEPAX_ARCH_EXACT, config->extent_b != 0},
      {"early-out", SEPAX_ARCH_EXACT, config->early_out},
      {"lanes", SEPAX_ARCH_EXACT, config->lanes != 0},
      {"clearance", SEPAX_ARCH_EXACT, config->clearance != plain.clearance},
      {"warning", SEPAX_ARCH_EXACT, config->warning != plain.warning},
      {"ii", is_published(config->arch) ? SEPAX_ARCH_PAPER : SEPAX_ARCH_EXACT,
       config->ii != plain.ii},
  };
  sepax_arch owner = is_published(config->arch) ? SEPAX_ARCH_PAPER : config->arch;
  for (size_t i = 0; i < sizeof choice / sizeof choice[0]; i++) {
    if (choice[i].changed && owner != choice[i].owner) {
      return sepax_fail(error,
                        "%s: architecture %s has no such choice; leave it out, or give --arch=%s",
                        choice[i].name, arch_names[config->arch], arch_names[choice[i].owner]);
    }
  }
  return true;
}

/* The gap of boxes beyond which a pair is free, the outermost clearance granted. */
static int64_t outer_margin(const sepax_config *config) {
  int outer = config->warning > 0 ? config->warning : config->clearance;
  return (int64_t)outer + 1;
}

/* Boxes that meet, or are no farther apart than the margin, seen from the lowest corner of the
 * larger kind: its own coordinates reach up to its extent, the other's from minus its extent to
 * the sum of both, and that much more. */
static int core_word(const sepax_config *config) {
  int64_t a = config->extent_a;
  int64_t b = config->extent_b;
  if (a == 0 && b == 0) {
    return config->word;
  }
  int64_t range = (a > b ? a + 2 * b : 2 * a + b) + 2 * outer_margin(config);
  int bits = SEPAX_WORD_MIN;
  while (range >> bits != 0) {
    bits++;
  }
  return bits;
}

static bool check_engine(const sepax_config *config, sepax_error *error) {
  sepax_config plain = sepax_config_default();
  if (config->lanes == 0) {
    bool left_alone = config->cores == plain.cores && config->memory_a == plain.memory_a &&
                      config->memory_b == plain.memory_b;
    return left_alone ||
           sepax_fail(error,
                      "cores, memory-a, memory-b are those of an object engine; give --lanes, too");
  }
  if (config->lanes < 1 || config->lanes > SEPAX_LANES_MAX) {
    return sepax_fail(error, "lanes: %d is out of range; give 1 ... %d", config->lanes,
                      SEPAX_LANES_MAX);
  }
  if (config->cores < 1 || config->cores > 8) {
    return sepax_fail(error, "cores: %d is out of range; give 1 ... 8", config->cores);
  }
  for (int t = 0; t < 2; t++) {
    int memory = t == 0 ? config->memory_a : config->memory_b;
    if (memory < SEPAX_MEMORY_MIN || memory > SEPAX_MEMORY_MAX || (memory & (memory - 1)) != 0) {
      return sepax_fail(error, "memory-%c: %d triangles is no power of two of %d ... %d", 'a' + t,
                        memory, SEPAX_MEMORY_MIN, SEPAX_MEMORY_MAX);
    }
  }
  return true;
}

static bool check_clearance(const sepax_config *config, sepax_error *error) {
  int most = sepax_word_max(config->word);
  if (config->clearance < -1 || config->clearance > most) {
    return sepax_fail(error, "clearance: %d LSB is out of range; give 0 ... %d", config->clearance,
                      most);
  }
  if (config->warning != 0 && config->clearance < 0) {
    return sepax_fail(error,
                      "warning: there is no clearance to warn before; give --clearance, too");
  }
  if (config->warning != 0 && (config->warning <= config->clearance || config->warning > most)) {
    return sepax_fail(error, "warning: %d LSB is not above the clearance of %d and up to %d",
                      config->warning, config->clearance, most);
  }
  if (config->clearance >= 0 && config->flag) {
    return sepax_fail(
        error, "coplanar: with a clearance coplanar pairs need no second pass; leave flag out");
  }
  return true;
}

static bool check_exact(const sepax_config *config, sepax_error *error) {
  if (config->ii < 1 || config->ii > SEPAX_II_MAX) {
    return sepax_fail(error, "ii: %d is out of range; give 1 ... %d cycles", config->ii,
                      SEPAX_II_MAX);
  }
  if (!check_clearance(config, error)) {
    return false;
  }
  if (config->extent_a != 0 || config->extent_b != 0) {
    int64_t most = (INT64_C(1) << config->word) - 1;
    if (config->extent_a < 1 || config->extent_b < 1 || config->extent_a > most ||
        config->extent_b > most) {
      return sepax_fail(error,
                        "extent: %d and %d LSB; give both --extent-a and --extent-b, 1 ... %lld",
                        config->extent_a, config->extent_b, (long long)most);
    }
    if (core_word(config) >= config->word) {
      return sepax_fail(
          error, "extent: pairs that near need %d bits, no fewer than W; leave the extents out",
          core_word(config));
    }
  }
  if (config->early_out && (config->extent_a != 0 || config->lanes != 0)) {
    return sepax_fail(error, "early-out: %s test boxes before the core anyway; leave it out",
                      config->lanes != 0 ? "box lanes" : "extents");
  }
  if (config->clock_ps < 500 || config->clock_ps > 20000) {
    return sepax_fail(error, "clock-ns: %g is out of range; give 0.5 ... 20",
                      config->clock_ps / 1000.0);
  }
  return check_engine(config, error);
}

bool sepax_config_check(const sepax_config *config, sepax_error *error) {
  if (config->word < SEPAX_WORD_MIN || config->word > SEPAX_WORD_MAX) {
    return sepax_fail(error, "word: W = %d is out of range; give %d ... %d", config->word,
                      SEPAX_WORD_MIN, SEPAX_WORD_MAX);
  }
  if (config->arch > SEPAX_ARCH_CONFERENCE || config->coplanarity > SEPAX_COPLANAR_PAPER ||
      config->inequality > SEPAX_INEQUALITY_PRINTED) {
    return sepax_fail(error, "configuration: a value is none of its enumeration");
  }
  if (!check_unused(config, error)) {
    return false;
  }
  if (!is_published(config->arch)) {
    return config->arch != SEPAX_ARCH_EXACT || check_exact(config, error);
  }
  if (config->ii != 3) {
    return sepax_fail(error,
                      "ii: architecture %s takes a pair in three input cycles; "
                      "give --ii=3, not %d",
                      arch_names[config->arch], config->ii);
  }
  if (!config->full && (config->guard < 0 || config->guard > 2 * config->word + 3)) {
    return sepax_fail(error,
                      "precision: guard = %d is out of range; give 0 ... %d at "
                      "W = %d, or full",
                      config->guard, 2 * config->word + 3, config->word);
  }
  if (config->full && config->block_float) {
    return sepax_fail(error, "block-float: nothing is truncated at --precision=full; "
                             "give --precision=word or guard=BITS");
  }
  if (config->epsilon < 0 || config->epsilon > sepax_word_max(config->word)) {
    return sepax_fail(error, "epsilon: %d LSB is out of range; give 0 ... %d at W = %d",
                      config->epsilon, sepax_word_max(config->word), config->word);
  }
  return true;
}

/* ------------------------------------------------------------ interval analysis */

typedef struct {
  wide lo, hi;
} interval;

static interval hull(interval p, interval q) {
  return (interval){p.lo < q.lo ? p.lo : q.lo, p.hi > q.hi ? p.hi : q.hi};
}

static interval difference(interval p, interval q) { return (interval){p.lo - q.hi, p.hi - q.lo}; }

static interval product(interval p, interval q) {
  wide corner[] = {p.lo * q.lo, p.lo * q.hi, p.hi * q.lo, p.hi * q.hi};
  interval r = {corner[0], corner[0]};
  for (int i = 1; i < 4; i++) {
    r = hull(r, (interval){corner[i], corner[i]});
  }
  return r;
}

static interval sum_of_three(interval p) { return (interval){3 * p.lo, 3 * p.hi}; }

static int bits_of(interval p) {
  int bits = 1;
  while (p.lo < -((wide)1 << (bits - 1)) || p.hi >= (wide)1 << (bits - 1)) {
    bits++;
  }
  return bits;
}

static interval signed_word(int bits) {
  wide half = (wide)1 << (bits - 1);
  return (interval){-half, half - 1};
}

/* Enter a format that keeps at most `keep` of the bits which `range` needs, and
 * return the range that is left. */
static interval enter(sepax_design *design, sepax_format_id id, const char *name, interval range,
                      int keep) {
  int exact = bits_of(range);
  int shift = exact > keep ? exact - keep : 0;
  design->format[id] = (sepax_format){name, exact, exact - shift, shift, 0};
  design->formats = (int)id + 1;
  return (interval){range.lo >> shift, range.hi >> shift};
}

/* Enter a format of architecture exact; every bit that tells results apart is kept. */
static void enter_modular(sepax_design *design, int id, const char *name, interval terms,
                          interval result) {
  design->format[id] = (sepax_format){name, bits_of(terms), bits_of(result), 0, 0};
  design->formats = id + 1;
}

/* The same for a factor of a product that is cut into radix-4 digits, all but the highest
 * counting for one less than they say; 1 + 4 + 16 ... is added to make up for it. */
static void enter_digits(sepax_design *design, int id, const char *name, interval value) {
  int digits = (bits_of(value) + 1) / 2;
  wide offset = (((wide)1 << (2 * (digits - 1))) - 1) / 3;
  interval sum = {value.lo + offset, value.hi + offset};
  enter_modular(design, id, name, sum, sum);
  design->format[id].digits = digits;
}

static void derive_formats(sepax_design *d) {
  enum { EVERY_BIT = 127 };
  const sepax_config *c = &d->config;
  int keep = c->full ? EVERY_BIT : c->word + c->guard;
  int keep_axis_terms = c->block_float ? EVERY_BIT : keep;

  interval word = signed_word(c->word);
  interval vertex = enter(d, SEPAX_F_VERTEX, "vertex", word, keep);
  interval normal = enter(d, SEPAX_F_NORMAL, "normal", word, keep);
  interval np = enter(d, SEPAX_F_NORMAL_PRODUCT, "normal_product", product(vertex, normal), keep);
  enter(d, SEPAX_F_NORMAL_PROJECTION, "normal_projection", sum_of_three(np), keep);

  interval edge = enter(d, SEPAX_F_EDGE, "edge", difference(vertex, vertex), keep_axis_terms);
  interval cp =
      enter(d, SEPAX_F_CROSS_PRODUCT, "cross_product", product(edge, edge), keep_axis_terms);
  interval axis = enter(d, SEPAX_F_AXIS, "axis", difference(cp, cp), keep);
  if (c->block_float) {
    axis = signed_word(d->format[SEPAX_F_AXIS].width);
  }
  interval p = enter(d, SEPAX_F_PRODUCT, "product", product(vertex, axis), keep);
  enter(d, SEPAX_F_PROJECTION, "projection", sum_of_three(p), keep);
}

/* What a gap, doubled, must exceed on an axis whose components are at most so long. */
static interval limit_of(const sepax_config *c, int components, wide longest) {
  wide outer = outer_margin(c) - 1;
  return (interval){0, ((outer + 2) * components + outer) * longest};
}

/* With a clearance: components of e x f are at most twice the square of a side. */
static void derive_limits(sepax_design *d, wide side) {
  const sepax_config *c = &d->config;
  if (c->clearance < 0) {
    return;
  }
  interval cross = {-2 * side * side, 2 * side * side};
  interval limit = limit_of(c, 3, 2 * side * side);
  interval edge_limit = limit_of(c, 2, side);
  enter_modular(d, SEPAX_X_CROSS, "cross", cross, cross);
  enter_modular(d, SEPAX_X_LIMIT, "limit", limit, limit);
  enter_modular(d, SEPAX_X_EDGE_LIMIT, "edge_limit", edge_limit, edge_limit);
}

/* Formats of architecture exact: `exact` bits hold every term on the way, `width` the
 * result; sums that cancel are taken modulo 2^width. Twice the area of a triangle in a
 * square of side L is at most L^2, six times the volume of a tetrahedron in a cube 2 L^3. */
static void derive_exact_formats(sepax_design *d) {
  interval word = signed_word(d->core_word);
  interval span = hull(difference(word, word), (interval){2 * word.lo, 2 * word.hi});
  interval weight = {2 * (word.lo - word.hi), 2 * (word.hi - word.lo)};
  interval own_weight = {3 * (word.lo - word.hi), 3 * (word.hi - word.lo)};
  wide side = word.hi - word.lo;
  interval area = {-side * side, side * side};
  interval volume = {-2 * side * side * side, 2 * side * side * side};
  interval strip = product(span, span);
  enter_modular(d, SEPAX_X_COORDINATE, "coordinate", word, word);
  enter_modular(d, SEPAX_X_SPAN, "span", span, span);
  d->format[SEPAX_X_SPAN].digits = (bits_of(span) + 1) / 2;
  enter_modular(d, SEPAX_X_ORIENT2D, "area", sum_of_three(strip), area);
  enter_digits(d, SEPAX_X_Z_SUM, "weight", weight);
  enter_digits(d, SEPAX_X_OWN_Z_SUM, "own_weight", own_weight);
  enter_modular(d, SEPAX_X_ORIENT3D, "volume", product(area, own_weight), volume);
  derive_limits(d, side);
}

/* epsilon LSB of distance along a unit normal, in units of a normal projection. */
static int64_t derive_coplanar_limit(const sepax_design *d) {
  int shift = d->format[SEPAX_F_NORMAL_PRODUCT].shift + d->format[SEPAX_F_NORMAL_PROJECTION].shift;
  int64_t distance = (int64_t)d->config.epsilon << (d->config.word - 1);
  int64_t unit = INT64_C(1) << shift;
  int64_t limit = (distance + unit - 1) >> shift;
  return limit > 1 ? limit : 1;
}

bool sepax_design_init(sepax_design *design, const sepax_config *config, sepax_error *error) {
  if (!sepax_config_check(config, error)) {
    return false;
  }
  *design = (sepax_design){.config = *config};
  if (is_published(config->arch)) {
    derive_formats(design);
    design->coplanar_limit = derive_coplanar_limit(design);
    design->latency = config->arch == SEPAX_ARCH_PAPER ? 13 : 20;
  } else if (config->arch == SEPAX_ARCH_EXACT) {
    design->aabb_test = config->early_out || config->extent_a > 0;
    design->core_word = core_word(config);
    design->limits = config->clearance < 0 ? 0 : config->warning > 0 ? 2 : 1;
    design->margin[0] = (int64_t)config->clearance + 1;
    design->margin[1] = outer_margin(config);
    derive_exact_formats(design);
  }
  return true;
}
