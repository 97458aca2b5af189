/* SPDX-License-Identifier: MIT */
/* poses.c - files of poses: decimals rounded once, in any locale; what is refused. */
#include "harness.h"

#include <float.h>
#include <gmp.h>
#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void put_text(const char *text) {
  FILE *out = fopen(path, "w");
  assert_non_null(out);
  assert_true(fputs(text, out) != EOF);
  assert_int_equal(fclose(out), 0);
}

static sepax_poses read_text(const char *text) {
  sepax_poses poses;
  put_text(text);
  assert_works(sepax_poses_read(&poses, path, &fault));
  return poses;
}

static void refuse_text(const char *text, const char *part) {
  sepax_poses poses;
  put_text(text);
  assert_fault(sepax_poses_read(&poses, path, &fault), part);
  assert_message(path);
  assert_null(poses.pose);
  assert_int_equal(poses.count, 0);
}

CASE(test_layout) {
  sepax_poses poses = read_text("# all\n\n0 -1 0 1 0 0 0 0 1 7 8 9 # last\n \t\r\n"
                                "1 0 0 0 1 0 0 0 1 -.5 1.e1 +2E-1");
  static const sepax_pose turned = {{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}, {7, 8, 9}};
  static const double moved[3] = {-0.5, 10, 0.2};
  assert_int_equal(poses.count, 2);
  assert_memory_equal(&poses.pose[0], &turned, sizeof turned);
  assert_memory_equal(poses.pose[1].translation, moved, sizeof moved);
  sepax_poses_free(&poses);
  assert_null(poses.pose);
  poses = read_text("\xef\xbb\xbf"
                    "0 -1 0 1 0 0 0 0 1 7 8 9\n"); /* a byte order mark */
  assert_int_equal(poses.count, 1);
  assert_memory_equal(&poses.pose[0], &turned, sizeof turned);
  sepax_poses_free(&poses);
}

/* A rotation about a random axis. */
static sepax_pose draw_rotation(void) {
  double q[4];
  double square = 0;
  sepax_pose p = {.translation = {1, 2, 3}};
  for (int i = 0; i < 4; i++) {
    q[i] = random_unit();
    square += q[i] * q[i];
  }
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3;
    int k = (i + 2) % 3;
    p.rotation[i][i] = 1 - 2 * (q[j] * q[j] + q[k] * q[k]) / square;
    p.rotation[i][j] = 2 * (q[i] * q[j] - q[k] * q[3]) / square;
    p.rotation[i][k] = 2 * (q[i] * q[k] + q[j] * q[3]) / square;
  }
  return p;
}

/* The nearest rotation R of a matrix M: R^T M is symmetric and positive. */
static void check_nearest(const sepax_pose *matrix, const sepax_pose *nearest) {
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      double unit = 0;
      double wrong = 0;
      for (int k = 0; k < 3; k++) {
        unit += nearest->rotation[k][i] * nearest->rotation[k][j];
        wrong += nearest->rotation[k][i] * matrix->rotation[k][j] -
                 nearest->rotation[k][j] * matrix->rotation[k][i];
      }
      assert_true(fabs(unit - (i == j)) < 1e-15 * 8 && fabs(wrong) < 1e-15 * 8);
    }
    assert_true(nearest->translation[i] == matrix->translation[i]);
  }
}

CASE(test_nearest) {
  double most = 0;
  for (int n = 0; n < FEWER(20000); n++) {
    sepax_pose matrix = draw_rotation();
    double off = ldexp(1, -7 - random_below(50));
    for (int i = 0; i < 9; i++) {
      matrix.rotation[i / 3][i % 3] += 0.6 * off * random_unit();
    }
    sepax_pose nearest = matrix;
    double moved = -1;
    assert_works(sepax_pose_nearest(&nearest, &moved, &fault));
    check_nearest(&matrix, &nearest);
    double way = 0;
    for (int i = 0; i < 9; i++) {
      way = fmax(way, fabs(nearest.rotation[i / 3][i % 3] - matrix.rotation[i / 3][i % 3]));
    }
    assert_true(moved == way && way <= 0.01);
    most = fmax(most, way);
    sepax_pose again = nearest;
    assert_works(sepax_pose_nearest(&again, NULL, &fault));
    check_nearest(&nearest, &again);
  }
  assert_true(most > 0.003);
  sepax_pose p = {.rotation = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  sepax_pose same = p;
  assert_works(sepax_pose_nearest(&p, NULL, &fault));
  assert_memory_equal(&p, &same, sizeof p);
  p.rotation[0][0] = 1.011;
  assert_fault(sepax_pose_nearest(&p, NULL, &fault), "differs by more than 0.01");
  assert_true(p.rotation[0][0] == 1.011);
  p.rotation[0][0] = 1e300;
  assert_fault(sepax_pose_nearest(&p, NULL, &fault), "more than 0.01");
  p.rotation[0][0] = -1;
  assert_fault(sepax_pose_nearest(&p, NULL, &fault), "reflection");
  p.rotation[0][0] = NAN;
  assert_fault(sepax_pose_nearest(&p, NULL, &fault), "finite");
  p.rotation[0][0] = 1;
  p.translation[2] = INFINITY;
  assert_fault(sepax_pose_nearest(&p, NULL, &fault), "finite");
}

CASE(test_read_nearest) {
  sepax_poses poses;
  double moved;
  put_text("1 0 0 0 1 0 0 0 1 7 8 9\n1.002 0 0 0 .999 0 0 0 1 4 5 6\n1 0 0 0 1 0 0 0 1 1 2 3\n");
  assert_fault(sepax_poses_read(&poses, path, &fault), ":2: the matrix is no rotation");
  assert_works(sepax_poses_read_nearest(&poses, &moved, path, &fault));
  assert_int_equal(poses.count, 3);
  static const sepax_pose second = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {4, 5, 6}};
  assert_true(fabs(poses.pose[1].rotation[0][0] - 1) < 1e-15);
  assert_memory_equal(poses.pose[1].translation, second.translation, sizeof second.translation);
  assert_true(fabs(moved - 0.002) < 1e-15);
  sepax_poses_free(&poses);
  put_text("1 0 0 0 1 0 0 0 1 7 8 9\n1.02 0 0 0 1 0 0 0 1 4 5 6\n");
  assert_fault(sepax_poses_read_nearest(&poses, &moved, path, &fault), ":2: the matrix is no");
  assert_null(poses.pose);
}

CASE(test_many) {
  enum { POSES = 3000 };
  FILE *out = fopen(path, "w");
  assert_non_null(out);
  for (int n = 0; n < POSES; n++) {
    fprintf(out, "1 0 0 0 1 0 0 0 1 %d 0 0\n", n);
  }
  fclose(out);
  sepax_poses poses;
  assert_works(sepax_poses_read(&poses, path, &fault));
  assert_int_equal(poses.count, POSES);
  for (int n = 0; n < POSES; n++) {
    assert_true(poses.pose[n].translation[0] == n);
  }
  sepax_poses_free(&poses);
}

/* The decimal of `digits` times 10^power is no nearer to a neighbour of x. */
static void assert_nearest(const char *digits, int power, double x) {
  mpq_t exact;
  mpq_t distance[3];
  mpz_t ten;
  mpq_init(exact);
  mpz_init(ten);
  mpq_set_str(exact, digits, 10);
  mpz_ui_pow_ui(ten, 10, (unsigned)abs(power));
  mpz_mul(power < 0 ? mpq_denref(exact) : mpq_numref(exact),
          power < 0 ? mpq_denref(exact) : mpq_numref(exact), ten);
  mpq_canonicalize(exact);
  const double near[3] = {nextafter(x, -DBL_MAX), x, nextafter(x, DBL_MAX)};
  for (int i = 0; i < 3; i++) {
    mpq_init(distance[i]);
    mpq_set_d(distance[i], near[i]);
    mpq_sub(distance[i], distance[i], exact);
    mpq_abs(distance[i], distance[i]);
  }
  for (int i = 0; i < 3; i += 2) {
    int order = mpq_cmp(distance[1], distance[i]);
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    assert_true(order < 0 || (order == 0 && (bits & 1) == 0));
  }
  for (int i = 0; i < 3; i++) {
    mpq_clear(distance[i]);
  }
  mpq_clear(exact);
  mpz_clear(ten);
}

static void read_decimals(void) {
  enum { DECIMALS = 2000 };
  static struct {
    char digits[48];
    int power;
  } decimal[DECIMALS];
  FILE *out = fopen(path, "w");
  assert_non_null(out);
  for (int n = 0; n < DECIMALS; n++) {
    int length = 1 + random_below(40);
    decimal[n].power = random_below(400) - 280 - length;
    for (int i = 0; i < length; i++) {
      decimal[n].digits[i] = (char)('0' + random_below(10));
    }
    decimal[n].digits[length] = '\0';
    fprintf(out, "1 0 0 0 1 0 0 0 1 0 0.%se%d 0\n", decimal[n].digits, decimal[n].power + length);
  }
  assert_int_equal(fclose(out), 0);
  sepax_poses poses;
  assert_works(sepax_poses_read(&poses, path, &fault));
  assert_int_equal(poses.count, DECIMALS);
  for (int n = 0; n < DECIMALS; n++) {
    assert_nearest(decimal[n].digits, decimal[n].power, poses.pose[n].translation[1]);
  }
  sepax_poses_free(&poses);
}

/* Half-way cases, decimals with many digits, the ends of the range. */
CASE(test_rounding) {
  static const struct {
    const char *text;
    double value;
  } row[] = {{"9007199254740993", 0x1p53},
             {"9007199254740993.0000000000000000000000000000000001", 0x1p53 + 2},
             {"9007199254740995", 0x1p53 + 4},
             {"0.1", 0.1},
             {"4.9e-324", 0x1p-1074},
             {"2.4703282292062327e-324", 0},
             {"2.4703282292062328e-324", 0x1p-1074},
             {"1.7976931348623158e308", DBL_MAX},
             {"-2.2250738585072011e-308", 0x1p-1074 - 0x1p-1022}};
  for (size_t i = 0; i < LENGTH(row); i++) {
    char text[160];
    snprintf(text, sizeof text, "1 0 0 0 1 0 0 0 1 0 0 %s", row[i].text);
    sepax_poses poses = read_text(text);
    assert_true(poses.pose[0].translation[2] == row[i].value);
    sepax_poses_free(&poses);
  }
  read_decimals();
}

CASE(test_decimal_comma) {
  char command[2 * PATH_BYTES + 100];
  snprintf(command, sizeof command, "localedef -i de_DE -f UTF-8 %s/de_DE.UTF-8 > /dev/null 2>&1",
           folder);
  setenv("LOCPATH", folder, 1);
  if (system(command) == 0 && setlocale(LC_ALL, "de_DE.UTF-8") != NULL &&
      strcmp(localeconv()->decimal_point, ",") == 0) {
    read_decimals();
    refuse_text("1 0 0 0 1 0 0 0 1 1,5 0 0\n", "'1,5' is no number");
    assert_string_equal(localeconv()->decimal_point, ",");
  }
  setlocale(LC_ALL, "C");
  snprintf(command, sizeof command, "rm -rf %s/de_DE.UTF-8 %s", folder, path);
  assert_int_equal(system(command), 0);
}

CASE(test_refused) {
  static const char *const row[][2] = {
      {"", "the file has no poses"},
      {"# nothing\n\n", "the file has no poses"},
      {"1 0 0 0 1 0 0 0 1 0 0", ":1: 11 numbers; give 12"},
      {"\n1 0 0 0 1 0 0 0 1 0 0 0 0\n", ":2: 13 numbers; give 12"},
      {"#\n#\n1 0 0 0 1 0 0 0 1 0 nan 0\n", ":3: NaN is no number; give 12"},
      {"1 0 0 0 1 0 0 0 1 0 -NAN(1) 0\n", ":1: NaN is no number; give 12"},
      {"1 0 0 0 1 0 0 0 1 infinity 0 0\n", ":1: 'infinity' is no number; give 12"},
      {"1 0 0 0 1 0 0 0 1 1e309 0 0\n", ":1: 1e309 is too large"},
      {"1 0 0 0 1 0 0 0 1 0x1p0 0 0\n", "'0x1p0' is no number"},
      {"1 0 0 0 1 0 0 0 1 1,5 0 0\n", "'1,5' is no number"},
      {"\n\xef\xbb\xbf"
       "1 0 0 0 1 0 0 0 1 0 0 0\n",
       ":2: '???1' is no number"},
      {"1 0 0 0 1 0 0 0 1 1d0 0 0\n", "'1d0' is no number"},
      {"1 0 0 0 1 0 0 0 1 - 0 0\n", "'-' is no number"},
      {"1 0 0 0 1 0 0 0 1 0 0 0\n2 0 0 0 1 0 0 0 1 0 0 0\n", ":2: the matrix is no rotation"},
      {"1 0 0 0 1 0 0 0 -1 0 0 0\n", ":1: the matrix is a reflection"}};
  for (size_t i = 0; i < LENGTH(row); i++) {
    refuse_text(row[i][0], row[i][1]);
  }
  FILE *out = fopen(path, "wb");
  assert_non_null(out);
  fwrite("1 0 0 0 1 0 0 0 1 0 0 0\0 5\n", 1, 27, out);
  fclose(out);
  sepax_poses poses;
  assert_fault(sepax_poses_read(&poses, path, &fault), ":1: a byte of zero");
  assert_fault(sepax_poses_read(&poses, folder, &fault), "directory");
  assert_int_equal(remove(path), 0);
  assert_fault(sepax_poses_read(&poses, path, &fault), "No such file");
}
