/* SPDX-License-Identifier: MIT */
/* solid_small.h - is a small octahedron inside a mesh? */
#ifndef SOLID_SMALL_H
#define SOLID_SMALL_H

#include "solid_meshes.h"

#include <time.h>

/* A small octahedron and what is asked of it, in a mesh that is then freed. */
static inline void assert_small(sepax_soup *stock, double x, double y, double z, bool closed,
                                bool consistent, sepax_inside expected) {
  const double c[3] = {x, y, z};
  sepax_soup small = {0};
  sepax_body *body[2];
  sepax_shell shell[2];
  sepax_inside within[2] = {SEPAX_INSIDE, SEPAX_INSIDE};
  add_octahedron(&small, c, 0.125);
  assert_works(sepax_body_new(&body[0], SEPAX_SOUP_MESH(&small), NULL, &fault));
  assert_works(sepax_body_new(&body[1], SEPAX_SOUP_MESH(stock), NULL, &fault));
  for (int k = 0; k < 2; k++) {
    assert_works(sepax_shell_find(&shell[k], body[k], &fault));
  }
  assert_int_equal(shell[1].closed, closed);
  assert_int_equal(shell[1].consistent, consistent);
  assert_works(sepax_bodies_within(&shell[0], NULL, &shell[1], NULL, within, &fault));
  assert_int_equal(within[0], expected);
  assert_int_equal(within[1], SEPAX_OUTSIDE);
  for (int k = 0; k < 2; k++) {
    sepax_shell_free(&shell[k]);
    sepax_body_free(body[k]);
  }
  sepax_soup_free(&small);
}

/* Of two blocks that overlap. */
static const double corner[4][3] = {{0, 0, 0}, {2, 2, 2}, {1, -1, 0}, {3, 1, 2}};

/* Find the shell of a mesh, which takes less than 3 s; frees the mesh. */
static inline void assert_soon(sepax_soup *m, size_t parts) {
  sepax_body *body = NULL;
  sepax_shell shell;
  assert_works(sepax_body_new(&body, SEPAX_SOUP_MESH(m), NULL, &fault));
  clock_t start = clock();
  assert_works(sepax_shell_find(&shell, body, &fault));
  assert_true(clock() - start < 3 * CLOCKS_PER_SEC);
  assert_true(shell.closed);
  assert_int_equal(shell.parts, parts);
  assert_int_equal(shell.pieces, 1);
  sepax_shell_free(&shell);
  sepax_body_free(body);
  sepax_soup_free(m);
}

#endif
