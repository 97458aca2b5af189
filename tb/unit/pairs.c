/* pairs.c - pairs as text. */
#include <stdlib.h>
#include <string.h>

#include "oracle/pair_tools.h"
#include "sepax_vectors.h"
#include "harness.h"

#define EIGHTEEN "0 0 0 7 0 0 0 7 0 1 1 -3 1 1 3 2 2 3"

static const sepax_pair untouched = {{{{1, 2, 3}, {4, 5, 6}, {7, -1, -2}}},
                                     {{{-3, -4, -5}, {-6, -7, -8}, {0, 1, 2}}},
                                     {3, 4, 5},
                                     {-1, -2, -3}};

static bool same_pair(const sepax_pair *p, const sepax_pair *q) {
  for (int i = 0; i < 6; i++) {
    if (!equal(vertex(p, i), vertex(q, i))) {
      return false;
    }
  }
  return equal(p->na, q->na) && equal(p->nb, q->nb);
}

static bool fits_with(int32_t value, int field, int word) {
  sepax_pair pair = {0};
  sepax_vec *v[8] = {&pair.a.v[0], &pair.a.v[1], &pair.a.v[2], &pair.b.v[0],
                     &pair.b.v[1], &pair.b.v[2], &pair.na,     &pair.nb};
  int32_t *c[3] = {&v[field / 3]->x, &v[field / 3]->y, &v[field / 3]->z};
  *c[field % 3] = value;
  return sepax_pair_fits(&pair, word);
}

CASE(fits_looks_at_every_field) {
  for (int word = SEPAX_WORD_MIN; word <= SEPAX_WORD_MAX; word++) {
    int32_t least = sepax_word_min(word);
    int32_t most = sepax_word_max(word);
    for (int field = 0; field < 24; field++) {
      assert_true(fits_with(least, field, word));
      assert_true(fits_with(most, field, word));
      if (word < SEPAX_WORD_MAX) {
        assert_false(fits_with(least - 1, field, word));
        assert_false(fits_with(most + 1, field, word));
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
  sepax_error error = {""};
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
      assert_int_equal(sepax_pair_read(&got, file, "x", &number, word, &error), SEPAX_LINE_PAIR);
      assert_true(same_pair(&got, &pair));
      assert_int_equal(fclose(file), 0);
    }
  }
}

CASE(absent_normals_are_computed) {
  sepax_error error = {""};
  sepax_pair pair;
  assert_int_equal(sepax_pair_parse(&pair, EIGHTEEN, 4, &error), SEPAX_LINE_PAIR);
  assert_true(legal(&pair, 4));
  assert_true(equal(pair.na, (sepax_vec){0, 0, 7}));
  assert_true(equal(pair.b.v[2], (sepax_vec){2, 2, 3}));
  assert_string_equal(error.text, "");
}

CASE(given_normals_are_taken) {
  sepax_error error = {""};
  sepax_pair pair;
  assert_int_equal(sepax_pair_parse(&pair, EIGHTEEN " 1 2 3 -4 -5 -6", 4, &error), SEPAX_LINE_PAIR);
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
  sepax_error error = {""};
  sepax_pair expected;
  assert_int_equal(sepax_pair_parse(&expected, EIGHTEEN, 4, &error), SEPAX_LINE_PAIR);
  for (size_t i = 0; i < LENGTH(lines); i++) {
    sepax_pair pair = untouched;
    assert_int_equal(sepax_pair_parse(&pair, lines[i], 4, &error), SEPAX_LINE_PAIR);
    assert_true(same_pair(&pair, &expected));
  }
}

CASE(empty_lines_are_empty) {
  static const char *const lines[] = {"", "\n", "\r\n", "\r", " \t \r\n", "#", "  # 1 2 3\n"};
  sepax_error error = {""};
  for (size_t i = 0; i < LENGTH(lines); i++) {
    sepax_pair pair = untouched;
    assert_int_equal(sepax_pair_parse(&pair, lines[i], 4, &error), SEPAX_LINE_EMPTY);
    assert_true(same_pair(&pair, &untouched));
    assert_string_equal(error.text, "");
  }
}

typedef struct {
  int word;
  const char *line, *message;
} refusal;

#define COUNT_MESSAGE \
  " where 18 (A1x A1y A1z ... B3z) or 24 (with the normals N_A, N_B) are expected"

static const refusal refusals[] = {
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
    const refusal *r = &refusals[i];
    sepax_error error = {""};
    sepax_pair pair = untouched;
    sepax_line kind = sepax_pair_parse(&pair, r->line, r->word, &error);
    assert_string_equal(error.text, r->message);
    assert_int_equal(kind, SEPAX_LINE_ERROR);
    assert_true(same_pair(&pair, &untouched));
  }
}

CASE(every_field_has_its_name) {
  static const char names[] = "A1x A1y A1z A2x A2y A2z A3x A3y A3z "
                              "B1x B1y B1z B2x B2y B2z B3x B3y B3z "
                              "N_Ax N_Ay N_Az N_Bx N_By N_Bz";
  const char *name = names;
  for (size_t field = 0; field < 24; field++) {
    char line[64] = "";
    for (size_t i = 0; i < field; i++) {
      line[2 * i] = '0';
      line[2 * i + 1] = ' ';
    }
    line[2 * field] = '8';
    sepax_error error = {""};
    sepax_pair pair;
    assert_int_equal(sepax_pair_parse(&pair, line, 4, &error), SEPAX_LINE_ERROR);
    size_t length = strcspn(name, " ");
    assert_memory_equal(error.text, name, length);
    assert_memory_equal(error.text + length, " = 8 ", 5);
    name += length + 1;
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

CASE(reading_counts_lines) {
  static const char text[] = "# head\n\n" EIGHTEEN "\r\n \t\n# two\n1 2 3\n" EIGHTEEN
                             " 1 2 3 4 5 6 # last, without a line feed";
  FILE *in = stream_of(text, sizeof text - 1);
  sepax_error error = {""};
  sepax_pair pair;
  size_t number = 0;
  assert_int_equal(sepax_pair_read(&pair, in, "f", &number, 4, &error), SEPAX_LINE_PAIR);
  assert_int_equal(number, 3);
  assert_string_equal(error.text, "");
  sepax_pair first = pair;
  assert_int_equal(sepax_pair_read(&pair, in, "f", &number, 4, &error), SEPAX_LINE_ERROR);
  assert_int_equal(number, 6);
  assert_string_equal(error.text, "f:6: 3 numbers" COUNT_MESSAGE);
  assert_true(same_pair(&pair, &first));
  assert_int_equal(sepax_pair_read(&pair, in, "f", &number, 4, &error), SEPAX_LINE_PAIR);
  assert_int_equal(number, 7);
  assert_int_equal(pair.nb.z, 6);
  assert_int_equal(sepax_pair_read(&pair, in, "f", &number, 4, &error), SEPAX_LINE_EMPTY);
  assert_int_equal(sepax_pair_read(&pair, in, "f", &number, 4, &error), SEPAX_LINE_EMPTY);
  assert_int_equal(number, 7);
  fclose(in);
}

CASE(an_empty_stream_ends) {
  FILE *in = stream_of("", 0);
  sepax_error error = {""};
  sepax_pair pair = untouched;
  size_t number = 0;
  assert_int_equal(sepax_pair_read(&pair, in, "f", &number, 4, &error), SEPAX_LINE_EMPTY);
  assert_int_equal(number, 0);
  assert_true(same_pair(&pair, &untouched));
  fclose(in);
}

static void assert_nul_refused(const char *text, size_t length) {
  FILE *in = stream_of(text, length);
  sepax_error error = {""};
  sepax_pair pair = untouched;
  size_t number = 0;
  assert_int_equal(sepax_pair_read(&pair, in, "f", &number, 4, &error), SEPAX_LINE_ERROR);
  assert_string_equal(error.text, "f:1: NUL byte where text is expected");
  assert_true(same_pair(&pair, &untouched));
  fclose(in);
}

CASE(nul_bytes_are_refused) {
  static const char inside[] = EIGHTEEN "\0 1\n";
  static const char comment[] = EIGHTEEN " # \0\n";
  static const char alone[] = "\0\n";
  static const char last[] = EIGHTEEN "\0";
  assert_nul_refused(inside, sizeof inside - 1);
  assert_nul_refused(comment, sizeof comment - 1);
  assert_nul_refused(alone, sizeof alone - 1);
  assert_nul_refused(last, sizeof last - 1);
}

CASE(long_names_and_lines_fit) {
  enum { LONG = 100000, SHORTER = 4000 };
  char *text = malloc(LONG + 1);
  assert_non_null(text);
  for (size_t i = 0; i < LONG; i++) {
    text[i] = 'n';
  }
  text[LONG] = '\0';
  sepax_error error = {""};
  sepax_pair pair;
  size_t number = 0;
  FILE *in = stream_of(text, LONG);
  assert_int_equal(sepax_pair_read(&pair, in, text, &number, 4, &error), SEPAX_LINE_ERROR);
  assert_non_null(strstr(error.text, ":1: longer than any pair"));
  fclose(in);

  number = 0;
  in = stream_of(text, SHORTER);
  assert_int_equal(sepax_pair_read(&pair, in, text, &number, 4, &error), SEPAX_LINE_ERROR);
  assert_non_null(strstr(error.text, ":1: number 1, 'nnnn"));
  assert_non_null(strstr(error.text, "nn...', is not a decimal integer"));
  fclose(in);
  free(text);
}

CASE(read_failures_are_errors) {
  FILE *in = fopen("/", "r");
  assert_non_null(in);
  sepax_error error = {""};
  sepax_pair pair = untouched;
  size_t number = 4;
  assert_int_equal(sepax_pair_read(&pair, in, "/", &number, 4, &error), SEPAX_LINE_ERROR);
  assert_memory_equal(error.text, "/:5: cannot read: ", 18);
  assert_true(strlen(error.text) > 20);
  assert_int_equal(number, 4);
  assert_true(same_pair(&pair, &untouched));
  fclose(in);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(fits_looks_at_every_field), cmocka_unit_test(printing_is_24_integers),
      cmocka_unit_test(print_then_read),           cmocka_unit_test(absent_normals_are_computed),
      cmocka_unit_test(given_normals_are_taken),   cmocka_unit_test(spellings_are_tolerated),
      cmocka_unit_test(empty_lines_are_empty),     cmocka_unit_test(errors_say_what_is_wrong),
      cmocka_unit_test(every_field_has_its_name),  cmocka_unit_test(reading_counts_lines),
      cmocka_unit_test(an_empty_stream_ends),      cmocka_unit_test(nul_bytes_are_refused),
      cmocka_unit_test(long_names_and_lines_fit),  cmocka_unit_test(read_failures_are_errors),
  };
  return cmocka_run_group_tests_name("test_pairs", tests, NULL, NULL);
}
