/* SPDX-License-Identifier: MIT */
/* canon.c - the reader of canonical motion: what it reads, and what it refuses with the line. */
#include "streams.h"

static const char good[] = "sepax-nc 1\n"                                          /* 1 */
                           "file 0 my part.ngc\n"                                  /* 2 */
                           "machine xyzac-trt-kins sparm=identityfirst\n"          /* 3 */
                           "parameter y-offset 20\n"                               /* 4 */
                           "parameter tool-offset 1.5 z\n"                         /* 5 */
                           "joint 0 X linear -10 10.5\n"                           /* 6 */
                           "joint 1 A angular -1e-05 90 720\n"                     /* 7 */
                           "tool 3 1 6.0 0 0 42.5 0 0 0 0 0 0 end mill, of 6 mm\n" /* 8 */
                           "tool 4 2 8.0 0 0 1 0 0 0 0 0 0 \n"                     /* 9 */
                           "start home 0 0 1 0 0 0 0 0 0\n"                        /* 10 */
                           "file 1 sub.ngc\n"                                      /* 11 */
                           "move rapid 0 1 1 2 3 4 5 6 7 8 9\n"                    /* 12 */
                           "arc feed 1 2 1 2 3 4 5 6 7 8 9 0 0 3 0 0 -1 2\n"       /* 13 */
                           "dwell 0 3 0.5\n"                                       /* 14 */
                           "load 0 4 3\n"                                          /* 15 */
                           "length 0 5 0 0 42.5 0 0 0 0 0 0\n"                     /* 16 */
                           "spindle -1 6 on\n"                                     /* 17 */
                           "kins 0 7 1 1 2 3 4 5 6 7 8 9\n"                        /* 18 */
                           "blend 0 8 within 0.05\n"                               /* 19 */
                           "note 0 9 a text, with blanks\n"                        /* 20 */
                           "move probe 0 0 1 2 3 4 5 6 7 8 -9.5\n"                 /* 21 */
                           "end 0 11\n";                                           /* 22 */

static bool read_text(nc_program *p, const char *bytes, size_t size) {
  char *copy = malloc(size);
  assert_non_null(copy);
  memcpy(copy, bytes, size);
  FILE *in = fmemopen(copy, size, "r");
  assert_non_null(in);
  bool ok = nc_program_read(p, in, "stream", &fault);
  fclose(in);
  free(copy);
  return ok;
}

CASE(test_all_records) {
  nc_program p;
  assert_works(read_text(&p, good, strlen(good)));
  assert_int_equal(p.files, 2);
  assert_string_equal(nc_program_file(&p, 0), "my part.ngc");
  assert_string_equal(nc_program_file(&p, -1), "(a file of unknown name)");
  assert_int_equal(p.machine_words, 2);
  assert_string_equal(p.machine[1], "sparm=identityfirst");
  assert_true(p.parameters == 2 && p.parameter[1].follows && !p.parameter[0].follows);
  assert_true(p.joints == 2 && p.joint[0].most == 10.5 && p.joint[1].least == -1e-5);
  assert_true(p.joint[1].axis == NC_A && p.joint[1].angular);
  assert_true(p.joint[0].acceleration == 0 && p.joint[1].acceleration == 720);
  assert_true(p.tools == 2 && p.tool[0].offset[NC_Z] == 42.5);
  assert_string_equal(p.tool[0].comment, "end mill, of 6 mm");
  assert_string_equal(p.tool[1].comment, "");
  assert_true(!p.start_given && p.start[NC_Z] == 1);
  static const nc_action actions[] = {NC_DO_MOVE,   NC_DO_ARC,     NC_DO_DWELL, NC_DO_LOAD,
                                      NC_DO_LENGTH, NC_DO_SPINDLE, NC_DO_KINS,  NC_DO_BLEND,
                                      NC_DO_NOTE,   NC_DO_MOVE,    NC_DO_END};
  assert_int_equal(p.records, LENGTH(actions));
  for (size_t n = 0; n < p.records; n++) {
    assert_int_equal(p.record[n].action, actions[n]);
  }
  assert_true(p.record[1].file == 1 && p.record[1].line == 2 && p.record[1].number == 2);
  assert_true(p.record[1].normal[2] == -1 && p.record[1].centre[2] == 3);
  assert_true(p.record[7].blend == NC_WITHIN && p.record[7].within == 0.05);
  assert_string_equal(p.record[8].text, "a text, with blanks");
  assert_true(p.record[9].kind == NC_PROBE && p.record[9].axis[NC_W] == -9.5);
  nc_program_free(&p);
}

/* Line `number` of the good stream, from 1, is replaced by text, or left out. */
static void refuse(int number, const char *by, const char *part) {
  char bytes[4096] = "", where[32];
  nc_program p;
  const char *line = good;
  for (int n = 1; *line != '\0'; n++) {
    const char *end = strchr(line, '\n') + 1;
    if (n == number) {
      strcat(bytes, by);
    } else {
      strncat(bytes, line, (size_t)(end - line));
    }
    line = end;
  }
  assert_fault(read_text(&p, bytes, strlen(bytes)), part);
  snprintf(where, sizeof where, "stream:%d:", number);
  assert_message(where);
  assert_true(p.records == 0 && p.record == NULL && p.file == NULL);
}

CASE(test_head) {
  refuse(1, "sepax-nc 2\n", "`sepax-nc 1`");
  refuse(2, "file 0\n", "no path");
  refuse(2, "file x y\n", "no finite number");
  refuse(2, "file -1 y\n", "whole number");
  refuse(3, "machine\n", "kinematics is missing");
  refuse(3, "machine a b c d e f g h i\n", "more than 8 words");
  refuse(4, "machine trivkins\n", "second record");
  refuse(4, "parameter y-offset 20 w\n", "none of: z");
  refuse(4, "parameter y-offset 20 z z\n", "too many");
  refuse(5, "parameter y-offset 3\n", "two records");
  refuse(6, "joint 1 X linear -10 10\n", "in order");
  refuse(6, "joint 0 XY linear -10 10\n", "none of: XYZABCUVW");
  refuse(6, "joint 0 X angular -10 10\n", "axis X is linear");
  refuse(6, "joint 0 X linear 10 -10\n", "lower limit");
  refuse(6, "joint 0 X linear -10 10 -1\n", "greatest acceleration");
  refuse(6, "joint 0 X linear -10 10 1 2\n", "too many");
  refuse(6, "servo -0.001\n", "no period");
  refuse(6, "servo\n", "ends before servo period");
  refuse(6, "joint 0 X linear -10\n", "ends before upper limit");
  refuse(9, "tool 3 1 6.0 0 0 42.5 0 0 0 0 0 0 again\n", "two records");
  refuse(9, "tool 5 1 6.0 0 0\n", "ends before offset");
  refuse(10, "start somewhere 0 0 1 0 0 0 0 0 0\n", "none of: home, given");
  refuse(10, "start given 0 0 1 0 0 0 0 0\n", "ends before start");
  refuse(11, "start home 0 0 1 0 0 0 0 0 0\n", "after `start`");
  refuse(11, "tool 7 1 6.0 0 0 42.5 0 0 0 0 0 0 late\n", "after `start`");
  refuse(11, "file 0 twice\n", "two records");
}

CASE(test_actions) {
  refuse(8, "move rapid 0 1 1 2 3 4 5 6 7 8 9\n", "before `start`");
  refuse(12, "move fast 0 1 1 2 3 4 5 6 7 8 9\n", "none of: rapid, feed, probe");
  refuse(12, "move rapid 7 1 1 2 3 4 5 6 7 8 9\n", "file 7 has no record");
  refuse(12, "move rapid 0 1 1 2 3 4 5 6 7 8\n", "ends before axis");
  refuse(12, "move rapid 0 1 1 2 3 4 5 6 7 8 9 10\n", "too many");
  refuse(12, "move rapid 0 1 1  2 3 4 5 6 7 8 9\n", "no finite number");
  refuse(12, "move rapid 0 1 1 2 3 4 5 6 7 8 nan\n", "no finite number");
  refuse(12, "move rapid 0 1 1 2 3 4 5 6 7 8 1e300\n", "beyond");
  refuse(12, "move rapid 0 1.5 1 2 3 4 5 6 7 8 9\n", "whole number");
  refuse(13, "arc feed 1 2 1 2 3 4 5 6 7 8 9 0 0 3 0 0.5 -1 2\n", "length is 1.118");
  refuse(13, "arc feed 1 2 1 2 3 4 5 6 7 8 9 0 0 3 0 0 -1 -1\n", "whole number");
  refuse(13, "arc feed 1 2 1 2 3 4 5 6 7 8 9 0 0 3 0 0 -1\n", "ends before turns");
  refuse(14, "dwell 0 3 -1\n", "no time");
  refuse(15, "load 0 4 -3\n", "whole number");
  refuse(17, "spindle 0 6 slow\n", "none of: off, on");
  refuse(18, "kins 0 7 1\n", "ends before position");
  refuse(19, "blend 0 8 near\n", "none of: exact, within, unbounded");
  refuse(19, "blend 0 8 within\n", "ends before tolerance");
  refuse(19, "blend 0 8 within -1\n", "no tolerance");
  refuse(19, "blend 0 8 exact 1\n", "too many");
  refuse(20, "spline 0 8\n", "'spline' is not known");
  refuse(20, "\n", "'' is not known");
}

CASE(test_ends) {
  nc_program p;
  static const char zero[] = "sepax-nc 1\nfile 0 a\0b\n";
  char text[5000];
  assert_fault(read_text(&p, good, strlen(good) - 9), "stream:22: the stream ends without `end`");
  assert_fault(read_text(&p, good, strlen(good) - 1), "stream:22: the stream ends within a line");
  assert_fault(read_text(&p, good, 11), "stream:2: the stream ends without");
  assert_fault(read_text(&p, zero, sizeof zero - 1), "stream:2: a byte of zero");
  memset(text, 'x', sizeof text);
  assert_fault(read_text(&p, text, sizeof text), "stream:1: the line is too long");
  snprintf(text, sizeof text, "%smove feed 0 1 1 2 3 4 5 6 7 8 9\n", good);
  assert_fault(read_text(&p, text, strlen(text)), "stream:23: a line after `end`");
}

/* G64 P0 is G64 without P. */
CASE(test_tolerance_of_zero) {
  static const char text[] = "sepax-nc 1\nfile 0 a\nmachine trivkins\njoint 0 X linear 0 1\n"
                             "start home 0 0 0 0 0 0 0 0 0\nblend 0 1 within 0.0\nend 0 2\n";
  nc_program p;
  assert_works(read_text(&p, text, strlen(text)));
  assert_int_equal(p.record[0].blend, NC_UNBOUNDED);
  nc_program_free(&p);
}
