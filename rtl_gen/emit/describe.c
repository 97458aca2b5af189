/* describe.c - sepax.json, sepax_params.h and sepax_params.vh: what benches and scripts ask about a
 * design. */
#include "describe.h"
#include "check.h"

#include <jansson.h>
#include <stdlib.h>
#include <string.h>

static json_t *describe_formats(const sepax_design *d) {
  json_t *list = json_array();
  bool exact = d->config.arch == SEPAX_ARCH_EXACT;
  for (int i = 0; i < d->formats; i++) {
    const sepax_format *f = exact ? &d->exact_format[i] : &d->format[i];
    json_array_append_new(list, json_pack("{s:s, s:i, s:i, s:i}", "name", f->name, "exact",
                                          f->exact, "width", f->width, "shift", f->shift));
  }
  return list;
}

static json_t *describe_ports(const emit_module *top) {
  json_t *list = json_array();
  reader r;
  reader_open(&r, top, top->verilog);
  check_header(&r);
  for (const check_name *n = r.name; n < r.name + r.header; n++) {
    if (n->kind != NAME_CONSTANT) {
      json_array_append_new(list, json_pack("{s:s, s:s, s:i, s:b, s:s%}", "name", n->name,
                                            "direction", n->kind == NAME_INPUT ? "input" : "output",
                                            "width", n->width, "signed", n->is_signed, "about",
                                            n->about, strcspn(n->about, "\n")));
    }
  }
  reader_close(&r);
  return list;
}

/* Each option of the design: "clock_ns": 2. */
static void describe_settings(json_t *all, const sepax_config *config) {
  sepax_setting setting;
  for (size_t i = 0; sepax_config_setting(config, i, &setting); i++) {
    char name[sizeof setting.value];
    size_t k = 0;
    for (; setting.name[k] != '\0' && k + 1 < sizeof name; k++) {
      name[k] = (char)(setting.name[k] == '-' ? '_' : setting.name[k]);
    }
    name[k] = '\0';
    double number = setting.is_number ? strtod(setting.value, NULL) : 0;
    json_int_t whole = (json_int_t)number;
    json_object_set_new(all, name,
                        !setting.is_number        ? json_string(setting.value)
                        : (double)whole == number ? json_integer(whole)
                                                  : json_real(number));
  }
}

static json_t *describe(const emitter *e) {
  const sepax_design *d = e->design;
  const sepax_config *c = &d->config;
  char text[SEPAX_CONFIG_TEXT];
  json_t *modules = json_array();
  for (int i = 0; i < e->modules; i++) {
    json_array_append_new(modules, json_string(e->module[i]->name));
  }
  bool exact = c->arch == SEPAX_ARCH_EXACT;
  json_t *all = json_pack("{s:s, s:s}", "version", SEPAX_VERSION, "options",
                          sepax_config_text(c, text, sizeof text));
  describe_settings(all, c);
  json_object_set_new(all, "latency", json_integer(d->latency));
  json_object_set_new(all, "input_words", json_integer(exact ? 1 : 3));
  if (exact) {
    if (c->extent_a > 0) {
      json_object_set_new(all, "core_word", json_integer(d->core_word));
    }
    if (d->limits > 0) {
      json_object_set_new(all, "margin", json_integer((json_int_t)d->margin[1]));
    }
    json_object_set_new(all, "behavioural_view", json_string("SEPAX_BEHAVIOURAL"));
  } else {
    json_object_set_new(all, "coplanar_limit", json_integer((json_int_t)d->coplanar_limit));
  }
  json_object_set_new(all, "formats", describe_formats(d));
  json_object_set_new(all, "modules", modules);
  json_object_set_new(all, "ports", describe_ports(e->module[e->modules - 1]));
  return all;
}

void describe_json(const emitter *e, FILE *out) {
  json_t *description = describe(e);
  json_dumpf(description, out, JSON_INDENT(2) | JSON_REAL_PRECISION(6));
  fputc('\n', out);
  json_decref(description);
}

/* A number of the design for benches: a macro SEPAX_NAME in C; in Verilog a localparam NAME, a
 * macro if it is not 0, or nothing. */
typedef struct {
  const char *name;
  int value;
  bool given; /* else left out */
  enum { C_ONLY, LOCALPARAM, MACRO } verilog;
} number;

enum { NUMBERS = 14 };

static void list_numbers(const sepax_design *d, number list[NUMBERS]) {
  const sepax_config *c = &d->config;
  bool extents = c->extent_a > 0;
  bool engine = c->lanes > 0;
  const number all[NUMBERS] = {
      {"WORD", c->word, true, LOCALPARAM},
      {"LATENCY", d->latency, true, LOCALPARAM},
      {"II", c->ii, true, LOCALPARAM},
      {"EXACT", c->arch == SEPAX_ARCH_EXACT, true, MACRO},
      {"FLAG", c->flag, true, C_ONLY},
      {"CONFERENCE", 1, c->arch == SEPAX_ARCH_CONFERENCE, MACRO},
      {"BOXES", 1, d->aabb_test, MACRO},
      {"EXTENT_A", c->extent_a, extents, C_ONLY},
      {"EXTENT_B", c->extent_b, extents, C_ONLY},
      {"LANES", c->lanes, engine, C_ONLY},
      {"CORES", c->cores, engine, C_ONLY},
      {"MEMORY_A", c->memory_a, engine, C_ONLY},
      {"MEMORY_B", c->memory_b, engine, C_ONLY},
      {"BANDS", d->limits + 1, d->limits > 0, MACRO},
  };
  for (int i = 0; i < NUMBERS; i++) {
    list[i] = all[i];
  }
}

void describe_c(const sepax_design *d, FILE *out) {
  char options[SEPAX_CONFIG_TEXT];
  char variables[SEPAX_CONFIG_TEXT];
  number list[NUMBERS];
  list_numbers(d, list);
  sepax_config_variables(&d->config, variables, sizeof variables);
  fprintf(out, "/* Generated by sepax %s; do not edit. */\n", SEPAX_VERSION);
  fprintf(out, "#define SEPAX_OPTIONS \"%s\"\n#define SEPAX_MAKE \"%s\"\n",
          sepax_config_text(&d->config, options, sizeof options), variables);
  for (int i = 0; i < NUMBERS; i++) {
    if (list[i].given) {
      fprintf(out, "#define SEPAX_%s %d\n", list[i].name, list[i].value);
    }
  }
}

void describe_verilog(const sepax_design *d, FILE *out) {
  number list[NUMBERS];
  list_numbers(d, list);
  fprintf(out, "// Generated by sepax %s; do not edit.\n", SEPAX_VERSION);
  for (int i = 0; i < NUMBERS; i++) {
    if (list[i].given && list[i].verilog == LOCALPARAM) {
      fprintf(out, "localparam %s = %d;\n", list[i].name, list[i].value);
    } else if (list[i].given && list[i].verilog == MACRO && list[i].value != 0) {
      fprintf(out, "`define SEPAX_%s\n", list[i].name);
    }
  }
}
