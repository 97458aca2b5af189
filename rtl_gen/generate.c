/* SPDX-License-Identifier: MIT */
/* generate.c - see generate.h. */
#include "generate.h"

#include "conference/conference.h"
#include "emit/prefix.h"
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

bool sepax_generate(sepax_design *design, const char *folder, const sepax_output *how,
                    sepax_error *error) {
  if (!generate_check(&design->config, error)) {
    return false;
  }
  const char *prefix = how->prefix != NULL ? how->prefix : PREFIX_STANDARD;
  if (!prefix_check(prefix, error)) {
    return false;
  }
  const bool own = strcmp(prefix, PREFIX_STANDARD) != 0;
  char command[SEPAX_CONFIG_TEXT + 96];
  char text[SEPAX_CONFIG_TEXT];
  char vectors[32] = "";
  if (how->vectors != 0) {
    snprintf(vectors, sizeof vectors, " --vectors=%d", how->vectors > 0 ? how->vectors : 0);
  }
  snprintf(command, sizeof command, "sepax gen %s%s%s%s%s",
           sepax_config_text(&design->config, text, sizeof text), own ? " --prefix=" : "",
           own ? prefix : "", how->absolute ? " --absolute" : "", vectors);
  emitter e;
  emit_init(&e, design, command);
  e.prefix = prefix;
  bool ok = generators[design->config.arch](&e);
  if (!ok) {
    *error = e.error;
  }
  if (ok) {
    emit_drop_unused(&e);
  }
  ok = ok && gen_write(&e, folder, how, error);
  emit_free(&e);
  return ok;
}
