/* SPDX-License-Identifier: MIT */
/* parse.c - reads a command line: argp, after a look at what argp would pass over. */
#include "cli/cli.h"

#include <getopt.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { OPTIONS_MOST = 128, LONG_VALUE = 0x1000 };

/* All options of a command, its own and those of the argps that it includes, as getopt_long takes
 * them. The value of each long option is LONG_VALUE plus its place in `of`. */
typedef struct {
  const struct argp_option *of[OPTIONS_MOST];
  const char *value[OPTIONS_MOST]; /* what the user gave */
  bool given[OPTIONS_MOST];
  struct option longs[OPTIONS_MOST + 1];
  char shorts[3 * OPTIONS_MOST + 1];
  int count;
} option_list;

static void add_option(option_list *all, const struct argp_option *option) {
  int argument = option->arg == NULL                          ? no_argument
                 : (option->flags & OPTION_ARG_OPTIONAL) != 0 ? optional_argument
                                                              : required_argument;
  all->of[all->count] = option;
  all->longs[all->count] = (struct option){option->name, argument, NULL, LONG_VALUE + all->count};
  if (option->key > ' ' && option->key < 0x7F) {
    size_t used = strlen(all->shorts);
    all->shorts[used] = (char)option->key;
    memcpy(all->shorts + used + 1, "::", (size_t)argument);
    all->shorts[used + 1 + (size_t)argument] = '\0';
  }
  all->count++;
}

static void add_options(option_list *all, const struct argp *argp) {
  const struct argp_option *option = argp->options;
  for (; option != NULL && (option->name != NULL || option->doc != NULL); option++) {
    if (option->name != NULL && all->count < OPTIONS_MOST) {
      add_option(all, option);
    }
  }
  const struct argp_child *child = argp->children;
  for (; child != NULL && child->argp != NULL; child++) {
    add_options(all, child->argp);
  }
}

/* The place of what getopt_long found; -1 if it knows no such option, which argp will say. */
static int place_of(const option_list *all, int found) {
  for (int n = 0; n < all->count; n++) {
    if (found == LONG_VALUE + n || found == all->of[n]->key) {
      return n;
    }
  }
  return -1;
}

static void refuse(const char *name, const char *format, ...)
    __attribute__((format(printf, 2, 3), noreturn));
static void refuse(const char *name, const char *format, ...) {
  va_list values;
  va_start(values, format);
  fprintf(stderr, "%s: ", name);
  vfprintf(stderr, format, values);
  fputc('\n', stderr);
  va_end(values);
  exit(EXIT_ERROR);
}

/* The value of a switch that is given without one is that of --SWITCH=on. */
static const char *told(const char *value) { return value != NULL ? value : "on"; }

static void check_option(option_list *all, int n, const char *value, const char *name) {
  const struct argp_option *option = all->of[n];
  bool file = option->arg != NULL && strcmp(option->arg, "FILE") == 0;
  bool folder = option->arg != NULL && strcmp(option->arg, "DIR") == 0;
  if ((file || folder) && value[0] == '\0') {
    refuse(name, "%s: the name is empty; name a %s", option->name, file ? "file" : "folder");
  }
  if (folder && strcmp(value, "-") == 0) {
    refuse(name, "%s: - is no folder; name a folder to write, or write ./-", option->name);
  }
  if (all->given[n] && (option->flags & CLI_REPEATABLE) == 0 &&
      strcmp(told(all->value[n]), told(value)) != 0) {
    refuse(name, "%s: given twice, as '%.100s' and as '%.100s'; give it once", option->name,
           told(all->value[n]), told(value));
  }
  all->given[n] = true;
  all->value[n] = value;
}

void cli_parse(const struct argp *argp, int argc, char **argv, void *input) {
  static option_list all;
  char **words = malloc(((size_t)argc + 1) * sizeof *words); /* getopt_long changes their order */
  if (words == NULL) {
    refuse(argv[0], "no memory for %d arguments", argc);
  }
  memcpy(words, argv, ((size_t)argc + 1) * sizeof *words);
  all = (option_list){.count = 0};
  add_options(&all, argp);
  opterr = 0;
  int found;
  while ((found = getopt_long(argc, words, all.shorts, all.longs, NULL)) != -1) {
    int n = place_of(&all, found);
    if (n >= 0) {
      check_option(&all, n, optarg, argv[0]);
    }
  }
  int empty = optind;
  while (empty < argc && words[empty][0] != '\0') {
    empty++;
  }
  free(words);
  if (empty < argc) {
    refuse(argv[0], "argument %d is empty; give a name", empty - optind + 1);
  }
  argp_parse(argp, argc, argv, 0, NULL, input);
}
