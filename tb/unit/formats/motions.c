/* SPDX-License-Identifier: MIT */
/* motions.c - CSV of joints: units, lines, limits; what is refused with line and column. */
#include "files.h"

#include <math.h>
#include <stdio.h>

static const format_motion_rules strict = {false, false};

/* Joints x (prismatic, -0.5 ... 0.5), a (continuous), m, which is twice x, and f, fixed. */
static sepax_robot mill(void) {
  sepax_robot r;
  assert_works(sepax_robot_read(
      &r,
      put_file("r.urdf",
               "<robot name='r'><link name='l0'/><link name='l1'/><link name='l2'/>"
               "<link name='l3'/><link name='l4'/>"
               "<joint name='x' type='prismatic'><parent link='l0'/><child link='l1'/>"
               "<limit lower='-.5' upper='.5'/></joint>"
               "<joint name='a' type='continuous'><parent link='l1'/><child link='l2'/></joint>"
               "<joint name='m' type='prismatic'><parent link='l2'/><child link='l3'/>"
               "<limit lower='-2' upper='.5'/><mimic joint='x' multiplier='2'/></joint>"
               "<joint name='f' type='fixed'><parent link='l3'/><child link='l4'/></joint>"
               "</robot>"),
      NULL, &fault));
  return r;
}

static format_motion read_text(const char *text, const format_motion_rules *rules) {
  sepax_robot r = mill();
  format_motion motion;
  assert_works(format_motion_read(&motion, &r.mechanism, rules, put_file("p.csv", text), &fault));
  sepax_robot_free(&r);
  return motion;
}

static void refuse_bytes(const char *text, size_t size, const char *part) {
  sepax_robot r = mill();
  format_motion motion;
  assert_fault(
      format_motion_read(&motion, &r.mechanism, &strict, put_bytes("p.csv", text, size), &fault),
      part);
  assert_message("p.csv");
  assert_null(motion.value);
  sepax_robot_free(&r);
}

static void refuse_text(const char *text, const char *part) {
  refuse_bytes(text, strlen(text), part);
}

/* Values beyond limits are told in the unit of their column. */
CASE(test_limits) {
  sepax_robot r;
  assert_works(sepax_robot_read(
      &r,
      put_file("r.urdf", "<robot name='r'><link name='l0'/><link name='l1'/>"
                         "<joint name='t' type='revolute'><parent link='l0'/><child link='l1'/>"
                         "<limit lower='-1' upper='1.570796'/></joint></robot>"),
      NULL, &fault));
  format_motion p;
  const char *turned = put_file("p.csv", "t [deg]\n90\n");
  assert_fault(
      format_motion_read(&p, &r.mechanism, &strict, turned, &fault),
      "p.csv:2: column 1, joint t: 90 deg is above its limit of 89.9999813 deg; mend it, or "
      "give --ignore-limits");
  assert_fault(format_motion_read(&p, &r.mechanism, &strict, put_file("p.csv", "t\n90\n"), &fault),
               "90 rad is above its limit of 1.570796 rad; mend it, name its unit, [deg], or give");
  sepax_robot_free(&r);
}

CASE(test_values) {
  format_motion p = read_text("\xef\xbb\xbf"
                              "a [deg] , time,x [mm]\r\n\r\n"
                              "90,0,250\r\n -180 ,0.5, -1e1\r\n\n36e1,.5,+.5",
                              &strict);
  assert_int_equal(p.lines, 3);
  assert_int_equal(p.joints, 4);
  static const double value[3][3] = {
      {0.25, 0x1.921fb54442d18p0, 0.5}, {-0.01, -0x1.921fb54442d18p1, -0.02}, {0.0005, 0, 0.001}};
  static const double time[3] = {0, 0.5, 0.5};
  static const size_t line[3] = {3, 4, 6};
  for (int n = 0; n < 3; n++) {
    for (int k = 0; k < (n < 2 ? 3 : 1); k++) {
      assert_true(p.value[4 * n + k] == value[n][k]);
    }
    assert_true(p.value[4 * n + 3] == 0);
    assert_true(p.time[n] == time[n]);
    assert_int_equal(p.line[n], line[n]);
  }
  format_motion_free(&p);
  p = read_text("x,a [rad]\n0.125,1\n", &strict);
  assert_null(p.time);
  assert_true(p.value[0] == 0.125 && p.value[1] == 1 && p.value[2] == 0.25);
  format_motion_free(&p);
  p = read_text("time [ms],x [um],a\n1500,1,2\n", &strict);
  assert_true(p.time[0] == 1.5 && p.value[0] == 1e-6);
  format_motion_free(&p);
}

CASE(test_rules) {
  format_motion p = read_text("a\n1\n", &(format_motion_rules){.hold = true});
  assert_true(p.value[0] == 0 && p.value[1] == 1);
  format_motion_free(&p);
  p = read_text("a,x\n1,7\n", &(format_motion_rules){.ignore_limits = true});
  assert_true(p.value[0] == 7 && p.value[2] == 14);
  format_motion_free(&p);
}

CASE(test_many_lines) {
  enum { LINES = 5000 };
  static char text[LINES * 16];
  size_t used = (size_t)sprintf(text, "x,a\n");
  for (int n = 0; n < LINES; n++) {
    used += (size_t)sprintf(text + used, "%d,%d\n", 0, n);
  }
  format_motion p = read_text(text, &strict);
  assert_int_equal(p.lines, LINES);
  for (int n = 0; n < LINES; n++) {
    assert_true(p.value[4 * n + 1] == n);
    assert_int_equal(p.line[n], n + 2);
  }
  format_motion_free(&p);
}

/* What a path says of the motions that end in its lines. A joint's name comes first. */
CASE(test_steps) {
  format_motion p = read_text("x,file,a,line,kind,tool,break,deviation [um]\n"
                              "0,part.ngc,0,17,rapid,3,,\n"
                              "0,,0,,,,0,2.5\n"
                              "0,sub.ngc,0,4,feed,part.ngc,1,0\n"
                              "0,part.ngc,0,0,dwell,3,,1e3\n",
                              &strict);
  assert_int_equal(p.columns, 8);
  assert_int_equal(p.names, 3);
  static const format_step step[4] = {
      {FORMAT_RAPID, false, 0, 1, 17, 0},
      {FORMAT_MOVE, false, FORMAT_NO_NAME, FORMAT_NO_NAME, 0, 2.5e-6},
      {FORMAT_FEED, true, 2, 0, 4, 0},
      {FORMAT_DWELL, false, 0, 1, 0, 1e-3}};
  static const bool goes_on[4] = {true, false, true, false};
  for (size_t n = 0; n < 4; n++) {
    assert_int_equal(p.step[n].kind, step[n].kind);
    assert_int_equal(p.step[n].breaks, step[n].breaks);
    assert_int_equal(p.step[n].file, step[n].file);
    assert_int_equal(p.step[n].tool, step[n].tool);
    assert_int_equal(p.step[n].line, step[n].line);
    assert_true(p.step[n].deviation == step[n].deviation);
    assert_int_equal(format_motion_goes_on(&p, n), goes_on[n]);
  }
  assert_string_equal(p.name[1], "3");
  format_motion_free(&p);
  p = read_text("x,a\n0,0\n1e-3,0\n", &strict);
  assert_null(p.step);
  assert_true(format_motion_goes_on(&p, 0) && !format_motion_goes_on(&p, 1));
  format_motion_free(&p);
}

CASE(test_steps_refused) {
  refuse_text("x,a,kind\n0,0,G0\n",
              "p.csv:2: column 3 (kind): 'G0' is none of: move, rapid, feed, probe, dwell");
  refuse_text("x,a,line\n0,0,1.5\n", "column 3 (line): '1.5' is no number of a line; mend it");
  refuse_text("x,a,line\n0,0,-1\n", "'-1' is no number of a line");
  refuse_text("x,a,line\n0,0,N10\n", "'N10' is no number of a line");
  refuse_text("x,a,break\n0,0,yes\n", "column 3 (break): 'yes' is neither 1, where the path");
  refuse_text("x,a,deviation\n0,0,-1e-6\n", "column 3 (deviation): '-1e-6' is below 0; mend it");
  refuse_text("x,a,deviation\n0,0,nan\n", "column 3 (deviation): 'nan' is no finite number");
  refuse_text("x,a,deviation [deg]\n0,0,0\n", "unit [deg] is none of: m, mm, um, nm");
  refuse_text("x,a,tool [mm]\n0,0,0\n", "column 'tool' has no unit; leave [mm] out");
  refuse_text("x,a,kind,kind\n0,0,,\n", "two columns 'kind'");
}

CASE(test_refused) {
  refuse_text("", "no line of values");
  refuse_text("x,a\n", "no line of values");
  refuse_text("\n\n  \n", "no line of values");
  refuse_text("x,b\n0,0\n", "p.csv:1: column 'b': there is no joint of this name");
  refuse_text("x;a\n0;0\n", "column 'x;a': there is no joint of this name; separate columns by");
  refuse_text("\"x\",a\n0,0\n", "leave the quotes out");
  refuse_text("x,a,\n0,0,\n", "column 3 has no name; give one, or leave the comma out");
  refuse_text("x\ta\n0\t0\n", "there is no joint of this name; separate columns by commas");
  refuse_text("x a\n0 0\n", "there is no joint of this name; separate columns by commas");
  refuse_text("0,0\n0,0\n", "column '0': there is no joint of this name; the first line must name");
  refuse_text("x [],a\n0,0\n", "column 'x': unit [] is none of: m, mm, um, nm");
  refuse_text("x [ ],a\n0,0\n", "column 'x': unit [] is none of");
  refuse_text("x,a,x\n0,0,0\n", "two columns 'x'");
  refuse_text("x,a,f\n0,0,0\n", "column 'f': this joint is fixed");
  refuse_text("x,a,m\n0,0,0\n", "column 'm': this joint follows another one");
  refuse_text("x [deg],a\n0,0\n", "column 'x': unit [deg] is none of: m, mm, um, nm");
  refuse_text("x,a [mm]\n0,0\n", "column 'a': unit [mm] is none of: rad, deg");
  refuse_text("x,a,time [h]\n0,0,0\n", "unit [h] is none of: s, ms, us, ns");
  refuse_text("time,x\n0,0\n", "p.csv:1: joint a has no column; add one, or give --hold");
  refuse_text("x,a\n0\n", "p.csv:2: 1 columns, but the header has 2");
  refuse_text("x,a\n0,0\n0,0,0\n", "p.csv:3: 3 columns, but the header has 2; mend the line");
  refuse_text("x,a\n0,5,0,5\n",
              "p.csv:2: 4 columns, but the header has 2; mend the line (decimals");
  refuse_text("x,a\n0,0\n\n0,nan\n", "p.csv:4: column 2 (a): 'nan' is no finite number");
  refuse_text("x,a\n0,inf\n", "'inf' is no finite number");
  refuse_text("x,a\n0,0x1\n", "'0x1' is no finite number");
  refuse_text("x,a\n0,1e999\n", "'1e999' is no finite number");
  refuse_text("x,a\n0,\n", "'' is no finite number");
  refuse_text("x,a\n0,1 2\n", "'1 2' is no finite number");
  refuse_text("x,a [deg]\n0,1e308\n", "p.csv:2: column 2: 1e308 is too large");
  refuse_text("x,a\n0,0\n0,-1.1e12\n", "p.csv:3: column 2: -1.1e12 is too large");
  refuse_text("x,a\n0,0\n0.6,0\n",
              "p.csv:3: column 1, joint x: 0.6 m is above its limit of 0.5 m; mend it, or give "
              "--ignore-limits");
  refuse_text("x [mm],a\n-500.1,0\n", "joint x: -500.1 mm is below its limit of -500 mm");
  refuse_text("x,a\n0.3,0\n", "p.csv:2: joint m: 0.6 m is above its limit of 0.5 m");
  refuse_text("time,x,a\n1,0,0\n0.5,0,0\n", "p.csv:3: time runs back, from 1 s to 0.5 s");
  refuse_bytes("x,a\n0,\0\n", 8, "bytes of zero");
}
