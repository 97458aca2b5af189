/* gen.c - sepax gen: configuration -> Verilog folder. */
#include "cli/cli.h"
#include "commands.h"
#include "util/error.h"
#include "gen.h"
#include "sepax_design.h"

#include <string.h>

typedef struct {
  sepax_config config;
  const char *folder;
} gen_options;

static const struct argp_option options[] = {
    {"output", 'o', "DIR", 0, "folder for the Verilog (made if missing)", 0}, {0}};

static error_t parse(int key, char *text, struct argp_state *state) {
  gen_options *o = state->input;
  switch (key) {
  case ARGP_KEY_INIT:
    state->child_inputs[0] = &o->config;
    return 0;
  case 'o':
    o->folder = text;
    return 0;
  case ARGP_KEY_ARG:
    argp_error(state, "unexpected argument '%s'", text);
    return 0;
  case ARGP_KEY_END:
    if (o->folder == NULL) {
      argp_error(state, "give the folder for the Verilog with -o DIR");
    }
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

static bool generate_exact(emitter *e, sepax_design *design) {
  return gen_exact(e, &design->latency);
}

static bool generate_paper(emitter *e, sepax_design *design) {
  (void)design;
  return gen_paper(e);
}

static bool generate_conference(emitter *e, sepax_design *design) {
  (void)design;
  return gen_conference(e);
}

/* The generator of each architecture with hardware. */
static bool (*const generators[SEPAX_ARCH_COUNT])(emitter *, sepax_design *) = {
    [SEPAX_ARCH_EXACT] = generate_exact,
    [SEPAX_ARCH_PAPER] = generate_paper,
    [SEPAX_ARCH_CONFERENCE] = generate_conference,
};

bool cli_generate(sepax_design *design, const char *folder, sepax_error *error) {
  if (generators[design->config.arch] == NULL) {
    return sepax_fail(error, "arch: '%s' has no hardware; give --arch=exact, paper or conference",
                      sepax_arch_name(design->config.arch));
  }
  char command[SEPAX_CONFIG_TEXT + 16];
  char text[SEPAX_CONFIG_TEXT];
  snprintf(command, sizeof command, "sepax gen %s",
           sepax_config_text(&design->config, text, sizeof text));
  emitter e;
  emit_init(&e, design, command);
  bool ok = generators[design->config.arch](&e, design);
  if (!ok) {
    *error = e.error;
  }
  ok = ok && gen_write(&e, folder, error);
  emit_free(&e);
  return ok;
}

int cli_gen(int argc, char **argv) {
  static const struct argp_child children[] = {{&cli_config_argp, 0, NULL, 0}, {0}};
  static const struct argp argp = {
      options,
      parse,
      NULL,
      "Generate the Verilog of a design: one module a file, sepax.f (their list), "
      "sepax_params.h, sepax_params.vh and sepax.json for test benches, sepax.sdc and for Xilinx "
      "sepax.xdc (the clock), sepax.gtkw (ports for GTKWave); of an engine its registers.",
      children,
      NULL,
      NULL};
  gen_options o = {.config = sepax_config_default()};
  argp_parse(&argp, argc, argv, 0, NULL, &o);
  sepax_error error = {""};
  sepax_design design;
  if (!sepax_design_init(&design, &o.config, &error) || !cli_generate(&design, o.folder, &error)) {
    return cli_fail("sepax gen", &error);
  }
  char text[SEPAX_CONFIG_TEXT];
  printf("%s: %s, latency %d, II %d\n", o.folder, sepax_config_text(&o.config, text, sizeof text),
         design.latency, o.config.ii);
  return 0;
}
