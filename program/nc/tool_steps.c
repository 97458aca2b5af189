/* SPDX-License-Identifier: MIT */
/* tool_steps.c - lists of steps, such as "28@5 28>32@20 50@30" or "6>10@15R85", as profiles. */
#include "nc/tool_rows.h"
#include "util/error.h"
#include "util/text.h"

#include <math.h>
#include <string.h>

/* A step: diameters at its ends, length, and radius of an arc between; all in the column's unit. */
typedef struct {
  double diameter[2], length, bend;
} step;

bool nc_tool_add_point(turned_profile *profile, const nc_tool_row *row, double z, double r,
                       double bend, sepax_error *error) {
  if (profile->points > 0) {
    const turned_point *last = &profile->point[profile->points - 1];
    if (last->z >= z && last->z <= z && last->r >= r && last->r <= r) {
      return true;
    }
  }
  if (profile->points == TURNED_POINTS_MOST) {
    return nc_tool_refuse(row, error, "a profile of more than %d points; leave some out",
                          TURNED_POINTS_MOST);
  }
  if (profile->points == 0) {
    profile->point = sepax_allocate(TURNED_POINTS_MOST * sizeof *profile->point);
    if (profile->point == NULL) {
      return sepax_fail(error, SEPAX_ERROR_MEMORY, "%.240s: no memory for a profile", row->path);
    }
  }
  profile->point[profile->points++] = (turned_point){z, r, bend};
  return true;
}

/* The number at *at, which moves to its end; false if there is none. */
static bool take_number(const char **at, double *value) {
  const char *end = sepax__decimal(*at, value);
  bool ok = end != NULL && isfinite(*value);
  *at = ok ? end : *at;
  return ok;
}

/* DIAMETER or DIAMETER>DIAMETER, then @LENGTH, then Rradius of an arc or nothing. */
static bool take_step(const char **at, step *s) {
  *s = (step){{0, 0}, 0, 0};
  bool ok = take_number(at, &s->diameter[0]);
  s->diameter[1] = s->diameter[0];
  if (ok && **at == '>') {
    ++*at;
    ok = take_number(at, &s->diameter[1]);
  }
  ok = ok && *(*at)++ == '@' && take_number(at, &s->length);
  if (ok && **at == 'R') {
    ++*at;
    ok = take_number(at, &s->bend) && s->bend != 0;
  }
  return ok && (**at == ' ' || **at == '\0') && s->diameter[0] >= 0 && s->diameter[1] >= 0 &&
         s->length > 0;
}

bool nc_tool_add_steps(turned_profile *profile, const nc_tool_row *row, nc_tool_part part,
                       double *z, sepax_error *error) {
  const tool_steps *list = &row->steps[part];
  const char *name = nc_tool_part_name(part);
  const char *at = list->text;
  while (*at != '\0') {
    step s;
    const char *begin = at;
    if (!take_step(&at, &s)) {
      int length = (int)strcspn(begin, " ");
      return nc_tool_refuse(row, error,
                            "column '%s': step '%.*s'; give DIAMETER@LENGTH, "
                            "DIAMETER>DIAMETER@LENGTH, or either with R and the radius of an arc",
                            name, length < 40 ? length : 40, begin);
    }
    double half = list->unit / 2;
    if (!nc_tool_add_point(profile, row, *z, s.diameter[0] * half, 0, error)) {
      return false;
    }
    *z += s.length * list->unit;
    if (!nc_tool_add_point(profile, row, *z, s.diameter[1] * half, s.bend * list->unit, error)) {
      return false;
    }
    at += strspn(at, " ");
  }
  sepax_error why;
  return sepax__turned_check(profile, &why) ||
         nc_tool_refuse(row, error, "column '%s', from the tip: %.150s", name, why.text);
}
