/* engine.h - the object engine: two memories of triangles, comparator lanes to which a pair
 * enumerator leads all pairs, and sepax_top behind them (docs/engine.md). */
#ifndef SEPAX_ENGINE_H
#define SEPAX_ENGINE_H

#include "emit/template.h"
#include "sepax_design.h"

enum { ENGINE_IDENTITY = 0x53505841 };

/* Holes of sepax_registers.v: inputs that are read as they are, addresses of what can be written,
 * the cases in which a register is read; `constants` are those of ID, GENERATOR, DESIGN, MEMORY. */
void engine_decode(emit_holes *h, const int constants[4]);

/* The register map for drivers: a C header, a page. */
void engine_header(FILE *out);
void engine_page(FILE *out);

/* Every module of the engine behind those of the core; `entries` is how many pairs a core
 * holds. */
void gen_engine(emitter *e, int entries);

#endif
