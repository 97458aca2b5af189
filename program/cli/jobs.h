/* SPDX-License-Identifier: MIT */
/* jobs.h - sepax tree of a list of jobs. */
#ifndef SEPAX_CLI_JOBS_H
#define SEPAX_CLI_JOBS_H

#include "sepax_tree.h"

/* Print what a list of jobs contains. If `walked` is true, then the golden model's answers are
 * printed, too. */
bool cli_tell_jobs(const char *path, bool walked, sepax_error *error);

#endif
