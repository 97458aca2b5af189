/* mesh_tools.c - scratch folder, random numbers and asserts of the tests of meshes. */
#include "mesh_tools.h"

#include <dirent.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

char folder[PATH_BYTES / 2];
char path[PATH_BYTES];
sepax_error fault;

int make_folder(void **state) {
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
int remove_folder(void **state) {
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

/* splitmix64, so that the test needs nothing of the library but what it tests. */
static uint64_t random_bits(void) {
  static uint64_t state = 2024;
  uint64_t z = state += UINT64_C(0x9e3779b97f4a7c15);
  z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
  z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
  return z ^ z >> 31;
}

int random_below(int count) { return (int)(random_bits() % (uint64_t)count); }

double random_unit(void) { return ldexp((double)(random_bits() >> 11), -52) - 1; }

double stepped(double x, int ulps) {
  for (; ulps != 0; ulps += ulps < 0 ? 1 : -1) {
    x = nextafter(x, ulps < 0 ? -INFINITY : INFINITY);
  }
  return x;
}

void assert_message(const char *part) {
  if (strstr(fault.text, part) == NULL || strchr(fault.text, '\n') != NULL) {
    fail_msg("message \"%s\" lacks \"%s\"", fault.text, part);
  }
}

sepax_mesh read_ok(void) {
  sepax_mesh mesh = {0};
  if (!sepax_stl_read(&mesh, path, &fault)) {
    fail_msg("%s", fault.text);
  }
  return mesh;
}

static bool fits(const sepax_mesh *mesh, const sepax_grid *grid) {
  sepax_tri *tri = malloc(mesh->count * sizeof *tri);
  assert_non_null(tri);
  bool ok = sepax_quantise(mesh, grid, tri, NULL, &fault);
  free(tri);
  return ok;
}

sepax_grid assert_fit(const sepax_mesh *const meshes[], size_t count, int word) {
  sepax_grid grid = {0};
  if (!sepax_grid_fit(&grid, meshes, count, word, &fault)) {
    fail_msg("%s", fault.text);
  }
  assert_int_equal(grid.word, word);
  sepax_grid finer = grid;
  finer.resolution = nextafter(grid.resolution, 0);
  bool finer_fits = finer.resolution > 0;
  for (size_t i = 0; i < count; i++) {
    if (!fits(meshes[i], &grid)) {
      fail_msg("fit of %d bits: %s", word, fault.text);
    }
    finer_fits = finer_fits && fits(meshes[i], &finer);
  }
  assert_false(finer_fits);
  return grid;
}
