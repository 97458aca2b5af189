/* SPDX-License-Identifier: MIT */
/* exact.c - architecture exact: its checks and the formats of its numbers
 * (docs/reference/exact.md). */
#include "design/architecture.h"
#include "design/engine_table.h"
#include "design/interval.h"
#include "util/error.h"

/* If the gap of two AABBs is above this number, then the pair is outside the clearance. */
static int64_t margin_of(const sepax_config *config, int clearance) {
  const engine_row *around = sepax__engine_of(config);
  bool more = around->margin_added != NULL && clearance >= 0;
  return 1 + (int64_t)clearance + (more ? around->margin_added(config->word) : 0);
}

int64_t sepax__outer_margin(const sepax_config *config) {
  return margin_of(config, config->warning > 0 ? config->warning : config->clearance);
}

static int core_word(const sepax_config *config) {
  bool any = config->extent_a == 0 && config->extent_b == 0;
  return any ? config->word
             : bits_behind_aabb_test(config->extent_a, config->extent_b,
                                     sepax__outer_margin(config));
}

static bool check_clearance(const sepax_config *config, sepax_error *error) {
  int most = sepax_word_max(config->word);
  if (config->clearance > most) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "clearance: %d LSB is out of range; give 0 ... %d", config->clearance, most);
  }
  if (config->warning != 0 && (config->warning <= config->clearance || config->warning > most)) {
    return sepax_fail(
        error, SEPAX_ERROR_ARGUMENT,
        "warning: %d LSB is out of range; give more than the clearance of %d, and at most %d",
        config->warning, config->clearance, most);
  }
  if (config->clearance >= 0 && config->flag) {
    return sepax_fail(
        error, SEPAX_ERROR_ARGUMENT,
        "coplanar: flag saves nothing with a clearance, because coplanar pairs then need no "
        "second pass; leave it out");
  }
  return true;
}

static bool check_extents(const sepax_config *config, sepax_error *error) {
  int64_t most = (INT64_C(1) << config->word) - 1;
  if (config->extent_a == 0) {
    return true;
  }
  if (config->extent_a > most || config->extent_b > most) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "extent: %d and %d LSB are out of range; give 1 ... %lld for both",
                      config->extent_a, config->extent_b, (long long)most);
  }
  return core_word(config) < config->word ||
         sepax_fail(
             error, SEPAX_ERROR_ARGUMENT,
             "extent: with these extents the core needs %d bits, which is not less than W, so "
             "they save nothing; leave them out",
             core_word(config));
}

/* Refuse options for what the engine already has. */
static bool check_around(const sepax_config *config, sepax_error *error) {
  const engine_row *around = sepax__engine_of(config);
  if (config->early_out && (config->extent_a != 0 || around->tests_aabbs)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "early-out: with %s AABBs are tested before the core anyway; leave it out",
                      around->tests_aabbs ? around->name : "extents");
  }
  bool fpga = config->target != SEPAX_TARGET_ASIC;
  if (config->registered_ready && (around->name != NULL || fpga)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "registered-ready: %s has registers there anyway; leave it out",
                      around->name != NULL ? around->name : "a core for an FPGA");
  }
  return true;
}

static bool check(const sepax_config *config, sepax_error *error) {
  if (!sepax__engine_check(config, error) || !check_clearance(config, error) ||
      !check_extents(config, error) || !check_around(config, error)) {
    return false;
  }
  if (config->corner == SEPAX_CORNER_SLOW && config->target != SEPAX_TARGET_ASIC) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "corner: the delays of an FPGA are known for one corner only; leave it out");
  }
  return !config->clock_gating || config->target == SEPAX_TARGET_ASIC ||
         sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                    "clock-gating: an FPGA has no clock gates; leave it out");
}

/* Enter a format. All bits that distinguish results are kept. */
static void enter(sepax_design *design, int id, const char *name, interval terms, interval result) {
  design->exact_format[id] = (sepax_format){name, bits_of(terms), bits_of(result), 0, 0};
  design->formats = id + 1;
}

/* Enter a format for the recoded factor of a product that is made of gates. The recoded multiplier
 * computes a (b - K) with K = 1 + 4 + 16 + ..., so K is added to the factor. */
static void enter_digits(sepax_design *design, int id, const char *name, interval value) {
  if (design->config.target != SEPAX_TARGET_ASIC) {
    enter(design, id, name, value, value);
    return;
  }
  int digits = (bits_of(value) + 1) / 2;
  wide bias = (((wide)1 << (2 * (digits - 1))) - 1) / 3;
  interval sum = {value.lo + bias, value.hi + bias};
  enter(design, id, name, sum, sum);
  design->exact_format[id].digits = digits;
}

/* The number that twice the gap must exceed, on an axis with components up to the given size. */
static interval limit_of(const sepax_config *c, int components, wide longest) {
  wide outer = sepax__outer_margin(c) - 1;
  return (interval){0, ((outer + 2) * components + outer) * longest};
}

/* With a clearance: each component of e x f is at most twice the square of a side. */
static void derive_limits(sepax_design *d, wide side) {
  const sepax_config *c = &d->config;
  if (c->clearance < 0) {
    return;
  }
  interval cross = {-2 * side * side, 2 * side * side};
  interval limit = limit_of(c, 3, 2 * side * side);
  interval edge_limit = limit_of(c, 2, side);
  enter(d, SEPAX_X_CROSS, "cross", cross, cross);
  enter(d, SEPAX_X_LIMIT, "limit", limit, limit);
  enter(d, SEPAX_X_EDGE_LIMIT, "edge_limit", edge_limit, edge_limit);
}

/* `exact` bits hold every term, and `width` bits hold the result, because sums are taken modulo
 * 2^width and terms cancel. Twice the area of a triangle in a square of side L is at most L^2. Six
 * times the volume of a tetrahedron in a cube of side L is at most 2 L^3. */
static void derive_formats(sepax_design *d) {
  interval word = signed_word(d->core_word);
  interval span = interval_hull(difference(word, word), (interval){2 * word.lo, 2 * word.hi});
  interval z_sum = {2 * (word.lo - word.hi), 2 * (word.hi - word.lo)};
  interval own_z_sum = {3 * (word.lo - word.hi), 3 * (word.hi - word.lo)};
  wide side = word.hi - word.lo;
  interval orient2d = {-side * side, side * side};
  interval orient3d = {-2 * side * side * side, 2 * side * side * side};
  enter(d, SEPAX_X_COORDINATE, "coordinate", word, word);
  enter(d, SEPAX_X_SPAN, "span", span, span);
  if (d->config.target == SEPAX_TARGET_ASIC) {
    d->exact_format[SEPAX_X_SPAN].digits = (bits_of(span) + 1) / 2;
  }
  enter(d, SEPAX_X_ORIENT2D, "orient2d", sum_of_three(product(span, span)), orient2d);
  enter_digits(d, SEPAX_X_Z_SUM, "z_sum", z_sum);
  enter_digits(d, SEPAX_X_OWN_Z_SUM, "own_z_sum", own_z_sum);
  enter(d, SEPAX_X_ORIENT3D, "orient3d", product(orient2d, own_z_sum), orient3d);
  enter_digits(d, SEPAX_X_STEP, "step", difference(word, word));
  derive_limits(d, side);
}

static void derive(sepax_design *design) {
  const sepax_config *config = &design->config;
  design->aabb_test = config->early_out || config->extent_a > 0;
  design->core_word = core_word(config);
  design->limits = config->clearance < 0 ? 0 : config->warning > 0 ? 2 : 1;
  design->margin[0] = margin_of(config, config->clearance);
  design->margin[1] = sepax__outer_margin(config);
  derive_formats(design);
}

const architecture sepax__architecture_exact = {"exact", sepax__judge_exact, check, derive};
