/* SPDX-License-Identifier: MIT */
/* collide.c - the engine's driver at work: two STL files are put on one grid, loaded into
 * the verilated engine over its buses, and the pairs of triangles that collide are printed.
 *   make experiment NAME=driver LANES=16 MESH_A=a.stl MESH_B=b.stl
 * On a board, sepax_driver.c stays as it is; the four accesses of `bus` become registers and
 * DMA, and main ends where it says. */
#include "object_engine/bus.h"
#include "sepax_models.h"
#include "sepax_driver.h"
#include "sepax_params.h"

#include <stdio.h>
#include <stdlib.h>

static bool print(void *context, const sepax_hit *hit) {
  (void)context;
  printf("%zu %zu%s\n", hit->a, hit->b,
         hit->out_of_range ? " undecided"
         : hit->warning    ? " too near"
                           : "");
  return true;
}

static int32_t (*flat(const sepax_tri *tri, size_t count))[9] {
  int32_t(*c)[9] = malloc((count + 1) * sizeof *c);
  if (c == NULL) {
    fprintf(stderr, "collide: out of memory\n");
    exit(2);
  }
  for (size_t i = 0; i < count; i++) {
    for (int k = 0; k < 3; k++) {
      c[i][3 * k] = tri[i].v[k].x;
      c[i][3 * k + 1] = tri[i].v[k].y;
      c[i][3 * k + 2] = tri[i].v[k].z;
    }
  }
  return c;
}

int main(int argc, char **argv) {
  if (argc != 3 && argc != 4) {
    fprintf(stderr, "usage: collide A.stl B.stl [RESOLUTION]\n");
    return 2;
  }
  sepax_error error = {0};
  sepax_scene scene;
  const char *const path[2] = {argv[1], argv[2]};
  char *end = argv[argc - 1];
  const sepax_grid grid = {argc == 4 ? strtod(argv[3], &end) : 0, {0, 0, 0}, SEPAX_WORD};
  if (argc == 4 && (*end != '\0' || !(grid.resolution > 0))) {
    fprintf(stderr, "collide: '%s' is not a length above 0\n", argv[3]);
    return 2;
  }
  if (!sepax_scene_load(&scene, path, &grid, false, &error)) {
    fprintf(stderr, "collide: %s\n", error.text);
    return 2;
  }
  int32_t(*a)[9] = flat(scene.tri[0], scene.count[0]);
  int32_t(*b)[9] = flat(scene.tri[1], scene.count[1]);
  bus_open(0, NULL);

  sepax_device device;
  const sepax_bus bus = {NULL, bus_read, bus_write, bus_send, bus_receive};
  sepax_counts counts = {0};
  sepax_status status = sepax_device_open(&device, &bus);
  if (status == SEPAX_DRIVER_OK) {
    status = sepax_device_collide(&device, a, scene.count[0], b, scene.count[1], false, print, NULL,
                                  &counts);
  }
  /* On a board: here. */

  fprintf(stderr, "collide: %s; %llu pairs, %llu to the core, %llu collide, %llu cycles\n",
          sepax_status_text(status), (unsigned long long)counts.pairs,
          (unsigned long long)counts.candidates, (unsigned long long)counts.collisions,
          (unsigned long long)counts.cycles);
  bus_close();
  free(a);
  free(b);
  sepax_scene_free(&scene);
  return status != SEPAX_DRIVER_OK ? 2 : counts.collisions > 0;
}
