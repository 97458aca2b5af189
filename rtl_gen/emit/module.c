/* module.c - the emitter's memory. */
#include "module.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

char *emit_copy(const char *text, size_t length) {
  char *copy = strndup(text, length);
  if (copy == NULL) {
    abort();
  }
  return copy;
}

void *emit_grow(void *list, int count, size_t size) {
  bool is_power = (count & (count - 1)) == 0;
  if (!is_power) {
    return list;
  }
  void *grown = realloc(list, (count > 0 ? 2 * (size_t)count : 1) * size);
  if (grown == NULL) {
    abort();
  }
  return grown;
}

void emit_stream_open(emit_stream *s) {
  s->out = open_memstream(&s->text, &s->size);
  if (s->out == NULL) {
    abort();
  }
}

char *emit_stream_close(emit_stream *s) {
  fclose(s->out);
  return s->text;
}

void emit_init(emitter *e, const sepax_design *design, const char *command) {
  *e = (emitter){.design = design};
  snprintf(e->command, sizeof e->command, "%s", command);
}

static void free_module(emit_module *m) {
  if (m->text != NULL) {
    fclose(m->text);
  }
  for (int i = 0; i < m->symbols; i++) {
    free(m->symbol[i].width);
    free(m->symbol[i].value);
    free(m->symbol[i].about);
  }
  free(m->symbol);
  free(m->verilog);
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
  free(e->module);
  free(e->variant);
  e->module = NULL;
  e->variant = NULL;
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

emit_module *emit_new_module(emitter *e, const char *name, const char *banner) {
  emit_module *m = calloc(1, sizeof *m);
  if (m == NULL) {
    abort();
  }
  m->emitter = e;
  snprintf(m->name, sizeof m->name, "%s", name);
  m->banner = emit_copy(banner, strlen(banner));
  m->text = open_memstream(&m->body, &m->body_size);
  if (m->text == NULL) {
    abort();
  }
  if (strlen(name) >= EMIT_NAME) {
    emit_refuse(m, "a module's name has at most %d characters", EMIT_NAME - 1);
  }
  e->module = emit_grow(e->module, e->modules, sizeof(emit_module *));
  e->module[e->modules++] = m;
  return m;
}

const emit_module *emit_find(const emitter *e, const char *name) {
  for (int i = 0; i < e->modules; i++) {
    if (strcmp(e->module[i]->name, name) == 0) {
      return e->module[i];
    }
  }
  return NULL;
}

emit_symbol *emit_declare(emit_module *m, emit_kind kind, const char *name) {
  if (strlen(name) >= EMIT_NAME) {
    emit_refuse(m, "'%s' has more than %d characters", name, EMIT_NAME - 1);
    return NULL;
  }
  for (int i = 0; i < m->symbols; i++) {
    if (strcmp(m->symbol[i].name, name) == 0) {
      emit_refuse(m, "'%s' is declared twice", name);
      return NULL;
    }
  }
  m->symbol = emit_grow(m->symbol, m->symbols, sizeof m->symbol[0]);
  emit_symbol *s = &m->symbol[m->symbols++];
  *s = (emit_symbol){.kind = kind};
  snprintf(s->name, sizeof s->name, "%s", name);
  return s;
}

bool emit_is_port(const emit_symbol *s) {
  return s->kind == EMIT_INPUT || s->kind == EMIT_OUTPUT || s->kind == EMIT_OUTPUT_REG;
}
