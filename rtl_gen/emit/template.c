/* template.c - Verilog files with holes become modules. */
#include "template.h"
#include "check.h"

#include <stdarg.h>
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
      return h->text;
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

static void fill_holes(const filler *f, const char *line, FILE *out) {
  while (*line != '\0') {
    size_t length = *line == '@' ? strspn(line + 1, name_characters) : 0;
    if (length > 0 && line[length + 1] == '@') {
      fputs(hole_text(f, line + 1, length), out);
      line += length + 2;
    } else {
      fputc(*line++, out);
    }
  }
  fputc('\n', out);
}

static void fill_line(filler *f, char *line, FILE *out) {
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

static char *fill(filler *f, const char *text) {
  emit_stream filled;
  emit_stream_open(&filled);
  while (*text != '\0') {
    size_t length = strcspn(text, "\n");
    char *line = emit_copy(text, length);
    fill_line(f, line, filled.out);
    free(line);
    text += length + (text[length] == '\n');
  }
  if (f->depth > 0) {
    emit_refuse(f->m, "//@ if without //@ end");
  }
  return emit_stream_close(&filled);
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
  if (e->error.text[0] != '\0') {
    return false;
  }
  emit_module *m = emit_new_module(e, name);
  filler f = {.m = m, .holes = holes, .keeps = {true}};
  char *filled = fill(&f, text);
  const char *module = filled;
  check_columns(m, filled);
  while (strncmp(module, "//", 2) == 0) {
    module += strcspn(module, "\n");
    module += *module == '\n';
  }
  m->banner = emit_copy(filled, (size_t)(module - filled));
  m->verilog = emit_copy(module + strspn(module, "\n"), strlen(module));
  free(filled);
  reader r;
  reader_open(&r, m, m->verilog);
  reader_expect(&r, "module");
  reader_expect_name(&r, m->name);
  reader_close(&r);
  return e->error.text[0] == '\0' && emit_check(m);
}

bool emit_template(emitter *e, const char *name, const emit_hole *holes) {
  const emit_template_file *found = NULL;
  int count = 0;
  for (const emit_template_file *file = emit_templates; file->path != NULL; file++) {
    const char *base = strrchr(file->path, '/') + 1;
    if (strcmp(file->path, name) == 0 || strcmp(base, name) == 0) {
      found = file;
      count++;
    }
  }
  if (count == 1) {
    return emit_template_text(e, name, found->text, holes);
  }
  emit_module *m = emit_new_module(e, name);
  return emit_refuse(m,
                     count == 0 ? "no such template" : "a template of several folders; say which");
}

static void take(emit_holes *h, const char *name, emit_stream *text) {
  int i = 0;
  while (i < h->count && strcmp(h->hole[i].name, name) != 0) {
    i++;
  }
  if (i == h->count) {
    h->hole = emit_grow(h->hole, h->count + 1, sizeof *h->hole);
    h->hole[++h->count] = (emit_hole){NULL, NULL};
  } else {
    free((char *)h->hole[i].text);
  }
  char *all = emit_stream_close(text);
  if (text->size > 0 && all[text->size - 1] == '\n') {
    all[text->size - 1] = '\0';
  }
  h->hole[i] = (emit_hole){name, all};
}

FILE *emit_hole_open(emit_holes *h, const char *name) {
  emit_hole_close(h);
  h->open = name;
  emit_stream_open(&h->text);
  return h->text.out;
}

void emit_hole_close(emit_holes *h) {
  if (h->open != NULL) {
    take(h, h->open, &h->text);
    h->open = NULL;
  }
}

void emit_hole_set(emit_holes *h, const char *name, const char *format, ...) {
  emit_stream text;
  emit_stream_open(&text);
  va_list args;
  va_start(args, format);
  vfprintf(text.out, format, args);
  va_end(args);
  take(h, name, &text);
}

void emit_hole_numbers(emit_holes *h, const emit_number *row) {
  for (; row->name != NULL; row++) {
    emit_hole_set(h, row->name, "%lld", (long long)row->number);
  }
}

void emit_holes_free(emit_holes *h) {
  for (int i = 0; i < h->count; i++) {
    free((char *)h->hole[i].text);
  }
  free(h->hole);
  *h = (emit_holes){0};
}
