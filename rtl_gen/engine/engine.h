/* engine.h - the object engine: two memories of triangles, box lanes that walk all pairs,
 * and sepax_top behind them (docs/engine.md). */
#ifndef SEPAX_ENGINE_H
#define SEPAX_ENGINE_H

#include "emit/gen.h"
#include "sepax_design.h"

typedef struct {
  const sepax_design *design;
  int word, moved; /* W; bits of a coordinate that was moved, W + 2 */
  int lanes, cores;
  int index_a, index_b; /* bits of a triangle's number */
  int flight_log2;      /* places for pairs that are in the cores */
} engine_plan;

/* A memory-mapped register, 32 bits: its place in the table is its address / 4. */
typedef enum { ENGINE_READ, ENGINE_WRITE, ENGINE_READ_WRITE, ENGINE_CLEAR } engine_access;
typedef struct {
  const char *name;
  engine_access access;
  const char *about;
  struct {
    const char *name;
    int low, bits;
    const char *about;
  } field[10]; /* none: all 32 bits are one number */
} engine_register;

enum {
  ENGINE_ID,
  ENGINE_GENERATOR,
  ENGINE_DESIGN,
  ENGINE_MEMORY,
  ENGINE_COMMAND,
  ENGINE_MODE,
  ENGINE_STATUS,
  ENGINE_ENABLE,
  ENGINE_PENDING,
  ENGINE_COUNT_A,
  ENGINE_COUNT_B,
  ENGINE_MOVE_X,
  ENGINE_MOVE_Y,
  ENGINE_MOVE_Z,
  ENGINE_PAIRS,
  ENGINE_CANDIDATES,
  ENGINE_COLLISIONS,
  ENGINE_OUT_OF_RANGE,
  ENGINE_WARNINGS,
  ENGINE_CYCLES,
  ENGINE_FIRST_A,
  ENGINE_FIRST_B,
  ENGINE_REGISTERS
};
enum { ENGINE_ADDRESS_BITS = 7, ENGINE_IDENTITY = 0x53505841 };

extern const engine_register engine_registers[ENGINE_REGISTERS];

/* The register map for drivers: a C header, a page. */
void engine_header(FILE *out);
void engine_page(FILE *out);

/* Every module of the engine behind those of the core; places is how many pairs the core
 * holds. */
void gen_engine(emitter *e, int places);

void gen_engine_lanes(emitter *e, const engine_plan *p); /* walk, lanes, candidates, pick */
void gen_engine_load(emitter *e, const engine_plan *p);
void gen_engine_results(emitter *e, const engine_plan *p);
void gen_engine_registers(emitter *e, const engine_plan *p);

/* A queue of words in registers, `name`: room says that more than `margin` - 1 are free. */
void gen_engine_queue(emitter *e, const char *name, const char *banner, int width, int log2,
                      int margin);

#endif
