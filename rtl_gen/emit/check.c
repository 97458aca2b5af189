/* SPDX-License-Identifier: MIT */
/* check.c - modules, the items in them, and instances with the values of their parameters. */
#include "check.h"

#include "util/list.h"

#include <stdlib.h>
#include <string.h>

/* ----------------------------------------------------------------------------- headers */

/* The comment on the line that is read. */
static const char *comment(reader *r) {
  const char *about = strstr(r->at, "//");
  if (about == NULL || about > r->at + strcspn(r->at, "\n")) {
    reader_refuse(r, "no comment behind a parameter or port");
    return r->end;
  }
  return about + 2 + (about[2] == ' ');
}

/* parameter [integer] NAME = value; an instance's value stands outside the header's scope. */
static void parameter(reader *r) {
  char name[EMIT_NAME];
  reader_expect(r, "parameter");
  reader_take(r, "integer");
  reader_expect_name(r, name);
  comment(r);
  const check_name *bound = reader_find(r, name);
  int64_t given = bound != NULL ? bound->value : 0;
  reader_expect(r, "=");
  r->off += bound != NULL;
  int64_t value = check_constant(r);
  r->off -= bound != NULL;
  check_name *n = reader_declare(r, NAME_CONSTANT, name, 0);
  n->known = true;
  n->value = bound != NULL ? given : value;
}

/* input or output [wire] [reg] [signed] [range] name */
static void port(reader *r) {
  char name[EMIT_NAME];
  int low = 0;
  name_kind kind = reader_take(r, "input") ? NAME_INPUT : NAME_WIRE;
  if (kind == NAME_WIRE) {
    reader_expect(r, "output");
  }
  if (!reader_take(r, "wire") && kind == NAME_WIRE && reader_take(r, "reg")) {
    kind = NAME_REG;
  }
  bool is_signed = reader_take(r, "signed");
  int width = check_range(r, 1, &low);
  if (low > 0) {
    reader_fault(r, "a port without a bit 0");
  }
  reader_expect_name(r, name);
  const char *about = comment(r);
  check_name *n = reader_declare(r, kind, name, width);
  n->is_signed = is_signed;
  n->about = about;
}

void check_header(reader *r) {
  char name[EMIT_NAME];
  reader_enter(r);
  reader_expect(r, "module");
  reader_expect_name(r, name);
  if (reader_take(r, "#(")) {
    reader_list(r, parameter);
  }
  reader_expect(r, "(");
  reader_list(r, port);
  reader_expect(r, ";");
  r->header = r->names;
}

/* A parameter or port of a module whose header was read. */
static check_name *find_in_header(reader *r, const char *name) {
  check_name *n = reader_find(r, name);
  return n != NULL && n - r->name >= r->scope && n - r->name < r->header ? n : NULL;
}

/* -------------------------------------------------------------------------- instances */

/* .NAME(value), declared around the header of the child. */
static void bind_parameter(reader *r) {
  char name[EMIT_NAME];
  reader_expect(r, ".");
  reader_expect_name(r, name);
  reader_expect(r, "(");
  int64_t value = check_constant(r);
  reader_expect(r, ")");
  check_name *n = reader_declare(r->child, NAME_CONSTANT, name, 0);
  n->known = true;
  n->value = value;
}

/* Is this the first time that the module gets these values of its parameters? Keep them then. */
static bool is_new_variant(reader *r) {
  emitter *e = r->m->emitter;
  emit_text values = {NULL};
  text_puts(&values, r->m->name);
  for (int i = r->scope; i < r->header; i++) {
    if (r->name[i].kind == NAME_CONSTANT) {
      text_printf(&values, " %lld", (long long)r->name[i].value);
    }
  }
  char *variant = text_take(&values);
  char **list = list_grow(e->variant, &e->variant_space, (size_t)e->variants, sizeof(char *));
  e->variant = list != NULL ? list : e->variant;
  if (variant == NULL || list == NULL) {
    free(variant);
    reader_no_memory(r);
    return false;
  }
  for (int i = 0; i < e->variants; i++) {
    if (strcmp(e->variant[i], variant) == 0) {
      free(variant);
      return false;
    }
  }
  e->variant[e->variants++] = variant;
  return true;
}

/* What stands behind the header, unless it passed with the same values of the parameters. */
static void check_items(reader *r) {
  if (!is_new_variant(r)) {
    return;
  }
  while (reader_is_before(r, "endmodule")) {
    check_item(r);
  }
  reader_skip(r);
  if (r->at < r->end) {
    reader_refuse(r, "text behind the module");
  }
}

/* The module of an instance with the values that are bound. */
static void check_child(reader *r, reader *child) {
  check_header(child);
  for (int i = 0; i < child->scope; i++) {
    const check_name *n = find_in_header(child, child->name[i].name);
    if (n == NULL || n->kind != NAME_CONSTANT) {
      reader_fault(r, "no parameter '%s'", child->name[i].name);
    }
  }
  if (!r->failed) {
    check_items(child);
  }
  if (child->failed) {
    reader_refuse(r, "refused: '%s'", child->m->name);
  }
}

/* .port(expression): an output drives what it is connected to. */
static void connect(reader *r) {
  char name[EMIT_NAME];
  reader_expect(r, ".");
  reader_expect_name(r, name);
  reader_expect(r, "(");
  check_name *n = find_in_header(r->child, name);
  bool output = n != NULL && n->kind != NAME_INPUT;
  operand given = output ? check_target(r) : check_expression(r);
  reader_expect(r, ")");
  if (n == NULL || n->kind == NAME_CONSTANT) {
    reader_fault(r, "no port '%s'", name);
  } else if (n->connected) {
    reader_fault(r, "connected twice: '%s'", name);
  } else if (given.width != n->width) {
    reader_fault(r, "port '%s' has %d bits, its connection %d", name, n->width, given.width);
  } else {
    n->connected = true;
  }
}

static void check_connected(reader *r, const reader *child) {
  int ports = 0;
  int connected = 0;
  for (int i = child->scope; i < child->header; i++) {
    ports += child->name[i].kind != NAME_CONSTANT;
    connected += child->name[i].connected;
  }
  if (connected != ports) {
    reader_fault(r, "%d of the %d ports are connected of '%s'", connected, ports, child->m->name);
  }
}

/* module #(.P(value), ...) name (.port(expression), ...); */
static void instance(reader *r) {
  char module[EMIT_NAME];
  char name[EMIT_NAME];
  bool named = reader_take_name(r, module);
  const emit_module *m = r->off == 0 ? emit_find(r->m->emitter, module) : NULL;
  reader child;
  reader_open(&child, m != NULL ? m : r->m, m != NULL ? m->verilog : "");
  child.off = r->off;
  r->child = &child;
  if (named && reader_take(r, "#(")) {
    reader_list(r, bind_parameter);
  }
  if (!named || !reader_take_name(r, name) || !reader_take(r, "(")) {
    reader_refuse(r, "item not understood");
  } else if (m == NULL || m == r->m) {
    reader_fault(r, "a module that is not emitted yet: '%s'", module);
  } else {
    reader_declare(r, NAME_LABEL, name, 0);
    check_child(r, &child);
  }
  reader_list(r, connect);
  reader_expect(r, ";");
  check_connected(r, &child);
  r->child = NULL;
  reader_close(&child);
}

/* ------------------------------------------------------------------------------ items */

static void always(reader *r) {
  if (reader_take(r, "@(posedge clk)")) {
    check_process(r, IN_CLOCKED);
  } else if (reader_take(r, "@(*)") || reader_take(r, "@*")) {
    check_process(r, IN_COMBINATIONAL);
  } else {
    reader_refuse(r, "expected '@(posedge clk)' or '@(*)'");
  }
}

static void module_item(reader *r) {
  if (reader_take(r, "assign")) {
    check_assignment(r);
  } else if (reader_take(r, "always")) {
    always(r);
  } else if (r->formal && reader_take(r, "initial")) {
    check_process(r, IN_COMBINATIONAL);
  } else if (reader_take(r, "generate")) {
    while (reader_is_before(r, "endgenerate")) {
      check_item(r);
    }
  } else if (reader_take(r, "function")) {
    check_function(r);
  } else if (!check_declaration(r)) {
    instance(r);
  }
}

void check_item(reader *r) {
  if (check_control(r)) {
    return;
  }
  if (r->place == IN_MODULE) {
    module_item(r);
  } else {
    check_statement(r);
  }
}

bool emit_check(const emit_module *m) {
  if (emit_find(m->emitter, m->name) != m) {
    return emit_refuse(m, "module is emitted twice");
  }
  reader r;
  reader_open(&r, m, m->verilog);
  check_header(&r);
  check_items(&r);
  reader_close(&r);
  return !r.failed;
}
