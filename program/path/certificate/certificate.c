/* SPDX-License-Identifier: MIT */
/* certificate.c - writes the proof of --certify for sepax-certificate-check:
 * docs/reference/certificate.md. */
#include "path/certificate/digest.h"
#include "path/common/parts.h"
#include "util/error.h"
#include "util/write_file.h"

#include <jansson.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

typedef struct {
  const path_scene *scene;
  const path_question *q;
  json_t *packages, *files;
} certificate;

/* Write a value on a line of its own and release it. */
static bool write_line(FILE *out, json_t *json) {
  bool ok = json != NULL && json_dumpf(json, out, JSON_COMPACT) == 0 && putc('\n', out) != EOF;
  json_decref(json);
  return ok;
}

/* The packages of --package, and those that were found: the path of a mesh file without the part
 * that the URDF has after the package's name. NULL if one name stands for two folders. */
static json_t *packages_of(const path_scene *scene, const path_question *q, sepax_error *error) {
  static const char scheme[] = "package://";
  json_t *packages = json_object();
  for (size_t n = 0; n < q->packages; n++) {
    json_object_set_new(packages, q->package[n].name, json_string(q->package[n].folder));
  }
  for (size_t n = 0; n < scene->robot.shapes; n++) {
    const sepax_shape *shape = &scene->robot.shape[n];
    if (shape->name == NULL || strncmp(shape->name, scheme, strlen(scheme)) != 0) {
      continue;
    }
    const char *name = shape->name + strlen(scheme);
    size_t length = strcspn(name, "/");
    size_t folder = strlen(shape->path) - strlen(name + length);
    json_t *key = json_stringn(name, length);
    const json_t *known = json_object_get(packages, json_string_value(key));
    bool same = known == NULL || (json_string_length(known) == folder &&
                                  strncmp(json_string_value(known), shape->path, folder) == 0);
    if (known == NULL) {
      json_object_set_new(packages, json_string_value(key), json_stringn(shape->path, folder));
    }
    json_decref(key);
    if (!same) {
      json_decref(packages);
      sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                 "certificate: package %.*s is in two folders; give --package=%.*s:FOLDER",
                 (int)(length < 60 ? length : 60), name, (int)(length < 60 ? length : 60), name);
      return NULL;
    }
  }
  return packages;
}

/* -------------------------------------------------------------------------- files */

/* Describe a file. `as` is its name in the URDF or on the command line. NULL if the file cannot be
 * read. */
static json_t *file_of(const char *as, const char *path, sepax_error *error) {
  char digest[DIGEST_LENGTH] = "";
  struct stat s;
  if (!path_digest(digest, path, error)) {
    return NULL;
  }
  if (stat(path, &s) != 0) {
    sepax_fail(error, SEPAX_ERROR_FILE, "%.400s: cannot be read", path);
    return NULL;
  }
  return json_pack("{s:s, s:s, s:I}", "file", as, "sha256", digest, "bytes", (json_int_t)s.st_size);
}

static void set_count(json_t *file, const char *what, size_t count) {
  json_object_set_new(file, what, json_integer((json_int_t)count));
}

static bool append_file(json_t *files, json_t *file) {
  return file != NULL && json_array_append_new(files, file) == 0;
}

static json_t *mesh_of(const sepax_shape *shape, const sepax_mesh_account *account,
                       sepax_error *error) {
  json_t *file = file_of(shape->name, shape->path, error);
  if (file != NULL) {
    json_object_set_new(file, "format", json_string(account->format));
    set_count(file, "faces", account->faces - account->unplaced);
    set_count(file, "triangles", account->triangles);
    if (account->fans > 0) {
      set_count(file, "polygons_as_fans", account->fans);
    }
    if (account->unit_mm != 0) {
      json_object_set_new(file, "unit_mm", json_real(account->unit_mm));
    }
  }
  return file;
}

static bool is_named(const json_t *files, const char *as) {
  for (size_t n = 0; n < json_array_size(files); n++) {
    const json_t *name = json_object_get(json_array_get(files, n), "file");
    if (strcmp(json_string_value(name), as) == 0) {
      return true;
    }
  }
  return false;
}

/* Append each mesh file once, even if several shapes use it. */
static bool append_meshes(json_t *files, const path_scene *scene, sepax_error *error) {
  for (size_t n = 0; n < scene->bodies; n++) {
    for (size_t k = 0; k < scene->body[n].parts; k++) {
      const sepax_shape *shape = scene->body[n].part[k].shape;
      if (shape != NULL && shape->path != NULL && !is_named(files, shape->name) &&
          !append_file(files, mesh_of(shape, &scene->body[n].part[k].file.account, error))) {
        return false;
      }
    }
  }
  return true;
}

/* All files that were read, with the counts of their readers. NULL if a file is gone. */
static json_t *files_of(const path_scene *scene, const path_question *q, sepax_error *error) {
  json_t *files = json_array();
  json_t *urdf = file_of(q->urdf, q->urdf, error);
  const char *path = path_motion_file(q);
  json_t *motion = urdf == NULL ? NULL : file_of(path, path, error);
  if (urdf != NULL && motion != NULL) {
    /* A URDF joint with several values became several joints of the mechanism, with one link
     * between each of them and the next. So subtracting the added links gives the joints of the
     * URDF. */
    const sepax_robot *robot = &scene->robot;
    set_count(urdf, "links", robot->links);
    set_count(urdf, "joints", robot->mechanism.joints - (robot->mechanism.links - robot->links));
    set_count(urdf, "collisions", robot->shapes + robot->nothings);
    set_count(motion, "lines", scene->motion.lines);
    set_count(motion, "columns", scene->motion.columns);
  }
  bool ok = append_file(files, urdf) && append_file(files, motion) &&
            (q->srdf == NULL || append_file(files, file_of(q->srdf, q->srdf, error))) &&
            (q->table == NULL || append_file(files, file_of(q->table, q->table, error))) &&
            append_meshes(files, scene, error);
  if (!ok) {
    json_decref(files);
  }
  return ok ? files : NULL;
}

/* -------------------------------------------------------------------------- tools */

static json_t *triangles_of(const sepax_soup *mesh) {
  json_t *list = json_array();
  for (size_t n = 0; n < mesh->count; n++) {
    json_t *triangle = json_array();
    for (int k = 0; k < 9; k++) {
      json_array_append_new(triangle, json_real(mesh->facet[n].v[k / 3][k % 3]));
    }
    json_array_append_new(list, triangle);
  }
  return list;
}

/* The parts of tools, which no file describes as meshes. */
static json_t *bodies_of(const path_scene *scene) {
  json_t *list = json_array();
  for (size_t n = 0; n < scene->bodies; n++) {
    const path_body *b = &scene->body[n];
    if (b->role != NULL) {
      json_array_append_new(list,
                            json_pack("{s:s, s:s, s:s, s:s, s:o}", "name", path_body_name(scene, n),
                                      "role", b->role, "tool", scene->motion.name[b->tool], "link",
                                      scene->robot.mechanism.link[b->link].name, "triangles",
                                      triangles_of(&b->mesh)));
    }
  }
  return list;
}

/* Is the pair of a part of a tool and a link proved by intervals? */
static bool has_intervals(const path_scene *scene, size_t tool, size_t other) {
  for (size_t n = 0; n < scene->pairs; n++) {
    const path_pair *pair = &scene->pair[n];
    if (!pair->by_cells && pair->body[0] == tool && pair->body[1] == other) {
      return true;
    }
  }
  return false;
}

/* Pairs that the certificate does not prove: those of parts of tools, [part, link], and of other
 * bodies that what is left of the stock decides. */
static json_t *left_out_of(const path_scene *scene) {
  json_t *list = json_array();
  for (size_t n = 0; n < scene->bodies; n++) {
    for (size_t k = 0; k < scene->partners && scene->body[n].role != NULL; k++) {
      size_t other = scene->body_of[scene->partner[k]];
      if (!has_intervals(scene, n, other)) {
        json_array_append_new(
            list, json_pack("[s, s]", path_body_name(scene, n), path_body_name(scene, other)));
      }
    }
  }
  for (size_t n = 0; n < scene->pairs; n++) {
    const path_pair *pair = &scene->pair[n];
    if (pair->of_left) {
      json_array_append_new(list, json_pack("[s, s]", path_body_name(scene, pair->body[0]),
                                            path_body_name(scene, pair->body[1])));
    }
  }
  return list;
}

/* Pairs for which the clearance does not count. */
static json_t *bare_of(const path_scene *scene) {
  json_t *list = json_array();
  for (size_t n = 0; n < scene->pairs; n++) {
    const path_pair *pair = &scene->pair[n];
    if (pair->bare && !pair->by_cells) {
      json_array_append_new(list, json_pack("[s, s]", path_body_name(scene, pair->body[0]),
                                            path_body_name(scene, pair->body[1])));
    }
  }
  return list;
}

static json_t *head_of(const certificate *c) {
  const path_question *q = c->q;
  json_t *pairs = json_array();
  for (size_t n = 0; n < c->scene->pairs; n++) {
    const path_pair *pair = &c->scene->pair[n];
    if (pair->by_cells) {
      continue;
    }
    json_array_append_new(pairs, json_pack("[s, s]", path_body_name(c->scene, pair->body[0]),
                                           path_body_name(c->scene, pair->body[1])));
  }
  json_t *head = json_pack("{s:s, s:i, s:s, s:s?, s:s?, s:s, s:O, s:O, s:f, s:o}", "certificate",
                           "sepax", "version", 2, "urdf", q->urdf, "srdf", q->srdf, "rules",
                           q->table, "path", path_motion_file(q), "packages", c->packages, "files",
                           c->files, "clearance", q->bands.clearance.length, "pairs", pairs);
  if (c->scene->tool_link != SIZE_MAX) {
    json_object_set_new(head, "tool_link",
                        json_string(c->scene->robot.mechanism.link[c->scene->tool_link].name));
    json_object_set_new(head, "bodies", bodies_of(c->scene));
    json_object_set_new(head, "left_out", left_out_of(c->scene));
    json_object_set_new(head, "without_clearance", bare_of(c->scene));
  }
  return head;
}

static json_t *interval_of(size_t pair, const path_interval *at) {
  json_t *json = json_pack("[I, I, I, I, f]", (json_int_t)pair, (json_int_t)at->segment,
                           (json_int_t)at->level, (json_int_t)at->index, at->bound);
  for (int i = 0; i < 3 && at->by_axis; i++) {
    json_array_append_new(json, json_real(at->axis[i]));
  }
  return json;
}

static bool write_all(FILE *out, const void *context) {
  const certificate *c = context;
  size_t count = 0;
  bool ok = write_line(out, head_of(c));
  for (size_t n = 0, number = 0; n < c->scene->pairs; n++) {
    const path_proof *proof = &c->scene->pair[n].proof;
    for (size_t k = 0; k < proof->count && ok; k++, count++) {
      ok = write_line(out, interval_of(number, &proof->interval[k]));
    }
    number += !c->scene->pair[n].by_cells;
  }
  return ok && write_line(out, json_pack("{s:I}", "intervals", (json_int_t)count));
}

static bool is_certificate(const char *path) {
  static const char begin[] = "{\"certificate\":";
  char text[sizeof begin] = "";
  struct stat s;
  FILE *in = stat(path, &s) == 0 && S_ISREG(s.st_mode) ? fopen(path, "r") : NULL;
  bool is = in != NULL && fgets(text, sizeof text, in) != NULL && strcmp(text, begin) == 0;
  if (in != NULL) {
    fclose(in);
  }
  return is;
}

bool path_write_certificate(path_scene *scene, const path_question *q, sepax_error *error) {
  if (!path_certified(scene)) {
    scene->removed = is_certificate(q->certificate) && unlink(q->certificate) == 0;
    return !is_certificate(q->certificate) ||
           sepax_fail(
               error, SEPAX_ERROR_ARGUMENT,
               "%.300s: this certificate of an earlier run cannot be removed; remove it yourself",
               q->certificate);
  }
  certificate c = {scene, q, packages_of(scene, q, error), NULL};
  c.files = c.packages == NULL ? NULL : files_of(scene, q, error);
  bool ok = c.files != NULL && sepax_write_file(q->certificate, write_all, &c, error);
  json_decref(c.packages);
  json_decref(c.files);
  return ok;
}
