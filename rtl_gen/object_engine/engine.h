/* engine.h - the object engine: two memories of triangles, comparator lanes to which a pair
 * enumerator leads all pairs, and sepax_top behind them (docs/engine.md). */
#ifndef SEPAX_ENGINE_H
#define SEPAX_ENGINE_H

#include "emit/template.h"
#include "sepax_design.h"

typedef enum {
  ENGINE_CONSTANT,
  ENGINE_READ,
  ENGINE_WRITE,
  ENGINE_READ_WRITE,
  ENGINE_CLEAR,
  ENGINE_FIELD
} engine_kind;

/* A memory-mapped register, 32 bits, at the next address; behind it its fields, if it is not one
 * number. */
typedef struct {
  const char *name;
  engine_kind kind;
  const char *shown; /* what is read, in sepax_registers.v: an input, if it can only be read */
  int low, bits;     /* of a field */
  const char *about;
} engine_register;

/* The register map of an engine, once: for the RTL, for C, for people. */
typedef struct {
  unsigned identity;
  const engine_register *row;
  size_t rows;
  const char *about; /* of its page */
} engine_registers;

extern const engine_registers engine_of_lanes, engine_of_trees;
/* That of the design; NULL: it is no engine. */
const engine_registers *engine_registers_of(const sepax_config *config);

/* Holes of sepax_registers.v: inputs that are read as they are, addresses of what can be written,
 * the cases in which a register is read; `constants` are those of the rows of that kind. */
void engine_decode(const engine_registers *map, emit_holes *h, const int *constants);

/* The register map for others: a C header, a page, SystemRDL. */
void engine_header(const engine_registers *map, FILE *out);
void engine_page(const engine_registers *map, FILE *out);
void engine_rdl(const engine_registers *map, FILE *out);

/* Of the generator, as GENERATOR has it: {MAJOR, MINOR, PATCH}. */
int engine_version(void);

/* Holes of sepax_cores, of which each core holds `entries` pairs; `info` bits go with a pair. */
void engine_cores(emit_holes *h, const sepax_design *design, int entries, int info);

/* Every module of the engine behind those of the core; `entries` is how many pairs a core
 * holds. */
void gen_engine(emitter *e, int entries);

#endif
