/* SPDX-License-Identifier: MIT */
/* engine.c - the table of generators of engines, and what engines share. */
#include "engine/engine.h"

#include <stdio.h>

#define ROW(value, name) [SEPAX_ENGINE_##value] = &generator_##name,
static const engine_generator none = {.generate = NULL};
static const engine_generator *const generators[SEPAX_ENGINE_COUNT] = {[SEPAX_ENGINE_NONE] = &none,
                                                                       SEPAX_ENGINES(ROW)};

const engine_generator *engine_generator_of(const sepax_config *config) {
  return generators[sepax__config_engine(config)];
}

bool engine_registers_ready(const sepax_config *config) {
  return config->registered_ready || config->target != SEPAX_TARGET_ASIC ||
         engine_generator_of(config)->registers_ready;
}

int engine_version(void) {
  int version[3] = {0, 0, 0};
  (void)sscanf(SEPAX_VERSION, "%d.%d.%d", &version[0], &version[1],
               &version[2]); // NOLINT(cert-err34-c)
  return (version[0] << 16) + (version[1] << 8) + version[2];
}

int engine_log2(int number) { return 31 - __builtin_clz(2 * (unsigned)number - 1); }

void engine_cores(emit_holes *h, const sepax_design *design, int pairs, int info) {
  const sepax_config *c = &design->config;
  emit_hole_set(h, "word", "%d", c->word);
  emit_hole_set(h, "limits", "%d", design->limits);
  emit_hole_set(h, "extents", "%d", c->extent_a > 0);
  emit_hole_set(h, "cores", "%d", c->cores);
  emit_hole_set(h, "several", "%d", c->cores > 1);
  emit_hole_set(h, "info", "%d", info);
  emit_hole_set(h, "flight_log2", "%d", engine_log2(pairs * c->cores + 1));
}
