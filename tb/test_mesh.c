/* test_mesh.c - STL files, the quantiser and the sample objects. */
#include "sepax.h"

#include <dirent.h>
#include <float.h>
#include <gmp.h>
#include <inttypes.h>
#include <math.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

enum { PATH_BYTES = 1024, RANDOM_VALUES = 200000 };

static const double pi = 0x1.921fb54442d18p1;

static char folder[PATH_BYTES / 2];
static char path[PATH_BYTES];
static sepax_error error;

/* splitmix64, so that the test needs nothing of the library but what it tests. */
static uint64_t random_bits(void) {
  static uint64_t state = 2024;
  uint64_t z = state += UINT64_C(0x9e3779b97f4a7c15);
  z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
  z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
  return z ^ z >> 31;
}

static int random_below(int count) { return (int)(random_bits() % (uint64_t)count); }

/* Uniform in -1 ... 1. */
static double random_unit(void) {
  return ldexp((double)(random_bits() >> 11), -52) - 1;
}

static double stepped(double x, int ulps) {
  for (; ulps != 0; ulps += ulps < 0 ? 1 : -1) {
    x = nextafter(x, ulps < 0 ? -INFINITY : INFINITY);
  }
  return x;
}

/* ------------------------------------------------------------ scratch folder */

static int make_folder(void **state) {
  (void)state;
  const char *parent = getenv("TMPDIR");
  snprintf(folder, sizeof folder, "%s/sepax_mesh_XXXXXX",
           parent != NULL && parent[0] != '\0' ? parent : "/tmp");
  if (mkdtemp(folder) == NULL) {
    return -1;
  }
  snprintf(path, sizeof path, "%s/part.stl", folder);
  return 0;
}

/* After a failed test there may be files. */
static int remove_folder(void **state) {
  (void)state;
  DIR *dir = opendir(folder);
  if (dir == NULL) {
    return -1;
  }
  for (struct dirent *entry = readdir(dir); entry != NULL; entry = readdir(dir)) {
    if (entry->d_name[0] != '.') {
      snprintf(path, sizeof path, "%s/%s", folder, entry->d_name);
      remove(path);
    }
  }
  closedir(dir);
  return rmdir(folder);
}

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

static void assert_message(const char *part) {
  if (strstr(error.text, part) == NULL || strchr(error.text, '\n') != NULL) {
    fail_msg("message \"%s\" lacks \"%s\"", error.text, part);
  }
}

static void assert_refused(const char *part) {
  sepax_mesh mesh = {.count = 77};
  error.text[0] = '\0';
  assert_false(sepax_stl_read(&mesh, path, &error));
  assert_message(part);
  assert_message(path);
  assert_null(mesh.facet);
  assert_int_equal(mesh.count, 77);
}

static void refuse_bytes(const void *bytes, size_t size, const char *part) {
  put_bytes(bytes, size);
  assert_refused(part);
  remove(path);
}

static void refuse_text(const char *text, const char *part) {
  refuse_bytes(text, strlen(text), part);
}

static sepax_mesh read_ok(void) {
  sepax_mesh mesh = {0};
  if (!sepax_stl_read(&mesh, path, &error)) {
    fail_msg("%s", error.text);
  }
  return mesh;
}

static sepax_mesh read_text(const char *text) {
  put_bytes(text, strlen(text));
  sepax_mesh mesh = read_ok();
  remove(path);
  return mesh;
}

/* ----------------------------------------------------------------- STL files */

#define FACET(number)                                                     \
  " facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex " number \
  " 0 0\n"                                                                \
  "   vertex 0 1 0\n  endloop\n endfacet\n"
#define SOLID(number) "solid part\n" FACET(number) "endsolid part\n"

static double number_read(const char *text) {
  char solid[2048];
  snprintf(solid, sizeof solid, SOLID("%s"), text);
  sepax_mesh mesh = read_text(solid);
  double number = mesh.facet[0].v[1][0];
  sepax_mesh_free(&mesh);
  assert_null(mesh.facet);
  assert_int_equal(mesh.count, 0);
  return number;
}

static void test_decimals(void **state) {
  (void)state;
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
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    double number = number_read(cases[i].text);
    if (number < cases[i].number || number > cases[i].number) {
      fail_msg("%s read as %a", cases[i].text, number);
    }
  }
}

static void test_text_forms(void **state) {
  (void)state;
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
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    sepax_mesh mesh = read_text(cases[i].text);
    assert_int_equal(mesh.count, cases[i].count);
    for (size_t k = 0; k < mesh.count; k++) {
      const sepax_facet *f = &mesh.facet[k];
      assert_true(f->normal[0] == 0 && f->normal[1] == 0 && f->normal[2] == 1);
      assert_true(f->v[1][0] == (double)(k + 1) && f->v[2][1] == 1 && f->v[0][2] == 0);
    }
    sepax_mesh_free(&mesh);
  }
}

static void test_text_errors(void **state) {
  (void)state;
  refuse_text("", "empty");
  refuse_text("hello", "no STL file");
  refuse_text(
      "<html>This is a page of text, and so long that it might have the head of a "
      "binary file in it.</html>",
      "no STL file");
  refuse_text("solid\nendsolid\n", "no facets");
  refuse_text("solidify\n", "line 1: 'solidify' where solid is expected");
  refuse_text("solid a\n", "line 2: the text ends before facet or endsolid: truncated");
  refuse_text("solid a\n" FACET("1"), "line 9: the text ends before");
  refuse_text("solid a\n facet normal 0 0", "line 2: the text ends before a number");
  refuse_text("solid a\n facet normal 0 0 1\n outer\r\n poop\n",
              "line 4: 'poop' where loop");
  refuse_text("solid a\r\r facet abnormal", "line 3: 'abnormal' where normal");
  refuse_text(SOLID("1") "rubbish", "line 10: 'rubbish' where solid");
  refuse_text(SOLID("1,5"), "line 5: '1,5' where a number");
  refuse_text(SOLID("0x10"), "line 5: '0x10' where a number");
  refuse_text(SOLID("1.#QNAN"), "line 5: '1.#QNAN' where a number");
  refuse_text(SOLID("1 2"), "line 5: '0' where vertex");
  refuse_text(SOLID("nan"), "line 5: coordinate is NaN; export");
  refuse_text(SOLID("-inf"), "line 5: coordinate is infinite");
  refuse_text(SOLID("1e309"), "line 5: coordinate is infinite");
  refuse_text("solid a\nfacet normal 0 nan 0", "line 2: normal is NaN");
  refuse_text("solid a\nfacet\033normal\x80zero 0 nan 0",
              "line 2: 'facet?normal?zero' where facet or endsolid");
  refuse_text("solid a\na_word_of_more_than_twenty_four_characters",
              "'a_word_of_more_than_twen' where");
  const char with_zero[] = SOLID("1\0");
  put_bytes(with_zero, sizeof with_zero - 1);
  assert_refused("no STL file");
  remove(path);
}

/* A binary file of `count` facets, all numbers 1, with room for what a case appends. */
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

static void test_binary_forms(void **state) {
  (void)state;
  const char *titles[] = {"", "solid", "solid part\n facet normal 0 0 1", "COLOR=\xff"};
  unsigned char bytes[500];
  for (size_t i = 0; i < sizeof titles / sizeof titles[0]; i++) {
    size_t size = make_binary(bytes, titles[i], 3);
    bytes[84 + 50 + 12 + 3] = 0xbf; /* facet 2, vertex 1, x: -1 */
    bytes[84 + 50 + 48] = 0xff;     /* attributes */
    put_bytes(bytes, size);
    sepax_mesh mesh = read_ok();
    remove(path);
    assert_int_equal(mesh.count, 3);
    assert_true(mesh.facet[1].v[0][0] == -1 && mesh.facet[1].normal[2] == 1);
    assert_true(mesh.facet[2].v[2][2] == 1 && mesh.facet[2].normal[0] == 1);
    sepax_mesh_free(&mesh);
  }
}

static void test_binary_errors(void **state) {
  (void)state;
  unsigned char bytes[500];
  size_t size = make_binary(bytes, "solid", 3);
  refuse_bytes(bytes, size - 1, "truncated: 3 facets take 234 bytes, the file has 233");
  refuse_bytes(bytes, 84, "truncated");
  refuse_bytes(bytes, 83, "no STL file");
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
  refuse_bytes(bytes, size, "facet 3: coordinate is infinite; export");
  bytes[84 + 50 + 3] = 0xff;
  bytes[84 + 50 + 2] = 0xc0;
  refuse_bytes(bytes, size, "facet 2: normal is NaN; export");
}

static void test_unreadable(void **state) {
  (void)state;
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
  sepax_mesh mesh = {0};
  assert_false(sepax_stl_read(&mesh, far, &error));
  assert_message("check the path");
}

static void test_pipe(void **state) {
  (void)state;
  assert_int_equal(mkfifo(path, 0600), 0);
  pid_t child = fork();
  assert_true(child >= 0);
  if (child == 0) {
    FILE *out = fopen(path, "w");
    _exit(out == NULL || fputs(SOLID("1"), out) == EOF || fclose(out) != 0);
  }
  sepax_mesh mesh = read_ok();
  int status = 1;
  waitpid(child, &status, 0);
  assert_int_equal(status, 0);
  assert_int_equal(mesh.count, 1);
  sepax_mesh_free(&mesh);
  remove(path);
}

/* -------------------------------------------------------------------- writing */

/* Random facets of numbers of every magnitude that binary32 holds. */
static sepax_mesh random_mesh(size_t count, bool single) {
  sepax_mesh mesh = {calloc(count, sizeof *mesh.facet), count};
  assert_non_null(mesh.facet);
  for (size_t i = 0; i < 12 * count; i++) {
    double number = ldexp(random_unit(), random_below(250) - 124);
    size_t k = i % 12;
    sepax_facet *facet = &mesh.facet[i / 12];
    *(k < 9 ? &facet->v[k / 3][k % 3] : &facet->normal[k - 9]) =
        single ? (double)(float)number : number;
  }
  return mesh;
}

static void assert_round_trip(const sepax_mesh *mesh, bool ascii) {
  if (!sepax_stl_write(mesh, path, ascii, &error)) {
    fail_msg("%s", error.text);
  }
  assert_int_equal(files_in_folder(), 1);
  sepax_mesh back = read_ok();
  assert_int_equal(back.count, mesh->count);
  assert_memory_equal(back.facet, mesh->facet, mesh->count * sizeof *mesh->facet);
  sepax_mesh_free(&back);
  remove(path);
}

static void test_round_trips(void **state) {
  (void)state;
  sepax_mesh mesh = random_mesh(1000, true);
  mesh.facet[0].v[0][0] = -0.0;
  mesh.facet[0].v[0][1] = FLT_MAX;
  mesh.facet[0].v[0][2] = 0x1p-149;
  assert_round_trip(&mesh, false);
  assert_round_trip(&mesh, true);
  sepax_mesh_free(&mesh);
  mesh = random_mesh(1000, false);
  mesh.facet[0].v[0][0] = -DBL_MAX;
  mesh.facet[0].v[0][1] = 0x1p-1074;
  assert_round_trip(&mesh, true);
  sepax_mesh_free(&mesh);
}

static void test_write_form(void **state) {
  (void)state;
  sepax_mesh mesh = random_mesh(2, true);
  mode_t mask = umask(027);
  assert_true(sepax_stl_write(&mesh, path, false, &error));
  umask(mask);
  struct stat status;
  assert_int_equal(stat(path, &status), 0);
  assert_int_equal(status.st_mode & 0777, 0640);
  assert_int_equal(status.st_size, 184);
  char bytes[8];
  assert_int_equal(get_bytes(bytes, sizeof bytes), sizeof bytes);
  assert_true(strncasecmp(bytes, "solid", 5) != 0);
  assert_true(sepax_stl_write(&mesh, path, true, &error)); /* over the old file */
  assert_int_equal(get_bytes(bytes, sizeof bytes), sizeof bytes);
  assert_memory_equal(bytes, "solid se", 8);
  remove(path);
  sepax_mesh_free(&mesh);
}

static void refuse_to_write(const sepax_mesh *mesh, bool ascii, const char *part) {
  int before = files_in_folder();
  error.text[0] = '\0';
  assert_false(sepax_stl_write(mesh, path, ascii, &error));
  assert_message(part);
  assert_message(path);
  assert_int_equal(files_in_folder(), before);
}

static void test_write_values(void **state) {
  (void)state;
  sepax_mesh mesh = random_mesh(3, true);
  double *x = &mesh.facet[2].v[1][0];
  *x = stepped(0x1.ffffffp127, -1);
  assert_true(sepax_stl_write(&mesh, path, false, &error));
  sepax_mesh back = read_ok();
  assert_true(back.facet[2].v[1][0] == FLT_MAX);
  sepax_mesh_free(&back);
  remove(path);
  *x = -0x1.ffffffp127;
  refuse_to_write(&mesh, false, "facet 3: coordinate -3.40282e+38 does not fit");
  *x = NAN;
  refuse_to_write(&mesh, false, "facet 3: coordinate is NaN");
  refuse_to_write(&mesh, true, "facet 3: coordinate is NaN");
  *x = 0;
  mesh.facet[0].normal[1] = -INFINITY;
  refuse_to_write(&mesh, true, "facet 1: normal is infinite");
  sepax_mesh_free(&mesh);
  refuse_to_write(&mesh, true, "no facets");
}

static void test_write_failures(void **state) {
  (void)state;
  sepax_mesh mesh = random_mesh(100, true);
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
  bool binary = sepax_stl_write(&mesh, path, false, &error);
  sepax_error first = error;
  bool text = sepax_stl_write(&mesh, path, true, &error);
  assert_int_equal(setrlimit(RLIMIT_FSIZE, &limit), 0);
  signal(SIGXFSZ, handler);
  assert_false(binary || text);
  assert_message("File too large");
  assert_string_equal(first.text, error.text);
  assert_int_equal(files_in_folder(), 1);
  char bytes[8];
  assert_int_equal(get_bytes(bytes, sizeof bytes), 8);
  assert_memory_equal(bytes, "precious", 8);
  remove(path);
  sepax_mesh_free(&mesh);
}

/* ------------------------------------------------------------------ quantiser */

/* A mesh of one facet: a point, and x in every coordinate. */
static sepax_facet facet_at(double x) {
  return (sepax_facet){.v = {{x, x, x}, {x, x, x}, {x, x, x}}};
}

static bool quantised(int32_t *q, double x, const sepax_grid *grid) {
  sepax_facet facet = facet_at(x);
  const sepax_mesh mesh = {&facet, 1};
  sepax_tri tri = {{{7, 7, 7}, {7, 7, 7}, {7, 7, 7}}};
  error.text[0] = '\0';
  bool ok = sepax_quantise(&mesh, grid, &tri, NULL, &error);
  *q = tri.v[2].z;
  return ok;
}

static void assert_quantised(double x, double resolution, double offset, int word,
                             int32_t expected) {
  sepax_grid grid = {resolution, {offset, offset, offset}, word};
  int32_t q = 0;
  if (!quantised(&q, x, &grid) || q != expected) {
    fail_msg("(%a - %a) / %a: %" PRId32 ", not %" PRId32 "; %s", x, offset, resolution,
             q, expected, error.text);
  }
}

static void refuse_value(double x, sepax_grid grid, const char *part) {
  int32_t q = 0;
  assert_false(quantised(&q, x, &grid));
  assert_int_equal(q, 7);
  assert_message(part);
}

static void test_rounding(void **state) {
  (void)state;
  assert_quantised(0.5, 1, 0, 18, 1);
  assert_quantised(-0.5, 1, 0, 18, -1);
  assert_quantised(2.5, 1, 0, 18, 3);
  assert_quantised(-2.5, 1, 0, 18, -3);
  assert_quantised(stepped(0.5, -1), 1, 0, 18, 0);
  assert_quantised(stepped(-0.5, 1), 1, 0, 18, 0);
  assert_quantised(-0.0, 1, 0, 4, 0);
  assert_quantised(0.125, 0.25, 0, 18, 1);
  assert_quantised(1, 2, 2, 18, -1);
  assert_quantised(0x1p-1074, 0x1p-1074, 0, 18, 1);
  assert_quantised(0x3p-1074, 0x1p-1073, 0, 18, 2);
  assert_quantised(0x1p999, 0x1p997, -0x1p999, 18, 8);
  /* 1e16 + 0.5 as x - offset is no double; only an exact difference sees the half. */
  assert_quantised(1e16, 1e16, -0.5, 18, 1);
  assert_quantised(0x1p53, 0x1p54, -0x1p-60, 18, 1);
  assert_quantised(0x1p53, 0x1p54, 0x1p-60, 18, 0);
  /* 0.009 / 0.002 and 0.25 / 0.1 give 4.5 and 2.5 in double; exactly they are less. */
  assert_quantised(0.009, 0.002, 0, 18, 4);
  assert_quantised(-0.25, 0.1, 0, 18, -2);
  assert_quantised(0.001, 0.002, 0, 18, 1);
}

static void test_extremes(void **state) {
  (void)state;
  for (int word = 4; word <= 32; word++) {
    double half = ldexp(1, word - 1);
    sepax_grid grid = {1, {0, 0, 0}, word};
    assert_quantised(stepped(half - 0.5, -1), 1, 0, word, sepax_word_max(word));
    assert_quantised(stepped(-half - 0.5, 1), 1, 0, word, sepax_word_min(word));
    refuse_value(half - 0.5, grid, "does not fit");
    refuse_value(-half - 0.5, grid, "does not fit");
  }
  sepax_grid grid = {0.002, {0, 0, 0}, 18};
  refuse_value(
      300, grid,
      "facet 1, vertex 1: x = 300 does not fit 18 bits of 0.002 from 0; raise");
  refuse_value(1e308, grid, "does not fit");
  refuse_value(-INFINITY, grid, "does not fit");
  refuse_value(NAN, grid, "does not fit");
}

static void test_bad_grids(void **state) {
  (void)state;
  const double bad[] = {0, -0.0, -1, NAN, INFINITY, DBL_MAX};
  for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
    refuse_value(1, (sepax_grid){bad[i], {0, 0, 0}, 18}, "resolution: ");
  }
  refuse_value(1, (sepax_grid){1, {0, NAN, 0}, 18}, "offset: y = nan");
  refuse_value(1, (sepax_grid){1, {0, 0, -INFINITY}, 18}, "offset: z = -inf");
  refuse_value(1, (sepax_grid){1, {0, 0, 0}, 3}, "word: 3 is not in 4 ... 32");
  refuse_value(1, (sepax_grid){1, {0, 0, 0}, 33}, "word: 33 is not in 4 ... 32");
}

/* floor(|x - offset| / resolution + 1/2) with its sign, in rationals. */
static void slow_quantise(mpz_t q, double x, double offset, double resolution) {
  mpq_t value;
  mpq_t other;
  mpq_inits(value, other, NULL);
  mpq_set_d(value, x);
  mpq_set_d(other, offset);
  mpq_sub(value, value, other);
  mpq_set_d(other, resolution);
  mpq_div(value, value, other);
  int sign = mpq_sgn(value);
  mpq_abs(value, value);
  mpq_set_ui(other, 1, 2);
  mpq_add(value, value, other);
  mpz_fdiv_q(q, mpq_numref(value), mpq_denref(value));
  if (sign < 0) {
    mpz_neg(q, q);
  }
  mpq_clears(value, other, NULL);
}

/* Most values lie within a few units in the last place of a border. */
static void test_against_rationals(void **state) {
  (void)state;
  const double resolutions[] = {0.002, 0.1,    1.0 / 3, 1e-3,      7e-7,
                                1,     0.0254, 1e30,    0x1p-1070, pi};
  const int count = (int)(sizeof resolutions / sizeof resolutions[0]);
  int fitting = 0;
  int below = 0;
  mpz_t expected;
  mpz_init(expected);
  for (int i = 0; i < RANDOM_VALUES; i++) {
    double step = resolutions[random_below(count)];
    int word = 4 + random_below(29);
    double offset = random_below(3) == 0 ? 0 : random_unit() * step * 1e4;
    double q = floor(random_unit() * ldexp(1.0001, word - 1));
    double x = stepped((q + 0.5) * step + offset, random_below(5) - 2);
    x = random_below(8) == 0 ? x + random_unit() * step : x;
    slow_quantise(expected, x, offset, step);
    below += mpz_cmp_d(expected, q) == 0;
    if (mpz_cmp_si(expected, sepax_word_min(word)) >= 0 &&
        mpz_cmp_si(expected, sepax_word_max(word)) <= 0) {
      assert_quantised(x, step, offset, word, (int32_t)mpz_get_si(expected));
      fitting++;
    } else {
      refuse_value(x, (sepax_grid){step, {offset, offset, offset}, word},
                   "does not fit");
    }
  }
  mpz_clear(expected);
  print_message("%d values against rationals, %d fit, %d below a border\n",
                RANDOM_VALUES, fitting, below);
  assert_true(fitting > RANDOM_VALUES / 2 && fitting < RANDOM_VALUES);
  assert_true(below > RANDOM_VALUES / 4 && below < RANDOM_VALUES * 3 / 4);
}

static void test_normals(void **state) {
  (void)state;
  const struct {
    double normal[3];
    int word;
    sepax_vec expected;
  } cases[] = {
      {{0, 0, 0}, 18, {0, 0, 0}},
      {{0, -0.0, 1}, 18, {0, 0, 131071}},
      {{-7, 0, 0}, 32, {-2147483647, 0, 0}},
      {{3e-320, 0, 4e-320}, 18, {78643, 0, 104857}},
      {{1e308, 1e308, -1e308}, 18, {75674, 75674, -75674}},
      {{1, 1, 1}, 4, {4, 4, 4}},
      {{0.5, 0.5, 0x1.6a09e667f3bcdp-1}, 8, {64, 64, 90}},
  };
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    sepax_facet facet = {.normal = {0}};
    memcpy(facet.normal, cases[i].normal, sizeof facet.normal);
    const sepax_mesh mesh = {&facet, 1};
    const sepax_grid grid = {1, {0, 0, 0}, cases[i].word};
    sepax_tri tri;
    sepax_vec normal;
    assert_true(sepax_quantise(&mesh, &grid, &tri, &normal, &error));
    assert_memory_equal(&normal, &cases[i].expected, sizeof normal);
  }
  sepax_facet facet = {.normal = {0, NAN, 0}};
  const sepax_mesh mesh = {&facet, 1};
  const sepax_grid grid = {1, {0, 0, 0}, 18};
  sepax_tri tri;
  sepax_vec normal;
  assert_false(sepax_quantise(&mesh, &grid, &tri, &normal, &error));
  assert_message("facet 1: the normal has y = nan");
}

static void test_untouched(void **state) {
  (void)state;
  sepax_facet facet[2] = {facet_at(1), facet_at(100)};
  const sepax_mesh mesh = {facet, 2};
  sepax_tri tri[2] = {{{{7, 7, 7}}}};
  sepax_vec normal[2] = {{7, 7, 7}};
  const sepax_grid grid = {1, {0, 0, 0}, 4};
  assert_false(sepax_quantise(&mesh, &grid, tri, normal, &error));
  assert_message("facet 2, vertex 1: x = 100 does not fit 4 bits");
  assert_true(tri[0].v[0].x == 7 && normal[0].x == 7);
}

/* ------------------------------------------------------------------------ fit */

static bool fits(const sepax_mesh *mesh, const sepax_grid *grid) {
  sepax_tri *tri = malloc(mesh->count * sizeof *tri);
  assert_non_null(tri);
  bool ok = sepax_quantise(mesh, grid, tri, NULL, &error);
  free(tri);
  return ok;
}

/* It fits, and the next finer resolution does not. */
static sepax_grid assert_fit(const sepax_mesh *const meshes[], size_t count, int word) {
  sepax_grid grid = {0};
  if (!sepax_grid_fit(&grid, meshes, count, word, &error)) {
    fail_msg("%s", error.text);
  }
  assert_int_equal(grid.word, word);
  sepax_grid finer = grid;
  finer.resolution = nextafter(grid.resolution, 0);
  bool finer_fits = finer.resolution > 0;
  for (size_t i = 0; i < count; i++) {
    if (!fits(meshes[i], &grid)) {
      fail_msg("fit of %d bits: %s", word, error.text);
    }
    finer_fits = finer_fits && fits(meshes[i], &finer);
  }
  assert_false(finer_fits);
  return grid;
}

static void test_fit(void **state) {
  (void)state;
  for (int i = 0; i < 20000; i++) {
    double scale = ldexp(1, random_below(80) - 40);
    double shift = random_below(2) == 0 ? 0 : random_unit() * 1e6;
    sepax_facet facet[2];
    for (int k = 0; k < 18; k++) {
      facet[k / 9].v[k / 3 % 3][k % 3] = shift + random_unit() * scale;
    }
    facet[1].v[0][0] = stepped(facet[0].v[0][0], 1); /* never a single point */
    const sepax_mesh a = {&facet[0], 1};
    const sepax_mesh b = {&facet[1], 1};
    assert_fit((const sepax_mesh *const[]){&a, &b}, 2, 4 + random_below(29));
  }
}

static void test_fit_extremes(void **state) {
  (void)state;
  const double ends[][2] = {{-1, 1},
                            {0, 10},
                            {1, 1 + DBL_EPSILON},
                            {0, 0x1p-1074},
                            {-0x1p1000, 0x1p1000},
                            {-0x1p1000, stepped(-0x1p1000, 1)},
                            {-1e-300, 1e300}};
  for (size_t i = 0; i < sizeof ends / sizeof ends[0]; i++) {
    sepax_facet facet = facet_at(ends[i][0]);
    facet.v[1][2] = ends[i][1];
    const sepax_mesh mesh = {&facet, 1};
    const sepax_mesh *const list[] = {&mesh};
    for (int word = 4; word <= 32; word++) {
      assert_fit(list, 1, word);
    }
  }
  sepax_facet facet = {.v = {{0, 0, 0}, {100, 20, 0}, {0, -40, 30}}};
  const sepax_mesh mesh = {&facet, 1};
  sepax_grid grid = assert_fit((const sepax_mesh *const[]){&mesh}, 1, 18);
  assert_true(grid.offset[0] == 50 && grid.offset[1] == -10 && grid.offset[2] == 15);
  assert_true(fabs(grid.resolution * 262143 / 100 - 1) < 1e-15);
}

static void refuse_fit(const sepax_mesh *const meshes[], size_t count, int word,
                       const char *part) {
  sepax_grid grid = {.word = 77};
  assert_false(sepax_grid_fit(&grid, meshes, count, word, &error));
  assert_message(part);
  assert_int_equal(grid.word, 77);
}

static void test_fit_errors(void **state) {
  (void)state;
  sepax_facet same = facet_at(5);
  sepax_facet wide = {.v = {{0, 0, 1}, {0, 0, 2}, {0, 0, 3}}};
  sepax_facet huge = {.v = {{0, 0, 0}, {0, -1e305, 0}, {0, 0, 0}}};
  sepax_facet wrong = {.v = {{0, 0, 0}, {0, 0, 0}, {0, NAN, 0}}};
  const sepax_mesh empty = {0};
  const sepax_mesh point = {&same, 1};
  const sepax_mesh line = {&wide, 1};
  const sepax_mesh large = {&huge, 1};
  const sepax_mesh flawed = {&wrong, 1};
  refuse_fit(NULL, 0, 18, "empty");
  refuse_fit((const sepax_mesh *const[]){&empty, &empty}, 2, 18, "empty");
  refuse_fit((const sepax_mesh *const[]){&empty, &point}, 2, 18, "a single point");
  refuse_fit((const sepax_mesh *const[]){&line}, 1, 3, "word: 3 is not in 4 ... 32");
  refuse_fit((const sepax_mesh *const[]){&line, &large}, 2, 18,
             "mesh 2, facet 1: y = -1e");
  refuse_fit((const sepax_mesh *const[]){&flawed}, 1, 18, "mesh 1, facet 1: y = nan");
}

/* -------------------------------------------------------------------- samples */

typedef struct {
  double p[3];
} point;

static int compare_points(const void *a, const void *b) {
  const point *p = a;
  const point *q = b;
  for (int i = 0; i < 3; i++) {
    if (p->p[i] < q->p[i] || p->p[i] > q->p[i]) {
      return p->p[i] < q->p[i] ? -1 : 1;
    }
  }
  return 0;
}

static int compare_edges(const void *a, const void *b) {
  const size_t *e = a;
  const size_t *f = b;
  for (int i = 0; i < 2; i++) {
    if (e[i] != f[i]) {
      return e[i] < f[i] ? -1 : 1;
    }
  }
  return 0;
}

/* The distinct corners of the mesh in ascending order; their number is returned. */
static size_t find_corners(point **corners, const sepax_mesh *mesh) {
  size_t count = 0;
  point *all = malloc(3 * mesh->count * sizeof *all);
  assert_non_null(all);
  for (size_t i = 0; i < 3 * mesh->count; i++) {
    memcpy(all[i].p, mesh->facet[i / 3].v[i % 3], sizeof all[i].p);
  }
  qsort(all, 3 * mesh->count, sizeof *all, compare_points);
  for (size_t i = 0; i < 3 * mesh->count; i++) {
    if (count == 0 || compare_points(&all[i], &all[count - 1]) != 0) {
      all[count++] = all[i];
    }
  }
  *corners = all;
  return count;
}

/* Each directed edge once, and once its opposite; as many corners as a surface of
 * the topology of the sphere has. */
static void assert_closed(const sepax_mesh *mesh) {
  point *corners = NULL;
  size_t count = find_corners(&corners, mesh);
  assert_int_equal(2 * count, mesh->count + 4);
  size_t edges = 3 * mesh->count;
  size_t(*edge)[2] = malloc(edges * sizeof *edge);
  assert_non_null(edge);
  for (size_t i = 0; i < edges; i++) {
    for (size_t k = 0; k < 2; k++) {
      const double *v = mesh->facet[i / 3].v[(i % 3 + k) % 3];
      const point *found = bsearch(v, corners, count, sizeof *corners, compare_points);
      assert_non_null(found);
      edge[i][k] = (size_t)(found - corners);
    }
  }
  qsort(edge, edges, sizeof *edge, compare_edges);
  for (size_t i = 0; i < edges; i++) {
    const size_t opposite[2] = {edge[i][1], edge[i][0]};
    assert_true(i == 0 || compare_edges(edge[i], edge[i - 1]) != 0);
    assert_non_null(bsearch(opposite, edge, edges, sizeof *edge, compare_edges));
  }
  free(edge);
  free(corners);
}

static double dot(const double a[3], const double b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross_edges(double n[3], const sepax_facet *facet) {
  double e[2][3];
  for (int i = 0; i < 3; i++) {
    e[0][i] = facet->v[1][i] - facet->v[0][i];
    e[1][i] = facet->v[2][i] - facet->v[0][i];
  }
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3;
    int k = (i + 2) % 3;
    n[i] = e[0][j] * e[1][k] - e[0][k] * e[1][j];
  }
}

/* The normals of the file are those of the corners, and of unit length. */
static void assert_normals(const sepax_mesh *mesh) {
  for (size_t i = 0; i < mesh->count; i++) {
    const sepax_facet *facet = &mesh->facet[i];
    double n[3];
    cross_edges(n, facet);
    assert_true(fabs(dot(facet->normal, facet->normal) - 1) < 1e-14);
    assert_true(fabs(dot(facet->normal, n) / sqrt(dot(n, n)) - 1) < 1e-12);
  }
}

static double volume(const sepax_mesh *mesh, const double origin[3]) {
  double sum = 0;
  for (size_t i = 0; i < mesh->count; i++) {
    const sepax_facet *facet = &mesh->facet[i];
    double n[3];
    double v[3];
    cross_edges(n, facet);
    for (int k = 0; k < 3; k++) {
      v[k] = facet->v[0][k] - origin[k];
    }
    sum += dot(v, n) / 6;
  }
  return sum;
}

/* A point of the axis or the centre sees every facet of a convex body from inside. */
static void assert_seen_from(const sepax_mesh *mesh, const double inside[3]) {
  for (size_t i = 0; i < mesh->count; i++) {
    double v[3];
    for (int k = 0; k < 3; k++) {
      v[k] = mesh->facet[i].v[0][k] - inside[k];
    }
    assert_true(dot(v, mesh->facet[i].normal) > 0);
  }
}

static sepax_mesh sample(const char *shape, size_t triangles, const double at[3],
                         double size) {
  sepax_mesh mesh = {0};
  if (!sepax_sample(&mesh, shape, triangles, at, size, &error)) {
    fail_msg("%s", error.text);
  }
  assert_int_equal(mesh.count, triangles);
  return mesh;
}

static const double origin[3] = {0, 0, 0};

static void test_sample_meshes(void **state) {
  (void)state;
  const double at[3] = {3, -40, 0.5};
  for (size_t i = 0; sepax_sample_name(i) != NULL; i++) {
    size_t least = sepax_sample_least(i);
    const size_t counts[] = {least,      least + 2,  least + 4, least + 6, least + 8,
                             least + 10, least + 40, 500,       1000,      20000};
    for (size_t k = 0; k < sizeof counts / sizeof counts[0]; k++) {
      sepax_mesh mesh = sample(sepax_sample_name(i), counts[k], at, k % 2 == 0 ? 0 : 7);
      assert_closed(&mesh);
      assert_normals(&mesh);
      assert_true(volume(&mesh, at) > 0);
      sepax_mesh_free(&mesh);
    }
  }
}

/* z above the centre of the end, r from the axis, for a cutter of radius 1. */
static bool on_cutter(double z, double r, bool ball) {
  const double eps = 1e-13;
  bool end = ball ? z < eps && fabs(sqrt(z * z + r * r) - 1) < eps
                  : fabs(z) < eps && r < 1 + eps;
  bool shank = z > -eps && z < 6 + eps && fabs(r - 1) < eps;
  bool top = fabs(z - 6) < eps && r < 1 + eps;
  return end || shank || top;
}

static void assert_cutter(bool ball, size_t triangles) {
  const double at[3] = {1, 2, 3};
  const double inside[3] = {1, 2, 3 + 20};
  sepax_mesh mesh = sample(ball ? "ball-end" : "flat-end", triangles, at, 0);
  double lowest = INFINITY;
  for (size_t i = 0; i < 3 * mesh.count; i++) {
    const double *v = mesh.facet[i / 3].v[i % 3];
    double r = sqrt((v[0] - 1) * (v[0] - 1) + (v[1] - 2) * (v[1] - 2)) / 10;
    assert_true(on_cutter((v[2] - 3) / 10 - (ball ? 1 : 0), r, ball));
    lowest = fmin(lowest, v[2]);
  }
  assert_true(lowest == 3);
  assert_seen_from(&mesh, inside);
  double solid = pi * 1000 * (6 + (ball ? 2.0 / 3 : 0));
  double filled = volume(&mesh, at) / solid;
  assert_true(filled < 1 && filled > 1 - 30.0 / (double)triangles);
  sepax_mesh_free(&mesh);
}

static void test_cutters(void **state) {
  (void)state;
  for (size_t triangles = 100; triangles < 30000; triangles = triangles * 3 + 2) {
    assert_cutter(true, triangles);
    assert_cutter(false, triangles);
  }
}

static void test_sphere(void **state) {
  (void)state;
  for (size_t triangles = 8; triangles < 30000; triangles = triangles * 2 + 2) {
    sepax_mesh mesh = sample("sphere", triangles, origin, 2);
    for (size_t i = 0; i < 3 * mesh.count; i++) {
      const double *v = mesh.facet[i / 3].v[i % 3];
      assert_true(fabs(dot(v, v) - 1) < 1e-14);
    }
    assert_seen_from(&mesh, origin);
    double filled = volume(&mesh, origin) / (pi * 4 / 3);
    assert_true(filled < 1 && filled > 1 - 14.0 / (double)triangles);
    sepax_mesh_free(&mesh);
  }
}

/* The boxes of the mesh: low and high by axis. */
static void assert_box(const sepax_mesh *mesh, const double low[3],
                       const double high[3]) {
  for (int axis = 0; axis < 3; axis++) {
    double least = INFINITY;
    double most = -INFINITY;
    for (size_t i = 0; i < 3 * mesh->count; i++) {
      least = fmin(least, mesh->facet[i / 3].v[i % 3][axis]);
      most = fmax(most, mesh->facet[i / 3].v[i % 3][axis]);
    }
    assert_true(least == low[axis] && most == high[axis]);
  }
}

static void test_blocks(void **state) {
  (void)state;
  const double at[3] = {100, 0, -8};
  sepax_mesh mesh = sample("box", 5000, at, 60);
  assert_box(&mesh, (double[3]){70, -20, -18}, (double[3]){130, 20, 2});
  assert_seen_from(&mesh, at);
  assert_true(fabs(volume(&mesh, at) / 48000 - 1) < 1e-12);
  sepax_mesh_free(&mesh);
  mesh = sample("pocket", 5000, at, 0);
  assert_box(&mesh, (double[3]){40, -40, -48}, (double[3]){160, 40, -8});
  assert_true(fabs(volume(&mesh, at) / (384000 - 80 * 40 * 25) - 1) < 1e-12);
  sepax_mesh_free(&mesh);
}

static void test_sample_again(void **state) {
  (void)state;
  sepax_mesh once = sample("ball-end", 4000, origin, 0);
  sepax_mesh twice = sample("ball-end", 4000, origin, 20);
  assert_memory_equal(once.facet, twice.facet, once.count * sizeof *once.facet);
  sepax_mesh_free(&once);
  sepax_mesh_free(&twice);
}

static void test_sample_list(void **state) {
  (void)state;
  const char *names[] = {"ball-end", "flat-end", "pocket", "sphere", "box"};
  for (size_t i = 0; i < 5; i++) {
    assert_string_equal(sepax_sample_name(i), names[i]);
    assert_true(strlen(sepax_sample_about(i)) > 10);
    assert_true(sepax_sample_least(i) >= 4 && sepax_sample_least(i) % 2 == 0);
  }
  assert_null(sepax_sample_name(5));
  assert_null(sepax_sample_about(5));
  assert_int_equal(sepax_sample_least(5), 0);
}

static void refuse_sample(const char *shape, size_t triangles, const double at[3],
                          double size, const char *part) {
  sepax_mesh mesh = {.count = 77};
  assert_false(sepax_sample(&mesh, shape, triangles, at, size, &error));
  assert_message(part);
  assert_null(mesh.facet);
  assert_int_equal(mesh.count, 77);
}

static void test_sample_errors(void **state) {
  (void)state;
  const double far[3] = {0, 0, -1e17};
  const double nowhere[3] = {0, NAN, 0};
  refuse_sample("torus", 100, origin, 0,
                "shape: 'torus' is none of: ball-end, flat-end, pocket, sphere, box");
  refuse_sample("box", 101, origin, 0, "101 triangles close no mesh; ask for an even");
  refuse_sample("box", 10, origin, 0, "box: 10 triangles are not in 12 ...");
  refuse_sample("box", 0, origin, 0, "not in 12 ...");
  refuse_sample("box", SIZE_MAX - 1, origin, 0, "not in 12 ...");
  refuse_sample("box", 100, origin, -1, "size: -1 is not a length");
  refuse_sample("box", 100, origin, NAN, "size: nan is not a length");
  refuse_sample("box", 100, origin, INFINITY, "size: inf is not a length");
  refuse_sample("box", 100, nowhere, 0, "at: y = nan");
  refuse_sample("box", 100, far, 0,
                "at: z = -1e+17 is no place for an object of 120 mm");
  refuse_sample("box", 100, origin, 1e-170, "triangles of no area");
  refuse_sample("box", 100, origin, 1e200, "triangles of no area");
}

/* A sample survives the file, binary32 included, and the finest grid of 18 bits. */
static void test_sample_to_grid(void **state) {
  (void)state;
  for (size_t i = 0; sepax_sample_name(i) != NULL; i++) {
    sepax_mesh mesh = sample(sepax_sample_name(i), 2000, origin, 0);
    assert_true(sepax_stl_write(&mesh, path, false, &error));
    sepax_mesh back = read_ok();
    assert_closed(&back);
    assert_fit((const sepax_mesh *const[]){&mesh, &back}, 2, 18);
    sepax_mesh_free(&back);
    sepax_mesh_free(&mesh);
    remove(path);
  }
}

/* ---------------------------------------------------------------- real meshes */

static bool ends_with(const char *name, const char *end) {
  return strlen(name) >= strlen(end) &&
         strcmp(name + strlen(name) - strlen(end), end) == 0;
}

static void test_shared_meshes(void **state) {
  (void)state;
  const char *shared = "../shared/meshes";
  DIR *dir = opendir(shared);
  if (dir == NULL) {
    skip();
    return;
  }
  for (struct dirent *entry = readdir(dir); entry != NULL; entry = readdir(dir)) {
    if (ends_with(entry->d_name, ".stl")) {
      char name[PATH_BYTES];
      sepax_mesh mesh = {0};
      snprintf(name, sizeof name, "%s/%s", shared, entry->d_name);
      if (!sepax_stl_read(&mesh, name, &error)) {
        fail_msg("%s", error.text);
      }
      print_message("%s: %zu facets\n", entry->d_name, mesh.count);
      assert_true(mesh.count > 0);
      assert_fit((const sepax_mesh *const[]){&mesh}, 1, 18);
      sepax_mesh_free(&mesh);
    }
  }
  closedir(dir);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_decimals),
      cmocka_unit_test(test_text_forms),
      cmocka_unit_test(test_text_errors),
      cmocka_unit_test(test_binary_forms),
      cmocka_unit_test(test_binary_errors),
      cmocka_unit_test(test_unreadable),
      cmocka_unit_test(test_pipe),
      cmocka_unit_test(test_round_trips),
      cmocka_unit_test(test_write_form),
      cmocka_unit_test(test_write_values),
      cmocka_unit_test(test_write_failures),
      cmocka_unit_test(test_rounding),
      cmocka_unit_test(test_extremes),
      cmocka_unit_test(test_bad_grids),
      cmocka_unit_test(test_against_rationals),
      cmocka_unit_test(test_normals),
      cmocka_unit_test(test_untouched),
      cmocka_unit_test(test_fit),
      cmocka_unit_test(test_fit_extremes),
      cmocka_unit_test(test_fit_errors),
      cmocka_unit_test(test_sample_meshes),
      cmocka_unit_test(test_cutters),
      cmocka_unit_test(test_sphere),
      cmocka_unit_test(test_blocks),
      cmocka_unit_test(test_sample_again),
      cmocka_unit_test(test_sample_list),
      cmocka_unit_test(test_sample_errors),
      cmocka_unit_test(test_sample_to_grid),
      cmocka_unit_test(test_shared_meshes),
  };
  return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
