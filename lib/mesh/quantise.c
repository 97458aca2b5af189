/* SPDX-License-Identifier: MIT */
/* quantise.c - puts meshes on the integer grid.
 *
 * q = round((x - offset) / resolution) is exact for the numbers as given: no rounding of a
 * difference or a quotient decides. Doubles decide if their error is too small to reach a border
 * between grid points. Otherwise the sign of an exact sum tells on which side of the border the
 * coordinate lies. */
#include "mesh.h"
#include "sepax_grid.h"
#include "util/error.h"

#include <float.h>
#include <math.h>

_Static_assert(FLT_EVAL_METHOD == 0, "needs arithmetic in plain IEEE double precision");

/* Above this, sums of coordinates may overflow. */
static const double magnitude_max = 0x1p1000;

/* More than any word holds, and exact in all that follows. */
static const double steps_max = 0x1p33;

static const char axis_name[] = "xyz";

/* The exact value high + low. */
typedef struct {
  double high, low;
} distance;

/* x - offset (Knuth): exact where nothing overflows, as below magnitude_max; sums of doubles never
 * underflow. */
static inline distance distance_of(double x, double offset) {
  double high = x - offset;
  double x_part = high + offset;
  return (distance){high, (x - x_part) - ((high - x_part) + offset)};
}

/* A double of the sign of 2 d - half_steps * resolution. half_steps is whole, |d| and
 * |half_steps * resolution| are below 2^35 steps.
 *
 * Let T be 2 high - half_steps * resolution, and u the least of ulp(2 high) and ulp(resolution), at
 * least 2^-1074. T is a whole multiple of u. If |T| <= 2^53 u, T is a double, so fma is exact; and
 * the sum of two doubles has the sign of their exact sum. Else |T| > 2^53 u, so fma is as large, of
 * T's sign, and the last term is less than either: it is at most ulp(2 high) / 2, that is u / 2 if
 * u is ulp(2 high); if u is ulp(resolution), it is at most 2^-53 * 2^36 steps, but 2^53 u more than
 * one step. */
static inline double beyond(distance d, double half_steps, double resolution) {
  return fma(-half_steps, resolution, 2 * d.high) + 2 * d.low;
}

/* A distance >= 0 in steps, a half rounded up; at most steps_max. */
static double rounded_steps(distance d, double resolution) {
  double steps = floor(d.high / resolution + 0.5);
  if (!(steps < steps_max)) {
    return steps_max;
  }
  while (beyond(d, 2 * steps - 1, resolution) < 0) {
    steps--;
  }
  while (beyond(d, 2 * steps + 1, resolution) >= 0) {
    steps++;
  }
  return steps;
}

/* Quantise one coordinate exactly. False if it does not fit the grid. */
static bool quantise_exactly(int32_t *q, double x, const sepax_grid *grid, int axis) {
  if (!(fabs(x) <= magnitude_max)) {
    return false;
  }
  distance d = distance_of(x, grid->offset[axis]);
  bool negative = d.high < 0;
  if (negative) {
    d = (distance){-d.high, -d.low};
  }
  double steps = rounded_steps(d, grid->resolution);
  double value = negative ? -steps : steps;
  if (value < sepax_word_min(grid->word) || value > sepax_word_max(grid->word)) {
    return false;
  }
  *q = (int32_t)value;
  return true;
}

static bool check_word(int word, sepax_error *error) {
  if (word < SEPAX_WORD_MIN || word > SEPAX_WORD_MAX) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "word: %d is not in %d ... %d", word,
                      SEPAX_WORD_MIN, SEPAX_WORD_MAX);
  }
  return true;
}

static bool check_grid(const sepax_grid *grid, sepax_error *error) {
  if (!(grid->resolution > 0 && grid->resolution <= magnitude_max)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "resolution: %g is not a length above 0",
                      grid->resolution);
  }
  for (int axis = 0; axis < 3; axis++) {
    if (!(fabs(grid->offset[axis]) <= magnitude_max)) {
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "offset: %c = %g is not a coordinate",
                        axis_name[axis], grid->offset[axis]);
    }
  }
  return check_word(grid->word, error);
}

/* ------------------------------------------------------------------ bounds */

typedef struct {
  double low[3], high[3];
  double rest[3]; /* 0; NaN after a coordinate that is NaN or infinite */
} bounds;

static const bounds no_bounds = {
    {INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}, {0, 0, 0}};

static bounds extended(bounds all, const triangles *mesh) {
  for (size_t i = 0; i < mesh->count; i++) {
    double space[3][3];
    const double(*v)[3] = triangle_at(mesh, i, space);
    _Pragma("GCC unroll 9") for (int k = 0; k < 9; k++) {
      int axis = k % 3;
      double x = v[k / 3][axis];
      all.low[axis] = x < all.low[axis] ? x : all.low[axis];
      all.high[axis] = x > all.high[axis] ? x : all.high[axis];
      all.rest[axis] += x - x;
    }
  }
  return all;
}

static bool are_numbers(const bounds *all) {
  return all->rest[0] == 0 && all->rest[1] == 0 && all->rest[2] == 0;
}

static bool all_fit(const bounds *all, const sepax_grid *grid, double resolution) {
  sepax_grid trial = *grid;
  trial.resolution = resolution;
  bool ok = resolution > 0 && are_numbers(all);
  for (int axis = 0; ok && axis < 3; axis++) {
    int32_t q;
    ok = quantise_exactly(&q, all->low[axis], &trial, axis) &&
         quantise_exactly(&q, all->high[axis], &trial, axis);
  }
  return ok;
}

/* --------------------------------------------------------------------- fit */

static bool check_range(const bounds *all, const triangles *mesh, size_t number,
                        sepax_error *error) {
  bool ok = are_numbers(all);
  for (int axis = 0; axis < 3; axis++) {
    ok = ok && all->low[axis] >= -magnitude_max && all->high[axis] <= magnitude_max;
  }
  for (size_t i = 0; !ok && i < 9 * mesh->count; i++) {
    int axis = (int)(i % 3);
    double space[3][3];
    double x = triangle_at(mesh, i / 9, space)[i / 3 % 3][axis];
    if (!(fabs(x) <= magnitude_max)) {
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "mesh %zu, facet %zu: %c = %g is too large; %s", number, i / 9,
                        axis_name[axis], x, "scale the mesh down");
    }
  }
  return true;
}

static bool find_bounds(bounds *all, const sepax_mesh *const meshes[], size_t count,
                        sepax_error *error) {
  *all = no_bounds;
  for (size_t i = 0; i < count; i++) {
    triangles mesh;
    if (!sepax__triangles_of(&mesh, meshes[i], error)) {
      return false;
    }
    *all = extended(*all, &mesh);
    if (!check_range(all, &mesh, i, error)) {
      return false;
    }
  }
  bool point = true;
  for (int axis = 0; axis < 3; axis++) {
    point = point && all->low[axis] >= all->high[axis];
  }
  if (point) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "no extent: the meshes are %s; give the resolution",
                      all->low[0] > all->high[0] ? "empty" : "a single point");
  }
  return true;
}

/* The word ends half a step inside of 2^(W-1) above and half a step outside below.
 * The quotient is the finest resolution or a few units in the last place below. */
static double finest_resolution(const bounds *all, const sepax_grid *grid) {
  double above = 2.0 * sepax_word_max(grid->word) + 1;
  double below = above + 2;
  double resolution = 0;
  for (int axis = 0; axis < 3; axis++) {
    double high = all->high[axis] - grid->offset[axis];
    double low = grid->offset[axis] - all->low[axis];
    resolution = fmax(resolution, fmax(2 * high / above, 2 * low / below));
  }
  while (!all_fit(all, grid, resolution)) {
    resolution = nextafter(resolution, INFINITY);
  }
  return resolution;
}

bool sepax_grid_fit(sepax_grid *grid, const sepax_mesh *const meshes[], size_t count, int word,
                    sepax_error *error) {
  bounds all;
  *grid = (sepax_grid){0};
  if (!check_word(word, error) || !find_bounds(&all, meshes, count, error)) {
    return false;
  }
  sepax_grid fit = {.word = word};
  for (int axis = 0; axis < 3; axis++) {
    fit.offset[axis] = 0.5 * (all.low[axis] + all.high[axis]);
  }
  fit.resolution = finest_resolution(&all, &fit);
  *grid = fit;
  return true;
}

/* ---------------------------------------------------------------- quantise */

/* Two coordinates at once. A facet has nine, so the ninth comes twice. */
typedef double reals __attribute__((vector_size(16)));
typedef int64_t lanes __attribute__((vector_size(16)));
typedef int32_t words __attribute__((vector_size(8)));

#define UNROLL _Pragma("GCC unroll 5")

typedef struct {
  const sepax_grid *grid;
  reals offset[5], per_step; /* per_step: 1 / resolution */
} fast_grid;

/* If a step is so long or short that per_step would be inexact, then all coordinates are in
 * doubt. */
static fast_grid fast_grid_of(const sepax_grid *grid) {
  const double *o = grid->offset;
  bool plain = grid->resolution >= 0x1p-1000 && grid->resolution <= 0x1p1000;
  return (fast_grid){grid,
                     {{o[0], o[1]}, {o[2], o[0]}, {o[1], o[2]}, {o[0], o[1]}, {o[2], o[2]}},
                     (reals){0} + (plain ? 1 / grid->resolution : NAN)};
}

/* Adding this number rounds to the nearest whole number, because neighbouring doubles there differ
 * by 1, and leaves the whole number in the lowest bits. */
static const double whole_shift = 0x3p51;

/* Decide a coordinate in doubt, which is within 2^-17 steps of the border below + 1/2. On the
 * border it is rounded away from zero. */
static int32_t settle(double x, int axis, const fast_grid *fast) {
  const sepax_grid *grid = fast->grid;
  double per_step = fast->per_step[0];
  int32_t q = 0;
  if (isnan(per_step)) {
    quantise_exactly(&q, x, grid, axis);
    return q;
  }
  distance d = distance_of(x, grid->offset[axis]);
  double below = (d.high * per_step - 0.5 + whole_shift) - whole_shift;
  double over = beyond(d, 2 * below + 1, grid->resolution);
  bool up = (over > 0) | ((over == 0) & (below >= 0));
  return (int32_t)((int64_t)below + up);
}

static inline int32_t *component(sepax_tri *tri, int i) {
  sepax_vec *v = &tri->v[i / 3];
  return i % 3 == 0 ? &v->x : i % 3 == 1 ? &v->y : &v->z;
}

/* A facet whose coordinates fit the grid.
 *
 * The difference, 1 / resolution and their product are wrong by 2^-53 each, in proportion, all
 * three by less than 2^-51: of up to 2^31 + 1 steps by less than 2^-19. (A product that underflows
 * is wrong by far less than that.) So a product that is nearer than 1/2 - 2^-18 to a whole number
 * rounds to it; any other, and what is undefined, is in doubt. */
static inline void quantise_facet(sepax_tri *tri, const double facet[3][3], const fast_grid *fast) {
  const double *v = facet[0];
  const reals x[5] = {{v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}, {v[6], v[7]}, {v[8], v[8]}};
  words q[5];
  lanes certain = {0, 0}; /* bit i: coordinate i */
  UNROLL for (int k = 0; k < 5; k++) {
    reals steps = (x[k] - fast->offset[k]) * fast->per_step;
    reals sum = steps + whole_shift;
    reals rest = (reals)((lanes)(steps - (sum - whole_shift)) & INT64_MAX);
    certain |= (rest < 0.5 - 0x1p-18) & (lanes){1 << 2 * k, 2 << 2 * k};
    q[k] = __builtin_convertvector((lanes)sum, words);
  }
  *tri = (sepax_tri){
      {{q[0][0], q[0][1], q[1][0]}, {q[1][1], q[2][0], q[2][1]}, {q[3][0], q[3][1], q[4][0]}}};
  unsigned doubt = (unsigned)~(certain[0] | certain[1]) & 0x1ff;
  for (; doubt != 0; doubt &= doubt - 1) {
    int i = __builtin_ctz(doubt);
    *component(tri, i) = settle(v[i], i % 3, fast);
  }
}

static bool check_coordinates(const double v[3][3], size_t number, const sepax_grid *grid,
                              sepax_error *error) {
  for (int i = 0; i < 9; i++) {
    int axis = i % 3;
    double x = v[i / 3][axis];
    int32_t q;
    if (!quantise_exactly(&q, x, grid, axis)) {
      return sepax_fail(
          error, SEPAX_ERROR_ARGUMENT,
          "facet %zu, vertex %d: %c = %.9g does not fit %d bits at %.9g per LSB from %.9g; raise "
          "resolution or word, or move the offset",
          number, i / 3, axis_name[axis], x, grid->word, grid->resolution, grid->offset[axis]);
    }
  }
  return true;
}

/* All coordinates are checked before a result is written. Rounding is monotonic, so a mesh fits if
 * its bounds do. */
bool sepax_quantise(const sepax_mesh *given, const sepax_grid *grid, sepax_tri *tri,
                    sepax_error *error) {
  triangles mesh;
  if (!sepax__triangles_of(&mesh, given, error)) {
    return false;
  }
  bool ok = check_grid(grid, error);
  const bounds all = extended(no_bounds, &mesh);
  bool fits = ok && (mesh.count == 0 || all_fit(&all, grid, grid->resolution));
  double space[3][3];
  for (size_t i = 0; i < mesh.count && ok && !fits; i++) {
    ok = check_coordinates(triangle_at(&mesh, i, space), i, grid, error);
  }
  if (!ok) {
    memset(tri, 0, mesh.count * sizeof *tri);
    return false;
  }
  const fast_grid fast = fast_grid_of(grid);
  for (size_t i = 0; i < mesh.count; i++) {
    quantise_facet(&tri[i], triangle_at(&mesh, i, space), &fast);
  }
  return true;
}
