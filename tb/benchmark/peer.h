/* SPDX-License-Identifier: MIT */
/* peer.h - what libraries are asked about two bodies, one way for all of them. */
#ifndef BENCHMARK_PEER_H
#define BENCHMARK_PEER_H

#include "sepax_models.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

/* WITHIN: the distance within a relative TOLERANCE. */
enum Query { FIRST, ALL, DISTANCE, WITHIN, QUERIES };
constexpr double TOLERANCE = 1e-6;
inline bool is_distance(int query) { return query == DISTANCE || query == WITHIN; }

using Pairs = std::vector<std::array<size_t, 2>>;
using Poses = std::vector<sepax_pose>;

/* Two bodies of one library, its trees built. */
class Peer {
public:
  virtual ~Peer() = default;
  virtual bool can(Query query) const { return !is_distance(query); }
  /* A as it stands against B in each pose; the answers stay until the next question. */
  virtual void ask(Query query, const Poses &poses) = 0;
  /* What ask(FIRST), ask(ALL) found in pose n. */
  virtual Pairs pairs(size_t n) const = 0;
  /* Of ask(DISTANCE), ask(WITHIN); 0 or less for a collision. */
  virtual double distance(size_t) const { return 0; }
  /* Whether the interval of pose n holds the exact distance, which is right to one unit in the last
   * place, and is as narrow as it should be. Libraries without intervals are right. */
  virtual bool holds(size_t, double) const { return true; }
};

/* nullptr: the library's headers are not here. */
using Maker = std::unique_ptr<Peer> (*)(const sepax_soup &a, const sepax_soup &b);
std::unique_ptr<Peer> make_sepax(const sepax_soup &a, const sepax_soup &b);
/* All pairs without a tree; the meshes stay. */
std::unique_ptr<Peer> make_sepax_once(const sepax_soup &a, const sepax_soup &b);
std::unique_ptr<Peer> make_fcl(const sepax_soup &a, const sepax_soup &b);
std::unique_ptr<Peer> make_coal(const sepax_soup &a, const sepax_soup &b);
std::unique_ptr<Peer> make_cgal(const sepax_soup &a, const sepax_soup &b);
std::unique_ptr<Peer> make_embree(const sepax_soup &a, const sepax_soup &b);

inline sepax_mesh mesh_of(const sepax_soup &soup) {
  sepax_mesh mesh = {};
  mesh.size = sizeof mesh;
  mesh.vertex = soup.facet;
  mesh.triangles = soup.count;
  return mesh;
}

/* Two meshes, and B's poses: kinds in turn from far away to deep inside. */
struct Scene {
  std::string name;
  sepax_soup mesh[2] = {{nullptr, 0, nullptr}, {nullptr, 0, nullptr}};
  Poses poses, contact; /* contact: the poses of a bar of its own, or none */
  ~Scene();
};

constexpr int KINDS = 5;
extern const char *const kind_names[KINDS];

std::vector<std::string> scene_names();
/* folder: where ktoolcav.stl and ktoolcor.stl are. nullptr: a mesh is not there. */
std::unique_ptr<Scene> make_scene(const std::string &name, size_t poses, const char *folder);

[[noreturn]] void stop(const std::string &why);

#endif
