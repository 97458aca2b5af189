/* SPDX-License-Identifier: MIT */
/* registers.h - the register map of an engine, written once as a table: for the RTL, for C, for
 * people. */
#ifndef SEPAX_ENGINE_REGISTERS_H
#define SEPAX_ENGINE_REGISTERS_H

#include "emit/template.h"

typedef enum {
  ENGINE_CONSTANT,
  ENGINE_READ,
  ENGINE_WRITE,
  ENGINE_READ_WRITE,
  ENGINE_CLEAR,
  ENGINE_FIELD
} engine_kind;

/* A memory-mapped register of 32 bits, at the next address; its fields follow as rows of their own
 * if it is not one number. */
typedef struct {
  const char *name;
  engine_kind kind;
  const char *shown; /* what is read, in sepax_registers.v: an input, if it can only be read */
  int low, bits;     /* of a field */
  const char *about;
} engine_register;

typedef struct {
  const char *file;  /* of its C header: sepax_registers; names of macros begin like it: SEPAX_ */
  unsigned identity; /* what the register ID reads */
  const engine_register *row;
  size_t rows;
  const char *about; /* a sentence for the page */
} engine_registers;

/* Holes of sepax_registers.v: inputs that are read as they are, addresses of what can be written,
 * the cases in which a register is read. `constants` has a value for each ENGINE_CONSTANT. */
void engine_decode(const engine_registers *map, emit_holes *h, const int *constants);

/* The map for others: a C header, a page and SystemRDL. */
void engine_header(const engine_registers *map, emit_text *out);
void engine_page(const engine_registers *map, emit_text *out);
void engine_rdl(const engine_registers *map, emit_text *out);

#endif
