/* SPDX-License-Identifier: MIT */
/* ply.h - the head of a PLY file (private). */
#ifndef SEPAX_PLY_H
#define SEPAX_PLY_H

#include "text/words.h"

typedef enum {
  PLY_NONE,
  PLY_INT8,
  PLY_UINT8,
  PLY_INT16,
  PLY_UINT16,
  PLY_INT32,
  PLY_UINT32,
  PLY_FLOAT,
  PLY_DOUBLE
} ply_type;

typedef struct {
  char name[40];
  ply_type type;
  ply_type count; /* for a list: the type of its length; otherwise PLY_NONE */
} ply_property;

/* The role of a kind of elements. */
typedef enum { PLY_OTHER, PLY_VERTEX, PLY_FACE, PLY_STRIP } ply_role;

typedef struct {
  char name[40];
  ply_role role;
  uint64_t rows;
  ply_property *property;
  size_t properties, capacity;
  size_t use[3]; /* for vertices: the properties x, y, z; for faces and strips use[0]: the list of
                    indices */
  size_t bytes;  /* bytes of a row in a binary file; 0 if a row has lists */
} ply_element;

typedef enum { PLY_TEXT, PLY_LITTLE, PLY_BIG } ply_order;

typedef struct {
  ply_order order;
  ply_element *element;
  size_t elements, capacity;
  size_t vertex;    /* the element of vertices */
  words behind;     /* where the first row begins */
  bool faces_first; /* faces come before the vertices */
} ply_head;

extern const size_t sepax__ply_bytes[PLY_DOUBLE + 1]; /* bytes of a number of each type */

/* Read the head and give each element its role. Free it with sepax__ply_head_free in any case. */
bool sepax__ply_head_read(ply_head *head, mesh_builder *b);
void sepax__ply_head_free(ply_head *head);

#endif
