/* check.c - modules, the items in them, and instances with the values of their parameters. */
#include "check.h"

#include <stdlib.h>
#include <string.h>

typedef struct {
  char name[EMIT_NAME];
  int64_t value;
} binding;

typedef struct {
  binding *list;
  int count;
} bindings;

static bool check_module(const emit_module *m, const bindings *overrides);

/* The value of an expression that stands outside the body, which may name parameters. */
static int64_t evaluate(reader *r, const char *expression) {
  const char *begin = r->begin;
  const char *at = r->at;
  const char *end = r->end;
  r->begin = r->at = expression;
  r->end = expression + strlen(expression);
  int64_t value = check_constant(r);
  reader_skip(r);
  if (!r->failed && r->at != r->end) {
    reader_refuse(r, "not a constant expression", "");
  }
  r->begin = begin;
  r->at = r->failed ? end : at;
  r->end = end;
  return value;
}

static int64_t parameter_value(reader *r, const emit_symbol *s, const bindings *overrides) {
  for (int i = 0; i < overrides->count; i++) {
    if (strcmp(overrides->list[i].name, s->name) == 0) {
      return overrides->list[i].value;
    }
  }
  return evaluate(r, s->value);
}

/* Declare parameters and ports of the module. */
static void open_header(reader *r, const bindings *overrides) {
  for (int i = 0; i < r->m->symbols && !r->failed; i++) {
    const emit_symbol *s = &r->m->symbol[i];
    if (s->kind == EMIT_PARAMETER) {
      int64_t value = parameter_value(r, s, overrides);
      check_name *n = reader_declare(r, NAME_CONSTANT, s->name, 0);
      n->known = true;
      n->value = value;
    } else {
      int64_t width = s->width[0] != '\0' ? evaluate(r, s->width) : 1;
      if (!r->failed && (width < 1 || width > 1 << 24)) {
        reader_refuse(r, "no bits in", s->name);
      }
      name_kind kind = s->kind == EMIT_INPUT    ? NAME_INPUT
                       : s->kind == EMIT_OUTPUT ? NAME_WIRE
                                                : NAME_REG;
      reader_declare(r, kind, s->name, (int)width);
    }
  }
}

/* -------------------------------------------------------------------------- instances */

static const emit_symbol *find_symbol(const emit_module *m, const char *name) {
  for (int i = 0; i < m->symbols; i++) {
    if (strcmp(m->symbol[i].name, name) == 0) {
      return &m->symbol[i];
    }
  }
  return NULL;
}

/* .NAME(value), ... behind "#(". */
static void bind_parameters(reader *r, const emit_module *child, bindings *bound) {
  do {
    binding b = {"", 0};
    reader_expect(r, ".");
    reader_take_name(r, b.name);
    const emit_symbol *s = child != NULL ? find_symbol(child, b.name) : NULL;
    if (r->off == 0 && (s == NULL || s->kind != EMIT_PARAMETER)) {
      reader_refuse(r, "no parameter", b.name);
    }
    reader_expect(r, "(");
    b.value = check_constant(r);
    reader_expect(r, ")");
    for (int i = 0; i < bound->count; i++) {
      if (strcmp(bound->list[i].name, b.name) == 0) {
        reader_refuse(r, "bound twice:", b.name);
      }
    }
    bound->list = emit_grow(bound->list, bound->count, sizeof b);
    bound->list[bound->count++] = b;
  } while (!r->failed && reader_take(r, ","));
  reader_expect(r, ")");
}

/* "sepax_mul A_W=18 ...": a module with the values that its parameters have. */
static char *variant_of(reader *child) {
  char *text = NULL;
  size_t size = 0;
  FILE *out = open_memstream(&text, &size);
  if (out == NULL) {
    abort();
  }
  fputs(child->m->name, out);
  for (int i = 0; i < child->m->symbols; i++) {
    const emit_symbol *s = &child->m->symbol[i];
    if (s->kind == EMIT_PARAMETER) {
      fprintf(out, " %s=%lld", s->name, (long long)reader_find(child, s->name)->value);
    }
  }
  fclose(out);
  return text;
}

/* Check a variant of a module, once. */
static bool check_variant(reader *child, const bindings *bound) {
  emitter *e = child->m->emitter;
  char *variant = variant_of(child);
  for (int i = 0; i < e->variants; i++) {
    if (strcmp(e->variant[i], variant) == 0) {
      free(variant);
      return true;
    }
  }
  if (!check_module(child->m, bound)) {
    free(variant);
    return false;
  }
  e->variant = emit_grow(e->variant, e->variants, sizeof(char *));
  e->variant[e->variants++] = variant;
  return true;
}

/* .port(expression) of a port that is `bits` wide; an output drives what it is connected to. */
static void connect(reader *r, const char *port, bool output, int bits) {
  operand given = output ? check_target(r, false) : check_expression(r);
  if (!r->failed && r->off == 0 && given.width != bits) {
    char what[EMIT_NAME + 96];
    snprintf(what, sizeof what, "port '%s' has %d bits, its connection %d", port, bits,
             given.width);
    reader_refuse(r, what, "");
  }
}

/* The connections, in any order; each port once. `child` is NULL in a branch not taken. */
static void check_connections(reader *r, const emit_module *m, reader *child) {
  int ports = 0;
  int connected = 0;
  for (int i = 0; m != NULL && i < m->symbols; i++) {
    ports += emit_is_port(&m->symbol[i]);
  }
  bool *seen = calloc((size_t)(m != NULL ? m->symbols : 0) + 1, sizeof *seen);
  if (seen == NULL) {
    abort();
  }
  while (!r->failed && reader_take(r, ".")) {
    char port[EMIT_NAME] = "";
    reader_take_name(r, port);
    const emit_symbol *s = m != NULL ? find_symbol(m, port) : NULL;
    reader_expect(r, "(");
    if (child == NULL) {
      check_expression(r);
    } else if (s == NULL || !emit_is_port(s)) {
      reader_refuse(r, "no port", port);
    } else if (seen[s - m->symbol]) {
      reader_refuse(r, "connected twice:", port);
    } else {
      seen[s - m->symbol] = true;
      connect(r, port, s->kind != EMIT_INPUT, reader_find(child, port)->width);
    }
    reader_expect(r, ")");
    connected++;
    if (!reader_take(r, ",")) {
      break;
    }
  }
  if (!r->failed && child != NULL && connected != ports) {
    char what[96];
    snprintf(what, sizeof what, "%d of the %d ports are connected of", connected, ports);
    reader_refuse(r, what, m->name);
  }
  free(seen);
  reader_expect(r, ")");
  reader_expect(r, ";");
}

/* module #(.P(value), ...) name (.port(expression), ...); behind the first word. */
static void check_instance(reader *r, const char *module) {
  bindings bound = {NULL, 0};
  char name[EMIT_NAME] = "";
  const emit_module *m = r->off == 0 ? emit_find(r->m->emitter, module) : NULL;
  bool parameters = reader_take(r, "#(");
  if (r->off == 0 && m == NULL && (parameters || !reader_next_is(r, "="))) {
    const char *at = r->at;
    bool looks = parameters || (reader_take_name(r, name) && reader_next_is(r, "("));
    r->at = at;
    reader_refuse(r, looks ? "a module that is not emitted yet:" : "item not understood", module);
  }
  if (parameters) {
    bind_parameters(r, m, &bound);
  }
  if (!r->failed && !reader_take_name(r, name)) {
    reader_refuse(r, "item not understood", "");
  }
  reader_expect(r, "(");
  if (r->off > 0) {
    check_connections(r, NULL, NULL);
  } else if (!r->failed) {
    reader_declare(r, NAME_LABEL, name, 0);
    reader child;
    reader_open(&child, m, "", 0);
    open_header(&child, &bound);
    if (child.failed || !check_variant(&child, &bound)) {
      reader_refuse(r, "refused:", name);
    } else {
      check_connections(r, m, &child);
    }
    reader_close(&child);
  }
  free(bound.list);
}

/* ------------------------------------------------------------------------------ items */

static void item(reader *r);

/* One item of a generate construct, or begin : label ... end. */
static void block(reader *r) {
  if (!reader_take(r, "begin")) {
    item(r);
    return;
  }
  char label[EMIT_NAME];
  int outer = reader_enter(r);
  if (reader_take(r, ":") && reader_take_name(r, label) && r->off == 0) {
    reader_declare(r, NAME_LABEL, label, 0);
  }
  while (!r->failed && !reader_take(r, "end")) {
    item(r);
  }
  reader_leave(r, outer);
}

static void generate_if(reader *r) {
  reader_expect(r, "(");
  bool holds = check_constant(r) != 0;
  reader_expect(r, ")");
  r->off += !holds;
  block(r);
  r->off -= !holds;
  if (reader_take(r, "else")) {
    r->off += holds;
    block(r);
    r->off -= holds;
  }
}

static void always(reader *r) {
  r->clocked = reader_take(r, "@(posedge clk)");
  r->combinational = !r->clocked && (reader_take(r, "@(*)") || reader_take(r, "@*"));
  if (!r->clocked && !r->combinational) {
    reader_refuse(r, "expected", "@(posedge clk) or @(*)");
  }
  check_statement(r);
  r->clocked = false;
  r->combinational = false;
}

static void assign(reader *r) {
  operand left = check_target(r, false);
  reader_expect(r, "=");
  check_same_width(r, "=", left, check_expression(r));
  reader_expect(r, ";");
}

static void item(reader *r) {
  char name[EMIT_NAME];
  if (reader_take(r, "assign")) {
    assign(r);
  } else if (reader_take(r, "always")) {
    always(r);
  } else if (reader_take(r, "generate")) {
    while (!r->failed && !reader_take(r, "endgenerate")) {
      item(r);
    }
  } else if (reader_take(r, "for")) {
    check_loop(r, block);
  } else if (reader_take(r, "if")) {
    generate_if(r);
  } else if (reader_take(r, "function")) {
    check_function(r);
  } else if (r->formal && reader_take(r, "initial")) {
    check_statement(r);
  } else if (!check_declaration(r)) {
    if (!r->failed && reader_take_name(r, name)) {
      check_instance(r, name);
    } else {
      reader_refuse(r, "item not understood", "");
    }
  }
}

static bool check_module(const emit_module *m, const bindings *overrides) {
  reader r;
  reader_open(&r, m, m->body, m->body_size);
  open_header(&r, overrides);
  reader_skip(&r);
  while (!r.failed && r.at < r.end) {
    item(&r);
    reader_skip(&r);
  }
  reader_close(&r);
  return !r.failed;
}

bool emit_check(const emit_module *m) {
  for (int i = 0; i < m->emitter->modules; i++) {
    const emit_module *other = m->emitter->module[i];
    if (other != m && strcmp(other->name, m->name) == 0) {
      return emit_refuse(m, "module is emitted twice");
    }
  }
  const bindings none = {NULL, 0};
  return check_module(m, &none);
}

int emit_port_width(const emit_module *m, const emit_symbol *port) {
  const bindings none = {NULL, 0};
  reader r;
  reader_open(&r, m, "", 0);
  open_header(&r, &none);
  const check_name *n = reader_find(&r, port->name);
  int width = n != NULL ? n->width : 1;
  reader_close(&r);
  return width;
}
