/* gates.c - simulates a mapped netlist, 64 lanes at once. */
#include "gates.h"
#include "liberty/text.h"
#include "sepax_vectors.h"

#include <stdio.h>
#include <string.h>

int gates_find(const gates *g, const char *name, int bit) {
  char full[320];
  if (bit < 0) {
    snprintf(full, sizeof full, "%s", name);
  } else {
    snprintf(full, sizeof full, "%s[%d]", name, bit);
  }
  for (int k = 0; k < g->ports; k++) {
    if (strcmp(g->port[k].name, full) == 0) {
      return g->port[k].net;
    }
  }
  text_fail("has no port", full);
}

int gates_bits(const gates *g, const char *name, int most) {
  size_t length = strlen(name);
  int bits = 0;
  for (int k = 0; k < g->ports; k++) {
    const char *port = g->port[k].name;
    bits += strncmp(port, name, length) == 0 && (port[length] == '[' || port[length] == '\0');
  }
  if (bits > most) {
    text_fail("has too many bits of", name);
  }
  return bits;
}

void gates_find_word(const gates *g, const char *name, int bits, int net[]) {
  for (int bit = 0; bit < bits; bit++) {
    net[bit] = gates_find(g, name, bits == 1 ? -1 : bit);
  }
}

void gates_set(gates *g, const int net[], int bits, unsigned lane, uint64_t value) {
  uint64_t mask = UINT64_C(1) << lane;
  for (int k = 0; k < bits; k++) {
    g->value[net[k]] = (value >> k & 1) != 0 ? g->value[net[k]] | mask : g->value[net[k]] & ~mask;
  }
}

void gates_set_all(gates *g, const int net[], int bits, uint64_t value) {
  for (int k = 0; k < bits; k++) {
    g->value[net[k]] = (value >> k & 1) != 0 ? ~UINT64_C(0) : 0;
  }
}

uint64_t gates_get(const gates *g, const int net[], int bits, unsigned lane) {
  uint64_t value = 0;
  for (int k = 0; k < bits; k++) {
    value |= (g->value[net[k]] >> lane & 1) << k;
  }
  return value;
}

/* -------------------------------------------------------------------- simulation */

static void evaluate(gates *g, const gates_cell *cell) {
  uint64_t in[LIB_PINS];
  const lib_cell *type = cell->type;
  for (int p = 0; p < type->pins; p++) {
    in[p] = cell->net[p] >= 0 ? g->value[cell->net[p]] : 0;
  }
  for (int p = 0; p < type->pins; p++) {
    if (type->pin[p].output && cell->net[p] >= 0) {
      g->value[cell->net[p]] = lib_evaluate(&type->pin[p].function, in, cell->state);
    }
  }
}

void gates_scramble(gates *g) {
  sepax_random random = {1};
  for (int c = 0; c < g->cells; c++) {
    g->cell[c].state = sepax_random_next(&random);
  }
}

void gates_settle(gates *g) {
  for (int c = 0; c < g->cells; c++) {
    if (g->cell[c].type->register_) {
      evaluate(g, &g->cell[c]);
    }
  }
  for (int k = 0; k < g->ordered; k++) {
    evaluate(g, &g->cell[g->order[k]]);
  }
}

static unsigned ones_of(uint64_t x) {
  x -= x >> 1 & UINT64_C(0x5555555555555555);
  x = (x & UINT64_C(0x3333333333333333)) + (x >> 2 & UINT64_C(0x3333333333333333));
  return (unsigned)(((x + (x >> 4)) & UINT64_C(0x0f0f0f0f0f0f0f0f)) *
                        UINT64_C(0x0101010101010101) >>
                    56);
}

void gates_rise(gates *g, bool count) {
  if (count) {
    g->cycles++;
    for (int k = 0; k < g->nets; k++) {
      g->toggles[k] += ones_of(g->value[k] ^ g->before[k]);
      g->ones[k] += ones_of(g->value[k]);
    }
  }
  memcpy(g->before, g->value, (size_t)g->nets * sizeof *g->before);
  for (int c = 0; c < g->cells; c++) {
    gates_cell *cell = &g->cell[c];
    if (!cell->type->register_) {
      continue;
    }
    uint64_t in[LIB_PINS];
    for (int p = 0; p < cell->type->pins; p++) {
      in[p] = cell->net[p] >= 0 ? g->value[cell->net[p]] : 0;
    }
    cell->state = lib_evaluate(&cell->type->next, in, cell->state);
  }
}
