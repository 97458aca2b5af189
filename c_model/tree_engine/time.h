/* time.h - about when the tree engine does what the walk does (private): caches, bus, compare path,
 * pair test and cores, each in order. docs/reference/tree-engine.md, Time. */
#ifndef SEPAX_TREE_TIME_H
#define SEPAX_TREE_TIME_H

#include "sepax_tree.h"

enum {
  TIME_NODE_SETS = 16,
  TIME_LEAF_SETS = 2,
  TIME_WAYS = 4,
  TIME_ROWS = 64,  /* in the row queue */
  TIME_LEAVES = 8, /* pairs of leaves that are in and not released */
  TIME_PAIRS = 16  /* between pair test and cores */
};

/* What a place of a cache holds, since when it is there, when it was used last, and up to when. */
typedef struct {
  uint32_t number; /* + 1; 0: nothing */
  uint64_t there, used, released;
} time_place;

typedef struct {
  const uint64_t *span; /* of steps, by target */
  uint64_t latency, ii, cores;
  uint64_t asked;   /* the last address */
  uint64_t bus;     /* until when it is taken */
  uint64_t compare; /* until when the compare path is taken */
  uint64_t pairs;   /* likewise the pair test */
  uint64_t verdict; /* the last pair was taken by a core */
  uint64_t free_at[SEPAX_CORES_MAX];
  uint64_t begun[TIME_ROWS]; /* rows by their number modulo TIME_ROWS */
  uint64_t rows, uses;
  uint32_t corners;               /* of the last row */
  uint32_t leaves[2];             /* of the last row, + 1 */
  time_place *places[2];          /* theirs */
  uint64_t released[TIME_LEAVES]; /* pairs of leaves by their number modulo TIME_LEAVES */
  uint64_t pairs_of_leaves;
  uint64_t leaves_there; /* when those of the last row are */
  time_place node[2][TIME_NODE_SETS][TIME_WAYS];
  time_place leaf[2][TIME_LEAF_SETS][TIME_WAYS];
} tree_time;

void sepax__tree_time_begin(tree_time *t, const sepax_config *config, int latency);

/* An entry is moved into the line at a time: when its nodes of A and of B are there. */
uint64_t sepax__tree_time_move(tree_time *t, uint64_t now, const uint32_t node[2]);

/* An entry of which all is there is finished, so many boxes turned: when. */
uint64_t sepax__tree_time_finish(tree_time *t, uint64_t there, unsigned boxes);

/* A row found at a time, of leaves whose records have so many beats: the numbers of the vertices of
 * B's triangle, 5 bits each, how many pairs, and how many passes through the cores the near ones of
 * them make. */
typedef struct {
  uint64_t now;
  uint32_t leaf[2];
  int beats[2];
  uint32_t corners;
  unsigned pairs, passes;
} time_row;
void sepax__tree_time_row(tree_time *t, const time_row *row);

/* The cycle of the last verdict, or of the end without one. */
uint64_t sepax__tree_time_end(const tree_time *t, const sepax_design *design);

#endif
