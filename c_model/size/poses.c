/* SPDX-License-Identifier: MIT */
/* poses.c - measures two meshes in all their poses: word length, extents, and the candidates that
 * the AABB test leaves. docs/reference/size.md. */
#include "design/interval.h"
#include "size/workloads.h"
#include "size/motion.h"
#include "util/error.h"

#include <math.h>
#include <stdlib.h>

static const char axis_name[] = "xyz";
/* Moving a body in double precision rounds by much less than this share. */
static const double slack = 0x1p-40;

/* A workspace may be too small by this share, so that the rounding of its decimals does not
 * matter. */
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

/* The length of d without the component that the rotation does not change. */
static double length_rotated(const double d[3], sepax_rotation rotation) {
  double square = 0;
  for (int axis = 0; axis < 3; axis++) {
    square += sepax__motion_keeps(rotation, axis) ? 0 : d[axis] * d[axis];
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
    bool still = sepax__motion_keeps(m->rotation, axis);
    double low = still ? v[axis] : fmin(c - r, v[axis]);
    double high = still ? v[axis] : fmax(c + r, v[axis]);
    extend(hull, axis, low + fmin(m->low[axis], 0), high + fmax(m->high[axis], 0));
  }
}

static void extend_by_body(range *hull, const sepax_soup *mesh, const sepax_motion *motion) {
  for (size_t n = 0; n < 3 * mesh->count; n++) {
    extend_by_vertex(hull, mesh->facet[n / 3].v[n % 3], motion);
  }
}

static void extend_by_path(range *hull, const sepax_soup *mesh, const sepax_poses *path) {
  double reach = 0;
  for (size_t k = 0; k < path->count; k++) {
    for (size_t n = 0; n < 3 * mesh->count; n++) {
      const double *v = mesh->facet[n / 3].v[n % 3];
      double at[3];
      sepax_pose_apply(&path->pose[k], v, at);
      for (int axis = 0; axis < 3; axis++) {
        extend(hull, axis, at[axis], at[axis]);
        reach = fmax(reach, fabs(v[axis]) + fabs(path->pose[k].translation[axis]));
      }
    }
  }
  for (int axis = 0; axis < 3; axis++) {
    extend(hull, axis, hull->low[axis] - slack * reach, hull->high[axis] + slack * reach);
  }
}

static range hull_of(const sepax_soup *const mesh[2], const sepax_space *space) {
  static const sepax_motion still = {.rotation = SEPAX_ROTATION_NONE};
  range hull = nowhere();
  if (space->path != NULL) {
    extend_by_path(&hull, mesh[1], space->path);
    extend_by_body(&hull, mesh[0], &still);
    return hull;
  }
  for (int i = 0; i < 2; i++) {
    extend_by_body(&hull, mesh[i], &space->motion[i]);
  }
  return hull;
}

/* The rotation of a body. */
static sepax_rotation rotation_of(const sepax_space *space, int body) {
  if (space->path == NULL) {
    return space->motion[body].rotation;
  }
  for (size_t k = 0; k < space->path->count && body == 1; k++) {
    for (int n = 0; n < 9; n++) {
      if (space->path->pose[k].rotation[n / 3][n % 3] != (n % 4 == 0)) {
        return SEPAX_ROTATION_ANY;
      }
    }
  }
  return SEPAX_ROTATION_NONE;
}

/* The longest side that the AABB of a facet has in any pose, in units of the file. */
static double longest_side(const sepax_facet *f, sepax_rotation rotation) {
  double side = 0;
  for (int k = 0; k < 3; k++) {
    double edge[3];
    for (int axis = 0; axis < 3; axis++) {
      edge[axis] = f->v[(k + 1) % 3][axis] - f->v[k][axis];
      side = sepax__motion_keeps(rotation, axis) ? fmax(side, fabs(edge[axis])) : side;
    }
    side = fmax(side, length_rotated(edge, rotation));
  }
  return side;
}

/* Two coordinates at a distance s round to grid points at a distance of at most floor(s) + 1. */
static int64_t extent_moved(const sepax_soup *mesh, sepax_rotation rotation, double reach,
                            double resolution) {
  double side = 0;
  for (size_t n = 0; n < mesh->count; n++) {
    side = fmax(side, longest_side(&mesh->facet[n], rotation));
  }
  return (int64_t)floor((side + slack * (side + reach)) / resolution) + 1;
}

/* --------------------------------------------------------------------- the AABBs */

typedef struct {
  workload_bodies on_grid;
  sepax_soup moved[2];
} bodies;

static int64_t longest_side_of(const aabb *bounds, size_t count) {
  int64_t longest = 1;
  for (size_t n = 0; n < count; n++) {
    int64_t side = aabb_longest_side(&bounds[n]);
    longest = side > longest ? side : longest;
  }
  return longest;
}

static bool quantise_body(bodies *r, int i, const sepax_soup *mesh, const sepax_grid *grid,
                          sepax_error *error) {
  if (!sepax_quantise(SEPAX_SOUP_MESH(mesh), grid, r->on_grid.tri[i], error)) {
    return false;
  }
  for (size_t n = 0; n < mesh->count; n++) {
    r->on_grid.bounds[i][n] = aabb_of(&r->on_grid.tri[i][n]);
  }
  return true;
}

static bool allocate(bodies *r, const sepax_soup *const mesh[2]) {
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

/* Add the workload of the current pose of the bodies. */
static bool add_workload(sepax_size *size, const bodies *r, sepax_error *error) {
  if (!sepax__workload_find(&size->workload[size->workloads], &r->on_grid, error)) {
    return false;
  }
  uint64_t candidates = size->workload[size->workloads++].candidates;
  size->worst = candidates > size->worst ? candidates : size->worst;
  return true;
}

static bool find_path_workloads(sepax_size *size, bodies *r, const sepax_soup *mesh,
                                const sepax_poses *path, sepax_error *error) {
  for (size_t k = 0; k < path->count; k++) {
    for (size_t n = 0; n < 3 * mesh->count; n++) {
      sepax_pose_apply(&path->pose[k], mesh->facet[n / 3].v[n % 3],
                       r->moved[1].facet[n / 3].v[n % 3]);
    }
    if (!quantise_body(r, 1, &r->moved[1], &size->grid, error) || !add_workload(size, r, error)) {
      return false;
    }
  }
  return true;
}

/* Find the most candidates in sampled poses. The first half of the poses is drawn from the whole
 * range; the second half comes closer and closer to the worst pose so far. */
static bool sample_poses(sepax_size *size, bodies *r, const sepax_soup *const mesh[2],
                         const sepax_space *space, sepax_error *error) {
  sepax_random random = {space->seed};
  motion_pose worst = sepax__motion_pose_of_files(space->motion);
  for (int n = 0; n < space->poses; n++) {
    bool anywhere = 2 * n < space->poses || size->worst == 0;
    double share = 0.5 * exp2(8 - 16.0 * n / space->poses);
    motion_pose p = sepax__motion_draw(anywhere ? NULL : &worst, share, &random);
    for (int i = 0; i < 2; i++) {
      if (sepax__motion_moves(&space->motion[i])) {
        sepax__motion_apply(&r->moved[i], mesh[i], &space->motion[i], p.u[i]);
        if (!quantise_body(r, i, &r->moved[i], &size->grid, error)) {
          return false;
        }
      }
    }
    uint64_t most = size->worst;
    if (!add_workload(size, r, error)) {
      return false;
    }
    size->poses++;
    worst = size->worst > most ? p : worst;
  }
  return true;
}

/* ------------------------------------------------------------------- word length */

/* The workspace, or the AABB of all poses if none was given. It must hold all poses. */
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
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "workspace: %c = %.9g ... %.9g, but the poses need %.9g ... %.9g; "
                        "enlarge it or limit the motion",
                        axis_name[axis], low, high, hull->low[axis], hull->high[axis]);
    }
    extend(all, axis, low, high);
  }
  return true;
}

static bool fits(const range *all, const sepax_grid *grid) {
  sepax_facet corners;
  for (int axis = 0; axis < 3; axis++) {
    corners.v[0][axis] = all->low[axis];
    corners.v[1][axis] = all->high[axis];
    corners.v[2][axis] = all->high[axis];
  }
  sepax_tri tri;
  sepax_error unread;
  return sepax_quantise(&SEPAX_STRUCT(sepax_mesh, .vertex = &corners, .triangles = 1), grid, &tri,
                        &unread);
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
         sepax_fail(
             error, SEPAX_ERROR_ARGUMENT,
             "resolution: coordinates up to %.9g from the origin do not fit %d bits at %.9g per "
             "LSB; give --resolution=%.3g or more",
             widest, SEPAX_WORD_MAX, space->resolution,
             widest / sepax_word_max(SEPAX_WORD_MAX) * 1.01);
}

static bool check_space(const sepax_soup *const mesh[2], const sepax_space *space,
                        sepax_error *error) {
  if (mesh[0]->count == 0 || mesh[1]->count == 0) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "mesh: it has no triangles; give two meshes with triangles");
  }
  for (int i = 0; i < 2; i++) {
    if (mesh[i]->count > UINT32_MAX) {
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "mesh: %zu triangles are too many; give up to %u", mesh[i]->count,
                        UINT32_MAX);
    }
  }
  if (space->path != NULL && space->path->count == 0) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "poses: the path has no poses; give one or more");
  }
  if (!(space->resolution > 0 && isfinite(space->resolution))) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "resolution: %g is not a length above 0",
                      space->resolution);
  }
  for (int axis = 0; axis < 3; axis++) {
    for (int i = 0; i < 2; i++) {
      const sepax_motion *m = &space->motion[i];
      if (!(m->low[axis] <= m->high[axis])) {
        return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                          "motion: %c from %g to %g is no range; put the smaller first",
                          axis_name[axis], m->low[axis], m->high[axis]);
      }
    }
    if (space->workspace != SEPAX_WORKSPACE_NONE && !(space->low[axis] < space->high[axis])) {
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "workspace: %c from %g to %g is no range; put the smaller first",
                        axis_name[axis], space->low[axis], space->high[axis]);
    }
  }
  return true;
}

/* Make the trees. B's tree has the origin in the middle of B. */
static bool find_trees(sepax_size *size, const bodies *r, const sepax_soup *mesh,
                       const sepax_space *space, sepax_error *error) {
  static const sepax_motion still = {.rotation = SEPAX_ROTATION_NONE};
  const sepax_space own = {.resolution = space->resolution};
  sepax_grid grid[2] = {size->grid};
  range of_b = nowhere();
  extend_by_body(&of_b, mesh, &still);
  if (!find_grid(&grid[1], &of_b, &own, error)) {
    return false;
  }
  if (grid[0].word > SEPAX_TREE_WORD_MAX || grid[1].word > SEPAX_TREE_WORD_MAX) {
    return true;
  }
  return sepax_quantise(SEPAX_SOUP_MESH(mesh), &grid[1], r->on_grid.tri[1], error) &&
         sepax__size_trees_new(&size->trees, &r->on_grid, grid, space, error);
}

static bool measure(sepax_size *size, bodies *r, const sepax_soup *const mesh[2],
                    const sepax_space *space, const range *all, sepax_error *error) {
  double reach = 0;
  for (int axis = 0; axis < 3; axis++) {
    reach = fmax(reach, fmax(fabs(all->low[axis]), fabs(all->high[axis])));
  }
  const sepax_poses *path = space->path;
  size->path = path != NULL ? path->count : 0;
  bool moving = path != NULL || sepax__motion_moves(&space->motion[0]) ||
                sepax__motion_moves(&space->motion[1]);
  for (int i = 0; i < 2; i++) {
    if ((i == 0 || path == NULL) && !quantise_body(r, i, mesh[i], &size->grid, error)) {
      return false;
    }
    size->count[i] = mesh[i]->count;
    size->extent[i] = moving || space->workspace != SEPAX_WORKSPACE_NONE
                          ? extent_moved(mesh[i], rotation_of(space, i), reach, space->resolution)
                          : longest_side_of(r->on_grid.bounds[i], mesh[i]->count);
  }
  int bits = bits_behind_aabb_test(size->extent[0], size->extent[1], r->on_grid.margin);
  size->core_word = bits < size->grid.word ? bits : size->grid.word;
  size_t most = path != NULL ? path->count : 1 + (size_t)space->poses;
  size->workload = calloc(most, sizeof *size->workload);
  if (size->workload == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu poses; give fewer", most);
  }
  uint64_t pairs = (uint64_t)size->count[0] * size->count[1];
  bool left_out = path != NULL && space->pairs_most > 0 && pairs > space->pairs_most;
  if (!left_out && !(path != NULL ? find_path_workloads(size, r, mesh[1], path, error)
                                  : add_workload(size, r, error))) {
    return false;
  }
  size->given = size->workload[0].candidates;
  return path != NULL ? find_trees(size, r, mesh[1], space, error)
                      : !moving || sample_poses(size, r, mesh, space, error);
}

bool sepax_size_scene(sepax_size *size, const sepax_soup *a, const sepax_soup *b,
                      const sepax_space *space, sepax_error *error) {
  const sepax_soup *const mesh[2] = {a, b};
  sepax_size found = {.poses = 0};
  range all;
  if (!check_space(mesh, space, error)) {
    return false;
  }
  range hull = hull_of(mesh, space);
  if (!find_space(&all, &hull, space, error) || !find_grid(&found.grid, &all, space, error)) {
    return false;
  }
  for (int axis = 0; axis < 3; axis++) {
    found.low[axis] = hull.low[axis];
    found.high[axis] = hull.high[axis];
  }
  bodies r = {.moved = {{0}, {0}}};
  found.limited = r.on_grid.limited = space->limited;
  found.clearance = space->clearance;
  found.warning = space->warning;
  r.on_grid.margin = !space->limited                     ? 0
                     : space->warning > space->clearance ? 1 + (int64_t)space->warning
                                                         : 1 + (int64_t)space->clearance;
  bool ok = allocate(&r, mesh)
                ? measure(&found, &r, mesh, space, &all, error)
                : sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu and %zu triangles",
                             a->count, b->count);
  release(&r);
  if (ok) {
    *size = found;
  } else {
    sepax_size_free(&found);
  }
  return ok;
}

void sepax_size_free(sepax_size *size) {
  for (size_t n = 0; n < size->workloads; n++) {
    free(size->workload[n].candidate);
  }
  free(size->workload);
  sepax__size_trees_free(size->trees);
  size->workload = NULL;
  size->workloads = 0;
  size->trees = NULL;
}
