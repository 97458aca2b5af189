// SPDX-License-Identifier: MIT
#include "bodies_unkind.h"

#include "sepax_vectors.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace {

using Mesh = std::shared_ptr<const sepax_soup>;

struct Point {
  double x, y, z;
};

Mesh owned(const sepax_soup &soup) {
  return Mesh(new sepax_soup(soup), [](sepax_soup *mesh) {
    sepax_soup_free(mesh);
    delete mesh;
  });
}

Mesh mesh_of_list(const std::vector<sepax_facet> &list) {
  sepax_soup soup = {nullptr, list.size(), nullptr};
  soup.facet = static_cast<sepax_facet *>(sepax_allocate(list.size() * sizeof list[0]));
  if (soup.facet == nullptr) {
    stop("no memory for a mesh");
  }
  std::copy(list.begin(), list.end(), soup.facet);
  return owned(soup);
}

Mesh sample(const char *shape, size_t count, double size) {
  const double at[3] = {0, 0, 0};
  sepax_soup soup = {};
  sepax_error error = {};
  if (!sepax_sample(&soup, shape, count, at, size, &error)) {
    stop(error.text);
  }
  return owned(soup);
}

/* A grid of side x side cells, two triangles each, over the unit square. */
void add_grid(std::vector<sepax_facet> &list, size_t side,
              const std::function<Point(double, double)> &place) {
  auto at = [&](size_t i, size_t j) {
    return place(double(i) / double(side) - 0.5, double(j) / double(side) - 0.5);
  };
  for (size_t i = 0; i < side; i++) {
    for (size_t j = 0; j < side; j++) {
      const Point p = at(i, j);
      const Point q = at(i + 1, j);
      const Point r = at(i + 1, j + 1);
      const Point s = at(i, j + 1);
      list.push_back({{{p.x, p.y, p.z}, {q.x, q.y, q.z}, {r.x, r.y, r.z}}});
      list.push_back({{{p.x, p.y, p.z}, {r.x, r.y, r.z}, {s.x, s.y, s.z}}});
    }
  }
}

Mesh sheet(size_t count, const std::function<Point(double, double)> &place) {
  std::vector<sepax_facet> list;
  add_grid(list, size_t(std::ceil(std::sqrt(double(count) / 2))), place);
  return mesh_of_list(list);
}

Point flat(double x, double y) { return {x, y, 0}; }

Point wavy(double x, double y) {
  const double u = x + 0.5;
  const double v = y + 0.5;
  return {x, y,
          0.08 * std::sin(9 * u + 2 * v) * std::cos(7 * v) +
              0.007 * std::sin(60 * u) * std::cos(55 * v)};
}

Point dome(double x, double y) { return {x, y, std::sqrt(1 - x * x - y * y)}; }

/* A cube of edge 1 whose six faces are grids. */
Mesh cube(size_t count) {
  std::vector<sepax_facet> list;
  const auto side = size_t(std::ceil(std::sqrt(double(count) / 12)));
  for (const double z : {-0.5, 0.5}) {
    add_grid(list, side, [z](double x, double y) { return Point{x, y, z}; });
    add_grid(list, side, [z](double x, double y) { return Point{y, z, x}; });
    add_grid(list, side, [z](double x, double y) { return Point{z, x, y}; });
  }
  return mesh_of_list(list);
}

/* ---------------------------------------------------------------------------- poses */

const sepax_pose still = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};

sepax_pose shift(double x, double y, double z) {
  sepax_pose pose = still;
  pose.translation[0] = x;
  pose.translation[1] = y;
  pose.translation[2] = z;
  return pose;
}

/* Turned round axis 0, 1 or 2. */
sepax_pose turn(int axis, double angle) {
  sepax_pose pose = still;
  const int i = (axis + 1) % 3;
  const int k = (axis + 2) % 3;
  pose.rotation[i][i] = pose.rotation[k][k] = std::cos(angle);
  pose.rotation[i][k] = -std::sin(angle);
  pose.rotation[k][i] = std::sin(angle);
  return pose;
}

/* The poses of a list, the last first: a product. */
sepax_pose product(const std::vector<sepax_pose> &list) {
  sepax_pose all = still;
  for (const sepax_pose &pose : list) {
    all = sepax_pose_compose(&all, &pose);
  }
  return all;
}

sepax_pose oblique() { return product({turn(2, 0.7), turn(0, 0.4), turn(1, 1.1)}); }

std::string of_gap(double gap) {
  char text[32];
  snprintf(text, sizeof text, "gap %g", gap);
  return text;
}

/* ------------------------------------------------------------------------- families */

using Pairs_of_meshes = std::vector<UnkindPair>;

Pairs_of_meshes plates(size_t count, size_t, const char *) {
  const Mesh level = sheet(count, flat);
  const sepax_pose place = oblique();
  const Mesh leaning = sheet(count, [&place](double x, double y) {
    const double v[3] = {x, y, 0};
    double to[3];
    sepax_pose_apply(&place, v, to);
    return Point{to[0], to[1], to[2]};
  });
  Pairs_of_meshes pairs = {{{level, level}, {}}, {{leaning, leaning}, {}}};
  for (const double gap : {1.0, 0.1, 0.01, 0.001}) {
    const double normal[3] = {place.rotation[0][2], place.rotation[1][2], place.rotation[2][2]};
    pairs[0].poses.push_back({"plates", of_gap(gap), {shift(0, 0, gap)}});
    pairs[0].poses.push_back(
        {"plates_turned", of_gap(gap), {product({shift(0, 0, gap), turn(2, 0.3)})}});
    pairs[1].poses.push_back({"plates_oblique",
                              of_gap(gap),
                              {shift(gap * normal[0], gap * normal[1], gap * normal[2])}});
  }
  return pairs;
}

Pairs_of_meshes concentric(size_t count, size_t, const char *) {
  return {{{sample("sphere", count, 1), sample("sphere", count, 1.1)},
           {{"spheres_aligned", "1 in 1.1", {still}},
            {"spheres_turned", "1 in 1.1", {turn(2, 0.01), oblique()}},
            {"spheres_off", "by 0.01", {shift(0.01, 0, 0), shift(0.006, 0.005, 0.006)}}}}};
}

Pairs_of_meshes sheets(size_t count, size_t, const char *) {
  const Mesh waves = sheet(count, wavy);
  const Mesh bowl = sheet(count, dome);
  return {{{waves, waves},
           {{"sheet_wavy", "z", {shift(0, 0, 0.01), shift(0, 0, 0.001)}},
            {"sheet_wavy", "oblique", {shift(0.003, 0.002, 0.01)}}}},
          {{bowl, bowl},
           {{"sheet_dome", "z", {shift(0, 0, 0.01), shift(0, 0, 0.001)}},
            {"sheet_dome", "oblique", {shift(0.003, 0.002, 0.01)}}}}};
}

/* A body and its own copy, shifted by a little: the closed ones collide. */
Pairs_of_meshes copies(size_t count, size_t, const char *) {
  const Mesh plate = sheet(count, flat);
  const Mesh ball = sample("ball-end", count, 10);
  const Mesh pocket = sample("pocket", count, 0);
  return {{{plate, plate},
           {{"copies_apart", "by 1e-3", {shift(0.003, 0.002, 0.001)}},
            {"copies_apart", "by 1e-9", {shift(1e-9, 0, 1e-9)}}}},
          {{ball, ball}, {{"copies_closed", "ball-end", {shift(0.01, 0.007, 0.004)}}}},
          {{pocket, pocket}, {{"copies_closed", "pocket", {shift(0.01, 0.007, 0.004)}}}}};
}

Pairs_of_meshes sizes(size_t count, size_t, const char *) {
  const Mesh ball = sample("sphere", count / 10, 1);
  const Mesh block = cube(count / 10);
  const Mesh speck = sample("sphere", count / 10, 1e-6);
  return {{{ball, block},
           {{"far_apart", "1e6 sizes", {shift(1e6, 0, 0), shift(6e5, 5e5, -6.2e5)}},
            {"far_apart", "turned", {product({shift(3e5, -8e5, 4e5), oblique()})}}}},
          {{block, speck},
           {{"size_of_1e-6",
             "near",
             {shift(0.51, 0.1, 0.2), shift(0.1, 0.2, 0.6), shift(0.500002, 0.3, 0.03)}}}}};
}

/* Faces that touch: the distance is 0. */
Pairs_of_meshes touching(size_t count, size_t, const char *) {
  const Mesh block = cube(count);
  return {{{block, block},
           {{"touching", "same grid", {shift(0, 0, 1)}},
            {"touching", "shifted", {shift(0.1, 0.07, 1)}},
            {"touching", "turned", {product({shift(0, 0, 1), turn(2, 0.3)})}},
            {"touching", "2^-40 apart", {shift(0.1, 0.07, 1 + 0x1p-40)}}}}};
}

/* -------------------------------------------- the mill of examples/five-axis, in m */

/* Each mesh in mm, as mill.urdf scales it. */
bool read_mill(const char *folder, const char *name, Mesh &mesh) {
  const std::string path = std::string(folder != nullptr ? folder : ".") + "/" + name + ".stl";
  FILE *there = fopen(path.c_str(), "r");
  if (there == nullptr) {
    return false;
  }
  fclose(there);
  sepax_soup soup = {};
  sepax_error error = {};
  if (!sepax_stl_read(&soup, path.c_str(), false, &error)) {
    stop(error.text);
  }
  for (size_t n = 0; n < 9 * soup.count; n++) {
    soup.facet[n / 9].v[n / 3 % 3][n % 3] *= 0.001;
  }
  mesh = owned(soup);
  return true;
}

struct Axes {
  double x, y, z, b, a;
};

/* The links of the tool and of the work in mill.urdf. */
sepax_pose tool_pose(int body, const Axes &at) {
  const sepax_pose fixed[3] = {still, shift(0, 0, -0.245), shift(0, 0, -0.055)};
  sepax_pose pose = product({shift(at.x, at.y, at.z), turn(1, at.b)});
  for (int k = 0; k <= body; k++) {
    pose = sepax_pose_compose(&pose, &fixed[k]);
  }
  return pose;
}

sepax_pose work_pose(int body, const Axes &at) {
  const sepax_pose fixed[3] = {still, shift(0, 0, -0.07), shift(0, 0, 0.02)};
  sepax_pose pose = turn(0, at.a);
  for (int k = 0; k <= body; k++) {
    pose = sepax_pose_compose(&pose, &fixed[k]);
  }
  return pose;
}

/* The work's body as the tool's body sees it. */
sepax_pose between(int tool, int work, const Axes &at) {
  const sepax_pose pose = tool_pose(tool, at);
  const sepax_pose back = sepax_pose_inverse(&pose);
  const sepax_pose other = work_pose(work, at);
  return sepax_pose_compose(&back, &other);
}

Pairs_of_meshes mill(size_t, size_t lines, const char *folder) {
  static const char *const tools[3] = {"spindle", "holder", "cutter"};
  static const char *const works[3] = {"table", "fixture", "workpiece"};
  constexpr double DEGREE = 3.14159265358979323846 / 180;
  Mesh mesh[2][3];
  for (int k = 0; k < 3; k++) {
    if (!read_mill(folder, tools[k], mesh[0][k]) || !read_mill(folder, works[k], mesh[1][k])) {
      return {};
    }
  }
  Pairs_of_meshes pairs;
  for (int k = 0; k < 9; k++) {
    const int i = k / 3;
    const int j = k % 3;
    const std::string kind = std::string(tools[i]) + "/" + works[j];
    UnkindPoses home = {"z_home", kind, {}};
    UnkindPoses generic = {"z_generic", kind, {}};
    for (size_t n = 0; n < lines; n++) {
      const double z = 0.001 * std::round(600 - 199 * double(n) / double(lines));
      home.poses.push_back(between(i, j, {0, 0, z, 0, 0}));
      generic.poses.push_back(between(i, j, {0.0037, 0.0021, z, 3.3 * DEGREE, 2.2 * DEGREE}));
    }
    UnkindPair pair = {{mesh[0][i], mesh[1][j]}, {home, generic}};
    if (kind == "holder/workpiece") {
      for (const double z : {0.1, 0.2, 0.3, 0.4, 0.5, 0.6}) {
        char height[32];
        snprintf(height, sizeof height, "z = %g", z);
        pair.poses.push_back({"holder_over_work", height, {between(i, j, {0, 0, z, 0, 0})}});
      }
    }
    if (kind == "spindle/table") {
      pair.poses.push_back(
          {"touching_mill", "spindle/table", {between(i, j, {0, 0, 0.115, 0, 0})}});
    }
    pairs.push_back(pair);
  }
  return pairs;
}

struct Family {
  const char *name;
  Pairs_of_meshes (*make)(size_t count, size_t lines, const char *folder);
};

const Family families[] = {{"plates", plates}, {"concentric", concentric}, {"sheets", sheets},
                           {"copies", copies}, {"sizes", sizes},           {"touching", touching},
                           {"mill", mill}};

} // namespace

std::vector<std::string> unkind_names() {
  std::vector<std::string> names;
  for (const Family &family : families) {
    names.emplace_back(family.name);
  }
  return names;
}

std::vector<UnkindPair> make_unkind(const std::string &name, size_t poses, const char *folder) {
  for (const Family &family : families) {
    if (name == family.name) {
      const size_t lines = std::min<size_t>(std::max<size_t>(poses / 50, 1), 200);
      return family.make(poses < 100 ? 1000 : 100000, lines, folder);
    }
  }
  stop("no scenes of the name " + name);
}
