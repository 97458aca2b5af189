/* SPDX-License-Identifier: MIT */
/* reader.c - tokens, names and scopes of the text that is checked. */
#include "check.h"

#include "util/list.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void reader_open(reader *r, const emit_module *m, const char *text) {
  *r = (reader){.m = m, .begin = text, .at = text, .end = text + strlen(text)};
}

void reader_close(reader *r) { free(r->name); }

static void refuse(reader *r, const char *format, va_list args) {
  if (!r->failed) {
    char what[160];
    const char *line = r->at;
    while (line > r->begin && line[-1] != '\n') {
      line--;
    }
    line += strspn(line, " ");
    int length = (int)strcspn(line, "\n");
    vsnprintf(what, sizeof what, format, args);
    emit_refuse(r->m, "%s in: %.*s", what, length < 120 ? length : 120, line);
  }
  r->failed = true;
  r->at = r->end;
}

void reader_refuse(reader *r, const char *format, ...) {
  va_list args;
  va_start(args, format);
  refuse(r, format, args);
  va_end(args);
}

void reader_fault(reader *r, const char *format, ...) {
  va_list args;
  va_start(args, format);
  if (r->off == 0) {
    refuse(r, format, args);
  }
  va_end(args);
}

void reader_no_memory(reader *r) {
  emit_no_memory(r->m->emitter);
  r->failed = true;
  r->at = r->end;
}

static bool starts(const reader *r, const char *text) {
  return strncmp(r->at, text, strlen(text)) == 0;
}

/* Behind the text, or to the end without it. */
static void skip_behind(reader *r, const char *text) {
  const char *found = strstr(r->at, text);
  r->at = found != NULL ? found + strlen(text) : r->end;
}

void reader_skip(reader *r) {
  for (;;) {
    r->at += strspn(r->at, " \t\r\n");
    if (*r->at == '`') {
      r->formal = starts(r, "`ifdef FORMAL") || (r->formal && !starts(r, "`endif"));
      skip_behind(r, "\n");
    } else if (starts(r, "//")) {
      skip_behind(r, "\n");
    } else if (starts(r, "/*")) {
      skip_behind(r, "*/");
    } else if (starts(r, "(*") && !starts(r, "(*)")) {
      skip_behind(r, "*)");
    } else {
      return;
    }
  }
}

static bool is_name_character(char c) { return isalnum((unsigned char)c) || c == '_'; }

bool reader_take(reader *r, const char *token) {
  reader_skip(r);
  size_t length = strlen(token);
  bool word = is_name_character(token[length - 1]);
  if (!starts(r, token) || (word && is_name_character(r->at[length]))) {
    return false;
  }
  r->at += length;
  return true;
}

void reader_expect(reader *r, const char *token) {
  if (!reader_take(r, token)) {
    reader_refuse(r, "expected '%s'", token);
  }
}

bool reader_is_before(reader *r, const char *token) { return !reader_take(r, token) && !r->failed; }

void reader_list(reader *r, void (*part)(reader *r)) {
  if (!reader_take(r, ")")) {
    do {
      part(r);
    } while (reader_take(r, ","));
    reader_expect(r, ")");
  }
}

bool reader_take_name(reader *r, char name[EMIT_NAME]) {
  reader_skip(r);
  size_t length = 0;
  while (is_name_character(r->at[length]) && !isdigit((unsigned char)*r->at)) {
    length++;
  }
  if (length >= EMIT_NAME) {
    reader_refuse(r, "a name is too long");
    length = 0;
  }
  memcpy(name, r->at, length);
  name[length] = '\0';
  r->at += length;
  return length > 0;
}

void reader_expect_name(reader *r, char name[EMIT_NAME]) {
  if (!reader_take_name(r, name)) {
    reader_refuse(r, "a name is missing");
  }
}

/* ---------------------------------------------------------------------------- names */

check_name *reader_find(reader *r, const char *name) {
  for (int i = r->names - 1; i >= 0; i--) {
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

/* Words of Verilog-AMS, but for its functions of numbers, such as min. */
static const char reserved_ams[] =
    " above absdelay ac_stim access aliasparam analog analysis branch connect connectmodule"
    " connectrules continuous ddt ddt_nature ddx discipline discrete domain driver_update"
    " endconnectrules enddiscipline endnature endparamset exclude final_step flicker_noise"
    " flow from ground idt idt_nature idtmod inf initial_step laplace_nd laplace_np laplace_zd"
    " laplace_zp last_crossing limexp merged nature net_resolution noise_table paramset"
    " potential resolveto slew split timer transition units white_noise wreal zi_nd zi_np"
    " zi_zd zi_zp ";

static bool is_word_of(const char *words, const char *name) {
  char word[EMIT_NAME + 2];
  snprintf(word, sizeof word, " %s ", name);
  return strstr(words, word) != NULL;
}

check_name *reader_declare(reader *r, name_kind kind, const char *name, int width) {
  const check_name *found = reader_find(r, name);
  if (found != NULL && found - r->name >= r->scope) {
    reader_fault(r, "'%s' is declared twice", name);
  }
  if (is_word_of(reserved, name)) {
    reader_fault(r, "a word of SystemVerilog as a name: '%s'", name);
  }
  if (is_word_of(reserved_ams, name)) {
    reader_fault(r, "a word of Verilog-AMS as a name: '%s'", name);
  }
  if (found != NULL && kind == NAME_LABEL && found->kind == NAME_LABEL) {
    reader_fault(r, "'%s' names a block around it, too", name);
  }
  if (kind >= NAME_WIRE && width < 1) {
    reader_fault(r, "no bits in '%s'", name);
  }
  if (r->off > 0) {
    return &r->ignored;
  }
  check_name *list = list_grow(r->name, &r->name_space, (size_t)r->names, sizeof *list);
  if (list == NULL) {
    reader_no_memory(r);
    return &r->ignored;
  }
  r->name = list;
  check_name *n = &r->name[r->names++];
  *n = (check_name){.kind = kind, .width = width};
  snprintf(n->name, sizeof n->name, "%s", name);
  return n;
}

int reader_enter(reader *r) {
  int outer = r->scope;
  r->scope = r->names;
  return outer;
}

void reader_leave(reader *r, int outer) {
  r->names = r->scope;
  r->scope = outer;
}
