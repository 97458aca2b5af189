/* SPDX-License-Identifier: MIT */
/* format.c - packs and unpacks nodes and records of leaves (docs/reference/tree-engine.md, Memory).
 */
#include "tree_engine/format.h"

uint32_t sepax__tree_crc(uint32_t crc, const uint8_t *bytes, size_t count) {
  static const uint32_t of_four_bits[16] = {0x00000000, 0x1db71064, 0x3b6e20c8, 0x26d930ac,
                                            0x76dc4190, 0x6b6b51f4, 0x4db26158, 0x5005713c,
                                            0xedb88320, 0xf00f9344, 0xd6d6a3e8, 0xcb61b38c,
                                            0x9b64c2b0, 0x86d3d2d4, 0xa00ae278, 0xbdbdf21c};
  crc = ~crc;
  for (size_t n = 0; n < count; n++) {
    crc ^= bytes[n];
    crc = crc >> 4 ^ of_four_bits[crc & 15];
    crc = crc >> 4 ^ of_four_bits[crc & 15];
  }
  return ~crc;
}

/* The lowest `bits` bits of x as a two's complement number. */
static int32_t from_bits(uint64_t x, int bits) {
  uint64_t sign = UINT64_C(1) << (bits - 1);
  return (int32_t)((int64_t)((x & (2 * sign - 1)) ^ sign) - (int64_t)sign);
}

tree_node sepax__tree_unpack(const uint8_t bytes[TREE_NODE_BYTES], int word) {
  tree_node n;
  uint32_t packed = bytes_get32(bytes + 12);
  for (int i = 0; i < 3; i++) {
    n.origin[i] = from_bits(bytes_get32(bytes + 4 * i), word);
    n.own[i] = (int8_t)bytes[28 + i];
    n.exponent[i] = (int)(packed >> (4 * i) & 15);
  }
  n.children = 1 + (int)(packed >> 12 & 15);
  n.level = (int)(packed >> 16 & 15);
  n.beats = 1 + (int)(packed >> 20 & 15);
  n.first = bytes_get32(bytes + 16);
  n.record = bytes_get32(bytes + 20);
  for (int j = 0; j < TREE_FAN_OUT; j++) {
    const uint8_t *child = bytes + 32 + 6 * j;
    for (int i = 0; i < 3; i++) {
      n.low[j][i] = (int8_t)child[i];
      n.high[j][i] = (int8_t)child[3 + i];
    }
  }
  return n;
}

void sepax__tree_pack(uint8_t bytes[TREE_NODE_BYTES], const tree_node *n, const uint8_t *record) {
  bool leaf = n->level == 0;
  uint32_t packed = (uint32_t)(n->children - 1) << 12 | (uint32_t)n->level << 16 |
                    (leaf ? (uint32_t)(n->beats - 1) << 20 : 0);
  for (int i = 0; i < 3; i++) {
    packed |= (uint32_t)n->exponent[i] << (4 * i);
    bytes_put32(bytes + 4 * i, (uint32_t)n->origin[i]);
  }
  bytes_put32(bytes + 12, packed);
  bytes_put32(bytes + 16, n->first);
  bytes_put32(bytes + 20, leaf ? n->record : 0);
  bytes_put32(bytes + 24, 0);
  for (int i = 0; i < 3; i++) {
    bytes[28 + i] = (uint8_t)n->own[i];
  }
  bytes[31] = 0;
  for (int j = 0; j < TREE_FAN_OUT; j++) {
    uint8_t *child = bytes + 32 + 6 * j;
    for (int i = 0; i < 3; i++) {
      child[i] = j < n->children ? (uint8_t)n->low[j][i] : 0;
      child[3 + i] = j < n->children ? (uint8_t)n->high[j][i] : 0;
    }
  }
  bytes_put32(bytes + 24, sepax__tree_node_crc(bytes, record));
}

uint32_t sepax__tree_node_crc(const uint8_t bytes[TREE_NODE_BYTES], const uint8_t *record) {
  uint32_t packed = bytes_get32(bytes + 12);
  uint32_t crc = sepax__tree_crc(0, bytes, 24);
  crc = sepax__tree_crc(crc, bytes + 28, TREE_NODE_BYTES - 28);
  bool leaf = (packed >> 16 & 15) == 0;
  return leaf ? sepax__tree_crc(crc, record, TREE_BEAT * (1 + (packed >> 20 & 15))) : crc;
}

bool sepax__tree_node_sound(const tree_image *tree, const tree_node *n, uint32_t number) {
  if (n->level > 0) {
    return n->first > number && (uint64_t)n->first + (uint64_t)n->children <= tree->nodes;
  }
  enum { BEATS = TREE_PAGE / TREE_BEAT };
  return (uint64_t)n->first + (uint64_t)n->children <= tree->triangles && n->beats >= 3 &&
         n->record % BEATS + (uint32_t)n->beats <= BEATS &&
         (uint64_t)n->record + (uint64_t)n->beats <= tree->beats;
}

bool sepax__tree_triangle(int32_t v[3][3], const uint8_t *record, int beats, int number, int word) {
  unsigned packed = record[2 * number] | (unsigned)record[2 * number + 1] << 8;
  for (int k = 0; k < 3; k++) {
    int vertex = (int)(packed >> (5 * k) & 31);
    if (vertex >= 2 * beats - 4) {
      return false;
    }
    uint64_t p = bytes_get64(record + 32 + 8 * vertex);
    for (int i = 0; i < 3; i++) {
      v[k][i] = from_bits(p >> (21 * i), word);
    }
  }
  return true;
}
