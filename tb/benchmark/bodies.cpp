// SPDX-License-Identifier: MIT
// bodies.cpp - two bodies that move: libsepax beside the libraries that are here, in one run on
// one core.
//   bench_bodies [-n POSES] [-m FOLDER_OF_STL] [-f FOLDER_OF_MILL] [-o FILE.json] [SCENE ...]
// Every verdict that differs from another library's goes to the oracle in rational numbers. Exit
// status 1: one of libsepax's is wrong, or an interval of a distance.
#include "peer.h"
#include "bodies_report.h"
#include "bodies_unkind.h"

#include "oracle/oracle.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <sched.h>
#include <unistd.h>

void stop(const std::string &why) {
  fprintf(stderr, "bench_bodies: %s\n", why.c_str());
  exit(2);
}

namespace {

struct Library {
  const char *name;
  Maker make;
};

const Library libraries[PEERS] = {{"sepax", make_sepax},
                                  {"FCL", make_fcl},
                                  {"Coal", make_coal},
                                  {"CGAL", make_cgal},
                                  {"Embree", make_embree}};

double cpu_seconds() {
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

bool truth(const Scene &scene, const std::array<size_t, 2> &pair, const sepax_pose &pose) {
  return oracle_collide_posed(scene.mesh[0].facet[pair[0]].v, nullptr,
                              scene.mesh[1].facet[pair[1]].v, &pose);
}

/* Pairs that one list has and the other lacks. */
Pairs difference(Pairs &from, Pairs &other) {
  Pairs only;
  std::set_difference(from.begin(), from.end(), other.begin(), other.end(),
                      std::back_inserter(only));
  return only;
}

void compare_all(const Scene &scene, const sepax_pose &pose, Pairs &own, Pairs &others,
                 Figures *figures) {
  std::sort(others.begin(), others.end());
  const Pairs claims[2] = {difference(own, others), difference(others, own)};
  for (int k = 0; k < 2; k++) {
    for (const auto &pair : claims[k]) {
      /* A claim that is true makes the other wrong. */
      const bool wrong_other = truth(scene, pair, pose) == (k == 0);
      (wrong_other ? figures[1] : figures[0]).wrong++;
    }
  }
}

void compare_first(const Scene &scene, const sepax_pose &pose, const Pairs &own,
                   const Pairs &others, Figures *figures) {
  if (own.empty() != others.empty()) {
    const bool collide = truth(scene, own.empty() ? others[0] : own[0], pose);
    (collide == own.empty() ? figures[0] : figures[1]).wrong++;
  }
}

/* The exact distances of some poses, by libsepax. */
using Distances = std::vector<double>;

/* Two distances of one pose are the same but for rounding and the tolerance, or both are of a
 * collision. Which one is wrong is not told: libsepax's are checked by tests of their own, and
 * counted here is the other. libsepax's intervals must hold its exact distances. */
void compare_distances(Query query, size_t poses, Peer *const peer[PEERS], Distances &exact,
                       Figures figures[PEERS]) {
  exact.resize(poses);
  for (size_t n = 0; n < poses; n++) {
    if (query == DISTANCE) {
      exact[n] = peer[0]->distance(n);
    } else {
      figures[0].wrong += !peer[0]->holds(n, exact[n]);
    }
    const double tolerance = 1e-9 * (1 + exact[n]) + (query == WITHIN ? TOLERANCE * exact[n] : 0);
    for (int k = 1; k < PEERS; k++) {
      if (peer[k] != nullptr && peer[k]->can(query)) {
        const double others = std::max(peer[k]->distance(n), 0.0);
        figures[k].wrong += !(std::fabs(exact[n] - others) <= tolerance);
      }
    }
  }
}

/* libsepax and each other library against it; figures[0] is its own. */
void compare(const Scene &scene, const Poses &poses, Query query, Peer *const peer[PEERS],
             Figures figures[PEERS]) {
  for (size_t n = 0; n < poses.size(); n++) {
    Pairs own = peer[0]->pairs(n);
    std::sort(own.begin(), own.end());
    figures[0].pairs += own.size();
    if (query == FIRST && !own.empty() && !truth(scene, own[0], poses[n])) {
      figures[0].wrong++;
    }
    for (int k = 1; k < PEERS; k++) {
      if (peer[k] == nullptr || !peer[k]->can(query)) {
        continue;
      }
      Figures two[2] = {};
      Pairs others = peer[k]->pairs(n);
      if (query == ALL) {
        compare_all(scene, poses[n], own, others, two);
      } else {
        compare_first(scene, poses[n], own, others, two);
      }
      figures[0].wrong += two[0].wrong;
      figures[k].wrong += two[1].wrong;
      figures[k].pairs += others.size();
    }
  }
}

/* All libraries in turn on a few poses at a time. */
void measure(const Scene &scene, const Poses &poses, Peer *const peer[PEERS], Row &row) {
  Distances exact;
  const size_t some = scene.mesh[0].count + scene.mesh[1].count < 50000 ? 100 : 10;
  for (size_t from = 0; from < poses.size(); from += some) {
    const Poses part(poses.begin() + long(from),
                     poses.begin() + long(std::min(from + some, poses.size())));
    for (int query = FIRST; query < QUERIES; query++) {
      for (int k = 0; k < PEERS; k++) {
        if (peer[k] == nullptr || !peer[k]->can(Query(query))) {
          continue;
        }
        if (from == 0) { /* memory that is touched for the first time */
          peer[k]->ask(Query(query), {part[0]});
        }
        const double start = cpu_seconds();
        peer[k]->ask(Query(query), part);
        row.figures[query][k].seconds += cpu_seconds() - start;
        row.figures[query][k].poses += part.size();
      }
      if (is_distance(query)) {
        compare_distances(Query(query), part.size(), peer, exact, row.figures[query]);
      } else {
        compare(scene, part, Query(query), peer, row.figures[query]);
      }
    }
  }
}

/* Building and one search for all pairs. */
void measure_once(const Scene &scene, const sepax_pose &pose, Row &row) {
  const size_t rounds = scene.mesh[0].count + scene.mesh[1].count < 50000 ? 5 : 1;
  std::unique_ptr<Peer> peer[PEERS];
  Peer *all[PEERS] = {};
  for (int k = 0; k < PEERS; k++) {
    double best = 0;
    for (size_t round = 0; round < rounds; round++) {
      const double start = cpu_seconds();
      const Maker make = k == 0 ? make_sepax_once : libraries[k].make;
      peer[k] = make(scene.mesh[0], scene.mesh[1]);
      if (peer[k] == nullptr) {
        break;
      }
      peer[k]->ask(ALL, {pose});
      const double took = cpu_seconds() - start;
      best = round == 0 ? took : std::min(best, took);
    }
    row.figures[ALL][k].seconds = best;
    row.figures[ALL][k].poses = peer[k] != nullptr;
    all[k] = peer[k].get();
  }
  compare(scene, {pose}, ALL, all, row.figures[ALL]);
}

Row row_of(const std::string &scene, const std::string &kind, const sepax_soup &a,
           const sepax_soup &b) {
  Row row;
  row.scene = scene;
  row.kind = kind;
  row.triangles[0] = a.count;
  row.triangles[1] = b.count;
  return row;
}

Row row_of(const Scene &scene, const char *kind) {
  return row_of(scene.name, kind, scene.mesh[0], scene.mesh[1]);
}

void run(const Scene &scene, Report &report) {
  for (int dense = 0; dense < 2 && scene.poses.size() >= KINDS; dense++) {
    Row row = row_of(scene, dense != 0 ? "one-shot, dense" : "one-shot, sparse");
    measure_once(scene, scene.poses[dense != 0 ? 4 : 2], row);
    report.add(row);
  }
  std::unique_ptr<Peer> peer[PEERS];
  Peer *all[PEERS];
  for (int k = 0; k < PEERS; k++) {
    peer[k] = libraries[k].make(scene.mesh[0], scene.mesh[1]);
    all[k] = peer[k].get();
  }
  for (int kind = 0; kind < KINDS; kind++) {
    Poses some;
    for (size_t n = size_t(kind); n < scene.poses.size(); n += KINDS) {
      some.push_back(scene.poses[n]);
    }
    Row row = row_of(scene, kind_names[kind]);
    measure(scene, some, all, row);
    report.add(row);
  }
  if (!scene.contact.empty()) {
    Row row = row_of(scene, "contact");
    measure(scene, scene.contact, all, row);
    report.add(row);
  }
}

/* The CPU time of one question that was asked before: its data are in the caches, as in a loop that
 * asks about one pair of bodies all the time. Short questions are repeated, and the median of three
 * such series counts; a long one is asked once, because it fills the caches by itself. */
double warm_seconds(Peer &peer, Query query, const Poses &pose) {
  constexpr double LONG = 0.02, SERIES = 2e-4;
  peer.ask(query, {}); /* trees that are built late */
  const double before = cpu_seconds();
  peer.ask(query, pose);
  const double first = cpu_seconds() - before;
  if (first > LONG) {
    return first;
  }
  const size_t repeats = size_t(std::ceil(SERIES / std::max(first, 1e-7)));
  const Poses many(repeats, pose[0]);
  double took[3];
  for (double &seconds : took) {
    const double start = cpu_seconds();
    peer.ask(query, many);
    seconds = (cpu_seconds() - start) / double(repeats);
  }
  std::sort(took, took + 3);
  return took[1];
}

/* Distances of one pair of bodies in poses that nobody chose kindly. */
void run_pair(const UnkindPair &pair, Report &report) {
  std::unique_ptr<Peer> peer[PEERS];
  Peer *all[PEERS];
  for (int k = 0; k < PEERS; k++) {
    peer[k] = libraries[k].make(*pair.mesh[0], *pair.mesh[1]);
    all[k] = peer[k].get();
  }
  for (const UnkindPoses &some : pair.poses) {
    Row row = row_of(some.scene, some.kind, *pair.mesh[0], *pair.mesh[1]);
    row.unkind = true;
    for (const sepax_pose &pose : some.poses) {
      Distances exact;
      for (const Query query : {DISTANCE, WITHIN}) {
        for (int k = 0; k < PEERS; k++) {
          if (all[k] != nullptr && all[k]->can(query)) {
            row.figures[query][k].seconds += warm_seconds(*all[k], query, {pose});
            row.figures[query][k].poses++;
          }
        }
        compare_distances(query, 1, all, exact, row.figures[query]);
      }
    }
    report.add(row);
  }
}

void run_unkind(const std::string &name, size_t poses, const char *folder, Report &report) {
  const std::vector<UnkindPair> pairs = make_unkind(name, poses, folder);
  std::vector<std::string> scenes;
  for (const UnkindPair &pair : pairs) {
    run_pair(pair, report);
    for (const UnkindPoses &some : pair.poses) {
      if (std::find(scenes.begin(), scenes.end(), some.scene) == scenes.end()) {
        scenes.push_back(some.scene);
      }
    }
  }
  if (pairs.empty()) {
    printf("%s: skipped, its meshes are not here\n", name.c_str());
  }
  for (const std::string &scene : scenes) {
    report.print_scene(scene);
  }
}

void stay_on_one_core() {
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(sched_getcpu(), &set);
  sched_setaffinity(0, sizeof set, &set);
}

} // namespace

int main(int argc, char **argv) {
  size_t poses = 1000;
  const char *folder = nullptr;
  const char *mill = nullptr;
  const char *json = nullptr;
  for (int option; (option = getopt(argc, argv, "n:m:f:o:")) != -1;) {
    switch (option) {
    case 'n':
      poses = strtoul(optarg, nullptr, 10);
      break;
    case 'm':
      folder = optarg;
      break;
    case 'f':
      mill = optarg;
      break;
    case 'o':
      json = optarg;
      break;
    default:
      return 2;
    }
  }
  std::vector<std::string> names(argv + optind, argv + argc);
  const std::vector<std::string> unkind = unkind_names();
  if (names.empty()) {
    names = scene_names();
    names.insert(names.end(), unkind.begin(), unkind.end());
  }
  stay_on_one_core();
  const char *called[PEERS];
  for (int k = 0; k < PEERS; k++) {
    called[k] = libraries[k].name;
  }
  Report report(called);
  sepax_facet one = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  for (int k = 1; k < PEERS; k++) {
    if (libraries[k].make({&one, 1, nullptr}, {&one, 1, nullptr}) == nullptr) {
      printf("%s: skipped, it is not installed\n", libraries[k].name);
    }
  }
  for (const std::string &name : names) {
    if (std::find(unkind.begin(), unkind.end(), name) != unkind.end()) {
      run_unkind(name, poses, mill, report);
      continue;
    }
    const std::unique_ptr<Scene> scene = make_scene(name, poses, folder);
    if (scene == nullptr) {
      printf("%s: skipped, its meshes are not here\n", name.c_str());
      continue;
    }
    run(*scene, report);
    report.print_scene(name);
  }
  report.print_bars();
  if (json != nullptr) {
    report.write_json(json);
  }
  return report.wrong() > 0 ? 1 : 0;
}
