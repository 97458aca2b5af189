/* SPDX-License-Identifier: MIT */
/* gen.c - sepax gen: configuration -> Verilog folder. */
#include "bench/bench.h"
#include "cli/cli.h"
#include "command_table.h"
#include "commands/estimates.h"
#include "generate.h"

#include <stdio.h>

typedef struct {
  sepax_config config;
  const char *folder;
  sepax_output how;
  bool estimate, json;
} gen_options;

enum {
  OPTION_PREFIX = 0x400,
  OPTION_ABSOLUTE,
  OPTION_SINGLE,
  OPTION_VECTORS,
  OPTION_ESTIMATE,
  OPTION_JSON
};

static const struct argp_option options[] = {
    {"output", 'o', "DIR", 0, "folder for the Verilog; it is made if missing", 0},
    {"prefix", OPTION_PREFIX, "NAME", 0,
     "first part of the names of modules, files and macros: NAME_top, NAME_REGISTERS_H (default "
     "sepax). Several designs with prefixes of their own fit into one project",
     0},
    {"absolute", OPTION_ABSOLUTE, NULL, 0,
     "write also NAME_absolute.f, the list of the modules' files with absolute paths", 0},
    {"estimate", OPTION_ESTIMATE, NULL, 0,
     "write nothing, but print latency, pairs a second, and an estimate of gates, flip-flops and "
     "energy with the error of each",
     0},
    {"json", OPTION_JSON, NULL, 0, "print the estimate as JSON (needs --estimate)", 0},
    {"single-file", OPTION_SINGLE, NULL, 0,
     "write all modules into one file, that of the top module", 0},
    {"vectors", OPTION_VECTORS, "N", 0,
     "pairs in the test bench tb/NAME_tb.v, 0 ... 100000 (default 256; 0: no test bench)", 0},
    {0}};

static void check(const gen_options *o, const struct argp_state *state) {
  const sepax_output *how = &o->how;
  bool written = o->folder != NULL || how->prefix != NULL || how->absolute || how->single_file ||
                 how->vectors != 0;
  if (o->estimate && written) {
    argp_error(state, "--estimate writes no Verilog; leave -o, --prefix, --absolute, "
                      "--single-file and --vectors out");
  }
  if (o->json && !o->estimate) {
    argp_error(state, "--json needs --estimate");
  }
  if (!o->estimate && o->folder == NULL) {
    argp_error(state, "give the folder for the Verilog with -o DIR");
  }
}

static error_t parse(int key, char *text, struct argp_state *state) {
  gen_options *o = state->input;
  switch (key) {
  case ARGP_KEY_INIT:
    state->child_inputs[0] = &o->config;
    return 0;
  case 'o':
    o->folder = text;
    return 0;
  case OPTION_PREFIX:
    o->how.prefix = text;
    return 0;
  case OPTION_ABSOLUTE:
    o->how.absolute = true;
    return 0;
  case OPTION_ESTIMATE:
    o->estimate = true;
    return 0;
  case OPTION_JSON:
    o->json = true;
    return 0;
  case OPTION_SINGLE:
    o->how.single_file = true;
    return 0;
  case OPTION_VECTORS: {
    const uint64_t vectors = cli_count(state, "vectors", text, 0, BENCH_VECTORS_MOST);
    o->how.vectors = vectors > 0 ? (int)vectors : -1;
    return 0;
  }
  case ARGP_KEY_ARG:
    argp_error(state, "unexpected argument '%s'", text);
    return 0;
  case ARGP_KEY_END:
    check(o, state);
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

int cli_gen(int argc, char **argv) {
  static const struct argp_child children[] = {{&cli_config_argp, 0, NULL, 0}, {0}};
  static const struct argp argp = {
      options,
      parse,
      NULL,
      "Generate the Verilog of a design. The output folder receives one file for each module, and "
      "these files: sepax.f (list of the modules' files); sepax_params.h, sepax_params.vh and "
      "sepax.json (parameters for test benches); sepax.sdc (clock constraints), and sepax.xdc if "
      "the target is a Xilinx FPGA; sepax.gtkw (ports for GTKWave). A design with an engine "
      "also has sepax_registers.h, .md and .rdl (--lanes) or sepax_tree_registers.h, .md and .rdl "
      "(--tree), which describe the registers of the engine. "
      "tb/sepax_tb.v is a test bench for any simulator. doc/sepax.html and .md are a datasheet. "
      "ip/ has a VHDL package, SystemVerilog interfaces, IP-XACT and SVD.",
      children,
      NULL,
      NULL};
  gen_options o = {.config = sepax_config_default()};
  cli_parse(&argp, argc, argv, &o);
  sepax_error error = {0};
  sepax_design design;
  if (sepax_design_init(&design, &o.config, &error) && o.estimate) {
    sepax_estimate estimate;
    if (sepax_estimate_design(&design, &estimate, &error)) {
      (o.json ? estimate_print_json : estimate_print)(&design, &estimate);
      return EXIT_SUCCESS;
    }
  }
  if (error.code != SEPAX_OK || !sepax_generate(&design, o.folder, &o.how, &error)) {
    return cli_fail("sepax gen", &error);
  }
  char text[SEPAX_CONFIG_TEXT];
  printf("%s: %s, latency %d, II %d\n", o.folder, sepax_config_text(&o.config, text, sizeof text),
         design.latency, o.config.ii);
  return 0;
}
