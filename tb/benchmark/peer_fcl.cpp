// SPDX-License-Identifier: MIT
// peer_fcl.cpp - FCL: hierarchies of oriented boxes (OBB) for collisions, of rectangle swept
// spheres (RSS) for distances; its others are slower.
#include "peer_tree.h"

#if __has_include(<fcl/fcl.h>)
#include <fcl/fcl.h>

namespace {

fcl::Transform3d transform_of(const sepax_pose &pose) {
  fcl::Transform3d t = fcl::Transform3d::Identity();
  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 3; k++) {
      t.linear()(i, k) = pose.rotation[i][k];
    }
    t.translation()[i] = pose.translation[i];
  }
  return t;
}

class Fcl : public Peer {
public:
  Fcl(const sepax_soup &a, const sepax_soup &b) : mesh{a, b} {}

  bool can(Query) const override { return true; }

  void ask(Query query, const Poses &poses) override {
    const fcl::Transform3d still = fcl::Transform3d::Identity();
    found.clear();
    found.resize(poses.size());
    away.resize(poses.size());
    for (int k = 0; k < 2; k++) {
      if (is_distance(query) && !swept[k]) {
        swept[k] = tree_of<fcl::BVHModel<fcl::RSSd>, int>(mesh[k]);
      } else if (!is_distance(query) && !boxes[k]) {
        boxes[k] = tree_of<fcl::BVHModel<fcl::OBBd>, int>(mesh[k]);
      }
    }
    for (size_t n = 0; n < poses.size(); n++) {
      const fcl::Transform3d moved = transform_of(poses[n]);
      if (is_distance(query)) {
        fcl::DistanceResultd result;
        fcl::DistanceRequestd request(true, false, query == WITHIN ? TOLERANCE : 0, 0);
        away[n] = fcl::distance(swept[0].get(), still, swept[1].get(), moved, request, result);
      } else {
        fcl::CollisionRequestd request(query == FIRST ? 1 : SIZE_MAX, false);
        fcl::collide(boxes[0].get(), still, boxes[1].get(), moved, request, found[n]);
      }
    }
  }

  Pairs pairs(size_t n) const override { return contacts_of(found[n]); }

  double distance(size_t n) const override { return away[n]; }

private:
  std::unique_ptr<fcl::BVHModel<fcl::OBBd>> boxes[2];
  std::unique_ptr<fcl::BVHModel<fcl::RSSd>> swept[2];
  const sepax_soup mesh[2];
  std::vector<fcl::CollisionResultd> found;
  std::vector<double> away;
};

} // namespace

std::unique_ptr<Peer> make_fcl(const sepax_soup &a, const sepax_soup &b) {
  return std::make_unique<Fcl>(a, b);
}
#else
std::unique_ptr<Peer> make_fcl(const sepax_soup &, const sepax_soup &) { return nullptr; }
#endif
