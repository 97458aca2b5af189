/* SPDX-License-Identifier: MIT */
/* bench.h - what the parts of the tree engine's test bench share. */
#ifndef SEPAX_BATCH_BENCH_H
#define SEPAX_BATCH_BENCH_H

#include "object_engine/bus.h"
#include "object_engine/crowd.h"
#include "sepax_params.h"
#include "sepax_tree_registers.h"
#include "sepax_tree.h"
#include "sepax_tree_driver.h"

extern uint64_t bench_base; /* address of the memory, a multiple of 4096 */

extern sepax_design design;
extern sepax_tree_device device;
extern unsigned long long wrong;

/* Count and print what is not as it must be. */
void expect(const char *what, unsigned long long got, unsigned long long wanted);
_Noreturn void stop(const char *text);
void stop_on(bool failed, const char *text);
void stop_at(bool failed, const char *path, const char *text); /* of something in a file */

/* Space in the engine's memory, a multiple of `unit` bytes from its base on: its offset. Before the
 * first call and with bench_clear it is empty. */
size_t bench_space(size_t bytes, size_t unit);
uint8_t *bench_at(size_t offset);
void bench_clear(void);
/* Space for so many bytes, of which few are used: it takes memory only for these. Until
 * bench_clear, and nothing counts which blocks are read. */
void bench_reserve(size_t bytes);
uint64_t bench_address(size_t offset);

/* Put a tree there; its body record. */
void bench_tree(const sepax_tree *tree, uint8_t record[SEPAX_TREE_BODY_BYTES]);

/* Attach what was put there, with a latency and so on; bytes, base and size are filled in. */
void bench_attach(memory_options options);

/* A batch, compared pose by pose with the golden model. */
typedef struct {
  size_t list; /* offset of the jobs */
  uint32_t jobs;
  bool errors; /* memory answers with errors: the batch may end with one */
  bool any;    /* jobs are any bytes: what the golden model calls an error of the bus may be one */
  bool print;  /* a line a pose */
  /* Called with each pose that was compared: was it right? NULL: not called. */
  void (*told)(void *context, const sepax_outcome *outcome, bool right);
  void *context;
  int stop_at; /* pose from the beginning at which STOP is written; -1: never */
  uint64_t cycles, worst, poses, mismatches, near, hits, out_of_range, stopped, warnings; /* out */
  uint64_t damaged, bus, refused;
  uint32_t status;       /* out: every bit of a pose's status that was set */
  uint64_t predicted;    /* out: cycles by the golden model, all caches cold */
  double off;            /* out: its largest relative error in a pose */
  uint32_t first_hit[2]; /* job and pose of the first pose that collides, where hits > 0 */
} bench_batch;
void bench_run(bench_batch *batch);

/* Which blocks of its memory a batch has read. */
typedef struct {
  const uint32_t *bursts; /* that began at each beat of the memory, from bench_base on */
  uint64_t colds;         /* poses before which the caches forgot what they had */
  bool whole;             /* none was stopped */
} bench_reads;

/* Of a batch of sound jobs about one pair of bodies, of so many bursts in all: no job or pose is
 * read twice; no node and no record twice after a cold start, of bodies of up to 16 nodes and 4
 * leaves; nothing else is read. */
void reads_check(const bench_reads *of, uint64_t list, uint32_t jobs, uint64_t bursts);

/* Seeded bodies, poses, modes; then damage, errors, resets, refusals. */
void bench_rounds(unsigned long long rounds, uint64_t seed, bool stressed);

/* Seeded bodies, poses and modes alone. */
void bench_sound(unsigned long long rounds, uint64_t seed, bool stressed);

/* Poses that end quickly while their results are taken late, 1 ... 8 transfers at a time. */
void bench_late(uint64_t seed);

/* Small bodies, of which, as of jobs and poses, any bytes are damaged. */
void bench_fuzz(unsigned long long batches, uint64_t seed);

/* Two bodies in the poses of a file; resolution 0: the finest. */
void bench_meshes(const char *const path[3], double resolution, unsigned modes, unsigned budget,
                  const memory_options *options);

/* A list of jobs in a file. */
void bench_list(const char *path, const memory_options *options);

/* Spindle, holder and tool against table, fixture and workpiece, in poses along a path; with
 * a seed, in trouble. */
void bench_scene(size_t poses, uint64_t seed);

/* A list of jobs of so many poses each, again and again: under stress, left, stopped, with errors
 * of the memory, with damaged nodes, with poses that are refused. */
void bench_troubles(const bench_batch *batch, size_t poses, uint64_t seed);

#endif
