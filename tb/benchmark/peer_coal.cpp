// SPDX-License-Identifier: MIT
// peer_coal.cpp - Coal: hierarchies of oriented boxes and rectangle swept spheres (OBBRSS), its
// boxes for collisions, its spheres for distances.
#include "peer.h"

#if __has_include(<coal/distance.h>) && __has_include(<Eigen/Core>)
#include <coal/BVH/BVH_model.h>
#include <coal/collision.h>
#include <coal/distance.h>

namespace {

using Model = coal::BVHModel<coal::OBBRSS>;

std::unique_ptr<Model> model_of(const sepax_soup &mesh) {
  auto model = std::make_unique<Model>();
  model->beginModel(static_cast<unsigned>(mesh.count), static_cast<unsigned>(3 * mesh.count));
  for (size_t n = 0; n < mesh.count; n++) {
    const auto &v = mesh.facet[n].v;
    model->addTriangle({v[0][0], v[0][1], v[0][2]}, {v[1][0], v[1][1], v[1][2]},
                       {v[2][0], v[2][1], v[2][2]});
  }
  model->endModel();
  return model;
}

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
  Coal(const sepax_soup &a, const sepax_soup &b) : model{model_of(a), model_of(b)} {}

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

  Pairs pairs(size_t n) const override {
    Pairs list;
    for (size_t k = 0; k < found[n].numContacts(); k++) {
      const coal::Contact &contact = found[n].getContact(k);
      list.push_back({static_cast<size_t>(contact.b1), static_cast<size_t>(contact.b2)});
    }
    return list;
  }

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
