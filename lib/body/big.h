/* SPDX-License-Identifier: MIT */
/* big.h - signed integers of any size that sums and products of a few doubles reach (private).
 *
 * A value is sign * limb[0 ... limbs-1] * 2^0, limb[0] the lowest, the highest not 0; zero has no
 * limbs and sign 0. A result may be one of its operands in sums, never in products. Limbs beyond
 * `limbs` hold nothing. Posed coordinates of doubles on a common exponent have up to 3,160 bits
 * (body.h), an orient3d of them three times as many, the square of one six times. */
#ifndef SEPAX_BIG_H
#define SEPAX_BIG_H

#include <assert.h>
#include <stdint.h>

enum { BIG_LIMBS = 304 };

typedef struct {
  int sign, limbs;
  uint64_t limb[BIG_LIMBS];
} big;

static inline void big_set_zero(big *r) { r->sign = r->limbs = 0; }

static inline void big_copy(big *r, const big *p) {
  r->sign = p->sign;
  r->limbs = p->limbs;
  for (int i = 0; i < p->limbs; i++) {
    r->limb[i] = p->limb[i];
  }
}

static inline int big_compare_sizes(const big *p, const big *q) {
  if (p->limbs != q->limbs) {
    return p->limbs < q->limbs ? -1 : 1;
  }
  for (int i = p->limbs - 1; i >= 0; i--) {
    if (p->limb[i] != q->limb[i]) {
      return p->limb[i] < q->limb[i] ? -1 : 1;
    }
  }
  return 0;
}

/* r = |p| + |q|; |p| must be the longer. */
static inline void big_add_sizes(big *r, const big *p, const big *q) {
  unsigned __int128 carry = 0;
  for (int i = 0; i < p->limbs; i++) {
    carry += (unsigned __int128)p->limb[i] + (i < q->limbs ? q->limb[i] : 0);
    r->limb[i] = (uint64_t)carry;
    carry >>= 64;
  }
  r->limbs = p->limbs;
  if (carry != 0) {
    assert(r->limbs < BIG_LIMBS);
    r->limb[r->limbs++] = (uint64_t)carry;
  }
}

/* r = |p| - |q|; |p| must be the greater. */
static inline void big_subtract_sizes(big *r, const big *p, const big *q) {
  uint64_t borrow = 0;
  int used = 0;
  for (int i = 0; i < p->limbs; i++) {
    uint64_t take = i < q->limbs ? q->limb[i] : 0;
    uint64_t less = p->limb[i] - take;
    uint64_t lend = (uint64_t)(p->limb[i] < take) | (uint64_t)(less < borrow);
    r->limb[i] = less - borrow;
    borrow = lend;
    used = r->limb[i] != 0 ? i + 1 : used;
  }
  r->limbs = used;
}

/* r = p + sign_q * |q|. */
static inline void big_add_signed(big *r, const big *p, const big *q, int sign_q) {
  if (sign_q == 0 || p->sign == 0) {
    const big *only = sign_q == 0 ? p : q;
    int sign = sign_q == 0 ? p->sign : sign_q;
    big_copy(r, only);
    r->sign = sign;
    return;
  }
  int order = big_compare_sizes(p, q);
  int sign = order >= 0 ? p->sign : sign_q;
  const big *most = order >= 0 ? p : q;
  const big *least = order >= 0 ? q : p;
  if (p->sign == sign_q) {
    big_add_sizes(r, most, least);
  } else if (order != 0) {
    big_subtract_sizes(r, most, least);
  } else {
    sign = r->limbs = 0;
  }
  r->sign = sign;
}

static inline void big_add(big *r, const big *p, const big *q) { big_add_signed(r, p, q, q->sign); }

static inline void big_subtract(big *r, const big *p, const big *q) {
  big_add_signed(r, p, q, -q->sign);
}

static inline void big_multiply(big *r, const big *p, const big *q) {
  if (p->sign == 0 || q->sign == 0) {
    big_set_zero(r);
    return;
  }
  int limbs = p->limbs + q->limbs;
  assert(p->limbs > 0 && q->limbs > 0 && limbs <= BIG_LIMBS);
  for (int i = 0; i < p->limbs; i++) {
    r->limb[i] = 0;
  }
  for (int j = 0; j < q->limbs; j++) {
    unsigned __int128 carry = 0;
    for (int i = 0; i < p->limbs; i++) {
      carry += (unsigned __int128)p->limb[i] * q->limb[j] + r->limb[i + j];
      r->limb[i + j] = (uint64_t)carry;
      carry >>= 64;
    }
    r->limb[j + p->limbs] = (uint64_t)carry;
  }
  r->limbs = limbs - (r->limb[limbs - 1] == 0);
  r->sign = p->sign * q->sign;
}

/* r += sign * size * 2^shift. */
static inline void big_add_shifted(big *r, int sign, unsigned __int128 size, int shift) {
  big term;
  int at = shift / 64;
  int bits = shift % 64;
  assert(at + 3 <= BIG_LIMBS);
  for (int i = 0; i < at; i++) {
    term.limb[i] = 0;
  }
  term.limb[at] = (uint64_t)(size << bits);
  size >>= 64 - bits;
  term.limb[at + 1] = (uint64_t)size;
  term.limb[at + 2] = (uint64_t)(size >> 64);
  term.limbs = at + 3;
  while (term.limbs > 0 && term.limb[term.limbs - 1] == 0) {
    term.limbs--;
  }
  big_add_signed(r, r, &term, term.limbs > 0 ? sign : 0);
}

#endif
