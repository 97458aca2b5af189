/* SPDX-License-Identifier: MIT */
/* within.c - words for the reasons of sepax_bodies_within_why. */
#include "report/within.h"

#include <stdio.h>

static const char *const names[] = {
    [SEPAX_WITHIN_PLAIN] = NULL,        [SEPAX_WITHIN_NESTED] = "nested",
    [SEPAX_WITHIN_OPEN] = "open",       [SEPAX_WITHIN_INCONSISTENT] = "inconsistent",
    [SEPAX_WITHIN_DOUBLED] = "doubled", [SEPAX_WITHIN_OPPOSED] = "opposed",
    [SEPAX_WITHIN_SHEETS] = "sheets",
};

const char *report_within_name(sepax_within_reason why) { return names[why]; }

void report_print_within(sepax_within_reason why, const char *inner, const char *outer) {
  if (why == SEPAX_WITHIN_NESTED) {
    printf("%s is inside a shell of %s that is inside another shell, wound the same way: taken as "
           "solid; if it is a cavity, then wind it inwards",
           inner, outer);
    return;
  }
  printf("it is not known whether %s is inside %s, because ", inner, outer);
  switch (why) {
  case SEPAX_WITHIN_OPEN:
    printf("%s is open there; close it, for example by --weld", outer);
    break;
  case SEPAX_WITHIN_INCONSISTENT:
    printf("facets of %s are turned round; wind all of them outwards", outer);
    break;
  case SEPAX_WITHIN_DOUBLED:
    printf("%s has faces twice there, as two sides or as copies, or a cavity with an edge in its "
           "wall; --weld=0 leaves one of equal facets",
           outer);
    break;
  case SEPAX_WITHIN_OPPOSED:
    printf("parts of %s that touch are wound in opposite ways there; turn the part that is inside "
           "out, or move a cavity off its wall",
           outer);
    break;
  default:
    printf("more than 256 sheets of %s are in one line with it; leave out inner walls", outer);
  }
}
