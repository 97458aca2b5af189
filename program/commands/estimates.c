/* SPDX-License-Identifier: MIT */
/* estimates.c - see estimates.h. */
#include "commands/estimates.h"

#include "report/json.h"

#include <math.h>
#include <stdio.h>

enum { WIDTH = 12 };

static const char *const workloads[ESTIMATE_PAIRS] = {"separated", "colliding", "coplanar"};

static void print_known(const sepax_estimate *e) {
  printf("%-*s%.1fK +- %.1fK GE (formula for Nangate45, typical)\n", WIDTH, "gates",
         e->gates / 1000, e->gates_error / 1000);
  printf("%-*s%.0f +- %.0f\n", WIDTH, "flip-flops", e->flip_flops, e->flip_flops_error);
  for (int i = 0; i < ESTIMATE_PAIRS && e->energy_known; i++) {
    printf("%-*s%.3f +- %.3f nJ a pair that is %s\n", WIDTH, i == 0 ? "energy" : "", e->energy[i],
           e->energy_error[i], workloads[i]);
  }
}

static const char *why_unknown(const sepax_config *c) {
  return c->arch != SEPAX_ARCH_EXACT ? "has no formula for this architecture"
                                     : "has no formula for FPGAs; synth/fpga/map counts cells";
}

void estimate_print(const sepax_design *design, const sepax_estimate *e) {
  const sepax_config *c = &design->config;
  char text[SEPAX_CONFIG_TEXT];
  printf("%-*s%s\n", WIDTH, "design", sepax_config_text(c, text, sizeof text));
  printf("%-*s%d cycles of %g ns: %.4g ns\n", WIDTH, "latency", e->latency, c->clock_ps / 1000.0,
         e->latency * (c->clock_ps / 1000.0));
  printf("%-*s%.4g M a second\n", WIDTH, "pairs", e->pairs / 1e6);
  if (e->compared > 0) {
    printf("%-*s%.4g M pairs of AABBs a second\n", WIDTH, "compared", e->compared / 1e6);
  }
  if (e->memory_bits > 0) {
    printf("%-*s%.4g kbit, not in the gates\n", WIDTH, "memories", (double)e->memory_bits / 1000);
  }
  if (e->gates_known) {
    print_known(e);
  } else {
    printf("%-*snot known: sepax %s\n", WIDTH, "gates", why_unknown(c));
  }
}

/* What JSON has of each energy. */
static void set_energies(json_t *all, const sepax_estimate *e) {
  json_t *energies = json_object();
  for (int i = 0; i < ESTIMATE_PAIRS && e->energy_known; i++) {
    json_object_set_new(
        energies, workloads[i],
        json_pack("{s:f, s:f}", "nj", e->energy[i], "error_nj", e->energy_error[i]));
  }
  if (e->energy_known) {
    json_object_set(all, "energy", energies);
  }
  json_decref(energies);
}

static void set_terms(json_t *all, const sepax_estimate *e) {
  json_t *terms = json_object();
  for (int i = 0; sepax_estimate_term(i) != NULL; i++) {
    json_object_set_new(terms, sepax_estimate_term(i), json_real(e->term[i]));
  }
  json_object_set_new(all, "terms", terms);
}

json_t *estimate_json(const sepax_design *design, const sepax_estimate *e) {
  const sepax_config *c = &design->config;
  char text[SEPAX_CONFIG_TEXT];
  json_t *all = json_pack(
      "{s:s, s:i, s:f, s:f, s:f, s:I}", "options", sepax_config_text(c, text, sizeof text),
      "latency", e->latency, "latency_ns", e->latency * (c->clock_ps / 1000.0), "pairs_per_second",
      e->pairs, "compared_per_second", e->compared, "memory_bits", (json_int_t)e->memory_bits);
  if (e->gates_known) {
    json_object_set_new(all, "ge", json_real(e->gates));
    json_object_set_new(all, "ge_error", json_real(e->gates_error));
    json_object_set_new(all, "flip_flops", json_integer(llrint(e->flip_flops)));
    json_object_set_new(all, "flip_flops_error", json_integer(llrint(e->flip_flops_error)));
    set_energies(all, e);
    set_terms(all, e);
  }
  return all;
}

void estimate_print_json(const sepax_design *design, const sepax_estimate *e) {
  report_print_json(estimate_json(design, e));
}
