/* SPDX-License-Identifier: MIT */
// walk_bench.h - the verilated tree engine with its cores on a memory.
#ifndef SEPAX_WALK_BENCH_H
#define SEPAX_WALK_BENCH_H

#include "Vsepax_tree_bench.h"
#include "cosim/verilated_top.h"
#include "tree_engine/modules/memory.h"
#include "tree_engine/modules/ports.h"

#include "sepax_params.h"
#include "sepax_tree.h"

#include <vector>

const uint64_t BASE = 0x8912345000; // of the memory

// What a run is asked to do, besides pose and bodies.
struct Ask {
  bool first = false, quiet = false, cold = true, row = false, probe = true;
  uint32_t budget = UINT32_MAX;
  uint64_t stop = UINT64_MAX;
  sepax_tree_pair pair{};
};

struct Result {
  uint32_t a, b;
  bool coplanar, outside, warning;
  bool operator==(const Result &o) const {
    return a == o.a && b == o.b && coplanar == o.coplanar && outside == o.outside &&
           warning == o.warning;
  }
};

inline uint32_t get32(const uint8_t *from) {
  return (uint32_t)from[0] | (uint32_t)from[1] << 8 | (uint32_t)from[2] << 16 |
         (uint32_t)from[3] << 24;
}

// Two bodies in one memory.
struct Scene {
  sepax_tree *tree[2] = {nullptr, nullptr};
  std::vector<uint8_t> bytes; // of the memory: both images
  size_t at[2];
  uint8_t record[2][SEPAX_TREE_BODY_BYTES];

  ~Scene() {
    sepax_tree_free(tree[0]);
    sepax_tree_free(tree[1]);
  }
  uint32_t nodes(int body) const { return get32(record[body] + 8); }
  void place() {
    bytes.clear();
    for (int i = 0; i < 2; i++) {
      size_t size;
      const uint8_t *from = sepax_tree_image(tree[i], &size);
      at[i] = bytes.size();
      sepax_tree_body(tree[i], BASE + at[i], record[i]);
      bytes.insert(bytes.end(), from, from + size);
      bytes.resize((bytes.size() + 4095) / 4096 * 4096);
    }
  }
};

class Engine {
public:
  Engine(const char *wave, uint64_t seed, uint64_t seed_of_stress, int cycles, uint64_t error_odds)
      : top(wave, seed), stress(seed_of_stress), latency(cycles), errors(error_odds) {
    top->start = top->stop = top->rvalid = 0;
    reset();
  }

  void reset() {
    memory_options o = {};
    o.latency = latency;
    o.stress = stress;
    o.error_odds = errors;
    memory_open(&ram, &o);
    top->rst = 1;
    top->rvalid = 0;
    for (int k = 0; k < 3; k++) {
      top.settle();
      top.rise();
    }
    top->rst = 0;
  }

  void begin(const Scene &scene, const sepax_tree_pose &pose, const Ask &ask) {
    give(scene, pose, ask);
    ram.options.base = BASE;
    ram.options.bytes = scene.bytes.data();
    ram.options.size = scene.bytes.size();
    ram.counts.errors = 0;
    results.clear();
    thick = 0;
    stopped_at = 0;
    top->start = 1;
  }

  // False if it hangs. stop: the cycle in which it is stopped.
  bool run(const Scene &scene, const sepax_tree_pose &pose, const Ask &ask) {
    begin(scene, pose, ask);
    for (uint64_t cycle = 0; cycle < 2000000; cycle++) {
      cycles++;
      top->stop = cycle == ask.stop;
      top->result_ready = stress == 0 || memory_draw(&stress) % 4 != 0;
      if (tick()) {
        return true;
      }
    }
    return false;
  }

  // One clock cycle; true if the run ended in it.
  bool tick() {
    const memory_slave *slave = memory_drive(&ram);
    top->arready = slave->arready;
    top->rvalid = slave->rvalid;
    top->rlast = slave->rlast;
    top->rresp = (uint8_t)slave->rresp;
    for (int k = 0; k < 4; k++) {
      top->rdata[k] = slave->rdata[k];
    }
    top.settle();
    const memory_master master = {top->arvalid != 0, top->rready != 0, top->araddr, top->arlen};
    memory_clock(&ram, &master);
    if (top->result_valid && top->result_ready) {
      results.push_back({top->result_a, top->result_b, top->result_coplanar != 0,
                         top->result_outside != 0, top->result_warning != 0});
    }
    thick += top->pair_valid && top->pair_ready && !top->pair_outside && !is_thin();
    bool ended = top->done;
    idle_at_end = ended && top->memory_idle;
    if (!top->start && top->stopped && stopped_at == 0) {
      stopped_at = top->cycles;
    }
    top.rise();
    top->start = 0;
    return ended;
  }

  VerilatedTop<Vsepax_tree_bench> top;
  std::vector<Result> results;
  memory ram;
  uint64_t thick;      // pairs that are not thinnest along z
  bool idle_at_end;    // no burst, no record is under way when the run has ended
  uint64_t cycles = 0; // of all runs
  uint64_t stopped_at; // cycles when it was first seen to be stopped; 0: it was not

private:
  uint64_t stress; // a seed, or 0: none
  int latency;
  uint64_t errors; // one beat in so many

  template <typename Words> static void put(Words &words, int at, uint64_t value, int bits) {
    for (int k = 0; k < bits; k++, at++) {
      uint32_t bit = UINT32_C(1) << (at % 32);
      words[at / 32] = (value >> k & 1) != 0 ? words[at / 32] | bit : words[at / 32] & ~bit;
    }
  }

  template <typename Words> static int64_t get(const Words &words, int at, int bits) {
    uint64_t value = bits_of(words, (unsigned)at, (unsigned)bits);
    return (int64_t)(value << (64 - bits)) >> (64 - bits);
  }

  // Of the pair that goes to the cores.
  bool is_thin() {
    int64_t side[3];
    for (int i = 0; i < 3; i++) {
      int64_t low = INT64_MAX, high = INT64_MIN;
      for (int k = 0; k < 6; k++) {
        int at = SEPAX_WORD * (3 * (k % 3) + i);
        int64_t x = k < 3 ? get(top->pair_a, at, SEPAX_WORD) : get(top->pair_b, at, SEPAX_WORD);
        low = x < low ? x : low;
        high = x > high ? x : high;
      }
      side[i] = high - low;
    }
    return side[2] <= side[0] && side[2] <= side[1];
  }

  void give(const Scene &scene, const sepax_tree_pose &pose, const Ask &ask) {
    top->base_a = (uint32_t)((BASE + scene.at[0]) / 4096);
    top->base_b = (uint32_t)((BASE + scene.at[1]) / 4096);
    top->nodes_a = get32(scene.record[0] + 8);
    top->nodes_b = get32(scene.record[1] + 8);
    top->triangles_a = get32(scene.record[0] + 12);
    top->triangles_b = get32(scene.record[1] + 12);
    top->beats_a = get32(scene.record[0] + 16);
    top->beats_b = get32(scene.record[1] + 16);
    for (int k = 0; k < 9; k++) {
      put(top->matrix_m, 22 * k, (uint64_t)(int64_t)pose.side[0].matrix[k / 3][k % 3], 22);
      put(top->matrix_k, 22 * k, (uint64_t)(int64_t)pose.side[1].matrix[k / 3][k % 3], 22);
    }
    for (int k = 0; k < 3; k++) {
      put(top->shift_t, 44 * k, (uint64_t)pose.side[0].shift[k], 44);
      put(top->shift_u, 44 * k, (uint64_t)pose.side[1].shift[k], 44);
      put(top->sigma_a, 24 * k, pose.side[0].sigma[k], 24);
      put(top->sigma_b, 24 * k, pose.side[1].sigma[k], 24);
    }
    top->first = ask.first;
    top->quiet = ask.quiet;
    top->cold = ask.cold;
    top->probe = ask.cold || ask.probe;
    top->budget = ask.budget;
    top->row = ask.row;
    top->row_leaf_a = ask.pair.leaf[0];
    top->row_leaf_b = ask.pair.leaf[1];
    top->row_a = (uint32_t)ask.pair.child[0];
    top->row_b = (uint32_t)ask.pair.child[1];
  }
};

// ---------------------------------------------------------------------- damage

// Bytes of trees that are damaged; poses and first rows that are anything.
class Damage {
public:
  explicit Damage(uint64_t *state) : seed(state) {}

  uint64_t draw() { return memory_draw(seed); }
  int below(int count) { return (int)(draw() % (uint64_t)count); }
  int64_t bits(int count) { return (int64_t)(draw() << (64 - count)) >> (64 - count); }

  // Any bytes, bytes that say where things are, and the beats of records; or where `high`, bits
  // alone that are too high in what says where things are.
  void harm(Scene &scene, bool high) {
    if (high) {
      int body = below(2);
      size_t node = scene.at[body] + SEPAX_TREE_NODE_BYTES * (draw() % scene.nodes(body));
      scene.bytes[node + 17 + 4 * (size_t)below(2) + (size_t)below(3)] ^= (uint8_t)(1 << below(8));
      return;
    }
    for (int count = 1 + below(1 + below(8)); count > 0; count--) {
      int body = below(2);
      size_t node = scene.at[body] + SEPAX_TREE_NODE_BYTES * (draw() % scene.nodes(body));
      switch (below(4)) {
      case 0:
        scene.bytes[draw() % scene.bytes.size()] = (uint8_t)draw();
        break;
      case 1:
        scene.bytes[node + 12 + (size_t)below(12)] = (uint8_t)draw();
        break;
      case 2:
        scene.bytes[node + (size_t)below(SEPAX_TREE_NODE_BYTES)] ^= (uint8_t)(1 << below(8));
        break;
      default:
        scene.bytes[node + 14] = (uint8_t)((scene.bytes[node + 14] & 15) | below(4) << 4);
      }
    }
  }

  // A pair of any two leaves, or where `all`, of any nodes or numbers.
  sepax_tree_pair any_row(const Scene &scene, bool all) {
    sepax_tree_pair pair = {};
    for (int body = 0; body < 2; body++) {
      const uint8_t *head;
      int tries = all && below(4) == 0 ? 1000 : 0; // with a node that is no leaf
      do {
        pair.leaf[body] = (uint32_t)(draw() % scene.nodes(body));
        head = &scene.bytes[scene.at[body] + SEPAX_TREE_NODE_BYTES * pair.leaf[body]];
      } while ((head[14] & 15) != 0 && ++tries < 1000);
      pair.child[body] = below(1 + (head[13] >> 4));
      if (all && below(4) == 0) {
        pair.leaf[body] = (uint32_t)(draw() >> (41 + below(20)));
        pair.child[body] = below(16);
      }
    }
    return pair;
  }

  // Numbers of a pose that are in their ranges, which is all that they have to do with each other.
  sepax_tree_pose any_pose() {
    sepax_tree_pose pose;
    bool far = below(4) == 0; // vertices as far as can be, on both sides
    int small = far ? 25 + below(4) : below(2) == 0 ? 44 : 20 + below(24);
    for (sepax_tree_side &side : pose.side) {
      for (int k = 0; k < 9; k++) {
        int64_t one = 1 << 20;
        int64_t any = (int64_t)(draw() % (uint64_t)(2 * one + 1)) - one;
        side.matrix[k / 3][k % 3] = (int32_t)(far             ? one * (2 * below(2) - 1)
                                              : below(8) == 0 ? one * (below(3) - 1)
                                                              : any);
      }
      for (int k = 0; k < 3; k++) {
        side.shift[k] = bits(small);
        side.sigma[k] = (uint32_t)(draw() >> (40 + below(24)));
      }
    }
    return pose;
  }

private:
  uint64_t *seed;
};

#endif
