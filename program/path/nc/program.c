/* SPDX-License-Identifier: MIT */
/* program.c - the path of an NC program: the joints of the control become those of the URDF, and
 * their deviations become lengths. */
#include "path/nc/program.h"
#include "nc/process.h"
#include "util/error.h"
#include "util/memory.h"
#include "util/write_file.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ------------------------------------------------------------------------- joints */

static bool is_letter(const char *name, char letter) {
  return toupper((unsigned char)name[0]) == letter && name[1] == '\0';
}

/* The name of the URDF's joint for an axis: that of --axis, else the letter. */
static const char *name_of(const path_question *q, char letter) {
  for (size_t n = 0; n < q->axes; n++) {
    if (q->axis[n].letter == letter) {
      return q->axis[n].joint;
    }
  }
  return NULL;
}

static size_t joint_of(const path_scene *scene, const path_question *q, char letter) {
  const sepax_mechanism *m = &scene->robot.mechanism;
  const char *name = name_of(q, letter);
  size_t n = 0;
  while (n < m->joints && !(name != NULL ? strcmp(m->joint[n].name, name) == 0
                                         : is_letter(m->joint[n].name, letter))) {
    n++;
  }
  return n;
}

/* Does a joint of the control ever leave its first value? */
static bool moves(const nc_motion *nc, size_t joint) {
  for (size_t n = 1; n < nc->rows; n++) {
    if (nc->value[n * nc->joints + joint] != nc->value[joint]) {
      return true;
    }
  }
  return false;
}

static bool match_joint(path_scene *scene, const path_question *q, size_t number,
                        sepax_error *error) {
  const sepax_mechanism *m = &scene->robot.mechanism;
  const nc_joint *joint = &scene->nc.program.joint[number];
  char letter = nc_letter(joint->axis);
  size_t to = joint_of(scene, q, letter);
  scene->joint_of[number] = to;
  if (to == m->joints) {
    scene->joint_of[number] = SEPAX_NO_JOINT;
    return !moves(&scene->nc, number) ||
           sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "%.200s: the program moves the axis %c, and no joint of %.200s is for it; "
                      "give --axis=%c:JOINT",
                      q->motion, letter, q->urdf, letter);
  }
  bool slides = m->joint[to].kind == SEPAX_JOINT_PRISMATIC;
  if (!sepax_joint_driven(&m->joint[to]) || slides == joint->angular) {
    return sepax_fail(
        error, SEPAX_ERROR_ARGUMENT,
        "%.200s: joint %.60s cannot be the axis %c, which is %s; give --axis=%c:JOINT", q->urdf,
        m->joint[to].name, letter, joint->angular ? "angular" : "linear", letter);
  }
  return true;
}

/* Each joint of the URDF that has a value of its own needs an axis. */
static bool all_matched(const path_scene *scene, const path_question *q, sepax_error *error) {
  const sepax_mechanism *m = &scene->robot.mechanism;
  for (size_t n = 0; n < m->joints && !q->rules.hold; n++) {
    size_t k = 0;
    while (k < scene->nc.joints && scene->joint_of[k] != n) {
      k++;
    }
    if (sepax_joint_driven(&m->joint[n]) && k == scene->nc.joints) {
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "%.200s: no axis of %.200s moves joint %.60s; give --axis=LETTER:%.60s, or "
                        "--hold, which keeps such joints at 0",
                        q->urdf, q->machine, m->joint[n].name, m->joint[n].name);
    }
  }
  return true;
}

/* --------------------------------------------------------------------------- rows */

static bool add_name(path_scene *scene, const char *text, size_t *number) {
  format_motion *to = &scene->motion;
  *number = 0;
  while (*number < to->names && strcmp(to->name[*number], text) != 0) {
    ++*number;
  }
  if (*number < to->names) {
    return true;
  }
  size_t length = strlen(text) + 1;
  char **grown = sepax_resize(to->name, (to->names + 1) * sizeof *grown);
  to->name = grown != NULL ? grown : to->name;
  char *copy = grown != NULL ? sepax_allocate(length) : NULL;
  if (copy != NULL) {
    memcpy(copy, text, length);
    to->name[to->names++] = copy;
  }
  return copy != NULL;
}

static bool fill_step(path_scene *scene, const path_question *q, const nc_row *row,
                      format_step *step) {
  static const format_kind kinds[] = {[NC_RAPID] = FORMAT_RAPID,
                                      [NC_FEED] = FORMAT_FEED,
                                      [NC_PROBE] = FORMAT_PROBE,
                                      [NC_DWELL] = FORMAT_DWELL};
  char tool[16];
  *step = (format_step){.kind = kinds[row->kind],
                        .breaks = row->begins == NC_PROBED || row->begins == NC_DISPLACED,
                        .file = FORMAT_NO_NAME,
                        .tool = FORMAT_NO_NAME,
                        .line = row->line};
  int number = row->tool < 0 ? q->loaded : row->tool;
  snprintf(tool, sizeof tool, "%d", number);
  return (row->file < 0 ||
          add_name(scene, nc_program_file(&scene->nc.program, row->file), &step->file)) &&
         (number <= 0 || add_name(scene, tool, &step->tool));
}

static bool within_limits(const path_scene *scene, const path_question *q, size_t row,
                          sepax_error *error) {
  const sepax_mechanism *m = &scene->robot.mechanism;
  const format_motion *motion = &scene->motion;
  for (size_t n = 0; n < m->joints; n++) {
    const sepax_joint *joint = &m->joint[n];
    double value = motion->value[row * motion->joints + n];
    double slack = 1e-9;
    if (joint->kind == SEPAX_JOINT_FIXED ||
        (value >= joint->lower - slack && value <= joint->upper + slack)) {
      continue;
    }
    char place[PATH_PLACE];
    bool angular = joint->kind != SEPAX_JOINT_PRISMATIC;
    double unit = angular ? 180 / 0x1.921fb54442d18p1 : 1e3;
    return sepax_fail(error, SEPAX_ERROR_FORMAT,
                      "%.200s: joint %.60s: %.9g %s is beyond its limits in %.120s, %.9g ... %.9g; "
                      "mend the program or the URDF, or give --ignore-limits",
                      path_place(motion, row, place), joint->name, value * unit,
                      angular ? "deg" : "mm", q->urdf, joint->lower * unit, joint->upper * unit);
  }
  return true;
}

/* Allocate `rows` lines of the path. */
static bool make_lines(path_scene *scene, size_t rows, sepax_error *error) {
  format_motion *to = &scene->motion;
  *to = (format_motion){.joints = scene->robot.mechanism.joints, .of_program = true};
  to->value = sepax__zeroed(rows * (to->joints + 1), sizeof *to->value);
  to->line = sepax__zeroed(rows, sizeof *to->line);
  to->step = sepax__zeroed(rows, sizeof *to->step);
  scene->row_of = sepax__zeroed(rows, sizeof *scene->row_of);
  return (to->value != NULL && to->line != NULL && to->step != NULL && scene->row_of != NULL) ||
         sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu lines of a path", rows);
}

/* A row within a dog-leg is left out: the joints may take any way between its ends. */
static bool is_within_dogleg(const nc_row *row) { return row->dogleg && row->share < 1; }

static bool fill_lines(path_scene *scene, const path_question *q, sepax_error *error) {
  const nc_motion *nc = &scene->nc;
  format_motion *to = &scene->motion;
  for (size_t n = 0; n < nc->rows; n++) {
    bool begins = nc->row[n].begins != NC_GOES_ON;
    if (is_within_dogleg(&nc->row[n]) && !begins) {
      continue;
    }
    size_t line = to->lines++;
    double *value = &to->value[line * to->joints];
    scene->row_of[line] = n;
    to->line[line] = line + 2; /* of the motion file */
    for (size_t k = 0; k < nc->joints; k++) {
      if (scene->joint_of[k] != SEPAX_NO_JOINT) {
        value[scene->joint_of[k]] = nc->value[n * nc->joints + k];
      }
    }
    sepax_mechanism_follow(&scene->robot.mechanism, value);
    if (!fill_step(scene, q, &nc->row[n], &to->step[line])) {
      return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for the names of a path");
    }
    if (!q->rules.ignore_limits && !within_limits(scene, q, line, error)) {
      return false;
    }
  }
  return true;
}

/* ---------------------------------------------------------------------- front end */

/* For the rules, where 0 stands for the default, and a number below 0 for none. */
static double smoothing_of(const path_question *q, double times) {
  double length = q->smoothing.length * times;
  return q->smoothing.text == NULL ? 0 : length > 0 ? length : -1;
}

static bool run(path_scene *scene, const path_question *q, sepax_error *error) {
  char table[4096];
  char start[512];
  char control[PATH_CONTROLS_MOST][256];
  const char *words[PATH_CONTROLS_MOST + 5] = {q->machine, q->motion};
  int count = 2;
  nc_process p;
  nc_rules rules = {.linear = q->deviation.length,
                    .angular = q->deviation.length,
                    .servo_linear = smoothing_of(q, 1),
                    .servo_angular = smoothing_of(q, 10),
                    .dogleg = q->dogleg,
                    .ignore_limits = q->rules.ignore_limits};
  if (q->tool_table != NULL) {
    snprintf(table, sizeof table, "--tool-table=%s", q->tool_table);
    words[count++] = table;
  }
  if (q->start != NULL) {
    snprintf(start, sizeof start, "--start=%s", q->start);
    words[count++] = start;
  }
  for (size_t n = 0; n < q->controls; n++) {
    snprintf(control[n], sizeof control[n], "--control=%s", q->control[n]);
    words[count++] = control[n];
  }
  if (!nc_process_start(&p, path_linuxcnc, words, error)) {
    return false;
  }
  sepax_error of_reader = {0};
  sepax_error of_process = {0};
  bool failed = false;
  bool read = nc_motion_read(&scene->nc, p.out, q->motion, &rules, &of_reader);
  bool ended = nc_process_end(&p, &failed, &of_process);
  if (read && ended) {
    return true;
  }
  *error = failed || read ? of_process : of_reader;
  return false;
}

bool path_program_read(path_scene *scene, const path_question *q, sepax_error *error) {
  if (!run(scene, q, error)) {
    return false;
  }
  for (size_t n = 0; n < scene->nc.joints; n++) {
    if (!match_joint(scene, q, n, error)) {
      return false;
    }
  }
  if (q->tools != NULL && q->loaded < 0 && scene->nc.row[0].tool < 0) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "%.200s: moves before it loads a tool; give --loaded=NUMBER, the tool in the "
                      "spindle, or --loaded=0, if there is none",
                      q->motion);
  }
  return all_matched(scene, q, error) && make_lines(scene, scene->nc.rows, error) &&
         fill_lines(scene, q, error);
}

bool path_way_unknown(const path_scene *scene, size_t line) {
  return scene->motion.step[line].breaks &&
         (scene->row_of == NULL || scene->nc.row[scene->row_of[line]].begins != NC_GOES_ON);
}

size_t path_unbounded_corners(const path_scene *scene, size_t *first) {
  const nc_motion *nc = &scene->nc;
  size_t count = 0;
  for (size_t n = 1; n < scene->motion.lines; n++) {
    const nc_row *row = &nc->row[scene->row_of[n]];
    bool again = scene->row_of[n] == scene->row_of[n - 1]; /* of a dog-leg */
    if (row->blend == NC_UNBOUNDED && row->share == 1 && row->kind != NC_DWELL && !again) {
      *first = count++ == 0 ? n : *first;
    }
  }
  return count;
}

/* ------------------------------------------------------------------- motion file */

static bool write_head(FILE *out, const path_scene *scene) {
  const sepax_mechanism *m = &scene->robot.mechanism;
  for (size_t n = 0; n < m->joints; n++) {
    if (sepax_joint_driven(&m->joint[n])) {
      fprintf(out, "%s,", m->joint[n].name);
    }
  }
  return fputs("file,line,kind,tool,break,deviation\n", out) != EOF;
}

static bool write_rows(FILE *out, const void *context) {
  const path_scene *scene = context;
  const sepax_mechanism *m = &scene->robot.mechanism;
  const format_motion *motion = &scene->motion;
  bool ok = write_head(out, scene);
  for (size_t n = 0; n < motion->lines && ok; n++) {
    const format_step *step = &motion->step[n];
    for (size_t j = 0; j < m->joints; j++) {
      if (sepax_joint_driven(&m->joint[j])) {
        fprintf(out, "%.17g,", motion->value[n * motion->joints + j]);
      }
    }
    ok = fprintf(out, "%s,%zu,%s,%s,%d,%.17g\n",
                 step->file != FORMAT_NO_NAME ? motion->name[step->file] : "", step->line,
                 format_kind_names[step->kind],
                 step->tool != FORMAT_NO_NAME ? motion->name[step->tool] : "", step->breaks,
                 step->deviation) > 0;
  }
  return ok;
}

/* A name that a cell of the motion file cannot hold; NULL: none. */
static const char *name_without_cell(const path_scene *scene) {
  const sepax_mechanism *m = &scene->robot.mechanism;
  for (size_t n = 0; n < m->joints; n++) {
    if (strpbrk(m->joint[n].name, ",\n\"[") != NULL) {
      return m->joint[n].name;
    }
  }
  for (size_t n = 0; n < scene->motion.names; n++) {
    if (strpbrk(scene->motion.name[n], ",\n\r") != NULL) {
      return scene->motion.name[n];
    }
  }
  return NULL;
}

const char *path_motion_file(const path_question *q) {
  return q->written != NULL ? q->written : q->motion;
}

bool path_program_write(path_scene *scene, const char *path, sepax_error *error) {
  const char *name = name_without_cell(scene);
  if (name != NULL) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "motion: the name '%.200s' has characters that CSV cannot hold; rename it",
                      name);
  }
  scene->motion.columns = 6;
  for (size_t n = 0; n < scene->robot.mechanism.joints; n++) {
    scene->motion.columns += sepax_joint_driven(&scene->robot.mechanism.joint[n]);
  }
  return sepax_write_file(path, write_rows, scene, error);
}
