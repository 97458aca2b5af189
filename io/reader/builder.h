/* SPDX-License-Identifier: MIT */
/* builder.h - collects the triangles that the readers of all formats make (private). */
#ifndef SEPAX_BUILDER_H
#define SEPAX_BUILDER_H

#include "sepax_io.h"
#include "sides.h"
#include "util/error.h"

/* The bytes of a file, followed by a '\0', and what was made from them. */
typedef struct {
  const char *path;
  const char *bytes;
  size_t size;
  sepax_mesh_reading how;
  sepax_mesh_account account;
  sepax_soup soup;
  size_t capacity, normal_capacity; /* facets and normals that the soup has space for */
  double (*corner)[3];              /* scratch space for `corners` corners of a polygon */
  size_t (*triangle)[3];            /* and for its triangles */
  size_t corners;
  polygon_sides sides; /* the polygons of the file */
  sepax_error *error;
} mesh_builder;

/* "PATH: ..." with code FORMAT; false. The last words are the cure. */
bool sepax__builder_fail(const mesh_builder *b, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
/* "PATH:LINE: ..."; lines count from 1. */
bool sepax__builder_fail_line(const mesh_builder *b, size_t line, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
bool sepax__builder_fail_memory(const mesh_builder *b);

/* Make space for `corners` corners in b->corner. Its content stays. */
bool sepax__builder_corners(mesh_builder *b, size_t corners);

/* Add a triangle. Fails on a coordinate that is not finite or beyond 2^1000, and above the limit of
 * triangles. */
bool sepax__builder_triangle(mesh_builder *b, const double v[3][3]);

/* Check a triangle that a reader put into the soup itself, as sepax__builder_triangle does. */
bool sepax__builder_within(const mesh_builder *b);

/* Add a polygon with the first `count` (3 or more) corners of b->corner, divided by polygon.h in
 * the order of sides.h, and count it in account.divided and account.bent. Fails if it cannot be
 * divided. Messages call it "face 17" by `what` and number; with line 0 they name no line. */
bool sepax__builder_polygon(mesh_builder *b, size_t count, size_t line, const char *what,
                            size_t number);

/* Count `count` more elements of a kind without a surface. */
bool sepax__builder_other(mesh_builder *b, const char *what, size_t count);

/* Remark on one more object of the file, whose name is printed by `format`. `what` is one of at
 * most SEPAX_MESH_REMARKS_MOST texts. */
void sepax__builder_remark(mesh_builder *b, const char *what, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
