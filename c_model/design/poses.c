/* poses.c - what two meshes need in each of their poses: word length, extents, and how many
 * candidates the AABB test leaves. docs/size.md. */
#include "design/interval.h"
#include "design/jobs.h"
#include "sepax_vectors.h"
#include "util/error.h"

#include <math.h>
#include <stdlib.h>

static const char axis_name[] = "xyz";
static const double full_angle = 6.283185307179586;

/* Rounding when a body is moved in double precision stays well below this share. */
static const double slack = 0x1p-40;

/* A workspace may be too small by this share, so that the rounding of its decimals decides nothing.
 */
static const double workspace_slack = 1e-9;

typedef struct {
  double low[3], high[3];
} range;

static range nowhere(void) {
  return (range){{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
}

static void extend(range *r, int axis, double low, double high) {
  r->low[axis] = fmin(r->low[axis], low);
  r->high[axis] = fmax(r->high[axis], high);
}

static bool moves(const sepax_motion *m) {
  bool shifted = false;
  for (int axis = 0; axis < 3; axis++) {
    shifted = shifted || m->low[axis] != 0 || m->high[axis] != 0;
  }
  return shifted || m->rotation != SEPAX_ROTATION_NONE;
}

/* True iff the rotation does not change this coordinate. */
static bool kept(sepax_rotation rotation, int axis) {
  return rotation == SEPAX_ROTATION_NONE || (int)rotation - SEPAX_ROTATION_X == axis;
}

/* The length of d without the component that the rotation does not change. */
static double length_rotated(const double d[3], sepax_rotation rotation) {
  double square = 0;
  for (int axis = 0; axis < 3; axis++) {
    square += kept(rotation, axis) ? 0 : d[axis] * d[axis];
  }
  return sqrt(square);
}

/* ---------------------------------------------------------------- hull, extents */

static void extend_by_vertex(range *hull, const double v[3], const sepax_motion *m) {
  double arm[3];
  for (int axis = 0; axis < 3; axis++) {
    arm[axis] = v[axis] - m->centre[axis];
  }
  double radius = length_rotated(arm, m->rotation);
  for (int axis = 0; axis < 3; axis++) {
    double c = m->centre[axis];
    double r = radius + slack * (radius + fabs(c));
    bool still = kept(m->rotation, axis);
    double low = still ? v[axis] : fmin(c - r, v[axis]);
    double high = still ? v[axis] : fmax(c + r, v[axis]);
    extend(hull, axis, low + fmin(m->low[axis], 0), high + fmax(m->high[axis], 0));
  }
}

static range hull_of(const sepax_mesh *const mesh[2], const sepax_motion motion[2]) {
  range hull = nowhere();
  for (int i = 0; i < 2; i++) {
    for (size_t n = 0; n < 3 * mesh[i]->count; n++) {
      extend_by_vertex(&hull, mesh[i]->facet[n / 3].v[n % 3], &motion[i]);
    }
  }
  return hull;
}

/* The longest side that the AABB of a facet has in any pose, file units. */
static double longest_side(const sepax_facet *f, sepax_rotation rotation) {
  double side = 0;
  for (int k = 0; k < 3; k++) {
    double edge[3];
    for (int axis = 0; axis < 3; axis++) {
      edge[axis] = f->v[(k + 1) % 3][axis] - f->v[k][axis];
      side = kept(rotation, axis) ? fmax(side, fabs(edge[axis])) : side;
    }
    side = fmax(side, length_rotated(edge, rotation));
  }
  return side;
}

/* Two coordinates at a distance of s round to grid points at a distance of floor(s) + 1 at most. */
static int64_t extent_moved(const sepax_mesh *mesh, sepax_rotation rotation, double reach,
                            double resolution) {
  double side = 0;
  for (size_t n = 0; n < mesh->count; n++) {
    side = fmax(side, longest_side(&mesh->facet[n], rotation));
  }
  return (int64_t)floor((side + slack * (side + reach)) / resolution) + 1;
}

/* --------------------------------------------------------------------- the AABBs */

typedef struct {
  job_bodies on_grid;
  sepax_mesh moved[2];
} bodies;

static int64_t longest_side_of(const aabb *bounds, size_t count) {
  int64_t longest = 1;
  for (size_t n = 0; n < count; n++) {
    int64_t side = aabb_longest_side(&bounds[n]);
    longest = side > longest ? side : longest;
  }
  return longest;
}

static bool quantise_body(bodies *r, int i, const sepax_mesh *mesh, const sepax_grid *grid,
                          sepax_error *error) {
  if (!sepax_quantise(mesh, grid, r->on_grid.tri[i], NULL, error)) {
    return false;
  }
  for (size_t n = 0; n < mesh->count; n++) {
    r->on_grid.bounds[i][n] = aabb_of(&r->on_grid.tri[i][n]);
  }
  return true;
}

static bool allocate(bodies *r, const sepax_mesh *const mesh[2]) {
  bool ok = true;
  for (int i = 0; i < 2; i++) {
    size_t count = mesh[i]->count;
    r->on_grid.tri[i] = calloc(count, sizeof *r->on_grid.tri[i]);
    r->on_grid.bounds[i] = calloc(count, sizeof *r->on_grid.bounds[i]);
    r->moved[i].facet = calloc(count, sizeof *r->moved[i].facet);
    r->moved[i].count = count;
    r->on_grid.count[i] = count;
    ok = ok && r->on_grid.tri[i] != NULL && r->on_grid.bounds[i] != NULL &&
         r->moved[i].facet != NULL;
  }
  return ok;
}

static void release(bodies *r) {
  for (int i = 0; i < 2; i++) {
    free(r->on_grid.tri[i]);
    free(r->on_grid.bounds[i]);
    free(r->moved[i].facet);
  }
}

/* ------------------------------------------------------------------ sampled poses */

/* Numbers of 0 ... 1 of each body: three for its shift, three for its rotation. */
typedef struct {
  double u[2][6];
} pose;

static double unit(sepax_random *random) {
  return (double)(sepax_random_next(random) >> 11) * 0x1p-53;
}

/* The pose of the files, or the nearest to it in the ranges. */
static pose pose_of_files(const sepax_motion motion[2]) {
  static const double no_rotation[3] = {0, 0.25, 0};
  pose p;
  for (int k = 0; k < 12; k++) {
    int axis = k % 6;
    double low = motion[k / 6].low[axis % 3];
    double way = motion[k / 6].high[axis % 3] - low;
    double u = way > 0 ? fmin(fmax(-low / way, 0), 1) : 0;
    p.u[k / 6][axis] = axis < 3 ? u : no_rotation[axis - 3];
  }
  return p;
}

/* Any pose, or one within a share of the ranges around another pose. */
static pose draw_pose(const pose *centre, double share, sepax_random *random) {
  pose p;
  for (int k = 0; k < 12; k++) {
    double u = unit(random);
    if (centre != NULL) {
      double moved = centre->u[k / 6][k % 6] + share * (u - 0.5);
      u = k % 6 < 3 ? fmin(fmax(moved, 0), 1) : moved - floor(moved);
    }
    p.u[k / 6][k % 6] = u;
  }
  return p;
}

/* A rotation about one axis, or any rotation (Shoemake: uniform). */
static void rotation_matrix(double m[3][3], sepax_rotation rotation, const double u[3]) {
  double q[4] = {1, 0, 0, 0};
  if (rotation == SEPAX_ROTATION_ANY) {
    double p = sqrt(1 - u[0]);
    double r = sqrt(u[0]);
    q[0] = p * sin(full_angle * u[1]);
    q[1] = p * cos(full_angle * u[1]);
    q[2] = r * sin(full_angle * u[2]);
    q[3] = r * cos(full_angle * u[2]);
  } else if (rotation != SEPAX_ROTATION_NONE) {
    q[0] = cos(full_angle / 2 * u[0]);
    q[1 + (int)rotation - SEPAX_ROTATION_X] = sin(full_angle / 2 * u[0]);
  }
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3;
    int k = (i + 2) % 3;
    m[i][i] = 1 - 2 * (q[1 + j] * q[1 + j] + q[1 + k] * q[1 + k]);
    m[i][j] = 2 * (q[1 + i] * q[1 + j] - q[0] * q[1 + k]);
    m[i][k] = 2 * (q[1 + i] * q[1 + k] + q[0] * q[1 + j]);
  }
}

static void move_body(sepax_mesh *moved, const sepax_mesh *mesh, const sepax_motion *motion,
                      const double u[6]) {
  double m[3][3];
  rotation_matrix(m, motion->rotation, &u[3]);
  for (size_t n = 0; n < 3 * mesh->count; n++) {
    const double *v = mesh->facet[n / 3].v[n % 3];
    for (int i = 0; i < 3; i++) {
      double x = v[i];
      if (!kept(motion->rotation, i)) {
        x = motion->centre[i];
        for (int k = 0; k < 3; k++) {
          x += m[i][k] * (v[k] - motion->centre[k]);
        }
      }
      double shift = motion->low[i] + u[i] * (motion->high[i] - motion->low[i]);
      moved->facet[n / 3].v[n % 3][i] = x + shift;
    }
  }
}

/* The job of the pose in which the bodies are now. */
static bool add_job(sepax_size *size, const bodies *r, sepax_error *error) {
  if (!job_find(&size->job[size->poses + 1], &r->on_grid, error)) {
    return false;
  }
  size->poses++;
  return true;
}

/* The most candidates in sampled poses. The first half of the poses is anywhere, the second half
 * closes in on the worst pose so far. */
static bool sample_poses(sepax_size *size, bodies *r, const sepax_mesh *const mesh[2],
                         const sepax_space *space, sepax_error *error) {
  sepax_random random = {space->seed};
  pose worst = pose_of_files(space->motion);
  for (int n = 0; n < space->poses; n++) {
    bool anywhere = 2 * n < space->poses || size->worst == 0;
    double share = 0.5 * exp2(8 - 16.0 * n / space->poses);
    pose p = draw_pose(anywhere ? NULL : &worst, share, &random);
    for (int i = 0; i < 2; i++) {
      if (moves(&space->motion[i])) {
        move_body(&r->moved[i], mesh[i], &space->motion[i], p.u[i]);
        if (!quantise_body(r, i, &r->moved[i], &size->grid, error)) {
          return false;
        }
      }
    }
    if (!add_job(size, r, error)) {
      return false;
    }
    if (size->job[n + 1].candidates > size->worst) {
      size->worst = size->job[n + 1].candidates;
      worst = p;
    }
  }
  return true;
}

/* ------------------------------------------------------------------- word length */

/* The workspace, or what the poses need; it always holds all of them. */
static bool find_space(range *all, const range *hull, const sepax_space *space,
                       sepax_error *error) {
  *all = *hull;
  for (int axis = 0; axis < 3 && space->workspace != SEPAX_WORKSPACE_NONE; axis++) {
    double low = space->low[axis];
    double high = space->high[axis];
    double side = high - low;
    if (space->workspace == SEPAX_WORKSPACE_SIDES) {
      low = (hull->low[axis] + hull->high[axis] - side) / 2;
      high = low + side;
    }
    double spare = workspace_slack * side;
    if (hull->low[axis] < low - spare || hull->high[axis] > high + spare) {
      return sepax_fail(error,
                        "workspace: %c = %.9g ... %.9g, but the poses need %.9g ... %.9g; "
                        "enlarge it or limit the motion",
                        axis_name[axis], low, high, hull->low[axis], hull->high[axis]);
    }
    extend(all, axis, low, high);
  }
  return true;
}

static bool fits(const range *all, const sepax_grid *grid) {
  sepax_facet corners = {.normal = {0}};
  for (int axis = 0; axis < 3; axis++) {
    corners.v[0][axis] = all->low[axis];
    corners.v[1][axis] = all->high[axis];
    corners.v[2][axis] = all->high[axis];
  }
  sepax_mesh one = {&corners, 1};
  sepax_tri tri;
  sepax_error unread;
  return sepax_quantise(&one, grid, &tri, NULL, &unread);
}

static bool find_grid(sepax_grid *grid, const range *all, const sepax_space *space,
                      sepax_error *error) {
  *grid = (sepax_grid){.resolution = space->resolution, .word = SEPAX_WORD_MIN};
  double widest = 0;
  for (int axis = 0; axis < 3; axis++) {
    double middle = (all->low[axis] + all->high[axis]) / 2;
    grid->offset[axis] = space->offset_given ? space->offset[axis] : middle;
    widest = fmax(widest,
                  fmax(all->high[axis] - grid->offset[axis], grid->offset[axis] - all->low[axis]));
  }
  while (grid->word < SEPAX_WORD_MAX && !fits(all, grid)) {
    grid->word++;
  }
  return fits(all, grid) ||
         sepax_fail(error,
                    "resolution: coordinates reach %.9g from the origin, more than %d bits "
                    "of %.9g; give --resolution=%.3g or more",
                    widest, SEPAX_WORD_MAX, space->resolution,
                    widest / sepax_word_max(SEPAX_WORD_MAX) * 1.01);
}

static bool check_space(const sepax_mesh *const mesh[2], const sepax_space *space,
                        sepax_error *error) {
  if (mesh[0]->count == 0 || mesh[1]->count == 0) {
    return sepax_fail(error, "mesh: no triangles; give two meshes that have some");
  }
  for (int i = 0; i < 2; i++) {
    if (mesh[i]->count > UINT32_MAX) {
      return sepax_fail(error, "mesh: %zu triangles are too many; give up to %u", mesh[i]->count,
                        UINT32_MAX);
    }
  }
  if (!(space->resolution > 0 && isfinite(space->resolution))) {
    return sepax_fail(error, "resolution: %g is not a length above 0", space->resolution);
  }
  for (int axis = 0; axis < 3; axis++) {
    for (int i = 0; i < 2; i++) {
      const sepax_motion *m = &space->motion[i];
      if (!(m->low[axis] <= m->high[axis])) {
        return sepax_fail(error, "motion: %c from %g to %g is no range; put the smaller first",
                          axis_name[axis], m->low[axis], m->high[axis]);
      }
    }
    if (space->workspace != SEPAX_WORKSPACE_NONE && !(space->low[axis] < space->high[axis])) {
      return sepax_fail(error, "workspace: %c from %g to %g is no range; put the smaller first",
                        axis_name[axis], space->low[axis], space->high[axis]);
    }
  }
  return true;
}

static bool measure(sepax_size *size, bodies *r, const sepax_mesh *const mesh[2],
                    const sepax_space *space, const range *all, sepax_error *error) {
  double reach = 0;
  for (int axis = 0; axis < 3; axis++) {
    reach = fmax(reach, fmax(fabs(all->low[axis]), fabs(all->high[axis])));
  }
  bool moving = moves(&space->motion[0]) || moves(&space->motion[1]);
  for (int i = 0; i < 2; i++) {
    if (!quantise_body(r, i, mesh[i], &size->grid, error)) {
      return false;
    }
    size->count[i] = mesh[i]->count;
    size->extent[i] =
        moving || space->workspace != SEPAX_WORKSPACE_NONE
            ? extent_moved(mesh[i], space->motion[i].rotation, reach, space->resolution)
            : longest_side_of(r->on_grid.bounds[i], mesh[i]->count);
  }
  int bits = bits_behind_aabb_test(size->extent[0], size->extent[1], 0);
  size->core_word = bits < size->grid.word ? bits : size->grid.word;
  size->poses = -1;
  size->job = calloc(1 + (size_t)space->poses, sizeof *size->job);
  if (size->job == NULL) {
    return sepax_fail(error, "no memory for %d poses; sample fewer", space->poses);
  }
  if (!add_job(size, r, error)) {
    return false;
  }
  size->given = size->job[0].candidates;
  size->worst = size->given;
  return !moving || sample_poses(size, r, mesh, space, error);
}

bool sepax_size_scene(sepax_size *size, const sepax_mesh *a, const sepax_mesh *b,
                      const sepax_space *space, sepax_error *error) {
  const sepax_mesh *const mesh[2] = {a, b};
  sepax_size found = {.poses = 0};
  range all;
  if (!check_space(mesh, space, error)) {
    return false;
  }
  range hull = hull_of(mesh, space->motion);
  if (!find_space(&all, &hull, space, error) || !find_grid(&found.grid, &all, space, error)) {
    return false;
  }
  for (int axis = 0; axis < 3; axis++) {
    found.low[axis] = hull.low[axis];
    found.high[axis] = hull.high[axis];
  }
  bodies r = {.moved = {{NULL, 0}, {NULL, 0}}};
  bool ok = allocate(&r, mesh)
                ? measure(&found, &r, mesh, space, &all, error)
                : sepax_fail(error, "no memory for %zu and %zu triangles", a->count, b->count);
  release(&r);
  if (ok) {
    *size = found;
  } else {
    sepax_size_free(&found);
  }
  return ok;
}

void sepax_size_free(sepax_size *size) {
  for (int n = 0; n <= size->poses && size->job != NULL; n++) {
    free(size->job[n].pass);
  }
  free(size->job);
  size->job = NULL;
}
