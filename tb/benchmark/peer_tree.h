/* SPDX-License-Identifier: MIT */
/* peer_tree.h - what FCL and Coal, which grew out of it, have in common. */
#ifndef BENCHMARK_PEER_TREE_H
#define BENCHMARK_PEER_TREE_H

#include "peer.h"

/* A tree of a mesh; Count: the type of its numbers of triangles and vertices. */
template <typename Model, typename Count> std::unique_ptr<Model> tree_of(const sepax_soup &mesh) {
  auto model = std::make_unique<Model>();
  model->beginModel(static_cast<Count>(mesh.count), static_cast<Count>(3 * mesh.count));
  for (size_t n = 0; n < mesh.count; n++) {
    const auto &v = mesh.facet[n].v;
    model->addTriangle({v[0][0], v[0][1], v[0][2]}, {v[1][0], v[1][1], v[1][2]},
                       {v[2][0], v[2][1], v[2][2]});
  }
  model->endModel();
  return model;
}

/* The pairs of triangles of a result. */
template <typename Result> Pairs contacts_of(const Result &found) {
  Pairs list;
  for (size_t k = 0; k < found.numContacts(); k++) {
    const auto &contact = found.getContact(k);
    list.push_back({static_cast<size_t>(contact.b1), static_cast<size_t>(contact.b2)});
  }
  return list;
}

#endif
