// SPDX-License-Identifier: MIT
// bodies_report.cpp - figures of the benchmark of bodies: tables, bars, JSON.
#include "bodies_report.h"

#include <algorithm>
#include <cmath>

namespace {

const char *const query_names[QUERIES] = {"first", "all", "distance", "1e-6"};

/* Rows of a scene's poses; the others are of one-shot searches and of bars of their own. */
bool is_kind(const std::string &kind) {
  return std::find(kind_names, kind_names + KINDS, kind) != kind_names + KINDS;
}

} // namespace

Report::Report(const char *const names[PEERS]) : name(names, names + PEERS) {}

size_t Report::wrong() const {
  size_t sum = 0;
  for (const Row &row : rows) {
    for (const auto &of_query : row.figures) {
      sum += of_query[0].wrong;
    }
  }
  return sum;
}

std::vector<std::string> Report::scenes(Choice choice) const {
  std::vector<std::string> list;
  for (const Row &row : rows) {
    const bool chosen = choice == BOTH || row.unkind == (choice == UNKIND);
    if (chosen && std::find(list.begin(), list.end(), row.scene) == list.end()) {
      list.push_back(row.scene);
    }
  }
  return list;
}

Row Report::sum_of(const std::string &scene) const {
  Row sum;
  for (const Row &row : rows) {
    if (row.scene != scene || !(row.unkind || is_kind(row.kind))) {
      continue;
    }
    sum.scene = scene;
    sum.kind = "mean";
    std::copy(row.triangles, row.triangles + 2, sum.triangles);
    for (int q = 0; q < QUERIES; q++) {
      for (int k = 0; k < PEERS; k++) {
        sum.figures[q][k].seconds += row.figures[q][k].seconds;
        sum.figures[q][k].poses += row.figures[q][k].poses;
        sum.figures[q][k].pairs += row.figures[q][k].pairs;
        sum.figures[q][k].wrong += row.figures[q][k].wrong;
      }
    }
  }
  return sum;
}

void Report::print_row(const Row &row, int query, const char *what) const {
  const Figures *figures = row.figures[query];
  if (figures[0].poses == 0) {
    return;
  }
  printf("  %-17s %-9s %9.1f %10.5f", row.kind.c_str(), what,
         double(figures[0].pairs) / double(figures[0].poses), figures[0].ms());
  for (int k = 1; k < PEERS; k++) {
    if (figures[k].poses == 0) {
      printf(" %20s", "-");
    } else {
      printf(" %10.5f %8.3gx", figures[k].ms(), figures[k].ms() / figures[0].ms());
    }
  }
  for (int k = 0; k < PEERS; k++) {
    printf(" %7zu", figures[k].wrong);
  }
  putchar('\n');
}

void Report::print_scene(const std::string &scene) const {
  const Row mean = sum_of(scene);
  printf("%s: %zu x %zu triangles, ms a pose of CPU time, times libsepax's; verdicts that are "
         "wrong\n  %-17s %-9s %9s %10s",
         scene.c_str(), mean.triangles[0], mean.triangles[1], "poses", "query", "pairs",
         name[0].c_str());
  for (int k = 1; k < PEERS; k++) {
    printf(" %20s", name[size_t(k)].c_str());
  }
  for (int k = 0; k < PEERS; k++) {
    printf(" %7s", name[size_t(k)].c_str());
  }
  putchar('\n');
  for (int query = 0; query < QUERIES; query++) {
    for (const Row &row : rows) {
      if (row.scene == scene) {
        print_row(row, query, query_names[query]);
      }
    }
    print_row(mean, query, query_names[query]);
  }
  fflush(stdout);
}

const Row *Report::row_of(const std::string &scene, const std::string &kind) const {
  for (const Row &row : rows) {
    if (row.scene == scene && row.kind == kind) {
      return &row;
    }
  }
  return nullptr;
}

/* Times libsepax's, of the rows of each scene. kind: nullptr for the mean of all poses. */
Ratios Report::ratios(int query, int library, const char *kind, Choice choice) const {
  Ratios r;
  double sum = 0;
  for (const std::string &scene : scenes(choice)) {
    const Row mean = sum_of(scene);
    const Row *row = kind == nullptr ? &mean : row_of(scene, kind);
    const Figures *figures = row != nullptr ? row->figures[query] : nullptr;
    if (figures != nullptr && figures[0].poses > 0 && figures[library].poses > 0) {
      const double ratio = figures[library].ms() / figures[0].ms();
      sum += std::log(ratio);
      r.least_of = ratio < r.least ? scene : r.least_of;
      r.least = std::fmin(r.least, ratio);
      r.count++;
    }
  }
  r.mean = std::exp(sum / double(r.count));
  return r;
}

void Report::print_ratios(int query, const char *kind, double least_fcl) const {
  for (int k = 1; k < PEERS; k++) {
    const Ratios r = ratios(query, k, kind);
    if (r.count == 0) {
      continue;
    }
    const bool each = k == 1 && least_fcl > 0;
    printf("  %-17s %-9s %-8s %8.3g %8.3g   %s\n", kind != nullptr ? kind : "mean",
           query_names[query], name[size_t(k)].c_str(), r.mean, r.least,
           each ? (r.least >= least_fcl ? "met" : "missed") : (r.mean >= 1 ? "met" : "missed"));
  }
}

/* The means of the scenes of either kind and of both, and the scene of the least ratio. */
void Report::print_distances(int query) const {
  static const char *const names[] = {"kind scenes", "unkind scenes", "all scenes"};
  for (int choice = KIND; choice <= BOTH; choice++) {
    for (int k = 1; k < PEERS; k++) {
      const Ratios r = ratios(query, k, nullptr, Choice(choice));
      if (r.count > 0) {
        printf("  %-17s %-9s %-8s %8.3g %8.3g   %s of %zu: %s\n", names[choice], query_names[query],
               name[size_t(k)].c_str(), r.mean, r.least, "least", r.count, r.least_of.c_str());
      }
    }
  }
}

/* Scenes in which the library takes less than 50 us, where 10 us are the bar, and those in which
 * libsepax is not twice as fast. */
void Report::print_slow(int query, int library) const {
  constexpr double SHORT = 0.05, BAR = 0.01, FASTER = 2;
  for (const std::string &scene : scenes(BOTH)) {
    const Row row = sum_of(scene);
    const Figures *f = row.figures[query];
    if (f[0].poses == 0 || f[library].poses == 0) {
      continue;
    }
    const bool is_short = f[library].ms() <= SHORT;
    const bool met = is_short ? f[0].ms() <= BAR : f[library].ms() >= FASTER * f[0].ms();
    if (is_short || !met) {
      printf("  %-17s %-9s %s %.2f us, libsepax %.2f us, bar %s   %s\n", scene.c_str(),
             query_names[query], name[size_t(library)].c_str(), 1e3 * f[library].ms(),
             1e3 * f[0].ms(), is_short ? "10 us" : "half", met ? "met" : "missed");
    }
  }
}

void Report::print_limit(const char *scene, double limit) const {
  const Row *row = row_of(scene, "contact");
  if (row != nullptr) {
    const double ms = row->figures[ALL][0].ms();
    printf("  %s in contact, all pairs: %.4f ms, bar %.1f ms   %s\n", scene, ms, limit,
           ms <= limit ? "met" : "missed");
  }
}

void Report::print_bars() const {
  printf("times libsepax's: geometric mean over the meshes, least; bars: 3 for FCL on each, else 1 "
         "for the mean\n");
  for (int query = 0; query < QUERIES; query++) {
    print_ratios(query, nullptr, is_distance(query) ? 0 : 3);
  }
  print_ratios(ALL, "one-shot, sparse", 0);
  print_ratios(ALL, "one-shot, dense", 0);
  print_limit("gouge_100k", 0.5);
  print_limit("mould", 3);
  printf("distances, times libsepax's: geometric mean over the scenes, least\n");
  print_distances(DISTANCE);
  print_distances(WITHIN);
  printf("scenes in which another library takes at most 50 us, or less than twice libsepax's "
         "time\n");
  for (int k = 1; k < PEERS; k++) {
    print_slow(WITHIN, k);
  }
}

void Report::write_json(const char *path) const {
  FILE *file = fopen(path, "w");
  if (file == nullptr) {
    stop(std::string(path) + " cannot be written");
  }
  fputs("{\"rows\": [", file);
  const char *before = "\n";
  for (const Row &row : rows) {
    for (int q = 0; q < QUERIES; q++) {
      for (int k = 0; k < PEERS; k++) {
        const Figures &f = row.figures[q][k];
        if (f.poses > 0) {
          fprintf(file,
                  "%s  {\"meshes\": \"%s\", \"unkind\": %s, \"triangles\": [%zu, %zu], "
                  "\"poses\": \"%s\", \"count\": %zu, ",
                  before, row.scene.c_str(), row.unkind ? "true" : "false", row.triangles[0],
                  row.triangles[1], row.kind.c_str(), f.poses);
          fprintf(file,
                  "\"query\": \"%s\", \"library\": \"%s\", \"ms\": %.6g, \"pairs\": %zu, "
                  "\"wrong\": %zu}",
                  query_names[q], name[size_t(k)].c_str(), f.ms(), f.pairs, f.wrong);
          before = ",\n";
        }
      }
    }
  }
  fputs("\n]}\n", file);
  if (fclose(file) != 0) {
    stop(std::string(path) + " cannot be written");
  }
}
