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

#define FIELD(name) offsetof(sepax_config, name), sizeof(((sepax_config *)0)->name)

/* clang-format off */
static const design_option table[] = {
    {"arch", 0, OPTION_ARCH, FIELD(arch), SEPAX_ARCH_EXACT, 0, SEPAX_ARCH_COUNT - 1, NULL,
     ALL, ALL, true, NULL, "%s", "NAME",
     "exact (default), paper or conference; without hardware: reference, float32, float64, "
     "interval32, interval64, guigue32, guigue64, filtered"},
    {"word", 'w', OPTION_NUMBER, FIELD(word), 18, SEPAX_WORD_MIN, SEPAX_WORD_MAX, NULL,
     ALL, ALL, true, NULL, "-w%s", "BITS",
     "word length W of a coordinate, 4 ... 32 (18)"},
    {"ii", 0, OPTION_NUMBER, FIELD(ii), 3, 1, SEPAX_II_MAX, NULL,
     HARDWARE, EXACT, true, NULL, "-ii%s", "CYCLES",
     "initiation interval, paper and conference: 3; exact: 1 ... 18 (3)"},
    {"coplanar", 0, OPTION_CHOICE, FIELD(flag), 0, 0, 1, coplanar_names,
     EXACT, 0, true, NULL, "-%s", "HOW",
     "exact: decide coplanar pairs (default); flag: call them collisions and say so"},
    {"clock-ns", 0, OPTION_PERIOD, FIELD(clock_ps), 2000, 500, 20000, NULL,
     EXACT, 0, true, NULL, "-%sns", "PERIOD",
     "clock period to pipeline for, 0.5 ... 20 (2)"},
    {"corner", 0, OPTION_CHOICE, FIELD(corner), 0, 0, SEPAX_CORNER_SLOW, corner_names,
     EXACT, 0, false, NULL, "-%s", "NAME",
     "of the cells that the clock period is for: typical (default), or slow"},
    {"target", 0, OPTION_CHOICE, FIELD(target), 0, 0, SEPAX_TARGET_GOWIN, target_names,
     EXACT, 0, false, NULL, "-%s", "FAMILY",
     "what the Verilog is made for: asic (default), or FPGAs, whose multipliers it uses: ice40, "
     "ecp5, xc7, xcup, gowin"},
    {"extent-a", 0, OPTION_NUMBER, FIELD(extent_a), 0, 1, INT32_MAX, NULL,
     EXACT, 0, false, "extent-b", "-a%s", "LSB",
     "the longest side of the AABB of a triangle of A that is decided: an AABB test goes before, "
     "and what is behind it is as short as the extents allow; a larger triangle is called a "
     "collision and flagged (any; needs --extent-b)"},
    {"extent-b", 0, OPTION_NUMBER, FIELD(extent_b), 0, 1, INT32_MAX, NULL,
     EXACT, 0, false, "extent-a", "-b%s", "LSB",
     "the same of B"},
    {"early-out", 0, OPTION_CHOICE, FIELD(early_out), 0, 0, 1, early_names,
     EXACT, 0, false, NULL, "-%s", "HOW",
     "boxes: an AABB test goes before the core, which idles for the pairs that it decides; none "
     "(default)"},
    {"registered-ready", 0, OPTION_SWITCH, FIELD(registered_ready), 0, 0, 1, switch_names,
     EXACT, 0, false, NULL, "-rr", "on|off",
     "a skid buffer before the core: in_ready is a register, which no input reaches (off)"},
    {"clock-gating", 0, OPTION_SWITCH, FIELD(clock_gating), 0, 0, 1, switch_names,
     EXACT, 0, false, NULL, "-cg", "on|off",
     "registers of the core have enables, which a pair brings along: without one they stand still, "
     "and synthesis can gate their clocks (off)"},
    {"clearance", 0, OPTION_NUMBER, FIELD(clearance), -1, 0, INT32_MAX, NULL,
     EXACT, 0, false, NULL, "-c%s", "LSB",
     "call a pair free only if the real triangles are farther from each other than this, whatever "
     "the rounding to LSB did to them (none)"},
    {"warning", 0, OPTION_NUMBER, FIELD(warning), 0, 1, INT32_MAX, NULL,
     EXACT, 0, false, "clearance", "-d%s", "LSB",
     "a second, larger clearance: a band between free and collision (none)"},
    {"stream", 0, OPTION_CHOICE, FIELD(stream), SEPAX_STREAM_NONE, 0, SEPAX_STREAM_PAIR,
     stream_names, EXACT, 0, false, NULL, "-%s", "WORDS",
     "AXI4-Stream around the core: a vertex a transfer of 128 bits, a triangle of 512, or a pair "
     "of 1024; verdicts of 32 bits, in order (none)"},
    {"tag", 0, OPTION_NUMBER, FIELD(tag), 16, 1, 64, NULL,
     EXACT, 0, true, "stream", "-t%s", "BITS",
     "bits of the tag (TUSER) that goes with a pair to its verdict, 1 ... 64 (16)"},
    {"lanes", 0, OPTION_NUMBER, FIELD(lanes), 0, 1, SEPAX_LANES_MAX, NULL,
     EXACT, 0, false, NULL, "-k%s", "K",
     "an object engine with K comparator lanes, 1 ... 64, around the core (none: the core alone)"},
    {"tree", 0, OPTION_SWITCH, FIELD(tree), 0, 0, 1, switch_names,
     EXACT, 0, false, NULL, "-tree", "on|off",
     "a tree engine around the core: bodies as trees in external memory, poses (off)"},
    {"cores", 0, OPTION_NUMBER, FIELD(cores), 1, 1, SEPAX_CORES_MAX, NULL,
     EXACT, 0, true, "lanes|tree", "x%s", "N",
     "cores of the engine, 1 ... 8 (1)"},
    {"memory-a", 0, OPTION_NUMBER, FIELD(memory_a), 512, SEPAX_MEMORY_MIN, SEPAX_MEMORY_MAX, NULL,
     EXACT, 0, true, "lanes", "-ma%s", "TRIANGLES",
     "triangles of A that it holds, a power of two (512)"},
    {"memory-b", 0, OPTION_NUMBER, FIELD(memory_b), 512, SEPAX_MEMORY_MIN, SEPAX_MEMORY_MAX, NULL,
     EXACT, 0, true, "lanes", "-mb%s", "TRIANGLES",
     "the same of B"},
    {"precision", 0, OPTION_PRECISION, FIELD(guard), -1, -1, 2 * SEPAX_WORD_MAX + 3, NULL,
     PUBLISHED, PUBLISHED, true, NULL, "-%s", "BITS",
     "full: every bit of an intermediate (default); word: W bits; guard=G: W + G bits"},
    {"block-float", 0, OPTION_SWITCH, FIELD(block_float), 0, 0, 1, switch_names,
     PUBLISHED, 0, true, NULL, "-bf", "on|off",
     "shift each axis left in common before truncation (off)"},
    {"coplanarity", 0, OPTION_CHOICE, FIELD(coplanarity), 0, 0, 1, coplanarity_names,
     PUBLISHED, 0, true, NULL, "-cop", "TEST",
     "plane: B_k.N_A = A_k.N_A (default); paper: A_k.N_A = B_k.N_B, as printed"},
    {"inequality", 0, OPTION_CHOICE, FIELD(inequality), 0, 0, 1, inequality_names,
     PUBLISHED, 0, true, NULL, "-ineq", "FORM",
     "correct (default), or printed: (5) as in the paper"},
    {"epsilon", 0, OPTION_NUMBER, FIELD(epsilon), PAPER_EPSILON, 0, INT32_MAX, NULL,
     PUBLISHED, 0, true, NULL, "-e%s", "LSB",
     "tolerance of coplanarity (1; 0: equality)"},
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
  if (end == text || *end != '\0' || !(number > 0) || number > 1000) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "%s: '%.40s' is no period in nanoseconds; give 0.5 ... 20", option, text);
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
    /* "None" is said by leaving an option out, not by the number that stands for it. */
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
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "'%.40s' is no setting of a design", name);
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

/* What is needed is there: nothing, or one of the options was given. */
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

/* Append to text[size] what fits. */
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
  char *sign = size > 0 ? strchr(text, '=') : NULL; /* guard=4 */
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
                      "configuration: a value is none of its enumeration");
  }
  for (size_t i = 0; i < OPTIONS; i++) {
    const design_option *option = &table[i];
    if (is_changed(option, config) && !reads(config, option)) {
      int owner = 0;
      while ((option->archs >> owner & 1) == 0) {
        owner++;
      }
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "%s: architecture %s has no such choice; leave it out, or give --arch=%s",
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
                        "%s: nothing without --%.*s%s%s; give --%.*s, too", option->name, one,
                        option->needs, other != NULL ? " or --" : "", other != NULL ? other : "",
                        one, option->needs);
    }
  }
  return true;
}
