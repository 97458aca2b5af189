/* SPDX-License-Identifier: MIT */
/* memory.c - see memory.h. */
#include "memory.h"

#include <stdio.h>
#include <string.h>

enum { PAGE = 4096, BURST_MAX = 16, OPEN = 32 };

uint64_t memory_draw(uint64_t *state) {
  uint64_t z = *state += 0x9e3779b97f4a7c15;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
  z = (z ^ z >> 27) * 0x94d049bb133111eb;
  return z ^ z >> 31;
}

/* True at rates that change from stretch to stretch; always without stress. */
static bool goes_on(memory *m) {
  static const uint64_t eighths[] = {1, 2, 4, 7, 8, 8, 8};
  if (m->options.stress == 0) {
    return true;
  }
  if (memory_draw(&m->state) % 256 == 0) {
    m->rate = memory_draw(&m->state) % (sizeof eighths / sizeof eighths[0]);
  }
  return memory_draw(&m->state) % 8 < eighths[m->rate];
}

static void breach(memory *m, const char *what, uint64_t address) {
  m->counts.breaches++;
  fprintf(stderr, "memory: cycle %llu, address %llx: %s\n", (unsigned long long)m->cycle,
          (unsigned long long)address, what);
}

void memory_open(memory *m, const memory_options *options) {
  memset(m, 0, sizeof *m);
  m->options = *options;
  m->state = options->stress;
}

void memory_reset(memory *m) {
  m->head = m->tail = m->beat = 0;
  m->counts.open = 0;
  m->was_blocked = false;
  m->slave.rvalid = false;
}

/* Each answer that AXI has for a read that went wrong, and RLAST at a wrong beat. */
static void spoil(memory *m, unsigned how) {
  m->is_bad = true;
  if (how == 0) {
    m->slave.rlast = !m->slave.rlast;
  } else {
    m->slave.rresp = how; /* EXOKAY, SLVERR, DECERR */
  }
}

static void answer(memory *m) {
  const memory_options *o = &m->options;
  memory_slave *s = &m->slave;
  uint64_t address = m->open[m->head].address + (uint64_t)MEMORY_BEAT * m->beat;
  s->rvalid = true;
  s->rlast = m->beat + 1 == m->open[m->head].beats;
  s->rresp = 0;
  m->is_bad = false;
  bool keeps = false;
  uint64_t offset = address - o->base;
  if (address < o->base || (offset + MEMORY_BEAT > o->size && !o->repeated)) {
    s->rresp = 3;
    m->is_bad = true;
  } else if ((address >= o->error_from && address < o->error_to) ||
             (o->error_odds > 0 && memory_draw(&m->state) % o->error_odds == 0)) {
    spoil(m, (unsigned)(memory_draw(&m->state) % 4));
  } else if (m->counts.beats + 1 == o->wrong_beat) {
    spoil(m, o->wrong_how);
    keeps = o->wrong_keeps;
  }
  for (int k = 0; k < 4; k++) { /* what comes with an error is not to be used */
    s->rdata[k] = (uint32_t)memory_draw(&m->state);
  }
  if (!m->is_bad || keeps) {
    const uint8_t *from = o->bytes + (o->repeated ? offset & (o->size - 1) : offset);
    for (int k = 0; k < 4; k++) {
      s->rdata[k] = (uint32_t)from[4 * k] | (uint32_t)from[4 * k + 1] << 8 |
                    (uint32_t)from[4 * k + 2] << 16 | (uint32_t)from[4 * k + 3] << 24;
    }
  }
}

/* A beat that belongs to no burst, where none can be on its way: an address that the master drives
 * may be taken in this cycle. */
static void offer_uncalled(memory *m) {
  memory_slave *s = &m->slave;
  m->is_uncalled = m->counts.open == 0 && !m->before.arvalid && memory_draw(&m->state) % 2 == 0;
  s->rvalid = m->is_uncalled;
  s->rresp = 0;
  s->rlast = memory_draw(&m->state) % 2 == 0;
  for (int k = 0; k < 4; k++) {
    s->rdata[k] = (uint32_t)memory_draw(&m->state);
  }
}

const memory_slave *memory_drive(memory *m) {
  bool blocked = m->options.stress != 0 && (m->cycle / 64 + m->options.stress) % 8 == 0;
  m->slave.arready = m->counts.open < MEMORY_OPEN_MAX && goes_on(m) && !blocked;
  if (!m->slave.rvalid && m->head != m->tail && m->cycle >= m->open[m->head].due && goes_on(m)) {
    answer(m);
  } else if (!m->slave.rvalid && m->options.uncalled) {
    offer_uncalled(m);
  }
  return &m->slave;
}

/* The cycle in which the first beat of a burst comes from its bank. */
static uint64_t come_from_bank(memory *m, uint64_t address) {
  enum { ROW_BYTES = 2048, HIT = 60, MISS = 110, HIT_BUSY = 4, MISS_BUSY = 50 };
  uint64_t row = address / ROW_BYTES;
  uint64_t n = row % MEMORY_BANKS;
  bool is_open = m->bank[n].row == row + 1;
  uint64_t begin = m->bank[n].free > m->cycle ? m->bank[n].free : m->cycle;
  m->bank[n].row = row + 1;
  m->bank[n].free = begin + (is_open ? HIT_BUSY : MISS_BUSY);
  return begin + (is_open ? HIT : MISS);
}

static void take_address(memory *m, const memory_master *master) {
  const memory_options *o = &m->options;
  unsigned beats = master->arlen + 1;
  if (beats > BURST_MAX) {
    breach(m, "a burst of more than 16 beats", master->araddr);
  }
  if (master->araddr % MEMORY_BEAT != 0) {
    breach(m, "a burst that is not aligned", master->araddr);
  }
  if (master->araddr / PAGE != (master->araddr + MEMORY_BEAT * (uint64_t)beats - 1) / PAGE) {
    breach(m, "a burst across 4 KB", master->araddr);
  }
  if (m->counts.open >= (o->open_max > 0 ? o->open_max : OPEN)) {
    breach(m, "too many bursts are open", master->araddr);
  }
  uint64_t late = o->stress == 0 || goes_on(m) ? 0 : memory_draw(&m->state) % 64;
  m->open[m->tail].address = master->araddr;
  m->open[m->tail].beats = beats;
  m->open[m->tail].due =
      late + (o->banked ? come_from_bank(m, master->araddr) : m->cycle + (uint64_t)o->latency);
  m->tail = (m->tail + 1) % MEMORY_OPEN_MAX;
  m->counts.bursts++;
  if (o->bursts != NULL && master->araddr >= o->base && master->araddr - o->base < o->size) {
    o->bursts[(master->araddr - o->base) / MEMORY_BEAT]++;
  }
  m->counts.open++;
  if (m->counts.open > m->counts.open_most) {
    m->counts.open_most = m->counts.open;
  }
}

void memory_clock(memory *m, const memory_master *master) {
  if (m->was_blocked && (!master->arvalid || master->araddr != m->before.araddr ||
                         master->arlen != m->before.arlen)) {
    breach(m, "an address moves before it is taken", m->before.araddr);
  }
  m->was_blocked = master->arvalid && !m->slave.arready;
  m->before = *master;
  if (m->is_uncalled) {
    if (master->rready) {
      breach(m, "a beat is taken that belongs to no burst", master->araddr);
    }
    m->is_uncalled = m->slave.rvalid = false;
  } else if (m->slave.rvalid && master->rready) {
    m->counts.beats++;
    m->counts.errors += m->is_bad;
    m->slave.rvalid = false;
    m->beat++;
    if (m->beat == m->open[m->head].beats) {
      m->beat = 0;
      m->head = (m->head + 1) % MEMORY_OPEN_MAX;
      m->counts.open--;
    }
  }
  if (master->arvalid && m->slave.arready) {
    take_address(m, master);
  }
  m->cycle++;
}
