/* SPDX-License-Identifier: MIT */
/* count.c - what a mesh file has, by the library:
 *   cc count.c $(pkg-config --cflags --libs sepax-io) -o count && ./count part.3mf */
#include <sepax_io.h>
#include <stdio.h>

int main(int argc, char **argv) {
  sepax_soup soup;
  sepax_mesh_account account;
  sepax_error error = {0};
  if (argc != 2) {
    fputs("count: give a mesh file\n", stderr);
    return 2;
  }
  if (!sepax_mesh_read(&soup, &account, argv[1], NULL, &error)) {
    fprintf(stderr, "count: %s\n", error.text);
    return 2;
  }
  printf("%s: %s, %zu triangles\n", argv[1], account.format, account.triangles);
  for (size_t n = 0; n < account.remarks; n++) {
    printf("%s: %zu (%s)\n", account.remark[n].what, account.remark[n].count,
           account.remark[n].which);
  }
  for (size_t n = 0; n < account.others; n++) {
    printf("without a surface: %zu %s\n", account.other[n].count, account.other[n].what);
  }
  sepax_soup_free(&soup);
  return 0;
}
