/* SPDX-License-Identifier: MIT */
/* search.h - the state of a search for pairs of triangles of two meshes, and of its threads
 * (private). */
#ifndef SEPAX_BROAD_PHASE_SEARCH_H
#define SEPAX_BROAD_PHASE_SEARCH_H

#include "body/judge.h"
#include "sepax_grid.h"

#include <stdatomic.h>

/* Number of pairs that are judged together. */
enum { BATCH = 64 };

typedef struct tasks tasks;

typedef struct {
  sepax_search how;
  sepax_pair_judge *judge;        /* NULL: find collisions */
  void *context;                  /* first argument of judge */
  const sepax_tri *tri[2];        /* triangles of A and of B on a grid */
  const double (*facet[2])[3][3]; /* or triangles of doubles, in poses */
  posed_pairs posed;
  double unit; /* coordinates times this number are within 1 */
  size_t count[2];
  int64_t margin;  /* largest gap of the AABBs of a pair that is judged */
  uint64_t total;  /* total work for the progress function */
  tasks *tasks;    /* of halves.c */
  int32_t *column; /* for brute force: columns of B, their parts, the next task */
  sepax_columns columns;
  size_t parts;
  atomic_size_t next;
  atomic_bool stop;
  bool ended; /* the progress function ended the search */
} search;

typedef struct {
  search *all;
  bool reports; /* calls the progress function; true for the calling thread */
  sepax_pairs found;
  size_t capacity;
  size_t waiting; /* number of waiting candidates */
  uint32_t candidate[BATCH][2];
  bool no_memory;
} worker;

/* Add a pair to the candidates, and judge them if the batch is full. */
void sepax__search_add_candidate(worker *w, uint32_t i, uint32_t j);
void sepax__search_judge_candidates(worker *w);

void sepax__search_report(worker *w, uint64_t done);

/* halves.c: prepare, run and end a search that is not brute force. False without memory. */
bool sepax__halves_begin(search *s, size_t *most_threads);
void sepax__halves_work(worker *w);
void sepax__halves_end(search *s);

#endif
