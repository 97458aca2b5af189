/* builder.h - what the readers of the formats make of a file (private). */
#ifndef SEPAX_BUILDER_H
#define SEPAX_BUILDER_H

#include "sepax_io.h"
#include "util/error.h"

/* The bytes of a file, a '\0' behind them, and what has been made of them. */
typedef struct {
  const char *path;
  const char *bytes;
  size_t size;
  sepax_mesh_reading how;
  sepax_mesh_account account;
  sepax_soup soup;
  size_t capacity, normal_capacity; /* facets of the soup */
  double (*corner)[3];              /* space of the reader for `corners` corners of a polygon, */
  size_t (*triangle)[3];            /* and for its triangles */
  size_t corners;
  sepax_error *error;
} mesh_builder;

/* "PATH: ..." with code FORMAT; false. The last words are the cure. */
bool sepax__builder_fail(const mesh_builder *b, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
/* "PATH:LINE: ..."; lines count from 1. */
bool sepax__builder_fail_line(const mesh_builder *b, size_t line, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
bool sepax__builder_fail_memory(const mesh_builder *b);

/* Space for `corners` corners in b->corner; what was in it stays. */
bool sepax__builder_corners(mesh_builder *b, size_t corners);

/* One triangle more. Fails on a coordinate that is not finite or beyond 2^1000, and above the limit
 * of triangles. */
bool sepax__builder_triangle(mesh_builder *b, const double v[3][3]);

/* Fails as that does on a triangle of the soup that a reader filled itself. */
bool sepax__builder_within(const mesh_builder *b);

/* The polygon of the first `count` (3 or more) corners in b->corner as triangles, by polygon.h;
 * counts it in account.divided and account.bent. Fails on one that cannot be divided. The messages
 * call it "face 17" by `what` and number; with line 0 they have no line. */
bool sepax__builder_polygon(mesh_builder *b, size_t count, size_t line, const char *what,
                            size_t number);

/* `count` more elements of this kind without a surface. */
bool sepax__builder_other(mesh_builder *b, const char *what, size_t count);

#endif
