/* format.h - nodes, records of leaves and poses as they are in memory, to the byte (private).
 * docs/reference/tree-engine.md is normative. */
#ifndef SEPAX_TREE_FORMAT_H
#define SEPAX_TREE_FORMAT_H

#include "sepax_grid.h"
#include "util/bytes.h"

enum {
  TREE_FAN_OUT = 16,     /* children of a node, triangles of a leaf */
  TREE_VERTICES = 28,    /* of a leaf's record */
  TREE_NODE_BYTES = 128, /* of a node */
  TREE_RECORD_BYTES = 256,
  TREE_BEAT = 16, /* bytes; the unit of records */
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
  int beats;       /* of a leaf's record, 1 ... 16 */
  int8_t own[3];   /* h: all below is in cells -1 - h ... h */
  uint32_t first;  /* child; of a leaf triangle */
  uint32_t record; /* where a leaf's record begins in the image, in beats */
  int8_t low[TREE_FAN_OUT][3], high[TREE_FAN_OUT][3]; /* cells of the children */
} tree_node;

/* What a tree is to a reader: an image and what its body record says of it. */
typedef struct {
  const uint8_t *image;
  uint32_t nodes, triangles;
  uint32_t beats; /* of the image */
} tree_image;

/* Go on with a CRC-32 (IEEE 802.3); begin with 0. */
uint32_t sepax__tree_crc(uint32_t crc, const uint8_t *bytes, size_t count);

/* What bytes 24 ... 27 of a node should be; `record` is a leaf's, else not read. */
uint32_t sepax__tree_node_crc(const uint8_t bytes[TREE_NODE_BYTES], const uint8_t *record);

/* The node in 128 bytes, any bytes; coordinates of W bits. */
tree_node sepax__tree_unpack(const uint8_t bytes[TREE_NODE_BYTES], int word);

/* Its bytes, with its CRC. */
void sepax__tree_pack(uint8_t bytes[TREE_NODE_BYTES], const tree_node *node, const uint8_t *record);

/* False if the engine calls node `number` damaged: docs/reference/tree-engine.md, Checks. */
bool sepax__tree_node_sound(const tree_image *tree, const tree_node *node, uint32_t number);

/* The vertices of triangle `number` of a leaf's record of so many beats; false if the engine calls
 * it damaged. */
bool sepax__tree_triangle(int32_t v[3][3], const uint8_t *record, int beats, int number, int word);

#endif
