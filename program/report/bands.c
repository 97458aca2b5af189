/* bands.c - the limits of --clearance and --warning, and how they are told. */
#include "report/bands.h"
#include "util/error.h"

bool report_bands_agree(const report_bands *bands, sepax_error *error) {
  const report_limit *clearance = &bands->clearance;
  const report_limit *warning = &bands->warning;
  if (warning->text != NULL && clearance->text == NULL) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "warning: there is no clearance to warn before; give --clearance, too");
  }
  return warning->text == NULL || warning->length > clearance->length ||
         sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                    "warning: %.60s is not above the clearance of %.60s", warning->text,
                    clearance->text);
}
