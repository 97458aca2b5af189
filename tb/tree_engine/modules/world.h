/* SPDX-License-Identifier: MIT */
// world.h - two bodies in one memory, with anything in their nodes and records, and what
// sepax_tree_memory should say of them.
#ifndef SEPAX_TREE_TB_WORLD_H
#define SEPAX_TREE_TB_WORLD_H

#include "tree_engine/modules/memory.h"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <vector>

#ifndef NODE_INFO // bits that go with a pair
#define NODE_INFO 32
#define LEAF_INFO 64
#endif
#ifndef NODE_WINDOW // log2 of the pairs that are in
#define NODE_WINDOW 5
#define LEAF_WINDOW 3
#endif

constexpr unsigned NODES = 600, LEAVES = 120, NODE_BYTES = 128, HEAD_BYTES = 32, PAGE = 4096;
constexpr unsigned SIZE = 1 << 19; // of the memory

struct Record {
  uint32_t place; // in the image, in beats
  unsigned beats;
};

struct Body {
  uint64_t base; // of its image in memory
  std::vector<Record> records;
};

// A pair of nodes or of leaves on its way.
struct Pair {
  unsigned number[2]; // of the node, or of the record
  unsigned far[2];    // of a record: these bits of its place are others; what is there is read
  uint64_t info;
  unsigned slot[2];
  bool was_read[2];
};

// One kind of pairs: nodes or leaves, and what is on its way.
struct Kind {
  bool of_leaves;
  std::deque<Pair> in, out; // not taken, taken
  Pair next;                // offered
  bool offered = false;
  bool failed = false; // the pair of that number came with an error: it comes again
  unsigned number[2] = {0, 0}, far[2] = {0, 0};
  unsigned left = 0; // pairs that are still to go in
  unsigned hot = 1, spread = 1;
  // What is read in this cycle, index in `out`: of A and B, and heads of nodes.
  int read_of[4] = {-1, -1, -1, -1};
  unsigned index[2] = {0, 0};
  // What was read last, as long as the bytes in memory are the same.
  bool stands[4] = {};
  Pair stood[4];
  unsigned stood_index[4];
};

class World {
public:
  explicit World(uint64_t seed) : state(seed) {}

  uint64_t draw(uint64_t below) { return memory_draw(&state) % below; }

  // New bodies; at addresses far up if `far`. In order: vertices have the order of the triangles.
  void renew(bool far, bool in_order) {
    base = PAGE * (1 + draw(uint64_t(1) << (far ? 27 : 10)));
    uint64_t at = base;
    for (Body &b : body) {
      b.base = at;
      at += make_body(b) + PAGE * draw(3);
    }
    bytes.resize(SIZE);
    for (uint8_t &byte : bytes) {
      byte = (uint8_t)draw(256);
    }
    for (const Body &b : body) {
      number_vertices(b, in_order);
    }
  }

  // Other nodes: what the caches have is wrong.
  void change_nodes() {
    for (const Body &b : body) {
      for (unsigned k = 0; k < NODES * NODE_BYTES; k += 1 + (unsigned)draw(9)) {
        bytes[b.base - base + k] ^= (uint8_t)(1 + draw(255));
      }
    }
  }

  // Errors in a stretch of memory; in any beat of a node; in the last one of a record, mostly a
  // long one; or none. That node or record is asked for soon.
  void draw_errors(memory_options &o, Kind &nodes, Kind &leaves) {
    uint64_t kind = draw(4);
    int i = (int)draw(2);
    Kind &k = kind == 1 ? leaves : nodes;
    unsigned &n = k.number[i] = (unsigned)draw(NODES);
    for (int tries = 0; kind == 1 && (tries == 0 || (tries < 8 && body[i].records[n].beats < 14));
         tries++) {
      n = (unsigned)draw(LEAVES);
    }
    k.number[1 - i] = (unsigned)draw(LEAVES);
    k.far[0] = k.far[1] = 0;
    k.failed = kind == 1 || kind == 2;
    uint64_t beat =
        kind == 1 ? body[i].records[n].place + body[i].records[n].beats - 1 : 8 * n + draw(8);
    o.error_from = base + (kind == 0 ? draw(SIZE / 2) : body[i].base - base + MEMORY_BEAT * beat);
    o.error_to = o.error_from + (kind == 0 ? 300 : k.failed ? MEMORY_BEAT : 0);
  }

  // The next pair that is asked for.
  void draw_next(Kind &k) {
    unsigned all = k.of_leaves ? LEAVES : NODES;
    bool again = k.failed && draw(4) == 0; // not at once: others wait in front of it
    unsigned mask = (1u << 2 * (k.of_leaves ? LEAF_SETS : NODE_SETS)) - 1;
    for (int i = 0; i < 2; i++) {
      unsigned n = (unsigned)draw(k.hot);
      if (k.spread == 0 && draw(2) == 0) {
        n = k.next.number[i]; // again
      } else if (k.spread == 1) {
        n = (k.next.number[i] + (i == 0)) % all; // side by side
      } else if (k.spread == 2) {
        n = (n & ~mask) % all; // in few sets
      }
      unsigned bit = !again && draw(8) == 0 ? 1u << draw(k.of_leaves ? 24 : 23) : 0;
      k.next.number[i] = again ? k.number[i] : k.of_leaves ? n : n ^ bit;
      k.next.far[i] = again ? k.far[i] : k.of_leaves ? bit << 8 : 0; // as far in its 4 KB
    }
    k.next.info = draw(~uint64_t(0));
    k.failed = k.failed && !again;
  }

  // A byte of body i's image, which the memory repeats.
  const uint8_t *at(int i, uint64_t offset) const {
    return bytes.data() + (body[i].base - base + offset) % SIZE;
  }

  Record record(const Pair &p, int i) const {
    const Record &r = body[i].records[p.number[i]];
    return {r.place ^ p.far[i], r.beats};
  }

  // Is a beat of the node or record of body i in the memory's range of errors?
  bool is_bad(int i, bool of_leaves, const Pair &p, const memory_options &o) const {
    const Record r = of_leaves ? record(p, i) : Record{p.number[i] * 8, 8};
    for (unsigned k = 0; k < r.beats; k++) {
      uint64_t address = body[i].base + MEMORY_BEAT * (uint64_t)(r.place + k);
      if (address >= o.error_from && address < o.error_to) {
        return true;
      }
    }
    return false;
  }

  // Numbers of the vertices of triangle `index` of a record.
  unsigned corners(int i, const Pair &p, unsigned index) const {
    const uint8_t *from = at(i, MEMORY_BEAT * (uint64_t)record(p, i).place);
    return (from[2 * index] | (unsigned)from[2 * index + 1] << 8) & 0x7fff;
  }

  // Coordinates of triangle `index` of a record, W bits each; false if it is damaged.
  bool triangle(int i, const Pair &p, unsigned index, unsigned word, uint64_t coordinate[9]) const {
    const Record r = record(p, i);
    const uint8_t *from = at(i, MEMORY_BEAT * (uint64_t)r.place);
    unsigned numbers = corners(i, p, index);
    for (unsigned k = 0; k < 9; k++) {
      unsigned number = numbers >> 5 * (k / 3) & 31;
      if (number >= 2 * r.beats - 4) {
        return false;
      }
      uint64_t whole = 0;
      for (unsigned n = 0; n < 8; n++) {
        whole |= (uint64_t)from[32 + 8 * number + n] << (8 * n);
      }
      coordinate[k] = whole >> (21 * (k % 3)) & ((1u << word) - 1);
    }
    return true;
  }

  uint64_t base = 0; // of all
  std::vector<uint8_t> bytes;
  Body body[2];

private:
  uint64_t make_body(Body &b) {
    uint32_t place = (NODES * NODE_BYTES + PAGE - 1) / PAGE * PAGE / MEMORY_BEAT;
    b.records.clear();
    for (unsigned n = 0; n < LEAVES; n++) {
      unsigned beats = 3 + (unsigned)draw(14);
      if (place % (PAGE / MEMORY_BEAT) + beats > PAGE / MEMORY_BEAT) {
        place = (place / (PAGE / MEMORY_BEAT) + 1) * (PAGE / MEMORY_BEAT);
      }
      b.records.push_back({place, beats});
      place += beats;
    }
    return (place + PAGE / MEMORY_BEAT) / (PAGE / MEMORY_BEAT) * PAGE;
  }

  // Numbers of vertices: in the order of their first use, any that are there, or any at all.
  void number_vertices(const Body &b, bool in_order) {
    for (const Record &r : b.records) {
      uint8_t *to = bytes.data() + (b.base - base) + MEMORY_BEAT * r.place;
      unsigned most = 2 * r.beats - 4, style = in_order ? 0 : (unsigned)draw(3);
      for (unsigned t = 0; t < 16; t++) {
        unsigned word = (unsigned)draw(2) << 15;
        for (unsigned k = 0; k < 3; k++) {
          unsigned number = style == 0   ? std::min(t + k, most - 1)
                            : style == 1 ? (unsigned)draw(most)
                                         : (unsigned)draw(32);
          word |= number << (5 * k);
        }
        to[2 * t] = (uint8_t)word;
        to[2 * t + 1] = (uint8_t)(word >> 8);
      }
    }
  }

  uint64_t state;
};

#endif
