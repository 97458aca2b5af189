/* bench.c - pairs a second of the software verdicts, side by side on the same pairs:
 * the families uniform and local at W = 18. Best of five rounds each, in turn. */
#include "sepax.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { PAIRS = 100000, ROUNDS = 5 };

static double seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

int main(void) {
  static const sepax_arch archs[] = {SEPAX_ARCH_FLOAT64, SEPAX_ARCH_FLOAT32,
                                     SEPAX_ARCH_EXACT, SEPAX_ARCH_PAPER};
  enum { ARCHS = sizeof archs / sizeof archs[0] };
  double best[ARCHS];
  size_t collisions[ARCHS] = {0};
  sepax_pair *pair = calloc(PAIRS, sizeof *pair);
  if (pair == NULL) {
    return 2;
  }
  sepax_random random = {1};
  for (size_t n = 0; n < PAIRS; n++) {
    pair[n] = sepax_family_pair(n % 2, 18, &random);
  }
  for (int round = 0; round < ROUNDS; round++) {
    for (int i = 0; i < ARCHS; i++) {
      sepax_config config = sepax_config_default();
      sepax_design design;
      sepax_error error = {""};
      config.arch = archs[i];
      if (!sepax_design_init(&design, &config, &error)) {
        fprintf(stderr, "bench: %s\n", error.text);
        return 2;
      }
      collisions[i] = 0;
      double start = seconds();
      for (size_t n = 0; n < PAIRS; n++) {
        collisions[i] += sepax_judge(&design, &pair[n]).collision;
      }
      double took = seconds() - start;
      best[i] = round == 0 || took < best[i] ? took : best[i];
    }
  }
  printf("%-10s %12s %10s %12s\n", "verdict", "pairs/s", "ratio", "collisions");
  for (int i = 0; i < ARCHS; i++) {
    printf("%-10s %12.0f %10.2f %12zu\n", sepax_arch_name(archs[i]), PAIRS / best[i],
           best[0] / best[i], collisions[i]);
  }
  free(pair);
  return 0;
}
