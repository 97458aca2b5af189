// SPDX-License-Identifier: MIT
// traffic.cpp - sepax_tree_memory under random traffic (memory_bench.h checks it), with runs that
// are dropped and resets; then its speed.
//
//     traffic ROUNDS SEED [+FAULT]
//
// W, NODE_SETS, LEAF_SETS, OPEN, maybe others are macros, the module's parameters.
#include "tree_engine/modules/memory_bench.h"

#include <cstdio>
#include <functional>
#include <vector>

namespace {

class Traffic : public MemoryBench {
public:
  using MemoryBench::MemoryBench;

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

  uint64_t bursts = 0, errors = 0, drops = 0, resets = 0, stops = 0;
  int most = 0; // bursts that were open

private:
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

  uint64_t stream(bool of_leaves, unsigned count, const std::function<unsigned(unsigned, int)> &);
};

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
