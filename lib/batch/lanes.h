/* lanes.h - the exact verdicts of LANES pairs at once (private; pairs.c includes it once per
 * instruction set). Vectors are those of GCC and Clang.
 *
 * LANES, NAME(x), TARGET        pairs at once, a name of its own, the attribute of its functions
 * LOAD(from), LOAD_REALS(from)  the next LANES int32_t, sign-extended; as doubles
 * PRODUCT(p, q)                 product of the low 32 bits of each lane, signed; if it is not
 *                               defined, sepax_exact judges pairs uncertain in doubles, and
 *                               LOAD is not used
 * LEAST_REAL(p, q)              the lesser of doubles
 * BITS(v), BITS_OF_SHORTS(v)    the sign bits of lanes, of shorts, as a number
 * LEAST(p, q), MOST(p, q)       the lesser, the greater of shorts
 *
 * In doubles all products and sums of coordinates of 25 bits are exact, up to orient2d. The 19
 * products of orient2d and z sums round, and so do orient3d, their sums of up to four. With
 * orient2d up to 2^(2n) and sums of z up to 6 * 2^(n-1) they round by less than 2^12 in all if
 * coordinates have n = 20 bits, by less than 2^28 for n = 25. Where all 15 orient3d are larger,
 * their signs are certain. Elsewhere they are summed modulo 2^64: with 20 bits that is all of them;
 * with 25 bits the doubles give the sign of those from 2^62 upwards. */

typedef uint64_t NAME(lanes) __attribute__((vector_size(8 * LANES)));
typedef int64_t NAME(signed_lanes) __attribute__((vector_size(8 * LANES)));
typedef double NAME(reals) __attribute__((vector_size(8 * LANES)));
typedef int32_t NAME(shorts) __attribute__((vector_size(8 * LANES)));
enum { NAME(SHORT_LANES) = 2 * LANES };

#define V NAME(lanes)
#define R NAME(reals)
#define SHORTS NAME(shorts)
#define INLINE TARGET static inline __attribute__((always_inline))

/* -------------------------------------------------------------------- sums */

#ifdef PRODUCT
/* Modulo 2^64; z fits 32 bits, g need not. */
INLINE V NAME(prism)(V g, V z) {
  return PRODUCT(g, z) + (PRODUCT((g + (UINT64_C(1) << 31)) >> 32, z) << 32);
}

#endif

#define NUMBER R
#define OF(x) NAME(x##_real)
#define TIMES(p, q) ((p) * (q))
#define PRISM(g, z) ((g) * (z))
#include "sums.h"

INLINE R NAME(all_real)(int32_t value) { return (R){0} + (double)value; }

INLINE void NAME(find_real)(NAME(orient3d_real) * v, const sepax_tri *one, const block *in,
                            size_t at) {
  NAME(coordinate_real) c[3];
  UNROLL for (int axis = 0; axis < 3; axis++) {
    UNROLL for (int k = 0; k < 3; k++) {
      c[axis].a[k] =
          one != NULL ? NAME(all_real)(coordinate(one, k, axis)) : LOAD_REALS(in->a[k][axis] + at);
      c[axis].b[k] = LOAD_REALS(in->b[k][axis] + at);
    }
  }
  NAME(orient2d_real) g;
  NAME(find_orient2d_real)(&g, &c[0], &c[1]);
  NAME(find_orient3d_real)(v, &g, &c[2]);
}

/* ------------------------------------------------------- verdicts by doubles */

INLINE R NAME(least_size)(R least, R value) { return LEAST_REAL(least, (R)((V)value & INT64_MAX)); }

/* An edge with ends on different sides of a plane passes all edges p, q, r on one side. */
INLINE V NAME(pierces)(R from, R to, R p, R q, R r) {
  return ((V)from ^ (V)to) & ~(((V)p ^ (V)q) | ((V)q ^ (V)r));
}

/* The bits of the pairs that collide, and of those of which some sign is uncertain. */
INLINE uint32_t NAME(judge_large)(const sepax_tri *one, const block *in, size_t at, double limit,
                                  uint32_t *uncertain) {
  NAME(orient3d_real) v;
  NAME(find_real)(&v, one, in, at);
  R least = (R)((V)v.s[0] & INT64_MAX);
  V hit = {0};
  UNROLL for (int i = 0; i < 3; i++) {
    int n = next[i];
    hit |= NAME(pierces)(v.w[i], v.w[n], v.d[i][0], v.d[i][1], v.d[i][2]) |
           NAME(pierces)(v.s[i], v.s[n], v.d[0][i], v.d[1][i], v.d[2][i]);
    least = NAME(least_size)(NAME(least_size)(least, v.s[i]), v.w[i]);
    UNROLL for (int j = 0; j < 3; j++) { least = NAME(least_size)(least, v.d[i][j]); }
  }
  *uncertain = BITS((V)(least - limit));
  return BITS(hit);
}

/* ------------------------------------------------- verdicts by whole numbers */

#ifdef PRODUCT
#define WHOLE_PRODUCT(p, q) PRODUCT(p, q)
#define WHOLE_PRISM(g, z) NAME(prism)(g, z)
#define BITS_OF(v) BITS(v)
#include "whole.h"

INLINE V NAME(all)(int32_t value) { return (V){0} + (uint64_t)value; }

INLINE void NAME(load_whole)(NAME(coordinate_whole) c[3], const sepax_tri *one, const block *in,
                             size_t at) {
  UNROLL for (int axis = 0; axis < 3; axis++) {
    UNROLL for (int k = 0; k < 3; k++) {
      c[axis].a[k] = one != NULL ? NAME(all)(coordinate(one, k, axis)) : LOAD(in->a[k][axis] + at);
      c[axis].b[k] = LOAD(in->b[k][axis] + at);
    }
  }
}

/* The bits of the pairs that collide, if their AABBs overlap. */
INLINE uint32_t NAME(judge)(const sepax_tri *one, const block *in, size_t at,
                            const NAME(orient3d_real) * rough) {
  NAME(coordinate_whole) c[3];
  NAME(load_whole)(c, one, in, at);
  return NAME(judge_whole)(c, &(NAME(rough)){NULL, NULL, rough});
}

TARGET static __attribute__((noinline)) uint32_t NAME(judge_long)(const sepax_tri *one,
                                                                  const block *in, size_t at) {
  NAME(orient3d_real) rough;
  NAME(find_real)(&rough, one, in, at);
  return NAME(judge)(one, in, at, &rough);
}

/* The verdicts of a group; only those of `uncertain` are used. */
INLINE uint32_t NAME(judge_small)(const sepax_tri *one, const block *in, size_t at, bool is_long,
                                  uint32_t uncertain) {
  (void)uncertain;
  return is_long ? NAME(judge_long)(one, in, at) : NAME(judge)(one, in, at, NULL);
}
#else
INLINE uint32_t NAME(judge_small)(const sepax_tri *one, const block *in, size_t at, bool is_long,
                                  uint32_t uncertain) {
  (void)is_long;
  return (uint32_t)(judge_singly(one, in, (uint64_t)uncertain << at) >> at);
}
#endif

/* ------------------------------------------------------------------- blocks */

typedef struct {
  SHORTS least, most; /* of all coordinates */
} NAME(ends);

INLINE SHORTS NAME(short_all)(int32_t value) { return (SHORTS){0} + value; }

INLINE SHORTS NAME(short_load)(const int32_t *from) {
  SHORTS shorts;
  memcpy(&shorts, from, sizeof shorts);
  return shorts;
}

INLINE SHORTS NAME(disjoint)(const SHORTS p[3], const SHORTS q[3], NAME(ends) * ends) {
  SHORTS low_p = LEAST(LEAST(p[0], p[1]), p[2]);
  SHORTS low_q = LEAST(LEAST(q[0], q[1]), q[2]);
  SHORTS high_p = MOST(MOST(p[0], p[1]), p[2]);
  SHORTS high_q = MOST(MOST(q[0], q[1]), q[2]);
  ends->least = LEAST(ends->least, LEAST(low_p, low_q));
  ends->most = MOST(ends->most, MOST(high_p, high_q));
  return (SHORTS)((high_p < low_q) | (high_q < low_p));
}

/* The pairs of a block whose AABBs overlap; *longest is a number as long as the longest coordinate.
 */
INLINE uint64_t NAME(aabbs_overlap)(const sepax_tri *one, const block *in, uint32_t *longest) {
  NAME(ends) ends;
  ends.least = ends.most = (SHORTS){0};
  uint64_t disjoint = 0;
  for (size_t m = 0; m < BLOCK; m += NAME(SHORT_LANES)) {
    SHORTS any = {0};
    UNROLL for (int axis = 0; axis < 3; axis++) {
      SHORTS p[3];
      SHORTS q[3];
      UNROLL for (int k = 0; k < 3; k++) {
        p[k] = one != NULL ? NAME(short_all)(coordinate(one, k, axis))
                           : NAME(short_load)(in->a[k][axis] + m);
        q[k] = NAME(short_load)(in->b[k][axis] + m);
      }
      any |= NAME(disjoint)(p, q, &ends);
    }
    disjoint |= (uint64_t)BITS_OF_SHORTS(any) << m;
  }
  int32_t sizes[NAME(SHORT_LANES)];
  SHORTS size = MOST(ends.most, ~ends.least);
  memcpy(sizes, &size, sizeof size);
  *longest = 0;
  for (int k = 0; k < NAME(SHORT_LANES); k++) {
    *longest |= (uint32_t)sizes[k];
  }
  return ~disjoint;
}

/* Doubles are tried as long as they settle most groups of the block. */
INLINE uint64_t NAME(judge_block)(const sepax_tri *one, const block *in) {
  const uint64_t group = (UINT64_C(1) << LANES) - 1;
  uint32_t longest;
  uint64_t candidates = NAME(aabbs_overlap)(one, in, &longest);
  if (candidates == 0) {
    return 0;
  }
  if (longest >> LONG_BITS != 0) {
    return judge_singly(one, in, candidates);
  }
  bool is_long = longest >> SHORT_BITS != 0;
  double limit = is_long ? LONG_LIMIT : SHORT_LIMIT;
  uint64_t hits = 0;
  size_t tried = 0;
  size_t failed = 0;
  for (size_t m = 0; m < BLOCK; m += LANES) {
    uint32_t wanted = (uint32_t)(candidates >> m & group);
    if (wanted == 0) {
      continue;
    }
    uint32_t found = 0;
    uint32_t uncertain = wanted;
    if (failed * 3 <= tried) {
      found = NAME(judge_large)(one, in, m, limit, &uncertain);
      uncertain &= wanted;
      tried++;
      failed += uncertain != 0;
    }
    if (uncertain != 0) {
      found =
          (found & ~uncertain) | (uncertain & NAME(judge_small)(one, in, m, is_long, uncertain));
    }
    hits |= (uint64_t)found << m;
  }
  return hits & candidates;
}

TARGET static uint64_t NAME(judge_pairs)(const block *in) { return NAME(judge_block)(NULL, in); }

TARGET static uint64_t NAME(judge_one)(const sepax_tri *one, const block *in) {
  return NAME(judge_block)(one, in);
}

#undef V
#undef R
#undef SHORTS
#undef INLINE
#undef LANES
#undef NAME
#undef TARGET
#undef LOAD
#undef LOAD_REALS
#undef PRODUCT
#undef LEAST_REAL
#undef BITS
#undef BITS_OF_SHORTS
#undef LEAST
#undef MOST
