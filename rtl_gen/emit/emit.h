/* emit.h - a small strict emitter of Verilog-2005 modules.
 *
 * A module is built from parameters, ports, signals, literal text and instances, or is a
 * template (template.h), and is checked before a byte of it is written. The emitter refuses
 *   - a name declared twice, a name used before it is declared,
 *   - an operator or an assignment whose sides differ in width (no implicit
 *     extension or truncation, no constant without a size), a select outside a signal's range,
 *   - an assignment to an input, to a wire in an always block, to a reg outside of one,
 *   - an instance with an unknown, missing or mis-sized port or parameter,
 *   - a module used but not emitted, and any statement it does not understand.
 * It elaborates: widths may be expressions of parameters and are checked for the values of every
 * instance; generate and for loops run; what a constant condition excludes is read for its
 * syntax only. Indices that are not constant have exactly the bits that number the elements;
 * an integer or genvar i in an expression gets its size by a select, i[3:0].
 *
 * The first refusal is kept in the emitter's error; later calls do nothing. */
#ifndef SEPAX_EMIT_H
#define SEPAX_EMIT_H

#include "module.h"

/* Begin a module. The banner says purpose, formula and latency, one or more lines;
 * emitter and ports add the rest. */
emit_module *emit_begin(emitter *e, const char *name, const char *banner);

/* Check the module; false and e->error set if it is refused. */
bool emit_end(emit_module *m);

/* The default value of a parameter and what it counts. */
void emit_parameter(emit_module *m, emit_kind kind, const char *name, int value, const char *about);

/* A port, wire or reg of `width` bits ("" for one bit). `about` says what it holds
 * and, printf-like, its range; ports must have it. Wires and regs are declared
 * where they are called for. */
void emit_signal(emit_module *m, emit_kind kind, bool is_signed, const char *name,
                 const char *width, const char *about, ...) __attribute__((format(printf, 6, 7)));

/* A declaration: "wire", "reg signed" ... of `width` bits, "" for one. */
void emit_net(FILE *out, const char *kind, const char *width, const char *name);

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

/* printf into a text by value. */
typedef struct {
  char text[1024];
} gen_line;
gen_line gen_format(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Print one checked module. */
void emit_print(const emit_module *m, FILE *out);

#endif
