// peer_sepax.cpp - libsepax: bodies in their poses.
#include "peer.h"

namespace {

class Sepax : public Peer {
public:
  Sepax(const sepax_mesh &a, const sepax_mesh &b) {
    sepax_error error = {""};
    if (!sepax_body_new(&body[0], &a, &error) || !sepax_body_new(&body[1], &b, &error)) {
      stop(error.text);
    }
  }
  Sepax(const Sepax &) = delete;
  ~Sepax() override {
    forget();
    sepax_body_free(body[0]);
    sepax_body_free(body[1]);
  }

  bool can(Query) const override { return true; }

  void ask(Query query, const Poses &poses) override {
    forget();
    found.resize(query == DISTANCE ? 0 : poses.size());
    away.resize(query == DISTANCE ? poses.size() : 0);
    sepax_error error = {""};
    for (size_t n = 0; n < away.size(); n++) {
      if (!sepax_bodies_distance(body[0], nullptr, body[1], &poses[n], nullptr, &away[n], &error)) {
        stop(error.text);
      }
    }
    sepax_query what = {};
    what.most = query == FIRST ? 1 : 0;
    for (size_t n = 0; n < found.size(); n++) {
      if (!sepax_bodies_collide(body[0], nullptr, body[1], &poses[n], &what, &found[n], &error)) {
        stop(error.text);
      }
    }
  }

  Pairs pairs(size_t n) const override {
    Pairs list;
    for (size_t k = 0; k < found[n].count; k++) {
      list.push_back({found[n].pair[k][0], found[n].pair[k][1]});
    }
    return list;
  }

  double distance(size_t n) const override { return away[n].min_distance; }

private:
  void forget() {
    for (sepax_pairs &list : found) {
      sepax_pairs_free(&list);
    }
    found.clear();
  }

  sepax_body *body[2] = {nullptr, nullptr};
  std::vector<sepax_pairs> found;
  std::vector<sepax_distance_result> away;
};

} // namespace

std::unique_ptr<Peer> make_sepax(const sepax_mesh &a, const sepax_mesh &b) {
  return std::make_unique<Sepax>(a, b);
}
