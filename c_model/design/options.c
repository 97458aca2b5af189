/* SPDX-License-Identifier: MIT */
/* options.c - the options of a design: one table, and everything that is made of it. */
#include "design/options.h"
#include "design/architecture.h"
#include "design/paper.h"
#include "util/error.h"
#include "util/plain_numbers.h"

#include <ctype.h>
#include <errno.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ------------------------------------------------------------------ the table */

enum {
  EXACT = 1 << SEPAX_ARCH_EXACT,
  PUBLISHED = 1 << SEPAX_ARCH_PAPER | 1 << SEPAX_ARCH_CONFERENCE,
  HARDWARE = EXACT | PUBLISHED,
  ALL = (1 << SEPAX_ARCH_COUNT) - 1
};

static const char *const coplanarity_names[] = {"plane", "paper", NULL};
static const char *const inequality_names[] = {"correct", "printed", NULL};
static const char *const switch_names[] = {"off", "on", NULL};
static const char *const early_names[] = {"none", "boxes", NULL};
static const char *const coplanar_names[] = {"exact", "flag", NULL};
static const char *const stream_names[] = {"none", "vertex", "triangle", "pair", NULL};
static const char *const target_names[] = {"asic", "ice40", "ecp5", "xc7", "xcup", "gowin", NULL};

static const char *const corner_names[] = {"typical", "slow", NULL};

/* Macros for parts of a row. The first name of a choice is its default. */
#define FIELD(member) \
  .field = offsetof(sepax_config, member), .size = sizeof(((sepax_config *)0)->member)
#define CHOICES(names) .choices = (names), .low = 0, .high = sizeof(names) / sizeof((names)[0]) - 2
#define RANGE(least, most) .low = (least), .high = (most)

/* clang-format off */
static const design_option table[] = {
    {.name = "arch", .kind = OPTION_ARCH, FIELD(arch), .standard = SEPAX_ARCH_EXACT,
     RANGE(0, SEPAX_ARCH_COUNT - 1), .archs = ALL, .named = ALL, .shown = true, .tag = "%s",
     .argument = "NAME", .decides = true,
     .help = "architecture. Hardware: exact (default), paper, conference. Software only: "
             "reference, float32, float64, interval32, interval64, guigue32, guigue64, filtered"},
    {.name = "word", .letter = 'w', .kind = OPTION_NUMBER, FIELD(word), .standard = 18,
     RANGE(SEPAX_WORD_MIN, SEPAX_WORD_MAX), .archs = ALL, .named = ALL, .shown = true,
     .tag = "-w%s", .argument = "BITS", .decides = true,
     .help = "bits W of a coordinate, 4 ... 32 (default 18)"},
    {.name = "ii", .kind = OPTION_NUMBER, FIELD(ii), .standard = 3, RANGE(1, SEPAX_II_MAX),
     .archs = HARDWARE, .named = EXACT, .shown = true, .tag = "-ii%s", .argument = "CYCLES",
     .help = "initiation interval: cycles between two pairs, 1 ... 18 (default 3); paper and "
             "conference have 3 only"},
    {.name = "coplanar", .kind = OPTION_CHOICE, FIELD(flag), CHOICES(coplanar_names),
     .archs = EXACT, .shown = true, .tag = "-%s", .argument = "HOW", .decides = true,
     .help = "exact: decide coplanar pairs (default); flag: call them collisions and flag them as "
             "undecided, which saves gates"},
    {.name = "clock-ns", .kind = OPTION_PERIOD, FIELD(clock_ps), .standard = 2000,
     RANGE(500, 1000000), .archs = EXACT, .shown = true, .tag = "-%sns", .argument = "PERIOD",
     .help = "clock period in ns for which pipeline registers are placed, 0.5 ... 1000 (default "
             "2)"},
    {.name = "corner", .kind = OPTION_CHOICE, FIELD(corner), CHOICES(corner_names), .archs = EXACT,
     .tag = "-%s", .argument = "NAME",
     .help = "corner of the cells for which the clock period must hold: typical (default) or slow"},
    {.name = "target", .kind = OPTION_CHOICE, FIELD(target), CHOICES(target_names), .archs = EXACT,
     .tag = "-%s", .argument = "FAMILY",
     .help = "technology: asic (default, multipliers made of gates) or an FPGA family (its own "
             "multipliers): ice40, ecp5, xc7, xcup, gowin"},
    {.name = "extent-a", .kind = OPTION_NUMBER, FIELD(extent_a), .standard = 0,
     RANGE(1, INT32_MAX), .archs = EXACT, .needs = "extent-b", .tag = "-a%s", .argument = "LSB",
     .decides = true,
     .help = "largest AABB side of a triangle of A, in LSB. An AABB test then precedes the core, "
             "and the core is smaller because it is built for triangles up to this size. A larger "
             "triangle is reported as a collision and flagged as undecided (default: no limit; "
             "needs --extent-b)"},
    {.name = "extent-b", .kind = OPTION_NUMBER, FIELD(extent_b), .standard = 0,
     RANGE(1, INT32_MAX), .archs = EXACT, .needs = "extent-a", .tag = "-b%s", .argument = "LSB",
     .decides = true,
     .help = "largest AABB side of a triangle of B, in LSB (default: no limit; needs --extent-a)"},
    {.name = "early-out", .kind = OPTION_CHOICE, FIELD(early_out), CHOICES(early_names),
     .archs = EXACT, .tag = "-%s", .argument = "HOW", .decides = true,
     .help = "boxes: put an AABB test before the core; the core idles for pairs that the test "
             "decides, which saves energy; none (default): no such test"},
    {.name = "registered-ready", .kind = OPTION_SWITCH, FIELD(registered_ready),
     CHOICES(switch_names), .archs = EXACT, .tag = "-rr", .argument = "on|off",
     .help = "put a skid buffer before the core, so that in_ready comes from a register and no "
             "input reaches it in the same cycle (default off; a core for an FPGA always has it)"},
    {.name = "clock-gating", .kind = OPTION_SWITCH, FIELD(clock_gating), CHOICES(switch_names),
     .archs = EXACT, .tag = "-cg", .argument = "on|off",
     .help = "add enables to the registers of the core. The enables follow each pair through the "
             "pipeline, so registers without a pair stand still and synthesis can gate their "
             "clocks (default off)"},
    {.name = "clearance", .kind = OPTION_NUMBER, FIELD(clearance), .standard = -1,
     RANGE(0, INT32_MAX), .archs = EXACT, .tag = "-c%s", .argument = "LSB", .decides = true,
     .help = "call a pair free only if the real triangles, before they were rounded to LSB, are "
             "farther apart than this distance (default: none)"},
    {.name = "warning", .kind = OPTION_NUMBER, FIELD(warning), .standard = 0, RANGE(1, INT32_MAX),
     .archs = EXACT, .needs = "clearance", .tag = "-d%s", .argument = "LSB", .decides = true,
     .help = "a second, larger clearance: a pair that is free at --clearance, but not at this "
             "distance, gets band 1 (warning) instead of band 0 (free) (default: none; needs "
             "--clearance)"},
    {.name = "stream", .kind = OPTION_CHOICE, FIELD(stream), CHOICES(stream_names), .archs = EXACT,
     .tag = "-%s", .argument = "WORDS",
     .help = "put AXI4-Stream around the core. One transfer carries a vertex (128 bits), a "
             "triangle (512) or a pair (1024); verdicts have 32 bits and come in order. none "
             "(default): no stream"},
    {.name = "tag", .kind = OPTION_NUMBER, FIELD(tag), .standard = 16, RANGE(1, 64),
     .archs = EXACT, .shown = true, .needs = "stream", .tag = "-t%s", .argument = "BITS",
     .help = "bits of the tag (TUSER) that a pair passes on to its verdict, 1 ... 64 (default 16; "
             "needs --stream)"},
    {.name = "lanes", .kind = OPTION_NUMBER, FIELD(lanes), .standard = 0,
     RANGE(1, SEPAX_LANES_MAX), .archs = EXACT, .tag = "-k%s", .argument = "K",
     .help = "build an object engine around the core. The engine holds two objects in memories and "
             "selects pairs with K comparator lanes, 1 ... 64 (default: no engine)"},
    {.name = "tree", .kind = OPTION_SWITCH, FIELD(tree), CHOICES(switch_names), .archs = EXACT,
     .tag = "-tree", .argument = "on|off", .decides = true,
     .help = "build a tree engine around the core; it reads bodies as trees from external memory "
             "and takes poses (default off)"},
    {.name = "cores", .kind = OPTION_NUMBER, FIELD(cores), .standard = 1,
     RANGE(1, SEPAX_CORES_MAX), .archs = EXACT, .shown = true, .needs = "lanes|tree", .tag = "x%s",
     .argument = "N",
     .help = "cores of the engine, 1 ... 8 (default 1; needs --lanes or --tree)"},
    {.name = "memory-a", .kind = OPTION_NUMBER, FIELD(memory_a), .standard = 512,
     RANGE(SEPAX_MEMORY_MIN, SEPAX_MEMORY_MAX), .archs = EXACT, .shown = true, .needs = "lanes",
     .tag = "-ma%s", .argument = "TRIANGLES",
     .help = "triangles of A that the object engine holds, a power of two, 128 ... 32768 (default "
             "512; needs --lanes)"},
    {.name = "memory-b", .kind = OPTION_NUMBER, FIELD(memory_b), .standard = 512,
     RANGE(SEPAX_MEMORY_MIN, SEPAX_MEMORY_MAX), .archs = EXACT, .shown = true, .needs = "lanes",
     .tag = "-mb%s", .argument = "TRIANGLES",
     .help = "triangles of B that the object engine holds, a power of two, 128 ... 32768 (default "
             "512; needs --lanes)"},
    {.name = "leaves", .kind = OPTION_NUMBER, FIELD(leaves), .standard = 16,
     RANGE(SEPAX_LEAVES_MIN, SEPAX_LEAVES_MAX), .archs = EXACT, .needs = "tree", .tag = "-l%s",
     .argument = "N",
     .help = "leaves of each body that the tree engine holds, a power of two, 8 ... 32 (default "
             "16; needs --tree)"},
    {.name = "rows", .kind = OPTION_NUMBER, FIELD(rows), .standard = 128,
     RANGE(SEPAX_ROWS_MIN, SEPAX_ROWS_MAX), .archs = EXACT, .needs = "tree", .tag = "-r%s",
     .argument = "N",
     .help = "rows that wait in the tree engine, a power of two, 64 ... 256 (default 128; needs "
             "--tree)"},
    {.name = "precision", .kind = OPTION_PRECISION, FIELD(guard), .standard = -1,
     RANGE(-1, 2 * SEPAX_WORD_MAX + 3), .archs = PUBLISHED, .named = PUBLISHED, .shown = true,
     .tag = "-%s", .argument = "BITS", .decides = true,
     .help = "bits kept of each intermediate result. full (default) keeps all bits, word keeps W "
             "bits, and guard=G keeps W + G bits, where G = 0 ... 2 W + 3"},
    {.name = "block-float", .kind = OPTION_SWITCH, FIELD(block_float), CHOICES(switch_names),
     .archs = PUBLISHED, .shown = true, .tag = "-bf", .argument = "on|off", .decides = true,
     .help = "before truncation, shift the three components of an axis left by the same number of "
             "bits (default off)"},
    {.name = "coplanarity", .kind = OPTION_CHOICE, FIELD(coplanarity), CHOICES(coplanarity_names),
     .archs = PUBLISHED, .shown = true, .tag = "-cop", .argument = "TEST", .decides = true,
     .help = "how a pair is tested for coplanarity, where A_k and B_k are vertices and N_A and N_B "
             "are normals. plane (default) tests B_k.N_A = A_k.N_A; paper tests A_k.N_A = "
             "B_k.N_B, which is what the paper prints"},
    {.name = "inequality", .kind = OPTION_CHOICE, FIELD(inequality), CHOICES(inequality_names),
     .archs = PUBLISHED, .shown = true, .tag = "-ineq", .argument = "FORM", .decides = true,
     .help = "form of inequality (5) in the published paper. correct (default): max A < min B; "
             "printed: max A > min B, as the paper prints the inequality"},
    {.name = "epsilon", .kind = OPTION_NUMBER, FIELD(epsilon), .standard = PAPER_EPSILON,
     RANGE(0, INT32_MAX), .archs = PUBLISHED, .shown = true, .tag = "-e%s", .argument = "LSB",
     .decides = true,
     .help = "tolerance of the test of coplanarity, in LSB (default 1; 0 means equality)"},
};
/* clang-format on */

enum { OPTIONS = sizeof table / sizeof table[0] };

const design_option *sepax__design_option_at(size_t i) { return i < OPTIONS ? &table[i] : NULL; }

static const design_option *find(const char *name) {
  for (size_t i = 0; i < OPTIONS; i++) {
    if (strcmp(table[i].name, name) == 0) {
      return &table[i];
    }
  }
  return NULL;
}

/* --------------------------------------------------------------------- values */

/* A field is an int, a bool, or an enumeration without negative values. */
static int get(const design_option *option, const sepax_config *config) {
  const char *field = (const char *)config + option->field;
  int value = 0;
  if (option->size == sizeof(bool)) {
    return *(const bool *)field;
  }
  memcpy(&value, field, sizeof value);
  return value;
}

static void set(const design_option *option, sepax_config *config, int value) {
  char *field = (char *)config + option->field;
  if (option->size == sizeof(bool)) {
    *(bool *)field = value != 0;
  } else {
    memcpy(field, &value, sizeof value);
  }
}

static bool in_range(const design_option *option, int value) {
  return value >= option->low && value <= option->high;
}

static bool is_changed(const design_option *option, const sepax_config *config) {
  return get(option, config) != option->standard;
}

bool sepax__design_option_given(const char *name, const sepax_config *config) {
  return is_changed(find(name), config);
}

static bool reads(const sepax_config *config, const design_option *option) {
  return (option->archs >> config->arch & 1) != 0;
}

static option_text text_of(const design_option *option, int value) {
  option_text text = {""};
  switch (option->kind) {
  case OPTION_ARCH:
    snprintf(text.text, sizeof text.text, "%s", sepax_arch_name((sepax_arch)value));
    break;
  case OPTION_CHOICE:
  case OPTION_SWITCH:
    snprintf(text.text, sizeof text.text, "%s", option->choices[value]);
    break;
  case OPTION_PERIOD:
    snprintf(text.text, sizeof text.text, "%g", value / 1000.0);
    break;
  case OPTION_PRECISION:
    snprintf(text.text, sizeof text.text,
             value < 0    ? "full"
             : value == 0 ? "word"
                          : "guard=%d",
             value);
    break;
  case OPTION_NUMBER:
    snprintf(text.text, sizeof text.text, "%d", value);
    break;
  }
  return text;
}

option_text sepax__design_option_value(const design_option *option, const sepax_config *config) {
  int value = get(option, config);
  if (value == option->standard && !in_range(option, value)) {
    return (option_text){""};
  }
  return text_of(option, value);
}

option_text sepax__design_option_variable(const design_option *option) {
  option_text variable = {""};
  for (size_t i = 0; option->name[i] != '\0' && i + 1 < sizeof variable.text; i++) {
    char c = option->name[i];
    variable.text[i] = (char)(c == '-' ? '_' : toupper((unsigned char)c));
  }
  return variable;
}

sepax_config sepax_config_default(void) {
  sepax_config config = {0};
  for (size_t i = 0; i < OPTIONS; i++) {
    set(&table[i], &config, table[i].standard);
  }
  return config;
}

/* -------------------------------------------------------------------- parsing */

static const char *choice_at(const design_option *option, int i) {
  return option->kind != OPTION_ARCH ? option->choices[i]
         : i < SEPAX_ARCH_COUNT      ? sepax_arch_name((sepax_arch)i)
                                     : NULL;
}

static bool parse_choice(int *value, const design_option *option, const char *text,
                         sepax_error *error) {
  char choices[128] = "";
  const char *name;
  bool by_number = option->kind == OPTION_SWITCH && text[0] != '\0' && text[1] == '\0';
  for (int i = 0; (name = choice_at(option, i)) != NULL; i++) {
    if (strcmp(name, text) == 0 || (by_number && text[0] == '0' + i)) {
      *value = i;
      return true;
    }
    size_t used = strlen(choices);
    snprintf(choices + used, sizeof choices - used, "%s%s", i > 0 ? ", " : "", name);
  }
  return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "%s: '%.40s' is none of: %s", option->name, text,
                    choices);
}

static bool parse_int(int *value, const char *option, const char *text, sepax_error *error) {
  char *end;
  errno = 0;
  long number = strtol(text, &end, 10);
  if (end == text || *end != '\0' || isspace((unsigned char)text[0])) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "%s: '%.40s' is not a whole number", option,
                      text);
  }
  if (errno == ERANGE || number < INT32_MIN || number > INT32_MAX) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "%s: %.40s is out of range", option, text);
  }
  *value = (int)number;
  return true;
}

static bool parse_period(int *picoseconds, const char *option, const char *text,
                         sepax_error *error) {
  char *end;
  plain_numbers plain = plain_numbers_begin();
  double number = strtod(text, &end);
  plain_numbers_end(plain);
  bool decimal = text[strspn(text, "0123456789.eE+-")] == '\0';
  if (end == text || *end != '\0' || !decimal || !(number > 0) || number > 1000) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "%s: '%.40s' is no period in nanoseconds; give 0.5 ... 1000", option, text);
  }
  int rounded = (int)(number * 1000 + 0.5);
  if (number * 1000 - rounded > 1e-6 || rounded - number * 1000 > 1e-6) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "%s: '%.40s' has more than three decimals; round it", option, text);
  }
  *picoseconds = rounded;
  return true;
}

static bool parse_precision(int *guard, const char *option, const char *text, sepax_error *error) {
  static const char prefix[] = "guard=";
  if (strncmp(text, prefix, sizeof prefix - 1) == 0) {
    return parse_int(guard, "precision guard", text + sizeof prefix - 1, error) &&
           (*guard >= 0 ||
            sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                       "%s: guard = %d is out of range; give 0 ... 2 W + 3", option, *guard));
  }
  if (strcmp(text, "full") != 0 && strcmp(text, "word") != 0) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "%s: '%.40s' is none of: full, word, guard=BITS",
                      option, text);
  }
  *guard = text[0] == 'f' ? -1 : 0;
  return true;
}

static bool out_of_range(const design_option *option, int value, sepax_error *error) {
  const char *unit = strcmp(option->argument, "LSB") == 0 ? " LSB" : "";
  return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "%s: %s%s is out of range; give %s ... %s",
                    option->name, text_of(option, value).text, unit,
                    text_of(option, option->low).text, text_of(option, option->high).text);
}

static bool parse(int *value, const design_option *option, const char *text, sepax_error *error) {
  switch (option->kind) {
  case OPTION_PERIOD:
    return parse_period(value, option->name, text, error);
  case OPTION_PRECISION:
    return parse_precision(value, option->name, text, error);
  case OPTION_NUMBER:
    /* A user says "none" by leaving the option out, not by the number that stands for it. */
    return parse_int(value, option->name, text, error) &&
           (*value >= 0 || option->low < 0 || out_of_range(option, *value, error));
  default:
    return parse_choice(value, option, text, error);
  }
}

bool sepax_config_set(sepax_config *config, const char *name, const char *value,
                      sepax_error *error) {
  const design_option *option = find(name);
  if (option == NULL) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "'%.40s' is not a design option; 'sepax name --list' lists them", name);
  }
  int number = option->standard;
  bool none = value[0] == '\0' && !in_range(option, number);
  if (!none && !parse(&number, option, value, error)) {
    return false;
  }
  set(option, config, number);
  return true;
}

bool sepax_config_parse(sepax_config *config, const char *text, sepax_error *error) {
  char copy[512];
  if (strlen(text) >= sizeof copy) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "configuration text is longer than %zu characters", sizeof copy - 1);
  }
  strcpy(copy, text);
  sepax_config parsed = *config;
  char *rest = NULL;
  for (char *word = strtok_r(copy, " ", &rest); word != NULL; word = strtok_r(NULL, " ", &rest)) {
    char *value = strchr(word, '=');
    if (strncmp(word, "--", 2) != 0 || value == NULL) {
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "configuration: '%.40s' is not --NAME=VALUE",
                        word);
    }
    *value = '\0';
    if (!sepax_config_set(&parsed, word + 2, value + 1, error)) {
      return false;
    }
  }
  *config = parsed;
  return true;
}

/* ----------------------------------------------------------------------- text */

/* True if the option needs no other option, or if one of the options that it needs was given. */
static bool is_founded(const design_option *option, const sepax_config *config) {
  const char *needs = option->needs;
  bool founded = needs == NULL;
  while (needs != NULL) {
    option_text one;
    snprintf(one.text, sizeof one.text, "%.*s", (int)strcspn(needs, "|"), needs);
    founded = founded || sepax__design_option_given(one.text, config);
    needs = strchr(needs, '|');
    needs = needs != NULL ? needs + 1 : NULL;
  }
  return founded;
}

bool sepax_config_setting(const sepax_config *config, size_t i, sepax_setting *setting) {
  for (size_t k = 0; k < OPTIONS; k++) {
    const design_option *option = &table[k];
    bool shown = option->shown ? is_founded(option, config) : is_changed(option, config);
    if (reads(config, option) && shown && i-- == 0) {
      setting->name = option->name;
      setting->is_number = option->kind == OPTION_NUMBER || option->kind == OPTION_PERIOD;
      snprintf(setting->value, sizeof setting->value, "%s",
               text_of(option, get(option, config)).text);
      return true;
    }
  }
  return false;
}

/* Append to text[size]; what does not fit is cut. */
static void __attribute__((format(printf, 4, 5)))
append(char *text, size_t size, size_t *used, const char *format, ...) {
  va_list args;
  va_start(args, format);
  int more = vsnprintf(text + *used, size - *used, format, args);
  va_end(args);
  *used += more > 0 ? (size_t)more : 0;
  *used = *used >= size ? size - 1 : *used;
}

char *sepax_config_text(const sepax_config *config, char *text, size_t size) {
  sepax_setting setting;
  size_t used = 0;
  for (size_t i = 0; size > 0 && sepax_config_setting(config, i, &setting); i++) {
    append(text, size, &used, "%s--%s=%s", i > 0 ? " " : "", setting.name, setting.value);
  }
  return text;
}

char *sepax_config_variables(const sepax_config *config, char *text, size_t size) {
  sepax_setting setting;
  size_t used = 0;
  for (size_t i = 0; size > 0 && sepax_config_setting(config, i, &setting); i++) {
    append(text, size, &used, "%s%s=%s", i > 0 ? " " : "",
           sepax__design_option_variable(find(setting.name)).text, setting.value);
  }
  return text;
}

char *sepax_config_name(const sepax_config *config, char *text, size_t size) {
  size_t used = 0;
  for (size_t i = 0; size > 0 && i < OPTIONS; i++) {
    const design_option *option = &table[i];
    bool named = (option->named >> config->arch & 1) != 0;
    if (!reads(config, option) || (!named && !is_changed(option, config))) {
      continue;
    }
    const char *value = strstr(option->tag, "%s");
    int head = value != NULL ? (int)(value - option->tag) : (int)strlen(option->tag);
    append(text, size, &used, "%.*s", head, option->tag);
    if (value != NULL) {
      append(text, size, &used, "%s%s", text_of(option, get(option, config)).text, value + 2);
    }
  }
  char *sign = size > 0 ? strchr(text, '=') : NULL; /* guard=4 becomes guard4 */
  if (sign != NULL) {
    memmove(sign, sign + 1, strlen(sign));
  }
  return text;
}

/* ---------------------------------------------------------------------- check */

static bool check_value(const design_option *option, int value, sepax_error *error) {
  return value == option->standard || in_range(option, value) || out_of_range(option, value, error);
}

bool sepax__design_options_check(const sepax_config *config, sepax_error *error) {
  if ((unsigned)config->arch >= SEPAX_ARCH_COUNT) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "configuration: arch has a value that is not in its enumeration");
  }
  for (size_t i = 0; i < OPTIONS; i++) {
    const design_option *option = &table[i];
    if (is_changed(option, config) && !reads(config, option)) {
      int owner = 0;
      while ((option->archs >> owner & 1) == 0) {
        owner++;
      }
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "%s: architecture %s has no such option; leave it out, or give --arch=%s",
                        option->name, sepax_arch_name(config->arch),
                        sepax_arch_name((sepax_arch)owner));
    }
    if (!check_value(option, get(option, config), error)) {
      return false;
    }
    if (is_changed(option, config) && !is_founded(option, config)) {
      int one = (int)strcspn(option->needs, "|");
      const char *other = option->needs[one] != '\0' ? option->needs + one + 1 : NULL;
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "%s: has an effect only with --%.*s%s%s; give --%.*s, too", option->name,
                        one, option->needs, other != NULL ? " or --" : "",
                        other != NULL ? other : "", one, option->needs);
    }
  }
  return true;
}
