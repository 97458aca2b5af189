/* SPDX-License-Identifier: MIT */
/* srdf.c - reads an SRDF: the pairs of links that are not compared. */
#include "robot/libxml2/elements.h"

#include <stdlib.h>
#include <string.h>

static bool read_link(const xml_file *file, const xmlNode *node, const char *attribute,
                      const sepax_mechanism *m, size_t *link, sepax_error *error) {
  char *name = NULL;
  if (!sepax__xml_name(file, node, attribute, &name, error)) {
    return false;
  }
  *link = 0;
  while (*link < m->links && strcmp(m->link[*link].name, name) != 0) {
    ++*link;
  }
  bool ok = *link < m->links ||
            sepax__xml_fail(file, node, error, "there is no link '%.60s'; mend the name", name);
  sepax_release(name);
  return ok;
}

static bool read_pairs(const xml_file *file, const char *element, bool value, bool *compared,
                       const sepax_mechanism *m, sepax_error *error) {
  for (const xmlNode *n = sepax__xml_child(file->root, element); n != NULL;
       n = sepax__xml_next(n, element)) {
    size_t a;
    size_t b;
    if (!read_link(file, n, "link1", m, &a, error) || !read_link(file, n, "link2", m, &b, error)) {
      return false;
    }
    compared[a * m->links + b] = value;
    compared[b * m->links + a] = value;
  }
  return true;
}

static bool read_defaults(const xml_file *file, bool *compared, const sepax_mechanism *m,
                          sepax_error *error) {
  static const char element[] = "disable_default_collisions";
  for (const xmlNode *n = sepax__xml_child(file->root, element); n != NULL;
       n = sepax__xml_next(n, element)) {
    size_t link;
    if (!read_link(file, n, "link", m, &link, error)) {
      return false;
    }
    for (size_t k = 0; k < m->links; k++) {
      compared[link * m->links + k] = false;
      compared[k * m->links + link] = false;
    }
  }
  return true;
}

/* What else an SRDF may have is of planning groups, and says nothing of pairs. */
static const element_row elements[] = {
    {"robot", "name", "version", "",
     "disable_collisions enable_collisions disable_default_collisions",
     "group group_state end_effector virtual_joint passive_joint joint_property gripper "
     "link_sphere_approximation group_tcps rotor_params specificities",
     true},
    {"disable_collisions", "link1 link2", "reason", "", "", "", false},
    {"enable_collisions", "link1 link2", "reason", "", "", "", false},
    {"disable_default_collisions", "link", "reason", "", "", "", false},
    {NULL, NULL, NULL, NULL, NULL, NULL, false}};

/* A misspelt element would leave its pair compared, and a URDF all of them. What else a file may
 * have, as groups, names no links in this way. */
static bool elements_known(xml_file *file, sepax_robot_others *others, sepax_error *error) {
  static const char sphere[] = "link_sphere_approximation";
  for (const xmlNode *n = sepax__xml_child(file->root, NULL); n != NULL;
       n = sepax__xml_next(n, NULL)) {
    if (sepax__xml_is(n, "link") || sepax__xml_is(n, "joint")) {
      return sepax__xml_fail(file, n, error, "<%s> is of a URDF; give an SRDF",
                             (const char *)n->name);
    }
    bool right = sepax__xml_is(n, sphere);
    for (const element_row *e = elements + 1; e->name != NULL; e++) {
      right = right || sepax__xml_is(n, e->name);
    }
    if (!right &&
        (sepax__xml_has(n, "link1") || sepax__xml_has(n, "link2") || sepax__xml_has(n, "link"))) {
      return sepax__xml_fail(file, n, error, "<%.60s> is no element of SRDF; mend its name",
                             (const char *)n->name);
    }
  }
  return sepax__elements_check(file, elements, others, error);
}

bool sepax_srdf_read(bool *compared, const sepax_mechanism *m, sepax_srdf *srdf, const char *path,
                     sepax_error *error) {
  xml_file file;
  sepax_srdf found = {0};
  if (srdf != NULL) {
    *srdf = found;
  }
  if (!sepax__xml_open(&file, path, "robot", error)) {
    return false;
  }
  bool named = sepax__xml_has(file.root, "name");
  bool ok = (!named || sepax__xml_name(&file, file.root, "name", &found.robot, error)) &&
            elements_known(&file, &found.others, error) &&
            read_defaults(&file, compared, m, error) &&
            read_pairs(&file, "enable_collisions", true, compared, m, error) &&
            read_pairs(&file, "disable_collisions", false, compared, m, error);
  sepax__xml_close(&file);
  if (ok && srdf != NULL) {
    *srdf = found;
  } else {
    sepax_srdf_free(&found);
  }
  return ok;
}
