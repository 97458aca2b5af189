// SPDX-License-Identifier: MIT
// bodies_scenes.cpp - the meshes of the benchmark and the poses of their bodies.
#include "peer.h"

#include "sepax_vectors.h"

#include <cmath>
#include <cstring>

const char *const kind_names[KINDS] = {"far", "near", "touching", "shallow", "deep"};

Scene::~Scene() {
  sepax_soup_free(&mesh[0]);
  sepax_soup_free(&mesh[1]);
}

namespace {

double uniform(sepax_random &random, double low, double high) {
  return low + (high - low) * std::ldexp(double(sepax_random_next(&random) >> 11), -53);
}

struct Vector {
  double c[3];
};

Vector direction(sepax_random &random) {
  for (;;) {
    Vector v = {{uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)}};
    const double square = v.c[0] * v.c[0] + v.c[1] * v.c[1] + v.c[2] * v.c[2];
    if (square > 0.01 && square <= 1) {
      for (double &x : v.c) {
        x /= std::sqrt(square);
      }
      return v;
    }
  }
}

/* A turn by `angle` round an axis through `centre`. */
sepax_pose turned(const Vector &axis, double angle, const double centre[3]) {
  const double w = std::cos(angle / 2);
  double q[3];
  for (int i = 0; i < 3; i++) {
    q[i] = std::sin(angle / 2) * axis.c[i];
  }
  sepax_pose pose = {};
  for (int i = 0; i < 3; i++) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    pose.rotation[i][i] = 1 - 2 * (q[j] * q[j] + q[k] * q[k]);
    pose.rotation[i][j] = 2 * (q[i] * q[j] - w * q[k]);
    pose.rotation[i][k] = 2 * (q[i] * q[k] + w * q[j]);
  }
  for (int i = 0; i < 3; i++) {
    pose.translation[i] = centre[i];
    for (int k = 0; k < 3; k++) {
      pose.translation[i] -= pose.rotation[i][k] * centre[k];
    }
  }
  return pose;
}

void sample(sepax_soup &mesh, const char *shape, size_t count, double x, double y, double z,
            double size) {
  const double at[3] = {x, y, z};
  sepax_error error = {};
  if (!sepax_sample(&mesh, shape, count, at, size, &error)) {
    stop(error.text);
  }
}

/* An open surface z(x, y) over a square of 100, two triangles a cell. */
void wavy_surface(sepax_soup &mesh, size_t count) {
  const auto side = size_t(std::sqrt(double(count) / 2));
  auto z = [side](size_t i, size_t j) {
    const double x = double(i) / double(side);
    const double y = double(j) / double(side);
    return 8 * std::sin(9 * x + 2 * y) * std::cos(7 * y) +
           0.7 * std::sin(60 * x) * std::cos(55 * y);
  };
  mesh.count = 2 * side * side;
  mesh.facet = static_cast<sepax_facet *>(calloc(mesh.count, sizeof *mesh.facet));
  if (mesh.facet == nullptr) {
    stop("no memory for a surface");
  }
  static const int corner[2][3][2] = {{{0, 0}, {1, 0}, {1, 1}}, {{0, 0}, {1, 1}, {0, 1}}};
  for (size_t n = 0; n < mesh.count; n++) {
    for (int k = 0; k < 3; k++) {
      const size_t i = n / 2 % side + size_t(corner[n % 2][k][0]);
      const size_t j = n / 2 / side + size_t(corner[n % 2][k][1]);
      double *v = mesh.facet[n].v[k];
      v[0] = 100 * double(i) / double(side) - 50;
      v[1] = 100 * double(j) / double(side) - 50;
      v[2] = z(i, j);
    }
  }
}

/* How B moves, in the units of the file: turned by up to `tilt` round any axis through `centre`,
 * then along a direction: `way` and `spread` times a random one. It starts deep inside. Far away it
 * is lifted, too. */
struct Path {
  double centre[3];
  double tilt;
  double way[3], spread;
  double size, lift;
};

struct Recipe {
  const char *name;
  void (*make)(Scene &scene, const char *folder);
  Path path;
};

void gouge(Scene &scene, size_t count) {
  sample(scene.mesh[0], "pocket", count, 0, 0, 0, 0);
  sample(scene.mesh[1], "ball-end", count, 45, 0, -20, 0);
}

void spheres(Scene &scene, size_t count) {
  sample(scene.mesh[0], "sphere", count, 0, 0, 0, 40);
  sample(scene.mesh[1], "sphere", count, 15, 3, 2, 40);
}

void mould(Scene &scene, const char *folder) {
  static const char *const file[2] = {"ktoolcav.stl", "ktoolcor.stl"};
  sepax_error error = {};
  for (int k = 0; k < 2; k++) {
    const std::string path = std::string(folder != nullptr ? folder : ".") + "/" + file[k];
    FILE *there = fopen(path.c_str(), "r");
    if (there == nullptr) {
      return;
    }
    fclose(there);
    if (!sepax_stl_read(&scene.mesh[k], path.c_str(), false, &error)) {
      stop(error.text);
    }
  }
}

constexpr double PI = 3.14159265358979323846;

const Recipe recipes[] = {
    {"gouge_1k",
     [](Scene &s, const char *) { gouge(s, 1000); },
     {{45, 0, -20}, 0.1, {-1, 0, 0.1}, 0.3, 60, 100}},
    {"spheres_10k",
     [](Scene &s, const char *) { spheres(s, 10000); },
     {{15, 3, 2}, PI, {0, 0, 0}, 1, 40, 0}},
    {"mould", mould, {{0, 0, 0}, 0.02, {0, 0, 0}, 1, 4, 0}},
    {"gouge_100k",
     [](Scene &s, const char *) { gouge(s, 100000); },
     {{45, 0, -20}, 0.1, {-1, 0, 0.1}, 0.3, 60, 100}},
    {"tool_surface",
     [](Scene &s, const char *) {
       wavy_surface(s.mesh[0], 1000000);
       sample(s.mesh[1], "ball-end", 1000, 0, 0, -6, 6);
     },
     {{0, 0, 0}, 0.5, {0, 0, 1}, 0.3, 20, 0}},
    {"surfaces_1M",
     [](Scene &s, const char *) {
       wavy_surface(s.mesh[0], 1000000);
       sample(s.mesh[1], "sphere", 1000000, 0, 0, 10, 40);
     },
     {{0, 0, 10}, PI, {0, 0, 1}, 0.3, 40, 0}},
};

bool meet(const sepax_body *const body[2], const sepax_pose &pose) {
  sepax_query any = {};
  any.size = sizeof any;
  any.only_any = true;
  sepax_pairs found;
  sepax_error error = {};
  if (!sepax_bodies_collide(body[0], nullptr, body[1], &pose, &any, &found, &error)) {
    stop(error.text);
  }
  return found.count > 0;
}

sepax_pose shifted(const sepax_pose &pose, const Vector &way, double by) {
  sepax_pose moved = pose;
  for (int i = 0; i < 3; i++) {
    moved.translation[i] += by * way.c[i];
  }
  return moved;
}

/* Kinds in turn. The body is moved out along a direction; where it comes free is found by
 * bisection, and the pose is that place and a part of the body's size. */
sepax_pose draw_pose(size_t n, const Path &path, const sepax_body *const body[2],
                     sepax_random &random) {
  const sepax_pose start =
      turned(direction(random), uniform(random, -path.tilt, path.tilt), path.centre);
  Vector way = direction(random);
  for (int i = 0; i < 3; i++) {
    way.c[i] = path.way[i] + path.spread * way.c[i];
  }
  double low = 0;
  double high = 0.05 * path.size;
  while (high < 4 * path.size && meet(body, shifted(start, way, high))) {
    low = high;
    high *= 1.5;
  }
  for (int step = 0; step < 24; step++) {
    const double middle = (low + high) / 2;
    (meet(body, shifted(start, way, middle)) ? low : high) = middle;
  }
  const double part = uniform(random, 0, 1);
  switch (n % KINDS) {
  case 0:
    return shifted(shifted(start, way, high + (0.5 + part) * path.size), {{0, 0, 1}}, path.lift);
  case 1:
    return shifted(start, way, high + (0.001 + 0.01 * part) * path.size);
  case 2:
    return shifted(start, way, low);
  case 3:
    return shifted(start, way, low - std::fmin(low, 0.02 * part * path.size));
  default:
    return shifted(start, way, part * low);
  }
}

} // namespace

std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  for (const Recipe &recipe : recipes) {
    names.emplace_back(recipe.name);
  }
  return names;
}

std::unique_ptr<Scene> make_scene(const std::string &name, size_t poses, const char *folder) {
  for (const Recipe &recipe : recipes) {
    if (name != recipe.name) {
      continue;
    }
    auto scene = std::make_unique<Scene>();
    scene->name = name;
    recipe.make(*scene, folder);
    if (scene->mesh[0].count == 0 || scene->mesh[1].count == 0) {
      return nullptr;
    }
    sepax_body *body[2] = {nullptr, nullptr};
    sepax_error error = {};
    for (int k = 0; k < 2; k++) {
      const sepax_mesh mesh = mesh_of(scene->mesh[k]);
      if (!sepax_body_new(&body[k], &mesh, nullptr, &error)) {
        stop(error.text);
      }
    }
    sepax_random random = {1};
    for (size_t n = 0; n < poses; n++) {
      scene->poses.push_back(draw_pose(n, recipe.path, body, random));
    }
    const sepax_pose still = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};
    if (name == "mould") {
      scene->contact.assign(std::min<size_t>(poses, 20), still);
    }
    if (name == "gouge_100k") { /* the cutter turns */
      for (size_t n = 0; n < std::min<size_t>(poses, 100); n++) {
        scene->contact.push_back(
            turned({{0, 0, 1}}, uniform(random, 0, 2 * PI), recipe.path.centre));
      }
    }
    sepax_body_free(body[0]);
    sepax_body_free(body[1]);
    return scene;
  }
  stop("no meshes of the name " + name);
}
