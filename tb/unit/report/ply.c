/* SPDX-License-Identifier: MIT */
/* ply.c - PLY files: where vertices are, which faces have which colour and number. */
#include "report/ply.h"
#include "harness.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FACES = 3, VERTICES = 3 * FACES };

static uint32_t word_at(const unsigned char *bytes) {
  return (uint32_t)(bytes[0] | bytes[1] << 8 | bytes[2] << 16) | (uint32_t)bytes[3] << 24;
}

static bool print_comment(FILE *out, const void *context) {
  return fprintf(out, "comment %s\n", (const char *)context) > 0;
}

/* Two bodies of one and two faces, the second turned about z by a right angle and moved. */
CASE(test_bodies) {
  static const sepax_facet facet[FACES] = {
      {.v = {{1, 2, 3}, {4, 5, 6}, {7, 8, 10}}},
      {.v = {{-1, 0.5, 2}, {0, 0, 0}, {3, 4, 5}}},
      {.v = {{6, 7, 8}, {9, 1, 2}, {0x1p-30, 0, 1}}},
  };
  static const sepax_pose turned = {{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}, {10, 20, 30}};
  static const bool marked[2] = {false, true};
  sepax_soup mesh[2] = {{.facet = calloc(1, sizeof facet[0]), .count = 1},
                        {.facet = calloc(2, sizeof facet[0]), .count = 2}};
  assert_non_null(mesh[0].facet);
  assert_non_null(mesh[1].facet);
  memcpy(mesh[0].facet, facet, sizeof facet[0]);
  memcpy(mesh[1].facet, facet + 1, 2 * sizeof facet[0]);
  const report_ply_body body[2] = {
      {.mesh = &mesh[0], .colour = {1, 2, 3}},
      {.mesh = &mesh[1],
       .pose = &turned,
       .colour = {4, 5, 6},
       .marked_colour = {7, 8, 255},
       .marked = marked},
  };
  static const unsigned char colours[FACES][3] = {{1, 2, 3}, {4, 5, 6}, {7, 8, 255}};
  char place[PATH_BYTES + 8];
  snprintf(place, sizeof place, "%s/b.ply", folder);
  for (int numbered = 0; numbered < 2; numbered++) {
    const report_ply ply = {.body = body,
                            .bodies = 2,
                            .numbered = numbered == 1,
                            .print_comments = print_comment,
                            .context = "of a test"};
    assert_works(report_ply_write(&ply, place, &fault));
    static char text[4096];
    memset(text, 0, sizeof text);
    FILE *in = fopen(place, "rb");
    assert_non_null(in);
    size_t size = fread(text, 1, sizeof text - 1, in);
    assert_int_equal(fclose(in), 0);
    assert_non_null(strstr(text, "comment of a test\nelement vertex 9\n"));
    assert_non_null(strstr(text, "element face 3\n"));
    assert_true((strstr(text, "property uint body\nend_header\n") != NULL) == (numbered == 1));
    const char *end = strstr(text, "end_header\n");
    assert_non_null(end);
    const unsigned char *at = (const unsigned char *)end + strlen("end_header\n");
    size_t face_bytes = numbered == 1 ? 20 : 16;
    assert_int_equal(size, (size_t)((const char *)at - text) + VERTICES * 24 + FACES * face_bytes);
    for (int n = 0; n < VERTICES; n++) {
      const double *own = facet[n / 3].v[n % 3];
      const double there[3] = {10 - own[1], 20 + own[0], 30 + own[2]};
      assert_memory_equal(at + 24 * n, n < 3 ? own : there, sizeof there);
    }
    for (uint32_t n = 0; n < FACES; n++) {
      const unsigned char *face = at + VERTICES * 24 + face_bytes * n;
      assert_int_equal(face[0], 3);
      for (uint32_t k = 0; k < 3; k++) {
        assert_int_equal(word_at(face + 1 + 4 * k), 3 * n + k);
      }
      assert_memory_equal(face + 13, colours[n], 3);
      assert_true(numbered == 0 || word_at(face + 16) == (n > 0));
    }
    assert_fault(report_ply_write(&ply, "no/such/ab.ply", &fault), "no/such/ab.ply");
  }
  sepax_soup_free(&mesh[0]);
  sepax_soup_free(&mesh[1]);
}
