/* arith.h - arithmetic of architecture exact: compressors, Booth multipliers, and the
 * delays by which they are pipelined. */
#ifndef SEPAX_ARITH_H
#define SEPAX_ARITH_H

#include "gen.h"

/* Delays in nanoseconds of mapped and sized logic, Nangate45 typical (docs/exact.md has
 * the fit, `make timing` holds it against OpenSTA). */
double delay_register(void);    /* clock to output and setup together */
double delay_booth(int width);  /* recoding, its fan-out over a row, and selection */
double delay_compressor(void);  /* one 3:2 compressor on whole words */
double delay_adder(int width);  /* carry-propagate addition */
double delay_test(int width);   /* width bits are zero */
double delay_mux(int inputs);   /* one of several sources, by cycle of the frame */

/* A multiplier a x b modulo 2^p_w: rows by radix-4 Booth recoding of b; full adders,
 * column by column, the earliest bits first, until two rows are left; one addition. A half
 * adder first makes odd columns even, so that no carry ripples through them. Where
 * a bit would come later than the period allows, it is made behind a rank of registers. */
enum { ARITH_BITS = 12288, ARITH_ADDERS = 3072, ARITH_WIDTH = 128, ARITH_RANKS = 8 };

typedef enum { ARITH_ROW, ARITH_NEGATIVE, ARITH_SUM, ARITH_CARRY, ARITH_ONE } arith_source;

typedef struct {
  arith_source source;
  int from, index;   /* row and bit of it; or the adder */
  int stage;         /* ranks passed when it is made */
  int last;          /* ranks passed when it is last used */
  double time;       /* since that rank */
} arith_bit;

typedef enum {
  ARITH_FULL,        /* a + b + c */
  ARITH_HALF,        /* a + b */
  ARITH_PLUS_ONE,    /* a + b + 1 */
  ARITH_TOP_FULL,    /* the same in the highest column, which needs no carry */
  ARITH_TOP_HALF,
  ARITH_TOP_PLUS_ONE
} arith_kind;

typedef struct {
  arith_kind kind;
  int column, level, stage;
  int input[3];      /* bits; two but in full adders */
  int copy;          /* which of its kind in its column, level and stage */
} arith_adder;

typedef struct {
  int a_w, b_w, p_w;
  int rows, levels, ranks;
  int registers;     /* bits in all ranks */
  arith_bit bit[ARITH_BITS];
  int bits;
  arith_adder adder[ARITH_ADDERS];
  int adders;
  int final[2][ARITH_WIDTH]; /* the two rows of the last addition; -1: no bit */
} arith_plan;

/* `used` ns are spent before the rows. */
void arith_plan_make(arith_plan *plan, int a_w, int b_w, int p_w, double used, double period);

void gen_fa(emitter *e);
void gen_booth(emitter *e);

/* Emit the multiplier as a module: ports a, b, p, and clk if it has registers. */
void gen_multiplier(emitter *e, const char *name, const arith_plan *plan);

#endif
