/* SPDX-License-Identifier: MIT */
/* options.c - the values of the options of a design: from text, as text, checked. */
#include "design/options.h"
#include "design/architecture.h"
#include "util/error.h"
#include "util/plain_numbers.h"

#include <ctype.h>
#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const design_option *find(const char *name) {
  const design_option *option;
  for (size_t i = 0; (option = sepax__design_option_at(i)) != NULL; i++) {
    if (strcmp(option->name, name) == 0) {
      break;
    }
  }
  return option;
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
  const design_option *option;
  for (size_t i = 0; (option = sepax__design_option_at(i)) != NULL; i++) {
    set(option, &config, option->standard);
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
  const design_option *option;
  for (size_t k = 0; (option = sepax__design_option_at(k)) != NULL; k++) {
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
  const design_option *option;
  for (size_t i = 0; size > 0 && (option = sepax__design_option_at(i)) != NULL; i++) {
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
  const design_option *option;
  for (size_t i = 0; (option = sepax__design_option_at(i)) != NULL; i++) {
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
