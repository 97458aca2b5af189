/* SPDX-License-Identifier: MIT */
/* vectors.c - the verdicts in floating point as gcc compiles them with -O3 for AVX2 are those of
 * the library. gcc 12 has read other numbers where a condition chose between two structures. */
#include "harness.h"

#if defined __GNUC__ && !defined __clang__ && defined __x86_64__
#pragma GCC push_options
#pragma GCC optimize("O3")
#pragma GCC target("avx2")
#define sepax_float32 vector_float32
#define sepax_float64 vector_float64
#define sepax_interval32 vector_interval32
#define sepax_interval64 vector_interval64
#define sepax_guigue32 vector_guigue32
#define sepax_guigue64 vector_guigue64
#define sepax_filtered vector_filtered
#include "models/filtered.c" /* NOLINT(bugprone-suspicious-include): compiled once more */
#include "models/float.c"    /* NOLINT(bugprone-suspicious-include) */
#undef sepax_float32
#undef sepax_float64
#undef sepax_interval32
#undef sepax_interval64
#undef sepax_guigue32
#undef sepax_guigue64
#undef sepax_filtered
#pragma GCC pop_options

typedef bool verdict(const sepax_tri *a, const sepax_tri *b);

static bool filtered(const sepax_tri *a, const sepax_tri *b) { return sepax_filtered(a, b, NULL); }
static bool filtered_too(const sepax_tri *a, const sepax_tri *b) {
  return vector_filtered(a, b, NULL);
}

CASE(every_verdict_is_the_library_s) {
  static verdict *const of[][2] = {{sepax_float32, vector_float32},
                                   {sepax_float64, vector_float64},
                                   {sepax_interval32, vector_interval32},
                                   {sepax_interval64, vector_interval64},
                                   {sepax_guigue32, vector_guigue32},
                                   {sepax_guigue64, vector_guigue64},
                                   {filtered, filtered_too}};
  if (!__builtin_cpu_supports("avx2")) {
    skip();
  }
  sepax_random random = {1};
  for (size_t n = 0; n < 17000; n++) {
    sepax_pair pair = sepax_family_triangles(n % 17, n % 2 == 0 ? 18 : 26, &random);
    for (size_t k = 0; k < LENGTH(of); k++) {
      assert_int_equal(of[k][0](&pair.a, &pair.b), of[k][1](&pair.a, &pair.b));
    }
  }
}
#else
CASE(every_verdict_is_the_library_s) { skip(); }
#endif
