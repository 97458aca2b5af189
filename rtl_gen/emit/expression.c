/* SPDX-License-Identifier: MIT */
/* expression.c - operators: the bits of their results, and the values of constants. */
#include "check.h"

#include <string.h>

bool check_is(operand condition, bool value) {
  return condition.known && (condition.value != 0) == value;
}

void check_same_width(reader *r, const char *what, operand left, operand right) {
  if (left.width == right.width) {
    return;
  }
  if (left.width == 0 || right.width == 0) {
    reader_fault(r, "a constant without a size");
  }
  reader_fault(r, "%s: %d bits against %d", what, left.width, right.width);
}

void check_condition(reader *r, operand condition) {
  if (condition.width != 0 || !condition.known) {
    check_same_width(r, "condition", condition, check_bits(1));
  }
}

int64_t check_constant(reader *r) {
  operand o = check_expression(r);
  if (!o.known) {
    reader_fault(r, "not a constant expression");
  }
  return o.value;
}

int check_range(reader *r, int none, int *low) {
  *low = 0;
  if (!reader_take(r, "[")) {
    return none;
  }
  int64_t msb = check_constant(r);
  reader_expect(r, ":");
  int64_t lsb = check_constant(r);
  reader_expect(r, "]");
  if (lsb < 0 || msb - lsb >= 1 << 24) {
    reader_fault(r, "range not understood");
  }
  *low = (int)lsb;
  return (int)(msb - lsb + 1);
}

typedef enum { ARITHMETIC, COMPARISON, LOGIC, SHIFT } operator_kind;

typedef struct {
  const char *text;
  int level;
  operator_kind kind;
} operator_row;

/* Longer ones first. */
static const operator_row operators[] = {
    {">>>", 7, SHIFT},     {"<<<", 7, SHIFT},     {"||", 0, LOGIC},     {"&&", 1, LOGIC},
    {"==", 5, COMPARISON}, {"!=", 5, COMPARISON}, {"<<", 7, SHIFT},     {">>", 7, SHIFT},
    {"<=", 6, COMPARISON}, {">=", 6, COMPARISON}, {"<", 6, COMPARISON}, {">", 6, COMPARISON},
    {"|", 2, ARITHMETIC},  {"^", 3, ARITHMETIC},  {"&", 4, ARITHMETIC}, {"+", 8, ARITHMETIC},
    {"-", 8, ARITHMETIC},  {"*", 9, ARITHMETIC},  {"/", 9, ARITHMETIC}, {"%", 9, ARITHMETIC},
};
enum { OPERATOR_ROWS = sizeof operators / sizeof operators[0] };

/* The operator that is next, of this level or above; "+:" and "-:" are of part selects. */
static const operator_row *take_operator(reader *r, int level) {
  reader_skip(r);
  for (int i = 0; i < OPERATOR_ROWS && r->at[0] != '\0' && r->at[1] != ':'; i++) {
    const operator_row *row = &operators[i];
    if (reader_take(r, row->text)) {
      bool binds = row->level >= level;
      r->at -= binds ? 0 : strlen(row->text);
      return binds ? row : NULL;
    }
  }
  return NULL;
}

/* The value of an operation on constants; most differ in their first character. */
static int64_t fold(const char *op, int64_t a, int64_t b) {
  bool doubled = op[1] == op[0];
  bool or_equal = op[1] == '=';
  bool shifts = b >= 0 && b < 62;
  switch (op[0]) {
  case '|':
    return doubled ? (a != 0 || b != 0) : (a | b);
  case '&':
    return doubled ? (a != 0 && b != 0) : (a & b);
  case '^':
    return a ^ b;
  case '=':
    return a == b;
  case '!':
    return a != b;
  case '<':
    return doubled ? (shifts ? a * (INT64_C(1) << b) : 0) : or_equal ? a <= b : a < b;
  case '>':
    return doubled ? (shifts ? a >> b : 0) : or_equal ? a >= b : a > b;
  case '+':
    return a + b;
  case '-':
    return a - b;
  case '*':
    return a * b;
  default:
    return b == 0 ? 0 : op[0] == '/' ? a / b : a % b;
  }
}

static operand apply(reader *r, const operator_row *o, operand left, operand right) {
  bool decides = o->kind == COMPARISON || o->kind == LOGIC;
  bool unsized = left.width == 0 && (right.width == 0 || o->kind == SHIFT);
  if (o->kind == LOGIC) {
    check_condition(r, left);
    check_condition(r, right);
  } else if (o->kind != SHIFT) {
    check_same_width(r, o->text, left, right);
  }
  if (left.known && right.known && (unsized || decides)) {
    return (operand){unsized ? 0 : 1, true, fold(o->text, left.value, right.value)};
  }
  return check_bits(decides ? 1 : left.width);
}

/* Operators of one level and above, from the left. */
static operand binary(reader *r, int level) {
  operand left = check_primary(r);
  for (const operator_row *o; (o = take_operator(r, level)) != NULL;) {
    bool decided = o->kind == LOGIC && check_is(left, o->level == 0);
    r->off += decided;
    operand right = binary(r, o->level + 1);
    r->off -= decided;
    left = decided ? left : apply(r, o, left, right);
  }
  return left;
}

/* One arm of ?:, read without its widths if it is not chosen. */
static operand arm(reader *r, bool dead) {
  r->off += dead;
  operand o = check_expression(r);
  r->off -= dead;
  return o;
}

operand check_expression(reader *r) {
  operand condition = binary(r, 0);
  if (!reader_take(r, "?")) {
    return condition;
  }
  check_condition(r, condition);
  operand left = arm(r, check_is(condition, false));
  reader_expect(r, ":");
  operand right = arm(r, check_is(condition, true));
  if (condition.known) {
    return check_is(condition, true) ? left : right;
  }
  check_same_width(r, "arms of ?:", left, right);
  return check_bits(left.width);
}
