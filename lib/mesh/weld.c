/* weld.c - a stub. */
#include "util/error.h"

bool sepax_soup_weld(sepax_soup *soup, double length, sepax_weld *said, sepax_error *error) {
  (void)soup;
  (void)length;
  *said = (sepax_weld){0};
  return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "stub");
}
