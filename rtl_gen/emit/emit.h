/* emit.h - a small strict emitter of Verilog-2005 modules.
 *
 * A module is built from parameters, ports, signals, literal text and instances,
 * and is checked before a byte of it is written. The emitter refuses
 *   - a name declared twice, a name used before it is declared,
 *   - an operator or an assignment whose sides differ in width (no implicit
 *     extension or truncation), a select outside a signal's range,
 *   - an instance with an unknown, missing or mis-sized port or parameter,
 *   - a module used but not emitted, and any statement it does not understand.
 * Widths may be expressions of parameters; they are checked for the values of
 * every instance.
 *
 * The first refusal is kept in the emitter's error; later calls do nothing. */
#ifndef SEPAX_EMIT_H
#define SEPAX_EMIT_H

#include "sepax_design.h"

enum {
  EMIT_MODULES = 64,
  EMIT_SYMBOLS = 4096,
  EMIT_INSTANCES = 512,
  EMIT_NAME = 48,
  EMIT_VARIANTS = 256,
  EMIT_PORTS = 128
};

typedef enum {
  EMIT_PARAMETER,
  EMIT_LOCALPARAM,
  EMIT_INPUT,
  EMIT_OUTPUT,
  EMIT_OUTPUT_REG,
  EMIT_WIRE,
  EMIT_REG,
  EMIT_LABEL
} emit_kind;

typedef struct {
  emit_kind kind;
  char name[EMIT_NAME];
  char width[EMIT_NAME];   /* expression of parameters; "" for one bit */
  char address[EMIT_NAME]; /* of a memory: bits of its address, likewise; "" for a signal */
  bool is_signed;
  int value; /* of a parameter */
  char *about;
  size_t begin, end; /* its declaration in the body; 0, 0 for the header's */
} emit_symbol;

typedef struct emit_module emit_module;

typedef struct {
  const emit_module *module;
  char name[EMIT_NAME];
  char *parameters, *connections;
  size_t begin, end; /* its text in the body */
} emit_instance_record;

struct emit_module {
  struct emitter *emitter;
  char name[EMIT_NAME];
  char *banner;
  emit_symbol symbol[EMIT_SYMBOLS];
  int symbols;
  emit_instance_record instance[EMIT_INSTANCES];
  int instances;
  char *body; /* all that stands between the header and endmodule */
  size_t body_size;
  FILE *text; /* writes body */
};

typedef struct emitter {
  const sepax_design *design;
  char command[512]; /* printed in every banner */
  emit_module *module[EMIT_MODULES];
  int modules;
  char *variant[EMIT_VARIANTS]; /* modules with parameter values that passed the check */
  int variants;
  sepax_error error;
} emitter;

void emit_init(emitter *e, const sepax_design *design, const char *command);
void emit_free(emitter *e);

/* Begin a module. The banner says purpose, formula and latency, one or more lines;
 * emitter and ports add the rest. */
emit_module *emit_begin(emitter *e, const char *name, const char *banner);

/* Check the module; false and e->error set if it is refused. */
bool emit_end(emit_module *m);

/* A module emitted before, by name; refuses an unknown one. */
const emit_module *emit_find(emitter *e, const char *name);

/* The default value of a parameter and what it counts. */
void emit_parameter(emit_module *m, emit_kind kind, const char *name, int value, const char *about);

/* A port, wire or reg of `width` bits ("" for one bit). `about` says what it holds
 * and, printf-like, its range; ports must have it. Wires and regs are declared
 * where they are called for. */
void emit_signal(emit_module *m, emit_kind kind, bool is_signed, const char *name,
                 const char *width, const char *about, ...) __attribute__((format(printf, 6, 7)));

/* A wire or reg that its name explains. */
void emit_net(emit_module *m, emit_kind kind, bool is_signed, const char *name, const char *width);

/* A memory of 2^address words, `words[index]`, index exactly `address` bits wide. */
void emit_memory(emit_module *m, const char *name, const char *width, const char *address,
                 const char *about);

void emit_blank(emit_module *m);

/* Literal Verilog, one or more lines, with two blanks put before each. */
void emit_text(emit_module *m, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Two bodies for one module: what stands between emit_view(m, EMIT_BEHAVIOURAL) and
 * emit_view(m, EMIT_STRUCTURAL) is read where the macro SEPAX_BEHAVIOURAL is defined,
 * from there to emit_view(m, EMIT_BOTH) where it is not. */
typedef enum { EMIT_BEHAVIOURAL, EMIT_STRUCTURAL, EMIT_BOTH } emit_views;
void emit_view(emit_module *m, emit_views view);

/* An instance of an emitted module: "A_W=VW, P_W=PW" and "a=v_x, p=product_x". */
void emit_instance(emit_module *m, const char *module, const char *name, const char *parameters,
                   const char *connections, ...) __attribute__((format(printf, 5, 6)));

/* Print one checked module. */
void emit_print(const emit_module *m, FILE *out);

/* ------------------------------------------------------- check.c, for emit.c */

typedef struct {
  char name[EMIT_NAME];
  int value;
} emit_binding;

/* The value of a constant expression of a module's parameters, some of which may
 * be overridden; refuses (returns false) what it cannot evaluate. */
bool emit_constant(const emit_module *m, const emit_binding *overrides, int count,
                   const char *expression, int *value);

/* Check a whole module with some parameters overridden. */
bool emit_check(const emit_module *m, const emit_binding *overrides, int count);

/* Keep a refusal, unless there is one already; always returns false. */
bool emit_refuse(const emit_module *m, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

#endif
