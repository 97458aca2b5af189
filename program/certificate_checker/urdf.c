/* SPDX-License-Identifier: MIT */
/* urdf.c - elements and attributes of URDF and SRDF, in libxml2's tree. */
#include "urdf.h"

#include "report.h"
#include "tree.h"

#include <stdlib.h>
#include <string.h>

xmlNode *urdf_single(const urdf_file *u, xmlNode *node, const char *name) {
  xmlNode *first = tree_child(node, name);
  if (first != NULL && tree_from(first->next, name) != NULL)
    cannot("%s:%ld: two %s in one %s", u->file, tree_line(node), name, (const char *)node->name);
  return first;
}

bool urdf_is_word(const char *words, const char *word) {
  const size_t length = strlen(word);
  for (const char *at = strstr(words, word); at != NULL; at = strstr(at + 1, word)) {
    if ((at == words || at[-1] == ' ') && (at[length] == ' ' || at[length] == 0))
      return true;
  }
  return false;
}

void urdf_only_attributes(const urdf_file *u, const xmlNode *node, const char *names) {
  for (const xmlAttr *n = node == NULL ? NULL : node->properties; n != NULL; n = n->next) {
    if (n->ns == NULL && strcmp((const char *)n->name, "name") != 0 &&
        !urdf_is_word(names, (const char *)n->name))
      cannot("%s:%ld: unknown attribute %s of %s", u->file, tree_line(node), (const char *)n->name,
             (const char *)node->name);
  }
}

void urdf_only_elements(const urdf_file *u, const xmlNode *node, const char *names) {
  for (const xmlNode *n = tree_element(node->children); n != NULL; n = tree_element(n->next)) {
    if (n->ns == NULL && !urdf_is_word(names, (const char *)n->name))
      cannot("%s:%ld: unknown element %s in %s", u->file, tree_line(n), (const char *)n->name,
             (const char *)node->name);
  }
}

char *urdf_attribute(const urdf_file *u, xmlNode *node, const char *name) {
  char *text = node == NULL ? NULL : (char *)xmlGetProp(node, (const xmlChar *)name);
  if (text == NULL)
    cannot("%s: no %s where there must be one", u->file, name);
  return text;
}

void urdf_numbers(const urdf_file *u, xmlNode *node, const char *name, int count,
                  long double *value) {
  char *text = node == NULL ? NULL : (char *)xmlGetProp(node, (const xmlChar *)name);
  if (text == NULL)
    return;
  const char *next = text;
  for (int n = 0; n < count; n++) {
    char *end = NULL;
    value[n] = strtold(next, &end);
    if (end == next || !isfinite(value[n]))
      cannot("%s: %s=\"%s\"", u->file, name, text);
    next = end;
  }
  if (next[strspn(next, " \t\r\n")] != 0)
    cannot("%s: %s=\"%s\"", u->file, name, text);
  xmlFree(text);
}

long double urdf_number(const urdf_file *u, xmlNode *node, const char *name) {
  long double value = NAN;
  urdf_numbers(u, node, name, 1, &value);
  if (!isfinite(value))
    cannot("%s: no %s where there must be one", u->file, name);
  return value;
}

pose urdf_origin(const urdf_file *u, xmlNode *node) {
  long double xyz[3] = {0, 0, 0};
  long double rpy[3] = {NAN, NAN, NAN};
  long double quat[4] = {NAN, NAN, NAN, NAN};
  xmlNode *at = urdf_single(u, node, "origin");
  urdf_only_attributes(u, at, "xyz rpy quat_xyzw");
  urdf_numbers(u, at, "xyz", 3, xyz);
  urdf_numbers(u, at, "rpy", 3, rpy);
  urdf_numbers(u, at, "quat_xyzw", 4, quat);
  if (isfinite(quat[0])) {
    const quaternion q = {quat[3], {quat[0], quat[1], quat[2]}};
    const long double length = sqrtl(q.w * q.w + point_dot(q.v, q.v));
    if (isfinite(rpy[0]) || !u->has_quaternions || !(fabsl(length - 1) <= 1e-3L))
      cannot("%s:%ld: quat_xyzw", u->file, tree_line(at));
    return (pose){{q.w / length, point_times(1 / length, q.v)}, {xyz[0], xyz[1], xyz[2]}};
  }
  for (int n = 0; n < 3; n++)
    rpy[n] = isfinite(rpy[n]) ? rpy[n] : 0;
  const quaternion roll = quaternion_about((point){1, 0, 0}, rpy[0]);
  const quaternion pitch = quaternion_about((point){0, 1, 0}, rpy[1]);
  const quaternion yaw = quaternion_about((point){0, 0, 1}, rpy[2]);
  return (pose){quaternion_product(yaw, quaternion_product(pitch, roll)), {xyz[0], xyz[1], xyz[2]}};
}
