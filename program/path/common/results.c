/* SPDX-License-Identifier: MIT */
/* results.c - combines the verdicts of lines and of the motion between them, and finds their
 * moments. */
#include "path/common/parts.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

report_verdict path_in_lines(const path_pair *pair) {
  report_verdict worst = VERDICT_FREE;
  for (int v = 0; v < VERDICTS; v++) {
    worst = pair->lines[v] > 0 ? (report_verdict)v : worst;
  }
  return worst;
}

report_verdict path_between_lines(const path_pair *pair) {
  const path_proof *proof = &pair->proof;
  return proof->collides ? VERDICT_COLLISION : proof->is_open ? VERDICT_UNDECIDED : VERDICT_FREE;
}

report_verdict path_verdict_of(const path_pair *pair) {
  report_verdict lines = path_in_lines(pair);
  report_verdict between = path_between_lines(pair);
  return report_worse(lines, between);
}

report_verdict path_worst(const path_scene *scene) {
  report_verdict worst = VERDICT_FREE;
  for (size_t n = 0; n < scene->pairs; n++) {
    worst = report_worse(worst, path_verdict_of(&scene->pair[n]));
  }
  return worst;
}

size_t path_certified_pairs(const path_scene *scene) {
  size_t count = 0;
  for (size_t n = 0; n < scene->pairs; n++) {
    count += scene->pair[n].proof.certified;
  }
  return count;
}

bool path_certified(const path_scene *scene) {
  return scene->between && path_certified_pairs(scene) == scene->pairs;
}

/* --------------------------------------------------------------------------- moments */

void path_open_ends(const path_pair *pair, double ends[2]) {
  const path_interval *at = &pair->proof.open;
  for (int k = 0; k < 2; k++) {
    ends[k] = ldexp((double)(at->index + (uint64_t)k), -(int)at->level);
  }
}

path_moment path_between_moment(const path_pair *pair) {
  const path_proof *proof = &pair->proof;
  double ends[2];
  path_open_ends(pair, ends);
  return proof->collides ? (path_moment){proof->segment, proof->part}
                         : (path_moment){proof->open.segment, ends[0] / 2 + ends[1] / 2};
}

report_verdict path_motion_verdict(const path_pair *pair, size_t line, path_moment *at) {
  if (pair->between != NULL) {
    *at = (path_moment){line, pair->part[line]};
    return (report_verdict)pair->between[line];
  }
  *at = path_between_moment(pair);
  return at->line == line ? path_between_lines(pair) : VERDICT_FREE;
}

static bool is_before(path_moment a, path_moment b) {
  return a.line < b.line || (a.line == b.line && a.part < b.part);
}

path_moment path_first(const path_pair *pair, report_verdict verdict) {
  path_moment first = {pair->first[verdict], 0};
  if (verdict > VERDICT_WARNING && path_between_lines(pair) == verdict) {
    path_moment between = path_between_moment(pair);
    first = is_before(between, first) ? between : first;
  }
  return first;
}

path_moment path_worst_moment(const path_scene *scene, const path_pair **of) {
  report_verdict worst = path_worst(scene);
  *of = NULL;
  path_moment first = {PATH_NO_LINE, 0};
  double least = INFINITY;
  for (size_t n = 0; n < scene->pairs; n++) {
    const path_pair *pair = &scene->pair[n];
    if (worst == VERDICT_FREE && pair->least < least) {
      least = pair->least;
      first.line = pair->least_line;
      *of = pair;
    } else if (worst != VERDICT_FREE && is_before(path_first(pair, worst), first)) {
      first = path_first(pair, worst);
      *of = pair;
    }
  }
  first.line = first.line == PATH_NO_LINE ? 0 : first.line;
  return first;
}

double path_value(const format_motion *motion, path_moment at, size_t joint) {
  const double *from = &motion->value[at.line * motion->joints + joint];
  return at.part == 0 ? *from : *from + (from[motion->joints] - *from) * at.part;
}

double path_time(const format_motion *motion, path_moment at) {
  const double *from = &motion->time[at.line];
  return at.part == 0 ? *from : *from + (from[1] - *from) * at.part;
}

const char *path_place(const format_motion *motion, size_t line, char text[PATH_PLACE]) {
  const format_step *step = motion->step != NULL ? &motion->step[line] : NULL;
  text[0] = '\0';
  if (step != NULL && step->file != FORMAT_NO_NAME) {
    snprintf(text, PATH_PLACE, step->line > 0 ? "%.240s:%zu" : "%.240s", motion->name[step->file],
             step->line);
  } else if (step != NULL && step->line > 0) {
    snprintf(text, PATH_PLACE, "program line %zu", step->line);
  }
  return text;
}

void path_values(const format_motion *motion, path_moment at, double *value) {
  for (size_t n = 0; n < motion->joints; n++) {
    value[n] = path_value(motion, at, n);
  }
}

void path_points(const path_scene *scene, const path_pair *pair, double point[2][3]) {
  const sepax_mechanism *m = &scene->robot.mechanism;
  const double *value = &scene->motion.value[pair->least_line * scene->motion.joints];
  sepax_chain chain;
  sepax_pose top[2];
  sepax_error error = {0};
  memcpy(point, pair->point, sizeof pair->point);
  if (!sepax_chain_find(&chain, m, m->root, pair->chain.top, &error)) {
    return;
  }
  sepax_chain_poses(&chain, m, value, top);
  for (int side = 0; side < 2; side++) {
    sepax_pose_apply(&top[1], pair->point[side], point[side]);
  }
  sepax_chain_free(&chain);
}
