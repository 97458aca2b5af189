/* placement.h - two bodies in their poses (private). */
#ifndef SEPAX_PLACEMENT_H
#define SEPAX_PLACEMENT_H

#include "body.h"

/* From the coordinates of one tree to those of the other: scaled[k] and turn[k] are what axis k
 * becomes, in units of the other body and of length 1; lengths grow by `ratio`; `lost` is what
 * rounding of the doubles may have moved. The last of four is 0. */
typedef struct {
  double scaled[3][4], shift[4];
  float turn[3][4], ratio, lost;
} motion;

typedef struct {
  const sepax_pose *pose[2]; /* NULL: as the body stands in its file */
  motion to[2];              /* to[0]: B's boxes into A's coordinates; to[1]: A's into B's */
  double linear[3][3];       /* B's triangles into A's file coordinates */
  double offset[3];
  double error; /* of a coordinate of B then, at most; 0 where no pose is given */
  bool whole;   /* B's axes are turned into axes: `linear` is of 0, 1 and -1, and exact */
} placement;

/* NULL is valid. */
bool sepax__poses_valid(const sepax_pose *pose_a, const sepax_pose *pose_b, sepax_error *error);

/* Of all vertices, at most. */
double sepax__largest_coordinate(const sepax_body *b);

/* All but `to`, for coordinates of B of up to `most`. */
void sepax__place_poses(placement *p, const sepax_pose *pose_a, const sepax_pose *pose_b,
                        double most);

void sepax__place_bodies(placement *p, const sepax_body *a, const sepax_pose *pose_a,
                         const sepax_body *b, const sepax_pose *pose_b);

/* True only if balls around the bodies have no common point. A pose stretches by 2^-16 at most. */
bool sepax__balls_disjoint(const sepax_body *a, const sepax_pose *pose_a, const sepax_body *b,
                           const sepax_pose *pose_b);

/* The vertices of a triangle of B in A's file coordinates, each wrong by `error` at most. */
void sepax__place_triangle_b(const placement *p, const double b[3][3], double placed[3][3]);

#endif
