/* SPDX-License-Identifier: MIT */
/* tube.c - writes where the joints of a certified program may be: for each motion, the values of
 * the joints at its end, and how far each joint may be off its linear motion there. A guard in the
 * control asks in each period whether the joints are inside. docs/reference/tube.md. */
#include "path/nc/deviation.h"
#include "path/nc/program.h"
#include "util/error.h"
#include "util/write_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char first_line[] = "# sepax tube 1";

/* What the file is made of. */
typedef struct {
  const path_scene *scene;
  const path_question *q;
  double *off;
} tube;

static const char *joint_name(const path_scene *scene, size_t n) {
  return scene->robot.mechanism.joint[n].name;
}

static void write_head(FILE *out, const tube *t) {
  const sepax_mechanism *m = &t->scene->robot.mechanism;
  fprintf(out, "%s; clearance %.17g; metres and radians\ntool,begins", first_line,
          t->q->bands.clearance.length);
  for (size_t n = 0; n < m->joints; n++) {
    if (sepax_joint_driven(&m->joint[n])) {
      fprintf(out, ",%s,%s off", joint_name(t->scene, n), joint_name(t->scene, n));
    }
  }
  fputc('\n', out);
}

static bool write_all(FILE *out, const void *context) {
  const tube *t = context;
  const path_scene *scene = t->scene;
  const sepax_mechanism *m = &scene->robot.mechanism;
  write_head(out, t);
  for (size_t line = 0; line < scene->motion.lines; line++) {
    const size_t tool = scene->motion.step[line].tool;
    const bool begins = line == 0 || !format_motion_goes_on(&scene->motion, line - 1);
    path_joints_off(scene, t->q->blended, line, t->off);
    fprintf(out, "%s,%d", tool != FORMAT_NO_NAME ? scene->motion.name[tool] : "", begins);
    for (size_t n = 0; n < m->joints; n++) {
      if (sepax_joint_driven(&m->joint[n])) {
        fprintf(out, ",%.17g,%.17g", scene->motion.value[line * m->joints + n], t->off[n]);
      }
    }
    fputc('\n', out);
  }
  return ferror(out) == 0;
}

/* A file that is a tube of an earlier run. */
static bool is_tube(const char *path) {
  char text[sizeof first_line] = "";
  FILE *in = fopen(path, "r");
  const bool is = in != NULL && fgets(text, sizeof text, in) != NULL;
  if (in != NULL) {
    fclose(in);
  }
  return is && strcmp(text, first_line) == 0;
}

bool path_tube_is_free(const path_scene *scene) {
  const report_verdict worst = path_worst(scene);
  return worst == VERDICT_FREE || worst == VERDICT_WARNING;
}

bool path_write_tube(path_scene *scene, const path_question *q, sepax_error *error) {
  if (!path_tube_is_free(scene)) {
    scene->tube_removed = is_tube(q->tube) && unlink(q->tube) == 0;
    return !is_tube(q->tube) ||
           sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "%.300s: this tube of an earlier run cannot be removed; remove it yourself",
                      q->tube);
  }
  for (size_t n = 0; n < scene->robot.mechanism.joints; n++) {
    if (strpbrk(joint_name(scene, n), ",\n\"") != NULL) {
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "tube: the name '%.200s' has characters that CSV cannot hold; rename it",
                        joint_name(scene, n));
    }
  }
  tube t = {scene, q, calloc(scene->robot.mechanism.joints + 1, sizeof(double))};
  const bool ok = t.off != NULL ? sepax_write_file(q->tube, write_all, &t, error)
                                : sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for a tube");
  free(t.off);
  return ok;
}
