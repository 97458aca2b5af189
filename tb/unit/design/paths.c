/* SPDX-License-Identifier: MIT */
/* paths.c - on a path the design that sepax_size_design finds is the cheapest of all that there
 * are, tree engines among them, each timed in each pose; what a pose gives an engine of lanes and a
 * tree engine to do is the same. */
#include "size/workloads.h"
#include "harness.h"

#include <math.h>

enum { MOST_FACETS = 150, MOST_POSES = 4, LANES = 12, MOST_OPTIONS = 7 * 8 * (2 * LANES + 2) };

typedef struct {
  sepax_config config;
  double gates;
  uint64_t cycles;
} option;

typedef struct {
  sepax_facet facet[2][MOST_FACETS];
  sepax_soup mesh[2];
  sepax_pose pose[MOST_POSES];
  sepax_poses path;
  sepax_size size;
  option all[MOST_OPTIONS];
  size_t options;
} scene;

static const int intervals[] = {1, 2, 3, 4, 6, 9, 18};

/* Whole coordinates, and a body about the origin: quarter turns and whole shifts round nothing. */
static void draw_body(scene *s, int i, int count, int spread) {
  s->mesh[i] = (sepax_soup){.facet = s->facet[i], .count = (size_t)(1 + random_below(count))};
  for (size_t n = 0; n < s->mesh[i].count; n++) {
    int middle[3];
    for (int axis = 0; axis < 3; axis++) {
      middle[axis] = n == 0 ? 0 : random_below(2 * spread + 1) - spread;
    }
    for (int k = 0; k < 9; k++) {
      int at = middle[k % 3] + random_below(41) - 20;
      at = n == 0 ? (k / 3 == 0 ? -1 : 1) * (spread + 20) : at;
      s->facet[i][n].v[k / 3][k % 3] = at;
    }
  }
}

static sepax_pose draw_pose(int way) {
  static const int turns[4][3][3] = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                     {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
                                     {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
                                     {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}};
  sepax_pose pose;
  int turn = random_below(4);
  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 3; k++) {
      pose.rotation[i][k] = turns[turn][i][k];
    }
    pose.translation[i] = random_below(2 * way + 1) - way;
  }
  return pose;
}

static void draw_scene(scene *s, int count) {
  int spread = 20 + random_below(200);
  draw_body(s, 0, count, spread);
  draw_body(s, 1, count, spread);
  s->path = (sepax_poses){s->pose, (size_t)(1 + random_below(MOST_POSES))};
  for (size_t n = 0; n < s->path.count; n++) {
    s->pose[n] = draw_pose(random_below(2 * spread));
  }
  const sepax_space space = {.resolution = 1, .offset_given = true, .path = &s->path};
  sepax_size_free(&s->size);
  assert_works(sepax_size_scene(&s->size, &s->mesh[0], &s->mesh[1], &space, &fault));
  assert_int_equal(s->size.workloads, s->path.count);
  assert_int_equal(s->size.path, s->path.count);
  assert_non_null(s->size.trees);
}

/* Vertices that an engine of lanes is sent for a pose: A's stay if they are one part. */
static uint64_t vertices_sent(const scene *s, const sepax_config *c) {
  uint64_t sent = 0;
  size_t of_a = 0;
  for (size_t i = 0; i < s->mesh[0].count; i += (size_t)c->memory_a) {
    of_a++;
    size_t of_b = 0;
    for (size_t j = 0; j < s->mesh[1].count; j += (size_t)c->memory_b) {
      size_t rest = s->mesh[1].count - j;
      of_b++;
      sent += rest < (size_t)c->memory_b ? rest : (size_t)c->memory_b;
    }
    sent -= of_a > 1 && of_b == 1 ? s->mesh[1].count : 0;
  }
  return 3 * (sent + (of_a > 1 ? s->mesh[0].count : 0));
}

static uint64_t cycles_of(const scene *s, const sepax_design *design, uint64_t *steps) {
  uint64_t most = 0;
  for (size_t n = 0; n < s->path.count; n++) {
    const sepax_config *c = &design->config;
    const struct sepax_size_trees *t = s->size.trees;
    sepax_tree_run run = {.cycles = 0};
    if (c->tree) {
      const sepax_tree_walk_options how = {.design = design};
      assert_works(sepax_tree_walk(t->tree[0], t->tree[1], &t->pose[n], &how, &run, &fault));
    } else {
      run.cycles = sepax__workload_cycles(&s->size.workload[n], s->size.count, c, steps);
      run.cycles += c->lanes > 0 ? vertices_sent(s, c) : 0;
    }
    most = run.cycles > most ? run.cycles : most;
  }
  return most;
}

static void list_options(scene *s, uint64_t *steps) {
  const sepax_size *size = &s->size;
  double unread;
  s->options = 0;
  for (size_t n = 0; n < LENGTH(intervals) * SEPAX_CORES_MAX; n++) {
    int ii = intervals[n / SEPAX_CORES_MAX];
    int cores = 1 + (int)n % SEPAX_CORES_MAX;
    sepax_design tree =
        design_of("--word=%d --ii=%d --cores=%d --tree=on", size->trees->word, ii, cores);
    s->all[s->options++] =
        (option){tree.config, sepax_gates(&tree, &unread), cycles_of(s, &tree, steps)};
    for (int lanes = 0; lanes <= LANES; lanes++) {
      for (int extents = 0; extents < (size->core_word < size->grid.word ? 2 : 1); extents++) {
        sepax_design other =
            design_of("--word=%d --ii=%d --extent-a=%d --extent-b=%d --lanes=%d --cores=%d",
                      size->grid.word, ii, extents != 0 ? (int)size->extent[0] : 0,
                      extents != 0 ? (int)size->extent[1] : 0, lanes, lanes > 0 ? cores : 1);
        s->all[s->options++] =
            (option){other.config, sepax_gates(&other, &unread), cycles_of(s, &other, steps)};
      }
    }
  }
}

static bool is_asked(const option *o, const sepax_size_request *r) {
  return o->config.tree ? r->tree
                        : o->config.lanes >= r->lanes_least && o->config.lanes <= r->lanes_most;
}

static const option *cheapest(const scene *s, const sepax_size_request *r, uint64_t limit,
                              uint64_t *fewest) {
  const option *best = NULL;
  *fewest = UINT64_MAX;
  for (const option *o = s->all; o < s->all + s->options; o++) {
    if (is_asked(o, r)) {
      *fewest = o->cycles < *fewest ? o->cycles : *fewest;
      best = o->cycles <= limit && (best == NULL || o->gates < best->gates) ? o : best;
    }
  }
  return best;
}

CASE(test_cheapest_on_a_path) {
  static scene s;
  static uint64_t steps[2 * MOST_FACETS * MOST_FACETS];
  size_t trees = 0;
  size_t lanes = 0;
  for (int n = 0; n < FEWER(24); n++) {
    draw_scene(&s, n % 3 == 0 ? 12 : MOST_FACETS);
    list_options(&s, steps);
    for (int k = 0; k < 12; k++) {
      const option *at = &s.all[random_below((int)s.options)];
      while (k % 2 == 1 && !at->config.tree) {
        at = &s.all[random_below((int)s.options)];
      }
      uint64_t limit = at->cycles - (uint64_t)random_below(2);
      sepax_size_request request = {.seconds = (double)limit * 2e-9,
                                    .clock_ps = 2000,
                                    .lanes_least = k % 4 == 1 ? 1 : 0,
                                    .lanes_most = k % 4 == 1   ? 0
                                                  : k % 4 == 3 ? 2
                                                               : LANES,
                                    .tree = k % 4 != 0};
      uint64_t fewest;
      const option *best = cheapest(&s, &request, limit, &fewest);
      sepax_sized_design m;
      bool ok = sepax_size_design(&m, &s.size, &request, &fault);
      assert_int_equal(ok, best != NULL);
      if (best == NULL) {
        assert_int_equal(m.cycles, fewest);
        assert_message(k % 4 == 1 ? "the fastest tree engine takes" : "or coarsen");
        continue;
      }
      assert_true(fabs(m.gates - best->gates) <= 1e-9 * best->gates);
      assert_int_equal(m.config.tree, best->config.tree);
      assert_int_equal(m.cycles, best->cycles);
      assert_true(m.mean <= (double)m.cycles && m.mean > 0 && m.worst < s.path.count);
      trees += m.config.tree && request.lanes_least == 0;
      lanes += m.config.lanes > 0;
    }
  }
  sepax_size_free(&s.size);
  assert_true(trees > FEWER(5) && lanes > FEWER(20));
}

/* ------------------------------------------------------------------- several pairs */

enum { PAIRS = 3 };

/* In each pose, the sum of all that are there; a tree engine takes more cycles for each of them. */
static uint64_t cycles_of_all(const scene s[PAIRS], const sepax_design *design,
                              const sepax_size_request *request, uint64_t *steps) {
  uint64_t most = 0;
  for (size_t n = 0; n < s[0].path.count; n++) {
    uint64_t latency = design->config.tree ? (uint64_t)request->latency : 0;
    uint64_t sum = latency;
    for (int k = 0; k < PAIRS; k++) {
      if (s[k].size.absent != NULL && s[k].size.absent[n] != 0) {
        uint64_t none;
        assert_works(sepax_size_cycles(&none, &s[k].size, &design->config, n, request, &fault));
        assert_int_equal(none, 0);
        continue;
      }
      sum += design->config.tree ? 40 + latency : 0;
      const struct sepax_size_trees *t = s[k].size.trees;
      sepax_tree_run run = {.cycles = 0};
      if (design->config.tree) {
        const sepax_tree_walk_options how = {.design = design, .latency = request->latency};
        assert_works(sepax_tree_walk(t->tree[0], t->tree[1], &t->pose[n], &how, &run, &fault));
      } else {
        run.cycles =
            sepax__workload_cycles(&s[k].size.workload[n], s[k].size.count, &design->config, steps);
        run.cycles += design->config.lanes > 0 ? vertices_sent(&s[k], &design->config) : 0;
      }
      uint64_t cycles;
      assert_works(sepax_size_cycles(&cycles, &s[k].size, &design->config, n, request, &fault));
      assert_int_equal(cycles, run.cycles);
      sum += run.cycles;
    }
    most = sum > most ? sum : most;
  }
  return most;
}

/* The cheapest for all pairs of a scene, of all that there are, and one cycle less. */
CASE(test_cheapest_of_pairs) {
  static scene s[PAIRS];
  static uint64_t steps[2 * MOST_FACETS * MOST_FACETS];
  static unsigned char absent[PAIRS][MOST_POSES];
  enum { FIRST = FEWER_BY > 1 ? 2 : 0 }; /* one of many facets, one of few */
  size_t kinds[2] = {0, 0};
  for (int n = FIRST; n < 4; n++) {
    sepax_size size[PAIRS];
    int word[2] = {0, 0};
    int shortest = 0;
    for (int k = 0; k < PAIRS; k++) {
      do {
        draw_scene(&s[k], n % 3 == 0 ? 12 : MOST_FACETS);
      } while (s[k].path.count != s[0].path.count);
      for (int at = 0; at < MOST_POSES; at++) { /* the first pair is always there */
        absent[k][at] = (unsigned char)(k > 0 && random_below(2) == 0);
      }
      s[k].size.absent = n % 2 == 0 ? absent[k] : NULL;
      int of_trees = s[k].size.trees->word;
      word[0] = s[k].size.grid.word > word[0] ? s[k].size.grid.word : word[0];
      word[1] = of_trees > word[1] ? of_trees : word[1];
      shortest = of_trees < s[shortest].size.trees->word ? k : shortest;
    }
    for (int k = 0; k < PAIRS; k++) {
      size[k] = s[(k + shortest) % PAIRS].size;
    }
    for (int tree = 0; tree < 2; tree++) {
      sepax_size_request request = {.clock_ps = 2000, .tree = tree != 0, .latency = 50 + n};
      request.lanes_most = tree != 0 ? -1 : 3;
      uint64_t limit = 0;
      double least = INFINITY;
      for (int turn = 0; turn < 2; turn++) { /* any design's cycles; then the cheapest within */
        for (size_t i = 0; i < LENGTH(intervals) * SEPAX_CORES_MAX * 4; i++) {
          int ii = intervals[i / 4 / SEPAX_CORES_MAX];
          int cores = 1 + (int)(i / 4) % SEPAX_CORES_MAX;
          int lanes = tree != 0 ? 0 : (int)i % 4;
          sepax_design d =
              design_of("--word=%d --ii=%d --lanes=%d --cores=%d --tree=%s", word[tree], ii, lanes,
                        tree + lanes > 0 ? cores : 1, tree != 0 ? "on" : "off");
          uint64_t cycles = cycles_of_all(s, &d, &request, steps);
          double unread;
          if (turn == 0 && (limit == 0 || random_below(40) == 0)) {
            limit = cycles;
          } else if (turn == 1 && cycles <= limit) {
            least = fmin(least, sepax_gates(&d, &unread));
          }
        }
      }
      sepax_sized_design m;
      request.seconds = (double)limit * 2e-9;
      assert_works(sepax_size_pairs(&m, size, PAIRS, &request, &fault));
      assert_true(fabs(m.gates - least) <= 1e-9 * least);
      assert_true(m.cycles <= limit && m.mean <= (double)m.cycles);
      assert_int_equal(m.config.tree, tree);
      sepax_design found;
      assert_works(sepax_design_init(&found, &m.config, &fault));
      assert_int_equal(m.cycles, cycles_of_all(s, &found, &request, steps));
      kinds[tree]++;
    }
  }
  assert_true(kinds[0] == 4 - FIRST && kinds[1] == 4 - FIRST);
  for (int k = 0; k < PAIRS; k++) {
    sepax_size_free(&s[k].size);
  }
}

/* Where nothing is rounded, near pairs of a tree engine are the candidates of one with lanes. */
CASE(test_same_near_pairs) {
  static scene s;
  uint64_t near = 0;
  for (int n = 0; n < FEWER(60); n++) {
    draw_scene(&s, MOST_FACETS);
    for (size_t k = 0; k < s.path.count; k++) {
      const sepax_size_request request = {.latency = 100};
      sepax_design design = design_of("--word=%d --ii=3 --tree=on", s.size.trees->word);
      sepax_tree_run run;
      assert_works(sepax__size_trees_walk(s.size.trees, &design.config, k, &request, &run, &fault));
      assert_int_equal(run.near, s.size.workload[k].candidates);
      near += run.near;
    }
  }
  sepax_size_free(&s.size);
  assert_true(near > FEWER(10000));
}

/* The same with a clearance, to which a tree engine adds 2 LSB. */
CASE(test_same_near_pairs_with_a_clearance) {
  static scene s;
  uint64_t near[2] = {0, 0};
  for (int n = 0; n < (FEWER_BY > 1 ? 8 : 30); n++) {
    sepax_size limited[2];
    draw_scene(&s, MOST_FACETS);
    for (int k = 0; k < 2; k++) {
      const sepax_space space = {.resolution = 1,
                                 .offset_given = true,
                                 .path = &s.path,
                                 .limited = true,
                                 .clearance = 3,
                                 .warning = n % 2 == 0 ? 0 : 9 - 2 * k};
      sepax_space one = space;
      one.clearance = n % 2 == 0 ? 9 - 2 * k : 3;
      assert_works(sepax_size_scene(&limited[k], &s.mesh[0], &s.mesh[1], &one, &fault));
    }
    for (size_t k = 0; k < s.path.count; k++) {
      const sepax_size_request request = {.latency = 100};
      sepax_design design =
          design_of("--word=%d --ii=3 --tree=on --clearance=%d --warning=%d",
                    limited[1].trees->word, limited[1].clearance, limited[1].warning);
      sepax_tree_run run;
      assert_works(
          sepax__size_trees_walk(limited[1].trees, &design.config, k, &request, &run, &fault));
      assert_int_equal(run.near, limited[0].workload[k].candidates);
      near[0] += run.near;
      near[1] += s.size.workload[k].candidates;
    }
    sepax_size_free(&limited[0]);
    sepax_size_free(&limited[1]);
  }
  sepax_size_free(&s.size);
  assert_true(near[0] > near[1] + FEWER(1000) && near[1] > FEWER(1000));
}

/* Bodies that are larger than the memories. */
CASE(test_loading) {
  static scene s;
  for (int n = 0; n < 300; n++) {
    sepax_config config = sepax_config_default();
    for (int i = 0; i < 2; i++) {
      int more = random_below(MOST_FACETS);
      s.mesh[i].count = 1 + (size_t)more;
    }
    const size_t count[2] = {s.mesh[0].count, s.mesh[1].count};
    config.lanes = 1;
    config.memory_a = 1 + random_below(MOST_FACETS);
    config.memory_b = 1 + random_below(MOST_FACETS);
    assert_int_equal(sepax__workload_loading(count, &config), vertices_sent(&s, &config));
  }
}

/* Jobs of many pairs are not looked for: then no engine of lanes is taken, and the time that is
 * told is a bound. A word above 21 bits leaves no tree engine. */
CASE(test_left_out) {
  static scene s;
  draw_scene(&s, MOST_FACETS);
  sepax_space space = {.resolution = 1, .path = &s.path, .pairs_most = 1};
  sepax_size_request request = {.seconds = 1, .clock_ps = 2000, .lanes_most = SEPAX_LANES_MAX};
  sepax_sized_design m;
  sepax_size_free(&s.size);
  while (s.mesh[0].count * s.mesh[1].count < 2) {
    draw_body(&s, 0, MOST_FACETS, 20);
  }
  assert_works(sepax_size_scene(&s.size, &s.mesh[0], &s.mesh[1], &space, &fault));
  assert_int_equal(s.size.workloads, 0);
  assert_fault(sepax_size_design(&m, &s.size, &request, &fault), "of up to 64 lanes takes");
  assert_int_equal(fault.code, SEPAX_ERROR_NONE_FITS);
  request.tree = true;
  assert_works(sepax_size_design(&m, &s.size, &request, &fault));
  assert_true(m.config.tree);
  sepax_size_free(&s.size);
  space.resolution = 1e-6;
  assert_works(sepax_size_scene(&s.size, &s.mesh[0], &s.mesh[1], &space, &fault));
  assert_null(s.size.trees);
  request.lanes_least = 1;
  request.lanes_most = 0;
  assert_fault(sepax_size_design(&m, &s.size, &request, &fault), "at most 21 bits");
  sepax_size_free(&s.size);
  space.path = &(sepax_poses){NULL, 0};
  assert_fault(sepax_size_scene(&s.size, &s.mesh[0], &s.mesh[1], &space, &fault),
               "poses: the path has no poses");
}
