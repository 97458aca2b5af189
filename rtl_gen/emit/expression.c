/* expression.c - operators: the bits of their results, and the values of constants. */
#include "check.h"

#include <string.h>

static operand bits(int width) { return (operand){width, false, 0}; }

bool check_is_false(operand condition) { return condition.known && condition.value == 0; }
bool check_is_true(operand condition) { return condition.known && condition.value != 0; }

void check_same_width(reader *r, const char *what, operand left, operand right) {
  if (r->failed || r->off > 0 || left.width == right.width) {
    return;
  }
  if (left.width == 0 || right.width == 0) {
    reader_refuse(r, "a constant without a size", "");
    return;
  }
  char text[96];
  snprintf(text, sizeof text, "%.40s: %d bits against %d", what, left.width, right.width);
  reader_refuse(r, text, "");
}

void check_condition(reader *r, operand condition) {
  if (condition.width != 0 || !condition.known) {
    check_same_width(r, "condition", condition, bits(1));
  }
}

int64_t check_constant(reader *r) {
  operand o = check_expression(r);
  if (!o.known && !r->failed && r->off == 0) {
    reader_refuse(r, "not a constant expression", "");
  }
  return o.value;
}

typedef enum { ARITHMETIC, COMPARISON, LOGIC, SHIFT } operator_kind;

typedef struct {
  const char *text;
  int level;
  operator_kind kind;
} operator_row;

/* Longer ones first. */
static const operator_row operators[] = {
    {">>>", 7, SHIFT},    {"<<<", 7, SHIFT},     {"===", 5, COMPARISON}, {"!==", 5, COMPARISON},
    {"||", 0, LOGIC},     {"&&", 1, LOGIC},      {"==", 5, COMPARISON},  {"!=", 5, COMPARISON},
    {"<<", 7, SHIFT},     {">>", 7, SHIFT},      {"<=", 6, COMPARISON},  {">=", 6, COMPARISON},
    {"**", 10, SHIFT},    {"~^", 3, ARITHMETIC}, {"<", 6, COMPARISON},   {">", 6, COMPARISON},
    {"|", 2, ARITHMETIC}, {"^", 3, ARITHMETIC},  {"&", 4, ARITHMETIC},   {"+", 8, ARITHMETIC},
    {"-", 8, ARITHMETIC}, {"*", 9, ARITHMETIC},  {"/", 9, ARITHMETIC},   {"%", 9, ARITHMETIC},
};
enum { OPERATOR_ROWS = sizeof operators / sizeof operators[0], OPERATOR_LEVELS = 11 };

static const operator_row *take_operator(reader *r, int level) {
  reader_skip(r);
  if (r->at == r->end || strchr("|&=!<>^+-*/%~", *r->at) == NULL) {
    return NULL;
  }
  if (r->end - r->at > 1 && r->at[1] == ':') { /* of a part select */
    return NULL;
  }
  for (int i = 0; i < OPERATOR_ROWS; i++) {
    if (reader_next_is(r, operators[i].text)) {
      if (operators[i].level != level) {
        return NULL;
      }
      reader_take(r, operators[i].text);
      return &operators[i];
    }
  }
  return NULL;
}

static int64_t power(int64_t base, int64_t exponent) {
  int64_t value = 1;
  for (int64_t i = 0; i < exponent && i < 62; i++) {
    value *= base;
  }
  return value;
}

/* The value of an operation on constants; the first character distinguishes most of them. */
static int64_t fold(const char *op, int64_t a, int64_t b) {
  bool doubled = op[1] == op[0];
  switch (op[0]) {
  case '|':
    return doubled ? (a != 0 || b != 0) : (a | b);
  case '&':
    return doubled ? (a != 0 && b != 0) : (a & b);
  case '^':
    return a ^ b;
  case '~':
    return ~(a ^ b);
  case '=':
    return a == b;
  case '!':
    return a != b;
  case '<':
    return doubled ? (b < 62 ? a * (INT64_C(1) << b) : 0) : op[1] == '=' ? a <= b : a < b;
  case '>':
    return doubled ? (b < 62 ? a >> b : 0) : op[1] == '=' ? a >= b : a > b;
  case '+':
    return a + b;
  case '-':
    return a - b;
  case '*':
    return doubled ? power(a, b) : a * b;
  case '/':
    return b != 0 ? a / b : 0;
  default:
    return b != 0 ? a % b : 0;
  }
}

static operand apply(reader *r, const operator_row *o, operand left, operand right) {
  if (o->kind == LOGIC) {
    check_condition(r, left);
    check_condition(r, right);
  } else if (o->kind != SHIFT) {
    check_same_width(r, o->text, left, right);
  }
  bool decides = o->kind == COMPARISON || o->kind == LOGIC;
  operand result = bits(decides ? 1 : left.width);
  bool unsized = left.width == 0 && (right.width == 0 || o->kind == SHIFT);
  if (left.known && right.known && (unsized || decides)) {
    result = (operand){unsized ? 0 : 1, true, fold(o->text, left.value, right.value)};
  }
  return result;
}

/* Operators of one level and above, from the left. */
static operand binary(reader *r, int level) {
  if (level == OPERATOR_LEVELS) {
    return check_primary(r);
  }
  operand left = binary(r, level + 1);
  for (const operator_row *o; !r->failed && (o = take_operator(r, level)) != NULL;) {
    bool decided = o->kind == LOGIC && (level == 0 ? check_is_true(left) : check_is_false(left));
    r->off += decided;
    operand right = binary(r, level + 1);
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
  if (r->failed || !reader_take(r, "?")) {
    return condition;
  }
  check_condition(r, condition);
  operand left = arm(r, check_is_false(condition));
  reader_expect(r, ":");
  operand right = arm(r, check_is_true(condition));
  if (condition.known) {
    return check_is_true(condition) ? left : right;
  }
  check_same_width(r, "arms of ?:", left, right);
  return bits(left.width);
}
