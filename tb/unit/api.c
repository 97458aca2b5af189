/* SPDX-License-Identifier: MIT */
/* api.c - what callers of libsepax rely on beside the answers: codes of errors, results that are
 * zero after a failure, structs of other versions, meshes as they lie in memory, an allocator of
 * their own. */
#include "harness.h"
#include "sepax_grid.h"
#include "sepax_mechanism.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A tetrahedron: vertices, and the index of its four faces. */
static const double vertex[4][3] = {{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {0, 0, 8}};
static const uint32_t corner[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
static const sepax_pose shifted = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {1, 1, -1}};

static void assert_code(bool ok, sepax_code code, const char *part) {
  assert_false(ok);
  assert_int_equal(fault.code, code);
  assert_message(part);
}

static void assert_zero(const void *result, size_t bytes) {
  for (size_t n = 0; n < bytes; n++) {
    assert_int_equal(((const unsigned char *)result)[n], 0);
  }
}

CASE(versions) {
  char text[32];
  snprintf(text, sizeof text, "%d.%d.%d", SEPAX_VERSION_MAJOR, SEPAX_VERSION_MINOR,
           SEPAX_VERSION_PATCH);
  assert_string_equal(sepax_version(), text);
  assert_int_equal(sepax_version_number(), SEPAX_VERSION_NUMBER);
  assert_true(sepax_version_fits(SEPAX_VERSION_NUMBER));
  assert_false(sepax_version_fits(SEPAX_VERSION_NUMBER + 1));
  assert_false(sepax_version_fits(SEPAX_VERSION_NUMBER + 10000));
  assert_int_equal(sepax_version_fits(SEPAX_VERSION_NUMBER - 100), SEPAX_VERSION_MAJOR > 0);
}

/* ------------------------------------------------------------------ meshes */

/* The tetrahedron in one of its forms, of which all are the same body. */
enum { FORMS = 6 };
static sepax_mesh form(int which) {
  static double soup[4][3][3];
  static double wide[4][5];    /* a vertex and two numbers more */
  static float single[4][3];   /* exact for these numbers */
  static float odd[4 * 4 + 1]; /* at an address that is no multiple of 8 */
  static uint32_t four[4][4];  /* an index and one number more */
  for (int n = 0; n < 4; n++) {
    for (int k = 0; k < 3; k++) {
      memcpy(soup[n][k], vertex[corner[n][k]], sizeof soup[n][k]);
      four[n][k] = corner[n][k];
      wide[n][k] = vertex[n][k];
      single[n][k] = odd[4 * n + k + 1] = (float)vertex[n][k];
    }
    wide[n][3] = wide[n][4] = NAN;
    four[n][3] = UINT32_MAX;
  }
  const sepax_mesh forms[FORMS] = {
      SEPAX_STRUCT(sepax_mesh, .vertex = soup, .triangles = 4),
      SEPAX_STRUCT(sepax_mesh, .vertex = vertex, .vertices = 4, .index = corner[0], .triangles = 4),
      SEPAX_STRUCT(sepax_mesh, .vertex = wide, .vertex_stride = sizeof wide[0], .vertices = 4,
                   .index = corner[0], .triangles = 4),
      SEPAX_STRUCT(sepax_mesh, .vertex = single, .real = SEPAX_FLOAT, .vertices = 4,
                   .index = corner[0], .triangles = 4),
      SEPAX_STRUCT(sepax_mesh, .vertex = &odd[1], .real = SEPAX_FLOAT,
                   .vertex_stride = 4 * sizeof odd[0], .vertices = 4, .index = four[0],
                   .index_stride = sizeof four[0], .triangles = 4),
      SEPAX_STRUCT(sepax_mesh, .vertex = vertex, .vertices = 4, .index = four[0],
                   .index_stride = sizeof four[0], .triangles = 4)};
  return forms[which];
}

CASE(meshes_are_read_where_they_are) {
  sepax_pairs expected = {0};
  sepax_tri expected_tri[4];
  sepax_grid expected_grid;
  for (int n = 0; n < FORMS; n++) {
    sepax_mesh mesh = form(n);
    sepax_body *body;
    sepax_pairs found[2];
    sepax_tri tri[4];
    sepax_grid grid;
    assert_works(sepax_body_new(&body, &mesh, NULL, &fault));
    assert_int_equal(sepax_body_triangles(body), 4);
    assert_works(sepax_bodies_collide(body, NULL, body, &shifted, NULL, &found[0], &fault));
    assert_works(sepax_meshes_collide(&mesh, NULL, &mesh, &shifted, NULL, &found[1], &fault));
    assert_works(sepax_grid_fit(&grid, (const sepax_mesh *[]){&mesh}, 1, 12, &fault));
    assert_works(sepax_quantise(&mesh, &grid, tri, &fault));
    if (n == 0) {
      expected = found[1];
      memcpy(expected_tri, tri, sizeof tri);
      expected_grid = grid;
      assert_true(expected.count > 2);
    }
    assert_int_equal(found[0].count, expected.count);
    assert_int_equal(found[1].count, expected.count);
    assert_memory_equal(found[1].pair, expected.pair, expected.count * sizeof *expected.pair);
    assert_memory_equal(tri, expected_tri, sizeof tri);
    assert_memory_equal(&grid, &expected_grid, sizeof grid);
    sepax_pairs_free(&found[0]);
    if (n > 0) {
      sepax_pairs_free(&found[1]);
    }
    sepax_body_free(body);
  }
  sepax_pairs_free(&expected);
}

CASE(meshes_that_are_none) {
  static const uint32_t beyond[4][3] = {{0, 2, 1}, {0, 1, 4}, {0, 3, 2}, {1, 2, 3}};
  const struct {
    sepax_mesh mesh;
    const char *part;
  } row[] = {
      {{.vertex = vertex, .triangles = 1}, "sepax_mesh has no size"},
      {SEPAX_STRUCT(sepax_mesh, .triangles = 1), "has no vertices"},
      {SEPAX_STRUCT(sepax_mesh, .vertex = vertex, .real = (sepax_real)7, .triangles = 1), "kind 7"},
      {SEPAX_STRUCT(sepax_mesh, .vertex = vertex, .vertex_stride = 8, .triangles = 1), "strides"},
      {SEPAX_STRUCT(sepax_mesh, .vertex = vertex, .vertices = 4, .index = beyond[0],
                    .index_stride = 4, .triangles = 4),
       "strides"},
      {SEPAX_STRUCT(sepax_mesh, .vertex = vertex, .vertices = 4, .index = beyond[0],
                    .triangles = 4),
       "triangle 1: vertex 4 is beyond the last of 4"}};
  const sepax_mesh good = form(1);
  for (size_t n = 0; n < LENGTH(row); n++) {
    const sepax_mesh *bad = &row[n].mesh;
    sepax_body *body = (sepax_body *)1;
    sepax_pairs found = {.count = 7};
    sepax_grid grid = {.word = 7};
    sepax_tri tri[4];
    assert_code(sepax_body_new(&body, bad, NULL, &fault), SEPAX_ERROR_ARGUMENT, row[n].part);
    assert_null(body);
    assert_code(sepax_meshes_collide(&good, NULL, bad, NULL, NULL, &found, &fault),
                SEPAX_ERROR_ARGUMENT, row[n].part);
    assert_zero(&found, sizeof found);
    assert_code(sepax_grid_fit(&grid, (const sepax_mesh *[]){&good, bad}, 2, 12, &fault),
                SEPAX_ERROR_ARGUMENT, row[n].part);
    assert_zero(&grid, sizeof grid);
    grid = (sepax_grid){1, {0, 0, 0}, 12};
    assert_code(sepax_quantise(bad, &grid, tri, &fault), SEPAX_ERROR_ARGUMENT, row[n].part);
    assert_false(sepax_body_new(&body, bad, NULL, NULL)); /* nobody asks why */
  }
  sepax_body *body;
  assert_code(sepax_body_new(&body, NULL, NULL, &fault), SEPAX_ERROR_ARGUMENT, "no mesh");
}

/* ----------------------------------------------------------------- options */

/* A caller of a newer header has a field behind those that are known here; one of an older header
 * lacks the last. */
CASE(structs_of_other_versions) {
  sepax_mesh mesh = form(0);
  sepax_body *body;
  sepax_pairs found;
  assert_works(sepax_body_new(&body, &mesh, NULL, &fault));
  struct {
    sepax_query known;
    size_t unknown;
  } newer = {.known = {.size = sizeof newer, .most = 1}};
  assert_works(sepax_bodies_collide(body, NULL, body, NULL, &newer.known, &found, &fault));
  assert_int_equal(found.count, 1);
  sepax_pairs_free(&found);
  newer.unknown = 1;
  found.count = 7;
  assert_code(sepax_bodies_collide(body, NULL, body, NULL, &newer.known, &found, &fault),
              SEPAX_ERROR_ARGUMENT, "does not know");
  assert_zero(&found, sizeof found);
  sepax_query older = {.size = offsetof(sepax_query, only_any), .most = 1, .only_any = true};
  assert_works(sepax_bodies_collide(body, NULL, body, NULL, &older, &found, &fault));
  assert_true(found.count == 1 && found.pair != NULL); /* only_any is not read */
  sepax_pairs_free(&found);
  sepax_query none = {.size = 0};
  assert_code(sepax_bodies_near(body, NULL, body, NULL, 1, &none, &found, &fault),
              SEPAX_ERROR_ARGUMENT, "sepax_query has no size");
  sepax_distance_request request = {.size = 4};
  sepax_distance_result result = {.min_distance = 7};
  assert_code(sepax_bodies_distance(body, NULL, body, NULL, &request, &result, &fault),
              SEPAX_ERROR_ARGUMENT, "sepax_distance_request has no size");
  assert_zero(&result, sizeof result);
  sepax_build build = {.size = sizeof build, .threads = -1};
  sepax_body *other;
  assert_code(sepax_body_new(&other, &mesh, &build, &fault), SEPAX_ERROR_ARGUMENT, "-1 threads");
  const sepax_search search = {.size = sizeof search, .threads = -1};
  assert_code(sepax_meshes_collide(&mesh, NULL, &mesh, NULL, &search, &found, &fault),
              SEPAX_ERROR_ARGUMENT, "-1 threads");
  sepax_body_free(body);
}

static bool refuse(void *context, uint64_t done, uint64_t total) {
  (void)context;
  (void)done;
  (void)total;
  return false;
}

CASE(a_search_is_cancelled) {
  sepax_mesh mesh = form(0);
  sepax_pairs found = {.count = 7};
  const sepax_search how = {.size = sizeof how, .progress = refuse};
  assert_code(sepax_meshes_collide(&mesh, NULL, &mesh, NULL, &how, &found, &fault),
              SEPAX_ERROR_CANCELLED, "ended");
  assert_zero(&found, sizeof found);
}

/* Instructions that no processor has stand for the widest that this one has. */
CASE(unknown_vector_instructions) {
  const int32_t x[3][3] = {{0, 4, 0}, {0, 0, 4}, {0, 0, 0}};
  sepax_columns a;
  for (int k = 0; k < 9; k++) {
    a.c[k / 3][k % 3] = &x[k % 3][k / 3];
  }
  for (int simd = -1; simd < 9; simd++) {
    uint64_t bits = 0;
    sepax_exact_pairs((sepax_simd)simd, &a, &a, 1, &bits);
    assert_int_equal(bits, 1);
    assert_non_null(sepax_simd_name((sepax_simd)simd));
  }
}

/* ------------------------------------------------------------------ memory */

typedef struct {
  size_t blocks, calls, most; /* alive, made, and how many may be made */
} account;

static void *allocate(void *context, size_t bytes) {
  account *a = context;
  if (a->calls++ >= a->most) {
    return NULL;
  }
  a->blocks++;
  return malloc(bytes);
}

static void *resize(void *context, void *memory, size_t bytes) {
  account *a = context;
  if (a->calls++ >= a->most) {
    return NULL;
  }
  a->blocks += memory == NULL;
  return realloc(memory, bytes);
}

static void release(void *context, void *memory) {
  account *a = context;
  a->blocks--;
  free(memory);
}

/* Everything once, by one thread. False where memory is refused; what was made is freed. */
static bool use_all(void) {
  sepax_mesh mesh = form(3);
  const sepax_build how = {.size = sizeof how, .threads = 1};
  const sepax_search search = {.size = sizeof search, .threads = 1};
  sepax_body *body = NULL;
  sepax_shell shell = {0};
  sepax_pairs found[3] = {{0}, {0}, {0}};
  sepax_distance_result result;
  const sepax_pose away = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {20, 0, 0}};
  bool ok = sepax_body_new(&body, &mesh, &how, &fault);
  ok = ok && sepax_shell_find(&shell, body, &fault);
  ok = ok && sepax_bodies_collide(body, NULL, body, &shifted, NULL, &found[0], &fault);
  ok = ok && sepax_bodies_near(body, NULL, body, &away, 30, NULL, &found[1], &fault);
  ok = ok && sepax_meshes_collide(&mesh, NULL, &mesh, &shifted, &search, &found[2], &fault);
  ok = ok && sepax_bodies_distance(body, NULL, body, &away, NULL, &result, &fault);
  if (!ok) {
    assert_int_equal(fault.code, SEPAX_ERROR_MEMORY);
  }
  sepax_shell_free(&shell);
  for (int n = 0; n < 3; n++) {
    sepax_pairs_free(&found[n]);
  }
  sepax_body_free(body);
  return ok;
}

CASE(memory_is_the_callers) {
  account a = {.most = SIZE_MAX};
  const sepax_allocator own = {allocate, resize, release, &a};
  sepax_set_allocator(&own);
  assert_true(use_all());
  size_t calls = a.calls;
  assert_int_equal(a.blocks, 0);
  assert_in_range(calls, 10, 1000);
  for (size_t n = 0; n < calls; n++) {
    a = (account){.most = n};
    assert_false(use_all());
    assert_int_equal(a.blocks, 0);
  }
  sepax_set_allocator(NULL);
  a = (account){0};
  assert_true(use_all());
  assert_int_equal(a.calls, 0);
}

/* ------------------------------------------------------------------- poses */

CASE(poses_are_applied_joined_and_inverted) {
  const sepax_pose turn = {{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}, {1, 2, 3}};
  const sepax_pose other = {{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, {4, 5, 6}};
  double v[3] = {7, 8, 9};
  double w[3];
  sepax_pose_apply(&turn, v, w);
  assert_true(w[0] == -8 + 1 && w[1] == 7 + 2 && w[2] == 9 + 3);
  const sepax_pose both = sepax_pose_compose(&other, &turn);
  double x[3];
  double y[3];
  sepax_pose_apply(&other, w, x);
  sepax_pose_apply(&both, v, y);
  assert_memory_equal(x, y, sizeof x);
  const sepax_pose back = sepax_pose_inverse(&both);
  sepax_pose_apply(&back, y, y); /* in place */
  assert_memory_equal(y, v, sizeof v);
}
