/* SPDX-License-Identifier: MIT */
/* urdf_shapes.c - collision geometry of URDF: its shapes and where they are. */
#include "robot/libxml2/urdf.h"
#include "util/list.h"

#include <math.h>

/* The rotation of a quaternion x, y, z, w, which is made one of length 1. */
static bool read_quaternion(const urdf_reader *r, const xmlNode *origin, sepax_pose *pose,
                            sepax_error *error) {
  double q[4];
  if (r->minor < 1) {
    return sepax__xml_fail(&r->file, origin, error,
                           "quat_xyzw is of URDF 1.1; give <robot version=\"1.1\">, or rpy");
  }
  if (sepax__xml_has(origin, "rpy")) {
    return sepax__xml_fail(&r->file, origin, error,
                           "<origin> has rpy and quat_xyzw; leave one of them out");
  }
  if (!sepax__xml_numbers(&r->file, origin, "quat_xyzw", q, 4, error)) {
    return false;
  }
  double length = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  if (!(fabs(length - 1) <= 1e-3)) {
    return sepax__xml_fail(&r->file, origin, error,
                           "quat_xyzw: its length is %.9g; give one of length 1, within 0.001",
                           length);
  }
  double x = q[0] / length;
  double y = q[1] / length;
  double z = q[2] / length;
  double w = q[3] / length;
  const double turned[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
                               {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
                               {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}};
  for (int i = 0; i < 9; i++) {
    pose->rotation[i / 3][i % 3] = turned[i / 3][i % 3];
  }
  return true;
}

/* <origin xyz rpy>, or quat_xyzw instead of rpy: about x by r, then y by p, then z by y, axes that
 * stay. */
bool sepax__urdf_read_origin(const urdf_reader *r, const xmlNode *of, sepax_pose *pose,
                             sepax_error *error) {
  xmlNode *origin = NULL;
  double a[3] = {0, 0, 0};
  *pose = urdf_at_origin;
  if (!sepax__xml_single(&r->file, of, "origin", &origin, error)) {
    return false;
  }
  if (origin == NULL) {
    return true;
  }
  if (!sepax__xml_numbers(&r->file, origin, "xyz", pose->translation, 3, error) ||
      !sepax__xml_numbers(&r->file, origin, "rpy", a, 3, error)) {
    return false;
  }
  for (int i = 0; i < 3; i++) {
    if (fabs(pose->translation[i]) > SEPAX_ROBOT_VALUE_MOST ||
        fabs(a[i]) > SEPAX_ROBOT_VALUE_MOST) {
      return sepax__xml_fail(&r->file, origin, error, "<origin>: a number beyond %g; mend it",
                             SEPAX_ROBOT_VALUE_MOST);
    }
  }
  if (sepax__xml_has(origin, "quat_xyzw")) {
    return read_quaternion(r, origin, pose, error);
  }
  if (a[0] == 0 && a[1] == 0 && a[2] == 0) {
    return true;
  }
  double c[3] = {cos(a[0]), cos(a[1]), cos(a[2])};
  double s[3] = {sin(a[0]), sin(a[1]), sin(a[2])};
  const double turned[3][3] = {
      {c[2] * c[1], c[2] * s[1] * s[0] - s[2] * c[0], c[2] * s[1] * c[0] + s[2] * s[0]},
      {s[2] * c[1], s[2] * s[1] * s[0] + c[2] * c[0], s[2] * s[1] * c[0] - c[2] * s[0]},
      {-s[1], c[1] * s[0], c[1] * c[0]}};
  for (int i = 0; i < 9; i++) {
    pose->rotation[i / 3][i % 3] = turned[i / 3][i % 3];
  }
  return true;
}

/* The lengths of an attribute, which must be there: none negative. */
static bool read_lengths(const urdf_reader *r, const xmlNode *node, const char *attribute,
                         double *size, int count, sepax_error *error) {
  if (!sepax__xml_has(node, attribute)) {
    return sepax__xml_fail(&r->file, node, error, "<%.20s> without %s=\"...\"; give it",
                           (const char *)node->name, attribute);
  }
  if (!sepax__xml_numbers(&r->file, node, attribute, size, count, error)) {
    return false;
  }
  for (int i = 0; i < count; i++) {
    if (!(size[i] >= 0) || size[i] > 1e6) {
      return sepax__xml_fail(&r->file, node, error,
                             "<%.20s>: a length of %.9g m; give one above 0, and up to 1e6",
                             (const char *)node->name, size[i]);
    }
  }
  return true;
}

/* Where all lengths are 0 there is no surface. Where some are, the shape is flat or thin: it would
 * be a surface that has no inside. A capsule whose length is 0 is a sphere. */
static bool check_lengths(const urdf_reader *r, const xmlNode *node, const sepax_shape *shape,
                          bool *nothing, sepax_error *error) {
  int count = shape->kind == SEPAX_SHAPE_BOX ? 3 : shape->kind == SEPAX_SHAPE_SPHERE ? 1 : 2;
  int zeros = 0;
  for (int i = 0; i < count; i++) {
    zeros += shape->size[i] == 0;
  }
  *nothing = zeros == count;
  bool ball = shape->kind == SEPAX_SHAPE_CAPSULE && shape->size[0] > 0;
  return zeros == 0 || *nothing || ball ||
         sepax__xml_fail(&r->file, node, error,
                         "<%.20s>: a length of 0 m makes it flat, without an inside; give one "
                         "above 0, or leave the element out",
                         (const char *)node->name);
}

static bool read_primitive(const urdf_reader *r, const xmlNode *node, sepax_shape *shape,
                           bool *nothing, sepax_error *error) {
  shape->kind = sepax__xml_is(node, "box")        ? SEPAX_SHAPE_BOX
                : sepax__xml_is(node, "cylinder") ? SEPAX_SHAPE_CYLINDER
                : sepax__xml_is(node, "sphere")   ? SEPAX_SHAPE_SPHERE
                                                  : SEPAX_SHAPE_CAPSULE;
  bool long_too = shape->kind == SEPAX_SHAPE_CYLINDER || shape->kind == SEPAX_SHAPE_CAPSULE;
  return (shape->kind == SEPAX_SHAPE_BOX
              ? read_lengths(r, node, "size", shape->size, 3, error)
              : read_lengths(r, node, "radius", &shape->size[0], 1, error) &&
                    (!long_too || read_lengths(r, node, "length", &shape->size[1], 1, error))) &&
         check_lengths(r, node, shape, nothing, error);
}

static bool read_mesh(const urdf_reader *r, const xmlNode *node, sepax_shape *shape,
                      sepax_error *error) {
  shape->kind = SEPAX_SHAPE_MESH;
  for (int i = 0; i < 3; i++) {
    shape->size[i] = 1;
  }
  if (!sepax__xml_numbers(&r->file, node, "scale", shape->size, 3, error) ||
      !sepax__xml_name(&r->file, node, "filename", &shape->name, error)) {
    return false;
  }
  sepax_error inner = {0};
  bool ok = shape->size[0] * shape->size[1] * shape->size[2] != 0 ||
            sepax__xml_fail(&r->file, node, error, "a scale of 0 leaves no body; give another one");
  ok = ok && (sepax__find_mesh(r->places, shape->name, &shape->path, &inner) ||
              sepax__xml_fail_as(&r->file, node, error, &inner));
  return ok;
}

static bool read_geometry(const urdf_reader *r, const xmlNode *node, sepax_shape *shape,
                          bool *nothing, sepax_error *error) {
  xmlNode *geometry = NULL;
  if (!sepax__xml_single(&r->file, node, "geometry", &geometry, error)) {
    return false;
  }
  const xmlNode *what = sepax__xml_child(geometry, NULL);
  const xmlNode *second = what != NULL ? sepax__xml_next(what, NULL) : NULL;
  if (second != NULL) {
    return sepax__xml_fail(
        &r->file, second, error,
        "<%.40s> beside <%.40s> in one <geometry>; give each a <collision> of its own",
        (const char *)second->name, (const char *)what->name);
  }
  if (what == NULL) {
    return sepax__xml_fail(&r->file, node, error,
                           "<collision> without geometry; give mesh, box, cylinder, sphere or "
                           "capsule");
  }
  return sepax__xml_is(what, "mesh") ? read_mesh(r, what, shape, error)
                                     : read_primitive(r, what, shape, nothing, error);
}

static bool add_nothing(urdf_reader *r, const sepax_shape *shape, const xmlNode *node,
                        sepax_error *error) {
  sepax_robot *robot = r->robot;
  sepax_bare_shape *grown =
      list_grow(robot->nothing, &r->nothing_capacity, robot->nothings, sizeof *grown);
  if (grown == NULL) {
    return sepax__xml_no_memory(&r->file, node, error);
  }
  robot->nothing = grown;
  robot->nothing[robot->nothings++] = (sepax_bare_shape){shape->link, shape->kind, shape->line};
  return true;
}

bool sepax__urdf_read_collision(urdf_reader *r, const xmlNode *node, size_t link,
                                sepax_error *error) {
  sepax_robot *robot = r->robot;
  sepax_shape shape = {.link = link, .line = xmlGetLineNo(node)};
  if (robot->shapes == SEPAX_ROBOT_SHAPES_MOST) {
    return sepax__xml_fail(&r->file, node, error, "more than %d collision elements; join some",
                           SEPAX_ROBOT_SHAPES_MOST);
  }
  sepax_shape *grown = list_grow(robot->shape, &r->shape_capacity, robot->shapes, sizeof *grown);
  if (grown == NULL) {
    return sepax__xml_no_memory(&r->file, node, error);
  }
  robot->shape = grown;
  bool nothing = false;
  if (!sepax__urdf_read_origin(r, node, &shape.origin, error) ||
      !read_geometry(r, node, &shape, &nothing, error)) {
    sepax_release(shape.name);
    sepax_release(shape.path);
    return false;
  }
  if (nothing) {
    return add_nothing(r, &shape, node, error);
  }
  robot->shape[robot->shapes++] = shape;
  return true;
}
