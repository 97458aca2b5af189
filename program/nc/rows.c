/* SPDX-License-Identifier: MIT */
/* rows.c - lists of rows and of the motions that they belong to. */
#include "nc/rows.h"
#include "util/error.h"
#include "util/list.h"

#include <stdarg.h>
#include <string.h>

static const size_t rows_most = (size_t)1 << 24;

/* A joint may be beyond its limit by this much, in m or rad, because values are rounded. */
static const double limit_slack = 1e-9;

bool nc_rows_refuse(const nc_rows *r, const nc_record *record, const char *format, ...) {
  char detail[300], line[32] = "";
  va_list args;
  va_start(args, format);
  vsnprintf(detail, sizeof detail, format, args);
  va_end(args);
  if (record->line > 0) {
    snprintf(line, sizeof line, ":%zu", record->line);
  }
  return sepax_fail(r->error, SEPAX_ERROR_FORMAT, "%.180s%s: %s",
                    nc_program_file(&r->motion->program, record->file), line, detail);
}

static bool no_memory(const nc_rows *r) {
  return sepax_fail(r->error, SEPAX_ERROR_MEMORY,
                    "%.180s: no memory for more rows than %zu; give larger tolerances", r->name,
                    r->motion->rows);
}

bool nc_rows_state(nc_rows *r, const nc_kinematics *k) {
  nc_kinematics *grown = list_grow(r->state, &r->state_capacity, r->states, sizeof *grown);
  if (grown == NULL) {
    return no_memory(r);
  }
  r->state = grown;
  r->state[r->states++] = *k;
  return true;
}

bool nc_rows_part(nc_rows *r, const nc_part *part) {
  nc_part *grown = list_grow(r->part, &r->part_capacity, r->parts, sizeof *grown);
  if (grown == NULL) {
    return no_memory(r);
  }
  r->part = grown;
  r->part[r->parts++] = *part;
  return true;
}

/* How far smoothing takes a joint off its way, in m or rad (nc.h). The control keeps the
 * acceleration of axes. Where joints are not axes, they may accelerate faster, so the default is a
 * floor there. */
static double smoothing_of(const nc_rows *r, const nc_joint *joint, bool trivial) {
  double given = joint->angular ? r->rules.servo_angular : r->rules.servo_linear;
  double plain = joint->angular ? 1e-5 : 1e-6;
  double period = r->motion->program.servo;
  double fastest = nc_kinematics_metric(joint->angular, nc_point(joint->acceleration)).hi;
  double bound = 2 * fastest * period * period / 6 * (1 + 0x1p-40);
  if (given != 0) {
    return fmax(given, 0);
  }
  bool told = joint->acceleration > 0 && period > 0;
  return !told ? plain : trivial ? bound : fmax(bound, plain);
}

bool nc_rows_begin(nc_rows *r) {
  const nc_program *p = &r->motion->program;
  nc_kinematics k;
  if (!nc_kinematics_of(&k, p, r->name, r->error) || !nc_rows_state(r, &k)) {
    return false;
  }
  for (size_t n = 0; n < p->joints; n++) {
    const nc_joint *joint = &p->joint[n];
    r->least[n] = nc_kinematics_metric(joint->angular, nc_point(joint->least)).lo;
    r->most[n] = nc_kinematics_metric(joint->angular, nc_point(joint->most)).hi;
    r->motion->smoothing[n] = smoothing_of(r, joint, k.module == NC_TRIVIAL);
  }
  r->motion->joints = p->joints;
  return true;
}

void nc_rows_end(nc_rows *r) {
  sepax_release(r->part);
  sepax_release(r->state);
  r->part = NULL;
  r->state = NULL;
}

/* ---------------------------------------------------------------------------- rows */

static bool refuse_joint(const nc_rows *r, const nc_record *record, size_t n, double value,
                         bool between) {
  const nc_joint *joint = &r->motion->program.joint[n];
  bool above = value > r->most[n];
  double scale = joint->angular ? 57.29577951308232 : 1000;
  const char *unit = joint->angular ? "deg" : "mm";
  return nc_rows_refuse(r, record,
                        "joint %zu (axis %c) %s %.9g %s, %s its limit of %.9g %s; mend the program "
                        "or its offsets, or give --ignore-limits",
                        n, nc_letter(joint->axis), between ? "may go on its way to" : "goes to",
                        value * scale, unit, above ? "above" : "below",
                        above ? joint->most : joint->least, unit);
}

/* Values on the way are at most the deviation beyond the values of the two rows. */
static bool within_limits(const nc_rows *r, const nc_record *record, const double *value,
                          const double *deviation) {
  size_t joints = r->motion->joints;
  for (size_t n = 0; n < joints && !r->rules.ignore_limits; n++) {
    double off = deviation != NULL ? deviation[n] : 0;
    double low = r->least[n] - limit_slack, high = r->most[n] + limit_slack;
    if (!(value[n] >= low && value[n] <= high)) {
      return refuse_joint(r, record, n, value[n], false);
    }
    if (deviation == NULL) {
      continue;
    }
    double before = value[n];
    if (r->motion->rows > 0) {
      before = r->motion->value[(r->motion->rows - 1) * joints + n];
    }
    double least = nc_least(before, value[n]) - off, most = nc_most(before, value[n]) + off;
    if (!(least >= low && most <= high)) {
      return refuse_joint(r, record, n, least >= low ? most : least, true);
    }
  }
  return true;
}

bool nc_rows_add(nc_rows *r, const nc_row *row, const nc_record *record, const double *value,
                 const double *deviation) {
  nc_motion *to = r->motion;
  size_t joints = to->joints;
  if (!within_limits(r, record, value, deviation)) {
    return false;
  }
  nc_row *rows = list_grow(to->row, &r->row_capacity, to->rows, sizeof *rows);
  to->row = rows != NULL ? rows : to->row;
  double *values = list_grow(to->value, &r->value_capacity, to->rows, joints * sizeof *values);
  to->value = values != NULL ? values : to->value;
  double *deviations =
      list_grow(to->deviation, &r->deviation_capacity, to->rows, joints * sizeof *deviations);
  to->deviation = deviations != NULL ? deviations : to->deviation;
  if (rows == NULL || values == NULL || deviations == NULL || to->rows == rows_most) {
    return no_memory(r);
  }
  to->row[to->rows] = *row;
  memcpy(&to->value[to->rows * joints], value, joints * sizeof *value);
  for (size_t n = 0; n < joints; n++) {
    to->deviation[to->rows * joints + n] = deviation != NULL ? deviation[n] : 0;
  }
  to->rows++;
  return true;
}
