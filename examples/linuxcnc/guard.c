/* SPDX-License-Identifier: MIT */
/* guard.c - the verdict of each period; see guard.h. */
#include "machine.h"

#include <math.h>
#include <string.h>

const char *guard_reason_text(guard_reason reason) {
  static const char *const TEXT[] = {
      "none",           "near",           "may be near",   "not homed",    "a number is not valid",
      "tool not known", "a joint jumped", "query refused", "left the tube"};
  return TEXT[reason];
}

/* ------------------------------------------------------------------ the way of braking */

/* How far a joint goes that brakes with `a` from the velocity w after the time d. */
static double way(double w, double a, double d) { return w > 0 ? w * d + w * w / (2 * a) : 0; }

static bool resting(const guard_settings *s, const guard_input *in) {
  bool rest = in->speed == 0;
  for (size_t n = 0; n < s->joints; n++) {
    rest = rest && in->velocity[n] == 0;
  }
  return rest;
}

static bool on_path(const guard_settings *s, size_t n) { return strchr("XYZ", s->axis[n]) != NULL; }

/* Coordinated motion: the greatest speed along X, Y and Z when it begins to brake, and how long it
 * brakes then. */
typedef struct {
  double speed, time;
} path_brake;

/* A joint that rested in the period before, too, is part of no motion now. */
static bool rests(const guard_input *in, size_t n, const double *before) {
  return before != NULL && in->velocity[n] == 0 && before[n] == 0;
}

static path_brake brake_of_path(const guard_settings *s, const guard_input *in,
                                const double *before, double d) {
  double square = 0;
  double growth = 0;
  double least = INFINITY;
  path_brake path = {0, 0};
  for (size_t n = 0; n < s->joints; n++) {
    const double a = in->acceleration[n];
    if (on_path(s, n)) {
      square += in->velocity[n] * in->velocity[n];
      growth += a * a;
      least = fmin(least, a);
    } else {
      path.time = fmax(path.time, rests(in, n, before) ? d : in->fastest[n] / a);
    }
  }
  path.speed = fmax(sqrt(square), fabs(in->speed)) + sqrt(growth) * d;
  path.time = fmax(path.time, path.speed / least) / s->brake;
  return path;
}

void guard_reach(const guard_settings *s, const guard_input *in, const double *before,
                 double low[GUARD_JOINTS_MOST], double high[GUARD_JOINTS_MOST]) {
  const double d = s->reaction * in->period;
  const path_brake path = brake_of_path(s, in, before, d);
  for (size_t n = 0; n < s->joints; n++) {
    const double a = in->acceleration[n];
    if (!in->coordinated) {
      high[n] = way(in->velocity[n] + a * d, a, d);
      low[n] = -way(a * d - in->velocity[n], a, d);
    } else {
      const bool still = rests(in, n, before);
      high[n] = on_path(s, n) ? path.speed * (d + path.time / 2)
                : still       ? way(a * d, s->brake * a, d)
                              : in->fastest[n] * (d + path.time / 2);
      low[n] = -high[n];
    }
  }
}

/* Values and travels of a machine that cover the box. X, Y and Z together move along the path, so
 * if their axes are at right angles, then they move no body by more than the way of the path: a
 * ball, where the box would count this way three times. The factors cover the rounding of all this
 * and of `square`. */
static void cover(guard_machine *m, const guard *g, const guard_input *in) {
  const guard_settings *s = &g->settings;
  double low[GUARD_JOINTS_MOST];
  double high[GUARD_JOINTS_MOST];
  guard_reach(s, in, g->seen ? g->before : NULL, low, high);
  m->apart = 0;
  for (size_t n = 0; n < s->joints; n++) {
    if (in->coordinated && m->square && on_path(s, n)) {
      m->apart = high[n] * s->unit * (1 + 1e-9);
      low[n] = high[n] = 0;
    }
    const double middle = in->position[n] + (low[n] + high[n]) / 2;
    const double half = (high[n] - low[n]) / 2 * (1 + 1e-9) + fabs(middle) * 1e-14;
    m->value[m->joint[n]] = middle * m->scale[n];
    m->travel[m->joint[n]] = half * m->scale[n];
  }
}

/* ------------------------------------------------------------------ queries */

/* With `travel`: for all positions of `cover`; else for the values alone. */
static bool ask(guard_machine *m, const guard_settings *s, double clearance, const double *travel,
                bool measure, sepax_machine_answer *answer) {
  sepax_error error = {0};
  const double apart = travel != NULL ? m->apart : 0;
  const sepax_machine_query query = {.size = sizeof query,
                                     .clearance = clearance + apart,
                                     .travel = travel,
                                     .work = s->work,
                                     .measure = measure,
                                     .relative = 0.02,
                                     .absolute = 1e-6};
  memset(answer, 0, sizeof *answer);
  const bool good = sepax_watch_ask(m->watch, m->value, &query, answer, &error);
  answer->least = fmax(0, answer->least - apart);
  answer->most = fmax(0, answer->most - apart);
  return good;
}

static void report(const guard_machine *m, const guard_settings *s,
                   const sepax_machine_answer *answer, guard_output *out) {
  const size_t pair = answer->nearest != SEPAX_NO_PAIR ? answer->nearest : answer->pair;
  out->least = answer->least / s->unit;
  out->most = answer->most / s->unit;
  out->work += answer->work;
  for (int side = 0; side < 2 && pair != SEPAX_NO_PAIR; side++) {
    out->nearest[side] = m->robot.pairs.pair[pair][side];
  }
}

/* ------------------------------------------------------------------ one period */

static bool numbers_good(const guard_settings *s, const guard_input *in) {
  bool good = in->period > 0 && in->period <= 1 && isfinite(in->speed);
  for (size_t n = 0; n < s->joints; n++) {
    good = good && isfinite(in->position[n]) && isfinite(in->velocity[n]) &&
           in->acceleration[n] > 0 && isfinite(in->acceleration[n]) && in->fastest[n] > 0 &&
           isfinite(in->fastest[n]);
  }
  return good;
}

/* A period was missed, or the velocities are not connected: the way since the period before is
 * more than the velocity explains. */
static bool jumped(const guard *g, const guard_input *in) {
  bool jump = false;
  for (size_t n = 0; n < g->settings.joints; n++) {
    const double moved = fabs(in->position[n] - g->last[n]);
    const double change = 8 * in->acceleration[n] * in->period;
    jump = jump || moved > (1.5 * fabs(in->velocity[n]) + change) * in->period;
  }
  return g->seen && jump;
}

static guard_machine *machine_of(guard *g, long tool) {
  for (size_t n = 0; n < g->tools; n++) {
    if (g->tool[n].tool == tool || g->tool[n].tool == -1) {
      return &g->tool[n];
    }
  }
  return NULL;
}

static guard_reason failure(guard *g, const guard_input *in) {
  if (!numbers_good(&g->settings, in)) {
    return GUARD_NOT_A_NUMBER;
  }
  if (!in->homed) {
    return GUARD_NOT_HOMED;
  }
  if (machine_of(g, in->tool) == NULL) {
    return GUARD_TOOL;
  }
  return jumped(g, in) ? GUARD_JUMP : GUARD_NO_REASON;
}

/* Programs and MDI move in the tube of a certified program. */
static bool in_tube(guard *g, const guard_input *in, guard_output *out) {
  const bool was = g->place.inside;
  if (g->tube == NULL || !in->coordinated) {
    g->place.inside = false;
    return false;
  }
  out->in_tube = tube_inside(g->tube, &g->place, in->position, in->velocity, in->acceleration,
                             in->tool, in->period);
  g->left = was && !out->in_tube;
  return out->in_tube;
}

static void latch(guard *g, guard_reason reason) {
  if (!g->latched) {
    g->reason = reason;
    g->kept = g->settings.clearance;
    g->rebase = true;
  }
  g->latched = true;
}

/* Zones and the display: how near are the bodies at the commanded position? Once in MEASURED
 * periods, because it takes longer than the verdict and no proof needs it. */
static bool measure(guard *g, guard_machine *m, const guard_input *in, guard_output *out) {
  const guard_settings *s = &g->settings;
  const double leave = s->clearance + 1.1 * s->slow_zone;
  sepax_machine_answer answer;
  /* The zone is one of distance, not of speed: otherwise slowing would leave it. */
  for (size_t n = 0; n < s->joints; n++) {
    m->value[m->joint[n]] = in->position[n] * m->scale[n];
  }
  if (!ask(m, s, s->clearance, NULL, true, &answer)) {
    return false;
  }
  report(m, s, &answer, out);
  g->slow = answer.least < (g->slow ? leave : s->clearance + s->slow_zone);
  g->measured = *out;
  return true;
}

/* The machine may move: is it still proved that it stops in time? */
static void run(guard *g, guard_machine *m, const guard_input *in, guard_output *out) {
  enum { MEASURED = 8 };
  const guard_settings *s = &g->settings;
  sepax_machine_answer answer;
  if (in_tube(g, in, out)) {
    out->least = g->tube->free_of / s->unit;
    out->most = INFINITY;
    g->slow = false;
    g->since = 0;
    return;
  }
  cover(m, g, in);
  if (!ask(m, s, s->clearance, m->travel, false, &answer)) {
    latch(g, GUARD_QUERY);
    return;
  }
  if (answer.verdict != SEPAX_APART) {
    report(m, s, &answer, out);
    latch(g, g->left                        ? GUARD_LEFT_TUBE
             : answer.verdict == SEPAX_NEAR ? GUARD_IS_NEAR
                                            : GUARD_MAY_BE_NEAR);
    return;
  }
  out->work += answer.work;
  if (g->since++ % MEASURED == 0) {
    if (!measure(g, m, in, out)) {
      latch(g, GUARD_QUERY);
    }
    return;
  }
  out->least = g->measured.least;
  out->most = g->measured.most;
  memcpy(out->nearest, g->measured.nearest, sizeof out->nearest);
}

/* The joint of the control that is fastest, as a number of the mechanism. */
static size_t fastest(const guard_machine *m, const guard_settings *s, const guard_input *in) {
  size_t joint = 0;
  for (size_t n = 1; n < s->joints; n++) {
    joint = fabs(in->velocity[n]) > fabs(in->velocity[joint]) ? n : joint;
  }
  return m->joint[joint];
}

/* Is every pair farther apart than `clearance` in all positions of `cover`? The way of the joint
 * that is fastest is divided, because a query counts a way along a surface like one towards it.
 * The pieces share the work of one query. */
static bool apart_in_pieces(guard_machine *m, const guard_settings *s, const guard_input *in,
                            double clearance, guard_output *out) {
  enum { PIECES = 8 };
  guard_settings piece = *s;
  sepax_machine_answer answer;
  const size_t joint = fastest(m, s, in);
  const double middle = m->value[joint];
  const double half = m->travel[joint];
  bool apart = true;
  m->travel[joint] = half / PIECES + (fabs(middle) + half) * 1e-14;
  for (int n = 0; n < PIECES && apart && piece.work > 0; n++) {
    m->value[joint] = middle + half * (2 * n + 1 - PIECES) / PIECES;
    apart = ask(m, &piece, clearance, m->travel, false, &answer) && answer.verdict == SEPAX_APART;
    piece.work -= answer.work < piece.work ? answer.work : piece.work;
    out->work += answer.work;
  }
  return apart && piece.work > 0;
}

/* Stopped: a jog may only lead away. When the joints rest, the guard notes the least distance of
 * all pairs, less a tenth of the clearance, so that a jog along a surface is not one towards it.
 * No pair may come nearer than this. It is noted once after the stop and once after each reset;
 * otherwise it only grows, so that repeated jogs do not wear it down. */
static void hold(guard *g, guard_machine *m, const guard_input *in, bool reset, guard_output *out) {
  const guard_settings *s = &g->settings;
  sepax_machine_answer answer;
  out->jog_stop = true;
  g->rebase = g->rebase || reset;
  cover(m, g, in);
  const bool rest = resting(s, in);
  const bool tubed = in_tube(g, in, out);
  if (!ask(m, s, s->clearance, m->travel, true, &answer)) {
    return;
  }
  report(m, s, &answer, out);
  if (reset && rest && (tubed || answer.verdict == SEPAX_APART)) {
    g->latched = false;
    g->since = 0;
    g->reason = GUARD_NO_REASON;
    out->jog_stop = false;
    return;
  }
  if (rest && !in->coordinated) {
    const double lower = answer.least - 0.1 * s->clearance;
    const double kept = answer.least >= s->clearance ? fmax(lower, s->clearance) : fmax(lower, 0);
    g->kept = g->rebase ? kept : fmax(kept, g->kept);
    g->rebase = false;
  }
  out->jog_stop =
      in->coordinated || g->rebase || g->kept == 0 || !apart_in_pieces(m, s, in, g->kept, out);
}

static void finish(guard *g, const guard_input *in, guard_output *out) {
  const bool stopped = out->state == GUARD_BLIND || g->latched;
  if (g->latched) {
    out->state = GUARD_STOPPED;
  } else if (out->state != GUARD_BLIND) {
    out->state = g->slow ? GUARD_SLOW : GUARD_FREE;
  }
  out->reason = out->state == GUARD_BLIND ? GUARD_NOT_HOMED : g->reason;
  out->feed_inhibit = stopped;
  out->feed_scale = stopped ? 0 : g->slow ? g->settings.slow_scale : 1;
  memcpy(g->last, in->position, sizeof g->last);
  memcpy(g->before, in->velocity, sizeof g->before);
  g->reset_was = in->reset;
}

void guard_step(guard *g, const guard_input *in, guard_output *out) {
  const bool reset = in->reset && !g->reset_was;
  *out = (guard_output){.state = GUARD_FREE, .nearest = {SEPAX_NO_PAIR, SEPAX_NO_PAIR}};
  const guard_reason wrong = failure(g, in);
  if (wrong == GUARD_NOT_HOMED) {
    out->state = g->latched ? GUARD_STOPPED : GUARD_BLIND;
    out->jog_stop = true;
  } else if (wrong != GUARD_NO_REASON) {
    latch(g, wrong);
    out->jog_stop = true;
  } else if (g->latched) {
    hold(g, machine_of(g, in->tool), in, reset, out);
  } else {
    run(g, machine_of(g, in->tool), in, out);
    out->jog_stop = g->latched;
  }
  g->seen = in->homed && wrong != GUARD_NOT_A_NUMBER;
  finish(g, in, out);
}
