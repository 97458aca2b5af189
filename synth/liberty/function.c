/* function.c - the functions of cells' pins: read, evaluated, and how likely each row is. */
#include "function.h"
#include "text.h"
#include "tree.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
  const char *p;
  const lib_cell *cell;
  const char *state, *state_not;
  lib_function *f;
} parser;

int lib_pin_index(const lib_cell *cell, const char *name) {
  for (int k = 0; k < cell->pins; k++) {
    if (strcmp(cell->pin[k].name, name) == 0) {
      return k;
    }
  }
  return -1;
}

static void emit(parser *s, int op) {
  if (s->f->count == LIB_OPS) {
    text_fail("too long a function in", s->cell->name);
  }
  bool operand = op >= 0 || op <= LIB_ZERO;
  s->f->depth += operand ? 1 : op == LIB_NOT ? 0 : -1;
  if (s->f->depth > LIB_DEPTH) {
    text_fail("too deep a function in", s->cell->name);
  }
  s->f->op[s->f->count++] = (short)op;
}

static void blanks(parser *s) {
  while (isspace((unsigned char)*s->p)) {
    s->p++;
  }
}

static void parse_or(parser *s);

static void parse_name(parser *s) {
  const char *start = s->p;
  while (isalnum((unsigned char)*s->p) || *s->p == '_') {
    s->p++;
  }
  char *name = tree_copy(start, (size_t)(s->p - start));
  int pin = lib_pin_index(s->cell, name);
  if (pin >= 0) {
    emit(s, pin);
  } else if (strcmp(name, "0") == 0 || strcmp(name, "1") == 0) {
    emit(s, *name == '1' ? LIB_ONE : LIB_ZERO);
  } else if (s->state != NULL && strcmp(name, s->state) == 0) {
    emit(s, LIB_STATE);
  } else if (s->state_not != NULL && strcmp(name, s->state_not) == 0) {
    emit(s, LIB_STATE_NOT);
  } else {
    text_fail("unknown operand in a function of", s->cell->name);
  }
  free(name);
}

static void parse_factor(parser *s) {
  blanks(s);
  if (*s->p == '!') {
    s->p++;
    parse_factor(s);
    emit(s, LIB_NOT);
    return;
  }
  if (*s->p == '(') {
    s->p++;
    parse_or(s);
    if (*s->p++ != ')') {
      text_fail("a bracket is missing in a function of", s->cell->name);
    }
  } else {
    parse_name(s);
  }
  for (blanks(s); *s->p == '\''; blanks(s)) {
    s->p++;
    emit(s, LIB_NOT);
  }
}

static void parse_xor(parser *s) {
  parse_factor(s);
  for (blanks(s); *s->p == '^'; blanks(s)) {
    s->p++;
    parse_factor(s);
    emit(s, LIB_XOR);
  }
}

static void parse_and(parser *s) {
  parse_xor(s);
  for (blanks(s); *s->p != '\0' && strchr(")+|", *s->p) == NULL; blanks(s)) {
    s->p += *s->p == '&' || *s->p == '*';
    parse_xor(s);
    emit(s, LIB_AND);
  }
}

static void parse_or(parser *s) {
  parse_and(s);
  for (blanks(s); *s->p == '|' || *s->p == '+'; blanks(s)) {
    s->p++;
    parse_and(s);
    emit(s, LIB_OR);
  }
}

void function_parse(lib_function *f, const lib_cell *cell, const char *text, const char *state,
                    const char *state_not) {
  parser s = {text, cell, state, state_not, f};
  f->count = f->depth = 0;
  parse_or(&s);
  if (*s.p != '\0') {
    text_fail("a function is not understood, of", cell->name);
  }
}

uint64_t lib_evaluate(const lib_function *f, const uint64_t pin[], uint64_t state) {
  uint64_t stack[LIB_DEPTH] = {0};
  int top = -1;
  for (int k = 0; k < f->count; k++) {
    int op = f->op[k];
    switch (op) {
    case LIB_NOT:
      stack[top] = ~stack[top];
      break;
    case LIB_AND:
      top--;
      stack[top] &= stack[top + 1];
      break;
    case LIB_OR:
      top--;
      stack[top] |= stack[top + 1];
      break;
    case LIB_XOR:
      top--;
      stack[top] ^= stack[top + 1];
      break;
    case LIB_ZERO:
      stack[++top] = 0;
      break;
    case LIB_ONE:
      stack[++top] = ~UINT64_C(0);
      break;
    case LIB_STATE:
      stack[++top] = state;
      break;
    case LIB_STATE_NOT:
      stack[++top] = ~state;
      break;
    default:
      stack[++top] = pin[op];
    }
  }
  return top == 0 ? stack[0] : 0;
}

int function_inputs(const lib_cell *cell) {
  int inputs = 0;
  for (int k = 0; k < cell->pins; k++) {
    inputs += !cell->pin[k].output;
  }
  return inputs;
}

/* Bit r: the function in row r. Outputs are what they are in that row. */
uint64_t function_rows(const lib_cell *cell, const lib_function *f) {
  static const uint64_t column[6] = {UINT64_C(0xaaaaaaaaaaaaaaaa), UINT64_C(0xcccccccccccccccc),
                                     UINT64_C(0xf0f0f0f0f0f0f0f0), UINT64_C(0xff00ff00ff00ff00),
                                     UINT64_C(0xffff0000ffff0000), UINT64_C(0xffffffff00000000)};
  uint64_t value[LIB_PINS] = {0};
  int n = 0;
  for (int k = 0; k < cell->pins; k++) {
    if (!cell->pin[k].output) {
      value[k] = column[n++];
    }
  }
  uint64_t state = cell->register_ ? column[n] : 0;
  for (int k = 0; k < cell->pins; k++) {
    if (cell->pin[k].output) {
      value[k] = lib_evaluate(&cell->pin[k].function, value, state);
    }
  }
  return lib_evaluate(f, value, state);
}

int lib_rows(const lib_cell *cell, const double one[], double one_state, double differ,
             double row[64]) {
  int inputs = function_inputs(cell);
  int rows = 1 << (inputs + cell->register_);
  bool follows = cell->register_ && cell->next.count == 1 && cell->next.op[0] >= 0;
  int data = follows ? cell->next.op[0] : -1;
  for (int r = 0; r < rows; r++) {
    bool state = (r >> inputs & 1) != 0;
    double p = 1;
    int n = 0;
    for (int k = 0; k < cell->pins; k++) {
      if (cell->pin[k].output) {
        continue;
      }
      bool bit = (r >> n++ & 1) != 0;
      if (k != data) {
        p *= bit ? one[k] : 1 - one[k];
        continue;
      }
      double sum = state == bit ? 1 - differ + (bit ? 1 : -1) * (one[k] + one_state - 1)
                                : differ + (bit ? 1 : -1) * (one[k] - one_state);
      p *= sum > 0 ? sum / 2 : 0;
    }
    if (cell->register_ && !follows) {
      p *= state ? one_state : 1 - one_state;
    }
    row[r] = p;
  }
  return rows;
}
