/* SPDX-License-Identifier: MIT */
/* mesh.c - sepax mesh: sample objects as STL. */
#include "cli/question.h"
#include "command_table.h"
#include "sepax_vectors.h"

#include <stdio.h>

typedef struct {
  const char *shape, *path;
  uint64_t triangles;
  double at[3], size;
  bool ascii, list;
} mesh_options;

enum { KEY_AT = 0x300, KEY_SIZE, KEY_ASCII, KEY_LIST, TRIANGLES_MOST = 1000000000 };

static const struct argp_option options[] = {
    {"output", 'o', "FILE", 0, "STL file to write", 0},
    {"triangles", 'n', "COUNT", 0, "number of triangles, an even number (default 400)", 0},
    {"at", KEY_AT, "X,Y,Z", 0, "position of the object in mm (default 0,0,0)", 0},
    {"size", KEY_SIZE, "MM", 0,
     "diameter or longest side of the object in mm (default: a size for each shape)", 0},
    {"ascii", KEY_ASCII, NULL, 0, "write ASCII STL instead of binary STL", 0},
    {"list", KEY_LIST, NULL, 0, "list the shapes and exit", 0},
    {0}};

static error_t parse(int key, char *text, struct argp_state *state) {
  mesh_options *o = state->input;
  switch (key) {
  case 'o':
    o->path = text;
    return 0;
  case 'n':
    o->triangles = cli_count(state, "triangles", text, 0, TRIANGLES_MOST);
    return 0;
  case KEY_AT:
    cli_vector(state, "at", text, o->at);
    return 0;
  case KEY_SIZE:
    o->size = cli_number(state, "size", text);
    if (o->size <= 0) {
      argp_error(state, "size: %s is not above 0", text);
    }
    return 0;
  case KEY_ASCII:
    o->ascii = true;
    return 0;
  case KEY_LIST:
    o->list = true;
    return 0;
  case ARGP_KEY_ARG:
    if (o->shape != NULL) {
      argp_error(state, "unexpected argument '%s': give one shape", text);
    }
    o->shape = text;
    return 0;
  case ARGP_KEY_END:
    if (!o->list && (o->shape == NULL || o->path == NULL)) {
      argp_error(state, "give a shape and -o FILE (--list lists the shapes)");
    }
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

int cli_mesh(int argc, char **argv) {
  static const struct argp argp = {
      options,
      parse,
      "SHAPE",
      "Write a sample object as an STL file: a closed mesh with any even number of triangles.",
      NULL,
      NULL,
      NULL};
  mesh_options o = {.triangles = 400};
  cli_parse(&argp, argc, argv, &o);
  if (o.list) {
    for (size_t i = 0; sepax_sample_name(i) != NULL; i++) {
      printf("%-10s %s (at least %zu triangles)\n", sepax_sample_name(i), sepax_sample_about(i),
             sepax_sample_least(i));
    }
    return 0;
  }
  sepax_error error = {0};
  sepax_soup mesh = {0};
  const char *const output = o.path;
  bool ok = cli_outputs_allowed(&output, 1, NULL, 0, &error) &&
            sepax_sample(&mesh, o.shape, (size_t)o.triangles, o.at, o.size, &error) &&
            sepax_stl_write(&mesh, o.path, o.ascii, &error);
  if (ok) {
    printf("%s: %s, %zu triangles\n", o.path, o.shape, mesh.count);
  }
  sepax_soup_free(&mesh);
  return ok ? 0 : cli_fail(argv[0], &error);
}
