/* SPDX-License-Identifier: MIT */
/* machine.h - a machine, and what a watch remembers of its queries (private).
 *
 * The top of a pair is the last link that the ways from the root to both links have in common. All
 * poses of a pair are in the coordinates of its top, so they depend only on the joints between its
 * bodies. A node is a link as seen from a top; a place is a body as seen from a top. Pairs with the
 * same top share nodes and places. */
#ifndef SEPAX_MACHINE_H
#define SEPAX_MACHINE_H

#include "sepax_mechanism.h"

/* A body's AABB in the link's coordinates, and a ball around its centre. */
typedef struct {
  double centre[3], half[3], radius;
  double size; /* twice the lengths of the vectors to its least and to its greatest corner */
} machine_box;

typedef struct {
  size_t joint;  /* moves the link, or SEPAX_NO_JOINT if the link is the top */
  size_t parent; /* the node of the link above */
} machine_node;

typedef struct {
  size_t body, node;
  size_t first; /* number of its first entry in watch.moved; it has depth + 1 entries */
  size_t depth; /* joints between the top and the link */
  double scale; /* the box's size and the lengths of the origins of those joints */
} machine_place;

typedef struct {
  size_t place[2];
} machine_pair;

struct sepax_machine {
  sepax_mechanism parts;            /* a copy of the struct, so that the caller's may move */
  const sepax_mechanism *mechanism; /* &parts */
  sepax_machine_body *body;
  machine_box *box; /* of each body */
  size_t bodies;
  machine_node *node; /* parents before children */
  size_t nodes;
  machine_place *place;
  size_t places;
  machine_pair *pair;
  size_t pairs;
  size_t moves; /* entries of watch.moved */
};

typedef struct {
  sepax_pose pose; /* in the coordinates of the top */
  double ways;     /* sum of the ways along prismatic axes between the top and the link, with their
                      travel */
  bool changed;    /* the pose differs from that of the query before */
} watch_node;

typedef struct {
  double centre[3];  /* of the box, in the coordinates of the top */
  double side[3][3]; /* half its sides, as vectors */
  double radius;     /* of the ball around the centre */
  double scale;      /* sum of all lengths between the top and the farthest point */
} watch_place;

/* What is known of a pair. */
typedef enum {
  PAIR_OPEN,  /* not known yet */
  PAIR_APART, /* farther apart than the clearance in all positions */
  PAIR_NEAR,  /* near at the values */
  PAIR_LOOSE  /* apart at the values, but perhaps not within the travel */
} pair_state;

typedef struct {
  pair_state state;
  bool boxed;    /* `least` takes the boxes into account */
  bool close;    /* found to be near at `need`, which does not say that it is near at the values */
  bool final;    /* measured as well as the tolerance asks */
  double slack;  /* bounds all rounding of lengths in this pair */
  double motion; /* bounds the relative motion by travel, rounding included; 0 without travel */
  double need;   /* a greater distance is APART */
  double least;  /* certain bound of the distance at the values */
  uint64_t got;  /* units of work that the pair had at most in one search of this query */
  double kept;   /* bound of the distance in the pose `at`; 0: none */
  double kept_slack;
  sepax_pose at;   /* of the first body in the second's coordinates */
  double beyond;   /* in the pose of the query before, the bodies are farther apart than this;
                      negative: not known */
  double touching; /* in that pose `triangle` is near at this clearance; negative: not known */
  size_t triangle[2];
} watch_pair;

struct sepax_watch {
  const sepax_machine *machine;
  bool settled;     /* the query before succeeded: values, steps and poses are of that query */
  double *value;    /* of all joints */
  double *travel;   /* of all joints, those that follow others included */
  sepax_pose *step; /* of each joint */
  bool *stepped;    /* the step of a joint changed since the query before */
  watch_node *node;
  watch_place *place;
  double *moved; /* moved[place.first + n]: how far the n joints nearest to the body move it */
  size_t *way;   /* space for the nodes of the longest way */
  watch_pair *pair;
  sepax_distance_result *last; /* the last measurement of each pair, if has_last */
  bool *has_last;
  char *fronts;        /* memory of the fronts of all pairs */
  sepax_front **front; /* of each pair */
  size_t *queue;       /* numbers of pairs */
  double *key;         /* of each pair that is measured */
  size_t near_before;  /* the pair that was near last, or SEPAX_NO_PAIR */
  size_t least_before; /* the pair that was measured as the least last, or SEPAX_NO_PAIR */
};

/* Put links and bodies where the values say. On an error the watch is not settled. */
bool sepax__watch_place(sepax_watch *w, const double *value, const double *travel,
                        sepax_error *error);

/* Fill in `moved` for the travel of the watch. */
void sepax__watch_move(sepax_watch *w);

/* Bounds on the relative motion of a pair by the travel of its joints: quickly, from what the
 * places know; and for the link between the bodies that is best. Both include the rounding of
 * poses. */
double sepax__pair_motion(const sepax_watch *w, size_t pair);
double sepax__pair_least_motion(sepax_watch *w, size_t pair);

/* A bound on all rounding of lengths in a pair. */
double sepax__pair_slack(const sepax_watch *w, size_t pair);

/* Certain bounds of the distance of a pair at the values; they may be negative: by balls, by boxes,
 * and by what is left of the bound that was kept. */
double sepax__pair_ball_gap(const sepax_watch *w, size_t pair);
double sepax__pair_box_gap(const sepax_watch *w, size_t pair);
double sepax__pair_kept_gap(const sepax_watch *w, size_t pair);

/* Keep a bound of the distance at the values for later poses. */
void sepax__pair_keep(sepax_watch *w, size_t pair, double least);

#endif
