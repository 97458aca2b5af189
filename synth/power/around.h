/* SPDX-License-Identifier: MIT */
/* around.h - what stands around an engine as gates, in 64 lanes: its memories, its AXI4-Lite port,
 * its stream of results. */
#ifndef SEPAX_POWER_AROUND_H
#define SEPAX_POWER_AROUND_H

#include "gates.h"

/* sepax_ram: one port to write, one to read; a word is there in the cycle after it was asked for.
 */
typedef struct {
  const uint64_t *write, *read;
  const gates_port *write_address, *read_address, *write_data, *read_data;
  uint64_t *word;        /* [address][bit], one bit a lane */
  uint64_t *next, reads; /* what comes out at the edge, in the lanes that read */
} memory;

/* A channel of a bus. */
typedef struct {
  uint64_t *valid, *ready;
  const gates_port *word;     /* an address, data */
  const gates_port *response; /* 0: okay; NULL: has none */
} channel;

typedef struct around {
  gates *g;
  memory *memory;
  int memories;
  channel write_address, write_data, write_answer, read_address, read_answer, out;
  uint64_t *out_last;
  bool count;                      /* transitions */
  uint64_t wrong;                  /* answers that did not come, or were refusals */
  void (*offer)(struct around *a); /* before inputs settle: sets more of them; NULL: none */
  void (*take)(struct around *a);  /* before the edge */
} around;

extern const uint64_t around_all; /* lanes */

/* The memory of these ports. */
memory around_memory(memory ports);

/* Finds the buses and drives a reset; `memory` is given, all answers are taken at once. */
void around_begin(around *a);

channel around_channel(const gates *g, const char *bus, const char *word, int bits,
                       const char *response);

/* A cycle. */
void around_tick(around *a);

/* Offer what is on one or two channels until all lanes have taken it and, where there is an answer,
 * have given that; its word is `data` where it has one. */
void around_transfer(around *a, const channel *first, const channel *second, const channel *answer,
                     uint32_t data[GATES_LANES]);

void around_write(around *a, uint64_t address, uint32_t data);
/* In each lane another value. */
void around_write_each(around *a, uint64_t address, const uint32_t data[GATES_LANES]);
void around_read(around *a, uint64_t address, uint32_t data[GATES_LANES]);

#endif
