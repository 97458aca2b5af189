/* SPDX-License-Identifier: MIT */
/* tools.c - parts of tools as links. */
#include "tools.h"

#include "report.h"

#include <stdlib.h>
#include <string.h>

static const char *text_of(const certificate *c, const json_t *body, const char *key) {
  const char *text = json_string_value(json_object_get(body, key));
  if (text == NULL || *text == 0)
    cannot("%s: line 1: a body has no %s", c->file, key);
  return text;
}

static surface surface_of(const certificate *c, const json_t *triangles) {
  mesh m = {.file = c->file};
  surface s = {0};
  for (size_t n = 0; n < json_array_size(triangles); n++) {
    const json_t *numbers = json_array_get(triangles, n);
    long double x[9];
    for (size_t k = 0; k < 9; k++) {
      const json_t *number = json_array_get(numbers, k);
      if (!json_is_number(number) || json_array_size(numbers) != 9)
        cannot("%s: line 1: triangle %zu of a body", c->file, n);
      x[k] = json_number_value(number);
    }
    const point corner[3] = {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, {x[6], x[7], x[8]}};
    mesh_polygon(&m, corner, 3);
  }
  if (m.polygons == 0)
    cannot("%s: line 1: a body has no triangles", c->file);
  surface_element(&s);
  surface_mesh(&s, &m, (point){1, 1, 1}, POSE_NONE);
  surface_finish(&s);
  mesh_free(&m);
  return s;
}

/* The greatest distance of a vertex from the axis, and its heights. */
static void print_body(const robot_link *link, const char *held_by) {
  const surface *s = &link->body;
  double radius = 0;
  for (size_t n = 0; n < s->count; n++) {
    for (int k = 0; k < 3; k++)
      radius = fmax(radius, hypot(s->triangle[n].at[k].x, s->triangle[n].at[k].y));
  }
  printf("%s (%s), on %s with tool %s: radius %.6g m, z %.6g ... %.6g m; taken from the "
         "certificate, not checked\n",
         link->name, link->role, held_by, link->tool, radius, s->low.z, s->high.z);
}

static void add(robot *r, const certificate *c, const json_t *body, int held_by) {
  const char *name = text_of(c, body, "name");
  if (robot_link_named(r, name) >= 0)
    cannot("%s: line 1: two links %s", c->file, name);
  robot_link link = {.name = text_copy(name, strlen(name)),
                     .joint = r->joints,
                     .body = surface_of(c, json_object_get(body, "triangles")),
                     .role = text_of(c, body, "role"),
                     .tool = text_of(c, body, "tool")};
  const joint fixed = {.name = link.name,
                       .kind = JOINT_FIXED,
                       .parent = held_by,
                       .child = r->links,
                       .origin = POSE_NONE,
                       .mimic = -1};
  GROW(r->joint, r->joints);
  r->joint[r->joints++] = fixed;
  GROW(r->link, r->links);
  r->link[r->links++] = link;
  print_body(&link, r->link[held_by].name);
}

/* Parts of tools are compared as the link that holds them, and not with each other. */
static bool *excluded_of(const robot *r, int before, int held_by) {
  const int links = r->links;
  bool *all = memory(NULL, (size_t)links * (size_t)links, sizeof *all);
  for (int a = 0; a < links; a++) {
    for (int b = 0; b < links; b++) {
      const int p = a < before ? a : held_by;
      const int q = b < before ? b : held_by;
      all[a * links + b] = p == q || r->excluded[p * before + q];
    }
  }
  return all;
}

static void leave_out(const robot *r, const certificate *c, const json_t *names) {
  const char *first = json_string_value(json_array_get(names, 0));
  const char *second = json_string_value(json_array_get(names, 1));
  const int a = first == NULL ? -1 : robot_link_named(r, first);
  const int b = second == NULL ? -1 : robot_link_named(r, second);
  if (a < 0 || b < 0)
    cannot("%s: line 1: a pair that is left out", c->file);
  r->excluded[a * r->links + b] = r->excluded[b * r->links + a] = true;
  printf("%s and %s: left out, nothing is proved of them\n", first, second);
}

void tools_add(robot *r, const certificate *c) {
  const json_t *bodies = json_object_get(c->head, "bodies");
  if (bodies == NULL)
    return;
  const char *name = text_of(c, c->head, "tool_link");
  const int held_by = robot_link_named(r, name);
  if (held_by < 0)
    cannot("%s: line 1: no link %s", c->file, name);
  if (r->link[held_by].body.count > 0)
    printf("%s: its own geometry is left out, the tools take its place\n", name);
  r->link[held_by].body = (surface){0};
  const int before = r->links;
  for (size_t n = 0; n < json_array_size(bodies); n++)
    add(r, c, json_array_get(bodies, n), held_by);
  bool *excluded = excluded_of(r, before, held_by);
  free(r->excluded);
  r->excluded = excluded;
  const json_t *left_out = json_object_get(c->head, "left_out");
  for (size_t n = 0; n < json_array_size(left_out); n++)
    leave_out(r, c, json_array_get(left_out, n));
}
