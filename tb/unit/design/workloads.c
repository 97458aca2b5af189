/* SPDX-License-Identifier: MIT */
/* workloads.c - the design that sepax_size_design finds, against all designs that there are, each
 * timed cycle by cycle. */
#include "size/workloads.h"
#include "oracle/geometry.h"
#include "oracle/pair_tools.h"
#include "ticks.h"
#include "harness.h"

#include <math.h>
#include <stdio.h>

enum { MOST_TRIANGLES = 150 };

/* Every design that there is for a scene, and its cycles by taking one at a time, in the pose of
 * the scene that takes the most. */
typedef struct {
  sepax_config config;
  double gates;
  unsigned long long cycles;
} option;

enum { MOST_OPTIONS = 2 * 7 * (1 + SEPAX_LANES_MAX * SEPAX_CORES_MAX), MOST_POSES = 2 };

typedef struct {
  sepax_size size;
  sepax_tri tri[MOST_POSES][2][MOST_TRIANGLES];
  bool candidate[MOST_POSES][MOST_TRIANGLES * MOST_TRIANGLES];
  option all[MOST_OPTIONS];
  size_t options, poses;
} designs;

static void find_candidates(designs *d, size_t pose) {
  size_t count_b = d->size.count[1];
  for (size_t n = 0; n < d->size.count[0] * count_b; n++) {
    sepax_pair pair = {.a = d->tri[pose][0][n / count_b], .b = d->tri[pose][1][n % count_b]};
    d->candidate[pose][n] = aabbs_overlap(&pair, 32);
  }
}

static unsigned long long most(unsigned long long a, unsigned long long b) { return a > b ? a : b; }

static void add_options(designs *d, int lanes, unsigned *steps) {
  static const int intervals[] = {1, 2, 3, 4, 6, 9, 18};
  const sepax_size *size = &d->size;
  for (size_t n = 0; n<LENGTH(intervals) * SEPAX_CORES_MAX; n += lanes> 0 ? 1 : SEPAX_CORES_MAX) {
    int cores = 1 + (int)n % SEPAX_CORES_MAX;
    int ii = intervals[n / SEPAX_CORES_MAX];
    unsigned long long cycles = 0;
    for (size_t pose = 0; pose < d->poses && lanes > 0; pose++) {
      ticks_workload workload = {d->candidate[pose], size->count[0], size->count[1]};
      size_t count = ticks_walk(&workload, (size_t)lanes, steps);
      cycles = most(cycles, ticks(steps, count, (unsigned)ii, (size_t)cores));
    }
    const int kinds = size->core_word < size->grid.word ? 2 : 1;
    for (int extents = 0; extents < kinds; extents++) {
      sepax_design design =
          design_of("--word=%d --ii=%d --extent-a=%d --extent-b=%d --lanes=%d --cores=%d",
                    size->grid.word, ii, extents != 0 ? (int)size->extent[0] : 0,
                    extents != 0 ? (int)size->extent[1] : 0, lanes, cores);
      double unread;
      for (size_t pose = 0; pose < d->poses && lanes == 0; pose++) {
        unsigned long long pairs = size->count[0] * size->count[1];
        cycles = pose == 0 ? 0 : cycles;
        cycles = most(cycles, pairs * (unsigned)ii);
      }
      d->all[d->options++] = (option){design.config, sepax_gates(&design, &unread), cycles};
    }
  }
}

/* Up to `count` triangles of all kinds with whole coordinates, many of them upright in one plane,
 * some vertical lines; in odd scenes B moves to another pose. */
static void draw_scene(designs *d, int n, int count) {
  static sepax_facet facet[2][MOST_TRIANGLES];
  sepax_soup mesh[2];
  sepax_space space = {.resolution = 1, .offset_given = true, .poses = 3, .seed = 1};
  int spread = n % 5 == 0 ? 1 : random_below(100);
  int scale = n % 5 < 2 ? 1000 : 1; /* to 18 bits, where two cores may be cheaper than a fast one */
  int shift = n % 2 == 0 ? 0 : scale * (random_below(60) - 30);
  d->poses = n % 2 == 0 ? 1 : 2;
  for (int i = 0; i < 2; i++) {
    mesh[i] = (sepax_soup){.facet = facet[i],
                           .count = (size_t)(1 + random_below(n % 3 == 0 ? 5 : count))};
    for (size_t k = 0; k < 9 * mesh[i].count; k++) {
      int axis = (int)k % 3;
      size_t m = k / 9;
      int32_t c = (int32_t)(m * 37 % 11) * spread * (axis + 1) % 200 + random_below(40);
      c = axis == 0 && m % 4 == 0 ? 7 : axis == 1 && m % 12 == 0 ? 9 : c;
      c *= scale;
      facet[i][m].v[k / 3 % 3][axis] = c;
      *coordinate(&d->tri[0][i][m].v[k / 3 % 3], axis) = c;
      *coordinate(&d->tri[1][i][m].v[k / 3 % 3], axis) = c + (i == 1 && axis == n % 3 ? shift : 0);
    }
  }
  space.motion[1].low[n % 3] = shift;
  space.motion[1].high[n % 3] = shift;
  sepax_size_free(&d->size);
  assert_works(sepax_size_scene(&d->size, &mesh[0], &mesh[1], &space, &fault));
  for (size_t pose = 0; pose < d->poses; pose++) {
    find_candidates(d, pose);
  }
}

static void draw_designs(designs *d, int n) {
  draw_scene(d, n, 60);
  unsigned *steps =
      malloc(sizeof *steps * (MOST_TRIANGLES + SEPAX_LANES_MAX) * (MOST_TRIANGLES + 2));
  assert_non_null(steps);
  d->options = 0;
  for (int lanes = 0; lanes <= SEPAX_LANES_MAX; lanes++) {
    add_options(d, lanes, steps);
  }
  free(steps);
}

static unsigned long long ticks_of_part(const designs *d, size_t i, size_t j,
                                        const size_t memory[2], const sepax_config *config,
                                        unsigned *steps) {
  static bool candidate[MOST_TRIANGLES * MOST_TRIANGLES];
  const size_t *count = d->size.count;
  ticks_workload workload = {candidate, count[0] - i < memory[0] ? count[0] - i : memory[0],
                             count[1] - j < memory[1] ? count[1] - j : memory[1]};
  for (size_t n = 0; n < workload.count_a * workload.count_b; n++) {
    candidate[n] =
        d->candidate[0][(i + n / workload.count_b) * count[1] + j + n % workload.count_b];
  }
  size_t end = ticks_walk(&workload, (size_t)config->lanes, steps);
  return ticks(steps, end, (unsigned)config->ii, (size_t)config->cores);
}

static const option *cheapest(const designs *d, unsigned long long limit, int least, int last) {
  const option *best = NULL;
  for (size_t n = 0; n < d->options; n++) {
    const option *o = &d->all[n];
    if (o->config.lanes >= least && o->config.lanes <= last && o->cycles <= limit &&
        (best == NULL || o->gates < best->gates)) {
      best = o;
    }
  }
  return best;
}

static unsigned long long fewest_cycles(const designs *d, int least, int last) {
  unsigned long long fewest = ~0ull;
  for (size_t n = 0; n < d->options; n++) {
    const option *o = &d->all[n];
    bool counts = o->config.lanes >= least && o->config.lanes <= last;
    fewest = counts && o->cycles < fewest ? o->cycles : fewest;
  }
  return fewest;
}

static bool sized(sepax_sized_design *m, const sepax_size *size, double seconds, int least,
                  int last) {
  const sepax_size_request request = {
      .seconds = seconds, .clock_ps = 2000, .lanes_least = least, .lanes_most = last};
  return sepax_size_design(m, size, &request, &fault);
}

/* The cheapest design that is in time of all that there are, each with its cycles one by one. */
CASE(test_cheapest) {
  static designs d; /* large */
  size_t found = 0;
  size_t several_cores = 0;
  for (int n = 0; n < FEWER(24); n++) {
    draw_designs(&d, n);
    for (int k = 0; k < 12; k++) {
      int least = random_below(2) * random_below(SEPAX_LANES_MAX + 1);
      int last = k % 4 == 0 ? least : least + random_below(SEPAX_LANES_MAX + 1 - least);
      const option *at = &d.all[random_below((int)d.options)];
      while (k % 2 == 0 && at->config.ii * 6 < at->config.cores * 18) { /* a busy core */
        at = &d.all[random_below((int)d.options)];
      }
      unsigned long long limit = at->cycles - (unsigned)random_below(2);
      const option *best = cheapest(&d, limit, least, last);
      double seconds = (double)limit * 2e-9;
      sepax_sized_design m;
      bool ok = sized(&m, &d.size, seconds, least, last);
      assert_int_equal(ok, best != NULL);
      if (!ok || best == NULL) {
        char told[80];
        snprintf(told, sizeof told, "of up to %d lanes takes %.4g ms", last,
                 2e-6 * (double)fewest_cycles(&d, least, last));
        assert_message(told);
        continue;
      }
      assert_true(fabs(m.gates - best->gates) <= 1e-9 * best->gates);
      assert_int_equal(m.cycles, best->cycles);
      assert_int_equal(m.config.lanes, best->config.lanes);
      assert_int_equal(m.config.ii, best->config.ii);
      found++;
      several_cores += m.config.cores > 1;
    }
  }
  sepax_size_free(&d.size);
  assert_true(found > FEWER(100) && several_cores > 0);
}

/* Objects that are larger than their memories go through them in parts; and the golden model, which
 * has the triangles, says the same. */
CASE(test_parts) {
  static designs d; /* large */
  unsigned *steps =
      malloc(sizeof *steps * (MOST_TRIANGLES + SEPAX_LANES_MAX) * (MOST_TRIANGLES + 2));
  uint64_t *space = malloc(sizeof *space * 2 * MOST_TRIANGLES * MOST_TRIANGLES);
  assert_true(steps != NULL && space != NULL);
  for (int n = 0; n < FEWER(40); n++) {
    static const int32_t still[3] = {0, 0, 0};
    draw_scene(&d, 2 * n, MOST_TRIANGLES);
    sepax_design design =
        design_of("--word=%d --lanes=%d --cores=%d --ii=%d", d.size.grid.word,
                  1 + random_below(SEPAX_LANES_MAX), 1 + random_below(8), 1 + random_below(18));
    sepax_config config = design.config;
    sepax_object_run run;
    const sepax_size *size = &d.size;
    assert_works(sepax_object_engine(&design, d.tri[0][0], size->count[0], d.tri[0][1],
                                     size->count[1], still, &run, &fault));
    assert_int_equal(sepax__workload_cycles(&size->workload[0], size->count, &config, space),
                     run.cycles);
    assert_int_equal(size->workload[0].candidates, run.candidates);
    sepax_pairs_free(&run.found);
    config.memory_a = 1 + random_below(MOST_TRIANGLES);
    config.memory_b = 1 + random_below(MOST_TRIANGLES);
    unsigned long long cycles = 0;
    size_t memory[2] = {(size_t)config.memory_a, (size_t)config.memory_b};
    for (size_t i = 0; i < size->count[0]; i += memory[0]) {
      for (size_t j = 0; j < size->count[1]; j += memory[1]) {
        cycles += ticks_of_part(&d, i, j, memory, &config, steps);
      }
    }
    assert_int_equal(sepax__workload_cycles(&size->workload[0], size->count, &config, space),
                     cycles);
    assert_true(sepax__workload_least_cycles(size->workload[0].candidates, size->count, &config) <=
                cycles);
  }
  sepax_size_free(&d.size);
  free(steps);
  free(space);
}

/* The paper's scene: 160,000 pairs in 0.96 ms at 2 ns are II = 3. */
CASE(test_workloads) {
  sepax_workload workload = {0};
  sepax_size size = {.grid = {.word = 18},
                     .count = {400, 400},
                     .extent = {60000, 60000},
                     .core_word = 18,
                     .workload = &workload,
                     .workloads = 1};
  sepax_sized_design m;
  assert_works(sized(&m, &size, 0.96e-3, 0, 0));
  assert_int_equal(m.config.ii, 3);
  assert_int_equal(m.cycles, 480000);
  assert_int_equal(m.config.extent_a, 0);
  size.count[0] = 40000;
  size.count[1] = 70000;
  assert_works(sized(&m, &size, 1, 10, 10));
  assert_int_equal(m.config.memory_a, 32768);
  assert_int_equal(m.config.memory_b, 32768);
  assert_int_equal(m.cycles, (3277 + 724) * UINT64_C(70000) + 3 * (7 + 5) + 3 * (1 + 5));
}
