/* SPDX-License-Identifier: MIT */
/* dae_scene.c - the geometries of a COLLADA document where its scene places them. */
#include "body/orient.h"
#include "util/text.h"
#include "xml/dae.h"

#include <math.h>
#include <string.h>

/* Limits: levels of nodes, including those that nodes refer to, and children visited to place all
 * geometries. */
enum { HEIGHT_MOST = 300, VISITS_MOST = 4000000 };

/* The matrix m of p' = m p for a column (x y z 1). */
typedef struct {
  double m[3][4];
  bool identity, mirrors;
} dae_matrix;

static const dae_matrix identity = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}, true, false};

/* ---------------------------------------------------------------------------- matrices */

static dae_matrix multiply(const dae_matrix *outer, const dae_matrix *inner) {
  if (outer->identity) {
    return *inner;
  }
  if (inner->identity) {
    return *outer;
  }
  dae_matrix product = {.mirrors = outer->mirrors != inner->mirrors};
  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 4; k++) {
      product.m[i][k] = outer->m[i][0] * inner->m[0][k] + outer->m[i][1] * inner->m[1][k] +
                        outer->m[i][2] * inner->m[2][k] + (k == 3 ? outer->m[i][3] : 0);
    }
  }
  return product;
}

/* Above 0 if the matrix keeps left and right, below 0 if it mirrors, 0 if it makes meshes flat. */
static int orientation(const dae_matrix *at) {
  static const double origin[3] = {0, 0, 0};
  return sepax__orient3d(origin, at->m[0], at->m[1], at->m[2]);
}

static bool read_matrix(const dae *d, const xmlNode *node, dae_matrix *at) {
  double value[16];
  if (!sepax__dae_reals(d, node, value, 16)) {
    return false;
  }
  if (value[12] != 0 || value[13] != 0 || value[14] != 0 || value[15] != 1) {
    return sepax__dae_fail(d, node, "<%s>: its last row is not 0 0 0 1; export it again",
                           (const char *)node->name);
  }
  memcpy(at->m, value, sizeof at->m);
  return true;
}

/* Cosine and sine, exact if the angle is a multiple of 90 degrees. */
static void turn(double degrees, double *cosine, double *sine) {
  static const double exact[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  static const double pi = 3.14159265358979323846;
  double angle = fmod(degrees, 360);
  double quarters = angle / 90;
  if (quarters == floor(quarters)) {
    const double *known = exact[((int)quarters + 4) % 4];
    *cosine = known[0];
    *sine = known[1];
  } else {
    *cosine = cos(angle * pi / 180);
    *sine = sin(angle * pi / 180);
  }
}

static bool read_rotate(const dae *d, const xmlNode *node, dae_matrix *at) {
  double value[4];
  if (!sepax__dae_reals(d, node, value, 4)) {
    return false;
  }
  double length = hypot(hypot(value[0], value[1]), value[2]);
  if (length == 0 && value[3] == 0) { /* as exporters of 3ds Max write a ScaleAxisR */
    return true;
  }
  double cosine;
  double sine;
  turn(value[3], &cosine, &sine);
  if (!(length > 0) || isinf(length) || !isfinite(cosine)) {
    return sepax__dae_fail(d, node, "<rotate>: give an axis that is not zero, and an angle");
  }
  double a[3] = {value[0] / length, value[1] / length, value[2] / length};
  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 3; k++) {
      at->m[i][k] = a[i] * a[k] * (1 - cosine) + (i == k ? cosine : 0);
    }
  }
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3;
    int k = (i + 2) % 3;
    at->m[j][i] += a[k] * sine;
    at->m[i][j] -= a[k] * sine;
  }
  return true;
}

static bool read_three(const dae *d, const xmlNode *node, dae_matrix *at, bool scale) {
  double value[3];
  if (!sepax__dae_reals(d, node, value, 3)) {
    return false;
  }
  for (int i = 0; i < 3; i++) {
    if (scale) {
      at->m[i][i] = value[i];
    } else {
      at->m[i][3] = value[i];
    }
  }
  return true;
}

/* Digits of coordinates are lost where products of matrices are very small or large, and all of
 * them where they underflow. */
static bool is_placing(const dae_matrix *at) {
  bool placing = true;
  for (int i = 0; i < 3 && !at->identity; i++) {
    double most = fmax(fabs(at->m[i][0]), fmax(fabs(at->m[i][1]), fabs(at->m[i][2])));
    placing = placing && most >= 0x1p-400 && most <= 0x1p400;
  }
  return placing && (at->identity || orientation(at) != 0);
}

static bool fail_product(const dae *d, const xmlNode *node) {
  return sepax__dae_fail(
      d, node,
      "<%s>: combined with the transformations above it, it makes a mesh flat, or too small or "
      "too large for a double; export it again",
      (const char *)node->name);
}

static bool is_transformation(const xmlNode *node) {
  static const char *const names[] = {"lookat", "matrix", "rotate", "scale", "skew", "translate"};
  bool is = false;
  for (size_t n = 0; n < sizeof names / sizeof names[0]; n++) {
    is = is || sepax__xml_is(node, names[n]);
  }
  return is;
}

/* A child of a node: if it is a transformation, into *at behind what stands there. */
static bool read_transformation(const dae *d, const xmlNode *node, dae_matrix *at) {
  const char *name = (const char *)node->name;
  dae_matrix own = identity;
  bool ok = true;
  if (strcmp(name, "lookat") == 0 || strcmp(name, "skew") == 0) {
    return sepax__dae_fail(d, node, "<%s> is not read; export it as a <matrix>", name);
  }
  if (strcmp(name, "matrix") == 0 || strcmp(name, "bind_shape_matrix") == 0) {
    ok = read_matrix(d, node, &own);
  } else if (strcmp(name, "rotate") == 0) {
    ok = read_rotate(d, node, &own);
  } else if (strcmp(name, "translate") == 0 || strcmp(name, "scale") == 0) {
    ok = read_three(d, node, &own, name[0] == 's');
  } else {
    return true;
  }
  if (!ok) {
    return false;
  }
  own.identity = memcmp(own.m, identity.m, sizeof own.m) == 0;
  for (int i = 0; i < 12; i++) {
    if (!isfinite(own.m[i / 4][i % 4])) {
      return sepax__dae_fail(d, node, "<%s>: give finite numbers", name);
    }
  }
  int sign = orientation(&own);
  own.mirrors = sign < 0;
  if (sign == 0) {
    return sepax__dae_fail(
        d, node, "<%s> makes every mesh that it places flat; give one that does not", name);
  }
  *at = multiply(at, &own);
  return is_placing(at) || fail_product(d, node);
}

/* -------------------------------------------------------------------------- references */

static dae_geometry *geometry_of(const dae *d, const xmlNode *node) {
  return node != NULL ? &d->geometry[(size_t)node->_private - 1] : NULL;
}

/* What an <instance_controller> places: a skin in the shape in which it was bound. */
static dae_geometry *find_skinned(const dae *d, const xmlNode *instance, dae_matrix *at) {
  const xmlNode *controller = sepax__dae_refer(d, instance, "url", "controller");
  const xmlNode *skin = sepax__xml_child(controller, "skin");
  if (controller == NULL) {
    return NULL;
  }
  if (skin == NULL || sepax__xml_child(controller, "morph") != NULL) {
    sepax__dae_fail(d, controller,
                    "<controller> that is no skin (a <morph>) is not read; export "
                    "the mesh that it makes");
    return NULL;
  }
  const xmlNode *bind = sepax__xml_child(skin, "bind_shape_matrix");
  if (bind != NULL && !read_transformation(d, bind, at)) {
    return NULL;
  }
  return geometry_of(d, sepax__dae_refer(d, skin, "source", "geometry"));
}

/* The geometry that a child of a node places, if it places one; false: failed. */
static bool find_placed(const dae *d, const xmlNode *child, dae_geometry **g, dae_matrix *at) {
  *g = NULL;
  if (sepax__xml_is(child, "instance_geometry")) {
    *g = geometry_of(d, sepax__dae_refer(d, child, "url", "geometry"));
    return *g != NULL;
  }
  if (sepax__xml_is(child, "instance_controller")) {
    *g = find_skinned(d, child, at);
    return *g != NULL;
  }
  return true;
}

/* The node that a child of a node is or refers to, if it does; false: failed. */
static bool find_node(const dae *d, xmlNode *child, xmlNode **node) {
  *node = sepax__xml_is(child, "node") ? child : NULL;
  if (sepax__xml_is(child, "instance_node")) {
    *node = sepax__dae_refer(d, child, "url", "node");
    return *node != NULL;
  }
  return true;
}

/* ------------------------------------------------------------------------------- nodes */

static dae_node *state_of(const dae *d, const xmlNode *node) {
  return &d->node[(size_t)node->_private - 1];
}

static size_t add(size_t a, size_t b) { return a > SIZE_MAX - b ? SIZE_MAX : a + b; }

static bool fail_deep(const dae *d, const xmlNode *node) {
  return sepax__dae_fail(d, node, "nodes are nested deeper than %d; flatten them",
                         (int)HEIGHT_MOST);
}

/* Count the triangles that one use of a node makes. Each node is counted only once, so a document
 * whose nodes double at each level takes no longer than its length. */
static bool weigh(dae *d, xmlNode *node, size_t depth) {
  dae_node *state = state_of(d, node);
  if (state->done) {
    return true;
  }
  if (state->entered) {
    return sepax__dae_fail(d, node, "<node> that contains itself; export it again");
  }
  state->entered = true;
  dae_matrix at = identity;
  bool places = false;
  for (xmlNode *child = sepax__xml_child(node, NULL); child != NULL;
       child = sepax__xml_next(child, NULL)) {
    xmlNode *inner = NULL;
    dae_geometry *g = NULL;
    dae_matrix bound = identity;
    if (places && is_transformation(child)) {
      return sepax__dae_fail(
          d, child,
          "<%s> after an element that the node places; transformations must come first; export it "
          "again",
          (const char *)child->name);
    }
    if (!read_transformation(d, child, &at) || !find_placed(d, child, &g, &bound) ||
        !find_node(d, child, &inner) ||
        (inner != NULL && depth == HEIGHT_MOST && !fail_deep(d, inner)) ||
        (inner != NULL && !weigh(d, inner, depth + 1))) {
      return false;
    }
    places = places || g != NULL || inner != NULL;
    state->weight = add(state->weight, g != NULL ? g->count : 0);
    state->visits = add(state->visits, 1);
    if (inner != NULL) {
      const dae_node *below = state_of(d, inner);
      state->weight = add(state->weight, below->weight);
      state->visits = add(state->visits, below->weight > 0 ? below->visits : 0);
      state->height = below->height >= state->height ? below->height + 1 : state->height;
    }
  }
  state->done = true;
  return state->height <= HEIGHT_MOST || fail_deep(d, node);
}

static bool place_geometry(const dae *d, const dae_geometry *g, const dae_matrix *at) {
  for (size_t n = 0; n < g->count; n++) {
    double v[3][3];
    for (int c = 0; c < 3; c++) {
      const double *from = g->facet[n].v[c];
      double *to =
          v[at->mirrors && c > 0 ? 3 - c : c]; /* a mirrored triangle keeps its outer side */
      for (int i = 0; i < 3; i++) {
        const double *row = at->m[i];
        to[i] = at->identity ? from[i]
                             : row[0] * from[0] + row[1] * from[1] + row[2] * from[2] + row[3];
      }
    }
    if (!sepax__builder_triangle(d->b, (const double(*)[3])v)) {
      return false;
    }
  }
  return true;
}

static bool place(const dae *d, xmlNode *node, const dae_matrix *outer) {
  dae_matrix at = *outer;
  if (state_of(d, node)->weight == 0) {
    return true;
  }
  for (xmlNode *child = sepax__xml_child(node, NULL); child != NULL;
       child = sepax__xml_next(child, NULL)) {
    xmlNode *inner = NULL;
    dae_geometry *g = NULL;
    dae_matrix bound = identity;
    if (!read_transformation(d, child, &at) || !find_placed(d, child, &g, &bound) ||
        !find_node(d, child, &inner)) {
      return false;
    }
    bound = multiply(&at, &bound);
    if ((g != NULL || inner != NULL) && !is_placing(&bound)) {
      return fail_product(d, child);
    }
    if ((g != NULL && !place_geometry(d, g, &bound)) || (inner != NULL && !place(d, inner, &at))) {
      return false;
    }
  }
  return true;
}

/* Marks the geometries that the node places, and names skins. Each node is entered once; `entered`
 * is set of those that are to be. */
static bool mark(const dae *d, xmlNode *node) {
  dae_node *state = state_of(d, node);
  if (!state->entered) {
    return true;
  }
  state->entered = false;
  for (xmlNode *child = sepax__xml_child(node, NULL); child != NULL;
       child = sepax__xml_next(child, NULL)) {
    xmlNode *inner = NULL;
    dae_geometry *g = NULL;
    dae_matrix bound = identity;
    if (!find_placed(d, child, &g, &bound) || !find_node(d, child, &inner)) {
      return false;
    }
    if (g != NULL) {
      g->placed = true;
    }
    if ((sepax__xml_is(child, "instance_controller") &&
         !sepax__builder_other(d->b, "skins, read as they were bound", 1)) ||
        (inner != NULL && !mark(d, inner))) {
      return false;
    }
  }
  return true;
}

/* The <visual_scene> of the <scene>. Without it nothing says which of the nodes are there. */
static xmlNode *find_scene(const dae *d) {
  xmlNode *scene = NULL;
  xmlNode *instance = NULL;
  if (!sepax__xml_single(&d->file, d->file.root, "scene", &scene, d->b->error) ||
      (scene != NULL &&
       !sepax__xml_single(&d->file, scene, "instance_visual_scene", &instance, d->b->error))) {
    return NULL;
  }
  if (instance == NULL) {
    sepax__dae_fail(d, scene != NULL ? scene : d->file.root,
                    "it has no <scene> with an <instance_visual_scene>, which places the meshes; "
                    "export one");
    return NULL;
  }
  return sepax__dae_refer(d, instance, "url", "visual_scene");
}

static bool weigh_all(dae *d) {
  for (size_t n = 0; n < d->ids; n++) {
    bool is_node = strcmp(d->id[n].name, "node") == 0 || strcmp(d->id[n].name, "visual_scene") == 0;
    if (is_node && !weigh(d, d->id[n].node, 0)) {
      return false;
    }
  }
  return true;
}

bool sepax__dae_place(dae *d) {
  xmlNode *scene = find_scene(d);
  if (scene == NULL || !weigh_all(d) || !mark(d, scene)) {
    return false;
  }
  const dae_node *all = state_of(d, scene);
  bool places = false;
  for (size_t n = 0; n < d->geometries; n++) {
    places = places || d->geometry[n].placed;
  }
  if (all->weight == 0 && places) {
    return sepax__dae_fail(d, scene, "the meshes that the scene places have no faces; export some");
  }
  if (all->weight == 0 && d->geometries > 0) {
    return sepax__dae_fail(d, scene,
                           "the scene places no mesh (what physics places is not read); "
                           "export one that does");
  }
  if (all->visits > VISITS_MOST) {
    return sepax_fail(d->b->error, SEPAX_ERROR_LIMIT,
                      "%.240s: its nodes are placed more than %d times; simplify it", d->b->path,
                      (int)VISITS_MOST);
  }
  if (all->weight > d->b->how.most) {
    return sepax_fail(d->b->error, SEPAX_ERROR_LIMIT,
                      "%.240s: its scene makes more than %zu triangles; simplify the mesh",
                      d->b->path, d->b->how.most);
  }
  return place(d, scene, &identity);
}
