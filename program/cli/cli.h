/* SPDX-License-Identifier: MIT */
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

/* The highest value of --threads. The library starts no more threads. */
enum { CLI_THREADS_MOST = 256 };

/* The flag of an option that may be given several times, each time with another value. */
enum { CLI_REPEATABLE = 0x1000 };

/* Read the command line as argp_parse(argp, argc, argv, 0, NULL, input) does, but refuse an option
 * that is given twice with two values, of which argp would silently take the last, and names of
 * files and folders that are empty. A mistake ends the program with EXIT_ERROR. */
void cli_parse(const struct argp *argp, int argc, char **argv, void *input);

/* Argp children. The input of the first three is a sepax_config *, whose fields they set: by every
 * option of a design, by the options that a verdict depends on, and by --environment. The last one
 * reads --resolution, --offset and --normals into a cli_grid *. */
extern const struct argp cli_config_argp;
extern const struct argp cli_verdict_argp;
extern const struct argp cli_environment_argp;
void cli_options_init(void); /* fills in the options; call it once before the first use */
/* The title above the options that these architectures (bits 1 << sepax_arch) read; "Design:" if
 * most read them. */
const char *cli_options_title(unsigned archs);
extern const struct argp cli_grid_argp;

typedef struct {
  sepax_grid grid;        /* resolution 0: the finest grid that holds both meshes */
  const char *resolution; /* the resolution as the user wrote it, or NULL */
  bool file_normals, offset_given;
} cli_grid;

/* A whole number of least ... most. Anything else ends the program by argp_error. */
uint64_t cli_count(const struct argp_state *state, const char *option, const char *text,
                   uint64_t least, uint64_t most);
/* Read "X,Y,Z" with three finite numbers, or one finite number. Anything else ends the program by
 * argp_error. */
void cli_vector(const struct argp_state *state, const char *option, const char *text,
                double vector[3]);
double cli_number(const struct argp_state *state, const char *option, const char *text);

/* A decimal number without rounding: its digits, without leading zeros, times 10^power. */
enum { CLI_DIGITS = 38 };
typedef struct {
  char digits[CLI_DIGITS + 1]; /* "" is 0 */
  int power;
  bool negative;
} cli_decimal;

/* Read a decimal number and the unit after it, if there is one. `unit` is the unit of the result
 * and of a number without a unit, as a power: 10^unit. Returns the end of what was read. Returns
 * NULL if there is no number or if it has more than CLI_DIGITS digits. "1..2" is read as 1,
 * followed by "..". */
const char *cli_scan_decimal(const char *text, const cli_unit *units, int unit,
                             cli_decimal *decimal);
/* The same as a double, rounded once. NULL also if the number is too large or too small for a
 * double. */
const char *cli_scan(const char *text, const cli_unit *units, int unit, double *value);
/* The same for a length: in mm, or with nm, um, mm or m after it. */
const char *cli_scan_length(const char *text, double *value);
/* A length and nothing after it. Anything else ends the program by argp_error. */
double cli_length(const struct argp_state *state, const char *option, const char *text);

/* True if both paths name the same file. The files need not exist. */
bool cli_same_file(const char *p, const char *q);

/* The families of `name`: *first ... *last, one family or all. Fails if the name is unknown. */
bool cli_families(const char *name, size_t *first, size_t *last, sepax_error *error);

/* Progress on a terminal: one line on stderr, rewritten four times a second. Nothing is printed if
 * stderr is not a terminal. */
typedef struct {
  const char *what;
  uint64_t total;
  struct timespec start, shown;
  bool terminal;
} cli_progress;

cli_progress cli_progress_begin(const char *what, uint64_t total);
void cli_progress_show(cli_progress *progress, uint64_t done);
/* Erase the line. Returns the seconds since cli_progress_begin. */
double cli_progress_end(const cli_progress *progress);

#ifdef __cplusplus
}
#endif
#endif
