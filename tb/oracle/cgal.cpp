// SPDX-License-Identifier: MIT
// cgal.cpp - cross-check of the exact model against CGAL's exact predicates: seeded pairs of
// all families, degenerate triangles left out (CGAL asks for area).
//   cgal [PAIRS [WORD]]
#include "sepax_vectors.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangle_3.h>
#include <CGAL/intersections.h>

#include <cstdio>
#include <cstdlib>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

static Kernel::Triangle_3 triangle(const sepax_tri &t) {
  Kernel::Point_3 p[3];
  for (int i = 0; i < 3; i++) {
    p[i] = Kernel::Point_3(t.v[i].x, t.v[i].y, t.v[i].z);
  }
  return Kernel::Triangle_3(p[0], p[1], p[2]);
}

int main(int argc, char **argv) {
  unsigned long long wanted = argc > 1 ? strtoull(argv[1], nullptr, 10) : 1000000;
  int word = argc > 2 ? atoi(argv[2]) : 18;
  size_t families = 0;
  while (sepax_family_name(families) != nullptr) {
    families++;
  }
  sepax_random random = {(uint64_t)word};
  unsigned long long pairs = 0;
  unsigned long long different = 0;
  unsigned long long collisions = 0;
  for (size_t n = 0; pairs < wanted; n++) {
    sepax_pair pair = sepax_family_pair(n % families, word, &random);
    Kernel::Triangle_3 a = triangle(pair.a);
    Kernel::Triangle_3 b = triangle(pair.b);
    if (a.is_degenerate() || b.is_degenerate()) {
      continue;
    }
    bool exact = sepax_exact(&pair.a, &pair.b).collision;
    pairs++;
    collisions += exact;
    if (CGAL::do_intersect(a, b) != exact) {
      different++;
    }
  }
  std::printf(
      "CGAL %s, W = %d: %llu pairs without degenerate triangles, %llu collisions, %llu different\n",
      CGAL_VERSION_STR, word, pairs, collisions, different);
  return different == 0 && pairs > 0 ? 0 : 1;
}
