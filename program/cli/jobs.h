/* jobs.h - sepax tree of a list of jobs. */
#ifndef SEPAX_CLI_JOBS_H
#define SEPAX_CLI_JOBS_H

#include "sepax_tree.h"

/* Print what a list of jobs has; with `walked` what the golden model answers, too. */
bool cli_tell_jobs(const char *path, bool walked, sepax_error *error);

#endif
