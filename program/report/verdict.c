/* SPDX-License-Identifier: MIT */
/* verdict.c - the names of verdicts and the exit status of each. */
#include "report/verdict.h"

const char *const report_verdict_names[VERDICTS] = {
    [VERDICT_FREE] = "free",
    [VERDICT_WARNING] = "warning",
    [VERDICT_UNDECIDED] = "undecided",
    [VERDICT_COLLISION] = "collision",
};

const char *const report_verdict_titles[VERDICTS] = {
    [VERDICT_FREE] = "FREE",
    [VERDICT_WARNING] = "WARNING",
    [VERDICT_UNDECIDED] = "UNDECIDED",
    [VERDICT_COLLISION] = "COLLISION",
};

const int report_verdict_status[VERDICTS] = {
    [VERDICT_FREE] = EXIT_FREE,
    [VERDICT_WARNING] = EXIT_WARNING,
    [VERDICT_UNDECIDED] = EXIT_UNDECIDED,
    [VERDICT_COLLISION] = EXIT_COLLISION,
};
