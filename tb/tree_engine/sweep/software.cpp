// SPDX-License-Identifier: MIT
// software.cpp - the tree engine beside software: two bodies in the poses of a file, all pairs that
// collide; and how long trees take to build.
//   bench_tree NAME RESOLUTION A.stl B.stl
//   bench_tree NAME RESOLUTION A.stl B.stl POSES LOG
// The first prints a line a body: triangles, microseconds and bytes a triangle.
// LOG is what `make cosim POSES=file` printed of the same bodies, resolution (0: what fits) and
// poses: a line a pose begins with cycles, near pairs, collisions. Prints a line for the poses that
// collide and one for those that do not: microseconds a pose of CPU time on one core. All are asked
// in turn, some poses at a time; the least of some rounds counts.
#include "fast_walk.h"

#include "benchmark/peer.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <sched.h>
#include <sstream>

void stop(const std::string &why) {
  fprintf(stderr, "bench_tree: %s\n", why.c_str());
  exit(2);
}

namespace {

constexpr int ROUNDS = 5;
constexpr size_t SOME = 50; /* poses at a time */

sepax_error failure = {};

void stop_unless(bool ok) {
  if (!ok) {
    stop(failure.text);
  }
}

double cpu_seconds() {
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

/* The meshes on one grid; resolution 0: what fits. */
struct Quantised {
  sepax_grid grid;
  std::vector<sepax_tri> tri[2];

  Quantised(const sepax_soup mesh[2], double resolution)
      : grid{resolution, {0, 0, 0}, sepax_config_default().word} {
    const sepax_mesh view[2] = {mesh_of(mesh[0]), mesh_of(mesh[1])};
    const sepax_mesh *both[2] = {&view[0], &view[1]};
    stop_unless(resolution > 0 || sepax_grid_fit(&grid, both, 2, grid.word, &failure));
    for (int i = 0; i < 2; i++) {
      tri[i].resize(mesh[i].count);
      stop_unless(sepax_quantise(&view[i], &grid, tri[i].data(), &failure));
    }
  }
};

sepax_tree *tree_of(const Quantised &body, int i) {
  sepax_tree *tree = nullptr;
  stop_unless(sepax_tree_new(&tree, body.tri[i].data(), body.tri[i].size(), &body.grid, &failure));
  return tree;
}

/* The trees that the engine reads, by the walk of the golden model or by a fast one. */
class Walk : public Peer {
public:
  Walk(const sepax_soup mesh[2], double resolution) {
    sepax_config config = sepax_config_default();
    stop_unless(sepax_config_parse(&config, "--tree=on", &failure) &&
                sepax_design_init(&design, &config, &failure));
    const Quantised body(mesh, resolution);
    tree[0] = tree_of(body, 0);
    tree[1] = tree_of(body, 1);
    fast = make_fast_walk(tree[0], tree[1]);
  }
  Walk(const Walk &) = delete;
  ~Walk() override {
    sepax_tree_free(tree[0]);
    sepax_tree_free(tree[1]);
  }

  bool has_fast() const { return fast != nullptr; }
  void be_fast(bool yes) { is_fast = yes; }

  void ask(Query, const Poses &poses) override {
    found.assign(poses.size(), TreePairs());
    for (size_t n = 0; n < poses.size(); n++) {
      sepax_tree_pose pose;
      stop_unless(sepax_tree_pose_make(&pose, tree[0], nullptr, tree[1], &poses[n],
                                       design.margin[1], &failure));
      if (is_fast) {
        fast->ask(pose, found[n]);
      } else {
        sepax_tree_run run;
        sepax_tree_walk_options how = {};
        how.design = &design;
        how.each = keep;
        how.context = &found[n];
        stop_unless(sepax_tree_walk(tree[0], tree[1], &pose, &how, &run, &failure));
      }
    }
  }

  Pairs pairs(size_t n) const override {
    Pairs list;
    for (const auto &pair : found[n]) {
      list.push_back({pair.first, pair.second});
    }
    return list;
  }

private:
  static bool keep(void *context, const sepax_tree_pair *pair) {
    if (pair->collision) {
      static_cast<TreePairs *>(context)->push_back({pair->triangle[0], pair->triangle[1]});
    }
    return true;
  }

  sepax_design design;
  sepax_tree *tree[2];
  std::unique_ptr<FastWalk> fast;
  bool is_fast = false;
  std::vector<TreePairs> found;
};

/* The fast walk finds what the golden model does. */
void compare_walks(Walk &walk, const Poses &poses) {
  std::vector<Pairs> golden;
  walk.be_fast(false);
  walk.ask(ALL, poses);
  for (size_t n = 0; n < poses.size(); n++) {
    golden.push_back(walk.pairs(n));
  }
  walk.be_fast(true);
  walk.ask(ALL, poses);
  for (size_t n = 0; n < poses.size(); n++) {
    Pairs fast = walk.pairs(n);
    std::sort(fast.begin(), fast.end());
    std::sort(golden[n].begin(), golden[n].end());
    if (fast != golden[n]) {
      stop("the fast walk is wrong");
    }
  }
}

enum { BODIES, WALK, FAST, FCL, PEERS };

/* Microseconds of all poses, the least of some rounds. */
void measure(const Poses &poses, Peer *const peer[PEERS], double us[PEERS]) {
  for (size_t from = 0; from < poses.size(); from += SOME) {
    const Poses part(poses.begin() + long(from),
                     poses.begin() + long(std::min(from + SOME, poses.size())));
    double least[PEERS];
    std::fill(least, least + PEERS, INFINITY);
    for (int round = 0; round < ROUNDS; round++) {
      for (int k = 0; k < PEERS; k++) {
        if (peer[k] != nullptr) {
          if (k == WALK || k == FAST) {
            static_cast<Walk *>(peer[k])->be_fast(k == FAST);
          }
          const double start = cpu_seconds();
          peer[k]->ask(ALL, part);
          least[k] = std::min(least[k], 1e6 * (cpu_seconds() - start));
        }
      }
    }
    for (int k = 0; k < PEERS; k++) {
      us[k] += least[k];
    }
  }
}

/* The poses that collide, or those that do not. */
void report(const char *name, bool contact, const Poses &poses, Peer *const peer[PEERS]) {
  if (poses.empty()) {
    return;
  }
  double us[PEERS] = {};
  measure(poses, peer, us);
  printf("%s,%s,%zu", name, contact ? "contact" : "free", poses.size());
  for (int k = 0; k < PEERS; k++) {
    if (peer[k] == nullptr) {
      printf(",-");
    } else {
      printf(",%.3f", us[k] / double(poses.size()));
    }
  }
  putchar('\n');
  fflush(stdout);
}

void stay_on_one_core() {
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(sched_getcpu(), &set);
  sched_setaffinity(0, sizeof set, &set);
}

void report_trees(const char *name, const sepax_soup mesh[2], double resolution) {
  const Quantised body(mesh, resolution);
  for (int i = 0; i < 2; i++) {
    const double count = double(mesh[i].count);
    double least = INFINITY;
    size_t bytes = 0;
    for (int round = 0; round < 3; round++) {
      const double start = cpu_seconds();
      sepax_tree *tree = tree_of(body, i);
      least = std::min(least, cpu_seconds() - start);
      sepax_tree_image(tree, &bytes);
      sepax_tree_free(tree);
    }
    printf("%s,%c,%zu,%.2f,%.1f\n", name, "AB"[i], mesh[i].count, 1e6 * least / count,
           double(bytes) / count);
  }
}

void report_poses(const char *name, const sepax_soup mesh[2], double resolution,
                  const char *poses_path, const char *log_path) {
  sepax_poses poses;
  stop_unless(sepax_poses_read(&poses, poses_path, &failure));
  Poses kind[2];
  std::ifstream log(log_path);
  std::string line;
  for (size_t n = 0; n < poses.count; n++) {
    double cycles = 0;
    unsigned long long near = 0;
    unsigned long long collisions = 0;
    std::getline(log, line);
    if (!(std::istringstream(line) >> cycles >> near >> collisions)) {
      stop(std::string(log_path) + ": no line of three numbers for each pose");
    }
    kind[collisions > 0].push_back(poses.pose[n]);
  }
  sepax_poses_free(&poses);
  const std::unique_ptr<Peer> bodies = make_sepax(mesh[0], mesh[1]);
  const std::unique_ptr<Peer> fcl = make_fcl(mesh[0], mesh[1]);
  Walk walk(mesh, resolution);
  Peer *const peer[PEERS] = {bodies.get(), &walk, walk.has_fast() ? &walk : nullptr, fcl.get()};
  if (walk.has_fast()) {
    compare_walks(walk, kind[0]);
    compare_walks(walk, kind[1]);
  }
  for (int contact = 1; contact >= 0; contact--) {
    report(name, contact != 0, kind[contact], peer);
  }
}

} // namespace

int main(int argc, char **argv) {
  if (argc != 5 && argc != 7) {
    stop("usage: bench_tree NAME RESOLUTION A.stl B.stl [POSES LOG]");
  }
  stay_on_one_core();
  sepax_soup mesh[2];
  for (int i = 0; i < 2; i++) {
    stop_unless(sepax_stl_read(&mesh[i], argv[3 + i], false, &failure));
  }
  if (argc == 5) {
    report_trees(argv[1], mesh, atof(argv[2]));
  } else {
    report_poses(argv[1], mesh, atof(argv[2]), argv[5], argv[6]);
  }
  sepax_soup_free(&mesh[0]);
  sepax_soup_free(&mesh[1]);
  return 0;
}
