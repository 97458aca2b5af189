/* SPDX-License-Identifier: MIT */
/* collision.c - the collision elements of a link: meshes, boxes, cylinders, spheres, capsules. */
#include "collision.h"

#include "report.h"
#include "tree.h"

#include <stdlib.h>
#include <string.h>

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

static char *mesh_file(const urdf_file *u, const char *name) {
  static const char PACKAGE[] = "package://";
  static const char FILE_SCHEME[] = "file://";
  if (strncmp(name, PACKAGE, sizeof PACKAGE - 1) == 0) {
    const char *of = name + sizeof PACKAGE - 1;
    const size_t length = strcspn(of, "/");
    for (size_t n = 0; n < u->folders->count; n++) {
      const package *p = &u->folders->entry[n];
      if (strlen(p->name) == length && strncmp(p->name, of, length) == 0 && of[length] == '/') {
        return joined(p->folder, strlen(p->folder), of + length + 1);
      }
    }
    cannot("%s: %s: no folder of this package (-p NAME:FOLDER)", u->file, name);
  }
  if (strncmp(name, FILE_SCHEME, sizeof FILE_SCHEME - 1) == 0) {
    return text_copy(name + sizeof FILE_SCHEME - 1, strlen(name) - (sizeof FILE_SCHEME - 1));
  }
  if (strstr(name, "://") != NULL)
    cannot("%s: %s: no file", u->file, name);
  const char *slash = strrchr(u->file, '/');
  if (slash == u->file)
    slash++;
  return joined(u->file, slash == NULL ? 0 : (size_t)(slash - u->file), name);
}

/* Above 0, or 0 if that may be. */
static long double length_of(const urdf_file *u, xmlNode *node, const char *name, bool zero) {
  const long double value = urdf_number(u, node, name);
  if (!(value > 0 || (zero && value == 0)))
    cannot("%s:%ld: %s of %Lg", u->file, tree_line(node), name, value);
  return value;
}

static void read_mesh(const urdf_file *u, xmlNode *node, pose at, surface *body) {
  long double scale[3] = {1, 1, 1};
  urdf_only_attributes(u, node, "filename scale");
  urdf_numbers(u, node, "scale", 3, scale);
  if (scale[0] == 0 || scale[1] == 0 || scale[2] == 0)
    cannot("%s:%ld: a scale of 0", u->file, tree_line(node));
  char *name = urdf_attribute(u, node, "filename");
  char *file = mesh_file(u, name);
  size_t length = 0;
  char *bytes = files_read(u->files, file, name, &length);
  mesh m = mesh_read(file, bytes, length);
  files_text(u->files, name, "format", m.format);
  files_count(u->files, name, "faces", (long double)m.faces);
  files_count(u->files, name, "triangles", (long double)m.triangles);
  if (m.unit_mm != 0)
    files_count(u->files, name, "unit_mm", m.unit_mm);
  /* Of a 3MF a millimetre, of files without a unit their unit is that of the URDF. */
  const long double unit = strcmp(m.format, "3MF") == 0   ? m.unit_mm
                           : strcmp(m.format, "DAE") == 0 ? m.unit_mm / 1000
                                                          : 1;
  m.fans = files_has(u->files, name, "polygons_as_fans");
  surface_mesh(body, &m, (point){unit * scale[0], unit * scale[1], unit * scale[2]}, at);
  if (m.fans)
    files_count(u->files, name, "polygons_as_fans", (long double)m.fanned);
  mesh_free(&m);
  free(bytes);
  free(file);
  xmlFree(name);
}

/* A box that is a point has no surface. */
static void read_box(const urdf_file *u, xmlNode *node, pose at, surface *body) {
  long double size[3] = {NAN, NAN, NAN};
  urdf_only_attributes(u, node, "size");
  urdf_numbers(u, node, "size", 3, size);
  if (size[0] == 0 && size[1] == 0 && size[2] == 0)
    return;
  if (!(size[0] > 0 && size[1] > 0 && size[2] > 0))
    cannot("%s:%ld: a box's size", u->file, tree_line(node));
  surface_box(body, (point){size[0], size[1], size[2]}, at);
}

/* A cylinder or capsule that is a point has no surface; a capsule without a length is a sphere. */
static void read_round(const urdf_file *u, xmlNode *node, pose at, surface *body) {
  urdf_only_attributes(u, node, "radius length");
  const bool capsule = tree_is(node, "capsule");
  const bool none = urdf_number(u, node, "radius") == 0 && urdf_number(u, node, "length") == 0;
  const long double radius = length_of(u, node, "radius", none);
  const long double length = length_of(u, node, "length", none || capsule);
  if (none)
    return;
  if (capsule)
    surface_capsule(body, radius, length, at);
  else
    surface_cylinder(body, radius, length, at);
}

void collision_read(urdf_file *u, xmlNode *node, surface *body) {
  const pose at = urdf_origin(u, node);
  xmlNode *geometry = urdf_single(u, node, "geometry");
  urdf_only_elements(u, node,
                     "origin geometry material verbose contact "
                     "contact_coefficients surface");
  urdf_only_attributes(u, node, "name group concave");
  if (geometry == NULL || xmlChildElementCount(geometry) != 1)
    cannot("%s:%ld: not one geometry", u->file, tree_line(node));
  urdf_only_attributes(u, geometry, "name");
  xmlNode *shape = tree_element(geometry->children);
  u->collisions++;
  surface_element(body);
  if (tree_is(shape, "mesh")) {
    read_mesh(u, shape, at, body);
  } else if (tree_is(shape, "box")) {
    read_box(u, shape, at, body);
  } else if (tree_is(shape, "cylinder") || tree_is(shape, "capsule")) {
    read_round(u, shape, at, body);
  } else if (tree_is(shape, "sphere")) {
    urdf_only_attributes(u, shape, "radius");
    const long double radius = length_of(u, shape, "radius", true);
    if (radius > 0)
      surface_sphere(body, radius, at);
  } else {
    cannot("%s: geometry other than mesh, box, cylinder, sphere, capsule", u->file);
  }
}
