/* SPDX-License-Identifier: MIT */
/* pairs.c - exact verdicts on many pairs, several at once, with AVX-512, AVX2 or plain C. */
#include "sepax_grid.h"
#include "util/simd.h"

#include <string.h>

#if defined __x86_64__
#include <immintrin.h>
#endif

/* Bits of the magnitude of a coordinate (lanes.h). The limits: an orient3d that is larger has a
 * certain sign. */
enum { BLOCK = 64, SHORT_BITS = 19, LONG_BITS = 24 };
static const double SHORT_LIMIT = 1 << 12;
static const double LONG_LIMIT = 1 << 28;

/* Unrolled loops keep all sums in registers. */
#define SIMD_UNROLL _Pragma("GCC unroll 3")

static const int next[3] = {1, 2, 0};

/* 64 pairs by vertex, axis and pair. They are copied because columns at distances of a power of two
 * would evict each other from the cache. */
typedef struct {
  int32_t a[3][3][BLOCK], b[3][3][BLOCK];
} block;

static inline int32_t coordinate(const sepax_tri *t, int vertex, int axis) {
  const sepax_vec *v = &t->v[vertex];
  return axis == 0 ? v->x : axis == 1 ? v->y : v->z;
}

static inline sepax_tri gathered(const int32_t from[3][3][BLOCK], size_t at) {
  sepax_tri t;
  SIMD_UNROLL for (int k = 0; k < 3; k++) {
    t.v[k] = (sepax_vec){from[k][0][at], from[k][1][at], from[k][2][at]};
  }
  return t;
}

/* Judge the pairs in `which` one by one: in->a against in->b, or `one` against in->b if `one` is
 * not NULL. */
static uint64_t judge_singly(const sepax_tri *one, const block *in, uint64_t which) {
  uint64_t hits = 0;
  for (size_t m = 0; m < BLOCK; m++) {
    if ((which >> m & 1) != 0) {
      sepax_tri a = one != NULL ? *one : gathered(in->a, m);
      sepax_tri b = gathered(in->b, m);
      hits |= (uint64_t)sepax_exact(&a, &b).collision << m;
    }
  }
  return hits;
}

/* --------------------------------------------------------- instruction sets */

/* Vectors of two doubles. The compiler uses SSE2, NEON and the like, or scalar instructions. */
#define SIMD_LANES 2
#define SIMD_NAME(x) x##_portable
#define SIMD_TARGET
typedef int32_t half_portable __attribute__((vector_size(8), aligned(4), may_alias));
#define SIMD_LOAD_REALS(from) __builtin_convertvector(*(const half_portable *)(from), SIMD_REAL)
#define SIMD_SELECT(TYPE, mask, p, q) \
  ((TYPE)(((SIMD_WHOLE)(p) & (SIMD_WHOLE)(mask)) | ((SIMD_WHOLE)(q) & ~(SIMD_WHOLE)(mask))))
#define SIMD_LEAST_REAL(p, q) SIMD_SELECT(SIMD_REAL, (p) < (q), p, q)
#define SIMD_BITS(v) ((uint32_t)((v)[0] >> 63 | (v)[1] >> 63 << 1))
#define SIMD_BITS_OF_SHORTS(v) \
  ((uint32_t)(((v)[0] < 0) | ((v)[1] < 0) << 1 | ((v)[2] < 0) << 2 | ((v)[3] < 0) << 3))
#define SIMD_LEAST(p, q) SIMD_SELECT(SIMD_SHORT, (p) < (q), p, q)
#define SIMD_MOST(p, q) SIMD_SELECT(SIMD_SHORT, (p) > (q), p, q)
#include "lanes.h"
#undef SIMD_SELECT

#if defined __x86_64__

/* On machines without AVX-512, tb/unit/avx512.c runs this code with emulated intrinsics. */
#ifndef TARGET_AVX512
#define TARGET_AVX512 __attribute__((target("avx512f")))
#endif
typedef int32_t unaligned_shorts __attribute__((vector_size(32), aligned(4), may_alias));
#define SIMD_LANES 8
#define SIMD_NAME(x) x##_avx512
#define SIMD_TARGET TARGET_AVX512
#define SIMD_LOAD(from) \
  ((SIMD_WHOLE) __builtin_convertvector(*(const unaligned_shorts *)(from), signed_lanes_avx512))
#define SIMD_LOAD_REALS(from) \
  __builtin_convertvector(*(const unaligned_shorts *)(from), reals_avx512)
#define SIMD_LEAST_REAL(p, q) ((SIMD_REAL)_mm512_min_pd((__m512d)(p), (__m512d)(q)))
#define SIMD_PRODUCT(p, q) ((SIMD_WHOLE)_mm512_mul_epi32((__m512i)(p), (__m512i)(q)))
#define SIMD_BITS(v) ((uint32_t)_mm512_cmpgt_epi64_mask(_mm512_setzero_si512(), (__m512i)(v)))
#define SIMD_BITS_OF_SHORTS(v) \
  ((uint32_t)_mm512_cmpgt_epi32_mask(_mm512_setzero_si512(), (__m512i)(v)))
#define SIMD_LEAST(p, q) ((SIMD_SHORT)_mm512_min_epi32((__m512i)(p), (__m512i)(q)))
#define SIMD_MOST(p, q) ((SIMD_SHORT)_mm512_max_epi32((__m512i)(p), (__m512i)(q)))
#include "lanes.h"

#define SIMD_LANES 4
#define SIMD_NAME(x) x##_avx2
#define SIMD_TARGET __attribute__((target("avx2")))
#define SIMD_LOAD(from) ((SIMD_WHOLE)_mm256_cvtepi32_epi64(_mm_loadu_si128((const void *)(from))))
#define SIMD_LOAD_REALS(from) ((SIMD_REAL)_mm256_cvtepi32_pd(_mm_loadu_si128((const void *)(from))))
#define SIMD_LEAST_REAL(p, q) ((SIMD_REAL)_mm256_min_pd((__m256d)(p), (__m256d)(q)))
#define SIMD_PRODUCT(p, q) ((SIMD_WHOLE)_mm256_mul_epi32((__m256i)(p), (__m256i)(q)))
#define SIMD_BITS(v) ((uint32_t)_mm256_movemask_pd((__m256d)(v)))
#define SIMD_BITS_OF_SHORTS(v) ((uint32_t)_mm256_movemask_ps((__m256)(v)))
#define SIMD_LEAST(p, q) ((SIMD_SHORT)_mm256_min_epi32((__m256i)(p), (__m256i)(q)))
#define SIMD_MOST(p, q) ((SIMD_SHORT)_mm256_max_epi32((__m256i)(p), (__m256i)(q)))
#include "lanes.h"
#endif

/* ----------------------------------------------------------------- dispatch */

typedef struct {
  uint64_t (*pairs)(const block *in);
  uint64_t (*one)(const sepax_tri *one, const block *in);
} functions;

static const functions table[] = {
    [SEPAX_SIMD_PORTABLE] = {judge_pairs_portable, judge_one_portable},
#if defined __x86_64__
    [SEPAX_SIMD_AVX2] = {judge_pairs_avx2, judge_one_avx2},
    [SEPAX_SIMD_AVX512] = {judge_pairs_avx512, judge_one_avx512},
#endif
};

bool sepax_simd_runs(sepax_simd simd) {
  switch (simd) {
#if defined __x86_64__
  case SEPAX_SIMD_AVX2:
    return __builtin_cpu_supports("avx2");
  case SEPAX_SIMD_AVX512:
    return __builtin_cpu_supports("avx512f");
#endif
  default:
    return simd == SEPAX_SIMD_BEST || simd == SEPAX_SIMD_PORTABLE;
  }
}

static sepax_simd best(void) {
  return sepax_simd_runs(SEPAX_SIMD_AVX512) ? SEPAX_SIMD_AVX512
         : sepax_simd_runs(SEPAX_SIMD_AVX2) ? SEPAX_SIMD_AVX2
                                            : SEPAX_SIMD_PORTABLE;
}

/* The instructions to use: the widest that the processor has, if it lacks those of `simd`. */
static sepax_simd settled(sepax_simd simd) {
  return simd == SEPAX_SIMD_BEST || !sepax_simd_runs(simd) ? best() : simd;
}

const char *sepax_simd_name(sepax_simd simd) {
  static const char *const names[] = {[SEPAX_SIMD_PORTABLE] = "portable",
                                      [SEPAX_SIMD_AVX2] = "avx2",
                                      [SEPAX_SIMD_AVX512] = "avx512"};
  return names[settled(simd)];
}

/* ------------------------------------------------------------- entry points */

/* Copy up to a block of triangles. The last triangle fills the rest of the block. */
static void copy_columns(int32_t to[3][3][BLOCK], const sepax_columns *from, size_t at,
                         size_t count) {
  for (int k = 0; k < 3; k++) {
    for (int axis = 0; axis < 3; axis++) {
      const int32_t *column = from->c[k][axis] + at;
      if (count >= BLOCK) {
        memcpy(to[k][axis], column, sizeof to[k][axis]);
        continue;
      }
      for (size_t m = 0; m < BLOCK; m++) {
        to[k][axis][m] = column[m < count ? m : count - 1];
      }
    }
  }
}

static uint64_t mask_of(size_t count) {
  return count >= BLOCK ? ~UINT64_C(0) : (UINT64_C(1) << count) - 1;
}

void sepax_exact_pairs(sepax_simd simd, const sepax_columns *a, const sepax_columns *b,
                       size_t count, uint64_t *bits) {
  const functions *f = &table[settled(simd)];
  block in;
  for (size_t n = 0; n < count; n += BLOCK) {
    copy_columns(in.a, a, n, count - n);
    copy_columns(in.b, b, n, count - n);
    bits[n / BLOCK] = f->pairs(&in) & mask_of(count - n);
  }
}

void sepax_exact_one_to_many(sepax_simd simd, const sepax_tri *a, const sepax_columns *b,
                             size_t count, uint64_t *bits) {
  const functions *f = &table[settled(simd)];
  block in;
  for (size_t n = 0; n < count; n += BLOCK) {
    copy_columns(in.b, b, n, count - n);
    bits[n / BLOCK] = f->one(a, &in) & mask_of(count - n);
  }
}
