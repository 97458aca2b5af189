/* SPDX-License-Identifier: MIT */
/* main.c - firmware: asks the tree engine about two bodies that lie in the SDRAM, in the poses of
 * scene.h, and then about a list of jobs outside of the SDRAM. Each answer is a line on the
 * UART; soc.py compares them with the library's. */
#include "sepax_tree_driver.h"
#include "sepax_tree_registers.h"

#include <generated/csr.h>
#include <generated/mem.h>
#include <generated/soc.h>

#include "scene.h"

/* What the compiler calls. */
void *memset(void *to, int value, size_t count);
void *memcpy(void *restrict to, const void *restrict from, size_t count);

void *memset(void *to, int value, size_t count) {
  volatile uint8_t *byte = to;
  while (count-- > 0) {
    *byte++ = (uint8_t)value;
  }
  return to;
}

void *memcpy(void *restrict to, const void *restrict from, size_t count) {
  volatile uint8_t *byte = to;
  const uint8_t *next = from;
  while (count-- > 0) {
    *byte++ = *next++;
  }
  return to;
}

static void letter(char c) {
  while (uart_txfull_read() != 0) {}
  uart_rxtx_write((uint32_t)c);
}

static void text(const char *c) {
  while (*c != '\0') {
    letter(*c++);
  }
}

static void number(uint32_t n) {
  char digit[12];
  int i = 11;
  digit[i] = '\0';
  do {
    digit[--i] = (char)('0' + n % 10);
    n /= 10;
  } while (n != 0);
  letter(' ');
  text(digit + i);
}

/* ---------------------------------------------------------------- the driver's accesses */

static volatile uint32_t *const engine = (volatile uint32_t *)TREE_BASE;

static bool read_register(void *context, uint32_t address, uint32_t *value) {
  (void)context;
  *value = engine[address / 4];
  return true;
}

static bool write_register(void *context, uint32_t address, uint32_t value) {
  (void)context;
  engine[address / 4] = value;
  return true;
}

static bool receive(void *context, uint64_t *result, bool *last) {
  (void)context;
  uint32_t state = 0;
  do {
    state = tree_state_read();
  } while ((state & (1u << CSR_TREE_STATE_VALID_OFFSET)) == 0);
  *last = (state & (1u << CSR_TREE_STATE_LAST_OFFSET)) != 0;
  *result = tree_result_read();
  tree_take_write(1);
  return true;
}

/* The cache between bus and SDRAM keeps what was written; reading as many bytes again empties it.
 * The cache of the CPU writes through. */
static void flush(void) {
  const volatile uint32_t *word = (const volatile uint32_t *)(MAIN_RAM_BASE + 0x100000u);
  for (uint32_t i = 0; i < CONFIG_L2_SIZE / 4; i++) {
    (void)word[i];
  }
}

/* ---------------------------------------------------------------- questions and answers */

static uint8_t *ram(uint32_t place) { return (uint8_t *)(MAIN_RAM_BASE + place); }

static void found(void *context, const sepax_contact *contact) {
  (void)context;
  text("pair");
  number(contact->a);
  number(contact->b);
  text(contact->out_of_range ? " undecided\n" : "\n");
}

static int take_all(sepax_tree_device *device) {
  sepax_outcome outcome = {0};
  while (!outcome.last) {
    sepax_tree_device_status status = sepax_tree_device_take(device, found, NULL, &outcome);
    if (status != SEPAX_TREE_DEVICE_OK && status != SEPAX_TREE_DEVICE_NO_VERDICT) {
      text(sepax_tree_device_text(status));
      text("\n");
      return 2;
    }
    text("pose");
    number(outcome.pose);
    number(outcome.status);
    number(outcome.collisions);
    number(outcome.cycles);
    text("\n");
  }
  return 0;
}

static int ask(void) {
  const sepax_tree_device_bus bus = {NULL, read_register, write_register, receive};
  sepax_tree_device device;
  sepax_tree_device_status status = sepax_tree_device_open(&device, &bus);
  if (status != SEPAX_TREE_DEVICE_OK) {
    text(sepax_tree_device_text(status));
    text("\n");
    return 2;
  }
  static sepax_tree_device_work work;
  uint8_t *job = ram(RECORDS);
  uint8_t *pose = job + 4096;
  if (!sepax_tree_device_fits(&device, ram(TREE_A), ram(TREE_B)) ||
      !sepax_tree_device_body(work.body[0], ram(TREE_A), MAIN_RAM_BASE + TREE_A) ||
      !sepax_tree_device_body(work.body[1], ram(TREE_B), MAIN_RAM_BASE + TREE_B)) {
    text("the trees do not fit\n");
    return 2;
  }
  for (int i = 0; i < POSES; i++) {
    if (!sepax_tree_device_pose(pose + 256 * i, matrix_of[i], shift_of[i], device.word,
                                device.margin)) {
      text("a pose does not fit\n");
      return 2;
    }
  }
  work.poses = (uint32_t)pose;
  work.count = POSES;
  sepax_tree_device_job(job, &work);
  flush();
  status = sepax_tree_device_start(&device, (uint32_t)job, 1);
  if (status == SEPAX_TREE_DEVICE_OK && take_all(&device) == 0) {
    text("outside\n");
    bool busy = true;
    while (busy) {
      (void)sepax_tree_device_busy(&device, &busy);
    }
    status = sepax_tree_device_start(&device, MAIN_RAM_BASE + MAIN_RAM_SIZE, 1);
    if (status == SEPAX_TREE_DEVICE_OK) {
      return take_all(&device);
    }
  }
  text(sepax_tree_device_text(status));
  text("\n");
  return 2;
}

int main(void) {
  uart_ev_enable_write(0);
  text(ask() == 0 ? "end\n" : "failed\n");
  letter('\x04'); /* the simulation ends */
  return 0;
}
