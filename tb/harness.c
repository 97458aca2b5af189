/* SPDX-License-Identifier: MIT */
/* harness.c - the main program of every unit test, and what the unit tests share. */
#include "harness.h"

#include "oracle/pair_tools.h"

#include <dirent.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* ------------------------------------------------------------------------- cases */

static struct CMUnitTest cases[32]; /* cmocka leaves out empty ones */

void add_case(const char *name, CMUnitTestFunction function) {
  static size_t count;
  if (count == LENGTH(cases)) {
    abort();
  }
  cases[count++] = (struct CMUnitTest){.name = name, .test_func = function};
}

char folder[PATH_BYTES / 2];
char path[PATH_BYTES];

static int make_folder(void **state) {
  (void)state;
  const char *parent = getenv("TMPDIR");
  snprintf(folder, sizeof folder, "%s/sepax_unit_XXXXXX",
           parent != NULL && parent[0] != '\0' ? parent : "/tmp");
  bool made = mkdtemp(folder) != NULL;
  snprintf(path, sizeof path, "%s/part.stl", folder);
  return made ? 0 : -1;
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

int main(void) { return cmocka_run_group_tests(cases, make_folder, remove_folder); }

/* ---------------------------------------------------------------- faults, numbers */

sepax_error fault;

void assert_message(const char *part) {
  if (strstr(fault.text, part) == NULL || strchr(fault.text, '\n') != NULL) {
    fail_msg("message \"%s\" lacks \"%s\"", fault.text, part);
  }
}

static sepax_random numbers = {2024};

int random_below(int count) { return (int)sepax_random_range(&numbers, 0, count - 1); }

double random_unit(void) { return ldexp((double)(sepax_random_next(&numbers) >> 11), -52) - 1; }

double stepped(double x, int ulps) {
  for (; ulps != 0; ulps += ulps < 0 ? 1 : -1) {
    x = nextafter(x, ulps < 0 ? -INFINITY : INFINITY);
  }
  return x;
}

/* ------------------------------------------------------------------ designs, pairs */

static bool parsed(sepax_design *design, const char *options) {
  sepax_config config = sepax_config_default();
  return sepax_config_parse(&config, options, &fault) && sepax_design_init(design, &config, &fault);
}

sepax_design design_of(const char *options, ...) {
  char text[SEPAX_CONFIG_TEXT];
  va_list arguments;
  va_start(arguments, options);
  vsnprintf(text, sizeof text, options, arguments);
  va_end(arguments);
  sepax_design design;
  if (!parsed(&design, text)) {
    fail_msg("%s: %s", text, fault.text);
  }
  return design;
}

void refuse_design(const char *options, const char *why) {
  sepax_design design;
  if (parsed(&design, options) || strstr(fault.text, why) == NULL) {
    fail_msg("%s: '%s' does not say '%s'", options, fault.text, why);
  }
}

sepax_pair mixed_pair(size_t n, int word, sepax_random *random) {
  return sepax_family_pair(n % family_count(), word, random);
}

/* ------------------------------------------------------------------------ meshes */

sepax_soup read_mesh(void) {
  sepax_soup mesh = {0};
  assert_works(sepax_stl_read(&mesh, path, true, &fault));
  return mesh;
}

static bool fits(const sepax_soup *mesh, const sepax_grid *grid) {
  sepax_tri *tri = malloc(mesh->count * sizeof *tri);
  assert_non_null(tri);
  bool ok = sepax_quantise(SEPAX_SOUP_MESH(mesh), grid, tri, &fault);
  free(tri);
  return ok;
}

sepax_grid assert_fit(const sepax_soup *const meshes[], size_t count, int word) {
  sepax_grid grid = {0};
  sepax_mesh view[4];
  const sepax_mesh *all[4];
  assert_true(count <= 4);
  for (size_t i = 0; i < count; i++) {
    view[i] = *SEPAX_SOUP_MESH(meshes[i]);
    all[i] = &view[i];
  }
  assert_works(sepax_grid_fit(&grid, all, count, word, &fault));
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
