/* SPDX-License-Identifier: MIT */
/* sepax_tree_driver.c - see sepax_tree_driver.h. */
#include "sepax_tree_driver.h"

#include "sepax_tree_registers.h"

const char *sepax_tree_device_text(sepax_tree_device_status status) {
  static const char *const text[] = {"done", "no tree engine there", "bus error",
                                     "results were lost", "no verdict"};
  return text[status];
}

/* ---------------------------------------------------------------- memory */

static void put(uint8_t *to, uint64_t value, int bytes) {
  for (int k = 0; k < bytes; k++) {
    to[k] = (uint8_t)(value >> (8 * k));
  }
}

static uint64_t get(const uint8_t *from, int bytes) {
  uint64_t value = 0;
  for (int k = 0; k < bytes; k++) {
    value |= (uint64_t)from[k] << (8 * k);
  }
  return value;
}

/* True if the file begins with the 8 characters of `head` and has version 1. */
static bool begins(const uint8_t *file, const char *head) {
  enum { HEAD = 8, VERSION = 1 };
  for (int k = 0; k < HEAD; k++) {
    if (file[k] != (uint8_t)head[k]) {
      return false;
    }
  }
  return get(file + 8, 4) == VERSION;
}

static bool is_tree(const uint8_t *file) { return begins(file, "sepaxSXT"); }

bool sepax_tree_device_body(uint8_t record[SEPAX_TREE_DEVICE_BODY], const uint8_t *file,
                            uint64_t address) {
  enum { IMAGE = 4096 };
  if (!is_tree(file) || address % IMAGE != 0) {
    return false;
  }
  put(record, address + IMAGE, 8);
  put(record + 8, get(file + 48, 4), 4);
  put(record + 12, get(file + 52, 4), 4);
  put(record + 16, get(file + 56, 8) / 16, 4);
  put(record + 20, 0, 8);
  put(record + 28, 0, 4);
  return true;
}

bool sepax_tree_device_fits(const sepax_tree_device *device, const uint8_t *a, const uint8_t *b) {
  uint64_t most = (uint64_t)device->word;
  return is_tree(a) && is_tree(b) && get(a + 12, 4) <= most && get(b + 12, 4) <= most &&
         get(a + 16, 8) ==
             get(b + 16, 8); /* resolutions are above 0, so equal numbers have equal bits */
}

/* Floor of a / 2^20. */
static int64_t down(int64_t a) { return a >= 0 ? a >> 20 : -((-a + (1 << 20) - 1) >> 20); }

static int64_t magnitude(int64_t a) { return a < 0 ? -a : a; }

/* Write u_i and sigma_B,i, which belong to row i of K, the transposed matrix. `shift` is t', split
 * as t' = 2^20 high + low, so that all sums fit 64 bits. u is the integer nearest to -K t' / 2^20,
 * and 2^20 u + K t' is the remainder of K low. sigma is the right side of inequality (2) of
 * docs/reference/tree-engine.md, rounded up. False if a number does not fit. */
static bool turn_back(uint8_t *pose, int i, const int32_t matrix[3][3], const int64_t shift[3],
                      int word, int margin) {
  const int64_t one = (int64_t)1 << 20;
  int64_t high = 0;
  int64_t low = 0;
  int64_t sizes = 0;
  int64_t errors = 0;
  for (int j = 0; j < 3; j++) {
    int64_t k = matrix[j][i];
    int64_t e = i == j ? one * one : 0;
    for (int l = 0; l < 3; l++) {
      e -= (int64_t)matrix[l][i] * matrix[l][j];
    }
    errors += magnitude(e);
    sizes += magnitude(k);
    high += k * down(shift[j]);
    low += k * (shift[j] - one * down(shift[j]));
  }
  int64_t carry = down(low + one / 2);
  int64_t u = -high - carry;
  if (errors >> 38 != 0 || u < -((int64_t)1 << 43) || u >= (int64_t)1 << 43) {
    return false;
  }
  int64_t units = errors * ((int64_t)1 << (word - 1)) + sizes * (one / 2) * (2 * margin + 1) +
                  magnitude(low - one * carry);
  int64_t sigma = (units + ((int64_t)1 << 30) - 1) >> 30;
  put(pose + 24 + 8 * i, (uint64_t)u, 8);
  put(pose + 132 + 4 * i, (uint64_t)sigma, 4);
  return sigma >> 24 == 0;
}

bool sepax_tree_device_pose(uint8_t pose[SEPAX_TREE_DEVICE_POSE], const int32_t matrix[3][3],
                            const int64_t shift[3], int word, int margin) {
  const int64_t most = (int64_t)1 << 20;
  const int64_t half = most / 2;
  bool fits = margin >= 0 && margin <= 8191;
  for (int i = 0; i < 3; i++) {
    fits = fits && shift[i] >= -((int64_t)1 << 43) && shift[i] < ((int64_t)1 << 43) - half;
    for (int j = 0; j < 3; j++) {
      fits = fits && matrix[i][j] >= -most && matrix[i][j] <= most;
    }
  }
  for (int i = 0; fits && i < 3; i++) {
    put(pose + 8 * i, (uint64_t)(shift[i] + half), 8);
    put(pose + 120 + 4 * i, (uint64_t)margin << 10, 4);
    for (int j = 0; j < 3; j++) {
      put(pose + 48 + 4 * (3 * i + j), (uint64_t)(int64_t)matrix[i][j], 4);
      put(pose + 84 + 4 * (3 * i + j), (uint64_t)(int64_t)matrix[j][i], 4);
    }
    fits = turn_back(pose, i, matrix, shift, word, margin);
  }
  return fits;
}

void sepax_tree_device_job(uint8_t job[SEPAX_TREE_DEVICE_JOB], const sepax_tree_device_work *work) {
  for (int k = 0; k < SEPAX_TREE_DEVICE_JOB; k++) {
    job[k] = k < 2 * SEPAX_TREE_DEVICE_BODY
                 ? work->body[k / SEPAX_TREE_DEVICE_BODY][k % SEPAX_TREE_DEVICE_BODY]
                 : 0;
  }
  put(job + 64, work->poses, 8);
  put(job + 72, work->count, 4);
  put(job + 76, work->modes, 4);
  put(job + 80, work->budget, 4);
  put(job + 88, work->row[0], 4);
  put(job + 92, work->row[1], 4);
}

/* ---------------------------------------------------------------- lists */

/* The margin of a design for the list. */
static int margin_of(const uint8_t *file) {
  int word = (int)get(file + 12, 4);
  int clearance = (int)get(file + 16, 4);
  int warning = (int)get(file + 20, 4);
  return 1 + (warning > clearance ? warning : clearance) + (word <= 18 ? 2 : word <= 20 ? 3 : 5);
}

bool sepax_tree_device_place(const sepax_tree_device *device, sepax_tree_device_list *list,
                             uint8_t *file, uint64_t address) {
  enum { PAGE = 4096, PLACED = 80 };
  if (!begins(file, "sepaxSXJ") || address % PAGE != 0 ||
      get(file + 12, 4) != (uint64_t)device->word || margin_of(file) != device->margin) {
    return false;
  }
  const uint64_t way = address - get(file + PLACED, 8);
  const uint64_t at = get(file + 56, 8);
  *list = (sepax_tree_device_list){.list = address + at,
                                   .jobs = (uint32_t)get(file + 28, 4),
                                   .poses = (uint32_t)get(file + 32, 4)};
  for (uint32_t n = 0; n < list->jobs; n++) {
    uint8_t *job = file + at + (uint64_t)SEPAX_TREE_DEVICE_JOB * n;
    for (int k = 0; k < 2 * SEPAX_TREE_DEVICE_BODY + 1;
         k += SEPAX_TREE_DEVICE_BODY) { /* A, B, poses */
      put(job + k, get(job + k, 8) + way, 8);
    }
  }
  put(file + PLACED, address, 8);
  return true;
}

/* ---------------------------------------------------------------- runs */

sepax_tree_device_status sepax_tree_device_open(sepax_tree_device *device,
                                                const sepax_tree_device_bus *bus) {
  uint32_t id = 0;
  uint32_t design = 0;
  uint32_t margin = 0;
  device->bus = *bus;
  if (!bus->read(bus->context, SEPAX_TREE_ID, &id)) {
    return SEPAX_TREE_DEVICE_BUS;
  }
  if (id != SEPAX_TREE_IDENTITY) {
    return SEPAX_TREE_DEVICE_NONE;
  }
  if (!bus->read(bus->context, SEPAX_TREE_DESIGN, &design) ||
      !bus->read(bus->context, SEPAX_TREE_MARGIN, &margin)) {
    return SEPAX_TREE_DEVICE_BUS;
  }
  device->word = (int)SEPAX_TREE_DESIGN_WORD(design);
  device->margin = (int)margin;
  return SEPAX_TREE_DEVICE_OK;
}

sepax_tree_device_status sepax_tree_device_start(sepax_tree_device *device, uint64_t list,
                                                 uint32_t jobs) {
  const sepax_tree_device_bus *bus = &device->bus;
  const uint32_t all = SEPAX_TREE_PENDING_DONE | SEPAX_TREE_PENDING_HIT | SEPAX_TREE_PENDING_POSE;
  bool ok = bus->write(bus->context, SEPAX_TREE_PENDING, all) &&
            bus->write(bus->context, SEPAX_TREE_LIST_LOW, (uint32_t)list) &&
            bus->write(bus->context, SEPAX_TREE_LIST_HIGH, (uint32_t)(list >> 32)) &&
            bus->write(bus->context, SEPAX_TREE_JOBS, jobs) &&
            bus->write(bus->context, SEPAX_TREE_COMMAND, SEPAX_TREE_COMMAND_START);
  return ok ? SEPAX_TREE_DEVICE_OK : SEPAX_TREE_DEVICE_BUS;
}

sepax_tree_device_status sepax_tree_device_stop(sepax_tree_device *device) {
  const sepax_tree_device_bus *bus = &device->bus;
  return bus->write(bus->context, SEPAX_TREE_COMMAND, SEPAX_TREE_COMMAND_STOP)
             ? SEPAX_TREE_DEVICE_OK
             : SEPAX_TREE_DEVICE_BUS;
}

static void take_end(sepax_outcome *o, const uint64_t word[8]) {
  uint32_t low[8];
  uint32_t high[8];
  for (int k = 0; k < 8; k++) {
    low[k] = (uint32_t)word[k];
    high[k] = (uint32_t)(word[k] >> 32);
  }
  *o = (sepax_outcome){.job = low[1],
                       .pose = high[1],
                       .status = high[0] & 63,
                       .last = (high[0] & 64) != 0,
                       .steps = low[0],
                       .cycles = low[2],
                       .near = high[2],
                       .collisions = low[3],
                       .warnings = high[3],
                       .out_of_range = low[4],
                       .pairs = high[4],
                       .rows = low[5],
                       .entries = high[5],
                       .first = {low[6], high[6]},
                       .row = {low[7], high[7]}};
}

sepax_tree_device_status sepax_tree_device_take(sepax_tree_device *device,
                                                void (*found)(void *context,
                                                              const sepax_contact *contact),
                                                void *context, sepax_outcome *outcome) {
  const sepax_tree_device_bus *bus = &device->bus;
  uint64_t word[8] = {0};
  uint32_t pairs = 0;
  int taken = 0;
  bool last = false;
  while (!last) {
    if (taken == 8 || !bus->receive(bus->context, &word[taken], &last)) {
      return SEPAX_TREE_DEVICE_BUS;
    }
    if (taken > 0 || word[0] >> 63 != 0) {
      taken++;
    } else {
      pairs++;
      const sepax_contact contact = {.a = (uint32_t)word[0],
                                     .b = (uint32_t)(word[0] >> 32 & 0xffffff),
                                     .coplanar = (word[0] >> 56 & 1) != 0,
                                     .out_of_range = (word[0] >> 57 & 1) != 0,
                                     .warning = (word[0] >> 58 & 1) != 0};
      if (found != NULL) {
        found(context, &contact);
      }
    }
  }
  if (taken != 8) {
    return SEPAX_TREE_DEVICE_INCOMPLETE;
  }
  take_end(outcome, word);
  return outcome->status >> 3 != 0 ? SEPAX_TREE_DEVICE_NO_VERDICT
         : pairs != 0 && pairs != outcome->collisions + outcome->warnings
             ? SEPAX_TREE_DEVICE_INCOMPLETE
             : SEPAX_TREE_DEVICE_OK;
}

sepax_tree_device_status sepax_tree_device_busy(sepax_tree_device *device, bool *busy) {
  const sepax_tree_device_bus *bus = &device->bus;
  uint32_t status = 0;
  bool ok = bus->read(bus->context, SEPAX_TREE_STATUS, &status);
  *busy = (status & SEPAX_TREE_STATUS_BUSY) != 0;
  return ok ? SEPAX_TREE_DEVICE_OK : SEPAX_TREE_DEVICE_BUS;
}
