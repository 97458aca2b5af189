/* SPDX-License-Identifier: MIT */
/* violations.c - the lines of a program whose motions are not free, by pair and kind of motion. */
#include "path/common/parts.h"

#include <stdlib.h>

size_t path_motion_of(const path_scene *scene, const path_pair *pair, size_t line) {
  bool ends = line > 0 && path_motion_asked(scene, pair, line - 1);
  return !ends && path_motion_asked(scene, pair, line) ? line + 1 : line;
}

typedef struct {
  path_violation *list;
  size_t count;
} violations;

/* Add a moment of a pair that is not free. The moments of a pair come in the order of the path. */
static void add(const path_scene *scene, violations *v, const path_pair *pair, path_moment at,
                report_verdict verdict) {
  size_t motion = at.part > 0 ? at.line + 1 : path_motion_of(scene, pair, at.line);
  const format_step *step = &scene->motion.step[motion];
  size_t n = v->count;
  while (n > 0 && v->list[n - 1].pair == pair) {
    path_violation *old = &v->list[--n];
    if (old->kind == step->kind && old->verdict == verdict) {
      const format_step *last = &scene->motion.step[old->last];
      old->motions += last->line != step->line || last->file != step->file;
      old->last = motion;
      return;
    }
  }
  v->list[v->count++] = (path_violation){pair, verdict, step->kind, at, motion, 1, motion};
}

/* The motion that ends in a line, then the line itself. */
static void add_pair(const path_scene *scene, violations *v, const path_pair *pair) {
  for (size_t line = 0; line < scene->motion.lines; line++) {
    path_moment at;
    report_verdict between = line > 0 ? path_motion_verdict(pair, line - 1, &at) : VERDICT_FREE;
    if (between != VERDICT_FREE) {
      add(scene, v, pair, at, between);
    }
    if (pair->verdict[line] != VERDICT_FREE) {
      add(scene, v, pair, (path_moment){line, 0}, (report_verdict)pair->verdict[line]);
    }
  }
}

static int in_order(const void *a, const void *b) {
  const path_violation *p = a;
  const path_violation *q = b;
  if (p->verdict != q->verdict) {
    return report_worse(p->verdict, q->verdict) == p->verdict ? -1 : 1;
  }
  if (p->motion != q->motion) {
    return p->motion < q->motion ? -1 : 1;
  }
  return p->pair < q->pair ? -1 : p->pair > q->pair;
}

path_violation *path_violations(const path_scene *scene, size_t *count) {
  violations v = {calloc(scene->pairs * FORMAT_KINDS * VERDICTS + 1, sizeof *v.list), 0};
  for (size_t n = 0; n < scene->pairs && v.list != NULL && scene->motion.step != NULL; n++) {
    if (path_verdict_of(&scene->pair[n]) != VERDICT_FREE) {
      add_pair(scene, &v, &scene->pair[n]);
    }
  }
  if (v.list != NULL && v.count > 0) {
    qsort(v.list, v.count, sizeof *v.list, in_order);
  }
  *count = v.count;
  return v.list;
}
