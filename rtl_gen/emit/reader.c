/* reader.c - tokens, names and scopes of the text that is checked. */
#include "check.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

void reader_open(reader *r, const emit_module *m, const char *text, size_t size) {
  *r = (reader){.m = m, .begin = text, .at = text, .end = text + size};
  for (int i = 0; i < CHECK_BUCKETS; i++) {
    r->bucket[i] = -1;
  }
}

void reader_close(reader *r) { free(r->name); }

void reader_refuse(reader *r, const char *what, const char *name) {
  if (!r->failed) {
    r->failed = true;
    const char *line = r->at;
    while (line > r->begin && line[-1] != '\n') {
      line--;
    }
    line += strspn(line, " ");
    int length = (int)strcspn(line, "\n");
    bool named = name[0] != '\0';
    char quoted[EMIT_NAME + 4] = "";
    if (named) {
      snprintf(quoted, sizeof quoted, " '%.*s'", EMIT_NAME, name);
    }
    emit_refuse(r->m, "%s%s in: %.*s", what, quoted, length < 120 ? length : 120, line);
  }
  r->at = r->end;
}

static bool starts(const reader *r, const char *text) {
  size_t length = strlen(text);
  return (size_t)(r->end - r->at) >= length && memcmp(r->at, text, length) == 0;
}

static void skip_to(reader *r, const char *text) {
  while (r->at < r->end && !starts(r, text)) {
    r->at++;
  }
}

static void directive(reader *r) {
  if (starts(r, "`ifdef FORMAL")) {
    r->formal = true;
  } else if (starts(r, "`endif")) {
    r->formal = false;
  }
  skip_to(r, "\n");
}

void reader_skip(reader *r) {
  while (r->at < r->end) {
    if (isspace((unsigned char)*r->at)) {
      r->at++;
    } else if (*r->at == '`') {
      directive(r);
    } else if (starts(r, "//")) {
      skip_to(r, "\n");
    } else if (starts(r, "/*") || (starts(r, "(*") && !starts(r, "(*)"))) {
      skip_to(r, *r->at == '/' ? "*/" : "*)");
      r->at += r->at < r->end ? 2 : 0;
    } else {
      return;
    }
  }
}

static bool is_name_character(char c) { return isalnum((unsigned char)c) || c == '_'; }

bool reader_take(reader *r, const char *token) {
  reader_skip(r);
  size_t length = strlen(token);
  if (!starts(r, token)) {
    return false;
  }
  bool word = is_name_character(token[length - 1]);
  if (word && r->at + length < r->end && is_name_character(r->at[length])) {
    return false;
  }
  r->at += length;
  return true;
}

bool reader_next_is(reader *r, const char *token) {
  reader_skip(r);
  const char *at = r->at;
  bool found = reader_take(r, token);
  r->at = at;
  return found;
}

void reader_expect(reader *r, const char *token) {
  if (!r->failed && !reader_take(r, token)) {
    reader_refuse(r, "expected", token);
  }
}

bool reader_take_name(reader *r, char name[EMIT_NAME]) {
  reader_skip(r);
  size_t length = 0;
  while (r->at + length < r->end && is_name_character(r->at[length])) {
    length++;
  }
  if (length == 0 || isdigit((unsigned char)*r->at)) {
    return false;
  }
  if (length >= EMIT_NAME) {
    reader_refuse(r, "a name is too long", "");
    return false;
  }
  memcpy(name, r->at, length);
  name[length] = '\0';
  r->at += length;
  return true;
}

/* ---------------------------------------------------------------------------- names */

static unsigned bucket_of(const char *name) {
  unsigned hash = 5381;
  for (; *name != '\0'; name++) {
    hash = 33 * hash + (unsigned char)*name;
  }
  return hash % CHECK_BUCKETS;
}

check_name *reader_find(reader *r, const char *name) {
  for (int i = r->bucket[bucket_of(name)]; i >= 0; i = r->name[i].next) {
    if (strcmp(r->name[i].name, name) == 0) {
      return &r->name[i];
    }
  }
  return NULL;
}

/* Words of Verilog and SystemVerilog that a module's author might take for a name. */
static const char reserved[] =
    " alias and assign assume automatic before bind bins bit break buf byte cell checker"
    " class config const context continue cover cross deassign default design disable"
    " dist do edge end enum event expect export extends extern final first_match for"
    " force fork generate global import include initial inside int interface join let"
    " library local logic longint matches modport nand new nor not null or package packed"
    " primitive priority program property protected pull0 pull1 pure rand real ref"
    " release repeat restrict return sequence shortint small solve specify static string"
    " strong struct super table tagged task this throughout time tran tri type typedef"
    " union unique untyped use uwire var vectored virtual void wait weak while wildcard"
    " with within wor xnor xor ";

static bool is_reserved(const char *name) {
  char word[EMIT_NAME + 2];
  snprintf(word, sizeof word, " %s ", name);
  return strstr(reserved, word) != NULL;
}

check_name *reader_declare(reader *r, name_kind kind, const char *name, int width) {
  const check_name *found = reader_find(r, name);
  if (found != NULL && found - r->name >= r->scope) {
    char what[EMIT_NAME + 32];
    snprintf(what, sizeof what, "'%s' is declared twice", name);
    reader_refuse(r, what, "");
  }
  if (is_reserved(name)) {
    reader_refuse(r, "a word of SystemVerilog as a name:", name);
  }
  int *bucket = &r->bucket[bucket_of(name)];
  r->name = emit_grow(r->name, r->names, sizeof r->name[0]);
  check_name *n = &r->name[r->names];
  *n = (check_name){.kind = kind, .width = width, .next = *bucket};
  snprintf(n->name, sizeof n->name, "%s", name);
  *bucket = r->names++;
  return n;
}

int reader_enter(reader *r) {
  int outer = r->scope;
  r->scope = r->names;
  return outer;
}

void reader_leave(reader *r, int outer) {
  while (r->names > r->scope) {
    const check_name *n = &r->name[--r->names];
    r->bucket[bucket_of(n->name)] = n->next;
  }
  r->scope = outer;
}
