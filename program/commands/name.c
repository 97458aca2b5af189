/* SPDX-License-Identifier: MIT */
/* name.c - sepax name: answers what make and scripts ask about a design and its options. */
#include "cli/cli.h"
#include "design/engine_table.h"
#include "command_table.h"
#include "design/options.h"
#include "util/error.h"

#include <stdio.h>
#include <string.h>

typedef enum {
  PRINT_NAME,
  PRINT_TEXT,
  PRINT_MAKE,
  PRINT_LIST,
  PRINT_ONLY,
  PRINT_VERDICT
} print_what;

typedef struct {
  sepax_config config;
  print_what what;
} name_options;

enum { KEY_WHAT = 0x400 };

static const struct argp_option options[] = {
    {"options", KEY_WHAT + PRINT_TEXT, NULL, 0,
     "print the design's options: --arch=exact --word=18 ...", 0},
    {"make", KEY_WHAT + PRINT_MAKE, NULL, 0,
     "print assignments for a shell: DESIGN_NAME=..., DESIGN_ENGINE=..., OPTIONS=..., then one for "
     "each option, such as WORD=18",
     0},
    {"list", KEY_WHAT + PRINT_LIST, NULL, 0, "list all design options as variables of make", 0},
    {"only", KEY_WHAT + PRINT_ONLY, NULL, 0,
     "list the variables of make that the architecture of --arch reads and no other architecture "
     "reads",
     0},
    {"verdict", KEY_WHAT + PRINT_VERDICT, NULL, 0,
     "print those options of the design that a verdict depends on, as sepax judge takes them", 0},
    {0}};

static error_t parse(int key, char *text, struct argp_state *state) {
  name_options *o = state->input;
  switch (key) {
  case ARGP_KEY_INIT:
    state->child_inputs[0] = &o->config;
    state->child_inputs[1] = &o->config;
    return 0;
  case ARGP_KEY_ARG:
    argp_error(state, "unexpected argument '%s'", text);
    return 0;
  default:
    if (key > KEY_WHAT && key <= KEY_WHAT + (int)PRINT_VERDICT) {
      if (o->what != PRINT_NAME && o->what != (print_what)(key - KEY_WHAT)) {
        argp_error(state, "options, make, list, only, verdict: give one of them");
      }
      o->what = (print_what)(key - KEY_WHAT);
      return 0;
    }
    return ARGP_ERR_UNKNOWN;
  }
}

/* Print "  WORD=18   bits W of a coordinate ...", wrapped at 96 columns. */
static void print_row(const design_option *option, const sepax_config *standard) {
  enum { INDENT = 21, WIDTH = 96 };
  int column = printf("  %s=%s", sepax__design_option_variable(option).text,
                      sepax__design_option_value(option, standard).text);
  for (const char *word = option->help; *word != '\0';) {
    int length = (int)strcspn(word, " ");
    if (column + 1 + length > WIDTH) {
      putchar('\n');
      column = 0;
    }
    column += column < INDENT ? printf("%*s", INDENT - column, "") : 0;
    column += printf(" %.*s", length, word);
    word += length + (word[length] == ' ');
  }
  putchar('\n');
}

static void print_list(void) {
  sepax_config standard = sepax_config_default();
  const design_option *option;
  const char *last = "";
  for (size_t i = 0; (option = sepax__design_option_at(i)) != NULL; i++) {
    const char *title = cli_options_title(option->archs);
    if (strcmp(title, last) != 0) {
      printf("%s\n", title);
    }
    last = title;
    print_row(option, &standard);
  }
}

static void print_only(sepax_arch arch) {
  const design_option *option;
  for (size_t i = 0; (option = sepax__design_option_at(i)) != NULL; i++) {
    if (option->archs == 1U << arch) {
      printf("%s\n", sepax__design_option_variable(option).text);
    }
  }
}

/* "--arch=exact --word=18 ...": what sepax judge takes of the options of a design. */
static void print_verdict_options(const sepax_config *config) {
  const design_option *option;
  sepax_setting setting;
  const char *gap = "";
  for (size_t i = 0; sepax_config_setting(config, i, &setting); i++) {
    for (size_t k = 0; (option = sepax__design_option_at(k)) != NULL; k++) {
      if (option->decides && strcmp(option->name, setting.name) == 0) {
        printf("%s--%s=%s", gap, setting.name, setting.value);
        gap = " ";
      }
    }
  }
}

static void print_design(const name_options *o) {
  char name[SEPAX_CONFIG_TEXT];
  char text[SEPAX_CONFIG_TEXT];
  char variables[SEPAX_CONFIG_TEXT];
  sepax_config_name(&o->config, name, sizeof name);
  sepax_config_text(&o->config, text, sizeof text);
  sepax_config_variables(&o->config, variables, sizeof variables);
  if (o->what == PRINT_MAKE) {
    printf("DESIGN_NAME=%s DESIGN_ENGINE=%s 'OPTIONS=%s' 'VERDICT_OPTIONS=", name,
           sepax__engine_name(sepax__config_engine(&o->config)), text);
    print_verdict_options(&o->config);
    printf("' %s\n", variables);
  } else {
    puts(o->what == PRINT_TEXT ? text : name);
  }
}

int cli_name(int argc, char **argv) {
  static const struct argp_child children[] = {
      {&cli_config_argp, 0, NULL, 0}, {&cli_environment_argp, 0, NULL, 0}, {0}};
  static const struct argp argp = {
      options,  parse,
      NULL,     "Print the name of a design, which is also the name of its folder in build/core.",
      children, NULL,
      NULL};
  name_options o = {.config = sepax_config_default()};
  cli_parse(&argp, argc, argv, &o);
  sepax_error error = {0};
  if (!sepax_config_check(&o.config, &error)) {
    return cli_fail(argv[0], &error);
  }
  if (o.what == PRINT_LIST) {
    print_list();
  } else if (o.what == PRINT_ONLY) {
    print_only(o.config.arch);
  } else if (o.what == PRINT_VERDICT) {
    print_verdict_options(&o.config);
    putchar('\n');
  } else {
    print_design(&o);
  }
  return 0;
}
