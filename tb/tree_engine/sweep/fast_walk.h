/* SPDX-License-Identifier: MIT */
// fast_walk.h - the walk of docs/reference/tree-engine.md made fast with AVX-512, as a rival of the
// engine.
#ifndef SWEEP_FAST_WALK_H
#define SWEEP_FAST_WALK_H

#include "sepax_tree.h"

#include <memory>
#include <utility>
#include <vector>

using TreePairs = std::vector<std::pair<uint32_t, uint32_t>>; /* triangles of A, of B */

/* Two trees of W = 18, which stay. It tests what the walk of the library tests, in another order,
 * and judges near pairs with sepax_exact_pairs. */
class FastWalk {
public:
  virtual ~FastWalk() = default;
  /* All pairs that collide. */
  virtual void ask(const sepax_tree_pose &pose, TreePairs &found) = 0;
};

/* nullptr: this processor lacks AVX-512 with VBMI and VNNI. */
std::unique_ptr<FastWalk> make_fast_walk(const sepax_tree *a, const sepax_tree *b);

#endif
