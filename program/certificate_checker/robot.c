/* SPDX-License-Identifier: MIT */
/* robot.c - URDF and SRDF, read with libxml2's tree. */
#include "robot.h"

#include "report.h"
#include "tree.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
  const char *file;
  const packages *folders;
  files *files;
  bool has_quaternions; /* since 1.1 */
  long links, joints, collisions;
} context;

/* The element of that name, of which there is one, or none (NULL). */
static xmlNode *single(const context *c, xmlNode *node, const char *name) {
  xmlNode *first = tree_child(node, name);
  if (first != NULL && tree_from(first->next, name) != NULL)
    cannot("%s:%ld: two %s in one %s", c->file, tree_line(node), name, (const char *)node->name);
  return first;
}

static bool is_word(const char *words, const char *word) {
  const size_t length = strlen(word);
  for (const char *at = strstr(words, word); at != NULL; at = strstr(at + 1, word)) {
    if ((at == words || at[-1] == ' ') && (at[length] == ' ' || at[length] == 0))
      return true;
  }
  return false;
}

/* No attributes but those named, with a blank between them: one that is misspelt would be lost.
 * What has a prefix belongs to another program. */
static void only_attributes(const context *c, const xmlNode *node, const char *names) {
  for (const xmlAttr *n = node == NULL ? NULL : node->properties; n != NULL; n = n->next) {
    if (n->ns == NULL && !is_word(names, (const char *)n->name))
      cannot("%s:%ld: unknown attribute %s of %s", c->file, tree_line(node), (const char *)n->name,
             (const char *)node->name);
  }
}

static void only_elements(const context *c, const xmlNode *node, const char *names) {
  for (const xmlNode *n = tree_element(node->children); n != NULL; n = tree_element(n->next)) {
    if (n->ns == NULL && !is_word(names, (const char *)n->name))
      cannot("%s:%ld: unknown element %s in %s", c->file, tree_line(n), (const char *)n->name,
             (const char *)node->name);
  }
}

static char *attribute(const context *c, xmlNode *node, const char *name) {
  char *text = node == NULL ? NULL : (char *)xmlGetProp(node, (const xmlChar *)name);
  if (text == NULL)
    cannot("%s: no %s where there must be one", c->file, name);
  return text;
}

/* Exactly count numbers; the values stay as they are where there is no such attribute. */
static void numbers(const context *c, xmlNode *node, const char *name, int count,
                    long double *value) {
  char *text = node == NULL ? NULL : (char *)xmlGetProp(node, (const xmlChar *)name);
  if (text == NULL)
    return;
  const char *next = text;
  for (int n = 0; n < count; n++) {
    char *end = NULL;
    value[n] = strtold(next, &end);
    if (end == next || !isfinite(value[n]))
      cannot("%s: %s=\"%s\"", c->file, name, text);
    next = end;
  }
  if (next[strspn(next, " \t\r\n")] != 0)
    cannot("%s: %s=\"%s\"", c->file, name, text);
  xmlFree(text);
}

static long double number(const context *c, xmlNode *node, const char *name) {
  long double value = NAN;
  numbers(c, node, name, 1, &value);
  if (!isfinite(value))
    cannot("%s: no %s where there must be one", c->file, name);
  return value;
}

/* Roll about x, then pitch about y, then yaw about z, each of them fixed axes; or, since URDF 1.1,
 * a quaternion, scalar part last. */
static pose origin(const context *c, xmlNode *node) {
  long double xyz[3] = {0, 0, 0};
  long double rpy[3] = {NAN, NAN, NAN};
  long double quat[4] = {NAN, NAN, NAN, NAN};
  xmlNode *at = single(c, node, "origin");
  only_attributes(c, at, "xyz rpy quat_xyzw");
  numbers(c, at, "xyz", 3, xyz);
  numbers(c, at, "rpy", 3, rpy);
  numbers(c, at, "quat_xyzw", 4, quat);
  if (isfinite(quat[0])) {
    const quaternion q = {quat[3], {quat[0], quat[1], quat[2]}};
    const long double length = sqrtl(q.w * q.w + point_dot(q.v, q.v));
    if (isfinite(rpy[0]) || !c->has_quaternions || !(fabsl(length - 1) <= 1e-3L))
      cannot("%s:%ld: quat_xyzw", c->file, tree_line(at));
    return (pose){{q.w / length, point_times(1 / length, q.v)}, {xyz[0], xyz[1], xyz[2]}};
  }
  for (int n = 0; n < 3; n++)
    rpy[n] = isfinite(rpy[n]) ? rpy[n] : 0;
  const quaternion roll = quaternion_about((point){1, 0, 0}, rpy[0]);
  const quaternion pitch = quaternion_about((point){0, 1, 0}, rpy[1]);
  const quaternion yaw = quaternion_about((point){0, 0, 1}, rpy[2]);
  return (pose){quaternion_product(yaw, quaternion_product(pitch, roll)), {xyz[0], xyz[1], xyz[2]}};
}

/* folder/name; name where it is absolute. */
static char *joined(const char *folder, size_t length, const char *name) {
  if (name[0] == '/' || length == 0)
    return text_copy(name, strlen(name));
  char *path = memory(NULL, length + strlen(name) + 2, 1);
  memcpy(path, folder, length);
  path[length] = '/';
  strcpy(path + length + 1, name);
  return path;
}

static char *mesh_file(const context *c, const char *name) {
  static const char PACKAGE[] = "package://";
  static const char FILE_SCHEME[] = "file://";
  if (strncmp(name, PACKAGE, sizeof PACKAGE - 1) == 0) {
    const char *of = name + sizeof PACKAGE - 1;
    const size_t length = strcspn(of, "/");
    for (size_t n = 0; n < c->folders->count; n++) {
      const package *p = &c->folders->entry[n];
      if (strlen(p->name) == length && strncmp(p->name, of, length) == 0 && of[length] == '/') {
        return joined(p->folder, strlen(p->folder), of + length + 1);
      }
    }
    cannot("%s: %s: no folder of this package (-p NAME:FOLDER)", c->file, name);
  }
  if (strncmp(name, FILE_SCHEME, sizeof FILE_SCHEME - 1) == 0) {
    return text_copy(name + sizeof FILE_SCHEME - 1, strlen(name) - (sizeof FILE_SCHEME - 1));
  }
  if (strstr(name, "://") != NULL)
    cannot("%s: %s: no file", c->file, name);
  const char *slash = strrchr(c->file, '/');
  if (slash == c->file)
    slash++;
  return joined(c->file, slash == NULL ? 0 : (size_t)(slash - c->file), name);
}

/* Above 0, or 0 if that may be. */
static long double length_of(const context *c, xmlNode *node, const char *name, bool zero) {
  const long double value = number(c, node, name);
  if (!(value > 0 || (zero && value == 0)))
    cannot("%s:%ld: %s of %Lg", c->file, tree_line(node), name, value);
  return value;
}

static void read_mesh(const context *c, xmlNode *node, pose at, surface *body) {
  long double scale[3] = {1, 1, 1};
  only_attributes(c, node, "filename scale");
  numbers(c, node, "scale", 3, scale);
  if (scale[0] == 0 || scale[1] == 0 || scale[2] == 0)
    cannot("%s:%ld: a scale of 0", c->file, tree_line(node));
  char *name = attribute(c, node, "filename");
  char *file = mesh_file(c, name);
  size_t length = 0;
  char *bytes = files_read(c->files, file, name, &length);
  mesh m = mesh_read(file, bytes, length);
  files_text(c->files, name, "format", m.format);
  files_count(c->files, name, "faces", (long double)m.faces);
  files_count(c->files, name, "triangles", (long double)m.triangles);
  if (m.unit_mm != 0)
    files_count(c->files, name, "unit_mm", m.unit_mm);
  /* Of a 3MF a millimetre, of files without a unit their unit is that of the URDF. */
  const long double unit = strcmp(m.format, "3MF") == 0   ? m.unit_mm
                           : strcmp(m.format, "DAE") == 0 ? m.unit_mm / 1000
                                                          : 1;
  surface_mesh(body, &m, (point){unit * scale[0], unit * scale[1], unit * scale[2]}, at);
  mesh_free(&m);
  free(bytes);
  free(file);
  xmlFree(name);
}

/* A box that is a point has no surface. */
static void read_box(const context *c, xmlNode *node, pose at, surface *body) {
  long double size[3] = {NAN, NAN, NAN};
  only_attributes(c, node, "size");
  numbers(c, node, "size", 3, size);
  if (size[0] == 0 && size[1] == 0 && size[2] == 0)
    return;
  if (!(size[0] > 0 && size[1] > 0 && size[2] > 0))
    cannot("%s:%ld: a box's size", c->file, tree_line(node));
  surface_box(body, (point){size[0], size[1], size[2]}, at);
}

/* A cylinder or capsule that is a point has no surface; a capsule without a length is a sphere. */
static void read_round(const context *c, xmlNode *node, pose at, surface *body) {
  only_attributes(c, node, "radius length");
  const bool capsule = tree_is(node, "capsule");
  const bool none = number(c, node, "radius") == 0 && number(c, node, "length") == 0;
  const long double radius = length_of(c, node, "radius", none);
  const long double length = length_of(c, node, "length", none || capsule);
  if (none)
    return;
  if (capsule)
    surface_capsule(body, radius, length, at);
  else
    surface_cylinder(body, radius, length, at);
}

static void collision(context *c, xmlNode *node, surface *body) {
  const pose at = origin(c, node);
  xmlNode *geometry = single(c, node, "geometry");
  only_elements(c, node,
                "origin geometry material verbose contact "
                "contact_coefficients surface");
  only_attributes(c, node, "name group concave");
  if (geometry == NULL || xmlChildElementCount(geometry) != 1)
    cannot("%s:%ld: not one geometry", c->file, tree_line(node));
  only_attributes(c, geometry, "name");
  xmlNode *shape = tree_element(geometry->children);
  c->collisions++;
  surface_element(body);
  if (tree_is(shape, "mesh")) {
    read_mesh(c, shape, at, body);
  } else if (tree_is(shape, "box")) {
    read_box(c, shape, at, body);
  } else if (tree_is(shape, "cylinder") || tree_is(shape, "capsule")) {
    read_round(c, shape, at, body);
  } else if (tree_is(shape, "sphere")) {
    only_attributes(c, shape, "radius");
    const long double radius = length_of(c, shape, "radius", true);
    if (radius > 0)
      surface_sphere(body, radius, at);
  } else {
    cannot("%s: geometry other than mesh, box, cylinder, sphere, capsule", c->file);
  }
}

/* Elements of other programs are passed over, unless a collision may be meant. */
static void check_names(const context *c, const xmlNode *node) {
  for (const xmlNode *n = tree_element(node->children); n != NULL; n = tree_element(n->next)) {
    const char *name = (const char *)n->name;
    if (n->ns == NULL &&
        !is_word("collision collision_checking self_collision_checking disable_collisions "
                 "enable_collisions disable_default_collisions",
                 name) &&
        (xmlStrcasestr(n->name, (const xmlChar *)"coll") != NULL ||
         xmlStrcasestr(n->name, (const xmlChar *)"geometry") != NULL))
      cannot("%s:%ld: unknown element %s in %s", c->file, tree_line(n), name,
             (const char *)node->name);
  }
}

static void read_link(context *c, xmlNode *node, robot *r) {
  robot_link new = {.name = attribute(c, node, "name"), .joint = -1};
  if (robot_link_named(r, new.name) >= 0)
    cannot("%s: two links %s", c->file, new.name);
  check_names(c, node);
  for (xmlNode *n = tree_child(node, "collision"); n != NULL; n = tree_from(n->next, "collision")) {
    collision(c, n, &new.body);
  }
  if (new.body.count > 0)
    surface_finish(&new.body);
  GROW(r->link, r->links);
  r->link[r->links++] = new;
}

static void add_joint(const context *c, robot *r, joint new) {
  if (robot_joint_named(r, new.name) >= 0)
    cannot("%s: two joints %s", c->file, new.name);
  if (r->link[new.child].joint >= 0)
    cannot("%s: link %s has two parents", c->file, r->link[new.child].name);
  r->link[new.child].joint = r->joints;
  GROW(r->joint, r->joints);
  r->joint[r->joints++] = new;
}

/* A joint of several values J is joints J/x ... one behind the other, with empty links between
 * them; turns are about axes that those before have moved. `names` are letters: x, y, z are shifts;
 * Y, P, R are yaw, pitch, roll. */
static void divide_joint(const context *c, robot *r, joint whole, const char *names) {
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
        cannot("%s: two links %s", c->file, new.name);
      GROW(r->link, r->links);
      r->link[r->links] = (robot_link){.name = new.name, .joint = -1};
      new.child = r->links++;
    }
    add_joint(c, r, new);
    whole.parent = new.child;
    whole.origin = POSE_NONE;
  }
}

static void read_joint(const context *c, xmlNode *node, robot *r) {
  joint new = {
      attribute(c, node, "name"), JOINT_FIXED, 0, 0, origin(c, node), {1, 0, 0}, -1, NULL, 1, 0};
  only_attributes(c, node, "name type dont_collapse");
  const char *kind = attribute(c, node, "type");
  if (strcmp(kind, "revolute") == 0 || strcmp(kind, "continuous") == 0) {
    new.kind = JOINT_REVOLUTE;
  } else if (strcmp(kind, "prismatic") == 0) {
    new.kind = JOINT_PRISMATIC;
  } else if (strcmp(kind, "fixed") != 0 && strcmp(kind, "floating") != 0 &&
             strcmp(kind, "planar") != 0) {
    cannot("%s: joint %s: type %s", c->file, new.name, kind);
  }
  new.parent = robot_link_named(r, attribute(c, single(c, node, "parent"), "link"));
  new.child = robot_link_named(r, attribute(c, single(c, node, "child"), "link"));
  if (new.parent < 0 || new.child < 0)
    cannot("%s: joint %s: no such link", c->file, new.name);
  long double xyz[3] = {1, 0, 0};
  only_attributes(c, single(c, node, "axis"), "xyz");
  numbers(c, single(c, node, "axis"), "xyz", 3, xyz);
  single(c, node, "limit"); /* not read */
  const point axis = {xyz[0], xyz[1], xyz[2]};
  const long double length = point_length(axis);
  if (new.kind != JOINT_FIXED) {
    if (!(length > 0 && isfinite(length)))
      cannot("%s: joint %s: axis", c->file, new.name);
    new.axis = point_times(1 / length, axis);
  }
  xmlNode *mimic = single(c, node, "mimic");
  if (mimic != NULL && new.kind != JOINT_FIXED) {
    only_attributes(c, mimic, "joint multiplier offset");
    new.mimics = attribute(c, mimic, "joint");
    numbers(c, mimic, "multiplier", 1, &new.factor);
    numbers(c, mimic, "offset", 1, &new.offset);
  }
  const bool planar = strcmp(kind, "planar") == 0;
  if (planar && (xyz[0] != 0 || xyz[1] != 0 || !(xyz[2] > 0)))
    cannot("%s: joint %s: planar, and its axis is not 0 0 1", c->file, new.name);
  if (!planar && strcmp(kind, "floating") != 0) {
    add_joint(c, r, new);
    return;
  }
  if (mimic != NULL)
    cannot("%s: joint %s: mimic of a joint with several values", c->file, new.name);
  divide_joint(c, r, new, planar ? "xyY" : "xyzYPR");
}

static xmlNode *document(const context *c) {
  size_t length = 0;
  char *bytes = files_read(c->files, c->file, c->file, &length);
  xmlNode *root = tree_root(c->file, bytes, length);
  free(bytes);
  if (!tree_is(root, "robot"))
    cannot("%s: has no robot", c->file);
  return root;
}

static void check_trees(const context *c, robot *r) {
  const char *root = NULL;
  for (int n = 0; n < r->links; n++) {
    if (r->link[n].joint < 0 && root != NULL)
      cannot("%s: two roots, %s and %s", c->file, root, r->link[n].name);
    root = r->link[n].joint < 0 ? r->link[n].name : root;
  }
  for (int n = 0; n < r->links; n++) {
    int steps = 0;
    for (int at = n; r->link[at].joint >= 0; at = r->joint[r->link[at].joint].parent) {
      if (++steps > r->joints)
        cannot("%s: a circle of joints at %s", c->file, r->link[n].name);
    }
  }
  for (int n = 0; n < r->joints; n++) {
    joint *j = &r->joint[n];
    if (j->mimics == NULL)
      continue;
    j->mimic = robot_joint_named(r, j->mimics);
    if (j->mimic < 0)
      cannot("%s: joint %s: no joint %s", c->file, j->name, j->mimics);
  }
  for (int n = 0; n < r->joints; n++) {
    int steps = 0;
    for (int at = n; r->joint[at].mimic >= 0; at = r->joint[at].mimic) {
      if (++steps > r->joints)
        cannot("%s: joint %s mimics itself", c->file, r->joint[n].name);
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

static void check_version(context *c, xmlNode *root) {
  char *version = tree_attribute(root, "version", NULL);
  if (version != NULL && !is_word("1.0 1.1 1.2", version))
    cannot("%s: version %s; 1.0, 1.1 and 1.2 are read", c->file, version);
  c->has_quaternions = version != NULL && strcmp(version, "1.0") != 0;
  xmlFree(version);
}

robot robot_read(const char *urdf, const char *srdf, const packages *folders, files *f) {
  context c = {.file = urdf, .folders = folders, .files = f};
  robot r = {0};
  xmlNode *root = document(&c);
  check_version(&c, root);
  check_names(&c, root);
  for (xmlNode *n = tree_child(root, "link"); n != NULL; n = tree_from(n->next, "link")) {
    read_link(&c, n, &r);
    c.links++;
  }
  for (xmlNode *n = tree_child(root, "joint"); n != NULL; n = tree_from(n->next, "joint")) {
    read_joint(&c, n, &r);
    c.joints++;
  }
  if (r.links == 0)
    cannot("%s: no link", urdf);
  files_count(f, urdf, "links", c.links);
  files_count(f, urdf, "joints", c.joints);
  files_count(f, urdf, "collisions", c.collisions);
  check_trees(&c, &r);
  const size_t squares = (size_t)r.links * (size_t)r.links;
  r.excluded = memory(NULL, squares, sizeof *r.excluded);
  memset(r.excluded, 0, squares * sizeof *r.excluded);
  if (srdf == NULL) {
    exclude_joined(&r);
    return r;
  }
  const context of = {.file = srdf, .folders = folders, .files = f};
  static const char *const unread[] = {"disable_default_collisions", "enable_collisions"};
  const char *name = "disable_collisions";
  xmlNode *pairs = document(&of);
  for (int n = 0; n < 2; n++) {
    if (tree_child(pairs, unread[n]) != NULL)
      cannot("%s: %s: only disable_collisions is read", srdf, unread[n]);
  }
  for (xmlNode *n = tree_child(pairs, name); n != NULL; n = tree_from(n->next, name)) {
    exclude(&r, robot_link_named(&r, attribute(&of, n, "link1")),
            robot_link_named(&r, attribute(&of, n, "link2")));
  }
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
