/* SPDX-License-Identifier: MIT */
/* paper.c - architectures paper and conference: their checks and the fixed-point formats that
 * follow by interval analysis (docs/reference/paper.md). Both have the same options and formats. */
#include "design/architecture.h"
#include "design/interval.h"
#include "design/paper.h"
#include "util/error.h"

static bool check(const sepax_config *config, sepax_error *error) {
  if (config->ii != 3) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "ii: architecture %s takes a pair in three input cycles; "
                      "give --ii=3, not %d",
                      sepax_arch_name(config->arch), config->ii);
  }
  if (config->guard > 2 * config->word + 3) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "precision: guard = %d is out of range; give 0 ... %d at "
                      "W = %d, or full",
                      config->guard, 2 * config->word + 3, config->word);
  }
  if (config->guard < 0 && config->block_float) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "block-float: nothing is truncated at --precision=full; "
                      "give --precision=word or guard=BITS");
  }
  return sepax__paper_epsilon_check(config, error);
}

/* Enter a format that keeps at most `keep` of the bits that `range` needs. Returns the range after
 * the other bits are dropped. */
static interval enter(sepax_design *design, sepax_format_id id, const char *name, interval range,
                      int keep) {
  int exact = bits_of(range);
  int shift = exact > keep ? exact - keep : 0;
  design->format[id] = (sepax_format){name, exact, exact - shift, shift, 0};
  design->formats = (int)id + 1;
  return (interval){range.lo >> shift, range.hi >> shift};
}

static void derive_formats(sepax_design *d) {
  enum { EVERY_BIT = 127 };
  const sepax_config *c = &d->config;
  int keep = c->guard < 0 ? EVERY_BIT : c->word + c->guard;
  int keep_axis_terms = c->block_float ? EVERY_BIT : keep;

  interval word = signed_word(c->word);
  interval vertex = enter(d, SEPAX_F_VERTEX, "vertex", word, keep);
  interval normal = enter(d, SEPAX_F_NORMAL, "normal", word, keep);
  interval np = enter(d, SEPAX_F_NORMAL_PRODUCT, "normal_product", product(vertex, normal), keep);
  enter(d, SEPAX_F_NORMAL_PROJECTION, "normal_projection", sum_of_three(np), keep);

  interval edge = enter(d, SEPAX_F_EDGE, "edge", difference(vertex, vertex), keep_axis_terms);
  interval cp =
      enter(d, SEPAX_F_CROSS_PRODUCT, "cross_product", product(edge, edge), keep_axis_terms);
  interval axis = enter(d, SEPAX_F_AXIS, "axis", difference(cp, cp), keep);
  if (c->block_float) {
    axis = signed_word(d->format[SEPAX_F_AXIS].width);
  }
  interval p = enter(d, SEPAX_F_PRODUCT, "product", product(vertex, axis), keep);
  enter(d, SEPAX_F_PROJECTION, "projection", sum_of_three(p), keep);
}

static void derive_paper(sepax_design *design) {
  derive_formats(design);
  design->coplanar_limit = sepax__paper_coplanar_limit(design);
  design->latency = sepax__paper_latency();
}

static void derive_conference(sepax_design *design) {
  derive_paper(design);
  design->latency = sepax__conference_latency();
}

const architecture sepax__architecture_paper = {"paper", sepax_paper, check, derive_paper};
const architecture sepax__architecture_conference = {"conference", sepax_conference, check,
                                                     derive_conference};
