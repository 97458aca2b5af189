/* judge.c - verdicts on pairs of posed triangles, several at once: by doubles (filter.h), where
 * these are not certain by whole numbers, else by sepax_exact_posed. */
#include "judge.h"
#include "verdict/signs.h"

#include <string.h>

#if defined __x86_64__
#include <immintrin.h>
#endif

#define UNROLL _Pragma("GCC unroll 3")

#define NAME(x) x##_portable
#define TARGET
#define LANES 2
#define BITS(v) ((uint32_t)((v)[0] >> 63 | (v)[1] >> 63 << 1))
#include "filter.h"

#if defined __x86_64__
#define NAME(x) x##_avx2
#define TARGET __attribute__((target("avx2,fma")))
#define LANES 4
#define BITS(v) ((uint32_t)_mm256_movemask_pd((__m256d)(v)))
#include "filter.h"
#endif

enum { MOST_LANES = 4 };

typedef const double const_vertex[3];

bool posed_pairs_fast(sepax_path path) {
#if defined __x86_64__
  return path != SEPAX_PATH_PORTABLE && __builtin_cpu_supports("avx2") &&
         __builtin_cpu_supports("fma");
#else
  (void)path;
  return false;
#endif
}

static const_vertex *triangle(const posed_pairs *p, int body, uint32_t number) {
  return (const_vertex *)(p->first[body] + number * p->stride[body]);
}

/* Coordinate i of vertex k of pair n goes to (6 i + k) lanes + n. */
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

static uint32_t judge_group(const posed_pairs *p, const double *c, uint32_t *uncertain) {
  uint32_t off = 0;
  uint32_t hits;
  uint32_t more = 0;
#if defined __x86_64__
  if (p->fast) {
    hits = judge_avx2(c, &p->at, p->strict, uncertain);
    if (*uncertain == 0 || !p->at.whole || p->strict) {
      return hits;
    }
    more = judge_on_grid_avx2(c, &p->at, &off);
  } else
#endif
  {
    hits = judge_portable(c, &p->at, p->strict, uncertain);
    if (*uncertain == 0 || !p->at.whole || p->strict) {
      return hits;
    }
    more = judge_on_grid_portable(c, &p->at, &off);
  }
  hits = (hits & ~*uncertain) | (more & *uncertain);
  *uncertain &= off;
  return hits;
}

uint64_t judge_posed_pairs(const posed_pairs *p, const uint32_t (*pair)[2], int count) {
  const int lanes = p->fast ? 4 : 2;
  double c[18 * MOST_LANES];
  uint64_t hits = 0;
  for (int first = 0; first < count; first += lanes) {
    int used = count - first < lanes ? count - first : lanes;
    uint32_t uncertain;
    gather(p, pair + first, used, lanes, c);
    uint32_t group = judge_group(p, c, &uncertain);
    uint32_t mine = (1U << used) - 1;
    for (uint32_t rest = uncertain & mine; rest != 0; rest &= rest - 1) {
      int n = __builtin_ctz(rest);
      const uint32_t *of = pair[first + n];
      sepax_verdict v = sepax_exact_posed(triangle(p, 0, of[0]), p->at.pose[0],
                                          triangle(p, 1, of[1]), p->at.pose[1]);
      bool hit = p->strict ? v.strict : v.collision;
      group = (group & ~(1U << n)) | (uint32_t)hit << n;
    }
    hits |= (uint64_t)(group & mine) << first;
  }
  return hits;
}
