// SPDX-License-Identifier: MIT
// traffic.cpp - sepax_tree_memory under random traffic, against the bytes of the memory: pairs of
// nodes and of leaves in order, each of their bytes and triangles, errors with the first pair that
// needs a block that came with one, runs that are dropped, resets; then its speed.
//
//     traffic ROUNDS SEED [+FAULT]
//
// W, NODE_SETS, LEAF_SETS, OPEN, maybe others are macros, the module's parameters.
#include "Vsepax_tree_memory.h"
#include "cosim/verilated_top.h"
#include "tree_engine/modules/ports.h"
#include "tree_engine/modules/world.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <functional>
#include <iostream>
#include <vector>

namespace {

class Traffic {
public:
  Traffic(uint64_t seed, int argc, char **argv) : top(nullptr, seed), world(seed) {
    top.arguments(argc, argv);
    top->start = top->cold = top->drop = 0;
    silence();
  }

  void run(unsigned rounds) {
    host_reads = true;
    for (unsigned n = 0; n < rounds && wrong < 20; n++) {
      new_world(n, false);
      reset();
      unsigned runs = 1 + draw(6);
      for (unsigned k = 0; k < runs; k++) {
        one_run(k == 0 || draw(3) == 0);
      }
      wrong += slave.counts.breaches;
      bursts += slave.counts.bursts;
      most = std::max(most, slave.counts.open_most);
      errors += slave.counts.errors;
    }
    host_reads = false;
  }

  void speed();
  void come_round();

  uint64_t host_bursts = 0;
  uint64_t node_pairs = 0, leaf_pairs = 0, reads = 0, bursts = 0, errors = 0, drops = 0, resets = 0,
           stops = 0, wrong = 0, cycles = 0;
  int most = 0; // bursts that were open

private:
  uint64_t draw(uint64_t below) { return world.draw(below); }
  bool now_and_then() { return !stress || draw(16) < rate; }

  void silence() {
    top->node_in_valid = top->leaf_in_valid = top->node_out_ready = top->leaf_out_ready = 0;
    top->node_release = top->leaf_release = top->node_read_a = top->node_read_b = 0;
    top->head_read_a = top->head_read_b = 0;
    top->triangle_read_a = top->triangle_read_b = top->corners_read_b = 0;
    top->host_valid = 0;
  }

  void fault(const char *what, uint64_t got, uint64_t wanted) {
    wrong++;
    std::cout << "traffic: cycle " << cycles << ": " << what << ": " << got << ", not " << wanted
              << "\n";
  }

  void new_world(unsigned round, bool in_order) {
    stress = round % 4 != 0;
    world.renew(round % 2 != 0, in_order);
    memory_options o = {};
    o.base = world.base;
    o.size = SIZE;
    o.repeated = true;
    o.bytes = world.bytes.data();
    o.latency = 1 + (int)draw(stress ? 60 : 10);
    o.stress = stress ? 1 + draw(~uint64_t(0)) : 0;
    o.open_max = 1 << OPEN;
    memory_open(&slave, &o);
    top->base_a = world.body[0].base / PAGE;
    top->base_b = world.body[1].base / PAGE;
  }

  void reset() {
    silence();
    top->rst = 1;
    tick();
    tick();
    memory_reset(&slave);
    hosts.clear();
    top->rst = 0;
    top.settle();
    if (top->arvalid) {
      fault("ARVALID after reset", 1, 0);
    }
    forget();
  }

  void forget() {
    for (Kind *k : {&nodes, &leaves}) {
      k->in.clear();
      k->out.clear();
      k->offered = false;
      k->left = 0;
      std::fill(k->stands, k->stands + 4, false);
    }
  }

  void one_run(bool cold) {
    if (cold) { // what the caches have must not be used
      world.change_nodes();
      world.draw_errors(slave.options, nodes, leaves);
    }
    rate = 1 + draw(16);
    top->start = 1;
    top->cold = cold;
    tick();
    top->start = top->cold = 0;
    for (Kind *k : {&nodes, &leaves}) {
      k->left = (unsigned)draw(300);
      k->hot = 1 + (unsigned)draw(k->of_leaves ? LEAVES : NODES);
      k->spread = (unsigned)draw(4);
    }
    uint64_t end = draw(8) == 0 ? draw(3000) : ~uint64_t(0);
    bool failed = false;
    waited = 0;
    for (uint64_t n = 0; n < end && !failed && !is_over() && wrong < 20; n++) {
      failed = step();
    }
    stops += failed;
    if (!failed && !is_over() && draw(2) == 0) {
      resets++;
      reset();
      return;
    }
    drops += !failed && !is_over();
    drop();
  }

  static bool is_over(const Kind &k) {
    return k.left == 0 && !k.offered && k.in.empty() && k.out.empty();
  }
  bool is_over() const { return is_over(nodes) && is_over(leaves); }

  // Drop what is on its way and wait until all bursts have come.
  void drop() {
    silence();
    top->drop = 1;
    tick();
    top->drop = 0;
    forget();
    for (unsigned n = 0; n < 5000 && !top->idle; n++) {
      tick();
      if (top->node_out_valid || top->leaf_out_valid) {
        fault("a pair after the drop", 1, 0);
      }
    }
    if (!top->idle || slave.counts.open > (int)hosts.size()) {
      fault("idle with open bursts", (uint64_t)slave.counts.open, 0);
    }
  }

  void offer(Kind &k) {
    if (k.offered || k.left == 0 || !now_and_then()) {
      return;
    }
    world.draw_next(k);
    k.offered = true;
    k.left--;
  }

  void choose_reads(Kind &k) {
    for (int i = 0; i < (k.of_leaves ? 2 : 4); i++) {
      k.read_of[i] = -1;
      if (!k.out.empty() && draw(3) != 0) {
        unsigned n = draw(2) == 0 ? 0 : (unsigned)draw(k.out.size());
        k.read_of[i] = (int)n;
        k.index[i % 2] = (unsigned)draw(16);
        k.out[n].was_read[i % 2] = true;
      }
    }
  }

  bool choose_release(Kind &k) {
    return !k.out.empty() && k.out[0].was_read[0] && k.out[0].was_read[1] &&
           std::find(k.read_of, k.read_of + 4, 0) == k.read_of + 4 && now_and_then();
  }

  // A burst of the host, anywhere in the memory; it does not cross 4 KB.
  void offer_host() {
    if (host_reads && top->host_valid == 0 && draw(16) == 0) {
      next_host.beats = 1 + (unsigned)draw(16);
      next_host.place = draw(SIZE / MEMORY_BEAT) / 256 * 256 + draw(257 - next_host.beats);
      next_host.beat = 0;
      top->host_valid = 1;
      top->host_address = world.base / MEMORY_BEAT + next_host.place;
      top->host_beats = (uint8_t)(next_host.beats - 1);
    }
  }

  // The beats of the host's bursts come in order, as they are.
  void check_host() {
    if (top->host_fill == 0) {
      return;
    }
    if (hosts.empty()) {
      fault("a beat for the host", 1, 0);
      return;
    }
    HostBurst &h = hosts.front();
    uint64_t address = world.base + MEMORY_BEAT * (h.place + h.beat);
    const uint8_t *from = world.bytes.data() + MEMORY_BEAT * (h.place + h.beat) % SIZE;
    bool bad = address >= slave.options.error_from && address < slave.options.error_to;
    for (unsigned n = 0; n < MEMORY_BEAT && !bad; n++) {
      if (bits_of(top->host_data, 8 * n, 8) != from[n]) {
        fault("a byte for the host", bits_of(top->host_data, 8 * n, 8), from[n]);
        break;
      }
    }
    if (top->host_beat != h.beat || (top->host_last != 0) != (h.beat + 1 == h.beats) ||
        (top->host_error != 0) != bad) {
      fault("number, last or error of the host's beat", top->host_beat, h.beat);
    }
    if (++h.beat == h.beats) {
      hosts.pop_front();
      host_bursts++;
    }
  }

  // The head of a node of body i, bytes 0 ... 31, or the others. Of the head only the bits that the
  // engine reads are kept: W of each coordinate, and not the CRC.
  void check_nodes(const Pair &p, int i, bool head) {
    const uint8_t *from = world.at(i, p.number[i] * (uint64_t)NODE_BYTES);
    for (unsigned n = head ? 0 : HEAD_BYTES; n < (head ? HEAD_BYTES : NODE_BYTES); n += 4) {
      uint64_t got = i == 0 ? bits_of(top->node_a, 8 * n, 32) : bits_of(top->node_b, 8 * n, 32);
      uint64_t wanted =
          from[n] | from[n + 1] << 8 | from[n + 2] << 16 | (uint64_t)from[n + 3] << 24;
      const uint64_t kept[] = {
          (1 << W) - 1, (1 << W) - 1, (1 << W) - 1, 0xffffff, 0xffffffff, 0xffffffff, 0, 0xffffff};
      wanted &= head ? kept[n / 4] : 0xffffffff;
      if (got != wanted) {
        fault("bytes of a node", got, wanted);
        return;
      }
    }
  }
  uint64_t triangle_bits(int i, unsigned from, unsigned count) {
    return i == 0 ? bits_of(top->triangle_a, from, count) : bits_of(top->triangle_b, from, count);
  }
  void check_triangle(const Pair &p, int i, unsigned index) {
    uint64_t wanted[9];
    bool damaged = !world.triangle(i, p, index, W, wanted);
    if (i == 1 && top->corners_b != world.corners(i, p, index)) {
      fault("corners", top->corners_b, world.corners(i, p, index));
    }
    if (triangle_bits(i, 9 * W, 1) != damaged) {
      fault("damaged", !damaged, damaged);
    }
    for (unsigned k = 0; k < 9 && !damaged; k++) {
      uint64_t got = triangle_bits(i, W * k, W);
      if (got != wanted[k]) {
        fault("coordinate", got, wanted[k]);
        return;
      }
    }
  }

  // What was read in the cycle before, or stands since an earlier one.
  void check_reads(Kind &k, const Pair *const read[4]) {
    for (int i = 0; i < 4; i++) {
      if (read[i] != nullptr) {
        reads++;
        k.stands[i] = true;
        k.stood[i] = *read[i];
        k.stood_index[i] = k.index[i % 2];
      }
      if (k.stands[i] && k.of_leaves) {
        check_triangle(k.stood[i], i, k.stood_index[i]);
      } else if (k.stands[i]) {
        check_nodes(k.stood[i], i % 2, i >= 2);
      }
    }
  }

  // A pair that is taken; true if it came with an error.
  template <class Port>
  bool take(Kind &k, const Port &info, unsigned bits, unsigned a, unsigned b, bool error) {
    if (k.in.empty()) {
      fault("a pair too many", 1, 0);
      return false;
    }
    Pair p = k.in.front();
    k.in.pop_front();
    if (!has_spread(p.info, bits, info)) {
      fault("info of a pair", bits_of(info, 0, 32), p.info & ~uint32_t(0));
    }
    bool bad = false;
    for (int i = 0; i < 2; i++) {
      bad |= world.is_bad(i, k.of_leaves, p, slave.options);
    }
    if (error != bad) {
      fault("error of a pair", error, bad);
    }
    if (error) {
      k.failed = true;
      std::copy(p.number, p.number + 2, k.number);
      std::copy(p.far, p.far + 2, k.far);
    }
    p.slot[0] = a;
    p.slot[1] = b;
    p.was_read[0] = p.was_read[1] = false;
    k.out.push_back(p);
    waited = 0;
    return error;
  }

  // One cycle of both kinds; true when a pair came with an error.
  bool step();
  void drive();
  void tick();
  uint64_t stream(bool of_leaves, unsigned count, const std::function<unsigned(unsigned, int)> &);

  struct HostBurst {
    uint64_t place; // in the memory, in beats
    unsigned beats, beat;
  };
  VerilatedTop<Vsepax_tree_memory> top;
  HostBurst next_host{};
  std::deque<HostBurst> hosts; // that were taken, oldest first
  bool host_taken = false;
  bool host_reads = false; // the host has bursts
  World world;
  memory slave;
  Kind nodes{false}, leaves{true};
  uint64_t rate = 16, waited = 0;
  bool stress = false;
};

void Traffic::drive() {
  offer_host();
  for (Kind *k : {&nodes, &leaves}) {
    offer(*k);
    choose_reads(*k);
  }
  top->node_in_valid = nodes.offered;
  top->node_in_a = nodes.next.number[0];
  top->node_in_b = nodes.next.number[1];
  spread(nodes.next.info, NODE_INFO, top->node_in_info);
  top->leaf_in_valid = leaves.offered;
  const Record a = world.record(leaves.next, 0), b = world.record(leaves.next, 1);
  top->leaf_in_a = a.place;
  top->leaf_in_b = b.place;
  top->leaf_in_beats_a = (uint8_t)(a.beats - 1);
  top->leaf_in_beats_b = (uint8_t)(b.beats - 1);
  spread(leaves.next.info, LEAF_INFO, top->leaf_in_info);
  top->node_out_ready = now_and_then();
  top->leaf_out_ready = now_and_then();
  top->node_release = choose_release(nodes);
  top->leaf_release = choose_release(leaves);
  const int *n = nodes.read_of, *l = leaves.read_of;
  top->node_read_a = n[0] >= 0;
  top->node_read_b = n[1] >= 0;
  top->head_read_a = n[2] >= 0;
  top->head_read_b = n[3] >= 0;
  auto node = [&](int i) { return (uint8_t)(n[i] >= 0 ? nodes.out[(size_t)n[i]].slot[i % 2] : 0); };
  top->node_slot_a = node(0);
  top->node_slot_b = node(1);
  top->head_slot_a = node(2);
  top->head_slot_b = node(3);
  top->triangle_read_a = l[0] >= 0;
  top->triangle_read_b = top->corners_read_b = l[1] >= 0;
  auto slot = [&](int i) {
    return (l[i] >= 0 ? leaves.out[(size_t)l[i]].slot[i] : 0) * 16 + leaves.index[i];
  };
  top->triangle_slot_a = slot(0);
  top->triangle_slot_b = top->corners_slot_b = slot(1);
}

// From the settled outputs over the edge of the clock.
void Traffic::tick() {
  const memory_slave *s = memory_drive(&slave);
  top->arready = s->arready;
  top->rvalid = s->rvalid;
  top->rlast = s->rlast;
  top->rresp = (uint8_t)s->rresp;
  for (int k = 0; k < 4; k++) {
    top->rdata[k] = s->rdata[k];
  }
  top.settle();
  if (top->host_valid && top->host_ready && !top->rst) {
    hosts.push_back(next_host);
    host_taken = true;
  }
  memory_master m = {top->arvalid != 0, top->rready != 0, top->araddr, top->arlen};
  if (!top->rst) {
    memory_clock(&slave, &m);
  }
  top.rise();
  if (host_taken) {
    top->host_valid = 0;
    host_taken = false;
  }
  top.settle();
  cycles++;
  if (!top->rst) {
    check_host();
  }
}

bool Traffic::step() {
  drive();
  top.settle();
  bool failed = false;
  Pair copy[2][4];
  const Pair *read[2][4] = {};
  Kind *kinds[2] = {&nodes, &leaves};
  for (int n = 0; n < 2; n++) {
    for (int i = 0; i < 4; i++) {
      if (kinds[n]->read_of[i] >= 0) {
        copy[n][i] = kinds[n]->out[(size_t)kinds[n]->read_of[i]];
        read[n][i] = &copy[n][i];
      }
    }
  }
  bool in[2] = {top->node_in_valid && top->node_in_ready, top->leaf_in_valid && top->leaf_in_ready};
  bool out[2] = {top->node_out_valid && top->node_out_ready,
                 top->leaf_out_valid && top->leaf_out_ready};
  bool release[2] = {top->node_release != 0, top->leaf_release != 0};
  if (out[0]) {
    failed |= take(nodes, top->node_out_info, NODE_INFO, top->node_out_a, top->node_out_b,
                   top->node_out_error);
    node_pairs++;
  }
  if (out[1]) {
    failed |= take(leaves, top->leaf_out_info, LEAF_INFO, top->leaf_out_a, top->leaf_out_b,
                   top->leaf_out_error);
    leaf_pairs++;
  }
  for (int n = 0; n < 2; n++) {
    if (in[n]) {
      kinds[n]->in.push_back(kinds[n]->next);
      kinds[n]->offered = false;
      waited = 0;
    }
    if (release[n]) {
      kinds[n]->out.pop_front();
      waited = 0;
    }
  }
  tick();
  check_reads(nodes, read[0]);
  check_reads(leaves, read[1]);
  if (++waited > 20000) {
    fault("nothing for 20000 cycles", 0, 1);
    std::exit(1);
  }
  return failed;
}

// Cycles of so many pairs of given numbers, taken and released as they come. Of leaves FAR and more
// are another page.
constexpr unsigned FAR = 1u << 23;
uint64_t Traffic::stream(bool of_leaves, unsigned count,
                         const std::function<unsigned(unsigned, int)> &number) {
  Kind &k = of_leaves ? leaves : nodes;
  uint64_t begin = cycles;
  unsigned in = 0, released = 0, outs = 0;
  while (released < count) {
    if (cycles - begin > 1000000) {
      fault("pairs of a stream", released, count);
      return 0;
    }
    silence();
    for (int i = 0; i < 2; i++) {
      k.next.number[i] = number(in, i) % FAR;
      k.next.far[i] = of_leaves ? number(in, i) / FAR * 256 : 0;
    }
    k.offered = in < count;
    k.left = 0;
    stress = false;
    nodes.out.clear();
    leaves.out.clear();
    drive();
    bool release = outs > released;
    (of_leaves ? top->leaf_release : top->node_release) = release;
    top.settle();
    bool taken = of_leaves ? top->leaf_in_valid && top->leaf_in_ready
                           : top->node_in_valid && top->node_in_ready;
    in += taken;
    outs += of_leaves ? top->leaf_out_valid != 0 : top->node_out_valid != 0;
    released += release;
    tick();
    k.offered = false;
  }
  return cycles - begin;
}

void Traffic::speed() {
  stress = false;
  for (int latency : {20, 100, 300}) {
    new_world(0, true);
    slave.options.latency = latency;
    slave.options.error_to = slave.options.error_from = 0;
    reset();
    stream(false, 1, [](unsigned, int) { return 0; });
    uint64_t first = stream(false, 1, [](unsigned, int) { return 1; });
    uint64_t hits = stream(false, 1000, [](unsigned n, int i) { return i ? 0 : n % 32; });
    uint64_t b = stream(false, 500, [](unsigned n, int i) { return i ? n + 40 : 0; });
    uint64_t both = stream(false, 400, [](unsigned n, int) { return n + 100; });
    uint64_t leaf = stream(true, 1, [](unsigned, int) { return 1; });
    uint64_t leaf_hits = stream(true, 1000, [](unsigned n, int i) { return i ? 1 : n % 2; });
    uint64_t beats = slave.counts.beats;
    uint64_t leaf_both = stream(true, LEAVES, [](unsigned n, int) { return n; });
    std::cout << "latency " << latency << ": a pair of nodes " << first << " cycles, hits "
              << hits / 1000. << " a pair, one misses " << b / 500. << ", both " << both / 400.
              << "; a pair of leaves " << leaf << ", hits " << leaf_hits / 1000. << ", both miss "
              << leaf_both / double(LEAVES) << " of " << double(slave.counts.beats - beats) / LEAVES
              << " beats\n";
  }
}

// Blocks of one set, each asked for when the numbers of pairs have come round since the one before:
// none is pinned.
void Traffic::come_round() {
  new_world(0, true);
  slave.options.error_to = slave.options.error_from = 0;
  reset();
  auto set = [&](unsigned n) {
    uint64_t place = world.body[1].base / MEMORY_BEAT + world.body[1].records[n].place;
    return (place ^ place >> LEAF_SETS) % (1 << LEAF_SETS);
  };
  unsigned other = 1;
  for (; set(other) == set(0); other++) {}
  for (bool of_leaves : {false, true}) {
    unsigned all = 8u << (of_leaves ? LEAF_WINDOW : NODE_WINDOW);
    unsigned step = of_leaves ? FAR : 1u << 2 * NODE_SETS;
    uint64_t before = slave.counts.bursts;
    stream(of_leaves, 8 * all, [&](unsigned n, int i) {
      return i == 0 || n % all > 0 ? (of_leaves ? other : 1) : n / all % 5 * step;
    });
    std::cout << slave.counts.bursts - before << " bursts of blocks of a set\n";
  }
}

} // namespace

int main(int argc, char **argv) {
  if (argc < 3) {
    std::fprintf(stderr, "traffic: give rounds and a seed\n");
    return 2;
  }
  Traffic t(std::strtoull(argv[2], nullptr, 10), argc, argv);
  t.run((unsigned)std::strtoul(argv[1], nullptr, 10));
  std::cout << t.node_pairs << " pairs of nodes, " << t.leaf_pairs << " of leaves, " << t.reads
            << " reads, " << t.bursts << " bursts, " << t.host_bursts << " of the host, up to "
            << t.most << " open, " << t.errors << " bad beats, " << t.stops
            << " runs ended by an error, " << t.drops << " dropped, " << t.resets << " resets, "
            << t.cycles << " cycles, " << t.wrong << " wrong\n";
  if (t.wrong == 0) {
    t.come_round();
    t.speed();
  }
  return t.wrong != 0 || t.reads == 0;
}
