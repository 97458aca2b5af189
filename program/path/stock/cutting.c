/* SPDX-License-Identifier: MIT */
/* cutting.c - the stock as it is cut.
 *
 * Two bounds of the stock are kept in cells: an outer one, which holds all material that is left,
 * and an inner one, which is wholly material. A motion is tested before it cuts, in short parts:
 * what a part removes is gone for the next part.
 *
 * Flutes and shank touch what they have just cut, and cells that are cut in part stay. So they are
 * tested shrunk by a depth: what is proved is "no deeper than that into what is left". Holders are
 * tested as they are. A holder is also free if it is free of the first stock's mesh. */
#include "path/stock/cutting.h"
#include "path/certificate/certify.h"
#include "path/stock/cutting_state.h"
#include "path/search/line.h"
#include "path/stock/snapshot.h"
#include "util/error.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A part of a motion that cuts is at most this long, in metres: the shank follows the flutes. */
static const double part_most = 1e-3;

/* ---------------------------------------------------------------------- one motion */

/* The pairs of the tool of a motion. */
bool path_cutting_find_pairs(path_cutting *c) {
  size_t tool = c->scene->motion.step[c->line].tool;
  bool any = false;
  memset(c->of, 0, sizeof c->of);
  for (size_t n = 0; n < c->scene->pairs && tool != FORMAT_NO_NAME; n++) {
    path_pair *pair = &c->scene->pair[n];
    if (pair->by_cells && pair->tool == tool) {
      c->of[c->scene->body[pair->body[0]].turned_part] = pair;
      any = true;
    }
  }
  return any;
}

static const path_body *body_of(const path_cutting *c, const path_pair *pair) {
  return &c->scene->body[pair->body[0]];
}

/* Go from the part `from` of the motion to `to`, with one part of the tool. */
sepax__stock_way path_cutting_way(path_cutting *c, const path_pair *pair, double from, double to) {
  const format_motion *motion = &c->scene->motion;
  const double *b = &motion->value[c->line * motion->joints];
  const double *a = c->alone ? b : b - motion->joints;
  double *ends[2] = {c->value + 3 * (motion->joints + 1), c->value + 4 * (motion->joints + 1)};
  for (size_t n = 0; n < motion->joints; n++) {
    ends[0][n] = from == 0 ? a[n] : a[n] + (b[n] - a[n]) * from;
    ends[1][n] = to == 1 ? b[n] : a[n] + (b[n] - a[n]) * to;
  }
  const path_body *body = body_of(c, pair);
  c->joints.from = ends[0];
  c->joints.to = ends[1];
  c->joints.chain = &pair->chain;
  memcpy(c->joints.box[0], body->least, sizeof c->joints.box[0]);
  memcpy(c->joints.box[1], body->most, sizeof c->joints.box[1]);
  return (sepax__stock_way){sepax__stock_joint_piece, &c->joints};
}

/* Does the spindle turn, as far as is known? */
static bool spins(const path_cutting *c) {
  const path_scene *scene = c->scene;
  return !scene->motion.of_program || scene->nc.row[scene->row_of[c->line]].spindle;
}

bool path_cutting_cuts(const path_cutting *c) {
  const path_pair *flutes = c->of[NC_FLUTES];
  return flutes != NULL && !c->alone && c->scene->motion.step[c->line].kind == FORMAT_FEED &&
         spins(c) && body_of(c, flutes)->turned->kind != NC_TOOL_PROBE;
}

/* How far the tool may be from the linear motion of the joints. */
double path_cutting_tolerance(const path_cutting *c) {
  return c->alone ? 0 : c->scene->motion.step[c->line].deviation;
}

/* Keep what was found of a pair in this motion. */
static void note(path_cutting *c, path_pair *pair, report_verdict verdict, const double depth[2]) {
  unsigned char *kept = &pair->verdict[c->line];
  if (report_worse((report_verdict)*kept, verdict) != (report_verdict)*kept) {
    *kept = (unsigned char)verdict;
  }
  if (depth[1] > pair->deepest[1]) {
    pair->deepest[0] = depth[0];
    pair->deepest[1] = depth[1];
    pair->deepest_line = c->line;
  }
}

/* A part of the tool touches the outer bound. Is that certainly material? */
static bool judge(path_cutting *c, const path_pair *pair, const sepax__stock_way *way,
                  sepax_error *error) {
  const path_cutter *shapes = path_cutting_cutter(c, pair);
  double clearance = path_bands(c->q, pair).clearance.length;
  double at[3];
  bool hit = false;
  if ((c->inner != NULL && !sepax__stock_hit(c->inner, shapes->inside.shape, shapes->inside.count,
                                             way, path_cutting_tolerance(c), &hit, at, error)) ||
      !sepax__stock_depth(c->outer, shapes->outside.shape, shapes->outside.count, way,
                          path_cutting_tolerance(c) + clearance, c->depth, error)) {
    return false;
  }
  c->found = hit ? VERDICT_COLLISION : VERDICT_UNDECIDED;
  return true;
}

bool path_cutting_is_outside(path_cutting *c, const path_pair *pair, bool *outside,
                             sepax_error *error) {
  report_verdict within = VERDICT_FREE;
  path_line l = path_line_begin(c->scene, c->q, pair);
  if (!path_certify_segment(c->scene, c->q, pair, c->line - 1, outside, error)) {
    return false;
  }
  path_line_pose(&l, c->line - 1);
  if (*outside && !path_line_within(&l, &within, error)) {
    return false;
  }
  *outside = *outside && within == VERDICT_FREE;
  return true;
}

/* Test one part of the tool between two parts of the motion. */
static bool test(path_cutting *c, nc_tool_part part, double from, double to, sepax_error *error) {
  path_pair *pair = c->of[part];
  sepax__stock_touch found;
  if (pair == NULL || pair->verdict[c->line] == VERDICT_COLLISION) {
    return true;
  }
  bool holder = part == NC_HOLDER;
  const path_cutter *shapes = path_cutting_cutter(c, pair);
  sepax__stock_way way = path_cutting_way(c, pair, from, to);
  double clearance = path_bands(c->q, pair).clearance.length;
  if (!sepax__stock_test(c->outer, shapes->outside.shape, shapes->outside.count, &way,
                         holder ? 0 : c->scene->stock.depth, path_cutting_tolerance(c) + clearance,
                         false, &found, error)) {
    return false;
  }
  bool is_free = found.free;
  bool has_mesh = !c->alone && c->q->first == NULL;
  if (!is_free && holder && has_mesh && !path_cutting_is_outside(c, pair, &is_free, error)) {
    return false;
  }
  if (is_free) {
    return true;
  }
  if (!judge(c, pair, &way, error)) {
    return false;
  }
  double shrink = holder ? 0 : c->scene->stock.depth;
  if (c->found == VERDICT_UNDECIDED &&
      !path_cutting_look_closer(c, pair, from, to, shrink, path_cutting_tolerance(c) + clearance,
                                &is_free, error)) {
    return false;
  }
  if (!is_free) {
    note(c, pair, c->found, c->depth);
  }
  return true;
}

static bool cut(path_cutting *c, double from, double to, sepax_error *error) {
  const path_pair *flutes = c->of[NC_FLUTES];
  const path_cutter *shapes = path_cutting_cutter(c, flutes);
  sepax__stock_way way = path_cutting_way(c, flutes, from, to);
  c->stale = true;
  return sepax__stock_cut(c->outer, shapes->inside.shape, shapes->inside.count, &way,
                          path_cutting_tolerance(c), error) &&
         (c->inner == NULL ||
          sepax__stock_cut(c->inner, shapes->outside.shape, shapes->outside.count, &way,
                           path_cutting_tolerance(c), error));
}

/* The number of parts of a motion that cuts: no point of the tool goes farther than part_most, or
 * half of the flutes' length, in one. */
static size_t parts_of(path_cutting *c) {
  const path_pair *flutes = c->of[NC_FLUTES];
  const path_body *body = body_of(c, flutes);
  double box[2][3];
  memcpy(box[0], body->least, sizeof box[0]);
  memcpy(box[1], body->most, sizeof box[1]);
  double length = box[1][2] - box[0][2];
  path_cutting_way(c, flutes, 0, 1);
  const format_motion *motion = &c->scene->motion;
  double *middle = c->joints.value[0];
  for (size_t n = 0; n < motion->joints; n++) {
    middle[n] = c->joints.from[n] / 2 + c->joints.to[n] / 2;
  }
  double travel = 2 * sepax_chain_travel(&flutes->chain, &c->scene->robot.mechanism, c->joints.from,
                                         middle, c->joints.to, box);
  double parts = ceil(travel / fmin(part_most, length / 2));
  return parts < 1 ? 1 : parts > 1e6 ? 1000000 : (size_t)parts;
}

/* Count what the flutes do in the motion at hand. A tool whose feeds touch nothing may have a wrong
 * offset. */
static bool count_feed(path_cutting *c, bool does_cut, sepax_error *error) {
  const format_step *step = &c->scene->motion.step[c->line];
  const path_pair *flutes = c->of[NC_FLUTES];
  sepax__stock_touch found;
  if (c->alone || step->kind != FORMAT_FEED || flutes == NULL ||
      body_of(c, flutes)->turned->kind == NC_TOOL_PROBE) {
    return true;
  }
  path_feeds *feeds = &c->scene->stock.feeds[step->tool];
  feeds->feeds++;
  if (!does_cut && feeds->still++ == 0) {
    feeds->first_still = c->line;
  }
  if (!does_cut || feeds->touches) {
    return true;
  }
  const path_cutter *shapes = path_cutting_cutter(c, flutes);
  sepax__stock_way way = path_cutting_way(c, flutes, 0, 1);
  if (!sepax__stock_test(c->outer, shapes->outside.shape, shapes->outside.count, &way, 0,
                         path_cutting_tolerance(c), false, &found, error)) {
    return false;
  }
  feeds->touches = !found.free;
  return true;
}

static bool go(path_cutting *c, sepax_error *error) {
  bool does_cut = path_cutting_cuts(c);
  if (!count_feed(c, does_cut, error)) {
    return false;
  }
  bool tested = c->of[NC_SHANK] != NULL || c->of[NC_HOLDER] != NULL;
  size_t parts = does_cut && tested ? parts_of(c) : 1;
  for (size_t n = 0; n < parts; n++) {
    double from = (double)n / (double)parts;
    double to = (double)(n + 1) / (double)parts;
    if ((!does_cut && !test(c, NC_FLUTES, from, to, error)) ||
        !test(c, NC_SHANK, from, to, error) || !test(c, NC_HOLDER, from, to, error) ||
        (does_cut && !cut(c, from, to, error))) {
      return false;
    }
  }
  return true;
}

/* ------------------------------------------------------------------------ all of it */

static void end(path_cutting *c) {
  for (size_t n = 0; n < c->scene->bodies && c->cutter != NULL; n++) {
    path_cutter_free(&c->cutter[n]);
  }
  free(c->cutter);
  free(c->value);
  sepax__stock_free(c->outer);
  sepax__stock_free(c->inner);
}

/* Count the verdicts of a pair. */
static void count(const path_scene *scene, path_pair *pair) {
  pair->lines_asked = 0;
  for (size_t n = 0; n < scene->motion.lines; n++) {
    bool ends = n > 0 && format_motion_goes_on(&scene->motion, n - 1);
    bool alone = !ends && !format_motion_goes_on(&scene->motion, n);
    bool there = pair->tool == FORMAT_NO_NAME || scene->motion.step[n].tool == pair->tool;
    if ((!ends && !alone) || !there) {
      continue;
    }
    int v = pair->verdict[n];
    pair->lines_asked++;
    pair->lines[v]++;
    if (pair->first[v] == PATH_NO_LINE) {
      pair->first[v] = n;
    }
  }
  pair->proof.certified = pair->lines[VERDICT_FREE] == pair->lines_asked;
}

static bool run(path_cutting *c, sepax_error *error) {
  path_scene *scene = c->scene;
  scene->stock.feeds = calloc(scene->motion.names + 1, sizeof *scene->stock.feeds);
  if (scene->stock.feeds == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for tools");
  }
  bool ok = path_cutting_fill(c, error);
  cli_progress progress = cli_progress_begin("motions through the stock", scene->motion.lines);
  for (size_t n = 0; n < scene->pairs && ok; n++) {
    path_pair *pair = &scene->pair[n];
    if (pair->by_cells) {
      free(pair->verdict);
      pair->verdict = calloc(scene->motion.lines, 1);
      ok = pair->verdict != NULL || sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for verdicts");
    }
  }
  for (c->line = 0; c->line < scene->motion.lines && ok; c->line++) {
    bool ends = c->line > 0 && format_motion_goes_on(&scene->motion, c->line - 1);
    c->alone = !ends && !format_motion_goes_on(&scene->motion, c->line);
    ok = c->q->page == NULL || !path_snapshot_due(scene, c->line) ||
         path_snapshot_take(scene, c->outer, c->line, error);
    ok = ok && (!ends || path_cutting_others(c, error)) &&
         ((!ends && !c->alone) || !path_cutting_find_pairs(c) || go(c, error));
    if (ok && ends) {
      path_cutting_others_meet(c);
    }
    cli_progress_show(&progress, c->line);
  }
  path_cutting_end_others(c);
  for (size_t n = 0; n < scene->pairs && ok; n++) {
    if (scene->pair[n].by_cells) {
      count(scene, &scene->pair[n]);
    }
  }
  if (ok) {
    sepax__stock_facts facts = sepax__stock_look(c->outer);
    scene->stock.cells = (size_t)facts.cells;
    scene->stock.bytes = (size_t)facts.bytes;
    ok = (c->q->page == NULL ||
          path_snapshot_take(scene, c->outer, scene->motion.lines - 1, error)) &&
         (c->q->left == NULL || path_cutting_write_left(c, error));
  }
  scene->stock.seconds += cli_progress_end(&progress);
  return ok;
}

bool path_cutting_run(path_scene *scene, const path_question *q, sepax_error *error) {
  path_cutting c = {.scene = scene, .q = q};
  bool ok = run(&c, error);
  end(&c);
  return ok;
}
