/* assimp.c - meshes of other formats than STL, by assimp, without steps that move a vertex. */
#include "formats/formats.h"
#include "formats/libraries.h"
#include "formats/mesh_format_table.h"
#include "util/error.h"
#include "util/list.h"

#include <assimp/cimport.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

const bool format_assimp_here = true;

/* From a mesh to the file's own coordinates: rows of three, then a translation. */
typedef struct {
  double m[3][4];
} change;

typedef struct {
  const char *path;
  const struct aiScene *scene;
  sepax_soup *mesh;
  size_t capacity;
  double (*corner)[3]; /* of the polygon at hand */
  size_t (*triangle)[3];
  size_t corners; /* for which there is space */
} importer;

/* ------------------------------------------------------------------------- scenes */

static change change_of(const struct aiMatrix4x4 *t) {
  return (change){{{(double)t->a1, (double)t->a2, (double)t->a3, (double)t->a4},
                   {(double)t->b1, (double)t->b2, (double)t->b3, (double)t->b4},
                   {(double)t->c1, (double)t->c2, (double)t->c3, (double)t->c4}}};
}

static change combined(const change *outer, const change *inner) {
  change r;
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 4; j++) {
      r.m[i][j] = outer->m[i][0] * inner->m[0][j] + outer->m[i][1] * inner->m[1][j] +
                  outer->m[i][2] * inner->m[2][j] + (j == 3 ? outer->m[i][3] : 0);
    }
  }
  return r;
}

static bool is_nothing(const change *c) {
  for (int i = 0; i < 12; i++) {
    if (c->m[i / 4][i % 4] != (i / 4 == i % 4)) {
      return false;
    }
  }
  return true;
}

static void place(const change *c, const struct aiVector3D *v, double to[3]) {
  const double from[3] = {(double)v->x, (double)v->y, (double)v->z};
  for (int i = 0; i < 3; i++) {
    to[i] = is_nothing(c)
                ? from[i]
                : c->m[i][0] * from[0] + c->m[i][1] * from[1] + c->m[i][2] * from[2] + c->m[i][3];
  }
}

static bool add_facet(importer *in, const size_t corner[3], sepax_error *error) {
  sepax_soup *mesh = in->mesh;
  sepax_facet *grown = mesh->count < FORMAT_FACETS_MOST
                           ? list_grow(mesh->facet, &in->capacity, mesh->count, sizeof *grown)
                           : NULL;
  if (grown == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY,
                      "%.300s: more than %d triangles, or no memory; simplify the mesh", in->path,
                      FORMAT_FACETS_MOST);
  }
  mesh->facet = grown;
  sepax_facet *facet = &mesh->facet[mesh->count];
  *facet = (sepax_facet){0};
  for (int k = 0; k < 3; k++) {
    memcpy(facet->v[k], in->corner[corner[k]], sizeof facet->v[k]);
    for (int i = 0; i < 3; i++) {
      if (!isfinite(facet->v[k][i])) {
        return sepax_fail(error, SEPAX_ERROR_FORMAT,
                          "%.300s: a coordinate of triangle %zu is not finite; export it "
                          "again",
                          in->path, mesh->count);
      }
    }
  }
  mesh->count++;
  return true;
}

static bool make_space(importer *in, size_t corners) {
  if (corners <= in->corners) {
    return true;
  }
  sepax_release(in->corner);
  sepax_release(in->triangle);
  in->corner = sepax_allocate(corners * sizeof *in->corner);
  in->triangle = sepax_allocate(corners * sizeof *in->triangle);
  in->corners = in->corner != NULL && in->triangle != NULL ? corners : 0;
  return in->corners != 0;
}

static bool add_face(importer *in, const struct aiMesh *from, const struct aiFace *face,
                     const change *to, sepax_error *error) {
  size_t count = face->mNumIndices;
  if (count < 3) {
    return sepax_fail(error, SEPAX_ERROR_FORMAT,
                      "%.300s: it has points or lines beside faces; leave them out", in->path);
  }
  if (!make_space(in, count)) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "%.300s: no memory for a face of %zu corners",
                      in->path, count);
  }
  for (size_t k = 0; k < count; k++) {
    if (face->mIndices[k] >= from->mNumVertices) {
      return sepax_fail(error, SEPAX_ERROR_FORMAT,
                        "%.300s: a face has a vertex that is not there; export it again", in->path);
    }
    place(to, &from->mVertices[face->mIndices[k]], in->corner[k]);
  }
  if (!format_polygon_divide((const double(*)[3])in->corner, count, in->triangle)) {
    return sepax_fail(error, SEPAX_ERROR_FORMAT,
                      "%.240s: a face of %zu corners is too hollow to be divided; export "
                      "triangles",
                      in->path, count);
  }
  bool ok = true;
  for (size_t k = 0; k + 2 < count && ok; k++) {
    const size_t corner[3] = {in->triangle[k][0], in->triangle[k][1], in->triangle[k][2]};
    ok = add_facet(in, corner, error);
  }
  return ok;
}

static bool add_node(importer *in, const struct aiNode *node, const change *outer, int depth,
                     sepax_error *error) {
  enum { DEPTH_MOST = 200 };
  change own = change_of(&node->mTransformation);
  change to = is_nothing(outer) ? own : is_nothing(&own) ? *outer : combined(outer, &own);
  bool ok =
      depth < DEPTH_MOST || sepax_fail(error, SEPAX_ERROR_FORMAT,
                                       "%.300s: nodes %d deep; flatten the scene", in->path, depth);
  for (unsigned n = 0; n < node->mNumMeshes && ok; n++) {
    const struct aiMesh *mesh = in->scene->mMeshes[node->mMeshes[n]];
    for (unsigned k = 0; k < mesh->mNumFaces && ok; k++) {
      ok = add_face(in, mesh, &mesh->mFaces[k], &to, error);
    }
  }
  for (unsigned n = 0; n < node->mNumChildren && ok; n++) {
    ok = add_node(in, node->mChildren[n], &to, depth + 1, error);
  }
  return ok;
}

/* -------------------------------------------------------------------------- files */

static const struct aiScene *import(const char *path, sepax_error *error) {
  struct aiPropertyStore *how = aiCreatePropertyStore();
  aiSetImportPropertyInteger(how, AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, 1);
  const struct aiScene *scene = aiImportFileExWithProperties(path, 0, NULL, how);
  aiReleasePropertyStore(how);
  if (scene == NULL || scene->mRootNode == NULL ||
      (scene->mFlags & AI_SCENE_FLAGS_INCOMPLETE) != 0) {
    const char *why = scene == NULL ? aiGetErrorString() : "it is incomplete";
    if (strstr(why, "bad_alloc") != NULL) {
      why = "it is too large for the memory that a file of this length gets";
    }
    sepax_fail(error, SEPAX_ERROR_FORMAT, "%.240s: %.180s; export it again", path, why);
    aiReleaseImport(scene);
    return NULL;
  }
  return scene;
}

bool mesh_read_assimp(sepax_soup *mesh, const char *path, sepax_error *error) {
  *mesh = (sepax_soup){0};
  const struct aiScene *scene = import(path, error);
  if (scene == NULL) {
    return false;
  }
  importer in = {.path = path, .scene = scene, .mesh = mesh};
  const change none = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  bool ok = add_node(&in, scene->mRootNode, &none, 0, error) &&
            (mesh->count > 0 || sepax_fail(error, SEPAX_ERROR_FORMAT,
                                           "%.300s: no triangles in it; give a mesh", path));
  sepax_release(in.corner);
  sepax_release(in.triangle);
  aiReleaseImport(scene);
  return ok;
}
