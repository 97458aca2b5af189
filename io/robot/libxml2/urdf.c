/* SPDX-License-Identifier: MIT */
/* urdf.c - URDF: the version, the elements, the links. */
#include "robot/libxml2/elements.h"
#include "robot/libxml2/urdf.h"
#include "mechanism/steps.h"
#include "util/list.h"
#include "util/options.h"
#include "util/plain_numbers.h"

#include <string.h>

/* URDF 1.0 ... 1.2, and what files of robots add to it. */
static const element_row elements[] = {
    {"robot", "name version", "", "", "link joint",
     "material transmission gazebo sensor ros2_control group group_state end_effector "
     "virtual_joint passive_joint disable_collisions enable_collisions disable_default_collisions",
     true},
    {"link", "name", "type", "", "collision",
     "visual inertial contact gravity kinematic self_collide self_filter surface sensor gazebo "
     "collision_checking self_collision_checking",
     true},
    {"collision", "", "name group concave", "", "origin geometry",
     "material verbose contact contact_coefficients surface", false},
    {"geometry", "", "name", "", "mesh box cylinder sphere capsule", "", false},
    {"mesh", "filename scale", "", "name", "", "", false},
    {"box", "size", "", "name", "", "", false},
    {"cylinder", "radius length", "", "name", "", "", false},
    {"sphere", "radius", "", "name", "", "", false},
    {"capsule", "radius length", "", "name", "", "", false},
    {"origin", "xyz rpy quat_xyzw", "", "name", "", "", false},
    {"joint", "name type", "dont_collapse", "", "origin parent child axis limit mimic",
     "dynamics calibration safety_controller gazebo", true},
    {"parent", "link", "", "name", "", "", false},
    {"child", "link", "", "name", "", "", false},
    {"axis", "xyz", "", "rpy name", "", "", false},
    {"limit", "lower upper",
     "effort velocity acceleration deceleration jerk command_effort current gear_velocity", "name",
     "", "", false},
    {"mimic", "joint multiplier offset", "", "name", "", "", false},
    {NULL, NULL, NULL, NULL, NULL, NULL, false}};

/* Without the attribute: 1.0. */
static bool read_version(urdf_reader *r, sepax_error *error) {
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

/* --------------------------------------------------------------------------- links */

size_t sepax__urdf_find_link(const sepax_mechanism *m, const char *name) {
  size_t n = 0;
  while (n < m->links && strcmp(m->link[n].name, name) != 0) {
    n++;
  }
  return n;
}

bool sepax__urdf_add_link(urdf_reader *r, const xmlNode *node, char *name, sepax_error *error) {
  sepax_mechanism *m = &r->robot->mechanism;
  bool fits = m->links < SEPAX_ROBOT_LINKS_MOST;
  sepax_link *grown = fits ? list_grow(m->link, &r->link_capacity, m->links, sizeof *grown) : NULL;
  m->link = grown != NULL ? grown : m->link;
  if (grown == NULL || sepax__urdf_find_link(m, name) < m->links) {
    sepax_release(name);
    return fits && grown == NULL ? sepax__xml_no_memory(&r->file, node, error)
                                 : sepax__xml_fail(&r->file, node, error, "%s",
                                                   fits ? "two links of one name; rename one"
                                                        : "more than 4096 links; leave some out");
  }
  m->link[m->links++] = (sepax_link){.name = name};
  return true;
}

static bool read_link(urdf_reader *r, const xmlNode *node, sepax_error *error) {
  sepax_mechanism *m = &r->robot->mechanism;
  char *name = NULL;
  if (!sepax__xml_name(&r->file, node, "name", &name, error) ||
      !sepax__urdf_add_link(r, node, name, error)) {
    return false;
  }
  for (const xmlNode *c = sepax__xml_child(node, "collision"); c != NULL;
       c = sepax__xml_next(c, "collision")) {
    if (!sepax__urdf_read_collision(r, c, m->links - 1, error)) {
      return false;
    }
  }
  return true;
}

/* ---------------------------------------------------------------------------- file */

static bool read_links_and_joints(urdf_reader *r, sepax_error *error) {
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
    if (!sepax__urdf_read_joint(r, n, error)) {
      return false;
    }
  }
  for (size_t n = 0; n < r->robot->mechanism.joints; n++) {
    if (!sepax__urdf_read_mimic(r, r->node[n], &r->robot->mechanism.joint[n], error)) {
      return false;
    }
  }
  return true;
}

static bool read_robot(urdf_reader *r, sepax_error *error) {
  const xmlNode *root = r->file.root;
  if (!read_version(r, error) ||
      !sepax__elements_check(&r->file, elements, &r->robot->others, error) ||
      (sepax__xml_has(root, "name") &&
       !sepax__xml_name(&r->file, root, "name", &r->robot->name, error)) ||
      !read_links_and_joints(r, error)) {
    return false;
  }
  sepax_error inner = {0};
  size_t wrong = SEPAX_NO_JOINT;
  return sepax__mechanism_join(&r->robot->mechanism, &wrong, &inner) ||
         sepax__xml_fail_as(&r->file, wrong != SEPAX_NO_JOINT ? r->node[wrong] : root, error,
                            &inner);
}

bool sepax_robot_read(sepax_robot *robot, const char *path, const sepax_robot_reading *how,
                      sepax_error *error) {
  sepax_robot_reading h;
  *robot = (sepax_robot){0};
  if (!sepax__options(&h, sizeof h, how, "sepax_robot_reading", error)) {
    return false;
  }
  const mesh_places places = {path, h.package, h.packages};
  urdf_reader r = {.robot = robot, .places = &places};
  plain_numbers plain = plain_numbers_begin();
  bool ok = sepax__xml_open(&r.file, path, "robot", error) && read_robot(&r, error);
  plain_numbers_end(plain);
  sepax_release(r.node);
  sepax__xml_close(&r.file);
  if (!ok) {
    sepax_robot_free(robot);
  }
  return ok;
}
