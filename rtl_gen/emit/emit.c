/* emit.c - building and printing modules; check.c judges them. */
#include "emit.h"
#include "sepax_design.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

void emit_init(emitter *e, const sepax_design *design, const char *command) {
  *e = (emitter){.design = design};
  snprintf(e->command, sizeof e->command, "%s", command);
}

static void free_module(emit_module *m) {
  if (m->text != NULL) {
    fclose(m->text);
  }
  for (int i = 0; i < m->symbols; i++) {
    free(m->symbol[i].about);
  }
  for (int i = 0; i < m->instances; i++) {
    free(m->instance[i].parameters);
    free(m->instance[i].connections);
  }
  free(m->body);
  free(m->banner);
  free(m);
}

void emit_free(emitter *e) {
  for (int i = 0; i < e->modules; i++) {
    free_module(e->module[i]);
  }
  for (int i = 0; i < e->variants; i++) {
    free(e->variant[i]);
  }
  e->modules = 0;
  e->variants = 0;
}

bool emit_refuse(const emit_module *m, const char *format, ...) {
  sepax_error *error = &m->emitter->error;
  if (error->text[0] == '\0') {
    int used = snprintf(error->text, sizeof error->text, "generator refuses %s: ", m->name);
    va_list args;
    va_start(args, format);
    vsnprintf(error->text + used, sizeof error->text - (size_t)used, format, args);
    va_end(args);
  }
  return false;
}

static char *copy_text(const char *text) {
  char *copy = strdup(text);
  if (copy == NULL) {
    abort();
  }
  return copy;
}

static char *format_text(const char *format, va_list args) {
  char *text = NULL;
  size_t size = 0;
  FILE *stream = open_memstream(&text, &size);
  if (stream == NULL || vfprintf(stream, format, args) < 0 || fclose(stream) != 0) {
    abort();
  }
  return text;
}

emit_module *emit_begin(emitter *e, const char *name, const char *banner) {
  emit_module *m = calloc(1, sizeof *m);
  if (m == NULL) {
    abort();
  }
  m->emitter = e;
  snprintf(m->name, sizeof m->name, "%s", name);
  m->banner = copy_text(banner);
  m->text = open_memstream(&m->body, &m->body_size);
  if (m->text == NULL) {
    abort();
  }
  for (int i = 0; i < e->modules; i++) {
    if (strcmp(e->module[i]->name, name) == 0) {
      emit_refuse(m, "module is emitted twice");
    }
  }
  if (e->modules == EMIT_MODULES) {
    emit_refuse(m, "more than %d modules", EMIT_MODULES);
    e->modules--;
    free_module(e->module[e->modules]);
  }
  e->module[e->modules++] = m;
  return m;
}

bool emit_end(emit_module *m) {
  fflush(m->text);
  return m->emitter->error.text[0] == '\0' && emit_check(m, NULL, 0);
}

const emit_module *emit_find(emitter *e, const char *name) {
  for (int i = 0; i < e->modules; i++) {
    if (strcmp(e->module[i]->name, name) == 0) {
      return e->module[i];
    }
  }
  return NULL;
}

static emit_symbol *declare(emit_module *m, emit_kind kind, const char *name) {
  for (int i = 0; i < m->symbols; i++) {
    if (strcmp(m->symbol[i].name, name) == 0) {
      emit_refuse(m, "'%s' is declared twice", name);
      return NULL;
    }
  }
  if (m->symbols == EMIT_SYMBOLS || strlen(name) >= EMIT_NAME) {
    emit_refuse(m, "no room for the name '%s'", name);
    return NULL;
  }
  emit_symbol *s = &m->symbol[m->symbols++];
  s->kind = kind;
  snprintf(s->name, sizeof s->name, "%s", name);
  return s;
}

static size_t body_position(emit_module *m) {
  fflush(m->text);
  return m->body_size;
}

void emit_parameter(emit_module *m, emit_kind kind, const char *name, int value,
                    const char *about) {
  emit_symbol *s = declare(m, kind, name);
  if (s == NULL) {
    return;
  }
  s->value = value;
  s->about = copy_text(about);
  if (kind == EMIT_LOCALPARAM) {
    s->begin = body_position(m);
    fprintf(m->text, "  localparam %s = %d; // %s\n", name, value, about);
    s->end = body_position(m);
  }
}

static void print_range(FILE *out, const char *width) {
  char *end;
  long bits = strtol(width, &end, 10);
  if (*width == '\0') {
    return;
  }
  if (*end == '\0') {
    fprintf(out, "[%ld:0] ", bits - 1);
  } else {
    fprintf(out, "[%s-1:0] ", width);
  }
}

void emit_signal(emit_module *m, emit_kind kind, bool is_signed, const char *name,
                 const char *width, const char *about, ...) {
  emit_symbol *s = declare(m, kind, name);
  if (s == NULL) {
    return;
  }
  va_list args;
  va_start(args, about);
  s->about = format_text(about, args);
  va_end(args);
  s->is_signed = is_signed;
  snprintf(s->width, sizeof s->width, "%s", width);
  if (kind == EMIT_WIRE || kind == EMIT_REG) {
    s->begin = body_position(m);
    fprintf(m->text, "  %s %s", kind == EMIT_WIRE ? "wire" : "reg", is_signed ? "signed " : "");
    print_range(m->text, width);
    fprintf(m->text, "%s;%s%s\n", name, s->about[0] != '\0' ? " // " : "", s->about);
    s->end = body_position(m);
  } else if (s->about[0] == '\0') {
    emit_refuse(m, "port '%s' has no description", name);
  }
}

void emit_net(emit_module *m, emit_kind kind, bool is_signed, const char *name, const char *width) {
  emit_signal(m, kind, is_signed, name, width, "%s", "");
}

void emit_memory(emit_module *m, const char *name, const char *width, const char *address,
                 const char *about) {
  emit_symbol *s = declare(m, EMIT_REG, name);
  if (s == NULL) {
    return;
  }
  s->about = copy_text(about);
  snprintf(s->width, sizeof s->width, "%s", width);
  snprintf(s->address, sizeof s->address, "%s", address);
  s->begin = body_position(m);
  fputs("  reg ", m->text);
  print_range(m->text, width);
  fprintf(m->text, "%s [0:(1<<%s)-1]; // %s\n", name, address, about);
  s->end = body_position(m);
}

void emit_blank(emit_module *m) { fputc('\n', m->text); }

void emit_text(emit_module *m, const char *format, ...) {
  va_list args;
  va_start(args, format);
  char *text = format_text(format, args);
  va_end(args);
  for (char *line = text; *line != '\0';) {
    size_t length = strcspn(line, "\n");
    fprintf(m->text, "%s%.*s\n", length > 0 ? "  " : "", (int)length, line);
    line += length + (line[length] == '\n');
  }
  free(text);
}

void emit_view(emit_module *m, emit_views view) {
  static const char *const directive[] = {"`ifdef SEPAX_BEHAVIOURAL", "`else", "`endif"};
  fprintf(m->text, "%s\n", directive[view]);
}

static void print_bindings(FILE *out, const char *bindings, const char *indent) {
  char *copy = copy_text(bindings);
  char *rest = NULL;
  const char *separator = "";
  for (char *item = strtok_r(copy, ",", &rest); item != NULL; item = strtok_r(NULL, ",", &rest)) {
    item += strspn(item, " \n");
    char *value = strchr(item, '=');
    if (value != NULL) {
      *value++ = '\0';
      fprintf(out, "%s%s.%s(%s)", separator, indent, item, value);
      separator = ",";
    }
  }
  free(copy);
}

void emit_instance(emit_module *m, const char *module, const char *name, const char *parameters,
                   const char *connections, ...) {
  emit_symbol *s = declare(m, EMIT_LABEL, name);
  const emit_module *child = emit_find(m->emitter, module);
  if (child == NULL) {
    emit_refuse(m, "instance '%s' of a module '%s' that is not emitted yet", name, module);
    return;
  }
  if (s == NULL || m->instances == EMIT_INSTANCES) {
    emit_refuse(m, "no room for the instance '%s'", name);
    return;
  }
  emit_instance_record *record = &m->instance[m->instances++];
  record->module = child;
  snprintf(record->name, sizeof record->name, "%s", name);
  record->parameters = copy_text(parameters);
  va_list args;
  va_start(args, connections);
  record->connections = format_text(connections, args);
  va_end(args);
  s->begin = record->begin = body_position(m);
  fprintf(m->text, "  %s ", module);
  if (parameters[0] != '\0') {
    fprintf(m->text, "#(");
    print_bindings(m->text, parameters, " ");
    fprintf(m->text, " ) ");
  }
  fprintf(m->text, "%s (", name);
  print_bindings(m->text, record->connections, "\n    ");
  fprintf(m->text, "\n  );\n");
  s->end = record->end = body_position(m);
}

/* ------------------------------------------------------------------ printing */

static void print_comment(FILE *out, const char *text) {
  for (const char *line = text; *line != '\0';) {
    size_t length = strcspn(line, "\n");
    fprintf(out, "//%s%.*s\n", length > 0 ? " " : "", (int)length, line);
    line += length + (line[length] == '\n');
  }
}

/* The declaration of a parameter or port, in aligned columns, without its comma. */
static void describe(const emit_symbol *s, char *text, size_t size) {
  static const char *const direction[] = {[EMIT_INPUT] = "input  wire",
                                          [EMIT_OUTPUT] = "output wire",
                                          [EMIT_OUTPUT_REG] = "output reg "};
  if (s->kind == EMIT_PARAMETER) {
    snprintf(text, size, "parameter %s = %d", s->name, s->value);
    return;
  }
  char range[2 * EMIT_NAME] = "";
  FILE *out = fmemopen(range, sizeof range, "w");
  if (out == NULL) {
    abort();
  }
  print_range(out, s->width);
  fclose(out);
  snprintf(text, size, "%s %-6s %-13s%s", direction[s->kind], s->is_signed ? "signed" : "", range,
           s->name);
}

static bool in_header(const emit_symbol *s, bool parameters) {
  return parameters ? s->kind == EMIT_PARAMETER
                    : s->kind == EMIT_INPUT || s->kind == EMIT_OUTPUT || s->kind == EMIT_OUTPUT_REG;
}

/* Parameters or ports in parentheses, one a line with its comment. */
static void print_list(const emit_module *m, bool parameters, FILE *out) {
  char text[4 * EMIT_NAME];
  size_t longest = 0;
  int left = 0;
  for (int i = 0; i < m->symbols; i++) {
    if (in_header(&m->symbol[i], parameters)) {
      describe(&m->symbol[i], text, sizeof text);
      longest = strlen(text) > longest ? strlen(text) : longest;
      left++;
    }
  }
  if (left == 0) {
    return;
  }
  fprintf(out, parameters ? " #(\n" : " (\n");
  for (int i = 0; i < m->symbols; i++) {
    if (in_header(&m->symbol[i], parameters)) {
      left--;
      describe(&m->symbol[i], text, sizeof text);
      strcat(text, left > 0 ? "," : "");
      fprintf(out, "  %-*s // %s\n", (int)longest + 1, text, m->symbol[i].about);
    }
  }
  fprintf(out, ")");
}

void emit_print(const emit_module *m, FILE *out) {
  fprintf(out, "// %s.v\n//\n", m->name);
  print_comment(out, m->banner);
  fprintf(out, "//\n// Generated by sepax %s; do not edit. Made by:\n//   %s\n\n", SEPAX_VERSION,
          m->emitter->command);
  fprintf(out, "`default_nettype none\n\nmodule %s", m->name);
  print_list(m, true, out);
  print_list(m, false, out);
  fprintf(out, ";\n\n%.*s\nendmodule\n\n`default_nettype wire\n", (int)m->body_size, m->body);
}
