/* SPDX-License-Identifier: MIT */
/* trees.c - what every tree of a body holds, and that threads do not matter to it. */
#include "body/body.h"
#include "harness.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LEVELS = 64 };

/* Kinds: strewn; of very different sizes; all the same; in a row whose steps halve. */
static sepax_soup drawn(size_t count, int kind) {
  sepax_soup mesh = {.facet = calloc(count, sizeof(sepax_facet)), .count = count};
  assert_non_null(mesh.facet);
  for (size_t n = 0; n < count; n++) {
    double size = kind == 1 ? ldexp(1, random_below(60) - 60) : 0.1;
    double along = ldexp(1, -(int)(n % 1000));
    for (int k = 0; k < 9; k++) {
      double corner = k < 3 ? random_unit() : mesh.facet[n].v[0][k % 3];
      mesh.facet[n].v[k / 3][k % 3] = kind == 2   ? k
                                      : kind == 3 ? along * (1 + k % 4)
                                      : k < 3     ? corner
                                                  : corner + size * random_unit();
    }
  }
  return mesh;
}

typedef struct {
  const sepax_body *body;
  bool *seen;
  int deepest;
} visit;

/* Boxes around a point of a triangle: the AABB of a lane, and the box of any direction, of which
 * the doubles that it comes from are wrong by up to 2^-50 (a search allows for 2^-44, placement.c).
 */
static void assert_inside(const sepax_body *b, const body_boxes *boxes, const body_node *node,
                          int lane, const double v[3]) {
  double from[3];
  for (int i = 0; i < 3; i++) {
    double at = (v[i] - b->centre[i]) / b->scale;
    from[i] = at - (double)boxes->centre[i][lane];
    assert_true(fabs(at - (double)node->centre[i][lane]) <= (double)node->half[i][lane]);
  }
  for (int i = 0; i < 3; i++) {
    double along = 0;
    for (int j = 0; j < 3; j++) {
      along += from[j] * (double)boxes->axis[i][j][lane];
    }
    assert_true(fabs(along) <= (double)boxes->half[i][lane] + 0x1p-50);
  }
}

/* All triangles below a node, in the tree's order from `place` on, are in its boxes. */
static uint32_t assert_below(visit *t, uint32_t number, uint32_t place, int level) {
  const sepax_body *b = t->body;
  const body_node *node = &b->node[number];
  t->deepest = level > t->deepest ? level : t->deepest;
  assert_true(number < b->nodes && node->children >= 1 && node->children <= BODY_WIDE);
  for (int lane = 0; lane < (int)node->children; lane++) {
    uint32_t child = node->child[lane];
    uint32_t end = place + 1;
    assert_int_equal(b->boxes[number].child[lane], child);
    if ((child & BODY_TRIANGLE) != 0) {
      assert_int_equal(child, BODY_TRIANGLE + place);
      assert_false(t->seen[b->number[place]]);
      t->seen[b->number[place]] = true;
    } else {
      end = assert_below(t, child, place, level + 1);
    }
    for (; place < end; place++) {
      for (int k = 0; k < 3; k++) {
        assert_inside(b, &b->boxes[number], node, lane, b->triangle[place][k]);
      }
    }
  }
  return place;
}

CASE(triangles_are_in_their_boxes) {
  static const size_t counts[] = {1, 2, 8, 9, 65, 700, 5000};
  for (size_t c = 0; c < LENGTH(counts); c++) {
    for (int kind = 0; kind < 4; kind++) {
      sepax_soup mesh = drawn(counts[c], kind);
      sepax_body *body;
      assert_works(sepax_body_new(&body, SEPAX_SOUP_MESH(&mesh), NULL, &fault));
      visit t = {body, calloc(mesh.count, sizeof(bool)), 0};
      assert_non_null(t.seen);
      assert_int_equal(assert_below(&t, 0, 0, 1), mesh.count);
      assert_true(t.deepest <= LEVELS);
      for (size_t n = 0; n < mesh.count; n++) {
        assert_memory_equal(body->triangle[n], mesh.facet[body->number[n]].v, sizeof(facet_points));
      }
      free(t.seen);
      sepax_body_free(body);
      sepax_soup_free(&mesh);
    }
  }
}

CASE(threads_do_not_matter) {
  static const int threads[] = {1, 2, 7};
  for (int kind = 0; kind < 4; kind++) {
    sepax_soup mesh = drawn(20000, kind);
    sepax_body *body[LENGTH(threads)];
    for (size_t k = 0; k < LENGTH(threads); k++) {
      assert_works(sepax_body_new(&body[k], SEPAX_SOUP_MESH(&mesh),
                                  &SEPAX_STRUCT(sepax_build, .threads = threads[k]), &fault));
      assert_int_equal(body[k]->nodes, body[0]->nodes);
      assert_memory_equal(body[k]->node, body[0]->node, body[0]->nodes * sizeof(body_node));
      assert_memory_equal(body[k]->boxes, body[0]->boxes, body[0]->nodes * sizeof(body_boxes));
      assert_memory_equal(body[k]->number, body[0]->number, mesh.count * sizeof(uint32_t));
    }
    for (size_t k = 0; k < LENGTH(threads); k++) {
      sepax_body_free(body[k]);
    }
    sepax_soup_free(&mesh);
  }
}
