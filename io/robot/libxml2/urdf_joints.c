/* SPDX-License-Identifier: MIT */
/* urdf_joints.c - joints of URDF, and those that become several: floating and planar ones. */
#include "robot/libxml2/urdf.h"
#include "util/list.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static size_t find_joint(const sepax_mechanism *m, const char *name) {
  size_t n = 0;
  while (n < m->joints && strcmp(m->joint[n].name, name) != 0) {
    n++;
  }
  return n;
}

/* What a joint element becomes: one joint of the mechanism, or several. */
typedef enum { ONE_JOINT, FLOATING, PLANAR } joint_parts;

static bool read_kind(const urdf_reader *r, const xmlNode *node, sepax_joint *joint,
                      joint_parts *parts, sepax_error *error) {
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

static bool read_end(const urdf_reader *r, const xmlNode *node, const char *which, size_t *link,
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
  *link = sepax__urdf_find_link(m, name);
  bool ok = *link < m->links ||
            sepax__xml_fail(&r->file, end, error, "<%s>: there is no link '%.60s'; mend the name",
                            which, name);
  sepax_release(name);
  return ok;
}

static bool read_limits(const urdf_reader *r, const xmlNode *node, sepax_joint *joint,
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

/* Add a joint. It takes over the name, also on failure. */
static sepax_joint *add_joint(urdf_reader *r, const xmlNode *node, char *name, sepax_error *error) {
  sepax_mechanism *m = &r->robot->mechanism;
  const sepax_joint joint = {.name = name,
                             .origin = urdf_at_origin,
                             .axis = {1, 0, 0},
                             .lower = -INFINITY,
                             .upper = INFINITY,
                             .mimic = SEPAX_NO_JOINT,
                             .factor = 1};
  bool fits = m->joints < SEPAX_ROBOT_LINKS_MOST;
  sepax_joint *grown =
      fits ? list_grow(m->joint, &r->joint_capacity, m->joints, sizeof *grown) : NULL;
  m->joint = grown != NULL ? grown : m->joint;
  const xmlNode **nodes =
      grown != NULL ? list_grow(r->node, &r->node_capacity, m->joints, sizeof *nodes) : NULL;
  if (nodes == NULL) {
    sepax_release(name);
    if (fits) {
      sepax__xml_no_memory(&r->file, node, error);
    } else {
      sepax__xml_fail(&r->file, node, error, "more than %d joints; leave some out",
                      SEPAX_ROBOT_LINKS_MOST);
    }
    return NULL;
  }
  r->node = nodes;
  bool unique = find_joint(m, name) == m->joints;
  r->node[m->joints] = node;
  m->joint[m->joints++] = joint; /* from now on the mechanism frees the name */
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
static bool is_divided(const urdf_reader *r, const char *name) {
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

/* Divide a joint into several, from the parent on, with links without geometry between them. Yaw,
 * pitch and roll turn about axes that the turns before have moved, which is the rotation of rpy. */
static bool divide_joint(urdf_reader *r, const xmlNode *node, size_t whole, const joint_part *part,
                         size_t parts, sepax_error *error) {
  sepax_mechanism *m = &r->robot->mechanism;
  const size_t child = m->joint[whole].child;
  char *name = m->joint[whole].name; /* from now on the name of the first part */
  bool ok = true;
  for (size_t n = 0; n < parts && ok; n++) {
    char *own = part_name(name, part[n].name);
    char *link = own != NULL && n + 1 < parts ? part_name(name, part[n].name) : NULL;
    bool taken = own != NULL && n == 0 && find_joint(m, own) < m->joints;
    if (own == NULL || taken || (n + 1 < parts && link == NULL)) {
      ok = taken ? sepax__xml_fail(&r->file, node, error, "two joints '%.60s'; rename one", own)
                 : sepax__xml_no_memory(&r->file, node, error);
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
      ok = link == NULL || sepax__urdf_add_link(r, node, link, error);
      j->child = link != NULL ? m->links - 1 : child;
    }
  }
  if (m->joint[whole].name != name) {
    sepax_release(name);
  }
  return ok;
}

static bool divide(urdf_reader *r, const xmlNode *node, joint_parts parts, sepax_error *error) {
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

bool sepax__urdf_read_joint(urdf_reader *r, const xmlNode *node, sepax_error *error) {
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
      !read_end(r, node, "child", &j->child, error) ||
      !sepax__urdf_read_origin(r, node, &j->origin, error) ||
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

bool sepax__urdf_read_mimic(const urdf_reader *r, const xmlNode *node, sepax_joint *joint,
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
