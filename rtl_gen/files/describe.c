/* SPDX-License-Identifier: MIT */
/* describe.c - sepax.json, sepax_params.h and sepax_params.vh: what benches and scripts ask about a
 * design; constraints and a list of waves for other tools. */
#include "files/describe.h"

#include "datapath/delay.h"
#include "emit/check.h"
#include "emit/prefix.h"
#include "engine/engine.h"

#include <jansson.h>
#include <stdlib.h>
#include <string.h>

/* Without memory *failed becomes true, here and below. */
static json_t *describe_formats(const sepax_design *d, bool *failed) {
  json_t *list = json_array();
  bool exact = d->config.arch == SEPAX_ARCH_EXACT;
  for (int i = 0; i < d->formats; i++) {
    const sepax_format *f = exact ? &d->exact_format[i] : &d->format[i];
    *failed |=
        json_array_append_new(list, json_pack("{s:s, s:i, s:i, s:i}", "name", f->name, "exact",
                                              f->exact, "width", f->width, "shift", f->shift)) != 0;
  }
  return list;
}

static json_t *describe_ports(const emit_module *top, bool *failed) {
  json_t *list = json_array();
  reader r;
  reader_open(&r, top, top->verilog);
  check_header(&r);
  for (const check_name *n = r.name; n < r.name + r.header; n++) {
    if (n->kind != NAME_CONSTANT) {
      *failed |= json_array_append_new(
                     list, json_pack("{s:s, s:s, s:i, s:b, s:s%}", "name", n->name, "direction",
                                     n->kind == NAME_INPUT ? "input" : "output", "width", n->width,
                                     "signed", n->is_signed, "about", n->about,
                                     strcspn(n->about, "\n"))) != 0;
    }
  }
  *failed |= r.failed;
  reader_close(&r);
  return list;
}

/* Each option of the design: "clock_ns": 2. */
static void describe_settings(json_t *all, const sepax_config *config, bool *failed) {
  sepax_setting setting;
  for (size_t i = 0; sepax_config_setting(config, i, &setting); i++) {
    gen_line name = gen_format("%s", setting.name);
    for (char *dash = name.text; (dash = strchr(dash, '-')) != NULL;) {
      *dash = '_';
    }
    double number = setting.is_number ? strtod(setting.value, NULL) : 0;
    json_int_t whole = (json_int_t)number;
    *failed |= json_object_set_new(all, name.text,
                                   !setting.is_number        ? json_string(setting.value)
                                   : (double)whole == number ? json_integer(whole)
                                                             : json_real(number)) != 0;
  }
}

/* What json_pack leaves out with "o*" where it is not given; without memory it is not left out. */
static json_t *optional(bool given, json_t *made, bool *failed) {
  *failed |= given && made == NULL;
  return given ? made : NULL;
}

static json_t *optional_number(bool given, int64_t number, bool *failed) {
  return optional(given, given ? json_integer((json_int_t)number) : NULL, failed);
}

void describe_json(const emitter *e, emit_text *out) {
  const sepax_design *d = e->design;
  const bool exact = d->config.arch == SEPAX_ARCH_EXACT;
  const int transfers = sepax_stream_transfers(&d->config);
  char text[SEPAX_CONFIG_TEXT];
  bool failed = false;
  json_t *modules = json_array();
  for (int i = 0; i < e->modules; i++) {
    failed |= json_array_append_new(modules, json_string(e->module[i]->name)) != 0;
  }
  json_t *all = json_pack("{ss, ss, ss}", "version", SEPAX_VERSION, "license", "MIT", "options",
                          sepax_config_text(&d->config, text, sizeof text));
  describe_settings(all, &d->config, &failed);
  json_t *rest = json_pack(
      "{si, so*, si, so*, so*, so*, so*, so, so, so}", "latency", d->latency, "latency_wait",
      optional_number(exact, d->wait, &failed), "input_words",
      transfers > 0 ? transfers
      : exact       ? 1
                    : 3,
      "core_word", optional_number(exact && d->config.extent_a > 0, d->core_word, &failed),
      "margin", optional_number(exact && d->limits > 0, d->margin[1], &failed), "behavioural_view",
      optional(exact, exact ? json_string("SEPAX_BEHAVIOURAL") : NULL, &failed), "coplanar_limit",
      optional_number(!exact, d->coplanar_limit, &failed), "formats", describe_formats(d, &failed),
      "modules", modules, "ports", describe_ports(e->module[e->modules - 1], &failed));
  failed |= json_object_update(all, rest) != 0;
  if (d->config.corner == SEPAX_CORNER_SLOW) {
    failed |= json_object_set_new(all, "slower", json_real(delay_corner(&d->config))) != 0;
  }
  if (d->ripple) {
    failed |= json_object_set_new(all, "adders", json_string("ripple")) != 0;
  }
  if (strcmp(e->prefix, PREFIX_STANDARD) != 0) {
    failed |= json_object_set_new(all, "prefix", json_string(e->prefix)) != 0;
  }
  json_decref(rest);
  char *json = json_dumps(all, JSON_INDENT(2) | JSON_REAL_PRECISION(6));
  /* Without memory jansson 2.14 prints a key as nothing. */
  json_t *again = json != NULL ? json_loads(json, 0, NULL) : NULL;
  failed |= again == NULL || json_object_size(again) != json_object_size(all) ||
            json_object_get(again, "") != NULL;
  json_decref(again);
  json_decref(all);
  out->failed = out->failed || failed;
  text_printf(out, "%s\n", json != NULL ? json : "");
  free(json);
}

/* Does the text of the design have this option? */
static bool is_shown(const sepax_config *config, const char *option) {
  sepax_setting setting;
  for (size_t i = 0; sepax_config_setting(config, i, &setting); i++) {
    if (strcmp(setting.name, option) == 0) {
      return true;
    }
  }
  return false;
}

/* Numbers of the design for benches, if they are given: macros SEPAX_NAME in C; in Verilog a
 * localparam NAME (SEPAX_NAME if the design has a prefix of its own), a macro if it is not 0, or
 * nothing. */
static void describe_numbers(const sepax_design *d, bool verilog, bool own, emit_text *out) {
  const sepax_config *c = &d->config;
  const struct {
    const char *name;
    int value;
    bool given;
    enum { C_ONLY, LOCALPARAM, MACRO } kind;
  } row[] = {
      {"WORD", c->word, true, LOCALPARAM},
      {"LATENCY", d->latency, true, LOCALPARAM},
      {"II", c->ii, true, LOCALPARAM},
      {"EXACT", c->arch == SEPAX_ARCH_EXACT, true, MACRO},
      {"FLAG", c->flag, true, C_ONLY},
      {"CONFERENCE", 1, c->arch == SEPAX_ARCH_CONFERENCE, MACRO},
      {"BOXES", 1, d->aabb_test, MACRO},
      {"SKID", 1, engine_registers_ready(c), MACRO},
      {"EXTENT_A", c->extent_a, is_shown(c, "extent-a"), C_ONLY},
      {"EXTENT_B", c->extent_b, is_shown(c, "extent-b"), C_ONLY},
      {"LANES", c->lanes, is_shown(c, "lanes"), C_ONLY},
      {"TREE", 1, is_shown(c, "tree"), C_ONLY},
      {"STREAM", sepax_stream_transfers(c), is_shown(c, "stream"), C_ONLY},
      {"TAG", c->tag, is_shown(c, "tag"), C_ONLY},
      {"CORES", c->cores, is_shown(c, "cores"), C_ONLY},
      {"MEMORY_A", c->memory_a, is_shown(c, "memory-a"), C_ONLY},
      {"MEMORY_B", c->memory_b, is_shown(c, "memory-b"), C_ONLY},
      {"BANDS", d->limits + 1, d->limits > 0, MACRO},
  };
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
    if (row[i].given && !verilog) {
      text_printf(out, "#define SEPAX_%s %d\n", row[i].name, row[i].value);
    } else if (row[i].given && row[i].kind == LOCALPARAM) {
      text_printf(out, "localparam %s%s = %d;\n", own ? "SEPAX_" : "", row[i].name, row[i].value);
    } else if (row[i].given && row[i].kind == MACRO && row[i].value != 0) {
      text_printf(out, "`define SEPAX_%s\n", row[i].name);
    }
  }
}

void describe_c(const sepax_design *d, emit_text *out) {
  char options[SEPAX_CONFIG_TEXT];
  char variables[SEPAX_CONFIG_TEXT];
  sepax_config_variables(&d->config, variables, sizeof variables);
  text_printf(out,
              "/* SPDX-License-Identifier: MIT */\n/* Generated by sepax %s; do not edit. */\n",
              SEPAX_VERSION);
  text_printf(out, "#define SEPAX_OPTIONS \"%s\"\n#define SEPAX_MAKE \"%s\"\n",
              sepax_config_text(&d->config, options, sizeof options), variables);
  describe_numbers(d, false, false, out);
}

void describe_verilog(const emitter *e, emit_text *out) {
  text_printf(out, "// SPDX-License-Identifier: MIT\n// Generated by sepax %s; do not edit.\n",
              SEPAX_VERSION);
  describe_numbers(e->design, true, strcmp(e->prefix, PREFIX_STANDARD) != 0, out);
}

/* ---------------------------------------------------------------------- other tools */

static bool has_port(const reader *r, const char *name) {
  for (const check_name *n = r->name; n < r->name + r->header; n++) {
    if (n->kind != NAME_CONSTANT && strcmp(n->name, name) == 0) {
      return true;
    }
  }
  return false;
}

/* The parameters and ports of the top. */
static void open_top(const emitter *e, reader *r) {
  const emit_module *top = e->module[e->modules - 1];
  reader_open(r, top, top->verilog);
  check_header(r);
}

void describe_constraints(const emitter *e, emit_text *out) {
  const sepax_config *c = &e->design->config;
  const double ns = c->arch == SEPAX_ARCH_CONFERENCE ? 2.5 : 1e-3 * c->clock_ps;
  reader r;
  open_top(e, &r);
  const char *clock = has_port(&r, "aclk") ? "aclk" : "clk";
  out->failed |= r.failed;
  reader_close(&r);
  text_printf(
      out,
      "# SPDX-License-Identifier: MIT\n"
      "# Generated by sepax %s; do not edit.\n"
      "# The clock of %s, for the module by itself; in a larger design leave it out. No path\n"
      "# is false or takes several cycles. Add the delays of your inputs and outputs.\n"
      "create_clock -name %s -period %.3f [get_ports %s]\n",
      SEPAX_VERSION, e->module[e->modules - 1]->name, clock, ns, clock);
}

/* What a port is shown with: a bus, or what it is. */
static const char *group_of(const check_name *n) {
  static const char *const buses[] = {"s_axi", "s_axis", "m_axi", "m_axis"};
  static const char *const clocks[] = {"clk", "rst", "aclk", "aresetn"};
  for (size_t i = 0; i < 4; i++) {
    size_t length = strlen(buses[i]);
    if (strncmp(n->name, buses[i], length) == 0 && n->name[length] == '_') {
      return buses[i];
    }
    if (strcmp(n->name, clocks[i]) == 0) {
      return "clock";
    }
  }
  return n->kind == NAME_INPUT ? "input" : "output";
}

static void end_group(const char *group, emit_text *out) {
  if (group != NULL) {
    text_printf(out, "@1000200\n-%s\n", group);
  }
}

/* The ports of a module at a path, group by group as they come. */
static void show_ports(const emit_module *m, const char *path, emit_text *out) {
  enum { SIGNED = 0x420, BINARY = 0x28, HEXADECIMAL = 0x22, BEGIN = 0x800200 };
  const char *group = NULL;
  reader r;
  reader_open(&r, m, m->verilog);
  check_header(&r);
  for (const check_name *n = r.name; n < r.name + r.header; n++) {
    if (n->kind == NAME_CONSTANT) {
      continue;
    }
    const char *of = group_of(n);
    if (of != group) {
      end_group(group, out);
      text_printf(out, "@%x\n-%s\n", BEGIN, of);
      group = of;
    }
    text_printf(out, "@%x\n%s.%s",
                n->is_signed    ? SIGNED
                : n->width == 1 ? BINARY
                                : HEXADECIMAL,
                path, n->name);
    if (n->width > 1) {
      text_printf(out, "[%d:0]", n->width - 1);
    }
    text_putc(out, '\n');
  }
  end_group(group, out);
  out->failed |= r.failed;
  reader_close(&r);
}

void describe_waves(const emitter *e, emit_text *out) {
  const emit_module *top = e->module[e->modules - 1];
  const gen_line path = gen_format("TOP.%s", top->name);
  text_printf(out,
              "[*] SPDX-License-Identifier: MIT\n"
              "[*] Generated by sepax %s; do not edit.\n[*] GTKWave: the ports of %s as make wave "
              "names them.\n",
              SEPAX_VERSION, top->name);
  show_ports(top, path.text, out);
  const char *core = engine_generator_of(&e->design->config)->core;
  if (core != NULL) {
    show_ports(emit_find(e, "sepax_top"), gen_format("%s.%s", path.text, core).text, out);
  }
}
