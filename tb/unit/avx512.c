/* SPDX-License-Identifier: MIT */
/* avx512.c - the AVX-512 path of batch/pairs.c with its intrinsics emulated by SIMDe, so that
 * it is tested on machines without them. */
#include <immintrin.h>

#define SIMDE_ENABLE_NATIVE_ALIASES
#include <simde/x86/avx512.h>

#define TARGET_AVX512
#include "batch/pairs.c" /* NOLINT(bugprone-suspicious-include): its functions are static */

#include "benchmark/columns.h"
#include "oracle/pair_tools.h"
#include "harness.h"

/* A block of each family at each word length: pairs, and one against many. */
CASE(every_family_at_every_word) {
  static const functions emulated = {judge_pairs_avx512, judge_one_avx512};
  static sepax_tri t[2][BLOCK];
  pair_columns batch = columns_of(BLOCK);
  for (size_t family = 0; family < family_count(); family++) {
    for (int word = SEPAX_WORD_MIN; word <= SEPAX_WORD_MAX; word++) {
      sepax_random random = seeded(family, word);
      for (int round = 0; round < FEWER(30); round++) {
        for (size_t n = 0; n < BLOCK; n++) {
          sepax_pair pair = sepax_family_triangles(family, word, &random);
          t[0][n] = pair.a;
          t[1][n] = pair.b;
          columns_set(&batch, n, &pair);
        }
        block in;
        copy_columns(in.a, &batch.a, 0, BLOCK);
        copy_columns(in.b, &batch.b, 0, BLOCK);
        uint64_t pairs = emulated.pairs(&in);
        uint64_t one = emulated.one(&t[0][0], &in);
        for (size_t n = 0; n < BLOCK; n++) {
          assert_int_equal(bit_at(&pairs, n), sepax_exact(&t[0][n], &t[1][n]).collision);
          assert_int_equal(bit_at(&one, n), sepax_exact(&t[0][0], &t[1][n]).collision);
        }
      }
    }
  }
  columns_free(&batch);
}
