/* SPDX-License-Identifier: MIT */
/* bodies_unkind.h - scenes of distances that nobody chose kindly: many triangles are nearly equally
 * near, or the bodies touch, or their sizes have nothing to do with their distance. */
#ifndef BENCHMARK_BODIES_UNKIND_H
#define BENCHMARK_BODIES_UNKIND_H

#include "peer.h"

/* Poses of B, a row of the report. */
struct UnkindPoses {
  std::string scene, kind;
  Poses poses;
};

/* Two meshes and all rows in which they are compared. */
struct UnkindPair {
  std::shared_ptr<const sepax_soup> mesh[2];
  std::vector<UnkindPoses> poses;
};

/* The families of scenes. */
std::vector<std::string> unkind_names();

/* The pairs of a family. Fewer than 100 poses: meshes of 1,000 triangles instead of 100,000, for a
 * test that is quick. folder: the meshes of examples/five-axis. Empty: they are not there. */
std::vector<UnkindPair> make_unkind(const std::string &name, size_t poses, const char *folder);

#endif
