/* SPDX-License-Identifier: MIT */
/* paper_coplanarity_epsilon.c - the epsilon of the paper's coplanarity test: how far in LSB, along
 * a unit normal, a vertex may be from a plane and still count as lying in it (--epsilon,
 * docs/reference/paper.md). rtl_gen/paper/sepax_cop.v is the test in hardware. */
#include "design/paper.h"
#include "util/error.h"

bool sepax__paper_epsilon_check(const sepax_config *config, sepax_error *error) {
  int most = sepax_word_max(config->word);
  return config->epsilon <= most ||
         sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                    "epsilon: %d LSB is out of range; give 0 ... %d at W = %d", config->epsilon,
                    most, config->word);
}

/* A unit normal has W - 1 fractional bits. The bits that the formats drop are rounded up. An
 * epsilon of 0 asks for equality, that is, for a difference below 1. */
int64_t sepax__paper_coplanar_limit(const sepax_design *d) {
  int shift = d->format[SEPAX_F_NORMAL_PRODUCT].shift + d->format[SEPAX_F_NORMAL_PROJECTION].shift;
  int64_t distance = (int64_t)d->config.epsilon << (d->config.word - 1);
  int64_t unit = INT64_C(1) << shift;
  int64_t limit = (distance + unit - 1) >> shift;
  return limit > 1 ? limit : 1;
}

bool sepax__paper_coplanar(const sepax_design *design, const wide p[3], const wide q[3]) {
  for (int k = 0; k < 3; k++) {
    if (wide_magnitude(p[k] - q[k]) >= design->coplanar_limit) {
      return false;
    }
  }
  return true;
}
