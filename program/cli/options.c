/* SPDX-License-Identifier: MIT */
/* options.c - options, messages and progress that the subcommands share. */
#include "cli.h"
#include "design/options.h"
#include "util/error.h"
#include "sepax_design.h"
#include "sepax_vectors.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

int cli_fail(const char *name, const sepax_error *error) {
  fprintf(stderr, "%s: %s\n", name, error->text);
  return EXIT_ERROR;
}

/* ------------------------------------------------------------- configuration */

enum { MOST = 64, KEY_OPTION = 0x100, KEY_ENVIRONMENT = KEY_OPTION + MOST };

/* The design's options for argp, with titles: all of them, and those that a verdict depends on.
 * cli_options_init fills them in from c_model/design/option_table.c. */
static struct argp_option config_options[MOST];
static struct argp_option verdict_options[MOST];

const char *cli_options_title(unsigned archs) {
  static struct {
    unsigned archs;
    char text[128];
  } title[8]; /* argp keeps pointers to them */
  enum { TITLES = sizeof title / sizeof title[0] };
  char names[80] = "";
  int found = 0;
  for (int i = 0; i < SEPAX_ARCH_COUNT; i++) {
    if ((archs >> i & 1) != 0) {
      size_t used = strlen(names);
      snprintf(names + used, sizeof names - used, "%s%s", found++ > 0 ? " and " : "",
               sepax_arch_name((sepax_arch)i));
    }
  }
  if (archs == sepax__design_option_at(0)->archs || found > 2) {
    return "Design:";
  }
  int n = 0;
  while (n < TITLES - 1 && title[n].archs != 0 && title[n].archs != archs) {
    n++;
  }
  title[n].archs = archs;
  snprintf(title[n].text, sizeof title[n].text,
           "Design, architecture%s %s only:", found > 1 ? "s" : "", names);
  return title[n].text;
}

static void list_options(struct argp_option list[MOST], bool verdict) {
  const design_option *option;
  const char *title = "";
  int used = 0;
  int group = 0;
  for (size_t i = 0; (option = sepax__design_option_at(i)) != NULL && used + 3 < MOST; i++) {
    if (verdict && !option->decides) {
      continue;
    }
    const char *next = cli_options_title(option->archs);
    if (strcmp(next, title) != 0) {
      title = next;
      group++;
      list[used++] = (struct argp_option){.doc = title, .group = group};
    }
    list[used++] = (struct argp_option){
        .name = option->name,
        .key = option->letter != 0 ? option->letter : KEY_OPTION + (int)i,
        .arg = option->argument,
        .flags = option->kind == OPTION_SWITCH ? OPTION_ARG_OPTIONAL : 0,
        .doc = option->help,
    };
  }
}

void cli_options_init(void) {
  list_options(config_options, false);
  list_options(verdict_options, true);
}

static void read_environment(sepax_config *config, const struct argp_state *state) {
  const design_option *option;
  for (size_t i = 0; (option = sepax__design_option_at(i)) != NULL; i++) {
    const char *value = getenv(sepax__design_option_variable(option).text);
    sepax_error error = {0};
    if (value != NULL && !sepax_config_set(config, option->name, value, &error)) {
      argp_error(state, "%s", error.text);
    }
  }
}

static error_t parse_config(int key, char *text, struct argp_state *state) {
  const design_option *option;
  for (size_t i = 0; (option = sepax__design_option_at(i)) != NULL; i++) {
    if (key == KEY_OPTION + (int)i || (option->letter != 0 && key == option->letter)) {
      sepax_error error = {0};
      if (!sepax_config_set(state->input, option->name, text != NULL ? text : "on", &error)) {
        argp_error(state, "%s", error.text);
      }
      return 0;
    }
  }
  return ARGP_ERR_UNKNOWN;
}

const struct argp cli_config_argp = {config_options, parse_config, NULL, NULL, NULL, NULL, NULL};
const struct argp cli_verdict_argp = {verdict_options, parse_config, NULL, NULL, NULL, NULL, NULL};

static const struct argp_option environment_options[] = {
    {"environment", KEY_ENVIRONMENT, NULL, 0,
     "also take design options from environment variables: WORD for --word, CLOCK_NS for "
     "--clock-ns",
     0},
    {0}};

static error_t parse_environment(int key, char *text, struct argp_state *state) {
  (void)text;
  if (key != KEY_ENVIRONMENT) {
    return ARGP_ERR_UNKNOWN;
  }
  read_environment(state->input, state);
  return 0;
}

const struct argp cli_environment_argp = {
    environment_options, parse_environment, NULL, NULL, NULL, NULL, NULL};

/* ---------------------------------------------------------------------- grid */

enum { KEY_OFFSET = 0x200, KEY_NORMALS };

static const struct argp_option grid_options[] = {
    {NULL, 0, NULL, 0, "Quantisation:", 4},
    {"resolution", 'r', "LENGTH", 0,
     "length of one LSB, with a unit (nm, um, mm, m) or in mm; without this option, the finest "
     "grid that holds the meshes is used",
     0},
    {"offset", KEY_OFFSET, "X,Y,Z", 0,
     "point of the file, in mm, that becomes the integer origin (default 0,0,0; needs "
     "--resolution)",
     0},
    {"normals", KEY_NORMALS, "SOURCE", 0,
     "where the normals of the triangles come from. computed (default): from the rounded "
     "vertices; file: from the STL file",
     0},
    {0}};

static error_t parse_grid(int key, char *text, struct argp_state *state) {
  cli_grid *g = state->input;
  switch (key) {
  case 'r':
    g->grid.resolution = cli_length(state, "resolution", text);
    g->resolution = text;
    if (g->grid.resolution <= 0) {
      argp_error(state, "resolution: %s is not above 0", text);
    }
    return 0;
  case KEY_OFFSET:
    cli_vector(state, "offset", text, g->grid.offset);
    g->offset_given = true;
    return 0;
  case KEY_NORMALS:
    g->file_normals = strcmp(text, "file") == 0;
    if (!g->file_normals && strcmp(text, "computed") != 0) {
      argp_error(state, "normals: '%s' is none of: computed, file", text);
    }
    return 0;
  case ARGP_KEY_END:
    if (g->offset_given && g->grid.resolution == 0) {
      argp_error(
          state,
          "offset: without --resolution the offset is chosen by fitting; give --resolution, too");
    }
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

const struct argp cli_grid_argp = {grid_options, parse_grid, NULL, NULL, NULL, NULL, NULL};

/* -------------------------------------------------------------------- values */

uint64_t cli_count(const struct argp_state *state, const char *option, const char *text,
                   uint64_t least, uint64_t most) {
  char *end;
  errno = 0;
  unsigned long long value = strtoull(text, &end, 10);
  if (text[0] < '0' || text[0] > '9' || *end != '\0' || errno != 0 || value < least ||
      value > most) {
    argp_error(state, "%s: '%s' is not a whole number of %llu ... %llu", option, text,
               (unsigned long long)least, (unsigned long long)most);
  }
  return value;
}

double cli_number(const struct argp_state *state, const char *option, const char *text) {
  char *end;
  double value = strtod(text, &end);
  if (end == text || *end != '\0' || !isfinite(value)) {
    argp_error(state, "%s: '%s' is not a number", option, text);
  }
  return value;
}

/* The length of the decimal number at the beginning of the text, without an exponent; 0 if there is
 * none. */
static size_t number_length(const char *text) {
  static const char digits[] = "0123456789";
  size_t n = text[0] == '+' || text[0] == '-';
  size_t whole = strspn(text + n, digits);
  size_t fraction = text[n + whole] == '.' ? strspn(text + n + whole + 1, digits) : 0;
  n += whole + (fraction > 0 ? fraction + 1 : 0);
  return whole + fraction > 0 ? n : 0;
}

static bool digits_of(const char *text, size_t length, cli_decimal *decimal) {
  size_t used = 0;
  bool fraction = false;
  for (size_t i = 0; i < length; i++) {
    fraction = fraction || text[i] == '.';
    if (text[i] >= '0' && text[i] <= '9' && (used > 0 || text[i] != '0')) {
      if (used == CLI_DIGITS) {
        return false;
      }
      decimal->digits[used++] = text[i];
    }
    decimal->power -= fraction && text[i] != '.';
  }
  decimal->digits[used] = '\0';
  decimal->negative = text[0] == '-';
  return true;
}

const char *cli_scan_decimal(const char *text, const cli_unit *units, int unit,
                             cli_decimal *decimal) {
  size_t length = number_length(text);
  *decimal = (cli_decimal){.power = 0};
  if (length == 0 || !digits_of(text, length, decimal)) {
    return NULL;
  }
  const char *end = text + length;
  if ((*end == 'e' || *end == 'E') && number_length(end + 1) > 0) {
    char *after;
    long power = strtol(end + 1, &after, 10);
    decimal->power += (int)(power > 9999 ? 9999 : power < -9999 ? -9999 : power);
    end = after;
  }
  const cli_unit *given = units;
  while (given->name != NULL && strncmp(end, given->name, strlen(given->name)) != 0) {
    given++;
  }
  decimal->power += given->name != NULL ? given->power - unit : 0;
  return end + (given->name != NULL ? strlen(given->name) : 0);
}

const char *cli_scan(const char *text, const cli_unit *units, int unit, double *value) {
  cli_decimal decimal;
  char number[CLI_DIGITS + 24];
  const char *end = cli_scan_decimal(text, units, unit, &decimal);
  if (end == NULL) {
    return NULL;
  }
  snprintf(number, sizeof number, "%s0%se%d", decimal.negative ? "-" : "", decimal.digits,
           decimal.power);
  *value = strtod(number, NULL);
  bool lost = *value == 0 && decimal.digits[0] != '\0';
  return isfinite(*value) && !lost ? end : NULL;
}

const char *cli_scan_length(const char *text, double *value) {
  return cli_scan(text, cli_lengths, CLI_MILLIMETRES, value);
}

double cli_length(const struct argp_state *state, const char *option, const char *text) {
  double value = 0;
  const char *end = cli_scan_length(text, &value);
  if (end == NULL || *end != '\0') {
    argp_error(state, "%s: '%s' is not a length; give 2um, or 0.002 for 0.002 mm", option, text);
  }
  return value;
}

void cli_vector(const struct argp_state *state, const char *option, const char *text,
                double vector[3]) {
  const char *at = text;
  for (int i = 0; i < 3; i++) {
    char *end;
    vector[i] = strtod(at, &end);
    if (end == at || *end != (i < 2 ? ',' : '\0') || !isfinite(vector[i])) {
      argp_error(state, "%s: '%s' is not X,Y,Z", option, text);
    }
    at = end + 1;
  }
}

/* ------------------------------------------------------------------ progress */

static double seconds_between(const struct timespec *from, const struct timespec *to) {
  return (double)(to->tv_sec - from->tv_sec) + 1e-9 * (double)(to->tv_nsec - from->tv_nsec);
}

cli_progress cli_progress_begin(const char *what, uint64_t total) {
  cli_progress p = {.what = what, .total = total, .terminal = isatty(STDERR_FILENO) == 1};
  clock_gettime(CLOCK_MONOTONIC, &p.start);
  p.shown = p.start;
  return p;
}

void cli_progress_show(cli_progress *p, uint64_t done) {
  if (!p->terminal) {
    return;
  }
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  if (seconds_between(&p->shown, &now) >= 0.25) {
    p->shown = now;
    double part = p->total > 0 ? (double)done / (double)p->total : 1;
    fprintf(stderr, "\r%s: %llu of %llu (%.0f %%)", p->what, (unsigned long long)done,
            (unsigned long long)p->total, 100 * part);
    if (part > 0) {
      fprintf(stderr, ", %.0f s to go", seconds_between(&p->start, &now) * (1 / part - 1));
    }
    fputs("\033[K", stderr);
  }
}

double cli_progress_end(const cli_progress *p) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  if (p->terminal) {
    fprintf(stderr, "\r\033[K");
  }
  return seconds_between(&p->start, &now);
}

/* ------------------------------------------------------------------ families */

bool cli_families(const char *name, size_t *first, size_t *last, sepax_error *error) {
  bool all = strcmp(name, "all") == 0;
  bool found = all;
  *first = 0;
  *last = 0;
  for (size_t i = 0; sepax_family_name(i) != NULL; i++) {
    if (all || strcmp(sepax_family_name(i), name) == 0) {
      *first = all ? 0 : i;
      *last = i;
      found = true;
    }
  }
  return found || sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                             "family: '%.60s' is unknown; 'sepax vectors --list' lists them", name);
}

/* The length of the folder's name in a path; 0 if the file is in the current folder. */
static size_t folder_of(const char *path) {
  const char *slash = strrchr(path, '/');
  return slash != NULL ? (size_t)(slash - path) + 1 : 0;
}

/* True if both paths name the same entry of the same folder, also if no such file exists yet. */
static bool same_place(const char *p, const char *q) {
  struct stat folder[2];
  const char *const path[2] = {p, q};
  for (int i = 0; i < 2; i++) {
    size_t length = folder_of(path[i]);
    char *name = length > 0 ? strndup(path[i], length) : strdup(".");
    bool found = name != NULL && stat(name, &folder[i]) == 0;
    free(name);
    if (!found) {
      return false;
    }
  }
  return folder[0].st_dev == folder[1].st_dev && folder[0].st_ino == folder[1].st_ino &&
         strcmp(p + folder_of(p), q + folder_of(q)) == 0;
}

bool cli_same_file(const char *p, const char *q) {
  struct stat a;
  struct stat b;
  return strcmp(p, q) == 0 || same_place(p, q) ||
         (stat(p, &a) == 0 && stat(q, &b) == 0 && a.st_dev == b.st_dev && a.st_ino == b.st_ino);
}
