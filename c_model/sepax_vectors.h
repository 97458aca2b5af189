/* SPDX-License-Identifier: MIT */
/* sepax_vectors.h - input for tests and experiments: random numbers, families of hard pairs, pairs
 * as text, and sample objects. The conventions are those of sepax.h. */
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

/* A stream of pseudo-random numbers (splitmix64). `state` begins as the seed; the same seed gives
 * the same stream. */
typedef struct {
  uint64_t state;
} sepax_random;

/* The next 64 random bits. */
uint64_t sepax_random_next(sepax_random *random);

/* A uniform random integer in lo ... hi, both included; lo <= hi. */
int64_t sepax_random_range(sepax_random *random, int64_t lo, int64_t hi);

/* The name of a family of hard pairs, and one line about it. Families are numbered from 0; the
 * functions return NULL after the last one. */
const char *sepax_family_name(size_t family);
const char *sepax_family_about(size_t family);

/* A random pair of an existing family, with coordinates of `word` bits and the normals of
 * sepax_unit_normal. */
sepax_pair sepax_family_pair(size_t family, int word, sepax_random *random);

/* The same pair with zero normals. It is several times as fast. */
sepax_pair sepax_family_triangles(size_t family, int word, sepax_random *random);

/* A random pair of a family whose AABB sides are at most extent[0] LSB for A and extent[1] LSB for
 * B (each 1 ... 2^W - 1). Many sides are exactly as long as the extent. The pair lies anywhere in
 * the range of the word. If `exceeds` is true, then one AABB is longer than its extent by 1 LSB or
 * more, provided that it still fits the word. It always fits if both extents are below 2^(W-2). */
sepax_pair sepax_extent_pair(size_t family, int word, const int extent[2], bool exceeds,
                             sepax_random *random);

/* A pair as text is one line of 18 decimal integers A1x A1y A1z ... B3z, or of 24 integers, the
 * last six of which are N_A and N_B. If the normals are absent, then they are computed. '#' starts
 * a comment. The enumeration says what a line was. */
typedef enum { SEPAX_LINE_PAIR, SEPAX_LINE_EMPTY, SEPAX_LINE_ERROR } sepax_line;

/* Parse one line. Error: FORMAT if the line has not 18 or 24 integers or if an integer does not fit
 * `word` bits. */
sepax_line sepax_pair_parse(sepax_pair *pair, const char *line, int word, sepax_error *error);

/* Read the next pair of a stream. Empty lines are skipped. A line has at most 4095 bytes. *number
 * counts the lines and must start at 0; `name` is the name of the stream. Messages contain both.
 * SEPAX_LINE_EMPTY means the end of the stream. After an error the next call goes on after the bad
 * line. Error: FORMAT. */
sepax_line sepax_pair_read(sepax_pair *pair, FILE *in, const char *name, size_t *number, int word,
                           sepax_error *error);

/* A verdict as up to four numbers, in this order: collision (0 or 1), coplanar (0 or 1), axis
 * (0 ... 15), band (sepax_band). `count` says how many of the numbers the verdict has. */
typedef struct {
  size_t count;
  int value[4];
} sepax_told;

/* The verdict of a design as numbers. The verdict of exact has three numbers, and four numbers if
 * the design has a clearance. The verdicts of paper and conference have two numbers, and those of
 * architectures without hardware have one. */
sepax_told sepax_tell(const sepax_design *design, const sepax_judgement *verdict);

/* Read the next pair of a stream, like sepax_pair_read. After the 24 integers a line may also have
 * the numbers of a verdict, as `sepax judge --echo` writes them. The function stores these numbers
 * in *told, and sets told->count to 0 if the line has no verdict. */
sepax_line sepax_pair_read_told(sepax_pair *pair, sepax_told *told, FILE *in, const char *name,
                                size_t *number, int word, sepax_error *error);

/* True if the verdict of a line (*told) equals the verdict of this design, or if the line has no
 * verdict. Error: FORMAT if a number differs; the text of *error names the number. */
bool sepax_told_check(const sepax_told *told, const sepax_design *design,
                      const sepax_judgement *verdict, sepax_error *error);

/* Print the 24 integers of a pair, separated by blanks, without a newline. */
void sepax_pair_print(FILE *out, const sepax_pair *pair);

/* ---------------------------------------------------------------- samples */

/* Make a sample object: a closed mesh of exactly `triangles` facets, in mm. A coarse mesh is
 * refined by bisection of longest edges. `at` is the centre of the object; for cutters it is the
 * tip, and for the pocket the middle of the top face. `size` is the characteristic length in mm; 0
 * means the default of the shape. Errors: ARGUMENT if the shape is unknown, if `triangles` is below
 * the least number of the shape, above 10^9 or odd (a closed mesh has an even number), if `at` is
 * farther than 2^30 sizes from the origin, or if a triangle would lose its area in double
 * precision; MEMORY. */
bool sepax_sample(sepax_soup *soup, const char *shape, size_t triangles, const double at[3],
                  double size, sepax_error *error);

/* The name of shape i, one line about it, and its least number of triangles. Shapes are numbered
 * from 0; the functions return NULL, NULL and 0 after the last one. */
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
