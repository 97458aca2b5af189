/* SPDX-License-Identifier: MIT */
/* cutting_others.c - bodies that are no part of a tool, such as the spindle, and the stock as it is
 * cut. They are compared with the first stock's mesh like all bodies. Where they are not free of
 * that, they are compared with the surface of what is left, which is a body like any other. */
#include "path/stock/cutting_state.h"
#include "mechanism/steps.h"
#include "path/search/line.h"
#include "util/error.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What is left is made into a body so often at most, with so many triangles at most. */
enum { MADE_MOST = 200, TRIANGLES_MOST = 4000000 };

static bool is_other(const path_cutting *c, const path_pair *pair) {
  size_t stock = c->scene->stock.body;
  return !pair->by_cells && pair->tool == FORMAT_NO_NAME && pair->between != NULL &&
         (pair->body[0] == stock || pair->body[1] == stock);
}

/* Is the pair free of the first stock in the motion at hand? */
static bool is_free(const path_cutting *c, const path_pair *pair) {
  return pair->between[c->line - 1] == VERDICT_FREE && pair->verdict[c->line] == VERDICT_FREE &&
         pair->verdict[c->line - 1] == VERDICT_FREE;
}

static void free_left(path_cutting *c) {
  path_body *b = &c->left;
  if (b->part != NULL) {
    sepax_shell_free(&b->part->shell);
    sepax_body_free(b->part->body);
    free(b->part);
  }
  sepax_soup_free(&b->mesh);
  *b = (path_body){.part = NULL};
}

/* Make what is left into a body. */
static bool make_left(path_cutting *c, sepax_error *error) {
  const path_body *stock = &c->scene->body[c->scene->stock.body];
  sepax_soup mesh = {0};
  free_left(c);
  c->left.link = stock->link;
  c->left.tool = FORMAT_NO_NAME;
  c->left.part = calloc(1, sizeof *c->left.part);
  if (c->left.part == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for what is left of the stock");
  }
  bool ok = sepax__stock_mesh(c->outer, TRIANGLES_MOST, &mesh, error);
  c->nothing_left = ok && mesh.count == 0;
  ok = ok && (c->nothing_left || path_body_of_mesh(&c->left, &mesh, false, error));
  sepax_soup_free(&mesh);
  c->stale = false;
  c->made++;
  return ok;
}

/* Is the body of a pair free of what was left when that was last made into a body? */
static bool is_free_of_left(path_cutting *c, const path_pair *pair, bool *yes, sepax_error *error) {
  path_body *stock = &c->scene->body[c->scene->stock.body];
  const path_body first = *stock;
  if (c->nothing_left) {
    *yes = true;
    return true;
  }
  *stock = c->left;
  bool ok = path_cutting_is_outside(c, pair, yes, error);
  *stock = first;
  return ok;
}

/* Is a vertex of the body in a cell that is wholly material? */
static bool meets_material(const path_cutting *c, const path_pair *pair, double part) {
  const path_scene *scene = c->scene;
  const format_motion *motion = &scene->motion;
  int other = pair->body[0] == scene->stock.body;
  const path_body *b = &scene->body[pair->body[other]];
  sepax_pose pose[2];
  path_values(motion, (path_moment){c->line - 1, part}, c->value);
  sepax_chain_poses(&pair->chain, &scene->robot.mechanism, c->value, pose);
  sepax_pose seen = sepax__pose_seen(&pose[!other], &pose[other]);
  for (size_t n = 0; n < 3 * b->mesh.count; n++) {
    double at[3];
    sepax_pose_apply(&seen, b->mesh.facet[n / 3].v[n % 3], at);
    if (sepax__stock_has(c->inner, at)) {
      return true;
    }
  }
  return false;
}

/* Is a pair that is not free of the first stock free of what is left? */
static bool decide(path_cutting *c, const path_pair *pair, bool *yes, sepax_error *error) {
  if (c->made == 0 && !make_left(c, error)) {
    return false;
  }
  if (!is_free_of_left(c, pair, yes, error)) {
    return false;
  }
  return *yes || !c->stale || c->made == MADE_MOST ||
         (make_left(c, error) && is_free_of_left(c, pair, yes, error));
}

bool path_cutting_others(path_cutting *c, sepax_error *error) {
  path_scene *scene = c->scene;
  for (size_t n = 0; n < scene->pairs; n++) {
    path_pair *pair = &scene->pair[n];
    bool yes = false;
    if (!is_other(c, pair) || is_free(c, pair)) {
      continue;
    }
    if (!decide(c, pair, &yes, error)) {
      return false;
    }
    pair->of_left = true;
    pair->between[c->line - 1] = VERDICT_FREE;
    pair->verdict[c->line] = yes ? VERDICT_FREE : VERDICT_UNDECIDED;
    if (c->line == 1 || !format_motion_goes_on(&scene->motion, c->line - 2)) {
      pair->verdict[c->line - 1] = VERDICT_FREE; /* the motion begins there */
    }
  }
  return true;
}

void path_cutting_others_meet(path_cutting *c) {
  for (size_t n = 0; n < c->scene->pairs && c->inner != NULL; n++) {
    path_pair *pair = &c->scene->pair[n];
    if (!pair->of_left || pair->verdict[c->line] != VERDICT_UNDECIDED) {
      continue;
    }
    const double parts[] = {0, pair->part[c->line - 1], 0.5, 1};
    for (size_t k = 0; k < sizeof parts / sizeof *parts; k++) {
      if (meets_material(c, pair, parts[k])) {
        pair->verdict[c->line] = VERDICT_COLLISION;
      }
    }
  }
}

void path_cutting_end_others(path_cutting *c) {
  free_left(c);
  for (size_t n = 0; n < c->scene->pairs; n++) {
    path_pair *pair = &c->scene->pair[n];
    if (!pair->of_left) {
      continue;
    }
    pair->by_cells = true; /* what is left decides, and no certificate */
    pair->proof.count = 0;
    pair->proof.is_open = false;
    pair->proof.collides = false;
    pair->least = INFINITY;
    pair->least_line = PATH_NO_LINE;
    pair->deepest[1] = INFINITY;
    for (int v = 0; v < VERDICTS; v++) {
      pair->lines[v] = 0;
      pair->first[v] = PATH_NO_LINE;
    }
    free(pair->between);
    pair->between = NULL;
  }
}
