/* SPDX-License-Identifier: MIT */
/* generate.c - see generate.h. */
#include "generate.h"

#include "conference/conference.h"
#include "emit/prefix.h"
#include "estimate.h"
#include "exact/exact.h"
#include "files/output.h"
#include "paper/paper.h"
#include "util/error.h"

#include <stdio.h>
#include <string.h>

/* The generator of each architecture with hardware. */
static bool (*const generators[SEPAX_ARCH_COUNT])(emitter *e) = {
    [SEPAX_ARCH_EXACT] = gen_exact,
    [SEPAX_ARCH_PAPER] = gen_paper,
    [SEPAX_ARCH_CONFERENCE] = gen_conference,
};

bool generate_check(const sepax_config *config, sepax_error *error) {
  return generators[config->arch] != NULL ||
         sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                    "arch: '%s' has no hardware; give --arch=exact, paper or conference",
                    sepax_arch_name(config->arch));
}

enum { COMMAND = SEPAX_CONFIG_TEXT + 128 };

/* The command that makes the same files. */
static const char *command_text(const sepax_design *design, const sepax_output *how,
                                const char *prefix, char command[COMMAND]) {
  char text[SEPAX_CONFIG_TEXT];
  char vectors[32] = "";
  const bool own = strcmp(prefix, PREFIX_STANDARD) != 0;
  if (how->vectors != 0) {
    snprintf(vectors, sizeof vectors, " --vectors=%d", how->vectors > 0 ? how->vectors : 0);
  }
  snprintf(command, COMMAND, "sepax gen %s%s%s%s%s%s",
           sepax_config_text(&design->config, text, sizeof text), own ? " --prefix=" : "",
           own ? prefix : "", how->single_file ? " --single-file" : "",
           how->absolute ? " --absolute" : "", vectors);
  return command;
}

/* What the datasheet says of the cost. */
static bool costs_of(const sepax_design *design, sheet_costs *costs, sepax_error *error) {
  sepax_estimate e;
  if (!sepax_estimate_design(design, &e, error)) {
    return false;
  }
  *costs = (sheet_costs){.pairs = e.pairs,
                         .compared = e.compared,
                         .memory_bits = e.memory_bits,
                         .gates_known = e.gates_known,
                         .gates = e.gates,
                         .gates_error = e.gates_error,
                         .flip_flops = e.flip_flops,
                         .flip_flops_error = e.flip_flops_error,
                         .energy_known = e.energy_known};
  for (int i = 0; i < SHEET_ENERGIES; i++) {
    costs->energy[i] = e.energy[i];
    costs->energy_error[i] = e.energy_error[i];
  }
  return true;
}

bool sepax_generate(sepax_design *design, const char *folder, const sepax_output *how,
                    sepax_error *error) {
  if (!generate_check(&design->config, error)) {
    return false;
  }
  const char *prefix = how->prefix != NULL ? how->prefix : PREFIX_STANDARD;
  if (!prefix_check(prefix, error)) {
    return false;
  }
  char command[COMMAND];
  emitter e;
  emit_init(&e, design, command_text(design, how, prefix, command));
  e.prefix = prefix;
  bool ok = generators[design->config.arch](&e);
  if (!ok) {
    *error = e.error;
  }
  if (ok) {
    emit_drop_unused(&e);
  }
  sheet_costs costs;
  ok = ok && costs_of(design, &costs, error) && gen_write(&e, folder, how, &costs, error);
  emit_free(&e);
  return ok;
}
