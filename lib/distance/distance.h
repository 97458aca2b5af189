/* SPDX-License-Identifier: MIT */
/* distance.h - the nearest features of two posed triangles (private).
 *
 * A feature of a triangle is a vertex, an edge or its face: bit k is vertex k. */
#ifndef SEPAX_DISTANCE_H
#define SEPAX_DISTANCE_H

#include "body/posed.h"
#include "twofold.h"

enum { FEATURES = 32 };

/* Features of A and of B, likely ones first. */
typedef struct {
  uint8_t a[FEATURES], b[FEATURES];
  int count;
} feature_list;

/* The nearest points of two features and their distance. The points are sums of weight[k] times
 * vertex k, of A for k < 3 and of B for k >= 3. The distance is |over| / sqrt(under) if `linear`,
 * and sqrt(over / under) otherwise, in units of the posed points. */
typedef struct {
  twofold weight[6];
  big over, under;
  bool linear;
} exact_nearest;

/* Find the nearest points of the triangles. All is exact except for the weights, which are rounded.
 * The features of the list are tried first. */
void sepax__find_exact_nearest(const posed_points *p, const feature_list *likely,
                               exact_nearest *found);

/* Returns a value; the distance is value * 2^*exponent, right to 2^-90 of itself. */
twofold sepax__exact_distance(const exact_nearest *n, int *exponent);

/* The sign of (distance * 2^exponent - limit), limit >= 0; exact. */
int sepax__exact_compare(const exact_nearest *n, int exponent, double limit);

/* Like sepax_distance_posed. *way receives a direction on which the triangles are that far apart,
 * or 0 if there is none. */
double sepax__distance_and_way(const double a[3][3], const sepax_pose *pose_a, const double b[3][3],
                               const sepax_pose *pose_b, double nearest[2][3], twofold_vector *way);

/* True only if the gap on `way` proves that the distance is at least `distance`, within one unit in
 * its last place. */
bool sepax__distance_at_least(const double a[3][3], const sepax_pose *pose_a, const double b[3][3],
                              const sepax_pose *pose_b, const twofold_vector *way, double distance);

/* The sign of (distance of the triangles - limit), limit >= 0; exact. Coordinates as for
 * sepax_distance_posed. */
int sepax__distance_compare(const double a[3][3], const sepax_pose *pose_a, const double b[3][3],
                            const sepax_pose *pose_b, double limit);

#endif
