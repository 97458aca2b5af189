/* SPDX-License-Identifier: MIT */
/* check.h - the emitter's strictness: a recursive-descent reader of the Verilog that the
 * generator writes. It elaborates a module for given parameters: generate loops run, constant
 * conditions choose, every expression gets its width. check.c reads modules and instances,
 * statement.c what stands in them, expression.c and operand.c the widths, reader.c the names. */
#ifndef SEPAX_EMIT_CHECK_H
#define SEPAX_EMIT_CHECK_H

#include "emit.h"

#include <stdint.h>
#include <stdio.h>

/* Check a whole module with its parameters' defaults, and all that it instantiates with the
 * values they get. */
bool emit_check(const emit_module *m);

/* ---------------------------------------------------------------- between the readers */

typedef enum {
  NAME_LABEL,    /* of an instance or a block */
  NAME_CONSTANT, /* parameter, localparam */
  NAME_VARIABLE, /* genvar, integer */
  NAME_WIRE,     /* assigned by assign, or an instance */
  NAME_REG,      /* assigned in a process */
  NAME_INPUT,
  NAME_FUNCTION
} name_kind;

enum { CHECK_ARGUMENTS = 16 };

typedef struct {
  name_kind kind;
  char name[EMIT_NAME];
  int width;                 /* 0: a constant without a size */
  int low;                   /* number of the lowest bit */
  int64_t words;             /* of a memory; 0: none */
  bool is_signed, connected; /* of a port */
  const char *about;         /* of a port: the comment behind it, to the line's end */
  bool known;                /* the constant's value is */
  int64_t value;
  int arguments, argument[CHECK_ARGUMENTS]; /* of a function: their widths */
} check_name;

/* Among the items of a module, or among the statements of a process. */
typedef enum { IN_MODULE, IN_CLOCKED, IN_COMBINATIONAL } check_place;

typedef struct reader {
  const emit_module *m;
  const char *begin, *at, *end; /* *end is 0 */
  bool failed;                  /* then nothing is left: at == end */
  int off;                      /* > 0: in a branch that is not taken */
  bool formal;                  /* between `ifdef FORMAL and `endif */
  check_place place;
  struct reader *child; /* the module of the instance that is read */
  check_name *name;
  size_t name_space;
  int names, scope;   /* scope: the first name of the innermost one */
  int header;         /* the names from the outermost scope to here: parameters and ports */
  check_name ignored; /* what a branch that is not taken declares */
} reader;

/* An expression: its bits, 0 for constants without a size, and its value where known. */
typedef struct {
  int width;
  bool known;
  int64_t value;
} operand;
static inline operand check_bits(int width) { return (operand){width, false, 0}; }

/* The text ends with a 0. */
void reader_open(reader *r, const emit_module *m, const char *text);
void reader_close(reader *r);

/* Keep the refusal with the line that is read, and read no further: what is no Verilog, and what
 * has the wrong width, name or value. In a branch that is not taken there are no faults. */
void reader_refuse(reader *r, const char *format, ...) __attribute__((format(printf, 2, 3)));
void reader_fault(reader *r, const char *format, ...) __attribute__((format(printf, 2, 3)));

void reader_no_memory(reader *r); /* the same; it is the emitter's error */

void reader_skip(reader *r);                            /* blanks, comments, directives */
bool reader_take(reader *r, const char *token);         /* if it is next; words whole */
void reader_expect(reader *r, const char *token);       /* or refuse */
bool reader_is_before(reader *r, const char *token);    /* takes it, or there is more before it */
bool reader_take_name(reader *r, char name[EMIT_NAME]); /* "": there is none */
void reader_expect_name(reader *r, char name[EMIT_NAME]);
void reader_list(reader *r, void (*part)(reader *r)); /* behind "(" up to ")", with commas */

check_name *reader_find(reader *r, const char *name);
check_name *reader_declare(reader *r, name_kind kind, const char *name, int width);
int reader_enter(reader *r); /* a scope; what it returns goes to reader_leave */
void reader_leave(reader *r, int outer);

/* expression.c */
operand check_expression(reader *r);
int64_t check_constant(reader *r); /* refuses what has no known value */
/* [msb:lsb], if one is next, else `none`: the bits, the lowest's number. */
int check_range(reader *r, int none, int *low);
void check_same_width(reader *r, const char *what, operand left, operand right);
void check_condition(reader *r, operand condition);
bool check_is(operand condition, bool value); /* known to be */

/* operand.c */
operand check_primary(reader *r); /* without operators around it */
operand check_target(reader *r);  /* what is assigned to: a name with selects, or a list of them */

/* statement.c; what is named stands behind its word */
bool check_declaration(reader *r); /* wire, reg, integer, genvar, localparam, if one is next */
void check_function(reader *r);
bool check_control(reader *r); /* if or for, around items or statements, if one is next */
void check_process(reader *r, check_place place);
void check_statement(reader *r);
void check_assignment(reader *r);

/* check.c */
void check_item(reader *r); /* a statement in a process */
void check_header(reader *r);

#endif
