/* SPDX-License-Identifier: MIT */
/* text.c - what sepax path prints for people. */
#include "path/parts.h"
#include "report/text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 7 };

/* What a line of the path is called: an NC program has lines of its own. */
static const char *row_word(const path_scene *scene) {
  return scene->motion.of_program ? "row" : "line";
}

/* Print `before` and "part.ngc:127, rapid, ", the place in the program and the kind of the motion
 * that ends in a line; nothing if the path does not say them. */
static void print_place(const path_scene *scene, const char *before, size_t line) {
  char text[PATH_PLACE];
  const format_step *step = scene->motion.step;
  path_place(&scene->motion, line, text);
  bool named = text[0] != '\0';
  bool kind = step != NULL && step[line].kind != FORMAT_MOVE;
  printf("%s%s%s%s%s", named || kind ? before : "", text, named ? ", " : "",
         kind ? format_kind_names[step[line].kind] : "", kind ? ", " : "");
}

/* "line 17 (0.1 s)", or "part.ngc:127, rapid, line 17 (0.1 s)" */
static void print_line(const path_scene *scene, const path_pair *pair, size_t line) {
  print_place(scene, "", pair != NULL ? path_motion_of(scene, pair, line) : line);
  printf("%s %zu", row_word(scene), scene->motion.line[line]);
  if (scene->motion.time != NULL) {
    printf(" (%.9g s)", scene->motion.time[line]);
  }
}

static double mm_of(double length) { return report_mm(length, CLI_METRES); }

static void print_point(const double v[3]) {
  printf("%.6g,%.6g,%.6g mm", mm_of(v[0]), mm_of(v[1]), mm_of(v[2]));
}

static void print_least(const path_scene *scene, const path_pair *pair) {
  if (pair->least_line == PATH_NO_LINE) {
    return;
  }
  if (pair->least == 0) {
    fputs(pair->inside ? "; one body, or a part of it, is inside the other" : "", stdout);
    return;
  }
  double point[2][3];
  path_points(scene, pair, point);
  printf("; least clearance %.6g mm in ", mm_of(pair->least));
  print_line(scene, pair, pair->least_line);
  fputs(", from ", stdout);
  print_point(point[0]);
  fputs(" to ", stdout);
  print_point(point[1]);
}

/* "between lines 17 and 18 (0.1 ... 0.2 s)" */
static void print_segment(const path_scene *scene, size_t segment) {
  const format_motion *motion = &scene->motion;
  print_place(scene, "in ", segment + 1);
  printf("between %ss %zu and %zu", row_word(scene), motion->line[segment],
         motion->line[segment + 1]);
  if (motion->time != NULL) {
    printf(" (%.9g ... %.9g s)", motion->time[segment], motion->time[segment + 1]);
  }
}

/* Print the values at a moment of the joints between the two links. */
static void print_values(const path_scene *scene, const path_pair *pair, path_moment at) {
  const char *before = ": ";
  for (size_t n = 0; n < pair->chain.count; n++) {
    const sepax_joint *joint = &scene->robot.mechanism.joint[pair->chain.joint[n]];
    if (joint->kind != SEPAX_JOINT_FIXED) {
      printf("%s%s %.9g %s", before, joint->name,
             path_value(&scene->motion, at, pair->chain.joint[n]),
             joint->kind == SEPAX_JOINT_PRISMATIC ? "m" : "rad");
      before = ", ";
    }
  }
}

/* "; collides between lines 17 and 18 at 0.5 of the way: x 0.1 m, free to 0.25", or what is open */
static void print_way(const path_scene *scene, const path_pair *pair) {
  const path_proof *proof = &pair->proof;
  double ends[2];
  path_open_ends(pair, ends);
  if (proof->collides) {
    fputs("; collides ", stdout);
    print_segment(scene, proof->segment);
    printf(" at %.9g of the way", proof->part);
    print_values(scene, pair, path_between_moment(pair));
  }
  if (!proof->is_open) {
    return;
  }
  fputs(proof->collides ? "; certified " : "; ", stdout);
  if (!proof->collides || proof->open.segment != proof->segment) {
    print_segment(scene, proof->open.segment);
    fputs(proof->collides ? " " : ", free ", stdout);
  }
  printf("to %.9g of the way", ends[0]);
  if (!proof->collides) {
    printf(", open to %.9g, %.6g mm in its middle", ends[1], mm_of(proof->distance));
    fputs(proof->ended ? "; not divided further (--intervals)" : "", stdout);
  }
}

/* " where it may not meet (6000 lines left out: feed)" */
static void print_allowed(const path_pair *pair) {
  printf("%s where it may not meet (", path_in_lines(pair) == VERDICT_FREE ? "" : ",");
  report_print_count(pair->lines_left_out, "line");
  const char *before = " left out: ";
  for (unsigned k = 0; k < FORMAT_KINDS; k++) {
    if ((pair->may_meet >> k & 1U) != 0) {
      printf("%s%s", before, format_kind_names[k]);
      before = ", ";
    }
  }
  putchar(')');
}

static bool is_core(const path_scene *scene, const path_pair *pair) {
  const char *role = scene->body[pair->body[0]].role;
  return role != NULL && strcmp(role, "core") == 0;
}

/* A pair that the stock as it is cut decides. */
static void print_stock_pair(const path_scene *scene, const path_pair *pair) {
  nc_tool_part part = scene->body[pair->body[0]].turned_part;
  const path_stock *s = &scene->stock;
  const char *before = "  ";
  for (int v = VERDICT_COLLISION; v > VERDICT_WARNING; v--) {
    if (pair->lines[v] > 0) {
      printf("%s%s in ", before,
             v == VERDICT_COLLISION ? "meets material" : "touches what is left");
      report_print_count(pair->lines[v], "motion");
      fputs(", first in ", stdout);
      print_line(scene, NULL, pair->first[v]);
      before = "; ";
    }
  }
  if (path_in_lines(pair) == VERDICT_FREE) {
    printf("  with tool %.60s ", scene->motion.name[pair->tool]);
    if (part == NC_HOLDER) {
      fputs("free of what is left", stdout);
    } else {
      printf("no deeper than %.6g mm in what is left%s", mm_of(s->depth),
             part == NC_FLUTES ? ", except where it cuts" : "");
    }
  } else if (isfinite(pair->deepest[1])) {
    printf("; %.4g ... %.4g mm deep in ", mm_of(fmax(0, pair->deepest[0])),
           mm_of(pair->deepest[1]));
    print_line(scene, NULL, pair->deepest_line);
  }
  putchar('\n');
}

static void print_pair(const path_scene *scene, const path_pair *pair, int width) {
  char names[2 * 64 + 4];
  snprintf(names, sizeof names, "%.60s, %.60s", path_body_name(scene, pair->body[0]),
           path_body_name(scene, pair->body[1]));
  printf("%-9s  %-*s", report_verdict_titles[path_verdict_of(pair)], width, names);
  if (pair->by_cells) {
    print_stock_pair(scene, pair);
    return;
  }
  const char *before = "  ";
  for (int v = VERDICT_COLLISION; v > VERDICT_FREE; v--) {
    static const char *const what[] = {"", "a warning", "undecided", "collide"};
    if (pair->lines[v] > 0) {
      printf("%s%s in ", before, what[v]);
      report_print_count(pair->lines[v], "line");
      fputs(", first in ", stdout);
      print_line(scene, pair, pair->first[v]);
      before = "; ";
    }
  }
  if (path_in_lines(pair) == VERDICT_FREE) {
    if (is_core(scene, pair)) {
      printf("  flutes no deeper than %.6g mm", mm_of(scene->gouge));
    } else {
      fputs("  free in all lines", stdout);
    }
    if (pair->tool != FORMAT_NO_NAME) {
      printf(" with tool %.60s", scene->motion.name[pair->tool]);
    }
  }
  if (pair->may_meet != 0) {
    print_allowed(pair);
  }
  fputs(pair->proof.certified ? path_in_lines(pair) == VERDICT_FREE ? " and between them"
                                                                    : "; no collision between them"
                              : "",
        stdout);
  print_way(scene, pair);
  print_least(scene, pair);
  putchar('\n');
}

static void print_stock(const path_scene *scene) {
  const path_stock *s = &scene->stock;
  printf("stock  %s, cut in cells of %.6g mm; %.6g cm3 are left at most; %zu KB, %.3f s\n",
         path_body_name(scene, s->body), mm_of(s->cell),
         (double)s->cells * s->cell * s->cell * s->cell * 1e6, s->bytes / 1000, s->seconds);
}

/* By the lines of the program, the worst first. */
static void print_violations(const path_scene *scene) {
  enum { LINES_MOST = 40 };
  size_t count = 0;
  path_violation *list = path_violations(scene, &count);
  for (size_t n = 0; list != NULL && n < count && n < LINES_MOST; n++) {
    const path_violation *v = &list[n];
    char place[PATH_PLACE];
    path_place(&scene->motion, v->motion, place);
    printf("%s%s: %s%s%s, %.60s, %.60s", n == 0 ? "lines  " : "       ",
           report_verdict_names[v->verdict], place, place[0] != '\0' ? ", " : "",
           format_kind_names[v->kind], path_body_name(scene, v->pair->body[0]),
           path_body_name(scene, v->pair->body[1]));
    if (v->motions > 1) {
      printf("; %zu lines of the program in all", v->motions);
    }
    putchar('\n');
  }
  if (count > LINES_MOST) {
    printf("       and %zu more; --json has all\n", count - LINES_MOST);
  }
  free(list);
}

/* Free pairs of a tool share a row, because there are many. */
static bool is_in_summary(const path_scene *scene, const path_pair *pair) {
  return pair->tool != FORMAT_NO_NAME && !pair->by_cells && !is_core(scene, pair) &&
         path_verdict_of(pair) == VERDICT_FREE;
}

/* The row of the free pairs of a tool, with the least clearance of them. */
static void print_tool(const path_scene *scene, size_t tool, int width) {
  const path_pair *least = NULL;
  size_t count = 0;
  bool certified = true;
  for (size_t n = 0; n < scene->pairs; n++) {
    const path_pair *pair = &scene->pair[n];
    if (pair->tool == tool && is_in_summary(scene, pair)) {
      count++;
      certified = certified && pair->proof.certified;
      least = least == NULL || pair->least < least->least ? pair : least;
    }
  }
  if (least == NULL) {
    return;
  }
  char name[64 + 40];
  snprintf(name, sizeof name, "tool %.60s, %zu pairs", scene->motion.name[tool], count);
  printf("%-9s  %-*s  free in all its lines%s", report_verdict_titles[VERDICT_FREE], width, name,
         certified ? " and between them" : "");
  if (least->least_line != PATH_NO_LINE) {
    printf("; least: %s, %s", path_body_name(scene, least->body[0]),
           path_body_name(scene, least->body[1]));
    print_least(scene, least);
  }
  putchar('\n');
}

static void print_bodies(const path_scene *scene) {
  for (size_t n = 0; n < scene->bodies; n++) {
    const path_body *b = &scene->body[n];
    if (b->role != NULL) {
      continue;
    }
    printf("body   %s, ", path_body_name(scene, n));
    report_print_count(b->triangles, "triangle");
    if (b->parts > 1) {
      printf(", %zu parts", b->parts);
    }
    if (b->open > 0) {
      printf(", %zu of %zu parts open: an open part has no inside", b->open, b->parts);
    }
    putchar('\n');
  }
}

/* A row for each tool, with its parts. */
static void print_tools(const path_scene *scene) {
  const nc_turned_tool *last = NULL;
  for (size_t n = 0; n < scene->bodies; n++) {
    const path_body *b = &scene->body[n];
    if (b->role == NULL || strcmp(b->role, "core") == 0) {
      continue;
    }
    if (b->turned != last) {
      printf("%stool   %d, %s, diameter %.6g mm, length %.6g mm: %s", last != NULL ? "\n" : "",
             b->turned->number, nc_tool_kind_name(b->turned->kind), b->turned->diameter,
             b->turned->length, b->role);
    } else {
      printf(", %s", b->role);
    }
    last = b->turned;
  }
  fputs(last != NULL ? "\n" : "", stdout);
}

static bool is_named_before(const path_scene *scene, size_t body, size_t part, const char *file) {
  for (size_t n = 0; n <= body; n++) {
    size_t parts = n < body ? scene->body[n].parts : part;
    for (size_t k = 0; k < parts; k++) {
      const char *other = path_mesh_file(&scene->body[n].part[k]);
      if (other != NULL && strcmp(other, file) == 0) {
        return true;
      }
    }
  }
  return false;
}

/* Print the mesh files about which more is known than the number of triangles. */
static void print_meshes(const path_scene *scene) {
  for (size_t n = 0; n < scene->bodies; n++) {
    for (size_t k = 0; k < scene->body[n].parts; k++) {
      const char *file = path_mesh_file(&scene->body[n].part[k]);
      const report_mesh *mesh = &scene->body[n].part[k].file;
      if (file != NULL && !report_mesh_is_plain(mesh) && !is_named_before(scene, n, k, file)) {
        report_print_mesh("mesh", WIDTH, file, mesh);
      }
    }
  }
}

/* Print the links without collision geometry, because a user may have given them visual meshes
 * only. */
static void print_empty(const path_scene *scene) {
  enum { NAMES_MOST = 12 };
  size_t empty = 0;
  for (size_t n = 0; n < scene->robot.links; n++) {
    if (!path_has_body(scene, n)) {
      if (empty++ < NAMES_MOST) {
        printf("%s%s", empty == 1 ? "empty  no collision geometry: " : ", ",
               scene->robot.mechanism.link[n].name);
      }
    }
  }
  if (empty > NAMES_MOST) {
    printf(" and %zu more links", empty - NAMES_MOST);
  }
  fputs(empty > 0 ? "\n" : "", stdout);
}

/* Collision elements whose lengths are all 0. */
static void print_nothings(const path_scene *scene) {
  enum { NAMES_MOST = 12 };
  const sepax_robot *robot = &scene->robot;
  for (size_t n = 0; n < robot->nothings && n < NAMES_MOST; n++) {
    const sepax_bare_shape *nothing = &robot->nothing[n];
    printf("%s%s of %s (line %ld)",
           n == 0 ? "zero   all lengths are 0, so there is no surface: " : ", ",
           sepax_shape_kind_name(nothing->kind), robot->mechanism.link[nothing->link].name,
           nothing->line);
  }
  if (robot->nothings > NAMES_MOST) {
    printf(" and %zu more", robot->nothings - NAMES_MOST);
  }
  fputs(robot->nothings > 0 ? "\n" : "", stdout);
}

/* Print the elements that are ignored because they say nothing about collision geometry or belong
 * to other programs. */
static void print_others(const char *file, const sepax_robot_others *others) {
  for (size_t n = 0; n < others->count; n++) {
    const sepax_robot_other *other = &others->entry[n];
    bool attribute = other->what[strlen(other->what) - 1] == '=';
    printf("%s%zu %s%s%s", n == 0 ? "passed over: " : ", ", other->count, attribute ? "" : "<",
           other->what, attribute ? "" : ">");
  }
  if (others->count > 0) {
    printf(" of %s\n", file);
  }
}

static void print_compared(const path_scene *scene, const path_question *q) {
  size_t off = scene->joined + scene->rigid + scene->disabled;
  printf("pairs  %zu of %zu are compared", scene->pairs, scene->pairs + off);
  if (q->srdf != NULL) {
    printf(", %zu are disabled by %s", scene->disabled, q->srdf);
    if (scene->srdf.robot != NULL) {
      printf(", which is for a robot '%.60s'; the URDF's is '%.60s'", scene->srdf.robot,
             scene->robot.name != NULL ? scene->robot.name : "");
    }
  } else {
    printf("; not compared: links of one joint (%zu)", scene->joined);
    if (scene->rigid > 0) {
      printf(", links that no joint moves against each other (%zu)", scene->rigid);
    }
    fputs("; --srdf=FILE chooses the pairs", stdout);
  }
  if (q->table != NULL) {
    printf("; %s lets some of them meet", q->table);
  }
  putchar('\n');
}

/* What the path says of its motions beyond the values of joints. */
static void print_steps(const format_motion *motion) {
  size_t kinds[FORMAT_KINDS] = {0};
  size_t breaks = 0;
  double deviation = 0;
  if (motion->step == NULL) {
    return;
  }
  for (size_t n = 0; n < motion->lines; n++) {
    kinds[motion->step[n].kind]++;
    breaks += n > 0 && motion->step[n].breaks;
    deviation = fmax(deviation, motion->step[n].deviation);
  }
  const char *before = "steps  ";
  for (int k = 0; k < FORMAT_KINDS; k++) {
    if (kinds[k] > 0) {
      fputs(before, stdout);
      report_print_count(kinds[k], format_kind_names[k]);
      before = ", ";
    }
  }
  if (breaks > 0) {
    fputs(", ", stdout);
    report_print_count(breaks, "break");
    fputs(" with a way there that is not known and not checked", stdout);
  }
  if (deviation > 0) {
    printf("; deviations of at most %.6g mm", mm_of(deviation));
  }
  putchar('\n');
}

/* What is taken for granted of an NC program. */
static void print_program(const path_scene *scene, const path_question *q) {
  printf("start  %s%s\n",
         q->start != NULL ? "the axes are at "
                          : "the machine is at home when the program starts; --start gives another "
                            "position",
         q->start != NULL ? q->start : "");
  size_t first = 0;
  size_t corners = path_unbounded_corners(scene, &first);
  if (corners > 0) {
    char place[PATH_PLACE];
    printf("blend  %zu motions without a bound of blending (G64 without P), first %s: %s\n",
           corners, path_place(&scene->motion, first, place),
           q->blended ? "the deviations count it"
                      : "the proof is for exact corners (G61); --blended counts the blending");
  }
  if (q->dogleg) {
    puts("rapids each axis takes its own time");
  }
}

static void print_motion(const path_scene *scene, const path_question *q) {
  const format_motion *motion = &scene->motion;
  size_t last = motion->lines - 1;
  printf("path   %s, ", q->motion);
  report_print_count(motion->lines, "pose");
  if (motion->of_program) {
    printf(" in rows 2 ... %zu%s%s", motion->line[last], q->written != NULL ? " of " : "",
           q->written != NULL ? q->written : "");
  } else if (last == 0) {
    printf(", in line %zu of the file", motion->line[0]);
  } else {
    printf(", in lines %zu ... %zu of the file", motion->line[0], motion->line[last]);
  }
  if (motion->time != NULL && last == 0) {
    printf(", %.9g s", motion->time[0]);
  } else if (motion->time != NULL) {
    printf(", %.9g ... %.9g s", motion->time[0], motion->time[last]);
  }
  putchar('\n');
  print_steps(motion);
  if (motion->of_program) {
    print_program(scene, q);
  }
}

static void print_between(const path_scene *scene, const path_question *q) {
  size_t intervals = 0;
  size_t by_axis = 0;
  for (size_t n = 0; n < scene->pairs; n++) {
    const path_proof *proof = &scene->pair[n].proof;
    intervals += proof->count;
    for (size_t k = 0; k < proof->count; k++) {
      by_axis += proof->interval[k].by_axis;
    }
  }
  bool all = path_certified(scene);
  if (all) {
    fputs("CERTIFIED  ", stdout);
  } else {
    printf("certified  %zu of %zu pairs; ", path_certified_pairs(scene), scene->pairs);
  }
  report_print_count(intervals, "interval");
  printf(", %zu of them by an axis", by_axis);
  if (!all) {
    printf("; the resolution is %.6g mm", mm_of(q->resolution.length));
  }
  printf(", %.3f s\n", scene->between_seconds);
}

static void print_certificate(const path_scene *scene, const path_question *q) {
  printf("certificate  %s: ", q->certificate);
  if (!path_certified(scene)) {
    printf("not written%s\n",
           scene->removed ? "; the certificate of an earlier run is removed" : "");
  } else {
    puts("written");
  }
}

static void print_jobs(const path_scene *scene, const path_question *q) {
  const path_jobs *jobs = &scene->jobs;
  char text[SEPAX_CONFIG_TEXT];
  printf(
      "jobs   %s, %zu jobs of %zu poses, %zu trees, %zu bytes; 1 LSB = %.9g mm, clearance %d LSB",
      q->jobs, scene->pairs, scene->motion.lines, jobs->bodies, jobs->bytes,
      mm_of(jobs->resolution), jobs->config.clearance);
  if (jobs->config.warning > 0) {
    printf(", warning %d LSB", jobs->config.warning);
  }
  printf("\nsepax gen %s -o DIR\n", sepax_config_text(&jobs->config, text, sizeof text));
}

void path_print_text(const path_scene *scene, const path_question *q) {
  report_verdict worst = path_worst(scene);
  int width = 0;
  size_t such = 0;
  for (size_t n = 0; n < scene->pairs; n++) {
    const path_pair *pair = &scene->pair[n];
    int length = (int)(strlen(path_body_name(scene, pair->body[0])) +
                       strlen(path_body_name(scene, pair->body[1])) + 2);
    width = length > width ? length : width;
    such += path_verdict_of(pair) == worst;
  }
  print_bodies(scene);
  print_tools(scene);
  print_meshes(scene);
  print_empty(scene);
  print_nothings(scene);
  print_others(q->urdf, &scene->robot.others);
  print_others(q->srdf, &scene->srdf.others);
  print_compared(scene, q);
  print_motion(scene, q);
  if (q->bands.clearance.text != NULL) {
    report_print_bands(WIDTH, &q->bands, NULL, NULL);
    putchar('\n');
  }
  if (q->jobs != NULL) {
    print_jobs(scene, q);
  }
  for (size_t n = 0; n < scene->pairs; n++) {
    if (!is_in_summary(scene, &scene->pair[n])) {
      print_pair(scene, &scene->pair[n], width < 40 ? width : 40);
    }
  }
  for (size_t n = 0; n < scene->motion.names; n++) {
    print_tool(scene, n, width < 40 ? width : 40);
  }
  if (scene->stock.cell > 0) {
    print_stock(scene);
  }
  print_violations(scene);
  if (q->certify) {
    print_between(scene, q);
  }
  if (q->certificate != NULL) {
    print_certificate(scene, q);
  }
  const path_pair *pair = NULL;
  path_moment first = path_worst_moment(scene, &pair);
  printf("%s  %zu of ", report_verdict_titles[worst], such);
  report_print_count(scene->pairs, "pair");
  if (worst != VERDICT_FREE) {
    fputs(", first ", stdout);
    if (first.part > 0) {
      print_segment(scene, first.line);
    } else {
      fputs("in ", stdout);
      print_line(scene, pair, first.line);
    }
  }
  fputs(q->certify ? " (checked in the lines of the path and between them"
                   : " (checked in the lines of the path, not between them",
        stdout);
  if (path_certified(scene) && q->bands.clearance.length > 0) {
    printf("; between the lines all pairs%s are farther apart than %s",
           scene->tool_link != SIZE_MAX ? ", but for flutes and shanks with stock and part," : "",
           q->bands.clearance.text);
  }
  printf("), %.3f s\n", scene->seconds + scene->between_seconds);
}
