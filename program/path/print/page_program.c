/* SPDX-License-Identifier: MIT */
/* page_program.c - the part of a page about the program that a path comes from. */
#include "report/json.h"
#include "path/print/page.h"

#include <stdlib.h>
#include <string.h>

int path_page_put(const char *text, size_t length, void *context) {
  FILE *out = context;
  for (size_t n = 0; n < length; n++) {
    if (text[n] == '<' || text[n] == '>' || text[n] == '&') {
      fprintf(out, "\\u%04x", (unsigned)text[n]);
    } else {
      putc(text[n], out);
    }
  }
  return 0;
}

static void write_number(FILE *out, size_t name) {
  fprintf(out, name == FORMAT_NO_NAME ? ", -1" : ", %zu", name);
}

/* Write a text as JSON. Bytes that are not UTF-8 become '?'. */
static void write_text(FILE *out, const char *text, size_t size) {
  json_t *json = json_stringn(text, size);
  if (json == NULL) {
    char *plain = malloc(size + 1);
    for (size_t n = 0; n < size && plain != NULL; n++) {
      plain[n] = (unsigned char)text[n] < 0x80 ? text[n] : '?';
    }
    json = plain != NULL ? json_stringn(plain, size) : NULL;
    free(plain);
  }
  if (json == NULL ||
      json_dump_callback(json, path_page_put, out, JSON_ENSURE_ASCII | JSON_ENCODE_ANY) != 0) {
    fputs("null", out);
  }
  json_decref(json);
}

/* The text of a program, if the file is there; the page says so if it is not. */
static void write_source(FILE *out, const format_motion *motion, size_t name) {
  text_bytes text;
  sepax_error error = {0};
  bool is_file = false;
  for (size_t n = 0; n < motion->lines && !is_file; n++) {
    is_file = motion->step[n].file == name;
  }
  if (!is_file || !sepax__text_read(&text, motion->name[name], PATH_PAGE_TEXT, &error)) {
    fputs("null", out);
    return;
  }
  write_text(out, text.bytes, text.size);
  sepax_release(text.bytes);
}

/* The step that a moment of the page belongs to. */
static const format_step *step_at(const page *p, size_t n) {
  return &p->scene->motion.step[p->step[n].line + (p->step[n].part > 0)];
}

static bool is_same_step(const format_step *a, const format_step *b) {
  return a->file == b->file && a->line == b->line && a->kind == b->kind && a->tool == b->tool;
}

/* Write the steps as [number of moments in a row, file, line, kind, tool]. */
static void write_steps(FILE *out, const page *p) {
  size_t first = 0;
  for (size_t n = 1; n <= p->steps; n++) {
    const format_step *step = step_at(p, first);
    if (n < p->steps && is_same_step(step, step_at(p, n))) {
      continue;
    }
    fprintf(out, "%s[%zu", first > 0 ? ", " : "", n - first);
    write_number(out, step->file);
    fprintf(out, ", %zu, %d", step->line, (int)step->kind);
    write_number(out, step->tool);
    putc(']', out);
    first = n;
  }
}

void path_page_program(FILE *out, const page *p) {
  const format_motion *motion = &p->scene->motion;
  fputs(",\n\"program\": ", out);
  if (motion->step == NULL) {
    fputs("null", out);
    return;
  }
  fputs("{\"kinds\": [", out);
  for (int k = 0; k < FORMAT_KINDS; k++) {
    fprintf(out, "%s\"%s\"", k > 0 ? ", " : "", format_kind_names[k]);
  }
  for (int texts = 0; texts < 2; texts++) {
    fputs(texts > 0 ? "], \"text\": [" : "], \"name\": [", out);
    for (size_t n = 0; n < motion->names; n++) {
      fputs(n > 0 ? ", " : "", out);
      if (texts > 0) {
        write_source(out, motion, n);
      } else {
        write_text(out, motion->name[n], strlen(motion->name[n]));
      }
    }
  }
  fputs("],\n\"run\": [", out);
  write_steps(out, p);
  fputs("]}", out);
}
