/* SPDX-License-Identifier: MIT */
/* join.c - is it a mechanism? Its root, the order of its joints. */
#include "mechanism/steps.h"
#include "util/error.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ------------------------------------------------------------------------ joints */

static bool make_unit(double axis[3]) {
  double most = fmax(fabs(axis[0]), fmax(fabs(axis[1]), fabs(axis[2])));
  if (!isfinite(axis[0]) || !isfinite(axis[1]) || !isfinite(axis[2]) || most == 0) {
    return false;
  }
  int power = 0;
  frexp(most, &power);
  double square = 0;
  for (int i = 0; i < 3; i++) {
    axis[i] = ldexp(axis[i], -power);
    square += axis[i] * axis[i];
  }
  double length = sqrt(square);
  for (int i = 0; i < 3; i++) {
    axis[i] /= length;
  }
  return true;
}

static bool check_mimic(const sepax_mechanism *m, size_t n, sepax_error *error) {
  const sepax_joint *joint = &m->joint[n];
  if (joint->mimic == SEPAX_NO_JOINT) {
    return true;
  }
  if (joint->mimic >= m->joints || joint->mimic == n) {
    return sepax_fail(
        error, SEPAX_ERROR_ARGUMENT,
        "joint %.60s: it follows itself or a joint that does not exist; name another joint",
        joint->name);
  }
  if (m->joint[joint->mimic].kind == SEPAX_JOINT_FIXED) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "joint %.60s: it follows %.60s, which is fixed; name the joint that leads",
                      joint->name, m->joint[joint->mimic].name);
  }
  return true;
}

static bool check_joint(sepax_mechanism *m, size_t n, sepax_error *error) {
  sepax_joint *joint = &m->joint[n];
  if (joint->parent >= m->links || joint->child >= m->links) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "joint %.60s: its links do not exist; mend the parent or the child",
                      joint->name);
  }
  sepax_link *child = &m->link[joint->child];
  if (joint->parent == joint->child) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "joint %.60s: link %.60s is its own parent; name another parent", joint->name,
                      child->name);
  }
  if (child->joint != SEPAX_NO_JOINT) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "link %.60s: two joints move it, %.60s and %.60s; leave one of them out",
                      child->name, m->joint[child->joint].name, joint->name);
  }
  sepax_error inner = {0};
  if (!sepax_pose_valid(&joint->origin, &inner) ||
      !sepax_pose_nearest(&joint->origin, NULL, &inner)) {
    return sepax_fail(error, inner.code, "joint %.60s: origin: %.200s", joint->name, inner.text);
  }
  if (joint->kind != SEPAX_JOINT_FIXED && !make_unit(joint->axis)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "joint %.60s: the axis has no direction; give three numbers, one of "
                      "them not 0",
                      joint->name);
  }
  if (!(joint->lower <= joint->upper)) {
    return sepax_fail(
        error, SEPAX_ERROR_ARGUMENT,
        "joint %.60s: the lower limit, %.9g, is above the upper, %.9g; swap or mend them",
        joint->name, joint->lower, joint->upper);
  }
  child->joint = n;
  return check_mimic(m, n, error);
}

/* --------------------------------------------------------------------- followers */

/* Joint n follows the joint that its leader follows; true where the leader leads. */
static bool skip_leader(sepax_mechanism *m, size_t n) {
  sepax_joint *joint = &m->joint[n];
  const sepax_joint *leader = &m->joint[joint->mimic];
  if (leader->mimic == SEPAX_NO_JOINT) {
    return true;
  }
  joint->offset += joint->factor * leader->offset;
  joint->factor *= leader->factor;
  joint->mimic = leader->mimic;
  return false;
}

/* Chains of joints that follow each other: each joint names the one that leads. Every round halves
 * the length of all chains at least, so what is left after 17 rounds is no chain of 65,536 joints
 * but a cycle. */
static bool find_leaders(sepax_mechanism *m, size_t *wrong, sepax_error *error) {
  enum { ROUNDS = 17 };
  bool left = true;
  size_t last = 0;
  for (int round = 0; round <= ROUNDS && left; round++) {
    left = false;
    for (size_t n = 0; n < m->joints; n++) {
      if (m->joint[n].mimic != SEPAX_NO_JOINT && !skip_leader(m, n)) {
        left = true;
        last = n;
      }
    }
  }
  if (left) {
    *wrong = last;
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "joint %.60s: the joints that it follows lead to a cycle; name a joint that "
                      "follows no other",
                      m->joint[last].name);
  }
  for (size_t n = 0; n < m->joints; n++) {
    const sepax_joint *joint = &m->joint[n];
    if (joint->mimic != SEPAX_NO_JOINT && (!isfinite(joint->factor) || !isfinite(joint->offset))) {
      *wrong = n;
      return sepax_fail(
          error, SEPAX_ERROR_ARGUMENT,
          "joint %.60s: the factor or the offset by which it follows is not finite; mend it",
          joint->name);
    }
  }
  return true;
}

/* -------------------------------------------------------------------------- tree */

/* first[link]: a joint below it, next[joint]: another one below the same link. */
typedef struct {
  size_t *first, *next;
} lists;

/* The joints in order, breadth first; how many are below the root. */
static size_t put_in_order(const sepax_mechanism *m, const lists *below) {
  size_t count = 0;
  size_t link = m->root;
  for (size_t done = 0;; done++) {
    for (size_t n = below->first[link]; n != SEPAX_NO_JOINT; n = below->next[n]) {
      m->order[count++] = n;
    }
    if (done == count) {
      return count;
    }
    link = m->joint[m->order[done]].child;
  }
}

/* From a link that no root reaches: up until it is on the cycle. */
static bool fail_cycle(const sepax_mechanism *m, size_t link, size_t *wrong, sepax_error *error) {
  for (size_t n = 0; n < m->links; n++) {
    link = m->joint[m->link[link].joint].parent;
  }
  *wrong = m->link[link].joint;
  const sepax_joint *joint = &m->joint[*wrong];
  return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                    "links %.60s and %.60s are on a cycle; leave joint %.60s out",
                    m->link[joint->parent].name, m->link[link].name, joint->name);
}

static bool find_root(sepax_mechanism *m, size_t *wrong, sepax_error *error) {
  size_t roots = 0;
  for (size_t n = 0; n < m->links; n++) {
    if (m->link[n].joint == SEPAX_NO_JOINT && roots++ == 0) {
      m->root = n;
    } else if (m->link[n].joint == SEPAX_NO_JOINT) {
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "links %.60s and %.60s: two roots; join one to the other",
                        m->link[m->root].name, m->link[n].name);
    }
  }
  return roots == 1 || fail_cycle(m, 0, wrong, error);
}

/* A link that the root does not reach; `mark` is overwritten. */
static size_t link_astray(const sepax_mechanism *m, size_t count, size_t *mark) {
  memset(mark, 0, m->links * sizeof *mark);
  mark[m->root] = 1;
  for (size_t n = 0; n < count; n++) {
    mark[m->joint[m->order[n]].child] = 1;
  }
  size_t link = 0;
  while (mark[link] != 0) {
    link++;
  }
  return link;
}

static bool order_joints(sepax_mechanism *m, size_t *wrong, sepax_error *error) {
  lists below = {sepax_allocate(m->links * sizeof *below.first),
                 sepax_allocate((m->joints + 1) * sizeof *below.next)};
  sepax_release(m->order);
  m->order = sepax_allocate((m->joints + 1) * sizeof *m->order);
  bool ok = below.first != NULL && below.next != NULL && m->order != NULL;
  if (ok) {
    for (size_t n = 0; n < m->links; n++) {
      below.first[n] = SEPAX_NO_JOINT;
    }
    for (size_t n = m->joints; n-- > 0;) {
      below.next[n] = below.first[m->joint[n].parent];
      below.first[m->joint[n].parent] = n;
    }
    size_t count = put_in_order(m, &below);
    ok = count == m->joints || fail_cycle(m, link_astray(m, count, below.first), wrong, error);
  } else {
    sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu joints", m->joints);
  }
  sepax_release(below.first);
  sepax_release(below.next);
  return ok;
}

bool sepax__mechanism_join(sepax_mechanism *m, size_t *wrong, sepax_error *error) {
  if (m->links == 0) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "the mechanism has no link; give at least one");
  }
  if (m->joints > SEPAX_JOINTS_MOST) {
    return sepax_fail(error, SEPAX_ERROR_LIMIT, "%zu joints are more than %d", m->joints,
                      SEPAX_JOINTS_MOST);
  }
  for (size_t n = 0; n < m->links; n++) {
    m->link[n].joint = SEPAX_NO_JOINT;
  }
  for (size_t n = 0; n < m->joints; n++) {
    if (!check_joint(m, n, error)) {
      *wrong = n;
      return false;
    }
  }
  return find_leaders(m, wrong, error) && find_root(m, wrong, error) &&
         order_joints(m, wrong, error);
}
