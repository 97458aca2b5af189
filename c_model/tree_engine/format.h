/* SPDX-License-Identifier: MIT */
/* format.h - the bytes of nodes and of records of leaves (private). docs/reference/tree-engine.md,
 * Memory, is normative. */
#ifndef SEPAX_TREE_FORMAT_H
#define SEPAX_TREE_FORMAT_H

#include "sepax_grid.h"
#include "util/bytes.h"

enum {
  TREE_FAN_OUT = 16,  /* children of a node, triangles of a leaf */
  TREE_VERTICES = 28, /* most vertices of a leaf's record */
  TREE_NODE_BYTES = 128,
  TREE_RECORD_BYTES = 256, /* most bytes of a record */
  TREE_BEAT = 16,          /* bytes of a beat, the unit of records */
  TREE_PAGE = 4096,
  TREE_EXPONENT_MAX = 15,
  TREE_LEVEL_MAX = 15
};
#define TREE_NODES_MAX (UINT32_C(1) << 23)

/* A node, unpacked. */
typedef struct {
  int32_t origin[3];
  int exponent[3]; /* 0 ... 15 */
  int children;    /* 1 ... 16 */
  int level;       /* 0: a leaf */
  int beats;       /* leaf: beats of its record, 1 ... 16 */
  int8_t own[3];   /* own box h: all that is below is in the cells -1 - h ... h */
  uint32_t first;  /* number of the first child; leaf: number of the first triangle */
  uint32_t record; /* leaf: place of its record in the image, in beats */
  int8_t low[TREE_FAN_OUT][3], high[TREE_FAN_OUT][3]; /* boxes of the children, in cells */
} tree_node;

/* A tree as the engine sees it: an image and the sizes in its body record. */
typedef struct {
  const uint8_t *image;
  uint32_t nodes, triangles;
  uint32_t beats; /* of the image */
} tree_image;

/* Continue a CRC-32 (IEEE 802.3) over `count` bytes. The first `crc` is 0. */
uint32_t sepax__tree_crc(uint32_t crc, const uint8_t *bytes, size_t count);

/* The right value of bytes 24 ... 27 of a node. `record` is read only if the node is a leaf. */
uint32_t sepax__tree_node_crc(const uint8_t bytes[TREE_NODE_BYTES], const uint8_t *record);

/* Unpack a node from any 128 bytes. Of each coordinate, `word` bits are read. */
tree_node sepax__tree_unpack(const uint8_t bytes[TREE_NODE_BYTES], int word);

/* Pack a node, with its CRC. `record` is read only if the node is a leaf. */
void sepax__tree_pack(uint8_t bytes[TREE_NODE_BYTES], const tree_node *node, const uint8_t *record);

/* False if the engine calls node `number` damaged (docs/reference/tree-engine.md, Checks). */
bool sepax__tree_node_sound(const tree_image *tree, const tree_node *node, uint32_t number);

/* Write the vertices of triangle `number`, 0 ... 15, of a leaf's record of `beats` beats. False if
 * the engine calls the triangle damaged. */
bool sepax__tree_triangle(int32_t v[3][3], const uint8_t *record, int beats, int number, int word);

#endif
