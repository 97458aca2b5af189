/* SPDX-License-Identifier: MIT */
/* rows.c - canonical motion on standard input becomes rows of joints as CSV.
 *
 *   nc-rows [--dogleg] [--ignore-limits] [--tolerance=METRES] < stream > rows.csv
 *
 * Columns: joints in m or rad, then what nc.h says of a row, then the deviations and the blending
 * of each joint. Exit status 2 with one line if the stream is refused. */
#include "nc/nc.h"

#include <stdlib.h>
#include <string.h>

static const char *const kinds[] = {"rapid", "feed", "probe", "dwell"};
static const char *const breaks[] = {"", "first", "loaded", "probed", "displaced"};
static const char *const blends[] = {"exact", "within", "unbounded"};

static void put_head(const nc_motion *m) {
  static const char *const of[] = {"", "deviation.", "blending."};
  for (size_t k = 0; k < 3; k++) {
    for (size_t j = 0; j < m->joints; j++) {
      printf("%s%sjoint%zu", k + j > 0 ? "," : "", of[k], j);
    }
    printf("%s", k == 0 ? ",kind,file,line,tool,break,blend,within,spindle,dogleg" : "");
  }
  putchar('\n');
}

static void put_row(const nc_motion *m, size_t n) {
  const nc_row *row = &m->row[n];
  const double *const of[] = {m->value, m->deviation, m->blending};
  for (size_t k = 0; k < 3; k++) {
    for (size_t j = 0; j < m->joints; j++) {
      printf("%s%.17g", k + j > 0 ? "," : "", of[k][n * m->joints + j]);
    }
    if (k == 0) {
      printf(",%s,%s,%zu,%d,%s,%s,%.17g,%d,%d", kinds[row->kind],
             nc_program_file(&m->program, row->file), row->line, row->tool, breaks[row->begins],
             blends[row->blend], row->within, row->spindle, row->dogleg);
    }
  }
  putchar('\n');
}

int main(int argc, char **argv) {
  nc_rules rules = {0};
  nc_motion motion;
  sepax_error error;
  for (int n = 1; n < argc; n++) {
    rules.dogleg = rules.dogleg || strcmp(argv[n], "--dogleg") == 0;
    rules.ignore_limits = rules.ignore_limits || strcmp(argv[n], "--ignore-limits") == 0;
    if (strncmp(argv[n], "--tolerance=", 12) == 0) {
      rules.linear = rules.angular = strtod(argv[n] + 12, NULL);
    }
  }
  if (!nc_motion_read(&motion, stdin, "standard input", &rules, &error)) {
    fprintf(stderr, "%s\n", error.text);
    return 2;
  }
  put_head(&motion);
  for (size_t n = 0; n < motion.rows; n++) {
    put_row(&motion, n);
  }
  nc_motion_free(&motion);
  return fflush(stdout) == 0 ? 0 : 2;
}
