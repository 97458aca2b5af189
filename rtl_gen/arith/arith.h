/* SPDX-License-Identifier: MIT */
/* arith.h - arithmetic of architecture exact: multipliers and sums of products, pipelined by the
 * delay model. */
#ifndef SEPAX_ARITH_H
#define SEPAX_ARITH_H

#include "datapath/delay.h"
#include "emit/emit.h"

/* A recoded multiplier modulo 2^p_w. b is cut into radix-4 digits; each but the highest counts
 * for one less than it says, so that it is -1, 0, 1 or 2 and its row needs no multiple of a
 * but a, 2a and -a. All in all that is a (b - BIAS), BIAS = 1 + 4 + 16 ...: the biased
 * multiplier, for whoever adds BIAS to b beforehand, or has sums in which a BIAS cancels; or the
 * plain one, which adds BIAS to b itself. Two less do as well (-2, -1, 0, 1; BIAS = 2 + 8 + 32
 * ...), for a b that has got the lesser BIAS twice. Then full adders, column by column,
 * the earliest bits first, until two rows are left; one addition. A half adder first makes
 * odd columns even, so that no carry ripples through them. Where a bit would come later
 * than the period allows, it is made behind a pipeline register. */
enum { ARITH_BITS = 12288, ARITH_ADDERS = 3072, ARITH_WIDTH = 128, ARITH_STAGES = 8 };

typedef enum {
  ARITH_ROW,
  ARITH_NEGATIVE,
  ARITH_ADDEND,
  ARITH_SUM,
  ARITH_CARRY,
  ARITH_ONE
} arith_source;

/* Pipeline registers passed, and ns since the last of them. */
typedef struct {
  int stage;
  double time;
} arith_moment;

typedef struct {
  arith_source source;
  int from, index; /* the row, addend or adder; where in its vector, -1: it has none */
  arith_moment made;
  int last;                /* the stage in which it is last used */
  int place[ARITH_STAGES]; /* in each pipeline register that it passes */
} arith_bit;

typedef enum {
  ARITH_FULL,     /* a + b + c */
  ARITH_HALF,     /* a + b */
  ARITH_PLUS_ONE, /* a + b + 1 */
  ARITH_TOP_FULL, /* the same in the highest column, which needs no carry */
  ARITH_TOP_HALF,
  ARITH_TOP_PLUS_ONE
} arith_kind;

typedef struct {
  arith_kind kind;
  int column, level, stage;
  int input[3]; /* bits; two but in full adders */
  int copy;     /* which of its kind in its column, level and stage */
  int order;    /* which of its kind, level, stage and copy: they stand side by side */
} arith_adder;

/* What is added to products: `width` bits, signed, times 2^place; or subtracted. */
enum { ARITH_ADDENDS = 2 };
typedef struct {
  int width, place; /* 0: none */
  bool minus;
} arith_addend;

typedef struct {
  const delay_model *delay; /* NULL: that of an ASIC's cells */
  int a_w, b_w, p_w;        /* bits of a, b, the product */
  int digits;               /* of b, for a (b - BIAS); the highest must be in -2 ... 2. 0: a b */
  int less;                 /* what a digit counts less: 1, 2 */
  double used;              /* ns spent before b is there */
  int terms; /* 0: a product. Else a sum of so many products a (b - BIAS) and addends */
  arith_addend addend[ARITH_ADDENDS];
  bool open;     /* gates: no last addition; the sum is that of two numbers, */
  double behind; /* which whoever reads them has ns for */
} arith_form;

/* How the multipliers of an FPGA make a product: low bits of a and of b are left to logic; what is
 * left of a is cut into parts of `part` bits, the last signed, each times what is left of b. */
typedef struct {
  int parts; /* 0: gates */
  int part, low_a, low_b;
  double settled; /* ns until what logic makes has */
} arith_cut;

typedef struct {
  const char *fault; /* NULL, or why the plan is none: more than it holds */
  const delay_model *delay;
  int a_w, b_w, p_w;
  arith_cut cut;
  bool plain; /* a b; else a (b - BIAS) */
  int less;
  int sum_w; /* bits that are cut into digits: b, or b + BIAS */
  int terms; /* of a sum of products; 0: a product */
  arith_addend addend[ARITH_ADDENDS];
  bool open;                  /* the sum is that of two numbers, p and q */
  int rows, levels, latency;  /* rows of a product */
  double settled;             /* gates: ns in the last stage until the product is there */
  int registers;              /* bits in all pipeline registers */
  int crossing[ARITH_STAGES]; /* in each */
  arith_bit bit[ARITH_BITS];
  int bits;
  arith_adder adder[ARITH_ADDERS];
  int adders;
  int final[2][ARITH_WIDTH]; /* the two rows of the last addition; -1: no bit */
} arith_plan;

/* The shortest period in ns, however many pipeline registers: registers, and a row and a full
 * adder, or the last addition, or that of BIAS. */
double arith_shortest(const arith_form *form);

/* Plan the multiplier for a period in ns, not below arith_shortest: its latency is the least that
 * the delay model (datapath/delay.h) allows. A multiplier of more bits, adders or columns than the
 * plan holds gets a fault, and gen_multiplier refuses it; 80 x 80 bits, the most that a design asks
 * for, fit. */
void arith_plan_make(arith_plan *plan, const arith_form *form, double period);

/* The same for an FPGA: gates are not planned. A product alone, or one of those that are summed. */
void arith_product_make(arith_plan *plan, const arith_form *form, double period);
void gen_product(emitter *e, const arith_plan *plan);

/* A sum of products on an FPGA; where a product is a sum of parts, theirs takes two stages. */
void gen_products(emitter *e, const arith_plan *plan);
bool arith_two_sums(const arith_plan *plan);

/* The module that one multiplier of the FPGA makes. */
void gen_dsp(emitter *e, const delay_model *m);

/* Would both plans make the same module? */
bool arith_same(const arith_plan *plan, const arith_plan *other);

/* Bits of a row; whether they are all, or cut off at the product's highest. */
int arith_row_bits(const arith_plan *plan, int row);
bool arith_row_whole(const arith_plan *plan, int row);

/* Emit what multipliers are made of, once a design and before them: sepax_fa; sepax_digit and
 * sepax_top_digit, and sepax_digit_2, of digits that count two less, if asked for. */
void gen_multiplier_parts(emitter *e, bool two_less);

/* Its module: sepax_mul_AxB; of a sum of N products, sepax_productsN_AxB; of biased ones
 * sepax_mul_AxB_biased, or sepax_mul_AxB_biased_2 where digits count two less; of a sum that
 * is left open sepax_productsN_AxB_open. */
gen_line arith_name(const arith_plan *plan);

/* BIAS, decimal. */
gen_line arith_bias(const arith_plan *plan);

/* Emit the multiplier as a module: ports a, b, p, and clk if its latency is above 0. Of a sum of
 * products a and b hold all factors, the first lowest; ports c, d are the addends that there are.
 * If the sum is left open, then it is p + q. */
void gen_multiplier(emitter *e, const arith_plan *plan);

#endif
