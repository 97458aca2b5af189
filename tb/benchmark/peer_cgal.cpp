// SPDX-License-Identifier: MIT
// peer_cgal.cpp - CGAL: a tree of AABBs over the triangles of the larger body, asked with each
// triangle of the other one, posed; predicates are exact (EPICK), posed coordinates rounded.
#include "peer.h"

#if __has_include(<CGAL/AABB_tree.h>)
#define CGAL_NDEBUG
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

/* A rotation and what follows it, or their inverse. */
class Motion {
public:
  Motion(const sepax_pose &pose, bool back) {
    for (int i = 0; i < 3; i++) {
      shift[i] = back ? 0 : pose.translation[i];
      for (int k = 0; k < 3; k++) {
        turn[i][k] = back ? pose.rotation[k][i] : pose.rotation[i][k];
        shift[i] -= back ? pose.rotation[k][i] * pose.translation[k] : 0;
      }
    }
  }
  Kernel::Point_3 operator()(const Kernel::Point_3 &p) const {
    return {turn[0][0] * p.x() + turn[0][1] * p.y() + turn[0][2] * p.z() + shift[0],
            turn[1][0] * p.x() + turn[1][1] * p.y() + turn[1][2] * p.z() + shift[1],
            turn[2][0] * p.x() + turn[2][1] * p.y() + turn[2][2] * p.z() + shift[2]};
  }
  Kernel::Triangle_3 operator()(const Kernel::Triangle_3 &t) const {
    return {(*this)(t[0]), (*this)(t[1]), (*this)(t[2])};
  }
  CGAL::Bbox_3 operator()(const CGAL::Bbox_3 &b) const {
    CGAL::Bbox_3 all;
    for (int k = 0; k < 8; k++) {
      all += (*this)(Kernel::Point_3(k & 1 ? b.xmax() : b.xmin(), k & 2 ? b.ymax() : b.ymin(),
                                     k & 4 ? b.zmax() : b.zmin()))
                 .bbox();
    }
    return all;
  }

private:
  double turn[3][3], shift[3];
};

class Cgal : public Peer {
public:
  Cgal(const sepax_soup &a, const sepax_soup &b) : swapped(b.count > a.count) {
    const sepax_soup *mesh[2] = {swapped ? &b : &a, swapped ? &a : &b};
    for (int k = 0; k < 2; k++) {
      for (size_t n = 0; n < mesh[k]->count; n++) {
        const auto &v = mesh[k]->facet[n].v;
        triangle[k].emplace_back(Kernel::Point_3(v[0][0], v[0][1], v[0][2]),
                                 Kernel::Point_3(v[1][0], v[1][1], v[1][2]),
                                 Kernel::Point_3(v[2][0], v[2][1], v[2][2]));
        if (k == 1) {
          whole += triangle[k].back().bbox();
        }
      }
    }
    tree.insert(triangle[0].cbegin(), triangle[0].cend());
    tree.build();
  }

  void ask(Query query, const Poses &poses) override {
    found.clear();
    found.resize(poses.size());
    for (size_t n = 0; n < poses.size(); n++) {
      const Motion motion(poses[n], swapped);
      if (CGAL::do_overlap(motion(whole), tree.bbox())) {
        search(query, motion, found[n]);
      }
    }
  }

  Pairs pairs(size_t n) const override { return found[n]; }

private:
  void search(Query query, const Motion &motion, Pairs &list) {
    const CGAL::Bbox_3 all = tree.bbox();
    for (size_t j = 0; j < triangle[1].size(); j++) {
      const Kernel::Triangle_3 posed = motion(triangle[1][j]);
      if (!CGAL::do_overlap(posed.bbox(), all)) {
        continue;
      }
      if (query == FIRST) {
        if (auto any = tree.any_intersected_primitive(posed)) {
          add(list, *any, j);
          return;
        }
        continue;
      }
      hits.clear();
      tree.all_intersected_primitives(posed, std::back_inserter(hits));
      for (const auto &hit : hits) {
        add(list, hit, j);
      }
    }
  }

  void add(Pairs &list, Triangles::const_iterator hit, size_t j) const {
    const size_t i = static_cast<size_t>(hit - triangle[0].cbegin());
    list.push_back({swapped ? j : i, swapped ? i : j});
  }

  const bool swapped; /* the tree is B's */
  Triangles triangle[2];
  CGAL::Bbox_3 whole; /* of triangle[1] */
  Tree tree;
  std::vector<Pairs> found;
  std::vector<Primitive::Id> hits;
};

} // namespace

std::unique_ptr<Peer> make_cgal(const sepax_soup &a, const sepax_soup &b) {
  return std::make_unique<Cgal>(a, b);
}
#else
std::unique_ptr<Peer> make_cgal(const sepax_soup &, const sepax_soup &) { return nullptr; }
#endif
