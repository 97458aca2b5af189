/* sepax_driver.h - driver of sepax_engine, for bare metal: no heap, no operating system, C11.
 *
 * The registers are those of sepax_registers.h, which sepax gen writes beside the Verilog.
 * The four accesses are yours: registers are mostly a volatile pointer, the two streams a
 * DMA engine or a FIFO. All functions answer with a sepax_status; after one that is not
 * SEPAX_DRIVER_OK the engine is idle, and what it found is not to be used. */
#ifndef SEPAX_DRIVER_H
#define SEPAX_DRIVER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef enum {
  SEPAX_DRIVER_OK,
  SEPAX_NO_ENGINE,  /* ID is not what it must be */
  SEPAX_BUS_ERROR,  /* an access failed, was answered with SLVERR, or a load never ended */
  SEPAX_BAD_WORD,   /* a coordinate does not fit the engine's words */
  SEPAX_BAD_SIZE,   /* an object is empty, or larger than the memory */
  SEPAX_BAD_MOVE,   /* a move does not fit W + 1 bits */
  SEPAX_INCOMPLETE, /* the engine sent another number of results than it counted */
  SEPAX_ENDED       /* found() asked for the end */
} sepax_status;

const char *sepax_status_text(sepax_status status);

/* How the engine is reached; `context` is handed on. false: the access failed. */
typedef struct {
  void *context;
  bool (*read)(void *context, uint32_t address, uint32_t *value);
  bool (*write)(void *context, uint32_t address, uint32_t value);
  /* A vertex of object A (to_b false) or B, `last` with the last one of the object. It may be
   * on its way for a while: sepax_device_load waits until the engine has it. */
  bool (*send)(void *context, const int32_t vertex[3], bool last, bool to_b);
  /* Wait for a result and take it. */
  bool (*receive)(void *context, uint64_t *result, bool *last);
} sepax_bus;

typedef struct {
  sepax_bus bus;
  int word, lanes;
  size_t capacity[2]; /* triangles of A, of B */
} sepax_device;

/* A pair that collides, or is too near, and what is known of it. */
typedef struct {
  size_t a, b;
  bool coplanar;
  bool out_of_range; /* undecided, called a collision */
  bool warning;      /* no collision, but too near (engines with a warning limit) */
} sepax_hit;

/* Counts of a run; of sepax_device_collide: their sums. */
typedef struct {
  uint64_t pairs, candidates, collisions, out_of_range, warnings, cycles;
} sepax_counts;

/* Is the engine there, and what is it like. */
sepax_status sepax_device_open(sepax_device *device, const sepax_bus *bus);

/* Load an object: 9 coordinates a triangle, x y z of its three vertices, in LSB. An object that was
 * cut off by a failed access is ended first. */
sepax_status sepax_device_load(sepax_device *device, bool to_b, const int32_t (*triangle)[9],
                               size_t count);

/* Move B by whole LSB against where it was loaded; exact. A rotation is no matter of the engine:
 * turn the vertices, round them and load B again, so that each is rounded once. */
sepax_status sepax_device_move(sepax_device *device, const int32_t move[3]);

/* One run over what is loaded. Each of them is handed to `found`, in the engine's order; false
 * ends the run. `first`: it ends at its first collision by itself. */
sepax_status sepax_device_run(sepax_device *device, bool first,
                              bool (*found)(void *context, const sepax_hit *hit), void *context,
                              sepax_counts *counts);

/* Two objects of any size: part by part as the memories hold them, numbers those of the whole
 * objects; B as the last sepax_device_move says. */
sepax_status sepax_device_collide(sepax_device *device, const int32_t (*a)[9], size_t count_a,
                                  const int32_t (*b)[9], size_t count_b, bool first,
                                  bool (*found)(void *context, const sepax_hit *hit), void *context,
                                  sepax_counts *counts);

#endif
