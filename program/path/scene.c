/* SPDX-License-Identifier: MIT */
/* scene.c - makes bodies from the links and chooses the pairs of bodies that are compared. */
#include "path/stock/cutting.h"
#include "path/nc/program.h"
#include "path/tools.h"
#include "robot/robot.h"
#include "util/error.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *path_body_name(const path_scene *scene, size_t body) {
  const path_body *b = &scene->body[body];
  return b->name != NULL ? b->name : scene->robot.mechanism.link[b->link].name;
}

const char *path_mesh_file(const path_part *part) {
  return part->shape != NULL ? part->shape->path : NULL;
}

bool path_has_body(const path_scene *scene, size_t link) {
  return scene->body_of[link] < scene->bodies;
}

static void free_body(path_body *b) {
  for (size_t n = 0; n < b->parts; n++) {
    sepax_shell_free(&b->part[n].shell);
    if (b->part[n].body != b->body) {
      sepax_body_free(b->part[n].body);
    }
  }
  sepax_body_free(b->body);
  free(b->name);
  free(b->part);
  sepax_soup_free(&b->mesh);
}

void path_scene_free(path_scene *scene) {
  for (size_t n = 0; n < scene->bodies; n++) {
    free_body(&scene->body[n]);
  }
  for (size_t n = 0; n < scene->pairs; n++) {
    sepax_chain_free(&scene->pair[n].chain);
    free(scene->pair[n].verdict);
    free(scene->pair[n].proof.interval);
    free(scene->pair[n].between);
    free(scene->pair[n].part);
  }
  free(scene->body);
  free(scene->body_of);
  free(scene->partner);
  for (size_t n = 0; n < scene->job_lists; n++) {
    free(scene->jobs[n].file);
  }
  free(scene->jobs);
  free(scene->pair);
  sepax_srdf_free(&scene->srdf);
  sepax_robot_free(&scene->robot);
  format_motion_free(&scene->motion);
  nc_motion_free(&scene->nc);
  sepax_release(scene->row_of);
  sepax_release(scene->spread);
  nc_tools_free(&scene->tools);
  free(scene->stock.feeds);
  for (size_t n = 0; n < scene->stock.snapshots; n++) {
    sepax_soup_free(&scene->stock.snapshot[n].mesh);
  }
}

/* -------------------------------------------------------------------------- bodies */

/* Append all facets of a part. */
static bool append(sepax_soup *to, const sepax_soup *mesh) {
  sepax_facet *grown = sepax_resize(to->facet, (to->count + mesh->count) * sizeof *grown);
  if (grown == NULL) {
    return false;
  }
  to->facet = grown;
  memcpy(to->facet + to->count, mesh->facet, mesh->count * sizeof *grown);
  to->count += mesh->count;
  return true;
}

/* Add a part to a body. If the link has several parts, then each part has a sepax_body of its
 * own. */
static bool add_part(path_body *b, const sepax_shape *shape, bool only, const cli_meshes *rules,
                     sepax_error *error) {
  sepax_soup mesh = {0};
  path_part *part = &b->part[b->parts];
  part->shape = shape;
  bool ok = format_shape_mesh(&mesh, &part->file, shape, rules, error) &&
            (append(&b->mesh, &mesh) ||
             sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu triangles",
                        b->mesh.count + mesh.count));
  if (ok && sepax_body_new(&part->body, SEPAX_SOUP_MESH(&mesh), NULL, error)) {
    b->parts++; /* from now on the body frees the part */
    b->body = only ? part->body : NULL;
    ok = sepax_shell_find(&part->shell, part->body, error);
    b->open += ok && !part->shell.closed;
  } else {
    ok = false;
  }
  sepax_soup_free(&mesh);
  return ok;
}

static void find_box(path_body *b) {
  for (int i = 0; i < 3; i++) {
    b->least[i] = INFINITY;
    b->most[i] = -INFINITY;
  }
  for (size_t n = 0; n < 3 * b->mesh.count; n++) {
    for (int i = 0; i < 3; i++) {
      double x = b->mesh.facet[n / 3].v[n % 3][i];
      b->least[i] = fmin(b->least[i], x);
      b->most[i] = fmax(b->most[i], x);
    }
  }
}

bool path_body_of_mesh(path_body *b, const sepax_soup *mesh, bool keep, sepax_error *error) {
  path_part *part = b->part;
  if (!append(&b->mesh, mesh)) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu triangles", mesh->count);
  }
  b->triangles = mesh->count;
  find_box(b);
  if (!sepax_body_new(&part->body, SEPAX_SOUP_MESH(mesh), NULL, error)) {
    return false;
  }
  b->parts = 1;
  b->body = part->body;
  if (!keep) {
    sepax_soup_free(&b->mesh);
  }
  return sepax_shell_find(&part->shell, part->body, error);
}

static bool make_body(path_body *b, const sepax_robot *robot, size_t first, size_t count,
                      const path_question *q, sepax_error *error) {
  b->link = robot->shape[first].link;
  b->tool = FORMAT_NO_NAME;
  b->part = calloc(count, sizeof *b->part);
  if (b->part == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu parts", count);
  }
  sepax_error inner = {0};
  for (size_t n = first; n < first + count; n++) {
    if (!add_part(b, &robot->shape[n], count == 1, &q->meshes, &inner)) {
      return sepax_fail(error, inner.code, "link %.60s: %.400s",
                        robot->mechanism.link[b->link].name, inner.text);
    }
  }
  b->triangles = b->mesh.count;
  find_box(b);
  if (!sepax__distinct(&b->mesh)) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu triangles", b->triangles);
  }
  if (b->mesh.count < b->triangles) {
    b->body = NULL; /* the parts are complete and say what is inside */
  }
  if (b->body == NULL && !sepax_body_new(&b->body, SEPAX_SOUP_MESH(&b->mesh), NULL, error)) {
    return false;
  }
  if (!q->keep) {
    sepax_soup_free(&b->mesh);
  }
  return true;
}

/* Make the bodies. The shapes of a link follow each other in the list. */
static bool make_bodies(path_scene *scene, const path_question *q, sepax_error *error) {
  const sepax_robot *robot = &scene->robot;
  scene->body = calloc(robot->shapes + 1, sizeof *scene->body);
  scene->body_of = malloc(robot->mechanism.links * sizeof *scene->body_of);
  if (scene->body == NULL || scene->body_of == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for bodies");
  }
  for (size_t n = 0; n < robot->mechanism.links; n++) {
    scene->body_of[n] = SIZE_MAX;
  }
  bool ok = true;
  cli_progress progress = cli_progress_begin("bodies", robot->shapes);
  for (size_t first = 0; first < robot->shapes && ok;) {
    size_t count = 1;
    while (first + count < robot->shapes &&
           robot->shape[first + count].link == robot->shape[first].link) {
      count++;
    }
    cli_progress_show(&progress, first);
    if (robot->shape[first].link == scene->tool_link) { /* the tools take its place */
      first += count;
      continue;
    }
    scene->body_of[robot->shape[first].link] = scene->bodies;
    ok = make_body(&scene->body[scene->bodies++], robot, first, count, q, error);
    first += count;
  }
  cli_progress_end(&progress);
  return ok;
}

/* --------------------------------------------------------------------------- pairs */

/* The number of the link that an option names. */
static bool is_link(const path_scene *scene, size_t body, const char *name) {
  const path_body *b = &scene->body[body];
  return name != NULL && b->role == NULL && strcmp(path_body_name(scene, body), name) == 0;
}

static bool add_pair(path_scene *scene, size_t a, size_t b, sepax_error *error) {
  path_pair *pair = &scene->pair[scene->pairs];
  size_t tool = scene->body[a].tool != FORMAT_NO_NAME ? scene->body[a].tool : scene->body[b].tool;
  *pair = (path_pair){.body = {a, b}, .tool = tool, .least = INFINITY, .least_line = PATH_NO_LINE};
  for (int v = 0; v < VERDICTS; v++) {
    pair->first[v] = PATH_NO_LINE;
  }
  if (!sepax_chain_find(&pair->chain, &scene->robot.mechanism, scene->body[a].link,
                        scene->body[b].link, error)) {
    return false;
  }
  scene->pairs++;
  return true;
}

/* Add the pairs of a part of a tool and the body of a link. The core of the flutes is compared with
 * the finished part, and with nothing else; the flutes with everything else. */
static bool add_tool_pair(path_scene *scene, const path_question *q, size_t tool, size_t other,
                          sepax_error *error) {
  bool is_core = strcmp(scene->body[tool].role, "core") == 0;
  bool is_flutes = is_core || scene->body[tool].turned_part == NC_FLUTES;
  if (is_flutes && is_core != is_link(scene, other, q->part)) {
    return true;
  }
  if (!add_pair(scene, tool, other, error)) {
    return false;
  }
  path_pair *pair = &scene->pair[scene->pairs - 1];
  pair->may_meet = is_flutes && is_link(scene, other, q->stock) ? 1U << FORMAT_FEED : 0;
  pair->bare = scene->body[tool].turned_part != NC_HOLDER &&
               (is_link(scene, other, q->stock) || is_link(scene, other, q->part));
  return true;
}

/* Add the pairs of two links. */
static bool add_links(path_scene *scene, const path_question *q, const size_t link[2],
                      sepax_error *error) {
  int of_tools = link[0] == scene->tool_link ? 0 : link[1] == scene->tool_link ? 1 : -1;
  if (of_tools < 0) {
    return add_pair(scene, scene->body_of[link[0]], scene->body_of[link[1]], error);
  }
  scene->partner[scene->partners++] = link[1 - of_tools];
  for (size_t n = 0; n < scene->bodies; n++) {
    if (scene->body[n].role != NULL &&
        !add_tool_pair(scene, q, n, scene->body_of[link[1 - of_tools]], error)) {
      return false;
    }
  }
  return true;
}

static bool choose_pairs(path_scene *scene, const path_question *q, sepax_error *error) {
  sepax_robot_pairs chosen;
  if (!sepax__robot_pairs(&chosen, &scene->robot, q->srdf, scene->tool_link, error)) {
    return false;
  }
  scene->joined = chosen.joined;
  scene->rigid = chosen.rigid;
  scene->disabled = chosen.disabled;
  scene->srdf = chosen.srdf;
  chosen.srdf = (sepax_srdf){0};
  const char *name = scene->robot.name;
  if (scene->srdf.robot != NULL && name != NULL && strcmp(scene->srdf.robot, name) == 0) {
    sepax_release(scene->srdf.robot);
    scene->srdf.robot = NULL;
  }
  scene->pair = calloc(chosen.count * (1 + scene->bodies) + 1, sizeof *scene->pair);
  scene->partner = calloc(scene->robot.mechanism.links, sizeof *scene->partner);
  bool ok = scene->pair != NULL && scene->partner != NULL;
  if (!ok) {
    sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu pairs", chosen.count);
  }
  for (size_t n = 0; n < chosen.count && ok; n++) {
    ok = add_links(scene, q, chosen.pair[n], error);
  }
  sepax_robot_pairs_free(&chosen);
  return ok;
}

static bool fail_no_pair(const path_scene *scene, const path_question *q, sepax_error *error) {
  char names[200] = "";
  size_t length = 0;
  for (size_t n = 0; n < scene->robot.links && length < sizeof names; n++) {
    if (!path_has_body(scene, n)) {
      length += (size_t)snprintf(
          names + length, sizeof names - length, "%s%.40s",
          length > 0 ? ", " : "; none have: ", scene->robot.mechanism.link[n].name);
    }
  }
  return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                    "%.240s: no two bodies to compare: %zu links have collision geometry, %zu "
                    "pairs are left out%s",
                    q->urdf, scene->bodies, scene->joined + scene->rigid + scene->disabled, names);
}

/* The links that options name have bodies. */
static bool links_known(const path_scene *scene, const path_question *q, sepax_error *error) {
  const char *const names[] = {q->stock, q->part};
  static const char *const options[] = {"stock", "part"};
  for (int k = 0; k < 2; k++) {
    size_t n = 0;
    while (names[k] != NULL && n < scene->bodies && !is_link(scene, n, names[k])) {
      n++;
    }
    if (names[k] != NULL && n == scene->bodies) {
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "%s: no link %.60s with collision geometry in %.200s; mend the name",
                        options[k], names[k], q->urdf);
    }
  }
  return true;
}

static bool read_motion(path_scene *scene, const path_question *q, sepax_error *error) {
  return q->machine != NULL ? path_program_read(scene, q, error)
                            : format_motion_read(&scene->motion, &scene->robot.mechanism, &q->rules,
                                                 q->motion, error);
}

bool path_scene_load(path_scene *scene, const path_question *q, sepax_error *error) {
  /* A guard compares rounded values with a tube, in other units. */
  *scene = (path_scene){.tool_link = SIZE_MAX,
                        .gouge = q->gouge.length,
                        .agreement.link = SIZE_MAX,
                        .slack = q->tube != NULL ? 1e-9 : 0};
  const sepax_robot_reading how = {
      .size = sizeof how, .package = q->package, .packages = q->packages};
  if (!sepax_robot_read(&scene->robot, q->urdf, &how, error) || !read_motion(scene, q, error) ||
      (q->tools != NULL && !path_tools_read(scene, q, error)) ||
      (q->machine != NULL && !path_program_agrees(scene, q, error)) ||
      !make_bodies(scene, q, error) || (q->tools != NULL && !path_tools_bodies(scene, q, error)) ||
      !links_known(scene, q, error) || !choose_pairs(scene, q, error)) {
    return false;
  }
  if ((scene->pairs == 0 && !fail_no_pair(scene, q, error)) ||
      (q->table != NULL && !path_rules_apply(scene, q->table, error)) ||
      (q->stock != NULL && q->tools != NULL && !path_cutting_begin(scene, q, error))) {
    return false;
  }
  if (q->dogleg && !path_program_doglegs(scene, q, error)) {
    return false;
  }
  path_rules_count(scene);
  return q->machine == NULL || path_program_deviations(scene, q->blended, error);
}
