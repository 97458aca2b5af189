/* SPDX-License-Identifier: MIT */
/* sepax_driver.h - driver of an object engine, for bare metal: no heap, no operating system, C11.
 *
 * sepax_registers.h has the registers, which are the same for every object engine, whatever its
 * --prefix. You write the four functions of sepax_bus: mostly, registers are a volatile pointer,
 * and the two streams are a DMA engine or a FIFO. Call sepax_device_open once, sepax_device_load
 * for both objects, then sepax_device_move and sepax_device_run for each position. If a function
 * returns another status than SEPAX_DRIVER_OK, then the engine is idle and its results must not be
 * used. */
#ifndef SEPAX_DRIVER_H
#define SEPAX_DRIVER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef enum {
  SEPAX_DRIVER_OK,
  SEPAX_NO_ENGINE,  /* the ID register is not that of an object engine */
  SEPAX_BUS_ERROR,  /* an access failed or was answered with SLVERR, or a load never ended */
  SEPAX_BAD_WORD,   /* a coordinate does not fit the word of the engine */
  SEPAX_BAD_SIZE,   /* an object is empty or larger than the engine's memory */
  SEPAX_BAD_MOVE,   /* a move does not fit W + 1 bits */
  SEPAX_INCOMPLETE, /* the engine sent another number of results than it counted */
  SEPAX_ENDED       /* `found` returned false */
} sepax_status;

/* A short English text for a status. */
const char *sepax_status_text(sepax_status status);

/* The accesses to the engine. Each gets `context`, and returns false if the access failed. */
typedef struct {
  void *context;
  bool (*read)(void *context, uint32_t address, uint32_t *value);
  bool (*write)(void *context, uint32_t address, uint32_t value);
  /* Send a vertex of object A (to_b false) or B (to_b true). `last` is true for the last vertex of
   * the object. The function may return before the engine has the vertex: sepax_device_load waits
   * until the engine has all of them. */
  bool (*send)(void *context, const int32_t vertex[3], bool last, bool to_b);
  /* Wait for a transfer of the result stream and take it. *last is its TLAST. */
  bool (*receive)(void *context, uint64_t *result, bool *last);
} sepax_bus;

typedef struct {
  sepax_bus bus;
  int word;           /* bits of a coordinate */
  int lanes;          /* comparator lanes */
  size_t capacity[2]; /* most triangles of A and of B */
} sepax_device;

/* A pair that collides or is too near. a and b are the numbers of its triangles. */
typedef struct {
  size_t a, b;
  bool coplanar;
  bool out_of_range; /* undecided, reported as a collision */
  bool warning;      /* no collision, but within the warning limit of the engine */
} sepax_hit;

/* Counts of a run. sepax_device_collide adds those of all its runs. */
typedef struct {
  uint64_t pairs, candidates, collisions, out_of_range, warnings, cycles;
} sepax_counts;

/* Check that an object engine answers, and read its word, lanes and capacity. */
sepax_status sepax_device_open(sepax_device *device, const sepax_bus *bus);

/* Load object A or B: 9 coordinates a triangle, x y z of its three vertices, in LSB. If an earlier
 * access failed in the middle of an object, then that object is ended first. */
sepax_status sepax_device_load(sepax_device *device, bool to_b, const int32_t (*triangle)[9],
                               size_t count);

/* Shift B by whole LSB from where it was loaded. The shift is exact. The engine does not rotate: to
 * rotate B, rotate its original vertices, round them once and load B again. */
sepax_status sepax_device_move(sepax_device *device, const int32_t move[3]);

/* Test the loaded objects against each other. `found` gets each pair that collides or is too near,
 * in the engine's order. If `found` returns false, the run ends with SEPAX_ENDED. If `first` is
 * true, the engine ends the run at its first collision. */
sepax_status sepax_device_run(sepax_device *device, bool first,
                              bool (*found)(void *context, const sepax_hit *hit), void *context,
                              sepax_counts *counts);

/* Load and test two objects of any size, in parts that fit the engine's memories. `found` gets the
 * numbers of the whole objects. B is shifted by the last sepax_device_move. */
sepax_status sepax_device_collide(sepax_device *device, const int32_t (*a)[9], size_t count_a,
                                  const int32_t (*b)[9], size_t count_b, bool first,
                                  bool (*found)(void *context, const sepax_hit *hit), void *context,
                                  sepax_counts *counts);

#endif
