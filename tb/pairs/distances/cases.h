/* SPDX-License-Identifier: MIT */
/* cases.h - two bodies in poses whose distance is hard to find, and that distance. */
#ifndef DISTANCES_CASES_H
#define DISTANCES_CASES_H

#include "oracle/bodies.h"
#include "oracle/oracle.h"
#include "oracle/real_pairs.h"

#include <math.h>
#include <string.h>

enum { MOST = 64 }; /* triangles of a body, but for kind LARGE */

typedef enum {
  STREWN,   /* triangles of any place */
  TIED,     /* parallel plates: all pairs are equally near */
  TOUCHING, /* boxes face on face, or a few ulps apart */
  NESTED,   /* a body in a hollow one */
  COPY,     /* a surface and its own copy */
  SLIVERS,  /* needles, segments and points */
  MIXED,    /* coordinates of very different sizes */
  FAR,      /* far from the origin, or from each other, for their size */
  ALIKE,    /* each triangle is nearly the same one */
  ON_EDGE,  /* a box over a plate, on its edge or corner */
  SPHERES,  /* concentric ones of few triangles */
  LARGE,    /* thousands of triangles */
  KINDS
} kind;

typedef struct {
  sepax_facet few[2][MOST];
  const sepax_facet *facet[2];
  size_t count[2];
  sepax_pose pose[2];
  const sepax_pose *given[2]; /* &pose[k], &pose[0] or NULL */
  sepax_body *body[2];
  exact_square square; /* of the distance */
  double below;        /* the greatest double that is not above the distance */
  bool is_double;      /* it is the distance */
  double slack_ulps;   /* the truth is known but for so many ulps */
} situation;

/* The large bodies, which cases share. */
void make_pool(void);
void free_pool(void);

/* Draw a case into a situation that is all zero. */
void draw_situation(situation *s, kind what, sepax_random *r);
void find_truth(situation *s, kind what);
void free_situation(situation *s, kind what);

/* The sign of the distance less x. */
int order(const situation *s, double x);

/* The exact square of the distance of a pair of triangles. */
void find_pair_square(const situation *s, const size_t pair[2], exact_square *square);

sepax_distance_result ask(const situation *s, const sepax_distance_request *request);

/* Any rotation, a third of them not quite one; translations up to `away`. */
sepax_pose any_pose(double away, sepax_random *r);

/* 2^-k, or a number of that size. */
double little(sepax_random *r, int least, int most);

static inline int64_t range(sepax_random *r, int64_t low, int64_t high) {
  return sepax_random_range(r, low, high);
}
static inline bool one_in(sepax_random *r, int64_t n) { return range(r, 1, n) == 1; }
static inline uint64_t bits_of(double x) {
  uint64_t bits;
  memcpy(&bits, &x, sizeof bits);
  return bits;
}
static inline double up(double x) { return nextafter(x, INFINITY); }
static inline double down(double x) { return nextafter(x, 0); }

#endif
