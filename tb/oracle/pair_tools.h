/* pair_tools.h - what the tests of pairs share: seeds and the properties of a pair. */
#ifndef PAIR_TOOLS_H
#define PAIR_TOOLS_H

#include "sepax_vectors.h"

#define LENGTH(array) (sizeof(array) / sizeof *(array))

size_t family_count(void);
sepax_random seeded(size_t family, int word);

/* Vertex 0 ... 5: three of A, three of B. */
sepax_vec vertex(const sepax_pair *pair, int i);
bool equal(sepax_vec p, sepax_vec q);

/* What a pair may be, found in exact integers. */
typedef bool property(const sepax_pair *pair, int word);

property legal, collides, coplanar, almost_coplanar, both_have_area, normals_parallel,
    same_orientation, one_common, two_common, three_common, same_order, vertex_on_face,
    vertex_on_edge, edge_on_edge, has_sliver, has_tiny, a_is_tiny, a_has_area, is_point, small,
    aabbs_overlap, at_least_value, at_greatest_value, at_corners, on_grid, tangent;

#endif
