/* gates.c - reads a mapped netlist and simulates it, 64 lanes at once. */
#include "gates.h"
#include "sepax_vectors.h"
#include "liberty/text.h"

#include <ctype.h>
#include <search.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void *more(void *list, size_t count, size_t size) { /* room for one more */
  if (count > 0 && (count & (count - 1)) != 0) {
    return list;
  }
  list = realloc(list, (count == 0 ? 1 : 2 * count) * size);
  if (list == NULL) {
    text_fail("out of", "memory");
  }
  return list;
}

/* ------------------------------------------------------------------ the modules */

/* Bits of a port, nets of a connection: numbers of the module's own nets; 0 and 1 are constants. */
typedef struct {
  char *name;
  int *bit; /* the highest first */
  int bits;
  bool vector, output;
} bundle;

typedef struct {
  char *type, *name;
  bundle *pin;
  int pins;
} instance;

typedef struct {
  char *name;
  bundle *port;
  int ports;
  instance *instance;
  int instances;
  int (*alias)[2];
  int aliases;
  int nets;
  char **net_name;
} module;

typedef struct {
  module *module;
  int modules;
  const char *p; /* the text that is left */
  char token[256];
  bool escaped;
} reader;

/* Names of nets of the module that is read. One hash table, open addresses. */
enum { SLOTS = 1 << 20 };
static int slot[SLOTS];

static unsigned hash(const char *name) {
  unsigned h = 2166136261U;
  for (; *name != '\0'; name++) {
    h = (h ^ (unsigned char)*name) * 16777619U;
  }
  return h % SLOTS;
}

static int net_number(module *m, const char *name) {
  unsigned h = hash(name);
  for (; slot[h] != 0; h = (h + 1) % SLOTS) {
    if (strcmp(m->net_name[slot[h]], name) == 0) {
      return slot[h];
    }
  }
  if (m->nets > SLOTS / 2) {
    text_fail("too many nets in", m->name);
  }
  m->net_name = more(m->net_name, (size_t)m->nets, sizeof *m->net_name);
  m->net_name[m->nets] = strdup(name);
  slot[h] = m->nets;
  return m->nets++;
}

static void new_names(module *m) {
  memset(slot, 0, sizeof slot);
  m->nets = 0;
  for (; m->nets < 2; m->nets++) { /* the constants */
    m->net_name = more(m->net_name, (size_t)m->nets, sizeof *m->net_name);
    m->net_name[m->nets] = strdup("");
  }
}

static bool next_token(reader *r) {
  for (;;) {
    while (isspace((unsigned char)*r->p)) {
      r->p++;
    }
    if (r->p[0] == '/' && r->p[1] == '*') {
      const char *end = strstr(r->p, "*/");
      r->p = end == NULL ? r->p + strlen(r->p) : end + 2;
    } else if (r->p[0] == '/' && r->p[1] == '/') {
      r->p += strcspn(r->p, "\n");
    } else {
      break;
    }
  }
  size_t length = 0;
  r->escaped = *r->p == '\\';
  if (r->escaped) {
    r->p++;
    length = strcspn(r->p, " \t\n");
  } else if (isalnum((unsigned char)*r->p) || *r->p == '_') {
    while (isalnum((unsigned char)r->p[length]) || r->p[length] == '_' || r->p[length] == '$' ||
           r->p[length] == '\'') {
      length++;
    }
  } else {
    length = *r->p != '\0';
  }
  if (length >= sizeof r->token) {
    text_fail("a name is too long:", r->p);
  }
  memcpy(r->token, r->p, length);
  r->token[length] = '\0';
  r->p += length;
  return length > 0;
}

static bool is(const reader *r, const char *text) {
  return !r->escaped && strcmp(r->token, text) == 0;
}

static void want(reader *r, const char *text) {
  next_token(r);
  if (!is(r, text)) {
    text_fail("what is not understood, before", r->token);
  }
}

static int want_number(reader *r) {
  next_token(r);
  return (int)strtol(r->token, NULL, 10);
}

static void add_bit(bundle *b, int net) {
  b->bit = more(b->bit, (size_t)b->bits, sizeof *b->bit);
  b->bit[b->bits++] = net;
}

static void add_constant(bundle *b, const char *text) {
  char *end;
  long bits = strtol(text, &end, 10);
  int base = end[0] != '\'' ? 0 : end[1] == 'h' ? 16 : end[1] == 'd' ? 10 : end[1] == 'b' ? 2 : 0;
  if (base == 0 || bits < 1 || bits > 64 || strpbrk(end + 2, "xzXZ") != NULL) {
    text_fail("a constant is not understood:", text);
  }
  uint64_t value = strtoull(end + 2, NULL, base);
  for (long k = bits - 1; k >= 0; k--) {
    add_bit(b, (int)(value >> k & 1));
  }
}

static const bundle *find_port(const module *m, const char *name) {
  for (int k = 0; k < m->ports; k++) {
    if (strcmp(m->port[k].name, name) == 0) {
      return &m->port[k];
    }
  }
  return NULL;
}

/* A signal, its token read: a name, name[3], name[3:1], a constant. */
static void add_signal(reader *r, module *m, bundle *b) {
  char name[300];
  if (!r->escaped && isdigit((unsigned char)r->token[0])) {
    add_constant(b, r->token);
    return;
  }
  snprintf(name, sizeof name, "%s", r->token);
  const char *back = r->p;
  if (r->escaped) {
    back = NULL;
  }
  while (back != NULL && isspace((unsigned char)*back)) {
    back++;
  }
  if (back != NULL && *back == '[') {
    next_token(r);
    int high = want_number(r);
    int low = high;
    next_token(r);
    if (is(r, ":")) {
      low = want_number(r);
      next_token(r);
    }
    for (int k = high; k >= low; k--) {
      char bit[320];
      snprintf(bit, sizeof bit, "%s[%d]", name, k);
      add_bit(b, net_number(m, bit));
    }
    return;
  }
  const bundle *port = find_port(m, name);
  if (port == NULL) {
    add_bit(b, net_number(m, name));
    return;
  }
  for (int k = 0; k < port->bits; k++) {
    add_bit(b, port->bit[k]);
  }
}

static void add_signals(reader *r, module *m, bundle *b) { /* ... or { ... } */
  if (!is(r, "{")) {
    add_signal(r, m, b);
    return;
  }
  while (next_token(r), !is(r, "}")) {
    if (!is(r, ",")) {
      add_signals(r, m, b);
    }
    if (r->token[0] == '\0') {
      text_fail("ends in", m->name);
    }
  }
}

/* input, output, wire, with [high:low] or without. */
static void read_signal(reader *r, module *m, bool wire, bool output) {
  int high = -1;
  int low = 0;
  next_token(r);
  if (is(r, "[")) {
    high = want_number(r);
    want(r, ":");
    low = want_number(r);
    want(r, "]");
    next_token(r);
  }
  bundle b = {.name = strdup(r->token), .vector = high >= 0, .output = output};
  if (!wire) {
    if (b.vector) {
      for (int k = high; k >= low; k--) {
        char bit[320];
        snprintf(bit, sizeof bit, "%s[%d]", b.name, k);
        add_bit(&b, net_number(m, bit));
      }
    } else {
      add_bit(&b, net_number(m, b.name));
    }
    m->port = more(m->port, (size_t)m->ports, sizeof *m->port);
    m->port[m->ports++] = b;
  } else {
    if (b.vector && find_port(m, b.name) == NULL) {
      text_fail("has a wire of several bits, which splitnets should have split:", b.name);
    }
    free(b.name);
  }
  want(r, ";");
}

static void read_assign(reader *r, module *m) {
  bundle side[2] = {{0}, {0}};
  next_token(r);
  add_signals(r, m, &side[0]);
  want(r, "=");
  next_token(r);
  add_signals(r, m, &side[1]);
  want(r, ";");
  if (side[0].bits != side[1].bits) {
    text_fail("an assignment of unequal widths in", m->name);
  }
  for (int k = 0; k < side[0].bits; k++) {
    m->alias = more(m->alias, (size_t)m->aliases, sizeof *m->alias);
    m->alias[m->aliases][0] = side[0].bit[k];
    m->alias[m->aliases++][1] = side[1].bit[k];
  }
  free(side[0].bit);
  free(side[1].bit);
}

static void read_instance(reader *r, module *m) {
  instance one = {.type = strdup(r->token)};
  next_token(r);
  one.name = strdup(r->token);
  want(r, "(");
  while (next_token(r), !is(r, ")")) {
    if (is(r, ",")) {
      continue;
    }
    if (!is(r, ".")) {
      text_fail("an instance is not understood:", one.name);
    }
    bundle pin = {0};
    next_token(r);
    pin.name = strdup(r->token);
    want(r, "(");
    next_token(r);
    if (!is(r, ")")) {
      add_signals(r, m, &pin);
      want(r, ")");
    }
    one.pin = more(one.pin, (size_t)one.pins, sizeof *one.pin);
    one.pin[one.pins++] = pin;
  }
  want(r, ";");
  m->instance = more(m->instance, (size_t)m->instances, sizeof *m->instance);
  m->instance[m->instances++] = one;
}

static void read_module(reader *r) {
  r->module = more(r->module, (size_t)r->modules, sizeof *r->module);
  module *m = &r->module[r->modules++];
  memset(m, 0, sizeof *m);
  next_token(r);
  m->name = strdup(r->token);
  new_names(m);
  while (next_token(r) && !is(r, ";")) {}
  while (next_token(r) && !is(r, "endmodule")) {
    if (is(r, "input") || is(r, "output") || is(r, "wire")) {
      read_signal(r, m, is(r, "wire"), is(r, "output"));
    } else if (is(r, "assign")) {
      read_assign(r, m);
    } else {
      read_instance(r, m);
    }
  }
  if (!is(r, "endmodule")) {
    text_fail("ends in", m->name);
  }
}

/* ---------------------------------------------------------------- all instances */

typedef struct {
  const reader *r;
  const library *lib;
  gates *g;
  int *same; /* of each net: one that it is the same as */
} builder;

static int new_net(builder *b) {
  b->same = more(b->same, (size_t)b->g->nets, sizeof *b->same);
  b->same[b->g->nets] = b->g->nets;
  return b->g->nets++;
}

static int root_of(builder *b, int net) {
  while (b->same[net] != net) {
    b->same[net] = b->same[b->same[net]];
    net = b->same[net];
  }
  return net;
}

static void join(builder *b, int net, int other) {
  net = root_of(b, net);
  other = root_of(b, other);
  if (net < 2 && other < 2 && net != other) {
    text_fail("0 and 1 are joined in", b->g->place[0].module);
  }
  b->same[net < other ? other : net] = net < other ? net : other;
}

static const module *find_module(const reader *r, const char *name) {
  for (int k = 0; k < r->modules; k++) {
    if (strcmp(r->module[k].name, name) == 0) {
      return &r->module[k];
    }
  }
  return NULL;
}

static void add_cell(builder *b, const instance *one, const int *net, int place) {
  const lib_cell *type = library_cell(b->lib, one->type);
  if (type == NULL) {
    text_fail("neither a module nor a cell of the library:", one->type);
  }
  gates *g = b->g;
  g->cell = more(g->cell, (size_t)g->cells, sizeof *g->cell);
  gates_cell *cell = &g->cell[g->cells++];
  *cell = (gates_cell){.type = type, .name = one->name, .place = place};
  for (int k = 0; k < LIB_PINS; k++) {
    cell->net[k] = -1;
  }
  for (int k = 0; k < one->pins; k++) {
    int pin = lib_pin_index(type, one->pin[k].name);
    if (pin < 0 || one->pin[k].bits > 1) {
      text_fail("a pin that the library does not have, of", one->name);
    }
    if (one->pin[k].bits == 1) {
      cell->net[pin] = net[one->pin[k].bit[0]];
    }
  }
}

static void build(builder *b, const module *m, int *net, const char *name, int parent) {
  gates *g = b->g;
  g->place = more(g->place, (size_t)g->places, sizeof *g->place);
  int place = g->places++;
  g->place[place] = (gates_place){name, m->name, parent};
  for (int k = 0; k < m->nets; k++) {
    net[k] = k < 2 ? k : net[k] >= 0 ? net[k] : new_net(b);
  }
  for (int k = 0; k < m->aliases; k++) {
    join(b, net[m->alias[k][0]], net[m->alias[k][1]]);
  }
  for (int k = 0; k < m->instances; k++) {
    const instance *one = &m->instance[k];
    const module *of = find_module(b->r, one->type);
    if (of == NULL) {
      add_cell(b, one, net, place);
      continue;
    }
    int *inner = text_alloc((size_t)of->nets, sizeof *inner);
    memset(inner, 0xff, (size_t)of->nets * sizeof *inner);
    for (int p = 0; p < one->pins; p++) {
      const bundle *port = find_port(of, one->pin[p].name);
      if (port == NULL || (one->pin[p].bits != 0 && port->bits != one->pin[p].bits)) {
        text_fail("a connection that does not fit:", one->pin[p].name);
      }
      for (int bit = 0; bit < one->pin[p].bits; bit++) {
        inner[port->bit[bit]] = net[one->pin[p].bit[bit]];
      }
    }
    build(b, of, inner, one->name, place);
    free(inner);
  }
}

static const module *top_of(const reader *r) {
  const module *top = NULL;
  for (int k = 0; k < r->modules; k++) {
    bool used = false;
    for (int j = 0; j < r->modules && !used; j++) {
      for (int i = 0; i < r->module[j].instances && !used; i++) {
        used = strcmp(r->module[j].instance[i].type, r->module[k].name) == 0;
      }
    }
    if (!used && top != NULL) {
      text_fail("has several top modules, one of them", top->name);
    }
    top = used ? top : &r->module[k];
  }
  if (top == NULL) {
    text_fail("has no", "module");
  }
  return top;
}

static void add_ports(builder *b, const module *top, const int *net) {
  gates *g = b->g;
  for (int k = 0; k < top->ports; k++) {
    for (int bit = 0; bit < top->port[k].bits; bit++) {
      g->port = more(g->port, (size_t)g->ports, sizeof *g->port);
      g->port[g->ports++] =
          (gates_port){top->net_name[top->port[k].bit[bit]], root_of(b, net[top->port[k].bit[bit]]),
                       top->port[k].output};
    }
  }
}

/* Every net has one driver; combinational cells stand behind theirs. */
static void put_in_order(gates *g) {
  int *driver =
      text_alloc((size_t)g->nets, sizeof *driver); /* cell + 1; -1: an input, a constant */
  int *waits = text_alloc((size_t)g->cells, sizeof *waits);
  driver[0] = driver[1] = -1;
  for (int k = 0; k < g->ports; k++) {
    if (!g->port[k].output) {
      driver[g->port[k].net] = -1;
    }
  }
  for (int c = 0; c < g->cells; c++) {
    for (int p = 0; p < g->cell[c].type->pins; p++) {
      int net = g->cell[c].net[p];
      if (!g->cell[c].type->pin[p].output || net < 0) {
        continue;
      }
      if (g->cell[c].type->pin[p].function.count == 0) {
        text_fail("the library has no function of", g->cell[c].type->name);
      }
      if (driver[net] != 0) {
        text_fail("a net has two drivers, one of them", g->cell[c].name);
      }
      driver[net] = c + 1;
    }
  }
  /* Readers of each net, as a list through the pins. */
  int *first = text_alloc((size_t)g->nets, sizeof *first);
  int *next = text_alloc((size_t)g->cells * LIB_PINS, sizeof *next);
  for (int c = 0; c < g->cells; c++) {
    const lib_cell *type = g->cell[c].type;
    for (int p = 0; p < type->pins; p++) {
      int net = g->cell[c].net[p];
      if (type->pin[p].output) {
        continue;
      }
      if (net < 0 || driver[net] == 0) {
        text_fail("nothing drives an input of", g->cell[c].name);
      }
      if (type->register_ && p == type->clock) {
        if (net != g->clock) {
          text_fail("another clock than clk, at", g->cell[c].name);
        }
        continue;
      }
      if (!type->register_ && driver[net] > 0 && !g->cell[driver[net] - 1].type->register_) {
        waits[c]++;
        next[c * LIB_PINS + p] = first[net];
        first[net] = c * LIB_PINS + p + 1;
      }
    }
  }
  g->order = text_alloc((size_t)g->cells, sizeof *g->order);
  int registers = 0;
  for (int c = 0; c < g->cells; c++) {
    registers += g->cell[c].type->register_;
    if (!g->cell[c].type->register_ && waits[c] == 0) {
      g->order[g->ordered++] = c;
    }
  }
  for (int k = 0; k < g->ordered; k++) {
    const gates_cell *cell = &g->cell[g->order[k]];
    for (int p = 0; p < cell->type->pins; p++) {
      if (!cell->type->pin[p].output || cell->net[p] < 0) {
        continue;
      }
      for (int at = first[cell->net[p]]; at != 0; at = next[at - 1]) {
        int reads = (at - 1) / LIB_PINS;
        if (--waits[reads] == 0) {
          g->order[g->ordered++] = reads;
        }
      }
    }
  }
  if (g->ordered + registers != g->cells) {
    text_fail("has a loop without", "registers");
  }
  free(driver);
  free(waits);
  free(first);
  free(next);
}

void gates_read(gates *g, const library *lib, const char *path) {
  text_file = path;
  char *text = text_read("make one with synth/area/map");
  static reader read;
  reader *r = &read;
  *r = (reader){.p = text};
  while (next_token(r)) {
    if (!is(r, "module")) {
      text_fail("is not a netlist of synth/area/map, at", r->token);
    }
    read_module(r);
  }
  *g = (gates){0};
  builder b = {r, lib, g, NULL};
  new_net(&b);
  new_net(&b);
  const module *top = top_of(r);
  int *net = text_alloc((size_t)top->nets, sizeof *net);
  memset(net, 0xff, (size_t)top->nets * sizeof *net);
  build(&b, top, net, top->name, -1);
  add_ports(&b, top, net);
  for (int c = 0; c < g->cells; c++) {
    for (int p = 0; p < LIB_PINS; p++) {
      if (g->cell[c].net[p] >= 0) {
        g->cell[c].net[p] = root_of(&b, g->cell[c].net[p]);
      }
    }
  }
  g->clock = gates_find(g, "clk", -1);
  put_in_order(g);
  free(net);
  free(b.same);
  free(text); /* the modules stay: places and cells have their names */
  g->value = text_alloc((size_t)g->nets, sizeof *g->value);
  g->before = text_alloc((size_t)g->nets, sizeof *g->before);
  g->toggles = text_alloc((size_t)g->nets, sizeof *g->toggles);
  g->ones = text_alloc((size_t)g->nets, sizeof *g->ones);
  g->value[1] = ~UINT64_C(0);
}

int gates_find(const gates *g, const char *name, int bit) {
  char full[320];
  if (bit < 0) {
    snprintf(full, sizeof full, "%s", name);
  } else {
    snprintf(full, sizeof full, "%s[%d]", name, bit);
  }
  for (int k = 0; k < g->ports; k++) {
    if (strcmp(g->port[k].name, full) == 0) {
      return g->port[k].net;
    }
  }
  text_fail("has no port", full);
}

void gates_find_word(const gates *g, const char *name, int bits, int net[]) {
  for (int bit = 0; bit < bits; bit++) {
    net[bit] = gates_find(g, name, bit);
  }
}

void gates_set(gates *g, const int net[], int bits, unsigned lane, uint64_t value) {
  uint64_t mask = UINT64_C(1) << lane;
  for (int k = 0; k < bits; k++) {
    g->value[net[k]] = (value >> k & 1) != 0 ? g->value[net[k]] | mask : g->value[net[k]] & ~mask;
  }
}

void gates_set_all(gates *g, const int net[], int bits, uint64_t value) {
  for (int k = 0; k < bits; k++) {
    g->value[net[k]] = (value >> k & 1) != 0 ? ~UINT64_C(0) : 0;
  }
}

uint64_t gates_get(const gates *g, const int net[], int bits, unsigned lane) {
  uint64_t value = 0;
  for (int k = 0; k < bits; k++) {
    value |= (g->value[net[k]] >> lane & 1) << k;
  }
  return value;
}

/* -------------------------------------------------------------------- simulation */

static void evaluate(gates *g, const gates_cell *cell) {
  uint64_t in[LIB_PINS];
  const lib_cell *type = cell->type;
  for (int p = 0; p < type->pins; p++) {
    in[p] = cell->net[p] >= 0 ? g->value[cell->net[p]] : 0;
  }
  for (int p = 0; p < type->pins; p++) {
    if (type->pin[p].output && cell->net[p] >= 0) {
      g->value[cell->net[p]] = lib_evaluate(&type->pin[p].function, in, cell->state);
    }
  }
}

void gates_scramble(gates *g) {
  sepax_random random = {1};
  for (int c = 0; c < g->cells; c++) {
    g->cell[c].state = sepax_random_next(&random);
  }
}

void gates_settle(gates *g) {
  for (int c = 0; c < g->cells; c++) {
    if (g->cell[c].type->register_) {
      evaluate(g, &g->cell[c]);
    }
  }
  for (int k = 0; k < g->ordered; k++) {
    evaluate(g, &g->cell[g->order[k]]);
  }
}

static unsigned ones_of(uint64_t x) {
  x -= x >> 1 & UINT64_C(0x5555555555555555);
  x = (x & UINT64_C(0x3333333333333333)) + (x >> 2 & UINT64_C(0x3333333333333333));
  return (unsigned)(((x + (x >> 4)) & UINT64_C(0x0f0f0f0f0f0f0f0f)) *
                        UINT64_C(0x0101010101010101) >>
                    56);
}

void gates_rise(gates *g, bool count) {
  if (count) {
    g->cycles++;
    for (int k = 0; k < g->nets; k++) {
      g->toggles[k] += ones_of(g->value[k] ^ g->before[k]);
      g->ones[k] += ones_of(g->value[k]);
    }
  }
  memcpy(g->before, g->value, (size_t)g->nets * sizeof *g->before);
  for (int c = 0; c < g->cells; c++) {
    gates_cell *cell = &g->cell[c];
    if (!cell->type->register_) {
      continue;
    }
    uint64_t in[LIB_PINS];
    for (int p = 0; p < cell->type->pins; p++) {
      in[p] = cell->net[p] >= 0 ? g->value[cell->net[p]] : 0;
    }
    cell->state = lib_evaluate(&cell->type->next, in, cell->state);
  }
}
