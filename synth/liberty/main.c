/* main.c - prints the cells of a Liberty file as JSON: liberty FILE.lib */
#include "cells.h"

#include <jansson.h>
#include <stdio.h>

int main(int argc, char **argv) {
  if (argc != 2) {
    fputs("usage: liberty FILE.lib\n", stderr);
    return 2;
  }
  static library lib;
  library_read(&lib, argv[1]);
  json_t *cells = json_object();
  for (size_t k = 0; k < lib.cells; k++) {
    json_object_set_new(cells, lib.cell[k].name,
                        json_pack("{s:f}", "leakage_w", lib.cell[k].leakage));
  }
  int status = json_dumpf(cells, stdout, JSON_INDENT(1));
  json_decref(cells);
  return status == 0 ? 0 : 2;
}
