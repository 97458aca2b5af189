/* SPDX-License-Identifier: MIT */
/* sepax_driver.c - see sepax_driver.h. */
#include "sepax_driver.h"

#include "sepax_registers.h"

const char *sepax_status_text(sepax_status status) {
  static const char *const text[] = {"done",
                                     "no engine there",
                                     "bus error",
                                     "a coordinate does not fit the words",
                                     "an object is empty or too large",
                                     "a move does not fit W + 1 bits",
                                     "results were lost",
                                     "ended"};
  return text[status];
}

sepax_status sepax_device_open(sepax_device *device, const sepax_bus *bus) {
  uint32_t id = 0;
  uint32_t design = 0;
  uint32_t memory = 0;
  device->bus = *bus;
  if (!bus->read(bus->context, SEPAX_ID, &id)) {
    return SEPAX_BUS_ERROR;
  }
  if (id != SEPAX_IDENTITY) {
    return SEPAX_NO_ENGINE;
  }
  if (!bus->read(bus->context, SEPAX_DESIGN, &design) ||
      !bus->read(bus->context, SEPAX_MEMORY, &memory)) {
    return SEPAX_BUS_ERROR;
  }
  device->word = (int)SEPAX_DESIGN_WORD(design);
  device->lanes = (int)SEPAX_DESIGN_LANES(design);
  device->capacity[0] = (size_t)1 << SEPAX_MEMORY_LOG2_A(memory);
  device->capacity[1] = (size_t)1 << SEPAX_MEMORY_LOG2_B(memory);
  return SEPAX_DRIVER_OK;
}

static bool fits(const int32_t c[9], int word) {
  int64_t half = INT64_C(1) << (word - 1);
  for (int i = 0; i < 9; i++) {
    if (c[i] < -half || c[i] >= half) {
      return false;
    }
  }
  return true;
}

/* Wait until the engine has an object, some seconds at most. */
static bool wait_loaded(const sepax_bus *bus) {
  enum { READS = 10000000 };
  uint32_t pending = 0;
  for (long i = 0; i < READS; i++) {
    if (!bus->read(bus->context, SEPAX_PENDING, &pending)) {
      return false;
    }
    if ((pending & SEPAX_PENDING_LOADED) != 0) {
      return true;
    }
  }
  return false;
}

/* End an object that a failed access has left unfinished. The engine then ignores it. */
static bool end_object(const sepax_bus *bus) {
  static const int32_t vertex[3] = {0, 0, 0};
  uint32_t status = 0;
  if (!bus->read(bus->context, SEPAX_STATUS, &status)) {
    return false;
  }
  return (status & SEPAX_STATUS_LOADING) == 0 ||
         (bus->write(bus->context, SEPAX_PENDING, SEPAX_PENDING_LOADED) &&
          bus->send(bus->context, vertex, true, false) && wait_loaded(bus));
}

sepax_status sepax_device_load(sepax_device *device, bool to_b, const int32_t (*triangle)[9],
                               size_t count) {
  const sepax_bus *bus = &device->bus;
  if (count == 0 || count > device->capacity[to_b]) {
    return SEPAX_BAD_SIZE;
  }
  for (size_t i = 0; i < count; i++) {
    if (!fits(triangle[i], device->word)) {
      return SEPAX_BAD_WORD;
    }
  }
  if (!end_object(bus) || !bus->write(bus->context, SEPAX_PENDING, SEPAX_PENDING_LOADED)) {
    return SEPAX_BUS_ERROR;
  }
  for (size_t i = 0; i < count; i++) {
    for (int k = 0; k < 3; k++) {
      if (!bus->send(bus->context, triangle[i] + 3 * k, i == count - 1 && k == 2, to_b)) {
        return SEPAX_BUS_ERROR;
      }
    }
  }
  uint32_t loaded = 0;
  bool ok =
      wait_loaded(bus) && bus->read(bus->context, to_b ? SEPAX_COUNT_B : SEPAX_COUNT_A, &loaded);
  return ok && loaded == count ? SEPAX_DRIVER_OK : SEPAX_BUS_ERROR;
}

sepax_status sepax_device_move(sepax_device *device, const int32_t move[3]) {
  static const uint32_t address[3] = {SEPAX_MOVE_X, SEPAX_MOVE_Y, SEPAX_MOVE_Z};
  int64_t most = INT64_C(1) << device->word;
  for (int i = 0; i < 3; i++) {
    if (move[i] < -most || move[i] >= most) {
      return SEPAX_BAD_MOVE;
    }
  }
  for (int i = 0; i < 3; i++) {
    if (!device->bus.write(device->bus.context, address[i], (uint32_t)move[i])) {
      return SEPAX_BUS_ERROR;
    }
  }
  return SEPAX_DRIVER_OK;
}

static sepax_status read_counts(sepax_device *device, sepax_counts *counts) {
  static const uint32_t address[6] = {SEPAX_PAIRS,        SEPAX_CANDIDATES, SEPAX_COLLISIONS,
                                      SEPAX_OUT_OF_RANGE, SEPAX_WARNINGS,   SEPAX_CYCLES};
  uint32_t value[6];
  for (int i = 0; i < 6; i++) {
    if (!device->bus.read(device->bus.context, address[i], &value[i])) {
      return SEPAX_BUS_ERROR;
    }
  }
  *counts = (sepax_counts){value[0], value[1], value[2], value[3], value[4], value[5]};
  return SEPAX_DRIVER_OK;
}

sepax_status sepax_device_run(sepax_device *device, bool first,
                              bool (*found)(void *context, const sepax_hit *hit), void *context,
                              sepax_counts *counts) {
  const sepax_bus *bus = &device->bus;
  if (!bus->write(bus->context, SEPAX_PENDING, SEPAX_PENDING_DONE | SEPAX_PENDING_HIT) ||
      !bus->write(bus->context, SEPAX_MODE, first ? SEPAX_MODE_FIRST : 0) ||
      !bus->write(bus->context, SEPAX_COMMAND, SEPAX_COMMAND_START)) {
    return SEPAX_BUS_ERROR;
  }
  uint64_t results = 0;
  bool ended = false;
  for (;;) {
    uint64_t result = 0;
    bool last = false;
    if (!bus->receive(bus->context, &result, &last)) {
      return SEPAX_BUS_ERROR;
    }
    if (last) {
      if ((uint32_t)result != results) {
        return SEPAX_INCOMPLETE;
      }
      break;
    }
    results++;
    sepax_hit hit = {.a = (size_t)(result & 0xffffffffu),
                     .b = (size_t)(result >> 32 & 0xffffffu),
                     .coplanar = (result >> 56 & 1) != 0,
                     .out_of_range = (result >> 57 & 1) != 0,
                     .warning = (result >> 58 & 1) != 0};
    if (!ended && !found(context, &hit)) {
      ended = true;
      if (!bus->write(bus->context, SEPAX_COMMAND, SEPAX_COMMAND_STOP)) {
        return SEPAX_BUS_ERROR;
      }
    }
  }
  sepax_status status = read_counts(device, counts);
  return status == SEPAX_DRIVER_OK && ended ? SEPAX_ENDED : status;
}

/* A part of the objects: `base` is added to the numbers of its pairs. */
typedef struct {
  size_t base[2];
  bool (*found)(void *context, const sepax_hit *hit);
  void *context;
} part;

static bool found_in_part(void *context, const sepax_hit *hit) {
  const part *p = context;
  sepax_hit whole = *hit;
  whole.a += p->base[0];
  whole.b += p->base[1];
  return p->found(p->context, &whole);
}

static size_t least(size_t a, size_t b) { return a < b ? a : b; }

sepax_status sepax_device_collide(sepax_device *device, const int32_t (*a)[9], size_t count_a,
                                  const int32_t (*b)[9], size_t count_b, bool first,
                                  bool (*found)(void *context, const sepax_hit *hit), void *context,
                                  sepax_counts *counts) {
  *counts = (sepax_counts){0};
  if (count_a == 0 || count_b == 0) {
    return SEPAX_BAD_SIZE;
  }
  part p = {{0, 0}, found, context};
  for (p.base[0] = 0; p.base[0] < count_a; p.base[0] += device->capacity[0]) {
    size_t of_a = least(count_a - p.base[0], device->capacity[0]);
    sepax_status status = sepax_device_load(device, false, a + p.base[0], of_a);
    for (p.base[1] = 0; p.base[1] < count_b && status == SEPAX_DRIVER_OK;
         p.base[1] += device->capacity[1]) {
      size_t of_b = least(count_b - p.base[1], device->capacity[1]);
      sepax_counts run = {0};
      if (count_b > device->capacity[1] || p.base[0] == 0) { /* a B that fits is loaded once */
        status = sepax_device_load(device, true, b + p.base[1], of_b);
      }
      if (status == SEPAX_DRIVER_OK) {
        status = sepax_device_run(device, first, found_in_part, &p, &run);
      }
      counts->pairs += run.pairs;
      counts->candidates += run.candidates;
      counts->collisions += run.collisions;
      counts->out_of_range += run.out_of_range;
      counts->warnings += run.warnings;
      counts->cycles += run.cycles;
      if (first && status == SEPAX_DRIVER_OK && run.collisions > 0) {
        return SEPAX_DRIVER_OK;
      }
    }
    if (status != SEPAX_DRIVER_OK) {
      return status;
    }
  }
  return SEPAX_DRIVER_OK;
}
