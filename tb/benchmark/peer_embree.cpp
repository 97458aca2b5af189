// SPDX-License-Identifier: MIT
// peer_embree.cpp - Embree's rtcCollide: user geometry of triangles. It takes no pose: the
// smaller body's triangles are posed and its tree is refitted in each pose in which the bodies'
// AABBs overlap. A pair of triangles that it reports is judged by Guigue's and Devillers's test in
// doubles. rtcCollide cannot be ended; no pair is judged after the first hit.
#include "peer.h"

#if __has_include(<embree3/rtcore.h>)
#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>

namespace {

struct Point {
  double c[3];
};

struct Corners {
  Point v[3];
};

Point operator-(const Point &p, const Point &q) {
  return {{p.c[0] - q.c[0], p.c[1] - q.c[1], p.c[2] - q.c[2]}};
}

Point cross(const Point &p, const Point &q) {
  return {{p.c[1] * q.c[2] - p.c[2] * q.c[1], p.c[2] * q.c[0] - p.c[0] * q.c[2],
           p.c[0] * q.c[1] - p.c[1] * q.c[0]}};
}

double dot(const Point &p, const Point &q) {
  return p.c[0] * q.c[0] + p.c[1] * q.c[1] + p.c[2] * q.c[2];
}

/* ---------------------------------------------------- two triangles (Guigue, Devillers 2003) */

/* Which vertex is alone on its side of a plane, and whether that is the negative side; from the
 * three signs. vertex 3: all are in the plane. */
struct Side {
  int vertex;
  bool turned;
};

Side side_of(const double s[3]) {
  if (s[0] > 0) {
    return s[1] > 0 ? Side{2, true} : s[2] > 0 ? Side{1, true} : Side{0, false};
  }
  if (s[0] < 0) {
    return s[1] < 0 ? Side{2, false} : s[2] < 0 ? Side{1, false} : Side{0, true};
  }
  if (s[1] < 0) {
    return s[2] >= 0 ? Side{1, true} : Side{0, false};
  }
  if (s[1] > 0) {
    return s[2] > 0 ? Side{0, true} : Side{1, false};
  }
  return s[2] > 0 ? Side{2, false} : s[2] < 0 ? Side{2, true} : Side{3, false};
}

/* Distances of a's vertices from b's plane; false if all are on one side. */
bool crosses_plane(const Corners &a, const Corners &b, double s[3]) {
  const Point normal = cross(b.v[1] - b.v[0], b.v[2] - b.v[0]);
  for (int k = 0; k < 3; k++) {
    s[k] = dot(a.v[k] - b.v[0], normal);
  }
  return !((s[0] > 0 && s[1] > 0 && s[2] > 0) || (s[0] < 0 && s[1] < 0 && s[2] < 0));
}

double orient3d(const Point &p, const Point &q, const Point &r, const Point &s) {
  return dot(s - p, cross(q - p, r - p));
}

double orient2d(const Point &p, const Point &q, const Point &r, int i, int j) {
  return (q.c[i] - p.c[i]) * (r.c[j] - p.c[j]) - (q.c[j] - p.c[j]) * (r.c[i] - p.c[i]);
}

/* In the plane with normal n: no edge of either has the other triangle beyond it. */
bool overlap_in_plane(const Corners &a, const Corners &b, const Point &n) {
  const int drop = std::fabs(n.c[0]) > std::fabs(n.c[1])
                       ? (std::fabs(n.c[0]) > std::fabs(n.c[2]) ? 0 : 2)
                       : (std::fabs(n.c[1]) > std::fabs(n.c[2]) ? 1 : 2);
  const int i = (drop + 1) % 3;
  const int j = (drop + 2) % 3;
  for (int way = 0; way < 2; way++) {
    const Corners &own = way == 0 ? a : b;
    const Corners &other = way == 0 ? b : a;
    const double turn = orient2d(own.v[0], own.v[1], own.v[2], i, j);
    for (int k = 0; k < 3; k++) {
      bool beyond = true;
      for (int m = 0; m < 3; m++) {
        beyond = beyond && turn * orient2d(own.v[k], own.v[(k + 1) % 3], other.v[m], i, j) < 0;
      }
      if (beyond) {
        return false;
      }
    }
  }
  return true;
}

bool collide(const Corners &a, const Corners &b) {
  double of_a[3];
  double of_b[3];
  if (!crosses_plane(a, b, of_a) || !crosses_plane(b, a, of_b)) {
    return false;
  }
  const Side side_a = side_of(of_a);
  if (side_a.vertex == 3) {
    return overlap_in_plane(a, b, cross(b.v[1] - b.v[0], b.v[2] - b.v[0]));
  }
  const int order[3] = {0, side_a.turned ? 2 : 1, side_a.turned ? 1 : 2};
  const double turned[3] = {of_b[0], of_b[order[1]], of_b[order[2]]};
  const Side side_b = side_of(turned);
  if (side_b.vertex == 3) {
    return overlap_in_plane(a, b, cross(a.v[1] - a.v[0], a.v[2] - a.v[0]));
  }
  const Point *p[3];
  const Point *q[3];
  for (int k = 0; k < 3; k++) {
    p[k] = &a.v[(side_a.vertex + k) % 3];
    q[k] = &b.v[order[(side_b.vertex + k) % 3]];
  }
  if (side_b.turned) {
    std::swap(p[1], p[2]);
  }
  return orient3d(*p[1], *q[0], *p[0], *q[1]) <= 0 && orient3d(*p[0], *q[0], *p[2], *q[2]) <= 0;
}

/* ------------------------------------------------------------------------- the peer */

std::vector<Corners> corners_of(const sepax_soup &mesh) {
  std::vector<Corners> list(mesh.count);
  for (size_t n = 0; n < mesh.count; n++) {
    for (int k = 0; k < 9; k++) {
      list[n].v[k / 3].c[k % 3] = mesh.facet[n].v[k / 3][k % 3];
    }
  }
  return list;
}

void find_bounds(const RTCBoundsFunctionArguments *arguments) {
  const auto &v = static_cast<const Corners *>(arguments->geometryUserPtr)[arguments->primID].v;
  float low[3];
  float high[3];
  for (int i = 0; i < 3; i++) {
    low[i] = std::nextafterf(float(std::min({v[0].c[i], v[1].c[i], v[2].c[i]})), -INFINITY);
    high[i] = std::nextafterf(float(std::max({v[0].c[i], v[1].c[i], v[2].c[i]})), INFINITY);
  }
  *arguments->bounds_o = {low[0], low[1], low[2], 0, high[0], high[1], high[2], 0};
}

class Embree : public Peer {
public:
  Embree(const sepax_soup &a, const sepax_soup &b)
      : swapped(a.count < b.count), device(rtcNewDevice("threads=1")) {
    const sepax_soup *mesh[2] = {swapped ? &b : &a, swapped ? &a : &b};
    for (int k = 0; k < 2; k++) {
      still[k] = corners_of(*mesh[k]);
      scene[k] = rtcNewScene(device);
      geometry[k] = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
      if (k == 1) {
        posed = still[1];
        rtcSetSceneFlags(scene[k], RTC_SCENE_FLAG_DYNAMIC);
        rtcSetSceneBuildQuality(scene[k], RTC_BUILD_QUALITY_LOW); /* another one builds anew */
        rtcSetGeometryBuildQuality(geometry[k], RTC_BUILD_QUALITY_REFIT);
      }
      rtcSetGeometryUserPrimitiveCount(geometry[k], unsigned(mesh[k]->count));
      rtcSetGeometryUserData(geometry[k], k == 0 ? still[0].data() : posed.data());
      rtcSetGeometryBoundsFunction(geometry[k], find_bounds, nullptr);
      rtcCommitGeometry(geometry[k]);
      rtcAttachGeometry(scene[k], geometry[k]);
      rtcCommitScene(scene[k]);
      rtcGetSceneBounds(scene[k], &bounds[k]);
    }
  }
  Embree(const Embree &) = delete;
  ~Embree() override {
    for (int k = 0; k < 2; k++) {
      rtcReleaseGeometry(geometry[k]);
      rtcReleaseScene(scene[k]);
    }
    rtcReleaseDevice(device);
  }

  void ask(Query query, const Poses &poses) override {
    found.clear();
    found.resize(poses.size());
    for (size_t n = 0; n < poses.size(); n++) {
      if (!boxes_overlap(poses[n])) {
        continue;
      }
      for (size_t k = 0; k < posed.size(); k++) {
        for (int v = 0; v < 3; v++) {
          posed[k].v[v] = placed(still[1][k].v[v], poses[n]);
        }
      }
      rtcCommitGeometry(geometry[1]);
      rtcCommitScene(scene[1]);
      list = &found[n];
      first = query == FIRST;
      rtcCollide(scene[0], scene[1], judge, this);
    }
  }

  Pairs pairs(size_t n) const override { return found[n]; }

private:
  /* A point of the smaller body in the larger one's coordinates. */
  Point placed(const Point &p, const sepax_pose &pose) const {
    Point r;
    for (int i = 0; i < 3; i++) {
      r.c[i] = swapped ? 0 : pose.translation[i];
      for (int m = 0; m < 3; m++) {
        r.c[i] += swapped ? pose.rotation[m][i] * (p.c[m] - pose.translation[m])
                          : pose.rotation[i][m] * p.c[m];
      }
    }
    return r;
  }

  bool boxes_overlap(const sepax_pose &pose) const {
    double low[3] = {INFINITY, INFINITY, INFINITY};
    double high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (int k = 0; k < 8; k++) {
      const RTCBounds &b = bounds[1];
      const Point corner = placed({{k & 1 ? b.upper_x : b.lower_x, k & 2 ? b.upper_y : b.lower_y,
                                    k & 4 ? b.upper_z : b.lower_z}},
                                  pose);
      for (int i = 0; i < 3; i++) {
        low[i] = std::min(low[i], corner.c[i]);
        high[i] = std::max(high[i], corner.c[i]);
      }
    }
    const RTCBounds &b = bounds[0];
    return low[0] <= b.upper_x && high[0] >= b.lower_x && low[1] <= b.upper_y &&
           high[1] >= b.lower_y && low[2] <= b.upper_z && high[2] >= b.lower_z;
  }

  static void judge(void *own, RTCCollision *collision, unsigned count) {
    auto *self = static_cast<Embree *>(own);
    for (unsigned n = 0; n < count && !(self->first && !self->list->empty()); n++) {
      const size_t i = collision[n].primID0;
      const size_t j = collision[n].primID1;
      if (collide(self->still[0][i], self->posed[j])) {
        self->list->push_back({self->swapped ? j : i, self->swapped ? i : j});
      }
    }
  }

  const bool swapped; /* the larger body, which stands still, is B */
  bool first = false;
  RTCDevice device;
  RTCScene scene[2];
  RTCGeometry geometry[2];
  RTCBounds bounds[2];
  std::vector<Corners> still[2], posed;
  std::vector<Pairs> found;
  Pairs *list = nullptr;
};

} // namespace

std::unique_ptr<Peer> make_embree(const sepax_soup &a, const sepax_soup &b) {
  return std::make_unique<Embree>(a, b);
}
#else
std::unique_ptr<Peer> make_embree(const sepax_soup &, const sepax_soup &) { return nullptr; }
#endif
