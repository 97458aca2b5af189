/* SPDX-License-Identifier: MIT */
/* main.c - build/sepax: picks the subcommand. */
#include "cli/cli.h"
#include "command_table.h"
#include "util/temporary.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define COMMAND_ROW(name, about) {#name, cli_##name, about},
static const struct {
  const char *name;
  int (*run)(int argc, char **argv);
  const char *about;
} commands[] = {COMMANDS(COMMAND_ROW)};
enum { COMMAND_COUNT = sizeof commands / sizeof commands[0] };

/* At the end of every run, those that argp ends among them: a result that is lost is an error. */
static const char *own_name = "sepax";
static void finish_output(void) {
  if (fflush(stdout) != 0 || ferror(stdout)) {
    fprintf(stderr, "%s: standard output cannot be written; free some space\n", own_name);
    _exit(EXIT_ERROR);
  }
}

static void usage(FILE *out) {
  fprintf(out, "Usage: sepax COMMAND [OPTION...]\n"
               "Check bodies for collisions, and generate hardware for this check.\n\n");
  for (int i = 0; i < COMMAND_COUNT; i++) {
    fprintf(out, "  %-10s  %s\n", commands[i].name, commands[i].about);
  }
  fprintf(out,
          "\n'sepax COMMAND --help' lists the options of a command. 'sepax --version' prints the "
          "version.\nExit status: 0 success, 2 error. For check and path: 0 free, 1 collision, "
          "2 error,\n3 warning, 4 undecided.\n");
}

int main(int argc, char **argv) {
  argp_program_version = "sepax " SEPAX_VERSION;
  argp_err_exit_status = EXIT_ERROR;
  cli_options_init();
  atexit(finish_output);
  sepax__temporary_remove_on_signals();
  if (argc >= 2 && strcmp(argv[1], "--help") == 0) {
    usage(stdout);
    return 0;
  }
  if (argc >= 2 && (strcmp(argv[1], "--version") == 0 || strcmp(argv[1], "-V") == 0)) {
    puts(argp_program_version);
    return 0;
  }
  for (int i = 0; argc >= 2 && i < COMMAND_COUNT; i++) {
    if (strcmp(argv[1], commands[i].name) == 0) {
      static char name[32];
      snprintf(name, sizeof name, "sepax %s", commands[i].name);
      argv[1] = name;
      own_name = name;
      return commands[i].run(argc - 1, argv + 1);
    }
  }
  if (argc >= 2) {
    fprintf(stderr, "sepax: unknown command '%s'; 'sepax --help' lists all commands\n", argv[1]);
  } else {
    usage(stderr);
  }
  return EXIT_ERROR;
}
