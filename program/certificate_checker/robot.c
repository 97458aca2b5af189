/* robot.c - URDF and SRDF, read with libxml2's tree. */
#include "robot.h"

#include "report.h"

#include <libxml/parser.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
  const char *file;
  const packages *folders;
} context;

static bool is(const xmlNode *node, const char *name) {
  return node->type == XML_ELEMENT_NODE && strcmp((const char *)node->name, name) == 0;
}

/* The first element of that name among node and those behind it. */
static xmlNode *from(xmlNode *node, const char *name) {
  while (node != NULL && !is(node, name))
    node = node->next;
  return node;
}

static xmlNode *child(xmlNode *node, const char *name) {
  return node == NULL ? NULL : from(node->children, name);
}

/* The element of that name, of which there is one, or none (NULL). */
static xmlNode *single(const context *c, xmlNode *node, const char *name) {
  xmlNode *first = child(node, name);
  if (first != NULL && from(first->next, name) != NULL)
    cannot("%s:%ld: two %s in one %s", c->file, xmlGetLineNo(node), name, (const char *)node->name);
  return first;
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

/* Roll about x, then pitch about y, then yaw about z, each of them fixed axes. */
static pose origin(const context *c, xmlNode *node) {
  long double xyz[3] = {0, 0, 0};
  long double rpy[3] = {0, 0, 0};
  numbers(c, single(c, node, "origin"), "xyz", 3, xyz);
  numbers(c, single(c, node, "origin"), "rpy", 3, rpy);
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

static long double length_of(const context *c, xmlNode *node, const char *name) {
  const long double value = number(c, node, name);
  if (!(value > 0))
    cannot("%s:%ld: %s of %Lg", c->file, xmlGetLineNo(node), name, value);
  return value;
}

static void collision(const context *c, xmlNode *node, surface *body) {
  const pose at = origin(c, node);
  xmlNode *geometry = single(c, node, "geometry");
  if (geometry == NULL || xmlChildElementCount(geometry) != 1)
    cannot("%s:%ld: not one geometry", c->file, xmlGetLineNo(node));
  xmlNode *mesh = child(geometry, "mesh");
  xmlNode *box = child(geometry, "box");
  xmlNode *cylinder = child(geometry, "cylinder");
  xmlNode *sphere = child(geometry, "sphere");
  surface_element(body);
  if (mesh != NULL) {
    long double scale[3] = {1, 1, 1};
    numbers(c, mesh, "scale", 3, scale);
    if (scale[0] == 0 || scale[1] == 0 || scale[2] == 0)
      cannot("%s:%ld: a scale of 0", c->file, xmlGetLineNo(mesh));
    char *name = attribute(c, mesh, "filename");
    char *file = mesh_file(c, name);
    surface_stl(body, file, (point){scale[0], scale[1], scale[2]}, at);
    free(file);
    xmlFree(name);
  } else if (box != NULL) {
    long double size[3] = {NAN, NAN, NAN};
    numbers(c, box, "size", 3, size);
    if (!(size[0] > 0 && size[1] > 0 && size[2] > 0))
      cannot("%s:%ld: a box's size", c->file, xmlGetLineNo(box));
    surface_box(body, (point){size[0], size[1], size[2]}, at);
  } else if (cylinder != NULL) {
    surface_cylinder(body, length_of(c, cylinder, "radius"), length_of(c, cylinder, "length"), at);
  } else if (sphere != NULL) {
    surface_sphere(body, length_of(c, sphere, "radius"), at);
  } else {
    cannot("%s: geometry other than mesh, box, cylinder, sphere", c->file);
  }
}

static void read_link(const context *c, xmlNode *node, robot *r) {
  robot_link new = {attribute(c, node, "name"), -1, {0}};
  if (robot_link_named(r, new.name) >= 0)
    cannot("%s: two links %s", c->file, new.name);
  for (xmlNode *n = child(node, "collision"); n != NULL; n = from(n->next, "collision")) {
    collision(c, n, &new.body);
  }
  if (new.body.count > 0)
    surface_finish(&new.body);
  GROW(r->link, r->links);
  r->link[r->links++] = new;
}

static void read_joint(const context *c, xmlNode *node, robot *r) {
  joint new = {
      attribute(c, node, "name"), JOINT_FIXED, 0, 0, origin(c, node), {1, 0, 0}, -1, NULL, 1, 0};
  if (robot_joint_named(r, new.name) >= 0)
    cannot("%s: two joints %s", c->file, new.name);
  const char *kind = attribute(c, node, "type");
  if (strcmp(kind, "revolute") == 0 || strcmp(kind, "continuous") == 0) {
    new.kind = JOINT_REVOLUTE;
  } else if (strcmp(kind, "prismatic") == 0) {
    new.kind = JOINT_PRISMATIC;
  } else if (strcmp(kind, "fixed") != 0) {
    cannot("%s: joint %s: type %s", c->file, new.name, kind);
  }
  new.parent = robot_link_named(r, attribute(c, single(c, node, "parent"), "link"));
  new.child = robot_link_named(r, attribute(c, single(c, node, "child"), "link"));
  if (new.parent < 0 || new.child < 0)
    cannot("%s: joint %s: no such link", c->file, new.name);
  long double xyz[3] = {1, 0, 0};
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
    new.mimics = attribute(c, mimic, "joint");
    numbers(c, mimic, "multiplier", 1, &new.factor);
    numbers(c, mimic, "offset", 1, &new.offset);
  }
  if (r->link[new.child].joint >= 0) {
    cannot("%s: link %s has two parents", c->file, r->link[new.child].name);
  }
  r->link[new.child].joint = r->joints;
  GROW(r->joint, r->joints);
  r->joint[r->joints++] = new;
}

/* What libxml2 would print where it cannot open a document type. */
static void be_silent(void *unused, const char *format, ...) {
  (void)unused;
  (void)format;
}

static xmlNode *document(const char *file) {
  size_t length = 0;
  free(file_read(file, &length)); /* says that it is not there */
  xmlSetGenericErrorFunc(NULL, be_silent);
  xmlDoc *doc = xmlReadFile(file, NULL, XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING);
  const xmlError *wrong = doc == NULL ? xmlGetLastError() : NULL;
  const char *why = wrong != NULL && wrong->message != NULL ? wrong->message : "";
  if (doc == NULL)
    cannot("%s:%d: is no XML: %.*s", file, wrong != NULL ? wrong->line : 1, (int)strcspn(why, "\n"),
           why);
  if (doc != NULL && (doc->intSubset != NULL || doc->extSubset != NULL))
    cannot("%s: has a document type", file);
  xmlNode *root = xmlDocGetRootElement(doc);
  if (root == NULL || !is(root, "robot"))
    cannot("%s: has no robot", file);
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

robot robot_read(const char *urdf, const char *srdf, const packages *folders) {
  const context c = {urdf, folders};
  robot r = {0};
  xmlNode *root = document(urdf);
  for (xmlNode *n = child(root, "link"); n != NULL; n = from(n->next, "link")) {
    read_link(&c, n, &r);
  }
  for (xmlNode *n = child(root, "joint"); n != NULL; n = from(n->next, "joint")) {
    read_joint(&c, n, &r);
  }
  if (r.links == 0)
    cannot("%s: no link", urdf);
  check_trees(&c, &r);
  const size_t squares = (size_t)r.links * (size_t)r.links;
  r.excluded = memory(NULL, squares, sizeof *r.excluded);
  memset(r.excluded, 0, squares * sizeof *r.excluded);
  if (srdf == NULL) {
    for (int n = 0; n < r.joints; n++)
      exclude(&r, r.joint[n].parent, r.joint[n].child);
    return r;
  }
  const context of = {srdf, folders};
  static const char *const unread[] = {"disable_default_collisions", "enable_collisions"};
  const char *name = "disable_collisions";
  xmlNode *pairs = document(srdf);
  for (int n = 0; n < 2; n++) {
    if (child(pairs, unread[n]) != NULL)
      cannot("%s: %s: only disable_collisions is read", srdf, unread[n]);
  }
  for (xmlNode *n = child(pairs, name); n != NULL; n = from(n->next, name)) {
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
