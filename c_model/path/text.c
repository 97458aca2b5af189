/* text.c - what sepax path prints for people. */
#include "path/parts.h"

#include <math.h>
#include <string.h>

const char *const path_names[PATH_VERDICTS] = {"FREE", "WARNING", "UNDECIDED", "COLLISION"};

/* "line 17 (0.1 s)" */
static void print_line(const path_scene *scene, size_t line) {
  printf("line %zu", scene->motion.line[line]);
  if (scene->motion.time != NULL) {
    printf(" (%.9g s)", scene->motion.time[line]);
  }
}

static void print_point(const double v[3]) {
  printf("%.6g %.6g %.6g", 1e3 * v[0], 1e3 * v[1], 1e3 * v[2]);
}

static void print_least(const path_scene *scene, const path_pair *pair) {
  if (pair->least_line == PATH_NO_LINE) {
    return;
  }
  if (pair->least == 0) {
    fputs(pair->inside ? "; one has the other, or a part of it, inside" : "", stdout);
    return;
  }
  double point[2][3];
  path_points(scene, pair, point);
  printf("; least clearance %.6g mm in ", 1e3 * pair->least);
  print_line(scene, pair->least_line);
  fputs(", from ", stdout);
  print_point(point[0]);
  fputs(" to ", stdout);
  print_point(point[1]);
}

static void print_pair(const path_scene *scene, const path_pair *pair, int width) {
  path_verdict verdict = path_verdict_of(pair);
  char names[2 * 64 + 4];
  snprintf(names, sizeof names, "%.60s, %.60s", path_body_name(scene, pair->body[0]),
           path_body_name(scene, pair->body[1]));
  printf("%-9s  %-*s", path_names[verdict], width, names);
  const char *before = "  ";
  for (int v = PATH_COLLISION; v > PATH_FREE; v--) {
    static const char *const what[] = {"", "a warning", "undecided", "collide"};
    if (pair->lines[v] > 0) {
      printf("%s%s in %zu line%s, first in ", before, what[v], pair->lines[v],
             pair->lines[v] == 1 ? "" : "s");
      print_line(scene, pair->first[v]);
      before = "; ";
    }
  }
  fputs(verdict == PATH_FREE ? "  free in all lines" : "", stdout);
  print_least(scene, pair);
  putchar('\n');
}

static void print_bodies(const path_scene *scene) {
  for (size_t n = 0; n < scene->bodies; n++) {
    const path_body *b = &scene->body[n];
    printf("body   %s, %zu triangles", path_body_name(scene, n), b->triangles);
    if (b->parts > 1) {
      printf(", %zu parts", b->parts);
    }
    if (b->open > 0) {
      printf(", %zu of %zu parts open: the inside of these is not defined", b->open, b->parts);
    }
    putchar('\n');
  }
}

/* Misspelt elements, or meshes for the eye alone, would else go unseen. */
static void print_empty(const path_scene *scene) {
  enum { NAMES_MOST = 12 };
  const sepax_mechanism *m = &scene->robot.mechanism;
  size_t body = 0;
  size_t empty = 0;
  for (size_t n = 0; n < m->links; n++) {
    while (body < scene->bodies && scene->body[body].link < n) {
      body++;
    }
    if (body == scene->bodies || scene->body[body].link != n) {
      if (empty++ < NAMES_MOST) {
        printf("%s%s", empty == 1 ? "empty  no collision geometry: " : ", ", m->link[n].name);
      }
    }
  }
  if (empty > NAMES_MOST) {
    printf(" and %zu more links", empty - NAMES_MOST);
  }
  fputs(empty > 0 ? "\n" : "", stdout);
}

static void print_compared(const path_scene *scene, const path_question *q) {
  size_t off = scene->joined + scene->disabled;
  printf("pairs  %zu of %zu are compared", scene->pairs, scene->pairs + off);
  if (q->srdf != NULL) {
    printf(", %zu are disabled by %s", scene->disabled, q->srdf);
    if (scene->srdf_robot != NULL) {
      printf(", which is for a robot '%.60s'; the URDF's is '%.60s'", scene->srdf_robot,
             scene->robot.name != NULL ? scene->robot.name : "");
    }
  } else {
    printf("; %zu are not: links of one joint (--srdf=FILE says which)", scene->joined);
  }
  putchar('\n');
}

static void print_motion(const path_scene *scene, const path_question *q) {
  const format_motion *motion = &scene->motion;
  size_t last = motion->lines - 1;
  printf("path   %s, %zu pose%s, in lines %zu ... %zu of the file", q->motion, motion->lines,
         motion->lines == 1 ? "" : "s", motion->line[0], motion->line[last]);
  if (motion->time != NULL) {
    printf(", %.9g ... %.9g s", motion->time[0], motion->time[last]);
  }
  putchar('\n');
}

static void print_limits(const path_question *q) {
  if (q->clearance.text != NULL) {
    printf("bands  collision up to %.9g mm", 1e3 * q->clearance.length);
    if (q->warning.text != NULL) {
      printf(", warning up to %.9g mm", 1e3 * q->warning.length);
    }
    putchar('\n');
  }
}

/* "between lines 17 and 18 (0.1 ... 0.2 s), free to 0.25 of the way; collides at 0.5" */
static void print_open(const path_scene *scene, const path_pair *pair, int width) {
  const path_proof *proof = &pair->proof;
  const format_motion *motion = &scene->motion;
  size_t n = proof->open.segment;
  char names[2 * 64 + 4];
  double ends[2];
  snprintf(names, sizeof names, "%.60s, %.60s", path_body_name(scene, pair->body[0]),
           path_body_name(scene, pair->body[1]));
  path_open_ends(pair, ends);
  bool collides = isfinite(proof->collides);
  printf("%-9s  %-*s  between lines %zu and %zu",
         path_names[collides ? PATH_COLLISION : PATH_UNDECIDED], width, names, motion->line[n],
         motion->line[n + 1]);
  if (motion->time != NULL) {
    printf(" (%.9g ... %.9g s)", motion->time[n], motion->time[n + 1]);
  }
  printf(", free to %.9g of the way; ", ends[0] - (double)n);
  if (collides) {
    printf("collides at %.9g\n", proof->collides);
  } else {
    printf("open to %.9g, %.6g mm in its middle\n", ends[1] - (double)n, 1e3 * proof->distance);
  }
}

static void print_between(const path_scene *scene, const path_question *q, int width) {
  size_t intervals = 0;
  size_t by_axis = 0;
  if (!scene->between) {
    puts("between  not asked: there is no verdict of free in all lines");
    return;
  }
  for (size_t n = 0; n < scene->pairs; n++) {
    const path_proof *proof = &scene->pair[n].proof;
    intervals += proof->count;
    for (size_t k = 0; k < proof->count; k++) {
      by_axis += proof->interval[k].by_axis;
    }
  }
  const path_pair *open = path_open(scene);
  if (open != NULL) {
    print_open(scene, open, width);
  }
  printf("%s  %zu intervals, %zu of them by an axis", open == NULL ? "CERTIFIED" : "certified",
         intervals, by_axis);
  if (open != NULL) {
    printf(", to there; the resolution is %.6g mm", 1e3 * q->resolution.length);
  }
  printf(", %.3f s\n", scene->between_seconds);
}

static void print_jobs(const path_scene *scene, const path_question *q) {
  const path_jobs *jobs = &scene->jobs;
  char text[SEPAX_CONFIG_TEXT];
  printf("jobs   %s, %zu jobs of %zu poses, %zu trees, %zu bytes; LSB %.9g um, clearance %d LSB",
         q->jobs, scene->pairs, scene->motion.lines, jobs->bodies, jobs->bytes,
         1e6 * jobs->resolution, jobs->config.clearance);
  if (jobs->config.warning > 0) {
    printf(", warning %d LSB", jobs->config.warning);
  }
  printf("\nsepax gen %s -o DIR\n", sepax_config_text(&jobs->config, text, sizeof text));
}

void path_print_text(const path_scene *scene, const path_question *q) {
  path_verdict worst = path_worst(scene);
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
  print_empty(scene);
  print_compared(scene, q);
  print_motion(scene, q);
  print_limits(q);
  if (q->jobs != NULL) {
    print_jobs(scene, q);
  }
  for (size_t n = 0; n < scene->pairs; n++) {
    print_pair(scene, &scene->pair[n], width < 40 ? width : 40);
  }
  if (q->certify) {
    print_between(scene, q, width < 40 ? width : 40);
  }
  bool in_lines = path_open(scene) == NULL;
  printf("%s", path_names[worst]);
  if (in_lines) {
    printf("  %zu of %zu pairs", such, scene->pairs);
  }
  if (worst != PATH_FREE) {
    fputs(in_lines ? ", first in " : "  behind ", stdout);
    print_line(scene, path_worst_line(scene));
  }
  printf(" (%s), %.3f s\n",
         path_certified(scene) ? "in the lines of the path and, to the clearance, between them"
         : in_lines            ? "in the lines of the path, not between them"
                               : "no line of the path tells",
         scene->seconds + scene->between_seconds);
}
