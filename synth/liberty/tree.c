/* SPDX-License-Identifier: MIT */
/* tree.c - see tree.h. */
#include "tree.h"
#include "text.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

char *tree_copy(const char *from, size_t length) {
  char *text = text_alloc(length + 1, 1);
  memcpy(text, from, length);
  return text;
}

/* Comments and continued lines become blanks. */
static void blank_comments(char *text) {
  for (char *p = text; *p != '\0'; p++) {
    if (p[0] == '/' && p[1] == '*') {
      char *end = strstr(p + 2, "*/");
      end = end == NULL ? p + strlen(p) : end + 2;
      memset(p, ' ', (size_t)(end - p));
      p = end - 1;
    } else if (p[0] == '\\') {
      *p = ' ';
      while (p[1] == '\r' || p[1] == '\n') {
        *++p = ' ';
      }
    }
  }
}

static const char *skip(const char *p) {
  while (isspace((unsigned char)*p) || *p == ';') {
    p++;
  }
  return p;
}

char *tree_trimmed(const char *from, const char *to) {
  while (from < to && (isspace((unsigned char)*from) || *from == '"')) {
    from++;
  }
  while (to > from && (isspace((unsigned char)to[-1]) || to[-1] == '"')) {
    to--;
  }
  return tree_copy(from, (size_t)(to - from));
}

/* The value or args from p up to one of these characters, but for quoted ones; returns its end. */
static const char *parse_text(node *n, char **text, const char *p, const char *ends) {
  bool quoted = false;
  n->from = p;
  while (*p != '\0' && (quoted || strchr(ends, *p) == NULL)) {
    quoted ^= *p++ == '"';
  }
  n->to = p;
  *text = tree_trimmed(n->from, n->to);
  return p;
}

static const char *parse_body(node *parent, const char *p) {
  node **tail = &parent->child;
  for (p = skip(p); *p != '\0' && *p != '}'; p = skip(p)) {
    const char *start = p;
    while (isalnum((unsigned char)*p) || *p == '_') {
      p++;
    }
    if (p == start) {
      size_t line = strcspn(p, "\n");
      text_fail("is not understood at", tree_copy(p, line < 20 ? line : 20));
    }
    node *n = text_alloc(1, sizeof *n);
    n->name = tree_copy(start, (size_t)(p - start));
    *tail = n;
    tail = &n->next;
    p = skip(p);
    if (*p == ':') {
      p = parse_text(n, &n->value, p + 1, ";\n}");
    } else if (*p == '(') {
      p = parse_text(n, &n->args, p + 1, ")");
      p = skip(*p == ')' ? p + 1 : p);
      if (*p == '{') {
        p = parse_body(n, p + 1);
        p += *p == '}';
      }
    }
  }
  return p;
}

const node *tree_child(const node *n, const char *name) {
  for (n = n->child; n != NULL && strcmp(n->name, name) != 0; n = n->next) {}
  return n;
}

const node *tree_next(const node *n) {
  const char *name = n->name;
  for (n = n->next; n != NULL && strcmp(n->name, name) != 0; n = n->next) {}
  return n;
}

const node *tree_named(const node *n, const char *name, const char *args) {
  for (n = tree_child(n, name); n != NULL && strcmp(n->args, args) != 0; n = tree_next(n)) {}
  return n;
}

const char *tree_value(const node *n, const char *name) {
  const node *c = tree_child(n, name);
  return c == NULL ? NULL : c->value;
}

double tree_number(const node *n, const char *name, double other) {
  const char *value = tree_value(n, name);
  return value == NULL ? other : strtod(value, NULL);
}

const char *tree_clock_gate(const node *cell, const node *pin) {
  static const char *const roles[][2] = {{"clock_gate_clock_pin", "clock"},
                                         {"clock_gate_enable_pin", "enable"},
                                         {"clock_gate_test_pin", "test"},
                                         {"clock_gate_out_pin", "out"}};
  const char *kind = tree_value(cell, "clock_gating_integrated_cell");
  if (kind == NULL || strncmp(kind, "latch_posedge", strlen("latch_posedge")) != 0) {
    return NULL;
  }
  for (size_t k = 0; k < sizeof roles / sizeof roles[0]; k++) {
    const char *value = tree_value(pin, roles[k][0]);
    if (value != NULL && strcmp(value, "true") == 0) {
      return roles[k][1];
    }
  }
  return NULL;
}

double tree_unit(const char *text, double other) {
  static const char prefix[] = "munpf";
  if (text == NULL) {
    return other;
  }
  char *end;
  double number = strtod(text, &end);
  while (*end != '\0' && !isalpha((unsigned char)*end)) {
    end++;
  }
  const char *at = *end == '\0' ? NULL : strchr(prefix, tolower((unsigned char)*end));
  static const double scale[] = {1e-3, 1e-6, 1e-9, 1e-12, 1e-15};
  return at == NULL ? number : number * scale[at - prefix];
}

const node *tree_read(const char *path) {
  text_file = path;
  FILE *in = fopen(path, "r");
  if (in == NULL) {
    text_fail("cannot be read;", "give a plain Liberty file");
  }
  char *text = NULL;
  size_t size = 0;
  if (getdelim(&text, &size, '\0', in) <= 0) {
    text_fail("is", "empty");
  }
  fclose(in);
  blank_comments(text);
  node top = {.from = text};
  parse_body(&top, text);
  const node *library = tree_child(&top, "library");
  if (library == NULL) {
    text_fail("is no", "Liberty file");
  }
  return library;
}
