/* SPDX-License-Identifier: MIT */
/* watch.c - the memory of a machine's queries, and where its links and bodies are. */
#include "mechanism/machine.h"
#include "mechanism/steps.h"
#include "util/error.h"
#include "util/memory.h"

#include <math.h>
#include <string.h>

static const sepax_pose at_origin = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};

/* ------------------------------------------------------------------------- memory */

/* Of each pair's front. More of them would serve only searches of hundreds of microseconds. */
enum { FRONT_ENTRIES = 512 };

void sepax_watch_free(sepax_watch *watch) {
  if (watch != NULL) {
    sepax_release(watch->value);
    sepax_release(watch->travel);
    sepax_release(watch->step);
    sepax_release(watch->stepped);
    sepax_release(watch->node);
    sepax_release(watch->place);
    sepax_release(watch->moved);
    sepax_release(watch->way);
    sepax_release(watch->pair);
    sepax_release(watch->last);
    sepax_release(watch->has_last);
    sepax_release(watch->fronts);
    sepax_release(watch->front);
    sepax_release(watch->queue);
    sepax_release(watch->key);
    sepax_release(watch);
  }
}

/* Writing zeros into all memory also brings its pages in. */
static bool make(sepax_watch *w, const sepax_machine *machine) {
  const size_t joints = machine->mechanism->joints;
  size_t longest = 0;
  for (size_t n = 0; n < machine->places; n++) {
    longest = machine->place[n].depth > longest ? machine->place[n].depth : longest;
  }
  w->machine = machine;
  w->near_before = SEPAX_NO_PAIR;
  w->least_before = SEPAX_NO_PAIR;
  return (w->value = sepax__zeroed(joints, sizeof *w->value)) != NULL &&
         (w->travel = sepax__zeroed(joints, sizeof *w->travel)) != NULL &&
         (w->step = sepax__zeroed(joints, sizeof *w->step)) != NULL &&
         (w->stepped = sepax__zeroed(joints, sizeof *w->stepped)) != NULL &&
         (w->node = sepax__zeroed(machine->nodes, sizeof *w->node)) != NULL &&
         (w->place = sepax__zeroed(machine->places, sizeof *w->place)) != NULL &&
         (w->moved = sepax__zeroed(machine->moves, sizeof *w->moved)) != NULL &&
         (w->way = sepax__zeroed(longest, sizeof *w->way)) != NULL &&
         (w->pair = sepax__zeroed(machine->pairs, sizeof *w->pair)) != NULL &&
         (w->last = sepax__zeroed(machine->pairs, sizeof *w->last)) != NULL &&
         (w->has_last = sepax__zeroed(machine->pairs, sizeof *w->has_last)) != NULL &&
         (w->front = sepax__zeroed(machine->pairs, sizeof(sepax_front *))) != NULL &&
         (w->fronts = sepax__zeroed(machine->pairs, sepax_front_bytes(FRONT_ENTRIES))) != NULL &&
         (w->queue = sepax__zeroed(machine->pairs, sizeof *w->queue)) != NULL &&
         (w->key = sepax__zeroed(machine->pairs, sizeof *w->key)) != NULL;
}

bool sepax_watch_new(sepax_watch **watch, const sepax_machine *machine, sepax_error *error) {
  *watch = NULL;
  sepax_watch *made = sepax__zeroed(1, sizeof *made);
  if (made == NULL || !make(made, machine)) {
    sepax_watch_free(made);
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for a watch of %zu pairs",
                      machine->pairs);
  }
  for (size_t n = 0; n < machine->pairs; n++) {
    size_t bytes = sepax_front_bytes(FRONT_ENTRIES);
    if (!sepax_front_begin(&made->front[n], made->fronts + n * bytes, bytes, error)) {
      sepax_watch_free(made);
      return false;
    }
  }
  *watch = made;
  return true;
}

/* ------------------------------------------------------------------------- joints */

static bool fail_value(const sepax_joint *joint, double value, sepax_error *error) {
  return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                    "joint %.60s: its value is %g; give a finite number", joint->name, value);
}

/* The value that a joint has. That of a follower is rounded twice. */
static double value_of(const sepax_mechanism *m, size_t n, const double *value) {
  const sepax_joint *joint = &m->joint[n];
  if (joint->kind == SEPAX_JOINT_FIXED) {
    return 0;
  }
  return joint->mimic == SEPAX_NO_JOINT ? value[n]
                                        : joint->factor * value[joint->mimic] + joint->offset;
}

/* The travel of a joint. That of a follower covers the rounding of its value. */
static double travel_of(const sepax_mechanism *m, size_t n, const double *value,
                        const double *travel) {
  const sepax_joint *joint = &m->joint[n];
  if (joint->kind == SEPAX_JOINT_FIXED) {
    return 0;
  }
  if (joint->mimic == SEPAX_NO_JOINT) {
    return travel[n];
  }
  double factor = fabs(joint->factor);
  return factor * travel[joint->mimic] * (1 + 0x1p-50) +
         0x1p-51 * (factor * fabs(value[joint->mimic]) + fabs(joint->offset)) + 0x1p-1060;
}

static uint64_t bits_of(double x) {
  uint64_t bits;
  memcpy(&bits, &x, sizeof bits);
  return bits;
}

/* A joint takes a value. Equal bits are the same step; 0 and -0 may be different ones. */
static void step_to(sepax_watch *w, size_t n, double value) {
  w->stepped[n] = !w->settled || bits_of(value) != bits_of(w->value[n]);
  if (w->stepped[n]) {
    w->value[n] = value;
    w->step[n] = sepax__step_of(&w->machine->mechanism->joint[n], value);
  }
}

static bool place_joints(sepax_watch *w, const double *value, const double *travel,
                         sepax_error *error) {
  const sepax_mechanism *m = w->machine->mechanism;
  for (size_t n = 0; n < m->joints; n++) {
    if (sepax_joint_driven(&m->joint[n]) && !isfinite(value[n])) {
      return fail_value(&m->joint[n], value[n], error);
    }
    if (sepax_joint_driven(&m->joint[n]) && travel != NULL &&
        !(travel[n] >= 0 && travel[n] < INFINITY)) {
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "joint %.60s: its travel is %g; give a finite number, 0 or more",
                        m->joint[n].name, travel[n]);
    }
  }
  for (size_t n = 0; n < m->joints; n++) {
    double at = value_of(m, n, value);
    if (!isfinite(at)) {
      return fail_value(&m->joint[n], at, error);
    }
    step_to(w, n, at);
    w->travel[n] = travel != NULL ? travel_of(m, n, value, travel) : 0;
  }
  return true;
}

/* ------------------------------------------------------------------ links, bodies */

static void place_node(sepax_watch *w, size_t n) {
  const machine_node *node = &w->machine->node[n];
  watch_node *at = &w->node[n];
  if (node->joint == SEPAX_NO_JOINT) {
    *at = (watch_node){.pose = at_origin, .changed = !w->settled};
    return;
  }
  const watch_node *parent = &w->node[node->parent];
  const sepax_joint *joint = &w->machine->mechanism->joint[node->joint];
  at->changed = parent->changed || w->stepped[node->joint];
  if (at->changed) {
    at->pose = sepax_pose_compose(&parent->pose, &w->step[node->joint]);
  }
  at->ways = parent->ways + (joint->kind == SEPAX_JOINT_PRISMATIC
                                 ? fabs(w->value[node->joint]) + w->travel[node->joint]
                                 : 0);
}

static bool within_limits(const sepax_pose *pose) {
  return fabs(pose->translation[0]) <= 0x1p1000 && fabs(pose->translation[1]) <= 0x1p1000 &&
         fabs(pose->translation[2]) <= 0x1p1000;
}

static void place_body(sepax_watch *w, size_t n) {
  const machine_place *place = &w->machine->place[n];
  const machine_box *box = &w->machine->box[place->body];
  const watch_node *node = &w->node[place->node];
  watch_place *at = &w->place[n];
  at->scale = place->scale + node->ways;
  at->radius = box->radius;
  if (node->changed) {
    sepax_pose_apply(&node->pose, box->centre, at->centre);
    for (int k = 0; k < 3; k++) {
      for (int i = 0; i < 3; i++) {
        at->side[k][i] = node->pose.rotation[i][k] * box->half[k];
      }
    }
  }
}

bool sepax__watch_place(sepax_watch *w, const double *value, const double *travel,
                        sepax_error *error) {
  const sepax_machine *machine = w->machine;
  bool ok = place_joints(w, value, travel, error);
  for (size_t n = 0; n < machine->nodes && ok; n++) {
    place_node(w, n);
    ok = within_limits(&w->node[n].pose) ||
         sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                    "joint %.60s: its value moves a link beyond 2^1000; give a lesser one",
                    machine->mechanism->joint[machine->node[n].joint].name);
  }
  for (size_t n = 0; n < machine->places && ok; n++) {
    place_body(w, n);
  }
  w->settled = ok;
  return ok;
}
