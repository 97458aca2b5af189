/* pair_tools.c - seeds, and the properties of a pair in exact integers. */
#include "pair_tools.h"
#include "sepax_vectors.h"

typedef __int128 wide;

size_t family_count(void) {
  size_t count = 0;
  while (sepax_family_name(count) != NULL) {
    count++;
  }
  return count;
}

sepax_random seeded(size_t family, int word) {
  return (sepax_random){1000 * (uint64_t)family + (uint64_t)word};
}

/* ------------------------------------------------------------------- geometry */

typedef struct {
  wide c[3];
} vec;

static vec between(sepax_vec from, sepax_vec to) {
  return (vec){{(wide)to.x - from.x, (wide)to.y - from.y, (wide)to.z - from.z}};
}

static vec cross(vec p, vec q) {
  return (vec){{p.c[1] * q.c[2] - p.c[2] * q.c[1], p.c[2] * q.c[0] - p.c[0] * q.c[2],
                p.c[0] * q.c[1] - p.c[1] * q.c[0]}};
}

static wide dot(vec p, vec q) { return p.c[0] * q.c[0] + p.c[1] * q.c[1] + p.c[2] * q.c[2]; }

static bool is_zero(vec p) { return p.c[0] == 0 && p.c[1] == 0 && p.c[2] == 0; }

static wide gcd(wide p, wide q) {
  while (q != 0) {
    wide rest = p % q;
    p = q;
    q = rest;
  }
  return p < 0 ? -p : p;
}

static vec normal(const sepax_tri *t) {
  return cross(between(t->v[0], t->v[1]), between(t->v[0], t->v[2]));
}

/* The normal without its common factor, which is returned. */
static wide primitive(vec *n) {
  wide factor = gcd(gcd(n->c[0], n->c[1]), n->c[2]);
  for (int i = 0; i < 3 && factor != 0; i++) {
    n->c[i] /= factor;
  }
  return factor;
}

bool equal(sepax_vec p, sepax_vec q) { return p.x == q.x && p.y == q.y && p.z == q.z; }

sepax_vec vertex(const sepax_pair *pair, int i) { return i < 3 ? pair->a.v[i] : pair->b.v[i - 3]; }

static int sign(wide value) { return (value > 0) - (value < 0); }

/* On which side of the line p q is r, with one coordinate left out. */
static int side(sepax_vec p, sepax_vec q, sepax_vec r, int dropped) {
  return sign(cross(between(p, q), between(p, r)).c[dropped]);
}

/* An axis along which a vector is not zero. */
static int pivot(vec n) { return n.c[0] != 0 ? 0 : n.c[1] != 0 ? 1 : 2; }

static bool on_face(sepax_vec p, const sepax_tri *t) {
  vec n = normal(t);
  if (is_zero(n) || dot(n, between(t->v[0], p)) != 0) {
    return false;
  }
  int dropped = pivot(n);
  int ahead = 0;
  int behind = 0;
  for (int k = 0; k < 3; k++) {
    int s = side(t->v[k], t->v[(k + 1) % 3], p, dropped);
    ahead += s > 0;
    behind += s < 0;
  }
  return ahead == 0 || behind == 0;
}

static bool on_edge(sepax_vec p, sepax_vec from, sepax_vec to) {
  vec ahead = between(p, to);
  vec behind = between(p, from);
  return is_zero(cross(ahead, behind)) && dot(ahead, behind) <= 0;
}

/* Two edges that are not parallel have a common point. */
static bool edges_meet(const sepax_vec e[2], const sepax_vec f[2]) {
  vec n = cross(between(e[0], e[1]), between(f[0], f[1]));
  if (is_zero(n) || dot(n, between(e[0], f[0])) != 0) {
    return false;
  }
  int d = pivot(n);
  return side(e[0], e[1], f[0], d) * side(e[0], e[1], f[1], d) <= 0 &&
         side(f[0], f[1], e[0], d) * side(f[0], f[1], e[1], d) <= 0;
}

static wide extent(const sepax_tri *t) {
  wide most = 0;
  for (int k = 0; k < 3; k++) {
    vec edge = between(t->v[k], t->v[(k + 1) % 3]);
    for (int i = 0; i < 3; i++) {
      wide length = edge.c[i] < 0 ? -edge.c[i] : edge.c[i];
      most = length > most ? length : most;
    }
  }
  return most;
}

/* ----------------------------------------------------------- what a pair may be */

bool legal(const sepax_pair *pair, int word) {
  return sepax_pair_fits(pair, word) && equal(pair->na, sepax_unit_normal(&pair->a, word)) &&
         equal(pair->nb, sepax_unit_normal(&pair->b, word));
}

bool collides(const sepax_pair *pair, int word) {
  (void)word;
  return sepax_reference(&pair->a, &pair->b);
}

typedef struct {
  vec v[6];
} six;

static vec minus(vec p, vec q) {
  return (vec){{p.c[0] - q.c[0], p.c[1] - q.c[1], p.c[2] - q.c[2]}};
}

static six vertices(const sepax_pair *pair) {
  static const sepax_vec origin = {0, 0, 0};
  six s;
  for (int i = 0; i < 6; i++) {
    s.v[i] = between(origin, vertex(pair, i));
  }
  return s;
}

/* All 15 tetrahedra have no volume. */
static bool flat(const six *s) {
  for (int i = 0; i < 6; i++) {
    for (int j = i + 1; j < 6; j++) {
      for (int k = j + 1; k < 6; k++) {
        vec n = cross(minus(s->v[j], s->v[i]), minus(s->v[k], s->v[i]));
        for (int l = k + 1; l < 6; l++) {
          if (dot(n, minus(s->v[l], s->v[i])) != 0) {
            return false;
          }
        }
      }
    }
  }
  return true;
}

bool coplanar(const sepax_pair *pair, int word) {
  (void)word;
  six s = vertices(pair);
  return flat(&s);
}

/* A move of one coordinate by 1 LSB, maybe out of the range, makes the pair flat. */
bool almost_coplanar(const sepax_pair *pair, int word) {
  (void)word;
  six s = vertices(pair);
  for (int i = 0; i < 18; i++) {
    wide *c = &s.v[i / 3].c[i % 3];
    wide kept = *c;
    *c = kept + 1;
    bool found = flat(&s);
    *c = kept - 1;
    found = found || flat(&s);
    *c = kept;
    if (found) {
      return true;
    }
  }
  return false;
}

static bool has_area(const sepax_tri *t) { return !is_zero(normal(t)); }

bool both_have_area(const sepax_pair *pair, int word) {
  (void)word;
  return has_area(&pair->a) && has_area(&pair->b);
}

bool normals_parallel(const sepax_pair *pair, int word) {
  (void)word;
  vec a = normal(&pair->a);
  vec b = normal(&pair->b);
  return primitive(&a) != 0 && primitive(&b) != 0 && is_zero(cross(a, b));
}

bool same_orientation(const sepax_pair *pair, int word) {
  (void)word;
  vec a = normal(&pair->a);
  vec b = normal(&pair->b);
  return sign(a.c[pivot(a)]) == sign(b.c[pivot(a)]);
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

bool one_common(const sepax_pair *pair, int word) {
  (void)word;
  return common_vertices(pair) >= 1;
}

bool two_common(const sepax_pair *pair, int word) {
  (void)word;
  return common_vertices(pair) >= 2;
}

bool three_common(const sepax_pair *pair, int word) {
  (void)word;
  return common_vertices(pair) == 3;
}

bool same_order(const sepax_pair *pair, int word) {
  (void)word;
  return equal(pair->a.v[0], pair->b.v[0]) && equal(pair->a.v[1], pair->b.v[1]);
}

bool vertex_on_face(const sepax_pair *pair, int word) {
  (void)word;
  for (int i = 0; i < 6; i++) {
    if (on_face(vertex(pair, i), i < 3 ? &pair->b : &pair->a)) {
      return true;
    }
  }
  return false;
}

bool vertex_on_edge(const sepax_pair *pair, int word) {
  (void)word;
  for (int i = 0; i < 6; i++) {
    const sepax_tri *other = i < 3 ? &pair->b : &pair->a;
    for (int k = 0; k < 3; k++) {
      if (on_edge(vertex(pair, i), other->v[k], other->v[(k + 1) % 3])) {
        return true;
      }
    }
  }
  return false;
}

bool edge_on_edge(const sepax_pair *pair, int word) {
  (void)word;
  for (int i = 0; i < 3; i++) {
    const sepax_vec e[2] = {pair->a.v[i], pair->a.v[(i + 1) % 3]};
    for (int k = 0; k < 3; k++) {
      const sepax_vec f[2] = {pair->b.v[k], pair->b.v[(k + 1) % 3]};
      if (edges_meet(e, f)) {
        return true;
      }
    }
  }
  return false;
}

static double square(vec p) {
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
    double length = square(between(t->v[k], t->v[(k + 1) % 3]));
    longest = length > longest ? length : longest;
  }
  return square(normal(t)) < 2.8 * longest && extent(t) >= sepax_word_max(word) / 6;
}

bool has_sliver(const sepax_pair *pair, int word) {
  return is_sliver(&pair->a, word) || is_sliver(&pair->b, word);
}

static bool is_tiny(const sepax_tri *t, int word) {
  return extent(t) <= (word > 6 ? (wide)1 << (word - 5) : 2);
}

bool has_tiny(const sepax_pair *pair, int word) {
  return is_tiny(&pair->a, word) || is_tiny(&pair->b, word);
}

bool a_is_tiny(const sepax_pair *pair, int word) { return is_tiny(&pair->a, word); }

bool a_has_area(const sepax_pair *pair, int word) {
  (void)word;
  return has_area(&pair->a);
}

bool is_point(const sepax_pair *pair, int word) {
  (void)word;
  return extent(&pair->a) == 0 || extent(&pair->b) == 0;
}

bool small(const sepax_pair *pair, int word) {
  wide most = sepax_word_max(word);
  return extent(&pair->a) <= most && extent(&pair->b) <= most;
}

static void aabb_along(const sepax_tri *t, int axis, int64_t box[2]) {
  box[0] = INT64_MAX;
  box[1] = INT64_MIN;
  for (int k = 0; k < 3; k++) {
    int64_t c[3] = {t->v[k].x, t->v[k].y, t->v[k].z};
    box[0] = c[axis] < box[0] ? c[axis] : box[0];
    box[1] = c[axis] > box[1] ? c[axis] : box[1];
  }
}

bool aabbs_overlap(const sepax_pair *pair, int word) {
  (void)word;
  for (int axis = 0; axis < 3; axis++) {
    int64_t a[2];
    int64_t b[2];
    aabb_along(&pair->a, axis, a);
    aabb_along(&pair->b, axis, b);
    if (a[1] < b[0] || b[1] < a[0]) {
      return false;
    }
  }
  return true;
}

static bool coordinate_at(const sepax_pair *pair, int64_t value) {
  for (int i = 0; i < 6; i++) {
    sepax_vec v = vertex(pair, i);
    if (v.x == value || v.y == value || v.z == value) {
      return true;
    }
  }
  return false;
}

bool at_least_value(const sepax_pair *pair, int word) {
  return coordinate_at(pair, sepax_word_min(word));
}

bool at_greatest_value(const sepax_pair *pair, int word) {
  return coordinate_at(pair, sepax_word_max(word));
}

bool at_corners(const sepax_pair *pair, int word) {
  int64_t most = sepax_word_max(word);
  for (int i = 0; i < 6; i++) {
    sepax_vec v = vertex(pair, i);
    const int64_t c[3] = {v.x, v.y, v.z};
    for (int axis = 0; axis < 3; axis++) {
      int64_t size = c[axis] < 0 ? -c[axis] : c[axis];
      if (size > 1 && size < most - 1) {
        return false;
      }
    }
  }
  return true;
}

bool on_grid(const sepax_pair *pair, int word) {
  (void)word;
  for (int i = 0; i < 6; i++) {
    sepax_vec v = vertex(pair, i);
    if (v.x < -1 || v.x > 1 || v.y < -1 || v.y > 1 || v.z < -1 || v.z > 1) {
      return false;
    }
  }
  return true;
}

/* A.N_A = B.N_B, exactly: equal levels and squares of the primitive normals. */
bool tangent(const sepax_pair *pair, int word) {
  (void)word;
  static const sepax_vec origin = {0, 0, 0};
  vec a = normal(&pair->a);
  vec b = normal(&pair->b);
  bool areas = primitive(&a) != 0 && primitive(&b) != 0;
  return areas && dot(a, a) == dot(b, b) &&
         dot(a, between(origin, pair->a.v[0])) == dot(b, between(origin, pair->b.v[0]));
}
