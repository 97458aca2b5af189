/* SPDX-License-Identifier: MIT */
/* pair_tools.c - seeds, and the properties of a pair in exact integers. */
#include "pair_tools.h"
#include "geometry.h"

#include <string.h>

size_t family_count(void) {
  size_t count = 1;
  while (sepax_family_name(count) != NULL) {
    count++;
  }
  return count;
}

size_t family_number(const char *name) {
  size_t family = 0;
  while (sepax_family_name(family) != NULL && strcmp(sepax_family_name(family), name) != 0) {
    family++;
  }
  return family;
}

sepax_random seeded(size_t family, int word) {
  return (sepax_random){1000 * (uint64_t)family + (uint64_t)word};
}

int32_t *field(sepax_pair *pair, int i) {
  sepax_vec *v = i < 9 ? &pair->a.v[i / 3] : i < 18 ? &pair->b.v[i / 3 - 3] : &pair->na;
  return coordinate(i < 21 ? v : &pair->nb, i % 3);
}

int32_t field_of(const sepax_pair *pair, int i) {
  sepax_pair copy = *pair;
  return *field(&copy, i);
}

/* ------------------------------------------------------------------- geometry */

static bool is_zero(wide_vec p) { return p.c[0] == 0 && p.c[1] == 0 && p.c[2] == 0; }

static wide gcd(wide p, wide q) {
  while (q != 0) {
    wide rest = p % q;
    p = q;
    q = rest;
  }
  return p < 0 ? -p : p;
}

static wide_vec normal(const sepax_tri *t) { return cross(edge(t, 0), edge(t, 1)); }

/* The normal without its common factor; false if it is zero. */
static bool primitive(wide_vec *n, const sepax_tri *t) {
  *n = normal(t);
  wide factor = gcd(gcd(n->c[0], n->c[1]), n->c[2]);
  for (int i = 0; i < 3 && factor != 0; i++) {
    n->c[i] /= factor;
  }
  return factor != 0;
}

bool equal(sepax_vec p, sepax_vec q) { return p.x == q.x && p.y == q.y && p.z == q.z; }

/* Vertex 0 ... 5: three of A, three of B. */
static sepax_vec vertex(const sepax_pair *pair, int i) {
  return i < 3 ? pair->a.v[i] : pair->b.v[i - 3];
}

static int sign(wide value) { return (value > 0) - (value < 0); }

/* On which side of the line p q is r, with one coordinate left out. */
static int side(sepax_vec p, sepax_vec q, sepax_vec r, int dropped) {
  return sign(cross(between(p, q), between(p, r)).c[dropped]);
}

/* An axis along which a vector is not zero. */
static int pivot(wide_vec n) { return n.c[0] != 0 ? 0 : n.c[1] != 0 ? 1 : 2; }

static bool on_face(sepax_vec p, const sepax_tri *t) {
  wide_vec n = normal(t);
  if (is_zero(n) || dot(n, between(t->v[0], p)) != 0) {
    return false;
  }
  int ahead = 0;
  int behind = 0;
  for (int k = 0; k < 3; k++) {
    int s = side(t->v[k], t->v[(k + 1) % 3], p, pivot(n));
    ahead += s > 0;
    behind += s < 0;
  }
  return ahead == 0 || behind == 0;
}

static bool on_edge(sepax_vec p, sepax_vec from, sepax_vec to) {
  wide_vec ahead = between(p, to);
  wide_vec behind = between(p, from);
  return is_zero(cross(ahead, behind)) && dot(ahead, behind) <= 0;
}

/* Two edges that are not parallel have a common point. */
static bool edges_meet(const sepax_tri *a, int i, const sepax_tri *b, int j) {
  const sepax_vec e[2] = {a->v[i], a->v[(i + 1) % 3]};
  const sepax_vec f[2] = {b->v[j], b->v[(j + 1) % 3]};
  wide_vec n = cross(edge(a, i), edge(b, j));
  if (is_zero(n) || dot(n, between(e[0], f[0])) != 0) {
    return false;
  }
  int d = pivot(n);
  return side(e[0], e[1], f[0], d) * side(e[0], e[1], f[1], d) <= 0 &&
         side(f[0], f[1], e[0], d) * side(f[0], f[1], e[1], d) <= 0;
}

int64_t longest_side(const sepax_tri *t) {
  int64_t most = 0;
  for (int i = 0; i < 9; i++) {
    int64_t length = (int64_t)edge(t, i / 3).c[i % 3];
    length = length < 0 ? -length : length;
    most = length > most ? length : most;
  }
  return most;
}

/* ----------------------------------------------------------- what a pair may be */

#define PROPERTY(name) bool name(const sepax_pair *pair, __attribute__((unused)) int word)

PROPERTY(legal) {
  return sepax_pair_fits(pair, word) && equal(pair->na, sepax_unit_normal(&pair->a, word)) &&
         equal(pair->nb, sepax_unit_normal(&pair->b, word));
}

PROPERTY(collides) { return sepax_reference(&pair->a, &pair->b); }

typedef struct {
  wide_vec v[6];
} six;

static six vertices(const sepax_pair *pair) {
  six s;
  for (int i = 0; i < 6; i++) {
    s.v[i] = wide_of(vertex(pair, i));
  }
  return s;
}

/* All 15 tetrahedra have no volume. */
static bool flat(const six *s) {
  for (int i = 0; i < 6; i++) {
    for (int j = i + 1; j < 6; j++) {
      for (int k = j + 1; k < 6; k++) {
        wide_vec n = cross(wide_minus(s->v[j], s->v[i]), wide_minus(s->v[k], s->v[i]));
        for (int l = k + 1; l < 6; l++) {
          if (dot(n, wide_minus(s->v[l], s->v[i])) != 0) {
            return false;
          }
        }
      }
    }
  }
  return true;
}

PROPERTY(coplanar) {
  six s = vertices(pair);
  return flat(&s);
}

/* A move of one coordinate by 1 LSB, maybe out of the range, makes the pair flat. */
PROPERTY(almost_coplanar) {
  six s = vertices(pair);
  bool found = false;
  for (int i = 0; i < COORDINATES && !found; i++) {
    wide *c = &s.v[i / 3].c[i % 3];
    *c += 1;
    found = flat(&s);
    *c -= 2;
    found = found || flat(&s);
    *c += 1;
  }
  return found;
}

PROPERTY(a_has_area) { return !is_zero(normal(&pair->a)); }

PROPERTY(both_have_area) { return a_has_area(pair, word) && !is_zero(normal(&pair->b)); }

PROPERTY(normals_parallel) {
  wide_vec a;
  wide_vec b;
  return primitive(&a, &pair->a) && primitive(&b, &pair->b) && is_zero(cross(a, b));
}

PROPERTY(same_orientation) {
  wide_vec a = normal(&pair->a);
  return sign(a.c[pivot(a)]) == sign(normal(&pair->b).c[pivot(a)]);
}

static int common_vertices(const sepax_pair *pair) {
  int count = 0;
  for (int i = 0; i < 3; i++) {
    sepax_vec p = pair->a.v[i];
    const sepax_vec *b = pair->b.v;
    count += equal(p, b[0]) || equal(p, b[1]) || equal(p, b[2]);
  }
  return count;
}

PROPERTY(one_common) { return common_vertices(pair) >= 1; }

PROPERTY(two_common) { return common_vertices(pair) >= 2; }

PROPERTY(three_common) { return common_vertices(pair) == 3; }

PROPERTY(same_order) {
  return equal(pair->a.v[0], pair->b.v[0]) && equal(pair->a.v[1], pair->b.v[1]);
}

PROPERTY(vertex_on_face) {
  bool found = false;
  for (int i = 0; i < 6; i++) {
    found = found || on_face(vertex(pair, i), i < 3 ? &pair->b : &pair->a);
  }
  return found;
}

PROPERTY(vertex_on_edge) {
  bool found = false;
  for (int i = 0; i < 18; i++) {
    const sepax_vec *other = i < 9 ? pair->b.v : pair->a.v;
    found = found || on_edge(vertex(pair, i / 3), other[i % 3], other[(i + 1) % 3]);
  }
  return found;
}

PROPERTY(edge_on_edge) {
  bool found = false;
  for (int i = 0; i < 9; i++) {
    found = found || edges_meet(&pair->a, i / 3, &pair->b, i % 3);
  }
  return found;
}

static double square(wide_vec p) {
  double total = 0;
  for (int i = 0; i < 3; i++) {
    total += (double)p.c[i] * (double)p.c[i];
  }
  return total;
}

/* Long, and no higher than 1.5 LSB in one direction and 0.5 in the others. */
static bool is_sliver(const sepax_tri *t, int word) {
  double longest = 0;
  for (int k = 0; k < 3; k++) {
    double length = square(edge(t, k));
    longest = length > longest ? length : longest;
  }
  return square(normal(t)) < 2.8 * longest && longest_side(t) >= sepax_word_max(word) / 6;
}

PROPERTY(has_sliver) { return is_sliver(&pair->a, word) || is_sliver(&pair->b, word); }

static bool is_tiny(const sepax_tri *t, int word) {
  return longest_side(t) <= (word > 6 ? INT64_C(1) << (word - 5) : 2);
}

PROPERTY(has_tiny) { return is_tiny(&pair->a, word) || is_tiny(&pair->b, word); }

PROPERTY(a_is_tiny) { return is_tiny(&pair->a, word); }

PROPERTY(is_point) { return longest_side(&pair->a) == 0 || longest_side(&pair->b) == 0; }

PROPERTY(small) {
  int64_t most = sepax_word_max(word);
  return longest_side(&pair->a) <= most && longest_side(&pair->b) <= most;
}

PROPERTY(aabbs_overlap) {
  static const wide_vec unit[3] = {{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}};
  bool separated = false;
  for (int axis = 0; axis < 3; axis++) {
    separated = separated || separates(unit[axis], &pair->a, &pair->b);
  }
  return !separated;
}

static bool coordinate_at(const sepax_pair *pair, int32_t value) {
  bool found = false;
  for (int i = 0; i < COORDINATES; i++) {
    found = found || field_of(pair, i) == value;
  }
  return found;
}

PROPERTY(at_least_value) { return coordinate_at(pair, sepax_word_min(word)); }

PROPERTY(at_greatest_value) { return coordinate_at(pair, sepax_word_max(word)); }

/* Every coordinate is in -1 ... 1, or its size in big ... . */
static bool at_places(const sepax_pair *pair, int64_t big) {
  bool all = true;
  for (int i = 0; i < COORDINATES; i++) {
    int64_t c = field_of(pair, i);
    int64_t size = c < 0 ? -c : c;
    all = all && (size <= 1 || size >= big);
  }
  return all;
}

PROPERTY(at_corners) { return at_places(pair, (int64_t)sepax_word_max(word) - 1); }

PROPERTY(on_grid) { return at_places(pair, INT64_MAX); }

/* A.N_A = B.N_B, exactly: equal levels and squares of the primitive normals. */
PROPERTY(tangent) {
  wide_vec a;
  wide_vec b;
  bool areas = primitive(&a, &pair->a) && primitive(&b, &pair->b);
  return areas && dot(a, a) == dot(b, b) &&
         dot(a, wide_of(pair->a.v[0])) == dot(b, wide_of(pair->b.v[0]));
}
