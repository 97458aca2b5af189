/* SPDX-License-Identifier: MIT */
/* main.c - firmware: asks the tree engine about two bodies that lie in the SDRAM, in the poses of
 * scene.h: for all pairs, and for the first one. Then it gives the engine what is not wholly in the
 * SDRAM, and asks once more. Each answer is a line on the UART; soc.py compares them with the
 * library's. */
#include "bytes.h"
#include "sepax_tree_driver.h"
#include "sepax_tree_registers.h"

#include <generated/csr.h>
#include <generated/mem.h>
#include <generated/soc.h>

#include "scene.h"

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

/* The numbers of a pose, in the order in which the engine sends them. */
static void tell(const sepax_outcome *o) {
  const uint32_t numbers[] = {o->steps,        o->status,   o->job,        o->pose,
                              o->cycles,       o->near,     o->collisions, o->warnings,
                              o->out_of_range, o->pairs,    o->rows,       o->entries,
                              o->first[0],     o->first[1], o->row[0],     o->row[1]};
  text("pose");
  for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
    number(numbers[i]);
  }
  text("\n");
}

/* Start a batch of one job, and tell all its answers. */
static bool batch(sepax_tree_device *device, const char *name, uint32_t job) {
  text("batch ");
  text(name);
  text("\n");
  bool busy = true;
  while (busy) {
    (void)sepax_tree_device_busy(device, &busy);
  }
  sepax_tree_device_status status = sepax_tree_device_start(device, job, 1);
  sepax_outcome outcome = {0};
  while (status == SEPAX_TREE_DEVICE_OK && !outcome.last) {
    status = sepax_tree_device_take(device, found, NULL, &outcome);
    if (status == SEPAX_TREE_DEVICE_OK || status == SEPAX_TREE_DEVICE_NO_VERDICT) {
      tell(&outcome);
      status = SEPAX_TREE_DEVICE_OK;
    }
  }
  if (status != SEPAX_TREE_DEVICE_OK) {
    text(sepax_tree_device_text(status));
    text("\n");
  }
  return status == SEPAX_TREE_DEVICE_OK;
}

/* Jobs in the SDRAM: all pairs, the first pair, a body and a queue of poses that are not wholly in
 * the SDRAM. */
enum { ALL, FIRST, BODY, POSE };
#define END (MAIN_RAM_BASE + MAIN_RAM_SIZE)
#define PAGE 4096u /* its nodes are in the first page of a body, its triangles in the others */

static bool write_records(const sepax_tree_device *device, uint8_t *job) {
  static sepax_tree_device_work work;
  uint8_t *pose = job + PAGE;
  if (!sepax_tree_device_fits(device, ram(TREE_A), ram(TREE_B)) ||
      !sepax_tree_device_body(work.body[0], ram(TREE_A), MAIN_RAM_BASE + TREE_A) ||
      !sepax_tree_device_body(work.body[1], ram(TREE_B), MAIN_RAM_BASE + TREE_B)) {
    text("the trees do not fit\n");
    return false;
  }
  for (int i = 0; i < POSES; i++) {
    if (!sepax_tree_device_pose(pose + 256 * i, matrix_of[i], shift_of[i], device->word,
                                device->margin)) {
      text("a pose does not fit\n");
      return false;
    }
  }
  work.poses = (uint32_t)pose;
  work.count = POSES;
  sepax_tree_device_job(job + ALL * SEPAX_TREE_DEVICE_JOB, &work);
  work.modes = SEPAX_TREE_DEVICE_FIRST | SEPAX_TREE_DEVICE_QUIET;
  sepax_tree_device_job(job + FIRST * SEPAX_TREE_DEVICE_JOB, &work);
  work.poses = END;
  sepax_tree_device_job(job + POSE * SEPAX_TREE_DEVICE_JOB, &work);
  work.poses = (uint32_t)pose;
  memcpy((uint8_t *)(END - PAGE), ram(TREE_B), PAGE);
  (void)sepax_tree_device_body(work.body[1], ram(TREE_B), END - PAGE);
  sepax_tree_device_job(job + BODY * SEPAX_TREE_DEVICE_JOB, &work);
  return true;
}

static bool ask(void) {
  const sepax_tree_device_bus bus = {NULL, read_register, write_register, receive};
  sepax_tree_device device;
  sepax_tree_device_status status = sepax_tree_device_open(&device, &bus);
  if (status != SEPAX_TREE_DEVICE_OK) {
    text(sepax_tree_device_text(status));
    text("\n");
    return false;
  }
  uint8_t *job = ram(RECORDS);
  if (!write_records(&device, job)) {
    return false;
  }
  flush();
  uint32_t at = (uint32_t)job;
  return batch(&device, "all", at + ALL * SEPAX_TREE_DEVICE_JOB) &&
         batch(&device, "first", at + FIRST * SEPAX_TREE_DEVICE_JOB) &&
         batch(&device, "triangles", at + BODY * SEPAX_TREE_DEVICE_JOB) &&
         batch(&device, "poses", at + POSE * SEPAX_TREE_DEVICE_JOB) &&
         batch(&device, "jobs", END) && batch(&device, "again", at + FIRST * SEPAX_TREE_DEVICE_JOB);
}

int main(void) {
  uart_ev_enable_write(0);
  text(ask() ? "end\n" : "failed\n");
  letter('\x04'); /* the simulation ends */
  return 0;
}
