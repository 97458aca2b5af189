/* collide.c - the colliding triangles of two STL files, by the installed library:
 *   cc collide.c $(pkg-config --cflags --libs sepax) -o collide && ./collide a.stl b.stl */
#include <sepax.h>

int main(int argc, char **argv) {
  sepax_scene scene;
  sepax_pairs hits;
  sepax_error error = {0};
  sepax_grid grid = {.word = 18}; /* resolution 0: as fine as both meshes allow */
  if (argc != 3) {
    fputs("usage: collide A.stl B.stl\n", stderr);
    return 2;
  }
  const char *const path[2] = {argv[1], argv[2]};
  if (!sepax_scene_load(&scene, path, &grid, false, &error)) {
    fprintf(stderr, "collide: %s\n", error.text);
    return 2;
  }
  if (!sepax_colliding_pairs(scene.tri[0], scene.count[0], scene.tri[1], scene.count[1], NULL,
                             &hits, &error)) {
    fprintf(stderr, "collide: %s\n", error.text);
    return 2;
  }
  for (size_t n = 0; n < hits.count; n++) {
    printf("A[%zu] B[%zu]\n", hits.pair[n][0], hits.pair[n][1]);
  }
  sepax_pairs_free(&hits);
  sepax_scene_free(&scene);
  return 0;
}
