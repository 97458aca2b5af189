/* SPDX-License-Identifier: MIT */
/* judge.c - the verdict of a design: the model of its architecture, after the AABB test if the
 * design has one. */
#include "design/architecture.h"
#include "util/aabb.h"

static bool exceeds_extents(const sepax_config *c, const aabb *a, const aabb *b) {
  return c->extent_a > 0 &&
         (aabb_longest_side(a) > c->extent_a || aabb_longest_side(b) > c->extent_b);
}

sepax_judgement sepax__judge_exact(const sepax_design *design, const sepax_pair *pair) {
  if (design->aabb_test) {
    aabb a = aabb_of(&pair->a);
    aabb b = aabb_of(&pair->b);
    if (aabb_disjoint(&a, &b, design->margin[1])) {
      return (sepax_judgement){.axis = SEPAX_AXIS_AABB, .band = SEPAX_BAND_FREE};
    }
    if (exceeds_extents(&design->config, &a, &b)) {
      return (sepax_judgement){.collision = true,
                               .axis = SEPAX_AXIS_EXTENT,
                               .band = design->limits > 0 ? SEPAX_BAND_COLLISION : SEPAX_BAND_FREE};
    }
  }
  if (design->limits > 0) {
    return sepax_clearance(design, &pair->a, &pair->b);
  }
  sepax_verdict verdict = sepax_exact(&pair->a, &pair->b);
  if (verdict.coplanar && design->config.flag) {
    return (sepax_judgement){.collision = true, .coplanar = true};
  }
  return (sepax_judgement){.collision = verdict.collision,
                           .strict = verdict.strict,
                           .coplanar = verdict.coplanar,
                           .axis = verdict.axis};
}

#define SOFTWARE(name)                                                                      \
  sepax_judgement sepax__judge_##name(const sepax_design *design, const sepax_pair *pair) { \
    (void)design;                                                                           \
    return (sepax_judgement){.collision = sepax_##name(&pair->a, &pair->b)};                \
  }
SOFTWARE(reference)
SOFTWARE(float32)
SOFTWARE(float64)
SOFTWARE(interval32)
SOFTWARE(interval64)
SOFTWARE(guigue32)
SOFTWARE(guigue64)

sepax_judgement sepax__judge_filtered(const sepax_design *design, const sepax_pair *pair) {
  (void)design;
  return (sepax_judgement){.collision = sepax_filtered(&pair->a, &pair->b, NULL)};
}

sepax_judgement sepax_judge(const sepax_design *design, const sepax_pair *pair) {
  return sepax__architectures[design->config.arch]->judge(design, pair);
}
