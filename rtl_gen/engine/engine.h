/* SPDX-License-Identifier: MIT */
/* engine.h - what the generator of an engine is to everything that does not depend on which one it
 * is, and what engines share. c_model/design/engine_table.h has the list of engines. */
#ifndef SEPAX_ENGINE_GENERATOR_H
#define SEPAX_ENGINE_GENERATOR_H

#include "datapath/delay.h"
#include "design/engine_table.h"
#include "emit/template.h"
#include "engine/registers.h"

typedef struct {
  /* Every module of the engine, behind those of the core; NULL: there is no engine. `pairs` is how
   * many pairs a core holds. `h` has the holes of sepax_top, and may get more. */
  void (*generate)(emitter *e, emit_holes *h, int pairs);
  const engine_registers *registers; /* NULL: none */
  bool registers_ready;              /* in_ready of the core is a register */
  const char *core; /* instance of sepax_top whose ports a list of waves shows, too; NULL: none */
  /* ns of the longest stage that has no place for a register; NULL: no stage of the engine is. */
  double (*delay)(const delay_model *m, int word);
} engine_generator;

#define ENGINE_GENERATOR(value, name) extern const engine_generator generator_##name;
SEPAX_ENGINES(ENGINE_GENERATOR)
#undef ENGINE_GENERATOR

/* The generator of the design's engine; without an engine a row of zeros. */
const engine_generator *engine_generator_of(const sepax_config *config);

/* Is in_ready of the core a register, by the option, for the engine or as on every FPGA? */
bool engine_registers_ready(const sepax_config *config);

/* Version of the generator, as the register GENERATOR has it: {MAJOR, MINOR, PATCH}. */
int engine_version(void);

/* Holes of sepax_cores, of which each core holds `pairs` pairs; `info` bits go with a pair. */
void engine_cores(emit_holes *h, const sepax_design *design, int pairs, int info);

/* Bits that number so many things. */
int engine_log2(int number);

#endif
