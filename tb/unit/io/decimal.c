/* SPDX-License-Identifier: MIT */
/* decimal.c - decimals become the nearest double: against strtod, on those that are hard. */
#include "harness.h"
#include "util/text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static uint64_t seed = 88172645463325252U;

static uint64_t next_random(void) {
  seed ^= seed << 13;
  seed ^= seed >> 7;
  seed ^= seed << 17;
  return seed;
}

static int below(int n) { return (int)(next_random() % (unsigned)n); }

static void assert_same(const char *text) {
  double value = -1;
  char *end = NULL;
  double expected = strtod(text, &end);
  const char *got = sepax__decimal(text, &value);
  if (got != end || value != expected || signbit(value) != signbit(expected)) {
    fail_msg("%s: %a, not %a", text, value, expected);
  }
}

/* Halfway between two doubles, or one unit of the last digit beside that. */
static void put_halfway(char text[80]) {
  uint64_t odd = ((uint64_t)1 << 53) | (next_random() >> 11) | 1;
  int shift = 1 + below(10);
  uint64_t half = (odd << shift) + ((uint64_t)1 << (shift - 1)) + (uint64_t)(below(3) - 1);
  snprintf(text, 80, "%s%llu%s", below(2) != 0 ? "-" : "", (unsigned long long)half,
           below(2) != 0 ? "" : "e0");
}

static void put_hard(char text[80], int kind) {
  char last[16];
  uint64_t bits = next_random();
  double any;
  memcpy(&any, &bits, sizeof any);
  switch (kind) {
  case 0:
    put_halfway(text);
    break;
  case 1: /* of any size, subnormal ones among them */
    snprintf(text, 80, "%.*e", below(21), isfinite(any) ? any : 1);
    break;
  case 2: /* near the ends of the powers that are divided exactly */
    snprintf(text, 80, "%llu.%llue%d", (unsigned long long)(next_random() % 100000000),
             (unsigned long long)(next_random() % 100000000000U), below(70) - 35);
    break;
  case 3: /* 18 to 21 digits */
    snprintf(last, sizeof last, "%012llu", (unsigned long long)(next_random() % 1000000000));
    snprintf(text, 80, "0.%09llu%s", (unsigned long long)(next_random() % 1000000000),
             last + below(4));
    break;
  default: /* as files have them */
    snprintf(text, 80, "%s%d.%0*d%s", below(2) != 0 ? "+" : "", below(2000), 1 + below(6),
             below(10), below(4) == 0 ? "E-02" : "");
    break;
  }
}

CASE(random_decimals) {
  long count = FEWER(2000000);
  char text[80];
  for (long n = 0; n < count; n++) {
    put_hard(text, (int)(n % 5));
    assert_same(text);
  }
}

CASE(decimals_of_their_own) {
  static const char *const texts[] = {
      "0",
      "-0",
      "0.0",
      ".5",
      "5.",
      "1e5",
      "1E+05",
      "1e-5",
      "1e",
      "1e+",
      "1ex",
      "1.5.5",
      "00000001",
      "1e400",
      "-1e400",
      "1e-400",
      "4.9e-324",
      "2.4703282292062328e-324",
      "2.4703282292062327e-324",
      "1.7976931348623157e308",
      "1.7976931348623159e308",
      "9007199254740993",
      "9007199254740992.99999999999999999999999999",
      "0.1000000000000000055511151231257827021181583404541015625",
      "1e22",
      "1e23",
      "123456789012345678901234567890",
      "0.000000000000000000000000000000000001",
      "1e99999999999999999999",
      "1e-99999999999999999999",
      "0e99999999999999999999",
  };
  for (size_t n = 0; n < sizeof texts / sizeof texts[0]; n++) {
    assert_same(texts[n]);
  }
  static const char *const none[] = {"", "-", "+", ".", "-.", "e5", "nan", "inf", "x", " 1", "--1"};
  for (size_t n = 0; n < sizeof none / sizeof none[0]; n++) {
    double value;
    assert_null(sepax__decimal(none[n], &value));
  }
  double value = 0;
  assert_true(sepax__number("1.5 2", 3, &value) && value == 1.5);
  assert_false(sepax__number("1.5 2", 5, &value));
  assert_false(sepax__number("1e999", 5, &value));
  assert_false(sepax__number("0x10", 4, &value));
}
