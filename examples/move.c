/* SPDX-License-Identifier: MIT */
/* move.c - a tool goes down 1 mm at a time until it touches the workpiece; exact, without a grid:
 *   cc move.c $(pkg-config --cflags --libs sepax) -o move && ./move tool.stl workpiece.stl */
#include <sepax.h>
#include <stdio.h>

int main(int argc, char **argv) {
  sepax_body *body[2];
  sepax_error error = {0};
  for (int k = 0; k < 2; k++) { /* trees are built once */
    sepax_soup mesh;
    if (argc != 3 || !sepax_stl_read(&mesh, argv[1 + k], false, &error) ||
        !sepax_body_new(&body[k], SEPAX_SOUP_MESH(&mesh), NULL, &error)) {
      fprintf(stderr, "move: %s\n", argc != 3 ? "give TOOL.stl WORKPIECE.stl" : error.text);
      return 2;
    }
    sepax_soup_free(&mesh);
  }
  sepax_pose pose = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};
  sepax_pairs hits = {0};
  for (; hits.count == 0 && pose.translation[2] > -1000; pose.translation[2] -= 1) {
    if (!sepax_bodies_collide(body[0], &pose, body[1], NULL, NULL, &hits, &error)) {
      fprintf(stderr, "move: %s\n", error.text);
      return 2;
    }
    printf("%g mm: %zu pairs of triangles collide\n", pose.translation[2], hits.count);
  }
  sepax_pairs_free(&hits); /* freed where it is empty, too */
  sepax_body_free(body[0]);
  sepax_body_free(body[1]);
  return 0;
}
