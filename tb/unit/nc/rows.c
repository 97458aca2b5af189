/* SPDX-License-Identifier: MIT */
/* rows.c - rows of whole programs: breaks, tools, limits, kinematics that change, blending, speed.
 */
#include "streams.h"

#include <time.h>

static const char trt[] = "parameter y-offset 20\nparameter z-offset 10\n"
                          "parameter tool-offset 0 z\n";
static const double origin[NC_AXES] = {0};

/* A program of a machine with straight axes within +-100. */
static nc_motion rows_of(const char *program, const nc_rules *rules) {
  stream t;
  nc_motion m;
  text_begin(&t);
  put_head(&t, "trivkins", "", "XYZC", 100, origin);
  fprintf(t.out, "%send 0 99\n", program);
  assert_works(text_read(&t, &m, rules));
  return m;
}

static void refuse(const char *machine, const char *program, const char *part) {
  stream t;
  nc_motion m;
  bool trivial = strncmp(machine, "trivkins", 8) == 0;
  text_begin(&t);
  put_head(&t, machine, strncmp(machine, "xyzac", 5) == 0 ? trt : "", trivial ? "XYZC" : "XYZAC",
           100, origin);
  fprintf(t.out, "%send 0 99\n", program);
  assert_fault(text_read(&t, &m, NULL), part);
  assert_true(m.rows == 0 && m.row == NULL && m.value == NULL);
}

static double at(const nc_motion *m, size_t row, size_t joint) {
  return m->value[row * m->joints + joint];
}

CASE(test_program) {
  nc_motion m = rows_of("spindle 0 2 on\n"
                        "move rapid 0 3 10 0 0 0 0 0 0 0 0\n"
                        "dwell 0 4 1\n"
                        "load 0 5 7\n"
                        "spindle 0 6 off\n"
                        "move feed 0 7 10 20 0 0 0 90 0 0 0\n"
                        "move probe 0 8 10 20 5 0 0 90 0 0 0\n"
                        "move rapid 0 9 0 0 0 0 0 0 0 0 0\n",
                        &(nc_rules){.dogleg = true});
  assert_int_equal(m.rows, 7);
  static const nc_row rows[7] = {
      {NC_RAPID, 0, 3, -1, NC_FIRST, NC_UNBOUNDED, 0, true, true, 0},
      {NC_RAPID, 0, 3, -1, NC_GOES_ON, NC_UNBOUNDED, 0, true, true, 1},
      {NC_DWELL, 0, 4, -1, NC_GOES_ON, NC_UNBOUNDED, 0, true, false, 1},
      {NC_FEED, 0, 7, 7, NC_LOADED, NC_UNBOUNDED, 0, false, false, 0},
      {NC_FEED, 0, 7, 7, NC_GOES_ON, NC_UNBOUNDED, 0, false, false, 1},
      {NC_PROBE, 0, 8, 7, NC_GOES_ON, NC_UNBOUNDED, 0, false, false, 1},
      {NC_RAPID, 0, 9, 7, NC_PROBED, NC_UNBOUNDED, 0, false, true, 1},
  };
  for (size_t n = 0; n < m.rows; n++) {
    const nc_row *a = &rows[n], *b = &m.row[n];
    assert_true(a->kind == b->kind && a->file == b->file && a->line == b->line);
    assert_true(a->tool == b->tool && a->begins == b->begins && a->blend == b->blend);
    assert_true(a->spindle == b->spindle && a->dogleg == b->dogleg && a->share == b->share);
  }
  assert_true(fabs(at(&m, 4, 1) - 0.02) < 1e-17 && fabs(at(&m, 4, 3) - PI / 2) < 1e-15);
  assert_true(at(&m, 3, 0) == at(&m, 2, 0));
  nc_motion_free(&m);
}

/* Motions that end where they begin have a row, but no part in blending. */
CASE(test_no_way) {
  nc_motion m = rows_of("blend 0 1 within 0.5\n"
                        "move feed 0 2 10 0 0 0 0 0 0 0 0\n"
                        "move feed 0 3 10 0 0 0 0 0 0 0 0\n"
                        "move feed 0 4 10 20 0 0 0 0 0 0 0\n",
                        &(nc_rules){.servo_linear = -1, .servo_angular = -1});
  assert_int_equal(m.rows, 4);
  for (size_t row = 0; row < m.rows; row++) {
    double off = row == 0 || row == 2 ? 0 : 0.0005;
    assert_true(fabs(m.blending[row * m.joints] - off) < 1e-12);
    assert_true(m.blending[row * m.joints + 2] < 1e-100);
  }
  nc_motion_free(&m);
}

/* Smoothing by the servo period and twice the acceleration, where the joints are the axes; else no
 * less than the default. */
CASE(test_smoothing) {
  static const char *const machine[2] = {"trivkins", "xyzac-trt-kins"};
  static const char *const linear[4] = {" 600", " 60000", "", " 0"};
  static const double most[2][4] = {{2e-7, 2e-5, 1e-6, 1e-6}, {1e-6, 2e-5, 1e-6, 1e-6}};
  for (int n = 0; n < 16; n++) {
    const double *off = &most[n % 2][n / 4];
    stream t;
    nc_motion m;
    text_begin(&t);
    fprintf(t.out, "sepax-nc 1\nfile 0 a.ngc\nmachine %s\n%s%s", machine[n % 2],
            n % 2 == 0 ? "" : trt, n / 2 % 2 == 0 ? "servo 0.001\n" : "");
    for (int j = 0; j < 3; j++) {
      fprintf(t.out, "joint %d %c linear -100 100%s\n", j, "XYZ"[j], linear[n / 4]);
    }
    fprintf(t.out, "joint 3 %c angular -100 100\njoint 4 C angular -100 100 %.17g\n", 'A',
            2 * 180 / PI);
    fprintf(t.out, "start given 0 0 0 0 0 0 0 0 0\nmove rapid 0 1 1 1 1 1 0 1 0 0 0\nend 0 2\n");
    assert_works(text_read(&t, &m, NULL));
    bool told = n / 2 % 2 == 0;
    assert_true(fabs(m.smoothing[0] / (told ? *off : 1e-6) - 1) < 1e-9);
    assert_true(m.smoothing[3] == 1e-5);
    assert_true(fabs(m.smoothing[4] / (told && n % 2 == 0 ? 2 * 2e-6 / 6 : 1e-5) - 1) < 1e-9);
    assert_true(fabs(m.blending[m.joints] - m.smoothing[0]) < 1e-15);
    nc_motion_free(&m);
  }
}

CASE(test_blends) {
  nc_motion m = rows_of("blend 0 1 exact\n"
                        "move feed 0 2 10 0 0 0 0 0 0 0 0\n"
                        "move feed 0 3 10 20 0 0 0 0 0 0 0\n"
                        "blend 0 4 within 0.5\n"
                        "move feed 0 5 10 20 30 0 0 0 0 0 0\n"
                        "dwell 0 6 1\n"
                        "blend 0 7 unbounded\n"
                        "move feed 0 8 0 20 30 0 0 0 0 0 0\n"
                        "move feed 0 9 0 15 30 0 0 0 0 0 0\n",
                        NULL);
  static const double servo = 1e-6; /* of joints that move, or do so beside */
  static const double most[][3] = {{0, 0, 0}, {0, 0, 0},    {0, 5e-4, 5e-4}, {0, 5e-4, 5e-4},
                                   {0, 0, 0}, {0, 5e-3, 0}, {0, 5e-3, 0}};
  assert_int_equal(m.rows, LENGTH(most));
  for (size_t row = 0; row < m.rows; row++) {
    for (size_t j = 0; j < 3; j++) {
      bool moves = (row == 1 && j < 2) || row == 2 || (row == 3 && j > 0) || (row > 4 && j < 2);
      double off = most[row][j] + (moves ? servo : 0);
      assert_true(fabs(m.blending[row * m.joints + j] - off) < 1e-12);
    }
  }
  assert_true(m.smoothing[0] == servo && m.smoothing[3] == 1e-5);
  assert_true(m.row[3].within == 0.0005 && m.row[3].blend == NC_WITHIN);
  nc_motion_free(&m);
}

/* Lines that LinuxCNC may merge: an axis that moves in one of them may be off in all. A corner
 * sharper than the tolerance ends the merging. */
CASE(test_merging) {
  nc_motion m = rows_of("blend 0 1 within 0.5\n"
                        "move feed 0 2 10 0 0 0 0 0 0 0 0\n"
                        "move feed 0 3 20 0.1 0 0 0 0 0 0 0\n"
                        "move feed 0 4 30 0.1 0 0 0 0 0 0 0\n"
                        "move feed 0 5 30 0.1 40 0 0 0 0 0 0\n",
                        NULL);
  assert_int_equal(m.rows, 5);
  for (size_t row = 1; row < 4; row++) {
    assert_true(m.blending[row * m.joints + 1] > 4.99e-4);
  }
  assert_true(m.blending[1 * m.joints + 2] < 1e-100);
  assert_true(m.blending[3 * m.joints + 2] > 4.99e-4);
  nc_motion_free(&m);
}

CASE(test_limits) {
  refuse("trivkins", "move feed 0 7 0 100.1 0 0 0 0 0 0 0\n",
         "part.ngc:7: joint 1 (axis Y) goes to 100.1 mm, above its limit of 100 mm");
  refuse("trivkins", "move feed 0 7 0 0 0 0 0 -101 0 0 0\n",
         "part.ngc:7: joint 3 (axis C) goes to -101 deg, below its limit of -100 deg");
  refuse("trivkins", "move feed -1 0 0 0 -150 0 0 0 0 0 0\n",
         "(a file of unknown name): joint 2 (axis Z)");
  /* An arc whose ends are within the limits. */
  refuse("trivkins",
         "move feed 0 1 90 0 0 0 0 0 0 0 0\n"
         "arc feed 0 2 90 40 0 0 0 0 0 0 0 90 20 0 0 0 1 0\n",
         "part.ngc:2: joint 0 (axis X) goes to");
  /* It touches the limit between two rows, which are within. */
  refuse("trivkins",
         "move feed 0 1 79.9999995 0 0 0 0 0 0 0 0\n"
         "arc feed 0 2 79.9999995 40 0 0 0 0 0 0 0 79.9999995 20.0000037 0 0 0 1 0\n",
         "part.ngc:2: joint 0 (axis X) ");
  /* Within the limits as axes, but not as joints. */
  refuse("xyzac-trt-kins", "move feed 0 3 90 90 0 0 0 45 0 0 0\n",
         "part.ngc:3: joint 1 (axis Y) goes to");
  nc_motion m = rows_of("move feed 0 7 0 100 0 0 0 -100 0 0 0\n", NULL);
  assert_int_equal(m.rows, 2);
  nc_motion_free(&m);
  m = rows_of("move feed 0 7 0 200 0 0 0 0 0 0 0\n", &(nc_rules){.ignore_limits = true});
  assert_int_equal(m.rows, 2);
  nc_motion_free(&m);
}

CASE(test_refused) {
  refuse("trivkins", "dwell 0 1 1\n", "part.ngc: the program moves nothing");
  refuse("scarakins", "move feed 0 1 1 0 0 0 0 0 0 0 0\n", "'scarakins' are none of");
  refuse("trivkins coordinates=XYZA", "move feed 0 1 1 0 0 0 0 0 0 0 0\n", "coordinates=XYZA");
  refuse("trivkins sparm=identityfirst", "move feed 0 1 1 0 0 0 0 0 0 0 0\n", "no parameter");
  refuse("xyzbc-trt-kins", "move feed 0 1 1 0 0 0 0 0 0 0 0\n", "needs a joint for axis B");
  refuse("trivkins", "kins 0 3 1 0 0 0 0 0 0 0 0 0\n", "part.ngc:3: the kinematics have no type 1");
  refuse("xyzac-trt-kins", "kins 0 3 2 0 0 0 0 0 0 0 0 0\n", "have no type 2");
  refuse("trivkins", "arc feed 0 4 5 0 0 0 0 0 0 0 0 0 0 0 0 0 1 0\n",
         "part.ngc:4: an end of the arc is its centre");
  refuse("trivkins", "arc feed 0 4 50 0 0 0 0 0 0 0 0 -1 0 0 0 0 1 0\n", "radii");
  nc_motion m;
  stream t;
  text_begin(&t);
  fprintf(t.out, "sepax-nc 1\n");
  assert_fault(text_read(&t, &m, &(nc_rules){.linear = 1e-13}), "a tolerance is below");
  text_begin(&t);
  put_head(&t, "xyzac-trt-kins", "parameter conventional-directions 1\n", "XYZAC", 1, origin);
  fprintf(t.out, "end 0 1\n");
  assert_fault(text_read(&t, &m, NULL), "conventional-directions is 1");
}

/* A program on a machine whose table turns; `program` follows the head. */
static nc_motion table(const char *program) {
  stream t;
  nc_motion m;
  text_begin(&t);
  put_head(&t, "xyzac-trt-kins sparm=identityfirst", trt, "XYZAC", 400, origin);
  fprintf(t.out, "blend 0 1 exact\n%send 0 99\n", program);
  assert_works(text_read(&t, &m, NULL));
  return m;
}

/* When the kinematics change, the joints stay; what the front end says of the axes is checked. */
CASE(test_kinematics_change) {
  nc_motion m = table("move feed 0 2 10 20 -5 0 0 0 0 0 0\n"
                      "kins 0 3 1 10 20 -5 0 0 0 0 0 0\n"
                      "move feed 0 4 10 20 -5 0 0 90 0 0 0\n");
  assert_true(m.rows > 10);
  const double last = at(&m, m.rows - 1, 0);
  assert_true(fabs(last + 0.02) < 1e-15);
  for (size_t n = 1; n < m.rows; n++) {
    assert_true(m.row[n].begins == NC_GOES_ON);
  }
  nc_motion_free(&m);
  refuse("xyzac-trt-kins sparm=identityfirst",
         "move feed 0 2 10 20 -5 -20 0 30 0 0 0\nkins 0 3 1 10 20 -5 -20 0 30 0 0 0\n",
         "part.ngc:3: at the change of the kinematics");
}

/* A tool offset that the kinematics use makes the joints jump, if the table is tilted. */
CASE(test_displaced) {
  static const nc_break expected[] = {NC_GOES_ON, NC_DISPLACED};
  for (int tilted = 0; tilted < 2; tilted++) {
    char program[512];
    snprintf(program, sizeof program,
             "kins 0 2 1 0 0 0 0 0 0 0 0 0\n"
             "move feed 0 3 10 0 0 %d 0 0 0 0 0\n"
             "length 0 4 0 0 50 0 0 0 0 0 0\n"
             "move feed 0 5 20 0 0 %d 0 0 0 0 0\n",
             tilted * 30, tilted * 30);
    nc_motion m = table(program);
    size_t row = 0;
    while (row < m.rows && m.row[row].line != 5) {
      row++;
    }
    assert_true(row < m.rows && m.row[row].begins == expected[tilted]);
    double jump = fabs(at(&m, row, 1) - at(&m, row - 1, 1));
    assert_true(tilted ? jump > 0.01 : jump < 1e-15);
    nc_motion_free(&m);
  }
}

/* 4,500 lines of five axes in well under a second. */
CASE(test_speed) {
  stream t;
  nc_motion m;
  text_begin(&t);
  put_head(&t, "xyzac-trt-kins", trt, "XYZAC", 1000, origin);
  for (int n = 0; n < 4500; n++) {
    double turn = 0.07 * n, axis[NC_AXES] = {0};
    axis[NC_X] = 15 * cos(turn) + random_unit();
    axis[NC_Y] = 15 * sin(turn) + random_unit();
    axis[NC_Z] = 20 + 5 * sin(0.01 * n);
    axis[NC_A] = -60 + 10 * cos(0.3 * turn);
    axis[NC_C] = 20 * sin(turn);
    put_move(&t, n % 25 == 0 ? "rapid" : "feed", n + 1, axis);
  }
  fprintf(t.out, "end 0 5000\n");
  clock_t before = clock();
  assert_works(text_read(&t, &m, NULL));
  double seconds = (double)(clock() - before) / CLOCKS_PER_SEC;
  print_message("%zu rows in %.3f s\n", m.rows, seconds);
  assert_true(m.rows > 4500 && seconds < 1.0 * FEWER_BY);
  nc_motion_free(&m);
}
