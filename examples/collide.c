/* SPDX-License-Identifier: MIT */
/* collide.c - the colliding triangles of two STL files on a grid of 18 bits, by the library:
 *   cc collide.c $(pkg-config --cflags --libs sepax) -o collide && ./collide a.stl b.stl */
#include <sepax_grid.h>
#include <stdio.h>
#include <stdlib.h>

static int fail(const char *text) {
  fprintf(stderr, "collide: %s\n", text);
  return 2;
}

int main(int argc, char **argv) {
  sepax_soup soup[2] = {{0}, {0}};
  sepax_tri *tri[2];
  sepax_grid grid;
  sepax_pairs hits;
  sepax_error error = {0};
  if (argc != 3) {
    return fail("give A.stl B.stl");
  }
  for (int i = 0; i < 2; i++) {
    if (!sepax_stl_read(&soup[i], argv[1 + i], false, &error)) {
      return fail(error.text);
    }
  }
  const sepax_mesh *const mesh[2] = {SEPAX_SOUP_MESH(&soup[0]), SEPAX_SOUP_MESH(&soup[1])};
  if (!sepax_grid_fit(&grid, mesh, 2, 18, &error)) { /* as fine as both meshes allow */
    return fail(error.text);
  }
  for (int i = 0; i < 2; i++) {
    tri[i] = malloc(soup[i].count * sizeof *tri[i]);
    if (tri[i] == NULL) {
      return fail("no memory");
    }
    if (!sepax_quantise(mesh[i], &grid, tri[i], &error)) {
      return fail(error.text);
    }
  }
  if (!sepax_colliding_pairs(tri[0], soup[0].count, tri[1], soup[1].count, NULL, &hits, &error)) {
    return fail(error.text);
  }
  for (size_t n = 0; n < hits.count; n++) {
    printf("A[%zu] B[%zu]\n", hits.pair[n][0], hits.pair[n][1]);
  }
  sepax_pairs_free(&hits);
  for (int i = 0; i < 2; i++) {
    free(tri[i]);
    sepax_soup_free(&soup[i]);
  }
  return 0;
}
