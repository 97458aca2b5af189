// SPDX-License-Identifier: MIT
// scenes.cpp - the scenes of bench_bodies as raw doubles, with what the C library takes for them:
//   python_scenes [-n POSES] [-m FOLDER_OF_STL] OUT_DIR [SCENE ...]
// OUT_DIR gets SCENE.a and SCENE.b (9 doubles a triangle), SCENE.poses (16 doubles a pose, of B),
// and a line of JSON for each scene on standard output.
#include "benchmark/peer.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <unistd.h>

void stop(const std::string &why) {
  fprintf(stderr, "python_scenes: %s\n", why.c_str());
  exit(2);
}

namespace {

void write(const std::string &path, const void *data, size_t bytes) {
  FILE *file = fopen(path.c_str(), "wb");
  if (file == nullptr || fwrite(data, 1, bytes, file) != bytes || fclose(file) != 0) {
    stop(path + " cannot be written");
  }
}

/* The processor's time, in which others do not count. */
double now() {
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

/* The least time of several passes over all poses. */
template <class Pass> double seconds_of(Pass pass) {
  double least = 1e300;
  const double begin = now();
  for (int k = 0; k < 7 && (k == 0 || now() - begin < 3); k++) {
    const double before = now();
    pass();
    least = std::min(least, now() - before);
  }
  return least;
}

void run(const Scene &scene, const std::string &out) {
  sepax_body *body[2];
  sepax_error error = {};
  for (int k = 0; k < 2; k++) {
    const sepax_mesh mesh = mesh_of(scene.mesh[k]);
    if (!sepax_body_new(&body[k], &mesh, nullptr, &error)) {
      stop(error.text);
    }
    write(out + "/" + scene.name + (k == 0 ? ".a" : ".b"), scene.mesh[k].facet,
          scene.mesh[k].count * sizeof *scene.mesh[k].facet);
  }
  std::vector<double> matrix;
  for (const sepax_pose &pose : scene.poses) {
    for (int i = 0; i < 3; i++) {
      matrix.insert(matrix.end(), pose.rotation[i], pose.rotation[i] + 3);
      matrix.push_back(pose.translation[i]);
    }
    matrix.insert(matrix.end(), {0, 0, 0, 1});
  }
  write(out + "/" + scene.name + ".poses", matrix.data(), matrix.size() * sizeof(double));

  sepax_query query = {};
  query.size = sizeof query;
  query.only_any = true;
  size_t hits = 0;
  const double collide = seconds_of([&] {
    hits = 0;
    for (const sepax_pose &pose : scene.poses) {
      sepax_pairs found;
      if (!sepax_bodies_collide(body[0], nullptr, body[1], &pose, &query, &found, &error)) {
        stop(error.text);
      }
      hits += found.count;
    }
  });
  /* As the Python package asks: each chunk of 16 poses begins anew. */
  sepax_distance_request request = {};
  request.size = sizeof request;
  request.relative = TOLERANCE;
  const double distance = seconds_of([&] {
    sepax_distance_result result[2];
    for (size_t n = 0; n < scene.poses.size(); n++) {
      request.last = n % 16 == 0 ? nullptr : &result[(n + 1) % 2];
      if (!sepax_bodies_distance(body[0], nullptr, body[1], &scene.poses[n], &request,
                                 &result[n % 2], &error)) {
        stop(error.text);
      }
    }
  });
  printf("{\"scene\": \"%s\", \"triangles\": [%zu, %zu], \"poses\": %zu, \"hits\": %zu, "
         "\"collide\": %.9g, \"distance\": %.9g}\n",
         scene.name.c_str(), scene.mesh[0].count, scene.mesh[1].count, scene.poses.size(), hits,
         collide, distance);
  fflush(stdout);
  sepax_body_free(body[0]);
  sepax_body_free(body[1]);
}

} // namespace

int main(int argc, char **argv) {
  size_t poses = 1000;
  const char *folder = nullptr;
  for (int option; (option = getopt(argc, argv, "n:m:")) != -1;) {
    if (option != 'n' && option != 'm') {
      return 2;
    }
    (option == 'n' ? (void)(poses = strtoul(optarg, nullptr, 10)) : (void)(folder = optarg));
  }
  if (optind >= argc) {
    stop("give OUT_DIR");
  }
  std::vector<std::string> names(argv + optind + 1, argv + argc);
  for (const std::string &name : names.empty() ? scene_names() : names) {
    const std::unique_ptr<Scene> scene = make_scene(name, poses, folder);
    if (scene == nullptr) {
      printf("{\"scene\": \"%s\", \"skipped\": \"its meshes are not here\"}\n", name.c_str());
      continue;
    }
    run(*scene, argv[optind]);
  }
  return 0;
}
