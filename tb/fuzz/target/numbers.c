/* SPDX-License-Identifier: MIT */
/* numbers.c - numbers and lengths as the command line and files have them: what is accepted is a
 * finite number, and that of strtod. */
#include "cli/cli.h"
#include "formats/formats.h"
#include "fuzz/fuzz.h"
#include "util/text.h"

#include <math.h>
#include <string.h>

enum { LONGEST = 500 };

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  char text[LONGEST + 1];
  if (size > LONGEST) {
    return 0;
  }
  memcpy(text, data, size);
  text[size] = '\0';
  double value = 0;
  const char *end = cli_scan_length(text, &value);
  REQUIRE(end == NULL || (end > text && end <= text + size && isfinite(value)));
  fuzz_accepted += end != NULL;
  double plain = 0;
  if (sepax__number(text, strlen(text), &plain)) {
    REQUIRE(isfinite(plain) && plain == strtod(text, NULL));
    end = cli_scan_length(text, &value);
    REQUIRE(end == NULL || *end != '\0' || value == plain);
  }
  return 0;
}
