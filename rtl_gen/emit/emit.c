/* emit.c - building and printing modules; check.c judges them. */
#include "emit.h"
#include "check.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

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

static void print_comment(FILE *out, const char *text) {
  for (const char *line = text; *line != '\0';) {
    size_t length = strcspn(line, "\n");
    fprintf(out, "//%s%.*s\n", length > 0 ? " " : "", (int)length, line);
    line += length + (line[length] == '\n');
  }
}

emit_module *emit_begin(emitter *e, const char *name, const char *banner) {
  emit_stream s;
  emit_stream_open(&s);
  print_comment(s.out, banner);
  emit_module *m = emit_new_module(e, name, emit_stream_close(&s));
  free(s.text);
  return m;
}

static void print_list(const emit_module *m, bool parameters, FILE *out);

bool emit_end(emit_module *m) {
  emit_stream s;
  emit_stream_open(&s);
  fflush(m->text);
  fprintf(s.out, "module %s", m->name);
  print_list(m, true, s.out);
  print_list(m, false, s.out);
  fprintf(s.out, ";\n\n%.*s\nendmodule\n", (int)m->body_size, m->body);
  m->verilog = emit_stream_close(&s);
  return m->emitter->error.text[0] == '\0' && emit_check(m);
}

void emit_parameter(emit_module *m, emit_kind kind, const char *name, int value,
                    const char *about) {
  if (kind == EMIT_LOCALPARAM) {
    fprintf(m->text, "  localparam %s = %d; // %s\n", name, value, about);
    return;
  }
  emit_symbol *s = emit_declare(m, kind, name);
  if (s != NULL) {
    char text[16];
    snprintf(text, sizeof text, "%d", value);
    s->value = copy_text(text);
    s->about = copy_text(about);
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
  va_list args;
  va_start(args, about);
  char *comment = format_text(about, args);
  va_end(args);
  if (kind == EMIT_WIRE || kind == EMIT_REG) {
    fprintf(m->text, "  %s %s", kind == EMIT_WIRE ? "wire" : "reg", is_signed ? "signed " : "");
    print_range(m->text, width);
    fprintf(m->text, "%s;%s%s\n", name, comment[0] != '\0' ? " // " : "", comment);
  } else {
    emit_symbol *s = emit_declare(m, kind, name);
    if (s != NULL) {
      s->is_signed = is_signed;
      s->width = copy_text(width);
      s->about = copy_text(comment);
    }
    if (comment[0] == '\0') {
      emit_refuse(m, "port '%s' has no description", name);
    }
  }
  free(comment);
}

void emit_net(FILE *out, const char *kind, const char *width, const char *name) {
  fprintf(out, "  %s ", kind);
  print_range(out, width);
  fprintf(out, "%s;\n", name);
}

void emit_memory(emit_module *m, const char *name, const char *width, const char *address,
                 const char *about) {
  fputs("  reg ", m->text);
  print_range(m->text, width);
  fprintf(m->text, "%s [0:(1<<%s)-1]; // %s\n", name, address, about);
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
  va_list args;
  va_start(args, connections);
  char *text = format_text(connections, args);
  va_end(args);
  fprintf(m->text, "  %s ", module);
  if (parameters[0] != '\0') {
    fprintf(m->text, "#(");
    print_bindings(m->text, parameters, " ");
    fprintf(m->text, " ) ");
  }
  fprintf(m->text, "%s (", name);
  print_bindings(m->text, text, "\n    ");
  fprintf(m->text, "\n  );\n");
  free(text);
}

/* ------------------------------------------------------------------ printing */

/* The declaration of a parameter or port, in aligned columns, without its comma. */
static char *describe(const emit_symbol *s) {
  static const char *const direction[] = {[EMIT_INPUT] = "input  wire",
                                          [EMIT_OUTPUT] = "output wire",
                                          [EMIT_OUTPUT_REG] = "output reg "};
  char *text = NULL;
  size_t size = 0;
  FILE *out = open_memstream(&text, &size);
  if (out == NULL) {
    abort();
  }
  if (s->kind == EMIT_PARAMETER) {
    fprintf(out, "parameter %s = %s", s->name, s->value);
  } else {
    fprintf(out, "%s %-6s ", direction[s->kind], s->is_signed ? "signed" : "");
    long before = ftell(out);
    print_range(out, s->width);
    int used = (int)(ftell(out) - before);
    fprintf(out, "%*s%s", used < 13 ? 13 - used : 0, "", s->name);
  }
  fclose(out);
  return text;
}

/* Parameters or ports in parentheses, one a line with its comment. */
static void print_list(const emit_module *m, bool parameters, FILE *out) {
  size_t longest = 0;
  int left = 0;
  for (int i = 0; i < m->symbols; i++) {
    if (emit_is_port(&m->symbol[i]) != parameters) {
      char *text = describe(&m->symbol[i]);
      longest = strlen(text) > longest ? strlen(text) : longest;
      left++;
      free(text);
    }
  }
  if (left == 0) {
    return;
  }
  fprintf(out, parameters ? " #(\n" : " (\n");
  for (int i = 0; i < m->symbols; i++) {
    if (emit_is_port(&m->symbol[i]) != parameters) {
      left--;
      char *text = describe(&m->symbol[i]);
      fprintf(out, "  %s%-*s // %s\n", text, (int)(longest + 1 - strlen(text)), left > 0 ? "," : "",
              m->symbol[i].about);
      free(text);
    }
  }
  fprintf(out, ")");
}

/* The command behind "//   ", broken at blanks. */
static void print_command(FILE *out, const char *command) {
  size_t column = 4;
  fprintf(out, "//  ");
  for (const char *word = command; *word != '\0'; word += strspn(word, " ")) {
    size_t length = strcspn(word, " ");
    if (column + 1 + length > 98) {
      fprintf(out, " \\\n//    ");
      column = 6;
    }
    fprintf(out, " %.*s", (int)length, word);
    column += 1 + length;
    word += length;
  }
  fprintf(out, "\n");
}

void emit_print(const emit_module *m, FILE *out) {
  fprintf(out, "// %s.v\n//\n", m->name);
  fputs(m->banner, out);
  fprintf(out, "//\n// Generated by sepax %s; do not edit. Made by:\n", SEPAX_VERSION);
  print_command(out, m->emitter->command);
  fprintf(out, "\n");
  fprintf(out, "`default_nettype none\n\n%s\n`default_nettype wire\n", m->verilog);
}

gen_line gen_format(const char *format, ...) {
  gen_line line;
  va_list args;
  va_start(args, format);
  vsnprintf(line.text, sizeof line.text, format, args);
  va_end(args);
  return line;
}
