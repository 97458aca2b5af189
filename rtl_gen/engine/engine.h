/* engine.h - the object engine: two memories of triangles, comparator lanes to which a pair
 * enumerator leads all pairs, and sepax_top behind them (docs/engine.md). */
#ifndef SEPAX_ENGINE_H
#define SEPAX_ENGINE_H

#include "emit/template.h"
#include "sepax_design.h"

/* A memory-mapped register, 32 bits: its place in the table is its address / 4. */
typedef enum { ENGINE_READ, ENGINE_WRITE, ENGINE_READ_WRITE, ENGINE_CLEAR } engine_access;
typedef struct {
  const char *name;
  engine_access access;
  const char *shown; /* in sepax_registers.v, as it is read; @...@ is a hole */
  const char *about;
  struct {
    const char *name;
    int low, bits;
    const char *about;
  } field[10]; /* none: all 32 bits are one number */
} engine_register;

enum { ENGINE_IDENTITY = 0x53505841 };

/* Addresses of what can be written, and the cases in which a register is read, for the holes of
 * sepax_registers.v. */
void engine_decode(emit_holes *h);

/* The register map for drivers: a C header, a page. */
void engine_header(FILE *out);
void engine_page(FILE *out);

/* Every module of the engine behind those of the core; `entries` is how many pairs a core
 * holds. */
void gen_engine(emitter *e, int entries);

#endif
