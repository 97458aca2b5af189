/* SPDX-License-Identifier: MIT */
/* architectures.c - the list of architectures. A design is checked and derived by the row of its
 * architecture. */
#include "design/architecture.h"
#include "design/options.h"

static const architecture reference = {.name = "reference", .judge = sepax__judge_reference};
static const architecture float32 = {.name = "float32", .judge = sepax__judge_float32};
static const architecture float64 = {.name = "float64", .judge = sepax__judge_float64};
static const architecture interval32 = {.name = "interval32", .judge = sepax__judge_interval32};
static const architecture interval64 = {.name = "interval64", .judge = sepax__judge_interval64};
static const architecture guigue32 = {.name = "guigue32", .judge = sepax__judge_guigue32};
static const architecture guigue64 = {.name = "guigue64", .judge = sepax__judge_guigue64};
static const architecture filtered = {.name = "filtered", .judge = sepax__judge_filtered};

const architecture *const sepax__architectures[SEPAX_ARCH_COUNT] = {
    [SEPAX_ARCH_EXACT] = &sepax__architecture_exact,
    [SEPAX_ARCH_PAPER] = &sepax__architecture_paper,
    [SEPAX_ARCH_CONFERENCE] = &sepax__architecture_conference,
    [SEPAX_ARCH_REFERENCE] = &reference,
    [SEPAX_ARCH_FLOAT32] = &float32,
    [SEPAX_ARCH_FLOAT64] = &float64,
    [SEPAX_ARCH_INTERVAL32] = &interval32,
    [SEPAX_ARCH_INTERVAL64] = &interval64,
    [SEPAX_ARCH_GUIGUE32] = &guigue32,
    [SEPAX_ARCH_GUIGUE64] = &guigue64,
    [SEPAX_ARCH_FILTERED] = &filtered,
};

const char *sepax_arch_name(sepax_arch arch) { return sepax__architectures[arch]->name; }

bool sepax_config_check(const sepax_config *config, sepax_error *error) {
  if (!sepax__design_options_check(config, error)) {
    return false;
  }
  const architecture *arch = sepax__architectures[config->arch];
  return arch->check == NULL || arch->check(config, error);
}

bool sepax_design_init(sepax_design *design, const sepax_config *config, sepax_error *error) {
  if (!sepax_config_check(config, error)) {
    return false;
  }
  *design = (sepax_design){.config = *config};
  if (sepax__architectures[config->arch]->derive != NULL) {
    sepax__architectures[config->arch]->derive(design);
  }
  return true;
}
