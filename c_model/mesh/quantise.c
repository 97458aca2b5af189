/* quantise.c - from file units to the integer grid.
 *
 * q = round((x - offset) / resolution) holds for the numbers as given: no rounding of a difference
 * or a quotient decides. Doubles decide where their error is too small to reach a border between
 * grid points; elsewhere the coordinate is compared with the borders by the sign of an exact sum.
 */
#include "util/error.h"

#include <float.h>
#include <math.h>

_Static_assert(FLT_EVAL_METHOD == 0, "needs arithmetic in plain IEEE double precision");

/* Above this, sums of coordinates may overflow. */
static const double magnitude_max = 0x1p1000;

/* More than any word holds, and exact in all that follows. */
static const double steps_max = 0x1p33;

static const char axis_name[] = "xyz";

/* a + b = sum + *rest exactly (Knuth). */
static double two_sum(double a, double b, double *rest) {
  double sum = a + b;
  double b_part = sum - a;
  *rest = (a - (sum - b_part)) + (b - b_part);
  return sum;
}

/* The sign of an exact sum: the terms are added to an expansion whose components do
 * not overlap and grow in magnitude (Shewchuk, grow-expansion). */
static int sign_of_sum(const double term[4]) {
  double part[4];
  for (int n = 0; n < 4; n++) {
    double sum = term[n];
    for (int i = 0; i < n; i++) {
      sum = two_sum(sum, part[i], &part[i]);
    }
    part[n] = sum;
  }
  for (int i = 3; i >= 0; i--) {
    if (part[i] != 0) {
      return part[i] > 0 ? 1 : -1;
    }
  }
  return 0;
}

/* x - offset = high + low exactly. */
typedef struct {
  double high, low;
} distance;

/* Is the distance at least half_steps / 2 steps of the grid? */
static bool reaches(distance d, double half_steps, double resolution) {
  if (d.low == 0) {
    return fma(half_steps, resolution, -2 * d.high) <= 0;
  }
  double product = half_steps * resolution;
  double rest = fma(half_steps, resolution, -product);
  return sign_of_sum((double[4]){2 * d.low, 2 * d.high, -rest, -product}) >= 0;
}

/* A distance >= 0 in steps, rounded half up; at most steps_max. */
static double rounded_steps(distance d, double resolution) {
  double steps = floor(d.high / resolution + 0.5);
  if (!(steps < steps_max)) {
    return steps_max;
  }
  while (!reaches(d, 2 * steps - 1, resolution)) {
    steps--;
  }
  while (reaches(d, 2 * steps + 1, resolution)) {
    steps++;
  }
  return steps;
}

/* False if x does not fit the grid; by exact sums. */
static bool quantise_exactly(int32_t *q, double x, const sepax_grid *grid, int axis) {
  if (!(fabs(x) <= magnitude_max)) {
    return false;
  }
  distance d;
  d.high = two_sum(x, -grid->offset[axis], &d.low);
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
    return sepax_fail(error, "word: %d is not in %d ... %d", word, SEPAX_WORD_MIN, SEPAX_WORD_MAX);
  }
  return true;
}

static bool check_grid(const sepax_grid *grid, sepax_error *error) {
  if (!(grid->resolution > 0 && grid->resolution <= magnitude_max)) {
    return sepax_fail(error, "resolution: %g is not a length above 0", grid->resolution);
  }
  for (int axis = 0; axis < 3; axis++) {
    if (!(fabs(grid->offset[axis]) <= magnitude_max)) {
      return sepax_fail(error, "offset: %c = %g is not a coordinate", axis_name[axis],
                        grid->offset[axis]);
    }
  }
  return check_word(grid->word, error);
}

/* --------------------------------------------------------------------- fit */

typedef struct {
  double low[3], high[3];
} bounds;

static bool extend(bounds *all, const sepax_mesh *mesh, size_t number, sepax_error *error) {
  for (size_t i = 0; i < 9 * mesh->count; i++) {
    int axis = (int)(i % 3);
    double x = mesh->facet[i / 9].v[i / 3 % 3][axis];
    if (!(fabs(x) <= magnitude_max)) {
      return sepax_fail(error, "mesh %zu, facet %zu: %c = %g is too large; %s", number, i / 9 + 1,
                        axis_name[axis], x, "scale the mesh down");
    }
    all->low[axis] = fmin(all->low[axis], x);
    all->high[axis] = fmax(all->high[axis], x);
  }
  return true;
}

static bool find_bounds(bounds *all, const sepax_mesh *const meshes[], size_t count,
                        sepax_error *error) {
  *all = (bounds){{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
  for (size_t i = 0; i < count; i++) {
    if (!extend(all, meshes[i], i + 1, error)) {
      return false;
    }
  }
  bool point = true;
  for (int axis = 0; axis < 3; axis++) {
    point = point && all->low[axis] >= all->high[axis];
  }
  if (point) {
    return sepax_fail(error, "no extent: the meshes are %s; give the resolution",
                      all->low[0] > all->high[0] ? "empty" : "a single point");
  }
  return true;
}

static bool all_fit(const bounds *all, const sepax_grid *grid, double resolution) {
  sepax_grid trial = *grid;
  trial.resolution = resolution;
  bool ok = resolution > 0;
  for (int axis = 0; ok && axis < 3; axis++) {
    int32_t q;
    ok = quantise_exactly(&q, all->low[axis], &trial, axis) &&
         quantise_exactly(&q, all->high[axis], &trial, axis);
  }
  return ok;
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

/* Coordinates two at once; the ninth of a facet comes twice. */
typedef double reals __attribute__((vector_size(16)));
typedef int64_t lanes __attribute__((vector_size(16)));
typedef int32_t words __attribute__((vector_size(8)));

#define UNROLL _Pragma("GCC unroll 5")

typedef struct {
  const sepax_grid *grid;
  reals offset[5], per_step, low, high; /* per_step: 1 / resolution; low, high: of the word */
} fast_grid;

/* Where steps are so long that a coordinate above magnitude_max could be some steps from the
 * offset, all is in doubt. */
static fast_grid fast_grid_of(const sepax_grid *grid) {
  const double *o = grid->offset;
  double per_step = grid->resolution <= 0x1p900 ? 1 / grid->resolution : NAN;
  return (fast_grid){grid,
                     {{o[0], o[1]}, {o[2], o[0]}, {o[1], o[2]}, {o[0], o[1]}, {o[2], o[2]}},
                     (reals){0} + per_step,
                     (reals){0} + (double)sepax_word_min(grid->word),
                     (reals){0} + (double)sepax_word_max(grid->word)};
}

/* The coordinates of a facet by doubles. False where one is in doubt or does not fit.
 *
 * The difference, 1 / resolution and their product are wrong by 2^-53 each, in proportion, all
 * three by less than 2^-51: of up to 2^31 + 1 steps by less than 2^-19. (A product that underflows
 * is wrong by far less than that.) So a product that is nearer than 1/2 - 2^-18 to a whole number
 * rounds to it. Adding 3 * 2^51 rounds to the nearest whole number, as the step of doubles is 1
 * there, and leaves it in the lowest bits. An infinite or undefined product is near to nothing. */
static inline bool quantise_fast(sepax_tri *tri, const sepax_facet *facet, const fast_grid *fast) {
  const double shift = 0x3p51;
  const double *v = facet->v[0];
  const reals x[5] = {{v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}, {v[6], v[7]}, {v[8], v[8]}};
  words q[5];
  lanes certain = {-1, -1};
  UNROLL for (int k = 0; k < 5; k++) {
    reals steps = (x[k] - fast->offset[k]) * fast->per_step;
    reals sum = steps + shift;
    reals whole = sum - shift;
    reals rest = (reals)((lanes)(steps - whole) & INT64_MAX);
    certain &= (rest < 0.5 - 0x1p-18) & (whole >= fast->low) & (whole <= fast->high);
    q[k] = __builtin_convertvector((lanes)sum, words);
  }
  *tri = (sepax_tri){
      {{q[0][0], q[0][1], q[1][0]}, {q[1][1], q[2][0], q[2][1]}, {q[3][0], q[3][1], q[4][0]}}};
  return (certain[0] & certain[1]) != 0;
}

static bool quantise_facet_exactly(sepax_tri *tri, const sepax_facet *facet, size_t number,
                                   const sepax_grid *grid, sepax_error *error) {
  for (int i = 0; i < 9; i++) {
    int axis = i % 3;
    double x = facet->v[i / 3][axis];
    sepax_vec *v = &tri->v[i / 3];
    int32_t *component[3] = {&v->x, &v->y, &v->z};
    if (!quantise_exactly(component[axis], x, grid, axis)) {
      return sepax_fail(error,
                        "facet %zu, vertex %d: %c = %.9g does not fit %d bits of %.9g "
                        "from %.9g; raise resolution or word, or move the offset",
                        number, i / 3 + 1, axis_name[axis], x, grid->word, grid->resolution,
                        grid->offset[axis]);
    }
  }
  return true;
}

static inline bool quantise_facet(sepax_tri *tri, const sepax_facet *facet, size_t number,
                                  const fast_grid *fast, sepax_error *error) {
  return quantise_fast(tri, facet, fast) ||
         quantise_facet_exactly(tri, facet, number, fast->grid, error);
}

static bool check_normal(const double normal[3], size_t number, sepax_error *error) {
  for (int axis = 0; axis < 3; axis++) {
    if (!isfinite(normal[axis])) {
      return sepax_fail(error, "facet %zu: the normal has %c = %g; mend the mesh", number,
                        axis_name[axis], normal[axis]);
    }
  }
  return true;
}

static sepax_vec quantise_normal(const double normal[3], int word) {
  double largest = fmax(fmax(fabs(normal[0]), fabs(normal[1])), fabs(normal[2]));
  if (largest == 0) {
    return (sepax_vec){0, 0, 0};
  }
  int exponent = 0;
  frexp(largest, &exponent);
  double n[3];
  for (int axis = 0; axis < 3; axis++) {
    n[axis] = ldexp(normal[axis], -exponent);
  }
  double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  double unit = sepax_word_max(word);
  return (sepax_vec){(int32_t)round(n[0] * unit / length), (int32_t)round(n[1] * unit / length),
                     (int32_t)round(n[2] * unit / length)};
}

/* The first pass only checks, for results that stay untouched on failure. */
bool sepax_quantise(const sepax_mesh *mesh, const sepax_grid *grid, sepax_tri *tri,
                    sepax_vec *normal, sepax_error *error) {
  if (!check_grid(grid, error)) {
    return false;
  }
  const fast_grid fast = fast_grid_of(grid);
  sepax_tri checked;
  for (size_t i = 0; i < mesh->count; i++) {
    const sepax_facet *facet = &mesh->facet[i];
    if (!quantise_facet(&checked, facet, i + 1, &fast, error) ||
        (normal != NULL && !check_normal(facet->normal, i + 1, error))) {
      return false;
    }
  }
  for (size_t i = 0; i < mesh->count; i++) {
    quantise_facet(&tri[i], &mesh->facet[i], i + 1, &fast, error);
    if (normal != NULL) {
      normal[i] = quantise_normal(mesh->facet[i].normal, grid->word);
    }
  }
  return true;
}
