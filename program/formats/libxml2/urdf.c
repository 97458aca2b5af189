/* urdf.c - URDF: links with collision geometry, and the joints between them. */
#include "formats/formats.h"
#include "formats/libxml2/elements.h"
#include "formats/packages.h"
#include "mechanism/steps.h"
#include "util/list.h"
#include "util/plain_numbers.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const sepax_pose at_origin = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};

/* URDF 1.0 ... 1.2, and what files of robots add to it. */
static const format_element elements[] = {
    {"robot", "name version", "", "link joint",
     "material transmission gazebo sensor ros2_control group group_state end_effector "
     "virtual_joint passive_joint disable_collisions enable_collisions disable_default_collisions",
     true},
    {"link", "name", "type", "collision",
     "visual inertial contact gravity kinematic self_collide self_filter surface sensor gazebo "
     "collision_checking self_collision_checking",
     true},
    {"collision", "", "name group concave", "origin geometry",
     "material verbose contact contact_coefficients surface", false},
    {"geometry", "", "name", "mesh box cylinder sphere capsule", "", false},
    {"mesh", "filename scale", "", "", "", false},
    {"box", "size", "", "", "", false},
    {"cylinder", "radius length", "", "", "", false},
    {"sphere", "radius", "", "", "", false},
    {"capsule", "radius length", "", "", "", false},
    {"origin", "xyz rpy quat_xyzw", "", "", "", false},
    {"joint", "name type", "dont_collapse", "origin parent child axis limit mimic",
     "dynamics calibration safety_controller gazebo", true},
    {"parent", "link", "", "", "", false},
    {"child", "link", "", "", "", false},
    {"axis", "xyz", "", "", "", false},
    {"limit", "lower upper",
     "effort velocity acceleration deceleration jerk command_effort current gear_velocity", "", "",
     false},
    {"mimic", "joint multiplier offset", "", "", "", false},
    {NULL, NULL, NULL, NULL, NULL, false}};

typedef struct {
  xml_file file;
  format_robot *robot;
  const format_places *places;
  int minor;            /* of version 1.MINOR */
  const xmlNode **node; /* of each joint of the mechanism */
  size_t shape_capacity, nothing_capacity, joint_capacity, node_capacity, link_capacity;
} reader;

/* Without the attribute: 1.0. */
static bool read_version(reader *r, sepax_error *error) {
  static const char *const known[] = {"1.0", "1.1", "1.2"};
  char *version = NULL;
  if (!sepax__xml_has(r->file.root, "version")) {
    return true;
  }
  if (!sepax__xml_name(&r->file, r->file.root, "version", &version, error)) {
    return false;
  }
  while (r->minor < 3 && strcmp(version, known[r->minor]) != 0) {
    r->minor++;
  }
  bool ok = r->minor < 3 ||
            sepax__xml_fail(&r->file, r->file.root, error,
                            "version=\"%.40s\" is not known; give the file as URDF 1.0, 1.1 or 1.2",
                            version);
  sepax_release(version);
  return ok;
}

/* ------------------------------------------------------------------------ geometry */

/* The rotation of a quaternion x, y, z, w, which is made one of length 1. */
static bool read_quaternion(const reader *r, const xmlNode *origin, sepax_pose *pose,
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
static bool read_origin(const reader *r, const xmlNode *of, sepax_pose *pose, sepax_error *error) {
  xmlNode *origin = NULL;
  double a[3] = {0, 0, 0};
  *pose = at_origin;
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
    if (fabs(pose->translation[i]) > FORMAT_VALUE_MOST || fabs(a[i]) > FORMAT_VALUE_MOST) {
      return sepax__xml_fail(&r->file, origin, error, "<origin>: a number beyond %g; mend it",
                             FORMAT_VALUE_MOST);
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
static bool read_lengths(const reader *r, const xmlNode *node, const char *attribute, double *size,
                         int count, sepax_error *error) {
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
static bool check_lengths(const reader *r, const xmlNode *node, const format_shape *shape,
                          bool *nothing, sepax_error *error) {
  int count = shape->kind == FORMAT_BOX ? 3 : shape->kind == FORMAT_SPHERE ? 1 : 2;
  int zeros = 0;
  for (int i = 0; i < count; i++) {
    zeros += shape->size[i] == 0;
  }
  *nothing = zeros == count;
  bool ball = shape->kind == FORMAT_CAPSULE && shape->size[0] > 0;
  return zeros == 0 || *nothing || ball ||
         sepax__xml_fail(&r->file, node, error,
                         "<%.20s>: a length of 0 m makes it flat, without an inside; give one "
                         "above 0, or leave the element out",
                         (const char *)node->name);
}

static bool read_primitive(const reader *r, const xmlNode *node, format_shape *shape, bool *nothing,
                           sepax_error *error) {
  shape->kind = sepax__xml_is(node, "box")        ? FORMAT_BOX
                : sepax__xml_is(node, "cylinder") ? FORMAT_CYLINDER
                : sepax__xml_is(node, "sphere")   ? FORMAT_SPHERE
                                                  : FORMAT_CAPSULE;
  bool long_too = shape->kind == FORMAT_CYLINDER || shape->kind == FORMAT_CAPSULE;
  return (shape->kind == FORMAT_BOX
              ? read_lengths(r, node, "size", shape->size, 3, error)
              : read_lengths(r, node, "radius", &shape->size[0], 1, error) &&
                    (!long_too || read_lengths(r, node, "length", &shape->size[1], 1, error))) &&
         check_lengths(r, node, shape, nothing, error);
}

static bool read_mesh(const reader *r, const xmlNode *node, format_shape *shape,
                      sepax_error *error) {
  shape->kind = FORMAT_MESH;
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
  ok = ok && (format_find_mesh(r->places, shape->name, &shape->path, &inner) ||
              sepax__xml_fail(&r->file, node, error, "%.230s", inner.text));
  return ok;
}

static bool read_geometry(const reader *r, const xmlNode *node, format_shape *shape, bool *nothing,
                          sepax_error *error) {
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

static bool add_nothing(reader *r, const format_shape *shape, const xmlNode *node,
                        sepax_error *error) {
  format_robot *robot = r->robot;
  format_nothing *grown =
      list_grow(robot->nothing, &r->nothing_capacity, robot->nothings, sizeof *grown);
  if (grown == NULL) {
    return sepax__xml_fail(&r->file, node, error, "no memory for it");
  }
  robot->nothing = grown;
  robot->nothing[robot->nothings++] = (format_nothing){shape->link, shape->kind, shape->line};
  return true;
}

static bool read_collision(reader *r, const xmlNode *node, size_t link, sepax_error *error) {
  format_robot *robot = r->robot;
  format_shape shape = {.link = link, .line = xmlGetLineNo(node)};
  format_shape *grown =
      robot->shapes < FORMAT_SHAPES_MOST
          ? list_grow(robot->shape, &r->shape_capacity, robot->shapes, sizeof *grown)
          : NULL;
  if (grown == NULL) {
    return sepax__xml_fail(&r->file, node, error, "more than %d collision elements, or no memory",
                           FORMAT_SHAPES_MOST);
  }
  robot->shape = grown;
  bool nothing = false;
  if (!read_origin(r, node, &shape.origin, error) ||
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

/* --------------------------------------------------------------------------- links */

static size_t find_link(const sepax_mechanism *m, const char *name) {
  size_t n = 0;
  while (n < m->links && strcmp(m->link[n].name, name) != 0) {
    n++;
  }
  return n;
}

static size_t find_joint(const sepax_mechanism *m, const char *name) {
  size_t n = 0;
  while (n < m->joints && strcmp(m->joint[n].name, name) != 0) {
    n++;
  }
  return n;
}

/* Takes the name, also on failure. */
static bool add_link(reader *r, const xmlNode *node, char *name, sepax_error *error) {
  sepax_mechanism *m = &r->robot->mechanism;
  sepax_link *grown = m->links < FORMAT_LINKS_MOST
                          ? list_grow(m->link, &r->link_capacity, m->links, sizeof *grown)
                          : NULL;
  m->link = grown != NULL ? grown : m->link;
  if (grown == NULL || find_link(m, name) < m->links) {
    sepax_release(name);
    return sepax__xml_fail(&r->file, node, error, "%s",
                           grown == NULL ? "more than 4096 links, or no memory"
                                         : "two links of one name; rename one");
  }
  m->link[m->links++] = (sepax_link){.name = name};
  return true;
}

static bool read_link(reader *r, const xmlNode *node, sepax_error *error) {
  sepax_mechanism *m = &r->robot->mechanism;
  char *name = NULL;
  if (!sepax__xml_name(&r->file, node, "name", &name, error) || !add_link(r, node, name, error)) {
    return false;
  }
  for (const xmlNode *c = sepax__xml_child(node, "collision"); c != NULL;
       c = sepax__xml_next(c, "collision")) {
    if (!read_collision(r, c, m->links - 1, error)) {
      return false;
    }
  }
  return true;
}

/* -------------------------------------------------------------------------- joints */

/* Of a joint element: what becomes one joint of the mechanism, or several. */
typedef enum { ONE_JOINT, FLOATING, PLANAR } joint_parts;

static bool read_kind(const reader *r, const xmlNode *node, sepax_joint *joint, joint_parts *parts,
                      sepax_error *error) {
  static const struct {
    const char *name;
    sepax_joint_kind kind;
    joint_parts parts;
  } types[] = {{"fixed", SEPAX_JOINT_FIXED, ONE_JOINT},
               {"revolute", SEPAX_JOINT_REVOLUTE, ONE_JOINT},
               {"continuous", SEPAX_JOINT_CONTINUOUS, ONE_JOINT},
               {"prismatic", SEPAX_JOINT_PRISMATIC, ONE_JOINT},
               {"floating", SEPAX_JOINT_FIXED, FLOATING},
               {"planar", SEPAX_JOINT_FIXED, PLANAR}};
  enum { TYPES = sizeof types / sizeof types[0] };
  char *type = NULL;
  if (!sepax__xml_name(&r->file, node, "type", &type, error)) {
    return false;
  }
  int n = 0;
  while (n < TYPES && strcmp(type, types[n].name) != 0) {
    n++;
  }
  bool ok = n < TYPES || sepax__xml_fail(&r->file, node, error,
                                         "joint %.60s: type '%.40s' is none of: fixed, revolute, "
                                         "continuous, prismatic, floating, planar",
                                         joint->name, type);
  sepax_release(type);
  joint->kind = ok ? types[n].kind : SEPAX_JOINT_FIXED;
  *parts = ok ? types[n].parts : ONE_JOINT;
  return ok;
}

static bool read_end(const reader *r, const xmlNode *node, const char *which, size_t *link,
                     sepax_error *error) {
  const sepax_mechanism *m = &r->robot->mechanism;
  xmlNode *end = NULL;
  char *name = NULL;
  if (!sepax__xml_single(&r->file, node, which, &end, error)) {
    return false;
  }
  if (end == NULL) {
    return sepax__xml_fail(&r->file, node, error, "<joint> without <%s link=\"...\"/>; give one",
                           which);
  }
  if (!sepax__xml_name(&r->file, end, "link", &name, error)) {
    return false;
  }
  *link = find_link(m, name);
  bool ok = *link < m->links ||
            sepax__xml_fail(&r->file, end, error, "<%s>: there is no link '%.60s'; mend the name",
                            which, name);
  sepax_release(name);
  return ok;
}

static bool read_limits(const reader *r, const xmlNode *node, sepax_joint *joint,
                        sepax_error *error) {
  xmlNode *limit = NULL;
  joint->lower = -INFINITY;
  joint->upper = INFINITY;
  if (!sepax__xml_single(&r->file, node, "limit", &limit, error)) {
    return false;
  }
  if (joint->kind != SEPAX_JOINT_REVOLUTE && joint->kind != SEPAX_JOINT_PRISMATIC) {
    return true;
  }
  if (limit == NULL) {
    return sepax__xml_fail(&r->file, node, error,
                           "joint %.60s: %s without <limit lower=\"...\" upper=\"...\"/>; give it",
                           joint->name,
                           joint->kind == SEPAX_JOINT_REVOLUTE ? "revolute" : "prismatic");
  }
  joint->lower = 0;
  joint->upper = 0;
  if (r->minor >= 2 && (!sepax__xml_has(limit, "lower") || !sepax__xml_has(limit, "upper"))) {
    return sepax__xml_fail(&r->file, limit, error,
                           "joint %.60s: URDF 1.2 has no limit of 0 by default; give lower and "
                           "upper",
                           joint->name);
  }
  return sepax__xml_numbers(&r->file, limit, "lower", &joint->lower, 1, error) &&
         sepax__xml_numbers(&r->file, limit, "upper", &joint->upper, 1, error);
}

/* A joint with this name, which becomes its own also on failure. */
static sepax_joint *add_joint(reader *r, const xmlNode *node, char *name, sepax_error *error) {
  sepax_mechanism *m = &r->robot->mechanism;
  const sepax_joint joint = {.name = name,
                             .origin = at_origin,
                             .axis = {1, 0, 0},
                             .lower = -INFINITY,
                             .upper = INFINITY,
                             .mimic = SEPAX_NO_JOINT,
                             .factor = 1};
  sepax_joint *grown = m->joints < FORMAT_LINKS_MOST
                           ? list_grow(m->joint, &r->joint_capacity, m->joints, sizeof *grown)
                           : NULL;
  m->joint = grown != NULL ? grown : m->joint;
  const xmlNode **nodes =
      grown != NULL ? list_grow(r->node, &r->node_capacity, m->joints, sizeof *nodes) : NULL;
  if (nodes == NULL) {
    sepax_release(name);
    sepax__xml_fail(&r->file, node, error, "more than %d joints, or no memory", FORMAT_LINKS_MOST);
    return NULL;
  }
  r->node = nodes;
  bool unique = find_joint(m, name) == m->joints;
  r->node[m->joints] = node;
  m->joint[m->joints++] = joint; /* which frees the name from now on */
  if (!unique) {
    sepax__xml_fail(&r->file, node, error, "two joints '%.60s'; rename one", name);
    return NULL;
  }
  return &m->joint[m->joints - 1];
}

/* "NAME/WHICH" */
static char *part_name(const char *name, const char *which) {
  size_t size = strlen(name) + strlen(which) + 2;
  char *text = sepax_allocate(size);
  if (text != NULL) {
    snprintf(text, size, "%s/%s", name, which);
  }
  return text;
}

/* Is a joint element of this name divided already? Its own name is then none of the mechanism's. */
static bool is_divided(const reader *r, const char *name) {
  const sepax_mechanism *m = &r->robot->mechanism;
  char *first = part_name(name, "x");
  size_t n = first != NULL ? find_joint(m, first) : m->joints;
  xmlChar *of = n < m->joints ? xmlGetNoNsProp(r->node[n], (const xmlChar *)"name") : NULL;
  bool divided = of != NULL && strcmp((const char *)of, name) == 0;
  xmlFree(of);
  sepax_release(first);
  return divided;
}

typedef struct {
  const char *name;
  sepax_joint_kind kind;
  int axis;
} joint_part;

/* A joint as several, from the parent on, with links without geometry between them. Yaw, pitch and
 * roll turn about axes that the turns before have moved: the rotation of rpy. */
static bool divide_joint(reader *r, const xmlNode *node, size_t whole, const joint_part *part,
                         size_t parts, sepax_error *error) {
  sepax_mechanism *m = &r->robot->mechanism;
  const size_t child = m->joint[whole].child;
  char *name = m->joint[whole].name; /* that of the first part from now on */
  bool ok = true;
  for (size_t n = 0; n < parts && ok; n++) {
    char *own = part_name(name, part[n].name);
    char *link = own != NULL && n + 1 < parts ? part_name(name, part[n].name) : NULL;
    bool taken = own != NULL && n == 0 && find_joint(m, own) < m->joints;
    if (own == NULL || taken || (n + 1 < parts && link == NULL)) {
      ok = taken ? sepax__xml_fail(&r->file, node, error, "two joints '%.60s'; rename one", own)
                 : sepax__xml_fail(&r->file, node, error, "no memory for a joint");
      sepax_release(own);
      sepax_release(link);
    } else if (n > 0 && add_joint(r, node, own, error) == NULL) {
      sepax_release(link);
      ok = false;
    } else {
      sepax_joint *j = &m->joint[n > 0 ? m->joints - 1 : whole];
      j->name = own;
      j->kind = part[n].kind;
      j->parent = n > 0 ? m->links - 1 : j->parent;
      for (int i = 0; i < 3; i++) {
        j->axis[i] = i == part[n].axis;
      }
      ok = link == NULL || add_link(r, node, link, error);
      j->child = link != NULL ? m->links - 1 : child;
    }
  }
  if (m->joint[whole].name != name) {
    sepax_release(name);
  }
  return ok;
}

static bool divide(reader *r, const xmlNode *node, joint_parts parts, sepax_error *error) {
  static const joint_part floating[] = {
      {"x", SEPAX_JOINT_PRISMATIC, 0},      {"y", SEPAX_JOINT_PRISMATIC, 1},
      {"z", SEPAX_JOINT_PRISMATIC, 2},      {"yaw", SEPAX_JOINT_CONTINUOUS, 2},
      {"pitch", SEPAX_JOINT_CONTINUOUS, 1}, {"roll", SEPAX_JOINT_CONTINUOUS, 0}};
  static const joint_part planar[] = {{"x", SEPAX_JOINT_PRISMATIC, 0},
                                      {"y", SEPAX_JOINT_PRISMATIC, 1},
                                      {"yaw", SEPAX_JOINT_CONTINUOUS, 2}};
  const sepax_joint *j = &r->robot->mechanism.joint[r->robot->mechanism.joints - 1];
  size_t whole = (size_t)(j - r->robot->mechanism.joint);
  if (parts == FLOATING) {
    return divide_joint(r, node, whole, floating, 6, error);
  }
  /* the format does not say which directions in the plane the two values are along */
  if (j->axis[0] != 0 || j->axis[1] != 0 || !(j->axis[2] > 0)) {
    return sepax__xml_fail(&r->file, node, error,
                           "joint %.60s: planar, and its axis is not 0 0 1; turn it by <origin>, "
                           "so that x and y are in the plane",
                           j->name);
  }
  return divide_joint(r, node, whole, planar, 3, error);
}

static bool read_joint(reader *r, const xmlNode *node, sepax_error *error) {
  char *name = NULL;
  if (!sepax__xml_name(&r->file, node, "name", &name, error)) {
    return false;
  }
  if (is_divided(r, name)) {
    sepax__xml_fail(&r->file, node, error, "two joints '%.60s'; rename one", name);
    sepax_release(name);
    return false;
  }
  xmlNode *axis = NULL;
  joint_parts parts = ONE_JOINT;
  sepax_joint *j = add_joint(r, node, name, error);
  if (j == NULL || !read_kind(r, node, j, &parts, error) ||
      !read_end(r, node, "parent", &j->parent, error) ||
      !read_end(r, node, "child", &j->child, error) || !read_origin(r, node, &j->origin, error) ||
      !sepax__xml_single(&r->file, node, "axis", &axis, error) ||
      (axis != NULL && !sepax__xml_numbers(&r->file, axis, "xyz", j->axis, 3, error)) ||
      !read_limits(r, node, j, error)) {
    return false;
  }
  if (parts != ONE_JOINT && sepax__xml_child(node, "mimic") != NULL) {
    return sepax__xml_fail(&r->file, node, error,
                           "joint %.60s: <mimic> of a joint with several values; leave it out",
                           j->name);
  }
  return parts == ONE_JOINT || divide(r, node, parts, error);
}

static bool read_mimic(const reader *r, const xmlNode *node, sepax_joint *joint,
                       sepax_error *error) {
  const sepax_mechanism *m = &r->robot->mechanism;
  xmlNode *mimic = NULL;
  char *name = NULL;
  if (!sepax__xml_single(&r->file, node, "mimic", &mimic, error)) {
    return false;
  }
  if (mimic == NULL || joint->kind == SEPAX_JOINT_FIXED) {
    return true;
  }
  if (!sepax__xml_name(&r->file, mimic, "joint", &name, error)) {
    return false;
  }
  joint->mimic = find_joint(m, name);
  bool ok =
      joint->mimic < m->joints || sepax__xml_fail(&r->file, mimic, error,
                                                  "<mimic>: there is no joint '%.60s'; mend the "
                                                  "name",
                                                  name);
  sepax_release(name);
  return ok && sepax__xml_numbers(&r->file, mimic, "multiplier", &joint->factor, 1, error) &&
         sepax__xml_numbers(&r->file, mimic, "offset", &joint->offset, 1, error);
}

/* ---------------------------------------------------------------------------- file */

static bool read_links_and_joints(reader *r, sepax_error *error) {
  const xmlNode *root = r->file.root;
  for (const xmlNode *n = sepax__xml_child(root, "link"); n != NULL;
       n = sepax__xml_next(n, "link")) {
    if (!read_link(r, n, error)) {
      return false;
    }
  }
  r->robot->links = r->robot->mechanism.links;
  for (const xmlNode *n = sepax__xml_child(root, "joint"); n != NULL;
       n = sepax__xml_next(n, "joint")) {
    if (!read_joint(r, n, error)) {
      return false;
    }
  }
  for (size_t n = 0; n < r->robot->mechanism.joints; n++) {
    if (!read_mimic(r, r->node[n], &r->robot->mechanism.joint[n], error)) {
      return false;
    }
  }
  return true;
}

static bool read_robot(reader *r, sepax_error *error) {
  const xmlNode *root = r->file.root;
  if (!read_version(r, error) ||
      !format_elements_check(&r->file, elements, &r->robot->others, error) ||
      (sepax__xml_has(root, "name") &&
       !sepax__xml_name(&r->file, root, "name", &r->robot->name, error)) ||
      !read_links_and_joints(r, error)) {
    return false;
  }
  sepax_error inner = {0};
  size_t wrong = SEPAX_NO_JOINT;
  return sepax__mechanism_join(&r->robot->mechanism, &wrong, &inner) ||
         sepax__xml_fail(&r->file, wrong != SEPAX_NO_JOINT ? r->node[wrong] : root, error, "%.230s",
                         inner.text);
}

bool format_urdf_read(format_robot *robot, const char *path, const format_package *package,
                      size_t packages, sepax_error *error) {
  const format_places places = {path, package, packages};
  reader r = {.robot = robot, .places = &places};
  *robot = (format_robot){0};
  plain_numbers plain = plain_numbers_begin();
  bool ok = sepax__xml_open(&r.file, path, "robot", error) && read_robot(&r, error);
  plain_numbers_end(plain);
  sepax_release(r.node);
  sepax__xml_close(&r.file);
  if (!ok) {
    format_robot_free(robot);
  }
  return ok;
}
