/* tree.c - see tree.h. */
#include "tree.h"
#include "text.h"

#include <ctype.h>
#include <stdbool.h>
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

static const char *parse_value(node *n, const char *p) {
  const char *start = ++p;
  bool quoted = false;
  while (*p != '\0' && (quoted || (*p != ';' && *p != '\n' && *p != '}'))) {
    quoted ^= *p++ == '"';
  }
  n->value = tree_trimmed(start, p);
  n->from = start;
  n->to = p;
  return p;
}

static const char *parse_args(node *n, const char *p) {
  const char *start = ++p;
  bool quoted = false;
  while (*p != '\0' && (quoted || *p != ')')) {
    quoted ^= *p++ == '"';
  }
  n->args = tree_trimmed(start, p);
  n->from = start;
  n->to = p;
  return skip(*p == ')' ? p + 1 : p);
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
      p = parse_value(n, p);
    } else if (*p == '(') {
      p = parse_args(n, p);
      if (*p == '{') {
        p = parse_body(n, p + 1);
        p += *p == '}';
      }
    }
  }
  return p;
}

void tree_free(node *n) {
  while (n != NULL) {
    node *next = n->next;
    tree_free(n->child);
    free(n->name);
    free(n->args);
    free(n->value);
    free(n);
    n = next;
  }
}

const node *tree_child(const node *n, const char *name) {
  for (n = n->child; n != NULL && strcmp(n->name, name) != 0; n = n->next) {}
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

node *tree_read(char *text) {
  node *top = text_alloc(1, sizeof *top);
  blank_comments(text);
  parse_body(top, text);
  if (tree_child(top, "library") == NULL) {
    text_fail("is no", "Liberty file");
  }
  return top;
}
