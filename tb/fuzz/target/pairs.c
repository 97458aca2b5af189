/* SPDX-License-Identifier: MIT */
/* pairs.c - pairs as text; the first byte chooses the word length. */
#include "fuzz/fuzz.h"
#include "sepax_vectors.h"

#include <stdio.h>
#include <string.h>

static void require_in_word(const sepax_tri *t, int word) {
  for (int k = 0; k < 3; k++) {
    const int32_t c[3] = {t->v[k].x, t->v[k].y, t->v[k].z};
    for (int i = 0; i < 3; i++) {
      REQUIRE(c[i] >= sepax_word_min(word) && c[i] <= sepax_word_max(word));
    }
  }
}

static void require_printed(const sepax_pair *pair, int word) {
  char text[1024];
  FILE *out = fmemopen(text, sizeof text, "w");
  REQUIRE(out != NULL);
  sepax_pair_print(out, pair);
  REQUIRE(fclose(out) == 0);
  sepax_pair again;
  sepax_error error = {0};
  REQUIRE(sepax_pair_parse(&again, text, word, &error) == SEPAX_LINE_PAIR);
  REQUIRE(memcmp(&again.a, &pair->a, sizeof again.a) == 0);
  REQUIRE(memcmp(&again.b, &pair->b, sizeof again.b) == 0);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  if (size < 2) {
    return 0;
  }
  int word = SEPAX_WORD_MIN + data[0] % (SEPAX_WORD_MAX - SEPAX_WORD_MIN + 1);
  fuzz_file("input.txt", data + 1, size - 1);
  FILE *in = fopen("input.txt", "r");
  REQUIRE(in != NULL);
  size_t number = 0;
  sepax_line kind = SEPAX_LINE_PAIR;
  while (kind != SEPAX_LINE_EMPTY) {
    sepax_pair pair;
    sepax_error error = {0};
    kind = sepax_pair_read(&pair, in, "input", &number, word, &error);
    fuzz_answer(kind != SEPAX_LINE_ERROR, &error);
    REQUIRE(number <= size);
    if (kind == SEPAX_LINE_PAIR) {
      require_in_word(&pair.a, word);
      require_in_word(&pair.b, word);
      require_printed(&pair, word);
    }
  }
  fclose(in);
  return 0;
}
