/* SPDX-License-Identifier: MIT */
/* size.c - what a scene needs, against poses and counts made by other means; gates
 * against mapped designs; pairs within extents. */
#include "size/motion.h"
#include "oracle/geometry.h"
#include "oracle/oracle.h"
#include "oracle/pair_tools.h"
#include "harness.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FACETS = 150, POSES = 60, SCENES = 40 };

/* -------------------------------------------------------------------------- scenes */

typedef struct {
  sepax_facet facet[2][FACETS];
  sepax_soup mesh[2];
  sepax_space space;
} scene;

static void draw_mesh(scene *s, int i, double size) {
  for (int n = 0; n < FACETS; n++) {
    double middle[3];
    for (int axis = 0; axis < 3; axis++) {
      middle[axis] = 20 * random_unit();
    }
    for (int k = 0; k < 9; k++) {
      s->facet[i][n].v[k / 3][k % 3] = middle[k % 3] + size * random_unit();
    }
  }
  s->mesh[i] = (sepax_soup){.facet = s->facet[i], .count = FACETS};
}

static void draw_scene(scene *s) {
  memset(s, 0, sizeof *s);
  draw_mesh(s, 0, 2);
  draw_mesh(s, 1, 3);
  s->space.resolution = ldexp(1, -random_below(8)) / (1 + random_below(9));
  s->space.poses = 20;
  s->space.seed = (uint64_t)random_below(1000);
}

static void draw_motion(sepax_motion *m, sepax_rotation rotation) {
  m->rotation = rotation;
  for (int axis = 0; axis < 3; axis++) {
    double a = 30 * random_unit();
    double b = 30 * random_unit();
    m->low[axis] = fmin(a, b);
    m->high[axis] = fmax(a, b);
    m->centre[axis] = 10 * random_unit();
  }
}

static sepax_size sized(const scene *s) {
  sepax_size size;
  assert_works(sepax_size_scene(&size, &s->mesh[0], &s->mesh[1], &s->space, &fault));
  return size;
}

static int64_t extent_of(const scene *s, int i) {
  sepax_size size = sized(s);
  sepax_size_free(&size);
  return size.extent[i];
}

static int word_of(const scene *s) {
  sepax_size size = sized(s);
  sepax_size_free(&size);
  return size.grid.word;
}

static void refuse(const scene *s, const char *part) {
  sepax_size size = {.core_word = 77};
  assert_fault(sepax_size_scene(&size, &s->mesh[0], &s->mesh[1], &s->space, &fault), part);
  assert_int_equal(size.core_word, 77);
}

/* Rodrigues' formula about an axis of length 1. */
static point turned(point v, point axis, double angle) {
  point sideways = outer(axis, v);
  point at = along((point){{0, 0, 0}}, cos(angle), v);
  at = along(at, sin(angle), sideways);
  return along(at, inner(v, axis) * (1 - cos(angle)), axis);
}

static point draw_axis(sepax_rotation rotation) {
  point axis;
  for (int i = 0; i < 3; i++) {
    bool own = rotation == SEPAX_ROTATION_ANY || (int)rotation - SEPAX_ROTATION_X == i;
    axis.c[i] = own ? (random_below(2) == 0 ? 1 : -1) * (1.5 + random_unit()) : 0;
  }
  double length = sqrt(inner(axis, axis));
  return along(axis, length > 0 ? 1 / length - 1 : 0, axis);
}

/* A body in a pose of its motion, at the ends of the ranges now and then, on the grid. */
static void move(scene *s, int i, const sepax_grid *grid, sepax_tri tri[FACETS]) {
  static sepax_facet to[FACETS];
  const sepax_motion *m = &s->space.motion[i];
  point axis = draw_axis(m->rotation);
  double angle = m->rotation == SEPAX_ROTATION_NONE ? 0 : PI * random_unit();
  double shift[3];
  for (int k = 0; k < 3; k++) {
    double u = random_below(3) == 0 ? random_below(2) : 0.5 + 0.5 * random_unit();
    shift[k] = m->low[k] + u * (m->high[k] - m->low[k]);
  }
  for (size_t n = 0; n < 3 * s->mesh[i].count; n++) {
    const double *from = s->facet[i][n / 3].v[n % 3];
    point arm = {{from[0] - m->centre[0], from[1] - m->centre[1], from[2] - m->centre[2]}};
    point out = turned(arm, axis, angle);
    for (int k = 0; k < 3; k++) {
      to[n / 3].v[n % 3][k] = (angle == 0 ? from[k] : m->centre[k] + out.c[k]) + shift[k];
    }
  }
  assert_works(sepax_quantise(
      &SEPAX_STRUCT(sepax_mesh, .vertex = to, .triangles = s->mesh[i].count), grid, tri, &fault));
}

static int64_t longest_of(const sepax_tri tri[FACETS]) {
  int64_t longest = 0;
  for (int n = 0; n < FACETS; n++) {
    int64_t side = longest_side(&tri[n]);
    longest = side > longest ? side : longest;
  }
  return longest;
}

static uint64_t brute_force(sepax_tri tri[2][FACETS]) {
  uint64_t meeting = 0;
  for (int n = 0; n < FACETS * FACETS; n++) {
    sepax_pair pair = {.a = tri[0][n / FACETS], .b = tri[1][n % FACETS]};
    meeting += aabbs_overlap(&pair, 32);
  }
  return meeting;
}

/* Poses of any kind: on the grid, boxes within the extents, and these not much too long. */
CASE(test_poses) {
  static scene s;
  static sepax_tri tri[2][FACETS];
  for (int n = 0; n < SCENES; n++) {
    draw_scene(&s);
    draw_motion(&s.space.motion[0], (sepax_rotation)(n % 5));
    draw_motion(&s.space.motion[1], (sepax_rotation)(n / 5 % 5));
    s.space.resolution /= n % 4 == 0 ? 100 : 1;
    sepax_size size = sized(&s);
    int64_t longest[2] = {0, 0};
    for (int p = 0; p < POSES; p++) {
      for (int i = 0; i < 2; i++) {
        move(&s, i, &size.grid, tri[i]);
        int64_t side = longest_of(tri[i]);
        longest[i] = side > longest[i] ? side : longest[i];
      }
    }
    for (int i = 0; i < 2; i++) {
      assert_true(longest[i] <= size.extent[i]);
      assert_true((double)longest[i] > 0.8 * (double)size.extent[i] - 1);
    }
    assert_true(size.given <= size.worst && size.poses == 20);
    sepax_size_free(&size);
  }
}

static bool fits(const double low[3], const double high[3], sepax_grid grid, int word) {
  sepax_facet f = {
      .v = {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}, {low[0], low[1], low[2]}}};
  sepax_soup mesh = {.facet = &f, .count = 1};
  sepax_tri tri;
  grid.word = word;
  return word >= SEPAX_WORD_MIN && sepax_quantise(SEPAX_SOUP_MESH(&mesh), &grid, &tri, &fault);
}

/* One pose: everything is exact. */
CASE(test_resting) {
  static scene s;
  static sepax_tri tri[2][FACETS];
  for (int n = 0; n < SCENES; n++) {
    draw_scene(&s);
    sepax_size size = sized(&s);
    for (int i = 0; i < 2; i++) {
      assert_works(sepax_quantise(SEPAX_SOUP_MESH(&s.mesh[i]), &size.grid, tri[i], &fault));
      int64_t side = longest_of(tri[i]);
      assert_int_equal(size.extent[i], side > 0 ? side : 1);
    }
    assert_int_equal(size.given, brute_force(tri));
    assert_int_equal(size.worst, size.given);
    assert_true(fits(size.low, size.high, size.grid, size.grid.word));
    assert_false(fits(size.low, size.high, size.grid, size.grid.word - 1));
    sepax_size_free(&size);
  }
}

/* Lengths have no unit: all of them times a power of two, and the size is the same. */
static void scale(scene *s, double by) {
  for (int i = 0; i < 2; i++) {
    for (int n = 0; n < 9 * FACETS; n++) {
      s->facet[i][n / 9].v[n / 3 % 3][n % 3] *= by;
    }
    for (int axis = 0; axis < 3; axis++) {
      s->space.motion[i].low[axis] *= by;
      s->space.motion[i].high[axis] *= by;
      s->space.motion[i].centre[axis] *= by;
    }
  }
  s->space.resolution *= by;
}

CASE(test_no_unit) {
  static scene s;
  for (int n = 0; n < SCENES / 2; n++) {
    draw_scene(&s);
    draw_motion(&s.space.motion[n % 2], (sepax_rotation)(n % 5));
    sepax_size first = sized(&s);
    scale(&s, n % 2 == 0 ? 0x1p-300 : 0x1p300);
    sepax_size size = sized(&s);
    assert_memory_equal(size.extent, first.extent, sizeof size.extent);
    assert_true(size.grid.word == first.grid.word && size.core_word == first.core_word);
    assert_true(size.given == first.given && size.worst == first.worst);
    assert_int_equal(size.workloads, first.workloads);
    for (size_t k = 0; k < size.workloads; k++) {
      assert_true(size.workload[k].candidates == first.workload[k].candidates);
    }
    sepax_size_free(&first);
    sepax_size_free(&size);
    assert_true(size.workload == NULL && size.workloads == 0 && size.trees == NULL);
  }
}

/* The pose of the files is among those that a body may be in, if no shift is needed. */
CASE(test_pose_of_files) {
  static scene s;
  static sepax_facet facet[FACETS];
  for (int n = 0; n < SCENES; n++) {
    draw_scene(&s);
    sepax_motion *m = s.space.motion;
    for (int i = 0; i < 2; i++) {
      draw_motion(&m[i], (sepax_rotation)((n + i) % 5));
      for (int axis = 0; axis < 3; axis++) {
        m[i].low[axis] = -fabs(m[i].low[axis]);
        m[i].high[axis] = fabs(m[i].high[axis]);
      }
    }
    motion_pose p = sepax__motion_pose_of_files(m);
    for (int i = 0; i < 2; i++) {
      sepax_soup moved = {.facet = facet, .count = FACETS};
      sepax__motion_apply(&moved, &s.mesh[i], &m[i], p.u[i]);
      for (int k = 0; k < 9 * FACETS; k++) {
        assert_true(fabs(facet[k / 9].v[k / 3 % 3][k % 3] - s.facet[i][k / 9].v[k / 3 % 3][k % 3]) <
                    1e-12 * 100);
      }
    }
  }
}

/* A shift to one place: every sample is that pose. */
CASE(test_samples_count) {
  static scene s;
  static sepax_tri tri[2][FACETS];
  for (int n = 0; n < SCENES; n++) {
    draw_scene(&s);
    for (int axis = 0; axis < 3; axis++) {
      s.space.motion[n % 2].low[axis] = 5 * random_unit();
      s.space.motion[n % 2].high[axis] = s.space.motion[n % 2].low[axis];
    }
    sepax_size size = sized(&s);
    for (int i = 0; i < 2; i++) {
      move(&s, i, &size.grid, tri[i]);
    }
    uint64_t there = brute_force(tri);
    assert_int_equal(size.worst, there > size.given ? there : size.given);
    sepax_size_free(&size);
  }
}

/* Half a step more or less: two coordinates that are at a whole number of steps may
 * round to one more. */
CASE(test_bound) {
  static scene s;
  draw_scene(&s);
  s.mesh[0].count = 1;
  s.mesh[1].count = 1;
  s.facet[0][0] = (sepax_facet){.v = {{0, 0, 0}, {5, 0, 0}, {0, 3, 0}}};
  s.facet[1][0] = (sepax_facet){.v = {{0, 0, 0}, {0, 0, 4.9}, {0, 3, 0}}};
  s.space.resolution = 0.002;
  s.space.motion[1].high[0] = 50;
  sepax_size size = sized(&s);
  assert_int_equal(size.extent[0], 2501);
  assert_int_equal(size.extent[1], 2451);
  assert_int_equal(size.core_word, 13);
  sepax_size_free(&size);
  s.space.motion[1].rotation =
      SEPAX_ROTATION_Z; /* z stays: 4.9; an edge (0, 3, -4.9) is 3 across */
  assert_int_equal(extent_of(&s, 1), 2451);
  s.space.motion[1].rotation = SEPAX_ROTATION_X; /* sqrt(3^2 + 4.9^2) = 5.7454 */
  assert_int_equal(extent_of(&s, 1), 2873);
  s.space.motion[1].rotation = SEPAX_ROTATION_ANY;
  assert_int_equal(extent_of(&s, 1), 2873);
}

CASE(test_workspace) {
  static scene s;
  draw_scene(&s);
  s.space.resolution = 0.002;
  s.space.workspace = SEPAX_WORKSPACE_SIDES;
  for (int axis = 0; axis < 3; axis++) {
    s.space.high[axis] = 200;
  }
  assert_int_equal(word_of(&s), 17); /* 100,000 steps */
  s.space.workspace = SEPAX_WORKSPACE_PLACED;
  refuse(&s, "workspace: x = 0 ... 200, but the poses need -2");
  for (int axis = 0; axis < 3; axis++) {
    s.space.low[axis] = -200;
  }
  assert_int_equal(word_of(&s), 18);
  s.space.offset_given = true; /* at the origin: as good; at a corner: a bit more */
  assert_int_equal(word_of(&s), 18);
  s.space.offset[2] = -200;
  assert_int_equal(word_of(&s), 19);
}

CASE(test_refused) {
  static scene s;
  draw_scene(&s);
  s.space.resolution = 1e-12;
  refuse(&s, "resolution: coordinates up to");
  s.space.resolution = 0;
  refuse(&s, "resolution: 0 is not");
  s.space.resolution = 1;
  s.space.motion[1].low[1] = 1;
  refuse(&s, "motion: y from 1 to 0");
  s.space.motion[1].low[1] = 0;
  s.space.workspace = SEPAX_WORKSPACE_PLACED;
  refuse(&s, "workspace: x from 0 to 0");
  s.space.workspace = SEPAX_WORKSPACE_NONE;
  s.mesh[1].count = 0;
  refuse(&s, "no triangles");
  s.mesh[1].count = (size_t)1 << 32;
  refuse(&s, "4294967296 triangles are too many");
}

/* ------------------------------------------------------------------------ designs */

/* Every design that was mapped, within the error that is told, and that error is reached. */
CASE(test_gates) {
  FILE *in = fopen("docs/developers/results/area/nangate45.csv", "r");
  char line[200];
  double worst = 0;
  double told = 0;
  int rows = 0;
  assert_non_null(in);
  while (fgets(line, sizeof line, in) != NULL) {
    int word;
    int ii;
    int extent[2];
    double mapped;
    if (sscanf(line, "%d,%d,%d,%d,%*[^,],%lf", &word, &extent[0], &extent[1], &ii, &mapped) != 5) {
      continue;
    }
    sepax_design design =
        design_of("--word=%d --extent-a=%d --extent-b=%d --ii=%d", word, extent[0], extent[1], ii);
    double error;
    double ge = sepax_gates(&design, &error);
    told = error / ge;
    worst = fmax(worst, fabs(ge / mapped - 1));
    rows++;
  }
  fclose(in);
  assert_true(rows >= 20);
  assert_true(worst <= told + 1e-4 && worst > told - 1e-3);
}

/* Engines with several cores, to which nothing was fitted, within the error that is told. */
CASE(test_gates_of_cores) {
  FILE *in = fopen("docs/developers/results/area/cores.csv", "r");
  char line[200];
  int rows = 0;
  assert_non_null(in);
  while (fgets(line, sizeof line, in) != NULL) {
    int word;
    int ii;
    int lanes;
    int cores;
    double mapped;
    if (sscanf(line, "%d,%d,%d,%d,%lf", &word, &ii, &lanes, &cores, &mapped) == 5) {
      sepax_design design =
          design_of("--word=%d --ii=%d --lanes=%d --cores=%d", word, ii, lanes, cores);
      double error;
      double ge = sepax_gates(&design, &error);
      assert_true(fabs(ge - mapped) <= error);
      rows++;
    }
  }
  fclose(in);
  assert_true(rows >= 5);
}

/* ------------------------------------------------------------- pairs within extents */

static bool inside(const sepax_pair *pair, int extent_a, int extent_b) {
  return longest_side(&pair->a) <= extent_a && longest_side(&pair->b) <= extent_b;
}

static void check_extent_pairs(int word, int extent_a, int extent_b) {
  const int extent[2] = {extent_a, extent_b};
  sepax_design design =
      design_of("--word=%d --extent-a=%d --extent-b=%d", word, extent_a, extent_b);
  int met[2] = {0, 0};
  int brim[2] = {0, 0};
  int verdicts[2] = {0, 0};
  for (size_t family = 0; family < family_count(); family++) {
    sepax_random random = seeded(family, word);
    for (int n = 0; n < 2000; n++) {
      bool exceeding = n % 2 == 1;
      sepax_pair pair = sepax_extent_pair(family, word, extent, exceeding, &random);
      sepax_judgement v = sepax_judge(&design, &pair);
      bool meet = aabbs_overlap(&pair, word);
      assert_true(sepax_pair_fits(&pair, word));
      assert_int_equal(inside(&pair, extent_a, extent_b), !exceeding);
      assert_int_equal(v.axis == SEPAX_AXIS_EXTENT, exceeding && meet);
      assert_int_equal(v.axis == SEPAX_AXIS_AABB, !meet);
      assert_int_equal(v.collision, meet && (exceeding || oracle_collide(&pair.a, &pair.b)));
      met[exceeding] += meet;
      verdicts[v.collision] += !exceeding;
      brim[exceeding] += exceeding ? inside(&pair, extent_a + 1, extent_b + 1)
                                   : !inside(&pair, extent_a - 1, extent_b - 1);
    }
  }
  for (int k = 0; k < 2; k++) {
    assert_true(met[k] > 3000 && brim[k] > 300 && verdicts[k] > 300);
  }
}

CASE(test_extent_pairs) {
  check_extent_pairs(18, 2500, 2500);
  check_extent_pairs(17, 2501, 1800);
  check_extent_pairs(12, 300, 40);
  check_extent_pairs(6, 2, 3);
  check_extent_pairs(32, 100, 1000000);
}
