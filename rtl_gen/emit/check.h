/* check.h - the emitter's strictness: a recursive-descent reader of the Verilog that the
 * generator writes. It elaborates a module for given parameters: generate loops run, constant
 * conditions choose, every expression gets its width. check.c reads modules and instances,
 * statement.c what stands in them, expression.c and operand.c the widths, reader.c the names. */
#ifndef SEPAX_EMIT_CHECK_H
#define SEPAX_EMIT_CHECK_H

#include "module.h"

#include <stdint.h>

/* ------------------------------------------------------------------ for the builders */

/* Check a whole module with its parameters' defaults, and all that it instantiates with the
 * values they get. */
bool emit_check(const emit_module *m);

/* Bits of a port with the parameters' defaults. */
int emit_port_width(const emit_module *m, const emit_symbol *port);

/* ---------------------------------------------------------------- between the readers */

typedef enum {
  NAME_CONSTANT, /* parameter, localparam, genvar, integer */
  NAME_WIRE,     /* assigned by assign, or an instance */
  NAME_REG,      /* assigned in an always block */
  NAME_INPUT,
  NAME_FUNCTION,
  NAME_LABEL /* of an instance or a block */
} name_kind;

enum { CHECK_ARGUMENTS = 16, CHECK_BUCKETS = 1024 };

typedef struct {
  name_kind kind;
  char name[EMIT_NAME];
  int width;     /* 0: a constant without a size */
  int low;       /* number of the lowest bit */
  int64_t words; /* of a memory; 0: none */
  bool known;    /* the constant's value is */
  int64_t value;
  int arguments, argument[CHECK_ARGUMENTS]; /* of a function: their widths */
  int next;                                 /* in the bucket; -1: none */
} check_name;

typedef struct {
  const emit_module *m;
  const char *begin, *at, *end;
  bool failed;
  int off;                     /* > 0: in a branch that is not taken: only syntax is read */
  bool formal;                 /* between `ifdef FORMAL and `endif */
  bool clocked, combinational; /* in an always block */
  check_name *name;
  int names, scope; /* scope: the first name of the innermost one */
  int bucket[CHECK_BUCKETS];
} reader;

/* An expression: its bits, 0 for constants without a size, and its value where known. */
typedef struct {
  int width;
  bool known;
  int64_t value;
} operand;

void reader_open(reader *r, const emit_module *m, const char *text, size_t size);
void reader_close(reader *r);

/* Keep the refusal "what 'name' in: line" and read no further. */
void reader_refuse(reader *r, const char *what, const char *name);

void reader_skip(reader *r);                       /* blanks, comments, directives */
bool reader_take(reader *r, const char *token);    /* if it is next; words whole */
bool reader_next_is(reader *r, const char *token); /* without taking it */
void reader_expect(reader *r, const char *token);  /* or refuse */
bool reader_take_name(reader *r, char name[EMIT_NAME]);

check_name *reader_find(reader *r, const char *name);
check_name *reader_declare(reader *r, name_kind kind, const char *name, int width);
int reader_enter(reader *r); /* a scope; what it returns goes to reader_leave */
void reader_leave(reader *r, int outer);

/* Bits that number n things: 1 for 1 and 2. */
int check_index_bits(int64_t n);

operand check_expression(reader *r); /* expression.c */
operand check_primary(reader *r);    /* operand.c: without operators around it */
int64_t check_constant(reader *r);   /* refuses what has no known value */
/* [msb:lsb] or none: the bits, the lowest's number. */
int check_range(reader *r, int *low);
void check_same_width(reader *r, const char *what, operand left, operand right);
void check_condition(reader *r, operand condition);

/* What is assigned to: a name with selects, or a concatenation. */
operand check_target(reader *r, bool procedural);

/* constant known and 0: the branch is not taken. */
bool check_is_false(operand condition);
bool check_is_true(operand condition);

/* wire, reg, integer, genvar, localparam, if one is next. */
bool check_declaration(reader *r);

void check_statement(reader *r);
void check_function(reader *r); /* behind the word */

/* for (i = ...; ...; i = ...) body, unrolled; behind the word. */
void check_loop(reader *r, void (*body)(reader *r));

#endif
