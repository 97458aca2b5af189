/* SPDX-License-Identifier: MIT */
/* stl.c - STL files: reading, writing, real meshes. */
#include "harness.h"

#include <dirent.h>
#include <float.h>
#include <locale.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

static int files_in_folder(void) {
  int count = 0;
  DIR *dir = opendir(folder);
  assert_non_null(dir);
  while (readdir(dir) != NULL) {
    count++;
  }
  closedir(dir);
  return count - 2; /* without . and .. */
}

static void put_bytes(const void *bytes, size_t size) {
  FILE *out = fopen(path, "wb");
  assert_non_null(out);
  assert_int_equal(fwrite(bytes, 1, size, out), size);
  assert_int_equal(fclose(out), 0);
}

static size_t get_bytes(char *bytes, size_t size) {
  FILE *in = fopen(path, "rb");
  assert_non_null(in);
  size_t got = fread(bytes, 1, size, in);
  fclose(in);
  return got;
}

static void assert_refused(const char *part) {
  sepax_soup mesh = {.count = 77};
  assert_fault(sepax_stl_read(&mesh, path, true, &fault), part);
  assert_message(path);
  assert_null(mesh.facet);
  assert_int_equal(mesh.count, 0);
}

static void refuse_bytes(const void *bytes, size_t size, const char *part) {
  put_bytes(bytes, size);
  assert_refused(part);
  remove(path);
}

static sepax_soup read_text(const char *text) {
  put_bytes(text, strlen(text));
  sepax_soup mesh = read_mesh();
  remove(path);
  return mesh;
}

/* ----------------------------------------------------------------- STL files */

#define FACET(number)                                                              \
  " facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex " number " 0 0\n" \
  "   vertex 0 1 0\n  endloop\n endfacet\n"
#define SOLID(number) "solid part\n" FACET(number) "endsolid part\n"

static double number_read(const char *text) {
  char solid[2048];
  snprintf(solid, sizeof solid, SOLID("%s"), text);
  sepax_soup mesh = read_text(solid);
  double number = mesh.facet[0].v[1][0];
  sepax_soup_free(&mesh);
  assert_null(mesh.facet);
  assert_int_equal(mesh.count, 0);
  return number;
}

CASE(test_decimals) {
  const struct {
    const char *text;
    double number;
  } cases[] = {
      {"0", 0},
      {"-1.5E+1", -15},
      {"+.5", 0.5},
      {"7.", 7},
      {"0.1", 0x1.999999999999ap-4},
      {"1e23", 0x1.52d02c7e14af6p+76},
      {"9007199254740993", 0x1p53},
      {"9007199254740993.00000000000000000001", 0x1.0000000000001p53},
      {"1.00000000000000011102230246251565404236316680908203125", 1},
      {"1.00000000000000011102230246251565404236316680908203126", 1 + DBL_EPSILON},
      {"2.2250738585072011e-308", 0x0.fffffffffffffp-1022},
      {"1.7976931348623158e308", DBL_MAX},
      {"4.9e-324", 0x1p-1074},
      {"1e-400", 0},
  };
  for (size_t i = 0; i < LENGTH(cases); i++) {
    double number = number_read(cases[i].text);
    if (number < cases[i].number || number > cases[i].number) {
      fail_msg("%s read as %a", cases[i].text, number);
    }
  }
}

CASE(test_text_forms) {
  const struct {
    const char *text;
    size_t count;
  } cases[] = {
      {SOLID("1"), 1},
      {" \t\r\nSOLID\nFACET NORMAL 0 0 1 OUTER LOOP VERTEX 0 0 0 Vertex 1 0 0 vertex 0 "
       "1 0"
       " endLoop EndFacet ENDSOLID",
       1},
      {"solid a\r\n" FACET("1\r") "endsolid a\r\n", 1},
      {"solid a\rfacet normal 0 0 1\router loop\rvertex 0 0 0\rvertex 1 0 0\rvertex 0 "
       "1 0"
       "\rendloop\rendfacet\rendsolid a\r",
       1},
      {SOLID("1") "\n\n" SOLID("2") "solid empty\nendsolid\n", 2},
      {"solid facet normal \xff\xfe endsolid\n" FACET("1") FACET("2")
           FACET("3") "endsolid so it was, facet\n",
       3},
  };
  for (size_t i = 0; i < LENGTH(cases); i++) {
    sepax_soup mesh = read_text(cases[i].text);
    assert_int_equal(mesh.count, cases[i].count);
    for (size_t k = 0; k < mesh.count; k++) {
      const sepax_facet *f = &mesh.facet[k];
      assert_true(mesh.normal[k][0] == 0 && mesh.normal[k][1] == 0 && mesh.normal[k][2] == 1);
      assert_true(f->v[1][0] == (double)(k + 1) && f->v[2][1] == 1 && f->v[0][2] == 0);
    }
    sepax_soup_free(&mesh);
  }
}

CASE(test_text_errors) {
  static const char *const row[][2] = {
      {"", "empty"},
      {"hello", "not an STL file"},
      {"<html>This is a page of text, and so long that it might have the head of a "
       "binary file in it.</html>",
       "neither 'solid' nor a binary header"},
      {"solid\nendsolid\n", "no facets"},
      {"solidify\n", ".stl:1: 'solidify' where solid is expected"},
      {"solid a\n", ".stl:2: the text ends before facet or endsolid: truncated"},
      {"solid a\n" FACET("1"), ".stl:9: the text ends before"},
      {"solid a\n facet normal 0 0", ".stl:2: the text ends before a number"},
      {"solid a\n facet normal 0 0 1\n outer\r\n poop\n", ".stl:4: 'poop' where loop"},
      {"solid a\r\r facet abnormal", ".stl:3: 'abnormal' where normal"},
      {SOLID("1") "rubbish", ".stl:10: 'rubbish' where solid"},
      {SOLID("1,5"), ".stl:5: '1,5' where a number"},
      {SOLID("0x10"), ".stl:5: '0x10' where a number"},
      {SOLID("1.#QNAN"), ".stl:5: '1.#QNAN' where a number"},
      {SOLID("1 2"), ".stl:5: '0' where vertex"},
      {SOLID("nan"), ".stl:5: coordinate is NaN; export"},
      {SOLID("-inf"), ".stl:5: coordinate is infinite"},
      {SOLID("1e309"), ".stl:5: coordinate is infinite"},
      {"solid a\nfacet normal 0 nan 0", ".stl:2: normal is NaN"},
      {"solid a\nfacet\033normal\x80zero 0 nan 0",
       ".stl:2: 'facet?normal?zero' where facet or endsolid"},
      {"solid a\na_word_of_more_than_twenty_four_characters", "'a_word_of_more_than_twen' where"}};
  for (size_t i = 0; i < LENGTH(row); i++) {
    refuse_bytes(row[i][0], strlen(row[i][0]), row[i][1]);
  }
  const char with_zero[] = SOLID("1\0");
  refuse_bytes(with_zero, sizeof with_zero - 1, "not an STL file");
}

/* A binary file of `count` facets, all numbers 1, with space for what a case appends. */
static size_t make_binary(unsigned char bytes[], const char *title, unsigned count) {
  memset(bytes, 0, 84 + 50 * (size_t)count);
  for (size_t i = 0; title[i] != '\0'; i++) {
    bytes[i] = (unsigned char)title[i];
  }
  bytes[80] = (unsigned char)count;
  for (size_t i = 0; i < 12 * (size_t)count; i++) {
    unsigned char *number = bytes + 84 + 50 * (i / 12) + 4 * (i % 12);
    number[2] = 0x80;
    number[3] = 0x3f;
  }
  return 84 + 50 * (size_t)count;
}

CASE(test_binary_forms) {
  const char *titles[] = {"", "solid", "solid part\n facet normal 0 0 1", "COLOR=\xff"};
  unsigned char bytes[500];
  for (size_t i = 0; i < LENGTH(titles); i++) {
    size_t size = make_binary(bytes, titles[i], 3);
    bytes[84 + 50 + 12 + 3] = 0xbf; /* facet 1, vertex 0, x: -1 */
    bytes[84 + 50 + 48] = 0xff;     /* attributes */
    put_bytes(bytes, size);
    sepax_soup mesh = read_mesh();
    remove(path);
    assert_int_equal(mesh.count, 3);
    assert_true(mesh.facet[1].v[0][0] == -1 && mesh.normal[1][2] == 1);
    assert_true(mesh.facet[2].v[2][2] == 1 && mesh.normal[2][0] == 1);
    sepax_soup_free(&mesh);
  }
}

CASE(test_binary_errors) {
  unsigned char bytes[500];
  size_t size = make_binary(bytes, "solid", 3);
  refuse_bytes(bytes, size - 1, "truncated: 3 facets take 234 bytes, the file has 233");
  refuse_bytes(bytes, 84, "truncated");
  refuse_bytes(bytes, 83, "not an STL file");
  bytes[size] = 0;
  refuse_bytes(bytes, size + 1, "longer than its count says");
  bytes[80 + 1] = 0xff;
  refuse_bytes(bytes, size, "truncated: 65283 facets");
  memset(bytes + 80, 0xff, 4);
  refuse_bytes(bytes, size, "truncated: 4294967295 facets take 214748364834 bytes");
  size = make_binary(bytes, "x", 0);
  refuse_bytes(bytes, size, "no facets");
  size = make_binary(bytes, "x", 3);
  bytes[84 + 100 + 44 + 3] = 0x7f;
  bytes[84 + 100 + 44 + 2] = 0x80;
  refuse_bytes(bytes, size, "facet 2: coordinate is infinite; export");
  bytes[84 + 50 + 3] = 0xff;
  bytes[84 + 50 + 2] = 0xc0;
  refuse_bytes(bytes, size, "facet 1: normal is NaN; export");
}

CASE(test_unreadable) {
  assert_refused("No such file");
  assert_int_equal(mkdir(path, 0777), 0);
  assert_refused("is a directory");
  assert_int_equal(rmdir(path), 0);
  assert_int_equal(symlink("/dev/null", path), 0);
  assert_refused("neither a file nor a pipe");
  remove(path);
  put_bytes(SOLID("1"), strlen(SOLID("1")));
  assert_int_equal(chmod(path, 0), 0);
  if (geteuid() != 0) {
    assert_refused("Permission denied");
  }
  remove(path);
  char far[700];
  memset(far, 'x', sizeof far - 1);
  far[sizeof far - 1] = '\0';
  sepax_soup mesh = {0};
  assert_fault(sepax_stl_read(&mesh, far, false, &fault), "check the path");
}

/* Normals are checked where they are asked for, and else are any words, or any bits. */
CASE(test_normals_that_are_none) {
  unsigned char bytes[500];
  sepax_soup mesh;
  static const char text[] = "solid\nfacet normal nan -nan(ind) 1.#IND\nouter loop\nvertex 1 2 3\n"
                             "vertex 4 5 6\nvertex 7 8 10\nendloop\nendfacet\nendsolid\n";
  put_bytes(text, strlen(text));
  assert_works(sepax_stl_read(&mesh, path, false, &fault));
  assert_true(mesh.count == 1 && mesh.facet[0].v[2][2] == 10);
  sepax_soup_free(&mesh);
  assert_refused(".stl:2: normal is NaN");
  refuse_bytes("solid\nfacet normal 0 0 outer loop\n", 34, ".stl:2: 'outer' where a number");
  size_t size = make_binary(bytes, "x", 3);
  bytes[84 + 50 + 3] = 0xff;
  bytes[84 + 50 + 2] = 0xc0;
  put_bytes(bytes, size);
  assert_works(sepax_stl_read(&mesh, path, false, &fault));
  assert_int_equal(mesh.count, 3);
  sepax_soup_free(&mesh);
  assert_refused("facet 1: normal is NaN; export");
}

/* A mark of UTF-8 before the text; zeros or Ctrl-Z behind it, as old systems fill their blocks. */
CASE(test_marks_and_padding) {
  static const char *const text[] = {"\xef\xbb\xbf" SOLID("1"), SOLID("1") "\x1a",
                                     SOLID("1") "\n\x1a\x1a \n"};
  sepax_soup mesh;
  for (size_t n = 0; n < LENGTH(text); n++) {
    put_bytes(text[n], strlen(text[n]));
    assert_works(sepax_stl_read(&mesh, path, false, &fault));
    assert_int_equal(mesh.count, 1);
    sepax_soup_free(&mesh);
  }
  static const char padded[] = SOLID("1") "\0\0\0";
  put_bytes(padded, sizeof padded);
  assert_works(sepax_stl_read(&mesh, path, false, &fault));
  sepax_soup_free(&mesh);
  refuse_bytes(SOLID("1") "\x1a" SOLID("1"), 2 * strlen(SOLID("1")) + 1, "where solid is expected");
}

/* A program that took over a language with a decimal comma reads and writes the same files. */
CASE(test_decimal_comma) {
  char command[3 * PATH_BYTES + 100];
  snprintf(command, sizeof command,
           "localedef -i de_DE -f UTF-8 %s/de_DE.UTF-8 > %s/log 2>&1; rm %s/log", folder, folder,
           folder);
  setenv("LOCPATH", folder, 1);
  bool made = system(command) == 0 && setlocale(LC_ALL, "de_DE.UTF-8") != NULL &&
              strcmp(localeconv()->decimal_point, ",") == 0;
  sepax_soup mesh = {0};
  if (made) {
    put_bytes(SOLID("1.5"), strlen(SOLID("1.5")));
    mesh = read_mesh();
    assert_works(sepax_stl_write(&mesh, path, true, &fault));
    sepax_soup_free(&mesh);
    mesh = read_mesh();
    assert_string_equal(localeconv()->decimal_point, ",");
  }
  setlocale(LC_ALL, "C");
  snprintf(command, sizeof command, "rm -rf %s/de_DE.UTF-8", folder);
  assert_int_equal(system(command), 0);
  remove(path);
  if (!made) {
    skip();
  }
  assert_int_equal(mesh.count, 1);
  sepax_soup_free(&mesh);
}

CASE(test_pipe) {
  assert_int_equal(mkfifo(path, 0600), 0);
  pid_t child = fork();
  assert_true(child >= 0);
  if (child == 0) {
    FILE *out = fopen(path, "w");
    _exit(out == NULL || fputs(SOLID("1"), out) == EOF || fclose(out) != 0);
  }
  sepax_soup mesh = read_mesh();
  int status = 1;
  waitpid(child, &status, 0);
  assert_int_equal(status, 0);
  assert_int_equal(mesh.count, 1);
  sepax_soup_free(&mesh);
  remove(path);
}

/* -------------------------------------------------------------------- writing */

/* Random facets of numbers of every magnitude that binary32 holds. */
static sepax_soup random_mesh(size_t count, bool single) {
  sepax_soup mesh = {.facet = calloc(count, sizeof *mesh.facet),
                     .count = count,
                     .normal = calloc(count, sizeof *mesh.normal)};
  assert_non_null(mesh.facet);
  assert_non_null(mesh.normal);
  for (size_t i = 0; i < 12 * count; i++) {
    double number = ldexp(random_unit(), random_below(250) - 124);
    size_t k = i % 12;
    sepax_facet *facet = &mesh.facet[i / 12];
    *(k < 9 ? &facet->v[k / 3][k % 3] : &mesh.normal[i / 12][k - 9]) =
        single ? (double)(float)number : number;
  }
  return mesh;
}

static void assert_round_trip(const sepax_soup *mesh, bool ascii) {
  assert_works(sepax_stl_write(mesh, path, ascii, &fault));
  assert_int_equal(files_in_folder(), 1);
  sepax_soup back = read_mesh();
  assert_int_equal(back.count, mesh->count);
  assert_memory_equal(back.facet, mesh->facet, mesh->count * sizeof *mesh->facet);
  assert_memory_equal(back.normal, mesh->normal, mesh->count * sizeof *mesh->normal);
  sepax_soup_free(&back);
  remove(path);
}

CASE(test_round_trips) {
  sepax_soup mesh = random_mesh(1000, true);
  mesh.facet[0].v[0][0] = -0.0;
  mesh.facet[0].v[0][1] = FLT_MAX;
  mesh.facet[0].v[0][2] = 0x1p-149;
  assert_round_trip(&mesh, false);
  assert_round_trip(&mesh, true);
  sepax_soup_free(&mesh);
  mesh = random_mesh(1000, false);
  mesh.facet[0].v[0][0] = -DBL_MAX;
  mesh.facet[0].v[0][1] = 0x1p-1074;
  assert_round_trip(&mesh, true);
  sepax_soup_free(&mesh);
}

CASE(test_write_form) {
  sepax_soup mesh = random_mesh(2, true);
  mode_t mask = umask(027);
  assert_works(sepax_stl_write(&mesh, path, false, &fault));
  umask(mask);
  struct stat status;
  assert_int_equal(stat(path, &status), 0);
  assert_int_equal(status.st_mode & 0777, 0640);
  assert_int_equal(status.st_size, 184);
  char bytes[8];
  assert_int_equal(get_bytes(bytes, sizeof bytes), sizeof bytes);
  assert_true(strncasecmp(bytes, "solid", 5) != 0);
  assert_works(sepax_stl_write(&mesh, path, true, &fault)); /* over the old file */
  assert_int_equal(get_bytes(bytes, sizeof bytes), sizeof bytes);
  assert_memory_equal(bytes, "solid se", 8);
  remove(path);
  sepax_soup_free(&mesh);
}

static void refuse_to_write(const sepax_soup *mesh, bool ascii, const char *part) {
  int before = files_in_folder();
  assert_fault(sepax_stl_write(mesh, path, ascii, &fault), part);
  assert_message(path);
  assert_int_equal(files_in_folder(), before);
}

CASE(test_write_values) {
  sepax_soup mesh = random_mesh(3, true);
  double *x = &mesh.facet[2].v[1][0];
  *x = stepped(0x1.ffffffp127, -1);
  assert_works(sepax_stl_write(&mesh, path, false, &fault));
  sepax_soup back = read_mesh();
  assert_true(back.facet[2].v[1][0] == FLT_MAX);
  sepax_soup_free(&back);
  remove(path);
  *x = -0x1.ffffffp127;
  refuse_to_write(&mesh, false, "facet 2: coordinate -3.40282e+38 does not fit");
  *x = NAN;
  refuse_to_write(&mesh, false, "facet 2: coordinate is NaN");
  refuse_to_write(&mesh, true, "facet 2: coordinate is NaN");
  *x = 0;
  mesh.normal[0][1] = -INFINITY;
  refuse_to_write(&mesh, true, "facet 0: normal is infinite");
  sepax_soup_free(&mesh);
  refuse_to_write(&mesh, true, "no facets");
}

CASE(test_write_failures) {
  sepax_soup mesh = random_mesh(100, true);
  assert_int_equal(mkdir(path, 0777), 0);
  refuse_to_write(&mesh, false, "exists and is no file");
  rmdir(path);
  assert_int_equal(symlink("/dev/null", path), 0);
  refuse_to_write(&mesh, false, "exists and is no file");
  remove(path);

  char kept[PATH_BYTES];
  memcpy(kept, path, sizeof kept);
  snprintf(path, sizeof path, "%.500s/none/part.stl", folder);
  refuse_to_write(&mesh, false, "No such file");
  memcpy(path, kept, sizeof path);

  put_bytes("precious", 8);
  struct rlimit limit;
  assert_int_equal(getrlimit(RLIMIT_FSIZE, &limit), 0);
  struct rlimit tight = {.rlim_cur = 100, .rlim_max = limit.rlim_max};
  void (*handler)(int) = signal(SIGXFSZ, SIG_IGN);
  assert_int_equal(setrlimit(RLIMIT_FSIZE, &tight), 0);
  bool binary = sepax_stl_write(&mesh, path, false, &fault);
  sepax_error first = fault;
  bool text = sepax_stl_write(&mesh, path, true, &fault);
  assert_int_equal(setrlimit(RLIMIT_FSIZE, &limit), 0);
  signal(SIGXFSZ, handler);
  assert_false(binary || text);
  assert_message("File too large");
  assert_string_equal(first.text, fault.text);
  assert_int_equal(files_in_folder(), 1);
  char bytes[8];
  assert_int_equal(get_bytes(bytes, sizeof bytes), 8);
  assert_memory_equal(bytes, "precious", 8);
  remove(path);
  sepax_soup_free(&mesh);
}

/* ---------------------------------------------------------------- real meshes */

static bool ends_with(const char *name, const char *end) {
  return strlen(name) >= strlen(end) && strcmp(name + strlen(name) - strlen(end), end) == 0;
}

/* Every STL file of a folder is read; how many there are. */
static size_t read_folder(const char *name) {
  DIR *dir = opendir(name);
  size_t files = 0;
  for (struct dirent *entry = NULL; dir != NULL && (entry = readdir(dir)) != NULL;) {
    if (ends_with(entry->d_name, ".stl")) {
      char file[PATH_BYTES];
      sepax_soup mesh = {0};
      snprintf(file, sizeof file, "%s/%s", name, entry->d_name);
      assert_works(sepax_stl_read(&mesh, file, false, &fault));
      print_message("%s: %zu facets\n", entry->d_name, mesh.count);
      assert_true(mesh.count > 0);
      assert_fit((const sepax_soup *const[]){&mesh}, 1, 18);
      sepax_soup_free(&mesh);
      files++;
    }
  }
  if (dir != NULL) {
    closedir(dir);
  }
  return files;
}

CASE(test_data_meshes) { assert_int_equal(read_folder("tb/data"), 3); }

CASE(test_shared_meshes) {
  if (read_folder("../shared/meshes") == 0) {
    skip();
  }
}
