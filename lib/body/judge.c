/* SPDX-License-Identifier: MIT */
/* judge.c - verdicts on pairs of posed triangles, several at once. Doubles decide first (filter.h),
 * then whole numbers, and sepax_exact_posed decides the rest. */
#include "judge.h"
#include "verdict/signs.h"
#include "util/simd.h"

#include <string.h>

#if defined __x86_64__
#include <immintrin.h>
#endif

#define SIMD_UNROLL _Pragma("GCC unroll 3")

#define SIMD_NAME(x) x##_portable
#define SIMD_TARGET
#define SIMD_LANES 2
#define SIMD_BITS(v) ((uint32_t)((v)[0] >> 63 | (v)[1] >> 63 << 1))
#include "filter.h"

#if defined __x86_64__
#define SIMD_NAME(x) x##_avx2
#define SIMD_TARGET __attribute__((target("avx2,fma")))
#define SIMD_LANES 4
#define SIMD_BITS(v) ((uint32_t)_mm256_movemask_pd((__m256d)(v)))
#include "filter.h"

#define SIMD_NAME(x) x##_avx512
#define SIMD_TARGET __attribute__((target("avx512f,avx512dq,avx512vl,avx2,fma")))
#define SIMD_LANES 8
#define SIMD_BITS(v) ((uint32_t)_mm512_movepi64_mask((__m512i)(v)))
#include "filter.h"
#endif

enum { MOST_LANES = 8 };

typedef const double const_vertex[3];

int sepax__posed_pairs_lanes(sepax_simd simd) {
#if defined __x86_64__
  bool fast = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  bool wide = fast && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
              __builtin_cpu_supports("avx512vl");
  if (simd == SEPAX_SIMD_BEST || simd == SEPAX_SIMD_AVX512) {
    return wide ? 8 : fast ? 4 : 2;
  }
  if (simd == SEPAX_SIMD_AVX2) {
    return fast ? 4 : 2;
  }
#else
  (void)simd;
#endif
  return 2;
}

static const_vertex *triangle(const posed_pairs *p, int body, uint32_t number) {
  return (const_vertex *)(p->first[body] + number * p->stride[body]);
}

/* Copy the pairs: coordinate i of vertex k of pair n goes to (6 i + k) lanes + n. */
static void gather(const posed_pairs *p, const uint32_t (*pair)[2], int used, int lanes,
                   double c[18 * MOST_LANES]) {
  for (int n = 0; n < lanes; n++) {
    const uint32_t *of = pair[n < used ? n : 0];
    const_vertex *a = triangle(p, 0, of[0]);
    const_vertex *b = triangle(p, 1, of[1]);
    for (int i = 0; i < 3; i++) {
      for (int k = 0; k < 3; k++) {
        c[(6 * i + k) * lanes + n] = a[k][i];
        c[(6 * i + 3 + k) * lanes + n] = b[k][i];
      }
    }
  }
}

typedef uint32_t filter(const double *from, const placement *at, bool strict, uint32_t *uncertain);
typedef uint32_t grid_judge(const double *from, const placement *at, uint32_t *off);

/* Judge a group of pairs. If a group before was in doubt, then whole numbers are tried first. */
static uint32_t judge_group(const posed_pairs *p, const double *c, bool *in_doubt,
                            uint32_t *uncertain) {
  filter *by_doubles = judge_portable;
  grid_judge *on_grid = judge_on_grid_portable;
#if defined __x86_64__
  if (p->lanes > 2) {
    by_doubles = p->lanes == 8 ? judge_avx512 : judge_avx2;
    on_grid = p->lanes == 8 ? judge_on_grid_avx512 : judge_on_grid_avx2;
  }
#endif
  bool has_grid = p->at.whole && !p->strict;
  uint32_t off = 0;
  uint32_t more = 0;
  if (has_grid && *in_doubt) {
    more = on_grid(c, &p->at, &off);
    if (off == 0) {
      *uncertain = 0;
      return more;
    }
  }
  uint32_t hits = by_doubles(c, &p->at, p->strict, uncertain);
  if (has_grid && !*in_doubt && *uncertain != 0) {
    more = on_grid(c, &p->at, &off);
    *in_doubt = true;
  }
  if (has_grid) {
    hits = (hits & ~*uncertain) | (more & *uncertain);
    *uncertain &= off;
  }
  return hits;
}

uint64_t sepax__judge_posed_pairs(const posed_pairs *p, const uint32_t (*pair)[2], int count,
                                  uint64_t *exact) {
  const int lanes = p->lanes;
  double c[18 * MOST_LANES];
  uint64_t hits = 0;
  bool in_doubt = false;
  *exact = 0;
  for (int first = 0; first < count; first += lanes) {
    int used = count - first < lanes ? count - first : lanes;
    uint32_t uncertain;
    gather(p, pair + first, used, lanes, c);
    uint32_t group = judge_group(p, c, &in_doubt, &uncertain);
    uint32_t mine = (1U << used) - 1;
    uncertain &= mine;
    *exact |= (uint64_t)uncertain << first;
    group &= ~uncertain;
    for (uint32_t rest = p->rough ? 0 : uncertain; rest != 0; rest &= rest - 1) {
      int n = __builtin_ctz(rest);
      const uint32_t *of = pair[first + n];
      sepax_verdict v = sepax_exact_posed(triangle(p, 0, of[0]), p->at.pose[0],
                                          triangle(p, 1, of[1]), p->at.pose[1]);
      bool hit = p->strict ? v.strict : v.collision;
      group |= (uint32_t)hit << n;
    }
    hits |= (uint64_t)(group & mine) << first;
  }
  return hits;
}
