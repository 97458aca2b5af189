/* SPDX-License-Identifier: MIT */
/* segments.c - divides the motions of a program into rows; nc.h has the bound. */
#include "nc/nc.h"
#include "nc/rows.h"
#include "util/error.h"

#include <string.h>

static const double tolerance_default = 1e-6, tolerance_least = 1e-12;

/* The shortest piece of a motion. */
static const double piece_least = 0x1p-40;

/* What is in force while the program runs. */
typedef struct {
  nc_rows rows;
  double axis[NC_AXES];
  nc_row row;    /* for the next row: tool, spindle, blend, begins */
  double within; /* mm */
  bool lost;     /* the position is not known */
  bool joined;   /* the next motion follows the one before without a stop */
  size_t motions;
} walk;

/* The joints at one t. */
typedef struct {
  double value[NC_JOINTS_MOST];
  double off[NC_JOINTS_MOST]; /* how far the true value may be from it */
} place;

static const nc_kinematics *in_force(const walk *w) { return &w->rows.state[w->rows.states - 1]; }

/* The joints at a point, and how far true joints may be from `given`, or from their own middle if
 * it is NULL. */
static place place_of(const walk *w, const nc_jet axis[NC_AXES], const double *given) {
  nc_jet joint[NC_JOINTS_MOST];
  place p = {.value = {0}};
  nc_kinematics_joints(in_force(w), axis, joint);
  for (size_t n = 0; n < w->rows.motion->joints; n++) {
    p.value[n] = given != NULL ? given[n] : nc_middle(joint[n].v);
    p.off[n] = nc_farthest(joint[n].v, p.value[n]);
  }
  return p;
}

static place place_at(const walk *w, const double axis[NC_AXES], const double *given) {
  nc_jet jet[NC_AXES];
  for (int i = 0; i < NC_AXES; i++) {
    jet[i] = nc_still(nc_point(axis[i]));
  }
  return place_of(w, jet, given);
}

static bool add_row(walk *w, const nc_record *record, double share, const place *p,
                    const double *deviation) {
  w->row.share = share;
  w->row.kind = record->kind;
  w->row.file = record->file;
  w->row.line = record->line;
  w->row.dogleg = w->rows.rules.dogleg && record->kind == NC_RAPID;
  if (!nc_rows_add(&w->rows, &w->row, record, p->value, deviation)) {
    return false;
  }
  w->row.begins = NC_GOES_ON;
  return true;
}

/* ------------------------------------------------------------------------- one motion */

/* The joints' deviation by the slip of an arc's other axes, in a piece. */
static void add_slip(const walk *w, const nc_way *way, double slip, const nc_jet axis[NC_AXES],
                     double deviation[NC_JOINTS_MOST]) {
  nc_jet slipped[NC_AXES], joint[NC_JOINTS_MOST];
  if (!way->arc) {
    return;
  }
  for (int i = 0; i < NC_AXES; i++) {
    double by = i <= NC_Z ? 0 : nc_above(nc_above(fabs(way->to[i] - way->from[i])) * slip);
    nc_interval beside = {-by, by};
    slipped[i] = (nc_jet){nc_add(axis[i].v, beside), beside, nc_point(0)};
  }
  nc_kinematics_joints(in_force(w), slipped, joint);
  for (size_t n = 0; n < w->rows.motion->joints; n++) {
    deviation[n] = nc_above(deviation[n] + nc_size(joint[n].d));
  }
}

/* Bound the deviations in the piece t0 ... t1 between the places a and b. Returns the largest ratio
 * of the part that division makes smaller to its tolerance. */
static double measure(const walk *w, const nc_way *way, double t0, double t1, const place *a,
                      const place *b, double deviation[NC_JOINTS_MOST]) {
  nc_jet axis[NC_AXES], joint[NC_JOINTS_MOST];
  const nc_kinematics *k = in_force(w);
  double h = nc_above(t1 - t0), worst = 0;
  nc_way_at(way, (nc_interval){t0, t1}, axis);
  nc_kinematics_joints(k, axis, joint);
  for (size_t n = 0; n < k->joints; n++) {
    const nc_rules *rules = &w->rows.rules;
    bool angular = w->rows.motion->program.joint[n].angular;
    double chord = nc_above(nc_above(nc_size(joint[n].dd) * nc_above(h * h)) / 8);
    worst = nc_most(worst, chord / (angular ? rules->angular : rules->linear));
    deviation[n] = nc_above(chord + nc_most(a->off[n], b->off[n]));
  }
  add_slip(w, way, nc_way_slip(way, t0, t1), axis, deviation);
  return worst;
}

/* A length of pieces that divides what is left of a motion evenly. */
static double even(double left, double piece) {
  double count = ceil(left / piece);
  return count > 1 ? left / count : left;
}

static bool divide(walk *w, const nc_way *way, const nc_record *record, place *at) {
  double deviation[NC_JOINTS_MOST], t = 0, piece = 1;
  while (t < 1) {
    double next = t + piece < 1 - piece / 2 ? t + piece : 1;
    nc_jet axis[NC_AXES];
    nc_way_at(way, nc_point(next), axis);
    place to = place_of(w, axis, NULL);
    double worst = measure(w, way, t, next, at, &to, deviation);
    if (worst > 1) {
      piece = even(1 - t, (next - t) * nc_most(0.1, 0.95 * sqrt(1 / worst)));
      if (piece < piece_least) {
        return nc_rows_refuse(&w->rows, record,
                              "this motion needs too many rows; give larger "
                              "tolerances");
      }
      continue;
    }
    if (!add_row(w, record, next, &to, deviation)) {
      return false;
    }
    *at = to;
    t = next;
    piece = t < 1 ? even(1 - t, piece * nc_least(2, 0.95 * sqrt(1 / nc_most(worst, 0.01)))) : 1;
  }
  return true;
}

static bool rests(const nc_way *way) {
  int axis = 0;
  while (axis < NC_AXES && nc_way_rests(way, axis)) {
    axis++;
  }
  return axis == NC_AXES;
}

/* A motion from a known position. */
static bool travel(walk *w, const nc_way *way, const nc_record *record, size_t number) {
  nc_rows *r = &w->rows;
  const nc_motion *m = r->motion;
  const double *before = NULL;
  if (w->row.begins == NC_GOES_ON) {
    before = &m->value[(m->rows - 1) * m->joints];
  }
  place at = place_at(w, way->from, before);
  nc_part part = {.record = number,
                  .first = m->rows,
                  .state = r->states - 1,
                  .blend = w->row.blend,
                  .within = w->within,
                  .joined = w->joined};
  memcpy(part.from, way->from, sizeof part.from);
  if (before == NULL) {
    if (!add_row(w, record, 0, &at, NULL)) {
      return false;
    }
    part.first++;
  }
  if (!divide(w, way, record, &at)) {
    return false;
  }
  part.end = m->rows;
  w->joined = w->joined || !rests(way);
  return rests(way) || nc_rows_part(r, &part);
}

static bool move(walk *w, const nc_record *record, size_t number) {
  nc_way way;
  const char *why = nc_way_of(&way, w->axis, record);
  if (why != NULL) {
    return nc_rows_refuse(&w->rows, record, "%s; mend the line", why);
  }
  w->motions++;
  if (w->lost) {
    place to = place_at(w, record->axis, NULL);
    if (!add_row(w, record, 1, &to, NULL)) {
      return false;
    }
  } else if (!travel(w, &way, record, number)) {
    return false;
  }
  memcpy(w->axis, record->axis, sizeof w->axis);
  w->lost = record->kind == NC_PROBE;
  if (w->lost) {
    w->row.begins = NC_PROBED;
    w->joined = false;
  }
  return true;
}

/* --------------------------------------------------------------------- other records */

/* A dwell has no row while the position is not known. */
static bool dwell(walk *w, const nc_record *record) {
  w->joined = false;
  if (w->lost) {
    return true;
  }
  const nc_motion *m = w->rows.motion;
  const double *before = w->row.begins == NC_GOES_ON ? &m->value[(m->rows - 1) * m->joints] : NULL;
  place at = place_at(w, w->axis, before);
  return add_row(w, record, 1, &at, before != NULL ? at.off : NULL);
}

/* Do two states of the kinematics give different joints at the position? */
static double jump(walk *w, const nc_kinematics *to, const double axis[NC_AXES]) {
  place before = place_at(w, w->axis, NULL), after;
  double most = 0;
  if (!nc_rows_state(&w->rows, to)) {
    return -1;
  }
  after = place_at(w, axis, NULL);
  for (size_t n = 0; n < w->rows.motion->joints; n++) {
    most = nc_most(most, fabs(after.value[n] - before.value[n]));
  }
  return most;
}

/* A tool offset moves nothing. If the kinematics depend on it, then the control takes the same
 * position for other joints at once. */
static bool change_length(walk *w, const nc_record *record) {
  nc_kinematics k = *in_force(w);
  if (!nc_kinematics_length(&k, record->axis[NC_Z])) {
    return true;
  }
  double by = jump(w, &k, w->axis);
  if (by > 1e-11 && w->row.begins == NC_GOES_ON) {
    w->row.begins = NC_DISPLACED;
  }
  w->joined = false;
  return by >= 0;
}

static bool change_kinematics(walk *w, const nc_record *record) {
  nc_kinematics k = *in_force(w);
  if (!nc_kinematics_switch(&k, record->number)) {
    return nc_rows_refuse(&w->rows, record, "the kinematics have no type %d that is known here",
                          record->number);
  }
  double by = jump(w, &k, record->axis);
  w->joined = false;
  if (by > 1e-9 && !w->lost) {
    return nc_rows_refuse(&w->rows, record,
                          "at the change of the kinematics the position given to the axes moves "
                          "the joints by %.3g m or rad; the parameters of the kinematics differ "
                          "from the front end's",
                          by);
  }
  memcpy(w->axis, record->axis, sizeof w->axis);
  return by >= 0;
}

static void load(walk *w, const nc_record *record) {
  w->row.tool = record->number;
  w->joined = false;
  if (w->row.begins == NC_GOES_ON) {
    w->row.begins = NC_LOADED;
  }
}

static bool take(walk *w, const nc_record *record, size_t number) {
  switch (record->action) {
  case NC_DO_MOVE:
  case NC_DO_ARC:
    return move(w, record, number);
  case NC_DO_DWELL:
    return dwell(w, record);
  case NC_DO_LENGTH:
    return change_length(w, record);
  case NC_DO_KINS:
    return change_kinematics(w, record);
  case NC_DO_LOAD:
    load(w, record);
    return true;
  case NC_DO_SPINDLE:
    w->row.spindle = record->number != 0;
    return true;
  case NC_DO_BLEND:
    w->row.blend = record->blend;
    w->within = record->blend == NC_WITHIN ? record->within : 0;
    w->row.within = w->within / 1000;
    return true;
  case NC_DO_NOTE:
  case NC_DO_END:
    break;
  }
  return true;
}

/* ----------------------------------------------------------------------- the program */

static bool run(walk *w) {
  const nc_program *p = &w->rows.motion->program;
  if (!nc_rows_begin(&w->rows)) {
    return false;
  }
  memcpy(w->axis, p->start, sizeof w->axis);
  for (size_t n = 0; n < p->records; n++) {
    if (!take(w, &p->record[n], n)) {
      return false;
    }
  }
  if (w->motions == 0) {
    return sepax_fail(w->rows.error, SEPAX_ERROR_FORMAT,
                      "%.300s: the program moves nothing; give one with motions",
                      nc_program_file(p, 0));
  }
  return nc_rows_blend(&w->rows);
}

static bool check_rules(nc_rules *rules, const nc_rules *given, sepax_error *error) {
  *rules = given != NULL ? *given : (nc_rules){0};
  rules->linear = rules->linear == 0 ? tolerance_default : rules->linear;
  rules->angular = rules->angular == 0 ? tolerance_default : rules->angular;
  return (rules->linear >= tolerance_least && rules->angular >= tolerance_least) ||
         sepax_fail(error, SEPAX_ERROR_ARGUMENT, "a tolerance is below %g m or rad; give more",
                    tolerance_least);
}

void nc_motion_free(nc_motion *motion) {
  nc_program_free(&motion->program);
  sepax_release(motion->row);
  sepax_release(motion->value);
  sepax_release(motion->deviation);
  sepax_release(motion->blending);
  *motion = (nc_motion){0};
}

bool nc_motion_read(nc_motion *motion, FILE *stream, const char *name, const nc_rules *rules,
                    sepax_error *error) {
  walk w = {.rows = {.name = name, .motion = motion, .error = error},
            .row = {.tool = -1, .begins = NC_FIRST, .blend = NC_UNBOUNDED}};
  *motion = (nc_motion){0};
  if (!check_rules(&w.rows.rules, rules, error) ||
      !nc_program_read(&motion->program, stream, name, error)) {
    return false;
  }
  bool ok = run(&w);
  nc_rows_end(&w.rows);
  if (!ok) {
    nc_motion_free(motion);
  }
  return ok;
}
