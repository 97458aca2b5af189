/* SPDX-License-Identifier: MIT */
/* around.c - memories and buses around an engine as gates. */
#include "around.h"
#include "liberty/text.h"

#include <stdio.h>

enum { LANES = GATES_LANES, PATIENCE = 1000, RESET = 2 };

const uint64_t around_all = ~UINT64_C(0);

/* ------------------------------------------------------------------- memories */

/* Those of the lanes `of` that ask for the same word as the first of them. */
static uint64_t with_first(const gates *g, const memory *m, const int address[], uint64_t of,
                           uint64_t **word) {
  int bits = m->read_address->bits;
  uint64_t number = gates_get(g, address, bits, (unsigned)__builtin_ctzll(of));
  for (int k = 0; k < bits; k++) {
    of &= (number >> k & 1) != 0 ? g->value[address[k]] : ~g->value[address[k]];
  }
  *word = m->word + number * (uint64_t)m->read_data->bits;
  return of;
}

/* The rising edge: the old word is read, but seen by nothing yet. */
static void clock_memory(const gates *g, memory *m) {
  uint64_t *word;
  m->reads = *m->read;
  for (uint64_t left = m->reads; left != 0;) {
    uint64_t now = with_first(g, m, m->read_address->net, left, &word);
    for (int k = 0; k < m->read_data->bits; k++) {
      m->next[k] = (m->next[k] & ~now) | (word[k] & now);
    }
    left &= ~now;
  }
  for (uint64_t left = *m->write; left != 0;) {
    uint64_t now = with_first(g, m, m->write_address->net, left, &word);
    for (int k = 0; k < m->read_data->bits; k++) { /* some are written more than they keep */
      word[k] = (word[k] & ~now) | (g->value[m->write_data->net[k]] & now);
    }
    left &= ~now;
  }
}

static void show_read(gates *g, const memory *m) {
  for (int k = 0; k < m->read_data->bits && m->reads != 0; k++) {
    g->value[m->read_data->net[k]] = m->next[k];
  }
}

memory around_memory(memory m) {
  size_t words = (size_t)1 << m.read_address->bits;
  m.word = text_alloc(words * (size_t)m.read_data->bits, sizeof *m.word);
  m.next = text_alloc((size_t)m.read_data->bits, sizeof *m.next);
  return m;
}

/* ---------------------------------------------------------------------- buses */

static const gates_port *find(const gates *g, const char *group, const char *name, int bits) {
  char full[64];
  snprintf(full, sizeof full, "%s%s", group, name);
  return gates_find(g, full, bits);
}

channel around_channel(const gates *g, const char *bus, const char *word, int bits,
                       const char *response) {
  return (channel){.valid = &g->value[find(g, bus, "valid", 1)->net[0]],
                   .ready = &g->value[find(g, bus, "ready", 1)->net[0]],
                   .word = word == NULL ? NULL : find(g, bus, word, bits),
                   .response = response == NULL ? NULL : find(g, bus, response, 2)};
}

static void settle(around *a) {
  if (a->offer != NULL) {
    a->offer(a);
  }
  gates_settle(a->g);
}

/* The rest of a cycle whose inputs have settled. */
static void clock_edge(around *a) {
  a->take(a);
  gates_rise(a->g, a->count);
  for (int k = 0; k < a->memories; k++) {
    clock_memory(a->g, &a->memory[k]);
  }
  for (int k = 0; k < a->memories; k++) {
    show_read(a->g, &a->memory[k]);
  }
}

void around_tick(around *a) {
  settle(a);
  clock_edge(a);
}

void around_begin(around *a) {
  const gates *g = a->g;
  a->write_address = around_channel(g, "s_axi_aw", "addr", 0, NULL);
  a->write_data = around_channel(g, "s_axi_w", "data", 32, NULL);
  a->write_answer = around_channel(g, "s_axi_b", NULL, 0, "resp");
  a->read_address = around_channel(g, "s_axi_ar", "addr", 0, NULL);
  a->read_answer = around_channel(g, "s_axi_r", "data", 32, "resp");
  a->out = around_channel(g, "m_axis_t", "data", 64, NULL);
  a->out_last = gates_bit(g, "m_axis_tlast");
  gates_set_all(a->g, gates_find(g, "s_axi_wstrb", 4), 15);
  *a->write_answer.ready = *a->read_answer.ready = *a->out.ready = around_all;
  gates_reset(a->g, true);
  for (int k = 0; k < RESET; k++) {
    gates_settle(a->g);
    gates_rise(a->g, false);
  }
  gates_reset(a->g, false);
  around_tick(a);
}

void around_transfer(around *a, const channel *first, const channel *second, const channel *answer,
                     uint32_t data[GATES_LANES]) {
  const channel *const offer[2] = {first, second};
  uint64_t left[2] = {around_all, second == NULL ? 0 : around_all};
  uint64_t waits = answer == NULL ? 0 : around_all;
  for (int k = 0; k < PATIENCE && (left[0] | left[1] | waits) != 0; k++) {
    for (int n = 0; n < 2 && offer[n] != NULL; n++) {
      *offer[n]->valid = left[n];
    }
    settle(a);
    for (int n = 0; n < 2 && offer[n] != NULL; n++) {
      left[n] &= ~*offer[n]->ready;
    }
    uint64_t now = answer == NULL ? 0 : waits & *answer->valid;
    for (uint64_t lanes = now; lanes != 0; lanes &= lanes - 1) {
      unsigned l = (unsigned)__builtin_ctzll(lanes);
      a->wrong += gates_get(a->g, answer->response->net, 2, l) != 0;
      if (answer->word != NULL) {
        data[l] = (uint32_t)gates_get(a->g, answer->word->net, 32, l);
      }
    }
    waits &= ~now;
    clock_edge(a);
  }
  a->wrong += (uint64_t)__builtin_popcountll(left[0] | left[1] | waits);
  for (int n = 0; n < 2 && offer[n] != NULL; n++) {
    *offer[n]->valid = 0;
  }
}

void around_write_each(around *a, uint64_t address, const uint32_t data[GATES_LANES]) {
  gates_set_all(a->g, a->write_address.word, address);
  for (unsigned l = 0; l < LANES; l++) {
    gates_set(a->g, a->write_data.word->net, 32, l, data[l]);
  }
  around_transfer(a, &a->write_address, &a->write_data, &a->write_answer, NULL);
}

void around_write(around *a, uint64_t address, uint32_t data) {
  uint32_t each[LANES];
  for (int l = 0; l < LANES; l++) {
    each[l] = data;
  }
  around_write_each(a, address, each);
}

void around_read(around *a, uint64_t address, uint32_t data[GATES_LANES]) {
  gates_set_all(a->g, a->read_address.word, address);
  around_transfer(a, &a->read_address, NULL, &a->read_answer, data);
}
