/* SPDX-License-Identifier: MIT */
/* verdict.h - the verdict on a pair, a pose or a whole scene, for sepax check, path and size. */
#ifndef SEPAX_REPORT_VERDICT_H
#define SEPAX_REPORT_VERDICT_H

/* Exit statuses of the commands. */
enum { EXIT_FREE, EXIT_COLLISION, EXIT_ERROR, EXIT_WARNING, EXIT_UNDECIDED };

/* In rising order of precedence: of several verdicts the greatest holds. */
typedef enum {
  VERDICT_FREE,
  VERDICT_WARNING,
  VERDICT_UNDECIDED,
  VERDICT_COLLISION,
  VERDICTS
} report_verdict;

extern const char *const report_verdict_names[VERDICTS];  /* "free": in JSON and CSV */
extern const char *const report_verdict_titles[VERDICTS]; /* "FREE": in text */
extern const int report_verdict_status[VERDICTS];         /* EXIT_FREE ... */

static inline report_verdict report_worse(report_verdict a, report_verdict b) {
  return a > b ? a : b;
}

#endif
