/* SPDX-License-Identifier: MIT */
#include "checker.h"

#include "../../program/certificate_checker/inside.h"
#include "../../program/certificate_checker/report.h"

#include <stdlib.h>

struct checker_body {
  surface surface;
  surface_part element;
  shell shell;
};

checker_body *checker_open(const double (*corner)[3][3], size_t count) {
  checker_body *c = memory(NULL, 1, sizeof *c);
  c->element = (surface_part){0, false};
  c->surface = (surface){.triangle = memory(NULL, count, sizeof(triangle)),
                         .count = count,
                         .element = &c->element,
                         .elements = 1};
  for (size_t n = 0; n < 3 * count; n++) {
    const double *v = corner[n / 3][n % 3];
    c->surface.triangle[n / 3].at[n % 3] = (vec){v[0], v[1], v[2]};
  }
  surface_finish(&c->surface);
  c->shell = shell_of(&c->surface);
  return c;
}

void checker_close(checker_body *c) {
  free(c->shell.of.sheet_of);
  free(c->shell.of.part_of);
  free(c->shell.of.part);
  free(c->shell.piece);
  free(c->shell.open);
  free(c->surface.triangle);
  free(c);
}

bool checker_proves_outside(checker_body *body, checker_body *probe) {
  return shell_outside(&body->shell, &probe->shell, POSE_NONE) &&
         shell_outside(&probe->shell, &body->shell, POSE_NONE);
}
