/* cli.h - what the subcommands of build/sepax share. */
#ifndef SEPAX_CLI_H
#define SEPAX_CLI_H

#include "cli/units.h"
#include "report/verdict.h"
#include "sepax_design.h"

#include <argp.h>
#include <time.h>
#include <unistd.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Print "NAME: text" on stderr and return EXIT_ERROR. */
int cli_fail(const char *name, const sepax_error *error);

/* argp children: the settings of sepax_config_set into a sepax_config (input:
 * sepax_config *), and --resolution --offset --normals into a cli_grid (input:
 * cli_grid *). */
extern const struct argp cli_config_argp;
void cli_options_init(void); /* once, before the first is used */
/* The title above options that these architectures (bits) read; "Design:" where most do. */
const char *cli_options_title(unsigned archs);
extern const struct argp cli_grid_argp;

typedef struct {
  sepax_grid grid;        /* resolution 0: fit both meshes into the word */
  const char *resolution; /* as it is written, or NULL */
  bool file_normals, offset_given;
} cli_grid;

/* A count of 1 ... limit; argp_error otherwise. */
uint64_t cli_count(const struct argp_state *state, const char *option, const char *text,
                   uint64_t limit);
/* "X,Y,Z" of finite numbers, or one finite number; argp_error otherwise. */
void cli_vector(const struct argp_state *state, const char *option, const char *text,
                double vector[3]);
double cli_number(const struct argp_state *state, const char *option, const char *text);

/* A decimal number as it is written: its digits without zeros before them, times 10^power. */
enum { CLI_DIGITS = 38 };
typedef struct {
  char digits[CLI_DIGITS + 1]; /* "" is 0 */
  int power;
  bool negative;
} cli_decimal;

/* A decimal number, and one of the units behind it if there is one; `unit` is that of a number
 * without one, and of the result: 10^unit. Returns the end of it, or NULL if there is no number, or
 * one of more than CLI_DIGITS digits. "1..2" is 1 with ".." behind it. */
const char *cli_scan_decimal(const char *text, const cli_unit *units, int unit,
                             cli_decimal *decimal);
/* The same, rounded once; NULL also beyond the doubles. */
const char *cli_scan(const char *text, const cli_unit *units, int unit, double *value);
/* The same of a length in mm, or with nm, um, mm, m behind it. */
const char *cli_scan_length(const char *text, double *value);
/* Such a length and nothing else; argp_error otherwise. */
double cli_length(const struct argp_state *state, const char *option, const char *text);

/* Two paths of one file, which may be there or not. */
bool cli_same_file(const char *p, const char *q);

/* The families that `name` asks for, one or "all": first ... last. Fails if there is none. */
bool cli_families(const char *name, size_t *first, size_t *last, sepax_error *error);

/* Progress on a terminal: one line on stderr, rewritten four times a second. */
typedef struct {
  const char *what;
  uint64_t total;
  struct timespec start, shown;
  bool terminal;
} cli_progress;

cli_progress cli_progress_begin(const char *what, uint64_t total);
void cli_progress_show(cli_progress *progress, uint64_t done);
/* Erase the line; the seconds since the beginning. */
double cli_progress_end(const cli_progress *progress);

#ifdef __cplusplus
}
#endif
#endif
