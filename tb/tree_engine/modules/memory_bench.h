// SPDX-License-Identifier: MIT
// memory_bench.h - drives sepax_tree_memory cycle by cycle and checks it against the bytes of the
// memory: pairs of nodes and of leaves in order, each of their bytes and triangles, errors with the
// first pair that needs a block that came with one, and the host's bursts.
#ifndef SEPAX_MEMORY_BENCH_H
#define SEPAX_MEMORY_BENCH_H

#include "Vsepax_tree_memory.h"
#include "cosim/verilated_top.h"
#include "tree_engine/modules/ports.h"
#include "tree_engine/modules/world.h"

#include <algorithm>
#include <cstdlib>
#include <deque>
#include <iostream>

class MemoryBench {
public:
  MemoryBench(uint64_t seed, int argc, char **argv) : top(nullptr, seed), world(seed) {
    top.arguments(argc, argv);
    top->start = top->cold = top->drop = 0;
    silence();
  }

  uint64_t host_bursts = 0;
  uint64_t node_pairs = 0, leaf_pairs = 0, reads = 0, wrong = 0, cycles = 0;

protected:
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

  void drive() {
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
    auto node = [&](int i) {
      return (uint8_t)(n[i] >= 0 ? nodes.out[(size_t)n[i]].slot[i % 2] : 0);
    };
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
  void tick() {
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

  // One cycle of both kinds; true when a pair came with an error.
  bool step() {
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
    bool in[2] = {top->node_in_valid && top->node_in_ready,
                  top->leaf_in_valid && top->leaf_in_ready};
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

  VerilatedTop<Vsepax_tree_memory> top;
  World world;
  memory slave;
  Kind nodes{false}, leaves{true};
  uint64_t rate = 16, waited = 0;
  bool stress = false;
  bool host_reads = false; // the host has bursts

private:
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

  struct HostBurst {
    uint64_t place; // in the memory, in beats
    unsigned beats, beat;
  };
  HostBurst next_host{};
  bool host_taken = false;

protected:
  std::deque<HostBurst> hosts; // that were taken, oldest first
};

#endif
