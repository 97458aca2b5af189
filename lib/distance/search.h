/* SPDX-License-Identifier: MIT */
/* search.h - the pairs of triangles of two posed bodies that may be within a limit, nearest boxes
 * first (private). */
#ifndef SEPAX_DISTANCE_SEARCH_H
#define SEPAX_DISTANCE_SEARCH_H

#include "body/placement.h"
#include "twofold.h"

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

/* A direction on which pairs of nodes may be proved to be apart (distance/support.h). */
typedef struct {
  bool possible;
  twofold_vector turned[2]; /* the way in the coordinates of each body */
  twofold shift[2];         /* of the bodies' origins on it */
  twofold end[2];           /* of the nearest triangles */
  twofold spare;            /* what they leave more than is needed */
  int high;                 /* the body whose side looks to greater numbers */
} direction_proof;

typedef struct search search;
struct search {
  const sepax_body *body[2];
  /* Called with places i of A and j of B whose distance is within least ... most, where least is
   * at most the limit; the limit may be lowered then. */
  void (*take)(search *s, const uint32_t at[2], double least, double most);
  /* Called now and then, once `nearest` is known: begins proofs by a direction. True if it is
   * proved that no other pair need be found, which ends the search. NULL: not called. */
  bool (*prove)(search *s);
  bool prove_soon; /* set by `take` to call it at the next step */
  void *context;
  double limit;       /* farther pairs need not be found; in file units; below 0: none need */
  int batch;          /* so many pairs are looked at together */
  bool ended;         /* set to end the search */
  uint64_t work;      /* units of work so far */
  uint64_t work_most; /* end after so many; 0: no limit */
  double seconds;     /* end after so much time; 0: no limit */
  bool portable;      /* without AVX2 */
  sepax_front *front; /* receives what the search proves; NULL: nothing. The limit must stay then */
  bool resume;        /* go on at the front's list instead of at the roots */
  bool best_first;    /* if a limit may end the search: with pairs that bound the distance least */
  /* of the search */
  placement at;
  world_pose pose[2];
  double unit;              /* of numbers of pairs of triangles, a power of two */
  double scale;             /* the larger of the bodies' */
  double square_of_unit[2]; /* of the bodies' scales, in terms of it */
  double most;              /* the square of the limit, likewise */
  float most_of[2];         /* and in units of each body's scale */
  double skew;              /* of the poses: distance/frames.h */
  float slack;              /* of gaps between boxes */
  float way[2][3];          /* between the bodies, in the coordinates of each */
  double line[3];           /* the same in the common coordinates, of length 1 or 0 */
  double centre[2][3];      /* of the bodies, in the common coordinates */
  double size[2];           /* of the bodies' scales, in its unit */
  box_pair nearest;         /* the triangles nearest to each other so far */
  double shortest;          /* their distance at most */
  direction_proof proof;
  double open;                    /* of a search that a limit ended: what it left is not nearer */
  box_pair waiting[SEARCH_BATCH]; /* triangles; up to 8 may be given to begin with */
  int count;
};

/* The place of the triangle in a box. */
uint32_t sepax__place_at(const sepax_body *b, uint32_t at);

/* Place the bodies, before sepax__search_pairs. The return value is a bound that their distance is
 * not below, in file units. */
double sepax__search_begin(search *s, const sepax_pose *pose_a, const sepax_pose *pose_b);

/* Calls `take` for all pairs within the limit, and for others. */
void sepax__search_pairs(search *s);

/* Calls `take` for the pairs of triangles in `waiting` that may be within the limit. */
void sepax__search_waiting(search *s);

/* Prove by one direction that no pair is within the limit. */
bool sepax__prove_beyond_limit(search *s);

/* Is it a distance that can be asked for? */
bool sepax__distance_valid(double distance, sepax_error *error);

#endif
