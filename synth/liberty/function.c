/* SPDX-License-Identifier: MIT */
/* function.c - see function.h; and how likely each row is. */
#include "function.h"
#include "text.h"
#include "tree.h"

#include <ctype.h>
#include <string.h>

typedef struct {
  const char *p;
  const lib_cell *cell;
  char *const *state;
} parser;

int lib_pin_index(const lib_cell *cell, const char *name) {
  for (int k = 0; k < cell->pins; k++) {
    if (strcmp(cell->pin[k].name, name) == 0) {
      return k;
    }
  }
  return -1;
}

uint64_t function_column(int k) {
  static const uint64_t column[LIB_INPUTS] = {
      UINT64_C(0xaaaaaaaaaaaaaaaa), UINT64_C(0xcccccccccccccccc), UINT64_C(0xf0f0f0f0f0f0f0f0),
      UINT64_C(0xff00ff00ff00ff00), UINT64_C(0xffff0000ffff0000), UINT64_C(0xffffffff00000000)};
  return column[k];
}

/* Is one of these characters next, behind blanks? */
static bool is_next(parser *s, const char *characters) {
  while (isspace((unsigned char)*s->p)) {
    s->p++;
  }
  return *s->p != '\0' && strchr(characters, *s->p) != NULL;
}

static bool accept(parser *s, const char *characters) {
  bool found = is_next(s, characters);
  s->p += found;
  return found;
}

static uint64_t parse_name(parser *s) {
  const char *start = s->p;
  while (isalnum((unsigned char)*s->p) || *s->p == '_') {
    s->p++;
  }
  char *name = tree_copy(start, (size_t)(s->p - start));
  int pin = lib_pin_index(s->cell, name);
  if (pin >= 0) {
    return s->cell->pin[pin].rows;
  }
  if (strcmp(name, "0") == 0 || strcmp(name, "1") == 0) {
    return *name == '1' ? ~UINT64_C(0) : 0;
  }
  for (int k = 0; k < 2; k++) {
    if (s->state[k] != NULL && strcmp(name, s->state[k]) == 0) {
      uint64_t column = s->cell->latch ? s->cell->next : function_column(s->cell->inputs);
      return k == 0 ? column : ~column;
    }
  }
  text_fail("unknown operand in a function of", s->cell->name);
}

static uint64_t parse_or(parser *s);

static uint64_t parse_factor(parser *s) {
  if (accept(s, "!")) {
    return ~parse_factor(s);
  }
  uint64_t value;
  if (accept(s, "(")) {
    value = parse_or(s);
    if (!accept(s, ")")) {
      text_fail("a bracket is missing in a function of", s->cell->name);
    }
  } else {
    value = parse_name(s);
  }
  while (accept(s, "'")) {
    value = ~value;
  }
  return value;
}

static uint64_t parse_xor(parser *s) {
  uint64_t value = parse_factor(s);
  while (accept(s, "^")) {
    value ^= parse_factor(s);
  }
  return value;
}

/* Operands that stand beside each other are an AND, too. */
static uint64_t parse_and(parser *s) {
  uint64_t value = parse_xor(s);
  while (accept(s, "&*") || (!is_next(s, ")+|") && *s->p != '\0')) {
    value &= parse_xor(s);
  }
  return value;
}

static uint64_t parse_or(parser *s) {
  uint64_t value = parse_and(s);
  while (accept(s, "|+")) {
    value |= parse_and(s);
  }
  return value;
}

uint64_t function_rows(const lib_cell *cell, const char *text, char *const state[2]) {
  parser s = {text, cell, state};
  uint64_t rows = parse_or(&s);
  if (*s.p != '\0') {
    text_fail("a function is not understood, of", cell->name);
  }
  return rows;
}

int lib_rows(const lib_cell *cell, const double one[], double one_state, double differ,
             double row[64]) {
  int rows = 1 << (cell->inputs + cell->register_);
  bool follows = false;
  for (int k = 0; k < cell->pins; k++) {
    follows |= cell->register_ && !cell->pin[k].output && cell->pin[k].rows == cell->next;
  }
  for (int r = 0; r < rows; r++) {
    bool state = (r >> cell->inputs & 1) != 0;
    double p = cell->register_ && !follows ? state ? one_state : 1 - one_state : 1;
    for (int k = 0; k < cell->pins; k++) {
      if (cell->pin[k].output) {
        continue;
      }
      bool bit = (cell->pin[k].rows >> r & 1) != 0;
      if (!follows || cell->pin[k].rows != cell->next) {
        p *= bit ? one[k] : 1 - one[k];
        continue;
      }
      double sum = state == bit ? 1 - differ + (bit ? 1 : -1) * (one[k] + one_state - 1)
                                : differ + (bit ? 1 : -1) * (one[k] - one_state);
      p *= sum > 0 ? sum / 2 : 0;
    }
    row[r] = p;
  }
  return rows;
}
