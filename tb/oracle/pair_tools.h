/* SPDX-License-Identifier: MIT */
/* pair_tools.h - what the tests of pairs share: seeds and the properties of a pair. */
#ifndef PAIR_TOOLS_H
#define PAIR_TOOLS_H

#include "sepax_vectors.h"

size_t family_count(void);
/* The family of a name; their count where none has it. */
size_t family_number(const char *name);
sepax_random seeded(size_t family, int word);

/* The integers of a pair as text has them: 0 ... 17 coordinates, 18 ... 23 of the normals. */
enum { COORDINATES = 18, FIELDS = 24 };
int32_t *field(sepax_pair *pair, int i);
int32_t field_of(const sepax_pair *pair, int i);

bool equal(sepax_vec p, sepax_vec q);

/* The longest side of the AABB of a triangle. */
int64_t longest_side(const sepax_tri *t);

/* What a pair may be, found in exact integers. */
typedef bool property(const sepax_pair *pair, int word);

property legal, collides, coplanar, almost_coplanar, both_have_area, normals_parallel,
    same_orientation, one_common, two_common, three_common, same_order, vertex_on_face,
    vertex_on_edge, edge_on_edge, has_sliver, has_tiny, a_is_tiny, a_has_area, is_point, small,
    aabbs_overlap, at_least_value, at_greatest_value, at_corners, on_grid, tangent;

#endif
