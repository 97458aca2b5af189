/* SPDX-License-Identifier: MIT */
/* ply.c - PLY: texts and both orders of bytes, what is named, what is refused with line or offset.
 */
#include "unit/io/reading.h"

#include <math.h>

#define FORMAT "ply\nformat ascii 1.0\n"
#define XYZ "property double x\nproperty double y\nproperty double z\n"
#define FACES(n) "element face " n "\nproperty list uchar int vertex_indices\n"
#define HEAD(faces) FORMAT "element vertex 4\n" XYZ FACES(faces) "end_header\n"
#define ROWS "0 0 0\n1 0 0\n0 2 0\n0 0 3\n"

static void read_bytes(const char *bytes, size_t size, size_t faces, size_t triangles) {
  sepax_soup_free(&soup);
  const char *file = put_bytes("a.ply", bytes, size);
  assert_works(sepax_mesh_read(&soup, &account, file, NULL, &fault));
  assert_string_equal(account.format, "PLY");
  assert_int_equal(account.faces, faces);
  assert_int_equal(soup.count, triangles);
}

static void read_text(const char *text, size_t faces, size_t triangles) {
  read_bytes(text, strlen(text), faces, triangles);
}

static void refuse_file(const char *bytes, size_t size, const char *part) {
  sepax_soup none;
  const char *file = put_bytes("a.ply", bytes, size);
  assert_fault(sepax_mesh_read(&none, NULL, file, NULL, &fault), part);
  assert_message("a.ply");
}

static void refuse(const char *text, const char *part) { refuse_file(text, strlen(text), part); }

CASE(texts) {
  read_text(HEAD("2") ROWS "3 0 1 2\n3 1 2 3\n", 2, 2);
  TRIANGLE(0, 0, 0, 0, 1, 0, 0, 0, 2, 0);
  TRIANGLE(1, 1, 0, 0, 0, 2, 0, 0, 0, 3);
  read_text(HEAD("1") ROWS "4 0 1 2 3", 1, 2);
  assert_int_equal(account.divided, 1);
  assert_int_equal(account.bent, 1);
  /* Rows behind empty lines; lines that end as on other systems. */
  read_text(HEAD("1") "\n" ROWS "\n  3 0 1 2 \n\n", 1, 1);
  read_text("ply\r\nformat ascii 1.0\r\ncomment x\r\nobj_info y\r\nelement vertex 3\r\n"
            "property float x\r\nproperty float y\r\nproperty float z\r\nelement face 1\r\n"
            "property list uchar int vertex_index\r\nend_header\r\n0 0 0\r\n1 0 0\r\n0 0.1 0\r\n"
            "3 0 1 2\r\n",
            1, 1);
  TRIANGLE(0, 0, 0, 0, 1, 0, 0, 0, 0.1, 0); /* a decimal is a double, whatever its type */
}

/* Faces in front of the vertices, properties in any order and between. */
CASE(orders) {
  /* A head with blanks before its words and a comment that names its end; a mark of UTF-8. */
  read_text("ply \n\tformat  ascii 1.0\ncomment end_header\nobj_info element face 7\n"
            " element vertex 4\n" XYZ "\telement\tface 1 \n"
            "property list uchar int vertex_indices\n end_header \n" ROWS "3 0 1 2\n",
            1, 1);
  read_text("\xef\xbb\xbf" HEAD("1") ROWS "3 0 1 2\n", 1, 1);
  read_text(FORMAT FACES("1") "element vertex 3\nproperty int z\nproperty float q\n"
                              "property list uchar float w\nproperty short y\nproperty double x\n"
                              "end_header\n3 0 1 2\n1 nan 0 2 3\n4 0 2 1 1 5 6\n7 0 1 9 8 9\n",
            1, 1);
  TRIANGLE(0, 3, 2, 1, 6, 5, 4, 9, 8, 7);
  assert_int_equal(others("sets of vertex properties: q w"), 3);
}

CASE(what_has_no_surface) {
  read_text(FORMAT
            "element camera 1\nproperty float view\nproperty list uchar float ids\n"
            "element vertex 4\n" XYZ "property uchar red\n" FACES(
                "1") "property uchar flags\nelement edge 2\nproperty int vertex1\n"
                     "property int vertex2\nend_header\n0.5 2 7 8\n0 0 0 1\n1 0 0 1\n0 2 0 1\n"
                     "0 0 3 1\n3 0 1 2 255\n0 1\n1 2\n",
            1, 1);
  assert_int_equal(others("elements 'camera'"), 1);
  assert_int_equal(others("edges"), 2);
  assert_int_equal(others("sets of vertex properties: red"), 4);
  assert_int_equal(others("sets of face properties: flags"), 1);
  assert_int_equal(account.others, 4);
}

CASE(strips) {
  read_text(FORMAT "element vertex 4\n" XYZ "element tristrips 2\n"
                   "property list int int vertex_indices\nend_header\n" ROWS
                   "8 0 1 2 3 -1 0 1 2\n6 0 1 2 2 3 0\n",
            2, 5);
  TRIANGLE(0, 0, 0, 0, 1, 0, 0, 0, 2, 0);
  TRIANGLE(1, 0, 2, 0, 1, 0, 0, 0, 0, 3); /* wound as the first */
  TRIANGLE(2, 0, 0, 0, 1, 0, 0, 0, 2, 0);
  TRIANGLE(4, 0, 0, 3, 0, 2, 0, 0, 0, 0);
  assert_int_equal(others("triangles of strips with a corner twice"), 2);
}

/* ------------------------------------------------------------------------- binary */

static char made[1024];
static size_t size;

static void put_text(const char *text) { size = (size_t)snprintf(made, sizeof made, "%s", text); }

static void put_number(const void *number, size_t bytes, bool big) {
  for (size_t n = 0; n < bytes; n++) {
    made[size++] = ((const char *)number)[big ? bytes - 1 - n : n];
  }
}

#define PUT(type, value)                     \
  do {                                       \
    type number = (value);                   \
    put_number(&number, sizeof number, big); \
  } while (0)

/* A row of each type: x, y, z and what is between. This computer is little-endian. */
static void put_binary(bool big, const char *ends) {
  char head[512];
  snprintf(head, sizeof head,
           "ply%sformat binary_%s_endian 1.0%selement vertex 3%sproperty double x%s"
           "property float y%sproperty short z%sproperty list ushort char s%selement face 2%s"
           "property uchar flags%sproperty list uchar uint vertex_indices%send_header%s",
           ends, big ? "big" : "little", ends, ends, ends, ends, ends, ends, ends, ends, ends,
           ends);
  put_text(head);
  for (int n = 0; n < 3; n++) {
    PUT(double, n == 1 ? 0.1 : 0);
    PUT(float, n == 2 ? 1.5F : 0);
    PUT(int16_t, (int16_t)-n);
    PUT(uint16_t, (uint16_t)n);
    for (int k = 0; k < n; k++) {
      PUT(int8_t, 10); /* as the end of a line */
    }
  }
  for (uint32_t n = 0; n < 2; n++) {
    PUT(uint8_t, 10);
    PUT(uint8_t, 3);
    PUT(uint32_t, n);
    PUT(uint32_t, 1 - n);
    PUT(uint32_t, 2);
  }
}

CASE(binaries) {
  static const char *const ends[] = {"\n", "\r\n", "\r"};
  for (int way = 0; way < 6; way++) {
    put_binary(way % 2 == 1, ends[way / 2]);
    read_bytes(made, size, 2, 2);
    TRIANGLE(0, 0, 0, 0, 0.1, 0, -1, 0, 1.5, -2);
    TRIANGLE(1, 0.1, 0, -1, 0, 0, 0, 0, 1.5, -2);
    for (size_t less = 1; less <= 79; less++) {
      refuse_file(made, size - less, "truncated");
    }
    made[size] = '\n';
    refuse_file(made, size + 1, "more data after the last element than the head declares");
    made[size - 1] = made[size - 4] = 9; /* the last index, in either order */
    refuse_file(made, size, "element face, row 1: there is no vertex");
  }
}

/* ------------------------------------------------------------------------ refused */

CASE(heads) {
  static const char *const row[][2] = {
      {"poly\nformat ascii 1.0\n", "a.ply:1: 'poly' where the head has ply"},
      {"ply 1\nformat ascii 1.0\n", "a.ply:1: '1' where the head has the end of a line"},
      {"", "a.ply:1: '' where the head has ply"},
      {"ply", "a.ply:1: truncated: no end_header"},
      {"ply\nformat ascii 2.0\n", "a.ply:2: '2.0' where the head has 1.0"},
      {"ply\nformat binary 1.0\n", "'binary' where the head has ascii, binary_little_endian"},
      {"ply\nelement vertex -1\n", "'-1' where the head has how many there are"},
      {"ply\nelement vertex 1x\n", "'1x' where the head has how many there are"},
      {"ply\nelement g\xc3\xb6\x01 1\n", "a.ply:2: 'g\?\?\?' where the head has a name of up to"},
      {"ply\nelement a234567890123456789012345678901234567890 1\n", "has a name of up to 39"},
      {"ply\nelement vertex\n", "'' where the head has how many there are"},
      {"ply\nproperty float x\n", "an element before its properties"},
      {FORMAT "element vertex 1\nproperty real x\n", "'real' where the head has a type"},
      {FORMAT "element vertex 1\nproperty list float int x\n", "a length that is no integer"},
      {FORMAT "element vertex 1\nproperty float x y\n", "'y' where the head has the end of a line"},
      {FORMAT "element vertex 1\nproperty float x\nproperty float x\n", "a second property 'x'"},
      {FORMAT "element vertex 1\nelement vertex 1\n", "a second element 'vertex'"},
      {FORMAT "elephant vertex 1\n", "'elephant' where the head has format, comment, element"},
      {FORMAT "element vertex 1\n", "truncated: no end_header"},
      {"ply\nend_header\n", "its head has no format"},
      {FORMAT "end_header\n", "it has no element face; give a mesh with faces"},
      {FORMAT "element vertex 1\n" XYZ "end_header\n0 0 0\n", "it has no element face"},
      {FORMAT FACES("1") "end_header\n", "it has no element vertex"},
      {FORMAT "element vertex 1\nproperty float x\n" FACES("1") "end_header\n",
       "element vertex has no property y"},
      {FORMAT "element vertex 1\n" XYZ
              "element face 1\nproperty list uchar float ids\nend_header\n",
       "element face has no list vertex_indices of integers"},
      {FORMAT "element vertex 1\n" XYZ "element face 1\n"
              "property list uchar float vertex_indices\nend_header\n",
       "element face has no list vertex_indices of integers"},
      {FORMAT "element vertex 1\n" XYZ "element face 1\nproperty list uchar int vertex_indices\n"
              "property list uchar int vertex_index\nend_header\n0 0 0\n",
       "element 'face' may refer to vertices by its list 'vertex_index'"},
      {FORMAT "element vertex 1\n" XYZ FACES("0") "element patch 1\n"
                                                  "property list uchar int corner\nend_header\n",
       "element 'patch' may refer to vertices by its list 'corner'"},
      {FORMAT "element vertex 1\n" XYZ "element range_grid 1\n"
              "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0\n",
       "element 'range_grid' may refer to vertices by its list 'vertex_indices', which"},
      {FORMAT "element vertex 1\n" XYZ FACES("1") "element quad 1\n"
                                                  "property list uchar int verts\nend_header\n",
       "element 'quad' may refer to vertices by its list 'verts'"},
      {FORMAT "element vertex 1\n" XYZ FACES("1") "element fan 1\n"
                                                  "property list uchar int indices\nend_header\n",
       "element 'fan' may refer to vertices by its list 'indices'"},
      {FORMAT "element vertex 1\n" XYZ "element odd 9999999999\n" FACES("1") "end_header\n",
       "element 'odd' has no properties"},
  };
  for (size_t n = 0; n < sizeof row / sizeof row[0]; n++) {
    refuse(row[n][0], row[n][1]);
  }
  static const char zero[] = FORMAT "element face\0x 1\n";
  refuse_file(zero, sizeof zero - 1, "a.ply:3: 'face?x' where the head has a name");
}

CASE(rows) {
  static const char *const row[][2] = {
      {HEAD("1") ROWS "3 0 1 4\n", "a.ply:14: element face, row 0: there is no vertex 4, of 4"},
      {HEAD("1") ROWS "3 0 1 -1\n", "there is no vertex -1, of 4"},
      {HEAD("1") ROWS "3 0 1 1.5\n", "there is no vertex 1.5, of 4"},
      {HEAD("1") ROWS "2 0 1\n", "a face of fewer than three corners"},
      {HEAD("1") ROWS "3 0 1\n", "truncated: fewer numbers than properties"},
      {HEAD("1") ROWS "3 0 1 2 3\n", "a.ply:14: element face, row 0: more numbers than"},
      {HEAD("2") ROWS "3 0 1 2\n", "element face, row 1: truncated"},
      {HEAD("1") ROWS "3 0 1 2\n3 0 1 2\n", "more data after the last element"},
      {HEAD("99999999999") ROWS "3 0 1 2\n", "element face, row 1: truncated"},
      {HEAD("1") ROWS "1000000 0 1 2\n", "a list is longer than the numbers that follow"},
      {HEAD("1") ROWS "-3 0 1 2\n", "a list whose length is no whole number"},
      {HEAD("1") ROWS "2.5 0 1 2\n", "a list whose length is no whole number"},
      {HEAD("1") "0 0 nan\n1 0 0\n0 2 0\n0 0 3\n3 0 1 2\n", "triangle 0: a coordinate is NaN"},
      {HEAD("1") "0 0 0,5\n1 0 0\n0 2 0\n0 0 3\n3 0 1 2\n", "a.ply:10: '0,5' is no number"},
      {FORMAT "element vertex 3\nproperty uchar x\nproperty uchar y\nproperty int z\n" FACES(
           "1") "end_header\n0 0 0\n0 300 0\n0 0 3\n3 0 1 2\n",
       "element vertex, row 1: a number that its type does not have"},
      {FORMAT "element vertex 3\nproperty uchar x\nproperty uchar y\nproperty int z\n" FACES(
           "1") "end_header\n0 0 0\n0 30 0\n0 0 0.5\n3 0 1 2\n",
       "element vertex, row 2: a number that its type does not have"},
      {HEAD("1") "0 0\n1 0 0\n0 2 0\n0 0 3\n3 0 1 2\n", "element vertex, row 0: truncated: fewer"},
  };
  for (size_t n = 0; n < sizeof row / sizeof row[0]; n++) {
    refuse(row[n][0], row[n][1]);
  }
  /* A vertex that is none does no harm where no face has it. */
  read_text(HEAD("1") "0 0 0\n1 0 0\n0 2 0\nnan -inf 0\n3 0 1 2\n", 1, 1);
}
