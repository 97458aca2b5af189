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
      {"", "no pose in it"},
      {"# nothing\n\n", "no pose in it"},
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
