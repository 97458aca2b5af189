/* delay.h - the delay model: when logic between registers has settled, in nanoseconds. Registers
 * are placed by it (docs/results/clock.md#target-periods tells how far it is right). */
#ifndef SEPAX_DELAY_H
#define SEPAX_DELAY_H

/* All fitted numbers of one cell library. A logarithm is to base 2 of the width in bits. */
typedef struct {
  const char *library;
  double reg; /* clock to output and setup together */
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
  double slot;          /* of a slot bit over the multiplexers of a unit */
  double operands[2];   /* of slot bits before operands of shared units: a + b log2 (W / 8) */
  double fixed_slots;   /* more of it where coordinates do not rotate */
  double shared_value;  /* of a value that many units read */
  double sums[3];       /* of a trapezoid's sums over its rows: a + b (width - c), at least 0 */
  double orient2d_sign; /* of a zero test of an orient2d, and what its sign steers */
  double aabb;          /* of the AABB test: bounds, comparison, isolation of the coordinates */
  /* Thirds of a gate equivalent a bit: */
  int flip_flop, enabled_flip_flop;
} delay_model;

/* The library for which registers are placed. */
extern const delay_model *const delay_used;

double delay_register(void);
double delay_row(int width);
double delay_compressor(void); /* one 3:2 compressor on whole words */
double delay_adder(int width);
double delay_test(int width);
double delay_mux(int inputs);
double delay_operands(int word); /* of shared units, behind the fan-out of what selects them */
double delay_sums_fan_out(int width);

#endif
