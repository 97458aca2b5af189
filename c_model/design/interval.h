/* interval.h - interval analysis: how many bits hold every value. */
#ifndef SEPAX_INTERVAL_H
#define SEPAX_INTERVAL_H

typedef __int128 wide;

typedef struct {
  wide lo, hi;
} interval;

static inline interval hull(interval p, interval q) {
  return (interval){p.lo < q.lo ? p.lo : q.lo, p.hi > q.hi ? p.hi : q.hi};
}

static inline interval difference(interval p, interval q) {
  return (interval){p.lo - q.hi, p.hi - q.lo};
}

static inline interval product(interval p, interval q) {
  wide corner[] = {p.lo * q.lo, p.lo * q.hi, p.hi * q.lo, p.hi * q.hi};
  interval r = {corner[0], corner[0]};
  for (int i = 1; i < 4; i++) {
    r = hull(r, (interval){corner[i], corner[i]});
  }
  return r;
}

static inline interval sum_of_three(interval p) { return (interval){3 * p.lo, 3 * p.hi}; }

/* The least width of a two's complement number that holds all of them. */
static inline int bits_of(interval p) {
  int bits = 1;
  while (p.lo < -((wide)1 << (bits - 1)) || p.hi >= (wide)1 << (bits - 1)) {
    bits++;
  }
  return bits;
}

static inline interval signed_word(int bits) {
  wide half = (wide)1 << (bits - 1);
  return (interval){-half, half - 1};
}

#endif
