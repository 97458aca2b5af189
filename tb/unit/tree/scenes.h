/* SPDX-License-Identifier: MIT */
/* scenes.h - bodies of integer triangles and poses for the tests of trees; what a test knows of
 * them without the library's arithmetic. */
#ifndef TREE_SCENES_H
#define TREE_SCENES_H

#include "harness.h"
#include "oracle/geometry.h"
#include "sepax_tree.h"
#include "tree_engine/format.h"
#include "unit/body/draws.h"

typedef struct {
  sepax_tri *tri;
  size_t count;
} triangles;

/* A count from the environment, for long runs, or the usual one. */
static inline size_t count_of_run(const char *name, size_t usual) {
  const char *given = getenv(name);
  return given != NULL ? strtoull(given, NULL, 10) : usual;
}

static inline int32_t within_word(double x, int word) {
  double low = sepax_word_min(word);
  double high = sepax_word_max(word);
  return (int32_t)round(x < low ? low : x > high ? high : x);
}

/* Triangles of some size within +- reach LSB. Kinds: 0 strewn; 1 in facets of one plane, so that
 * many touch; 2 on a coarse grid; 3 slivers; 4 a closed surface: a bumpy ball. */
static inline triangles drawn(size_t count, int kind, double reach, double size, int word) {
  triangles t = {calloc(count, sizeof(sepax_tri)), count};
  assert_non_null(t.tri);
  size_t across = (size_t)ceil(sqrt((double)count / 2));
  for (size_t n = 0; n < count; n++) {
    const double at[3] = {reach * random_unit(), reach * random_unit(), reach * random_unit()};
    for (int k = 0; k < 9; k++) {
      int axis = k % 3;
      double x = at[axis] + (k < 3 && kind != 3 ? 0 : size * random_unit());
      x = kind == 1 && axis == 2 ? round(at[2] / reach * 2) * reach / 4 : x;
      x = kind == 2 ? round(x / size * 2) * size / 2 : x;
      x = kind == 3 && k >= 6 ? *coordinate(&t.tri[n].v[1], axis) + random_below(3) - 1 : x;
      *coordinate(&t.tri[n].v[k / 3], axis) = within_word(x, word);
    }
    for (int k = 0; k < 3 && kind == 4; k++) {
      size_t square = n / 2;
      size_t row = square / across;
      double u = (double)(square % across + (size_t)(k == 1 || (n % 2 == 1 && k > 0)));
      double v = (double)(row + (size_t)(k == 2 || (n % 2 == 1 && k == 0)));
      double a = 2 * PI * u / (double)across;
      double b = PI * v / (double)across;
      double r = reach * (0.8 + 0.1 * sin(5 * a) * sin(b) + 0.1 * cos(7 * b));
      t.tri[n].v[k] =
          (sepax_vec){within_word(r * sin(b) * cos(a), word),
                      within_word(r * sin(b) * sin(a), word), within_word(r * cos(b), word)};
    }
  }
  return t;
}

static inline sepax_tree *tree_of(const triangles *t, int word) {
  sepax_tree *tree;
  const sepax_grid grid = {.resolution = 1, .word = word};
  assert_works(sepax_tree_new(&tree, t->tri, t->count, &grid, &fault));
  return tree;
}

/* Rotations: any; by quarters; of the triangle 3, 4, 5; none; small. */
static inline sepax_pose posed(int kind, double away) {
  static const double thirds[][3] = {{0.6, 0.8, 0}, {0.8, 0, 0.6}, {0, 0.28, 0.96}};
  sepax_pose p = turned(1, 0, 0, 0);
  if (kind == 0) {
    p = turned(random_unit(), random_unit(), random_unit(), random_unit());
  } else if (kind == 1) {
    static const double half[] = {-1, 0, 1};
    do {
      p = turned(half[random_below(3)], half[random_below(3)], half[random_below(3)], 1);
    } while (fabs(fmod(p.rotation[0][0], 1)) + fabs(fmod(p.rotation[0][1], 1)) > 0);
  } else if (kind == 2) {
    const double *c = thirds[random_below(3)];
    int axis = random_below(3);
    int x = (axis + 1) % 3;
    int y = (axis + 2) % 3;
    double cosine = c[0] > 0 ? c[0] : c[1];
    double sine = c[0] > 0 ? c[1] + c[2] : c[2];
    p.rotation[x][x] = cosine;
    p.rotation[y][y] = cosine;
    p.rotation[x][y] = -sine;
    p.rotation[y][x] = sine;
  } else if (kind == 4) {
    p = turned(1, 1e-3 * random_unit(), 1e-3 * random_unit(), 1e-3 * random_unit());
  }
  for (int i = 0; i < 3; i++) {
    p.translation[i] = kind == 1 || kind == 2 ? round(away * random_unit()) : away * random_unit();
  }
  return p;
}

/* Formula (1) of docs/reference/tree-engine.md, in 128 bits. */
static inline void turn_exactly(int64_t v[3], const sepax_tree_side *side, const sepax_vec *p) {
  for (int i = 0; i < 3; i++) {
    wide sum = (wide)side->matrix[i][0] * p->x + (wide)side->matrix[i][1] * p->y +
               (wide)side->matrix[i][2] * p->z + side->shift[i];
    wide steps = sum / (1 << 20);
    v[i] = (int64_t)(steps * (1 << 20) > sum ? steps - 1 : steps);
  }
}

#endif
