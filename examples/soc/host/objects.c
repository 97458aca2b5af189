/* SPDX-License-Identifier: MIT */
/* objects.c - two STL files as objects.h of the firmware: integers on one grid.
 *   objects A.stl B.stl WORD [RESOLUTION]     without RESOLUTION the finest grid that holds both */
#include "sepax_models.h"

#include <stdio.h>
#include <stdlib.h>

static void print(char name, const sepax_tri *tri, size_t count) {
  printf("enum { COUNT_%c = %zu };\n", name, count);
  printf("static const int32_t object_%c[][9] = {\n", name - 'A' + 'a');
  for (size_t i = 0; i < count; i++) {
    const sepax_vec *v = tri[i].v;
    printf("  {%d, %d, %d, %d, %d, %d, %d, %d, %d},\n", (int)v[0].x, (int)v[0].y, (int)v[0].z,
           (int)v[1].x, (int)v[1].y, (int)v[1].z, (int)v[2].x, (int)v[2].y, (int)v[2].z);
  }
  printf("};\n");
}

int main(int argc, char **argv) {
  if (argc != 4 && argc != 5) {
    fprintf(stderr, "usage: objects A.stl B.stl WORD [RESOLUTION]\n");
    return 2;
  }
  char *end_word = NULL;
  char *end = argv[argc - 1];
  long word = strtol(argv[3], &end_word, 10);
  double resolution = argc == 5 ? strtod(argv[4], &end) : 0;
  if (*end_word != '\0' || word < 4 || word > 32 ||
      (argc == 5 && (*end != '\0' || resolution <= 0))) {
    fprintf(stderr, "objects: WORD is 4 ... 32, RESOLUTION a length above 0\n");
    return 2;
  }
  sepax_error error = {0};
  sepax_scene scene;
  const char *const path[2] = {argv[1], argv[2]};
  const sepax_grid grid = {resolution, {0, 0, 0}, (int)word};
  if (!sepax_scene_load(&scene, path, &grid, false, &error)) {
    fprintf(stderr, "objects: %s\n", error.text);
    return 2;
  }
  printf("/* objects.h - made by objects from %s and %s; do not edit. */\n", argv[1], argv[2]);
  printf("#ifndef OBJECTS_H\n#define OBJECTS_H\n\n#include <stdint.h>\n\n");
  print('A', scene.tri[0], scene.count[0]);
  print('B', scene.tri[1], scene.count[1]);
  printf("\n#endif\n");
  sepax_scene_free(&scene);
  return 0;
}
