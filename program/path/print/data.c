/* SPDX-License-Identifier: MIT */
/* data.c - the results of sepax path for programs: JSON and CSV. */
#include "report/json.h"
#include "report/text.h"
#include "report/within.h"
#include "path/common/parts.h"
#include "report/csv.h"
#include "util/write_file.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* What a path with steps says of the motion that ends in a line. */
static void set_step(json_t *json, const format_motion *motion, size_t line) {
  const format_step *step = motion->step != NULL ? &motion->step[line] : NULL;
  if (step == NULL) {
    return;
  }
  const char *file = step->file != FORMAT_NO_NAME ? motion->name[step->file] : NULL;
  const char *tool = step->tool != FORMAT_NO_NAME ? motion->name[step->tool] : NULL;
  json_object_set_new(json, "program",
                      json_pack("{s:s?, s:o, s:s, s:s?, s:b, s:f}", "file", file, "line",
                                step->line > 0 ? json_integer((json_int_t)step->line) : json_null(),
                                "kind", format_kind_names[step->kind], "tool", tool, "break",
                                step->breaks, "deviation_mm",
                                report_mm(step->deviation, CLI_METRES)));
}

/* {"line": 17, "time_s": 0.1}, or null */
static json_t *line_of(const path_scene *scene, const path_pair *pair, size_t line) {
  if (line == PATH_NO_LINE) {
    return json_null();
  }
  json_t *json = json_object();
  report_set_count(json, "line", scene->motion.line[line]);
  json_object_set_new(json, "time_s",
                      scene->motion.time != NULL ? json_real(scene->motion.time[line])
                                                 : json_null());
  set_step(json, &scene->motion, pair != NULL ? path_motion_of(scene, pair, line) : line);
  return json;
}

static double mm_of(double length) { return report_mm(length, CLI_METRES); }

static json_t *point_of(const double v[3]) {
  return json_pack("[f, f, f]", mm_of(v[0]), mm_of(v[1]), mm_of(v[2]));
}

static json_t *points_of(const path_scene *scene, const path_pair *pair) {
  double point[2][3];
  if (pair->inside) {
    return json_null();
  }
  path_points(scene, pair, point);
  return json_pack("[o, o]", point_of(point[0]), point_of(point[1]));
}

/* The interval of a length in millimetres. Its ends are rounded outwards, so it is certain. */
static json_t *interval_of(const double interval[2]) {
  double least = interval[0] > 0 ? nextafter(mm_of(interval[0]), 0) : 0;
  double most = interval[1] > 0 ? nextafter(mm_of(interval[1]), INFINITY) : 0;
  return json_pack("[f, f]", least, most);
}

static json_t *least_of(const path_scene *scene, const path_pair *pair) {
  if (pair->least_line == PATH_NO_LINE) {
    return json_null();
  }
  json_t *json = line_of(scene, pair, pair->least_line);
  json_object_set_new(json, "distance_mm", json_real(mm_of(pair->least)));
  json_object_set_new(json, "interval_mm", interval_of(pair->interval));
  json_object_set_new(json, "points_mm", points_of(scene, pair));
  return json;
}

/* {"x": 0.1, ...}: the values of all joints that have a column or would have one, in metres and
 * radians as in a URDF. */
static json_t *values_of(const path_scene *scene, path_moment at) {
  const sepax_mechanism *m = &scene->robot.mechanism;
  json_t *json = json_object();
  for (size_t n = 0; n < m->joints; n++) {
    if (sepax_joint_driven(&m->joint[n])) {
      json_object_set_new(json, m->joint[n].name, json_real(path_value(&scene->motion, at, n)));
    }
  }
  return json;
}

static json_t *segment_of(const path_scene *scene, size_t segment) {
  return json_pack("{s:o, s:o}", "from", line_of(scene, NULL, segment), "to",
                   line_of(scene, NULL, segment + 1));
}

/* The result of --certify for a pair; null without --certify. */
static json_t *way_of(const path_scene *scene, const path_pair *pair) {
  const path_proof *proof = &pair->proof;
  if (!scene->between || (pair->between == NULL && path_in_lines(pair) == VERDICT_COLLISION)) {
    return json_null();
  }
  json_t *open = json_null();
  json_t *collision = json_null();
  if (proof->is_open) {
    double ends[2];
    path_open_ends(pair, ends);
    open = segment_of(scene, proof->open.segment);
    json_object_set_new(open, "part", json_pack("[f, f]", ends[0], ends[1]));
    json_object_set_new(open, "distance_mm", json_real(mm_of(proof->distance)));
    json_object_set_new(open, "ended", json_boolean(proof->ended));
  }
  if (proof->collides) {
    collision = segment_of(scene, proof->segment);
    json_object_set_new(collision, "part", json_real(proof->part));
    json_object_set_new(collision, "values_m_rad", values_of(scene, path_between_moment(pair)));
  }
  return json_pack("{s:b, s:I, s:o, s:o}", "certified", proof->certified, "intervals",
                   (json_int_t)proof->count, "open", open, "collision", collision);
}

/* What rules leave out. */
static json_t *allowed_of(const path_pair *pair) {
  json_t *kinds = json_array();
  for (unsigned k = 0; k < FORMAT_KINDS; k++) {
    if ((pair->may_meet >> k & 1U) != 0) {
      json_array_append_new(kinds, json_string(format_kind_names[k]));
    }
  }
  return json_pack("{s:o, s:I, s:I}", "kinds", kinds, "lines_left_out",
                   (json_int_t)pair->lines_left_out, "motions_left_out",
                   (json_int_t)pair->motions_left_out);
}

/* What the stock as it is cut says of a pair. */
static json_t *touch_of(const path_scene *scene, const path_pair *pair) {
  bool holder = scene->body[pair->body[0]].turned_part == NC_HOLDER;
  json_t *deepest = json_null();
  if (path_in_lines(pair) != VERDICT_FREE) {
    deepest = line_of(scene, NULL, pair->deepest_line);
    json_object_set_new(deepest, "at_least_mm", json_real(mm_of(fmax(0, pair->deepest[0]))));
    json_object_set_new(deepest, "at_most_mm",
                        isfinite(pair->deepest[1]) ? json_real(mm_of(pair->deepest[1]))
                                                   : json_null());
  }
  return json_pack("{s:f, s:o}", "depth_mm", holder ? 0.0 : mm_of(scene->stock.depth), "deepest",
                   deepest);
}

static json_t *pair_of(const path_scene *scene, const path_pair *pair) {
  json_t *lines = json_object();
  json_t *first = json_object();
  json_t *json = json_pack("{s:s, s:s, s:s}", "a", path_body_name(scene, pair->body[0]), "b",
                           path_body_name(scene, pair->body[1]), "verdict",
                           report_verdict_names[path_verdict_of(pair)]);
  for (int v = 0; v < VERDICTS; v++) {
    report_set_count(lines, report_verdict_names[v], pair->lines[v]);
    json_object_set_new(first, report_verdict_names[v], line_of(scene, pair, pair->first[v]));
  }
  if (pair->why != SEPAX_WITHIN_PLAIN) {
    json_object_set_new(json, pair->why_of == 0 ? "a_inside_b_reason" : "b_inside_a_reason",
                        json_string(report_within_name(pair->why)));
  }
  json_object_set_new(json, "lines", lines);
  json_object_set_new(json, "first", first);
  json_object_set_new(json, "least_clearance", least_of(scene, pair));
  json_object_set_new(json, "between", way_of(scene, pair));
  if (pair->by_cells) {
    json_object_set_new(json, "stock", touch_of(scene, pair));
  } else if (pair->may_meet != 0) {
    json_object_set_new(json, "may_meet", allowed_of(pair));
  }
  return json;
}

/* The mesh files of a body. */
static json_t *meshes_of(const path_body *b) {
  json_t *meshes = json_array();
  for (size_t k = 0; k < b->parts; k++) {
    const char *file = path_mesh_file(&b->part[k]);
    if (file != NULL) {
      const report_mesh *mesh = &b->part[k].file;
      json_t *json =
          json_pack("{s:s, s:I}", "file", file, "triangles", (json_int_t)mesh->account.triangles);
      report_set_mesh(json, mesh);
      json_array_append_new(meshes, json);
    }
  }
  return meshes;
}

static json_t *bodies_of(const path_scene *scene) {
  json_t *bodies = json_array();

  for (size_t n = 0; n < scene->bodies; n++) {
    const path_body *b = &scene->body[n];
    json_array_append_new(
        bodies, json_pack("{s:s, s:I, s:I, s:I, s:o}", "link", path_body_name(scene, n),
                          "triangles", (json_int_t)b->triangles, "parts", (json_int_t)b->parts,
                          "open_parts", (json_int_t)b->open, "meshes", meshes_of(b)));
  }
  return bodies;
}

/* The names of links without collision geometry. */
static json_t *empty_of(const path_scene *scene) {
  json_t *links = json_array();
  for (size_t n = 0; n < scene->robot.links; n++) {
    if (!path_has_body(scene, n)) {
      json_array_append_new(links, json_string(scene->robot.mechanism.link[n].name));
    }
  }
  return links;
}

/* Collision elements whose lengths are all 0. */
static json_t *nothings_of(const sepax_robot *robot) {
  json_t *list = json_array();
  for (size_t n = 0; n < robot->nothings; n++) {
    const sepax_bare_shape *nothing = &robot->nothing[n];
    json_array_append_new(list, json_pack("{s:s, s:s, s:I}", "link",
                                          robot->mechanism.link[nothing->link].name, "element",
                                          sepax_shape_kind_name(nothing->kind), "line",
                                          (json_int_t)nothing->line));
  }
  return list;
}

static void add_others(json_t *list, const char *file, const sepax_robot_others *others) {
  for (size_t n = 0; n < others->count; n++) {
    json_array_append_new(list,
                          json_pack("{s:s, s:s, s:I}", "file", file, "what", others->entry[n].what,
                                    "count", (json_int_t)others->entry[n].count));
  }
}

/* The elements of the URDF and the SRDF that are ignored. */
static json_t *passed_over(const path_scene *scene, const path_question *q) {
  json_t *list = json_array();
  add_others(list, q->urdf, &scene->robot.others);
  add_others(list, q->srdf, &scene->srdf.others);
  return list;
}

/* The result of --certify for all pairs; null without --certify. */
static json_t *between_of(const path_scene *scene) {
  size_t intervals = 0;
  if (!scene->between) {
    return json_null();
  }
  for (size_t n = 0; n < scene->pairs; n++) {
    intervals += scene->pair[n].proof.count;
  }
  return json_pack("{s:b, s:I, s:I, s:f}", "certified", path_certified(scene), "pairs",
                   (json_int_t)path_certified_pairs(scene), "intervals", (json_int_t)intervals,
                   "seconds", scene->between_seconds);
}

/* The first moment with the worst verdict: a line, or a pose after a line. */
static json_t *first_of(const path_scene *scene) {
  const path_pair *pair = NULL;
  path_moment at = path_worst_moment(scene, &pair);
  if (path_worst(scene) == VERDICT_FREE) {
    return json_null();
  }
  json_t *json = line_of(scene, pair, at.line);
  json_object_set_new(json, "part", json_real(at.part));
  json_object_set_new(json, "values_m_rad", values_of(scene, at));
  return json;
}

/* The lists of --jobs. */
static json_t *jobs_of(const path_scene *scene) {
  json_t *json = json_array();
  for (size_t n = 0; n < scene->job_lists; n++) {
    const path_jobs *jobs = &scene->jobs[n];
    char text[SEPAX_CONFIG_TEXT];
    char command[SEPAX_CONFIG_TEXT + 16];
    snprintf(command, sizeof command, "sepax gen %s",
             sepax_config_text(&jobs->config, text, sizeof text));
    json_array_append_new(
        json,
        json_pack("{s:s, s:I, s:I, s:I, s:I, s:i, s:f, s:i, s:i, s:s}", "file", jobs->file, "jobs",
                  (json_int_t)jobs->jobs, "poses", (json_int_t)jobs->poses, "bodies",
                  (json_int_t)jobs->bodies, "bytes", (json_int_t)jobs->bytes, "word",
                  jobs->config.word, "lsb_mm", mm_of(jobs->resolution), "clearance_lsb",
                  jobs->config.clearance, "warning_lsb", jobs->config.warning, "command", command));
  }
  return json;
}

/* By the lines of the program, the worst first; null if the path names no lines. */
static json_t *violations_of(const path_scene *scene) {
  size_t count = 0;
  path_violation *list = path_violations(scene, &count);
  json_t *json = scene->motion.step != NULL ? json_array() : json_null();
  for (size_t n = 0; list != NULL && n < count; n++) {
    const path_violation *v = &list[n];
    json_t *first = line_of(scene, NULL, v->first.line);
    set_step(first, &scene->motion, v->motion);
    json_array_append_new(json, json_pack("{s:s, s:s, s:s, s:s, s:I, s:o}", "verdict",
                                          report_verdict_names[v->verdict], "a",
                                          path_body_name(scene, v->pair->body[0]), "b",
                                          path_body_name(scene, v->pair->body[1]), "kind",
                                          format_kind_names[v->kind], "program_lines",
                                          (json_int_t)v->motions, "first", first));
  }
  free(list);
  return json;
}

/* What each tool does in feeds. */
static json_t *feeds_of(const path_scene *scene) {
  json_t *json = json_array();
  for (size_t n = 0; n < scene->motion.names; n++) {
    const path_feeds *f = &scene->stock.feeds[n];
    if (f->feeds > 0) {
      json_array_append_new(json, json_pack("{s:s, s:I, s:I, s:b}", "tool", scene->motion.name[n],
                                            "feeds", (json_int_t)f->feeds, "spindle_off",
                                            (json_int_t)f->still, "touches_stock", f->touches));
    }
  }
  return json;
}

json_t *path_report(const path_scene *scene, const path_question *q) {
  report_verdict worst = path_worst(scene);
  json_t *json = json_object();
  json_t *pairs = json_array();
  for (size_t n = 0; n < scene->pairs; n++) {
    json_array_append_new(pairs, pair_of(scene, &scene->pair[n]));
  }
  json_object_set_new(json, "urdf", json_string(q->urdf));
  json_object_set_new(json, "srdf", q->srdf != NULL ? json_string(q->srdf) : json_null());
  json_object_set_new(json, "path", json_string(q->motion));
  json_object_set_new(json, "rules", q->table != NULL ? json_string(q->table) : json_null());
  json_object_set_new(json, "verdict", json_string(report_verdict_names[worst]));
  json_object_set_new(json, "first", first_of(scene));
  report_set_count(json, "lines", scene->motion.lines);
  report_set_bands(json, &q->bands, NULL);
  json_object_set_new(json, "bodies", bodies_of(scene));
  json_object_set_new(json, "links_without_geometry", empty_of(scene));
  json_object_set_new(json, "without_surface", nothings_of(&scene->robot));
  json_object_set_new(json, "passed_over", passed_over(scene, q));
  json_object_set_new(json, "pairs", pairs);
  report_set_count(json, "pairs_of_one_joint", scene->joined);
  report_set_count(json, "pairs_without_joint", scene->rigid);
  report_set_count(json, "pairs_disabled", scene->disabled);
  json_object_set_new(json, "violations", violations_of(scene));
  json_object_set_new(json, "between", between_of(scene));
  if (q->certificate != NULL) {
    json_object_set_new(
        json, "certificate",
        json_pack("{s:s, s:b}", "file", q->certificate, "written", path_certified(scene)));
  }
  if (q->tube != NULL) {
    json_object_set_new(
        json, "tube",
        json_pack("{s:s, s:b}", "file", q->tube, "written", path_tube_is_free(scene)));
  }
  if (scene->stock.cell > 0) {
    const path_stock *s = &scene->stock;
    json_object_set_new(json, "feeds", feeds_of(scene));
    json_object_set_new(json, "stock",
                        json_pack("{s:s, s:f, s:f, s:I, s:I, s:f}", "link",
                                  path_body_name(scene, s->body), "cell_mm", mm_of(s->cell),
                                  "depth_mm", mm_of(s->depth), "cells", (json_int_t)s->cells,
                                  "bytes", (json_int_t)s->bytes, "seconds", s->seconds));
  }
  if (q->jobs != NULL) {
    json_object_set_new(json, "jobs", jobs_of(scene));
    json_object_set_new(json, "jobs_left_out", json_integer((json_int_t)scene->jobs_left_out));
  }
  json_object_set_new(json, "seconds", json_real(scene->seconds));
  return json;
}

void path_print_json(const path_scene *scene, const path_question *q) {
  report_print_json(path_report(scene, q));
}

/* ----------------------------------------------------------------------------- CSV */

typedef struct {
  const path_scene *scene;
  bool parts; /* a column for the part of the way */
} rows;

/* The program's line and the kind of the motion. */
static bool write_step(FILE *out, const path_scene *scene, const path_pair *pair, path_moment at) {
  char text[PATH_PLACE];
  size_t line = at.part > 0 ? at.line + 1 : path_motion_of(scene, pair, at.line);
  const format_motion *motion = &scene->motion;
  return report_csv_text(out, path_place(motion, line, text)) &&
         fprintf(out, ",%s,", format_kind_names[motion->step[line].kind]) > 0;
}

static bool write_row(FILE *out, const rows *r, const path_pair *pair, path_moment at,
                      report_verdict verdict) {
  const format_motion *motion = &r->scene->motion;
  return fprintf(out, "%zu,", motion->line[at.line]) > 0 &&
         (motion->step == NULL || write_step(out, r->scene, pair, at)) &&
         (motion->time == NULL || fprintf(out, "%.17g,", path_time(motion, at)) > 0) &&
         report_csv_text(out, path_body_name(r->scene, pair->body[0])) && putc(',', out) != EOF &&
         report_csv_text(out, path_body_name(r->scene, pair->body[1])) &&
         fprintf(out, ",%s", report_verdict_names[verdict]) > 0 &&
         (!r->parts || fprintf(out, ",%.17g", at.part) > 0) && putc('\n', out) != EOF;
}

/* A row for each line and pair that is not free, and for each pose between lines that is not
 * free. */
static bool write_rows(FILE *out, const void *context) {
  const rows *r = context;
  const path_scene *scene = r->scene;
  bool ok =
      fprintf(out, "line,%s%sa,b,verdict%s\n", scene->motion.step != NULL ? "program,kind," : "",
              scene->motion.time != NULL ? "time," : "", r->parts ? ",part" : "") > 0;
  for (size_t line = 0; line < scene->motion.lines && ok; line++) {
    for (size_t n = 0; n < scene->pairs && ok; n++) {
      const path_pair *pair = &scene->pair[n];
      ok = pair->verdict[line] == VERDICT_FREE ||
           write_row(out, r, pair, (path_moment){line, 0}, pair->verdict[line]);
    }
    for (size_t n = 0; n < scene->pairs && ok; n++) {
      const path_pair *pair = &scene->pair[n];
      path_moment at;
      report_verdict verdict = path_motion_verdict(pair, line, &at);
      ok = verdict == VERDICT_FREE || write_row(out, r, pair, at, verdict);
    }
  }
  return ok;
}

bool path_write_csv(const path_scene *scene, const char *path, sepax_error *error) {
  const rows r = {scene, scene->between};
  return sepax_write_file(path, write_rows, &r, error);
}
