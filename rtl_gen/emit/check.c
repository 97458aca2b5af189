/* check.c - the emitter's strictness: a recursive-descent reader of the subset of
 * Verilog that the generator writes, which gives every expression its width and
 * refuses what is undeclared, mis-sized or not understood. */
#include "emit.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
  const emit_module *m;
  const emit_binding *overrides;
  int override_count;
  const char *at, *end;
  size_t base; /* of `at` in the body, for declared-before-use; or SIZE_MAX */
  const char *begin;
  bool failed;
} reader;

static void refuse(reader *r, const char *what, const char *name) {
  if (!r->failed) {
    r->failed = true;
    const char *line = r->at;
    while (line > r->begin && line[-1] != '\n') {
      line--;
    }
    line += strspn(line, " ");
    int length = (int)strcspn(line, "\n");
    emit_refuse(r->m, "%s%s%s%s in: %.*s", what, name[0] != '\0' ? " '" : "", name,
                name[0] != '\0' ? "'" : "", length < 120 ? length : 120, line);
  }
  r->at = r->end;
}

static void skip_blanks(reader *r) {
  while (r->at < r->end) {
    if (isspace((unsigned char)*r->at)) {
      r->at++;
    } else if (*r->at == '`' || (r->end - r->at > 1 && r->at[0] == '/' && r->at[1] == '/')) {
      while (r->at < r->end && *r->at != '\n') {
        r->at++;
      }
    } else {
      return;
    }
  }
}

static bool is_name_character(char c) { return isalnum((unsigned char)c) || c == '_'; }

/* Take a token if it is the next one; words are not taken as prefixes. */
static bool take(reader *r, const char *token) {
  skip_blanks(r);
  size_t length = strlen(token);
  if ((size_t)(r->end - r->at) < length || memcmp(r->at, token, length) != 0) {
    return false;
  }
  bool word = is_name_character(token[length - 1]);
  if (word && r->at + length < r->end && is_name_character(r->at[length])) {
    return false;
  }
  r->at += length;
  return true;
}

static bool next_is(reader *r, const char *token) {
  const char *at = r->at;
  bool found = take(r, token);
  r->at = at;
  return found;
}

static void expect(reader *r, const char *token) {
  if (!r->failed && !take(r, token)) {
    refuse(r, "expected", token);
  }
}

static bool take_name(reader *r, char name[EMIT_NAME]) {
  skip_blanks(r);
  size_t length = 0;
  while (r->at + length < r->end && is_name_character(r->at[length])) {
    length++;
  }
  if (length == 0 || isdigit((unsigned char)*r->at) || length >= EMIT_NAME) {
    return false;
  }
  memcpy(name, r->at, length);
  name[length] = '\0';
  r->at += length;
  return true;
}

static const emit_symbol *find_symbol(const emit_module *m, const char *name) {
  for (int i = 0; i < m->symbols; i++) {
    if (strcmp(m->symbol[i].name, name) == 0) {
      return &m->symbol[i];
    }
  }
  return NULL;
}

/* --------------------------------------------------------- constant expressions */

static int constant_sum(reader *r);

static int parameter_value(reader *r, const char *name) {
  const emit_symbol *s = find_symbol(r->m, name);
  if (s == NULL || (s->kind != EMIT_PARAMETER && s->kind != EMIT_LOCALPARAM)) {
    refuse(r, "no such parameter", name);
    return 0;
  }
  for (int i = 0; i < r->override_count; i++) {
    if (s->kind == EMIT_PARAMETER && strcmp(r->overrides[i].name, name) == 0) {
      return r->overrides[i].value;
    }
  }
  return s->value;
}

static int constant_factor(reader *r) {
  char name[EMIT_NAME];
  skip_blanks(r);
  if (take(r, "(")) {
    int value = constant_sum(r);
    expect(r, ")");
    return value;
  }
  if (r->at < r->end && isdigit((unsigned char)*r->at)) {
    int value = 0;
    while (r->at < r->end && isdigit((unsigned char)*r->at) && value < 100000) {
      value = 10 * value + (*r->at++ - '0');
    }
    return value;
  }
  if (take_name(r, name)) {
    return parameter_value(r, name);
  }
  refuse(r, "no constant", "");
  return 0;
}

static int constant_product(reader *r) {
  int value = constant_factor(r);
  while (take(r, "*")) {
    value *= constant_factor(r);
  }
  return value;
}

static int constant_sum(reader *r) {
  int value = constant_product(r);
  for (;;) {
    if (take(r, "+")) {
      value += constant_product(r);
    } else if (take(r, "-")) {
      value -= constant_product(r);
    } else {
      return value;
    }
  }
}

static reader read_text(const emit_module *m, const emit_binding *overrides, int count,
                        const char *text) {
  return (reader){m, overrides, count, text, text + strlen(text), SIZE_MAX, text, false};
}

bool emit_constant(const emit_module *m, const emit_binding *overrides, int count,
                   const char *expression, int *value) {
  reader r = read_text(m, overrides, count, expression);
  *value = constant_sum(&r);
  skip_blanks(&r);
  if (!r.failed && r.at != r.end) {
    refuse(&r, "not a constant expression", expression);
  }
  return !r.failed;
}

static int symbol_width(reader *r, const emit_symbol *s) {
  int width = 1;
  if (s->width[0] != '\0' &&
      !emit_constant(r->m, r->overrides, r->override_count, s->width, &width)) {
    r->failed = true;
  }
  if (!r->failed && width < 1) {
    refuse(r, "no bits in", s->name);
  }
  return width;
}

/* ------------------------------------------------------------------ expressions */

static int expression(reader *r);

/* [msb:lsb] or [bit] behind a name of `width` bits. */
static int selected_width(reader *r, int width, const char *name) {
  if (!take(r, "[")) {
    return width;
  }
  int msb = constant_sum(r);
  int lsb = take(r, ":") ? constant_sum(r) : msb;
  expect(r, "]");
  if (!r->failed && (msb >= width || lsb < 0 || msb < lsb)) {
    refuse(r, "select outside of", name);
  }
  return msb - lsb + 1;
}

static void same_width(reader *r, const char *operator_text, int left, int right) {
  if (!r->failed && left != right) {
    char what[96];
    snprintf(what, sizeof what, "%.40s: %d bits against %d", operator_text, left, right);
    refuse(r, what, "");
  }
}

/* [address] behind a memory's name. */
static int word_width(reader *r, const emit_symbol *s) {
  int bits = 0;
  if (!emit_constant(r->m, r->overrides, r->override_count, s->address, &bits)) {
    r->failed = true;
  }
  expect(r, "[");
  same_width(r, "address of a memory", expression(r), bits);
  expect(r, "]");
  return symbol_width(r, s);
}

static int signal_width(reader *r, const char *name, bool assigned) {
  const emit_symbol *s = find_symbol(r->m, name);
  if (s == NULL || s->kind < EMIT_INPUT || s->kind == EMIT_LABEL) {
    refuse(r, "undeclared signal", name);
    return 1;
  }
  bool header = s->end == 0;
  if (!header && r->base != SIZE_MAX && r->base + (size_t)(r->at - r->begin) < s->end) {
    refuse(r, "used before it is declared:", name);
    return 1;
  }
  if (assigned && s->kind == EMIT_INPUT) {
    refuse(r, "an input is assigned:", name);
    return 1;
  }
  if (s->address[0] != '\0') {
    return word_width(r, s);
  }
  return selected_width(r, symbol_width(r, s), name);
}

static int literal_width(reader *r) {
  int width = 0;
  while (r->at < r->end && isdigit((unsigned char)*r->at)) {
    width = 10 * width + (*r->at++ - '0');
  }
  if (r->at == r->end || *r->at != '\'') {
    refuse(r, "a literal without a size", "");
    return 1;
  }
  r->at++;
  while (r->at < r->end && is_name_character(*r->at)) {
    r->at++;
  }
  return width;
}

/* {a, b} or {N{a}} behind the opening brace. */
static int braces(reader *r) {
  const char *start = r->at;
  char name[EMIT_NAME];
  skip_blanks(r);
  bool counted = r->at < r->end && (*r->at == '(' || isdigit((unsigned char)*r->at));
  if (take_name(r, name)) {
    const emit_symbol *s = find_symbol(r->m, name);
    counted = s != NULL && s->kind <= EMIT_LOCALPARAM;
  }
  r->at = start;
  if (counted) {
    const char *literal = r->at;
    while (literal < r->end && isdigit((unsigned char)*literal)) {
      literal++;
    }
    counted = *literal != '\'';
  }
  if (counted) {
    int times = constant_sum(r);
    expect(r, "{");
    int width = expression(r);
    expect(r, "}");
    expect(r, "}");
    if (!r->failed && times < 1) {
      refuse(r, "replication by less than one", "");
    }
    return times * width;
  }
  int width = expression(r);
  while (take(r, ",")) {
    width += expression(r);
  }
  expect(r, "}");
  return width;
}

static int primary(reader *r) {
  char name[EMIT_NAME];
  skip_blanks(r);
  if (take(r, "(")) {
    int width = expression(r);
    expect(r, ")");
    return width;
  }
  if (take(r, "{")) {
    return braces(r);
  }
  if (take(r, "$signed")) {
    expect(r, "(");
    int width = expression(r);
    expect(r, ")");
    return width;
  }
  if (take(r, "~") || take(r, "-")) {
    return primary(r);
  }
  if (take(r, "!")) {
    same_width(r, "operand of !", primary(r), 1);
    return 1;
  }
  if (take(r, "&") || take(r, "|")) {
    primary(r);
    return 1;
  }
  if (r->at < r->end && isdigit((unsigned char)*r->at)) {
    return literal_width(r);
  }
  if (take_name(r, name)) {
    return signal_width(r, name, false);
  }
  refuse(r, "expression not understood", "");
  return 1;
}

typedef struct {
  const char *text;
  int level;
  bool compares, logical;
} operator_row;

static const operator_row operators[] = {
    {"||", 0, false, true}, {"&&", 1, false, true}, {"==", 4, true, false}, {"!=", 4, true, false},
    {"<=", 5, true, false}, {">=", 5, true, false}, {"<", 5, true, false},  {">", 5, true, false},
    {"|", 2, false, false}, {"^", 2, false, false}, {"&", 3, false, false}, {"+", 6, false, false},
    {"-", 6, false, false}, {"*", 7, false, false},
};
enum { OPERATOR_ROWS = sizeof operators / sizeof operators[0], OPERATOR_LEVELS = 8 };

static const operator_row *take_operator(reader *r, int level) {
  skip_blanks(r);
  if (r->at == r->end || strchr("|&=!<>^+-*", *r->at) == NULL) {
    return NULL;
  }
  for (int i = 0; i < OPERATOR_ROWS; i++) {
    if (next_is(r, operators[i].text)) {
      if (operators[i].level != level) {
        return NULL;
      }
      take(r, operators[i].text);
      return &operators[i];
    }
  }
  return NULL;
}

static int binary(reader *r, int level) {
  if (level == OPERATOR_LEVELS) {
    return primary(r);
  }
  int width = binary(r, level + 1);
  for (const operator_row *o; !r->failed && (o = take_operator(r, level)) != NULL;) {
    int right = binary(r, level + 1);
    same_width(r, o->text, width, right);
    if (o->logical) {
      same_width(r, o->text, width, 1);
    }
    width = o->compares ? 1 : width;
  }
  return width;
}

static int expression(reader *r) {
  int width = binary(r, 0);
  if (take(r, "?")) {
    same_width(r, "condition", width, 1);
    width = expression(r);
    expect(r, ":");
    same_width(r, "arms of ?:", width, expression(r));
  }
  return width;
}

/* ------------------------------------------------------------------- statements */

static void assignment(reader *r, const char *operator_text) {
  char name[EMIT_NAME];
  if (!take_name(r, name)) {
    refuse(r, "statement not understood", "");
    return;
  }
  int left = signal_width(r, name, true);
  expect(r, operator_text);
  same_width(r, operator_text, left, expression(r));
  expect(r, ";");
}

static void statement(reader *r) {
  if (take(r, "begin")) {
    while (!r->failed && !take(r, "end")) {
      statement(r);
    }
  } else if (take(r, "if")) {
    expect(r, "(");
    same_width(r, "condition", expression(r), 1);
    expect(r, ")");
    statement(r);
    if (take(r, "else")) {
      statement(r);
    }
  } else {
    assignment(r, "<=");
  }
}

static void skip_generate(reader *r) {
  while (r->at < r->end && !next_is(r, "endgenerate")) {
    r->at++;
  }
}

/* generate if (P > Q) begin : label ... end endgenerate: the body holds a wire of
 * its own, and is read only where the condition holds. */
static void generate(reader *r) {
  expect(r, "if");
  expect(r, "(");
  int left = constant_sum(r);
  expect(r, ">");
  int right = constant_sum(r);
  expect(r, ")");
  if (left <= right) {
    skip_generate(r);
  } else {
    char name[EMIT_NAME] = "";
    expect(r, "begin");
    expect(r, ":");
    take_name(r, name);
    expect(r, "wire");
    expect(r, "[");
    int msb = constant_sum(r);
    expect(r, ":0]");
    take_name(r, name);
    expect(r, "=");
    same_width(r, name, msb + 1, expression(r));
    expect(r, ";");
    expect(r, "end");
  }
  expect(r, "endgenerate");
}

static void item(reader *r) {
  if (take(r, "assign")) {
    assignment(r, "=");
  } else if (take(r, "always")) {
    expect(r, "@(posedge clk)");
    statement(r);
  } else if (take(r, "generate")) {
    generate(r);
  } else {
    refuse(r, "item not understood", "");
  }
}

/* --------------------------------------------------------------------- instances */

static bool split_binding(const emit_module *m, char *item_text, char **name, char **value) {
  item_text += strspn(item_text, " \n");
  char *equals = strchr(item_text, '=');
  if (equals == NULL) {
    emit_refuse(m, "binding '%s' is not NAME=VALUE", item_text);
    return false;
  }
  *equals = '\0';
  *name = item_text;
  *value = equals + 1;
  return true;
}

static int bind_parameters(reader *r, const emit_instance_record *i,
                           emit_binding bound[EMIT_PORTS]) {
  char copy[1024];
  char *rest = NULL;
  int count = 0;
  snprintf(copy, sizeof copy, "%s", i->parameters);
  for (char *p = strtok_r(copy, ",", &rest); p != NULL; p = strtok_r(NULL, ",", &rest)) {
    char *name = NULL;
    char *value = NULL;
    if (!split_binding(r->m, p, &name, &value)) {
      r->failed = true;
      return count;
    }
    const emit_symbol *s = find_symbol(i->module, name);
    if (s == NULL || s->kind != EMIT_PARAMETER) {
      r->failed = !emit_refuse(r->m, "%s: no parameter '%s'", i->name, name);
      return count;
    }
    snprintf(bound[count].name, EMIT_NAME, "%s", name);
    if (!emit_constant(r->m, r->overrides, r->override_count, value, &bound[count].value)) {
      r->failed = true;
      return count;
    }
    count++;
  }
  return count;
}

static int count_ports(const emit_module *m) {
  int ports = 0;
  for (int i = 0; i < m->symbols; i++) {
    emit_kind kind = m->symbol[i].kind;
    ports += kind == EMIT_INPUT || kind == EMIT_OUTPUT || kind == EMIT_OUTPUT_REG;
  }
  return ports;
}

static bool connect(reader *r, const emit_instance_record *i, const emit_binding *bound, int count,
                    const char *port, const char *signal) {
  const emit_symbol *s = find_symbol(i->module, port);
  if (s == NULL || s->kind < EMIT_INPUT || s->kind > EMIT_OUTPUT_REG) {
    return emit_refuse(r->m, "%s: %s has no port '%s'", i->name, i->module->name, port);
  }
  int wanted = 1;
  if (s->width[0] != '\0' && !emit_constant(i->module, bound, count, s->width, &wanted)) {
    return false;
  }
  reader value = read_text(r->m, r->overrides, r->override_count, signal);
  value.base = i->begin;
  int given = expression(&value);
  if (value.failed) {
    return false;
  }
  if (given != wanted) {
    return emit_refuse(r->m, "%s: port '%s' has %d bits, '%s' has %d", i->name, port, wanted,
                       signal, given);
  }
  return true;
}

/* "sepax_mul A_W=18 ...": a module with the values that its parameters have. */
static char *variant_of(const emit_module *m, const emit_binding *bound, int count) {
  char *text = NULL;
  size_t size = 0;
  FILE *out = open_memstream(&text, &size);
  if (out == NULL) {
    abort();
  }
  reader r = read_text(m, bound, count, "");
  fputs(m->name, out);
  for (int i = 0; i < m->symbols; i++) {
    if (m->symbol[i].kind == EMIT_PARAMETER) {
      fprintf(out, " %s=%d", m->symbol[i].name, parameter_value(&r, m->symbol[i].name));
    }
  }
  fclose(out);
  return text;
}

/* Check a variant of a module, once. */
static bool check_variant(const emit_module *m, const emit_binding *bound, int count) {
  emitter *e = m->emitter;
  char *variant = variant_of(m, bound, count);
  for (int i = 0; i < e->variants; i++) {
    if (strcmp(e->variant[i], variant) == 0) {
      free(variant);
      return true;
    }
  }
  bool ok = emit_check(m, bound, count);
  if (ok && e->variants < EMIT_VARIANTS) {
    e->variant[e->variants++] = variant;
  } else {
    free(variant);
  }
  return ok;
}

/* Check the connections "port=signal, ..." in `copy`, which is taken apart. */
static bool check_connections(reader *r, const emit_instance_record *i, const emit_binding *bound,
                              int count, char *copy) {
  char *rest = NULL;
  char seen[EMIT_PORTS][EMIT_NAME];
  int connected = 0;
  for (char *p = strtok_r(copy, ",", &rest); p != NULL; p = strtok_r(NULL, ",", &rest)) {
    char *port = NULL;
    char *signal = NULL;
    if (!split_binding(r->m, p, &port, &signal) || !connect(r, i, bound, count, port, signal)) {
      return false;
    }
    for (int k = 0; k < connected; k++) {
      if (strcmp(seen[k], port) == 0) {
        return emit_refuse(r->m, "%s: port '%s' is connected twice", i->name, port);
      }
    }
    if (connected == EMIT_PORTS) {
      return emit_refuse(r->m, "%s: more than %d ports", i->name, EMIT_PORTS);
    }
    snprintf(seen[connected++], EMIT_NAME, "%s", port);
  }
  if (connected != count_ports(i->module)) {
    return emit_refuse(r->m, "%s: %d of the %d ports of %s are connected", i->name, connected,
                       count_ports(i->module), i->module->name);
  }
  return true;
}

static bool check_instance(reader *r, const emit_instance_record *i) {
  emit_binding bound[EMIT_PORTS];
  int count = bind_parameters(r, i, bound);
  if (r->failed || !check_variant(i->module, bound, count)) {
    return false;
  }
  char *copy = strdup(i->connections);
  bool ok = copy != NULL && check_connections(r, i, bound, count, copy);
  free(copy);
  return ok;
}

/* The body with declarations and instances blanked out, which are checked apart. */
static char *statements_of(const emit_module *m) {
  char *code = strndup(m->body, m->body_size);
  if (code == NULL) {
    abort();
  }
  for (int i = 0; i < m->symbols; i++) {
    const emit_symbol *s = &m->symbol[i];
    memset(code + s->begin, ' ', s->end - s->begin);
  }
  return code;
}

bool emit_check(const emit_module *m, const emit_binding *overrides, int count) {
  char *code = statements_of(m);
  reader r = {m, overrides, count, code, code + m->body_size, 0, code, false};
  for (int i = 0; i < m->symbols && !r.failed; i++) {
    if (m->symbol[i].kind >= EMIT_INPUT && m->symbol[i].kind != EMIT_LABEL) {
      symbol_width(&r, &m->symbol[i]);
    }
  }
  skip_blanks(&r);
  while (!r.failed && r.at < r.end) {
    item(&r);
    skip_blanks(&r);
  }
  for (int i = 0; i < m->instances && !r.failed; i++) {
    r.failed = !check_instance(&r, &m->instance[i]);
  }
  free(code);
  return !r.failed;
}
