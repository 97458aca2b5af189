/* sepax_vectors.h - the input of tests and experiments: random numbers, families of hard pairs,
 * pairs as text, sample objects. The conventions are those of sepax.h. */
#ifndef SEPAX_VECTORS_H
#define SEPAX_VECTORS_H

#include "sepax_design.h"
#include "sepax_models.h"

#include <stdio.h>

#ifdef __cplusplus
extern "C" {
#endif
#ifdef __GNUC__
#pragma GCC visibility push(default)
#endif

/* ------------------------------------------------------------- test vectors */

/* A stream of pseudo-random numbers (splitmix64): same seed, same stream. */
typedef struct {
  uint64_t state;
} sepax_random;

uint64_t sepax_random_next(sepax_random *random);
/* Uniform in lo ... hi, both included; lo <= hi. */
int64_t sepax_random_range(sepax_random *random, int64_t lo, int64_t hi);

/* Families of hard pairs, numbered from 0; NULL after the last. */
const char *sepax_family_name(size_t family);
const char *sepax_family_about(size_t family);

/* A random pair of a family (below the last) at W bits, normals by
 * sepax_unit_normal. */
sepax_pair sepax_family_pair(size_t family, int word, sepax_random *random);

/* The same with zero normals, several times as fast. */
sepax_pair sepax_family_triangles(size_t family, int word, sepax_random *random);

/* The same with AABBs whose sides are at most extent[0] (A) and extent[1] (B) LSB long (1 ... 2^W -
 * 1), many of them exactly as long, anywhere in the word. With `exceeds` one AABB exceeds its
 * extent by 1 LSB or more if it then fits the word; it does whenever both extents are below
 * 2^(W-2). */
sepax_pair sepax_extent_pair(size_t family, int word, const int extent[2], bool exceeds,
                             sepax_random *random);

/* Pairs as text: one line of 18 decimal integers A1x A1y A1z ... B3z, or 24 with
 * N_A and N_B behind them (computed when absent); '#' starts a comment. */
typedef enum { SEPAX_LINE_PAIR, SEPAX_LINE_EMPTY, SEPAX_LINE_ERROR } sepax_line;

/* Parse one line. Fails on other than 18 or 24 integers, and on one that does not fit W bits. */
sepax_line sepax_pair_parse(sepax_pair *pair, const char *line, int word, sepax_error *error);

/* The next pair of a stream; empty lines are skipped, a line has at most 4095 bytes. *number counts
 * lines for messages (start at 0), `name` names the stream. SEPAX_LINE_EMPTY is the end of the
 * stream. After an error the next read begins behind the bad line. */
sepax_line sepax_pair_read(sepax_pair *pair, FILE *in, const char *name, size_t *number, int word,
                           sepax_error *error);

/* A verdict as numbers, of which a design has the first `count`: collision (0, 1), coplanar (0, 1),
 * axis (0 ... 15), band (sepax_band). */
typedef struct {
  size_t count;
  int value[4];
} sepax_told;

/* The verdict of a design in these numbers: exact has three, with a clearance four, paper and
 * conference two, an architecture without hardware one. */
sepax_told sepax_tell(const sepax_design *design, const sepax_judgement *verdict);

/* Like sepax_pair_read. A line may also be what `sepax judge --echo` wrote: 24 integers and the
 * numbers of a verdict. *told gets them; its count is 0 if the line has none. */
sepax_line sepax_pair_read_told(sepax_pair *pair, sepax_told *told, FILE *in, const char *name,
                                size_t *number, int word, sepax_error *error);

/* Is what a line tells the verdict of this design? True if the line tells none. Error: FORMAT,
 * naming the number that differs. */
bool sepax_told_check(const sepax_told *told, const sepax_design *design,
                      const sepax_judgement *verdict, sepax_error *error);

/* Print the 24 integers separated by blanks, without a newline. */
void sepax_pair_print(FILE *out, const sepax_pair *pair);

/* ---------------------------------------------------------------- samples */

/* A sample object: a closed mesh of exactly `triangles` facets in mm, refined by longest-edge
 * bisection. `at` is its centre (cutters: the tip; pocket: the middle of the top face), `size` its
 * characteristic length in mm (0: the default of the shape). Fails on an unknown shape, on fewer
 * triangles than the shape needs, on more than 10^9, on an odd number (a closed mesh has an even
 * number), and where `at` is farther than 2^30 sizes from the origin. */
bool sepax_sample(sepax_soup *soup, const char *shape, size_t triangles, const double at[3],
                  double size, sepax_error *error);

/* Names, descriptions and least numbers of triangles; NULL and 0 after the last. */
const char *sepax_sample_name(size_t i);
const char *sepax_sample_about(size_t i);
size_t sepax_sample_least(size_t i);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif
#endif
