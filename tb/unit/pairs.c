/* SPDX-License-Identifier: MIT */
/* pairs.c - pairs as text. */
#include "oracle/pair_tools.h"
#include "harness.h"

#include <stdio.h>
#include <string.h>

#define EIGHTEEN "0 0 0 7 0 0 0 7 0 1 1 -3 1 1 3 2 2 3"

static const sepax_pair untouched = {{{{1, 2, 3}, {4, 5, 6}, {7, -1, -2}}},
                                     {{{-3, -4, -5}, {-6, -7, -8}, {0, 1, 2}}},
                                     {3, 4, 5},
                                     {-1, -2, -3}};

static bool same_pair(const sepax_pair *p, const sepax_pair *q) {
  return memcmp(p, q, sizeof *p) == 0;
}

static bool fits_with(int32_t value, int number, int word) {
  sepax_pair pair = {0};
  *field(&pair, number) = value;
  return sepax_pair_fits(&pair, word);
}

/* The pair of a line that is one. */
static sepax_pair parsed(const char *line) {
  sepax_pair pair = untouched;
  fault.text[0] = '\0';
  assert_int_equal(sepax_pair_parse(&pair, line, 4, &fault), SEPAX_LINE_PAIR);
  assert_string_equal(fault.text, "");
  return pair;
}

/* A line that is none leaves the pair alone. */
static void assert_no_pair(const char *line, int word, sepax_line kind, const char *message) {
  sepax_pair pair = untouched;
  fault.text[0] = '\0';
  sepax_line got = sepax_pair_parse(&pair, line, word, &fault);
  assert_string_equal(fault.text, message);
  assert_int_equal(got, kind);
  assert_true(same_pair(&pair, &untouched));
}

CASE(fits_looks_at_every_field) {
  for (int word = SEPAX_WORD_MIN; word <= SEPAX_WORD_MAX; word++) {
    int32_t least = sepax_word_min(word);
    int32_t most = sepax_word_max(word);
    for (int number = 0; number < FIELDS; number++) {
      assert_true(fits_with(least, number, word));
      assert_true(fits_with(most, number, word));
      if (word < SEPAX_WORD_MAX) {
        assert_false(fits_with(least - 1, number, word));
        assert_false(fits_with(most + 1, number, word));
      }
    }
  }
}

CASE(printing_is_24_integers) {
  char text[256] = "";
  FILE *out = fmemopen(text, sizeof text, "w");
  assert_non_null(out);
  sepax_pair_print(out, &untouched);
  assert_int_equal(fclose(out), 0);
  assert_string_equal(text, "1 2 3 4 5 6 7 -1 -2 -3 -4 -5 -6 -7 -8 0 1 2 3 4 5 -1 -2 -3");
}

CASE(print_then_read) {
  for (size_t family = 0; family < family_count(); family++) {
    for (int word = SEPAX_WORD_MIN; word <= SEPAX_WORD_MAX; word++) {
      sepax_random random = seeded(family, word);
      sepax_pair pair = sepax_family_pair(family, word, &random);
      pair.na.x = sepax_word_min(word);
      FILE *file = tmpfile();
      assert_non_null(file);
      sepax_pair_print(file, &pair);
      rewind(file);
      sepax_pair got;
      size_t number = 0;
      assert_int_equal(sepax_pair_read(&got, file, "x", &number, word, &fault), SEPAX_LINE_PAIR);
      assert_true(same_pair(&got, &pair));
      assert_int_equal(fclose(file), 0);
    }
  }
}

CASE(absent_normals_are_computed) {
  sepax_pair pair = parsed(EIGHTEEN);
  assert_true(legal(&pair, 4));
  assert_true(equal(pair.na, (sepax_vec){0, 0, 7}));
  assert_true(equal(pair.b.v[2], (sepax_vec){2, 2, 3}));
}

CASE(given_normals_are_taken) {
  sepax_pair pair = parsed(EIGHTEEN " 1 2 3 -4 -5 -6");
  assert_true(equal(pair.na, (sepax_vec){1, 2, 3}));
  assert_true(equal(pair.nb, (sepax_vec){-4, -5, -6}));
}

CASE(spellings_are_tolerated) {
  static const char *const lines[] = {
      EIGHTEEN "\n",
      EIGHTEEN "\r\n",
      EIGHTEEN "\r",
      EIGHTEEN " \t \n",
      EIGHTEEN "# with a comment\r\n",
      EIGHTEEN " # 1 2 3 # more, \t\r and 0x7f",
      (" \t" EIGHTEEN),
      "+0 -0 00 +7 0 0 0\t007 0 1 1 -3 1  1 3 2 2 3",
  };
  sepax_pair expected = parsed(EIGHTEEN);
  for (size_t i = 0; i < LENGTH(lines); i++) {
    sepax_pair pair = parsed(lines[i]);
    assert_true(same_pair(&pair, &expected));
  }
}

CASE(empty_lines_are_empty) {
  static const char *const lines[] = {"", "\n", "\r\n", "\r", " \t \r\n", "#", "  # 1 2 3\n"};
  for (size_t i = 0; i < LENGTH(lines); i++) {
    assert_no_pair(lines[i], 4, SEPAX_LINE_EMPTY, "");
  }
}

#define COUNT_MESSAGE \
  " where 18 (A1x A1y A1z ... B3z) or 24 (with the normals N_A, N_B) are expected"

static const struct {
  int word;
  const char *line, *message;
} refusals[] = {
    {4, "1", "1 number" COUNT_MESSAGE},
    {4, "1 2 3 4 5 6 7 1 2 3 4 5 6 7 1 2 3", "17 numbers" COUNT_MESSAGE},
    {4, "1 2 3 4 5 6 7 1 2 3 4 5 6 7 1 2 3 # 4", "17 numbers" COUNT_MESSAGE},
    {4, EIGHTEEN " 1", "19 numbers" COUNT_MESSAGE},
    {4, EIGHTEEN " 1 2 3 4 5", "23 numbers" COUNT_MESSAGE},
    {4, EIGHTEEN " 1 2 3 4 5 6 7", "25 numbers" COUNT_MESSAGE},
    {4, EIGHTEEN " " EIGHTEEN " 99", "37 numbers" COUNT_MESSAGE},
    {4, EIGHTEEN " 1 2 3 4 5 6 x", "number 25, 'x', is not a decimal integer"},
    {4, "0x1 2", "number 1, '0x1', is not a decimal integer"},
    {4, "1 2.0", "number 2, '2.0', is not a decimal integer"},
    {4, "1 2e3", "number 2, '2e3', is not a decimal integer"},
    {4, "1,2,3", "number 1, '1,2,3', is not a decimal integer"},
    {4, "1 -", "number 2, '-', is not a decimal integer"},
    {4, "+", "number 1, '+', is not a decimal integer"},
    {4, "+-1", "number 1, '+-1', is not a decimal integer"},
    {4, "--1", "number 1, '--1', is not a decimal integer"},
    {4, "1 nan", "number 2, 'nan', is not a decimal integer"},
    {4, "1\v2", "number 1, '1?2', is not a decimal integer"},
    {4, "1\r2\n", "number 1, '1?2', is not a decimal integer"},
    {4, "1 \r\r\n", "number 2, '?', is not a decimal integer"},
    {4,
     "\xef\xbb\xbf"
     "1",
     "number 1, '???1', is not a decimal integer"},
    {4, "1 2-", "number 2, '2-', is not a decimal integer"},
    {4, EIGHTEEN "\n" EIGHTEEN, "more than one line where one pair is expected"},
    {4, "# one\n2", "more than one line where one pair is expected"},
    {4, "0 0 0 0 9", "A2y = 9 does not fit W = 4 (-8 ... 7)"},
    {4, "-9", "A1x = -9 does not fit W = 4 (-8 ... 7)"},
    {4, "0 8", "A1y = 8 does not fit W = 4 (-8 ... 7)"},
    {4, "1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 +99", "B3z = +99 does not fit W = 4 (-8 ... 7)"},
    {4, EIGHTEEN " 8", "N_Ax = 8 does not fit W = 4 (-8 ... 7)"},
    {4, EIGHTEEN " 1 1 1 1 1 -9", "N_Bz = -9 does not fit W = 4 (-8 ... 7)"},
    {18, "131072", "A1x = 131072 does not fit W = 18 (-131072 ... 131071)"},
    {32, "2147483648", "A1x = 2147483648 does not fit W = 32 (-2147483648 ... 2147483647)"},
    {32, "-2147483649", "A1x = -2147483649 does not fit W = 32 (-2147483648 ... 2147483647)"},
    {32, "9223372036854775808",
     "A1x = 9223372036854775808 does not fit W = 32 (-2147483648 ... 2147483647)"},
    {32, "-18446744073709551616",
     "A1x = -18446744073709551616 does not fit W = 32 (-2147483648 ... 2147483647)"},
    {4, "123456789012345678901234567890123456789012345678901234567890",
     "A1x = 1234567890123456789012345678901234567890... does not fit W = 4 (-8 ... 7)"},
    {4, "123456789012345678901234567890123456789x",
     "number 1, '123456789012345678901234567890123456789x', is not a decimal integer"},
};

CASE(errors_say_what_is_wrong) {
  for (size_t i = 0; i < LENGTH(refusals); i++) {
    assert_no_pair(refusals[i].line, refusals[i].word, SEPAX_LINE_ERROR, refusals[i].message);
  }
}

CASE(every_field_has_its_name) {
  static const char *const names[FIELDS] = {
      "A1x", "A1y", "A1z", "A2x", "A2y", "A2z", "A3x",  "A3y",  "A3z",  "B1x",  "B1y",  "B1z",
      "B2x", "B2y", "B2z", "B3x", "B3y", "B3z", "N_Ax", "N_Ay", "N_Az", "N_Bx", "N_By", "N_Bz"};
  char line[64] = "";
  for (size_t i = 0; i < FIELDS; i++) {
    char message[64];
    line[2 * i] = '8';
    snprintf(message, sizeof message, "%s = 8 does not fit W = 4 (-8 ... 7)", names[i]);
    assert_no_pair(line, 4, SEPAX_LINE_ERROR, message);
    line[2 * i] = '0';
    line[2 * i + 1] = ' ';
  }
}

/* ----------------------------------------------------------------------- streams */

static FILE *stream_of(const char *text, size_t length) {
  FILE *file = tmpfile();
  assert_non_null(file);
  assert_int_equal(fwrite(text, 1, length, file), length);
  rewind(file);
  return file;
}

/* The next pair of a stream "f", if it is one, else as it was; `number` lines were read. */
static sepax_pair read_next(FILE *in, size_t *number, sepax_line kind, size_t expected) {
  sepax_pair pair = untouched;
  fault.text[0] = '\0';
  assert_int_equal(sepax_pair_read(&pair, in, "f", number, 4, &fault), kind);
  assert_int_equal(*number, expected);
  assert_int_equal(fault.text[0] == '\0', kind != SEPAX_LINE_ERROR);
  assert_int_equal(same_pair(&pair, &untouched), kind != SEPAX_LINE_PAIR);
  return pair;
}

CASE(reading_counts_lines) {
  static const char text[] = "# head\n\n" EIGHTEEN "\r\n \t\n# two\n1 2 3\n" EIGHTEEN
                             " 1 2 3 4 5 6 # last, without a line feed";
  FILE *in = stream_of(text, sizeof text - 1);
  size_t number = 0;
  read_next(in, &number, SEPAX_LINE_PAIR, 3);
  read_next(in, &number, SEPAX_LINE_ERROR, 6);
  assert_string_equal(fault.text, "f:6: 3 numbers" COUNT_MESSAGE);
  assert_int_equal(read_next(in, &number, SEPAX_LINE_PAIR, 7).nb.z, 6);
  read_next(in, &number, SEPAX_LINE_EMPTY, 7);
  read_next(in, &number, SEPAX_LINE_EMPTY, 7);
  fclose(in);
}

/* What `sepax judge --echo` wrote can be read again, and is compared with a design. */
CASE(told_verdicts_are_read) {
  static const char text[] = EIGHTEEN "\n" EIGHTEEN " 1 2 3 4 5 6 1 0 7\n" EIGHTEEN
                                      " 1 2 3 4 5 6 2\n" EIGHTEEN " 1 2 3 4 5 6 1 1 15 3 0\n";
  FILE *in = stream_of(text, sizeof text - 1);
  size_t number = 0;
  sepax_pair pair;
  sepax_told told;
  assert_int_equal(sepax_pair_read_told(&pair, &told, in, "f", &number, 4, &fault),
                   SEPAX_LINE_PAIR);
  assert_int_equal(told.count, 0);
  assert_int_equal(sepax_pair_read_told(&pair, &told, in, "f", &number, 4, &fault),
                   SEPAX_LINE_PAIR);
  assert_int_equal(told.count, 3);
  assert_int_equal(told.value[0], 1);
  assert_int_equal(told.value[2], 7);
  assert_int_equal(pair.nb.z, 6);
  assert_int_equal(sepax_pair_read_told(&pair, &told, in, "f", &number, 4, &fault),
                   SEPAX_LINE_ERROR);
  assert_string_equal(fault.text, "f:3: number 1 of a verdict, '2', is not in 0 ... 1");
  assert_int_equal(sepax_pair_read_told(&pair, &told, in, "f", &number, 4, &fault),
                   SEPAX_LINE_ERROR);
  assert_non_null(strstr(fault.text, "f:4: 29 numbers where"));
  assert_int_equal(fclose(in), 0);
}

CASE(told_verdicts_are_compared) {
  sepax_config config = sepax_config_default();
  sepax_design design;
  assert_true(sepax_design_init(&design, &config, &fault));
  sepax_judgement verdict = {.collision = true, .axis = 0};
  sepax_told told = sepax_tell(&design, &verdict);
  assert_int_equal(told.count, 3);
  assert_true(sepax_told_check(&told, &design, &verdict, &fault));
  told.value[2] = 4;
  assert_false(sepax_told_check(&told, &design, &verdict, &fault));
  assert_non_null(strstr(fault.text, "axis is 4, by the golden model of this design 0"));
  told.count = 2;
  assert_false(sepax_told_check(&told, &design, &verdict, &fault));
  assert_non_null(strstr(fault.text, "a verdict of 2 numbers"));
  told.count = 0;
  assert_true(sepax_told_check(&told, &design, &verdict, &fault));
}

CASE(an_empty_stream_ends) {
  FILE *in = stream_of("", 0);
  size_t number = 0;
  read_next(in, &number, SEPAX_LINE_EMPTY, 0);
  fclose(in);
}

CASE(nul_bytes_are_refused) {
  static const struct {
    const char *text;
    size_t length;
  } row[] = {{EIGHTEEN "\0 1\n", sizeof EIGHTEEN + 3},
             {EIGHTEEN " # \0\n", sizeof EIGHTEEN + 4},
             {"\0\n", 2},
             {EIGHTEEN "\0", sizeof EIGHTEEN}};
  for (size_t i = 0; i < LENGTH(row); i++) {
    FILE *in = stream_of(row[i].text, row[i].length);
    size_t number = 0;
    read_next(in, &number, SEPAX_LINE_ERROR, 1);
    assert_string_equal(fault.text, "f:1: NUL byte where text is expected");
    fclose(in);
  }
}

CASE(long_names_and_lines_fit) {
  enum { LONG = 100000, SHORTER = 4000 };
  static const struct {
    size_t length;
    const char *part;
  } row[] = {{LONG, ":1: the line is longer than any pair"},
             {SHORTER, ":1: number 1, 'nnnn"},
             {SHORTER, "nn...', is not a decimal integer"}};
  static char text[LONG + 1];
  memset(text, 'n', LONG);
  for (size_t i = 0; i < LENGTH(row); i++) {
    sepax_pair pair;
    size_t number = 0;
    FILE *in = stream_of(text, row[i].length);
    assert_int_equal(sepax_pair_read(&pair, in, text, &number, 4, &fault), SEPAX_LINE_ERROR);
    assert_message(row[i].part);
    fclose(in);
  }
}

CASE(read_failures_are_errors) {
  FILE *in = fopen("/", "r");
  assert_non_null(in);
  size_t number = 4;
  read_next(in, &number, SEPAX_LINE_ERROR, 4);
  assert_memory_equal(fault.text, "f:5: cannot read: ", 18);
  assert_true(strlen(fault.text) > 20);
  fclose(in);
}
