/* SPDX-License-Identifier: MIT */
/* replay.c - the guard without a control: on the joints that a control commanded, or on random
 * motion; what it says and what it costs.
 *   replay MACHINE.urdf SRDF AXES CLEARANCE ACCELERATION VELOCITY samples TUBE SAMPLES.csv
 *   replay MACHINE.urdf SRDF AXES CLEARANCE ACCELERATION VELOCITY random SEED PERIODS
 * SRDF: or - for none. AXES: the letters of the control's joints; the URDF's have the same names in
 * lower case. ACCELERATION: of all joints, or LINEAR,ANGULAR. Lengths in mm, angles in degrees.
 * TUBE: a file of sepax path --tube, or - for none. SAMPLES.csv: columns joint0, joint1, ... in
 * each servo period of 1 ms, as tb/nc/simulator writes them; in the slow zone they are done slower.
 * All is done three times, and of each period the least time counts: what else the machine does is
 * not the guard's. Prints name and value in each line; exit status 2 on failure. */
#include "../../examples/linuxcnc/guard.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <time.h>

enum { ROWS = 100000, RUNS = 3 };

static const double PERIOD = 0.001;

/* ------------------------------------------------------------------ memory */

/* The linker gives each call of malloc and its like to these (--wrap). */
static size_t allocations;

/* NOLINTBEGIN(bugprone-reserved-identifier): these names are the linker's */
void *__real_malloc(size_t bytes);
void *__real_calloc(size_t count, size_t bytes);
void *__real_realloc(void *at, size_t bytes);
void *__wrap_malloc(size_t bytes);
void *__wrap_calloc(size_t count, size_t bytes);
void *__wrap_realloc(void *at, size_t bytes);

void *__wrap_malloc(size_t bytes) {
  allocations++;
  return __real_malloc(bytes);
}

void *__wrap_calloc(size_t count, size_t bytes) {
  allocations++;
  return __real_calloc(count, bytes);
}

void *__wrap_realloc(void *at, size_t bytes) {
  allocations++;
  return __real_realloc(at, bytes);
}
/* NOLINTEND(bugprone-reserved-identifier) */

/* ------------------------------------------------------------------ what is counted */

typedef struct {
  size_t periods, tube, slow, stops, toggles;
  size_t timed[2]; /* free, in the tube */
  double sum[2], worst[2];
  float *time; /* of each period, us: the least of the runs so far; 0: none */
  size_t room; /* for periods */
  uint64_t work;
  size_t first, outside; /* periods of the first stop and of the first one outside of the tube */
  guard_reason reason;
  size_t allocated, faults;
} tally;

static void fail(const char *what, const char *of) {
  fprintf(stderr, "replay: %s%s\n", what, of);
  exit(2);
}

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return (double)t.tv_sec * 1e6 + (double)t.tv_nsec * 1e-3;
}

/* As LinuxCNC does before it loads a component: memory is there before it is used. */
static void lock_memory(void) {
  char stack[1 << 18];
  mlockall(MCL_CURRENT | MCL_FUTURE); /* may be forbidden; then faults are counted */
  memset(stack, 1, sizeof stack);
  __asm__ volatile("" : : "r"(stack) : "memory");
}

static size_t faults_now(void) {
  struct rusage use;
  getrusage(RUSAGE_SELF, &use);
  return (size_t)(use.ru_minflt + use.ru_majflt);
}

/* The least time of this period so far. */
static double keep_least(tally *t, double took) {
  const size_t n = t->periods - 1;
  if (n >= t->room) {
    fail("too many periods", "");
  }
  t->time[n] = t->time[n] == 0 || took < (double)t->time[n] ? (float)took : t->time[n];
  return (double)t->time[n];
}

static void step(guard *g, const guard_input *in, guard_output *out, tally *t) {
  const bool stopped = out->feed_inhibit;
  const size_t before = allocations;
  const size_t faults = faults_now();
  const double begin = now();
  guard_step(g, in, out);
  const double took = now() - begin;
  t->allocated += allocations - before;
  t->faults += faults_now() - faults;
  t->periods++;
  if (out->state == GUARD_BLIND) {
    return;
  }
  const double least = keep_least(t, took);
  t->timed[out->in_tube]++;
  t->sum[out->in_tube] += least;
  t->worst[out->in_tube] = fmax(t->worst[out->in_tube], least);
  t->tube += out->in_tube;
  t->outside = t->outside == 0 && !out->in_tube ? t->periods : t->outside;
  t->slow += out->state == GUARD_SLOW;
  t->work = out->work > t->work ? out->work : t->work;
  t->toggles += stopped != out->feed_inhibit;
  if (out->state == GUARD_STOPPED && !stopped) {
    t->first = t->stops++ == 0 ? t->periods : t->first;
    t->reason = out->reason;
  }
}

static void print(const tally *t) {
  static const char *const MODE[] = {"free", "tube"};
  printf("periods %zu\nin_tube %zu\nslow %zu\nstops %zu\ntoggles %zu\n", t->periods, t->tube,
         t->slow, t->stops, t->toggles);
  for (int n = 0; n < 2; n++) {
    const double mean = t->timed[n] > 0 ? t->sum[n] / (double)t->timed[n] : 0;
    printf("%s_mean_us %.2f\n%s_worst_us %.1f\n", MODE[n], mean, MODE[n], t->worst[n]);
  }
  printf("most_work %llu\nallocations %zu\npage_faults %zu\n", (unsigned long long)t->work,
         t->allocated, t->faults);
  if (t->outside > 0) {
    printf("first_outside %zu\n", t->outside);
  }
  if (t->stops > 0) {
    printf("first_stop %zu\nreason %s\n", t->first, guard_reason_text(t->reason));
  }
}

/* ------------------------------------------------------------------ samples */

static bool sample(FILE *in, size_t joints, double *position) {
  char line[2048];
  char *at = line;
  if (fgets(line, sizeof line, in) == NULL) {
    return false;
  }
  for (size_t n = 0; n < joints; n++) {
    char *end = at;
    position[n] = strtod(at, &end);
    if (end == at) {
      fail("no number in a sample: ", at);
    }
    at = end + (*end == ',');
  }
  return true;
}

/* Adaptive feed: the motion of the samples at the rate that the guard asks for. The rate changes by
 * a fiftieth in a period, which at 50 mm/s is an acceleration of 1,000 mm/s^2. */
static double follow(double rate, double scale) {
  const double most = 0.02;
  const double target = scale > 0 ? scale : 1; /* a stop is not followed: it is a failure here */
  return rate + fmax(-most, fmin(most, target - rate));
}

static void replay(guard *g, guard_input *in, size_t joints, FILE *file, tally *t) {
  char head[2048];
  double before[GUARD_JOINTS_MOST] = {0};
  double after[GUARD_JOINTS_MOST] = {0};
  guard_output out = {.feed_scale = 1};
  if (fgets(head, sizeof head, file) == NULL || !sample(file, joints, after)) {
    fail("no samples", "");
  }
  double rate = 1;
  double part = 0;
  bool first = true;
  memcpy(before, after, sizeof before);
  for (bool more = true; more; rate = follow(rate, out.feed_scale)) {
    double square = 0;
    for (part += first ? 0 : rate; part >= 1 && more; part -= 1) {
      memcpy(before, after, sizeof before);
      more = sample(file, joints, after);
    }
    for (size_t n = 0; n < joints; n++) {
      const double position = before[n] + (after[n] - before[n]) * part;
      in->velocity[n] = first ? 0 : (position - in->position[n]) / PERIOD;
      in->position[n] = position;
      square += n < 3 ? in->velocity[n] * in->velocity[n] : 0;
    }
    in->speed = sqrt(square);
    first = false;
    step(g, in, &out, t);
  }
}

/* ------------------------------------------------------------------ random motion */

static uint64_t seed;

static double between(double low, double high) {
  seed = seed * 6364136223846793005u + 1442695040888963407u;
  return low + (high - low) * (double)(seed >> 11) * 0x1p-53;
}

/* A target for the next motion; often only one joint moves, and angles often are whole quarters, so
 * that faces are parallel. */
static void choose(const guard_settings *s, const guard_input *in, double *target) {
  const bool one = between(0, 1) < 0.5;
  const size_t only = (size_t)between(0, (double)s->joints);
  for (size_t n = 0; n < s->joints; n++) {
    const bool turns = strchr("ABC", s->axis[n]) != NULL;
    const double most = turns ? 90 : 150;
    target[n] = between(-most, most);
    if (turns && between(0, 1) < 0.7) {
      target[n] = 90 * floor(between(-1, 2));
    }
    target[n] = one && n != only ? in->position[n] : target[n];
  }
}

/* Each joint goes to its target and is there in time to stop; a stopped machine brakes. */
static bool advance(const guard_settings *s, guard_input *in, const double *target, bool stop,
                    double scale) {
  bool moves = false;
  double square = 0;
  for (size_t n = 0; n < s->joints; n++) {
    const double way = target[n] - in->position[n];
    const double a = in->acceleration[n] * PERIOD;
    const double brake = sqrt(fmax(0, 2 * in->acceleration[n] * fabs(way))) * 0.9;
    const double wish = stop ? 0 : copysign(fmin(in->fastest[n] * scale, brake), way);
    double v = in->velocity[n] + fmax(-a, fmin(a, wish - in->velocity[n]));
    v = fabs(way) < a * PERIOD && fabs(v) <= a ? way / PERIOD : v;
    in->velocity[n] = v;
    in->position[n] += v * PERIOD;
    moves = moves || v != 0;
    square += n < 3 ? v * v : 0;
  }
  in->speed = in->coordinated ? sqrt(square) : 0;
  return moves;
}

static void wander(guard *g, const guard_settings *s, guard_input *in, size_t periods, tally *t) {
  double target[GUARD_JOINTS_MOST] = {0};
  guard_output out = {.feed_scale = 1};
  size_t stood = 0;
  while (t->periods < periods) {
    const bool stop = in->coordinated ? out.feed_inhibit : out.jog_stop;
    const bool moves = advance(s, in, target, stop, out.feed_scale > 0 ? out.feed_scale : 1);
    stood = moves ? 0 : stood + 1;
    in->reset = false;
    if (!moves && (stood > 100 || out.state != GUARD_STOPPED)) {
      if (out.state == GUARD_STOPPED) { /* carried to another place */
        choose(s, in, in->position);
        in->homed = false;
        step(g, in, &out, t);
        in->homed = in->reset = true;
      }
      in->coordinated = between(0, 1) < 0.5;
      choose(s, in, target);
      stood = 0;
    }
    step(g, in, &out, t);
  }
}

/* ------------------------------------------------------------------ start */

static guard_settings settings_of(char **argument) {
  static char name[GUARD_JOINTS_MOST][2];
  guard_settings s = {.joints = strlen(argument[3]),
                      .unit = 0.001,
                      .clearance = strtod(argument[4], NULL) * 0.001,
                      .slow_zone = 0.1,
                      .slow_scale = 0.2,
                      .reaction = 10,
                      .brake = 0.2,
                      .work = GUARD_WORK};
  if (s.joints > GUARD_JOINTS_MOST) {
    fail("too many axes: ", argument[3]);
  }
  for (size_t n = 0; n < s.joints; n++) {
    s.axis[n] = argument[3][n];
    name[n][0] = (char)tolower((unsigned char)argument[3][n]);
    s.name[n] = name[n];
  }
  return s;
}

static const tube *tube_of(const guard *g, size_t joints, const char *path) {
  tube *t = NULL;
  if (strcmp(path, "-") != 0) {
    char text[TUBE_TEXT] = "";
    t = calloc(1, tube_size(joints, ROWS));
    if (t == NULL) {
      fail("out of memory", "");
    }
    guard_begin_tube(g, t, ROWS);
    if (!tube_read(t, path, text)) {
      fail(text, "");
    }
  }
  return t;
}

/* One run, counted in t, which keeps its times. */
static void run(char **argument, const guard_settings *s, tally *t) {
  char text[GUARD_TEXT] = "";
  const guard_tool tool = {-1, argument[1], strcmp(argument[2], "-") == 0 ? NULL : argument[2]};
  guard *g = guard_new(s, &tool, 1, text);
  if (g == NULL) {
    fail(text, "");
  }
  guard_input in = {.period = PERIOD, .coordinated = true, .homed = true};
  char *angular = NULL;
  const double acceleration = strtod(argument[5], &angular);
  for (size_t n = 0; n < s->joints; n++) {
    const bool turns = strchr("ABC", s->axis[n]) != NULL && *angular == ',';
    in.acceleration[n] = turns ? strtod(angular + 1, NULL) : acceleration;
    in.fastest[n] = strtod(argument[6], NULL);
  }
  *t = (tally){.time = t->time, .room = t->room};
  if (strcmp(argument[7], "samples") == 0) {
    FILE *file = fopen(argument[9], "r");
    if (file == NULL) {
      fail("cannot be opened: ", argument[9]);
    }
    guard_use_tube(g, tube_of(g, s->joints, argument[8]));
    replay(g, &in, s->joints, file, t);
    fclose(file);
  } else {
    seed = strtoull(argument[8], NULL, 10);
    wander(g, s, &in, strtoull(argument[9], NULL, 10), t);
  }
  guard_free(g);
}

int main(int count, char **argument) {
  tally t = {.room = 8000000};
  if (count != 10) {
    fail("give what the head of replay.c says", "");
  }
  lock_memory();
  const guard_settings s = settings_of(argument);
  t.time = calloc(t.room, sizeof *t.time);
  if (t.time == NULL) {
    fail("out of memory", "");
  }
  for (int n = 0; n < RUNS; n++) {
    run(argument, &s, &t);
  }
  print(&t);
  free(t.time);
  return 0;
}
