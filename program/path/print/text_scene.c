/* SPDX-License-Identifier: MIT */
/* text_scene.c - prints what sepax path has read. */
#include "path/print/text.h"
#include "report/text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void print_bodies(const path_scene *scene) {
  for (size_t n = 0; n < scene->bodies; n++) {
    const path_body *b = &scene->body[n];
    if (b->role != NULL) {
      continue;
    }
    printf("body   %s, ", path_body_name(scene, n));
    report_print_count(b->triangles, "triangle");
    if (b->parts > 1) {
      printf(", %zu parts", b->parts);
    }
    if (b->open > 0) {
      printf(", %zu of %zu parts open: an open part has no inside", b->open, b->parts);
    }
    putchar('\n');
  }
}

/* A row for each tool, with its parts. */
static void print_tools(const path_scene *scene) {
  const nc_turned_tool *last = NULL;
  for (size_t n = 0; n < scene->bodies; n++) {
    const path_body *b = &scene->body[n];
    if (b->role == NULL || strcmp(b->role, "core") == 0) {
      continue;
    }
    if (b->turned != last) {
      printf("%stool   %d, %s, diameter %.6g mm, length %.6g mm: %s", last != NULL ? "\n" : "",
             b->turned->number, nc_tool_kind_name(b->turned->kind), b->turned->diameter,
             b->turned->length, b->role);
    } else {
      printf(", %s", b->role);
    }
    last = b->turned;
  }
  fputs(last != NULL ? "\n" : "", stdout);
}

static bool is_named_before(const path_scene *scene, size_t body, size_t part, const char *file) {
  for (size_t n = 0; n <= body; n++) {
    size_t parts = n < body ? scene->body[n].parts : part;
    for (size_t k = 0; k < parts; k++) {
      const char *other = path_mesh_file(&scene->body[n].part[k]);
      if (other != NULL && strcmp(other, file) == 0) {
        return true;
      }
    }
  }
  return false;
}

/* Print the mesh files about which more is known than the number of triangles. */
static void print_meshes(const path_scene *scene) {
  for (size_t n = 0; n < scene->bodies; n++) {
    for (size_t k = 0; k < scene->body[n].parts; k++) {
      const char *file = path_mesh_file(&scene->body[n].part[k]);
      const report_mesh *mesh = &scene->body[n].part[k].file;
      if (file != NULL && !report_mesh_is_plain(mesh) && !is_named_before(scene, n, k, file)) {
        report_print_mesh("mesh", PATH_WIDTH, file, mesh);
      }
    }
  }
}

/* Print the links without collision geometry, because a user may have given them visual meshes
 * only. */
static void print_empty(const path_scene *scene) {
  enum { NAMES_MOST = 12 };
  size_t empty = 0;
  for (size_t n = 0; n < scene->robot.links; n++) {
    if (!path_has_body(scene, n)) {
      if (empty++ < NAMES_MOST) {
        printf("%s%s", empty == 1 ? "empty  no collision geometry: " : ", ",
               scene->robot.mechanism.link[n].name);
      }
    }
  }
  if (empty > NAMES_MOST) {
    printf(" and %zu more links", empty - NAMES_MOST);
  }
  fputs(empty > 0 ? "\n" : "", stdout);
}

/* Collision elements whose lengths are all 0. */
static void print_nothings(const path_scene *scene) {
  enum { NAMES_MOST = 12 };
  const sepax_robot *robot = &scene->robot;
  for (size_t n = 0; n < robot->nothings && n < NAMES_MOST; n++) {
    const sepax_bare_shape *nothing = &robot->nothing[n];
    printf("%s%s of %s (line %ld)",
           n == 0 ? "zero   all lengths are 0, so there is no surface: " : ", ",
           sepax_shape_kind_name(nothing->kind), robot->mechanism.link[nothing->link].name,
           nothing->line);
  }
  if (robot->nothings > NAMES_MOST) {
    printf(" and %zu more", robot->nothings - NAMES_MOST);
  }
  fputs(robot->nothings > 0 ? "\n" : "", stdout);
}

/* Print the elements that are ignored because they say nothing about collision geometry or belong
 * to other programs. */
static void print_others(const char *file, const sepax_robot_others *others) {
  for (size_t n = 0; n < others->count; n++) {
    const sepax_robot_other *other = &others->entry[n];
    bool element = strchr("='", other->what[strlen(other->what) - 1]) == NULL;
    printf("%s%zu %s%s%s", n == 0 ? "passed over: " : ", ", other->count, element ? "<" : "",
           other->what, element ? ">" : "");
    if (!element) { /* which may be an oversight, so the user is led to it */
      printf(" (line %ld)", other->line);
    }
  }
  if (others->count > 0) {
    printf(" of %s\n", file);
  }
}

static void print_compared(const path_scene *scene, const path_question *q) {
  size_t off = scene->joined + scene->rigid + scene->disabled;
  printf("pairs  %zu of %zu are compared", scene->pairs, scene->pairs + off);
  if (q->srdf != NULL) {
    printf(", %zu are disabled by %s", scene->disabled, q->srdf);
    if (scene->srdf.robot != NULL) {
      printf(", which is for a robot '%.60s'; the URDF's is '%.60s'", scene->srdf.robot,
             scene->robot.name != NULL ? scene->robot.name : "");
    }
  } else {
    printf("; not compared: links of one joint (%zu)", scene->joined);
    if (scene->rigid > 0) {
      printf(", links that no joint moves against each other (%zu)", scene->rigid);
    }
    fputs("; --srdf=FILE chooses the pairs", stdout);
  }
  if (q->table != NULL) {
    printf("; %s lets some of them meet", q->table);
  }
  putchar('\n');
}

/* What the path says of its motions beyond the values of joints. */
static void print_steps(const path_scene *scene) {
  const format_motion *motion = &scene->motion;
  size_t kinds[FORMAT_KINDS] = {0};
  size_t breaks = 0;
  double deviation = 0;
  if (motion->step == NULL) {
    return;
  }
  for (size_t n = 0; n < motion->lines; n++) {
    kinds[motion->step[n].kind]++;
    breaks += n > 0 && path_way_unknown(scene, n);
    deviation = fmax(deviation, motion->step[n].deviation);
  }
  const char *before = "steps  ";
  for (int k = 0; k < FORMAT_KINDS; k++) {
    if (kinds[k] > 0) {
      fputs(before, stdout);
      report_print_count(kinds[k], format_kind_names[k]);
      before = ", ";
    }
  }
  if (breaks > 0) {
    fputs(", ", stdout);
    report_print_count(breaks, "break");
    fputs(" with a way there that is not known and not checked", stdout);
  }
  if (deviation > 0) {
    printf("; deviations of at most %.6g mm", path_mm(deviation));
  }
  putchar('\n');
}

/* What the front end says about the program. */
static void print_notes(const nc_program *p) {
  enum { NOTES_MOST = 10 };
  size_t notes = 0;
  for (size_t n = 0; n < p->records; n++) {
    const nc_record *r = &p->record[n];
    if (r->action == NC_DO_NOTE && notes++ < NOTES_MOST) {
      printf("note   %.200s:%zu: %.300s\n", nc_program_file(p, r->file), r->line, r->text);
    }
  }
  if (notes > NOTES_MOST) {
    printf("       and %zu notes more\n", notes - NOTES_MOST);
  }
}

/* The kinematics of the control, with its parameters in mm. */
static void print_kinematics(const path_scene *scene) {
  const nc_program *p = &scene->nc.program;
  printf("kins  ");
  for (size_t n = 0; n < p->machine_words; n++) {
    printf(" %.60s", p->machine[n]);
  }
  for (size_t n = 0; n < p->parameters; n++) {
    const nc_parameter *of = &p->parameter[n];
    printf("%s %.60s %.9g mm%s", n == 0 ? ":" : ",", of->name, of->value,
           of->follows ? " + tool length" : "");
  }
  if (scene->agreement.link != SIZE_MAX) {
    printf("; the URDF agrees within %.1g mm, by link %.60s", path_mm(scene->agreement.off),
           scene->robot.mechanism.link[scene->agreement.link].name);
    if (fabs(scene->agreement.length) > 1e-6) {
      printf(", for the point %.6g mm below the nose of the spindle",
             path_mm(scene->agreement.length));
    }
  }
  putchar('\n');
}

/* What is taken for granted of an NC program. */
static void print_program(const path_scene *scene, const path_question *q) {
  if (scene->nc.program.parameters > 0) {
    print_kinematics(scene);
  }
  printf("start  %s%s\n",
         q->start != NULL ? "the axes are at "
                          : "the machine is at home when the program starts; --start gives another "
                            "position",
         q->start != NULL ? q->start : "");
  size_t first = 0;
  size_t corners = path_unbounded_corners(scene, &first);
  if (corners > 0) {
    char place[PATH_PLACE];
    printf("blend  %zu motions without a bound of blending (G64 without P), first %s: %s\n",
           corners, path_place(&scene->motion, first, place),
           q->blended ? "the deviations count it"
                      : "the proof is for exact corners (G61); --blended counts the blending");
  }
  print_notes(&scene->nc.program);
  if (q->dogleg) {
    puts("rapids each axis takes its own time; all ways between the ends of a rapid count");
  }
}

static void print_motion(const path_scene *scene, const path_question *q) {
  const format_motion *motion = &scene->motion;
  size_t last = motion->lines - 1;
  printf("path   %s, ", q->motion);
  report_print_count(motion->lines, "pose");
  if (motion->of_program) {
    printf(" in rows 2 ... %zu%s%s", motion->line[last], q->written != NULL ? " of " : "",
           q->written != NULL ? q->written : "");
  } else if (last == 0) {
    printf(", in line %zu of the file", motion->line[0]);
  } else {
    printf(", in lines %zu ... %zu of the file", motion->line[0], motion->line[last]);
  }
  if (motion->time != NULL && last == 0) {
    printf(", %.9g s", motion->time[0]);
  } else if (motion->time != NULL) {
    printf(", %.9g ... %.9g s", motion->time[0], motion->time[last]);
  }
  putchar('\n');
  print_steps(scene);
  if (motion->of_program) {
    print_program(scene, q);
  }
}

void path_print_scene(const path_scene *scene, const path_question *q) {
  print_bodies(scene);
  print_tools(scene);
  print_meshes(scene);
  print_empty(scene);
  print_nothings(scene);
  print_others(q->urdf, &scene->robot.others);
  print_others(q->srdf, &scene->srdf.others);
  print_compared(scene, q);
  print_motion(scene, q);
}
