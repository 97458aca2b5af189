/* SPDX-License-Identifier: MIT */
/* output.c - what sepax check prints and writes. */
#include "check/parts.h"
#include "report/json.h"
#include "report/ply.h"
#include "report/text.h"
#include "report/within.h"
#include "util/error.h"
#include "util/write_file.h"

#include <stdio.h>
#include <stdlib.h>

bool check_any_is_enough(const check_question *q) {
  return q->output.quiet && q->pairs_path == NULL && q->ply_path == NULL;
}

report_verdict check_worst(const check_report *report) {
  report_verdict worst = VERDICT_FREE;
  for (size_t n = 0; n < report->answers; n++) {
    worst = report_worse(worst, report->answer[n].verdict);
  }
  return worst;
}

void check_report_free(check_report *report) {
  for (size_t n = 0; n < report->answers; n++) {
    sepax_pairs_free(&report->answer[n].colliding);
    sepax_pairs_free(&report->answer[n].undecided);
    sepax_pairs_free(&report->answer[n].warned);
  }
  free(report->answer);
  sepax_soup_free(&report->mesh[0]);
  sepax_soup_free(&report->mesh[1]);
}

/* ----------------------------------------------------------------------- text */

enum { WIDTH = 7 };

static void print_surface(const check_question *q, const check_report *report, int i) {
  const check_surface *s = &report->surface[i];
  if (!s->closed) {
    printf("%c is open: an edge of facet %zu belongs to an odd number of facets; %s\n", "AB"[i],
           s -> facet, q -> surfaces ? "its inside is not tested" : "its inside is not defined");
  } else if (!s->consistent) {
    printf(
        "%c winds inconsistently: facet %zu and its neighbour run along their common edge in the "
        "same direction; that matters where a body may be inside %c\n",
        "AB"[i], s -> facet, "AB"[i]);
  }
}

/* Print each reason once, with the first pose that has it. */
static void print_reasons(const check_question *q, const check_report *report) {
  bool said[2][SEPAX_WITHIN_SHEETS + 1] = {{false}};
  for (size_t n = 0; n < report->answers; n++) {
    const check_answer *a = &report->answer[n];
    for (int i = 0; i < 2; i++) {
      const sepax_within_reason why = a->within_asked ? a->why[i] : SEPAX_WITHIN_PLAIN;
      if (why == SEPAX_WITHIN_PLAIN || said[i][why]) {
        continue;
      }
      said[i][why] = true;
      if (q->poses_path != NULL) {
        printf("pose %zu: ", n);
      }
      report_print_within(why, i == 0 ? "A" : "B", i == 0 ? "B" : "A");
      putchar('\n');
    }
  }
}

/* Print whether a part of one body is inside the other. */
static void print_within(const check_answer *a) {
  if (!a->within_asked) {
    return;
  }
  if (a->within[0] == SEPAX_OUTSIDE && a->within[1] == SEPAX_OUTSIDE) {
    fputs(", neither is inside the other", stdout);
    return;
  }
  bool inside = a->within[0] == SEPAX_INSIDE || a->within[1] == SEPAX_INSIDE;
  for (int i = 0; i < 2; i++) {
    char which = "AB"[i];
    char other = "BA"[i];
    if (a->within[i] == SEPAX_INSIDE) {
      printf(", but %c, or a part of it, is inside %c", which, other);
    } else if (a->within[i] == SEPAX_INSIDE_UNKNOWN && !inside) {
      printf(", but %c, or a part of it, may be inside %c", which, other);
    } else if (a->within[i] == SEPAX_OUTSIDE && !inside) {
      printf(", %c is not inside %c", which, other);
    }
  }
}

/* Print what the verdict is about: the files, the changed files, or the grid. */
static void print_basis(const check_question *q, const check_report *report) {
  if (!q->on_grid) {
    bool changed = q->meshes.weld.text != NULL || q->meshes.own.text != NULL || q->nearest;
    fputs(changed ? "(exact for the files as changed by options)"
                  : "(exact for the coordinates in the files)",
          stdout);
    return;
  }
  printf("(%s, on the grid of %s mm)", sepax_arch_name(q->config.arch),
         report_exactly(report->grid.resolution).text);
}

/* Print the bands. The number of pairs in each band is known only if all pairs were searched. */
static void print_bands(const check_question *q, const check_report *report) {
  const check_answer *a = report->answer;
  const size_t pairs = report->triangles[0] * report->triangles[1];
  const size_t count[VERDICTS] = {
      [VERDICT_FREE] = pairs - a->colliding.count - a->warned.count,
      [VERDICT_WARNING] = a->warned.count,
      [VERDICT_COLLISION] = a->colliding.count,
  };
  if (q->bands.clearance.text != NULL) {
    report_print_bands(WIDTH, &q->bands, q->on_grid ? &report->steps : NULL,
                       q->poses_path == NULL && !q->first ? count : NULL);
    putchar('\n');
  }
}

static void print_pairs(const sepax_pairs *pairs, const char *what) {
  for (size_t k = 0; k < pairs->count && pairs->pair != NULL; k++) {
    printf("A[%zu] B[%zu]%s\n", pairs->pair[k][0], pairs->pair[k][1], what);
  }
}

static void print_verdict(const check_question *q, const check_report *report) {
  const check_answer *a = report->answer;
  size_t pairs = report->triangles[0] * report->triangles[1];
  if (q->pairs_path == NULL) {
    print_pairs(&a->colliding, "");
    print_pairs(&a->undecided, " undecided");
  }
  print_bands(q, report);
  printf("%s  %s%zu of %zu pairs collide", report_verdict_titles[a->verdict],
         q->first && a->colliding.count > 0 ? "at least " : "", a->colliding.count, pairs);
  if (a->undecided.count > 0) {
    printf(", %zu are undecided", a->undecided.count);
  }
  if (a->verdict == VERDICT_WARNING) {
    printf(", %s%zu get a warning", q->first ? "at least " : "", a->warned.count);
  }
  print_within(a);
}

static void print_pose(const check_question *q, const check_report *report, size_t n) {
  const check_answer *a = &report->answer[n];
  printf("%6zu  %-9s  ", n, report_verdict_titles[a->verdict]);
  const sepax_pairs *shown = a->colliding.count > 0 ? &a->colliding : &a->warned;
  if (q->first && shown->count > 0) {
    printf("A[%zu] B[%zu]", shown->pair[0][0], shown->pair[0][1]);
  } else {
    printf("%zu", a->colliding.count);
  }
  if (!q->first && q->bands.warning.text != NULL) {
    printf("  %zu get a warning", a->warned.count);
  }
  for (int i = 0; i < 2; i++) {
    if (a->within_asked && a->within[i] != SEPAX_OUTSIDE) {
      printf("  %c %sin %c", "AB"[i], a -> within[i] == SEPAX_INSIDE_UNKNOWN ? "perhaps " : "",
             "BA"[i]);
    }
  }
  putchar('\n');
}

static void print_poses(const check_question *q, const check_report *report) {
  report_verdict worst = check_worst(report);
  size_t such = 0;
  print_bands(q, report);
  if (q->nearest) {
    printf("poses  nearest rotations; an entry of a matrix changed by at most %.3g\n",
           report->moved);
  }
  for (size_t n = 0; n < report->answers; n++) {
    such += report->answer[n].verdict == worst;
    print_pose(q, report, n);
  }
  printf("%s  in %zu of %zu poses", report_verdict_titles[worst], such, report->answers);
}

void check_print_text(const check_question *q, const check_report *report) {
  report_print_mesh("A", WIDTH, q->path[0], &report->file[0]);
  report_print_mesh("B", WIDTH, q->path[1], &report->file[1]);
  if (q->on_grid) {
    report_print_grid(WIDTH, &report->grid);
  } else {
    print_surface(q, report, 0);
    print_surface(q, report, 1);
    print_reasons(q, report);
  }
  (q->poses_path != NULL ? print_poses : print_verdict)(q, report);
  putchar(' ');
  print_basis(q, report);
  printf(", %.3f s\n", report->seconds);
}

/* ----------------------------------------------------------------------- JSON */

static json_t *pairs_as_json(const sepax_pairs *pairs) {
  json_t *list = json_array();
  for (size_t k = 0; k < pairs->count && pairs->pair != NULL; k++) {
    json_array_append_new(
        list, json_pack("[I, I]", (json_int_t)pairs->pair[k][0], (json_int_t)pairs->pair[k][1]));
  }
  return list;
}

static void set_within(json_t *to, const char *name, const check_answer *a, int i) {
  sepax_inside within = a->within[i];
  bool known = a->within_asked && within != SEPAX_INSIDE_UNKNOWN;
  json_object_set_new(to, name, known ? json_boolean(within == SEPAX_INSIDE) : json_null());
  if (a->within_asked && a->why[i] != SEPAX_WITHIN_PLAIN) {
    char reason[32];
    snprintf(reason, sizeof reason, "%s_reason", name);
    json_object_set_new(to, reason, json_string(report_within_name(a->why[i])));
  }
}

static json_t *answer_as_json(const check_question *q, const check_report *report,
                              const check_answer *a) {
  json_t *json = json_object();
  if (q->poses_path != NULL) {
    report_set_count(json, "pose", (size_t)(a - report->answer));
  }
  json_object_set_new(json, "verdict", json_string(report_verdict_names[a->verdict]));
  report_set_count(json, "collisions", a->colliding.count);
  if (!q->on_grid) {
    set_within(json, "a_inside_b", a, 0);
    set_within(json, "b_inside_a", a, 1);
  }
  if (q->bands.clearance.text != NULL && !q->first) {
    size_t pairs = report->triangles[0] * report->triangles[1];
    report_set_count(json, "free", pairs - a->colliding.count - a->warned.count);
  }
  if (q->bands.clearance.text != NULL) {
    report_set_count(json, "warnings", a->warned.count);
  }
  if (a->colliding.pair != NULL || q->poses_path == NULL) {
    json_object_set_new(json, "colliding", pairs_as_json(&a->colliding));
  }
  if (q->bands.warning.text != NULL && (a->warned.pair != NULL || q->poses_path == NULL)) {
    json_object_set_new(json, "warned", pairs_as_json(&a->warned));
  }
  if (q->on_grid) {
    json_object_set_new(json, "undecided", pairs_as_json(&a->undecided));
  }
  return json;
}

static void set_surface(json_t *body, const check_surface *s) {
  json_object_set_new(body, "closed", json_boolean(s->closed));
  json_object_set_new(body, "consistent", json_boolean(s->consistent));
  if (!s->closed || !s->consistent) {
    report_set_count(body, "facet", s->facet);
  }
}

void check_print_json(const check_question *q, const check_report *r) {
  json_t *json = report_scene(q->path, r->triangles, &r->grid);
  json_object_set_new(json, "basis", json_string(q->on_grid ? "grid" : "files"));
  if (q->on_grid) {
    json_object_set_new(json, "arch", json_string(sepax_arch_name(q->config.arch)));
  } else {
    json_object_del(json, "grid");
    set_surface(json_object_get(json, "a"), &r->surface[0]);
    set_surface(json_object_get(json, "b"), &r->surface[1]);
  }
  report_set_mesh(json_object_get(json, "a"), &r->file[0]);
  report_set_mesh(json_object_get(json, "b"), &r->file[1]);
  report_set_bands(json, &q->bands, q->on_grid ? &r->steps : NULL);
  report_set_count(json, "pairs", r->triangles[0] * r->triangles[1]);
  json_object_set_new(json, "seconds", json_real(r->seconds));
  if (q->poses_path == NULL) {
    json_t *answer = answer_as_json(q, r, r->answer);
    json_object_update(json, answer);
    json_decref(answer);
  } else {
    json_t *poses = json_array();
    for (size_t n = 0; n < r->answers; n++) {
      json_array_append_new(poses, answer_as_json(q, r, &r->answer[n]));
    }
    json_object_set_new(json, "verdict", json_string(report_verdict_names[check_worst(r)]));
    json_object_set_new(json, "poses", poses);
    json_object_set_new(json, "nearest_rotation", q->nearest ? json_real(r->moved) : json_null());
  }
  report_print_json(json);
}

/* ---------------------------------------------------------------------- files */

typedef struct {
  const check_question *q;
  const check_report *report;
} table;

static bool write_csv(FILE *out, const void *context) {
  const table *t = context;
  bool posed = t->q->poses_path != NULL;
  bool ok = fputs(posed ? "pose,a,b\n" : "a,b\n", out) != EOF;
  for (size_t n = 0; n < t->report->answers && ok; n++) {
    const sepax_pairs *pairs = &t->report->answer[n].colliding;
    for (size_t k = 0; k < pairs->count && ok; k++) {
      ok = (!posed || fprintf(out, "%zu,", n) > 0) &&
           fprintf(out, "%zu,%zu\n", pairs->pair[k][0], pairs->pair[k][1]) > 0;
    }
  }
  return ok;
}

static bool print_ply_comments(FILE *out, const void *context) {
  (void)context;
  return fputs("comment sepax check: mm; triangles of A that collide are red, of B orange\n",
               out) != EOF;
}

static bool write_ply(const check_question *q, const check_report *report, sepax_error *error) {
  report_ply_body body[2] = {
      {.colour = {170, 190, 215}, .marked_colour = {215, 40, 40}},
      {.colour = {200, 200, 190}, .marked_colour = {240, 150, 30}},
  };
  bool *marked[2] = {NULL, NULL};
  bool ok = true;
  for (int i = 0; i < 2; i++) {
    marked[i] = calloc(report->mesh[i].count + 1, sizeof *marked[i]);
    body[i].mesh = &report->mesh[i];
    body[i].marked = marked[i];
    ok = ok && marked[i] != NULL;
  }
  const sepax_pairs *pairs = &report->answer->colliding;
  for (size_t n = 0; n < pairs->count && ok; n++) {
    marked[0][pairs->pair[n][0]] = true;
    marked[1][pairs->pair[n][1]] = true;
  }
  const report_ply ply = {.body = body, .bodies = 2, .print_comments = print_ply_comments};
  ok = ok ? report_ply_write(&ply, q->ply_path, error)
          : sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for the colours of %zu triangles",
                       report->mesh[0].count + report->mesh[1].count);
  free(marked[0]);
  free(marked[1]);
  return ok;
}

bool check_write_files(const check_question *q, const check_report *report, sepax_error *error) {
  const table t = {q, report};
  return (q->pairs_path == NULL || sepax_write_file(q->pairs_path, write_csv, &t, error)) &&
         (q->ply_path == NULL || write_ply(q, report, error));
}
