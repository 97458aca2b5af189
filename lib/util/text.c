/* SPDX-License-Identifier: MIT */
/* text.c - whole files, and decimal numbers in them. */
#include "util/text.h"
#include "util/error.h"

#include <errno.h>
#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* ------------------------------------------------------------------- files */

static bool is_readable_kind(FILE *in, size_t *bytes, const char *path, sepax_error *error) {
  struct stat s;
  if (fstat(fileno(in), &s) != 0) {
    return sepax_fail(error, SEPAX_ERROR_FILE, "%.300s: %s; check the file", path, strerror(errno));
  }
  if (S_ISDIR(s.st_mode)) {
    return sepax_fail(error, SEPAX_ERROR_FILE, "%.300s: is a directory; name a file", path);
  }
  if (!S_ISREG(s.st_mode) && !S_ISFIFO(s.st_mode)) {
    return sepax_fail(error, SEPAX_ERROR_FILE, "%.300s: is neither a file nor a pipe; name a file",
                      path);
  }
  *bytes = S_ISREG(s.st_mode) && s.st_size > 0 ? (size_t)s.st_size : 0;
  return true;
}

/* `bytes` is how many are expected. */
static bool read_stream(text_bytes *text, FILE *in, size_t bytes, size_t most, const char *path,
                        sepax_error *error) {
  static const size_t first = (size_t)1 << 16;
  size_t capacity = bytes >= first ? bytes + 2 : first;
  while (bytes <= most) {
    char *grown = sepax_resize(text->bytes, capacity);
    if (grown == NULL) {
      return sepax_fail(error, SEPAX_ERROR_MEMORY, "%.300s: no memory for %zu bytes", path,
                        capacity);
    }
    text->bytes = grown;
    text->size += fread(grown + text->size, 1, capacity - text->size - 1, in);
    grown[text->size] = '\0';
    bytes = text->size;
    if (text->size + 1 < capacity && bytes <= most) {
      return ferror(in) == 0 || sepax_fail(error, SEPAX_ERROR_FILE, "%.300s: %s; check the file",
                                           path, strerror(errno));
    }
    capacity *= 2;
  }
  return sepax_fail(error, SEPAX_ERROR_LIMIT, "%.300s: longer than %zu MiB; split it", path,
                    most >> 20);
}

bool sepax__text_read(text_bytes *text, const char *path, size_t most, sepax_error *error) {
  *text = (text_bytes){NULL, 0};
  FILE *in = fopen(path, "rb");
  if (in == NULL) {
    return sepax_fail(error, SEPAX_ERROR_FILE, "%.300s: %s; check the path", path, strerror(errno));
  }
  size_t bytes = 0;
  bool ok =
      is_readable_kind(in, &bytes, path, error) && read_stream(text, in, bytes, most, path, error);
  fclose(in);
  if (!ok) {
    sepax_release(text->bytes);
    *text = (text_bytes){NULL, 0};
  }
  return ok;
}

bool sepax__text_csv(text_bytes *text, size_t *begin, const char *path, size_t most,
                     sepax_error *error) {
  static const char mark[] = "\xef\xbb\xbf";
  if (!sepax__text_read(text, path, most, error)) {
    return false;
  }
  if (memchr(text->bytes, '\0', text->size) != NULL) {
    sepax_release(text->bytes);
    *text = (text_bytes){NULL, 0};
    return sepax_fail(error, SEPAX_ERROR_FORMAT, "%.300s: it has bytes of zero; give CSV as text",
                      path);
  }
  *begin = strncmp(text->bytes, mark, strlen(mark)) == 0 ? strlen(mark) : 0;
  return true;
}

/* ----------------------------------------------------------------- numbers */

enum { FIVES = 28 };

/* 5^n < 2^64 */
static const uint64_t five[FIVES] = {
    1,
    5,
    25,
    125,
    625,
    3125,
    15625,
    78125,
    390625,
    1953125,
    9765625,
    48828125,
    244140625,
    1220703125,
    6103515625,
    30517578125,
    152587890625,
    762939453125,
    3814697265625,
    19073486328125,
    95367431640625,
    476837158203125,
    2384185791015625,
    11920928955078125,
    59604644775390625,
    298023223876953125,
    1490116119384765625,
    7450580596923828125,
};

/* 10^n that are doubles */
enum { TENS = 23 };
static const double ten[TENS] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                 1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/* digits * 10^power of |power| < FIVES, rounded to the nearest, ties to even. The processor rounds
 * the quotient or the product of two doubles so. Otherwise they are exact in 128 bits but for a
 * remainder, of which only one bit counts: whether it is 0. */
static double scaled(uint64_t digits, int power) {
  if (FLT_EVAL_METHOD == 0 && digits <= (uint64_t)1 << 53 && power > -TENS && power < TENS) {
    return power < 0 ? (double)digits / ten[-power] : (double)digits * ten[power];
  }
  if (digits == 0) {
    return 0;
  }
  int shift = __builtin_clzll(digits);
  unsigned __int128 whole = 0;
  int two = 0; /* the value is whole * 2^two */
  if (power >= 0) {
    whole = (unsigned __int128)(digits << shift) * five[power];
    two = power - shift;
  } else {
    unsigned __int128 high = (unsigned __int128)(digits << shift) << 64;
    whole = high / five[-power];
    whole |= whole * five[-power] != high;
    two = power - shift - 64;
  }
  uint64_t top = (uint64_t)(whole >> 64);
  int length = top != 0 ? 128 - __builtin_clzll(top) : 64 - __builtin_clzll((uint64_t)whole);
  int drop = length - 53;
  if (drop > 0) {
    unsigned __int128 rest = whole & (((unsigned __int128)1 << drop) - 1);
    unsigned __int128 half = (unsigned __int128)1 << (drop - 1);
    whole >>= drop;
    whole += rest > half || (rest == half && (whole & 1) != 0);
    two += drop;
  }
  return ldexp((double)(uint64_t)whole, two);
}

typedef struct {
  uint64_t digits;
  int power, used; /* digits that count, without zeros before them */
} decimal;

static bool is_digit(char c) { return (unsigned char)(c - '0') < 10; }

static const char *scan_digits(const char *c, decimal *d, bool behind_point) {
  for (; is_digit(*c); c++) {
    d->used += d->used > 0 || *c != '0';
    if (d->used < 20) {
      d->digits = 10 * d->digits + (uint64_t)(*c - '0');
      d->power -= behind_point;
    }
  }
  return c;
}

/* A run of digits behind those that *digits has; wrong where there are more than 19 in all. */
static const char *scan_few(const char *c, uint64_t *digits) {
  uint64_t sum = *digits;
  for (; is_digit(*c); c++) {
    sum = 10 * sum + (uint64_t)(*c - '0');
  }
  *digits = sum;
  return c;
}

/* Behind the digits; c where there is no exponent. */
static const char *scan_exponent(const char *c, int *power) {
  if (*c != 'e' && *c != 'E') {
    return c;
  }
  const char *e = c + 1;
  bool negative = *e == '-';
  e += *e == '-' || *e == '+';
  if (*e < '0' || *e > '9') {
    return c;
  }
  int value = 0;
  for (; *e >= '0' && *e <= '9'; e++) {
    value = value < 100000 ? 10 * value + (*e - '0') : value;
  }
  *power += negative ? -value : value;
  return e;
}

/* Behind the digits and the point; NULL where there is no digit. */
static const char *scan_number(const char *begin, decimal *d) {
  const char *c = scan_few(begin, &d->digits);
  bool point = *c == '.';
  const char *fraction = c + point;
  c = point ? scan_few(fraction, &d->digits) : c;
  d->power = point ? -(int)(c - fraction) : 0;
  ptrdiff_t count = c - begin - point;
  if (count < 20) {
    d->used = (int)count;
    return count > 0 ? c : NULL;
  }
  *d = (decimal){0, 0, 0};
  c = scan_digits(begin, d, false);
  return point ? scan_digits(fraction, d, true) : c;
}

/* Numbers of more than 19 digits, or of many zeros, are left to strtod. */
const char *sepax__decimal(const char *text, double *value) {
  decimal d = {0, 0, 0};
  const char *c = scan_number(text + (*text == '-' || *text == '+'), &d);
  if (c == NULL) {
    return NULL;
  }
  c = scan_exponent(c, &d.power);
  if (d.used < 20 && d.power > -FIVES && d.power < FIVES) {
    double size = scaled(d.digits, d.power);
    *value = *text == '-' ? -size : size;
  } else {
    *value = strtod(text, NULL);
  }
  return c;
}

bool sepax__number(const char *word, size_t length, double *number) {
  const char *end = length > 0 ? sepax__decimal(word, number) : NULL;
  return end == word + length && isfinite(*number);
}
