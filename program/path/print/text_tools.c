/* SPDX-License-Identifier: MIT */
/* text_tools.c - prints what sepax path found about tools, stock and the lines of a program. */
#include "path/print/text.h"
#include "report/text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool path_is_core(const path_scene *scene, const path_pair *pair) {
  const char *role = scene->body[pair->body[0]].role;
  return role != NULL && strcmp(role, "core") == 0;
}

/* A pair that the stock as it is cut decides. */
void path_print_stock_pair(const path_scene *scene, const path_pair *pair) {
  nc_tool_part part = scene->body[pair->body[0]].turned_part;
  const path_stock *s = &scene->stock;
  const char *before = "  ";
  for (int v = VERDICT_COLLISION; v > VERDICT_WARNING; v--) {
    if (pair->lines[v] > 0) {
      printf("%s%s in ", before,
             v == VERDICT_COLLISION ? "meets material" : "touches what is left");
      report_print_count(pair->lines[v], "motion");
      fputs(", first in ", stdout);
      path_print_line(scene, NULL, pair->first[v]);
      before = "; ";
    }
  }
  if (path_in_lines(pair) == VERDICT_FREE) {
    fputs("  ", stdout);
    if (pair->tool != FORMAT_NO_NAME) {
      printf("with tool %.60s ", scene->motion.name[pair->tool]);
    }
    if (part == NC_HOLDER || pair->of_left) {
      fputs("free of what is left", stdout);
    } else {
      printf("no deeper than %.6g mm in what is left%s", path_mm(s->depth),
             part == NC_FLUTES ? ", except where it cuts" : "");
    }
  } else if (isfinite(pair->deepest[1])) {
    printf("; no deeper than %.4g mm, in ", path_mm(pair->deepest[1]));
    path_print_line(scene, NULL, pair->deepest_line);
  }
  putchar('\n');
}

void path_print_stock(const path_scene *scene) {
  const path_stock *s = &scene->stock;
  printf("stock  %s, cut in cells of %.6g mm; %.6g cm3 are left at most; %zu KB, %.3f s\n",
         path_body_name(scene, s->body), path_mm(s->cell),
         (double)s->cells * s->cell * s->cell * s->cell * 1e6, s->bytes / 1000, s->seconds);
}

void path_print_feeds(const path_scene *scene) {
  for (size_t n = 0; n < scene->motion.names; n++) {
    const path_feeds *f = &scene->stock.feeds[n];
    if (f->still > 0) {
      printf("note   tool %.60s feeds with the spindle off in ", scene->motion.name[n]);
      report_print_count(f->still, "motion");
      fputs(", first in ", stdout);
      path_print_line(scene, NULL, f->first_still);
      puts(": it cuts nothing there");
    }
    if (f->feeds > f->still && !f->touches) {
      printf("note   tool %.60s touches nothing of the stock in ", scene->motion.name[n]);
      report_print_count(f->feeds - f->still, "feed");
      puts(": are its length and the work offset right?");
    }
  }
}

/* By the lines of the program, the worst first. */
void path_print_violations(const path_scene *scene) {
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
bool path_is_in_summary(const path_scene *scene, const path_pair *pair) {
  return pair->tool != FORMAT_NO_NAME && !pair->by_cells && !path_is_core(scene, pair) &&
         path_verdict_of(pair) == VERDICT_FREE;
}

/* The row of the free pairs of a tool, with the least clearance of them. */
void path_print_tool(const path_scene *scene, size_t tool, int width) {
  const path_pair *least = NULL;
  size_t count = 0;
  bool certified = true;
  for (size_t n = 0; n < scene->pairs; n++) {
    const path_pair *pair = &scene->pair[n];
    if (pair->tool == tool && path_is_in_summary(scene, pair)) {
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
    path_print_least(scene, least);
  }
  putchar('\n');
}
