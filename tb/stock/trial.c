/* SPDX-License-Identifier: MIT */
/* trial.c - whole programs on the stock: what is proved of them, and is it true?
 *
 *   stock-trial three|shifted|ball|bull CELL
 *
 * `three` is the part in three axes, `shifted` the same with the faces of the part between the
 * faces of cells; `ball` and `bull` are the five-axis motion with a ball and with a bull nose.
 * Prints times, memory and how tight the bound is, and fails with status 1 if
 *   - a rapid, or the way of a feed gone back, is not free at a depth of two cells;
 *   - a corner of a cell that is gone is in the cutter at no pose of a feed, taken every 3 um;
 *   - a way that is deeper than two cells in a cell that is there is called free;
 *   - a holder 0.1 mm in the uncut top is called free, or one 0.2 mm above a cut away from it is
 * not;
 *   - the stock takes more than 64 MB with cells of 0.25 or more, or 256 MB. */
#include "stock/cells.h"
#include "stock/program.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define PI 0x1.921fb54442d18p1

enum { CORNER_CELLS = 400, PLANTS = 200, DEEP_CELLS = 3000 };

typedef struct {
  bool five;
  int cutter; /* in five axes */
  bool shifted;
  double cell;
  program made;
  mill tool[TOOLS];
  sepax__stock *stock;
  double seconds[2]; /* of cutting and of testing */
  int alarms, tests, wrong;
} trial;

static sepax_error fault;

/* Uniform in -1 ... 1, the same in every run; 0 ... count - 1. */
static double random_unit(void) {
  static uint64_t state = 1;
  state = state * 6364136223846793005U + 1442695040888963407U;
  return (double)(state >> 11) * 0x1p-52 - 1;
}
static int random_below(int count) { return (int)((random_unit() + 1) / 2 * count); }

static double cpu_seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static void must(bool ok) {
  if (!ok) {
    fprintf(stderr, "stock-trial: %s\n", fault.text);
    exit(2);
  }
}

static void complain(trial *t, const char *what, size_t line) {
  t->wrong++;
  printf("FAILED: %s (line %zu)\n", what, line);
}

/* ----------------------------------------------------------------- program */

/* A bull nose deviates as far as two cells allow (docs/reference/stock.md). */
static double tolerance_of(const trial *t) {
  return t->cutter == FIVE_AXIS_BULL && t->five ? t->cell / 10 : 0;
}

static void test_move(trial *t, const move *m, size_t line) {
  const mill *k = &t->tool[m->tool];
  const sepax__stock_shape both[2] = {k->flutes[1], k->shank[1]};
  sepax__stock_touch found;
  double start = cpu_seconds();
  must(sepax__stock_test(t->stock, both, t->five ? 1 : 2, WAY(m), 2 * t->cell, tolerance_of(t),
                         false, &found, &fault));
  t->seconds[1] += cpu_seconds() - start;
  t->tests++;
  if (!found.free) {
    t->alarms++;
    complain(t, "a way that is cut free touches at two cells", line);
  }
}

static void run(trial *t) {
  for (size_t n = 0; n < t->made.count; n++) {
    move *m = &t->made.line[n];
    m->reach = t->five ? hypot(2, 8) : 40;
    if (m->rapid) {
      test_move(t, m, n);
      continue;
    }
    double start = cpu_seconds();
    must(sepax__stock_cut(t->stock, &t->tool[m->tool].flutes[0], 1, WAY(m), tolerance_of(t),
                          &fault));
    t->seconds[0] += cpu_seconds() - start;
    move back = *m;
    back.from = m->to;
    back.to = m->from;
    if (t->five || n % 7 == 0) {
      test_move(t, &back, n);
    }
  }
}

/* ------------------------------------------------------------- brute force */

/* How far a point is beyond the flutes of a move at a stand. */
static double beyond_stand(const mill *k, int tool, const stand *at, const double p[3]) {
  sepax_pose pose = pose_of(at);
  double q[3] = {0, 0, 0};
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      q[i] += pose.rotation[j][i] * (p[j] - pose.translation[j]);
    }
  }
  double rho = hypot(q[0], q[1]);
  double c = k->round;
  double beyond = fmax(rho - k->radius, q[2] - k->flutes[0].high);
  if (c > 0 && rho > k->radius - c && q[2] < c) {
    return fmax(beyond, hypot(rho - (k->radius - c), c - q[2]) - c);
  }
  double slope = tool == 1 ? 59 * PI / 180 : PI / 2;
  return fmax(beyond, rho * cos(slope) - q[2] * sin(slope));
}

static bool is_far(const move *m, double reach, const double p[3]) {
  for (int i = 0; i < 3; i++) {
    if (p[i] < fmin(m->from.tip[i], m->to.tip[i]) - reach ||
        p[i] > fmax(m->from.tip[i], m->to.tip[i]) + reach) {
      return true;
    }
  }
  return false;
}

/* The least distance beyond the cutter over poses of all feeds, no point of the flutes moving more
 * than `step` from one to the next; ends at `until`. */
static double beyond_program(const trial *t, const double p[3], double step, double until) {
  double least = INFINITY;
  for (size_t n = 0; n < t->made.count && least > until; n++) {
    const move *m = &t->made.line[n];
    const mill *k = &t->tool[m->tool];
    double reach = hypot(k->radius, k->flutes[0].high);
    if (m->rapid || is_far(m, reach, p)) {
      continue;
    }
    double way = (fabs(m->to.a - m->from.a) + fabs(m->to.c - m->from.c)) * reach;
    double square = 0;
    for (int i = 0; i < 3; i++) {
      square += (m->to.tip[i] - m->from.tip[i]) * (m->to.tip[i] - m->from.tip[i]);
    }
    int count = 1 + (int)((way + sqrt(square)) / step);
    for (int i = 0; i <= count && least > until; i++) {
      stand at = stand_between(m, (double)i / count);
      double beyond = beyond_stand(k, m->tool, &at, p);
      least = fmin(least, beyond);
      /* no pose nearer than this can be in it */
      i += (int)fmax(0, (beyond - fmax(until, 0)) / step - 1);
    }
  }
  return least;
}

static void draw_cell(const sepax__stock_facts *f, int cell[3]) {
  for (int i = 0; i < 3; i++) {
    cell[i] = random_below(cells_along(f, i));
  }
}

static void check_corners(trial *t, const sepax__stock *first) {
  sepax__stock_facts f = sepax__stock_look(t->stock);
  double worst = -INFINITY;
  for (int found = 0; found < CORNER_CELLS;) {
    int at[3];
    draw_cell(&f, at);
    if (has_cell(t->stock, &f, at) || !has_cell(first, &f, at) || !is_border(t->stock, &f, at)) {
      continue;
    }
    found++;
    for (int n = 0; n < 8; n++) {
      double p[3];
      cell_point(&f, at, (const double[]){n & 1, n >> 1 & 1, n >> 2}, p);
      double beyond = beyond_program(t, p, 0.003, 0);
      worst = fmax(worst, beyond);
      if (beyond > 0) {
        complain(t, "a cell is gone that was not cut", 0);
      }
    }
  }
  printf("  %d cells that are gone: every corner was cut\n", CORNER_CELLS);
}

static void look_at_depths(const trial *t) {
  sepax__stock_facts f = sepax__stock_look(t->stock);
  double most = 0;
  double sum = 0;
  for (int found = 0; found < DEEP_CELLS;) {
    int at[3];
    double p[3];
    draw_cell(&f, at);
    if (!has_cell(t->stock, &f, at) || !is_border(t->stock, &f, at)) {
      continue;
    }
    cell_point(&f, at, (const double[]){0.5, 0.5, 0.5}, p);
    double depth = -beyond_program(t, p, t->cell / 8, -INFINITY) / t->cell;
    found++;
    sum += fmax(depth, 0);
    most = fmax(most, depth);
  }
  printf("  middles of %d border cells that stay: %.3f cells deep at most, %.3f on average\n",
         DEEP_CELLS, most, sum / DEEP_CELLS);
}

/* ------------------------------------------------------------------ faults */

/* Rapids that have the middle of a cell that is there deeper than two cells, somewhere. */
static void plant_rapids(trial *t) {
  sepax__stock_facts f = sepax__stock_look(t->stock);
  for (int found = 0; found < PLANTS;) {
    int at[3];
    double p[3];
    draw_cell(&f, at);
    if (!has_cell(t->stock, &f, at) || (found % 2 == 0 && !is_border(t->stock, &f, at))) {
      continue;
    }
    cell_point(&f, at, (const double[]){0.5, 0.5, 0.5}, p);
    int tool = t->five ? t->cutter : found % 3;
    const mill *k = &t->tool[tool];
    stand there = {.a = t->five ? PI * random_unit() : 0, .c = t->five ? PI * random_unit() : 0};
    sepax_pose pose = pose_of(&there);
    double z = k->radius + (k->flutes[0].high - 2 * k->radius) * 0.5 * (1 + random_unit());
    double rho = (k->radius - 2 * t->cell) * 0.999 * random_unit();
    for (int i = 0; i < 3; i++) {
      there.tip[i] = p[i] - z * pose.rotation[i][2] - rho * pose.rotation[i][found % 2];
    }
    if (beyond_stand(k, tool, &there, p) > -2 * t->cell) {
      continue;
    }
    move m = {.rapid = true, .tool = tool, .from = there, .to = there, .reach = 40};
    double part = 0.5 + 0.4 * random_unit();
    for (int i = 0; i < 3; i++) {
      double way = 10 * random_unit();
      m.from.tip[i] -= part * way;
      m.to.tip[i] += (1 - part) * way;
    }
    double turn = t->five ? 0.3 * random_unit() : 0;
    m.from.a -= part * turn;
    m.to.a += (1 - part) * turn;
    sepax__stock_touch touched;
    must(sepax__stock_test(t->stock, &k->flutes[1], 1, WAY(&m), 2 * t->cell, 0, false, &touched,
                           &fault));
    found++;
    if (touched.free) {
      complain(t, "a planted rapid deeper than two cells is called free", 0);
    }
  }
}

/* Rapids along the uncut side of the part, which is the end of the grid, a little deeper than two
 * cells in it. */
static void plant_grazes(trial *t) {
  for (int n = 0; n < PLANTS && !t->five; n++) {
    const mill *k = &t->tool[n % 2 == 0 ? 0 : 2];
    double deep = 2 * t->cell * (1.15 + 0.14 * random_unit());
    stand at = {.tip = {deep - k->radius, 20 + 10 * random_unit(), -10 + 5 * random_unit()}};
    move m = {.rapid = true, .from = at, .to = at, .reach = 40};
    m.to.tip[1] += 10;
    m.to.tip[2] += random_unit();
    sepax__stock_touch touched;
    must(sepax__stock_test(t->stock, &k->flutes[1], 1, WAY(&m), 2 * t->cell, 0, false, &touched,
                           &fault));
    if (touched.free) {
      complain(t, "a rapid that rubs deeper than two cells is called free", (size_t)n);
    }
  }
}

/* The holder over the uncut corner of the part, far from all cuts. */
static void plant_holders(trial *t) {
  for (int n = 0; n < PLANTS && !t->five; n++) {
    double low = n % 2 == 0 ? -0.1 : 0.2;
    stand at = {.tip = {70 + 5 * random_unit(), 8 + 4 * random_unit(), low - 35}};
    move m = {.from = at, .to = at, .reach = 45};
    m.to.tip[0] += 4 * random_unit();
    sepax__stock_touch touched;
    must(sepax__stock_test(t->stock, &t->tool[0].holder[1], 1, WAY(&m), 0, 0, false, &touched,
                           &fault));
    if (touched.free != (low > 0)) {
      complain(t, "a holder 0.1 mm low is called free, or one 0.2 mm above is not", (size_t)n);
    }
  }
}

/* ------------------------------------------------------------------- frame */

static sepax__stock *first_stock(const trial *t) {
  sepax__stock *s;
  double box[2][3];
  for (int i = 0; i < 3; i++) {
    box[0][i] = (t->five ? cone_box : part_box)[0][i] - (t->shifted ? 0.37 * t->cell : 0);
    box[1][i] = (t->five ? cone_box : part_box)[1][i];
  }
  must(sepax__stock_new(&s, SEPAX__STOCK_OUTER, box, t->cell, &fault));
  if (!t->five) {
    must(sepax__stock_fill_box(s, part_box, &fault));
    return s;
  }
  const sepax_pose still = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};
  sepax__stock_shape cone[2];
  must(sepax__stock_shape_make(cone_profile, 4, 1, &cone[0], &cone[1], &fault));
  must(sepax__stock_fill_shape(s, &cone[1], &still, &fault));
  return s;
}

int main(int argc, char **argv) {
  trial t = {.cell = argc == 3 ? strtod(argv[2], NULL) : 0};
  bool bull = argc == 3 && strcmp(argv[1], "bull") == 0;
  t.cutter = bull ? FIVE_AXIS_BULL : FIVE_AXIS_BALL;
  t.five = bull || (argc == 3 && strcmp(argv[1], "ball") == 0);
  t.shifted = argc == 3 && strcmp(argv[1], "shifted") == 0;
  if (argc != 3 || (!t.five && !t.shifted && strcmp(argv[1], "three") != 0) || !(t.cell >= 0.02)) {
    fprintf(stderr, "usage: stock-trial three|shifted|ball|bull CELL\n");
    return 2;
  }
  make_tools(t.tool, t.cell / 256);
  t.made = t.five ? five_axis_part(t.cutter) : three_axis_part();
  t.stock = first_stock(&t);
  sepax__stock *first = first_stock(&t);
  run(&t);
  sepax__stock_facts f = sepax__stock_look(t.stock);
  printf("%s, cells of %g: %zu lines, cut in %.2f s, %d ways tested in %.2f s, %.1f MB\n", argv[1],
         t.cell, t.made.count, t.seconds[0], t.tests, t.seconds[1], (double)f.bytes / 1e6);
  printf("  false alarms at two cells: %d\n", t.alarms);
  if ((double)f.bytes > (t.cell >= 0.25 ? 64e6 : 256e6)) {
    complain(&t, "too much memory", 0);
  }
  check_corners(&t, first);
  look_at_depths(&t);
  plant_rapids(&t);
  plant_grazes(&t);
  plant_holders(&t);
  printf("  %d planted rapids%s\n", PLANTS, t.five ? "" : ", as many that rub, as many holders");
  sepax__stock_free(first);
  sepax__stock_free(t.stock);
  free_program(&t.made);
  printf("%d wrong\n", t.wrong);
  return t.wrong > 0;
}
