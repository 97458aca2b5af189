/* SPDX-License-Identifier: MIT */
/* generate.c - see generate.h. */
#include "generate.h"

#include "conference/conference.h"
#include "exact/exact.h"
#include "files/output.h"
#include "paper/paper.h"
#include "util/error.h"

#include <stdio.h>

/* The generator of each architecture with hardware. */
static bool (*const generators[SEPAX_ARCH_COUNT])(emitter *e) = {
    [SEPAX_ARCH_EXACT] = gen_exact,
    [SEPAX_ARCH_PAPER] = gen_paper,
    [SEPAX_ARCH_CONFERENCE] = gen_conference,
};

bool sepax_generate(sepax_design *design, const char *folder, sepax_error *error) {
  if (generators[design->config.arch] == NULL) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "arch: '%s' has no hardware; give --arch=exact, paper or conference",
                      sepax_arch_name(design->config.arch));
  }
  char command[SEPAX_CONFIG_TEXT + 16];
  char text[SEPAX_CONFIG_TEXT];
  snprintf(command, sizeof command, "sepax gen %s",
           sepax_config_text(&design->config, text, sizeof text));
  emitter e;
  emit_init(&e, design, command);
  bool ok = generators[design->config.arch](&e);
  if (!ok) {
    *error = e.error;
  }
  ok = ok && gen_write(&e, folder, error);
  emit_free(&e);
  return ok;
}
