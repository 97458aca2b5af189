/* SPDX-License-Identifier: MIT */
/* multiplier.c - sepax multiplier: one of the generated multipliers by itself. */
#include "arith/arith.h"
#include "cli/cli.h"
#include "command_table.h"
#include "files/output.h"
#include "util/error.h"

#include <stdio.h>
#include <stdlib.h>

typedef struct {
  uint64_t a, b, product, digits, less; /* 0: not given */
  double period;
  sepax_config config; /* only its target is read */
  const char *target;  /* --target as the user wrote it */
  const char *folder;
} multiplier_options;

enum { LEAST = 3, MOST = 80, KEY_CLOCK = 0x500, KEY_DIGITS, KEY_LESS, KEY_TARGET };

static const struct argp_option options[] = {
    {"a", 'a', "BITS", 0, "bits of the first factor, 3 ... 80", 0},
    {"b", 'b', "BITS", 0,
     "bits of the second factor, which is recoded into radix-4 digits; at most --a", 0},
    {"product", 'p', "BITS", 0,
     "number of lowest bits of the product to keep, at most 128 (default: all)", 0},
    {"digits", KEY_DIGITS, "COUNT", 0,
     "cut b into COUNT radix-4 digits and compute a (b - K) instead of a b, which saves an "
     "addition. K = 1 + 4 + ... + 4^(COUNT - 2). The highest digit, floor(b / 4^(COUNT - 1)), must "
     "be in -2 ... 2",
     0},
    {"less", KEY_LESS, "1|2", 0,
     "1 or 2: the factor by which K of --digits is multiplied (default 1; needs --digits)", 0},
    {"clock-ns", KEY_CLOCK, "PERIOD", 0,
     "clock period in ns for which pipeline registers are placed (default: no registers)", 0},
    {"target", KEY_TARGET, "TARGET", 0, "technology: asic (default), ice40, ecp5, xc7, xcup, gowin",
     0},
    {"output", 'o', "DIR", 0, "folder for the Verilog; it is made if missing", 0},
    {0}};

static error_t parse(int key, char *text, struct argp_state *state) {
  multiplier_options *o = state->input;
  switch (key) {
  case 'a':
    o->a = cli_count(state, "a", text, LEAST, MOST);
    return 0;
  case 'b':
    o->b = cli_count(state, "b", text, LEAST, MOST);
    return 0;
  case 'p':
    o->product = cli_count(state, "product", text, LEAST + 1, ARITH_WIDTH);
    return 0;
  case KEY_DIGITS:
    o->digits = cli_count(state, "digits", text, 1, MOST / 2);
    return 0;
  case KEY_LESS:
    o->less = cli_count(state, "less", text, 1, 2);
    return 0;
  case KEY_CLOCK:
    o->period = cli_number(state, "clock-ns", text);
    return 0;
  case KEY_TARGET: {
    sepax_error error = {0};
    if (!sepax_config_set(&o->config, "target", text, &error)) {
      argp_error(state, "%s", error.text);
    }
    o->target = text;
    return 0;
  }
  case 'o':
    o->folder = text;
    return 0;
  case ARGP_KEY_ARG:
    argp_error(state, "unexpected argument '%s'", text);
    return 0;
  case ARGP_KEY_END:
    if (o->a == 0 || o->b == 0) {
      argp_error(state, "give the bits of both factors with -a BITS -b BITS");
    }
    if (o->folder == NULL) {
      argp_error(state, "give the folder for the Verilog with -o DIR");
    }
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

static arith_form form_of(const multiplier_options *o) {
  return (arith_form){.delay = delay_model_of(o->config.target),
                      .a_w = (int)o->a,
                      .b_w = (int)o->b,
                      .p_w = (int)o->product,
                      .digits = (int)o->digits,
                      .less = o->less != 0 ? (int)o->less : 1};
}

static bool check(const multiplier_options *o, sepax_error *error) {
  if (o->a < LEAST || o->b < LEAST || o->b > o->a) {
    return sepax_fail(
        error, SEPAX_ERROR_ARGUMENT,
        "factors of %d and %d bits are out of range; give 3 ... 80, and -b at most -a", (int)o->a,
        (int)o->b);
  }
  if (o->product <= o->a || o->product > o->a + o->b || o->product > ARITH_WIDTH) {
    return sepax_fail(
        error, SEPAX_ERROR_ARGUMENT,
        "product: %d bits is out of range; give more than -a, and at most -a plus -b and %d",
        (int)o->product, ARITH_WIDTH);
  }
  if (o->digits != 0 && (o->b + 1 < 2 * o->digits || o->b + 1 > 2 * o->digits + 2)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "digits: %d is out of range for -b %d; give %d ... %d", (int)o->digits,
                      (int)o->b, (int)o->b / 2, ((int)o->b + 1) / 2);
  }
  if (o->less != 0 && o->digits == 0) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "less: applies only to --digits; give --digits, too");
  }
  bool asic = o->config.target == SEPAX_TARGET_ASIC;
  if (!asic && (o->digits != 0 || o->period != 0)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "%s: applies only to an ASIC; leave out the option, or --target",
                      o->digits != 0 ? "digits" : "clock-ns");
  }
  if (o->period != 0 && !(o->period >= 0.5 && o->period <= 1000)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "clock-ns: %g is out of range; give 0.5 ... 1000", o->period);
  }
  arith_form form = form_of(o);
  if (o->period != 0 && o->period < arith_shortest(&form)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "clock-ns: %g is too short for %dx%d; give %.2f or more", o->period,
                      (int)o->a, (int)o->b, arith_shortest(&form) + 0.005);
  }
  return true;
}

static bool generate(const multiplier_options *o, sepax_error *error) {
  char command[200];
  arith_form form = form_of(o);
  int used = snprintf(command, sizeof command, "sepax multiplier --a=%d --b=%d --product=%d",
                      (int)o->a, (int)o->b, (int)o->product);
  if (o->digits > 0) {
    used += snprintf(command + used, sizeof command - (size_t)used, " --digits=%d --less=%d",
                     (int)o->digits, form.less);
  }
  if (o->period > 0) {
    snprintf(command + used, sizeof command - (size_t)used, " --clock-ns=%g", o->period);
  }
  if (o->target != NULL) {
    snprintf(command + used, sizeof command - (size_t)used, " --target=%s", o->target);
  }
  arith_plan *plan = malloc(sizeof *plan);
  if (plan == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for a multiplier");
  }
  arith_plan_make(plan, &form, o->period > 0 ? o->period : 1e9);
  emitter e;
  emit_init(&e, NULL, command);
  if (o->config.target == SEPAX_TARGET_ASIC) {
    gen_multiplier_parts(&e, o->less == 2);
  } else {
    gen_dsp(&e, form.delay);
  }
  gen_multiplier(&e, plan);
  bool ok = emit_works(&e);
  if (!ok) {
    *error = e.error;
  }
  ok = ok && gen_write(&e, o->folder, &(sepax_output){NULL}, NULL, error);
  if (ok) {
    printf("%s: %s, product modulo 2^%d, latency %d\n", o->folder, arith_name(plan).text,
           (int)o->product, plan->latency);
  }
  emit_free(&e);
  free(plan);
  return ok;
}

int cli_multiplier(int argc, char **argv) {
  static const struct argp argp = {
      options,
      parse,
      NULL,
      "Generate the Verilog of one signed multiplier, as in designs of architecture exact: radix-4 "
      "digits -1 ... 2 select rows, full adders reduce the columns, and one addition gives the "
      "product. For an FPGA, the factors are cut into parts for its own multipliers.",
      NULL,
      NULL,
      NULL};
  multiplier_options o = {.config = sepax_config_default()};
  cli_parse(&argp, argc, argv, &o);
  sepax_error error = {0};
  o.product = o.product == 0 ? o.a + o.b : o.product;
  if (!check(&o, &error) || !generate(&o, &error)) {
    return cli_fail("sepax multiplier", &error);
  }
  return 0;
}
