// SPDX-License-Identifier: MIT
// compare.cpp - sepax_tree_compare and its blocks against the golden model: random nodes, poses and
// entries, and what lies at the ends of their ranges; gaps at all ports, drops in between.
//
//     compare ENTRIES SEED [+FAULT] [TRACE]
//
// TRACE gets all inputs and outputs of each cycle, for compare_tb.v.
//
// W is a macro, the module's parameter.
#include "Vcompare_top.h"
#include "cosim/verilated_top.h"
#include "tree_engine/modules/entries.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <vector>

namespace {

template <typename Port> int64_t field(const Port &port, int at, int bits) {
  uint64_t value = 0;
  for (int k = 0; k < bits; k++) {
    value |= (uint64_t)(port[(at + k) / 32] >> (at + k) % 32 & 1) << k;
  }
  return (int64_t)(value << (64 - bits)) >> (64 - bits);
}

template <typename Port> void put(Port &port, int at, int bits, int64_t value) {
  for (int k = 0; k < bits; k++) {
    uint32_t one = (uint32_t)1 << (at + k) % 32;
    port[(at + k) / 32] = (port[(at + k) / 32] & ~one) | ((value >> k & 1) != 0 ? one : 0);
  }
}

struct Item {
  bool last, side, columns, leaves;
  int index, mask, a, b;
  bool operator==(const Item &o) const {
    return last == o.last && side == o.side && columns == o.columns && leaves == o.leaves &&
           index == o.index && mask == o.mask && a == o.a && b == o.b;
  }
};

class Checker : private Entries {
public:
  Checker(uint64_t seed, int argc, char **argv) : Entries(seed), top(nullptr, seed) {
    top.arguments(argc, argv);
  }

  void run(uint64_t entries) {
    reset();
    while (counts.entries < entries && counts.wrong < 20) {
      new_world();
      one_run(1 + draw(120));
    }
  }

  struct {
    uint64_t entries, boxes, items, hits, columns, vertices, settings, cells, drops, cycles, wrong;
    uint64_t quick_cycles, quick_steps; // where nothing is in the way
  } counts = {};

  FILE *trace = nullptr;

private:
  void wrong(const char *what, int64_t got, int64_t wanted) {
    counts.wrong++;
    printf("compare: cycle %llu: %s: %lld, not %lld\n", (unsigned long long)counts.cycles, what,
           (long long)got, (long long)wanted);
  }
  void same(const char *what, int64_t got, int64_t wanted) {
    if (got != wanted) {
      wrong(what, got, wanted);
    }
  }

  void new_world() {
    renew();
    for (int side = 0; side < 2; side++) {
      for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
          put(top->matrix, 22 * (9 * side + 3 * i + k), 22, pose.side[side].matrix[i][k]);
        }
        put(top->shift, 44 * (3 * side + i), 44, pose.side[side].shift[i]);
        put(top->sigma, 24 * (3 * side + i), 24, pose.side[side].sigma[i]);
      }
    }
    rate_in = draw(3) == 0 ? 16 : 1 + (unsigned)draw(15);
    rate_out = draw(3) == 0 ? 16 : 1 + (unsigned)draw(15);
    rate_other = draw(3) == 0 ? 0 : (unsigned)draw(15);
    one_side = draw(4) == 0;
    small = draw(3) == 0;
  }

  // ------------------------------------------------------------------ what is expected

  void expect(bool side, int mask, int a, int b) {
    const tree_node *s = side ? &node[0][a] : &node[1][b];
    const tree_node *t = side ? &node[1][b] : &node[0][a];
    tree_setting setting = sepax__tree_set_up(&pose.side[side], s, t);
    settings.push_back(setting);
    for (int i = 0; i < 3; i++) {
      shifts.push_back(10 - setting.shift[i]);
    }
    int hit[16] = {0};
    int column[16] = {0};
    int8_t own_low[3];
    for (int i = 0; i < 3; i++) {
      own_low[i] = (int8_t)(-1 - s->own[i]);
    }
    bool own = mask == 0;
    for (int i = 0; i < 16; i++) {
      if (own ? i == 0 : (mask >> i & 1) != 0) {
        tree_cells box = own ? sepax__tree_turn_box(&setting, own_low, s->own)
                             : sepax__tree_turn_box(&setting, s->low[i], s->high[i]);
        boxes.push_back(box);
        hit[i] = sepax__tree_hits(&box, t);
        counts.boxes++;
      }
      for (int j = 0; j < 16; j++) {
        column[j] |= (hit[i] >> j & 1) << i;
      }
    }
    bool leaves = s->level == 0 && t->level == 0 && !own;
    bool columns = !own && s->level == 0 && (t->level > 0 || side);
    const int *masks = columns ? column : hit;
    int last = own ? 0 : columns ? 15 : 31 - __builtin_clz((unsigned)mask);
    while (columns && last > 0 && masks[last] == 0) {
      last--;
    }
    for (int k = 0; k <= last; k++) {
      counts.hits += masks[k] != 0;
      if (masks[k] != 0 || k == last) {
        Item item = {k == last, side, columns, leaves, k, masks[k], a, b};
        item.index = masks[k] == 0 && columns ? 0 : k;
        items.push_back(item);
      }
    }
    counts.columns += columns;
    counts.entries++;
  }

  // ------------------------------------------------------------------ cycles

  template <typename Port> void write(const Port &port) {
    for (int k = (int)(sizeof port / 4) - 1; k >= 0; k--) {
      fprintf(trace, "%08x", port[k]);
    }
    fputc(' ', trace);
  }

  void record() {
    if (trace == nullptr) {
      return;
    }
    fprintf(trace, "%x %x %x %x %x %x %x %x %x ", top->rst, top->drop, top->in_valid, top->in_side,
            top->in_mask, top->in_a, top->in_b, top->out_ready, top->other);
    fprintf(trace, "%llx ", (unsigned long long)point[0]);
    write(top->matrix);
    write(top->shift);
    write(top->sigma);
    write(top->head_a);
    write(top->head_b);
    write(top->boxes_a);
    write(top->boxes_b);
    fprintf(trace, "%x %x %x %x %x %x ", top->in_ready, top->boxes_read_a, top->boxes_slot_a,
            top->boxes_read_b, top->boxes_slot_b, top->out_valid);
    fprintf(trace, "%x %x %x %x %x %x %x %x\n", top->out_last, top->out_side, top->out_columns,
            top->out_leaves, top->out_index, top->out_mask, top->out_a, top->out_b);
  }

  void tick() {
    top.settle();
    record();
    top.rise();
    counts.cycles++;
  }

  void reset() {
    top->in_valid = top->out_ready = top->drop = top->other = 0;
    top->rst = 1;
    tick();
    tick();
    top->rst = 0;
    settings.clear();
    shifts.clear();
    boxes.clear();
    items.clear();
    others.clear();
  }

  template <typename Port> void garbage(Port &port) {
    for (unsigned k = 0; k < sizeof port / 4; k++) {
      port[k] = (uint32_t)sepax_random_next(&random);
    }
  }

  template <typename Port> void show(Port &port, const uint8_t *from) {
    memcpy(&port[0], from, sizeof port);
  }

  void check_blocks() {
    if (top->setting_valid) {
      const tree_setting s = settings.front();
      settings.pop_front();
      for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
          same("N", field(top->n, 12 * (3 * i + k), 12), s.n[i][k]);
        }
        uint32_t low[2] = {(uint32_t)top->low, (uint32_t)(top->low >> 32)};
        uint32_t high[2] = {(uint32_t)top->high, (uint32_t)(top->high >> 32)};
        same("low", field(low, 21 * i, 21), s.low[i]);
        same("high", field(high, 21 * i, 21), s.high[i]);
        same("shift", top->cell_shift >> 4 * i & 15, shifts.front());
        shifts.pop_front();
      }
      counts.settings++;
    }
    if (top->cells_valid) {
      check_end(false);
      check_end(true);
    }
  }

  // Beyond the 8 bits of cells: 128 lower, -129 upper; -129 lower is -128, 128 upper is 127.
  void check_end(bool upper) {
    const tree_cells &box = boxes.front();
    uint64_t all = top->cells;
    bool beyond = false;
    for (int i = 0; i < 3; i++) {
      int wanted = upper ? -1 - box.high[i] : box.low[i];
      int got = (int8_t)(all >> (24 * upper + 8 * i));
      beyond = beyond || wanted > 127;
      if (wanted <= 127) {
        same(upper ? "high cell" : "low cell", got, wanted < -128 ? -128 : wanted);
      }
    }
    same("beyond", top->beyond >> upper & 1, beyond);
    counts.cells++;
    if (upper) {
      boxes.pop_front();
    }
  }

  void check_vertex() {
    if (top->other_valid) {
      int32_t v[3];
      const int32_t *p = others.front().p;
      const sepax_tree_side &side = pose.side[others.front().side];
      sepax__tree_turn_vertex(v, &side, p);
      for (int i = 0; i < 3; i++) { // and what is below the point, of which set-up reads some
        const int32_t *m = side.matrix[i];
        int64_t sum = (int64_t)m[0] * p[0] + (int64_t)m[1] * p[1] + (int64_t)m[2] * p[2];
        sum += side.shift[i];
        same("vertex", field(top->sum, 45 * i + 20, 25), v[i]);
        same("its fraction", field(top->sum, 45 * i, 20) & 0xfffff, sum & 0xfffff);
      }
      others.pop_front();
      counts.vertices++;
    }
  }

  void check_item() {
    if (items.empty()) {
      wrong("an item that is not expected, index", top->out_index, -1);
      return;
    }
    Item got = {(bool)top->out_last,   (bool)top->out_side, (bool)top->out_columns,
                (bool)top->out_leaves, (int)top->out_index, (int)top->out_mask,
                (int)top->out_a,       (int)top->out_b};
    if (!(got == items.front())) {
      wrong("index of an item", got.index, items.front().index);
      wrong("its mask", got.mask, items.front().mask);
      wrong("its last, side, columns, leaves",
            got.last * 8 + got.side * 4 + got.columns * 2 + got.leaves,
            items.front().last * 8 + items.front().side * 4 + items.front().columns * 2 +
                items.front().leaves);
    }
    items.pop_front();
    counts.items++;
  }

  struct Vertex {
    bool side;
    int32_t p[3];
  };

  void offer_other(uint64_t left) {
    top->other = (left > 0 || !items.empty()) && draw(16) < rate_other;
    if (top->other) {
      Vertex v;
      v.side = draw(2) != 0;
      top->other |= v.side << 1;
      uint64_t packed[2] = {0, 0};
      for (int i = 0; i < 3; i++) {
        v.p[i] = (int32_t)bits(draw(4) == 0 ? 1 : W);
        for (int k = 0; k < W; k++) {
          packed[(W * i + k) / 64] |= (uint64_t)(v.p[i] >> k & 1) << (W * i + k) % 64;
        }
      }
      set_point(top->other_point, packed);
      point[0] = packed[0];
      others.push_back(v);
    }
  }
  static void set_point(SData &port, const uint64_t *p) { port = (SData)p[0]; }
  static void set_point(IData &port, const uint64_t *p) { port = (IData)p[0]; }
  static void set_point(QData &port, const uint64_t *p) { port = p[0]; }
  template <typename Port> static void set_point(Port &port, const uint64_t *p) {
    port[0] = (uint32_t)p[0];
    port[1] = (uint32_t)(p[0] >> 32);
  }

  void drop() {
    top->drop = 1;
    tick_and_check();
    top->drop = 0;
    settings.clear();
    shifts.clear();
    boxes.clear();
    items.clear();
    counts.drops++;
  }

  void tick_and_check() {
    top.settle();
    record();
    bool read_a = top->boxes_read_a, read_b = top->boxes_read_b;
    int slot_a = top->boxes_slot_a, slot_b = top->boxes_slot_b;
    top.rise();
    counts.cycles++;
    if (read_a) {
      show(top->boxes_a, bytes[0][slot_a] + 32);
    }
    if (read_b) {
      show(top->boxes_b, bytes[1][slot_b] + 32);
    }
    garbage(top->head_a);
    garbage(top->head_b);
  }

  void one_run(uint64_t entries) {
    uint64_t left = entries;
    uint64_t drop_at = draw(6) == 0 ? 1 + draw(300) : 0;
    unsigned idle = 0;
    bool quick = rate_in == 16 && rate_out == 16 && rate_other == 0 && drop_at == 0;
    uint64_t begun = counts.cycles;
    uint64_t boxes_before = counts.boxes;
    top->in_valid = 0;
    while (left > 0 || !items.empty() || !others.empty()) {
      if (!top->in_valid && left > 0 && draw(16) < rate_in) {
        offer();
      }
      top->out_ready = draw(16) < rate_out;
      offer_other(left);
      top.settle();
      bool in = top->in_valid && top->in_ready;
      int a = top->in_a, b = top->in_b;
      if (in) {
        expect(top->in_side, top->in_mask, a, b);
      }
      check_blocks();
      check_vertex();
      if (top->out_valid && top->out_ready) {
        check_item();
        idle = 0;
      }
      tick_and_check();
      if (in) {
        show(top->head_a, bytes[0][a]);
        show(top->head_b, bytes[1][b]);
        top->in_valid = 0;
        left--;
      }
      if (drop_at > 0 && --drop_at == 0) {
        top->in_valid = 0;
        top->other = 0;
        top->out_ready = 0;
        check_later();
        drop();
        left = 0;
      }
      if (++idle > 2000) {
        wrong("cycles without an item", idle, 0);
        reset();
        return;
      }
    }
    if (quick) {
      counts.quick_cycles += counts.cycles - begun;
      counts.quick_steps += counts.boxes - boxes_before;
    }
  }

  // What comes out in the cycle of a drop is checked as well.
  void check_later() {
    top.settle();
    check_blocks();
    check_vertex();
  }

  void offer() {
    int a = (int)draw(SLOTS);
    top->in_valid = 1;
    top->in_side = draw(4) == 0 ? draw(2) : near_side[a];
    if (one_side) {
      top->in_side = 0;
    }
    top->in_a = (uint8_t)a;
    top->in_b = (uint8_t)(draw(4) == 0 ? draw(SLOTS) : (uint64_t)a);
    uint64_t mask = sepax_random_next(&random);
    top->in_mask = (uint16_t)(small ? mask & mask >> 16 & mask >> 32 : mask);
    if (draw(8) == 0) {
      top->in_mask = draw(2) == 0 ? 0 : 0xffff;
    }
  }

  VerilatedTop<Vcompare_top> top;
  uint64_t point[1] = {0};
  unsigned rate_in = 16, rate_out = 16, rate_other = 0;
  bool one_side = false, small = false;
  std::deque<tree_setting> settings;
  std::deque<int> shifts;
  std::deque<tree_cells> boxes;
  std::deque<Item> items;
  std::deque<Vertex> others;
};

} // namespace

int main(int argc, char **argv) {
  uint64_t entries = argc > 1 ? strtoull(argv[1], nullptr, 10) : 100000;
  uint64_t seed = argc > 2 ? strtoull(argv[2], nullptr, 10) : 1;
  static Checker checker(seed, argc, argv);
  if (argc > 3 && argv[3][0] != '+') {
    checker.trace = fopen(argv[3], "w");
  }
  checker.run(entries);
  if (checker.trace != nullptr && fclose(checker.trace) != 0) {
    return 2;
  }
  const auto &c = checker.counts;
  printf("compare W=%d: %llu entries (%llu columns), %llu boxes, %llu items (%llu with hits), "
         "%llu vertices, %llu drops, %llu cycles; %llu wrong\n",
         W, (unsigned long long)c.entries, (unsigned long long)c.columns,
         (unsigned long long)c.boxes, (unsigned long long)c.items, (unsigned long long)c.hits,
         (unsigned long long)c.vertices, (unsigned long long)c.drops, (unsigned long long)c.cycles,
         (unsigned long long)c.wrong);
  printf("without gaps %.2f cycles a box\n", (double)c.quick_cycles / (double)c.quick_steps);
  return c.wrong > 0 || c.items == 0 || c.hits == 0 || c.vertices == 0 || c.drops == 0 ? 1 : 0;
}
