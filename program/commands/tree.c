/* SPDX-License-Identifier: MIT */
/* tree.c - sepax tree: writes a body as a tree for the tree engine, and describes trees and lists
 * of jobs. */
#include "cli/jobs.h"
#include "cli/meshes.h"
#include "cli/question.h"
#include "command_table.h"
#include "report/text.h"
#include "sepax_tree.h"
#include "util/error.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
  const char *path, *output;
  uint64_t word; /* 0: not given */
  cli_grid grid;
  cli_meshes meshes;
  bool walk;
} tree_options;

enum { KEY_WORD = 0x400, KEY_WALK, WORD = 18 };

static const struct argp_option options[] = {
    {"output", 'o', "FILE", 0,
     "tree to write. Without this option, MESH must be a tree or a list of jobs, which is checked "
     "and described",
     0},
    {"word", KEY_WORD, "W", 0, "bits of a coordinate, 4 ... 21 (default 18)", 0},
    {"walk", KEY_WALK, NULL, 0,
     "for a list of jobs: print the answer of the golden model in each pose", 0},
    {0}};

static error_t parse(int key, char *text, struct argp_state *state) {
  tree_options *o = state->input;
  switch (key) {
  case ARGP_KEY_INIT:
    state->child_inputs[0] = &o->grid;
    state->child_inputs[1] = &o->meshes;
    return 0;
  case 'o':
    o->output = text;
    return 0;
  case KEY_WORD:
    o->word = cli_count(state, "word", text, SEPAX_WORD_MIN, SEPAX_TREE_WORD_MAX);
    return 0;
  case KEY_WALK:
    o->walk = true;
    return 0;
  case ARGP_KEY_ARG:
    if (o->path != NULL) {
      argp_error(state, "unexpected argument '%s': give one file", text);
    }
    o->path = text;
    return 0;
  case ARGP_KEY_END:
    if (o->path == NULL) {
      argp_error(state, "give a mesh file and -o FILE, or a tree, or a list of jobs");
    }
    if (o->output == NULL && (o->word > 0 || o->grid.resolution != NULL ||
                              o->meshes.own.text != NULL || o->meshes.weld.text != NULL)) {
      argp_error(
          state,
          "word, resolution, unit, weld: apply only when a tree is written; give -o FILE, too");
    }
    if (o->grid.file_normals) {
      argp_error(state, "normals: a tree has no normals; leave it out");
    }
    o->grid.grid.word = o->word > 0 ? (int)o->word : WORD;
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

static bool name_file(sepax_error *error, const char *path) {
  sepax_error inner = *error;
  return sepax_fail(error, inner.code, "%.200s: %.300s", path, inner.text);
}

static bool make_tree(sepax_tree **tree, report_mesh *file, const tree_options *o,
                      sepax_error *error) {
  sepax_soup mesh;
  if (!cli_mesh_read(&mesh, file, o->path, &o->meshes, error)) {
    return false;
  }
  sepax_grid grid = o->grid.grid;
  const sepax_mesh *const one[] = {SEPAX_SOUP_MESH(&mesh)};
  sepax_tri *tri = malloc(mesh.count * sizeof *tri);
  bool ok = tri != NULL ||
            sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu triangles", mesh.count);
  ok = ok && (grid.resolution > 0 || sepax_grid_fit(&grid, one, 1, grid.word, error)) &&
       sepax_quantise(SEPAX_SOUP_MESH(&mesh), &grid, tri, error) &&
       sepax_tree_new(tree, tri, mesh.count, &grid, error);
  free(tri);
  sepax_soup_free(&mesh);
  return ok || name_file(error, o->path);
}

static void tell(const char *path, const sepax_tree *tree) {
  size_t bytes;
  sepax_tree_image(tree, &bytes);
  sepax_grid grid = sepax_tree_grid(tree);
  size_t triangles = sepax_tree_triangles(tree);
  printf("%s: %zu triangles, %zu nodes, %zu bytes, %.1f a triangle; W = %d, 1 LSB = %s mm, "
         "origin %s,%s,%s mm\n",
         path, triangles, sepax_tree_nodes(tree), bytes, (double)bytes / (double)triangles,
         grid.word, report_exactly(grid.resolution).text, report_exactly(grid.offset[0]).text,
         report_exactly(grid.offset[1]).text, report_exactly(grid.offset[2]).text);
}

int cli_tree(int argc, char **argv) {
  static const struct argp_child children[] = {
      {&cli_grid_argp, 0, NULL, 0}, {&cli_meshes_argp, 0, NULL, 0}, {0}};
  static const struct argp argp = {
      options,
      parse,
      "MESH",
      "Write a mesh (STL, OBJ, PLY, 3MF, DAE) as a tree in the memory format of the tree engine "
      "(docs/reference/tree-engine.md). Two trees fit each other if their resolutions are equal. "
      "Without --output, describe an existing tree, or a list of jobs from sepax path --jobs.",
      children,
      NULL,
      NULL};
  tree_options o = {.path = NULL, .meshes.unit = CLI_MILLIMETRES};
  cli_parse(&argp, argc, argv, &o);
  sepax_error error = {0};
  if (o.output == NULL && sepax_job_list_is(o.path)) {
    return cli_tell_jobs(o.path, o.walk, &error) ? 0 : cli_fail(argv[0], &error);
  }
  if (o.walk) {
    sepax_fail(&error, SEPAX_ERROR_ARGUMENT,
               "walk: %.300s is no list of jobs; make one with 'sepax path --jobs=FILE'", o.path);
    return cli_fail(argv[0], &error);
  }
  if (!cli_outputs_allowed(&o.output, 1, &o.path, 1, &error)) {
    return cli_fail(argv[0], &error);
  }
  sepax_tree *tree = NULL;
  report_mesh file = {.unit = 0};
  bool ok = o.output != NULL
                ? make_tree(&tree, &file, &o, &error) && sepax_tree_write(tree, o.output, &error)
                : sepax_tree_read(&tree, o.path, &error);
  if (ok && o.output != NULL && !report_mesh_is_plain(&file)) {
    report_print_mesh("", 0, o.path, &file);
  }
  if (ok) {
    tell(o.output != NULL ? o.output : o.path, tree);
  }
  sepax_tree_free(tree);
  return ok ? 0 : cli_fail(argv[0], &error);
}
