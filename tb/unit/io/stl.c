/* SPDX-License-Identifier: MIT */
/* stl.c - STL through the door of the mesh readers: which of the two kinds, what is named, what is
 * refused. tb/unit/stl.c has the forms of numbers and words. */
#include "unit/io/reading.h"

#include <math.h>

#define FACET(number)                                                                   \
  "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex " number " 0 0\nvertex 0 1 0\n" \
  "endloop\nendfacet\n"
#define SOLID(number) "solid part\n" FACET(number) "endsolid part\n"

static void read_bytes(const char *name, const char *bytes, size_t size, size_t facets) {
  sepax_soup_free(&soup);
  const char *file = put_bytes(name, bytes, size);
  assert_works(sepax_mesh_read(&soup, &account, file, NULL, &fault));
  assert_string_equal(account.format, "STL");
  assert_string_equal(account.unit, "");
  assert_true(account.unit_mm == 0);
  assert_int_equal(account.faces, facets);
  assert_int_equal(account.triangles, facets);
  assert_int_equal(soup.count, facets);
  assert_int_equal(account.divided, 0);
}

static void read_text(const char *text, size_t facets) {
  read_bytes("a.stl", text, strlen(text), facets);
  assert_int_equal(account.others, 0);
}

static void refuse_bytes(const char *name, const char *bytes, size_t size, const char *part) {
  sepax_soup none;
  const char *file = put_bytes(name, bytes, size);
  assert_fault(sepax_mesh_read(&none, NULL, file, NULL, &fault), part);
  assert_message(name);
}

static void refuse(const char *text, const char *part) {
  refuse_bytes("a.stl", text, strlen(text), part);
}

/* Each facet is counted twice, by code of its own: also in capitals, without lines, or where names
 * have words of the format in them. */
CASE(texts) {
  read_text(SOLID("1"), 1);
  TRIANGLE(0, 0, 0, 0, 1, 0, 0, 0, 1, 0);
  read_text("\xef\xbb\xbf \r\n" SOLID("0.1") "solid facet\n" FACET("1e23") "endsolid facet\n", 2);
  TRIANGLE(0, 0, 0, 0, 0.1, 0, 0, 0, 1, 0);
  TRIANGLE(1, 0, 0, 0, 1e23, 0, 0, 0, 1, 0);
  read_text("SOLID X\r\nFACET NORMAL NAN NAN NAN OUTER LOOP VERTEX 1 2 3 VERTEX 4 5 6 VERTEX 7 8 9 "
            "ENDLOOP ENDFACET Facet normal 0 0 0 outer loop vertex 1 2 3\rvertex 4 5 6\rvertex 7 8 "
            "10 endloop EndFacet ENDSOLID",
            2);
  TRIANGLE(0, 1, 2, 3, 4, 5, 6, 7, 8, 9);
  TRIANGLE(1, 1, 2, 3, 4, 5, 6, 7, 8, 10);
  read_text("solid endfacets, bendfacet\n" FACET("1") "endsolid\n\x1a", 1);
}

CASE(refused_texts) {
  static const char *const row[][2] = {
      {"", "a.stl: the file is empty"},
      {"solid\n" FACET("1"), "a.stl:9: the text ends before facet or endsolid: truncated"},
      {"solid\nfacet normal 0 0 1\ncolor 1 0 0\n", "a.stl:3: 'color' where outer is expected"},
      {"solid\n# made by hand\n" FACET("1"), "a.stl:2: '#' where facet or endsolid is expected"},
      {"solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\n"
       "vertex 0 1 0\nendloop\nendfacet\nendsolid\n",
       "a.stl:7: 'vertex' where endloop is expected"},
      {SOLID("0,5"), "a.stl:5: '0,5' where a number is expected"},
      {SOLID("nan"), "a.stl:5: coordinate is NaN"},
      {SOLID("1e302"), "a.stl: triangle 0: a coordinate is beyond 2^1000"},
      {"solid a facet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop "
       "EndFacet\n" FACET("1") "endsolid\n",
       "a.stl:1: a facet in the line of a solid's name; export"},
      {SOLID("1") "endsolid", "a.stl:10: 'endsolid' where solid is expected"},
      {"solid\nendsolid a solid b facet normal 0 0 1 endfacet endsolid\n" SOLID("1"),
       "a.stl:2: a facet in the line of a solid's name"},
      {"solid\nendsolid\n", "a.stl: no facets"},
  };
  for (size_t n = 0; n < LENGTH(row); n++) {
    refuse(row[n][0], row[n][1]);
  }
}

/* ------------------------------------------------------------------------- binary */

enum { FACETS = 3, SIZE = 84 + 50 * FACETS };
static char binary[SIZE + 1];

static void put_float(size_t facet, int number, float value) {
  memcpy(binary + 84 + 50 * facet + (size_t)(4 * number), &value, sizeof value);
}

/* This computer is little-endian. Coordinate i of facet n is 10 n + i / 2. */
static void make_binary(const char *title) {
  memset(binary, 0, sizeof binary);
  for (size_t n = 0; title[n] != '\0'; n++) {
    binary[n] = title[n];
  }
  binary[80] = FACETS;
  for (size_t n = 0; n < FACETS; n++) {
    for (int i = 0; i < 9; i++) {
      put_float(n, 3 + i, (float)n * 10 + (float)i / 2);
    }
  }
}

/* A binary file is one by its size, however its title begins and whatever its name is. */
CASE(binaries) {
  static const char *const titles[] = {"", "solid part", "v 0 0 0\nf 1 2 3", "<?xml", "COLOR=\xff"};
  static const char *const names[] = {"a.stl", "a.obj", "a.ply", "a"};
  for (size_t n = 0; n < LENGTH(titles) * LENGTH(names); n++) {
    make_binary(titles[n / LENGTH(names)]);
    put_float(1, 0, NAN); /* a normal */
    read_bytes(names[n % LENGTH(names)], binary, SIZE, FACETS);
    TRIANGLE(0, 0, 0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4);
    TRIANGLE(2, 20, 20.5, 21, 21.5, 22, 22.5, 23, 23.5, 24);
    assert_int_equal(account.others, 0);
  }
  memset(binary, ' ', 80); /* no zero before the count */
  for (size_t n = 0; n < 5; n++) {
    binary[n] = "solid"[n];
  }
  read_bytes("a.stl", binary, SIZE, FACETS);
}

/* Colours in the last two bytes of two facets. */
CASE(attributes) {
  make_binary("");
  binary[84 + 48] = 1;
  binary[84 + 50 + 50 + 49] = '\x80';
  read_bytes("a.stl", binary, SIZE, FACETS);
  assert_int_equal(account.others, 1);
  assert_string_equal(account.other[0].what, "facet attributes");
  assert_int_equal(account.other[0].count, 2);
}

CASE(refused_binaries) {
  static const char *const titles[] = {"", "solid", "Exported by hand", "v 0 0 0"};
  for (size_t n = 0; n < LENGTH(titles); n++) {
    make_binary(titles[n]);
    refuse_bytes("a.stl", binary, SIZE - 1, "truncated: 3 facets take 234 bytes, the file has 233");
    refuse_bytes("a.stl", binary, SIZE + 1, "longer than its count says: 3 facets take 234 bytes");
    memset(binary + 80, 0xff, 4);
    refuse_bytes("a.stl", binary, SIZE, "truncated: 4294967295 facets take 214748364834 bytes");
  }
  make_binary("");
  put_float(2, 5, INFINITY);
  refuse_bytes("a.stl", binary, SIZE, "facet 2: coordinate is infinite");
  make_binary("");
  sepax_soup none;
  const sepax_mesh_reading how = SEPAX_STRUCT(sepax_mesh_reading, .most = FACETS - 1);
  assert_fault(sepax_mesh_read(&none, NULL, put_bytes("a.stl", binary, SIZE), &how, &fault),
               "more than 2 triangles; simplify");
  assert_int_equal(fault.code, SEPAX_ERROR_LIMIT);
}
