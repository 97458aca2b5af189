/* SPDX-License-Identifier: MIT */
/* bounds.c - bounds of a pair's distance and of its relative motion that cost less than a search.
 *
 * Rounding. Let n joints lie between two bodies and let `scale` be the sum of the lengths of both
 * boxes' corners, of the origins and of the ways along prismatic axes, as each place counts it. A
 * point of a body is at most `scale` away from the top's origin. It is wrong by at most n 2^-45
 * scale because its pose is (docs/reference/mechanisms.md). What is computed here from such points
 * takes fewer than 60 roundings of numbers that are at most 2 scale, which is less than 2^-46
 * scale. The rotations are orthonormal up to 2 n 2^-46, which changes a length by less than n 2^-44
 * scale. So (n + 1) 2^-42 scale is more than all of this together. */
#include "mechanism/machine.h"
#include "util/vector.h"

#include <math.h>

/* A factor that covers all rounding of the products and sums of motions. */
static const double up = 1 + 0x1p-30;

static const watch_place *place_of(const sepax_watch *w, size_t pair, int side) {
  return &w->place[w->machine->pair[pair].place[side]];
}

/* Squares of lengths within these limits neither overflow nor lose more by underflow than 2^-500.
 * Beyond them nothing is bounded here, and the searches decide. */
static bool has_squares(double scale) { return scale >= 0x1p-400 && scale <= 0x1p450; }

double sepax__pair_slack(const sepax_watch *w, size_t pair) {
  const machine_pair *p = &w->machine->pair[pair];
  const machine_place *a = &w->machine->place[p->place[0]];
  const machine_place *b = &w->machine->place[p->place[1]];
  double scale = w->place[p->place[0]].scale + w->place[p->place[1]].scale;
  return has_squares(scale) ? (double)(a->depth + b->depth + 1) * 0x1p-42 * scale : INFINITY;
}

/* ------------------------------------------------------------------------- travel */

/* The greatest distance of a point of a posed box from the axis of a joint, which is reached at a
 * corner because the distance is a convex function. */
static double reach_of(const watch_place *box, const sepax_pose *child, const double axis[3]) {
  double a[3];
  double arm[3];
  double at[4][3]; /* the axis times the centre's arm, and times each half side */
  for (int i = 0; i < 3; i++) {
    a[i] = vector_dot(child->rotation[i], axis);
    arm[i] = box->centre[i] - child->translation[i];
  }
  vector_cross(a, arm, at[0]);
  for (int k = 0; k < 3; k++) {
    vector_cross(a, box->side[k], at[k + 1]);
  }
  double most = 0;
  for (int corner = 0; corner < 8; corner++) {
    double v[3];
    for (int i = 0; i < 3; i++) {
      v[i] = at[0][i] + ((corner & 1) != 0 ? at[1][i] : -at[1][i]) +
             ((corner & 2) != 0 ? at[2][i] : -at[2][i]) +
             ((corner & 4) != 0 ? at[3][i] : -at[3][i]);
    }
    most = fmax(most, vector_dot(v, v));
  }
  return sqrt(most);
}

/* How far the joint of a node moves a point of a box, while the other joints have their values. A
 * turn by d moves a point at the distance r from the axis by at most 2 r sin(d / 2) if d is at most
 * half a turn, and by 2 r otherwise: at most r times the lesser of d and 2.
 *
 * The motions of several joints add up to no more than their sum. Let the joints be 1 ... n from
 * the body outwards, E_j the motion of joint j at its value and F_j at another value within the
 * travel. Replace E_n by F_n first, then E_(n-1), and so on. The step from F_n ... F_(j+1) E_j ...
 * E_1 p to F_n ... F_(j+1) F_j E_(j-1) ... E_1 p is as long as that from E_j E_(j-1) ... E_1 p to
 * F_j E_(j-1)
 * ... E_1 p, because F_n ... F_(j+1) keeps lengths. In the latter, p is where the values put it. */
static double step_by(const sepax_watch *w, const watch_place *box, size_t node, double slack) {
  size_t number = w->machine->node[node].joint;
  const sepax_joint *joint = &w->machine->mechanism->joint[number];
  double travel = w->travel[number];
  if (joint->kind == SEPAX_JOINT_FIXED || !(travel > 0)) {
    return 0;
  }
  if (joint->kind == SEPAX_JOINT_PRISMATIC) {
    return travel * up;
  }
  return fmin(travel, 2) * (reach_of(box, &w->node[node].pose, joint->axis) + slack) * up;
}

/* How far the joints between the body and the top move the body. */
static void move_place(sepax_watch *w, size_t place) {
  const machine_place *p = &w->machine->place[place];
  const watch_place *box = &w->place[place];
  double *moved = &w->moved[p->first];
  double slack = (double)(p->depth + 1) * 0x1p-42 * box->scale;
  size_t node = p->node;
  moved[0] = 0;
  for (size_t n = 0; n < p->depth; n++, node = w->machine->node[node].parent) {
    moved[n + 1] = (moved[n] + step_by(w, box, node, slack)) * up;
  }
}

double sepax__pair_motion(const sepax_watch *w, size_t pair) {
  const machine_pair *p = &w->machine->pair[pair];
  double sum = 0;
  for (int side = 0; side < 2; side++) {
    const machine_place *place = &w->machine->place[p->place[side]];
    sum += w->moved[place->first + place->depth];
  }
  return sum * up + sepax__pair_slack(w, pair);
}

/* Seen from any link between the bodies, the distance changes by no more than both bodies move
 * there: each by the joints between it and the link. This is the least sum over the links between
 * the top and the body of a side. The joints above the link move the other body. */
static double least_of_side(sepax_watch *w, size_t pair, int side) {
  const machine_pair *p = &w->machine->pair[pair];
  const machine_place *own = &w->machine->place[p->place[side]];
  const machine_place *other = &w->machine->place[p->place[!side]];
  const double *moved = &w->moved[own->first];
  double slack = sepax__pair_slack(w, pair);
  size_t node = own->node;
  for (size_t n = 0; n < own->depth; n++, node = w->machine->node[node].parent) {
    w->way[n] = node;
  }
  double moved_other = w->moved[other->first + other->depth];
  double least = (moved[own->depth] + moved_other) * up;
  for (size_t n = own->depth; n-- > 0;) {
    double step = step_by(w, place_of(w, pair, !side), w->way[n], slack);
    moved_other = (moved_other + step) * up;
    least = fmin(least, (moved[n] + moved_other) * up);
  }
  return least;
}

double sepax__pair_least_motion(sepax_watch *w, size_t pair) {
  return fmin(least_of_side(w, pair, 0), least_of_side(w, pair, 1)) + sepax__pair_slack(w, pair);
}

void sepax__watch_move(sepax_watch *w) {
  for (size_t n = 0; n < w->machine->places; n++) {
    move_place(w, n);
  }
}

/* ------------------------------------------------------------------------- boxes */

double sepax__pair_ball_gap(const sepax_watch *w, size_t pair) {
  const machine_pair *p = &w->machine->pair[pair];
  const watch_place *a = &w->place[p->place[0]];
  const watch_place *b = &w->place[p->place[1]];
  const double way[3] = {b->centre[0] - a->centre[0], b->centre[1] - a->centre[1],
                         b->centre[2] - a->centre[2]};
  return vector_length(way) - a->radius - b->radius - w->pair[pair].slack;
}

/* How far one box is from the AABB, in its own coordinates, that holds the other. */
static double gap_from(const watch_place *own, const double axis[3][3], const double half[3],
                       const watch_place *other) {
  const double way[3] = {other->centre[0] - own->centre[0], other->centre[1] - own->centre[1],
                         other->centre[2] - own->centre[2]};
  double square = 0;
  for (int i = 0; i < 3; i++) {
    const double u[3] = {axis[0][i], axis[1][i], axis[2][i]};
    double gap = fabs(vector_dot(u, way)) - half[i] - fabs(vector_dot(u, other->side[0])) -
                 fabs(vector_dot(u, other->side[1])) - fabs(vector_dot(u, other->side[2]));
    square += gap > 0 ? gap * gap : 0;
  }
  return sqrt(square);
}

double sepax__pair_box_gap(const sepax_watch *w, size_t pair) {
  const sepax_machine *machine = w->machine;
  const machine_pair *p = &machine->pair[pair];
  double most = 0;
  for (int side = 0; side < 2; side++) {
    const machine_place *own = &machine->place[p->place[side]];
    double gap = gap_from(place_of(w, pair, side), w->node[own->node].pose.rotation,
                          machine->box[own->body].half, place_of(w, pair, !side));
    most = fmax(most, gap);
  }
  return most - w->pair[pair].slack;
}

/* ------------------------------------------------------------------- kept bounds */

/* The first body in the second's coordinates; the second's rotation is taken as orthonormal. */
static void relate(const sepax_watch *w, size_t pair, sepax_pose *at) {
  const machine_pair *p = &w->machine->pair[pair];
  const sepax_pose *a = &w->node[w->machine->place[p->place[0]].node].pose;
  const sepax_pose *b = &w->node[w->machine->place[p->place[1]].node].pose;
  const double way[3] = {a->translation[0] - b->translation[0],
                         a->translation[1] - b->translation[1],
                         a->translation[2] - b->translation[2]};
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      at->rotation[i][j] = b->rotation[0][i] * a->rotation[0][j] +
                           b->rotation[1][i] * a->rotation[1][j] +
                           b->rotation[2][i] * a->rotation[2][j];
    }
    at->translation[i] =
        b->rotation[0][i] * way[0] + b->rotation[1][i] * way[1] + b->rotation[2][i] * way[2];
  }
}

void sepax__pair_keep(sepax_watch *w, size_t pair, double least) {
  watch_pair *known = &w->pair[pair];
  known->kept = least < INFINITY ? least : 0;
  if (known->kept > 0) {
    known->kept_slack = known->slack;
    relate(w, pair, &known->at);
  }
}

/* Let x be a point of A and y a point of B, and let D be the difference of their relative poses.
 * Then |x - y| falls by at most |D x|, which is an affine function of x: no more than what it is
 * for the centre of A's box, and what it adds along each half side. That B's rotations are not
 * quite orthonormal is covered by the slack of both poses: it makes an error of at most 2 n 2^-46
 * of the coordinates in B and of the distance, once in each pose. */
double sepax__pair_kept_gap(const sepax_watch *w, size_t pair) {
  const watch_pair *known = &w->pair[pair];
  if (!(known->kept > 0)) {
    return -1;
  }
  const machine_box *box =
      &w->machine->box[w->machine->place[w->machine->pair[pair].place[0]].body];
  sepax_pose at;
  relate(w, pair, &at);
  double way[4][3];
  for (int i = 0; i < 3; i++) {
    way[3][i] = at.translation[i] - known->at.translation[i];
    for (int k = 0; k < 3; k++) {
      double turned = at.rotation[i][k] - known->at.rotation[i][k];
      way[3][i] += turned * box->centre[k];
      way[k][i] = turned * box->half[k];
    }
  }
  double moved =
      vector_length(way[0]) + vector_length(way[1]) + vector_length(way[2]) + vector_length(way[3]);
  return known->kept - moved - 2 * (known->kept_slack + known->slack);
}
