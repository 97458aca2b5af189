/* SPDX-License-Identifier: MIT */
/* engines.c - finds the engine of a design in the table of engines. */
#include "design/engine_table.h"
#include "design/options.h"
#include "util/error.h"

static const engine_row none = {.name = NULL};

#define ROW(value, name) [SEPAX_ENGINE_##value] = &sepax__engine_##name,
static const engine_row *const engines[SEPAX_ENGINE_COUNT] = {[SEPAX_ENGINE_NONE] = &none,
                                                              SEPAX_ENGINES(ROW)};

const char *sepax__engine_name(sepax_engine which) {
#define NAME(value, name) [SEPAX_ENGINE_##value] = #name,
  static const char *const names[SEPAX_ENGINE_COUNT] = {[SEPAX_ENGINE_NONE] = "none",
                                                        SEPAX_ENGINES(NAME)};
  return names[which];
}

/* The first engine after `before` in the table that the options ask for. */
static sepax_engine next_asked(const sepax_config *config, sepax_engine before) {
  for (int n = (int)before + 1; n < SEPAX_ENGINE_COUNT; n++) {
    if (sepax__design_option_given(engines[n]->option, config)) {
      return (sepax_engine)n;
    }
  }
  return SEPAX_ENGINE_NONE;
}

sepax_engine sepax__config_engine(const sepax_config *config) {
  return next_asked(config, SEPAX_ENGINE_NONE);
}

const engine_row *sepax__engine_of(const sepax_config *config) {
  return engines[sepax__config_engine(config)];
}

bool sepax__engine_check(const sepax_config *config, sepax_error *error) {
  sepax_engine asked = sepax__config_engine(config);
  sepax_engine other = asked != SEPAX_ENGINE_NONE ? next_asked(config, asked) : SEPAX_ENGINE_NONE;
  if (other != SEPAX_ENGINE_NONE) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "%s: a design has %s or %s, not both; leave --%s or --%s out",
                      engines[asked]->option, engines[asked]->name, engines[other]->name,
                      engines[asked]->option, engines[other]->option);
  }
  return engines[asked]->check == NULL || engines[asked]->check(config, error);
}
