/* SPDX-License-Identifier: MIT */
// entries.h - random poses and nodes for test benches of the compare path, and what lies at the
// ends of their ranges. W is a macro.
#ifndef SEPAX_TB_TREE_ENTRIES_H
#define SEPAX_TB_TREE_ENTRIES_H

#include "sepax_vectors.h"
extern "C" {
#include "tree_engine/walk.h"
}

const int SLOTS = 64;

// A pose and the nodes of both bodies.
class Entries {
public:
  explicit Entries(uint64_t seed) : random{seed} {}

  uint64_t draw(uint64_t below) { return sepax_random_next(&random) % below; }
  int64_t bits(int n) { return (int64_t)(sepax_random_next(&random) << (64 - n)) >> (64 - n); }

  int32_t entry_of(int how) {
    const int32_t one = 1 << 20;
    switch (how) {
    case 0:
      return (int32_t)(draw(2 * one + 1)) - one;
    case 1: // quarter turns, mirrors, what is no rotation
      return (int32_t)(draw(3) - 1) * one;
    case 2:
      return (int32_t)bits(1 + (int)draw(20));
    default: // near what N is rounded at
      return (int32_t)((bits(12) << draw(10)) + bits(2)) % (one + 1);
    }
  }

  // A rotation that is none: one row after the other from small turns of the axes.
  void rotate(sepax_tree_side side[2]) {
    double m[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int turn = 0; turn < 3; turn++) {
      static const double pairs[][2] = {{0.6, 0.8}, {0, 1}, {1, 0}, {0.28, 0.96}, {0.7071, 0.7071}};
      const double *cs = pairs[draw(5)];
      int a = (int)draw(3);
      int b = (a + 1) % 3;
      for (auto &row : m) {
        double x = cs[0] * row[a] - cs[1] * row[b];
        row[b] = cs[1] * row[a] + cs[0] * row[b];
        row[a] = x;
      }
    }
    for (int i = 0; i < 3; i++) {
      for (int k = 0; k < 3; k++) {
        side[0].matrix[i][k] = (int32_t)(m[i][k] * (1 << 20));
        side[1].matrix[i][k] = (int32_t)(m[k][i] * (1 << 20));
      }
    }
  }

  static int64_t product(const sepax_tree_side *s, const int32_t p[3], int i) {
    int64_t sum = 0;
    for (int k = 0; k < 3; k++) {
      sum += (int64_t)s->matrix[i][k] * p[k];
    }
    return sum;
  }

  static int64_t in_range(int64_t t) {
    const int64_t most = ((int64_t)1 << 43) - 1;
    return t > most ? most : t < -most - 1 ? -most - 1 : t;
  }

  void new_pose() {
    int how = (int)draw(6);
    for (auto &side : pose.side) {
      for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
          side.matrix[i][k] = entry_of(how < 4 ? how : 0);
        }
        side.shift[i] = draw(24) == 0 ? bits(44) : bits(18 + W);
        if (draw(8) == 0) { // a single bit, and what is right below it
          side.shift[i] = ((int64_t)1 << draw(43)) - (int64_t)draw(2);
        }
        side.sigma[i] = (uint32_t)(draw(4) == 0 ? (uint64_t)bits(24) & 0xffffff : draw(4096));
        if (draw(16) == 0) {
          side.sigma[i] = draw(2) == 0 ? 0 : 0xffffff;
        }
        if (draw(8) == 0) { // a single bit, which a shift may leave of it
          side.sigma[i] = (uint32_t)1 << draw(24);
        }
      }
    }
    if (how >= 4) {
      rotate(pose.side);
      const sepax_tree_side *s = pose.side;
      for (int i = 0; i < 3; i++) {
        int64_t u = 0;
        for (int k = 0; k < 3; k++) {
          u -= (s[1].matrix[i][k] * (__int128)s[0].shift[k]) >> 20;
        }
        pose.side[1].shift[i] = in_range(u);
      }
    }
  }

  tree_node new_node() {
    tree_node n = {};
    int spread = (int)draw(3) == 0 ? 16 : 1 + (int)draw(4);
    int least = (int)draw(16);
    bool extremes = draw(8) == 0;
    n.children = 1 + (int)draw(16);
    n.level = draw(2) == 0 ? 0 : 1 + (int)draw(15);
    for (int i = 0; i < 3; i++) {
      n.origin[i] = (int32_t)bits(draw(4) == 0 ? W : W - 2);
      int e = least + (int)draw((uint64_t)spread);
      n.exponent[i] = e > 15 ? 15 : e;
      n.own[i] = (int8_t)(draw(64) == 0 ? bits(8) : (int64_t)draw(128));
      for (int j = 0; j < 16; j++) {
        int64_t a = extremes ? (draw(2) == 0 ? -128 : 127) : bits(8);
        int64_t b = extremes ? (draw(2) == 0 ? -128 : 127) : a + (int64_t)draw(30);
        n.low[j][i] = (int8_t)a;
        n.high[j][i] = (int8_t)(b > 127 ? 127 : b);
      }
    }
    return n;
  }

  // So that what is turned meets: the origin of t is where that of s comes to, or near it.
  void bring_near(tree_node *t, const tree_node *s, const sepax_tree_side *side) {
    for (int i = 0; i < 3; i++) {
      int64_t v = (product(side, s->origin, i) + side->shift[i]) >> 20;
      v += bits(1 + (int)draw(7)) * ((int64_t)1 << t->exponent[i]);
      const int64_t most = (1 << (W - 1)) - 1;
      t->origin[i] = (int32_t)(v > most ? most : v < -most - 1 ? -most - 1 : v);
    }
  }

  void renew() {
    new_pose();
    for (int k = 0; k < SLOTS; k++) {
      node[0][k] = new_node();
      node[1][k] = new_node();
      near_side[k] = draw(2) != 0;
      near_side[k] ? bring_near(&node[1][k], &node[0][k], &pose.side[1])
                   : bring_near(&node[0][k], &node[1][k], &pose.side[0]);
      for (int body = 0; body < 2; body++) {
        sepax__tree_pack(bytes[body][k], &node[body][k], bytes[body][k]);
        for (int i = 0; i < 3; i++) { // the bits above W do not count
          bytes[body][k][4 * i + 3] ^= (uint8_t)draw(256);
        }
        node[body][k] = sepax__tree_unpack(bytes[body][k], W);
      }
    }
  }

  sepax_random random;
  sepax_tree_pose pose;
  tree_node node[2][SLOTS];
  uint8_t bytes[2][SLOTS][TREE_NODE_BYTES] = {};
  bool near_side[SLOTS]; // in which the origin of T is where that of S comes to
};

#endif
