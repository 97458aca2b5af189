/* SPDX-License-Identifier: MIT */
/* bench.c - checks the verilated sepax_engine against its golden model.
 *   engine [--stress=SEED] [--resolution=LENGTH] [--wave=FILE] A.stl B.stl
 *   engine [--stress=SEED] [--rounds=N] [--beats=N] [--size=N] [--blocked=N] [--wave=FILE]
 * The first: the meshes, part by part if the memories are smaller. The second: N rounds of
 * seeded objects of all families and sizes, moves, first hits and stops, and more rounds until N
 * transfers were made; objects of N (100) triangles of which all AABBs overlap; then what is
 * refused, interrupts, and a run of which nobody takes results for N (5000) cycles. Exit status 1:
 * something was wrong. */
#include "bench.h"
#include "meshes.h"
#include "sepax_vectors.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

sepax_device device;
static sepax_design design;
static unsigned long long wrong;

static void complain(const char *what, unsigned long long got, unsigned long long wanted) {
  if (wrong++ < 20) {
    fprintf(stderr, "engine: %s: %llu, expected %llu\n", what, got, wanted);
  }
}

void expect(const char *what, unsigned long long got, unsigned long long wanted) {
  if (got != wanted) {
    complain(what, got, wanted);
  }
}

static void check(sepax_status status, const char *what) {
  if (status != SEPAX_DRIVER_OK) {
    fprintf(stderr, "engine: %s: %s\n", what, sepax_status_text(status));
    wrong++;
  }
}

static _Noreturn void stop(const char *text) {
  fprintf(stderr, "engine: %s\n", text);
  exit(2);
}

static void stop_on(bool failed, const char *text) {
  if (failed) {
    stop(text);
  }
}

/* Triangles as the driver takes them. */
static int32_t (*columns(const sepax_tri *tri, size_t count))[9] {
  int32_t(*flat)[9] = malloc(count * sizeof *flat);
  if (flat == NULL) {
    stop("out of memory");
  }
  for (size_t i = 0; i < count; i++) {
    for (int k = 0; k < 3; k++) {
      const sepax_vec *v = &tri[i].v[k];
      flat[i][3 * k] = v->x;
      flat[i][3 * k + 1] = v->y;
      flat[i][3 * k + 2] = v->z;
    }
  }
  return flat;
}

/* What the golden model says, and how far the engine is in it. */
typedef struct {
  sepax_object_run run;
  size_t seen;
  const task *task;
} expected;

static bool see(void *context, const sepax_hit *hit) {
  expected *e = context;
  if (e->seen >= e->run.found.count) {
    complain("a result too many, from A", hit->a, 0);
    e->seen++;
    return true;
  }
  const size_t *pair = e->run.found.pair[e->seen++];
  if (hit->a != pair[0] || hit->b != pair[1]) {
    complain("pair of A", hit->a, pair[0]);
    complain("pair of B", hit->b, pair[1]);
    return true;
  }
  const task *t = e->task;
  sepax_pair judged = {.a = t->a[hit->a], .b = t->b[hit->b]};
  bool within = true;
  for (int k = 0; k < 3; k++) {
    int32_t *c[3] = {&judged.b.v[k].x, &judged.b.v[k].y, &judged.b.v[k].z};
    for (int i = 0; i < 3; i++) {
      int64_t moved = (int64_t)*c[i] + t->move[i];
      within = within && moved >= sepax_word_min(SEPAX_WORD) && moved <= sepax_word_max(SEPAX_WORD);
      *c[i] = (int32_t)moved;
    }
  }
  sepax_judgement v = {0};
  if (within) {
    v = sepax_judge(&design, &judged);
  }
  bool undecided = !within || v.axis == SEPAX_AXIS_EXTENT;
  bool warning = design.limits > 0 && !undecided && v.band == SEPAX_BAND_WARNING;
  expect("warning of a result", hit->warning, warning);
  expect("out_of_range of a result", hit->out_of_range, undecided);
  expect("coplanar of a result", hit->coplanar, v.coplanar && !undecided);
  return true;
}

/* Behind a gap the two stages of a core's AABB test take a pair in another window. */
#ifdef SEPAX_BOXES
enum { COUNTED = 0 };
#else
enum { COUNTED = 1 };
#endif

static void compare_cycles(uint64_t cycles, const sepax_object_run *run, const task *t) {
  bool fpga = design.config.target != SEPAX_TARGET_ASIC;
  uint64_t slack = 20 + 4 * SEPAX_II + run->cycles / 10;
  if (cycles > run->cycles + slack || cycles + slack < run->cycles) {
    complain("cycles (to 10 %, 20 and 4 II)", cycles, run->cycles);
  }
  if (!fpga && SEPAX_CORES == 1 && COUNTED) {
    uint64_t least = cycles_of_run(t->a, t->count_a, t->b, t->count_b, t->move, design.margin[1]);
    if (cycles != least) {
      complain("cycles", cycles, least);
    }
  }
}

sepax_counts run_task(const task *t, bool paced) {
  sepax_error error = {0};
  expected e = {.task = t};
  sepax_counts counts = {0};
  stop_on(
      !sepax_object_engine(&design, t->a, t->count_a, t->b, t->count_b, t->move, &e.run, &error),
      error.text);
  int32_t(*a)[9] = columns(t->a, t->count_a);
  int32_t(*b)[9] = columns(t->b, t->count_b);
  static bool b_first;
  b_first = !b_first;
  for (int n = 0; n < 2; n++) {
    bool of_b = b_first == (n == 0);
    check(sepax_device_load(&device, of_b, of_b ? b : a, of_b ? t->count_b : t->count_a), "load");
  }
  check(sepax_device_move(&device, t->move), "move");
  check(sepax_device_run(&device, t->first, see, &e, &counts), "run");
  bool early = t->first && e.run.collisions > 0;
  expect("results", e.seen, early ? e.run.first + 1 : e.run.found.count);
  expect("collisions", counts.collisions, early ? 1 : e.run.collisions);
  expect("warnings", counts.warnings, early ? e.run.first : e.run.found.count - e.run.collisions);
  if (!early) {
    expect("pairs", counts.pairs, e.run.pairs);
    expect("candidates", counts.candidates, e.run.candidates);
    expect("out of range", counts.out_of_range, e.run.out_of_range);
    uint32_t status = 0;
    expect("STATUS can be read", bus_read(NULL, SEPAX_STATUS, &status), 1);
    expect("STATUS", status & (SEPAX_STATUS_HIT | SEPAX_STATUS_OUT_OF_RANGE | SEPAX_STATUS_STOPPED),
           (e.run.collisions > 0 ? SEPAX_STATUS_HIT : 0) |
               (e.run.out_of_range > 0 ? SEPAX_STATUS_OUT_OF_RANGE : 0));
  }
  if (e.run.collisions > 0) {
    uint32_t a_number = 0;
    uint32_t b_number = 0;
    bool ok = bus_read(NULL, SEPAX_FIRST_A, &a_number) && bus_read(NULL, SEPAX_FIRST_B, &b_number);
    expect("FIRST can be read", ok, 1);
    expect("FIRST_A", a_number, e.run.found.pair[e.run.first][0]);
    expect("FIRST_B", b_number, e.run.found.pair[e.run.first][1]);
  }
  if (paced && !early) {
    compare_cycles(counts.cycles, &e.run, t);
  }
  free(a);
  free(b);
  sepax_pairs_free(&e.run.found);
  return counts;
}

/* ------------------------------------------------------------------------ meshes */

typedef struct {
  sepax_pairs golden;
  unsigned char *there; /* found by the engine */
} whole;

static int by_numbers(const void *left, const void *right) {
  const size_t *l = left;
  const size_t *r = right;
  return l[0] != r[0] ? (l[0] < r[0] ? -1 : 1) : l[1] != r[1] ? (l[1] < r[1] ? -1 : 1) : 0;
}

static bool tick_off(void *context, const sepax_hit *hit) {
  whole *w = context;
  const size_t key[2] = {hit->a, hit->b};
  const size_t(*at)[2] =
      bsearch(key, w->golden.pair, w->golden.count, sizeof *w->golden.pair, by_numbers);
  if (at == NULL) {
    complain("a false alarm with triangle of A", hit->a, 0);
  } else if (w->there[at - w->golden.pair]++ != 0) {
    complain("a pair came twice, of A", hit->a, 0);
  }
  return true;
}

/* Both meshes against sepax_colliding_pairs, which enumerates no pairs as the engine does. */
static void run_meshes(const char *const path[2], double resolution, bool paced) {
  sepax_error error = {0};
  sepax_scene scene;
  const sepax_grid grid = {resolution, {0, 0, 0}, SEPAX_WORD};
  stop_on(!mesh_files_scene(&scene, path, &grid, false, &error), error.text);
  printf("%s\n", SEPAX_OPTIONS);
  mesh_files_print(&scene, path);
  whole w = {.there = NULL};
  bool ok = design.limits > 0
                ? sepax_near_pairs(&design, false, scene.tri[0], scene.count[0], scene.tri[1],
                                   scene.count[1], NULL, &w.golden, &error)
                : sepax_colliding_pairs(scene.tri[0], scene.count[0], scene.tri[1], scene.count[1],
                                        NULL, &w.golden, &error);
  stop_on(!ok, error.text);
  w.there = calloc(w.golden.count + 1, 1);
  stop_on(w.there == NULL, "out of memory");
  int32_t(*a)[9] = columns(scene.tri[0], scene.count[0]);
  int32_t(*b)[9] = columns(scene.tri[1], scene.count[1]);
  sepax_counts counts = {0};
  static const int32_t still[3] = {0, 0, 0};
  uint64_t begin = bus_cycles();
  check(sepax_device_move(&device, still), "move");
  check(sepax_device_collide(&device, a, scene.count[0], b, scene.count[1], false, tick_off, &w,
                             &counts),
        "collide");
  uint64_t all = bus_cycles() - begin;
  for (size_t i = 0; i < w.golden.count; i++) {
    if (w.there[i] == 0) {
      complain("a missed collision of A", w.golden.pair[i][0], 0);
    }
  }
  expect("pairs", counts.pairs, scene.count[0] * scene.count[1]);
  expect("collisions and warnings", counts.collisions + counts.warnings, w.golden.count);
  if (design.limits > 0) {
    printf("%llu warnings\n", (unsigned long long)counts.warnings);
  }
  printf("%zu x %zu triangles: %llu pairs, %llu candidates, %llu collisions, %llu wrong\n",
         scene.count[0], scene.count[1], (unsigned long long)counts.pairs,
         (unsigned long long)counts.candidates, (unsigned long long)counts.collisions, wrong);
  printf("K = %d, II = %d: %llu cycles = %.4f ms at %g ns, with loading %llu = %.4f ms\n",
         SEPAX_LANES, SEPAX_II, (unsigned long long)counts.cycles,
         1e-9 * (double)counts.cycles * design.config.clock_ps, 1e-3 * design.config.clock_ps,
         (unsigned long long)all, 1e-9 * (double)all * design.config.clock_ps);
  if (scene.count[0] <= device.capacity[0] && scene.count[1] <= device.capacity[1]) {
    const task t = {scene.tri[0], scene.tri[1], scene.count[0], scene.count[1], {0, 0, 0}, false};
    run_task(&t, paced);
  }
  free(w.there);
  free(a);
  free(b);
  sepax_pairs_free(&w.golden);
  sepax_scene_free(&scene);
}

/* ------------------------------------------------------------------------ rounds */

static sepax_random rng;

int64_t range(int64_t lo, int64_t hi) { return sepax_random_range(&rng, lo, hi); }

static size_t families(void) {
  size_t count = 0;
  while (sepax_family_name(count) != NULL) {
    count++;
  }
  return count;
}

/* Sizes that matter: one, about the lanes, the whole memory. */
static size_t some_count(size_t capacity) {
  switch (range(0, 7)) {
  case 0:
    return 1;
  case 1:
  case 2: {
    int64_t n = SEPAX_LANES * range(1, 3) + range(-1, 1);
    return n < 1 ? 1 : (size_t)n > capacity ? capacity : (size_t)n;
  }
  case 3:
    return capacity < 600 ? capacity : 130;
  default:
    return (size_t)range(1, capacity < 150 ? (int64_t)capacity : 150);
  }
}

static void some_object(sepax_tri *tri, size_t count, bool of_b) {
  size_t all = families();
  size_t family = (size_t)range(0, (int64_t)all);
  for (size_t i = 0; i < count; i++) {
    size_t f = family < all ? family : (size_t)range(0, (int64_t)all - 1);
    sepax_pair pair = sepax_family_triangles(f, SEPAX_WORD, &rng);
    tri[i] = of_b ? pair.b : pair.a;
  }
}

static void round_of(sepax_tri *a, sepax_tri *b, bool paced) {
  task t = {a,
            b,
            some_count(device.capacity[0]),
            some_count(device.capacity[1]),
            {0, 0, 0},
            range(0, 3) == 0};
  some_object(a, t.count_a, false);
  some_object(b, t.count_b, true);
  int64_t most = INT64_C(1) << SEPAX_WORD;
  switch (range(0, 3)) {
  case 0:
    for (int i = 0; i < 3; i++) {
      t.move[i] = (int32_t)range(-5, 5);
    }
    break;
  case 1:
    for (int i = 0; i < 3; i++) {
      t.move[i] = (int32_t)range(-most / 8 > INT32_MIN ? -most / 8 : INT32_MIN,
                                 most / 8 < INT32_MAX ? most / 8 : INT32_MAX);
    }
    break;
  case 2:
    t.move[range(0, 2)] = (int32_t)(range(0, 1) ? (most - 1 < INT32_MAX ? most - 1 : INT32_MAX)
                                                : (-most > INT32_MIN ? -most : INT32_MIN));
    break;
  default:
    break;
  }
  run_task(&t, paced);
}

/* A result, of which all bits that have no meaning are 0. */
static bool receive(void *context, uint64_t *result, bool *last) {
  bool ok = bus_receive(context, result, last);
  if (ok) {
    expect("bits of a result without a meaning", *last ? *result << 2 >> 34 : *result >> 59, 0);
    expect("the highest bit of a result", *result >> 63, *last);
  }
  return ok;
}

static bool number_after(const char *text, const char *name, unsigned long long *value) {
  size_t length = strlen(name);
  if (strncmp(text, name, length) != 0) {
    return false;
  }
  char *end;
  *value = strtoull(text + length, &end, 10);
  stop_on(end == text + length || *end != '\0',
          "--stress, --rounds, --beats, --size, --blocked are whole numbers");
  return true;
}

static void self_test(unsigned long long rounds, unsigned long long beats, size_t size,
                      unsigned long long blocked, bool paced) {
  sepax_tri *a = malloc(device.capacity[0] * sizeof *a);
  sepax_tri *b = malloc(device.capacity[1] * sizeof *b);
  stop_on(a == NULL || b == NULL, "out of memory");
  unsigned long long made = 0;
  while ((made < rounds || bus_beats() < beats) && wrong == 0) {
    round_of(a, b, paced);
    made++;
  }
  if (wrong == 0) {
    overlap(a, b, size, size, paced);
    objects(a, b, size, paced);
  }
  if (wrong == 0) {
    refusals();
    controls(a, b, blocked, paced);
  }
  printf("%llu rounds, %llu transfers, %llu cycles, %llu wrong\n", made,
         (unsigned long long)bus_beats(), (unsigned long long)bus_cycles(), wrong);
  free(a);
  free(b);
}

int main(int argc, char **argv) {
  const char *path[2] = {NULL, NULL};
  const char *wave = NULL;
  unsigned long long stress = 0;
  unsigned long long rounds = 20;
  unsigned long long beats = 0;
  unsigned long long size = 100;
  unsigned long long blocked = 5000;
  double resolution = 0;
  int paths = 0;
  for (int i = 1; i < argc; i++) {
    char *end = argv[i];
    if (number_after(argv[i], "--stress=", &stress) ||
        number_after(argv[i], "--rounds=", &rounds) || number_after(argv[i], "--beats=", &beats) ||
        number_after(argv[i], "--size=", &size) || number_after(argv[i], "--blocked=", &blocked) ||
        argv[i][0] == '+') {
      continue;
    }
    if (strncmp(argv[i], "--resolution=", 13) == 0) {
      resolution = strtod(argv[i] + 13, &end);
      stop_on(*end != '\0' || !(resolution > 0), "--resolution is a length above 0");
    } else if (strncmp(argv[i], "--wave=", 7) == 0) {
      wave = argv[i] + 7;
    } else {
      stop_on(argv[i][0] == '-' || paths == 2,
              "usage: engine [--stress=SEED] [--resolution=LENGTH] A.stl B.stl, "
              "or [--stress=SEED] [--rounds=N] [--beats=N] [--size=N] [--blocked=N]");
      path[paths++] = argv[i];
    }
  }
  stop_on(size == 0 || size > 128, "--size is 1 ... 128");
  stop_on(paths == 1, "give two meshes, or none");
  sepax_error error = {0};
  sepax_config config = sepax_config_default();
  stop_on(!sepax_config_parse(&config, SEPAX_OPTIONS, &error) ||
              !sepax_design_init(&design, &config, &error),
          error.text);
  design.latency = SEPAX_LATENCY;
  rng.state = 1 + stress;
  bus_arguments(argc, argv);
  bus_open(stress, wave);
  const sepax_bus bus = {NULL, bus_read, bus_write, bus_send, receive};
  check(sepax_device_open(&device, &bus), "open");
  expect("lanes", (unsigned long long)device.lanes, SEPAX_LANES);
  expect("capacity for A", device.capacity[0], SEPAX_MEMORY_A);
  expect("capacity for B", device.capacity[1], SEPAX_MEMORY_B);
  if (paths == 2) {
    run_meshes(path, resolution, stress == 0);
  } else {
    self_test(rounds, beats, size, blocked, stress == 0);
  }
  wrong += bus_breaches();
  bus_close();
  return wrong != 0;
}
