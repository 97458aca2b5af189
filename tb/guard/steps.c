/* SPDX-License-Identifier: MIT */
/* steps.c - the guard without a control, in the worst case that guard.h allows: the stop acts only
 * after `reaction` periods, until then the machine accelerates towards the bodies, and it brakes
 * with no more than `brake` of the acceleration while its path turns. Prints how near it came.
 *   steps MACHINE.urdf SEED RUNS: exit status 1 if it came within the clearance, or never near */
#include "../../examples/linuxcnc/guard.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { JOINTS = 3, DELAY = 10, PERIODS = 20000 };

static const guard_settings SETTINGS = {.joints = JOINTS,
                                        .axis = "XYZ",
                                        .name = {"x", "y", "z"},
                                        .unit = 0.001,
                                        .clearance = 0.002,
                                        .slow_zone = 0.02,
                                        .slow_scale = 0.2,
                                        .reaction = DELAY,
                                        .brake = 0.2,
                                        .work = 1000};

typedef struct {
  double position[JOINTS], toward[JOINTS], speed, fastest;
  bool coordinated;
} machine_state;

static uint64_t seed;

static double between(double low, double high) {
  seed = seed * 6364136223846793005u + 1442695040888963407u;
  return low + (high - low) * (double)(seed >> 11) * 0x1p-53;
}

/* A direction towards the bodies; a jog moves one joint alone. */
static void direct(machine_state *m) {
  double square = 0;
  for (int k = 0; k < JOINTS; k++) {
    m->toward[k] = m->coordinated ? between(-1, 1) : 0;
  }
  m->toward[2] = -fabs(m->coordinated ? m->toward[2] : 1);
  for (int k = 0; k < JOINTS; k++) {
    square += m->toward[k] * m->toward[k];
  }
  for (int k = 0; k < JOINTS; k++) {
    m->toward[k] /= sqrt(square);
  }
}

static void move(machine_state *m, bool stop, double scale) {
  const double most = m->coordinated ? 1000 * sqrt(3.0) : 1000;
  const double brake = m->coordinated ? 200 : 1000;
  const double target = m->fastest * scale;
  m->speed = stop ? fmax(0, m->speed - brake * 0.001) : fmin(target, m->speed + most * 0.001);
  if (m->coordinated && between(0, 1) < 0.02) {
    direct(m); /* the path turns */
  }
  for (int k = 0; k < JOINTS; k++) {
    m->position[k] += m->toward[k] * m->speed * 0.001;
  }
}

static guard_input input_of(const machine_state *m) {
  guard_input in = {.period = 0.001, .coordinated = m->coordinated, .homed = true, .tool = 1};
  in.speed = m->coordinated ? m->speed : 0;
  for (int k = 0; k < JOINTS; k++) {
    in.position[k] = m->position[k];
    in.velocity[k] = m->toward[k] * m->speed;
    in.acceleration[k] = 1000;
    in.fastest[k] = 200;
  }
  return in;
}

/* The least distance of all pairs, mm. */
static double distance(const sepax_robot_machine *robot, sepax_watch *watch,
                       const machine_state *m) {
  double value[16] = {0};
  sepax_machine_answer answer;
  sepax_error error;
  const sepax_machine_query query = {.size = sizeof query, .measure = true, .relative = 1e-6};
  for (int k = 0; k < JOINTS; k++) {
    value[sepax_robot_joint(&robot->robot, SETTINGS.name[k])] = m->position[k] * 0.001;
  }
  if (!sepax_watch_ask(watch, value, &query, &answer, &error)) {
    fprintf(stderr, "steps: %s\n", error.text);
    exit(2);
  }
  return answer.verdict == SEPAX_NEAR ? 0 : answer.least * 1000;
}

/* One run towards the bodies; the least distance on the way. */
static double run(guard *g, const sepax_robot_machine *robot, sepax_watch *watch) {
  machine_state m = {.position = {between(-60, 60), between(-40, 40), between(-60, 40)},
                     .fastest = between(1, 150)};
  bool stop[DELAY] = {false};
  guard_output out = {.feed_scale = 1};
  double least = INFINITY;
  m.coordinated = between(0, 1) < 0.5;
  direct(&m);
  for (int period = 0; period < PERIODS && (period < DELAY || m.speed > 0); period++) {
    guard_input in = input_of(&m);
    in.reset = period == 0;
    guard_step(g, &in, &out);
    const bool acts = stop[period % DELAY]; /* what was said DELAY periods before */
    stop[period % DELAY] = m.coordinated ? out.feed_inhibit : out.jog_stop;
    move(&m, acts, m.coordinated && !acts && out.feed_scale > 0 ? out.feed_scale : 1);
    least = fmin(least, distance(robot, watch, &m));
  }
  return least;
}

int main(int argc, char **argv) {
  char text[GUARD_TEXT] = "";
  sepax_robot_machine robot;
  sepax_watch *watch;
  sepax_error error;
  double least = INFINITY;
  if (argc != 4 || !sepax_robot_machine_read(&robot, argv[1], NULL, NULL, &error) ||
      !sepax_watch_new(&watch, robot.machine, &error)) {
    fputs("steps: give MACHINE.urdf SEED RUNS\n", stderr);
    return 2;
  }
  seed = strtoull(argv[2], NULL, 10);
  for (long n = strtol(argv[3], NULL, 10); n > 0; n--) {
    guard *g = guard_new(&SETTINGS, &(guard_tool){.tool = 1, .urdf = argv[1]}, 1, text);
    if (g == NULL) {
      fprintf(stderr, "steps: %s\n", text);
      return 2;
    }
    least = fmin(least, run(g, &robot, watch));
    guard_free(g);
  }
  sepax_watch_free(watch);
  sepax_robot_machine_free(&robot);
  printf("least distance %.6f mm; clearance %g mm\n", least, SETTINGS.clearance * 1000);
  return least > SETTINGS.clearance * 1000 && least < 3 * SETTINGS.clearance * 1000 ? 0 : 1;
}
