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
#include "path/cutting.h"
#include "path/certify.h"
#include "path/cutter.h"
#include "path/line.h"
#include "path/snapshot.h"
#include "util/error.h"
#include "util/write_file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A part of a motion that cuts is at most this long, in metres: the shank follows the flutes. */
static const double part_most = 1e-3;

enum { CELLS_MOST = 1500 };

/* Arcs of profiles are polygons that are no farther from them than this part of a cell. */
static const double arc_error = 0x1p-8;

typedef struct {
  path_scene *scene;
  const path_question *q;
  path_pair *of[NC_TOOL_PARTS]; /* pairs of the tool at hand; NULL: it has no such part */
  path_cutter *cutter;          /* of all bodies */
  sepax__stock *outer, *inner;
  sepax__stock_joints joints;
  double *value; /* memory of `joints`, and of the ends of a part of a motion */
  size_t line;   /* the motion ends in this line */
  bool alone;    /* no motion ends or begins in the line; its pose is tested */
  /* Of the part of a tool at hand: what was found, and how deep it is. */
  report_verdict found;
  double depth[2];
  size_t looks; /* closer looks that were taken */
} cutting;

/* Closer looks at most, and the cells on a side of what they look at. */
enum { LOOKS_MOST = 200, CLOSE_MOST = 200 };

/* ------------------------------------------------------------------------- choices */

/* A tenth of the smallest radius, or 0.2 mm; but no more than CELLS_MOST cells along the stock, as
 * long as the default depth suits the tool. */
static double default_cell(const path_body *stock, double radius) {
  double longest = 0;
  for (int i = 0; i < 3; i++) {
    longest = fmax(longest, stock->most[i] - stock->least[i]);
  }
  double cell = fmin(2e-4, radius / 10);
  return fmin(fmax(cell, longest / CELLS_MOST), radius / 5);
}

bool path_cutting_begin(path_scene *scene, const path_question *q, sepax_error *error) {
  double least = INFINITY;
  for (size_t n = 0; n < scene->pairs; n++) {
    path_pair *pair = &scene->pair[n];
    const path_body *tool = &scene->body[pair->body[0]];
    if (tool->role == NULL || strcmp(tool->role, "core") == 0 ||
        strcmp(path_body_name(scene, pair->body[1]), q->stock) != 0) {
      continue;
    }
    pair->by_cells = true;
    scene->stock.body = pair->body[1];
    if (tool->turned_part == NC_FLUTES) {
      least = fmin(least, tool->turned->diameter / 2 * 1e-3);
    }
  }
  if (isinf(least)) {
    return q->left == NULL ||
           sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "left: no tool with flutes is in the spindle on the path, so nothing of the "
                      "stock is cut; leave --left out");
  }
  path_stock *s = &scene->stock;
  s->cell = q->cell.length > 0 ? q->cell.length : default_cell(&scene->body[s->body], least);
  s->depth = q->depth.text != NULL ? q->depth.length : 2 * s->cell;
  if (!(s->depth < least / 2)) {
    return sepax_fail(
        error, SEPAX_ERROR_ARGUMENT,
        "depth: %.6g mm is half of the radius of the smallest tool, %.6g mm, or more, "
        "so nothing would be proved; give smaller --cells or a smaller --depth",
        s->depth * 1e3, least * 1e3);
  }
  return true;
}

/* ----------------------------------------------------------------------- the stock */

/* What an earlier program has left. Nothing of it is certainly material. */
static bool read_first(cutting *c, sepax_error *error) {
  path_stock *s = &c->scene->stock;
  if (!sepax__stock_read(&c->outer, c->q->first, error)) {
    return false;
  }
  sepax__stock_facts facts = sepax__stock_look(c->outer);
  if (facts.bound != SEPAX__STOCK_OUTER || fabs(facts.cell - s->cell) > 1e-9 * s->cell) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "%.300s: has cells of %.9g mm, not of %.9g mm; give --cells=%.9gmm",
                      c->q->first, facts.cell * 1e3, s->cell * 1e3, facts.cell * 1e3);
  }
  s->cell = facts.cell;
  return true;
}

static bool fill(cutting *c, sepax__stock **stock, sepax__stock_bound bound, sepax_error *error) {
  const path_body *b = &c->scene->body[c->scene->stock.body];
  double box[2][3];
  memcpy(box[0], b->least, sizeof box[0]);
  memcpy(box[1], b->most, sizeof box[1]);
  return sepax__stock_new(stock, bound, box, c->scene->stock.cell, error) &&
         sepax__stock_fill_mesh(*stock, &b->mesh, error);
}

/* Flutes and shanks must be thicker than four times the depth. */
static bool suits_depth(const cutting *c, size_t body, sepax_error *error) {
  const path_body *b = &c->scene->body[body];
  const sepax__stock_shapes *shapes = &c->cutter[body].outside;
  double depth = c->scene->stock.depth;
  for (size_t n = 0; n < shapes->count && b->turned_part != NC_HOLDER; n++) {
    if (!(depth < shapes->shape[n].radius / 2)) {
      return sepax_fail(
          error, SEPAX_ERROR_ARGUMENT,
          "depth: %.6g mm is half of the radius of %.60s, %.6g mm, or more, so nothing "
          "would be proved; give smaller --cells or a smaller --depth",
          depth * 1e3, path_body_name(c->scene, body), shapes->shape[n].radius * 1e3);
    }
  }
  return true;
}

static bool begin(cutting *c, sepax_error *error) {
  path_scene *scene = c->scene;
  size_t joints = scene->motion.joints + 1;
  c->value = calloc(5 * joints, sizeof *c->value);
  c->cutter = calloc(scene->bodies, sizeof *c->cutter);
  if (c->value == NULL || c->cutter == NULL) {
    sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for the stock");
    return false;
  }
  for (int k = 0; k < 3; k++) {
    c->joints.value[k] = c->value + (size_t)k * joints;
  }
  c->joints.mechanism = &scene->robot.mechanism;
  c->joints.mount = (sepax_pose){{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};
  const path_body *stock = &scene->body[scene->stock.body];
  if (stock->open > 0) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "stock: the mesh of %.60s has holes; give a closed mesh",
                      path_body_name(scene, scene->stock.body));
  }
  for (size_t n = 0; n < scene->bodies; n++) {
    const path_body *b = &scene->body[n];
    if (b->role != NULL && (!path_cutter_make(&c->cutter[n], b->turned, b->turned_part,
                                              arc_error * scene->stock.cell, error) ||
                            !suits_depth(c, n, error))) {
      return false;
    }
  }
  if (c->q->first != NULL) {
    return read_first(c, error);
  }
  return fill(c, &c->outer, SEPAX__STOCK_OUTER, error) &&
         fill(c, &c->inner, SEPAX__STOCK_INNER, error);
}

static void end(cutting *c) {
  for (size_t n = 0; n < c->scene->bodies && c->cutter != NULL; n++) {
    path_cutter_free(&c->cutter[n]);
  }
  free(c->cutter);
  free(c->value);
  sepax__stock_free(c->outer);
  sepax__stock_free(c->inner);
}

/* ---------------------------------------------------------------------- one motion */

/* The pairs of the tool of a motion. */
static bool find_pairs(cutting *c) {
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

static const path_body *body_of(const cutting *c, const path_pair *pair) {
  return &c->scene->body[pair->body[0]];
}

static const path_cutter *cutter_of(const cutting *c, const path_pair *pair) {
  return &c->cutter[pair->body[0]];
}

/* Go from the part `from` of the motion to `to`, with one part of the tool. */
static sepax__stock_way way_of(cutting *c, const path_pair *pair, double from, double to) {
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
static bool spins(const cutting *c) {
  const path_scene *scene = c->scene;
  return !scene->motion.of_program || scene->nc.row[scene->row_of[c->line]].spindle;
}

static bool cuts(const cutting *c) {
  const path_pair *flutes = c->of[NC_FLUTES];
  return flutes != NULL && !c->alone && c->scene->motion.step[c->line].kind == FORMAT_FEED &&
         spins(c) && body_of(c, flutes)->turned->kind != NC_TOOL_PROBE;
}

/* How far the tool may be from the linear motion of the joints. */
static double tolerance_of(const cutting *c) {
  return c->alone ? 0 : c->scene->motion.step[c->line].deviation;
}

/* Keep what was found of a pair in this motion. */
static void note(cutting *c, path_pair *pair, report_verdict verdict, const double depth[2]) {
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
static bool judge(cutting *c, const path_pair *pair, const sepax__stock_way *way,
                  sepax_error *error) {
  const path_cutter *shapes = cutter_of(c, pair);
  double clearance = path_bands(c->q, pair).clearance.length;
  double at[3];
  bool hit = false;
  if ((c->inner != NULL && !sepax__stock_hit(c->inner, shapes->inside.shape, shapes->inside.count,
                                             way, tolerance_of(c), &hit, at, error)) ||
      !sepax__stock_depth(c->outer, shapes->outside.shape, shapes->outside.count, way,
                          tolerance_of(c) + clearance, c->depth, error)) {
    return false;
  }
  c->found = hit ? VERDICT_COLLISION : VERDICT_UNDECIDED;
  return true;
}

/* -------------------------------------------------------------------- a closer look */

/* Cut a stock by all that the path has cut before the part `from` of the motion at hand. */
static bool replay(cutting *c, sepax__stock *stock, double from, sepax_error *error) {
  size_t line = c->line;
  bool alone = c->alone;
  bool ok = true;
  c->alone = false;
  for (c->line = 1; c->line <= line && ok; c->line++) {
    double to = c->line < line ? 1 : from;
    if (!format_motion_goes_on(&c->scene->motion, c->line - 1) || !find_pairs(c) || !cuts(c) ||
        to == 0) {
      continue;
    }
    const path_pair *flutes = c->of[NC_FLUTES];
    const path_cutter *shapes = cutter_of(c, flutes);
    sepax__stock_way way = way_of(c, flutes, 0, to);
    ok = sepax__stock_cut(stock, shapes->inside.shape, shapes->inside.count, &way, tolerance_of(c),
                          error);
  }
  c->line = line;
  c->alone = alone;
  find_pairs(c);
  return ok;
}

/* A box around the cells that were touched, with cells of a quarter of the side around it. */
static bool make_close(cutting *c, sepax__stock **stock, const double touched[2][3],
                       sepax_error *error) {
  const path_body *b = &c->scene->body[c->scene->stock.body];
  double cell = c->scene->stock.cell;
  double box[2][3];
  for (int i = 0; i < 3; i++) {
    box[0][i] = touched[0][i] - cell / 8;
    box[1][i] = touched[1][i] + cell / 8;
    if (box[1][i] - box[0][i] > CLOSE_MOST * cell) {
      *stock = NULL;
      return true;
    }
  }
  return sepax__stock_new(stock, SEPAX__STOCK_OUTER, box, cell / 4, error) &&
         sepax__stock_fill_mesh(*stock, &b->mesh, error);
}

/* Does a closer look, with cells of a quarter of the side around what was touched, prove that the
 * part of the tool is free? It heals seams: walls of cells between two cuts that overlap by less
 * than a cell. */
static bool look_closer(cutting *c, path_pair *pair, double from, double to, double shrink,
                        double tolerance, bool *is_free, sepax_error *error) {
  const path_cutter *shapes = cutter_of(c, pair);
  sepax__stock_touch found;
  sepax__stock *close = NULL;
  if (c->looks == LOOKS_MOST || c->q->first != NULL) {
    return true;
  }
  c->looks++;
  sepax__stock_way way = way_of(c, pair, from, to);
  bool ok = sepax__stock_test(c->outer, shapes->outside.shape, shapes->outside.count, &way, shrink,
                              tolerance, true, &found, error) &&
            make_close(c, &close, (const double(*)[3])found.box, error);
  if (ok && close != NULL) {
    ok = replay(c, close, from, error);
    way = way_of(c, pair, from, to);
    ok = ok && sepax__stock_test(close, shapes->outside.shape, shapes->outside.count, &way, shrink,
                                 tolerance, false, &found, error);
    *is_free = ok && found.free;
  }
  sepax__stock_free(close);
  return ok;
}

/* Is a holder outside of the first stock's mesh, and does it stay away from it on the whole motion?
 */
static bool is_outside(cutting *c, const path_pair *pair, bool *outside, sepax_error *error) {
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
static bool test(cutting *c, nc_tool_part part, double from, double to, sepax_error *error) {
  path_pair *pair = c->of[part];
  sepax__stock_touch found;
  if (pair == NULL || pair->verdict[c->line] == VERDICT_COLLISION) {
    return true;
  }
  bool holder = part == NC_HOLDER;
  const path_cutter *shapes = cutter_of(c, pair);
  sepax__stock_way way = way_of(c, pair, from, to);
  double clearance = path_bands(c->q, pair).clearance.length;
  if (!sepax__stock_test(c->outer, shapes->outside.shape, shapes->outside.count, &way,
                         holder ? 0 : c->scene->stock.depth, tolerance_of(c) + clearance, false,
                         &found, error)) {
    return false;
  }
  bool is_free = found.free;
  bool has_mesh = !c->alone && c->q->first == NULL;
  if (!is_free && holder && has_mesh && !is_outside(c, pair, &is_free, error)) {
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
      !look_closer(c, pair, from, to, shrink, tolerance_of(c) + clearance, &is_free, error)) {
    return false;
  }
  if (!is_free) {
    note(c, pair, c->found, c->depth);
  }
  return true;
}

static bool cut(cutting *c, double from, double to, sepax_error *error) {
  const path_pair *flutes = c->of[NC_FLUTES];
  const path_cutter *shapes = cutter_of(c, flutes);
  sepax__stock_way way = way_of(c, flutes, from, to);
  return sepax__stock_cut(c->outer, shapes->inside.shape, shapes->inside.count, &way,
                          tolerance_of(c), error) &&
         (c->inner == NULL ||
          sepax__stock_cut(c->inner, shapes->outside.shape, shapes->outside.count, &way,
                           tolerance_of(c), error));
}

/* The number of parts of a motion that cuts: no point of the tool goes farther than part_most, or
 * half of the flutes' length, in one. */
static size_t parts_of(cutting *c) {
  const path_pair *flutes = c->of[NC_FLUTES];
  const path_body *body = body_of(c, flutes);
  double box[2][3];
  memcpy(box[0], body->least, sizeof box[0]);
  memcpy(box[1], body->most, sizeof box[1]);
  double length = box[1][2] - box[0][2];
  way_of(c, flutes, 0, 1);
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

static bool go(cutting *c, sepax_error *error) {
  bool does_cut = cuts(c);
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

/* Count the verdicts of a pair. */
static void count(const path_scene *scene, path_pair *pair) {
  pair->lines_asked = 0;
  for (size_t n = 0; n < scene->motion.lines; n++) {
    bool ends = n > 0 && format_motion_goes_on(&scene->motion, n - 1);
    bool alone = !ends && !format_motion_goes_on(&scene->motion, n);
    if ((!ends && !alone) || scene->motion.step[n].tool != pair->tool) {
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

/* ------------------------------------------------------------------- what is left */

static bool write_obj(FILE *out, const void *context) {
  const sepax_soup *mesh = context;
  bool ok = fputs("# what is left of the stock, in metres\n", out) != EOF;
  for (size_t n = 0; n < mesh->count && ok; n++) {
    const double(*v)[3] = (const double(*)[3])mesh->facet[n].v;
    for (int k = 0; k < 3 && ok; k++) {
      ok = fprintf(out, "v %.17g %.17g %.17g\n", v[k][0], v[k][1], v[k][2]) > 0;
    }
    ok = ok && fputs("f -3 -2 -1\n", out) != EOF;
  }
  return ok;
}

static bool write_left(const cutting *c, sepax_error *error) {
  enum { TRIANGLES_MOST = 20000000 };
  const char *path = c->q->left;
  size_t length = strlen(path);
  sepax_soup mesh = {0};
  if (length < 4 || strcmp(path + length - 4, ".obj") != 0) {
    return sepax__stock_write(c->outer, path, error);
  }
  bool ok = sepax__stock_mesh(c->outer, TRIANGLES_MOST, &mesh, error) &&
            sepax_write_file(path, write_obj, &mesh, error);
  sepax_soup_free(&mesh);
  return ok;
}

static bool run(cutting *c, sepax_error *error) {
  path_scene *scene = c->scene;
  cli_progress progress = cli_progress_begin("motions through the stock", scene->motion.lines);
  bool ok = begin(c, error);
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
    ok = ok && ((!ends && !c->alone) || !find_pairs(c) || go(c, error));
    cli_progress_show(&progress, c->line);
  }
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
         (c->q->left == NULL || write_left(c, error));
  }
  scene->stock.seconds = cli_progress_end(&progress);
  return ok;
}

bool path_cutting_run(path_scene *scene, const path_question *q, sepax_error *error) {
  cutting c = {.scene = scene, .q = q};
  bool ok = run(&c, error);
  end(&c);
  return ok;
}
