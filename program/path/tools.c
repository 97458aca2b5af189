/* SPDX-License-Identifier: MIT */
/* tools.c - the tools of a program as bodies on one link: flutes, shank and holder of each tool
 * that the path names. The origin of the link is the nose of the spindle, and its z axis leads into
 * the spindle. Meshes contain the true solids of revolution. */
#include "path/tools.h"
#include "mesh/revolve.h"
#include "util/error.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* No point of a tool's mesh is farther from the tool than this, in mm. */
static const double mesh_gap = 0.005;

/* The same of a core, which is compared with the finished part. */
static const double core_gap = 0.0005;

static bool find_link(path_scene *scene, const path_question *q, sepax_error *error) {
  const sepax_mechanism *m = &scene->robot.mechanism;
  size_t n = 0;
  while (n < m->links && strcmp(m->link[n].name, q->tool_link) != 0) {
    n++;
  }
  scene->tool_link = n;
  return n < m->links || sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                                    "tool-link: %.200s has no link %.60s; name the link that holds "
                                    "the tools",
                                    q->urdf, q->tool_link);
}

/* The number of a tool, which is its name in the path. */
static bool number_of(const char *name, int *number) {
  char *end = NULL;
  errno = 0;
  long value = strtol(name, &end, 10);
  *number = (int)value;
  return errno == 0 && end != name && *end == '\0' && value > 0 && value <= INT_MAX;
}

/* The place of the first motion with a tool. */
static size_t first_line(const path_scene *scene, size_t tool) {
  size_t n = 0;
  while (scene->motion.step[n].tool != tool) {
    n++;
  }
  return n;
}

static bool is_tool(const path_scene *scene, size_t name) {
  for (size_t n = 0; n < scene->motion.lines; n++) {
    if (scene->motion.step[n].tool == name) {
      return true;
    }
  }
  return false;
}

/* Check that a tool of the path exists. */
static bool check_tool(const path_scene *scene, size_t name, sepax_error *error) {
  char place[PATH_PLACE];
  const char *text = scene->motion.name[name];
  const char *where = path_place(&scene->motion, first_line(scene, name), place);
  sepax_error inner = {0};
  int number = 0;
  if (!number_of(text, &number)) {
    return sepax_fail(error, SEPAX_ERROR_FORMAT,
                      "%.200s: tool '%.60s' is no number, and tools have numbers; mend the path",
                      where, text);
  }
  return nc_tools_find(&scene->tools, number, &inner) != NULL ||
         sepax_fail(error, inner.code, "%.200s: %.260s", where, inner.text);
}

/* Complete the tools by the rows of the control's table whose tools the path names. */
static bool complete_tools(path_scene *scene, const path_question *q, sepax_error *error) {
  const nc_program *program = &scene->nc.program;
  nc_tool *used = calloc(program->tools + 1, sizeof *used);
  size_t count = 0;
  char table[300];
  if (used == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for tools");
  }
  for (size_t n = 0; n < scene->motion.names; n++) {
    int number = 0;
    bool is = is_tool(scene, n) && number_of(scene->motion.name[n], &number);
    for (size_t k = 0; k < program->tools && is; k++) {
      if (program->tool[k].number == number) {
        used[count++] = program->tool[k];
      }
    }
  }
  snprintf(table, sizeof table, q->tool_table != NULL ? "%.250s" : "tool table of %.250s",
           q->tool_table != NULL ? q->tool_table : q->machine);
  bool ok = nc_tools_complete(&scene->tools, used, count, table, error);
  free(used);
  return ok;
}

bool path_tools_read(path_scene *scene, const path_question *q, sepax_error *error) {
  if (!find_link(scene, q, error) || !nc_tools_read(&scene->tools, q->tools, error)) {
    return false;
  }
  if (scene->motion.step == NULL) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "tools: the path has no column tool; add it, or leave --tools out");
  }
  if (q->machine != NULL && !complete_tools(scene, q, error)) {
    return false;
  }
  for (size_t n = 0; n < scene->motion.names; n++) {
    if (is_tool(scene, n) && !check_tool(scene, n, error)) {
      return false;
    }
  }
  return true;
}

/* -------------------------------------------------------------------------- bodies */

/* From mm above the tip to metres on the link. Factors above 1 keep the mesh around the solid. */
static void place_on_link(sepax_soup *mesh, double length) {
  for (size_t n = 0; n < 3 * mesh->count; n++) {
    double *v = mesh->facet[n / 3].v[n % 3];
    v[0] = v[0] * 1e-3 * (1 + 0x1p-50);
    v[1] = v[1] * 1e-3 * (1 + 0x1p-50);
    v[2] = (v[2] - length) * 1e-3;
  }
}

/* Make a part of a tool, shrunk by so many mm; the scene frees it. */
static bool add_body(path_scene *scene, const path_question *q, const nc_turned_tool *tool,
                     nc_tool_part part, size_t name, double shrink, sepax_error *error) {
  path_body *b = &scene->body[scene->bodies];
  const revolve_how how = {
      .gap = shrink > 0 ? core_gap : mesh_gap, .shrink = shrink, .keep_top = shrink > 0};
  char text[64];
  sepax_soup mesh = {0};
  const char *role = shrink > 0 ? "core" : nc_tool_part_name(part);
  snprintf(text, sizeof text, "T%d %s", tool->number, role);
  *b = (path_body){
      .link = scene->tool_link, .role = role, .tool = name, .turned = tool, .turned_part = part};
  b->name = strdup(text);
  b->part = calloc(1, sizeof *b->part);
  scene->bodies++;
  if (b->name == NULL || b->part == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for tools");
  }
  sepax_error inner = {0};
  if (!sepax__revolve(&mesh, NULL, &tool->part[part], &how, &inner)) {
    if (shrink > 0 && inner.code == SEPAX_ERROR_LIMIT) {
      return sepax_fail(
          error, SEPAX_ERROR_ARGUMENT,
          "gouge: too little is left of the flutes of tool %d, which are shrunk by %g "
          "mm; give a smaller --gouge",
          tool->number, shrink);
    }
    return sepax_fail(error, inner.code, "%.200s:%zu: tool %d, %s: %.200s", scene->tools.path,
                      tool->line, tool->number, role, inner.text);
  }
  if (mesh.count == 0) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "gouge: nothing is left of the flutes of tool %d, which are shrunk by %g mm; "
                      "give a smaller --gouge",
                      tool->number, shrink);
  }
  place_on_link(&mesh, tool->length);
  bool ok = path_body_of_mesh(b, &mesh, q->keep, error);
  sepax_soup_free(&mesh);
  return ok;
}

static bool add_tool(path_scene *scene, const path_question *q, size_t name, sepax_error *error) {
  int number = 0;
  number_of(scene->motion.name[name], &number);
  const nc_turned_tool *tool = nc_tools_find(&scene->tools, number, error);
  bool ok = tool != NULL;
  for (int part = 0; part < NC_TOOL_PARTS && ok; part++) {
    ok = tool->part[part].points == 0 ||
         add_body(scene, q, tool, (nc_tool_part)part, name, 0, error);
  }
  bool has_core = q->part != NULL && tool != NULL && tool->part[NC_FLUTES].points > 0;
  return ok &&
         (!has_core || add_body(scene, q, tool, NC_FLUTES, name, q->gouge.length * 1e3, error));
}

bool path_tools_bodies(path_scene *scene, const path_question *q, sepax_error *error) {
  size_t most = scene->bodies + (NC_TOOL_PARTS + 1) * scene->motion.names;
  path_body *grown = realloc(scene->body, (most + 1) * sizeof *grown);
  if (grown == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for bodies");
  }
  scene->body = grown;
  for (size_t n = 0; n < scene->motion.names; n++) {
    if (is_tool(scene, n) && !add_tool(scene, q, n, error)) {
      return false;
    }
  }
  return true;
}
