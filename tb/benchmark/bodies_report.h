/* SPDX-License-Identifier: MIT */
/* bodies_report.h - figures of the benchmark of bodies: tables, bars, JSON. */
#ifndef BENCHMARK_BODIES_REPORT_H
#define BENCHMARK_BODIES_REPORT_H

#include "peer.h"

#include <cmath>

constexpr int PEERS = 5; /* the first is libsepax */

struct Figures {
  double seconds = 0; /* of the process */
  size_t poses = 0;   /* 0: not measured */
  size_t pairs = 0, wrong = 0;
  double ms() const { return 1e3 * seconds / double(poses); }
};

/* A scene in one kind of poses. */
struct Row {
  std::string scene, kind;
  bool unkind = false; /* distances alone; its poses are few */
  size_t triangles[2] = {0, 0};
  Figures figures[QUERIES][PEERS];
};

struct Ratios {
  double mean = 0, least = INFINITY;
  size_t count = 0;
  std::string least_of; /* the scene of the least */
};

/* The scenes of a mean. */
enum Choice { KIND, UNKIND, BOTH };

class Report {
public:
  explicit Report(const char *const names[PEERS]);
  void add(const Row &row) { rows.push_back(row); }
  void print_scene(const std::string &scene) const;
  void print_bars() const;
  void write_json(const char *path) const;
  size_t wrong() const; /* verdicts of libsepax */

private:
  const Row *row_of(const std::string &scene, const std::string &kind) const;
  Ratios ratios(int query, int library, const char *kind, Choice choice = KIND) const;
  void print_ratios(int query, const char *kind, double least_fcl) const;
  void print_distances(int query) const;
  void print_slow(int query, int library) const;
  void print_limit(const char *scene, double limit) const;
  Row sum_of(const std::string &scene) const;
  void print_row(const Row &row, int query, const char *name) const;
  std::vector<std::string> scenes(Choice choice) const;

  std::vector<std::string> name;
  std::vector<Row> rows;
};

#endif
