/* SPDX-License-Identifier: MIT */
/* cutting_left.c - what is left of the stock, as a file. */
#include "path/stock/cutting_state.h"
#include "util/write_file.h"

#include <stdio.h>
#include <string.h>

static bool write_obj(FILE *out, const void *context) {
  const sepax_soup *mesh = context;
  bool ok = fputs("# what is left of the stock, in metres\n", out) != EOF;
  for (size_t n = 0; n < mesh->count && ok; n++) {
    const double(*v)[3] = (const double(*)[3])mesh->facet[n].v;
    for (int k = 0; k < 3 && ok; k++) {
      ok = fprintf(out, "v %.17g %.17g %.17g\n", v[k][0], v[k][1], v[k][2]) > 0;
    }
    ok = ok && fputs("f -3 -2 -1\n", out) != EOF;
  }
  return ok;
}

bool path_cutting_write_left(const path_cutting *c, sepax_error *error) {
  enum { TRIANGLES_MOST = 20000000 };
  const char *path = c->q->left;
  size_t length = strlen(path);
  sepax_soup mesh = {0};
  if (length < 4 || strcmp(path + length - 4, ".obj") != 0) {
    return sepax__stock_write(c->outer, path, error);
  }
  bool ok = sepax__stock_mesh(c->outer, TRIANGLES_MOST, &mesh, error) &&
            sepax_write_file(path, write_obj, &mesh, error);
  sepax_soup_free(&mesh);
  return ok;
}
