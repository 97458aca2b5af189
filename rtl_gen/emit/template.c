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
  int count;
  bool keeps[DEPTH]; /* of the conditions around a line: its branch stays */
  int depth;
} filler;

static const char *hole_text(filler *f, const char *name, size_t length) {
  for (int i = 0; i < f->count; i++) {
    if (strlen(f->holes[i].name) == length && memcmp(f->holes[i].name, name, length) == 0) {
      return f->holes[i].text;
    }
  }
  emit_refuse(f->m, "no text for the hole @%.*s@", (int)length, name);
  return "";
}

static bool kept(const filler *f) {
  for (int i = 0; i < f->depth; i++) {
    if (!f->keeps[i]) {
      return false;
    }
  }
  return true;
}

/* "name": is the hole's text neither empty nor "0"? "!name": is it? */
static bool holds(filler *f, const char *name, size_t length) {
  bool negated = length > 0 && name[0] == '!';
  const char *text = hole_text(f, name + negated, length - negated);
  bool set = text[0] != '\0' && strcmp(text, "0") != 0;
  return set != negated;
}

/* "if name", "if !name", "else", "end" behind the mark. */
static void condition(filler *f, const char *words, size_t length) {
  while (length > 0 && words[length - 1] == ' ') {
    length--;
  }
  if (length > 3 && memcmp(words, "if ", 3) == 0 && f->depth < DEPTH) {
    f->keeps[f->depth++] = holds(f, words + 3, length - 3);
  } else if (length == 4 && memcmp(words, "else", 4) == 0 && f->depth > 0) {
    f->keeps[f->depth - 1] = !f->keeps[f->depth - 1];
  } else if (length == 3 && memcmp(words, "end", 3) == 0 && f->depth > 0) {
    f->depth--;
  } else {
    emit_refuse(f->m, "not understood: //@ %.*s", (int)length, words);
  }
}

/* One line with its holes filled, if the condition that it ends with holds. */
static void fill_line(filler *f, const char *line, size_t length, FILE *out) {
  const char *end = line + length;
  const char *mark = strstr(line, "//@ ");
  if (mark != NULL && mark < end) {
    if (!holds(f, mark + 4, (size_t)(end - mark - 4))) {
      return;
    }
    for (end = mark; end > line && end[-1] == ' ';) {
      end--;
    }
  }
  while (line < end) {
    const char *hole = memchr(line, '@', (size_t)(end - line));
    const char *close = hole != NULL ? memchr(hole + 1, '@', (size_t)(end - hole - 1)) : NULL;
    size_t name = close != NULL ? (size_t)(close - hole - 1) : 0;
    bool is_hole = close != NULL && name > 0 &&
                   strspn(hole + 1, "abcdefghijklmnopqrstuvwxyz_0123456789") >= name;
    const char *plain = hole == NULL ? end : is_hole ? hole : hole + 1;
    fwrite(line, 1, (size_t)(plain - line), out);
    line = plain;
    if (is_hole) {
      fputs(hole_text(f, hole + 1, name), out);
      line = close + 1;
    }
  }
  fputc('\n', out);
}

static char *fill(filler *f, const char *text) {
  char *filled = NULL;
  size_t size = 0;
  FILE *out = open_memstream(&filled, &size);
  if (out == NULL) {
    abort();
  }
  while (*text != '\0') {
    size_t length = strcspn(text, "\n");
    size_t indent = strspn(text, " ");
    if (strncmp(text + indent, "//@ ", 4) == 0) {
      condition(f, text + indent + 4, length - indent - 4);
    } else if (kept(f)) {
      fill_line(f, text, length, out);
    }
    text += length + (text[length] == '\n');
  }
  fclose(out);
  if (f->depth > 0) {
    emit_refuse(f->m, "//@ if without //@ end");
  }
  return filled;
}

/* ------------------------------------------------------------------------------ header */

/* The comment behind what was read, on the same line; a comma may stand before it. */
static char *comment_behind(reader *r) {
  const char *at = r->at;
  at += strspn(at, " ");
  at += *at == ',';
  at += strspn(at, " ");
  if (strncmp(at, "//", 2) != 0) {
    reader_refuse(r, "no comment behind a parameter or port", "");
    return emit_copy("", 0);
  }
  at += 2 + (at[2] == ' ');
  return emit_copy(at, strcspn(at, "\n"));
}

/* The text up to a comma, a closing parenthesis or bracket of its own, or the line's end. */
static char *expression_text(reader *r, const char *ends) {
  reader_skip(r);
  const char *begin = r->at;
  int open = 0;
  while (r->at < r->end && (open > 0 || strchr(ends, *r->at) == NULL) && *r->at != '\n' &&
         strncmp(r->at, "//", 2) != 0) {
    open += *r->at == '(';
    open -= *r->at == ')';
    r->at++;
  }
  const char *end = r->at;
  while (end > begin && end[-1] == ' ') {
    end--;
  }
  return emit_copy(begin, (size_t)(end - begin));
}

static emit_symbol *declare(reader *r, emit_module *m, emit_kind kind) {
  char name[EMIT_NAME] = "";
  if (!reader_take_name(r, name)) {
    reader_refuse(r, "a name is missing", "");
  }
  emit_symbol *s = emit_declare(m, kind, name);
  r->failed = r->failed || s == NULL;
  return s;
}

static void read_parameter(reader *r, emit_module *m) {
  reader_expect(r, "parameter");
  reader_take(r, "integer");
  emit_symbol *s = declare(r, m, EMIT_PARAMETER);
  reader_expect(r, "=");
  if (!r->failed) {
    s->value = expression_text(r, ",)");
    s->about = comment_behind(r);
  }
}

static void read_port(reader *r, emit_module *m) {
  emit_kind kind = EMIT_INPUT;
  if (!reader_take(r, "input")) {
    reader_expect(r, "output");
    kind = EMIT_OUTPUT;
  }
  if (!reader_take(r, "wire") && kind == EMIT_OUTPUT && reader_take(r, "reg")) {
    kind = EMIT_OUTPUT_REG;
  }
  bool is_signed = reader_take(r, "signed");
  char *width = NULL;
  if (reader_take(r, "[")) {
    char *msb = expression_text(r, ":]");
    size_t length = strlen(msb) + 8;
    width = malloc(length);
    if (width == NULL) {
      abort();
    }
    snprintf(width, length, "(%s)+1", msb);
    free(msb);
    reader_expect(r, ":");
    reader_expect(r, "0");
    reader_expect(r, "]");
  }
  emit_symbol *s = declare(r, m, kind);
  if (r->failed) {
    free(width);
    return;
  }
  s->is_signed = is_signed;
  s->width = width != NULL ? width : emit_copy("", 0);
  s->about = comment_behind(r);
}

/* A list of parameters or ports behind its parenthesis. */
static void read_list(reader *r, emit_module *m, void (*read)(reader *, emit_module *)) {
  if (reader_take(r, ")")) {
    return;
  }
  do {
    read(r, m);
  } while (!r->failed && reader_take(r, ","));
  reader_expect(r, ")");
}

/* -------------------------------------------------------------------------- the module */

/* The comment at the file's beginning, without its slashes, up to the first other line. */
static char *read_banner(const char **text) {
  char *banner = NULL;
  size_t size = 0;
  FILE *out = open_memstream(&banner, &size);
  if (out == NULL) {
    abort();
  }
  while (strncmp(*text, "//", 2) == 0) {
    const char *line = *text + 2 + ((*text)[2] == ' ');
    size_t length = strcspn(line, "\n");
    fprintf(out, "%.*s\n", (int)length, line);
    *text = line + length + (line[length] == '\n');
  }
  fclose(out);
  if (size > 0) {
    banner[size - 1] = '\0';
  }
  return banner;
}

static void check_columns(const emit_module *m, const char *text) {
  for (; *text != '\0'; text += strcspn(text, "\n"), text += *text == '\n') {
    size_t length = strcspn(text, "\n");
    if (length > COLUMNS) {
      emit_refuse(m, "a line of more than %d columns: %.60s", COLUMNS, text);
    }
  }
}

/* Header, body, and nothing behind them. */
static void split_module(emit_module *m, const char *text) {
  reader r;
  reader_open(&r, m, text, strlen(text));
  const char *begin = text + strspn(text, "\n"); /* with attributes of the module */
  reader_skip(&r);
  reader_expect(&r, "module");
  reader_take_name(&r, m->name);
  if (reader_take(&r, "#(")) {
    read_list(&r, m, read_parameter);
  }
  reader_expect(&r, "(");
  read_list(&r, m, read_port);
  reader_expect(&r, ";");
  const char *end = strstr(r.at, "\nendmodule");
  if (!r.failed && end == NULL) {
    reader_refuse(&r, "expected", "endmodule");
  }
  if (!r.failed) {
    m->header = emit_copy(begin, (size_t)(r.at - begin));
    fwrite(r.at, 1, (size_t)(end - r.at), m->text);
    r.at = end + strlen("\nendmodule");
    reader_skip(&r);
    if (r.at < r.end) {
      reader_refuse(&r, "text behind the module", "");
    }
  }
  fflush(m->text);
  reader_close(&r);
}

bool emit_template_text(emitter *e, const char *name, const char *text, const emit_hole *holes) {
  if (e->error.text[0] != '\0') {
    return false;
  }
  emit_module *m = emit_new_module(e, name, "");
  filler f = {.m = m, .holes = holes};
  while (holes != NULL && holes[f.count].name != NULL) {
    f.count++;
  }
  char *filled = fill(&f, text);
  const char *rest = filled;
  check_columns(m, filled);
  free(m->banner);
  m->banner = read_banner(&rest);
  m->name[0] = '\0'; /* what the text says */
  if (e->error.text[0] == '\0') {
    split_module(m, rest);
  }
  free(filled);
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
  emit_module *m = emit_new_module(e, name, "");
  return emit_refuse(m,
                     count == 0 ? "no such template" : "a template of several folders; say which");
}

void emit_hole_take(emit_holes *h, const char *name, emit_stream *text) {
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
  h->hole[i] = (emit_hole){name, emit_stream_close(text)};
}

void emit_hole_set(emit_holes *h, const char *name, const char *format, ...) {
  emit_stream text;
  emit_stream_open(&text);
  va_list args;
  va_start(args, format);
  vfprintf(text.out, format, args);
  va_end(args);
  emit_hole_take(h, name, &text);
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
  *h = (emit_holes){NULL, 0};
}
