/* search.h - a search for pairs of triangles of two meshes, and the threads at it (private). */
#ifndef SEPAX_BROAD_PHASE_SEARCH_H
#define SEPAX_BROAD_PHASE_SEARCH_H

#include "body/judge.h"
#include "sepax_grid.h"

#include <stdatomic.h>

/* Pairs that are judged together. */
enum { BATCH = 64 };

typedef struct tasks tasks;

typedef struct {
  sepax_search how;
  sepax_pair_judge *judge;        /* NULL: collisions */
  void *context;                  /* of judge */
  const sepax_tri *tri[2];        /* of A, of B; on a grid */
  const double (*facet[2])[3][3]; /* or doubles, in poses */
  posed_pairs posed;
  double unit; /* of boxes: coordinates times this are within 1 */
  size_t count[2];
  int64_t margin;  /* between AABBs of a pair that is judged */
  uint64_t total;  /* what progress is told */
  tasks *tasks;    /* halves.c */
  int32_t *column; /* of B, for brute force; its parts and the next task */
  sepax_columns columns;
  size_t parts;
  atomic_size_t next;
  atomic_bool stop;
  bool ended; /* by progress */
} search;

typedef struct {
  search *all;
  bool reports; /* to progress: the calling thread */
  sepax_pairs found;
  size_t capacity;
  size_t waiting; /* candidates */
  uint32_t candidate[BATCH][2];
  bool no_memory;
} worker;

/* A pair that is to be judged, now or when a batch is full. */
void sepax__search_add_candidate(worker *w, uint32_t i, uint32_t j);
void sepax__search_judge_candidates(worker *w);

void sepax__search_report(worker *w, uint64_t done);

/* halves.c: the lists and tasks of a search without brute force. False without memory. */
bool sepax__halves_begin(search *s, size_t *most_threads);
void sepax__halves_work(worker *w);
void sepax__halves_end(search *s);

#endif
