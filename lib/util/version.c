/* SPDX-License-Identifier: MIT */
/* version.c - which library runs. */
#include "sepax.h"

int sepax_version_number(void) { return SEPAX_VERSION_NUMBER; }

const char *sepax_version(void) { return SEPAX_VERSION; }

/* While the major number is 0, a new minor one may break callers. */
bool sepax_version_fits(int number) {
  int breaks = SEPAX_VERSION_MAJOR == 0 ? 100 : 10000;
  return number / breaks == SEPAX_VERSION_NUMBER / breaks && number <= SEPAX_VERSION_NUMBER;
}
