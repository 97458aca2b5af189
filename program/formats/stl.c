/* stl.c - STL files by the library's reader, their length bounded before anything is read. */
#include "formats/confined.h"
#include "formats/formats.h"
#include "formats/mesh_format_table.h"
#include "util/error.h"

#include <stdio.h>

/* What the head of a binary STL announces, if it is as long as that; of another file 0. */
static size_t facets_announced(const char *path, size_t bytes) {
  enum { HEAD = 84, FACET = 50 };
  unsigned char head[HEAD];
  FILE *in = fopen(path, "rb");
  size_t count = 0;
  if (in != NULL && fread(head, 1, HEAD, in) == HEAD) {
    count = head[80] | (size_t)head[81] << 8 | (size_t)head[82] << 16 | (size_t)head[83] << 24;
  }
  if (in != NULL) {
    fclose(in);
  }
  return bytes == HEAD + FACET * count ? count : 0;
}

/* Bounded before anything is read. A text of this length has fewer facets. */
bool mesh_read_stl(sepax_soup *mesh, const char *path, sepax_error *error) {
  size_t bytes = 0;
  if (!confined_size(path, &bytes, error)) {
    return false;
  }
  size_t facets = facets_announced(path, bytes);
  return facets <= FORMAT_FACETS_MOST
             ? sepax_stl_read(mesh, path, false, error)
             : sepax_fail(error, SEPAX_ERROR_FORMAT,
                          "%.300s: %zu triangles, more than %d; simplify the mesh", path, facets,
                          FORMAT_FACETS_MOST);
}
