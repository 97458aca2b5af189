/* SPDX-License-Identifier: MIT */
/* glitches.c - changes between two edges: pulses by hand, and random gates beside a simulation of
 * one lane after another by a queue of events. */
#include "harness.h"
#include "power/glitches.h"

#include <string.h>

/* Gates of two inputs, by their truth tables: row 0 is 00, row 1 is 01 (pin 0 is 1) ... */
enum { XOR = 6, NAND = 7, AND = 8, OR = 14, GATES = 24, INPUTS = 8, NETS = 2 + INPUTS + GATES };

static lib_cell types[16];
static gates_cell cells[GATES];
static gates circuit;
static uint64_t value[NETS], before[NETS];
static int input_nets[INPUTS];
static cell_delays delays[GATES];
static double share = 1;

/* Pins 0 and 1 are inputs, pin 2 is the output. */
static const lib_cell *type_of(int table) {
  lib_cell *type = &types[table];
  type->pins = 3;
  type->inputs = 2;
  type->pin[2].output = true;
  type->pin[2].rows = (uint64_t)table;
  return type;
}

/* The counter of a share is made once: it is freed by nobody. */
static void begin_circuit(void) {
  static gates_port port;
  static gates counter[2];
  for (int k = 0; k < INPUTS; k++) {
    input_nets[k] = 2 + k;
  }
  port = (gates_port){.name = "in", .bits = INPUTS, .net = input_nets};
  gates *c = &counter[share < 1];
  if (c->glitches == NULL) {
    *c = (gates){
        .cell = cells, .port = &port, .ports = 1, .nets = NETS, .value = value, .before = before};
    glitches_begin(c, delays, share);
  }
  circuit = *c;
  memset(value, 0, sizeof value);
  memset(before, 0, sizeof before);
  value[1] = before[1] = ~UINT64_C(0);
}

/* Returns its output's net. */
static int add_gate(int table, int a, int b, int delay_a, int delay_b) {
  int c = circuit.cells++;
  int out = 2 + INPUTS + c;
  cells[c] = (gates_cell){.type = type_of(table), .name = "gate", .net = {a, b, out}};
  static uint16_t of_cell[GATES][9];
  delays[c] = of_cell[c];
  delays[c][0 * 3 + 2] = (uint16_t)delay_a;
  delays[c][1 * 3 + 2] = (uint16_t)delay_b;
  return out;
}

static uint64_t changes_of(int net) {
  uint64_t sum = 0;
  for (int k = 0; k < GATES_GROUPS; k++) {
    sum += circuit.changes[net][k];
  }
  return sum;
}

/* From one set of inputs to another. */
static void count_changes(const uint64_t from[], const uint64_t to[]) {
  for (int k = 0; k < INPUTS; k++) {
    value[2 + k] = from[k];
  }
  gates_settle(&circuit);
  memcpy(before, value, sizeof before);
  memset(circuit.changes, 0, NETS * sizeof *circuit.changes);
  for (int k = 0; k < INPUTS; k++) {
    value[2 + k] = to[k];
  }
  gates_settle(&circuit);
  glitches_count(&circuit);
}

/* x ^ !x, the second by a way of `late` ps: two changes for each of x, where the pulse is long
 * enough for the last gate. */
static uint64_t pulse(int late, int delay_a, int delay_b, uint64_t lanes) {
  begin_circuit();
  int not = add_gate(NAND, 2, 1, late, late);
  int out = add_gate(XOR, 2, not, delay_a, delay_b);
  count_changes((uint64_t[INPUTS]){0}, (uint64_t[INPUTS]){lanes});
  assert_int_equal(changes_of(2), __builtin_popcountll(lanes));
  assert_int_equal(changes_of(not ), __builtin_popcountll(lanes));
  return changes_of(out);
}

CASE(pulses_by_hand) {
  assert_int_equal(pulse(30, 20, 20, 1), 2);
  assert_int_equal(pulse(30, 20, 20, 0x8000000000000401), 6);
  assert_int_equal(pulse(30, 30, 30, 1), 2);
  assert_int_equal(pulse(30, 31, 31, 1), 0); /* shorter than the delay */
  assert_int_equal(pulse(30, 10, 60, 1), 2); /* from 10 to 90, which 60 ps let pass */
  assert_int_equal(pulse(30, 60, 10, 1), 0); /* from 40 to 60, ended by what takes 60 */
  assert_int_equal(pulse(30, 40, 10, 1), 0); /* both at 40: none */
  assert_int_equal(pulse(0, 5, 5, ~UINT64_C(0)), 0);
  share = 0.5;
  assert_int_equal(pulse(30, 60, 60, 1), 2);
  assert_int_equal(pulse(30, 62, 62, 1), 0);
  share = 1;
}

/* One lane: an event is a new value of a net; a gate has one at most that is still to come, which a
 * later one replaces (inertial delay). */
static void simulate_lane(unsigned lane, int *changes, const int delay[]) {
  bool now[NETS];
  int when[NETS];
  bool then[NETS];
  for (int k = 0; k < NETS; k++) {
    now[k] = before[k] >> lane & 1;
    when[k] = -1;
    changes[k] = 0;
  }
  for (int k = 0; k < INPUTS; k++) {
    when[2 + k] = 0;
    then[2 + k] = value[2 + k] >> lane & 1;
  }
  for (int time = 0; time < 100000; time++) {
    bool moved[NETS] = {false};
    for (int k = 0; k < NETS; k++) {
      if (when[k] == time) {
        when[k] = -1;
        moved[k] = now[k] != then[k];
        changes[k] += moved[k];
        now[k] = then[k];
      }
    }
    bool waits = false;
    for (int c = 0; c < circuit.cells; c++) {
      const gates_cell *cell = &cells[c];
      int out = cell->net[2];
      if (moved[cell->net[0]] || moved[cell->net[1]]) {
        unsigned row = (unsigned)now[cell->net[0]] | (unsigned)now[cell->net[1]] << 1;
        bool to = cell->type->pin[2].rows >> row & 1;
        if (to == now[out]) {
          when[out] = -1;
        } else if (when[out] < 0) {
          when[out] = time + delay[c];
          then[out] = to;
        }
      }
      waits |= when[out] >= 0;
    }
    if (!waits && time > 0) {
      return;
    }
  }
  fail_msg("lane %u does not settle", lane);
}

CASE(random_gates) {
  static const int tables[] = {XOR, NAND, AND, OR};
  uint64_t glitches = 0;
  sepax_random random = {1};
  for (int round = 0; round < 60; round++) {
    begin_circuit();
    int delay[GATES];
    uint64_t from[INPUTS];
    uint64_t to[INPUTS];
    for (int c = 0; c < GATES; c++) {
      int last = 1 + INPUTS + c;
      delay[c] = (int)sepax_random_range(&random, 1, 40);
      add_gate(tables[sepax_random_range(&random, 0, 3)],
               (int)sepax_random_range(&random, last > 16 ? last - 10 : 2, last),
               (int)sepax_random_range(&random, 2, last), delay[c], delay[c]);
    }
    for (int k = 0; k < INPUTS; k++) {
      from[k] = sepax_random_next(&random);
      to[k] = sepax_random_next(&random);
    }
    count_changes(from, to);
    uint64_t expected[NETS] = {0};
    for (unsigned lane = 0; lane < GATES_LANES; lane++) {
      int changes[NETS];
      simulate_lane(lane, changes, delay);
      for (int k = 0; k < NETS; k++) {
        expected[k] += (uint64_t)changes[k];
      }
    }
    for (int k = 0; k < NETS; k++) {
      assert_int_equal(changes_of(k), expected[k]);
      glitches += expected[k] - (uint64_t)__builtin_popcountll(value[k] ^ before[k]);
    }
  }
  assert_true(glitches > 1000);
}
