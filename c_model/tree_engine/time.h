/* SPDX-License-Identifier: MIT */
/* time.h - predicts the cycles of the tree engine (private; docs/reference/tree-engine.md, Time).
 * The walk tells each entry and each row. The model keeps, for the caches, the bus, the compare
 * path, the pair test and the cores, until which cycle each is busy. All members named like a part
 * are cycles. */
#ifndef SEPAX_TREE_TIME_H
#define SEPAX_TREE_TIME_H

#include "sepax_tree.h"

enum {
  TIME_NODE_SETS = 16,
  TIME_WAYS = 4,
  TIME_PAIRS = 16 /* pairs between the pair test and the cores */
};

/* A place of a cache. */
typedef struct {
  uint32_t number;   /* number of the block + 1; 0: empty */
  uint64_t there;    /* cycle from which on the block is here */
  uint64_t used;     /* tree_time.uses at the last use */
  uint64_t released; /* cycle from which on the block may be replaced */
} time_place;

typedef struct {
  const uint64_t *span; /* cycles of the steps of the target: time.c */
  uint64_t latency, ii, cores;
  uint64_t most_rows;   /* rows in the row queue */
  uint64_t most_leaves; /* leaves of a body; also pairs of leaves that are in and not released */
  uint64_t asked;       /* the last address went out */
  uint64_t bus;         /* the bus is free */
  uint64_t compare;     /* the compare path is free */
  uint64_t pairs;       /* the pair test is free */
  uint64_t verdict;     /* a core took the last pair */
  uint64_t free_at[SEPAX_CORES_MAX]; /* each core is free */
  uint64_t begun[SEPAX_ROWS_MAX];    /* the first pair of row n was tested, at n modulo most_rows */
  uint64_t rows, uses;               /* numbers of rows and of uses of the caches */
  uint32_t corners;                  /* vertex numbers of the last row */
  uint32_t leaves[2];                /* leaves of the last row, + 1 */
  time_place *places[2];             /* places of these leaves */
  uint64_t released[SEPAX_LEAVES_MAX]; /* pair of leaves n was released, at n modulo most_leaves */
  uint64_t pairs_of_leaves;            /* their number */
  uint64_t leaves_there;               /* the leaves of the last row are here */
  time_place node[2][TIME_NODE_SETS][TIME_WAYS];
  time_place leaf[2][SEPAX_LEAVES_MAX / TIME_WAYS][TIME_WAYS];
} tree_time;

void sepax__tree_time_begin(tree_time *t, const sepax_config *config, int latency);

/* An entry enters the line in cycle `now`, with the nodes node[0] of A and node[1] of B. Returns
 * the cycle in which both nodes are here. */
uint64_t sepax__tree_time_move(tree_time *t, uint64_t now, const uint32_t node[2]);

/* An entry whose nodes are here from `there` on turns `boxes` boxes. Returns the cycle in which it
 * is finished. */
uint64_t sepax__tree_time_finish(tree_time *t, uint64_t there, unsigned boxes);

/* A row, which was found in cycle `now`: its leaves, the beats of their records, the numbers of the
 * vertices of B's triangle (5 bits each), its pairs, and how many of them are near. */
typedef struct {
  uint64_t now;
  uint32_t leaf[2];
  int beats[2];
  uint32_t corners;
  unsigned pairs, near;
} time_row;
void sepax__tree_time_row(tree_time *t, const time_row *row);

/* The cycle of the last verdict; without a near pair, the cycle in which the walk ends. */
uint64_t sepax__tree_time_end(const tree_time *t, const sepax_design *design);

#endif
