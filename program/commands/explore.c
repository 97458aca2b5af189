/* SPDX-License-Identifier: MIT */
/* explore.c - sepax explore: a page with all designs of a word length and clock, to choose one.
 * explore.html is the page; the estimates of the designs are inserted. */
#include "cli/cli.h"
#include "command_table.h"
#include "commands/estimates.h"
#include "util/error.h"
#include "util/write_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
  sepax_config config; /* what all designs have in common */
  const char *file;
} explore_options;

/* Design options that hold for all designs. Their help is that of sepax gen. */
static const char *const common[] = {"word",      "clock-ns",     "corner",
                                     "clearance", "warning",      "extent-a",
                                     "extent-b",  "clock-gating", "registered-ready"};
enum { COMMON = sizeof common / sizeof common[0], KEY_COMMON = 0x400 };

static const struct argp_option options[] = {
    {"output", 'o', "PAGE", 0, "file for the page, one HTML file that needs no network", 0},
    {"word", 'w', "BITS", 0, "bits W of a coordinate, 4 ... 32 (default 18)", 0},
    {"clock-ns", KEY_COMMON + 1, "PERIOD", 0, "clock period in ns, 0.5 ... 1000 (default 2)", 0},
    {"corner", KEY_COMMON + 2, "NAME", 0, "typical (default) or slow", 0},
    {"clearance", KEY_COMMON + 3, "LSB", 0, "as in sepax gen", 0},
    {"warning", KEY_COMMON + 4, "LSB", 0, "as in sepax gen", 0},
    {"extent-a", KEY_COMMON + 5, "LSB", 0, "as in sepax gen", 0},
    {"extent-b", KEY_COMMON + 6, "LSB", 0, "as in sepax gen", 0},
    {"clock-gating", KEY_COMMON + 7, "on|off", OPTION_ARG_OPTIONAL, "as in sepax gen", 0},
    {"registered-ready", KEY_COMMON + 8, "on|off", OPTION_ARG_OPTIONAL, "as in sepax gen", 0},
    {0}};

static error_t parse(int key, char *text, struct argp_state *state) {
  explore_options *o = state->input;
  int option = key == 'w' ? 0 : key - KEY_COMMON;
  if (option >= 0 && option < COMMON) {
    sepax_error error = {0};
    if (!sepax_config_set(&o->config, common[option], text != NULL ? text : "on", &error)) {
      argp_error(state, "%s", error.text);
    }
    return 0;
  }
  switch (key) {
  case 'o':
    o->file = text;
    return 0;
  case ARGP_KEY_ARG:
    argp_error(state, "unexpected argument '%s'", text);
    return 0;
  case ARGP_KEY_END:
    if (o->file == NULL) {
      argp_error(state, "give the file for the page with -o PAGE.html");
    }
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

/* ------------------------------------------------------------------------ designs */

typedef struct {
  json_t *designs, *refused;
  bool failed; /* without memory */
} explore_lists;

static json_t *design_json(const sepax_design *design, const sepax_estimate *estimate) {
  const sepax_config *c = &design->config;
  char text[SEPAX_CONFIG_TEXT];
  json_t *one = estimate_json(design, estimate);
  json_t *more =
      json_pack("{s:s, s:i, s:b, s:b, s:i}", "name", sepax_config_name(c, text, sizeof text), "ii",
                c->ii, "flag", c->flag, "early_out", c->early_out, "lanes", c->lanes);
  json_object_del(one, "terms");
  if (one == NULL || more == NULL || json_object_update(one, more) != 0) {
    json_decref(one);
    one = NULL;
  }
  json_decref(more);
  return one;
}

/* Add a design, or the reason why there is none: the clock is too short for it. */
static bool add_design(explore_lists *lists, const sepax_config *config, sepax_error *error) {
  sepax_design design;
  sepax_estimate estimate;
  *error = (sepax_error){0};
  if (!sepax_design_init(&design, config, error)) {
    return false;
  }
  if (!sepax_estimate_design(&design, &estimate, error)) {
    char text[SEPAX_CONFIG_TEXT];
    lists->failed |= error->code == SEPAX_ERROR_MEMORY;
    lists->failed |= json_array_append_new(lists->refused,
                                           json_pack("{s:s, s:s}", "options",
                                                     sepax_config_text(config, text, sizeof text),
                                                     "why", error->text)) != 0;
    return true;
  }
  lists->failed |= json_array_append_new(lists->designs, design_json(&design, &estimate)) != 0;
  return true;
}

/* Cores by II, with and without a verdict for coplanar pairs, with and without the AABB test: as
 * far as they go with what all designs have in common. */
static bool add_cores(explore_lists *lists, const sepax_config *base, sepax_error *error) {
  bool any = false;
  for (int ii = 1; ii <= SEPAX_II_MAX; ii++) {
    for (int kind = 0; kind < 4; kind++) {
      sepax_config c = *base;
      sepax_error fault;
      c.ii = ii;
      c.flag = (kind & 1) != 0;
      c.early_out = (kind & 2) != 0;
      bool fits = add_design(lists, &c, &fault);
      any |= fits;
      if (!fits && kind == 0) {
        *error = fault;
      }
    }
  }
  return any;
}

/* Object engines. */
static void add_engines(explore_lists *lists, const sepax_config *base) {
  static const int intervals[] = {1, 2, 3, 6, 9, 18};
  for (size_t i = 0; i < sizeof intervals / sizeof intervals[0]; i++) {
    for (int lanes = 1; lanes <= SEPAX_LANES_MAX; lanes *= 2) {
      sepax_config c = *base;
      sepax_error fault;
      c.ii = intervals[i];
      c.lanes = lanes;
      add_design(lists, &c, &fault);
    }
  }
}

/* ---------------------------------------------------------------------------- page */

extern const char explore_html[]; /* made from explore.html */

/* A callback of jansson: JSON between <script> and </script> must not contain "<". */
static int put(const char *text, size_t length, void *out) {
  for (size_t i = 0; i < length; i++) {
    if (text[i] == '<' ? fputs("\\u003c", out) == EOF : fputc(text[i], out) == EOF) {
      return -1;
    }
  }
  return 0;
}

static bool write_page(FILE *out, const void *context) {
  const char *hole = strstr(explore_html, "@data@");
  fwrite(explore_html, 1, (size_t)(hole - explore_html), out);
  bool ok = json_dump_callback(context, put, out, JSON_ENSURE_ASCII | JSON_REAL_PRECISION(7)) == 0;
  fputs(hole + strlen("@data@"), out);
  return ok && !ferror(out);
}

/* The designs of the page, to be released; NULL and an error. */
static json_t *list_designs(const sepax_config *base, sepax_error *error) {
  explore_lists lists = {json_array(), json_array(), false};
  json_t *page = NULL;
  if (add_cores(&lists, base, error)) {
    add_engines(&lists, base);
    page = json_pack("{s:s, s:i, s:f, s:s, s:O, s:O}", "version", SEPAX_VERSION, "word", base->word,
                     "clock_ns", base->clock_ps / 1000.0, "corner",
                     base->corner == SEPAX_CORNER_SLOW ? "slow" : "typical", "designs",
                     lists.designs, "refused", lists.refused);
    if (page == NULL || lists.failed) {
      json_decref(page);
      page = NULL;
      sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for the designs");
    } else if (json_array_size(lists.designs) == 0) {
      const char *why = json_string_value(json_object_get(json_array_get(lists.refused, 0), "why"));
      sepax_fail(error, SEPAX_ERROR_ARGUMENT, "%s", why);
      json_decref(page);
      page = NULL;
    }
  }
  json_decref(lists.designs);
  json_decref(lists.refused);
  return page;
}

int cli_explore(int argc, char **argv) {
  static const struct argp argp = {
      options,
      parse,
      NULL,
      "Write a page with all designs of a word length and clock: gates against pairs a second, "
      "energy and latency, the best of them, filters, and the command that generates a design. The "
      "figures are estimates (sepax gen --estimate).",
      NULL,
      NULL,
      NULL};
  explore_options o = {.config = sepax_config_default()};
  cli_parse(&argp, argc, argv, &o);
  sepax_error error = {0};
  if (!sepax__write_file_possible(o.file, &error)) {
    return cli_fail("sepax explore", &error);
  }
  json_t *page = list_designs(&o.config, &error);
  bool ok = page != NULL && sepax_write_file(o.file, write_page, page, &error);
  size_t designs = json_array_size(json_object_get(page, "designs"));
  size_t refused = json_array_size(json_object_get(page, "refused"));
  json_decref(page);
  if (!ok) {
    return cli_fail("sepax explore", &error);
  }
  printf("%s: %zu designs of W = %d at %g ns", o.file, designs, o.config.word,
         o.config.clock_ps / 1000.0);
  printf(refused > 0 ? ", %zu more need a slower clock\n" : "\n", refused);
  return EXIT_SUCCESS;
}
