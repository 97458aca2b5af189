/* SPDX-License-Identifier: MIT */
/* pose.c - makes, packs and unpacks poses in fixed point. docs/reference/tree-engine.md, Why
 * nothing is missed, has inequality (2). */
#include "tree_engine/tree.h"
#include "util/error.h"
#include "util/wide.h"

#include <math.h>

#define ONE (INT64_C(1) << 20)
#define HALF (INT64_C(1) << 19)
#define SHIFT_MAX (INT64_C(1) << 43)
#define SIGMA_MAX ((UINT32_C(1) << 24) - 1)

/* Largest coordinate, in LSB. A double has 53 bits, so 2^28 LSB leave a precision of 2^-25 LSB. */
static const double far = 0x1p28;

static bool fits_shift(wide x) { return x >= -SHIFT_MAX && x < SHIFT_MAX; }

/* ------------------------------------------------------------------ inequality (2) */

/* The right side of inequality (2) without the factor 2^-30. No overflow: entries of M and K are
 * within 2^20 and t is within 2^43, so all terms are below 2^86. */
static wide needed(const sepax_tree_pose *p, int i, int word, int64_t margin) {
  const sepax_tree_side *to_a = &p->side[0];
  const sepax_tree_side *to_b = &p->side[1];
  wide errors = 0;
  wide sizes = 0;
  wide offset = (wide)to_b->shift[i] * ONE;
  for (int j = 0; j < 3; j++) {
    wide e = i == j ? (wide)ONE * ONE : 0;
    for (int l = 0; l < 3; l++) {
      e -= (wide)to_b->matrix[i][l] * to_a->matrix[l][j];
    }
    errors += wide_magnitude(e);
    sizes += wide_magnitude(to_b->matrix[i][j]);
    offset += (wide)to_b->matrix[i][j] * (to_a->shift[j] - HALF);
  }
  return errors * ((wide)1 << (word - 1)) + sizes * HALF * (2 * margin + 1) +
         wide_magnitude(offset);
}

bool sepax_tree_pose_close(sepax_tree_pose *pose, int word, int64_t margin, sepax_error *error) {
  uint32_t sigma[3];
  for (int i = 0; i < 3; i++) {
    wide units = (needed(pose, i, word, margin) + (1 << 30) - 1) >> 30;
    if (margin < 0 || units > SIGMA_MAX) {
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "boxes of A would be larger by 2^14 LSB and more: the matrices are not "
                        "each other's inverse, or the margin of %lld LSB is not in 0 ... 8191",
                        (long long)margin);
    }
    sigma[i] = (uint32_t)units;
  }
  for (int i = 0; i < 3; i++) {
    pose->side[1].sigma[i] = sigma[i];
  }
  return true;
}

/* -------------------------------------------------------------- from doubles */

static void invert(double inverse[3][3], const double m[3][3]) {
  double determinant = 0;
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      int a = (i + 1) % 3;
      int b = (i + 2) % 3;
      int c = (j + 1) % 3;
      int d = (j + 2) % 3;
      inverse[j][i] = m[a][c] * m[b][d] - m[a][d] * m[b][c];
    }
    determinant += m[0][i] * inverse[i][0];
  }
  for (int k = 0; k < 9; k++) {
    inverse[k / 3][k % 3] /= determinant;
  }
}

static double dot(const double row[3], const double v[3]) {
  return row[0] * v[0] + row[1] * v[1] + row[2] * v[2];
}

/* The pose of B in the coordinates of A: inverse(pose_a) pose_b. */
static sepax_pose between(const sepax_pose *pose_a, const sepax_pose *pose_b) {
  static const sepax_pose as_it_stands = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};
  pose_b = pose_b != NULL ? pose_b : &as_it_stands;
  if (pose_a == NULL) {
    return *pose_b;
  }
  double inverse[3][3];
  double way[3];
  sepax_pose r;
  invert(inverse, pose_a->rotation);
  for (int i = 0; i < 3; i++) {
    way[i] = pose_b->translation[i] - pose_a->translation[i];
  }
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      const double column[3] = {pose_b->rotation[0][j], pose_b->rotation[1][j],
                                pose_b->rotation[2][j]};
      r.rotation[i][j] = dot(inverse[i], column);
    }
    r.translation[i] = dot(inverse[i], way);
  }
  return r;
}

static bool make_matrix(int32_t matrix[3][3], const double rotation[3][3], sepax_error *error) {
  for (int k = 0; k < 9; k++) {
    double entry = rint(rotation[k / 3][k % 3] * 0x1p20);
    if (!(fabs(entry) <= 0x1p20)) {
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "the matrix has the entry %.9g; mend it to within -1 ... 1",
                        rotation[k / 3][k % 3]);
    }
    matrix[k / 3][k % 3] = (int32_t)entry;
  }
  return true;
}

/* Set K to the rounded inverse. Inequality (2) holds for any K, so K may be inexact. Entries that
 * rounding brought above 1 are clamped. */
static void make_inverse(int32_t matrix[3][3], const double rotation[3][3]) {
  double inverse[3][3];
  invert(inverse, rotation);
  for (int k = 0; k < 9; k++) {
    double entry = rint(inverse[k / 3][k % 3] * 0x1p20);
    matrix[k / 3][k % 3] = (int32_t)fmax(-0x1p20, fmin(0x1p20, entry));
  }
}

static bool make_shift(int64_t shift[3], const sepax_pose *pose, const sepax_grid *a,
                       const sepax_grid *b, sepax_error *error) {
  for (int i = 0; i < 3; i++) {
    double sum = dot(pose->rotation[i], b->offset) + pose->translation[i] - a->offset[i];
    double steps = rint(sum / a->resolution * 0x1p20) + 0x1p19;
    if (!(steps >= -(double)SHIFT_MAX && steps < (double)SHIFT_MAX)) {
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "the bodies are %.3g LSB from each other; the tree engine takes "
                        "8388607 (2^23 - 1)",
                        fabs(sum / a->resolution));
    }
    shift[i] = (int64_t)steps;
  }
  return true;
}

/* Set u to -K t' / 2^20, rounded to nearest. */
static bool make_back_shift(sepax_tree_pose *p, sepax_error *error) {
  for (int i = 0; i < 3; i++) {
    wide sum = 0;
    for (int j = 0; j < 3; j++) {
      sum -= (wide)p->side[1].matrix[i][j] * (p->side[0].shift[j] - HALF);
    }
    wide u = (sum + HALF) >> 20;
    if (!fits_shift(u)) {
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "the bodies are too far from each other; the tree engine takes "
                        "8388607 LSB (2^23 - 1)");
    }
    p->side[1].shift[i] = (int64_t)u;
  }
  return true;
}

static bool check_near(const sepax_pose *pose, const sepax_grid *grid, const char *name,
                       sepax_error *error) {
  if (pose != NULL && !sepax_pose_valid(pose, error)) {
    return false;
  }
  for (int i = 0; i < 3; i++) {
    double t = pose != NULL ? pose->translation[i] : 0;
    if (!(fabs(t) <= far * grid->resolution && fabs(grid->offset[i]) <= far * grid->resolution)) {
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "body %s: offset or translation beyond 2^28 LSB; put the origin of "
                        "the files nearer to the bodies",
                        name);
    }
  }
  return true;
}

bool sepax_tree_pose_make(sepax_tree_pose *pose, const sepax_tree *a, const sepax_pose *pose_a,
                          const sepax_tree *b, const sepax_pose *pose_b, int64_t margin,
                          sepax_error *error) {
  if (a->grid.resolution != b->grid.resolution) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "the trees have resolutions of %.9g and %.9g; make them alike",
                      a->grid.resolution, b->grid.resolution);
  }
  if (margin < 0 || margin > 8191) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "a margin of %lld LSB is not in 0 ... 8191",
                      (long long)margin);
  }
  if (!check_near(pose_a, &a->grid, "A", error) || !check_near(pose_b, &b->grid, "B", error)) {
    return false;
  }
  const sepax_pose of_b = between(pose_a, pose_b);
  sepax_tree_pose made = {0};
  if (!make_matrix(made.side[0].matrix, of_b.rotation, error) ||
      !make_shift(made.side[0].shift, &of_b, &a->grid, &b->grid, error)) {
    return false;
  }
  make_inverse(made.side[1].matrix, of_b.rotation);
  for (int i = 0; i < 3; i++) {
    made.side[0].sigma[i] = (uint32_t)margin << 10;
  }
  if (!make_back_shift(&made, error) ||
      !sepax_tree_pose_close(&made, b->grid.word, margin, error)) {
    return false;
  }
  *pose = made;
  return true;
}

/* d = sqrt(3) (sqrt(3) / 2 + 3 x 2^(W - 22) + 2^-17), rounded up. */
int sepax_tree_clearance_added(int word) { return word <= 18 ? 2 : word <= 20 ? 3 : 5; }

/* -------------------------------------------------------------------- bytes */

/* Places of the numbers of a side in the 144 bytes. */
static const struct { int shift, matrix, sigma; } place[2] = {{0, 48, 120}, {24, 84, 132}};

void sepax_tree_pose_pack(const sepax_tree_pose *pose, uint8_t bytes[SEPAX_TREE_POSE_BYTES]) {
  for (int n = 0; n < 2; n++) {
    const sepax_tree_side *side = &pose->side[n];
    for (int k = 0; k < 9; k++) {
      bytes_put32(bytes + place[n].matrix + 4 * k, (uint32_t)side->matrix[k / 3][k % 3]);
    }
    for (int i = 0; i < 3; i++) {
      bytes_put64(bytes + place[n].shift + 8 * i, (uint64_t)side->shift[i]);
      bytes_put32(bytes + place[n].sigma + 4 * i, side->sigma[i]);
    }
  }
}

static bool in_range(const sepax_tree_side *side, sepax_error *error) {
  for (int k = 0; k < 9; k++) {
    int32_t m = side->matrix[k / 3][k % 3];
    if (m < -ONE || m > ONE) {
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "a matrix has the entry %d, beyond 2^20", m);
    }
  }
  for (int i = 0; i < 3; i++) {
    if (!fits_shift(side->shift[i]) || side->sigma[i] > SIGMA_MAX) {
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "a pose has the shift %lld, the sigma %u; they have 44 and 24 bits",
                        (long long)side->shift[i], side->sigma[i]);
    }
  }
  return true;
}

bool sepax_tree_pose_unpack(sepax_tree_pose *pose, const uint8_t bytes[SEPAX_TREE_POSE_BYTES],
                            sepax_error *error) {
  sepax_tree_pose p = {0};
  for (int n = 0; n < 2; n++) {
    sepax_tree_side *side = &p.side[n];
    for (int k = 0; k < 9; k++) {
      side->matrix[k / 3][k % 3] = (int32_t)bytes_get32(bytes + place[n].matrix + 4 * k);
    }
    for (int i = 0; i < 3; i++) {
      side->shift[i] = (int64_t)bytes_get64(bytes + place[n].shift + 8 * i);
      side->sigma[i] = bytes_get32(bytes + place[n].sigma + 4 * i);
    }
    if (!in_range(side, error)) {
      return false;
    }
  }
  *pose = p;
  return true;
}
