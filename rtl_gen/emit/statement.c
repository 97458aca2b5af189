/* statement.c - declarations, and what stands in always blocks and functions. */
#include "check.h"

#include <string.h>

int check_range(reader *r, int *low) {
  *low = 0;
  if (!reader_take(r, "[")) {
    return 1;
  }
  int64_t msb = check_constant(r);
  reader_expect(r, ":");
  int64_t lsb = check_constant(r);
  reader_expect(r, "]");
  if (r->failed || r->off > 0) {
    return 1;
  }
  if (lsb < 0 || msb - lsb >= 1 << 24) {
    reader_refuse(r, "range not understood", "");
  }
  *low = (int)lsb;
  return (int)(msb - lsb) + 1;
}

/* ---------------------------------------------------------------------- declarations */

static void declare_net(reader *r, const check_name *net, const char *name) {
  int width = net->width;
  int64_t words = 0;
  if (reader_take(r, "[")) {
    int64_t first = check_constant(r);
    reader_expect(r, ":");
    words = check_constant(r) + 1;
    reader_expect(r, "]");
    if (!r->failed && r->off == 0 && (first != 0 || words < 1)) {
      reader_refuse(r, "no words in", name);
    }
  }
  if (r->off == 0) {
    if (!r->failed && width < 1) {
      reader_refuse(r, "no bits in", name);
    }
    check_name *n = reader_declare(r, net->kind, name, width);
    n->low = net->low;
    n->words = words;
  }
  if (reader_take(r, "=")) {
    operand right = check_expression(r);
    check_same_width(r, "=", (operand){width, false, 0}, right);
  }
}

static void declare_constant(reader *r, int width, const char *name) {
  reader_expect(r, "=");
  operand o = check_expression(r);
  if (r->failed || r->off > 0) {
    return;
  }
  if (width > 0 && width < 63 && o.known && o.value >= 0 && (o.value >> width) != 0) {
    reader_refuse(r, "a value exceeds the size of", name);
  }
  if (width == 0 && o.width > 0 && !o.known) {
    width = o.width;
  }
  check_name *n = reader_declare(r, NAME_CONSTANT, name, width > 0 ? width : o.width);
  n->known = o.known;
  n->value = o.value;
}

static void declare_names(reader *r, const char *word) {
  bool is_localparam = strcmp(word, "localparam") == 0;
  bool is_integer = strcmp(word, "integer") == 0 || strcmp(word, "genvar") == 0;
  reader_take(r, "signed");
  bool ranged = reader_next_is(r, "[");
  check_name net = {.kind = strcmp(word, "wire") == 0 ? NAME_WIRE : NAME_REG};
  net.width = check_range(r, &net.low);
  do {
    char name[EMIT_NAME];
    if (!reader_take_name(r, name)) {
      reader_refuse(r, "a name is missing", "");
      return;
    }
    if (is_localparam) {
      declare_constant(r, ranged ? net.width : 0, name);
    } else if (!is_integer) {
      declare_net(r, &net, name);
    } else if (r->off == 0) {
      reader_declare(r, NAME_CONSTANT, name, 0);
    }
  } while (!r->failed && reader_take(r, ","));
  reader_expect(r, ";");
}

bool check_declaration(reader *r) {
  static const char *const word[] = {"wire", "reg", "integer", "genvar", "localparam"};
  for (size_t i = 0; i < sizeof word / sizeof word[0]; i++) {
    if (reader_take(r, word[i])) {
      declare_names(r, word[i]);
      return true;
    }
  }
  return false;
}

/* function [automatic] [signed] [range] name(input [signed] [range] a, ...); statement endfunction
 */
void check_function(reader *r) {
  char name[EMIT_NAME] = "";
  reader_take(r, "automatic");
  reader_take(r, "signed");
  int low = 0;
  check_name f = {.width = check_range(r, &low)};
  reader_take_name(r, name);
  reader_expect(r, "(");
  int outer = reader_enter(r);
  do {
    char argument[EMIT_NAME] = "";
    reader_expect(r, "input");
    reader_take(r, "signed");
    int width = check_range(r, &low);
    reader_take_name(r, argument);
    if (f.arguments == CHECK_ARGUMENTS) {
      reader_refuse(r, "too many arguments of", name);
    }
    if (!r->failed && r->off == 0) {
      f.argument[f.arguments++] = width;
      reader_declare(r, NAME_INPUT, argument, width);
    }
  } while (!r->failed && reader_take(r, ","));
  reader_expect(r, ")");
  reader_expect(r, ";");
  if (!r->failed && r->off == 0) {
    reader_declare(r, NAME_REG, name, f.width);
  }
  while (!r->failed && check_declaration(r)) {}
  check_statement(r);
  reader_expect(r, "endfunction");
  reader_leave(r, outer);
  if (!r->failed && r->off == 0) {
    check_name *n = reader_declare(r, NAME_FUNCTION, name, f.width);
    n->arguments = f.arguments;
    memcpy(n->argument, f.argument, sizeof n->argument);
  }
}

/* ------------------------------------------------------------------------- statements */

enum { LOOP_TURNS = 65536 };

/* The value of "i = value"; i is the variable `loop`, or the first, which names it. */
static int64_t loop_value(reader *r, char loop[EMIT_NAME]) {
  char name[EMIT_NAME] = "";
  reader_take_name(r, name);
  if (loop[0] == '\0') {
    memcpy(loop, name, EMIT_NAME);
  } else if (strcmp(loop, name) != 0) {
    reader_refuse(r, "a loop of two variables", name);
  }
  reader_expect(r, "=");
  return check_constant(r);
}

static void set_loop(reader *r, const char *loop, bool known, int64_t value) {
  check_name *n = reader_find(r, loop);
  if (n == NULL || n->kind != NAME_CONSTANT || n->width != 0) {
    if (r->off == 0) {
      reader_refuse(r, "no genvar or integer", loop);
    }
    return;
  }
  n->known = known;
  n->value = value;
}

void check_loop(reader *r, void (*body)(reader *r)) {
  char loop[EMIT_NAME] = "";
  reader_expect(r, "(");
  int64_t value = loop_value(r, loop);
  reader_expect(r, ";");
  const char *head = r->at;
  const char *end = head;
  bool runs = true;
  for (int turn = 0; !r->failed && runs; turn++) {
    r->at = head;
    set_loop(r, loop, true, value);
    runs = (r->off > 0 ? check_expression(r).value : check_constant(r)) != 0 && r->off == 0;
    reader_expect(r, ";");
    value = loop_value(r, loop);
    reader_expect(r, ")");
    if (turn == LOOP_TURNS) {
      reader_refuse(r, "a loop without an end", "");
    }
    if (runs || turn == 0) {
      r->off += !runs;
      body(r);
      r->off -= !runs;
      end = r->at;
    } else if (!r->failed) {
      r->at = end;
    }
  }
  set_loop(r, loop, false, 0);
}

static void labelled(reader *r) {
  char label[EMIT_NAME];
  if (reader_take(r, ":") && reader_take_name(r, label) && r->off == 0) {
    reader_declare(r, NAME_LABEL, label, 0);
  }
}

static void branch(reader *r, bool dead, void (*body)(reader *r)) {
  r->off += dead;
  body(r);
  r->off -= dead;
}

static void case_statement(reader *r) {
  reader_expect(r, "(");
  operand selector = check_expression(r);
  reader_expect(r, ")");
  while (!r->failed && !reader_take(r, "endcase")) {
    if (reader_take(r, "default")) {
      reader_take(r, ":");
    } else {
      do {
        check_same_width(r, "case", selector, check_expression(r));
      } while (!r->failed && reader_take(r, ","));
      reader_expect(r, ":");
    }
    check_statement(r);
  }
}

static void assignment(reader *r) {
  operand left = check_target(r, true);
  bool late = reader_take(r, "<=");
  if (!late) {
    reader_expect(r, r->clocked ? "<=" : "=");
  } else if (r->combinational) {
    reader_refuse(r, "<= in a combinational block", "");
  }
  check_same_width(r, late ? "<=" : "=", left, check_expression(r));
  reader_expect(r, ";");
}

static bool formal_statement(reader *r) {
  if (!r->formal || !(reader_take(r, "assert") || reader_take(r, "assume") ||
                      reader_take(r, "cover") || reader_take(r, "restrict"))) {
    return false;
  }
  reader_expect(r, "(");
  check_condition(r, check_expression(r));
  reader_expect(r, ")");
  reader_expect(r, ";");
  return true;
}

void check_statement(reader *r) {
  if (r->failed || reader_take(r, ";") || formal_statement(r)) {
    return;
  }
  if (reader_take(r, "begin")) {
    int outer = reader_enter(r);
    labelled(r);
    while (!r->failed && check_declaration(r)) {}
    while (!r->failed && !reader_take(r, "end")) {
      check_statement(r);
    }
    reader_leave(r, outer);
  } else if (reader_take(r, "if")) {
    reader_expect(r, "(");
    operand condition = check_expression(r);
    check_condition(r, condition);
    reader_expect(r, ")");
    branch(r, check_is_false(condition), check_statement);
    if (reader_take(r, "else")) {
      branch(r, check_is_true(condition), check_statement);
    }
  } else if (reader_take(r, "for")) {
    check_loop(r, check_statement);
  } else if (reader_take(r, "case") || reader_take(r, "casez")) {
    case_statement(r);
  } else {
    assignment(r);
  }
}
