/* urdf.c - URDF: links with collision geometry, and the joints between them. */
#include "formats/formats.h"
#include "xml/xml.h"
#include "formats/packages.h"
#include "mechanism/steps.h"
#include "util/list.h"
#include "util/plain_numbers.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const sepax_pose at_origin = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};

typedef struct {
  xml_file file;
  format_robot *robot;
  const format_places *places;
  size_t shape_capacity, joint_capacity, link_capacity;
} reader;

/* ------------------------------------------------------------------------ geometry */

/* <origin xyz rpy>: about x by r, then y by p, then z by y, axes that stay. */
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

static bool above_zero(const reader *r, const xmlNode *node, const double *size, int count,
                       sepax_error *error) {
  for (int i = 0; i < count; i++) {
    if (!(size[i] > 0) || size[i] > 1e6) {
      return sepax__xml_fail(&r->file, node, error,
                             "<%.20s>: a length of %.9g m; give one above 0, and up to 1e6",
                             (const char *)node->name, size[i]);
    }
  }
  return true;
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

static bool read_geometry(const reader *r, const xmlNode *node, format_shape *shape,
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
                           "<collision> without geometry; give mesh, box, cylinder "
                           "or sphere");
  }
  if (sepax__xml_is(what, "mesh")) {
    return read_mesh(r, what, shape, error);
  }
  if (sepax__xml_is(what, "box")) {
    shape->kind = FORMAT_BOX;
    return sepax__xml_numbers(&r->file, what, "size", shape->size, 3, error) &&
           above_zero(r, what, shape->size, 3, error);
  }
  bool cylinder = sepax__xml_is(what, "cylinder");
  if (!cylinder && !sepax__xml_is(what, "sphere")) {
    return sepax__xml_fail(
        &r->file, what, error,
        "<%.40s> is no geometry that is known; give mesh, box, cylinder or sphere",
        (const char *)what->name);
  }
  shape->kind = cylinder ? FORMAT_CYLINDER : FORMAT_SPHERE;
  return sepax__xml_numbers(&r->file, what, "radius", &shape->size[0], 1, error) &&
         sepax__xml_numbers(&r->file, what, "length", &shape->size[1], 1, error) &&
         above_zero(r, what, shape->size, cylinder ? 2 : 1, error);
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
  if (!read_origin(r, node, &shape.origin, error) || !read_geometry(r, node, &shape, error)) {
    sepax_release(shape.name);
    sepax_release(shape.path);
    return false;
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

static bool read_link(reader *r, const xmlNode *node, sepax_error *error) {
  sepax_mechanism *m = &r->robot->mechanism;
  char *name = NULL;
  if (!sepax__xml_name(&r->file, node, "name", &name, error)) {
    return false;
  }
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
  for (const xmlNode *c = sepax__xml_child(node, "collision"); c != NULL;
       c = sepax__xml_next(c, "collision")) {
    if (!read_collision(r, c, m->links - 1, error)) {
      return false;
    }
  }
  return true;
}

/* -------------------------------------------------------------------------- joints */

static bool read_kind(const reader *r, const xmlNode *node, sepax_joint *joint,
                      sepax_error *error) {
  static const char *const names[] = {"fixed", "revolute", "continuous", "prismatic"};
  char *type = NULL;
  if (!sepax__xml_name(&r->file, node, "type", &type, error)) {
    return false;
  }
  int kind = 0;
  while (kind < 4 && strcmp(type, names[kind]) != 0) {
    kind++;
  }
  bool ok = kind < 4 || sepax__xml_fail(&r->file, node, error,
                                        "joint %.60s: type '%.40s' is none of: fixed, revolute, "
                                        "continuous, prismatic",
                                        joint->name, type);
  sepax_release(type);
  joint->kind = ok ? (sepax_joint_kind)kind : SEPAX_JOINT_FIXED;
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
  return sepax__xml_numbers(&r->file, limit, "lower", &joint->lower, 1, error) &&
         sepax__xml_numbers(&r->file, limit, "upper", &joint->upper, 1, error);
}

static bool read_joint(reader *r, const xmlNode *node, sepax_error *error) {
  sepax_mechanism *m = &r->robot->mechanism;
  sepax_joint joint = {.axis = {1, 0, 0}, .mimic = SEPAX_NO_JOINT, .factor = 1};
  sepax_joint *grown = m->joints < FORMAT_LINKS_MOST
                           ? list_grow(m->joint, &r->joint_capacity, m->joints, sizeof *grown)
                           : NULL;
  if (grown == NULL) {
    return sepax__xml_fail(&r->file, node, error, "more than %d joints, or no memory",
                           FORMAT_LINKS_MOST);
  }
  m->joint = grown;
  if (!sepax__xml_name(&r->file, node, "name", &joint.name, error)) {
    return false;
  }
  bool unique = find_joint(m, joint.name) == m->joints;
  m->joint[m->joints++] = joint; /* which frees the name from now on */
  sepax_joint *j = &m->joint[m->joints - 1];
  xmlNode *axis = NULL;
  return (unique ||
          sepax__xml_fail(&r->file, node, error, "two joints '%.60s'; rename one", j->name)) &&
         read_kind(r, node, j, error) && read_end(r, node, "parent", &j->parent, error) &&
         read_end(r, node, "child", &j->child, error) && read_origin(r, node, &j->origin, error) &&
         sepax__xml_single(&r->file, node, "axis", &axis, error) &&
         (axis == NULL || sepax__xml_numbers(&r->file, axis, "xyz", j->axis, 3, error)) &&
         read_limits(r, node, j, error);
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

static bool read_robot(reader *r, sepax_error *error) {
  const xmlNode *root = r->file.root;
  if (sepax__xml_has(root, "name") &&
      !sepax__xml_name(&r->file, root, "name", &r->robot->name, error)) {
    return false;
  }
  for (const xmlNode *n = sepax__xml_child(root, NULL); n != NULL; n = sepax__xml_next(n, NULL)) {
    if (n->ns != NULL && n->ns->prefix != NULL &&
        strcmp((const char *)n->ns->prefix, "xacro") == 0) {
      return sepax__xml_fail(&r->file, n, error,
                             "<xacro:%.40s> is of xacro; run xacro on the file first",
                             (const char *)n->name);
    }
    if (sepax__xml_is(n, "link") && !read_link(r, n, error)) {
      return false;
    }
  }
  for (const xmlNode *n = sepax__xml_child(root, "joint"); n != NULL;
       n = sepax__xml_next(n, "joint")) {
    if (!read_joint(r, n, error)) {
      return false;
    }
  }
  size_t k = 0;
  for (const xmlNode *n = sepax__xml_child(root, "joint"); n != NULL;
       n = sepax__xml_next(n, "joint")) {
    if (!read_mimic(r, n, &r->robot->mechanism.joint[k++], error)) {
      return false;
    }
  }
  sepax_error inner = {0};
  size_t wrong = SEPAX_NO_JOINT;
  if (sepax__mechanism_join(&r->robot->mechanism, &wrong, &inner)) {
    return true;
  }
  const xmlNode *at = wrong != SEPAX_NO_JOINT ? sepax__xml_child(root, "joint") : root;
  for (size_t n = 0; n < wrong && wrong != SEPAX_NO_JOINT; n++) {
    at = sepax__xml_next(at, "joint");
  }
  return sepax__xml_fail(&r->file, at, error, "%.230s", inner.text);
}

bool format_urdf_read(format_robot *robot, const char *path, const format_package *package,
                      size_t packages, sepax_error *error) {
  const format_places places = {path, package, packages};
  reader r = {.robot = robot, .places = &places};
  *robot = (format_robot){0};
  plain_numbers plain = plain_numbers_begin();
  bool ok = sepax__xml_open(&r.file, path, "robot", error) && read_robot(&r, error);
  plain_numbers_end(plain);
  sepax__xml_close(&r.file);
  if (!ok) {
    format_robot_free(robot);
  }
  return ok;
}
