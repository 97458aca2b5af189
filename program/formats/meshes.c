/* meshes.c - meshes of other formats than STL, by assimp, without steps that move a vertex. */
#include "formats/confined.h"
#include "formats/ply.h"
#include "formats/formats.h"
#include "formats/xml.h"
#include "util/error.h"
#include "util/list.h"

#include <assimp/cimport.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* From a mesh to the file's own coordinates: rows of three, then a translation. */
typedef struct {
  double m[3][4];
} change;

typedef struct {
  const char *path;
  const struct aiScene *scene;
  sepax_mesh *mesh;
  size_t capacity;
  double (*corner)[3]; /* of the polygon at hand */
  size_t (*triangle)[3];
  size_t corners; /* for which there is space */
} importer;

/* ----------------------------------------------------------------------- polygons */

static void cross(const double p[3], const double q[3], double r[3]) {
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3;
    int k = (i + 2) % 3;
    r[i] = p[j] * q[k] - p[k] * q[j];
  }
}

/* Twice the area of a triangle as a vector. */
static void area_of(const double a[3], const double b[3], const double c[3], double area[3]) {
  double p[3];
  double q[3];
  for (int i = 0; i < 3; i++) {
    p[i] = b[i] - a[i];
    q[i] = c[i] - a[i];
  }
  cross(p, q, area);
}

/* All triangles of this corner turn the same way as the polygon. */
static bool sees_all(const double (*corner)[3], size_t count, size_t from, const double whole[3]) {
  for (size_t n = 1; n + 1 < count; n++) {
    double area[3];
    area_of(corner[from], corner[(from + n) % count], corner[(from + n + 1) % count], area);
    if (!(area[0] * whole[0] + area[1] * whole[1] + area[2] * whole[2] >= 0)) {
      return false;
    }
  }
  return true;
}

bool format_polygon_divide(const double (*corner)[3], size_t count, size_t (*triangle)[3]) {
  enum { CORNERS_SEARCHED = 2000 };
  double whole[3] = {0, 0, 0};
  for (size_t n = 1; n + 1 < count; n++) {
    double area[3];
    area_of(corner[0], corner[n], corner[n + 1], area);
    for (int i = 0; i < 3; i++) {
      whole[i] += area[i];
    }
  }
  size_t tries = count > CORNERS_SEARCHED ? 1 : count;
  size_t from = 0;
  while (from < tries && count > 3 && !sees_all(corner, count, from, whole)) {
    from++;
  }
  for (size_t n = 1; n + 1 < count && from < tries; n++) {
    triangle[n - 1][0] = from;
    triangle[n - 1][1] = (from + n) % count;
    triangle[n - 1][2] = (from + n + 1) % count;
  }
  return from < tries;
}

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
  sepax_mesh *mesh = in->mesh;
  sepax_facet *grown = mesh->count < FORMAT_FACETS_MOST
                           ? list_grow(mesh->facet, &in->capacity, mesh->count, sizeof *grown)
                           : NULL;
  if (grown == NULL) {
    return sepax_fail(error, "%.300s: more than %d triangles, or no memory; simplify the mesh",
                      in->path, FORMAT_FACETS_MOST);
  }
  mesh->facet = grown;
  sepax_facet *facet = &mesh->facet[mesh->count];
  *facet = (sepax_facet){0};
  for (int k = 0; k < 3; k++) {
    memcpy(facet->v[k], in->corner[corner[k]], sizeof facet->v[k]);
    for (int i = 0; i < 3; i++) {
      if (!isfinite(facet->v[k][i])) {
        return sepax_fail(error,
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
  free(in->corner);
  free(in->triangle);
  in->corner = malloc(corners * sizeof *in->corner);
  in->triangle = malloc(corners * sizeof *in->triangle);
  in->corners = in->corner != NULL && in->triangle != NULL ? corners : 0;
  return in->corners != 0;
}

static bool add_face(importer *in, const struct aiMesh *from, const struct aiFace *face,
                     const change *to, sepax_error *error) {
  size_t count = face->mNumIndices;
  if (count < 3) {
    return sepax_fail(error, "%.300s: it has points or lines beside faces; leave them out",
                      in->path);
  }
  if (!make_space(in, count)) {
    return sepax_fail(error, "%.300s: no memory for a face of %zu corners", in->path, count);
  }
  for (size_t k = 0; k < count; k++) {
    if (face->mIndices[k] >= from->mNumVertices) {
      return sepax_fail(error, "%.300s: a face has a vertex that is not there; export it again",
                        in->path);
    }
    place(to, &from->mVertices[face->mIndices[k]], in->corner[k]);
  }
  if (!format_polygon_divide((const double(*)[3])in->corner, count, in->triangle)) {
    return sepax_fail(error,
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
  bool ok = depth < DEPTH_MOST ||
            sepax_fail(error, "%.300s: nodes %d deep; flatten the scene", in->path, depth);
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

static bool ends_in(const char *path, const char *ending) {
  size_t length = strlen(path);
  return length > strlen(ending) && strcasecmp(path + length - strlen(ending), ending) == 0;
}

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
    sepax_fail(error, "%.240s: %.180s; export it again", path, why);
    aiReleaseImport(scene);
    return NULL;
  }
  return scene;
}

static bool read_other(sepax_mesh *mesh, const char *path, sepax_error *error) {
  *mesh = (sepax_mesh){0};
  if ((ends_in(path, ".ply") && !ply_is_whole(path, error)) ||
      (ends_in(path, ".dae") && !xml_dae_right(path, error))) {
    return false;
  }
  const struct aiScene *scene = import(path, error);
  if (scene == NULL) {
    return false;
  }
  importer in = {.path = path, .scene = scene, .mesh = mesh};
  const change none = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  bool ok = add_node(&in, scene->mRootNode, &none, 0, error) &&
            (mesh->count > 0 || sepax_fail(error, "%.300s: no triangles in it; give a mesh", path));
  free(in.corner);
  free(in.triangle);
  aiReleaseImport(scene);
  return ok;
}

/* What the head of a binary STL announces, if it is as long as that; of another file 0. */
static size_t facets_announced(const char *path, size_t bytes) {
  enum { HEAD = 84, FACET = 50 };
  unsigned char head[HEAD];
  FILE *in = fopen(path, "rb");
  size_t count = 0;
  if (in != NULL && fread(head, 1, HEAD, in) == HEAD) {
    count = head[80] | (size_t)head[81] << 8 | (size_t)head[82] << 16 | (size_t)head[83] << 24;
  }
  if (in != NULL) {
    fclose(in);
  }
  return bytes == HEAD + FACET * count ? count : 0;
}

/* Bounded before anything is read. A text of this length has fewer facets. */
static bool read_stl(sepax_mesh *mesh, const char *path, sepax_error *error) {
  size_t bytes = 0;
  if (!confined_size(path, &bytes, error)) {
    return false;
  }
  size_t facets = facets_announced(path, bytes);
  return facets <= FORMAT_FACETS_MOST
             ? sepax_stl_read(mesh, path, error)
             : sepax_fail(error, "%.300s: %zu triangles, more than %d; simplify the mesh", path,
                          facets, FORMAT_FACETS_MOST);
}

bool format_mesh_is_stl(const char *path) {
  return ends_in(path, ".stl") || ends_in(path, ".stlb");
}

bool format_mesh_read(sepax_mesh *mesh, const char *path, sepax_error *error) {
  static const char *const others[] = {".obj", ".ply", ".3mf", ".dae"};
  *mesh = (sepax_mesh){0};
  if (format_mesh_is_stl(path)) {
    return read_stl(mesh, path, error);
  }
  for (int i = 0; i < 4; i++) {
    if (ends_in(path, others[i])) {
      return confined_read(mesh, path, read_other, error);
    }
  }
  return sepax_fail(error, "%.300s: no mesh that is read; give STL, OBJ, PLY, 3MF or DAE", path);
}
