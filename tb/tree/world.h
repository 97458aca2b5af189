// world.h - two bodies in one memory, with anything in their nodes and records, and what
// sepax_tree_memory should say of them.
#ifndef SEPAX_TREE_TB_WORLD_H
#define SEPAX_TREE_TB_WORLD_H

#include "tree/memory.h"

#include <algorithm>
#include <cstdint>
#include <vector>

constexpr unsigned NODES = 600, LEAVES = 120, NODE_BYTES = 128, HEAD_BYTES = 32, PAGE = 4096;

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
  uint64_t info;
  unsigned slot[2];
  bool was_read[2];
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
    bytes.resize(at - base);
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

  // Errors in a stretch of memory; or in the last beat of record n of body i, which is returned,
  // mostly a long one; or none.
  bool draw_errors(memory_options *o, int *i, unsigned *n) {
    uint64_t kind = draw(4);
    *i = (int)draw(2);
    for (int k = 0; k == 0 || (k < 8 && body[*i].records[*n].beats < 14); k++) {
      *n = (unsigned)draw(LEAVES);
    }
    const Record &r = body[*i].records[*n];
    o->error_from = kind == 0 ? base + draw(bytes.size())
                              : body[*i].base + MEMORY_BEAT * uint64_t(r.place + r.beats - 1);
    o->error_to = o->error_from + (kind == 0 ? 300 : kind == 1 ? MEMORY_BEAT : 0);
    return kind == 1;
  }

  // A byte of body i's image.
  const uint8_t *at(int i, uint64_t offset) const {
    return bytes.data() + (body[i].base - base) + offset;
  }

  // Is a beat of node or record n of body i in the memory's range of errors?
  bool is_bad(int i, bool of_leaves, unsigned n, const memory_options &o) const {
    const Record r = of_leaves ? body[i].records[n] : Record{n * 8, 8};
    for (unsigned k = 0; k < r.beats; k++) {
      uint64_t address = body[i].base + MEMORY_BEAT * (uint64_t)(r.place + k);
      if (address >= o.error_from && address < o.error_to) {
        return true;
      }
    }
    return false;
  }

  // Numbers of the vertices of triangle `index` of a record.
  unsigned corners(int i, unsigned record, unsigned index) const {
    const uint8_t *from = at(i, MEMORY_BEAT * (uint64_t)body[i].records[record].place);
    return (from[2 * index] | (unsigned)from[2 * index + 1] << 8) & 0x7fff;
  }

  // Coordinates of triangle `index` of a record, W bits each; false if it is damaged.
  bool triangle(int i, unsigned record, unsigned index, unsigned word,
                uint64_t coordinate[9]) const {
    const Record &r = body[i].records[record];
    const uint8_t *from = at(i, MEMORY_BEAT * (uint64_t)r.place);
    unsigned numbers = corners(i, record, index);
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
