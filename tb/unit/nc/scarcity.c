/* SPDX-License-Identifier: MIT */
/* scarcity.c - tools and their meshes without memory: each allocation refused in turn. */
#include "nc/tools.h"
#include "unit/memory/scarce.h"

static bool work_tools(void *context) {
  static const nc_tool table[] = {{.number = 1, .diameter = 10, .offset[NC_Z] = 120, .comment = ""},
                                  {.number = 8, .diameter = 6, .offset[NC_Z] = 99, .comment = "8"},
                                  {.number = 9, .comment = "of no diameter"}};
  nc_tools tools;
  if (!nc_tools_read(&tools, context, &fault)) {
    return false;
  }
  bool works = nc_tools_complete(&tools, table, 3, "tool.tbl", &fault);
  if (works) {
    assert_non_null(nc_tools_find(&tools, 1, &fault));
    assert_non_null(nc_tools_find(&tools, 8, &fault));
    assert_null(nc_tools_find(&tools, 9, &fault));
  }
  nc_tools_free(&tools);
  return works;
}

CASE(test_tools) {
  char name[PATH_BYTES];
  snprintf(name, sizeof name, "%s/tools.csv", folder);
  FILE *out = fopen(name, "w");
  assert_non_null(out);
  fputs("number,name,kind,diameter [mm],flute length [mm],shank diameter [mm],stick-out [mm],"
        "holder [mm]\n1,one,flat,10,25,10,40,50@80\n2,two,ball,10,25,10,40,50@80\n"
        "default,,flat,,20,,,\n",
        out);
  assert_int_equal(fclose(out), 0);
  assert_true(assert_scarce(work_tools, name) > 15);
}

static bool work_meshes(void *context) {
  turned_point point[] = {{0, 4, 0}, {1, 5, 1}, {1, 3, 0}, {25, 5, 0}};
  const turned_profile profile = {point, LENGTH(point)};
  sepax_soup outer;
  sepax_soup inner;
  if (!sepax__revolve(&outer, &inner, &profile, context, &fault)) {
    assert_true(outer.facet == NULL && inner.facet == NULL);
    return false;
  }
  sepax_soup_free(&outer);
  sepax_soup_free(&inner);
  return true;
}

CASE(test_meshes) {
  revolve_how how = {0.01, 0.1, true};
  assert_true(assert_scarce(work_meshes, &how) > 10);
}
