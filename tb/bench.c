/* bench.c - pairs a second of the software verdicts, side by side on the same pairs:
 * the families uniform and local at W = 18. Best of five rounds each, in turn. */
#include "sepax.h"

#include <stdlib.h>
#include <time.h>

enum { PAIRS = 100000, ROUNDS = 5 };

static bool float64(const sepax_design *paper, const sepax_pair *p) {
  (void)paper;
  return sepax_float64(&p->a, &p->b);
}

static bool float32(const sepax_design *paper, const sepax_pair *p) {
  (void)paper;
  return sepax_float32(&p->a, &p->b);
}

static bool interval64(const sepax_design *paper, const sepax_pair *p) {
  (void)paper;
  return sepax_interval64(&p->a, &p->b);
}

static bool interval32(const sepax_design *paper, const sepax_pair *p) {
  (void)paper;
  return sepax_interval32(&p->a, &p->b);
}

static bool reference(const sepax_design *paper, const sepax_pair *p) {
  (void)paper;
  return sepax_reference(&p->a, &p->b);
}

static bool exact(const sepax_design *paper, const sepax_pair *p) {
  (void)paper;
  return sepax_exact(&p->a, &p->b).collision;
}

static bool sat54(const sepax_design *paper, const sepax_pair *p) {
  (void)paper;
  return sepax_sat54(&p->a, &p->b);
}

static bool machine(const sepax_design *paper, const sepax_pair *p) {
  return sepax_paper(paper, p).collision;
}

static const struct {
  const char *name;
  bool (*collide)(const sepax_design *paper, const sepax_pair *p);
} verdicts[] = {{"float64", float64}, {"float32", float32}, {"interval64", interval64}, {"interval32", interval32}, {"reference", reference},
                {"exact", exact},     {"sat54", sat54},     {"paper", machine}};
enum { VERDICTS = sizeof verdicts / sizeof verdicts[0] };

static double seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* The seconds that a verdict takes for all pairs. */
static double measure(int verdict, const sepax_design *paper, const sepax_pair *pair,
                      size_t *collisions) {
  *collisions = 0;
  double start = seconds();
  for (size_t n = 0; n < PAIRS; n++) {
    *collisions += verdicts[verdict].collide(paper, &pair[n]);
  }
  return seconds() - start;
}

static void run(const sepax_design *paper, const sepax_pair *pair) {
  double best[VERDICTS] = {0};
  size_t collisions[VERDICTS];
  for (int round = 0; round < ROUNDS; round++) {
    for (int i = 0; i < VERDICTS; i++) {
      double took = measure(i, paper, pair, &collisions[i]);
      best[i] = round == 0 || took < best[i] ? took : best[i];
    }
  }
  printf("%-10s %12s %10s %12s\n", "verdict", "pairs/s", "ratio", "collisions");
  for (int i = 0; i < VERDICTS; i++) {
    printf("%-10s %12.0f %10.2f %12zu\n", verdicts[i].name, PAIRS / best[i],
           best[0] / best[i], collisions[i]);
  }
}

int main(void) {
  sepax_config config = sepax_config_default();
  config.arch = SEPAX_ARCH_PAPER;
  sepax_design paper;
  sepax_error error = {""};
  sepax_pair *pair = calloc(PAIRS, sizeof *pair);
  if (pair == NULL || !sepax_design_init(&paper, &config, &error)) {
    fprintf(stderr, "bench: %s\n", pair == NULL ? "no memory" : error.text);
    free(pair);
    return 2;
  }
  sepax_random random = {1};
  for (size_t n = 0; n < PAIRS; n++) {
    pair[n] = sepax_family_pair(n % 2, 18, &random);
  }
  run(&paper, pair);
  free(pair);
  return 0;
}
