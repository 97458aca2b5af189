/* SPDX-License-Identifier: MIT */
/* robot.c - links and joints of a URDF, and the pairs that are not checked. */
#include "robot.h"

#include "collision.h"
#include "report.h"
#include "tree.h"
#include "urdf.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Elements of other programs are passed over, unless a collision may be meant. */
static void check_names(const urdf_file *u, const xmlNode *node) {
  for (const xmlNode *n = tree_element(node->children); n != NULL; n = tree_element(n->next)) {
    const char *name = (const char *)n->name;
    if (n->ns == NULL &&
        !urdf_is_word("collision collision_checking self_collision_checking disable_collisions "
                      "enable_collisions disable_default_collisions",
                      name) &&
        (xmlStrcasestr(n->name, (const xmlChar *)"coll") != NULL ||
         xmlStrcasestr(n->name, (const xmlChar *)"geometry") != NULL))
      cannot("%s:%ld: unknown element %s in %s", u->file, tree_line(n), name,
             (const char *)node->name);
  }
}

static void read_link(urdf_file *u, xmlNode *node, robot *r) {
  robot_link new = {.name = urdf_attribute(u, node, "name"), .joint = -1};
  if (robot_link_named(r, new.name) >= 0)
    cannot("%s: two links %s", u->file, new.name);
  check_names(u, node);
  for (xmlNode *n = tree_child(node, "collision"); n != NULL; n = tree_from(n->next, "collision")) {
    collision_read(u, n, &new.body);
  }
  if (new.body.count > 0)
    surface_finish(&new.body);
  GROW(r->link, r->links);
  r->link[r->links++] = new;
}

static void add_joint(const urdf_file *u, robot *r, joint new) {
  if (robot_joint_named(r, new.name) >= 0)
    cannot("%s: two joints %s", u->file, new.name);
  if (r->link[new.child].joint >= 0)
    cannot("%s: link %s has two parents", u->file, r->link[new.child].name);
  r->link[new.child].joint = r->joints;
  GROW(r->joint, r->joints);
  r->joint[r->joints++] = new;
}

/* A joint of several values J is joints J/x ... one behind the other, with empty links between
 * them; turns are about axes that those before have moved. `names` are letters: x, y, z are shifts;
 * Y, P, R are yaw, pitch, roll. */
static void divide_joint(const urdf_file *u, robot *r, joint whole, const char *names) {
  const int child = whole.child;
  for (const char *at = names; *at != 0; at++) {
    const char *part = *at == 'Y' ? "yaw" : *at == 'P' ? "pitch" : *at == 'R' ? "roll" : NULL;
    const char letter[2] = {*at, 0};
    const size_t size = strlen(whole.name) + 8;
    joint new = whole;
    new.name = memory(NULL, size, 1);
    snprintf(new.name, size, "%s/%s", whole.name, part == NULL ? letter : part);
    new.kind = part == NULL ? JOINT_PRISMATIC : JOINT_REVOLUTE;
    new.axis =
        (point){*at == 'x' || *at == 'R', *at == 'y' || *at == 'P', *at == 'z' || *at == 'Y'};
    new.child = child;
    if (at[1] != 0) {
      if (robot_link_named(r, new.name) >= 0)
        cannot("%s: two links %s", u->file, new.name);
      GROW(r->link, r->links);
      r->link[r->links] = (robot_link){.name = new.name, .joint = -1};
      new.child = r->links++;
    }
    add_joint(u, r, new);
    whole.parent = new.child;
    whole.origin = POSE_NONE;
  }
}

static void read_joint(const urdf_file *u, xmlNode *node, robot *r) {
  joint new = {.name = urdf_attribute(u, node, "name"),
               .kind = JOINT_FIXED,
               .origin = urdf_origin(u, node),
               .axis = {1, 0, 0},
               .mimic = -1,
               .factor = 1};
  urdf_only_attributes(u, node, "name type dont_collapse");
  const char *kind = urdf_attribute(u, node, "type");
  if (strcmp(kind, "revolute") == 0 || strcmp(kind, "continuous") == 0) {
    new.kind = JOINT_REVOLUTE;
  } else if (strcmp(kind, "prismatic") == 0) {
    new.kind = JOINT_PRISMATIC;
  } else if (strcmp(kind, "fixed") != 0 && strcmp(kind, "floating") != 0 &&
             strcmp(kind, "planar") != 0) {
    cannot("%s: joint %s: type %s", u->file, new.name, kind);
  }
  new.parent = robot_link_named(r, urdf_attribute(u, urdf_single(u, node, "parent"), "link"));
  new.child = robot_link_named(r, urdf_attribute(u, urdf_single(u, node, "child"), "link"));
  if (new.parent < 0 || new.child < 0)
    cannot("%s: joint %s: no such link", u->file, new.name);
  long double xyz[3] = {1, 0, 0};
  urdf_only_attributes(u, urdf_single(u, node, "axis"), "xyz rpy");
  urdf_numbers(u, urdf_single(u, node, "axis"), "xyz", 3, xyz);
  urdf_single(u, node, "limit"); /* not read */
  const point axis = {xyz[0], xyz[1], xyz[2]};
  const long double length = point_length(axis);
  if (new.kind != JOINT_FIXED) {
    if (!(length > 0 && isfinite(length)))
      cannot("%s: joint %s: axis", u->file, new.name);
    new.axis = point_times(1 / length, axis);
  }
  xmlNode *mimic = urdf_single(u, node, "mimic");
  if (mimic != NULL && new.kind != JOINT_FIXED) {
    urdf_only_attributes(u, mimic, "joint multiplier offset");
    new.mimics = urdf_attribute(u, mimic, "joint");
    urdf_numbers(u, mimic, "multiplier", 1, &new.factor);
    urdf_numbers(u, mimic, "offset", 1, &new.offset);
  }
  const bool planar = strcmp(kind, "planar") == 0;
  if (planar && (xyz[0] != 0 || xyz[1] != 0 || !(xyz[2] > 0)))
    cannot("%s: joint %s: planar, and its axis is not 0 0 1", u->file, new.name);
  if (!planar && strcmp(kind, "floating") != 0) {
    add_joint(u, r, new);
    return;
  }
  if (mimic != NULL)
    cannot("%s: joint %s: mimic of a joint with several values", u->file, new.name);
  divide_joint(u, r, new, planar ? "xyY" : "xyzYPR");
}

static xmlNode *document(const urdf_file *u) {
  size_t length = 0;
  char *bytes = files_read(u->files, u->file, u->file, &length);
  xmlNode *root = tree_root(u->file, bytes, length);
  free(bytes);
  if (!tree_is(root, "robot"))
    cannot("%s: has no robot", u->file);
  return root;
}

static void check_trees(const urdf_file *u, robot *r) {
  const char *root = NULL;
  for (int n = 0; n < r->links; n++) {
    if (r->link[n].joint < 0 && root != NULL)
      cannot("%s: two roots, %s and %s", u->file, root, r->link[n].name);
    root = r->link[n].joint < 0 ? r->link[n].name : root;
  }
  for (int n = 0; n < r->links; n++) {
    int steps = 0;
    for (int at = n; r->link[at].joint >= 0; at = r->joint[r->link[at].joint].parent) {
      if (++steps > r->joints)
        cannot("%s: a circle of joints at %s", u->file, r->link[n].name);
    }
  }
  for (int n = 0; n < r->joints; n++) {
    joint *j = &r->joint[n];
    if (j->mimics == NULL)
      continue;
    j->mimic = robot_joint_named(r, j->mimics);
    if (j->mimic < 0)
      cannot("%s: joint %s: no joint %s", u->file, j->name, j->mimics);
  }
  for (int n = 0; n < r->joints; n++) {
    int steps = 0;
    for (int at = n; r->joint[at].mimic >= 0; at = r->joint[at].mimic) {
      if (++steps > r->joints)
        cannot("%s: joint %s mimics itself", u->file, r->joint[n].name);
    }
  }
}

static void exclude(robot *r, int a, int b) {
  if (a < 0 || b < 0)
    return;
  r->excluded[a * r->links + b] = r->excluded[b * r->links + a] = true;
}

/* Where none of the joints between two links moves. */
static int fixed_root(const robot *r, int link) {
  while (r->link[link].joint >= 0 && r->joint[r->link[link].joint].kind == JOINT_FIXED)
    link = r->joint[r->link[link].joint].parent;
  return link;
}

/* Links that no joint moves against each other, and the two links of a joint. */
static void exclude_joined(robot *r) {
  for (int a = 0; a < r->links; a++) {
    for (int b = 0; b < a; b++) {
      if (fixed_root(r, a) == fixed_root(r, b))
        exclude(r, a, b);
    }
  }
  for (int n = 0; n < r->joints; n++)
    exclude(r, r->joint[n].parent, r->joint[n].child);
}

static void check_version(urdf_file *u, xmlNode *root) {
  char *version = tree_attribute(root, "version", NULL);
  if (version != NULL && !urdf_is_word("1.0 1.1 1.2", version))
    cannot("%s: version %s; 1.0, 1.1 and 1.2 are read", u->file, version);
  u->has_quaternions = version != NULL && strcmp(version, "1.0") != 0;
  xmlFree(version);
}

/* The pairs that an SRDF disables. */
static void exclude_listed(robot *r, const urdf_file *u) {
  static const char *const unread[] = {"disable_default_collisions", "enable_collisions"};
  const char *name = "disable_collisions";
  xmlNode *pairs = document(u);
  for (int n = 0; n < 2; n++) {
    if (tree_child(pairs, unread[n]) != NULL)
      cannot("%s: %s: only disable_collisions is read", u->file, unread[n]);
  }
  for (xmlNode *n = tree_child(pairs, name); n != NULL; n = tree_from(n->next, name)) {
    exclude(r, robot_link_named(r, urdf_attribute(u, n, "link1")),
            robot_link_named(r, urdf_attribute(u, n, "link2")));
  }
}

robot robot_read(const char *urdf, const char *srdf, const packages *folders, files *f) {
  urdf_file u = {.file = urdf, .folders = folders, .files = f};
  robot r = {0};
  long links = 0;
  long joints = 0; /* as the file has them, before a joint of several values is divided */
  xmlNode *root = document(&u);
  check_version(&u, root);
  check_names(&u, root);
  for (xmlNode *n = tree_child(root, "link"); n != NULL; n = tree_from(n->next, "link")) {
    read_link(&u, n, &r);
    links++;
  }
  for (xmlNode *n = tree_child(root, "joint"); n != NULL; n = tree_from(n->next, "joint")) {
    read_joint(&u, n, &r);
    joints++;
  }
  if (r.links == 0)
    cannot("%s: no link", urdf);
  files_count(f, urdf, "links", links);
  files_count(f, urdf, "joints", joints);
  files_count(f, urdf, "collisions", u.collisions);
  check_trees(&u, &r);
  const size_t squares = (size_t)r.links * (size_t)r.links;
  r.excluded = memory(NULL, squares, sizeof *r.excluded);
  memset(r.excluded, 0, squares * sizeof *r.excluded);
  if (srdf == NULL)
    exclude_joined(&r);
  else
    exclude_listed(&r, &(urdf_file){.file = srdf, .folders = folders, .files = f});
  return r;
}

int robot_link_named(const robot *r, const char *name) {
  for (int n = 0; n < r->links; n++) {
    if (strcmp(r->link[n].name, name) == 0)
      return n;
  }
  return -1;
}

int robot_joint_named(const robot *r, const char *name) {
  for (int n = 0; n < r->joints; n++) {
    if (strcmp(r->joint[n].name, name) == 0)
      return n;
  }
  return -1;
}
