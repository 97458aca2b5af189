/* SPDX-License-Identifier: MIT */
/* ulx3s.c - two STL files on the engine of a board: the pairs of triangles that collide.
 *   ulx3s [--port=/dev/ttyUSB0] [--baud=3000000] [--resolution=LENGTH] [--check] A.stl B.stl
 * --check compares every pair in its order, all counts and the cycles with the golden model. Exit
 * status: 0 none collides, 1 some do, 2 an error, 3 the board and the golden model differ. */
#include "board.h"
#include "sepax_design.h"
#include "sepax_params.h"

#include <argp.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#ifndef BOARD_NAME /* of the program */
#define BOARD_NAME "ulx3s"
#define BOARD_PORT "/dev/ttyUSB0"
#endif
#ifndef BOARD_RESULTS
#define BOARD_RESULTS 12 /* log2 of the results that wait without holding up a run */
#endif

typedef struct {
  const char *port, *path[2];
  unsigned long baud;
  double resolution;
  bool check;
} settings;

/* Pairs as the board finds them, and what the golden model expects. */
typedef struct {
  const sepax_object_run *golden; /* NULL: nothing is compared */
  size_t seen;
  bool differs;
} progress;

static error_t parse(int key, char *text, struct argp_state *state) {
  settings *s = state->input;
  char *end = text;
  switch (key) {
  case 'p':
    s->port = text;
    return 0;
  case 'b':
    s->baud = strtoul(text, &end, 10);
    if (end == text || *end != '\0') {
      argp_error(state, "baud: '%s' is no number", text);
    }
    return 0;
  case 'r':
    s->resolution = strtod(text, &end);
    if (*end != '\0' || !(s->resolution > 0)) {
      argp_error(state, "resolution: '%s' is not a length above 0", text);
    }
    return 0;
  case 'c':
    s->check = true;
    return 0;
  case ARGP_KEY_ARG:
    if (state->arg_num > 1) {
      argp_error(state, "unexpected argument '%s': give two STL files", text);
    } else {
      s->path[state->arg_num] = text;
    }
    return 0;
  case ARGP_KEY_END:
    if (state->arg_num < 2) {
      argp_error(state, "give two STL files");
    }
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

static int error_of(const char *what, const char *why) {
  fprintf(stderr, BOARD_NAME ": %s%s%s\n", what, why[0] != '\0' ? ": " : "", why);
  return 2;
}

static bool print(void *context, const sepax_hit *hit) {
  progress *p = context;
  const sepax_object_run *golden = p->golden;
  printf("%zu %zu%s\n", hit->a, hit->b,
         hit->out_of_range ? " undecided"
         : hit->warning    ? " too near"
                           : "");
  if (golden != NULL) {
    const size_t *pair = p->seen < golden->found.count ? golden->found.pair[p->seen] : NULL;
    if (!p->differs && (pair == NULL || pair[0] != hit->a || pair[1] != hit->b)) {
      fprintf(stderr, BOARD_NAME ": pair %zu is %zu %zu, by the golden model %s\n", p->seen, hit->a,
              hit->b, pair == NULL ? "there is none" : "another");
      p->differs = true;
    }
  }
  p->seen++;
  return true;
}

static void compare(progress *p, const char *what, uint64_t got, uint64_t golden) {
  if (got != golden) {
    fprintf(stderr, BOARD_NAME ": %s: %llu, by the golden model %llu\n", what,
            (unsigned long long)got, (unsigned long long)golden);
    p->differs = true;
  }
}

/* Counts and cycles of a run; these as exactly as sepax_object_run says, unless a result had to
 * wait for the line. */
static void compare_counts(progress *p, const sepax_counts *counts) {
  const sepax_object_run *g = p->golden;
  compare(p, "results", p->seen, g->found.count);
  compare(p, "pairs", counts->pairs, g->pairs);
  compare(p, "candidates", counts->candidates, g->candidates);
  compare(p, "collisions", counts->collisions, g->collisions);
  compare(p, "out of range", counts->out_of_range, g->out_of_range);
  uint64_t slack = 20 + 4 * SEPAX_II + g->cycles / 100;
  uint64_t more = SEPAX_II * (g->passes - g->candidates);
  if (g->found.count <= UINT64_C(1) << BOARD_RESULTS &&
      (counts->cycles > g->cycles + slack + more || counts->cycles + slack < g->cycles)) {
    compare(p, "cycles", counts->cycles, g->cycles);
  }
}

static int32_t (*columns(const sepax_tri *tri, size_t count))[9] {
  int32_t(*flat)[9] = calloc(count + 1, sizeof *flat);
  for (size_t i = 0; flat != NULL && i < 3 * count; i++) {
    const sepax_vec *v = &tri[i / 3].v[i % 3];
    int32_t *c = flat[i / 3] + 3 * (i % 3);
    c[0] = v->x;
    c[1] = v->y;
    c[2] = v->z;
  }
  return flat;
}

static bool golden_run(sepax_object_run *run, const sepax_scene *scene, sepax_error *error) {
  static const int32_t still[3] = {0, 0, 0};
  sepax_config config = sepax_config_default();
  sepax_design design;
  if (!sepax_config_parse(&config, SEPAX_OPTIONS, error) ||
      !sepax_design_init(&design, &config, error)) {
    return false;
  }
  design.latency = SEPAX_LATENCY;
  return sepax_object_engine(&design, scene->tri[0], scene->count[0], scene->tri[1],
                             scene->count[1], still, run, error);
}

static double milliseconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return 1e3 * (double)now.tv_sec + 1e-6 * (double)now.tv_nsec;
}

static int run_board(board *b, const settings *s, const sepax_scene *scene, progress *p) {
  int32_t(*triangles_a)[9] = columns(scene->tri[0], scene->count[0]);
  int32_t(*triangles_b)[9] = columns(scene->tri[1], scene->count[1]);
  sepax_device device;
  sepax_counts counts = {0};
  const sepax_bus bus = board_bus(b);
  sepax_status status = sepax_device_open(&device, &bus);
  double begin = milliseconds();
  if (status == SEPAX_DRIVER_OK && triangles_a != NULL && triangles_b != NULL) {
    status = sepax_device_collide(&device, triangles_a, scene->count[0], triangles_b,
                                  scene->count[1], false, print, p, &counts);
  }
  double took = milliseconds() - begin;
  bool ok = triangles_a != NULL && triangles_b != NULL;
  free(triangles_a);
  free(triangles_b);
  if (!ok) {
    return error_of("out of memory", "");
  }
  if (status != SEPAX_DRIVER_OK) {
    return error_of(sepax_status_text(status), board_error(b));
  }
  fprintf(stderr,
          BOARD_NAME
          ": %zu x %zu triangles: %llu pairs, %llu to the core, %llu collide\n" BOARD_NAME
          ": %llu cycles at %g MHz = %.4f ms; %.0f ms with the serial line\n" BOARD_NAME
          ": %llu bytes to the board, %llu back; at %lu baud the line takes %.0f ms\n",
          scene->count[0], scene->count[1], (unsigned long long)counts.pairs,
          (unsigned long long)counts.candidates, (unsigned long long)counts.collisions,
          (unsigned long long)counts.cycles, 1e-6 * b->clock_hz,
          1e3 * (double)counts.cycles / b->clock_hz, took, (unsigned long long)b->sent,
          (unsigned long long)b->came, s->baud, 1e4 * (double)b->sent / (double)s->baud);
  if (p->golden != NULL) {
    compare_counts(p, &counts);
    fprintf(stderr, BOARD_NAME ": %s\n",
            p->differs ? "the golden model differs" : "as the golden model");
  }
  return p->differs ? 3 : counts.collisions > 0;
}

int main(int argc, char **argv) {
  static const struct argp_option options[] = {
      {"port", 'p', "PATH", 0, "the board's serial line (" BOARD_PORT ")", 0},
      {"baud", 'b', "RATE", 0, "its rate, that of the bitstream (3000000)", 0},
      {"resolution", 'r', "LENGTH", 0, "length of one LSB (the finest that holds both)", 0},
      {"check", 'c', NULL, 0, "compare all with the golden model", 0},
      {0}};
  static const struct argp argp = {options,
                                   parse,
                                   "A.stl B.stl",
                                   "Print the pairs of triangles that collide, found by the engine "
                                   "of a board.",
                                   NULL,
                                   NULL,
                                   NULL};
  settings s = {.port = BOARD_PORT, .baud = 3000000};
  argp_parse(&argp, argc, argv, 0, NULL, &s);
  sepax_error error = {0};
  sepax_scene scene;
  const sepax_grid grid = {s.resolution, {0, 0, 0}, SEPAX_WORD};
  if (!sepax_scene_load(&scene, s.path, &grid, false, &error)) {
    return error_of(error.text, "");
  }
  sepax_object_run golden;
  progress p = {NULL, 0, false};
  int status = 0;
  board b = {.line = -1};
  if (s.check) {
    p.golden = &golden;
    status = golden_run(&golden, &scene, &error) ? 0 : error_of(error.text, "");
  }
  if (status == 0) {
    status = board_open(&b, s.port, s.baud) ? run_board(&b, &s, &scene, &p)
                                            : error_of(board_error(&b), "");
    if (s.check) {
      sepax_pairs_free(&golden.found);
    }
  }
  board_close(&b);
  sepax_scene_free(&scene);
  return status;
}
