/* SPDX-License-Identifier: MIT */
/* pairs.c - chooses the pairs of links that are compared. */
#include "robot/robot.h"
#include "util/error.h"
#include "util/memory.h"

#include <string.h>

static bool joined(const sepax_mechanism *m, size_t a, size_t b) {
  const size_t up[2] = {m->link[a].joint, m->link[b].joint};
  return (up[0] != SEPAX_NO_JOINT && m->joint[up[0]].parent == b) ||
         (up[1] != SEPAX_NO_JOINT && m->joint[up[1]].parent == a);
}

/* The uppermost link that is joined to this one by fixed joints only. Links with the same uppermost
 * link never move against each other. */
static size_t held_by(const sepax_mechanism *m, size_t link) {
  while (m->link[link].joint != SEPAX_NO_JOINT &&
         m->joint[m->link[link].joint].kind == SEPAX_JOINT_FIXED) {
    link = m->joint[m->link[link].joint].parent;
  }
  return link;
}

/* Without an SRDF: true if the pair is left out. The reason is counted. */
static bool left_out(sepax_robot_pairs *pairs, const sepax_mechanism *m, size_t a, size_t b) {
  bool of_one_joint = joined(m, a, b);
  bool rigid = !of_one_joint && held_by(m, a) == held_by(m, b);
  pairs->joined += of_one_joint;
  pairs->rigid += rigid;
  return of_one_joint || rigid;
}

/* `compared`: of an SRDF, or NULL. `has_shape`: of each link. */
static void choose(sepax_robot_pairs *pairs, const sepax_robot *robot, const bool *compared,
                   const bool *has_shape) {
  const sepax_mechanism *m = &robot->mechanism;
  for (size_t a = 0; a < m->links; a++) {
    for (size_t b = a + 1; b < m->links; b++) {
      if (!has_shape[a] || !has_shape[b]) {
        continue;
      }
      bool off = compared != NULL ? !compared[a * m->links + b] : left_out(pairs, m, a, b);
      pairs->disabled += compared != NULL && off;
      if (!off) {
        pairs->pair[pairs->count][0] = a;
        pairs->pair[pairs->count++][1] = b;
      }
    }
  }
}

/* Which links have shapes, besides those that are marked; returns how many links are marked. */
static size_t find_shapes(const sepax_robot *robot, bool *has_shape) {
  size_t count = 0;
  for (size_t n = 0; n < robot->shapes; n++) {
    has_shape[robot->shape[n].link] = true;
  }
  for (size_t n = 0; n < robot->mechanism.links; n++) {
    count += has_shape[n];
  }
  return count;
}

/* Space for `compared` is there if an SRDF is given. */
static bool choose_by(sepax_robot_pairs *pairs, const sepax_robot *robot, const char *srdf,
                      bool *has_shape, bool *compared, sepax_error *error) {
  const size_t links = robot->mechanism.links;
  const size_t bodies = find_shapes(robot, has_shape);
  pairs->pair = sepax_allocate((bodies * (bodies + 1) / 2 + 1) * sizeof *pairs->pair);
  if (pairs->pair == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for pairs of %zu links", bodies);
  }
  if (compared != NULL) {
    memset(compared, true, links * links);
    if (!sepax_srdf_read(compared, &robot->mechanism, &pairs->srdf, srdf, error)) {
      return false;
    }
  }
  choose(pairs, robot, compared, has_shape);
  return true;
}

bool sepax__robot_pairs(sepax_robot_pairs *pairs, const sepax_robot *robot, const char *srdf,
                        size_t also, sepax_error *error) {
  const size_t links = robot->mechanism.links;
  bool *has_shape = sepax__zeroed(links, sizeof *has_shape);
  bool *compared = srdf != NULL ? sepax_allocate(links * links) : NULL;
  bool ok = false;
  *pairs = (sepax_robot_pairs){0};
  if (has_shape == NULL || (srdf != NULL && compared == NULL)) {
    sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for pairs of %zu links", links);
  } else {
    if (also < links) {
      has_shape[also] = true;
    }
    ok = choose_by(pairs, robot, srdf, has_shape, compared, error);
  }
  sepax_release(has_shape);
  sepax_release(compared);
  if (!ok) {
    sepax_robot_pairs_free(pairs);
  }
  return ok;
}

bool sepax_robot_pairs_choose(sepax_robot_pairs *pairs, const sepax_robot *robot, const char *srdf,
                              sepax_error *error) {
  return sepax__robot_pairs(pairs, robot, srdf, SIZE_MAX, error);
}

void sepax_robot_pairs_free(sepax_robot_pairs *pairs) {
  sepax_release(pairs->pair);
  sepax_srdf_free(&pairs->srdf);
  *pairs = (sepax_robot_pairs){0};
}
