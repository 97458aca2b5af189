// SPDX-License-Identifier: MIT
// walks.cpp - the verilated tree engine against its golden model: random bodies and poses, or two
// STL files in the pose of their files. Pairs, their order, flags and counters are compared. --any:
// before most runs bytes of the trees are damaged, poses are mostly any numbers, and the memory is
// quick or slow, with gaps and without. --dense: bodies of large triangles about one point. --rows:
// every second run has a first row, often of nodes that are no leaves, and finds the caches as they
// are. --collisions=N: until there are so many. --high: what is damaged are high bits of where
// things are.
#include "tree_engine/modules/walk_bench.h"

#include "sepax_models.h"
#include "sepax_params.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

namespace {

struct Options {
  unsigned runs = 100;
  uint64_t seed = 1, stress = 0, damage = 0, stops = 0, errors = 0, resets = 0, fault = 0;
  int latency = 100, size = 60, verbose = 0;
  bool any = false, dense = false, rows = false, high = false;
  uint64_t collisions = 0;
  unsigned line = 32, stack = 1024;
  double resolution = 0;
  const char *design = "", *wave = nullptr;
  std::vector<const char *> meshes;
} options;

uint64_t state;
uint64_t draw() { return memory_draw(&state); }
int below(int count) { return (int)(draw() % (uint64_t)count); }
bool happens(uint64_t one_in) { return one_in > 0 && draw() % one_in == 0; }
Damage damage(&state);
double unit() { return (double)(int64_t)draw() * 0x1p-63; }

[[noreturn]] void fail(const char *what) {
  std::fprintf(stderr, "walks: %s\n", what);
  std::exit(2);
}

// ------------------------------------------------------------------ golden model

struct Golden {
  sepax_tree_run run;
  std::vector<sepax_tree_pair> near;
};

bool keep(void *context, const sepax_tree_pair *pair) {
  static_cast<Golden *>(context)->near.push_back(*pair);
  return true;
}

Golden walk(const Scene &scene, const sepax_tree_pose &pose, const Ask &ask,
            const sepax_design &design) {
  Golden golden;
  sepax_tree_walk_options how = {};
  how.design = &design;
  how.line = options.line;
  how.stack = options.stack;
  how.first = ask.first;
  how.row = ask.row ? &ask.pair : nullptr;
  how.each = keep;
  how.context = &golden;
  const uint8_t *image[2] = {&scene.bytes[scene.at[0]], &scene.bytes[scene.at[1]]};
  sepax_error error;
  if (!sepax_tree_walk_images(image, scene.record, &pose, &how, &golden.run, &error)) {
    fail(error.text);
  }
  return golden;
}

std::vector<Result> results_of(const Golden &golden) {
  std::vector<Result> results;
  for (const sepax_tree_pair &p : golden.near) {
    bool warning = !p.collision && p.band == SEPAX_BAND_WARNING;
    if (p.collision || warning) {
      results.push_back(
          {p.triangle[0], p.triangle[1], p.coplanar && !p.out_of_range, p.out_of_range, warning});
    }
  }
  return results;
}

// ------------------------------------------------------------------- comparison

std::vector<std::string> faults;
void expect(const char *what, uint64_t is, uint64_t should) {
  if (is != should) {
    faults.push_back(std::string(what) + " " + std::to_string(is) + ", not " +
                     std::to_string(should));
  }
}

void compare_first(Engine &e, const Golden &golden, size_t collisions) {
  const sepax_tree_pair &f = golden.run.found;
  expect("ANY", e.top->any, collisions > 0);
  if (collisions > 0) {
    expect("FIRST, A", e.top->first_a, f.triangle[0]);
    expect("FIRST, B", e.top->first_b, f.triangle[1]);
    expect("FIRST, leaf A", e.top->first_leaf_a, f.leaf[0]);
    expect("FIRST, leaf B", e.top->first_leaf_b, f.leaf[1]);
    expect("FIRST, a", e.top->first_row_a, (uint64_t)f.child[0]);
    expect("FIRST, b", e.top->first_row_b, (uint64_t)f.child[1]);
  }
}

// Of a run that was stopped: what it found is where the golden order begins.
void compare_part(Engine &e, const Golden &golden, const Ask &ask) {
  size_t near = e.top->near_pairs;
  size_t collisions = 0, warnings = 0;
  for (size_t k = 0; k < near && k < golden.near.size(); k++) {
    collisions += golden.near[k].collision;
    warnings += !golden.near[k].collision && golden.near[k].band == SEPAX_BAND_WARNING;
  }
  expect("NEAR of a part", near <= golden.near.size(), 1);
  expect("COLLISIONS of a part", e.top->collisions, collisions);
  expect("results of a part", e.results.size(), ask.quiet ? 0 : collisions + warnings);
  compare_first(e, golden, collisions);
}

void compare(Engine &e, const Golden &golden, const Ask &ask) {
  const sepax_tree_run &run = golden.run;
  std::vector<Result> should = results_of(golden);
  if (ask.quiet) {
    should.clear();
  }
  for (size_t k = 0; k < e.results.size() && k < should.size(); k++) {
    if (!(e.results[k] == should[k])) {
      expect("result", k, SIZE_MAX);
      break;
    }
  }
  if (e.ram.counts.errors == 0) {
    expect("ERROR", e.top->error, 0);
  } else if (e.top->error) {
    compare_part(e, golden, ask);
    return;
  }
  bool finished = !e.top->stopped && !e.top->damaged; // in time, but for what it then waits for
  expect("cycles beyond BUDGET", finished && e.top->cycles > uint64_t(ask.budget) + 100, 0);
  expect("the memory side idle", e.idle_at_end, 1);
  uint64_t last = uint64_t(ask.budget) + 1; // STOPPED is a register
  bool other = ask.stop < UINT64_MAX || (ask.first && e.top->any);
  expect("CYCLES as BUDGET ends it", e.top->stopped && !other && e.stopped_at != last, 0);
  expect("STOPPED behind BUDGET", e.top->stopped && e.stopped_at > last, 0);
  if (e.top->stopped && (ask.budget < UINT32_MAX || ask.stop < UINT64_MAX)) {
    expect("DAMAGED", e.top->damaged, 0);
    compare_part(e, golden, ask);
    return;
  }
  expect("DAMAGED", e.top->damaged, run.damaged);
  expect("STOPPED", e.top->stopped, run.ended);
  expect("NEAR", e.top->near_pairs, run.near);
  expect("COLLISIONS", e.top->collisions, run.collisions);
  expect("OUT_OF_RANGE", e.top->out_of_range, run.out_of_range);
  expect("WARNINGS", e.top->warnings, run.warnings);
  expect("results", e.results.size(), should.size());
  compare_first(e, golden, run.collisions);
  if (!run.ended && !run.damaged) {
    expect("ENTRIES", e.top->entries, run.entries);
    expect("STEPS", e.top->steps, run.steps);
    expect("ROWS", e.top->rows, run.rows);
    expect("PAIRS", e.top->pairs, run.pairs);
  }
}

// ------------------------------------------------------------------------ scenes

sepax_vec near_to(const double at[3], double size, double step, int word) {
  sepax_vec v;
  int32_t *coordinate[3] = {&v.x, &v.y, &v.z};
  double most = std::ldexp(1, word - 1) - 1;
  for (int i = 0; i < 3; i++) {
    double x = at[i] + size * unit();
    x = step > 0 ? step * std::round(x / step) : x;
    *coordinate[i] = (int32_t)std::round(x < -most ? -most : x > most ? most : x);
  }
  return v;
}

// Triangles strewn in a ball or a slab, large or small, some without an area; or most of them with
// two vertices of the one before, in any order.
sepax_tree *strewn(size_t count, int word) {
  std::vector<sepax_tri> tri(count);
  double reach = std::ldexp(1, word - 1) * (below(4) == 0 ? 0.9 : 0.3);
  double size = reach / (1 + below(options.dense ? 1 : options.any ? 8 : 40));
  double step = below(3) == 0 ? std::ldexp(1, word - 6) : 0;
  bool flat = below(3) == 0;
  bool joined = below(2) == 0;
  double at[3];
  for (size_t n = 0; n < count; n++) {
    bool joins = joined && n > 0 && below(4) > 0;
    for (int i = 0; i < 3 && !joins; i++) {
      at[i] = options.dense || (flat && i == 2) ? 0 : reach * unit();
    }
    for (sepax_vec &v : tri[n].v) {
      v = near_to(at, below(20) == 0 ? 0 : size, step, word);
    }
    for (int k = below(3), j = below(3), step_j = 1 + below(2), m = 0; joins && m < 2; m++) {
      tri[n].v[(k + m) % 3] = tri[n - 1].v[(j + m * step_j) % 3];
    }
  }
  sepax_tree *tree;
  sepax_grid grid = {};
  grid.resolution = 1;
  grid.word = word;
  sepax_error error;
  if (!sepax_tree_new(&tree, tri.data(), count, &grid, &error)) {
    fail(error.text);
  }
  return tree;
}

sepax_pose random_pose(double away) {
  double q[4], n = 0;
  int kind = below(4); // any; of quarters; none
  for (double &x : q) {
    x = kind == 0 ? unit() : kind == 1 ? below(3) - 1 : 0;
    n += x * x;
  }
  if (n < 1e-6) {
    q[0] = n = 1;
    q[1] = q[2] = q[3] = 0;
  }
  double w = q[0], x = q[1], y = q[2], z = q[3], f = 2 / n;
  sepax_pose p = {{{1 - f * (y * y + z * z), f * (x * y - w * z), f * (x * z + w * y)},
                   {f * (x * y + w * z), 1 - f * (x * x + z * z), f * (y * z - w * x)},
                   {f * (x * z - w * y), f * (y * z + w * x), 1 - f * (x * x + y * y)}},
                  {0, 0, 0}};
  for (double &t : p.translation) {
    t = kind == 1 ? std::round(away * unit()) : away * unit();
  }
  return p;
}

sepax_tree_pose pose_of(const Scene &scene, const sepax_pose *b, const sepax_design &design) {
  sepax_tree_pose pose;
  sepax_error error;
  int64_t margin = design.limits > 0 ? design.margin[1] : 0;
  if (!sepax_tree_pose_make(&pose, scene.tree[0], nullptr, scene.tree[1], b, margin, &error)) {
    fail(error.text);
  }
  return pose;
}

// ------------------------------------------------------------------------- runs

struct Totals {
  uint64_t runs = 0, mismatches = 0, near = 0, collisions = 0, damaged = 0, stopped = 0;
} totals;

// False after a fault.
bool judge(Engine &e, const Scene &scene, const sepax_tree_pose &pose, const Ask &ask,
           const sepax_design &design) {
  Golden golden = walk(scene, pose, ask, design);
  faults.clear();
  if (!e.run(scene, pose, ask)) {
    faults.push_back("hangs");
    e.reset();
  } else {
    compare(e, golden, ask);
  }
  expect("breaches of AXI", e.ram.counts.breaches, 0);
  expect("pairs that are not thinnest along z", e.thick, 0);
  totals.runs++;
  totals.mismatches += !faults.empty();
  totals.near += e.top->near_pairs;
  totals.collisions += e.top->collisions;
  totals.damaged += e.top->damaged;
  totals.stopped += e.top->stopped;
  if (options.verbose > 0 || (!faults.empty() && totals.mismatches < 10)) {
    const sepax_tree_run &r = golden.run;
    std::printf(
        "run %llu: %u cycles, %llu beats, entries %llu, steps %llu, rows %llu, pairs %llu, "
        "near %llu, collisions %llu, deepest %llu%s%s%s%s\n",
        (unsigned long long)totals.runs, e.top->cycles, (unsigned long long)e.ram.counts.beats,
        (unsigned long long)r.entries, (unsigned long long)r.steps, (unsigned long long)r.rows,
        (unsigned long long)r.pairs, (unsigned long long)r.near, (unsigned long long)r.collisions,
        (unsigned long long)r.deepest, ask.first ? ", FIRST" : "", ask.quiet ? ", QUIET" : "",
        ask.row ? ", ROW" : "", r.damaged ? ", damaged" : "");
    for (const std::string &fault : faults) {
      std::printf("  %s\n", fault.c_str());
    }
  }
  return faults.empty();
}

// How a run in which anything may be damaged goes.
void draw_memory(Engine &e) {
  static const int cycles[] = {1, 2, 3, 5, 10, 30};
  e.ram.options.latency = cycles[below(6)];
  e.ram.options.stress = below(3) == 0 ? 1 + draw() / 2 : 0;
  e.ram.options.error_odds = below(20) == 0 ? (uint64_t)(1 + below(100)) : 0;
}

Ask draw_ask(const Scene &scene, bool is_new, const sepax_tree_pair *last) {
  Ask ask;
  ask.first = below(4) == 0;
  ask.quiet = below(8) == 0;
  ask.cold = is_new || (!options.rows && below(2) == 0);
  ask.probe = is_new || below(2) == 0;
  ask.row = below(options.rows ? 2 : 3) == 0;
  bool any = options.any || below(2) == 0;
  ask.pair = last != nullptr && below(2) == 0 ? *last : damage.any_row(scene, any);
  if (any && below(2) == 0) { // with a root: behind a hit, leaves of the other are in the cache
    ask.pair.leaf[below(2)] = 0;
  }
  ask.budget = happens(options.stops) ? (uint32_t)(1 + below(3000)) : UINT32_MAX;
  ask.stop = happens(options.stops) ? (uint64_t)below(3000) : UINT64_MAX;
  return ask;
}

sepax_tree_pose draw_pose(const Scene &scene, const sepax_design &design) {
  sepax_pose b = random_pose(std::ldexp(options.dense ? 0.02
                                        : options.any ? 0.2
                                                      : 0.7,
                                        design.config.word - 1));
  if (below(6) == 0) { // by what W + 2 bits do not tell
    int most = design.config.word < 20 ? design.config.word + 2 : 22; // poses are below 2^23
    b.translation[below(3)] += std::ldexp(below(2) == 0 ? 1 : -1, most);
  }
  return options.any && below(3) == 0 ? damage.any_pose() : pose_of(scene, &b, design);
}

bool is_going_on() {
  return options.collisions > 0 ? totals.collisions < options.collisions
                                : totals.runs < options.runs;
}

void random_runs(Engine &e, const sepax_design &design) {
  int word = design.config.word;
  while (is_going_on() && (options.fault == 0 || totals.mismatches == 0)) {
    Scene scene;
    for (sepax_tree *&tree : scene.tree) {
      tree = strewn((size_t)(1 + below(1 + below(options.size * options.size))), word);
    }
    scene.place();
    sepax_tree_pair last = {};
    bool known = false, is_new = true;
    bool harmed = options.any || happens(options.damage);
    int poses = options.any || options.rows ? 20 : 1 + below(8);
    for (; poses > 0 && is_going_on(); poses--) {
      sepax_tree_pose pose = draw_pose(scene, design);
      Ask ask = draw_ask(scene, is_new, known ? &last : nullptr);
      if (options.any) {
        draw_memory(e);
      }
      if (happens(options.resets)) {
        e.begin(scene, pose, ask);
        for (int cycles = below(2000); cycles > 0; cycles--) {
          e.tick();
        }
        e.reset();
        ask.cold = true;
      }
      if (harmed && (is_new || (options.any && below(4) > 0))) {
        scene.place();
        damage.harm(scene, options.high);
        ask.cold = true;
      }
      is_new = false;
      judge(e, scene, pose, ask, design);
      if (e.top->any) {
        known = true;
        last.leaf[0] = e.top->first_leaf_a;
        last.leaf[1] = e.top->first_leaf_b;
        last.child[0] = (int)e.top->first_row_a;
        last.child[1] = (int)e.top->first_row_b;
      }
    }
  }
}

void mesh_run(Engine &e, const sepax_design &design) {
  sepax_soup mesh[2];
  sepax_error error;
  Scene scene;
  for (int i = 0; i < 2; i++) {
    if (!sepax_stl_read(&mesh[i], options.meshes[(size_t)i], false, &error)) {
      fail(error.text);
    }
  }
  sepax_mesh view[2] = {};
  for (int i = 0; i < 2; i++) {
    view[i].size = sizeof view[i];
    view[i].vertex = mesh[i].facet;
    view[i].triangles = mesh[i].count;
  }
  const sepax_mesh *const both[2] = {&view[0], &view[1]};
  sepax_grid grid = {};
  grid.resolution = options.resolution;
  grid.word = design.config.word;
  bool ok = grid.resolution > 0 || sepax_grid_fit(&grid, both, 2, grid.word, &error);
  for (int i = 0; i < 2 && ok; i++) {
    std::vector<sepax_tri> tri(mesh[i].count);
    ok = sepax_quantise(&view[i], &grid, tri.data(), &error) &&
         sepax_tree_new(&scene.tree[i], tri.data(), tri.size(), &grid, &error);
    sepax_soup_free(&mesh[i]);
  }
  if (!ok) {
    fail(error.text);
  }
  scene.place();
  options.verbose = 1;
  Ask ask;
  judge(e, scene, pose_of(scene, nullptr, design), ask, design);
}

bool number(const char *argument, const char *name, uint64_t *value) {
  size_t length = std::strlen(name);
  if (std::strncmp(argument, name, length) != 0) {
    return false;
  }
  *value = std::strtoull(argument + length, nullptr, 0);
  return true;
}

void read_options(int count, char **argument) {
  for (int k = 1; k < count; k++) {
    uint64_t value = 0;
    const char *a = argument[k];
    if (number(a, "--runs=", &value)) {
      options.runs = (unsigned)value;
    } else if (number(a, "--seed=", &options.seed) || number(a, "--stress=", &options.stress) ||
               number(a, "--damage=", &options.damage) || number(a, "--stops=", &options.stops) ||
               number(a, "--errors=", &options.errors) || number(a, "--fault=", &options.fault) ||
               number(a, "--resets=", &options.resets) ||
               number(a, "--collisions=", &options.collisions)) {
    } else if (number(a, "--latency=", &value)) {
      options.latency = (int)value;
    } else if (number(a, "--size=", &value)) {
      options.size = (int)value;
    } else if (number(a, "--line=", &value)) {
      options.line = (unsigned)value;
    } else if (number(a, "--stack=", &value)) {
      options.stack = (unsigned)value;
    } else if (std::strcmp(a, "--any") == 0) {
      options.any = true;
    } else if (std::strcmp(a, "--dense") == 0) {
      options.dense = true;
    } else if (std::strcmp(a, "--rows") == 0) {
      options.rows = true;
    } else if (std::strcmp(a, "--high") == 0) {
      options.high = true;
    } else if (std::strcmp(a, "-v") == 0) {
      options.verbose = 1;
    } else if (std::strncmp(a, "--wave=", 7) == 0) {
      options.wave = a + 7;
    } else if (a[0] != '-') {
      options.meshes.push_back(a);
    } else {
      fail("bad option");
    }
  }
}

} // namespace

int main(int count, char **argument) {
  read_options(count, argument);
  state = options.seed;
  sepax_config config = sepax_config_default();
  sepax_design design;
  sepax_error error;
  if (!sepax_config_parse(&config, SEPAX_OPTIONS, &error) ||
      !sepax_design_init(&design, &config, &error)) {
    fail(error.text);
  }
  Engine engine(options.wave, options.seed, options.stress, options.latency, options.errors);
  engine.top->fault = (uint32_t)options.fault;
  if (options.meshes.size() == 2) {
    mesh_run(engine, design);
  } else {
    random_runs(engine, design);
  }
  std::printf("%llu runs, %llu mismatches, %llu near pairs, %llu collisions, %llu damaged, "
              "%llu stopped, %llu cycles\n",
              (unsigned long long)totals.runs, (unsigned long long)totals.mismatches,
              (unsigned long long)totals.near, (unsigned long long)totals.collisions,
              (unsigned long long)totals.damaged, (unsigned long long)totals.stopped,
              (unsigned long long)engine.cycles);
  return totals.mismatches > 0;
}
