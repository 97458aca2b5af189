/* SPDX-License-Identifier: MIT */
/* mesh_files.c - what the reader of meshes makes of files, and how long it takes; or what assimp
 * makes of them, where it is installed.
 *   mesh_files [-a] FILE...    -a: by assimp
 * A line of JSON a file. Seconds are of the processor. */
#include "sepax_io.h"

#include <jansson.h>
#include <math.h>
#include <string.h>
#include <time.h>

#ifdef ASSIMP
#include <assimp/cimport.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#endif

typedef struct {
  size_t triangles;
  double area;
  double low[3], high[3];
} figures;

static double seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static figures no_figures(void) {
  return (figures){.low = {INFINITY, INFINITY, INFINITY},
                   .high = {-INFINITY, -INFINITY, -INFINITY}};
}

static void add(figures *f, const double v[3][3]) {
  double edge[2][3];
  for (int i = 0; i < 3; i++) {
    edge[0][i] = v[1][i] - v[0][i];
    edge[1][i] = v[2][i] - v[0][i];
    for (int k = 0; k < 3; k++) {
      f->low[i] = fmin(f->low[i], v[k][i]);
      f->high[i] = fmax(f->high[i], v[k][i]);
    }
  }
  double x = edge[0][1] * edge[1][2] - edge[0][2] * edge[1][1];
  double y = edge[0][2] * edge[1][0] - edge[0][0] * edge[1][2];
  double z = edge[0][0] * edge[1][1] - edge[0][1] * edge[1][0];
  f->area += 0.5 * sqrt(x * x + y * y + z * z);
  f->triangles++;
}

static void set_figures(json_t *to, const figures *f) {
  json_object_set_new(to, "triangles", json_integer((json_int_t)f->triangles));
  json_object_set_new(to, "area", json_real(f->area));
  json_object_set_new(to, "low", json_pack("[fff]", f->low[0], f->low[1], f->low[2]));
  json_object_set_new(to, "high", json_pack("[fff]", f->high[0], f->high[1], f->high[2]));
}

static void set_count(json_t *to, const char *key, size_t count) {
  json_object_set_new(to, key, json_integer((json_int_t)count));
}

static void set_account(json_t *to, const sepax_mesh_account *account) {
  json_object_set_new(to, "format", json_string(account->format));
  json_object_set_new(to, "unit", json_string(account->unit));
  set_count(to, "faces", account->faces);
  set_count(to, "divided", account->divided);
  set_count(to, "bent", account->bent);
  set_count(to, "unplaced", account->unplaced);
  json_t *others = json_object();
  for (size_t n = 0; n < account->others; n++) {
    set_count(others, account->other[n].what, account->other[n].count);
  }
  json_object_set_new(to, "others", others);
}

static bool by_sepax(json_t *to, const char *path, figures *f) {
  sepax_soup mesh;
  sepax_mesh_account account;
  sepax_error error = {0};
  double start = seconds();
  if (!sepax_mesh_read(&mesh, &account, path, NULL, &error)) {
    json_object_set_new(to, "error", json_string(error.text));
    return false;
  }
  json_object_set_new(to, "seconds", json_real(seconds() - start));
  set_account(to, &account);
  for (size_t n = 0; n < mesh.count; n++) {
    add(f, mesh.facet[n].v);
  }
  sepax_soup_free(&mesh);
  return true;
}

#ifdef ASSIMP
static void add_mesh(figures *f, const struct aiMesh *mesh, const struct aiMatrix4x4 *place) {
  const struct aiMatrix4x4 *m = place;
  for (unsigned n = 0; n < mesh->mNumFaces; n++) {
    const struct aiFace *face = &mesh->mFaces[n];
    for (unsigned k = 2; k < face->mNumIndices; k++) {
      const unsigned corner[3] = {0, k - 1, k};
      double v[3][3];
      for (int i = 0; i < 3; i++) {
        const struct aiVector3D *p = &mesh->mVertices[face->mIndices[corner[i]]];
        v[i][0] = (double)(m->a1 * p->x + m->a2 * p->y + m->a3 * p->z + m->a4);
        v[i][1] = (double)(m->b1 * p->x + m->b2 * p->y + m->b3 * p->z + m->b4);
        v[i][2] = (double)(m->c1 * p->x + m->c2 * p->y + m->c3 * p->z + m->c4);
      }
      add(f, v);
    }
  }
}

static void add_node(figures *f, const struct aiScene *scene, const struct aiNode *node,
                     const struct aiMatrix4x4 *above) {
  struct aiMatrix4x4 place = *above;
  aiMultiplyMatrix4(&place, &node->mTransformation);
  for (unsigned n = 0; n < node->mNumMeshes; n++) {
    add_mesh(f, scene->mMeshes[node->mMeshes[n]], &place);
  }
  for (unsigned n = 0; n < node->mNumChildren; n++) {
    add_node(f, scene, node->mChildren[n], &place);
  }
}

static bool by_assimp(json_t *to, const char *path, figures *f) {
  double start = seconds();
  const struct aiScene *scene = aiImportFile(path, 0);
  if (scene == NULL) {
    json_object_set_new(to, "error", json_string(aiGetErrorString()));
    return false;
  }
  json_object_set_new(to, "seconds", json_real(seconds() - start));
  struct aiMatrix4x4 one;
  aiIdentityMatrix4(&one);
  add_node(f, scene, scene->mRootNode, &one);
  aiReleaseImport(scene);
  return true;
}
#else
static bool by_assimp(json_t *to, const char *path, figures *f) {
  (void)path;
  (void)f;
  json_object_set_new(to, "error", json_string("assimp is not installed"));
  return false;
}
#endif

static json_t *measure(const char *path, bool assimp) {
  json_t *line = json_pack("{ss}", "file", path);
  figures f = no_figures();
  if (assimp ? by_assimp(line, path, &f) : by_sepax(line, path, &f)) {
    if (f.triangles > 0) {
      set_figures(line, &f);
    } else {
      json_object_set_new(line, "error", json_string("no triangles"));
    }
  }
  return line;
}

int main(int count, char **words) {
  bool assimp = count > 1 && strcmp(words[1], "-a") == 0;
  for (int n = assimp ? 2 : 1; n < count; n++) {
    json_t *line = measure(words[n], assimp);
    json_dumpf(line, stdout, JSON_REAL_PRECISION(17));
    puts("");
    json_decref(line);
  }
  return 0;
}
