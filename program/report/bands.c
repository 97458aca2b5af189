/* SPDX-License-Identifier: MIT */
/* bands.c - checks and prints the limits of --clearance and --warning. */
#include "report/bands.h"
#include "report/text.h"
#include "util/error.h"

#include <stdio.h>
#include <string.h>

/* The unit of a length that the user wrote as a number alone. */
static const char *unit_of(const report_limit *limit, int unit) {
  const char *end = limit->text + strlen(limit->text);
  bool named = end > limit->text && end[-1] == 'm';
  return named ? "" : unit == 0 ? " m" : " mm";
}

bool report_bands_agree(const report_bands *bands, sepax_error *error) {
  const report_limit *clearance = &bands->clearance;
  const report_limit *warning = &bands->warning;
  if (warning->text != NULL && clearance->text == NULL) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "warning: needs a smaller clearance; give --clearance, too");
  }
  return warning->text == NULL || warning->length > clearance->length ||
         sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                    "warning: %.60s%s is not above the clearance of %.60s%s; give more",
                    warning->text, unit_of(warning, bands->unit), clearance->text,
                    unit_of(clearance, bands->unit));
}

static void print_limit(const report_bands *bands, const report_limit *limit,
                        const report_steps *steps, int lsb) {
  if (steps != NULL) {
    printf(" (up to %d LSB = %.9g mm)", lsb, lsb * steps->lsb_mm);
  } else {
    printf(" (up to %.9g mm)", report_mm(limit->length, bands->unit));
  }
}

void report_print_bands(int width, const report_bands *bands, const report_steps *steps,
                        const size_t *count) {
  printf("%-*s", width, "bands");
  if (count != NULL) {
    printf("%zu free, ", count[VERDICT_FREE]);
  }
  if (bands->warning.text != NULL) {
    if (count != NULL) {
      printf("%zu ", count[VERDICT_WARNING]);
    }
    fputs("warning", stdout);
    print_limit(bands, &bands->warning, steps, steps != NULL ? steps->warning : 0);
    fputs(", ", stdout);
  }
  if (count != NULL) {
    printf("%zu ", count[VERDICT_COLLISION]);
  }
  fputs("collision", stdout);
  print_limit(bands, &bands->clearance, steps, steps != NULL ? steps->clearance : 0);
}

static void set_limit(json_t *to, const char *key, const report_limit *limit, int unit) {
  if (limit->text != NULL) {
    json_object_set_new(to, key, json_real(report_mm(limit->length, unit)));
  }
}

void report_set_bands(json_t *to, const report_bands *bands, const report_steps *steps) {
  set_limit(to, "clearance_mm", &bands->clearance, bands->unit);
  set_limit(to, "warning_mm", &bands->warning, bands->unit);
  if (steps != NULL && bands->clearance.text != NULL) {
    json_object_set_new(to, "clearance_lsb", json_integer(steps->clearance));
  }
  if (steps != NULL && bands->warning.text != NULL) {
    json_object_set_new(to, "warning_lsb", json_integer(steps->warning));
  }
}
