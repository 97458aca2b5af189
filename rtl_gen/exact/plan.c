/* exact_plan.c - the exact datapath as operations, and their places in time. */
#include "exact.h"

#include "util/error.h"
#include "sepax_design.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static int mod3(int i) { return (i % 3 + 3) % 3; }

int exact_cross_strip(int a, int b) { return 6 + 3 * mod3(b - a) + mod3(a); }
int exact_edge_area(int i, int b) { return 3 * mod3(b - i) + mod3(i); }
int exact_vertex_area(int a, int j) { return 9 + 3 * mod3(j - a) + mod3(a); }
int exact_between(int i, int j) { return 3 * mod3(j - i) + mod3(i); }

int exact_units(const exact_plan *p, exact_class_id id) {
  int ii = p->design->config.ii;
  return (p->class[id].operations + ii - 1) / ii;
}

int exact_slots(const exact_plan *p, exact_class_id id, int unit) {
  int ii = p->design->config.ii;
  int left = p->class[id].operations - unit * ii;
  return left < ii ? left : ii;
}

/* At II = 3 the areas of A_c and edge c + 2 of B begin with c = 1, so that all areas can
 * start before the last strip is there; and so do the volumes over B. */
static int turn_by(const exact_plan *p, exact_class_id id, int orbit) {
  bool area = id == EXACT_BEYOND_XY || id == EXACT_BEYOND_YZ || id == EXACT_BEYOND_ZX ||
              id == EXACT_AREA || id == EXACT_AREA_YZ || id == EXACT_AREA_ZX ||
              id == EXACT_AREA_SIGN || id == EXACT_WEIGHT || id == EXACT_ORDER_Z ||
              id == EXACT_PRISM;
  return p->running && ((area && orbit == 5) || id == EXACT_ABOVE_B);
}

int exact_operation(const exact_plan *p, exact_class_id id, int unit, int slot) {
  int place = unit * p->design->config.ii + slot;
  int orbit = place / 3;
  return 3 * orbit + mod3(place + turn_by(p, id, orbit));
}

schedule_value exact_value(const exact_plan *p, exact_class_id id, int operation) {
  int ii = p->design->config.ii;
  if (id == EXACT_ABOVE_A && p->running) {
    return (schedule_value){p->class[id].stream + mod3(operation + 1), 2};
  }
  int orbit = operation / 3;
  int place = 3 * orbit + mod3(operation - turn_by(p, id, orbit));
  return (schedule_value){p->class[id].stream + place / ii, place % ii};
}

int exact_z_bank(const exact_plan *p, int cycle) {
  for (int bank = 0; bank < p->z_banks; bank++) {
    if (cycle < p->z_bank[bank] + p->design->config.ii) {
      return bank;
    }
  }
  abort(); /* z is read when no bank has it any more */
}

/* ------------------------------------------------------------------- operations */

exact_class_id exact_projected(exact_class_id of_xy, int projection) {
  static const exact_class_id other[][3] = {{EXACT_STRIP, EXACT_STRIP_YZ, EXACT_STRIP_ZX},
                                            {EXACT_AREA, EXACT_AREA_YZ, EXACT_AREA_ZX},
                                            {EXACT_OWN, EXACT_OWN_YZ, EXACT_OWN_ZX},
                                            {EXACT_CROSS_XY, EXACT_CROSS_YZ, EXACT_CROSS_ZX},
                                            {EXACT_BEYOND_XY, EXACT_BEYOND_YZ, EXACT_BEYOND_ZX},
                                            {EXACT_EDGE_XY, EXACT_EDGE_YZ, EXACT_EDGE_ZX}};
  for (size_t i = 0; i < sizeof other / sizeof other[0]; i++) {
    if (other[i][0] == of_xy) {
      return other[i][projection];
    }
  }
  abort(); /* there is one of it only */
}

const char *exact_projection_name(int projection) {
  static const char *const name[] = {"xy", "yz", "zx"};
  return name[projection];
}

/* Which projection a class is of. */
static int projection_of(exact_class_id id) {
  switch (id) {
  case EXACT_AREA_YZ:
  case EXACT_OWN_YZ:
  case EXACT_CROSS_YZ:
  case EXACT_BEYOND_YZ:
  case EXACT_EDGE_YZ:
    return 1;
  case EXACT_AREA_ZX:
  case EXACT_OWN_ZX:
  case EXACT_CROSS_ZX:
  case EXACT_BEYOND_ZX:
  case EXACT_EDGE_ZX:
    return 2;
  default:
    return 0;
  }
}

static int area_operands(const exact_plan *p, exact_class_id strip, int operation,
                         schedule_value v[EXACT_TERMS]) {
  int r = operation % 9 / 3;
  int c = operation % 3;
  if (operation < 9) { /* t(A_c A_c+1) + t(A_c+1 B) - t(A_c B) */
    v[0] = exact_value(p, strip, c);
    v[1] = exact_value(p, strip, exact_cross_strip(c + 1, c + r));
    v[2] = exact_value(p, strip, exact_cross_strip(c, c + r));
  } else { /* t(B_j B_j+1) + t(A B_j) - t(A B_j+1) */
    v[0] = exact_value(p, strip, 3 + mod3(c + r));
    v[1] = exact_value(p, strip, exact_cross_strip(c, c + r));
    v[2] = exact_value(p, strip, exact_cross_strip(c, c + r + 1));
  }
  return 3;
}

static int between_operands(const exact_plan *p, int operation, schedule_value v[EXACT_TERMS]) {
  int i = operation % 3;
  int j = i + operation / 3;
  v[0] = exact_value(p, EXACT_PRISM, exact_vertex_area(i + 1, j));
  v[1] = exact_value(p, EXACT_PRISM, exact_edge_area(i, j + 1));
  v[2] = exact_value(p, EXACT_PRISM, exact_vertex_area(i, j));
  v[3] = exact_value(p, EXACT_PRISM, exact_edge_area(i, j));
  return 4;
}

/* An area, and the limit of its edge that is not between both triangles. */
static int beyond_operands(const exact_plan *p, int projection, int operation,
                           schedule_value v[EXACT_TERMS]) {
  int c = operation % 3;
  v[0] = exact_value(p, exact_projected(EXACT_AREA, projection), operation);
  v[1] = exact_value(p, EXACT_EDGE_LIMIT, operation < 9 ? c : 3 + mod3(c + operation % 9 / 3));
  return 2;
}

/* What was found of the areas of an edge and the vertices of the other triangle; the area of its
 * own triangle. */
static int edge_operands(const exact_plan *p, int projection, int operation,
                         schedule_value v[EXACT_TERMS]) {
  exact_class_id area = exact_projected(EXACT_BEYOND_XY, projection);
  int i = operation % 3;
  for (int k = 0; k < 3; k++) { /* by orbit, so that a turn changes no operand's unit */
    v[k] = exact_value(p, area,
                       operation < 3 ? exact_edge_area(i, i + k) : exact_vertex_area(i - k, i));
  }
  v[3] = exact_value(p, exact_projected(EXACT_OWN, projection), operation < 3 ? 1 : 0);
  return 4;
}

static int cross_operands(const exact_plan *p, int projection, int operation,
                          schedule_value v[EXACT_TERMS]) {
  exact_class_id area = exact_projected(EXACT_AREA, projection);
  int i = operation % 3;
  int j = i + operation / 3;
  v[0] = exact_value(p, area, exact_edge_area(i, j + 1));
  v[1] = exact_value(p, area, exact_edge_area(i, j));
  return 2;
}

static int clear_operands(const exact_plan *p, exact_class_id id, int operation,
                          schedule_value v[EXACT_TERMS]) {
  switch (id) {
  case EXACT_CROSS_XY:
  case EXACT_CROSS_YZ:
  case EXACT_CROSS_ZX:
    return cross_operands(p, projection_of(id), operation, v);
  case EXACT_LIMIT:
  case EXACT_OWN_LIMIT:
    for (int k = 0; k < 3; k++) {
      v[k] = exact_value(p, exact_projected(id == EXACT_LIMIT ? EXACT_CROSS_XY : EXACT_OWN, k),
                         operation);
    }
    return 3;
  case EXACT_BEYOND_XY:
  case EXACT_BEYOND_YZ:
  case EXACT_BEYOND_ZX:
    return beyond_operands(p, projection_of(id), operation, v);
  case EXACT_EDGE_XY:
  case EXACT_EDGE_YZ:
  case EXACT_EDGE_ZX:
    return edge_operands(p, projection_of(id), operation, v);
  case EXACT_FAR_A:
    v[0] = exact_value(p, EXACT_ABOVE_A, operation);
    v[1] = exact_value(p, EXACT_OWN_LIMIT, 1);
    return 2;
  case EXACT_FAR_B:
    v[0] = exact_value(p, EXACT_ABOVE_B, operation);
    v[1] = exact_value(p, EXACT_OWN_LIMIT, 0);
    return 2;
  case EXACT_FAR_BETWEEN:
    v[0] = exact_value(p, EXACT_BETWEEN, operation);
    v[1] = exact_value(p, EXACT_LIMIT, operation);
    return 2;
  case EXACT_SLOPE_A:
  case EXACT_SLOPE_B:
    v[0] = exact_value(p, id == EXACT_SLOPE_A ? EXACT_ABOVE_A : EXACT_ABOVE_B, operation);
    v[1] = exact_value(p, id == EXACT_SLOPE_A ? EXACT_ABOVE_A : EXACT_ABOVE_B, mod3(operation + 1));
    return 2;
  default:
    return 0;
  }
}

int exact_operands(const exact_plan *p, exact_class_id id, int operation,
                   schedule_value v[EXACT_TERMS]) {
  switch (id) {
  case EXACT_AREA:
  case EXACT_AREA_YZ:
  case EXACT_AREA_ZX:
    return area_operands(p, exact_projected(EXACT_STRIP, projection_of(id)), operation, v);
  case EXACT_OWN: /* operation 0: B, 1: A */
  case EXACT_OWN_YZ:
  case EXACT_OWN_ZX:
    for (int c = 0; c < 3; c++) {
      v[c] = exact_value(p, exact_projected(EXACT_STRIP, projection_of(id)),
                         operation == 0 ? 3 + c : c);
    }
    return 3;
  case EXACT_PRISM:
    v[0] = exact_value(p, EXACT_AREA, operation);
    v[1] = exact_value(p, EXACT_WEIGHT, operation);
    return 2;
  case EXACT_OWN_PRISM:
    v[0] = exact_value(p, EXACT_OWN, 0);
    v[1] = exact_value(p, EXACT_OWN_WEIGHT, 0);
    return 2;
  case EXACT_ABOVE_A: /* by orbit, so that a turn changes no operand's unit */
    for (int r = 0; r < 3; r++) {
      v[r] = exact_value(p, EXACT_PRISM, exact_edge_area(operation - r, operation));
    }
    return 3;
  case EXACT_ABOVE_B:
    for (int r = 0; r < 3; r++) {
      v[r] = exact_value(p, EXACT_PRISM, exact_vertex_area(operation, operation + r));
    }
    v[3] = exact_value(p, EXACT_OWN_PRISM, 0);
    return 4;
  case EXACT_BETWEEN:
    return between_operands(p, operation, v);
  default:
    return clear_operands(p, id, operation, v);
  }
}

/* ------------------------------------------------------------------------ names */

static void vertex(char text[8], int v) { snprintf(text, 8, "%c%d", "ab"[v / 3], v % 3 + 1); }

static void label_of(exact_class_id id, int operation, char text[EMIT_NAME]) {
  char part[4][8] = {"", "", "", ""};
  int c = operation % 3;
  int r = operation % 9 / 3;
  switch (id) {
  case EXACT_STRIP:
  case EXACT_ORDER_X:
  case EXACT_STRIP_YZ:
  case EXACT_STRIP_ZX:
  case EXACT_EDGE_LIMIT:
  case EXACT_EDGE_XY:
  case EXACT_EDGE_YZ:
  case EXACT_EDGE_ZX:
    if (operation < 6) {
      vertex(part[0], operation);
      vertex(part[1], operation < 3 ? mod3(c + 1) : 3 + mod3(c + 1));
    } else {
      vertex(part[0], c);
      vertex(part[1], 3 + mod3(c + operation / 3 - 2));
    }
    break;
  case EXACT_AREA:
  case EXACT_AREA_YZ:
  case EXACT_AREA_ZX:
  case EXACT_BEYOND_XY:
  case EXACT_BEYOND_YZ:
  case EXACT_BEYOND_ZX:
  case EXACT_AREA_SIGN:
  case EXACT_WEIGHT:
  case EXACT_ORDER_Z:
  case EXACT_PRISM:
    vertex(part[0], c);
    if (operation < 9) {
      vertex(part[1], mod3(c + 1));
      vertex(part[2], 3 + mod3(c + r));
    } else {
      vertex(part[1], 3 + mod3(c + r));
      vertex(part[2], 3 + mod3(c + r + 1));
    }
    break;
  case EXACT_OWN:
  case EXACT_OWN_YZ:
  case EXACT_OWN_ZX:
  case EXACT_OWN_LIMIT:
  case EXACT_OWN_SIGN:
  case EXACT_OWN_WEIGHT:
  case EXACT_OWN_PRISM:
    for (int i = 0; i < 3; i++) {
      vertex(part[i], operation == 0 ? 3 + i : i);
    }
    break;
  case EXACT_BOX:
    snprintf(part[0], 8, "%c", 'x' + c);
    break;
  case EXACT_SLOPE_A:
    vertex(part[0], 3 + c);
    vertex(part[1], 3 + mod3(c + 1));
    break;
  case EXACT_SLOPE_B:
    vertex(part[0], c);
    vertex(part[1], mod3(c + 1));
    break;
  case EXACT_ABOVE_A:
  case EXACT_FAR_A:
    vertex(part[0], 3 + c);
    break;
  case EXACT_ABOVE_B:
  case EXACT_FAR_B:
    vertex(part[0], c);
    break;
  default:
    vertex(part[0], c);
    vertex(part[1], mod3(c + 1));
    vertex(part[2], 3 + mod3(c + r));
    vertex(part[3], 3 + mod3(c + r + 1));
  }
  snprintf(text, EMIT_NAME, "%s%s%s%s", part[0], part[1], part[2], part[3]);
}

/* --------------------------------------------------------------------- schedule */

typedef struct {
  const char *kind, *width;
  int format; /* SEPAX_X_...; -1: two bits */
  bool is_signed;
} stream_row;

static const stream_row rows[EXACT_CLASSES] = {
    [EXACT_STRIP] = {"t", "G_W", SEPAX_X_ORIENT2D, true},
    [EXACT_ORDER_X] = {"ox", "2", -1, false},
    [EXACT_AREA] = {"g", "G_W", SEPAX_X_ORIENT2D, true},
    [EXACT_AREA_SIGN] = {"gs", "2", -1, false},
    [EXACT_WEIGHT] = {"z", "Z_W", SEPAX_X_Z_SUM, true},
    [EXACT_ORDER_Z] = {"oz", "2", -1, false},
    [EXACT_OWN] = {"go", "G_W", SEPAX_X_ORIENT2D, true},
    [EXACT_OWN_SIGN] = {"gos", "2", -1, false},
    [EXACT_OWN_WEIGHT] = {"zo", "O_W", SEPAX_X_OWN_Z_SUM, true},
    [EXACT_PRISM] = {"h", "V_W", SEPAX_X_ORIENT3D, true},
    [EXACT_OWN_PRISM] = {"ho", "V_W", SEPAX_X_ORIENT3D, true},
    [EXACT_ABOVE_A] = {"s", "2", -1, false},
    [EXACT_ABOVE_B] = {"w", "2", -1, false},
    [EXACT_BETWEEN] = {"d", "2", -1, false},
    [EXACT_STRIP_YZ] = {"tyz", "G_W", SEPAX_X_ORIENT2D, true},
    [EXACT_STRIP_ZX] = {"tzx", "G_W", SEPAX_X_ORIENT2D, true},
    [EXACT_AREA_YZ] = {"gyz", "G_W", SEPAX_X_ORIENT2D, true},
    [EXACT_AREA_ZX] = {"gzx", "G_W", SEPAX_X_ORIENT2D, true},
    [EXACT_OWN_YZ] = {"goyz", "G_W", SEPAX_X_ORIENT2D, true},
    [EXACT_OWN_ZX] = {"gozx", "G_W", SEPAX_X_ORIENT2D, true},
    [EXACT_CROSS_XY] = {"cxy", "C_W", SEPAX_X_CROSS, true},
    [EXACT_CROSS_YZ] = {"cyz", "C_W", SEPAX_X_CROSS, true},
    [EXACT_CROSS_ZX] = {"czx", "C_W", SEPAX_X_CROSS, true},
    [EXACT_LIMIT] = {"l", "LIMITS*L_W", SEPAX_X_LIMIT, false},
    [EXACT_OWN_LIMIT] = {"lo", "LIMITS*L_W", SEPAX_X_LIMIT, false},
    [EXACT_EDGE_LIMIT] = {"le", "3*M_W", SEPAX_X_EDGE_LIMIT, false},
    [EXACT_BEYOND_XY] = {"bxy", "LIMITS+1", -1, false},
    [EXACT_BEYOND_YZ] = {"byz", "LIMITS+1", -1, false},
    [EXACT_BEYOND_ZX] = {"bzx", "LIMITS+1", -1, false},
    [EXACT_EDGE_XY] = {"exy", "LIMITS", -1, false},
    [EXACT_EDGE_YZ] = {"eyz", "LIMITS", -1, false},
    [EXACT_EDGE_ZX] = {"ezx", "LIMITS", -1, false},
    [EXACT_BOX] = {"box", "LIMITS", -1, false},
    [EXACT_FAR_A] = {"fs", "LIMITS+2", -1, false},
    [EXACT_FAR_B] = {"fw", "LIMITS+2", -1, false},
    [EXACT_FAR_BETWEEN] = {"fd", "LIMITS+2", -1, false},
    [EXACT_SLOPE_A] = {"rs", "2", -1, false},
    [EXACT_SLOPE_B] = {"rw", "2", -1, false},
};

/* With a clearance the volumes themselves. */
static stream_row row_of(const exact_plan *p, exact_class_id id) {
  stream_row row = rows[id];
  if (p->limits > 0 && id >= EXACT_ABOVE_A && id <= EXACT_BETWEEN) {
    row.width = "V_W";
    row.format = SEPAX_X_ORIENT3D;
    row.is_signed = true;
  }
  return row;
}

/* Bits of a stream, for its storage. */
static int bits_of(const exact_plan *p, exact_class_id id) {
  int format = row_of(p, id).format;
  int bits = format < 0 ? 2 : p->design->format[format].width;
  return id == EXACT_EDGE_LIMIT                           ? 3 * p->limits * bits
         : id == EXACT_LIMIT || id == EXACT_OWN_LIMIT     ? p->limits * bits
         : id >= EXACT_BEYOND_XY && id <= EXACT_BEYOND_ZX ? p->limits + 1
         : id >= EXACT_FAR_A && id <= EXACT_FAR_BETWEEN   ? p->limits + 2
         : id >= EXACT_EDGE_XY && id <= EXACT_BOX         ? p->limits
                                                          : bits;
}

/* The first cycle in which a unit can start. */
static int earliest_of(const exact_plan *p, exact_class_id id, int unit) {
  int start = 0;
  for (int slot = 0; slot < exact_slots(p, id, unit); slot++) {
    schedule_value v[EXACT_TERMS];
    int count = exact_operands(p, id, exact_operation(p, id, unit, slot), v);
    for (int i = 0; i < count; i++) {
      int after = schedule_born(&p->schedule, v[i]) - slot;
      start = after > start ? after : start;
    }
  }
  return start;
}

/* Enter a class that starts in a cycle, or, -1, as soon as it can: its units' output
 * streams. */
static void enter(exact_plan *p, exact_class_id id, int operations, int start, int latency) {
  schedule *s = &p->schedule;
  exact_class *c = &p->class[id];
  *c = (exact_class){.operations = operations, .latency = latency, .stream = s->streams};
  for (int unit = 0; unit < exact_units(p, id); unit++) {
    c->start[unit] = start < 0 ? earliest_of(p, id, unit) : start;
  }
  for (int unit = 0; unit < exact_units(p, id); unit++) {
    char name[EMIT_NAME];
    int count = exact_slots(p, id, unit);
    label_of(id, exact_operation(p, id, unit, 0), name);
    if (count > 1) {
      snprintf(name, sizeof name, "%d", unit);
    }
    stream_row row = row_of(p, id);
    int stream = schedule_add(s, row.kind, row.width, bits_of(p, id), row.is_signed, name);
    s->stream[stream].first = c->start[unit] + latency;
    for (int k = 0; k < count; k++) {
      label_of(id, exact_operation(p, id, unit, k), s->stream[stream].label[k]);
    }
  }
}

/* The first cycle in which all units of a class of so many operations can start. */
static int earliest(exact_plan *p, exact_class_id id, int operations) {
  int start = 0;
  p->class[id].operations = operations;
  for (int unit = 0; unit < exact_units(p, id); unit++) {
    int after = earliest_of(p, id, unit);
    start = after > start ? after : start;
  }
  return start;
}

static void need_operands(exact_plan *p, exact_class_id id) {
  const exact_class *c = &p->class[id];
  for (int unit = 0; unit < exact_units(p, id); unit++) {
    for (int slot = 0; slot < exact_slots(p, id, unit); slot++) {
      schedule_value v[EXACT_TERMS];
      int count = exact_operands(p, id, exact_operation(p, id, unit, slot), v);
      for (int i = 0; i < count; i++) {
        schedule_need(&p->schedule, v[i], c->start[unit] + slot);
      }
    }
  }
}

static void need_all(exact_plan *p, exact_class_id id, int from, int to, int cycle) {
  for (int k = from; k < to; k++) {
    schedule_need(&p->schedule, exact_value(p, id, k), cycle);
  }
}

/* Volumes over A at II = 3: unit r adds to the sum it takes over from unit r + 1. */
static void enter_running(exact_plan *p) {
  schedule *s = &p->schedule;
  int start = p->class[EXACT_PRISM].start[0] + p->class[EXACT_PRISM].latency;
  p->class[EXACT_ABOVE_A] =
      (exact_class){.operations = 3, .start = {start}, .latency = 1, .stream = s->streams};
  for (int r = 0; r < 3; r++) {
    char name[EMIT_NAME];
    snprintf(name, sizeof name, "%d", r);
    stream_row row = row_of(p, EXACT_ABOVE_A);
    int stream = schedule_add(s, "s", row.width, bits_of(p, EXACT_ABOVE_A), row.is_signed, name);
    s->stream[stream].first = start + 1;
    for (int k = 0; k < 3; k++) {
      label_of(EXACT_ABOVE_A, (r + k) % 3, s->stream[stream].label[k]);
    }
    for (int k = 0; k < 3; k++) {
      schedule_need(s, exact_value(p, EXACT_PRISM, exact_edge_area(k, r + k)), start + k);
    }
  }
}

/* Banks of coordinates, from cycle 0 on each II cycles long, one starting at `at`, until
 * cycle `last` is covered. Returns their number. */
static int plan_banks(int bank[EXACT_BANKS], int ii, int at, int last) {
  int count = 1;
  bank[0] = 0;
  while (bank[count - 1] < at) {
    int next = bank[count - 1] + ii;
    bank[count++] = next < at ? next : at;
  }
  while (bank[count - 1] + ii - 1 < last) {
    bank[count] = bank[count - 1] + ii;
    count++;
  }
  return count;
}

static double longer(double a, double b) { return a > b ? a : b; }

/* A strip with registers behind its sums or without, whichever has fewer ranks, or else
 * fewer registers. Without, its rows are late behind fan-outs (fitted to W = 18 and 20). */
static void plan_strip(exact_plan *p, double sums, double period) {
  int span = p->design->format[SEPAX_X_SPAN].width;
  int area = p->design->format[SEPAX_X_ORIENT2D].width;
  arith_form form = {span, span, area, p->design->format[SEPAX_X_SPAN].digits, 1, 0};
  arith_plan_make(&p->strip_mul, &form, period);
  int ranks = 1 + p->strip_mul.ranks;
  int registers = 2 * span + p->strip_mul.registers;
  double fan_outs = longer(0.125 + 0.022 * (span - 19), 0);
  form.used = sums + fan_outs;
  arith_plan_make(&p->strip_mul, &form, period);
  p->strip_rank = sums + delay_row(span) > period - delay_register() ||
                  ranks < p->strip_mul.ranks ||
                  (ranks == p->strip_mul.ranks && registers < p->strip_mul.registers);
  if (p->strip_rank) {
    form.used = 0;
    arith_plan_make(&p->strip_mul, &form, period);
  }
}

int exact_digits(int64_t factor) {
  int digits = 0;
  for (; factor != 0; factor >>= 1) {
    if ((factor & 1) != 0) {
      digits++;
      factor -= (factor & 3) == 3 ? -1 : 1;
    }
  }
  return digits;
}

/* Full adders one after the other that leave two rows of so many. */
static int levels_of(int terms) {
  int levels = 0;
  for (; terms > 2; terms = terms / 3 * 2 + terms % 3) {
    levels++;
  }
  return levels;
}

/* With a clearance: registers inside a limit. */
static void plan_limits(exact_plan *p, double room) {
  const sepax_format *f = p->design->format;
  if (p->limits == 0) {
    return;
  }
  double maximum = delay_adder(f[SEPAX_X_CROSS].width) + delay_mux(2);
  double sum = delay_adder(f[SEPAX_X_LIMIT].width);
  int terms = 0;
  int most = 0;
  for (int k = 0; k < p->limits; k++) {
    int of_sum = exact_digits(p->design->margin[k] + 1);
    int of_most = exact_digits(p->design->margin[k] - 1);
    terms = of_sum + of_most > terms ? of_sum + of_most : terms;
    most = of_sum > most ? of_sum : most;
    most = of_most > most ? of_most : most;
  }
  p->most_rank = 2 * maximum > room;
  p->total_rank = levels_of(terms) * delay_compressor() + sum > room;
  p->shortest = longer(p->shortest, delay_register() + levels_of(most) * delay_compressor() + sum);
}

/* What steers the operands of shared units comes late, behind its fan-out, ns. */
static const double steering = 0.28;

/* Of shared units, behind the fan-out of what steers them: the later the more bits it reaches
 * (fitted to W = 8 and 18 at II = 3). */
static double chosen(const exact_plan *p) {
  int word = p->design->core_word > 8 ? p->design->core_word : 8;
  return 0.38 + 0.26 * log2(word / 8.0) + delay_mux(2);
}

/* The longest stage that has no place for a register. Areas and weights read what steering has
 * selected. */
static double shortest_stage(const exact_plan *p, double sums, double sum) {
  const sepax_format *f = p->design->format;
  bool shared = p->design->config.ii > 1;
  double operands = shared ? chosen(p) : 0.15;
  double area = delay_compressor() + delay_adder(f[SEPAX_X_ORIENT2D].width);
  double weight = 2 * delay_compressor() + delay_adder(f[SEPAX_X_Z_SUM].width);
  double row = delay_row(f[SEPAX_X_ORIENT2D].width) + delay_compressor();
  double taken = (p->running ? steering + delay_mux(2) : 0) + sum;
  return delay_register() +
         longer(longer(row, sums), longer(operands + longer(area, weight), taken));
}

/* Until the operands of a strip are there (fitted to W = 12 at II = 2 and 6), later where no banks
 * turn. At II = 3 turning banks are all that they need. */
static double strip_operands(const exact_plan *p) {
  if (p->design->config.ii == 1 || p->running) {
    return 0;
  }
  return chosen(p) + (p->turns ? 0 : 0.12);
}

/* Where registers stand inside the units, and the longest stage that is left. */
/* The box test in front: bounds, a comparison with the margin, and what holds the coordinates back,
 * each behind its fan-out (fitted to W = 18). */
static double aabb_stage(const sepax_design *d) {
  int word = d->config.word;
  double compare = delay_adder(word) + (d->limits > 0 ? delay_adder(word + 1) : 0);
  double fan_outs = 0.71;
  return delay_register() + delay_adder(word) + delay_mux(3) + compare + fan_outs;
}

static void plan_ranks(exact_plan *p) {
  const sepax_format *f = p->design->format;
  double period = p->design->config.clock_ps / 1000.0;
  double room = period - delay_register();
  int span = f[SEPAX_X_SPAN].width;
  int area = f[SEPAX_X_ORIENT2D].width;
  int volume = f[SEPAX_X_ORIENT3D].width;
  double mux = delay_mux(p->design->config.ii == 1 ? 1 : 2);
  double sums = delay_adder(span) + strip_operands(p);
  plan_strip(p, sums, period);
  const sepax_format *weight = &f[SEPAX_X_Z_SUM];
  const sepax_format *own_weight = &f[SEPAX_X_OWN_Z_SUM];
  arith_form prism = {area, weight->width, volume, weight->digits, 1, 0};
  arith_form own_prism = {area, own_weight->width, volume, own_weight->digits, 1, 0};
  arith_plan_make(&p->prism_mul, &prism, period);
  arith_plan_make(&p->own_mul, &own_prism, period);
  prism.less = 2;
  arith_plan_make(&p->low_prism_mul, &prism, period);
  double fan_out = 0.15; /* of what many units read */
  double sum = fan_out + delay_adder(volume);
  double whole = (p->design->config.ii == 1 ? 0 : steering + mux) + 2 * delay_compressor() + sum;
  p->volume_ranks = whole > room ? 2 : whole + delay_test(volume) > room ? 1 : 0;
  p->shared_rises = p->design->config.ii == 1 &&
                    fan_out + 3 * delay_compressor() + 2 * delay_adder(own_weight->width) <= room;
  double six_terms = fan_out + 4 * delay_compressor() + delay_adder(own_weight->width);
  p->own_weight_rank = !p->running && !p->shared_rises && six_terms > room;
  p->sign_rank = delay_test(area) + 1.0 > room;
  p->shortest = shortest_stage(p, sums, sum);
  if (p->design->config.early_out) {
    p->shortest = longer(p->shortest, aabb_stage(p->design));
  }
  plan_limits(p, room);
}

static int latest_born(const exact_plan *p, exact_class_id from, exact_class_id to) {
  int latest = 0;
  for (exact_class_id id = from; id <= to; id++) {
    for (int k = 0; k < p->class[id].operations; k++) {
      int born = schedule_born(&p->schedule, exact_value(p, id, k));
      latest = born > latest ? born : latest;
    }
  }
  return latest;
}

static void enter_and_need(exact_plan *p, exact_class_id id, int operations, int latency) {
  enter(p, id, operations, -1, latency);
  need_operands(p, id);
}

/* A volume that comes whole needs no register for its sign. */
static int volume_latency(const exact_plan *p) {
  return 1 + (p->limits > 0 ? p->volume_ranks / 2 : p->volume_ranks);
}

static void enter_projections(exact_plan *p, int area_start, int own_start) {
  for (int projection = 1; projection < 3; projection++) {
    enter(p, exact_projected(EXACT_STRIP, projection), 15, 0, p->class[EXACT_STRIP].latency);
  }
  for (int projection = 1; projection < 3; projection++) {
    exact_class_id area = exact_projected(EXACT_AREA, projection);
    exact_class_id own = exact_projected(EXACT_OWN, projection);
    enter(p, area, 18, area_start, 1);
    need_operands(p, area);
    enter(p, own, 2, own_start, 1);
    need_operands(p, own);
  }
}

/* With a clearance: what follows from the areas and volumes. */
static void enter_clear(exact_plan *p) {
  int limit = 3 + p->most_rank + p->total_rank;
  enter_projections(p, p->class[EXACT_AREA].start[0], p->class[EXACT_OWN].start[0]);
  for (int projection = 0; projection < 3; projection++) {
    enter_and_need(p, exact_projected(EXACT_CROSS_XY, projection), 9, 1);
  }
  enter_and_need(p, EXACT_LIMIT, 9, limit);
  enter_and_need(p, EXACT_OWN_LIMIT, 2, limit);
  enter(p, EXACT_EDGE_LIMIT, 6, 0, 3 + p->total_rank);
  for (int projection = 0; projection < 3; projection++) {
    enter_and_need(p, exact_projected(EXACT_BEYOND_XY, projection), 18, 1);
    enter_and_need(p, exact_projected(EXACT_EDGE_XY, projection), 6, 1);
  }
  enter(p, EXACT_BOX, 3, 0, 2);
  enter_and_need(p, EXACT_FAR_A, 3, 1);
  enter_and_need(p, EXACT_FAR_B, 3, 1);
  enter_and_need(p, EXACT_FAR_BETWEEN, 9, 1);
  enter_and_need(p, EXACT_SLOPE_A, 3, 1);
  enter_and_need(p, EXACT_SLOPE_B, 3, 1);
}

/* Cycles of all classes, from the first to the last. */
static void enter_classes(exact_plan *p) {
  int own = p->single && p->limits == 0 ? 1 : 2;
  enter(p, EXACT_STRIP, 15, 0, 1 + p->strip_rank + p->strip_mul.ranks);
  enter(p, EXACT_ORDER_X, 15, 0, 1);
  int start = earliest(p, EXACT_AREA, 18);
  enter(p, EXACT_AREA, 18, start, 1);
  enter(p, EXACT_WEIGHT, 18, start, 1);
  enter(p, EXACT_ORDER_Z, 18, start, 1);
  enter(p, EXACT_AREA_SIGN, 18, start, 1 + p->sign_rank);
  enter(p, EXACT_PRISM, 18, start + 1, 1 + p->prism_mul.ranks);
  int own_start = earliest(p, EXACT_OWN, own);
  own_start = own_start > start ? own_start : start;
  enter(p, EXACT_OWN, own, own_start, 1);
  int own_weight = p->running ? 3 : p->shared_rises ? 1 : 1 + p->own_weight_rank;
  enter(p, EXACT_OWN_WEIGHT, 1, own_start + 1 - own_weight, own_weight);
  enter(p, EXACT_OWN_SIGN, own, own_start, 1 + p->sign_rank);
  enter(p, EXACT_OWN_PRISM, 1, own_start + 1, 1 + p->own_mul.ranks);
  if (p->running) {
    enter_running(p);
  } else {
    enter(p, EXACT_ABOVE_A, 3, -1, volume_latency(p));
    need_operands(p, EXACT_ABOVE_A);
  }
  enter(p, EXACT_ABOVE_B, 3, -1, volume_latency(p));
  enter(p, EXACT_BETWEEN, 9, -1, volume_latency(p));
  static const exact_class_id readers[] = {EXACT_AREA,      EXACT_OWN,     EXACT_PRISM,
                                           EXACT_OWN_PRISM, EXACT_ABOVE_B, EXACT_BETWEEN};
  for (size_t i = 0; i < sizeof readers / sizeof readers[0]; i++) {
    need_operands(p, readers[i]);
  }
  if (p->limits > 0) {
    enter_clear(p);
  }
}

/* What is read when the verdict is made. */
static void enter_clear_judge(exact_plan *p) {
  static const exact_class_id read[] = {EXACT_EDGE_XY,     EXACT_EDGE_YZ, EXACT_EDGE_ZX,
                                        EXACT_BOX,         EXACT_FAR_A,   EXACT_FAR_B,
                                        EXACT_FAR_BETWEEN, EXACT_SLOPE_A, EXACT_SLOPE_B};
  p->verdict_cycle = latest_born(p, EXACT_EDGE_XY, EXACT_SLOPE_B);
  for (size_t i = 0; i < sizeof read / sizeof read[0]; i++) {
    need_all(p, read[i], 0, p->class[read[i]].operations, p->verdict_cycle);
  }
  p->latency = p->verdict_cycle + 3;
}

/* When the plane and the verdict are judged, and what is read then. */
static void enter_judges(exact_plan *p) {
  int ii = p->schedule.ii;
  int frames = 0;
  if (p->limits > 0) {
    enter_clear_judge(p);
    return;
  }
  if (!p->single) {
    int own = latest_born(p, EXACT_OWN_SIGN, EXACT_OWN_SIGN);
    int other = latest_born(p, EXACT_AREA_SIGN, EXACT_AREA_SIGN);
    frames = ((own > other ? own : other) + ii) / ii;
    p->plane_cycle = frames * ii - 1;
    need_all(p, EXACT_ORDER_X, 6, 15, p->plane_cycle);
    need_all(p, EXACT_ORDER_Z, 0, 9, p->plane_cycle);
    need_all(p, EXACT_AREA_SIGN, 0, 18, p->plane_cycle);
    need_all(p, EXACT_OWN_SIGN, 0, 2, p->plane_cycle);
  }
  int born = latest_born(p, EXACT_ABOVE_A, EXACT_BETWEEN);
  p->verdict_cycle = born > frames * ii ? born : frames * ii;
  need_all(p, EXACT_ABOVE_A, 0, 3, p->verdict_cycle);
  need_all(p, EXACT_ABOVE_B, 0, 3, p->verdict_cycle);
  need_all(p, EXACT_BETWEEN, 0, 9, p->verdict_cycle);
  p->latency = p->verdict_cycle + 3;
}

static void plan_all_banks(exact_plan *p) {
  int ii = p->schedule.ii;
  int last = p->single ? 0 : p->plane_cycle;
  p->u_banks = plan_banks(p->u_bank, ii, 0, last);
  int weights = p->class[EXACT_WEIGHT].start[0] + ii - 1;
  int own = p->class[EXACT_OWN_WEIGHT].start[0] + (p->running ? 2 : 0);
  last = weights > last ? weights : last;
  last = own > last ? own : last;
  int aligned = plan_banks(p->z_bank, ii, 0, last);
  p->z_banks = plan_banks(p->z_bank, ii, p->class[EXACT_WEIGHT].start[0], last);
  if (aligned < p->z_banks) { /* weights read two banks, but a bank costs more */
    p->z_banks = plan_banks(p->z_bank, ii, 0, last);
  }
}

bool exact_plan_make(exact_plan *p, const sepax_design *design, sepax_error *error) {
  int ii = design->config.ii;
  *p = (exact_plan){.design = design,
                    .turns = ii % 3 == 0,
                    .running = ii == 3,
                    .limits = design->limits,
                    .single = design->config.flag || design->limits > 0};
  p->schedule.ii = ii;
  plan_ranks(p);
  if (p->shortest * 1000 > design->config.clock_ps) {
    return sepax_fail(error, "clock-ns: %g is too short for W = %d; give %.2f or more",
                      design->config.clock_ps / 1000.0, design->core_word, p->shortest + 0.005);
  }
  enter_classes(p);
  enter_judges(p);
  schedule_store(&p->schedule);
  plan_all_banks(p);
  return true;
}
