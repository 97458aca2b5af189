/* SPDX-License-Identifier: MIT */
/* bus.h - the verilated sepax_engine on its buses, for programs in C: the four accesses
 * of drivers/object_engine/sepax_driver.h, and what a test wants besides. All master and slave
 * sides obey AXI; what AXI asks of the engine (valid and data stand until ready) is watched
 * in every cycle. */
#ifndef SEPAX_ENGINE_BUS_H
#define SEPAX_ENGINE_BUS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "tree_engine/modules/memory.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Build the design and reset it. stress 0: no gaps; else a seed: every valid and ready of the
 * test bench comes at random. wave: a file for the waveform of a build with traces, or NULL. */
void bus_open(uint64_t stress, const char *wave);
/* Before bus_open: words of the command that begin with + are for the design. */
void bus_arguments(int argc, char **argv);
void bus_close(void);
void bus_reset(void);

/* The accesses; context is not read. They fail on SLVERR, after 10,000,000 cycles without a
 * transfer, and after as many cycles of their own as bus_limit says, if it was called. bus_receive
 * also takes results that came during other accesses. */
void bus_limit(uint64_t cycles);
bool bus_read(void *context, uint32_t address, uint32_t *value);
bool bus_write(void *context, uint32_t address, uint32_t value);
bool bus_send(void *context, const int32_t vertex[3], bool last, bool to_b);
/* A vertex that is offered from so many cycles on, 1 or more, beside other accesses; and wait for
 * it. */
void bus_offer(const int32_t vertex[3], bool last, bool to_b, uint64_t after);
bool bus_sent(void);
/* Of a tree engine instead of bus_send: the memory that it reads. */
void bus_memory(const memory_options *options);
const memory *bus_attached(void);
bool bus_receive(void *context, uint64_t *result, bool *last);

/* A write with other byte strobes. */
bool bus_write_part(uint32_t address, uint32_t value, unsigned strobes);
/* Many accesses on their way at once, each channel as far as it goes, with gaps; writes in their
 * order, and reads in theirs. `patient`: a response is taken when it is there, not before. */
typedef struct {
  uint32_t address, value; /* of a read: what was read */
  unsigned strobes;        /* of a write; 0: a read */
  bool ok;                 /* OKAY, not SLVERR */
} bus_access;
void bus_crowd(bus_access *list, size_t count, bool patient);
/* Take no results (false: from now on again). */
void bus_block_results(bool block);
/* Let cycles go by. */
void bus_idle(uint64_t cycles);
bool bus_interrupt(void);
/* Cycles in which the interrupt rose last, a response to a write and a vertex were taken last. */
uint64_t bus_rose(void);
uint64_t bus_responded(void);
uint64_t bus_came(void);

/* Transfers on all channels, cycles, and breaches of the protocol so far (each is printed). */
uint64_t bus_beats(void);
uint64_t bus_cycles(void);
uint64_t bus_breaches(void);

#ifdef __cplusplus
}
#endif

#endif
