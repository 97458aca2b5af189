/* SPDX-License-Identifier: MIT */
/* crowd.c - see crowd.h. */
#include "object_engine/crowd.h"
#include "object_engine/bus.h"
#include "sepax_vectors.h"

enum { ID = 0, ADDRESSES = 128, ACCESSES = 60, ROUNDS = 8 };

static sepax_random rng;
static uint32_t below(uint32_t end) { return (uint32_t)sepax_random_range(&rng, 0, end - 1); }
static uint32_t any_word(void) { return (uint32_t)sepax_random_range(&rng, 0, UINT32_MAX); }

static bool takes(const crowd_register *r, uint32_t value) {
  uint32_t sign = r->bits & ~(r->bits >> 1);
  bool is_negative = r->is_signed && (value & sign) != 0;
  return (value & ~r->bits) == (is_negative ? ~r->bits : 0);
}

/* Mostly what is taken, or nearly. */
static uint32_t some_value(uint32_t bits) {
  uint32_t value = any_word() & bits;
  switch (below(4)) {
  case 0:
    return value ^ UINT32_C(1) << below(32);
  case 1:
    return value | ~bits;
  default:
    return value;
  }
}

static bool is_known(const crowd_register *known, size_t count, uint32_t command,
                     uint32_t address) {
  for (size_t n = 0; n < count; n++) {
    if (known[n].address == address) {
      return true;
    }
  }
  return address == command;
}

/* Small numbers, which a register would take, to addresses that are none or can only be read. */
static void write_elsewhere(const crowd_register *known, size_t count, uint32_t command) {
  for (uint32_t at = 0; at < ADDRESSES; at++) {
    for (uint32_t value = 0; value < 8 && !is_known(known, count, command, at); value++) {
      expect("a write to what cannot be written", bus_write(NULL, at, value), 0);
    }
  }
}

void crowd(const crowd_register *known, size_t count, uint32_t command, uint64_t seed) {
  bool there[ADDRESSES];
  uint32_t value[ADDRESSES];
  rng.state = 1 + seed;
  for (uint32_t at = 0; at < ADDRESSES; at++) {
    there[at] = bus_read(NULL, at, &value[at]);
  }
  write_elsewhere(known, count, command);
  for (int round = 0; round < 2 * ROUNDS; round++) {
    bus_access list[ACCESSES];
    bool ok[ACCESSES];
    bool reads = round % 2 != 0;
    for (int n = 0; n < ACCESSES; n++) {
      const crowd_register *r = below(4) != 0 ? &known[below((uint32_t)count)] : NULL;
      bus_access *access = &list[n];
      *access = (bus_access){.address = r != NULL ? r->address : below(ADDRESSES)};
      if (reads || below(4) == 0) { /* beside writes, what never changes */
        access->address = reads ? access->address : ID;
        ok[n] = there[access->address];
        continue;
      }
      access->strobes = below(8) != 0 ? 15 : below(14) + 1;
      access->value = some_value(r != NULL ? r->bits : 7);
      for (size_t k = 0; k < count && r == NULL; k++) {
        r = known[k].address == access->address ? &known[k] : NULL;
      }
      if (access->address == command) {
        access->value |= 4; /* no command */
      }
      ok[n] = r != NULL && access->strobes == 15 && takes(r, access->value);
      if (ok[n] && !r->forgets) {
        value[r->address] = access->value;
      }
    }
    bus_crowd(list, ACCESSES, round % 4 < 2);
    for (int n = 0; n < ACCESSES; n++) {
      expect(list[n].strobes != 0 ? "one of many writes" : "one of many reads", list[n].ok, ok[n]);
      if (list[n].strobes == 0 && ok[n]) {
        expect("what one of many reads", list[n].value, value[list[n].address]);
      }
    }
  }
}
