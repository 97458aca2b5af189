/* SPDX-License-Identifier: MIT */
/* text.c - what sepax path prints for people. */
#include "path/print/text.h"
#include "report/text.h"
#include "report/within.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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
void path_print_line(const path_scene *scene, const path_pair *pair, size_t line) {
  print_place(scene, "", pair != NULL ? path_motion_of(scene, pair, line) : line);
  printf("%s %zu", row_word(scene), scene->motion.line[line]);
  if (scene->motion.time != NULL) {
    printf(" (%.9g s)", scene->motion.time[line]);
  }
}

double path_mm(double length) { return report_mm(length, CLI_METRES); }

static void print_point(const double v[3]) {
  printf("%.6g,%.6g,%.6g mm", path_mm(v[0]), path_mm(v[1]), path_mm(v[2]));
}

void path_print_least(const path_scene *scene, const path_pair *pair) {
  if (pair->least_line == PATH_NO_LINE) {
    return;
  }
  if (pair->least == 0) {
    fputs(pair->inside ? "; one body, or a part of it, is inside the other" : "", stdout);
    return;
  }
  double point[2][3];
  path_points(scene, pair, point);
  printf("; least clearance %.6g mm in ", path_mm(pair->least));
  path_print_line(scene, pair, pair->least_line);
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
    printf(", open to %.9g, %.6g mm in its middle", ends[1], path_mm(proof->distance));
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

static void print_pair(const path_scene *scene, const path_pair *pair, int width) {
  char names[2 * 64 + 4];
  snprintf(names, sizeof names, "%.60s, %.60s", path_body_name(scene, pair->body[0]),
           path_body_name(scene, pair->body[1]));
  printf("%-9s  %-*s", report_verdict_titles[path_verdict_of(pair)], width, names);
  if (pair->by_cells) {
    path_print_stock_pair(scene, pair);
    return;
  }
  const char *before = "  ";
  for (int v = VERDICT_COLLISION; v > VERDICT_FREE; v--) {
    static const char *const what[] = {"", "a warning", "undecided", "collide"};
    if (pair->lines[v] > 0) {
      printf("%s%s in ", before, what[v]);
      report_print_count(pair->lines[v], "line");
      fputs(", first in ", stdout);
      path_print_line(scene, pair, pair->first[v]);
      before = "; ";
    }
  }
  if (path_in_lines(pair) == VERDICT_FREE) {
    if (path_is_core(scene, pair)) {
      printf("  flutes no deeper than %.6g mm", path_mm(scene->gouge));
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
  path_print_least(scene, pair);
  if (pair->why != SEPAX_WITHIN_PLAIN) {
    fputs("; ", stdout);
    report_print_within(pair->why, path_body_name(scene, pair->body[pair->why_of]),
                        path_body_name(scene, pair->body[!pair->why_of]));
  }
  putchar('\n');
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
    printf("; the resolution is %.6g mm", path_mm(q->resolution.length));
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

static void print_tube(const path_scene *scene, const path_question *q) {
  if (path_tube_is_free(scene)) {
    printf("tube   %s: %zu rows, clearance %.9g mm\n", q->tube, scene->motion.lines,
           path_mm(q->bands.clearance.length));
  } else {
    printf("tube   %s: not written%s\n", q->tube,
           scene->tube_removed ? "; the tube of an earlier run is removed" : "");
  }
}

static void print_jobs(const path_scene *scene) {
  char text[SEPAX_CONFIG_TEXT];
  for (size_t n = 0; n < scene->job_lists; n++) {
    const path_jobs *jobs = &scene->jobs[n];
    printf("%-7s%s, %zu jobs of %zu poses, %zu trees, %zu bytes; 1 LSB = %.9g mm, clearance %d LSB",
           n == 0 ? "jobs" : "", jobs->file, jobs->jobs, jobs->poses, jobs->bodies, jobs->bytes,
           path_mm(jobs->resolution), jobs->config.clearance);
    if (jobs->config.warning > 0) {
      printf(", warning %d LSB", jobs->config.warning);
    }
    putchar('\n');
  }
  if (scene->jobs_left_out > 0) {
    printf("%-7s", "");
    report_print_count(scene->jobs_left_out, "pair");
    puts(" left out, because rules or the stock as it is cut decide when they may meet");
  }
  printf("sepax gen %s -o DIR\n", sepax_config_text(&scene->jobs->config, text, sizeof text));
}

/* The last line: the verdict of all pairs, and how many have it. */
static void print_verdict(const path_scene *scene, const path_question *q) {
  report_verdict worst = path_worst(scene);
  size_t such = 0;
  for (size_t n = 0; n < scene->pairs; n++) {
    such += path_verdict_of(&scene->pair[n]) == worst;
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
      path_print_line(scene, pair, first.line);
    }
  }
  fputs(q->certify ? " (checked in the lines of the path and between them"
                   : " (checked in the lines of the path, not between them",
        stdout);
  if (path_certified(scene) && q->bands.clearance.length > 0) {
    printf("; between the lines all pairs%s are farther apart than %.9g mm",
           scene->tool_link != SIZE_MAX ? ", but for flutes and shanks with stock and part," : "",
           path_mm(q->bands.clearance.length));
  }
  printf("), %.3f s\n", scene->seconds + scene->between_seconds + scene->stock.seconds);
}

void path_print_text(const path_scene *scene, const path_question *q) {
  int width = 0;
  for (size_t n = 0; n < scene->pairs; n++) {
    const path_pair *pair = &scene->pair[n];
    int length = (int)(strlen(path_body_name(scene, pair->body[0])) +
                       strlen(path_body_name(scene, pair->body[1])) + 2);
    width = length > width ? length : width;
  }
  path_print_scene(scene, q);
  if (q->bands.clearance.text != NULL) {
    report_print_bands(PATH_WIDTH, &q->bands, NULL, NULL);
    putchar('\n');
  }
  if (q->jobs != NULL) {
    print_jobs(scene);
  }
  for (size_t n = 0; n < scene->pairs; n++) {
    if (!path_is_in_summary(scene, &scene->pair[n])) {
      print_pair(scene, &scene->pair[n], width < 40 ? width : 40);
    }
  }
  for (size_t n = 0; n < scene->motion.names; n++) {
    path_print_tool(scene, n, width < 40 ? width : 40);
  }
  if (scene->stock.cell > 0) {
    path_print_stock(scene);
    path_print_feeds(scene);
  } else if (q->stock != NULL) {
    printf("stock  %s, and no tool with flutes is in the spindle, so nothing is cut\n", q->stock);
  }
  path_print_violations(scene);
  if (q->certify) {
    print_between(scene, q);
  }
  if (q->certificate != NULL) {
    print_certificate(scene, q);
  }
  if (q->tube != NULL) {
    print_tube(scene, q);
  }
  print_verdict(scene, q);
}
