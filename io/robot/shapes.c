/* SPDX-License-Identifier: MIT */
/* shapes.c - makes triangles from collision geometry, in the coordinates of its link. */
#include "robot/robot.h"
#include "util/error.h"
#include "util/hash.h"
#include "util/memory.h"
#include "util/options.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 0x1.921fb54442d18p1;

/* A factor that keeps rounding from moving a polyhedron inside its shape. */
static const double outward = 1 + 0x1p-40;

/* Sides of a cylinder; a sphere's are those of an octahedron, each divided into SPLIT^2. */
enum { SIDES = 64, SPLIT = 24, SPHERE_FACETS = 8 * SPLIT * SPLIT };

static bool make_facets(sepax_soup *mesh, size_t count, sepax_error *error) {
  mesh->facet = sepax__zeroed(count, sizeof *mesh->facet);
  mesh->count = mesh->facet != NULL ? count : 0;
  return mesh->facet != NULL ||
         sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu triangles", count);
}

static bool make_box(sepax_soup *mesh, const double side[3], sepax_error *error) {
  if (!make_facets(mesh, 12, error)) {
    return false;
  }
  for (int face = 0; face < 6; face++) {
    int axis = face / 2;
    double sign = face % 2 == 0 ? -0.5 : 0.5;
    for (int half = 0; half < 2; half++) {
      static const int corner[2][3][2] = {{{0, 0}, {1, 0}, {1, 1}}, {{0, 0}, {1, 1}, {0, 1}}};
      sepax_facet *facet = &mesh->facet[2 * face + half];
      for (int k = 0; k < 3; k++) {
        int to = face % 2 == 0 ? 2 - k : k; /* counterclockwise from outside */
        facet->v[to][axis] = sign * side[axis];
        for (int i = 0; i < 2; i++) {
          int other = (axis + 1 + i) % 3;
          facet->v[to][other] = (corner[half][k][i] - 0.5) * side[other];
        }
      }
    }
  }
  return true;
}

static void set_vertex(sepax_facet *facet, int k, double x, double y, double z) {
  facet->v[k][0] = x;
  facet->v[k][1] = y;
  facet->v[k][2] = z;
}

/* A prism around the cylinder: corners are at radius / cos(pi / SIDES). */
static bool make_cylinder(sepax_soup *mesh, double radius, double length, sepax_error *error) {
  if (!make_facets(mesh, (size_t)4 * SIDES, error)) {
    return false;
  }
  double out = radius / cos(pi / SIDES) * outward;
  double z = length / 2;
  for (int n = 0; n < SIDES; n++) {
    double a = 2 * pi * n / SIDES;
    double b = 2 * pi * ((n + 1) % SIDES) / SIDES;
    double p[2] = {out * cos(a), out * sin(a)};
    double q[2] = {out * cos(b), out * sin(b)};
    sepax_facet *facet = &mesh->facet[(size_t)4 * (size_t)n];
    set_vertex(&facet[0], 0, 0, 0, -z);
    set_vertex(&facet[0], 1, q[0], q[1], -z);
    set_vertex(&facet[0], 2, p[0], p[1], -z);
    set_vertex(&facet[1], 0, p[0], p[1], -z);
    set_vertex(&facet[1], 1, q[0], q[1], -z);
    set_vertex(&facet[1], 2, q[0], q[1], z);
    set_vertex(&facet[2], 0, p[0], p[1], -z);
    set_vertex(&facet[2], 1, q[0], q[1], z);
    set_vertex(&facet[2], 2, p[0], p[1], z);
    set_vertex(&facet[3], 0, 0, 0, z);
    set_vertex(&facet[3], 1, p[0], p[1], z);
    set_vertex(&facet[3], 2, q[0], q[1], z);
  }
  return true;
}

/* ------------------------------------------------------------------------- spheres */

/* The point of the unit sphere over i, j, SPLIT - i - j of the octahedron's corners x, y, z. The
 * angles on its edges are equal, so that triangles are nearly so. */
static void sphere_point(int i, int j, double v[3]) {
  const double quarter = pi / 2 / SPLIT;
  const double part[3] = {sin(quarter * i), sin(quarter * j), sin(quarter * (SPLIT - i - j))};
  double length = sqrt(part[0] * part[0] + part[1] * part[1] + part[2] * part[2]);
  for (int k = 0; k < 3; k++) {
    v[k] = part[k] / length;
  }
}

static void add_octant(sepax_facet **next, int octant, const int ij[3][2]) {
  double mirrored = 1;
  double v[3][3];
  for (int axis = 0; axis < 3; axis++) {
    mirrored *= (octant >> axis & 1) != 0 ? -1 : 1;
  }
  for (int k = 0; k < 3; k++) {
    sphere_point(ij[k][0], ij[k][1], v[k]);
    for (int axis = 0; axis < 3; axis++) {
      v[k][axis] *= (octant >> axis & 1) != 0 ? -1 : 1;
    }
  }
  for (int k = 0; k < 3; k++) {
    memcpy((*next)->v[mirrored > 0 ? k : 2 - k], v[k], sizeof v[k]);
  }
  ++*next;
}

/* The distance of the triangle's plane from the origin. */
static double height(const sepax_facet *facet) {
  double p[3];
  double q[3];
  double above = 0;
  double square = 0;
  for (int i = 0; i < 3; i++) {
    p[i] = facet->v[1][i] - facet->v[0][i];
    q[i] = facet->v[2][i] - facet->v[0][i];
  }
  for (int i = 0; i < 3; i++) {
    double normal = p[(i + 1) % 3] * q[(i + 2) % 3] - p[(i + 2) % 3] * q[(i + 1) % 3];
    above += normal * facet->v[0][i];
    square += normal * normal;
  }
  return fabs(above) / sqrt(square);
}

/* Fill the first SPHERE_FACETS facets of the mesh. Returns the factor by which the sphere of radius
 * 1 was scaled. */
static double fill_sphere(sepax_soup *mesh, double radius) {
  sepax_facet *next = mesh->facet;
  for (int octant = 0; octant < 8; octant++) {
    for (int i = 0; i < SPLIT; i++) {
      for (int j = 0; i + j < SPLIT; j++) {
        const int up[3][2] = {{i, j}, {i + 1, j}, {i, j + 1}};
        const int down[3][2] = {{i + 1, j}, {i + 1, j + 1}, {i, j + 1}};
        add_octant(&next, octant, up);
        if (i + j + 1 < SPLIT) {
          add_octant(&next, octant, down);
        }
      }
    }
  }
  double least = 1;
  for (size_t n = 0; n < SPHERE_FACETS; n++) {
    least = fmin(least, height(&mesh->facet[n]));
  }
  double scale = radius / least * outward;
  for (size_t n = 0; n < 9 * (size_t)SPHERE_FACETS; n++) {
    mesh->facet[n / 9].v[n % 9 / 3][n % 3] *= scale;
  }
  return scale;
}

static bool make_sphere(sepax_soup *mesh, double radius, sepax_error *error) {
  if (!make_facets(mesh, SPHERE_FACETS, error)) {
    return false;
  }
  fill_sphere(mesh, radius);
  return true;
}

/* The side of a capsule between its half spheres, whose rims are the sphere's edges at z = 0. */
static void fill_side(sepax_facet *next, double scale, double z) {
  for (int quadrant = 0; quadrant < 4; quadrant++) {
    const double sign[2] = {(quadrant & 1) != 0 ? -1 : 1, (quadrant & 2) != 0 ? -1 : 1};
    for (int i = 0; i < SPLIT; i++, next += 2) {
      double v[2][3];
      int first = sign[0] * sign[1] > 0; /* counterclockwise, seen from above */
      sphere_point(i, SPLIT - i, v[first]);
      sphere_point(i + 1, SPLIT - i - 1, v[1 - first]);
      for (int k = 0; k < 4; k++) {
        v[k / 2][k % 2] *= sign[k % 2];
        v[k / 2][k % 2] *= scale;
      }
      set_vertex(&next[0], 0, v[0][0], v[0][1], -z);
      set_vertex(&next[0], 1, v[1][0], v[1][1], -z);
      set_vertex(&next[0], 2, v[1][0], v[1][1], z);
      set_vertex(&next[1], 0, v[0][0], v[0][1], -z);
      set_vertex(&next[1], 1, v[1][0], v[1][1], z);
      set_vertex(&next[1], 2, v[0][0], v[0][1], z);
    }
  }
}

/* A cylinder with half a sphere on each end; `length` is the cylinder's. The half of a polyhedron
 * around a sphere that is above z = 0 holds the half of the sphere, and its rim at z = 0 goes
 * around the circle, so the side holds the cylinder. */
static bool make_capsule(sepax_soup *mesh, double radius, double length, sepax_error *error) {
  if (length == 0) {
    return make_sphere(mesh, radius, error);
  }
  if (!make_facets(mesh, SPHERE_FACETS + 8 * SPLIT, error)) {
    return false;
  }
  double scale = fill_sphere(mesh, radius);
  double z = length / 2 * outward;
  for (size_t n = 0; n < 3 * (size_t)SPHERE_FACETS; n++) {
    bool below = n / 3 / (SPLIT * SPLIT) >= 4; /* octants of negative z */
    mesh->facet[n / 3].v[n % 3][2] += below ? -z : z;
  }
  fill_side(mesh->facet + SPHERE_FACETS, scale, z);
  return true;
}

/* -------------------------------------------------------------------------- places */

/* A mesh that the factors mirror is turned round, triangle by triangle, so that its outer side
 * remains the outer one. */
static void scale_mesh(sepax_soup *mesh, const double scale[3]) {
  const bool mirrors = ((scale[0] < 0) ^ (scale[1] < 0) ^ (scale[2] < 0)) != 0;
  for (size_t n = 0; n < 9 * mesh->count; n++) {
    mesh->facet[n / 9].v[n % 9 / 3][n % 3] *= scale[n % 3];
  }
  for (size_t n = 0; n < mesh->count && mirrors; n++) {
    double second[3];
    memcpy(second, mesh->facet[n].v[1], sizeof second);
    memcpy(mesh->facet[n].v[1], mesh->facet[n].v[2], sizeof second);
    memcpy(mesh->facet[n].v[2], second, sizeof second);
  }
}

static bool is_at_origin(const sepax_pose *pose) {
  for (int i = 0; i < 9; i++) {
    if (pose->rotation[i / 3][i % 3] != (i / 3 == i % 3)) {
      return false;
    }
  }
  return pose->translation[0] == 0 && pose->translation[1] == 0 && pose->translation[2] == 0;
}

void sepax__place_mesh(sepax_soup *mesh, const sepax_pose *pose) {
  for (size_t n = 0; n < 3 * mesh->count && !is_at_origin(pose); n++) {
    double *v = mesh->facet[n / 3].v[n % 3];
    sepax_pose_apply(pose, v, v);
  }
}

/* ---------------------------------------------------------------------- repetition */

static int compare_vertices(const double p[3], const double q[3]) {
  for (int i = 0; i < 3; i++) {
    if (p[i] < q[i] || p[i] > q[i]) {
      return p[i] < q[i] ? -1 : 1;
    }
  }
  return 0;
}

/* The corners of a triangle, the least first; -0 becomes 0. */
static void sort_corners(const sepax_facet *facet, double v[3][3]) {
  for (int k = 0; k < 3; k++) {
    double corner[3];
    int at = k;
    for (int i = 0; i < 3; i++) {
      corner[i] = facet->v[k][i] + 0.0;
    }
    for (; at > 0 && compare_vertices(v[at - 1], corner) > 0; at--) {
      memcpy(v[at], v[at - 1], sizeof corner);
    }
    memcpy(v[at], corner, sizeof corner);
  }
}

bool sepax__distinct(sepax_soup *mesh) {
  size_t slots = 16;
  while (slots < 2 * mesh->count) {
    slots *= 2;
  }
  uint32_t *slot =
      sepax__zeroed(slots, sizeof *slot); /* number of a triangle that stays, plus one */
  size_t kept = 0;
  for (size_t n = 0; slot != NULL && n < mesh->count; n++) {
    double v[3][3];
    double other[3][3];
    bool is_new = true;
    sort_corners(&mesh->facet[n], v);
    size_t at = (size_t)hash_doubles((const double *)v, 9) & (slots - 1);
    for (; slot[at] != 0 && is_new; at = (at + 1) & (slots - 1)) {
      sort_corners(&mesh->facet[slot[at] - 1], other);
      is_new = false;
      for (int k = 0; k < 3; k++) {
        is_new = is_new || compare_vertices(v[k], other[k]) != 0;
      }
    }
    if (is_new) {
      mesh->facet[kept++] = mesh->facet[n];
      slot[at] = (uint32_t)kept;
    }
  }
  bool ok = slot != NULL;
  mesh->count = ok ? kept : mesh->count;
  sepax_release(slot);
  return ok;
}

static bool read_mesh(sepax_soup *mesh, sepax_mesh_account *account, const sepax_shape *shape,
                      const sepax_shape_reading *how, sepax_error *error) {
  static const double metre = 1000; /* mm */
  const sepax_mesh_reading file = {.size = sizeof file, .fans = how->fans};
  double unit = how->unit;
  if (!sepax_mesh_read(mesh, account, shape->path, &file, error)) {
    return false;
  }
  if (unit == 0) {
    unit = strcmp(account->format, "DAE") == 0 ? account->unit_mm / metre
           : account->unit_mm > 0              ? account->unit_mm
                                               : 1;
  }
  const double scale[3] = {unit * shape->size[0], unit * shape->size[1], unit * shape->size[2]};
  scale_mesh(mesh, scale);
  return true;
}

static bool make_mesh(sepax_soup *mesh, sepax_mesh_account *account, const sepax_shape *shape,
                      const sepax_shape_reading *how, sepax_error *error) {
  switch (shape->kind) {
  case SEPAX_SHAPE_MESH:
    return read_mesh(mesh, account, shape, how, error);
  case SEPAX_SHAPE_BOX:
    return make_box(mesh, shape->size, error);
  case SEPAX_SHAPE_CYLINDER:
    return make_cylinder(mesh, shape->size[0], shape->size[1], error);
  case SEPAX_SHAPE_SPHERE:
    return make_sphere(mesh, shape->size[0], error);
  case SEPAX_SHAPE_CAPSULE:
    return make_capsule(mesh, shape->size[0], shape->size[1], error);
  }
  return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "a shape has the kind %d; give a sepax_shape_kind",
                    (int)shape->kind);
}

bool sepax_shape_mesh(sepax_soup *mesh, sepax_mesh_account *account, const sepax_shape *shape,
                      const sepax_shape_reading *how, sepax_error *error) {
  sepax_mesh_account unused = {0};
  sepax_shape_reading h;
  account = account != NULL ? account : &unused;
  *mesh = (sepax_soup){0};
  *account = (sepax_mesh_account){0};
  if (!sepax__options(&h, sizeof h, how, "sepax_shape_reading", error)) {
    return false;
  }
  if (!(h.unit >= 0 && h.unit <= 1e9)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "a unit of %g m is not within 0 ... 1e9 m",
                      h.unit);
  }
  if (!make_mesh(mesh, account, shape, &h, error)) {
    sepax_soup_free(mesh);
    return false;
  }
  if (!h.unplaced) {
    sepax__place_mesh(mesh, &shape->origin);
  }
  return true;
}

const char *sepax_shape_kind_name(sepax_shape_kind kind) {
  static const char *const names[] = {"mesh", "box", "cylinder", "sphere", "capsule"};
  return names[kind];
}

static void free_others(sepax_robot_others *others) {
  for (size_t n = 0; n < others->count; n++) {
    sepax_release(others->entry[n].what);
  }
  sepax_release(others->entry);
  *others = (sepax_robot_others){0};
}

void sepax_srdf_free(sepax_srdf *srdf) {
  sepax_release(srdf->robot);
  free_others(&srdf->others);
  *srdf = (sepax_srdf){0};
}

void sepax_robot_free(sepax_robot *robot) {
  for (size_t n = 0; n < robot->shapes; n++) {
    sepax_release(robot->shape[n].path);
    sepax_release(robot->shape[n].name);
  }
  sepax_release(robot->shape);
  sepax_release(robot->nothing);
  sepax_release(robot->name);
  free_others(&robot->others);
  sepax_mechanism_free(&robot->mechanism);
  *robot = (sepax_robot){0};
}
