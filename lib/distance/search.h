/* SPDX-License-Identifier: MIT */
/* search.h - the pairs of triangles of two posed bodies that may be within a limit, nearest boxes
 * first (private). */
#ifndef SEPAX_DISTANCE_SEARCH_H
#define SEPAX_DISTANCE_SEARCH_H

#include "body/placement.h"

/* A body's triangles into the common coordinates of a search, in its unit. */
typedef struct {
  double rotation[3][3], translation[3];
  double unit;  /* of the body's coordinates, before the rotation */
  double error; /* of a placed vertex, as a length */
} world_pose;

enum { SEARCH_BATCH = 16 };

/* Where the boxes of a pair are, BODY_WIDE * node + lane, or the places of triangles; the square of
 * their distance at least, in units of the larger body's scale. */
typedef struct {
  uint32_t at[2];
  double least;
} box_pair;

typedef struct search search;
struct search {
  const sepax_body *body[2];
  /* Called with places i of A and j of B whose distance is within least ... most, where least is
   * at most the limit; the limit may be lowered then. */
  void (*take)(search *s, const uint32_t at[2], double least, double most);
  void *context;
  double limit;   /* farther pairs need not be found; in file units */
  int batch;      /* so many pairs are looked at together */
  bool ended;     /* set to end the search */
  double seconds; /* end after so much time; 0: no limit */
  bool portable;  /* without AVX2 */
  /* of the search */
  placement at;
  world_pose pose[2];
  double unit;                    /* of numbers of pairs of triangles, a power of two */
  double scale;                   /* the larger of the bodies' */
  double square_of_unit[2];       /* of the bodies' scales, in terms of it */
  double most;                    /* the square of the limit, likewise */
  float most_of[2];               /* and in units of each body's scale */
  float slack;                    /* of gaps between boxes */
  float way[2][3];                /* between the bodies, in the coordinates of each */
  box_pair nearest;               /* the triangles nearest to each other so far */
  double shortest;                /* their distance at most */
  box_pair waiting[SEARCH_BATCH]; /* triangles; up to 8 may be given to begin with */
  int count;
};

/* The place of the triangle in a box. */
uint32_t sepax__place_at(const sepax_body *b, uint32_t at);

/* Calls `take` for all pairs within the limit, and for others. */
void sepax__search_pairs(search *s, const sepax_pose *pose_a, const sepax_pose *pose_b);

#endif
