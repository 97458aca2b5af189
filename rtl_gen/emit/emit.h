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
 * The first refusal is kept in the emitter's error; later calls do nothing. */
#ifndef SEPAX_EMIT_H
#define SEPAX_EMIT_H

#include "sepax_design.h"

enum { EMIT_NAME = 64 }; /* a name and the zero behind it; longer ones are refused */

typedef struct {
  struct emitter *emitter;
  char name[EMIT_NAME];
  char *banner;  /* comment lines */
  char *verilog; /* from the attributes of the module to endmodule */
} emit_module;

typedef struct emitter {
  sepax_design *design; /* NULL: modules by themselves. The generator sets its latency */
  char command[512];    /* printed in every banner */
  emit_module **module;
  int modules;
  char **variant; /* modules with parameter values that passed the check */
  int variants;
  sepax_error error;
} emitter;

void emit_init(emitter *e, sepax_design *design, const char *command);
void emit_free(emitter *e);

/* A new module of the emitter, without text. */
emit_module *emit_new_module(emitter *e, const char *name);

/* A module emitted before, by name; NULL if there is none. */
const emit_module *emit_find(const emitter *e, const char *name);

/* Print one checked module. */
void emit_print(const emit_module *m, FILE *out);

/* Keep a refusal, unless there is one already; always returns false. */
bool emit_refuse(const emit_module *m, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Copies that end the program without memory. */
char *emit_copy(const char *text, size_t length);
void *emit_grow(void *list, int count, size_t size); /* capacity for one more than `count` */

/* A text that grows: written to `out`, whole in `text` behind emit_stream_close, which returns it;
 * to be freed. */
typedef struct {
  FILE *out;
  char *text;
  size_t size;
} emit_stream;
void emit_stream_open(emit_stream *s);
char *emit_stream_close(emit_stream *s);

/* printf into a text by value. */
typedef struct {
  char text[1024];
} gen_line;
gen_line gen_format(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* A declaration: "wire", "reg signed" ... of `width` bits, a number or an expression. */
void emit_net(FILE *out, const char *kind, const char *width, const char *name);

#endif
