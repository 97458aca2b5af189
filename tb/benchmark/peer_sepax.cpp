// SPDX-License-Identifier: MIT
// peer_sepax.cpp - libsepax: bodies in their poses.
#include "peer.h"

#include <cmath>

namespace {

Pairs listed(const sepax_pairs &found) {
  Pairs list;
  for (size_t k = 0; k < found.count; k++) {
    list.push_back({found.pair[k][0], found.pair[k][1]});
  }
  return list;
}

class Sepax : public Peer {
public:
  Sepax(const sepax_soup &a, const sepax_soup &b) {
    sepax_error error = {};
    const sepax_mesh mesh[2] = {mesh_of(a), mesh_of(b)};
    if (!sepax_body_new(&body[0], &mesh[0], nullptr, &error) ||
        !sepax_body_new(&body[1], &mesh[1], nullptr, &error)) {
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
    found.resize(is_distance(query) ? 0 : poses.size());
    away.resize(is_distance(query) ? poses.size() : 0);
    sepax_error error = {};
    sepax_distance_request how = {};
    how.size = sizeof how;
    how.relative = query == WITHIN ? TOLERANCE : 0;
    for (size_t n = 0; n < away.size(); n++) {
      if (!sepax_bodies_distance(body[0], nullptr, body[1], &poses[n], &how, &away[n], &error)) {
        stop(error.text);
      }
    }
    sepax_query what = {};
    what.size = sizeof what;
    what.most = query == FIRST ? 1 : 0;
    for (size_t n = 0; n < found.size(); n++) {
      if (!sepax_bodies_collide(body[0], nullptr, body[1], &poses[n], &what, &found[n], &error)) {
        stop(error.text);
      }
    }
  }

  Pairs pairs(size_t n) const override { return listed(found[n]); }

  double distance(size_t n) const override { return away[n].min_distance; }

  bool holds(size_t n, double exact) const override {
    const sepax_distance_result &r = away[n];
    const double low = std::nextafter(exact, 0);
    const double high = std::nextafter(exact, INFINITY);
    const bool narrow =
        r.most - r.least <= TOLERANCE * r.most || (r.least >= low && r.most <= high);
    return !r.ended && r.least <= high && r.most >= low && r.min_distance >= low &&
           r.min_distance <= std::nextafter(r.most, INFINITY) && narrow;
  }

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

/* Meshes that are asked once. */
class SepaxOnce : public Peer {
public:
  SepaxOnce(const sepax_soup &a, const sepax_soup &b) : mesh{mesh_of(a), mesh_of(b)} {}
  SepaxOnce(const SepaxOnce &) = delete;
  ~SepaxOnce() override { sepax_pairs_free(&found); }

  bool can(Query query) const override { return query == ALL; }

  void ask(Query, const Poses &poses) override {
    sepax_error error = {};
    sepax_search how = {};
    how.size = sizeof how;
    how.threads = 1;
    sepax_pairs_free(&found);
    if (!sepax_meshes_collide(&mesh[0], nullptr, &mesh[1], &poses.at(0), &how, &found, &error)) {
      stop(error.text);
    }
  }

  Pairs pairs(size_t) const override { return listed(found); }
  double distance(size_t) const override { return 0; }

private:
  const sepax_mesh mesh[2];
  sepax_pairs found = {};
};

} // namespace

std::unique_ptr<Peer> make_sepax(const sepax_soup &a, const sepax_soup &b) {
  return std::make_unique<Sepax>(a, b);
}

std::unique_ptr<Peer> make_sepax_once(const sepax_soup &a, const sepax_soup &b) {
  return std::make_unique<SepaxOnce>(a, b);
}
