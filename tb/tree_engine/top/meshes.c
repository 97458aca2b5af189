/* SPDX-License-Identifier: MIT */
/* meshes.c - two bodies, STL or files of sepax tree, in the poses of a file through the engine. */
#include "bench.h"
#include "meshes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool is_tree(const char *path) {
  size_t length = strlen(path);
  return length > 4 && strcmp(path + length - 4, ".sxt") == 0;
}

static sepax_tree *build(const sepax_grid *grid, const sepax_soup *mesh, const char *path) {
  sepax_error error = {0};
  sepax_tree *tree = NULL;
  sepax_tri *tri = malloc((mesh->count + 1) * sizeof *tri);
  if (tri == NULL) {
    stop("out of memory");
  }
  stop_at(!sepax_quantise(SEPAX_SOUP_MESH(mesh), grid, tri, &error) ||
              !sepax_tree_new(&tree, tri, mesh->count, grid, &error),
          path, error.text);
  free(tri);
  return tree;
}

/* Both bodies; STL files on one grid, that of the other body's tree if that is one. */
static void load_both(sepax_tree *tree[2], const char *const path[2], double resolution) {
  sepax_error error = {0};
  sepax_soup mesh[2] = {{0}, {0}};
  sepax_mesh view[2];
  const sepax_mesh *read[2];
  size_t meshes = 0;
  sepax_grid grid = {resolution, {0, 0, 0}, SEPAX_WORD};
  for (int i = 0; i < 2; i++) {
    if (is_tree(path[i])) {
      stop_on(!sepax_tree_read(&tree[i], path[i], &error), error.text);
      sepax_grid own = sepax_tree_grid(tree[i]);
      stop_at(own.word > SEPAX_WORD, path[i],
              "a tree of more bits than the engine has; make it anew with the engine's --word");
      stop_at(i == 1 && is_tree(path[0]) && own.resolution != grid.resolution, path[1],
              "its resolution is not that of the other tree; make both with one");
      grid = own;
    } else {
      stop_on(!mesh_file_read(&mesh[i], path[i], false, &error), error.text);
      view[i] = *SEPAX_SOUP_MESH(&mesh[i]);
      read[meshes++] = &view[i];
    }
  }
  stop_on(grid.resolution <= 0 && !sepax_grid_fit(&grid, read, meshes, SEPAX_WORD, &error),
          error.text);
  for (int i = 0; i < 2; i++) {
    if (!is_tree(path[i])) {
      tree[i] = build(&grid, &mesh[i], path[i]);
      sepax_soup_free(&mesh[i]);
    }
  }
}

void bench_meshes(const char *const path[3], double resolution, unsigned modes, unsigned budget,
                  const memory_options *options) {
  sepax_error error = {0};
  sepax_tree *tree[2] = {NULL, NULL};
  sepax_poses poses;
  load_both(tree, path, resolution);
  sepax_grid grid = sepax_tree_grid(tree[0]);
  printf("%s\n%s: %zu triangles\n%s: %zu triangles\n%s: %s\n", SEPAX_OPTIONS, path[0],
         sepax_tree_triangles(tree[0]), path[1], sepax_tree_triangles(tree[1]), path[2],
         "poses of the second");
  printf("grid: %.9g mm per LSB, W = %d\n", grid.resolution, grid.word);
  stop_on(!sepax_poses_read(&poses, path[2], &error), error.text);
  sepax_tree_job job = {.count = (uint32_t)poses.count, .modes = modes, .budget = budget};
  bench_tree(tree[0], job.body[0]);
  bench_tree(tree[1], job.body[1]);
  size_t at = bench_space(SEPAX_TREE_POSE_STRIDE * poses.count, SEPAX_TREE_POSE_STRIDE);
  for (size_t n = 0; n < poses.count; n++) {
    sepax_tree_pose pose;
    if (!sepax_tree_pose_make(&pose, tree[0], NULL, tree[1], &poses.pose[n], design.margin[1],
                              &error)) {
      char line[640];
      snprintf(line, sizeof line, "pose %zu: %s", n + 1, error.text);
      stop_at(true, path[2], line);
    }
    sepax_tree_pose_pack(&pose, bench_at(at + SEPAX_TREE_POSE_STRIDE * n));
  }
  job.poses = bench_address(at);
  bench_batch batch = {.jobs = 1, .print = true, .stop_at = -1};
  batch.list = bench_space(SEPAX_TREE_JOB_BYTES, SEPAX_TREE_JOB_BYTES);
  sepax_tree_job_pack(&job, bench_at(batch.list));
  bench_attach(*options);
  uint64_t begin = bus_cycles();
  bench_run(&batch);
  const memory *m = bus_attached();
  printf("%llu cycles in all, %llu bytes read, %llu near pairs, %llu poses collide, %llu out of "
         "range\n",
         (unsigned long long)(bus_cycles() - begin),
         (unsigned long long)(MEMORY_BEAT * m->counts.beats), (unsigned long long)batch.near,
         (unsigned long long)batch.hits, (unsigned long long)batch.out_of_range);
  bool usual = options->latency == SEPAX_TREE_LATENCY && options->stress == 0;
  if (modes == SEPAX_TREE_COLD && budget == 0 && usual) {
    printf("predicted: mean %.0f cycles, a pose by up to %+.1f %% off\n",
           (double)batch.predicted / (double)poses.count, 100 * batch.off);
  }
  printf("%llu poses, %llu mismatches, mean %.0f cycles, worst %llu\n",
         (unsigned long long)batch.poses, (unsigned long long)batch.mismatches,
         (double)batch.cycles / (double)(batch.poses > 0 ? batch.poses : 1),
         (unsigned long long)batch.worst);
  expect("poses", batch.poses, poses.count);
  sepax_poses_free(&poses);
  sepax_tree_free(tree[0]);
  sepax_tree_free(tree[1]);
}
