/* SPDX-License-Identifier: MIT */
/* delay.h - the delay model: when logic between registers has settled, in nanoseconds. Registers
 * are placed by it (docs/developers/results/clock.md#target-periods tells how far it is right). */
#ifndef SEPAX_DELAY_H
#define SEPAX_DELAY_H

#include "sepax_design.h"

/* All fitted numbers of one cell library, or of one family of FPGAs. A logarithm is to base 2 of
 * the width in bits. */
typedef struct {
  const char *library;
  bool family; /* of FPGAs */
  int dsp[2];  /* bits of the signed factors of its multiplier, the longer first; 80: of what
                  one stage of its logic multiplies */
  double reg;  /* clock to output and setup together */
  /* a + b log2 width + c width: */
  double row[2];   /* a digit, its fan-out over a row of partial products, and selection */
  double adder[3]; /* carry-propagate addition, comparison */
  double test[2];  /* all bits are zero */
  double mux[2];   /* of so many inputs: one by slot */
  /* Of a full adder, from its first two inputs and from the third, which may be late. */
  double sum, late_sum, carry;
  double early_correction; /* a row's correction bit is there so much before the row */
  double skew_lost; /* low columns settle early, which helps the last addition, but not behind a
                       pipeline register */
  /* Fan-outs: */
  double slot;         /* of a slot bit over the multiplexers of a unit */
  double operands[2];  /* of slot bits before operands of shared units: a + b log2 (W / 8) */
  double fixed_slots;  /* more of it where coordinates do not rotate */
  double shared_value; /* of a value that many units read */
  double sums[3];      /* of a trapezoid's sums over its rows: a + b (width - c), at least 0 */
  double decide;       /* of the verdict, from the signs of orient3d */
  double ripple;       /* of a bit of an addition that is a chain of full adders */
  double overlap;      /* of two units in a chain: the second begins with the low bits */
  double aabb;         /* of the AABB test: bounds, comparison, isolation of the coordinates */
  double engine;       /* of the object engine: a queue read, what is counted and compared of it */
  double product;      /* of an FPGA's multiplier */
  double slow;         /* how many times slower the cells of the slow corner are */
  /* Thirds of a gate equivalent a bit: */
  int flip_flop, enabled_flip_flop;
} delay_model;

/* That of a target. */
const delay_model *delay_model_of(sepax_target target);

/* How many times slower than in the model cells are at the corner of a configuration. */
double delay_corner(const sepax_config *config);

double delay_register(const delay_model *m);
double delay_row(const delay_model *m, int width);
double delay_compressor(const delay_model *m); /* one 3:2 compressor on whole words */
double delay_adder(const delay_model *m, int width);
double delay_test(const delay_model *m, int width);
double delay_mux(const delay_model *m, int inputs);
/* Of shared units, behind the fan-out of what selects them. */
double delay_operands(const delay_model *m, int word);
double delay_sums_fan_out(const delay_model *m, int width);

#endif
