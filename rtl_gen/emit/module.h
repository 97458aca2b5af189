/* module.h - the emitter and its modules: what emit.c and template.c build and check.c reads. */
#ifndef SEPAX_EMIT_MODULE_H
#define SEPAX_EMIT_MODULE_H

#include "sepax_design.h"

enum { EMIT_NAME = 64 }; /* a name and the zero behind it; longer ones are refused */

typedef enum {
  EMIT_PARAMETER,
  EMIT_LOCALPARAM,
  EMIT_INPUT,
  EMIT_OUTPUT,
  EMIT_OUTPUT_REG,
  EMIT_WIRE,
  EMIT_REG
} emit_kind;

/* A parameter or a port; the body's declarations stay text until they are checked. */
typedef struct {
  emit_kind kind;
  char name[EMIT_NAME];
  bool is_signed;
  char *width; /* of a port: expression of parameters, "" for one bit */
  char *value; /* of a parameter: expression of parameters before it */
  char *about;
} emit_symbol;

typedef struct {
  struct emitter *emitter;
  char name[EMIT_NAME];
  char *banner;
  emit_symbol *symbol; /* parameters and ports in the order of their declaration */
  int symbols;
  char *verilog; /* from the attributes of the module to endmodule; builders make it last */
  char *body;    /* all that stands between the header and endmodule */
  size_t body_size;
  FILE *text; /* writes body */
} emit_module;

typedef struct emitter {
  const sepax_design *design;
  char command[512]; /* printed in every banner */
  emit_module **module;
  int modules;
  char **variant; /* modules with parameter values that passed the check */
  int variants;
  sepax_error error;
} emitter;

void emit_init(emitter *e, const sepax_design *design, const char *command);
void emit_free(emitter *e);

/* A new module of the emitter, refused if the name is too long. */
emit_module *emit_new_module(emitter *e, const char *name, const char *banner);

/* A module emitted before, by name; NULL if there is none. */
const emit_module *emit_find(const emitter *e, const char *name);

/* A new parameter or port, refused (NULL) if the name is taken or too long. */
emit_symbol *emit_declare(emit_module *m, emit_kind kind, const char *name);

bool emit_is_port(const emit_symbol *s);

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

#endif
