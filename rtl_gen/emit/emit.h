/* SPDX-License-Identifier: MIT */
/* emit.h - a small strict emitter of Verilog-2005 modules.
 *
 * A module is a template (template.h) and is checked before a byte of it is written. The emitter
 * refuses
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
 * One idiom of errors in all of rtl_gen: the first refusal, missing memory or exceeded limit is
 * kept in the emitter's error; from then on calls that emit do nothing and return false. No
 * function ends the program. */
#ifndef SEPAX_EMIT_H
#define SEPAX_EMIT_H

#include "emit/text.h"
#include "sepax_design.h"

#include <stdio.h>

enum { EMIT_NAME = 64 }; /* a name and the zero behind it; longer ones are refused */

typedef struct {
  struct emitter *emitter;
  char name[EMIT_NAME];
  char *banner;  /* comment lines */
  char *verilog; /* from the attributes of the module to endmodule */
  bool used;     /* by emit_drop_unused: the top, or named by a module that is used */
} emit_module;

typedef struct emitter {
  sepax_design *design; /* NULL: modules by themselves. The generator sets its latency */
  char command[640];    /* printed in every banner */
  const char *prefix;   /* of what is written, in place of sepax; here all names have sepax */
  emit_module **module;
  int modules;
  char **variant; /* modules with parameter values that passed the check */
  int variants;
  size_t module_space, variant_space; /* of both lists */
  sepax_error error;
} emitter;

void emit_init(emitter *e, sepax_design *design, const char *command);
void emit_free(emitter *e);

/* A new module of the emitter, without text; NULL, and the error is set, without memory. */
emit_module *emit_new_module(emitter *e, const char *name);

/* A module emitted before, by name; NULL if there is none. */
const emit_module *emit_find(const emitter *e, const char *name);

/* Drop the modules that neither the last module nor one that it needs names. Tools would take each
 * of them for another top. Some units are such where II shares others. */
void emit_drop_unused(emitter *e);

/* Print one checked module, with names that begin with sepax_. */
void emit_print(const emit_module *m, emit_text *out);

/* Print all modules as one file, the last one's. There is at least one. */
void emit_print_all(const emitter *e, emit_text *out);

/* Print who made a file, by which command, as comments that begin with `mark`. */
void emit_origin(const emitter *e, const char *mark, emit_text *out);

/* Keep an error, unless there is one already: of the emitter, or the refusal of a module. Both
 * return false. */
bool emit_fail(emitter *e, sepax_code code, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
bool emit_refuse(const emit_module *m, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
bool emit_no_memory(emitter *e);
static inline bool emit_works(const emitter *e) { return e->error.code == SEPAX_OK; }

/* printf into a text by value. */
typedef struct {
  char text[1024];
} gen_line;
gen_line gen_format(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* A declaration: "wire", "reg signed" ... of `width` bits, a number or an expression. */
void emit_net(emit_text *out, const char *kind, const char *width, const char *name);

#endif
