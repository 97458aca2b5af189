/* SPDX-License-Identifier: MIT */
/* memory.h - a memory behind an AXI4 read port of 128 bits, for test benches under Verilator: as
 * fast as its latency allows, or with delays, gaps and errors at random; it watches what AXI asks
 * of the master. In each cycle the test bench calls memory_drive, evaluates the design, and calls
 * memory_clock before the clock's edge. */
#ifndef SEPAX_TREE_TB_MEMORY_H
#define SEPAX_TREE_TB_MEMORY_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { MEMORY_BEAT = 16, MEMORY_OPEN_MAX = 64, MEMORY_BANKS = 16 };

typedef struct {
  const uint8_t *bytes; /* contents; a read beside them is answered with DECERR */
  uint64_t base, size;  /* address of bytes[0], a multiple of 16; how many bytes */
  bool repeated;        /* above base they come again and again; size is a power of two */
  int latency;          /* cycles from an address to its first beat, 1 or more */
  bool banked;     /* as a DRAM: 16 banks with an open row of 2 KB each. A burst in the open row
                    * comes after 60 cycles and keeps its bank busy for 4; another one comes
                    * after 110 and keeps it busy for 50. Answers stay in order; `latency` is
                    * not used */
  int open_max;    /* bursts that the master may have open; 0: 32 */
  uint64_t stress; /* 0: none; else a seed: addresses wait, up to 64 cycles in which none is
                    * taken, beats come late and with gaps */
  /* Beats in [error_from, error_to) come with EXOKAY, SLVERR, DECERR or a wrong RLAST. */
  uint64_t error_from, error_to;
  uint64_t error_odds; /* and one beat in so many, at random; 0: none */
  /* And beat wrong_beat, counted from 1 on since memory_open, comes with RRESP wrong_how, or where
   * that is 0 with a wrong RLAST; where wrong_keeps, its data are right. */
  uint64_t wrong_beat;
  unsigned wrong_how;
  bool wrong_keeps;
  bool uncalled;    /* beats come, for a cycle each, while no burst is open, which AXI forbids */
  uint32_t *bursts; /* a number a beat of `bytes`: bursts that began there; NULL: not counted */
} memory_options;

/* What the master drives in a cycle. */
typedef struct {
  bool arvalid, rready;
  uint64_t araddr;
  unsigned arlen;
} memory_master;

/* What the memory drives. */
typedef struct {
  bool arready, rvalid, rlast;
  unsigned rresp;
  uint32_t rdata[4]; /* lowest bits first */
} memory_slave;

typedef struct {
  uint64_t bursts, beats, errors; /* answered */
  uint64_t breaches;              /* of the protocol; each is printed */
  int open;                       /* bursts now, the most so far */
  int open_most;
} memory_counts;

typedef struct {
  memory_options options;
  memory_counts counts;
  memory_slave slave;
  memory_master before; /* of the cycle before */
  bool was_blocked;     /* its address was not taken */
  bool is_bad;          /* the beat that is answered comes with an error */
  bool is_uncalled;     /* it belongs to no burst */
  uint64_t cycle, state, rate;
  struct {
    uint64_t address, due; /* the cycle from which on it may be answered */
    unsigned beats;
  } open[MEMORY_OPEN_MAX]; /* a ring */
  unsigned head, tail;
  unsigned beat; /* of the burst that is answered */
  struct {
    uint64_t row, free; /* the open row + 1, or 0; the cycle from which on the bank is free */
  } bank[MEMORY_BANKS];
} memory;

/* Begin, with nothing open. The options may be changed later, between runs. */
void memory_open(memory *m, const memory_options *options);
/* As a reset of bus and master: bursts that are open are forgotten. */
void memory_reset(memory *m);

const memory_slave *memory_drive(memory *m);
void memory_clock(memory *m, const memory_master *master);

/* The next number of a generator of random numbers (splitmix64). */
uint64_t memory_draw(uint64_t *state);

#ifdef __cplusplus
}
#endif

#endif
