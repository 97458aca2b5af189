/* SPDX-License-Identifier: MIT */
/* template.c - Verilog files with holes become modules. */
#include "template.h"

#include "check.h"
#include "util/list.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { DEPTH = 16, COLUMNS = 100 };

typedef struct {
  emit_module *m;
  const emit_hole *holes;
  bool keeps[DEPTH + 1]; /* the lines in so many conditions */
  int depth;
} filler;

static const char *hole_text(const filler *f, const char *name, size_t length) {
  for (const emit_hole *h = f->holes; h != NULL && h->name != NULL; h++) {
    if (strncmp(h->name, name, length) == 0 && h->name[length] == '\0') {
      if (h->text == NULL) {
        emit_no_memory(f->m->emitter);
      }
      return h->text != NULL ? h->text : "";
    }
  }
  emit_refuse(f->m, "no text for the hole @%.*s@", (int)length, name);
  return "";
}

/* "name": is the hole's text neither empty nor "0"? "!name": is it? */
static bool holds(const filler *f, const char *name) {
  bool negated = name[0] == '!';
  const char *text = hole_text(f, name + negated, strlen(name + negated));
  bool set = text[0] != '\0' && strcmp(text, "0") != 0;
  return set != negated;
}

/* "if name", "if !name", "else", "end" behind the mark. */
static void condition(filler *f, const char *words) {
  bool *keeps = &f->keeps[f->depth];
  if (strncmp(words, "if ", 3) == 0 && f->depth < DEPTH) {
    keeps[1] = holds(f, words + 3) && keeps[0];
    f->depth++;
  } else if (strcmp(words, "else") == 0 && f->depth > 0) {
    keeps[0] = keeps[-1] && !keeps[0];
  } else if (strcmp(words, "end") == 0 && f->depth > 0) {
    f->depth--;
  } else {
    emit_refuse(f->m, "not understood: //@ %s", words);
  }
}

static const char name_characters[] = "abcdefghijklmnopqrstuvwxyz_0123456789";

static void fill_holes(const filler *f, const char *line, emit_text *out) {
  while (*line != '\0') {
    size_t length = *line == '@' ? strspn(line + 1, name_characters) : 0;
    if (length > 0 && line[length + 1] == '@') {
      text_puts(out, hole_text(f, line + 1, length));
      line += length + 2;
    } else {
      text_putc(out, *line++);
    }
  }
  text_putc(out, '\n');
}

static void fill_line(filler *f, char *line, emit_text *out) {
  char *mark = strstr(line, "//@ ");
  if (mark != NULL && mark == line + strspn(line, " ")) {
    condition(f, mark + 4);
  } else if (f->keeps[f->depth] && (mark == NULL || holds(f, mark + 4))) {
    while (mark != NULL && mark[-1] == ' ') {
      mark--;
    }
    if (mark != NULL) {
      *mark = '\0';
    }
    fill_holes(f, line, out);
  }
}

/* The template without its holes; NULL, and the error is set, without memory. */
static char *fill(filler *f, const char *text) {
  emit_text filled = {NULL};
  emit_text line = {NULL};
  while (*text != '\0') {
    size_t length = strcspn(text, "\n");
    line.length = 0;
    text_put(&line, text, length);
    if (line.failed) {
      break;
    }
    fill_line(f, line.bytes, &filled);
    text += length + (text[length] == '\n');
  }
  if (f->depth > 0) {
    emit_refuse(f->m, "//@ if without //@ end");
  }
  filled.failed = filled.failed || line.failed;
  free(line.bytes);
  return text_take(&filled);
}

/* -------------------------------------------------------------------------- the module */

static void check_columns(const emit_module *m, const char *text) {
  for (; *text != '\0'; text += strcspn(text, "\n"), text += *text == '\n') {
    size_t length = strcspn(text, "\n");
    if (length > COLUMNS) {
      emit_refuse(m, "a line of more than %d columns: %.60s", COLUMNS, text);
    }
  }
}

bool emit_template_text(emitter *e, const char *name, const char *text, const emit_hole *holes) {
  emit_module *m = emit_works(e) ? emit_new_module(e, name) : NULL;
  if (m == NULL) {
    return false;
  }
  filler f = {.m = m, .holes = holes, .keeps = {true}};
  char *filled = fill(&f, text);
  const char *module = filled;
  if (filled == NULL) {
    return emit_no_memory(e);
  }
  check_columns(m, filled);
  while (strncmp(module, "//", 2) == 0) {
    module += strcspn(module, "\n");
    module += *module == '\n';
  }
  m->banner = strndup(filled, (size_t)(module - filled));
  m->verilog = strdup(module + strspn(module, "\n"));
  free(filled);
  if (m->banner == NULL || m->verilog == NULL) {
    return emit_no_memory(e);
  }
  reader r;
  reader_open(&r, m, m->verilog);
  reader_expect(&r, "module");
  reader_expect_name(&r, m->name);
  reader_close(&r);
  return emit_works(e) && emit_check(m);
}

/* The file of this name; NULL, and the error is set, unless there is just one. */
static const emit_template_file *find_file(emitter *e, const char *name) {
  const emit_template_file *found = NULL;
  int count = 0;
  for (const emit_template_file *file = emit_templates; file->path != NULL; file++) {
    const char *base = strrchr(file->path, '/') + 1;
    if (strcmp(file->path, name) == 0 || strcmp(base, name) == 0) {
      found = file;
      count++;
    }
  }
  if (count != 1) {
    emit_fail(e, SEPAX_ERROR_ARGUMENT, "generator refuses %s: %s", name,
              count == 0 ? "no such template" : "a template of several folders; say which");
    return NULL;
  }
  return found;
}

bool emit_template(emitter *e, const char *name, const emit_hole *holes) {
  const emit_template_file *file = find_file(e, name);
  return file != NULL && emit_template_text(e, name, file->text, holes);
}

bool emit_fill(emitter *e, const char *name, const emit_hole *holes, emit_text *out) {
  const emit_template_file *file = find_file(e, name);
  emit_module m = {.emitter = e};
  snprintf(m.name, sizeof m.name, "%s", name);
  filler f = {.m = &m, .holes = holes, .keeps = {true}};
  char *filled = file != NULL && emit_works(e) ? fill(&f, file->text) : NULL;
  if (filled == NULL) {
    emit_no_memory(e);
  } else {
    check_columns(&m, filled);
    text_puts(out, filled);
  }
  free(filled);
  return emit_works(e);
}

void emit_hole_take(emit_holes *h, const char *name, emit_text *text) {
  size_t i = 0;
  while (i < h->count && strcmp(h->hole[i].name, name) != 0) {
    i++;
  }
  if (text->length > 0 && text->bytes[text->length - 1] == '\n') {
    text->bytes[--text->length] = '\0';
  }
  char *all = text_take(text);
  if (i == h->count) {
    emit_hole *list = list_grow(h->hole, &h->space, h->count + 1, sizeof *h->hole);
    if (list == NULL) {
      free(all);
      return;
    }
    h->hole = list;
    h->hole[++h->count] = (emit_hole){NULL, NULL};
  } else {
    free((char *)h->hole[i].text);
  }
  h->hole[i] = (emit_hole){name, all};
}

emit_text *emit_hole_open(emit_holes *h, const char *name) {
  emit_hole_close(h);
  h->open = name;
  return &h->text;
}

void emit_hole_close(emit_holes *h) {
  if (h->open != NULL) {
    emit_hole_take(h, h->open, &h->text);
    h->open = NULL;
  }
}

void emit_hole_set(emit_holes *h, const char *name, const char *format, ...) {
  emit_text text = {NULL};
  va_list args;
  va_start(args, format);
  text_vprintf(&text, format, args);
  va_end(args);
  emit_hole_take(h, name, &text);
}

void emit_hole_numbers(emit_holes *h, const emit_number *row) {
  for (; row->name != NULL; row++) {
    emit_hole_set(h, row->name, "%lld", (long long)row->number);
  }
}

void emit_holes_free(emit_holes *h) {
  for (size_t i = 0; i < h->count; i++) {
    free((char *)h->hole[i].text);
  }
  free(h->hole);
  free(h->text.bytes);
  *h = (emit_holes){0};
}
