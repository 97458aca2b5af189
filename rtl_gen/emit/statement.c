/* SPDX-License-Identifier: MIT */
/* statement.c - declarations, what stands in always blocks and functions, and control around
 * statements or items. */
#include "check.h"

#include <string.h>

/* ---------------------------------------------------------------------- declarations */

/* name [0:N-1] = value: a signal like `kind`, whose range was read. */
static void declare_net(reader *r, const check_name *kind, const char *name) {
  check_name net = *kind;
  if (reader_take(r, "[")) {
    int64_t first = check_constant(r);
    reader_expect(r, ":");
    net.words = check_constant(r) + 1;
    reader_expect(r, "]");
    if (first != 0 || net.words < 1) {
      reader_fault(r, "no words in '%s'", name);
    }
  }
  check_name *n = reader_declare(r, net.kind, name, net.width);
  n->low = net.low;
  n->words = net.words;
  if (reader_take(r, "=")) {
    check_same_width(r, "=", (operand){net.width, false, 0}, check_expression(r));
  }
}

static void declare_constant(reader *r, int width, const char *name) {
  reader_expect(r, "=");
  operand o = check_expression(r);
  if (width > 0 && width < 63 && o.known && o.value >= 0 && (o.value >> width) != 0) {
    reader_fault(r, "a value exceeds the size of '%s'", name);
  }
  check_name *n = reader_declare(r, NAME_CONSTANT, name, width > 0 ? width : o.width);
  n->known = o.known;
  n->value = o.value;
}

static void declare_names(reader *r, name_kind kind) {
  char name[EMIT_NAME];
  reader_take(r, "signed");
  check_name net = {.kind = kind};
  net.width = check_range(r, kind == NAME_CONSTANT ? 0 : 1, &net.low);
  do {
    reader_expect_name(r, name);
    if (kind == NAME_CONSTANT) {
      declare_constant(r, net.width, name);
    } else if (kind == NAME_VARIABLE) {
      reader_declare(r, kind, name, 0);
    } else {
      declare_net(r, &net, name);
    }
  } while (reader_take(r, ","));
  reader_expect(r, ";");
}

bool check_declaration(reader *r) {
  static const struct {
    const char *word;
    name_kind kind;
  } row[] = {{"wire", NAME_WIRE},
             {"reg", NAME_REG},
             {"localparam", NAME_CONSTANT},
             {"integer", NAME_VARIABLE},
             {"genvar", NAME_VARIABLE}};
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
    if (reader_take(r, row[i].word)) {
      declare_names(r, row[i].kind);
      return true;
    }
  }
  return false;
}

void check_function(reader *r) {
  char name[EMIT_NAME];
  char argument[EMIT_NAME];
  int low = 0;
  reader_take(r, "automatic");
  reader_take(r, "signed");
  check_name f = {.width = check_range(r, 1, &low)};
  reader_expect_name(r, name);
  reader_expect(r, "(");
  int outer = reader_enter(r);
  do {
    reader_expect(r, "input");
    reader_take(r, "signed");
    int width = check_range(r, 1, &low);
    reader_expect_name(r, argument);
    reader_declare(r, NAME_INPUT, argument, width);
    if (f.arguments == CHECK_ARGUMENTS) {
      reader_refuse(r, "too many arguments of '%s'", name);
    } else {
      f.argument[f.arguments++] = width;
    }
  } while (reader_take(r, ","));
  reader_expect(r, ")");
  reader_expect(r, ";");
  reader_declare(r, NAME_REG, name, f.width);
  while (check_declaration(r)) {}
  check_process(r, IN_COMBINATIONAL);
  reader_expect(r, "endfunction");
  reader_leave(r, outer);
  check_name *n = reader_declare(r, NAME_FUNCTION, name, f.width);
  n->arguments = f.arguments;
  memcpy(n->argument, f.argument, sizeof n->argument);
}

/* ---------------------------------------------------------------------------- control */

enum { LOOP_TURNS = 65536 };

/* begin : label ... end with a scope of its own, behind the first word. */
static void block(reader *r) {
  int outer = reader_enter(r);
  if (reader_take(r, ":")) {
    char label[EMIT_NAME];
    reader_expect_name(r, label);
    reader_declare(r, NAME_LABEL, label, 0);
  }
  while (check_declaration(r)) {}
  while (reader_is_before(r, "end")) {
    check_item(r);
  }
  reader_leave(r, outer);
}

static void branch(reader *r, bool dead) {
  r->off += dead;
  if (reader_take(r, "begin")) {
    block(r);
  } else {
    check_item(r);
  }
  r->off -= dead;
}

static operand in_parentheses(reader *r) {
  reader_expect(r, "(");
  operand o = check_expression(r);
  reader_expect(r, ")");
  return o;
}

/* Around items the condition is constant. */
static void conditional(reader *r) {
  operand condition = in_parentheses(r);
  check_condition(r, condition);
  if (!condition.known && r->place == IN_MODULE) {
    reader_fault(r, "not a constant expression");
  }
  branch(r, check_is(condition, false));
  if (reader_take(r, "else")) {
    branch(r, check_is(condition, true));
  }
}

static void set_variable(reader *r, const char *name, bool known, int64_t value) {
  check_name *n = reader_find(r, name);
  if (n == NULL || n->kind != NAME_VARIABLE) {
    reader_fault(r, "no genvar or integer '%s'", name);
    return;
  }
  n->known = known;
  n->value = value;
}

/* for (i = ...; ...; i = ...), unrolled; what runs no time is read once. */
static void loop(reader *r) {
  char name[EMIT_NAME];
  reader_expect(r, "(");
  reader_expect_name(r, name);
  reader_expect(r, "=");
  int64_t value = check_constant(r);
  reader_expect(r, ";");
  const char *head = r->at;
  const char *end = r->end;
  bool runs = true;
  for (int turn = 0; runs && !r->failed; turn++) {
    r->at = head;
    set_variable(r, name, true, value);
    runs = check_constant(r) != 0 && r->off == 0;
    reader_expect(r, ";");
    reader_expect(r, name);
    reader_expect(r, "=");
    value = check_constant(r);
    reader_expect(r, ")");
    if (turn == LOOP_TURNS) {
      reader_fault(r, "a loop without an end");
    }
    if (runs || turn == 0) {
      branch(r, !runs);
      end = r->at;
    }
  }
  r->at = r->failed ? r->end : end;
  set_variable(r, name, false, 0);
}

bool check_control(reader *r) {
  if (reader_take(r, "if")) {
    conditional(r);
  } else if (reader_take(r, "for")) {
    loop(r);
  } else {
    return false;
  }
  return true;
}

/* ------------------------------------------------------------------------- statements */

static void case_statement(reader *r) {
  operand selector = in_parentheses(r);
  while (reader_is_before(r, "endcase")) {
    if (!reader_take(r, "default")) {
      do {
        check_same_width(r, "case", selector, check_expression(r));
      } while (reader_take(r, ","));
    }
    reader_expect(r, ":");
    branch(r, false);
  }
}

void check_assignment(reader *r) {
  operand left = check_target(r);
  if (r->place == IN_COMBINATIONAL && reader_take(r, "<=")) {
    reader_refuse(r, "<= in a combinational block");
  }
  reader_expect(r, r->place == IN_CLOCKED ? "<=" : "=");
  check_same_width(r, "assignment", left, check_expression(r));
  reader_expect(r, ";");
}

static bool is_assertion(reader *r) {
  return r->formal &&
         (reader_take(r, "assert") || reader_take(r, "assume") || reader_take(r, "cover"));
}

void check_statement(reader *r) {
  if (reader_take(r, ";")) {
    return;
  }
  if (is_assertion(r)) {
    check_condition(r, in_parentheses(r));
    reader_expect(r, ";");
  } else if (reader_take(r, "begin")) {
    block(r);
  } else if (reader_take(r, "case") || reader_take(r, "casez")) {
    case_statement(r);
  } else {
    check_assignment(r);
  }
}

void check_process(reader *r, check_place place) {
  r->place = place;
  check_item(r);
  r->place = IN_MODULE;
}
