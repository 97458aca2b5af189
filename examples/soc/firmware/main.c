/* SPDX-License-Identifier: MIT */
/* main.c - firmware: two objects on the engine of this chip; the pairs of triangles that collide
 * are written to the console, then the counts. The bare-metal driver is
 * drivers/object_engine/sepax_driver.c; the four accesses that it asks for are those of
 * soc_bridge.v. */
#include "objects.h"
#include "sepax_driver.h"
#include "sepax_registers.h"

#define CONSOLE (*(volatile uint32_t *)0x10000000)
#define ENGINE ((volatile uint32_t *)0x20000000)

enum { VERTEX = 0x80 / 4, SEND = 0x8c / 4, STATE = 0x90 / 4, LOW = 0x94 / 4, HIGH = 0x98 / 4 };
enum { RESULT = 1, LAST = 2, REFUSED = 4 };

static void text(const char *c) {
  while (*c != '\0') {
    CONSOLE = (uint32_t)*c++;
  }
}

static void number(uint32_t n) {
  char digit[11];
  int i = 10;
  digit[i] = '\0';
  do {
    digit[--i] = (char)('0' + n % 10);
    n /= 10;
  } while (n != 0);
  text(digit + i);
}

static bool taken(void) { return (ENGINE[STATE] & REFUSED) == 0; }

static bool read_register(void *context, uint32_t address, uint32_t *value) {
  (void)context;
  *value = ENGINE[address / 4];
  return taken();
}

static bool write_register(void *context, uint32_t address, uint32_t value) {
  (void)context;
  ENGINE[address / 4] = value;
  return taken();
}

static bool send(void *context, const int32_t vertex[3], bool last, bool to_b) {
  (void)context;
  for (int i = 0; i < 3; i++) {
    ENGINE[VERTEX + i] = (uint32_t)vertex[i];
  }
  ENGINE[SEND] = (last ? 1u : 0u) | (to_b ? 2u : 0u);
  return taken();
}

static bool receive(void *context, uint64_t *result, bool *last) {
  (void)context;
  uint32_t state = 0;
  do {
    state = ENGINE[STATE];
  } while ((state & RESULT) == 0);
  *last = (state & LAST) != 0;
  uint32_t low = ENGINE[LOW];
  *result = (uint64_t)ENGINE[HIGH] << 32 | low;
  return taken();
}

static bool print(void *context, const sepax_hit *hit) {
  (void)context;
  number((uint32_t)hit->a);
  text(" ");
  number((uint32_t)hit->b);
  text(hit->out_of_range ? " undecided\n" : "\n");
  return true;
}

/* What there is not is refused: a register, a result before the first run. */
static bool refuses(void) {
  uint32_t value = 0;
  bool refused = !read_register(NULL, 0x7c, &value);
  value = ENGINE[HIGH];
  return refused && !taken() && read_register(NULL, SEPAX_ID, &value);
}

int main(void) {
  const sepax_bus bus = {NULL, read_register, write_register, send, receive};
  sepax_device device;
  sepax_counts counts;
  if (!refuses()) {
    text("# the bridge refuses nothing\n");
    return 3;
  }
  sepax_status status = sepax_device_open(&device, &bus);
  if (status == SEPAX_DRIVER_OK) {
    status = sepax_device_collide(&device, object_a, COUNT_A, object_b, COUNT_B, false, print, NULL,
                                  &counts);
  }
  text("# ");
  text(sepax_status_text(status));
  if (status == SEPAX_DRIVER_OK) {
    text(": ");
    number((uint32_t)counts.pairs);
    text(" pairs, ");
    number((uint32_t)counts.collisions);
    text(" collide, ");
    number((uint32_t)counts.cycles);
    text(" cycles");
  }
  text("\n");
  return status != SEPAX_DRIVER_OK ? 2 : counts.collisions > 0;
}
