/* SPDX-License-Identifier: MIT */
/* tools.c - files of tools: the profiles of each kind, units, completion by a tool table; what is
 * refused with file, line and cure. */
#include "harness.h"
#include "nc/tools.h"

#include <math.h>
#include <string.h>

static nc_tools tools;

static const char *put_tools(const char *text, size_t size) {
  static char at[PATH_BYTES];
  snprintf(at, sizeof at, "%s/tools.csv", folder);
  FILE *out = fopen(at, "wb");
  assert_non_null(out);
  assert_int_equal(fwrite(text, 1, size, out), size);
  assert_int_equal(fclose(out), 0);
  return at;
}

/* Part of the only tool, with z, r, bend of each point. */
static void expect_part(const char *text, nc_tool_part part, size_t points,
                        const double expected[][3]) {
  assert_works(nc_tools_read(&tools, put_tools(text, strlen(text)), &fault));
  const turned_profile *p = &tools.tool[0].part[part];
  assert_int_equal(p->points, points);
  for (size_t n = 0; n < points; n++) {
    assert_true(fabs(p->point[n].z - expected[n][0]) < 1e-12);
    assert_true(fabs(p->point[n].r - expected[n][1]) < 1e-12);
    assert_true(fabs(p->point[n].bend - expected[n][2]) < 1e-12);
  }
  if (points > 0) {
    assert_works(sepax__turned_check(p, &fault));
  }
  nc_tools_free(&tools);
}

#define POINTS(...) \
  sizeof((const double[][3]){__VA_ARGS__}) / sizeof(double[3]), (const double[][3]) { __VA_ARGS__ }

#define HEAD                                                                        \
  "number,kind,diameter [mm],corner radius [mm],tip angle [deg],taper angle [deg]," \
  "flute length [mm]\n"

CASE(test_kinds) {
  expect_part(HEAD "1,flat,10,,,,25", NC_FLUTES, POINTS({0, 5, 0}, {25, 5, 0}));
  expect_part(HEAD "1,flat,10,0,,,25", NC_FLUTES, POINTS({0, 5, 0}, {25, 5, 0}));
  expect_part(HEAD "1,ball,10,,,,25", NC_FLUTES, POINTS({0, 0, 0}, {5, 5, 5}, {25, 5, 0}));
  expect_part(HEAD "1,ball,10,,,,5", NC_FLUTES, POINTS({0, 0, 0}, {5, 5, 5}));
  expect_part(HEAD "1,bull,10,1,,,25", NC_FLUTES, POINTS({0, 4, 0}, {1, 5, 1}, {25, 5, 0}));
  expect_part(HEAD "1,face,50,0.8,,,6", NC_FLUTES,
              POINTS({0, 24.2, 0}, {0.8, 25, 0.8}, {6, 25, 0}));
  expect_part(HEAD "1,drill,10,,90,,60", NC_FLUTES, POINTS({0, 0, 0}, {5, 5, 0}, {60, 5, 0}));
  expect_part(HEAD "1,drill,10,,180,,60", NC_FLUTES, POINTS({0, 0, 0}, {0, 5, 0}, {60, 5, 0}));
  expect_part(HEAD "1,taper,2,,,45,10", NC_FLUTES, POINTS({0, 1, 0}, {10, 11, 0}));
  expect_part(HEAD "1,taper,0,,,45,10", NC_FLUTES, POINTS({0, 0, 0}, {10, 10, 0}));
  double s = sqrt(0.5);
  expect_part(HEAD "1,taper,2,1,,45,10", NC_FLUTES,
              POINTS({0, 0, 0}, {1 - s, s, 1}, {10, s + 10 - (1 - s), 0}));
  expect_part(HEAD "1,taper,2,1,,30,10", NC_FLUTES,
              POINTS({0, 0, 0}, {0.5, sqrt(0.75), 1}, {10, sqrt(0.75) + 9.5 / sqrt(3), 0}));
  expect_part(HEAD "1,taper,4,1,,45,10", NC_FLUTES,
              POINTS({0, 1, 0}, {1 - s, 1 + s, 1}, {10, 1 + s + 10 - (1 - s), 0}));
  expect_part(HEAD "1,probe,6,,,,", NC_FLUTES, POINTS({0, 0, 0}, {3, 3, 3}, {6, 0, 3}));
}

#define STEPS "number,kind,flutes [mm],shank [mm],stick-out [mm],holder [in]\n"

CASE(test_steps) {
  expect_part(STEPS "1,form,25@5 10>12@15,,20,", NC_FLUTES,
              POINTS({0, 12.5, 0}, {5, 12.5, 0}, {5, 5, 0}, {20, 6, 0}));
  expect_part(STEPS "1,form,6>10@20R85 10@20,,40,", NC_FLUTES,
              POINTS({0, 3, 0}, {20, 5, 85}, {40, 5, 0}));
  expect_part(STEPS "1,form, 10@5  10>20@8R-12 ,,13,", NC_FLUTES,
              POINTS({0, 5, 0}, {5, 5, 0}, {13, 10, -12}));
  expect_part(STEPS "1,form,10@5,8@10 8>12@5,20,", NC_SHANK,
              POINTS({5, 4, 0}, {15, 4, 0}, {20, 6, 0}));
  expect_part(STEPS "1,form,10@5,8@10 8>12@5,,2@1", NC_HOLDER,
              POINTS({20, 25.4, 0}, {45.4, 25.4, 0}));
}

#define FULL                                                             \
  "number,name,kind,diameter [in],flute length [mm],neck diameter [mm]," \
  "usable length [mm],shank diameter [mm],stick-out [mm],holder [mm],length [mm]\n"

CASE(test_upper_parts) {
  expect_part(FULL "1,,flat,.5,25,,,12,40,,", NC_FLUTES, POINTS({0, 6.35, 0}, {25, 6.35, 0}));
  expect_part(FULL "1,,flat,.5,25,,,12,40,,", NC_SHANK, POINTS({25, 6, 0}, {40, 6, 0}));
  expect_part(FULL "1,,flat,.5,25,9,30,12,40,,", NC_SHANK,
              POINTS({25, 4.5, 0}, {30, 4.5, 0}, {30, 6, 0}, {40, 6, 0}));
  expect_part(FULL "1,,flat,.5,25,9,40,12,40,,", NC_SHANK, POINTS({25, 4.5, 0}, {40, 4.5, 0}));
  expect_part(FULL "1,,flat,.5,25,,,12,25,,", NC_SHANK, 0, NULL);
  expect_part(FULL "1,,flat,.5,25,,,,25,30@10,", NC_HOLDER, POINTS({25, 15, 0}, {35, 15, 0}));
  expect_part(FULL "1,,flat,.5,25,,,12,40,28>32@20 50@30,90", NC_HOLDER,
              POINTS({40, 14, 0}, {60, 16, 0}, {60, 25, 0}, {90, 25, 0}));
  expect_part(FULL "1,,probe,.25,,,,2,40,,", NC_SHANK, POINTS({3.175, 1, 0}, {40, 1, 0}));
  expect_part(FULL "1,,flat,.5,25,,,,,,", NC_SHANK, 0, NULL);
}

CASE(test_rows) {
  static const char text[] =
      "\xef\xbb\xbf# mill\r\n\r\n" FULL " 12 , end mill D12 ,flat,.5,25,,,12,40,,\r\n"
      "3,,ball,.5,25,,,,,,100\r\ndefault,,flat,,20,,,,,,\r\n";
  assert_works(nc_tools_read(&tools, put_tools(text, strlen(text)), &fault));
  assert_int_equal(tools.tools, 2);
  assert_int_equal(tools.tool[0].number, 12);
  assert_int_equal(tools.tool[0].line, 4);
  assert_string_equal(tools.tool[0].name, "end mill D12");
  assert_true(isnan(tools.tool[0].length) && tools.tool[1].length == 100);
  assert_true(tools.tool[1].kind == NC_TOOL_BALL && tools.tool[1].diameter == 12.7);
  assert_non_null(tools.common);
  nc_tools_free(&tools);
}

/* ------------------------------------------------------------------- tool table */

static nc_tool row_of(int number, double diameter, double z) {
  nc_tool tool = {.number = number, .pocket = number, .diameter = diameter};
  tool.offset[NC_Z] = z;
  return tool;
}

static bool complete(const char *text, nc_tool row) {
  assert_works(nc_tools_read(&tools, put_tools(text, strlen(text)), &fault));
  return nc_tools_complete(&tools, &row, 1, "tool.tbl", &fault);
}

static void disagree(const char *text, nc_tool row, const char *why) {
  assert_fault(complete(text, row), why);
  assert_message("tools.csv:2: tool 1: ");
  nc_tools_free(&tools);
}

static void found(const char *text, nc_tool row, double length) {
  assert_works(complete(text, row));
  const nc_turned_tool *tool = nc_tools_find(&tools, row.number, &fault);
  assert_works(tool != NULL);
  assert_true(fabs(tool->length - length) < 1e-9);
  assert_true(tool->diameter > 0 && tool->part[NC_FLUTES].points > 1);
  nc_tools_free(&tools);
}

static void not_found(const char *text, nc_tool row, int number, const char *why) {
  assert_works(complete(text, row));
  assert_fault(nc_tools_find(&tools, number, &fault) != NULL, why);
  assert_message("tools.csv");
  nc_tools_free(&tools);
}

#define LENGTHS                                                             \
  "number,kind,diameter [mm],flute length [mm],stick-out [mm],holder [mm]," \
  "length [mm],shank diameter [mm]\n"

CASE(test_table) {
  found(LENGTHS "1,flat,10,25,,,120,", row_of(1, 10, 120), 120);
  found(LENGTHS "1,flat,10,25,,,120,", row_of(1, 10 + 9e-5, 120 - 9e-5), 120);
  found(LENGTHS "1,flat,10,25,,,120,", row_of(1, 0, 0), 120);
  found(LENGTHS "1,flat,10,25,,,,", row_of(1, 10, 118), 118);
  found(LENGTHS "1,flat,10,25,40,50@80,,8", row_of(1, 10, 120), 120);
  disagree(LENGTHS "1,flat,10,25,,,120,", row_of(1, 12, 120),
           "its diameter is 10 mm, but 12 mm in tool.tbl; mend");
  disagree(LENGTHS "1,flat,10,25,,,120,", row_of(1, 10 + 2e-4, 120), "in tool.tbl; mend");
  disagree(LENGTHS "1,flat,10,25,,,120,", row_of(1, 10, 122),
           "its length is 120 mm, but 122 mm in tool.tbl; mend");
  disagree(LENGTHS "1,flat,10,25,40,50@80,,8", row_of(1, 10, 122),
           "its holder ends 120 mm above the tip, below the nose of the spindle at the length of "
           "122 mm; add a step");
  disagree(LENGTHS "1,flat,10,25,40,50@80,,8", row_of(1, 10, 30), "40 mm long below its holder");
  not_found(LENGTHS "1,flat,10,25,,,,", row_of(1, 10, 0), 1,
            "no length here and none in tool.tbl; give 'length'");
  not_found(LENGTHS "1,flat,10,25,,,99,", row_of(2, 10, 99), 2,
            "no tool 2, which tool.tbl has; add it, or a row 'default'");
}

CASE(test_default) {
  static const char common[] = LENGTHS "default,flat,,25,,,,\n1,flat,10,25,,,120,";
  found(common, row_of(7, 10, 99), 99);
  found(common, row_of(1, 10, 120), 120);
  not_found(common, row_of(7, 0, 99), 7, "tool 7: kind flat needs 'diameter'");
  not_found(common, row_of(7, 10, 0), 7, "no length");
  not_found(common, row_of(7, 10, 99), 8, "no tool 8; add a row");
  not_found(LENGTHS "default,ball,,25,,,,", row_of(7, 60, 99), 7,
            "a flute length of 25 mm ends within the tip, which is 30 mm high");
}

CASE(test_offsets) {
  nc_tool row = row_of(1, 10, 120);
  row.offset[NC_X] = 3;
  assert_works(complete(LENGTHS "1,flat,10,25,,,120,", row));
  assert_fault(nc_tools_find(&tools, 1, &fault) != NULL,
               "tool.tbl: tool 1 has an offset X of 3, so its axis is not the spindle's");
  nc_tools_free(&tools);
}

/* ---------------------------------------------------------------------- refused */

static void refuse_bytes(const char *text, size_t size, const char *why) {
  assert_fault(nc_tools_read(&tools, put_tools(text, size), &fault), why);
  assert_message("tools.csv");
  assert_true(tools.tool == NULL && tools.path == NULL);
}

static void refuse(const char *text, const char *why) { refuse_bytes(text, strlen(text), why); }

CASE(test_refused_tables) {
  refuse("", "no tools in it");
  refuse(HEAD, "no tools in it");
  refuse_bytes("a\0b", 3, "bytes of zero");
  refuse("kind\nflat", ":1: no column 'number'; add it");
  refuse("number\n1", ":1: no column 'kind'; add it");
  refuse("number,kind,colour\n", ":1: unknown column 'colour'; give some of: number, name");
  refuse("number,kind,kind\n", ":1: two columns 'kind'");
  refuse("number,kind,diameter\n", "column 'diameter': write 'diameter [mm]' or 'diameter [in]'");
  refuse("number,kind,diameter [cm]\n", "write 'diameter [mm]'");
  refuse("number,kind,holder\n", "write 'holder [mm]'");
  refuse("number,kind,tip angle [rad]\n", "write 'tip angle [deg]'");
  refuse("number,kind [mm]\n", "column 'kind' has no unit");
  refuse("number\tkind\n", ":1: a tab; separate cells by commas");
  refuse("number;kind\n", ":1: a semicolon; separate cells by commas");
  refuse(HEAD "1,\"flat\",10,,,,25", ":2: a quotation mark");
  refuse(HEAD "1,flat,10,5,,,,25",
         ":2: 8 cells, but the first line has 7; mend the line (decimals");
  refuse(HEAD "1,flat,10", ":2: 3 cells, but the first line has 7; mend the line");
}

CASE(test_refused_cells) {
  refuse(HEAD "0,flat,10,,,,25", "tool '0'; give a whole number from 1");
  refuse(HEAD "1.5,flat,10,,,,25", "tool '1.5'; give a whole number from 1");
  refuse(HEAD ",flat,10,,,,25", "tool ''; give a whole number from 1");
  refuse(HEAD "1,flat,10,,,,25\n\n1,flat,10,,,,25", ":4: tool 1 is in line 2, too");
  refuse(HEAD "1,endmill,10,,,,25", "kind 'endmill'; give flat, ball");
  refuse(HEAD "1,flat,1O,,,,25", "column 'diameter': '1O' is no number of 0 or more");
  refuse(HEAD "1,flat,-1,,,,25", "column 'diameter': '-1' is no number of 0 or more");
  refuse(HEAD "1,flat,nan,,,,25", "'nan' is no number");
  refuse(HEAD "1,flat,10001,,,,25", "10001 is too large");
  refuse(HEAD "1,flat,0,,,,25", ":2: tool 1: 'diameter' is 0; give a number above 0");
  refuse(HEAD "1,flat,,,,,25", "kind flat needs 'diameter'");
  refuse(HEAD "1,flat,10,,,,", "kind flat needs 'flute length'");
  refuse(HEAD "1,bull,10,0,,,25", "kind bull needs 'corner radius'");
  refuse(HEAD "1,drill,10,,,,25", "kind drill needs 'tip angle'");
  refuse(HEAD "1,taper,10,,,,25", "kind taper needs 'taper angle'");
  refuse(HEAD "1,form,10,,,,", "kind form needs 'flutes'");
  refuse(HEAD "1,flat,10,1,,,25", "kind flat has no corner radius; leave the cell empty");
  refuse(HEAD "1,ball,10,,118,,25", "kind ball has no tip angle");
  refuse(HEAD "1,probe,10,,,,25", "kind probe has no flute length");
  refuse(HEAD "1,bull,10,6,,,25",
         "a corner radius of 6 mm is more than half of the diameter of 10");
  refuse(HEAD "1,ball,10,,,,4", "a flute length of 4 mm ends within the tip, which is 5 mm high");
  refuse(HEAD "1,drill,10,,181,,9", "a tip angle above 180 degrees");
  refuse(HEAD "1,taper,10,,,90,9", "a taper angle of 90 degrees or more");
  refuse(HEAD "1,taper,10,,,89.9999,9999", "its flutes, from the tip: point 1");
  refuse(HEAD "default,flat,10,,,,25", "default: diameter and length come from the tool table");
}

CASE(test_refused_parts) {
  refuse(STEPS "1,form,25@,,,", ":2: tool 1: column 'flutes': step '25@'; give DIAMETER@LENGTH");
  refuse(STEPS "1,form,25@5+3@4,,,", "step '25@5+3@4'");
  refuse(STEPS "1,form,25@0,,,", "step '25@0'");
  refuse(STEPS "1,form,25@5R0,,,", "step '25@5R0'");
  refuse(STEPS "1,form,5>25@5R4,,,", "column 'flutes', from the tip: point 1: an arc of radius 4");
  refuse(STEPS "1,form,5@5,6@5,20,", "end 10 mm above the tip, but the stick-out is 20 mm");
  refuse(STEPS "1,form,5@5,,,1@2", "a holder needs 'stick-out'");
  refuse(FULL "1,,flat,.5,25,,,,40,,", "the flutes end at 25 mm and the stick-out is 40 mm; give");
  refuse(FULL "1,,flat,.5,25,,,12,20,,", "a stick-out of 20 mm is less than the 25 mm");
  refuse(FULL "1,,flat,.5,25,,,12,,,", "a shank needs 'stick-out'");
  refuse(FULL "1,,flat,.5,25,9,,12,40,,", "a neck needs 'neck diameter' and 'usable length'");
  refuse(FULL "1,,flat,.5,25,9,30,,40,,", "a neck needs 'shank diameter'");
  refuse(FULL "1,,flat,.5,25,9,45,12,40,,", "a usable length of 45 mm is not above the flutes");
  refuse(FULL "1,,flat,.5,25,9,25,12,40,,", "a usable length of 25 mm is not above the flutes");
  refuse(FULL "1,,flat,.5,25,,,12,0,,", "'stick-out' is 0");
  refuse(FULL "1,,flat,.5,25,,,12,40,30@50,100", "add a step to 'holder'");
  refuse(FULL "1,,flat,.5,25,,,12,40,30@50,39", "a length of 39 mm, but the tool is 40 mm long");
  refuse("number,kind,flutes [mm],diameter [mm]\n1,form,25@5,24",
         "a diameter of 24 mm, but the greatest of 'flutes' is 25 mm");
  refuse("number,kind,flutes [mm],diameter [mm],flute length [mm]\n1,flat,25@5,24,9",
         "'flutes' is for kind form");
  refuse("number,kind,flutes [mm],shank [mm],shank diameter [mm]\n1,form,25@5,8@9,8",
         "'shank' has steps; leave shank diameter");
}

/* ------------------------------------------------------------------- the example */

/* Each part has meshes at 5 um. The flutes shrunk by 10 um have them, too. */
CASE(test_example) {
  assert_works(nc_tools_read(&tools, "examples/five-axis/tools.csv", &fault));
  assert_int_equal(tools.tools, 3);
  for (size_t n = 0; n < tools.tools; n++) {
    assert_non_null(nc_tools_find(&tools, (int)n + 1, &fault));
    for (int part = 0; part < NC_TOOL_PARTS; part++) {
      sepax_soup outer;
      const revolve_how how = {0.005, part == NC_FLUTES ? 0.01 : 0, part == NC_FLUTES};
      assert_works(sepax__revolve(&outer, NULL, &tools.tool[n].part[part], &how, &fault));
      assert_in_range(outer.count, 300, 12000);
      sepax_soup_free(&outer);
    }
  }
  nc_tools_free(&tools);
}
