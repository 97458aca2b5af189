// SPDX-License-Identifier: MIT
// peer_coal.cpp - Coal: hierarchies of oriented boxes and rectangle swept spheres (OBBRSS), its
// boxes for collisions, its spheres for distances.
#include "peer_tree.h"

#if __has_include(<coal/distance.h>) && __has_include(<Eigen/Core>)
#include <coal/BVH/BVH_model.h>
#include <coal/collision.h>
#include <coal/distance.h>

namespace {

using Model = coal::BVHModel<coal::OBBRSS>;

coal::Transform3s transform_of(const sepax_pose &pose) {
  coal::Matrix3s rotation;
  coal::Vec3s translation;
  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 3; k++) {
      rotation(i, k) = pose.rotation[i][k];
    }
    translation[i] = pose.translation[i];
  }
  return coal::Transform3s(rotation, translation);
}

class Coal : public Peer {
public:
  Coal(const sepax_soup &a, const sepax_soup &b)
      : model{tree_of<Model, unsigned>(a), tree_of<Model, unsigned>(b)} {}

  bool can(Query) const override { return true; }

  void ask(Query query, const Poses &poses) override {
    const coal::Transform3s still;
    const bool measured = is_distance(query);
    found.clear();
    found.resize(measured ? 0 : poses.size());
    away.resize(measured ? poses.size() : 0);
    for (size_t n = 0; n < poses.size(); n++) {
      const coal::Transform3s moved = transform_of(poses[n]);
      if (measured) {
        coal::DistanceResult result;
        coal::DistanceRequest request(true, false, query == WITHIN ? TOLERANCE : 0, 0);
        away[n] = coal::distance(model[0].get(), still, model[1].get(), moved, request, result);
      } else {
        coal::CollisionRequest request(coal::NO_REQUEST, query == FIRST ? 1 : SIZE_MAX);
        coal::collide(model[0].get(), still, model[1].get(), moved, request, found[n]);
      }
    }
  }

  Pairs pairs(size_t n) const override { return contacts_of(found[n]); }

  double distance(size_t n) const override { return away[n]; }

private:
  std::unique_ptr<Model> model[2];
  std::vector<coal::CollisionResult> found;
  std::vector<double> away;
};

} // namespace

std::unique_ptr<Peer> make_coal(const sepax_soup &a, const sepax_soup &b) {
  return std::make_unique<Coal>(a, b);
}
#else
std::unique_ptr<Peer> make_coal(const sepax_soup &, const sepax_soup &) { return nullptr; }
#endif
