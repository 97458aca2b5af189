/* SPDX-License-Identifier: MIT */
/* dogleg.c - rapids in which each axis takes its own time. The values of the joints are then
 * anywhere in the box between those of the two ends. The box is divided until the bodies of each
 * box are apart, and each box becomes a motion of its own: it goes along the box in one joint, with
 * the others at their middle, and half their sides are deviations (deviation.c). Each value in the
 * box is a value of the motion, with the other joints no farther off than that. */
#include "path/nc/deviation.h"
#include "path/nc/program.h"
#include "util/error.h"
#include "util/memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The most divisions of a box, and boxes that are examined in a motion. */
enum { LEVELS = 20, BOXES = 8192 };

typedef struct {
  path_scene *scene;
  const path_question *q;
  size_t joints;
  double *levers;
  double *from, *to;   /* the box at hand: the values of all joints */
  double *middle;      /* its middle */
  double *off, *moved; /* how far joints may be from there; the same without the box */
  size_t *open;        /* for each level: the pairs that are not apart yet */
  size_t left;         /* boxes that may still be examined */
  bool ended;          /* a collision was found, or no box is left: divide no more */
  format_motion path;  /* the new lines */
  size_t *row_of;
  double *spread;
  size_t capacity;
} dividing;

/* ------------------------------------------------------------------------- lines */

static bool more_lines(dividing *d, sepax_error *error) {
  format_motion *path = &d->path;
  if (path->lines < d->capacity) {
    return true;
  }
  size_t capacity = 2 * d->capacity + 64;
  size_t row = d->joints * sizeof(double);
  double *value = sepax_resize(path->value, capacity * row);
  path->value = value != NULL ? value : path->value;
  size_t *line = sepax_resize(path->line, capacity * sizeof *line);
  path->line = line != NULL ? line : path->line;
  format_step *step = sepax_resize(path->step, capacity * sizeof *step);
  path->step = step != NULL ? step : path->step;
  size_t *row_of = sepax_resize(d->row_of, capacity * sizeof *row_of);
  d->row_of = row_of != NULL ? row_of : d->row_of;
  double *spread = sepax_resize(d->spread, capacity * row);
  d->spread = spread != NULL ? spread : d->spread;
  if (value == NULL || line == NULL || step == NULL || row_of == NULL || spread == NULL) {
    sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu lines of a path", capacity);
    return false;
  }
  d->capacity = capacity;
  return true;
}

/* Add a line with these values; its place in the program is that of a line of the old path. */
static bool add_line(dividing *d, const double *value, size_t old, bool breaks,
                     sepax_error *error) {
  format_motion *path = &d->path;
  if (!more_lines(d, error)) {
    return false;
  }
  size_t line = path->lines++;
  memcpy(&path->value[line * d->joints], value, d->joints * sizeof *value);
  memset(&d->spread[line * d->joints], 0, d->joints * sizeof *value);
  path->line[line] = line + 2;
  path->step[line] = d->scene->motion.step[old];
  path->step[line].breaks = breaks;
  d->row_of[line] = d->scene->row_of[old];
  return true;
}

/* --------------------------------------------------------------------------- boxes */

static const sepax_mechanism *mechanism_of(const dividing *d) { return &d->scene->robot.mechanism; }

/* The middle of the box, and how far each joint may be from there. */
static void find_middle(dividing *d) {
  for (size_t j = 0; j < d->joints; j++) {
    d->middle[j] = d->from[j] / 2 + d->to[j] / 2;
    double half = fabs(d->to[j] - d->from[j]) / 2;
    d->off[j] = half > 0 ? half * (1 + 0x1p-40) + 0x1p-50 * fabs(d->middle[j]) : 0;
  }
  sepax_mechanism_follow(mechanism_of(d), d->middle);
  for (size_t j = 0; j < d->joints; j++) {
    d->off[j] += d->moved[j];
  }
  path_followers_off(mechanism_of(d), d->off);
}

/* Find the joint along which to divide the box: none moves the bodies of the pair farther than this
 * one. Change *split and *most if it moves them farther than *most. */
static void find_widest(const dividing *d, size_t pair, size_t *split, double *most) {
  const double *lever = &d->levers[2 * pair * d->joints];
  for (size_t j = 0; j < d->joints; j++) {
    double half = fabs(d->to[j] - d->from[j]) / 2;
    double moves = fmin(lever[j], lever[j + d->joints]) * half;
    if (mechanism_of(d)->joint[j].mimic == SEPAX_NO_JOINT && moves > *most) {
      *most = moves;
      *split = j;
    }
  }
}

/* Keep the pairs that are open in this box. *split: the joint along which to divide; SIZE_MAX:
 * none, because no box is left, a collision was found or the box is small enough. */
static bool examine(dividing *d, size_t *open, size_t *count, size_t *split, sepax_error *error) {
  static const sepax_apart_request request = {.size = sizeof(sepax_apart_request)};
  const path_scene *scene = d->scene;
  size_t still = 0;
  double most = 0; /* of the joint along which to divide */
  *split = SIZE_MAX;
  d->left -= d->left > 0;
  find_middle(d);
  for (size_t n = 0; n < *count; n++) {
    const path_pair *pair = &scene->pair[open[n]];
    const path_body *body[2] = {&scene->body[pair->body[0]], &scene->body[pair->body[1]]};
    double clearance = path_bands(d->q, pair).clearance.length;
    double nearer = path_nearer(scene, d->levers, open[n], d->off);
    sepax_pose pose[2];
    sepax_apart_result r;
    sepax_chain_poses(&pair->chain, mechanism_of(d), d->middle, pose);
    if (!sepax_bodies_apart(body[0]->body, &pose[0], body[1]->body, &pose[1],
                            (clearance + nearer) * (1 + 0x1p-40), &request, &r, error)) {
      return false;
    }
    if (r.verdict == SEPAX_APART) {
      continue;
    }
    most = fmax(most, pair->by_cells ? scene->stock.cell : d->q->resolution.length);
    find_widest(d, open[n], split, &most);
    if (!pair->by_cells && !sepax_bodies_apart(body[0]->body, &pose[0], body[1]->body, &pose[1],
                                               clearance, &request, &r, error)) {
      return false;
    }
    d->ended = d->ended || r.verdict == SEPAX_NEAR;
    open[still++] = open[n];
  }
  *count = still;
  d->ended = d->ended || d->left == 0;
  return true;
}

/* Add the motion of a box to the path. It goes along the joint that moves bodies farthest; if a
 * pair is open, by the middle of the box. */
static bool add_box(dividing *d, size_t line, bool is_open, sepax_error *error) {
  size_t along = SIZE_MAX;
  double most = -1;
  find_middle(d);
  for (size_t j = 0; j < d->joints; j++) {
    double half = fabs(d->to[j] - d->from[j]);
    double moves = 0;
    for (size_t n = 0; n < d->scene->pairs; n++) {
      const double *lever = &d->levers[2 * n * d->joints];
      moves = fmax(moves, fmin(lever[j], lever[j + d->joints]) * half);
    }
    if (half > 0 && mechanism_of(d)->joint[j].mimic == SEPAX_NO_JOINT && moves > most) {
      most = moves;
      along = j;
    }
  }
  const double *const end[3] = {d->from, d->middle, d->to};
  double at = d->middle[along];
  for (int k = 0; k < 3; k++) {
    if (k == 1 && !is_open) {
      continue;
    }
    d->middle[along] = k == 1 ? at : end[k][along];
    sepax_mechanism_follow(mechanism_of(d), d->middle);
    if (!add_line(d, d->middle, line, k == 0, error)) {
      return false;
    }
    double *spread = &d->spread[(d->path.lines - 1) * d->joints];
    for (size_t j = 0; j < d->joints; j++) {
      spread[j] = j == along ? 0 : d->off[j] - d->moved[j];
    }
  }
  return true;
}

static bool divide(dividing *d, size_t line, size_t *open, size_t count, int level,
                   sepax_error *error) {
  size_t split = SIZE_MAX;
  if (!d->ended && !examine(d, open, &count, &split, error)) {
    return false;
  }
  if (d->ended || split == SIZE_MAX || level == LEVELS) {
    return add_box(d, line, d->ended || count > 0, error);
  }
  size_t *next = open + count;
  double from = d->from[split];
  double to = d->to[split];
  double middle = from / 2 + to / 2;
  memcpy(next, open, count * sizeof *next);
  d->to[split] = middle;
  bool ok = divide(d, line, next, count, level + 1, error);
  d->from[split] = middle;
  d->to[split] = to;
  memcpy(next, open, count * sizeof *next);
  ok = ok && divide(d, line, next, count, level + 1, error);
  d->from[split] = from;
  return ok;
}

/* Does the motion that ends in this line of the old path need a box? */
static bool is_box(const path_scene *scene, size_t line) {
  const format_motion *motion = &scene->motion;
  if (line == 0 || !scene->nc.row[scene->row_of[line]].dogleg ||
      !format_motion_goes_on(motion, line - 1)) {
    return false;
  }
  size_t moving = 0;
  const double *now = &motion->value[line * motion->joints];
  for (size_t j = 0; j < motion->joints; j++) {
    moving += scene->robot.mechanism.joint[j].mimic == SEPAX_NO_JOINT &&
              now[j] != now[j - motion->joints];
  }
  return moving > 1;
}

static bool add_boxes(dividing *d, size_t line, sepax_error *error) {
  const path_scene *scene = d->scene;
  const double *now = &scene->motion.value[line * d->joints];
  size_t count = 0;
  memcpy(d->from, now - d->joints, d->joints * sizeof *d->from);
  memcpy(d->to, now, d->joints * sizeof *d->to);
  path_joints_off(scene, d->q->blended, line, d->moved);
  for (size_t n = 0; n < scene->pairs; n++) {
    if (path_motion_decided(scene, &scene->pair[n], line - 1)) {
      d->open[count++] = n;
    }
  }
  d->left = BOXES;
  d->ended = false;
  return divide(d, line, d->open, count, 0, error) && add_line(d, now, line, true, error);
}

static bool add_all(dividing *d, sepax_error *error) {
  const format_motion *motion = &d->scene->motion;
  cli_progress progress = cli_progress_begin("motions with dog-legs", motion->lines);
  bool ok = true;
  for (size_t n = 0; n < motion->lines && ok; n++) {
    ok = is_box(d->scene, n)
             ? add_boxes(d, n, error)
             : add_line(d, &motion->value[n * d->joints], n, motion->step[n].breaks, error);
    cli_progress_show(&progress, n);
  }
  cli_progress_end(&progress);
  return ok;
}

/* Take the new lines in place of the old ones. */
static void replace(dividing *d) {
  format_motion *motion = &d->scene->motion;
  sepax_release(motion->value);
  sepax_release(motion->line);
  sepax_release(motion->step);
  sepax_release(d->scene->row_of);
  motion->value = d->path.value;
  motion->line = d->path.line;
  motion->step = d->path.step;
  motion->lines = d->path.lines;
  d->scene->row_of = d->row_of;
  d->scene->spread = d->spread;
}

bool path_program_doglegs(path_scene *scene, const path_question *q, sepax_error *error) {
  size_t joints = scene->robot.mechanism.joints;
  dividing d = {.scene = scene, .q = q, .joints = joints};
  d.from = calloc(5 * joints + 1, sizeof *d.from);
  d.open = calloc((LEVELS + 2) * (scene->pairs + 1), sizeof *d.open);
  d.levers = path_levers(scene, error);
  bool ok = d.levers != NULL;
  if (ok && (d.from == NULL || d.open == NULL)) {
    sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for dog-legs");
    ok = false;
  }
  if (ok) {
    d.to = d.from + joints;
    d.middle = d.to + joints;
    d.off = d.middle + joints;
    d.moved = d.off + joints;
    ok = add_all(&d, error);
  }
  if (ok) {
    replace(&d);
  } else {
    sepax_release(d.path.value);
    sepax_release(d.path.line);
    sepax_release(d.path.step);
    sepax_release(d.row_of);
    sepax_release(d.spread);
  }
  free(d.from);
  free(d.open);
  free(d.levers);
  return ok;
}
