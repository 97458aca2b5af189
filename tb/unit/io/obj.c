/* SPDX-License-Identifier: MIT */
/* obj.c - OBJ: what becomes triangles, what is named, and what is refused with its line. */
#include "unit/io/reading.h"

#include <math.h>

/* Vertices 1 ... 4: 0, x, y, z. */
#define VERTICES "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\n"

static void read_text(const char *text, size_t faces, size_t triangles) {
  sepax_soup_free(&soup);
  assert_works(sepax_mesh_read(&soup, &account, put_file("a.obj", text), NULL, &fault));
  assert_string_equal(account.format, "OBJ");
  assert_int_equal(account.faces, faces);
  assert_int_equal(account.triangles, triangles);
  assert_int_equal(soup.count, triangles);
}

static void refuse(const char *text, const char *part) {
  sepax_soup none;
  assert_fault(sepax_mesh_read(&none, NULL, put_file("a.obj", text), NULL, &fault), part);
  assert_message("a.obj");
}

CASE(corners) {
  static const char *const faces[] = {
      "f 1 2 3\n",
      "f 1/1 2/1 3/1\n",
      "f 1//1 2//1 3//1\n",
      "f 1/1/1 2/1/1 3/1/1\n",
      "f -4 -3 -2\n",
      "fo 1 2 3\n",
      "f 1/-1/-1 2 3//1\n",
      "f\t1 2\t3 \t\n",
      "\t f 1 2 3   # x\n",
      "f 1 \\\n2 \\\r\n 3\n",
      "\\\nf\\\n1 2 \\\r3",
      "fo\\\r\n1 2 3 # C:\\parts\\\n",
      "# C:\\parts\\\n# f 1 2 3\nf 1 2 3\n",
      "f 1 2 3",
      "f 1 2 3\r",
  };
  char text[256];
  for (size_t n = 0; n < sizeof faces / sizeof faces[0]; n++) {
    snprintf(text, sizeof text, "%s%s%s", VERTICES, "vt 0 0\nvn 0 0 1\n", faces[n]);
    read_text(text, 1, 1);
    TRIANGLE(0, 0, 0, 0, 1, 0, 0, 0, 2, 0);
  }
}

CASE(lines) {
  read_text("\xef\xbb\xbf# a mark\r\n\r\nv 0 0 0\r\n v 1 0 0\r\n\tv 0 2 0\r\nf 1 2 3\r\n", 1, 1);
  TRIANGLE(0, 0, 0, 0, 1, 0, 0, 0, 2, 0);
  read_text("v 0 0 0\rv 1 0 0\rv 0 2 0\rf 1 2 3\r", 1, 1);
  TRIANGLE(0, 0, 0, 0, 1, 0, 0, 0, 2, 0);
  read_text("f 1 2 3\n" VERTICES "f 2 3 4\n", 2, 2); /* before its vertices */
  TRIANGLE(0, 0, 0, 0, 1, 0, 0, 0, 2, 0);
  TRIANGLE(1, 1, 0, 0, 0, 2, 0, 0, 0, 3);
  read_text(VERTICES "f -4 -3 -2\nv 9 9 9\nf -5 -4 -1\n", 2, 2); /* counted from each line */
  TRIANGLE(1, 0, 0, 0, 1, 0, 0, 9, 9, 9);
}

CASE(numbers) {
  read_text("v 1e0 +1. .5E+00\nv -0.1 1.0E+003 1e-320\nv 1e6 123456789012345678901234567890 0.1\n"
            "f 1 2 3\n",
            1, 1);
  TRIANGLE(0, 1, 1, 0.5, -0.1, 1000, 1e-320, 1e6, 123456789012345678901234567890.0, 0.1);
}

CASE(polygons) {
  read_text("v 0 0 0\nv 3 0 0\nv 3 2 0\nv 2 2 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\n"
            "f 1 2 3 4 5 6 7 8\n",
            1, 6);
  double area = 0;
  for (size_t n = 0; n < soup.count; n++) {
    const double(*v)[3] = (const double(*)[3])soup.facet[n].v;
    double own =
        (v[1][0] - v[0][0]) * (v[2][1] - v[0][1]) - (v[1][1] - v[0][1]) * (v[2][0] - v[0][0]);
    assert_true(own >= 0);
    area += own / 2;
  }
  assert_true(area == 5);
  assert_int_equal(account.divided, 1);
  assert_int_equal(account.bent, 0);
  read_text("v 0 0 0\nv 1 0 0\nv 1 1 0.1\nv 0 1 0\nf 1 2 3 4\n", 1, 2);
  assert_int_equal(account.bent, 1);
}

static bool same_point(const double p[3], const double q[3]) {
  return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
}

/* Of a polygon that is there twice, from another corner on or the other way round, each triangle is
 * there twice. */
static void assert_pairs(void) {
  for (size_t n = 0; n < soup.count; n++) {
    size_t equal = 0;
    for (size_t k = 0; k < soup.count; k++) {
      size_t common = 0;
      for (int i = 0; i < 9; i++) {
        common += same_point(soup.facet[n].v[i / 3], soup.facet[k].v[i % 3]);
      }
      equal += common == 3;
    }
    assert_int_equal(equal, 2);
  }
}

CASE(both_sides) {
  static const char *const orders[] = {"1 2 3 4", "2 3 4 1", "3 4 1 2", "4 1 2 3",
                                       "4 3 2 1", "3 2 1 4", "2 1 4 3", "1 4 3 2"};
  char text[200];
  for (size_t n = 0; n < sizeof orders / sizeof orders[0]; n++) {
    snprintf(text, sizeof text, "v 0 0 0\nv 1 0 0\nv 1 1 0.5\nv 0 1 0\nf 1 2 3 4\nf %s\n",
             orders[n]);
    read_text(text, 2, 4);
    assert_pairs();
    double z = 0; /* of the sum of area vectors: the sides cancel, or not */
    for (size_t k = 0; k < 4; k++) {
      const double(*v)[3] = (const double(*)[3])soup.facet[k].v;
      z += (v[1][0] - v[0][0]) * (v[2][1] - v[0][1]) - (v[1][1] - v[0][1]) * (v[2][0] - v[0][0]);
    }
    assert_true(z == (n < 4 ? 4 : 0));
  }
  /* Concave; with another polygon between. */
  read_text("v 0 0 0\nv 4 0 0\nv 4 4 0\nv 3 1 0\nv 0 1 0\nf 1 2 3 4 5\nf 2 1 5 4 3\n", 2, 6);
  assert_pairs();
  /* From each corner on, both ways: backwards another ear could be cut first. */
  for (size_t count = 6; count <= 12; count += 2) {
    for (size_t turn = 0; turn < 2 * count; turn++) {
      char twice[1000] = "";
      for (size_t n = 0; n < count; n++) {
        double angle = 6.2831853 * (double)n / (double)count;
        double radius = n % 2 == 0 ? 1 : 0.4 + 0.05 * (double)n; /* concave */
        snprintf(twice + strlen(twice), 60, "v %.6f %.6f 0\n", radius * cos(angle),
                 radius * sin(angle));
      }
      for (size_t n = 0; n < 2 * count; n++) {
        size_t other = turn % 2 == 0 ? n + turn / 2 : 2 * count - n + turn / 2;
        snprintf(twice + strlen(twice), 30, "%s%zu%s", n % count == 0 ? "f " : " ",
                 (n < count ? n : other) % count + 1, n % count == count - 1 ? "\n" : "");
      }
      read_text(twice, 2, 2 * (count - 2));
      assert_pairs();
    }
  }
  char many[4000] = "";
  for (int n = 0; n < 100; n++) {
    snprintf(many + strlen(many), 40, "v %d 0 0\nv %d 1 0\n", n, n);
  }
  for (int n = 0; n < 50; n++) {
    int k = n < 25 ? n : n - 25;
    snprintf(many + strlen(many), 40, n < 25 ? "f %d %d %d %d\n" : "f %4$d %3$d %2$d %1$d\n",
             2 * k + 1, 2 * k + 3, 2 * k + 4, 2 * k + 2);
  }
  read_text(many, 50, 100);
  assert_pairs();
}

/* The numbers behind a slash may be left out, or be of nothing. */
CASE(corners_of_nothing) {
  read_text(VERTICES "f 1/ 2// 3/\n", 1, 1);
  assert_int_equal(account.others, 0);
  read_text(VERTICES "vt 0 0\nf 1/1/1 2/2/0 3/-2/-1\n", 1, 1);
  assert_int_equal(others("texture coordinates of corners that are not there"), 2);
  assert_int_equal(others("normals of corners that are not there"), 3);
  read_text("v 0 0 0 nan nan nan\nv 1 0 0 -inf 0 0\nv 0 2 0 1 1 1\nf 1 2 3\n", 1, 1);
  assert_int_equal(others("vertex colours"), 3);
}

/* Each kind without a surface is counted by its name. */
CASE(what_has_no_surface) {
  read_text(VERTICES "mtllib a.mtl\no box\ng a b\ns off\nusemtl red\nvt 0 0\nvt 0 1\nvn 0 0 1\n"
                     "vp 0 1\np 1 2\nl 1 2\nl 2 3\nlod 1\nbevel on\ncstype bezier\ndeg 3\n"
                     "curv 0 1 1 2 3 4\nparm u 0 1\nend\nf 1 2 3\n",
            1, 1);
  assert_int_equal(others("material libraries"), 1);
  assert_int_equal(others("object names"), 1);
  assert_int_equal(others("group names"), 1);
  assert_int_equal(others("smoothing groups"), 1);
  assert_int_equal(others("material names"), 1);
  assert_int_equal(others("texture coordinates"), 2);
  assert_int_equal(others("vertex normals"), 1);
  assert_int_equal(others("parameter space vertices"), 1);
  assert_int_equal(others("points"), 1);
  assert_int_equal(others("lines"), 2);
  assert_int_equal(others("display attributes"), 2);
  assert_int_equal(others("statements of curves"), 5);
  assert_int_equal(account.others, 12);
  read_text("v 0 0 0 1\nv 1 0 0 0.5 0.5 0.5\nv 0 2 0 1 0.5 0.5 0.5\nf 1 2 3\n", 1, 1);
  assert_int_equal(others("vertex weights"), 2);
  assert_int_equal(others("vertex colours"), 2);
}

CASE(refused) {
  static const char *const row[][2] = {
      {VERTICES "f 0 1 2\n", "a.obj:5: '0': there is no such vertex; the file has 4"},
      {VERTICES "f 1 2 5\n", "a.obj:5: '5': there is no such vertex; the file has 4"},
      {VERTICES "f 1 2 -5\n",
       "a.obj:5: '-5': there is no such vertex; the file has 4, 4 of them above"},
      {"v 0 0 0\nf -1 -2 -3\n" VERTICES,
       "a.obj:2: '-2': there is no such vertex; the file has 5, 1 of them above"},
      {VERTICES "f 1 2\n", "a.obj:5: a face of 2 corners; give three or more"},
      {VERTICES "f\n", "a face of 0 corners"},
      {VERTICES "f 1 2 3.5\n", "'3.5' is no corner of a face"},
      {VERTICES "f 1 2 3/x\n", "'x' is no corner of a face"},
      {VERTICES "f 1 2 3/1/1/1\n", "a corner of more than three numbers"},
      {VERTICES "f 1 2 x\n", "'x' is no corner of a face"},
      {VERTICES "f 1 2 99999999999999999999\n", "there is no such vertex"},
      {VERTICES "F 1 2 3\n", "a.obj:5: 'F' is no word of OBJ"},
      {VERTICES "facet 1 2 3\n", "'facet' is no word of OBJ"},
      {VERTICES "cstype bspline\nsurf 0 1 0 1 1 2 3 4\nf 1 2 3\n",
       "a.obj:6: surf: a free-form surface"},
      {VERTICES "bzp 1 2 3 4\n", "bzp: a Bezier patch"},
      {VERTICES "call b.obj\n", "call: another file"},
      {VERTICES "csh ls\n", "csh: a command of a shell"},
      {"v 1 2\n", "a.obj:1: a vertex of 2 numbers"},
      {"v 1 2 3 4 5\n", "a vertex of 5 numbers"},
      {"v 0,5 1 2\n", "a.obj:1: '0,5' is no finite number"},
      {"v 1 2 nan\n", "'nan' is no finite number"},
      {"v 1 2 1e400\n", "'1e400' is no finite number"},
      {"v 1 2 0x10\n", "'0x10' is no finite number"},
      {VERTICES "f 1 2 3 \\\nf 2 3 4\n", "a.obj:6: 'f' is no corner of a face"},
      {VERTICES "# C:\\parts\\\nf 1 2 3\n",
       "a.obj:5: the backslash at its end makes 'f' of the next line a part of this one"},
      {VERTICES "f 1 2 3\nvn 0 0 1 \\\n 0 \\\r\n  v 0 0 0\n",
       "a.obj:7: the backslash at its end makes 'v'"},
      {VERTICES, "no triangles"},
      {VERTICES "l 1 2\n", "no triangles"},
      {"v 0 0 0\nv 2 2 0\nv 2 0 0\nv 0 2 0\nf 1 2 3 4\n", "a.obj:5: face 0: a polygon of 4 corners "
                                                          "crosses itself"},
  };
  for (size_t n = 0; n < sizeof row / sizeof row[0]; n++) {
    refuse(row[n][0], row[n][1]);
  }
  static const char zero[] = VERTICES "g a\0b\nf 1 2 3\n";
  sepax_soup none;
  const char *file = put_bytes("a.obj", zero, sizeof zero - 1);
  assert_fault(sepax_mesh_read(&none, NULL, file, NULL, &fault), "a byte of zero at offset 35");
  file = put_bytes("a.mesh", zero, sizeof zero - 1);
  assert_fault(sepax_mesh_read(&none, NULL, file, NULL, &fault),
               "a.mesh: not a mesh that can be read");
}

/* A polygon that crosses itself is a fan of its first corner, if the caller wants that; all others
 * are divided as ever. The second side of a face begins at its own first corner. */
CASE(polygons_as_fans) {
  static const char text[] = "v 0 0 0\nv 2 2 0\nv 2 0 0\nv 0 2 0\nv 2 1 0\n"
                             "f 1 2 3 4\nf 2 1 4 3\nf 1 3 5 4\nf 3 5 1 4\nf 5 1 4 3\n";
  const sepax_mesh_reading how = SEPAX_STRUCT(sepax_mesh_reading, .fans = true);
  sepax_soup_free(&soup);
  assert_works(sepax_mesh_read(&soup, &account, put_file("a.obj", text), &how, &fault));
  assert_int_equal(account.divided, 5);
  assert_int_equal(account.fans, 4);
  TRIANGLE(0, 0, 0, 0, 2, 2, 0, 2, 0, 0);
  TRIANGLE(1, 0, 0, 0, 2, 0, 0, 0, 2, 0);
  TRIANGLE(2, 0, 2, 0, 2, 0, 0, 2, 2, 0);
  TRIANGLE(3, 0, 0, 0, 0, 2, 0, 2, 2, 0);
  TRIANGLE(4, 0, 0, 0, 2, 0, 0, 2, 1, 0);
  TRIANGLE(6, 2, 0, 0, 2, 1, 0, 0, 0, 0);
  TRIANGLE(7, 2, 0, 0, 0, 0, 0, 0, 2, 0);
  TRIANGLE(8, 2, 1, 0, 0, 0, 0, 0, 2, 0);
  sepax_soup_free(&soup);
  assert_fault(sepax_mesh_read(&soup, &account, put_file("a.obj", text), NULL, &fault),
               "a.obj:6: face 0: a polygon of 4 corners crosses itself; export triangles, or give "
               "--polygons=fan");
}
