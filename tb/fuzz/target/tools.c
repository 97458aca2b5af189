/* SPDX-License-Identifier: MIT */
/* tools.c - files of tools, completed by a tool table. */
#include "fuzz/fuzz.h"
#include "nc/tools.h"

#include <math.h>

static void require_sound(const nc_turned_tool *tool) {
  REQUIRE(tool->part[NC_FLUTES].points > 0 || tool->refusal != NULL);
  for (int n = 0; n < NC_TOOL_PARTS; n++) {
    REQUIRE(tool->part[n].points == 0 || sepax__turned_check(&tool->part[n], NULL));
  }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static const nc_tool table[] = {{.number = 1, .diameter = 10, .offset[NC_Z] = 120},
                                  {.number = 77, .diameter = 6, .offset[NC_Z] = 99}};
  nc_tools tools;
  sepax_error error = {0};
  fuzz_file("tools.csv", data, size);
  if (!fuzz_answer(nc_tools_read(&tools, "tools.csv", &error), &error)) {
    return 0;
  }
  sepax_error disagreement = {0};
  bool ok = nc_tools_complete(&tools, table, 2, "tool.tbl", &disagreement);
  REQUIRE(ok == (disagreement.code == SEPAX_OK));
  for (size_t n = 0; n < tools.tools; n++) {
    require_sound(&tools.tool[n]);
    sepax_error why = {0};
    bool found = nc_tools_find(&tools, tools.tool[n].number, &why) != NULL;
    REQUIRE(found == (why.code == SEPAX_OK));
  }
  nc_tools_free(&tools);
  return 0;
}
