/* SPDX-License-Identifier: MIT */
/* hard.c - hard pairs through the library, each of its verdicts against sepax_reference.
 *   hard-pairs WORD COUNT SEED   prints "N pairs, N mismatches, N collisions, N coplanar"; a pair
 *                                that differs on stderr. Exit status 1: one does
 *
 * sepax_exact and sepax_filtered pair by pair, sepax_exact_pairs on every path of this processor.
 * The families come in turn. Pairs are made in place and judged in blocks. */
#include "benchmark/columns.h"

#include <inttypes.h>
#include <stdio.h>

enum { BLOCK = 4000, SHOWN = 20, PATHS = 3 };

static const sepax_simd paths[PATHS] = {SEPAX_SIMD_PORTABLE, SEPAX_SIMD_AVX2, SEPAX_SIMD_AVX512};

typedef struct {
  uint64_t mismatches, collisions, coplanar;
} tally;

static void compare(tally *t, const char *who, const sepax_pair *pair, bool got, bool expected) {
  if (got == expected || t->mismatches++ >= SHOWN) {
    return;
  }
  fprintf(stderr, "hard-pairs: %s says %d, sepax_reference %d:", who, got, expected);
  for (int k = 0; k < 6; k++) {
    const sepax_vec *v = k < 3 ? &pair->a.v[k] : &pair->b.v[k - 3];
    fprintf(stderr, " %" PRId32 " %" PRId32 " %" PRId32, v->x, v->y, v->z);
  }
  fputc('\n', stderr);
}

static void judge(tally *t, const sepax_pair *pair, size_t count, bool *expected,
                  pair_columns *batch) {
  for (size_t n = 0; n < count; n++) {
    const sepax_tri *a = &pair[n].a;
    const sepax_tri *b = &pair[n].b;
    expected[n] = sepax_reference(a, b);
    sepax_verdict exact = sepax_exact(a, b);
    t->collisions += expected[n];
    t->coplanar += exact.coplanar;
    compare(t, "sepax_exact", &pair[n], exact.collision, expected[n]);
    compare(t, "sepax_filtered", &pair[n], sepax_filtered(a, b, NULL), expected[n]);
    columns_set(batch, n, &pair[n]);
  }
  for (int k = 0; k < PATHS; k++) {
    if (sepax_simd_runs(paths[k])) {
      sepax_exact_pairs(paths[k], &batch->a, &batch->b, count, batch->bits);
      for (size_t n = 0; n < count; n++) {
        compare(t, sepax_simd_name(paths[k]), &pair[n], bit_at(batch->bits, n), expected[n]);
      }
    }
  }
}

static uint64_t number(const char *text) {
  char *end;
  uint64_t value = strtoull(text, &end, 10);
  if (end == text || *end != '\0' || text[0] == '-') {
    fprintf(stderr, "hard-pairs: '%s' is no whole number\n", text);
    exit(2);
  }
  return value;
}

int main(int argc, char **argv) {
  if (argc != 4) {
    fputs("usage: hard-pairs WORD COUNT SEED\n", stderr);
    return 2;
  }
  uint64_t word = number(argv[1]);
  uint64_t count = number(argv[2]);
  if (word < SEPAX_WORD_MIN || word > SEPAX_WORD_MAX || count == 0) {
    fputs("hard-pairs: WORD is 4 ... 32, COUNT 1 or more\n", stderr);
    return 2;
  }
  sepax_random random = {number(argv[3])};
  size_t families = 1;
  while (sepax_family_name(families) != NULL) {
    families++;
  }
  sepax_pair *pair = allocate(BLOCK * sizeof *pair);
  bool *expected = allocate(BLOCK * sizeof *expected);
  pair_columns batch = columns_of(BLOCK);
  tally t = {0};
  size_t many;
  for (uint64_t done = 0; done < count; done += many) {
    many = count - done < BLOCK ? (size_t)(count - done) : BLOCK;
    for (size_t n = 0; n < many; n++) {
      pair[n] = sepax_family_triangles((done + n) % families, (int)word, &random);
    }
    judge(&t, pair, many, expected, &batch);
  }
  printf("%" PRIu64 " pairs, %" PRIu64 " mismatches, %" PRIu64 " collisions, %" PRIu64
         " coplanar\n",
         count, t.mismatches, t.collisions, t.coplanar);
  free(pair);
  free(expected);
  columns_free(&batch);
  return t.mismatches > 0;
}
