/* SPDX-License-Identifier: MIT */
/* tube.c - whether the joints are inside; see tube.h. Real time: no allocation, lock, file or
 * clock. */
#include "tube.h"

#include <math.h>

enum { BACK = 4, AHEAD = 64, SEARCHED = 128 };

size_t tube_stride(size_t joints) { return TUBE_FIRST + joints * TUBE_VALUES; }

size_t tube_size(size_t joints, uint64_t rows) {
  return sizeof(tube) + rows * tube_stride(joints) * sizeof(double);
}

/* What is asked in one period. */
typedef struct {
  const tube *t;
  const double *position, *velocity, *acceleration;
  long tool;
  double period;
} question;

static const double *row_of(const tube *t, uint64_t row) {
  return &t->value[row * tube_stride(t->joints)];
}

static const double *joint_of(const double *row, size_t joint) {
  return &row[TUBE_FIRST + joint * TUBE_VALUES];
}

/* Keep the parts of the way at which a joint is within `off`: a + t d. */
static void narrow(double p, double a, double d, double off, double range[2]) {
  if (d == 0) {
    range[1] = fabs(p - a) <= off ? range[1] : -1;
    return;
  }
  const double one = (p - off - a) / d;
  const double other = (p + off - a) / d;
  range[0] = fmax(range[0], fmin(one, other));
  range[1] = fmin(range[1], fmax(one, other));
}

/* A joint that brakes as it can stops before it is farther than `off` beyond the value where the
 * tube turns. Two periods of braking are allowed for the steps of the control. */
static bool stops(const question *q, size_t joint, const double *value) {
  const double v = q->velocity[joint];
  const double a = q->acceleration[joint];
  const double speed = fmax(0, fabs(v) - 2 * a * q->period);
  const double room =
      v > 0 ? value[TUBE_HIGH] - q->position[joint] : q->position[joint] - value[TUBE_LOW];
  return speed * speed <= 2 * a * (room + value[TUBE_OFF]);
}

/* Is the machine on the motion that ends in the row? */
static bool on_motion(const question *q, uint64_t row) {
  const double *at = row_of(q->t, row);
  double range[2] = {0, 1};
  if (row == 0 || at[TUBE_BEGINS] != 0 ||
      (at[TUBE_TOOL] >= 0 && at[TUBE_TOOL] != (double)q->tool)) {
    return false;
  }
  const double *before = row_of(q->t, row - 1);
  for (size_t n = 0; n < q->t->joints; n++) {
    const double *value = joint_of(at, n);
    const double from = joint_of(before, n)[TUBE_END];
    narrow(q->position[n], from, value[TUBE_END] - from, value[TUBE_OFF], range);
    if (!(range[0] <= range[1]) || !stops(q, n, value)) {
      return false;
    }
  }
  return true;
}

/* The first of some rows that the machine is on; `rows` if it is on none. */
static uint64_t find(const question *q, uint64_t from, uint64_t to, uint64_t rows) {
  for (uint64_t row = from; row < to && row < rows; row++) {
    if (on_motion(q, row)) {
      return row;
    }
  }
  return rows;
}

/* A machine that is in the tube goes on in it; another is looked for, some rows in each period. */
static uint64_t place_of(const question *q, tube_place *place, uint64_t rows) {
  if (!place->inside) {
    const uint64_t from = place->search < rows ? place->search : 0;
    place->search = from + SEARCHED;
    return find(q, from, from + SEARCHED, rows);
  }
  const uint64_t row = find(q, place->row, place->row + AHEAD, rows);
  if (row < rows) {
    return row;
  }
  place->search = 0;
  const uint64_t back = place->row > BACK ? place->row - BACK : 0;
  const uint64_t earlier = find(q, back, place->row, rows);
  return earlier < place->row ? earlier : rows;
}

bool tube_inside(const tube *t, tube_place *place, const double *position, const double *velocity,
                 const double *acceleration, long tool, double period) {
  const question q = {t, position, velocity, acceleration, tool, period};
  const uint64_t serial = atomic_load_explicit(&t->serial, memory_order_acquire);
  const uint64_t rows = t->rows;
  if (serial % 2 != 0 || rows == 0 || rows > t->most) {
    place->inside = false;
    return false;
  }
  if (serial != place->serial) {
    *place = (tube_place){.serial = serial};
  }
  const uint64_t row = place_of(&q, place, rows);
  atomic_thread_fence(memory_order_acquire);
  place->inside = row < rows && atomic_load_explicit(&t->serial, memory_order_relaxed) == serial;
  place->row = row;
  return place->inside;
}

void tube_clear(tube *t) {
  const uint64_t serial = atomic_load(&t->serial);
  atomic_store(&t->serial, serial | 1);
  atomic_thread_fence(memory_order_release);
  t->rows = 0;
  atomic_store_explicit(&t->serial, (serial | 1) + 1, memory_order_release);
}
