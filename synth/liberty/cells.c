/* cells.c - a reader of Liberty files, as far as gates and their power need it. */
#include "cells.h"
#include "text.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A statement: name (args) { body } or name : value. */
typedef struct node {
  char *name, *args, *value;
  struct node *child, *next;
} node;

static char *copy(const char *from, size_t length) {
  char *text = text_room(length + 1, 1);
  memcpy(text, from, length);
  return text;
}

/* --------------------------------------------------------------------- the text */

/* Comments and continued lines become blanks. */
static void blank_comments(char *text) {
  for (char *p = text; *p != '\0'; p++) {
    if (p[0] == '/' && p[1] == '*') {
      char *end = strstr(p + 2, "*/");
      end = end == NULL ? p + strlen(p) : end + 2;
      memset(p, ' ', (size_t)(end - p));
      p = end - 1;
    } else if (p[0] == '\\') {
      *p = ' ';
      while (p[1] == '\r' || p[1] == '\n') {
        *++p = ' ';
      }
    }
  }
}

static const char *skip(const char *p) {
  while (isspace((unsigned char)*p) || *p == ';') {
    p++;
  }
  return p;
}

static char *trimmed(const char *from, const char *to) {
  while (from < to && (isspace((unsigned char)*from) || *from == '"')) {
    from++;
  }
  while (to > from && (isspace((unsigned char)to[-1]) || to[-1] == '"')) {
    to--;
  }
  return copy(from, (size_t)(to - from));
}

static const char *parse_value(node *n, const char *p) {
  const char *start = ++p;
  bool quoted = false;
  while (*p != '\0' && (quoted || (*p != ';' && *p != '\n' && *p != '}'))) {
    quoted ^= *p++ == '"';
  }
  n->value = trimmed(start, p);
  return p;
}

static const char *parse_args(node *n, const char *p) {
  const char *start = ++p;
  bool quoted = false;
  while (*p != '\0' && (quoted || *p != ')')) {
    quoted ^= *p++ == '"';
  }
  n->args = trimmed(start, p);
  return skip(*p == ')' ? p + 1 : p);
}

static const char *parse_body(node *parent, const char *p) {
  node **tail = &parent->child;
  for (p = skip(p); *p != '\0' && *p != '}'; p = skip(p)) {
    const char *start = p;
    while (isalnum((unsigned char)*p) || *p == '_') {
      p++;
    }
    if (p == start) {
      text_fail("is not understood at", copy(p, strnlen(p, 20)));
    }
    node *n = text_room(1, sizeof *n);
    n->name = copy(start, (size_t)(p - start));
    *tail = n;
    tail = &n->next;
    p = skip(p);
    if (*p == ':') {
      p = parse_value(n, p);
    } else if (*p == '(') {
      p = parse_args(n, p);
      if (*p == '{') {
        p = parse_body(n, p + 1);
        p += *p == '}';
      }
    }
  }
  return p;
}

static void free_nodes(node *n) {
  while (n != NULL) {
    node *next = n->next;
    free_nodes(n->child);
    free(n->name);
    free(n->args);
    free(n->value);
    free(n);
    n = next;
  }
}

static const node *child(const node *n, const char *name) {
  for (n = n->child; n != NULL && strcmp(n->name, name) != 0; n = n->next) {}
  return n;
}

static const char *value_of(const node *n, const char *name) {
  const node *c = child(n, name);
  return c == NULL ? NULL : c->value;
}

static double number_of(const node *n, const char *name, double other) {
  const char *value = value_of(n, name);
  return value == NULL ? other : strtod(value, NULL);
}

/* ------------------------------------------------------------------- functions */

typedef struct {
  const char *p;
  const lib_cell *cell;
  const char *state, *state_not;
  lib_function *f;
} parser;

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
  char *name = copy(start, (size_t)(s->p - start));
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

static void parse_function(lib_function *f, const lib_cell *cell, const char *text,
                           const char *state, const char *state_not) {
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

static int input_count(const lib_cell *cell) {
  int inputs = 0;
  for (int k = 0; k < cell->pins; k++) {
    inputs += !cell->pin[k].output;
  }
  return inputs;
}

/* Bit r: the function in row r. Outputs are what they are in that row. */
static uint64_t mask_of(const lib_cell *cell, const lib_function *f) {
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
  int inputs = input_count(cell);
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

/* ---------------------------------------------------------------------- tables */

static int parse_numbers(const char *text, double *list, int most) {
  int n = 0;
  while (*text != '\0') {
    char *end;
    double x = strtod(text, &end);
    if (end == text) {
      text++;
      continue;
    }
    if (n == most) {
      text_fail("has a table that is too large,", "more than 16 entries");
    }
    list[n++] = x;
    text = end;
  }
  return n;
}

static const node *find_template(const node *root, const char *name) {
  for (const node *n = root->child; n != NULL; n = n->next) {
    if ((strcmp(n->name, "lu_table_template") == 0 || strcmp(n->name, "power_lut_template") == 0) &&
        strcmp(n->args, name) == 0) {
      return n;
    }
  }
  return NULL;
}

static int index_of(const node *table, const node *model, const char *name, double *list) {
  const node *n = child(table, name);
  if (n == NULL && model != NULL) {
    n = child(model, name);
  }
  return n == NULL || n->args == NULL ? 0 : parse_numbers(n->args, list, LIB_INDEX);
}

static void read_table(lib_table *t, const node *root, const node *n) {
  if (n == NULL) {
    return;
  }
  const node *model = find_template(root, n->args);
  const char *first = model == NULL ? NULL : value_of(model, "variable_1");
  double axis[2][LIB_INDEX];
  int count[2] = {index_of(n, model, "index_1", axis[0]), index_of(n, model, "index_2", axis[1])};
  const node *values = child(n, "values");
  if (values == NULL) {
    return;
  }
  static double list[LIB_INDEX * LIB_INDEX];
  int rows = count[0] > 0 ? count[0] : 1;
  int columns = count[1] > 0 ? count[1] : 1;
  if (parse_numbers(values->args, list, LIB_INDEX * LIB_INDEX) != rows * columns) {
    text_fail("has a table of wrong size,", n->name);
  }
  bool slope_first = first == NULL || strstr(first, "transition") != NULL;
  t->given = true;
  t->slopes = slope_first ? rows : columns;
  t->loads = slope_first ? columns : rows;
  memcpy(t->slope, axis[slope_first ? 0 : 1], sizeof t->slope);
  memcpy(t->load, axis[slope_first ? 1 : 0], sizeof t->load);
  for (int r = 0; r < rows; r++) {
    for (int c = 0; c < columns; c++) {
      t->value[slope_first ? r : c][slope_first ? c : r] = list[r * columns + c];
    }
  }
}

static int place(const double *axis, int n, double x, double *part) {
  if (n < 2) {
    *part = 0;
    return 0;
  }
  int k = 0;
  while (k + 2 < n && x >= axis[k + 1]) {
    k++;
  }
  *part = (x - axis[k]) / (axis[k + 1] - axis[k]);
  return k;
}

double lib_look_up(const lib_table *t, double slope, double load) {
  if (!t->given) {
    return 0;
  }
  double ps;
  double pl;
  int s = place(t->slope, t->slopes, slope, &ps);
  int l = place(t->load, t->loads, load, &pl);
  int s2 = s + (t->slopes > 1);
  int l2 = l + (t->loads > 1);
  return (1 - ps) * ((1 - pl) * t->value[s][l] + pl * t->value[s][l2]) +
         ps * ((1 - pl) * t->value[s2][l] + pl * t->value[s2][l2]);
}

/* ----------------------------------------------------------------------- cells */

int lib_pin_index(const lib_cell *cell, const char *name) {
  for (int k = 0; k < cell->pins; k++) {
    if (strcmp(cell->pin[k].name, name) == 0) {
      return k;
    }
  }
  return -1;
}

static bool is_pin(const node *n) {
  const char *direction = strcmp(n->name, "pin") == 0 ? value_of(n, "direction") : NULL;
  return direction != NULL && strcmp(direction, "internal") != 0;
}

static void read_pin_names(lib_cell *cell, const library *lib, const node *n) {
  for (const node *p = n->child; p != NULL; p = p->next) {
    if (!is_pin(p)) {
      continue;
    }
    if (cell->pins == LIB_PINS) {
      text_fail("too many pins in", cell->name);
    }
    lib_pin *pin = &cell->pin[cell->pins++];
    pin->name = copy(p->args, strlen(p->args));
    pin->output = strcmp(value_of(p, "direction"), "output") == 0;
    pin->capacitance = number_of(p, "capacitance", 0) * lib->farad;
  }
}

static void read_register(lib_cell *cell, const node *ff, char *state[2]) {
  char *comma = strchr(ff->args, ',');
  if (comma == NULL || value_of(ff, "next_state") == NULL || child(ff, "clear") != NULL ||
      child(ff, "preset") != NULL) {
    return; /* not one that the netlists have; library_cell's user sees it has no function */
  }
  state[0] = trimmed(ff->args, comma);
  state[1] = trimmed(comma + 1, comma + strlen(comma));
  parse_function(&cell->next, cell, value_of(ff, "next_state"), state[0], state[1]);
  const char *clock = value_of(ff, "clocked_on");
  cell->clock = clock == NULL ? -1 : lib_pin_index(cell, clock);
  cell->register_ = cell->clock >= 0;
}

static void read_powers(lib_cell *cell, const node *root, const node *p, int pin, char *state[2]) {
  for (const node *n = p->child; n != NULL; n = n->next) {
    if (strcmp(n->name, "internal_power") != 0) {
      continue;
    }
    cell->power = realloc(cell->power, (size_t)(cell->powers + 1) * sizeof *cell->power);
    if (cell->power == NULL) {
      text_fail("out of", "memory");
    }
    lib_power *power = &cell->power[cell->powers++];
    memset(power, 0, sizeof *power);
    power->pin = pin;
    const char *related = value_of(n, "related_pin");
    power->related = related == NULL ? -1 : lib_pin_index(cell, related);
    power->when = ~UINT64_C(0);
    if (value_of(n, "when") != NULL) {
      lib_function when = {0};
      parse_function(&when, cell, value_of(n, "when"), state[0], state[1]);
      power->when = mask_of(cell, &when);
    }
    read_table(&power->energy[0], root, child(n, "rise_power"));
    read_table(&power->energy[1], root, child(n, "fall_power"));
  }
}

static void read_arcs(lib_cell *cell, const node *root, const node *p, int pin) {
  for (const node *n = p->child; n != NULL; n = n->next) {
    const char *related = strcmp(n->name, "timing") == 0 ? value_of(n, "related_pin") : NULL;
    const char *sense = related == NULL ? NULL : value_of(n, "timing_sense");
    const char *type = related == NULL ? NULL : value_of(n, "timing_type");
    if (related == NULL || child(n, "rise_transition") == NULL) {
      continue;
    }
    cell->arc = realloc(cell->arc, (size_t)(cell->arcs + 1) * sizeof *cell->arc);
    if (cell->arc == NULL) {
      text_fail("out of", "memory");
    }
    lib_arc *arc = &cell->arc[cell->arcs++];
    memset(arc, 0, sizeof *arc);
    arc->to = pin;
    arc->from = lib_pin_index(cell, related);
    arc->clocked = type != NULL && strcmp(type, "rising_edge") == 0;
    arc->on_rise = sense == NULL || strcmp(sense, "negative_unate") != 0;
    arc->on_fall = sense == NULL || strcmp(sense, "positive_unate") != 0;
    read_table(&arc->slope[0], root, child(n, "rise_transition"));
    read_table(&arc->slope[1], root, child(n, "fall_transition"));
  }
}

/* All functions first, as a `when` may ask for an output. */
static void read_pins(lib_cell *cell, const node *root, const node *n, char *state[2]) {
  int pin = 0;
  for (const node *p = n->child; p != NULL; p = p->next) {
    if (is_pin(p)) {
      if (child(p, "three_state") == NULL && value_of(p, "function") != NULL) {
        parse_function(&cell->pin[pin].function, cell, value_of(p, "function"), state[0], state[1]);
      }
      pin++;
    }
  }
  pin = 0;
  for (const node *p = n->child; p != NULL; p = p->next) {
    if (is_pin(p)) {
      read_powers(cell, root, p, pin, state);
      read_arcs(cell, root, p, pin++);
    }
  }
}

static void read_cell(lib_cell *cell, const library *lib, const node *root, const node *n,
                      double watt) {
  char *state[2] = {NULL, NULL};
  cell->name = copy(n->args, strlen(n->args));
  cell->leakage = number_of(n, "cell_leakage_power", 0) * watt;
  read_pin_names(cell, lib, n);
  if (child(n, "ff") != NULL) {
    read_register(cell, child(n, "ff"), state);
  }
  if (child(n, "latch") == NULL && child(n, "statetable") == NULL &&
      (child(n, "ff") == NULL || cell->register_) && input_count(cell) + cell->register_ <= 6) {
    read_pins(cell, root, n, state);
  }
  free(state[0]);
  free(state[1]);
}

static double unit_of(const char *text, double other) {
  double scale = 1;
  if (text == NULL) {
    return other;
  }
  char *end;
  double number = strtod(text, &end);
  while (*end != '\0' && !isalpha((unsigned char)*end)) {
    end++;
  }
  switch (tolower((unsigned char)*end)) {
  case 'm':
    scale = 1e-3;
    break;
  case 'u':
    scale = 1e-6;
    break;
  case 'n':
    scale = 1e-9;
    break;
  case 'p':
    scale = 1e-12;
    break;
  case 'f':
    scale = 1e-15;
    break;
  default:
    break;
  }
  return number * scale;
}

/* The default wire load: a length for a number of loads, linear between, `slope` beyond. */
static void read_wires(library *lib, const node *root) {
  const char *name = value_of(root, "default_wire_load");
  const node *model = root->child;
  while (model != NULL && (name == NULL || strcmp(model->name, "wire_load") != 0 ||
                           strcmp(model->args, name) != 0)) {
    model = model->next;
  }
  if (model == NULL) {
    return;
  }
  double at = 0;
  double length = 0;
  double slope = 0;
  int next = 1;
  for (const node *n = model->child; n != NULL; n = n->next) {
    double point[2];
    if (strcmp(n->name, "fanout_length") != 0 || parse_numbers(n->args, point, 2) != 2) {
      continue;
    }
    slope = (point[1] - length) / (point[0] - at);
    for (; next < LIB_FANOUT && next <= point[0]; next++) {
      lib->wire[next] = at == 0 ? point[1] : length + slope * (next - at);
    }
    at = point[0];
    length = point[1];
  }
  for (slope = number_of(model, "slope", slope); next < LIB_FANOUT; next++) {
    lib->wire[next] = length + slope * (next - at);
  }
  for (next = 0; next < LIB_FANOUT; next++) {
    lib->wire[next] *= number_of(model, "capacitance", 0) * lib->farad;
  }
}

void library_read(library *lib, const char *path) {
  text_file = path;
  char *text = text_read("give a plain Liberty file");
  blank_comments(text);
  node top = {0};
  parse_body(&top, text);
  const node *root = child(&top, "library");
  if (root == NULL) {
    text_fail("is no", "Liberty file");
  }
  const node *load = child(root, "capacitive_load_unit");
  lib->farad = load == NULL ? 1e-12 : unit_of(load->args, 1e-12);
  lib->volt = number_of(root, "nom_voltage", 0);
  double volt_unit = unit_of(value_of(root, "voltage_unit"), 1);
  lib->joule = lib->farad * volt_unit * volt_unit;
  double watt = unit_of(value_of(root, "leakage_power_unit"), 1e-9);
  read_wires(lib, root);
  for (const node *n = root->child; n != NULL; n = n->next) {
    lib->cells += strcmp(n->name, "cell") == 0;
  }
  lib->cell = text_room(lib->cells, sizeof *lib->cell);
  size_t k = 0;
  for (const node *n = root->child; n != NULL; n = n->next) {
    if (strcmp(n->name, "cell") == 0) {
      read_cell(&lib->cell[k++], lib, root, n, watt);
    }
  }
  free_nodes(top.child);
  free(text);
}

const lib_cell *library_cell(const library *lib, const char *name) {
  for (size_t k = 0; k < lib->cells; k++) {
    if (strcmp(lib->cell[k].name, name) == 0) {
      return &lib->cell[k];
    }
  }
  return NULL;
}
