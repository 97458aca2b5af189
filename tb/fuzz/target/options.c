/* SPDX-License-Identifier: MIT */
/* options.c - the options of a design as text: what is accepted is written and read back, and has a
 * design. */
#include "fuzz/fuzz.h"
#include "sepax_design.h"

#include <string.h>

enum { LONGEST = 2000 };

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  char text[LONGEST + 1];
  if (size > LONGEST) {
    return 0;
  }
  memcpy(text, data, size);
  text[size] = '\0';
  sepax_config config = sepax_config_default();
  sepax_error error = {0};
  bool ok = fuzz_answer(sepax_config_parse(&config, text, &error), &error);
  if (ok) {
    ok = fuzz_answer(sepax_config_check(&config, &error), &error);
  }
  if (ok) {
    char again[LONGEST];
    char twice[LONGEST];
    sepax_design design;
    sepax_config other = sepax_config_default();
    sepax_config_text(&config, again, sizeof again);
    REQUIRE(sepax_config_parse(&other, again, &error));
    REQUIRE(strcmp(sepax_config_text(&other, twice, sizeof twice), again) == 0);
    fuzz_answer(sepax_design_init(&design, &config, &error), &error);
  }
  return 0;
}
