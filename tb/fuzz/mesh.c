/* SPDX-License-Identifier: MIT */
/* mesh.c - any bytes as a mesh file. */
#include "fuzz/mesh.h"
#include "reader/read.h"

#include <math.h>
#include <string.h>

/* An input of a few kB that makes more triangles places its meshes again and again. */
enum { TRIANGLES_MOST = 20000 };

static void require_finite(const sepax_soup *mesh) {
  REQUIRE(mesh->count > 0 && mesh->count <= TRIANGLES_MOST);
  for (size_t n = 0; n < 9 * mesh->count; n++) {
    REQUIRE(isfinite(mesh->facet[n / 9].v[n % 9 / 3][n % 3]));
  }
}

static void require_account(const sepax_mesh_account *account, const sepax_soup *mesh) {
  REQUIRE(account->format != NULL);
  REQUIRE(account->triangles == mesh->count);
  REQUIRE(account->faces > account->unplaced);
  REQUIRE(account->bent <= account->divided);
  REQUIRE(account->fans <= account->divided);
  REQUIRE(memchr(account->unit, '\0', sizeof account->unit) != NULL);
  REQUIRE(account->unit_mm >= 0 && isfinite(account->unit_mm));
  REQUIRE(account->others <= SEPAX_MESH_OTHERS_MOST);
  for (size_t n = 0; n < account->others; n++) {
    const char *what = account->other[n].what;
    REQUIRE(memchr(what, '\0', sizeof account->other[n].what) != NULL && what[0] != '\0');
    REQUIRE(account->other[n].count > 0);
    for (size_t k = 0; k < n; k++) {
      REQUIRE(strcmp(what, account->other[k].what) != 0);
    }
  }
}

static void require_remarks(const sepax_mesh_account *account) {
  REQUIRE(account->remarks <= SEPAX_MESH_REMARKS_MOST);
  for (size_t n = 0; n < account->remarks; n++) {
    const sepax_mesh_remark *r = &account->remark[n];
    REQUIRE(memchr(r->what, '\0', sizeof r->what) != NULL && r->what[0] != '\0');
    REQUIRE(memchr(r->which, '\0', sizeof r->which) != NULL && r->which[0] != '\0');
    REQUIRE(r->count > 0);
  }
}

void fuzz_mesh(const uint8_t *data, size_t size, const char *name) {
  /* Polygons that cross themselves are divided in every other length. */
  const sepax_mesh_reading how = {
      .size = sizeof how, .most = TRIANGLES_MOST, .fans = size % 2 == 1};
  sepax_mesh_account account;
  sepax_soup mesh;
  sepax_error error = {0};
  char *bytes = malloc(size + 1);
  REQUIRE(bytes != NULL);
  memcpy(bytes, data, size);
  bytes[size] = '\0';
  bool ok =
      fuzz_answer(sepax__mesh_parse(&mesh, &account, bytes, size, name, &how, &error), &error);
  if (ok) {
    require_finite(&mesh);
    require_account(&account, &mesh);
    require_remarks(&account);
    sepax_soup_free(&mesh);
  } else {
    /* Both counts read the same format. Of 3MF the second one knows no namespaces. */
    REQUIRE(strstr(name, ".3mf") != NULL || strstr(error.text, "a second count") == NULL);
    REQUIRE(mesh.facet == NULL && mesh.count == 0);
  }
  free(bytes);
}
