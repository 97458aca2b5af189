/* SPDX-License-Identifier: MIT */
/* chain.c - the joints between two links. */
#include "sepax_mechanism.h"
#include "util/error.h"

#include <stdlib.h>

static size_t depth_of(const sepax_mechanism *m, size_t link) {
  size_t depth = 0;
  while (m->link[link].joint != SEPAX_NO_JOINT) {
    link = m->joint[m->link[link].joint].parent;
    depth++;
  }
  return depth;
}

static size_t parent_of(const sepax_mechanism *m, size_t link) {
  return m->joint[m->link[link].joint].parent;
}

bool sepax_chain_find(sepax_chain *chain, const sepax_mechanism *m, size_t a, size_t b,
                      sepax_error *error) {
  size_t depth[2] = {depth_of(m, a), depth_of(m, b)};
  size_t top[2] = {a, b};
  size_t count[2] = {0, 0};
  while (top[0] != top[1]) {
    int lower = depth[1] > depth[0];
    top[lower] = parent_of(m, top[lower]);
    depth[lower]--;
    count[lower]++;
  }
  *chain = (sepax_chain){.count = count[0] + count[1], .up = count[0], .top = top[0]};
  chain->joint = sepax_allocate((chain->count + 1) * sizeof *chain->joint);
  if (chain->joint == NULL) {
    *chain = (sepax_chain){0};
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for a chain of %zu joints",
                      count[0] + count[1]);
  }
  for (size_t n = 0; n < chain->up; n++, a = parent_of(m, a)) {
    chain->joint[n] = m->link[a].joint;
  }
  for (size_t n = chain->count; n-- > chain->up; b = parent_of(m, b)) {
    chain->joint[n] = m->link[b].joint;
  }
  return true;
}

void sepax_chain_free(sepax_chain *chain) {
  sepax_release(chain->joint);
  *chain = (sepax_chain){0};
}
