/* SPDX-License-Identifier: MIT */
/* deviations.c - the true joints of a motion stay within the deviations of its rows, by dense
 * sampling in wide numbers; and the deviations are not much larger than that. */
#include "streams.h"

enum { SAMPLES = 24 };

/* What was found in all rows that were looked at. */
static struct {
  wide worst;   /* the largest share of a deviation that is reached */
  wide sum;     /* of deviations over what is reached, where that is no rounding */
  size_t count; /* of these */
  size_t rows;
} found;

static const char *const machines[] = {"trivkins", "xyzac-trt-kins", "xyzbc-trt-kins", "5axiskins"};
static const char *const letters_of[] = {"XYZABCUVW", "XYZAC", "XYZBC", "XYZBCW"};

static mill random_machine(int n) {
  mill m = {.module = "IABM"[n]};
  for (int i = 0; i < 3; i++) {
    m.point[i] = 300 * random_unit();
    m.offset[i] = 100 * random_unit();
  }
  m.tool = 80 * random_unit();
  m.pivot = 250 + 200 * random_unit();
  return m;
}

static void put_machine(stream *t, int n, const mill *m, const double start[NC_AXES]) {
  char parameters[1024] = "";
  if (n == 3) {
    snprintf(parameters, sizeof parameters, "parameter pivot-length %.17g\n", m->pivot);
  } else if (n > 0) {
    snprintf(parameters, sizeof parameters,
             "parameter x-rot-point %.17g\nparameter y-rot-point %.17g\n"
             "parameter z-rot-point %.17g\nparameter x-offset %.17g\nparameter y-offset %.17g\n"
             "parameter z-offset %.17g\nparameter tool-offset %.17g\n",
             m->point[0], m->point[1], m->point[2], m->offset[0], m->offset[1], m->offset[2],
             m->tool);
  }
  put_head(t, machines[n], parameters, letters_of[n], 1e8, start);
}

/* Compare a row with its motion: samples between the share of the row before and its own. */
static void look_at_row(const nc_motion *rows, size_t row, const mill *m, const motion *way,
                        const char *letters, double before) {
  const double *a = &rows->value[(row - 1) * rows->joints], *b = a + rows->joints;
  const double *off = &rows->deviation[row * rows->joints];
  wide reached[NC_JOINTS_MOST] = {0};
  for (int k = 0; k <= SAMPLES; k++) {
    wide part = (wide)k / SAMPLES, axis[NC_AXES], joint[NC_JOINTS_MOST];
    wide_way(way, before + (rows->row[row].share - (wide)before) * part, axis);
    wide_metric(m, letters, axis, joint);
    for (size_t j = 0; j < rows->joints; j++) {
      wide line = a[j] + ((wide)b[j] - a[j]) * part;
      reached[j] = fmaxl(reached[j], fabsl(joint[j] - line));
    }
  }
  for (size_t j = 0; j < rows->joints; j++) {
    if (!(reached[j] <= off[j])) {
      fail_msg("row %zu, joint %zu: %Lg is beyond the deviation of %g", row, j, reached[j], off[j]);
    }
    if (off[j] > 0) {
      found.worst = fmaxl(found.worst, reached[j] / off[j]);
    }
    if (reached[j] > 1e-8L) {
      found.sum += off[j] / reached[j];
      found.count++;
    }
  }
  found.rows++;
}

static void look_at(int n, const mill *m, const motion *way, double tolerance) {
  stream t;
  text_begin(&t);
  nc_motion rows;
  put_machine(&t, n, m, way->from);
  if (way->arc) {
    put_arc(&t, 1, way->to, way->centre, way->normal, way->turns);
  } else {
    put_move(&t, "feed", 1, way->to);
  }
  fprintf(t.out, "end 0 2\n");
  assert_works(text_read(&t, &rows, &(nc_rules){.linear = tolerance, .angular = tolerance}));
  assert_true(rows.rows >= 2 && rows.row[0].begins == NC_FIRST);
  assert_true(rows.row[rows.rows - 1].share == 1);
  for (size_t row = 1; row < rows.rows; row++) {
    assert_true(rows.row[row].share > rows.row[row - 1].share);
    look_at_row(&rows, row, m, way, letters_of[n], rows.row[row - 1].share);
    for (size_t j = 0; j < rows.joints && !way->arc; j++) {
      assert_true(rows.deviation[row * rows.joints + j] <= 1.001 * tolerance + 1e-11);
    }
  }
  nc_motion_free(&rows);
}

/* ---------------------------------------------------------------------------- motions */

/* Axes without a joint must rest, or their motion would be nowhere. */
static void keep_joints(int n, motion *way) {
  for (int i = 0; i < NC_AXES; i++) {
    if (strchr(letters_of[n], nc_letter(i)) == NULL) {
      way->from[i] = way->to[i] = 0;
    }
  }
}

static motion random_motion(int n, double length, double angle) {
  motion way = {0};
  for (int i = 0; i < NC_AXES; i++) {
    bool angular = i >= NC_A && i <= NC_C;
    way.from[i] = (angular ? 200 : 300) * random_unit();
    way.to[i] = way.from[i] + (angular ? angle : length) * random_unit();
  }
  keep_joints(n, &way);
  return way;
}

/* An arc from the start of the motion: around a random centre, in a random plane or one of the
 * axes' planes, a helix or not, a spiral by LinuxCNC's tolerance or not. */
static motion random_arc(int n, double radius, double angle, double uneven) {
  motion way = random_motion(n, 0, angle);
  int about = random_below(4);
  double normal[3] = {random_unit(), random_unit(), random_unit()}, u[3], v[3];
  for (int i = 0; i < 3 && about < 3; i++) {
    normal[i] = i == about ? (random_below(2) == 0 ? 1 : -1) : 0;
  }
  double size = sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
  int least = about < 3 ? (about + 1) % 3 : 0;
  for (int i = 0; i < 3; i++) {
    way.normal[i] = normal[i] / size;
  }
  for (int i = 0; i < 3; i++) {
    u[i] = (i == least) - way.normal[least] * way.normal[i];
  }
  size = sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
  for (int i = 0; i < 3; i++) {
    u[i] *= radius / size;
  }
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3, k = (i + 2) % 3;
    v[i] = way.normal[j] * u[k] - way.normal[k] * u[j];
  }
  bool whole = random_below(4) == 0;
  double turn = whole ? 0 : PI * random_unit(),
         rise = random_below(2) == 0 ? 0 : 30 * random_unit();
  double grow = random_below(2) == 0 ? 1 : 1 + uneven * random_unit();
  for (int i = 0; i < 3; i++) {
    way.centre[i] = way.from[i] - u[i];
    way.to[i] = way.centre[i] + grow * (cos(turn) * u[i] + sin(turn) * v[i]) + rise * way.normal[i];
  }
  if (whole && grow == 1 && rise == 0) {
    memcpy(way.to, way.from, 3 * sizeof *way.to);
  }
  way.arc = true;
  way.turns = random_below(3) == 0 ? random_below(4) : 0;
  return way;
}

static void begin_finding(void) { memset(&found, 0, sizeof found); }

/* The deviations are reached nearly, so smaller ones would not hold; in the mean they are at most
 * `mean` times what is reached. */
static void assert_tight(double mean) {
  print_message("%zu rows: worst %.4Lf of the deviation, mean of deviation / reached %.3Lf\n",
                found.rows, found.worst, found.sum / (wide)found.count);
  assert_true(found.rows > 0 && found.count > 0);
  assert_true(found.worst > 0.9L);
  assert_true(found.sum / (wide)found.count < mean);
}

CASE(test_straight) {
  begin_finding();
  for (int n = 0; n < FEWER(120); n++) {
    int kind = 1 + n % 3;
    mill m = random_machine(kind);
    double size = pow(10, 3 * random_unit());
    motion way = random_motion(kind, fmin(size, 300), fmin(10 * size, 90));
    look_at(kind, &m, &way, pow(10, -6 + random_unit()));
  }
  assert_tight(2);
}

CASE(test_arcs) {
  begin_finding();
  for (int n = 0; n < FEWER(120); n++) {
    int kind = n % 4;
    mill m = random_machine(kind);
    motion way = random_arc(kind, pow(10, 2 * random_unit()), 60, 0);
    look_at(kind, &m, &way, pow(10, -6 + random_unit()));
  }
  assert_tight(2);
}

/* The radii of the ends differ within LinuxCNC's tolerance. The bound of the slip is twice what the
 * proof needs, and holds in both directions. */
CASE(test_spirals) {
  begin_finding();
  for (int n = 0; n < FEWER(80); n++) {
    int kind = n % 4;
    mill m = random_machine(kind);
    motion way = random_arc(kind, pow(10, 2 * random_unit()), 60, 1e-5);
    look_at(kind, &m, &way, 1e-6);
  }
  assert_tight(4);
}

/* Tiny arcs, and arcs whose other axes run ahead because the radius changes much. */
CASE(test_small_and_uneven_arcs) {
  begin_finding();
  for (int n = 0; n < FEWER(80); n++) {
    int kind = n % 4;
    mill m = random_machine(kind);
    motion way = random_arc(kind, n % 2 == 0 ? 1e-3 : 20, n % 2 == 0 ? 1e-3 : 30, 1e-2);
    if (n % 2 == 1 && fabs(way.to[0] - way.centre[0]) + fabs(way.to[1] - way.centre[1]) > 1) {
      for (int i = 0; i < 3; i++) {
        way.to[i] = way.centre[i] + 1.3 * (way.to[i] - way.centre[i]);
      }
    }
    look_at(kind, &m, &way, 1e-6);
  }
  print_message("%zu rows: worst %.4Lf of the deviation\n", found.rows, found.worst);
  assert_true(found.rows > 0 && found.worst > 0.5L);
}

/* Motions that are chosen to be hard, with each kinematics. */
CASE(test_chosen) {
  static const double pairs[][2][NC_AXES] = {
      {{100, 0, 0, -90, -90, 0}, {100, 0, 0, 90, 90, 0}},    /* through 0, a half turn */
      {{0, 0, 0, 80, 80, 0}, {0, 0, 0, 100, 100, 0}},        /* through 90 degrees */
      {{1e-3, 0, 0, 0, 0, 0}, {1e-3, 1e-6, 0, 0, 0, 720}},   /* C by 720 at a tiny radius */
      {{300, 200, 50, 0, 0, 0}, {-300, 200, 60, 0, 0, 720}}, /* C by 720, far from its axis */
      {{5000, -4000, 3000, 10, 10, 10}, {-5000, 4000, 3000, 50, 50, -300}}, /* large offsets */
      {{0, 0, 0, 0, 0, 0}, {1e-7, 0, 0, 1e-7, 1e-7, 1e-7}},                 /* hardly any way */
      {{10, 0, 0, 0, 0, 0}, {10, 0, 0, 0, 1e-9, 179.999999}}, /* near the singular position */
      {{10, 10, 10, 0, 0, 36000}, {10, 10, 10, 0, 0, 36090}}, /* after 100 turns */
      {{10, 20, 30, 40, 50, 60}, {10, 20, 30, 40, 50, 61}},   /* only C */
      {{10, 20, 30, 40, 50, 60}, {10, 20, 31, 40, 50, 60}},   /* only Z, tilted */
  };
  begin_finding();
  for (size_t n = 0; n < LENGTH(pairs); n++) {
    for (int kind = 0; kind < 4; kind++) {
      mill m = random_machine(kind);
      motion way = {0};
      memcpy(way.from, pairs[n][0], sizeof way.from);
      memcpy(way.to, pairs[n][1], sizeof way.to);
      keep_joints(kind, &way);
      look_at(kind, &m, &way, 1e-6);
    }
  }
  assert_tight(2);
}

/* A straight motion of a machine without turns is one row, and its deviation is rounding. */
CASE(test_identity) {
  for (int n = 0; n < FEWER(80); n++) {
    mill m = random_machine(0);
    motion way = random_motion(0, 300, 720);
    stream t;
    text_begin(&t);
    nc_motion rows;
    put_machine(&t, 0, &m, way.from);
    put_move(&t, "rapid", 1, way.to);
    fprintf(t.out, "end 0 2\n");
    assert_works(text_read(&t, &rows, NULL));
    assert_int_equal(rows.rows, 2);
    for (size_t j = 0; j < rows.joints; j++) {
      assert_true(rows.deviation[rows.joints + j] < 1e-13);
    }
    look_at_row(&rows, 1, &m, &way, letters_of[0], 0);
    nc_motion_free(&rows);
  }
}
