/* SPDX-License-Identifier: MIT */
/* refusals.c - what the engine refuses, its settings, interrupts, and the end of a run. */
#include "bench.h"

static uint32_t value_of(uint32_t address) {
  uint32_t value = 0;
  expect("a register can be read", bus_read(NULL, address, &value), 1);
  return value;
}

/* So many vertices of an object; coordinate `which` of the whole is `value`, the others are 1. */
static void send_one(size_t beats, size_t which, int32_t value, bool to_b) {
  for (size_t i = 0; i < beats; i++) {
    int32_t vertex[3];
    for (size_t k = 0; k < 3; k++) {
      vertex[k] = 3 * i + k == which ? value : 1;
    }
    expect("a vertex is taken", bus_send(NULL, vertex, i == beats - 1, to_b), 1);
  }
}

static void send_beats(size_t beats, bool to_b) { send_one(beats, 0, 1, to_b); }

/* Each bit beyond those that a register has: 1, and 0 in a number below 0. */
static void single_bits(void) {
  static const uint32_t move[3] = {SEPAX_MOVE_X, SEPAX_MOVE_Y, SEPAX_MOVE_Z};
  for (uint32_t k = 2; k < 32; k++) {
    const uint32_t bit = UINT32_C(1) << k;
    expect("a bit of MODE", bus_write(NULL, SEPAX_MODE, bit), 0);
    expect("a bit of STOP", bus_write(NULL, SEPAX_COMMAND, bit | SEPAX_COMMAND_STOP), 0);
    expect("a bit of START", bus_write(NULL, SEPAX_COMMAND, bit | SEPAX_COMMAND_START), 0);
    if (k > 2) {
      expect("a bit of ENABLE", bus_write(NULL, SEPAX_ENABLE, bit), 0);
      expect("a bit of PENDING", bus_write(NULL, SEPAX_PENDING, bit), 0);
    }
    for (int i = 0; i < 3 && k >= SEPAX_WORD; i++) {
      expect("a bit of a move", bus_write(NULL, move[i], bit), k == 31 && SEPAX_WORD == 31);
      expect("a bit of a move back", bus_write(NULL, move[i], ~bit), SEPAX_WORD > 30);
    }
  }
  for (unsigned strobes = 0; strobes < 15; strobes++) {
    expect("a write of bytes", bus_write_part(SEPAX_ENABLE, 1, strobes), 0);
  }
  expect("nobody has set a bit", value_of(SEPAX_MODE) | value_of(SEPAX_ENABLE), 0);
}

/* Objects of 1, 2, 4 ... triangles, and coordinates of which one bit is beyond the word. */
static void counts_and_words(void) {
  static const struct {
    uint32_t memory, number, loaded;
  } object[2] = {{SEPAX_MEMORY_A, SEPAX_COUNT_A, SEPAX_STATUS_LOADED_A},
                 {SEPAX_MEMORY_B, SEPAX_COUNT_B, SEPAX_STATUS_LOADED_B}};
  for (int to_b = 0; to_b < 2; to_b++) {
    for (uint32_t count = 1; count <= object[to_b].memory; count *= 2) {
      send_beats(3 * (size_t)count, to_b);
      expect("COUNT", value_of(object[to_b].number), count);
      expect("an object is loaded", value_of(SEPAX_STATUS) & object[to_b].loaded,
             object[to_b].loaded);
    }
  }
  for (int k = SEPAX_WORD - 1; k < 31 && SEPAX_WORD < 32; k++) {
    for (size_t which = 0; which < 3; which++) {
      for (int back = 0; back < 2; back++) {
        send_one(3, which, back ? ~(INT32_C(1) << k) : INT32_C(1) << k, false);
        expect("a bit beyond the word", value_of(SEPAX_STATUS) & SEPAX_STATUS_WORD,
               SEPAX_STATUS_WORD);
      }
    }
  }
}

/* Settings: what they take, what they refuse, and that nobody changes another's. */
static void settings(void) {
  static const uint32_t move[3] = {SEPAX_MOVE_X, SEPAX_MOVE_Y, SEPAX_MOVE_Z};
  static const uint32_t zero[] = {SEPAX_MODE,   SEPAX_ENABLE, SEPAX_PENDING,
                                  SEPAX_MOVE_X, SEPAX_MOVE_Y, SEPAX_MOVE_Z};
  for (size_t i = 0; i < sizeof zero / sizeof zero[0]; i++) {
    expect("a setting after reset", value_of(zero[i]), 0);
  }
  expect("a bit that MODE has not", bus_write(NULL, SEPAX_MODE, 4), 0);
  expect("a bit that ENABLE has not", bus_write(NULL, SEPAX_ENABLE, 8), 0);
  expect("a command that is none", bus_write(NULL, SEPAX_COMMAND, 3), 0);
  for (uint32_t i = 0; i < 3; i++) {
    uint32_t far = UINT32_C(1) << (SEPAX_WORD < 31 ? SEPAX_WORD : 31);
#if SEPAX_WORD < 31
    expect("a move too far", bus_write(NULL, move[i], far), 0);
    expect("a move too far back", bus_write(NULL, move[i], 0u - far - 1), 0);
#endif
    expect("the farthest move", bus_write(NULL, move[i], 0u - far + i), 1);
  }
  for (uint32_t i = 0; i < 3; i++) {
    uint32_t far = UINT32_C(1) << (SEPAX_WORD < 31 ? SEPAX_WORD : 31);
    expect("it reads back", value_of(move[i]), 0u - far + i);
    expect("no move", bus_write(NULL, move[i], 0), 1);
  }
  expect("MODE", bus_write(NULL, SEPAX_MODE, 2), 1);
  expect("MODE reads back", value_of(SEPAX_MODE), 2);
  expect("STOP while idle", bus_write(NULL, SEPAX_COMMAND, SEPAX_COMMAND_STOP), 1);
  expect("nothing was stopped", value_of(SEPAX_STATUS), 0);
}

/* Many accesses at once. */
static void many_accesses(void) {
  const uint32_t move = SEPAX_WORD < 31 ? (UINT32_C(2) << SEPAX_WORD) - 1 : UINT32_MAX;
  const crowd_register known[] = {
      {SEPAX_MODE, 3, false, false},     {SEPAX_ENABLE, 7, false, false},
      {SEPAX_PENDING, 7, false, true},   {SEPAX_MOVE_X, move, true, false},
      {SEPAX_MOVE_Y, move, true, false}, {SEPAX_MOVE_Z, move, true, false}};
  bus_reset();
  crowd(known, sizeof known / sizeof known[0], SEPAX_COMMAND, 1);
}

void refusals(void) {
  uint32_t value = 0;
  many_accesses();
  bus_reset();
  expect("nothing is loaded after reset", value_of(SEPAX_STATUS), 0);
  expect("START without objects", bus_write(NULL, SEPAX_COMMAND, SEPAX_COMMAND_START), 0);
  for (uint32_t address = 0; address < 0x80; address++) {
    bool known = address % 4 == 0 && address <= SEPAX_FIRST_B && address != SEPAX_COMMAND;
    expect("which addresses can be read", bus_read(NULL, address, &value), known);
    if (address % 4 != 0) {
      expect("a write that is not aligned", bus_write(NULL, address, 1), 0);
    }
  }
  expect("a write to ID", bus_write(NULL, SEPAX_ID, 1), 0);
  single_bits();
  settings();
  counts_and_words();
  bus_reset();
  send_beats(3, true);
  expect("START without A", bus_write(NULL, SEPAX_COMMAND, SEPAX_COMMAND_START), 0);
  bus_reset();
  send_beats(3, false);
  expect("A is loaded", value_of(SEPAX_STATUS), SEPAX_STATUS_LOADED_A);
  expect("COUNT_A", value_of(SEPAX_COUNT_A), 1);
  send_beats(4, true);
  expect("an object that ends within a triangle", value_of(SEPAX_STATUS),
         SEPAX_STATUS_LOADED_A | SEPAX_STATUS_PARTIAL);
#if SEPAX_WORD < 32
  for (size_t which = 0; which < 9; which++) {
    send_one(3, which,
             which % 2 == 0 ? INT32_C(1) << (SEPAX_WORD - 1)
                            : -(INT32_C(1) << (SEPAX_WORD - 1)) - 1,
             true);
    expect("a coordinate that does not fit", value_of(SEPAX_STATUS),
           SEPAX_STATUS_LOADED_A | SEPAX_STATUS_WORD);
    send_one(3, which, -(INT32_C(1) << (SEPAX_WORD - 1)), true);
    expect("one that just fits", value_of(SEPAX_STATUS),
           SEPAX_STATUS_LOADED_A | SEPAX_STATUS_LOADED_B);
  }
#endif
  send_beats(3 * (size_t)SEPAX_MEMORY_A + 3, false);
  expect("more than A's memory holds",
         value_of(SEPAX_STATUS) & (SEPAX_STATUS_LOADED_A | SEPAX_STATUS_FULL), SEPAX_STATUS_FULL);
  send_beats(3 * (size_t)SEPAX_MEMORY_A + 1, false);
  expect("a vertex more, which is no triangle",
         value_of(SEPAX_STATUS) & (SEPAX_STATUS_FULL | SEPAX_STATUS_PARTIAL), SEPAX_STATUS_PARTIAL);
  send_beats(3 * (size_t)SEPAX_MEMORY_A + 5, false);
  expect("more, and not whole",
         value_of(SEPAX_STATUS) &
             (SEPAX_STATUS_LOADED_A | SEPAX_STATUS_FULL | SEPAX_STATUS_PARTIAL),
         SEPAX_STATUS_FULL | SEPAX_STATUS_PARTIAL);
  send_beats(3, false);
  expect("PENDING clears", bus_write(NULL, SEPAX_PENDING, 7), 1);
  send_beats(3 * (size_t)SEPAX_MEMORY_B + 3, true);
  expect("an object has come", value_of(SEPAX_PENDING), SEPAX_PENDING_LOADED);
  expect("more than the memory holds", value_of(SEPAX_STATUS),
         SEPAX_STATUS_LOADED_A | SEPAX_STATUS_FULL);
  expect("START without B", bus_write(NULL, SEPAX_COMMAND, SEPAX_COMMAND_START), 0);
  send_beats(3 * (size_t)SEPAX_MEMORY_B, true);
  expect("a full memory", value_of(SEPAX_COUNT_B), SEPAX_MEMORY_B);
  const int32_t vertex[3] = {1, 1, 1};
  expect("a first vertex", bus_send(NULL, vertex, false, false), 1);
  expect("an object is under way", value_of(SEPAX_STATUS),
         SEPAX_STATUS_LOADED_B | SEPAX_STATUS_LOADING);
  expect("START meanwhile", bus_write(NULL, SEPAX_COMMAND, SEPAX_COMMAND_START), 0);
  expect("a second vertex", bus_send(NULL, vertex, false, true), 1);
  expect("the last", bus_send(NULL, vertex, true, true), 1);
  expect("tdest of the first vertex counts", value_of(SEPAX_COUNT_A), 1);
}

/* Triangles of B in the many runs of controls(). */
enum { SHORT = SEPAX_MEMORY_B < 128 ? SEPAX_MEMORY_B : 128 };

/* A run is over. */
static void wait_for_end(void) {
  enum { MOST = 100000 + 2 * SEPAX_II * SEPAX_MEMORY_B };
  for (int reads = 0; reads < MOST && (value_of(SEPAX_STATUS) & SEPAX_STATUS_BUSY) != 0;) {
    reads++;
  }
  expect("a run ends", value_of(SEPAX_STATUS) & SEPAX_STATUS_BUSY, 0);
}

static void start(void) { expect("START", bus_write(NULL, SEPAX_COMMAND, SEPAX_COMMAND_START), 1); }

/* A vertex is offered in each of the cycles about START: it comes before, and START is refused, or
 * behind the run. */
static void vertex_beside_start(bool paced) {
  const int32_t vertex[3] = {1, 1, 1};
  int before = 0;
  for (uint64_t after = 1; after < 12; after++) {
    bus_offer(vertex, false, false, after);
    if (bus_write(NULL, SEPAX_COMMAND, SEPAX_COMMAND_START)) {
      for (uint32_t status = SEPAX_STATUS_BUSY; (status & SEPAX_STATUS_BUSY) != 0;) {
        status = value_of(SEPAX_STATUS);
        expect("no vertex is taken in a run",
               (status & SEPAX_STATUS_BUSY) != 0 && (status & SEPAX_STATUS_LOADING) != 0, 0);
      }
      expect("all pairs of a run beside which a vertex waits", value_of(SEPAX_COLLISIONS), SHORT);
    } else {
      before++;
    }
    expect("a vertex beside START", bus_sent(), 1);
    expect("its object is under way", value_of(SEPAX_STATUS) & SEPAX_STATUS_LOADING,
           SEPAX_STATUS_LOADING);
    send_beats(2, false);
    expect("it is whole", value_of(SEPAX_COUNT_A), 1);
  }
  expect("some come before START", !paced || (before > 0 && before < 11), 1);
}

/* A vertex is offered in each of the cycles about a write that is no START: it does not wait. */
static void vertex_beside_write(bool paced) {
  static const uint32_t write[2][2] = {{SEPAX_ENABLE, 1}, {SEPAX_COMMAND, SEPAX_COMMAND_STOP}};
  const int32_t vertex[3] = {1, 1, 1};
  for (int n = 0; n < 2; n++) {
    for (uint64_t after = 1; after < 12; after++) {
      uint64_t begun = bus_cycles();
      bus_offer(vertex, false, false, after);
      expect("a write beside a vertex", bus_write(NULL, write[n][0], write[n][1]), 1);
      expect("a vertex beside a write", bus_sent(), 1);
      expect("it comes when it is offered", paced ? bus_came() + 1 - begun : after, after);
      send_beats(2, false);
    }
  }
  expect("ENABLE", bus_write(NULL, SEPAX_ENABLE, 0), 1);
}

/* PENDING is cleared in each of the cycles about an event: it stands until it is cleared behind
 * that, and the interrupt comes as ever. */
static void clear_beside(uint32_t bit, bool of_a_vertex) {
  const int32_t vertex[3] = {1, 1, 1};
  uint64_t delay = 0;
  int stands = 0;
  expect("ENABLE", bus_write(NULL, SEPAX_ENABLE, bit), 1);
  for (uint64_t after = 0; after < 40; after++) {
    uint64_t wait = 0;
    expect("PENDING clears", bus_write(NULL, SEPAX_PENDING, 7), 1);
    bus_idle(10);
    if (of_a_vertex) {
      expect("a vertex", bus_send(NULL, vertex, false, false), 1);
      expect("a vertex", bus_send(NULL, vertex, false, false), 1);
      bus_offer(vertex, true, false, after + 1);
      wait = 10;
    } else {
      start();
      wait = (delay > 20 ? delay - 20 : 0) + after;
    }
    uint64_t begun = bus_responded();
    bus_idle(wait);
    expect("PENDING clears", bus_write(NULL, SEPAX_PENDING, 7), 1);
    uint64_t cleared = bus_responded();
    expect("a vertex", bus_sent(), 1);
    wait_for_end();
    bus_idle(4);
    begun = of_a_vertex ? bus_came() : begun;
    if (delay == 0) {
      delay = bus_rose() - begun;
    }
    expect("the interrupt comes so many cycles behind its cause", bus_rose() - begun, delay);
    expect("PENDING beside a write to it", value_of(SEPAX_PENDING) & bit,
           bus_rose() >= cleared ? bit : 0);
    stands += bus_rose() >= cleared;
  }
  expect("some are cleared, some stand", stands > 1 && stands < 39, 1);
}

/* All results of a run: the last of them. */
static uint64_t last_result(void) {
  uint64_t result = 0;
  for (bool last = false; !last && bus_receive(NULL, &result, &last);) {}
  return result;
}

/* STOP in each of the cycles about the end of a run: STATUS and the last transfer say the same. */
static void stop_beside_end(bool paced) {
  enum { AROUND = 25 };
  int stopped = 0;
  start();
  last_result();
  wait_for_end();
  uint64_t cycles = value_of(SEPAX_CYCLES);
  for (uint64_t after = 0; after < 2 * AROUND; after++) {
    start();
    bus_idle(after + (cycles > AROUND ? cycles - AROUND : 0));
    expect("STOP", bus_write(NULL, SEPAX_COMMAND, SEPAX_COMMAND_STOP), 1);
    uint64_t last = last_result();
    wait_for_end();
    expect("STATUS and the last transfer about STOP",
           (value_of(SEPAX_STATUS) & SEPAX_STATUS_STOPPED) != 0, last >> 62 & 1);
    stopped += (last >> 62 & 1) != 0;
  }
  expect("STOP comes before the end, and behind it",
         !paced || (stopped > 0 && stopped < 2 * AROUND), 1);
}

/* A run of which nobody takes results for a while, then STOP. `around`: cycles from START to the
 * interrupt that are not of the run. */
static void nobody_takes(uint64_t blocked, uint64_t around, bool paced) {
  static const uint32_t move[3] = {SEPAX_MOVE_X, SEPAX_MOVE_Y, SEPAX_MOVE_Z};
  bus_block_results(true);
  start();
  uint64_t started = bus_responded();
  uint32_t first = value_of(SEPAX_CYCLES);
  uint64_t since = bus_cycles();
  for (uint64_t left = blocked; left > 0;) {
    uint64_t some = left < 5000 ? left : 5000;
    bus_idle(some);
    left -= some;
    uint64_t counted = value_of(SEPAX_CYCLES) - first;
    expect("CYCLES meanwhile", paced ? counted : 0, paced ? bus_cycles() - since : 0);
  }
  uint32_t busy = value_of(SEPAX_STATUS);
  expect("a run waits for its results to be taken", busy & SEPAX_STATUS_BUSY, SEPAX_STATUS_BUSY);
  expect("START while busy", bus_write(NULL, SEPAX_COMMAND, SEPAX_COMMAND_START), 0);
  expect("MODE while busy", bus_write(NULL, SEPAX_MODE, 1), 0);
  for (int i = 0; i < 3; i++) {
    expect("MOVE while busy", bus_write(NULL, move[i], 1), 0);
  }
  expect("STOP", bus_write(NULL, SEPAX_COMMAND, SEPAX_COMMAND_STOP), 1);
  bus_block_results(false);
  uint64_t result = 0;
  uint64_t results = 0;
  for (bool last = false; !last && bus_receive(NULL, &result, &last);) {
    results++;
  }
  expect("the end says that it was stopped", result >> 62, 3);
  expect("and how many came", (uint32_t)result, results - 1);
  expect("STATUS", value_of(SEPAX_STATUS) & (SEPAX_STATUS_BUSY | SEPAX_STATUS_STOPPED),
         SEPAX_STATUS_STOPPED);
  expect("CYCLES of a long run", paced ? value_of(SEPAX_CYCLES) : 0,
         paced ? bus_rose() - started - around : 0);
}

/* Interrupts, quiet runs, STOP, and results that nobody takes. */
void controls(sepax_tri *a, sepax_tri *b, uint64_t blocked, bool paced) {
  expect("PENDING clears", bus_write(NULL, SEPAX_PENDING, 7), 1);
  expect("no interrupt", bus_interrupt(), 0);
  expect("ENABLE", bus_write(NULL, SEPAX_ENABLE, SEPAX_ENABLE_DONE), 1);
  expect("MODE", bus_write(NULL, SEPAX_MODE, SEPAX_MODE_QUIET), 1);
  start();
  uint64_t started = bus_responded();
  wait_for_end();
  bus_idle(2);
  expect("an interrupt", bus_interrupt(), 1);
  expect("PENDING", value_of(SEPAX_PENDING), SEPAX_PENDING_DONE | SEPAX_PENDING_HIT);
  expect("all pairs collide", value_of(SEPAX_COLLISIONS), SEPAX_MEMORY_B);
  expect("STATUS says so", value_of(SEPAX_STATUS),
         SEPAX_STATUS_LOADED_A | SEPAX_STATUS_LOADED_B | SEPAX_STATUS_HIT);
  uint32_t cycles = value_of(SEPAX_CYCLES);
  uint64_t around = bus_rose() - started - cycles;
  bus_idle(100);
  expect("CYCLES stands after the run", value_of(SEPAX_CYCLES), cycles);
  expect("ENABLE", bus_write(NULL, SEPAX_ENABLE, SEPAX_ENABLE_HIT), 1);
  bus_idle(2);
  expect("an interrupt by the hit", bus_interrupt(), 1);
  expect("PENDING.HIT clears", bus_write(NULL, SEPAX_PENDING, SEPAX_PENDING_HIT), 1);
  bus_idle(2);
  expect("that interrupt is gone", bus_interrupt(), 0);
  expect("PENDING", value_of(SEPAX_PENDING), SEPAX_PENDING_DONE);
  expect("MODE", bus_write(NULL, SEPAX_MODE, SEPAX_MODE_QUIET | SEPAX_MODE_FIRST), 1);
  start();
  wait_for_end();
  expect("one collision", value_of(SEPAX_COLLISIONS), 1);
  /* Its way, that of what was taken until then, and a latency for the phases of several cores. */
  expect("the first ends the run soon",
         value_of(SEPAX_CYCLES) < 30u + 3u * SEPAX_LATENCY + 4u * SEPAX_II, 1);
  expect("MODE", bus_write(NULL, SEPAX_MODE, SEPAX_MODE_QUIET), 1);
  for (uint32_t k = 1; k < 32; k++) {
    uint32_t command = SEPAX_COMMAND_START | UINT32_C(1) << k;
    expect("START and another bit", bus_write(NULL, SEPAX_COMMAND, command), 0);
  }
  send_beats(3 * (size_t)SHORT, true);
  vertex_beside_start(paced);
  vertex_beside_write(paced);
  if (paced) {
    clear_beside(SEPAX_PENDING_DONE, false);
    clear_beside(SEPAX_PENDING_HIT, false);
    clear_beside(SEPAX_PENDING_LOADED, true);
  }
  expect("MODE", bus_write(NULL, SEPAX_MODE, 0), 1);
  stop_beside_end(paced);
  expect("ENABLE", bus_write(NULL, SEPAX_ENABLE, SEPAX_ENABLE_DONE), 1);
  expect("PENDING clears", bus_write(NULL, SEPAX_PENDING, 7), 1);
  bus_idle(2);
  expect("the interrupt is gone", bus_interrupt(), 0);
  expect("MODE", bus_write(NULL, SEPAX_MODE, 0), 1);
  nobody_takes(blocked, around, paced);
  bus_reset();
  overlap(a, b, 3, 5, false);
}
