/* SPDX-License-Identifier: MIT */
/* batch.c - the batch and the search among meshes at length.
 *
 *   batch check COUNT           COUNT pairs of all families at W = 8, 18, 24, 32 each: every vector
 *                               path, and meshes halved and by brute force, against single verdicts
 *   batch scale                 time per pair over the number of pairs and of triangles
 *   batch meshes A.stl B.stl    halving, brute force and threads on two meshes */
#include "columns.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

static const sepax_simd paths[] = {SEPAX_SIMD_PORTABLE, SEPAX_SIMD_AVX2, SEPAX_SIMD_AVX512};
enum { PATHS = sizeof paths / sizeof paths[0], CHUNK = 1 << 14 };

/* --------------------------------------------------------------------- check */

static size_t family_count(void) {
  size_t families = 1;
  while (sepax_family_name(families) != NULL) {
    families++;
  }
  return families;
}

typedef struct {
  uint64_t collisions, wrong[PATHS];
} tally;

/* Batches have odd lengths, so that the last word of bits is partly used. */
static tally check_paths(int word, uint64_t count) {
  static bool exact[CHUNK];
  pair_columns batch = columns_of(CHUNK);
  sepax_random random = {(uint64_t)word};
  size_t families = family_count();
  size_t many = 0;
  tally t = {0};
  for (uint64_t done = 0; done < count; done += many) {
    many = (size_t)sepax_random_range(&random, CHUNK / 2, CHUNK);
    many = count - done < many ? (size_t)(count - done) : many;
    for (size_t n = 0; n < many; n++) {
      sepax_pair pair = sepax_family_triangles((done + n) % families, word, &random);
      columns_set(&batch, n, &pair);
      exact[n] = sepax_exact(&pair.a, &pair.b).collision;
      t.collisions += exact[n];
    }
    for (int p = 0; p < PATHS; p++) {
      if (sepax_simd_runs(paths[p])) {
        sepax_exact_pairs(paths[p], &batch.a, &batch.b, many, batch.bits);
        for (size_t n = 0; n < many; n++) {
          t.wrong[p] += bit_at(batch.bits, n) != exact[n];
        }
      }
    }
  }
  columns_free(&batch);
  return t;
}

/* How many entries differ between a list of pairs and the pairs of all triangles, one by one. */
static uint64_t count_wrong(const sepax_pairs *found, const sepax_tri *a, size_t count_a,
                            const sepax_tri *b, size_t count_b, const sepax_design *design) {
  uint64_t wrong = 0;
  size_t k = 0;
  for (size_t i = 0; i < count_a; i++) {
    for (size_t j = 0; j < count_b; j++) {
      bool expected = design != NULL ? sepax_clearance(design, &a[i], &b[j]).band != SEPAX_BAND_FREE
                                     : sepax_exact(&a[i], &b[j]).collision;
      bool listed = k < found->count && found->pair[k][0] == i && found->pair[k][1] == j;
      wrong += expected != listed;
      k += listed;
    }
  }
  return wrong + (found->count - k);
}

/* Meshes of 1 ... MOST triangles of all families, halved and by brute force: `count` pairs
 * of triangles at least. With a clearance the pairs that are not free, else those that collide. */
static uint64_t check_halving(int word, uint64_t count, int clearance) {
  enum { MOST = 300 };
  static sepax_tri a[MOST], b[MOST];
  sepax_random random = {(uint64_t)word};
  sepax_error error = {0};
  sepax_config config = sepax_config_default();
  config.word = word;
  config.clearance = clearance;
  const sepax_design design = design_from(config);
  size_t families = family_count();
  uint64_t wrong = 0;
  size_t drawn = 0;
  for (uint64_t done = 0; done < count;) {
    size_t count_a = (size_t)sepax_random_range(&random, 1, MOST);
    size_t count_b = (size_t)sepax_random_range(&random, 1, MOST);
    for (size_t n = 0; n < count_a || n < count_b; n++) {
      sepax_pair pair = sepax_family_triangles(drawn++ % families, word, &random);
      a[n] = pair.a;
      b[n] = pair.b;
    }
    if (drawn % 2 == 0) { /* its AABB is the whole range */
      const int32_t low = sepax_word_min(word);
      const int32_t high = sepax_word_max(word);
      a[0] = (sepax_tri){{{low, low, low}, {high, high, high}, {low, high, low}}};
    }
    for (int way = 0; way < 2; way++) {
      sepax_search how = {.size = sizeof(sepax_search), .threads = 2, .brute_force = way == 1};
      sepax_pairs found;
      if (clearance < 0
              ? !sepax_colliding_pairs(a, count_a, b, count_b, &how, &found, &error)
              : !sepax_near_pairs(&design, false, a, count_a, b, count_b, &how, &found, &error)) {
        bench_fail(&error);
      }
      wrong += count_wrong(&found, a, count_a, b, count_b, clearance < 0 ? NULL : &design);
      sepax_pairs_free(&found);
    }
    done += (uint64_t)count_a * count_b;
  }
  return wrong;
}

/* Halving costs a second verdict of every pair, with a clearance about 20 times as long a one. */
static int check(uint64_t count) {
  static const int words[] = {8, 18, 24, 32};
  enum { SHARE_HALVING = 10, SHARE_NEAR = 200 };
  uint64_t wrong = 0;
  for (size_t w = 0; w < sizeof words / sizeof words[0]; w++) {
    int word = words[w];
    tally t = check_paths(word, count);
    printf("W = %2d, %" PRIu64 " pairs, %" PRIu64 " collisions:", word, count, t.collisions);
    for (int p = 0; p < PATHS; p++) {
      if (sepax_simd_runs(paths[p])) {
        printf(" %s %" PRIu64 " wrong,", sepax_simd_name(paths[p]), t.wrong[p]);
      } else {
        printf(" %s not on this machine,", sepax_simd_name(paths[p]));
      }
      wrong += t.wrong[p];
    }
    uint64_t halved = check_halving(word, count / SHARE_HALVING + 1, -1);
    uint64_t near = check_halving(word, count / SHARE_NEAR + 1, 1 << (word - 4));
    printf(" halving %" PRIu64 " wrong, with a clearance %" PRIu64 " wrong\n", halved, near);
    fflush(stdout);
    wrong += halved + near;
  }
  return wrong == 0 ? 0 : 1;
}

/* --------------------------------------------------------------------- scale */

/* Each figure is the best of rounds for so many seconds; -q: of one. */
static double seconds_each = 0.5;

static void best_of(double *best, double took) {
  *best = *best == 0 || took < *best ? took : *best;
}

static void scale_pairs(void) {
  enum { MOST = 10000000 };
  pair_columns batch = columns_of(MOST);
  sepax_random random = {1};
  for (size_t n = 0; n < MOST; n++) {
    sepax_pair pair = sepax_family_triangles(n % 2, 18, &random);
    columns_set(&batch, n, &pair);
  }
  for (size_t count = 1000; count <= MOST; count *= 10) {
    double best = 0;
    size_t rounds = seconds_each > 0 ? 3 + 1000000 / count : 1;
    for (size_t round = 0; round < rounds; round++) {
      double start = seconds_now();
      sepax_exact_pairs(SEPAX_SIMD_BEST, &batch.a, &batch.b, count, batch.bits);
      best_of(&best, seconds_now() - start);
    }
    printf("pairs,%zu,%zu,%.6g,%.4g\n", count, count, best, 1e9 * best / (double)count);
    fflush(stdout);
  }
  columns_free(&batch);
}

static double search(const sepax_scene *s, int threads, bool brute_force, size_t *collisions) {
  sepax_search how = {.size = sizeof(sepax_search), .threads = threads, .brute_force = brute_force};
  sepax_pairs found;
  sepax_error error = {0};
  double start = seconds_now();
  if (!sepax_colliding_pairs(s->tri[0], s->count[0], s->tri[1], s->count[1], &how, &found,
                             &error)) {
    bench_fail(&error);
  }
  double took = seconds_now() - start;
  *collisions = found.count;
  sepax_pairs_free(&found);
  return took;
}

/* Two spheres, one half a radius beside the other. */
static void scale_meshes(void) {
  for (size_t triangles = 100; triangles <= 100000; triangles *= 10) {
    sepax_soup mesh[2];
    sepax_error error = {0};
    sepax_grid grid = {.resolution = 0.0005, .word = 18};
    sepax_scene scene = {.count = {triangles, triangles}};
    for (int i = 0; i < 2; i++) {
      const double centre[3] = {10.0 * i, 0.37 * i, 0.19 * i};
      scene.tri[i] = allocate(triangles * sizeof *scene.tri[i]);
      if (!sepax_sample(&mesh[i], "sphere", triangles, centre, 40, &error) ||
          !sepax_quantise(SEPAX_SOUP_MESH(&mesh[i]), &grid, scene.tri[i], &error)) {
        bench_fail(&error);
      }
      sepax_soup_free(&mesh[i]);
    }
    double pairs = (double)triangles * (double)triangles;
    for (int brute = 0; brute < (triangles <= 10000 ? 2 : 1); brute++) {
      size_t collisions;
      double took = 0;
      double end = seconds_now() + seconds_each;
      do {
        best_of(&took, search(&scene, 1, brute != 0, &collisions));
      } while (seconds_now() < end);
      printf("%s,%zu,%.0f,%.6g,%.4g\n", brute != 0 ? "brute force" : "halving", triangles, pairs,
             took, 1e9 * took / pairs);
      fflush(stdout);
    }
    sepax_scene_free(&scene);
  }
}

/* -------------------------------------------------------------------- meshes */

static int meshes(const char *const path[2]) {
  sepax_scene scene;
  sepax_error error = {0};
  sepax_grid grid = {.word = 18};
  if (!sepax_scene_load(&scene, path, &grid, false, &error)) {
    bench_fail(&error);
  }
  printf("%s, %s: %zu x %zu triangles\n", path[0], path[1], scene.count[0], scene.count[1]);
  double best[4] = {0};
  size_t collisions[4];
  double end = seconds_now() + 10 * seconds_each;
  do {
    for (int way = 0; way < 4; way++) {
      best_of(&best[way], search(&scene, 1 + way % 2, way >= 2, &collisions[way]));
    }
  } while (seconds_now() < end);
  for (int way = 0; way < 4; way++) {
    double pairs = (double)scene.count[0] * (double)scene.count[1];
    printf("%-12s %d thread%s %10.3f ms %10.3g pairs/s %8zu collisions",
           way < 2 ? "halving" : "brute force", 1 + way % 2, way % 2 == 1 ? "s" : " ",
           1e3 * best[way], pairs / best[way], collisions[way]);
    if (way % 2 == 1) {
      printf(", %.2f times one thread", best[way - 1] / best[way]);
    }
    putchar('\n');
  }
  sepax_scene_free(&scene);
  return 0;
}

int main(int argc, char **argv) {
  if (argc > 1 && strcmp(argv[1], "-q") == 0) {
    seconds_each = 0;
    argv++;
    argc--;
  }
  char *end = NULL;
  uint64_t count = argc == 3 && strcmp(argv[1], "check") == 0 ? strtoull(argv[2], &end, 10) : 0;
  if (count > 0 && *end == '\0') {
    return check(count);
  }
  if (argc == 2 && strcmp(argv[1], "scale") == 0) {
    puts("what,n,pairs,seconds,ns_per_pair");
    scale_pairs();
    scale_meshes();
    return 0;
  }
  if (argc == 4 && strcmp(argv[1], "meshes") == 0) {
    return meshes((const char *const *)&argv[2]);
  }
  fputs("usage: batch [-q] check COUNT | scale | meshes A.stl B.stl\n", stderr);
  return 2;
}
